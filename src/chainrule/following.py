"""Following a path with constant joint-rate ratios, and a feedback update wherever the tip has drifted too far.

The joints move at constant rates along the path's tangent. When the tip's distance from the path reaches the tolerance
it is measured and brought back onto the path at the nearest point, and the next stretch begins: motions that stay close
for longer need fewer updates. How a stretch moves and ends is told in :mod:`chainrule.stretches`.

Methods, all for planar arms with three joints:

- ``pseudoinverse``: x = J^+ T, the smallest rates.
- ``speed_ratio``: the rule of Ambike, Schmiedeler and Stanisic. The curvature is met, or approached as closely as
  possible; of the two solutions the one whose dk/ds is nearer the desired one.
- ``two_term``: of all rates along the tangent, those whose predicted offset, the terms in s^2 and s^3 with their signs,
  stays within the tolerance longest.
- ``look_ahead``: the rates of the other methods and a few like them are tried (forward kinematics costs little), and
  those that get farthest are taken. From the same posture this is never worse than any of the others; over a whole path
  the postures differ from the second stretch on, and there is no such guarantee.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar, planar_model
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluators
from chainrule.inputs import real_array, whole_number
from chainrule.paths import Path, real_number, unit
from chainrule.search import samples
from chainrule.stretches import (
    END,
    ENDS,
    LIMIT,
    METHODS,
    STUCK,
    Arcs,
    Chains,
    Method,
    Placed,
    Stretches,
    Tracks,
    choose,
    picked,
    stand,
    stretch,
)

Array = NDArray[Any]
Status = Literal["finished", "singular", "joint limit", "unreachable", "too many updates"]
FINISHED, SINGULAR, AT_LIMIT, UNREACHABLE, UNFINISHED = range(5)
STATUSES: tuple[Status, ...] = ("finished", "singular", "joint limit", "unreachable", "too many updates")

#: Stretches shorter than this share of the tolerance count as no progress.
PROGRESS = 1e-6
#: The tolerance may not exceed this share of the path's smallest radius of curvature.
WIDEST = 0.9
#: Nor may it be below this share of the coordinates: postures are brought back to 1e-14 of them.
FINEST = 1e-11
#: Postures looked at for a start on the path.
_STARTS = 4096


# ---- a whole path ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Followed:
    """A path followed in m stretches.

    Attributes:
        method: how the rates were chosen.
        tolerance: the distance from the path, in m, at which a stretch ends.
        status: ``finished``; ``singular`` (the arm cannot go on along the tangent, or makes no progress), ``joint
            limit``, ``unreachable`` (the start, or the point to come back to) or ``too many updates``.
        reason: the status in a sentence, with the place.
        q: (m, 3) where each stretch begins, tip on the path; rad or m.
        q_end: (m, 3) where it ends, before the update.
        rates: (m, 3) joint rates per metre of path at the stretch's beginning.
        travel: (m,) how long each lasted, in m: q_end = q + rates travel.
        s: (m + 1,) arc length where each begins, and where the last ends.
        offset: (m,) the signed distance from the path at the end of each, left positive, in m.
        ended: m reasons, from :data:`chainrule.stretches.ENDS`.
        worst: the largest distance from the path met, in m.
        start_moved: how far the tip of the given posture had to be moved to be on the path, in m.
    """

    method: Method
    tolerance: float
    status: Status
    reason: str
    q: Array
    q_end: Array
    rates: Array
    travel: Array
    s: Array
    offset: Array
    ended: tuple[str, ...]
    worst: float
    start_moved: float

    @property
    def updates(self) -> int:
        """How often the tip was measured and brought back onto the path."""
        return max(len(self.q) - 1, 0)

    @property
    def followed(self) -> float:
        """Arc length followed, in m."""
        return float(self.s[-1] - self.s[0]) if len(self.s) else 0.0

    def postures(self, each: int = 20) -> Array:
        """(m, each, 3) postures along every stretch, equally spaced in time, both ends included."""
        share = np.linspace(0.0, 1.0, each)
        return self.q[:, None] + self.rates[:, None] * (self.travel[:, None] * share)[..., None]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "method": self.method,
            "tolerance": self.tolerance,
            "status": self.status,
            "reason": self.reason,
            "updates": self.updates,
            "followed": self.followed,
            "worst": self.worst,
            "start_moved": self.start_moved,
            "s": self.s.tolist(),
            "q": self.q.tolist(),
            "q_end": self.q_end.tolist(),
            "rates": self.rates.tolist(),
            "travel": self.travel.tolist(),
            "offset": self.offset.tolist(),
            "ended": list(self.ended),
        }


def follow(
    arm: Arm,
    path: Path,
    tolerance: float,
    *,
    method: Method = "look_ahead",
    q: Any = None,
    start: float | None = None,
    max_updates: int = 10_000,
) -> Followed:
    """Follow a path to its end, a closed one once around.

    Args:
        arm: a planar arm with three joints.
        path: see :mod:`chainrule.paths`.
        tolerance: distance from the path, in m, at which the tip is brought back; at most 0.9 of the path's smallest
            radius of curvature, so that the nearest point is never in doubt.
        method: one of :data:`chainrule.stretches.METHODS`.
        q: (3,) the posture to start in. Its tip must be within the tolerance of the path and is brought onto it; with
            ``start`` it is a guess, and the posture nearest to it with its tip at r(start) is found. Without it the
            start is the best posture found (largest manipulability), always the same one.
        start: arc length, in m, at which to begin; without it at the beginning, or where the tip of ``q`` is.
        max_updates: after so many updates it is given up.

    Raises:
        InputError: an arm that is not planar with three joints; a tolerance that is not positive or too large for the
            path; an unknown method; a posture whose tip is too far from the path or outside the joint limits.

    Example:
        >>> import chainrule as cr
        >>> arm, circle = cr.planar_3r(1.0, 0.8, 0.6), cr.Circle((1.2, 0.3), 0.4)
        >>> [cr.follow(arm, circle, 0.002, method=m).status for m in ("pseudoinverse", "look_ahead")]
        ['finished', 'finished']
    """
    chains = _chains(arm)
    margin = _tolerance(tolerance)
    _known(method)
    _path(path)
    _narrow(margin, path.max_curvature)
    most = whole_number(max_updates, "max_updates", 0)
    begin, posture, moved = _start(arm, chains, path, margin, q, start)
    if posture is None:
        where = path.point(begin)
        reason = f"no posture was found with the tip at the start of the path ({where[0]:.4g}, {where[1]:.4g})"
        return _result(method, margin, UNREACHABLE, reason, [], np.array([begin]), 0.0, moved)
    _fine(margin, float(chains.size(posture[None])[0]) + float(np.abs(path.point(begin)).max()))
    end = begin + path.length if path.closed else path.length
    tracks = Placed(path, np.array([[1.0, 0.0]]), np.zeros((1, 2)), np.array([end]))
    log = _run(chains, tracks, posture[None], np.array([begin]), np.array([margin]), method, most)
    stretches = [(entry.q[0], entry.rates[0], entry.found) for entry in log.entries]
    ends = np.array([begin, *(found.s[0] for _, _, found in stretches)])
    worst = max((float(found.swing[0]) for _, _, found in stretches), default=0.0)
    status = int(log.status[0])
    reason = _reason(arm, status, stretches, float(ends[-1]), most)
    return _result(method, margin, status, reason, stretches, ends, worst, moved)


def _result(
    method: Method,
    tolerance: float,
    status: int,
    reason: str,
    stretches: list[tuple[Array, Array, Stretches]],
    s: Array,
    worst: float,
    moved: float,
) -> Followed:
    q, rates = (np.array([entry[k] for entry in stretches]).reshape(-1, 3) for k in (0, 1))
    travel = np.array([found.t[0] for _, _, found in stretches])
    return Followed(
        method=method,
        tolerance=tolerance,
        status=STATUSES[status],
        reason=reason,
        q=q,
        q_end=q + rates * travel[:, None],
        rates=rates,
        travel=travel,
        s=s,
        offset=np.array([found.offset[0] for _, _, found in stretches]),
        ended=tuple(ENDS[int(found.ended[0])] for _, _, found in stretches),
        worst=worst,
        start_moved=moved,
    )


def _reason(arm: Arm, status: int, stretches: list[tuple[Array, Array, Stretches]], s: float, most: int) -> str:
    at = f"at s = {s:.6g} m"
    if status == FINISHED:
        return "the end of the path was reached"
    if status == SINGULAR:
        return f"{at} the arm is singular, or so nearly that it makes no progress along the tangent"
    if status == UNREACHABLE:
        return f"{at} the tip cannot be brought back onto the path"
    if status == UNFINISHED:
        return f"{at} {most} updates had been made"
    q, rates, found = stretches[-1]
    ending = q + rates * found.t[0]
    lower, upper = arm.limits.position.T
    room = np.where(rates > 0.0, upper - ending, np.where(rates < 0.0, ending - lower, np.inf))
    return f"{at} joint '{arm.joint_names[int(np.argmin(room))]}' is at its limit"


@dataclass(frozen=True)
class _Entry:
    """One stretch of the cases ``which``."""

    which: Array
    q: Array
    rates: Array
    found: Stretches


@dataclass(frozen=True)
class _Log:
    """What became of k cases: every stretch, the status of each, how many updates, and how far each got."""

    entries: list[_Entry]
    status: Array
    updates: Array
    s: Array


def _run(chains: Chains, tracks: Tracks, q: Array, s: Array, tolerance: Array, method: Method, most: int) -> _Log:
    """Follow k paths with k arms: stretch, measure, come back, until every one is done."""
    k = len(q)
    status, updates = np.full(k, UNFINISHED), np.zeros(k, dtype=int)
    live, q, s, final = np.arange(k), q.copy(), np.array(s, float), np.array(s, float)
    entries: list[_Entry] = []
    for count in range(most + 1):
        case = stand(chains, q, tracks.at(s), tolerance)
        rates, found = choose(case, tracks, s, method)
        at_end = (found.ended == END) | (found.ended == LIMIT)
        moved = (found.ended != STUCK) & ((found.s - s > PROGRESS * tolerance) | at_end)
        state = np.full(len(live), -1)
        state[found.ended == END] = FINISHED
        state[found.ended == LIMIT] = AT_LIMIT
        state[~moved] = SINGULAR
        kept = np.nonzero(moved)[0]
        if len(kept):
            entries.append(_Entry(live[kept], q[kept], rates[kept], found.take(kept)))
        final[live] = np.where(moved, found.s, s)
        on = np.nonzero(state < 0)[0]
        back, good = bring(
            chains.take(on), q[on] + rates[on] * found.t[on][:, None], tracks.take(on).at(found.s[on]).point
        )
        state[on[~good]] = UNREACHABLE
        status[live[state >= 0]] = state[state >= 0]
        on = on[good]
        if not len(on) or count == most:
            break
        live, q, s = live[on], back[good], found.s[on]
        updates[live] += 1
        chains, tracks, tolerance = chains.take(on), tracks.take(on), tolerance[on]
    return _Log(entries, status, updates, final)


def bring(chains: Chains, q: Array, goal: Array, step: float = 0.5) -> tuple[Array, Array]:
    """Postures (k, n) with the tip at ``goal`` (k, 2), by Newton's method q += J^+ (goal - r), and which were found.

    A step turns no joint by more than ``step`` rad. Postures outside the joint limits do not count.
    """
    turning = np.array([kind == "R" for kind in chains.kinds])
    q = q.copy()
    accuracy = 1e-14 * (chains.size(q) + np.hypot(goal[:, 0], goal[:, 1]))
    zero = np.zeros(len(q))
    for _ in range(60):
        away = goal - chains.tip(q)
        gap = np.hypot(away[:, 0], away[:, 1])
        far = gap > accuracy
        if not far.any():
            break
        direction = away / np.where(far, gap, 1.0)[:, None]
        change = chains.rates(q, np.where(far[:, None], direction, [1.0, 0.0]), zero, zero).least * gap[:, None]
        size = np.abs(np.where(turning, change, 0.0)).max(axis=1)
        q = q + np.where(far, np.minimum(1.0, step / np.maximum(size, 1e-300)), 0.0)[:, None] * change
    away = goal - chains.tip(q)
    lower, upper = chains.limits.T
    inside = ((q >= lower - 1e-12) & (q <= upper + 1e-12)).all(axis=1)
    return q, (np.hypot(away[:, 0], away[:, 1]) <= 100.0 * accuracy) & inside


def _start(
    arm: Arm, chains: Chains, path: Path, tolerance: float, q: Any, start: float | None
) -> tuple[float, Array | None, float]:
    """Arc length and posture to begin with (None where there is none), and how far the given tip was from there."""
    if start is not None:
        begin = real_number(start, "start")
        if not 0.0 <= begin <= path.length or (begin == path.length and not path.closed):
            raise InputError(
                f"start: {begin:g} m; from 0 to less than the path's length, {path.length:.6g} m, is accepted"
            )
    else:
        begin = 0.0
    if q is None:
        return begin, _posture(arm, chains, path.point(begin), None), 0.0
    given = real_array(q, "q")
    if given.shape != (arm.n,):
        raise InputError(f"q: shape {given.shape}; ({arm.n},) is accepted")
    lower, upper = arm.limits.position.T
    outside = np.nonzero((given < lower) | (given > upper))[0]
    if len(outside):
        raise InputError(f"q: joint '{arm.joint_names[outside[0]]}' is outside its limits at {given[outside[0]]:g}")
    tip = chains.tip(given[None])[0]
    if start is None:
        nearest = path.nearest(tip)
        begin, moved = float(nearest.s), float(nearest.distance)
        if not path.closed and begin >= path.length:
            raise InputError("q: the tip is at the end of the path already; start= says where to begin")
        if moved > tolerance:
            raise InputError(
                f"q: the tip is {moved:.4g} m from the path, farther than the tolerance; with start= it is a guess, "
                "and without q a start is found"
            )
        found, good = bring(chains, given[None], path.point(begin)[None])
        return begin, found[0] if good[0] else None, moved
    goal = path.point(begin)
    return begin, _posture(arm, chains, goal, given), float(np.hypot(*(goal - tip)))


def _posture(arm: Arm, chains: Chains, goal: Array, near: Array | None) -> Array | None:
    """A posture with the tip at a point: the one nearest to ``near``, else the one with the largest manipulability."""
    guesses = samples(arm, _STARTS, seed=1)
    gaps = np.linalg.norm(arm.position(guesses) - goal, axis=1)
    guesses = guesses[np.argsort(gaps, kind="stable")[:64]]
    if near is not None:
        guesses = np.vstack([near, guesses])
    many = chains.take(np.zeros(len(guesses), dtype=int))
    found, good = bring(many, guesses, np.broadcast_to(goal, (len(guesses), 2)))
    if not good.any():
        return None
    if near is not None:
        score = -np.linalg.norm(found - near, axis=1)
    else:
        score = np.asarray(arm.manipulability(found, task="position"))
    best: Array = found[int(np.where(good, score, -np.inf).argmax())]
    return best


def _chains(arm: Arm) -> Chains:
    if not isinstance(arm, Arm):
        raise InputError(f"arm: {shown(arm)}; an arm such as load('planar_3r') is accepted")
    if not isinstance(arm.description.geometry, Planar) or arm.n != 3:
        raise InputError(f"{arm.name}: {arm.n} joints ({arm.kinds}); a planar arm with three joints is accepted")
    return Chains(arm.kinds, arm.evaluator, arm.parameters[None], np.array(arm.limits.position))


def _tolerance(value: Any) -> float:
    number = real_number(value, "tolerance")
    if not number > 0.0:
        raise InputError(f"tolerance: {number}; a positive number of metres is accepted")
    return number


def _fine(tolerance: float, size: float) -> None:
    """Refuse a tolerance that rounding of coordinates of this size decides."""
    if tolerance < FINEST * size:
        raise InputError(
            f"tolerance: {tolerance:g} m; at least {FINEST * size:.2g} m is accepted here: rounding is finer"
        )


def _narrow(tolerance: float, curvature: float) -> None:
    """Refuse a tolerance within which the nearest point of the path is in doubt."""
    if tolerance * curvature > WIDEST:
        raise InputError(
            f"tolerance: {tolerance:g} m; up to {WIDEST / curvature:.4g} m is accepted, {WIDEST:g} of the smallest "
            "radius of curvature"
        )


def _known(method: Any) -> None:
    if not isinstance(method, str) or method not in METHODS:
        raise InputError(f"method: {shown(method)}; {', '.join(METHODS)} are accepted")


def _methods(methods: Any) -> tuple[Method, ...]:
    """Several methods, each once."""
    if isinstance(methods, str) or not isinstance(methods, Sequence) or not methods:
        raise InputError(f"methods: {shown(methods)}; a list of {', '.join(METHODS)} is accepted")
    for method in methods:
        _known(method)
    return tuple(dict.fromkeys(methods))


def _path(path: Any) -> None:
    if not isinstance(path, Path):
        raise InputError(f"path: {shown(path)}; a path such as Circle, Spline or Curve is accepted")


def _place(methods: tuple[Method, ...], method: Any) -> int:
    """Which of the methods of a result this is."""
    if not isinstance(method, str) or method not in methods:
        raise InputError(f"method: {shown(method)}; {', '.join(methods)} were compared")
    return methods.index(method)


# ---- one stretch, method against method ------------------------------------------------------------------------


@dataclass(frozen=True)
class Comparison:
    """One stretch along circular arcs (or lines) from the same postures, by every method.

    Attributes:
        methods: the m methods.
        tolerance: in m.
        rates: (..., m, 3) joint rates per metre of path at the start.
        travel: (..., m) arc length of the desired path when the tolerance is reached, in m; 0 where the arm is
            singular; at most one turn, or four times the arm's size.
        duration: (..., m) how long the joints move: they end at q + rates duration.
        predicted: (..., m) the travel by the two-term offset.
        curvature: (..., m) of the path each makes, at the start, in 1/m.
        curvature_rate: (..., m) its dk/ds, in 1/m^2.
        ended: (..., m) why each ended, numbers in :data:`chainrule.stretches.ENDS`.
        discriminant: (...,) negative where no constant rates have the desired curvature.
        roots: (..., 2) travel by each of the two solutions for the curvature; nan where there is none.
        chosen: (...,) the solution (from 0) that the paper's rule takes.
    """

    methods: tuple[Method, ...]
    tolerance: float
    rates: Array
    travel: Array
    duration: Array
    predicted: Array
    curvature: Array
    curvature_rate: Array
    ended: Array
    discriminant: Array
    roots: Array
    chosen: Array

    def of(self, method: Method) -> Array:
        """The travel (...,) of one method."""
        found: Array = self.travel[..., _place(self.methods, method)]
        return found

    def ratio(self, method: Method, other: Method = "pseudoinverse") -> Array:
        """How many times as far one method travels as another, (...,); nan where the other does not move."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.of(other) > 0.0, self.of(method) / self.of(other), np.nan)

    def to_dict(self) -> dict[str, Any]:
        """Plain values; null where there is no number."""
        names = ("rates", "travel", "duration", "predicted", "curvature", "curvature_rate", "discriminant", "roots")
        lists = {name: _listed(getattr(self, name)) for name in names}
        ended = np.take(np.array(ENDS), self.ended).tolist()
        return {"methods": list(self.methods), "tolerance": self.tolerance, **lists, "ended": ended}


