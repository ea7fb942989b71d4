"""Workspaces of planar arms within their limits, against closed forms, sampling, grids and optimisation."""

import itertools
import json
import math

import numpy as np
import pytest

import chainrule as cr
from chainrule import regions
from chainrule.boundary_pieces import Arc, Segment
from chainrule.boundary_tracing import trace
from chainrule.description import Planar
from chainrule.planar_chains import chain, from_tip, merged, reached
from chainrule.regions import Region, point
from chainrule.sweeping import Slide, Turn, sweep
from chainrule.workspaces import boundary_table, dexterous_rings, ring, rings_inside, workspace

PI = math.pi


def tip(arm, q):
    """Tip and heading by the definition of a planar chain: nothing of the code under test."""
    geometry = arm.description.geometry
    assert isinstance(geometry, Planar)
    heading, z = np.zeros(q.shape[:-1]), np.zeros(q.shape[:-1], dtype=complex)
    for i, kind in enumerate(arm.kinds):
        heading = heading + (q[..., i] if kind == "R" else geometry.headings[i])
        z = z + (geometry.lengths[i] + (q[..., i] if kind == "P" else 0.0)) * np.exp(1j * heading)
    return z, heading


def box(arm):
    """Limits (n, 2), a full turn where a revolute joint has none."""
    limits = arm.limits.position.copy()
    limits[~np.isfinite(limits).all(axis=1)] = [-PI, PI]
    return limits


def samples(arm, rng, count):
    """Postures inside the limits, many of them with joints at their limits."""
    low, high = box(arm).T
    q = rng.uniform(low, high, (count, arm.n))
    where = rng.random(q.shape)
    return np.where(where < 0.2, low, np.where(where < 0.4, high, q))


def random_arm(rng, kinds):
    lengths = rng.uniform(-0.2, 1.0, len(kinds))
    headings = [rng.uniform(-3, 3) if kind == "P" else 0.0 for kind in kinds]
    limits = []
    for kind in kinds:
        low = rng.uniform(-3, 3) if kind == "R" else rng.uniform(-1, 1)
        limits.append((low, low + (rng.uniform(0.1, 4.5) if kind == "R" else rng.uniform(0.1, 1.0))))
    return cr.planar(kinds, lengths, headings).with_limits(position=limits)


def tidy_arm(rng, kinds):
    """Equal and zero lengths, symmetric limits, quarter turns: everything coincides that can."""
    lengths = rng.choice([0.0, 0.5, 1.0, 1.0, 1.0, 2.0], len(kinds))
    headings = [rng.choice([0.0, PI / 2, -PI / 2, PI / 4]) if kind == "P" else 0.0 for kind in kinds]
    limits = []
    for kind in kinds:
        middle = rng.choice([0.0, 0.0, PI / 2, PI] if kind == "R" else [0.0, 0.5])
        half = rng.choice([0.0, PI / 4, PI / 2, PI / 2, 0.75 * PI, PI] if kind == "R" else [0.0, 0.25, 0.5])
        limits.append((middle - half, middle + half))
    return cr.planar(kinds, lengths, headings).with_limits(position=limits)


def words(rng, most=5):
    return "".join(rng.choice(list("RRRP"), rng.integers(1, most + 1)))


def tip_jacobian(arm, q):
    """Derivatives of the tip (k, n), complex, by the definition of a planar chain."""
    starts, headings, heading, z = [], [], np.zeros(len(q)), np.zeros(len(q), dtype=complex)
    for i, kind in enumerate(arm.kinds):
        starts.append(z)
        heading = heading + (q[:, i] if kind == "R" else arm.description.geometry.headings[i])
        headings.append(np.exp(1j * heading))
        z = z + (arm.description.geometry.lengths[i] + (q[:, i] if kind == "P" else 0.0)) * headings[-1]
    columns = [1j * (z - p) if kind == "R" else u for kind, p, u in zip(arm.kinds, starts, headings, strict=True)]
    return z, np.stack(columns, axis=1)


