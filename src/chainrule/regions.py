"""Regions of the plane bounded by arcs and segments, and what a turn or a slide sweeps of them.

Points are complex numbers x + iy. A region is closed; its boundary is made of loops that keep the inside on their
left, so outer loops run counter-clockwise and holes clockwise. A region without inside is a curve, or a point.

Turning a region D about the origin by every angle from a to b gives a region whose boundary consists of parts of

    D turned by a, D turned by b, and arcs about the origin through those points of D's boundary where the distance
    from the origin is locally extreme;

sliding does the same with translates and straight segments. These candidates are cut where they meet; a part belongs
to the boundary when exactly one of its sides is swept, which is decided by whether the way back of a point beside it
meets D. Everything is in closed form; nothing is sampled.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import GenerationError

Array = NDArray[Any]
Values = tuple[float, ...]
TURN = 2.0 * math.pi

#: Relative to the size of what is cut: when two curves count as touching, and when two corners as one.
CONTACT, CORNER = 1e-13, 1e-12


#: Numbers in the largest arrays when many points are asked about at once.
CHUNK = 2_000_000


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
        return Arc(self.centre, self.radius, start, turn, _between(self, t0), _between(self, t1))

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
        return Segment(self.point(t0), self.point(t1), _between(self, t0), _between(self, t1))

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


def _between(piece: Piece, t: float) -> Values:
    return tuple(a + t * (b - a) for a, b in zip(piece.first, piece.last, strict=True))


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
        return max((_extent(piece) for piece in self.pieces), default=0.0)

    @cached_property
    def _all(self) -> Packed:
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
            lambda part: nearest(self._all, part[:, None])[1].min(axis=1, initial=np.inf), z, len(self.pieces), float
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


def _extent(piece: Piece) -> float:
    if isinstance(piece, Arc):
        return abs(piece.centre) + piece.radius
    return max(abs(piece.start), abs(piece.end))


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


# ---- motions ---------------------------------------------------------------------------------------------------------


class Turn:
    """Rotation about the origin by an angle in rad."""

    #: A motion as long as this reaches everything on an orbit.
    period = TURN

    @staticmethod
    def level(z: complex) -> float:
        """What the motion does not change: the distance from the origin."""
        return abs(z)

    @staticmethod
    def gradient(z: complex) -> complex:
        """Unit vector in which the level grows; turned left by a right angle it is the direction of the motion."""
        return z / abs(z) if z else 0j

    @staticmethod
    def move(z: Any, by: float) -> Any:
        """Points after the motion."""
        return z * cmath.rect(1.0, by)

    @staticmethod
    def moved(region: Region | Piece, by: float) -> Any:
        """A region or piece after the motion."""
        return region.moved(cmath.rect(1.0, by), 0j)

    @staticmethod
    def orbit(z: complex, low: float, high: float, first: Values = (), last: Values = ()) -> Piece:
        """The way of a point."""
        return Arc(0j, abs(z), cmath.phase(z) + low, high - low, first, last)

    @staticmethod
    def critical(piece: Piece) -> list[float]:
        """Where along a piece the level is extreme, ends aside."""
        if isinstance(piece, Segment):
            chord = piece.end - piece.start
            return _inner([-(piece.start * chord.conjugate()).real / abs(chord) ** 2])
        if Turn.along(piece):
            return []
        towards = cmath.phase(piece.centre)
        return _inner(_shares(piece, (towards, towards + math.pi)))

    @staticmethod
    def along(piece: Piece) -> bool:
        """Whether the piece lies on one orbit."""
        return isinstance(piece, Arc) and abs(piece.centre) <= CONTACT * piece.radius

    @staticmethod
    def meets(z: Array, low: float, high: float, p: Packed, slack: float) -> Array:
        """Whether points (k,) moved back by something in [low, high] lie on one of the pieces."""
        z = z[:, None]
        r = np.maximum(np.abs(z), 1e-300)
        met = np.zeros(len(z), dtype=bool)
        for at, valid in circle_meets(p, r, slack):
            turned = np.mod(np.angle(z) - np.angle(at) - low + slack / r, TURN)
            met |= (valid & (turned <= high - low + 2.0 * slack / r)).any(axis=1)
        return met


class Slide:
    """Translation along x by a length in m."""

    period = math.inf

    @staticmethod
    def level(z: complex) -> float:
        """What the motion does not change."""
        return -z.imag

    @staticmethod
    def gradient(z: complex) -> complex:
        """Unit vector in which the level grows; turned left by a right angle it is the direction of the motion."""
        return -1j

    @staticmethod
    def move(z: Any, by: float) -> Any:
        """Points after the motion."""
        return z + by

    @staticmethod
    def moved(region: Region | Piece, by: float) -> Any:
        """A region or piece after the motion."""
        return region.moved(1.0 + 0j, complex(by))

    @staticmethod
    def orbit(z: complex, low: float, high: float, first: Values = (), last: Values = ()) -> Piece:
        """The way of a point."""
        return Segment(z + low, z + high, first, last)

    @staticmethod
    def critical(piece: Piece) -> list[float]:
        """Where along a piece the level is extreme, ends aside."""
        return _inner(_shares(piece, (math.pi / 2, -math.pi / 2))) if isinstance(piece, Arc) else []

    @staticmethod
    def along(piece: Piece) -> bool:
        """Whether the piece lies on one orbit."""
        return isinstance(piece, Segment) and abs((piece.end - piece.start).imag) <= CONTACT * max(
            piece.length, abs(piece.start)
        )

    @staticmethod
    def meets(z: Array, low: float, high: float, p: Packed, slack: float) -> Array:
        """Whether points (k,) moved back by something in [low, high] lie on one of the pieces."""
        z = z[:, None]
        chord = p.end - p.start
        with np.errstate(divide="ignore", invalid="ignore"):
            half = np.sqrt(p.radius**2 - (z.imag - p.centre.imag) ** 2)
            straight = p.start.real + chord.real * (z.imag - p.start.imag) / chord.imag
        met = np.zeros(len(z), dtype=bool)
        for sign in (-1.0, 1.0):
            x = np.where(p.arc, p.centre.real + sign * half, straight)
            valid = np.isfinite(x)
            x = np.where(valid, x, 0.0)
            valid &= nearest(p, x + 1j * z.imag)[1] <= slack
            back = z.real - x
            met |= (valid & (back >= low - slack) & (back <= high + slack)).any(axis=1)
        return met


Motion = type[Turn] | type[Slide]


def _shares(arc: Arc, angles: Iterable[float]) -> list[float]:
    """The shares of the way at which an arc has these angles; more than 1 where it does not."""
    sense = math.copysign(1.0, arc.turn)
    return [((a - arc.start) * sense % TURN) / abs(arc.turn) for a in angles]


def _inner(shares: Iterable[float]) -> list[float]:
    return sorted(t for t in shares if 1e-12 < t < 1.0 - 1e-12)


# ---- sweeping --------------------------------------------------------------------------------------------------------


def sweep(
    region: Region,
    motion: Motion,
    low: float,
    high: float,
    joint: int = 0,
    values: tuple[float, float] | None = None,
    size: float = 0.0,
) -> Region:
    """What a region covers when it moves by everything in [low, high].

    Args:
        region: what is moved; connected.
        motion: :class:`Turn` or :class:`Slide`.
        low: the least motion, rad or m.
        high: the greatest; a full turn or more gives a ring.
        joint: which of the numbers carried along is the motion's own, if any are carried.
        values: its values at ``low`` and ``high``; ``(low, high)`` when absent.
        size: of the whole the region is part of, m: what is shorter than its rounding errors counts as a point.

    Raises:
        GenerationError: if the boundary cannot be put together at any tolerance.

    Example:
        >>> link = point(2.0 + 0j)
        >>> bow = sweep(link, Turn, 0.0, 1.0)  # an arc of radius 2
        >>> round(sweep(bow, Slide, 0.0, 0.5).area, 12) == round(0.5 * 2.0 * math.sin(1.0), 12)
        True
    """
    ends = (low, high) if values is None else values
    small = 1e-11 * max(size, region.size)
    if high == low:
        return _tagged(motion.moved(region, low), joint, ends[0])
    if math.fsum(piece.length for piece in region.pieces) <= small:
        region = point(region.pieces[0].point(0.0), region.pieces[0].first)
    if high - low >= motion.period - 1e-12:
        share = motion.period / (high - low)
        return _revolved(region, low, joint, (ends[0], ends[0] + share * (ends[1] - ends[0])), small)
    if region.curves and (region.curves[0].length == 0.0 or motion.along(region.curves[0])):
        return Region(curves=(_lengthened(region.curves[0], motion, low, high, joint, ends, small),))
    candidates = _candidates(region, motion, low, high, joint, ends, small)
    size = max(size, max(map(_extent, candidates)))
    everything = region._all

    def swept(z: Array) -> Array:
        start = region.around(motion.move(z, -0.5 * (low + high)))
        return start | motion.meets(z, low, high, everything, CONTACT * size)

    loops = assemble(candidates, swept, size)
    return Region(loops) if loops else _thin(region, motion, low, high, joint, ends, small)


def _thin(
    region: Region, motion: Motion, low: float, high: float, joint: int, ends: tuple[float, float], small: float
) -> Region:
    """What is swept where it is nowhere wider than rounding errors: the curve in its middle."""
    curve = max(region.pieces, key=lambda piece: piece.length)
    line = [curve.point(t) for t in np.linspace(0.0, 1.0, 33)]
    heights = [motion.level(z) for z in line]
    if max(heights) - min(heights) > (high - low) * (region.size if motion is Turn else 1.0):
        return _tagged(motion.moved(region, 0.5 * (low + high)), joint, 0.5 * (ends[0] + ends[1]))
    if motion is Turn:
        turn = math.fsum(cmath.phase(after / before) for before, after in pairwise(line))
        along: Piece = Arc(0j, abs(line[16]), cmath.phase(line[0]), turn, curve.first, curve.last)
    else:
        along = Segment(line[0].real + 1j * line[16].imag, line[-1].real + 1j * line[16].imag, curve.first, curve.last)
    return Region(curves=(_lengthened(along, motion, low, high, joint, ends, small),))


def _tagged(found: Region, joint: int, value: float) -> Region:
    def tag(pieces: Iterable[Piece]) -> tuple[Piece, ...]:
        return tuple(_with(piece, joint, value, value) for piece in pieces)

    return Region(tuple(tag(loop) for loop in found.loops), tag(found.curves))


def _with(piece: Piece, joint: int, first: float, last: float) -> Piece:
    if not piece.first:
        return piece
    return replace(piece, first=_put(piece.first, joint, first), last=_put(piece.last, joint, last))


def _put(values: Values, joint: int, value: float) -> Values:
    return (*values[:joint], value, *values[joint + 1 :]) if values else ()


def levels(pieces: Iterable[Piece], motion: Motion) -> Iterator[Piece]:
    """Pieces in parts along which the level only grows, only falls, or stays."""
    for piece in pieces:
        if piece.length == 0.0:
            yield piece
            continue
        for t0, t1 in pairwise([0.0, *motion.critical(piece), 1.0]):
            yield piece.part(t0, t1)


def _revolved(region: Region, low: float, joint: int, ends: tuple[float, float], small: float) -> Region:
    """The ring that a full turn makes of a connected region."""
    corners = [(part.point(t), _between(part, t)) for part in levels(region.pieces, Turn) for t in (0.0, 1.0)]
    inner, outer = min(corners, key=lambda c: abs(c[0])), max(corners, key=lambda c: abs(c[0]))
    hollow = abs(inner[0]) > small and not bool(region.around(np.zeros(1, dtype=complex))[0])

    def circle(corner: tuple[complex, Values]) -> Piece:
        first, last = (_put(corner[1], joint, value) for value in ends)
        return Turn.orbit(corner[0], low, low + TURN, first, last)

    if abs(outer[0]) <= small:
        return point(0j, _put(outer[1], joint, ends[0]))
    if hollow and abs(outer[0]) - abs(inner[0]) <= small:
        return Region(curves=(circle(outer),))
    return Region(((circle(outer),), *(((circle(inner).part(1.0, 0.0),),) if hollow else ())))


def _lengthened(
    piece: Piece, motion: Motion, low: float, high: float, joint: int, ends: tuple[float, float], small: float
) -> Piece:
    """A point or a piece of one orbit, moved along it: a longer piece, at most the whole orbit."""
    if piece.length == 0.0:
        z = piece.point(0.0)
        if motion is Turn and abs(z) <= small:
            return _with(Segment(0j, 0j, piece.first, piece.first), joint, ends[0], ends[0])
        return motion.orbit(z, low, high, _put(piece.first, joint, ends[0]), _put(piece.first, joint, ends[1]))
    backwards = piece.turn < 0 if isinstance(piece, Arc) else (piece.end - piece.start).real < 0
    if backwards:
        piece = piece.part(1.0, 0.0)
    first, last = _put(piece.first, joint, ends[0]), _put(piece.last, joint, ends[1])
    if isinstance(piece, Segment):
        return Segment(piece.start + low, piece.end + high, first, last)
    whole = Arc(piece.centre, piece.radius, piece.start + low, piece.turn + high - low, first, last)
    return whole if whole.turn <= TURN else whole.part(0.0, TURN / whole.turn)


def _candidates(
    region: Region, motion: Motion, low: float, high: float, joint: int, ends: tuple[float, float], small: float
) -> list[Piece]:
    """Everything the boundary of the swept region can consist of.

    Where the level grows along the boundary, the region lies ahead of it in the motion: only the copy at ``low`` can
    be boundary of what is swept; where it falls, only the copy at ``high``.
    """
    flat = bool(region.curves)
    found: list[Piece] = []
    loops = [region.curves] if flat else list(region.loops)
    for loop in loops:
        parts = list(levels(loop, motion))
        for part in parts:
            slope = _slope(part, motion)
            if flat or slope >= 0:
                found.append(_with(motion.moved(part, low), joint, ends[0], ends[0]))
            if flat or slope <= 0:
                found.append(_with(motion.moved(part, high), joint, ends[1], ends[1]))
        corners = [*pairwise(parts), *([] if flat else [(parts[-1], parts[0])])]
        extreme = [after for before, after in corners if flat or _appears(before, after, motion)]
        tips = [(part.point(0.0), part.first) for part in extreme]
        if flat:
            tips += [(parts[0].point(0.0), parts[0].first), (parts[-1].point(1.0), parts[-1].last)]
        for z, tags in tips:
            orbit = motion.orbit(z, low, high, _put(tags, joint, ends[0]), _put(tags, joint, ends[1]))
            if orbit.length > small:
                found.append(orbit)
    return found


def _slope(part: Piece, motion: Motion) -> int:
    """Sign of the change of level along a part; 0 if the part lies on one orbit."""
    if motion.along(part):
        return 0
    change = motion.level(part.point(1.0)) - motion.level(part.point(0.0))
    return (change > 0) - (change < 0)


def _appears(before: Piece, after: Piece, motion: Motion) -> bool:
    """Whether at the corner between two parts something of the region appears that is not at lower or higher levels.

    The level must be locally extreme, with the region on the side it comes from.
    """
    slopes = _slope(before, motion), _slope(after, motion)
    if slopes[0] == slopes[1] != 0:
        return False
    along = before.tangent(1.0) + after.tangent(0.0)
    if 0 in slopes or abs(along) < 1e-6:
        return True
    inwards = (1j * along * motion.gradient(after.point(0.0)).conjugate()).real
    return inwards * slopes[0] <= 1e-9


# ---- putting a boundary together ------------------------------------------------------------------------------------


def assemble(
    candidates: Sequence[Piece], inside: Callable[[Array], Array], size: float
) -> tuple[tuple[Piece, ...], ...]:
    """The loops around the points where ``inside`` holds, given pieces that contain its boundary.

    Args:
        candidates: pieces; they may cross, touch, overlap and repeat.
        inside: for points (k,) off every candidate, whether they belong to the region.
        size: a length the tolerances are relative to, m.

    Raises:
        GenerationError: if what remains does not close at any of the tolerances tried.
    """
    for loosen in (1.0, 30.0, 1e3):
        contact, corner = CONTACT * loosen * size, CORNER * loosen * size
        kept, beside, sides = _boundary(candidates, inside, contact, corner, size)
        if kept is None:
            continue
        found = Region(_loops(kept))
        if _agree(found, inside, candidates, beside, sides, 100.0 * corner):
            return found.loops
    raise GenerationError(
        "a workspace boundary cannot be put together: some of its curves nearly coincide; lengths and limits that do "
        "not nearly coincide are accepted"
    )


def _agree(
    found: Region,
    inside: Callable[[Array], Array],
    candidates: Sequence[Piece],
    beside: Array,
    sides: Array,
    reach: float,
) -> bool:
    """Whether loops surround what is inside: at the points that decided them, and at some all over the plane."""
    share = np.arange(1, 201) * np.array([[0.7548776662466927], [0.5698402909980532]]) % 1.0  # spread evenly
    ends = np.array([candidate.point(t) for candidate in candidates for t in (0.0, 0.5, 1.0)])
    low, high = complex(ends.real.min(), ends.imag.min()), complex(ends.real.max(), ends.imag.max())
    spread = low + (high - low).real * share[0] + 1j * (high - low).imag * share[1]
    z, truth = np.concatenate([beside, spread]), np.concatenate([sides, inside(spread)])
    doubtful = nearest(packed(candidates), z[:, None])[1].min(axis=1) <= reach
    agree: bool = bool(np.all((found.around(z) == truth) | doubtful))
    return agree


def _boundary(
    candidates: Sequence[Piece], inside: Callable[[Array], Array], contact: float, corner: float, size: float
) -> tuple[list[tuple[Piece, int, int]] | None, Array, Array]:
    """The parts with the region on exactly one side, directed so that it is the left one, with their corners' numbers.

    None if at some corner not as many begin as end. Also the points beside the parts, and whether they are inside.
    """
    parts = _parts(candidates, contact, corner)
    if not parts:
        return [], np.zeros(0, dtype=complex), np.zeros(0, dtype=bool)
    p = packed([part for part, _, _ in parts])
    middle = np.array([part.point(0.5) for part, _, _ in parts])
    normal = np.array([1j * part.tangent(0.5) for part, _, _ in parts])
    gaps = nearest(p, middle[:, None])[1]
    np.fill_diagonal(gaps, np.inf)
    # between a part and its nearest neighbour nothing changes, so the middle of that gap decides most safely
    own = np.where(p.arc, np.minimum(p.radius, np.abs(p.turn) * p.radius), np.abs(p.end - p.start))
    step = 0.5 * np.minimum(gaps.min(axis=1), np.minimum(0.5 * own, 0.1 * size))
    beside = np.concatenate([middle + step * normal, middle - step * normal])
    sides = inside(beside)
    left, right = sides[: len(parts)], sides[len(parts) :]
    kept = [
        (part, v, w) if on_left else (part.part(1.0, 0.0), w, v)
        for (part, v, w), on_left, on_right in zip(parts, left, right, strict=True)
        if on_left != on_right
    ]
    balance: dict[int, int] = {}
    for _, v, w in kept:
        balance[v] = balance.get(v, 0) + 1
        balance[w] = balance.get(w, 0) - 1
    return (None if any(balance.values()) else kept), beside, sides


def _parts(candidates: Sequence[Piece], contact: float, corner: float) -> list[tuple[Piece, int, int]]:
    """The candidates cut wherever they meet, without repetitions, with the numbers of their two corners."""
    owner, share, z = _cuts(candidates, contact, corner)
    number = _clusters(z, corner)
    found: list[tuple[Piece, int, int]] = []
    seen: dict[tuple[int, int], list[complex]] = {}
    order = np.lexsort((share, owner))
    for i, j in pairwise(order):
        if owner[i] != owner[j]:
            continue
        part = candidates[owner[i]].part(float(share[i]), float(share[j]))
        v, w = int(number[i]), int(number[j])
        if v == w and part.length <= 8.0 * corner:
            continue
        key, middle = (min(v, w), max(v, w)), part.point(0.5)
        others = seen.setdefault(key, [])
        if all(abs(middle - other) > corner for other in others):
            others.append(middle)
            found.append((part, v, w))
    return found


def _cuts(pieces: Sequence[Piece], contact: float, corner: float) -> tuple[Array, Array, Array]:
    """Where to cut: the numbers of the pieces, the shares of their ways (0 and 1 among them), and the points.

    Every piece is also cut at every corner it passes, so that pieces which nearly coincide are cut alike.
    """
    p = packed(pieces)
    count = len(pieces)
    owners, shares = [np.repeat(np.arange(count), 2)], [np.tile([0.0, 1.0], count)]
    points = [np.stack([p.start, p.end], axis=1).reshape(-1)]
    first, second = np.triu_indices(count, 1)
    a, b = p[first], p[second]
    for z in _meetings(a, b, contact):
        valid = np.isfinite(z)
        z = np.where(valid, z, 0.0)
        (ta, ga), (tb, gb) = nearest(a, z), nearest(b, z)
        valid &= (ga <= 4.0 * contact) & (gb <= 4.0 * contact)
        owners += [first[valid], second[valid]]
        shares += [ta[valid], tb[valid]]
        points += [z[valid], z[valid]]
    found = np.concatenate(points)
    corners = found[np.unique(_clusters(found, corner), return_index=True)[1]]
    t, gap = nearest(p, corners[:, None])
    at, on = np.nonzero(gap <= corner)
    owner, share = np.concatenate([*owners, on]), np.concatenate([*shares, t[at, on]])
    return owner, share, np.concatenate([found, corners[at]])


def _meetings(a: Packed, b: Packed, contact: float) -> list[Array]:
    """The two points where the circles or lines of pieces (k,) meet; nan where they do not; the same where they touch.

    Where circles touch, the point on the line of their centres is accurate, the intersection's formula is not.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        # circle and circle
        d = b.centre - a.centre
        away = np.abs(d)
        x, y = triangle(a.radius, b.radius, away)
        touch = np.minimum(np.abs(away - a.radius - b.radius), np.abs(away - np.abs(a.radius - b.radius))) <= contact
        x = np.where(touch, np.copysign(a.radius, x), x)
        y = np.where(touch, 0.0, np.where(y > 0.0, y, np.nan))
        round_ = [np.where(away > contact, a.centre + (x + 1j * s * y) * d / away, np.nan) for s in (-1.0, 1.0)]
        # line and circle
        mixed = []
        centre, radius = np.where(a.arc, a.centre, b.centre), np.where(a.arc, a.radius, b.radius)
        start, chord = np.where(a.arc, b.start, a.start), np.where(a.arc, b.end - b.start, a.end - a.start)
        unit = chord / np.abs(chord)
        foot = start + unit * ((centre - start) * unit.conj()).real
        height = np.abs(foot - centre)
        half = np.where(np.abs(height - radius) <= contact, 0.0, np.sqrt(radius**2 - height**2))
        mixed = [foot + s * half * unit for s in (-1.0, 1.0)]
        # line and line
        u, v = a.end - a.start, b.end - b.start
        cross = (u.conj() * v).imag
        t = ((b.start - a.start).conj() * v).imag / np.where(np.abs(cross) > 1e-12 * np.abs(u * v), cross, np.nan)
        straight = a.start + t * u
    both, none = a.arc & b.arc, ~a.arc & ~b.arc
    return [np.where(both, round_[k], np.where(none, straight, mixed[k])) for k in (0, 1)]


