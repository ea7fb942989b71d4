"""Self-motion curves of any arm with one joint more than its task has rows, followed by its generated kernel.

The kernel (``<arm>_continuation_<task>_follow``, made from templates/continuation.h.j2) follows a curve from a start to
its return without Python in the loop, and without jumping: every step stays in a ball in which the solutions are
proved to be one arc (:mod:`.tracing` says how and why). Lengths are accurate to about 1e-10 of themselves.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule import compile as compiling
from chainrule.arm import Arm, checked_arm
from chainrule.description import Model, Planar, Serial
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.self_motions import tracing
from chainrule.self_motions.result import ENDS, Component
from chainrule.self_motions.tracing import Settings, System, Trace, quintic

Array = NDArray[Any]

#: Points the kernel may write in one call, at first.
ROOM = 1 << 12
#: Corrections of points between those of the kernel.
CORRECTIONS = 3
#: Most corrections, and the largest one (rad), of :func:`project`; and the last one, below which it has arrived.
PROJECTIONS, STRIDE, ARRIVED = 60, 0.5, 1e-10
#: Half of the step of difference quotients, rad.
DIFFERENCE = 1e-5


def held_task(arm: Arm, task: str | None) -> str:
    """The task, checked to leave one joint free.

    Raises:
        InputError: an unknown task, or n - m is not 1.
    """
    task = checked_arm(arm).default_task if task is None else task
    if task not in arm.tasks:
        raise InputError(f"{arm.name}: there is no task {shown(task)}; {', '.join(arm.tasks)} are accepted")
    if arm.n - arm.tasks[task] != 1:
        fitting = [name for name, rows in arm.tasks.items() if arm.n - rows == 1]
        raise InputError(
            f"{arm.name}: the task '{task}' has {arm.tasks[task]} rows for {arm.n} joints: no curve; "
            + (f"{', '.join(fitting)} is accepted" if fitting else "an arm with one joint more than rows is accepted")
        )
    return task


def length_scale(scale: float) -> float:
    """The length that counts as one radian for prismatic joints, m, checked."""
    found = float(real_array(scale, "scale"))
    if not found > 0.0:
        raise InputError(f"scale: {shown(scale)}; a length above 0 is accepted")
    return found


def target_shape(arm: Arm, task: str) -> tuple[int, ...]:
    """The shape of a target: x, y(, z); x, alpha; x, y, alpha; or (4, 4)."""
    if isinstance(arm.description.geometry, Planar):
        return ({"position": 2, "x_alpha": 2, "pose": 3}[task],)
    return (3,) if task == "position" else (4, 4)


def target_of(arm: Arm, q: ArrayLike, task: str | None = None) -> Array:
    """What the tip does at the configurations q (..., n), as a target of the task.

    (..., 2) x, y; (..., 3) x, y, z; (..., 2) x, alpha; (..., 3) x, y, alpha; or a homogeneous matrix (..., 4, 4).

    Example:
        >>> import chainrule as cr
        >>> target_of(cr.planar_3r(1.0, 0.5, 0.25), [0.0, 0.0, 0.0], "x_alpha")
        array([1.75, 0.  ])
    """
    task = arm.default_task if task is None else task
    if task == "position":
        return arm.position(q)
    pose = arm.pose(q)
    if not isinstance(arm.description.geometry, Planar):
        return pose
    alpha = np.arctan2(pose[..., 1, 0], pose[..., 0, 0])
    rows = (0,) if task == "x_alpha" else (0, 1)
    return np.stack([*(pose[..., row, 2] for row in rows), alpha], axis=-1)


def checked_targets(arm: Arm, task: str, targets: ArrayLike) -> Array:
    """Targets as an array (..., target shape); poses are checked to be displacements.

    Raises:
        InputError: a wrong shape, or a rotation that is none.
    """
    found, shape = real_array(targets, "target"), target_shape(arm, task)
    if found.shape[-len(shape) :] != shape:
        raise InputError(f"target has shape {found.shape}; (..., {', '.join(map(str, shape))}) is accepted")
    if shape == (4, 4):
        rotation = found[..., :3, :3]
        wrong = np.abs(rotation @ np.swapaxes(rotation, -1, -2) - np.eye(3)).max(initial=0.0)
        if wrong > 1e-6 or (found.size and np.linalg.det(rotation).min() < 0.0):
            raise InputError(f"target: its rotation is off by {wrong:.3g}; a rotation to 1e-6 is accepted")
    return found


@dataclass(frozen=True)
class Held:
    """An arm's task as what is followed: scaled so that everything is in rad.

    Attributes:
        arm, task: whose.
        scale: m that count as one radian of a prismatic joint.
    """

    arm: Arm
    task: str
    scale: float = 1.0

    @cached_property
    def unit(self) -> Array:
        """(n,): 1 for revolute joints, the length scale for prismatic ones."""
        return np.asarray(np.where(self.revolute, 1.0, self.scale))

    @cached_property
    def revolute(self) -> Array:
        """(n,): which joints are revolute."""
        return np.array([kind == "R" for kind in self.arm.kinds])

    @cached_property
    def links(self) -> Array:
        """(n,): the constant distance from each joint to the next one, from the last one to the tip, m."""
        geometry = self.arm.description.geometry
        if isinstance(geometry, Planar):
            return np.array([abs(length) for length in geometry.lengths])
        assert isinstance(geometry, Serial)  # the orthogonal 3R arms have no task with two rows
        ahead = (*geometry.placements[1:], geometry.tool)
        return np.array([math.hypot(*transform.translation) for transform in ahead])

    @cached_property
    def size(self) -> float:
        """The length that rows are divided by, m: where the guard's balls are about largest."""
        return max(float(self.links.sum()) / 3.0, self.scale * 1e-3) or 1.0

    def evaluate(self, q: Array, target: Array) -> tuple[Array, Array, Array]:
        """Error (..., m), Jacobian (..., m, n) and null vector (..., n), in the task's units."""
        found: tuple[Array, Array, Array] = self.arm.evaluator(f"continuation_{self.task}")(
            q, target, *self._parameters
        )
        return found

    def bend(self, q: Array) -> tuple[Array, Array]:
        """Null vector (..., n) and its derivative along itself."""
        found: tuple[Array, Array] = self.arm.evaluator(f"continuation_{self.task}_bending")(q, *self._parameters)
        return found

    @cached_property
    def _parameters(self) -> tuple[Array, ...]:
        return (self.arm.parameters,) if self.arm.parameters.size else ()

    @cached_property
    def kernel(self) -> Kernel | None:
        """The compiled functions, or None where there is no compiler."""
        return kernel(self.arm.description.model, self.task)

    @cached_property
    def _numbers(self) -> tuple[Array, ...]:
        every = (self.arm.parameters, self.unit, self.links, [self.size])
        return tuple(np.ascontiguousarray(each, float) for each in every)

    @cached_property
    def _pointers(self) -> tuple[int, ...]:
        return tuple(each.ctypes.data for each in self._numbers)

    def inputs(self, targets: Array, starts: Array | None = None) -> _Inputs:
        """What the compiled functions are given: contiguous targets, one for all or one each, and starts."""
        parameters, *others = self._pointers
        shared = targets.ndim == len(target_shape(self.arm, self.task))
        return _Inputs(
            None if starts is None else starts.ctypes.data,
            targets.ctypes.data,
            0 if shared else targets[0].size,
            parameters if self.arm.parameters.size else None,
            0,
            *(entry for pointer in others for entry in (pointer, 0)),
        )

    def system(self, target: Array) -> System:
        """As the NumPy code follows it."""
        planar = isinstance(self.arm.description.geometry, Planar)
        return System(
            lambda q: self.evaluate(q, target),
            self.bend,
            self.revolute,
            self.unit,
            self.links,
            ({"x_alpha": 1}.get(self.task, 2) if planar else 3),
            self.task != "x_alpha",
            not planar and self.task == "pose",
            self.size,
        )

    def corrected(self, q: Array, target: Array, times: int = CORRECTIONS) -> Array:
        """Configurations (k, n) near the curve, moved onto it by Newton's method, each by its shortest way."""
        if self.kernel is not None:
            return self.placed(q, target, times)[0]
        q = np.array(q, float)
        for _ in range(times if len(q) else 0):
            q += self.step(q, target)
        return q

    def placed(self, q: Array, target: Array, times: int = CORRECTIONS) -> tuple[Array, Array]:
        """As :meth:`corrected`, and the unit tangents (k, n) of scaled joints there."""
        functions = self.kernel
        if functions is None:
            q = self.corrected(q, target, times)
            null = self.bend(q)[0] / self.unit
            return q, null / np.linalg.norm(null, axis=-1, keepdims=True)
        q, tangents = np.array(q, float, order="C"), np.empty(q.shape)
        aim = np.ascontiguousarray(target, float)
        functions.correct(len(q), ctypes.byref(self.inputs(aim)), times, q.ctypes.data, tangents.ctypes.data)
        return q, tangents

    def step(self, q: Array, target: Array) -> Array:
        """Newton's correction -J^+ e in scaled joints, in the joints' own units, (k, n); 0 where J has lost rank."""
        e, jacobian, _ = self.evaluate(q, target)
        columns, triangle = np.linalg.qr(np.swapaxes(jacobian * self.unit, -1, -2))
        diagonal = np.abs(np.diagonal(triangle, axis1=-2, axis2=-1))
        regular = (diagonal > 1e-14 * diagonal.max(axis=-1, keepdims=True)).all(axis=-1) & np.isfinite(e).all(axis=-1)
        triangle[~regular] = np.eye(triangle.shape[-1])
        y = np.linalg.solve(np.swapaxes(triangle, -1, -2), e[..., np.newaxis])
        step = -(columns @ y)[..., 0] * self.unit
        step[~regular] = 0.0
        return np.asarray(step)


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


