"""Draws the figures of the site: ``python docs/figures.py [NAME ...]`` writes docs/images/NAME.svg.

Every figure comes from public functions, and drawing it again gives the same file (with the same Matplotlib).
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

import chainrule as cr
from chainrule import papers
from chainrule.console import write_figure
from chainrule.following_compared import compare, study
from chainrule.papers.sanchez_paths import STARTS, thesis_arc
from chainrule.plot.arm import draw_arm
from chainrule.plot.cuspidality import draw_design
from chainrule.plot.following import draw_following, draw_stretches, draw_study
from chainrule.plot.higher_order import draw_four_joints, draw_orders, draw_timings
from chainrule.plot.maps import draw_map, draw_optima
from chainrule.plot.redundancy import draw_runs
from chainrule.plot.self_motion import draw_self_motion
from chainrule.plot.speed_ratio import draw_reachable, draw_speed_ratios
from chainrule.plot.style import COLOURS, FIELD, WIDTH, styled
from chainrule.plot.timing import draw_profiles
from chainrule.plot.workspace import draw_workspace, fill, outline

Array = NDArray[Any]
IMAGES = Path(__file__).resolve().parent / "images"

METHODS = ("pseudoinverse", "speed_ratio", "two_term", "look_ahead")


def _limited() -> cr.Arm:
    """The arm of the guide to workspaces, with its limits."""
    return cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(-0.5, 2.0), (-2.0, 2.0), (-2.5, 2.5)])


def _cuspidal() -> tuple[cr.Orthogonal3R, cr.PostureChange]:
    """Baili's figure 2 (a), and a change of posture."""
    arm = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    q = arm.postures(2.5, 0.0, 0.5)
    return arm, arm.posture_change(q[0], q[2])


def _ellipse() -> tuple[cr.Arm, cr.Ellipse]:
    return cr.planar_3r(1.0, 0.8, 0.6), cr.Ellipse((1.2, 0.3), (0.6, 0.3), rotation=0.4)


# ---- the picture of the README -----------------------------------------------------------------------------------


def overview() -> Figure:
    """Four questions, a panel each."""
    with styled():
        drawing = Figure(figsize=(8.6, 8.0), layout="constrained")
        panels = drawing.subplots(2, 2)
        drawing.get_layout_engine().set(h_pad=0.12, w_pad=0.12)  # type: ignore[union-attr,call-arg]
        for axes in panels.flat:
            axes.spines[:].set_visible(False)
            axes.set_xticks([])
            axes.set_yticks([])
            axes.set_aspect("equal", adjustable="datalim")
        _loops(panels[0, 0])
        _round_a_cusp(panels[0, 1])
        _fewer_updates(panels[1, 0])
        _reached(panels[1, 1])
    return drawing


def _title(axes: Axes, question: str, answer: str) -> None:
    axes.set_title(f"{question}\n", loc="left", fontsize=11.5, fontweight="bold")
    axes.text(0.0, 1.015, answer, transform=axes.transAxes, fontsize=9.5, color=COLOURS["muted"])


def _loops(axes: Axes) -> None:
    """Postures of Lenarčič's arm along both of its self-motion curves, coloured by H."""
    arm = cr.load("lenarcic_3r")
    found = cr.self_motion(arm, [0.4, 0.0])
    q = np.concatenate([component.at(np.linspace(0.0, 1.0, 19)[:-1]) for component in found.components])
    height = np.asarray(arm.manipulability(q))
    for posture, share in zip(q, height / height.max(), strict=True):
        _links(axes, arm, posture, colormaps[FIELD](share))
    axes.plot(0.4, 0.0, "o", ms=9, color=COLOURS["accent"], zorder=5)
    axes.plot(0.0, 0.0, "s", ms=7, color=COLOURS["ink"], zorder=5)
    _title(axes, "How can it move while its hand holds still?", f"along {found.count} closed curves; proved: no other")


def _round_a_cusp(axes: Axes) -> None:
    """The cross-section of a cuspidal arm, and the path of the tip while the posture changes."""
    arm, change = _cuspidal()
    curves = [curve.image for curve in arm.singular_curves() if not curve.line]
    for image, shade in zip(sorted(curves, key=lambda image: -np.ptp(image)), ("fill", "fill_deep"), strict=True):
        axes.fill(*image.T, fc=COLOURS[shade], ec=COLOURS["link"], lw=1.6)
    axes.plot(*np.asarray(arm.cusps()).T, "o", ms=6.5, mfc=COLOURS["accent"], mec=COLOURS["paper"])
    image = change.image(200)
    axes.plot(*image.T, color=COLOURS["joint"], lw=2.4)
    for share in (0.2, 0.8):
        at = int(share * len(image))
        arrow = {
            "arrowstyle": "-|>,head_width=0.35,head_length=0.7",
            "color": COLOURS["joint"],
            "shrinkA": 0,
            "shrinkB": 0,
        }
        axes.annotate("", image[at + 2], image[at], arrowprops=arrow)
    axes.plot(*image[0], "s", ms=7, color=COLOURS["ink"])
    _title(axes, "Can it change its posture freely?", "round a cusp, back to the point, in another posture")


