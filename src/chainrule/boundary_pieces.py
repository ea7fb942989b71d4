"""Pieces of the boundaries of regions of the plane, arcs and segments: one at a time, and many at once as arrays.

Points are complex numbers x + iy.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Values = tuple[float, ...]
TURN = 2.0 * math.pi

#: Relative to the size of what is cut: when two curves count as touching.
CONTACT = 1e-13


@dataclass(frozen=True)
class Arc:
    """Part of a circle, from the angle ``start`` through ``turn`` rad (counter-clockwise where positive).

    Attributes:
        centre: x + iy, m.
        radius: m.
        start: angle of the first point, rad.
        turn: signed angle to the last point, rad; 2 pi for a full circle.
        first, last: numbers carried along, linear in the angle (of a workspace: the joint values).
    """

    centre: complex
    radius: float
    start: float
    turn: float
    first: Values = ()
    last: Values = ()

    @property
    def length(self) -> float:
        """Length, m."""
        return abs(self.turn) * self.radius

    def point(self, t: float) -> complex:
        """The point at the share ``t`` of the way."""
        return self.centre + cmath.rect(self.radius, self.start + t * self.turn)

    def tangent(self, t: float) -> complex:
        """Unit vector along the way."""
        return cmath.rect(1.0, self.start + t * self.turn + math.copysign(math.pi / 2, self.turn))

    def part(self, t0: float, t1: float) -> Arc:
        """From the share ``t0`` to ``t1``; backwards if ``t1 < t0``."""
        start, turn = self.start + t0 * self.turn, (t1 - t0) * self.turn
        return Arc(self.centre, self.radius, start, turn, between(self, t0), between(self, t1))

    def moved(self, rotation: complex, shift: complex) -> Arc:
        """Every point z at rotation z + shift, with abs(rotation) = 1."""
        angle = cmath.phase(rotation)
        return replace(self, centre=rotation * self.centre + shift, start=self.start + angle)

    def area(self) -> float:
        """Integral of (x dy - y dx) / 2 along the way (Green)."""
        chord = self.point(1.0) - self.point(0.0)
        return 0.5 * (self.radius**2 * self.turn + (self.centre.conjugate() * chord).imag)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers; angles in rad."""
        return {
            "kind": "arc",
            "centre": [self.centre.real, self.centre.imag],
            "radius": self.radius,
            "from": self.start,
            "to": self.start + self.turn,
        }


@dataclass(frozen=True)
class Segment:
    """A straight segment; a single point if both ends are the same.

    Attributes:
        start, end: x + iy, m.
        first, last: numbers carried along, linear in the length (of a workspace: the joint values).
    """

    start: complex
    end: complex
    first: Values = ()
    last: Values = ()

    @property
    def length(self) -> float:
        """Length, m."""
        return abs(self.end - self.start)

    def point(self, t: float) -> complex:
        """The point at the share ``t`` of the way."""
        return self.start + t * (self.end - self.start)

    def tangent(self, t: float) -> complex:
        """Unit vector along the way; 0 for a point."""
        return (self.end - self.start) / self.length if self.length > 0.0 else 0j

    def part(self, t0: float, t1: float) -> Segment:
        """From the share ``t0`` to ``t1``; backwards if ``t1 < t0``."""
        return Segment(self.point(t0), self.point(t1), between(self, t0), between(self, t1))

    def moved(self, rotation: complex, shift: complex) -> Segment:
        """Every point z at rotation z + shift, with abs(rotation) = 1."""
        return replace(self, start=rotation * self.start + shift, end=rotation * self.end + shift)

    def area(self) -> float:
        """Integral of (x dy - y dx) / 2 along the way (Green)."""
        return 0.5 * (self.start.conjugate() * self.end).imag

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers."""
        ends = (self.start, self.end)
        return {"kind": "segment", "start": [ends[0].real, ends[0].imag], "end": [ends[1].real, ends[1].imag]}


Piece = Arc | Segment


def between(piece: Piece, t: float) -> Values:
    """The numbers carried along at the share ``t`` of the way."""
    return tuple(a + t * (b - a) for a, b in zip(piece.first, piece.last, strict=True))


def extent(piece: Piece) -> float:
    """A length, m, that no point's distance from the origin exceeds."""
    if isinstance(piece, Arc):
        return abs(piece.centre) + piece.radius
    return max(abs(piece.start), abs(piece.end))


