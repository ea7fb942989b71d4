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
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.self_motions.continuation import Held, held_task
from chainrule.self_motions.result import Component, limit_reason

Array = NDArray[Any]

TURN = 2.0 * math.pi
#: Points looked at on curves that bring none of their own.
SAMPLES = 512
#: Parts of an interval between points in which a slope is looked at for a change of sign.
PARTS = 8
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


@dataclass(frozen=True)
class Course:
    """The joints and H along a curve, between whose knots each of them rises or falls throughout.

    Attributes:
        component: the curve.
        s: (k,) fractions of its length, from 0 to 1.
        q: (k, n) joint values; h: (k,) manipulability.
        knots: for each joint, then for H, fractions (rising, from 0 to 1) and values, extrema included.
    """

    component: Component
    s: Array
    q: Array
    h: Array
    knots: tuple[tuple[Array, Array], ...]


def course(arm: Arm, component: Component, task: str | None = None) -> Course:
    """A curve with every extremum of each joint and of H."""
    held = Held(arm, held_task(arm, task), component.scale)
    own = getattr(component.points, "fractions", None)
    s = np.linspace(0.0, 1.0, SAMPLES + 1) if own is None else np.unique(np.clip(own, 0.0, 1.0))
    s[0], s[-1] = 0.0, 1.0
    q = component.at(s)
    sense = _sense(held, component, s, q)
    values, slopes, bends = _derivatives(held, component.length, sense, q)
    knots = []
    for i in range(arm.n + 1):
        bend = bends[:, i] if i < arm.n else None
        begin, end = _brackets(s, values[:, i], slopes[:, i], bend)

        def slope(at: Array, i: int = i) -> Array:
            return np.asarray(_derivatives(held, component.length, sense, component.at(at))[1][:, i])

        places = roots(slope, begin, end)
        found = _derivatives(held, component.length, sense, component.at(places))[0][:, i]
        where = np.concatenate([s, places])
        order = np.argsort(where, kind="stable")
        knots.append((where[order], np.concatenate([values[:, i], found])[order]))
    return Course(component, s, q, values[:, -1], tuple(knots))


def _sense(held: Held, component: Component, s: Array, q: Array) -> float:
    """Whether the curve runs along the null vector (1) or against it (-1)."""
    null = held.bend(q[:-1])[0] / held.unit
    return math.copysign(1.0, float(((q[1:] - q[:-1]) / held.unit * null).sum()))


def _derivatives(held: Held, length: float, sense: float, q: Array) -> tuple[Array, Array, Array]:
    """Values (k, n + 1) of the joints and H, their first derivatives by the fraction s, and the joints' second ones."""
    null, bending = held.bend(q)
    scaled, change = null / held.unit, bending / held.unit
    size = np.linalg.norm(scaled, axis=-1, keepdims=True)
    h = np.linalg.norm(null, axis=-1, keepdims=True)
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


def roots(function: Callable[[Array], Array], begin: Array, end: Array, tolerance: float = 1e-15) -> Array:
    """Roots of a function in many intervals at once, by false position (Illinois) with bisection every third time.

    An interval at whose ends the function has one sign gives the end where it is smaller: a slope that the polynomial
    between two points has changing its sign there, but the curve has not.
    """
    a, b = np.array(begin, float), np.array(end, float)
    if not len(a):
        return a
    fa, fb = function(a), function(b)
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
        value = function(middle)
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


