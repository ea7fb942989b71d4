"""The same joint motion in the least time: what a run costs when its joints need not keep the path's own timing."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.redundancy.asked import orientation_of
from chainrule.redundancy.measure import measured
from chainrule.redundancy.result import Run
from chainrule.redundancy.task_path import TaskPath
from chainrule.scaling import JointPath, time_scaling

Array = NDArray[Any]

#: Cubic pieces of the joint path, at most.
PIECES = 100


def joint_path(run: Run, pieces: int = PIECES) -> JointPath:
    """The joint motion of a run by its own time: cubics through samples and rates, at most so many of them."""
    k = len(run.t) - 1
    knots = np.unique(np.round(np.linspace(0, k, min(k, pieces) + 1)).astype(int))
    t, q, rates = run.t[knots], run.q[knots], run.rates[knots]
    h = np.diff(t)[:, None]
    slope = np.diff(q, axis=0) / h
    second = (3.0 * slope - 2.0 * rates[:-1] - rates[1:]) / h
    third = (rates[:-1] + rates[1:] - 2.0 * slope) / h**2
    return JointPath(t, np.stack([q[:-1], rates[:-1], second, third], axis=1), t, False)


def fastest_run(run: Run, path: TaskPath, *, velocity: Any = None, acceleration: Any = None) -> Run:
    """The joint motion of a run in the least time from rest to rest, by TOPP-RA.

    The joints pass the same postures (between at most :data:`PIECES` samples the cubics through them and their rates)
    at other times; ``scale`` says how many times as fast as before, and may exceed 1.

    Args:
        run: a complete one whose task was not scaled.
        path: the path it followed.
        velocity: (n,) or one number, rad/s or m/s; the arm's limits when absent.
        acceleration: (n,) or one number, rad/s^2 or m/s^2, finite; likewise.

    Raises:
        InputError: another run; no acceleration limits; the package toppra is not installed.
        GenerationError: TOPP-RA found no timing.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> path = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
        >>> run = cr.track(arm, path, "best", gain=0.5, criterion="H", dt=0.01)
        >>> quick = cr.fastest_run(run, path, velocity=2.0, acceleration=10.0)
        >>> bool(quick.t[-1] < 1.0), quick.peak_rate < 2.0 + 1e-9, quick.worst_position_error < 1e-3
        (True, True, True)
    """
    if not isinstance(run, Run):
        raise InputError(f"run: {shown(run)}; a Run is accepted, such as chainrule.track gives")
    arm, task = run.arm, run.task
    if run.status != "complete" or len(run.t) < 2 or not (run.scale == 1.0).all():
        raise InputError(
            "run: it stopped early, or its task was scaled; a complete one in the path's own time is accepted"
        )
    if task != "position" and path.turning is None:
        path = path.holding(orientation_of(arm, run.q[0], path.dimension))
    fast = arm.limits.velocity if velocity is None else velocity
    push = arm.limits.acceleration if acceleration is None else acceleration
    if acceleration is None and not np.isfinite(push).all():
        raise InputError(f"{arm.name} has no acceleration limit for some of its joints; acceleration= gives it")
    found = time_scaling(joint_path(run), fast, push, method="toppra")
    count = max(1, math.ceil(found.duration / run.dt))
    t = np.linspace(0.0, found.duration, count + 1)
    q, rates, accelerations = found.sample(t)
    along, speed = found.along(t)
    speed = np.maximum(speed, 0.0)  # rounding, where it comes to rest
    held, slope = path.sample(np.clip(along, 0.0, path.duration), task)
    return measured(
        arm,
        task,
        method=f"{run.method}, least time",
        law=run.law,
        integrator="toppra",
        dt=found.duration / count,
        t=t,
        q=q,
        held=held,
        velocity=slope * speed[:, None],
        rates=rates,
        accelerations=accelerations,
        scale=speed,
    )