def _listed(values: Array) -> Any:
    """Nested lists, with None for what is not finite."""
    objects: Array = values.astype(object)
    objects[~np.isfinite(values)] = None
    return objects.tolist()


def compare(
    arm: Arm, q: Any, tangent: Any, curvature: Any, tolerance: float, *, methods: Sequence[Method] = METHODS
) -> Comparison:
    """How far each method gets along a circular arc before the tip is ``tolerance`` away from it.

    Args:
        arm: a planar arm with three joints.
        q: (..., 3) postures; leading axes broadcast.
        tangent: (..., 2) directions of the arc at the tip; any length but zero.
        curvature: (...,) of the arc in 1/m, left turns positive; 0 is a straight line.
        tolerance: in m; at most 0.9 of the smallest radius.
        methods: which methods.

    Raises:
        InputError: one line saying what is wrong.

    Example:
        >>> import numpy as np
        >>> from chainrule import load
        >>> arm, q = load("ambike_3r"), np.radians([-14.0, -10.0, -205.0])
        >>> found = compare(arm, q, [2.0, 1.0], -1.0, 0.025)  # example 1 of the paper
        >>> float(found.ratio("speed_ratio").round(2)) > 1.0
        True
    """
    chains = _chains(arm)
    margin = _tolerance(tolerance)
    methods = _methods(methods)
    given, direction, bend = (
        real_array(value, name) for value, name in ((q, "q"), (tangent, "tangent"), (curvature, "curvature"))
    )
    if given.ndim < 1 or given.shape[-1] != 3:
        raise InputError(f"q: shape {given.shape}; (..., 3) is accepted")
    if direction.ndim < 1 or direction.shape[-1] != 2:
        raise InputError(f"tangent: shape {direction.shape}; (..., 2) is accepted")
    try:
        lead = np.broadcast_shapes(given.shape[:-1], direction.shape[:-1], bend.shape)
    except ValueError:
        raise InputError(
            f"q {given.shape}, tangent {direction.shape} and curvature {bend.shape} do not broadcast together"
        ) from None
    direction = unit(direction, "tangent")
    _narrow(margin, float(np.abs(bend).max(initial=0.0)))
    flat = np.broadcast_to(given, (*lead, 3)).reshape(-1, 3)
    headings = np.broadcast_to(direction, (*lead, 2)).reshape(-1, 2)
    _fine(margin, float(chains.size(flat).max(initial=0.0)))
    found = _compared(
        chains.take(np.zeros(len(flat), dtype=int)),
        flat,
        headings,
        np.broadcast_to(bend, lead).reshape(-1),
        margin,
        methods,
    )
    shaped = {name: a.reshape((*lead, *a.shape[1:])) for name, a in vars(found).items() if isinstance(a, np.ndarray)}
    return Comparison(methods=found.methods, tolerance=margin, **shaped)


