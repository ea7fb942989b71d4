"""Posture changes of six-joint arms: every witness is checked without the code that found and proved it."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest

import chainrule as cr
from chainrule.balls import minors_on_balls
from chainrule.cuspidality.certified_path import bezier, certify_sign, halved, sample
from chainrule.cuspidality.inverse import inverse_solutions, pose_error, same_pose
from chainrule.cuspidality.pose_proof import neighbour
from chainrule.cuspidality.witness import Witness, posture_change_witness, prove_path
from chainrule.errors import InputError

CUSPIDAL = ("crx10ial", "jaco2", "gofa5")
CASES = [(name, limits) for name in CUSPIDAL for limits in (False, True)]


@cache
def witness(name: str, limits: bool) -> Witness:
    return posture_change_witness(cr.load(name), seed=3, tries=20, limits=limits)


def determinant_by_definition(arm: cr.Arm, q: np.ndarray) -> np.ndarray:
    """det of the matrix that the Jacobian's columns make; not the generated determinant."""
    return np.linalg.det(arm.jacobian(q, task="pose"))


# ---- witnesses -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "limits"), CASES)
def test_path_joins_two_postures_of_one_pose(name: str, limits: bool) -> None:
    arm, found = cr.load(name), witness(name, limits)
    assert found.found and found.certified and "cuspidal" in found.words
    assert found.path is not None and found.start is not None and found.goal is not None
    ends = found.sample([0.0, 1.0])
    np.testing.assert_array_equal(ends, [found.start, found.goal])
    np.testing.assert_allclose(arm.pose(ends[0]), arm.pose(ends[1]), rtol=0, atol=1e-9)
    np.testing.assert_allclose(arm.pose(ends[0]), found.pose, rtol=0, atol=1e-12)
    apart = np.abs(np.remainder(ends[1] - ends[0] + np.pi, 2 * np.pi) - np.pi).max()
    assert apart > 0.01  # not the same posture some turns away


@pytest.mark.parametrize(("name", "limits"), CASES)
def test_determinant_keeps_its_sign_above_the_proved_bound(name: str, limits: bool) -> None:
    arm, found = cr.load(name), witness(name, limits)
    q = found.sample(np.linspace(0.0, 1.0, 20_001))
    det = found.sign * determinant_by_definition(arm, q)
    assert 0.0 < found.smallest_determinant <= det.min() * (1 + 1e-9)
    assert found.smallest_determinant > 0.2 * det.min()  # and the bound says something
    np.testing.assert_allclose(det, found.sign * arm.minors(q)[:, 0], rtol=0, atol=1e-13)
    assert np.abs(np.diff(q, axis=0)).max() < 0.01  # no jump between the samples


@pytest.mark.parametrize("name", CUSPIDAL)
def test_limits_are_kept_where_asked_for(name: str) -> None:
    arm = cr.load(name)
    q = witness(name, True).sample(np.linspace(0.0, 1.0, 20_001))
    assert (q >= arm.limits.position[:, 0] - 1e-12).all() and (q <= arm.limits.position[:, 1] + 1e-12).all()


def test_same_seed_same_answer_and_plain_values() -> None:
    found = witness("gofa5", False)
    again = posture_change_witness(cr.load("gofa5"), seed=3, tries=20)
    assert json.dumps(found.to_dict()) == json.dumps(again.to_dict())
    other = posture_change_witness(cr.load("gofa5"), seed=4, tries=20)
    assert other.start is not None and found.start is not None and not np.allclose(other.start, found.start)


@pytest.mark.parametrize("name", ["puma560", "ur5e"])
def test_nothing_found_is_not_called_noncuspidal(name: str) -> None:
    """Their determinants are products of three factors; four aspects of each sign hold one solution each."""
    found = posture_change_witness(cr.load(name), tries=20)
    assert not found.found and not found.certified and found.path is None and found.tries == 20
    assert found.poses > 10  # it did have pairs to join
    assert "no witness in 20 tries" in found.words and "not prove" in found.words
    assert "not cuspidal" not in found.words and "noncuspidal" not in found.words
    with pytest.raises(InputError, match="no path"):
        found.sample(0.5)
    json.dumps(found.to_dict())


