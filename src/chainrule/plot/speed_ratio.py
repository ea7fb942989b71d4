"""Speed ratios drawn: the paths and their centres of curvature, the parabola, and what can be reached all around."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.plot.style import COLOURS, WIDTH, styled
from chainrule.skeleton import skeleton
from chainrule.speed_ratio import SpeedRatios, Status, speed_ratios
from chainrule.tables import readable

Array = NDArray[Any]

#: How each path is drawn; dashes and widths differ, so that it survives printing in grey.
STROKES: dict[str, dict[str, Any]] = {
    "desired": {"color": COLOURS["fill_deep"], "lw": 5.0, "ls": "-"},
    "chosen": {"color": COLOURS["ink"], "lw": 1.7, "ls": "-"},
    "other solution": {"color": COLOURS["joint"], "lw": 1.7, "ls": (0, (5, 2))},
    "pseudoinverse": {"color": COLOURS["accent"], "lw": 1.7, "ls": (0, (1.5, 1.5))},
}
MARKS = {"desired": "o", "chosen": "o", "other solution": "D", "pseudoinverse": "s"}


def finding(found: SpeedRatios) -> str:
    """One configuration's answer in one line."""
    if found.status is Status.SINGULAR:
        return "The configuration is singular: no rates to choose from"
    if found.exact:
        ways = {1: "by one motion", 2: "by two motions"}[found.count]
        return f"The curvature {readable(found.desired, 4)} is met {ways}"
    return f"The curvature {readable(found.desired, 4)} is out of reach; {readable(found.curvature, 4)} is nearest"


def draw_speed_ratios(found: SpeedRatios) -> Figure:
    """One configuration: the tip's paths with their centres of curvature, and the curvature over the self-motion.

    Example:
        >>> from chainrule import load
        >>> found = speed_ratios(load("ambike_3r"), [-0.2, -0.2, 2.7], tangent=[2, 1], curvature=-1.0)
        >>> len(draw_speed_ratios(found).axes)
        2
    """
    with styled():
        drawing = Figure(figsize=(1.8 * WIDTH, 0.98 * WIDTH), layout="constrained")
        left, right = drawing.subplots(1, 2, width_ratios=(1.1, 1.0))
        for axes in (left, right):
            axes.spines[["top", "right"]].set_visible(False)
        _paths(left, found)
        _parabola(right, found)
        drawing.suptitle(finding(found), x=0.01, ha="left", fontsize=11, color=COLOURS["ink"])
        drawing.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=4, frameon=False)
    return drawing


def motions(found: SpeedRatios) -> dict[str, tuple[Array, float]]:
    """Rates and curvature of each solution and of the pseudoinverse, by name."""
    named: dict[str, tuple[Array, float]] = {}
    for k in sorted(range(found.count), key=lambda k: k != found.chosen):
        word = "chosen" if k == found.chosen else "other solution"
        named[word] = (found.rates[k], float(found.curvatures[k]))
    if found.count:
        named["pseudoinverse"] = (found.pseudoinverse, float(found.pseudoinverse_curvature))
    return named


def _paths(axes: Axes, found: SpeedRatios) -> None:
    bones = skeleton(found.arm, found.q)
    line = np.vstack([np.zeros(2), bones.points[:, :2], bones.tip[:2]])
    tip, size = bones.tip[:2], max(float(np.abs(line).max()), 1e-9)
    across = np.array([-found.tangent[1], found.tangent[0]])
    axes.plot(*line.T, color=COLOURS["line"], lw=5.0, solid_capstyle="round", solid_joinstyle="round", zorder=1)
    axes.plot(*bones.points[:, :2].T, "o", ms=6, mfc=COLOURS["paper"], mec=COLOURS["muted"], mew=1.4, zorder=1.1)
    reach = 0.55 * size if found.desired == 0.0 else min(0.55 * size, 1.3 / abs(found.desired))
    s = np.linspace(-reach, reach, 201)
    axes.plot(*_circle(tip, found.tangent, across, found.desired, s).T, label="desired", zorder=2, **STROKES["desired"])
    shown = [line, tip + reach * np.array([found.tangent, -found.tangent, across, -across])]
    named = motions(found)
    for word, (rates, _) in named.items():
        drawn = found.arm.position(found.q + s[:, None] * rates)
        axes.plot(*drawn.T, label=word, zorder=3, **STROKES[word])
        shown.append(drawn)
    for word, curvature in [("desired", found.desired), *((word, k) for word, (_, k) in named.items())]:
        radius = 1.0 / curvature if curvature else math.inf
        if abs(radius) < 2.5 * size:
            centre = tip + radius * across
            hollow = word in ("desired",)
            axes.plot(
                *centre,
                MARKS[word],
                ms=11 if hollow else 5,
                mfc="none" if hollow else STROKES[word]["color"],
                mec=STROKES[word]["color"],
                mew=2.4 if hollow else 0.8,
                zorder=4,
            )
            shown.append(centre[None])
    head = {"arrowstyle": "-|>", "color": COLOURS["ink"], "lw": 1.2, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11}
    axes.annotate("", tuple(tip + 0.34 * size * found.tangent), xytext=tuple(tip), arrowprops=head, zorder=5)
    axes.plot(*tip, "o", ms=5, color=COLOURS["ink"], zorder=5)
    points = np.vstack(shown)
    middle, half = (points.min(axis=0) + points.max(axis=0)) / 2.0, 0.55 * float(np.ptp(points, axis=0).max())
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_title("Paths at constant rates, with their centres of curvature", loc="left", color=COLOURS["muted"])


