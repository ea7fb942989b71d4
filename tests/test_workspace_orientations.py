"""Orientations at a point: inverse kinematics on a grid, sampling, and two methods against each other."""

import cmath
import itertools
import math

import numpy as np
import pytest

import chainrule as cr
from chainrule.boundary_pieces import Arc
from chainrule.orientations import FULL, Everywhere, _limited, circle_in, orientations, union, widened
from chainrule.planar_chains import chain, merged, reached
from chainrule.regions import Region
from chainrule.workspaces import workspace

PI = math.pi


def tip(arm, q):
    """Tip and heading by the definition of a planar chain."""
    geometry = arm.description.geometry
    heading, z = np.zeros(q.shape[:-1]), np.zeros(q.shape[:-1], dtype=complex)
    for i, kind in enumerate(arm.kinds):
        heading = heading + (q[..., i] if kind == "R" else geometry.headings[i])
        z = z + (geometry.lengths[i] + (q[..., i] if kind == "P" else 0.0)) * np.exp(1j * heading)
    return z, heading


def within(angle, low, high, slack=0.0):
    return np.mod(angle - low + slack, 2 * PI) <= high - low + 2 * slack


def random_arm(rng, kinds, first_free=False, tidy=False):
    n = len(kinds)
    lengths = rng.choice([0.0, 0.5, 1.0, 1.0, 2.0], n) if tidy else rng.uniform(0.1, 1.0, n)
    headings = [rng.uniform(-3, 3) if kind == "P" else 0.0 for kind in kinds]
    limits = []
    for kind in kinds:
        middle, half = rng.uniform(-3, 3), rng.uniform(0.3, 3.1)
        if tidy:
            middle, half = rng.choice([0.0, PI / 2]), rng.choice([PI / 4, PI / 2, 0.75 * PI])
        limits.append((middle - half, middle + half) if kind == "R" else (middle / 3, middle / 3 + half / 2))
    limits = [None, *limits[1:]] if first_free else limits
    return cr.planar(kinds, lengths, headings).with_limits(position=limits)


def reached_rrr(arm, z, alpha):
    """Whether a 3R arm reaches poses: its inverse kinematics, and the limits."""
    l1, l2, l3 = arm.description.geometry.lengths
    limits = arm.limits.position
    wrist = z - l3 * np.exp(1j * alpha)
    cosine = (np.abs(wrist) ** 2 - l1**2 - l2**2) / (2 * l1 * l2)
    found = np.zeros(alpha.shape, dtype=bool)
    for sign in (-1, 1):
        q2 = sign * np.arccos(np.clip(cosine, -1, 1))
        q1 = np.angle(wrist / (l1 + l2 * np.exp(1j * q2)))
        q = (q1, q2, alpha - q1 - q2)
        found |= (np.abs(cosine) <= 1) & np.all([within(v, *pair) for v, pair in zip(q, limits, strict=True)], axis=0)
    return found


def reached_prr(arm, z, alpha):
    """The same for a slide with two revolute joints behind it."""
    l1, l2, l3 = arm.description.geometry.lengths
    heading, limits = arm.description.geometry.headings[0], arm.limits.position
    wrist = (z - l3 * np.exp(1j * alpha)) * np.exp(-1j * heading)
    found = np.zeros(alpha.shape, dtype=bool)
    for flip in (False, True):
        q2 = np.arcsin(np.clip(wrist.imag / l2, -1, 1))
        q2 = PI - q2 if flip else q2
        slide = wrist.real - l1 - l2 * np.cos(q2)
        good = (np.abs(wrist.imag) <= l2) & (slide >= limits[0, 0]) & (slide <= limits[0, 1])
        found |= good & within(q2, *limits[1]) & within(alpha - heading - q2, *limits[2])
    return found


