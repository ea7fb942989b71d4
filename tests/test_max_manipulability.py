"""The certified maximum of manipulability: paper values, closed forms, grids, and an independent algebraic solution."""

import json
import math

import flint
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

import chainrule as cr
from chainrule.balls import above, below, exact, minors_on_balls, nearest
from chainrule.branch_and_bound import Domain, Hunt, Peak, _Boxes, _inside_any, neighbourhood, positive_definite
from chainrule.certificate import certify, crude_bound, used_joints
from chainrule.errors import InputError
from chainrule.manipulability import manipulability_map, max_manipulability
from chainrule.plot.maps import draw_map, draw_optima
from chainrule.waves import spectra, square, unit_of, waves


def planar_squared(lengths, q2, q3):
    """De Luca, equation (1), squared."""
    l1, l2, l3 = lengths
    s2, s3, s23 = np.sin(q2), np.sin(q3), np.sin(q2 + q3)
    return (l1 * (l2 * s2 + l3 * s23)) ** 2 + (l3 * (l1 * s23 + l2 * s3)) ** 2 + (l2 * l3 * s3) ** 2


def dense_maximum(function, ranges, size=241, zooms=26):
    """The largest value over a rectangle: a grid, and finer grids about its best twelve points."""
    axes = [np.linspace(low, high, size) for low, high in ranges]
    values = function(*np.meshgrid(*axes, indexing="ij"))
    best = -math.inf
    for flat in np.argsort(-values, axis=None)[:12]:
        point = np.array([axis[k] for axis, k in zip(axes, np.unravel_index(flat, values.shape), strict=True)])
        width = np.array([(high - low) / (size - 1) for low, high in ranges])
        for _ in range(zooms):
            local = [
                np.clip(np.linspace(p - w, p + w, 9), low, high)
                for p, w, (low, high) in zip(point, width, ranges, strict=True)
            ]
            here = function(*np.meshgrid(*local, indexing="ij"))
            k = np.unravel_index(int(here.argmax()), here.shape)
            point, width = np.array([axis[i] for axis, i in zip(local, k, strict=True)]), width / 2
            best = max(best, float(here[k]))
    return best


def test_the_paper():
    best = max_manipulability(cr.load("planar_3r"))
    assert best.value == pytest.approx(0.7955370838, abs=5e-11)
    np.testing.assert_allclose(best.q, [0.0, 1.4702184, 0.2473498], atol=5e-8)
    np.testing.assert_allclose(best.others, [[0.0, -1.4702184, -0.2473498]], atol=5e-8)
    assert best.proved
    assert best.complete
    assert best.value <= best.bound <= best.value * (1 + 1e-14)
    value, q = best
    assert value == best.value
    assert q is best.q
    assert json.loads(json.dumps(best.to_dict()))["proved"] is True


@pytest.mark.parametrize("seed", range(12))
def test_random_lengths_against_grids(seed):
    lengths = 10.0 ** np.random.default_rng(seed).uniform(-1.5, 1.5, 3)
    best = max_manipulability(cr.planar_3r(*lengths))
    dense = math.sqrt(dense_maximum(lambda a, b: planar_squared(lengths, a, b), [(-np.pi, np.pi)] * 2))
    assert best.proved
    assert best.value * (1 - 1e-10) <= dense <= best.bound * (1 + 1e-14)
    assert math.sqrt(planar_squared(lengths, *best.q[1:])) == pytest.approx(best.value, rel=1e-14)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.floats(-1e3, 1e3).map(lambda x: x if abs(x) > 1e-9 else 0.0), min_size=3, max_size=3))
def test_any_lengths(lengths):
    best = max_manipulability(cr.planar_3r(*lengths))
    assert best.proved
    assert np.isfinite(best.q).all()
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (2000, 2))
    assert np.sqrt(planar_squared(lengths, *q.T)).max() <= best.bound * (1 + 1e-13)
    if best.value > 1e-150:
        assert math.sqrt(planar_squared(lengths, *best.q[1:])) == pytest.approx(best.value, rel=1e-9)


