"""Where the tip of a planar arm can be, and where with every orientation: exact rings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.errors import InputError

Ring = tuple[float, float]


@dataclass(frozen=True)
class Workspace:
    """Workspaces as rings about the base, inner and outer radius in m; joints without limits.

    Attributes:
        primary: points the tip can reach.
        secondary: points it can reach with every orientation; none, one or two rings.
    """

    primary: tuple[Ring, ...]
    secondary: tuple[Ring, ...]

    def to_dict(self) -> dict[str, Any]:
        """Plain lists."""
        return {"primary": [list(ring) for ring in self.primary], "secondary": [list(r) for r in self.secondary]}


def ring(lengths: Sequence[float]) -> Ring:
    """Radii between which the tip of a planar chain of revolute joints can be: max(0, 2 max l - sum l) and sum l.

    One link longer than all others together cannot be folded back onto the base; else the base itself is reached.

    Example:
        >>> ring([1.0, 0.5, 0.25])
        (0.25, 1.75)
    """
    sizes = [abs(length) for length in lengths]
    longest = max(sizes)
    rest = list(sizes)
    rest.remove(longest)
    return max(0.0, longest - math.fsum(rest)), math.fsum(sizes)


def dexterous_rings(lengths: Sequence[float]) -> tuple[Ring, ...]:
    """Radii that the tip of a planar chain of revolute joints reaches with every orientation.

    With c the last link and [ra, Ra] the ring of the others: every point at distance c from the tip must lie in that
    ring, so [0, min(c - ra, Ra - c)] if ra <= c <= Ra, together with [ra + c, Ra - c] if ra + 2c <= Ra.

    Example:
        >>> dexterous_rings([1.0, 0.5, 0.25])
        ((0.75, 1.25),)
    """
    if len(lengths) < 2:
        return ()
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


def workspace(arm: Arm) -> Workspace:
    """The exact workspaces of a planar arm with revolute joints, their limits left aside.

    Raises:
        InputError: any other arm.

    Example:
        >>> from chainrule import planar_3r
        >>> workspace(planar_3r(1.0, 0.5, 0.25)).primary
        ((0.25, 1.75),)
    """
    geometry = arm.description.geometry
    if not isinstance(geometry, Planar) or "P" in arm.kinds:
        raise InputError(f"{arm.name}: the exact workspace is known for planar arms with revolute joints only")
    return Workspace((ring(geometry.lengths),), dexterous_rings(geometry.lengths))
