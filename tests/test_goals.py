"""Postures of a pose, turns of a joint, and the fastest of several goals: against kinematics and against trying all."""

import itertools
import json
import math
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import chainrule as cr
from chainrule import InputError
from chainrule.goals import fastest, nearest_turns, postures, wrapped
from chainrule.report.context import Context
from chainrule.report.parts import timing as part
from chainrule.search import Found
from chainrule.timing import min_time

TURN = 2.0 * math.pi
PAPER = cr.load("planar_3r")


def tip(arm, q):
    """Position and heading by adding up the links."""
    headings = np.cumsum(q, axis=-1)
    lengths = arm.parameters
    x, y = ((lengths * f(headings)).sum(axis=-1) for f in (np.cos, np.sin))
    return x, y, headings[..., -1]


def same_angle(a, b, within=1e-9):
    return np.abs(np.remainder(np.asarray(a) - b + math.pi, TURN) - math.pi) <= within


def random_arms(count, seed):
    """Planar 3R arms, some with links of negative length."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        yield cr.planar_3r(*(random.uniform(0.2, 1.5, 3) * random.choice([1.0, 1.0, -1.0], 3))), random


# ---- postures ------------------------------------------------------------------------------------------------------


def test_every_posture_reaches_the_pose_and_none_is_missing():
    """A random posture's pose has it among its postures, and every one of those reaches the pose."""
    for arm, random in random_arms(300, seed=1):
        q = random.uniform(-math.pi, math.pi, 3)
        x, y, alpha = tip(arm, q)
        found = postures(arm, x, y, alpha)
        assert found.status == "regular"
        assert found.q.shape == (2, 3)
        for row in found.q:
            there = tip(arm, row)
            assert there[:2] == pytest.approx((x, y), abs=1e-12)
            assert same_angle(there[2], alpha, 1e-12)
        assert (np.abs(found.q - q) < 1e-7).all(axis=-1).any()
        assert (found.q > -math.pi).all()
        assert (found.q <= math.pi).all()
        assert found.q[0, 1] > 0.0 > found.q[1, 1]


def test_how_many_postures_follows_from_the_ring_of_the_wrist():
    for arm, random in random_arms(300, seed=2):
        x, y, alpha = random.uniform(-3.0, 3.0, 3)
        l1, l2, l3 = arm.parameters
        wrist = math.hypot(x - l3 * math.cos(alpha), y - l3 * math.sin(alpha))
        found = postures(arm, x, y, alpha)
        reachable = abs(abs(l1) - abs(l2)) < wrist < abs(l1) + abs(l2)
        assert (found.status, len(found.q)) == (("regular", 2) if reachable else ("unreachable", 0))
        assert found.wrist == pytest.approx(wrist, abs=1e-14)
        assert found.ring == pytest.approx((abs(abs(l1) - abs(l2)), abs(l1) + abs(l2)))


def test_stretched_and_folded_postures_are_one():
    """Whatever the rounding of the pose: the elbow is straight exactly."""
    for arm, random in random_arms(300, seed=3):
        q = random.uniform(-math.pi, math.pi, 3)
        q[1] = random.choice([0.0, math.pi])
        if abs(abs(arm.parameters[0]) - abs(arm.parameters[1])) < 1e-3:
            continue
        found = postures(arm, *tip(arm, q))
        assert found.status == "singular"
        assert found.q.shape == (1, 3)
        assert found.q[0, 1] in (0.0, math.pi)
        assert same_angle(found.q[0], q, 1e-12).all()


def test_close_to_stretched_there_are_two():
    found = postures(PAPER, 1.75 - 1e-12, 0.0, 0.0)
    assert found.status == "regular"
    assert 1e-6 < found.q[0, 1] < 1e-5
    assert postures(PAPER, 1.75, 0.0, 0.0).q.tolist() == [[0.0, 0.0, 0.0]]
    assert postures(PAPER, 1.75 + 1e-12, 0.0, 0.0).status == "unreachable"


@pytest.mark.parametrize("lengths", [(1.0, 1.0, 0.5), (-0.7, 0.7, 0.3), (0.7, -0.7, 0.3), (-0.7, -0.7, -0.3)])
def test_a_wrist_on_the_first_axis_leaves_the_first_joint_free(lengths):
    arm = cr.planar_3r(*lengths)
    for alpha in (0.0, 0.3, -2.5, 3.0):
        x, y = lengths[2] * math.cos(alpha), lengths[2] * math.sin(alpha)
        found = postures(arm, x, y, alpha)
        assert found.status == "free"
        assert found.q[0, 0] == 0.0
        for angle in (0.0, 1.0, -2.0):
            there = tip(arm, found.q[0] + [angle, 0.0, -angle])
            assert there[:2] == pytest.approx((x, y), abs=1e-14)
            assert same_angle(there[2], alpha, 1e-14)


