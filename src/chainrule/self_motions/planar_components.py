"""What is reported of a piece of a planar 3R arm's self-motion: points, box, range of H, kept signs."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
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
    low, high = _over(piece, lambda path, rounds, parameter: path.evaluate(parameter)[1])
    return low * piece.case.scale_of_h, high * piece.case.scale_of_h


#: A function of the path, whole rounds, and the path's parameter.
Quantity = Callable[[Path, int, Array], Array]


def _over(piece: Piece, quantity: Quantity) -> tuple[float, float]:
    """Extremes of a quantity over the piece, end points included, round by round."""
    path = piece.path
    assert path is not None
    end = piece.begin + piece.rounds
    found = []
    for rounds in range(math.floor(piece.begin), math.ceil(end)):
        first, last = max(piece.begin - rounds, 0.0), min(end - rounds, 1.0)
        if last > first:
            between = path.parameter_at(np.array([first, last]) * path.length)
            found.append(path.extremes(partial(quantity, path, rounds), between[0], between[1]))
    return min(low for low, _ in found), max(high for _, high in found)


def _box(piece: Piece, q: Array) -> Array:
    """Range of each unwrapped joint: in closed form on whole curves, else from its extremes along the piece."""
    if piece.angles is None or not piece.closed:
        found = [_over(piece, _coordinate(piece, joint)) for joint in range(3)]
        ends = piece.joints(np.array([0.0, 1.0]))  # at a stop, exactly
        low, high = (np.array(values) for values in zip(*found, strict=True))
        return np.stack([np.minimum(low, ends.min(axis=0)), np.maximum(high, ends.max(axis=0))], axis=-1)
    raw = piece.sign * (q[0] - piece.offset)  # of the curve that is not mirrored
    sense = piece.sign * np.sign(piece.advance)
    box = piece.sign * closed_boxes(piece.case.task, piece.angles, raw, sense)
    box = np.sort(box, axis=-1) + piece.offset[:, None]
    middle = q.min(axis=0) + q.max(axis=0) - box.sum(axis=-1)
    fits: Array = box + TURN * np.rint(middle / (2.0 * TURN))[:, None]
    return fits


def _coordinate(piece: Piece, joint: int) -> Quantity:
    """A joint's value as a function of the path's parameter."""

    def value(path: Path, rounds: int, parameter: Array) -> Array:
        found: Array = piece.at_parameter(np.full(np.shape(parameter), float(rounds)), parameter)[..., joint]
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
