"""The self-motion at the tip of the posture drawn: for arms with one joint more than their task has rows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.manipulability import unit
from chainrule.plot.self_motion import draw_lengths, draw_self_motion
from chainrule.plot.style import svg
from chainrule.report.content import Block, Details, Finding, Grid, Motion, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.motion import FRAMES, Track, motion
from chainrule.report.parts.summary import count_word
from chainrule.report.sections import Section
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.held import target_of
from chainrule.self_motions.result import SelfMotion
from chainrule.self_motions.words import arcs_table, completeness, curves_table, finding, limits_finding
from chainrule.tables import posture, readable

Array = NDArray[Any]

#: Points of each curve among the section's numbers for machines.
POINTS = 37


def _applies(arm: Arm) -> bool:
    task = Context(arm).task
    return task is not None and arm.n - arm.tasks[task] == 1


def _failures(arm: Arm, found: SelfMotion) -> str:
    """Which joints may stop anywhere in their range without the target being lost."""
    if not found.components or found.status != "regular":
        return ""
    free = [j for j in range(1, arm.n + 1) if any(curve.turns_freely(j) for curve in found.components)]
    if not free:
        return "No joint turns all the way round on a curve."
    names = ", ".join(f"q{j}" for j in free)
    return f"{names} {'turns' if len(free) == 1 else 'turn'} all the way round on some curve."


def _figures(arm: Arm, found: SelfMotion) -> list[Block]:
    whole = finding(found)
    drawn = svg(draw_self_motion(arm, found), "selfmotion", f"The self-motion of {arm.name}", f"{whole}.")
    caption = (
        "Left: the arm in postures that all hold the target, coloured by the manipulability H. Right: the same in "
    )
    caption += "joint space." if arm.n > 3 else "joint space, all curves."
    blocks: list[Block] = [Picture(Markup(drawn), caption)]
    if arm.kinds == "RRR" and "x_alpha" in arm.tasks and found.task == "position":
        lengths = svg(
            draw_lengths(arm),
            "selfmotionlengths",
            "Lengths of the self-motion",
            "The length of the self-motion over the distance of the target, with the borders between regions.",
        )
        caption = (
            "How long the self-motion is, over the distance px of the target from the base. At a border curves meet, "
            "and the total has a cusp like a square root."
        )
        blocks.append(Picture(Markup(lengths), caption))
    return blocks


def _build(arm: Arm, context: Context) -> Part:
    task, q = context.task, context.posture
    assert task is not None  # it applies
    context.progress("finding the self-motions")
    found = self_motion(arm, target_of(arm, q, task), task, limits=True, points=POINTS)
    blocks: list[Block] = [Finding(f"{finding(found)}. {completeness(found)}")]
    left = limits_finding(found)
    if left:
        blocks.append(Finding(f"{left}."))
    blocks.append(
        Prose(
            f"The target is what the tip does in the posture of the drawing ({posture(arm, q)}). The arm has one joint "
            f"more than the task '{task}' needs, so the postures that hold it form curves in joint space; a length is "
            "measured there, in rad"
            + (", a metre of a slide as one radian. " if "P" in arm.kinds else ". ")
            + _failures(arm, found)
        )
    )
    if found.status == "regular":
        blocks.append(_motion(arm, found))
    blocks += _figures(arm, found)
    blocks.append(Grid(curves_table(arm, found), digits=5))
    if found.feasible:
        grid = Grid(arcs_table(arm, found), digits=5)
        blocks.append(
            grid if len(found.feasible) <= 8 else Details("What the joint limits leave, part by part", (grid,))
        )
    return Part(tuple(blocks), _numbers(found), headlines=(_headline(found),))


def _headline(found: SelfMotion) -> str:
    """The section in one sentence, for the summary."""
    if found.status != "regular":
        return f"At the tip of the posture drawn, self-motion: {finding(found)}."
    curves = f"{count_word(found.count)} self-motion curve{'' if found.count == 1 else 's'}"
    start = f"Holding its tip where the drawing has it, the arm can move along {curves}"
    start += ", and cannot pass from one to another" if found.count > 1 else ""
    left = limits_finding(found)
    return f"{start}. {left}." if left else f"{start}."


def _motion(arm: Arm, found: SelfMotion) -> Motion:
    """The arm along each curve, for a slider."""
    s = np.linspace(0.0, 1.0, FRAMES)
    tracks = []
    for k, curve in enumerate(found.components):
        q = curve.at(s) if len(curve.q) > 1 else np.repeat(curve.q[:1], FRAMES, axis=0)
        inside = None if found.feasible is None else _allowed(arm, q)
        values = np.asarray(arm.manipulability(q, task=found.task))
        turned = np.where([kind == "R" for kind in arm.kinds], np.pi - np.remainder(np.pi - q, 2.0 * np.pi), q)
        name = f"{k + 1} of {found.count}, {readable(curve.length, 4)} rad"
        start = int(np.argmax(values if inside is None or not inside.any() else np.where(inside, values, -1.0)))
        tracks.append(Track(name, turned, values, inside, start))
    size = unit(arm, found.task)
    limited = "; thick where it is within the joint limits" if found.feasible is not None else ""
    return motion(
        arm,
        "selfmotionslider",
        tracks,
        label="Along the curve",
        chart="manipulability",
        symbol="H",
        unit="" if size.mixed or size.text == "1" else size.text,
        title=f"{arm.name} moving without moving its tip",
        caption=f"The arm along its self-motion: the tip stays, H changes{limited}.",
    )


def _allowed(arm: Arm, q: Array) -> NDArray[np.bool_]:
    """(k,) whether postures (k, n) are within the joint limits, revolute joints up to whole turns."""
    low, high = arm.limits.position.T
    turning = np.array([kind == "R" for kind in arm.kinds]) & np.isfinite(low)
    start = np.where(turning, low, 0.0)
    moved = np.where(turning, start + np.remainder(q - start + 1e-9, 2.0 * np.pi) - 1e-9, q)
    inside: NDArray[np.bool_] = ((moved >= low - 1e-9) & (moved <= high + 1e-9)).all(axis=1)
    return inside


def _numbers(found: SelfMotion) -> dict[str, Any]:
    """The section's numbers, without the curves' points."""
    whole = found.to_dict()
    for part in [*whole["components"], *(whole["feasible"] or [])]:
        del part["q"]
    lengths = [curve.length for curve in found.components]
    assert all(math.isfinite(length) for length in lengths)
    return whole


SECTION = Section("self_motion", "Self-motion", _applies, _build)
