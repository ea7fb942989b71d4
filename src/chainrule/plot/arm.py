"""The arm drawn: in its plane with what it reaches, or in space seen from the side and above."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.plot.style import COLOURS, WIDTH, figure, styled
from chainrule.plot.workspace import fill, outline
from chainrule.skeleton import Skeleton, skeleton
from chainrule.tables import readable
from chainrule.workspaces import workspace

Array = NDArray[Any]

#: Directions of view for the spatial drawing, rad: azimuth and height of the eye.
AZIMUTH, HEIGHT = np.radians(-58.0), np.radians(20.0)


def draw_arm(arm: Arm, q: Any, title: str = "") -> Figure:
    """The arm at ``q`` (n,): links, joints with their numbers, joint axes, the tip's frame, a scale in metres.

    Raises:
        InputError: not an arm, or not one posture of it.
    """
    posture = real_array(q, "q")
    if posture.shape != (checked_arm(arm).n,):
        raise InputError(f"q: shape {posture.shape}; ({arm.n},), one value for each joint of {arm.name}, is accepted")
    bones = skeleton(arm, posture)
    with styled():
        return _planar(arm, bones, title) if bones.planar else _spatial(arm, bones, title)


def _planar(arm: Arm, bones: Skeleton, title: str) -> Figure:
    drawing, axes = figure(WIDTH * 0.92)
    shown = np.vstack([np.zeros(3), bones.points, bones.tip])[:, :2]
    try:
        found = workspace(arm)
    except InputError:  # an unlimited slide reaches without bounds
        found = None
    if found is not None:
        edges = np.concatenate([outline(piece) for piece in found.region.pieces])
        shown = np.vstack([shown, np.stack([edges.real, edges.imag], axis=1)])
        fill(axes, found.region, COLOURS["ground"], zorder=1.0)
        fill(axes, found.dexterous, COLOURS["fill"], zorder=1.1)
        for region, colour, dashes in (
            (found.region, COLOURS["muted"], "-"),
            (found.dexterous, COLOURS["link"], (0, (4, 3))),
        ):
            for loop in [*region.loops, *((curve,) for curve in region.curves)]:
                line = np.concatenate([outline(piece) for piece in loop])
                axes.plot(line.real, line.imag, color=colour, lw=0.8, ls=dashes, zorder=1.2)
    middle = 0.5 * (shown.min(axis=0) + shown.max(axis=0))
    radius = max(float(np.abs(shown - middle).max()), 1e-9)
    path = [np.zeros(3)]
    for point, kind in zip(bones.points, arm.kinds, strict=True):
        if (kind == "R" and np.linalg.norm(point - path[-1]) > 1e-12) or kind == "P":
            path.append(point)
    path.append(bones.tip)
    line = np.array(path)[:, :2]
    axes.plot(*line.T, color=COLOURS["link"], lw=5.5, solid_capstyle="round", solid_joinstyle="round", zorder=3)
    for point, axis, kind in zip(bones.points, bones.axes, arm.kinds, strict=True):
        if kind == "R":
            axes.plot(point[0], point[1], "o", ms=9, mfc=COLOURS["paper"], mec=COLOURS["joint"], mew=2.2, zorder=4)
        else:
            ends = np.array([point - 0.06 * radius * axis, point + 0.06 * radius * axis])[:, :2]
            axes.plot(*ends.T, color=COLOURS["joint"], lw=9, solid_capstyle="butt", zorder=4)
    axes.plot(*bones.tip[:2], "o", ms=6, color=COLOURS["accent"], zorder=5)
    _place_labels(
        axes,
        [(f"q{i}", point[:2], COLOURS["ink"]) for i, point in enumerate(bones.points, 1)]
        + [("tip", bones.tip[:2], COLOURS["accent"])],
        _along(line),
        0.13 * radius,
    )
    axes.set_aspect("equal")
    axes.set_xlim(middle[0] - 1.1 * radius, middle[0] + 1.1 * radius)
    axes.set_ylim(middle[1] - 1.1 * radius, middle[1] + 1.1 * radius)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    if title:
        axes.set_title(title, loc="left")
    return drawing


def projection() -> Array:
    """Rows (right, up, towards the eye) of the parallel projection."""
    ca, sa, ch, sh = np.cos(AZIMUTH), np.sin(AZIMUTH), np.cos(HEIGHT), np.sin(HEIGHT)
    return np.array([[-sa, ca, 0.0], [-sh * ca, -sh * sa, ch], [ch * ca, ch * sa, sh]])


def seen_from(arm: Arm) -> Array:
    """(2, 3): what takes a point to the picture: the plane of a planar arm, else the parallel projection."""
    return np.eye(3)[:2] if "x_alpha" in arm.tasks else projection()[:2]


def links(arm: Arm, q: Any) -> Array:
    """(n + 2, 3): base, joints and tip at ``q`` (n,)."""
    found = skeleton(arm, q)
    return np.vstack([np.zeros(3), found.points, found.tip])


def even(axes: Axes, arm: Arm) -> None:
    """One scale for both directions; a frame with metres for a planar arm only."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.08)
    if "x_alpha" in arm.tasks:
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
    else:
        axes.set_axis_off()


