"""Which self-motion a planar 3R arm has at a target, decided exactly: the signs of eight sums of lengths.

Lengths and the target's distance are scaled by a power of two first, so that no product leaves the range of numbers;
sums near zero are formed in rational arithmetic from the doubles as they are given.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import planar_model
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluator, Evaluators
from chainrule.inputs import real_array

Array = NDArray[Any]

TASKS = ("position", "x_alpha")
#: Signs of (l1, l2, l3) in the sums from which r is taken, and to which it is added.
SIGNS = np.array([[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]])
#: Sums below this share of all lengths together are formed exactly.
NEAR = 1e-6

UNREACHABLE, REGULAR, SINGULAR = 0, 1, 2
STATUS = ("unreachable", "regular", "singular")


@cache
def evaluators() -> Evaluators:
    """The generated functions of every planar 3R arm."""
    return Evaluators(planar_model("RRR"))


@cache
def evaluator(name: str) -> Evaluator:
    """A function of the group ``self_motion``, such as ``"speed_position"``."""
    found = evaluators().get("self_motion", f"self_motion_{name}")
    if found is None:
        raise InputError(f"there is no function self_motion_{name}")
    return found


@dataclass(frozen=True)
class Case:
    """One arm at one target.

    Attributes:
        task: "position" or "x_alpha".
        lengths: (3,) scaled by 2**-exponent; for x_alpha l3 is not scaled in with the others, and plays no part.
        reach: (1,) distance of the target from the base, or x - l3 cos alpha, scaled.
        sums: (8,) of the generated functions, scaled.
        zero: (8,) which of them are 0, exactly.
        exponent: the scale.
        offset: (3,) what is to be added to the joint values of the generated functions.
    """

    task: str
    lengths: Array
    reach: Array
    sums: Array
    zero: Array
    exponent: int
    offset: Array

    @property
    def scale_of_h(self) -> float:
        """What H of the scaled arm is multiplied with."""
        return math.ldexp(1.0, self.exponent * (2 if self.task == "position" else 1))


def planar_lengths_of(arm: Any) -> Array:
    """The lengths (3,) of a planar 3R arm.

    Raises:
        InputError: another kind of arm, or a negative length (turn the joints before and behind that link by pi).
    """
    if not isinstance(arm, Arm) or arm.description.model.name != "planar_rrr":
        name = arm.name if isinstance(arm, Arm) else shown(arm)
        raise InputError(f"{name}: not a planar arm with three revolute joints; that is what the closed form is for")
    lengths = arm.parameters
    return lengths if min(lengths.tolist()) >= 0.0 else checked_lengths(lengths, arm.name)


def checked_lengths(lengths: Any, name: str = "lengths") -> Array:
    """Lengths (..., 3), not negative.

    Raises:
        InputError: a wrong shape, numbers that are not finite, a negative length.
    """
    found = real_array(lengths, name)
    if found.ndim == 0 or found.shape[-1] != 3:
        raise InputError(f"{name}: shape {found.shape}; (..., 3) is accepted")
    if (found < 0.0).any():
        raise InputError(f"{name}: {float(found.min())} is negative; lengths of 0 and more are accepted")
    return found


def checked_targets(target: Any) -> Array:
    """Targets (..., 2): x and y, or x and alpha.

    Raises:
        InputError: a wrong shape, or numbers that are not finite.
    """
    found = real_array(target, "target")
    if found.ndim == 0 or found.shape[-1] != 2:
        raise InputError(f"target: shape {found.shape}; (..., 2) is accepted: x, y or (task 'x_alpha') x, alpha")
    return found


def checked_task(task: Any) -> str:
    """The task's name.

    Raises:
        InputError: it is neither.
    """
    if task not in TASKS:
        raise InputError(f"task: {shown(task)}; {' or '.join(map(repr, TASKS))} is accepted (one joint to spare)")
    return str(task)


def cases(lengths: Array, target: Array, task: str) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Of targets (k, 2): lengths (k, 3), reach (k, 1), sums (k, 8), which are 0, exponents (k,), offsets (k, 3)."""
    offset = np.zeros((len(target), 3))
    if task == "position":
        offset[:, 0] = np.arctan2(target[:, 1], target[:, 0])
        with np.errstate(over="ignore"):  # refused below
            reach, active = np.hypot(target[:, 0], target[:, 1]), lengths
    else:
        offset[:, 2] = target[:, 1]
        reach, active = target[:, 0] - lengths[:, 2] * np.cos(target[:, 1]), lengths * [1.0, 1.0, 0.0]
    largest = np.maximum(np.abs(active).max(axis=1), np.abs(reach))
    if not np.isfinite(largest).all():
        raise InputError("target: the distance of the target overflows; targets nearer to the base are accepted")
    exponent = np.frexp(largest)[1]
    scaled, r = np.ldexp(active, -exponent[:, None]), np.ldexp(reach, -exponent)
    flat = scaled @ SIGNS.T
    sums = np.concatenate([flat - r[:, None], flat + r[:, None]], axis=1)
    zero = np.zeros(sums.shape, bool)
    size = scaled.sum(axis=1) + np.abs(r)
    for k in np.flatnonzero(np.abs(sums).min(axis=1) <= NEAR * size):
        sums[k], zero[k] = exact_sums(
            active[k], target[k] if task == "position" else (reach[k],), reach[k], int(exponent[k])
        )
    return scaled, r[:, None], sums, zero, exponent, offset