def _clusters(z: Array, reach: float) -> Array:
    """A number for each point (k,): the same for points within ``reach`` of each other, and of their neighbours.

    Groups are split wherever x, then y, leaves a gap, until nothing splits any more.
    """
    number, count = np.zeros(len(z), dtype=int), 0
    while int(number.max(initial=0)) + 1 != count:
        count = int(number.max(initial=0)) + 1
        for coordinate in (z.real, z.imag):
            order = np.lexsort((coordinate, number))
            split = (np.diff(number[order]) > 0) | (np.diff(coordinate[order]) > reach)
            number[order] = np.concatenate([[0], np.cumsum(split)])
    return number


def _loops(kept: list[tuple[Piece, int, int]]) -> tuple[tuple[Piece, ...], ...]:
    """Closed loops from directed pieces; where several could follow, the one furthest to the left."""
    leaving: dict[int, list[tuple[Piece, int]]] = {}
    for piece, v, w in kept:
        leaving.setdefault(v, []).append((piece, w))
    loops = []
    while any(leaving.values()):
        origin = next(v for v, pieces in leaving.items() if pieces)
        loop: list[Piece] = []
        at = origin
        while not loop or at != origin:
            choice = leaving[at]
            k = max(range(len(choice)), key=lambda i: _leftness(loop[-1], choice[i][0])) if loop else 0
            piece, at = choice.pop(k)
            loop.append(piece)
        loops.append(tuple(_joined(loop)))
    return tuple(sorted(loops, key=lambda pieces: -abs(math.fsum(piece.area() for piece in pieces))))


