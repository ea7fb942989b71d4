"""Questions about planar arms: speed ratios, minimum time, the workspace within limits; each beside a peer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count as counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chainrule as cr
from benchmarks.measure import Disagreement, in_turn
from benchmarks.table import Row

Array = NDArray[Any]
Results = Callable[[], tuple[Array, ...]]

#: Everyone's numbers agree to this, relative to 1 or the value.
TOLERANCE = 1e-8
#: How many times faster a batch of speed ratios is meant to be than its peers in NumPy.
RATIO = 10.0


@dataclass(frozen=True)
class Way:
    """One way of answering: who, how many answers one call gives, the call, and its results for comparison."""

    who: str
    count: int
    call: Callable[[], object]
    results: Results | None = None
    least: float = 0.0  # how many times slower than ours it is meant to be
    most_ns: float = 0.0  # how long one answer is meant to take at most
    tolerance: float = TOLERANCE


def agreement(ways: list[Way]) -> float:
    """The largest difference between the ways that can be compared.

    Raises:
        Disagreement: naming who differs.
    """
    worst = 0.0
    reference = ways[0].results() if ways[0].results else ()
    for way in ways[1:]:
        if way.results is None:
            continue
        for mine, theirs in zip(reference, way.results(), strict=False):
            mine = mine[: len(theirs)]
            difference = float(np.max(np.abs(mine - theirs) / np.maximum(1.0, np.abs(mine)), initial=0.0))
            worst = max(worst, difference)
            if not difference <= way.tolerance:
                raise Disagreement(f"{way.who} differs by {difference:.1e}")
    return worst


def rows(section: str, ways: list[Way], rounds: int, least_ns: float) -> list[Row]:
    """Everyone timed in turn; ours first."""
    found = in_turn({way.who: (way.call, way.count) for way in ways}, rounds, least_ns)
    mine = found[ways[0].who]
    table = []
    for way in ways:
        timing = found[way.who]
        ratio = timing.times(mine)
        goal = {"goal": f"ours {way.least:g} times faster", "reached": ratio >= way.least} if way.least else {}
        if way.most_ns:
            goal = {"goal": f"at most {way.most_ns:,.0f} ns", "reached": timing.median <= way.most_ns}
        table.append(Row(section, way.who, timing.median, "ns", timing.spread, ratio, **goal))  # type: ignore[arg-type]
    return table


def questions(batch: int) -> Iterator[tuple[str, list[Way], str]]:
    """Every question: its heading, the ways of answering it, and perhaps a note."""
    yield f"both speed ratios of a planar 3R, with dk/ds; batch of {batch:,}", speed_ratios(batch), ""
    yield f"minimum time of seven joints; batch of {batch:,}", min_time(batch), ""
    ways, note = limited_workspace()
    yield "area of a planar 3R's workspace within limits", ways, note


# ---- speed ratios ------------------------------------------------------------------------------------------------


def speed_ratios(count: int) -> list[Way]:
    """Both joint rates that give a path tangent and curvature, and the curvature's rate of each, for a planar 3R."""
    arm = cr.planar_3r(1.15, 1.5, 1.8)
    rng = np.random.default_rng(2)
    q = rng.uniform(-np.pi, np.pi, (3 * count, 3))
    turn = rng.uniform(-np.pi, np.pi, 3 * count)
    tangent = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    curvature = np.stack([rng.uniform(-1.0, 1.0, 3 * count), np.zeros(3 * count)], axis=-1)
    evaluator = arm.evaluator("speed_ratio_rates")
    lead = np.array([1.0, 0.0, 0.0])
    places = {name: k for k, (name, _) in enumerate(evaluator.outputs)}
    first = evaluator(q, arm.parameters, tangent, curvature, lead)
    # clear cases only: two real solutions, away from singular postures, where everyone's formulas hold
    bent = np.abs(first[places["parabola"]][..., 0]) > 0.05
    clear = (first[places["slack"]] > 0.01) & (arm.manipulability(q) > 0.3) & bent
    q, tangent, curvature = (np.ascontiguousarray(part[clear][:count]) for part in (q, tangent, curvature))
    kappa = np.ascontiguousarray(curvature[:, 0])
    out = evaluator(q, arm.parameters, tangent, curvature, lead)

    def ours() -> tuple[Array, ...]:
        found = evaluator(q, arm.parameters, tangent, curvature, lead, out=out)
        return _sorted(found[places["rates"]], found[places["tracked_rate"]])

    symbolic = _lambdified(arm)

    def lambdify() -> tuple[Array, ...]:
        return symbolic(*q.T, *tangent.T, kappa)  # type: ignore[no-any-return]

    def compared() -> tuple[Array, ...]:
        found = np.stack(np.broadcast_arrays(*lambdify()), axis=-1)
        return _sorted(found[:, :6].reshape(-1, 2, 3), found[:, 6:])

    most = min(count, 5000)

    def pseudoinverse() -> Array:
        rates: Array = (np.linalg.pinv(_jacobian(q[:most])) @ tangent[:most, :, None])[..., 0]
        return rates

    return [
        Way(
            "chainrule, the generated function",
            len(q),
            lambda: evaluator(q, arm.parameters, tangent, curvature, lead, out=out),
            ours,
        ),
        Way("chainrule, cr.speed_ratios", len(q), lambda: cr.speed_ratios(arm, q, tangent, kappa)),
        Way("the same formulas by SymPy lambdify (cse)", len(q), lambdify, compared, RATIO),
        Way("the pseudoinverse alone, NumPy (linalg.pinv)", most, pseudoinverse, None, RATIO),
    ]


