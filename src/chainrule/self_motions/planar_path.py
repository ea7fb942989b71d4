"""A piece of a planar 3R arm's self-motion as a path: measured by Gauss-Legendre panels, unwrapped, to be run along.

A joint moves no farther than the path is long, so joint values are unwrapped without guessing wherever panels are
shorter than half a turn.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.self_motions.planar_case import Case, evaluator

Array = NDArray[Any]

#: Gauss-Legendre nodes in a panel, and the most panels.
NODES, MOST = 16, 1 << 14
#: Points of a whole path among which extremes are looked for first.
GRID = 128
#: Panels are doubled until the length changes by less, relatively.
SETTLED = 1e-12


@cache
def _gauss() -> tuple[Array, Array]:
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    return (nodes + 1.0) / 2.0, weights / 2.0


def wrapped(angle: Array) -> Array:
    """Angles in [-pi, pi], unchanged where they are."""
    found: Array = angle - 2.0 * math.pi * np.rint(angle / (2.0 * math.pi))
    return found


Evaluate = Callable[[Array], tuple[Array, Array, Array]]


def by_theta(case: Case) -> Evaluate:
    """Joint values, H and ds/d theta at theta (...,), uniform in the elliptic parameter; for regular self-motions."""
    turn, point, speed = (evaluator(f"{name}_{case.task}") for name in ("turn", "point", "speed"))

    def evaluate(theta: Array) -> tuple[Array, Array, Array]:
        node = np.stack([np.cos(theta), np.sin(theta)], axis=-1)
        phi = turn(node, case.reach, case.sums, case.lengths)
        q, _, h, _ = point(phi, case.reach, case.sums, case.lengths)
        return q, h, speed(node, case.reach, case.sums, case.lengths)

    return evaluate


def by_phi(case: Case, shift: float) -> Evaluate:
    """Joint values, H and ds/d phi at phi (...,), counted from ``shift`` quarter turns on; for singular ones."""
    point = evaluator(f"point_{case.task}")
    quarter = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][int(shift) % 4]

    def evaluate(phi: Array) -> tuple[Array, Array, Array]:
        c, s = np.cos(phi), np.sin(phi)
        turned = np.stack([quarter[0] * c - quarter[1] * s, quarter[1] * c + quarter[0] * s], axis=-1)
        q, _, h, speed = point(turned, case.reach, case.sums, case.lengths)
        return q, h, speed

    return evaluate


class Path:
    """The piece from parameter ``start`` to ``end``.

    Attributes:
        start, end: the parameters of its ends.
        edges: (k + 1,) parameters between panels.
        cumulative: (k + 1,) length up to there.
        values: (k + 1, 3) unwrapped joint values there.
    """

    def __init__(self, evaluate: Evaluate, start: float, end: float, ends: tuple[Array, Array] | None = None) -> None:
        """``ends`` are the joint values at both ends, where the functions have no values (modulo 2 pi)."""
        self.evaluate, self.start, self.end = evaluate, start, end
        nodes, weights = _gauss()
        panels, before = 8, math.inf
        while True:
            self.edges = np.linspace(start, end, panels + 1)
            width = (end - start) / panels
            q, _, speed = evaluate(self.edges[:-1, None] + width * nodes)
            parts = speed @ weights * width
            length = float(math.fsum(parts))
            if (abs(length - before) <= SETTLED * length and parts.max() < 1.5) or panels >= MOST:
                break
            panels, before = 2 * panels, length
        self.cumulative = np.concatenate([[0.0], np.cumsum(parts)])
        self.length = length
        at = evaluate(self.edges)[0]
        if ends is not None:
            at[0], at[-1] = ends
        # from edge to edge through the panel's nodes
        steps = np.concatenate([at[:-1, None], q, at[1:, None]], axis=1)
        moved = wrapped(np.diff(steps, axis=1)).sum(axis=1)
        self.values = np.concatenate([at[:1], at[:1] + np.cumsum(moved, axis=0)])

    def _panel(self, where: Array, marks: Array) -> Array:
        found: Array = np.clip(np.searchsorted(marks, where, side="right") - 1, 0, len(marks) - 2)
        return found

    def length_to(self, parameter: Array) -> Array:
        """Length from the start to parameters (...,)."""
        panel = self._panel(parameter, self.edges)
        nodes, weights = _gauss()
        begin = self.edges[panel]
        speed = self.evaluate(begin[..., None] + (parameter - begin)[..., None] * nodes)[2]
        found: Array = self.cumulative[panel] + (speed @ weights) * (parameter - begin)
        return found

    def parameter_at(self, length: Array) -> Array:
        """Parameters at lengths (...,) from the start, by Newton's method within the panel."""
        length = np.asarray(length, float)
        panel = self._panel(length, self.cumulative)
        low, high = self.edges[panel], self.edges[panel + 1]
        part = self.cumulative[panel + 1] - self.cumulative[panel]
        share = (length - self.cumulative[panel]) / np.where(part > 0.0, part, 1.0)
        found = low + np.clip(share, 0.0, 1.0) * (high - low)
        below, above, inner = low, high, 1e-9 * (high - low)
        nodes, weights = _gauss()
        for _ in range(60):
            ahead = found - low
            speed = self.evaluate(low[..., None] + ahead[..., None] * nodes)[2]
            miss = self.cumulative[panel] + (speed @ weights) * ahead - length
            if float(np.abs(miss).max(initial=0.0)) <= 4e-15 * self.length:
                break
            below, above = np.where(miss < 0.0, found, below), np.where(miss > 0.0, found, above)
            pace = self.evaluate(np.clip(found, low + inner, high - inner))[2]
            new = found - miss / np.where(pace > 0.0, pace, np.inf)
            new = np.where((new < below) | (new > above), (below + above) / 2.0, new)
            if np.abs(new - found).max(initial=0.0) <= 1e-15 * abs(self.end - self.start):
                break
            found = new
        return np.asarray(found)

    def joints_at(self, parameter: Array) -> Array:
        """Unwrapped joint values (..., 3) at parameters (...,)."""
        parameter = np.asarray(parameter, float)
        panel = self._panel(parameter, self.edges)
        right = parameter - self.edges[panel] > self.edges[panel + 1] - parameter
        near = np.where(right, panel + 1, panel)
        found: Array = self.values[near] + wrapped(self.evaluate(parameter)[0] - self.values[near])
        hit = parameter == self.edges[near]
        found[hit] = self.values[near][hit]
        return found

    def extremes(self, function: Callable[[Array], Array], first: float, last: float) -> tuple[float, float]:
        """Least and greatest value of a function between two parameters: every local one, closed in on."""
        share = abs(last - first) / abs(self.end - self.start)
        panels = max(32, math.ceil(share * max(GRID, 2 * len(self.edges))))
        where = np.linspace(first, last, panels + 1)
        values = function(where)
        return -_greatest(function, where, -values, -1.0), _greatest(function, where, values, 1.0)


def _greatest(function: Callable[[Array], Array], where: Array, values: Array, sign: float) -> float:
    """The greatest of sign * function, whose values on an even grid are known."""
    padded = np.concatenate([[-np.inf], values, [-np.inf]])
    peaks = (values >= padded[:-2]) & (values >= padded[2:]) & (values >= values.max() - 0.05 * float(np.ptp(values)))
    middle, best, width = where[peaks], float(values.max()), where[1] - where[0]
    fan = np.linspace(-1.0, 1.0, 17)
    for _ in range(5):  # to the grid's step over 8^5: a smooth extreme is then right to 1e-12
        fine = np.clip(middle[:, None] + width * fan, where[0], where[-1])
        there = sign * function(fine)
        best = max(best, float(there.max()))
        middle, width = fine[np.arange(len(middle)), there.argmax(axis=1)], width / 8.0
    return best
