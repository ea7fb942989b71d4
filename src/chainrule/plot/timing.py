"""Velocity and acceleration of every joint over the time of a motion, with their limits (De Luca, figure 3)."""

from __future__ import annotations

import math
from textwrap import wrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import MaxNLocator

from chainrule.errors import InputError
from chainrule.plot.style import COLOURS, styled
from chainrule.profiles import finding
from chainrule.tables import readable
from chainrule.timing import JointMove

#: More joints than this stand below each other instead of side by side.
SIDE_BY_SIDE = 4


def draw_profiles(move: JointMove, kinds: str | None = None, title: str | None = None) -> Figure:
    """Velocity and acceleration of each joint, the limits dashed, and the time each joint has to spare.

    Up to four joints stand side by side, more below each other. The area under a velocity is the joint's way.

    Args:
        move: one motion (not a batch).
        kinds: the joints' kinds, ``R`` in degrees and ``P`` in metres; all ``R`` when absent.
        title: :func:`chainrule.profiles.finding` when absent.

    Raises:
        InputError: a batch of motions, or kinds that do not fit.
    """
    kinds = "R" * move.n if kinds is None else kinds
    if move.start.ndim != 1 or len(kinds) != move.n:
        raise InputError(
            f"motions of shape {move.start.shape} and kinds '{kinds}'; one motion, and one letter for each of its "
            "joints are accepted"
        )
    wide = move.n <= SIDE_BY_SIDE
    with styled():
        size = (max(5.0, 2.15 * move.n), 4.2) if wide else (7.0, 1.0 + 1.05 * move.n)
        drawing = Figure(figsize=size, layout=ConstrainedLayoutEngine(w_pad=0.06, h_pad=0.07, hspace=0.03, wspace=0.03))
        shape = (2, move.n) if wide else (move.n, 2)
        panels = drawing.subplots(*shape, sharex=True, squeeze=False)
        panels = panels if wide else panels.T
        for j in range(move.n):
            _draw_joint(panels[0, j], panels[1, j], move, j, kinds[j])
        for row, what in ((0, "velocity"), (1, "acceleration")):
            _align(list(panels[row]), kinds)
            _label(list(panels[row]), kinds, what, wide)
        drawing.align_ylabels()
        for axes in panels[1] if wide else (panels[0, -1], panels[1, -1]):
            axes.set_xlabel("time [s]")
        text = title or finding(move)
        drawing.suptitle(_folded(text, 13.5 * size[0]), x=0.012, ha="left", fontsize=10.0, linespacing=1.35)
    return drawing


def _draw_joint(upper: Axes, lower: Axes, move: JointMove, j: int, kind: str) -> None:
    scale = 180.0 / math.pi if kind == "R" else 1.0
    duration, travel = float(move.duration), float(move.travel[j])
    sense = float(np.sign(move.goal[j] - move.start[j])) * scale
    ramp, peak = float(move.ramp[j]), sense * float(move.peak[j])
    rate = sense * float(move.acceleration[j]) if ramp > 0.0 else 0.0
    times = np.array([0.0, 0.0, ramp, ramp, travel - ramp, travel - ramp, travel, travel, duration])
    speeds = np.array([0.0, 0.0, peak, peak, peak, peak, 0.0, 0.0, 0.0])
    rates = np.array([0.0, rate, rate, 0.0, 0.0, -rate, -rate, 0.0, 0.0])
    upper.fill_between(times, speeds, color=COLOURS["fill"], lw=0)
    upper.plot(times, speeds, color=COLOURS["link"], lw=1.6, solid_joinstyle="round")
    lower.plot(times, rates, color=COLOURS["link"], lw=1.6, solid_joinstyle="miter")
    for axes, bound in ((upper, float(move.v_max[j])), (lower, float(move.a_max[j]))):
        axes.spines[["top", "right"]].set_visible(False)
        axes.axhline(0.0, color=COLOURS["line"], lw=0.8, zorder=0)
        if math.isfinite(bound):
            for side in (-scale * bound, scale * bound):
                axes.axhline(side, color=COLOURS["accent"], lw=1.0, ls=(0, (4, 3)), zorder=1)
        if travel < duration:
            axes.axvspan(travel, duration, color=COLOURS["ground"], lw=0, zorder=-1)
        axes.set_xlim(-0.02 * duration, duration * 1.02 if duration > 0.0 else 1.0)
    upper.set_title(_heading(move, j), loc="left", fontsize=9.5)


def _heading(move: JointMove, j: int) -> str:
    spare = "no slack" if move.bottleneck[j] else f"slack {readable(float(move.slack[j]), 2)} s"
    return f"q{j + 1}: case {move.cases[j]}, {spare}"


def _align(row: list[Axes], kinds: str) -> None:
    """One scale for all joints of a kind, symmetric about 0, so that heights can be compared."""
    for kind in set(kinds):
        same = [axes for axes, k in zip(row, kinds, strict=True) if k == kind]
        top = max(float(np.max(np.abs(np.asarray(line.get_ydata(), float)))) for axes in same for line in axes.lines)
        for axes in same:
            axes.set_ylim(-1.12 * top, 1.12 * top) if top > 0.0 else None
            axes.yaxis.set_major_locator(_locator())


def _locator() -> MaxNLocator:
    return MaxNLocator(nbins=4, steps=[1, 2, 3, 5, 6, 9, 10], symmetric=True)


def _label(row: list[Axes], kinds: str, what: str, wide: bool) -> None:
    power = {"velocity": "s", "acceleration": "s²"}[what]
    alike = len(set(kinds)) == 1
    for j, (axes, kind) in enumerate(zip(row, kinds, strict=True)):
        unit = f"{'deg' if kind == 'R' else 'm'}/{power}"
        if wide and alike and j > 0:
            axes.tick_params(labelleft=False)
        elif wide:
            axes.set_ylabel(f"{what} [{unit}]" if alike or j == 0 else f"[{unit}]")
        else:
            axes.set_ylabel(f"[{unit}]")
    if not wide:
        row[0].set_title(what, loc="right", fontsize=9.5, color=COLOURS["muted"])


def _folded(text: str, width: float) -> str:
    """Text in lines of about equal length, none longer than ``width`` characters."""
    lines = -(-len(text) // int(width))
    return "\n".join(wrap(text, min(int(width), len(text) // lines + 8)))
