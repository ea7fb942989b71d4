"""Manipulability over two joints, with its maximum."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from chainrule.arm import Arm
from chainrule.manipulability import ManipulabilityMap
from chainrule.plot.style import COLOURS, FIELD, figure, styled
from chainrule.tables import posture, readable


def finding(arm: Arm, found: ManipulabilityMap) -> str:
    """The map in one sentence: how large H gets, and where."""
    where = posture(arm, found.maximum.q, found.joints)
    return f"H is largest, {found.maximum.value:.4g}{found.unit.suffix}, at {where}"


def singular_note(arm: Arm, found: ManipulabilityMap) -> str:
    """Whether the map meets a singularity: its smallest value, refined off the grid."""
    if found.minimum.value > 1e-7 * found.maximum.value:
        return f"and nowhere below {readable(found.minimum.value, 2)}{found.unit.suffix}"
    points = [found.minimum.q, *found.minimum.others]
    if all(arm.kinds[j] == "R" for j in found.joints) and all(
        abs(np.sin(q[j])) < 1e-6 for q in points for j in found.joints
    ):
        return "zero where both are 0° or 180°"
    where = posture(arm, found.minimum.q, found.joints)
    return f"zero at {where}" + (" among others" if len(points) > 1 else "")


def draw_map(arm: Arm, found: ManipulabilityMap, title: str | None = None) -> Figure:
    """The map as filled contours; the maxima are marked by rings.

    The title states the finding; the axes carry degrees for revolute joints and metres for prismatic ones.
    """
    i, j = found.joints
    scale = [180.0 / np.pi if arm.kinds[k] == "R" else 1.0 for k in (i, j)]
    x, y = found.first * scale[0], found.second * scale[1]
    with styled():
        drawing, axes = figure(4.3)
        top = found.maximum.value
        levels = np.linspace(0.0, top if top > 0 else 1.0, 13)
        field = axes.contourf(x, y, found.H.T, levels=levels, cmap=FIELD, extend="neither")
        axes.contour(x, y, found.H.T, levels=levels[1:-1:2], colors="white", linewidths=0.5, alpha=0.55)
        for q in [found.maximum.q, *found.maximum.others]:
            axes.plot(q[i] * scale[0], q[j] * scale[1], "o", ms=9, mfc="none", mec="white", mew=2.6, clip_on=False)
            axes.plot(
                q[i] * scale[0], q[j] * scale[1], "o", ms=9, mfc="none", mec=COLOURS["accent"], mew=1.4, clip_on=False
            )
        for set_label, k in ((axes.set_xlabel, i), (axes.set_ylabel, j)):
            set_label(f"q{k + 1} [{'deg' if arm.kinds[k] == 'R' else 'm'}]")
        _degree_ticks(axes, arm, (i, j))
        axes.set_title(title or f"{finding(arm, found)},\n{singular_note(arm, found)}", loc="left")
        bar = drawing.colorbar(field, ax=axes, shrink=0.95, pad=0.02, aspect=28)
        bar.outline.set_visible(False)
        bar.set_label(f"H [{found.unit.text}]" if not found.unit.mixed else f"H (terms in {found.unit.text})")
        bar.ax.yaxis.set_major_formatter(lambda value, place: f"{value:.3g}")
        axes.spines[:].set_visible(False)
    return drawing


def _degree_ticks(axes: object, arm: Arm, pair: tuple[int, int]) -> None:
    from matplotlib.axes import Axes
    from matplotlib.ticker import MultipleLocator

    assert isinstance(axes, Axes)
    for axis, k in ((axes.xaxis, pair[0]), (axes.yaxis, pair[1])):
        if arm.kinds[k] == "R":
            low, high = sorted(axis.get_view_interval())
            step = next(s for s in (15, 30, 45, 90, 180, 360, 1e9) if (high - low) / s <= 9)
            axis.set_major_locator(MultipleLocator(step))
