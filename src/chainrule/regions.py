"""Regions of the plane bounded by arcs and segments: their area, and which points belong to them.

Points are complex numbers x + iy. A region is closed; its boundary is made of loops that keep the inside on their
left, so outer loops run counter-clockwise and holes clockwise. A region without inside is a curve, or a point.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.boundary_pieces import Arc, Packed, Piece, Segment, Values, extent, nearest, packed

Array = NDArray[Any]

#: Numbers in the largest arrays when many points are asked about at once.
CHUNK = 2_000_000


@dataclass(frozen=True)
class Region:
    """A closed region of the plane.

    Attributes:
        loops: closed sequences of pieces with the inside on their left; () for a region without inside.
        curves: what has no inside; a segment of length 0 is a point. What is swept is either all loops or one curve.
    """

    loops: tuple[tuple[Piece, ...], ...] = ()
    curves: tuple[Piece, ...] = ()

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Every piece of the boundary, or the curve."""
        return tuple(piece for loop in self.loops for piece in loop) + self.curves

    @cached_property
    def area(self) -> float:
        """Area, m^2, by Green's theorem: exact up to rounding."""
        return math.fsum(piece.area() for loop in self.loops for piece in loop)

    @cached_property
    def size(self) -> float:
        """A length, m, that no point's distance from the origin exceeds."""
        return max((extent(piece) for piece in self.pieces), default=0.0)

    @cached_property
    def arrays(self) -> Packed:
        """Every piece, as arrays."""
        return packed(self.pieces)

    @cached_property
    def _edges(self) -> Packed:
        """The loops in pieces of at most half a turn, the end of each exactly the start of the next."""
        halves, starts, ends = [], [], []
        for loop in self.loops:
            short = [half for piece in loop for half in _halves(piece)]
            corners = [half.point(0.0) for half in short]
            halves += short
            starts += corners
            ends += corners[1:] + corners[:1]
        p, a, b = packed(halves), np.array(starts, dtype=complex), np.array(ends, dtype=complex)
        # the chord of a very short arc has no safe direction, and its cap no width
        return replace(p, start=a, end=b, arc=p.arc & (np.abs(p.turn) > 1e-7))

    def moved(self, rotation: complex, shift: complex) -> Region:
        """Every point z at rotation z + shift, with abs(rotation) = 1."""

        def all_moved(pieces: Iterable[Piece]) -> tuple[Piece, ...]:
            return tuple(piece.moved(rotation, shift) for piece in pieces)

        return Region(tuple(all_moved(loop) for loop in self.loops), all_moved(self.curves))

    def around(self, z: Array) -> Array:
        """Whether points (k,) are surrounded by the loops; on the boundary itself either answer may come."""
        return _chunked(lambda part: _odd(self._edges, part), z, len(self._edges.start), bool)

    def distance(self, z: Array) -> Array:
        """Distance of points (k,) from the boundary, or from the curve, m."""
        return _chunked(
            lambda part: nearest(self.arrays, part[:, None])[1].min(axis=1, initial=np.inf), z, len(self.pieces), float
        )

    def contains(self, z: Array, tolerance: float | None = None) -> Array:
        """Whether points (k,) belong to the closed region.

        Args:
            z: points as complex numbers.
            tolerance: distance from the boundary that still counts as on it, m; a few rounding errors when absent.
        """
        z = np.asarray(z, dtype=complex)
        near = self.distance(z) <= (1e-12 * self.size if tolerance is None else tolerance)
        return self.around(z) | near

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        return {
            "area": self.area,
            "loops": [[piece.to_dict() for piece in loop] for loop in self.loops],
            "curves": [piece.to_dict() for piece in self.curves],
        }


def point(z: complex, values: Values = ()) -> Region:
    """The region that is one point."""
    return Region(curves=(Segment(z, z, values, values),))


def _halves(piece: Piece) -> list[Piece]:
    """An arc of more than half a turn in parts of less, so that each lies on one side of its chord."""
    if isinstance(piece, Arc) and abs(piece.turn) > 3.0:
        return [piece.part(k / 3, (k + 1) / 3) for k in range(3)]
    return [piece]


def _chunked(function: Callable[[Array], Array], z: Array, width: int, kind: type) -> Array:
    """A function of points (k,), a bounded number at a time, so that memory stays small."""
    step = max(1, CHUNK // max(width, 1))
    if len(z) <= step:
        return function(z)
    return np.concatenate([function(z[i : i + step]) for i in range(0, len(z), step)]).astype(kind)


def _odd(p: Packed, z: Array) -> Array:
    """Even-odd rule: a ray to the right against the chords, and once more for the cap between a chord and its arc.

    Ray and cap ask for the side of the chord with the very same number, so rounding cannot make them disagree.
    """
    z = z[:, None]
    a, b = p.start - z, p.end - z
    side = a.real * b.imag - a.imag * b.real
    left = np.where(side == 0.0, (p.end - p.start).real, side) > 0.0
    crossed = ((a.imag > 0.0) != (b.imag > 0.0)) & (left == (p.end.imag > p.start.imag))
    cap = p.arc & (np.abs(z - p.centre) < p.radius) & (left != (p.turn > 0.0))
    odd: Array = (crossed.sum(axis=1) + cap.sum(axis=1)) % 2 == 1
    return odd
