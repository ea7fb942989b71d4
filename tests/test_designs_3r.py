"""The face of 3R arms: an arm like any other, with answers that agree with each other and with kinematics."""

import copy
import json
import math
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from regional_arms import TURN, general, orthogonal, tip_and_determinant

import chainrule as cr
from chainrule import InputError
from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.domains import exact_domain

FISH = (1.0, 2.0, 1.5, 1.0)


def test_an_orthogonal_design_is_still_an_arm():
    design, plain = cr.orthogonal_3r(*FISH), cr.Arm(cr.load("orthogonal_3r_fig2a").description)
    assert isinstance(design, cr.Arm)
    q = np.random.default_rng(31).uniform(-3.0, 3.0, (20, 3))
    np.testing.assert_array_equal(design.jacobian(q), plain.jacobian(q))
    np.testing.assert_array_equal(design.manipulability(q), plain.manipulability(q))
    assert design.default_task == "position"
    np.testing.assert_allclose(design.position(q), tip_and_determinant(design, q)[0], rtol=0, atol=1e-14)


def test_a_loaded_orthogonal_arm_answers(tmp_path):
    """By name and from a file; domains and cusps are those of the paper's figures 2 (a) and (b)."""
    for name, domain, cusps in (("orthogonal_3r_fig2a", 2, 4), ("orthogonal_3r_fig2b", 3, 2)):
        arm = cr.load(name)
        assert (arm.name, arm.domain, len(arm.cusps()), arm.cuspidal) == (name, domain, cusps, True)
        assert isinstance(pickle.loads(pickle.dumps(arm)), cr.Orthogonal3R)
        assert isinstance(arm.with_limits(position=[(-1.0, 1.0)] * 3), cr.Orthogonal3R)
    file = tmp_path / "mine.toml"
    file.write_text(
        'chainrule = 1\nname = "mine"\nangles = "rad"\n[orthogonal_3r]\nd2 = 1\nd3 = 0.5\nd4 = 2.5\nr2 = 0.5\n'
    )
    assert (cr.load(file).domain, cr.load(file).cuspidal) == (5, False)


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (
            cr.posture_change_witness,
            "six revolute joints in space are accepted; of three ask chainrule.regional_3r(arm)",
        ),
        (lambda arm: cr.postures(arm, 1.0, 0.0, 0.0), "chainrule.regional_3r(arm).postures(x, y, z)"),
    ],
)
def test_other_questions_name_the_one_that_answers(ask, said):
    twisted = cr.Arm.from_dh([("R", 0, 0, 0, 0), ("R", 1.2, 1, 0.3, 0), ("R", -0.9, 1.5, 0.2, 0)], tool=(1.2, 0, 0))
    for arm in (cr.load("orthogonal_3r_fig2a"), twisted):
        with pytest.raises(InputError) as refusal:
            ask(arm)
        assert said in str(refusal.value)


@pytest.mark.parametrize(
    "lengths", [(1e-308, 1e-300, 1, 1), (1e150,) * 4, (5e-324,) * 4, (1, 1, 1e-61, 1), (1e308, 1e308, 1e308, 5e-324)]
)
def test_lengths_beyond_what_is_answered_are_refused(lengths):
    with pytest.raises(InputError, match="from 1e-100 to 1e100 m and none more than 1e60 times another") as refusal:
        cr.orthogonal_3r(*lengths)
    assert "\n" not in str(refusal.value)
    with pytest.raises(InputError, match="1e60 times another"):
        certified_cusps(["1e-390", 1, 1, 1])


def test_the_outermost_lengths_are_accepted():
    for lengths in ((1e100,) * 4, (1e-100,) * 4, (1.0, 1e-60, 1.0, 1.0), (1e40, 1e40, 1e100, 1e40)):
        assert cr.orthogonal_3r(*lengths).cuspidal is exact_domain(*lengths).cuspidal


