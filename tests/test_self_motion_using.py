"""The best posture of a self-motion, self-motion along a path, and joint limits of arms in general."""

from __future__ import annotations

import json
import math
from itertools import pairwise

import numpy as np
import pytest

import chainrule as cr

PANDA = cr.load("panda")
READY = [0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4]
ARM = cr.planar_3r(0.40, 0.35, 0.25)


# ---- limits ------------------------------------------------------------------------------------------------------


def test_the_pandas_own_limits_leave_arcs_within_them() -> None:
    found = cr.self_motion(PANDA, PANDA.pose(READY), limits=True)
    low, high = PANDA.limits.position.T
    assert found.feasible
    assert found.surviving == ()
    inside = total = 0.0
    for curve in found.components:  # the same share of each loop as a fine sampling finds
        q = curve.at((np.arange(20_000) + 0.5) / 20_000)
        q = q - 2.0 * math.pi * np.floor((q - low) / (2.0 * math.pi))
        inside += curve.length * (q <= high).all(axis=1).mean()
    for arc in found.feasible:
        q = arc.at(np.linspace(0.0, 1.0, 200))
        assert (q >= low - 1e-9).all() and (q <= high + 1e-9).all()
        np.testing.assert_allclose(PANDA.pose(q), np.broadcast_to(found.target, (200, 4, 4)), atol=1e-12)
        total += arc.length
    assert abs(total - inside) < 0.01
    here = np.abs(np.concatenate([arc.at(np.linspace(0.0, 1.0, 4001)) for arc in found.feasible]) - READY).max(axis=1)
    assert here.min() < 5e-3  # the posture we came from is on one of them


def test_points_are_as_many_as_asked_for() -> None:
    found = cr.self_motion(PANDA, PANDA.pose(READY), points=33)
    for curve in found.components:
        assert curve.q.shape == (33, 7)
        np.testing.assert_allclose(curve.q[-1] - curve.q[0], 2.0 * math.pi * curve.winding, atol=1e-9)
    json.dumps(found.to_dict(), allow_nan=False)


def test_the_papers_method_follows_one_curve_and_shows_its_errors() -> None:
    found = cr.self_motion(ARM, [0.4, 0.0], method="eigenvector", gamma=0.01)
    (curve,) = found.components
    assert found.complete == "1 start, one curve"
    assert curve.closed
    assert 1e-4 < curve.closure < 0.1
    assert abs(curve.length - cr.self_motion(ARM, [0.4, 0.0]).components[0].length) < 0.1


# ---- the best posture --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("limits", [False, True])
@pytest.mark.parametrize("criterion", ["manipulability", "limits"])
def test_no_sampled_posture_is_better(criterion: str, limits: bool) -> None:
    motion = cr.self_motion(PANDA, PANDA.pose(READY), limits=limits)
    best = cr.best_posture(PANDA, motion, criterion, limits=limits)
    low, high = PANDA.limits.position.T

    def value(q: np.ndarray) -> np.ndarray:
        if criterion == "manipulability":
            jacobian = PANDA.jacobian(q)
            return np.sqrt(np.linalg.det(jacobian @ np.swapaxes(jacobian, 1, 2)))
        return np.min(np.minimum(q - low, high - q) / (0.5 * (high - low)), axis=1)

    sampled = [value(part.at(np.linspace(0.0, 1.0, 3001))).max() for part in motion.arcs]
    assert best.value >= max(sampled) - 1e-12
    assert best.value <= max(sampled) + 1e-3 * abs(max(sampled))
    assert best.curve == int(np.argmax(sampled)) or abs(sampled[best.curve] - max(sampled)) < 1e-3
    assert value(best.q[None])[0] == pytest.approx(best.value, abs=1e-12)
    np.testing.assert_allclose(PANDA.pose(best.q), motion.target, atol=1e-12)
    values = [each.value for each in best.maxima]
    assert all(a >= b - 1e-12 for a, b in pairwise(values))
    json.dumps(best.to_dict(), allow_nan=False)


