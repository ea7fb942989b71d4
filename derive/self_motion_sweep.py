"""What sweeping one joint of a redundant arm takes: all postures of the 3R arm that is left, also where it is special.

With the first or last three axes of a 7R arm meeting in a point, and the joint at the other end held, the three joints
between place that point: a 3R arm, in the normal form of ``chainrule.derive.regional_3r``. Its two conditions are
    U = R - F3(theta3) = 2 d2 A,   V = z - F4(theta3) = sa2 B,   A^2 + B^2 = W(theta3),
(A, B) being (f1, f2) turned by theta2. In general A and B follow from U and V, and theta3 from a quartic. Where axes 1
and 2 of that arm meet (d2 = 0, as in the Panda) U = 0 alone holds theta3, a quadratic in its half tangent, and
A = +-sqrt(W - B^2); where they are parallel (sa2 = 0) V = 0 does, and B = +-sqrt(W - A^2). The three polynomials are
given on their own here, so that discriminants and resultants of either case can be taken.
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.program import Input, Output, Program, Steps
from chainrule.derive.regional_3r import ELBOW, TARGET, Arm, in_half_tangent, mismatch

#: A and B: the point, seen from joint 2, turned by theta2.
TURNED = Input("turned", (2,), sp.symbols("A B", real=True))


def conditions(where: Arm) -> Program:
    """U, V and W as polynomials in tan(theta3 / 2)."""
    u, v = (in_half_tangent(part, 1) for part in mismatch(where))
    return Program(
        "sweep_conditions",
        "coefficients, lowest power of t = tan(theta3/2) first, of (1 + t^2) U, (1 + t^2) V and (1 + t^2)^2 W",
        (where.inputs, TARGET),
        (),
        (Output("U", (3,), u), Output("V", (3,), v), Output("W", (5,), in_half_tangent(where.width, 2))),
    )


def elbow(where: Arm) -> Program:
    """U, V and the point in frame 2 at given c3, s3."""
    steps = Steps()
    u, v = (steps.let(name, part) for name, part in zip("UV", mismatch(where), strict=True))
    return Program(
        "sweep_elbow",
        "U and V, and f1 and f2, the point in the frame of joint 2, from cos(theta3), sin(theta3) and a target",
        (where.inputs, ELBOW, TARGET),
        tuple(steps.steps),
        (Output("mismatch", (2,), (u, v)), Output("point", (2,), where.point[:2])),
    )


def base(where: Arm) -> Program:
    """Where the point is at theta1 = 0, from A and B."""
    a, b = TURNED.symbols
    return Program(
        "sweep_base",
        "x and y of the point at theta1 = 0, from A, B and cos(theta3), sin(theta3)",
        (where.inputs, ELBOW, TURNED),
        (),
        (Output("xy", (2,), (where.d2 + a, where.ca2 * b - where.sa2 * (where.point[2] + where.r2))),),
    )


EVERY = (conditions, elbow, base)
