"""A way through the nonsingular joint space made short and smooth, and kept away from the singularities.

The control points of a cubic B-spline are moved to where
    (m - 1) sum |x_i+1 - x_i|^2  +  WEIGHT mean(least / (s det J))
is smallest (L-BFGS-B with the generated gradient of |det J|), where least is the smallest |det J| of the way it begins
with: the first part pulls the curve straight and evens its speed, the second lifts the smallest |det J|. A spline stays in the hull of its control points, so bounds on them keep the joint
limits along all of it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.certified_path import knots, sample
from chainrule.cuspidality.roadmap import JointSpace

Array = NDArray[Any]

#: Points looked at for each control point, rounds of L-BFGS-B, and the weight of the determinant.
DENSITY, ROUNDS, WEIGHT = 5, 120, 60.0
#: Below this share of the least |det J| the reciprocal goes on as a straight line: what crosses over finds back.
STRAIGHT = 0.25


def shortened(space: JointSpace, via: Array, share: float = 0.5) -> Array:
    """Via points (k, 6) without those that a straight way can pass by, where it keeps ``share`` of the least |det J|."""
    floor = share * lowest(space, via, 1)
    kept, at = [0], 0
    while at < len(via) - 1:
        ahead = np.arange(at + 1, len(via))
        least = _straight(space, via[at], via[ahead])
        at = int(ahead[np.flatnonzero(least >= floor).max(initial=0)])
        kept.append(at)
    return via[kept]


def _straight(space: JointSpace, a: Array, b: Array) -> Array:
    """The least det J times its sign at a on the ways from a (6,) to each of b (k, 6) as they are, not the shorter way."""
    share = np.linspace(0.0, 1.0, 64)[:, None]
    found = space.determinant(a + share * (b - a)[:, None])
    least: Array = (found * np.sign(found[:, :1])).min(axis=-1)
    return least


def evenly(via: Array, count: int) -> Array:
    """``count`` points of a polyline (k, 6), evenly spaced along it, its ends kept."""
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(via, axis=0), axis=-1))])
    at = np.linspace(0.0, lengths[-1], count)
    points = np.stack([np.interp(at, lengths, coordinate) for coordinate in via.T], axis=-1)
    points[0], points[-1] = via[0], via[-1]
    return points


def smoothed(space: JointSpace, via: Array, bounds: Array, count: int) -> Array:
    """Control points (count, 6) of a cubic B-spline from the first to the last of the via points (k, 6).

    Args:
        space: the joint space.
        via: where the way begins.
        bounds: (6, 2) rad, infinite where there is none.
        count: how many control points.
    """
    from scipy.interpolate import BSpline
    from scipy.optimize import minimize

    begin = np.clip(evenly(via, count), bounds[:, 0], bounds[:, 1])
    knot = knots(count, 3)
    at = np.linspace(0.0, knot[-1], DENSITY * count)
    basis = BSpline.design_matrix(at, knot, 3).toarray()
    sign = float(np.sign(space.determinant(begin[0])))
    least = lowest(space, via, 1)

    def value(inner: Array) -> tuple[float, Array]:
        control = np.concatenate([begin[:1], inner.reshape(-1, 6), begin[-1:]])
        steps = np.diff(control, axis=0)
        q = basis @ control
        height = sign * space.determinant(q) / least
        held = np.maximum(height, STRAIGHT)
        barrier = 1.0 / held - np.minimum(height - STRAIGHT, 0.0) / STRAIGHT**2
        # the generated gradient is that of |det J|: on the wrong side it points the other way
        gradient = space.arm.manipulability_gradient(q, task="pose", criterion="H") * np.sign(height)[:, None]
        change = -WEIGHT / len(at) * (basis.T @ (gradient / least / np.square(held)[:, None]))
        pull = 2.0 * (count - 1) * (np.pad(steps, ((1, 0), (0, 0))) - np.pad(steps, ((0, 1), (0, 0))))
        energy = (count - 1) * float(np.square(steps).sum()) + WEIGHT * float(barrier.mean())
        return energy, (change + pull)[1:-1].ravel()

    found = minimize(
        value,
        begin[1:-1].ravel(),
        jac=True,
        method="L-BFGS-B",
        bounds=np.tile(bounds, (count - 2, 1)),
        options={"maxiter": ROUNDS},
    )
    return np.concatenate([begin[:1], found.x.reshape(-1, 6), begin[-1:]])


def lowest(space: JointSpace, control: Array, degree: int) -> float:
    """The least det J times its sign at the start, along a B-spline with control points (k, 6), by samples."""
    found = space.determinant(sample(control, degree, np.linspace(0.0, 1.0, 40 * len(control) + 1)))
    return float((found * np.sign(found[0])).min())
