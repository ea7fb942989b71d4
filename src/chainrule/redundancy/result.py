"""What following a path gave: every step of it, what happened on the way, and how it ended.

All methods give the same result, so that they can be compared: rows are samples in time, the first at t = 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.redundancy.step import Law

Array = NDArray[Any]
Status = Literal["complete", "stopped"]

#: What each kind of event means.
EVENTS = {
    "start off the path": "the tip was farther than a millimetre or a milliradian from the first target",
    "singularity near": "the manipulability fell below the stated share of the largest so far",
    "limit met": "a joint came to a limit of position, velocity or acceleration",
    "limit passed": "a joint is outside a limit of position or velocity, which the method does not keep",
    "path left": "the tip is off its target by more than a hundredth of the path's extent (1 mm at least) or 0.05 rad",
    "task scaled": "the path is run more slowly than asked, because the limits leave no other way",
    "gain too large": "the null-space gain exceeds the estimated bound of stability for the step",
    "rates too large": "a joint rate exceeded the stated bound",
    "not finite": "the law gave a number that is not finite",
}


@dataclass(frozen=True)
class Event:
    """Something that happened on the way.

    Attributes:
        t: when, s.
        kind: one of :data:`EVENTS`.
        text: what happened, in a sentence with its numbers.
    """

    t: float
    kind: str
    text: str

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"t": self.t, "kind": self.kind, "text": self.text}


@dataclass(frozen=True)
class Run:
    """A path followed, in k samples by an arm of n joints.

    Attributes:
        arm: the arm.
        task: what was held, such as "pose" or "position".
        method: how spare joints were used, such as "gradient_projection".
        law: gains, feedback, damping and weights; None for a method without one.
        integrator: "euler", "heun", "rk4" or "dop853"; what the method states where there is none.
        dt: time between samples, s.
        t: (k,) s.
        q: (k, n) rad or m.
        rates: (k, n) that the law gives at each sample, rad/s or m/s.
        accelerations: (k, n) of the rates: central differences, one-sided at both ends, unless the method knows them
            better; rad/s^2 or m/s^2.
        torque: (k, n) N m or N, from inverse dynamics under gravity; None where the arm has no inertias.
        held: (k, ...) the targets: poses (4, 4), positions (3,), planar (x, y), (x, alpha) or (x, y, alpha).
        manipulability: (k,) w = sqrt(det J J^T).
        determinant: (k,) det J J^T = w^2.
        position_error: (k, p) tip minus target, m; p = 3, in the plane 2 (1 for the task "x_alpha").
        orientation_error: (k, r) the rotation vector from the target's orientation to the tip's, rad; r = 3, in the
            plane 1; 0 where the task leaves the orientation free.
        frame_errors: (k, 4) |n - n_d|, |o - o_d|, |a - a_d|, |p - p_d|: by how much the axes x, y, z of the tip and its
            position miss those of the target. An axis that the task leaves free counts nan.
        null_motion: (k, n) the part of the rates that does not move the tip, rad/s or m/s.
        scale: (k,) the share of the asked path speed that was run: 1 unless the task was scaled.
        events: what happened, in order of time.
        status: "complete", or "stopped" before the end of the path.
        reason: the status in a sentence.
    """

    arm: Arm
    task: str
    method: str
    law: Law | None
    integrator: str
    dt: float
    t: Array
    q: Array
    rates: Array
    accelerations: Array
    torque: Array | None
    held: Array
    manipulability: Array
    determinant: Array
    position_error: Array
    orientation_error: Array
    frame_errors: Array
    null_motion: Array
    scale: Array
    events: tuple[Event, ...]
    status: Status
    reason: str

    @property
    def peak_rate(self) -> float:
        """The largest joint rate, rad/s or m/s."""
        return float(np.abs(self.rates).max(initial=0.0))

    @property
    def peak_acceleration(self) -> float:
        """The largest joint acceleration, rad/s^2 or m/s^2."""
        return float(np.abs(self.accelerations).max(initial=0.0))

    @property
    def peak_torque(self) -> float | None:
        """The largest joint torque, N m or N; None where the arm has no inertias."""
        return None if self.torque is None else float(np.abs(self.torque).max(initial=0.0))

    @property
    def min_manipulability(self) -> float:
        """The smallest w met at a sample."""
        return float(self.manipulability.min(initial=math.inf))

    @property
    def worst_position_error(self) -> float:
        """The largest distance of the tip from its target, m."""
        return float(self._distance.max(initial=0.0))

    @property
    def final_position_error(self) -> float:
        """The distance of the tip from its target at the last sample, m."""
        return float(self._distance[-1])

    @property
    def worst_orientation_error(self) -> float:
        """The largest angle between the tip's orientation and its target's, rad; 0 where it is free."""
        return float(np.linalg.norm(self.orientation_error, axis=1).max(initial=0.0))

    @property
    def _distance(self) -> Array:
        return np.asarray(np.linalg.norm(self.position_error, axis=1))

    def to_dict(self) -> dict[str, Any]:
        """Plain values; what is not a finite number is None. ``masses`` says what the torques rest on."""
        from chainrule.redundancy.words import masses

        numbers = (
            *("t", "q", "rates", "accelerations", "torque", "held", "manipulability", "determinant"),
            *("position_error", "orientation_error", "frame_errors", "null_motion", "scale"),
        )
        return {
            "arm": self.arm.name,
            "task": self.task,
            "method": self.method,
            "law": None if self.law is None else self.law.to_dict(),
            "integrator": self.integrator,
            "dt": self.dt,
            "status": self.status,
            "reason": self.reason,
            "peak_rate": _finite(self.peak_rate),
            "peak_acceleration": _finite(self.peak_acceleration),
            "peak_torque": _finite(self.peak_torque),
            "masses": None if self.torque is None else masses(self.arm),
            "min_manipulability": _finite(self.min_manipulability),
            "worst_position_error": _finite(self.worst_position_error),
            "final_position_error": _finite(self.final_position_error),
            "worst_orientation_error": _finite(self.worst_orientation_error),
            "events": [event.to_dict() for event in self.events],
            **{name: _plain(getattr(self, name)) for name in numbers},
        }

    def rows(self) -> tuple[list[str], list[list[float]]]:
        """Headings and one row of numbers for each sample, for a CSV file."""
        joints = range(1, self.arm.n + 1)
        blocks: list[tuple[list[str], Array]] = [
            (["t"], self.t[:, None]),
            ([f"q{j}" for j in joints], self.q),
            ([f"rate{j}" for j in joints], self.rates),
            ([f"acceleration{j}" for j in joints], self.accelerations),
        ]
        if self.torque is not None:
            blocks.append(([f"torque{j}" for j in joints], self.torque))
        coordinates = ["x"] if self.task == "x_alpha" else ["x", "y", "z"]
        turns = ["alpha"] if self.orientation_error.shape[1] == 1 else ["x", "y", "z"]
        blocks += [
            (["manipulability"], self.manipulability[:, None]),
            (["determinant"], self.determinant[:, None]),
            ([f"position_error_{axis}" for axis in coordinates][: self.position_error.shape[1]], self.position_error),
            (
                [f"orientation_error_{axis}" for axis in turns][: self.orientation_error.shape[1]],
                self.orientation_error,
            ),
            ([f"frame_error_{axis}" for axis in "noap"], self.frame_errors),
            ([f"null_motion{j}" for j in joints], self.null_motion),
            (["scale"], self.scale[:, None]),
        ]
        headings = [name for names, _ in blocks for name in names]
        return headings, np.concatenate([values for _, values in blocks], axis=1).tolist()


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def _plain(values: Array | None) -> Any:
    """Nested lists; None for what is not finite, which JSON does not know."""
    if values is None:
        return None
    if np.isfinite(values).all():
        return values.tolist()
    plain = values.astype(object)
    plain[~np.isfinite(values)] = None
    return plain.tolist()
