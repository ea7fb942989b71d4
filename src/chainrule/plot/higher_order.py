"""Higher-order speed ratios drawn: how far each order keeps to a path, four joints' conic and cubic, a timing."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.four_joints import CUBIC, FourJointRatios
from chainrule.higher_order import MotionRatios
from chainrule.plot.style import COLOURS, figure, styled
from chainrule.scaling import TimeScaling

Array = NDArray[Any]

_RAISED = str.maketrans("0123456789-.", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻·")


def _power(value: float) -> str:
    """A power of ten, such as 10⁻⁴."""
    return f"10{str(round(np.log10(value))).translate(_RAISED)}"


def draw_orders(arm: Arm, motions: dict[str, MotionRatios], length: float = 0.5) -> Figure:
    """How far the tip is off the wanted path along it, for several motions of one configuration.

    Args:
        arm: the arm.
        motions: by label, each of one configuration and the same path.
        length: arc length to the right end of the axis, m.
    """
    s = np.geomspace(1e-2 * length, length, 60)
    with styled():
        drawing, axes = figure(3.6)
        looks = (("accent", ":"), ("joint", "--"), ("link", "-"), ("axis_y", "-."))
        slopes = []
        for (label, motion), (colour, style) in zip(motions.items(), looks, strict=False):
            off = np.linalg.norm(arm.position(motion.at(s)) - _clothoid(arm, motion, s), axis=1)
            axes.loglog(s, off, style, color=COLOURS[colour], lw=1.8)
            axes.annotate(label, (s[4], off[4]), (8, -3), textcoords="offset points", color=COLOURS[colour], va="top")
            slopes.append(float(np.log(off[20] / off[0]) / np.log(s[20] / s[0])))
        axes.set_xlabel("arc length s [m]")
        axes.set_ylabel("distance of the tip from the path [m]")
        axes.margins(x=0.02)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(lambda value, place: _power(value))
            axis.set_minor_formatter(lambda value, place: "")
        powers = ", ".join(f"s{f'{round(slope, 1):g}'.translate(_RAISED)}" for slope in slopes)
        axes.set_title(f"Each order keeps to the path longer:\nthe error grows with {powers}", loc="left")
    return drawing


def _clothoid(arm: Arm, motion: MotionRatios, s: Array) -> Array:
    """Points of the wanted path: curvature k + k' s, integrated by Gauss-Legendre quadrature."""
    k, rate, *_ = (float(g) for g in motion.point.geometry)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    u = s[:, None] * (nodes + 1.0) / 2.0
    turned = np.exp(1j * (k * u + rate * u**2 / 2.0)) @ weights * s / 2.0 * complex(*motion.point.tangent)
    start: Array = arm.position(motion.point.q)
    points: Array = start + np.stack([turned.real, turned.imag], axis=1)
    return points


def draw_four_joints(found: FourJointRatios) -> Figure:
    """The conic of the curvature and the cubic of its rate over the null space; they cross at the solutions."""
    points = found.coordinates if len(found.coordinates) else np.zeros((1, 2))
    # solutions differ by orders of magnitude: linear about the smaller ones, logarithmic far out
    linear = max(float(np.quantile(np.abs(points), 0.25)), 1e-3)
    reach = np.arcsinh(np.abs(points).max(axis=0) / linear) * 1.15 + 0.6
    x, y = (linear * np.sinh(np.linspace(-r, r, 601)) for r in reach)
    with styled():
        drawing, axes = figure(4.8)
        axes.set_xscale("asinh", linear_width=linear)
        axes.set_yscale("asinh", linear_width=linear)
        for coefficients, colour, style in ((found.conic, "link", "-"), (found.cubic, "joint", "--")):
            value = sum(c * x[:, None] ** i * y**j for c, (i, j) in zip(coefficients, CUBIC, strict=False))
            axes.contour(
                x, y, np.asarray(value).T, levels=[0.0], colors=COLOURS[colour], linestyles=style, linewidths=1.8
            )
        for k, point in enumerate(found.coordinates):
            chosen = k == found.chosen
            axes.plot(*point, "o", ms=8, mfc=COLOURS["accent"] if chosen else COLOURS["paper"], mec=COLOURS["ink"])
        for axis, values in ((axes.xaxis, x), (axes.yaxis, y)):
            axis.set_ticks(_ticks(values[-1], linear))
            axis.set_minor_locator(NullLocator())
            axis.set_major_formatter(lambda value, place: f"{value:g}".replace("-", "−"))
        axes.set_xlabel("x₁ along the first null vector [rad/m]")
        axes.set_ylabel("x₂ along the second [rad/m]")
        for text, colour, style in (("curvature met", "link", "-"), ("its rate met", "joint", "--")):
            axes.plot([], [], style, color=COLOURS[colour], lw=1.8, label=text)
        axes.plot([], [], "o", ms=8, mfc=COLOURS["accent"], mec=COLOURS["ink"], ls="", label="chosen")
        drawing.legend(loc="outside lower center", ncols=3, frameon=False)
        axes.set_title(_four_joint_finding(found), loc="left")
    return drawing


