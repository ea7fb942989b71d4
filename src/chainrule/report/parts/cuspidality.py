"""Whether a 3R arm, or the positioning part of a six-joint arm, can change its posture without a singularity."""

from __future__ import annotations

from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.cuspidality import tables
from chainrule.cuspidality.designs import Orthogonal3R, regional_3r
from chainrule.cuspidality.wrists import wrist
from chainrule.plot.cuspidality import draw_design
from chainrule.plot.design_space import draw_domains
from chainrule.plot.style import svg
from chainrule.report.content import Block, Finding, Grid, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section


def _applies(arm: Arm) -> bool:
    """Three revolute joints in space, or six."""
    return "x_alpha" not in arm.tasks and arm.kinds in ("RRR", "RRRRRR")


def _build(arm: Arm, context: Context) -> Part:
    if arm.n == 6 and not wrist(arm).spherical:
        text = (
            f"{wrist(arm).words}. Whether the arm is cuspidal is then not decided by its first three joints; "
            f"chainrule classify {arm.name} searches for a change of posture without a singularity."
        )
        return Part((Finding(text),), {"wrist": wrist(arm).to_dict()})
    context.progress("looking for cusps, nodes and aspects")
    design = regional_3r(arm)
    change = design.posture_change() if design.cuspidal else None
    blocks: list[Block] = [Finding(tables.verdict(design), tone="bad" if design.cuspidal else "good")]
    blocks += [Prose(line) for line in design.words()]
    if arm.n == 6:
        blocks.append(Prose(f"{wrist(arm).words}. What follows is about its centre and the first three joints."))
    description = (
        "Two panels: the curves of singularities over joints 2 and 3 with the aspects between them, and their images "
        "in the half plane of distance from axis 1 and height, shaded by how many postures reach a point."
    )
    drawn = svg(draw_design(design, change), "cuspidality", tables.verdict(design), description)
    caption = (
        "Left, the joint space: joints 2 and 3, with the singular curves and the aspects that they bound. Right, the "
        "cross-section of the workspace: the images of the same curves, where postures appear or vanish in pairs."
    )
    if change is not None:
        caption += " The red way changes the posture without crossing a singular curve; its image runs round a cusp."
        blocks.append(Prose(tables.change_in_words(change)))
    blocks.append(Picture(Markup(drawn), caption))
    if len(design.cusps()) or len(design.nodes()):
        blocks.append(Grid(tables.points_table(design)))
    blocks.append(Grid(tables.aspects_table(design)))
    if isinstance(design, Orthogonal3R) and not design.nongeneric:
        space = draw_domains(design.regional.orthogonal)
        description = "Sections of the design space with its five domains, the larger one with this design marked."
        title = "The design space of the orthogonal 3R arms"
        blocks.append(
            Picture(
                Markup(svg(space, "domains", title, description)),
                "The family's designs by the number of cusps (Baili, Wenger and Chablat); the numbers name the "
                "domains, the red mark is this arm.",
            )
        )
    data = design.to_dict() | {"posture_change": None if change is None else change.to_dict()}
    return Part(tuple(blocks), data)


SECTION = Section("cuspidality", "Changes of posture", _applies, _build)