def test_postures_of_very_small_and_very_large_arms_are_the_same():
    """Lengths times a power of two leave every bit of the angles as it is, also where squares are no doubles."""
    for exponent in (-700, 700):
        arm = cr.planar_3r(*(math.ldexp(length, exponent) for length in (1.0, 0.5, 0.25)))
        found = postures(arm, math.ldexp(1.25, exponent), math.ldexp(0.5, exponent), 0.0)
        assert (found.q == postures(PAPER, 1.25, 0.5, 0.0).q).all()
        assert found.wrist == math.ldexp(math.hypot(1.0, 0.5), exponent)
        assert found.ring == (math.ldexp(0.5, exponent), math.ldexp(1.5, exponent))
    assert postures(PAPER, 1e308, 1e308, 0.0).status == "unreachable"


def test_the_papers_postures():
    found = postures(PAPER, 1.25, 0.5, 0.0)
    bend = 2.0 * math.atan(0.5)
    expected = [[0.0, math.pi / 2, -math.pi / 2], [bend, -math.pi / 2, math.pi / 2 - bend]]
    np.testing.assert_allclose(found.q, expected, atol=4e-16)
    assert json.dumps(found.to_dict())


@pytest.mark.parametrize(
    ("arm", "pose", "message"),
    [
        (cr.load("panda"), (0.0, 0.0, 0.0), "panda: the postures of a pose are known for planar arms"),
        (cr.planar("RRP", [1.0, 1.0, 1.0]), (0.0, 0.0, 0.0), "three revolute joints"),
        (cr.planar_3r(1.0, 0.0, 1.0), (0.0, 0.0, 0.0), "link 2 has no length"),
        (cr.planar_3r(0.0, 1.0, 1.0), (0.0, 0.0, 0.0), "link 1 has no length"),
        (PAPER, (0.0, math.nan, 0.0), r"pose \(x, y, alpha\)\[1\]: nan"),
        (PAPER, (0.0, "1", 0.0), "real numbers"),
        (PAPER, ([0.0, 1.0], [1.0, 0.0], [0.0, 0.0]), r"arrays of shape \(2,\); three numbers"),
        (PAPER, (1.7e308, 1.7e308, 0.0), "too many times larger"),
        (cr.planar_3r(1e-300, 1e-300, 1.0), (1e300, 0.0, 0.0), "too many times larger"),
    ],
)
def test_what_has_no_postures_is_refused(arm, pose, message):
    with pytest.raises(InputError, match=message) as caught:
        postures(arm, *pose)
    assert "\n" not in str(caught.value)


@settings(max_examples=300, deadline=None)
@given(st.floats(-100.0, 100.0))
def test_wrapped_angles_are_the_same_angles(angle):
    found = float(wrapped(angle))
    assert -math.pi < found <= math.pi
    assert abs(math.remainder(found - angle, TURN)) <= 1e-14 * max(1.0, abs(angle))
    if -math.pi < angle <= math.pi:
        assert found == angle


# ---- turns ---------------------------------------------------------------------------------------------------------


def test_the_nearest_turn_is_the_nearest_of_all_tried():
    random = np.random.default_rng(4)
    start, goals = random.uniform(-6.0, 6.0, 4), random.uniform(-12.0, 12.0, (300, 4))
    found = nearest_turns(start, goals, "RRPR")
    tried = goals[..., None] + TURN * np.arange(-6, 7)
    best = np.abs(tried - start[:, None]).min(axis=-1)
    for j in (0, 1, 3):
        np.testing.assert_allclose(np.abs(found.q[:, j] - start[j]), best[:, j], atol=1e-14)
        assert same_angle(found.q[:, j], goals[:, j], 1e-13).all()
    assert (found.q[:, 2] == goals[:, 2]).all()
    assert found.allowed.all()
    assert not found.either_way.any()


