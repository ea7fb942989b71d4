"""Paths followed with spare joints: one run on a sheet, several runs compared, and gains and steps that go together."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.plot.arm import even, links, seen_from
from chainrule.plot.style import COLOURS, FIELD, WIDTH, line_look, styled
from chainrule.redundancy.result import Run
from chainrule.redundancy.words import (
    comparison_finding,
    finding,
    left_at,
    masses,
    rate_unit,
    rounded,
    setup,
    torque_unit,
)
from chainrule.tables import readable

Array = NDArray[Any]

#: Faint postures between the beginning and the end of a path.
BETWEEN = 6
#: From this ratio of the largest to the smallest value on, a scale is logarithmic.
SPAN = 30.0
#: Characters that fit beside each other below a sheet.
LEGEND = 116
#: The tip's axes and place, in the order of a run's frame errors.
FRAME = ("n (x axis)", "o (y axis)", "a (z axis)", "p [m]")


def draw_run(run: Run, title: str | None = None) -> Figure:
    """One run on a sheet: the arm along the path, det J Jᵀ, rates, accelerations, torques, and errors n, o, a, p.

    Where the arm has no inertias, the motion in the null space of J stands in the torques' place; where it has, the
    masses are named.

    Args:
        run: a path followed.
        title: :func:`chainrule.redundancy.words.finding` when absent.
    """
    arm = run.arm
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.75, WIDTH * 1.8), layout="constrained")
        (picture, height), (rates, accelerations), (torques, errors) = drawing.subplots(3, 2)
        draw_postures(picture, run)
        _determinant(height, run)
        _joints(rates, run, run.rates, f"joint rates [{rate_unit(arm)}]")
        _joints(accelerations, run, run.accelerations, f"joint accelerations [{rate_unit(arm, 's²')}]")
        if run.torque is not None:
            _joints(torques, run, run.torque, f"torques [{torque_unit(arm)}]\n{masses(arm)}")
        else:
            _joints(torques, run, run.null_motion, f"rates that leave the tip at rest [{rate_unit(arm)}]")
        _errors(errors, run)
        for axes in (height, rates, accelerations, torques, errors):
            axes.set_xlabel("time [s]")
        drawing.legend(
            handles=[Line2D([], [], lw=1.6, label=f"q{j + 1}", **line_look(j)) for j in range(arm.n)],
            ncols=min(arm.n, 10),
            frameon=False,
            loc="outside lower center",
            handlelength=2.6,
        )
        _title(drawing, title or f"{finding(run)}.", setup(run))
    return drawing


def _title(drawing: Figure, text: str, below: str = "") -> None:
    """A finding over a sheet, and how it was made."""
    width = int(13.5 * drawing.get_figwidth())
    lines = [fill(text, width), *([fill(below, width)] if below else [])]
    drawing.suptitle("\n".join(lines), x=0.012, ha="left", fontsize=10.5, color=COLOURS["ink"], linespacing=1.35)


# ---- panels ------------------------------------------------------------------------------------------------------


def draw_postures(axes: Axes, run: Run, marks: Sequence[int] | None = None) -> None:
    """The arm along the path: at its beginning, at its end, and where it is nearest to a singularity.

    Args:
        axes: where to draw.
        run: a path followed.
        marks: instead, the samples at which the arm is drawn, in a colour of its own each.
    """
    arm, view = run.arm, seen_from(run.arm)
    last = len(run.t) - 1
    tips = np.asarray(arm.position(run.q))
    tips = np.pad(tips, [(0, 0), (0, 3 - tips.shape[1])]) @ view.T
    if marks is None:
        nearest = int(run.manipulability.argmin())
        chosen = {0: "link", last: "muted"} | {nearest: "accent"}
        for k in np.linspace(0, last, BETWEEN + 2).astype(int)[1:-1]:
            axes.plot(*(links(arm, run.q[k]) @ view.T).T, color=COLOURS["line"], lw=1.4, zorder=1.5)
    else:
        chosen = dict(zip(marks, ("link", "joint", "accent", "muted"), strict=False))
        nearest = -1
    dashes = {"muted": (0, (4, 1.4)), "joint": (0, (6, 1.2, 1.2, 1.2)), "accent": (0, (1.4, 0.5))}
    for k, colour in sorted(chosen.items()):
        line = links(arm, run.q[k]) @ view.T
        name = f"{readable(float(run.t[k]), 3)} s" + (", least H" if k == nearest else "")
        look: dict[str, Any] = {"color": COLOURS[colour], "ls": dashes.get(colour, "-"), "label": name}
        axes.plot(*line.T, lw=3.0, solid_capstyle="round", zorder=3, **look)
        axes.plot(*line[1:-1].T, "o", ms=4.5, mfc=COLOURS["paper"], mec=COLOURS[colour], mew=1.4, zorder=3.1)
    axes.plot(*tips.T, color=COLOURS["ink"], lw=1.2, zorder=4)
    axes.plot(*tips[0], "o", ms=5.5, color=COLOURS["ink"], zorder=4.1)
    axes.plot(*tips[-1], "D", ms=5.5, mfc=COLOURS["paper"], mec=COLOURS["ink"], mew=1.4, zorder=4.1)
    axes.plot(0.0, 0.0, "s", ms=7, color=COLOURS["ink"], zorder=4)
    even(axes, arm)
    if "x_alpha" not in arm.tasks:
        _scale(axes, view)
    box = axes.dataLim
    axes.update_datalim([(box.x0 - 0.3 * max(box.width, box.height), box.y0)])  # room for the legend
    axes.autoscale_view()
    axes.set_title("the arm along the path, from dot to diamond", loc="left")
    axes.legend(frameon=False, fontsize=8.5, loc="upper left", handlelength=2.6, borderaxespad=0.1)


def _scale(axes: Axes, view: Array) -> None:
    """The base's axes x, y, z, each of a round length that is written beside."""
    size = max(axes.dataLim.width, axes.dataLim.height)
    length = next(s * 10.0**e for e in range(4, -6, -1) for s in (5, 2, 1) if s * 10.0**e <= 0.3 * size or e == -5)
    for k, letter in enumerate("xyz"):
        end = length * view[:, k]
        axes.plot([0.0, end[0]], [0.0, end[1]], color=COLOURS[f"axis_{letter}"], lw=1.4, zorder=2)
        axes.annotate(
            letter,
            (float(end[0]), float(end[1])),
            (3, 3),
            textcoords="offset points",
            color=COLOURS[f"axis_{letter}"],
            fontsize=9,
        )
    axes.annotate(
        f"axes: {readable(length)} m",
        (1.0, 0.0),
        xycoords="axes fraction",
        ha="right",
        va="bottom",
        fontsize=8.5,
        color=COLOURS["muted"],
    )


