"""Ways between postures: they keep the sign of det J, begin and end where they should, and exist when they can."""

import json
import math

import mpmath
import numpy as np
import pytest
import reference
from regional_arms import TURN, general, orthogonal, same_angles, tip_and_determinant

import chainrule as cr
from chainrule import InputError

#: One design of each domain, from the figures of Baili, Wenger and Chablat (2 and 3: figures 2a and 2b) and inside the
#: others' ranges, with the number of cusps the paper gives for the domain.
DOMAINS = {
    1: ((1.0, 1.0, 0.3, 1.0), 0),
    2: ((1.0, 2.0, 1.5, 1.0), 4),
    3: ((1.0, 3.0, 4.0, 3.0), 2),
    4: ((1.0, 2.0, 4.5, 1.0), 4),
    5: ((1.0, 0.5, 2.5, 0.5), 0),
}


def check(design, change):
    """A path as it should be: looked at densely, with kinematics that know nothing of the package."""
    assert change.reason == ""
    assert change.certified
    assert change.pieces >= 1
    q = change.sample(np.linspace(0.0, 1.0, 4001))
    np.testing.assert_array_equal(q[0], change.start)
    np.testing.assert_array_equal(change.path[0], change.start)
    assert same_angles(q[-1], change.goal, 1e-14 * (1.0 + np.abs(q[-1]).max()))
    det = change.sign * tip_and_determinant(design, q)[1]
    assert det.min() >= change.smallest_determinant * (1.0 - 1e-9) > 0.0
    assert np.abs(np.diff(q, axis=0)).max() < 0.05
    return det


def pair(design, rng, alike=True):
    """Two random configurations in one aspect, or in different ones."""
    while True:
        q = rng.uniform(-math.pi, math.pi, (2, 3))
        labels = design.aspect_of(q)
        if (labels >= 0).all() and (labels[0] == labels[1]) == alike:
            return q


@pytest.mark.parametrize("family", [orthogonal, general])
def test_configurations_of_different_points_are_joined_and_told_apart(family):
    """same_point against the tip from the definitions alone."""
    rng = np.random.default_rng(12)
    for _ in range(4):
        design = family(rng)
        change = design.posture_change(*pair(design, rng))
        assert change.exists
        assert not change.same_point
        q = rng.uniform(-math.pi, math.pi, 3)
        point, _ = tip_and_determinant(design, q)
        every = design.postures(*point)
        assert all(design.posture_change(every[0], other).same_point for other in every[1:])
        turned = q + np.array([0.1, 0.0, 0.0])  # as far from axis 1 and as high, elsewhere
        change = design.posture_change(q, turned)
        assert (change.exists, change.same_point) == (True, False)
        assert change.to_dict()["same_point"] is False


@pytest.mark.parametrize("family", [orthogonal, general])
def test_paths_keep_the_sign_and_end_at_the_postures(family):
    rng = np.random.default_rng(11)
    shares = []
    for _ in range(12):
        design = family(rng)
        change = design.posture_change(*pair(design, rng))
        det = check(design, change)
        shares.append(det.min() / min(det[0], det[-1]))
    assert np.median(shares) > 0.7  # most need not come nearer to a singularity than their ends are


def test_the_sign_in_forty_digits():
    rng = np.random.default_rng(12)
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    change = design.posture_change(*pair(design, rng))
    for s in np.linspace(0.0, 1.0, 60):
        jacobian = reference.jacobian(design.description, change.sample(s).tolist(), 40)
        assert change.sign * mpmath.det(jacobian[:3, :]) >= change.smallest_determinant


def test_paths_are_twice_continuously_differentiable():
    rng = np.random.default_rng(13)
    design = general(rng)
    change = design.posture_change(*pair(design, rng))
    inner = np.unique(change.knots)[1:-1]
    for derivative in (0, 1, 2):
        before, after = (change.sample(inner + side * 1e-9, derivative) for side in (-1.0, 1.0))
        size = np.abs(change.sample(np.linspace(0, 1, 500), min(derivative + 1, 2))).max()
        assert np.abs(after - before).max() <= 1e-5 * size
    s = np.linspace(0.01, 0.99, 50)
    slope = (change.sample(s + 1e-6) - change.sample(s - 1e-6)) / 2e-6
    np.testing.assert_allclose(change.sample(s, 1), slope, rtol=0, atol=1e-4)


@pytest.mark.parametrize("domain", DOMAINS)
def test_postures_of_one_point_can_be_changed_in_domains_2_3_and_4_only(domain):
    lengths, cusps = DOMAINS[domain]
    design = cr.orthogonal_3r(*lengths)
    assert design.domain == domain
    assert len(design.cusps()) == cusps
    assert design.cuspidal == (cusps > 0)
    rng = np.random.default_rng(14)
    found = 0
    for q in rng.uniform(-math.pi, math.pi, (150, 3)):
        tip, _ = tip_and_determinant(design, q)
        rows = design.postures(*tip)
        labels = design.aspect_of(rows)
        alike = [(i, j) for i in range(len(rows)) for j in range(i) if labels[i] == labels[j] >= 0]
        found += len(alike)
        if alike and found < 4:
            i, j = alike[0]
            change = design.posture_change(rows[i], rows[j])
            check(design, change)
            tips = tip_and_determinant(design, change.sample([0.0, 1.0]))[0]
            np.testing.assert_allclose(tips, np.stack([tip, tip]), rtol=0, atol=1e-9)
    assert (found > 0) == (cusps > 0)


