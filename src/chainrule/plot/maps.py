"""Manipulability over two joints, with its maximum; and the postures in which it is largest."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.manipulability import ManipulabilityMap, Maximum
from chainrule.plot.style import COLOURS, FIELD, WIDTH, figure, styled
from chainrule.skeleton import Skeleton, skeleton
from chainrule.tables import posture, readable

Array = NDArray[Any]


def finding(arm: Arm, found: ManipulabilityMap) -> str:
    """The map in one sentence: how large H gets, and where."""
    where = posture(arm, found.maximum.q, found.joints)
    return f"H is largest, {found.maximum.value:.4g}{found.unit.suffix}, at {where}"


def singular_note(arm: Arm, found: ManipulabilityMap) -> str:
    """Whether the map meets a singularity: its smallest value, refined off the grid."""
    if found.minimum.value > 1e-7 * found.maximum.value:
        return f"and nowhere below {readable(found.minimum.value, 2)}{found.unit.suffix}"
    if found.determinant is not None:
        return "zero along the dashed lines"
    points = [found.minimum.q, *found.singular]
    if all(arm.kinds[j] == "R" for j in found.joints) and all(
        abs(np.sin(q[j])) < 1e-6 for q in points for j in found.joints
    ):
        return "zero where both are 0° or 180°"
    where = posture(arm, found.minimum.q, found.joints)
    return f"zero at {where}" + (" among others" if len(found.singular) > 1 else "")


def draw_map(arm: Arm, found: ManipulabilityMap, title: str | None = None) -> Figure:
    """The map as filled contours with level lines: rings at the maxima, crosses or dashed lines where H is zero.

    The title states the finding; the axes carry degrees for revolute joints and metres for prismatic ones.

    Example:
        >>> from chainrule import planar_3r
        >>> from chainrule.manipulability import manipulability_map
        >>> arm = planar_3r(1.0, 0.5, 0.25)
        >>> len(draw_map(arm, manipulability_map(arm, size=31)).axes)      # the map and its scale
        2
    """
    i, j = found.joints
    scale = np.array([180.0 / np.pi if arm.kinds[k] == "R" else 1.0 for k in (i, j)])
    x, y = found.first * scale[0], found.second * scale[1]
    with styled():
        drawing, axes = figure(4.5)
        top = max(found.maximum.value, float(found.H.max()))
        levels = np.linspace(0.0, top * (1 + 1e-12) if top > 0 else 1.0, 25)
        field = axes.contourf(x, y, found.H.T, levels=levels, cmap=FIELD, extend="neither")
        axes.contour(x, y, found.H.T, levels=levels[1:-1], colors="white", linewidths=0.35, alpha=0.5)
        if found.determinant is not None and found.minimum.value <= 1e-7 * top:
            lines = axes.contour(x, y, found.determinant.T, levels=[0.0], colors="white", linewidths=1.3)
            lines.set_linestyle((0, (4, 2.5)))
        for point in _copies(arm, found.singular, (i, j), found):
            _mark(axes, point * scale, "x", 7, COLOURS["paper"], 1.6)
        for point in _copies(arm, np.array([found.maximum.q, *found.maximum.others]), (i, j), found):
            _mark(axes, point * scale, "o", 10, COLOURS["accent"], 1.7)
        for set_label, k in ((axes.set_xlabel, i), (axes.set_ylabel, j)):
            set_label(f"q{k + 1} [{'deg' if arm.kinds[k] == 'R' else 'm'}]")
        axes.set_xlim(x[0], x[-1])
        axes.set_ylim(y[0], y[-1])
        _degree_ticks(axes, arm, (i, j))
        axes.set_title(title or f"{finding(arm, found)},\n{singular_note(arm, found)}", loc="left")
        bar = drawing.colorbar(field, ax=axes, shrink=0.95, pad=0.02, aspect=28, ticks=levels[::4])
        bar.outline.set_visible(False)
        bar.set_label(f"H [{found.unit.text}]" if not found.unit.mixed else f"H (terms in {found.unit.text})")
        bar.ax.yaxis.set_major_formatter(lambda value, place: f"{value:.3g}")
        axes.spines[:].set_visible(False)
    return drawing


def _mark(axes: Axes, at: Array, marker: str, size: float, colour: str, width: float) -> None:
    """A mark with a rim that sets it off from light and dark ground."""
    rim = COLOURS["paper"] if colour != COLOURS["paper"] else COLOURS["ink"]
    for line, edge in ((width + 1.6, rim), (width, colour)):
        axes.plot(*at, marker, ms=size, mfc="none", mec=edge, mew=line, clip_on=False, zorder=5)


def _copies(arm: Arm, points: Array, pair: tuple[int, int], found: ManipulabilityMap) -> list[Array]:
    """Where configurations are on the map: angles also a whole turn on, where that is at its edge."""
    ranges = ((found.first[0], found.first[-1]), (found.second[0], found.second[-1]))
    turns = [(-1, 0, 1) if arm.kinds[k] == "R" else (0,) for k in pair]
    moved = [q[list(pair)] + 2 * np.pi * np.array(turn) for q in points for turn in product(*turns)]
    inside = [p for p in moved if all(low - 1e-6 <= v <= high + 1e-6 for v, (low, high) in zip(p, ranges, strict=True))]
    return [np.array([np.clip(v, *ends) for v, ends in zip(p, ranges, strict=True)]) for p in inside]


def _degree_ticks(axes: Axes, arm: Arm, pair: tuple[int, int]) -> None:
    from matplotlib.ticker import MultipleLocator

    for axis, k in ((axes.xaxis, pair[0]), (axes.yaxis, pair[1])):
        if arm.kinds[k] == "R":
            low, high = sorted(axis.get_view_interval())
            step = next(s for s in (5, 10, 15, 30, 60, 90, 180, 360, 1e9) if (high - low) / s <= 6)
            axis.set_major_locator(MultipleLocator(step))


def draw_optima(arm: Arm, largest: Maximum, title: str | None = None) -> Figure:
    """The postures in which H is largest, drawn over each other, of an arm in the plane; at most four of them.

    Joints that H does not depend on are in the middle of their range: the first heading is arbitrary for most tasks.

    Raises:
        InputError: an arm in space.

    Example:
        >>> from chainrule import planar_3r
        >>> from chainrule.manipulability import max_manipulability
        >>> arm = planar_3r(1.0, 0.5, 0.25)
        >>> draw_optima(arm, max_manipulability(arm)).axes[0].get_xlabel()
        'x [m]'
    """
    if "x_alpha" not in arm.tasks:
        raise InputError(f"{arm.name} moves in space; postures are drawn over each other for planar arms")
    postures = [largest.q, *largest.others][:4]
    bones = [skeleton(arm, q) for q in postures]
    with styled():
        drawing, axes = figure(WIDTH)
        for number, (q, bone) in enumerate(zip(postures, bones, strict=True)):
            _draw_links(axes, arm, bone, number, posture(arm, q))
        points = np.vstack([[*b.points[:, :2], b.tip[:2], (0.0, 0.0)] for b in bones])
        middle, extent = (points.max(axis=0) + points.min(axis=0)) / 2, np.ptp(points, axis=0)
        half = np.maximum(0.58 * extent, 0.2 * float(extent.max()) or 1.0)
        axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
        axes.set_ylim(middle[1] - half[1], middle[1] + half[1])
        axes.set_aspect("equal")
        tall = min(max(half[1] / half[0], 0.3), 1.0)
        drawing.set_size_inches(WIDTH, 4.2 * tall + 1.1 + 0.22 * len(postures))
        axes.grid(color=COLOURS["line"], lw=0.5, alpha=0.7)
        axes.set_axisbelow(True)
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.set_title(title or _optima_title(largest, len(postures)), loc="left")
        drawing.legend(loc="outside lower center", frameon=False, fontsize=9, ncols=1, handlelength=2.8)
    return drawing


#: Colour and line style of each posture: told apart by lightness and dashes as well.
_POSTURES = (
    (COLOURS["accent"], "-"),
    (COLOURS["link"], (0, (3.2, 1.4))),
    (COLOURS["joint"], (0, (1.2, 1.0))),
    (COLOURS["muted"], (0, (5, 1, 1, 1))),
)


def _draw_links(axes: Axes, arm: Arm, bones: Skeleton, number: int, label: str) -> None:
    colour, dashes = _POSTURES[number]
    path = np.vstack([[0.0, 0.0], bones.points[:, :2], bones.tip[:2]])
    line: Any = dashes
    axes.plot(*path.T, color=colour, lw=4.5 - 0.6 * number, ls=line, solid_capstyle="round", zorder=3, label=label)
    for point, kind in zip(bones.points, arm.kinds, strict=True):
        marker = "o" if kind == "R" else "s"
        axes.plot(*point[:2], marker, ms=8, mfc=COLOURS["paper"], mec=colour, mew=2.0, zorder=4)
    axes.plot(*bones.tip[:2], "o", ms=6, color=colour, zorder=5)


def _optima_title(largest: Maximum, drawn: int) -> str:
    sure = "proved to be the global maximum" if largest.proved else "the largest that was found"
    count = len(largest.others) + 1
    several = "one posture" if count == 1 else f"{count} postures" + (f" ({drawn} are drawn)" if drawn < count else "")
    return f"H = {readable(largest.value)} in {several},\n{sure}"