def _hits(line: Course, joint: int, bound: float, revolute: bool) -> Array:
    """Fractions at which a joint is at a bound, modulo whole turns for revolute joints; grazing extrema included."""
    where, value = line.knots[joint]
    if not math.isfinite(bound):
        return np.zeros(0)
    if revolute:
        turns = np.arange(
            math.ceil((value.min() - bound) / TURN - 1e-9), math.floor((value.max() - bound) / TURN + 1e-9) + 1
        )
    else:
        turns = np.zeros(1)
    found = []
    for aim in bound + TURN * turns:
        above = value > aim
        j = np.flatnonzero(above[:-1] != above[1:])

        def beyond(at: Array, aim: float = aim) -> Array:
            return np.asarray(line.component.at(at)[:, joint] - aim)

        found += [roots(beyond, where[j], where[j + 1]), where[np.abs(value - aim) <= 1e-13 * max(1.0, abs(aim))]]
    return np.concatenate(found) if found else np.zeros(0)


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
    bounds, line = _bounds(arm, limits), course(arm, component, task)
    found = []
    for i, kind in enumerate(arm.kinds):
        for side in (0, 1):
            for s in np.unique(_hits(line, i, bounds[i, side], kind == "R")):
                apart = np.array([s - 1e-9, s + 1e-9])
                apart = apart if component.closed else np.clip(apart, 0.0, 1.0)
                q = component.at(apart)
                revolute = np.array([each == "R" for each in arm.kinds])
                allowed = _turns(q, bounds, revolute)[:, i]
                before, after = allowed[:, 0] <= allowed[:, 1]
                word = "touches" if before == after else "leaves" if before else "enters"
                found.append(Crossing(float(s), i + 1, bool(side), word))
    return tuple(sorted(found, key=lambda crossing: crossing.s))


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
    return tuple(part for index, each in enumerate(components) for part in _parts(arm, task, bounds, index, each))


def _parts(arm: Arm, task: str, bounds: Array, index: int, component: Component) -> list[Component]:
    revolute = np.array([kind == "R" for kind in arm.kinds])
    if len(component.q) < 2 or component.length == 0.0:
        allowed = _turns(component.q[:1], bounds, revolute)[0]
        if (allowed[:, 0] > allowed[:, 1]).any():
            return []
        shift = TURN * np.clip(0, allowed[:, 0], allowed[:, 1])
        return [
            replace(component, q=component.q + shift, box=component.box + shift[:, np.newaxis], of=index, points=None)
        ]
    line = course(arm, component, task)
    hits = [_hits(line, i, bound, bool(revolute[i])) for i in range(arm.n) for bound in bounds[i]]
    inner = np.unique(np.concatenate(hits))
    inner = inner[(inner > SAME) & (inner < 1.0 - SAME)]
    cuts = np.concatenate([[0.0], inner[np.diff(inner, prepend=0.0) > SAME], [1.0]])
    allowed = _turns(component.at((cuts[:-1] + cuts[1:]) / 2.0), bounds, revolute)
    limited = np.isfinite(bounds).any(axis=1) & revolute
    winding = np.where(limited, component.winding, 0) if component.closed else np.zeros(arm.n, int)
    runs = _runs(allowed, winding, component.closed)
    found = []
    for run in runs:
        shift = TURN * np.array(run[0][1], float)
        if run[0] == run[-1] and len(run) > 1:  # round and round
            whole = replace(component, q=component.q + shift, box=component.box + shift[:, np.newaxis], of=index)
            found.append(replace(whole, points=_shifted(component, 0.0, 1.0, shift)))
            continue
        begin = cuts[run[0][0]]
        end = begin + sum(cuts[cell + 1] - cuts[cell] for cell, _ in run)
        ends = tuple(_reason(component, allowed, winding, run, last) for last in (False, True))
        found.append(_arc(line, float(begin), float(end), shift, ends, index))
    return _distinct(found)


State = tuple[int, tuple[int, ...]]


def _runs(allowed: Array, winding: Array, closed: bool) -> list[list[State]]:
    """Maximal runs through cells (between crossings) and turns of the joints; one that closes repeats its first."""
    cells, waiting = len(allowed), {}
    for cell in range(cells):
        spans = [range(low, high + 1) for low, high in allowed[cell]]
        if math.prod(map(len, spans)) * cells > MOST * 16:
            raise InputError("limits: they hold too many combinations of turns; limits of some turns are accepted")
        waiting.update(dict.fromkeys((cell, turns) for turns in product(*spans)))
    runs = []
    for heads in (True, False):  # arcs first; what is left goes round
        for state in list(waiting):
            if state not in waiting or (heads and _next(state, cells, winding, closed, -1) in waiting):
                continue
            run: list[State] = []
            following: State | None = state
            while following is not None and following in waiting:
                del waiting[following]
                run.append(following)
                following = _next(following, cells, winding, closed, 1)
            runs.append([*run, state] if not heads else run)
    return runs