def _plain(axes: Axes, run: Run) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlim(float(run.t[0]), float(run.t[-1]) if len(run.t) > 1 else float(run.t[0]) + 1.0)


def _scaled(axes: Axes, values: Array, span: float = SPAN, peaks: Array | None = None) -> None:
    """A logarithmic scale where positive values (or ``peaks``) differ by more than ``span``.

    It goes down to a millionth of the largest value; with ``peaks`` to a hundredth of the least of them.
    """
    above = values[np.isfinite(values) & (values > 0.0)]
    judged = above if peaks is None else peaks[peaks > 0.0]
    if not judged.size or float(judged.max()) <= span * float(judged.min()):
        axes.set_ylim(0.0, 1.1 * float(above.max(initial=0.0)) or 1.0)
        return
    high = float(above.max())
    axes.set_yscale("log")
    least = 1e-6 * high if peaks is None else 1e-2 * float(judged.min())
    axes.set_ylim(max(float(above.min()), least) / 1.5, 1.5 * high)
    axes.yaxis.set_major_locator(LogLocator(numticks=7))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, place: _power(value)))


def _power(value: float) -> str:
    """A power of ten as it is written by hand.

    >>> _power(1e-5)
    '10⁻⁵'
    """
    return "10" + str(round(math.log10(value))).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def _determinant(axes: Axes, run: Run) -> None:
    _plain(axes, run)
    axes.plot(run.t, run.determinant, color=COLOURS["link"], lw=1.8)
    nearest = int(run.determinant.argmin())
    _scaled(axes, run.determinant)
    lowest = max(float(run.determinant[nearest]), axes.get_ylim()[0])  # at the edge where it lies below the scale
    axes.plot(run.t[nearest], lowest, "o", ms=5.5, color=COLOURS["accent"], clip_on=False, zorder=4)
    axes.set_title(f"det J Jᵀ = H², least {readable(float(run.determinant[nearest]), 3)}", loc="left")
    told: set[str] = set()
    for event in run.events:
        if event.kind not in told:
            axes.axvline(event.t, color=COLOURS["joint"], lw=1.0, ls=(0, (2, 2)), zorder=1)
            place = 0.02 + 0.09 * len(told)
            right = event.t > 0.6 * float(run.t[-1])
            axes.annotate(
                event.kind,
                (event.t, place),
                (-4 if right else 4, 0),
                xycoords=("data", "axes fraction"),
                textcoords="offset points",
                ha="right" if right else "left",
                fontsize=8.5,
                color=COLOURS["muted"],
                bbox={"boxstyle": "round,pad=0.1", "fc": COLOURS["paper"], "ec": "none", "alpha": 0.8},
                zorder=3,
            )
            told.add(event.kind)


