"""One stretch: joints at constant rates until the tip has drifted too far from a path, for many arms at once.

The joints move along straight lines, q + x t, with the rates x chosen so that the tip leaves along the path's tangent T
at unit speed. With k and k' the curvature and dk/ds of the path that these rates make, and K, K' those of the desired
path, the signed offset of the tip after the arc length s is
    e(s) = (k - K) s^2 / 2 + (k' - K') s^3 / 6 + O(s^4).
Speed-ratio control (Ambike, Schmiedeler and Stanisic) makes the first term vanish. It says nothing of the second; and
an offset that swings to one side and back again stays within the tolerance longer than one without a first term.

:func:`stretch` moves the joints and finds where the tolerance is reached; :func:`choose` finds the rates. Everything
has the cases, one arm and one path each, on its first axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from chainrule.evaluators import Evaluator
from chainrule.paths import Foot, Frame, Path, arc_frame, arc_locate, cross, dot

Array = NDArray[Any]
Method = Literal["pseudoinverse", "speed_ratio", "two_term", "look_ahead"]

METHODS: tuple[Method, ...] = ("pseudoinverse", "speed_ratio", "two_term", "look_ahead")

#: Why a stretch ended, by its number.
ENDS = ("tolerance", "turned back", "end of the path", "joint limit", "no progress", "search limit")
TOLERANCE, TURNED, END, LIMIT, STUCK, LONG = range(len(ENDS))

#: The distance at which a stretch ends is located to this share of the tolerance (and to rounding).
ACCURACY = 1e-12
#: Share of the tolerance that the two-term offset may use on the side it swings to first; others that looking ahead
#: tries. The terms left out decide whether a swing closer to the tolerance comes back.
SWING, _SWINGS = 0.6, (0.95, 0.8, 0.4)
_STEPS, _GRID, _ZOOMS = 20_000, 33, 2
#: The rates do not depend on which joint leads; the generated function asks for one.
_LEADING = np.array([1.0, 0.0, 0.0])


# ---- many arms on many paths -----------------------------------------------------------------------------------


class Tracks(Protocol):
    """Paths of k cases, one each."""

    @property
    def bend(self) -> Array:
        """(k,) no curvature of the path is larger in magnitude."""

    @property
    def end(self) -> Array:
        """(k,) the arc length at which following ends."""

    def at(self, s: Array) -> Frame:
        """The frames at arc lengths (k,)."""

    def locate(self, points: Array, s: Array) -> Foot:
        """The feet near ``s`` (k,) of points (k, 2)."""

    def take(self, which: Array) -> Tracks:
        """Some of the cases."""


@dataclass(frozen=True)
class Arcs:
    """Curves of constant curvature: start (k, 2), tangent (k, 2), curvature (k,), end (k,)."""

    start: Array
    tangent: Array
    curvature: Array
    end: Array

    @property
    def bend(self) -> Array:
        """Their curvature."""
        return np.abs(self.curvature)

    def at(self, s: Array) -> Frame:
        """As :class:`Tracks`."""
        return arc_frame(self.start, self.tangent, self.curvature, s)

    def locate(self, points: Array, s: Array) -> Foot:
        """As :class:`Tracks`."""
        return arc_locate(self.start, self.tangent, self.curvature, points, s)

    def take(self, which: Array) -> Arcs:
        """As :class:`Tracks`."""
        return Arcs(self.start[which], self.tangent[which], self.curvature[which], self.end[which])


@dataclass(frozen=True)
class Placed:
    """One path, turned about the origin and then shifted for each case.

    Turn (k, 2) is (cos, sin), shift (k, 2), end (k,).
    """

    path: Path
    turn: Array
    shift: Array
    end: Array

    @property
    def bend(self) -> Array:
        """The path's largest curvature."""
        return np.full(len(self.end), self.path.max_curvature)

    def at(self, s: Array) -> Frame:
        """As :class:`Tracks`."""
        frame = self.path.at(s)
        point, tangent = (_turned(v, self.turn) for v in (frame.point, frame.tangent))
        return Frame(point + self.shift, tangent, frame.curvature, frame.curvature_rate)

    def locate(self, points: Array, s: Array) -> Foot:
        """As :class:`Tracks`."""
        back = self.turn * np.array([1.0, -1.0])
        foot = self.path.locate(_turned(points - self.shift, back), s)
        return Foot(foot.s, foot.offset, _turned(foot.tangent, self.turn))

    def take(self, which: Array) -> Placed:
        """As :class:`Tracks`."""
        return Placed(self.path, self.turn[which], self.shift[which], self.end[which])


