"""The design space of orthogonal 3R arms: exact domains, topologies, designs on surfaces."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.domains import CUSPS, TOPOLOGIES, exact_domain
from chainrule.cuspidality.exact import rational
from chainrule.cuspidality.nodes import certified_nodes
from chainrule.errors import InputError

#: Rational points of the surfaces: found among integers whose A and B, or whose product A B, are whole.
ON_SURFACE = [
    ("C1", (5, 6, 2, 2)),
    ("C1", (7, 24, Fraction(4, 5), 17)),
    ("C2", (1, 3, Fraction(15, 4), 3)),
    ("C2", (Fraction(3, 4), Fraction(13, 4), Fraction(65, 16), 3)),
    ("C3", (1, 4, Fraction(20, 3), 4)),
    ("C4", (4, 1, Fraction(5, 3), 4)),
    ("E1", (Fraction(11, 2), Fraction(21, 2), Fraction(7, 2), 12)),  # A = 20, B = 13
    ("E2", (1, 2, 2, 1)),
    ("E2", (3, 2, 2, Fraction(7, 5))),
    ("E3", (Fraction(11, 2), Fraction(21, 2), Fraction(33, 2), 12)),
]


def designs(seed: int, count: int) -> list[tuple[Any, ...]]:
    rng = np.random.default_rng(seed)
    return [tuple(int(x) for x in rng.integers(1, 1000, 4) * rng.choice([1, 3, 8], 4)) for _ in range(count)]


def surfaces_at_40_digits(d2: Any, d3: Any, d4: Any, r2: Any) -> dict[str, Any]:
    """d4 minus the surfaces as the paper prints them (corrected, scaled by d2)."""
    with mpmath.workdps(60):
        d2, d3, d4, r2 = (mpmath.mpf(x.numerator) / x.denominator for x in map(Fraction, (d2, d3, d4, r2)))
        a, b = mpmath.hypot(d3 + d2, r2), mpmath.hypot(d3 - d2, r2)
        x = d3**2 + r2**2
        found = {
            "C1": mpmath.sqrt((x - (x**2 - (d3**2 - r2**2) * d2**2) / (a * b)) / 2),
            "C2": d3 * a / (d2 + d3),
            "E1": (a - b) / 2,
            "E2": d3,
            "E3": (a + b) / 2,
        }
        if d3 != d2:
            found["C3" if d3 > d2 else "C4"] = d3 * b / abs(d3 - d2)
        return {name: d4 - value for name, value in found.items()}


def test_the_domain_is_the_one_of_the_paper_s_surfaces() -> None:
    for design in designs(1, 400):
        above = {name: value > 0 for name, value in surfaces_at_40_digits(*design).items()}
        expected = 1 if not above["C1"] else 2 if not above["C2"] else 3
        expected = 4 if above.get("C3") else 5 if above.get("C4") else expected
        found = exact_domain(*design)
        if not found.surfaces:
            assert found.number == expected
            assert (found.cusps, found.nodes) == TOPOLOGIES[found.topology or 0]


def test_cusps_and_nodes_of_every_topology_are_those_counted() -> None:
    seen = set()
    for design in designs(2, 150):
        found = exact_domain(*design)
        if found.topology is None:
            continue
        seen.add(found.topology)
        assert certified_cusps(design).number == found.cusps
        assert certified_nodes(design).number == found.nodes
    assert seen == set(TOPOLOGIES)


@pytest.mark.parametrize(("surface", "design"), ON_SURFACE)
def test_a_design_on_a_surface_is_reported_as_on_it(surface: str, design: tuple[Any, ...]) -> None:
    with mpmath.workdps(50):
        assert abs(surfaces_at_40_digits(*design)[surface]) < mpmath.mpf(10) ** -45
    found = exact_domain(*design)
    assert surface in found.surfaces and surface in found.words
    assert (found.number is None) == surface.startswith("C")
    assert certified_cusps(design).number == found.cusps


@pytest.mark.parametrize("distance", [Fraction(1, 10**3), Fraction(1, 10**9), Fraction(1, 10**12), Fraction(1, 10**30)])
@pytest.mark.parametrize(("surface", "design"), ON_SURFACE)
def test_counts_beside_a_surface(surface: str, design: tuple[Any, ...], distance: Fraction) -> None:
    d2, d3, d4, r2 = design
    sides = [exact_domain(d2, d3, d4 * (1 + turn * distance), r2) for turn in (-1, 1)]
    for turn, found in zip((-1, 1), sides, strict=True):
        beside = (d2, d3, d4 * (1 + turn * distance), r2)
        assert not found.surfaces
        assert (certified_cusps(beside).number, certified_nodes(beside).number) == (found.cusps, found.nodes)
    first, second = sides
    if surface.startswith("C"):
        assert first.number != second.number and first.cusps != second.cusps
        assert (first.number, second.number) == {"C1": (1, 2), "C2": (2, 3), "C3": (3, 4), "C4": (3, 5)}[surface]
    else:
        assert first.number == second.number


def test_the_domain_is_the_same_at_every_scale_and_for_mirrored_arms() -> None:
    for design in designs(3, 30):
        found = exact_domain(*design)
        for scale in (Fraction(1, 7), Decimal("1e-9"), 10**20):
            assert exact_domain(*(Fraction(x) * Fraction(scale) for x in design)) == found
        d2, d3, d4, r2 = design
        for mirrored in ((d2, d3, d4, -r2), (-d2, d3, d4, r2), (d2, -d3, d4, r2), (d2, d3, -d4, r2)):
            assert exact_domain(*mirrored) == found
            assert certified_cusps(mirrored).number == found.cusps


def test_degenerate_designs_are_named() -> None:
    for place, word in enumerate(("axes 1 and 2", "axes 2 and 3", "axis 3", "never cuspidal")):
        design = [1, 2, 3, 1]
        design[place] = 0
        found = exact_domain(*design)
        assert found.number is None and found.topology is None and word in found.words and found.cuspidal is False
        assert certified_cusps(design).nongeneric and not certified_cusps(design).cusps
        assert certified_nodes(design).nongeneric and not certified_nodes(design).nodes


def test_equal_lengths_are_no_exception() -> None:
    for design in ((1, 1, 1, 1), (1, 1, "1.5", "0.5"), (1, 1, 3, "0.25"), (2, 1, 1, 3)):
        found = exact_domain(*design)
        assert found.number is not None
        assert certified_cusps(design).number == found.cusps == CUSPS[found.number - 1]


def test_floats_count_at_their_binary_value() -> None:
    third = 1.0 / 3.0
    assert exact_domain(1, third, third, 1).surfaces == ("E2",)
    assert exact_domain(1, third, Fraction(1, 3), 1).surfaces == ()
    assert exact_domain(1, "0.1", Decimal("0.1"), 1).surfaces == ("E2",)


@pytest.mark.parametrize(
    "wrong", ["1/3", "__import__('os')", "nan", "1e9999", float("inf"), True, None, "1_0", [1], "٣"]
)
def test_other_input_is_refused_in_one_line(wrong: Any) -> None:
    with pytest.raises(InputError, match=r"^d3: .* accepted$") as caught:
        exact_domain(1, wrong, 1, 1)
    assert "\n" not in str(caught.value)


def test_decimal_text_is_read_exactly() -> None:
    assert rational("-1.25e-2") == rational(Fraction(-1, 80))
    assert rational("  .5 ") == rational(0.5)
    assert rational(np.int64(3)) == rational(3) == rational(np.float64(3.0))
