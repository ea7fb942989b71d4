"""Self-motions: the arm's postures along its curves beside the curves in joint space, and lengths over targets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.manipulability import unit
from chainrule.plot.arm import even, links, seen_from
from chainrule.plot.style import COLOURS, DASHES, FIELD, WIDTH, line_look, styled
from chainrule.self_motions.maps import self_motion_map
from chainrule.self_motions.planar_3r import planar_self_motion, singular_radii, singular_values
from chainrule.self_motions.result import ENDS, Component, SelfMotion
from chainrule.self_motions.words import finding, limits_finding

Array = NDArray[Any]

#: Postures in a fan, points of a line, of a line coloured piece by piece, and frames of an animation.
FAN, POINTS, SHADED, FRAMES = 14, 361, 181, 90


def draw_self_motion(arm: Arm, found: SelfMotion, which: int | None = None) -> Figure:
    """The postures along one curve as a fan, and the curves in joint space, coloured by the manipulability H.

    With three joints all curves are drawn over q2 and q3; with more, every joint of one curve over the share of its
    length. Where joint limits were looked at, what is outside them is faint.

    Args:
        arm: the arm.
        found: its self-motion.
        which: the curve that the fan shows; when absent the one of which limits leave most, else the first.

    Example:
        >>> from chainrule import planar_3r, self_motion
        >>> arm = planar_3r(0.40, 0.35, 0.25)
        >>> draw_self_motion(arm, self_motion(arm, [0.4, 0.0])).get_suptitle()
        '2 closed curves of length 8.238 rad each: the arm cannot pass from one to the other'
    """
    chosen = _chosen(found) if which is None else which
    scale = _scale(found)
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.75, WIDTH * 0.86), layout="constrained")
        if found.components:
            fan, joints = drawing.subplots(1, 2)
            _fan(fan, arm, found, chosen, scale)
            if arm.n == 3:
                _plane(joints, arm, found, scale)
            else:
                _over_length(joints, arm, found, chosen)
            _bar(drawing, arm, found, [fan, joints], scale)
        else:
            _no_curve(drawing.add_subplot(), arm, found)
        words = [finding(found), limits_finding(found)]
        drawing.suptitle(
            "\n".join(word for word in words if word), x=0.01, ha="left", fontsize=10.5, color=COLOURS["ink"]
        )
    return drawing


def _chosen(found: SelfMotion) -> int:
    """The curve of which limits leave most, the first where they leave all or nothing."""
    left = [0.0] * max(found.count, 1)
    for part in found.feasible or ():
        left[part.of or 0] += part.length
    return int(np.argmax(np.round(left, 6)))


def _scale(found: SelfMotion) -> Normalize:
    top = max((curve.manipulability[1] for curve in found.components), default=0.0)
    return Normalize(0.0, top if math.isfinite(top) and top > 1e-9 else 1.0)


def _bar(drawing: Figure, arm: Arm, found: SelfMotion, beside: list[Axes], scale: Normalize) -> None:
    """The scale of H, unless it is zero everywhere."""
    from matplotlib.cm import ScalarMappable

    if max(curve.manipulability[1] for curve in found.components) <= 1e-9:
        return
    bar: Any = drawing.colorbar(ScalarMappable(scale, FIELD), ax=beside, shrink=0.8, pad=0.02, aspect=32)
    bar.outline.set_visible(False)
    size = unit(arm, found.task)
    bar.set_label("manipulability H" + ("" if size.mixed or size.text == "1" else f" [{size.text}]"))


def _stations(curve: Component, count: int) -> Array:
    """Fractions of a curve's length for a fan: all of it, or the middle of one that goes on without end."""
    if curve.closed:
        return np.arange(count) / count
    half = min(0.5, math.pi / curve.length) if ENDS["length"] in curve.ends else 0.5
    return np.linspace(0.5 - half, 0.5 + half, count)


