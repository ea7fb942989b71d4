"""Aspects against a flood fill of the joint space, and against what is known of their number and their ends."""

import math

import numpy as np
import pytest
from regional_arms import TURN, general, orthogonal, tip_and_determinant
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

import chainrule as cr
from chainrule import InputError
from chainrule.cuspidality.aspects import Critical, components

GRID, ALONG = 150, 6


def flooded(design):
    """Configurations on a grid of the torus (theta2, theta3), the sign of det J there, and the component of each.

    Neighbours belong together where det J keeps its sign at several places between them, and not over the lines of
    the orthogonal arms, which are singular for every theta2 (the factor d3 + d4 cos(theta3) of det J).
    """
    angles = (np.arange(GRID) + 0.37) * TURN / GRID - math.pi

    def determinant(theta2, theta3):
        q = np.stack(np.broadcast_arrays(0.3, theta2, theta3), axis=-1)
        return tip_and_determinant(design, q)[1]

    sign = np.sign(determinant(angles[:, None], angles[None, :]))
    step = np.arange(1, ALONG) * TURN / GRID / ALONG
    number = np.arange(GRID * GRID).reshape(GRID, GRID)
    edges = []
    for axis in (0, 1):
        places = angles[:, None, None], angles[None, :, None]
        moved = (places[0] + step, places[1]) if axis == 0 else (places[0], places[1] + step)
        between = np.sign(determinant(*moved))
        joined = (between == sign[..., None]).all(axis=-1) & (np.roll(sign, -1, axis=axis) == sign)
        if axis == 1:
            for wall in walls(design):
                joined &= np.remainder(wall - angles, TURN) > TURN / GRID
        edges.append(np.stack([number[joined], np.roll(number, -1, axis=axis)[joined]]))
    rows, columns = np.concatenate(edges, axis=1)
    graph = coo_array((np.ones(rows.size), (rows, columns)), shape=(GRID**2, GRID**2))
    component = connected_components(graph, directed=False)[1].reshape(GRID, GRID)
    q = np.stack(np.broadcast_arrays(0.3, angles[:, None], angles[None, :]), axis=-1)
    return q, sign, component


def walls(design):
    """Every theta3 with d3 + d4 cos(theta3) = 0, for an orthogonal arm."""
    if not isinstance(design, cr.Orthogonal3R):
        return []
    _, d3, d4, _ = design.lengths
    return [] if abs(d3) > abs(d4) else [math.acos(-d3 / d4), -math.acos(-d3 / d4)]


def check_against_flood(design):
    """What the grid joins is one aspect; what is one aspect and the grid leaves apart is joined by a proved path."""
    q, sign, component = flooded(design)
    labels = design.aspect_of(q)
    every = design.aspects()
    assert [aspect.label for aspect in every] == list(range(len(every)))
    assert (labels >= 0).mean() > 0.999
    signs = np.array([aspect.sign for aspect in every])
    assert (signs[labels] == sign)[labels >= 0].all()
    pieces = {}
    for part in np.unique(component):
        found = labels[component == part]
        found = np.unique(found[found >= 0])
        assert found.size <= 1
        for label in found:
            pieces.setdefault(int(label), []).append(q[component == part][0])
    for first, *others in pieces.values():
        for other in others[:3]:
            change = design.posture_change(first, other)
            assert change.exists
            assert change.certified
    return len(pieces), len(every)


@pytest.mark.parametrize("family", [orthogonal, general])
def test_aspects_are_what_a_flood_fill_finds(family):
    rng = np.random.default_rng(5)
    for _ in range(4):
        seen, known = check_against_flood(family(rng))
        assert seen == known  # random aspects are wide enough for the grid to meet each


#: Arms in which something coincides: d3 = d4 (both lines are one, theta3 = pi), a line tangent to the singular curve
#: (surface C2: d4 = d3 / (d3 + d2) sqrt((d3 + d2)^2 + r2^2), exact in binary), no offset, equal lengths.
DEGENERATE = {
    "d3 = d4": (1.0, 2.0, 2.0, 1.0),
    "on C2": (1.0, 3.0, 3.75, 3.0),
    "r2 = 0": (1.0, 2.0, 1.5, 0.0),
    "r2 = 0, d3 < d2": (1.0, 0.5, 1.5, 0.0),
    "d2 = d3 = d4 = r2": (1.0, 1.0, 1.0, 1.0),
    "d3 = 0": (1.0, 0.0, 1.5, 0.5),
    "d2 = 0": (0.0, 1.0, 1.5, 0.5),
}


@pytest.mark.parametrize("name", DEGENERATE)
def test_aspects_of_degenerate_arms(name):
    check_against_flood(cr.orthogonal_3r(*DEGENERATE[name]))


def test_a_tangent_line_divides_and_a_nearby_one_does_not():
    """On either side of C2 the line theta3 = -arccos(-d3 / d4) meets the singular curve twice or not at all; on it the
    aspect between them is pinched in one point, which is singular."""
    number = [len(cr.orthogonal_3r(1.0, 3.0, d4, 3.0).aspects()) for d4 in (3.75 - 1e-6, 3.75, 3.75 + 1e-6)]
    by_flood = [check_against_flood(cr.orthogonal_3r(1.0, 3.0, d4, 3.0))[1] for d4 in (3.65, 3.85)]
    assert [number[0], number[2]] == by_flood