def test_answers_are_right_as_far_as_lengths_are_accepted():
    """The exact domain counts cusps and nodes by the signs of other polynomials."""
    rng = np.random.default_rng(3)
    for _ in range(12):
        lengths = rng.uniform(1.0, 2.0, 4) * 10.0 ** rng.choice([-30.0, 29.5, *rng.uniform(-30.0, 29.5, 2)], 4)
        design, place = cr.orthogonal_3r(*lengths), exact_domain(*lengths)
        assert len(design.cusps()) == place.cusps
        assert place.nodes in (None, len(design.nodes()))
        assert design.cuspidal is place.cuspidal


@pytest.mark.parametrize("lengths", [(1e-8, 1e-7, 1.0, 1.0), (1.0, 1e20, 1.5, 1.0)])
def test_a_cuspidal_arm_is_not_called_otherwise_for_want_of_digits(lengths):
    design = cr.orthogonal_3r(*lengths)
    assert exact_domain(*lengths).cuspidal is design.cuspidal is True
    assert design.example() is None
    with pytest.raises(InputError, match="the arm is cuspidal, but double precision"):
        design.posture_change()


def test_an_example_has_two_postures():
    """With d2 = 1e-15 two postures are one to the last digit: the pair must be another, or none."""
    found = cr.orthogonal_3r(1e-15, 1.0, 1.5, 1.0).example()
    assert found is None or np.abs(np.sin(np.diff(found.postures, axis=0) / 2.0)).max() > 1e-7


def test_copies_keep_everything():
    design = cr.orthogonal_3r("0.1", 2, Fraction(3, 2), Decimal("1.1"), exact=True)
    limited = design.with_limits(velocity=[1.0, 2.0, None])
    np.testing.assert_array_equal(limited.limits.velocity, [1.0, 2.0, np.inf])
    for twin in (pickle.loads(pickle.dumps(design)), copy.copy(design), copy.deepcopy(design), limited):
        assert isinstance(twin, cr.Orthogonal3R)
        assert twin.exact
        assert twin.lengths == (Fraction(1, 10), 2, Fraction(3, 2), Fraction(11, 10))
        assert twin.domain == design.domain
        np.testing.assert_array_equal(twin.cusps(), design.cusps())
    plain = pickle.loads(pickle.dumps(cr.orthogonal_3r(*FISH)))
    assert not plain.exact
    assert plain.lengths == FISH
    assert "chainrule" in type(plain).__module__


@pytest.mark.parametrize(
    ("lengths", "domain", "topology"),
    [
        ((1.0, 1.0, 0.3, 1.0), 1, (0, 0)),
        ((1.0, 2.0, 1.5, 1.0), 2, (4, 0)),
        ((1.0, 3.0, 4.0, 3.0), 3, (2, 1)),
        ((1.0, 2.0, 4.5, 1.0), 4, (4, 4)),
        ((1.0, 0.5, 2.5, 0.5), 5, (0, 2)),
    ],
)
def test_domain_and_topology_agree_with_the_points_found(lengths, domain, topology):
    """Cusps and nodes are found from polynomials, the domain from the surfaces."""
    for scale in (1.0, 1e-3, 250.0):
        design = cr.orthogonal_3r(*(scale * length for length in lengths))
        assert design.domain == domain
        assert design.surfaces == ()
        assert design.topology == topology == (len(design.cusps()), len(design.nodes()))
        assert design.cuspidal == (domain in (2, 3, 4))
        assert cr.classify_orthogonal_3r(*lengths) == domain


def test_exact_lengths_decide_on_a_surface():
    """C2: d4 = d3 / (d3 + d2) sqrt((d3 + d2)^2 + r2^2); with d3 + d2 = 0.4 and r2 = 0.3 the root is 0.5."""
    lengths = ("0.1", "0.3", "0.375", "0.3")
    on = cr.orthogonal_3r(*lengths, exact=True)
    assert on.surfaces == ("C2",)
    assert on.domain is None
    assert on.topology is None
    assert any("exactly on C2" in line for line in on.words())
    beside = [
        cr.orthogonal_3r("0.1", "0.3", d4, "0.3", exact=True)
        for d4 in ("0.37499999999999999999", "0.3750000000000000000001")
    ]
    assert [arm.domain for arm in beside] == [2, 3]
    assert [len(arm.cusps()) for arm in beside] == [4, 2]
    rounded = cr.orthogonal_3r(*(float(x) for x in lengths))
    assert not rounded.exact
    assert rounded.surfaces == ()  # the doubles next to these numbers are not on the surface
    far = [cr.orthogonal_3r(0.1, 0.3, d4, 0.3) for d4 in (0.37, 0.38)]
    assert [len(arm.aspects()) for arm in beside] == [len(arm.aspects()) for arm in far] == [6, 5]
    assert len(on.aspects()) == 5