def _leftness(before: Piece, after: Piece) -> tuple[float, float]:
    angle = cmath.phase(after.tangent(0.0) / before.tangent(1.0))
    bend = math.copysign(1.0 / after.radius, after.turn) if isinstance(after, Arc) else 0.0
    return round(angle, 6), bend


def _joined(loop: list[Piece]) -> list[Piece]:
    """A loop in which neighbours that continue each other are one piece."""
    start = next((k for k in range(len(loop)) if not _continues(loop[k - 1], loop[k])), 0)
    found: list[Piece] = []
    for piece in loop[start:] + loop[:start]:
        if found and _continues(found[-1], piece):
            found[-1] = _union(found[-1], piece)
        else:
            found.append(piece)
    return found


def _continues(a: Piece, b: Piece) -> bool:
    """Whether b goes on where a ends, on the same circle or line and with the numbers carried along."""
    if len(a.last) != len(b.first) or any(abs(x - y) > 1e-9 for x, y in zip(a.last, b.first, strict=True)):
        return False
    if isinstance(a, Arc) and isinstance(b, Arc):
        near = abs(a.centre - b.centre) + abs(a.radius - b.radius) <= 1e-12 * a.radius
        return near and a.turn * b.turn > 0 and abs(a.turn + b.turn) <= TURN + 1e-12
    if isinstance(a, Segment) and isinstance(b, Segment):
        return abs(a.tangent(1.0) - b.tangent(0.0)) <= 1e-12
    return False