def reached_rpr(arm, z, alpha):
    """The same for a slide between two revolute joints."""
    l1, l2, l3 = arm.description.geometry.lengths
    heading, limits = arm.description.geometry.headings[1], arm.limits.position
    wrist = z - l3 * np.exp(1j * alpha)
    base = l1 + l2 * cmath.exp(1j * heading)
    found = np.zeros(alpha.shape, dtype=bool)
    along = (base * cmath.exp(-1j * heading)).real
    root = along**2 - abs(base) ** 2 + np.abs(wrist) ** 2
    for sign in (-1, 1):
        slide = -along + sign * np.sqrt(np.maximum(root, 0))
        q1 = np.angle(wrist / (base + slide * cmath.exp(1j * heading)))
        good = (root >= 0) & (slide >= limits[1, 0]) & (slide <= limits[1, 1])
        found |= good & within(q1, *limits[0]) & within(alpha - heading - q1, *limits[2])
    return found


# ---- against brute force ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("kinds", "reached"), [("RRR", reached_rrr), ("PRR", reached_prr), ("RPR", reached_rpr)])
def test_against_inverse_kinematics_on_a_grid(kinds, reached):
    rng = np.random.default_rng(1)
    alpha = np.linspace(-PI, PI, 2001)[1:]
    met = 0
    for _ in range(60):
        arm = random_arm(rng, kinds)
        low, high = arm.limits.position.T
        z = tip(arm, rng.uniform(low, high))[0] + rng.normal(scale=0.1) * np.exp(2j)
        found = workspace_orientations(arm, complex(z))
        inside = np.any([within(alpha, *pair) for pair in found], axis=0) if found else np.zeros(len(alpha), dtype=bool)
        ends = np.array([end for pair in found for end in pair])
        gap = np.abs(np.exp(1j * alpha)[:, None] - np.exp(1j * ends)).min(axis=1) if len(ends) else np.ones(len(alpha))
        truth = reached(arm, z, alpha)
        assert (truth == inside)[gap > 1e-7].all(), arm.description
        met += truth.any()
    assert met > 30


def workspace_region(arm):
    return reached(chain(arm.description))


def workspace_orientations(arm, z):
    return orientations(chain(arm.description), z)


@pytest.mark.parametrize("tidy", [False, True])
def test_samples_have_an_orientation_of_the_set(tidy):
    rng = np.random.default_rng(2)
    for _ in range(120):
        arm = random_arm(rng, "".join(rng.choice(list("RRRP"), rng.integers(1, 6))), tidy=tidy)
        low, high = arm.limits.position.T
        for q in rng.uniform(low, high, (2, arm.n)):
            z, heading = tip(arm, q)
            found = workspace_orientations(arm, complex(z))
            assert any(within(heading, *pair, 1e-6) for pair in found), (arm.description, q)


@pytest.mark.parametrize("tidy", [False, True])
def test_both_methods_agree_where_the_first_joint_turns_freely(tidy):
    """Circles in the region seen from the tip, and postures in closed form: nothing in common but the chain."""
    rng = np.random.default_rng(3)
    for _ in range(35):
        kinds = "R" + "".join(rng.choice(list("RRP"), rng.integers(1, 5)))
        whole = chain(random_arm(rng, kinds, first_free=True, tidy=tidy).description)
        for radius in rng.uniform(0, whole.size, 2):
            z = cmath.rect(radius, rng.uniform(-3, 3))
            one, other = orientations(whole, z), _limited(merged(whole), z)
            assert len(one) == len(other)
            np.testing.assert_allclose(one, other, atol=1e-7)


def test_six_limited_joints():
    rng = np.random.default_rng(4)
    arm = random_arm(rng, "RRRRRR")
    low, high = arm.limits.position.T
    for q in rng.uniform(low, high, (20, 6)):
        z, heading = tip(arm, q)
        assert any(within(heading, *pair, 1e-6) for pair in workspace_orientations(arm, complex(z)))


# ---- known answers ---------------------------------------------------------------------------------------------------


def test_known_answers():
    found = workspace(cr.planar_3r(1.0, 0.5, 0.25))
    assert found.orientations(0.0, 1.0) == FULL
    assert found.orientations(0.0, 1.75) == (pytest.approx((PI / 2, PI / 2)),)  # stretched
    assert found.orientations(0.25, 0.0) == (pytest.approx((PI, PI)),)  # folded back
    assert found.orientations(0.1, 0.0) == ()
    # at 1.5 m: the wrist must stay within 1.5 m: |1.5 - 0.25 e^(i a)| <= 1.5
    edge = math.acos(0.25 / 3.0)
    assert found.orientations(1.5, 0.0) == (pytest.approx((-edge, edge)),)


