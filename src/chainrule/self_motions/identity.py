"""Which known curve a configuration lies on: what keeps a curve from being listed twice, and what labels follow."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.self_motions.bundle import Bundle
from chainrule.self_motions.continuation import Dense
from chainrule.self_motions.held import Held
from chainrule.self_motions.result import Component
from chainrule.self_motions.tracing import quintic

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
    _bundle: Bundle | None = None
    _tree: Any = None
    _owner: Any = None
    _gap: Any = None

    def add(self, component: Component) -> None:
        """One more curve."""
        self.components.append(component)
        self._tables.append(table(self.held, self.target, component))
        self._bundle = None

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
        if not len(q) or not self._tables:
            return found
        if self._bundle is None:
            from scipy.spatial import cKDTree

            self._bundle = Bundle.of(self.held, self._tables)
            self._owner = self._bundle.owner
            self._gap = np.array([np.diff(each.s).max(initial=0.0) for each in self._tables]) + ON
            self._tree = cKDTree(self.embedded(self._bundle.x * self.held.unit))
        tried = min(TRIED, len(self._owner))
        far, near = self._tree.query(self.embedded(q), k=tried)
        far, near = far.reshape(len(q), tried), near.reshape(len(q), tried)
        close = far <= self._gap[self._owner[near]]  # a point of the curve has a stored one within a step
        for column in range(tried):
            open_ = np.flatnonzero((found < 0) & close[:, column])
            if not len(open_):
                continue
            rows = near[open_, column]
            on = self._distance(self._bundle, rows, q[open_]) < ON
            found[open_[on]] = self._owner[rows[on]]
        return found

    def _distance(self, bundle: Bundle, rows: Array, q: Array) -> Array:
        """(k,): how far configurations are from a curve near its stored points ``rows``, rad."""
        x, curve = q / self.held.unit, self._owner[rows]
        at = bundle.s[rows] - bundle.offset[curve]
        for _ in range(4):
            c, t = _point(bundle, curve, at)
            at = at + (t * self._wrapped(x - c)).sum(axis=1)
        c, t = _point(bundle, curve, at)
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


def _point(bundle: Bundle, curve: Array, at: Array) -> tuple[Array, Array]:
    """Points (k, n) of the quintics and unit tangents there; ``at`` beyond the ends goes on with the next round."""
    row, width, u = bundle.between(curve, np.mod(at, bundle.length[curve]))
    w, u, after = width[:, np.newaxis], u[:, np.newaxis], row + 1
    first = (bundle.x[row], bundle.t[row] * w, bundle.k[row] * w**2)
    last = (bundle.x[after], bundle.t[after] * w, bundle.k[after] * w**2)
    t = bundle.t[row] * (1.0 - u) + bundle.t[after] * u
    return quintic(first, last, u), t / np.maximum(np.linalg.norm(t, axis=1, keepdims=True), 1e-300)


def table(held: Held, target: Array, component: Component) -> Dense:
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
