"""Which postures can follow a path: against kinematics, against counting, and against paths made to fit."""

import json
import math

import numpy as np
import pytest
from regional_arms import TURN, general, orthogonal, same_angles, tip_and_determinant

import chainrule as cr
from chainrule import InputError


def along(corners):
    """A polyline by its length: s in [0, 1] to points."""
    corners = np.asarray(corners, float)
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    return lambda s: np.stack([np.interp(s, lengths / lengths[-1], x) for x in corners.T], axis=-1)


def check(design, at, found):
    """Every joint path is continuous, follows the points and is regular; those that stop end in a singularity."""
    assert found.postures
    size = np.abs(tip_and_determinant(design, np.random.default_rng(0).uniform(-3, 3, (500, 3)))[1]).max()
    for i, posture in enumerate(found.postures):
        assert same_angles(posture.start, found.starts[i], 1e-12)
        assert same_angles(posture.q[0], posture.start, 1e-12)
        assert posture.s[0] == 0.0
        assert (np.diff(posture.s) > 0.0).all()
        tip, det = tip_and_determinant(design, posture.q)
        np.testing.assert_allclose(tip, at(posture.s), rtol=0, atol=1e-6)
        assert np.abs(np.diff(posture.q, axis=0)).max(initial=0.0) < 0.6
        assert (det * det[0] > 0.0).all()
        if posture.reaches_end:
            assert posture.stops_at is None
            assert posture.reason == ""
            assert posture.s[-1] == 1.0
            assert same_angles(posture.q[-1], found.ends[posture.end], 1e-9)
        else:
            assert posture.s[-1] == pytest.approx(posture.stops_at, abs=1e-6)
            assert abs(det[-1]) < 1e-2 * size
            assert posture.reason
            if posture.merges_with is not None:
                assert found.postures[posture.merges_with].merges_with == i
                other = found.postures[posture.merges_with]
                joints = slice(2, 3) if "free" in posture.reason else slice(0, 3)  # a free joint may differ
                assert same_angles(posture.q[-1, joints], other.q[-1, joints], 1e-2)
    ends = [posture.end for posture in found.postures if posture.reaches_end]
    assert len(set(ends)) == len(ends)


@pytest.mark.parametrize("family", [orthogonal, general])
def test_polylines_between_points_that_can_be_reached(family):
    rng = np.random.default_rng(21)
    stops = 0
    for _ in range(10):
        design = family(rng)
        corners, _ = tip_and_determinant(design, rng.uniform(-math.pi, math.pi, (3, 3)))
        found = design.feasible_postures(corners)
        check(design, along(corners), found)
        assert found.certified
        stops += sum(not posture.reaches_end for posture in found.postures)
        sampled = design.feasible_postures(along(corners))
        assert not sampled.certified
        assert [p.end for p in sampled.postures] == [p.end for p in found.postures]
        for a, b in zip(sampled.postures, found.postures, strict=True):
            assert a.stops_at == pytest.approx(b.stops_at, abs=1e-9)
    assert stops > 3


def test_the_events_are_where_the_number_of_postures_changes():
    rng = np.random.default_rng(22)
    changes = 0
    for design in (*(orthogonal(rng) for _ in range(6)), *(general(rng) for _ in range(6))):
        corners, _ = tip_and_determinant(design, rng.uniform(-math.pi, math.pi, (2, 3)))
        found = design.feasible_postures(corners)
        s = np.linspace(0.0, 1.0, 400)
        number = np.array([len(design.postures(*point)) for point in along(corners)(s)])
        for k in np.flatnonzero(np.diff(number)):
            assert ((found.events >= s[k] - 1e-12) & (found.events <= s[k + 1] + 1e-12)).any()
            changes += 1
        quiet = np.searchsorted(found.events, s[:-1]) == np.searchsorted(found.events, s[1:])
        assert (np.diff(number)[quiet] == 0).all()
    assert changes > 5


@pytest.mark.parametrize("lengths", [(1.0, 2.0, 1.5, 1.0), (1.0, 3.0, 4.0, 3.0)])
def test_a_cuspidal_arm_comes_back_in_another_posture(lengths):
    """Once round a cusp, along the image of a posture change: one posture becomes the other, and does not come back."""
    design = cr.orthogonal_3r(*lengths)
    change = design.posture_change()

    def loop(s):
        tip, _ = tip_and_determinant(design, change.sample(s))
        return np.stack([np.hypot(tip[..., 0], tip[..., 1]), 0.0 * tip[..., 0], tip[..., 2]], axis=-1)

    corners = loop(np.linspace(0.0, 1.0, 60))
    corners[-1] = corners[0]
    for path, certified in ((corners, True), (loop, False)):
        found = design.feasible_postures(path)
        assert found.closed
        assert found.flips
        assert found.certified == certified
        begin, end = (
            [k for k, q in enumerate(found.starts) if same_angles(q[1:], row[1:], 1e-6)]
            for row in change.sample([0.0, 1.0])
        )
        assert found.permutation[begin[0]] == end[0] != begin[0]
        check(design, along(corners) if certified else loop, found)