def test_a_limited_wrist_turns_by_its_limits():
    arm = cr.planar("RRR", (1.0, 1.0, 0.0)).with_limits(position=[(0.0, 2.0), (0.0, 2.0), (-0.1, 0.2)])
    z = cmath.exp(0.3j) + cmath.exp(1.0j)
    assert workspace(arm).orientations(z.real, z.imag) == (pytest.approx((0.9, 1.2)),)


def test_two_elbows_give_two_orientations():
    arm = cr.planar("RR", (1.0, 1.0)).with_limits(position=[(-3.0, 3.0), (-3.0, 3.0)])
    found = workspace(arm).orientations(math.sqrt(2), 0.0)
    assert found == (pytest.approx((-PI / 4, -PI / 4)), pytest.approx((PI / 4, PI / 4)))
    one = arm.with_limits(position=[(-3.0, 3.0), (0.0, 3.0)])
    assert workspace(one).orientations(math.sqrt(2), 0.0) == (pytest.approx((PI / 4, PI / 4)),)


def limited(kinds, lengths, limits, headings=None):
    return workspace(cr.planar(kinds, lengths, headings).with_limits(position=limits))


def test_a_limited_wrist_on_a_circle():
    """The base seen from the tip is on an arc about the tip: the arc's range is the answer, not all or nothing."""
    right = limited("RR", (0.5, 0.0), [None, (-PI / 2, PI / 2)])
    assert right.orientations(0.5, 0.0) == (pytest.approx((-PI / 2, PI / 2)),)
    assert right.orientations(0.0, 0.5) == (pytest.approx((0.0, PI)),)
    left = limited("RR", (0.5, 0.0), [None, (PI / 2, 1.5 * PI)])
    assert left.orientations(0.5, 0.0) == (pytest.approx((PI / 2, 1.5 * PI)),)
    assert right.secondary == left.secondary == ()
    assert not left.contains(0.5, 0.0, every_orientation=True)


def test_on_the_first_axis_the_first_joint_turns_the_tip_on_the_spot():
    folded = limited("RR", (1.0, 1.0), [(-0.8, 0.5), (-3.5, 0.0)])  # q2 = -pi brings the tip back to the base
    for z in (0.0, 1e-16):
        assert folded.orientations(z, 0.0) == (pytest.approx((PI - 0.8, PI + 0.5)),)
    assert limited("RR", (1.0, 1.0), [(-0.8, 0.5), (-3.0, 0.0)]).orientations(0.0, 0.0) == ()
    through = limited("RP", (0.3, 0.2), [(-0.8, 0.5), (-1.0, 0.5)], (0.0, 0.0))  # the stroke passes the base
    assert through.orientations(0.0, 0.0) == (pytest.approx((-0.8, 0.5)),)
    # with a wrist of a whole turn on top, exactly at the base and beside it
    arm = limited("RRR", (1.0, 1.0, 0.0), [(-0.8, 0.5), (-3.5, 0.0), (-3.0, 2.5)])
    assert arm.contains(0.0, 0.0, every_orientation=True)
    assert arm.orientations(0.0, 0.0) == FULL
    assert not arm.contains(1.0, 0.0, every_orientation=True)


@pytest.mark.parametrize("seed", range(12))
def test_on_a_later_axis(seed):
    """Joints behind a limited first one bring the tip back to the second one's axis, where that can turn it."""
    rng = np.random.default_rng(seed)
    low = np.append(rng.uniform(-3, 1, 4), -PI)  # q5 at its lower limit folds the last link back
    limits = np.stack([low, low + rng.uniform(0.3, 3.5, 5)], axis=1)
    arm = cr.planar("RRRRR", (1.0, 1.0, 1.0, 0.5, 0.5)).with_limits(position=limits)
    z = cmath.exp(1j * limits[0, seed % 2])
    found = workspace_orientations(arm, z)
    q = np.stack([np.full(4000, limits[0, seed % 2]), *rng.uniform(*limits[1:].T, (4000, 4)).T], axis=1)
    q[:, 2], q[:, 4] = PI, -PI
    if within(PI, *limits[2]):
        assert all(any(within(heading, *pair, 1e-6) for pair in found) for heading in tip(arm, q)[1][:200])
    beside = workspace_orientations(arm, z * cmath.exp(1e-7j * (1 - 2 * (seed % 2))))  # inwards: nothing special there
    assert len(beside) == len(found)
    np.testing.assert_allclose(beside, found, atol=2e-3)


