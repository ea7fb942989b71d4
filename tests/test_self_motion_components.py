"""All self-motion curves of spatial and other arms: counts against searches, symmetries, hostile targets."""

from __future__ import annotations

import math

import numpy as np
import pytest
from arms_under_test import crooked_rrpr

import chainrule as cr
from chainrule.cuspidality.normal_form import evaluator
from chainrule.self_motions.components import searched
from chainrule.self_motions.continuation import trace_many
from chainrule.self_motions.held import Held, target_of
from chainrule.self_motions.identity import Known
from chainrule.self_motions.projection import project, start_points
from chainrule.self_motions.spherical import orientations, turn
from chainrule.self_motions.srs import Swivel
from chainrule.self_motions.sweep import Sweep, real_angles

QUARTER = math.pi / 2.0
PANDA, IIWA = cr.load("panda"), cr.load("iiwa14")


def arm_of(rows: list[tuple[float, float, float]], name: str) -> cr.Arm:
    return cr.Arm.from_dh([("R", alpha, a, d, 0.0) for alpha, a, d in rows], name=name)


#: A spherical wrist on a general arm, one on an arm with parallel axes, and one with skew axes.
WRISTED = [(0.0, 0.0, 0.3), (-1.2, 0.1, 0.05), (0.9, 0.25, 0.1), (1.3, 0.2, 0.15), (-QUARTER, 0.08, 0.4)]
GENERAL = arm_of([*WRISTED, (QUARTER, 0.0, 0.0), (-QUARTER, 0.0, 0.1)], "general_wrist")
ELBOWED = [(0.0, 0.0, 0.3), (-QUARTER, 0.1, 0.05), (0.0, 0.35, 0.1), (QUARTER, 0.2, 0.15), (-QUARTER, 0.0, 0.4)]
PARALLEL = arm_of([*ELBOWED, (QUARTER, 0.0, 0.0), (-QUARTER, 0.0, 0.1)], "parallel_wrist")
SKEW = arm_of([*WRISTED, (1.0, 0.0, 0.0), (-1.2, 0.0, 0.1)], "skew_wrist")


def poses(arm: cr.Arm, count: int, seed: int) -> np.ndarray:
    return arm.pose(np.random.default_rng(seed).uniform(-math.pi, math.pi, (count, arm.n)))


def lengths(curves: tuple[cr.Component, ...]) -> np.ndarray:
    return np.sort([curve.length for curve in curves])


def known(arm: cr.Arm, motion: cr.SelfMotion) -> Known:
    found = Known(Held(arm, motion.task), motion.target)
    for curve in motion.components:
        found.add(curve)
    return found


# ---- the panda ---------------------------------------------------------------------------------------------------


def test_the_panda_has_eight_or_four_loops_in_pairs_of_equal_length() -> None:
    counts = set()
    for pose in poses(PANDA, 30, 1):
        found = cr.self_motion(PANDA, pose)
        assert (found.status, found.method, found.complete) == ("regular", "sweep", "proved")
        counts.add(found.count)
        signs = [curve.signs["q2"] for curve in found.components]
        assert signs.count(1) == signs.count(-1) == found.count / 2
        for sign in (1, -1):  # the other posture of the shoulder
            other = lengths(tuple(c for c in found.components if c.signs["q2"] == -sign))
            same = lengths(tuple(c for c in found.components if c.signs["q2"] == sign))
            np.testing.assert_allclose(same, other, rtol=1e-9)
        assert all(curve.closed and curve.residual < 1e-12 for curve in found.components)
    assert counts == {4, 8}


@pytest.mark.parametrize("seed", range(4))
def test_every_start_that_reaches_the_pose_lies_on_a_listed_loop(seed: int) -> None:
    (pose,) = poses(PANDA, 1, 100 + seed)
    found = cr.self_motion(PANDA, pose)
    q, arrived = project(PANDA, start_points(PANDA, 500, seed), pose)
    on = known(PANDA, found).which(q[arrived])
    assert arrived.sum() > 300
    assert set(on.tolist()) == set(range(found.count))  # none is -1, and every loop is met