def test_an_arm_that_is_not_cuspidal_never_flips():
    design = cr.orthogonal_3r(1.0, 0.5, 2.5, 0.5)
    rng = np.random.default_rng(23)
    loops = 0
    for q in rng.uniform(-math.pi, math.pi, (6, 3)):
        centre, _ = tip_and_determinant(design, q)
        turn = np.linspace(0.0, TURN, 24)
        corners = centre + 0.6 * np.stack([np.cos(turn), np.sin(turn), np.sin(turn)], axis=-1)
        corners[-1] = corners[0]
        if not len(design.postures(*corners[0])):
            continue
        found = design.feasible_postures(corners)
        assert found.closed
        assert not found.flips
        loops += any(posture.reaches_end for posture in found.postures)
    assert loops > 1


def test_leaving_the_workspace_says_so():
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    inside = tip_and_determinant(design, np.array([0.3, 0.2, 0.1]))[0]
    found = design.feasible_postures([inside, 9.0 * inside])
    assert found.feasible == ()
    assert found.ends.shape == (0, 3)
    last = [posture for posture in found.postures if "leaves the workspace" in posture.reason]
    assert len(last) == 2
    assert last[0].stops_at == last[1].stops_at == max(posture.stops_at for posture in found.postures)
    backwards = design.feasible_postures([9.0 * inside, inside])
    assert backwards.starts.shape == (0, 3)
    assert backwards.postures == ()
    assert len(backwards.ends) == len(design.postures(*inside))


def test_through_the_point_where_joint_2_is_free():
    """The tip passes exactly through a point that it reaches on axis 2, where theta2 is free: cos(theta3) = -3/5,
    rho^2 = 8^2 + (4 + 2)^2 = 10^2. The postures that are singular there stop, the others do not notice."""
    design = cr.orthogonal_3r(8.0, 3.0, 5.0, 2.0)
    line = math.acos(-0.6)
    corners = np.array([[10.0, 0.0, -0.5], [10.0, 0.0, 0.5]])
    found = design.feasible_postures(corners)
    check(design, along(corners), found)
    assert 0.5 in found.events
    there = [posture for posture in found.postures if posture.stops_at == 0.5]
    assert len(there) == 2
    for posture in there:
        assert "axis of joint 2, which is free" in posture.reason
        assert posture.q[-1, 2] == pytest.approx(line, abs=1e-6)
    beside = design.feasible_postures(corners + np.array([1e-3, 0.0, 0.0]))
    assert len(beside.postures) == len(found.postures)


def test_two_events_that_doubles_cannot_tell_apart():
    """Past a point where joint 2 is free, at rho = sqrt(37), which no double is: the path misses it by 4e-16 m."""
    design = cr.orthogonal_3r(1.0, 3.0, 5.0, 2.0)
    corners = np.array([[math.sqrt(37.0), 0.0, -0.5], [math.sqrt(37.0), 0.0, 0.5]])
    found = design.feasible_postures(corners)
    assert not found.certified
    check(design, along(corners), found)
    assert found.feasible == (0, 1)


def test_a_path_that_begins_on_a_singular_curve():
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    joint = design.singular_curves(60)[0].joint[17]
    begin = tip_and_determinant(design, np.array([0.0, *joint]))[0]
    for goal in ([2.0, 0.0, 0.5], [9.0, 0.0, 0.0]):
        found = design.feasible_postures([begin, goal])
        for posture in found.postures:
            assert posture.reaches_end or posture.reason


def test_plain_values_and_bad_input():
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    found = design.feasible_postures([[2.0, 0.0, 0.5], [2.5, 0.2, 0.5]])
    plain = json.loads(json.dumps(found.to_dict()))
    assert len(plain["postures"]) == len(found.starts)
    assert found.permutation is None
    assert not found.flips
    wrong = {
        "one point": [[1.0, 2.0, 3.0]],
        "two coordinates": [[1.0, 2.0], [2.0, 3.0]],
        "the same point twice": [[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]],
        "nan": [[1.0, 2.0, math.nan], [1.0, 2.0, 3.0]],
        "text": "path",
        "a function of another shape": lambda s: np.zeros((*np.shape(s), 2)),
    }
    for path in wrong.values():
        with pytest.raises(InputError):
            design.feasible_postures(path)
