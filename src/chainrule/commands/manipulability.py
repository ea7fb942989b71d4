"""``chainrule manipulability``: the largest manipulability of an arm, and whether that is proved."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Task,
    Tip,
    app,
    load_arm,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)
from chainrule.outputs import figure_file


@app.command()
def manipulability(
    arm: ArmName,
    task: Task = None,
    budget: Annotated[
        int | None, typer.Option(help="How many boxes the proof may examine; some seconds' worth when left out.")
    ] = None,
    figure: Annotated[
        Path | None,
        typer.Option(callback=figure_file, help="Draw the map of H over two joints: a .svg, .png or .pdf file."),
    ] = None,
    postures: Annotated[
        Path | None,
        typer.Option(callback=figure_file, help="Draw the postures in which H is largest (planar arms), likewise."),
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Find the largest manipulability H = sqrt(det(J J^T)) inside the joint limits, with a proof where one can be had.

    It says whether the maximum is proved to be the global one. Exits with 1 if H has no maximum, because a prismatic
    joint without limits raises it without end.

    Example: chainrule manipulability planar_3r --figure map.svg
    """
    from chainrule.manipulability import checked_task, manipulability_map, max_manipulability, unit
    from chainrule.tables import Column, Table, joint_unit

    loaded = load_arm(arm, tip, base)
    task = checked_task(loaded, task)
    with progressing() as progress:
        found = max_manipulability(loaded, task, budget=budget, progress=progress)
    if figure is not None:
        from chainrule.plot.maps import draw_map

        write_figure(draw_map(loaded, manipulability_map(loaded, task, largest=found)), figure)
    if postures is not None:
        from chainrule.plot.maps import draw_optima

        write_figure(draw_optima(loaded, found), postures)
    if as_json:
        print_json({"arm": loaded.name, "task": task, "unit": unit(loaded, task).text, **found.to_dict()})
    else:
        size = unit(loaded, task).suffix
        columns = (
            Column("number", "posture"),
            *(Column(f"q{j}", f"q{j}", joint_unit(kind)) for j, kind in enumerate(loaded.kinds, 1)),
        )
        rows = tuple((k, *(float(round(v, 9) + 0.0) for v in q)) for k, q in enumerate([found.q, *found.others], 1))
        bounded = math.isfinite(found.value)
        word = "proved to be the global maximum" if found.proved else "not proved to be the global maximum"
        say(f"H = {found.value:.12g}{size} ({task}), {word}" if bounded else f"H has no maximum ({task})")
        if math.isfinite(found.bound):
            say(f"no H exceeds {found.bound:.12g}{size}")
        say(f"{found.how}.")
        print_table(Table("", columns, rows))
        for path in (figure, postures):
            if path is not None:
                say(str(path))
    if not math.isfinite(found.value):
        raise typer.Exit(1)