def test_a_touching_root_ends_one_sign_only():
    """a^2 + b^2 - c^2 touches zero where c > 0: det J < 0 is lost there, det J > 0 is not; where c = 0 both are."""

    def count(c):
        touching = Critical((-2.0, 1.0), (c, c), (True, True), (1, 1))
        return len(components(touching, 1)), len(components(touching, -1))

    assert count(1) == (1, 2)
    assert count(-1) == (2, 1)
    assert count(0) == (2, 2)


def test_ends_are_singular_for_every_theta2():
    """At the end of an aspect no theta2 is left where det J has its sign, and just inside there is one."""
    rng = np.random.default_rng(6)
    theta2 = np.linspace(-math.pi, math.pi, 2001)
    for design in (*(orthogonal(rng) for _ in range(10)), *(general(rng) for _ in range(10))):
        for aspect in design.aspects():
            lower, upper = aspect.theta3
            assert -math.pi < lower <= math.pi
            assert 0.0 < upper - lower <= TURN * (1.0 + 1e-15)
            if aspect.whole:
                assert upper - lower == pytest.approx(TURN)
                continue
            scale = np.abs(tip_and_determinant(design, rng.uniform(-math.pi, math.pi, (100, 3)))[1]).max()
            for end in (lower, upper):
                det = tip_and_determinant(design, np.stack(np.broadcast_arrays(0.0, theta2, end), axis=-1))[1]
                assert (aspect.sign * det).max() <= 1e-9 * scale
            inside = np.array([lower + share * (upper - lower) for share in (1e-3, 0.5, 1.0 - 1e-3)])
            q = np.stack(np.broadcast_arrays(0.0, theta2, inside[:, None]), axis=-1)
            assert ((aspect.sign * tip_and_determinant(design, q)[1]).max(axis=1) > 0.0).all()


def test_the_first_joint_and_the_size_of_the_arm_play_no_part():
    rng = np.random.default_rng(7)
    for _ in range(5):
        d2, d3, d4, r2 = rng.uniform(0.3, 2.0, 4)
        q = rng.uniform(-math.pi, math.pi, (500, 3))
        turned = q + np.stack([rng.uniform(-9.0, 9.0, 500), *(TURN * rng.integers(-3, 4, (2, 500)))], axis=-1)
        arm = cr.orthogonal_3r(d2, d3, d4, r2)
        np.testing.assert_array_equal(arm.aspect_of(turned), arm.aspect_of(q))
        for scale in (1e-6, 1e6):
            scaled = cr.orthogonal_3r(*(scale * length for length in (d2, d3, d4, r2)))
            np.testing.assert_array_equal(scaled.aspect_of(q), arm.aspect_of(q))


def test_only_every_second_posture_can_share_an_aspect():
    """Along theta3 the signs of det J alternate from posture to posture (dE / dtheta3 is proportional to det J)."""
    rng = np.random.default_rng(8)
    seen = 0
    for design in (*(orthogonal(rng) for _ in range(8)), *(general(rng) for _ in range(8))):
        for q in rng.uniform(-math.pi, math.pi, (20, 3)):
            tip, _ = tip_and_determinant(design, q)
            found = design.postures(*tip)
            det = tip_and_determinant(design, found[np.argsort(found[:, 2])])[1]
            assert (det[:-1] * det[1:] < 0.0).all()
            seen += len(found) == 4
    assert seen > 20


def test_singular_configurations_have_no_aspect():
    arm = cr.orthogonal_3r(1.0, 3.0, 4.0, 3.0)
    line = math.acos(-3.0 / 4.0)
    assert arm.aspect_of([[0.0, 0.3, line], [0.0, 2.0, -line]]).tolist() == [-1, -1]
    curves = arm.singular_curves(50)
    joint = np.concatenate([curve.joint for curve in curves])
    assert (arm.aspect_of(np.column_stack([np.zeros(len(joint)), joint])) == -1).mean() > 0.95
    assert not arm.same_aspect([0.0, 0.3, line], [0.0, 0.3, line])


def test_an_arm_that_is_always_singular_has_no_aspects():
    for lengths in ((1.0, 2.0, 0.0, 1.0), (0.0, 0.0, 1.0, 0.0)):
        arm = cr.orthogonal_3r(*lengths)
        q = np.random.default_rng(0).uniform(-3.0, 3.0, (50, 3))
        flat = np.abs(tip_and_determinant(arm, q)[1]).max() < 1e-12
        assert (arm.aspects() == ()) == flat
        assert (arm.aspect_of(q) == -1).all() == flat


def test_shapes_and_bad_input():
    arm = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    assert arm.aspect_of(np.zeros((0, 3))).shape == (0,)
    assert arm.aspect_of(np.ones((2, 5, 3))).shape == (2, 5)
    assert arm.same_aspect(np.ones((4, 1, 3)), np.ones((5, 3))).shape == (4, 5)
    assert arm.aspect_of([math.nan, 0.0, 0.0]) == -1
    for wrong in (np.zeros(2), "q", [[1.0, 2.0], [3.0]]):
        with pytest.raises(InputError):
            arm.aspect_of(wrong)
