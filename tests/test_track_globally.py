"""Whole paths optimised at once: against dynamic programming, conditions of first order, limits, and by hand."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import chainrule as cr
from chainrule.compile import casadi_function
from chainrule.redundancy.globally import GlobalRun

LENGTHS = (1.0, 0.5, 0.25)
#: Directions of the last link in the grid of the dynamic program, and how far one step may go in them.
GRID, WINDOW = 720, 40
#: Start posture of the thesis' arc.
POSTURE_A = [
    *(-1.873731004463, -1.816784929574, -2.610767475187, 2.197077859614),
    *(-1.287777812569, 1.434014115789, 1.595985198549, -2.679241147511),
]


@pytest.fixture(scope="module")
def arm() -> cr.Arm:
    return cr.planar_3r(*LENGTHS)


@pytest.fixture(scope="module")
def line() -> cr.TaskPath:
    return cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)


def by_hand(q: Any) -> tuple[Any, Any, Any]:
    """Position, Jacobian and w of the planar arm, written out."""
    angles = np.cumsum(q, axis=-1)
    x, y = LENGTHS * np.cos(angles), LENGTHS * np.sin(angles)
    position = np.stack([x.sum(axis=-1), y.sum(axis=-1)], axis=-1)
    columns = [np.stack([-y[..., j:].sum(axis=-1), x[..., j:].sum(axis=-1)], axis=-1) for j in range(3)]
    jacobian = np.stack(columns, axis=-1)
    return position, jacobian, np.linalg.svd(jacobian, compute_uv=False).prod(axis=-1)


def postures(target: Any) -> Any:
    """(2, GRID, 3): both elbows for each direction of the last link; nan where there is none."""
    direction = 2.0 * np.pi * np.arange(GRID) / GRID
    a, b, c = LENGTHS
    x, y = target[0] - c * np.cos(direction), target[1] - c * np.sin(direction)
    with np.errstate(invalid="ignore"):
        elbow = np.arccos((x**2 + y**2 - a**2 - b**2) / (2.0 * a * b))
    found = []
    for sign in (1.0, -1.0):
        second = sign * elbow
        first = np.arctan2(y, x) - np.arctan2(b * np.sin(second), a + b * np.cos(second))
        found.append(np.stack([first, second, direction - first - second], axis=-1))
    return np.array(found)


def wrapped(change: Any) -> Any:
    return (change + np.pi) % (2.0 * np.pi) - np.pi


class Grid:
    """The best path over a grid of the self-motion, by dynamic programming: the optimum up to the grid."""

    def __init__(self, targets: Any, dt: float, most_rate: float) -> None:
        self.q = np.array([postures(target) for target in targets])
        self.w = by_hand(np.nan_to_num(self.q))[2]
        self.exists = np.isfinite(self.q).all(axis=-1)
        self.dt, self.most = dt, most_rate * dt

    def best(self, start: Any, cost: Any, join: Any, nothing: float = -np.inf) -> float:
        """The least cost: ``cost(k, w, rates)`` of arriving at sample k, ``join`` of the cost before and that."""
        shifts = range(-WINDOW, WINDOW + 1)
        total = None
        for k in range(1, len(self.q)):
            steps = []
            if total is None:
                change = wrapped(self.q[k] - start)
                steps.append((np.full(change.shape[:2], nothing), change))
            else:
                for shift in shifts:
                    before = np.roll(self.q[k - 1], shift, axis=1)
                    steps.append((np.roll(total, shift, axis=1), wrapped(self.q[k] - before)))
            arrived = np.full((2, GRID), np.inf)
            for before, change in steps:
                allowed = self.exists[k] & (np.abs(change).max(axis=-1) <= self.most)
                with np.errstate(divide="ignore"):  # where there is no posture
                    here = join(before, cost(k, self.w[k], change / self.dt))
                arrived = np.where(allowed & (here < arrived), here, arrived)
            total = arrived
        return float(np.min(total))


def targets_of(path: cr.TaskPath, steps: int) -> tuple[Any, Any]:
    t = np.linspace(0.0, path.duration, steps + 1)
    return t, path.sample(t, "position").held


def start_at(path: cr.TaskPath, elbow: int, direction: int) -> Any:
    return postures(path.sample([0.0], "position").held[0])[elbow, direction]


# Starts with either elbow, near the best posture and far from it, and bounds that hold the path up or do not.
@pytest.mark.parametrize(("elbow", "direction", "most"), [(0, 240, 4.0), (1, 200, 2.2), (0, 440, 1.6)])
def test_no_path_of_a_grid_has_a_larger_least_manipulability(
    arm: cr.Arm, line: cr.TaskPath, elbow: int, direction: int, most: float
) -> None:
    t, held = targets_of(line, 20)
    start = start_at(line, elbow, direction)
    grid = -Grid(held, 0.05, most).best(start, lambda k, w, rates: -w, np.maximum)
    found = cr.track_globally(arm, held, start, t, most_rate=most, count=4)
    assert found.solved
    assert grid * (1.0 - 1.5e-3) <= found.value <= grid * 1.02
    assert found.value == pytest.approx(by_hand(found.q)[2][1:].min(), rel=1e-12)
    assert found.ceiling is not None and found.value <= found.ceiling
    np.testing.assert_array_equal(found.q[0], start)
    np.testing.assert_allclose(by_hand(found.q)[0], held, rtol=0, atol=1e-8)
    assert found.run.peak_rate <= most + 1e-6
    assert found.run.min_manipulability == pytest.approx(by_hand(found.q)[2].min(), rel=1e-12)


def test_with_a_free_start_the_least_manipulability_is_the_ceiling(arm: cr.Arm) -> None:
    """No path has a larger least w than the largest w at its worst target; towards the base it can be had."""
    path = cr.TaskPath.line((0.6, 0.3), (0.3, 0.15), duration=1.0)
    found = cr.track_globally(arm, path, dt=0.05, count=2, slack=0.0, fixed_start=False)
    largest = []
    for target in targets_of(path, 20)[1]:
        every = postures(target)[0]
        largest.append(by_hand(every[np.isfinite(every).all(axis=-1)])[2].max())
    assert found.value == pytest.approx(min(largest), rel=2e-3)
    assert found.ceiling == pytest.approx(found.value, rel=1e-3)


def test_no_path_of_a_grid_has_smaller_rates_or_integral(arm: cr.Arm, line: cr.TaskPath) -> None:
    t, held = targets_of(line, 20)
    start, grid = start_at(line, 0, 440), Grid(held, 0.05, 2.0)
    trapezoid = np.append(np.full(20, 0.05), 0.025)
    costs = {
        "peak rate": grid.best(start, lambda k, w, rates: np.abs(rates).max(axis=-1), np.maximum),
        "squared rates": grid.best(start, lambda k, w, rates: 0.05 * (rates**2).sum(axis=-1), np.add, 0.0),
        "integral of criterion": 0.025 / by_hand(start)[2]
        + grid.best(start, lambda k, w, rates: trapezoid[k] / w, np.add, 0.0),
    }
    for objective, cost in costs.items():
        found = cr.track_globally(
            arm,
            held,
            start,
            t,
            objective=objective,
            criterion="1/H",
            most_rate=2.0,
            count=4,  # type: ignore[arg-type]
        )
        assert found.solved
        assert cost * 0.97 <= found.value <= cost * 1.003


def test_squared_rates_satisfy_the_conditions_of_first_order(arm: cr.Arm, line: cr.TaskPath) -> None:
    """Euler-Lagrange in samples: the change of the rates is normal to the self-motion; free ends move not along it."""
    found = cr.track_globally(arm, line, start_at(line, 0, 440), dt=0.05, objective="squared rates", fixed_start=False)
    rates = np.diff(found.q, axis=0) / 0.05
    null = np.linalg.svd(by_hand(found.q)[1])[2][:, 2]
    along = np.einsum("kj,kj->k", null[1:-1], np.diff(rates, axis=0))
    assert np.abs(along).max() < 1e-6
    assert abs(null[0] @ rates[0]) < 1e-6 and abs(null[-1] @ rates[-1]) < 1e-6
    fixed = cr.track_globally(arm, line, start_at(line, 0, 440), dt=0.05, objective="squared rates")
    assert fixed.value > found.value + 0.01
    assert found.solutions[-1].stationarity < 1e-6


def test_squared_accelerations_satisfy_the_conditions_of_first_order(arm: cr.Arm, line: cr.TaskPath) -> None:
    """Their fourth differences are normal to the self-motion, and also at free ends, beyond which nothing bends."""
    start = start_at(line, 0, 440)
    found = cr.track_globally(arm, line, start, dt=0.05, objective="squared accelerations", fixed_start=False)
    null = np.linalg.svd(by_hand(found.q)[1])[2][:, 2]
    bent = np.zeros((len(found.q) + 2, 3))
    bent[2:-2] = np.diff(found.q, 2, axis=0) / 0.05**2
    along = np.einsum("kj,kj->k", null, np.diff(bent, 2, axis=0))
    assert np.abs(along).max() < 1e-5
    assert found.value == pytest.approx(float((bent**2).sum() * 0.05), rel=1e-9)
    fixed = cr.track_globally(arm, line, start, dt=0.05, objective="squared accelerations")
    assert fixed.value > found.value


def test_accelerations_of_a_closed_path_go_round(arm: cr.Arm) -> None:
    """From the last interval to the first there is one more; an optimum of those differs from one without."""
    path = cr.TaskPath.circle((0.8, 0.0), 0.2, duration=2.0)
    start = start_at(path, 0, 440)
    closed = cr.track_globally(
        arm, path, start, dt=0.1, objective="squared accelerations", cyclic=True, fixed_start=False, count=2
    )
    rates = np.diff(closed.q, axis=0) / 0.1
    change = np.concatenate([np.diff(rates, axis=0), rates[:1] - rates[-1:]])
    assert closed.value == pytest.approx(float((change**2).sum() / 0.1), rel=1e-9)
    null = np.linalg.svd(by_hand(closed.q[:-1])[1])[2][:, 2]
    around = np.roll(change, 1, axis=0)  # at each sample
    bent = np.roll(around, 1, axis=0) - 2.0 * around + np.roll(around, -1, axis=0)
    assert np.abs(np.einsum("kj,kj->k", null, bent)).max() < 1e-5


def test_among_paths_as_good_the_smoothest(arm: cr.Arm, line: cr.TaskPath) -> None:
    """A thousandth of the least w buys a lower peak rate, a thousandth of that one smaller accelerations."""
    start = start_at(line, 0, 240)
    sharp = cr.track_globally(arm, line, start, dt=0.05, slack=0.0, count=2)
    calm = cr.track_globally(arm, line, start, dt=0.05, count=2)
    assert (len(sharp.solutions), len(calm.solutions)) == (1, 3)
    assert sharp.value * (1.0 - 1.1e-3) <= calm.value <= sharp.value * (1.0 + 1e-6)
    assert calm.run.peak_rate <= sharp.run.peak_rate * (1.0 + 1e-6)
    sizes = [float((np.diff(found.q, 2, axis=0) ** 2).sum()) for found in (calm, sharp)]
    assert sizes[0] < 0.9 * sizes[1]


def test_limits_of_position_rate_and_acceleration_are_kept(arm: cr.Arm, line: cr.TaskPath) -> None:
    start = start_at(line, 0, 440)
    free = cr.track_globally(arm, line, start, dt=0.05, count=3, objective="integral of criterion")
    rates = np.diff(free.q, axis=0) / 0.05
    low, high = free.q.min(axis=0), free.q.max(axis=0)
    position = [(low[0] - 1.0, high[0] + 1.0), (low[1] + 0.05, high[1] + 1.0), (low[2] - 1.0, high[2] + 1.0)]
    velocity = [0.95 * np.abs(rates).max()] * 3
    acceleration = [0.8 * np.abs(np.diff(rates, axis=0)).max() / 0.05] * 3
    limited = arm.with_limits(position=position, velocity=velocity, acceleration=acceleration)
    found = cr.track_globally(limited, line, start, dt=0.05, count=3, objective="integral of criterion")
    assert found.solved
    rates = np.diff(found.q, axis=0) / 0.05
    assert (found.q >= np.array(position)[:, 0] - 1e-7).all() and (found.q <= np.array(position)[:, 1] + 1e-7).all()
    assert np.abs(rates).max() <= velocity[0] + 1e-6
    assert np.abs(np.diff(rates, axis=0) / 0.05).max() <= acceleration[0] + 1e-4
    assert found.value > free.value
    assert (
        np.abs(
            cr.track_globally(limited, line, start, dt=0.05, count=3, objective="integral of criterion", limits=False).q
            - free.q
        ).max()
        < 1e-9
    )


@pytest.mark.parametrize("fixed", [True, False])
def test_a_cyclic_path_closes(arm: cr.Arm, fixed: bool) -> None:
    path = cr.TaskPath.circle((0.9, 0.3), 0.3, duration=2.0)
    start = start_at(path, 0, 60)
    open_ended = cr.track_globally(arm, path, start, dt=0.1, count=3, objective="squared rates", fixed_start=fixed)
    closed = cr.track_globally(
        arm, path, start, dt=0.1, count=3, objective="squared rates", fixed_start=fixed, cyclic=True
    )
    turns = (closed.q[-1] - closed.q[0]) / (2.0 * np.pi)
    np.testing.assert_allclose(turns, np.round(turns), rtol=0, atol=1e-12)
    assert np.abs(open_ended.q[-1] - open_ended.q[0]).max() > 1e-3
    assert closed.value > open_ended.value
    np.testing.assert_allclose(arm.position(closed.q), path.sample(closed.run.t, "position").held, rtol=0, atol=1e-8)


def test_a_pose_path_of_the_8r_arm_keeps_clear_of_singularities() -> None:
    """The thesis' arc: gradient projection with a gain of -2 comes to w = .0194; pushed by nothing, to .0016."""
    arm = cr.load("sanchez_8r")
    arc = cr.TaskPath.arc((0.0, 0.05, -0.25), 0.25, x=(1.0, 0.0, 0.0), y=(0.0, 0.0, 1.0), duration=2.0)
    found = cr.track_globally(arm, arc, POSTURE_A, dt=2.0 / 90, count=3)
    assert found.solved
    values = np.linalg.svd(arm.jacobian(found.q), compute_uv=False).prod(axis=-1)
    assert values.min() >= 0.0260
    assert np.abs(np.diff(found.q, axis=0)).max() / found.run.dt <= 2.42
    pose, wanted = arm.pose(found.q), arm.pose(POSTURE_A)
    theta = np.linspace(0.0, np.pi, 91)
    points = np.array([0.0, 0.05, -0.25]) + 0.25 * np.stack([np.cos(theta), 0.0 * theta, np.sin(theta)], axis=-1)
    np.testing.assert_allclose(pose[:, :3, 3], points, rtol=0, atol=1e-7)
    np.testing.assert_allclose(pose[:, :3, :3], np.broadcast_to(wanted[:3, :3], (91, 3, 3)), rtol=0, atol=1e-7)
    assert found.between is not None
    middle = arm.position(0.5 * (found.q[1:] + found.q[:-1]))
    theta = 0.5 * (theta[1:] + theta[:-1])
    points = np.array([0.0, 0.05, -0.25]) + 0.25 * np.stack([np.cos(theta), 0.0 * theta, np.sin(theta)], axis=-1)
    missed = np.linalg.norm(middle - points, axis=-1).max()
    assert missed <= found.between.position * (1.0 + 1e-6) and found.between.position < 1e-3


