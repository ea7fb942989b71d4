"""Paths in the plane by arc length: where they go, how they bend, and the nearest point on them.

A path has at every arc length s a point r(s), a unit tangent T(s), a signed curvature k(s) (a left turn is positive)
and its rate dk/ds. Lines, arcs and circles are exact; curves by another parameter (:mod:`chainrule.parametric_paths`)
are measured by Gauss-Legendre quadrature and inverted once, to a relative 1e-13, when they are made.

A path knows nothing of arms. It must be smooth: a corner has no curvature, and none is accepted.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array

Array = NDArray[Any]

#: Gauss-Legendre nodes in a panel, and coefficients of the inverse u(s) in it.
_NODES = 16
_GAUSS, _WEIGHTS = np.polynomial.legendre.leggauss(_NODES)
#: Relative accuracy of the arc length and of its inverse; panels are halved until it is reached.
ARC_ACCURACY = 1e-13
_MOST_PANELS = 4096
#: Coordinates and lengths are accepted up to this, and lengths down to its inverse.
LARGEST = 1e40


class Frame(NamedTuple):
    """A path at some arc lengths.

    Attributes:
        point: (..., 2) in m.
        tangent: (..., 2), of unit length.
        curvature: (...,) in 1/m, positive for a left turn.
        curvature_rate: (...,) dk/ds in 1/m^2.
    """

    point: Array
    tangent: Array
    curvature: Array
    curvature_rate: Array


class Nearest(NamedTuple):
    """The nearest points of a path.

    Attributes:
        s: (...,) their arc lengths in m.
        distance: (...,) in m.
        side: (...,) 1 where the point asked for lies on the left of the path, or on it; -1 on the right.
    """

    s: Array
    distance: Array
    side: Array


class Foot(NamedTuple):
    """Feet of points on a path.

    Attributes:
        s: (...,) arc lengths.
        offset: (...,) signed distances of the points from the path, left positive.
        tangent: (..., 2) of the path at the feet.
    """

    s: Array
    offset: Array
    tangent: Array


def cross(a: Array, b: Array) -> Array:
    """The z component of a x b for vectors (..., 2)."""
    found: Array = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return found


def left(a: Array) -> Array:
    """Vectors (..., 2) turned a quarter to the left."""
    return np.stack([-a[..., 1], a[..., 0]], axis=-1)


def dot(a: Array, b: Array) -> Array:
    """The scalar product over the last axis."""
    found: Array = (a * b).sum(axis=-1)
    return found


def arc_frame(start: Array, tangent: Array, curvature: Any, s: Any) -> Frame:
    """Curves of constant curvature at arc length s: straight lines too, without cancellation. All axes broadcast."""
    turn = curvature * s
    along, across = s * np.sinc(turn / np.pi), 0.5 * turn * s * np.sinc(0.5 * turn / np.pi) ** 2
    cosine, sine = np.cos(turn)[..., None], np.sin(turn)[..., None]
    normal = left(tangent)
    point = start + along[..., None] * tangent + across[..., None] * normal
    direction = cosine * tangent + sine * normal
    shape = point.shape[:-1]
    return Frame(point, direction, np.broadcast_to(curvature, shape), np.zeros(shape))


def arc_locate(start: Array, tangent: Array, curvature: Any, points: Array, s: Array) -> Foot:
    """Feet (nearest turn to ``s``) on curves of constant curvature.

    offset = w / (k (1 + sqrt(1 - w))) with w = 2 k v - k^2 (u^2 + v^2): exact at k = 0 too, where it is v.
    """
    away = points - start
    u, v = dot(away, tangent), cross(tangent, away)
    twice = 2.0 * v - curvature * (u**2 + v**2)
    offset = twice / (1.0 + np.sqrt(np.maximum(1.0 - curvature * twice, 0.0)))
    reach = 1.0 - curvature * v
    turn = np.arctan2(curvature * u, reach)
    bent = np.abs(curvature * u) + np.abs(np.minimum(reach, 0.0)) > 1e-9  # else u / reach is right to 1e-18
    safe = np.where(bent, curvature, 1.0)
    foot = np.where(bent, turn / safe, u / np.where(bent, 1.0, reach))
    around = 2.0 * np.pi / np.where(curvature != 0.0, curvature, 1.0)
    foot = foot + np.where(curvature != 0.0, np.round((s - foot) / around), 0.0) * around
    cosine, sine = np.cos(curvature * foot)[..., None], np.sin(curvature * foot)[..., None]
    return Foot(foot, offset, cosine * tangent + sine * left(tangent))


class Path(ABC):
    """A smooth path in the plane by arc length.

    Closed paths repeat: s and s + length are one point. An open path goes straight on beyond its ends.

    Attributes:
        length: arc length in m.
        closed: whether it ends where it begins, in the same direction.
        max_curvature: no curvature on it is larger in magnitude, 1/m (exact for lines, arcs, circles and ellipses;
            2 % above the largest of dense samples for the rest).
    """

    length: float
    closed: bool
    max_curvature: float

    @abstractmethod
    def to_dict(self) -> dict[str, Any]:
        """Plain values: the kind and what it was made from."""

    @abstractmethod
    def _inside(self, s: Array) -> Frame:
        """The frame at arc lengths from 0 to the length."""

    # ---- what it is at an arc length ---------------------------------------------------------------------------

    def frame(self, s: Any) -> Frame:
        """Point, tangent, curvature and its rate at arc lengths s (...,) in m.

        Raises:
            InputError: s is not finite numbers.
        """
        return self.at(real_array(s, "s"))

    def at(self, s: Array) -> Frame:
        """:meth:`frame` without checks, for loops."""
        if self.closed:
            return self._inside(np.mod(s, self.length))
        inside = np.clip(s, 0.0, self.length)
        found = self._inside(inside)
        beyond = s - inside
        if not beyond.any():
            return found
        curved = beyond == 0.0
        return Frame(
            found.point + beyond[..., None] * found.tangent,
            found.tangent,
            np.where(curved, found.curvature, 0.0),
            np.where(curved, found.curvature_rate, 0.0),
        )

    def point(self, s: Any) -> Array:
        """r(s) (..., 2) in m."""
        return self.frame(s).point

    def tangent(self, s: Any) -> Array:
        """The unit tangent (..., 2)."""
        return self.frame(s).tangent

    def curvature(self, s: Any) -> Array:
        """The signed curvature (...,) in 1/m; a left turn is positive."""
        return self.frame(s).curvature

    def curvature_rate(self, s: Any) -> Array:
        """dk/ds (...,) in 1/m^2."""
        return self.frame(s).curvature_rate

    # ---- the nearest point -------------------------------------------------------------------------------------

    def nearest(self, points: Any, near: Any = None) -> Nearest:
        """The nearest point of the path to each of ``points`` (..., 2).

        Args:
            points: (..., 2) in m.
            near: arc lengths (...,) to look near: the foot that a point moving away from r(near) keeps, so that a path
                that crosses itself or comes back close by does not make it jump. On a closed path the answer continues
                ``near`` and may leave [0, length]. Without it the whole path is searched, and the nearest of all wins.

        Raises:
            InputError: a wrong shape, or numbers that are not finite.

        Example:
            >>> circle = Circle((0.0, 0.0), 1.0)
            >>> found = circle.nearest([0.0, 1.5])
            >>> float(found.s.round(6)), float(found.distance.round(6)), float(found.side)
            (1.570796, 0.5, -1.0)
        """
        given = real_array(points, "points")
        if given.ndim < 1 or given.shape[-1] != 2:
            raise InputError(f"points: shape {given.shape}; (..., 2) is accepted")
        if near is None:
            s = self._search(given.reshape(-1, 2)).reshape(given.shape[:-1])
        else:
            try:
                start = np.broadcast_to(real_array(near, "near"), given.shape[:-1])
            except ValueError:
                raise InputError(f"near: shape {np.shape(near)} does not fit {given.shape[:-1]} points") from None
            s = self.locate(given, start).s
        if not self.closed:
            s = np.clip(s, 0.0, self.length)
        frame = self.at(s)
        away = given - frame.point
        side = np.where(cross(frame.tangent, away) < 0.0, -1.0, 1.0)
        return Nearest(s, np.hypot(away[..., 0], away[..., 1]), side)

    def locate(self, points: Array, s: Array) -> Foot:
        """The feet near ``s`` of points (..., 2); without checks.

        Newton's method on (p - r).T = 0, whose derivative by s is -(1 - k offset). Beyond the ends of an open path the
        foot lies on the straight continuation.
        """
        most = 0.25 / max(self.max_curvature, 1.0 / self.length)
        enough = 1e-9 / max(self.max_curvature, 1.0 / self.length)  # one more step squares it
        s = np.array(s, dtype=float)
        frame = self.at(s)
        for _ in range(60):
            away = points - frame.point
            slope = np.maximum(1.0 - frame.curvature * cross(frame.tangent, away), 0.05)
            step = np.minimum(np.maximum(dot(away, frame.tangent) / slope, -most), most)
            s = s + step
            frame = self.at(s)
            if not np.any(np.abs(step) > enough):
                break
        return Foot(s, cross(frame.tangent, points - frame.point), frame.tangent)

    def _search(self, points: Array) -> Array:
        """Arc lengths (k,) of the nearest points of all.

        The distance changes by no more than the arc length does, so the nearest point lies beside a sample that is no
        farther than the nearest sample plus half the spacing: each such valley of the samples is refined.
        """
        count = int(np.clip(16.0 * self.length * max(self.max_curvature, 1.0 / self.length), 64, 20_000))
        grid = np.linspace(0.0, self.length, count, endpoint=not self.closed)
        samples = self.at(grid).point
        spacing = self.length / (count - (not self.closed))
        best = np.empty(len(points))
        for first in range(0, len(points), 256):
            block = points[first : first + 256]
            distance = np.linalg.norm(block[:, None] - samples, axis=2)
            before, after = np.roll(distance, 1, axis=1), np.roll(distance, -1, axis=1)
            if not self.closed:
                before[:, 0] = after[:, -1] = np.inf
            low = distance.min(axis=1, keepdims=True)
            which, where = np.nonzero(
                (distance <= before) & (distance <= after) & (distance <= low + 0.5001 * spacing + 1e-12 * self.length)
            )
            s = self.locate(block[which], grid[where]).s
            s = np.clip(s, grid[where] - spacing, grid[where] + spacing)
            s = np.mod(s, self.length) if self.closed else np.clip(s, 0.0, self.length)
            gap = np.linalg.norm(block[which] - self.at(s).point, axis=1)
            order = np.lexsort((s, gap, which))
            _, leading = np.unique(which[order], return_index=True)
            best[first : first + 256] = s[order][leading]
        return best


# ---- curves of constant curvature ------------------------------------------------------------------------------


class Arc(Path):
    """A curve of constant curvature: from ``start`` along ``tangent``; a straight line where the curvature is 0.

    Args:
        start: (x, y) in m.
        tangent: (x, y), any length but zero.
        curvature: 1/m, positive for a left turn.
        length: m, positive.

    Raises:
        InputError: naming what is wrong.

    Example:
        >>> Arc((0.0, 0.0), (1.0, 0.0), curvature=1.0, length=1.0).point(1.0).round(4)
        array([0.8415, 0.4597])
    """

    closed = False

    def __init__(self, start: Sequence[float], tangent: Sequence[float], curvature: float, length: float) -> None:
        self.start = pair(start, "start")
        self.direction = unit(pair(tangent, "tangent"), "tangent")
        self.bend = bounded_number(curvature, "curvature")
        self.length = positive_number(length, "length")
        self.max_curvature = abs(self.bend)

    def _inside(self, s: Array) -> Frame:
        return arc_frame(self.start, self.direction, np.float64(self.bend), s)

    def locate(self, points: Array, s: Array) -> Foot:
        """As :meth:`Path.locate`, in closed form on the curve itself."""
        foot = arc_locate(self.start, self.direction, np.float64(self.bend), points, np.asarray(s, float))
        if self.closed or not np.any((foot.s < 0.0) | (foot.s > self.length)):
            return foot
        return super().locate(points, s)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "kind": "arc",
            "start": self.start.tolist(),
            "tangent": self.direction.tolist(),
            "curvature": self.bend,
            "length": self.length,
        }


class Line(Arc):
    """The straight line from ``start`` to ``end``, both (x, y) in m.

    Raises:
        InputError: the two are one point.

    Example:
        >>> Line((0.0, 0.0), (3.0, 4.0)).length
        5.0
    """

    def __init__(self, start: Sequence[float], end: Sequence[float]) -> None:
        first, last = pair(start, "start"), pair(end, "end")
        if np.array_equal(first, last):
            raise InputError(f"start and end are both ({first[0]:g}, {first[1]:g}); two points are accepted")
        super().__init__(first.tolist(), (last - first).tolist(), 0.0, math.hypot(*(last - first)))
        self.end = last

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"kind": "line", "start": self.start.tolist(), "end": self.end.tolist()}


class Circle(Arc):
    """The circle about ``centre``, once around.

    Args:
        centre: (x, y) in m.
        radius: m, positive.
        start: angle from the x axis, in rad, of the point where s = 0.
        clockwise: whether it turns right.

    Raises:
        InputError: naming what is wrong.

    Example:
        >>> float(Circle((1.0, 0.0), 0.5).curvature(0.0))
        2.0
    """

    closed = True

    def __init__(self, centre: Sequence[float], radius: float, *, start: float = 0.0, clockwise: bool = False) -> None:
        self.centre = pair(centre, "centre")
        self.radius = positive_number(radius, "radius")
        self.start_angle = bounded_number(start, "start")
        self.clockwise = bool(clockwise)
        turn = -1.0 if self.clockwise else 1.0
        c, s = math.cos(self.start_angle), math.sin(self.start_angle)
        first = self.centre + self.radius * np.array([c, s])
        super().__init__(first.tolist(), (-turn * s, turn * c), turn / self.radius, 2.0 * math.pi * self.radius)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "kind": "circle",
            "centre": self.centre.tolist(),
            "radius": self.radius,
            "start": self.start_angle,
            "clockwise": self.clockwise,
        }


# ---- arc length by another parameter ---------------------------------------------------------------------------


class ArcLength:
    """The arc length of a curve by its own parameter u, and the inverse, measured by panels to a relative 1e-13.

    In each panel the arc length from its start is a Gauss-Legendre sum, and u(s) a Chebyshev series.

    Args:
        speed: |dr/du| at u (...,), of the same shape.
        breaks: (k,) rising values of u: both ends, and the places between where r is not smooth to all orders.

    Attributes:
        length: m.
        edges: (p + 1,) u where panels meet.

    Raises:
        InputError: the curve is not smooth enough between the breaks.

    Example:
        >>> ArcLength(lambda u: 2.0 * u, np.array([1.0, 2.0])).parameter(np.array([1.25])).round(12)
        array([1.5])
    """

    def __init__(self, speed: Callable[[Array], Array], breaks: Array) -> None:
        self.edges, lengths, self._series = _panels(speed, breaks)
        self._marks = np.concatenate([[0.0], np.cumsum(lengths)])
        self.length = float(self._marks[-1])

    def parameter(self, s: Array) -> Array:
        """The curve's own parameter at arc lengths from 0 to the length."""
        panel = np.searchsorted(self._marks[1:-1], s, side="right")
        low, high = self._marks[panel], self._marks[panel + 1]
        x = np.minimum(np.maximum((2.0 * s - low - high) / (high - low), -1.0), 1.0)
        return _chebyshev_sum(self._series[panel], x)


