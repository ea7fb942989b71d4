"""A circle followed at constant joint rates: how many feedback updates each choice of the rates needs."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.following import Followed, follow
from chainrule.paths import Circle
from chainrule.plot.following import NAMES, draw_following
from chainrule.plot.style import svg
from chainrule.report.content import Block, Finding, Grid, Part, Picture, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.stretches import METHODS
from chainrule.tables import Column, Table, readable

#: The circle's radius and the tolerance, as shares of the largest distance of the tip from the base.
RADIUS, TOLERANCE = 0.15, 0.002


def _circle(arm: Arm, context: Context) -> Circle | None:
    """The circle through the tip of the drawing's posture whose centre lies towards the base."""
    tip = np.asarray(arm.position(context.posture))
    distance = float(np.hypot(*tip))
    radius = RADIUS * distance
    if not radius > 0.0:
        return None
    return Circle((tip * (1.0 - radius / distance)).tolist(), radius, start=float(np.arctan2(tip[1], tip[0])))


def _table(runs: list[Followed]) -> Table:
    columns = (
        Column("method", "choice of the rates"),
        Column("updates", "feedback updates"),
        Column("followed", "followed", "m"),
        Column("status", "status"),
    )
    rows = tuple((NAMES[run.method], run.updates, run.followed, run.status) for run in runs)
    return Table("Feedback updates on the circle", columns, rows)


def _build(arm: Arm, context: Context) -> Part:
    path = _circle(arm, context)
    if path is None:
        return Part((Finding("The drawing's posture has its tip at the base: there is no circle to follow."),))
    context.progress("following a circle")
    tolerance = TOLERANCE * float(np.hypot(*np.asarray(arm.position(context.posture))))
    runs = [follow(arm, path, tolerance, method=method, q=context.posture) for method in METHODS]
    done = [run for run in runs if run.status == "finished"]
    text = "No choice of the rates gets all the way round."
    if done:
        best = min(done, key=lambda run: run.updates)
        text = f"{NAMES[best.method].capitalize()} needs {best.updates} feedback updates on a circle"
        plain = runs[METHODS.index("pseudoinverse")]
        text += f", the pseudoinverse {plain.updates}." if plain in done and plain is not best else "."
    drawn = svg(
        draw_following(arm, path, runs),
        "following",
        "A circle followed at constant joint rates",
        "The circle with the places of the updates, and the tip's offset along it for each choice of the rates.",
    )
    blocks: tuple[Block, ...] = (
        Finding(text),
        Prose(
            "The joints move at constant rates until the tip is the tolerance "
            f"({readable(1000.0 * tolerance, 3)} mm) away from a circle of radius {readable(path.radius, 3)} m, and "
            "are then brought back to the nearest point. The speed ratio matches the circle's curvature or comes as "
            "near as possible (Ambike, Schmiedeler and Stanišić); the two-term rule weighs the next error too; looking "
            "ahead tries the candidates of all of them, stretch by stretch, so it may still need more in the end."
        ),
        Picture(Markup(drawn), "Large dots: updates with the pseudoinverse; small ones: looking ahead."),
        Grid(_table(runs)),
    )
    return Part(
        blocks,
        {"path": path.to_dict(), "tolerance": tolerance, "runs": [_facts(run) for run in runs]},
        headlines=(_headline(runs),),
    )


def _headline(runs: list[Followed]) -> str:
    """The section in one sentence, for the summary."""
    done = {run.method: run.updates for run in runs if run.status == "finished"}
    if not done:
        return "On the circle tried, no choice of constant joint rates gets all the way round."
    best = min(done, key=lambda method: done[method])
    way = NAMES[best] if best == "look_ahead" else f"the {NAMES[best]}"
    text = f"Following a circle at constant joint rates takes {done[best]} feedback updates with {way}"
    return text + (f", {done['pseudoinverse']} with the pseudoinverse." if "pseudoinverse" in done else ".")


def _facts(run: Followed) -> dict[str, object]:
    return {"method": run.method, "updates": run.updates, "followed": run.followed, "status": run.status}


def _applies(arm: Arm) -> bool:
    return isinstance(arm.description.geometry, Planar) and arm.n == 3


SECTION = Section("following", "Following a path", _applies, _build)
