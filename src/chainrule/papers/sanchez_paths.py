"""The paths of E. A. Sanchez's thesis, and start postures on them: found ones, and random ones.

The thesis does not say where its arm starts. The start postures here were searched for: without a gain they meet a
singularity where the thesis' arm does. They prove that such starts exist, and nothing about others; random starts stand
beside them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.loading import load
from chainrule.redundancy.task_path import TaskPath

Array = NDArray[Any]

#: The start postures that were found, rad: A, B, C on the arc, E on the "ellipse", L on the line.
STARTS: Mapping[str, tuple[float, ...]] = {
    "A": (
        *(-1.873731004463, -1.816784929574, -2.610767475187, 2.197077859614),
        *(-1.287777812569, 1.434014115789, 1.595985198549, -2.679241147511),
    ),
    "B": (
        *(1.609813802256, -0.232299026129, -2.186365553699, -0.941491016391),
        *(0.461419321006, 0.278709676276, 2.319829892885, -1.050383487685),
    ),
    "C": (
        *(-1.53668959001, -2.920792707402, 3.022548791608, -1.664516093498),
        *(-0.927860291821, -1.06738746154, 0.87794418847, -1.607968946038),
    ),
    "E": (
        *(0.356683909626, -0.678181398008, 2.920983371925, -2.897123090552),
        *(-0.419316528329, -0.004363446089, -0.777582490943, -2.014754810326),
    ),
    "L": (
        *(2.347162607434, 0.690084145544, 0.108517563932, -2.403259386128),
        *(-3.111707060913, 0.311795321069, -0.359757615609, -2.250603423303),
    ),
}


def thesis_arc() -> TaskPath:
    """The arc of table 5.1: half a circle in the plane y = 0.05 m, in 2 s; the start posture's orientation is held.

    Example:
        >>> thesis_arc().sample([0.0, 1.0, 2.0], "position").held.round(12).tolist()
        [[0.25, 0.05, -0.25], [0.0, 0.05, 0.0], [-0.25, 0.05, -0.25]]
    """
    return TaskPath.arc((0.0, 0.05, -0.25), 0.25, y=(0.0, 0.0, 1.0), duration=2.0)


def thesis_ellipse() -> TaskPath:
    """The ellipse of table 5.1, which is a circle: once round in 2 s.

    Example:
        >>> thesis_ellipse().sample([0.0], "position").held.round(12).tolist()
        [[0.4, 0.6, -0.25]]
    """
    return TaskPath.circle((0.1, 0.6, -0.25), 0.3, y=(0.0, 0.0, 1.0), duration=2.0)


def thesis_line() -> TaskPath:
    """The line of table 5.1, in 2 s.

    Example:
        >>> thesis_line().sample([2.0], "position").held.tolist()
        [[0.5, 0.2, 0.5]]
    """
    return TaskPath.line((-0.5, 0.2, -0.5), (0.5, 0.2, 0.5), duration=2.0)


#: The thesis' paths, and the start postures that were found on each.
PATHS: Mapping[str, Callable[[], TaskPath]] = {"arc": thesis_arc, "ellipse": thesis_ellipse, "line": thesis_line}
ON: Mapping[str, str] = {"arc": "ABC", "ellipse": "E", "line": "L"}


@cache
def the_arm() -> Arm:
    """The thesis' arm, with assumed links."""
    return load("sanchez_8r")


def random_starts(path: str, count: int, seed: int = 0) -> Array:
    """Random postures (count, 8) of the thesis' arm whose tips are at the start of one of its paths.

    Joints are drawn evenly from all angles and brought to the point by Newton's method; the orientation is what comes
    of it.

    Example:
        >>> import chainrule as cr
        >>> q = random_starts("arc", 5)
        >>> cr.load("sanchez_8r").position(q).round(9)[:2].tolist()
        [[0.25, 0.05, -0.25], [0.25, 0.05, -0.25]]
    """
    arm = the_arm()
    point = PATHS[path]().sample([0.0], "position").held[0]
    q = np.random.default_rng(seed).uniform(-math.pi, math.pi, (2 * count, arm.n))
    for _ in range(60):
        away = point - arm.position(q)
        jacobian = arm.jacobian(q, task="position")
        turned = np.swapaxes(jacobian, 1, 2)
        change = (turned @ np.linalg.solve(jacobian @ turned + 1e-12 * np.eye(3), away[..., None]))[..., 0]
        q = q + change * np.minimum(1.0, 0.5 / np.maximum(np.abs(change).max(axis=1, keepdims=True), 1e-300))
    near = np.linalg.norm(arm.position(q) - point, axis=1) < 1e-10
    wrapped: Array = np.remainder(q[near] + math.pi, 2.0 * math.pi) - math.pi
    return wrapped[:count]
