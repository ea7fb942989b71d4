"""The papers side by side with ours as one HTML page: every row, and the figures drawn anew."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from markupsafe import Markup

from chainrule.papers import PAPERS, VERDICTS, Row
from chainrule.plot.style import svg, titles
from chainrule.report.content import Block, Claims, Finding, Grid, Part, Picture, Prose, Subtitle
from chainrule.report.page import page
from chainrule.tables import Column, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def html(found: Mapping[str, Sequence[Row]], figures: Mapping[str, Mapping[str, Figure]]) -> str:
    """One page for the papers given.

    Args:
        found: the rows of each paper, by its key.
        figures: its figures, by key and name; papers without may be left out.

    Example:
        >>> row = Row("page 1", "a length", "1 m", "1 m", 0.0, "agrees", "f(x)")
        >>> html({"deluca": [row]}, {}).startswith("<!doctype html>")
        True
    """
    parts = {"overview": _overview(found)} | {
        key: _paper(key, rows, figures.get(key, {})) for key, rows in found.items()
    }
    names = {"overview": "Overview"} | {key: PAPERS[key].title for key in found}
    heading = "The papers, recomputed" if len(found) > 1 else PAPERS[next(iter(found))].title
    foot = (
        "Every value of ours on this page was computed when the page was written; the papers' are as they print them."
    )
    return page(heading, "chainrule reproduce", parts, names, foot)


def _overview(found: Mapping[str, Sequence[Row]]) -> Part:
    every = [row for rows in found.values() for row in rows]
    bad = sum(not row.good for row in every)
    shown = [verdict for verdict in VERDICTS if verdict != "DISAGREES" or bad]
    counts = {key: Counter(row.verdict for row in rows) for key, rows in found.items()}
    table = Table(
        "Rows by verdict",
        (Column("paper", "paper"), *(Column(verdict, verdict) for verdict in shown), Column("all", "all")),
        tuple((PAPERS[key].title, *(count[v] for v in shown), count.total()) for key, count in counts.items()),
    )
    good = "Nothing is left unexplained." if not bad else f"{bad} differences are left that nothing explains."
    meanings = Table(
        "What a verdict means",
        (Column("verdict", "verdict"), Column("meaning", "meaning")),
        tuple(VERDICTS.items())[:-1],
    )
    return Part(
        (
            Prose(
                f"{len(every)} statements: numbers, formulas, figures and claims, each as the paper has it, beside "
                "what the functions of this package give, with the call that gives it."
            ),
            Finding(good, tone="bad" if bad else "good"),
            Grid(table),
            Grid(meanings),
        )
    )


def _paper(key: str, rows: Sequence[Row], figures: Mapping[str, Figure]) -> Part:
    paper = PAPERS[key]
    blocks: list[Block] = [
        Prose(f"{paper.citation}. Recomputed: {paper.scope}."),
        Claims(f"{paper.title}: {len(rows)} statements", tuple(rows)),
    ]
    if figures:
        blocks.append(Subtitle("The figures, drawn anew"))
    for name, drawing in figures.items():
        what = name.replace("-", " ", 1).replace("-", " and ").capitalize()
        said = titles(drawing)
        picture = svg(drawing, f"{key}-{name}", f"{what} of {paper.title}, drawn anew", said)
        blocks.append(Picture(Markup(picture), f"{what}. {said}"))
    return Part(tuple(blocks), {"rows": [row.to_dict() for row in rows]})
