"""How well an arm can move its tip: the largest manipulability, its map over two joints, where it comes near zero.

H = sqrt(det(J J^T)) (Yoshikawa) of the arm's task Jacobian J; evaluated by the generated functions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.search import Found, best_of, box, climb, maximise, samples

Array = NDArray[Any]
Slope = Callable[[Array], tuple[float, Array]]

#: Linear rows (velocities in m/s) of each task; the others are angular (rad/s).
_LINEAR_ROWS = {"planar": {"position": 2, "x_alpha": 1, "pose": 2}, "spatial": {"position": 3, "pose": 3}}
_POWERS = {0: "1", 1: "m", 2: "m²", 3: "m³"}


@dataclass(frozen=True)
class Unit:
    """The unit of H.

    Attributes:
        text: such as ``m²``; ``1`` for a pure number.
        mixed: whether H adds up terms of different units, so that its value depends on the unit of length.
    """

    text: str
    mixed: bool = False

    @property
    def suffix(self) -> str:
        """What is written after a number: a space and the unit, or nothing for a pure or mixed number."""
        return "" if self.mixed or self.text == "1" else f" {self.text}"


def unit(arm: Arm, task: str | None = None) -> Unit:
    """The unit of H, from the task's rows and the joints' kinds.

    A maximal minor that takes k prismatic columns is a product of a - k lengths, a the number of the task's linear
    rows. Where k can vary between the minors, H adds metres of different powers.

    Example:
        >>> from chainrule import load
        >>> unit(load("planar_3r")).text, unit(load("panda")).text
        ('m²', 'm³')
    """
    task = checked_task(arm, task)
    kind = "planar" if "x_alpha" in arm.tasks else "spatial"
    linear, rows = _LINEAR_ROWS[kind][task], arm.tasks[task]
    sliding, turning = arm.kinds.count("P"), arm.kinds.count("R")
    powers = [linear - k for k in range(max(0, rows - turning), min(sliding, linear) + 1)]
    if len(powers) <= 1:
        return Unit(_POWERS[powers[0] if powers else 0])
    return Unit(" and ".join(_POWERS[p] for p in sorted(powers)), mixed=True)


def checked_task(arm: Arm, task: str | None) -> str:
    """The task, or the arm's first with no more rows than joints.

    Raises:
        InputError: a task the arm has no maximal minors for.
    """
    known = arm.full_rank_tasks
    if task is None:
        task = arm.default_task if arm.default_task in known or not known else known[-1]
    if task not in known:
        raise InputError(
            f"{arm.name}: no manipulability of a task '{task}'; {', '.join(known) or 'none'} can be had "
            f"with {arm.n} joints"
        )
    return task


def depends_on(arm: Arm, task: str | None = None) -> tuple[int, ...]:
    """The joints (from 0) that H depends on, seen from a gradient that is exactly zero everywhere for the others.

    Example:
        >>> from chainrule import planar_3r
        >>> depends_on(planar_3r(1.0, 0.5, 0.25))
        (1, 2)
    """
    gradient = arm.manipulability_gradient(samples(arm, 200, seed=1), task=checked_task(arm, task))
    return tuple(int(i) for i in np.flatnonzero((gradient != 0.0).any(axis=0)))


def max_manipulability(arm: Arm, task: str | None = None) -> Found:
    """The largest H met inside the joint limits, with its configuration: 20,000 samples, the best 12 refined.

    Joints that H does not depend on are put in the middle of their range. A search, not a proof.

    Raises:
        InputError: a task with more rows than joints.

    Example:
        >>> from chainrule import planar_3r
        >>> best = max_manipulability(planar_3r(1.0, 0.5, 0.25))   # De Luca, bonus exercise: 0.79
        >>> round(best.value, 4), best.q.round(4)
        (0.7955, array([0.    , 1.4702, 0.2473]))
    """
    task = checked_task(arm, task)

    return maximise(arm, lambda q: arm.manipulability(q, task=task), _upward(arm, task), moving=depends_on(arm, task))


def min_manipulability(arm: Arm, task: str | None = None) -> Found:
    """The smallest H met inside the joint limits, by descent on H^2: where a search came nearest to a singularity.

    Raises:
        InputError: a task with more rows than joints.
    """
    task = checked_task(arm, task)
    found = maximise(
        arm, lambda q: -arm.manipulability(q, task=task), _downward(arm, task), moving=depends_on(arm, task)
    )
    return Found(float(arm.manipulability(found.q, task=task)), found.q, found.others)


def _upward(arm: Arm, task: str) -> Slope:
    """H and its gradient."""

    def slope(q: Array) -> tuple[float, Array]:
        return float(arm.manipulability(q, task=task)), arm.manipulability_gradient(q, task=task)

    return slope


def _downward(arm: Arm, task: str) -> Slope:
    """-H^2 and its gradient: smooth where H is zero."""

    def slope(q: Array) -> tuple[float, Array]:
        height = float(arm.manipulability(q, task=task))
        return -(height * height), -2.0 * height * arm.manipulability_gradient(q, task=task)

    return slope


@dataclass(frozen=True)
class ManipulabilityMap:
    """H over two joints, the others held.

    Attributes:
        task: the task.
        joints: the two joints, from 0.
        first, second: (k,) values of the two joints, rad or m.
        H: (k, k), ``H[i, j]`` at ``first[i]``, ``second[j]``.
        q: (n,) the posture: the others are held at its entries.
        maximum: the largest H of this map, refined off the grid, and where.
        minimum: the smallest H of this map, refined likewise by descent on H^2, and where.
        unit: the unit of H.
    """

    task: str
    joints: tuple[int, int]
    first: Array
    second: Array
    H: Array
    q: Array
    maximum: Found
    minimum: Found
    unit: Unit

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists, without the grid."""
        return {
            "task": self.task,
            "joints": [j + 1 for j in self.joints],
            "q": self.q.tolist(),
            "unit": self.unit.text,
            "maximum": {"H": self.maximum.value, "q": self.maximum.q.tolist()},
            "minimum": {"H": self.minimum.value, "q": self.minimum.q.tolist()},
        }