@pytest.mark.parametrize(
    ("lengths", "expected"),
    [
        ((0.0, 0.7, 0.4), math.sqrt(2) * 0.7 * 0.4),  # J's first two columns are equal: sqrt(2) l2 l3 |s3|
        ((0.9, 0.0, 0.4), math.sqrt(2) * 0.9 * 0.4),  # the last but one and the second: sqrt(2) l1 l3 |s23|
        ((0.9, 0.7, 0.0), 0.9 * 0.7),  # the last column vanishes: l1 l2 |s2|
        ((0.0, 0.0, 2.0), 0.0),
        ((0.0, 0.0, 0.0), 0.0),
    ],
)
def test_zero_lengths(lengths, expected):
    best = max_manipulability(cr.planar_3r(*lengths))
    assert best.proved
    assert best.value == pytest.approx(expected, rel=1e-15)
    assert best.bound == pytest.approx(expected, rel=1e-14, abs=1e-300)


def test_a_ridge_between_limits():
    # l2 = 0: H = sqrt(2) l1 l3 |sin(q2 + q3)| is largest along a line, which the limits cut.
    arm = cr.planar_3r(1.0, 0.0, 0.5).with_limits(position=[None, (-1.0, 1.0), (-2.0, 2.0)])
    best = max_manipulability(arm)
    assert best.proved
    assert not best.complete
    assert best.value == pytest.approx(math.sqrt(2) * 0.5, rel=1e-14)


@pytest.mark.parametrize(
    "lengths",
    [(1, 1e-6, 1e3), (1e-6, 1, 1e3), (1e3, 1, 1e-6), (1, 1e-9, 1), (1, 1e-150, 1), (1e-150, 1, 1), (3, 3e-3, 3)],
)
def test_extreme_ratios(lengths):
    best = max_manipulability(cr.planar_3r(*lengths))
    assert best.proved
    # The largest H for q2 + q3 and q3 chosen one after the other, at 40 digits: an upper and a lower estimate.
    found = math.sqrt(dense_maximum(lambda a, b: planar_squared(lengths, a, b - a), [(-np.pi, np.pi)] * 2))
    assert found == pytest.approx(best.value, rel=1e-10)


def test_lengths_beyond_the_squares_of_doubles():
    one = max_manipulability(cr.planar_3r(1.0, 1.0, 1.0))
    large, small = (max_manipulability(cr.planar_3r(*[10.0**e] * 3)) for e in (37, -100))
    assert large.value == pytest.approx(one.value * 1e74, rel=1e-12)
    assert small.value == pytest.approx(one.value * 1e-200, rel=1e-12)
    assert max_manipulability(cr.planar_3r(*[1e-200] * 3)).value == 0.0


def test_scaling():
    small, large = (max_manipulability(cr.planar_3r(*(c * np.array([1.0, 0.5, 0.25])))) for c in (1.0, 7.3))
    assert large.value == pytest.approx(7.3**2 * small.value, rel=1e-14)
    np.testing.assert_allclose(large.q, small.q, atol=1e-9)


def test_equal_lengths_have_one_posture():
    postures = [max_manipulability(cr.planar_3r(size, size, size)).q for size in (0.1, 1.0, 42.0)]
    np.testing.assert_allclose(postures, [postures[0]] * 3, atol=1e-9)


