"""The boundary of a region put together from pieces that contain it: cut where they meet, kept, joined to loops."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.boundary_pieces import CONTACT, TURN, Arc, Packed, Piece, Segment, nearest, packed, triangle
from chainrule.errors import GenerationError
from chainrule.regions import Region

Array = NDArray[Any]

#: Relative to the size of what is cut: when two corners count as one.
CORNER = 1e-12


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
