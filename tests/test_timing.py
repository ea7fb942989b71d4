"""The fastest motion from rest to rest: against proofs, another program, and what must hold of every motion."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from chainrule import InputError
from chainrule.derive import rest_to_rest
from chainrule.derive.program import GuardedInverse, closed_form
from chainrule.timing import CASES, min_time

SYNCHRONISE = ("none", "time", "phase")
every_way = pytest.mark.parametrize("synchronise", SYNCHRONISE)


def random_moves(count, n, seed):
    """Starts, goals and bounds; one entry in eight does not move, one in eight just reaches its velocity."""
    random = np.random.default_rng(seed)
    start = random.uniform(-3.0, 3.0, (count, n))
    v, a = (10.0 ** random.uniform(-0.5, 0.5, (count, n)) for _ in range(2))
    goal = start + random.choice([-1.0, 1.0], (count, n)) * v * v / a * 10.0 ** random.uniform(-1.5, 1.5, (count, n))
    kind = random.integers(0, 8, (count, n))
    start = np.where(kind == 0, goal, start)
    start, goal = np.where(kind == 1, 0.0, start), np.where(kind == 1, v * v / a, goal)
    return start, goal, v, a


# ---- the formulas --------------------------------------------------------------------------------------------------

V, A, t, more, half = sp.symbols("V A t more half", positive=True)


def derived(program, **values):
    """The entries of a derived profile for these inputs, with every minimum and maximum decided."""
    symbols = {symbol: values[symbol.name] for symbol in program.inputs[0].symbols}
    entries = (entry.xreplace(symbols) for entry in closed_form(program)["profile"])
    return [sp.simplify(decided(entry)) for entry in entries]


def decided(entry):
    """An expression in positive symbols without Min, Max and GuardedInverse; fails where they cannot be decided."""
    if not entry.args:
        return entry
    args = [sp.simplify(decided(arg)) for arg in entry.args]
    if isinstance(entry, GuardedInverse):
        assert args[0].is_positive
        return 1 / args[0]
    if not isinstance(entry, sp.Min | sp.Max):
        return entry.func(*args)
    one, two = args
    gap = sp.factor(one**2 - two**2) if sp.S.Zero not in args else sp.factor(one - two)
    assert gap.is_nonnegative or gap.is_nonpositive
    return one if bool(gap.is_nonnegative) == isinstance(entry, sp.Max) else two


def area(peak, ramp, cruise):
    """The integral of the velocity, piece by piece."""
    rising, falling = peak / ramp * t, peak / ramp * (ramp - t)
    return sp.integrate(rising, (t, 0, ramp)) + peak * cruise + sp.integrate(falling, (t, 0, ramp))


@pytest.mark.parametrize("distance", [V**2 / A + more, V**2 / A, V**2 / A / (1 + more) ** 2], ids="abc")
def test_the_profile_covers_the_distance(distance):
    """In each case, for every distance of that case."""
    peak, ramp, cruise, duration = derived(rest_to_rest.profile(), distance=distance, velocity=V, acceleration=A)
    assert sp.simplify(area(peak, ramp, cruise) - distance) == 0
    assert sp.simplify(duration - 2 * ramp - cruise) == 0
    assert sp.simplify(peak / ramp - A) == 0
    assert sp.factor(V - peak).is_nonnegative
    assert cruise.is_nonnegative


def test_the_slowed_profile_covers_the_distance_in_the_time():
    """For every distance that takes less without a bound on the velocity, 2 sqrt(d / A) < T."""
    distance, duration = A * half**2, 2 * half + more
    peak, ramp, cruise, _ = derived(rest_to_rest.stretched(), distance=distance, acceleration=A, duration=duration)
    assert sp.simplify(area(peak, ramp, cruise) - distance) == 0
    assert sp.simplify(2 * ramp + cruise - duration) == 0
    assert sp.simplify(peak / ramp - A) == 0
    assert cruise.is_positive


def test_no_feasible_motion_goes_farther_in_the_same_time():
    """The largest distance in a time, found by a linear program over accelerations constant in short intervals.

    The intervals are chosen so that the fastest motion is one of those the program may choose.
    """
    for v, a, steps in [(1.0, 1.0, 10), (0.5, 2.0, 30), (3.0, 1.0, 12), (0.25, 1.0, 16)]:
        step = v / a / 4 if v < 1.0 else 0.25
        duration = steps * step
        peak_time = min(v / a, duration / 2)
        way = a * peak_time * (duration - peak_time)  # only to pose the question; the answer is the program's
        speeds = np.tril(np.full((steps, steps), step))  # speed after each interval
        before = np.vstack([np.zeros(steps), speeds[:-1]])
        gain = (step * before + step**2 / 2 * np.eye(steps)).sum(axis=0)
        best = linprog(
            -gain,
            A_ub=np.vstack([speeds, -speeds]),
            b_ub=np.full(2 * steps, v),
            A_eq=speeds[-1:],
            b_eq=[0.0],
            bounds=(-a, a),
        )
        farthest = -best.fun
        assert farthest == pytest.approx(way, rel=1e-9)
        assert float(min_time([0.0], [farthest], v, a).duration) == pytest.approx(duration, rel=1e-8)


# ---- against another program ---------------------------------------------------------------------------------------


def ruckig_moves(start, goal, v, a, synchronisation):
    """Durations, least times and positions at a third of the time, by Ruckig without a bound on jerk."""
    import ruckig

    n = start.shape[1]
    machine, given, found = ruckig.Ruckig(n), ruckig.InputParameter(n), ruckig.Trajectory(n)
    given.synchronization = getattr(ruckig.Synchronization, synchronisation)
    results = []
    for row in zip(start.tolist(), goal.tolist(), v.tolist(), a.tolist(), strict=True):
        given.current_position, given.target_position, given.max_velocity, given.max_acceleration = row
        assert machine.calculate(given, found) == ruckig.Result.Working
        results.append((found.duration, found.independent_min_durations, found.at_time(found.duration / 3.0)[0]))
    return (np.array(part) for part in zip(*results, strict=True))


@pytest.fixture(scope="module")
def ten_thousand():
    return random_moves(10_000, 3, seed=11)


@pytest.mark.parametrize(("synchronise", "theirs"), [("none", "No"), ("time", "Time")])
def test_ten_thousand_moves_as_ruckig(ten_thousand, synchronise, theirs):
    start, goal, v, a = ten_thousand
    move = min_time(start, goal, v, a, synchronise=synchronise)
    duration, least, third = ruckig_moves(start, goal, v, a, theirs)
    scale = np.maximum(1.0, duration)
    assert (np.abs(move.duration - duration) <= 1e-12 * scale).all()
    assert (np.abs(move.joint_durations - least) <= 1e-12 * scale[:, None]).all()
    off = np.abs(move.sample(duration / 3.0).position - third)
    # a short way in a long time costs Ruckig digits: T minus a root near T (ours: see the test at 40 digits)
    assert (off <= 1e-12 * np.maximum(scale[:, None], np.abs(start) + np.abs(goal))).all()
    assert {*move.cases.ravel()} == set(CASES)  # all four were met
    assert (move.cases[(start == 0.0) & (goal == v * v / a)] == "b").all()


def test_in_phase_as_ruckig_where_that_takes_no_longer(ten_thousand):
    """Ruckig keeps a straight line only where its time is the least; ours then has the same time and positions."""
    start, goal, v, a = ten_thousand
    v, a = v[:, :1] * [1.0, 1.5, 0.7], a[:, :1] * [1.0, 0.7, 1.4]
    straight = min_time(start, goal, v, a, synchronise="phase")
    least = straight.joint_durations.max(axis=-1)
    same = straight.bottleneck.any(axis=-1) & (least > 0.0)
    assert 1000 < same.sum() < 9500
    duration, _, third = ruckig_moves(start, goal, v, a, "Phase")
    np.testing.assert_allclose(duration, least, rtol=1e-12)
    np.testing.assert_allclose(straight.duration[same], duration[same], rtol=1e-12)
    off = np.abs(straight.pick(same).sample(duration[same] / 3.0).position - third[same])
    assert off.max() < 1e-11


# ---- what must hold of every motion --------------------------------------------------------------------------------


@every_way
def test_every_motion_is_feasible_and_arrives(synchronise):
    start, goal, v, a = random_moves(500, 4, seed=3)
    move = min_time(start, goal, v, a, synchronise=synchronise)
    times = np.linspace(-0.1, 1.1, 241)[:, None] * move.duration
    state = move.sample(times)
    assert (np.abs(state.velocity) <= v * (1.0 + 1e-14)).all()
    assert (np.abs(state.acceleration) <= a).all()
    assert (move.sample(0.0).position == start).all()
    assert (move.sample(move.duration).position == goal).all()
    assert (move.sample(-1.0).position == start).all()
    assert (move.sample(np.inf).position == goal).all()
    for time in (-1.0, 0.0, move.duration, move.duration + 1.0):
        assert not move.sample(time).velocity.any()
    # monotone, never beyond either end
    assert (np.diff(state.position, axis=0) * np.sign(goal - start) >= -1e-14 * (np.abs(start) + np.abs(goal))).all()


@every_way
def test_position_velocity_and_acceleration_belong_together(synchronise):
    """The trapezoidal rule is exact for a velocity that is linear between the instants where it bends."""
    start, goal, v, a = random_moves(200, 3, seed=4)
    move = min_time(start, goal, v, a, synchronise=synchronise)
    for j in range(3):
        bends = np.stack([0.0 * move.duration, move.ramp[:, j], move.travel[:, j] - move.ramp[:, j], move.travel[:, j]])
        inner = np.concatenate([bends, bends[:-1] + 0.37 * np.diff(bends, axis=0)])
        times = np.sort(inner, axis=0)
        state = move.sample(times)
        between = move.sample((times[:-1] + times[1:]) / 2.0)
        width = np.diff(times, axis=0)
        scale = 1e-14 * (np.abs(start[:, j]) + np.abs(goal[:, j]) + 1.0)
        way = ((state.velocity[1:, :, j] + state.velocity[:-1, :, j]) / 2.0 * width).sum(axis=0)
        rounding = 1e-15 * a[:, j] * move.duration**2  # of the times of the bends
        assert (np.abs(way - (goal - start)[:, j]) <= 8 * scale + rounding).all()
        steps = np.diff(state.velocity[..., j], axis=0) - between.acceleration[..., j] * width
        assert (np.abs(steps) <= 1e-13 * v[:, j] + 1e-15 * a[:, j] * move.duration).all()
        ways = np.diff(state.position[..., j], axis=0) - between.velocity[..., j] * width
        assert (np.abs(ways) <= 8 * scale).all()  # the middle of a line is its mean


@every_way
def test_motions_are_symmetric_in_time_and_reversible(synchronise):
    start, goal, v, a = random_moves(300, 3, seed=5)
    move = min_time(start, goal, v, a, synchronise=synchronise)
    back = min_time(goal, start, v, a, synchronise=synchronise)
    assert (move.duration == back.duration).all()
    assert (move.cases == back.cases).all()
    assert (move.unique == back.unique).all()
    for part in (0.1, 0.3, 0.45):
        early = move.sample(part * move.travel[:, 0]).position[:, 0] - start[:, 0]
        late = goal[:, 0] - move.sample((1.0 - part) * move.travel[:, 0]).position[:, 0]
        assert (np.abs(early - late) <= 1e-13 * (np.abs(start) + np.abs(goal))[:, 0] + 1e-15).all()
        np.testing.assert_allclose(
            move.sample(part * move.duration).velocity, -back.sample(part * move.duration).velocity, atol=1e-14
        )


@every_way
def test_scaling_laws(synchronise):
    """Powers of two scale without rounding: time by k with the distance by k^2 at the same acceleration, and so on."""
    start, goal, v, a = random_moves(300, 3, seed=6)
    start[:] = 0.0
    move = min_time(start, goal, v, a, synchronise=synchronise)
    larger = min_time(start, 4.0 * goal, 4.0 * v, 4.0 * a, synchronise=synchronise)
    np.testing.assert_array_equal(larger.duration, move.duration)
    np.testing.assert_array_equal(larger.peak, 4.0 * move.peak)
    slower = min_time(start, goal, v / 2.0, a / 4.0, synchronise=synchronise)
    np.testing.assert_array_equal(slower.duration, 2.0 * move.duration)
    np.testing.assert_array_equal(slower.cases, move.cases)


@every_way
@settings(max_examples=200, deadline=None)
@given(
    way=st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=4),
    bounds=st.lists(st.floats(1e-3, 1e3), min_size=8, max_size=8),
    factor=st.floats(1.0, 10.0),
)
def test_larger_bounds_and_shorter_ways_never_take_longer(synchronise, way, bounds, factor):
    n = len(way)
    start, goal, v, a = np.zeros(n), np.array(way), np.array(bounds[:n]), np.array(bounds[4 : 4 + n])
    duration = min_time(start, goal, v, a, synchronise=synchronise).duration * (1.0 + 1e-15)
    assert min_time(start, goal, v * factor, a, synchronise=synchronise).duration <= duration
    assert min_time(start, goal, v, a * factor, synchronise=synchronise).duration <= duration
    assert min_time(start, goal / factor, v, a, synchronise=synchronise).duration <= duration


@settings(max_examples=300, deadline=None)
@given(
    distance=st.floats(1e-12, 1e6),
    v=st.floats(1e-12, 1e6),
    a=st.floats(1e-12, 1e6),
)
def test_small_and_large_numbers_to_a_few_roundings(distance, v, a):
    """Against exact rational arithmetic and a square root of 40 digits."""
    d_, v_, a_ = (Fraction(x) for x in (distance, v, a))
    move = min_time([0.0], [distance], v, a)
    if d_ * a_ >= v_ * v_:
        exact = float(d_ / v_ + v_ / a_)
    else:
        exact = float(2 * sp.sqrt(sp.Rational(d_.numerator, d_.denominator) * a_.denominator / a_.numerator).evalf(40))
    assert float(move.duration) == pytest.approx(exact, rel=4e-16 * 4)
    assert move.sample(move.duration).position[0] == distance
    half = move.sample(move.duration / 2.0)
    assert half.position[0] == pytest.approx(distance / 2.0, rel=1e-15)


def test_motions_that_end_together_to_forty_digits():
    """The slowed joint's peak solves peak (T - peak / A) = d; its position a third of the way through follows."""
    start, goal, v, a = random_moves(300, 3, seed=13)
    move = min_time(start, goal, v, a, synchronise="time")
    third = move.sample(move.duration / 3.0).position
    with mpmath.workdps(40):
        for k, j in zip(*np.nonzero(~move.bottleneck & (goal != start)), strict=True):
            way, a_, whole = mpmath.mpf(goal[k, j]) - mpmath.mpf(start[k, j]), mpmath.mpf(a[k, j]), move.duration[k]
            root = mpmath.sqrt(mpmath.mpf(whole) ** 2 - 4 * abs(way) / a_)
            peak, time = a_ * (whole - root) / 2, mpmath.mpf(whole / 3.0)
            ramp = peak / a_
            gone = a_ * time**2 / 2 if time < ramp else peak * (time - ramp / 2)
            exact = float(start[k, j] + mpmath.sign(way) * gone)
            assert abs(third[k, j] - exact) <= 4e-16 * (2 + abs(start[k, j]) + abs(goal[k, j]))
            assert abs(float(peak) - move.peak[k, j]) <= 1e-15 * float(peak) * float(whole / root)