def test_near_the_first_axis_angles_stay_accurate():
    found = limited("RR", (1.0, 1.0), [(-3.0, 3.0), (-PI, PI - 0.01)])
    for distance in (1e-3, 1e-5, 1e-7, 2e-8):
        # isosceles: the second link points to the tip from (cos a, -sin a), a = acos(distance / 2)
        apex = math.acos(distance / 2.0)
        assert found.orientations(distance, 0.0) == (pytest.approx((-apex, -apex), abs=1e-11),)


def test_every_point_of_the_boundary_has_the_orientation_of_its_posture():
    """Where two limits and a stretched arm meet, rounding errors count by their square root."""
    rng = np.random.default_rng(8)
    known = [("RR", (0.94, 0.43), [(-3.0, -1.2), (0.0, PI)]), ("RR", (0.55, -0.1), [(1.4, 4.4), (-PI, 0.0)])]
    known += [("PR", (0.84, 0.77), [(0.9, 1.2), (-PI / 2, PI / 2)]), ("RR", (1.0, 0.5), [None, (1e-9 - PI, PI - 1e-9)])]
    arms = [cr.planar(kinds, lengths).with_limits(position=limits) for kinds, lengths, limits in known]
    rail = cr.planar("PR", (0.8416062254357982, 0.7727779139839083), (PI / 4, 0.0))
    arms.append(rail.with_limits(position=[(0.9262859542313282, 1.2024236423988297), (-PI / 2, PI / 2)]))
    arms += [random_arm(rng, "".join(rng.choice(list("RRP"), rng.integers(2, 5))), tidy=k % 2 == 1) for k in range(25)]
    for arm in arms:
        for piece in workspace_region(arm).pieces:
            for t in (0.0, 0.4, 1.0):
                q = np.array(piece.first) + t * (np.array(piece.last) - np.array(piece.first))
                z, heading = tip(arm, q)
                found = workspace_orientations(arm, complex(z))
                assert any(within(heading, *pair, 1e-4) for pair in found), (arm.description, q)


def test_a_fixed_arm_folded_onto_its_axis():
    found = limited("RRR", (1.0, 1.0, 2.0), [None, (0.0, 0.0), (PI, PI)])
    assert found.contains(1e-16, 0.0)
    assert found.orientations(1e-16, 0.0) == FULL


def test_too_many_limited_joints_are_refused():
    arm = cr.planar("R" * 12, [1.0] * 12).with_limits(position=[(-0.1, 0.1)] * 12)
    with pytest.raises(cr.InputError, match=r"12 moving joints, 12 of them limited.*up to 9"):
        workspace_orientations(arm, 11.9 + 0j)


# ---- every orientation behind a limited first joint ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kinds", "lengths", "limits"),
    [
        ("RRR", (1.0, 0.8, 0.4), [(-2.8, 2.8), (-2.6, 2.6), (-2.8, 2.8)]),
        ("RRR", (1.0, 0.5, 0.25), [(0.0, 2.0), (-2.0, 2.0), None]),
        ("PRR", (0.0, 0.5, 0.25), [(0.0, 2.0), None, (-3.0, 3.0)]),
    ],
)
def test_dexterous_region(kinds, lengths, limits):
    arm = cr.planar(kinds, lengths).with_limits(position=limits)
    found = workspace(arm)
    assert not found.exact and found.secondary == ()
    assert 0.0 < found.dexterous.area < found.area
    rng = np.random.default_rng(0)
    z = found.region.size * (rng.uniform(-1, 1, 1500) + 1j * rng.uniform(-1, 1, 1500))
    said = found.contains(z.real, z.imag, every_orientation=True)
    # against the orientations at each point, and against the traced outline
    for place, yes in zip(z[::20], said[::20], strict=True):
        assert (found.orientations(place.real, place.imag) == FULL) == yes
    clear = found.dexterous.distance(z) > found.region.size / 40  # the outline's squares may cut off tips
    assert (found.dexterous.contains(z) == said)[clear].all()
    # against inverse kinematics on a grid of orientations
    alpha = np.linspace(-PI, PI, 721)
    limited = arm.with_limits(position=[(-PI, PI) if pair is None else pair for pair in limits])
    reached = reached_rrr if kinds == "RRR" else reached_prr
    for place, yes in zip(z[:200], said[:200], strict=True):
        if yes:
            assert reached(limited, place, alpha).all()
        elif reached(limited, place, alpha).all():  # a gap narrower than the grid
            assert sum(high - low for low, high in found.orientations(place.real, place.imag)) > 2 * PI - 0.02


