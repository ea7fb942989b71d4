"""The design space of orthogonal 3R arms: every surface from its event, and that no other one separates."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest
import sympy as sp
from flint import Ordering, fmpz_mpoly_ctx

from chainrule.cuspidality.classify import classify_orthogonal_3r, topology_orthogonal_3r
from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.domains import TOPOLOGIES
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, evaluator
from chainrule.derive import orthogonal_designs as designs
from chainrule.derive import regional_3r
from chainrule.derive.orthogonal_3r import normal_form
from chainrule.derive.orthogonal_designs import D2, D3, D4, R2, M, N, P, X, modulo
from chainrule.errors import InputError

A2, B2 = designs.squares()
SIGNS = list(product((1, -1), repeat=2))


def zero(expression):
    """Whether a polynomial in the lengths and M is zero, M^2 = A^2 B^2."""
    return modulo(expression) == 0


def test_product_of_the_radii():
    assert sp.expand(A2 * B2 - (X**2 - 4 * D2**2 * D3**2)) == 0
    assert zero(M**2 - A2 * B2) and not zero(M - X)


# ---- two double roots, and four equal ones -------------------------------------------------------------------------


@pytest.mark.parametrize(("mean", "sense"), SIGNS)
def test_double_contact(mean, sense):
    """E = kappa (cos(theta3 - phi) - h)^2 at these targets: every harmonic agrees."""
    assert designs.contact_residuals(mean, sense) == (0, 0, 0, 0)


def test_double_contact_can_fail(monkeypatch):
    found = designs.double_contact(1, -1)
    monkeypatch.setattr(designs, "double_contact", lambda mean, sense: found | {"u0": found["u0"] + D2**2})
    assert any(residual != 0 for residual in designs.contact_residuals(1, -1))


@pytest.mark.parametrize(("mean", "sense"), SIGNS)
def test_four_equal_roots(mean, sense):
    """2 d4^2 = -+P -+ N / M for the four choices; C1 is the one with positive d4^2 and positive z^2."""
    found = designs.double_contact(mean, sense)
    square = (-mean * sense * P + sense * N / M) / 2
    assert zero(sp.expand((4 * sense * square * M - found["h_kappa"]) * M))
    twice_height = sp.expand(sp.expand(8 * D2**2 * found["z_squared"]).subs(D4**2, square) * M)
    # 2 d2^2 M z^2 is +-d2^2 times a bracket that is positive for every arm (next test)
    bracket = M * (D3**2 - D2**2) * mean + (D3**2 - D2**2) ** 2 + R2**2 * (D3**2 + D2**2)
    if mean != sense:
        assert zero(sp.expand(twice_height - 4 * mean * D2**2 * bracket))


def test_signs_of_four_equal_roots():
    """M P > |N|: two choices have no d4. The bracket is positive: one of the others has z^2 < 0, and C1 z^2 > 0."""
    assert sp.expand(A2 * B2 * P**2 - N**2 - 4 * D2**4 * D3**2 * R2**2) == 0
    rest = (D3**2 - D2**2) ** 2 + R2**2 * (D3**2 + D2**2)  # positive
    assert (
        sp.expand(rest**2 - A2 * B2 * (D3**2 - D2**2) ** 2 - 4 * D2**2 * D3**2 * R2**4) == 0
    )  # so rest > M |d3^2 - d2^2|


@pytest.mark.parametrize(("mean", "sense"), SIGNS)
def test_node_surfaces(mean, sense):
    """z^2 = 0 at a double contact: 4 d4^2 = (A - B)^2 or (A + B)^2; for the other two choices d4^2 is negative."""
    found = sp.expand(designs.double_contact(mean, sense)["z_squared"] * 4 * D2**2)
    if mean != sense:
        square = (X - mean * M) / 2
        assert zero(4 * square - (A2 + B2 - mean * 2 * M))  # (A -+ B)^2
        assert zero(sp.expand(found.subs(D4**2, square)))
        assert not zero(sp.expand(found.subs(D4**2, square + D2**2)))
    else:
        slope, constant = sp.Poly(found, D4).coeff_monomial(D4**2), found.subs(D4, 0)
        # d4^2 = -constant / slope, both of the sign of ``sense``, as M > |P - d2^2| and M > |w|
        assert zero(slope - 2 * (sense * M - P + D2**2))
        assert sp.expand(A2 * B2 - (P - D2**2) ** 2 - 4 * D2**2 * R2**2) == 0
        w = D3**2 - D2**2 - R2**2
        assert zero(constant - 2 * D2**2 * (w + mean * M))
        assert sp.expand(A2 * B2 - w**2 - 4 * D3**2 * R2**2) == 0


def test_singular_lines():
    """f1 = 0, a factor of det J, has real solutions exactly for d4 >= d3: E2."""
    a, b, c = regional_3r.determinant_parts(normal_form())
    f1 = normal_form().point[0]
    for part in (a, b, c):
        assert regional_3r.quotient(part, f1) is not None
    assert sp.solve(f1.subs(regional_3r.C, sp.Symbol("c")), sp.Symbol("c")) == [-D3 / D4]


# ---- tangency --------------------------------------------------------------------------------------------------------


def test_tangency():
    """d4 = d3 A / (d3 + d2) and d4 = d3 B / |d3 - d2|, squared."""
    first, second = designs.tangency()
    assert sp.expand(first - (D3**2 * A2 - D4**2 * (D3 + D2) ** 2)) == 0
    assert sp.expand(second - (D3**2 * B2 - D4**2 * (D3 - D2) ** 2)) == 0


def test_ends_of_the_singular_curve():
    """The aspect polynomial is what makes the singular curve end: ((d3 + d2) s3 - r2 c3) ((d3 - d2) s3 - r2 c3)."""
    c, s = regional_3r.C, regional_3r.S
    product_ = ((D3 + D2) * s - R2 * c) * ((D3 - D2) * s - R2 * c)
    assert sp.expand(regional_3r.aspect_condition(normal_form()) - regional_3r.reduced(product_)) == 0


# ---- no other surface ------------------------------------------------------------------------------------------------

CONTEXT = fmpz_mpoly_ctx.get(("t", "d2", "d3", "d4", "r2"), Ordering.lex)


def in_flint(expression):
    """A polynomial of SymPy in t and the lengths as one of FLINT."""
    symbols = (regional_3r.T, D2, D3, D4, R2)
    terms = sp.Poly(expression, *symbols).terms()
    return CONTEXT.from_dict({tuple(map(int, powers)): int(factor) for powers, factor in terms})


def half_tangent(condition, degree):
    return sum(e * regional_3r.T**k for k, e in enumerate(regional_3r.in_half_tangent(condition, degree)))


@cache
def cusp_polynomial():
    return in_flint(half_tangent(regional_3r.cusp_condition(normal_form()), 3))


def factors(polynomial):
    """Its irreducible factors, each once."""
    return [factor for factor, _ in polynomial.factor()[1]]


def same(found, expected):
    return len(found) == len(expected) and all(f in expected or -f in expected for f in found)


HARMLESS = [D2, D3, D4, R2, A2, B2, P]


def test_real_cusps_meet_on_C1_only():
    """Factors of the discriminant: what never vanishes; d4^2 = P, no cusp; and C1 with its conjugate, no cusp."""
    expected = [in_flint(e) for e in (*HARMLESS, D4**2 - P)]
    conjugates = in_flint(sp.expand(A2 * B2 * (2 * D4**2 - P) ** 2 - N**2))
    (pair,) = [f for f in factors(conjugates) if f.degrees()[3] > 0]
    assert same(factors(cusp_polynomial().discriminant("t")), [*expected, pair])


def test_double_root_that_is_no_cusp():
    """On d4^2 = d3^2 + r2^2 the double root has z^2 = -(d2 r2^2 / d4^2)^2."""
    found = designs.false_double_root()
    assert found["value"] == 0 and found["slope"] == 0
    assert sp.expand(found["z_squared"] + D2**4 * R2**4) == 0


def test_cusps_reach_z_0_on_C2_C3_C4_only():
    """Factors of the resultant with z^2."""
    first, second = designs.tangency()
    height = in_flint(half_tangent(designs.cusp_height(), 6))
    found = cusp_polynomial().subs({"d2": 1}).resultant(height.subs({"d2": 1}), "t")  # d2 = 1: the unit of length
    expected = [in_flint(e.subs(D2, 1)) for e in (D4, A2, B2, P, first, second)]
    assert same(factors(found), expected)


def test_without_r2_no_arm_is_cuspidal():
    """r2 = 0 is a hypothesis: E is even in theta3 and the cusp polynomial has only s3 = 0 (roots of even order)."""
    arm = normal_form()
    flat = sp.expand(regional_3r.reduced(regional_3r.elimination(arm)).subs(R2, 0))
    assert not flat.has(regional_3r.S)
    condition = sp.factor(regional_3r.reduced(regional_3r.cusp_condition(arm)).subs(R2, 0))
    c, s = regional_3r.C, regional_3r.S
    assert sp.expand(condition - regional_3r.reduced(D3 * D4 * (D2**2 - D3**2) * s**3)) == 0
    assert c in flat.free_symbols


# ---- the condition for being cuspidal --------------------------------------------------------------------------------


def test_printed_condition_is_sufficient_but_not_necessary():
    """C1 as printed in (7) minus the true one, squared: r2^2 d2^2 / (A B) > 0."""
    printed, true = ((P - numerator / M) / 2 for numerator in (designs.printed_numerator(), N))
    assert sp.expand(sp.expand(printed - true) * M - R2**2 * D2**2) == 0


def test_an_arm_between_the_printed_and_the_true_condition():
    """d2, d3, d4, r2 = 1, 2, 0.4, 1: below the printed surface, and with four cusps, so cuspidal."""
    values = dict(zip((D2, D3, D4, R2), (1, 2, sp.Rational(2, 5), 1), strict=True))
    m = sp.sqrt((A2 * B2).subs(values))
    printed, true = (((P - n / M) / 2).subs(M, m).subs(values) for n in (designs.printed_numerator(), N))
    assert float(true) < 0.16 < float(printed)
    assert classify_orthogonal_3r(1, 2, 0.4, 1) == 2
    assert certified_cusps([1, 2, "0.4", 1]).number == 4


# ---- the generated classification -----------------------------------------------------------------------------------


def by_definition(d2, d3, d4, r2):
    """The domain from the paper's surfaces, corrected, with d2 = 1: written independently, lengths positive."""
    d3, d4, r2 = d3 / d2, d4 / d2, r2 / d2
    a, b = np.hypot(d3 + 1, r2), np.hypot(d3 - 1, r2)
    c1 = np.sqrt((d3**2 + r2**2 - ((d3**2 + r2**2) ** 2 - d3**2 + r2**2) / (a * b)) / 2)
    c2 = d3 / (1 + d3) * a
    c3 = np.where(d3 > 1, d3 / np.where(d3 > 1, d3 - 1, 1) * b, np.inf)
    c4 = np.where(d3 < 1, d3 / np.where(d3 < 1, 1 - d3, 1) * b, np.inf)
    return np.select([d4 < c1, d4 < c2, d4 > c3, d4 > c4], [1, 2, 4, 5], 3)