def _union(a: Piece, b: Piece) -> Piece:
    if isinstance(a, Arc) and isinstance(b, Arc):
        return replace(a, turn=a.turn + b.turn, last=b.last)
    assert isinstance(a, Segment) and isinstance(b, Segment)
    return Segment(a.start, b.end, a.first, b.last)


# ---- a boundary that has no closed form ------------------------------------------------------------------------------


def trace(
    inside: Callable[[Array], Array], low: complex, high: complex, steps: int, tolerance: float, straight: float
) -> tuple[tuple[Piece, ...], ...]:
    """Polygons around the points where ``inside`` holds, their corners on its boundary to within ``tolerance``.

    Squares whose corners differ are found on a grid, crossings on their sides by bisection; then sides whose middle is
    off the boundary are bent onto it, up to four times.

    Args:
        inside: for points (k,), whether they belong to the region.
        low: the lower left corner of where to look.
        high: the upper right one.
        steps: squares along the longer side.
        tolerance: of the corners, m.
        straight: how far the middle of a side may be from the boundary, m.
    """
    step = max((high - low).real, (high - low).imag) / steps
    if step <= 0.0:
        return ()
    # off by a share that no drawing has, so that lines of symmetry do not fall on the grid
    nx, ny = (int(extent / step) + 4 for extent in ((high - low).real, (high - low).imag))
    corner = low - step * complex(1.3819, 1.4142)
    grid = corner + step * (np.arange(nx + 1)[:, None] + 1j * np.arange(ny + 1)[None, :])
    value = inside(grid.reshape(-1)).reshape(grid.shape)
    sides: dict[tuple[int, int, int], int] = {}
    ends: list[tuple[complex, complex]] = []  # (inside, outside)
    for direction, (dx, dy) in enumerate(((1, 0), (0, 1))):
        a, b = grid[: nx + 1 - dx, : ny + 1 - dy], grid[dx:, dy:]
        va, vb = value[: nx + 1 - dx, : ny + 1 - dy], value[dx:, dy:]
        for i, j in np.argwhere(va != vb).tolist():
            sides[(direction, i, j)] = len(ends)
            ends.append((a[i, j], b[i, j]) if va[i, j] else (b[i, j], a[i, j]))
    if not ends:
        return ()
    within, outside = np.array(ends).T
    crossing = _bisected(inside, within, outside, tolerance)
    following: dict[int, int] = {}
    cells = {(i - dx, j - dy) for d, i, j in sides for dx, dy in ((0, 0), ((0, 1), (1, 0))[d])}
    for i, j in sorted(cells):
        following.update(_through(value[i : i + 2, j : j + 2], sides, i, j, inside, grid))
    loops = []
    while following:
        at, after = following.popitem()
        polygon = [at]
        while after != polygon[0]:
            polygon.append(after)
            after = following.pop(after)
        loops.append(_bent(inside, crossing[polygon], tolerance, straight))
    pieces = [
        tuple(Segment(complex(a), complex(b)) for a, b in zip(line, np.roll(line, -1), strict=True)) for line in loops
    ]
    return tuple(sorted(pieces, key=lambda loop: -abs(math.fsum(piece.area() for piece in loop))))