def _compared(
    chains: Chains, q: Array, tangent: Array, curvature: Array, tolerance: float, methods: tuple[Method, ...]
) -> Comparison:
    """:func:`compare` for k arms, one each."""
    with np.errstate(divide="ignore"):
        end = np.minimum(2.0 * np.pi / np.abs(curvature), 4.0 * chains.size(q))
    tracks, zero, margin = Arcs(chains.tip(q), tangent, curvature, end), np.zeros(len(q)), np.full(len(q), tolerance)
    case = stand(chains, q, tracks.at(zero), margin)
    rates, travel, duration, predicted, bend, change, ended = [], [], [], [], [], [], []
    for method in methods:
        x, found = choose(case, tracks, zero, method)
        path = chains.motion(q, x)[1]
        still = ~(x != 0.0).any(axis=1)
        rates.append(x)
        travel.append(found.s)
        duration.append(found.t)
        predicted.append(np.where(still, 0.0, case.travel(path[:, 1], path[:, 2])))
        bend.append(path[:, 1])
        change.append(path[:, 2])
        ended.append(found.ended)
    roots = np.full((len(q), 2), np.nan)
    for k in (0, 1):
        own = picked(case.rates.both, np.full(len(q), k))
        there = case.rates.exist[:, k]
        roots[there, k] = stretch(chains, tracks, q, zero, own, margin).s[there]
    return Comparison(
        methods=methods,
        tolerance=tolerance,
        rates=np.stack(rates, axis=1),
        travel=np.stack(travel, axis=1),
        duration=np.stack(duration, axis=1),
        predicted=np.stack(predicted, axis=1),
        curvature=np.stack(bend, axis=1),
        curvature_rate=np.stack(change, axis=1),
        ended=np.stack(ended, axis=1),
        discriminant=case.rates.discriminant,
        roots=roots,
        chosen=case.rates.nearer,
    )