def _circle(tip: Array, tangent: Array, across: Array, curvature: float, s: Array) -> Array:
    """The path of constant curvature from the tip, at the arc lengths s."""
    angle = curvature * s
    forward = s * np.sinc(angle / np.pi)
    sideways = s * np.where(angle == 0.0, 0.0, (1.0 - np.cos(angle)) / np.where(angle == 0.0, 1.0, angle))
    drawn: Array = tip + forward[:, None] * tangent + sideways[:, None] * across
    return drawn


def _parabola(axes: Axes, found: SpeedRatios) -> None:
    p2, p1, p0 = (float(p) for p in (found.parabola if found.count else np.zeros(3)))
    marks = {word: float((rates - found.pseudoinverse) @ found.null) for word, (rates, _) in motions(found).items()}
    places = [*marks.values(), *([-p1 / (2.0 * p2)] if np.isfinite(found.reachable).any() and p2 else [])]
    spread = max(np.ptp(places) if places else 0.0, 0.5)
    z = np.linspace(min(places, default=0.0) - 0.6 * spread, max(places, default=0.0) + 0.6 * spread, 301)
    curve = p2 * z**2 + p1 * z + p0
    heights = [*curve, found.desired]
    bottom, top = min(heights), max(heights)
    room = 0.1 * max(top - bottom, 0.1)
    low, high = np.clip(found.reachable, bottom - room, top + room)
    if found.status is not Status.FIXED and found.count:
        axes.axhspan(low, high, color=COLOURS["ground"], zorder=0)
        side = 0.985 if np.isinf(found.reachable[1]) else 0.015
        axes.text(
            0.985,
            side,
            "reachable",
            transform=axes.transAxes,
            ha="right",
            va="top" if side > 0.5 else "bottom",
            color=COLOURS["muted"],
        )
    axes.axhline(found.desired, zorder=1, **STROKES["desired"])
    if found.count:
        axes.plot(z, curve, color=COLOURS["link"], lw=1.6, zorder=2)
    for word, place in marks.items():
        height = p2 * place**2 + p1 * place + p0
        axes.plot(place, height, MARKS[word], ms=7, color=STROKES[word]["color"], mec=COLOURS["paper"], zorder=3)
    axes.set_ylim(bottom - room, top + room)
    axes.set_xlim(z[0], z[-1])
    axes.set_xlabel("self-motion added to the pseudoinverse's rates")
    axes.set_ylabel("curvature [1/m]")
    shape = {Status.FIXED: "a constant", Status.ONE_AT_INFINITY: "a straight line"}.get(found.status, "a parabola")
    title = f"Their curvature is {shape}" if found.count else "There is no motion along the tangent to choose from"
    axes.set_title(title, loc="left", color=COLOURS["muted"])


def around(arm: Arm, q: Any, angles: Any = None) -> tuple[Array, SpeedRatios]:
    """Angles (k,) all around, in rad, and the speed ratios along those directions; 720 directions when absent.

    Raises:
        InputError: at a singular configuration.
    """
    chosen = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False) if angles is None else np.asarray(angles)
    found = speed_ratios(arm, q, np.stack([np.cos(chosen), np.sin(chosen)], axis=-1), 0.0)
    if (found.status == Status.SINGULAR).any():
        raise InputError(f"{arm.name}: the configuration is singular; one in which the tip can move freely is accepted")
    return chosen, found


def _edges_resolved(arm: Arm, q: Any) -> Array:
    """Directions all around, dense beside those two where p2 = 0: there the edge goes from one end to the other.

    p2 is T x r'' of self-motion, so it is a sine of the direction.
    """
    even = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)
    _, found = around(arm, q, [0.0, 0.5 * np.pi])
    critical = math.atan2(-float(found.parabola[0, 0]), float(found.parabola[1, 0]))
    near = np.logspace(-9, -2, 71)
    return np.sort(
        np.concatenate(
            [even, *((critical + turn + near * sign) % (2.0 * np.pi) for turn in (0.0, np.pi) for sign in (1, -1))]
        )
    )


