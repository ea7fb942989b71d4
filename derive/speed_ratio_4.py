"""Speed-ratio control of planar arms with two joints to spare: tangent, curvature and its rate (Ambike, section 3).

Unit-speed joint rates along T are x = J^+ T + x1 n1 + x2 n2, with n1, n2 an orthonormal basis of the null space. In
(x1, x2) the curvature T x r'' is a quadratic and dk/ds = T x r''' - 3 k (T.r'') a cubic: where the paper counts a
sextic, unit speed leaves a conic and a cubic, and at most six solutions.
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.manipulability import orthonormal_rows
from chainrule.derive.planar import PlanarChain
from chainrule.derive.program import CopySign, Expression, Output, Program, Steps
from chainrule.derive.speed_ratio import TANGENT, Rates, Row, TangentFrame, tangent_frame

X, Y = sp.symbols("x1 x2", real=True)
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
    (v, u), pivots = orthonormal_rows(steps, [frame.across, frame.along], passes=2)
    basis = null_basis(steps, u, v)
    least = [steps.let(f"least{k + 1}", e / pivots[1]) for k, e in enumerate(u)]
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