def quick(lengths: Array, target: Array, task: str) -> tuple[Array, Array, int] | None:
    """Reach (1,), sums (8,) and number of curves of one target that is clearly regular or out of reach; else None."""
    l1, l2, l3 = lengths.tolist()
    x, y = target.tolist()
    if task == "position":
        r = math.hypot(x, y)
        least = min(l1, l2, l3, r)
    else:
        r, l3, least = x - l3 * math.cos(y), 0.0, min(l1, l2)
    ahead, behind = l1 + l2, l1 - l2
    sums = (
        *(ahead + l3 - r, ahead - l3 - r, behind + l3 - r, l3 - behind - r),
        *(ahead + l3 + r, ahead - l3 + r, behind + l3 + r, l3 - behind + r),
    )
    size = ahead + l3 + abs(r)
    if least == 0.0 or min(map(abs, sums)) <= NEAR * size or not 1e-30 < size < 1e30:
        return None
    if task == "position":
        reached = min(sums[0], sums[5], sums[6], sums[7]) > 0.0
        two = (sums[1] > 0.0) ^ (sums[2] > 0.0) ^ (sums[3] > 0.0)
    else:
        reached, two = min(sums[0], sums[4]) > 0.0, (sums[2] > 0.0) == (sums[6] > 0.0)
    return np.array([r]), np.array(sums), (2 if two else 1) if reached else 0


def exact_sums(lengths: Any, target: Any, reach: float, exponent: int) -> tuple[Array, Array]:
    """The sums rounded once, with their true signs, and which are exactly 0; ``target`` has the length |reach|."""
    scale = Fraction(2) ** -exponent
    square = sum((Fraction(float(t)) ** 2 for t in target), Fraction(0))
    r = Fraction(float(reach))
    low = (square - r * r) / (2 * r) if r else Fraction(0)  # what rounding took from the distance
    sums, zero = np.empty(8), np.zeros(8, bool)
    links = [Fraction(float(length)) for length in lengths]
    for k, (side, signs) in enumerate(product((-1, 1), SIGNS)):
        flat = sum((int(sign) * link for sign, link in zip(signs, links, strict=True)), Fraction(0))
        value = (flat + side * (r + low)) * scale
        # flat + side * distance, by squares, since the distance need not be rational
        opposite = flat * side * (1 if r >= 0 else -1) <= 0
        zero[k] = opposite and flat * flat == square
        if zero[k]:
            sums[k] = 0.0
            continue
        sums[k] = float(value)
        if opposite:
            true = 1.0 if (flat * flat > square) == (flat > 0) else -1.0
            if flat == 0:
                true = float(side * (1 if r > 0 else -1))
            sums[k] = math.copysign(max(abs(sums[k]), 5e-324), true)
    return sums, zero


