"""``chainrule arms``, ``show`` and ``eval``: which arms there are, and what is known of one."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Task,
    Tip,
    app,
    configuration,
    finite,
    load_arm,
    print_json,
    print_table,
    progressing,
    say,
    table_or_json,
)
from chainrule.errors import InputError, shown

#: Functions of an arm that ``eval`` offers, and whether they take a task.
FUNCTIONS = {
    "position": False,
    "pose": False,
    "jacobian": True,
    "minors": True,
    "manipulability": True,
    "manipulability-gradient": True,
    "null-vector": True,
    "null-projector": True,
}


@app.command()
def arms(as_json: Json = False) -> None:
    """List the embedded arms.

    Example: chainrule arms
    """
    from chainrule import arms as embedded
    from chainrule.loading import load
    from chainrule.tables import Column, Table, printable

    found = [load(name) for name in embedded.names()]
    columns = (Column("name", "name"), Column("joints", "joints"), Column("kinds", "kinds"), Column("source", "source"))
    rows = tuple((arm.name, arm.n, arm.kinds, printable(arm.description.source)) for arm in found)
    table_or_json(Table("Embedded arms", columns, rows), as_json)


@app.command()
def show(arm: ArmName, tip: Tip = None, base: Base = None, as_json: Json = False) -> None:
    """Show an arm: joints, geometry, limits, source, tasks, and what is generated for it.

    For an arm of your own the functions are derived and compiled first; they are kept for the next time.

    Example: chainrule show my_robot.urdf --tip flange
    """
    from chainrule import tables

    loaded = load_arm(arm, tip, base)
    with progressing() as progress:
        loaded.prepare(progress)
    tool = tables.tool(loaded.description)
    listed = {
        "geometry": tables.geometry(loaded.description),
        "tool": [tool] if tool else [],
        "joints": [tables.joints(loaded)],
        "tasks": [tables.tasks(loaded)],
        "functions": [tables.functions(loaded)],
    }
    if as_json:
        print_json(
            {
                "name": loaded.name,
                "kinds": loaded.kinds,
                "source": loaded.description.source,
                **{key: [row for table in found for row in table.to_dict()] for key, found in listed.items()},
            }
        )
        return
    say(f"{loaded.name}: {loaded.n} joint{'s' * (loaded.n != 1)} ({loaded.kinds})")
    say(f"source: {tables.printable(loaded.description.source) or 'not given'}")
    for found in listed.values():
        for table in found:
            print_table(table)


@app.command("eval")
def evaluate(
    arm: ArmName,
    function: Annotated[str, typer.Argument(metavar="FUNCTION", help="One of: " + ", ".join(FUNCTIONS) + ".")],
    q: Annotated[
        list[str],
        typer.Option(
            "--q",
            help="The joint values, separated by commas or spaces: rad, and m for "
            "prismatic joints. Repeat it for several configurations.",
        ),
    ],
    task: Task = None,
    deg: Annotated[bool, typer.Option("--deg", help="Angles in --q are degrees.")] = False,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Evaluate one function of an arm.

    Example: chainrule eval panda jacobian --q "0, -45, 0, -135, 0, 90, 45" --deg
    """
    import numpy as np

    name = function.replace("_", "-")
    if name not in FUNCTIONS:
        raise InputError(f"there is no function {shown(function)}; {', '.join(FUNCTIONS)} are accepted")
    if task is not None and not FUNCTIONS[name]:
        raise InputError(f"{name} takes no --task")
    loaded = load_arm(arm, tip, base)
    given = np.array([configuration(text, loaded, deg) for text in q])
    single = len(given) == 1
    method = getattr(loaded, name.replace("-", "_"))
    options = {"task": task} if FUNCTIONS[name] else {}
    with progressing() as progress:
        progress(f"evaluating {name}")
        result = np.asarray(method(given[0] if single else given, **options))
    if as_json:
        print_json(
            {
                "arm": loaded.name,
                "function": name,
                "task": task or (loaded.default_task if FUNCTIONS[name] else None),
                "q": (given[0] if single else given).tolist(),
                "shape": list(result.shape),
                "result": finite(result),
            }
        )
        return
    with np.printoptions(precision=12, suppress=False, linewidth=200, threshold=sys.maxsize):
        say(str(result))
