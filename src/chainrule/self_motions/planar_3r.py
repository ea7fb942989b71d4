"""Every self-motion of a planar 3R arm, in closed form.

The number of curves is decided exactly, and lengths are right to 1e-10 at any distance from a singular radius.
Corrects and completes J. Lenarcic, "Some considerations on the self-motion curves of a planar 3R manipulator" (CIT 10,
2002): with the lengths sorted L >= M >= S, the circles |M + S - L|, L - M + S, L + M - S, L + M + S cut the workspace
into regions with 2 (0 if L > M + S), 1, 2, 1 and 0 curves; at the base point the first joint turns freely.
"""

from __future__ import annotations

import math
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.inputs import whole_number
from chainrule.self_motions import planar_case as deciding
from chainrule.self_motions.planar_case import REGULAR, STATUS, evaluator
from chainrule.self_motions.planar_components import component
from chainrule.self_motions.planar_pieces import FREE, TURN, pieces_of, zero_length
from chainrule.self_motions.result import MOST_POINTS, SelfMotion

Array = NDArray[Any]

#: Least and greatest number of nodes of the trapezoidal rule on the period.
FIRST, LAST = 32, 1 << 16
#: Relative accuracy of lengths.
ACCURACY = 1e-10


def singular_radii(lengths: Any) -> Array:
    """The distances from the base at which self-motions of a planar 3R arm (task "position") are singular, rising.

    Args:
        lengths: (3,) m, in any order, not negative.

    Returns:
        |M + S - L|, L - M + S, L + M - S and L + M + S for the lengths L >= M >= S; equal ones once.

    Raises:
        InputError: other than three lengths of 0 and more.

    Example:
        >>> singular_radii([0.40, 0.35, 0.25]).round(12)
        array([0.2, 0.3, 0.5, 1. ])
        >>> singular_radii([1.0, 1.0, 1.0])
        array([1., 3.])
    """
    found = deciding.checked_lengths(lengths)
    if found.shape != (3,):
        raise InputError(f"lengths: shape {found.shape}; (3,) is accepted")
    s, m, l = sorted(float(length) for length in found)  # noqa: E741
    return np.unique([abs(math.fsum([m, s, -l])), math.fsum([l, -m, s]), math.fsum([l, m, -s]), math.fsum([l, m, s])])


def singular_values(lengths: Any, alpha: float) -> Array:
    """The values of x at which self-motions of a planar 3R arm (task "x_alpha") are singular, rising.

    Args:
        lengths: (3,) m, not negative.
        alpha: the direction held, rad.

    Returns:
        l3 cos alpha +- l1 +- l2; equal ones once.

    Raises:
        InputError: other than three lengths of 0 and more, or an alpha that is not finite.

    Example:
        >>> singular_values([0.40, 0.35, 0.25], 0.0).round(12)
        array([-0.5,  0.2,  0.3,  1. ])
    """
    found = deciding.checked_lengths(lengths)
    held = deciding.checked_targets([0.0, alpha])[1]
    if found.shape != (3,):
        raise InputError(f"lengths: shape {found.shape}; (3,) is accepted")
    middle = float(found[2]) * math.cos(held)
    return np.unique([math.fsum([middle, i * found[0], j * found[1]]) for i in (-1, 1) for j in (-1, 1)])


@cache
def nodes(count: int) -> Array:
    """Points (count, 2) of half a turn: cosine and sine of k pi / count."""
    theta = np.arange(count) * (math.pi / count)
    return np.stack([np.cos(theta), np.sin(theta)], axis=-1)


@cache
def between_nodes(count: int) -> Array:
    """The points of ``nodes(2 count)`` that are not in ``nodes(count)``."""
    return np.ascontiguousarray(nodes(2 * count)[1::2])


def settled(mean: Any, change: Any, before: Any, accuracy: float = ACCURACY) -> Any:
    """Whether a mean over the period is right, by its last two changes.

    The error falls geometrically, so that it is far below the last change. A thin feature of a very uneven arm may hide
    from a set of nodes by chance; that the change before was small as well makes that improbable (none in 60,000
    hostile arms with lengths over four decades, at 1e-10).
    """
    return (change <= 0.1 * accuracy * mean) & (before <= 0.01 * math.sqrt(accuracy) * mean)


def half_length(reach: Array, sums: Array, lengths: Array, task: str, accuracy: float = ACCURACY) -> float:
    """Half the length of a regular self-motion's curves together: one of two, or half of one.

    The trapezoidal rule over the period of an analytic integrand: its error falls geometrically.
    """
    speed = evaluator(f"speed_{task}").function  # arrays of doubles, of the right shapes: nothing to check
    count = FIRST
    both = speed(nodes(count), reach, sums, lengths)
    mean, coarse, coarser = (float(np.add.reduce(both[::step])) * step / count for step in (1, 2, 4))
    before, change = abs(coarse - coarser), abs(mean - coarse)
    while count < LAST and not settled(mean, change, before, accuracy):
        between = float(np.add.reduce(speed(between_nodes(count), reach, sums, lengths))) / count
        finer = (mean + between) / 2.0
        before, change, mean, count = change, abs(finer - mean), finer, 2 * count
    return mean * math.pi


