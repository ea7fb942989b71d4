"""3R arms: singular curves in joint space and in the cross-section, posture counts, aspects, cusps and nodes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from chainrule.plot.style import COLOURS, WIDTH, styled

if TYPE_CHECKING:
    from chainrule.cuspidality.designs import Regional3R
    from chainrule.cuspidality.posture_change import PostureChange

Array = NDArray[Any]

#: Points along each direction of the shaded grids.
GRID = 361

#: How a curve of singularities is drawn, one after the other.
STROKES: tuple[tuple[str, Any], ...] = (
    (COLOURS["link"], "-"),
    (COLOURS["joint"], (0, (5, 1.6))),
    (COLOURS["axis_y"], (0, (7, 1.5, 1.5, 1.5))),
    (COLOURS["axis_z"], (0, (1, 1))),
)
_LINE: Any = {"color": COLOURS["muted"], "ls": (0, (1, 1.6)), "lw": 1.4}


def draw_design(design: Regional3R, change: PostureChange | None = None) -> Figure:
    """The arm's singularities: in joint space with its aspects, and in the cross-section with the posture counts.

    Args:
        design: a 3R arm.
        change: a change of posture, drawn into both.

    The cross-section is the half plane of the distance rho from axis 1 and the height z; a colour says how many
    postures reach a point (Baili, Wenger and Chablat 2004, figures 2 to 6).

    Example:
        >>> from chainrule import orthogonal_3r
        >>> drawing = draw_design(orthogonal_3r(1.0, 2.0, 1.5, 1.0))
        >>> drawing.get_suptitle().splitlines()[0]
        'Cuspidal: 4 cusps, 0 nodes; up to 4 postures'
    """
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.75, WIDTH * 1.02), layout="constrained")
        joint, section = drawing.subplots(1, 2)
        for axes in (joint, section):
            axes.spines[["top", "right"]].set_visible(False)
        curves = design.singular_curves()
        most = _cross_section(section, design, curves)
        _joint_space(joint, design, curves)
        if change is not None and change.path is not None:
            _change(joint, section, design, change)
        drawing.suptitle(finding(design, most), x=0.01, ha="left", fontsize=10.5, color=COLOURS["ink"])
        _legend(drawing, curves, change is not None and change.path is not None)
    return drawing


def finding(design: Regional3R, most: int) -> str:
    """The design in one or two lines: what it can do, and why."""
    cusps, nodes = len(design.cusps()), len(design.nodes())
    counts = f"{_plural(cusps, 'cusp')}, {_plural(nodes, 'node')}; up to {_plural(most, 'posture')}"
    if design.cuspidal:
        return f"Cuspidal: {counts}\nPostures can be changed without meeting a singularity, round a cusp"
    return f"Not cuspidal: {counts}\nEvery change of posture meets a singularity"


def _plural(number: int, word: str) -> str:
    return f"{number} {word}{'' if number == 1 else 's'}"


def _cross_section(axes: Axes, design: Regional3R, curves: Any) -> int:
    """Posture counts shaded, with the images of the singular curves; returns the largest count met."""
    images = np.concatenate([curve.image for curve in curves]) if curves else np.zeros((0, 2))
    reach = max(float(np.abs(images).max(initial=0.0)), 1e-9)
    low, high = (float(images[:, 1].min()), float(images[:, 1].max())) if len(images) else (-reach, reach)
    right = float(images[:, 0].max()) if len(images) else reach
    margin = 0.06 * max(high - low, right)
    rho = np.linspace(0.0, right + margin, GRID)
    z = np.linspace(low - margin, high + margin, GRID + 2)
    # a grid of an odd shape, away from the plane of symmetry, where singular points are not the exception
    counts = np.asarray(design.number_of_postures(rho[None, :], z[:, None]))
    shades = [COLOURS["fill"], COLOURS["fill_deep"]]
    axes.contourf(
        rho, z, counts, levels=[1.0, 3.0, 4.5], colors=shades
    )  # filled outlines: they follow a page's colours
    for k, curve in enumerate(_proper(curves)):
        colour, dashes = STROKES[k % len(STROKES)]
        axes.plot(*curve.image.T, color=colour, ls=dashes, lw=1.5, zorder=3)
    for curve in curves:
        if curve.line:
            axes.plot(*curve.image[0], "x", ms=7, mew=1.6, color=COLOURS["muted"], zorder=4)
    nodes, cusps = np.asarray(design.nodes()).reshape(-1, 2), np.asarray(design.cusps()).reshape(-1, 2)
    axes.plot(*nodes.T, "s", ms=7, mfc=COLOURS["paper"], mec=COLOURS["ink"], mew=1.3, zorder=5)
    axes.plot(*cusps.T, "o", ms=6.5, mfc=COLOURS["accent"], mec=COLOURS["paper"], mew=1.0, zorder=6)
    axes.set_aspect("equal")
    axes.set_xlim(0.0, rho[-1])
    axes.set_ylim(z[0], z[-1])
    axes.set_xlabel("distance from axis 1, ρ [m]")
    axes.set_ylabel("height, z [m]")
    axes.set_title("cross-section of the workspace", loc="left")
    return int(counts.max())


def _proper(curves: Any) -> list[Any]:
    """The curves whose image is a curve: the lines of the orthogonal arms have a point each."""
    return [curve for curve in curves if not curve.line]


def _joint_space(axes: Axes, design: Regional3R, curves: Any) -> None:
    """The singular curves over (q2, q3), the aspects shaded by the sign of det J and named where they are widest."""
    angles = np.linspace(-math.pi, math.pi, GRID)
    q = np.zeros((GRID, GRID, 3))
    q[..., 1], q[..., 2] = angles[None, :], angles[:, None]
    labels = np.asarray(design.aspect_of(q))
    every = design.aspects()
    signs = np.array([aspect.sign for aspect in every] + [0])[labels]
    degrees = np.degrees(angles)
    axes.contourf(degrees, degrees, signs, levels=[-1.5, 0.0], colors=[COLOURS["ground"]])
    for curve, look in _looks(curves):
        axes.plot(*_broken(curve.joint).T, zorder=3, **look)
    for aspect in every:
        row, column = _widest(labels == aspect.label)
        sign = "+" if aspect.sign > 0 else "−"
        axes.text(
            degrees[column],
            degrees[row],
            f"A{aspect.label + 1} {sign}",
            ha="center",
            va="center",
            fontsize=9,
            color=COLOURS["muted"],
            zorder=4,
        )
    axes.set_xlim(-180, 180)
    axes.set_ylim(-180, 180)
    axes.set_aspect("equal")
    axes.set_xticks(range(-180, 181, 90))
    axes.set_yticks(range(-180, 181, 90))
    axes.set_xlabel("θ2 [deg]")
    axes.set_ylabel("θ3 [deg]")
    axes.set_title("joint space, its aspects A and the sign of det J", loc="left")


def _looks(curves: Any) -> list[tuple[Any, dict[str, Any]]]:
    """Every curve with how it is drawn."""
    proper = _proper(curves)
    found = [
        (curve, {"color": STROKES[k % len(STROKES)][0], "ls": STROKES[k % len(STROKES)][1], "lw": 1.5})
        for k, curve in enumerate(proper)
    ]
    return [*found, *((curve, dict(_LINE)) for curve in curves if curve.line)]


def _broken(angles: Array) -> Array:
    """Angles (k, 2) in rad as degrees in [-180, 180], with a gap wherever a curve leaves on one side."""
    wrapped = np.degrees(np.remainder(angles + math.pi, 2 * math.pi) - math.pi)
    jumps = np.flatnonzero((np.abs(np.diff(wrapped, axis=0)) > 180).any(axis=1)) + 1
    found: Array = np.insert(wrapped, jumps, np.nan, axis=0)
    return found


def _widest(mask: Array) -> tuple[int, int]:
    """A place well inside a region of the torus: where it survives the most shrinking."""
    from scipy.ndimage import distance_transform_cdt

    rows, columns = mask.shape
    padded = np.pad(mask[:-1, :-1], (((rows - 1) // 2,) * 2, ((columns - 1) // 2,) * 2), mode="wrap")
    depth = distance_transform_cdt(padded)[
        (rows - 1) // 2 : -((rows - 1) // 2), (columns - 1) // 2 : -((columns - 1) // 2)
    ]
    margin = np.minimum(*np.meshgrid(*(_from_edge(n - 1) for n in (rows, columns)), indexing="ij"))
    inside = depth >= 0.6 * depth.max()
    best = np.unravel_index(int(np.argmax(np.where(inside, np.minimum(margin, 0.1) + 1e-4 * depth, -1.0))), depth.shape)
    return int(best[0]), int(best[1])


def _from_edge(count: int) -> Array:
    """How far places on a line are from its nearer end, as a share of its length: names are not cut off there."""
    place = (np.arange(count) + 0.5) / count
    found: Array = np.minimum(place, 1.0 - place)
    return found


def _change(joint: Axes, section: Axes, design: Regional3R, change: PostureChange) -> None:
    """A change of posture: its path in joint space and its image round the cusp."""
    s = np.linspace(0.0, 1.0, 801)
    q = change.sample(s)
    for axes, line in ((joint, _broken(q[:, 1:])), (section, change.image(801))):
        axes.plot(*line.T, color=COLOURS["paper"], lw=3.6, zorder=4.5)
        axes.plot(*line.T, color=COLOURS["accent"], lw=1.8, zorder=4.6)
    for axes, ends in ((joint, _broken(q[[0, -1], 1:])), (section, change.image(801)[[0, -1]])):
        ends = ends[~np.isnan(ends).any(axis=1)]
        axes.plot(*ends[:1].T, "o", ms=7, mfc=COLOURS["paper"], mec=COLOURS["accent"], mew=1.8, zorder=8)
        axes.plot(*ends[-1:].T, "D", ms=6, mfc=COLOURS["accent"], mec=COLOURS["paper"], mew=1.0, zorder=8)


def _legend(drawing: Figure, curves: Any, changed: bool) -> None:
    handles: list[tuple[Any, str]] = [
        (Patch(fc=COLOURS["fill"], ec=COLOURS["line"]), "2 postures"),
        (Patch(fc=COLOURS["fill_deep"], ec=COLOURS["line"]), "4 postures"),
    ]
    handles += [
        (Line2D([], [], color=STROKES[k % len(STROKES)][0], ls=STROKES[k % len(STROKES)][1]), f"singular curve {k + 1}")
        for k, _ in enumerate(_proper(curves))
    ]
    if len(_proper(curves)) < len(curves):
        handles.append((Line2D([], [], **_LINE), "tip on axis 2"))
    cusp: dict[str, Any] = {"marker": "o", "ls": "", "mfc": COLOURS["accent"], "mec": COLOURS["paper"], "ms": 6.5}
    node: dict[str, Any] = {"marker": "s", "ls": "", "mfc": COLOURS["paper"], "mec": COLOURS["ink"], "ms": 6.5}
    handles += [(Line2D([], [], **cusp), "cusp"), (Line2D([], [], **node), "node")]
    if changed:
        handles.append((Line2D([], [], color=COLOURS["accent"], lw=1.8), "change of posture"))
    drawing.legend(
        [handle for handle, _ in handles],
        [text for _, text in handles],
        loc="outside lower left",
        ncols=4,
        frameon=False,
        fontsize=8.5,
    )
