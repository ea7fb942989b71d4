"""Named steps of a derivation as formulas: shared by the sections on the Jacobian and the minors."""

from __future__ import annotations

from typing import Any

from chainrule.report import mathml
from chainrule.report.content import Block, Details, Formulas, Prose

#: More steps than this are not typeset: nobody reads them, and the page stays light.
MOST_STEPS = 400


def step_list(program: Any, summary: str, outputs: bool = True) -> Details:
    """A program's steps, to be opened on demand."""
    shown = program.steps[:MOST_STEPS]
    lines = tuple(mathml.symbol_equation(str(step.symbol), step.expression) for step in shown)
    blocks: list[Block] = [Formulas(lines, summary)]
    if len(program.steps) > len(shown):
        blocks.append(
            Prose(
                f"{len(program.steps) - len(shown)} further steps are left out here; all of them are in the "
                "generated code."
            )
        )
    return Details(f"{summary} ({len(program.steps)})", tuple(blocks))
