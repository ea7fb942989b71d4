"""The command line: ``chainrule arms``, ``show``, ``eval``, ``generate``, ``report``, ``reproduce``.

Results go to standard output, everything else to standard error. Every command takes ``--json``. Exit codes: 0 done,
1 the answer is no (a check fails, a paper's value is not met), 2 bad input (one line says why), 130 interrupted.
"""

from __future__ import annotations

import json
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from chainrule.errors import GenerationError, InputError, shown

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.tables import Table

app = typer.Typer(
    name="chainrule",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    help="Derives what is true of a robot arm, writes it as fast code, and answers questions with it.\n\n"
    "Example: chainrule report panda -o panda.html",
)

ArmName = Annotated[
    str, typer.Argument(metavar="ARM", help="An embedded arm's name, or the path of a .toml or .urdf file.")
]
Tip = Annotated[str | None, typer.Option(help="URDF: the link at the end of the chain.")]
Base = Annotated[str | None, typer.Option(help="URDF: the link at its start; the root when left out.")]
Json = Annotated[bool, typer.Option("--json", help="Write JSON to standard output.")]
Task = Annotated[str | None, typer.Option(help="The task: position, pose or x_alpha; the arm's own when left out.")]

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
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


@app.command()
def arms(as_json: Json = False) -> None:
    """List the embedded arms.

    Example: chainrule arms
    """
    from chainrule import arms as embedded
    from chainrule.arm import load
    from chainrule.tables import Column, Table, printable

    found = [load(name) for name in embedded.names()]
    columns = (Column("name", "name"), Column("joints", "joints"), Column("kinds", "kinds"), Column("source", "source"))
    rows = tuple((arm.name, arm.n, arm.kinds, printable(arm.description.source)) for arm in found)
    _table_or_json(Table("Embedded arms", columns, rows), as_json)


@app.command()
def show(arm: ArmName, tip: Tip = None, base: Base = None, as_json: Json = False) -> None:
    """Show an arm: joints, geometry, limits, source, tasks, and what is generated for it.

    For an arm of your own the functions are derived and compiled first; they are kept for the next time.

    Example: chainrule show my_robot.urdf --tip flange
    """
    from chainrule import tables

    loaded = _load(arm, tip, base)
    with _progress() as progress:
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
        _print_json(
            {
                "name": loaded.name,
                "kinds": loaded.kinds,
                "source": loaded.description.source,
                **{key: [row for table in found for row in table.to_dict()] for key, found in listed.items()},
            }
        )
        return
    _say(f"{loaded.name}: {loaded.n} joints ({loaded.kinds})")
    _say(f"source: {tables.printable(loaded.description.source) or 'not given'}")
    for found in listed.values():
        for table in found:
            _print_table(table)


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
    loaded = _load(arm, tip, base)
    given = np.array([_configuration(text, loaded) for text in q])
    if deg:
        given[:, [kind == "R" for kind in loaded.kinds]] *= np.pi / 180.0
    single = len(given) == 1
    method = getattr(loaded, name.replace("-", "_"))
    options = {"task": task} if FUNCTIONS[name] else {}
    with _progress() as progress:
        progress(f"evaluating {name}")
        result = np.asarray(method(given[0] if single else given, **options))
    if as_json:
        _print_json(
            {
                "arm": loaded.name,
                "function": name,
                "task": task or (loaded.default_task if FUNCTIONS[name] else None),
                "q": (given[0] if single else given).tolist(),
                "shape": list(result.shape),
                "result": _finite(result),
            }
        )
        return
    with np.printoptions(precision=12, suppress=False, linewidth=200, threshold=sys.maxsize):
        _say(str(result))