# ---- many arms and paths ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Study:
    """How far each method gets, over many random arms, postures and arcs.

    Attributes:
        kinds: the arms' joints, such as ``RRR``.
        lengths: (k, 3) their link lengths in m.
        curvature: (k,) of the arcs in 1/m.
        comparison: the k stretches.
    """

    kinds: str
    lengths: Array
    curvature: Array
    comparison: Comparison

    def quantiles(self, method: Method, shares: Sequence[float] = (0.05, 0.25, 0.5, 0.75, 0.95)) -> Array:
        """Quantiles of how many times as far a method travels as the pseudoinverse."""
        return np.asarray(np.nanquantile(self.comparison.ratio(method), shares))

    def to_dict(self) -> dict[str, Any]:
        """The distribution in numbers: medians, shares of cases in which a method is worse, predictions."""
        found = self.comparison
        ratio, met = found.ratio("speed_ratio"), found.discriminant >= 0.0
        pair = [found.methods.index("speed_ratio"), found.methods.index("pseudoinverse")]
        gap, guess = (np.diff(a[:, pair], axis=1)[:, 0] for a in (found.travel, found.predicted))
        decided = np.abs(gap) > 1e-9 * found.travel[:, pair].max(axis=1)
        both = np.isfinite(found.roots).all(axis=1) & (np.abs(np.diff(found.roots, axis=1)[:, 0]) > 1e-9)
        missed = found.roots[both].argmax(axis=1) != found.chosen[both]
        return {
            "kinds": self.kinds,
            "cases": len(ratio),
            "tolerance": found.tolerance,
            "met": float(met.mean()),
            "median": _median(ratio),
            "median_met": _median(ratio[met]),
            "median_not_met": _median(ratio[~met]),
            "worse": _share(ratio < 1.0 - 1e-9),
            "worse_met": _share(ratio[met] < 1.0 - 1e-9),
            "worse_not_met": _share(ratio[~met] < 1.0 - 1e-9),
            "two_term_median": _median(found.ratio("two_term")),
            "two_term_worse": _share(found.ratio("two_term") < 1.0 - 1e-9),
            "look_ahead_median": _median(found.ratio("look_ahead")),
            "look_ahead_worse": _share(
                found.of("look_ahead") < (1.0 - 1e-9) * np.maximum(found.of("speed_ratio"), found.of("pseudoinverse"))
            ),
            "winner_predicted": _share((np.sign(gap) == np.sign(guess))[decided]),
            "better_root_missed": int(missed.sum()),
            "two_roots": int(both.sum()),
        }