def _next(state: State, cells: int, winding: Array, closed: bool, step: int) -> State | None:
    cell, turns = state[0] + step, state[1]
    if 0 <= cell < cells:
        return cell, turns
    if not closed:
        return None
    return cell % cells, tuple(int(k + step * w) for k, w in zip(turns, winding, strict=True))


def _reason(component: Component, allowed: Array, winding: Array, run: list[State], last: bool) -> str:
    beyond = _next(run[-1 if last else 0], len(allowed), winding, component.closed, 1 if last else -1)
    if beyond is None:
        return component.ends[int(last)] if component.ends else "end of the curve"
    cell, turns = beyond
    for joint, (k, (low, high)) in enumerate(zip(turns, allowed[cell], strict=True), 1):
        if k > high:
            return limit_reason(joint, True)
        if k < low:
            return limit_reason(joint, False)
    raise AssertionError("a run ends where the next cell is not allowed")


def _shifted(component: Component, begin: float, end: float, shift: Array) -> Callable[[Array], Array]:
    """The points of a part of a curve, moved by whole turns, by fractions of the part."""
    return lambda s: component.at(begin + (end - begin) * np.asarray(s)) + shift


def _arc(line: Course, begin: float, end: float, shift: Array, ends: tuple[str, ...], index: int) -> Component:
    component = line.component
    rounds = range(math.floor(begin), math.ceil(end) + 1) if component.closed else range(1)
    inside = np.concatenate([line.s[:-1] + r for r in rounds])
    inside = inside[(inside > begin) & (inside < end)]
    q = component.at(np.concatenate([[begin], inside, [end]])) + shift
    box = np.stack([q.min(axis=0), q.max(axis=0)], axis=1)
    for i, (where, value) in enumerate(line.knots[:-1]):
        for r in rounds:
            known = value[(where + r > begin) & (where + r < end)] + TURN * r * component.winding[i] + shift[i]
            box[i] = min([box[i, 0], *known]), max([box[i, 1], *known])
    where, value = line.knots[-1]
    h = np.concatenate(
        [
            np.interp([begin % 1.0, end % 1.0], where, value),
            *(value[(where + r > begin) & (where + r < end)] for r in rounds),
        ]
    )
    return replace(
        component,
        q=q,
        length=component.length * (end - begin),
        closed=False,
        winding=np.zeros_like(component.winding),
        box=box,
        manipulability=(float(h.min()), float(h.max())),
        closure=math.nan,
        ends=ends,
        of=index,
        span=(begin, end),
        points=_shifted(component, begin, end, shift),
    )


def _distinct(parts: list[Component]) -> list[Component]:
    """Without the parts that lie in another one, whole turns apart."""
    kept: list[Component] = []
    for part in sorted(
        parts, key=lambda each: (-(each.span[1] - each.span[0]), each.span[0], float(np.abs(each.q[0]).sum()))
    ):
        begin, rounds = part.span[0], part.span[1] - part.span[0]
        inside = any(
            other.closed
            or other.span[1] - other.span[0] >= 1.0
            or math.fmod(begin - other.span[0] + 1.0, 1.0) + rounds <= other.span[1] - other.span[0] + 1e-12
            for other in kept
        )
        if not inside:
            kept.append(part)
    return sorted(kept, key=lambda each: each.span[0])


def ranges(parts: Sequence[Component]) -> Array:
    """(n, 2): how far each joint moves on any of the curves and arcs; nan where there is none.

    Lewis and Maciejewski's measure of failure tolerance: where a joint may be locked with the target still in reach.
    """
    if not parts:
        return np.zeros((0, 2))
    boxes = np.stack([part.box for part in parts])
    return np.stack([boxes[..., 0].min(axis=0), boxes[..., 1].max(axis=0)], axis=-1)