def nearest_to(arm, target, rng, starts=60):
    """The least distance from a point that a projected Levenberg-Marquardt search from many postures finds.

    It ends when the point is reached, or when forty steps have brought nothing.
    """
    low, high = box(arm).T
    q = rng.uniform(low, high, (starts, arm.n))
    damping = np.full(starts, 1e-2)
    z, jacobian = tip_jacobian(arm, q)
    best, waited = np.inf, 0
    while waited < 40 and best > 1e-11:
        gradient = (jacobian.conj() * (z - target)[:, None]).real
        held = ((q <= low) & (gradient > 0)) | ((q >= high) & (gradient < 0))
        free = np.where(held, 0, jacobian)
        normal = (free.conj()[:, :, None] * free[:, None, :]).real + damping[:, None, None] * np.eye(arm.n)
        step = np.linalg.solve(normal, np.where(held, 0.0, gradient)[..., None])[..., 0]
        trial = np.clip(q - step, low, high)
        z_trial, jacobian_trial = tip_jacobian(arm, trial)
        better = np.abs(z_trial - target) < np.abs(z - target)
        q, z = np.where(better[:, None], trial, q), np.where(better, z_trial, z)
        jacobian = np.where(better[:, None], jacobian_trial, jacobian)
        damping = np.clip(np.where(better, damping * 0.3, damping * 4.0), 1e-12, 1e6)
        least = float(np.abs(z - target).min())
        best, waited = (least, 0) if least < best - 1e-9 else (min(least, best), waited + 1)
    return best


def reached_by_grid(arm, z, steps=600):
    """Whether points are reached by a 3R arm: the first joint on a fine grid, the other two in closed form."""
    l1, l2, l3 = arm.description.geometry.lengths
    limits = box(arm)
    found = np.zeros(len(z), dtype=bool)
    for q1 in np.linspace(*limits[0], steps):
        rest = (z - l1 * np.exp(1j * q1)) * np.exp(-1j * q1)
        cosine = (np.abs(rest) ** 2 - l2**2 - l3**2) / (2 * l2 * l3)
        for sign in (-1, 1):
            q3 = sign * np.arccos(np.clip(cosine, -1, 1))
            q2 = np.angle(rest / (l2 + l3 * np.exp(1j * q3)))
            found |= (np.abs(cosine) <= 1) & turned_within(q2, limits[1]) & turned_within(q3, limits[2])
    return found


def turned_within(angle, limits, slack=0.0):
    return np.mod(angle - limits[0] + slack, 2 * PI) <= limits[1] - limits[0] + 2 * slack


def limited_3r(seed):
    rng = np.random.default_rng(seed)
    low = rng.uniform(-3, 0, 3)
    return cr.planar_3r(*rng.uniform(0.2, 1.0, 3)).with_limits(
        position=np.stack([low, low + rng.uniform(0.5, 3, 3)], 1)
    )


# ---- without limits --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lengths", "primary", "secondary"),
    [
        ((1.0, 0.5, 0.25), (0.25, 1.75), [(0.75, 1.25)]),  # De Luca, exercise 1
        ((1.0, 0.9, 0.5), (0.0, 2.4), [(0.0, 0.4), (0.6, 1.4)]),  # last link longer than l1 - l2: a disc is added
        ((1.0, 1.0, 0.5), (0.0, 2.5), [(0.0, 1.5)]),  # l1 = l2: disc and ring merge
        ((1.0, 1.0, 1.0), (0.0, 3.0), [(0.0, 1.0)]),
        ((1.0, 0.5, 2.0), (0.5, 3.5), []),  # last link too long
        ((1.0, 0.5, 0.5), (0.0, 2.0), [(0.0, 0.0), (1.0, 1.0)]),  # two single radii: l3 = l2
        ((1.0, 0.5, 0.25, 0.75), (0.0, 2.5), [(0.0, 0.5), (1.0, 1.0)]),  # n > 3, a single radius
        ((0.5, 0.4, 0.3, 0.2, 0.1), (0.0, 1.5), [(0.0, 1.3)]),
        ((2.0, 0.5, 0.25, 0.1), (1.15, 2.85), [(1.35, 2.65)]),
        ((1.0, 1.0), (0.0, 2.0), [(0.0, 0.0)]),
        ((1.0, 0.5), (0.5, 1.5), []),
        ((1.0, 0.0), (1.0, 1.0), [(1.0, 1.0)]),  # a wrist on the tip
        ((0.0, 1.0, 0.0), (1.0, 1.0), [(1.0, 1.0)]),
        ((1.0,), (1.0, 1.0), []),
        ((0.0,), (0.0, 0.0), [(0.0, 0.0)]),
    ],
)
def test_rings_without_limits(lengths, primary, secondary):
    found = workspace(cr.planar("R" * len(lengths), lengths))
    assert found.symmetric and found.exact
    np.testing.assert_allclose(found.primary, [primary], atol=1e-15)
    np.testing.assert_allclose(np.reshape(found.secondary, (-1, 2)), np.reshape(secondary, (-1, 2)), atol=1e-15)
    assert found.area == pytest.approx(PI * (primary[1] ** 2 - primary[0] ** 2), abs=1e-12)
    assert found.dexterous.area == pytest.approx(PI * sum(b**2 - a**2 for a, b in secondary), abs=1e-12)


