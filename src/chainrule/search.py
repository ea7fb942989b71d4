"""Looking for the best configuration: many random starts inside the joint limits, the best of them refined.

What is found this way is a local optimum, the best of those met: a search, not a proof. The starts are the same in
every run, so the same arm gives the same answer.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm

Array = NDArray[Any]
Slope = Callable[[Array], tuple[float, Array]]

#: Range searched for a prismatic joint without limits, in m.
FREE_TRAVEL = 1.0

#: How many configurations are looked at, and how many of the best are refined.
SAMPLES, STARTS = 20_000, 12


@dataclass(frozen=True)
class Found:
    """The best configuration met.

    Attributes:
        value: the value there.
        q: (n,) rad or m.
        others: (k, n) further configurations that reached the same value to a relative 1e-9.
    """

    value: float
    q: Array
    others: Array


def box(arm: Arm) -> Array:
    """The range (n, 2) searched: the joint limits; where there is none, [-pi, pi] rad or [-1, 1] m.

    Example:
        >>> from chainrule import planar_3r
        >>> box(planar_3r(1.0, 0.5, 0.25))[0].round(4)
        array([-3.1416,  3.1416])
    """
    limits = np.array(arm.limits.position)
    free = np.array([np.pi if kind == "R" else FREE_TRAVEL for kind in arm.kinds])
    lower, upper = limits[:, 0], limits[:, 1]
    lower = np.where(np.isfinite(lower), lower, np.where(np.isfinite(upper), upper - 2 * free, -free))
    upper = np.where(np.isfinite(upper), upper, np.where(np.isfinite(limits[:, 0]), lower + 2 * free, free))
    return np.stack([lower, upper], axis=1)


def assumed(arm: Arm) -> str:
    """What :func:`box` assumes where the arm has no limits, as a clause; empty where it has them all."""
    open_ended = ~np.isfinite(arm.limits.position).all(axis=1)
    phrases = {
        "R": "revolute joints without limits turn freely",
        "P": f"prismatic joints without limits are moved over ±{FREE_TRAVEL:g} m",
    }
    return "; ".join(phrase for kind, phrase in phrases.items() if kind in np.array(list(arm.kinds))[open_ended])


def turns_freely(arm: Arm) -> Array:
    """Which joints (n,) are revolute and without limits, so that an angle and the same angle plus a turn are one."""
    turning = np.array([kind == "R" for kind in arm.kinds])
    free: Array = turning & ~np.isfinite(arm.limits.position).any(axis=1)
    return free


def samples(arm: Arm, count: int = SAMPLES, seed: int = 0) -> Array:
    """Configurations (count, n), uniform in :func:`box`, the same for the same seed."""
    ranges = box(arm)
    return np.random.default_rng(seed).uniform(ranges[:, 0], ranges[:, 1], (count, arm.n))


def maximise(
    arm: Arm,
    values: Callable[[Array], Array],
    slope: Slope,
    *,
    moving: Sequence[int] | None = None,
    at: Array | None = None,
    count: int = SAMPLES,
    starts: int = STARTS,
) -> Found:
    """The largest value met inside :func:`box`: ``count`` samples, the best ``starts`` of them refined (L-BFGS-B).

    Args:
        arm: the arm.
        values: maps (k, n) to (k,).
        slope: maps (n,) to the value and its gradient (n,).
        moving: the joints that may move (from 0); all of them when absent. The others stay at ``at``.
        at: (n,); the middle of the box when absent.
        count: number of samples.
        starts: number of refinements.
    """
    ranges = box(arm)
    free = list(range(arm.n)) if moving is None else list(moving)
    rest = ranges.mean(axis=1) if at is None else np.asarray(at, float)
    tried = np.tile(rest, (count, 1))
    tried[:, free] = samples(arm, count)[:, free]
    best = tried[np.argsort(-values(tried), kind="stable")[:starts]]
    return best_of(arm, [climb(slope, start, free, ranges) for start in best], slope, free)


def climb(slope: Slope, start: Array, free: Sequence[int], ranges: Array) -> Array:
    """The local maximum reached from ``start`` (n,) by moving the joints ``free`` inside ``ranges`` (n, 2)."""
    from scipy.optimize import minimize

    chosen, q = list(free), np.array(start, float)
    if not chosen:
        return q

    def downhill(part: Array) -> tuple[float, Array]:
        q[chosen] = part
        value, gradient = slope(q)
        return -value, -gradient[chosen]

    result = minimize(
        downhill,
        q[chosen].copy(),
        jac=True,
        method="L-BFGS-B",
        bounds=ranges[chosen],
        options={"maxiter": 500, "ftol": 1e-16, "gtol": 1e-13},
    )
    q[chosen] = result.x
    return q


def best_of(arm: Arm, candidates: Sequence[Array], slope: Slope, free: Sequence[int]) -> Found:
    """The best of several configurations; among equals the one whose moving joints come last in order."""
    turning = turns_freely(arm)
    wrapped = [np.where(turning, -np.remainder(np.pi - q, 2 * np.pi) + np.pi, q) for q in candidates]
    scored = [(slope(q)[0], q) for q in wrapped]
    top = max(value for value, _ in scored)
    equal = [(value, q) for value, q in scored if value >= top - 1e-9 * abs(top)]
    equal.sort(key=lambda pair: tuple(np.round(pair[1][list(free)], 6)), reverse=True)
    distinct: list[Array] = []
    for _, q in equal:
        if all(np.abs(q - other).max() > 1e-5 for other in distinct):
            distinct.append(q)
    return Found(equal[0][0], distinct[0], np.array(distinct[1:]).reshape(-1, arm.n))