def _median(values: Array) -> float | None:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else None


def _share(flags: Array) -> float | None:
    return float(flags.mean()) if len(flags) else None


def study(
    count: int = 1000,
    tolerance: float = 0.025,
    *,
    kinds: str = "RRR",
    lengths: Sequence[float] | None = None,
    curvature: float = 1.0,
    seed: int = 0,
) -> Study:
    """Compare the methods over ``count`` random arms, postures, directions and both turns; the same for the same seed.

    Args:
        count: how many cases.
        tolerance: in m.
        kinds: three joints, R or P each.
        lengths: (3,) link lengths in m of every arm; without them each arm has its own, uniform from 0.2 to 1.8.
        curvature: magnitude of the arcs' curvature in 1/m; the turn is drawn.
        seed: of the random numbers.

    Raises:
        InputError: one line saying what is wrong.

    Example:
        >>> study(200, 0.005, seed=1).to_dict()["look_ahead_worse"]
        0.0
    """
    margin = _tolerance(tolerance)
    count = whole_number(count, "count")
    bend = real_number(curvature, "curvature")
    _narrow(margin, abs(bend))
    random = np.random.default_rng(whole_number(seed, "seed", 0))
    chains, q = random_arms(random, count, kinds, lengths)
    heading = random.uniform(-np.pi, np.pi, count)
    tangent = np.stack([np.cos(heading), np.sin(heading)], axis=1)
    bends = bend * random.choice([-1.0, 1.0], count)
    found = _compared(chains, q, tangent, bends, margin, METHODS)
    return Study(kinds, chains.parameters[:, :3], bends, found)


