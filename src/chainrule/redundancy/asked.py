"""What callers of the following functions ask for, checked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import real_number
from chainrule.redundancy.step import CRITERIA
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.time_laws import positive

Array = NDArray[Any]
Push = Callable[[float, Array], Any]
Secondary = Callable[[float, Array], tuple[Any, Any]]

#: Samples of a path when no dt is given.
SAMPLES = 300
#: The most steps of a run.
MOST_STEPS = 1_000_000
#: Feedback when none is given: the share of the error that one step takes away.
FEEDBACK = 0.5


@dataclass(frozen=True)
class Extras:
    """What a user adds to the law: a push, and a secondary task."""

    push: Push | None = None
    secondary: Secondary | None = None

    def now(self, t: float, q: Array) -> dict[str, Any]:
        """As the stepper takes them, at one time and configuration (n,)."""
        found: dict[str, Any] = {}
        if self.push is not None:
            found["push"] = real_array(self.push(t, q), "push", finite=False)
            if found["push"].shape != q.shape:
                raise InputError(f"push: it gives shape {found['push'].shape}; {q.shape} is accepted")
        if self.secondary is not None:
            given = self.secondary(t, q)
            if not isinstance(given, tuple | list) or len(given) != 2:
                raise InputError(f"secondary: it gives {shown(given)}; Jacobian (k, n) and velocity (k,) are accepted")
            jacobian, velocity = given
            found["secondary"] = (
                real_array(jacobian, "secondary", finite=False),
                real_array(velocity, "secondary", finite=False),
            )
        return found

    def at(self, t: Array, q: Array) -> dict[str, Any]:
        """The same at many times (k,) and configurations (k, n), on a leading axis."""
        if self.push is None and self.secondary is None:
            return {}
        each = [self.now(float(when), where) for when, where in zip(t, q, strict=True)]
        found: dict[str, Any] = {}
        if self.push is not None:
            found["push"] = np.stack([one["push"] for one in each])
        if self.secondary is not None:
            found["secondary"] = tuple(np.stack([one["secondary"][k] for one in each]) for k in (0, 1))
        return found


def number_of_steps(path: TaskPath, dt: float | None) -> int:
    """Into how many steps a path is divided.

    Raises:
        InputError: a step that is not positive, longer than the path's time, or so short that memory would not do.
    """
    if dt is None:
        return SAMPLES
    shortest = path.duration / MOST_STEPS
    if not shortest <= positive(dt, "dt") <= path.duration * (1.0 + 1e-9):
        raise InputError(
            f"dt: {dt:g} s; from {shortest:.3g} to {path.duration:g} s are accepted for a path that takes "
            f"{path.duration:g} s"
        )
    return max(1, round(path.duration / dt))


def gains(gain: float | Mapping[str, float] | None, criterion: str) -> dict[str, float]:
    """Gains by criterion."""
    if isinstance(gain, Mapping):
        return dict(gain)
    if criterion not in CRITERIA:
        raise InputError(f"criterion: {shown(criterion)}; {', '.join(CRITERIA)} are accepted")
    return {criterion: default_gain(criterion) if gain is None else real_number(gain, "gain")}


def check_criterion(arm: Arm, criterions: Iterable[str]) -> None:
    """Refuse the criterion "limits" for an arm that has none of both sides."""
    if "limits" in criterions and not np.isfinite(arm.limits.position).all(axis=1).any():
        raise InputError(f"{arm.name}: criterion 'limits': no joint has two limits; an arm that has is accepted")


def default_gain(criterion: str) -> float:
    """The gain when none is given: away from singularities, and from limits.

    >>> default_gain("H^(-1/2)"), default_gain("H")
    (-2.0, 2.0)
    """
    return 2.0 if criterion == "H" else -2.0


def both(feedback: float | Sequence[float] | None, dt: float) -> tuple[float, float]:
    """Feedback of position and orientation, 1/s."""
    if feedback is None:
        return (FEEDBACK / dt, FEEDBACK / dt)
    given = real_array(feedback, "feedback")
    if given.shape not in ((), (2,)) or (given < 0.0).any():
        raise InputError(f"feedback: {shown(feedback)}; a number, or two, not below 0, are accepted")
    pair = np.broadcast_to(given, 2)
    return (float(pair[0]), float(pair[1]))


def check_dimension(arm: Arm, path: TaskPath) -> None:
    """Refuse a path in space for an arm in the plane, and the other way round."""
    size = 2 if "x_alpha" in arm.tasks else 3
    if path.dimension != size:
        raise InputError(f"path: it has {path.dimension} coordinates; {size} are accepted for {arm.name}")


def orientation_of(arm: Arm, q: Array, dimension: int) -> Any:
    """A posture's own orientation, as a path takes it."""
    pose = arm.pose(q)
    return float(np.arctan2(pose[1, 0], pose[0, 0])) if dimension == 2 else pose[:3, :3]
