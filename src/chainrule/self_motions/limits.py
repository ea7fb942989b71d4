"""What joint limits leave of any self-motion curve: whole loops and arcs, where they begin and end, and their ranges.

A revolute joint has a real value between its stops, not an angle: joint values are moved by whole turns into the
limits, and an arc is what an arm can run along without meeting a stop; where a range is wider than a turn it may be
longer than one round of the curve. Arcs that hold nothing but what another one holds, whole turns apart, are not
listed.

Crossings are roots of q_i = bound on the curve itself, to 1e-12 of its length. No grazing one is missed because the
curve's points lie far apart: between any two of them the extrema of each joint are looked for first (from values and
two derivatives at both), and refined; between neighbouring extrema a joint crosses a stop at most once.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from operator import gt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.self_motions.bundle import Bundle
from chainrule.self_motions.continuation import Dense, Grid
from chainrule.self_motions.held import Held, held_task, target_of
from chainrule.self_motions.identity import table
from chainrule.self_motions.result import Component, limit_reason

Array = NDArray[Any]

TURN = 2.0 * math.pi
#: Parts of an interval between points in which a slope is looked at for a change of sign.
PARTS = 8
#: Steps of Newton's method on a polynomial, and on the curve; the last one of those, where the
#: tangent's component is above a bound and where it is not.
POLYNOMIAL, NEWTON, STEEP, SETTLED, LAST = 4, 4, 1e-2, 1e-8, 1e-13
#: Crossings nearer to each other than this share of the length are one.
SAME = 1e-13
#: More combinations of turns within the limits than this are refused.
MOST = 4096


@dataclass(frozen=True)
class Crossing:
    """Where a joint is at one of its stops.

    Attributes:
        s: where on the curve, as a fraction of its length.
        joint: which joint, from 1.
        upper: whether it is the upper stop.
        kind: "leaves" (the allowed range, in the curve's sense), "enters", or "touches".
    """

    s: float
    joint: int
    upper: bool
    kind: str


def _known(held: Held, component: Component) -> Dense:
    """The table of a curve, its extrema included: of followed curves they are known, of others looked for here."""
    own = component.points if isinstance(component.points, Dense) else None
    if own is not None and own.h is not None:
        return own
    found = table(held, target_of(held.arm, component.q[0], held.task), component)
    s = found.s / found.s[-1]
    values, slopes, bends = _derivatives(held, component.length, found.x * held.unit, found.t)
    knots = [np.zeros((0, 3))]
    for i in range(held.arm.n + 1):
        begin, end = _brackets(s, values[:, i], slopes[:, i], bends[:, i] if i < held.arm.n else None)

        def along(at: Array) -> tuple[Array, Array, Array]:
            q = component.at(at)
            ahead = component.at(np.minimum(at + 1e-4, 1.0)) - component.at(np.maximum(at - 1e-4, 0.0))
            return _derivatives(held, component.length, q, ahead)

        def slope(at: Array, _: Array, i: int = i) -> Array:
            return along(at)[1][:, i]

        places = roots(slope, begin, end)
        if len(places):
            knots.append(np.stack([np.full(len(places), i), places * found.s[-1], along(places)[0][:, i]], axis=1))
    return replace(found, h=values[:, -1], knots=np.concatenate(knots))


def _derivatives(held: Held, length: float, q: Array, ahead: Array) -> tuple[Array, Array, Array]:
    """Values (k, n + 1) of the joints and H, their first derivatives by the fraction s, and the joints' second ones.

    ``ahead`` (k, n) is the curve's sense at each place.
    """
    null, bending = held.bend(q)
    scaled, change = null / held.unit, bending / held.unit
    size = np.linalg.norm(scaled, axis=-1, keepdims=True)
    h = np.linalg.norm(null, axis=-1, keepdims=True)
    sense = np.copysign(1.0, (ahead * scaled).sum(axis=-1, keepdims=True))
    with np.errstate(all="ignore"):
        t = sense * scaled / size
        k = (change - t * (t * change).sum(axis=-1, keepdims=True)) / size**2
        slope = sense * (null * bending).sum(axis=-1, keepdims=True) / (h * size)
    first = np.concatenate([t * held.unit, slope], axis=-1) * length
    return np.concatenate([q, h], axis=-1), np.nan_to_num(first), np.nan_to_num(k * held.unit * length**2)


def _brackets(s: Array, value: Array, slope: Array, bend: Array | None) -> tuple[Array, Array]:
    """Intervals in which a slope changes sign: seen at the points, or by the polynomial between them."""
    width = np.diff(s)[:, np.newaxis]
    u = np.linspace(0.0, 1.0, PARTS + 1)
    v = 1.0 - u
    a, b = slope[:-1, np.newaxis], slope[1:, np.newaxis]
    if bend is not None:  # the cubic through the slopes and their derivatives
        d, e = bend[:-1, np.newaxis] * width, bend[1:, np.newaxis] * width
        shape = (1 + 2 * u) * v * v * a + u * v * v * d + (1 + 2 * v) * u * u * b - u * u * v * e
    else:  # the derivative of the cubic through values and slopes
        rise = np.diff(value)[:, np.newaxis] / width
        shape = (1 - 3 * u) * v * a + (1 - 3 * v) * u * b + 6 * u * v * rise
    interval, part = np.nonzero((shape[:, :-1] > 0.0) != (shape[:, 1:] > 0.0))
    begin = s[interval] + u[part] * width[interval, 0]
    return begin, s[interval] + u[part + 1] * width[interval, 0]


def roots(function: Callable[..., Array], begin: Array, end: Array, tolerance: float = 1e-15) -> Array:
    """Roots of a function in many intervals at once, by false position (Illinois) with bisection every third time.

    The function is given places and the indices of their intervals.

    An interval at whose ends the function has one sign gives the end where it is smaller: a slope that the polynomial
    between two points has changing its sign there, but the curve has not.
    """
    a, b = np.array(begin, float), np.array(end, float)
    if not len(a):
        return a
    every = np.arange(len(a))
    fa, fb = function(a, every), function(b, every)
    flat = (fa > 0.0) == (fb > 0.0)
    best = np.where(np.abs(fa) <= np.abs(fb), a, b)
    going = ~flat
    for turn in range(120):
        index = np.flatnonzero(going)
        if not len(index):
            break
        left, right, f, g = a[index], b[index], fa[index], fb[index]
        with np.errstate(all="ignore"):
            middle = left - f * (right - left) / (g - f)
        halved = (turn % 3 == 2) | ~((middle > left) & (middle < right))
        middle = np.where(halved, 0.5 * (left + right), middle)
        value = function(middle, index)
        upper = (value > 0.0) == (g > 0.0)
        best[index] = middle
        a[index], fa[index] = np.where(upper, left, middle), np.where(upper, np.where(halved, f, 0.5 * f), value)
        b[index], fb[index] = np.where(upper, middle, right), np.where(upper, value, np.where(halved, g, 0.5 * g))
        going[index] = (value != 0.0) & (b[index] - a[index] > tolerance)
    return best


def _bounds(arm: Arm, limits: ArrayLike | None) -> Array:
    found = arm.limits.position if limits is None else real_array(limits, "limits", finite=False)
    if found.shape != (arm.n, 2):
        raise InputError(f"limits: shape {found.shape}; ({arm.n}, 2) is accepted")
    if (found[:, 0] > found[:, 1]).any():
        raise InputError("limits: a lower limit is above the upper one; lower before upper is accepted")
    return found


@dataclass(frozen=True)
class _Hits:
    """Where joints are at stops, modulo whole turns for revolute joints: curve, fraction, joint from 0, which stop."""

    curve: Array
    s: Array
    joint: Array
    side: Array


def _hits(grids: Sequence[Grid], bundle: Bundle, bounds: Array) -> _Hits:
    """All of them on all curves, extrema that graze a stop included, by curve and fraction."""
    q, s = np.concatenate([grid.q for grid in grids]), np.concatenate([grid.s for grid in grids])
    begin = np.cumsum([0, *(len(grid.s) for grid in grids)])
    curve, revolute = np.repeat(np.arange(len(grids)), np.diff(begin)), bundle.held.revolute
    stops = bounds.ravel()  # of each joint the lower one and the upper one
    finite, turning = np.isfinite(stops)[:, np.newaxis], np.repeat(revolute, 2)
    turns = np.repeat(q.T, 2, axis=0)  # (2n, k): a row for each stop, since NumPy is fast along long last axes
    turns -= np.where(finite, stops[:, np.newaxis], 0.0)
    turns /= TURN
    cell = np.floor(turns)
    cell[~turning] = np.minimum(np.maximum(cell[~turning], -1.0), 0.0)
    cross = cell[:, 1:] != cell[:, :-1]
    cross &= finite
    cross[:, begin[1:-1] - 1] = False
    stop, row = np.unravel_index(np.flatnonzero(cross), cross.shape)
    aim = stops[stop] + TURN * np.where(turning[stop], np.maximum(cell[stop, row], cell[stop, row + 1]), 0.0)
    joint = stop // 2
    place = _reached(bundle, curve[row], s[row], s[row + 1], q[row, joint], q[row + 1, joint], joint, aim)
    edge = np.concatenate([grid.turns + start for grid, start in zip(grids, begin, strict=False)])
    near = turns[:, edge]
    apart = np.abs(near - np.where(turning[:, np.newaxis], np.rint(near), 0.0)) * TURN
    touched, touching = np.nonzero((apart <= 1e-13 * np.maximum(1.0, np.abs(q[edge].repeat(2, axis=1).T))) & finite)
    curve = np.concatenate([curve[row], curve[edge[touching]]])
    s, stop = np.concatenate([place, s[edge[touching]]]), np.concatenate([stop, touched])
    order = np.lexsort((s, curve))
    return _Hits(curve[order], s[order], *np.divmod(stop[order], 2))


def _reached(
    bundle: Bundle, curve: Array, low: Array, high: Array, first: Array, last: Array, joint: Array, aim: Array
) -> Array:
    """(m,): the fractions between low and high at which joints are at their aims, which they pass once in between.

    The root of the curve's own polynomial, then Newton's method on the curve; where that leaves the bracket or does not
    settle (beside an extremum), false position.
    """
    if not len(curve):
        return np.zeros(0)
    each, unit, length = np.arange(len(curve)), bundle.held.unit, bundle.length[curve]
    row, width, begin = bundle.between(curve, 0.5 * (low + high) * length)
    begin = (bundle.s[row] - bundle.offset[curve]) / length
    share, after = width / length, row + 1
    x = [part[rows, joint] * unit[joint] * scale for rows in (row, after) for part, scale in
         ((bundle.x, 1.0), (bundle.t, width), (bundle.k, width**2))]  # fmt: skip

    rise, middle = x[3] - x[0], 0.5 * (x[5] + x[2])
    powers = (
        *(x[0] - aim, x[1], 0.5 * x[2]),
        10.0 * rise - 6.0 * x[1] - 4.0 * x[4] + 0.5 * x[5] - 1.5 * x[2],
        -15.0 * rise + 8.0 * x[1] + 7.0 * x[4] + 1.5 * x[2] - x[5],
        6.0 * rise - 3.0 * (x[1] + x[4]) + middle - x[2],
    )
    first_u, last_u = (low - begin) / share, (high - begin) / share
    u = first_u + (last_u - first_u) * (first - aim) / (first - last)
    for _ in range(POLYNOMIAL):
        value, slope = powers[5], np.zeros(len(u))
        for power in powers[4::-1]:
            value, slope = value * u + power, slope * u + value
        with np.errstate(all="ignore"):
            ahead = u - value / slope
        u = np.where((ahead >= first_u) & (ahead <= last_u), ahead, u)
    s = np.minimum(np.maximum(begin + u * share, low), high)
    rising, settled = np.sign(last - first), np.zeros(len(s), bool)
    best: Array = s
    for _ in range(NEWTON):
        q, t = bundle.at(curve, best * length, 2)
        slope = np.abs(t[each, joint])
        with np.errstate(all="ignore"):
            step = (q[each, joint] - aim) / (rising * slope * unit[joint] * length)
        ahead = best - step
        inside = (ahead >= low) & (ahead <= high)
        # what a step leaves is of the order of its square over the slope
        settled = inside & (np.abs(step) <= np.where(slope > STEEP, SETTLED, LAST))
        best = np.where(inside, ahead, best)
        if settled.all():
            return best
    open_ = np.flatnonzero(~settled)

    def beyond(at: Array, which: Array) -> Array:
        k = open_[which]
        return np.asarray(bundle.at(curve[k], at * length[k])[0][np.arange(len(k)), joint[k]] - aim[k])

    best[open_] = roots(beyond, low[open_], high[open_])
    return best


def _turns(q: Array, bounds: Array, revolute: Array) -> Array:
    """(k, n, 2): least and greatest whole turns that bring q (k, n) within the bounds; empty where least is greater.

    Joints without limits have 0 and 0; a joint limited on one side only has the two nearest.
    """
    limited = np.isfinite(bounds).any(axis=1)
    with np.errstate(invalid="ignore"):
        low, high = np.ceil((bounds[:, 0] - q) / TURN), np.floor((bounds[:, 1] - q) / TURN)
    low, high = np.where(np.isfinite(low), low, high - 1.0), np.where(np.isfinite(high), high, low + 1.0)
    inside = (q >= bounds[:, 0]) & (q <= bounds[:, 1])
    low = np.where(limited, np.where(revolute, low, 0.0), 0.0)
    high = np.where(limited, np.where(revolute, high, np.where(inside, 0.0, -1.0)), 0.0)
    return np.stack([low, high], axis=-1).astype(int)


def crossings(
    arm: Arm, component: Component, task: str | None = None, limits: ArrayLike | None = None
) -> tuple[Crossing, ...]:
    """Every point of a curve at which a joint is at a stop (modulo whole turns), in order, and what happens there.

    Args:
        arm: whose curve.
        component: the curve.
        task: what is held on it; the arm's default task when absent.
        limits: (n, 2), infinite where there is none; the arm's own when absent.
    """
    bounds = _bounds(arm, limits)
    grids, bundle = _grids(arm, held_task(arm, task), [component])
    revolute = bundle.held.revolute
    hits = _hits(grids, bundle, bounds)
    apart = np.stack([hits.s - 1e-9, hits.s + 1e-9], axis=1)
    apart = apart if component.closed else np.clip(apart, 0.0, 1.0)
    allowed = _turns(component.at(apart), bounds, revolute)
    inside = allowed[..., 0] <= allowed[..., 1]
    found: dict[tuple[float, int, int], Crossing] = {}
    for k, (s, joint, side) in enumerate(zip(hits.s.tolist(), hits.joint.tolist(), hits.side.tolist(), strict=True)):
        before, after = inside[k, :, joint]
        word = "touches" if before == after else "leaves" if before else "enters"
        found.setdefault((s, joint, side), Crossing(s, joint + 1, bool(side), word))
    return tuple(found.values())


def feasible(
    arm: Arm, components: Sequence[Component], task: str | None = None, limits: ArrayLike | None = None
) -> tuple[Component, ...]:
    """What of the curves lies within the limits: whole loops and arcs, each with ``of`` and ``span``.

    Args:
        arm: whose curves.
        components: the curves, joints unlimited.
        task: what is held on them; the arm's default task when absent.
        limits: (n, 2), infinite where there is none; the arm's own when absent.

    Raises:
        InputError: limits of another shape, or so wide that they hold thousands of combinations of turns.

    Example:
        >>> import chainrule as cr
        >>> from chainrule.self_motions.continuation import trace
        >>> arm = cr.planar_3r(0.4, 0.35, 0.25)
        >>> loop = trace(arm, [0.5, 1.0, 1.0])
        >>> [first, second] = feasible(arm, [loop], limits=[(-3.0, 3.0), (-3.0, 3.0), (-1.0, 1.5)])
        >>> first.ends
        ('limit of joint 3 (upper)', 'limit of joint 3 (lower)')
        >>> first.box[2].round(9).tolist(), round((first.length + second.length) / loop.length, 3)
        ([-1.0, 1.5], 0.446)
    """
    task, bounds = held_task(arm, task), _bounds(arm, limits)
    revolute = np.array([kind == "R" for kind in arm.kinds])
    every: dict[int, list[Component]] = {}
    moving = []
    near = _meets(np.array([each.box for each in components]).reshape(-1, arm.n, 2), bounds, revolute)
    for index, each in enumerate(components):
        if len(each.q) < 2 or each.length == 0.0:
            every[index] = _point(each, bounds, revolute, index)
        elif near[index]:
            moving.append(index)
    if moving:
        curves = [components[index] for index in moving]
        grids, bundle = _grids(arm, task, curves)
        of, cuts = _cuts(_hits(grids, bundle, bounds), len(curves))
        first = np.searchsorted(of, np.arange(len(curves) + 1)).tolist()
        cell = np.flatnonzero(of[1:] == of[:-1])  # one lies between each cut and the next one of its curve
        curve, at = np.append(of, of[cell]), np.append(cuts, (cuts[cell + 1] + cuts[cell]) / 2.0)
        q = bundle.at(curve, at * bundle.length[curve])[0]
        allowed = _turns(q[len(cuts) :], bounds, revolute)
        least, most = ([tuple(turns) for turns in allowed[..., end].tolist()] for end in (0, 1))
        limited = np.isfinite(bounds).any(axis=1) & revolute
        parts = []
        for k, (each, begin, end) in enumerate(zip(curves, first, first[1:], strict=False)):
            mine = slice(begin - k, end - k - 1)
            parts.append(_parts(each, cuts[begin:end].tolist(), least[mine], most[mine], limited))
        ends = q[: len(cuts)]
        arcs = iter(_arcs(curves, grids, parts, first, ends, arm.manipulability(ends, task=task), moving))
        for each, index, those in zip(curves, moving, parts, strict=True):
            every[index] = [next(arcs) if part.ends else _whole(each, part, index) for part in those]
    return tuple(part for index in sorted(every) for part in every[index])


class Part(NamedTuple):
    """What limits leave of a curve in one piece.

    Attributes:
        begin, end: from where to where, fractions of a closed curve's length beyond 1 too.
        first, last: which of the curve's cuts these are, from 0 and counted on from round to round.
        turns: (n,) the whole turns that move it into the limits.
        ends: why it begins and ends there; empty for a curve left whole, which runs from 0 to 1.
    """

    begin: float
    end: float
    first: int
    last: int
    turns: tuple[int, ...]
    ends: tuple[str, ...]


def _grids(arm: Arm, task: str, curves: Sequence[Component]) -> tuple[list[Grid], Bundle]:
    """Places on each curve between which all joints rise or fall throughout, and the curves as one table."""
    first = curves[0].points
    held = first.held if isinstance(first, Dense) else Held(arm, task, curves[0].scale)
    tables = [_known(held, curve) for curve in curves]
    return [table.monotone for table in tables], Bundle.of(held, tables)


def _point(component: Component, bounds: Array, revolute: Array, index: int) -> list[Component]:
    """A single point, moved by whole turns into the limits; nothing where that is not possible."""
    allowed = _turns(component.q[:1], bounds, revolute)[0]
    if (allowed[:, 0] > allowed[:, 1]).any():
        return []
    shift = TURN * np.clip(0, allowed[:, 0], allowed[:, 1])
    return [replace(component, q=component.q + shift, box=component.box + shift[:, np.newaxis], of=index, points=None)]


def _meets(boxes: Array, bounds: Array, revolute: Array) -> Array:
    """(k,): whether each joint comes within its limits somewhere in a box (k, n, 2), whole turns apart if revolute."""
    with np.errstate(invalid="ignore"):
        low, high = bounds[:, 0] - boxes[..., 1], bounds[:, 1] - boxes[..., 0]  # a shift between these brings it there
        turned = np.floor(high / TURN + 1e-9) >= np.ceil(low / TURN - 1e-9)
    free = ~np.isfinite(bounds).all(axis=1)
    return np.asarray(np.where(revolute, free | turned, (low <= 1e-9) & (high >= -1e-9)).all(axis=-1))


def _cuts(hits: _Hits, curves: int) -> tuple[Array, Array]:
    """Of every curve 0, the places between, and 1: curve and fraction; places that are one only once."""
    inner = np.flatnonzero((hits.s > SAME) & (hits.s < 1.0 - SAME))
    curve, s = hits.curve[inner], hits.s[inner]
    new = np.ones(len(s), bool)
    new[1:] = (s[1:] - s[:-1] > SAME) | (curve[1:] != curve[:-1])
    every = np.arange(curves)
    of = np.concatenate([every, curve[new], every])
    cuts = np.concatenate([np.zeros(curves), s[new], np.ones(curves)])
    order = np.lexsort((cuts, of))
    return of[order], cuts[order]


#: The least and the most turns allowed in each cell of a curve (between neighbouring cuts).
Turns = list[tuple[int, ...]]
#: A cell, and turns of the joints.
State = tuple[int, tuple[int, ...]]


def _parts(component: Component, cuts: list[float], least: Turns, most: Turns, limited: Array) -> list[Part]:
    """What is left of one curve between its cuts, given the whole turns allowed in each cell."""
    winding = tuple((component.winding * limited).tolist() if component.closed else [0] * len(limited))
    found: list[Part] = []
    for (first, turns), length, before, after in _runs(least, most, winding, component.closed):
        last = first + length
        if before == (first, turns):  # round and round
            found.append(Part(0.0, 1.0, first, last, turns, ()))
            continue
        rounds, last_cut = divmod(last, len(least))
        ends = _reason(component, least, most, before, False), _reason(component, least, most, after, True)
        found.append(Part(cuts[first], cuts[last_cut] + rounds, first, last, turns, ends))
    return _distinct(found)


def _runs(
    least: Turns, most: Turns, winding: tuple[int, ...], closed: bool
) -> list[tuple[State, int, State | None, State | None]]:
    """Maximal runs through cells and turns: the first state, how many, and what comes before and after them.

    What comes after one that closes, and before it, is its first.
    """
    cells = len(least)
    waiting: dict[State, None] = {}
    for cell, (low, high) in enumerate(zip(least, most, strict=True)):
        if low == high:
            waiting[cell, low] = None
        elif not any(map(gt, low, high)):
            spans = [range(begin, end + 1) for begin, end in zip(low, high, strict=True)]
            if math.prod(map(len, spans)) * cells > MOST * 16:
                raise InputError("limits: they hold too many combinations of turns; limits of some turns are accepted")
            waiting.update(dict.fromkeys((cell, turns) for turns in product(*spans)))
    runs: list[tuple[State, int, State | None, State | None]] = []
    for heads in (True, False):  # arcs first; what is left goes round
        for state in list(waiting):
            if state not in waiting:
                continue
            before = _next(state, cells, winding, closed, -1) if heads else state
            if heads and before in waiting:
                continue
            length = 0
            following: State | None = state
            while following in waiting:
                del waiting[following]
                length += 1
                following = _next(following, cells, winding, closed, 1)
            runs.append((state, length, before, following))
    return runs


def _next(state: State, cells: int, winding: tuple[int, ...], closed: bool, step: int) -> State | None:
    cell, turns = state[0] + step, state[1]
    if 0 <= cell < cells:
        return cell, turns
    if not closed:
        return None
    if any(winding):
        turns = tuple(k + step * w for k, w in zip(turns, winding, strict=True))
    return cell % cells, turns


def _reason(component: Component, least: Turns, most: Turns, beyond: State | None, last: bool) -> str:
    """Why a run ends before a state, or its curve there."""
    if beyond is None:
        return component.ends[int(last)] if component.ends else "end of the curve"
    cell, turns = beyond
    for joint, (k, low, high) in enumerate(zip(turns, least[cell], most[cell], strict=True), 1):
        if not low <= k <= high:
            return limit_reason(joint, k > high)
    raise AssertionError("a run ends where the next cell is not allowed")


def _shifted(component: Component, begin: float, end: float, shift: Array) -> Callable[[Array], Array]:
    """The points of a part of a curve, moved by whole turns, by fractions of the part."""
    return lambda s: component.at(begin + (end - begin) * np.asarray(s)) + shift


def _whole(component: Component, part: Part, index: int) -> Component:
    """A curve left whole, moved by whole turns."""
    shift = TURN * np.array(part.turns, float)
    box = component.box + shift[:, np.newaxis]
    points = _shifted(component, 0.0, 1.0, shift)
    return replace(component, q=component.q + shift, box=box, of=index, points=points)


def _arcs(
    curves: Sequence[Component],
    grids: Sequence[Grid],
    parts: Sequence[Sequence[Part]],
    first: Sequence[int],
    ends: Array,
    heights: Array,
    indices: Sequence[int],
) -> list[Component]:
    """The parts of curves that are not whole as curves: of each the places of the grid in it, between its two ends.

    Args:
        curves: the curves.
        grids: of each, its places.
        parts: of each, what limits leave.
        first: of each, which of all cuts is its first one; and how many there are.
        ends: (cuts, n) the configurations at the cuts.
        heights: (cuts,) H there.
        indices: what ``of`` is for each curve.
    """
    arcs = [(k, part) for k, each in enumerate(parts) for part in each if part.ends]
    if not arcs:
        return []
    q, h = np.concatenate([*(grid.q for grid in grids), ends]), np.concatenate([*(grid.h for grid in grids), heights])
    places = [grid.s[:-1].tolist() for grid in grids]
    top = np.cumsum([0, *(len(grid.s) for grid in grids)]).tolist()
    pieces = []  # the first row of each, and how many; which arc's, and the round of the curve
    for arc, (k, (begin, end, one, other, _, _)) in enumerate(arcs):
        pieces.append((top[-1] + first[k] + one, 1, arc, 0))
        for r in range(math.ceil(end)):
            low, high = bisect_right(places[k], begin - r), bisect_left(places[k], end - r)
            pieces.append((top[k] + low, high - low, arc, r))
        cells = first[k + 1] - first[k] - 1
        rounds, other = divmod(other, cells) if curves[k].closed else (0, other)
        pieces.append((top[-1] + first[k] + other, 1, arc, rounds))
    start, count, arc_of, round_of = np.array(pieces).T
    shifts = TURN * np.array([part.turns for _, part in arcs], float)
    winding = np.array([curves[k].winding for k, _ in arcs])
    moved = shifts[arc_of] + (TURN * round_of)[:, np.newaxis] * winding[arc_of]
    after = np.cumsum(count)
    row = np.arange(after[-1]) + np.repeat(start - after + count, count)
    rows, values = q[row] + np.repeat(moved, count, axis=0), h[row]
    begins = (after - count)[np.searchsorted(arc_of, np.arange(len(arcs)))]
    boxes = np.stack([np.minimum.reduceat(rows, begins), np.maximum.reduceat(rows, begins)], axis=-1)
    lowest, highest = np.minimum.reduceat(values, begins).tolist(), np.maximum.reduceat(values, begins).tolist()
    stops = [*begins.tolist(), len(rows)]
    still = np.zeros_like(winding)
    return [
        Component(
            q=rows[stops[arc] : stops[arc + 1]],
            length=curves[k].length * (part.end - part.begin),
            closed=False,
            winding=still[arc],
            box=boxes[arc],
            manipulability=(lowest[arc], highest[arc]),
            residual=curves[k].residual,
            closure=math.nan,
            ends=part.ends,
            signs=curves[k].signs,
            of=indices[k],
            span=(part.begin, part.end),
            scale=curves[k].scale,
            points=_shifted(curves[k], part.begin, part.end, shifts[arc]),
        )
        for arc, (k, part) in enumerate(arcs)
    ]


def _distinct(parts: list[Part]) -> list[Part]:
    """Without the parts that lie in another one, whole turns apart."""
    kept: list[Part] = []
    for part in sorted(parts, key=lambda each: (each.begin - each.end, each.begin, sum(map(abs, each.turns)))):
        rounds = part.end - part.begin
        inside = any(
            not other.ends
            or other.end - other.begin >= 1.0
            or math.fmod(part.begin - other.begin + 1.0, 1.0) + rounds <= other.end - other.begin + 1e-12
            for other in kept
        )
        if not inside:
            kept.append(part)
    return sorted(kept, key=lambda each: each.begin)


def ranges(parts: Sequence[Component]) -> Array:
    """(n, 2): how far each joint moves on any of the curves and arcs; nan where there is none.

    Lewis and Maciejewski's measure of failure tolerance: where a joint may be locked with the target still in reach.
    """
    if not parts:
        return np.zeros((0, 2))
    boxes = np.stack([part.box for part in parts])
    return np.stack([boxes[..., 0].min(axis=0), boxes[..., 1].max(axis=0)], axis=-1)
