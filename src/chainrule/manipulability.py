"""How well an arm can move its tip: the largest manipulability, its map over two joints, where it comes near zero.

H = sqrt(det(J J^T)) (Yoshikawa) of the arm's task Jacobian J; evaluated by the generated functions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array, whole_number
from chainrule.search import FREE_TRAVEL, Found, best_of, box, climb, maximise, samples, turns_freely

if TYPE_CHECKING:
    from chainrule.certificate import Certificate

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
    known = checked_arm(arm).full_rank_tasks
    if task is None:
        task = arm.default_task if arm.default_task in known or not known else known[-1]
    if task not in known:
        raise InputError(
            f"{arm.name}: no manipulability of a task {shown(task)}; {', '.join(known) or 'none'} can be had "
            f"with {arm.n} joint{'s' if arm.n > 1 else ''}"
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


@dataclass(frozen=True, eq=False)
class Maximum:
    """The largest manipulability. It unpacks: ``H, q = max_manipulability(arm)``.

    Attributes:
        value: H at ``q``, in :func:`unit`; infinite where H grows without end along a prismatic joint without limits.
        q: (n,) rad or m, inside the joint limits.
        others: (k, n) further configurations with the same H (to a relative 1e-12); of a ridge, a mirror image at most.
        bound: H exceeds this nowhere inside the joint limits; infinite where no bound is known.
        proved: whether the bound is the value, to a relative 1e-10: the maximum is global.
        complete: whether it is proved that H is as large at ``q`` and ``others`` only, and where it is the same all the
            same: along joints, and combinations of joints, that H does not depend on.
        how: what was proved, and how, in one sentence.
    """

    value: float
    q: Array
    others: Array
    bound: float
    proved: bool
    complete: bool
    how: str

    def __iter__(self) -> Iterator[Any]:
        return iter((self.value, self.q))

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists; null for what is not finite."""
        return {
            "H": self.value if math.isfinite(self.value) else None,
            "q": self.q.tolist(),
            "others": self.others.tolist(),
            "bound": self.bound if math.isfinite(self.bound) else None,
            "proved": self.proved,
            "complete": self.complete,
            "how": self.how,
        }


def max_manipulability(
    arm: Arm, task: str | None = None, *, budget: int | None = None, progress: Callable[[str], None] = lambda line: None
) -> Maximum:
    """The largest H inside the joint limits, with a proof that it is global where one can be had.

    H^2 is a finite sum of waves in the angles; branch and bound over boxes of angles leaves only neighbourhoods of the
    maxima, over which H^2 is proved to be concave (:mod:`chainrule.branch_and_bound`). That settles planar arms of any
    lengths and joints, orthogonal 3R arms, and many arms of six joints; where it does not, ``bound`` is still certain,
    and ``proved`` is False. Arms whose H depends on more than about five angles (planar: seven) and spatial arms with
    prismatic joints are searched (20,000 samples, the best 12 refined).

    Args:
        arm: the arm. Joints that H does not depend on are put in the middle of their range.
        task: the task; the arm's own when absent.
        budget: how many boxes may be examined; enough for some seconds when absent.
        progress: called with a line now and then.

    Raises:
        InputError: a task with more rows than joints, a budget below 1, an H beyond the range of doubles.

    Example:
        >>> from chainrule import planar_3r
        >>> best = max_manipulability(planar_3r(1.0, 0.5, 0.25))   # De Luca, bonus exercise: 0.79
        >>> round(best.value, 10), best.q.round(7)
        (0.7955370838, array([0.       , 1.4702184, 0.2473498]))
        >>> best.proved, best.others.round(7)
        (True, array([[ 0.       , -1.4702184, -0.2473498]]))
        >>> H, q = best
    """
    from chainrule.certificate import Certificate, Unbounded, certify, crude_bound

    task = checked_task(arm, task)
    budget = None if budget is None else whole_number(budget, "budget")
    found = certify(arm, task, budget, progress)
    if isinstance(found, Certificate):
        return _certified(arm, found, crude_bound(arm, task))
    met = maximise(arm, lambda q: arm.manipulability(q, task=task), _upward(arm, task), moving=depends_on(arm, task))
    if isinstance(found, Unbounded):
        how = (
            f"H has no maximum: a minor is affine in q{found.joint + 1}, which slides without limits, and grows with "
            f"it; q is the best posture met with slides within ±{FREE_TRAVEL:g} m"
        )
        return Maximum(math.inf, met.q, np.empty((0, arm.n)), math.inf, True, False, how)
    bound = max(crude_bound(arm, task), met.value)
    how = f"the best of 20,000 samples, twelve of them refined: a search, not a proof, because {found}" + (
        "; the bound follows from the lengths of the links" if math.isfinite(bound) else ""
    )
    return Maximum(met.value, met.q, met.others, bound, bound <= met.value * (1 + 1e-10), False, how)


