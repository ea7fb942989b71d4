"""How far the tip gets."""

from __future__ import annotations

import math

from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.plot.style import svg
from chainrule.plot.workspace import draw_workspace
from chainrule.reach import Reach
from chainrule.report.content import Block, Details, Finding, Grid, Part, Picture, Points, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import posture, readable
from chainrule.workspaces import Workspace, boundary_table, findings, rings_table, workspace


def _exact(arm: Arm, found: Workspace) -> list[Block]:
    """The exact workspaces of a planar arm: how large, why the boundary is where it is, and a figure."""
    first, second = findings(found)[:2]
    about = (
        "The arm's first moving joint is at the base and turns freely, so the sets are rings about the base, and their "
        "radii are exact."
        if found.symmetric
        else "The joint limits make the reachable set a region bounded by arcs and straight segments. They, and the "
        "area, are in closed form: along each edge one joint moves, and every other one is at a limit or in line "
        "with the axes of the joints that are free."
    )
    blocks: list[Block] = [Finding(f"{first} {second}."), Prose(about)]
    if found.primary or found.secondary:
        blocks.append(Grid(rings_table(found)))
    picture = svg(draw_workspace(arm, found), "workspace", f"The workspace of {arm.name}", f"{first} {second}.")
    caption = "Light: every point the tip reaches within the joint limits. Darker: reached with every orientation."
    if not found.exact:
        caption += " The darker outline has no closed form; its corners were found by bisection to 1e-9 of the size."
    blocks.append(Picture(Markup(picture), caption))
    if not found.symmetric:
        blocks.append(Details("The boundary, piece by piece", (Grid(boundary_table(found)),)))
    return blocks


def _bounded(arm: Arm) -> Workspace | None:
    """The exact workspace, of a planar arm that has one."""
    try:
        return workspace(arm)
    except InputError:
        return None


def _build(arm: Arm, context: Context) -> Part:
    found = context.reach
    blocks: list[Block] = []
    context.progress("working out the exact workspace")
    exact = _bounded(arm)
    limited = any(joint.position is not None for joint in arm.description.joints)
    if exact is not None:
        blocks += _exact(arm, exact)
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
    if math.isfinite(found.bound) and exact is None:
        blocks.append(
            Prose(
                "The bound is certain: it is the length of a chain of points, one on each joint's axis, whose "
                "distances the joints cannot change. Distances are from the origin of the base frame to the tip."
            )
        )
    data = found.to_dict() | ({} if exact is None else {"workspace": exact.to_dict()})
    return Part(tuple(blocks), data, headlines=_headlines(arm, found, exact))


def _headlines(arm: Arm, found: Reach, exact: Workspace | None) -> tuple[str, ...]:
    """The section in one sentence, for the summary."""
    if exact is not None:
        first, second = findings(exact)[:2]
        return (f"{first} {second}.",)
    if not math.isfinite(found.bound):
        return ()
    nearest = found.nearest.value
    from_ = "the base's origin itself" if nearest <= 1e-9 else f"{readable(nearest, 3)} m"
    return (f"Its tip gets from {from_} to {readable(found.farthest.value, 4)} m away from the base.",)


SECTION = Section("reach", "Reach", lambda arm: True, _build)