def _joints(axes: Axes, run: Run, values: Array, title: str) -> None:
    """One line for each joint."""
    _plain(axes, run)
    axes.axhline(0.0, color=COLOURS["line"], lw=0.8, zorder=0)
    for j in range(run.arm.n):
        axes.plot(run.t, values[:, j], lw=1.4, **line_look(j))
    axes.yaxis.set_major_locator(MaxNLocator(6))
    axes.set_title(title, loc="left")


def _errors(axes: Axes, run: Run) -> None:
    """By how much the axes and the place of the tip miss those of the target."""
    _plain(axes, run)
    shown = [k for k in range(4) if np.nanmax(run.frame_errors[:, k], initial=0.0) > 0.0]
    for k in shown:
        axes.plot(run.t, run.frame_errors[:, k], lw=1.5, label=FRAME[k], **line_look(k))
    _scaled(axes, run.frame_errors, span=1.0)
    axes.set_title("errors of the tip's axes and place", loc="left")
    if shown:
        axes.legend(frameon=False, fontsize=8.5, ncols=2, loc="lower right", handlelength=2.4)


# ---- several runs ------------------------------------------------------------------------------------------------


def draw_runs(runs: Mapping[str, Run], title: str | None = None) -> Figure:
    """Several runs of one path: det J Jᵀ, the fastest joint, the largest torque and the tip's error over time.

    Where the arm has no inertias, the fastest acceleration stands in the torques' place.

    Args:
        runs: the runs, by what each is to be called.
        title: :func:`chainrule.redundancy.words.comparison_finding` when absent.
    """
    first = next(iter(runs.values()))
    arm = first.arm
    with_torque = all(run.torque is not None for run in runs.values())
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.75, WIDTH * 1.3), layout="constrained")
        (height, rate), (third, error) = drawing.subplots(2, 2)
        panels = [
            (height, [run.determinant for run in runs.values()], "det J Jᵀ = H²"),
            (rate, [np.abs(run.rates).max(axis=1) for run in runs.values()], f"fastest joint [{rate_unit(arm)}]"),
            (third, _third(runs, with_torque), _third_title(arm, with_torque)),
            (
                error,
                [1000.0 * np.linalg.norm(run.position_error, axis=1) for run in runs.values()],
                "tip's distance from its target [mm]",
            ),
        ]
        longest = max(runs.values(), key=lambda run: float(run.t[-1]))
        for axes, values, name in panels:
            _plain(axes, longest)
            for k, (run, line) in enumerate(zip(runs.values(), values, strict=True)):
                axes.plot(run.t, line, lw=1.7, zorder=3 + 0.1 * k, **line_look(k))
                if run.status != "complete":
                    axes.plot(run.t[-1], line[-1], "x", ms=7, mew=1.8, color=line_look(k)["color"], clip_on=False)
            peaks = np.array([line.max() for line in values]) if axes in (rate, third) else None
            _scaled(axes, np.concatenate(values), peaks=peaks)
            axes.set_title(name, loc="left")
            axes.set_xlabel("time [s]")
        names = [name + _ending(run) for name, run in runs.items()]
        drawing.legend(
            handles=[Line2D([], [], lw=1.7, label=name, **line_look(k)) for k, name in enumerate(names)],
            ncols=max(1, min(len(runs), LEGEND // (max(map(len, names)) + 8))),
            frameon=False,
            loc="outside lower left",
            handlelength=2.8,
        )
        _title(drawing, title or f"{comparison_finding(runs)}.")
    return drawing


def _ending(run: Run) -> str:
    """What the legend adds to the name of a run that did not follow the path."""
    return " (×: stopped)" if run.status != "complete" else "" if left_at(run) is None else " (path left)"


def _third(runs: Mapping[str, Run], with_torque: bool) -> list[Array]:
    if with_torque:
        return [np.abs(run.torque).max(axis=1) for run in runs.values() if run.torque is not None]
    return [np.abs(run.accelerations).max(axis=1) for run in runs.values()]


def _third_title(arm: Arm, with_torque: bool) -> str:
    if with_torque:
        return f"largest torque [{torque_unit(arm)}]\n{masses(arm)}"
    return f"largest joint acceleration [{rate_unit(arm, 's²')}]"


# ---- many runs ---------------------------------------------------------------------------------------------------


def draw_stability(
    gains: Any, steps: Any, worst: Any, *, lost: float = 0.1, bound: Any = None, title: str | None = None
) -> Figure:
    """The worst distance of the tip from its target over gain and step; crossed out where the path is lost.

    Args:
        gains: (g,) gains, all of one sign, increasing in size.
        steps: (s,) steps of the integrator, s, increasing.
        worst: (g, s) the worst distance of the tip from its target, m; nan where a run broke off.
        lost: from this distance on the path counts as lost, m.
        bound: (s,) the largest stable gain as estimated beforehand, of the sign of ``gains``; left out when absent.
        title: :func:`stability_finding` when absent.

    Example:
        >>> drawn = draw_stability([-1.0, -10.0], [0.001, 0.01], [[0.001, 0.01], [0.002, 0.9]])
        >>> drawn.axes[0].get_title(loc="left")
        'The path is followed with gains down to −10 at a step of 1 ms, −1 at 10 ms'
    """
    gains, steps, worst = (np.asarray(values, float) for values in (gains, steps, worst))
    failed = ~(worst < lost)
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.3, WIDTH * 0.95), layout="constrained")
        axes = drawing.add_subplot()
        colours = np.where(failed, np.nan, np.log10(np.where(failed, lost, np.maximum(worst, 1e-12))))
        x, y = (np.concatenate(_edges(np.abs(values))) for values in (steps, gains))
        mesh = axes.pcolormesh(1000.0 * x, y, colours, cmap=FIELD, shading="flat", rasterized=False)
        rows, columns = np.nonzero(failed)
        axes.plot(1000.0 * steps[columns], np.abs(gains[rows]), "x", ms=5, mew=1.2, color=COLOURS["accent"])
        if bound is not None:
            curve = np.abs(np.asarray(bound, float))
            axes.plot(1000.0 * steps, curve, color=COLOURS["paper"], lw=3.6)
            axes.plot(1000.0 * steps, curve, color=COLOURS["ink"], lw=1.8, ls=(0, (5, 1.6)), label="estimated bound")
            axes.legend(frameon=True, facecolor=COLOURS["paper"], edgecolor="none", fontsize=8.5, loc="lower left")
        for name in "xy":
            getattr(axes, f"set_{name}scale")("log")
            getattr(axes, f"{name}axis").set_minor_locator(NullLocator())
        axes.set_xlim(1000.0 * x[0], 1000.0 * x[-1])
        axes.set_ylim(y[0], y[-1])
        axes.set_xticks(1000.0 * steps, [readable(rounded(1000.0 * step, 3)) for step in steps])
        marks = [s * 10.0**e for e in range(-4, 7) for s in (1, 3) if y[0] <= s * 10.0**e <= y[-1]]
        sign = "−" if gains.size and gains[0] < 0.0 else ""
        axes.set_yticks(marks, [sign + readable(mark) for mark in marks])
        axes.set_xlabel("step [ms]")
        axes.set_ylabel("gain")
        bar: Any = drawing.colorbar(mesh, ax=axes, pad=0.02, aspect=28)
        bar.outline.set_visible(False)
        bar.ax.yaxis.set_major_locator(MaxNLocator(integer=True))
        bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, place: _power(10.0**value)))
        bar.set_label(f"worst distance from the target [m]; ×: {readable(lost)} m or more")
        axes.set_title(fill(title or stability_finding(gains, steps, failed), 78), loc="left")
    return drawing


