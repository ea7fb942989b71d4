"""The workspace of a planar arm: what it reaches, what with every orientation, and why each edge is where it is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch, Wedge
from matplotlib.path import Path
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.boundary_pieces import Arc, Piece
from chainrule.plot.style import COLOURS, WIDTH, styled
from chainrule.regions import Region
from chainrule.skeleton import skeleton
from chainrule.workspaces import Workspace, findings, states_in_words, workspace

Array = NDArray[Any]

#: How a piece of the boundary is drawn, by the joint that moves along it; later joints repeat.
STROKES: tuple[tuple[str, Any], ...] = (
    (COLOURS["link"], "-"),
    (COLOURS["joint"], (0, (5, 1.6))),
    (COLOURS["accent"], (0, (2, 1.2))),
    (COLOURS["axis_y"], (0, (7, 1.5, 1.5, 1.5))),
    (COLOURS["axis_z"], (0, (1, 1))),
)

#: More different edges than this have no letters.
LETTERS = "abcdefghijklmnop"


def draw_workspace(
    arm: Arm, found: Workspace | None = None, *, at: Sequence[float] | None = None, q: Any = None
) -> Figure:
    """The reachable set, in it darker the set reached with every orientation, and the arm.

    Args:
        arm: the arm.
        found: its workspace, if it is at hand.
        at: a point (x, y), m, at which a fan shows the orientations the tip can have there.
        q: the posture (n,) the arm is drawn in; one inside the limits when absent.

    Example:
        >>> from chainrule import planar_3r
        >>> draw_workspace(planar_3r(1.0, 0.5, 0.25)).axes[0].get_title(loc="left").split(",")[0]
        'Reached: 0.25 to 1.75 m from the base'
    """
    found = workspace(arm) if found is None else found
    with styled():
        drawing = Figure(figsize=(WIDTH, WIDTH), layout="constrained")
        axes = drawing.add_subplot()
        axes.spines[["top", "right"]].set_visible(False)
        fill(axes, found.region, COLOURS["fill"], zorder=1.0)
        fill(axes, found.dexterous, COLOURS["fill_deep"], zorder=1.1)
        entries = _edges(axes, found)
        _arm(axes, arm, _posture(arm) if q is None else q, found.region.size)
        if at is not None:
            _fan(axes, found, complex(*at))
        _frame(axes, found, at)
        title = findings(found, at)
        axes.set_title("\n".join(title), loc="left")
        _legend(drawing, axes, entries, found, len(title))
    return drawing


def outline(piece: Piece) -> Array:
    """Points (k,) along a piece, close enough to look smooth."""
    steps = 1 + math.ceil(abs(piece.turn) / 0.03) if isinstance(piece, Arc) else 1
    return np.array([piece.point(t) for t in np.linspace(0.0, 1.0, steps + 1)])


def fill(axes: Axes, region: Region, colour: str, zorder: float) -> None:
    """A region filled; its holes stay open because they run the other way round."""
    corners, codes = [], []
    for loop in region.loops:
        line = np.concatenate([outline(piece)[:-1] for piece in loop])
        corners += [*line, line[0]]
        codes += [Path.MOVETO, *[Path.LINETO] * (len(line) - 1), Path.CLOSEPOLY]
    if corners:
        z = np.array(corners)
        axes.add_patch(PathPatch(Path(np.stack([z.real, z.imag], axis=1), codes), fc=colour, ec="none", zorder=zorder))
    for curve in region.curves:
        z = outline(curve)
        mark = {"marker": "o", "ms": 5} if curve.length == 0.0 else {}
        axes.plot(z.real, z.imag, color=colour, lw=3.0, zorder=zorder, **mark)  # type: ignore[arg-type]


def _edges(axes: Axes, found: Workspace) -> list[tuple[Any, str]]:
    """Draw the boundary; returns the entries of the legend."""
    kinds: dict[tuple[str, ...], list[Piece]] = {}
    for piece in found.region.pieces:
        kinds.setdefault(found.joints(piece), []).append(piece)
    size = _extent(found.region)
    entries: list[tuple[Any, str]] = []
    lettered = 1 < len(kinds) <= len(LETTERS)
    moving_seen = set()
    taken: list[complex] = []
    for letter, (states, pieces) in zip(
        [*LETTERS[: len(kinds)], *[""] * max(0, len(kinds) - len(LETTERS))], kinds.items(), strict=True
    ):
        moving = states.index("moves") if "moves" in states else 0
        colour, dashes = STROKES[moving % len(STROKES)]
        for piece in pieces:
            z = outline(piece)
            axes.plot(z.real, z.imag, color=colour, ls=dashes, lw=2.0, zorder=2.0, solid_capstyle="round")
        if lettered:
            longest = max(pieces, key=lambda piece: piece.length)
            _letter(axes, letter, longest, size, colour, taken)
            entries.append((Line2D([], [], color=colour, ls=dashes, lw=2.0), f"{letter}  {states_in_words(states)}"))
        elif len(kinds) == 1:
            entries.append((Line2D([], [], color=colour, ls=dashes, lw=2.0), states_in_words(states)))
        elif moving not in moving_seen:
            moving_seen.add(moving)
            entries.append((Line2D([], [], color=colour, ls=dashes, lw=2.0), f"q{moving + 1} moves"))
    return entries


def _extent(region: Region) -> float:
    """The larger side of the box around a region."""
    z = np.concatenate([outline(piece) for piece in region.pieces])
    return max(float(np.ptp(z.real)), float(np.ptp(z.imag)), 1e-9)


def _letter(axes: Axes, letter: str, piece: Piece, size: float, colour: str, taken: list[complex]) -> None:
    """The letter of an edge on its outer side, or inside where the edge bounds a hole; clear of the ones ``taken``."""
    shares = [0.5, 0.35, 0.65, 0.2, 0.8]
    if isinstance(piece, Arc) and abs(piece.turn) > 6.2:  # a whole circle: where the arm is least likely to be
        shares = [((math.radians(-60.0) - piece.start) / piece.turn) % 1.0, *shares]
    # the inside is on the left; further away, a line leads to the edge
    places = [
        (piece.point(t), piece.point(t) - away * size * 1j * piece.tangent(t))
        for away in (0.035, -0.035, 0.075, -0.075, 0.115, -0.115, 0.155)
        for t in shares
    ]
    gaps = [min((abs(at - other) for other in taken), default=size) for _, at in places]
    k = next((k for k, gap in enumerate(gaps) if gap >= 0.05 * size), int(np.argmax(gaps)))
    foot, at = places[k]
    taken.append(at)
    if abs(at - foot) > 0.05 * size:
        axes.plot([foot.real, at.real], [foot.imag, at.imag], color=colour, lw=0.6, zorder=5)
    patch = {"boxstyle": "circle,pad=0.12", "fc": COLOURS["paper"], "ec": "none", "alpha": 0.8}
    look: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 8.5, "weight": "bold"}
    axes.text(at.real, at.imag, letter, color=colour, zorder=6, bbox=patch, **look)


def _posture(arm: Arm) -> Array:
    """A posture inside the limits that is bent enough to look like an arm."""
    q = []
    for i, (kind, (low, high)) in enumerate(zip(arm.kinds, arm.limits.position.tolist(), strict=True)):
        if math.isfinite(low) and math.isfinite(high) and (kind == "P" or high - low < 2.0 * math.pi - 1e-9):
            q.append(low + 0.62 * (high - low))
        else:
            q.append((0.4 if i == 0 else 0.6) if low <= 0.0 and high >= 1.0 else (low if math.isfinite(low) else high))
    return np.array(q)


def _arm(axes: Axes, arm: Arm, q: Any, size: float) -> None:
    bones = skeleton(arm, q)
    line = np.vstack([np.zeros(3), bones.points, bones.tip])[:, :2]
    axes.plot(*line.T, color=COLOURS["muted"], lw=2.4, alpha=0.55, solid_capstyle="round", zorder=3)
    for spot, kind in zip(bones.points, arm.kinds, strict=True):
        axes.plot(
            *spot[:2],
            "o" if kind == "R" else "s",
            ms=5.5,
            mfc=COLOURS["paper"],
            mec=COLOURS["muted"],
            mew=1.3,
            zorder=3.1,
        )
    axes.plot(*bones.tip[:2], "o", ms=3.5, color=COLOURS["muted"], zorder=3.1)


def _fan(axes: Axes, found: Workspace, z: complex) -> None:
    """The orientations at a point as a fan of headings."""
    radius = 0.12 * _extent(found.region)
    accent = COLOURS["accent"]
    for low, high in found.orientations(z.real, z.imag):
        if high - low > 1e-7:
            turns = math.degrees(low), math.degrees(high)
            axes.add_patch(Wedge((z.real, z.imag), radius, *turns, fc=accent, alpha=0.3, ec="none", zorder=4))
        for angle in {low, high} if high - low < 2.0 * math.pi - 1e-9 else ():
            end = z + radius * np.exp(1j * angle)
            axes.plot([z.real, end.real], [z.imag, end.imag], color=accent, lw=1.3, zorder=4.1)
    axes.plot(z.real, z.imag, "o", ms=5, color=accent, zorder=4.2)


def _frame(axes: Axes, found: Workspace, at: Sequence[float] | None) -> None:
    """Equal axes around everything, with a margin for the letters."""
    z = np.concatenate([np.zeros(1), *(outline(piece) for piece in found.region.pieces)])
    if at is not None:
        z = np.append(z, complex(*at))
    margin = 0.09 * _extent(found.region)
    axes.set_aspect("equal")
    axes.set_xlim(z.real.min() - margin, z.real.max() + margin)
    axes.set_ylim(z.imag.min() - margin, z.imag.max() + margin)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _legend(drawing: Figure, axes: Axes, entries: list[tuple[Any, str]], found: Workspace, lines: int) -> None:
    """Below the axes: the two sets, and what the joints do along each edge; the figure as high as it all needs."""
    sets: list[tuple[Any, str]] = [(Patch(fc=COLOURS["fill"]), "reached")]
    if found.dexterous.pieces:
        sets.append((Patch(fc=COLOURS["fill_deep"]), "reached with every orientation"))
    everything = sets + entries
    widest = max(len(text) for _, text in everything)
    columns = 1 if widest > 29 else 2
    rows = math.ceil(len(everything) / columns)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    height = 0.88 * WIDTH * (high - low) / (right - left) + 0.65 + 0.17 * lines + 0.19 * rows
    drawing.set_size_inches(WIDTH, min(max(height, 0.7 * WIDTH), 3.0 * WIDTH))
    drawing.legend(
        [handle for handle, _ in everything],
        [text for _, text in everything],
        loc="outside lower left",
        ncols=columns,
        frameon=False,
        fontsize=8.5,
        handlelength=2.6,
        columnspacing=1.4,
        labelspacing=0.35,
    )
