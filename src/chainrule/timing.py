"""The fastest joint motion from rest to rest under bounds on velocity and acceleration (De Luca, exercise 2).

Each joint by itself is fastest when it speeds up at its largest acceleration A, coasts at its largest velocity V, and
slows down again; with d the distance, the peak is min(V, sqrt(d A)) and the time d / V + V / A, or 2 sqrt(d / A) where
V is not reached. The arm needs the time T of its slowest joint. The formulas are derived in
``chainrule.derive.rest_to_rest`` and generated; here they meet arrays and the three ways of bringing joints together.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from chainrule.description import REST_TO_REST
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluator, Evaluators
from chainrule.inputs import real_array

Array = NDArray[Any]
Synchronise = Literal["none", "time", "phase"]

#: What each case of a joint's own fastest motion means.
CASES = {
    "a": "reaches its largest velocity and coasts",
    "b": "just reaches its largest velocity",
    "c": "slows down before it reaches its largest velocity",
    "d": "does not move",
}

#: A relative difference that a few roundings can make: smaller ones count as equality.
ROUNDING = 4.0 * float(np.finfo(float).eps)


class State(NamedTuple):
    """Where the joints are at some times: arrays (..., n) of rad or m, and their first and second derivatives."""

    position: Array
    velocity: Array
    acceleration: Array


@dataclass(frozen=True)
class JointMove:
    """A motion of n joints from rest to rest; units rad or m, and s. Leading axes are those of the inputs.

    Attributes:
        start, goal: (..., n) where it begins and ends.
        v_max, a_max: (..., n) the bounds.
        synchronise: ``"none"``, ``"time"`` or ``"phase"``.
        duration: (...) of the whole motion.
        joint_durations: (..., n) the least time each joint needs, whatever the others do.
        cases: (..., n) the case of each joint's own fastest motion, ``a`` to ``d`` (:data:`CASES`). ``b`` stands for
            d = V^2 / A within :data:`ROUNDING` of V^2 / A + |start| + |goal|.
        peak: (..., n) the largest speed in this motion.
        acceleration: (..., n) the size of the acceleration in its ramps.
        ramp, cruise: (..., n) the times of speeding up (and of slowing down), and between them.
    """

    start: Array
    goal: Array
    v_max: Array
    a_max: Array
    synchronise: Synchronise
    duration: Array
    joint_durations: Array
    cases: Array
    peak: Array
    acceleration: Array
    ramp: Array
    cruise: Array

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.start.shape[-1])

    @property
    def travel(self) -> Array:
        """(..., n) how long each joint moves in this motion: 0 where it stays."""
        if self.synchronise == "none":
            return self.joint_durations
        return np.where(self.cases == "d", 0.0, self.duration[..., None])

    @property
    def slack(self) -> Array:
        """(..., n) how much less time each joint needs than the motion takes."""
        found: Array = self.duration[..., None] - self.joint_durations
        return found

    @property
    def bottleneck(self) -> Array:
        """(..., n) whether a joint needs all of the time: its slack is no more than rounding makes.

        A distance is known to a rounding of start and goal, and dT/dd = 1 / peak, so the times are known to a rounding
        of T + (|start| + |goal|) / peak (and to T itself at worst).
        """
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            blur = (np.abs(self.start) + np.abs(self.goal)) / _own_peak(self)
        blur = np.fmin(ROUNDING * blur, self.joint_durations) + ROUNDING * self.joint_durations
        slowest = np.max(np.where(self.slack <= 0.0, blur, 0.0), axis=-1, keepdims=True, initial=0.0)
        found: Array = (self.slack <= blur + slowest) & ((self.cases != "d") | (self.slack <= 0.0))
        return found

    @property
    def unique(self) -> Array:
        """(...) whether no other motion of this duration reaches the goal within the bounds.

        A joint that needs all of the time has one way to do it. One with slack has infinitely many: it may wait, go
        slower, or move and come back. So the motion is unique exactly if every joint needs all of the time, or cannot
        move because a bound is 0.
        """
        found: Array = np.all(self.bottleneck | (self.v_max == 0.0) | (self.a_max == 0.0), axis=-1)
        return found

    def sample(self, t: Any) -> State:
        """Position, velocity and acceleration at times t (s), which broadcast with the leading axes.

        Before 0 the joints rest at the start, from the end on at the goal, which is met exactly. At a time where the
        acceleration jumps it has its later value. Where a_max is infinite the velocity jumps, and the acceleration,
        which has no value there, is given as 0.

        Raises:
            InputError: times that are not real numbers, or do not broadcast.

        Example:
            >>> move = min_time([0.0], [2.0], [1.0], [1.0])
            >>> [part.tolist() for part in move.sample([0.5, 1.5, 9.0])]
            [[[0.125], [1.0], [2.0]], [[0.5], [1.0], [0.0]], [[1.0], [0.0], [0.0]]]
        """
        times = real_array(t, "t", finite=False)
        try:
            np.broadcast_shapes(times.shape, self.duration.shape)
        except ValueError:
            raise InputError(
                f"t has shape {times.shape}, which does not broadcast with the {self.duration.shape} of the moves"
            ) from None
        time, travel = times[..., None], self.travel
        late = time >= travel / 2.0  # the second half is the first one backwards: symmetric, and exact at the goal
        since = np.clip(np.where(late, travel - time, time), 0.0, travel / 2.0)
        phases = np.broadcast_arrays(self.peak, self.ramp, self.cruise, since)
        distance, speed = np.moveaxis(_function("rest_to_rest_state")(np.stack(phases, axis=-1)), -1, 0)
        sense, moving = np.sign(self.goal - self.start), (time >= 0.0) & (time < travel)
        position = np.where(late, self.goal - sense * distance, self.start + sense * distance)
        speed = np.where(self.ramp > 0.0, speed, self.peak * moving)
        ramping = moving & np.where(late, since <= self.ramp, since < self.ramp) & (self.ramp > 0.0)
        rate = np.where(ramping, self.acceleration, 0.0) * np.where(late, -1.0, 1.0)
        return State(position, sense * speed + 0.0, sense * rate + 0.0)  # + 0.0: no negative zeros

    def pick(self, index: Any) -> JointMove:
        """One motion, or some, of a batch: ``index`` goes into the leading axes."""
        arrays = {name: value for name, value in vars(self).items() if name != "synchronise"}
        return replace(self, **{name: array[index] for name, array in arrays.items()})

    def to_dict(self) -> dict[str, Any]:
        """Plain values; an infinite bound is None."""
        arrays = {
            "start": self.start,
            "goal": self.goal,
            "v_max": self.v_max,
            "a_max": self.a_max,
            "duration": self.duration,
            "joint_durations": self.joint_durations,
            "cases": self.cases,
            "peak": self.peak,
            "acceleration": self.acceleration,
            "ramp": self.ramp,
            "cruise": self.cruise,
            "slack": self.slack,
            "bottleneck": self.bottleneck,
            "unique": self.unique,
        }
        return {"synchronise": self.synchronise, **{name: _plain(array.tolist()) for name, array in arrays.items()}}


def min_time(start: Any, goal: Any, v_max: Any, a_max: Any, *, synchronise: Synchronise = "none") -> JointMove:
    """The fastest motion from rest to rest with |velocity| <= v_max and |acceleration| <= a_max at every joint.

    Args:
        start: (..., n) joint values in rad or m.
        goal: (..., n) likewise, taken as they are (no turn is added or left out).
        v_max: (n,) or (..., n) largest velocities, or one number for all joints.
        a_max: the same for accelerations. One of the two may be infinite; 0 is accepted only for a joint that does
            not move.
        synchronise: ``"none"``: each joint moves as fast as it can, and waits at its goal. ``"time"``: all end
            together at the same T; a joint with slack keeps its acceleration and lowers its peak to
            2 d / (T + sqrt(T^2 - 4 d / A)). ``"phase"``: all stay in proportion, on a straight line in joint space,
            along which the velocity is bounded by min(V / d) and the acceleration by min(A / d) (d the distances). That
            takes exactly T if one joint has the least A / d and (unless the line's peak is a triangle's) also the least
            V / d; otherwise longer, and no motion on the line is faster.

    Returns:
        A :class:`JointMove`, with what is known of its uniqueness and slack.

    Raises:
        InputError: wrong shapes; entries that are not finite; bounds that are negative, or 0 or both infinite where
            the joint moves; an unknown ``synchronise``.

    Source: A. De Luca, Robotics I, exam of 11 January 2012, exercise 2, equations (2) to (4).

    Example:
        >>> import numpy as np
        >>> V, A = np.radians([90.0, 120.0, 60.0]), np.radians([150.0, 160.0, 240.0])
        >>> move = min_time([0.0, 0.0, 0.0], np.radians([0.0, 90.0, -90.0]), V, A)
        >>> move.joint_durations.round(4), "".join(move.cases), bool(move.unique)
        (array([0.  , 1.5 , 1.75]), 'dba', False)
    """
    if synchronise not in get_args(Synchronise):
        raise InputError(f"synchronise: {shown(synchronise)}; 'none', 'time' or 'phase' is accepted")
    first, last, v, a = _broadcast(start, goal, v_max, a_max)
    with np.errstate(over="ignore"):
        distance = np.abs(last - first)
    _check(distance, v, a)
    moving = distance > 0.0
    own = _profile(distance, v, a)
    longest = own[..., 3].max(axis=-1, initial=0.0)
    if synchronise == "phase":
        used, rate = _in_phase(distance, v, a)
        duration = used[..., 3].max(axis=-1, initial=0.0)
    else:
        used, rate, duration = own, np.where(moving, a, 0.0), longest
    _check_size(own[..., 3], duration)
    move = JointMove(
        first,
        last,
        v,
        a,
        synchronise,
        duration[()],
        own[..., 3],
        _cases(first, last, v, a),
        *(used[..., 0], rate, used[..., 1], used[..., 2]),
    )
    return _stretched(move, distance) if synchronise == "time" else move


def _broadcast(start: Any, goal: Any, v_max: Any, a_max: Any) -> list[Array]:
    """The four inputs with one shape (..., n)."""
    first, last = real_array(start, "start"), real_array(goal, "goal")
    if first.ndim == 0 or last.ndim == 0 or first.shape[-1] != last.shape[-1] or first.shape[-1] == 0:
        raise InputError(
            f"start has shape {first.shape} and goal {last.shape}; (..., n) with the same n >= 1 is accepted"
        )
    n = first.shape[-1]
    bounds = [real_array(v_max, "v_max", finite=False), real_array(a_max, "a_max", finite=False)]
    for name, bound in zip(("v_max", "a_max"), bounds, strict=True):
        if bound.ndim and bound.shape[-1] != n:
            raise InputError(f"{name} has shape {bound.shape}; ({n},), (..., {n}) or one number is accepted")
    try:
        return [np.array(part) for part in np.broadcast_arrays(first, last, *bounds)]
    except ValueError:
        shapes = ", ".join(str(part.shape) for part in (first, last, *bounds))
        raise InputError(f"start, goal, v_max and a_max have shapes {shapes}; they must broadcast together") from None


def _check(distance: Array, v: Array, a: Array) -> None:
    """Refuse what has no answer, naming the first place."""
    moving = distance > 0.0
    for wrong, reason in (
        (~np.isfinite(distance), "the way from start to goal is too long for a number"),
        ((v < 0.0) | (a < 0.0), "a bound is negative"),
        (moving & ((v == 0.0) | (a == 0.0)), "the joint has to move and a bound is 0"),
        (moving & np.isinf(v) & np.isinf(a), "both bounds are infinite, so there is no fastest motion"),
    ):
        if wrong.any():
            at = tuple(int(i) for i in np.argwhere(wrong)[0])
            where = f"joint {at[-1] + 1}" + (f" of move {list(at[:-1])}" if at[:-1] else "")
            raise InputError(
                f"{where}: {reason} (distance {distance[at]:.6g}, v_max {v[at]:.6g}, a_max {a[at]:.6g}); positive "
                "bounds are accepted, one of the two may be infinite"
            )


def _check_size(*times: Array) -> None:
    if not all(np.isfinite(time).all() for time in times):
        raise InputError("the motion takes longer than the largest number; larger bounds are accepted")


@cache
def _evaluators() -> Evaluators:
    return Evaluators(REST_TO_REST)


def _function(name: str) -> Evaluator:
    found = _evaluators().get("rest_to_rest", name)
    assert found is not None
    return found


def _profile(distance: Array, v: Array, a: Array) -> Array:
    """(..., 4) peak, ramp, cruise and duration of each joint's own fastest motion."""
    moving = distance > 0.0  # bounds of joints that stay play no part: any will do
    given = np.stack([distance, np.where(moving, v, 1.0), np.where(moving, a, 1.0)], axis=-1)
    found: Array = _function("rest_to_rest")(given)
    return found


