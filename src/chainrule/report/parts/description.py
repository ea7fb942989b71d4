"""What the arm was described by: geometry, limits, tool, source."""

from __future__ import annotations

from chainrule.arm import Arm
from chainrule.report.content import Block, Grid, Part, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.search import assumed
from chainrule.tables import geometry, joints, printable, tasks, tool


def _build(arm: Arm, context: Context) -> Part:
    description = arm.description
    tables = geometry(description)
    blocks: list[Block] = [Grid(table) for table in tables]
    hand = tool(description)
    if hand is not None:
        blocks.append(Grid(hand))
    blocks.append(Grid(joints(arm)))
    if assumed(arm):
        blocks.append(Prose(f"On this page, {assumed(arm)}."))
    blocks.append(Grid(tasks(arm)))
    source = printable(description.source)
    blocks.append(Prose(f"Source: {source}." if source else "No source of these numbers is given."))
    return Part(
        tuple(blocks),
        {"geometry": [t.to_dict() for t in tables], "joints": joints(arm).to_dict(), "source": description.source},
    )


SECTION = Section("description", "Description", lambda arm: True, _build)
