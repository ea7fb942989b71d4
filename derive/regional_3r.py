"""Any arm of three revolute joints that positions a point, in one normal form: its quartic, cusps, aspects.

In modified Denavit-Hartenberg frames joint 2 has (alpha2, d2, r2), joint 3 has (alpha3, d3, r3) and the point is
(d4, 0, 0) of the last frame; what the base and offsets add is taken off. With c_i, s_i the cosine and sine of theta_i,
    f1 = d3 + d4 c3,   f2 = ca3 d4 s3 - sa3 r3,   f3 = sa3 d4 s3 + ca3 r3
is the point in frame 2, and with A = c2 f1 - s2 f2, B = s2 f1 + c2 f2, F4 = ca2 (f3 + r2)
    rho^2 = x^2 + y^2 = (d2 + A)^2 + (ca2 B - sa2 (f3 + r2))^2,   z = sa2 B + F4,
    R = rho^2 + z^2 = F3 + 2 d2 A,   F3 = f1^2 + f2^2 + f3^2 + r2^2 + 2 r2 f3 + d2^2.
A and B are linear in R and z, and A^2 + B^2 = W = f1^2 + f2^2 eliminates theta2:
    E(theta3) = sa2^2 (R - F3)^2 + 4 d2^2 (z - F4)^2 - 4 d2^2 sa2^2 W = 0,
a trigonometric polynomial of degree 2, since F3 and F4 are of degree 1: a quartic in tan(theta3 / 2).

The derivatives of F3, F4 and W by theta3 are 2 d4 g3, d4 g4 and 2 d4 gw, with
    g3 = k2 c3 - k1 s3,   g4 = l2 c3,   gw = -(d3 s3 + m c3 + n c3 s3),
    k1 = d3,   k2 = sa3 r2,   l2 = ca2 sa3,   m = ca3 sa3 r3,   n = sa3^2 d4;
everything below is written with them, so that no factor d4 is carried along.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from chainrule.derive.program import Expression, Input, Output, Program, Steps

_0, _1 = sp.Integer(0), sp.Integer(1)

#: Cosine and sine of theta3, and tan(theta3 / 2), in the polynomials below.
C, S, T = sp.symbols("c3 s3 t", real=True)
C2, S2 = sp.symbols("c2 s2", real=True)
ELBOW = Input("elbow", (2,), (C, S))
SHOULDER = Input("shoulder", (2,), (C2, S2))
_PARTS = ("f1", "f2", "g3", "g4", "gw")
TARGET = Input("target", (2,), sp.symbols("rho_squared z", real=True))

NAMES = ("ca2", "sa2", "ca3", "sa3", "d2", "d3", "d4", "r2", "r3")


def reduced(expression: Expression) -> Expression:
    """A polynomial in c3 and s3 modulo c3^2 + s3^2 = 1: of degree 1 in s3, expanded."""
    found = sp.Poly(expression, S)
    total = _0
    for (power,), factor in found.terms():
        total += factor * (1 - C**2) ** (power // 2) * S ** (power % 2)
    return sp.expand(total)


def turned(expression: Expression) -> Expression:
    """The derivative by theta3 of a polynomial in c3 and s3."""
    return sp.diff(expression, S) * C - sp.diff(expression, C) * S


def in_half_tangent(expression: Expression, degree: int) -> tuple[Expression, ...]:
    """The coefficients, lowest power of t = tan(theta3 / 2) first, of (1 + t^2)^degree times a polynomial in c3, s3."""
    total = _0
    for (i, j), factor in sp.Poly(reduced(expression), C, S).terms():
        total += factor * (1 - T**2) ** i * (2 * T) ** j * (1 + T**2) ** (degree - i - j)
    found = sp.Poly(total, T)
    return tuple(sp.expand(found.coeff_monomial(T**k)) for k in range(2 * degree + 1))


def quotient(expression: Expression, divisor: Expression) -> Expression:
    """A polynomial in c3 and s3 divided by one in c3 alone; the division has no remainder."""
    reduced_form = sp.Poly(reduced(expression), S)
    total = _0
    for (power,), factor in reduced_form.terms():
        whole, rest = sp.div(sp.Poly(factor, C), sp.Poly(divisor, C))
        if sp.expand(rest.as_expr()) != 0:
            raise ValueError(f"{divisor} does not divide {expression}")
        total += whole.as_expr() * S**power
    return sp.expand(total)


@dataclass(frozen=True)
class Arm:
    """A 3R arm in normal form: the input its functions take, and cosines, sines and lengths in terms of that input."""

    inputs: Input
    ca2: Expression
    sa2: Expression
    ca3: Expression
    sa3: Expression
    d2: Expression
    d3: Expression
    d4: Expression
    r2: Expression
    r3: Expression

    @cached_property
    def point(self) -> tuple[Expression, Expression, Expression]:
        """f1, f2, f3."""
        return (
            self.d3 + self.d4 * C,
            self.ca3 * self.d4 * S - self.sa3 * self.r3,
            self.sa3 * self.d4 * S + self.ca3 * self.r3,
        )

    @cached_property
    def square(self) -> Expression:
        """F3, with ca3^2 + sa3^2 = 1."""
        constant = self.d2**2 + self.d3**2 + self.d4**2 + self.r2**2 + self.r3**2 + 2 * self.r2 * self.r3 * self.ca3
        return constant + 2 * self.d4 * (self.d3 * C + self.sa3 * self.r2 * S)

    @cached_property
    def height(self) -> Expression:
        """F4."""
        return self.ca2 * (self.point[2] + self.r2)

    @cached_property
    def width(self) -> Expression:
        """W = f1^2 + f2^2."""
        return self.point[0] ** 2 + self.point[1] ** 2

    @cached_property
    def slopes(self) -> tuple[Expression, Expression, Expression]:
        """g3, g4, gw."""
        d3, sa3 = self.d3, self.sa3
        return (
            sa3 * self.r2 * C - d3 * S,
            self.ca2 * sa3 * C,
            -(d3 * S + self.ca3 * sa3 * self.r3 * C + sa3**2 * self.d4 * C * S),
        )

    @cached_property
    def right_angle(self) -> bool:
        """Whether F4 does not depend on theta3 (alpha2 = +-90 deg)."""
        return bool(self.slopes[1] == 0)


def arm() -> Arm:
    """The general arm: every parameter a symbol."""
    symbols = sp.symbols(" ".join(NAMES), real=True)
    return Arm(Input("parameters", (9,), symbols), *symbols)


def named(steps: Steps, name: str, expression: Expression) -> Expression:
    """A polynomial in c3 and s3 with every coefficient of two or more operations a step of its own."""
    total = _0
    for (i, j), factor in sp.Poly(reduced(expression), C, S).terms():
        total += steps.let(f"{name}_{'c' * i}{'s' * j}", sp.factor_terms(factor)) * C**i * S**j
    return total


def mismatch(where: Arm) -> tuple[Expression, Expression]:
    """U = R - F3 and V = z - F4."""
    rho_squared, z = TARGET.symbols
    return rho_squared + z**2 - where.square, z - where.height


def elimination(where: Arm) -> Expression:
    """E, whose zeros are the angles theta3 of the postures that reach the target."""
    u, v = mismatch(where)
    return where.sa2**2 * u**2 + 4 * where.d2**2 * v**2 - 4 * where.d2**2 * where.sa2**2 * where.width


def quartic(where: Arm) -> Program:
    """The quartic in tan(theta3 / 2) of a target (rho^2, z)."""
    steps = Steps()
    u, v = (named(steps, name, part) for name, part in zip("UV", mismatch(where), strict=True))
    width = named(steps, "W", where.width)
    s, d = steps.let("ss", where.sa2**2), steps.let("dd", 4 * where.d2**2)
    pieces = [steps.let(f"E{k}", e) for k, e in enumerate(_square_sum(steps, s, u, d, v, width))]
    return Program(
        "quartic",
        "coefficients, lowest power of tan(theta3/2) first, of the quartic whose roots are the postures at a target",
        (where.inputs, TARGET),
        tuple(steps.steps),
        (Output("quartic", (5,), tuple(pieces)),),
    )


def _square_sum(
    steps: Steps, s: Expression, u: Expression, d: Expression, v: Expression, width: Expression
) -> tuple[Expression, ...]:
    """Coefficients in the half tangent of s u^2 + d v^2 - s d W, from those of u and v at theta3 = 0 and pi."""
    ut, vt, wt = in_half_tangent(u, 1), in_half_tangent(v, 1), in_half_tangent(width, 2)
    ut = tuple(steps.let(f"u{k}", e) for k, e in enumerate(ut))
    vt = tuple(steps.let(f"v{k}", e) for k, e in enumerate(vt))
    wt = tuple(steps.let(f"w{k}", e) for k, e in enumerate(wt))
    sd = steps.let("sd", s * d)

    def squared(p: tuple[Expression, ...]) -> tuple[Expression, ...]:
        return (p[0] ** 2, 2 * p[0] * p[1], p[1] ** 2 + 2 * p[0] * p[2], 2 * p[1] * p[2], p[2] ** 2)

    return tuple(s * a + d * b - sd * w for a, b, w in zip(squared(ut), squared(vt), wt, strict=True))


def triple_conditions(where: Arm) -> tuple[Expression, Expression]:
    """rho1, rho2 of the two linear conditions sa2^2 U g3 + 2 d2^2 V g4 = 2 rho1 and the same with g3', g4', rho2.

    They are E' = 0 and E'' = 0, divided by -4 d4.
    """
    g3, g4, gw = where.slopes
    s, d = where.sa2**2, where.d2**2
    return -d * s * gw, where.d4 * (s * g3**2 + d * g4**2) - d * s * turned(gw)


def cusp_condition(where: Arm) -> Expression:
    """The condition on theta3 for a triple root of the quartic, a cusp of the image of the singular curves.

    E' = E'' = 0 are linear in U and V with the determinant k1 l2, so that
        sa2^2 U k1 l2 = 2 P,   d2^2 V k1 l2 = Q,   P = rho1 g4' - rho2 g4,   Q = g3 rho2 - g3' rho1;
    put into E: d2^2 P^2 + sa2^2 Q^2 - d2^4 sa2^4 (k1 l2)^2 W = 0, of degree 6 in cosines and sines, 12 in the half
    tangent. Where F4 is constant (l2 = 0) the conditions do not hold V: they agree on U only if Q = 0, and Q / sa2^2,
    of degree 3 (6 in the half tangent), takes the place of the condition; V^2 follows from E and must not be
    negative.
    """
    g3, g4, gw = where.slopes
    if where.right_angle:
        return reduced(where.d4 * g3**3 - where.d2**2 * (g3 * turned(gw) - turned(g3) * gw))
    rho1, rho2 = (reduced(e) for e in triple_conditions(where))
    p = reduced(rho1 * turned(g4) - rho2 * g4)
    q = reduced(rho2 * g3 - rho1 * turned(g3))
    d2, s2 = where.d2, where.sa2
    return reduced(d2**2 * p**2 + s2**2 * q**2 - d2**4 * s2**4 * (where.d3 * where.ca2 * where.sa3) ** 2 * where.width)


def right_angled(where: Arm) -> Arm:
    """The same arm with alpha2 = +-90 deg: ca2 = 0."""
    values = {name: getattr(where, name) for name in NAMES}
    return Arm(where.inputs, **{**values, "ca2": _0})


def cusp_polynomial(where: Arm) -> Program:
    """The cusp condition as a polynomial in tan(theta3 / 2): degree 12, or 6 where alpha2 = +-90 deg."""
    steps = Steps()
    g3, g4, gw = (named(steps, name, g) for name, g in zip(("g3", "g4", "gw"), where.slopes, strict=True))
    d, s, d4 = (steps.let(name, e) for name, e in (("dd", where.d2**2), ("ss", where.sa2**2), ("d4", where.d4)))
    if where.right_angle:
        condition, degree = d4 * g3**3 - d * (g3 * turned(gw) - turned(g3) * gw), 3
    else:
        rho1 = named(steps, "rho1", -d * s * gw)
        rho2 = named(steps, "rho2", d4 * (s * g3**2 + d * g4**2) - d * s * turned(gw))
        p = named(steps, "P", rho1 * turned(g4) - rho2 * g4)
        q = named(steps, "Q", rho2 * g3 - rho1 * turned(g3))
        last = steps.let("last", (d * s * where.d3 * where.ca2 * where.sa3) ** 2)
        condition, degree = d * p**2 + s * q**2 - last * named(steps, "W", where.width), 6
    condition = named(steps, "cusp", condition)
    return Program(
        "cusp_polynomial_right_angle" if where.right_angle and where.inputs.shape == (9,) else "cusp_polynomial",
        "coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps"
        + (", for alpha2 = +-90 deg: those with z^2 >= 0" if where.right_angle else ""),
        (where.inputs,),
        tuple(steps.steps),
        (Output("polynomial", (2 * degree + 1,), in_half_tangent(condition, degree)),),
    )


def aspect_condition(where: Arm) -> Expression:
    """(a^2 + b^2 - c^2) / d4^2, where det J = a c2 + b s2 + c: no sign of theta2 is left where it is negative.

    It is W (sa2^2 g3^2 + d2^2 g4^2) - d2^2 sa2^2 gw^2. For an orthogonal arm W = f1^2 and gw = -s3 f1: f1^2 is divided
    out.
    """
    g3, g4, gw = where.slopes
    whole = where.width * (where.sa2**2 * g3**2 + where.d2**2 * g4**2) - (where.d2 * where.sa2 * gw) ** 2
    return quotient(whole, where.point[0] ** 2) if where.point[1] == 0 else reduced(whole)


def aspect_polynomial(where: Arm) -> Program:
    """The aspect condition as a polynomial in tan(theta3 / 2): degree 8, or 4 for an orthogonal arm."""
    steps = Steps()
    if where.point[1] == 0:
        condition, degree = named(steps, "bound", aspect_condition(where)), 2
    else:
        g3, g4, gw = (named(steps, name, g) for name, g in zip(("g3", "g4", "gw"), where.slopes, strict=True))
        d, s = steps.let("dd", where.d2**2), steps.let("ss", where.sa2**2)
        size = named(steps, "size", s * g3**2 + d * g4**2)
        width = named(steps, "W", where.width)
        condition, degree = named(steps, "bound", width * size - d * s * gw**2), 4
    return Program(
        "aspect_polynomial",
        "coefficients, lowest power first, of the polynomial in tan(theta3/2) that is (a^2 + b^2 - c^2)/d4^2"
        + (", divided by (d3 + d4 c3)^2" if where.point[1] == 0 else ""),
        (where.inputs,),
        tuple(steps.steps),
        (Output("polynomial", (2 * degree + 1,), in_half_tangent(condition, degree)),),
    )


def determinant_parts(where: Arm, steps: Steps | None = None) -> tuple[Expression, Expression, Expression]:
    """a, b, c of det J = a c2 + b s2 + c, the determinant of the position Jacobian; with ``steps`` in named steps."""
    f1, f2, g3, g4, gw = (*where.point[:2], *where.slopes)
    if steps is not None:
        f1, f2, g3, g4, gw = (steps.let(n, e) for n, e in zip(_PARTS, (f1, f2, g3, g4, gw), strict=True))
    d2, d4, sa2 = where.d2, where.d4, where.sa2
    return d4 * (d2 * g4 * f2 + sa2 * g3 * f1), d4 * (d2 * g4 * f1 - sa2 * g3 * f2), d4 * d2 * sa2 * gw


def determinant_terms(where: Arm) -> Program:
    """a, b, c of det J at given c3, s3."""
    steps = Steps()
    terms = determinant_parts(where, steps)
    return Program(
        "determinant_terms",
        "a, b, c of det J = a cos(theta2) + b sin(theta2) + c, from cos(theta3) and sin(theta3)",
        (where.inputs, ELBOW),
        tuple(steps.steps),
        (Output("terms", (3,), terms),),
    )


def determinant(where: Arm) -> Program:
    """det J at given c2, s2, c3, s3."""
    steps = Steps()
    a, b, c = determinant_parts(where, steps)
    return Program(
        "determinant",
        "det J, the determinant of the position Jacobian",
        (where.inputs, SHOULDER, ELBOW),
        tuple(steps.steps),
        (Output("determinant", (), (a * C2 + b * S2 + c,)),),
    )


def second_axis(where: Arm) -> Program:
    """f1 as a polynomial in t^2, t = tan(theta3 / 2): where it vanishes and f2 does too, the point is on axis 2."""
    steps = Steps()
    constant, linear, square = in_half_tangent(where.point[0], 1)
    if linear != 0:
        raise ValueError("f1 has a term in sin(theta3)")
    return Program(
        "second_axis",
        "coefficients of 1 and t^2 in (1 + t^2) f1, t = tan(theta3/2), which is 0 where the point is on axis 2",
        (where.inputs,),
        tuple(steps.steps),
        (Output("polynomial", (2,), (constant, square)),),
    )


def triple_point(where: Arm) -> Program:
    """The target of a triple root at given c3, s3 on the cusp polynomial, as numerators and one denominator.

    The first two entries over the third are (rho^2, z), or (rho^2, z^2) where alpha2 = +-90 deg; nothing is divided
    here, so that the entries are polynomials. In the first case U = 2 P / (sa2^2 k1 l2) and V = Q / (d2^2 k1 l2), as
    in :func:`cusp_condition`. In the second the two conditions are combined, since g3^2 + g3'^2 = k1^2 + k2^2: U = 2
    (rho1 g3 + rho2 g3') / (sa2^2 (k1^2 + k2^2)), and z^2 = V^2 = sa2^2 (W - U^2 / (4 d2^2)); a negative one is no
    cusp.
    """
    steps = Steps()
    g3, g4 = (steps.let(name, g) for name, g in zip(("g3", "g4"), where.slopes[:2], strict=True))
    dg3, dg4 = (steps.let(f"d{name}", turned(g)) for name, g in zip(("g3", "g4"), where.slopes[:2], strict=True))
    rho1, rho2 = (steps.let(f"rho{k}", e) for k, e in zip((1, 2), triple_conditions(where), strict=True))
    square, height, width = (
        steps.let(n, e) for n, e in (("F3", where.square), ("F4", where.height), ("W", where.width))
    )
    s, d = steps.let("ss", where.sa2**2), steps.let("dd", where.d2**2)
    if where.right_angle:
        k = steps.let("k", s * (where.d3**2 + (where.sa3 * where.r2) ** 2))
        half = steps.let("half_U_k", rho1 * g3 + rho2 * dg3)
        below = steps.let("below", d * k**2)
        last = steps.let("z_squared", s * (width * below - half**2))
        first = square * below + 2 * half * k * d - last
    else:
        k = steps.let("k", where.d3 * where.ca2 * where.sa3)
        half = steps.let("half_U_sk", rho1 * dg4 - rho2 * g4)
        z = steps.let("z_dk", height * d * k + g3 * rho2 - dg3 * rho1)
        below = steps.let("below", s * (d * k) ** 2)
        last = steps.let("z", z * s * d * k)
        first = square * below + 2 * half * k * d**2 - s * z**2
    what = "rho^2 and of z^2" if where.right_angle else "rho^2 and of z"
    return Program(
        "triple_point_right_angle" if where.right_angle and where.inputs.shape == (9,) else "triple_point",
        f"numerators of {what} of the cusp at a root of the cusp polynomial, and their denominator",
        (where.inputs, ELBOW),
        tuple(steps.steps),
        (Output("cusp", (3,), (first, last, below)),),
    )


def shoulder(where: Arm) -> Program:
    """theta2 of a posture: numbers in the ratio of its cosine and sine, and W (theta2 is free where W = 0).

    2 d2 A = R - F3 and sa2 B = z - F4 give W (cos theta2, sin theta2) = (A f1 + B f2, B f1 - A f2); multiplied by
    2 (d2 sa2)^2 nothing is divided.
    """
    steps = Steps()
    u, v = (steps.let(name, e) for name, e in zip("UV", mismatch(where), strict=True))
    f1, f2 = (steps.let(f"f{k}", f) for k, f in zip((1, 2), where.point[:2], strict=True))
    along, across = steps.let("A", where.d2 * where.sa2**2 * u), steps.let("B", 2 * where.d2**2 * where.sa2 * v)
    return Program(
        "shoulder",
        "numbers in the ratio of cos(theta2) and sin(theta2) of a posture at a target, and W",
        (where.inputs, TARGET, ELBOW),
        tuple(steps.steps),
        (Output("ratio", (3,), (along * f1 + across * f2, across * f1 - along * f2, f1**2 + f2**2)),),
    )


def placed(steps: Steps, where: Arm) -> tuple[Expression, Expression, Expression]:
    """The point at theta1 = 0, from the cosines and sines of theta2 and theta3."""
    f1, f2, f3 = (steps.let(f"f{k}", f) for k, f in enumerate(where.point, 1))
    along = steps.let("A", C2 * f1 - S2 * f2)
    across = steps.let("B", S2 * f1 + C2 * f2)
    return (
        steps.let("px", where.d2 + along),
        steps.let("py", where.ca2 * across - where.sa2 * (f3 + where.r2)),
        steps.let("pz", where.sa2 * across + where.ca2 * (f3 + where.r2)),
    )


def unturned(where: Arm) -> Program:
    """The point at theta1 = 0."""
    steps = Steps()
    point = placed(steps, where)
    return Program(
        "unturned",
        "the point at theta1 = 0, from the cosines and sines of theta2 and theta3",
        (where.inputs, SHOULDER, ELBOW),
        tuple(steps.steps),
        (Output("point", (3,), point),),
    )


def image(where: Arm) -> Program:
    """(rho^2, z) of the point at given c2, s2, c3, s3."""
    steps = Steps()
    x, y, z = placed(steps, where)
    return Program(
        "image",
        "rho^2 and z of the point, from the cosines and sines of theta2 and theta3",
        (where.inputs, SHOULDER, ELBOW),
        tuple(steps.steps),
        (Output("target", (2,), (x**2 + y**2, z)),),
    )
