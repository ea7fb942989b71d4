"""The normal form of any 3R arm: the elimination, det J, cusp and aspect conditions, and the count of roots, proved."""

from __future__ import annotations

import random
from functools import cache

import pytest
import sympy as sp
from flint import Ordering, fmpz_mpoly_ctx

from chainrule.derive import chain, orthogonal_3r, regional_3r, regional_postures
from chainrule.derive.program import Steps, closed_form, variables
from chainrule.derive.regional_3r import C, S, T
from chainrule.description import Transform

GENERAL, ORTHOGONAL = regional_3r.arm(), orthogonal_3r.normal_form()
RIGHT = regional_3r.right_angled(GENERAL)
C2, S2 = regional_3r.SHOULDER.symbols
RHO_SQUARED, Z = regional_3r.TARGET.symbols

RING = fmpz_mpoly_ctx.get(tuple(str(s) for s in (*GENERAL.inputs.symbols, C, S, C2, S2, T)), Ordering.degrevlex)
VALUES = dict(zip((*GENERAL.inputs.symbols, C, S, C2, S2, T), RING.gens(), strict=True))


def in_ring(expression):
    """A SymPy polynomial with whole coefficients as a polynomial of FLINT."""
    if expression.is_Add or expression.is_Mul:
        parts = [in_ring(part) for part in expression.args]
        total = parts[0]
        for part in parts[1:]:
            total = total + part if expression.is_Add else total * part
        return total
    if expression.is_Pow:
        return in_ring(expression.base) ** int(expression.exp)
    return VALUES[expression] if expression.is_Symbol else RING.constant(int(expression))


RELATIONS = [
    in_ring(c**2 + s**2 - 1) for c, s in ((C, S), (C2, S2), (GENERAL.ca2, GENERAL.sa2), (GENERAL.ca3, GENERAL.sa3))
]


def vanishes(expression):
    """Whether a polynomial is zero modulo the four relations c^2 + s^2 = 1, a Groebner basis."""
    rest = in_ring(expression)
    for relation in RELATIONS:
        _, rest = divmod(rest, relation)
    return rest == 0


def test_vanishes_can_fail():
    assert vanishes(C**4 - (1 - S**2) ** 2)
    assert not vanishes(C**4 - (1 + S**2) ** 2)


def placed(arm):
    """(x, y, z) at theta1 = 0 with every step written out."""
    return closed_form(regional_3r.unturned(arm))["point"]


def energy_on_solutions(arm):
    """E with rho^2 and z those that theta2 and theta3 reach."""
    x, y, z = placed(arm)
    return regional_3r.elimination(arm).subs({RHO_SQUARED: x**2 + y**2, Z: z})


def chain_3r():
    """The same arm as a chain of transforms."""
    ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3 = GENERAL.inputs.symbols
    eye = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    links = [chain.link(Transform())]
    for c, s, d, r in ((ca2, sa2, d2, r2), (ca3, sa3, d3, r3)):
        links.append(chain.Link(((1, 0, 0), (0, c, -s), (0, s, c)), (d, -s * r, c * r)))
    tool = chain.Link(tuple(tuple(sp.Integer(e) for e in row) for row in eye), (d4, sp.Integer(0), sp.Integer(0)))
    links = tuple(
        chain.Link(tuple(tuple(sp.sympify(e) for e in row) for row in link.rotation), link.translation)
        for link in links
    )
    return chain.Chain("RRR", links, tool, (variables("q", 3), GENERAL.inputs))


def at_zero(expression, arm):
    """Sines and cosines by their symbols, theta1 = 0."""
    q1, q2, q3 = arm.q
    names = {sp.sin(q1): 0, sp.cos(q1): 1, sp.sin(q2): S2, sp.cos(q2): C2, sp.sin(q3): S, sp.cos(q3): C}
    return sp.sympify(expression).subs(names)


def test_the_point_is_that_of_the_chain():
    arm = chain_3r()
    for mine, theirs in zip(placed(GENERAL), closed_form(chain.placement(arm, "position"))["position"], strict=True):
        assert vanishes(mine - at_zero(theirs, arm))


def test_postures_are_zeros_of_the_elimination():
    assert vanishes(energy_on_solutions(GENERAL))
    assert not vanishes(energy_on_solutions(GENERAL) + GENERAL.d2)


def determinant(arm):
    a, b, c = regional_3r.determinant_parts(arm)
    return a * C2 + b * S2 + c