def _cases(first: Array, last: Array, v: Array, a: Array) -> Array:
    distance = np.abs(last - first)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        limit = v / a * v  # the distance that just reaches V
        near = np.abs(distance - limit) <= ROUNDING * limit + ROUNDING * np.abs(first) + ROUNDING * np.abs(last)
    equal = np.isfinite(limit) & near
    codes = np.where(distance > limit, np.uint8(0), np.uint8(2))  # letters come last: comparing text is slow
    codes[equal] = 1
    codes[distance == 0.0] = 3
    return np.array(list(CASES)).take(codes)


def _own_peak(move: JointMove) -> Array:
    return _profile(np.abs(move.goal - move.start), move.v_max, move.a_max)[..., 0]


def _in_phase(distance: Array, v: Array, a: Array) -> tuple[Array, Array]:
    """Profiles (..., n, 4) and accelerations (..., n) on a straight line in joint space.

    The line is measured by the longest way on it, of which every joint goes a share.
    """
    longest = distance.max(axis=-1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        share = np.where(longest > 0.0, distance / longest, 0.0)
        speed = np.where(share > 0.0, v / share, np.inf).min(axis=-1)
        rate = np.where(share > 0.0, a / share, np.inf).min(axis=-1)
        rates = np.where(share > 0.0, np.minimum(rate[..., None] * share, a), 0.0)
    line = np.where((share > 0.0)[..., None], _profile(longest[..., 0], speed, rate)[..., None, :], 0.0)
    line[..., 0] = np.minimum(line[..., 0] * share, v)
    return line, rates


def _stretched(move: JointMove, distance: Array) -> JointMove:
    """The same motion with every joint that has slack slowed down to end with the others."""
    moving = distance > 0.0
    a = np.where(moving, move.a_max, 1.0)
    given = np.stack(np.broadcast_arrays(distance, a, move.duration[..., None]), axis=-1)
    slow = _function("rest_to_rest_in")(given)
    late = moving & ~move.bottleneck
    peak, ramp, cruise = (
        np.where(late, slow[..., k], part) for k, part in enumerate((move.peak, move.ramp, move.cruise))
    )
    return replace(move, peak=peak, ramp=ramp, cruise=cruise)


def _plain(value: Any) -> Any:
    """Nested lists in which what is infinite is None."""
    if isinstance(value, list):
        return [_plain(part) for part in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
