"""How far the tip gets."""

from __future__ import annotations

import math

from chainrule.arm import Arm
from chainrule.report.content import Block, Finding, Grid, Part, Points, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import Column, Table, posture, readable
from chainrule.workspaces import workspace


def _rings(arm: Arm) -> list[Block]:
    exact = workspace(arm)
    rows = [("reached", *ring) for ring in exact.primary] + [
        ("reached with every orientation", *r) for r in exact.secondary
    ]
    if not exact.secondary:
        rows.append(("reached with every orientation: nowhere", None, None))  # type: ignore[arg-type]
    table = Table(
        "Rings about the base, joints without limits",
        (Column("set", "points"), Column("inner", "inner radius", "m"), Column("outer", "outer radius", "m")),
        tuple(rows),
    )
    return [
        Prose(
            "For a planar chain of revolute joints the workspace is a ring, and its radii are exact: the sum "
            "of the link lengths outside; inside, by how much the longest link exceeds all the others together, or "
            "zero."
        ),
        Grid(table),
    ]


def _build(arm: Arm, context: Context) -> Part:
    found = context.reach
    blocks: list[Block] = []
    planar_turning = "x_alpha" in arm.tasks and "P" not in arm.kinds
    limited = any(joint.position is not None for joint in arm.description.joints)
    if planar_turning:
        blocks += _rings(arm)
    at = posture(arm, found.farthest.q)
    inside = " within the joint limits" if limited else ""
    if not math.isfinite(found.bound):
        blocks.append(Finding("A prismatic joint has no limits, so the reach has none either."))
    elif found.farthest.value >= found.bound * (1.0 - 1e-9):
        blocks.append(
            Finding(
                f"The tip reaches exactly {readable(found.farthest.value, 7)} m from the base{inside}: a posture "
                "attains the bound that no posture can exceed."
            )
        )
    else:
        blocks.append(
            Finding(
                f"The tip reaches {readable(found.farthest.value, 6)} m from the base{inside}, and cannot exceed "
                f"{readable(found.bound, 6)} m."
            )
        )
    height = "y" if "x_alpha" in arm.tasks else "z"
    items = [
        f"Farthest, found by search{inside}: {readable(found.farthest.value, 7)} m, at {at}.",
        f"Nearest, found by search{inside}: {readable(found.nearest.value, 4) if found.nearest.value > 1e-9 else '0'} m"
        + (" (the tip reaches the base's origin)." if found.nearest.value <= 1e-9 else "."),
        f"Heights {height} met by 20 000 random configurations: {readable(found.lowest, 4)} to "
        f"{readable(found.highest, 4)} m.",
    ]
    blocks.append(Points(tuple(items)))
    if math.isfinite(found.bound) and not planar_turning:
        blocks.append(
            Prose(
                "The bound is certain: it is the length of a chain of points, one on each joint's axis, whose "
                "distances the joints cannot change. Distances are from the origin of the base frame to the tip."
            )
        )
    return Part(tuple(blocks), found.to_dict())


SECTION = Section("reach", "Reach", lambda arm: True, _build)
