"""Postures in which a path can begin: many at its first target, and the best of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.redundancy.step import Law, Stepper
from chainrule.search import samples

Array = NDArray[Any]

#: Random configurations from which postures are sought.
STARTS = 64
#: Most corrections of a posture, the largest change of a joint in one (rad or m), and the error that is none.
CORRECTIONS, STRIDE, ARRIVED = 100, 0.5, 1e-12
#: Steps uphill, and the largest change of a joint in the first of them (rad or m); it shrinks evenly to nothing.
CLIMBS, CLIMB = 120, 0.1
#: An error of the task up to which a posture on the way up counts (it is brought back to the target at the end).
HELD = 1e-3


def bring(arm: Arm, task: str, target: Any, q: Array) -> tuple[Array, Array]:
    """Postures (k, n) at the target, by Newton's method from ``q`` (k, n), and which of them arrived (k,).

    Args:
        arm: the arm.
        task: what is held.
        target: one target, or (k, ...).
        q: (k, n).
    """
    newton = Stepper(arm, Law(feedback=(1.0, 1.0)), task)
    q = np.array(q, float)
    arrived = np.zeros(len(q), bool)
    for _ in range(CORRECTIONS if len(q) else 0):
        step = newton(q, target, None, 1.0)
        arrived = np.abs(step.error).max(axis=1, initial=0.0) <= ARRIVED
        if arrived.all():
            break
        size = np.abs(step.rates).max(axis=1, keepdims=True)
        q = q + np.where(arrived[:, None], 0.0, step.rates * np.minimum(1.0, STRIDE / np.maximum(size, 1e-300)))
    return q, arrived


def within(arm: Arm, q: Array) -> tuple[Array, Array]:
    """The same postures (k, n) with revolute joints turned by whole turns to near the middle of their range.

    Also whether each is inside the position limits (k,).
    """
    low, high = arm.limits.position.T
    turning = np.array([kind == "R" for kind in arm.kinds])
    with np.errstate(invalid="ignore"):
        middle = np.where(np.isfinite(low + high), (low + high) / 2.0, 0.0)
    turns = np.where(turning, np.rint((middle - q) / (2.0 * np.pi)), 0.0)
    moved = q + 2.0 * np.pi * turns
    return moved, np.asarray(((moved >= low) & (moved <= high)).all(axis=1))


def postures_at(arm: Arm, task: str, target: Any, count: int = STARTS, seed: int = 0) -> Array:
    """Different postures (k, n) at one target and inside the position limits, from ``count`` random starts.

    Raises:
        InputError: none was found.
    """
    q, arrived = bring(arm, task, target, samples(arm, count, seed))
    q, inside = within(arm, q)
    found = q[arrived & inside]
    if not len(found):
        where = "none of them inside the joint limits" if arrived.any() else "none of them arrived"
        raise InputError(f"{arm.name}: no posture was found at the start of the path from {count} starts ({where})")
    return found


def best(arm: Arm, task: str, target: Any, count: int = STARTS, seed: int = 0) -> Array:
    """The posture (n,) of the largest manipulability met at a target, inside the position limits.

    With one joint to spare every curve of the self-motion is looked at (:func:`chainrule.best_posture`); with more,
    many postures climb along the gradient while they hold the target: the best one met, not proved to be the best.

    Raises:
        InputError: no posture reaches the target.
    """
    if arm.n - arm.tasks[task] == 1:
        from chainrule.self_motions.best import best_posture

        return np.asarray(within(arm, best_posture(arm, target, task=task, limits=True).q[None])[0][0])
    q = postures_at(arm, task, target, count, seed)
    climb = Stepper(arm, Law({"H": 1.0}, feedback=(1.0, 1.0)), task)
    kept, top = q.copy(), arm.manipulability(q, task=task)
    for k in range(CLIMBS):
        step = climb(q, target, None, 1.0)
        correction = step.rates - step.null_motion
        size = np.abs(step.null_motion).max(axis=1, keepdims=True)
        reach = CLIMB * (1.0 - k / CLIMBS)
        q = q + correction + step.null_motion * np.minimum(1.0, reach / np.maximum(size, 1e-300))
        q, inside = within(arm, q)
        value = arm.manipulability(q, task=task)
        better = inside & (np.abs(step.error).max(axis=1) <= HELD) & (value > top)
        kept[better], top[better] = q[better], value[better]
    kept, arrived = bring(arm, task, target, kept)
    kept, inside = within(arm, kept)
    good = arrived & inside
    value = np.where(good, arm.manipulability(kept, task=task), -np.inf)
    return np.asarray(kept[int(np.argmax(value))])
