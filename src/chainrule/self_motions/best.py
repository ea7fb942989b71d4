"""The best posture at a target: the greatest value of a criterion over all curves of the self-motion."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.result import Component, SelfMotion

Array = NDArray[Any]
Criterion = Callable[[Array], Array]

#: Least number of intervals in which a curve is looked at, and how many halvings (by the golden section) follow.
INTERVALS, CUTS = 256, 48
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0


@dataclass(frozen=True)
class LocalBest:
    """A local maximum of a criterion on a curve.

    Attributes:
        value: of the criterion.
        q: (n,) the posture.
        curve: the index of the curve or arc among :attr:`SelfMotion.arcs`.
        s: where on it, as a fraction of its length.
    """

    value: float
    q: Array
    curve: int
    s: float

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers."""
        return {"value": self.value, "q": self.q.tolist(), "curve": self.curve, "s": self.s}


@dataclass(frozen=True)
class BestPosture:
    """The greatest value of a criterion over a self-motion, and every other local maximum.

    Attributes:
        criterion: its name.
        maxima: all local maxima, the best first; equal ones (within rounding) in the order of the curves.
        motion: the self-motion looked at; ``motion.complete`` says how sure it is that no curve is missing.
    """

    criterion: str
    maxima: tuple[LocalBest, ...]
    motion: SelfMotion

    @property
    def q(self) -> Array:
        """(n,) the best posture."""
        return self.maxima[0].q

    @property
    def value(self) -> float:
        """The greatest value."""
        return self.maxima[0].value

    @property
    def curve(self) -> int:
        """The index of the curve or arc of the best posture among ``motion.arcs``."""
        return self.maxima[0].curve

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists, without the curves."""
        return {
            "criterion": self.criterion,
            "complete": self.motion.complete,
            "maxima": [each.to_dict() for each in self.maxima],
        }


def best_posture(
    arm: Arm,
    target: Any,
    criterion: str | Criterion = "manipulability",
    task: str | None = None,
    *,
    limits: bool = True,
    **options: Any,
) -> BestPosture:
    """The posture at a target that maximises a criterion, over all curves and within the joint limits.

    Each curve is looked at in at least 256 places; every local maximum there is closed in on by the golden section, to
    about 1e-8 of the curve's length where the criterion is smooth (its value to rounding).

    Args:
        arm: as for :func:`chainrule.self_motion`.
        target: likewise; or a :class:`SelfMotion` found before.
        task: what is held; the arm's default task when absent.
        criterion: "manipulability", H = sqrt(det J J^T); "limits", the least distance of a joint from a limit over half
            its range (1 in the middle, 0 at a stop); or a function of configurations (k, n) that gives (k,) numbers.
        limits: whether the posture has to be within the arm's limits.
        options: of :func:`chainrule.self_motion`.

    Raises:
        InputError: an unknown criterion, one that gives something else than (k,) numbers, "limits" for an arm without;
            a target that no posture reaches, or none within the limits.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> best = cr.best_posture(arm, [1.0, 0.0])
        >>> round(best.value, 9), len(best.maxima)
        (0.734400168, 4)
    """
    if isinstance(target, SelfMotion):
        motion, task = target, target.task
    else:
        motion = self_motion(arm, target, task, limits=limits, **options)
    name, function = _criterion(arm, criterion, motion.task)
    parts = motion.arcs if limits else motion.components
    if not parts:
        where = "no posture within the limits reaches it" if motion.components else "no posture reaches it"
        raise InputError(f"{arm.name}: target {shown(np.asarray(motion.target).tolist())}: {where}")
    found = [best for k, part in enumerate(parts) for best in _maxima(part, k, function)]
    top = max(each.value for each in found)
    near = 1e-12 * max(abs(top), 1e-300)
    found.sort(key=lambda each: (-each.value if each.value < top - near else -math.inf, each.curve, each.s))
    return BestPosture(name, tuple(found), motion)


def _criterion(arm: Arm, criterion: str | Criterion, task: str) -> tuple[str, Criterion]:
    if criterion == "manipulability":
        return "manipulability", lambda q: arm.manipulability(q, task=task)
    if criterion == "limits":
        low, high = arm.limits.position.T
        limited = np.isfinite(low) & np.isfinite(high)
        if not limited.any():
            raise InputError(f"{arm.name}: criterion 'limits': no joint has two limits; an arm that has is accepted")
        low, half = low[limited], np.maximum(0.5 * (high - low)[limited], 1e-300)
        return "limits", lambda q: 1.0 - (np.abs(q[:, limited] - low - half) / half).max(axis=1)
    if not callable(criterion):
        raise InputError(f"criterion: {shown(criterion)}; 'manipulability', 'limits' or a function is accepted")
    given: Criterion = criterion

    def checked(q: Array) -> Array:
        values = np.asarray(given(q))
        if values.shape != (len(q),) or values.dtype.kind not in "iuf" or np.isnan(values).any():
            given_back = shown(values.tolist())
            raise InputError(f"criterion: of configurations {q.shape} it makes {given_back}; ({len(q)},) is accepted")
        return values.astype(float)

    return getattr(criterion, "__name__", "function"), checked


def _maxima(part: Component, index: int, function: Criterion) -> list[LocalBest]:
    """Every local maximum on one curve; ends of arcs count, and one point of a level stretch."""
    if len(part.q) < 2:
        return [LocalBest(float(function(part.q[:1])[0]), part.q[0], index, 0.0)]
    s = np.linspace(0.0, 1.0, max(INTERVALS, 2 * len(part.q)) + 1)
    values = function(part.at(s))
    if part.closed:
        before, after = np.roll(values[:-1], 1), np.roll(values[:-1], -1)
        values, places = values[:-1], s[:-1]
    else:
        before, after = np.append(-math.inf, values[:-1]), np.append(values[1:], -math.inf)
        places = s
    peaks = np.flatnonzero((values >= before) & (values > after))
    if not len(peaks):
        peaks = np.array([int(np.argmax(values))])  # constant along a closed curve
    step = s[1]
    low, high = places[peaks] - step, places[peaks] + step
    if not part.closed:
        low, high = np.maximum(low, 0.0), np.minimum(high, 1.0)

    def along(at: Array) -> Array:
        return function(part.at(at))

    best, value = places[peaks], values[peaks]
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    fa, fb = along(a), along(b)
    for _ in range(CUTS):
        for at, found in ((a, fa), (b, fb)):
            better = found > value
            best, value = np.where(better, at, best), np.where(better, found, value)
        left = fa >= fb
        low, high = np.where(left, low, a), np.where(left, b, high)
        if (high - low).max() < 1e-12:
            break
        inner = np.where(left, high - GOLDEN * (high - low), low + GOLDEN * (high - low))
        fresh = along(inner)
        a, b, fa, fb = (
            np.where(left, inner, b),
            np.where(left, a, inner),
            np.where(left, fresh, fb),
            np.where(left, fa, fresh),
        )
    q = part.at(best)
    return [
        LocalBest(float(v), row, index, float(np.mod(at, 1.0) if part.closed else at))
        for v, row, at in zip(value, q, best, strict=True)
    ]
