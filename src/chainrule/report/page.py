"""The page around sections: one self-contained HTML text, for the report of an arm and for the papers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from markupsafe import Markup

from chainrule.report.content import Block, Details, Motion, Part


def page(heading: str, kicker: str, parts: Mapping[str, Part], titles: Mapping[str, str], foot: str) -> str:
    """Sections as a page that needs nothing beside it.

    Args:
        heading: what the page is about.
        kicker: what kind of page it is.
        parts: the sections by key, in order.
        titles: their titles, by the same keys.
        foot: the last line.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined

    from chainrule.tables import capitalised, printable, readable

    environment = Environment(
        loader=PackageLoader("chainrule.report", "templates"),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=StrictUndefined,
    )
    environment.filters |= {
        "readable": readable,
        "printable": printable,
        "breaking": breaking,
        "capitalised": capitalised,
    }
    moves = any(isinstance(block, Motion) for part in parts.values() for block in _all(part.blocks))
    return environment.get_template("page.html.j2").render(
        heading=heading, kicker=kicker, parts=parts, titles=titles, foot=foot, version=version(), moves=moves
    )


def _all(blocks: Iterable[Block]) -> Iterable[Block]:
    """The blocks with those inside others."""
    for block in blocks:
        yield block
        if isinstance(block, Details):
            yield from _all(block.blocks)


def breaking(text: str) -> Markup:
    """A name or a call that may break into lines after underscores and brackets, and before the name of an attribute.

    >>> breaking("null_vector(q)")
    Markup('null_<wbr>vector(<wbr>q)')
    """
    escaped = re.sub(r"([_(])|(?=\.[a-z])", r"\1\0", str(Markup.escape(text)))
    return Markup(escaped.replace("\0", "<wbr>"))


def version() -> str:
    """The installed version; nothing where chainrule runs from a checkout that is not installed."""
    from importlib.metadata import PackageNotFoundError

    import chainrule

    try:
        return str(chainrule.__version__)
    except PackageNotFoundError:
        return ""
