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

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.following_inputs import (
    check_against_curvature,
    check_against_rounding,
    check_method,
    check_path,
    checked_chains,
    checked_tolerance,
)
from chainrule.inputs import real_array, whole_number
from chainrule.paths import Path, real_number
from chainrule.search import samples
from chainrule.stretches import END, ENDS, LIMIT, STUCK, Chains, Method, Placed, Stretches, Tracks, choose, stand

Array = NDArray[Any]
Status = Literal["finished", "singular", "joint limit", "unreachable", "too many updates"]
FINISHED, SINGULAR, AT_LIMIT, UNREACHABLE, UNFINISHED = range(5)
STATUSES: tuple[Status, ...] = ("finished", "singular", "joint limit", "unreachable", "too many updates")

#: Stretches shorter than this share of the tolerance count as no progress.
PROGRESS = 1e-6
#: Postures looked at for a start on the path.
_STARTS = 4096


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
    chains = checked_chains(arm)
    margin = checked_tolerance(tolerance)
    check_method(method)
    check_path(path)
    check_against_curvature(margin, path.max_curvature)
    most = whole_number(max_updates, "max_updates", 0)
    begin, posture, moved = _start(arm, chains, path, margin, q, start)
    if posture is None:
        where = path.point(begin)
        reason = f"no posture was found with the tip at the start of the path ({where[0]:.4g}, {where[1]:.4g})"
        return _result(method, margin, UNREACHABLE, reason, [], np.array([begin]), 0.0, moved)
    check_against_rounding(margin, float(chains.size(posture[None])[0]) + float(np.abs(path.point(begin)).max()))
    end = begin + path.length if path.closed else path.length
    tracks = Placed(path, np.array([[1.0, 0.0]]), np.zeros((1, 2)), np.array([end]))
    log = follow_many(chains, tracks, posture[None], np.array([begin]), np.array([margin]), method, most)
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


def follow_many(
    chains: Chains, tracks: Tracks, q: Array, s: Array, tolerance: Array, method: Method, most: int
) -> _Log:
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