def random_arms(
    random: np.random.Generator, count: int, kinds: str, lengths: Sequence[float] | None
) -> tuple[Chains, Array]:
    """Arms of one kind without joint limits, and a posture (count, 3) of each."""
    if not isinstance(kinds, str) or len(kinds) != 3 or set(kinds) - {"R", "P"}:
        raise InputError(f"kinds: {shown(kinds)}; three letters, R or P each, are accepted")
    sliding = np.array([kind == "P" for kind in kinds])
    own = random.uniform(0.2, 1.8, (count, 3))
    if lengths is not None:
        given = real_array(lengths, "lengths")
        if given.shape != (3,) or not (given > 0.0).all():
            raise InputError(f"lengths: {shown(lengths)}; three positive numbers are accepted")
        own = np.broadcast_to(given, (count, 3))
    headings = random.uniform(-np.pi, np.pi, (count, int(sliding.sum())))
    evaluators = Evaluators(planar_model(kinds))
    groups = {"tip_motion": "motion", "speed_ratio_rates": "speed_ratio"}

    def evaluator(name: str) -> Any:
        return evaluators.get(groups.get(name, "kinematics"), name)

    free = np.tile([-np.inf, np.inf], (3, 1))
    q = np.where(sliding, random.uniform(-0.2, 0.8, (count, 3)), random.uniform(-np.pi, np.pi, (count, 3)))
    return Chains(kinds, evaluator, np.concatenate([own, headings], axis=1), free), q


