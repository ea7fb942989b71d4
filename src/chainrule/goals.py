"""Where a motion may end: the postures of a pose, the turns of a revolute joint, and the fastest choice among them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.timing import ROUNDING, JointMove, Synchronise, min_time
from chainrule.workspaces import ring

Array = NDArray[Any]
TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Postures:
    """The postures of a planar 3R arm that put its tip in a pose.

    Attributes:
        status: ``"regular"``: two postures, elbow to either side. ``"singular"``: one, the first two links in one
            line. ``"free"``: the wrist (the last joint) is on the first joint's axis and l1 = l2, so that the first
            joint can have any angle; the one row given has q1 = 0, and q1 + q3 is the same for all. ``"unreachable"``.
        q: (k, 3) rad, each angle in (-pi, pi]; elbow to the left (q2 > 0) first. Joint limits play no part.
        wrist: distance of the wrist from the base, m.
        ring: the smallest and largest distance the wrist can have, m.
    """

    status: Literal["regular", "singular", "free", "unreachable"]
    q: Array
    wrist: float
    ring: tuple[float, float]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"status": self.status, "q": self.q.tolist(), "wrist": self.wrist, "ring": list(self.ring)}


def postures(arm: Arm, x: float, y: float, alpha: float) -> Postures:
    """All postures of a planar 3R arm with its tip at (x, y) m and its last link at the angle alpha rad to the x axis.

    The wrist is at w = (x, y) - l3 (cos alpha, sin alpha), and the first two links reach it as a 2R arm; the formulas
    are in ``chainrule.derive.planar_3r``. Where the wrist is at the edge of their ring to within rounding, the two
    postures are one.

    Raises:
        InputError: any other arm; a first or second link without length; numbers that are not finite, or too large
            for the links.

    Source: A. De Luca, Robotics I, exam of 11 January 2012, exercise 2.

    Example:
        >>> from chainrule import planar_3r
        >>> import numpy as np
        >>> found = postures(planar_3r(1.0, 0.5, 0.25), 1.25, 0.5, 0.0)
        >>> np.degrees(found.q).round(2) + 0.0
        array([[  0.  ,  90.  , -90.  ],
               [ 53.13, -90.  ,  36.87]])
    """
    if checked_arm(arm).description.model.name != "planar_rrr":
        space = (
            "; in space ask chainrule.regional_3r(arm).postures(x, y, z)"
            if arm.kinds == "RRR" and "x_alpha" not in arm.tasks
            else ""
        )
        raise InputError(
            f"{arm.name}: the postures of a pose are known for planar arms with three revolute joints{space}"
        )
    target = real_array([x, y, alpha], "the pose (x, y, alpha)")
    if target.shape != (3,):
        raise InputError(f"the pose (x, y, alpha): arrays of shape {target.shape[1:]}; three numbers are accepted")
    lengths = [float(length) for length in arm.parameters]
    if lengths[0] == 0.0 or lengths[1] == 0.0:
        raise InputError(f"{arm.name}: link {1 if lengths[0] == 0.0 else 2} has no length; the first two need one")
    # In units of a power of two near the longer link, which rounds nothing: squares neither overflow nor vanish.
    unit = math.frexp(max(abs(lengths[0]), abs(lengths[1])))[1] - 1
    with np.errstate(over="ignore"):
        l1, l2, l3, at_x, at_y = (float(np.ldexp(value, -unit)) for value in (*lengths, target[0], target[1]))
    target = np.array([at_x, at_y, target[2]])
    w = (at_x - l3 * math.cos(target[2]), at_y - l3 * math.sin(target[2]))
    wrist, (inner, outer) = math.hypot(*w), ring([l1, l2])
    if not math.isfinite(wrist):
        raise InputError(f"{arm.name}: the pose or the last link is too many times larger than the first two links")
    rounding = sum(ROUNDING * abs(value) for value in (at_x, at_y, l1, l2, l3))
    measured = (_in_metres(wrist, unit), (_in_metres(inner, unit), _in_metres(outer, unit)))
    if not inner - rounding <= wrist <= outer + rounding:
        return Postures("unreachable", np.empty((0, 3)), *measured)
    # A link of negative length is one of positive length that points the other way.
    back = (math.pi if l1 < 0.0 else 0.0, math.pi if l2 < 0.0 else 0.0)
    if rounding < wrist - inner and rounding < outer - wrist:
        solutions, _ = arm.evaluator("postures")(target, np.array([abs(l1), abs(l2), l3]))
        q = _with_lengths_back(solutions, back)
        return Postures("regular", q[np.argsort(-q[:, 1], kind="stable")], *measured)
    free, folded = wrist <= rounding, wrist <= inner + rounding
    away = folded and abs(l1) < abs(l2)  # the second link, the longer one, points to the wrist
    first = back[0] if free else math.atan2(w[1], w[0]) + (math.pi if away else 0.0)
    elbow = math.pi if folded else 0.0
    q = _with_lengths_back(np.array([[first, elbow, target[2] - first - elbow]]), back)
    return Postures("free" if free else "singular", q, *measured)


def _in_metres(value: float, unit: int) -> float:
    """``value`` times a power of two; infinite where no double is as large."""
    with np.errstate(over="ignore"):
        return float(np.ldexp(value, unit))


def _with_lengths_back(q: Array, back: tuple[float, float]) -> Array:
    """Angles q (k, 3) found for links of positive length, as the arm's own; ``back`` turns its negative links round."""
    return wrapped(q - [back[0], back[1] - back[0], -back[1]])