def test_interrupted_search_says_what_was_done() -> None:
    def interrupt(line: str) -> None:
        if line.startswith("pose 3 "):
            raise KeyboardInterrupt

    found = posture_change_witness(cr.load("puma560"), tries=50, progress=interrupt)
    assert (found.found, found.tries) == (False, 2)
    assert found.words.startswith("stopped")


def test_an_arm_that_is_singular_everywhere() -> None:
    arm = cr.Arm.from_dh([("R", 0.0, 0.3, 0.1, 0.0)] * 6, name="all-parallel")
    found = posture_change_witness(arm, tries=3)
    assert not found.found and "vanishes" in found.words


@pytest.mark.parametrize("arm", [cr.load("panda"), cr.planar_3r(1.0, 0.5, 0.25), cr.planar("RRRRRR", [0.3] * 6), None])
def test_other_arms_are_refused(arm: cr.Arm) -> None:
    with pytest.raises(InputError, match="six revolute joints") as refusal:
        posture_change_witness(arm)
    assert "\n" not in str(refusal.value)


def test_prismatic_joints_and_bad_numbers_are_refused() -> None:
    rows = [("P" if k == 2 else "R", np.pi / 2, 0.1, 0.2, 0.0) for k in range(6)]
    with pytest.raises(InputError, match="RRPRRR"):
        posture_change_witness(cr.Arm.from_dh(rows, name="slider"))
    for numbers in ({"tries": 0}, {"seed": -1}, {"starts": 1.5}):
        with pytest.raises(InputError, match=next(iter(numbers))):
            posture_change_witness(cr.load("gofa5"), **numbers)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="from 0 to 1"):
        witness("gofa5", False).sample(1.5)


# ---- the proof refuses what is false -------------------------------------------------------------------------------


def test_path_across_a_singularity_is_refused() -> None:
    arm = cr.load("crx10ial")
    minors = minors_on_balls(arm, "pose")
    assert minors is not None
    solutions = inverse_solutions(arm, arm.pose([0.3, 0.4, 0.5, 0.6, 0.7, 0.8]))
    det = arm.minors(solutions)[:, 0]
    one, other = solutions[np.argmax(det)], solutions[np.argmin(det)]
    assert not prove_path(arm, minors, np.stack([one, other]), 1).certified  # opposite signs
    # there and back across det J = 0, both ends of one sign
    there = np.stack([one, other, solutions[np.argsort(det)[-2]]])
    assert det.max() > 0.0 > det.min() and np.sort(det)[-2] > 0.0
    assert not prove_path(arm, minors, there, 1).certified
    # a dip below zero between samples: the sign at 100 equidistant samples tells nothing
    dip = certify_sign(lambda q: (q[:, 0] - 0.50371) * (q[:, 0] - 0.50372), bezier([[0.0], [1.0]], 1))
    at = np.linspace(0.0, 1.0, 100)
    assert ((at - 0.50371) * (at - 0.50372) > 0.0).all() and not dip.certified


def test_path_to_another_pose_is_refused() -> None:
    arm, found = cr.load("gofa5"), witness("gofa5", False)
    minors = minors_on_balls(arm, "pose")
    assert minors is not None and found.path is not None
    moved = found.path.copy()
    moved[-1, 0] += 1e-6  # joint 1 has no part in det J: only the pose is wrong
    assert prove_path(arm, minors, found.path, found.degree).certified
    assert not prove_path(arm, minors, moved, found.degree).certified
    closed = np.stack([found.path[0], found.path[0] + [2 * np.pi, 0, 0, 0, 0, 0]])
    assert not prove_path(arm, minors, closed, 1).certified  # the same posture, one turn on


@pytest.mark.parametrize("name", [*CUSPIDAL, "puma560", "ur5e"])
def test_proved_neighbour_is_a_solution_at_high_precision(name: str) -> None:
    arm = cr.load(name)
    start = np.array([0.3, -0.4, 0.9, 0.6, 0.7, 0.8])
    for q in inverse_solutions(arm, arm.pose(start)):
        box = neighbour(arm, start, q)
        assert box is not None
        assert max(abs(float(ball.mid()) - value) for ball, value in zip(box, q, strict=True)) < 1e-11
        assert neighbour(arm, start, q + 1e-5) is None


