"""Following a path with one arm: the local law, integrated in time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array, whole_number
from chainrule.paths import real_number
from chainrule.redundancy import starts
from chainrule.redundancy.asked import (
    Extras,
    Push,
    Secondary,
    both,
    check_criterion,
    check_dimension,
    gains,
    number_of_steps,
    orientation_of,
)
from chainrule.redundancy.batch import followable
from chainrule.redundancy.measure import END, NEAR, measured
from chainrule.redundancy.result import Event, Run, Status
from chainrule.redundancy.stability import feedback_event, gain_event
from chainrule.redundancy.step import Damping, Law, Step, Stepper
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.time_laws import positive

Array = NDArray[Any]
Method = Literal["gradient_projection", "pseudoinverse", "priority"]
Integrator = Literal["euler", "heun", "rk4", "dop853"]

METHODS = ("gradient_projection", "pseudoinverse", "priority")
INTEGRATORS = ("euler", "heun", "rk4", "dop853")

#: A start posture may miss the first target by this (m, rad), where no feedback would bring it there.
MISSED = 1e-6
#: Relative and absolute tolerance (rad, m) of the adaptive integrator, and its most steps.
TOLERANCES, MOST_STEPS = (1e-10, 1e-12), 20_000


def track(
    arm: Arm,
    path: TaskPath,
    q0: Any = None,
    *,
    task: str | None = None,
    method: Method = "gradient_projection",
    gain: float | Mapping[str, float] | None = None,
    criterion: str = "H^(-1/2)",
    integrator: Integrator = "euler",
    dt: float | None = None,
    feedback: float | Sequence[float] | None = None,
    damping: Damping | None = None,
    weights: Any = None,
    push: Push | None = None,
    secondary: Secondary | None = None,
    limits: bool = False,
    stop_rate: float | None = None,
    near: float = NEAR,
    seed: int = 0,
    gravity: Any = None,
    wrench: Any = None,
) -> Run:
    """Follow a path with the local law of gradient projection, damped or not, with or without limits.

    rates = J* (velocity - K error) + (I - J+ J) (gain grad criterion + push), integrated in time.

    Args:
        arm: an arm with no fewer joints than its task has rows.
        path: where the tip is to be.
        q0: (n,) the start posture, rad or m; or "best", the posture of largest manipulability found at the start; or
            "followable" (also when absent): of many postures there the one from which the path can be followed with
            the largest least manipulability, by a run of all of them together; where the path says no orientation
            each of them holds its own.
        task: what is held; the arm's default task when absent.
        method: "gradient_projection"; "pseudoinverse", the same without null-space motion; "priority", with a secondary
            task.
        gain: of the criterion, negative for 1/H and H^(-1/2), which it lowers; or gains by criterion. When absent -2,
            and 2 for H.
        criterion: "H", "1/H", "H^(-1/2)" or "limits"; see :class:`chainrule.redundancy.step.Law`.
        integrator: "euler" (the thesis), "heun" or "rk4" with steps of dt; "dop853", adaptive, sampled at dt.
        dt: s; the path's duration is divided into the nearest whole number of them, a million at most. A 300th of it
            when absent.
        feedback: 1/s, of the position and orientation error, or one each; when absent half of an error goes in a step.
        damping: of the task near singularities.
        weights: (n,) of the joints: what a joint's motion costs.
        push: function of t and q (n,) that gives a vector (n,), projected like the gradient and added to it.
        secondary: for "priority": function of t and q (n,) that gives a Jacobian (k, n) and velocity (k,).
        limits: keep the arm's limits of position, velocity and acceleration; where the path leaves no other way it is
            run more slowly (see :mod:`.limited`). With "euler" only: the rates are constant in every step.
        stop_rate: rad/s or m/s; a rate beyond it ends the run. When absent half a turn per step, pi / dt.
        near: share of the largest manipulability so far below which a singularity is near.
        seed: of the search for a start.
        gravity: for the torques, as in ``Arm.inverse_dynamics``.
        wrench: likewise.

    Raises:
        InputError: anything that is not accepted, in one line.

    Source: Sanchez, thesis on singularity avoidance of an 8R arm, (4.11).

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> path = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
        >>> run = cr.track(arm, path, "best", gain=0.5, criterion="H", dt=0.01)
        >>> run.status, len(run.t), run.worst_position_error < 1e-3
        ('complete', 101, True)
    """
    if not isinstance(path, TaskPath):
        raise InputError(f"path: {shown(path)}; a TaskPath is accepted, such as TaskPath.line gives")
    task = checked_arm(arm).task_of_full_rank(task)
    if integrator not in INTEGRATORS:
        raise InputError(f"integrator: {shown(integrator)}; {', '.join(INTEGRATORS)} are accepted")
    _check_method(method, gain, secondary)
    steps = number_of_steps(path, dt)
    dt = path.duration / steps
    law = _law(method, gain, criterion, feedback, damping, weights, dt)
    check_criterion(arm, [name for name, value in law.gains.items() if value])
    stepper = Stepper(arm, law, task)
    path, q = begin(stepper, path, q0, dt, seed)
    bound = np.pi / dt if stop_rate is None else positive(stop_rate, "stop_rate")
    for name, function in (("push", push), ("secondary", secondary)):
        if function is not None and not callable(function):
            raise InputError(f"{name}: {shown(function)}; a function of t and q is accepted")
    extras = Extras(push, secondary)
    near = real_number(near, "near")
    if not 0.0 <= near <= 1.0:
        raise InputError(f"near: {near:g}; a share from 0 to 1 is accepted")
    options: dict[str, Any] = {"near": near, "gravity": gravity, "wrench": wrench}
    if limits:
        from chainrule.redundancy.limited import follow_limited

        if integrator != "euler":
            raise InputError(
                f"integrator: {shown(integrator)}; with limits 'euler' is accepted, whose rates are constant"
            )
        return follow_limited(stepper, path, q, dt, method, extras, bound, options)
    t = np.linspace(0.0, path.duration, steps + 1)
    problem = _Problem(stepper, path, task, extras, dt)
    with np.errstate(all="ignore"):  # a run that diverges is cut off below
        q, halted = _INTEGRATE[integrator](problem, t, q)
    t = t[: len(q)]
    held, velocity = path.sample(t, task)
    with np.errstate(all="ignore"):
        step = stepper(q, held, velocity, dt, **extras.at(t, q))
    kept, events, reason = _cut(arm, t, q, step, bound, halted)
    if kept < len(t):
        t, q, held, velocity, step = t[:kept], q[:kept], held[:kept], velocity[:kept], first(step, kept)
    unstable = gain_event(stepper, integrator, dt, t, q, held) + feedback_event(law, integrator, dt)
    if reason and unstable:
        reason += f"; {unstable[-1].kind} from {unstable[-1].t:.4g} s on"
    status: Status = "stopped" if reason else "complete"
    return measured(
        arm,
        task,
        method=method,
        law=law,
        integrator=integrator,
        dt=dt,
        t=t,
        q=q,
        held=held,
        velocity=velocity,
        step=step,
        events=unstable + events,
        status=status,
        reason=reason or END,
        **options,
    )


# ---- what was asked ----------------------------------------------------------------------------------------------


def _check_method(method: str, gain: Any, secondary: Any) -> None:
    if method not in METHODS:
        raise InputError(f"method: {shown(method)}; {', '.join(METHODS)} are accepted")
    if method == "pseudoinverse" and gain is not None:
        raise InputError("gain: 'pseudoinverse' has no null-space motion; 'gradient_projection' takes one")
    if (method == "priority") != (secondary is not None):
        raise InputError("secondary: 'priority' takes a secondary task, and no other method does")


def _law(
    method: str, gain: Any, criterion: str, feedback: Any, damping: Damping | None, weights: Any, dt: float
) -> Law:
    return Law(
        {} if method == "pseudoinverse" else gains(gain, criterion),
        both(feedback, dt),
        Damping() if damping is None else damping,
        None if weights is None else tuple(real_array(weights, "weights", finite=False).tolist()),
    )


def begin(stepper: Stepper, path: TaskPath, q0: Any, dt: float, seed: int) -> tuple[TaskPath, Array]:
    """The path with its orientation, and the start posture (n,).

    Raises:
        InputError: a posture that is not accepted, or not at the start of the path; none to be found.
    """
    arm, task, law = stepper.arm, stepper.task, stepper.law
    assert isinstance(law, Law)
    named = q0 is None or isinstance(q0, str)
    turns = task != "position"
    if named and q0 not in (None, "best", "followable"):
        raise InputError(f"q0: {shown(q0)}; joint values, 'best' or 'followable' are accepted")
    if not named:
        q = real_array(q0, "q0")
        if q.shape != (arm.n,):
            raise InputError(f"q0: shape {q.shape}; ({arm.n},), one value for each joint of {arm.name}, is accepted")
        if turns and path.turning is None:
            path = path.holding(orientation_of(arm, q, path.dimension))
    check_dimension(arm, path)
    if named and q0 != "best":
        q = followable(stepper, path, dt, seed=whole_number(seed, "seed", 0))
        own = turns and path.turning is None  # the posture's own orientation
        return path.holding(orientation_of(arm, q, path.dimension)) if own else path, q
    held, _ = path.sample([0.0], task)
    if named:
        return path, starts.best(arm, task, held[0], seed=whole_number(seed, "seed", 0))
    missed = np.abs(stepper(q[None], held, None, dt).error)
    if missed.max(initial=0.0) > MISSED and min(law.feedback) == 0.0:
        raise InputError(
            f"q0: its tip misses the start of the path by {missed.max():.3g} (m, rad), and there is no feedback; a "
            "posture at the start is accepted"
        )
    return path, q


# ---- integration -------------------------------------------------------------------------------------------------


class _Problem:
    """The law as a function of time and configuration.

    Attributes:
        stepper, path, task, extras, dt: what it is made of.
    """

    def __init__(self, stepper: Stepper, path: TaskPath, task: str, extras: Extras, dt: float) -> None:
        self.stepper, self.path, self.task, self.extras, self.dt = stepper, path, task, extras, dt
        self.plain = extras.push is None and extras.secondary is None

    def rates(self, t: float, q: Array, held: Array, velocity: Array) -> Array:
        """The law's rates (n,) for a target."""
        more = {} if self.plain else self.extras.now(t, q)
        return self.stepper(q, held, velocity, self.dt, **more).rates

    def ticks(self, t: Array, halves: bool) -> tuple[list[Any], list[Any]]:
        """Targets and velocities at the times t (k,), and with ``halves`` between them too."""
        times = np.interp(np.arange(2 * len(t) - 1) / 2.0, np.arange(len(t)), t) if halves else t
        held, velocity = self.path.sample(times, self.task)
        return list(held), list(velocity)