def _spatial(arm: Arm, bones: Skeleton, title: str) -> Figure:
    view = projection()[:2]
    path = _path(bones)
    size = max(float(np.ptp(np.vstack([path, np.zeros(3)]), axis=0).max()), 1e-9)
    floor = min(0.0, float(path[:, 2].min()))
    drawing, axes = figure(WIDTH)
    obstacles = [_along(path @ view.T)]
    obstacles += _floor(axes, view, path, floor, size)
    shadow = path * [1.0, 1.0, 0.0] + [0.0, 0.0, floor]
    axes.plot(
        *(shadow @ view.T).T, color=COLOURS["line"], lw=4.0, solid_capstyle="round", solid_joinstyle="round", zorder=1.5
    )
    flat = path @ view.T
    axes.plot(*flat.T, color=COLOURS["paper"], lw=9.0, solid_capstyle="round", solid_joinstyle="round", zorder=2.9)
    axes.plot(*flat.T, color=COLOURS["link"], lw=5.5, solid_capstyle="round", solid_joinstyle="round", zorder=3)
    _joint_strokes(axes, view, arm, bones, size)
    obstacles += _frame(axes, view, np.zeros(3), np.eye(3), 0.14 * size)
    obstacles += _frame(axes, view, bones.tip, bones.frame, 0.14 * size)
    labels: dict[tuple[float, ...], list[str]] = {}
    for i, point in enumerate(bones.points, 1):
        labels.setdefault(tuple(np.round(point, 6)), []).append(f"q{i}")
    _place_labels(
        axes,
        [(", ".join(names), np.array(at) @ view.T, COLOURS["ink"]) for at, names in labels.items()]
        + [("tip", bones.tip @ view.T, COLOURS["accent"])],
        np.vstack(obstacles),
        0.085 * size,
    )
    axes.set_aspect("equal")
    axes.set_axis_off()
    if title:
        axes.set_title(title, loc="left")
    _fit(drawing, axes)
    return drawing


def _fit(drawing: Figure, axes: Axes) -> None:
    """Make the figure as high as what it shows needs."""
    axes.margins(0.04)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    drawing.set_size_inches(WIDTH, min(max(WIDTH * (high - low) / (right - left), 0.45 * WIDTH), 1.15 * WIDTH))


def _along(line: Array, count: int = 24) -> Array:
    """Points spread along a polyline (k, 2)."""
    share = np.linspace(0.0, 1.0, count)[:, None]
    return np.vstack([a + share * (b - a) for a, b in pairwise(line)]) if len(line) > 1 else line


def _place_labels(axes: Axes, labels: list[tuple[str, Array, str]], obstacles: Array, distance: float) -> None:
    """Each label beside its point, on the side that is freest of lines and of the other labels."""
    turn = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
    for text, point, colour in labels:
        wide = 1.0 + 0.18 * max(0, len(text) - 2)
        places = point + distance * np.stack([wide * np.cos(turn), np.sin(turn)], axis=1)
        gaps = np.linalg.norm((places[:, None] - obstacles[None]) / [wide, 1.0], axis=2).min(axis=1)
        best = places[int(np.argmax(np.minimum(gaps, 0.9 * distance) + 1e-3 * distance * np.cos(turn - 0.6)))]
        half = np.array([0.35 * wide * distance, 0.0])
        obstacles = np.vstack([obstacles, best, best + half, best - half])
        _write(axes, text, best, colour, zorder=7, alpha=0.7)