@pytest.mark.parametrize("seed", range(40))
def test_the_general_way_agrees_with_the_closed_form(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 7))
    lengths = rng.uniform(-1, 1, n) if seed % 2 else rng.choice([0.0, 0.5, 0.5, 1.0, 2.0], n)
    whole = chain(cr.planar("R" * n, lengths).description)
    radii = [piece.radius for piece in reached(whole).pieces if isinstance(piece, Arc)]
    inner, outer = ring(lengths)
    assert max(radii, default=0.0) == pytest.approx(outer, abs=1e-13)
    assert (min(radii) if len(radii) > 1 else 0.0) == pytest.approx(inner if inner < outer else 0.0, abs=1e-13)
    seen = from_tip(merged(whole))
    general = rings_inside(reached(type(seen)(seen.joints[:-1], seen.links[:-1], seen.values, seen.size)))
    np.testing.assert_allclose(np.reshape(general, (-1, 2)), np.reshape(dexterous_rings(lengths), (-1, 2)), atol=1e-12)


def test_the_papers_formula_holds_for_a_short_last_link_only():
    rng = np.random.default_rng(7)
    for l1, l2, l3 in rng.uniform(0.05, 1, (500, 3)):
        printed = (abs(l1 - l2) + l3, l1 + l2 - l3)
        ours = dexterous_rings((l1, l2, l3))
        if l3 < abs(l1 - l2) and printed[0] <= printed[1]:
            np.testing.assert_allclose(ours, [printed], atol=1e-15)
        elif l3 > abs(l1 - l2):
            assert ours == () or ours[0][0] == 0.0


# ---- exact areas -----------------------------------------------------------------------------------------------------


def limited(kinds, lengths, limits, headings=None):
    return workspace(cr.planar(kinds, lengths, headings).with_limits(position=limits))


def test_areas_known_in_closed_form():
    # polar: r from 1 to 1.5, over 0.7 rad
    assert limited("RP", (0, 0), [(-0.2, 0.5), (1, 1.5)]).area == pytest.approx(0.5 * (1.5**2 - 1) * 0.7, abs=1e-14)
    # two slides: a parallelogram
    slides = limited("PP", (0.3, -0.1), [(0, 2), (-1, 0.5)], (0.2, 1.1))
    assert slides.area == pytest.approx(2 * 1.5 * math.sin(1.1), abs=1e-14)
    # a bow on a rail across it: width of the bow times the stroke (every line along x meets the bow once)
    assert limited("PR", (0, 2), [(0, 0.5), (0, 1)]).area == pytest.approx(0.5 * 2 * math.sin(1), abs=1e-14)
    # 2R with q2 in [a, b] of one sign: l1 l2 (cos a - cos b) q1-range, the integral of the Jacobian's determinant
    elbow = limited("RR", (1.1, 0.6), [(-0.4, 0.8), (0.3, 2.5)])
    assert elbow.area == pytest.approx(1.1 * 0.6 * (math.cos(0.3) - math.cos(2.5)) * 1.2, abs=1e-14)
    # the middle one of three joints alone moves: an arc of length l times range
    bow = limited("RRR", (1, 0.5, 0.5), [(0.3, 0.3), (-1, 1), (0, 0)])
    assert bow.area == 0.0
    assert sum(piece.length for piece in bow.region.curves) == pytest.approx(2.0, abs=1e-14)


