"""Number, length and box of the self-motions of many planar 3R arms at many targets, in one call."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.self_motions import planar_case as deciding
from chainrule.self_motions.planar_3r import FIRST, LAST, between_nodes, nodes, settled
from chainrule.self_motions.planar_case import REGULAR, SINGULAR, STATUS, Case, closed_boxes, evaluator
from chainrule.self_motions.planar_pieces import pieces_of

Array = NDArray[Any]
#: Targets treated at a time.
BLOCK = 1 << 14


@dataclass(frozen=True)
class SelfMotionMap:
    """Self-motions over targets or arms; the arrays' leading axes are those of lengths and targets, broadcast.

    Attributes:
        task: "position" or "x_alpha".
        lengths: (..., 3) of the arms, m.
        target: (..., 2) x and y, m, or x and alpha.
        status: (...) 0 unreachable, 1 regular, 2 singular; see :attr:`words`.
        number: (...) of curves; at a singular target of the pieces between its singular points, 0 for a surface.
        length: (...) of each curve, rad (two are mirror images); at a singular target of all pieces together; nan
            where there is no curve.
        box: (..., 3, 2) range of each joint on the first curve, unwrapped (the second is its mirror image about the
            target's direction); nan at targets that are not regular.
    """

    task: str
    lengths: Array
    target: Array
    status: Array
    number: Array
    length: Array
    box: Array

    @property
    def total(self) -> Array:
        """(...) length of all curves together, rad."""
        found: Array = np.where(self.status == REGULAR, self.number, 1) * self.length
        return found

    @property
    def words(self) -> Array:
        """(...) the statuses in words."""
        found: Array = np.array(STATUS)[self.status]
        return found

    @property
    def span(self) -> Array:
        """(..., 3) how far each joint moves, rad: the sides of the bounding box of Lewis and Maciejewski (1997)."""
        found: Array = self.box[..., 1] - self.box[..., 0]
        return found

    def to_dict(self) -> dict[str, Any]:
        """Plain lists; what is not a number is None."""
        return {
            "task": self.task,
            "lengths": self.lengths.tolist(),
            "target": self.target.tolist(),
            "status": self.words.tolist(),
            "number": self.number.tolist(),
            "length": _plain(self.length),
            "total": _plain(self.total),
            "box": _plain(self.box),
        }


def _plain(values: Array) -> Any:
    found = values.astype(object)
    found[~np.isfinite(values)] = None
    return found.tolist()


def self_motion_map(arm: Arm | Any, targets: Any, task: str = "position") -> SelfMotionMap:
    """Number, length and box of the self-motions of a planar 3R arm, or of many, at many targets.

    Args:
        arm: a planar arm with three revolute joints, or lengths (..., 3), m.
        targets: (..., 2) x and y, m; for the task "x_alpha" x, m, and alpha, rad. Broadcasts with the lengths.
        task: "position" or "x_alpha".

    Raises:
        InputError: another arm, negative lengths, numbers that are not finite, shapes that do not fit.

    Example:
        >>> from chainrule import planar_3r
        >>> found = self_motion_map(planar_3r(0.40, 0.35, 0.25), [[0.1, 0.0], [0.25, 0.0], [0.4, 0.0], [2.0, 0.0]])
        >>> found.number, found.length.round(6)
        (array([2, 1, 2, 0]), array([ 6.752948, 16.569213,  8.23831 ,       nan]))
    """
    task = deciding.checked_task(task)
    lengths = deciding.planar_lengths_of(arm) if isinstance(arm, Arm) else deciding.checked_lengths(arm)
    where = deciding.checked_targets(targets)
    try:
        shape = np.broadcast_shapes(lengths.shape[:-1], where.shape[:-1])
    except ValueError:
        raise InputError(
            f"self_motion_map: the leading axes of lengths {lengths.shape[:-1]} and targets {where.shape[:-1]} do not "
            "broadcast together"
        ) from None
    lengths, where = np.broadcast_to(lengths, (*shape, 3)), np.broadcast_to(where, (*shape, 2))
    flat_lengths, flat_targets = lengths.reshape(-1, 3), where.reshape(-1, 2)
    parts = [
        _block(flat_lengths[k : k + BLOCK], flat_targets[k : k + BLOCK], task)
        for k in range(0, max(len(flat_targets), 1), BLOCK)
    ]
    status, number, length, box = (np.concatenate(column) for column in zip(*parts, strict=True))
    return SelfMotionMap(
        task=task,
        lengths=lengths,
        target=where,
        status=status.reshape(shape),
        number=number.reshape(shape),
        length=length.reshape(shape),
        box=box.reshape(*shape, 3, 2),
    )


def _block(lengths: Array, targets: Array, task: str) -> tuple[Array, Array, Array, Array]:
    """Status, number, length and box of some targets."""
    scaled, reach, sums, zero, exponent, offset = deciding.cases(lengths, targets, task)
    status, number, nothing = deciding.counted(scaled, reach, sums, zero, task)
    length, box = np.full(len(targets), np.nan), np.full((len(targets), 3, 2), np.nan)
    plain = np.flatnonzero((status == REGULAR) & (nothing == 0))
    if plain.size:
        given = (reach[plain], sums[plain], scaled[plain])
        length[plain] = _half_lengths(*given, task) * (3 - number[plain])
        extremes = evaluator(f"extremes_{task}")(*given)
        q, rates, _, _ = evaluator(f"point_{task}")(np.array([1.0, 0.0]), *given)
        box[plain] = closed_boxes(task, extremes, q, np.sign(rates)) + offset[plain][..., None]
    known: dict[bytes, float] = {}
    for k in np.flatnonzero((status != deciding.UNREACHABLE) & ((status == SINGULAR) | (nothing > 0)) & (number > 0)):
        key = scaled[k].tobytes() + reach[k].tobytes() + zero[k].tobytes()
        case = Case(task, scaled[k], reach[k], sums[k], zero[k], int(exponent[k]), offset[k])
        if status[k] == REGULAR:  # circles: short work, and a box of their own
            pieces = pieces_of(case, int(status[k]), int(number[k]), int(nothing[k]))[1]
            ends = pieces[0].joints(np.array([0.0, 1.0]))
            length[k], box[k] = pieces[0].length, np.sort(ends, axis=0).T
            continue
        if key not in known:
            pieces = pieces_of(case, int(status[k]), int(number[k]), int(nothing[k]))[1]
            known[key] = math.fsum(piece.length for piece in pieces)
        length[k] = known[key]
    return status, number, length, box


def _half_lengths(reach: Array, sums: Array, lengths: Array, task: str) -> Array:
    """Half the length of all curves together, by the trapezoidal rule; nodes are doubled where it has not settled."""
    speed = evaluator(f"speed_{task}")
    found = np.empty(len(reach))
    open_, count = np.arange(len(reach)), FIRST
    given: tuple[Array, ...] = (reach[:, None], sums[:, None], lengths[:, None])
    both = speed(nodes(count), *given)
    mean, coarse, coarser = (both[:, ::step].mean(axis=1) for step in (1, 2, 4))
    before, change = np.abs(coarse - coarser), np.abs(mean - coarse)
    while True:
        ready = settled(mean, change, before) | (count >= LAST)
        found[open_[ready]] = mean[ready] * math.pi
        if ready.all():
            return found
        open_, mean, change = (array[~ready] for array in (open_, mean, change))
        given = tuple(array[~ready] for array in given)
        finer = (mean + _summed(speed, between_nodes(count), given) / count) / 2.0
        before, change, mean, count = change, np.abs(finer - mean), finer, 2 * count


def _summed(speed: Any, where: Array, given: tuple[Array, ...]) -> Array:
    """The sum of the speeds at some nodes, in blocks of nodes."""
    step = max(1, (1 << 20) // max(1, len(given[0])))
    total = np.zeros(len(given[0]))
    for k in range(0, len(where), step):
        total += speed(where[k : k + step], *given).sum(axis=1)
    return total
