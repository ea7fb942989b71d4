"""Nodes of 3R arms against crossings of finely sampled singular curves."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from chainrule.cuspidality.domains import exact_domain
from chainrule.cuspidality.nodes import certified_nodes
from chainrule.cuspidality.normal_form import Regional
from chainrule.cuspidality.parameters import half_tangent
from chainrule.cuspidality.surds import Surd, square_root

Array = NDArray[Any]


def crossings(curves: list[Array]) -> Array:
    """Where closed polylines (k, 2) cross each other or themselves, each place once."""
    starts = np.concatenate(curves)
    ends = np.concatenate([np.roll(curve, -1, axis=0) for curve in curves])
    steps = ends - starts
    found = []
    for i in range(len(starts)):
        between, others = starts[i + 1 :] - starts[i], steps[i + 1 :]
        below = steps[i, 0] * others[:, 1] - steps[i, 1] * others[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            t = (between[:, 0] * others[:, 1] - between[:, 1] * others[:, 0]) / below
            u = (between[:, 0] * steps[i, 1] - between[:, 1] * steps[i, 0]) / below
        hit = (t > 0) & (t < 1) & (u > 0) & (u < 1)
        found += [starts[i] + value * steps[i] for value in t[hit]]
    distinct: list[Array] = []
    for place in found:
        if all(np.hypot(*(place - other)) > 1e-3 for other in distinct):
            distinct.append(place)
    return np.array(distinct).reshape(-1, 2)


def orthogonal_curves(d2: float, d3: float, d4: float, r2: float, count: int = 700) -> list[Array]:
    """The image of d2 s3 + c2 (d3 s3 - r2 c3) = 0, the second factor of the paper's equation (1), for all theta2."""
    theta2 = 0.0123 + np.linspace(0, 2 * np.pi, count, endpoint=False)
    theta3 = np.unwrap(np.arctan2(np.cos(theta2) * r2, d2 + np.cos(theta2) * d3))
    return [_image(d2, d3, d4, r2, theta2, theta3 + turn) for turn in (0.0, np.pi)]


def _image(d2: float, d3: float, d4: float, r2: float, theta2: Array, theta3: Array) -> Array:
    reach = d3 + d4 * np.cos(theta3)
    return np.stack([np.hypot(d2 + np.cos(theta2) * reach, r2 + d4 * np.sin(theta3)), -np.sin(theta2) * reach], axis=-1)


def general_curves(regional: Regional, count: int = 400) -> Iterator[Array]:
    """The image of the curves det J = a c2 + b s2 + c = 0 in the stretches of theta3 where they are real."""
    from numpy.polynomial import Polynomial

    aspect = [float(x.p) / float(x.q) for x in regional.exact_aspect_polynomial()]
    roots = Polynomial(aspect).roots()
    ends = np.sort(2 * np.arctan(roots[np.abs(roots.imag) < 1e-9].real))
    stretches = (
        [(0.0, 2 * np.pi)] if not len(ends) else list(zip(ends, np.append(ends[1:], ends[0] + 2 * np.pi), strict=True))
    )
    for low, high in stretches:
        middle = np.tan((low + high) / 4)
        if np.polyval(aspect[::-1], middle) < 0:
            continue
        if len(ends):
            theta3 = (low + high) / 2 - (high - low) / 2 * np.cos(np.pi * (np.arange(count) + 0.5) / count)
        else:
            theta3 = np.linspace(low, high, count, endpoint=False)
        a, b, c = np.moveaxis(regional.determinant_terms(theta3), -1, 0)
        spread = np.arccos(np.clip(-c / np.hypot(a, b), -1, 1))
        sides = [regional.image(np.arctan2(b, a) + turn * spread, theta3) for turn in (1, -1)]
        if len(ends):
            yield np.concatenate([sides[0], sides[1][::-1]])
        else:
            yield from sides


