"""Following paths: integrators, limits, events, starts, batches, the thesis' yardsticks; refusals."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import linprog, minimize

import chainrule as cr
from chainrule.errors import InputError
from chainrule.redundancy.limited import Box, Program, box, braking
from chainrule.redundancy.measure import errors
from chainrule.redundancy.result import EVENTS
from chainrule.redundancy.samples import circle_through
from chainrule.redundancy.stability import decay
from chainrule.redundancy.starts import best, bring, postures_at
from chainrule.redundancy.step import Damping, Law, Stepper

THESIS = cr.load("sanchez_8r")
PANDA = cr.load("panda")
PLANAR = cr.planar_3r(1.0, 0.5, 0.25)

# start postures of the README of the papers (found by search; they prove existence, nothing more), rad
A = [-1.873731004463, -1.816784929574, -2.610767475187, 2.197077859614]
A += [-1.287777812569, 1.434014115789, 1.595985198549, -2.679241147511]
B = [1.609813802256, -0.232299026129, -2.186365553699, -0.941491016391]
B += [0.461419321006, 0.278709676276, 2.319829892885, -1.050383487685]
C = [-1.53668959001, -2.920792707402, 3.022548791608, -1.664516093498]
C += [-0.927860291821, -1.06738746154, 0.87794418847, -1.607968946038]
E = [0.356683909626, -0.678181398008, 2.920983371925, -2.897123090552]
E += [-0.419316528329, -0.004363446089, -0.777582490943, -2.014754810326]
L = [2.347162607434, 0.690084145544, 0.108517563932, -2.403259386128]
L += [-3.111707060913, 0.311795321069, -0.359757615609, -2.250603423303]

ARC = cr.TaskPath.arc((0.0, 0.05, -0.25), 0.25, end=np.pi, y=(0.0, 0.0, 1.0), duration=2.0)
CIRCLE = cr.TaskPath.circle((0.1, 0.6, -0.25), 0.30, y=(0.0, 0.0, 1.0), duration=2.0)
LINE = cr.TaskPath.line((-0.5, 0.2, -0.5), (0.5, 0.2, 0.5), duration=2.0)
FLAT = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
FLAT_START = [-0.38432451, 2.40486314, 0.0044545]


def flat_start() -> Any:
    return bring(PLANAR, "position", np.array([0.6, 0.3]), np.array([FLAT_START]))[0][0]


def panda_line(seed: int, length: float = 0.3, duration: float = 0.8) -> tuple[cr.TaskPath, Any]:
    """A random line from a random posture inside the limits."""
    rng = np.random.default_rng(seed)
    low, high = PANDA.limits.position.T
    q = (low + high) / 2.0 + rng.uniform(-0.5, 0.5, 7) * (high - low) / 2.0
    way = rng.normal(size=3)
    start = PANDA.position(q)
    return cr.TaskPath.line(start, start + length * way / np.linalg.norm(way), duration=duration), q


# ---- the law in time ---------------------------------------------------------------------------------------------


def test_the_integrators_have_their_orders() -> None:
    """Against DOP853 at 1e-12 on the law written out with pinv and the exact gradient."""
    path, q0 = panda_line(5, 0.2, 1.0)
    held = path.holding(PANDA.pose(q0)[:3, :3])

    def law(t: float, q: Any) -> Any:
        jacobian = PANDA.jacobian(q)
        pseudo = np.linalg.pinv(jacobian)
        slope = PANDA.manipulability_gradient(q, criterion="H^(-1/2)")
        return pseudo @ held.sample([min(t, 1.0)]).velocity[0] - 2.0 * (slope - pseudo @ (jacobian @ slope))

    end = solve_ivp(law, (0.0, 1.0), q0, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    options: dict[str, Any] = {"gain": -2.0, "feedback": 0.0}
    cases: Any = (("euler", 1, (200, 400)), ("heun", 2, (100, 200)), ("rk4", 4, (40, 80)))
    for integrator, order, counts in cases:
        misses = [
            np.abs(cr.track(PANDA, path, q0, integrator=integrator, dt=1.0 / n, **options).q[-1] - end).max()
            for n in counts
        ]
        assert abs(np.log2(misses[0] / misses[1]) - order) < 0.2, (integrator, misses)
    exact = cr.track(PANDA, path, q0, integrator="dop853", dt=0.1, **options)
    assert np.abs(exact.q[-1] - end).max() < 1e-9 and len(exact.t) == 11


def test_null_motion_leaves_the_tip_alone_and_the_rest_does_the_task() -> None:
    run = cr.track(THESIS, ARC, A, gain=-2.0, dt=0.01)
    jacobian = THESIS.jacobian(run.q)
    moved = np.einsum("kij,kj->ki", jacobian, run.null_motion)
    assert np.abs(moved).max() < 1e-13 * np.abs(run.null_motion).max() * np.abs(jacobian).max() * 100.0
    assert np.abs(run.null_motion).max() > 0.1
    velocity = ARC.holding(THESIS.pose(np.array(A))[:3, :3]).sample(run.t).velocity
    wanted = velocity - 0.5 / run.dt * np.concatenate(
        [run.position_error, 2.0 * np.sin(run.orientation_error / 2.0)], axis=1
    )
    np.testing.assert_allclose(np.einsum("kij,kj->ki", jacobian, run.rates), wanted, atol=1e-9)


def test_what_a_run_says_of_the_tip() -> None:
    run = cr.track(THESIS, ARC, A, gain=-2.0, dt=0.05)
    tip, held = THESIS.pose(run.q), run.held
    np.testing.assert_allclose(run.position_error, tip[:, :3, 3] - held[:, :3, 3], atol=1e-15)
    np.testing.assert_allclose(run.frame_errors[:, 3], np.linalg.norm(run.position_error, axis=1), atol=1e-15)
    for axis in range(3):
        np.testing.assert_allclose(
            run.frame_errors[:, axis], np.linalg.norm(tip[:, :3, axis] - held[:, :3, axis], axis=1), atol=1e-15
        )
    angle = np.linalg.norm(run.orientation_error, axis=1)
    trace = np.trace(tip[:, :3, :3] @ np.swapaxes(held[:, :3, :3], 1, 2), axis1=1, axis2=2)
    np.testing.assert_allclose(2.0 * np.sin(angle / 2.0) ** 2, (3.0 - trace) / 2.0, atol=1e-14)
    values = np.linalg.svd(THESIS.jacobian(run.q), compute_uv=False)
    np.testing.assert_allclose(run.manipulability, values.prod(axis=1), rtol=1e-11)
    np.testing.assert_allclose(run.determinant, run.manipulability**2, rtol=1e-15)
    np.testing.assert_allclose(run.accelerations[1:-1], (run.rates[2:] - run.rates[:-2]) / (2.0 * run.dt), rtol=1e-9)
    assert run.torque is not None
    np.testing.assert_allclose(run.torque[3], THESIS.inverse_dynamics(run.q[3], run.rates[3], run.accelerations[3]))


def test_a_run_as_plain_values() -> None:
    run = cr.track(PLANAR, FLAT, flat_start(), task="position", dt=0.1)
    plain = json.loads(json.dumps(run.to_dict(), allow_nan=False))
    assert plain["status"] == "complete" and plain["frame_errors"][0][0] is None and plain["torque"] is None
    assert plain["masses"] is None
    assert cr.track(THESIS, ARC, A, dt=0.5).to_dict()["masses"].startswith("assumed link masses 3, 2.5, 2")
    headings, rows = run.rows()
    assert len(headings) == len(set(headings)) and {len(row) for row in rows} == {len(headings)}
    assert len(rows) == 11 and rows[3][headings.index("q2")] == run.q[3, 1]


def test_a_position_of_an_angle_in_the_plane_is_followed_too() -> None:
    q0 = np.array([0.3, 0.8, -0.5])
    tip = PLANAR.pose(q0)
    x, alpha = float(tip[0, 2]), float(q0.sum())
    path = cr.TaskPath.line((x, 0.0), (x - 0.3, 0.0), duration=1.0, orientation=[alpha, alpha + 1.0])
    run = cr.track(PLANAR, path, q0, task="x_alpha", criterion="H", gain=0.1, integrator="rk4")
    assert run.position_error.shape[1] == 1 and run.orientation_error.shape[1] == 1
    np.testing.assert_allclose(run.q[-1].sum(), alpha + 1.0, atol=1e-6)
    assert abs(PLANAR.position(run.q[-1])[0] - (x - 0.3)) < 1e-6
    assert np.abs(run.frame_errors[:, :2]).max() < 1e-5 and (run.frame_errors[:, 2] == 0.0).all()


def test_weights_hold_a_joint_still_and_damping_bounds_the_rates() -> None:
    weights = [1.0] * 8
    weights[2] = np.inf
    run = cr.track(THESIS, ARC.timed(duration=2.0), A, gain=-2.0, dt=0.02, weights=weights)
    assert np.abs(run.q[:, 2] - A[2]).max() == 0.0
    outwards = cr.TaskPath.line((1.2, 0.0), (1.9, 0.0), duration=1.0)  # beyond the reach of 1.75
    start = bring(PLANAR, "position", np.array([1.2, 0.0]), np.array([[0.5, -0.6, -0.6]]))[0][0]
    damped = cr.track(PLANAR, outwards, start, gain=0.0, damping=Damping("constant", 0.1), feedback=5.0, dt=0.002)
    assert damped.status == "complete" and damped.peak_rate < 20.0
    undamped = cr.track(PLANAR, outwards, start, gain=0.0, feedback=5.0, dt=0.002)
    assert undamped.status == "stopped" or undamped.peak_rate > 100.0


def test_a_secondary_task_and_a_push() -> None:
    """The 8R arm, whose pose task leaves two joints: the third one moves as it is told."""
    row = np.eye(1, 8, 2)
    options: dict[str, Any] = {"gain": 0.0, "dt": 0.01}
    secondary = cr.track(THESIS, ARC, A, method="priority", secondary=lambda t, q: (row, np.zeros(1)), **options)
    held = cr.track(THESIS, ARC, A, weights=np.where(row[0] == 1.0, np.inf, 1.0), **options)
    np.testing.assert_allclose(secondary.q, held.q, atol=1e-6)  # to stand still by priority, and by weight
    moved = cr.track(THESIS, ARC, A, method="priority", secondary=lambda t, q: (row, np.array([0.05])), **options)
    np.testing.assert_allclose(moved.rates[:, 2], 0.05, atol=1e-9)
    tip = np.einsum("kij,kj->ki", THESIS.jacobian(moved.q), moved.rates)[:, :3]
    velocity = ARC.sample(moved.t, "position").velocity
    np.testing.assert_allclose(tip, velocity - 50.0 * moved.position_error, atol=1e-8)
    pushed = cr.track(
        THESIS,
        ARC,
        A,
        gain=0.0,
        dt=0.01,
        push=lambda t, q: -2.0 * THESIS.manipulability_gradient(q, criterion="H^(-1/2)"),
    )
    np.testing.assert_allclose(pushed.q, cr.track(THESIS, ARC, A, gain=-2.0, dt=0.01).q, atol=1e-9)


def test_a_closed_path_closes_at_the_tip_and_with_a_large_gain_in_the_joints() -> None:
    """With a large gain the posture follows the best one of each target, which comes back with the target."""
    start = cr.best_posture(PLANAR, [1.1, 0.2]).q
    circle = cr.TaskPath.circle((0.9, 0.2), 0.2, duration=2.0)
    gaps = []
    for gain in (0.0, 100.0, 300.0):
        run = cr.track(PLANAR, circle, start, task="position", gain=gain, criterion="H", integrator="rk4", dt=0.004)
        np.testing.assert_allclose(PLANAR.position(run.q[-1]), [1.1, 0.2], atol=1e-6)
        gaps.append(float(np.abs(run.q[-1] - run.q[0]).max()))
    assert gaps[0] > 0.01 and gaps[2] < 0.4 * gaps[1] and gaps[2] < 0.005  # in inverse proportion to the gain


# ---- the thesis --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("path", "start", "w", "rate", "error"),
    [(ARC, A, 0.0194, 2.31, 8e-6), (CIRCLE, E, 0.0095, 6.99, 9e-5)],
    ids=["A", "E"],
)
def test_the_yardsticks_of_gradient_projection(
    path: cr.TaskPath, start: list[float], w: float, rate: float, error: float
) -> None:
    run = cr.track(THESIS, path, start, gain=-2.0, criterion="H^(-1/2)", dt=0.0067)
    assert run.status == "complete" and len(run.t) == 300
    assert run.min_manipulability == pytest.approx(w, abs=5e-5)
    assert run.peak_rate == pytest.approx(rate, rel=5e-3)
    assert run.final_position_error == pytest.approx(error, rel=0.1)


def test_the_line_is_where_the_local_law_fails() -> None:
    run = cr.track(THESIS, LINE, L, gain=-2.0, dt=0.0067)
    assert run.peak_rate > 36.0 and 0.01 < run.final_position_error < 0.05
    told = cr.forecast(THESIS, LINE, L, -2.0, dt=0.0067)
    assert not told.good and told.best is None and "nor with any other" in told.text
    assert cr.forecast(THESIS, ARC, A, -2.0, dt=0.0067).good


def test_the_line_is_followed_by_the_local_law_inside_limits() -> None:
    arm = THESIS.with_limits(velocity=[3.0] * 8, acceleration=[20.0] * 8)
    run = cr.track(arm, LINE, L, gain=-2.0, dt=0.0067, limits=True)
    assert run.status == "complete" and run.peak_rate <= 3.0 and run.worst_position_error < 1e-3
    assert run.t[-1] < 2.5
    arm = THESIS.with_limits(velocity=[10.0] * 8)
    run = cr.track(arm, LINE, L, method="pseudoinverse", dt=0.002, limits=True)
    assert run.status == "complete" and run.peak_rate <= 10.0 and run.worst_position_error < 2e-4
    assert (run.scale == 1.0).all() and len(run.t) == 1001  # saturated in the null space, not slowed down


@pytest.mark.parametrize("start", [A, B, C], ids=["A", "B", "C"])
def test_without_gain_the_arc_nears_a_singularity_and_with_it_keeps_away(start: list[float]) -> None:
    plain = cr.track(THESIS, ARC, start, method="pseudoinverse", dt=0.002)
    assert plain.t[int(plain.manipulability.argmin())] == pytest.approx(1.27, abs=0.02)
    assert plain.determinant.min() < 5e-5
    assert any(event.kind == "singularity near" for event in plain.events)
    helped = cr.track(THESIS, ARC, start, gain=-2.0, dt=0.002)
    assert helped.determinant.min() > 3.5e-4


# ---- limits ------------------------------------------------------------------------------------------------------


def brake(rate: float, most: float, dt: float) -> float:
    """How far a joint still goes: this step at ``rate``, then the largest deceleration; summed up."""
    way = 0.0
    while rate > 0.0:
        way += rate * dt
        rate -= most * dt
    return way


def test_the_braking_rate_is_the_largest_that_stops_in_time() -> None:
    rng = np.random.default_rng(2)
    for _ in range(200):
        room, most, dt = 10.0 ** rng.uniform(-4, 1), 10.0 ** rng.uniform(-1, 2), 10.0 ** rng.uniform(-3, -1)
        rate = float(braking(np.array([room]), np.array([most]), dt)[0])
        assert brake(rate * (1.0 - 1e-9), most, dt) <= room < brake(rate * (1.0 + 1e-9), most, dt)
    np.testing.assert_allclose(braking(np.array([0.0, np.inf]), np.array([1.0, 1.0]), 0.1), [0.0, np.inf])


def test_the_box_is_never_empty_after_a_step_inside_it() -> None:
    rng = np.random.default_rng(3)
    arm = PANDA.with_limits(acceleration=[3.0, 5.0, 7.0, 1.0, 2.0, 9.0, 4.0])
    low, high = arm.limits.position.T
    q, before, dt = rng.uniform(low, high), np.zeros(7), 0.01
    for _ in range(3000):
        room = box(arm.limits, q, before, dt)
        assert (room.low <= room.high).all()
        before = np.where(rng.uniform(size=7) < 0.9, room.high, room.low)  # as fast as can be, mostly upwards
        q = q + dt * before
        assert (q <= high + 1e-12).all() and (q >= low - 1e-12).all()


def test_a_step_inside_limits_is_the_solution_of_its_program() -> None:
    """The share against HiGHS; the rates against SLSQP on the same program with the share fixed."""
    rng = np.random.default_rng(4)
    weights = rng.uniform(0.5, 2.0, 8)
    program = Program(weights)
    scaled = 0
    for _ in range(40):
        jacobian, null = rng.normal(size=(6, 8)), rng.normal(size=8)
        null -= np.linalg.pinv(jacobian) @ (jacobian @ null)
        velocity = jacobian @ rng.normal(size=8) * 0.7
        room = Box(-rng.uniform(0.2, 1.5, 8), rng.uniform(0.2, 1.5, 8), np.zeros(8, int), np.zeros(8, int))
        found = program(jacobian, velocity, null, room, 1.0)
        assert found is not None
        rates, share = found
        assert (rates >= room.low).all() and (rates <= room.high).all()
        np.testing.assert_allclose(jacobian @ rates, share * velocity, atol=1e-9)
        most = linprog(
            np.append(np.zeros(8), -1.0),
            A_eq=np.column_stack([jacobian, -velocity]),
            b_eq=np.zeros(6),
            bounds=[*zip(room.low, room.high, strict=True), (0.0, 1.0)],
        )
        assert share == pytest.approx(-most.fun, abs=1e-6)
        scaled += share < 1.0
        if share == 1.0:
            other = minimize(
                lambda x, aim=null: (weights * (x - aim) ** 2).sum(),
                rates,
                jac=lambda x, aim=null: 2.0 * weights * (x - aim),
                method="SLSQP",
                bounds=[*zip(room.low, room.high, strict=True)],
                constraints={"type": "eq", "fun": lambda x, a=jacobian, b=velocity: a @ x - b},
                options={"ftol": 1e-14, "maxiter": 200},
            )
            np.testing.assert_allclose(rates, other.x, atol=1e-5)
    assert 5 < scaled < 35
    tight = Box(np.full(8, 0.5), np.full(8, 0.6), np.zeros(8, int), np.zeros(8, int))
    assert program(np.eye(6, 8), np.array([1.0, -1.0, 0.0, 0.0, 0.0, 0.0]), np.zeros(8), tight, 1.0) is None


def assert_inside(run: cr.Run) -> None:
    """No limit is exceeded at a sample or between two: rates are constant in a step."""
    limits = run.arm.limits
    low, high = limits.position.T
    assert (run.q >= low - 1e-12).all() and (run.q <= high + 1e-12).all()
    assert (np.abs(run.rates) <= limits.velocity).all()
    steps = np.diff(run.t)
    np.testing.assert_allclose(np.diff(run.q, axis=0), run.rates[:-1] * steps[:, None], atol=1e-12)
    jumps = np.diff(run.rates, axis=0, prepend=np.zeros((1, run.arm.n)))
    assert (np.abs(jumps) <= limits.acceleration * run.dt + 1e-12).all()


@pytest.mark.parametrize("seed", range(8))
def test_limits_are_never_exceeded_and_the_path_is_not_left(seed: int) -> None:
    path, q0 = panda_line(seed, 0.25, (0.25, 0.5, 1.0)[seed % 3])
    run = cr.track(PANDA, path, q0, gain=-2.0, dt=0.005, limits=True)
    assert_inside(run)
    tip = PANDA.position(run.q)
    ends = path.sample([0.0, path.duration], "position").held
    way = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    away = tip - ends[0]
    off = np.linalg.norm(away - (away @ way)[:, None] * way, axis=1)
    assert off.max() < 1e-3
    assert run.worst_orientation_error < 1e-2
    if run.status == "complete":
        assert run.final_position_error < 1e-3 and np.linalg.norm(tip[-1] - ends[1]) < 1e-3
    else:
        assert "limits leave no motion" in run.reason
    if run.scale[:-1].min() < 0.9:
        assert any(event.kind == "task scaled" for event in run.events)
        assert any(event.kind == "limit met" for event in run.events)


def test_limits_in_the_plane_and_paths_that_end_at_a_limit() -> None:
    start = flat_start()
    turns = [(-1.0, 1.0), (start[1] - 0.3, 3.0), (-1.0, 1.0)]
    arm = PLANAR.with_limits(position=turns, velocity=[1.0] * 3, acceleration=[5.0] * 3)
    run = cr.track(arm, FLAT, start, task="position", gain=0.0, criterion="H", dt=0.01, limits=True)
    assert_inside(run)
    free = cr.track(PLANAR, FLAT, start, task="position", gain=0.0, criterion="H", dt=0.01)
    assert free.q[:, 1].min() < turns[1][0] - 0.1  # the limit matters
    if run.status == "stopped":
        assert "position limit" in run.reason
    assert any("position limit" in event.text for event in run.events)


def test_what_had_to_go_back_is_not_much_slower_than_it_need_be() -> None:
    """Against the least time of the free motion; going back alone takes three times as long."""
    pytest.importorskip("toppra")
    q = [0.3, -0.8, 0.0, -2.3, 0.0, 1.6, 0.8]
    circle = circle_through(PANDA, q, 0.15, 1.0)
    least = cr.fastest_run(cr.track(PANDA, circle, q, integrator="rk4", dt=0.01), circle).t[-1]
    run = cr.track(PANDA, circle, q, dt=0.01, limits=True)
    assert run.status == "complete" and least <= run.t[-1] < 1.6 * least
    assert (np.abs(run.accelerations) <= PANDA.limits.acceleration * (1.0 + 1e-9)).all()


def test_without_need_limits_change_nothing() -> None:
    arm = THESIS.with_limits(position=[(-9.0, 9.0)] * 8, velocity=[50.0] * 8)
    kept = cr.track(arm, ARC, A, gain=-2.0, dt=0.01, limits=True)
    free = cr.track(THESIS, ARC, A, gain=-2.0, dt=0.01)
    np.testing.assert_allclose(kept.q, free.q, atol=1e-12)
    assert (kept.scale == 1.0).all() and not any(event.kind == "task scaled" for event in kept.events)


# ---- events ------------------------------------------------------------------------------------------------------


def test_a_gain_too_large_is_said_before_it_diverges() -> None:
    start = flat_start()
    options: dict[str, Any] = {"task": "position", "criterion": "H", "dt": 0.01}
    calm = cr.track(PLANAR, FLAT, start, gain=1000.0, **options)
    assert calm.status == "complete" and not calm.events
    wild = cr.track(PLANAR, FLAT, start, gain=1800.0, **options)
    assert wild.status == "stopped"
    kinds = [event.kind for event in wild.events]
    assert kinds.index("gain too large") < kinds.index("rates too large")
    assert wild.reason.endswith(f"gain too large from {wild.events[0].t:.4g} s on")
    at_once = cr.track(PLANAR, FLAT, start, gain=1e7, **options)
    assert [event.kind for event in at_once.events[:2]] == ["gain too large", "rates too large"]
    assert wild.events[0].t < 0.6 * wild.t[-1]
    stepper = Stepper(PLANAR, Law({"H": 1.0}), "position")
    rho = decay(stepper, calm.q[::10], calm.held[::10])
    assert 1000.0 < (2.0 / (0.01 * rho)).min() < 1800.0  # the bound lies between the two


def test_the_decay_rate_is_that_of_the_flow() -> None:
    """A posture displaced from the best one along its self-motion comes back at the rate that is estimated."""
    target = np.array([1.0, 0.0])
    best_q = cr.best_posture(PLANAR, target).q
    stepper = Stepper(PLANAR, Law({"H": 1.0}, feedback=(50.0, 50.0)), "position")
    rate = float(decay(stepper, best_q[None], target[None])[0])
    null = PLANAR.null_vector(best_q) / np.linalg.norm(PLANAR.null_vector(best_q))
    q = bring(PLANAR, "position", target, (best_q + 1e-3 * null)[None])[0][0]
    flow = solve_ivp(lambda t, x: stepper(x, target, None, 0.0).rates, (0.0, 5.0), q, rtol=1e-10, atol=1e-12)
    gone = [np.linalg.norm(flow.y[:, k] - best_q) for k in (0, -1)]
    assert np.log(gone[0] / gone[1]) / 5.0 == pytest.approx(rate, rel=5e-3)


def test_runs_that_cannot_go_on_stop_with_a_reason() -> None:
    outwards = cr.TaskPath.line((1.2, 0.0), (2.5, 0.0), duration=1.0)
    start = bring(PLANAR, "position", np.array([1.2, 0.0]), np.array([[0.5, -0.6, -0.6]]))[0][0]
    for integrator in ("euler", "heun", "rk4", "dop853"):
        run = cr.track(PLANAR, outwards, start, gain=0.0, integrator=integrator, stop_rate=30.0, dt=0.01)
        assert run.status == "stopped" and run.t[-1] < 1.0 and np.isfinite(run.q).all(), integrator
        assert run.reason.startswith("at ") and run.events
    nan = cr.track(PLANAR, FLAT, flat_start(), dt=0.1, push=lambda t, q: np.full(3, np.inf if t > 0.45 else 0.0))
    assert nan.status == "stopped" and nan.events[-1].kind == "not finite" and np.isfinite(nan.rates).all()
    assert nan.t[-1] == pytest.approx(0.4)
    loud = cr.track(PLANAR, FLAT, flat_start(), dt=0.1, feedback=50.0, gain=0.0)
    assert any("feedback" in event.text for event in loud.events)
    slow = PLANAR.with_limits(velocity=[1.0] * 3)
    kept = cr.track(slow, FLAT, flat_start(), task="position", dt=0.1, feedback=50.0, gain=0.0, limits=True)
    assert any("feedback" in event.text for event in kept.events)


def test_a_path_that_is_left_is_said() -> None:
    """The arm reaches as far as 1.75 m; what is damped or has no feedback goes on without the path."""
    outwards = cr.TaskPath.line((1.2, 0.0), (2.0, 0.0), duration=1.0)
    start = bring(PLANAR, "position", np.array([1.2, 0.0]), np.array([[0.5, -0.6, -0.6]]))[0][0]
    for options in ({"damping": Damping("constant", 0.1)}, {"damping": Damping("constant", 0.1), "feedback": 0.0}):
        run = cr.track(PLANAR, outwards, start, gain=0.0, dt=0.01, **options)
        assert run.status == "complete" and "of its target" not in run.reason
        assert run.reason.startswith("the end of the path's time was reached, the tip ")
        left = next(event for event in run.events if event.kind == "path left")
        away = np.linalg.norm(run.position_error, axis=1)
        assert away[run.t >= left.t].min() > 0.008 >= away[run.t < left.t].max()  # a hundredth of 0.8 m
        assert left.t <= 0.55 / 0.8 + 0.03
    stays = cr.track(PLANAR, FLAT, flat_start(), task="position", dt=0.01)
    assert not stays.events and stays.reason == "the end of the path was reached"


def test_limits_that_are_not_asked_for_are_said_to_be_passed() -> None:
    q = flat_start()
    free = cr.track(PLANAR, FLAT, q, task="position", dt=0.01)
    low, high = free.q.min(axis=0), free.q.max(axis=0)
    top = np.array([(-9.0, 9.0), (-9.0, 9.0), (low[2] - 1.0, high[2] - 0.01)])
    most = np.array([9.0, 9.0, 9.0])
    most[0] = 0.9 * np.abs(free.rates[:, 0]).max()
    run = cr.track(PLANAR.with_limits(position=top, velocity=most), FLAT, q, task="position", dt=0.01)
    np.testing.assert_array_equal(run.q, free.q)
    told = {event.text.split("'")[1]: event for event in run.events if event.kind == "limit passed"}
    assert sorted(told) == ["joint1", "joint3"]
    assert told["joint3"].t == free.t[(free.q[:, 2] > high[2] - 0.01).argmax()]
    assert "position limit, by up to 0.01 rad" in told["joint3"].text
    assert told["joint1"].t == free.t[(np.abs(free.rates[:, 0]) > most[0]).argmax()]
    assert "velocity limit" in told["joint1"].text and told["joint1"].text.endswith("rad/s")


# ---- starts ------------------------------------------------------------------------------------------------------


def test_starts_are_at_the_start_and_the_best_is_a_maximum() -> None:
    path = ARC.holding(THESIS.pose(np.array(A))[:3, :3])
    target = path.sample([0.0]).held[0]
    some = postures_at(THESIS, "pose", target, 32)
    np.testing.assert_allclose(THESIS.pose(some), np.broadcast_to(target, (len(some), 4, 4)), atol=1e-11)
    top = best(THESIS, "pose", target)
    np.testing.assert_allclose(THESIS.pose(top), target, atol=1e-11)
    w = float(THESIS.manipulability(top))
    assert w >= THESIS.manipulability(some).max()
    slope = THESIS.null_projector(top) @ THESIS.manipulability_gradient(top)
    assert np.abs(slope).max() < 0.02 * np.abs(THESIS.manipulability_gradient(top)).max()
    run = cr.track(THESIS, path, "best", dt=0.01)
    np.testing.assert_allclose(run.q[0], top)
    flat = cr.track(PLANAR, FLAT, "best", gain=0.1, criterion="H", dt=0.1)
    np.testing.assert_allclose(flat.q[0], cr.best_posture(PLANAR, [0.6, 0.3]).q, atol=1e-12)


def test_a_start_is_found_from_which_the_path_can_be_followed() -> None:
    path = cr.TaskPath.line((0.5, -0.2, 0.4), (0.5, 0.2, 0.4), duration=1.0, orientation=[0.0, 1.0, 0.0, 0.0])
    run = cr.track(PANDA, path, dt=0.01)
    assert run.status == "complete" and run.worst_position_error < 1e-3
    low, high = PANDA.limits.position.T
    assert (run.q >= low).all() and (run.q <= high).all()
    others = postures_at(PANDA, "pose", path.sample([0.0]).held[0], 6, seed=9)
    least = [cr.track(PANDA, path, q, dt=0.01).min_manipulability for q in others]
    assert run.min_manipulability > 0.9 * max(least)
    across = cr.TaskPath.line((0.5, -0.1, 0.0), (0.5, 0.1, 0.0), duration=1.0, orientation=[0.0, 1.0, 0.0, 0.0])
    found, top = (cr.track(THESIS, across, q0, dt=0.02) for q0 in ("followable", "best"))
    assert not top.events and found.min_manipulability > (1.0 - 1e-3) * top.min_manipulability
    turns = cr.track(PANDA, cr.TaskPath.line((0.5, -0.2, 0.4), (0.5, 0.2, 0.4), duration=1.0), dt=0.01)
    assert turns.status == "complete"  # a posture was found that holds its own orientation
    np.testing.assert_allclose(turns.held[:, :3, :3], np.tile(PANDA.pose(turns.q[0])[:3, :3], (101, 1, 1)), atol=1e-12)
    np.testing.assert_allclose(turns.position_error[0], 0.0, atol=1e-9)
    far = cr.TaskPath.line((0.5, -0.2, 0.4), (0.5, 3.0, 0.4), duration=1.0, orientation=[0.0, 1.0, 0.0, 0.0])
    with pytest.raises(InputError, match=r"none of .* postures at the start follows"):
        cr.track(PANDA, far, dt=0.01)


# ---- many at once ------------------------------------------------------------------------------------------------


def test_a_batch_is_the_single_runs() -> None:
    gains, steps = [-0.5, -2.0], [0.02, 0.01]
    starts = np.array([A, B, C])
    for integrator in ("euler", "heun", "rk4"):
        found = cr.track_batch(THESIS, ARC, starts, gains, steps, integrator=integrator)
        assert found.min_manipulability.shape == (3, 2, 2) and not found.diverged.any()
        run = cr.track(THESIS, ARC, B, gain=-0.5, dt=0.01, integrator=integrator)
        assert found.min_manipulability[1, 0, 1] == pytest.approx(run.min_manipulability, rel=1e-9)
        assert found.peak_rate[1, 0, 1] == pytest.approx(run.peak_rate, rel=1e-9)
        assert found.worst_position_error[1, 0, 1] == pytest.approx(run.worst_position_error, rel=1e-6)
        assert found.final_position_error[1, 0, 1] == pytest.approx(run.final_position_error, rel=1e-6, abs=1e-12)
        jumps = np.abs(np.diff(run.rates, axis=0)).max() / run.dt
        assert found.peak_acceleration[1, 0, 1] == pytest.approx(jumps, rel=1e-6)
    json.dumps(found.to_dict(), allow_nan=False)


def test_batches_of_diverging_and_of_no_runs() -> None:
    start = flat_start()
    options: dict[str, Any] = {"task": "position", "criterion": "H"}
    found = cr.track_batch(PLANAR, FLAT, start, [1.0, 3000.0], [0.01, 0.001], **options)
    assert found.diverged[0].tolist() == [[False, False], [True, False]]
    assert np.isnan(found.final_position_error[0, 1, 0]) and 0.0 < found.diverged_at[0, 1, 0] < 1.0
    assert found.final_position_error[0, 0, 1] < found.final_position_error[0, 0, 0]
    none = cr.track_batch(PLANAR, FLAT, np.empty((0, 3)), [1.0], **options)
    assert none.diverged.shape == (0, 1, 1)
    none = cr.track_batch(THESIS, ARC, np.empty((0, 8)), [-1.0, -2.0])  # each would hold its own orientation
    assert none.diverged.shape == (0, 2, 1)
    turned = cr.track_batch(PLANAR, FLAT, [start], [0.0], task="pose")  # holds the start's own angle
    assert turned.final_orientation_error[0, 0, 0] < 1e-2


def test_the_least_time_of_a_run() -> None:
    pytest.importorskip("toppra")
    path, q0 = panda_line(5, 0.2, 1.0)
    run = cr.track(PANDA, path, q0, gain=0.0, integrator="rk4", dt=0.005)
    quick = cr.fastest_run(run, path)
    assert quick.t[-1] < 2.0 * run.t[-1] and quick.scale.min() >= 0.0
    assert (np.abs(quick.rates) <= PANDA.limits.velocity + 1e-9).all()
    assert (np.abs(quick.accelerations) <= PANDA.limits.acceleration + 1e-9).all()
    pushed = np.maximum(
        (np.abs(quick.rates) / PANDA.limits.velocity).max(axis=1),
        (np.abs(quick.accelerations) / PANDA.limits.acceleration).max(axis=1),
    )
    assert np.median(pushed) > 0.9  # some limit is nearly met all along: it could not be much faster
    np.testing.assert_allclose(quick.q[[0, -1]], run.q[[0, -1]], atol=1e-9)
    assert quick.worst_position_error < 1e-4 and np.abs(quick.rates[[0, -1]]).max() < 1e-9
    with pytest.raises(InputError, match="acceleration"):
        cr.fastest_run(cr.track(PLANAR, FLAT, flat_start(), task="position", dt=0.1), FLAT)


# ---- refusals ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"integrator": "rk5"}, "'rk5'; euler, heun"),
        ({"method": "magic"}, "'magic'; gradient_projection"),
        ({"method": "pseudoinverse", "gain": 1.0}, "has no null-space motion"),
        ({"method": "priority"}, "takes a secondary task"),
        ({"secondary": lambda t, q: (np.zeros((1, 3)), np.zeros(1))}, "takes a secondary task"),
        ({"criterion": "w"}, "criterion: 'w'"),
        ({"gain": {"w": 1.0}}, "gains"),
        ({"gain": np.nan}, "gain"),
        ({"dt": 0.0}, "dt: 0; a positive number"),
        ({"feedback": -1.0}, "not below 0"),
        ({"feedback": [1.0, 2.0, 3.0]}, "or two"),
        ({"stop_rate": -1.0}, "stop_rate"),
        ({"weights": [1.0, 2.0]}, "weights"),
        ({"push": lambda t, q: np.zeros(2)}, "push: it gives shape"),
        ({"method": "priority", "secondary": lambda t, q: None}, "secondary: it gives None"),
        ({"method": "priority", "secondary": lambda t, q: np.eye(3)}, r"Jacobian \(k, n\) and velocity"),
        ({"near": "far"}, "near"),
        ({"near": 1.5}, "near: 1.5; a share"),
        ({"seed": "a", "q0": None}, "seed"),
        ({"seed": -1, "q0": "best"}, "seed"),
        ({"q0": [0.0, 0.0]}, r"q0: shape \(2,\)"),
        ({"q0": "worst"}, "'best' or 'followable'"),
        ({"q0": [0.0, 0.0, 0.0], "feedback": 0.0}, "misses the start of the path"),
        ({"limits": True, "integrator": "rk4"}, "with limits 'euler'"),
        ({"task": "attitude"}, "no task 'attitude'"),
        ({"path": cr.TaskPath.line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), duration=1.0)}, "3 coordinates"),
        ({"path": "arc.toml"}, "a TaskPath is accepted"),
        ({"path": cr.TaskPath.line((5.0, 0.0), (6.0, 0.0), duration=1.0), "q0": None}, "no posture was found"),
    ],
)
def test_what_cannot_be_followed_is_refused_in_one_line(options: dict[str, Any], words: str) -> None:
    given = {"path": FLAT, "q0": flat_start(), "task": "position", **options}
    path, q0 = given.pop("path"), given.pop("q0")
    with pytest.raises(InputError, match=words) as caught:
        cr.track(PLANAR, path, q0, **given)
    assert "\n" not in str(caught.value)


def test_more_refusals() -> None:
    with pytest.raises(InputError, match="outside its limits"):
        cr.track(PLANAR.with_limits(position=[(2.0, 3.0)] * 3), FLAT, flat_start(), task="position", limits=True)
    with pytest.raises(InputError, match="the path says no orientation"):
        cr.track(PANDA, cr.TaskPath.line((0.4, 0.0, 0.4), (0.5, 0.0, 0.4), duration=1.0), "best")
    with pytest.raises(InputError, match="rows for 3 joints"):
        cr.track(cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0), LINE, [0.0] * 3, task="pose")
    with pytest.raises(InputError, match="integrator"):
        cr.track_batch(PLANAR, FLAT, flat_start(), integrator="dop853")  # type: ignore[arg-type]
    for none in ({"gains": []}, {"dt": []}):
        with pytest.raises(InputError, match=rf"{next(iter(none))}: shape \(0,\)"):
            cr.track_batch(PLANAR, FLAT, flat_start(), **none)
    with pytest.raises(InputError, match="no joint has two limits"):
        cr.track_batch(PLANAR, FLAT, flat_start(), criterion="limits")
    with pytest.raises(InputError, match="law: none"):
        Stepper(PLANAR, [])
    with pytest.raises(InputError, match=r"starts: shape"):
        cr.track_batch(PLANAR, FLAT, [0.0, 0.0])
    with pytest.raises(InputError, match="q0: shape"):
        cr.forecast(PLANAR, FLAT, [0.0, 0.0])


def test_runs_are_the_same_every_time() -> None:
    first, second = (cr.track(PANDA, *panda_line(2), dt=0.01, limits=True) for _ in range(2))
    assert np.array_equal(first.q, second.q) and first.events == second.events


def test_rotation_vectors_of_half_turns() -> None:
    step_error = np.array([[0.0, 0.0, 0.0, 2.0 * np.sin(0.6), 0.0, 0.0], [0.0] * 6, [0.0, 0.0, 0.0, 0.0, 2.0, 0.0]])
    _, turned = errors(PANDA, "pose", step_error)
    np.testing.assert_allclose(turned, [[1.2, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, np.pi, 0.0]], atol=1e-15)


def test_events_are_known_and_in_order_of_time() -> None:
    run = cr.track(PANDA, *panda_line(0, 0.25, 0.25), dt=0.005, limits=True)
    assert run.events and {event.kind for event in run.events} <= set(EVENTS)
    assert all(first.t <= second.t for first, second in pairwise(run.events))
