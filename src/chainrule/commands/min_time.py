"""``chainrule min-time``: the fastest joint motion between postures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Tip,
    angle,
    app,
    bounds,
    configuration,
    load_arm,
    numbers,
    print_json,
    print_table,
    say,
    write_figure,
)
from chainrule.errors import InputError
from chainrule.outputs import figure_file

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.goals import FastestMove, Postures


@app.command()
def min_time(
    arm: ArmName,
    start: Annotated[str, typer.Option("--from", help="The joint values at the start, separated by commas or spaces.")],
    to: Annotated[
        list[str] | None, typer.Option("--to", help="Those at the goal; repeat it to choose among several.")
    ] = None,
    pose: Annotated[
        str | None, typer.Option(help="Instead of --to, for planar 3R arms: x, y in m and the last link's angle.")
    ] = None,
    velocity: Annotated[
        str | None,
        typer.Option(help="Largest velocities, one or one for each joint; the arm's own when left out."),
    ] = None,
    acceleration: Annotated[
        str | None, typer.Option(help="Largest accelerations, likewise; the arm's own when left out.")
    ] = None,
    synchronise: Annotated[
        str, typer.Option(help="none; time: joints end together; phase: a straight line in joint space.")
    ] = "none",
    turns: Annotated[
        bool, typer.Option("--turns", help="A goal of --to may be reached at any full turn (--pose always is).")
    ] = False,
    deg: Annotated[bool, typer.Option("--deg", help="Angles given are degrees.")] = False,
    figure: Annotated[
        Path | None, typer.Option(callback=figure_file, help="Draw the profiles into FILE (.svg, .png or .pdf).")
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Find the fastest joint motion from rest to rest under velocity and acceleration limits.

    Exits with 1 if the pose cannot be reached.

    Example: chainrule min-time planar_3r --from 0,0,0 --pose 1.25,0.5,0 --figure profiles.svg
    """
    from chainrule.goals import fastest

    loaded = load_arm(arm, tip, base)
    first = configuration(start, loaded, deg, "--from")
    found: Postures | None = None
    if (pose is None) == (not to):
        raise InputError("one of --to and --pose is needed, not both")
    if pose is not None:
        found = _postures(pose, loaded, deg)
        if not len(found.q):
            _unreachable(found, loaded, as_json)
        goals = found.q
    else:
        import numpy as np

        goals = np.array([configuration(text, loaded, deg, "--to") for text in to or []])
    best = fastest(
        first,
        goals,
        _bounds(velocity, "velocity", loaded, deg),
        _bounds(acceleration, "acceleration", loaded, deg),
        kinds=loaded.kinds if turns or pose is not None else None,
        position=loaded.limits.position,
        synchronise=synchronise,  # type: ignore[arg-type]  # checked there
    )
    if figure is not None:
        from chainrule.plot.timing import draw_profiles

        write_figure(draw_profiles(best.move, loaded.kinds), figure)
    if as_json:
        print_json({"arm": loaded.name, "postures": found.to_dict() if found else None, **best.to_dict()})
    else:
        _print(best, loaded, found)


def _bounds(text: str | None, what: str, arm: Arm, deg: bool) -> Any:
    """The bounds given, or the arm's own where it has one for every joint."""
    import numpy as np

    if text is not None:
        return np.array(bounds(text, arm, deg, f"--{what}"))
    own = getattr(arm.limits, what)
    missing = [name for name, bound in zip(arm.joint_names, own, strict=True) if not np.isfinite(bound)]
    if missing:
        raise InputError(
            f"{arm.name} has no {what} limit for {', '.join(missing)}; --{what} with 1 or {arm.n} numbers gives it"
        )
    return own


def _postures(text: str, arm: Arm, deg: bool) -> Postures:
    from chainrule.goals import postures

    x, y, alpha = numbers(text, "--pose", 3)
    return postures(arm, x, y, angle(alpha, deg, "--pose"))


def _unreachable(found: Postures, arm: Arm, as_json: bool) -> None:
    if as_json:
        print_json({"arm": arm.name, "postures": found.to_dict(), "index": None, "move": None})
    else:
        inner, outer = found.ring
        say(
            f"The pose cannot be reached: the last joint would be {found.wrist:.6g} m from the base, and can be "
            f"between {inner:.6g} and {outer:.6g} m."
        )
    raise typer.Exit(1)


def _print(best: FastestMove, arm: Arm, found: Postures | None) -> None:
    from math import isfinite

    from chainrule.profiles import finding, table
    from chainrule.tables import Column, Table, posture

    say(f"{finding(best.move)}.")
    if found is not None and found.status == "free":
        say("The first joint can have any angle in this pose; the posture with q1 = 0 was taken as the goal.")
    if len(best.durations) > 1:
        rows = tuple(
            (k + 1, posture(arm, goal), float(t) if isfinite(t) else None, "".join(cases), k in best.equally_fast)
            for k, (goal, t, cases) in enumerate(zip(best.moves.goal, best.durations, best.moves.cases, strict=True))
        )
        columns = (
            ("goal", "goal"),
            ("posture", "posture"),
            ("duration", "time", "s"),
            ("cases", "cases"),
            ("fastest", "fastest"),
        )
        print_table(Table("Goals", tuple(Column(*column) for column in columns), rows))
    print_table(table(best.move, arm.kinds))
    for j in (best.either_way[best.index]).nonzero()[0]:
        say(f"Joint {j + 1} could as well turn the other way round: both ways are half a turn.")