# ---- the kernel ------------------------------------------------------------------------------------------------


class _Settings(ctypes.Structure):
    """chainrule_curve_settings."""

    _fields_ = (
        ("longest", ctypes.c_double),
        ("singular", ctypes.c_double),
        ("steps", ctypes.c_ssize_t),
        ("direction", ctypes.c_int),
    )


class _Inputs(ctypes.Structure):
    """chainrule_curve_inputs."""

    _fields_ = (
        ("starts", ctypes.c_void_p),
        ("targets", ctypes.c_void_p),
        ("target_step", ctypes.c_ssize_t),
        ("parameters", ctypes.c_void_p),
        ("parameter_step", ctypes.c_ssize_t),
        ("units", ctypes.c_void_p),
        ("unit_step", ctypes.c_ssize_t),
        ("links", ctypes.c_void_p),
        ("link_step", ctypes.c_ssize_t),
        ("sizes", ctypes.c_void_p),
        ("size_step", ctypes.c_ssize_t),
    )


class _Room(ctypes.Structure):
    """chainrule_curve_room."""

    _fields_ = (
        ("points", ctypes.c_void_p),
        ("knots", ctypes.c_void_p),
        ("most_points", ctypes.c_ssize_t),
        ("most_knots", ctypes.c_ssize_t),
    )