@pytest.mark.parametrize("lengths", [("1", "1/2", "1/4"), ("2/5", "7/20", "1/4"), ("3", "1", "2"), ("1", "1", "1")])
def test_against_the_polynomial_system(lengths):
    """Critical points of H^2 by half-angle tangents and a resultant, with exact rationals: an independent way.

    t = tan(q2 / 2), u = tan(q3 / 2): the two derivatives are polynomials; the real roots t of their resultant, and for
    each the real roots u of one of them, hold every critical point (a half turn of q2 or q3 is tried apart).
    """
    t, u = sp.symbols("t u")
    l1, l2, l3 = (sp.Rational(text) for text in lengths)

    def turned(x):
        return 2 * x / (1 + x**2), (1 - x**2) / (1 + x**2)

    (s2, c2), (s3, c3) = turned(t), turned(u)
    s23, c23 = s2 * c3 + c2 * s3, c2 * c3 - s2 * s3
    m = (l1 * (l2 * s2 + l3 * s23), l3 * (l1 * s23 + l2 * s3), l2 * l3 * s3)
    by_q2 = m[0] * l1 * (l2 * c2 + l3 * c23) + m[1] * l3 * l1 * c23
    by_q3 = m[0] * l1 * l3 * c23 + m[1] * l3 * (l1 * c23 + l2 * c3) + m[2] * l2 * l3 * c3
    first, second = (sp.Poly(sp.fraction(sp.together(e))[0], u, t) for e in (by_q2, by_q3))
    common = first.resultant(second).as_poly(t)  # u is eliminated
    assert common.degree() > 0
    exact_polynomial = flint.fmpq_poly(
        [flint.fmpq(int(sp.Rational(c).p), int(sp.Rational(c).q)) for c in reversed(common.all_coeffs())]
    )
    numerator = exact_polynomial.numer()
    roots = [root for root, _ in numerator.complex_roots() if root.imag.contains(0)]
    angles = [2 * math.atan(float(root.real.mid())) for root in roots] + [math.pi]
    sizes = tuple(float(size) for size in (l1, l2, l3))
    heights = []
    for angle in angles:  # for one q2, S is a trigonometric polynomial of q3: its largest value by fine sampling
        q3 = np.linspace(-np.pi, np.pi, 4001)
        start = float(q3[planar_squared(sizes, angle, q3).argmax()])
        around = dense_maximum(lambda b, a=angle: planar_squared(sizes, a, b), [(start - 0.01, start + 0.01)], 41)
        heights.append(around)
    best = max_manipulability(cr.planar_3r(*sizes))
    assert math.sqrt(max(heights)) == pytest.approx(best.value, rel=1e-12)
    assert min(abs(a - best.q[1]) for a in angles) < 1e-7


def test_limits():
    lengths, rng = (1.0, 0.5, 0.25), np.random.default_rng(4)
    for _ in range(12):
        ends = np.sort(rng.uniform(-np.pi, np.pi, (2, 2)), axis=1)
        arm = cr.planar_3r(*lengths).with_limits(position=[None, *map(tuple, ends)])
        best = max_manipulability(arm)
        dense = math.sqrt(dense_maximum(lambda a, b: planar_squared(lengths, a, b), ends))
        assert best.proved
        assert best.value * (1 - 1e-10) <= dense <= best.bound * (1 + 1e-14)
        assert all((ends[:, 0] <= q[1:]).all() and (q[1:] <= ends[:, 1]).all() for q in [best.q, *best.others])


def test_limits_of_a_point_of_a_turn_and_of_more():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    point = max_manipulability(arm.with_limits(position=[None, (0.3, 0.3), (-0.2, -0.2)]))
    assert point.value == pytest.approx(math.sqrt(planar_squared((1.0, 0.5, 0.25), 0.3, -0.2)), rel=1e-14)
    assert point.proved
    free, far = (
        max_manipulability(arm),
        max_manipulability(arm.with_limits(position=[None, (0.0, 7.0), (100.0, 107.0)])),
    )
    assert far.value == pytest.approx(free.value, rel=1e-13)
    assert far.proved
    assert 0.0 <= far.q[1] <= 7.0
    assert 100.0 <= far.q[2] <= 107.0


@pytest.mark.parametrize(
    ("lengths", "ends"),
    [
        ((0.963, -1.179, 1.315), [(-0.049, -0.049), (-0.945, 0.945)]),
        ((1.418, -0.615, 1.555), [(1.8996, 1.9), (-2.519, -1.36)]),
        ((-0.762, -0.522, 0.967), [(11.247, 14.174), (12.5634, 12.5638)]),
        ((0.023, 28.629, 3.364), [(-15.708, -15.708), (-16.262, -15.154)]),
    ],
)
def test_a_corner_is_judged_by_itself(lengths, ends):
    """Narrow ranges: S falls away from several corners; the height of a face is not that of the box it ends."""
    best = max_manipulability(cr.planar_3r(*lengths).with_limits(position=[None, *ends]))
    dense = math.sqrt(dense_maximum(lambda a, b: planar_squared(lengths, a, b), ends))
    assert best.proved
    assert best.value * (1 - 1e-10) <= dense <= best.bound * (1 + 1e-14)


def test_joints_that_are_held_are_numbers():
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(0.0, 0.0)] * 3)
    best = max_manipulability(arm)  # stretched: singular
    assert (best.value, best.bound, best.proved) == (0.0, 0.0, True)
    held = cr.planar("RPR", [1.0, 0.5, 0.25]).with_limits(position=[None, (0.3, 0.3), None])
    best = max_manipulability(held)
    assert best.proved
    q = np.random.default_rng(7).uniform(-np.pi, np.pi, (20_000, 3))
    q[:, 1] = 0.3
    some = held.manipulability(q)
    assert 0.999 * best.value < some.max() <= best.bound