def _path(bones: Skeleton) -> Array:
    points = [np.zeros(3)]
    for point in [*bones.points, bones.tip]:
        if np.linalg.norm(point - points[-1]) > 1e-12:
            points.append(point)
    return np.array(points)


def _floor(axes: Axes, view: Array, path: Array, floor: float, size: float) -> list[Array]:
    """Circles on the floor at round distances from the base, with their radius written beside."""
    step = next(s * 10.0**e for e in range(-4, 5) for s in (1, 2, 2.5, 5) if size / (s * 10.0**e) <= 4)
    extent = float(np.hypot(path[:, 0], path[:, 1]).max())
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    circle = np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)], axis=1)
    written = []
    for k in range(1, max(1, int(np.ceil(extent / step - 1e-9))) + 1):
        ring = circle * (k * step) + [0.0, 0.0, floor]
        axes.plot(*(ring @ view.T).T, color=COLOURS["line"], lw=0.8, zorder=1)
        at = np.array([k * step * np.cos(AZIMUTH), k * step * np.sin(AZIMUTH), floor]) @ view.T
        _write(axes, f"{readable(k * step)} m", at, COLOURS["muted"], zorder=1.2, size=8.5)
        written.append(at[None])
    return written


def _joint_strokes(axes: Axes, view: Array, arm: Arm, bones: Skeleton, size: float) -> None:
    """Each joint as a short stroke along its axis, a dot where the axis is seen end on."""
    for point, axis, kind in zip(bones.points, bones.axes, arm.kinds, strict=True):
        half = (0.032 if kind == "R" else 0.06) * size
        beyond = np.array([point - 2.8 * half * axis, point + 2.8 * half * axis]) @ view.T
        axes.plot(*beyond.T, color=COLOURS["joint"], lw=1.0, zorder=3.5)
        stroke = np.array([point - half * axis, point + half * axis]) @ view.T
        cap = "butt" if kind == "P" else "round"
        axes.plot(*stroke.T, color=COLOURS["paper"], lw=11.0, solid_capstyle=cap, zorder=3.8)
        axes.plot(*stroke.T, color=COLOURS["joint"], lw=8.5, solid_capstyle=cap, zorder=4)


def _write(
    axes: Axes, text: str, at: Array, colour: str, zorder: float, size: float = 10.0, alpha: float = 1.0
) -> None:
    """Text centred at a point, on a patch of paper so that lines do not run through it."""
    patch = {"boxstyle": "round,pad=0.12", "fc": COLOURS["paper"], "ec": "none", "alpha": alpha}
    axes.text(at[0], at[1], text, ha="center", va="center", color=colour, fontsize=size, zorder=zorder, bbox=patch)


def _frame(axes: Axes, view: Array, origin: Array, frame: Array, length: float) -> list[Array]:
    """A frame's axes as arrows with their letters; returns the points they cover."""
    start = origin @ view.T
    covered = [start[None]]
    for k, letter in enumerate("xyz"):
        end = (origin + length * frame[:, k]) @ view.T
        colour = COLOURS[f"axis_{letter}"]
        arrow = {"arrowstyle": "-|>", "color": colour, "lw": 1.4, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
        axes.annotate("", (end[0], end[1]), xytext=(start[0], start[1]), zorder=5, arrowprops=arrow)
        if np.linalg.norm(end - start) > 0.25 * length:
            beside = end + 0.17 * length * (end - start) / np.linalg.norm(end - start)
            axes.text(beside[0], beside[1], letter, ha="center", va="center", fontsize=9, color=colour, zorder=5)
            covered += [_along(np.array([start, end]), 6), beside[None]]
    axes.plot(*start, "o", ms=4, color=COLOURS["ink"], zorder=5.1)
    return covered
