"""Whether a 3R arm, or the positioning part of a six-joint arm, can change its posture without a singularity."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.cuspidality import tables
from chainrule.cuspidality.designs import Orthogonal3R, Regional3R, regional_3r
from chainrule.cuspidality.posture_change import PostureChange
from chainrule.cuspidality.witness import Witness, posture_change_witness
from chainrule.cuspidality.wrists import wrist
from chainrule.plot.cuspidality import draw_design
from chainrule.plot.design_space import draw_domains
from chainrule.plot.style import svg
from chainrule.report.content import Block, Finding, Grid, Motion, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.motion import FRAMES, Track, motion
from chainrule.report.sections import Section
from chainrule.tables import readable

#: Poses at which a six-joint arm without a spherical wrist is searched.
TRIES = 40


def _applies(arm: Arm) -> bool:
    """Three revolute joints in space, or six."""
    return "x_alpha" not in arm.tasks and arm.kinds in ("RRR", "RRRRRR")


def _build(arm: Arm, context: Context) -> Part:
    if arm.n == 6 and not wrist(arm).spherical:
        return _searched(arm, context)
    context.progress("looking for cusps, nodes and aspects")
    design = regional_3r(arm)
    example = design.example() if design.cuspidal else None
    change = None if example is None else design.posture_change(*example.postures)
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
    if change is not None and change.path is not None:
        blocks.append(_motion(design.arm, change))
    if change is not None:
        caption += " The red way changes the posture without crossing a singular curve; its image runs round a cusp."
        blocks.append(Prose(tables.change_in_words(change)))
    elif design.cuspidal:
        blocks.append(Prose(tables.NO_EXAMPLE))
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
    return Part(tuple(blocks), data, headlines=(_headline(arm, design),))


def _headline(arm: Arm, design: Regional3R) -> str:
    """The section in one sentence, for the summary."""
    which = "This arm" if arm.n == 3 else "The positioning part of this arm (joints 1 to 3)"
    if not design.cuspidal:
        return f"{which} is not cuspidal: every change of posture meets a singularity."
    return (
        f"{which} is cuspidal: it can change its posture without meeting a singularity, round one of "
        f"{len(design.cusps())} cusps; do not tell its posture by the sign of a determinant."
    )


def _searched(arm: Arm, context: Context) -> Part:
    """Six joints whose wrist is not spherical: a change of posture is searched."""
    context.progress("searching for a change of posture without a singularity")
    found = posture_change_witness(arm, tries=TRIES, progress=lambda line: context.progress(line))
    blocks: list[Block] = []
    if found.found:
        headline = (
            "This arm is cuspidal: two inverse solutions of one pose are joined by a proved path without a singularity."
        )
        blocks.append(Finding(headline, tone="bad"))
    else:
        headline = (
            f"Whether this arm is cuspidal is open: no change of posture without a singularity was found in {TRIES} "
            "tries, which proves nothing."
        )
        blocks.append(Finding(headline))
    blocks.append(
        Prose(
            f"In the wrist, {wrist(arm).words}. Whether the arm is cuspidal is then not decided by its first three "
            "joints, and a change of posture was searched: an inverse solution is taken to another one of the same "
            "pose on a path that keeps det J away from zero, by a proof in ball arithmetic."
        )
    )
    if found.found:
        blocks.append(
            Prose(
                f"On the path |det J| stays above {readable(found.smallest_determinant, 3)} m³; its median over the "
                f"joint space is {readable(found.typical_determinant, 3)} m³. The pose has {len(found.solutions)} "
                "inverse solutions that were met."
                if found.solutions is not None
                else ""
            )
        )
        blocks.append(_motion(arm, found))
    return Part(tuple(blocks), {"wrist": wrist(arm).to_dict(), "witness": found.to_dict()}, headlines=(headline,))


def _motion(arm: Arm, change: PostureChange | Witness) -> Motion:
    """The arm along its change of posture, for a slider."""
    q = change.sample(np.linspace(0.0, 1.0, FRAMES))
    task = "position" if arm.n == 3 else "pose"
    determinant = np.linalg.det(np.asarray(arm.jacobian(q, task=task)))
    return motion(
        arm,
        "changeslider",
        [Track("the change of posture", q, determinant)],
        label="From one posture to the other",
        chart="determinant",
        symbol="det J",
        unit="m³",
        title=f"{arm.name} changing its posture without meeting a singularity",
        caption="The change of posture: the tip returns to where it was in another posture, and det J never vanishes.",
    )


SECTION = Section("cuspidality", "Changes of posture", _applies, _build)
