"""Cusps of 3R arms: two certified counters that share nothing, events, scale, and the arms with the most cusps."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from chainrule.cuspidality.counting import count_doubtful, count_postures
from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.exact import number_of_real_roots, rational, real_roots, sign_at, surd_sign
from chainrule.cuspidality.invariants import cusps_by_invariants
from chainrule.cuspidality.nodes import certified_nodes
from chainrule.cuspidality.normal_form import exact_function
from chainrule.cuspidality.parameters import exact_parameters, half_tangent
from chainrule.errors import InputError

#: An arm with alpha2 = 90 deg and eight cusps, found among random ones.
EIGHT = [*half_tangent(1), *half_tangent("0.8"), "1.87", "1.46", "0.26", "0.4", "-2.14"]


def random_arm(rng: np.random.Generator) -> list[Any]:
    tangents = [half_tangent(Fraction(int(rng.integers(-300, 300)) * 2 + 1, 201)) for _ in range(2)]
    lengths = [Fraction(int(x), 100) for x in rng.integers(1, 300, 3)]
    return [*tangents[0], *tangents[1], *lengths, *(Fraction(int(x), 100) for x in rng.integers(-300, 300, 2))]


def test_two_counters_agree_on_orthogonal_arms() -> None:
    rng = np.random.default_rng(0)
    numbers = set()
    for _ in range(400):
        design = [int(x) for x in rng.integers(1, 4000, 4)]
        found = certified_cusps(design)
        assert found.number == cusps_by_invariants(design)
        numbers.add(found.number)
    assert numbers == {0, 2, 4}


def test_two_counters_agree_on_any_arm_and_numbers_are_even() -> None:
    rng = np.random.default_rng(1)
    numbers = set()
    for _ in range(150):
        arm = random_arm(rng)
        found = certified_cusps(arm)
        assert found.number == cusps_by_invariants(arm)
        assert found.number % 2 == 0
        numbers.add(found.number)
    assert {0, 2, 4} <= numbers


def test_an_arm_has_eight_cusps() -> None:
    assert certified_cusps(EIGHT).number == 8 == cusps_by_invariants(EIGHT)


def test_a_cusp_is_a_triple_root() -> None:
    rng = np.random.default_rng(2)
    for arm in [[1, 2, "1.5", 1], EIGHT, *(random_arm(rng) for _ in range(20))]:
        parameters = exact_parameters(arm)
        for cusp in certified_cusps(arm).cusps:
            target = np.array([rational(cusp.rho) ** 2, rational(cusp.z)], object)
            quartic = [mpmath.mpf(int(c.p)) / int(c.q) for c in exact_function("quartic")(parameters, target)]
            derivatives = [quartic]
            for _ in range(3):
                derivatives.append([k * c for k, c in enumerate(derivatives[-1])][1:])
            t = mpmath.tan(cusp.theta3 / 2)
            size = [sum(abs(c * t**k) for k, c in enumerate(p)) for p in derivatives]
            value = [abs(sum(c * t**k for k, c in enumerate(p))) for p in derivatives]
            assert all(value[k] < 1e-7 * size[k] for k in range(3))


def test_four_equal_roots_are_an_event_on_c1() -> None:
    found = certified_cusps([5, 6, 2, 2])
    assert not found.cusps and [event.event for event in found.events] == ["four equal roots"] * 2
    assert cusps_by_invariants([5, 6, 2, 2]) is None


def test_a_line_that_is_touched_is_an_event_on_c2() -> None:
    found = certified_cusps([1, 3, "3.75", 3])
    assert found.number == 2 and [event.event for event in found.events] == ["theta2 free"]


def test_cusps_scale_with_the_arm_and_are_mirrored_with_r2() -> None:
    for design in ([1, 2, "1.5", 1], [1, "1.5", 4, "0.5"]):
        found = certified_cusps(design)
        points = np.array([(c.rho, c.z) for c in found.cusps])
        scaled = certified_cusps([rational(x) * 1024 for x in design])
        np.testing.assert_allclose([(c.rho, c.z) for c in scaled.cusps], 1024 * points, rtol=1e-15)
        mirrored = certified_cusps([*design[:3], -rational(design[3])])
        np.testing.assert_allclose([(c.rho, c.z) for c in mirrored.cusps], points, rtol=1e-15, atol=1e-15)


def test_radii_hold_between_two_computations() -> None:
    scale = Fraction(3**63)
    found = certified_cusps([1, 2, "1.5", 1]).cusps
    other = certified_cusps([Fraction(x) * scale for x in (1, 2, "1.5", 1)]).cusps
    for a, b in zip(found, other, strict=True):
        assert a.radius < 1e-14
        allowed = Fraction(a.radius) + Fraction(b.radius) / scale
        assert abs(Fraction(a.rho) - Fraction(b.rho) / scale) <= allowed
        assert abs(Fraction(a.z) - Fraction(b.z) / scale) <= allowed


# ---- numbers of postures -----------------------------------------------------------------------------------------


def test_postures_are_counted_as_the_real_roots_of_the_quartic() -> None:
    rng = np.random.default_rng(3)
    for arm in ([1, 2, "1.5", 1], EIGHT, random_arm(rng)):
        parameters = exact_parameters(arm)
        targets = np.stack([rng.uniform(0, 16, 100), rng.uniform(-3, 3, 100)], axis=-1)
        numbers = count_doubtful(arm, targets, np.full(100, -9), np.arange(100) % 2 == 0)
        assert (numbers[1::2] == -9).all()
        for target, number in zip(targets[::2].tolist(), numbers[::2], strict=True):
            exact = np.array([rational(x) for x in target], object)
            quartic = list(exact_function("quartic")(parameters, exact))
            assert number == number_of_real_roots(quartic) == count_postures(arm, target).number


def test_the_point_on_axis_2_leaves_theta2_free() -> None:
    found = count_postures([1, 3, 5, 1], [26, 0])  # c3 = -3/5, s3 = 4/5: rho^2 = d2^2 + (4 + r2)^2
    assert found.free == ("theta2",) and 2 in found.multiplicities and sum(found.multiplicities) in (2, 4)


def test_the_point_on_axis_1_leaves_theta1_free() -> None:
    assert count_postures([1, 2, "1.5", 1], [0, 0, 1]).free == ("theta1",)


def test_a_target_on_a_singular_curve_has_a_double_posture() -> None:
    # theta2 = 0, d2 = 1, d3 = r2 = 3: tan(theta3) = r2 / (d2 + d3), c3 = 4/5, s3 = 3/5; d4 = 5: rho^2 = 8^2 + 6^2
    found = count_postures([1, 3, 5, 3], [100, 0])
    assert max(found.multiplicities) == 2


@pytest.mark.parametrize("wrong", [[1], [1, 2, 3, 4], [-1, 0], ["x", 0]])
def test_wrong_targets_are_refused(wrong: list[Any]) -> None:
    with pytest.raises(InputError):
        count_postures([1, 2, 3, 4], wrong)


@pytest.mark.parametrize("wrong", [[1, 2, 3], "1234", 5, [0, 1, 1, 1, 1, 1, 1, 1, 1]])
def test_wrong_arms_are_refused(wrong: Any) -> None:
    for question in (certified_cusps, certified_nodes, cusps_by_invariants):
        with pytest.raises(InputError):
            question(wrong)


# ---- exact numbers -----------------------------------------------------------------------------------------------


def test_roots_of_products_of_known_factors() -> None:
    from flint import fmpq, fmpq_poly

    rng = np.random.default_rng(4)
    for _ in range(150):
        given = [fmpq(int(rng.integers(-5, 6)), int(rng.integers(1, 4))) for _ in range(rng.integers(1, 6))]
        polynomial = fmpq_poly([int(rng.integers(1, 5)), 0, 1]) if rng.random() < 0.5 else fmpq_poly([1])
        for root in given:
            polynomial = polynomial * fmpq_poly([-root, 1])
        found = real_roots(polynomial)
        assert len(found) == len(set(given)) == number_of_real_roots(polynomial.coeffs())
        for root, known in zip(found, sorted(set(given)), strict=True):
            assert root.lower <= known <= root.upper and root.multiplicity == given.count(known)
            assert sign_at(fmpq_poly([-known, 1]), root) == 0
            assert sign_at(fmpq_poly([fmpq(1, 10**60) - known, 1]), root) == 1


def test_roots_a_hair_apart_are_told_apart() -> None:
    from flint import fmpq, fmpq_poly

    hair = fmpq(1, 10**80)
    polynomial = fmpq_poly([-2, 0, 1]) * fmpq_poly([-2 - hair, 0, 1])
    assert len(real_roots(polynomial)) == 4 == number_of_real_roots(polynomial.coeffs())
    first, second = real_roots(polynomial)[2:]
    assert (sign_at(fmpq_poly([-2, 0, 1]), first), sign_at(fmpq_poly([-2, 0, 1]), second)) == (0, 1)
    assert surd_sign(fmpq(-1), fmpq(1), 1 + hair) == 1