def _turned(v: Array, turn: Array) -> Array:
    c, s = turn[..., 0], turn[..., 1]
    return np.stack([c * v[..., 0] - s * v[..., 1], s * v[..., 0] + c * v[..., 1]], axis=-1)


@dataclass(frozen=True)
class Chains:
    """k arms of one kind, such as RRR: parameters (k, p), joint limits (n, 2)."""

    kinds: str
    evaluator: Callable[[str], Evaluator]
    parameters: Array
    limits: Array

    def take(self, which: Array) -> Chains:
        """Some of them."""
        return replace(self, parameters=self.parameters[which])

    def tip(self, q: Array) -> Array:
        """Positions (k, 2)."""
        found: Array = self.evaluator("position")(q, self.parameters)
        return found

    def motion(self, q: Array, rates: Array) -> tuple[Array, Array]:
        """r, r', ... (k, 5, 2) and speed, k, dk/ds, ... (k, 4) at constant rates."""
        zero = np.zeros(3)
        found: tuple[Array, Array] = self.evaluator("tip_motion")(q, self.parameters, rates, zero, zero)
        return found

    def rates(self, q: Array, tangent: Array, curvature: Array, curvature_rate: Array) -> Rates:
        """The generated speed ratios; axes between the cases and the joints broadcast."""
        extra = (slice(None), *(None,) * (np.ndim(curvature) - 1))
        wanted = np.stack(np.broadcast_arrays(curvature, curvature_rate), axis=-1)
        evaluator = self.evaluator("speed_ratio_rates")
        values = evaluator(q[extra], self.parameters[extra], tangent[extra], wanted, _LEADING)
        found = {name: value for (name, _), value in zip(evaluator.outputs, values, strict=True)}
        return Rates(
            both=found["rates"],
            tracked=found["tracked"],
            tracked_rate=found["tracked_rate"],
            nearer=found["verdict"][..., 2].astype(int),
            discriminant=found["slack"],
            least=found["least"],
        )

    def size(self, q: Array) -> Array:
        """(k,) sums of the links' advances: nothing is farther from the base than this."""
        found: Array = np.abs(self._advances(q)).sum(axis=-1)
        return found

    def bounds(self, q: Array, rates: Array) -> tuple[Array, Array, Array]:
        """Bounds on the tip's speed and acceleration along q + rates t, and the |t| up to which they hold.

        Revolute joints keep their lengths for ever; a prismatic joint may move by a quarter of the arm's size.
        """
        turning = np.array([kind == "R" for kind in self.kinds])
        spin = np.abs(np.cumsum(np.where(turning, rates, 0.0), axis=-1))
        slide = np.where(turning, 0.0, np.abs(rates))
        room = np.where(turning, 0.0, 0.25 * self.size(q)[:, None])
        with np.errstate(divide="ignore", invalid="ignore"):
            until = np.where(slide > 0.0, room / slide, np.inf).min(axis=-1)
        reach = np.abs(self._advances(q)) + room
        speed = (reach * spin + slide).sum(axis=-1)
        return speed, (reach * spin**2 + 2.0 * slide * spin).sum(axis=-1), until

    def _advances(self, q: Array) -> Array:
        sliding = np.array([kind == "P" for kind in self.kinds])
        found: Array = self.parameters[..., : len(self.kinds)] + np.where(sliding, q, 0.0)
        return found


