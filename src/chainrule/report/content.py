"""What a section of the report is made of: plain data, which the page's template writes as HTML."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

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


@dataclass(frozen=True)
class Headlines:
    """What the sections found, in plain sentences: key and title of a section, and the sentence."""

    lines: tuple[tuple[str, str, str], ...]
    kind: ClassVar[str] = "headlines"


@dataclass(frozen=True)
class Subtitle:
    """A heading inside a section."""

    text: str
    kind: ClassVar[str] = "subtitle"


@dataclass(frozen=True)
class Claims:
    """What a paper states beside ours: rows of :class:`chainrule.papers.Row`."""

    caption: str
    rows: tuple[Any, ...]
    kind: ClassVar[str] = "claims"


@dataclass(frozen=True)
class Motion:
    """The arm drawn in one posture of a motion, which a slider moves; see :mod:`chainrule.report.motion`.

    Without scripts it stays the picture of its first posture among others of the motion.

    Attributes:
        key: starts every id.
        title: of the picture, for those who do not see it.
        description: likewise.
        label: what the slider does.
        height: of the picture, whose width is 400.
        base: (x, y) of the arm's base in the picture.
        tracks: the motions to choose from, as plain values: name, frames, texts, lines of the chart, first posture.
        chart: what is drawn over the slider's range: its title, ticks and frame.
        caption: below.
    """

    key: str
    title: str
    description: str
    label: str
    height: float
    base: tuple[float, float]
    tracks: tuple[dict[str, Any], ...]
    chart: dict[str, Any]
    caption: str
    kind: ClassVar[str] = "motion"


Block = (
    Prose
    | Finding
    | Points
    | Formula
    | Formulas
    | Grid
    | Picture
    | Facts
    | Details
    | Headlines
    | Subtitle
    | Claims
    | Motion
)


@dataclass(frozen=True)
class Part:
    """The content of a section, the numbers in it for machines, and what the summary says of it."""

    blocks: tuple[Block, ...]
    data: dict[str, object] = field(default_factory=dict)
    headlines: tuple[str, ...] = ()