def straight_share(found: SpeedRatios) -> float:
    """The part of the directions along which a straight line is followed to second order."""
    return float(found.exact.mean())


def draw_reachable(arm: Arm, q: Any) -> Figure:
    """Which curvatures constant rates can follow, in every direction from one configuration.

    A point of the disc is a path that bends towards that side, the more the farther out: the centre is straight, the
    rim is turning on the spot. Its tangent lies across, and whichever way it is run the joint rates are the same up to
    their sign.

    Example:
        >>> from chainrule import planar_3r
        >>> draw_reachable(planar_3r(1.0, 0.5, 0.25), [0.3, 1.2, 0.5]).axes[0].name
        'polar'
    """
    angles, found = around(arm, q, _edges_resolved(arm, q))
    bones = skeleton(arm, q)
    line = np.vstack([np.zeros(2), bones.points[:, :2], bones.tip[:2]])
    unit = _round(0.25 * float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()))
    side = angles + np.pi / 2.0  # the left of the tangent

    def radius(curvature: Array) -> Array:
        """0 for straight, 1/2 where the radius of curvature is ``unit``, 1 for turning on the spot."""
        bent = np.maximum(np.where(np.isposinf(curvature), 0.0, curvature), 0.0) * unit
        return np.where(np.isposinf(curvature), 1.0, bent / (1.0 + bent))

    low, high = found.reachable.T
    with styled():
        drawing = Figure(figsize=(WIDTH, 1.12 * WIDTH), layout="constrained")
        axes = drawing.add_subplot(projection="polar")
        assert isinstance(axes, PolarAxes)
        order = np.r_[np.argsort(side % (2 * np.pi)), np.argsort(side % (2 * np.pi))[:1]]
        turn = np.unwrap((side % (2 * np.pi))[order])
        inner, outer = radius(low)[order], radius(high)[order]
        axes.fill_between(turn, inner, outer, where=outer > inner, color=COLOURS["fill"], lw=0, zorder=1)
        for edge in (low, high):
            # on the other side its radius is 0, so that the line runs into the centre
            axes.plot(
                turn,
                np.where(np.isfinite(edge[order]), radius(edge)[order], np.nan),
                color=COLOURS["link"],
                lw=1.3,
                zorder=3,
            )
        p0 = found.pseudoinverse_curvature[order]
        axes.plot(
            turn, np.where(p0 > 0.0, radius(p0), np.nan), zorder=4, label="pseudoinverse", **STROKES["pseudoinverse"]
        )
        axes.set_ylim(0.0, 1.0)
        axes.set_yticks([1 / 3, 1 / 2, 2 / 3, 5 / 6], [f"{readable(unit * f)} m" for f in (2, 1, 0.5, 0.2)])
        bare = -(np.clip(outer - inner, 0.0, None) * np.exp(1j * turn)).sum()
        axes.set_rlabel_position(math.degrees(np.angle(bare)) % 360.0 if abs(bare) > 1e-6 else 67.5)
        axes.tick_params(axis="y", labelsize=8)
        axes.grid(color=COLOURS["line"], lw=0.6)
        axes.spines["polar"].set_color(COLOURS["line"])
        drawing.suptitle(around_finding(around(arm, q)[1]), x=0.01, ha="left", fontsize=10, color=COLOURS["ink"])
        said = "angle: the side a path bends to; farther out: tighter; rings: radius of curvature"
        axes.set_xlabel(said, fontsize=8.5, labelpad=6)
        axes.fill_between([], [], [], color=COLOURS["fill"], label="reachable at constant rates")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2, frameon=False)
        _inset(drawing, line)
    return drawing


def around_finding(found: SpeedRatios) -> str:
    """What holds in every direction, in one sentence."""
    share = straight_share(found)
    if share in (0.0, 1.0):
        return f"A straight line is followed to second order in {'every' if share else 'no'} direction"
    return f"A straight line is followed to second order in {100.0 * share:.0f} % of the directions"


def _inset(drawing: Figure, line: Array) -> None:
    """The arm, small, in the corner: the disc is about its tip and turned as it is."""
    axes = drawing.add_axes((0.0, 0.12, 0.16, 0.16))
    axes.plot(*line.T, color=COLOURS["link"], lw=2.4, solid_capstyle="round", solid_joinstyle="round")
    axes.plot(*line[0], "o", ms=4, color=COLOURS["muted"])
    axes.plot(*line[-1], "o", ms=5, color=COLOURS["accent"])
    axes.set_aspect("equal")
    axes.margins(0.15)
    axes.set_axis_off()


def _round(value: float) -> float:
    """The nearest of 1, 2 and 5 times a power of ten."""
    if value <= 0.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return min((1.0, 2.0, 5.0, 10.0), key=lambda f: abs(math.log(value / (f * power)))) * power
