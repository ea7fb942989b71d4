"""How many postures of a 3R arm reach a point, and which: straight-line, for every target.

E of :mod:`chainrule.derive.regional_3r` as a trigonometric polynomial,
    E = alpha + 2 b c3 + 2 g s3 + delta cos(2 theta3) + eps sin(2 theta3),
is a conic x^T N x, x = (c3, s3, 1), on the unit circle. The pencil N + lambda diag(-1, -1, 1) takes the same values
there; its degenerate members are pairs of lines, at the roots of
    det = lambda^3 + alpha lambda^2 + (k - m) lambda + n - alpha m,
    k = b^2 + g^2,   m = delta^2 + eps^2,   n = delta (b^2 - g^2) + 2 eps b g.
Nothing here depends on where the angle is counted from, so that no angle is special (tan(theta3 / 2) is infinite at
one). With lambda = x - alpha / 3 the cubic's discriminant, the quartic's up to a positive factor, is (4 I^3 - J^2) /
27,
    I = alpha^2 + 3 m - 3 k,   J = 2 alpha^3 - 9 alpha k - 18 alpha m + 27 n.
It is negative for two real postures, positive for four or none. Four if and only if the pair of lines is real at all
three roots (for none it is at one of them), that is, if u = lambda^2 + 2 alpha lambda + m + k, minus the sum of the
principal minors of second order, is positive at all three: the first two symmetric functions of the three u are
positive (the third always is).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from chainrule.derive.program import (
    CopySign,
    Expression,
    GuardedInverse,
    Input,
    Output,
    Program,
    Steps,
    Where,
    exact,
)
from chainrule.derive.regional_3r import TARGET, Arm, C, S, mismatch, named, reduced

_0, _1 = sp.Integer(0), sp.Integer(1)

POINT = Input("point", (3,), sp.symbols("x y z", real=True))

#: What rounding may make of the coefficients, in units of their largest possible value: 32 units in the last place.
ROUNDING = sp.Rational(1, 2**48)
#: Steps towards the line pair, and towards each root.
LINE_STEPS, POLISHING_STEPS = 12, 2


@dataclass(frozen=True)
class Trigonometric:
    """E divided by the size of its coefficients; ``doubt`` bounds the error that rounding may have made in each."""

    alpha: Expression
    b: Expression
    g: Expression
    delta: Expression
    eps: Expression
    doubt: Expression

    def value(self, c: Expression, s: Expression) -> Expression:
        """E at an angle."""
        return self.alpha + 2 * (self.b * c + self.g * s) + self.delta * (c - s) * (c + s) + 2 * self.eps * c * s

    def slope(self, c: Expression, s: Expression) -> Expression:
        """Half the derivative of E."""
        return self.g * c - self.b * s - 2 * self.delta * c * s + self.eps * (c - s) * (c + s)


def harmonics(expression: Expression) -> tuple[Expression, Expression, Expression, Expression, Expression]:
    """alpha, b, g, delta, eps of a polynomial of degree 2 in c3 and s3."""
    terms = dict(sp.Poly(reduced(expression), C, S).terms())
    one, c, s, cc, cs = (terms.get(key, _0) for key in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1)))
    return one + cc / 2, c / 2, s / 2, cc / 2, cs / 2


def absolute(expression: Expression) -> Expression:
    """An upper bound of |expression|: every term by its absolute value."""
    total = _0
    for term in sp.Add.make_args(sp.expand(expression)):
        factor, rest = term.as_coeff_Mul()
        total += abs(factor) * sp.Mul(*(_magnitude(power) for power in sp.Mul.make_args(rest)))
    return total


def _magnitude(power: Expression) -> Expression:
    base, exponent = power.as_base_exp()
    return power if exponent % 2 == 0 else sp.Max(base, -base) * base ** (exponent - 1)


def trigonometric(steps: Steps, arm: Arm, rho_squared: Expression, z: Expression) -> Trigonometric:
    """E at a target, as named steps."""
    values = dict(zip(TARGET.symbols, (rho_squared, z), strict=True))
    u, v = mismatch(arm)
    u, v = arm.sa2 * u, 2 * arm.d2 * v
    bound = sum((absolute(part).subs({C: 1, S: 1}) ** 2 for part in (u, v)), _0)
    far = absolute(arm.point[0]) ** 2 + absolute(arm.point[1]) ** 2
    turn = steps.let("dd", (2 * arm.d2 * arm.sa2) ** 2)
    largest = steps.let("largest", (bound + turn * far.subs({C: 1, S: 1})).subs(values))
    u, v = (named(steps, name, part.subs(values)) for name, part in (("U", u), ("V", v)))
    width = named(steps, "W", arm.width)
    whole = [steps.let(name, e) for name, e in zip("abgde", harmonics(u**2 + v**2 - turn * width), strict=True)]
    size = steps.let("size", sum((sp.Max(e, -e) for e in whole), _0))
    inverse = steps.let("inverse", GuardedInverse(size))
    alpha, b, g, delta, eps = (steps.let(f"{name}_", e * inverse) for name, e in zip("abgde", whole, strict=True))
    return Trigonometric(alpha, b, g, delta, eps, steps.let("doubt", ROUNDING * largest * inverse))


def counted(steps: Steps, e: Trigonometric) -> tuple[Expression, Expression]:
    """The number of real roots, and a margin: above 1 rounding cannot have changed it.

    The coefficients are at most 1 in sum, and known to ``doubt`` each: I to 6 times that, J to 60 times, the two
    symmetric functions to 20 and 60 times, with room for the rounding of their own terms.
    """
    a, b, g, delta, eps = e.alpha, e.b, e.g, e.delta, e.eps
    bb, gg = steps.let("bb", b**2), steps.let("gg", g**2)
    k, m = steps.let("k", bb + gg), steps.let("m", delta**2 + eps**2)
    n = steps.let("n", delta * (bb - gg) + 2 * eps * b * g)
    aa = steps.let("aa", a**2)
    i = steps.let("I", aa + 3 * (m - k))
    j = steps.let("J", a * (2 * aa - 9 * k - 18 * m) + 27 * n)
    ii = steps.let("II", i**2)
    discriminant = steps.let("discriminant", 4 * ii * i - j**2)
    error = steps.let("error", e.doubt * (72 * ii + 120 * sp.Max(j, -j) + 5000 * e.doubt))
    p, t = steps.let("P", -i / 3), steps.let("T", j / 27)
    u0, u1 = steps.let("u0", m + k - 5 * aa / 9), steps.let("u1", 4 * a / 3)
    first = steps.let("first", 3 * u0 - 2 * p)
    second = steps.let("second", p**2 + 3 * u1 * t - 4 * p * u0 + u1**2 * p + 3 * u0**2)
    four = steps.let("four", sp.Min(3 * first, second) / (60 * e.doubt))
    clear = steps.let("clear", sp.Max(discriminant, -discriminant) / error)
    even = steps.let("even", (1 + CopySign(_1, discriminant)) / 2)
    number = steps.let("number", 2 + even * CopySign(sp.Integer(2), four))
    beyond = steps.let("beyond", sp.Max(four, -four) + (1 - even) * clear)
    return number, steps.let("margin", sp.Min(clear, beyond))


def number_of_postures(arm: Arm) -> Program:
    """The number of postures at a target (rho^2, z), and the margin of that answer."""
    steps = Steps()
    rho_squared, z = TARGET.symbols
    number, margin = counted(steps, trigonometric(steps, arm, rho_squared, z))
    return Program(
        "number_of_postures",
        "how many postures reach a target; in double precision certainly so where the margin exceeds 1",
        (arm.inputs, TARGET),
        tuple(steps.steps),
        (Output("number", (), (number,)), Output("margin", (), (margin,))),
    )


def choose(mask: Expression, yes: Expression, no: Expression) -> Expression:
    """``yes`` where the mask is 1, ``no`` where it is 0; both are finite. Products vectorise, branches may not."""
    return mask * yes + (1 - mask) * no


def positive(expression: Expression) -> Expression:
    """1 where an expression is positive or +0, else 0."""
    return (1 + CopySign(_1, expression)) / 2


def roots(steps: Steps, e: Trigonometric) -> tuple[list[Sequence[Expression]], list[Expression]]:
    """Cosine and sine of four angles, in two pairs, and for each pair a number that is negative if it is not real.

    Turned by half the phase of (delta, eps), E = alpha + 2 b c + 2 g s + mu cos(2 psi). The cubic has a root lambda in
    [-mu, mu], where its sign changes, and there the pair of lines is real: with x = mu - lambda, y = mu + lambda,
        E = (sqrt(x) c + b / sqrt(x))^2 - (sqrt(y) s - g / sqrt(y))^2.
    Exchanging c and s makes y the smaller one, which is found with bracketed Newton steps.
    """
    tiny = sp.Rational(1, 10**17)
    delta = steps.let("delta", e.delta + CopySign(tiny, e.delta))
    mu = steps.let("mu", sp.sqrt(delta**2 + e.eps**2))
    major = steps.let("major", sp.sqrt((mu + sp.Max(delta, -delta)) / (2 * mu)))
    minor = steps.let("minor", e.eps / (2 * mu * major))
    east = steps.let("east", positive(delta))
    cos, sin = steps.let("cos", choose(east, major, minor)), steps.let("sin", choose(east, minor, major))
    b, g = steps.let("b_turned", e.b * cos + e.g * sin), steps.let("g_turned", e.g * cos - e.b * sin)
    keep = steps.let("keep", positive(b**2 - g**2 - mu * e.alpha))
    a = steps.let("a_kept", e.alpha * (2 * keep - 1))
    b, g = steps.let("b_kept", choose(keep, b, -g)), steps.let("g_kept", choose(keep, g, -b))
    gg = steps.let("gg_kept", g**2)
    third, second, first = _1, steps.let("second", a - 3 * mu), steps.let("first", b**2 + gg - 2 * mu * (a - mu))
    zeroth = steps.let("zeroth", 2 * mu * gg)
    low, high = _0, mu
    top = steps.let("top", ((third * mu + second) * mu + first) * mu)
    y = steps.let("y_line", sp.Min(mu, mu * zeroth * GuardedInverse(top)))
    for _ in range(LINE_STEPS):
        value = steps.let("value", ((y + second) * y + first) * y - zeroth)
        rate = steps.let("rate", (3 * y + 2 * second) * y + first)
        above = steps.let("above", positive(value))
        low, high = steps.let("low", choose(above, low, y)), steps.let("high", choose(above, y, high))
        newton = steps.let("newton", y - value * GuardedInverse(rate))
        outside = steps.let("outside", Where(newton - sp.Min(sp.Max(newton, low), high), _1))
        y = steps.let("y_line", choose(outside, (low + high) / 2, newton))
    x = steps.let("x_line", 2 * mu - y)
    p, q = steps.let("p", sp.sqrt(x)), steps.let("q", sp.sqrt(y))
    large = steps.let("large", positive(y - sp.Rational(1, 10**25)))
    small_g = steps.let("small_g", sp.sqrt(sp.Max(b**2 / x + mu - a - y, _0)))
    offset = steps.let("offset", choose(large, g * GuardedInverse(q), CopySign(small_g, g)))
    middle = steps.let("middle", b / p)
    lines = []
    for sign in (-1, 1):
        distance = steps.let("distance", middle - sign * offset)
        room = steps.let("room", 2 * mu - distance**2)
        half = steps.let("half", sp.sqrt(sp.Max(room, _0)))
        ends = []
        for end in (1, -1):
            cp = steps.let("cp", (-distance * p - sign * end * half * q) / (2 * mu))
            sp_ = steps.let("sp", (-distance * sign * q + end * half * p) / (2 * mu))
            ck, sk = steps.let("ck", choose(keep, cp, sp_)), steps.let("sk", choose(keep, sp_, cp))
            ends.append((steps.let("c", cos * ck - sin * sk), steps.let("s", sin * ck + cos * sk)))
        lines.append((room, ends))
    return [polished(steps, e, c, s) for _, ends in lines for c, s in ends], [room for room, _ in lines]


def polished(steps: Steps, e: Trigonometric, c: Expression, s: Expression) -> Sequence[Expression]:
    """Newton steps on E from an angle near a root, none longer than 0.001 rad and none where the slope is rounding."""
    limit, noise = sp.Rational(1, 1000), sp.Rational(1, 10**18)
    for _ in range(POLISHING_STEPS):
        slope = steps.let("half_slope", e.slope(c, s))
        step = steps.let("newton_step", -e.value(c, s) * slope / (2 * (slope**2 + noise)))
        step = steps.let("step", sp.Max(sp.Min(step, limit), -limit))
        c, s = steps.let("c", c - s * step), steps.let("s", s + c * step)
        length = steps.let("length", GuardedInverse(sp.sqrt(c**2 + s**2)))
        c, s = steps.let("c", c * length), steps.let("s", s * length)
    return c, s


def postures(arm: Arm) -> Program:
    """All postures that reach a point (x, y, z), d2 and sa2 not zero.

    With theta3 known, A = (R - F3) / (2 d2) and B = (z - F4) / sa2 give theta2 = atan2(B f1 - A f2, A f1 + B f2), and
    theta1 turns the arm's (d2 + A, ca2 B - sa2 (f3 + r2)) to (x, y). A and B are taken again from theta2, so that the
    arm's own equations are what ``closure`` measures: how far from the point the posture is.
    """
    steps = Steps()
    x, y, z = POINT.symbols
    rho_squared = steps.let("rho_squared", x**2 + y**2)
    e = trigonometric(steps, arm, rho_squared, z)
    number, margin = counted(steps, e)
    found, rooms = roots(steps, e)
    u, v = _at_target(steps, arm, rho_squared, z)
    half = steps.let("half_inverse", GuardedInverse(2 * arm.d2))
    across = _1 / arm.sa2 if arm.sa2.is_number else steps.let("sine_inverse", GuardedInverse(arm.sa2))
    rho = steps.let("rho", sp.sqrt(rho_squared))
    angles: list[Expression] = []
    closures = []
    for c, s in found:
        here = {C: c, S: s}
        a, b = steps.let("A", u.xreplace(here) * half), steps.let("B", v.xreplace(here) * across)
        posture, closure = _posture(steps, arm, rho, here, (a, b))
        angles += posture
        closures.append(closure)
    return Program(
        "postures",
        "two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E",
        (arm.inputs, POINT),
        tuple(steps.steps),
        (
            Output("angles", (4, 3), tuple(angles)),
            Output("room", (2,), tuple(rooms)),
            Output("closure", (4,), tuple(closures)),
            Output("slope", (4,), tuple(e.slope(c, s) for c, s in found)),
            Output("number", (), (number,)),
            Output("margin", (), (margin,)),
        ),
    )


def _at_target(steps: Steps, arm: Arm, rho_squared: Expression, z: Expression) -> tuple[Expression, Expression]:
    """U and V of the target as polynomials in c3 and s3 with named coefficients."""
    values = dict(zip(TARGET.symbols, (rho_squared, z), strict=True))
    u, v = (named(steps, name, part.subs(values)) for name, part in zip("UV", mismatch(arm), strict=True))
    return u, v


def _posture(
    steps: Steps,
    arm: Arm,
    rho: Expression,
    here: Mapping[Expression, Expression],
    parts: tuple[Expression, Expression],
) -> tuple[list[Expression], Expression]:
    """theta1, theta2, theta3, and how far from the point that posture is, from theta3 and (A, B)."""
    x, y, z = POINT.symbols
    f1, f2, f3 = (steps.let(f"f{k}", f.xreplace(here)) for k, f in enumerate(arm.point, 1))
    a, b = parts
    c2, s2 = steps.let("c2", a * f1 + b * f2), steps.let("s2", b * f1 - a * f2)
    length = steps.let("length", GuardedInverse(sp.sqrt(c2**2 + s2**2)))
    c2, s2 = steps.let("c2", c2 * length), steps.let("s2", s2 * length)
    a, b = steps.let("A", c2 * f1 - s2 * f2), steps.let("B", s2 * f1 + c2 * f2)
    px = steps.let("px", arm.d2 + a)
    py = steps.let("py", arm.ca2 * b - arm.sa2 * (f3 + arm.r2))
    pz = steps.let("pz", arm.sa2 * b + arm.ca2 * (f3 + arm.r2))
    miss = steps.let("miss", sp.sqrt(px**2 + py**2) - rho)
    closure = steps.let("closure", sp.sqrt(miss**2 + (pz - z) ** 2))
    cosine, sine = steps.let("cos1", x * px + y * py), steps.let("sin1", y * px - x * py)
    first = angle(steps, cosine, sine, steps.let("size1", sp.sqrt(cosine**2 + sine**2)))
    return [first, angle(steps, c2, s2, _1), angle(steps, here[C], here[S], _1)], closure


def angle(steps: Steps, c: Expression, s: Expression, length: Expression) -> Expression:
    """atan2(s, c), given (c^2 + s^2)^(1/2), in operations that a compiler vectorises: a library's atan2 is none.

    The angle from the nearest axis is at most pi / 4; tan(phi / 2) = sin(phi) / (1 + cos(phi)) halves it, and
    tan(phi / 4) = tan(phi / 2) / (1 + (1 + tan(phi / 2)^2)^(1/2)) once more. Of what is left, at most pi / 16, the arc
    tangent's series is exact to 1e-18 after eleven terms.
    """
    a, b = steps.let("across", sp.Max(c, -c)), steps.let("up", sp.Max(s, -s))
    half = steps.let("half", sp.Min(a, b) * GuardedInverse(sp.Max(a, b) + length))
    quarter = steps.let("quarter", half / (1 + sp.sqrt(1 + half**2)))
    square = steps.let("square", quarter**2)
    series: Expression = _0
    for k in range(10, -1, -1):
        series = steps.let("series", sp.Rational((-1) ** k, 2 * k + 1) + square * series)
    turned = steps.let("turned", 4 * quarter * series)
    turn = exact(math.pi)
    turned = steps.let("turned", choose(positive(b - a), turn / 2 - turned, turned))
    return CopySign(choose(positive(-c), turn - turned, turned), s)


def postures_in_pairs(arm: Arm, parallel: bool) -> Program:
    """The postures of an arm whose axes 1 and 2 intersect (d2 = 0) or are parallel (sa2 = 0).

    E is a square there: U = 0 alone fixes theta3 where d2 = 0, and V = 0 where sa2 = 0, each of degree 1 in its cosine
    and sine: two solutions. The other equation gives B = V / sa2 or A = U / (2 d2), and A^2 + B^2 = W the missing one,
    with either sign. Square roots of negative numbers are taken as 0: such a posture is one only if it closes.
    """
    steps = Steps()
    x, y, z = POINT.symbols
    rho_squared = steps.let("rho_squared", x**2 + y**2)
    rho = steps.let("rho", sp.sqrt(rho_squared))
    u, v = _at_target(steps, arm, rho_squared, z)
    first, other = (v, u) if parallel else (u, v)
    scale = steps.let("scale", GuardedInverse(2 * arm.d2 if parallel else arm.sa2))
    known = dict(sp.Poly(first, C, S).terms())
    e0, ec, es = (known.get(key, _0) for key in ((0, 0), (1, 0), (0, 1)))
    square = steps.let("square", ec**2 + es**2)
    inverse = steps.let("inverse", GuardedInverse(square))
    still = steps.let("still", 1 - Where(square, _1))  # theta3 moves nothing: 0 is as good as any
    room = steps.let("room", sp.sqrt(sp.Max(square - e0**2, _0)))
    angles: list[Expression] = []
    closures, widths = [], []
    for elbow in (1, -1):
        c = steps.let("c", still - (e0 * ec + elbow * es * room) * inverse)
        s = steps.let("s", (elbow * ec * room - e0 * es) * inverse)
        size = steps.let("size", GuardedInverse(sp.sqrt(c**2 + s**2)))
        here = {C: steps.let("c", c * size), S: steps.let("s", s * size)}
        width = steps.let("W", arm.width.xreplace(here))
        one = steps.let("one", other.xreplace(here) * scale)
        two = steps.let("two", sp.sqrt(sp.Max(width - one**2, _0)))
        for sign in (1, -1):
            posture, closure = _posture(steps, arm, rho, here, (one, sign * two) if parallel else (sign * two, one))
            angles += posture
            closures.append(closure)
            widths.append(width)
    name = "postures_parallel" if parallel else "postures_intersecting"
    return Program(
        name,
        f"the postures of an arm with axes 1 and 2 {name.split('_')[1]}, the distance each leaves, and W",
        (arm.inputs, POINT),
        tuple(steps.steps),
        (
            Output("angles", (4, 3), tuple(angles)),
            Output("closure", (4,), tuple(closures)),
            Output("width", (4,), tuple(widths)),
        ),
    )