def _edges(values: Array) -> tuple[Array, Array, Array]:
    """Between increasing positive values and around them, evenly on a logarithmic scale."""
    middle = np.sqrt(values[1:] * values[:-1])
    first, last = (middle[:1], middle[-1:]) if middle.size else (values / 1.5, values * 1.5)
    low = values[:1] ** 2 / first if middle.size else first
    high = values[-1:] ** 2 / last if middle.size else last
    return low, middle, high


def stability_finding(gains: Any, steps: Any, failed: Any) -> str:
    """Up to which gain no run loses the path, at the smallest step and at the largest."""
    gains, steps, failed = np.asarray(gains, float), np.asarray(steps, float), np.asarray(failed, bool)

    def up_to(column: Array) -> str:
        good = int(np.argmax(column)) if column.any() else len(column)
        return "none" if good == 0 else readable(rounded(float(gains[good - 1]), 3))

    word = "down to" if gains[0] < 0.0 else "up to"
    first, last = up_to(failed[:, 0]), up_to(failed[:, -1])
    ends = [readable(rounded(1000.0 * float(step), 3)) for step in (steps[0], steps[-1])]
    return f"The path is followed with gains {word} {first} at a step of {ends[0]} ms, {last} at {ends[1]} ms"


def draw_population(
    without: Any, with_gain: Any, names: tuple[str, str], marked: Mapping[str, tuple[float, float]], title: str
) -> Figure:
    """The least H of many runs without a gain and with one: above the line the gain keeps clear of singularities.

    Args:
        without: (k,) least H of each run without a gain.
        with_gain: (k,) of the same starts with it.
        names: what the two are called.
        marked: single starts to be named, each with both values.
        title: the finding.
    """
    x, y = np.asarray(without, float), np.asarray(with_gain, float)
    better = y > x
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.2, WIDTH * 1.05), layout="constrained")
        axes = drawing.add_subplot()
        axes.plot(x[better], y[better], ".", ms=2.6, color=COLOURS["link"], label=f"gain: {int(better.sum())} starts")
        axes.plot(
            x[~better], y[~better], "x", ms=3.0, mew=0.8, color=COLOURS["joint"], label=f"lose: {int((~better).sum())}"
        )
        both = np.concatenate([x, y])
        low, high = float(both[both > 0.0].min()) / 1.3, float(both.max()) * 1.3
        axes.plot([low, high], [low, high], color=COLOURS["ink"], lw=1.0)
        for name, (first, second) in marked.items():
            axes.plot(first, second, "D", ms=7, mfc=COLOURS["paper"], mec=COLOURS["accent"], mew=1.8, zorder=4)
            axes.annotate(
                name,
                (first, second),
                (0, 7),
                textcoords="offset points",
                ha="center",
                color=COLOURS["ink"],
                bbox={"boxstyle": "round,pad=0.12", "fc": COLOURS["paper"], "ec": "none"},
                zorder=5,
            )
        for name, label in zip("xy", names, strict=True):
            getattr(axes, f"set_{name}scale")("log")
            getattr(axes, f"set_{name}lim")(low, high)
            getattr(axes, f"set_{name}label")(f"least H, {label}")
            getattr(axes, f"{name}axis").set_minor_locator(NullLocator())
            getattr(axes, f"{name}axis").set_major_formatter(FuncFormatter(lambda value, place: _power(value)))
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(frameon=False, fontsize=8.5, loc="lower right", markerscale=2.0)
        axes.set_title(fill(title, 72), loc="left")
    return drawing


