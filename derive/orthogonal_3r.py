"""Orthogonal 3R arms (Baili, Wenger, Chablat): alpha_2 = -90 deg, alpha_3 = 90 deg, r_3 = 0, lengths symbolic.

The determinant of the position Jacobian factors as d4 (d3 + c3 d4)(s3 d2 + c2 (s3 d3 - c3 r2)); equation (1) of the
paper lacks the factor d4.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from chainrule.derive import regional_3r
from chainrule.derive.chain import Chain, Link, minor_matrix
from chainrule.derive.manipulability import maximal_minors
from chainrule.derive.program import Expression, Input, Output, Program, Steps, closed_form, variables

_0, _1 = sp.Integer(0), sp.Integer(1)
_EYE = ((_1, _0, _0), (_0, _1, _0), (_0, _0, _1))


def orthogonal_chain() -> Chain:
    """The family as a serial chain in modified Denavit-Hartenberg frames; input ``parameters`` (d2, d3, d4, r2)."""
    d2, d3, d4, r2 = symbols = sp.symbols("d2 d3 d4 r2", real=True)
    down = ((_1, _0, _0), (_0, _0, _1), (_0, -_1, _0))  # turned by -90 deg about x
    up = ((_1, _0, _0), (_0, _0, -_1), (_0, _1, _0))
    links = (Link(_EYE, (_0, _0, _0)), Link(down, (d2, r2, _0)), Link(up, (d3, _0, _0)))
    return Chain("RRR", links, Link(_EYE, (d4, _0, _0)), (variables("q", 3), Input("parameters", (4,), symbols)))


def normal_form() -> regional_3r.Arm:
    """The family in the normal form of any 3R arm: ca2 = 0, sa2 = -1, ca3 = 0, sa3 = 1, r3 = 0."""
    given = orthogonal_chain().inputs[1]
    d2, d3, d4, r2 = given.symbols
    return regional_3r.Arm(given, _0, -_1, _0, _1, d2, d3, d4, r2, _0)


@cache
def determinant() -> Expression:
    """det J of the position, factored by SymPy, in c2, s2, c3, s3 and the lengths."""
    steps = Steps()
    (entry,) = maximal_minors(steps, minor_matrix(steps, orthogonal_chain(), "position"))
    program = Program("", "", (), tuple(steps.steps), (Output("det", (), (entry,)),))
    (value,) = closed_form(program)["det"]
    names = {
        f(q): sp.Symbol(f"{n}{i}")
        for i, q in enumerate(orthogonal_chain().q, 1)
        for f, n in ((sp.sin, "s"), (sp.cos, "c"))
    }
    value = sp.expand(value.xreplace(names))
    for i in (1, 2, 3):
        s, c = sp.symbols(f"s{i} c{i}")
        value = sp.expand(sp.rem(value, s**2 + c**2 - 1, s)) if value.has(s) else value
    back = {symbol: f for f, symbol in names.items()}
    return sp.factor(value).xreplace(back)


def minors(arm: Chain) -> Program:
    """The one maximal minor, det J, in factored form."""
    steps = Steps()
    q2, q3 = arm.q[1:]
    named = {f(q): steps.let(f"{n}{i}", f(q)) for i, q in ((2, q2), (3, q3)) for f, n in ((sp.sin, "s"), (sp.cos, "c"))}
    return Program(
        "minors_position",
        "determinant of the position Jacobian, factored",
        arm.inputs,
        tuple(steps.steps),
        (Output("minors", (1,), (determinant().xreplace(named),)),),
    )
