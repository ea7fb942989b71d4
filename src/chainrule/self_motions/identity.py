"""Which known curve a configuration lies on: what keeps a curve from being listed twice, and what labels follow."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.self_motions.continuation import Dense, Held, quintic
from chainrule.self_motions.result import Component

Array = NDArray[Any]

#: A configuration nearer than this to a curve is on it, rad; how many near points of the curves are tried.
ON, TRIED = 1e-8, 6
#: Points taken of curves that bring none of their own.
SAMPLES = 512


@dataclass
class Known:
    """The curves of one target, to be asked which of them a configuration is on.

    Attributes:
        held: the arm and task.
        target: what is held.
        components: the curves so far.
    """

    held: Held
    target: Array
    components: list[Component] = field(default_factory=list)
    _tables: list[Dense] = field(default_factory=list)
    _tree: Any = None
    _owner: Any = None
    _place: Any = None
    _gap: Any = None

    def add(self, component: Component) -> None:
        """One more curve."""
        self.components.append(component)
        self._tables.append(_table(self.held, self.target, component))
        self._tree = None

    def embedded(self, q: Array) -> Array:
        """(k, 2n): cosines and sines of angles; shifts over the length scale, and 0."""
        turning, x = self.held.revolute, q / self.held.unit
        return np.concatenate([np.where(turning, np.cos(x), x), np.where(turning, np.sin(x), 0.0)], axis=-1)

    def which(self, q: Array) -> Array:
        """(k,): the index of the curve that each of the configurations (k, n) is on, or -1.

        The configurations must hold the target. Nearest points of the curves are moved along the quintics between
        them to the foot of the configuration; what is left of the distance across the curve decides.
        """
        found = np.full(len(q), -1)
        tables = self._tables
        if not len(q) or not tables:
            return found
        if self._tree is None:
            from scipy.spatial import cKDTree

            points = np.concatenate([table.x for table in tables]) * self.held.unit
            self._owner = np.concatenate([np.full(len(table.s), k) for k, table in enumerate(self._tables)])
            self._place = np.concatenate([np.arange(len(table.s)) for table in tables])
            self._gap = np.array([np.diff(table.s).max(initial=0.0) for table in tables]) + ON
            self._tree = cKDTree(self.embedded(points))
        tried = min(TRIED, len(self._owner))
        far, near = self._tree.query(self.embedded(q), k=tried)
        far, near = far.reshape(len(q), tried), near.reshape(len(q), tried)
        close = far <= self._gap[self._owner[near]]  # a point of the curve has a stored one within a step
        for column in range(tried):
            open_ = np.flatnonzero((found < 0) & close[:, column])
            if not len(open_):
                continue
            owners = self._owner[near[open_, column]]
            for k in np.unique(owners):
                mine = open_[owners == k]
                table = self._tables[k]
                apart = self._distance(table, self._place[near[mine, column]], q[mine])
                found[mine[apart < ON]] = k
        return found

    def _distance(self, table: Dense, place: Array, q: Array) -> Array:
        """(k,): how far configurations are from a curve near its points ``place``, rad."""
        x = q / self.held.unit
        if len(table.s) < 2:
            return np.asarray(np.linalg.norm(self._wrapped(x - table.x[place]), axis=1))
        at = table.s[place]
        for _ in range(4):
            c, t = _point(table, at)
            at = at + (t * self._wrapped(x - c)).sum(axis=1)
        c, t = _point(table, at)
        left = self._wrapped(x - c)
        near = np.linalg.norm(left, axis=1) < 1e-3
        if near.any():
            exact = self.held.corrected(c[near] * self.held.unit, self.target, 2) / self.held.unit
            left[near] = self._wrapped(x[near] - exact)
        size = np.linalg.norm(left, axis=1)
        across = left - t * (t * left).sum(axis=1, keepdims=True)
        return np.asarray(np.where(size < 1e-4, np.linalg.norm(across, axis=1), math.inf))

    def _wrapped(self, x: Array) -> Array:
        turn = 2.0 * math.pi
        return np.asarray(np.where(self.held.revolute, x - turn * np.rint(x / turn), x))


def _point(table: Dense, at: Array) -> tuple[Array, Array]:
    """Points (k, n) of the quintics and unit tangents there; ``at`` beyond the ends goes on with the next round."""
    total = table.s[-1]
    at = np.mod(at, total)
    j = np.clip(np.searchsorted(table.s, at, side="right") - 1, 0, len(table.s) - 2)
    width = (table.s[j + 1] - table.s[j])[:, np.newaxis]
    u = (at - table.s[j])[:, np.newaxis] / width
    first = (table.x[j], table.t[j] * width, table.k[j] * width**2)
    last = (table.x[j + 1], table.t[j + 1] * width, table.k[j + 1] * width**2)
    t = table.t[j] * (1.0 - u) + table.t[j + 1] * u
    return quintic(first, last, u), t / np.linalg.norm(t, axis=1, keepdims=True)


def _table(held: Held, target: Array, component: Component) -> Dense:
    """Points, tangents and bends along a curve."""
    if isinstance(component.points, Dense):
        return component.points
    if len(component.q) < 2 or component.length == 0.0:
        x = component.q[:1] / held.unit
        return Dense(held, target, x, np.zeros_like(x), np.zeros_like(x), np.zeros(1))
    fractions = np.linspace(0.0, 1.0, SAMPLES + 1)
    q = component.at(fractions)
    null, bending = (part / held.unit for part in held.bend(q))
    size = np.linalg.norm(null, axis=1, keepdims=True)
    x = q / held.unit
    with np.errstate(all="ignore"):
        t = null / size * np.sign(((x[1:] - x[:-1]) * null[:-1]).sum())
        k = (bending - t * (t * bending).sum(axis=1, keepdims=True)) / size**2
    return Dense(held, target, x, np.nan_to_num(t), np.nan_to_num(k), fractions * component.length)
