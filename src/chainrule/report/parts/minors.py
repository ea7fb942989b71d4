"""The maximal minors of the Jacobian, and H from them."""

from __future__ import annotations

import math
from typing import Any

import sympy as sp

from chainrule.arm import Arm
from chainrule.derive import catalogue, manipulability, orthogonal_3r, planar_3r
from chainrule.derive.program import exact
from chainrule.manipulability import unit
from chainrule.report import mathml
from chainrule.report.content import Block, Formula, Formulas, Part, Points, Prose
from chainrule.report.context import Context
from chainrule.report.parts.steps import step_list
from chainrule.report.sections import Section


def _definition() -> Formula:
    """H as the root of the sum of the squared minors."""
    m = mathml
    gram = m.determinant(m.row(m.operator("("), m.bold("J"), f"<msup>{m.bold('J')}<mi>T</mi></msup>", m.operator(")")))
    total = m.row(f"<munder>{m.operator('∑')}<mi>K</mi></munder>", "<msubsup><mi>M</mi><mi>K</mi><mn>2</mn></msubsup>")
    return Formula(m.equation("<mi>H</mi>", f"<msqrt>{gram}</msqrt>", m.operator("="), f"<msqrt>{total}</msqrt>"))


def _planar_3r(arm: Arm) -> list[Block]:
    symbolic = catalogue.symbolic(arm.description.model)
    minors = planar_3r.closed_minors(symbolic)
    lines = tuple(
        mathml.symbol_equation(f"M{pair}", minor) for pair, minor in zip(("12", "13", "23"), minors, strict=True)
    )
    total = mathml.operator("+").join(map(mathml.squared, minors))
    return [
        Prose("The three minors, in closed form (columns 1 and 2, 1 and 3, 2 and 3):"),
        Formulas(lines, "Minors in closed form"),
        Formula(
            mathml.equation("<mi>H</mi>", f"<msqrt>{total}</msqrt>"),
            "q₁ does not appear: turning the whole arm about its base changes neither the minors nor H.",
        ),
    ]


def _orthogonal(arm: Arm) -> list[Block]:
    front, parts = mathml.factors(orthogonal_3r.determinant())
    symbols = catalogue.symbolic(arm.description.model).inputs[1].symbols
    numbers = dict(zip(symbols, map(exact, arm.description.model.parameters), strict=True))
    left = mathml.determinant(mathml.bold("J"))

    def product(factors: list[Any]) -> Any:
        return mathml.equation(
            left,
            mathml.inner(sp.Mul(front, *factors, evaluate=False) if front != 1 else sp.Mul(*factors, evaluate=False)),
        )

    return [
        Formula(
            product(parts), "Three joints for three rows: the only maximal minor is the determinant. SymPy factors it:"
        ),
        Formula(product([mathml.with_decimals(p.xreplace(numbers)) for p in parts]), "With this arm's lengths:"),
        Prose("q₁ does not appear. H is the determinant's magnitude."),
    ]


def _general(arm: Arm, task: str) -> tuple[list[Block], dict[str, object]]:
    """Any other arm: the steps, how many sub-minors they share, and what is zero or missing for certain."""
    rows, n = arm.tasks[task], arm.n
    count, shared = math.comb(n, rows), manipulability.submatrices(rows, n)
    model = arm.description.model
    found = {f.name: f.program for f in catalogue.functions(model, task)}
    program = found.get(f"minors_{task}")
    if program is None:
        return [
            Prose(
                f"A {rows} × {n} Jacobian has {count} maximal minors, which an expansion would need {shared} "
                "sub-minors for. H is computed by an orthogonal factorisation of the rows instead."
            )
        ], {"minors": count}
    zero = [k for k, e in enumerate(program.outputs[0].expressions) if e == 0]
    used = sum(str(step.symbol).startswith("m") for step in program.steps)
    blocks: list[Block] = [
        Prose(
            f"A {rows} × {n} Jacobian has {plural_minors(count)}. They are expanded along rows over subsets of columns "
            f"(Laplace) and share their sub-minors: {shared} at most, of which {used} remain as steps here "
            "because the rest are zero, or equal to an entry or to one another."
        )
    ]
    if zero:
        blocks.append(Points((f"{len(zero)} of the {count} minors are zero in every configuration.",)))
    blocks.append(step_list(program, "Named steps from joint angles to the minors"))
    return blocks, {"minors": count, "zero_minors": len(zero), "submatrices": shared, "steps": len(program.steps)}


def plural_minors(count: int) -> str:
    """``one maximal minor, its determinant`` or ``7 maximal minors``."""
    return "one maximal minor, its determinant" if count == 1 else f"{count} maximal minors"


def _build(arm: Arm, context: Context) -> Part:
    context.progress("typesetting the minors")
    task = context.task
    assert task is not None
    model, rows = arm.description.model, arm.tasks[task]
    blocks: list[Block] = [
        Prose(
            f"The manipulability H of the {task} task measures how far the Jacobian is from losing rank. It "
            "is the root of the sum of the squares of its maximal minors (Cauchy–Binet), and zero exactly where all "
            "of them vanish:"
        ),
        _definition(),
    ]
    data: dict[str, object] = {"minors": math.comb(arm.n, rows)}
    if model.name == "planar_rrr" and task == "position":
        blocks += _planar_3r(arm)
    elif model.family == "orthogonal_3r" and task == "position":
        blocks += _orthogonal(arm)
    else:
        general, data = _general(arm, task)
        blocks += general
    size = unit(arm, task)
    if size.mixed:
        blocks.append(
            Prose(
                f"Units: with revolute and prismatic joints together, H adds terms in {size.text}, so its value "
                "depends on the unit of length (metres here). Its zeros do not."
            )
        )
    else:
        blocks.append(Prose(f"H is in {size.text}." if size.text != "1" else "H is a pure number."))
    return Part(tuple(blocks), data | {"unit": size.text})


SECTION = Section("minors", "Minors and manipulability", lambda arm: bool(arm.full_rank_tasks), _build)