def test_twice_the_same_and_from_given_solutions(arm: cr.Arm, line: cr.TaskPath) -> None:
    start = start_at(line, 1, 440)
    first, second = (cr.track_globally(arm, line, start, dt=0.1, count=4) for _ in range(2))
    np.testing.assert_array_equal(first.q, second.q)
    local = cr.track(arm, line, start, dt=0.1).q
    given = cr.track_globally(arm, line, np.stack([local, first.q]), dt=0.1, count=0)
    assert len(given.values) == 2 and given.agreed >= 1
    assert given.value == pytest.approx(first.value, rel=1e-3)
    json.dumps(given.to_dict(), allow_nan=False)


def test_a_fine_mesh_comes_from_a_coarse_one(arm: cr.Arm, line: cr.TaskPath) -> None:
    lines: list[str] = []
    found = cr.track_globally(arm, line, start_at(line, 0, 440), dt=0.005, count=1, progress=lines.append)
    assert found.solved and len(found.q) == 201
    assert any("61 samples" in text for text in lines) and any("201 samples" in text for text in lines)
    np.testing.assert_allclose(by_hand(found.q)[0], targets_of(line, 200)[1], rtol=0, atol=1e-8)
    assert np.abs(np.diff(found.q, axis=0)).max() < 0.02


