"""Time scaling: limits honoured, the closed form against Ruckig, and TOPP-RA never slower than stopping."""

from __future__ import annotations

import builtins
import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import ruckig

import chainrule as cr
from chainrule.errors import InputError
from chainrule.higher_order import motion_ratios
from chainrule.scaling import JointPath, motion_path, polyline, rounded, time_scaling


def random_knots(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Knots of a random walk, velocity and acceleration limits."""
    rng = np.random.default_rng(seed)
    n, count = int(rng.integers(1, 8)), int(rng.integers(2, 10))
    knots = rng.normal(size=(count, n)).cumsum(axis=0) * 10.0 ** rng.uniform(-1.5, 0.5)
    return knots, rng.uniform(0.5, 2.0, n), rng.uniform(1.0, 5.0, n)


def worst(move: Any, velocity: Any, acceleration: Any) -> tuple[float, float]:
    """The largest share of the limits over dense samples."""
    _, speed, push = move.sample(np.linspace(0.0, move.duration, 8001))
    return float((np.abs(speed) / velocity).max()), float((np.abs(push) / acceleration).max())


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("method", ["stop", "toppra"])
def test_limits_hold_and_are_used(method: str, seed: int) -> None:
    knots, velocity, acceleration = random_knots(seed)
    options = {"deviation": 0.02} if method == "toppra" else {}
    move = time_scaling(knots, velocity, acceleration, method=method, **options)
    speed, push = worst(move, velocity, acceleration)
    assert speed <= 1.0 + 1e-9
    assert push <= 1.0 + 1e-9
    assert max(speed, push) > 0.98
    q, _, _ = move.sample([0.0, move.duration])
    np.testing.assert_allclose(q, knots[[0, -1]], atol=1e-12)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("method", ["stop", "toppra"])
def test_velocity_and_acceleration_are_derivatives(method: str, seed: int) -> None:
    """Integrated by the trapezoidal rule, they give back the move and the velocity."""
    knots, velocity, acceleration = random_knots(seed)
    move = time_scaling(
        knots, velocity, acceleration, method=method, **({"deviation": 0.05} if method != "stop" else {})
    )
    t = np.linspace(0.0, move.duration, 40001)
    q, speed, push = move.sample(t)
    step = t[1]
    moved = np.concatenate([np.zeros((1, q.shape[1])), np.cumsum(speed[1:] + speed[:-1], axis=0) * step / 2.0])
    gained = np.concatenate([np.zeros((1, q.shape[1])), np.cumsum(push[1:] + push[:-1], axis=0) * step / 2.0])
    np.testing.assert_allclose(q - q[0], moved, atol=1e-6 * (1 + np.abs(q).max()))
    np.testing.assert_allclose(speed, gained, atol=4.0 * len(knots) * step * acceleration.max())


@pytest.mark.parametrize("seed", range(6))
def test_stops_agree_with_ruckig(seed: int) -> None:
    """Every stretch takes as long as Ruckig's move along its line, and no less than its move of all joints."""
    knots, velocity, acceleration = random_knots(seed)
    move = time_scaling(knots, velocity, acceleration)
    n = knots.shape[1]
    for duration, (start, goal) in zip(move.durations, pairwise(knots), strict=True):
        generator, given, result = ruckig.Ruckig(n), ruckig.InputParameter(n), ruckig.Trajectory(n)
        given.synchronization = ruckig.Synchronization.Phase
        given.current_position, given.target_position = list(start), list(goal)
        given.max_velocity, given.max_acceleration = list(velocity), list(acceleration)
        given.max_jerk = [float("inf")] * n
        generator.calculate(given, result)
        # where Ruckig cannot keep the joints in phase it leaves the straight line, which may be faster
        assert duration >= result.duration - 1e-9
        share = np.abs(goal - start)
        alone = ruckig.InputParameter(1)
        alone.current_position, alone.target_position = [0.0], [1.0]
        alone.max_velocity = [float(np.min(velocity / share))]
        alone.max_acceleration = [float(np.min(acceleration / share))]
        alone.max_jerk = [float("inf")]
        line = ruckig.Trajectory(1)
        ruckig.Ruckig(1).calculate(alone, line)
        assert duration == pytest.approx(line.duration, rel=1e-9)


@pytest.mark.parametrize("deviation", [1e-6, 1e-3, 0.05])
def test_toppra_is_never_slower_than_stopping(deviation: float) -> None:
    faster = 0
    for seed in range(15):
        knots, velocity, acceleration = random_knots(seed)
        stop = time_scaling(knots, velocity, acceleration)
        move = time_scaling(knots, velocity, acceleration, method="toppra", deviation=deviation)
        assert move.duration <= stop.duration
        faster += move.duration < 0.97 * stop.duration
    assert faster >= (10 if deviation == 0.05 else 0)


@pytest.mark.parametrize("seed", range(6))
def test_rounding_stays_within_the_deviation(seed: int) -> None:
    """At the same s the rounded path and the polyline differ by no more, in every joint; the tangent never jumps."""
    knots, velocity, _ = random_knots(seed)
    allowed = np.linspace(0.01, 0.1, knots.shape[1])
    straight, smooth = polyline(knots, velocity), rounded(knots, allowed, velocity)
    s = np.linspace(0.0, straight.breaks[-1], 5001)
    assert (np.abs(straight.at(s) - smooth.at(s)) <= allowed * (1 + 1e-9) + 1e-14).all()
    inner = smooth.breaks[1:-1]
    pieces = np.arange(len(inner))
    for order in (0, 1):
        np.testing.assert_allclose(
            smooth.at(inner, order, pieces), smooth.at(inner, order, pieces + 1), atol=1e-9 * (1 + np.abs(knots).max())
        )
    gap = np.abs(smooth.at(smooth.marks) - knots)
    assert (gap <= allowed * (1 + 1e-9) + 1e-14).all()
    np.testing.assert_allclose(straight.at(straight.marks), knots, atol=1e-12 * (1 + np.abs(knots).max()))


def test_closed_form_by_hand() -> None:
    """One joint, d = 1, V = 1, A = 2: trapezoid, 1/1 + 1/2; V = 10: triangle, 2 sqrt(1/2)."""
    assert time_scaling([[0.0], [1.0]], 1.0, 2.0).duration == pytest.approx(1.5)
    assert time_scaling([[0.0], [1.0]], 10.0, 2.0).duration == pytest.approx(2.0 * np.sqrt(0.5))
    assert time_scaling([[0.0], [1.0]], np.inf, 2.0).duration == pytest.approx(2.0 * np.sqrt(0.5))
    # two joints in phase: the second's acceleration is what counts
    assert time_scaling([[0.0, 0.0], [1.0, 4.0]], np.inf, [2.0, 2.0]).duration == pytest.approx(2.0 * np.sqrt(2.0))


def test_toppra_finds_the_closed_form_on_a_straight_line() -> None:
    """Without corners the fastest run is the trapezoid; a grid comes near it from above."""
    knots, velocity, acceleration = np.array([[0.0, 0.0], [1.0, -2.0]]), [1.0, 1.5], [2.0, 3.0]
    exact = time_scaling(knots, velocity, acceleration).duration
    grid = time_scaling(polyline(knots, velocity), velocity, acceleration, method="toppra").duration
    assert exact * (1 - 1e-9) <= grid <= exact * (1 + 1e-3)


def test_knots_that_repeat_or_turn_back() -> None:
    knots = np.array([[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.5, 0.5], [1.0, 1.0]])
    stop = time_scaling(knots, 1.0, 2.0)
    np.testing.assert_allclose(stop.durations, [1.5, 0.0, 1.0, 1.0])
    np.testing.assert_allclose(stop.sample(stop.knot_times)[0], knots, atol=1e-12)
    move = time_scaling(knots, 1.0, 2.0, method="toppra", deviation=0.01)
    assert move.duration <= stop.duration
    assert max(worst(move, 1.0, 2.0)) <= 1.0 + 1e-9
    assert np.abs(move.sample(move.knot_times)[0] - knots).max() <= 0.01 + 1e-9
    for method, options in (("stop", {}), ("toppra", {"deviation": 0.1})):
        still = time_scaling([[0.3, 0.4], [0.3, 0.4]], 1.0, 1.0, method=method, **options)
        assert still.duration == 0.0
        q, speed, push = still.sample([0.0, 1.0])
        np.testing.assert_allclose(q, [[0.3, 0.4], [0.3, 0.4]])
        assert not speed.any() and not push.any()


def test_knots_that_all_but_repeat() -> None:
    """A knot a hair's breadth from its neighbour costs nothing, and knots far apart with tiny roundings stop."""
    plain = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
    for hair in (1e-300, 1e-16, 1e-12, 1e-6):
        knots = np.array([[0.0, 0.0], [hair, 0.0], [1.0, 0.0], [1.0, hair], [1.0, 1.0], [1.0, 1.0 + hair]])
        move = time_scaling(knots, 1.0, 2.0, method="toppra", deviation=0.01)
        assert move.method == "toppra"
        assert move.duration == pytest.approx(
            time_scaling(plain, 1.0, 2.0, method="toppra", deviation=0.01).duration, rel=1e-3
        )
        assert max(worst(move, 1.0, 2.0)) <= 1.0 + 1e-9
        q = move.sample(move.knot_times)[0]
        assert np.abs(q - knots).max() <= 0.01 * (1 + 1e-9)
        np.testing.assert_allclose(q[[0, -1]], knots[[0, -1]], rtol=0, atol=1e-14)
    for far, deviation in ((1e200, 0.1), (1.0, 1e-15)):
        assert time_scaling(far * plain, 1.0, 2.0, method="toppra", deviation=deviation).method == "stop"
    crowd = [[0.0, 0.0], [1e-9, 0.0], [0.0, 1e-9]]  # all of them one cluster
    assert time_scaling(crowd, 1.0, 2.0, method="toppra", deviation=0.01).sample([1.0])[0][0].tolist() == crowd[-1]


def test_a_stretch_that_rounding_swallows() -> None:
    """Of moves of 1e-16 beside moves of 1 nothing is left in the sum, and nothing of them is nan."""
    knots = np.array([[0.0], [1.0], [1.0 + 2.3e-16], [2.0], [2.0 + 1e-15], [3.0]])
    for options in ({"method": "stop"}, {"method": "toppra", "deviation": 0.01}):
        move = time_scaling(knots, [1.7], [2.0], **options)
        q, speed, push = move.sample(np.linspace(0.0, move.duration, 3001))
        assert np.isfinite(q).all() and np.isfinite(speed).all() and np.isfinite(push).all()
        assert np.isfinite(move.durations).all()
        assert q[-1, 0] == pytest.approx(3.0, abs=1e-12)


@pytest.mark.parametrize("seed", range(30))
def test_limits_hold_between_the_points_that_are_checked(seed: int) -> None:
    """Loose roundings and tight velocities: the peak of a joint's speed lies inside a grid interval."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 5))
    knots, velocity, acceleration = (
        rng.normal(size=(6, n)),
        10.0 ** rng.uniform(-1, 1, n),
        10.0 ** rng.uniform(-1, 2, n),
    )
    move = time_scaling(knots, velocity, acceleration, method="toppra", deviation=0.3)
    assert max(worst(move, velocity, acceleration)) <= 1.0 + 1e-9


@pytest.mark.parametrize("size", [1e-8, 1e-4, 1e3])
def test_small_and_large_paths(size: float) -> None:
    """TOPP-RA's own numbers are absolute; here a path s times as large takes sqrt(s) times as long."""
    knots = np.array([[0.0, 0.0], [1.0, 0.3], [1.2, 1.0], [0.1, 1.4]])
    plain = time_scaling(knots, np.inf, 2.0, method="toppra", deviation=0.05)
    other = time_scaling(size * knots, np.inf, 2.0, method="toppra", deviation=0.05 * size)
    assert plain.method == other.method == "toppra"
    assert other.duration == pytest.approx(size**0.5 * plain.duration, rel=1e-4)


@pytest.mark.parametrize("order", [2, 3])
def test_higher_order_motion(order: int) -> None:
    """The joint motion of the speed ratios, as fast as the joints allow: one limit is used nearly everywhere."""
    arm = cr.planar_3r(1.0, 0.8, 0.5)
    motion = motion_ratios(arm, [0.3, 0.8, 0.6], [1.0, 0.3], 2.0, 0.5, order=order)
    path = motion_path(motion, 0.4)
    s = np.linspace(0.0, 0.4, 7)
    np.testing.assert_allclose(path.at(s), motion.at(s), atol=1e-14)
    np.testing.assert_allclose(path.at(s[:1], 2)[0], motion.second)
    velocity, acceleration = np.array([0.4, 0.6, 0.8]), np.array([1.0, 1.5, 2.0])
    move = time_scaling(path, velocity, acceleration, method="toppra")
    assert max(worst(move, velocity, acceleration)) <= 1.0 + 1e-6
    _, speed, push = move.sample(np.linspace(0.01, 0.99, 400) * move.duration)
    busy = np.maximum((np.abs(speed) / velocity).max(axis=1), (np.abs(push) / acceleration).max(axis=1))
    assert np.quantile(busy, 0.05) > 0.95


def test_refusals(monkeypatch: pytest.MonkeyPatch) -> None:
    knots = [[0.0, 0.0], [1.0, 0.5], [2.0, -1.0]]
    bent = JointPath(np.array([0.0, 1.0]), np.ones((1, 3, 2)), np.array([0.0, 1.0]), False)
    batch = motion_ratios(cr.planar_3r(1, 1, 1), [[0.1, 1.0, 0.3]], [1, 0], 0.0)
    for call, words in (
        (lambda: time_scaling(knots, 1.0, 1.0, method="best"), "'stop' and 'toppra' are accepted"),
        (lambda: time_scaling([0.0, 1.0], 1.0, 1.0), r"\(k \+ 1, n\)"),
        (lambda: time_scaling([[0.0, 1.0]], 1.0, 1.0), "two knots or more"),
        (lambda: time_scaling([[0.0, 1.0], [np.nan, 1.0]], 1.0, 1.0), r"knots\[1, 0\]: nan"),
        (lambda: time_scaling("far", 1.0, 1.0), "knots: 'far'; an array"),
        (lambda: time_scaling(knots, 0.0, 1.0), "velocity: 0.0 has an entry"),
        (lambda: time_scaling(knots, [1.0, 2.0, 3.0], 1.0), "velocity: .* does not fit"),
        (lambda: time_scaling(knots, 1.0, np.inf), "acceleration: inf; finite"),
        (lambda: time_scaling(knots, 1.0, 1.0, deviation=0.1), "'stop' runs the knots exactly"),
        (lambda: time_scaling(knots, 1.0, 1.0, method="toppra"), "rounds the corners"),
        (lambda: time_scaling(knots, 1.0, 1.0, method="toppra", deviation=-1), "deviation: -1 has an entry"),
        (lambda: time_scaling(polyline(knots), 1.0, 1.0, method="toppra"), "has corners"),
        (lambda: time_scaling(bent, 1.0, 1.0), "straight stretches"),
        (lambda: motion_path(batch, 1.0), "one is accepted"),
        (lambda: motion_path(None, 1.0), "what motion_ratios gives"),  # type: ignore[arg-type]
        (lambda: time_scaling(knots, "1", 1.0), "velocity: '1'; an array of real"),
        (lambda: time_scaling(knots, np.nan, 1.0), "velocity: nan"),
        (lambda: time_scaling(knots, 1.0, 1.0).sample(np.nan), "t: nan"),
        (lambda: polyline(knots, [0.0, 1.0]), "weights: .* not positive"),
    ):
        with pytest.raises(InputError, match=words) as caught:
            call()
        assert "\n" not in str(caught.value)

    real = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name.split(".")[0] == "toppra":
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(InputError, match=r"needs the package toppra: pip install 'chainrule\[timing\]'"):
        time_scaling(knots, 1.0, 1.0, method="toppra", deviation=0.1)


def test_plain_values() -> None:
    move = time_scaling([[0.0], [1.0], [0.0]], 1.0, 2.0)
    assert json.loads(json.dumps(move.to_dict())) == {
        "method": "stop",
        "duration": pytest.approx(3.0),
        "knot_times": pytest.approx([0.0, 1.5, 3.0]),
    }


def test_timings_are_drawn() -> None:
    from chainrule.plot.higher_order import draw_timings

    knots = [[0.0, 0.0], [0.5, 0.2], [0.8, 0.9]]
    stop = time_scaling(knots, 1.0, 2.0)
    fast = time_scaling(knots, 1.0, 2.0, method="toppra", deviation=0.05)
    drawing = draw_timings({"stop": stop, "rounded": fast}, 1.0, 2.0)
    assert len(drawing.axes) == 2
    saved = round(100 * (1 - fast.duration / stop.duration))
    assert drawing.get_suptitle() == f"rounded is done {saved} % sooner"
