"""Lenarcic's method as printed: follow the null eigenvector of J^T J by small steps. For teaching and comparison.

J. Lenarcic, "Some considerations on the self-motion curves of a planar 3R manipulator", equations (8) to (18):
q += gamma e, e the unit eigenvector of J^T J of the eigenvalue 0, in the sense of its predecessor, until the
configuration is within gamma k0 of the start again; the length is gamma times the number of steps. The paper's wrap,
(13) and (14), compares with 2 pi; here an angle above pi loses a turn and one below -pi gains one, as must be meant.

Nothing corrects the drift: the tip leaves its target by about gamma times the length, and where two branches of the
curve come closer than that (near a singular target) the method changes branches or never returns. It says so: a
greatest number of steps ends it, and the result has what it did to the task and how sharply it turned.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array, whole_number
from chainrule.self_motions.held import checked_targets, held_task, target_of

Array = NDArray[Any]

#: What each status means.
STATUSES = {
    "closed": "the configuration came back to within gamma k0 of the start",
    "never returned": "the greatest number of steps was made",
}
#: The eigenvector turning by more than this from one step to the next (rad) is counted as a jump.
JUMP = 0.1


@dataclass(frozen=True)
class EigenvectorRun:
    """What Lenarcic's method finds from one start.

    Attributes:
        status: a key of :data:`STATUSES`.
        q: (k + 1, n) the configurations, unwrapped.
        length: gamma times the number of steps, rad, equation (18).
        closure: the distance between the last configuration (wrapped) and the first, rad, equation (17).
        drift: the largest error of the task on the way, in its units (for angles rad).
        jumps: how many times the eigenvector turned by more than 0.1 rad in one step.
        least: the least singular value of J met.
        gamma: the step, rad.
    """

    status: str
    q: Array
    length: float
    closure: float
    drift: float
    jumps: int
    least: float
    gamma: float

    @property
    def winding(self) -> Array:
        """(n,): turns of each joint, whole only where the curve closed."""
        return np.asarray(np.rint((self.q[-1] - self.q[0]) / (2.0 * math.pi)), int)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        return {
            "status": self.status,
            "length": self.length,
            "closure": self.closure,
            "drift": self.drift,
            "jumps": self.jumps,
            "least": self.least,
            "gamma": self.gamma,
            "steps": len(self.q) - 1,
            "q": self.q.tolist(),
        }


def wrapped(q: Array, revolute: Array) -> Array:
    """Angles in (-pi, pi]: the wrap that equations (13) and (14) must mean."""
    turned = q - 2.0 * math.pi * np.ceil((q - math.pi) / (2.0 * math.pi))
    return np.asarray(np.where(revolute, turned, q))


def eigenvector(
    arm: Arm,
    q0: ArrayLike,
    task: str | None = None,
    *,
    gamma: float = 0.001,
    k0: int = 5,
    steps: int = 100_000,
) -> EigenvectorRun:
    """The self-motion curve through a configuration by the paper's method.

    Args:
        arm: an arm with n - m = 1.
        q0: (n,) where to start; what the tip does there is what should be held.
        task: the arm's default task when absent.
        gamma: the step, rad.
        k0: a return counts after so many steps, and within gamma k0 (the paper: at least 5).
        steps: greatest number of steps.

    Raises:
        InputError: n - m is not 1, a wrong shape, a step that is not positive.

    Example:
        >>> import chainrule as cr
        >>> run = eigenvector(cr.planar_3r(0.4, 0.35, 0.25), [0.5, 1.0, 1.0], gamma=0.01)
        >>> run.status, round(run.length, 2), run.drift > 1e-4
        ('closed', 12.95, True)
    """
    task = held_task(arm, task)
    start, size = real_array(q0, "q0"), float(real_array(gamma, "gamma"))
    if start.shape != (arm.n,):
        raise InputError(f"q0 has shape {start.shape}; ({arm.n},) is accepted")
    if not size > 0.0:
        raise InputError(f"gamma: {shown(gamma)}; a step above 0 is accepted")
    least_steps, most = whole_number(k0, "k0"), whole_number(steps, "steps")
    revolute = np.array([kind == "R" for kind in arm.kinds])
    first, q = wrapped(start, revolute), wrapped(start, revolute)
    path, turns, smallest, jumps = [start], np.zeros(arm.n), math.inf, 0
    status, before = "never returned", None
    for k in range(1, most + 1):
        jacobian = arm.jacobian(q, task=task)
        values, vectors = np.linalg.eigh(jacobian.T @ jacobian)
        e = vectors[:, 0]
        if before is not None:
            cosine = float(e @ before)
            e = e if cosine >= 0.0 else -e
            jumps += abs(cosine) < math.cos(JUMP)
        smallest, before = min(smallest, float(values[1])), e
        ahead = q + size * e
        q = wrapped(ahead, revolute)
        turns += np.rint((ahead - q) / (2.0 * math.pi))
        path.append(start - first + q + 2.0 * math.pi * turns)
        if k > least_steps and np.linalg.norm(q - first) < size * least_steps:
            status = "closed"
            break
    points = np.array(path)
    aim = target_of(arm, start, task)
    error = arm.evaluator(f"continuation_{task}")(points, checked_targets(arm, task, aim), *_parameters(arm))[0]
    return EigenvectorRun(
        status,
        points,
        size * (len(points) - 1),
        float(np.linalg.norm(q - first)),
        float(np.abs(error).max()),
        jumps,
        math.sqrt(max(smallest, 0.0)),
        size,
    )


def _parameters(arm: Arm) -> tuple[Array, ...]:
    return (arm.parameters,) if arm.parameters.size else ()