def test_as_many_joints_as_rows_leave_one_path(arm: cr.Arm) -> None:
    start = np.array([0.3, 0.8, -0.5])
    path = cr.TaskPath.line(by_hand(start)[0], by_hand(start)[0] - 0.1, duration=1.0).holding(float(start.sum()))
    found = cr.track_globally(arm, path, start, dt=0.1, task="pose", objective="squared rates", count=1)
    np.testing.assert_allclose(by_hand(found.q)[0], path.sample(found.run.t, "position").held, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.q.sum(axis=1), start.sum(), rtol=0, atol=1e-8)


def interrupted_at(word: str) -> Any:
    def progress(line: str) -> None:
        if word in line:
            raise KeyboardInterrupt

    return progress


def test_an_interrupted_search_gives_the_best_so_far_or_ends(arm: cr.Arm, line: cr.TaskPath) -> None:
    start = start_at(line, 0, 440)
    with pytest.raises(KeyboardInterrupt):
        cr.track_globally(arm, line, start, dt=0.1, progress=interrupted_at("start 2"))
    found = cr.track_globally(arm, line, start, dt=0.1, count=2, progress=interrupted_at("least peak"))
    assert isinstance(found, GlobalRun) and found.interrupted and not found.solved
    assert "interrupted" in found.text and "no optimum is claimed" in found.text
    np.testing.assert_allclose(by_hand(found.q)[0], targets_of(line, 10)[1], rtol=0, atol=1e-8)