def _sorted(rates: Array, changes: Array) -> tuple[Array, Array]:
    """Both solutions in the order of their first joint's rate."""
    order = np.argsort(rates[..., 0], axis=-1)
    return np.take_along_axis(rates, order[..., None], axis=1), np.take_along_axis(changes, order, axis=1)


def _jacobian(q: Array) -> Array:
    """The position Jacobian as one writes it in NumPy."""
    heading = np.cumsum(q, axis=-1)
    lengths = np.array([1.15, 1.5, 1.8])
    x, y = lengths * np.cos(heading), lengths * np.sin(heading)
    tails = [np.cumsum(part[:, ::-1], axis=-1)[:, ::-1] for part in (-y, x)]
    return np.stack(tails, axis=1)


def _lambdified(arm: cr.Arm) -> Callable[..., Any]:
    """The curvature's parabola, its roots, the rates and dk/ds, from SymPy's own derivatives of the position."""
    import sympy as sp

    q = sp.symbols("q1:4", real=True)
    tx, ty, kappa = sp.symbols("tx ty kappa", real=True)
    headings = [sum(q[: k + 1]) for k in range(3)]
    lengths = [sp.Float(float(length)) for length in arm.parameters]
    tip = [sum(length * f(a) for length, a in zip(lengths, headings, strict=True)) for f in (sp.cos, sp.sin)]

    def along(values: list[Any]) -> Any:
        return values[0] * tx + values[1] * ty

    def across(values: list[Any]) -> Any:
        return tx * values[1] - ty * values[0]

    def derivative(rates: list[Any], order: int) -> list[Any]:
        found = tip
        for _ in range(order):
            found = [sum(sp.diff(part, joint) * rate for joint, rate in zip(q, rates, strict=True)) for part in found]
        return found

    a = [along([sp.diff(part, joint) for part in tip]) for joint in q]
    c = [across([sp.diff(part, joint) for part in tip]) for joint in q]
    normal = list(sp.Matrix(a).cross(sp.Matrix(c)))
    square = sum(e**2 for e in normal)
    size = sp.sqrt(square)
    null = [e / size for e in normal]
    least = [e / square for e in sp.Matrix(c).cross(sp.Matrix(normal))]
    mixed = [[across([sp.diff(part, i, j) for part in tip]) for j in q] for i in q]

    def form(x: list[Any], y: list[Any]) -> Any:
        return sum(mixed[i][j] * x[i] * y[j] for i in range(3) for j in range(3))

    p2, p1, p0 = form(null, null), 2 * form(least, null), form(least, least)
    root = sp.sqrt(p1**2 - 4 * p2 * (p0 - kappa))
    rates, changes = [], []
    for sign in (1, -1):
        z = (-p1 + sign * root) / (2 * p2)
        symbols = list(sp.symbols("x1:4"))
        x = [m + z * n for m, n in zip(least, null, strict=True)]
        change = across(derivative(symbols, 3)) - 3 * kappa * along(derivative(symbols, 2))
        rates += x
        changes.append(change.subs(dict(zip(symbols, x, strict=True))))
    found: Callable[..., Any] = sp.lambdify([*q, tx, ty, kappa], [*rates, *changes], "numpy", cse=True)
    return found