def _panels(speed: Callable[[Array], Array], breaks: Array) -> tuple[Array, Array, Array]:
    """Panel edges (p + 1,), their arc lengths (p,), and Chebyshev series (p, m) of u over s, by halving."""
    todo = np.stack([breaks[:-1], breaks[1:]], axis=1)
    done: list[tuple[Array, Array, Array]] = []
    total = float(_lengths(speed, todo[:, 0], todo[:, 1]).sum())
    while len(todo):
        low, high = todo.T
        middle = 0.5 * (low + high)
        whole = _lengths(speed, low, high)
        halves = _lengths(speed, low, middle) + _lengths(speed, middle, high)
        series, error = _inverse(speed, low, high, whole)
        good = (np.abs(whole - halves) <= ARC_ACCURACY * total) & (error <= ARC_ACCURACY * total)
        done.append((todo[good], whole[good], series[good]))
        bad = todo[~good]
        if sum(len(part[0]) for part in done) + 2 * len(bad) > _MOST_PANELS:
            raise InputError("the curve is not smooth enough to be measured (a corner, a cusp or too much detail)")
        centre = bad.mean(axis=1)
        todo = np.concatenate([np.stack([bad[:, 0], centre], axis=1), np.stack([centre, bad[:, 1]], axis=1)])
    parts, lengths, series = (np.concatenate(column) for column in zip(*done, strict=True))
    order = np.argsort(parts[:, 0])
    return np.append(parts[order, 0], parts[order[-1], 1]), lengths[order], series[order]