def test_only_turns_inside_the_limits_are_taken():
    random = np.random.default_rng(5)
    limits = np.array([[-2.0, 9.0], [-1.0, 1.0], [0.0, np.inf], [-1.0, 1.0]])
    start, goals = np.array([5.0, 0.5, 0.5, 0.5]), random.uniform(-12.0, 12.0, (400, 4))
    kinds = "RRRP"
    found = nearest_turns(start, goals, kinds, limits)
    for row, goal, allowed in zip(found.q, goals, found.allowed, strict=True):
        possible = True
        for j, kind in enumerate(kinds):
            tried = goal[j] + TURN * (np.arange(-8, 9) if kind == "R" else np.zeros(1))
            inside = tried[(tried >= limits[j, 0]) & (tried <= limits[j, 1])]
            possible &= len(inside) > 0
            if len(inside):
                assert abs(row[j] - start[j]) == pytest.approx(np.abs(inside - start[j]).min(), abs=1e-13)
        assert allowed == possible
    assert 0 < found.allowed.sum() < 400


def test_half_a_turn_has_two_ways():
    both = nearest_turns([0.0, 1.0], [[math.pi, 1.0 - math.pi], [-math.pi, 1.0 + 3 * math.pi]], "RR")
    assert both.either_way.all()
    np.testing.assert_allclose(both.q, [[math.pi, 1.0 + math.pi]] * 2)
    one = nearest_turns([0.0, 1.0], [math.pi, 1.0 - math.pi], "RR", [[-4.0, 3.0], [-4.0, 4.0]])
    np.testing.assert_allclose(one.q, [-math.pi, 1.0 - math.pi])
    assert not one.either_way.any()
    assert not nearest_turns([0.0], [math.pi], "P").either_way.any()
    assert not nearest_turns([0.0], [math.pi - 1e-9], "R").either_way.any()


def test_rounding_moves_no_joint_and_breaks_no_limit():
    start = np.array([0.3, -2.0])
    found = nearest_turns(start, [start + TURN * np.array([3, -5]) * (1 + 1e-16), start + 1e-15], "RR")
    assert (found.q == start).all()
    assert (nearest_turns(start, start + 1e-15, "PP").q != start).all()
    for goal in (0.5 + 2e-15, 0.5 + 2e-15 - TURN):
        edge = nearest_turns([0.0], [goal], "R", [[-0.5, 0.5]])
        assert edge.allowed
        assert edge.q[0] == 0.5
    assert not nearest_turns([0.0], [0.5 + 1e-13], "R", [[-0.5, 0.5]]).allowed


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (([0.0], [[0.0, 1.0]], "R"), "shape"),
        (([[0.0]], [[0.0]], "R"), "shape"),
        (([0.0], [0.0], "X"), "kinds: 'X'"),
        (([0.0], [0.0], "RR"), "each of the 1 joints"),
        (([0.0], [0.0], 7), "kinds: 7"),
        (([0.0], [0.0], "R", [0.0, 1.0]), "position has shape"),
        (([0.0, 2.0], [0.0, 0.0], "RR", [[0.0, 1.0], [0.0, 1.0]]), "start, joint 2: 2 is outside"),
        (([math.nan], [0.0], "R"), "nan"),
        (([1e308], [-1e308], "R"), "too long for a number"),
    ],
)
def test_turns_refuse_bad_input(given, message):
    with pytest.raises(InputError, match=message) as caught:
        nearest_turns(*given)
    assert "\n" not in str(caught.value)


# ---- the fastest goal ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("synchronise", ["none", "time", "phase"])
def test_no_turn_of_any_goal_is_faster(synchronise):
    """All 125 combinations of turns of every goal, tried."""
    random = np.random.default_rng(6)
    turns = TURN * np.array(list(itertools.product(range(-2, 3), repeat=3)))
    for _ in range(60):
        start, goals = random.uniform(-3.0, 3.0, 3), random.uniform(-math.pi, math.pi, (3, 3))
        v, a = random.uniform(0.5, 3.0, (2, 3))
        best = fastest(start, goals, v, a, kinds="RRR", synchronise=synchronise)
        tried = min_time(start, goals[:, None] + turns, v, a, synchronise=synchronise).duration
        np.testing.assert_allclose(best.durations, tried.min(axis=-1), rtol=1e-12)
        assert best.index == tried.min(axis=-1).argmin()
        assert best.move.duration == best.durations[best.index]
        assert best.equally_fast == (best.index,)
        plain = fastest(start, goals, v, a, synchronise=synchronise)
        assert (plain.moves.goal == goals).all()
        assert plain.move.duration >= best.move.duration * (1.0 - 1e-12)