def _euler(problem: _Problem, t: Array, start: Array) -> tuple[Array, str]:
    held, velocity = problem.ticks(t, False)
    q = np.empty((len(t), len(start)))
    now = q[0] = start
    for k in range(len(t) - 1):
        now = q[k + 1] = now + problem.dt * problem.rates(float(t[k]), now, held[k], velocity[k])
    return q, ""


def _heun(problem: _Problem, t: Array, start: Array) -> tuple[Array, str]:
    held, velocity = problem.ticks(t, False)
    q, dt = np.empty((len(t), len(start))), problem.dt
    now = q[0] = start
    for k in range(len(t) - 1):
        first = problem.rates(float(t[k]), now, held[k], velocity[k])
        second = problem.rates(float(t[k + 1]), now + dt * first, held[k + 1], velocity[k + 1])
        now = q[k + 1] = now + 0.5 * dt * (first + second)
    return q, ""


def _rk4(problem: _Problem, t: Array, start: Array) -> tuple[Array, str]:
    held, velocity = problem.ticks(t, True)
    q, dt = np.empty((len(t), len(start))), problem.dt
    now = q[0] = start
    for k in range(len(t) - 1):
        begin, middle, end = (float(t[k] + share * dt) for share in (0.0, 0.5, 1.0))
        a = problem.rates(begin, now, held[2 * k], velocity[2 * k])
        b = problem.rates(middle, now + 0.5 * dt * a, held[2 * k + 1], velocity[2 * k + 1])
        c = problem.rates(middle, now + 0.5 * dt * b, held[2 * k + 1], velocity[2 * k + 1])
        d = problem.rates(end, now + dt * c, held[2 * k + 2], velocity[2 * k + 2])
        now = q[k + 1] = now + dt / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    return q, ""


