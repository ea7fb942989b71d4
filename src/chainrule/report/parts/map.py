"""The manipulability map over two joints, with its maximum."""

from __future__ import annotations

from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.manipulability import unit
from chainrule.plot import draw_map
from chainrule.plot.maps import finding
from chainrule.plot.style import svg
from chainrule.report.content import Finding, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import posture


def _build(arm: Arm, context: Context) -> Part:
    if not context.depends_on:
        size = unit(arm, context.task)
        text = (
            f"H is the same in every configuration: {context.maximum.value:.6g}{size.suffix}. There is nothing to map."
        )
        return Part((Finding(text),), {"maximum": {"H": context.maximum.value}})
    found = context.map
    i, j = found.joints
    others = [k for k in context.depends_on if k not in found.joints]
    idle = [k for k in range(arm.n) if k not in context.depends_on]
    line = finding(arm, found)
    again = ""
    if len(found.maximum.others) == 1:
        again = " The same value is reached once more, at " + posture(arm, found.maximum.others[0], (i, j)) + "."
    elif len(found.maximum.others) > 1:
        again = f" The same value is reached at {len(found.maximum.others)} further points of the map."
    if others:
        held = posture(arm, found.q, others)
        scope = (
            f"Of all pairs of joints, H varies most over q{i + 1} and q{j + 1}. The others are held where the "
            f"largest H of all was found: {held}. The maximum is this map's: a grid, then refined with the gradient "
            "of H."
        )
    else:
        scope = (
            "H depends on no other joint, so this map shows all there is; its maximum, found on a grid and "
            "refined with the gradient of H, is the largest H the arm has inside the ranges shown."
        )
    if idle:
        scope += f" H does not depend on {', '.join(f'q{k + 1}' for k in idle)}."
    description = f"Filled contour map of H over q{i + 1} (horizontal) and q{j + 1} (vertical). {line}."
    text = svg(draw_map(arm, found), "map", f"Manipulability over q{i + 1} and q{j + 1}", description)
    return Part(
        (
            Picture(Markup(text), f"Lighter is larger; the rings mark the maximum.{again} {scope}"),
            Prose(
                f"Each point of H inside the joint limits was computed by the generated function "
                f"manipulability_{found.task}: {found.H.size:,} of them.".replace(",", "\u202f")
            ),
        ),
        found.to_dict(),
    )


SECTION = Section("map", "Manipulability map", lambda arm: bool(arm.full_rank_tasks) and arm.n >= 2, _build)