def test_loops_are_apart_and_through_their_start() -> None:
    (pose,) = poses(PANDA, 1, 7)
    found = cr.self_motion(PANDA, pose)
    for k, curve in enumerate(found.components):
        q = curve.at(np.linspace(0.03, 0.97, 23))
        assert (known(PANDA, found).which(q) == k).all()
        assert (known(PANDA, found).which(q + 2.0 * math.pi) == k).all()
        moved = q + 1e-5 * np.eye(7)[1]
        assert (known(PANDA, found).which(moved) == -1).all()  # near is not on


def test_a_pose_out_of_reach_has_none() -> None:
    for arm in (PANDA, IIWA, GENERAL):
        pose = arm.pose(np.zeros(arm.n))
        pose[:3, 3] += 5.0
        found = cr.self_motion(arm, pose)
        assert (found.status, found.count, found.complete, found.length) == ("unreachable", 0, "proved", 0.0)


def test_a_reconnection_of_two_loops_and_their_pairs_is_met_on_the_right_side() -> None:
    start = PANDA.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4])
    ends = []
    for shift in (0.1005, 0.1006):  # 8 loops become 8 others
        pose = start.copy()
        pose[0, 3] += shift
        found = cr.self_motion(PANDA, pose)
        least = min(curve.manipulability[0] for curve in found.components)
        assert (found.count, found.complete) == (8, "proved")
        assert least < 1e-2
        ends.append(lengths(found.components))
        again = searched(Held(PANDA, "pose"), pose, 300)
        np.testing.assert_allclose(lengths(again.components), ends[-1], rtol=1e-8)
    change = np.abs(ends[0] - ends[1])  # in a step of 0.1 mm
    assert (change > 0.1).sum() == 4
    assert np.sort(change)[:4].max() < 0.01


# ---- S-R-S -------------------------------------------------------------------------------------------------------


def test_the_iiwa_has_eight_loops_of_one_length_labelled_by_signs() -> None:
    for pose in poses(IIWA, 12, 3):
        found = cr.self_motion(IIWA, pose)
        assert (found.method, found.complete, found.count) == ("closed form", "proved", 8)
        np.testing.assert_allclose([c.length for c in found.components], found.components[0].length, rtol=1e-9)
        labels = {tuple(curve.signs[name] for name in ("q2", "q4", "q6")) for curve in found.components}
        assert len(labels) == 8
        for curve in found.components:  # the elbow's angle does not change
            assert np.ptp(curve.q[:, 3]) < 1e-9


def test_flips_of_shoulder_elbow_and_wrist_map_the_loops_onto_one_another() -> None:
    """(a + pi, -b, c + pi) of three axes in a row: the same pose, and onto another listed loop of the same length."""
    for arm, firsts in ((IIWA, (0, 2, 4)), (PANDA, (0,))):
        (pose,) = poses(arm, 1, 9)
        motion = cr.self_motion(arm, pose)
        table = known(arm, motion)
        for first in firsts:
            partners = []
            for k, curve in enumerate(motion.components):
                q = curve.at(np.linspace(0.0, 1.0, 20))
                q[:, [first, first + 2]] += math.pi
                q[:, first + 1] *= -1.0
                np.testing.assert_allclose(arm.pose(q), np.broadcast_to(pose, (20, 4, 4)), atol=1e-12)
                (other,) = set(table.which(q).tolist())
                assert other not in (-1, k)
                assert motion.components[other].length == pytest.approx(curve.length, rel=1e-12)
                assert motion.components[other].residual < 1e-12
                partners.append(other)
            assert sorted(partners) == list(range(motion.count))


def test_elbow_angles_are_where_two_points_are_at_the_distance() -> None:
    rng = np.random.default_rng(18)
    for _ in range(30):
        before, behind = rng.normal(size=(2, 3))
        angle = rng.uniform(-math.pi, math.pi)
        square = float(((turn(angle) @ behind - before) ** 2).sum())
        found, share = evaluator("spherical_elbow")(before, behind, np.array([square]))
        for each in found:
            assert ((turn(each) @ behind - before) ** 2).sum() == pytest.approx(square, rel=1e-12)
        assert abs(share[0]) <= 1.0
        assert np.abs(np.exp(1j * found) - np.exp(1j * angle)).min() < 1e-7
        assert abs(evaluator("spherical_elbow")(before, behind, np.array([square + 100.0]))[1][0]) > 1.0