def test_a_function_of_ones_own_and_its_maximum() -> None:
    """The greatest q3 on the curves of a planar arm is that of their boxes, found independently."""
    motion = cr.self_motion(ARM, [0.4, 0.1])
    best = cr.best_posture(ARM, motion, lambda q: np.cos(q[:, 2] - 0.7))
    turn = min(
        abs(math.remainder(q - 0.7, 2.0 * math.pi))
        for curve in motion.components
        for q in curve.at(np.linspace(0.0, 1.0, 20_001))[:, 2]
    )
    assert best.value == pytest.approx(math.cos(turn), abs=1e-6)
    highest = cr.best_posture(ARM, motion, lambda q: q[:, 2])
    assert highest.value == pytest.approx(max(curve.box[2, 1] for curve in motion.components), abs=1e-9)
    assert len(cr.best_posture(ARM, motion, lambda q: np.zeros(len(q))).maxima) == motion.count


def test_ends_of_arcs_count() -> None:
    arm = ARM.with_limits(position=[(-3.0, 3.0), (-3.0, 3.0), (-1.0, 1.0)])
    best = cr.best_posture(arm, [0.25, 0.0], lambda q: q[:, 2])
    assert best.value == pytest.approx(1.0, abs=1e-9)


def test_what_the_best_posture_refuses() -> None:
    with pytest.raises(cr.InputError, match="criterion"):
        cr.best_posture(ARM, [0.4, 0.0], "speed")
    with pytest.raises(cr.InputError, match="criterion"):
        cr.best_posture(ARM, [0.4, 0.0], lambda q: q)
    with pytest.raises(cr.InputError, match="criterion"):
        cr.best_posture(ARM, [0.4, 0.0], lambda q: np.full(len(q), np.nan))
    with pytest.raises(cr.InputError, match="no joint has two limits"):
        cr.best_posture(ARM, [0.4, 0.0], "limits")
    with pytest.raises(cr.InputError, match="no posture reaches"):
        cr.best_posture(ARM, [4.0, 0.0])
    with pytest.raises(cr.InputError, match="within the limits"):
        cr.best_posture(ARM.with_limits(position=[(0.0, 0.1)] * 3), [0.25, 0.0])


# ---- the nearest singular target ------------------------------------------------------------------------------------


def test_the_nearest_singular_target_of_planar_arms_is_the_nearest_singular_radius() -> None:
    rng, met = np.random.default_rng(31), 0
    for _ in range(15):
        arm = cr.planar_3r(*rng.uniform(0.1, 1.0, 3))
        motion = cr.self_motion(arm, rng.uniform(-0.7, 0.7, 2) * arm.parameters.sum())
        if motion.status != "regular":
            continue
        near = cr.nearest_singular(arm, motion)
        assert near.distance == pytest.approx(motion.to_singular, abs=1e-9)  # from the lengths, in closed form
        assert np.linalg.norm(near.target - motion.target) == pytest.approx(near.distance, abs=1e-9)
        assert np.linalg.svd(arm.jacobian(near.q, task="position"), compute_uv=False)[1] < 1e-8
        np.testing.assert_allclose(arm.position(near.q), near.target, atol=1e-12)
        met += 1
    assert met >= 10