# ---- minimum time ------------------------------------------------------------------------------------------------


def min_time(count: int) -> list[Way]:
    """The fastest motion of seven joints from rest to rest: durations of all joints."""
    rng = np.random.default_rng(3)
    start, goal = rng.uniform(-2.5, 2.5, (2, count, 7))
    v_max, a_max = rng.uniform(0.5, 3.0, 7), rng.uniform(1.0, 12.0, 7)
    ways = [
        Way(
            "chainrule, cr.min_time",
            count,
            lambda: cr.min_time(start, goal, v_max, a_max),
            lambda: (cr.min_time(start, goal, v_max, a_max).joint_durations,),
        )
    ]
    try:
        import ruckig
    except ImportError:
        return ways
    few = min(count, 2000)
    generator, move = ruckig.Ruckig(7), ruckig.InputParameter(7)
    move.synchronization = ruckig.Synchronization.No
    move.max_velocity, move.max_acceleration = v_max.tolist(), a_max.tolist()
    trajectory = ruckig.Trajectory(7)

    def loop() -> tuple[Array]:
        found = np.empty((few, 7))
        for k in range(few):
            move.current_position, move.target_position = start[k].tolist(), goal[k].tolist()
            if generator.calculate(move, trajectory) < 0:
                raise Disagreement("Ruckig found no trajectory")
            found[k] = trajectory.independent_min_durations
        return (found,)

    return [*ways, Way("Ruckig, a loop in Python", few, loop, loop)]


# ---- the workspace within limits -----------------------------------------------------------------------------------

#: Relative accuracy of the area at which the workspace and sampling are compared.
ACCURACY = 5e-3


def limited_workspace() -> tuple[list[Way], str]:
    """The area of the reachable set of a planar 3R with joint limits: exact, and by sampling to an equal accuracy."""
    limits = np.radians([[-100.0, 80.0], [10.0, 140.0], [-120.0, 60.0]])
    fresh = counter()

    def arm() -> cr.Arm:
        """The arm, longer by a picometre each time: nothing that is remembered helps."""
        return cr.planar_3r(1.0 + 1e-12 * next(fresh), 0.7, 0.4).with_limits(position=limits.tolist())

    exact, size = cr.workspace(arm()).area, 24
    while True:
        errors = [_sampled(arm(), limits, size, seed) / exact - 1.0 for seed in range(5)]
        error = float(np.sqrt(np.mean(np.square(errors))))
        if error <= ACCURACY:
            break
        size = int(size * 1.5)
        if size > 600:
            raise Disagreement(f"sampling comes no nearer than {error:.1e} to the exact area")
    ways = [
        Way("chainrule, the exact boundary and area", 1, lambda: cr.workspace(arm()).area),
        Way(f"sampling, right to {error:.1e}", 1, lambda: _sampled(arm(), limits, size, 0)),
    ]
    return ways, f"Workspace within limits: sampling takes {size}² cells to be right to {ACCURACY:g} (five grids)."


def _sampled(arm: cr.Arm, limits: Array, size: int, seed: int) -> float:
    """The area of the cells of a grid that random configurations meet, half of those on the rim counted.

    Configurations are added until a further round as large as the first meets hardly any new cell.
    """
    rng = np.random.default_rng(seed)
    reach = float(np.abs(arm.parameters).sum()) * 1.1
    shift = rng.uniform(-0.5, 0.5, 2)
    met = np.zeros((size + 2, size + 2), bool)
    while True:
        before = int(met.sum())
        q = rng.uniform(limits[:, 0], limits[:, 1], (8 * size * size, 3))
        cells = ((arm.position(q) / reach + 1.0) * (size / 2.0) + shift + 1.0).astype(int)
        met[cells[:, 0], cells[:, 1]] = True
        if int(met.sum()) - before <= 2e-4 * before:
            break
    inner = met[1:-1, 1:-1] & met[:-2, 1:-1] & met[2:, 1:-1] & met[1:-1, :-2] & met[1:-1, 2:]
    rim = int(met.sum()) - int(inner.sum())
    return (int(inner.sum()) + rim / 2.0) * (2.0 * reach / size) ** 2
