"""How a self-motion curve is followed without jumping: the algorithm of templates/continuation.h.j2, in NumPy.

The compiled kernel does exactly these steps and is used wherever there is one; this is the same for machines without
a C compiler, and to be read.

The task is held where e(q) = 0, m equations for n = m + 1 joints. Lengths are divided by a length (rows) and by the
stated length scale (prismatic joints), so that everything is in rad: x stands for the scaled joint values.

1. *Guard.* At a point x0 of the curve with unit tangent t and b >= |J^+|, let K bound the second derivative of e in the
   ball of radius r about x0 (:func:`second_derivative`). For b K r <= c < 1 the map
   T(x) = x - J^+ e(x) + (s - t.(x - x0)) t contracts the ball by c, and |T(x) - x0|^2 <= s^2 + (c r / 2)^2, since
   |e(x) - J (x - x0)| <= K r^2 / 2. So for every |s| <= r sqrt(1 - c^2 / 4) the ball holds exactly one point of the
   curve with t.(x - x0) = s: within that slab of the ball the solutions are one arc, through x0. A step to a solution
   in it cannot have changed curves. K is a bound, not an estimate: second derivatives of a serial chain are products
   of unit axes and distances from axes to the tip.
2. *Step.* Predict by the polynomial through up to four points and tangents (degree 7); correct by Newton's method,
   x -= J^+ e; halve the step where that does not contract. A point in the slab of the last ball is on its arc. So is a
   point x1 beyond it, if its own ball holds the end of that arc: the arc's point at the distance s along t lies in a
   disc of radius d = c / 2r (s^2 + (c r / 2)^2) about x0 + s t, by the bound in 1. Where all of the disc is in the slab
   of the ball about x1, behind x1, the arcs through x0 and x1 have that point in common and are one.
3. *Closure.* Where the start, each revolute joint shifted by whole turns, lies ahead within the slab, or behind the new
   point within the slab of its ball, the arc leads to it: the curve is closed. The last step is solved for in the plane
   through the start normal to its tangent.
4. *Length.* As often as the tangent has turned a little (or 5 radii were passed), the length since then is the
   integral of 1 / (t.d) over the distance along the chord's direction d: Lobatto's rule, each node corrected on the
   curve. Its last
   Legendre coefficients, and how fast they fall, estimate the error and set the next turn.
5. *Extrema* of each joint and of H between nodes: the roots of the tangent's component and of dH/ds.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

#: Why a curve ended, as numbered by the kernel.
REASONS = ("closed", "length", "singular", "steps", "stuck", "start")

CONTRACTION = 0.9  # c of the guard
SLAB = 0.89  # below sqrt(1 - c^2 / 4), with room for rounding
ADVANCE = 0.85  # the longest step within a ball, of its radius
BOTH = 0.82  # the longest step through two balls, of the sum of their radii
LONGEST = 0.5  # the longest step, rad
TURN = 0.5  # the most that a step may turn, rad
NODES = 48  # certified points kept between two output points
HISTORY = 4  # points that the predictor uses
NEWTON = 12  # most corrections
SETTLED = 1e-9  # the last correction, rad
LEFT = 1e-16  # |J^+| size^2 of the last correction of a point whose tangent is taken anew: an error of rounding
POWERS = 3  # of the matrix whose largest eigenvalue is bounded
LEVEL = 1e-12  # a slope below this (of H: this share of H) is rounding: nothing moves
PARTS = 8  # of an interval between output points in which a slope is looked at for a change of sign
LEAST_TURN, MOST_TURN = 0.02, 0.7  # of the tangent between two ends of a length rule
BALLS = 5.0  # of radii between two ends of a length rule: nothing the curve does between its points is narrower
FINEST = 1e-11  # the error of a length rule, relative to its chord, that is asked for


def lobatto(order: int) -> tuple[Array, Array, Array, Array]:
    """Nodes on [0, 1] of Lobatto's rule with ``order`` points, and three linear maps of the values there.

    Returns:
        nodes (order,), weights (order,), the integrals from 0 to each node (order, order) of the interpolating
        polynomial, and its last four Legendre coefficients (4, order).
    """
    from numpy.polynomial import legendre

    last = np.zeros(order)
    last[-1] = 1.0
    nodes = np.concatenate([[-1.0], np.sort(legendre.legroots(legendre.legder(last)).real), [1.0]])
    for _ in range(3):  # polish the roots of P'
        inner = nodes[1:-1]
        first, second = legendre.legder(last), legendre.legder(last, 2)
        nodes[1:-1] = inner - legendre.legval(inner, first) / legendre.legval(inner, second)
    coefficients = np.linalg.inv(legendre.legvander(nodes, order - 1))  # values to Legendre coefficients
    integrals = np.stack([legendre.legint(np.eye(order)[k], lbnd=-1.0) for k in range(order)])
    running = legendre.legval(nodes, integrals.T).T @ coefficients / 2.0
    return (nodes + 1.0) / 2.0, running[-1], running, coefficients[-4:]


ORDER = 7
LOBATTO_NODES, LOBATTO_WEIGHTS, LOBATTO_RUNNING, LOBATTO_LAST = lobatto(ORDER)


@dataclass(frozen=True)
class System:
    """What is followed: the generated functions of an arm and task at a target, and what the bounds need.

    Attributes:
        held: q -> error (m,), Jacobian (m, n), null vector (n,).
        bending: q -> null vector (n,), its derivative along itself (n,).
        revolute: (n,) which joints are revolute.
        unit: (n,) what one unit of x is: 1 rad, or L m for a prismatic joint.
        links: (n,) the constant distance from each joint to the next (from the last to the tip), m.
        positions: how many of the first rows are lengths.
        whole: whether these rows are the whole velocity of the tip.
        spatial: whether three rows of a spatial orientation follow.
        size: m; rows that are lengths are divided by it.
    """

    held: Callable[[Array], tuple[Array, Array, Array]]
    bending: Callable[[Array], tuple[Array, Array]]
    revolute: Array
    unit: Array
    links: Array
    positions: int
    whole: bool
    spatial: bool
    size: float


@dataclass(frozen=True)
class Settings:
    """Where a trace ends."""

    direction: int = 1
    longest: float = 1e3
    steps: int = 1_000_000
    singular: float = 1e-6


@dataclass
class Trace:
    """A traced curve: its points by columns, and what the kernel says of it.

    Attributes:
        q: (k, n) joint values.
        tangent, bend: (k, n) dq/ds and d2q/ds2 of the scaled joints x = q / unit.
        s: (k,) length so far.
        h: (k,) manipulability; slope: (k,) its change along the curve, dH/ds.
        knots: (e, 3) extrema between the points: which joint from 0 (H: n), at which length, and its value.
        box: (n, 2) least and greatest joint values; span: least and greatest H.
        reason: why it ended (:data:`REASONS`); steps: certified steps; evaluations: of the generated functions.
        closure: largest difference between the return and the start, rad; winding: (n,) turns of each joint.
        contraction: c times how far from a ball's centre, of its radius, a step went through it: below 1, the guard
            held at every step.
    """

    q: Array
    tangent: Array
    bend: Array
    s: Array
    h: Array
    slope: Array
    knots: Array
    box: Array
    span: tuple[float, float]
    reason: str
    steps: int
    evaluations: int
    closure: float
    winding: Array
    contraction: float


@dataclass
class Point:
    """A point on the curve, its unit tangent and, where it matters, the radius of its certified ball."""

    x: Array
    t: Array
    radius: float = 0.0
    s: float = 0.0


@dataclass
class Row:
    """An output point."""

    x: Array
    t: Array
    k: Array
    s: float
    h: float
    slope: float


def second_derivative(system: System, x: Array, jacobian: Array, radius: float) -> float:
    """K: a bound of |D2e(u, u)| for unit u in the ball of ``radius`` about x.

    For i <= j, d2p/dq_i dq_j = w_i x v_j (0 where joint i is prismatic), w_i the axis and v_j the velocity of the tip
    for a unit rate of joint j: at most the distance d_j of the tip from joint j (1 where j is prismatic), which is
    bounded by the links beyond j, and in the ball also by |v_j| at its centre plus ``radius`` times the bound of its
    own derivative. The rows of a spatial orientation have the skew part of [w_i][w_j] E, at most 1/2 for i != j and 0
    for i = j where E = I, and sqrt(n) radius more in the ball. K is the largest eigenvalue of the matrix A of these
    bounds; with A >= 0 it is at most max (A y)_i / y_i for any y > 0 (Collatz and Wielandt).
    """
    n = len(x)
    turning, unit = system.revolute, system.unit
    reach = system.links + np.where(turning, 0.0, unit * (np.abs(x) + radius))
    reach = np.where(turning, np.cumsum(reach[::-1])[::-1], 1.0)
    far = np.maximum.outer(np.arange(n), np.arange(n))
    near = np.minimum.outer(np.arange(n), np.arange(n))
    bound = np.where(turning[near], reach[far], 0.0)
    if system.whole:
        speeds = np.linalg.norm(jacobian[: system.positions], axis=0) / unit * system.size
        slopes = np.sqrt(((bound * unit[:, None]) ** 2).sum(axis=0))
        reach = np.where(turning, np.minimum(reach, speeds + radius * slopes), 1.0)
        bound = np.where(turning[near], reach[far], 0.0)
    bound = bound * np.outer(unit, unit) / system.size
    if system.spatial:
        pair = turning[:, None] & turning[None, :]
        turns = np.where(pair, math.sqrt(n) * radius + np.where(np.eye(n, dtype=bool), 0.0, 0.5), 0.0)
        bound = np.sqrt(bound**2 + turns**2)
    y = np.ones(n)
    for _ in range(POWERS):
        image = bound @ y
        ratio = float((image / y).max())
        y = np.maximum(image / max(ratio, 1e-300), 1e-6)
    return ratio


class Follower:
    """One curve being followed."""

    def __init__(self, system: System, settings: Settings) -> None:
        self.system, self.settings = system, settings
        self.evaluations = self.steps = 0
        self.contraction = 0.0
        self.rows: list[Row] = []
        self.turn = 0.4

    # ---- evaluations -------------------------------------------------------------------------------------------

    def held(self, x: Array) -> tuple[Array, Array, Array]:
        """Scaled error and Jacobian, and the unit tangent in the direction followed."""
        self.evaluations += 1
        e, jacobian, null = self.system.held(x * self.system.unit)
        e, jacobian = np.array(e), jacobian * self.system.unit
        e[: self.system.positions] /= self.system.size
        jacobian[: self.system.positions] /= self.system.size
        t = null / self.system.unit
        length = float(np.linalg.norm(t))
        return e, jacobian, self.settings.direction * t / length if length > 0.0 else t

    def row(self, x: Array, s: float) -> Row:
        """An output point: tangent, curvature vector, H and its slope."""
        self.evaluations += 1
        null, bending = self.system.bending(x * self.system.unit)
        n, w = null / self.system.unit, bending / self.system.unit
        size = float(np.linalg.norm(n))
        t = n / size
        k = (w - t * (t @ w)) / size**2
        h = float(np.linalg.norm(null))
        slope = float(null @ bending) / (h * size)
        return Row(x, self.settings.direction * t, k, s, h, self.settings.direction * slope)

    def manipulability(self, x: Array) -> float:
        """H."""
        return float(np.linalg.norm(self.system.bending(x * self.system.unit)[0]))

    # ---- corrections -------------------------------------------------------------------------------------------

    def correct(
        self, x: Array, normal: Array | None = None, offset: float = 0.0, *, loose: bool = False
    ) -> tuple[Array, Array, float, Array, float] | None:
        """Newton's method onto the curve, in the plane normal.x = offset where one is given.

        Returns the point, its tangent, b, the scaled Jacobian and the last correction's size; None if it diverges.
        ``loose`` where the tangent (taken before the last correction) is not needed: the point is as exact.
        """
        before = math.inf
        for _ in range(NEWTON):
            e, jacobian, t = self.held(x)
            found = minimum_norm(jacobian, e)
            if found is None or not np.isfinite(t).all():
                return None
            step, bound = found
            if normal is not None:
                along = float(normal @ t)
                if abs(along) < 0.05:
                    return None
                step = step + t * ((offset - float(normal @ (x + step))) / along)
            size = float(np.linalg.norm(step))
            if not size <= max(0.5 * before, 1e-11):
                return None
            x = x + step
            if size <= SETTLED or (loose and bound * size**2 <= LEFT):
                return x, t, bound, jacobian, size
            before = size
        return None

    def radius(self, x: Array, jacobian: Array, bound: float, last: float) -> float:
        """The radius of the ball in which the curve is one arc."""
        trial = min(1.5 * last, 1.0)
        for _ in range(3):
            curving = second_derivative(self.system, x, jacobian, trial)
            allowed = CONTRACTION / (bound * curving) if curving > 0.0 else math.inf
            if allowed >= 0.5 * trial:
                break
            trial = min(2.0 * allowed, 0.5 * trial)
        return min(trial, allowed)

    # ---- the loop ----------------------------------------------------------------------------------------------

    def follow(self, start: Array) -> Trace:
        """Follow the curve through ``start`` until it closes or ends."""
        settings = self.settings
        found = self.correct(start)
        if found is None:
            # where J has lost rank on the target itself there is no tangent to begin with
            there = float(np.linalg.norm(self.held(start)[0])) < 1e-9
            return self.finished("singular" if there else "start", start, math.nan)
        x, t, bound, jacobian, _ = found
        origin = Point(x, t)
        origin.radius = self.radius(x, jacobian, bound, 0.5)
        if self.singular(jacobian, bound):
            return self.finished("singular", x, math.nan)
        self.rows.append(self.row(x, 0.0))
        nodes, history = [origin], [origin]
        reason, closure, step, last_radius = "", math.nan, ADVANCE * origin.radius, origin.radius
        while not reason:
            here = nodes[-1]
            ahead, along, distance = self.image(origin.x, here)
            if 0.0 < along <= SLAB * here.radius and distance <= here.radius:
                closure = self.close(origin, ahead, nodes, history)
                reason = "closed"
                break
            if self.rows[-1].s + float(np.linalg.norm(here.x - self.rows[-1].x)) >= settings.longest:
                reason = "length"
                break
            if self.steps >= settings.steps:
                reason = "steps"
                break
            # one ball's length, or two where the next one is about as large
            larger = here.radius**2 / last_radius if here.radius < last_radius else here.radius
            step = min(step, BOTH * (here.radius + larger), LONGEST)
            if len(history) > 1:
                bend = float(np.linalg.norm(history[-1].t - history[-2].t)) / (history[-1].s - history[-2].s)
                step = min(step, TURN / bend) if bend > 0.0 else step
            new, reached, closing = None, 0.0, False
            while step > 1e-3 * here.radius:
                found = self.correct(self.predict(history, step))
                along = float(here.t @ (found[0] - here.x)) if found is not None else 0.0
                if found is not None and along > 0.0:
                    point = Point(found[0], found[1], self.radius(found[0], found[3], found[2], here.radius))
                    distance = float(np.linalg.norm(found[0] - here.x))
                    if along <= SLAB * here.radius and distance <= here.radius:
                        new, reached = point, distance / here.radius
                        break
                    joined, reached = meet(here, point, along * here.radius / (here.radius + point.radius))
                    if joined:
                        new = point
                        ahead, behind, apart = self.image(origin.x, point)
                        closing = -SLAB * point.radius <= behind <= 0.0 and apart <= point.radius
                        closing = closing and float(here.t @ (ahead - here.x)) > 0.0
                        break
                step = min(0.5 * step, ADVANCE * here.radius)
            if new is None or found is None:
                reason = "stuck"
                break
            self.steps += 1
            self.contraction = max(self.contraction, CONTRACTION * reached)
            if closing:
                closure = self.close(origin, ahead, nodes, history)
                reason = "closed"
                break
            x, t, bound, jacobian, _ = found
            turned = float(np.linalg.norm(t - here.t))
            point = replace(new, s=here.s + distance * (1.0 + turned**2 / 24.0))
            nodes.append(point)
            last_radius = here.radius
            history = [*history[-HISTORY + 1 :], point]
            step *= 2.0
            if self.singular(jacobian, bound):
                reason = "singular"
            elif (
                np.linalg.norm(t - nodes[0].t) >= self.turn
                or np.linalg.norm(x - nodes[0].x) >= BALLS * min(each.radius for each in nodes)
                or len(nodes) >= NODES
            ):
                nodes = self.measure(nodes)
        self.measure(nodes)
        return self.finished(reason, origin.x, closure)

    def singular(self, jacobian: Array, bound: float) -> bool:
        """Whether the smallest singular value, relative to the largest, is (about) below the stated share."""
        return not float(np.linalg.norm(jacobian)) * bound * self.settings.singular < 1.0

    def image(self, x: Array, near: Point) -> tuple[Array, float, float]:
        """x with whole turns added to its revolute joints, nearest to a point; how far ahead of that, how far away."""
        turns = np.rint((near.x - x) / (2.0 * math.pi))
        shifted: Array = np.where(self.system.revolute, x + 2.0 * math.pi * turns, x)
        return shifted, float(near.t @ (shifted - near.x)), float(np.linalg.norm(shifted - near.x))

    def close(self, origin: Point, image: Array, nodes: list[Point], history: list[Point]) -> float:
        """Append the start, shifted by whole turns, as the last node; how far from it the curve arrives, rad."""
        here = nodes[-1]
        along = float(here.t @ (image - here.x))
        guess = self.predict(history, along)
        back = self.correct(guess, origin.t, float(origin.t @ image))
        nodes.append(Point(image, origin.t, origin.radius, here.s + along))
        return float(np.abs((guess if back is None else back[0]) - image).max())

    @staticmethod
    def predict(history: list[Point], step: float) -> Array:
        """The Hermite polynomial through the last points and their tangents, ``step`` beyond the last one."""
        places = [point.s - history[-1].s for point in history]
        return hermite_through(history, places, [1.0] * len(history), step)

    # ---- length ------------------------------------------------------------------------------------------------

    def measure(self, nodes: list[Point]) -> list[Point]:
        """Output points and length over certified points; returns the last of them."""
        begin = 0
        while begin < len(nodes) - 1:
            end = len(nodes) - 1
            while not self.rule(nodes[begin : end + 1]):
                if end > begin + 1:
                    end = (begin + end) // 2
                    continue
                middle = self.halved(nodes[begin], nodes[end])
                if middle is None:  # cannot be refined: take it as it is
                    self.rule(nodes[begin : end + 1], always=True)
                    break
                nodes.insert(end, middle)
            begin = end
        return [nodes[-1]]

    def rule(self, nodes: list[Point], always: bool = False) -> bool:
        """Lobatto's rule from the first to the last of the nodes; False where its error is too large."""
        first, last = nodes[0], nodes[-1]
        chord = float(np.linalg.norm(last.x - first.x))
        if chord == 0.0:
            return True
        d = (last.x - first.x) / chord
        cosines = [float(node.t @ d) for node in nodes]
        along = [float(d @ (node.x - first.x)) for node in nodes]
        if not always and (min(cosines) < 0.3 or any(b <= a for a, b in pairwise(along))):
            return False
        points: list[Array] = []
        for place in LOBATTO_NODES[1:-1] * chord:
            j = min(max(int(np.searchsorted(along, place)) - 1, 0), len(nodes) - 2)
            if always:
                guess = between(nodes[j], nodes[j + 1], d, (place - along[j]) / (along[j + 1] - along[j]))
            else:
                used = min(len(nodes), HISTORY)  # nodes around the place
                start = min(max(j + 1 - used // 2, 0), len(nodes) - used)
                near = slice(start, start + used)
                guess = hermite_through(nodes[near], along[near], [1.0 / c for c in cosines[near]], float(place))
            found = self.correct(guess, d, float(d @ first.x) + place, loose=True)
            if found is None or all(np.linalg.norm(found[0] - each.x) > each.radius for each in nodes[j : j + 2]):
                if not always:
                    return False
                found = (guess, d, 0.0, d, 0.0)
            points.append(found[0])
        rows = [self.rows[-1], *(self.row(x, 0.0) for x in [*points, last.x])]
        values = np.array([1.0 / float(row.t @ d) for row in rows])
        # Of smooth integrands they fall as r^-k, and the rule's error as r^-(2 ORDER - 2).
        sizes = np.abs(LOBATTO_LAST @ values)
        size = float(sizes[2:].max())
        error = size * min(size / max(float(sizes[:2].max()), 1e-300), 1.0) ** 3
        if error > FINEST and not always and chord > 1e-9:
            self.turn = max(0.7 * self.turn, LEAST_TURN)
            return False
        self.turn = min(
            max(self.turn * min(0.9 * (FINEST / max(error, 1e-300)) ** (1.0 / (2 * ORDER)), 1.5), LEAST_TURN), MOST_TURN
        )
        lengths = self.rows[-1].s + chord * (LOBATTO_RUNNING @ values)
        self.rows += [replace(row, s=float(s)) for row, s in zip(rows[1:], lengths[1:], strict=True)]
        return True

    def halved(self, first: Point, last: Point) -> Point | None:
        """A further certified point between two neighbours."""
        chord = float(np.linalg.norm(last.x - first.x))
        if chord < 1e-9:
            return None
        d = (last.x - first.x) / chord
        if float(first.t @ d) < 0.3 or float(last.t @ d) < 0.3:
            return None
        found = self.correct(between(first, last, d, 0.5), d, float(d @ first.x) + 0.5 * chord)
        if found is None:
            return None
        return Point(
            found[0], found[1], max(each.radius - float(np.linalg.norm(found[0] - each.x)) for each in (first, last))
        )

    # ---- what is reported --------------------------------------------------------------------------------------

    def finished(self, reason: str, start: Array, closure: float) -> Trace:
        """Everything about the curve, extrema refined."""
        unit, n = self.system.unit, len(start)
        if not self.rows:  # nothing but the start
            self.rows.append(Row(start, np.zeros(n), np.zeros(n), 0.0, self.manipulability(start), 0.0))
        rows = self.rows
        x = np.array([row.x for row in rows]).reshape(-1, n)
        h = np.array([row.h for row in rows])
        box = np.stack([x.min(axis=0), x.max(axis=0)], axis=1)
        span = [float(h.min()), float(h.max())]
        knots: list[tuple[float, float, float]] = []
        for a, b in pairwise(rows):
            for i, place, value in self.extrema(a, b):
                if i < n:
                    box[i] = min(box[i, 0], value), max(box[i, 1], value)
                else:
                    span = [min(span[0], value), max(span[1], value)]
                knots.append((i, place, value * unit[i] if i < n else value))
        turns = np.rint((x[-1] - x[0]) / (2.0 * math.pi)) if reason == "closed" else np.zeros(n)
        return Trace(
            x * unit,
            np.array([row.t for row in rows]).reshape(-1, n),
            np.array([row.k for row in rows]).reshape(-1, n),
            np.array([row.s for row in rows]),
            h,
            np.array([row.slope for row in rows]),
            np.array(knots, float).reshape(-1, 3),
            box * unit[:, None],
            (span[0], span[1]),
            reason,
            self.steps,
            self.evaluations,
            closure,
            np.where(self.system.revolute, turns, 0.0).astype(int),
            self.contraction,
        )

    def extrema(self, a: Row, b: Row) -> list[tuple[int, float, float]]:
        """Extrema between two output points: of which joint (n: of H), at which length, and the value."""
        if b.s <= a.s:
            return []
        found = []
        for i in range(len(a.x) + 1):
            slopes = [slope_at(a, b, i, k / PARTS) for k in range(PARTS + 1)]
            if max(map(abs, slopes)) <= LEVEL * (1.0 if i < len(a.x) else a.h):
                continue
            for k in range(PARTS):
                if (slopes[k] > 0.0) != (slopes[k + 1] > 0.0):
                    place = self.extremum(a, b, i, k / PARTS, (k + 1) / PARTS, slopes[k], slopes[k + 1])
                    found += [(i, *place)] if place is not None else []
        return found

    def extremum(
        self, a: Row, b: Row, i: int, low: float, high: float, g_low: float, g_high: float
    ) -> tuple[float, float] | None:
        """The place and value of an extremum on the curve: false position (Illinois), for joints Newton's method.

        The last step of Newton's method is not made but taken from the parabola.
        """
        n, width, side = len(a.x), b.s - a.s, 0
        scale = 1.0 if i < n else abs(a.slope) + abs(b.slope)
        place = value = math.nan
        u = root_between(a, b, i, low, high) if i < n else secant(low, high, g_low, g_high)
        for _ in range(12):
            found = self.correct(interpolated(a, b, u), loose=True)
            if found is None:
                return None
            row = self.row(found[0], a.s + u * width)
            g, bend = (float(row.t[i]), float(row.k[i])) if i < n else (row.slope, math.nan)
            place, value = row.s, float(row.x[i]) if i < n else row.h
            if i < n and abs(g) <= 1e-5 and abs(g) <= 1e-4 * width * abs(bend):
                return place - g / bend, value - 0.5 * g * g / bend
            if abs(g) <= (1e-9 if i < n else 1e-6 * scale) or high - low < 1e-7:
                break
            if (g > 0.0) == (g_low > 0.0):
                low, g_low = u, g
                g_high = 0.5 * g_high if side == 1 else g_high
                side = 1
            else:
                high, g_high = u, g
                g_low = 0.5 * g_low if side == -1 else g_low
                side = -1
            newton = u - g / (bend * width) if i < n and bend != 0.0 else low
            u = newton if low < newton < high else secant(low, high, g_low, g_high)
        return place, value


def meet(first: Point, last: Point, ahead: float) -> tuple[bool, float]:
    """Whether the arcs of two points' balls meet at a distance along the first one's tangent.

    Returns:
        whether; and how far from a centre the disc is that has to lie in both balls, of a ball's radius.
    """
    disc = 0.5 * CONTRACTION / first.radius * (ahead**2 + (0.5 * CONTRACTION * first.radius) ** 2)
    gap = first.x + ahead * first.t - last.x
    square, along, across = float(gap @ gap), float(gap @ last.t), float(gap @ first.t)
    sideways = math.sqrt(max(square - across**2, 0.0))
    far = math.sqrt(square + 2.0 * sideways * disc + disc**2)
    tilt = disc * math.sqrt(max(1.0 - float(first.t @ last.t) ** 2, 0.0))
    reached = max(math.sqrt(ahead**2 + disc**2) / first.radius, far / last.radius)
    inside = ahead <= SLAB * first.radius and far <= last.radius
    return inside and along + tilt < 0.0 and along - tilt >= -SLAB * last.radius, reached


def minimum_norm(jacobian: Array, e: Array) -> tuple[Array, float] | None:
    """-J^+ e and a bound of |J^+|, by orthogonalised rows, J = L Q.

    |J^+|^2 is the largest eigenvalue of G = L^-T L^-1, at most the root of the Frobenius norm of G^2.
    """
    m, n = jacobian.shape
    q, lower = np.zeros((m, n)), np.zeros((m, m))
    for i in range(m):
        row = jacobian[i].copy()
        for _ in range(2):
            for j in range(i):
                part = float(q[j] @ row)
                lower[i, j] += part
                row -= part * q[j]
        length = float(np.linalg.norm(row))
        if not length > 1e-300:
            return None
        lower[i, i] = length
        q[i] = row / length
    inverse = np.zeros((m, m))
    for j in range(m):
        inverse[j, j] = 1.0 / lower[j, j]
        for i in range(j + 1, m):
            inverse[i, j] = -float(lower[i, j:i] @ inverse[j:i, j]) / lower[i, i]
    gram = inverse.T @ inverse
    return -(inverse @ e) @ q, math.sqrt(math.sqrt(float(np.linalg.norm(gram @ gram))))


def between(first: Point, last: Point, d: Array, u: float) -> Array:
    """The cubic through two points and tangents, at the share u of the way along d."""
    width = float(d @ (last.x - first.x))
    a, b = first.t / float(first.t @ d) * width, last.t / float(last.t @ d) * width
    return hermite(first.x, a, last.x, b, u)


def hermite_through(points: list[Point], places: list[float], scales: list[float], at: float) -> Array:
    """The Hermite polynomial through points at places (one for each) and their tangents times scales, at another."""
    knots = np.repeat(places, 2)
    current = [point.x for point in points for _ in range(2)]
    columns = [current[0]]
    for order in range(1, len(knots)):
        following = []
        for i in range(len(knots) - order):
            if order == 1 and i % 2 == 0:
                following.append(points[i // 2].t * scales[i // 2])
            else:
                following.append((current[i + 1] - current[i]) / (knots[i + order] - knots[i]))
        columns.append(following[0])
        current = following
    value = columns[-1]
    for i in range(len(knots) - 2, -1, -1):
        value = columns[i] + (at - knots[i]) * value
    return value


def hermite(x0: Array, d0: Array, x1: Array, d1: Array, u: float) -> Array:
    """The cubic with these values and derivatives at 0 and 1."""
    v = 1.0 - u
    found: Array = (1.0 + 2.0 * u) * v * v * x0 + u * v * v * d0 + (1.0 + 2.0 * v) * u * u * x1 - u * u * v * d1
    return found


def quintic(first: tuple[Array, Array, Array], last: tuple[Array, Array, Array], u: Array | float) -> Array:
    """The polynomial of degree 5 with these values, first and second derivatives at 0 and 1."""
    (x0, d0, c0), (x1, d1, c1) = first, last
    rise = x1 - x0
    a = 10 * rise - 6 * d0 - 4 * d1 - 1.5 * c0 + 0.5 * c1
    b = -15 * rise + 8 * d0 + 7 * d1 + 1.5 * c0 - c1
    c = 6 * rise - 3 * d0 - 3 * d1 - 0.5 * c0 + 0.5 * c1
    return np.asarray(x0 + u * (d0 + u * (0.5 * c0 + u * (a + u * (b + u * c)))))


def interpolated(a: Row, b: Row, u: float) -> Array:
    """The quintic between two output points."""
    width = b.s - a.s
    return quintic((a.x, width * a.t, width**2 * a.k), (b.x, width * b.t, width**2 * b.k), u)


def slope_at(a: Row, b: Row, i: int, u: float) -> float:
    """The slope of joint i (of H for i = n) between two output points: its cubic, or that of H differentiated."""
    width = b.s - a.s
    if i < len(a.x):
        return float(hermite(a.t[i], width * a.k[i], b.t[i], width * b.k[i], u))
    rise = (b.h - a.h) / width
    v = 1.0 - u
    return (1.0 - 3.0 * u) * v * a.slope + (1.0 - 3.0 * v) * u * b.slope + 6.0 * u * v * rise


def secant(low: float, high: float, g_low: float, g_high: float) -> float:
    """Where the line through two values is zero; the middle where they are equal."""
    return low - g_low * (high - low) / (g_high - g_low) if g_high != g_low else 0.5 * (low + high)


def root_between(a: Row, b: Row, i: int, low: float, high: float) -> float:
    """The root of :func:`slope_at` between two places of different sign, by false position."""
    g_low, g_high = slope_at(a, b, i, low), slope_at(a, b, i, high)
    u = secant(low, high, g_low, g_high)
    for _ in range(8):
        at = slope_at(a, b, i, u)
        if (at > 0.0) == (g_high > 0.0):
            high, g_high, g_low = u, at, 0.5 * g_low
        else:
            low, g_low, g_high = u, at, 0.5 * g_high
        u = secant(low, high, g_low, g_high)
    return u
