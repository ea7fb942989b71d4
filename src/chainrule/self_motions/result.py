"""What is known of the self-motion at one target: its curves, each with length, winding, box and manipulability.

Example:
    >>> import numpy as np
    >>> turning = Component(
    ...     q=np.array([[0.0], [np.pi], [2 * np.pi]]), length=2 * np.pi, closed=True, winding=np.array([1]),
    ...     box=np.array([[0.0, 2 * np.pi]]), manipulability=(1.0, 1.0), residual=0.0, closure=0.0,
    ... )
    >>> turning.at([0.25])
    array([[1.57079633]])
    >>> turning.turns_freely(1)
    True
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array

Array = NDArray[Any]

#: The most points of a curve that can be asked for.
MOST_POINTS = 100_000

#: What each status means.
STATUSES = {
    "regular": "every point of every curve is regular: the curves are smooth and apart from one another",
    "singular": "the target is a singular value: curves touch, or have shrunk to points; `detail` says how",
    "unreachable": "no posture reaches the target",
}
#: Why a traced curve ends; "limit of joint 4 (upper)" and the like come from :func:`limit_reason`.
ENDS = {
    "closed": "the curve returned to its start",
    "length": "the greatest length asked for was reached",
    "singular": "the manipulability fell below the stated share of its scale: the curve may branch there",
    "steps": "the greatest number of steps was reached",
    "stuck": "no step, however small, satisfied the guard against jumps",
}


def limit_reason(joint: int, upper: bool) -> str:
    """The words for a curve that ends at a limit of ``joint`` (from 1).

    >>> limit_reason(4, True)
    'limit of joint 4 (upper)'
    """
    return f"limit of joint {joint} ({'upper' if upper else 'lower'})"


@dataclass(frozen=True)
class Component:
    """One curve of a self-motion: a closed one, or an arc of one.

    Attributes:
        q: (k, n) points along the curve in order, unwrapped; a closed curve's last point is its first plus 2 pi times
            the winding numbers. An isolated point has one row.
        length: Euclidean in joint space, rad; with prismatic joints of sqrt(dq_R^2 + (dq_P / L)^2), L = ``scale``.
        closed: whether the curve returns to its start.
        winding: (n,) how many times each joint turns round; 0 for prismatic joints and for arcs.
        box: (n, 2) least and greatest value of each unwrapped joint; a joint that winds once spans 2 pi or more.
        manipulability: least and greatest value of H = sqrt(det J J^T) on the curve.
        residual: the largest error of the task at the points of ``q``, in the task's units.
        closure: how far from its start the curve closed (largest difference, rad), 0 where it closes by construction;
            nan for arcs.
        ends: of an arc, why its beginning and its end are there (:data:`ENDS`, or :func:`limit_reason`); of a closed
            curve, empty.
        signs: quantities that keep their sign all along, e.g. ``{"q3": 1}``.
        of: of a feasible arc, the index of the curve it is part of; else None.
        span: of a feasible arc, where it begins and ends on that curve, as fractions of its length; an arc across the
            curve's start ends above 1.
        scale: m per rad, weighs prismatic joints in lengths; 1 where there are none.
        points: the curve as a function of fractions of its length; None where only ``q`` is known.
    """

    q: Array
    length: float
    closed: bool
    winding: Array
    box: Array
    manipulability: tuple[float, float]
    residual: float
    closure: float
    ends: tuple[str, ...] = ()
    signs: Mapping[str, int] = field(default_factory=dict)
    of: int | None = None
    span: tuple[float, float] = (0.0, 1.0)
    scale: float = 1.0
    points: Callable[[Array], Array] | None = field(default=None, repr=False, compare=False)

    @property
    def joints(self) -> int:
        """Number of joints."""
        return int(self.q.shape[-1])

    def at(self, s: ArrayLike) -> Array:
        """(..., n): the points at fractions ``s`` of the length, unwrapped: s = 0 is the first point, 1 the last.

        On a closed curve ``s`` may be any number (one round is 1, and adds 2 pi times the winding numbers).

        Raises:
            InputError: on an arc, s outside 0 to 1; anything that is not finite.
        """
        fractions = real_array(s, "s")
        if self.closed:
            rounds = np.floor(fractions)
            rounds = np.where((fractions == rounds) & (rounds == 1.0), 0.0, rounds)  # 1 itself is the last point
            inside = fractions - rounds
        else:
            if fractions.size and (fractions.min() < 0.0 or fractions.max() > 1.0):
                raise InputError(f"s: {shown(float(fractions.max()))}; fractions from 0 to 1 of an arc's length")
            rounds, inside = np.zeros_like(fractions), fractions
        found = self.points(inside) if self.points is not None else self._between(inside)
        return np.asarray(found + 2.0 * math.pi * rounds[..., np.newaxis] * self.winding)

    def _between(self, s: Array) -> Array:
        """Linear interpolation of ``q`` by chord length."""
        if len(self.q) < 2:
            return np.broadcast_to(self.q[0], (*s.shape, self.joints)).copy()
        chords = np.linalg.norm(np.diff(self.q, axis=0), axis=1)
        along = np.concatenate([[0.0], np.cumsum(chords)]) / chords.sum()
        return np.stack([np.interp(s, along, column) for column in self.q.T], axis=-1)

    def turns_freely(self, joint: int) -> bool:
        """Whether ``joint`` (from 1) can be turned all the way round along this curve.

        A joint that swings over 2 pi or more without winding reaches every angle too, and counts.
        """
        if joint not in range(1, self.joints + 1):
            raise InputError(f"joint: {shown(joint)}; a joint from 1 to {self.joints} is accepted")
        low, high = self.box[joint - 1]
        return bool(high - low >= 2.0 * math.pi * (1.0 - 1e-12))

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists; infinite and undefined numbers are None."""
        return {
            "length": _plain(self.length),
            "closed": self.closed,
            "winding": [int(turns) for turns in self.winding],
            "box": [[_plain(low), _plain(high)] for low, high in self.box],
            "manipulability": [_plain(value) for value in self.manipulability],
            "residual": _plain(self.residual),
            "closure": _plain(self.closure),
            "ends": list(self.ends),
            "signs": dict(self.signs),
            "of": self.of,
            "span": [_plain(value) for value in self.span],
            "scale": _plain(self.scale),
            "q": self.q.tolist(),
        }


