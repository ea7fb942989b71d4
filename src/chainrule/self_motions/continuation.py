"""Self-motion curves of any arm with one joint more than its task has rows, followed by its generated kernel.

The kernel (``<arm>_continuation_<task>_follow``, made from templates/continuation.h.j2) follows a curve from a start to
its return without Python in the loop, and without jumping: every step stays in a ball in which the solutions are
proved to be one arc (:mod:`.tracing` says how and why). Lengths are accurate to about 1e-10 of themselves.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.self_motions import tracing
from chainrule.self_motions.held import Held, checked_targets, held_task, length_scale, target_of, target_shape
from chainrule.self_motions.kernel import CURVE_RESULT, CurveRoom, CurveSettings
from chainrule.self_motions.result import ENDS, Component
from chainrule.self_motions.tracing import Settings, Trace, quintic

Array = NDArray[Any]

#: Points the kernel may write in one call, at first.
ROOM = 1 << 12


@dataclass(frozen=True)
class Grid:
    """Places on a curve between which each joint and H rises or falls throughout.

    Attributes:
        s: (k,) fractions of the length, rising from 0 to 1.
        q: (k, n) joint values; h: (k,) manipulability.
        turns: which of the places are extrema.
    """

    s: Array
    q: Array
    h: Array
    turns: Array


@dataclass(frozen=True)
class Dense:
    """A followed curve as a function of fractions of its length: quintics between its points, then Newton's method.

    Attributes:
        held: the arm and task.
        target: what is held.
        x, t, k: (rows, n) scaled joints, their first and second derivative by the length.
        s: (rows,) length so far, from 0.
        h: (rows,) manipulability; None where it was not computed.
        knots: (e, 3) extrema: of which joint from 0 (n: of H), at which length, and the value; None where not known.
        source: the curve that this one is an image of, with the signs (n,) and the shift (n,) that make it.
    """

    held: Held
    target: Array
    x: Array
    t: Array
    k: Array
    s: Array
    h: Array | None = None
    knots: Array | None = None
    source: tuple[Dense, Array, Array] | None = None

    @property
    def fractions(self) -> Array:
        """Where the stored points lie, as fractions of the length."""
        return self.s / self.s[-1] if self.s[-1] > 0.0 else np.zeros_like(self.s)

    @cached_property
    def monotone(self) -> Grid:
        """The stored points with every extremum of a joint or of H between them."""
        if self.source is not None:
            grid, sign, shift = self.source[0].monotone, *self.source[1:]
            return Grid(grid.s, grid.q * sign + shift, grid.h, grid.turns)
        assert self.h is not None and self.knots is not None
        joint, at, value = self.knots.T
        n, joint = self.x.shape[1], joint.astype(int)
        q = self(at / self.s[-1]) if len(at) else np.zeros((0, n))
        h = self.held.arm.manipulability(q, task=self.held.task)
        own = joint < n
        q[np.flatnonzero(own), joint[own]] = value[own]
        h[~own] = value[~own]
        places = np.concatenate([self.s, at])
        order = np.argsort(places, kind="stable")
        s = places[order] / self.s[-1]
        s[0], s[-1] = 0.0, 1.0
        q = np.concatenate([self.x * self.held.unit, q])[order]
        return Grid(s, q, np.concatenate([self.h, h])[order], np.flatnonzero(order >= len(self.s)))

    def __call__(self, fractions: Array) -> Array:
        """(..., n): the points at fractions (...) of the length, from 0 to 1."""
        fractions = np.asarray(fractions, float)
        if len(self.s) < 2:
            return np.broadcast_to(self.x[0] * self.held.unit, (*fractions.shape, len(self.held.unit))).copy()
        at = (fractions * self.s[-1]).ravel()
        j = np.minimum(np.maximum(np.searchsorted(self.s, at, side="right") - 1, 0), len(self.s) - 2)
        width = self.s[j + 1] - self.s[j]
        u = ((at - self.s[j]) / width)[:, np.newaxis]
        width = width[:, np.newaxis]
        x = quintic(
            (self.x[j], self.t[j] * width, self.k[j] * width**2),
            (self.x[j + 1], self.t[j + 1] * width, self.k[j + 1] * width**2),
            u,
        )
        q = self.held.corrected(x * self.held.unit, self.target)
        ends = (at <= 0.0, at >= self.s[-1])
        q[ends[0]], q[ends[1]] = self.x[0] * self.held.unit, self.x[-1] * self.held.unit
        return q.reshape(*fractions.shape, len(self.held.unit))


# ---- following -------------------------------------------------------------------------------------------------


def traces(held: Held, starts: Array, targets: Array, settings: Settings, *, compiled: bool = True) -> Iterator[Trace]:
    """Follow the curve through each start (k, n) at its target (k, ...), or all at one target.

    Args:
        held: the arm, task and length scale.
        starts: near the curves; they are moved onto them first.
        targets: one for all, or one each.
        settings: direction and where to end.
        compiled: whether to use the kernel where there is one (else the NumPy code, about 500 times slower).
    """
    starts = np.ascontiguousarray(starts, float)
    shared = targets.ndim == len(target_shape(held.arm, held.task))
    functions = held.kernel if compiled else None
    if functions is None:
        for k, start in enumerate(starts):
            yield tracing.Follower(held.system(targets if shared else targets[k]), settings).follow(start / held.unit)
        return
    n, count = held.arm.n, len(starts)
    targets = np.ascontiguousarray(targets, float)
    boxes, results = np.empty((count, n, 2)), np.zeros(count, CURVE_RESULT)
    mine = CurveSettings(settings.longest, settings.singular, settings.steps, settings.direction)
    points, knots, done = np.empty((ROOM, 3 * n + 3)), np.empty((ROOM, 3)), 0
    while done < count:
        room = CurveRoom(points.ctypes.data, knots.ctypes.data, len(points), len(knots))
        inputs = held.inputs(targets if shared else targets[done:], starts[done:])
        taken = functions.follow(
            count - done, ctypes.byref(inputs), ctypes.byref(mine), ctypes.byref(room), boxes[done:].ctypes.data,
            results[done:].ctypes.data,
        )  # fmt: skip
        if taken == 0:  # not even one: more room
            points, knots = np.empty((2 * len(points), 3 * n + 3)), np.empty((2 * len(knots), 3))
            continue
        row = knot = 0
        for k in range(done, done + taken):
            rows, edges = row + int(results[k]["points"]), knot + int(results[k]["knots"])
            yield _trace(held, starts[k], points[row:rows].copy(), knots[knot:edges].copy(), boxes[k], results[k])
            row, knot = rows, edges
        done += taken


def _trace(held: Held, start: Array, rows: Array, knots: Array, box: Array, result: Any) -> Trace:
    n, reason = held.arm.n, tracing.REASONS[result["reason"]]
    span = (float(result["lowest"]), float(result["highest"]))
    if not len(rows):  # nothing but the start
        h = float(np.linalg.norm(held.bend(start)[0]))
        rows = np.concatenate([start / held.unit, np.zeros(2 * n + 1), [h, 0.0]])[np.newaxis]
        box, span = np.stack([start, start], axis=1), (h, h)
    x = rows[:, :n]
    turns = np.rint((x[-1] - x[0]) / (2.0 * math.pi)) if reason == "closed" else np.zeros(n)
    return Trace(
        x * held.unit,
        rows[:, n : 2 * n],
        rows[:, 2 * n : 3 * n],
        rows[:, 3 * n],
        rows[:, 3 * n + 1],
        rows[:, 3 * n + 2],
        knots,
        box.copy(),
        span,
        reason,
        int(result["steps"]),
        int(result["evaluations"]),
        float(result["closure"]),
        np.where(held.revolute, turns, 0.0).astype(int),
        float(result["contraction"]),
    )


# ---- components ------------------------------------------------------------------------------------------------


def trace(
    arm: Arm,
    q0: ArrayLike,
    task: str | None = None,
    *,
    target: ArrayLike | None = None,
    scale: float = 1.0,
    longest: float = 1e3,
    steps: int = 1_000_000,
    compiled: bool = True,
) -> Component:
    """The self-motion curve through a configuration, joints unlimited.

    Args:
        arm: an arm with n - m = 1.
        q0: (n,) a configuration.
        task: what is held; the arm's default task when absent.
        target: what it is held at, ``q0`` being moved onto the curve; where the tip is at ``q0`` when absent.
        scale: m that count as one radian of a prismatic joint.
        longest: greatest length to follow, either way.
        steps: greatest number of certified steps, either way.
        compiled: False for the NumPy code although there is a kernel.

    Raises:
        InputError: n - m is not 1, a wrong shape, or a start from which Newton's method does not reach the target.

    Example:
        >>> import chainrule as cr
        >>> curve = trace(cr.planar_3r(0.4, 0.35, 0.25), [0.5, 1.0, 1.0])
        >>> curve.closed, round(curve.length, 6), curve.winding.tolist()
        (True, 12.888087, [0, 0, 0])
    """
    start = real_array(q0, "q0")
    if start.shape != (arm.n,):
        raise InputError(f"q0 has shape {start.shape}; ({arm.n},) is accepted")
    found = trace_many(
        arm, start[np.newaxis], task, targets=target, scale=scale, longest=longest, steps=steps, compiled=compiled
    )
    return found[0]


def trace_many(
    arm: Arm,
    starts: ArrayLike,
    task: str | None = None,
    *,
    targets: ArrayLike | None = None,
    scale: float = 1.0,
    longest: float = 1e3,
    steps: int = 1_000_000,
    compiled: bool = True,
) -> tuple[Component, ...]:
    """The self-motion curve through each of many configurations (k, n), in one call of the kernel.

    Args: as for :func:`trace`; ``targets`` is one target for all, or one each.
    """
    task = held_task(arm, task)
    begin = real_array(starts, "starts")
    if begin.ndim != 2 or begin.shape[1] != arm.n:
        raise InputError(f"starts has shape {begin.shape}; (k, {arm.n}) is accepted")
    held = Held(arm, task, length_scale(scale))
    wanted = target_of(arm, begin, task) if targets is None else checked_targets(arm, task, targets)
    shared = wanted.ndim == len(target_shape(arm, task))
    if not shared and len(wanted) != len(begin):
        raise InputError(f"targets: {len(wanted)} for {len(begin)} starts; one for all or one each is accepted")
    return followed(held, begin, wanted, Settings(1, longest, steps), compiled=compiled)


def followed(
    held: Held, starts: Array, targets: Array, settings: Settings, *, compiled: bool = True
) -> tuple[Component, ...]:
    """As :func:`trace_many`, of what is checked already."""
    shared = targets.ndim == len(target_shape(held.arm, held.task))
    forward = list(traces(held, starts, targets, settings, compiled=compiled))
    lost = [k for k, each in enumerate(forward) if each.reason == "start"]
    if lost:
        raise InputError(
            f"start {lost[0]}: Newton's method does not lead from it to the target; a start near it is accepted"
        )
    open_ones = [k for k, each in enumerate(forward) if each.reason != "closed"]
    backward: dict[int, Trace] = {}
    if open_ones:
        again = replace(settings, direction=-1)
        aims = targets if shared else targets[open_ones]
        backward = dict(zip(open_ones, traces(held, starts[open_ones], aims, again, compiled=compiled), strict=True))
    return tuple(
        component(held, each, backward.get(k), targets if shared else targets[k]) for k, each in enumerate(forward)
    )


def component(held: Held, forward: Trace, backward: Trace | None, target: Array) -> Component:
    """A traced curve (with what was traced against the null vector, where it does not close) as a result."""
    whole = forward if backward is None else _joined(_reversed(backward), forward)
    closed = backward is None
    error = held.evaluate(whole.q, target)[0]
    return Component(
        q=whole.q,
        length=float(whole.s[-1]),
        closed=closed,
        winding=forward.winding,
        box=whole.box,
        manipulability=whole.span,
        residual=float(np.abs(error).max()),
        closure=forward.closure,
        ends=() if backward is None else (ENDS[backward.reason], ENDS[forward.reason]),
        signs=kept_signs(whole.box, held.revolute),
        scale=held.scale,
        points=Dense(held, target, whole.q / held.unit, whole.tangent, whole.bend, whole.s, whole.h, whole.knots),
    )


def _joined(first: Trace, last: Trace) -> Trace:
    """Two traces, the last from where the first ends."""
    offset = first.s[-1] if len(first.s) else 0.0

    def both(a: Array, b: Array) -> Array:
        return np.concatenate([a, b[1:]])

    low, high = np.minimum(first.box, last.box), np.maximum(first.box, last.box)
    return replace(
        last,
        q=both(first.q, last.q),
        tangent=both(first.tangent, last.tangent),
        bend=both(first.bend, last.bend),
        s=both(first.s, last.s + offset),
        h=both(first.h, last.h),
        slope=both(first.slope, last.slope),
        knots=np.concatenate([first.knots, last.knots + np.array([0.0, offset, 0.0])]),
        box=np.stack([low[:, 0], high[:, 1]], axis=1),
        span=(min(first.span[0], last.span[0]), max(first.span[1], last.span[1])),
    )


def _reversed(trace: Trace) -> Trace:
    """The same curve, run the other way: from its end to its start."""
    return replace(
        trace,
        q=trace.q[::-1],
        tangent=-trace.tangent[::-1],
        bend=trace.bend[::-1],
        s=trace.s[-1] - trace.s[::-1],
        knots=np.stack([trace.knots[:, 0], trace.s[-1] - trace.knots[:, 1], trace.knots[:, 2]], axis=1),
        h=trace.h[::-1],
        slope=-trace.slope[::-1],
    )


def kept_signs(box: Array, revolute: Array) -> dict[str, int]:
    """Signs of sin q_i (of q_i itself for prismatic joints) that hold in the whole range of a joint."""
    found = {}
    for i, ((low, high), turning) in enumerate(zip(box.tolist(), revolute.tolist(), strict=True), 1):
        half = math.floor(low / math.pi) if turning else (0 if low > 0.0 else -1)
        inside = low > half * math.pi and high < (half + 1) * math.pi if turning else low > 0.0 or high < 0.0
        if inside:
            found[f"q{i}"] = 1 if half % 2 == 0 else -1
    return found
