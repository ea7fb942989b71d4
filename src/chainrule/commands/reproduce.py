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
from chainrule.errors import InputError
from chainrule.outputs import output_file


@app.command()
def reproduce(
    paper: Annotated[str, typer.Argument(metavar="[PAPER]", help="Which paper, or all of them.")] = "all",
    html: Annotated[
        Path | None,
        typer.Option(
            "--html", metavar="FILE", callback=output_file, help="Write one HTML page with the rows and the figures."
        ),
    ] = None,
    figures: Annotated[
        Path | None,
        typer.Option(
            "--figures", metavar="FOLDER", help="Draw the figures anew, as .svg files; the folder is made if need be."
        ),
    ] = None,
    as_json: Json = False,
) -> None:
    """Recompute what a paper states: where, what, the paper, ours, difference, verdict, and the call that gives ours.

    Exits with 1 if a difference is left that nothing explains.

    Example: chainrule reproduce deluca --html deluca.html
    """
    from chainrule import papers
    from chainrule.derive.manifest import write_whole
    from chainrule.papers import PAPERS

    if html is not None and html.suffix.lower() not in (".html", ".htm"):
        raise InputError(f"{html}: the page is written as .html")
    if figures is not None and figures.exists() and not figures.is_dir():
        raise InputError(f"{figures} is a file; a folder is accepted")
    keys = list(PAPERS) if paper == "all" else [paper]
    written: list[Path] = []
    with progressing() as progress:
        found = {}
        for key in keys:
            found[key] = papers.reproduce(key, lambda line, key=key: progress(f"{key}: {line}"))  # type: ignore[misc]
        drawn = {}
        for key in keys if html is not None or figures is not None else ():
            progress(f"{key}: drawing the figures")
            drawn[key] = papers.figures(key)
        if figures is not None:
            figures.mkdir(parents=True, exist_ok=True)
            for key, drawings in drawn.items():
                for name, drawing in drawings.items():
                    written.append(figures / f"{key}-{name}.svg")
                    write_figure(drawing, written[-1])
        if html is not None:
            from chainrule.papers import page

            progress("writing the page")
            write_whole(html, page.html(found, drawn))
            written.append(html)
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
                "files": [str(path) for path in written],
            }
        )
    else:
        for key, rows in found.items():
            _print_paper(key, rows)
        for path in written:
            say(str(path))
    if not good:
        raise typer.Exit(1)


def _print_paper(key: str, rows: Sequence[Any]) -> None:
    from chainrule.papers import PAPERS
    from chainrule.tables import Column, Table

    paper = PAPERS[key]
    say(f"{paper.citation}: {paper.scope}")
    titles = {"where": "where", "quantity": "what", "paper": "the paper", "ours": "ours", "difference": "difference"}
    columns = tuple(Column(name, title) for name, title in (titles | {"verdict": "verdict", "how": "how"}).items())
    shown_rows = tuple(
        (r.where, r.quantity, r.paper, r.ours, "" if r.difference is None else f"{r.difference:.2g}", r.verdict, r.how)
        for r in rows
    )
    print_table(Table("", columns, shown_rows))
    for row in rows:
        if row.note:
            say(f"{row.where}, {row.quantity}: {row.verdict}: {row.note}.")
