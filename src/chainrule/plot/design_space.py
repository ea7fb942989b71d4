"""The design space of the orthogonal 3R arms: its five domains in sections r2 = constant, and a design in it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from chainrule.cuspidality.classify import classify_orthogonal_3r
from chainrule.cuspidality.domains import CUSPS
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, evaluator
from chainrule.plot.style import COLOURS, WIDTH, styled

Array = NDArray[Any]

#: Sections r2 / d2 of the small multiples, the extent of d3 / d2 and d4 / d2, and points along each side.
SECTIONS, EXTENT, GRID = (0.1, 0.5, 1.0, 2.0), 4.0, 161


def draw_domains(lengths: Sequence[float] | None = None, sections: Sequence[float] = SECTIONS) -> Figure:
    """The domains over d3 / d2 and d4 / d2, in the section of a design and in others (Baili et al. 2004, figure 7).

    Args:
        lengths: (d2, d3, d4, r2) in m of a design to mark; the paper's section r2 = d2 without one when absent.
        sections: r2 / d2 of the four small sections.

    Example:
        >>> draw_domains((1.0, 2.0, 1.5, 1.0)).get_suptitle().splitlines()[0]
        'd2 = 1, d3 = 2, d4 = 1.5, r2 = 1 m lies in domain 2: 4 cusps'
    """
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.75, WIDTH * 0.98), layout="constrained")
        panels = drawing.subplot_mosaic([["main", "main", "a", "b"], ["main", "main", "c", "d"]])
        mark, ratio, extent, title = _marked(lengths)
        _section(panels["main"], ratio, extent, named=True)
        panels["main"].set_title(f"section r2 = {ratio:.4g} d2", loc="left")
        if mark is not None:
            panels["main"].plot(*mark, "o", ms=9, mfc=COLOURS["accent"], mec=COLOURS["paper"], mew=1.5, zorder=6)
        for key, value in zip("abcd", sections, strict=True):
            _section(panels[key], value, EXTENT, named=False)
            panels[key].set_title(f"r2 = {value:.4g} d2", loc="left")
        drawing.suptitle(title, x=0.01, ha="left", fontsize=10.5, color=COLOURS["ink"])
        handles: list[Any] = [Patch(fc=COLOURS[name], ec=COLOURS["muted"]) for name in ("paper", "fill", "fill_deep")]
        handles.append(Line2D([], [], color=COLOURS["muted"], ls="dotted"))
        texts = ["no cusp: not cuspidal", "2 cusps", "4 cusps", "node surfaces E1, E2, E3"]
        drawing.legend(handles, texts, loc="outside lower left", ncols=4, frameon=False, fontsize=8.5)
    return drawing


def _marked(lengths: Sequence[float] | None) -> tuple[Array | None, float, float, str]:
    """Where a design is marked, its section, the extent that shows it, and the title."""
    if lengths is None or not lengths[0] > 0.0:
        return None, 1.0, EXTENT, "Five domains of orthogonal 3R arms: cuspidal in domains 2, 3 and 4"
    d2, d3, d4, r2 = (abs(float(value)) for value in lengths)
    number = int(classify_orthogonal_3r(d2, d3, d4, r2))
    where = f"lies in domain {number}: {CUSPS[number - 1]} cusps" if number else "lies on a surface between domains"
    title = f"d2 = {lengths[0]:g}, d3 = {lengths[1]:g}, d4 = {lengths[2]:g}, r2 = {lengths[3]:g} m {where}"
    mark = np.array([d3, d4]) / d2
    return mark, r2 / d2, max(EXTENT, 1.25 * float(mark.max())), title


def _section(axes: Axes, ratio: float, extent: float, named: bool) -> None:
    """One section, shaded by the number of cusps, with the domains' borders and numbers."""
    values = (np.arange(GRID) + 0.5) * (extent / GRID)
    d3, d4 = np.meshgrid(values, values)
    lengths = np.stack([np.ones_like(d3), d3, d4, np.full_like(d3, max(ratio, 1e-9))], axis=-1)
    sides = np.moveaxis(evaluator("sides", ORTHOGONAL_3R)(lengths), -1, 0)
    last = (np.where(d3 > 1.0, sides[2], -1.0), np.where(d3 < 1.0, sides[2], -1.0))
    layers = (sides[0], "fill_deep"), (sides[1], "fill"), (last[0], "fill_deep"), (last[1], "paper")
    for side, colour in layers:  # each surface fills what is above it; filled outlines follow a page's colours
        axes.contourf(values, values, side, levels=[0.0, 2.0], colors=[COLOURS[colour]])
    for side in (sides[0], sides[1], *last):
        axes.contour(values, values, side, levels=[0.0], colors=COLOURS["ink"], linewidths=0.9)
    if named:
        for side in sides[3:]:
            axes.contour(
                values, values, side, levels=[0.0], colors=COLOURS["muted"], linewidths=0.8, linestyles="dotted"
            )
    domain = np.asarray(classify_orthogonal_3r(1.0, d3, d4, ratio))
    for number in range(1, 6):
        if (domain == number).any():
            row, column = _middle(domain == number)
            look: dict[str, Any] = {"ha": "center", "va": "center", "color": COLOURS["ink"]}
            axes.text(values[column], values[row], str(number), fontsize=13 if named else 9, zorder=4, **look)
    axes.set_xlim(0.0, extent)
    axes.set_ylim(0.0, extent)
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    if named:
        axes.set_xlabel("d3 / d2")
        axes.set_ylabel("d4 / d2")


def _middle(mask: Array) -> tuple[int, int]:
    """A place as far inside a region as can be."""
    from scipy.ndimage import distance_transform_edt

    depth = distance_transform_edt(np.pad(mask, 1))[1:-1, 1:-1]
    row, column = np.unravel_index(int(depth.argmax()), depth.shape)
    return int(row), int(column)