def _fewer_updates(axes: Axes) -> None:
    """One ellipse, the arm, and the updates of two methods."""
    arm, path = _ellipse()
    runs = [cr.follow(arm, path, 0.002, method=method) for method in ("pseudoinverse", "look_ahead")]
    axes.plot(*path.point(np.linspace(0.0, path.length, 400)).T, color=COLOURS["ink"], lw=1.0)
    axes.plot(*path.point(runs[0].s).T, "o", ms=8, mfc=COLOURS["fill"], mec=COLOURS["muted"], mew=0.7)
    axes.plot(*path.point(runs[1].s).T, "o", ms=4, color=COLOURS["accent"])
    _links(axes, arm, runs[1].q[0], COLOURS["link"])
    updates = f"within 2 mm: {runs[1].updates} updates (dots) instead of {runs[0].updates} (circles)"
    _title(axes, "How should a spare joint move?", updates)


def _links(axes: Axes, arm: cr.Arm, q: Array, colour: Any) -> None:
    heading = np.cumsum(q)
    links = np.asarray(arm.parameters)[:, None] * np.stack([np.cos(heading), np.sin(heading)], axis=-1)
    points = np.vstack([np.zeros(2), np.cumsum(links, axis=0)])
    axes.plot(*points.T, color=colour, lw=1.8, solid_capstyle="round")
    axes.plot(*points[:-1].T, "o", ms=3.0, color=COLOURS["muted"])


def _reached(axes: Axes) -> None:
    """A workspace within joint limits."""
    arm = _limited()
    found = cr.workspace(arm)
    fill(axes, found.region, COLOURS["fill"], 1.0)
    fill(axes, found.dexterous, COLOURS["fill_deep"], 1.1)
    for piece in found.region.pieces:
        line = outline(piece)
        axes.plot(line.real, line.imag, color=COLOURS["link"], lw=1.6, zorder=2)
    _links(axes, arm, np.array([0.9, -0.8, 1.2]), COLOURS["link"])
    _title(
        axes, "Where can it reach?", f"{found.area:.4f} m² bounded by {len(found.region.pieces)} arcs, in closed form"
    )


# ---- one for each guide ------------------------------------------------------------------------------------------


def arm_files() -> Figure:
    """An embedded arm."""
    return draw_arm(cr.load("puma560"), [0.4, -0.9, 0.5, 0.3, 0.8, 0.2], "puma560, an embedded arm")


def self_motion() -> Figure:
    """Lenarčič's arm at a target in region C."""
    arm = cr.load("lenarcic_3r")
    return draw_self_motion(arm, cr.self_motion(arm, [0.4, 0.0]))


def posture_change_6r() -> Figure:
    """det J and the joints along a witness."""
    witness = cr.posture_change_witness(cr.load("gofa5"))
    s = np.linspace(0.0, 1.0, 400)
    q = witness.sample(s)
    det = witness.sign * np.asarray(cr.load("gofa5").minors(q)).ravel()
    with styled():
        drawing = Figure(figsize=(WIDTH, 4.4), layout="constrained")
        upper, lower = drawing.subplots(2, 1, sharex=True)
        for axes in (upper, lower):
            axes.spines[["top", "right"]].set_visible(False)
        upper.fill_between(s, 0.0, det, color=COLOURS["fill"], lw=0)
        upper.plot(s, det, color=COLOURS["link"], lw=1.8)
        upper.axhline(witness.smallest_determinant, color=COLOURS["accent"], lw=1.2, ls="--")
        upper.annotate(
            "proved bound", (0.5, witness.smallest_determinant), (0, 4), textcoords="offset points", ha="center"
        )
        upper.set_ylim(0.0)
        upper.set_ylabel("|det J| [m³]")
        upper.set_title("gofa5: two inverse solutions of one pose,\njoined without a singularity", loc="left")
        for joint in range(6):
            lower.plot(s, np.degrees(q[:, joint]), lw=1.6, color=colormaps[FIELD](joint / 6.5))
            lower.annotate(str(joint + 1), (1.0, float(np.degrees(q[-1, joint]))), (4, -3), textcoords="offset points")
        lower.set_xlabel("share of the path")
        lower.set_ylabel("joints 1 to 6 [°]")
        lower.margins(x=0.0)
    return drawing


def speed_ratio() -> Figure:
    """Ambike's example 1."""
    return draw_speed_ratios(cr.speed_ratios(cr.load("ambike_3r"), np.radians([-14.0, -10.0, -205.0]), [2, 1], -1.0))