def wrapped(angles: Any) -> Array:
    """Angles in (-pi, pi].

    Example:
        >>> wrapped([3.5, -np.pi, 0.25]).round(4)
        array([-2.7832,  3.1416,  0.25  ])
    """
    given = np.asarray(angles, float)
    rest = given - TURN * np.rint(given / TURN)
    found: Array = np.where(rest <= -math.pi, math.pi, rest)
    return found


@dataclass(frozen=True)
class Turns:
    """Goals at their nearest turns.

    Attributes:
        q: (..., n) the goals, with whole turns added where that is nearer to the start.
        allowed: (...) whether every joint is inside its limits there.
        either_way: (..., n) whether the way round the other side is as long and allowed too; the positive one is in q.
    """

    q: Array
    allowed: Array
    either_way: Array


def nearest_turns(start: Any, goals: Any, kinds: str, position: Any = None) -> Turns:
    """The goals with the whole turns added that bring them nearest to the start, inside the joint limits.

    Args:
        start: (n,) rad or m.
        goals: (..., n) rad or m.
        kinds: the joints' kinds, such as ``"RRP"``: an ``R`` may take any turn, a ``P`` is left as it is.
        position: (n, 2) lower and upper limits; none when absent. A goal within rounding of a limit is at the limit.

    A turn added is a rounding made: a goal that equals the start within ``ROUNDING`` of their sizes and one turn is the
    start. Where no turn of a joint is inside the limits, the goal is not ``allowed``, and its q the nearest turn.

    Raises:
        InputError: wrong shapes or kinds; numbers that are not finite; a start outside the limits.

    Example:
        >>> nearest_turns([3.0], [[-3.0], [3.0 - np.pi]], "R").q.round(4)
        array([[3.2832],
               [6.1416]])
    """
    first, last = real_array(start, "start"), real_array(goals, "goals")
    if first.ndim != 1 or last.ndim == 0 or last.shape[-1] != first.size:
        raise InputError(f"start has shape {first.shape} and goals {last.shape}; (n,) and (..., n) are accepted")
    if not isinstance(kinds, str) or len(kinds) != first.size or set(kinds) - set("RP"):
        raise InputError(f"kinds: {shown(kinds)}; one letter R or P for each of the {first.size} joints is accepted")
    lower, upper = _limits(first, position)
    with np.errstate(over="ignore"):
        if not np.isfinite(first - last).all():
            raise InputError("goals: the way from start to goal is too long for a number")
    blur = ROUNDING * (np.abs(first) + np.abs(last) + TURN)
    turning = np.array([kind == "R" for kind in kinds])
    least, most = (np.where(turning, part, 0.0) for part in _turns_inside(last, lower - blur, upper + blur))
    nearest = np.where(turning, np.rint((first - last) / TURN), 0.0)
    inside = np.where(turning, least <= most, (lower - blur <= last) & (last <= upper + blur))
    turns = np.where(inside, np.clip(nearest, least, np.maximum(least, most)), nearest)
    q = np.where(turns == 0.0, last, last + TURN * turns)
    way = q - first
    other = turns - np.copysign(1.0, way)
    either = turning & inside & (np.abs(np.abs(way) - math.pi) <= blur) & (least <= other) & (other <= most)
    q = np.where(either & (way < 0.0), last + TURN * other, q)
    q = np.where(np.abs(q - first) <= np.where(turning, blur, 0.0), first, q)
    q = np.where(inside, np.clip(q, lower, upper), q)
    return Turns(q, np.all(inside, axis=-1), either)


