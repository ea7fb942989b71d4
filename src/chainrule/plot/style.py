"""One look for every figure: colours, sizes, and how a figure becomes SVG for a page.

Figures are drawn on their own canvas (never through pyplot), with named colours. On a page the names become CSS
variables, so that one figure is right on a light and on a dark ground; alone, a figure has the light colours.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from html import escape
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chainrule.tables import capitalised

#: Named colours: the light value, which also marks the name in the SVG, so all values differ.
COLOURS = {
    "ink": "#1c2733",
    "muted": "#5b6876",
    "line": "#c9d1d9",
    "ground": "#eef1f4",
    "paper": "#fdfdfc",
    "link": "#2f4a6d",
    "joint": "#d9822b",
    "accent": "#b3261e",
    "fill": "#cfdcea",
    "fill_deep": "#a5bfd8",
    "axis_x": "#b0413e",
    "axis_y": "#3f7d4e",
    "axis_z": "#3568ba",
}

#: Colour map of every field: monotonic in lightness, so it survives printing in grey.
FIELD = "cividis"

#: Line styles of several lines in one picture, and the colours they go with: together they tell lines apart in grey.
DASHES: tuple[Any, ...] = (
    *("-", (0, (5, 1.6)), (0, (1.2, 1.2)), (0, (7, 1.5, 1.5, 1.5))),
    *((0, (11, 1.8)), (0, (2.4, 1.0)), (0, (1.2, 2.8)), (0, (7, 1.3, 1.3, 1.3, 1.3, 1.3))),
)
LINES = ("link", "joint", "accent", "axis_y", "axis_z", "ink", "muted")

WIDTH = 5.0  # inches; text keeps its size relation to the figure on every screen
_FONTS = ["system-ui", "-apple-system", "Segoe UI", "Roboto", "Helvetica Neue", "Arial", "DejaVu Sans", "sans-serif"]

_SETTINGS: Any = {  # matplotlib's type of it differs between versions
    "font.family": ["DejaVu Sans"],
    "font.size": 10.0,
    "axes.titlesize": 10.0,
    "axes.labelsize": 10.0,
    "axes.edgecolor": COLOURS["line"],
    "axes.labelcolor": COLOURS["muted"],
    "axes.titlecolor": COLOURS["ink"],
    "text.color": COLOURS["ink"],
    "xtick.color": COLOURS["line"],
    "ytick.color": COLOURS["line"],
    "xtick.labelcolor": COLOURS["muted"],
    "ytick.labelcolor": COLOURS["muted"],
    "axes.facecolor": "none",
    "figure.facecolor": "none",
    "savefig.facecolor": "none",
    "axes.linewidth": 0.8,
    "svg.fonttype": "none",
    "svg.hashsalt": "chainrule",
    "text.usetex": False,
    "text.parse_math": False,
    "axes.unicode_minus": True,
}


@contextmanager
def styled() -> Iterator[None]:
    """The settings of every figure, for the time of drawing."""
    with rc_context(_SETTINGS):
        yield


def figure(height: float, width: float = WIDTH) -> tuple[Figure, Axes]:
    """A figure with one pair of axes, without pyplot; sizes in inches."""
    drawing = Figure(figsize=(width, height), layout="constrained")
    axes = drawing.add_subplot()
    axes.spines[["top", "right"]].set_visible(False)
    return drawing, axes


def line_look(k: int) -> dict[str, Any]:
    """Colour and dashes of the k-th of several lines, from 0; no two of the first 8 look alike in grey."""
    return {"color": COLOURS[LINES[k % len(LINES)]], "ls": DASHES[k % len(DASHES)]}


def svg(drawing: Figure, key: str, title: str, description: str) -> str:
    """A figure as an ``<svg>`` element to stand in a page.

    Every id starts with ``key``; the colours become CSS variables with the light value as fallback; nothing refers to
    anything outside. ``title`` and ``description`` are for those who do not see the figure.
    """
    buffer = io.StringIO()
    with styled():
        drawing.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    return inline(buffer.getvalue(), key, title, description)


def titles(drawing: Figure) -> str:
    r"""What a figure says of itself: its title and those of its panels, as sentences, for those who do not see it.

    Example:
        >>> drawing, axes = figure(3.0)
        >>> _ = axes.set_title("One finding\nAnother, which\ngoes on", loc="left")
        >>> titles(drawing)
        'One finding. Another, which goes on.'
    """
    texts = [drawing.get_suptitle(), *(axes.get_title(loc) for axes in drawing.axes for loc in ("left", "center"))]
    lines = [re.sub(r"(?<=[^.,:;])\n(?=[A-Z])", ". ", text.strip()) for text in texts if text.strip()]
    words = [" ".join(line.split()).rstrip(".") for line in lines]
    return " ".join(f"{capitalised(word)}." for word in dict.fromkeys(words))


def inline(text: str, key: str, title: str, description: str) -> str:
    """Matplotlib's SVG made fit to stand in a page beside others."""
    text = text[text.index("<svg") :].strip()
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'\bid="([^"]*)"', rf'id="{key}-\1"', text)
    text = re.sub(r'(?:xlink:)?href="#([^"]*)"', rf'href="#{key}-\1"', text)
    text = re.sub(r"url\(#([^)]*)\)", rf"url(#{key}-\1)", text)
    text = text.replace("xlink:href=", "href=")
    for name, light in COLOURS.items():
        text = text.replace(light, f"var(--fig-{name.replace('_', '-')}, {light})")
    text = text.replace("'DejaVu Sans'", ", ".join(f"'{f}'" if " " in f else f for f in _FONTS))
    opening = re.match(r"<svg[^>]*>", text)
    assert opening is not None
    box = re.search(r'viewBox="([^"]*)"', opening.group())
    assert box is not None
    width = round(float(box.group(1).split()[2]))
    kind = ' class="wide"' if width > 1.2 * 72.0 * WIDTH else ""
    start = (
        f'<svg{kind} style="--width:{width}" viewBox="{box.group(1)}" role="img" '
        f'aria-labelledby="{key}-title {key}-desc" preserveAspectRatio="xMidYMid meet">\n'
        f'<title id="{key}-title">{escape(title)}</title>\n'
        f'<desc id="{key}-desc">{escape(description)}</desc>'
    )
    return start + text[opening.end() :]