def counted(lengths: Array, reach: Array, sums: Array, zero: Array, task: str) -> tuple[Array, Array, Array]:
    """Status (k,), number of curves (k,) and number of lengths that are 0 (k,), for the arrays of :func:`cases`.

    The number is that of a regular self-motion; where it is singular, that of the pieces into which its singular
    points cut it (0 for a surface).
    """
    if task == "position":
        nothing = (lengths == 0.0).sum(axis=1) + (reach[:, 0] == 0.0)
        rims, crossings = sums[:, [0, 5, 6, 7]], sums[:, 1:4]
        end, crossed = zero[:, [0, 5, 6, 7]], zero[:, 1:4]
        surface = nothing >= 2
    else:
        nothing = (lengths[:, :2] == 0.0).sum(axis=1)
        rims, crossings = sums[:, [0, 4]], sums[:, [2, 6]]
        end, crossed = zero[:, [0, 4]], zero[:, [2, 6]]
        surface = nothing == 2
    reached = (np.where(end, 0.0, rims) >= 0.0).all(axis=1)
    side = np.sign(np.where(crossed, 0.0, crossings)).prod(axis=1)
    singular = reached & (end.any(axis=1) | crossed.any(axis=1))
    number = np.where(side > 0, 2, 1)
    number[singular] = np.where(crossed.any(axis=1), 2 * crossed.sum(axis=1), 1)[singular]
    number[singular & (nothing > 0)] = 1
    number[surface | ~reached] = 0
    status = np.where(reached, np.where(singular, SINGULAR, REGULAR), UNREACHABLE)
    return status, number, nothing


def case_of(lengths: Array, target: Array, task: str) -> tuple[Case, int, int, int]:
    """One target: the case, its status, number of curves, and number of lengths that are 0."""
    scaled, reach, sums, zero, exponent, offset = cases(lengths[None], target[None], task)
    status, number, nothing = counted(scaled, reach, sums, zero, task)
    case = Case(task, scaled[0], reach[0], sums[0], zero[0], int(exponent[0]), offset[0])
    return case, int(status[0]), int(number[0]), int(nothing[0])


def closed_boxes(task: str, extremes: Array, q: Array, sense: Array) -> Array:
    """Ranges (..., 3, 2) of the functions' joint values on whole closed curves.

    Args:
        task: "position" or "x_alpha".
        extremes: (..., 3, 2) least and greatest |angle| of q1, q2, q3 (x_alpha: q1, q2, heading of link 2 = -q3).
        q: (..., 3) a point of the curve; of a joint that winds, the point from which it is unwrapped.
        sense: (..., 3) the signs of the joints' rates there.
    """
    turn = 2.0 * math.pi
    heading = np.array([1.0, 1.0, -1.0 if task == "x_alpha" else 1.0])
    least, most = extremes[..., 0], extremes[..., 1]
    low = np.where(least == 0.0, -most, least)
    high = np.where((most == math.pi) & (least > 0.0), turn - least, most)
    flip = heading * np.where((least > 0.0) & (most < math.pi), np.sign(np.sin(heading * q)), 1.0) < 0.0
    low, high = np.where(flip, -high, low), np.where(flip, -low, high)
    winds = (least == 0.0) & (most == math.pi)
    low, high = (
        np.where(winds, q + turn * np.minimum(sense, 0.0), low),
        np.where(winds, q + turn * np.maximum(sense, 0.0), high),
    )
    found: Array = np.stack([low, high], axis=-1)
    return found