def four_joints() -> Figure:
    """The guide's example with six solutions."""
    arm = cr.planar("RRRR", [1.0, 0.8, 0.6, 0.4])
    return draw_four_joints(cr.speed_ratios_4(arm, [0.2, 0.8, 0.9, -1.2], tangent=[0.6, 0.8], curvature=0.0))


def higher_order() -> Figure:
    """Ambike's example 2 at orders two and three."""
    arm, q, tangent = cr.load("ambike_3r"), np.radians([-14, -40, -205]), [0.9439, 0.3304]
    orders = {2: "second order", 3: "third order"}
    motions = {label: cr.motion_ratios(arm, q, tangent, -1.0, 0.25, order=order) for order, label in orders.items()}
    return draw_orders(arm, motions)


def time_scaling() -> Figure:
    """A path through knots, with stops and without."""
    knots = [[0, 0, 0], [0.5, 0.2, -0.3], [0.8, 0.9, 0.1], [0.2, 1.2, 0.6]]
    stop = cr.time_scaling(knots, 1.0, 2.0)
    fast = cr.time_scaling(knots, 1.0, 2.0, method="toppra", deviation=0.02)
    return draw_timings({"stops at the knots": stop, "rounded corners": fast}, 1.0, 2.0)


def follow_path() -> Figure:
    """One ellipse by four methods."""
    arm, path = _ellipse()
    return draw_following(arm, path, [cr.follow(arm, path, 0.002, method=method) for method in METHODS])


def follow_study() -> Figure:
    """6000 cases at three tolerances."""
    return draw_study([study(6000, tolerance, seed=11) for tolerance in (0.025, 0.005, 0.0005)])


def stretches(degrees: tuple[float, ...], tangent: tuple[float, float]) -> Figure:
    """One of Ambike's examples."""
    arm, q = cr.load("ambike_3r"), np.radians(degrees)
    return draw_stretches(arm, q, tangent, -1.0, compare(arm, q, tangent, -1.0, 0.025))


def min_time() -> Figure:
    """De Luca's exercise 2."""
    arm = cr.load("planar_3r")
    limits = arm.limits
    move = cr.min_time([0.0, 0.0, 0.0], np.radians([53.13, -90, 36.87]), limits.velocity, limits.acceleration)
    return draw_profiles(move, arm.kinds)


def manipulability() -> Figure:
    """De Luca's map."""
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    return draw_map(arm, cr.manipulability_map(arm, size=91))


def optima() -> Figure:
    """The two postures of the largest H."""
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    return draw_optima(arm, cr.max_manipulability(arm))


def track() -> Figure:
    """One arc of the thesis followed in three ways."""
    arm, path, start = cr.load("sanchez_8r"), thesis_arc(), STARTS["A"]
    local = cr.track(arm, path, start, gain=-2.0)
    return draw_runs(
        {
            "pseudoinverse": cr.track(arm, path, start, method="pseudoinverse"),
            "gradient projection, −2 on H^(-1/2)": local,
            "global optimum": cr.track_globally(arm, path, start).run,
        }
    )


def _of_paper(key: str, name: str) -> Figure:
    return papers.figures(key)[name]


FIGURES: dict[str, Callable[[], Figure]] = {
    "overview": overview,
    "arm-files": arm_files,
    "self-motion": self_motion,
    "cuspidality": lambda: draw_design(*_cuspidal()),
    "posture-change-6r": posture_change_6r,
    "workspace": lambda: draw_workspace(_limited(), at=(0.6, 0.7)),
    "manipulability": manipulability,
    "optima": optima,
    "speed-ratio": speed_ratio,
    "reachable-curvatures": lambda: draw_reachable(cr.load("ambike_3r"), np.radians([-14.0, -10.0, -205.0])),
    "four-joints": four_joints,
    "higher-order": higher_order,
    "time-scaling": time_scaling,
    "follow-path": follow_path,
    "follow-study": follow_study,
    "min-time": min_time,
    "track": track,
    "ambike-figure-1": partial(stretches, (-14.0, -10.0, -205.0), (2.0, 1.0)),
    "ambike-figure-2": partial(stretches, (-14.0, -40.0, -205.0), (0.9439, 0.3304)),
    "baili-figure-7": partial(_of_paper, "baili", "figure-7"),
    **{f"lenarcic-figure-{k}": partial(_of_paper, "lenarcic", f"figure-{k}") for k in (2, 3, 4, 5)},
}


def main(wanted: list[str]) -> None:
    """Draw the figures asked for, or all."""
    for name in wanted or FIGURES:
        write_figure(FIGURES[name](), IMAGES / f"{name}.svg")
        print(f"docs/images/{name}.svg", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
