"""Spherical wrists of six-joint arms, seen in the axes themselves."""

from __future__ import annotations

import numpy as np
import pytest

import chainrule as cr
from chainrule.cuspidality.wrists import wrist
from chainrule.errors import InputError

HALF = np.pi / 2
#: alpha, a, d of a modified table whose last three axes are skew to each other at 50 and 70 degrees and meet.
SKEW_WRIST = [
    ("R", 0.0, 0.0, 0.4, 0.0),
    ("R", -HALF, 0.1, 0.05, 0.0),
    ("R", 0.3, 0.5, -0.02, 0.0),
    ("R", -HALF, 0.07, 0.45, 0.0),
    ("R", np.radians(50), 0.0, 0.0, 0.3),
    ("R", np.radians(70), 0.0, 0.2, 0.0),
]


def skew_wrist(**changes: float) -> cr.Arm:
    rows = [list(row) for row in SKEW_WRIST]
    for place, value in changes.items():
        row, column = {"a5": (4, 2), "d5": (4, 3), "a6": (5, 2), "alpha5": (4, 1)}[place]
        rows[row][column] = value
    return cr.Arm.from_dh(rows, name="skew-wrist")


def random_q(count: int = 200) -> np.ndarray:
    return np.random.default_rng(0).uniform(-np.pi, np.pi, (count, 6))


def test_which_embedded_arms_have_one() -> None:
    found = {name: wrist(cr.load(name)) for name in ("puma560", "crx10ial", "jaco2", "gofa5", "ur5e")}
    assert [name for name, answer in found.items() if answer.spherical] == ["puma560"]
    assert not any(answer.inverse for answer in found.values())
    for name, answer in found.items():
        assert "\n" not in answer.words
        assert (answer.regional is None) == (name != "puma560") == (answer.in_tip is None)
    assert "0.15 m apart on axis 5" in found["crx10ial"].words
    assert "pass each other at 0.08 m" in found["gofa5"].words


@pytest.mark.parametrize("arm", [cr.load("puma560"), skew_wrist()], ids=lambda arm: arm.name)
def test_centre_is_where_the_last_three_joints_move_nothing(arm: cr.Arm) -> None:
    """The regional arm places the centre, and joints 4, 5 and 6 leave it where it is: v + w x (c - p) = 0."""
    answer, q = wrist(arm), random_q()
    assert answer.regional is not None
    pose = arm.pose(q)
    centre = answer.centre(pose)
    np.testing.assert_allclose(cr.Arm(answer.regional).position(q[:, :3]), centre, rtol=0, atol=1e-14)
    np.testing.assert_allclose(answer.pose(centre, pose[:, :3, :3]), pose, rtol=0, atol=1e-14)
    jacobian = arm.jacobian(q, task="pose")
    arm_of_rotation = (centre - pose[:, :3, 3])[:, :, None]
    velocity = jacobian[:, :3] + np.cross(jacobian[:, 3:], arm_of_rotation, axis=1)
    np.testing.assert_allclose(velocity[:, :, 3:], 0.0, rtol=0, atol=1e-14)


@pytest.mark.parametrize("arm", [cr.load("puma560"), skew_wrist()], ids=lambda arm: arm.name)
def test_determinant_is_that_of_the_regional_arm_times_a_factor_of_the_wrist(arm: cr.Arm) -> None:
    answer, q = wrist(arm), random_q()
    assert answer.regional is not None
    regional = cr.Arm(answer.regional).minors(q[:, :3], task="position")[:, 0]
    jacobian = arm.jacobian(q, task="pose")[:, 3:, 3:]  # the axes of joints 4, 5 and 6
    product = regional * np.linalg.det(jacobian)
    np.testing.assert_allclose(arm.minors(q)[:, 0], product, rtol=0, atol=1e-13)


def test_axes_that_nearly_meet() -> None:
    assert wrist(skew_wrist(a6=1e-12)).spherical  # rounding
    assert wrist(skew_wrist(a6=1e-6)).words == "axes 5 and 6 pass each other at 1e-06 m"
    assert wrist(skew_wrist(a5=-1e-6)).words == "axes 4 and 5 pass each other at 1e-06 m"
    assert "apart on axis 5" in wrist(skew_wrist(d5=1e-6)).words
    assert wrist(skew_wrist(alpha5=0.0)).words == "axes 4 and 5 are parallel"


def test_inverse_spherical_wrist_is_named() -> None:
    rows = [("R", 0.0, 0.0, 0.3, 0.0), ("R", -HALF, 0.0, 0.0, 0.0), ("R", HALF, 0.0, 0.4, 0.0)]
    rows += [("R", HALF, 0.1, 0.1, 0.0), ("R", 0.2, 0.3, 0.1, 0.0), ("R", HALF, 0.1, 0.2, 0.0)]
    answer = wrist(cr.Arm.from_dh(rows, name="turned-round"))
    assert answer.inverse and not answer.spherical
    assert "inverse spherical wrist" in answer.words


@pytest.mark.parametrize("arm", [cr.load("panda"), cr.planar_3r(1.0, 0.5, 0.25), "puma560"])
def test_other_arms_are_refused(arm: object) -> None:
    with pytest.raises(InputError, match="six revolute joints") as refusal:
        wrist(arm)  # type: ignore[arg-type]
    assert "\n" not in str(refusal.value)


def test_questions_that_need_a_wrist() -> None:
    arm = cr.load("ur5e")
    with pytest.raises(InputError, match="no spherical wrist"):
        wrist(arm).centre(arm.pose(np.zeros(6)))
    with pytest.raises(InputError, match="is accepted"):
        wrist(cr.load("puma560")).centre(np.zeros((3, 3)))
