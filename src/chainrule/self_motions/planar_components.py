"""What is reported of a piece of a planar 3R arm's self-motion: points, box, range of H, kept signs."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.self_motions.planar_case import closed_boxes
from chainrule.self_motions.planar_path import Path, wrapped
from chainrule.self_motions.planar_pieces import TURN, Piece
from chainrule.self_motions.result import Component

Array = NDArray[Any]


def component(arm: Arm, target: Array, task: str, points: int, piece: Piece) -> Component:
    """What is reported of a curve or an arc."""
    if piece.path is None or piece.length == 0.0:
        q = piece.joints(np.zeros(1))
        box, h = np.stack([q[0], q[0]], axis=-1), (float(arm.manipulability(q, task=task)[0]),) * 2
        closed, winding, closure = False, np.zeros(3, int), math.nan
    else:
        q = piece.joints(np.linspace(0.0, 1.0, points))
        h = _range_of_h(piece)
        box = _box(piece, q)
        closed = piece.closed
        winding = np.rint((q[-1] - q[0]) / TURN).astype(int) if closed else np.zeros(3, int)
        closure = 0.0 if closed else math.nan
    return Component(
        q=q,
        length=piece.length,
        closed=closed,
        winding=winding,
        box=box,
        manipulability=h,
        residual=_residual(arm, q, target, task),
        closure=closure,
        ends=piece.ends,
        signs=_signs(piece),
        of=piece.of,
        span=piece.span,
        points=piece.joints,
    )


def _residual(arm: Arm, q: Array, target: Array, task: str) -> float:
    place = arm.position(q)
    if task == "position":
        return float(np.linalg.norm(place - target, axis=-1).max())
    return float(max(np.abs(place[..., 0] - target[0]).max(), np.abs(wrapped(q.sum(axis=-1) - target[1])).max()))


def _range_of_h(piece: Piece) -> tuple[float, float]:
    """Least and greatest H: its local extremes, closed in on."""
    low, high = _over(piece, lambda parameter, path: path.evaluate(parameter)[1])
    return low * piece.case.scale_of_h, high * piece.case.scale_of_h


def _over(piece: Piece, function: Callable[[Array, Path], Array]) -> tuple[float, float]:
    """Extremes of a function of the parameter over the piece, end points included."""
    path = piece.path
    assert path is not None
    if piece.rounds >= 1.0:
        return path.extremes(lambda parameter: function(parameter, path))
    whole, ends = piece.located(np.array([0.0, 1.0]))
    if whole[0] == whole[1]:
        return between(path, ends[0], ends[1], function)
    low1, high1 = between(path, ends[0], path.end, function)
    low2, high2 = between(path, path.start, ends[1], function)
    return min(low1, low2), max(high1, high2)


def between(path: Path, first: float, last: float, function: Callable[[Array, Path], Array]) -> tuple[float, float]:
    """Extremes between two parameters of a path."""
    part = object.__new__(Path)
    part.start, part.end, part.edges = float(first), float(last), path.edges
    return part.extremes(lambda parameter: function(parameter, path))


def _box(piece: Piece, q: Array) -> Array:
    """Range of each unwrapped joint: in closed form on whole curves, else from its extremes along the piece."""
    low, high = q.min(axis=0), q.max(axis=0)
    if piece.angles is None or piece.rounds != 1.0 or not piece.closed:
        if piece.rounds > 1.0 or piece.path is None:
            return np.stack([low, high], axis=-1)
        found = []
        for joint in range(3):
            if piece.closed and abs(piece.advance[joint]) > 1.0:
                found.append(sorted((q[0, joint], q[0, joint] + piece.advance[joint])))
                continue
            ends = piece.joints(np.array([0.0, 1.0]))[:, joint]
            middle = (low[joint] + high[joint]) / 2.0
            values = _over(piece, _coordinate(piece.sign, joint))
            moved = piece.offset[joint] + piece.shift[joint]
            pair = np.sort(np.array(values)) + moved
            pair += TURN * np.rint((middle - pair.mean()) / TURN)
            found.append([min(pair[0], ends.min()), max(pair[1], ends.max())])
        return np.array(found)
    raw = piece.sign * (q[0] - piece.offset)  # of the curve that is not mirrored
    sense = piece.sign * np.sign(piece.advance)
    box = piece.sign * closed_boxes(piece.case.task, piece.angles, raw, sense)
    box = np.sort(box, axis=-1) + piece.offset[:, None]
    fits: Array = box + TURN * np.rint((low + high - box.sum(axis=-1)) / (2.0 * TURN))[:, None]
    return fits


def _coordinate(sign: float, joint: int) -> Callable[[Array, Path], Array]:
    """A joint's value as a function of the path's parameter."""

    def value(parameter: Array, path: Path) -> Array:
        found: Array = sign * path.joints_at(parameter)[..., joint]
        return found

    return value


def _signs(piece: Piece) -> dict[str, int]:
    """The sines that keep their sign on one of two curves: of angles between links none of which is the shortest."""
    if not piece.nested or piece.path is None:
        return {}
    q1, q2, q3 = piece.sign * piece.path.values[0]
    if piece.case.task == "x_alpha":
        headings = {"q1": q1, "q1+q2": q1 + q2}
        rolls = piece.path.values[-1] - piece.path.values[0]
        return {
            name: int(math.copysign(1.0, math.sin(angle)))
            for name, angle in headings.items()
            if abs(rolls[0] if name == "q1" else rolls[0] + rolls[1]) < 1.0
        }
    links = [*piece.case.lengths, piece.case.reach[0]]
    shortest = int(np.argmin(links))
    angles = {
        "q2": (0, 1, q2),
        "q3": (1, 2, q3),
        "q2+q3": (0, 2, q2 + q3),
        "q1-direction": (0, 3, q1),
        "q1+q2-direction": (1, 3, q1 + q2),
        "q1+q2+q3-direction": (2, 3, q1 + q2 + q3),
    }
    return {
        name: int(math.copysign(1.0, math.sin(angle)))
        for name, (i, j, angle) in angles.items()
        if shortest not in (i, j)
    }