@pytest.mark.parametrize("domain", [2, 3, 4])
def test_the_example_runs_round_a_cusp(domain):
    """Its image is closed, and a change of posture without a singularity encircles a cusp."""
    design = cr.orthogonal_3r(*DOMAINS[domain][0])
    change = design.posture_change()
    check(design, change)
    image = change.image()
    np.testing.assert_allclose(image[0], image[-1], rtol=0, atol=1e-9)
    assert (image[0] == pytest.approx(design.example().section, abs=1e-9)) is True
    assert np.abs(change.encircled(design.cusps())).sum() >= 1
    assert not change.encircled([[1e3, 0.0]]).any()


def test_random_designs_have_an_example_exactly_in_domains_2_3_and_4():
    """The domain comes from the separating surfaces, the example from postures and aspects of many points."""
    rng = np.random.default_rng(18)
    seen = {domain: 0 for domain in DOMAINS}
    while min(seen.values()) < 2:
        design = cr.orthogonal_3r(1.0, *rng.uniform([0.1, 0.1, 0.1], [3.0, 5.0, 2.0]))
        if seen[design.domain] == 4:
            continue
        seen[design.domain] += 1
        found = design.example()
        assert (found is not None) == (design.domain in (2, 3, 4))
        if found is not None:
            check(design, design.posture_change(*found.postures))
            tips, _ = tip_and_determinant(design, found.postures)
            np.testing.assert_allclose(tips[0], tips[1], rtol=0, atol=1e-9)


def test_there_is_no_example_for_an_arm_that_is_not_cuspidal():
    design = cr.orthogonal_3r(*DOMAINS[1][0])
    assert design.example() is None
    with pytest.raises(InputError, match="not cuspidal"):
        design.posture_change()


def test_reasons_why_there_is_no_path():
    rng = np.random.default_rng(15)
    design = cr.orthogonal_3r(1.0, 3.0, 4.0, 3.0)
    seen = set()
    for _ in range(40):
        a, b = pair(design, rng, alike=False)
        change = design.posture_change(a, b)
        assert not change.exists
        assert change.path is None
        assert not change.certified
        det = tip_and_determinant(design, np.stack([a, b]))[1]
        word = "positive at the start and negative" if det[0] > 0 > det[1] else "different aspects"
        word = "negative at the start and positive" if det[0] < 0 < det[1] else word
        assert word in change.reason
        seen.add(word)
        with pytest.raises(InputError, match="there is no path"):
            change.sample(0.5)
    assert len(seen) == 3
    line = math.acos(-3.0 / 4.0)
    assert "the goal is itself singular" in design.posture_change([0.0, 1.0, 0.1], [0.0, 1.0, line]).reason
    assert "41.41" not in change.reason  # the lines are at +-138.59 deg
    across = [design.posture_change(*pair(design, rng, alike=False)).reason for _ in range(60)]
    assert any("138.59 deg, where the tip is on the axis of joint 2" in reason for reason in across)


def test_through_a_narrow_place():
    """Beside the surface C2 an aspect is nearly cut: the path through the throat is found and proved all the same."""
    for nearness in (1e-3, 1e-6):
        design = cr.orthogonal_3r(1.0, 3.0, 3.75 - nearness, 3.0)
        q, widest = None, 0.0
        for aspect in design.aspects():
            lower, upper = aspect.theta3
            theta3 = np.array([lower + 0.02 * (upper - lower), upper - 0.02 * (upper - lower)])
            theta2 = np.linspace(-math.pi, math.pi, 721)
            grid = np.stack(np.broadcast_arrays(0.0, theta2, theta3[:, None]), axis=-1)
            best = (aspect.sign * tip_and_determinant(design, grid)[1]).argmax(axis=1)
            if upper - lower > widest:
                widest, q = upper - lower, grid[[0, 1], best]
        check(design, design.posture_change(*q))


def test_the_same_posture_and_whole_turns():
    rng = np.random.default_rng(16)
    design = orthogonal(rng)
    a = rng.uniform(-1.0, 1.0, 3)
    while design.aspect_of(a) < 0:
        a = rng.uniform(-1.0, 1.0, 3)
    check(design, design.posture_change(a, a))
    check(design, design.posture_change(a, a + TURN))


def test_the_size_of_the_arm_plays_no_part():
    rng = np.random.default_rng(17)
    lengths = (1.0, 2.0, 1.5, 1.0)
    design = cr.orthogonal_3r(*lengths)
    q = pair(design, rng)
    path = design.posture_change(*q).path
    for scale in (2.0**-20, 2.0**20):
        scaled = cr.orthogonal_3r(*(scale * length for length in lengths))
        change = scaled.posture_change(*q)
        check(scaled, change)
        np.testing.assert_allclose(change.path, path, rtol=0, atol=1e-6)


def test_plain_values_and_bad_input():
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    change = design.posture_change()
    plain = json.loads(json.dumps(change.to_dict()))
    assert plain["exists"] is True
    assert np.shape(plain["path"]) == change.path.shape
    for wrong in ([1.0, 2.0], [[1.0, 2.0, 3.0]], "abc", [0.0, math.nan, 0.0]):
        with pytest.raises(InputError):
            design.posture_change(wrong, [0.0, 0.0, 0.0])
    with pytest.raises(InputError, match="both"):
        design.posture_change([0.0, 1.0, 0.0])
    for s in (-0.1, 1.1, math.nan):
        with pytest.raises(InputError):
            change.sample(s)
    with pytest.raises(InputError, match="derivative"):
        change.sample(0.5, 3)