def random_designs(count, seed):
    return np.exp(np.random.default_rng(seed).uniform(-2.5, 2.5, (4, count)))


def test_domains_are_those_of_the_surfaces():
    lengths = random_designs(20_000, 1)
    found = classify_orthogonal_3r(*lengths)
    assert np.array_equal(found, by_definition(*lengths))
    assert found.dtype == np.int8 and set(found) == {1, 2, 3, 4, 5}


def test_cusps_of_the_domains():
    """The number of real roots of the cusp polynomial with z^2 > 0 is that of the domain."""
    lengths = random_designs(300, 2)
    topology = topology_orthogonal_3r(*lengths)
    for k in range(300):
        polynomial = evaluator("cusp_polynomial", ORTHOGONAL_3R)(lengths[:, k])
        roots = np.roots(polynomial[::-1])
        t = roots[np.abs(roots.imag) < 1e-7 * (1 + np.abs(roots))].real
        elbow = np.stack([(1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)], axis=-1)
        cusps = evaluator("triple_point", ORTHOGONAL_3R)(lengths[:, k], elbow)
        assert 2 * (cusps[:, 1] > 0).sum() == TOPOLOGIES[int(topology[k])][0]


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e150, 1e303])
def test_only_ratios_matter(scale):
    lengths = random_designs(500, 3)
    for classified in (classify_orthogonal_3r, topology_orthogonal_3r):
        assert np.array_equal(classified(*lengths), classified(*(scale * lengths)))