@dataclass(frozen=True)
class SelfMotion:
    """Every known curve of joint space on which the tip rests at one target.

    Attributes:
        arm: name of the arm.
        task: the task held.
        target: the target held, as given.
        method: how the curves were found: "closed form", "sweep", "continuation" or "eigenvector".
        status: a key of :data:`STATUSES`.
        detail: of a status, what exactly: "figure of eight", "isolated point", "free first joint"; empty where regular.
        components: the curves, joints unlimited.
        complete: "proved", or "N starts and M extremal points of joints, last new component at start k".
        feasible: what of the curves is within the arm's joint limits: whole loops and arcs, each with ``of`` and
            ``span``; None where limits were not asked for or the arm has none.
        to_singular: distance of the target to the nearest singular value of the task, in its units; None if not known.
    """

    arm: str
    task: str
    target: Array
    method: str
    status: str
    components: tuple[Component, ...]
    complete: str
    detail: str = ""
    feasible: tuple[Component, ...] | None = None
    to_singular: float | None = None

    @property
    def count(self) -> int:
        """Number of curves, joints unlimited."""
        return len(self.components)

    @property
    def length(self) -> float:
        """Length of all curves together, joints unlimited."""
        return math.fsum(component.length for component in self.components)

    @property
    def arcs(self) -> tuple[Component, ...]:
        """The feasible curves and arcs; where limits are not considered, the curves."""
        return self.components if self.feasible is None else self.feasible

    @property
    def surviving(self) -> tuple[int, ...]:
        """Indices of the curves that lie within the limits as a whole."""
        if self.feasible is None:
            return tuple(range(self.count))
        return tuple(part.of for part in self.feasible if part.closed and part.of is not None)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists; infinite and undefined numbers are None."""
        return {
            "arm": self.arm,
            "task": self.task,
            "target": self.target.tolist(),
            "method": self.method,
            "status": self.status,
            "detail": self.detail,
            "complete": self.complete,
            "count": self.count,
            "length": _plain(self.length),
            "to_singular": None if self.to_singular is None else _plain(self.to_singular),
            "components": [component.to_dict() for component in self.components],
            "feasible": None if self.feasible is None else [part.to_dict() for part in self.feasible],
        }


def _plain(value: float) -> float | None:
    """``value`` as JSON knows it."""
    return float(value) if math.isfinite(value) else None