@dataclass(frozen=True)
class Loops:
    """Whole paths followed by many arms, each with every method from the same posture.

    Attributes:
        methods: the m methods.
        tolerance: in m.
        updates: (k, m) feedback updates.
        finished: (k, m) which reached the end.
    """

    methods: tuple[Method, ...]
    tolerance: float
    updates: Array
    finished: Array

    def ratio(self, method: Method, other: Method = "pseudoinverse") -> Array:
        """Updates of one method divided by another's, where both reached the end and the other needed any."""
        i, j = (_place(self.methods, name) for name in (method, other))
        use = self.finished[:, i] & self.finished[:, j] & (self.updates[:, j] > 0)
        found: Array = self.updates[use, i] / self.updates[use, j]
        return found

    def to_dict(self) -> dict[str, Any]:
        """For each method: the share that reached the end, median updates, and ratios to the pseudoinverse."""
        rows = {}
        for k, method in enumerate(self.methods):
            ratio = self.ratio(method)
            rows[method] = {
                "finished": float(self.finished[:, k].mean()),
                "median_updates": _median(self.updates[self.finished.all(axis=1), k].astype(float)),
                "median_ratio": _median(ratio),
                "more": _share(ratio > 1.0),
                "fewer": _share(ratio < 1.0),
            }
        return {"cases": len(self.updates), "tolerance": self.tolerance, "methods": rows}