# ---- one quantity of several runs --------------------------------------------------------------------------------


def draw_places(runs: Mapping[str, Run], shares: Sequence[float], title: str) -> Figure:
    """The arm at shares of the time (0 to 1) of each run, side by side, with the way of its tip."""
    with styled():
        drawing = Figure(figsize=(WIDTH * (0.35 + 0.65 * len(runs)), WIDTH * 0.8), layout="constrained")
        panels = drawing.subplots(1, len(runs), squeeze=False)[0]
        for axes, (name, run) in zip(panels, runs.items(), strict=True):
            draw_postures(axes, run, [round(share * (len(run.t) - 1)) for share in shares])
            axes.set_title(name, loc="left")
        _title(drawing, title)
    return drawing


def draw_heights(runs: Mapping[str, Run], title: str) -> Figure:
    """det J Jᵀ over time, one line for each run."""
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.2, WIDTH * 0.75), layout="constrained")
        axes = drawing.add_subplot()
        for k, (name, run) in enumerate(runs.items()):
            _plain(axes, run)
            label = f"{name}: least {readable(float(run.determinant.min()), 3)}"
            axes.plot(run.t, run.determinant, lw=1.7, label=label, **line_look(k))
        axes.set_ylim(0.0, 1.08 * max(float(run.determinant.max()) for run in runs.values()))
        axes.set_xlabel("time [s]")
        axes.set_ylabel("det J Jᵀ")
        drawing.legend(loc="outside lower left", frameon=False, fontsize=8.5, ncols=len(runs), handlelength=2.8)
        _title(drawing, title)
    return drawing


