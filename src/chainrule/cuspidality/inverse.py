"""The inverse solutions of arms with six revolute joints: a search from many starts; whether two poses are the same.

A damped Newton method on the generated pose and Jacobian, run on all starts at once (K. Levenberg 1944, D. Marquardt
1963). It needs no special geometry, and it is a search: a solution that no start leads to is not in the list. An arm
with six revolute joints has at most 16 (E. J. F. Primrose 1986).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.goals import wrapped
from chainrule.inputs import real_array, whole_number

Array = NDArray[Any]

#: Starts, steps of each at most, and the longest step of a joint, rad.
STARTS, STEPS, LONGEST = 600, 30, 1.0
#: An error (rad, and m over the arm's size) below which a start has arrived; postures nearer than this, rad, are one.
ARRIVED, SAME = 1e-9, 1e-5


def six_joints(arm: Any) -> Arm:
    """The arm, if it has six revolute joints in space.

    Raises:
        InputError: anything else.
    """
    if not isinstance(arm, Arm):
        raise InputError(f"arm: {shown(arm)}; an Arm with six revolute joints is accepted")
    if arm.kinds != "RRRRRR" or arm.tasks.get("pose") != 6:
        where = "" if arm.tasks.get("pose") == 6 else " in a plane"
        three = "; of three ask chainrule.regional_3r(arm)" if arm.kinds == "RRR" and not where else ""
        raise InputError(f"{arm.name}: joints {arm.kinds}{where}; six revolute joints in space are accepted{three}")
    return arm


def size(arm: Arm) -> float:
    """A length of the arm: the root mean square of the distances of the tip from the joints' axes, in m.

    Example:
        >>> from chainrule import load
        >>> round(size(load("ur5e")), 2)
        0.35
    """
    q = np.random.default_rng(0).uniform(-math.pi, math.pi, (256, arm.n))
    return float(np.sqrt(np.mean(np.square(arm.jacobian(q, task="pose")[:, :3]).sum(axis=1))))


def pose_error(arm: Arm, a: Any, b: Any) -> tuple[Array, Array]:
    """How far the tip's poses at two configurations (..., n) are apart: distance (...) in m, angle (...) in rad."""
    first, second = arm.pose(a), arm.pose(b)
    shift, turn = _apart(first, second)
    return np.linalg.norm(shift, axis=-1), np.linalg.norm(turn, axis=-1)


def same_pose(arm: Arm, a: Any, b: Any, *, tolerance: float = 1e-9) -> Any:
    """Whether two configurations (..., n) give the tip one pose: to ``tolerance`` in rad, and in m over the arm's size.

    Example:
        >>> from chainrule import load
        >>> puma = load("puma560")
        >>> bool(same_pose(puma, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], [0.1, 0.2, 0.3, 0.4 + np.pi, -0.5, 0.6 - np.pi]))
        True
    """
    distance, angle = pose_error(arm, real_array(a, "a"), real_array(b, "b"))
    return (distance <= tolerance * size(arm)) & (angle <= tolerance)


def inverse_solutions(arm: Arm, pose: Any, *, starts: int = STARTS, seed: int = 0) -> Array:
    """The configurations (k, 6) found that put the tip in a pose, each angle in (-pi, pi], in lexicographic order.

    Joint limits play no part. At a singular pose, where solutions are infinitely many or coincide, some of them.

    Args:
        arm: six revolute joints.
        pose: (4, 4), as :meth:`chainrule.Arm.pose` gives it.
        starts: how many starts.
        seed: of the starts.

    Raises:
        InputError: another kind of arm; ``pose`` is no pose.

    Example:
        >>> from chainrule import load
        >>> arm = load("gofa5")
        >>> len(inverse_solutions(arm, arm.pose([0.3, 0.4, 0.5, 0.6, 0.7, 0.8])))
        8
    """
    six_joints(arm)
    target = real_array(pose, "pose")
    if target.shape != (4, 4) or not np.allclose(target[:3, :3] @ target[:3, :3].T, np.eye(3), rtol=0, atol=1e-6):
        raise InputError(f"pose: shape {target.shape}; a homogeneous matrix (4, 4) with a rotation is accepted")
    rng = np.random.default_rng(whole_number(seed, "seed", 0))
    begin = rng.uniform(-math.pi, math.pi, (whole_number(starts, "starts"), 6))
    return solutions_from(arm, target, begin, size(arm))