def test_towards_a_singular_target_of_the_panda_its_curves_come_to_a_singular_posture() -> None:
    motion = cr.self_motion(PANDA, PANDA.pose(READY))
    near = cr.nearest_singular(PANDA, motion)
    assert np.linalg.svd(PANDA.jacobian(near.q), compute_uv=False)[-1] < 1e-8
    shift = near.target[:3, 3] - motion.target[:3, 3]
    turn = near.target[:3, :3] @ motion.target[:3, :3].T
    sine = np.linalg.norm([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2.0
    assert near.distance == pytest.approx(math.hypot(np.linalg.norm(shift), near.length * sine), rel=1e-9)
    assert near.distance < 0.02 and near.manipulability == min(c.manipulability[0] for c in motion.components)
    from scipy.spatial.transform import Rotation

    least = [near.manipulability]
    for share in (0.9, 0.999):
        pose = motion.target.copy()
        pose[:3, 3] += share * shift
        pose[:3, :3] = Rotation.from_rotvec(share * Rotation.from_matrix(turn).as_rotvec()).as_matrix() @ pose[:3, :3]
        least.append(min(c.manipulability[0] for c in cr.self_motion(PANDA, pose).components))
    assert least[0] > 2.0 * least[1] > 4.0 * least[2]
    with pytest.raises(cr.InputError, match="no posture reaches"):
        cr.nearest_singular(ARM, [4.0, 0.0])
    json.dumps(near.to_dict(), allow_nan=False)


# ---- along a path ------------------------------------------------------------------------------------------------


def test_changes_on_a_planar_path_are_the_singular_radii() -> None:
    """Straight out along x: 2, 1, 2, 1, 0 curves between 0.2, 0.3, 0.5 and 1.0 m."""
    x = [0.1, 0.25, 0.4, 0.7, 1.2]
    along = cr.self_motion_along(ARM, [[value, 0.0] for value in x])
    assert along.count.tolist() == [2, 1, 2, 1, 0]
    assert [change.kind for change in along.changes] == ["merge", "split", "merge", "vanish"]
    where = [np.interp(change.at, range(5), x) for change in along.changes]
    np.testing.assert_allclose(where, [0.2, 0.3, 0.5, 1.0], atol=1e-12)
    assert all(change.width == 0.0 for change in along.changes)
    assert not along.followable
    assert along.labels[1] == along.changes[0].after
    first, second = (along.reached(k) for k in (0, 1))
    assert first[1:] == second[1:]  # after the merger nothing tells them apart
    assert [len(each) for each in first] == [1, 1, 2, 1, 0]
    json.dumps(along.to_dict(), allow_nan=False)


def test_two_crossings_between_neighbouring_targets_are_seen_in_the_plane() -> None:
    along = cr.self_motion_along(ARM, [[0.45, 0.3], [0.45, -0.3]])  # through 0.45 m, where there are two curves
    assert along.count.tolist() == [1, 1]
    assert [change.kind for change in along.changes] == ["split", "merge"]
    assert not along.followable


def test_a_path_in_closed_form_is_the_one_that_points_take() -> None:
    """Random arms and straight paths: the same counts, changes and labels as by moving points from target to target."""
    rng, kinds = np.random.default_rng(21), []
    for _ in range(4):
        arm = cr.planar_3r(*rng.uniform(0.15, 1.0, 3))
        targets = rng.uniform(-0.8, 0.8, (2, 2)) * arm.parameters.sum()
        quick = cr.self_motion_along(arm, targets)
        walked = cr.self_motion_along(arm, targets, method="continuation", starts=8, tolerance=0.02)
        assert quick.count.tolist() == walked.count.tolist()
        np.testing.assert_allclose(quick.length, walked.length, rtol=1e-8)
        assert quick.families == walked.families
        assert [change.kind for change in quick.changes] == [change.kind for change in walked.changes]
        assert [motion.count for motion in quick.motions] == quick.count.tolist()
        kinds += [change.kind for change in quick.changes]
    assert {"split", "merge"} <= set(kinds)


def test_a_path_within_limits_is_followed_on_arcs() -> None:
    """A posture moved on in small steps stays within the limits on an arc that keeps its label, to the path's end."""
    arm = cr.planar_3r(0.5, 0.4, 0.3).with_limits(position=[(-2.5, 2.5), (-2.0, 2.2), (-1.8, 2.4)])
    targets = np.array([[0.72, 0.0], [0.735, -0.05], [0.75, -0.1]])
    along = cr.self_motion_along(arm, targets, limits=True, tolerance=1e-3)
    assert along.count.tolist() == [len(motion.arcs) for motion in along.motions]
    assert along.followable and along.count.tolist() == [3, 3, 3]
    low, high = arm.limits.position.T
    for label in along.families:
        arc = along.motions[0].arcs[along.labels[0].index(label)]
        q = arc.at(0.5)
        fine = np.concatenate([np.linspace(a, b, 60) for a, b in pairwise(targets)])
        for target in fine:
            for _ in range(4):
                q = q - np.linalg.pinv(arm.jacobian(q, task="position")) @ (arm.position(q) - target)
            assert (q > low).all() and (q < high).all()
        last = along.motions[-1].arcs
        apart = [np.linalg.norm(each.at(np.linspace(0.0, 1.0, 4001)) - q, axis=1).min() for each in last]
        assert along.labels[-1][int(np.argmin(apart))] == label and min(apart) < 3e-3
    tight = arm.with_limits(position=[(-0.2, 0.2), (0.5, 1.0), (0.2, 0.6)])
    nothing = cr.self_motion_along(tight, [tight.position([0.0, 0.8, 0.4]), [0.1, 0.1]], limits=True, tolerance=1e-3)
    assert nothing.count.tolist()[0] == 1 and nothing.count.tolist()[1] == 0
    assert [change.kind for change in nothing.changes][-1] == "vanish" and not nothing.followable


def test_within_a_region_all_families_go_on() -> None:
    rng = np.random.default_rng(3)
    radius, angle = rng.uniform(0.32, 0.48, 6), np.cumsum(rng.uniform(-0.2, 0.2, 6))
    targets = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    along = cr.self_motion_along(ARM, targets)
    assert along.changes == ()
    assert along.families == (0, 1)
    assert along.followable
    for motion, labels in zip(along.motions, along.labels, strict=True):  # the sign of q2 is what keeps them apart
        signs = {label: curve.signs["q2"] for label, curve in zip(labels, motion.components, strict=True)}
        assert signs[0] == along.motions[0].components[0].signs["q2"]
        assert signs[1] == -signs[0]


def test_the_other_task_is_closed_in_on() -> None:
    along = cr.self_motion_along(ARM, [[0.25, 0.0], [0.4, 0.0]], "x_alpha", tolerance=1e-8)
    (change,) = along.changes
    assert change.width <= 1e-8
    assert 0.25 + 0.15 * change.at == pytest.approx(0.30, abs=1e-8)  # l3 + l1 - l2


def test_pandas_labels_follow_the_loops() -> None:
    start = PANDA.pose(READY)
    end = start.copy()
    end[0, 3] += 0.002
    along = cr.self_motion_along(PANDA, [start, end])
    assert along.changes == ()
    assert sorted(along.labels[1]) == sorted(along.labels[0]) == list(range(8))
    first, last = along.motions
    for k, curve in enumerate(last.components):
        old = first.components[along.labels[0].index(along.labels[1][k])]
        assert old.signs["q2"] == curve.signs["q2"]
        assert abs(old.length - curve.length) < 0.2  # 2 mm further
    far = start.copy()
    far[0, 3] += 0.12
    changed = cr.self_motion_along(PANDA, [start, far], tolerance=1e-3)
    assert changed.count.tolist() == [8, 4]
    assert [change.kind for change in changed.changes] == ["reconnect"] * 2 + ["vanish"] * 4
    assert len(changed.families) == 4


def test_what_a_path_refuses() -> None:
    with pytest.raises(cr.InputError, match="targets"):
        cr.self_motion_along(ARM, [[0.4, 0.0]])
    with pytest.raises(cr.InputError, match="shape"):
        cr.self_motion_along(ARM, [0.4, 0.0])
    with pytest.raises(cr.InputError, match="tolerance"):
        cr.self_motion_along(ARM, [[0.4, 0.0], [0.45, 0.0]], tolerance=0.0)
    with pytest.raises(cr.InputError, match="curve"):
        cr.self_motion_along(ARM, [[0.4, 0.0], [0.45, 0.0]]).reached(2)