def _lengths(speed: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """Arc lengths between u = low and u = high, (...,): one Gauss-Legendre sum each."""
    half = 0.5 * (high - low)[..., None]
    found: Array = (speed(low[..., None] + half * (1.0 + _GAUSS)) * half) @ _WEIGHTS
    return found


def _inverse(speed: Callable[[Array], Array], low: Array, high: Array, length: Array) -> tuple[Array, Array]:
    """Chebyshev series (p, m) of u over the arc length in each panel, and the arc length each misses."""
    x = np.cos(np.pi * (np.arange(_NODES) + 0.5) / _NODES)
    basis = np.cos(np.outer(np.arange(_NODES), np.arccos(x)))
    series = 2.0 / _NODES * _inverted(speed, low, high, length, x) @ basis.T
    series[:, 0] *= 0.5
    between = np.linspace(-0.99, 0.99, 9)
    u = _chebyshev_sum(series[:, None, :], np.broadcast_to(between, (len(low), 9)))
    error = np.abs(_lengths(speed, np.broadcast_to(low[:, None], u.shape), u) - 0.5 * length[:, None] * (1.0 + between))
    return series, np.where(length > 0.0, error.max(axis=1), 0.0)


def _inverted(speed: Callable[[Array], Array], low: Array, high: Array, length: Array, x: Array) -> Array:
    """u (p, m) where the arc length from ``low`` is the share (1 + x) / 2 of the panel's, by Newton's method."""
    goal = 0.5 * length[:, None] * (1.0 + x)
    begin, end = (np.broadcast_to(edge[:, None], goal.shape) for edge in (low, high))
    u: Array = begin + (end - begin) * 0.5 * (1.0 + x)
    for _ in range(20):
        rate = np.maximum(speed(u), 1e-300)
        step = (_lengths(speed, begin, u) - goal) / rate
        u = np.clip(u - step, begin, end)
        if np.all(np.abs(step) <= 4e-16 * np.abs(end - begin)):
            break
    return u


def _chebyshev_sum(series: Array, x: Array) -> Array:
    """Chebyshev series with coefficients on the last axis, each at its own x: T_k(x) = cos(k arccos x)."""
    found: Array = (series * np.cos(np.arccos(x)[..., None] * np.arange(series.shape[-1]))).sum(axis=-1)
    return found


# ---- what was given --------------------------------------------------------------------------------------------


def real_number(value: Any, what: str) -> float:
    """One finite number, no array.

    Raises:
        InputError: anything else.

    Example:
        >>> real_number(2, "radius")
        2.0
    """
    try:
        array = real_array(value, what)
    except InputError:
        array = np.empty(1)
    if array.ndim:
        raise InputError(f"{what}: {shown(value)}; one finite number is accepted")
    return float(array)


def unit(vectors: Array, what: str) -> Array:
    """Vectors (..., 2) of length 1, for any length but zero, however small or large.

    Raises:
        InputError: one of them is zero.
    """
    size = np.abs(vectors).max(axis=-1, keepdims=True)
    if not (size > 0.0).all():
        raise InputError(f"{what}: (0, 0); a direction is accepted")
    scaled = vectors / size
    found: Array = scaled / np.hypot(scaled[..., :1], scaled[..., 1:])
    return found


def bounded(array: Array, what: str) -> Array:
    """Lengths and coordinates whose powers stay within the range of doubles."""
    if np.abs(array).max(initial=0.0) > LARGEST:
        raise InputError(f"{what}: {np.abs(array).max():.3g} is too large; magnitudes up to {LARGEST:g} are accepted")
    return array


def bounded_number(value: Any, what: str) -> float:
    """One coordinate, angle or curvature."""
    return float(bounded(np.asarray(real_number(value, what)), what))


def positive_number(value: Any, what: str) -> float:
    """One length above 0."""
    number = bounded_number(value, what)
    if not number >= 1.0 / LARGEST:
        raise InputError(f"{what}: {number:g}; a positive number is accepted")
    return number


def pair(value: Any, what: str) -> Array:
    """One point or direction, (2,)."""
    array = real_array(value, what)
    if array.shape != (2,):
        raise InputError(f"{what}: {shown(value)}; two numbers (x, y) are accepted")
    return bounded(array, what)
