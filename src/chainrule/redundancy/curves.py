"""Curves in space or in the plane by a parameter u from 0 to 1: where they go, with two exact derivatives.

What :mod:`chainrule.paths` knows by arc length in the plane is placed in space by :class:`Placed`; the others here know
no plane: conics by their angle, polynomial pieces (lines, polylines with rounded corners) and splines.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import ArcLength, Path, left
from chainrule.redundancy.time_laws import positive
from chainrule.scaling import JointPath, polyline, rounded

Array = NDArray[Any]

#: Points given, at most.
MOST = 10_000
#: Points nearer to each other than this share of the whole are one.
NEAR = 1e-9
#: The end meets the beginning within this share of the length.
MEETS = 1e-9


class SpaceCurve(ABC):
    """A curve r(u), 0 <= u <= 1.

    Attributes:
        steady: whether |dr/du| is constant, so that u is the share of the arc length.
        breaks: (k,) rising values of u from 0 to 1 between which r is smooth to all orders.
        normal: (3,) of the plane a spatial curve lies in, where it has one.
    """

    steady: bool = False
    breaks: Array = np.linspace(0.0, 1.0, 17)
    normal: Array | None = None

    @abstractmethod
    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """r, dr/du and d2r/du2 at u (k,), each (k, d) in m."""

    @property
    def dimension(self) -> int:
        """d: 3 in space, 2 in the plane."""
        return int(self.at(np.zeros(1))[0].shape[1])

    def speed(self, u: Array) -> Array:
        """|dr/du| at u (...,), in m."""
        flat = np.asarray(u, float).ravel()
        return np.asarray(np.linalg.norm(self.at(flat)[1], axis=1).reshape(np.shape(u)))

    @cached_property
    def length(self) -> float:
        """Arc length, m; 0 for a point."""
        return float(self.speed(np.zeros(1))[0]) if self.steady else self._arc.length

    @property
    def closed(self) -> bool:
        """Whether the end is the beginning."""
        ends = self.at(np.array([0.0, 1.0]))[0]
        return bool(np.linalg.norm(ends[1] - ends[0]) <= MEETS * max(self.length, 1e-300))

    @cached_property
    def _arc(self) -> ArcLength:
        return ArcLength(self.speed, self.breaks)

    def parameter(self, share: Array) -> tuple[Array, Array]:
        """u and du/dshare where the share (k,) of the arc length is behind."""
        if self.steady:
            return share, np.ones_like(share)
        u = np.clip(self._arc.parameter(share * self.length), 0.0, 1.0)
        return u, self.length / self.speed(u)


class Conic(SpaceCurve):
    """centre + cos(theta) first + sin(theta) second, theta from ``start`` to ``end`` in equal parts.

    An arc of a circle where the two are square to each other and equally long, else of an ellipse.

    Args:
        centre, first, second: (d,) in m; the two semi-axes are not parallel.
        start, end: rad; the other way round where ``end`` is smaller.

    Raises:
        InputError: naming what is wrong.

    Example:
        >>> Conic([0.0, 0.0], [2.0, 0.0], [0.0, 1.0], 0.0, np.pi).at(np.array([0.5]))[0].round(6) + 0.0
        array([[0., 1.]])
    """

    def __init__(self, centre: Any, first: Any, second: Any, start: float, end: float) -> None:
        self.centre = vector(centre, "centre")
        self.first, self.second = (vector(v, name, self.centre.size) for v, name in ((first, "x"), (second, "y")))
        self.start, self.sweep = float(start), float(end) - float(start)
        a, b = np.linalg.norm(self.first), np.linalg.norm(self.second)
        product = float(self.first @ self.second)
        if not a * b > 0.0 or abs(product) > (1.0 - 1e-9) * a * b or max(a, b) > 1000.0 * min(a, b):
            raise InputError(
                "the semi-axes: two directions that are not parallel, of lengths up to 1 : 1000, are accepted"
            )
        if self.sweep == 0.0:
            raise InputError(f"start and end are both {self.start:g} rad; two angles are accepted")
        self.steady = bool(abs(a - b) <= 1e-14 * a and abs(product) <= 1e-14 * a * b)
        if self.centre.size == 3:
            self.normal = direction(np.cross(self.first, self.second) * np.sign(self.sweep), "the semi-axes")
        turns = max(1, int(np.ceil(abs(self.sweep) / (2.0 * np.pi))))
        self.breaks = np.linspace(0.0, 1.0, 16 * turns + 1)

    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """As :meth:`SpaceCurve.at`."""
        theta = self.start + self.sweep * u[:, None]
        cosine, sine = np.cos(theta), np.sin(theta)
        out = cosine * self.first + sine * self.second
        along = self.sweep * (cosine * self.second - sine * self.first)
        return self.centre + out, along, -(self.sweep**2) * out


class Pieces(SpaceCurve):
    """Polynomial pieces that meet without corners: a straight line, or a polyline whose corners are rounded.

    Args:
        path: polynomials of two or three coordinates.
    """

    def __init__(self, path: JointPath) -> None:
        self.path = path
        self.span = float(path.breaks[-1] - path.breaks[0])
        if self.span > 0.0:
            self.breaks = (path.breaks - path.breaks[0]) / self.span
        self.steady = len(path.pieces) == 1 and not np.any(path.pieces[:, 2:])

    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """As :meth:`SpaceCurve.at`."""
        s = self.path.breaks[0] + self.span * u
        r, slope, bend = (self.path.at(s, order) * self.span**order for order in (0, 1, 2))
        return r, slope, bend


class Interpolated(SpaceCurve):
    """The spline through points, of degree five (less through fewer than six) and with continuous curvature.

    Args:
        points: (k, d) in m.
        parameters: (k,) rising, where the points are, from 0 to 1.
        closed: whether it goes on smoothly from the last point, which is the first, to the first.
    """

    def __init__(self, points: Array, parameters: Array, closed: bool = False) -> None:
        from scipy.interpolate import make_interp_spline

        degree = 5 if closed else min(5, len(points) - 1)
        spline = make_interp_spline(parameters, points, k=degree, bc_type="periodic" if closed else None)
        self._splines = [spline, *(spline.derivative(order) for order in (1, 2) if order <= degree)]
        self.breaks = np.unique(np.clip(spline.t, 0.0, 1.0))
        self.points = points

    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """As :meth:`SpaceCurve.at`."""
        found = [np.asarray(spline(u)) for spline in self._splines]
        r, slope, bend = [*found, *[np.zeros_like(found[0])] * (3 - len(found))]
        return r, slope, bend


class Placed(SpaceCurve):
    """A path of :mod:`chainrule.paths` as it is, or in a plane of space: origin + x(s) x + y(s) y.

    Args:
        path: in the plane, by arc length.
        origin, x, y: (3,) m and two directions square to each other; in the plane itself where they are absent.

    Raises:
        InputError: only some of the three, or directions that are not square to each other.
    """

    steady = True

    def __init__(self, path: Path, origin: Any = None, x: Any = None, y: Any = None) -> None:
        if not isinstance(path, Path):
            raise InputError(f"path: {shown(path)}; a path such as chainrule.Circle is accepted")
        self.path, self.frame = path, None
        if origin is not None or x is not None or y is not None:
            first, second = axes(x, y, 3)
            self.origin = np.zeros(3) if origin is None else vector(origin, "origin", 3)
            self.frame = np.stack([first, second])
            self.normal = np.cross(first, second)

    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """As :meth:`SpaceCurve.at`."""
        # on a closed path the end is the beginning, and so it is for the path
        frame, length = self.path.at(u * self.path.length), self.path.length
        r, slope = frame.point, length * frame.tangent
        bend = (length**2 * frame.curvature)[:, None] * left(frame.tangent)
        if self.frame is None:
            return r, slope, bend
        return self.origin + r @ self.frame, slope @ self.frame, bend @ self.frame


# ---- made from points --------------------------------------------------------------------------------------------


def line(start: Any, end: Any) -> Pieces:
    """The straight line between two points (d,).

    Raises:
        InputError: they are one point, or not points.
    """
    first = vector(start, "start")
    last = vector(end, "end", first.size)
    if np.array_equal(first, last):
        raise InputError(f"start and end are both {shown(first.tolist())}; two points are accepted")
    return Pieces(polyline(np.stack([first, last])))


def corners(points: Any, deviation: Any) -> Pieces:
    """The polyline through points (k, d) with its corners rounded by parabolas.

    Args:
        points: (k, d) in m.
        deviation: how far a rounded corner may leave the polyline in any coordinate, m.

    Raises:
        InputError: fewer than two points, neighbours that are one, a deviation that is not positive.
    """
    given = listed(points, 2)
    apart(np.linalg.norm(np.diff(given, axis=0), axis=1))
    return Pieces(rounded(given, positive(deviation, "deviation")))


def through(points: Any, closed: bool = False) -> Interpolated:
    """The spline through points (k, d) by the chord length; closed as well where the last point is the first.

    Raises:
        InputError: fewer than three points, neighbours that are one.
    """
    given = listed(points, 3)
    closed = closed or bool(np.array_equal(given[0], given[-1]))
    ring = np.vstack([given, given[:1]]) if closed and not np.array_equal(given[0], given[-1]) else given
    if closed and len(ring) < 4:
        raise InputError("points: a closed spline needs at least 3 different points")
    chords = np.linalg.norm(np.diff(ring, axis=0), axis=1)
    apart(chords)
    return Interpolated(ring, np.concatenate([[0.0], np.cumsum(chords) / chords.sum()]).clip(0.0, 1.0), closed)


def listed(points: Any, least: int) -> Array:
    """Points (k, d), checked.

    Raises:
        InputError: another shape, too few or too many.
    """
    given = real_array(points, "points")
    if given.ndim != 2 or given.shape[1] not in (2, 3) or not least <= len(given) <= MOST:
        raise InputError(f"points: shape {given.shape}; (k, 3) or (k, 2) with k from {least} to {MOST} is accepted")
    return given


def apart(steps: Array) -> None:
    """Refuse steps (k,) between neighbours that are nothing, or next to it.

    Raises:
        InputError: naming the first.
    """
    wrong = np.flatnonzero(~(steps > NEAR * steps.sum()))
    if len(wrong):
        raise InputError(
            f"points: numbers {wrong[0] + 1} and {wrong[0] + 2} are one; neighbours that differ are accepted"
        )


def vector(value: Any, what: str, size: int | None = None) -> Array:
    """(2,) or (3,) numbers, or exactly ``size``.

    Raises:
        InputError: anything else.
    """
    found = real_array(value, what)
    accepted = (2, 3) if size is None else (size,)
    if found.ndim != 1 or found.size not in accepted:
        raise InputError(f"{what}: {shown(value)}; {' or '.join(map(str, accepted))} numbers are accepted")
    return found


def direction(value: Array, what: str) -> Array:
    """A vector made one long.

    Raises:
        InputError: it has no length.
    """
    size = np.linalg.norm(value)
    if not size > 0.0:
        raise InputError(f"{what}: {shown(value.tolist())}; a direction is accepted")
    return np.asarray(value / size)


def axes(x: Any, y: Any, size: int) -> tuple[Array, Array]:
    """Two unit vectors (size,) square to each other; the first two coordinate axes where absent.

    Raises:
        InputError: they are not square to each other to 1e-9.
    """
    rows = np.eye(size)
    first = rows[0] if x is None else direction(vector(x, "x", size), "x")
    second = rows[1] if y is None else direction(vector(y, "y", size), "y")
    if abs(float(first @ second)) > 1e-9:
        raise InputError(f"x and y: {shown(first.tolist())} and {shown(second.tolist())} are not square to each other")
    return first, second