def _ticks(end: float, linear: float) -> list[float]:
    """Zero and powers of ten from the linear range to the end, both signs."""
    low, high = round(np.log10(linear)), int(np.floor(np.log10(end)))
    powers = [10.0**k for k in range(low, high + 1)]
    return [*(-power for power in reversed(powers)), 0.0, *powers]


def _four_joint_finding(found: FourJointRatios) -> str:
    if found.status == "exact":
        six = found.count + found.complex_count
        rest = f"{found.complex_count} of the {six} are complex" if found.complex_count else "all that exist are real"
        many = "One joint motion meets" if found.count == 1 else f"{found.count} joint motions meet"
        return f"{many} tangent, curvature and its rate;\n{rest}"
    return f"No joint motion meets tangent, curvature and its rate:\n{found.status}"


def draw_timings(moves: dict[str, TimeScaling], velocity: Any, acceleration: Any) -> Figure:
    """The largest share of the velocity and the acceleration limits over time, one panel for each timing."""
    longest = max(move.duration for move in moves.values())
    with styled():
        drawing = Figure(figsize=(5.0, 1.6 + 1.6 * len(moves)), layout="constrained")
        panels: Any = np.atleast_1d(drawing.subplots(len(moves), 1, sharex=True))
        for axes, (label, move) in zip(panels, moves.items(), strict=True):
            _timing(axes, move, velocity, acceleration)
            axes.set_xlim(0.0, longest or 1.0)
            axes.text(0.995, 1.03, f"{label}: {move.duration:.3g} s", transform=axes.transAxes, ha="right")
        panels[-1].set_xlabel("time [s]")
        drawing.supylabel("share of the limit", color=COLOURS["muted"], fontsize=10.0)
        lines, labels = panels[0].get_legend_handles_labels()
        drawing.legend(lines, labels, loc="outside lower center", ncols=2, frameon=False)
        names = sorted(moves, key=lambda name: moves[name].duration)
        saved = 1.0 - moves[names[0]].duration / longest if longest > 0.0 else 0.0
        finding = f"{names[0]} is done {100 * saved:.0f} % sooner" if saved > 0.0 else f"all take {longest:.3g} s"
        drawing.suptitle(finding, x=0.02, ha="left", fontsize=10.0)
    return drawing


def _timing(axes: Axes, move: TimeScaling, velocity: Any, acceleration: Any) -> None:
    t = np.linspace(0.0, move.duration, 1500)
    _, speed, push = move.sample(t)
    axes.plot(t, (np.abs(speed) / velocity).max(axis=1), "-", color=COLOURS["link"], lw=1.8, label="fastest joint")
    axes.plot(
        t, (np.abs(push) / acceleration).max(axis=1), "--", color=COLOURS["joint"], lw=1.2, label="hardest pushed joint"
    )
    axes.axhline(1.0, color=COLOURS["line"], lw=0.8, zorder=0)
    axes.set_ylim(0.0, 1.08)
    axes.spines[["top", "right"]].set_visible(False)
    for passed in move.knot_times[1:-1]:
        axes.axvline(passed, color=COLOURS["line"], lw=0.8, zorder=0)
