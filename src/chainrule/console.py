"""What the commands share: the application, common arguments, reading numbers, writing tables, JSON and figures.

Results go to standard output, everything else to standard error.
"""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from chainrule.errors import InputError, shown
from chainrule.outputs import figure_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def load_arm(source: str, tip: str | None = None, base: str | None = None) -> Arm:
    """The arm of a name or file, as :func:`chainrule.load`."""
    from chainrule.loading import load

    return load(source, tip=tip, base=base)


def configuration(text: str, arm: Arm, deg: bool = False, what: str = "--q") -> list[float]:
    """One number for each joint, in rad or m; with ``deg`` those of revolute joints are given in degrees."""
    found = numbers(text, what)
    if len(found) != arm.n:
        raise InputError(f"{what}: {_counted(found)} given; {arm.name} has {arm.n} joint{'s' * (arm.n != 1)}")
    turning = [value for value, kind in zip(found, arm.kinds, strict=True) if kind == "R"]
    angle(max(turning, key=abs, default=0.0), deg, what)
    return [math.radians(value) if deg and kind == "R" else value for value, kind in zip(found, arm.kinds, strict=True)]


def angle(value: float, deg: bool, what: str) -> float:
    """An angle in rad, from degrees with ``deg``; without it, one of more than two turns is wondered at."""
    if not deg and abs(value) > 4.0 * math.pi:
        turns = abs(value) / (2.0 * math.pi)
        complain(f"note: {what}: {value:g} is taken as rad, {turns:.3g} turns; --deg is for degrees")
    return math.radians(value) if deg else value


def bounds(text: str, arm: Arm, deg: bool, what: str) -> list[float]:
    """One number for all joints or one for each, per s or s²; with ``deg`` those of revolute joints are in degrees."""
    found = numbers(text, what)
    if len(found) not in (1, arm.n):
        raise InputError(f"{what}: {_counted(found)} given; one, or one for each of {arm.n} joints, is accepted")
    each = found * arm.n if len(found) == 1 else found
    return [math.radians(value) if deg and kind == "R" else value for value, kind in zip(each, arm.kinds, strict=True)]


def _counted(found: list[float]) -> str:
    return f"{len(found)} number{'s' * (len(found) != 1)}"


def finite(array: Any) -> Any:
    """Nested lists in which what is not finite is null: JSON has no name for it."""
    if array.ndim:
        return [finite(part) for part in array]
    value = float(array)
    return value if value == value and abs(value) != float("inf") else None


def print_json(content: Any) -> None:
    """Write plain values as JSON."""
    print(json.dumps(content, ensure_ascii=False, allow_nan=False, indent=2))


def say(text: str) -> None:
    """Write a line of results, without control characters."""
    print("".join(c if c.isprintable() or c == "\n" else " " for c in text))


def complain(text: str) -> None:
    """Write one line to standard error."""
    print(f"chainrule: {' '.join(text.split())}", file=sys.stderr)


def table_or_json(table: Table, as_json: bool) -> None:
    """Write a table for people or for machines."""
    if as_json:
        print_json(table.to_dict())
    else:
        print_table(table)


def _console() -> Any:
    from rich.console import Console

    wide = None if sys.stdout.isatty() else 200
    return Console(width=wide, highlight=False, markup=False, emoji=False)


def print_table(table: Table) -> None:
    """Write a table for people."""
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


@contextmanager
def progressing() -> Iterator[Callable[[str], None]]:
    """A line of progress on standard error while something takes time, if somebody is looking."""
    if not sys.stderr.isatty():
        yield lambda line: None
        return
    from rich.console import Console
    from rich.text import Text

    console = Console(stderr=True, highlight=False)
    with console.status(Text("working")) as status:
        yield lambda line: status.update(Text(line))


def numbers(text: str, what: str, count: int | None = None) -> list[float]:
    """Finite numbers separated by commas or spaces; nothing in the text is evaluated.

    Raises:
        InputError: an entry that is not a number, or another number of entries than ``count``; named by ``what``.
    """
    entries = re.split(r"\s*,\s*|\s+", text.strip())
    found = []
    for place, entry in enumerate(entries, 1):
        if len(entry) > 100 or not _NUMBER.fullmatch(entry) or abs(float(entry)) == float("inf"):
            raise InputError(f"{what}, entry {place}: {shown(entry)} is not a finite number")
        found.append(float(entry))
    if count is not None and len(found) != count:
        raise InputError(f"{what}: {_counted(found)} given; {count} {'is' if count == 1 else 'are'} accepted")
    return found


def write_figure(drawing: Figure, path: Path) -> None:
    """A figure into a file, whole or not at all; the suffix says how.

    Raises:
        InputError: a suffix other than .svg, .png or .pdf, or a folder that does not exist.
    """
    import io

    from chainrule.derive.manifest import write_whole
    from chainrule.plot.style import COLOURS, styled

    figure_file(path)
    kind = path.suffix.lower().removeprefix(".")
    buffer = io.BytesIO()
    dated: dict[str, Any] = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}
    with styled():
        drawing.savefig(buffer, format=kind, dpi=160, facecolor=COLOURS["paper"], metadata=dated[kind])
    write_whole(path, buffer.getvalue())
