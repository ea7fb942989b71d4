"""``chainrule speed-ratios``: constant joint-rate ratios that follow a tangent and a curvature."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
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
from chainrule.outputs import figure_file

if TYPE_CHECKING:
    from chainrule.speed_ratio import Leading


@app.command()
def speed_ratios(
    arm: ArmName,
    q: Annotated[str, typer.Option("--q", help="The joint values, separated by commas or spaces: rad, or m.")],
    tangent: Annotated[str, typer.Option(help="The direction of motion X,Y, of any length.")],
    curvature: Annotated[str, typer.Option(help="The desired curvature, 1/m; a left turn is positive.")],
    curvature_rate: Annotated[str, typer.Option(help="Its desired change along the path, 1/m².")] = "0",
    leading: Annotated[
        str, typer.Option(help="The leading joint: 1, 2, 3, or auto for the one that moves most.")
    ] = "1",
    deg: Annotated[bool, typer.Option("--deg", help="Angles in --q are degrees.")] = False,
    figure: Annotated[
        Path | None, typer.Option(callback=figure_file, help="Draw the paths into FILE (.svg, .png or .pdf).")
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Find joint rates in constant ratio that follow a tangent and a curvature, for planar arms with three joints.

    Exits with 1 at a singular configuration, where there are none.

    Example: chainrule speed-ratios ambike_3r --q=-14,-10,-205 --deg --tangent 2,1 --curvature -1 --figure ratios.svg
    """
    from chainrule.speed_ratio import check_arm, table
    from chainrule.speed_ratio import speed_ratios as solve

    loaded = load_arm(arm, tip, base)
    check_arm(loaded)
    given = configuration(q, loaded, deg)
    (bend,), (change,) = numbers(curvature, "--curvature", 1), numbers(curvature_rate, "--curvature-rate", 1)
    with progressing() as progress:
        progress("solving")
        found = solve(loaded, given, numbers(tangent, "--tangent", 2), bend, change, _leading(leading))
    if figure is not None:
        from chainrule.plot.speed_ratio import draw_speed_ratios

        write_figure(draw_speed_ratios(found), figure)
    if as_json:
        print_json(found.to_dict() | ({"figure": str(figure)} if figure is not None else {}))
    else:
        if found.count:
            print_table(table(found))
        say(found.reason)
    if not found.count:
        raise typer.Exit(1)


def _leading(text: str) -> Leading:
    if text == "auto":
        return "auto"
    if text not in ("1", "2", "3"):
        raise InputError(f"--leading: {shown(text)}; 1, 2, 3 or auto are accepted")
    return int(text)