def planar_lengths(
    arm: Arm, target: Any, task: str = "position", *, accuracy: float = ACCURACY
) -> tuple[str, tuple[float, ...]]:
    """Status and the length of each self-motion curve of a planar 3R arm, rad, without the curves themselves.

    Args:
        arm: as of :func:`planar_self_motion`.
        target: (2,) likewise.
        task: "position" or "x_alpha".
        accuracy: relative, of the lengths; from 1e-13 to 1e-2.

    Raises:
        InputError: as :func:`planar_self_motion`; an accuracy that is not accepted.

    Example:
        >>> from chainrule import planar_3r
        >>> status, lengths = planar_lengths(planar_3r(0.40, 0.35, 0.25), [0.1, 0.0])
        >>> status, len(lengths), round(lengths[0], 9)
        ('regular', 2, 6.752948361)
    """
    task, lengths, where = _checked(arm, target, task)
    if not (isinstance(accuracy, float) and 1e-13 <= accuracy <= 1e-2):
        raise InputError(f"accuracy: {shown(accuracy)}; a number from 1e-13 to 1e-2 is accepted")
    known = deciding.quick(lengths, where, task)
    if known is not None:
        reach, sums, number = known
        half = half_length(reach, sums, lengths, task, accuracy) if number else 0.0
        return STATUS[min(number, 1)], ((), (2.0 * half,), (half, half))[number]
    case, status, number, nothing = deciding.case_of(lengths, where, task)
    if status != REGULAR:
        found = planar_self_motion(arm, target, task)
        return found.status, tuple(part.length for part in found.components)
    if nothing:
        length = TURN * float(np.linalg.norm(FREE[task][zero_length(case)]))
        return STATUS[status], (length,) * number
    half = half_length(case.reach, case.sums, case.lengths, task, accuracy)
    return STATUS[status], (half, half) if number == 2 else (2.0 * half,)


def _checked(arm: Arm, target: Any, task: str) -> tuple[str, Array, Array]:
    """The task, the lengths (3,) and the target (2,)."""
    task, lengths = deciding.checked_task(task), deciding.planar_lengths_of(arm)
    where = deciding.checked_targets(target)
    if where.shape != (2,):
        raise InputError(f"target: shape {where.shape}; (2,) is accepted; for many targets see self_motion_map")
    return task, lengths, where


def planar_self_motion(
    arm: Arm, target: Any, task: str = "position", *, points: int = 129, limits: bool = True
) -> SelfMotion:
    """Every self-motion curve of a planar 3R arm at a target.

    Args:
        arm: a planar arm with three revolute joints; lengths may be 0 or equal.
        target: (2,) x and y, m; or for the task "x_alpha" x, m, and the last link's direction alpha, rad.
        task: "position" or "x_alpha".
        points: how many points of each curve to give, evenly spaced; any others by ``Component.at``.
        limits: whether to find the parts within the arm's joint limits (:attr:`SelfMotion.feasible`), if it has any.

    Returns:
        Status "regular" with one or two closed curves; "singular" with the pieces between singular points (loops of a
        figure of eight, arcs), an isolated point, or nothing but its name where the set is a surface; "unreachable".
        Joint 1 is unwrapped from the target's direction. Two curves are mirror images, equally long; the signs that
        each keeps are those of sin q2, sin q3, sin(q2 + q3) and of the headings relative to the target's direction
        ("q1-direction", "q1+q2-direction", "q1+q2+q3-direction"), or for x_alpha sin q1 or sin(q1 + q2).

    Raises:
        InputError: another arm, a negative length, a target or task that is not accepted.

    Example:
        >>> from chainrule import planar_3r
        >>> found = planar_self_motion(planar_3r(0.40, 0.35, 0.25), [0.4, 0.0])
        >>> found.count, round(found.components[0].length, 9), dict(found.components[0].signs)
        (2, 8.238309624, {'q2': 1, 'q1-direction': -1, 'q1+q2-direction': 1})
    """
    task, lengths, where = _checked(arm, target, task)
    points = whole_number(points, "points", 2, MOST_POINTS)
    case, status, number, nothing = deciding.case_of(lengths, where, task)
    detail, parts = pieces_of(case, status, number, nothing)
    finish = partial(component, arm, where, task, points)
    components = tuple(finish(part) for part in parts)
    feasible = None
    if limits and np.isfinite(arm.limits.position).any():
        from chainrule.self_motions import planar_limits  # SciPy's special functions are loaded only here

        feasible = tuple(planar_limits.feasible(case, parts, arm.limits.position, finish))
    return SelfMotion(
        arm=arm.name,
        task=task,
        target=where,
        method="closed form",
        status=STATUS[status],
        components=components,
        complete="proved",
        detail=detail,
        feasible=feasible,
        to_singular=_to_singular(arm, where, task),
    )


def _to_singular(arm: Arm, target: Array, task: str) -> float:
    """Distance of the target to the nearest singular value, m."""
    if task == "x_alpha":
        return float(np.abs(singular_values(arm.parameters, float(target[1])) - target[0]).min())
    return float(np.abs(singular_radii(arm.parameters) - math.hypot(*target)).min())
