"""How fast the arm gets from one posture to another."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.plot.style import svg
from chainrule.plot.timing import draw_profiles
from chainrule.profiles import finding, table
from chainrule.report.content import Block, Finding, Grid, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.search import box
from chainrule.tables import posture
from chainrule.timing import min_time


def _applies(arm: Arm) -> bool:
    """Velocity and acceleration limits for every joint, none of them 0."""
    bounds = np.stack([arm.limits.velocity, arm.limits.acceleration])
    return bool((np.isfinite(bounds) & (bounds > 0.0)).all())


def _build(arm: Arm, context: Context) -> Part:
    ranges = box(arm)
    middle, name = ranges.mean(axis=1), "the posture of the largest H"
    start = np.clip(context.posture, ranges[:, 0], ranges[:, 1])
    start = np.where(np.abs(start - middle) < 1e-9, middle, start)
    if np.array_equal(start, middle):  # H is the same everywhere, or has no meaning for this arm
        start, name = ranges[:, 0] + 0.25 * (ranges[:, 1] - ranges[:, 0]), "a quarter into the joints' ranges"
    limits = arm.limits
    move = min_time(start, middle, limits.velocity, limits.acceleration)
    line = min_time(start, middle, limits.velocity, limits.acceleration, synchronise="phase")
    said = finding(move)
    picture = svg(
        draw_profiles(move, arm.kinds),
        "timing",
        "Velocity and acceleration over time",
        f"For each joint its velocity above its acceleration, with the limits as dashed lines. {said}.",
    )
    blocks: tuple[Block, ...] = (
        Finding(f"{said}."),
        Prose(
            f"From rest in {name} ({posture(arm, start)}) to rest in the middle of the joints' ranges "
            f"({posture(arm, middle)}), each joint within its velocity and acceleration limits and as fast as it can; "
            f"torques, and what the arm could collide with, are left aside. On a straight line in joint space, all "
            f"joints in proportion, the same takes {float(line.duration):.4g} s."
        ),
        Picture(
            Markup(picture),
            "Dashed: the limits. Each coloured area is the joint's way. On grey ground the joint is at its goal and "
            "waits for the others.",
        ),
        Grid(table(move, arm.kinds), digits=4),
    )
    return Part(blocks, {"motion": move.to_dict(), "straight_line": float(line.duration)})


SECTION = Section("timing", "Fastest motion", _applies, _build)