def test_in_phase_is_a_straight_line_and_equal_exactly_where_stated():
    start, goal, v, a = random_moves(3000, 3, seed=8)
    v[1000:2000], a[1000:] = v[1000:2000, :1], a[1000:, :1]
    move = min_time(start, goal, v, a, synchronise="phase")
    way, rows = goal - start, np.arange(3000)
    gone, longest = move.sample(0.3 * move.duration).position - start, np.abs(way).argmax(axis=-1)
    across = gone * way[rows, longest, None] - way * gone[rows, longest, None]  # the components of a cross product
    assert (np.abs(across) <= 1e-14 * np.abs(way[rows, longest, None]) * (1.0 + np.abs(start) + np.abs(goal))).all()
    # the statement: least A/d and (least V/d or a triangle)
    with np.errstate(divide="ignore"):
        speeds, rates = v / np.abs(way), a / np.abs(way)
    speed, rate = speeds.min(axis=-1), rates.min(axis=-1)
    triangle = speed**2 >= rate
    stated = ((rates == rate[:, None]) & (triangle[:, None] | (speeds == speed[:, None]))).any(axis=-1)
    least = move.joint_durations.max(axis=-1)
    assert (move.duration >= least * (1.0 - 1e-15)).all()
    clear = least > 0.0
    equal = move.duration <= least * (1.0 + 1e-12)
    assert (equal == stated)[clear].all()
    assert 0 < stated.sum() < len(stated)
    assert (move.bottleneck.any(axis=-1) == equal)[clear].all()


