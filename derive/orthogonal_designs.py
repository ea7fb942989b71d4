r"""The design space of orthogonal 3R arms: surfaces C1 to C4 and E1 to E3, from the events that define them.

With X = d2^2 + d3^2 + r2^2, A^2 = (d3 + d2)^2 + r2^2, B^2 = (d3 - d2)^2 + r2^2, the product M = A B satisfies
M^2 = X^2 - 4 d2^2 d3^2, and the second harmonic of E has the amplitude 2 d4^2 M.

Two double roots (nodes), and four equal ones. E = kappa (cos(theta3 - phi) - h)^2 needs kappa = +-4 d4^2 M; comparing
the other harmonics, U at mean theta3 is u0 = -X +- M and kappa h^2 = u0 (u0 + 2 d2^2), and z^2 follows
(:func:`double_contact`, r2 and d3 not zero). The two double roots coincide where h^2 = 1: four equal roots, the
surface C1. The two nodes +-z meet and vanish where z = 0: the surfaces E1 and E3. The nodes of the other kind lie on
the singular lines f1 = d3 + d4 c3 = 0, which exist for d4 > d3: the surface E2.

Tangency. The singular curve has ends of its interval of theta3 where the aspect polynomial vanishes,
((d3 + d2) s3 - r2 c3) ((d3 - d2) s3 - r2 c3) = 0: the line f1 = 0 is tangent to it where both vanish: C2, and C3 and
C4.

No other surface. Cusps are the real roots of the cusp polynomial with z^2 > 0: their number changes only where two real
roots meet (a factor of its discriminant) or where z^2 = 0 at a root (a factor of the resultant with z^2). The factors
are d2, d3, d4, r2, A^2, B^2, d3^2 + r2^2, which do not vanish for r2 > 0; those of C2, C3 and C4; that of C1, d4^2 =
(P - N / M) / 2, and its conjugate d4^2 = (P + N / M) / 2; and d4^2 = P, P = d3^2 + r2^2. On the last two the double
root has z^2 < 0: no cusp is there (:func:`double_contact`, :func:`false_double_root`).
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.orthogonal_3r import normal_form, orthogonal_chain
from chainrule.derive.program import CopySign, Expression, Output, Program, Steps, Where
from chainrule.derive.regional_3r import TARGET, C, S, cusp_condition, elimination, triple_conditions, turned
from chainrule.derive.regional_postures import harmonics

D2, D3, D4, R2 = orthogonal_chain().inputs[1].symbols
#: The product A B.
M = sp.Symbol("M", positive=True)
X, P = D2**2 + D3**2 + R2**2, D3**2 + R2**2
N = P**2 - (D3**2 - R2**2) * D2**2

_1 = sp.Integer(1)

#: A side nearer to 0 than this is left undecided: 64 units in the last place, more than rounding makes of it.
ROUNDING = sp.Rational(1, 2**47)


def squares() -> tuple[Expression, Expression]:
    """A^2 and B^2."""
    return (D3 + D2) ** 2 + R2**2, (D3 - D2) ** 2 + R2**2


def modulo(expression: Expression) -> Expression:
    """A polynomial in M by M^2 = A^2 B^2: of degree 1 in M, expanded."""
    relation = sp.Poly(M**2 - sp.expand(squares()[0] * squares()[1]), M)
    return sp.expand(sp.rem(sp.Poly(sp.expand(expression), M), relation).as_expr())


def double_contact(mean: int, sense: int) -> dict[str, Expression]:
    """The targets whose quartic has two double roots: u0 = -X + mean M and kappa = 4 sense d4^2 M, signs 1 or -1.

    Returns:
        ``u0``, ``kappa``, ``h_kappa`` = kappa h^2 and ``z_squared``.
    """
    u0, kappa = -X + mean * M, 4 * sense * D4**2 * M
    h_kappa = u0 * (u0 + 2 * D2**2)
    z_squared = (kappa / 2 + h_kappa - u0**2 - 2 * D4**2 * P + 4 * D2**2 * D3**2 + 2 * D2**2 * D4**2) / (4 * D2**2)
    return {"u0": u0, "kappa": kappa, "h_kappa": h_kappa, "z_squared": z_squared}


def contact_residuals(mean: int, sense: int) -> tuple[Expression, ...]:
    """What must vanish modulo M^2 = A^2 B^2 for :func:`double_contact` to be one.

    With delta + i eps = kappa e^(2 i phi) / 2, b + i g = -kappa h e^(i phi), alpha = kappa (1/2 + h^2):
    (b + i g)^2 = 2 kappa h^2 (delta + i eps), real and imaginary part, the amplitude of the second harmonic, and alpha.
    """
    found = double_contact(mean, sense)
    rho_squared, z = TARGET.symbols
    square = sp.Symbol("R", real=True)
    energy = sp.expand(elimination(normal_form())).subs(rho_squared, square - z**2)
    alpha, b, g, delta, eps = (
        sp.expand(part).subs(z**2, found["z_squared"]).subs(square, found["u0"] + X + D4**2)
        for part in harmonics(energy)
    )
    residuals = (
        b**2 - g**2 - 2 * found["h_kappa"] * delta,
        2 * b * g - 2 * found["h_kappa"] * eps,
        4 * (delta**2 + eps**2) - found["kappa"] ** 2,
        alpha - found["kappa"] / 2 - found["h_kappa"],
    )
    return tuple(modulo(residual) for residual in residuals)


def tangency() -> tuple[Expression, Expression]:
    """Where a singular line f1 = 0 meets an end of the singular curve: two polynomials, of C2 and of C3 and C4.

    With c3 = -d3 / d4 put into r2^2 c3^2 = (d3 +- d2)^2 s3^2.
    """
    found = []
    for distance in (D3 + D2, D3 - D2):
        condition = R2**2 * C**2 - distance**2 * (1 - C**2)
        found.append(sp.expand(sp.expand(condition.subs(C, -D3 / D4)) * D4**2))
    return found[0], found[1]


def cusp_height() -> Expression:
    """z^2 d2^2 (d3^2 + r2^2)^2 of a root of the cusp polynomial, as a polynomial in c3 and s3."""
    arm = normal_form()
    g3 = arm.slopes[0]
    rho1, rho2 = triple_conditions(arm)
    return sp.expand(arm.width * D2**2 * P**2 - sp.expand(rho1 * g3 + rho2 * turned(g3)) ** 2)


def false_double_root() -> dict[str, Expression]:
    """The double root of the cusp polynomial on d4^2 = d3^2 + r2^2: c3 = -d3 / d4, s3 = -r2 / d4, with z^2 < 0.

    Returns:
        ``value`` and ``slope`` of the cusp polynomial there, and ``z_squared`` times d2^2 (d3^2 + r2^2)^2.
    """
    here = {C: -D3 / D4, S: -R2 / D4}
    on = {D3: sp.sqrt(D4**2 - R2**2)}
    condition = cusp_condition(normal_form())
    parts = {"value": condition, "slope": turned(condition), "z_squared": cusp_height()}
    return {name: sp.simplify(part.subs(here).subs(on)) for name, part in parts.items()}


def printed_numerator() -> Expression:
    """N as condition (7) of the paper prints it; N itself is that of equation (2)."""
    return P**2 - P * D2**2


def sides(steps: Steps) -> dict[str, Expression]:
    """For each surface a number in [-1, 1], positive above it in d4, else negative; signs of lengths drop out.

    C1: A B (2 d4^2 - P) + N, C2: d4 (d3 + d2) - d3 A, C3 and C4: d4 |d3 - d2| - d3 B, E1: 2 d4 - (A - B), E2: d4 - d3,
    E3: 2 d4 - (A + B), each over the sum of its terms' absolute values, so that rounding makes only some units in the
    last place of it.
    """
    lengths = [steps.let(f"length_{n}", sp.Max(x, -x)) for n, x in zip("234r", (D2, D3, D4, R2), strict=True)]
    total = steps.let("total", sum(lengths, sp.Integer(0)))
    d2, d3, d4, r2 = (steps.let(f"share_{n}", x / total) for n, x in zip("234r", lengths, strict=True))
    here = dict(zip((D2, D3, D4, R2), (d2, d3, d4, r2), strict=True))
    a, b = (steps.let(n, sp.sqrt(e.xreplace(here))) for n, e in zip("AB", squares(), strict=True))
    p, m = steps.let("P", P.xreplace(here)), steps.let("M", a * b)
    gap = steps.let("gap", sp.Max(d3 - d2, d2 - d3))
    n = steps.let("N", p**2 - (d3 - r2) * (d3 + r2) * d2**2)
    n_size = p**2 + p * d2**2
    difference = steps.let("difference", 4 * d2 * d3 / (a + b))
    terms = {
        "C1": (m * (2 * d4**2 - p) + n, m * (2 * d4**2 + p) + n_size),
        "C2": (d4 * (d3 + d2) - d3 * a, d4 * (d3 + d2) + d3 * a),
        "C3": (d4 * gap - d3 * b, d4 * gap + d3 * b),
        "E1": (2 * d4 - difference, 2 * d4 + difference),
        "E2": (d4 - d3, d4 + d3),
        "E3": (2 * d4 - a - b, 2 * d4 + a + b),
    }
    return {name: steps.let(name, top / below) for name, (top, below) in terms.items()}


def above(side: Expression) -> Expression:
    """1 above a surface, 0 below."""
    return (1 + CopySign(_1, side)) / 2


def classify() -> Program:
    """The domain 1 to 5 and the topology 1 to 9, each 0 where a deciding side is within rounding of 0 or a length is 0.

    C1 < C2 < C3 (for d3 > d2) and C1 < C2 < C4 (for d3 < d2). Of the node surfaces E1 and E2 cut domain 2, E3 domains
    3 and 5.
    """
    steps = Steps()
    found = sides(steps)
    one, two, three, e1, e2, e3 = (steps.let(f"above_{name}", above(side)) for name, side in found.items())
    size = {name: steps.let(f"size_{name}", sp.Max(side, -side)) for name, side in found.items()}
    larger = steps.let("larger", above(sp.Max(D2, -D2) - sp.Max(D3, -D3)))
    five, four = steps.let("five", three * larger), steps.let("four", three * (1 - larger))
    middle, third = steps.let("in_two", one * (1 - two)), steps.let("in_three", two * (1 - three))
    clear = steps.let("clear", sp.Min(size["C1"], size["C2"], size["C3"]) - ROUNDING)
    there = steps.let("there", Where(D2, Where(D3, Where(D4, Where(R2, above(clear))))))
    domain = there * (1 + one * (1 + two * (1 + three * (1 + larger))))
    topology = 1 + middle * (1 + e1 * (1 + e2)) + third * (4 + e3) + 6 * four + five * (7 + e3)
    nodes = sp.Min(size["E1"], size["E2"]) * middle + size["E3"] * (third + five) + (1 - one) + four
    return Program(
        "classify",
        "the domain 1 to 5 and the topology 1 to 9 of a design, each 0 where rounding would decide it",
        (normal_form().inputs,),
        tuple(steps.steps),
        (
            Output("domain", (), (domain,)),
            Output("topology", (), (there * above(nodes - ROUNDING) * topology,)),
        ),
    )


def sides_of_surfaces() -> Program:
    """Where a design lies in relation to each surface."""
    steps = Steps()
    found = tuple(sides(steps).values())
    return Program(
        "sides",
        "on which side of C1, C2, C3 or C4, E1, E2, E3 a design lies: above is positive, at most 1",
        (normal_form().inputs,),
        tuple(steps.steps),
        (Output("sides", (6,), found),),
    )


def squared_sides() -> dict[str, Expression]:
    """The sides of the surfaces without square roots but A B, as polynomials of positive lengths.

    C1 is ``C1_whole`` + ``C1_factor`` sqrt(``C1_radicand``), with A B = sqrt(A^2 B^2). C2 and C3, C4 are squared:
    d4^2 (d3 +- d2)^2 - d3^2 A^2 (or B^2). E1 and E3 are the roots of x^2 - X x + d2^2 d3^2 in x = d4^2, where
    X = (A^2 + B^2) / 2: ``E`` is negative between them, and ``middle`` = d4^2 - d2 d3 tells which of them is near, as
    E1 E3 = d2 d3.
    """
    a_square, b_square = squares()
    return {
        "C1_whole": N,
        "C1_factor": 2 * D4**2 - P,
        "C1_radicand": a_square * b_square,
        "C2": D4**2 * (D3 + D2) ** 2 - D3**2 * a_square,
        "C3": D4**2 * (D3 - D2) ** 2 - D3**2 * b_square,
        "E": D4**2 * (D4**2 - X) + D2**2 * D3**2,
        "middle": D4**2 - D2 * D3,
        "E2": D4 - D3,
        "gap": D3 - D2,
    }


def exact_sides() -> Program:
    """What decides a design exactly: run on fractions, its signs are those of the surfaces."""
    steps = Steps()
    a, b = (steps.let(name, square) for name, square in zip(("AA", "BB"), squares(), strict=True))
    named = {squares()[0]: a, squares()[1]: b}
    entries = tuple(value.xreplace(named) for value in squared_sides().values())
    return Program(
        "exact_sides",
        "polynomials whose signs tell on which side of the surfaces a design lies: " + ", ".join(squared_sides()),
        (normal_form().inputs,),
        tuple(steps.steps),
        (Output("sides", (len(entries),), entries),),
    )