def _limits(start: Array, position: Any) -> tuple[Array, Array]:
    if position is None:
        return np.full(start.size, -np.inf), np.full(start.size, np.inf)
    limits = real_array(position, "position", finite=False)
    if limits.shape != (start.size, 2):
        raise InputError(f"position has shape {limits.shape}; ({start.size}, 2) is accepted")
    lower, upper = limits[:, 0], limits[:, 1]
    for j in np.flatnonzero((start < lower) | (start > upper)):
        raise InputError(
            f"start, joint {j + 1}: {start[j]:.6g} is outside the limits {lower[j]:.6g} to {upper[j]:.6g}; a start "
            "inside them is accepted"
        )
    return lower, upper


def _turns_inside(goals: Array, lower: Array, upper: Array) -> tuple[Array, Array]:
    """The fewest and the most turns that leave a goal inside its limits."""
    return np.ceil((lower - goals) / TURN), np.floor((upper - goals) / TURN)


@dataclass(frozen=True)
class FastestMove:
    """The fastest of several motions from one start.

    Attributes:
        index: the row of the goal chosen, from 0; the first where several are as fast.
        move: the motion to it.
        moves: the motions to all goals, leading axis k.
        durations: (k,) their durations in s, infinite where a goal is outside the joint limits.
        equally_fast: rows of all goals reached in the least time, to within rounding.
        either_way: (k, n) the joints that could as well go round the other side.
    """

    index: int
    move: JointMove
    moves: JointMove
    durations: Array
    equally_fast: tuple[int, ...]
    either_way: Array

    @property
    def unique(self) -> bool:
        """Whether there is no other motion as fast: no second goal or turn, and every joint needs all of the time."""
        return len(self.equally_fast) == 1 and not self.either_way[self.index].any() and bool(self.move.unique)

    def to_dict(self) -> dict[str, Any]:
        """Plain values; the duration to a goal outside the joint limits is None."""
        return {
            "index": self.index,
            "unique": self.unique,
            "equally_fast": list(self.equally_fast),
            "either_way": self.either_way.tolist(),
            "durations": [float(t) if math.isfinite(t) else None for t in self.durations],
            "move": self.move.to_dict(),
            "moves": self.moves.to_dict(),
        }


def fastest(
    start: Any,
    goals: Any,
    v_max: Any,
    a_max: Any,
    *,
    kinds: str | None = None,
    position: Any = None,
    synchronise: Synchronise = "none",
) -> FastestMove:
    """The fastest motion from rest at the start to rest at one of several goals.

    A shorter way never takes longer, so of all turns of a revolute joint the nearest is a fastest. Every joint moves
    without turning back, so it keeps its position limits all the way if it does at both ends.

    Args:
        start: (n,) rad or m.
        goals: (k, n) such as :func:`postures` gives.
        v_max: largest velocities, (n,) or one number.
        a_max: largest accelerations, likewise.
        kinds: the joints' kinds (``arm.kinds``), if revolute goals stand for all their turns
            (:func:`nearest_turns`); when absent the goals are taken as they are.
        position: (n, 2) joint limits (``arm.limits.position``), if they are to be kept.
        synchronise: ``"none"``, ``"time"`` or ``"phase"``, as in :func:`chainrule.timing.min_time`.

    Raises:
        InputError: as :func:`chainrule.min_time` and :func:`nearest_turns`; no goal, or none inside the limits.

    Example:
        >>> from chainrule import load
        >>> arm = load("planar_3r")
        >>> goals = postures(arm, 1.25, 0.5, 0.0).q
        >>> best = fastest([0.0, 0.0, 0.0], goals, arm.limits.velocity, arm.limits.acceleration, kinds=arm.kinds)
        >>> best.index, best.durations.round(6), "".join(best.move.cases), best.unique
        (1, array([1.75, 1.5 ]), 'cba', False)
    """
    first, last = real_array(start, "start"), real_array(goals, "goals")
    if first.ndim != 1 or last.ndim != 2 or last.shape[1] != first.size or not len(last):
        raise InputError(f"start has shape {first.shape}, goals {last.shape}; (n,) and (k, n), k >= 1, are accepted")
    for name, bound in (("v_max", v_max), ("a_max", a_max)):
        axes = real_array(bound, name, finite=False).ndim
        if axes > 1:
            raise InputError(f"{name} has {axes} axes; ({first.size},) or one number is accepted")
    turns = nearest_turns(first, last, "P" * first.size if kinds is None else kinds, position)
    if not turns.allowed.any():
        raise InputError(f"no goal is inside the joint limits ({len(last)} given, with all their turns if any)")
    moves = min_time(first, turns.q, v_max, a_max, synchronise=synchronise)
    durations = np.where(turns.allowed, moves.duration, np.inf)
    least = float(durations.min())
    equal = tuple(int(k) for k in np.flatnonzero(durations <= least * (1.0 + 8.0 * ROUNDING)))
    return FastestMove(equal[0], moves.pick(equal[0]), moves, durations, equal, turns.either_way)
