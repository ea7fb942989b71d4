"""Configurations to begin from, and how they are moved to a target."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.self_motions.held import Held, checked_targets, held_task, length_scale

Array = NDArray[Any]

#: Most corrections, and the largest one (rad), of :func:`project`; and the last one, below which it has arrived.
PROJECTIONS, STRIDE, ARRIVED = 60, 0.5, 1e-10
#: Half of the step of difference quotients, rad.
DIFFERENCE = 1e-5


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
