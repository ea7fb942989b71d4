"""Following a path inside limits of joint position, velocity and acceleration, exactly and step by step.

The rates of a step of length dt are constant. They have to lie in the box of

- the velocity limits: |rate| <= V;
- the acceleration limits: |rate - rate of the step before| <= A dt;
- the position limits, so that the joint can always still stop: with rate r in this step and the largest deceleration in
  the following ones the joint goes on by dt ((N + 1) r - A dt N (N + 1) / 2), N = floor(r / (A dt)), which must not
  exceed the room left. Solved for r: r <= room / ((N + 1) dt) + A dt N / 2 with N the largest whole number for which
  A dt^2 N (N + 1) / 2 <= room. Without an acceleration limit r <= room / dt.

A box that holds now is never empty in the next step. In it first the largest share of the law's task velocity is
sought, from 0 to 1, then the null motion nearest to the law's: :class:`Program`. Where the law's own rates fit, they
are the solution. The path is run at that share of its speed: it is scaled, never left.

Acceleration limits can make a step impossible at any speed, because the arm should have slowed down before. Then the
run goes back, asks for half of the speed (of the null motion too) from there on, and tries again, over a stretch that
doubles from failure to failure, up to what it takes to stop. If that does not help, the run stops and says why. What
was slowed down in this way is often slower than it need be: the run is then tried again at a half, a quarter, ... of
the speed from its beginning, as long as that can end sooner.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, Limits
from chainrule.errors import InputError
from chainrule.redundancy.asked import Extras
from chainrule.redundancy.measure import END, measured, stretches
from chainrule.redundancy.result import Event, Run, Status
from chainrule.redundancy.stability import feedback_event, gain_event
from chainrule.redundancy.step import Law, Stepper
from chainrule.redundancy.task_path import TaskPath

Array = NDArray[Any]

#: How far a share goes back from the end of its range, relative to it, so that the box is left some width for y.
INSIDE = 1e-7
#: The task velocity must be met to this, and what counts as none, relative to the largest rate of the box.
MET, ROUNDING = 1e-7, 1e-12
#: A run whose speed is on average below this share, over this share of the path's steps (50 at least), has come to a
#: standstill.
STANDS, PATIENCE = 1e-2, 0.5
#: It goes back so often at most, and asks for no less than this share of the speed.
#: Failures in one place at that speed are the end.
RETURNS, SLOWEST, STUCK = 200, 5e-2, 2
#: A stretch asked to be slower begins so many steps before the failure, at first.
BACK = 4
#: A rate this near to its bound (relative to the box) is at it.
AT = 1e-6
#: What happens again after so many samples or fewer is one event.
APART = 10

KINDS = ("velocity", "acceleration", "position")


@dataclass(frozen=True)
class Box:
    """What the limits leave of the rates in one step.

    Attributes:
        low, high: (n,) rad/s or m/s.
        low_kind, high_kind: (n,) indices in :data:`KINDS` of the limit behind each.
    """

    low: Array
    high: Array
    low_kind: Array
    high_kind: Array


def braking(room: Array, most: Array, dt: float) -> Array:
    """The largest rate (n,) after which a joint can still stop within ``room`` (n,).

    Args:
        room: to the limit, rad or m; infinite where there is none.
        most: acceleration limits (n,), infinite where there is none.
        dt: s.

    Example:
        >>> braking(np.array([0.3, 0.3]), np.array([np.inf, 10.0]), 0.1)   # 0.1 * (2 + 1) = 0.3
        array([3., 2.])
    """
    room = np.maximum(room, 0.0)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        unit = most * dt**2
        count = np.floor((np.sqrt(1.0 + 8.0 * room / unit) - 1.0) / 2.0)
        slowing = room / ((count + 1.0) * dt) + most * dt * count / 2.0
    free = ~np.isfinite(room)
    found = np.where(np.isfinite(most), slowing, room / dt)
    return np.where(free, np.inf, found)


def box(limits: Limits, q: Array, before: Array | None, dt: float) -> Box:
    """The box of the rates (n,) at q (n,), after a step at the rates ``before`` (any, where they are None)."""
    velocity, most = limits.velocity, limits.acceleration
    below, above = limits.position.T
    ups = [velocity, braking(above - q, most, dt)]
    downs = [-velocity, -braking(q - below, most, dt)]
    if before is None:
        reach = np.full(len(q), np.inf)
        middle = np.zeros(len(q))
    else:
        reach, middle = most * dt, before
    ups.insert(1, middle + reach)
    downs.insert(1, middle - reach)
    up, down = np.stack(ups), np.stack(downs)
    high_kind, low_kind = up.argmin(axis=0), down.argmax(axis=0)
    high, low = up.min(axis=0), down.max(axis=0)
    return Box(np.minimum(low, high), high, low_kind, high_kind)  # they cross by rounding only


class Program:
    """What a step inside a box is to be, for n joints.

    All rates that do the share s of a task velocity v are s J^+ v + Z y, Z an orthonormal basis of the null space of J.
    The share is the one wanted where the box allows it, else the nearest that it does (a linear program in y and s, by
    HiGHS); y makes the null motion the nearest to the one wanted, in the weights' norm (a quadratic program in the
    joints to spare, by DAQP, a dual active-set method, through CasADi).

    Args:
        weights: (n,); infinite for a joint that stands still.
    """

    def __init__(self, weights: Array) -> None:
        self.still = ~np.isfinite(weights)
        self.weights = np.where(self.still, 1.0, weights)
        self._solvers: dict[int, Any] = {}

    def __call__(
        self, jacobian: Array, velocity: Array, null: Array, room: Box, wanted: float
    ) -> tuple[Array, float] | None:
        """Rates (n,) inside the box, and the share of the velocity (m,) that they do.

        Args:
            jacobian: (m, n).
            velocity: (m,) of the law.
            null: (n,) the null motion that is wanted.
            room: the box.
            wanted: share, 0 to 1.

        Returns:
            None where the box has no rates that do any share.
        """
        low, high = np.where(self.still, 0.0, room.low), np.where(self.still, 0.0, room.high)
        along, basis, possible = _solutions(jacobian, velocity)
        ends = np.abs(np.concatenate([low, high]))
        unit = float(ends[np.isfinite(ends)].max(initial=0.0)) or 1.0
        share = wanted if possible else 0.0
        y = self._nearest(basis, null - share * along, low - share * along, high - share * along, unit)
        if y is None:
            found = _nearest_share(along, basis, low, high, unit, wanted if possible else 0.0, possible)
            if found is None:
                return None
            share, corner = found
            inside = min(share * (1.0 + INSIDE * float(np.sign(share - wanted))), 1.0)
            y = self._nearest(basis, null - inside * along, low - inside * along, high - inside * along, unit)
            share, y = (share, corner) if y is None else (inside, y)
        rates = np.clip(share * along + basis @ y, low, high)
        missed = np.abs(jacobian @ rates - share * velocity).max(initial=0.0)
        return (rates, share) if missed <= MET * unit * max(float(np.abs(jacobian).max()), 1.0) else None

    def _nearest(self, basis: Array, aim: Array, low: Array, high: Array, unit: float) -> Array | None:
        """y (k,) with low <= basis y <= high and basis y nearest to ``aim``, in W; None where there is none."""
        k = basis.shape[1]
        slack = ROUNDING * unit
        if not k:
            return np.zeros(0) if (low <= slack).all() and (high >= -slack).all() else None
        if k not in self._solvers:
            import casadi

            shape = {"h": casadi.Sparsity.dense(k, k), "a": casadi.Sparsity.dense(len(basis), k)}
            self._solvers[k] = casadi.conic("step", "daqp", shape, {"error_on_fail": False})
        solver = self._solvers[k]
        weighted = basis * self.weights[:, None]
        found = solver(h=basis.T @ weighted, g=-(weighted.T @ aim) / unit, a=basis, lba=low / unit, uba=high / unit)
        y = np.asarray(found["x"]).ravel() * unit
        if not solver.stats()["success"] or not np.isfinite(y).all():
            return None
        at = basis @ y
        return y if (at >= low - 1e3 * slack).all() and (at <= high + 1e3 * slack).all() else None


def _solutions(jacobian: Array, velocity: Array) -> tuple[Array, Array, bool]:
    """J^+ v (n,), an orthonormal basis (n, k) of the null space, and whether v is in the range of J."""
    left, values, right = np.linalg.svd(jacobian)
    rank = int((values > ROUNDING * values.max(initial=0.0)).sum())
    parts = left[:, :rank].T @ velocity
    along = right[:rank].T @ (parts / values[:rank])
    missed = np.abs(velocity - left[:, :rank] @ parts).max(initial=0.0)
    return along, right[rank:].T, bool(missed <= 1e-9 * max(float(np.abs(velocity).max(initial=0.0)), 1e-300))


def _nearest_share(
    along: Array, basis: Array, low: Array, high: Array, unit: float, wanted: float, free: bool
) -> tuple[float, Array] | None:
    """The share nearest to the one wanted for which the box has rates, with y (k,) of one of them; None for none."""
    from scipy.optimize import linprog

    k = basis.shape[1]
    matrix = np.column_stack([basis, along / unit, np.zeros(len(along))])
    upper, lower = np.isfinite(high), np.isfinite(low)
    away = np.zeros((2, k + 2))
    away[:, k:] = [[1.0, -1.0], [-1.0, -1.0]]  # the last unknown is |share - wanted|
    found = linprog(
        np.append(np.zeros(k + 1), 1.0),
        A_ub=np.vstack([matrix[upper], -matrix[lower], away]),
        b_ub=np.concatenate([high[upper] / unit, -low[lower] / unit, [wanted, -wanted]]),
        bounds=[(None, None)] * k + [(0.0, 1.0 if free else 0.0), (0.0, None)],
        method="highs",
    )
    return (float(np.clip(found.x[k], 0.0, 1.0)), found.x[:k] * unit) if found.status == 0 else None


@dataclass
class _Log:
    """What was done so far; going back drops its end."""

    along: list[float] = field(default_factory=list)  # the path's own time
    q: list[Array] = field(default_factory=list)
    rates: list[Array] = field(default_factory=list)
    share: list[float] = field(default_factory=list)
    touched: list[tuple[tuple[int, str], ...]] = field(default_factory=list)
    returns: int = 0  # how often the run went back

    def back_to(self, count: int) -> tuple[float, Array]:
        """Drop all but ``count`` steps; the path time and posture before the first step dropped."""
        when, q = self.along[count], self.q[count]
        for part in (self.along, self.q, self.rates, self.share, self.touched):
            del part[count:]
        return when, q


def follow_limited(
    stepper: Stepper,
    path: TaskPath,
    q0: Array,
    dt: float,
    method: str,
    extras: Extras,
    bound: float,
    options: dict[str, Any],
) -> Run:
    """Follow a path inside the arm's limits; see :func:`chainrule.track`.

    Raises:
        InputError: a start outside the position limits; a limit of velocity or acceleration of 0.
    """
    arm, law = stepper.arm, stepper.law
    assert isinstance(law, Law)
    _check_start(arm, q0)
    for what in ("velocity", "acceleration"):
        still = [name for name, most in zip(arm.joint_names, getattr(arm.limits, what), strict=True) if most == 0.0]
        if still:
            raise InputError(f"{arm.name}: the {what} limit of {', '.join(still)} is 0; a positive one is accepted")
    log, status, reason = _quickest(stepper, path, q0, dt, extras, bound)
    along, q = np.array(log.along), np.array(log.q)
    rates, share = np.array(log.rates), np.array(log.share)
    t = dt * np.arange(len(along))
    if status == "complete":  # the last step ends where the path does
        t[-1] = t[-2] + (along[-1] - along[-2]) / share[-2]
    held, velocity = path.sample(along, stepper.task)
    step = stepper(q, held, velocity, dt, **extras.at(t, q))
    return measured(
        arm,
        stepper.task,
        method=method,
        law=law,
        integrator="euler",
        dt=dt,
        t=t,
        q=q,
        held=held,
        velocity=velocity,
        rates=rates,
        accelerations=_accelerations(arm.limits, rates, dt),
        scale=share,
        step=step,
        events=[
            *_scaled_events(t, share),
            *_limit_events(arm, t, log.touched),
            *gain_event(stepper, "euler", dt, t, q, held),
            *feedback_event(law, "euler", dt),
        ],
        status=status,
        reason=reason,
        **options,
    )


def _check_start(arm: Arm, q: Array) -> None:
    low, high = arm.limits.position.T
    outside = np.flatnonzero((q < low) | (q > high))
    if len(outside):
        j = int(outside[0])
        raise InputError(
            f"q0, joint '{arm.joint_names[j]}': {q[j]:.6g} is outside its limits {low[j]:.6g} to {high[j]:.6g}; a "
            "start inside them is accepted"
        )


def _accelerations(limits: Limits, rates: Array, dt: float) -> Array:
    """The change of the rates from the step before, over dt; from rest at the start where accelerations are limited."""
    before = np.zeros_like(rates[:1]) if np.isfinite(limits.acceleration).any() else rates[:1]
    return np.asarray(np.diff(rates, axis=0, prepend=before) / dt)


def _quickest(
    stepper: Stepper, path: TaskPath, q0: Array, dt: float, extras: Extras, bound: float
) -> tuple[_Log, Status, str]:
    """The run, and where it had to go back those that are slower from the beginning: of all the one that ends first."""
    steps, most = round(path.duration / dt), 1.0
    best = _run(stepper, path, q0, dt, extras, bound, most)
    found = best
    while found[0].returns and most > 2.0 * SLOWEST:
        complete = best[1] == "complete"
        if found[0].returns <= RETURNS and (not complete or len(best[0].q) * most / 2.0 <= steps):
            break
        most *= 0.5
        found = _run(stepper, path, q0, dt, extras, bound, most)
        if found[1] == "complete" and (not complete or len(found[0].q) < len(best[0].q)):
            best = found
    return best


def _run(
    stepper: Stepper, path: TaskPath, q0: Array, dt: float, extras: Extras, bound: float, most: float
) -> tuple[_Log, Status, str]:
    arm, task = stepper.arm, stepper.task
    law = stepper.law
    assert isinstance(law, Law)
    limits, end = arm.limits, path.duration
    rest = np.zeros(arm.n) if np.isfinite(limits.acceleration).any() else None
    program = Program(np.array(law.weights or np.ones(arm.n)))
    steps = round(end / dt)
    caps = np.full(steps + 1, most)
    log, when, q = _Log(), 0.0, q0
    patience = max(int(PATIENCE * steps), 50)
    back, failed_at, stuck = BACK, -1.0, 0
    while True:
        held, velocity = path.sample([when], task)
        t = len(log.q) * dt
        step = stepper(q, held[0], velocity[0], dt, **({} if extras == Extras() else extras.now(t, q)))
        if not np.isfinite(step.rates).all():
            return _ended(log, when, q, "stopped", f"at {t:.4g} s the law gave a number that is not finite")
        room = box(limits, q, log.rates[-1] if log.rates else rest, dt)
        bin_now = min(int(when / dt + 1e-9), steps)
        found = _one(
            program, arm, task, q, step.rates, step.null_motion, room, float(caps[bin_now : bin_now + 2].min())
        )
        if found is None:
            log.returns += 1
            stuck = stuck + 1 if abs(when - failed_at) < dt and caps[bin_now] <= SLOWEST else 0
            if log.returns > RETURNS or stuck > STUCK or not log.q:
                return _ended(log, when, q, "stopped", _why(arm, t, q, step.manipulability, room))
            back = min(2 * back, longest(limits, log.rates, dt)) if abs(when - failed_at) <= 2 * back * dt else BACK
            failed_at = when
            count = int(np.searchsorted(np.array(log.along), when - back * dt))
            when, q = log.back_to(min(count, len(log.q) - 1))
            first = min(int(when / dt), steps)
            caps[first : bin_now + 2] = np.maximum(0.5 * caps[first : bin_now + 2], SLOWEST)
            continue
        rates, share = found
        if np.abs(rates).max() > bound:
            j = int(np.abs(rates).argmax())
            text = f"joint '{arm.joint_names[j]}' would move at {abs(rates[j]):.4g}, above the bound of {bound:.4g}"
            return _ended(log, when, q, "stopped", f"at {t:.4g} s {text}")
        left = (end - when) / dt
        log.along.append(when)
        log.q.append(q)
        log.rates.append(rates)
        log.share.append(share)
        log.touched.append(_touched(rates, room))
        if len(log.q) > patience and when - log.along[-patience] < STANDS * patience * dt:
            return _ended(log, when, q, "stopped", _why(arm, t, q, step.manipulability, room))
        if share > 0.0 and share >= left * (1.0 - 1e-12):
            ending = q + left / share * dt * rates
            return _ended(log, end, ending, "complete", END)
        when, q = when + share * dt, q + dt * rates


def longest(limits: Limits, rates: list[Array], dt: float) -> int:
    """How many steps the joints need at most to stop from the largest rates met so far; :data:`BACK` at least."""
    fastest = np.abs(np.array(rates)).max(axis=0)
    return max(int(np.ceil((fastest / limits.acceleration).max() / dt)), BACK)


def _one(
    program: Program, arm: Arm, task: str, q: Array, rates: Array, null: Array, room: Box, wanted: float
) -> tuple[Array, float] | None:
    """The rates of one step and the share of the path speed; None where the limits leave none."""
    if wanted == 1.0 and (rates >= room.low).all() and (rates <= room.high).all():
        return rates, 1.0
    jacobian = arm.jacobian(q, task=task)
    return program(jacobian, jacobian @ (rates - null), wanted * null, room, wanted)


def _ended(log: _Log, when: float, q: Array, status: Status, reason: str) -> tuple[_Log, Status, str]:
    """The log with a last sample, at which the last rates still hold."""
    rates = log.rates[-1] if log.rates else np.zeros_like(q)
    log.along.append(when)
    log.q.append(q)
    log.rates.append(rates)
    log.share.append(log.share[-1] if log.share else 0.0)
    log.touched.append(())
    return log, status, reason


def _touched(rates: Array, room: Box) -> tuple[tuple[int, str], ...]:
    """The joints at a bound of the box, and of which limit."""
    with np.errstate(invalid="ignore"):
        margin = AT * np.maximum(np.abs(rates), 1e-9)
        at_high, at_low = rates >= room.high - margin, rates <= room.low + margin
    found = [(int(j), KINDS[int(room.high_kind[j])]) for j in np.flatnonzero(at_high)]
    return tuple(found + [(int(j), KINDS[int(room.low_kind[j])]) for j in np.flatnonzero(at_low & ~at_high)])


def _why(arm: Arm, t: float, q: Array, w: Any, room: Box) -> str:
    """The reason of a standstill: the joints at their position limits, or the one with the least room."""
    low, high = arm.limits.position.T
    with np.errstate(invalid="ignore"):
        margin = 1e-6 * np.maximum(1.0, np.abs(q))
        at = np.flatnonzero((q <= low + margin) | (q >= high - margin))
    if len(at):
        names = ", ".join(f"'{arm.joint_names[j]}'" for j in at)
        cause = f"at its position limit is joint {names}"
    else:
        width = room.high - room.low
        tight = int(np.argmin(np.where(np.isfinite(width), width, np.inf)))
        kinds = sorted({KINDS[int(room.low_kind[tight])], KINDS[int(room.high_kind[tight])]})
        cause = f"least room has joint '{arm.joint_names[tight]}' ({', '.join(kinds)})"
    return f"at {t:.4g} s the limits leave no motion along the path to speak of: {cause}; w is {float(w):.3g}"


def _scaled_events(t: Array, share: Array) -> list[Event]:
    """One event for every stretch that is run more slowly."""
    return [
        Event(
            float(t[first]),
            "task scaled",
            f"the path is run at {100.0 * share[first : last + 1].min():.3g} % of its speed until {t[last + 1]:.4g} s",
        )
        for first, last in _joined(share[:-1] < 1.0 - 1e-9)
    ]


def _limit_events(arm: Arm, t: Array, touched: list[tuple[tuple[int, str], ...]]) -> list[Event]:
    """One event for every stretch in which a joint is at a limit."""
    found = []
    for joint, kind in sorted({pair for pairs in touched for pair in pairs}):
        mask = np.array([(joint, kind) in pairs for pairs in touched])
        for first, last in _joined(mask):
            found.append(
                Event(
                    float(t[first]),
                    "limit met",
                    f"joint '{arm.joint_names[joint]}' is at its {kind} limit until {t[last + 1]:.4g} s",
                )
            )
    return found


def _joined(mask: Array) -> list[tuple[int, int]]:
    """First and last index of every run of true entries, those less than :data:`APART` apart as one."""
    found: list[tuple[int, int]] = []
    for first, last in stretches(mask):
        if found and first - found[-1][1] <= APART:
            found[-1] = (found[-1][0], last)
        else:
            found.append((first, last))
    return found
