"""The planar 3R arm in closed form: minors, manipulability and singular set (De Luca, exercise 1).

SymPy simplifies the minors of the position Jacobian to
    M12 = l1 (l2 s2 + l3 s23),   M13 = l3 (l1 s23 + l2 s3),   M23 = l2 l3 s3
(s2 = sin q2, s3 = sin q3, s23 = sin(q2 + q3)), so that H = sqrt(M12^2 + M13^2 + M23^2), equation (1) of the
paper: q1 does not appear.
"""

from __future__ import annotations

from functools import cache
from itertools import combinations

import sympy as sp

from chainrule.derive.manipulability import root_sum_of_squares
from chainrule.derive.planar import PlanarChain, jacobian_of, layout, place_output
from chainrule.derive.program import Expression, Input, Output, Program, Steps, closed_form


@cache
def closed_minors(arm: PlanarChain) -> tuple[Expression, ...]:
    """The three minors, simplified from the Jacobian's own columns: functions of q2 and q3 only."""
    steps = Steps()
    output = jacobian_of(steps, arm, layout(steps, arm), "position")
    entries = closed_form(Program("", "", arm.inputs, tuple(steps.steps), (output,)))["jacobian"]
    rows = sp.Matrix(2, 3, entries)
    return tuple(sp.factor(sp.simplify(rows[:, list(pair)].det())) for pair in combinations(range(3), 2))


def singular_set(arm: PlanarChain) -> tuple[dict[Expression, Expression], ...]:
    """Every (q2, q3) in (-pi, pi]^2 where all minors vanish, for non-zero lengths.

    Solved in the paper's order: the last minor gives q3, the second then q2, and the first must vanish too.
    """
    m12, m13, m23 = closed_minors(arm)
    q2, q3 = arm.inputs[0].symbols[1:]
    turn = sp.Interval.Lopen(-sp.pi, sp.pi)
    positive = {length: sp.Symbol(str(length), positive=True) for length in arm.inputs[1].symbols}
    found = []
    for third in sp.solveset(m23.xreplace(positive), q3, turn):
        for second in sp.solveset(sp.simplify(m13.xreplace(positive).subs(q3, third)), q2, turn):
            if sp.simplify(m12.subs({q2: second, q3: third})) == 0:
                found.append({q2: second, q3: third})
    return tuple(sorted(found, key=lambda pair: (float(pair[q2]), float(pair[q3]))))


def _named(steps: Steps, arm: PlanarChain) -> list[Expression]:
    """The closed minors over steps s2, c2, s3, c3 and s23 = s2 c3 + c2 s3."""
    q2, q3 = arm.inputs[0].symbols[1:]
    s2, c2 = steps.let("s2", sp.sin(q2)), steps.let("c2", sp.cos(q2))
    s3, c3 = steps.let("s3", sp.sin(q3)), steps.let("c3", sp.cos(q3))
    s23 = steps.let("s23", s2 * c3 + c2 * s3)
    sines = {sp.sin(q2): s2, sp.sin(q3): s3, sp.sin(q2 + q3): s23}
    pairs = ("12", "13", "23")
    return [steps.let(f"M{pair}", m.xreplace(sines)) for pair, m in zip(pairs, closed_minors(arm), strict=True)]


def minors(arm: PlanarChain) -> Program:
    """The minors (1,2), (1,3), (2,3) of the position Jacobian."""
    steps = Steps()
    entries = tuple(_named(steps, arm))
    return Program(
        "minors_position",
        "minors (1,2), (1,3), (2,3) of the position Jacobian, in closed form",
        arm.inputs,
        tuple(steps.steps),
        (Output("minors", (3,), entries),),
    )


def survey(arm: PlanarChain) -> Program:
    """Position, Jacobian and H together: what a sweep over the workspace asks."""
    steps = Steps()
    place = layout(steps, arm)
    outputs = (
        place_output(place, "position"),
        jacobian_of(steps, arm, place, "position"),
        Output("manipulability", (), (root_sum_of_squares(steps, _named(steps, arm)),)),
    )
    return Program(
        "survey_position", "position, Jacobian and manipulability H together", arm.inputs, tuple(steps.steps), outputs
    )


def postures(arm: PlanarChain) -> Program:
    """Both solutions q of a pose (x, y, alpha), and the radicand that says whether they exist.

    The last joint sits at w = (x, y) - l3 (cos alpha, sin alpha), and the first two links reach it as a 2R arm:
    with C = |w|^2 - l1^2 - l2^2 = 2 l1 l2 c2 and S = 2 l1 l2 s2 = +-sqrt(((l1 + l2)^2 - |w|^2) (|w|^2 - (l1 - l2)^2)),
    q2 = atan2(S, C), q1 = atan2(w_y, w_x) - atan2(S, 2 l1^2 + C) and q3 = alpha - q1 - q2. Angles are not wrapped.
    """
    l1, l2, l3 = arm.inputs[1].symbols
    target = Input("target", (3,), tuple(sp.Symbol(name, real=True) for name in ("x", "y", "alpha")))
    x, y, alpha = target.symbols
    steps = Steps()
    wx = steps.let("wx", x - l3 * steps.let("c_alpha", sp.cos(alpha)))
    wy = steps.let("wy", y - l3 * steps.let("s_alpha", sp.sin(alpha)))
    square = steps.let("square", wx**2 + wy**2)
    distance = steps.let("distance", sp.sqrt(square))
    outside = steps.let("outside", (l1 + l2 - distance) * (l1 + l2 + distance))
    inside = steps.let("inside", (distance - l1 + l2) * (distance + l1 - l2))
    radicand = steps.let("radicand", outside * inside)
    root = steps.let("S", sp.sqrt(sp.Max(radicand, sp.Integer(0))))
    c = steps.let("C", square - l1**2 - l2**2)
    towards = steps.let("towards", sp.atan2(wy, wx))
    elbow = steps.let("elbow", sp.atan2(root, c))
    bend = steps.let("bend", sp.atan2(root, 2 * l1**2 + c))
    entries: list[Expression] = []
    for sign in (1, -1):
        first = steps.let("first", towards - sign * bend)
        entries += [first, sign * elbow, alpha - first - sign * elbow]
    return Program(
        "postures",
        "both postures of a pose (x, y, alpha), and the radicand, negative where there are none",
        (target, arm.inputs[1]),
        tuple(steps.steps),
        (Output("q", (2, 3), tuple(entries)), Output("radicand", (), (radicand,))),
    )