def test_together_all_end_at_the_same_time_with_the_same_acceleration():
    start, goal, v, a = random_moves(300, 4, seed=9)
    move = min_time(start, goal, v, a, synchronise="time")
    alone = min_time(start, goal, v, a)
    assert (move.duration == alone.duration).all()
    assert (move.peak <= alone.peak).all()
    moving = goal != start
    np.testing.assert_allclose(
        (2 * move.ramp + move.cruise)[moving], np.broadcast_to(move.duration[:, None], moving.shape)[moving]
    )
    assert (move.acceleration[moving] == a[moving]).all()
    just_before = move.sample(move.duration * (1.0 - 1e-6))
    assert (just_before.velocity[moving] != 0.0).all()


# ---- uniqueness and slack ------------------------------------------------------------------------------------------


def test_unique_exactly_where_no_joint_has_slack():
    one = min_time([0.0], [1.0], 1.0, 1.0)
    assert one.unique
    assert one.bottleneck.all()
    two = min_time([0.0, 0.0], [1.0, -1.0], 1.0, 1.0)
    assert two.unique
    spare = min_time([0.0, 0.0], [1.0, -0.9], 1.0, 1.0)
    assert not spare.unique
    assert spare.bottleneck.tolist() == [True, False]
    still = min_time([0.0, 1.0], [1.0, 1.0], 1.0, 1.0)
    assert not still.unique  # the second joint may go and come back
    assert min_time([0.0, 1.0], [1.0, 1.0], [1.0, 0.0], 1.0).unique  # unless it cannot
    nothing = min_time([0.0, 1.0], [0.0, 1.0], 1.0, 1.0)
    assert nothing.unique
    assert nothing.duration == 0.0
    assert not min_time([0.0, 0.0], [1.0, 0.5], [1.0, 0.2], [1.0, 1.0], synchronise="phase").unique


