"""The domain of an orthogonal 3R arm decided exactly: five domains, nine topologies, designs on a surface named.

The separating surfaces of Baili, Wenger and Chablat (equations 2 to 6) for any d2, with X = d3^2 + r2^2,
A^2 = (d3 + d2)^2 + r2^2 and B^2 = (d3 - d2)^2 + r2^2,
    C1: 2 d4^2 = X - (X^2 - (d3^2 - r2^2) d2^2) / (A B),     C2: d4 (d2 + d3) = d3 A,
    C3: d4 (d3 - d2) = d3 B, d3 > d2,                        C4: d4 (d2 - d3) = d3 B, d3 < d2,
and those where nodes come and go, E1: 2 d4 = A - B, E2: d4 = d3, E3: 2 d4 = A + B, are squared until at most A B is
left: every sign is one of p + q sqrt(D) with rational p, q, D. E1 and E3 need not even that: d4^2 = E1^2 or E3^2 are
the roots of x^2 - (X + d2^2) x + d2^2 d3^2.

Nodes. Two pairs of double roots are real outside [E1, E3]; singular curves cross the lines where the point is on axis 2
on both of them in domains 2 (for d4 > d3) and 4, on one in domain 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from chainrule.cuspidality.exact import rational, sign, surd_sign
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, exact_function

#: Cusps of the domains 1 to 5.
CUSPS = (0, 4, 2, 4, 0)
NAMES = ("d2", "d3", "d4", "r2")
SURFACES = ("C1", "C2", "C3", "C4", "E1", "E2", "E3")

#: Topology 1 to 9 of a domain, by its number and whether d4 is below E1, above E2, above E3; its (cusps, nodes).
TOPOLOGIES = {1: (0, 0), 2: (4, 2), 3: (4, 0), 4: (4, 2), 5: (2, 1), 6: (2, 3), 7: (4, 4), 8: (0, 0), 9: (0, 2)}

#: Cusps that are left on a surface between two domains.
_LEFT = {"C1": 0, "C2": 2, "C3": 2, "C4": 0}


@dataclass(frozen=True)
class Domain:
    """Where a design lies in the design space, decided exactly.

    Attributes:
        number: the domain, 1 to 5; None on a surface C1 to C4, which separates two, or where the design is degenerate.
        topology: 1 to 9 (see ``TOPOLOGIES``); None on a surface that changes it, or where degenerate.
        cusps: how many cusps the cross-section has, both signs of z, also on surfaces.
        nodes: how many nodes; None on a surface that changes them, or where the design is degenerate.
        surfaces: the surfaces that it lies on, such as ``("E2",)``.
        degenerate: why it has no domain although it is on no surface, in words; empty otherwise.
    """

    number: int | None
    topology: int | None
    cusps: int
    nodes: int | None
    surfaces: tuple[str, ...]
    degenerate: str

    @property
    def cuspidal(self) -> bool | None:
        """Whether it is cuspidal: where it has a cusp; None on C1 and C4: the theorem is about generic arms."""
        return True if self.cusps else False if self.degenerate or self.number is not None else None

    @property
    def words(self) -> str:
        """The answer in one line."""
        if self.degenerate:
            return f"no domain: {self.degenerate}"
        where = "between two domains" if self.number is None else f"domain {self.number}"
        return where + (f", exactly on {' and '.join(self.surfaces)}" if self.surfaces else "")

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "domain": self.number,
            "topology": self.topology,
            "cusps": self.cusps,
            "nodes": self.nodes,
            "surfaces": list(self.surfaces),
            "degenerate": self.degenerate,
            "cuspidal": self.cuspidal,
            "words": self.words,
        }


def sides(lengths: Sequence[Any]) -> dict[str, int]:
    """The sign of d4 minus each surface's value, of positive rational lengths; -1 where a surface does not exist.

    From the generated polynomials ``exact_sides`` on fractions (``chainrule.derive.orthogonal_designs``).
    """
    found = exact_function("exact_sides", ORTHOGONAL_3R)(np.array(lengths, object))
    whole, factor, radicand, second, third, quadratic, middle, line, gap = found
    across, between = sign(third), sign(quadratic)
    return {
        "C1": surd_sign(whole, factor, radicand),
        "C2": sign(second),
        "C3": across if gap > 0 else -1,
        "C4": across if gap < 0 else -1,
        "E1": 1 if middle > 0 else -between,
        "E2": sign(line),
        "E3": between if middle > 0 else -1,
    }


def exact_domain(d2: Any, d3: Any, d4: Any, r2: Any) -> Domain:
    """The domain of a design, exactly as its lengths are given; a design on a surface is reported as on it.

    Changing the sign of a length mirrors the arm or turns a joint's zero: signs do not matter.

    Args:
        d2: in m, as d3, d4 and r2: an int, Fraction, Decimal, decimal text, or a float at its binary value.
        d3: as d2.
        d4: as d2.
        r2: as d2.

    Raises:
        InputError: what is no such number.

    Example:
        >>> exact_domain(1, 2, "1.5", 1).words, exact_domain(1, 2, 2, 1).words
        ('domain 2', 'domain 2, exactly on E2')
        >>> exact_domain(1, 3, "3.75", 3).words                     # A = 5: a rational point of C2
        'between two domains, exactly on C2'
    """
    lengths = [abs(rational(value, name)) for value, name in zip((d2, d3, d4, r2), NAMES, strict=True)]
    degenerate = _degenerate(lengths)
    if degenerate:
        return Domain(None, None, 0, None, (), degenerate)
    side = sides(lengths)
    on = tuple(name for name in SURFACES if side[name] == 0)
    for name, left in _LEFT.items():
        if name in on:
            return Domain(None, None, left, None, on, "")
    number = 1 if side["C1"] < 0 else 2 if side["C2"] < 0 else 4 if side["C3"] > 0 else 5 if side["C4"] > 0 else 3
    topology = _topology(number, side)
    return Domain(number, topology, CUSPS[number - 1], TOPOLOGIES[topology][1] if topology else None, on, "")


def _topology(number: int, side: dict[str, int]) -> int | None:
    """The topology in a domain; None on a surface that changes it there."""
    below, equal, above = side["E1"], side["E2"], side["E3"]
    if number == 2:
        return None if 0 in (below, equal) else 2 if below < 0 else 4 if equal > 0 else 3
    if number == 3:
        return None if above == 0 else 6 if above > 0 else 5
    if number == 5:
        return None if above == 0 else 9 if above > 0 else 8
    return 1 if number == 1 else 7


def _degenerate(lengths: list[Any]) -> str:
    """Why a design is in no domain, or nothing."""
    reasons = (
        "d2 = 0: axes 1 and 2 intersect",
        "d3 = 0: axes 2 and 3 intersect",
        "d4 = 0: the point lies on axis 3",
        "r2 = 0: never cuspidal",
    )
    return next((reason for reason, length in zip(reasons, lengths, strict=True) if length == 0), "")