@dataclass(frozen=True)
class Rates:
    """Joint rates along the tangent at unit tip speed, with cases on the first axis.

    Attributes:
        both: (k, ..., 2, n) the two solutions; zero where one does not exist.
        tracked: (k, ..., 2) their curvature.
        tracked_rate: (k, ..., 2) their dk/ds.
        nearer: (k, ...) the solution (0 or 1) whose dk/ds is nearer the desired one: the paper's choice.
        discriminant: (k, ...) negative where the curvature cannot be met.
        least: (k, ..., n) J^+ T; zero where the arm is singular.
    """

    both: Array
    tracked: Array
    tracked_rate: Array
    nearer: Array
    discriminant: Array
    least: Array

    @property
    def exist(self) -> Array:
        """(k, ..., 2) which solutions exist."""
        found: Array = (self.both != 0.0).any(axis=-1)
        return found


# ---- one stretch -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Stretches:
    """One stretch of each case.

    Attributes:
        t: (k,) how long the joints moved, at unit tip speed in the beginning.
        s: (k,) arc length of the foot at the end.
        offset: (k,) the tip's signed offset there, left positive.
        ended: (k,) why, a number in :data:`ENDS`.
        swing: (k,) the largest distance from the path met.
    """

    t: Array
    s: Array
    offset: Array
    ended: Array
    swing: Array

    def take(self, which: Array) -> Stretches:
        """Some of them."""
        return Stretches(self.t[which], self.s[which], self.offset[which], self.ended[which], self.swing[which])


def _safe_step(gap: Array, rate: Array, bound: Array) -> Array:
    """The largest h with rate h + bound h^2 / 2 <= gap: Newton's step towards the limit, kept from passing it."""
    root = np.sqrt(rate**2 + 2.0 * bound * gap)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(rate > 0.0, 2.0 * gap / (rate + root), np.where(bound > 0.0, (root - rate) / bound, np.inf))


def stretch(chains: Chains, tracks: Tracks, q: Array, s: Array, rates: Array, tolerance: Array) -> Stretches:
    """Move k arms along q + rates t, each until its tip is ``tolerance`` from the path for the first time.

    A stretch ends earlier where the tip turns back along the path, where the path ends, at a joint limit, or after
    20 000 steps of the search (a motion that follows the path exactly, at a tolerance of a hundred-millionth of it).

    No excursion is missed: e'' = N.r'' - k/(1 - k e) (T.r')^2 is bounded over a step by the joints' rates and the
    path's largest curvature, and a step is as long as e, e' and that bound allow. Near the tolerance this is Newton's
    method from the near side.
    """
    k = len(q)
    result = Stretches(np.zeros(k), np.array(s, float), np.zeros(k), np.full(k, STUCK), np.zeros(k))
    until = _until_limit(chains, q, rates)
    live = np.nonzero((rates != 0.0).any(axis=1))[0]
    state = _Moving(chains.take(live), tracks.take(live), q[live], rates[live], tolerance[live], until[live])
    t, at = np.zeros(len(live)), np.array(s, float)[live]
    at, offset, along, across = state.look(t, at)
    for _ in range(_STEPS):
        if not len(live):
            break
        result.swing[live] = np.maximum(result.swing[live], np.abs(offset))
        h = state.step(t, offset, along, across)
        stuck = ~(h > 4e-16 * t) & ~state.reached(offset)
        limited = t + h >= state.until
        after = np.where(limited, state.until, t + h)
        new_at, new_offset, new_along, new_across = state.look(after, at + along * (after - t))
        past = (new_along <= 0.0) | (new_at >= state.tracks.end)
        ended = np.full(len(live), -1)
        ended[limited] = LIMIT
        ended[stuck] = STUCK
        ended[state.reached(new_offset)] = TOLERANCE
        if past.any():
            where = np.nonzero(past)[0]
            later = state.take(where).first_past(t[where], after[where], at[where])
            after[where], new_at[where], new_offset[where], ended[where] = later
        t, at, offset, along, across = after, new_at, new_offset, new_along, new_across
        over = ended >= 0
        if over.any():
            done = live[over]
            result.t[done], result.s[done], result.offset[done] = t[over], at[over], offset[over]
            result.ended[done] = ended[over]
            result.swing[done] = np.maximum(result.swing[done], np.abs(offset[over]))
            keep = np.nonzero(~over)[0]
            live, state = live[keep], state.take(keep)
            t, at, offset, along, across = (a[keep] for a in (t, at, offset, along, across))
    result.t[live], result.s[live], result.offset[live], result.ended[live] = t, at, offset, LONG
    return result