def test_signs_do_not_matter():
    lengths = random_designs(200, 4)
    for signs in product((1, -1), repeat=4):
        assert np.array_equal(
            classify_orthogonal_3r(*lengths), classify_orthogonal_3r(*(np.array(signs)[:, None] * lengths))
        )


@pytest.mark.parametrize("design", [(0, 2, 1.5, 1), (1, 0, 1.5, 1), (1, 2, 0, 1), (1, 2, 1.5, 0), (0, 0, 0, 0)])
def test_another_family_has_no_domain(design):
    assert classify_orthogonal_3r(*design) == 0
    assert topology_orthogonal_3r(*design) == 0


def test_designs_on_a_surface_are_not_decided():
    """C2 at a rational point (A = 5), E2, and their neighbours on both sides."""
    assert classify_orthogonal_3r(0.75, 3.25, 4.0625, 3.0) == 0
    for step, number in ((-1e-12, 2), (1e-12, 3)):
        assert classify_orthogonal_3r(0.75, 3.25, 4.0625 * (1 + step), 3.0) == number
    assert topology_orthogonal_3r(1, 2, 2, 1) == 0 and classify_orthogonal_3r(1, 2, 2, 1) == 2
    assert [int(topology_orthogonal_3r(1, 2, 2 * (1 + e), 1)) for e in (-1e-12, 1e-12)] == [3, 4]