def test_a_box_that_ends_at_a_neighbourhoods_edge_is_not_inside_it():
    """To rounding: what is compared are differences of coordinates of size 100."""
    domain = Domain(np.array([90.0]), np.array([110.0]), np.array([False]))
    hunt = Hunt(None, domain, lambda x: None, [Peak(np.array([100.0]), None, np.array([1e-7]), None)])
    edge = 100.0 + 1e-7
    boxes = _Boxes(np.array([[100.0], [100.0]]), np.array([[edge], [100.0 + 9e-8]]), np.zeros(2))
    assert _inside_any(hunt, boxes).tolist() == [False, True]


PLANAR = ["RRP", "RPR", "PRR", "PPR", "PRP", "RPP", "PPP"]


@pytest.mark.parametrize("kinds", PLANAR)
@pytest.mark.parametrize("task", ["position", "x_alpha", "pose"])
def test_other_planar_arms(kinds, task):
    rng = np.random.default_rng(len(kinds) + PLANAR.index(kinds))
    headings = [float(rng.uniform(-2, 2)) if kind == "P" else 0.0 for kind in kinds]
    arm = cr.planar(kinds, rng.uniform(0.2, 1.0, 3).tolist(), headings)
    arm = arm.with_limits(position=[(-0.4, 0.9) if kind == "P" else None for kind in kinds])
    best = max_manipulability(arm, task)
    assert best.proved
    q = rng.uniform(-np.pi, np.pi, (60_000, 3))
    for j, kind in enumerate(kinds):
        if kind == "P":
            q[:, j] = rng.uniform(-0.4, 0.9, len(q))
    some = arm.manipulability(q, task=task)
    assert some.max() <= best.bound * (1 + 1e-13)
    assert some.max() >= 0.98 * best.value
    assert float(arm.manipulability(best.q, task=task)) == pytest.approx(best.value, rel=1e-12, abs=1e-14)


def test_pose_of_a_planar_3r_by_hand():
    best = max_manipulability(cr.planar_3r(1.0, 0.5, 0.25), "pose")  # |det J| = l1 l2 |s2|
    assert best.value == 0.5
    assert best.proved


def test_unlimited_slides_have_no_maximum():
    best = max_manipulability(cr.planar("RPR", [1.0, 0.5, 0.25]))
    assert math.isinf(best.value)
    assert "q2" in best.how
    assert best.to_dict()["H"] is None
    # H of PRR does not depend on its slide, although the code reads it.
    assert max_manipulability(cr.planar("PRR", [1.0, 0.5, 0.25])).value == pytest.approx(math.hypot(0.75, 0.25))


@pytest.mark.parametrize("name", ["orthogonal_3r_fig2a", "orthogonal_3r_fig2b"])
def test_orthogonal_arms(name):
    arm = cr.load(name)
    best = max_manipulability(arm)

    def squared(a, b):
        return arm.manipulability(np.stack([np.zeros_like(a), a, b], axis=-1)) ** 2

    dense = math.sqrt(dense_maximum(squared, [(-np.pi, np.pi)] * 2))
    assert best.proved
    assert best.value * (1 - 1e-10) <= dense <= best.bound * (1 + 1e-13)


def test_arms_in_space():
    arm = cr.load("puma560")
    best = max_manipulability(arm)
    assert best.proved
    some = arm.manipulability(np.random.default_rng(2).uniform(-np.pi, np.pi, (100_000, 6)))
    assert 0.8 * best.value < some.max() <= best.bound
    assert float(arm.manipulability(best.q)) == pytest.approx(best.value, rel=1e-12)


def test_a_budget_of_one_box_gives_a_valid_bound():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    best = max_manipulability(arm, budget=1)
    assert not best.proved
    assert not best.complete
    assert 0.7955370837652547 <= best.bound <= 1.84375 * (1 + 1e-9)  # from the traces, by hand
    bounds = [max_manipulability(cr.load("ur5e"), budget=budget) for budget in (1, 3000)]
    assert not any(b.proved for b in bounds)
    assert bounds[1].value <= bounds[1].bound <= bounds[0].bound