def _within(found: SelfMotion, index: int, s: Array) -> NDArray[np.bool_]:
    """Which fractions of a curve's length are within the limits; all where these were not looked at."""
    if found.feasible is None:
        return np.ones(s.shape, bool)
    inside = np.zeros(s.shape, bool)
    for part in found.feasible:
        if part.of == index:
            low, high = part.span
            inside |= part.closed | ((low <= s) & (s <= high)) | ((low <= s + 1.0) & (s + 1.0 <= high))
    return inside


def _height(arm: Arm, found: SelfMotion, q: Array) -> Array:
    result: Array = arm.manipulability(q, task=found.task)
    return result


def _fan(axes: Axes, arm: Arm, found: SelfMotion, index: int, scale: Normalize) -> None:
    """Postures at even steps along a curve."""
    colours, view, curve = colormaps[FIELD], seen_from(arm), found.components[index]
    single = len(curve.q) == 1
    s = np.zeros(1) if single else _stations(curve, FAN)
    q = curve.q[:1] if single else curve.at(s)
    for posture, height, inside in zip(q, _height(arm, found, q), _within(found, index, s), strict=True):
        line = links(arm, posture) @ view.T
        look: dict[str, Any] = {"lw": 2.2, "alpha": 1.0 if inside else 0.25, "zorder": 2.0 if inside else 1.5}
        axes.plot(*line.T, color=colours(scale(float(height))), solid_capstyle="round", **look)
        axes.plot(*line[1:-1].T, "o", ms=2.6, color=COLOURS["muted"], alpha=look["alpha"], zorder=look["zorder"] + 0.1)
        axes.plot(*line[-1], "o", ms=5.5, color=COLOURS["accent"], zorder=4)
    axes.plot(0.0, 0.0, "s", ms=6, color=COLOURS["ink"], zorder=4)
    even(axes, arm)
    number = f"curve {index + 1} of {found.count}" if found.count > 1 else "the curve"
    axes.set_title("the only posture" if single else f"{FAN} postures along {number}", loc="left")


def _no_curve(axes: Axes, arm: Arm, found: SelfMotion) -> None:
    """The arm in its zero posture, and the target where it is a point."""
    view = seen_from(arm)
    axes.plot(*(links(arm, np.zeros(arm.n)) @ view.T).T, "o-", color=COLOURS["link"], lw=3, ms=4, label="arm at q = 0")
    axes.plot(0.0, 0.0, "s", ms=7, color=COLOURS["ink"])
    if found.task != "x_alpha":
        where = found.target[:3, 3] if found.target.shape == (4, 4) else np.append(found.target, [0.0])[:3]
        where = where * ([1.0, 1.0, 0.0] if "x_alpha" in arm.tasks else 1.0)
        axes.plot(*(view @ where), "x", ms=9, mew=2.2, color=COLOURS["accent"], label="target")
    even(axes, arm)
    axes.legend(frameon=False, fontsize=8.5)


