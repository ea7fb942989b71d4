"""The arm drawn."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.plot import draw_arm
from chainrule.plot.style import svg
from chainrule.report.content import Part, Picture
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import posture


def _build(arm: Arm, context: Context) -> Part:
    context.progress("drawing the arm")
    at = posture(arm, context.posture)
    why = "the posture of its largest manipulability" if context.task else "the middle of its ranges"
    planar = "x_alpha" in arm.tasks
    unbounded = any(kind == "P" and not np.isfinite(arm.limits.position[i]).all() for i, kind in enumerate(arm.kinds))
    if planar and not unbounded:
        reading = (
            " Light: every point the tip reaches within the joint limits. Darker, inside dashed lines: points it "
            "reaches with every orientation."
        )
    elif planar:
        reading = ""
    else:
        reading = (
            " Orange strokes lie along the joints' axes and straight lines join their origins, so this is a skeleton, "
            "not the housing; its shadow falls on the floor, whose circles give the distance from the base."
        )
    description = f"Line drawing of the arm {arm.name} with {arm.n} joints, at {at}."
    text = svg(draw_arm(arm, context.posture), "arm", f"The arm {arm.name}", description)
    return Part(
        (Picture(Markup(text), f"{arm.name} in {why}: {at}.{reading}"),),
        {"q": context.posture.tolist()},
    )


SECTION = Section("drawing", "The arm", lambda arm: True, _build)