def test_swivel_postures_hold_the_pose_and_lie_on_the_loops_and_circles() -> None:
    (pose,) = poses(IIWA, 1, 4)
    swivel = Swivel.of(IIWA, pose)
    assert swivel is not None
    q = swivel.postures(np.linspace(0.0, 6.0, 11))
    assert q.shape == (2, 2, 2, 11, 7)
    np.testing.assert_allclose(IIWA.pose(q), np.broadcast_to(pose, (2, 2, 2, 11, 4, 4)), atol=1e-12)
    on = known(IIWA, cr.self_motion(IIWA, pose)).which(q.reshape(-1, 7)).reshape(8, 11)
    assert (on == on[:, :1]).all()
    assert sorted(on[:, 0].tolist()) == list(range(8))
    upper = cr.Arm.from_dh([("R", 0.0, 0.0, 0.36, 0.0), ("R", -QUARTER, 0.0, 0.0, 0.0)], tool=[0.0, -0.42, 0.0])
    for each, (centre, axis, radius) in zip(q, swivel.circles, strict=True):
        elbow = upper.position(each[..., :2]) - centre
        np.testing.assert_allclose(np.linalg.norm(elbow, axis=-1), radius, atol=1e-12)
        np.testing.assert_allclose(elbow @ axis, 0.0, atol=1e-12)


def test_the_iiwa_by_sweep_and_by_search_has_the_same_loops() -> None:
    (pose,) = poses(IIWA, 1, 5)
    want = lengths(cr.self_motion(IIWA, pose).components)
    np.testing.assert_allclose(lengths(cr.self_motion(IIWA, pose, method="continuation").components), want, rtol=1e-8)


@pytest.mark.parametrize("q", [np.zeros(7), [0.3, 0.5, 0.2, 0.0, 0.4, 0.5, 0.1], [0.3, 0.0, 0.2, 1.0, 0.4, 0.5, 0.1]])
def test_singular_poses_of_the_iiwa_are_called_so(q: list[float]) -> None:
    found = cr.self_motion(IIWA, IIWA.pose(q))
    assert found.status == "singular"
    assert found.detail
    assert found.complete != "proved"
    assert all(curve.length > 0.0 for curve in found.components)


# ---- other arms --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("arm", [GENERAL, PARALLEL, SKEW], ids=lambda arm: arm.name)
def test_a_swept_joint_finds_what_a_search_finds(arm: cr.Arm) -> None:
    for pose in poses(arm, 3, 6):
        found = cr.self_motion(arm, pose)
        assert found.method == "sweep"
        assert (found.complete == "proved") == (arm is not SKEW)
        other = searched(Held(arm, "pose"), pose, 200)
        np.testing.assert_allclose(lengths(found.components), lengths(other.components), rtol=1e-8)


