"""``chainrule follow``: a path at constant joint-rate ratios, with feedback updates."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Tip,
    angle,
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
from chainrule.errors import InputError
from chainrule.outputs import figure_file

if TYPE_CHECKING:
    from chainrule.following import Followed
    from chainrule.paths import Path as TipPath


@app.command()
def follow(
    arm: ArmName,
    tolerance: Annotated[float, typer.Option(help="Distance from the path, in m, at which the tip is brought back.")],
    path: Annotated[
        Path | None,
        typer.Option(help="A path from a file: .toml (kind = line, arc, circle, ...) or .csv (points x,y)."),
    ] = None,
    circle: Annotated[str | None, typer.Option(help="Instead: centre and radius X,Y,R in m.")] = None,
    ellipse: Annotated[
        str | None, typer.Option(help="Instead: centre, semi-axes and perhaps a rotation X,Y,A,B,ROTATION.")
    ] = None,
    line: Annotated[str | None, typer.Option(help="Instead: both ends X1,Y1,X2,Y2 in m.")] = None,
    method: Annotated[
        str | None,
        typer.Option(help="pseudoinverse, speed_ratio, two_term or look_ahead; all are compared when left out."),
    ] = None,
    q: Annotated[
        str | None, typer.Option("--q", help="The posture to start in; with --start a guess. Found when left out.")
    ] = None,
    start: Annotated[float | None, typer.Option(help="Arc length, in m, at which to begin.")] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Angles given are degrees.")] = False,
    figure: Annotated[
        Path | None,
        typer.Option(callback=figure_file, help="Draw the path, updates and offsets into FILE (.svg, .png or .pdf)."),
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Follow a path with a planar 3-joint arm at constant joint rates; count the feedback updates.

    Exits with 1 if the end of the path is not reached (by any method, where all are compared).

    Example: chainrule follow ambike_3r --circle 2,0.5,0.6 --tolerance 0.005 --figure follow.svg
    """
    from chainrule.following import follow as run
    from chainrule.stretches import METHODS

    loaded = load_arm(arm, tip, base)
    desired = _path(path, {"circle": circle, "ellipse": ellipse, "line": line}, deg)
    posture = None if q is None else configuration(q, loaded, deg)
    runs: list[Followed] = []
    with progressing() as progress:
        for name in METHODS if method is None else (method,):
            progress(f"following by {name}")
            runs.append(run(loaded, desired, tolerance, method=name, q=posture, start=start))  # type: ignore[arg-type]
    if figure is not None:
        from chainrule.plot.following import draw_following

        write_figure(draw_following(loaded, desired, runs), figure)
    if as_json:
        print_json({"arm": loaded.name, "path": desired.to_dict(), "runs": [found.to_dict() for found in runs]})
    else:
        _print(runs, desired)
    if not any(found.status == "finished" for found in runs):
        raise typer.Exit(1)


def _path(file: Path | None, given: dict[str, str | None], deg: bool) -> TipPath:
    """The one path that was given."""
    from chainrule.parametric_paths import Ellipse
    from chainrule.paths import Circle, Line

    named = {name: text for name, text in given.items() if text is not None}
    if len(named) + (file is not None) != 1:
        raise InputError("one of --path, --circle, --ellipse and --line is needed, and only one")
    if file is not None:
        from chainrule.readers.paths import read_path

        return read_path(file)
    ((name, text),) = named.items()
    if name == "circle":
        x, y, radius = numbers(text, "--circle", 3)
        return Circle((x, y), radius)
    if name == "line":
        x1, y1, x2, y2 = numbers(text, "--line", 4)
        return Line((x1, y1), (x2, y2))
    values = numbers(text, "--ellipse")
    if len(values) not in (4, 5):
        raise InputError(f"--ellipse: {len(values)} numbers given; 4 or 5 are accepted")
    turn = values[4] if len(values) == 5 else 0.0
    return Ellipse(values[:2], values[2:4], rotation=angle(turn, deg, "--ellipse"))


def _print(runs: list[Followed], path: TipPath) -> None:
    from chainrule.tables import Column, Table, readable

    columns = (
        Column("method", "method"),
        Column("updates", "updates"),
        Column("followed", "followed", "m"),
        Column("worst", "worst distance", "m"),
        Column("status", "status"),
    )
    rows = tuple((run.method, run.updates, run.followed, run.worst, run.status) for run in runs)
    caption = f"Path of {readable(path.length, 6)} m, tolerance {readable(runs[0].tolerance, 6)} m"
    print_table(Table(caption, columns, rows))
    for run in runs:
        if run.status != "finished":
            say(f"{run.method}: {run.reason}.")