def test_nongeneric_arms_are_named():
    assert "r2 = 0" in cr.orthogonal_3r(1.0, 2.0, 1.5, 0.0).nongeneric[0]
    assert "axis 3" in cr.orthogonal_3r(1.0, 2.0, 0.0, 1.0).nongeneric[0]
    assert "intersect" in cr.orthogonal_3r(0.0, 2.0, 1.5, 1.0).nongeneric[0]
    puma = cr.regional_3r(cr.load("puma560"))
    assert len(puma.nongeneric) == 2
    for design in (puma, cr.orthogonal_3r(1.0, 2.0, 1.5, 0.0)):
        assert design.cuspidal is False
        assert len(design.words()) >= len(design.nongeneric)
    assert cr.orthogonal_3r(*FISH).nongeneric == ()


@pytest.mark.parametrize("family", [orthogonal, general])
def test_postures_reach_the_point_and_hold_the_one_it_came_from(family):
    rng = np.random.default_rng(32)
    for _ in range(8):
        design = family(rng)
        for q in rng.uniform(-math.pi, math.pi, (10, 3)):
            tip, _ = tip_and_determinant(design, q)
            rows = design.postures(*tip)
            np.testing.assert_allclose(
                tip_and_determinant(design, rows)[0], np.broadcast_to(tip, rows.shape), atol=1e-10
            )
            assert (np.abs(np.remainder(rows - q + math.pi, TURN) - math.pi).max(axis=1) < 1e-6).any()
            assert (np.diff(rows[:, 2]) >= 0.0).all()
            assert design.number_of_postures(*design.section(tip)) == len(rows)


def test_number_of_postures_has_any_shape():
    design = cr.orthogonal_3r(*FISH)
    assert design.number_of_postures(np.ones((2, 1, 3)), np.zeros((5, 1))).shape == (2, 5, 3)
    assert design.number_of_postures(2.0, 0.5) == 4
    assert design.number_of_postures(99.0, 0.0) == 0
    assert design.postures(99.0, 0.0, 0.0).shape == (0, 3)


def test_a_free_joint_is_said():
    design = cr.orthogonal_3r(8.0, 3.0, 5.0, 2.0)  # at rho = 10, z = 0 the tip is on axis 2
    with pytest.warns(cr.FreeJointWarning, match="joint 2"):
        rows = design.postures(10.0, 0.0, 0.0)
    np.testing.assert_allclose(
        tip_and_determinant(design, rows)[0], np.tile([10.0, 0.0, 0.0], (len(rows), 1)), atol=1e-10
    )


