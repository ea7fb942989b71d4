"""One table of everything measured, with the goals beside: for the terminal, as Markdown, as JSON."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import Any

HEADINGS = ("what", "who", "time", "spread", "to ours", "goal", "reached")


@dataclass(frozen=True)
class Row:
    """One line.

    Attributes:
        section: the heading it stands under.
        who: what was timed.
        value: the time, in ``unit``.
        unit: ns (for one configuration), ms or s; or "x" for a ratio.
        spread: half of what lies between the quartiles, over the median; None for a single measurement.
        ratio: the time over ours in the same rounds; None where there is nothing to compare.
        goal: what was aimed at, in words.
        reached: whether it was.
    """

    section: str
    who: str
    value: float
    unit: str
    spread: float | None = None
    ratio: float | None = None
    goal: str = ""
    reached: bool | None = None


def _cells(row: Row) -> tuple[str, ...]:
    digits = 0 if row.value >= 1000 else 1 if row.value >= 10 else 2
    return (
        row.who,
        f"{row.value:,.{digits}f} {row.unit}",
        "" if row.spread is None else f"± {row.spread:.0%}",
        "" if row.ratio is None else f"{row.ratio:,.2f}" if row.ratio < 100 else f"{row.ratio:,.0f}",
        row.goal,
        {None: "", True: "yes", False: "no"}[row.reached],
    )


def sections(rows: Iterable[Row]) -> dict[str, list[Row]]:
    """The rows under their headings, in order."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.section, []).append(row)
    return found


def as_markdown(rows: Iterable[Row], notes: Iterable[str]) -> str:
    """The table in GitHub's Markdown."""
    lines = ["| " + " | ".join(HEADINGS) + " |", "| --- | --- | ---: | ---: | ---: | --- | --- |"]
    for section, members in sections(rows).items():
        for k, row in enumerate(members):
            lines.append("| " + " | ".join((section if k == 0 else "", *_cells(row))) + " |")
    return "\n".join([*lines, "", *(f"- {note}" for note in notes), ""])


def as_json(rows: Iterable[Row], notes: Iterable[str], facts: dict[str, Any]) -> dict[str, Any]:
    """Everything, for machines."""
    return {"facts": facts, "rows": [asdict(row) for row in rows], "notes": list(notes)}


def show(rows: Iterable[Row], notes: Iterable[str], title: str) -> None:
    """The table on the terminal."""
    from rich.console import Console
    from rich.table import Table

    table = Table(title=title, title_justify="left", header_style="bold")
    for k, heading in enumerate(HEADINGS):
        table.add_column(heading, justify="right" if k in (2, 3, 4) else "left", overflow="fold")
    for section, members in sections(rows).items():
        for k, row in enumerate(members):
            cells = _cells(row)
            style = {None: None, True: "green", False: "red"}[row.reached]
            table.add_row(section if k == 0 else "", *cells, style=style, end_section=k == len(members) - 1)
    console = Console()
    console.print(table)
    for note in notes:
        console.print(f"- {note}", highlight=False, markup=False)
