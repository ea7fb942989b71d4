"""Which orientations the tip of a planar chain can have at a point, exactly.

Two ways, by what the chain is. If its first moving joint turns freely, everything is symmetric about that joint's
axis: seen from the tip, the axis lies in a fixed region W', and the tip at distance r from the axis has the
orientations that the circle of radius r about the origin has inside W'.

Otherwise the range of orientations at a point ends in postures where some joints are at their limits and the axes of
all the others lie on one straight line (the Jacobian of position and orientation has lost rank; a prismatic joint
counts as an axis infinitely far away, square to its slide). With those on the line rigidly aligned, only the first
and the last of them remain: two unknowns for two coordinates, in closed form. Whether the orientations between two
such ends are reached, one pose between them decides: if it can be reached at all, then also with all joints but three
at their limits or aligned, and the three follow in closed form.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise, product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.boundary_pieces import TURN, circle_meets, triangle
from chainrule.errors import InputError
from chainrule.planar_chains import Chain, Move, Moving, after_first, from_tip, merged, reached, then
from chainrule.regions import Region

Array = NDArray[Any]
Interval = tuple[float, float]
FULL: tuple[Interval, ...] = ((-math.pi, math.pi),)

#: Angles closer than this count as the same, rad; also how far beyond a limit still counts as at it (times the size).
SAME = 1e-9

#: Relative to the size: a posture this near to a stretched or folded one counts as that, because the angles of one
#: differ from those of the other by the root of it.
TOUCH = 1e-14

#: More limited moving joints than this are refused where orientations need every combination of limits.
MOST = 9

#: Combinations tried at once on many poses.
BLOCK = 16


# ---- sets of angles --------------------------------------------------------------------------------------------------


def union(intervals: list[Interval]) -> tuple[Interval, ...]:
    """Intervals of angles as disjoint ones, each low in (-pi, pi], in order; the full circle is (-pi, pi).

    >>> union([(0.0, 1.0), (0.5, 2.0), (5.0, 5.5)])
    ((-1.2831853071795862, -0.7831853071795862), (0.0, 2.0))
    """
    pieces = sorted((_wrapped(low), high - low) for low, high in intervals)
    found: list[Interval] = []
    for low, width in pieces:
        if found and low <= found[-1][1] + SAME:
            found[-1] = (found[-1][0], max(found[-1][1], low + width))
        else:
            found.append((low, low + width))
    while len(found) > 1 and found[-1][1] + SAME >= found[0][0] + TURN:  # the last runs into the first
        low, high = found.pop()
        found[0] = (low - TURN, max(high - TURN, found[0][1]))
        while len(found) > 1 and found[0][1] + SAME >= found[1][0]:
            found[0] = (found[0][0], max(found[0][1], found.pop(1)[1]))
    if any(high - low >= TURN - SAME for low, high in found):
        return FULL
    return tuple(sorted((_wrapped(low), _wrapped(low) + high - low) for low, high in found))


def widened(intervals: tuple[Interval, ...], low: float, high: float) -> tuple[Interval, ...]:
    """Every angle of the intervals plus every one of [low, high]."""
    return union([(a + low, b + high) for a, b in intervals])


def _wrapped(angle: float) -> float:
    wrapped = math.remainder(angle, TURN)
    return math.pi if wrapped <= -math.pi + 1e-12 else wrapped


def circle_in(region: Region, radius: float, size: float = 0.0) -> tuple[Interval, ...]:
    """The angles at which the circle of a radius about the origin lies in a region.

    Args:
        region: the region.
        radius: m.
        size: of the whole the region is part of, m: the scale of rounding errors, if it is larger than the region's.
    """
    slack = 1e-11 * max(size, region.size, radius)
    if radius <= slack:
        return FULL if bool(region.contains(np.zeros(1, dtype=complex), slack)[0]) else ()
    p = region.arrays
    meets = [at[valid] for at, valid in circle_meets(p, np.array(radius), slack)]
    # ends on the circle stand for arcs along it, and for tangent ones that end just before they touch it
    meets += [ends[np.abs(np.abs(ends) - radius) <= slack] for ends in (p.start, p.end)]
    found = np.unique(np.angle(np.concatenate(meets)))
    angles = [a for k, a in enumerate(found.tolist()) if k == 0 or a - found[k - 1] > SAME]
    if not angles:
        return FULL if bool(region.contains(np.array([radius + 0j]), slack)[0]) else ()
    gaps = list(pairwise([*angles, angles[0] + TURN]))
    middles = np.array([cmath.rect(radius, 0.5 * (a + b)) for a, b in gaps])
    inside = region.contains(middles, slack)
    return union([gap for gap, yes in zip(gaps, inside, strict=True) if yes] + [(a, a) for a in angles])


# ---- orientations at a point -----------------------------------------------------------------------------------------


def seen_from_tip(whole: Chain) -> Region:
    """W': where the axis of the first moving joint can be, seen from the tip."""
    return reached(from_tip(replace(after_first(whole), size=whole.size)))