def test_the_papers_choice():
    goals = postures(PAPER, 1.25, 0.5, 0.0).q
    best = fastest([0.0] * 3, goals, PAPER.limits.velocity, PAPER.limits.acceleration, kinds="RRR")
    assert best.index == 1
    assert best.durations == pytest.approx([1.75, 1.5], rel=1e-14)
    assert ["".join(cases) for cases in best.moves.cases] == ["dba", "cba"]
    assert not best.unique
    assert best.move.bottleneck.tolist() == [False, True, False]


def test_goals_as_fast_as_each_other_are_named():
    """Mirror images of a stretched arm's goals."""
    goals = np.array([[0.4, 1.0, -0.2], [-0.4, -1.0, 0.2], [0.5, 1.1, 0.0]])
    best = fastest([0.0] * 3, goals, 1.0, 1.0)
    assert best.equally_fast == (0, 1)
    assert best.index == 0
    assert not fastest([0.0], [[1.0], [-1.0]], 1.0, 1.0).unique
    assert fastest([0.0], [[1.0], [-1.5]], 1.0, 1.0).unique
    assert fastest([0.0], [[1.0]], 1.0, 1.0, kinds="R").unique
    assert not fastest([0.0], [[math.pi]], 1.0, 1.0, kinds="R").unique  # either way round


def test_goals_outside_the_limits_are_passed_over():
    limits = [[-1.0, 1.0]]
    best = fastest([0.0], [[1.5], [-0.9], [0.95]], 1.0, 1.0, position=limits)
    assert best.index == 1
    assert best.durations[0] == math.inf
    assert best.to_dict()["durations"][0] is None
    assert json.dumps(best.to_dict(), allow_nan=False)
    with pytest.raises(InputError, match="no goal is inside the joint limits"):
        fastest([0.0], [[1.5], [2.0]], 1.0, 1.0, kinds="R", position=limits)


@pytest.mark.parametrize("goals", [np.zeros((0, 3)), [0.0, 0.0, 0.0], [[0.0, 0.0]], [[[0.0] * 3]]])
def test_goals_of_wrong_shape_are_refused(goals):
    with pytest.raises(InputError, match=r"\(n,\) and \(k, n\), k >= 1"):
        fastest([0.0] * 3, goals, 1.0, 1.0)


def test_bounds_are_of_joints_not_of_goals():
    with pytest.raises(InputError, match="v_max has 2 axes"):
        fastest([0.0, 0.0], [[1.0, 1.0]] * 2, np.ones((2, 2)), 1.0)


# ---- the command ---------------------------------------------------------------------------------------------------


@pytest.fixture
def call(call):
    return partial(call, "min-time")


def test_the_command_solves_the_exercise(call, tmp_path):
    figure = tmp_path / "profiles.svg"
    code, out, err = call("planar_3r", "--from", "0,0,0", "--pose", "1.25 0.5 0", "--json", "--figure", figure)
    assert (code, err) == (0, "")
    answer = json.loads(out)
    assert answer["index"] == 1
    assert answer["move"]["duration"] == pytest.approx(1.5)
    assert answer["move"]["cases"] == ["c", "b", "a"]
    assert answer["postures"]["status"] == "regular"
    assert "<svg" in figure.read_text("utf-8")
    code, out, _ = call("planar_3r", "--from", "0,0,0", "--pose", "1.25 0.5 0")
    assert code == 0
    assert "The motion takes 1.5 s: joint 2 needs all of it" in out
    assert "q1\u00a0=\u00a053.1°" in out


def test_the_command_takes_goals_bounds_and_degrees(call):
    arguments = ("puma560", "--deg", "--from", "0 0 0 0 0 0", "--velocity", "90,90,90,90,90,90", "--json")
    code, out, _ = call(*arguments, "--acceleration", "90,90,90,90,90,90", "--to", "90,0,0,0,0,0")
    assert code == 0
    assert json.loads(out)["move"]["duration"] == pytest.approx(2.0)
    half_turn = ("--acceleration", "90,90,90,90,90,90", "--to", "360,0,0,0,0,0", "--to", "0,90,0,0,0,0")
    code, out, _ = call(
        "planar_3r", "--deg", "--from", "0 0 0", "--to", "360 0 0", "--to", "0 90 0", "--turns", "--json"
    )
    assert code == 0
    assert json.loads(out)["move"]["duration"] == 0.0
    code, out, _ = call("planar_3r", "--deg", "--from", "0 0 0", "--to", "180 0 0", "--turns", "--synchronise", "time")
    assert code == 0
    assert "Joint 1 could as well turn the other way round" in out
    assert call(*arguments, *half_turn[:2])[0] == 2