def test_slack_is_told_from_rounding():
    """A way that start and goal give with a rounding, against the same way given exactly."""
    start = np.array([0.0, 1e3, 0.1, 0.7])
    goal = start + 0.3
    assert len({*(goal - start)}) > 1
    assert min_time(start, goal, 1.0, 1.0).unique
    assert not min_time(start, goal + np.array([0.0, 1e-9, 0.0, 0.0]), 1.0, 1.0).unique


def test_case_b_is_told_from_rounding():
    """The way V^2 / A, as a start and a goal far from 0 give it."""
    start = np.array([0.0, 0.1, 1e3, -3e5])
    goal = start + 0.3
    assert min_time(start, goal, 0.3, 0.3).cases.tolist() == ["b"] * 4
    assert min_time(start, goal, 0.3, 0.3 * (1 + 1e-8)).cases.tolist() == ["a"] * 4
    assert min_time(start, goal, 0.3, 0.3 * (1 - 1e-8)).cases.tolist() == ["c"] * 4


def test_joints_with_slack_have_another_motion_as_fast():
    start, goal, v, a = random_moves(200, 3, seed=10)
    alone, together = (min_time(start, goal, v, a, synchronise=s) for s in ("none", "time"))
    assert (alone.duration == together.duration).all()
    different = (alone.peak != together.peak).any(axis=-1)
    loose = (~alone.bottleneck & (alone.cases != "d")).any(axis=-1)
    assert (different == loose).all()


