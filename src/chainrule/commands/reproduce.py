"""``chainrule reproduce``: what the papers print, recomputed."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from chainrule.console import (
    Json,
    app,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)


@app.command()
def reproduce(
    paper: Annotated[
        str | None, typer.Argument(metavar="[PAPER]", help="Which paper; all of them when left out.")
    ] = None,
    figures: Annotated[
        Path | None, typer.Option("--figures", metavar="FOLDER", help="Draw the paper's figures anew, as .svg files.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Recompute what a paper prints: quantity, paper, ours, difference, verdict.

    Exits with 1 if a difference is left that nothing explains.

    Example: chainrule reproduce deluca
    """
    from chainrule import papers
    from chainrule.papers import PAPERS

    drawn: list[Path] = []
    with progressing() as progress:
        found = {key: papers.reproduce(key, progress) for key in ([paper] if paper is not None else PAPERS)}
        for key in found if figures is not None else ():
            progress(f"drawing the figures of {key}")
            for name, drawing in papers.figures(key).items():
                drawn.append(figures / f"{key}-{name}.svg")  # type: ignore[operator]  # not None here
                write_figure(drawing, drawn[-1])
    good = all(row.good for rows in found.values() for row in rows)
    if as_json:
        print_json(
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
        for path in drawn:
            say(str(path))
    if not good:
        raise typer.Exit(1)


def _print_paper(key: str, rows: Sequence[Any]) -> None:
    from chainrule.papers import PAPERS
    from chainrule.tables import Column, Table

    paper = PAPERS[key]
    say(f"{paper.citation}: {paper.scope}")
    columns = tuple(Column(name, name) for name in ("where", "quantity", "paper", "ours", "difference", "verdict"))
    shown_rows = tuple(
        (r.where, r.quantity, r.paper, r.ours, "" if r.difference is None else f"{r.difference:.2g}", r.verdict)
        for r in rows
    )
    print_table(Table("", columns, shown_rows))
    for row in rows:
        if row.note:
            say(f"{row.quantity}: {row.note}.")