def orientations(whole: Chain, z: complex, seen: Region | None = None) -> tuple[Interval, ...]:
    """The orientations of the tip at z, as disjoint intervals in rad; low = high for a single one.

    Args:
        whole: the chain.
        z: x + iy, m.
        seen: its :func:`seen_from_tip`, if the first moving joint turns freely and it is at hand.
    """
    whole = merged(whole)
    if math.hypot(z.real, z.imag) > (1.0 + SAME) * whole.size:  # too far: its square need not even be a number
        return ()
    if not whole.turns:
        return _limited(whole, z)
    offset = whole.links[0][1] - z
    towards = cmath.phase(offset)
    found = circle_in(seen_from_tip(whole) if seen is None else seen, abs(offset), whole.size)
    return union([(towards - b, towards - a) for a, b in found])


def _limited(whole: Chain, z: complex) -> tuple[Interval, ...]:
    joints, (rotation, shift) = whole.joints, whole.links[-1]
    if joints and joints[-1].kind == "R" and abs(shift) <= 1e-12 * whole.size:  # it turns the tip on the spot
        rest = replace(whole, joints=joints[:-1], links=whole.links[:-1])
        turned = cmath.phase(rotation)
        return widened(_limited(rest, z), joints[-1].lower + turned, joints[-1].upper + turned)
    if bool(_on_axis(whole, np.array([z]))[0]):  # the first joint turns everything about the tip
        turned = cmath.phase(whole.links[0][0])
        return widened(_limited(after_first(whole), 0j), joints[0].lower + turned, joints[0].upper + turned)
    if len(joints) < 2:
        return _single(whole, z)
    ends, between = _ends(whole), _between(whole)
    target = np.array([z])
    found = ends.orientations(target)[:, 0]
    found = np.sort(found[np.isfinite(found)])
    angles = [a for k, a in enumerate(found.tolist()) if k == 0 or a - found[k - 1] > SAME]
    if not angles:
        return FULL if bool(between.reached(target, np.zeros(1))[0]) else ()
    gaps = list(pairwise([*angles, angles[0] + TURN]))
    middles = np.array([0.5 * (a + b) for a, b in gaps])
    inside = between.reached(np.full(len(gaps), z), middles)
    return union([gap for gap, yes in zip(gaps, inside, strict=True) if yes] + [(a, a) for a in angles])


def _on_axis(whole: Chain, z: Array) -> Array:
    """Whether points (k,) are on the axis of the first moving joint, one of several."""
    turns = len(whole.joints) > 1 and whole.joints[0].kind == "R"
    found: Array = turns & (np.abs(z - whole.links[0][1]) <= 1e-11 * whole.size)
    return found


def _single(whole: Chain, z: complex) -> tuple[Interval, ...]:
    """At most one joint: one orientation, if the point is reached."""
    if not bool(reached(whole).contains(np.array([z]), SAME * whole.size)[0]):
        return ()
    turned = cmath.phase(whole.links[0][0] * whole.links[-1][0]) if whole.joints else cmath.phase(whole.links[0][0])
    if whole.joints and whole.joints[0].kind == "R":
        turned += cmath.phase((z - whole.links[0][1]) / (whole.links[0][0] * whole.links[1][1]))
    return union([(turned, turned)])