def _until_limit(chains: Chains, q: Array, rates: Array) -> Array:
    """(k,) t at which the first joint meets a limit."""
    lower, upper = chains.limits.T
    with np.errstate(divide="ignore", invalid="ignore"):
        room = np.where(rates > 0.0, (upper - q) / rates, np.where(rates < 0.0, (lower - q) / rates, np.inf))
    found: Array = np.maximum(room.min(axis=1), 0.0)
    return found


@dataclass(frozen=True)
class _Moving:
    """The cases of a stretch that are still on their way."""

    chains: Chains
    tracks: Tracks
    q: Array
    rates: Array
    tolerance: Array
    until: Array

    def take(self, which: Array) -> _Moving:
        return _Moving(
            self.chains.take(which),
            self.tracks.take(which),
            self.q[which],
            self.rates[which],
            self.tolerance[which],
            self.until[which],
        )

    def look(self, t: Array, s: Array) -> tuple[Array, Array, Array, Array]:
        """The foot's arc length, the offset, and the tip's velocity along the path and across it."""
        derivatives, _ = self.chains.motion(self.q + self.rates * t[:, None], self.rates)
        foot = self.tracks.locate(derivatives[:, 0], s)
        return foot.s, foot.offset, dot(foot.tangent, derivatives[:, 1]), cross(foot.tangent, derivatives[:, 1])

    def reached(self, offset: Array) -> Array:
        """Whether the offset is the tolerance, to the accuracy and rounding."""
        rounding = 4e-15 * self.chains.size(self.q)
        found: Array = np.abs(offset) >= self.tolerance * (1.0 - ACCURACY) - rounding
        return found

    def step(self, t: Array, offset: Array, along: Array, across: Array) -> Array:
        """How far t may go on without the offset passing the tolerance."""
        most, bend, until = self.chains.bounds(self.q + self.rates * t[:, None], self.rates)
        speed = np.hypot(along, across)
        with np.errstate(divide="ignore", invalid="ignore"):
            doubling = np.where(bend > 0.0, speed / bend, np.inf)
        near = most > 2.0 * speed  # up to t + speed / bend the speed at most doubles
        speed, until = np.where(near, 2.0 * speed, most), np.where(near, np.minimum(doubling, until), until)
        path_bend = self.tracks.bend / (1.0 - self.tracks.bend * self.tolerance)
        bound = bend + path_bend * speed**2
        h = np.minimum(
            _safe_step(np.maximum(self.tolerance - offset, 0.0), across, bound),
            _safe_step(np.maximum(self.tolerance + offset, 0.0), -across, bound),
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            # the foot must not jump: at most a quarter of the smallest radius, or of what is left of the path
            local = 0.25 / np.maximum(self.tracks.bend, 1.0 / self.tracks.end) / speed
        return np.minimum(np.minimum(h, until), local)

    def first_past(self, before: Array, after: Array, s: Array) -> tuple[Array, Array, Array, Array]:
        """Between two times: t, s and offset where the tip turns back or the path ends, and which of them."""
        low, high, foot = before.copy(), after.copy(), s.copy()

        def margin(t: Array, s: Array) -> tuple[Array, Array, Array]:
            """What is positive before and not after: the speed along the path, or the share of the path left."""
            at, offset, along, _ = self.look(t, s)
            return np.minimum(along, 1.0 - at / self.tracks.end), at, offset

        ahead, behind = margin(low, foot)[0], margin(high, foot)[0]
        for _ in range(80):  # false position; a side that stays counts half (Illinois)
            share = ahead / np.maximum(ahead - behind, 1e-300)
            middle = np.minimum(np.maximum(low + (high - low) * share, low), high)
            value, at, _ = margin(middle, foot)
            past = value <= 0.0
            ahead, behind = np.where(past, 0.5 * ahead, value), np.where(past, value, 0.5 * behind)
            low, high, foot = np.where(past, low, middle), np.where(past, middle, high), np.where(past, foot, at)
            if np.all((np.abs(value) <= 4e-14) | (high - low <= 4e-16 * high)):
                break
        _, at, offset = margin(middle, foot)
        done = self.tracks.end - at <= 1e-13 * self.tracks.end
        return middle, np.where(done, self.tracks.end, at), offset, np.where(done, END, TURNED)


# ---- choosing the rates ----------------------------------------------------------------------------------------


def predicted_travel(first: Any, second: Any, tolerance: Any, swing: float = 1.0) -> Array:
    """The smallest s > 0 with abs(first s^2 / 2 + second s^3 / 6) = tolerance; infinite where both are 0.

    Where the two terms differ in sign the offset swings to one side and back. If ``swing`` is less than 1 and the
    offset comes within ``swing`` of the tolerance there, the peak counts as the end: a prediction is not that exact.

    In w = 1 / s this is the largest root of a cubic that is convex for w > 0: Newton's method from above.

    Example:
        >>> predicted_travel([2.0, 0.0], [0.0, 6.0], 0.001).round(6)
        array([0.031623, 0.1     ])
    """
    first, second, tolerance = np.broadcast_arrays(*(np.asarray(a, float) for a in (first, second, tolerance)))
    sign = np.where(first < 0.0, -1.0, 1.0)
    a, b = sign * first / 2.0, sign * second / 6.0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        back = b < 0.0
        peak = np.where(back, 4.0 * a**3 / (27.0 * b**2), np.inf)
        other = peak < tolerance * swing  # it swings through, and ends on the other side
        alpha, beta = np.where(other, -a, a), np.where(other, -b, b)
        w = np.sqrt(np.maximum(alpha, 0.0) / tolerance) + np.cbrt(np.maximum(beta, 0.0) / tolerance)
        w = _largest_root(tolerance, alpha, beta, w)
        touched = back & ~other & (peak < tolerance)
        found: Array = np.where(touched, -2.0 * a / (3.0 * b), np.where(w > 0.0, 1.0 / w, np.inf))
    return found


def _largest_root(a: Array, alpha: Array, beta: Array, w: Array) -> Array:
    """The largest root of a w^3 - alpha w - beta, by Newton's method from above; those that converge are left alone."""
    a, alpha, beta, found = (np.array(x).ravel() for x in (a, alpha, beta, w))
    open_ = np.arange(len(found))
    for _ in range(60):
        u, b, c, d = found[open_], a[open_], alpha[open_], beta[open_]
        slope = 3.0 * b * u**2 - c
        step = np.where(slope > 0.0, (b * u**3 - c * u - d) / slope, 0.0)
        found[open_] = u - np.maximum(step, 0.0)
        open_ = open_[step > 1e-12 * u]
        if not len(open_):
            break
    return found.reshape(np.shape(w))


@dataclass(frozen=True)
class Case:
    """Where k arms stand on their paths, and the rates they could take."""

    chains: Chains
    q: Array
    frame: Frame
    tolerance: Array
    rates: Rates

    def errors(self, tracked: Array, change: Array) -> tuple[Array, Array]:
        """The coefficients of s^2 / 2 and s^3 / 6 in the offset; what is asked has cases on its first axis."""
        extra = (slice(None), *(None,) * (tracked.ndim - 1))
        return tracked - self.frame.curvature[extra], change - self.frame.curvature_rate[extra]

    def travel(self, tracked: Array, change: Array, swing: float = 1.0) -> Array:
        """The predicted travel."""
        first, second = self.errors(tracked, change)
        return predicted_travel(first, second, self.tolerance[(slice(None), *(None,) * (tracked.ndim - 1))], swing)


def stand(chains: Chains, q: Array, frame: Frame, tolerance: Array) -> Case:
    """The cases with their tips at the frames' points, and the rates along the tangents."""
    rates = chains.rates(q, frame.tangent, frame.curvature, frame.curvature_rate)
    return Case(chains, q, frame, tolerance, rates)


def picked(both: Array, which: Array) -> Array:
    """(k, n) one of the solutions (k, 2, n) of each case."""
    found: Array = np.take_along_axis(both, which[:, None, None], axis=1)[:, 0]
    return found


def _two_term(case: Case, swing: float) -> Array:
    """Rates (k, n) whose two-term offset stays within the tolerance longest, of all along the tangent.

    Every such motion is a solution for the curvature K + d of some d. A travel s needs |d| < 17 tolerance / s^2 (the
    longest swing of a cubic), so with s the best of the two solutions and J^+ T the range of d is bounded: a grid, and
    finer grids about the best of it.
    """
    rates = case.rates
    _, path = case.chains.motion(case.q, rates.least)
    plain = case.travel(path[:, 1], path[:, 2], swing)
    solved = np.where(rates.exist, case.travel(rates.tracked, rates.tracked_rate, swing), 0.0)
    best = np.concatenate([solved, plain[:, None]], axis=1)
    which = best.argmax(axis=1)
    rows = np.arange(len(which))
    candidates = np.concatenate([rates.both, rates.least[:, None]], axis=1)
    chosen: Array = candidates[rows, which]
    longest = best[rows, which]
    with np.errstate(divide="ignore"):
        width = np.where(np.isfinite(longest), 17.0 * case.tolerance / longest**2, 0.0)
    centre = np.zeros(len(rows))
    for _ in range(1 + _ZOOMS):
        shift = centre[:, None] + width[:, None] * np.linspace(-1.0, 1.0, _GRID)
        wanted = case.frame.curvature[:, None] + shift
        tried = case.chains.rates(case.q, case.frame.tangent, wanted, case.frame.curvature_rate[:, None])
        travel = np.where(tried.exist, case.travel(tried.tracked, tried.tracked_rate, swing), 0.0)
        flat = travel.reshape(len(rows), 2 * _GRID)
        which = flat.argmax(axis=1)
        better = flat[rows, which] > longest
        found = tried.both.reshape(len(rows), 2 * _GRID, 3)[rows, which]
        chosen = np.where(better[:, None], found, chosen)
        longest = np.where(better, flat[rows, which], longest)
        centre, width = np.where(better, shift[rows, which // 2], centre), width * (2.0 / (_GRID - 1))
    return chosen


def _candidates(case: Case) -> Array:
    """Rates (c, k, n) that looking ahead tries: the other methods' first, so that they win ties."""
    chosen = case.rates.nearer
    own, other = (picked(case.rates.both, which) for which in (chosen, 1 - chosen))
    return np.stack([own, case.rates.least, _two_term(case, SWING), other, *(_two_term(case, w) for w in _SWINGS)])


def choose(case: Case, tracks: Tracks, s: Array, method: Method) -> tuple[Array, Stretches]:
    """The rates (k, n) of a method, and the stretch they make."""
    if method == "look_ahead":
        tried = _candidates(case)
        count, k = tried.shape[:2]
        again = np.tile(np.arange(k), count)
        found = stretch(
            case.chains.take(again),
            tracks.take(again),
            case.q[again],
            s[again],
            tried.reshape(count * k, 3),
            case.tolerance[again],
        )
        best = found.s.reshape(count, k).argmax(axis=0)
        place = best * k + np.arange(k)
        return tried[best, np.arange(k)], found.take(place)
    if method == "pseudoinverse":
        rates = case.rates.least
    elif method == "speed_ratio":
        rates = picked(case.rates.both, case.rates.nearer)
    else:
        rates = _two_term(case, SWING)
    return rates, stretch(case.chains, tracks, case.q, s, rates, case.tolerance)
