"""What a turn or a slide sweeps of a region of the plane.

Turning a region D about the origin by every angle from a to b gives a region whose boundary consists of parts of

    D turned by a, D turned by b, and arcs about the origin through those points of D's boundary where the distance
    from the origin is locally extreme;

sliding does the same with translates and straight segments. These candidates are cut where they meet; a part belongs
to the boundary when exactly one of its sides is swept, which is decided by whether the way back of a point beside it
meets D (:mod:`.boundary_assembly`). Everything is in closed form; nothing is sampled.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.boundary_assembly import assemble
from chainrule.boundary_pieces import (
    CONTACT,
    TURN,
    Arc,
    Packed,
    Piece,
    Segment,
    Values,
    between,
    circle_meets,
    extent,
    nearest,
)
from chainrule.regions import Region, point

Array = NDArray[Any]

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
    size = max(size, max(map(extent, candidates)))
    everything = region.arrays

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
    corners = [(part.point(t), between(part, t)) for part in levels(region.pieces, Turn) for t in (0.0, 1.0)]
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
