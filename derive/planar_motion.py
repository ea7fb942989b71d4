"""The tip's path while the joints of a planar chain move: derivatives up to the fourth, speed, curvature and its rates.

A link adds z = a exp(i phi), a its advance and phi its heading. With w = d phi/dt, differentiating in the heading's
frame is D(X + i Y) = X' - w Y + i (Y' + w X): four applications to X = a, Y = 0 give every derivative of the tip.
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.planar import PlanarChain, layout
from chainrule.derive.program import Expression, GuardedInverse, Input, Output, Program, Steps

ORDERS = 4


def joint_motion(n: int) -> tuple[Input, ...]:
    """First, second and third derivatives of the joint values, as inputs."""
    names = (("rates", "dq"), ("second", "ddq"), ("third", "dddq"))
    return tuple(
        Input(name, (n,), tuple(sp.Symbol(f"{label}{i + 1}", real=True) for i in range(n))) for name, label in names
    )


def link_derivatives(orders: int = ORDERS) -> list[tuple[Expression, Expression]]:
    """Components along and across the heading of the derivatives 0 .. ``orders`` of a exp(i phi).

    Polynomials in the symbols a0, a1, ... (the advance and its derivatives) and w0, w1, ... (the heading's rate).
    """
    a, w = ([sp.Symbol(f"{name}{k}", real=True) for k in range(orders + 2)] for name in "aw")
    following = {symbol: chain[k + 1] for chain in (a, w) for k, symbol in enumerate(chain[:-1])}

    def changed(expression: Expression) -> Expression:
        return sum((sp.diff(expression, s) * following[s] for s in expression.free_symbols), sp.Integer(0))

    found = [(a[0], sp.Integer(0))]
    for _ in range(orders):
        along, across = found[-1]
        found.append((sp.expand(changed(along) - w[0] * across), sp.expand(changed(across) + w[0] * along)))
    return found


def tip_motion(arm: PlanarChain) -> Program:
    """r, r', r'', r''', r'''' of the tip along q(t) with the given derivatives (those from the fourth on are zero).

    Also the path's speed v = |r'|, signed curvature k = (r' x r'') / v^3 (left turns positive), dk/ds and d^2k/ds^2;
    all 0 where the tip stands still.
    """
    steps = Steps()
    place = layout(steps, arm)
    motion = joint_motion(arm.n)
    rates = [given.symbols for given in motion]
    zero = sp.Integer(0)
    turning = [zero, zero, zero]
    totals = [[zero, zero] for _ in range(ORDERS)]
    for i, kind in enumerate(arm.kinds):
        length, shift = arm.inputs[1].symbols[i], arm.inputs[0].symbols[i]
        if kind == "R":
            turning = [steps.let(f"w{i + 1}{'dt' * k}", turning[k] + rates[k][i]) for k in range(3)]
        advance = [length, zero, zero, zero] if kind == "R" else [length + shift, *(rates[k][i] for k in range(3))]
        advance = [steps.let(f"a{i + 1}", advance[0]), *advance[1:]]
        values = {sp.Symbol(f"a{k}", real=True): entry for k, entry in enumerate([*advance, zero, zero])}
        values |= {sp.Symbol(f"w{k}", real=True): entry for k, entry in enumerate([*turning, zero, zero, zero])}
        c, s = place.headings[i]
        for order, (along, across) in enumerate(link_derivatives()[1:]):
            x = steps.let(f"along{i + 1}_{order + 1}", along.xreplace(values))
            y = steps.let(f"across{i + 1}_{order + 1}", across.xreplace(values))
            totals[order][0] = steps.let(f"r{order + 1}x{i + 1}", totals[order][0] + x * c - y * s)
            totals[order][1] = steps.let(f"r{order + 1}y{i + 1}", totals[order][1] + x * s + y * c)
    entries = [*place.tip, *(entry for pair in totals for entry in pair)]
    outputs = (Output("derivatives", (ORDERS + 1, 2), tuple(entries)), Output("path", (4,), path(steps, totals)))
    return Program(
        "tip_motion",
        "derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2",
        (*arm.inputs, *motion),
        tuple(steps.steps),
        outputs,
    )


def path(steps: Steps, derivatives: list[list[Expression]]) -> tuple[Expression, ...]:
    """Speed, curvature k and its first two derivatives by arc length, from r' .. r''''.

    With P = r' x r'', V = r'.r' and the slowness u = V^(-1/2): k = P u^3, d/ds = u d/dt, du/dt = -V' u^3 / 2.
    """
    first, second, third, fourth = derivatives

    def cross(a: list[Expression], b: list[Expression]) -> Expression:
        return a[0] * b[1] - a[1] * b[0]

    def dot(a: list[Expression], b: list[Expression]) -> Expression:
        return a[0] * b[0] + a[1] * b[1]

    speed = steps.let("speed", sp.sqrt(dot(first, first)))
    u = steps.let("slowness", GuardedInverse(speed))
    square = steps.let("square", u**2)
    turn = [
        steps.let("P", cross(first, second)),
        steps.let("dP", cross(first, third)),
        steps.let("ddP", cross(second, third) + cross(first, fourth)),
    ]
    stretch = [steps.let("dV", 2 * dot(first, second)), steps.let("ddV", 2 * (dot(second, second) + dot(first, third)))]
    rate = {turn[0]: turn[1], turn[1]: turn[2], stretch[0]: stretch[1], u: -stretch[0] * u**3 / 2}
    geometry = [turn[0] * u**3]
    for _ in range(2):
        geometry.append(sp.expand(u * sum(sp.diff(geometry[-1], symbol) * rate[symbol] for symbol in rate)))

    def with_square(term: Expression) -> Expression:
        power = sp.degree(term, u)
        return term / u**power * square ** (power // 2) * u ** (power % 2)

    found = [sum(map(with_square, sp.Add.make_args(sp.expand(e))), sp.Integer(0)) for e in geometry]
    return (speed, *(steps.let("curvature", expression) for expression in found))