@pytest.mark.parametrize("family", [orthogonal, general])
def test_singular_curves_are_closed_and_singular_and_complete(family):
    """det J vanishes on them, and beside every place of a grid where it changes sign there is one."""
    rng = np.random.default_rng(33)
    angles = (np.arange(120) + 0.3) * TURN / 120 - math.pi
    for _ in range(6):
        design = family(rng)
        curves = design.singular_curves()
        grid = np.stack(np.broadcast_arrays(0.0, angles[:, None], angles[None, :]), axis=-1)
        det = tip_and_determinant(design, grid)[1]
        every = np.concatenate([curve.joint for curve in curves])
        for curve in curves:
            q = np.column_stack([np.zeros(len(curve.joint)), curve.joint])
            tip, value = tip_and_determinant(design, q)
            assert np.abs(value).max() <= 1e-9 * np.abs(det).max()
            np.testing.assert_allclose(curve.joint[-1] - curve.joint[0], TURN * np.array(curve.turns), atol=1e-9)
            np.testing.assert_allclose(curve.image, design.section(tip), atol=1e-9)
            assert np.abs(np.diff(curve.joint, axis=0)).max() < 0.1
        for axis in (0, 1):
            change = np.argwhere(np.sign(det) != np.sign(np.roll(det, -1, axis=axis)))
            for i, j in change[:: max(1, len(change) // 60)]:
                gap = np.remainder(every - [angles[i], angles[j]] + math.pi, TURN) - math.pi
                assert np.abs(gap).max(axis=1).min() < TURN / 120 + 0.06


def test_the_lines_of_the_orthogonal_arms():
    design = cr.orthogonal_3r(1.0, 3.0, 4.0, 3.0)
    lines = [curve for curve in design.singular_curves() if curve.line]
    assert sorted(line.joint[0, 1] for line in lines) == pytest.approx([-math.acos(-0.75), math.acos(-0.75)])
    for line in lines:
        assert np.ptp(line.image, axis=0).max() < 1e-12
        assert line.turns == (1, 0)
    assert not any(curve.line for curve in cr.orthogonal_3r(*FISH).singular_curves())


def test_cusps_are_where_the_images_turn_back():
    """The image of a singular curve runs through every cusp and is slowest there."""
    design = cr.orthogonal_3r(*FISH)
    images = [curve.image for curve in design.singular_curves(4000)]
    for cusp in design.cusps():
        distance, image, place = min(
            (float(np.hypot(*(image - cusp).T).min()), k, int(np.hypot(*(image - cusp).T).argmin()))
            for k, image in enumerate(images)
        )
        assert distance < 1e-3
        steps = np.diff(images[image][np.arange(place - 12, place + 13) % (len(images[image]) - 1)], axis=0)
        assert (steps[0] @ steps[-1]) < 0.0


def test_what_a_regional_part_of_six_joints_is():
    puma = cr.load("puma560")
    design = cr.regional_3r(puma)
    assert design.arm is puma
    assert design.name == "puma560"
    assert cr.regional_3r(cr.load("orthogonal_3r_fig2b")).domain == 3
    same = cr.orthogonal_3r(*FISH)
    assert cr.regional_3r(same) is same


def test_plain_values():
    for design in (cr.orthogonal_3r(*FISH), cr.orthogonal_3r("1", "2", "1.5", "1", exact=True)):
        plain = json.loads(json.dumps(design.to_dict()))
        assert plain["cuspidal"] is True
        assert len(plain["cusps"]) == 4
        assert len(plain["aspects"]) == 2
        assert json.loads(json.dumps(design.example().to_dict()))["sign"] in (1, -1)
        for curve in design.singular_curves(20):
            json.dumps(curve.to_dict())


def test_bad_input_gets_one_line():
    design = cr.orthogonal_3r(*FISH)
    wrong = (
        lambda: cr.orthogonal_3r("1", 2.0, 1.5, 1.0),
        lambda: cr.orthogonal_3r(math.nan, 2.0, 1.5, 1.0),
        lambda: cr.orthogonal_3r(math.inf, 2.0, 1.5, 1.0, exact=True),
        lambda: cr.orthogonal_3r("one", 2, 1.5, 1, exact=True),
        lambda: cr.orthogonal_3r(Fraction(1, 10**400), 2, 1.5, 1, exact=True),
        lambda: cr.orthogonal_3r(10**400, 2, 1.5, 1, exact=True),
        lambda: cr.regional_3r(cr.load("panda")),
        lambda: cr.regional_3r(cr.load("planar_3r")),
        lambda: cr.regional_3r(cr.load("ur5e")),
        lambda: cr.regional_3r("puma560"),
        lambda: design.postures(1.0, 2.0, math.nan),
        lambda: design.postures([1.0, 2.0], 0.0, 0.0),
        lambda: design.number_of_postures("a", 0.0),
        lambda: design.number_of_postures(np.ones(2), np.ones(3)),
        lambda: design.section([1.0, 2.0]),
        lambda: design.singular_curves(3),
    )
    for call in wrong:
        with pytest.raises(InputError) as refused:
            call()
        assert "\n" not in str(refused.value)
        assert len(str(refused.value)) < 300