def manipulability_map(
    arm: Arm, task: str | None = None, *, joints: tuple[int, int] | None = None, q: Any = None, size: int = 121
) -> ManipulabilityMap:
    """H over a grid of two joints inside the joint limits, and the map's maximum (grid, then refined).

    Args:
        arm: the arm, of two joints or more.
        task: the task.
        joints: two joints, from 0; the pair over which H varies most when absent.
        q: (n,) the posture that holds the others; that of the largest H when absent.
        size: points in each direction.

    Raises:
        InputError: a task with more rows than joints, joints that do not exist, fewer than two joints.
    """
    task = checked_task(arm, task)
    posture = max_manipulability(arm, task).q if q is None else np.array(q, float)
    if posture.shape != (arm.n,):
        raise InputError(f"{arm.name}: q has shape {posture.shape}; ({arm.n},) is accepted")
    pair = liveliest_pair(arm, task, posture) if joints is None else joints
    if len(set(pair)) != 2 or not all(0 <= j < arm.n for j in pair):
        raise InputError(f"{arm.name}: joints {pair}; two different ones of 0 to {arm.n - 1} are accepted")
    first, second, grid = _grid(arm, pair, posture, size)
    height = arm.manipulability(grid, task=task)

    ranges, flat = box(arm), grid.reshape(-1, arm.n)
    upward, downward = _upward(arm, task), _downward(arm, task)
    high = [climb(upward, start, pair, ranges) for start in _peaks(height, grid)]
    low = [climb(downward, flat[k], pair, ranges) for k in np.argsort(height, axis=None, kind="stable")[:4]]
    best, least = best_of(arm, high, upward, pair), best_of(arm, low, downward, pair)
    least = Found(float(arm.manipulability(least.q, task=task)), least.q, least.others)
    return ManipulabilityMap(task, pair, first, second, height, posture, best, least, unit(arm, task))


def _grid(arm: Arm, pair: tuple[int, int], posture: Array, size: int) -> tuple[Array, Array, Array]:
    ranges = box(arm)
    first, second = (np.linspace(ranges[j, 0], ranges[j, 1], size) for j in pair)
    grid = np.tile(posture, (size, size, 1))
    grid[..., pair[0]] = first[:, None]
    grid[..., pair[1]] = second[None, :]
    return first, second, grid


def _peaks(height: Array, grid: Array) -> list[Array]:
    """Grid points not lower than their neighbours, the highest twelve."""
    padded = np.pad(height, 1, constant_values=-np.inf)
    rows, columns = height.shape
    around = [padded[1 + i : 1 + i + rows, 1 + j : 1 + j + columns] for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
    peaks = np.argwhere(height >= np.max(around, axis=0))  # never empty: the largest of all is among them
    peaks = peaks[np.argsort(-height[tuple(peaks.T)], kind="stable")[:12]]
    return [grid[tuple(peak)] for peak in peaks]


def liveliest_pair(arm: Arm, task: str, q: Array) -> tuple[int, int]:
    """The two joints over which H varies most (standard deviation on a coarse grid), the others held at ``q``."""
    if arm.n < 2:
        raise InputError(f"{arm.name}: one joint; a map over two joints needs two")
    live = depends_on(arm, task)
    if len(live) < 2:  # H is constant, or depends on one joint: any pair with it shows all there is
        live = (
            tuple(sorted({*live, *(j for j in range(arm.n - 1, -1, -1))}))
            if not live
            else (*live, *(j for j in range(arm.n) if j not in live))
        )
        first, second = sorted(live[:2])
        return first, second
    spread = {
        pair: float(arm.manipulability(_grid(arm, pair, q, 31)[2], task=task).std()) for pair in combinations(live, 2)
    }
    top = max(spread.values())
    return next(pair for pair in spread if spread[pair] >= top * (1 - 1e-9))