# ---- infinite bounds, no joints to move, shapes --------------------------------------------------------------------


@every_way
def test_one_bound_may_be_infinite(synchronise):
    free = min_time([0.0], [2.0], np.inf, 2.0, synchronise=synchronise)
    assert free.duration == pytest.approx(2.0, rel=1e-15)
    assert free.cases.tolist() == ["c"]
    assert free.peak == pytest.approx(2.0, rel=1e-15)
    jump = min_time([0.0], [2.0], 0.5, np.inf, synchronise=synchronise)
    assert jump.duration == 4.0
    assert jump.cases.tolist() == ["a"]
    state = jump.sample([0.0, 1.0, 3.0, 4.0])
    assert state.position[:, 0].tolist() == [0.0, 0.5, 1.5, 2.0]
    assert state.velocity[:, 0].tolist() == [0.5, 0.5, 0.5, 0.0]
    assert not state.acceleration.any()
    assert jump.to_dict()["a_max"] == [None]
    mixed = min_time([0.0, 0.0], [1.0, 1.0], [np.inf, 1.0], [1.0, np.inf], synchronise=synchronise)
    assert mixed.duration == pytest.approx(2.0)
    slow = min_time([0.0, 0.0], [1.0, 1.0], [np.inf, 0.1], [1.0, np.inf], synchronise=synchronise)
    assert slow.duration == pytest.approx(10.1 if synchronise == "phase" else 10.0)
    assert np.isfinite(slow.sample(np.linspace(0.0, 11.0, 7)).position).all()