def test_searched_arms_have_a_certain_bound():
    arm = cr.load("sanchez_8r")
    best = max_manipulability(arm)
    assert not best.proved
    assert "search" in best.how
    some = arm.manipulability(np.random.default_rng(3).uniform(-np.pi, np.pi, (50_000, 8)))
    assert some.max() <= best.value <= best.bound


@pytest.mark.parametrize(
    "name", ["panda", "ur5e", "jaco2", "sanchez_8r", "orthogonal_3r_fig2b", "lenarcic_3r", "puma560"]
)
def test_the_bound_from_the_lengths(name):
    arm = cr.load(name)
    q = np.random.default_rng(6).uniform(-np.pi, np.pi, (5_000, arm.n))  # the bound needs no limits
    for task in arm.full_rank_tasks:
        assert arm.manipulability(q, task=task).max() <= crude_bound(arm, task)


@pytest.mark.parametrize(
    ("name", "task"), [("planar_3r", "position"), ("ur5e", "pose"), ("puma560", "position"), ("panda", "pose")]
)
def test_balls_hold_the_true_value(name, task):
    arm = cr.load(name)
    minors = minors_on_balls(arm, task)
    rng = np.random.default_rng(0)
    with flint.ctx.workprec(60):
        for _ in range(5):
            q = rng.uniform(-3, 3, arm.n)
            wide = np.array([flint.arb(float(v), 1e-9) for v in q])
            enclosed, narrow = minors(wide[None, :])[0], minors(exact(q)[None, :])[0]
            inside = arm.minors(q + rng.uniform(-1e-9, 1e-9, arm.n), task=task)
            for ball, value, point in zip(enclosed, inside, narrow, strict=True):
                assert below(ball) - 1e-14 <= value <= above(ball) + 1e-14
                assert ball.contains(point)


def test_balls_hold_the_value_at_forty_digits():
    mp.dps = 40
    arm, q = cr.planar_3r(1.0, 0.5, 0.25), [0.1, 1.3, -0.7]
    a, b = mpf(q[1]), mpf(q[2])
    expected = [
        mp.sin(a) / 2 + mp.sin(a + b) / 4,
        (mp.sin(a + b) + mp.sin(b) / 2) / 4,
        mp.sin(b) / 8,
    ]
    with flint.ctx.workprec(256):
        for ball, value in zip(minors_on_balls(arm, "position")(exact(q)[None, :])[0], expected, strict=True):
            assert abs(ball - flint.arb(str(value))) < flint.arb("1e-38")


@pytest.mark.parametrize(
    ("name", "task", "degree"),
    [("planar_3r", "position", 1), ("planar_3r", "x_alpha", 1), ("ur5e", "pose", 2), ("puma560", "position", 2)],
)
def test_the_waves_are_the_square_of_manipulability(name, task, degree):
    """Also at points that were not sampled: the minors have no higher degree than claimed."""
    arm = cr.load(name)
    with flint.ctx.workprec(256):
        minors = minors_on_balls(arm, task)
        joints = used_joints(minors, arm.n)
        part = square(spectra(minors, exact(np.zeros(arm.n)), joints, degree))
        found = waves(part, len(joints), unit_of([part]), 4.0, headings=False)
        scale = nearest(found.scale)
    kept = [int(np.flatnonzero(row)[0]) for row in found.back]
    q = np.random.default_rng(9).uniform(-np.pi, np.pi, (500, arm.n))
    height = found.expanded(q[:, [joints[k] for k in kept]])[0] * scale
    np.testing.assert_allclose(height, arm.manipulability(q, task=task) ** 2, atol=1e-12 * scale)
    x = q[:1, [joints[k] for k in kept]]
    _, gradient, hessian = found.expanded(x)
    for i in range(found.size):  # derivatives against differences
        step = 1e-5 * np.eye(found.size)[i]
        ahead, behind = found.expanded(x + step), found.expanded(x - step)
        assert gradient[0, i] == pytest.approx(float(ahead[0][0] - behind[0][0]) / 2e-5, abs=1e-8)
        np.testing.assert_allclose(hessian[0, i], (ahead[1][0] - behind[1][0]) / 2e-5, atol=1e-8)