def test_a_first_joint_that_turns_freely_makes_a_ring_of_any_arm():
    found = limited("RPR", (0.2, 1.0, 0.25), [None, (0.0, 0.6), (-2.0, 2.0)])
    # the tip is farthest fully stretched, nearest with the slide in and q3 at a limit
    assert found.primary[0][1] == pytest.approx(0.2 + 1.6 + 0.25, abs=1e-14)
    assert found.primary[0][0] == pytest.approx(abs(1.2 + 0.25 * np.exp(2j)), abs=1e-14)
    assert found.symmetric and found.secondary == ()


def test_coaxial_joints_add_up_to_a_free_turn():
    found = limited("RRR", (0.0, 1.0, 0.3), [(-2, 2), (-2, 2), None])
    assert found.symmetric
    np.testing.assert_allclose(found.primary, [(0.7, 1.3)], atol=1e-14)


@pytest.mark.parametrize("limits", [(-math.inf, 0.5), (0.0, math.inf), (-3.0, 3.3), (1.0, 1.0 + 2 * PI)])
def test_ranges_that_turn_freely(limits):
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[limits, limits, limits])
    assert workspace(arm).primary == ((0.25, 1.75),)
    assert workspace(arm).secondary == ((0.75, 1.25),)


@pytest.mark.parametrize("limit", [1e3, 1e6, 1e9, 1e20])
def test_very_wide_limits_turn_freely(limit):
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(-limit, limit), (limit, 2 * limit), (-limit, limit)])
    if limit < 1e10:  # from there on numbers are further apart than a turn is long
        assert workspace(arm).secondary == ((0.75, 1.25),)
    free = workspace(arm.with_limits(position=[(-limit, limit)] * 3))
    assert (free.primary, free.secondary) == (((0.25, 1.75),), ((0.75, 1.25),))


@pytest.mark.parametrize("length", [1e-200, 1e200])
def test_arms_of_no_sensible_size_are_refused(length):
    with pytest.raises(cr.InputError, match=r"add up to .* m; 1e-60 to 1e\+60 m are accepted"):
        workspace(cr.planar_3r(length, length, length))


def test_rings_about_another_point_than_the_base():
    found = limited("RRR", (1.0, 0.5, 0.25), [(0.0, 0.0), None, None])
    assert not found.symmetric and found.primary == ()
    assert found.area == pytest.approx(PI * (0.75**2 - 0.25**2), abs=1e-14)
    assert found.contains([1.0, 1.5, 1.76, 0.3], 0.0).tolist() == [False, True, False, True]
    assert found.orientations(1.0, 0.5) == workspace(cr.planar("RR", (0.5, 0.25))).orientations(0.0, 0.5)


# ---- with limits, against sampling -----------------------------------------------------------------------------------


@pytest.mark.parametrize("make", [random_arm, tidy_arm])
def test_samples_are_inside_and_boundary_postures_are_real(make):
    rng = np.random.default_rng(11)
    for _ in range(45):
        arm = make(rng, words(rng))
        found = workspace_region(arm)
        z, _ = tip(arm, samples(arm, rng, 400))
        assert found.contains(z, 1e-9).all(), arm.description
        low, high = box(arm).T
        for piece in found.pieces:
            for t in (0.0, 0.37, 1.0):
                q = np.array([a + t * (b - a) for a, b in zip(piece.first, piece.last, strict=True)])
                assert abs(tip(arm, q)[0] - piece.point(t)) < 1e-9
                assert (q >= low - 1e-9).all() and (q <= high + 1e-9).all()


def workspace_region(arm):
    return reached(chain(arm.description))