@every_way
def test_joints_that_stay_need_no_bounds(synchronise):
    move = min_time([1.0, 2.0, 3.0], [1.0, 2.5, 3.0], [0.0, 1.0, np.inf], [0.0, 1.0, np.inf], synchronise=synchronise)
    assert move.cases.tolist() == ["d", "c", "d"]
    assert move.joint_durations[0] == move.joint_durations[2] == 0.0
    state = move.sample(move.duration / 2.0)
    assert state.position.tolist() == [1.0, 2.25, 3.0]
    assert not state.velocity[[0, 2]].any()


@every_way
def test_shapes(synchronise):
    empty = min_time(np.zeros((0, 3)), np.zeros(3), 1.0, 1.0, synchronise=synchronise)
    assert empty.duration.shape == (0,)
    assert empty.sample(0.5).position.shape == (0, 3)
    batch = min_time(np.zeros((5, 1, 2)), np.ones((4, 2)), [1.0, 2.0], 1.0, synchronise=synchronise)
    assert batch.duration.shape == (5, 4)
    assert batch.cases.shape == (5, 4, 2)
    assert batch.sample(np.zeros((7, 1, 1))).velocity.shape == (7, 5, 4, 2)
    one = batch.pick((2, 3))
    assert one.duration.shape == ()
    assert one.sample(np.zeros((7, 2))).position.shape == (7, 2, 2)
    assert one.to_dict()["duration"] == pytest.approx(float(one.duration))
    with pytest.raises(InputError, match="does not broadcast"):
        batch.sample(np.zeros(3))


def test_a_batch_is_its_rows():
    start, goal, v, a = random_moves(50, 3, seed=12)
    for synchronise in SYNCHRONISE:
        batch = min_time(start, goal, v, a, synchronise=synchronise)
        for k in range(50):
            row = min_time(start[k], goal[k], v[k], a[k], synchronise=synchronise)
            assert row.to_dict() == batch.pick(k).to_dict()


def test_the_jumps_of_the_acceleration_have_their_later_value():
    move = min_time([0.0], [3.0], 1.0, 1.0)  # 1 s up, 2 s along, 1 s down
    times = [-0.1, 0.0, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0]
    assert move.sample(times).acceleration[:, 0].tolist() == [0.0, 1.0, 1.0, 0.0, 0.0, -1.0, -1.0, 0.0]
    triangle = min_time([0.0], [-1.0], 1.0, 1.0)
    assert triangle.sample([0.0, 1.0, 2.0]).acceleration[:, 0].tolist() == [-1.0, 1.0, 0.0]


# ---- what is refused -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (([0.0], [np.nan], 1.0, 1.0), r"goal\[0\]: nan"),
        (([np.inf], [0.0], 1.0, 1.0), r"start\[0\]: inf"),
        (([0.0], [1.0], np.nan, 1.0), "v_max: nan"),
        (([0.0, 0.0], [1.0, 1.0], 1.0, [1.0, -1.0]), "joint 2: a bound is negative"),
        (([0.0, 0.0], [0.0, 0.0], 1.0, [1.0, -1.0]), "joint 2: a bound is negative"),
        (([0.0], [1.0], 0.0, 1.0), "joint 1: the joint has to move and a bound is 0"),
        (([0.0], [1.0], np.inf, np.inf), "both bounds are infinite"),
        (([[0.0], [0.0]], [[0.0], [1.0]], 1.0, 0.0), r"joint 1 of move \[1\]"),
        (([0.0], [1.0, 2.0], 1.0, 1.0), "the same n"),
        ((0.0, 1.0, 1.0, 1.0), "the same n"),
        (([], [], 1.0, 1.0), "n >= 1"),
        (([0.0, 0.0], [1.0, 1.0], [1.0], 1.0), "v_max has shape"),
        (([[0.0]] * 2, [[1.0]] * 3, 1.0, 1.0), "must broadcast"),
        ((["a"], [1.0], 1.0, 1.0), "real numbers"),
        (([[0.0], [1.0, 2.0]], [1.0], 1.0, 1.0), "ragged"),
        (([1j], [1.0], 1.0, 1.0), "real numbers"),
        (([-1e308], [1e308], 1.0, 1.0), "too long for a number"),
        (([0.0], [1e300], 1e-300, 1.0), "longer than the largest number"),
    ],
)
def test_bad_input_gets_one_line(given, message):
    with pytest.raises(InputError, match=message) as caught:
        min_time(*given)
    assert "\n" not in str(caught.value)