@pytest.mark.parametrize("arm", [PANDA, GENERAL, PARALLEL, SKEW], ids=lambda arm: arm.name)
def test_postures_of_a_swept_joint_are_all_solutions(arm: cr.Arm) -> None:
    q = np.random.default_rng(8).uniform(-math.pi, math.pi, arm.n)
    sweep = Sweep.of(Held(arm, "pose"), arm.pose(q))
    assert sweep is not None
    value = -q[6] if sweep.chain.backwards else q[0]
    postures, rows = sweep.postures(np.array([value, value + 1.0]))
    np.testing.assert_allclose(arm.pose(postures), np.broadcast_to(arm.pose(q), (len(postures), 4, 4)), atol=1e-11)
    gaps = postures[rows == 0] - q
    assert np.abs(gaps - 2.0 * math.pi * np.rint(gaps / (2.0 * math.pi))).max(axis=1).min() < 1e-9
    # a Newton search with the joint held finds no other
    held = np.delete(np.arange(7), sweep.swept)
    free = np.random.default_rng(9).uniform(-math.pi, math.pi, (300, 7))
    free[:, sweep.swept] = q[sweep.swept]
    for _ in range(60):
        e, jacobian, _ = sweep.held.evaluate(free, arm.pose(q))
        square = jacobian[..., held]
        step = np.linalg.solve(
            np.swapaxes(square, 1, 2) @ square + 1e-12 * np.eye(6), np.swapaxes(square, 1, 2) @ e[..., None]
        )
        free[:, held] -= np.clip(step[..., 0], -0.5, 0.5)
    good = np.abs(arm.pose(free) - arm.pose(q)).max(axis=(1, 2)) < 1e-10
    apart = free[good][:, None] - postures[rows == 0][None]
    apart = np.abs(apart - 2.0 * math.pi * np.rint(apart / (2.0 * math.pi))).max(axis=2).min(axis=1)
    assert good.sum() > 20
    assert apart.max() < 1e-6


def test_an_arm_without_spherical_joints_is_searched_and_says_so() -> None:
    arm = crooked_rrpr()
    target = arm.position([0.4, -0.9, 0.15, 1.1])
    found = cr.self_motion(arm, target, "position", starts=40, scale=0.4)
    assert found.method == "continuation"
    assert found.complete.startswith("40 starts and 40 extremal points of joints, last new component at ")
    more = cr.self_motion(arm, target, "position", starts=120, seed=5, scale=0.4)
    np.testing.assert_allclose(lengths(found.components), lengths(more.components), rtol=1e-8)


def test_extremal_points_are_the_ends_of_the_boxes() -> None:
    """Of planar 3R arms the extremal values of each joint are known in closed form."""
    rng = np.random.default_rng(17)
    for _ in range(5):
        arm = cr.planar_3r(*rng.uniform(0.2, 1.0, 3))
        target = arm.position(rng.uniform(-2.0, 2.0, 3))
        known = cr.self_motion(arm, target)
        joints = np.repeat([1, 2, 3], 60)
        q, arrived = project(arm, start_points(arm, 180, 1), target, extremal=joints)
        np.testing.assert_allclose(arm.position(q[arrived]), np.tile(target, (arrived.sum(), 1)), atol=1e-12)
        for joint in (1, 2, 3):
            met = q[arrived & (joints == joint), joint - 1]
            ends = np.concatenate([c.box[joint - 1] for c in known.components if not c.winding[joint - 1]] or [[]])
            for end in ends:  # extrema inside a box may be met too
                assert np.abs(np.exp(1j * met) - np.exp(1j * end)).min() < 1e-8


@pytest.mark.parametrize(
    ("arm", "task"),
    [
        (cr.planar("RRRR", [0.4, 0.3, 0.2, 0.1]), "pose"),
        (cr.planar("RPR", [0.4, 0.3, 0.2], [0.0, 0.5, 0.0]), "position"),
    ],
)
def test_other_tasks_and_prismatic_joints(arm: cr.Arm, task: str) -> None:
    target = target_of(arm, np.random.default_rng(2).uniform(-1.0, 1.0, arm.n), task)
    found = cr.self_motion(arm, target, task, scale=0.5)
    assert found.status == "regular"
    q, arrived = project(arm, start_points(arm, 100, 3), target, task, scale=0.5)
    table = Known(Held(arm, task, 0.5), found.target)
    for curve in found.components:
        table.add(curve)
    assert (table.which(q[arrived]) >= 0).all()
    one = trace_many(arm, q[arrived][:1], task, targets=target, scale=0.5)[0]
    assert np.abs(lengths(found.components) - one.length).min() < 1e-8


def test_planar_3r_by_search_is_the_closed_form() -> None:
    arm = cr.planar_3r(0.40, 0.35, 0.25)
    for radius, count in ((0.1, 2), (0.25, 1), (0.4, 2), (0.7, 1)):
        exact = cr.self_motion(arm, [0.0, radius])
        found = cr.self_motion(arm, [0.0, radius], method="continuation")
        assert exact.count == found.count == count
        np.testing.assert_allclose(lengths(found.components), lengths(exact.components), rtol=1e-8)


