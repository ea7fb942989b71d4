"""What is held along a self-motion: the task, its target, and both as what is followed, in rad throughout."""

from __future__ import annotations

import ctypes
import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.description import Planar, Serial
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.self_motions.kernel import CurveInputs, Kernel, kernel
from chainrule.self_motions.tracing import System

Array = NDArray[Any]

#: Corrections of points between those of the kernel.
CORRECTIONS = 3


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

    def inputs(self, targets: Array, starts: Array | None = None) -> CurveInputs:
        """What the compiled functions are given: contiguous targets, one for all or one each, and starts."""
        parameters, *others = self._pointers
        shared = targets.ndim == len(target_shape(self.arm, self.task))
        return CurveInputs(
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
