"""Where the tip of a planar arm can be, with which orientations, and where with every one: exact, within the limits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.boundary_pieces import TURN, Arc, Piece, Segment
from chainrule.boundary_tracing import trace
from chainrule.description import Description, check_finite
from chainrule.errors import InputError, shown
from chainrule.orientations import FULL, SAME, Everywhere, circle_in, orientations, seen_from_tip
from chainrule.planar_chains import Chain, chain, merged, reached
from chainrule.regions import Region
from chainrule.sweeping import Turn, levels
from chainrule.tables import Cell, Column, Table, angle_deg, readable

Array = NDArray[Any]
Ring = tuple[float, float]
Interval = tuple[float, float]

#: Squares across the largest extent when a dexterous region without closed form is looked for.
STEPS = 80

#: How far the middle of its polygon's sides may be from the boundary, relative to the size.
STRAIGHT = 1e-5


@dataclass(frozen=True)
class Workspace:
    """The workspaces of a planar arm within its joint limits; lengths in m, angles in rad, areas in m^2.

    Attributes:
        primary: the points the tip can reach, as rings (inner, outer) about the base; () where they are not rings.
        secondary: the points it can reach with every orientation, as rings; a disc has the inner radius 0, a single
            circle twice the same radius; () where there are none, or where they are not rings.
        symmetric: whether the first moving joint is at the base and turns freely, so that both are rings.
        region: the points the tip can reach, with the exact boundary and area; its pieces carry joint values.
        dexterous: the points it can reach with every orientation.
        exact: whether ``dexterous`` is in closed form; else its outline is a polygon, whose corners are on the
            boundary to 1e-9 of the size (parts narrower than 1/80 of the region's extent may be missing). What
            :meth:`contains` and :meth:`orientations` say is exact in every case.
        name: the arm's.
    """

    primary: tuple[Ring, ...]
    secondary: tuple[Ring, ...]
    symmetric: bool
    region: Region = field(repr=False)
    dexterous: Region = field(repr=False)
    exact: bool
    name: str
    _chain: Chain = field(repr=False)
    _seen: Region | None = field(repr=False)
    _everywhere: Everywhere | None = field(repr=False)

    @property
    def area(self) -> float:
        """Area of the reachable region."""
        return self.region.area

    def contains(self, x: Any, y: Any, *, every_orientation: bool = False) -> Any:
        """Whether the tip reaches the points (x, y); arrays broadcast, a point that is not finite is not reached.

        Args:
            x: m.
            y: m.
            every_orientation: whether it must be reached with every orientation.

        Returns:
            An array of bool, or one bool for two numbers.

        Raises:
            InputError: what is not numbers; arrays that do not broadcast.

        Example:
            >>> from chainrule import planar_3r
            >>> workspace(planar_3r(1.0, 0.5, 0.25)).contains([0.2, 0.3], 0.0).tolist()
            [False, True]
        """
        z = _points(x, y)
        flat = z.reshape(-1)
        farthest = (1.0 + SAME) * self._chain.size
        good = (np.abs(flat.real) <= farthest) & (np.abs(flat.imag) <= farthest)
        found = np.zeros(flat.shape, dtype=bool)
        if every_orientation and self._everywhere is not None:
            found[good] = self._everywhere(flat[good])
        else:
            region = self.dexterous if every_orientation else self.region
            found[good] = region.contains(flat[good], 1e-11 * self._chain.size)
        return found.reshape(z.shape) if z.ndim else bool(found[0])

    def orientations(self, x: float, y: float) -> tuple[Interval, ...]:
        """The orientations of the tip at (x, y): disjoint intervals (low, high) of its heading, rad.

        Each low is in (-pi, pi] and high at most 2 pi more; the full circle is (-pi, pi), a single orientation has
        low = high. Empty where the point is not reached.

        Raises:
            InputError: a coordinate that is not a finite number; more than nine limited joints, the first among them.

        Example:
            >>> from chainrule import planar_3r
            >>> workspace(planar_3r(1.0, 0.5, 0.25)).orientations(1.75, 0.0)
            ((0.0, 0.0),)
        """
        z = complex(check_finite(x, "x"), check_finite(y, "y"))
        return orientations(self._chain, z, self._seen)

    def joints(self, piece: Piece) -> tuple[str, ...]:
        """What each joint does along a piece of the boundary, for every joint of the arm.

        "moves"; "lower" or "upper" (at that limit), "fixed" (its limits are equal); or between its limits and
        "stretched" (0), "folded" (pi) or "aligned" (so that the line through its axis and the other free ones goes on).
        """
        moving = {joint.index: joint for joint in self._chain.joints}
        found = []
        for i, (first, last) in enumerate(zip(piece.first, piece.last, strict=True)):
            if i not in moving:
                found.append("fixed")
            elif abs(last - first) > SAME:
                found.append("moves")
            elif not moving[i].free and min(abs(first - moving[i].lower), abs(first - moving[i].upper)) <= SAME:
                found.append("lower" if abs(first - moving[i].lower) <= SAME else "upper")
            elif moving[i].kind == "R" and abs(math.remainder(first, math.pi)) <= 1e-7:
                found.append("stretched" if abs(math.remainder(first, TURN)) <= 1e-7 else "folded")
            else:
                found.append("aligned")
        return tuple(found)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists; every boundary piece with what the joints do along it."""
        boundary = [piece.to_dict() | {"joints": list(self.joints(piece))} for piece in self.region.pieces]
        return {
            "arm": self.name,
            "primary": [list(ring) for ring in self.primary],
            "secondary": [list(ring) for ring in self.secondary],
            "symmetric": self.symmetric,
            "area": self.region.area,
            "boundary": boundary,
            "loops": [len(loop) for loop in self.region.loops],
            "dexterous": {"exact": self.exact, **self.dexterous.to_dict()},
        }


def _points(x: Any, y: Any) -> Array:
    """Coordinates as complex numbers; without arithmetic, because infinite ones are welcome."""
    try:
        both = list(np.broadcast_arrays(np.asarray(x), np.asarray(y)))
    except ValueError:
        both = []
    if not both or any(part.dtype.kind not in "iuf" for part in both):
        raise InputError(f"x = {shown(x)}, y = {shown(y)}: arrays of numbers that broadcast are accepted")
    z = np.empty(both[0].shape, dtype=complex)
    z.real, z.imag = both
    return z


def workspace(arm: Arm) -> Workspace:
    """The exact workspaces of a planar arm of revolute and prismatic joints, within its joint limits.

    A revolute joint without limits, with one only, or with a range of a full turn or more turns freely. The boundary
    of the reachable set consists of arcs and segments in closed form (see :mod:`chainrule.sweeping`); without limits it
    is the ring of :func:`ring`, with :func:`dexterous_rings` inside (De Luca, exercise 1, for three links and a short
    last one).

    Raises:
        InputError: an arm in space; a prismatic joint without two finite limits (its workspace has no bounds); more
            than nine limited joints, the first among them, if they turn far enough for every orientation.

    Example:
        >>> from chainrule import planar_3r
        >>> arm = planar_3r(1.0, 0.5, 0.25)
        >>> workspace(arm).primary, workspace(arm).secondary
        (((0.25, 1.75),), ((0.75, 1.25),))
        >>> limited = workspace(arm.with_limits(position=[(0.0, 2.0), (-2.0, 2.0), None]))
        >>> limited.primary, round(limited.area, 9)
        ((), 4.077101645)
    """
    return _of(checked_arm(arm).description)


@lru_cache(maxsize=32)
def _of(arm: Description) -> Workspace:
    whole = chain(arm)
    simple = merged(whole)
    region = reached(whole)
    axis = simple.links[0][1]
    symmetric = simple.turns and abs(axis) <= 1e-12 * whole.size
    seen, everywhere, exact = None, None, True
    if simple.turns:
        seen = seen_from_tip(simple)
        secondary = rings_inside(seen, simple.size)
        dexterous = _annuli(secondary, axis)
    else:
        everywhere, dexterous = _limited(simple, region)
        exact = everywhere is None or everywhere.region is not None or not dexterous.loops
        secondary = _rings(dexterous) if exact else ()
    if arm.kinds == "R" * arm.n and len(whole.joints) == arm.n and all(joint.free for joint in whole.joints):
        lengths = arm.geometry.lengths  # type: ignore[union-attr]  # chain() refuses all but planar arms
        primary: tuple[Ring, ...] = (ring(lengths),)
        secondary = dexterous_rings(lengths)
    else:
        primary = _rings(region)
    return Workspace(primary, secondary, symmetric, region, dexterous, exact, arm.name, whole, seen, everywhere)


# ---- rings -----------------------------------------------------------------------------------------------------------


def ring(lengths: Sequence[float]) -> Ring:
    """Radii between which the tip of a planar chain of revolute joints can be: max(0, 2 max l - sum l) and sum l.

    One link longer than all others together cannot be folded back onto the base; else the base itself is reached.

    Example:
        >>> ring([1.0, 0.5, 0.25])
        (0.25, 1.75)
    """
    sizes = [abs(length) for length in lengths]
    if not sizes:
        return 0.0, 0.0
    longest = max(sizes)
    rest = list(sizes)
    rest.remove(longest)
    return max(0.0, longest - math.fsum(rest)), math.fsum(sizes)


def dexterous_rings(lengths: Sequence[float]) -> tuple[Ring, ...]:
    """Radii that the tip of a planar chain of revolute joints reaches with every orientation.

    With c the last link and [ra, Ra] the ring of the others: every point at distance c from the tip must lie in that
    ring, so [0, min(c - ra, Ra - c)] if ra <= c <= Ra, together with [ra + c, Ra - c] if ra + 2c <= Ra. The two may
    touch (one disc), be single radii, or be absent.

    Example:
        >>> dexterous_rings([1.0, 0.5, 0.25]), dexterous_rings([1.0, 0.9, 0.5])
        (((0.75, 1.25),), ((0.0, 0.4), (0.6, 1.4)))
    """
    last = abs(lengths[-1])
    inner, outer = ring(lengths[:-1])
    found: list[Ring] = []
    if inner <= last <= outer:
        found.append((0.0, min(last - inner, outer - last)))
    if inner + 2.0 * last <= outer:
        found.append((inner + last, outer - last))
    if len(found) == 2 and found[0][1] >= found[1][0]:  # they touch: one disc
        found = [(0.0, found[1][1])]
    return tuple(found)


def rings_inside(region: Region, size: float = 0.0) -> tuple[Ring, ...]:
    """The radii at which the whole circle about the origin lies in a region.

    A radius at which some piece of the boundary passes from nearer to farther is none of them; at the others the
    circle is all inside or all outside.
    """
    parts = [tuple(sorted((abs(part.point(0.0)), abs(part.point(1.0))))) for part in levels(region.pieces, Turn)]
    close = 1e-11 * region.size
    breaks = [0.0]
    for value in sorted(value for part in parts for value in part):
        if value - breaks[-1] > close:
            breaks.append(value)
    found: list[Ring] = []
    for low, high in pairwise(breaks):
        middle = 0.5 * (low + high)
        crossed = any(a < middle < b for a, b in parts)
        if not crossed and bool(region.around(np.array([middle + 0j]))[0]):
            found = [*found[:-1], (found[-1][0], high)] if found and found[-1][1] == low else [*found, (low, high)]
    singles = [r for r in breaks if not any(low <= r <= high for low, high in found)]
    return tuple(sorted(found + [(r, r) for r in singles if circle_in(region, r, size) == FULL]))


def _annuli(rings: tuple[Ring, ...], centre: complex) -> Region:
    """Rings about a point as a region."""

    def circle(radius: float, turn: float) -> Piece:
        return Arc(centre, radius, -math.pi, turn) if radius > 0.0 else Segment(centre, centre)

    loops, curves = [], []
    for low, high in rings:
        if high > low:
            loops += [(circle(high, TURN),), *([(circle(low, -TURN),)] if low > 0.0 else [])]
        else:
            curves.append(circle(high, TURN))
    return Region(tuple(loops), tuple(curves))


def _rings(region: Region) -> tuple[Ring, ...]:
    """A region as rings about the base, if it is; else nothing."""
    close = 1e-10 * region.size
    radii: list[tuple[float, bool]] = []
    for loop in [*region.loops, *((curve,) for curve in region.curves)]:
        if all(piece.length == 0.0 and abs(piece.point(0.0)) <= close for piece in loop):
            radii.append((0.0, True))
            continue
        arcs = [piece for piece in loop if isinstance(piece, Arc) and abs(piece.centre) <= close]
        whole = abs(math.fsum(arc.turn for arc in arcs))
        if len(arcs) < len(loop) or max(a.radius for a in arcs) - min(a.radius for a in arcs) > close:
            return ()
        if abs(whole - TURN) > 1e-9:
            return ()
        radii.append((arcs[0].radius, loop[0] in region.curves))
    found = [(radius, radius) for radius, flat in radii if flat]
    edges = sorted(radius for radius, flat in radii if not flat)
    edges = edges if len(edges) % 2 == 0 else [0.0, *edges]
    return tuple(sorted(found + list(zip(edges[::2], edges[1::2], strict=True))))


# ---- every orientation behind a limited first joint ------------------------------------------------------------------


def _limited(whole: Chain, region: Region) -> tuple[Everywhere | None, Region]:
    """Where a chain whose first moving joint is limited reaches every orientation."""
    turning = math.fsum(joint.upper - joint.lower for joint in whole.joints if joint.kind == "R")
    if turning < TURN - SAME or len(whole.joints) < 2:
        return None, Region()
    everywhere = Everywhere(whole)
    if everywhere.region is not None:  # the last joint turns the tip on the spot, all the way round
        return everywhere, everywhere.region
    corners = np.array([piece.point(t) for piece in region.pieces for t in np.linspace(0.0, 1.0, 9)])
    low, high = complex(corners.real.min(), corners.imag.min()), complex(corners.real.max(), corners.imag.max())

    def inside(z: Array) -> Array:
        found = region.around(z)
        found[found] = everywhere(z[found])
        return found

    steps = STEPS if len(whole.joints) < 5 else STEPS // 2
    return everywhere, Region(trace(inside, low, high, steps, 1e-9 * whole.size, STRAIGHT * whole.size))


# ---- in words and tables ---------------------------------------------------------------------------------------------


def summary(found: Workspace) -> str:
    """Both sets in one sentence."""
    return " ".join(findings(found))


def findings(found: Workspace, at: Sequence[float] | None = None) -> list[str]:
    """What the tip reaches, what with every orientation, and its orientations at a point: a line each."""
    if found.primary:
        first = f"Reached: {_in_words(found.primary)} from the base"
    elif found.region.loops:
        first = f"Reached: {readable(found.area, 4)} m²"
    else:
        first = f"Reached: a curve, {readable(math.fsum(c.length for c in found.region.curves), 4)} m long"
    if found.secondary:
        second = f"with every orientation: {_in_words(found.secondary)}"
    elif found.dexterous.loops:
        second = f"with every orientation: {readable(found.dexterous.area, 4)} m²"
    else:
        second = "nowhere with every orientation"
    lines = [f"{first},", second]
    if at is not None:
        lines.append(f"at ({readable(at[0], 4)}, {readable(at[1], 4)}) m: {orientations_in_words(found, at)}")
    return lines


def orientations_in_words(found: Workspace, at: Sequence[float]) -> str:
    """The orientations at a point, in degrees."""
    intervals = found.orientations(float(at[0]), float(at[1]))
    if not intervals:
        return "not reached"
    if intervals == FULL:
        return "every orientation"
    words = []
    for low, high in intervals:
        degrees = [readable(round(math.degrees(angle), 1) + 0.0) for angle in (low, high)]
        words.append(f"{degrees[0]}°" if high - low < 1e-7 else f"{degrees[0]}° to {degrees[1]}°")
    return "orientation " + ", ".join(words)


def _in_words(rings: Sequence[Ring]) -> str:
    words = [readable(b, 4) if b - a < 1e-12 else f"{readable(a, 4)} to {readable(b, 4)}" for a, b in rings]
    return " and ".join(words) + " m"


def rings_table(found: Workspace) -> Table:
    """The radii of both sets, where they are rings."""
    rows: list[tuple[Cell, ...]] = [("reached", *ring) for ring in found.primary]
    rows += [("reached with every orientation", *ring) for ring in found.secondary]
    columns = (Column("set", "points"), Column("inner", "inner radius", "m"), Column("outer", "outer radius", "m"))
    return Table("Rings about the base", columns, tuple(rows))


def boundary_table(found: Workspace) -> Table:
    """Every piece of the boundary: its shape, where from and to, and what the joints do along it."""

    def coordinates(z: complex) -> tuple[float, float]:
        """What is zero up to rounding is shown as zero."""
        x, y = (0.0 if abs(value) < 1e-13 * found.region.size else value for value in (z.real, z.imag))
        return x, y

    rows: list[tuple[Cell, ...]] = []
    numbered = [(i, loop) for i, loop in enumerate(found.region.loops, 1)] + [(0, found.region.curves)]
    for number, loop in numbered:
        for piece in loop:
            name: Cell = number if number else "curve"
            if isinstance(piece, Arc):
                turns = (angle_deg(piece.start), angle_deg(piece.start + piece.turn))
                shape: tuple[Cell, ...] = ("arc", *coordinates(piece.centre), piece.radius, *turns)
            else:
                shape = ("segment", None, None, None, None, None)
            ends = (*coordinates(piece.point(0.0)), *coordinates(piece.point(1.0)))
            rows.append((name, *shape, *ends, states_in_words(found.joints(piece))))
    columns = (
        Column("loop", "loop"),
        Column("kind", "kind"),
        Column("centre_x", "centre x", "m"),
        Column("centre_y", "centre y", "m"),
        Column("radius", "radius", "m"),
        Column("from_deg", "from", "deg"),
        Column("to_deg", "to", "deg"),
        Column("x0", "from x", "m"),
        Column("y0", "from y", "m"),
        Column("x1", "to x", "m"),
        Column("y1", "to y", "m"),
        Column("why", "joints along it"),
    )
    return Table("Boundary, the inside on its left", columns, tuple(rows))


def states_in_words(states: Sequence[str]) -> str:
    """What the joints do along an edge.

    >>> states_in_words(("moves", "upper", "stretched", "stretched"))
    'q1 moves, q2 at upper limit, q3 and q4 stretched'
    """
    words = {"lower": "at lower limit", "upper": "at upper limit"}
    groups: dict[str, list[str]] = {}
    for i, state in enumerate(states, 1):
        if state != "fixed":
            groups.setdefault(words.get(state, state), []).append(f"q{i}")
    texts = []
    for state, names in sorted(groups.items(), key=lambda item: item[0] != "moves"):
        several = " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]
        texts.append(f"{several} {'move' if state == 'moves' and len(names) > 1 else state}")
    return ", ".join(texts)