@pytest.mark.parametrize("seed", range(3))
def test_membership_and_area_against_a_fine_grid(seed):
    arm = limited_3r(seed)
    found = workspace(arm)
    rng = np.random.default_rng(seed)
    size = sum(arm.description.geometry.lengths)
    count = 2500
    z = rng.uniform(-size, size, count) + 1j * rng.uniform(-size, size, count)
    truth = reached_by_grid(arm, z)
    inside = found.contains(z.real, z.imag)
    assert not (truth & ~inside).any()
    doubtful = found.region.distance(z) < 8e-3  # the grid's steps
    assert (truth == inside)[~doubtful].all()
    share = found.area / (2 * size) ** 2
    statistical = 4 * math.sqrt(share * (1 - share) / count)
    assert abs(inside.mean() - share) < statistical
    assert abs(truth.mean() - share) < statistical + doubtful.mean()


@pytest.mark.parametrize("seed", range(10))
def test_distances_against_an_optimiser(seed):
    """Outside, the nearest the tip comes is the distance from the boundary; well inside, it arrives."""
    rng = np.random.default_rng(100 + seed)
    kinds = ["RRRR", "RPR", "PRR", "RRP", "RRRRR", "PR", "RRRP", "PRRR", "RRR", "RPRR"][seed]
    arm = random_arm(rng, kinds)
    region = workspace_region(arm)
    z = rng.uniform(-1, 1, 8) * region.size + 1j * rng.uniform(-1, 1, 8) * region.size
    inside = region.contains(z)
    expected = np.where(inside, 0.0, region.distance(z))
    for place, distance in zip(z, expected, strict=True):
        assert nearest_to(arm, place, rng) == pytest.approx(distance, abs=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_each_edge_separates_reached_from_not_reached(seed):
    rng = np.random.default_rng(200 + seed)
    arm = limited_3r(50 + seed)
    region = workspace(arm).region
    for piece in region.pieces:
        if piece.length < 0.02:
            continue
        step = 2e-3j * piece.tangent(0.5)
        assert nearest_to(arm, piece.point(0.5) + step, rng, 200) < 1e-9  # left: inside
        assert nearest_to(arm, piece.point(0.5) - step, rng) == pytest.approx(2e-3, abs=1e-6)


def test_postures_agree_with_the_generated_functions():
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(-0.5, 2), (-2, 2), (-2.5, 2.5)])
    for piece in workspace(arm).region.pieces:
        for q, t in ((piece.first, 0.0), (piece.last, 1.0)):
            z = piece.point(t)
            np.testing.assert_allclose(arm.position(q), [z.real, z.imag], atol=1e-14)


# ---- properties ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(8))
def test_mirror_scale_and_turn(seed):
    rng = np.random.default_rng(seed)
    kinds = "R" + words(rng, 3)
    arm = random_arm(rng, kinds)
    geometry, limits = arm.description.geometry, arm.limits.position
    region = workspace_region(arm)
    z = (rng.uniform(-1, 1, 500) + 1j * rng.uniform(-1, 1, 500)) * region.size
    z = z[region.distance(z) > 1e-9 * region.size]

    def changed(lengths, headings, position):
        return workspace_region(cr.planar(kinds, lengths, headings).with_limits(position=position))

    flip = np.array(
        [[-high, -low] if kind == "R" else [low, high] for kind, (low, high) in zip(kinds, limits, strict=True)]
    )
    mirrored = changed(geometry.lengths, -np.array(geometry.headings), flip)
    assert mirrored.area == pytest.approx(region.area, rel=1e-9)
    assert (mirrored.contains(z.conj()) == region.contains(z)).all()

    stroke = np.array([[1.0] if kind == "R" else [2.5] for kind in kinds])
    larger = changed(2.5 * np.array(geometry.lengths), geometry.headings, limits * stroke)
    assert larger.area == pytest.approx(2.5**2 * region.area, rel=1e-9)
    assert (larger.contains(2.5 * z) == region.contains(z)).all()

    turned = changed(geometry.lengths, geometry.headings, limits + np.array([[0.7, 0.7]] + [[0, 0]] * (len(kinds) - 1)))
    assert turned.area == pytest.approx(region.area, rel=1e-9)
    assert (turned.contains(z * np.exp(0.7j)) == region.contains(z)).all()