def _certified(arm: Arm, found: Certificate, crude: float) -> Maximum:
    """The certificate in doubles and words."""
    from flint import arb, ctx

    from chainrule.balls import PRECISION, above, nearest

    with ctx.workprec(PRECISION):
        proved = bool(found.bound <= found.square * arb(1 + 2e-10))
        try:
            value, bound = nearest(found.square.sqrt()), above(found.bound.sqrt())
        except OverflowError:
            raise InputError(
                f"{arm.name}: H is larger than any double; lengths in a larger unit are accepted"
            ) from None
    if not proved:
        bound = max(value, min(bound, crude))
    return Maximum(value, found.postures[0], found.postures[1:], bound, proved, found.complete, _how(found, proved))


def _how(found: Certificate, proved: bool) -> str:
    def named(joints: tuple[int, ...]) -> str:
        return ", ".join(f"q{j + 1}" for j in joints)

    if found.waves:
        what = f"H² is a sum of {found.waves} wave{'s' if found.waves > 1 else ''} in {named(found.moving)}"
        if found.lost:
            what += f" (of which only {len(found.moving) - found.lost} of {len(found.moving)} combinations matter)"
    else:
        what = "H depends on no angle"
    if found.slides:
        what += f", convex in {named(found.slides)} and so largest at an end of the range"
    boxes = f"{found.boxes:,} box{'es' if found.boxes != 1 else ''}".replace(",", "\u202f")
    count = len(found.postures)
    if not found.waves and not found.slides:
        return "H is the same in every configuration"
    if found.complete:
        only = "this maximum" if count == 1 else f"these {count} maxima"
        return f"{what}; branch and bound over {boxes}, every rounding bounded, leaves {only} and no other"
    if proved:
        return f"{what}; branch and bound over {boxes}, every rounding bounded, leaves none higher"
    return (
        f"{what}; branch and bound over {boxes} did not settle it: the bound is certain, the maximum is the largest met"
    )


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


