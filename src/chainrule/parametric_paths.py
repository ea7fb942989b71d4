"""Paths in the plane by a parameter of their own: ellipses, splines, and a user's own curves r(u).

With v = |r'|, N the normal to the left and primes for derivatives by the curve's own parameter u,
    k = (r' x r'') / v^3,    dk/ds = (r' x r''') / v^4 - 3 (r' x r'') (r' . r'') / v^6.
They are measured and inverted once, when they are made (:class:`chainrule.paths.ArcLength`).
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import ArcLength, Frame, Path, bounded, bounded_number, cross, dot, pair, positive_number

Array = NDArray[Any]
Position = Callable[[Array], Any]

#: Samples of a panel for the bound on the curvature, and how far the bound lies above the largest sample.
_SAMPLES, _MARGIN = 32, 1.02
#: A curve whose speed falls below this share of its largest stands still: a cusp.
_CUSP = 1e-7
#: Degrees tried for a curve given without derivatives.
_DEGREES = (32, 64, 128, 256, 512)


class _Parametric(Path):
    """A curve r(u), 0 <= u <= 1 or another range, measured and inverted by :class:`ArcLength`."""

    def _measure(self, breaks: Array) -> None:
        """Arc lengths and the inverse; ``breaks`` are the places where r is not smooth to all orders."""
        self._arc = ArcLength(self._speed, breaks)
        self.length = self._arc.length
        edges = self._arc.edges
        share = np.linspace(0.0, 1.0, _SAMPLES + 1)
        u = (edges[:-1, None] + np.diff(edges)[:, None] * share).ravel()
        speed = self._speed(u)
        if not speed.min() > _CUSP * speed.max():
            raise InputError("the curve stands still somewhere (a cusp, or a point given twice); it must keep moving")
        self.max_curvature = _MARGIN * float(np.abs(self._at(u).curvature).max())

    @abstractmethod
    def _derivatives(self, u: Array, orders: int) -> list[Array]:
        """r and its derivatives up to ``orders``, each (..., 2)."""

    def _speed(self, u: Array) -> Array:
        first = self._derivatives(u, 1)[1]
        return np.hypot(first[..., 0], first[..., 1])

    def _at(self, u: Array) -> Frame:
        r, r1, r2, r3 = self._derivatives(u, 3)
        v = np.hypot(r1[..., 0], r1[..., 1])
        tangent = r1 / v[..., None]
        bend = cross(tangent, r2) / v**2
        return Frame(r, tangent, bend, cross(tangent, r3) / v**3 - 3.0 * bend * dot(tangent, r2) / v**2)

    def parameter(self, s: Array) -> Array:
        """The curve's own parameter at arc lengths from 0 to the length."""
        return self._arc.parameter(s)

    def _inside(self, s: Array) -> Frame:
        return self._at(self.parameter(s))

    def _check_closed(self) -> None:
        """That the end continues the beginning, in point, tangent and curvature."""
        start, end = self._inside(np.array(0.0)), self._inside(np.array(self.length))
        gap = float(np.hypot(*(start.point - end.point)))
        bend = abs(float(start.curvature - end.curvature))
        turned = float(np.hypot(*(start.tangent - end.tangent)))
        if gap > 1e-9 * self.length or turned > 1e-6 or bend > 1e-5 * max(self.max_curvature, 1.0 / self.length):
            raise InputError(
                f"closed: the end misses the beginning by {gap:.3g} m, {turned:.3g} rad, {bend:.3g} 1/m in curvature; "
                "a closed curve that goes on smoothly is accepted"
            )