def solutions_from(arm: Arm, target: Array, starts: Array, length: float) -> Array:
    """:func:`inverse_solutions` from given starts (m, 6); ``length`` is the arm's :func:`size`."""
    q, found = starts, []
    for _ in range(STEPS):
        error, jacobian = _errors(arm, q, target, length)
        far = np.linalg.norm(error, axis=-1)
        arrived = far < ARRIVED
        found.append(q[arrived])
        q, error, jacobian, far = (part[~arrived] for part in (q, error, jacobian, far))
        if not len(q):
            break
        step = _damped(jacobian, error, 1e-3 * np.minimum(far, 1.0) ** 2 + 1e-14)
        q = q + step * np.minimum(1.0, LONGEST / np.maximum(np.abs(step).max(axis=-1), 1e-300))[:, None]
    return _polished(arm, _distinct(wrapped(np.concatenate(found))), target, length)


def _errors(arm: Arm, q: Array, target: Array, length: float) -> tuple[Array, Array]:
    """The twist (k, 6) from the poses at q to the target, lengths over ``length``, and the Jacobian likewise."""
    pose, jacobian = arm.kinematics(q, task="pose")
    shift, turn = _apart(pose, target)
    return np.concatenate([shift / length, turn], axis=-1), jacobian / np.repeat([length, 1.0], 3)[:, None]


def _apart(pose: Array, target: Array) -> tuple[Array, Array]:
    """The translation (..., 3) and the rotation vector (..., 3), in the base frame, from one pose to another."""
    turn = target[..., :3, :3] @ np.swapaxes(pose[..., :3, :3], -1, -2)
    axis = 0.5 * skew_part(turn)
    sine = np.linalg.norm(axis, axis=-1)
    angle = np.arctan2(sine, 0.5 * (np.trace(turn, axis1=-2, axis2=-1) - 1.0))
    stretch = np.where(sine > 1e-9, angle / np.maximum(sine, 1e-300), 1.0)  # at a half turn the axis is lost: any step
    return target[..., :3, 3] - pose[..., :3, 3], axis * stretch[..., None]


def skew_part(matrix: Array) -> Array:
    """The vector (..., 3) of A - A^T; for a rotation 2 sin(angle) times its axis."""
    return np.stack([matrix[..., j, i] - matrix[..., i, j] for i, j in ((1, 2), (2, 0), (0, 1))], axis=-1)


def _damped(jacobian: Array, error: Array, damping: Array) -> Array:
    """(J^T J + damping)^-1 J^T error."""
    across = np.swapaxes(jacobian, -1, -2)
    normal = across @ jacobian + damping[:, None, None] * np.eye(jacobian.shape[-1])
    found: Array = np.linalg.solve(normal, across @ error[..., None])[..., 0]
    return found


def _distinct(q: Array) -> Array:
    """One of each group of configurations that are the same up to whole turns."""
    found = []
    while len(q):
        found.append(q[0])
        q = q[np.abs(wrapped(q - q[0])).max(axis=-1) > SAME]
    kept = np.array(found).reshape(-1, 6)
    return kept[np.lexsort(np.round(kept, 6).T[::-1])]


def _polished(arm: Arm, q: Array, target: Array, length: float) -> Array:
    """Newton steps as long as they reduce the error."""
    best = q
    for _ in range(3):
        error, jacobian = _errors(arm, best, target, length)
        try:
            moved = best + np.linalg.solve(jacobian, error[..., None])[..., 0]
        except np.linalg.LinAlgError:  # a singular one among them
            return best
        after, _ = _errors(arm, moved, target, length)
        better = np.linalg.norm(after, axis=-1) < np.linalg.norm(error, axis=-1)
        best = np.where(better[:, None], moved, best)
    return wrapped(best)
