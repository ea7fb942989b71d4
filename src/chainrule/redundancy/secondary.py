"""Secondary tasks ready to use with ``method="priority"``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError, shown
from chainrule.paths import real_number
from chainrule.redundancy.asked import Secondary
from chainrule.redundancy.time_laws import positive

Array = NDArray[Any]

#: How fast a joint is led to its value, 1/s.
RATE = 2.0


def joints_towards(arm: Arm, values: Mapping[str, float], rate: float = RATE) -> Secondary:
    """The secondary task that leads joints to values: q_j' = rate (value_j - q_j).

    Args:
        arm: the arm.
        values: rad or m by joint: its name, or q1, q2, ... in order. At most as many as there are joints to spare.
        rate: 1/s.

    Raises:
        InputError: no joint, one that the arm does not have, one named twice, a number that is not finite.

    Example:
        >>> import chainrule as cr
        >>> from chainrule.redundancy.samples import circle_through, good_posture
        >>> arm = cr.load("panda")
        >>> start = good_posture(arm)
        >>> still = joints_towards(arm, {"q3": start[2]})
        >>> run = cr.track(arm, circle_through(arm, start, 0.1), start, method="priority", secondary=still, gain=0.0)
        >>> bool(abs(run.q[:, 2] - start[2]).max() < 1e-3)
        True
    """
    names = checked_arm(arm).joint_names
    if not isinstance(values, Mapping) or not values:
        raise InputError(f"values: {shown(values)}; a value for each of one or more joints is accepted")
    chosen: list[int] = []
    for name in values:
        known = [j for j in range(arm.n) if name in (names[j], f"q{j + 1}")]
        if not known:
            raise InputError(f"joint {shown(name)}: {arm.name} has {', '.join(names)}, or q1 to q{arm.n}")
        if known[0] in chosen:
            raise InputError(f"joint {shown(name)}: it has a value already")
        chosen.append(known[0])
    aims = np.array([real_number(value, f"joint '{name}'") for name, value in values.items()])
    rows, speed = np.eye(arm.n)[chosen], positive(rate, "rate")

    def task(t: float, q: Array) -> tuple[Array, Array]:
        return rows, speed * (aims - q[chosen])

    return task
