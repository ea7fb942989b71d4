"""What was generated, and how many operations each function takes."""

from __future__ import annotations

from chainrule.arm import Arm
from chainrule.report.content import Grid, Part, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import readable


def _build(arm: Arm, context: Context) -> Part:
    table = context.functions
    total = sum(row[3] for row in table.rows if isinstance(row[3], int))
    model = arm.description.model
    lead = (
        f"{len(table.rows)} functions of the {arm.n} joint variables, {readable(total)} operations in all for one "
        "configuration, a sine or cosine counted as one. Each takes single configurations and batches, in "
        "double and single precision."
    )
    if model.parameters:
        lead += (
            f" They belong to the family {model.name} and also take its parameters "
            f"({', '.join(model.parameter_names)}), so other lengths need no new code."
        )
    return Part((Prose(lead), Grid(table)), {"functions": table.to_dict(), "operations": total})


SECTION = Section("generated", "What was generated", lambda arm: True, _build)