def _plane(axes: Axes, arm: Arm, found: SelfMotion, scale: Normalize) -> None:
    """The curves over q2 and q3, coloured by H: angles wrapped into (-180, 180] deg, slides in m."""
    turning = np.array([kind == "R" for kind in arm.kinds[1:]])
    for k, curve in enumerate(found.components):
        s = np.linspace(0.0, 1.0, SHADED)
        q = curve.at(s) if len(curve.q) > 1 else curve.q
        xy = np.where(turning, np.degrees(q[:, 1:]), q[:, 1:])
        if np.ptp(xy, axis=0).max() < 1e-6:  # a point, or a circle of q1 alone
            axes.plot(*np.where(turning, _wrapped(xy[0]), xy[0]), "o", ms=8, color=COLOURS["accent"])
        else:
            inside = _within(found, k, s)
            for line, height, near in _pieces(xy, turning, _height(arm, found, q), inside):
                segments = np.stack([line[:-1], line[1:]], axis=1)
                whole = LineCollection(list(segments), array=height[:-1], cmap=FIELD, norm=scale)
                whole.set(linewidth=3.2 if near else 1.2, alpha=1.0 if near else 0.7)
                if near:
                    axes.plot(*line.T, color=COLOURS["ink"], lw=4.4, zorder=1.9, solid_capstyle="butt")
                axes.add_collection(whole, autolim=True)
        if found.count > 1:
            at = np.where(turning, _wrapped(xy[len(xy) // 3]), xy[len(xy) // 3])
            axes.annotate(
                str(k + 1),
                (float(at[0]), float(at[1])),
                (7, 4),
                textcoords="offset points",
                color=COLOURS["ink"],
                fontsize=9,
            )
    axes.autoscale_view()
    _joint_axes(axes, arm)
    outside = (
        found.feasible is not None and bool(found.feasible) and sum(p.length for p in found.feasible) < found.length
    )
    axes.set_title("joint space, coloured by H" + ("; thin: outside the limits" if outside else ""), loc="left")


def _wrapped(angles: Array) -> Array:
    """Into (-180, 180]."""
    found: Array = 180.0 - np.remainder(180.0 - angles, 360.0)
    return found


def _pieces(
    xy: Array, turning: NDArray[np.bool_], values: Array, inside: NDArray[np.bool_]
) -> list[tuple[Array, Array, bool]]:
    """A line, its angles wrapped and cut where they leave on one side, and where it crosses joint limits."""
    wrapped = np.where(turning, _wrapped(xy), xy)
    jump: NDArray[np.bool_] = np.any((np.abs(np.diff(wrapped, axis=0)) > 180.0) & turning, axis=1)
    cuts = np.flatnonzero(jump | (inside[1:] != inside[:-1])) + 1
    parts = []
    for a, b in pairwise([0, *cuts, len(xy)]):
        b += b < len(xy) and not jump[b - 1]  # up to the first point of the next piece, where there is no gap
        if b - a > 1:
            parts.append((wrapped[a:b], values[a:b], bool(inside[a])))
    return parts


def _joint_axes(axes: Axes, arm: Arm) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    for name, kind, joint in zip("xy", arm.kinds[1:3], ("q2", "q3"), strict=True):
        getattr(axes, f"set_{name}label")(f"{joint} [{'deg' if kind == 'R' else 'm'}]")
        if kind == "R":
            getattr(axes, f"set_{name}lim")(-180, 180)
            getattr(axes, f"set_{name}ticks")(range(-180, 181, 90))
        else:
            getattr(axes, f"{name}axis").set_major_locator(MaxNLocator(5))
    if arm.kinds[1:3] == "RR":
        axes.set_aspect("equal")


def _over_length(axes: Axes, arm: Arm, found: SelfMotion, index: int) -> None:
    """Every joint along a curve; grey ground where all are within their limits."""
    curve = found.components[index]
    axes.spines[["top", "right"]].set_visible(False)
    s = np.linspace(0.0, 1.0, POINTS)
    q = curve.at(s) if len(curve.q) > 1 else np.repeat(curve.q[:1], POINTS, axis=0)
    turning = np.array([kind == "R" for kind in arm.kinds])
    for j in range(arm.n):
        values = np.degrees(q[:, j]) if turning[j] else 1000.0 * q[:, j]
        if turning[j]:
            values = values - 360.0 * round(float(values.mean()) / 360.0)
        axes.plot(100.0 * s, values, lw=1.6, label=f"q{j + 1}", **line_look(j))
    if found.feasible is not None:
        for a, b in _runs(_within(found, index, s)):
            axes.axvspan(100.0 * s[a], 100.0 * s[b - 1], color=COLOURS["fill"], lw=0, zorder=0)
    axes.set_xlim(0.0, 100.0)
    axes.set_xlabel("share of the curve's length [%]")
    axes.set_ylabel("joint [deg]" if turning.all() else "joint [deg or mm]")
    number = f"curve {index + 1} of {found.count}" if found.count > 1 else "the curve"
    some = found.feasible is not None and any(part.of == index for part in found.feasible)
    axes.set_title(f"joints along {number}" + ("; shaded: within all limits" if some else ""), loc="left")
    axes.legend(ncols=4, frameon=False, fontsize=8.5, loc="upper center", bbox_to_anchor=(0.5, -0.14))


def _runs(inside: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Where true values begin and end."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
    return [(int(a), int(b)) for a, b in edges.reshape(-1, 2)]


# ---- over targets ------------------------------------------------------------------------------------------------


def draw_lengths(arm: Arm, task: str = "position", other: float = 0.0, points: int = 801) -> Figure:
    """The length of the self-motion over px, its regions, and the square-root cusps of the total at their borders.

    Lenarcic, figures 2 (task position, py = 0) and 4 (task x_alpha).

    Args:
        arm: a planar arm with three revolute joints.
        task: "position" or "x_alpha".
        other: py, m; for x_alpha the last link's direction, rad.
        points: values of px in each region.

    Raises:
        InputError: a ``py`` that is out of reach.

    Example:
        >>> from chainrule import planar_3r
        >>> draw_lengths(planar_3r(0.40, 0.35, 0.25)).axes[0].get_title(loc="left").splitlines()[0]
        'Two curves where px is in region A or C, one in B or D'
    """
    if task == "position":
        radii = singular_radii(arm.parameters)
        if not abs(other) < radii[-1]:
            raise InputError(f"py = {other:g} m: out of reach; less than {radii[-1]:g} m is accepted")
        borders = np.sqrt(radii[radii > abs(other)] ** 2 - other**2)
        low = 0.0
    else:
        borders = singular_values(arm.parameters, other)
        low = float(borders.min())
    x = _clustered(low, float(borders.max()), borders, points)
    found = self_motion_map(arm, np.stack([x, np.full(x.shape, other)], axis=-1), task)
    with styled():
        drawing = Figure(figsize=(WIDTH * 1.4, WIDTH * 0.8), layout="constrained")
        axes = drawing.add_subplot()
        axes.spines[["top", "right"]].set_visible(False)
        regular = (found.status == 1) | (found.number == 0)
        total, each = (np.where(regular, np.nan_to_num(v), np.nan) for v in (found.total, found.length))
        for k, region in enumerate(np.split(np.arange(len(x)), len(x) // points)):
            name = (None, None) if k else ("all curves together", "the curve that the arm is on")
            axes.plot(x[region], total[region], color=COLOURS["muted"], lw=1.3, ls=(0, (4, 2)), label=name[0])
            axes.plot(x[region], each[region], color=COLOURS["link"], lw=2.0, label=name[1])
        for border in borders:
            axes.axvline(border, color=COLOURS["line"], lw=0.9, zorder=0.5)
        edges = np.unique(np.concatenate([[low], borders]))
        named = _name_regions(axes, edges, x, found.number)
        axes.set_ylim(0.0, 1.12 * float(np.nanmax(total)))
        axes.set_xlim(x[0], x[-1])
        axes.set_xlabel(
            "px [m]" + (f", py = {other:.4g} m" if task == "position" else f", α = {math.degrees(other):.4g}°")
        )
        axes.set_ylabel("length s [rad]")
        axes.legend(frameon=False, fontsize=8.5, loc="lower center")
        axes.set_title(
            f"{_where(named)}\nthe length of the curve the arm is on jumps at a border, that of all together does not",
            loc="left",
        )
    return drawing


def _where(named: list[tuple[str, int]]) -> str:
    """How many curves there are where, in words."""
    words = {0: ("None", ""), 1: ("One", "curve "), 2: ("Two", "curves ")}
    texts: list[str] = []
    for number in (2, 1, 0):
        names = [name for name, count in named if count == number]
        if names:
            first, noun = words[number]
            start = f"{first.lower()} in" if texts else f"{first} {noun}where px is in region"
            texts.append(f"{start} {' or '.join(names)}")
    return ", ".join(texts)


def _clustered(low: float, high: float, borders: Array, points: int) -> Array:
    """Values between two ends, dense beside the borders, none on them."""
    edges = np.unique(np.concatenate([[low, high], borders[(borders > low) & (borders < high)]]))
    u = 0.5 - 0.5 * np.cos(math.pi * (np.arange(points) + 0.5) / points)
    return np.concatenate([a + (b - a) * u for a, b in pairwise(edges)])


def _name_regions(axes: Axes, edges: Array, x: Array, number: Array) -> list[tuple[str, int]]:
    """Letters over the regions between borders, each with its number of curves."""
    named = []
    for letter, (a, b) in zip("ABCDEFGH", pairwise(edges), strict=False):
        inside = (x > a) & (x < b)
        if inside.any():
            named.append((letter, int(np.median(number[inside]))))
            at: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "ha": "center", "color": COLOURS["ink"]}
            axes.text((a + b) / 2, 0.94, letter, **at)
    return named


def draw_curves(arm: Arm, values: Sequence[float], task: str = "position", other: float = 0.0) -> Figure:
    """The curves of several px: on the joint torus of q2 and q3, unwrapped, and in the space of all three joints.

    Lenarcic, figures 3 and 5.

    Args:
        arm: a planar arm with three revolute joints.
        values: px, m.
        task: "position" or "x_alpha".
        other: py, m; for x_alpha the last link's direction, rad.
    """
    with styled():
        drawing = Figure(figsize=(WIDTH * 2.1, WIDTH * 0.8), layout="constrained")
        grid = drawing.add_gridspec(1, 3, width_ratios=[1.0, 1.0, 1.25])
        torus, plain = drawing.add_subplot(grid[0]), drawing.add_subplot(grid[1])
        space: Any = drawing.add_subplot(grid[2], projection="3d")
        shades = [COLOURS[name] for name in ("link", "joint", "accent", "axis_y", "axis_z", "muted")]
        counts = []
        for k, x in enumerate(values):
            found = planar_self_motion(arm, [x, other], task)
            counts.append(found.count)
            look: dict[str, Any] = {"color": shades[k % 6], "ls": DASHES[k % 4], "lw": 1.5}
            for component in found.components:
                q = np.degrees(component.at(np.linspace(0.0, 1.0, POINTS)))
                every = np.ones(len(q), bool)
                for line, _, _ in _pieces(q[:, 1:], every[:2], q[:, 0], every):
                    torus.plot(*line.T, **look)
                plain.plot(*q[:, 1:].T, **look)
                space.plot(*q.T, **look)
        _joint_axes(torus, arm)
        torus.set_title("on the torus", loc="left")
        plain.set_title("unwrapped", loc="left")
        plain.set_xlabel("q2 [deg]")
        plain.set_ylabel("q3 [deg]")
        plain.spines[["top", "right"]].set_visible(False)
        space.set_title("all three joints", loc="left")
        for name, label in zip("xyz", ("q1", "q2", "q3"), strict=True):
            getattr(space, f"set_{name}label")(f"{label} [deg]")
            getattr(space, f"{name}axis").set_pane_color((1.0, 1.0, 1.0, 0.0))
        space.tick_params(labelsize=7)
        space.set_box_aspect(None, zoom=0.9)
        handles = [Line2D([], [], color=shades[k % 6], ls=DASHES[k % 4]) for k in range(len(values))]
        texts = [f"px = {x:g} m: {n} curve{'' if n == 1 else 's'}" for x, n in zip(values, counts, strict=True)]
        drawing.legend(handles, texts, loc="outside lower left", ncols=4, frameon=False, fontsize=8.5)
        drawing.suptitle(_counted(values, counts), x=0.01, ha="left", fontsize=10.5, color=COLOURS["ink"])
    return drawing


def _counted(values: Sequence[float], counts: list[int]) -> str:
    """How many curves at which px, in words."""
    texts = []
    for number in sorted(set(counts), reverse=True):
        places = ", ".join(f"{x:g}" for x, count in zip(values, counts, strict=True) if count == number)
        texts.append(f"{number} curve{'' if number == 1 else 's'} at px = {places} m")
    return "; ".join(texts)


def animation(arm: Arm, found: SelfMotion, which: int | None = None, frames: int = FRAMES) -> bytes:
    """The arm moving once along a curve, as an animated GIF; along an arc there and back.

    Args:
        arm: the arm.
        found: its self-motion, with at least one curve.
        which: the curve; when absent the longest curve or arc that limits leave, else the first curve.
        frames: pictures in one round.
    """
    import io

    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    longest = max(found.feasible or found.components[:1], key=lambda part: part.length)
    component = longest if which is None else found.components[which]
    turn = np.arange(frames) / frames
    s = turn if component.closed else 0.5 - 0.5 * np.cos(2.0 * math.pi * turn)
    q = component.at(s) if len(component.q) > 1 else component.q[:1]
    lines = [links(arm, posture) @ seen_from(arm).T for posture in q]
    every = np.concatenate(lines)
    pictures = []
    with styled():
        drawing = Figure(figsize=(WIDTH * 0.8, WIDTH * 0.8), facecolor=COLOURS["paper"])
        canvas: Any = FigureCanvasAgg(drawing)
        axes = drawing.add_axes((0.02, 0.02, 0.96, 0.88))
        axes.set_aspect("equal")
        axes.set_axis_off()
        middle, half = (every.max(axis=0) + every.min(axis=0)) / 2, float(np.ptp(every, axis=0).max()) / 2 * 1.1
        axes.set_xlim(middle[0] - half, middle[0] + half)
        axes.set_ylim(middle[1] - half, middle[1] + half)
        axes.set_title(
            f"{arm.name}: the {'tip rests' if found.task != 'x_alpha' else 'task is held'}, the arm moves", loc="left"
        )
        for line in lines[:: max(1, frames // 30)]:
            axes.plot(*line.T, color=COLOURS["fill"], lw=1.0, zorder=1)
        axes.plot(*lines[0][0], "s", ms=8, color=COLOURS["ink"], zorder=2)
        canvas.draw()
        ground = canvas.copy_from_bbox(drawing.bbox)
        (bones,) = axes.plot([], [], "o-", color=COLOURS["link"], lw=4, ms=6, mfc=COLOURS["paper"])
        (tip,) = axes.plot([], [], "o", ms=8, color=COLOURS["accent"])
        for line in lines:  # only what moves is drawn anew
            canvas.restore_region(ground)
            bones.set_data(*line.T)
            tip.set_data(*line[-1:].T)
            axes.draw_artist(bones)
            axes.draw_artist(tip)
            pictures.append(Image.fromarray(np.array(canvas.buffer_rgba())).convert("RGB"))
    shades = _palette(Image)
    pictures = [picture.quantize(palette=shades, dither=Image.Dither.NONE) for picture in pictures]
    stream = io.BytesIO()
    pictures[0].save(stream, "GIF", save_all=True, append_images=pictures[1:], duration=50, loop=0, optimize=True)
    return stream.getvalue()


def _palette(image: Any) -> Any:
    """The colours of an animation and what lies between each and the ground (edges are smoothed), as a palette."""
    from matplotlib.colors import to_rgb

    ground = np.array(to_rgb(COLOURS["paper"]))
    names, steps = ("link", "accent", "ink", "fill"), np.linspace(0.0, 1.0, 16)[:, np.newaxis]
    mixed = [ground + steps * (np.array(to_rgb(COLOURS[name])) - ground) for name in names]
    palette = image.new("P", (1, 1))
    palette.putpalette(np.round(255.0 * np.concatenate(mixed)).astype(int).ravel().tolist())
    return palette
