"""What a section of the report is made of: plain data, which the page's template writes as HTML."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

from markupsafe import Markup

from chainrule.tables import Table


@dataclass(frozen=True)
class Prose:
    """A paragraph of plain text."""

    text: str
    kind: ClassVar[str] = "prose"


@dataclass(frozen=True)
class Finding:
    """A result worth a line of its own; its tone is ``plain``, ``good`` or ``bad`` (to be looked at)."""

    text: str
    tone: str = "plain"
    kind: ClassVar[str] = "finding"


@dataclass(frozen=True)
class Points:
    """A list of short statements."""

    items: tuple[str, ...]
    kind: ClassVar[str] = "points"


@dataclass(frozen=True)
class Formula:
    """A displayed formula (MathML of ours) with a line of text before it."""

    mathml: Markup
    lead: str = ""
    kind: ClassVar[str] = "formula"


@dataclass(frozen=True)
class Formulas:
    """Many formulas, one below the other."""

    lines: tuple[Markup, ...]
    label: str
    kind: ClassVar[str] = "formulas"


@dataclass(frozen=True)
class Grid:
    """A table."""

    table: Table
    digits: int = 7
    kind: ClassVar[str] = "grid"


@dataclass(frozen=True)
class Picture:
    """A figure as SVG of ours, with its caption."""

    svg: Markup
    caption: str
    kind: ClassVar[str] = "picture"


@dataclass(frozen=True)
class Facts:
    """Pairs of a term and its value, such as the numbers at the top."""

    pairs: tuple[tuple[str, str], ...]
    kind: ClassVar[str] = "facts"


@dataclass(frozen=True)
class Details:
    """Blocks that open on demand."""

    summary: str
    blocks: tuple[Block, ...]
    kind: ClassVar[str] = "details"


Block = Prose | Finding | Points | Formula | Formulas | Grid | Picture | Facts | Details


@dataclass(frozen=True)
class Part:
    """The content of a section, and the numbers in it for machines."""

    blocks: tuple[Block, ...]
    data: dict[str, object] = field(default_factory=dict)