@dataclass(frozen=True)
class Packed:
    """Pieces as arrays, to work on many at once; ``turn`` is 0 for segments."""

    arc: Array
    start: Array
    end: Array
    centre: Array
    radius: Array
    angle: Array
    turn: Array

    def __getitem__(self, index: Any) -> Packed:
        return Packed(*(getattr(self, name)[index] for name in self.__dataclass_fields__))


def packed(pieces: Sequence[Piece]) -> Packed:
    """The arrays of some pieces."""
    arcs = np.array([isinstance(p, Arc) for p in pieces], dtype=bool)
    rows = [(p.centre, p.radius, p.start, p.turn) if isinstance(p, Arc) else (0j, 0.0, 0.0, 0.0) for p in pieces]
    centre, radius, angle, turn = (np.array(c) for c in zip(*rows, strict=True)) if rows else (np.zeros(0),) * 4
    ends = np.array([(p.point(0.0), p.point(1.0)) for p in pieces], dtype=complex).reshape(-1, 2)
    return Packed(arcs, ends[:, 0], ends[:, 1], centre.astype(complex), radius.real, angle.real, turn.real)


def nearest(p: Packed, z: Array) -> tuple[Array, Array]:
    """Share of the way of each piece's nearest point to ``z``, and the distance; both broadcast."""
    chord = p.end - p.start
    square = np.where(chord == 0, 1.0, np.abs(chord) ** 2)
    straight = np.clip(((z - p.start) * chord.conj()).real / square, 0.0, 1.0)
    span = np.where(p.arc, np.abs(p.turn), 1.0)
    ahead = np.mod((np.angle(z - p.centre) - p.angle) * np.where(p.turn < 0, -1.0, 1.0), TURN)
    # beyond its end the nearest point of an arc is the end nearer in angle
    round_ = np.where(ahead <= span, ahead / span, np.where(ahead - span < TURN - ahead, 1.0, 0.0))
    t = np.where(p.arc, round_, straight)
    on_arc = p.centre + p.radius * np.exp(1j * (p.angle + t * p.turn))
    return t, np.abs(z - np.where(p.arc, on_arc, p.start + t * chord))


def triangle(a: Array, b: Array, c: Array) -> tuple[Array, Array]:
    """Apex of the triangle on the side c, at distance a from its start and b from its end: along it, and across.

    The height by Heron's product, which stays accurate where the triangle is flat or one side is tiny; 0 if there is
    no triangle.
    """
    area = (a + b + c) * (a + b - c) * (a - b + c) * (b - a + c)
    return ((a - b) * (a + b) + c**2) / (2.0 * c), np.sqrt(np.maximum(area, 0.0)) / (2.0 * c)


def circle_meets(p: Packed, radius: Array, slack: float) -> Iterator[tuple[Array, Array]]:
    """Where circles about the origin meet pieces: twice the points, and whether they are on the pieces; broadcast."""
    away, chord = np.abs(p.centre), p.end - p.start
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        along, across = triangle(radius, p.radius, away)
        towards = p.centre / away
        unit = chord / np.where(chord == 0, 1.0, np.abs(chord))  # 0 for a point
        foot = p.start - unit * (p.start * unit.conj()).real
        reach = np.sqrt(np.maximum(radius**2 - np.abs(foot) ** 2, 0.0))
    for sign in (-1.0, 1.0):
        at = np.where(p.arc, (along + 1j * sign * across) * towards, foot + sign * reach * unit)
        valid = np.isfinite(at) & (np.abs(np.abs(at) - radius) <= slack)
        at = np.where(valid, at, 0.0)
        yield at, valid & (nearest(p, at)[1] <= slack)
