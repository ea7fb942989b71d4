"""Paths that begin at the tip of a posture, and a posture to begin in: to try an arm without drawing a path for it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError
from chainrule.inputs import real_array
from chainrule.redundancy.asked import orientation_of
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.time_laws import positive
from chainrule.search import samples

Array = NDArray[Any]

#: Random postures of which the best is taken.
TRIED = 4096
#: The share of the time in which a path from rest to rest gets to its speed.
RAMP = 0.25


def good_posture(arm: Arm, task: str | None = None) -> Array:
    """(n,): of many random postures within the limits the one with the largest manipulability.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.load("panda")
        >>> bool(arm.manipulability(good_posture(arm)) > 0.08)
        True
    """
    q = samples(arm, TRIED)
    found: Array = q[int(np.argmax(arm.manipulability(q, task=arm.task_of_full_rank(task))))]
    return found


def _tip(arm: Arm, q: Any) -> tuple[Array, Any]:
    """Where the tip is at a posture, and how it is turned."""
    posture = real_array(q, "q")
    if posture.shape != (checked_arm(arm).n,):
        raise InputError(f"q: shape {posture.shape}; ({arm.n},), one value for each joint of {arm.name}, is accepted")
    tip = np.asarray(arm.position(posture))
    return tip, orientation_of(arm, posture, tip.size)


def circle_through(arm: Arm, q: Any, radius: float, duration: float = 2.0) -> TaskPath:
    """A circle through the tip at ``q`` (n,), from rest to rest, with the tip's orientation held.

    It lies level, in a plane of constant z (for a planar arm in its plane), and its centre is on the base's side of the
    tip.

    Args:
        arm: the arm.
        q: (n,) the posture in which the path begins.
        radius: m.
        duration: s.

    Raises:
        InputError: a posture of another length, a radius or duration that is not positive.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> path = circle_through(arm, [0.0, 0.6, -0.6], 0.1)
        >>> bool(np.allclose(path.sample([0.0, 2.0], "position").held, arm.position([0.0, 0.6, -0.6])))
        True
    """
    tip, turned = _tip(arm, q)
    size = positive(radius, "radius")
    outwards = np.zeros(tip.size)
    level = float(np.hypot(*tip[:2]))
    outwards[:2] = tip[:2] / level if level > 1e-9 else (1.0, 0.0)
    across = np.zeros(tip.size)
    across[:2] = -outwards[1], outwards[0]
    ramp = RAMP * positive(duration, "duration")
    return TaskPath.circle(
        tip - size * outwards, size, x=outwards, y=across, orientation=turned, duration=duration, ramp=ramp
    )


def line_from(arm: Arm, q: Any, displacement: Any, duration: float = 2.0) -> TaskPath:
    """A straight line from the tip at ``q`` (n,) by a displacement (m), from rest to rest, the orientation held.

    Raises:
        InputError: a posture or displacement of another length, a duration that is not positive.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> round(line_from(arm, [0.0, 0.6, -0.6], [-0.3, 0.0]).length, 9)
        0.3
    """
    tip, turned = _tip(arm, q)
    way = real_array(displacement, "displacement")
    if way.shape != tip.shape:
        raise InputError(f"displacement: {way.size} numbers; {tip.size} are accepted for {arm.name}")
    ramp = RAMP * positive(duration, "duration")
    return TaskPath.line(tip, tip + way, orientation=turned, duration=duration, ramp=ramp)