def test_nodes_of_orthogonal_arms_are_the_crossings_of_their_curves() -> None:
    rng = np.random.default_rng(5)
    seen = set()
    tried = 0
    while tried < 14:
        design = [1.0, *rng.uniform(0.3, 3.5, 3).round(2)]
        found = certified_nodes(design)
        if exact_domain(*design).topology in seen and tried < 9 and len(seen) < 8:
            continue
        tried += 1
        seen.add(exact_domain(*design).topology)
        expected = crossings(orthogonal_curves(*design))
        assert len(expected) == found.number, design
        for node in found.nodes:
            assert np.hypot(*(expected - [node.rho, node.z]).T).min() < 2e-2, design
    assert len(seen) >= 8


def test_nodes_of_any_arm_are_the_crossings_of_its_curves() -> None:
    rng = np.random.default_rng(6)
    numbers = set()
    for _ in range(10):
        twists = [half_tangent(Fraction(int(x) * 2 + 1, 201)) for x in rng.integers(-200, 200, 2)]
        lengths = [*rng.uniform(0.4, 2.5, 3).round(2), *rng.uniform(-1.5, 1.5, 2).round(2)]
        given = [float(x.p) / float(x.q) for pair in twists for x in pair]
        found = certified_nodes([*twists[0], *twists[1], *lengths])
        expected = crossings(list(general_curves(Regional((*given, *lengths)))))
        assert len(expected) == found.number
        for node in found.nodes:
            assert np.hypot(*(expected - [node.rho, node.z]).T).min() < 2e-2
        numbers.add(found.number)
    assert len(numbers) >= 3


def test_nodes_of_a_design_with_the_point_on_axis_2() -> None:
    found = certified_nodes(
        [1, 3, 5, 3]
    )  # cos(theta3) = -3/5, sin(theta3) = +-4/5: rho^2 = 1 + (3 + 4)^2 or 1 + (3 - 4)^2
    places = [(node.rho, node.z, node.kind) for node in found.nodes if node.kind == "theta2 free"]
    for rho, z, _ in places:
        assert z == 0.0 and rho**2 in (pytest.approx(50), pytest.approx(2))
    assert places


def test_two_nodes_meet_or_turn_isolated_at_a_surface() -> None:
    design = (Fraction(11, 2), Fraction(21, 2), Fraction(33, 2), 12)  # A = 20, B = 13: on E3
    assert certified_nodes(design).events
    counts = [certified_nodes((*design[:2], design[2] * (1 + Fraction(turn, 10**12)), 12)).number for turn in (-1, 1)]
    assert counts[1] - counts[0] == 2


def test_scale_and_mirror_leave_the_nodes() -> None:
    for design in ((1, "1.5", 4, "0.5"), (1, "0.5", 3, "0.2"), (1, 3, 4, 3)):
        found = certified_nodes(design)
        assert found.number == exact_domain(*design).nodes
        points = np.array([(node.rho, node.z) for node in found.nodes])
        scaled = certified_nodes([Fraction(x) * 1024 for x in design])
        np.testing.assert_allclose([(n.rho, n.z) for n in scaled.nodes], 1024 * points, rtol=1e-14, atol=1e-10)
        mirrored = certified_nodes([*design[:3], -Fraction(design[3])])
        np.testing.assert_allclose([(n.rho, n.z) for n in mirrored.nodes], points, rtol=1e-14, atol=1e-14)


def test_numbers_with_square_roots_are_a_field() -> None:
    from flint import fmpq

    root = square_root(fmpq(2))
    assert isinstance(root, Surd) and (root * root - 2).sign() == 0
    assert ((1 + root).inverse() - (root - 1)).sign() == 0  # 1 / (1 + sqrt 2) = sqrt 2 - 1
    nested = square_root(3 + 2 * root)  # = 1 + sqrt 2
    assert (nested - root - 1).sign() == 0 and (nested - root - fmpq(999999, 1000000)).sign() == 1
    assert ((nested + 1 - root).inverse() - fmpq(1, 2)).sign() == 0
    assert square_root(fmpq(49, 4)) == fmpq(7, 2)
