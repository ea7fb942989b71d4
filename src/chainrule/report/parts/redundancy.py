"""A path followed with the joints to spare: what gradient projection changes, from the posture of the drawing."""

from __future__ import annotations

from typing import Any

import numpy as np
from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.plot.redundancy import draw_runs
from chainrule.plot.style import svg
from chainrule.redundancy.result import Run
from chainrule.redundancy.samples import circle_through
from chainrule.redundancy.track import track
from chainrule.redundancy.words import comparison_table, left_at, masses, rate_unit
from chainrule.report.content import Block, Finding, Grid, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import readable

#: The circle's radius as a share of the tip's distance from the base, how long it takes, s, and the gain on H^(-1/2).
RADIUS, DURATION, GAIN = 0.35, 4.0, -2.0
#: Below this relative change of the least H the gain hardly matters.
HARDLY = 0.01


def _applies(arm: Arm) -> bool:
    task = Context(arm).task
    return task is not None and arm.n > arm.tasks[task]


def _finding(runs: dict[str, Run]) -> str:
    plain, gained = runs.values()
    stopped = [
        f"{name} stops at {readable(float(run.t[-1]), 3)} s" for name, run in runs.items() if run.status != "complete"
    ]
    stopped += [
        f"{name} leaves it at {readable(left, 3)} s"
        for name, run in runs.items()
        if run.status == "complete" and (left := left_at(run)) is not None
    ]
    if stopped:
        return f"The circle is not followed to its end: {', '.join(stopped)}."
    before, after = plain.min_manipulability, gained.min_manipulability
    rates = f"{readable(plain.peak_rate, 3)} to {readable(gained.peak_rate, 3)} {rate_unit(plain.arm)}"
    if abs(after - before) < HARDLY * before:
        return f"On this circle gradient projection hardly matters: H ≥ {readable(after, 3)}, largest rates {rates}."
    word = "raises" if after > before else "lowers"
    return (
        f"On this circle gradient projection {word} the least H from {readable(before, 3)} to {readable(after, 3)}; "
        f"the largest joint rate goes from {rates}."
    )


def _build(arm: Arm, context: Context) -> Part:
    task, q = context.task, context.posture
    assert task is not None  # it applies
    context.progress("following a path with the joints to spare")
    radius = RADIUS * float(np.linalg.norm(arm.position(q)))
    if not radius > 0.0:
        return Part((Finding("The drawing's posture has its tip at the base: there is no circle to follow."),))
    path = circle_through(arm, q, radius, DURATION)
    runs = {
        "pseudoinverse": track(arm, path, q, task=task, method="pseudoinverse"),
        "gradient projection": track(arm, path, q, task=task, gain=GAIN),
    }
    drawn = svg(
        draw_runs(runs, _finding(runs)),
        "redundancy",
        "A path followed with the joints to spare",
        "det J Jᵀ, the fastest joint, and the tip's error over time, with and without gradient projection.",
    )
    spare = arm.n - arm.tasks[task]
    held = "" if task == "position" else " with the tip's orientation held"
    torques = masses(arm)
    blocks: tuple[Block, ...] = (
        Finding(_finding(runs)),
        Prose(
            f"The tip goes round a level circle of radius {readable(radius, 3)} m in {readable(DURATION)} s, from rest "
            f"to rest{held}, beginning in the posture of the drawing. Of all rates that follow it the pseudoinverse "
            f"takes the smallest. Gradient projection adds motion that leaves the tip at rest, of "
            f"{'the joint' if spare == 1 else f'the {spare} joints'} to spare: gain {readable(GAIN)} on H^(-1/2), "
            "which is large near singularities." + (f" Torques rest on {torques}." if torques else "")
        ),
        Picture(Markup(drawn), "The same circle with and without gradient projection."),
        Grid(comparison_table(runs)),
    )
    return Part(blocks, {"path": path.to_dict(), "task": task, "runs": {key: _facts(run) for key, run in runs.items()}})


def _facts(run: Run) -> dict[str, Any]:
    """A run's numbers, without its samples."""
    return {key: value for key, value in run.to_dict().items() if not isinstance(value, list)}


SECTION = Section("redundancy", "Joints to spare", _applies, _build)