def test_an_unknown_synchronisation_is_refused():
    with pytest.raises(InputError, match="'none', 'time' or 'phase'"):
        min_time([0.0], [1.0], 1.0, 1.0, synchronise="both")
    with pytest.raises(InputError, match="nan"):
        min_time([0.0], [1.0], 1.0, 1.0).sample(math.nan)


# ---- the figure ----------------------------------------------------------------------------------------------------


def lines(axes, style="-"):
    return [line for line in axes.lines if line.get_linestyle() == style and len(line.get_xdata()) > 2]


@pytest.mark.parametrize("n", [1, 3, 4, 6])
@every_way
def test_the_figure_draws_the_motion_and_its_limits(n, synchronise):
    from chainrule.plot.timing import draw_profiles
    from chainrule.profiles import finding

    start, goal, v, a = (part[0] for part in random_moves(1, n, seed=n))
    move = min_time(start, goal, v, a, synchronise=synchronise)
    figure = draw_profiles(move)
    assert len(figure.axes) == 2 * n
    assert finding(move).split()[0] in figure.get_suptitle()
    titled = [axes for axes in figure.axes if axes.get_title(loc="left")]
    assert [axes.get_title(loc="left").split(",")[0] for axes in titled] == [
        f"q{j + 1}: case {c}" for j, c in enumerate(move.cases)
    ]
    for j, axes in enumerate(titled):
        (curve,) = lines(axes)
        times, speeds = (np.asarray(x, float) for x in (curve.get_xdata(), curve.get_ydata()))
        np.testing.assert_allclose(np.trapezoid(speeds, times), np.degrees(goal - start)[j], atol=1e-9)
        dashed = sorted({float(y) for line in axes.lines if line.get_linestyle() == "--" for y in line.get_ydata()})
        np.testing.assert_allclose(dashed, np.degrees([-v[j], v[j]]))


def test_the_figure_takes_prismatic_joints_and_no_motion_and_refuses_batches():
    from chainrule.plot.timing import draw_profiles

    figure = draw_profiles(min_time([0.0, 0.0], [1.0, 0.5], 1.0, [1.0, np.inf]), "RP")
    assert figure.axes[1].get_ylabel() == "[m/s]"
    draw_profiles(min_time([0.0], [0.0], 1.0, 1.0), title="nothing moves")
    for move, kinds in ((min_time([[0.0]], [[1.0]], 1.0, 1.0), "R"), (min_time([0.0], [1.0], 1.0, 1.0), "RR")):
        with pytest.raises(InputError, match="one motion"):
            draw_profiles(move, kinds)


@pytest.mark.parametrize(
    ("move", "words"),
    [
        (([0.0], [0.0], 1.0, 1.0), "no joint has to move"),
        (([0.0], [1.0], 1.0, 1.0), "the joint needs all of it: no other"),
        (([0.0, 0.0], [1.0, 1.0], 1.0, 1.0), "every joint needs all of it: no other"),
        (([0.0, 0.0], [1.0, 0.0], [1.0, 0.0], 1.0), "every joint that can move needs all of it: no other"),
        (([0.0] * 3, [1.0, 1.0, 0.5], 1.0, 1.0), "joints 1 and 2 need all of it; joint 3 has slack"),
        (([0.0] * 5, [1.0, 0.1, 0.1, 0.1, 0.1], 1.0, 1.0), "joint 1 needs all of it; the others have slack"),
    ],
)
def test_the_finding_says_what_holds(move, words):
    from chainrule.profiles import finding

    assert words in finding(min_time(*move))


def test_the_finding_of_a_straight_line_that_takes_longer():
    from chainrule.profiles import finding

    move = min_time([0.0, 0.0], [1.0, 0.5], [1.0, 0.3], 1.0, synchronise="phase")
    assert "longer than any joint needs" in finding(move)