def test_determinant_is_that_of_the_jacobian():
    arm = chain_3r()
    entries = closed_form(chain.jacobian(arm, "position"))["jacobian"]
    expected = sp.Matrix(3, 3, [at_zero(e, arm) for e in entries]).det(method="berkowitz")
    assert vanishes(determinant(GENERAL) - expected)


def test_determinant_of_the_orthogonal_family():
    q2, q3 = orthogonal_3r.orthogonal_chain().q[1:]
    names = {sp.sin(q2): S2, sp.cos(q2): C2, sp.sin(q3): S, sp.cos(q3): C}
    assert vanishes(orthogonal_3r.determinant().subs(names) - determinant(ORTHOGONAL))


def test_slope_of_the_elimination_is_proportional_to_the_determinant():
    """dE/dtheta3 = -8 d2 sa2 det J on solutions: postures side by side have opposite signs of det J."""
    x, y, z = placed(GENERAL)
    slope = regional_3r.turned(regional_3r.elimination(GENERAL)).subs({RHO_SQUARED: x**2 + y**2, Z: z})
    assert vanishes(slope + 8 * GENERAL.d2 * GENERAL.sa2 * determinant(GENERAL))


@pytest.mark.parametrize("arm", [GENERAL, ORTHOGONAL], ids=["general", "orthogonal"])
def test_aspect_condition(arm):
    a, b, c = regional_3r.determinant_parts(arm)
    divided = (arm.d3 + arm.d4 * C) ** 2 if arm is ORTHOGONAL else 1
    assert vanishes(arm.d4**2 * divided * regional_3r.aspect_condition(arm) - (a**2 + b**2 - c**2))


def test_triple_roots():
    """With U and V of the two linear conditions, E' and E'' vanish, and E is the cusp condition up to a factor."""
    arm = GENERAL
    g3, g4, _ = arm.slopes
    s, d, k = arm.sa2**2, arm.d2**2, arm.d3 * arm.ca2 * arm.sa3
    rho1, rho2 = regional_3r.triple_conditions(arm)
    p = rho1 * regional_3r.turned(g4) - rho2 * g4
    q = g3 * rho2 - regional_3r.turned(g3) * rho1
    u, v = sp.symbols("U V")
    energy = s * u**2 + 4 * d * v**2 - 4 * d * s * arm.width
    moved = {u: -2 * arm.d4 * g3, v: -arm.d4 * g4}

    def turn(expression):
        return regional_3r.turned(expression) + sum(sp.diff(expression, x) * rate for x, rate in moved.items())

    def put(expression):
        """U = 2 P / (s k), V = Q / (d k), times (s d k)^2."""
        terms = sp.Poly(sp.expand(expression), u, v).terms()
        return sum(f * (2 * p * d) ** i * (q * s) ** j * (s * d * k) ** (2 - i - j) for (i, j), f in terms)

    assert vanishes(put(turn(energy)))
    assert vanishes(put(turn(turn(energy))))
    assert vanishes(put(energy) - 4 * d * s * regional_3r.cusp_condition(arm))


def test_cusp_condition_at_right_angles():
    """For alpha2 = +-90 deg the general condition is the square of the one that takes its place."""
    general = regional_3r.cusp_condition(GENERAL).subs(GENERAL.ca2, 0)
    special = regional_3r.cusp_condition(RIGHT)
    assert vanishes(sp.expand(general) - GENERAL.sa2**6 * special**2)
    assert RIGHT.right_angle and not GENERAL.right_angle


@pytest.mark.parametrize("arm", [GENERAL, RIGHT, ORTHOGONAL], ids=["general", "right", "orthogonal"])
def test_polynomials_are_the_conditions(arm):
    """In the half tangent, at random fractions: the programs that are generated are the conditions derived."""
    chance = random.Random(5)
    numbers = {s: sp.Rational(chance.randint(-30, 30), 7) for s in arm.inputs.symbols}
    numbers |= {GENERAL.ca2: sp.Rational(3, 5), GENERAL.sa2: sp.Rational(4, 5)}
    numbers |= {GENERAL.ca3: sp.Rational(5, 13), GENERAL.sa3: sp.Rational(12, 13)}
    target = {RHO_SQUARED: sp.Rational(7, 3), Z: sp.Rational(-2, 5)}
    t = sp.Rational(chance.randint(1, 50), 11)
    angle = {C: (1 - t**2) / (1 + t**2), S: 2 * t / (1 + t**2)}
    for program, condition, degree in (
        (regional_3r.quartic(arm), regional_3r.elimination(arm), 2),
        (regional_3r.cusp_polynomial(arm), regional_3r.cusp_condition(arm), 3 if arm.right_angle else 6),
        (regional_3r.aspect_polynomial(arm), regional_3r.aspect_condition(arm), 2 if arm is ORTHOGONAL else 4),
    ):
        (entries,) = closed_form(program).values()
        assert len(entries) == 2 * degree + 1
        value = sum(e.subs(numbers | target) * t**k for k, e in enumerate(entries))
        assert value == condition.subs(numbers | target).subs(angle) * (1 + t**2) ** degree != 0