START = [0.4, 1.0, -1.5]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"objective": "fastest"}, "objective: 'fastest'; max min w"),
        ({"criterion": "limits"}, "criterion: 'limits'; H, 1/H"),
        ({"slack": 1.0}, "slack: 1; a share from 0"),
        ({"most_rate": 0.0}, "most_rate: 0"),
        ({"count": 0}, "count: 0; a whole number, 1 or more"),
        ({"q_start": [0.0, 0.0]}, "q_start: shape (2,)"),
        ({"q_start": np.zeros((4, 3))}, "q_start: 4 samples; 11"),
        ({"q_start": [0.0, 0.5, 0.5]}, "q_start: its tip misses the first target by"),
        ({"cyclic": True}, "cyclic: the path does not end where it begins"),
        ({"t": [0.0, 0.5, 0.4]}, "t: shape (3,); three or more rising times"),
        ({"path": np.zeros((3, 2))}, "t: targets in samples come with their times"),
        ({"path": np.zeros((3, 2)), "t": [0.0, 1.0, 2.0, 3.0], "dt": None}, "path: shape (3, 2); (4, 2), a target"),
        ({"path": cr.TaskPath.line((1.5, 0.0), (2.0, 0.0), duration=1.0), "q_start": None}, "none of 12 starts leads"),
    ],
)
def test_what_is_not_accepted_is_said(arm: cr.Arm, line: cr.TaskPath, change: Any, message: str) -> None:
    given = {"path": line, "q_start": start_at(line, 0, 440), "dt": 0.1, **change}
    with pytest.raises(cr.InputError) as caught:
        cr.track_globally(arm, given.pop("path"), **given)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_limits_that_no_path_keeps_are_said(arm: cr.Arm, line: cr.TaskPath) -> None:
    slow = arm.with_limits(velocity=[0.3] * 3)
    with pytest.raises(cr.InputError, match="holds every target within the limits"):
        cr.track_globally(slow, line, start_at(line, 0, 440), dt=0.1, count=2)
    start = start_at(line, 0, 440)
    low = arm.with_limits(position=[(start[0] + 0.1, 3.0), (-4.0, 4.0), (-4.0, 4.0)])
    with pytest.raises(cr.InputError, match=r"q_start: joint '.*' is outside its limits"):
        cr.track_globally(low, line, start, dt=0.1)


def test_the_generated_functions_as_casadi_functions(arm: cr.Arm) -> None:
    import casadi as ca

    model, q, target = arm.description.model, np.array([0.4, 1.1, -0.6]), np.array([0.3, 0.2])
    function = casadi_function(model, "redundancy_position", "step_position", ("error", "manipulability"))
    assert function.name_in() == ["q", "held", "parameters"]
    x = ca.SX.sym("q", 3)
    error, w = function(x, ca.DM(target), ca.DM(arm.parameters))
    found = [np.array(each) for each in ca.Function("f", [x], [error, ca.jacobian(error, x), w])(q)]
    position, jacobian, expected = by_hand(q)
    np.testing.assert_allclose(found[0][:, 0], position - target, rtol=0, atol=1e-15)
    np.testing.assert_allclose(found[1], jacobian, rtol=0, atol=1e-15)
    assert found[2][0, 0] == pytest.approx(expected, rel=1e-13)
    for name, outputs in (("nothing", ("error",)), ("step_position", ("nothing",))):
        with pytest.raises(cr.GenerationError, match="nothing"):
            casadi_function(model, "redundancy_position", name, outputs)