class Ellipse(_Parametric):
    """The ellipse about ``centre``, once around.

    Args:
        centre: (x, y) in m.
        semi_axes: (a, b) in m, positive, in either order.
        rotation: angle from the x axis to the first semi-axis, in rad.
        start: the eccentric angle, in rad, of the point where s = 0.
        clockwise: whether it turns right.

    Raises:
        InputError: naming what is wrong; a ratio of the axes above 1000 is refused.

    Example:
        >>> Ellipse((0.0, 0.0), (2.0, 1.0)).curvature([0.0]).round(6)
        array([2.])
    """

    closed = True

    def __init__(
        self,
        centre: Sequence[float],
        semi_axes: Sequence[float],
        *,
        rotation: float = 0.0,
        start: float = 0.0,
        clockwise: bool = False,
    ) -> None:
        self.centre = pair(centre, "centre")
        axes = pair(semi_axes, "semi_axes")
        self.semi_axes = np.array(
            [positive_number(axes[0], "semi_axes, entry 1"), positive_number(axes[1], "semi_axes, entry 2")]
        )
        if self.semi_axes.max() > 1000.0 * self.semi_axes.min():
            raise InputError(f"semi_axes: ({axes[0]:g}, {axes[1]:g}); a ratio of up to 1000 is accepted")
        self.rotation = bounded_number(rotation, "rotation")
        self.start_angle = bounded_number(start, "start")
        self.clockwise = bool(clockwise)
        c, s = math.cos(self.rotation), math.sin(self.rotation)
        self._frame = np.array([[c, -s], [s, c]]) * self.semi_axes  # columns: the two semi-axes
        self._measure(np.linspace(0.0, 2.0 * np.pi, 17))
        self.max_curvature = float(self.semi_axes.max() / self.semi_axes.min() ** 2)

    def _derivatives(self, u: Array, orders: int) -> list[Array]:
        turn = -1.0 if self.clockwise else 1.0
        angle = self.start_angle + turn * u
        c, s = np.cos(angle), np.sin(angle)
        around = [(c, s), (-s * turn, c * turn), (-c, -s), (s * turn, -c * turn)][: orders + 1]
        found = [np.stack(pair, axis=-1) @ self._frame.T for pair in around]
        return [self.centre + found[0], *found[1:]]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "kind": "ellipse",
            "centre": self.centre.tolist(),
            "semi_axes": self.semi_axes.tolist(),
            "rotation": self.rotation,
            "start": self.start_angle,
            "clockwise": self.clockwise,
        }


class Spline(_Parametric):
    """The interpolating spline through points in their order, with continuous dk/ds.

    A quintic spline in the chord length: four continuous derivatives. Open with not-a-knot ends (through fewer than six
    points it is one polynomial); closed it is periodic.

    Args:
        points: (k, 2) in m, at least three, no two neighbours equal.
        closed: whether it returns to the first point; true as well where the last point is the first.

    Raises:
        InputError: naming the point that is wrong.

    Example:
        >>> path = Spline([(0.0, 0.0), (1.0, 0.2), (2.0, 0.0), (3.0, 0.4)])
        >>> [round(float(distance), 9) for distance in path.nearest(path.points).distance]
        [0.0, 0.0, 0.0, 0.0]
    """

    def __init__(self, points: Any, *, closed: bool = False) -> None:
        from scipy.interpolate import make_interp_spline

        given = bounded(real_array(points, "points"), "points")
        if given.ndim != 2 or given.shape[1] != 2 or len(given) < 3:
            raise InputError(f"points: shape {given.shape}; (k, 2) with k at least 3 is accepted")
        if len(given) > 10_000:
            raise InputError(f"points: {len(given)} of them; at most 10000 are accepted")
        self.closed = bool(closed) or bool(np.array_equal(given[0], given[-1]))
        self.points = given[:-1] if np.array_equal(given[0], given[-1]) else given
        ring = np.vstack([self.points, self.points[:1]]) if self.closed else self.points
        chords = np.linalg.norm(np.diff(ring, axis=0), axis=1)
        if len(self.points) < 3:
            raise InputError("points: a closed spline needs at least 3 different points")
        if not chords.min() > 1e-9 * chords.sum():
            place = int(np.argmin(chords)) + 1
            raise InputError(f"points: numbers {place} and {place % len(self.points) + 1} are one point")
        u = np.concatenate([[0.0], np.cumsum(chords)])
        degree = 5 if self.closed else min(5, len(ring) - 1)
        spline = make_interp_spline(u, ring, k=degree, bc_type="periodic" if self.closed else None)
        self._splines = [spline, *(spline.derivative(k) for k in (1, 2, 3) if k <= degree)]
        knots = np.unique(np.clip(spline.t, u[0], u[-1]))
        self._measure(knots)
        if self.closed:
            self._check_closed()

    def _derivatives(self, u: Array, orders: int) -> list[Array]:
        found = [np.asarray(spline(u)) for spline in self._splines[: orders + 1]]
        return found + [np.zeros_like(found[0])] * (orders + 1 - len(found))

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"kind": "spline", "points": self.points.tolist(), "closed": self.closed}


