"""The manipulability map over two joints, with its maximum."""

from __future__ import annotations

import math

from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.manipulability import ManipulabilityMap, unit
from chainrule.plot.maps import draw_map, draw_optima, finding
from chainrule.plot.style import svg
from chainrule.report.content import Finding, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import capitalised, posture, readable


def _zeros(found: ManipulabilityMap) -> str:
    """The map's marks of singular configurations."""
    if found.minimum.value > 1e-7 * found.maximum.value:
        return ""
    if found.determinant is not None:
        return ", dashed lines are where H is zero"
    return ", crosses where H is zero" if len(found.singular) else ""


def _status(arm: Arm, context: Context) -> Finding:
    """What is known of the largest H of all, and how surely."""
    largest, size = context.maximum, unit(arm, context.task)
    if not math.isfinite(largest.value):
        return Finding(f"{largest.how}.")
    value = f"{largest.value:.10g}{size.suffix}"
    count = len(largest.others)
    where = posture(arm, largest.q) + (f", and at {count} further posture{'s' if count > 1 else ''}" if count else "")
    how = capitalised(largest.how)
    if largest.proved:
        return Finding(
            f"The largest H is {value}, at {where}: proved to be the global maximum. {how}.",
            tone="good",
        )
    limit = (
        f" No H exceeds {readable(largest.bound)}{size.suffix}: that is certain."
        if math.isfinite(largest.bound)
        else ""
    )
    return Finding(
        f"The largest H found is {value}, at {where}; it is not proved to be the global maximum.{limit} {how}."
    )


def _headline(arm: Arm, context: Context) -> str:
    """The section in one sentence, for the summary."""
    largest, size = context.maximum, unit(arm, context.task)
    sure = "proved to be the global maximum" if largest.proved else "the largest that was found"
    where = posture(arm, largest.q, context.depends_on)
    return f"It is farthest from singular at {where}: H = {readable(largest.value, 4)}{size.suffix}, {sure}."


def _build(arm: Arm, context: Context) -> Part:
    if not context.depends_on:
        size = unit(arm, context.task)
        text = (
            f"H is the same in every configuration: {context.maximum.value:.6g}{size.suffix}. There is nothing to map."
        )
        return Part((Finding(text),), {"maximum": context.maximum.to_dict()})
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
        scope = "H depends on no other joint, so this map shows all there is."
    if idle:
        scope += f" H does not depend on {', '.join(f'q{k + 1}' for k in idle)}."
    description = f"Filled contour map of H over q{i + 1} (horizontal) and q{j + 1} (vertical). {line}."
    text = svg(draw_map(arm, found), "map", f"Manipulability over q{i + 1} and q{j + 1}", description)
    optima: tuple[Picture, ...] = ()
    if "x_alpha" in arm.tasks and math.isfinite(context.maximum.value):
        drawn = svg(
            draw_optima(arm, context.maximum),
            "optima",
            "Postures of the largest manipulability",
            f"The arm in {min(4, len(context.maximum.others) + 1)} posture(s), drawn over each other.",
        )
        optima = (Picture(Markup(drawn), "The arm where H is largest; joints that do not matter are mid-range."),)
    return Part(
        (
            Picture(Markup(text), f"Lighter is larger; rings mark the maximum{_zeros(found)}.{again} {scope}"),
            _status(arm, context),
            *optima,
            Prose(
                f"Each point of H inside the joint limits was computed by the generated function "
                f"manipulability_{found.task}: {found.H.size:,} of them.".replace(",", "\u202f")
            ),
        ),
        {**found.to_dict(), "largest": context.maximum.to_dict()},
        headlines=() if not math.isfinite(context.maximum.value) else (_headline(arm, context),),
    )


SECTION = Section("map", "Manipulability map", lambda arm: bool(arm.full_rank_tasks) and arm.n >= 2, _build)
