"""When a path is where: the share of the path that is behind at time t, and how fast it grows."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import real_number
from chainrule.timing import JointMove, min_time

Array = NDArray[Any]


class TimeLaw(ABC):
    """The share of a path, from 0 to 1, by time.

    Attributes:
        duration: s.
    """

    duration: float

    @abstractmethod
    def at(self, t: Array) -> tuple[Array, Array]:
        """The share and its rate (1/s) at times t (k,) from 0 to the duration."""

    @abstractmethod
    def to_dict(self) -> dict[str, Any]:
        """Plain values."""


class Constant(TimeLaw):
    """Constant speed from the first moment to the last.

    Args:
        duration: s.

    Example:
        >>> Constant(2.0).at(np.array([0.5]))
        (array([0.25]), array([0.5]))
    """

    def __init__(self, duration: float) -> None:
        self.duration = positive(duration, "duration")

    def at(self, t: Array) -> tuple[Array, Array]:
        """As :meth:`TimeLaw.at`."""
        return t / self.duration, np.full_like(t, 1.0 / self.duration)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"law": "constant", "duration": self.duration}


class Trapezoid(TimeLaw):
    """From rest to rest: a constant acceleration, a constant speed, the same acceleration back.

    Args:
        speed: the largest rate of the share, 1/s.
        acceleration: of the share, 1/s^2.

    Example:
        >>> law = Trapezoid(1.0, 2.0)
        >>> law.duration, [part.tolist() for part in law.at(np.array([0.25, 0.75]))]
        (1.5, [[0.0625, 0.5], [0.5, 1.0]])
    """

    def __init__(self, speed: float, acceleration: float) -> None:
        self.speed = positive(speed, "speed")
        self.acceleration = positive(acceleration, "acceleration")
        self.duration = float(self._move.duration)

    @cached_property
    def _move(self) -> JointMove:
        return min_time([0.0], [1.0], [self.speed], [self.acceleration])

    @classmethod
    def lasting(cls, duration: float, ramp: float) -> Trapezoid:
        """The one of a duration (s) whose two ramps last ``ramp`` (s) each.

        Raises:
            InputError: ramps longer than half of the duration.
        """
        whole, part = positive(duration, "duration"), positive(ramp, "ramp")
        if not part <= whole / 2.0:
            raise InputError(f"ramp: {part:g} s; up to half of the duration, {whole / 2.0:g} s, is accepted")
        speed = 1.0 / (whole - part)
        return cls(speed, speed / part)

    def at(self, t: Array) -> tuple[Array, Array]:
        """As :meth:`TimeLaw.at`."""
        state = self._move.sample(t)
        return state.position[..., 0], state.velocity[..., 0]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"law": "trapezoid", "duration": self.duration, "speed": self.speed, "acceleration": self.acceleration}


class Sampled(TimeLaw):
    """Given shares at given times, by the monotone cubic through them.

    Args:
        t: (k,) rising from 0, s.
        share: (k,) from 0 to 1, not falling.

    Raises:
        InputError: other arrays.

    Example:
        >>> Sampled([0.0, 1.0, 2.0], [0.0, 0.25, 1.0]).at(np.array([1.0]))[0]
        array([0.25])
    """

    def __init__(self, t: Any, share: Any) -> None:
        from scipy.interpolate import PchipInterpolator

        times, shares = real_array(t, "t"), real_array(share, "share")
        if times.ndim != 1 or len(times) < 2 or times[0] != 0.0 or not (np.diff(times) > 0.0).all():
            raise InputError("t: two times or more that rise from 0 are accepted")
        if shares.shape != times.shape or shares[0] != 0.0 or shares[-1] != 1.0 or not (np.diff(shares) >= 0.0).all():
            raise InputError(f"share: {len(times)} numbers from 0 to 1, none less than the one before, are accepted")
        self.duration = float(times[-1])
        self.times, self.shares = times, shares
        self._share = PchipInterpolator(times, shares)
        self._rate = self._share.derivative()

    def at(self, t: Array) -> tuple[Array, Array]:
        """As :meth:`TimeLaw.at`."""
        return np.clip(self._share(t), 0.0, 1.0), np.maximum(self._rate(t), 0.0)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"law": "samples", "t": self.times.tolist(), "share": self.shares.tolist()}


def timed(
    length: float,
    *,
    duration: float | None = None,
    speed: float | None = None,
    acceleration: float | None = None,
    ramp: float | None = None,
    law: TimeLaw | None = None,
) -> TimeLaw:
    """The time law that is meant: ``constant, or from rest to rest with ``ramp`` or ``acceleration``.

    Args:
        length: of the path, m; speeds are along it.
        duration: s.
        speed: m/s along the path.
        acceleration: m/s^2 along the path.
        ramp: how long speeding up lasts, and slowing down, s.
        law: one that is ready.

    Raises:
        InputError: another combination.
    """
    given = {
        name
        for name, value in (
            *(("duration", duration), ("speed", speed), ("acceleration", acceleration)),
            *(("ramp", ramp), ("law", law)),
        )
        if value is not None
    }
    if given & {"speed", "acceleration"} and not length > 0.0:
        raise InputError("speed: the path has no length; a duration is accepted")
    match sorted(given):
        case ["law"]:
            if not isinstance(law, TimeLaw):
                raise InputError(f"law: {shown(law)}; a TimeLaw is accepted, such as Sampled(t, share)")
            return law
        case ["duration"]:
            assert duration is not None
            return Constant(duration)
        case ["speed"]:
            return Constant(length / positive(speed, "speed"))
        case ["duration", "ramp"]:
            assert duration is not None and ramp is not None
            return Trapezoid.lasting(duration, ramp)
        case ["acceleration", "speed"]:
            return Trapezoid(positive(speed, "speed") / length, positive(acceleration, "acceleration") / length)
    said = f"{', '.join(sorted(given))} given" if given else "nothing given"
    raise InputError(
        f"the time law: {said}; duration, or speed, or duration and ramp, or speed and acceleration, or law is accepted"
    )


def positive(value: Any, what: str) -> float:
    """One positive number.

    Raises:
        InputError: anything else.
    """
    number = real_number(value, what)
    if not number > 0.0:
        raise InputError(f"{what}: {number:g}; a positive number is accepted")
    return number