def _through(
    value: Array, sides: dict[tuple[int, int, int], int], i: int, j: int, inside: Callable[[Array], Array], grid: Array
) -> dict[int, int]:
    """How the boundary passes a square, with the inside on its left: from which crossing to which."""
    # corners and sides counter-clockwise from the lower left
    corners = [bool(value[0, 0]), bool(value[1, 0]), bool(value[1, 1]), bool(value[0, 1])]
    number = [sides.get(key) for key in ((0, i, j), (1, i + 1, j), (0, i, j + 1), (1, i, j))]
    # going round, the boundary comes in through sides that lead from inside to outside
    entering = [k for k in range(4) if corners[k] and not corners[(k + 1) % 4]]
    leaving = [k for k in range(4) if not corners[k] and corners[(k + 1) % 4]]
    if len(entering) == 2:
        middle = np.array([0.5 * (grid[i, j] + grid[i + 1, j + 1])])
        joined = bool(inside(middle)[0])
        # a joined middle cuts off the outside corners, each between a side and the next
        leaving = [(k + 1) % 4 if joined else (k - 1) % 4 for k in entering]
    found = {}
    for k, m in zip(entering, leaving, strict=True):
        start, end = number[k], number[m]
        assert start is not None and end is not None
        found[start] = end
    return found


