"""A whole path at once: of all joint motions that hold the task, one that is locally the best.

A local law decides at each instant; led into a singularity, it is too late. Here the postures at all samples are
unknown together (:mod:`.optimum`), and IPOPT looks for a local optimum from each of several starts: the joint motions
of local laws, and of local laws pushed along the self-motion. Each start is solved on a coarse mesh; the best of them
is interpolated, brought back onto the targets by Newton's method, and solved again at every sample.

What is found is a local optimum to first order. No statement about all joint motions is made.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, Limits, checked_arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array, whole_number
from chainrule.paths import real_number
from chainrule.redundancy import starts as beginnings
from chainrule.redundancy.asked import check_dimension, number_of_steps, orientation_of
from chainrule.redundancy.measure import errors, measured
from chainrule.redundancy.optimum import Aim, Optimality, Problem, Stage, solve
from chainrule.redundancy.result import Run
from chainrule.redundancy.step import Law, Stepper
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.time_laws import positive

Array = NDArray[Any]
Progress = Callable[[str], None]
Criterion = Literal["H", "1/H", "H^(-1/2)"]

#: Intervals of the coarse mesh.
COARSE = 60
#: Without a bound given, rates may be this many times those of the smoothest path found.
GUARD = 2.0
#: Values that differ by this share count as the same.
SAME = 1e-3
#: Postures closer than this (rad or m) are the same path.
CLOSE = 1e-2
#: How many of the best coarse paths are tried at every sample, one after the other, until one is solved.
TRIED = 3
#: How far a start or the end of a closed path may miss its target (m, rad).
MISSED = 1e-6
#: Shares of the way uphill of the local starts in one coarse step, and the push of the others along the self-motion
#: over the whole path (rad or m).
UPHILL, PUSH = (0.0, 0.01, 0.05), 4.0
#: Corrections of a posture of a local start, and the largest change of a joint in one (rad or m).
CORRECTIONS, STRIDE = 4, 0.3


@dataclass(frozen=True)
class Between:
    """What happens between the samples, where the joints move at constant rates from one to the next.

    Looked at in the quarters of every interval.

    Attributes:
        position: the largest distance from the path, m.
        orientation: the largest angle from the path's orientation, rad.
        manipulability: the smallest w.
    """

    position: float
    orientation: float
    manipulability: float

    def to_dict(self) -> dict[str, float]:
        """Plain values."""
        return {"position": self.position, "orientation": self.orientation, "manipulability": self.manipulability}


@dataclass(frozen=True)
class GlobalRun:
    """A locally optimal joint motion, and how far that claim goes.

    Attributes:
        run: the motion, with rates (q_{i+1} - q_i) / (t_{i+1} - t_i), the last one twice.
        objective: what was optimised.
        value: of the objective: the least w, the integral of the criterion, of the squared rates or accelerations, or
            the peak rate.
        solutions: IPOPT's last solutions at every sample, in order: of the objective and, for "max min w", of the least
            peak rate among paths as good, and of the least squared accelerations among those.
        values: of the objective for each start, on the coarse mesh; nan where none was found.
        agreed: how many of them came within 0.1 % of the best of them.
        bound: (n,) the rates that were allowed, beside the limits; infinite where any were.
        ceiling: for "max min w": the largest w met among postures at the target where the path has its least, the whole
            self-motion where one joint is to spare, else many postures climbing; no path has a larger least w than the
            largest w at any one of its targets. None for other objectives.
        between: what happens between the samples; None where the path is not known there.
        interrupted: whether Ctrl-C ended the search.
        text: all this in a sentence.
    """

    run: Run
    objective: str
    value: float
    solutions: tuple[Optimality, ...]
    values: Array
    agreed: int
    bound: Array
    ceiling: float | None
    between: Between | None
    interrupted: bool
    text: str

    @property
    def q(self) -> Array:
        """(k, n) the postures."""
        return self.run.q

    @property
    def solved(self) -> bool:
        """Whether IPOPT calls the motion a local optimum."""
        return bool(self.solutions) and all(each.solved for each in self.solutions) and not self.interrupted

    def to_dict(self) -> dict[str, Any]:
        """Plain values; what is not a finite number is None."""
        return {
            "objective": self.objective,
            "value": self.value,
            "solved": self.solved,
            "interrupted": self.interrupted,
            "solutions": [each.to_dict() for each in self.solutions],
            "values": [float(v) if np.isfinite(v) else None for v in self.values],
            "agreed": self.agreed,
            "bound": [float(v) if np.isfinite(v) else None for v in self.bound],
            "ceiling": self.ceiling,
            "between": None if self.between is None else self.between.to_dict(),
            "text": self.text,
            "run": self.run.to_dict(),
        }


def track_globally(
    arm: Arm,
    path: TaskPath | Any,
    q_start: Any = None,
    t: Any = None,
    *,
    task: str | None = None,
    objective: Stage = "max min w",
    criterion: Criterion = "H^(-1/2)",
    dt: float | None = None,
    limits: bool = True,
    cyclic: bool = False,
    fixed_start: bool = True,
    slack: float = 1e-3,
    most_rate: float | None = None,
    count: int = 12,
    seed: int = 0,
    gravity: Any = None,
    wrench: Any = None,
    progress: Progress = lambda line: None,
) -> GlobalRun:
    """A locally optimal joint motion along a path: all its postures at once, by CasADi and IPOPT from several starts.

    Args:
        arm: an arm with no fewer joints than its task has rows.
        path: a :class:`TaskPath`; or targets (k, ...), one for each time: poses (k, 4, 4), positions (k, 3), planar
            (k, 2) or (k, 3).
        q_start: (n,) the start posture; or local solutions (k, n) or (s, k, n) at the times, which the search starts
            from too; when absent the posture of largest w found at the first target.
        t: (k,) rising times, s; with a :class:`TaskPath` they may be left out.
        task: what is held; the arm's default task when absent.
        objective: "max min w": the largest least w = sqrt(det J J^T) over the samples but a fixed start, among paths as
            good the least peak rate, and among those the least integral of |q''|^2; "integral of criterion": over time,
            H raised, 1/H and H^(-1/2) lowered; "squared rates" and "squared accelerations": the least integral of
            |q'|^2 or |q''|^2; "peak rate": the least largest |q'_j|. The first, second and fourth hold a share of 0.001
            of squared rates: the motion is smooth where the objective leaves it open.
        criterion: of the integral.
        dt: s, with a :class:`TaskPath` and no times; a 300th of the duration when absent.
        limits: whether the arm's limits of position, velocity and acceleration hold, for the differences above.
        cyclic: end in the posture of the start, revolute joints as many whole turns on as each start ends nearest to.
        fixed_start: keep the start posture; else it may move along its self-motion too.
        slack: the share of the largest least w that is given away for a lower peak rate, and of that peak rate for
            smaller accelerations; 0 for none.
        most_rate: rad/s or m/s, allowed beside the limits; when absent twice the peak rate of the smoothest path found,
            apart for revolute and prismatic joints, so that no path jumps between samples. (The objectives of rates
            and accelerations have none.)
        count: of starts that are made here.
        seed: of their pushes along the self-motion.
        gravity: for the torques, as in ``Arm.inverse_dynamics``.
        wrench: likewise.
        progress: called with a line for each step. Ctrl-C ends the search with the best path so far, if there is one.

    Raises:
        InputError: anything that is not accepted, in one line; a start that is not at the first target; no start that
            leads to a path holding every target within the limits.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> path = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
        >>> found = cr.track_globally(arm, path, dt=0.05, count=2, fixed_start=False)
        >>> found.solved, found.run.worst_position_error < 1e-8
        (True, True)
    """
    task = checked_arm(arm).task_of_full_rank(task)
    if objective not in get_args(Stage):
        raise InputError(f"objective: {shown(objective)}; {', '.join(get_args(Stage))} are accepted")
    if criterion not in get_args(Criterion):
        raise InputError(f"criterion: {shown(criterion)}; {', '.join(get_args(Criterion))} are accepted")
    slack = real_number(slack, "slack")
    if not 0.0 <= slack < 1.0:
        raise InputError(f"slack: {slack:g}; a share from 0 up to 1 is accepted")
    bound = np.full(arm.n, np.inf if most_rate is None else positive(most_rate, "most_rate"))
    given = None if q_start is None else _given(arm, q_start)
    count = whole_number(count, "count", 0 if given is not None and given.shape[1] > 1 else 1)
    if isinstance(path, TaskPath):
        if task != "position" and path.turning is None and given is not None:
            path = path.holding(orientation_of(arm, given[0, 0], path.dimension))
        check_dimension(arm, path)
        steps = number_of_steps(path, dt)
        times = np.linspace(0.0, path.duration, steps + 1) if t is None else _times(t)
        held = path.sample(times, task).held
    else:
        if t is None or dt is not None:
            raise InputError("t: targets in samples come with their times (k,), and with no dt")
        times, held = _times(t), real_array(path, "path")
        wanted = _target_shape(arm, task)
        if held.shape != (len(times), *wanted):
            raise InputError(f"path: shape {held.shape}; {(len(times), *wanted)}, a target for each time, is accepted")
    if given is None:
        given = beginnings.best(arm, task, held[0], seed=seed)[None, None]
    flat = held.reshape(len(times), -1)
    if cyclic and np.abs(held[-1] - held[0]).max() > MISSED:
        raise InputError("cyclic: the path does not end where it begins; a closed one is accepted")
    kept = arm.limits if limits else _unlimited(arm.n)
    problem = Problem(arm, task, times, flat, kept, fixed_start, None)
    search = _Search(problem, held, objective, criterion, slack, bound, most_rate is None, cyclic, progress)
    search.check(given)
    search.run(given, count, seed)
    return search.result(path if isinstance(path, TaskPath) else None, gravity, wrench)


# ---- what was asked ----------------------------------------------------------------------------------------------


def _given(arm: Arm, q_start: Any) -> Array:
    """Local solutions (s, k, n); of a posture (1, 1, n)."""
    given = real_array(q_start, "q_start")
    if given.ndim not in (1, 2, 3) or given.shape[-1] != arm.n or given.size == 0:
        raise InputError(
            f"q_start: shape {given.shape}; a posture ({arm.n},), or solutions (k, {arm.n}) or (s, k, {arm.n}), are "
            f"accepted for {arm.name}"
        )
    return given.reshape((1,) * (3 - given.ndim) + given.shape)


def _times(t: Any) -> Array:
    times = real_array(t, "t")
    if times.ndim != 1 or len(times) < 3 or not (np.diff(times) > 0.0).all():
        raise InputError(f"t: shape {times.shape}; three or more rising times (k,) are accepted")
    return times


def _target_shape(arm: Arm, task: str) -> tuple[int, ...]:
    """The shape of a target, as the generated step takes it."""
    return dict(arm.evaluator(f"step_{task}").inputs)["held"]


def _unlimited(n: int) -> Limits:
    free = np.full(n, np.inf)
    return Limits(np.column_stack([-free, free]), free, free, free)


# ---- the search --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Found:
    """A path, its value, and what was said of it."""

    q: Array
    value: float
    solutions: tuple[Optimality, ...]


class _Search:
    """From local solutions to the best path found."""

    def __init__(
        self,
        problem: Problem,
        held: Array,
        objective: Stage,
        criterion: str,
        slack: float,
        bound: Array,
        guarded: bool,
        cyclic: bool,
        progress: Progress,
    ) -> None:
        self.problem, self.held = problem, held
        self.objective, self.criterion, self.slack = objective, criterion, slack
        self.bound, self.guarded, self.cyclic, self.progress = bound, guarded, cyclic, progress
        size = len(problem.t) - 1
        self.mesh = np.unique(np.rint(np.linspace(0, size, min(size, COARSE) + 1)).astype(int))
        self.coarse = problem.at(self.mesh)
        self.values = np.empty(0)
        self.best: _Found | None = None
        self.interrupted = False

    def check(self, given: Array) -> None:
        """Refuse solutions of a wrong length, and starts that cannot be kept."""
        arm, k = self.problem.arm, given.shape[1]
        if k not in (1, len(self.problem.t)):
            raise InputError(f"q_start: {k} samples; {len(self.problem.t)}, one for each time, are accepted")
        if not self.problem.fixed:
            return
        if np.ptp(given[:, 0], axis=0).max() > 0.0:
            raise InputError("q_start: the solutions start in different postures; with fixed_start one is accepted")
        error, _ = self.problem.at(np.array([0])).evaluate(given[:1, :1])
        if np.abs(error).max() > MISSED:
            raise InputError(
                f"q_start: its tip misses the first target by {np.abs(error).max():.3g} (m, rad); a posture there is "
                "accepted, or fixed_start=False"
            )
        low, high = self.problem.limits.position.T
        outside = np.flatnonzero((given[0, 0] < low) | (given[0, 0] > high))
        if len(outside):
            raise InputError(f"q_start: joint '{arm.joint_names[outside[0]]}' is outside its limits")

    def run(self, given: Array, count: int, seed: int) -> None:
        """Solve from every start on the coarse mesh, and from the best of these at every sample."""
        try:
            guesses = list(given[:, self.mesh]) if given.shape[1] > 1 else []
            if count:
                guesses += list(_local(self.coarse, self.held[self.mesh], given[0, 0], count, seed))
            found = self._coarse(guesses)
            self._fine(self._calmed(sorted(found, key=lambda one: self._rank(one.value))))
        except KeyboardInterrupt:
            self.interrupted = True
            if self.best is None:
                raise

    def _rank(self, value: float) -> float:
        """Less is better."""
        raised = self.objective == "max min w" or (self.objective == "integral of criterion" and self.criterion == "H")
        return -value if raised else value

    def _value(self, problem: Problem, q: Array) -> float:
        if self.objective == "squared rates":
            return problem.squared_rates(q)
        if self.objective == "squared accelerations":
            return self._turned(problem, q).squared_accelerations(q)
        if self.objective == "peak rate":
            return float(np.abs(problem.rates(q)).max())
        _, w = problem.evaluate(q)
        if self.objective == "max min w":
            return float(w[int(problem.fixed) :].min())
        value = w ** {"H": 1.0, "1/H": -1.0, "H^(-1/2)": -0.5}[self.criterion]
        return float(np.trapezoid(value, problem.t))

    def _turned(self, problem: Problem, q: Array) -> Problem:
        """The problem of a closed path, with the whole turns that ``q`` ends nearest to."""
        if not self.cyclic:
            return problem
        turning = np.array([kind == "R" for kind in problem.arm.kinds])
        return replace(problem, turns=np.where(turning, 2.0 * np.pi * np.rint((q[-1] - q[0]) / (2.0 * np.pi)), 0.0))

    def _coarse(self, guesses: list[Array]) -> list[_Found]:
        """The smoothest path near each start; then, from each of these and from starts as smooth, the objective."""
        smooth: list[Array] = []
        of_start: list[list[Array]] = []
        missed = np.inf
        for number, guess in enumerate(guesses, 1):
            self.progress(f"start {number} of {len(guesses)}: the smoothest path near it")
            q, said = solve(
                self._turned(self.coarse, guess), Aim("squared rates", self.criterion, 0.0, self.bound), guess
            )
            missed = min(missed, said.infeasibility)
            known = [other for other in smooth if said.solved and np.abs(other - q).max() < CLOSE]
            if said.solved and not known:
                smooth.append(q)
            of_start.append(known[:1] or ([q] if said.solved else []))
        if not smooth:
            raise InputError(
                f"{self.problem.arm.name}: none of {len(guesses)} starts leads to a path that holds every target "
                f"within the limits (missed by {missed:.2g} at best); more starts, or another start posture, may"
            )
        self._guard(min(smooth, key=self.coarse.squared_rates))
        for start, guess in zip(of_start, guesses, strict=True):
            if (np.abs(self.coarse.rates(guess)) <= self.bound).all() and self.objective != "squared rates":
                start.append(guess)
        solved: dict[int, _Found | None] = {}
        self.values = np.full(len(guesses), np.nan)
        for number, start in enumerate(of_start):
            for q in start:
                if id(q) not in solved:
                    self.progress(f"start {number + 1} of {len(guesses)}: {self.objective}, {len(self.mesh)} samples")
                    solved[id(q)] = self._solved(q)
                one = solved[id(q)]
                if one is not None and not self._rank(one.value) >= self._rank(self.values[number]):
                    self.values[number] = one.value
        return [one for one in solved.values() if one is not None]

    def _guard(self, smoothest: Array) -> None:
        """Bound the rates by those of the smoothest path, apart for revolute and prismatic joints."""
        if not self.guarded or self.objective in ("squared rates", "peak rate", "squared accelerations"):
            return
        peak = np.abs(self.coarse.rates(smoothest)).max(axis=0)
        kinds = np.array(list(self.problem.arm.kinds))
        for kind in "RP":
            largest = peak[kinds == kind].max(initial=0.0)
            self.bound[kinds == kind] = GUARD * largest if largest > 0.0 else np.inf

    def _solved(self, q: Array) -> _Found | None:
        found, said = solve(self._turned(self.coarse, q), self._aim(), q)
        return _Found(found, self._value(self.coarse, found), (said,)) if said.solved else None

    def _aim(self, warm: bool = False) -> Aim:
        return Aim(self.objective, self.criterion, 0.0, self.bound, warm)

    def _calmed(self, ranked: list[_Found]) -> list[_Found]:
        """Of paths with a least w as large, the one that can be run with the least peak rate first."""
        if self.objective != "max min w" or self.slack == 0.0:
            return ranked
        kept: list[_Found] = []
        for one in ranked:
            as_good = one.value >= (1.0 - SAME) * ranked[0].value
            if as_good and len(kept) < TRIED and all(np.abs(one.q - other.q).max() > CLOSE for other in kept):
                kept.append(one)
        if len(kept) < 2:
            return ranked
        peaks = []
        for one in kept:
            self.progress(f"least peak rate with w as large, {len(self.mesh)} samples")
            calm, said = self._calm(self.coarse, one)
            peaks.append(float(np.abs(self.coarse.rates(calm)).max()) if said.solved else np.inf)
        order = [kept[k] for k in np.argsort(peaks, kind="stable")]
        return order + [one for one in ranked if not any(one is other for other in order)]

    def _calm(self, problem: Problem, one: _Found) -> tuple[Array, Optimality]:
        """The least peak rate near a path, for a least w but for the slack as large."""
        floor = (1.0 - self.slack) * one.value
        return solve(self._turned(problem, one.q), Aim("peak rate", self.criterion, floor, self.bound, True), one.q)

    def _fine(self, ranked: list[_Found]) -> None:
        """The best coarse path at every sample; the next ones where it cannot be solved there."""
        problem, tried = self.problem, 0
        for one in ranked:
            if tried == TRIED:
                break
            tried += 1
            q = self._refined(one.q)
            if tried == 1:
                self.best = _Found(q, self._value(problem, q), ())
            turned = self._turned(problem, q)
            self.progress(f"{self.objective}, {len(q)} samples")
            for warm in (True, False):
                found, said = solve(turned, self._aim(warm), q)
                if said.solved:
                    break
            if not said.solved:
                continue
            self.best = _Found(found, self._value(problem, found), (said,))
            if self.objective == "max min w" and self.slack > 0.0:
                self.progress(f"least peak rate with w as large, {len(q)} samples")
                calm, more = self._calm(problem, self.best)
                if more.solved and np.abs(problem.rates(calm)).max() < np.abs(problem.rates(found)).max():
                    floor = (1.0 - self.slack) * self.best.value
                    self.best = _Found(calm, self._value(problem, calm), (said, more))
                    self._smoothed(problem, floor)
            return

    def _smoothed(self, problem: Problem, floor: float) -> None:
        """The least squared accelerations near the best path, for a least w and a peak rate as good."""
        assert self.best is not None
        q = self.best.q
        self.progress(f"least accelerations with w and peak rate as good, {len(q)} samples")
        cap = np.minimum(self.bound, (1.0 + self.slack) * np.abs(problem.rates(q)).max())
        aim = Aim("squared accelerations", self.criterion, floor, cap, True)
        smooth, said = solve(self._turned(problem, q), aim, q)
        if said.solved:
            self.best = _Found(smooth, self._value(problem, smooth), (*self.best.solutions, said))

    def _refined(self, q: Array) -> Array:
        """A coarse path at every sample: interpolated, and brought onto the targets."""
        from scipy.interpolate import CubicSpline

        if len(q) == len(self.problem.t):
            return q
        dense = np.asarray(CubicSpline(self.coarse.t, q)(self.problem.t))
        found, arrived = beginnings.bring(self.problem.arm, self.problem.task, self.held, dense)
        found = np.where(arrived[:, None], found, dense)
        found[0], found[-1] = q[0], q[-1]
        return found

    def result(self, path: TaskPath | None, gravity: Any, wrench: Any) -> GlobalRun:
        """What was found, measured."""
        best, problem = self.best, self.problem
        if best is None:
            raise InputError(
                f"{problem.arm.name}: no start leads to a path within the limits and rates of up to "
                f"{self.bound.max():.4g}; more starts, or a larger most_rate, may"
            )
        rates = problem.rates(best.q)
        m = problem.arm.tasks[problem.task]
        ranks = np.array([self._rank(value) for value in self.values])
        top = np.nanmin(ranks)
        agreed = int((ranks <= top + SAME * abs(top)).sum())
        ceiling = self._ceiling(best)
        text = self._text(best, agreed, ceiling)
        run = measured(
            problem.arm,
            problem.task,
            method="global",
            law=None,
            integrator="rates constant between samples",
            dt=float(np.diff(problem.t).mean()),
            t=problem.t,
            q=best.q,
            held=self.held,
            velocity=np.zeros((len(best.q), m)),
            rates=np.concatenate([rates, rates[-1:]]),
            reason=text,
            gravity=gravity,
            wrench=wrench,
        )
        return GlobalRun(
            run,
            self.objective,
            best.value,
            best.solutions,
            self.values,
            agreed,
            self.bound,
            ceiling,
            None if path is None else _between(problem, best.q, path),
            self.interrupted,
            text,
        )

    def _ceiling(self, best: _Found) -> float | None:
        """The largest w met at the target where the path has its least."""
        if self.objective != "max min w":
            return None
        arm, task, first = self.problem.arm, self.problem.task, int(self.problem.fixed)
        _, w = self.problem.evaluate(best.q)
        try:
            posture = beginnings.best(arm, task, self.held[first + int(np.argmin(w[first:]))])
        except InputError:  # none was met at all
            return best.value
        return max(best.value, float(arm.manipulability(posture, task=task)))

    def _text(self, best: _Found, agreed: int, ceiling: float | None) -> str:
        if self.interrupted or not best.solutions:
            how = "interrupted" if self.interrupted else "IPOPT did not solve it at every sample"
            missed = float(np.abs(self.problem.evaluate(best.q)[0]).max())
            return (
                f"{self.objective}: {best.value:.6g}; {how}: no optimum is claimed, nor that limits are kept; targets "
                f"are missed by up to {missed:.1g} (m, rad)"
            )
        worst = max(each.stationarity for each in best.solutions)
        above = "" if ceiling is None else f"; at its target of least w postures with w up to {ceiling:.6g} were met"
        return (
            f"{self.objective}: {best.value:.6g}, a local optimum of first order (IPOPT: {best.solutions[0].status}, "
            f"residual {worst:.1g}); {agreed} of {len(self.values)} starts came as far, which is no proof that none "
            f"goes farther{above}"
        )


def _local(problem: Problem, held: Array, q0: Array, count: int, seed: int) -> Array:
    """Joint motions (count, k, n) of local laws from one posture: uphill, and pushed along the self-motion.

    Every sample is reached from the one before by Newton's method, after a step in the null space.
    """
    arm, task, k = problem.arm, problem.task, len(problem.t)
    pushes = np.random.default_rng(seed).normal(size=(count, arm.n))
    pushes[: len(UPHILL)] = 0.0
    pushes *= PUSH / (k - 1)
    root = float(np.sqrt(max(float(arm.manipulability(q0, task=task)), 1e-12)))
    shares = (*UPHILL, *(0.0,) * count)[:count]  # of grad log H: that of H^(-1/2) is -H^(-1/2) / 2 times it
    moving = Stepper(arm, [Law({"H^(-1/2)": -2.0 * root * share}) for share in shares], task)
    newton = Stepper(arm, Law(feedback=(1.0, 1.0)), task)
    q = np.empty((count, k, arm.n))
    q[:, 0] = now = np.broadcast_to(q0, (count, arm.n))
    for i in range(1, k):
        now = now + _clipped(moving(now, held[i - 1], None, 1.0, push=pushes).null_motion)
        for _ in range(CORRECTIONS):
            now = now + _clipped(newton(now, held[i], None, 1.0).rates)
        q[:, i] = now
    return q


def _clipped(change: Array) -> Array:
    change = np.nan_to_num(change, posinf=0.0, neginf=0.0)
    size = np.abs(change).max(axis=-1, keepdims=True)
    return np.asarray(change * np.minimum(1.0, STRIDE / np.maximum(size, 1e-300)))


def _between(problem: Problem, q: Array, path: TaskPath) -> Between:
    """Errors and w in the quarters of the intervals, at constant rates."""
    arm, task = problem.arm, problem.task
    shares = np.array([0.25, 0.5, 0.75])
    t = (problem.t[:-1, None] + np.diff(problem.t)[:, None] * shares).ravel()
    where = (q[:-1, None] + np.diff(q, axis=0)[:, None] * shares[:, None]).reshape(-1, arm.n)
    step = Stepper(arm, None, task)(where, path.sample(t, task).held, None, 0.0)
    away, turned = errors(arm, task, step.error)
    return Between(
        float(np.linalg.norm(away, axis=1).max()),
        float(np.linalg.norm(turned, axis=1).max(initial=0.0)),
        float(step.manipulability.min()),
    )