def test_the_command_says_no_to_a_pose_out_of_reach(call):
    code, out, err = call("planar_3r", "--from", "0,0,0", "--pose", "2,0,0")
    assert (code, err) == (1, "")
    assert out == (
        "The pose cannot be reached: the last joint would be 1.75 m from the base, and can be between 0.5 and 1.5 m.\n"
    )
    code, out, _ = call("planar_3r", "--from", "0,0,0", "--pose", "2,0,0", "--json")
    assert code == 1
    assert json.loads(out)["move"] is None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("planar_3r", "--from", "0,0,0"), "one of --to and --pose"),
        (("planar_3r", "--from", "0,0,0", "--to", "0,0,0", "--pose", "1,1,1"), "one of --to and --pose"),
        (("planar_3r", "--from", "0,0", "--to", "0,0,0"), "--from: 2 numbers given; planar_3r has 3 joints"),
        (("planar_3r", "--from", "0,0,0", "--to", "0,x,0"), "--to, entry 2"),
        (("planar_3r", "--from", "0,0,0", "--to", "0,1,0", "--synchronise", "x"), "'none', 'time' or 'phase'"),
        (("puma560", "--from", "0 0 0 0 0 0", "--to", "1 0 0 0 0 0"), "has no velocity limit for joint1"),
        (("panda", "--from", "0 0 0 0 0 0 0", "--to", "1 0 0 0 0 0 0"), "start, joint 4: 0 is outside the limits"),
        (("planar_3r", "--from", "0,0,0", "--to", "0,1,0", "--figure", "x.gif"), ".svg, .png or .pdf"),
        (("panda", "--from", "0 0 0 -1 0 1 0", "--pose", "1,1,1"), "three revolute joints"),
    ],
)
def test_the_command_refuses_in_one_line(call, arguments, message):
    code, out, err = call(*arguments)
    assert (code, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1


# ---- the report ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["planar_3r", "panda"])
def test_the_report_says_how_fast(name):
    arm = cr.load(name)
    assert part.SECTION.applies(arm)
    context = Context(arm)
    if name == "panda":  # any posture will do, and the search for the best takes long
        context.maximum = Found(0.1, np.array([0.1, -0.5, 0.2, -2.0, 0.3, 1.5, 0.0]), np.empty((0, 7)))
    made = part.SECTION.build(arm, context)
    motion = made.data["motion"]
    again = min_time(motion["start"], motion["goal"], arm.limits.velocity, arm.limits.acceleration)
    assert motion["duration"] == pytest.approx(float(again.duration))
    assert made.data["straight_line"] >= motion["duration"] * (1.0 - 1e-12)
    assert motion["duration"] > 0.0
    (finding,) = [block.text for block in made.blocks if block.kind == "finding"]
    assert f"{motion['duration']:.4g} s" in finding
    (grid,) = [block.table for block in made.blocks if block.kind == "grid"]
    assert len(grid.rows) == arm.n
    (picture,) = [block for block in made.blocks if block.kind == "picture"]
    assert picture.svg.count("case") >= arm.n


def test_the_report_is_silent_where_limits_are_missing():
    assert not part.SECTION.applies(cr.load("puma560"))
    assert not part.SECTION.applies(cr.planar_3r(1.0, 1.0, 1.0).with_limits(velocity=[1.0] * 3))
    still = cr.planar_3r(1.0, 1.0, 1.0).with_limits(velocity=[1.0, 0.0, 1.0], acceleration=[1.0] * 3)
    assert not part.SECTION.applies(still)


def test_the_report_of_an_arm_whose_manipulability_says_nothing():
    """H of two sliding joints is the same everywhere: the motion starts a quarter into the ranges."""
    arm = cr.planar("PP", [0.0, 0.0], [0.0, 1.0]).with_limits(
        position=[[0.0, 1.0]] * 2, velocity=[1.0] * 2, acceleration=[1.0] * 2
    )
    made = part.SECTION.build(arm, Context(arm))
    assert made.data["motion"]["start"] == [0.25, 0.25]
    assert made.data["motion"]["goal"] == [0.5, 0.5]