@dataclass(frozen=True, eq=False)
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
        singular: (k, n) isolated configurations met with H = 0 (to a relative 1e-7 of the maximum), free angles in
            (-pi, pi]; empty where they form curves.
        determinant: (k, k) for as many joints as rows, where H = |det J| and singular configurations form curves; else
            None.
        largest: the arm's largest H, with its proof, where the map shows every joint that H depends on; else None.
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
    singular: Array
    determinant: Array | None = None
    largest: Maximum | None = None

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists, without the grid."""
        return {
            "task": self.task,
            "joints": [j + 1 for j in self.joints],
            "q": self.q.tolist(),
            "unit": self.unit.text,
            "maximum": {"H": self.maximum.value, "q": self.maximum.q.tolist()},
            "minimum": {"H": self.minimum.value, "q": self.minimum.q.tolist()},
            "largest": None if self.largest is None else self.largest.to_dict(),
        }


def manipulability_map(
    arm: Arm,
    task: str | None = None,
    *,
    joints: tuple[int, int] | None = None,
    q: Any = None,
    size: int = 121,
    largest: Maximum | None = None,
) -> ManipulabilityMap:
    """H over a grid of two joints inside the joint limits, and the map's maximum (grid, then refined).

    Args:
        arm: the arm, of two joints or more.
        task: the task.
        joints: two joints, from 0; the pair over which H varies most when absent.
        q: (n,) the posture that holds the others; that of the largest H when absent.
        size: points in each direction.
        largest: what :func:`max_manipulability` found for this arm and task, if it is at hand.

    Raises:
        InputError: a task with more rows than joints, joints that do not exist, fewer than two joints, a q that is not
            n finite numbers, a size below 2.

    Example:
        >>> from chainrule import planar_3r
        >>> found = manipulability_map(planar_3r(1.0, 0.5, 0.25), q=[0.0, 0.0, 0.0], size=31)
        >>> found.joints, found.H.shape, round(found.maximum.value, 9)
        ((1, 2), (31, 31), 0.795537084)
    """
    task, size = checked_task(arm, task), whole_number(size, "size", 2)
    if q is None:
        largest = largest or max_manipulability(arm, task)
    posture = real_array(largest.q if q is None and largest is not None else q, "q")
    if posture.shape != (arm.n,):
        raise InputError(f"{arm.name}: q has shape {posture.shape}; ({arm.n},) is accepted")
    pair = liveliest_pair(arm, task, posture) if joints is None else _two_joints(arm, joints)
    first, second, grid = _grid(arm, pair, posture, size)
    height = arm.manipulability(grid, task=task)

    ranges = box(arm)
    upward, downward = _upward(arm, task), _downward(arm, task)
    if largest is not None and (not math.isfinite(largest.value) or set(depends_on(arm, task)) - set(pair)):
        largest = None
    if largest is None:
        best = best_of(arm, [climb(upward, start, pair, ranges) for start in _peaks(height, grid)], upward, pair)
    else:
        best = Found(largest.value, largest.q, largest.others)
    low = [climb(downward, start, pair, ranges) for start in _peaks(-height, grid)]
    least = best_of(arm, low, downward, pair)
    least = Found(float(arm.manipulability(least.q, task=task)), least.q, least.others)
    square = arm.tasks[task] == arm.n and f"minors_{task}" in _functions(arm, task)
    determinant = arm.minors(grid, task=task)[..., 0] if square else None
    zeros = _isolated_zeros(arm, task, low, best.value) if determinant is None else np.empty((0, arm.n))
    singular = zeros if len(zeros) <= 9 else np.empty((0, arm.n))
    return ManipulabilityMap(
        task, pair, first, second, height, posture, best, least, unit(arm, task), singular, determinant, largest
    )


def _two_joints(arm: Arm, joints: Any) -> tuple[int, int]:
    if isinstance(joints, (tuple, list)) and all(isinstance(j, (int, np.integer)) and 0 <= j < arm.n for j in joints):
        pair = tuple(int(j) for j in joints)
        if len(pair) == 2 and pair[0] != pair[1]:
            return pair[0], pair[1]
    raise InputError(f"{arm.name}: joints {shown(joints)}; two different ones of 0 to {arm.n - 1} are accepted")


def _isolated_zeros(arm: Arm, task: str, met: list[Array], top: float) -> Array:
    """Those of the configurations at which H is zero, each once."""
    turning, found = turns_freely(arm), list[Array]()
    for q in met:
        wrapped = np.where(turning, -np.remainder(np.pi + 1e-6 - q, 2 * np.pi) + np.pi + 1e-6, q)
        if arm.manipulability(q, task=task) <= 1e-7 * top and all(np.abs(wrapped - p).max() > 1e-4 for p in found):
            found.append(wrapped)
    return np.array(found).reshape(-1, arm.n)


def _functions(arm: Arm, task: str) -> dict[str, Any]:
    from chainrule import compile as compiling

    return compiling.find(arm.description.model, task).functions


def _grid(arm: Arm, pair: tuple[int, int], posture: Array, size: int) -> tuple[Array, Array, Array]:
    ranges = box(arm)
    first, second = (np.linspace(ranges[j, 0], ranges[j, 1], size) for j in pair)
    grid = np.tile(posture, (size, size, 1))
    grid[..., pair[0]] = first[:, None]
    grid[..., pair[1]] = second[None, :]
    return first, second, grid


def _peaks(height: Array, grid: Array) -> list[Array]:
    """Grid points not lower than their neighbours, the highest sixteen."""
    padded = np.pad(height, 1, constant_values=-np.inf)
    rows, columns = height.shape
    around = [padded[1 + i : 1 + i + rows, 1 + j : 1 + j + columns] for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
    peaks = np.argwhere(height >= np.max(around, axis=0))  # never empty: the largest of all is among them
    peaks = peaks[np.argsort(-height[tuple(peaks.T)], kind="stable")[:16]]
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
