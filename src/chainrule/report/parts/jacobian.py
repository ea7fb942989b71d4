"""The Jacobian: in closed form where it can be read, else by its columns and named steps."""

from __future__ import annotations

from typing import Any

from chainrule.arm import Arm
from chainrule.derive import catalogue
from chainrule.derive.program import closed_form, needed
from chainrule.report import mathml
from chainrule.report.content import Block, Formula, Part, Prose
from chainrule.report.context import Context
from chainrule.report.parts.steps import step_list
from chainrule.report.sections import Section

#: Families whose Jacobian is written out entry by entry, up to this many joints.
MOST_WRITTEN = 4


def simplified(entry: Any) -> Any:
    """A trigonometric polynomial in its shortest known form."""
    import sympy as sp

    short = min((sp.trigsimp(entry), sp.simplify(entry)), key=lambda e: int(sp.count_ops(e)))
    return sp.collect(short, [s for s in short.free_symbols if not str(s).startswith("q")]) if short.is_Add else short


def _written(arm: Arm, task: str) -> Formula:
    """The Jacobian entry by entry, for a family with symbolic lengths."""
    model = arm.description.model
    family = catalogue.FAMILIES[model.family][0]
    program = family.jacobian(catalogue.symbolic(model), task)
    rows, columns = program.outputs[0].shape
    entries = [simplified(e) for e in closed_form(program)["jacobian"]]
    table = [entries[r * columns : (r + 1) * columns] for r in range(rows)]
    return Formula(mathml.equation(mathml.bold("J"), mathml.matrix(table)))


def _columns(arm: Arm, task: str) -> list[Block]:
    """The Jacobian of a spatial chain by its columns."""
    m = mathml
    z, moment = (
        m.bold("z", "i"),
        m.row(m.operator("("), m.bold("p", "e"), m.operator("−"), m.bold("p", "i"), m.operator(")")),
    )
    turning = [m.row(z, m.operator("×"), moment), z]
    sliding = [z, "<mn>0</mn>"]
    rows = 2 if task == "pose" else 1

    def column(parts: list[str]) -> str:
        cells = "".join(f"<mtr><mtd>{part}</mtd></mtr>" for part in parts[:rows])
        return m.row(m.operator("["), f"<mtable>{cells}</mtable>", m.operator("]"))

    blocks: list[Block] = []
    for kind, word, parts in (("R", "revolute", turning), ("P", "prismatic", sliding)):
        if kind in arm.kinds:
            blocks.append(Formula(m.equation(m.bold("J", "i"), column(parts)), f"Column of a {word} joint i:"))
    return blocks


def _build(arm: Arm, context: Context) -> Part:
    context.progress("typesetting the Jacobian")
    task = context.task or arm.default_task
    model = arm.description.model
    family = catalogue.FAMILIES[model.family][0]
    program = needed(family.jacobian(catalogue.symbolic(model), task))
    rows = arm.tasks[task]
    blocks: list[Block] = []
    if model.family != "serial" and arm.n <= MOST_WRITTEN:
        blocks += [
            Prose(
                f"The {rows} × {arm.n} Jacobian of the {task}, in the base frame, simplified by SymPy. "
                "Shorthand: s₁ = sin q₁, c₁₂ = cos(q₁ + q₂), and so on."
            ),
            _written(arm, task),
        ]
    else:
        blocks.append(
            Prose(
                f"The {rows} × {arm.n} Jacobian of the {task}, in the base frame. "
                + ("Rows are the linear, then the angular velocity of the tip. " if task == "pose" else "")
                + ("zᵢ is the axis of joint i, pᵢ a point on it, pₑ the tip." if model.family == "serial" else "")
            )
        )
        if model.family == "serial":
            blocks += _columns(arm, task)
            blocks.append(
                Prose(
                    "The axes and points follow from the description, step by step. Shorthand: sᵢ = sin qᵢ, "
                    "cᵢ = cos qᵢ; x, y, z are the columns of a frame's rotation and p its origin; decimals are "
                    "the description's numbers, taken exactly."
                )
            )
    blocks.append(step_list(program, "Named steps from joint angles to the Jacobian"))
    return Part(tuple(blocks), {"task": task, "rows": rows, "steps": len(program.steps)})


SECTION = Section("jacobian", "Jacobian", lambda arm: True, _build)
