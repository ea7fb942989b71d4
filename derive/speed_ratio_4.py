"""Speed-ratio control of planar arms with two joints to spare: tangent, curvature and its rate (Ambike, section 3).

Unit-speed joint rates along T are x = J^+ T + x1 n1 + x2 n2, with n1, n2 an orthonormal basis of the null space. In
(x1, x2) the curvature T x r'' is a quadratic and dk/ds = T x r''' - 3 k (T.r'') a cubic: where the paper counts a
sextic, unit speed leaves a conic and a cubic, and at most six solutions.

With a leading joint, as in the paper, the third-order condition dk/ds = rho is the sextic
    rho |r'|^6 - |r'|^2 (r' x r''') + 3 (r' x r'')(r'.r'') = 0.
On the line (5), r' = v T, and with (6), T x r'' = k v^2, it is v^3 times the cubic
    rho v^3 - T x r''' + 3 k v (T.r'') = 0.
Of its twelve intersections with the conic (6) six are therefore the two points where the tip stands still (v = 0 on the
conic), threefold each; the others are the six solutions.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from chainrule.derive.manipulability import orthonormal_rows
from chainrule.derive.planar import PlanarChain
from chainrule.derive.program import CopySign, Expression, Output, Program, Steps
from chainrule.derive.speed_ratio import TANGENT, Rates, Row, TangentFrame, tangent_frame

X, Y = sp.symbols("x1 x2", real=True)
#: The speed ratios that are left when joint 1 leads and the line (5) has eliminated the fourth.
RATIOS = sp.symbols("n2 n3", real=True)
#: Powers of (x1, x2) in the order of the coefficients.
QUADRATIC = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
CUBIC = (*QUADRATIC, (3, 0), (2, 1), (1, 2), (0, 3))


def null_basis(steps: Steps, u: Row, v: Row) -> tuple[Row, Row]:
    """An orthonormal basis of what is perpendicular to two orthonormal rows of four.

    iu, ju, ku (quaternion products) complete u to a basis, in which v is a unit vector n of space; the plane across n
    gets its basis by the formula of Duff et al. (2017), in which nothing is ever divided by a small number.
    """
    u1, u2, u3, u4 = u
    frame = [[-u2, u1, -u4, u3], [-u3, u4, u1, -u2], [-u4, -u3, u2, u1]]
    n = [
        steps.let(f"n{k + 1}", sum((a * b for a, b in zip(row, v, strict=True)), sp.Integer(0)))
        for k, row in enumerate(frame)
    ]
    sign = steps.let("sign", CopySign(sp.Integer(1), n[2]))
    a = steps.let("a", -1 / (sign + n[2]))
    b = steps.let("b", n[0] * n[1] * a)
    plane = ([1 + sign * n[0] ** 2 * a, sign * b, -sign * n[0]], [b, sign + n[1] ** 2 * a, -n[1]])
    found = []
    for number, weights in enumerate(plane, 1):
        weights = [steps.let(f"weight{number}", w) for w in weights]
        found.append(
            [
                steps.let(
                    f"null{number}_{k + 1}",
                    sum((w * row[k] for w, row in zip(weights, frame, strict=True)), sp.Integer(0)),
                )
                for k in range(4)
            ]
        )
    return found[0], found[1]


def conditions(arm: PlanarChain) -> Program:
    """The conic and the cubic: coefficients of T x r'', T.r'' and T x r''' over the powers of (x1, x2)."""
    steps = Steps()
    frame = tangent_frame(steps, arm)
    # Gram-Schmidt from ``across``: then J^+ T lies along the second unit row, divided by its pivot
    (v, u), lower = orthonormal_rows(steps, [frame.across, frame.along], passes=2)
    basis = null_basis(steps, u, v)
    least = [steps.let(f"least{k + 1}", e / lower[1][1]) for k, e in enumerate(u)]
    general = [least[k] + X * basis[0][k] + Y * basis[1][k] for k in range(4)]
    along, across, third = _coefficients(steps, frame, general)
    outputs = (
        Output("least", (4,), tuple(least)),
        Output("basis", (2, 4), (*basis[0], *basis[1])),
        Output("along", (len(QUADRATIC),), tuple(along)),
        Output("across", (len(QUADRATIC),), tuple(across)),
        Output("third", (len(CUBIC),), tuple(third)),
    )
    return Program(
        "speed_ratio_conditions",
        "J^+ T, a basis of the null space, and over the powers of (x1, x2): T.r'', T x r'' and T x r'''",
        (*arm.inputs, TANGENT),
        tuple(steps.steps),
        outputs,
    )