#: chainrule_curve_result.
_RESULT = np.dtype(
    {
        "names": [
            *("length", "closure", "contraction", "lowest", "highest"),
            *("points", "knots", "steps", "evaluations", "reason"),
        ],
        "formats": [float] * 5 + [np.intp] * 4 + [np.intc],
    },
    align=True,
)


@dataclass(frozen=True)
class Kernel:
    """The compiled functions of a model's arms: ``follow`` a curve, ``correct`` configurations near it."""

    follow: Any
    correct: Any


@cache
def kernel(model: Model, task: str) -> Kernel | None:
    """The compiled functions of a model's arms, or None where there is no compiler."""
    built = compiling.find(model, f"continuation_{task}")
    if built.library is None:
        return None
    library, name = ctypes.CDLL(str(built.library)), f"{built.prefix}_continuation_{task}"
    follow, correct = library[f"{name}_follow"], library[f"{name}_correct"]
    many, inputs = ctypes.c_ssize_t, ctypes.POINTER(_Inputs)
    follow.restype, correct.restype = many, None
    follow.argtypes = [
        *(many, inputs, ctypes.POINTER(_Settings), ctypes.POINTER(_Room)),
        *[ctypes.c_void_p] * 2,
    ]
    correct.argtypes = [many, inputs, ctypes.c_int, *[ctypes.c_void_p] * 2]
    return Kernel(follow, correct)


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
    boxes, results = np.empty((count, n, 2)), np.zeros(count, _RESULT)
    mine = _Settings(settings.longest, settings.singular, settings.steps, settings.direction)
    points, knots, done = np.empty((ROOM, 3 * n + 3)), np.empty((ROOM, 3)), 0
    while done < count:
        room = _Room(points.ctypes.data, knots.ctypes.data, len(points), len(knots))
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


