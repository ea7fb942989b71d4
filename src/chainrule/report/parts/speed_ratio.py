"""Which curvatures the tip of a planar arm with one joint to spare can follow, in every direction."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.plot.speed_ratio import around, around_finding, draw_reachable
from chainrule.plot.style import svg
from chainrule.report.content import Block, Finding, Grid, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.speed_ratio import SpeedRatios, Status, speed_ratios
from chainrule.tables import Column, Table, posture, readable


def _end(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def directions_table(found: SpeedRatios, angles: NDArray[Any]) -> Table:
    """What each direction reaches; an open end is an empty cell."""
    rows = tuple(
        (f"{math.degrees(angle):.0f}°", _end(low), _end(high), float(middle))
        for angle, (low, high), middle in zip(angles, found.reachable, found.pseudoinverse_curvature, strict=True)
    )
    columns = (
        Column("direction", "direction of motion"),
        Column("from", "curvature from", "1/m"),
        Column("to", "to", "1/m"),
        Column("pseudoinverse", "with the pseudoinverse", "1/m"),
    )
    return Table(
        "Curvatures that constant joint rates follow (an open end: any; left turns are positive)", columns, rows
    )


def _outward(arm: Arm, q: NDArray[Any]) -> list[Block]:
    """The parabola in one direction: straight away from the base."""
    tip = np.asarray(arm.position(q))
    if not np.linalg.norm(tip) > 0.0:
        return []
    found = speed_ratios(arm, q, tip, 0.0)
    p2, p1, p0 = (float(p) for p in found.parabola)
    signs = ["+" if p >= 0.0 else "−" for p in (p1, p0)]
    text = f"κ = {readable(p2, 4)} z² {signs[0]} {readable(abs(p1), 4)} z {signs[1]} {readable(abs(p0), 4)}"
    return [
        Prose(
            f"Straight away from the base, for example, the tip's path has the curvature {text} (in 1/m), where z is "
            f"how much self-motion is added to the pseudoinverse's rates at a tip speed of 1 m/s. {found.reason}"
        )
    ]


def _build(arm: Arm, context: Context) -> Part:
    q = context.posture
    if speed_ratios(arm, q, [1.0, 0.0], 0.0).status is Status.SINGULAR:
        text = "The posture that the arm is drawn in is singular, so there is no spare motion to speak of here."
        return Part((Finding(text),), {"singular": True})
    line = around_finding(around(arm, q)[1])
    angles = np.radians(np.arange(0, 180, 30))
    _, found = around(arm, q, angles)
    description = (
        "A disc of path curvatures: the side a path bends to and how tightly, shaded where it can be followed."
    )
    drawn = svg(draw_reachable(arm, q), "ratios", "Curvatures that constant joint rates follow", description)
    blocks: tuple[Block, ...] = (
        Finding(f"{line}, in the posture of the drawing."),
        Prose(
            "With the joints' rates in constant ratio, the tip leaves along a tangent on a path whose curvature the "
            "spare joint decides (Ambike, Schmiedeler and Stanišić): it is a parabola in the self-motion, so that "
            "everything on one side of one curvature can be followed to second order, and nothing on the other."
        ),
        Picture(
            Markup(drawn),
            f"At {posture(arm, q)}. The centre is a straight path, the rim turning on the spot; a path bends to the "
            "side where its point lies, and its tangent lies across. The dotted line is what the pseudoinverse's rates "
            "do.",
        ),
        Grid(directions_table(found, angles), digits=4),
        *_outward(arm, q),
    )
    data = {
        "q": [float(value) for value in q],
        "finding": line,
        "directions_deg": np.degrees(angles).tolist(),
        "reachable": [[_end(low), _end(high)] for low, high in found.reachable],
        "pseudoinverse": found.pseudoinverse_curvature.tolist(),
    }
    return Part(blocks, data, headlines=(f"With its joints at constant rates, {line[0].lower()}{line[1:]}.",))


SECTION = Section(
    "speed_ratio", "Curvature at constant joint rates", lambda arm: "x_alpha" in arm.tasks and arm.n == 3, _build
)
