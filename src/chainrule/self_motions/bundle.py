"""Followed curves as one table, so that points on many of them are found in one call."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.self_motions.continuation import Dense
from chainrule.self_motions.held import CORRECTIONS, Held, target_shape
from chainrule.self_motions.tracing import quintic

Array = NDArray[Any]


@dataclass(frozen=True)
class Bundle:
    """The stored points of several curves, one after the other.

    Attributes:
        held: the arm and task.
        targets: what is held: one target for all curves, or one each.
        x, t, k: (rows, n) scaled joints, their first and second derivative by the length.
        s: (rows,) where a point is: the length so far on its curve, plus what ``offset`` says of the curve.
        first: (curves + 1,) the first row of each curve, and the number of rows.
        offset: (curves,) what is added to the lengths of a curve.
        length: (curves,)
    """

    held: Held
    targets: Array
    x: Array
    t: Array
    k: Array
    s: Array
    first: Array
    offset: Array
    length: Array

    @classmethod
    def of(cls, held: Held, tables: Sequence[Dense]) -> Bundle:
        """The curves as one; a single point stands for a curve on which nothing moves."""
        targets = tables[0].target
        if any(table.target is not targets for table in tables):
            targets = np.stack([table.target for table in tables])
        tables = [table if len(table.s) > 1 else _still(table) for table in tables]
        length = np.array([table.s[-1] for table in tables])
        offset = np.cumsum(length + 1.0) - length - 1.0
        return cls(
            held,
            targets,
            np.concatenate([table.x for table in tables]),
            np.concatenate([table.t for table in tables]),
            np.concatenate([table.k for table in tables]),
            np.concatenate([table.s + start for table, start in zip(tables, offset, strict=True)]),
            np.cumsum([0, *(len(table.s) for table in tables)]),
            offset,
            length,
        )

    @property
    def owner(self) -> Array:
        """(rows,) the curve of each row."""
        return np.repeat(np.arange(len(self.length)), np.diff(self.first))

    def between(self, curve: Array, at: Array) -> tuple[Array, Array, Array]:
        """For lengths (m,) on curves (m,): the row before, its distance to the next one, and the share of that."""
        s = at + self.offset[curve]
        row = np.searchsorted(self.s, s, side="right") - 1
        row = np.minimum(np.maximum(row, self.first[curve]), self.first[curve + 1] - 2)
        width = self.s[row + 1] - self.s[row]
        return row, width, (s - self.s[row]) / width

    def near(self, curve: Array, at: Array) -> Array:
        """(m, n): points of the quintics, scaled joints."""
        row, width, u = self.between(curve, at)
        w = width[:, np.newaxis]
        first, last = (
            (self.x.take(rows, axis=0), self.t.take(rows, axis=0) * w, self.k.take(rows, axis=0) * w**2)
            for rows in (row, row + 1)
        )
        return quintic(first, last, u[:, np.newaxis])

    def at(self, curve: Array, at: Array, corrections: int = CORRECTIONS) -> tuple[Array, Array]:
        """(m, n): joint values on the curves, and unit tangents of scaled joints, of either sense."""
        shared = self.targets.ndim == len(target_shape(self.held.arm, self.held.task))
        targets = self.targets if shared else self.targets[curve]
        return self.held.placed(self.near(curve, at) * self.held.unit, targets, corrections)


def _still(table: Dense) -> Dense:
    twice, nothing = np.repeat(table.x[:1], 2, axis=0), np.zeros((2, table.x.shape[1]))
    return Dense(table.held, table.target, twice, nothing, nothing, np.array([0.0, 1.0]))