def test_equal_lengths():
    """d3 = d2: no surface C3 or C4, domain 3 however long d4; d3 = d4 is E2, which cuts domain 2 only."""
    assert np.array_equal(classify_orthogonal_3r(1, 1, [0.2, 0.8, 1.0, 5.0, 1e6], 1), [1, 2, 2, 3, 3])
    assert classify_orthogonal_3r(2, 1, 1, 0.1) == 2 and topology_orthogonal_3r(2, 1, 1, 0.1) == 0


def test_shapes():
    assert classify_orthogonal_3r(1, np.ones((3, 1)), np.ones(4), 1).shape == (3, 4)
    assert classify_orthogonal_3r(1, 1, np.empty((0, 2)), 1).shape == (0, 2)
    assert classify_orthogonal_3r(1, 2, 1.5, 1).shape == ()
    many = random_designs(20_001, 6)  # over several blocks, and a strided view
    assert np.array_equal(classify_orthogonal_3r(*many[:, ::-1])[::-1], classify_orthogonal_3r(*many))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((1, 2, np.nan, 1), "d4: nan"),
        ((1, [2, np.inf], 1, 1), r"d3\[1\]: inf"),
        (("1", 2, 1, 1), "d2: '1'"),
        ((1, np.ones(2), np.ones(3), 1), "do not broadcast"),
    ],
)
def test_what_is_refused(arguments, message):
    with pytest.raises(InputError, match=message):
        classify_orthogonal_3r(*arguments)
