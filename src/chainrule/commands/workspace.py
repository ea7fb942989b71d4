"""``chainrule workspace``: what a planar arm reaches, and with which orientations."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Tip,
    app,
    load_arm,
    numbers,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)
from chainrule.outputs import figure_file


@app.command()
def workspace(
    arm: ArmName,
    at: Annotated[
        str | None, typer.Option("--at", metavar="X,Y", help="A point, in m: which orientations the tip has there.")
    ] = None,
    figure: Annotated[
        Path | None,
        typer.Option("--figure", metavar="FILE", callback=figure_file, help="Draw it into a .svg, .png or .pdf file."),
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Show the exact workspace of a planar arm within its joint limits: radii, area, boundary, orientations.

    Exits with 1 if a point is given and the tip does not reach it.

    Example: chainrule workspace planar_3r --at 1.2,0.4 --figure workspace.svg
    """
    from chainrule import workspaces

    point = None if at is None else numbers(at, "--at", 2)
    loaded = load_arm(arm, tip, base)
    with progressing() as progress:
        progress("working out the exact workspace")
        found = workspaces.workspace(loaded)
        intervals = None if point is None else found.orientations(*point)
        if figure is not None:
            from chainrule.plot.workspace import draw_workspace

            write_figure(draw_workspace(loaded, found, at=point), figure)
    if as_json:
        shown = found.to_dict()
        if point is not None and intervals is not None:
            shown["at"] = {"point": point, "orientations": [list(pair) for pair in intervals]}
        print_json(shown)
    else:
        say(f"{loaded.name}. {workspaces.summary(found)}.")
        if found.primary or found.secondary:
            print_table(workspaces.rings_table(found))
        print_table(workspaces.boundary_table(found))
        if point is not None:
            say(f"at ({point[0]:g}, {point[1]:g}) m: {workspaces.orientations_in_words(found, point)}")
        if figure is not None:
            say(str(figure))
    if intervals == ():
        raise typer.Exit(1)