def test_less_than_a_turn_in_all_reaches_nothing_with_every_orientation():
    found = workspace(cr.planar_3r(1, 1, 1).with_limits(position=[(0, 2), (0, 2), (0, 2)]))
    assert found.exact and found.dexterous == Region()
    assert not found.contains(1.0, 1.0, every_orientation=True)


def test_a_free_wrist_on_the_tip_reaches_everything_with_every_orientation():
    arm = cr.planar("RRR", (1.0, 0.5, 0.0)).with_limits(position=[(0.0, 1.0), (0.5, 2.0), None])
    found = workspace(arm)
    assert found.exact
    assert found.dexterous.area == pytest.approx(found.area, abs=1e-14)
    assert found.area == pytest.approx(0.5 * (math.cos(0.5) - math.cos(2.0)), abs=1e-14)
    assert (Everywhere(chain(arm.description))(np.array([1.2 + 0.8j, 5.0])) == [True, False]).all()


# ---- sets of angles --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(60))
def test_union_against_a_grid(seed):
    rng = np.random.default_rng(seed)
    low = rng.uniform(-10, 10, rng.integers(1, 6))
    given = [(a, a + rng.choice([0.0, 0.3, 1.0, 3.0, 6.0])) for a in low]
    found = union(given)
    angles = np.linspace(-PI, PI, 1000)
    truth = np.any([within(angles, *pair) for pair in given], axis=0)
    said = np.any([within(angles, *pair) for pair in found], axis=0)
    assert (truth == said).all() if found != FULL else truth.all()
    assert all(-PI < a <= PI and a <= b < a + 2 * PI for a, b in found) or found == FULL
    assert all(b < c for (_, b), (c, _) in itertools.pairwise(found))
    assert len(found) < 2 or found[-1][1] < found[0][0] + 2 * PI


def test_widening_and_points():
    assert union([]) == ()
    assert union([(PI, PI)]) == ((PI, PI),)
    assert union([(-PI, -PI)]) == ((PI, PI),)
    assert union([(0.0, 7.0)]) == FULL
    assert union([(0.0, PI), (PI, 2 * PI)]) == FULL
    assert widened(((0.0, 1.0),), -0.5, 0.25) == (pytest.approx((-0.5, 1.25)),)
    assert widened(((0.0, 1.0), (3.0, 3.0)), -1.0, 1.5) == (pytest.approx((-1.0, 4.5)),)
    assert widened((), -1.0, 1.0) == ()


def test_circles_in_a_region():
    ring = Region(((Arc(0.5 + 0j, 2.0, -PI, 2 * PI),), (Arc(0.5 + 0j, 1.0, PI, -2 * PI),)))
    assert circle_in(ring, 1.5) == FULL  # touches both circles
    edge = math.acos((0.25 + 0.49 - 1.0) / 0.7)  # |0.7 e^(ia) - 0.5| >= 1
    assert circle_in(ring, 0.7) == (pytest.approx((edge, 2 * PI - edge)),)
    assert circle_in(ring, 0.5) == (pytest.approx((PI, PI)),)
    assert circle_in(ring, 2.5) == (pytest.approx((0.0, 0.0)),)
    assert circle_in(ring, 3.0) == ()
    assert circle_in(ring, 0.0) == ()
