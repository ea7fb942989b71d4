"""Paths followed at constant joint rates: one stretch by two methods, whole paths, and distributions of many."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.following import Followed
from chainrule.following_compared import Comparison, Study
from chainrule.paths import Path, arc_frame, arc_locate
from chainrule.plot.style import COLOURS, WIDTH, styled
from chainrule.skeleton import skeleton
from chainrule.stretches import Method
from chainrule.tables import readable

Array = NDArray[Any]

#: How each method is called and drawn: line style and width keep them apart in grey too.
NAMES: dict[Method, str] = {
    "pseudoinverse": "pseudoinverse",
    "speed_ratio": "speed ratio",
    "two_term": "two-term rule",
    "look_ahead": "looking ahead",
}
_LINES: dict[Method, dict[str, Any]] = {
    "pseudoinverse": {"color": COLOURS["muted"], "lw": 1.6, "ls": (0, (4, 2))},
    "speed_ratio": {"color": COLOURS["link"], "lw": 1.8, "ls": "-"},
    "two_term": {"color": COLOURS["joint"], "lw": 1.6, "ls": (0, (6, 1.5, 1.5, 1.5))},
    "look_ahead": {"color": COLOURS["accent"], "lw": 1.8, "ls": "-"},
}


def _millimetres(value: float) -> str:
    return f"{readable(round(1000.0 * value, 6), 3)} mm" if value < 0.1 else f"{readable(value, 3)} m"


def _arm(axes: Axes, arm: Arm, q: Array) -> None:
    """The arm, lightly, so that the paths stand out."""
    bones = skeleton(arm, q)
    line = np.vstack([np.zeros(3), bones.points, bones.tip])[:, :2]
    axes.plot(*line.T, color=COLOURS["line"], lw=4.5, solid_capstyle="round", solid_joinstyle="round", zorder=1)
    axes.plot(*bones.points[:, :2].T, "o", ms=6, mfc=COLOURS["paper"], mec=COLOURS["line"], mew=1.6, zorder=1.1)


# ---- one stretch -----------------------------------------------------------------------------------------------


def draw_stretches(
    arm: Arm, q: Any, tangent: Any, curvature: float, found: Comparison, title: str | None = None
) -> Figure:
    """Paths made from one posture until the tolerance is reached, with their curvature centres, and their offsets.

    Above, the arm at ``q``, the desired arc and its band, and each method's path with its curvature centre; below, the
    distance from the arc over the arc length. ``found`` is :func:`chainrule.following_compared.compare` of the same
    posture.
    """
    q, direction = np.asarray(q, float), np.asarray(tangent, float)
    direction = direction / np.hypot(*direction)
    start = np.asarray(arm.position(q))
    with styled():
        drawing = Figure(figsize=(WIDTH, 6.7), layout="constrained")
        above, below = drawing.subplots(2, 1, height_ratios=[2.5, 1.0])
        _arm(above, arm, q)
        longest = float(found.travel.max())
        bend = np.float64(curvature)
        s = np.linspace(-0.06 * longest, 1.12 * longest, 400)
        arc = arc_frame(start, direction, bend, s)
        normal = np.stack([-arc.tangent[:, 1], arc.tangent[:, 0]], axis=1)
        band = np.vstack([arc.point + found.tolerance * normal, (arc.point - found.tolerance * normal)[::-1]])
        above.fill(*band.T, color=COLOURS["fill"], zorder=1.5, lw=0)
        above.plot(*arc.point.T, color=COLOURS["ink"], lw=0.9, zorder=2, label="desired, with tolerance")
        if curvature != 0.0:
            _centre(above, start + np.array([-direction[1], direction[0]]) / curvature, COLOURS["ink"], "+", "desired")
        below.axhspan(-found.tolerance, found.tolerance, color=COLOURS["fill"], lw=0, zorder=0)
        below.axhline(0.0, color=COLOURS["ink"], lw=0.9, zorder=1)
        for k, method in enumerate(found.methods):
            t = np.linspace(0.0, float(found.duration[k]), 300)
            points = np.asarray(arm.position(q + found.rates[k] * t[:, None]))
            guess = np.linspace(0.0, float(found.travel[k]), len(t))
            along, offset, _ = arc_locate(start, direction, bend, points, guess)
            style = _LINES[method]
            label = f"{NAMES[method]}: {_millimetres(float(found.travel[k]))}"
            above.plot(*points.T, **style, zorder=3, label=label)
            above.plot(*points[-1], "o", ms=4.5, color=style["color"], zorder=3.5)
            below.plot(along, offset, **style, zorder=3)
            below.plot(along[-1], offset[-1], "o", ms=4.5, color=style["color"], zorder=3.5, clip_on=False)
            own = float(found.curvature[k])
            if abs(own) > max(0.1 * abs(curvature), 1e-9):
                centre = start + np.array([-direction[1], direction[0]]) / own
                _centre(above, centre, style["color"], "x" if method == "speed_ratio" else "o", NAMES[method])
        above.plot(*start, "o", ms=6, color=COLOURS["ink"], zorder=4)
        above.set_aspect("equal", adjustable="datalim")
        handles, labels = above.get_legend_handles_labels()
        order = sorted(range(len(labels)), key=lambda k: labels[k].startswith("centre"))  # paths left, centres right
        above.legend(
            [handles[k] for k in order],
            [labels[k] for k in order],
            frameon=False,
            fontsize=9,
            ncols=2,
            loc="upper center",
            bbox_to_anchor=(0.45, -0.14),
            handlelength=2.6,
        )
        above.set_title(title or _stretch_finding(found), loc="left")
        for axes, x, y in ((above, "x [m]", "y [m]"), (below, "arc length of the desired path [m]", "offset [m]")):
            axes.set_xlabel(x)
            axes.set_ylabel(y)
            axes.spines[["top", "right"]].set_visible(False)
        below.set_xlim(0.0, 1.04 * longest)
        below.set_ylim(-1.25 * found.tolerance, 1.25 * found.tolerance)
    return drawing


def _centre(axes: Axes, at: Array, colour: str, marker: str, whose: str) -> None:
    filled: dict[str, Any] = {"mfc": "none"} if marker == "o" else {}
    axes.plot(*at, marker, ms=8, mew=1.4, color=colour, zorder=4, label=f"centre, {whose}", **filled)


def _stretch_finding(found: Comparison) -> str:
    if not {"speed_ratio", "pseudoinverse"} <= set(found.methods):
        return f"Until the tip is {_millimetres(found.tolerance)} from the arc"
    ratio = float(found.ratio("speed_ratio"))
    how = "met" if found.discriminant >= 0.0 else "out of reach"
    return (
        f"Curvature {how}: the speed ratio goes {ratio:.2f} times as\n"
        f"far as the pseudoinverse until {_millimetres(found.tolerance)} off"
    )


# ---- whole paths -----------------------------------------------------------------------------------------------


def draw_following(arm: Arm, path: Path, runs: Sequence[Followed], title: str | None = None) -> Figure:
    """A path with the places of the updates, and below, for each method, the tip's distance from the path along it."""
    with styled():
        count = len(runs)
        drawing = Figure(figsize=(WIDTH, 3.7 + 0.78 * count), layout="constrained")
        grid = drawing.add_gridspec(1 + count, 1, height_ratios=[3.6, *[0.72] * count])
        above = drawing.add_subplot(grid[0])
        begun = [run for run in runs if len(run.q)]
        if begun:
            _arm(above, arm, begun[0].q[0])
        above.plot(*path.point(np.linspace(0.0, path.length, 1500)).T, color=COLOURS["ink"], lw=1.0, zorder=2)
        for run in begun:
            places = path.point(run.s[1:-1]) if len(run.s) > 2 else np.empty((0, 2))
            style = _LINES[run.method]
            if run is begun[0]:
                above.plot(*places.T, "o", ms=7, mfc=COLOURS["fill"], mec=COLOURS["muted"], mew=0.7, zorder=3)
            elif run is begun[-1]:
                above.plot(*places.T, "o", ms=3.6, color=style["color"], zorder=3.5)
        if begun:
            above.plot(*path.point(begun[0].s[0]), "D", ms=6, color=COLOURS["ink"], zorder=4)
        above.set_aspect("equal", adjustable="datalim")
        above.set_xlabel("x [m]")
        above.set_ylabel("y [m]")
        above.spines[["top", "right"]].set_visible(False)
        above.set_title(title or following_finding(runs), loc="left")
        first = None
        for k, run in enumerate(runs):
            axes = drawing.add_subplot(grid[k + 1], sharex=first)
            first = first or axes
            _offsets(axes, arm, path, run)
            axes.tick_params(labelbottom=k == count - 1)
        if first is not None:
            axes.set_xlabel("arc length of the path [m]")
            middle = drawing.axes[1 + (count - 1) // 2]
            middle.set_ylabel("offset / tolerance" if count > 2 else "offset /\ntolerance")
    return drawing


def following_finding(runs: Sequence[Followed]) -> str:
    """The runs in one sentence: who needs the fewest updates."""
    done = [run for run in runs if run.status == "finished"]
    if not done:
        return "No method reaches the end of the path"
    best, worst = min(done, key=lambda r: r.updates), max(done, key=lambda r: r.updates)
    within = f"Within {_millimetres(best.tolerance)}"
    if len(done) == 1 or best.updates == worst.updates:
        return f"{within} of the path: {best.updates} updates by {NAMES[best.method]}"
    drawn = f" (large dots; small: {NAMES[best.method]})" if best is runs[-1] and worst is runs[0] else ""
    return (
        f"{within} of the path: {best.updates} updates by {NAMES[best.method]},\n"
        f"{worst.updates} by {NAMES[worst.method]}{drawn}"
    )


def _offsets(axes: Axes, arm: Arm, path: Path, run: Followed) -> None:
    """The signed distance over the arc length, one tooth to a stretch."""
    each = 40
    style = _LINES[run.method]
    axes.axhspan(-1.0, 1.0, color=COLOURS["ground"], lw=0, zorder=0)
    axes.axhline(0.0, color=COLOURS["line"], lw=0.8, zorder=1)
    if len(run.q):
        points = np.asarray(arm.position(run.postures(each)))
        guess = run.s[:-1, None] + np.diff(run.s)[:, None] * np.linspace(0.0, 1.0, each)
        along, offset, _ = path.locate(points, guess)
        gaps = np.full((len(run.q), 1), np.nan)
        along, offset = (np.hstack([a, gaps]).ravel() for a in (along, offset / run.tolerance))
        axes.plot(along, offset, color=style["color"], lw=1.1, zorder=2)
    note = f"{run.updates} updates" if run.status == "finished" else f"{run.status} after {run.updates} updates"
    axes.text(1.0, 1.04, note, transform=axes.transAxes, ha="right", va="bottom", fontsize=9, color=COLOURS["ink"])
    name = NAMES[run.method]
    axes.text(0.0, 1.04, name, transform=axes.transAxes, ha="left", va="bottom", fontsize=9, color=COLOURS["ink"])
    axes.set_ylim(-1.15, 1.15)
    axes.yaxis.set_major_locator(FixedLocator([-1.0, 0.0, 1.0]))
    axes.spines[["top", "right"]].set_visible(False)
    axes.margins(x=0.01)


# ---- distributions ---------------------------------------------------------------------------------------------


def draw_study(studies: Sequence[Study], title: str | None = None) -> Figure:
    """Distributions of how many times as far as the pseudoinverse the speed ratio travels, one curve to a study.

    The finest line style belongs to the smallest tolerance; looking ahead is drawn for the first study.
    """
    ordered = sorted(studies, key=lambda study: -study.comparison.tolerance)
    styles = [(2.2, "-"), (1.7, (0, (5, 1.6))), (1.5, (0, (1.2, 1.2))), (1.2, (0, (6, 1.5, 1.5, 1.5)))]
    with styled():
        drawing = Figure(figsize=(WIDTH, 3.9), layout="constrained")
        axes = drawing.add_subplot()
        axes.axvspan(0.1, 1.0, color=COLOURS["ground"], lw=0, zorder=0)
        axes.axvline(1.0, color=COLOURS["muted"], lw=0.8, zorder=1)
        for study, (width, dash) in zip(ordered, styles, strict=False):
            x, y = _steps(study.comparison.ratio("speed_ratio"))
            name = _millimetres(study.comparison.tolerance)
            axes.plot(x, y, color=COLOURS["link"], lw=width, ls=dash, zorder=3, label=f"speed ratio, {name}")
        x, y = _steps(ordered[0].comparison.ratio("look_ahead"))
        name = _millimetres(ordered[0].comparison.tolerance)
        axes.plot(x, y, color=COLOURS["accent"], lw=1.6, zorder=2.5, label=f"looking ahead, {name}")
        axes.set_xscale("log")
        ticks = [0.5, 1.0, 2.0, 5.0, 10.0]
        axes.xaxis.set_major_locator(FixedLocator(ticks))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, place: readable(float(value), 3)))
        axes.set_xlim(0.4, 14.0)
        axes.set_ylim(0.0, 1.0)
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, place: f"{100.0 * value:.0f} %"))
        axes.set_xlabel("travel, as a multiple of the pseudoinverse's")
        axes.set_ylabel("share of cases below")
        axes.text(0.43, 0.97, "less far than\nthe pseudo-\ninverse", va="top", fontsize=9, color=COLOURS["muted"])
        axes.legend(frameon=False, fontsize=9, loc="lower right")
        axes.spines[["top", "right"]].set_visible(False)
        axes.set_title(title or study_finding(ordered[0]), loc="left")
    return drawing


def study_finding(study: Study) -> str:
    """A study in one sentence."""
    facts = study.to_dict()
    return (
        f"The speed ratio goes {facts['median']:.2f} times as far in the median,\n"
        f"but less far in {100.0 * facts['worse']:.0f} % of {facts['cases']} cases ({_millimetres(facts['tolerance'])})"
    )


def _steps(ratio: Array) -> tuple[Array, Array]:
    values = np.sort(ratio[np.isfinite(ratio)])
    return values, (np.arange(len(values)) + 1.0) / max(len(values), 1)
