"""``chainrule four-joints``: all constant joint-rate ratios of an arm with four joints that follow a path."""

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
    configuration,
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
def four_joints(
    arm: ArmName,
    q: Annotated[str, typer.Option("--q", help="The joint values, separated by commas or spaces: rad, or m.")],
    tangent: Annotated[str, typer.Option(help="The direction of motion X,Y, of any length.")],
    curvature: Annotated[str, typer.Option(help="The desired curvature, 1/m; a left turn is positive.")],
    curvature_rate: Annotated[str, typer.Option(help="Its desired change along the path, 1/m².")] = "0",
    deg: Annotated[bool, typer.Option("--deg", help="Angles in --q are degrees.")] = False,
    figure: Annotated[
        Path | None, typer.Option(callback=figure_file, help="Draw the conditions into FILE (.svg, .png or .pdf).")
    ] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Find all joint rates of a planar arm with four joints that meet tangent, curvature and curvature rate.

    Exits with 1 where there are none; those that come nearest are listed instead.

    Example: chainrule four-joints arm.toml --q "0.2 0.8 0.9 -1.2" --tangent 3,4 --curvature 0.3 --figure six.svg
    """
    from chainrule.four_joints import STATUSES, speed_ratios_4
    from chainrule.tables import Column, Table

    loaded = load_arm(arm, tip, base)
    given = configuration(q, loaded, deg)
    (bend,), (change,) = numbers(curvature, "--curvature", 1), numbers(curvature_rate, "--curvature-rate", 1)
    with progressing() as progress:
        progress("solving")
        found = speed_ratios_4(loaded, given, numbers(tangent, "--tangent", 2), bend, change)
    if figure is not None:
        from chainrule.plot.higher_order import draw_four_joints

        write_figure(draw_four_joints(found), figure)
    if as_json:
        print_json(found.to_dict() | ({"figure": str(figure)} if figure is not None else {}))
    else:
        columns = (
            *(
                Column(f"rate_{i}", f"dq{i}/ds", "rad/m" if kind == "R" else "")
                for i, kind in enumerate(loaded.kinds, 1)
            ),
            Column("curvature", "curvature", "1/m"),
            Column("curvature_rate", "its rate", "1/m²"),
            Column("curvature_second", "second rate", "1/m³"),
            Column("chosen", "chosen"),
        )
        lines = zip(found.rates.tolist(), found.path[:, 1:].tolist(), strict=True)
        rows = tuple((*rates, *path, k == found.chosen) for k, (rates, path) in enumerate(lines))
        if rows:
            print_table(Table("Joint rates at unit tip speed", columns, rows))
        say(f"{found.status}: {STATUSES[found.status]}.")
        if found.status == "exact":
            say(
                f"{found.count} real, {found.complex_count} complex, {found.at_infinity} at infinity"
                f"{'; the count is proved' if found.certified else ''}."
            )
    if found.count == 0:
        raise typer.Exit(1)