def test_wider_limits_reach_more():
    rng = np.random.default_rng(3)
    for _ in range(8):
        arm = random_arm(rng, "RRR")
        wide = arm.with_limits(position=arm.limits.position + np.array([-0.2, 0.3]))
        region, more = workspace_region(arm), workspace_region(wide)
        assert more.area > region.area - 1e-12
        z = np.array([piece.point(t) for piece in region.pieces for t in (0.1, 0.6)])
        assert more.contains(z, 1e-9).all()


def test_limits_growing_to_a_full_turn_grow_to_the_ring():
    def area(half):
        limits = [(-half, half)] * 3
        return workspace_region(cr.planar_3r(1, 0.5, 0.25).with_limits(position=limits)).area

    areas = [area(half) for half in (1.0, 2.0, 3.0, 3.1, 3.14, PI)]
    assert areas == sorted(areas)
    assert areas[-1] == pytest.approx(PI * (1.75**2 - 0.25**2), abs=1e-12)
    assert areas[-2] == pytest.approx(areas[-1], rel=1e-2)


@pytest.mark.parametrize("n", [5, 6, 8])
def test_long_arms(n):
    rng = np.random.default_rng(n)
    arm = cr.planar("R" * n, np.linspace(1, 0.2, n)).with_limits(position=[(-0.7, 0.5)] * n)
    region = workspace_region(arm)
    z, _ = tip(arm, samples(arm, rng, 4000))
    assert region.contains(z, 1e-9).all()
    deep = z[(region.distance(z) > 0.05)][:5]
    assert all(nearest_to(arm, place, rng) < 1e-9 for place in deep)


def test_a_region_that_closes_on_itself():
    # with 2 x 100 degrees the two ends of the sector meet exactly behind the base at 180 + 180 degrees of turn
    region = workspace_region(cr.planar("RP", (0, 1)).with_limits(position=[(-PI + 1e-13, PI), (0, 1)]))
    assert region.area == pytest.approx(3 * PI, abs=1e-9)
    # limits whose boundary touches itself: the tip comes back to the base
    region = workspace_region(cr.planar("RRR", (1, 1, 1)).with_limits(position=[(-PI / 2, PI / 2)] * 3))
    z, _ = tip(cr.planar("RRR", (1, 1, 1)), np.random.default_rng(0).uniform(-PI / 2, PI / 2, (5000, 3)))
    assert region.contains(z, 1e-9).all()


# ---- regions themselves ----------------------------------------------------------------------------------------------


def test_loops_are_closed_and_have_the_inside_on_their_left():
    rng = np.random.default_rng(5)
    for make, _ in itertools.product((random_arm, tidy_arm), range(25)):
        region = workspace_region(make(rng, words(rng)))
        for loop in region.loops:
            for piece, following in zip(loop, loop[1:] + loop[:1], strict=True):
                assert abs(piece.point(1.0) - following.point(0.0)) < 1e-8 * region.size
        pieces = [piece for loop in region.loops for piece in loop if piece.length > 0.02]
        middle = np.array([piece.point(0.5) for piece in pieces])
        left = np.array([1e-5j * piece.tangent(0.5) for piece in pieces])
        if pieces:
            gap = [region_without(region, piece).distance(np.array([piece.point(0.5)]))[0] for piece in pieces]
            clear = np.array(gap) > 1e-4
            assert region.contains(middle + left)[clear].all()
            assert not region.contains(middle - left)[clear].any()


def region_without(region, piece):
    return Region(curves=tuple(other for other in region.pieces if other is not piece))