class _NotFinite(Exception):
    """The law gave a number that is not finite."""


def _dop853(problem: _Problem, t: Array, start: Array) -> tuple[Array, str]:
    from scipy.integrate import DOP853

    def slope(when: float, where: Array) -> Array:
        held, velocity = problem.path.sample([min(max(when, 0.0), float(t[-1]))], problem.task)
        found = problem.rates(when, where, held[0], velocity[0])
        if not np.isfinite(found).all():
            raise _NotFinite
        return found

    q = [start]
    try:
        solver = DOP853(slope, 0.0, start, float(t[-1]), rtol=TOLERANCES[0], atol=TOLERANCES[1])
        for _ in range(MOST_STEPS):
            solver.step()
            if solver.status == "failed":
                return np.array(q), "the integrator needs steps below rounding"
            passed = t[len(q) :]
            passed = passed[passed <= solver.t]
            if len(passed):
                q.extend(solver.dense_output()(passed).T)
            if solver.status == "finished":
                q[-1] = solver.y
                return np.array(q), ""
    except _NotFinite:
        return np.array(q), "the law gave a number that is not finite"
    return np.array(q), f"the integrator has taken {MOST_STEPS} steps"


_INTEGRATE: dict[str, Callable[[_Problem, Array, Array], tuple[Array, str]]] = {
    "euler": _euler,
    "heun": _heun,
    "rk4": _rk4,
    "dop853": _dop853,
}