class Curve(_Parametric):
    """A curve of the user's own, r(u) for u from ``start`` to ``end``.

    Args:
        position: takes u (k,) and returns r (k, 2) in m.
        start: first u.
        end: last u, larger than ``start``.
        derivatives: functions for r', r'', r''' by u, shaped like ``position``. Without them r is approximated by a
            Chebyshev series of degree up to 512, to rounding, and the series is differentiated: each derivative
            costs digits (dk/ds keeps about eight). A curve that no such series meets is refused.
        closed: whether it goes on smoothly from the end to the start; checked.

    Raises:
        InputError: naming what is wrong with the functions or the range.

    Example:
        >>> wave = Curve(lambda u: np.stack([u, 0.1 * np.sin(u)], axis=-1), 0.0, 6.0)
        >>> wave.tangent(0.0).round(6)
        array([0.995037, 0.099504])
    """

    def __init__(
        self,
        position: Position,
        start: float,
        end: float,
        *,
        derivatives: Sequence[Position] | None = None,
        closed: bool = False,
    ) -> None:
        first, last = bounded_number(start, "start"), bounded_number(end, "end")
        if not last > first:
            raise InputError(f"end: {last:g}; more than start = {first:g} is accepted")
        self.range = (first, last)
        if not callable(position):
            raise InputError(f"position: {shown(position)}; a function of u is accepted")
        three = derivatives is None or (isinstance(derivatives, Sequence) and len(derivatives) == 3)
        if not three or not all(callable(function) for function in derivatives or ()):
            raise InputError(f"derivatives: {shown(derivatives)}; three functions (r', r'', r''') are accepted")
        self._given = [position, *derivatives] if derivatives is not None else []
        self._coefficients = _chebyshev(position, first, last) if derivatives is None else []
        self.closed = bool(closed)
        self._measure(np.linspace(first, last, 17))
        if self._given:
            self._check_derivatives()
        if self.closed:
            self._check_closed()

    def _derivatives(self, u: Array, orders: int) -> list[Array]:
        u = np.asarray(u, float)
        if self._given:
            flat = u.reshape(-1)
            names = ("position", "the first derivative", "the second derivative", "the third derivative")
            parts = zip(self._given[: orders + 1], names, strict=False)
            return [_called(function, flat, name).reshape(*u.shape, 2) for function, name in parts]
        low, high = self.range
        x = (2.0 * u - low - high) / (high - low)
        found = self._coefficients[: orders + 1]
        return [np.moveaxis(np.polynomial.chebyshev.chebval(x, c), 0, -1) for c in found]

    def _check_derivatives(self) -> None:
        """That each function is the derivative of the one before it, by central differences."""
        low, high = self.range
        u, step = np.linspace(low, high, 11)[1:-1], 1e-5 * (high - low)
        for order in range(3):
            ends = [_called(self._given[order], u + sign * step, "a derivative") for sign in (1.0, -1.0)]
            slope, stated = (ends[0] - ends[1]) / (2.0 * step), _called(self._given[order + 1], u, "a derivative")
            scale = max(float(np.abs(stated).max()), float(np.abs(ends[0]).max()) / (high - low))
            if float(np.abs(slope - stated).max()) > 1e-4 * scale:
                word = ("first", "second", "third")[order]
                raise InputError(f"derivatives: the {word} is not the derivative of the function before it")

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"kind": "curve", "start": self.range[0], "end": self.range[1], "closed": self.closed}


def _chebyshev(position: Position, low: float, high: float) -> list[Array]:
    """Series (degree, 2) of r and its three derivatives by u, cut off where rounding begins."""
    from numpy.polynomial import chebyshev

    for degree in _DEGREES:
        x = np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))
        values = _called(position, 0.5 * (low + high) + 0.5 * (high - low) * x, "position")
        basis = np.cos(np.outer(np.arange(degree + 1), np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1)))
        series = 2.0 / (degree + 1) * basis @ values
        series[0] *= 0.5
        size = np.abs(series).max(axis=1)
        floor = 1e-15 * max(size[1:].max(), 1e-300)
        if size[-degree // 8 :].max() <= 20.0 * floor + 4e-16 * float(np.abs(values).max()):
            kept = int(np.nonzero(size > 3.0 * floor)[0].max(initial=0)) + 1
            found = [series[: max(kept, 4)]]
            for _ in range(3):
                found.append(np.asarray(chebyshev.chebder(found[-1]), np.float64) * (2.0 / (high - low)))
            return found
    raise InputError(
        "position: not smooth enough for its derivatives to be found (a corner, a jump or too much detail); "
        "give derivatives=(r', r'', r''')"
    )


def _called(function: Position, u: Array, what: str) -> Array:
    given = function(u)
    try:
        found = np.asarray(given)
    except ValueError:  # a ragged sequence
        found = np.asarray(None)
    if found.shape != (*u.shape, 2) or found.dtype.kind not in "fiu":
        raise InputError(
            f"{what}: for u of shape {u.shape} it returned {found.dtype} of shape {found.shape}; "
            f"numbers of shape {(*u.shape, 2)} are accepted"
        )
    if not np.isfinite(found).all():
        raise InputError(f"{what}: not finite at u = {u[~np.isfinite(found).all(axis=-1)][0]:.6g}")
    return bounded(found.astype(float), what)