def draw_each_joint(runs: Mapping[str, Run], what: str, unit: str, title: str, note: str = "") -> Figure:
    """One panel for each joint, in each of them a line for each run.

    Args:
        runs: the runs, by name, of one arm.
        what: the attribute of a run that is drawn: "rates", "accelerations" or "torque".
        unit: of what is drawn.
        title: the finding.
        note: a line below it, such as the masses that torques rest on.
    """
    n = next(iter(runs.values())).arm.n
    with styled():
        rows = -(-n // 2)
        drawing = Figure(figsize=(WIDTH * 1.4, 0.9 + 1.15 * rows), layout="constrained")
        panels = drawing.subplots(rows, 2, sharex=True, squeeze=False)
        for j, axes in enumerate(panels.ravel()):
            if j == n:
                axes.set_axis_off()
                continue
            axes.axhline(0.0, color=COLOURS["line"], lw=0.8, zorder=0)
            for k, run in enumerate(runs.values()):
                _plain(axes, run)
                axes.plot(run.t, getattr(run, what)[:, j], lw=1.4, **line_look(k))
            axes.yaxis.set_major_locator(MaxNLocator(3))
            axes.annotate(
                f"q{j + 1}",
                (1.0, 0.5),
                (4, 0),
                xycoords="axes fraction",
                textcoords="offset points",
                va="center",
                color=COLOURS["ink"],
            )
        for axes in panels[-1]:
            axes.set_xlabel("time [s]")
        drawing.supylabel(f"[{unit}]", fontsize=10.0, color=COLOURS["muted"])
        drawing.legend(
            handles=[Line2D([], [], lw=1.6, label=name, **line_look(k)) for k, name in enumerate(runs)],
            loc="outside lower left",
            ncols=len(runs),
            frameon=False,
            handlelength=2.8,
        )
        _title(drawing, title, note)
    return drawing


def draw_frame_errors(runs: Mapping[str, Run], title: str) -> Figure:
    """By how much the tip's axes n, o, a and its place p miss those of the target: a panel each, a line for a run."""
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.4, WIDTH * 1.0), layout="constrained")
        panels = drawing.subplots(2, 2, sharex=True)
        for j, axes in enumerate(panels.ravel()):
            for k, run in enumerate(runs.values()):
                _plain(axes, run)
                axes.plot(run.t, run.frame_errors[:, j], lw=1.4, **line_look(k))
            values = [run.frame_errors[:, j] for run in runs.values()]
            _scaled(axes, np.concatenate(values), span=1.0, peaks=np.array([line.max() for line in values]))
            axes.set_title(FRAME[j], loc="left")
        for axes in panels[-1]:
            axes.set_xlabel("time [s]")
        drawing.legend(
            handles=[Line2D([], [], lw=1.6, label=name, **line_look(k)) for k, name in enumerate(runs)],
            loc="outside lower left",
            ncols=3,
            frameon=False,
            handlelength=2.8,
        )
        _title(drawing, title)
    return drawing