def study_paths(
    path: Path,
    count: int = 200,
    tolerance: float = 0.005,
    *,
    lengths: Sequence[float] | None = None,
    methods: Sequence[Method] = METHODS,
    seed: int = 0,
    max_updates: int = 2000,
) -> Loops:
    """Follow one path with ``count`` random 3R arms, the path placed at the tip in a random direction.

    Postures are drawn until the path fits into the arm's workspace with a twentieth of its reach to spare.

    Raises:
        InputError: one line saying what is wrong; a path that no random arm can hold.

    Example:
        >>> from chainrule import Circle
        >>> study_paths(Circle((0.0, 0.0), 0.3), 20).to_dict()["cases"]
        20
    """
    margin, methods = _tolerance(tolerance), _methods(methods)
    _path(path)
    _narrow(margin, path.max_curvature)
    count, most = whole_number(count, "count"), whole_number(max_updates, "max_updates", 0)
    random = np.random.default_rng(whole_number(seed, "seed", 0))
    grid = path.point(np.linspace(0.0, path.length, 200))
    heading = path.tangent(0.0)
    stores: tuple[list[Array], ...] = ([], [], [], [])
    kept = 0
    for _ in range(100):
        chains, q = random_arms(random, 4 * count, "RRR", lengths)
        angle = random.uniform(-np.pi, np.pi, len(q))
        c, s = np.cos(angle), np.sin(angle)
        turn = np.stack([c * heading[0] + s * heading[1], s * heading[0] - c * heading[1]], axis=1)
        spun = np.stack(
            [
                turn[:, :1] * grid[:, 0] - turn[:, 1:] * grid[:, 1],
                turn[:, 1:] * grid[:, 0] + turn[:, :1] * grid[:, 1],
            ],
            axis=2,
        )
        shift = chains.tip(q) - spun[:, 0]
        radius = np.linalg.norm(spun + shift[:, None], axis=2)
        links = chains.parameters
        reach = links.sum(axis=1)
        hole = np.maximum(0.0, 2.0 * links.max(axis=1) - reach)
        fits = (radius.max(axis=1) < 0.95 * reach) & (radius.min(axis=1) > hole + 0.05 * reach)
        for store, values in zip(stores, (links, q, turn, shift), strict=True):
            store.append(values[fits])
        kept += int(fits.sum())
        if kept >= count:
            break
    else:
        raise InputError(f"path: no {count} random arms were found that reach all of it; a smaller path is accepted")
    arms, q, turn, shift = (np.concatenate(store)[:count] for store in stores)
    all_chains = Chains("RRR", chains.evaluator, arms, chains.limits)
    end = np.full(count, path.length)
    tracks = Placed(path, turn, shift, end)
    zero, tolerances = np.zeros(count), np.full(count, margin)
    logs = [_run(all_chains, tracks, q, zero, tolerances, method, most) for method in methods]
    return Loops(
        methods,
        margin,
        np.stack([log.updates for log in logs], axis=1),
        np.stack([log.status == FINISHED for log in logs], axis=1),
    )