def project(
    arm: Arm,
    q: ArrayLike,
    target: ArrayLike,
    task: str | None = None,
    *,
    scale: float = 1.0,
    extremal: ArrayLike | None = None,
) -> tuple[Array, Array]:
    """Configurations (k, n) moved to the target by damped Newton steps: where they arrive, and whether they do.

    Each step is -J^+ e in scaled joints, at most 0.5 rad long; for spatial orientations e has the rotation's vector
    (angle times axis). One that loses rank on its way, or does not arrive in 60 steps, counts as not arrived.

    Args:
        arm: an arm with n - m = 1.
        q: (k, n) where to begin.
        target: one target.
        task: what is held; the arm's default task when absent.
        scale: m that count as one radian of a prismatic joint.
        extremal: (k,) a joint for each configuration, from 1, that is to be extremal on the curve where it arrives:
            the null vector's component is one equation more.

    Returns:
        configurations (k, n), not wrapped, and (k,) whether each is on the target.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.load("panda")
        >>> aim = arm.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4])
        >>> found, arrived = project(arm, np.random.default_rng(0).uniform(-1.5, 1.5, (100, 7)), aim)
        >>> bool(np.abs(arm.pose(found[arrived]) - aim).max() < 1e-12)
        True
    """
    task = held_task(arm, task)
    held, aim = Held(arm, task, length_scale(scale)), checked_targets(arm, task, target)
    found = np.array(real_array(q, "q"))
    if found.ndim != 2 or found.shape[1] != arm.n:
        raise InputError(f"q has shape {found.shape}; (k, {arm.n}) is accepted")
    joints = None if extremal is None else np.asarray(extremal, int) - 1
    spatial = held.system(aim).spatial
    going = np.ones(len(found), bool)
    for _ in range(PROJECTIONS):
        index = np.flatnonzero(going)
        if not len(index):
            break
        step = _damped(held, found[index], aim, spatial, None if joints is None else joints[index])
        found[index] += step
        going[index] = np.linalg.norm(step / held.unit, axis=1) > ARRIVED
    error = np.abs(held.evaluate(found, aim)[0]).max(axis=1) if len(found) else np.zeros(0)
    near = ~going & (error < 1e-9 * max(held.size, 1.0))
    near |= error < 1e-14 * max(held.size, 1.0)  # at a singular posture steps go on after the error has vanished
    if joints is not None and len(found):
        near &= np.abs(_slope(held, found, joints)) < 1e-6
    if spatial and len(found):  # the skew part vanishes at half a turn too
        near &= np.einsum("kij,ij->k", arm.pose(found)[:, :3, :3], aim[:3, :3]) > 0.0
    return found, near


def _slope(held: Held, q: Array, joints: Array) -> Array:
    """(..., k): at configurations (..., k, n) the unit tangent's component of a joint each."""
    null = held.bend(q)[0] / held.unit
    with np.errstate(all="ignore"):
        found = null[..., np.arange(len(joints)), joints] / np.linalg.norm(null, axis=-1)
    return np.asarray(np.nan_to_num(found, nan=1.0))


def _damped(held: Held, q: Array, target: Array, spatial: bool, joints: Array | None = None) -> Array:
    e, jacobian, _ = held.evaluate(q, target)
    if spatial:
        from scipy.spatial.transform import Rotation

        e = e.copy()
        e[:, 3:] = Rotation.from_matrix(held.arm.pose(q)[:, :3, :3] @ target[:3, :3].T).as_rotvec()
    rows = np.where(np.arange(e.shape[1]) < held.system(target).positions, 1.0 / held.size, 1.0)
    scaled = jacobian * held.unit * rows[:, np.newaxis]
    e = e * rows
    if joints is not None:
        steps = (DIFFERENCE * np.eye(held.arm.n) * held.unit)[:, np.newaxis]
        slopes = _slope(held, np.concatenate([q + steps, q - steps, q[np.newaxis]]), joints)
        change = np.subtract(*np.split(slopes[:-1], 2)).T / (2.0 * DIFFERENCE)
        scaled = np.concatenate([scaled, change[:, np.newaxis]], axis=1)
        e = np.concatenate([e, slopes[-1][:, np.newaxis]], axis=1)
    gram = scaled @ np.swapaxes(scaled, -1, -2)
    error = np.linalg.norm(e, axis=1)
    damping = 1e-3 * np.minimum(error, 1.0) ** 2  # Levenberg and Marquardt: vanishes with the error's square
    damping = damping + 1e-15 * np.trace(gram, axis1=-2, axis2=-1) + 1e-300  # what rounding cannot tell from rank lost
    gram += damping[:, np.newaxis, np.newaxis] * np.eye(e.shape[1])
    y = np.linalg.solve(gram, e[..., np.newaxis])
    step = -(np.swapaxes(scaled, -1, -2) @ y)[..., 0]
    length = np.linalg.norm(step, axis=1, keepdims=True)
    return np.asarray(step * np.minimum(1.0, STRIDE / np.maximum(length, 1e-300)) * held.unit)


def start_points(arm: Arm, count: int, seed: int = 0, limits: Sequence[Any] | None = None) -> Array:
    """Random configurations (count, n) to begin from: angles all round, shifts within the limits or +-1 m."""
    bounds = arm.limits.position if limits is None else np.asarray(limits, float)
    low, high = np.full(arm.n, -math.pi), np.full(arm.n, math.pi)
    for i, kind in enumerate(arm.kinds):
        if kind == "P":
            low[i], high[i] = np.nan_to_num(bounds[i], posinf=1.0, neginf=-1.0)
    return np.random.default_rng(seed).uniform(low, high, (count, arm.n))