class Everywhere:
    """Whether points (k,) are reached with every orientation, for many calls with one chain."""

    def __init__(self, whole: Chain) -> None:
        whole = merged(whole)
        self.wrist = 0.0
        while whole.joints and whole.joints[-1].kind == "R" and abs(whole.links[-1][1]) <= 1e-12 * whole.size:
            self.wrist += whole.joints[-1].upper - whole.joints[-1].lower
            whole = replace(whole, joints=whole.joints[:-1], links=whole.links[:-1])
        self.chain = whole
        self.region = reached(whole) if self.wrist >= TURN - SAME else None
        self.ends = _ends(whole) if len(whole.joints) >= 2 else None
        self.between = _between(whole) if len(whole.joints) >= 2 else None

    def __call__(self, z: Array) -> Array:
        """The answer for points (k,)."""
        if self.region is not None:
            return self.region.contains(z)
        if self.ends is None or self.between is None:
            return np.zeros(len(z), dtype=bool)
        step = max(1, 100_000 // max(self.ends.count, 1))
        parts = [self._chunk(z[k : k + step]) for k in range(0, len(z), step)]
        found = np.concatenate(parts) if parts else np.zeros(0, dtype=bool)
        for k in np.nonzero(_on_axis(self.chain, z))[0]:
            found[k] = widened(_limited(self.chain, complex(z[k])), 0.0, self.wrist) == FULL
        return found

    def _chunk(self, z: Array) -> Array:
        """No gap between neighbouring ends is wider than what the wrist closes, unless poses inside are reached."""
        assert self.ends is not None and self.between is not None
        angles = np.sort(self.ends.orientations(z), axis=0)  # nan last
        following = np.roll(angles, -1, axis=0)
        count = np.isfinite(angles).sum(axis=0)
        some = np.nonzero(count)[0]
        following[count[some] - 1, some] = angles[0, some] + TURN
        gaps = np.nan_to_num(following - angles)
        widest = gaps.argmax(axis=0)
        everyone = np.arange(len(z))
        # where no orientation ends, one stands for all; else the widest gap goes first, as the likeliest to stay open
        middle = np.where(count > 0, angles[widest, everyone] + 0.5 * gaps[widest, everyone], 0.0)
        yes: Array = self.between.reached(z, middle)
        yes |= (count > 0) & (gaps[widest, everyone] <= SAME + self.wrist)
        gaps[widest, everyone] = 0.0
        row, column = np.nonzero((gaps > SAME + self.wrist) & yes)
        closed = self.between.reached(z[column], angles[row, column] + 0.5 * gaps[row, column])
        yes[column[~closed]] = False
        return yes


# ---- postures in closed form -----------------------------------------------------------------------------------------


def _ends(whole: Chain) -> Pairs:
    """Every combination in which the orientation can end: two joints move, the others are at a limit or aligned."""
    _check(whole)
    count = len(whole.joints)
    rows: list[Row] = [
        ((whole.joints[i], whole.joints[j]), (before, bridge, after))
        for i in range(count)
        for j in range(i + 1, count)
        for bridge in _bridges(whole, i, j)
        for before in _locked(whole, 0, i, whole.links[0])
        for after in _locked(whole, j + 1, count, whole.links[j + 1])
    ]
    return Pairs(rows, whole.size, len(rows) + 1)


def _between(whole: Chain) -> Triples:
    """Combinations of which one reaches any pose that can be reached: three joints move.

    Suppose a pose is reached. Lower the last joint's value as far as the others can make up for it: it ends at its
    lower limit, or with the axes of all joints that are not at a limit on one line. In the first case the chain is a
    joint shorter, and the same holds for it.
    """
    _check(whole)
    rows: list[Row] = []
    tail = whole.links[-1]
    for k in range(len(whole.joints) - 1, 1, -1):
        for i in range(k):
            for j in range(i + 1, k):
                three = (whole.joints[i], whole.joints[j], whole.joints[k])
                if all(joint.kind == "P" for joint in three):  # no three slides decide a pose
                    continue
                rows += [
                    (three, (before, bridge, middle, tail))
                    for bridge in _bridges(whole, i, j)
                    for before in _locked(whole, 0, i, whole.links[0])
                    for middle in _locked(whole, j + 1, k, whole.links[j + 1])
                ]
        tail = then(then(whole.links[k], whole.joints[k].at(whole.joints[k].lower)), tail)
    return Triples(rows, whole.size, BLOCK)


def _check(whole: Chain) -> None:
    limited = sum(not joint.free for joint in whole.joints)
    if limited > MOST or len(whole.joints) > MOST + 3:
        raise InputError(
            f"orientations: {len(whole.joints)} moving joints, {limited} of them limited, the first among them; "
            f"up to {MOST} limited ones are accepted (or a first joint that turns freely)"
        )


def _stops(joint: Moving) -> tuple[float, ...]:
    """The limits at which a joint can stand; none for one that turns freely."""
    return () if joint.free else (joint.lower, joint.upper)


def _locked(whole: Chain, start: int, stop: int, before: Move) -> Iterator[Move]:
    """The motions through joints start to stop - 1, each at one of its limits, and their links."""
    for values in product(*(_stops(joint) for joint in whole.joints[start:stop])):
        move = before
        for k, value in zip(range(start, stop), values, strict=True):
            move = then(then(move, whole.joints[k].at(value)), whole.links[k + 1])
        yield move


@dataclass(frozen=True)
class _Line:
    """The line that the free joints' axes lie on: a point of it (None: unknown so far) and its direction."""

    at: complex
    along: complex


def _bridges(whole: Chain, i: int, j: int) -> Iterator[Move]:
    """The motions from just after joint i to just before joint j, the joints between at a limit or aligned with both.

    A joint between that is free lies on the line through the free joints' axes: its value is what puts the next free
    joint on that line.
    """

    def walk(k: int, move: Move, line: _Line | None, waiting: tuple[int, Move] | None) -> Iterator[Move]:
        if k == j:
            yield from (full for full, _ in settled(k, move, line, waiting))
            return
        joint = whole.joints[k]
        for value in _stops(joint):
            yield from walk(k + 1, then(then(move, joint.at(value)), whole.links[k + 1]), line, waiting)
        for full, through in settled(k, move, line, waiting):
            through = through or _line(whole.joints[i].kind, joint.kind, full, whole.size)
            if through is not None:
                yield from walk(k + 1, whole.links[k + 1], through, (k, full))

    def settled(
        k: int, move: Move, line: _Line | None, waiting: tuple[int, Move] | None
    ) -> Iterator[tuple[Move, _Line | None]]:
        """The motions from joint i to before the free joint k, now that the one waiting can be aligned with it."""
        if waiting is None or line is None:
            yield move, None
            return
        before = waiting[1]
        for value in _aligned(whole.joints[waiting[0]], before, line, whole.joints[k].kind, move, whole.size):
            yield then(then(before, whole.joints[waiting[0]].at(value)), move), line

    yield from walk(i + 1, whole.links[i + 1], None, None)


def _line(first: str, second: str, move: Move, size: float) -> _Line | None:
    """The line through a joint at the origin and one at ``move``; None if they are on one axis or both slide."""
    if first == "R" and second == "R":
        return _Line(0j, move[1] / abs(move[1])) if abs(move[1]) > 1e-12 * size else None
    if first == "R":
        return _Line(0j, 1j * move[0])
    return _Line(move[1], 1j) if second == "R" else None


def _aligned(joint: Moving, before: Move, line: _Line, kind: str, move: Move, size: float) -> list[float]:
    """Values of a free joint that put the next free one, of a kind and at ``move`` from it, on the line."""
    if joint.kind == "P":
        if kind == "P":
            return []
        value = (before[0].conjugate() * (line.at - before[1])).real - move[1].real
        return [value] if joint.lower - SAME * size <= value <= joint.upper + SAME * size else []
    ahead = move[1] if kind == "R" else -1j * move[0]
    if abs(ahead) <= 1e-12 * size:
        return []
    base = cmath.phase(line.along / (before[0] * ahead))
    found = []
    for angle in (base, base + math.pi):
        turned = (angle - joint.lower + SAME) % TURN
        if turned <= joint.upper - joint.lower + 2 * SAME:
            found.append(joint.lower + turned - SAME)
    return found


#: A combination: the joints that move, and the motions before, between and after them.
Row = tuple[tuple[Moving, ...], tuple[Move, ...]]


class Combinations:
    """Combinations of some joints that move, in groups of the same kinds, as arrays."""

    def __init__(self, rows: list[Row], size: float, block: int) -> None:
        self.size, self.count = size, len(rows)
        self.groups: list[tuple[str, list[Array], list[Array]]] = []
        words = ["".join(joint.kind for joint in joints) for joints, _ in rows]
        for kinds in dict.fromkeys(words):
            same = [row for row, word in zip(rows, words, strict=True) if word == kinds]
            for start in range(0, len(same), block):
                joints, moves = zip(*same[start : start + block], strict=True)
                limits = [np.array([[(j.lower, j.upper)] for j in column]) for column in zip(*joints, strict=True)]
                self.groups.append((kinds, limits, [np.array(m)[:, None] for m in zip(*moves, strict=True)]))

    def within(self, kinds: str, values: tuple[Array, ...], limits: list[Array], valid: Array) -> Array:
        """Whether what exists is also within the limits."""
        for kind, value, (lower, upper) in zip(
            kinds, values, (np.moveaxis(pair, -1, 0) for pair in limits), strict=True
        ):
            if valid.any():
                valid = valid & _within(kind, value, lower, upper, self.size)
        return valid


class Pairs(Combinations):
    """Two joints move: two coordinates give two unknowns."""

    def orientations(self, z: Array) -> Array:
        """The orientations (s, k) at points (k,), in [-pi, pi); nan where the combination does not reach the point."""
        found = [np.full((1, len(z)), np.nan)]
        for kinds, limits, (before, bridge, after) in self.groups:
            target = before[..., 0].conj() * (z - before[..., 1])
            fixed = np.angle(before[..., 0] * bridge[..., 0] * after[..., 0])
            for first, second, valid in _two(kinds, target, bridge, after[..., 1], self.size):
                angle = fixed + (first if kinds[0] == "R" else 0.0) + (second if kinds[1] == "R" else 0.0)
                valid = self.within(kinds, (first, second), limits, valid)
                found.append(np.where(valid, np.mod(angle + math.pi, TURN) - math.pi, np.nan))
        return np.concatenate(found)


class Triples(Combinations):
    """Three joints move: a pose gives three unknowns."""

    def reached(self, z: Array, angle: Array) -> Array:
        """Whether the poses (k,) are reached in one of the combinations; what one block reaches the next leaves out."""
        open_ = np.arange(len(z))
        for kinds, limits, (before, bridge, middle, after) in self.groups:
            # J1 bridge J2 middle J3 = before^-1 pose after^-1
            turned = before[..., 0].conj() * np.exp(1j * angle[open_]) * after[..., 0].conj()
            target = before[..., 0].conj() * (z[open_] - before[..., 1]) - turned * after[..., 1]
            found = np.zeros(len(open_), dtype=bool)
            for values, valid in _three(kinds, turned, target, bridge, middle, self.size):
                found |= self.within(kinds, values, limits, valid).any(axis=0)
            open_ = open_[~found]
            if not len(open_):
                break
        yes = np.ones(len(z), dtype=bool)
        yes[open_] = False
        return yes


def _within(kind: str, value: Array, lower: Array, upper: Array, size: float) -> Array:
    with np.errstate(invalid="ignore"):
        if kind == "P":
            inside: Array = (value >= lower - SAME * size) & (value <= upper + SAME * size)
        else:
            ahead = value - lower + SAME
            inside = ahead - TURN * np.floor(ahead / TURN) <= upper - lower + 2.0 * SAME
    return inside


def _half_chord(radius: Array, away: Array, size: float) -> tuple[Array, Array]:
    """Half of what a circle cuts from a line at a distance from its centre, 0 where they touch; whether they meet."""
    gap = radius - np.abs(away)
    half = np.where(gap <= TOUCH * size, 0.0, np.sqrt(np.maximum(gap, 0.0) * (radius + np.abs(away))))
    return half, gap >= -1e-11 * size


def _two(kinds: str, w: Array, bridge: Array, d: Array, size: float) -> Iterator[tuple[Array, Array, Array]]:
    """Joint values with J1 (b + beta J2 d) = w, and whether they exist; two solutions."""
    beta, b = bridge[..., 0], bridge[..., 1]
    touch = TOUCH * size
    with np.errstate(divide="ignore", invalid="ignore"):
        if kinds == "RR":
            links, away = (np.abs(b), np.abs(d)), np.abs(w)
            along, across = triangle(*links, away)  # where the second axis is: seen from the first, towards w
            near, far = np.abs(links[0] - links[1]), links[0] + links[1]
            exists = (away >= near - 1e-11 * size) & (away <= far + 1e-11 * size) & (away > 1e-12 * size)
            exists &= np.minimum(*links) > 1e-12 * size
            across = np.where((np.abs(away - near) <= touch) | (np.abs(away - far) <= touch), 0.0, across)
            at, turned = np.angle(w * b.conj()), np.angle(b * (beta * d).conj())
            for sign in (-1.0, 1.0):
                bend = sign * np.arctan2(across, along)
                yield at + bend, turned - bend - sign * np.arctan2(across, away - along), exists
        elif kinds == "RP":
            base = b + beta * d
            along = (base.conj() * beta).real
            half, exists = _half_chord(np.abs(w), (base.conj() * beta).imag, size)
            for sign in (-1.0, 1.0):
                slide = -along + sign * half
                yield np.angle(w * (base + beta * slide).conj()), slide, exists
        elif kinds == "PR":
            across = (w - b).imag
            half, exists = _half_chord(np.abs(d), across, size)
            for sign in (-1.0, 1.0):
                angle = np.arctan2(across, sign * half)
                yield (w - b).real - sign * half, angle - np.angle(beta * d), exists
        else:
            rest = w - b - beta * d
            second = rest.imag / beta.imag
            yield rest.real - beta.real * second, second, np.broadcast_to(np.abs(beta.imag) > 1e-12, rest.shape)


def _three(
    kinds: str, g: Array, tau: Array, bridge: Array, middle: Array, size: float
) -> Iterator[tuple[tuple[Array, Array, Array], Array]]:
    """Joint values with J1 bridge J2 middle J3 = (g, tau), and whether they exist.

    Where the third axis comes to lie on the first, any first angle would do; then some other combination has the pose
    too, because the first and the third joint can turn against each other until one of them is at a limit.
    """
    beta, b, gamma, c = bridge[..., 0], bridge[..., 1], middle[..., 0], middle[..., 1]
    turned = np.angle(g * (beta * gamma).conj())
    if kinds[2] == "R":
        for first, second, exists in _two(kinds[:2], tau, bridge, c, size):
            others = (first if kinds[0] == "R" else 0.0) + (second if kinds[1] == "R" else 0.0)
            yield (first, second, turned - others), exists
        return
    with np.errstate(divide="ignore", invalid="ignore"):
        if kinds == "RRP":
            u = tau - g * gamma.conj() * c
            along = (g.conj() * u).real
            half, exists = _half_chord(np.abs(b), (g.conj() * u).imag, size)
            exists &= np.abs(b) > 1e-12 * size
            for sign in (-1.0, 1.0):
                slide = along + sign * half
                first = np.angle((u - g * slide) * b.conj())
                yield (first, turned - first, slide), exists
        elif kinds == "RPP":
            rest = beta.conj() * (np.exp(-1j * turned) * tau - b) - c
            last = rest.imag / gamma.imag
            yield (turned, rest.real - gamma.real * last, last), np.isfinite(last)
        elif kinds == "PRP":
            rest = tau - b - g * gamma.conj() * c
            last = rest.imag / g.imag
            yield (rest.real - g.real * last, turned, last), np.isfinite(last)
