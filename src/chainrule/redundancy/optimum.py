"""The nonlinear program of a whole path: one posture for each sample, and what IPOPT says of its solution.

Unknown are the postures q_i at the times t_i. They hold the task, e(q_i) = 0; rates are differences between
neighbours, (q_{i+1} - q_i) / (t_{i+1} - t_i), and accelerations differences of these over the mean of the two
intervals. Kinematics come from the derived step of the task, differentiated by CasADi.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, Limits
from chainrule.compile import casadi_function

Array = NDArray[Any]
Stage = Literal["max min w", "integral of criterion", "squared rates", "peak rate", "squared accelerations"]

#: A share of the squared rates in every other objective: among equally good paths the smoother one.
SMOOTHING = 1e-3
#: IPOPT's own measure of optimality, and the most iterations of one solution.
TOLERANCE, ITERATIONS = 1e-8, 200
#: How IPOPT is kept near a start that is nearly a solution: by the barrier of its last iterations, and little pushing.
WARM = {
    "ipopt.mu_init": 1e-4,
    **dict.fromkeys((f"ipopt.{part}" for part in ("bound_push", "bound_frac")), 1e-6),
    **dict.fromkeys((f"ipopt.slack_{part}" for part in ("bound_push", "bound_frac")), 1e-6),
}
#: What IPOPT calls a solution.
SOLVED = ("Solve_Succeeded", "Solved_To_Acceptable_Level")


@dataclass(frozen=True)
class Problem:
    """A path in samples.

    Attributes:
        arm: the arm.
        task: what is held.
        t: (k,) s.
        held: (k, h) targets, row by row.
        limits: joint limits, infinite where there is none.
        fixed: whether the first posture is given.
        turns: (n,) by how much the joints of a closed path come back turned, rad; None for an open path.
    """

    arm: Arm
    task: str
    t: Array
    held: Array
    limits: Limits
    fixed: bool
    turns: Array | None

    @cached_property
    def function(self) -> Any:
        """(q, held) -> (error, manipulability), as a CasADi function."""
        import casadi as ca

        model = self.arm.description.model
        found = casadi_function(model, f"redundancy_{self.task}", f"step_{self.task}", ("error", "manipulability"))
        q, held = ca.SX.sym("q", self.arm.n), ca.SX.sym("held", self.held.shape[1])
        given = {"q": q, "held": held, "parameters": ca.DM(self.arm.parameters)}
        error, w = found.call([given[name] for name in found.name_in()])
        return ca.Function("sample", [q, held], [error, w])

    def at(self, chosen: Array) -> Problem:
        """The same path at some of the samples."""
        return replace(self, t=self.t[chosen], held=self.held[chosen])

    def evaluate(self, q: Array) -> tuple[Array, Array]:
        """The error (..., m) and w (...,) of postures (..., k, n)."""
        rows = np.reshape(q, (-1, self.arm.n))
        held = np.broadcast_to(self.held, (*q.shape[:-1], self.held.shape[1])).reshape(len(rows), -1)
        error, w = (np.array(found) for found in self.function.map(len(rows))(rows.T, held.T))
        return error.T.reshape(*q.shape[:-1], -1), w.reshape(q.shape[:-1])

    def rates(self, q: Array) -> Array:
        """(k - 1, n)."""
        return np.asarray(np.diff(q, axis=0) / np.diff(self.t)[:, None])

    def squared_rates(self, q: Array) -> float:
        """The integral of the squared rates."""
        return float((self.rates(q) ** 2 * np.diff(self.t)[:, None]).sum())

    @property
    def between(self) -> Array:
        """s, the mean of every two neighbouring intervals; on a closed path also of the last one and the first."""
        steps = np.diff(self.t)
        return 0.5 * (steps + np.roll(steps, -1))[: len(steps) - (self.turns is None)]

    def squared_accelerations(self, q: Array) -> float:
        """The integral of the squared accelerations."""
        rates = self.rates(q)
        change = np.diff(rates, axis=0) if self.turns is None else np.roll(rates, -1, axis=0) - rates
        return float((change**2 / self.between[:, None]).sum())


@dataclass(frozen=True)
class Optimality:
    """What IPOPT said, and how well the conditions of first order hold, measured on the unscaled program.

    A local optimum: these say nothing of other paths.

    Attributes:
        status: IPOPT's word.
        iterations: how many it took.
        stationarity: the largest entry of the Lagrangian's gradient.
        infeasibility: the largest violation of a constraint, in the units of that constraint.
        complementarity: the largest product of a multiplier and its constraint's slack.
    """

    status: str
    iterations: int
    stationarity: float
    infeasibility: float
    complementarity: float

    @property
    def solved(self) -> bool:
        """Whether IPOPT calls it a solution."""
        return self.status in SOLVED

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "status": self.status,
            "iterations": self.iterations,
            "stationarity": self.stationarity,
            "infeasibility": self.infeasibility,
            "complementarity": self.complementarity,
        }


@dataclass(frozen=True)
class Aim:
    """What one solution is for.

    Attributes:
        stage: the objective.
        criterion: for the integral: "H", "1/H" or "H^(-1/2)".
        floor: the least w allowed; 0 for none.
        cap: (n,) the largest rates allowed beside the limits; infinite for none.
        warm: whether the start is nearly a solution, to be kept near.
    """

    stage: Stage
    criterion: str
    floor: float
    cap: Array
    warm: bool = False


class _Rows:
    """Constraints lower <= g <= upper, collected."""

    def __init__(self) -> None:
        self.g: list[Any] = []
        self.lower: list[Array] = []
        self.upper: list[Array] = []

    def add(self, g: Any, lower: Any, upper: Any) -> None:
        import casadi as ca

        g = ca.vec(g)
        self.g.append(g)
        self.lower.append(np.broadcast_to(lower, g.numel()).astype(float))
        self.upper.append(np.broadcast_to(upper, g.numel()).astype(float))


def solve(problem: Problem, aim: Aim, start: Array) -> tuple[Array, Optimality]:
    """A locally optimal path (k, n) near ``start`` (k, n), whose first posture is the given one where that is fixed.

    Raises:
        KeyboardInterrupt: the solution was interrupted.
    """
    import casadi as ca

    k, n = start.shape
    own = slice(int(problem.fixed), k - (problem.turns is not None))  # samples with a posture of their own
    count = own.stop - own.start
    x = ca.MX.sym("x", n, count)
    columns: list[Any] = [ca.DM(start[0]), x] if problem.fixed else [x]
    if problem.turns is not None:
        columns.append(columns[0][:, 0] + ca.DM(problem.turns))
    q: Any = ca.horzcat(*columns)
    moved = q[:, 1:] - q[:, :-1]
    error, w = problem.function.map(count)(x, ca.DM(problem.held[own]).T)
    rows = _Rows()
    rows.add(error, 0.0, 0.0)
    _limits(rows, problem, aim, moved)
    if aim.floor > 0.0:
        rows.add((w / aim.floor) ** 2, 1.0, np.inf)
    extra, extra_start, objective = _objective(rows, problem, aim, start, own, moved, w)

    low, high = (np.tile(bound, count) for bound in problem.limits.position.T)
    lower, upper = np.append(low, np.full(extra_start.size, 1e-9)), np.append(high, np.full(extra_start.size, np.inf))
    guess = np.append(start[own].ravel(), extra_start)
    at, optimality = _ipopt(ca.vertcat(ca.vec(x), extra), objective, rows, lower, upper, guess, aim.warm)
    found = start.copy()
    found[own] = at[: n * count].reshape(count, n)
    if problem.turns is not None:
        found[-1] = found[0] + problem.turns
    return found, optimality


def _objective(
    rows: _Rows, problem: Problem, aim: Aim, start: Array, own: slice, moved: Any, w: Any
) -> tuple[Any, Array, Any]:
    """What is minimised, scaled to about 1 at the start, and the unknown it needs beside the postures (or none).

    Largest and smallest values are taken by a further unknown, which everything else is held under or over.
    """
    import casadi as ca

    steps = np.diff(problem.t)
    if aim.stage == "squared accelerations":
        change = _each(_change(problem, moved), 1.0 / np.sqrt(problem.between))
        return ca.MX(0, 1), np.zeros(0), ca.sumsqr(change) / max(problem.squared_accelerations(start), 1e-12)
    smoothness = ca.sumsqr(_each(moved, 1.0 / np.sqrt(steps))) / max(problem.squared_rates(start), 1e-12)
    if aim.stage == "squared rates":
        return ca.MX(0, 1), np.zeros(0), smoothness
    if aim.stage == "peak rate":
        most = float(np.abs(problem.rates(start)).max(initial=0.0)) or 1.0
        peak, paced = ca.MX.sym("peak"), _each(moved, 1.0 / (steps * most))
        rows.add(peak - paced, 0.0, np.inf)
        rows.add(peak + paced, 0.0, np.inf)
        return peak, np.ones(1), peak + SMOOTHING * smoothness
    w_start = problem.evaluate(start)[1][own]
    scale = max(float(w_start.max()), 1e-300)
    w_start = np.maximum(w_start / scale, 1e-6)
    if aim.stage == "max min w":
        least = ca.MX.sym("least")
        rows.add((w / scale) ** 2 - least**2, 0.0, np.inf)
        return least, np.array([w_start.min()]), -ca.log(least) + SMOOTHING * smoothness
    weights = np.append(0.5 * steps, 0.0) + np.append(0.0, 0.5 * steps)
    if problem.turns is not None:  # the last sample is the first one again
        weights[0] += weights[-1]
    power = {"H": 1.0, "1/H": -1.0, "H^(-1/2)": -0.5}[aim.criterion]
    integral = ca.dot(ca.DM(weights[own]).T, (w / scale) ** power) / float(weights[own] @ w_start**power)
    return ca.MX(0, 1), np.zeros(0), (-integral if power > 0 else integral) + SMOOTHING * smoothness


def _each(columns: Any, factors: Array) -> Any:
    """Every column times its factor."""
    import casadi as ca

    return columns * ca.repmat(ca.DM(factors).T, columns.shape[0], 1)


def _change(problem: Problem, moved: Any) -> Any:
    """The change of the rates from each interval to the next; on a closed path from the last to the first as well."""
    import casadi as ca

    paced = _each(moved, 1.0 / np.diff(problem.t))
    change = paced[:, 1:] - paced[:, :-1]
    return change if problem.turns is None else ca.horzcat(change, paced[:, 0] - paced[:, -1])


def _limits(rows: _Rows, problem: Problem, aim: Aim, moved: Any) -> None:
    """Rates within their limits and the cap; accelerations within theirs."""
    steps = np.diff(problem.t)
    most = np.minimum(problem.limits.velocity, aim.cap)
    joints = [int(j) for j in np.flatnonzero(np.isfinite(most))]
    if joints:
        bound = (most[joints][:, None] * steps).ravel(order="F")
        rows.add(moved[joints, :], -bound, bound)
    sharp = problem.limits.acceleration
    joints = [int(j) for j in np.flatnonzero(np.isfinite(sharp))]
    if joints:
        change = _change(problem, moved)[joints, :]
        bound = (sharp[joints][:, None] * problem.between).ravel(order="F")
        rows.add(change, -bound, bound)


def _ipopt(
    x: Any, objective: Any, rows: _Rows, lower: Array, upper: Array, guess: Array, warm: bool
) -> tuple[Array, Optimality]:
    """Solve, and measure how well the conditions of first order hold."""
    import casadi as ca

    g, low, high = ca.vertcat(*rows.g), np.concatenate(rows.lower), np.concatenate(rows.upper)
    options: dict[str, Any] = {
        "print_time": False,
        "show_eval_warnings": False,
        "ipopt.print_level": 0,
        "ipopt.sb": "yes",
        "ipopt.tol": TOLERANCE,
        "ipopt.max_iter": ITERATIONS,
        **(WARM if warm else {}),
    }
    solver = ca.nlpsol("path", "ipopt", {"x": x, "f": objective, "g": g}, options)
    found = solver(x0=guess, lbx=lower, ubx=upper, lbg=low, ubg=high)
    status = str(solver.stats()["return_status"])
    if status == "NonIpopt_Exception_Thrown":  # what CasADi makes of Ctrl-C
        raise KeyboardInterrupt
    slope = ca.Function("slope", [x], [ca.gradient(objective, x), ca.jacobian(g, x), g])
    gradient, jacobian, values = slope(found["x"])
    stationarity = np.array(gradient + jacobian.T @ found["lam_g"] + found["lam_x"])
    at, reaction, force = (np.array(found[name]).ravel() for name in ("x", "lam_x", "lam_g"))
    value = np.append(at, np.array(values))
    above, below = value - np.append(lower, low), np.append(upper, high) - value
    force = np.append(reaction, force)
    slack = np.where(force > 0.0, below, above)
    products = np.abs(force[np.isfinite(slack)] * slack[np.isfinite(slack)])
    return at, Optimality(
        status,
        int(solver.stats()["iter_count"]),
        float(np.abs(stationarity).max(initial=0.0)),
        float(-min(above.min(initial=0.0), below.min(initial=0.0))),
        float(products.max(initial=0.0)),
    )