def test_a_neighbourhood_is_not_proved_at_a_saddle():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    with flint.ctx.workprec(256):
        minors = minors_on_balls(arm, "position")
        part = square(spectra(minors, exact(np.zeros(3)), (1, 2), 1))
        found = waves(part, 2, unit_of([part]), 4.0, headings=False)
        domain = Domain(np.full(2, -4.0), np.full(2, 4.0), np.array([True, True]))
        around, _ = neighbourhood(found, domain, np.array([0.0, 0.0]), flint.arb(0))  # singular: a minimum
        assert around is None
        best = max_manipulability(arm).q[1:]
        around, _ = neighbourhood(found, domain, best, flint.arb(0))
    assert around is not None
    assert (around > 0.01).all()
    q = best + around * np.random.default_rng(0).uniform(-1, 1, (2000, 2))
    assert np.linalg.eigvalsh(found.expanded(q)[2]).max() < 0.0


def test_positive_definite():
    assert positive_definite(np.array([[2.0, -1.0], [-1.0, 2.0]]))
    assert not positive_definite(np.array([[1.0, 1.0], [1.0, 1.0]]))  # singular
    assert not positive_definite(np.array([[1.0, 2.0], [2.0, 1.0]]))


def test_the_certificate_counts_what_it_found():
    found = certify(cr.load("puma560"), "pose")
    assert found.complete
    # Shoulder left or right, elbow up or down, wrist flipped or not: eight postures.
    assert len(found.postures) == 8


def test_longer_planar_arms():
    arm = cr.planar("RRRR", [1.0, 0.5, 0.25, 0.3])
    best = max_manipulability(arm)
    assert best.proved
    some = arm.manipulability(np.random.default_rng(5).uniform(-np.pi, np.pi, (200_000, 4)))
    assert 0.99 * best.value < some.max() <= best.bound


def test_refusals():
    with pytest.raises(InputError, match="no manipulability of a task"):
        max_manipulability(cr.planar("RP", [1.0, 1.0]), "pose")
    with pytest.raises(InputError, match="larger than any double"):
        max_manipulability(cr.planar_3r(1e200, 1e200, 1e200))


@pytest.mark.parametrize("budget", [0, -3, 10.5, math.nan, "10", True])
def test_a_budget_is_a_whole_number(budget):
    with pytest.raises(InputError, match=r"budget: .*; a whole number, 1 or more, is accepted"):
        max_manipulability(cr.planar_3r(1.0, 0.5, 0.25), budget=budget)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"q": [0.0, math.nan, 0.0]}, r"q\[1\]: nan"),
        ({"q": [0.0, 1.0]}, r"q has shape \(2,\)"),
        ({"size": 1}, "size: 1; a whole number, 2 or more"),
        ({"size": 10.5}, "size: 10.5"),
        ({"joints": (1, 1)}, "two different ones of 0 to 2"),
        ({"joints": (0, 3)}, "two different ones of 0 to 2"),
        ({"joints": (0.0, 1.0)}, "two different ones of 0 to 2"),
        ({"joints": 1}, "two different ones of 0 to 2"),
    ],
)
def test_maps_refuse_bad_input(given, message):
    with pytest.raises(InputError, match=message):
        manipulability_map(cr.planar_3r(1.0, 0.5, 0.25), **given)


def test_map_and_figures():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    found = manipulability_map(arm, size=61)
    assert found.largest is not None
    assert found.largest.proved
    assert found.maximum.value == found.largest.value
    pairs = {tuple(np.round(np.abs(q[1:]), 6)) for q in found.singular}
    assert pairs == {(a, b) for a in (0.0, 3.141593) for b in (0.0, 3.141593)}
    assert draw_map(arm, found).axes
    assert "global maximum" in draw_optima(arm, found.largest).axes[0].get_title(loc="left")
    with pytest.raises(InputError, match="in space"):
        draw_optima(cr.load("puma560"), found.largest)
    held = manipulability_map(cr.load("panda"), q=np.zeros(7) + 0.3, size=9)
    assert held.largest is None


def test_the_command(capsys, tmp_path):
    import chainrule.commands.manipulability  # noqa: F401  adds the command
    from chainrule.cli import run

    figure = tmp_path / "map.svg"
    assert run(["manipulability", "planar_3r", "--figure", str(figure), "--postures", str(tmp_path / "two.png")]) == 0
    assert "proved to be the global maximum" in capsys.readouterr().out
    assert figure.read_text("utf-8").startswith("<?xml")
    assert run(["manipulability", "planar_3r", "--task", "pose", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["H"] == 0.5
    assert run(["manipulability", "planar_3r", "--task", "other"]) == 2
