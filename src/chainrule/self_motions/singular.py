"""The nearest target whose self-motion is singular, for any arm with one joint to spare.

A target is singular if the task Jacobian J loses rank at some posture that holds it: there curves touch, or have shrunk
to points. Where J has the left null vector u (unit, J^T u = 0) every motion dq moves the tip across u only, so singular
targets form a hypersurface with normal u. The nearest one to a target x is therefore found among the solutions of

    J(q)^T u = 0,   u.u = 1,   e(q) + d u = 0,

n + m + 1 equations for q, u and d; e is the task's error at x, rows that are lengths divided by a stated length, and
|d| the distance. Newton's method is started from where H is least on the curves at x, from points all along them, and
from random configurations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.held import Held, target_of
from chainrule.self_motions.projection import DIFFERENCE, start_points
from chainrule.self_motions.result import Component, SelfMotion

Array = NDArray[Any]

#: Starts on each curve besides the minima of H, and random ones; steps of Newton's method, the longest of them, and the
#: last one.
STARTS, RANDOM, STEPS, STRIDE, LAST = 16, 128, 60, 0.3, 1e-10
#: A smallest singular value of J below this share of the largest one is 0.
LOST = 1e-8


@dataclass(frozen=True)
class NearestSingular:
    """A singular target near a target.

    Attributes:
        distance: from the target, m: of a displacement dp and a turn of the tip by t, sqrt(|dp|^2 + (L sin t)^2) with
            L = ``length`` (planar tasks have t in place of its sine; those without orientation only dp). An upper bound
            of the distance to the nearest one: the target below is singular, others may be nearer. None where no start
            led to one.
        target: the singular target; None likewise.
        q: (n,) the posture that holds it in which the Jacobian loses rank.
        length: m that count as one radian of orientation.
        manipulability: the least H on the curves at the target itself.
        least: (n,) about where: the one of 512 points of each curve with the least H.
    """

    distance: float | None
    target: Array | None
    q: Array | None
    length: float
    manipulability: float
    least: Array

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        return {
            "distance": self.distance,
            "target": None if self.target is None else self.target.tolist(),
            "q": None if self.q is None else self.q.tolist(),
            "length": self.length,
            "manipulability": self.manipulability,
            "least": self.least.tolist(),
        }


def nearest_singular(arm: Arm, target: Any, task: str | None = None, **options: Any) -> NearestSingular:
    """How near a target is to the nearest one whose self-motion is singular, found by a local search.

    What is guaranteed: the target returned is singular, and stationary (the distance does not fall in any direction
    along the singular targets near it); and on the curves at the target H is nowhere less than ``manipulability``. What
    is not: that no other singular target is nearer. For planar 3R arms ``self_motion(...).to_singular`` is exact.

    Args:
        arm: as for :func:`chainrule.self_motion`.
        target: likewise; or a :class:`SelfMotion` found before.
        task: what is held; the arm's default task when absent.
        options: of :func:`chainrule.self_motion`.

    Raises:
        InputError: what :func:`chainrule.self_motion` refuses; a target that no posture reaches.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(0.40, 0.35, 0.25)
        >>> near = cr.nearest_singular(arm, [0.38, 0.0])
        >>> round(near.distance, 9), near.target.round(9).tolist()  # the radius 0.40 - 0.35 + 0.25
        (0.08, [0.3, 0.0])
        >>> panda = cr.load("panda")
        >>> near = cr.nearest_singular(panda, panda.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4]))
        >>> bool(panda.manipulability(near.q) < 1e-8), round(near.distance, 3)
        (True, 0.012)
    """
    motion = target if isinstance(target, SelfMotion) else self_motion(arm, target, task, **options)
    if not motion.components:
        raise InputError(f"{arm.name}: no posture reaches the target; one with a self-motion is accepted")
    held = Held(arm, motion.task, motion.components[0].scale)
    q, h = _starts(arm, motion.task, motion.components)
    length = held.size
    system = held.system(motion.target)
    weights = np.where(np.arange(arm.tasks[motion.task]) < system.positions, 1.0 / length, 1.0)
    random = start_points(arm, RANDOM)
    found, distance = _stationary(held, np.concatenate([q, random]), motion.target, weights)
    least, smallest = q[int(np.argmin(h))], min(curve.manipulability[0] for curve in motion.components)
    if not len(found):
        return NearestSingular(None, None, None, length, smallest, least)
    best = int(np.argmin(distance))
    singular = target_of(arm, found[best], motion.task)
    return NearestSingular(float(distance[best] * length), singular, found[best], length, smallest, least)


def _starts(arm: Arm, task: str, components: Sequence[Component]) -> tuple[Array, Array]:
    """Postures all along the curves and where H has a minimum among many, and H there."""
    found = []
    for curve in components:
        if len(curve.q) < 2:
            found.append(curve.q)
            continue
        q = curve.at(np.linspace(0.0, 1.0, 513)[:-1])
        h = arm.manipulability(q, task=task)
        dips = (h <= np.roll(h, 1)) & (h < np.roll(h, -1))
        found += [q[dips], q[:: 512 // STARTS]]
    q = np.concatenate(found)
    return q, np.asarray(arm.manipulability(q, task=task))


def _stationary(held: Held, q: Array, target: Array, weights: Array) -> tuple[Array, Array]:
    """Singular postures (k, n) whose targets are stationary in distance, and the distances (k,), scaled."""
    n, m = held.arm.n, len(weights)
    unit, steps = held.unit, (DIFFERENCE * np.eye(held.arm.n) * held.unit)[:, np.newaxis]

    def scaled(at: Array) -> tuple[Array, Array]:
        e, jacobian, _ = held.evaluate(at, target)
        return e * weights, jacobian * unit * weights[:, np.newaxis]

    e, jacobian = scaled(q)
    u = np.linalg.svd(jacobian)[0][..., -1]  # of the least singular value
    d = -(e * u).sum(axis=1)
    q, going = q.copy(), np.ones(len(q), bool)
    for _ in range(STEPS):
        at = np.flatnonzero(going)
        if not len(at):
            break
        e, jacobian = scaled(q[at])
        ahead, behind = (scaled(q[at] + sign * steps)[1] for sign in (1.0, -1.0))
        bend = (ahead - behind) / (2.0 * DIFFERENCE)  # (n, k, m, n): by each joint
        rows = np.zeros((len(at), n + m + 1, n + m + 1))
        rows[:, :n, :n] = np.einsum("ikab,ka->kbi", bend, u[at])
        rows[:, :n, n : n + m] = np.swapaxes(jacobian, 1, 2)
        rows[:, n, n : n + m] = 2.0 * u[at]
        rows[:, n + 1 :, :n] = jacobian
        rows[:, n + 1 :, n : n + m] = d[at, np.newaxis, np.newaxis] * np.eye(m)
        rows[:, n + 1 :, -1] = u[at]
        error = np.concatenate(
            [np.einsum("kab,ka->kb", jacobian, u[at]), (u[at] ** 2).sum(axis=1)[:, np.newaxis] - 1.0,
             e + d[at, np.newaxis] * u[at]], axis=1
        )  # fmt: skip
        square = np.swapaxes(rows, 1, 2) @ rows + 1e-14 * np.eye(n + m + 1)
        step = -np.linalg.solve(square, (np.swapaxes(rows, 1, 2) @ error[..., np.newaxis]))[..., 0]
        size = np.linalg.norm(step, axis=1)
        step *= np.minimum(1.0, STRIDE / np.maximum(size, 1e-300))[:, np.newaxis]
        q[at] += step[:, :n] * unit
        u[at] += step[:, n : n + m]
        d[at] += step[:, -1]
        going[at] = (size > LAST) & np.isfinite(size)
    e, jacobian = scaled(q)
    values = np.linalg.svd(np.nan_to_num(jacobian), compute_uv=False)
    good = ~going & (values[:, -1] <= LOST * np.maximum(values[:, 0], 1e-300)) & np.isfinite(e).all(axis=1)
    size = np.linalg.norm(e, axis=1)
    good &= np.abs(size - np.abs(d)) <= 1e-8 * np.maximum(size, 1.0)
    if held.system(target).spatial:  # the skew part vanishes at half a turn too
        good &= np.trace(held.arm.pose(q)[:, :3, :3] @ target[:3, :3].T, axis1=1, axis2=2) > 1.0
    return q[good], size[good]