@app.command()
def generate(
    arm: ArmName,
    output: Annotated[Path, typer.Option("--output", "-o", help="The folder to write; made if needed.")],
    targets: Annotated[str, typer.Option(help="What to write: c, python, or both separated by a comma.")] = "c,python",
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Write an arm's functions as code that stands alone.

    Example: chainrule generate ur5e -o ur5e_code --targets c
    """
    from chainrule.export import generate as write

    loaded = _load(arm, tip, base)
    with _progress() as progress:
        paths = write(loaded, output, targets=[t.strip() for t in targets.split(",") if t.strip()], progress=progress)
    if as_json:
        _print_json({"arm": loaded.name, "files": [str(path) for path in paths]})
        return
    for path in paths:
        _say(str(path))


@app.command()
def report(
    arm: ArmName,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The HTML file; ARM's name when left out.")
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

    loaded = _load(arm, tip, base)
    path = output or Path(f"{loaded.name}.html")
    if path.is_dir():
        raise InputError(f"{path} is a folder; a file is accepted")
    with _progress() as progress:
        written = reports.write(loaded, path, progress)
    if as_json:
        _print_json({"arm": loaded.name, "file": str(path), **written.to_dict()})
    else:
        _say(str(path))
        for check in written.failed:
            _complain(f"a check failed: {check.what} ({check.worst:.2g}, {check.bound:.2g} is allowed)")
    if show_it:
        import webbrowser

        webbrowser.open(path.resolve().as_uri())
    if not written.passed:
        raise typer.Exit(1)


@app.command()
def reproduce(
    paper: Annotated[
        str | None, typer.Argument(metavar="[PAPER]", help="Which paper; all of them when left out.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Recompute what a paper prints: quantity, paper, ours, difference, verdict.

    Exits with 1 if a difference is left that nothing explains.

    Example: chainrule reproduce deluca
    """
    from chainrule.papers import PAPERS
    from chainrule.papers import reproduce as recompute

    with _progress() as progress:
        found = {key: recompute(key, progress) for key in ([paper] if paper is not None else PAPERS)}
    good = all(row.good for rows in found.values() for row in rows)
    if as_json:
        _print_json(
            {
                "agrees": good,
                "papers": {
                    key: {
                        "citation": PAPERS[key].citation,
                        "scope": PAPERS[key].scope,
                        "rows": [row.to_dict() for row in rows],
                    }
                    for key, rows in found.items()
                },
            }
        )
    else:
        for key, rows in found.items():
            _print_paper(key, rows)
    if not good:
        raise typer.Exit(1)


def _version(wanted: bool) -> None:
    if wanted:
        import chainrule

        _say(f"chainrule {chainrule.__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Shared options."""


# ---- what the commands share -------------------------------------------------------------------------------------


def _load(source: str, tip: str | None, base: str | None) -> Arm:
    from chainrule.arm import load

    return load(source, tip=tip, base=base)


def _configuration(text: str, arm: Arm) -> list[float]:
    """The numbers of one ``--q``; nothing in it is evaluated."""
    entries = [entry for entry in re.split(r"\s*,\s*|\s+", text.strip())]
    numbers = []
    for place, entry in enumerate(entries, 1):
        if len(entry) > 100 or not _NUMBER.fullmatch(entry) or abs(float(entry)) == float("inf"):
            raise InputError(f"--q, entry {place}: {shown(entry)} is not a finite number")
        numbers.append(float(entry))
    if len(numbers) != arm.n:
        raise InputError(f"--q: {len(numbers)} numbers given; {arm.name} has {arm.n} joints")
    return numbers


def _finite(array: Any) -> Any:
    """Nested lists in which what is not finite is null: JSON has no name for it."""
    if array.ndim:
        return [_finite(part) for part in array]
    value = float(array)
    return value if value == value and abs(value) != float("inf") else None


def _print_json(content: Any) -> None:
    print(json.dumps(content, ensure_ascii=False, allow_nan=False, indent=2))


def _say(text: str) -> None:
    print("".join(c if c.isprintable() or c == "\n" else " " for c in text))


def _complain(text: str) -> None:
    print(f"chainrule: {' '.join(text.split())}", file=sys.stderr)


def _table_or_json(table: Table, as_json: bool) -> None:
    if as_json:
        _print_json(table.to_dict())
    else:
        _print_table(table)


def _console() -> Any:
    from rich.console import Console

    wide = None if sys.stdout.isatty() else 200
    return Console(width=wide, highlight=False, markup=False, emoji=False)


def _print_table(table: Table) -> None:
    from rich import box
    from rich.table import Table as RichTable
    from rich.text import Text

    from chainrule.tables import readable

    title = Text(table.caption) if table.caption else None
    drawn = RichTable(title=title, title_justify="left", box=box.SIMPLE_HEAD, pad_edge=False, title_style="bold")
    for k, column in enumerate(table.columns):
        drawn.add_column(Text(column.heading), justify="right" if table.numeric(k) else "left", overflow="fold")
    for row in table.rows:
        drawn.add_row(*(Text(readable(cell)) for cell in row))
    console = _console()
    with console.capture() as captured:
        console.print(drawn)
    print("\n".join(line.rstrip() for line in captured.get().splitlines()))


def _print_paper(key: str, rows: Sequence[Any]) -> None:
    from chainrule.papers import PAPERS
    from chainrule.tables import Column, Table

    paper = PAPERS[key]
    _say(f"{paper.citation}: {paper.scope}")
    columns = tuple(Column(name, name) for name in ("where", "quantity", "paper", "ours", "difference", "verdict"))
    shown_rows = tuple(
        (r.where, r.quantity, r.paper, r.ours, "" if r.difference is None else f"{r.difference:.2g}", r.verdict)
        for r in rows
    )
    _print_table(Table("", columns, shown_rows))
    for row in rows:
        if row.note:
            _say(f"{row.quantity}: {row.note}.")


@contextmanager
def _progress() -> Iterator[Callable[[str], None]]:
    """A line of progress on standard error while something takes time, if somebody is looking."""
    if not sys.stderr.isatty():
        yield lambda line: None
        return
    from rich.console import Console
    from rich.text import Text

    console = Console(stderr=True, highlight=False)
    with console.status(Text("working")) as status:
        yield lambda line: status.update(Text(line))


def _warn(message: Warning | str, category: type[Warning], *rest: Any, **more: Any) -> None:
    _complain(f"note: {message}")


#: What Typer raises for a command line it cannot read (its own class where it carries its own parser).
_REFUSED: type[Exception] = typer.BadParameter.__mro__[2]


def run(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    warnings.showwarning = _warn
    command = typer.main.get_command(app)
    words = sys.argv[1:] if arguments is None else list(arguments)
    try:
        with command.make_context("chainrule", words) as context:
            command.invoke(context)
        sys.stdout.flush()
        return 0
    except typer.Exit as done:
        return done.exit_code
    except (InputError, GenerationError) as error:
        _complain(str(error))
    except _REFUSED as error:
        if type(error).__name__ == "NoArgsIsHelpError":
            return 2  # the help was printed
        _complain(error.format_message())  # type: ignore[attr-defined]
    except BrokenPipeError:  # the reader of our output has gone: nothing more to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        _complain(f"{error.filename or 'a file'}: {error.strerror or error}")
    except (KeyboardInterrupt, typer.Abort):
        _complain("interrupted")
        return 130
    return 2


def main() -> None:
    """The ``chainrule`` command."""
    sys.exit(run())


if __name__ == "__main__":
    main()