# ---- inverse solutions ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["puma560", "crx10ial", "jaco2", "gofa5", "ur5e"])
def test_inverse_solutions_are_all_found_again_from_other_starts(name: str) -> None:
    arm, rng = cr.load(name), np.random.default_rng(5)
    for q in rng.uniform(-np.pi, np.pi, (3, 6)):
        target = arm.pose(q)
        few, many = inverse_solutions(arm, target), inverse_solutions(arm, target, starts=2000, seed=1)
        assert len(few) == len(many)  # even numbers, at most 16
        assert len(few) % 2 == 0 and len(few) <= 16
        np.testing.assert_allclose(few, many, rtol=0, atol=1e-7)
        np.testing.assert_allclose(arm.pose(few), np.broadcast_to(target, (len(few), 4, 4)), rtol=0, atol=1e-9)
        assert np.abs(np.remainder(few - q + np.pi, 2 * np.pi) - np.pi).max(axis=-1).min() < 1e-7  # the given one


def test_puma_has_its_eight_postures() -> None:
    puma = cr.load("puma560")
    assert len(inverse_solutions(puma, puma.pose([0.3, 0.4, 0.5, 0.6, 0.7, 0.8]))) == 8


def test_unreachable_pose_has_none_and_no_pose_is_refused() -> None:
    arm = cr.load("ur5e")
    far = np.eye(4)
    far[0, 3] = 5.0
    assert inverse_solutions(arm, far).shape == (0, 6)
    with pytest.raises(InputError, match="4, 4"):
        inverse_solutions(arm, np.ones((4, 4)))


def test_same_pose_and_how_far_apart() -> None:
    arm, q = cr.load("gofa5"), np.array([0.3, 0.4, 0.5, 0.6, 0.7, 0.8])
    np.testing.assert_array_equal(same_pose(arm, q, np.stack([q, q + 2 * np.pi, q + 1e-3])), [True, True, False])
    distance, angle = pose_error(arm, q, q + 0.25 * np.eye(6)[5])
    np.testing.assert_allclose(angle, 0.25, rtol=1e-12)
    assert distance < 1e-15  # the last joint turns the tip on its axis


# ---- splines and their pieces --------------------------------------------------------------------------------------


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_pieces_are_the_spline(degree: int) -> None:
    control = np.random.default_rng(degree).normal(size=(9, 2))
    pieces = bezier(control, degree)
    middles = halved(pieces)[len(pieces) :, 0]
    ends = np.linspace(0.0, 1.0, len(pieces) + 1)
    for coefficients, at in (
        (pieces[:, 0], ends[:-1]),
        (pieces[:, -1], ends[1:]),
        (middles, (ends[1:] + ends[:-1]) / 2),
    ):
        found = np.array([[float(ball.mid()) for ball in row] for row in coefficients])
        np.testing.assert_allclose(found, sample(control, degree, at), rtol=0, atol=1e-14)


def test_lower_bound_is_one_and_can_be_asked_for() -> None:
    """q^2 + 1 / 100 from -1 to 2: the least value is 1 / 100, in the inside of the path."""
    from flint import arb

    def function(q: np.ndarray) -> np.ndarray:
        return np.array([row[0] * row[0] + arb("0.01") for row in q], object)

    pieces = bezier([[-1.0], [2.0]], 1)
    crude, fine = certify_sign(function, pieces), certify_sign(function, pieces, at_least=0.0099)
    assert crude.certified and 0.0 < crude.lower_bound <= 0.01
    assert fine.certified and 0.0099 < fine.lower_bound <= 0.01 and fine.pieces > crude.pieces
    negative = certify_sign(lambda q: -function(q), pieces)
    assert negative.certified and negative.sign == -1 and 0.0 < negative.lower_bound <= 0.01
    assert not certify_sign(lambda q: q[:, 0], bezier([[0.0], [1.0]], 1)).certified  # begins at zero
    with pytest.raises(InputError, match="at least 4"):
        bezier(np.zeros((3, 6)), 3)