def _coefficients(steps: Steps, frame: TangentFrame, general: Row) -> tuple[Row, Row, Row]:
    """T.r'', T x r'' and T x r''' at the rates ``general``, over the powers of (x1, x2)."""
    links = frame.rates(general)
    turning = [_named(steps, f"w{k + 1}_", rate) for k, rate in enumerate(links.turning)]
    named = Rates(turning, links.sliding)
    along, across = frame.second(named, named)
    return (
        _powers(steps, "along", along, QUADRATIC),
        _powers(steps, "across", across, QUADRATIC),
        _powers(steps, "third", frame.third(named)[1], CUBIC),
    )


def _named(steps: Steps, name: str, linear: Expression) -> Expression:
    """A linear form in (x1, x2) with its coefficients named."""
    flat = sp.Poly(linear, X, Y)
    return sum(
        (steps.let(name, flat.coeff_monomial(X**i * Y**j)) * X**i * Y**j for i, j in ((0, 0), (1, 0), (0, 1))),
        sp.Integer(0),
    )


def _powers(steps: Steps, name: str, expression: Expression, powers: tuple[tuple[int, int], ...]) -> Row:
    flat = sp.Poly(sp.expand(expression), X, Y)
    return [steps.let(f"{name}{i}_{j}", flat.coeff_monomial(X**i * Y**j)) for i, j in powers]


LINEAR, KAPPA, RHO = sp.symbols("v kappa rho", real=True)


def sextic(first: Row, second: Row, third: Row, rho: Expression) -> Expression:
    """The third-order condition |r'|^6 (rho - dk/ds) of any motion with these derivatives (two components each)."""
    square, turn = _dot(first, first), _cross(first, second)
    return rho * square**3 - square * _cross(first, third) + 3 * turn * _dot(first, second)


def cubic(v: Expression, along: Expression, third: Expression, kappa: Expression, rho: Expression) -> Expression:
    """What is left of it where the tangent and the curvature are met: rho v^3 - T x r''' + 3 kappa v (T.r'')."""
    return rho * v**3 - third + 3 * kappa * v * along


def reduction() -> Expression:
    """The sextic minus v^3 times the cubic, where r' = v T and T x r'' = kappa v^2: zero, for every chain.

    The components are those along T and across it, so T = (1, 0).
    """
    along, along3, across3 = sp.symbols("along2 along3 across3", real=True)
    first, second, third = [LINEAR, sp.Integer(0)], [along, KAPPA * LINEAR**2], [along3, across3]
    whole = sextic(first, second, third, RHO)
    return sp.expand(whole - LINEAR**3 * cubic(LINEAR, along, across3, KAPPA, RHO))


def _dot(a: Row, b: Row) -> Expression:
    return a[0] * b[0] + a[1] * b[1]


def _cross(a: Row, b: Row) -> Expression:
    return a[0] * b[1] - a[1] * b[0]


@dataclass(frozen=True)
class PaperSystem:
    """The paper's equations for one arm, joint 1 leading, on the line (5): polynomials in the ratios n2 and n3.

    Attributes:
        conic: equation (6).
        sextic: the third-order condition as it stands.
        still: v = r'.T, zero where the tip stands still.
        cubic: what the sextic is v^3 times of, on the conic.
    """

    conic: Expression
    sextic: Expression
    still: Expression
    cubic: Expression


def paper_system(arm: PlanarChain, numbers: Mapping[Expression, Expression]) -> PaperSystem:
    """Equations (6) and third order after elimination of n4 by (5).

    Args:
        arm: a symbolic chain of four joints.
        numbers: values of sin(q_i) and cos(q_i) (q_i of prismatic joints), the parameters, the tangent, and
            :data:`KAPPA` and :data:`RHO`; exact ones give exact polynomials.
    """
    steps = Steps()
    symbolic = tangent_frame(steps, arm)
    known: dict[Expression, Expression] = {}
    for step in steps.steps:
        known[step.symbol] = step.expression.xreplace(known).xreplace(numbers)

    def value(e: Expression) -> Expression:
        return e.xreplace(known).xreplace(numbers)

    frame = TangentFrame(
        symbolic.kinds,
        [value(e) for e in symbolic.along],
        [value(e) for e in symbolic.across],
        [(value(c), value(s)) for c, s in symbolic.headings],
        [value(e) for e in symbolic.advances],
    )
    n2, n3 = RATIOS
    n4 = -(frame.across[0] + frame.across[1] * n2 + frame.across[2] * n3) / frame.across[3]
    x = [sp.Integer(1), n2, n3, n4]
    links = frame.rates(x)
    v = sp.expand(sum((e * rate for e, rate in zip(frame.along, x, strict=True)), sp.Integer(0)))
    second, third = list(frame.second(links, links)), list(frame.third(links))
    kappa, rho = KAPPA.xreplace(numbers), RHO.xreplace(numbers)
    return PaperSystem(
        sp.expand(kappa * v**2 - second[1]),
        sp.expand(sextic([v, sp.Integer(0)], second, third, rho)),
        v,
        sp.expand(cubic(v, second[0], third[1], kappa, rho)),
    )