def test_membership_on_awkward_points():
    ring_ = Region(((Arc(0j, 2.0, -PI, 2 * PI),), (Arc(0j, 1.0, PI, -2 * PI),)))
    z = np.array([0, 1, -1, 2, -2, 1j, 2j, -1.5, 1.5, 1.5j, -1.5j, 0.999, 2.001, -2.001, np.exp(1j), 2 * np.exp(2j)])
    expected = [0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 1]
    assert ring_.contains(z).tolist() == [bool(e) for e in expected]
    square = Region(((Segment(0j, 1 + 0j), Segment(1 + 0j, 1 + 1j), Segment(1 + 1j, 1j), Segment(1j, 0j)),))
    z = np.array([0, 1, 1j, 1 + 1j, 0.5, 0.5j, 0.5 + 0.5j, -0.1, 1.1, -0.1 + 1j, 1.1 + 1j, 0.5 + 1.1j])
    assert square.contains(z).tolist() == [True] * 7 + [False] * 5
    # a lens: rays through its corners, points on its chord
    lens = Region(((Arc(-1j, math.sqrt(2), PI / 4, PI / 2), Arc(1j, math.sqrt(2), -3 * PI / 4, PI / 2)),))
    z = np.array([0, 0.5, -0.5, 1, -1, -2, 2, 0.4j, -0.4j, 0.42j, 0.5 + 0.2j])
    assert lens.contains(z).tolist() == [True] * 5 + [False] * 2 + [True] * 2 + [False] + [True]
    assert lens.area == pytest.approx(PI - 2, abs=1e-14)


def test_memory_stays_bounded_and_answers_do_not_depend_on_the_batch(monkeypatch):
    region = workspace_region(limited_3r(1))
    rng = np.random.default_rng(0)
    z = rng.normal(size=5000) + 1j * rng.normal(size=5000)
    together = region.contains(z)
    sizes = []
    nearest = regions.nearest

    def watched(p, points):
        sizes.append(len(p.start) * len(points))
        return nearest(p, points)

    monkeypatch.setattr(regions, "nearest", watched)
    monkeypatch.setattr(regions, "CHUNK", 1000)
    assert (together == region.contains(z)).all()
    assert max(sizes) <= 1000 and sum(sizes) == len(z) * len(region.pieces)
    assert region.contains(z[:0]).shape == (0,)


def test_sweeping_a_square():
    square = sweep(sweep(point(1 + 0j), Slide, 0.0, 1.0).moved(1j, 0j), Slide, 0.0, 1.0)
    assert square.area == pytest.approx(1.0, abs=1e-14)
    # turned about the origin: from the square's nearest point (0, 1) to its farthest (1, 2); Pappus does not apply,
    # but turning by a full turn must give the ring
    whole = sweep(square, Turn, 0.0, 2 * PI)
    assert whole.area == pytest.approx(PI * (5.0 - 1.0), abs=1e-12)


def test_tracing_a_known_shape():
    def inside(z):
        return (np.abs(z) < 1.0) & (np.abs(z - 0.2) > 0.3) & ~((z.real > 0.6) & (np.abs(z.imag) < 0.1))

    loops = trace(inside, -1 - 1j, 1 + 1j, 60, 1e-9, 1e-6)
    assert len(loops) == 2
    y = np.linspace(-0.1, 0.1, 20001)
    slot = np.trapezoid(np.sqrt(1 - y**2) - 0.6, y)
    assert Region(loops).area == pytest.approx(PI - PI * 0.09 - slot, abs=1e-3)  # its corners are cut
    corners = np.array([piece.point(0.0) for loop in loops for piece in loop])
    assert inside(corners).all()
    assert trace(lambda z: np.zeros(len(z), dtype=bool), 0j, 1 + 1j, 10, 1e-9, 1e-6) == ()


# ---- results and refusals --------------------------------------------------------------------------------------------


def test_the_result_is_plain_and_complete():
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(0, 2), (-2, 2), (-0.5, 0.5)])
    found = workspace(arm)
    shown = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert shown["area"] == found.area
    assert len(shown["boundary"]) == len(found.region.pieces) == sum(shown["loops"])
    assert {state for piece in shown["boundary"] for state in piece["joints"]} <= {
        *("moves", "lower", "upper", "fixed", "stretched", "folded", "aligned")
    }
    table = boundary_table(found)
    assert len(table.rows) == len(found.region.pieces)
    for piece in found.region.pieces:
        states = found.joints(piece)
        assert states.count("moves") == 1
        for state, value, (low, high) in zip(states, piece.first, arm.limits.position, strict=True):
            expected = {"lower": low, "upper": high, "stretched": 0.0}.get(state, value)
            assert value == pytest.approx(expected, abs=1e-9)