# ---- how it ended ------------------------------------------------------------------------------------------------


def first(step: Step, count: int) -> Step:
    """The first ``count`` samples of a batch of steps."""
    return Step(*(getattr(step, name)[:count] for name in Step.__dataclass_fields__))


def _cut(arm: Arm, t: Array, q: Array, step: Step, bound: float, halted: str) -> tuple[int, list[Event], str]:
    """How many samples are kept, what happened, and the reason if the run stops before the end."""
    finite = np.asarray(np.isfinite(q).all(axis=1) & np.isfinite(step.rates).all(axis=1))
    with np.errstate(invalid="ignore"):
        fast = np.asarray(np.abs(step.rates).max(axis=1) > bound)
    bad = np.flatnonzero(~finite | fast)
    if len(bad):
        k = int(bad[0])
        if finite[k]:
            joint = int(np.abs(step.rates[k]).argmax())
            text = (
                f"joint '{arm.joint_names[joint]}' would move at {abs(step.rates[k, joint]):.4g} "
                f"{'rad/s' if arm.kinds[joint] == 'R' else 'm/s'}, above the bound of {bound:.4g}"
            )
            kind, kept = "rates too large", k + 1
        else:
            text, kind, kept = "the law gave a number that is not finite", "not finite", k
        event = Event(float(t[min(k, len(t) - 1)]), kind, text)
        return max(kept, 1), [event], f"at {event.t:.4g} s {text}"
    if halted:
        event = Event(float(t[-1]), "not finite" if "finite" in halted else "rates too large", halted)
        return len(t), [event], f"at {event.t:.4g} s {halted}"
    return len(t), [], ""
