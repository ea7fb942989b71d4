"""``chainrule track``: a path followed by an arm with joints to spare, by one method or by several compared."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Task,
    Tip,
    app,
    configuration,
    load_arm,
    numbers,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)
from chainrule.errors import InputError, shown

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.redundancy.result import Run
    from chainrule.redundancy.task_path import TaskPath

#: Paths known by name, of Sanchez's thesis, and the start posture of each for its own arm.
NAMED = {"sanchez-arc": ("arc", "A"), "sanchez-ellipse": ("ellipse", "E"), "sanchez-line": ("line", "L")}


@app.command()
def track(
    arm: ArmName,
    path: Annotated[
        str | None,
        typer.Option(
            metavar="FILE|NAME",
            help="A .toml file (kind = line, arc, circle, ...), poses in a .csv file, or sanchez-arc, sanchez-ellipse "
            "or sanchez-line.",
        ),
    ] = None,
    circle: Annotated[
        float | None,
        typer.Option(metavar="RADIUS", help="Instead: a circle through the tip of the start posture, radius in m."),
    ] = None,
    line: Annotated[
        str | None,
        typer.Option(metavar="DX,DY[,DZ]", help="Instead: a line from the tip of the start posture, in m."),
    ] = None,
    duration: Annotated[float, typer.Option(help="With --circle and --line: how long it takes, s.")] = 2.0,
    start: Annotated[
        str | None,
        typer.Option(
            metavar="Q|NAME",
            help="The posture to start in; A, B, C, E or L of Sanchez's arm. Found when left out: the best on the "
            "self-motion.",
        ),
    ] = None,
    task: Task = None,
    method: Annotated[str, typer.Option(help="How the spare joints are used.")] = "gradient_projection",
    gain: Annotated[float, typer.Option(help="Gain of the criterion; negative ones lower it.")] = 0.0,
    criterion: Annotated[str, typer.Option(help="H, 1/H, H^(-1/2) or limits.")] = "H^(-1/2)",
    feedback: Annotated[float, typer.Option(help="Feedback on the errors of position and orientation, 1/s.")] = 0.0,
    integrator: Annotated[str, typer.Option(help="euler, heun, rk4 or dop853.")] = "euler",
    dt: Annotated[float, typer.Option(help="Step, s.")] = 0.002,
    limits: Annotated[
        bool, typer.Option("--limits", help="Keep within the arm's limits; the path slows down.")
    ] = False,
    compare: Annotated[bool, typer.Option("--compare", help="Several methods, in one table and one figure.")] = False,
    figure: Annotated[Path | None, typer.Option(metavar="FILE", help="Draw it into a .svg, .png or .pdf file.")] = None,
    csv: Annotated[
        Path | None, typer.Option("--csv", metavar="FILE", help="Every sample: time, joints, rates, torques, errors.")
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Angles given are degrees.")] = False,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Follow a path with an arm that has joints to spare: how near to singularities, how fast, how exactly.

    Exits with 1 if the end of the path is not reached (with --compare: by any method).

    Example: chainrule track sanchez_8r --path sanchez-arc --gain -2 --feedback 10 --figure track.svg
    """
