"""``chainrule generate``: an arm's functions as code that stands alone."""

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
    print_json,
    progressing,
    say,
)


@app.command()
def generate(
    arm: ArmName,
    output: Annotated[Path, typer.Option("--output", "-o", help="The folder to write; made if needed.")],
    targets: Annotated[str, typer.Option(help="What to write: c, python, or both separated by a comma.")] = "c,python",
    task: Annotated[str | None, typer.Option(help="What the step in C follows: position, pose or x_alpha.")] = None,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Write an arm's functions as code that stands alone.

    Example: chainrule generate ur5e -o ur5e_code --targets c
    """
    from chainrule.export import generate as write

    loaded = load_arm(arm, tip, base)
    with progressing() as progress:
        wanted = [t.strip() for t in targets.split(",") if t.strip()]
        paths = write(loaded, output, targets=wanted, progress=progress, task=task)
    if as_json:
        print_json({"arm": loaded.name, "files": [str(path) for path in paths]})
        return
    for path in paths:
        say(str(path))
