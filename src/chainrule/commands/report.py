"""``chainrule report``: the dossier of an arm."""

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
    complain,
    load_arm,
    print_json,
    progressing,
    say,
)
from chainrule.outputs import output_file


@app.command()
def report(
    arm: ArmName,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", callback=output_file, help="The HTML file; ARM's name when left out."),
    ] = None,
    show_it: Annotated[bool, typer.Option("--open", help="Open it in the browser.")] = False,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Write the report of an arm: one HTML page with its formulas, figures, workspace and checks.

    Exits with 1 if a check of the generated code fails (the page is written, and says which).

    Example: chainrule report panda -o panda.html --open
    """
    from chainrule import report as reports

    loaded = load_arm(arm, tip, base)
    path = output or Path(f"{loaded.name}.html")
    output_file(path)
    with progressing() as progress:
        written = reports.write(loaded, path, progress)
    if as_json:
        print_json({"arm": loaded.name, "file": str(path), **written.to_dict()})
    else:
        say(str(path))
        for check in written.failed:
            complain(f"a check failed: {check.what} ({check.worst:.2g}, {check.bound:.2g} is allowed)")
    if show_it:
        import webbrowser

        webbrowser.open(path.resolve().as_uri())
    if not written.passed:
        raise typer.Exit(1)