def _bisected(inside: Callable[[Array], Array], within: Array, outside: Array, tolerance: float) -> Array:
    """Points (k,) on the boundary between points inside and points outside."""
    within, outside = within.copy(), outside.copy()
    while float(np.abs(within - outside).max(initial=0.0)) > tolerance:
        middle = 0.5 * (within + outside)
        yes = inside(middle)
        within, outside = np.where(yes, middle, within), np.where(yes, outside, middle)
    return within


def _bent(inside: Callable[[Array], Array], line: Array, tolerance: float, straight: float) -> Array:
    """A closed polygon (k,) with more corners where the boundary is further than ``straight`` from its sides."""
    open_ = np.ones(len(line), dtype=bool)
    for _ in range(4):
        sides = np.nonzero(open_)[0]
        start, end = line[sides], np.roll(line, -1)[sides]
        middle, across = 0.5 * (start + end), 0.25j * (end - start)
        a, b = inside(middle + across), inside(middle - across)
        some = (a != b) & (np.abs(across) > straight)
        sides, middle, across, a = sides[some], middle[some], across[some], a[some]
        ends = middle + across, middle - across
        new = _bisected(inside, np.where(a, *ends), np.where(a, *ends[::-1]), tolerance)
        bent = np.abs(new - middle) > straight
        if not bent.any():
            break
        open_[:] = False
        open_[sides[bent]] = True
        line, open_ = np.insert(line, sides[bent] + 1, new[bent]), np.insert(open_, sides[bent] + 1, True)
    return line
