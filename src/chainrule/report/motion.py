"""A motion of the arm that a slider moves: every posture computed when the page is written, shown one at a time.

Without scripts the figure is its first posture among others of the motion. Nothing moves by itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.plot.arm import projection
from chainrule.report.content import Motion
from chainrule.skeleton import skeletons
from chainrule.tables import posture, readable

Array = NDArray[Any]

#: Postures of a motion, and how many of them stay visible behind the arm.
FRAMES, GHOSTS = 73, 12
#: The picture's width and margin, and the chart's frame (left, right, top, bottom), in its units.
WIDTH, MARGIN = 400.0, 26.0
LEFT, RIGHT, TOP, BOTTOM = 64.0, 392.0, 14.0, 96.0


@dataclass(frozen=True)
class Track:
    """One motion to choose.

    Attributes:
        name: what it is called.
        q: (k, n) its postures.
        values: (k,) what the chart shows.
        inside: (k,) whether each posture is within the joint limits; None where there are none to look at.
        start: the posture shown first.
    """

    name: str
    q: Array
    values: Array
    inside: NDArray[np.bool_] | None = None
    start: int = 0


def motion(
    arm: Arm,
    key: str,
    tracks: Sequence[Track],
    *,
    label: str,
    chart: str,
    symbol: str,
    unit: str,
    title: str,
    caption: str,
) -> Motion:
    """Tracks as a figure with a slider.

    Args:
        arm: the arm.
        key: starts every id.
        tracks: the motions.
        label: what the slider does.
        chart: what the chart shows, in words.
        symbol: its symbol.
        unit: its unit, or "".
        title: of the picture, for those who do not see it.
        caption: below.
    """
    view = np.eye(3)[:2] if "x_alpha" in arm.tasks else projection()[:2]
    lines = [skeletons(arm, track.q) @ view.T for track in tracks]
    every = np.concatenate([line.reshape(-1, 2) for line in lines])
    low, extent = every.min(axis=0), np.maximum(np.ptp(every, axis=0), 1e-9)
    scale = min((WIDTH - 2 * MARGIN) / extent[0], (WIDTH - 2 * MARGIN) / extent[1])
    height = float(np.ceil(max(extent[1] * scale + 2 * MARGIN, 0.4 * WIDTH)))
    shift = (np.array([WIDTH, height]) - extent * scale) / 2
    placed = [(line - low) * scale + shift for line in lines]
    for line in placed:
        line[..., 1] = height - line[..., 1]
    bounds = _bounds(tracks)
    suffix = f" {unit}" if unit else ""
    plain = tuple(
        {
            "name": track.name,
            "frames": [_points(frame) for frame in line],
            "texts": [_text(arm, track, k, symbol, suffix) for k in range(len(track.q))],
            "line": _points(_curve(track, bounds)),
            "inside": _within(track, bounds),
            "start": track.start,
        }
        for track, line in zip(tracks, placed, strict=True)
    )
    base = placed[0][0, 0]
    shown = _text(arm, tracks[0], tracks[0].start, symbol, suffix)
    description = f"The arm in front of {GHOSTS} other postures of this motion: {shown}. The slider moves it."
    frame = {
        "left": LEFT,
        "right": RIGHT,
        "top": TOP,
        "bottom": BOTTOM,
        "zero": float(BOTTOM + (BOTTOM - TOP) * bounds[0] / (bounds[1] - bounds[0])),
        "ticks": [readable(bounds[1], 3), readable(bounds[0], 3)],
        "title": f"{chart} {symbol}" + (f" [{unit}]" if unit else ""),
    }
    return Motion(key, title, description, label, height, (float(base[0]), float(base[1])), plain, frame, caption)


def _bounds(tracks: Sequence[Track]) -> tuple[float, float]:
    """Least and greatest value of the chart, with 0."""
    values = np.concatenate([track.values for track in tracks])
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    return low, high if high > low else low + 1.0


def _points(line: Array) -> str:
    """A line as the points of an SVG polyline."""
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in line)


def _curve(track: Track, bounds: tuple[float, float]) -> Array:
    """The chart's line (k, 2)."""
    low, high = bounds
    x = np.linspace(LEFT, RIGHT, len(track.values))
    return np.stack([x, BOTTOM - (BOTTOM - TOP) * (track.values - low) / (high - low)], axis=1)


def _within(track: Track, bounds: tuple[float, float]) -> str:
    """The part of the chart's line within the limits, as the path of an SVG: all of it where there are none."""
    line = _curve(track, bounds)
    inside = np.ones(len(line), bool) if track.inside is None else track.inside
    words = []
    for k, (x, y) in enumerate(line):
        if inside[k]:
            words.append(f"{'L' if k and inside[k - 1] else 'M'}{x:.1f} {y:.1f}")
    return " ".join(words)


def _text(arm: Arm, track: Track, k: int, symbol: str, suffix: str) -> str:
    """A posture in words."""
    value = f"{symbol} = {readable(float(track.values[k]), 4)}{suffix}".replace(" ", "\u00a0")
    said = f"{posture(arm, track.q[k])}; {value}"
    if track.inside is None:
        return said
    return f"{said}; {'within' if track.inside[k] else 'outside'} the joint limits"
