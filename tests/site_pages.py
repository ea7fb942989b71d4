"""Whether the page of a paper on the site is what a test has just recomputed."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parents[1] / "docs"


def script(name: str) -> Any:
    """One of the modules that write the site: scripts in docs/, no part of the package."""
    sys.path.insert(0, str(DOCS))
    try:
        return importlib.import_module(name)
    finally:
        sys.path.remove(str(DOCS))


def paper_page_is_up_to_date(key: str, rows: Sequence[Any], whole: bool = True, open_: Sequence[str] = ()) -> bool:
    """Whether docs/papers/KEY.md holds these rows, and (``whole``) nothing else; numbers may differ by rounding.

    In the rows of the quantities ``open_`` they may be any: times, and motions that rounding decides.
    """
    pages = script("pages")
    committed = (DOCS / "papers" / f"{key}.md").read_text("utf-8")
    anew = pages.paper_page(key, rows)
    if not whole:
        tables = [text.split("## Every row\n")[1].strip().splitlines() for text in (anew, committed)]
        count = 2 + len(rows)
        anew, committed = ("\n".join(table[:count]) for table in tables)
    same: bool = pages.same_but_for_rounding(anew, committed, open_)
    return same
