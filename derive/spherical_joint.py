"""Three revolute axes that meet in a point, and an elbow between two such points: the angles they need, in two ways.

*Orientation* (subproblems of B. Paden, 1986). Rz(a) S Rz(b) T Rz(c) = E with fixed rotations S and T. With u = z S (a
row), w = T z (a column) the entry z E z = u Rz(b) w is
    E33 = u3 w3 + k cos b + l sin b,   k = u1 w1 + u2 w2,   l = u2 w1 - u1 w2,
so that b = atan2(l, k) +- arccos(share), share = (E33 - u3 w3) / sqrt(k^2 + l^2). Then E z = Rz(a) (S Rz(b) T) z holds
a, and what is left, (Rz(a) S Rz(b) T)^T E, is a turn about z by c. Where the outer axes are in line a is any angle: 0.

*Elbow*. The shoulder is at s in the frame before the elbow's turn, the wrist at w in the one after it; their distance d
is held:
    d^2 = |Rz(q) w - s|^2 = w^2 + s^2 - 2 s3 w3 - 2 (k cos q + l sin q),   k = s1 w1 + s2 w2,   l = s2 w1 - s1 w2.

Both have solutions where |share| <= 1; beyond it the angles given are those of +-1.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from chainrule.derive.program import Expression, GuardedInverse, Input, Output, Program, Steps, Where

_0, _1 = sp.Integer(0), sp.Integer(1)


def _matrix(name: str) -> tuple[Input, sp.Matrix]:
    symbols = tuple(sp.Symbol(f"{name}_{i + 1}{j + 1}", real=True) for i in range(3) for j in range(3))
    return Input(name, (3, 3), symbols), sp.Matrix(3, 3, symbols)


def _two_ways(
    steps: Steps, u: Sequence[Expression], w: Sequence[Expression], value: Expression
) -> tuple[Expression, list[tuple[Expression, Expression]]]:
    """The share, and the two pairs (cos, sin) with u1 w1 + ... of the turned w equal to a value."""
    k = steps.let("k", u[0] * w[0] + u[1] * w[1])
    l = steps.let("l", u[1] * w[0] - u[0] * w[1])  # noqa: E741
    over = steps.let("over", GuardedInverse(sp.sqrt(k**2 + l**2)))
    share = steps.let("share", value * over)
    clipped = steps.let("clipped", sp.Max(sp.Min(share, _1), -_1))
    root = steps.let("root", sp.sqrt(sp.Max((1 - clipped) * (1 + clipped), _0)))
    ways = []
    for sign in (1, -1):
        cosine = steps.let("cosine", (k * clipped - sign * l * root) * over)
        sine = steps.let("sine", (l * clipped + sign * k * root) * over)
        ways.append((cosine, sine))
    return share, ways


def orientations() -> Program:
    """The two ways in which three axes take an orientation."""
    steps = Steps()
    (first, s), (second, t), (wanted, e) = _matrix("second"), _matrix("third"), _matrix("wanted")
    share, ways = _two_ways(steps, s.row(2), t.col(2), steps.let("value", e[2, 2] - s[2, 2] * t[2, 2]))
    angles: list[Expression] = []
    for cosine, sine in ways:
        rows = (t.row(0) * cosine - t.row(1) * sine, t.row(0) * sine + t.row(1) * cosine, t.row(2))
        inner = sp.Matrix(3, 3, [steps.let("inner", entry) for row in rows for entry in row])
        middle = sp.Matrix(3, 3, [steps.let("middle", entry) for entry in s * inner])
        x = steps.let("x", e[0, 2] * middle[0, 2] + e[1, 2] * middle[1, 2])
        y = steps.let("y", e[1, 2] * middle[0, 2] - e[0, 2] * middle[1, 2])
        size = steps.let("size", sp.sqrt(x**2 + y**2))
        over = steps.let("over_size", GuardedInverse(size))
        ca = steps.let("ca", x * over + 1 - Where(size, _1))
        sa = steps.let("sa", y * over)
        columns = [
            (ca * middle[0, j] - sa * middle[1, j], sa * middle[0, j] + ca * middle[1, j], middle[2, j]) for j in (0, 1)
        ]
        along = [steps.let("along", sum(part * e[i, 0] for i, part in enumerate(column))) for column in columns]
        angles += [sp.atan2(sa, ca), sp.atan2(sine, cosine), sp.atan2(along[1], along[0])]
    return Program(
        "spherical_orientations",
        "angles a, b, c with Rz(a) second Rz(b) third Rz(c) = wanted, in two ways; real where |share| <= 1",
        (first, second, wanted),
        tuple(steps.steps),
        (Output("angles", (2, 3), tuple(angles)), Output("share", (1,), (share,))),
    )


def elbow() -> Program:
    """The two angles of a revolute joint at which two points are at a given distance."""
    steps = Steps()
    before = Input("before", (3,), sp.symbols("s1 s2 s3", real=True))
    behind = Input("behind", (3,), sp.symbols("w1 w2 w3", real=True))
    square = Input("square", (1,), (sp.Symbol("distance_squared", real=True),))
    s, w = before.symbols, behind.symbols
    squares = sum(x**2 for x in (*s, *w))
    value = steps.let("value", (squares - 2 * s[2] * w[2] - square.symbols[0]) / 2)
    share, ways = _two_ways(steps, s, w, value)
    return Program(
        "spherical_elbow",
        "angles of a joint, in two ways, at which a point behind it is sqrt(square) from one before it",
        (before, behind, square),
        tuple(steps.steps),
        (Output("angles", (2,), tuple(sp.atan2(y, x) for x, y in ways)), Output("share", (1,), (share,))),
    )


EVERY = (orientations, elbow)
