"""Following a path many times at once: start postures, gains and steps as the axes of one vectorised simulation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import real_number
from chainrule.redundancy import starts as beginnings
from chainrule.redundancy.asked import both, check_criterion, check_dimension, number_of_steps, orientation_of
from chainrule.redundancy.measure import errors
from chainrule.redundancy.step import Damping, Law, Step, Stepper
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.time_laws import positive

Array = NDArray[Any]

#: Fewest steps of the coarse runs that choose a start or forecast.
COARSE = 150
#: What a forecast calls followed: rates up to this (rad/s or m/s), and position errors (m).
RATE, ERROR = 10.0, 1e-3
#: Gains that a forecast tries, as multiples of the one asked about.
TRIED = (0.0, 0.1, 0.3, 1.0, 3.0, 10.0)


@dataclass(frozen=True)
class Batch:
    """Many runs of one path: b start postures, g gains, d steps.

    Attributes:
        arm: its name.
        task: what was held.
        criterion: what the gains are of.
        integrator: "euler", "heun" or "rk4".
        starts: (b, n) rad or m.
        gains: (g,).
        dt: (d,) s.
        min_manipulability: (b, g, d) the smallest w at a sample of the run; of one that diverged until then.
        peak_rate: (b, g, d) the largest joint rate, rad/s or m/s; likewise.
        peak_acceleration: (b, g, d) the largest change of a joint rate from sample to sample, over dt, rad/s^2 or
            m/s^2; likewise. A gain too large for the step shows here first: the rates change sign at every sample.
        worst_position_error: (b, g, d) m; likewise.
        final_position_error: (b, g, d) m, at the end of the path; nan where the run diverged.
        final_orientation_error: (b, g, d) rad; likewise; 0 where the orientation is free.
        within_position: (b, g, d) whether every sample is inside the arm's position limits.
        within_velocity: (b, g, d) whether every rate is inside its velocity limits.
        diverged: (b, g, d) whether a rate exceeded the bound, or was not finite.
        diverged_at: (b, g, d) s, when; nan where it did not.
    """

    arm: str
    task: str
    criterion: str
    integrator: str
    starts: Array
    gains: Array
    dt: Array
    min_manipulability: Array
    peak_rate: Array
    peak_acceleration: Array
    worst_position_error: Array
    final_position_error: Array
    final_orientation_error: Array
    within_position: Array
    within_velocity: Array
    diverged: Array
    diverged_at: Array

    def to_dict(self) -> dict[str, Any]:
        """Plain values; None for what is not a number."""
        found: dict[str, Any] = {}
        for name in self.__dataclass_fields__:
            value = getattr(self, name)
            if isinstance(value, np.ndarray):
                plain = value.astype(object)
                if value.dtype.kind == "f":
                    plain[~np.isfinite(value)] = None
                value = plain.tolist()
            found[name] = value
        return found


def track_batch(
    arm: Arm,
    path: TaskPath,
    starts: Any,
    gains: Any = -2.0,
    dt: Any = None,
    *,
    task: str | None = None,
    criterion: str = "H^(-1/2)",
    integrator: Literal["euler", "heun", "rk4"] = "euler",
    feedback: Any = None,
    damping: Damping | None = None,
    weights: Any = None,
    stop_rate: float | None = None,
) -> Batch:
    """Follow a path from many start postures, with many gains and steps, at once.

    Every step of all runs is one call of the generated function. The arguments are those of :func:`chainrule.track`,
    with the same meaning; there are no limits, pushes or secondary tasks here.

    Args:
        arm: the arm.
        path: the path. Where it says no orientation each run holds that of its own start.
        starts: (b, n) or (n,).
        gains: (g,) or one number.
        dt: (d,) or one number, s.
        task: what is held.
        criterion: what the gains are of.
        integrator: "euler", "heun" or "rk4".
        feedback: 1/s.
        damping: of the task.
        weights: (n,) of the joints.
        stop_rate: rad/s or m/s; a run that exceeds it counts as diverged and is stopped.

    Raises:
        InputError: anything that is not accepted, in one line.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> path = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
        >>> start = cr.best_posture(arm, [0.6, 0.3]).q
        >>> found = cr.track_batch(arm, path, start, gains=[1.0, 3000.0], dt=[0.01, 0.001], criterion="H")
        >>> (found.peak_acceleration[0] > 1e3).tolist()     # the large gain needs the small step
        [[False, False], [True, False]]
    """
    task = checked_arm(arm).task_of_full_rank(task)
    if not isinstance(path, TaskPath):
        raise InputError(f"path: {shown(path)}; a TaskPath is accepted, such as TaskPath.line gives")
    check_dimension(arm, path)
    if integrator not in _SCHEMES:
        raise InputError(f"integrator: {shown(integrator)}; {', '.join(_SCHEMES)} are accepted")
    begin = np.atleast_2d(real_array(starts, "starts"))
    if begin.ndim != 2 or begin.shape[1] != arm.n:
        raise InputError(f"starts: shape {np.shape(starts)}; (b, {arm.n}) is accepted")
    values = _list(gains, "gains")
    check_criterion(arm, [criterion] if values.any() else [])
    steps = (
        [number_of_steps(path, float(one)) for one in _list(dt, "dt")]
        if dt is not None
        else [number_of_steps(path, None)]
    )
    targets = _Targets(arm, path, task, begin)
    found = []
    for count in steps:
        step = path.duration / count
        law = Law(
            {},
            both(feedback, step),
            Damping() if damping is None else damping,
            None if weights is None else tuple(real_array(weights, "weights", finite=False).tolist()),
        )
        laws = [replace(law, gains={criterion: float(value)}) for value in values]
        bound = np.pi / step if stop_rate is None else positive(stop_rate, "stop_rate")
        found.append(_simulated(Stepper(arm, laws, task), targets, begin, len(laws), count, step, integrator, bound))
    stacked = {name: np.stack([one[name] for one in found], axis=-1) for name in found[0]}
    return Batch(
        arm=arm.name,
        task=task,
        criterion=criterion,
        integrator=integrator,
        starts=begin,
        gains=values,
        dt=np.array([path.duration / count for count in steps]),
        **stacked,
    )


def _list(values: Any, name: str) -> Array:
    found = np.atleast_1d(real_array(values, name))
    if found.ndim != 1 or not found.size:
        raise InputError(f"{name}: shape {found.shape}; a number or a list of them is accepted")
    return found


class _Targets:
    """Targets of b runs, which may each hold the orientation of its own start; axes (b, 1, ...)."""

    def __init__(self, arm: Arm, path: TaskPath, task: str, begin: Array) -> None:
        self.path, self.task = path, task
        self.own: Array | None = None
        if task != "position" and path.turning is None:
            any_start = np.zeros((1, arm.n))  # where there is none
            turned = [orientation_of(arm, q, path.dimension) for q in (begin if len(begin) else any_start)]
            self.path, self.own = path.holding(turned[0]), np.array(turned)[: len(begin), None]

    def at(self, t: Array) -> tuple[Callable[[int], Array], Array]:
        """A function of the index that gives the targets, and the velocities (k, m)."""
        held, velocity = self.path.sample(t, self.task)
        own = self.own
        if own is None:
            return lambda k: held[k], velocity

        def each(k: int) -> Array:
            found = np.broadcast_to(held[k], (len(own), 1, *held.shape[1:])).copy()
            if own.ndim == 4:
                found[..., :3, :3] = own
            else:
                found[..., -1] = own
            return found

        return each, velocity


Rates = Callable[[Array, int], Step]


def _euler(rates: Rates, q: Array, step: Step, k: int, dt: float) -> Array:
    return np.asarray(q + dt * step.rates)


def _heun(rates: Rates, q: Array, step: Step, k: int, dt: float) -> Array:
    return np.asarray(q + 0.5 * dt * (step.rates + rates(q + dt * step.rates, k + 2).rates))


def _rk4(rates: Rates, q: Array, step: Step, k: int, dt: float) -> Array:
    a = step.rates
    b = rates(q + 0.5 * dt * a, k + 1).rates
    c = rates(q + 0.5 * dt * b, k + 1).rates
    d = rates(q + dt * c, k + 2).rates
    return np.asarray(q + dt / 6.0 * (a + 2.0 * b + 2.0 * c + d))


_SCHEMES = {"euler": _euler, "heun": _heun, "rk4": _rk4}


def _simulated(
    stepper: Stepper, targets: _Targets, begin: Array, count: int, steps: int, dt: float, integrator: str, bound: float
) -> dict[str, Array]:
    """What became of b x g runs."""
    arm = stepper.arm
    held, velocity = targets.at(np.linspace(0.0, targets.path.duration, 2 * steps + 1))
    lower, upper = arm.limits.position.T
    fastest = arm.limits.velocity
    shape = (len(begin), count)
    q = np.broadcast_to(begin[:, None], (*shape, arm.n)).copy()
    least, peak, push, worst = np.full(shape, np.inf), np.zeros(shape), np.zeros(shape), np.zeros(shape)
    before: Array | None = None
    last, turned = np.full(shape, np.nan), np.full(shape, np.nan)
    inside, slow, live, when = *(np.ones(shape, bool) for _ in range(3)), np.full(shape, np.nan)

    def rates(where: Array, k: int) -> Step:
        return stepper(where, held(k), velocity[k], dt)

    scheme = _SCHEMES[integrator]
    with np.errstate(all="ignore"):
        for k in range(steps + 1):
            step = rates(q, 2 * k)
            size = np.abs(step.rates).max(axis=-1, initial=0.0)
            away, turn = errors(arm, stepper.task, step.error)
            distance = np.linalg.norm(away, axis=-1)
            finite = np.isfinite(size) & np.isfinite(distance)
            used = live & finite
            least[used] = np.minimum(least, step.manipulability)[used]
            peak[used] = np.maximum(peak, size)[used]
            worst[used] = np.maximum(worst, distance)[used]
            if before is not None:
                push[used] = np.maximum(push, np.abs(step.rates - before).max(axis=-1, initial=0.0) / dt)[used]
            before = step.rates
            inside &= ((q >= lower) & (q <= upper)).all(axis=-1) | ~live
            slow &= (np.abs(step.rates) <= fastest).all(axis=-1) | ~live
            gone = live & ~(finite & (size <= bound))
            when[gone] = k * dt
            live &= ~gone
            if k == steps:
                last[live], turned[live] = distance[live], np.linalg.norm(turn, axis=-1)[live]
                break
            # runs that are over stay where they are: what is not finite would slow the others down
            q = np.where(live[..., None], scheme(rates, q, step, 2 * k, dt), begin[:, None])
    return {
        "min_manipulability": least,
        "peak_rate": peak,
        "peak_acceleration": push,
        "worst_position_error": worst,
        "final_position_error": last,
        "final_orientation_error": turned,
        "within_position": inside,
        "within_velocity": slow,
        "diverged": ~live,
        "diverged_at": when,
    }


# ---- a start from which it goes ----------------------------------------------------------------------------------


def followable(stepper: Stepper, path: TaskPath, dt: float, count: int = beginnings.STARTS, seed: int = 0) -> Array:
    """The start posture (n,) from which a law follows a path with the largest least manipulability.

    Many postures at the start of the path follow it together, in steps of at least a 150th of its duration; those that
    keep the velocity limits too come before those that would have to be slowed down. Where the path says no
    orientation each posture holds its own.

    Raises:
        InputError: no posture is found at the start, or none of them follows the path inside the position limits.
    """
    arm, task, law = stepper.arm, stepper.task, stepper.law
    assert isinstance(law, Law)
    first = "position" if path.turning is None else task  # each posture holds its own orientation
    held, _ = path.sample([0.0], first)
    q = beginnings.postures_at(arm, first, held[0], count, seed)
    if arm.n - arm.tasks[first] > 1:  # the best that climbing from them finds; with one joint to spare it takes longer
        q = np.vstack([q, beginnings.best(arm, first, held[0], count, seed)])
    steps = min(round(path.duration / dt), max(COARSE, 1))
    coarse = path.duration / steps
    near, turn = (min(k, 1.0 / coarse) for k in law.feedback)
    stepper = Stepper(arm, [replace(law, feedback=(near, turn))], task)
    found = _simulated(stepper, _Targets(arm, path, task, q), q, 1, steps, coarse, "heun", np.pi / coarse)
    good = (~found["diverged"] & found["within_position"])[:, 0]
    if not good.any():
        reason = "inside the position limits" if not found["diverged"].all() else "at all"
        raise InputError(
            f"{arm.name}: none of {len(q)} postures at the start follows the path {reason}; q0, or another law, may"
        )
    slow = good & found["within_velocity"][:, 0]
    return np.asarray(
        q[int(np.argmax(np.where(slow if slow.any() else good, found["min_manipulability"][:, 0], -1.0)))]
    )


# ---- beforehand --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Forecast:
    """What the local law will do on a path, said beforehand from coarse runs with several gains.

    Attributes:
        gains: (g,) tried; the first is the one asked about.
        rate, error: the largest rate (rad/s or m/s) and position error (m) that count as followed.
        batch: the runs.
        follows: (g,) whether a run stays below both.
        text: the answer in a sentence.
    """

    gains: Array
    rate: float
    error: float
    batch: Batch
    follows: Array
    text: str

    @property
    def good(self) -> bool:
        """Whether the gain asked about follows the path."""
        return bool(self.follows[0])

    @property
    def best(self) -> float | None:
        """The gain with the largest least manipulability among those that follow; None where none does."""
        if not self.follows.any():
            return None
        w = np.where(self.follows, self.batch.min_manipulability[0, :, 0], -np.inf)
        return float(self.gains[int(np.argmax(w))])

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "gains": self.gains.tolist(),
            "rate": self.rate,
            "error": self.error,
            "follows": self.follows.tolist(),
            "best": self.best,
            "text": self.text,
            "runs": self.batch.to_dict(),
        }


def forecast(
    arm: Arm,
    path: TaskPath,
    q0: Any,
    gain: float = -2.0,
    *,
    task: str | None = None,
    criterion: str = "H^(-1/2)",
    rate: float = RATE,
    error: float = ERROR,
    dt: float | None = None,
    **options: Any,
) -> Forecast:
    """Whether the local law will follow a path well, and with which gain, from one vectorised run of several gains.

    Args:
        arm: the arm.
        path: the path.
        q0: (n,) the start posture.
        gain: the gain asked about; multiples of it (:data:`TRIED`) are tried too.
        task: what is held.
        criterion: what the gain is of.
        rate: the largest joint rate that counts as followed, rad/s or m/s.
        error: the largest position error that counts as followed, m.
        dt: s; a 300th of the path's duration when absent.
        options: of :func:`track_batch`.

    Raises:
        InputError: as :func:`track_batch`.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> inwards = cr.TaskPath.line((1.7, 0.0), (0.3, 0.0), duration=1.0)
        >>> told = cr.forecast(arm, inwards, cr.best_posture(arm, [1.7, 0.0]).q, 1.0, criterion="H", rate=2.0)
        >>> told.good
        False
    """
    gain = real_number(gain, "gain")
    tried = gain * np.array([1.0, *(share for share in TRIED if share != 1.0)])
    tried = tried[:1] if gain == 0.0 else tried
    q = real_array(q0, "q0")
    if q.shape != (checked_arm(arm).n,):
        raise InputError(f"q0: shape {q.shape}; ({arm.n},) is accepted")
    found = track_batch(arm, path, q, tried, dt, task=task, criterion=criterion, **options)
    most, off = positive(rate, "rate"), positive(error, "error")
    peak, worst, w = (
        getattr(found, name)[0, :, 0] for name in ("peak_rate", "worst_position_error", "min_manipulability")
    )
    follows = ~found.diverged[0, :, 0] & (peak <= most) & (worst <= off)

    def told(k: int) -> str:
        return f"gain {tried[k]:.3g}: rates up to {peak[k]:.3g}, error up to {worst[k]:.2g} m, w down to {w[k]:.3g}"

    answer = "follows" if follows[0] else "does not follow"
    text = f"the local law {answer} this path within rates of {most:g} and {off:g} m ({told(0)})"
    if not follows[0]:
        if follows.any():
            k = int(np.argmax(np.where(follows, w, -np.inf)))
            text += f"; it does with {told(k)}"
        else:
            text += "; nor with any other gain that was tried"
    return Forecast(tried, most, off, found, follows, text)