# ---- parts -------------------------------------------------------------------------------------------------------


def test_real_angles_are_the_roots_half_a_turn_included() -> None:
    rng = np.random.default_rng(11)
    for degree in (2, 4):
        want = rng.uniform(-math.pi, math.pi, (20, degree))
        want[0, 0] = math.pi
        p = np.ones((20, 1))
        for theta in want.T:  # cos(theta0/2) t - sin(theta0/2)
            low, high = -np.sin(theta / 2.0), np.cos(theta / 2.0)
            grown = np.zeros((20, p.shape[1] + 1))
            grown[:, :-1] += p * low[:, None]
            grown[:, 1:] += p * high[:, None]
            p = grown
        rows, found = real_angles(p)
        for row in range(20):
            mine = found[rows == row]
            assert len(mine) == degree
            distance = np.abs(np.exp(1j * mine)[:, None] - np.exp(1j * want[row])[None])
            assert distance.min(axis=0).max() < 1e-5
    assert not len(real_angles(np.array([[1.0, 0.0, 1.0]]))[0])  # 1 + t^2


def test_orientations_of_three_axes() -> None:
    from scipy.spatial.transform import Rotation

    rng = np.random.default_rng(12)
    second, third = Rotation.random(2, rng=rng).as_matrix()
    angles = rng.uniform(-math.pi, math.pi, (50, 3))
    wanted = turn(angles[:, 0]) @ second @ turn(angles[:, 1]) @ third @ turn(angles[:, 2])
    found, real = orientations(second, third, wanted)
    assert real.all()
    for way in (0, 1):
        a, b, c = found[:, way].T
        np.testing.assert_allclose(turn(a) @ second @ turn(b) @ third @ turn(c), wanted, atol=1e-9)
    assert np.abs(np.exp(1j * found) - np.exp(1j * angles)[:, None]).max(axis=2).min(axis=1).max() < 1e-6


# ---- hostile targets ---------------------------------------------------------------------------------------------

FLIPPED = np.diag([1.0, 1.0, -1.0, 1.0])
BELOW = np.eye(4) + np.eye(4)[3][:, None] * np.array([0.1, 0.0, 0.0, 0.0])


@pytest.mark.parametrize(
    "target",
    [np.eye(3), np.full((4, 4), np.nan), 2.0 * np.eye(4), FLIPPED, BELOW, [[1, 2]], "here", None, 1j * np.eye(4)],
)
def test_targets_that_are_no_pose_are_refused_in_one_line(target: object) -> None:
    with pytest.raises(cr.InputError) as refused:
        cr.self_motion(PANDA, target)
    assert "\n" not in str(refused.value)


def test_other_refusals() -> None:
    pose = PANDA.pose(np.zeros(7))
    with pytest.raises(cr.InputError, match="no curve"):
        cr.self_motion(cr.load("ur5e"), np.eye(4))
    with pytest.raises(cr.InputError, match="one target"):
        cr.self_motion(PANDA, np.stack([pose, pose]))
    with pytest.raises(cr.InputError, match="method"):
        cr.self_motion(PANDA, pose, method="guess")
    with pytest.raises(cr.InputError, match="no closed form"):
        cr.self_motion(PANDA, poses(PANDA, 1, 13)[0], method="closed form")
    with pytest.raises(cr.InputError, match="starts"):
        cr.self_motion(PANDA, pose, starts=0)
    with pytest.raises(cr.InputError, match="scale"):
        cr.self_motion(PANDA, pose, scale=0.0)


def test_singular_postures_that_no_section_meets_are_noticed() -> None:
    """With all joints at 0 the panda's outer axes are in line: postures off the two loops hold its pose too."""
    assert PANDA.manipulability(np.zeros(7)) == 0.0
    found = cr.self_motion(PANDA, PANDA.pose(np.zeros(7)))
    assert found.status == "singular"
    assert found.complete != "proved"
    assert "singular postures" in found.detail