def test_quotient_needs_a_divisor():
    assert regional_3r.quotient((C + 1) * S + C**2 - 1, C + 1) == S + C - 1
    with pytest.raises(ValueError, match="does not divide"):
        regional_3r.quotient(S, C + 1)


# ---- the number of real roots ---------------------------------------------------------------------------------------


A, B, G, DELTA, EPS, LAMBDA = sp.symbols("alpha b g delta eps lambda", real=True)


@cache
def counted():
    """The steps of the count, with the coefficients as symbols."""
    steps = Steps()
    energy = regional_postures.Trigonometric(A, B, G, DELTA, EPS, sp.Symbol("doubt"))
    regional_postures.counted(steps, energy)
    known = {}
    for step in steps.steps:
        known[step.symbol] = step.expression.xreplace(known)
    return {str(symbol): value for symbol, value in known.items()}


def test_pencil():
    """The cubic is the determinant of the pencil, and its discriminant that of the quartic up to a positive factor."""
    conic = sp.Matrix([[DELTA - LAMBDA, EPS, B], [EPS, -DELTA - LAMBDA, G], [B, G, A + LAMBDA]])
    k, m = B**2 + G**2, DELTA**2 + EPS**2
    n = DELTA * (B**2 - G**2) + 2 * EPS * B * G
    cubic = LAMBDA**3 + A * LAMBDA**2 + (k - m) * LAMBDA + n - A * m
    assert sp.expand(conic.det() - cubic) == 0
    found = counted()["discriminant"]
    assert sp.expand(27 * sp.discriminant(cubic, LAMBDA) - found) == 0
    energy = A + 2 * B * C + 2 * G * S + DELTA * (C**2 - S**2) + 2 * EPS * C * S
    quartic = regional_3r.in_half_tangent(energy, 2)
    a, b, c, d, e = quartic[::-1]
    i, j = 12 * a * e - 3 * b * d + c**2, 72 * a * c * e + 9 * b * c * d - 27 * a * d**2 - 27 * e * b**2 - 2 * c**3
    assert sp.expand((4 * i**3 - j**2) - 4096 * found) == 0
    # u is minus the sum of the principal minors; at the roots its three values have the symmetric functions used
    minors = sum(conic.extract(rows, rows).det() for rows in ([0, 1], [0, 2], [1, 2]))
    u = LAMBDA**2 + 2 * A * LAMBDA + m + k
    assert sp.expand(minors + u) == 0
    x = sp.Symbol("x")
    values = sp.Poly(sp.resultant(cubic, x - u, LAMBDA), x)
    lead = values.coeff_monomial(x**3)
    first, second = (sp.expand(sign * values.coeff_monomial(x**p) / lead) for sign, p in ((-1, 2), (1, 1)))
    assert sp.expand(first - counted()["first"]) == 0
    assert sp.expand(second - counted()["second"]) == 0


@pytest.mark.parametrize(
    ("number", "coefficients"),
    [
        (0, [3, 1, 0, 1, 0]),  # 3 + 2 c + cos 2 theta
        (2, [0, 1, 0, 0, 0]),
        (2, [0, 1, 0, sp.Rational(1, 4), 0]),
        (4, [0, 0, 0, 1, 1]),
        (4, [0, 0, sp.Rational(1, 8), 0, -1]),
        (0, [-2, 0, 0, 0, 1]),
    ],
)
def test_count_by_hand(number, coefficients):
    values = dict(zip((A, B, G, DELTA, EPS), coefficients, strict=True))
    discriminant, first, second = (counted()[name].subs(values) for name in ("discriminant", "first", "second"))
    assert number == (2 if discriminant < 0 else 4 if first > 0 and second > 0 else 0)