def test_points_of_all_shapes():
    found = workspace(cr.planar_3r(1.0, 0.5, 0.25))
    assert found.contains(1.0, 0.0) is True
    assert found.contains(0.0, 0.0) is False
    grid = found.contains(np.linspace(-2, 2, 5)[:, None], np.linspace(-2, 2, 7)[None])
    assert grid.shape == (5, 7) and grid.dtype == bool
    assert found.contains([math.nan, math.inf, 1.0], 0.0).tolist() == [False, False, True]
    assert found.contains(1.0, 0.0, every_orientation=True) is True
    assert found.contains([0.5, 1.0, 1.5], 0.0, every_orientation=True).tolist() == [False, True, False]
    far = found.contains([1e300, -1e308, 1e160], [-1e300, 1e308, 0.0])
    assert not far.any() and found.orientations(1e300, -1e308) == ()
    assert found.contains([], []).shape == found.contains([], 1.0, every_orientation=True).shape == (0,)
    for x in ("a", "1", None, 1j, True, [[1], [1, 2]], [1, 2, 3]):
        y = [1.0, 2.0]
        with pytest.raises(cr.InputError, match="broadcast"):
            found.contains(x, y)
    for bad in (math.nan, math.inf, "1", None):
        with pytest.raises(cr.InputError, match="x"):
            found.orientations(bad, 0.0)


@pytest.mark.parametrize("limits", [None, (0.0, math.inf), (-math.inf, 1.0)])
def test_an_unlimited_slide_is_refused_with_the_reason(limits):
    arm = cr.planar("RPR", (1.0, 0.5, 0.2)).with_limits(position=[None, limits, None])
    with pytest.raises(cr.InputError, match=r"joint 2: .*unbounded; two finite position limits are accepted"):
        workspace(arm)


@pytest.mark.parametrize("name", ["panda", "orthogonal_3r_fig2a"])
def test_an_arm_in_space_is_refused(name):
    with pytest.raises(cr.InputError, match="planar arms only"):
        workspace(cr.load(name))


def test_one_joint_and_none_that_moves():
    one = limited("R", (2.0,), [(0.0, 1.5)])
    assert one.area == 0.0 and one.primary == ()
    assert one.contains([2.0, 0.0, -2.0], [0.0, 2.0, 0.0]).tolist() == [True, False, False]
    assert one.orientations(2.0 * math.cos(0.3), 2.0 * math.sin(0.3)) == (pytest.approx((0.3, 0.3)),)
    still = limited("RR", (1.0, 1.0), [(0.0, 0.0), (PI / 2, PI / 2)])
    assert still.contains([1.0, 1.1], [1.0, 1.0]).tolist() == [True, False]
    assert still.orientations(1.0, 1.0) == (pytest.approx((PI / 2, PI / 2)),)
    rail = limited("P", (0.5,), [(0.0, 1.0)], (0.3,))
    assert rail.orientations(math.cos(0.3), math.sin(0.3)) == (pytest.approx((0.3, 0.3)),)
    assert rail.orientations(0.0, 1.0) == ()


def test_arms_that_are_nearly_degenerate():
    """Lengths and limits that almost coincide: thin slivers, nearly concentric arcs, edges a hair apart."""
    rng = np.random.default_rng(13)
    for _ in range(60):
        arm = tidy_arm(rng, words(rng))
        error = 10.0 ** rng.uniform(-15, -4)
        geometry = arm.description.geometry
        lengths = np.array(geometry.lengths) + error * rng.normal(size=arm.n)
        limits = np.sort(arm.limits.position + error * rng.normal(size=(arm.n, 2)), axis=1)
        changed = cr.planar(arm.kinds, lengths, geometry.headings).with_limits(position=limits)
        region = workspace_region(changed)
        z, _ = tip(changed, samples(changed, rng, 300))
        # the last part of a cusp, thinner than rounding errors, may be cut off: a tip of 1e-5 is 1e-11 wide
        assert region.contains(z, 1e-5).all(), changed.description
