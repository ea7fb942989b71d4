"""Postures of 3R arms: each reaches its point, none is lost; an independent certified count of roots is the judge."""

from __future__ import annotations

from functools import reduce
from itertools import pairwise

import numpy as np
import pytest
from flint import fmpq, fmpq_poly

from chainrule.arm import Arm, planar_3r
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, Regional, evaluator
from chainrule.cuspidality.postures import number_of_postures, postures
from chainrule.errors import InputError
from chainrule.loading import load
from chainrule.readers import dh, families

RIGHT = np.pi / 2


def regional(alpha2, alpha3, d2, d3, d4, r2, r3=0.0, name="arm"):
    """An arm with offsets in every joint and a base of its own."""
    rows = [("R", 0.2, 0.1, 0.3, 0.1), ("R", alpha2, d2, r2, -0.4), ("R", alpha3, d3, 0.0, 0.3)]
    return Regional.of(dh.from_dh(rows, tool=(d4 * np.cos(0.7), d4 * np.sin(0.7), r3), name=name))


def orthogonal(d2, d3, d4, r2):
    return Regional.of(families.orthogonal_3r(d2, d3, d4, r2))


GENERIC = {
    "domain 2": orthogonal(1.0, 2.0, 1.5, 1.0),
    "domain 3": orthogonal(1.0, 2.0, 2.6, 1.0),
    "domain 4": orthogonal(1.0, 2.0, 4.0, 1.0),
    "domain 5": orthogonal(1.0, 0.5, 1.5, 0.4),
    "d3 = d2": orthogonal(1.0, 1.0, 1.5, 0.3),
    "d3 = d4": orthogonal(1.0, 1.5, 1.5, 0.3),
    "r2 = 0": orthogonal(1.0, 2.0, 1.5, 0.0),
    "any twists": regional(1.1, -0.7, 1.0, 2.0, 1.5, 0.4, 0.6),
    "more twists": regional(-2.0, 0.3, 0.6, 0.8, 1.1, -0.5, 0.9),
    "alpha2 right": regional(-RIGHT, 0.8, 0.7, 0.9, 0.8, 0.3, -0.2),
    "axes 2, 3 parallel": regional(1.1, 0.0, 1.0, 2.0, 1.5, 0.4, 0.6),
    "axes 2, 3 intersect": regional(1.1, 0.4, 1.0, 0.0, 1.5, 0.4, 0.6),
}


def reached(arm, q):
    """Where joint values (..., 3) lead, in the arm's own base frame, by rotations written out here."""
    theta1, theta2, theta3 = np.moveaxis(arm.to_normal(q), -1, 0)
    ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3 = arm.parameters
    point = [d4 * np.cos(theta3), d4 * np.sin(theta3), np.full(theta3.shape, r3)]
    for (c, s, d, r), theta in (((ca3, sa3, d3, r2), theta2), ((ca2, sa2, d2, 0.0), theta1)):
        x, y, z = point[0] + d, c * point[1] - s * point[2], s * point[1] + c * point[2]
        point = [np.cos(theta) * x - np.sin(theta) * y, np.sin(theta) * x + np.cos(theta) * y, z + r]
    return arm.point_from_normal(np.stack(point, axis=-1))


def test_the_points_are_those_of_the_arm():
    """The rotations above against the generated kinematics of the chain."""
    rows = [("R", 0.2, 0.1, 0.3, 0.1), ("R", 1.1, 0.5, 0.4, -0.4), ("R", -0.7, 0.8, 0.2, 0.3)]
    chain = Arm(dh.from_dh(rows, tool=(0.3, 0.2, 0.1), name="twisted"))
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (50, 3))
    assert np.abs(reached(Regional.of(chain), q) - chain.position(q)).max() < 1e-14


# ---- the judge ------------------------------------------------------------------------------------------------------


class Bounded:
    """Numbers with a bound of what rounding has made of them: every operation adds half a unit in the last place."""

    def __init__(self, value, error=0.0):
        self.value, self.error = value, error

    @staticmethod
    def of(other):
        return other if isinstance(other, Bounded) else Bounded(float(other))

    @staticmethod
    def rounded(value, error):
        return Bounded(value, 1.01 * (error + 2.0**-53 * np.abs(value)))

    def __add__(self, other):
        other = Bounded.of(other)
        return Bounded.rounded(self.value + other.value, self.error + other.error)

    def __sub__(self, other):
        return self + Bounded.of(other) * -1

    def __mul__(self, other):
        other = Bounded.of(other)
        error = np.abs(self.value) * other.error + np.abs(other.value) * self.error + self.error * other.error
        return Bounded.rounded(self.value * other.value, error)

    __rmul__, __radd__ = __mul__, __add__

    def sign(self):
        """-1 or 1, and 0 where rounding may decide."""
        return np.where(np.abs(self.value) > self.error, np.sign(self.value), 0).astype(int)


def total(*terms):
    return reduce(lambda a, b: a + b, terms)


def quartic(parameters, rho_squared, z):
    """Five coefficients, highest power first, by elimination of theta2 in the half tangent, for any kind of number.

    With t = tan(theta3 / 2): (1 + t^2) (R - F3) and (1 + t^2) (z - F4) are quadratic in t, (1 + t^2)^2 W quartic.
    """
    ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3 = parameters
    two, four = 2, 4
    far, near = d3 - d4, d3 + d4  # f1 at theta3 = pi and 0
    f1 = [far, near * 0, near]  # (1 + t^2) f1, highest power first
    low = -1 * (sa3 * r3)
    f2 = [low, two * (ca3 * d4), low]
    up = ca3 * r3
    f3 = [up, two * (sa3 * d4), up]

    def times(p, q):
        found = [None] * (len(p) + len(q) - 1)
        for i, a in enumerate(p):
            for j, b in enumerate(q):
                found[i + j] = a * b if found[i + j] is None else found[i + j] + a * b
        return found

    one = [1, 0, 1]
    radius = rho_squared + z * z
    # F3 (1 + t^2) without dividing: f1^2 + f2^2 + f3^2 = d3^2 + 2 d3 d4 c3 + d4^2 + r3^2
    base = d2 * d2 + d3 * d3 + d4 * d4 + r2 * r2 + r3 * r3
    cross = two * (d3 * d4)
    square = [base - cross, base * 0, base + cross]
    square = [s + two * (r2 * f) for s, f in zip(square, f3, strict=True)]
    u = [sa2 * (o * radius - s) for o, s in zip(one, square, strict=True)]
    v = [two * (d2 * (o * z - ca2 * (f + o * r2))) for o, f in zip(one, f3, strict=True)]
    w = [a + b for a, b in zip(times(f1, f1), times(f2, f2), strict=True)]
    turn = four * (d2 * d2 * (sa2 * sa2))
    return [a + b - turn * c for a, b, c in zip(times(u, u), times(v, v), w, strict=True)]


def judged(arm, points):
    """The number of distinct real roots for points (k, 3) of the normal form: by floats with a bound, else Sturm."""
    parameters = [Bounded(x, 2.0**-52 * abs(x)) for x in arm.parameters]  # as far as the exact ones may differ
    x, y, z = (Bounded(points[:, k]) for k in range(3))
    a, b, c, d, e = quartic(parameters, x * x + y * y, z)
    i = total(12 * (a * e), -3 * (b * d), c * c)
    j = total(72 * (a * (c * e)), 9 * (b * (c * d)), -27 * (a * (d * d)), -27 * (e * (b * b)), -2 * (c * (c * c)))
    discriminant = (4 * (i * (i * i)) - j * j).sign()
    p = (8 * (a * c) - 3 * (b * b)).sign()
    q = total(
        64 * (a * (a * (a * e))), -16 * (a * (a * (c * c))), 16 * (a * (b * (b * c))), -16 * (a * (a * (b * d))),
        -3 * (b * (b * (b * b))),
    ).sign()  # fmt: skip
    four, none = (p < 0) & (q < 0), (p > 0) | (q > 0)
    number = np.select([discriminant < 0, (discriminant > 0) & four, (discriminant > 0) & none], [2, 4, 0], -1)
    number[a.sign() == 0] = -1
    for k in np.flatnonzero(number < 0):
        x, y, z = map(exactly, points[k])
        number[k] = sturm(quartic(list(arm.rationals), x * x + y * y, z))
    return number


def exactly(x):
    return fmpq(*float(x).as_integer_ratio())


def sturm(coefficients):
    """Distinct real roots of a quartic of fractions in t, infinity counted, by the signs of its Sturm chain."""
    chain = [fmpq_poly(coefficients[::-1])]
    chain.append(chain[0].derivative())
    while chain[-1].degree() > 0:
        rest = -(chain[-2] % chain[-1])
        if rest.degree() < 0:
            break
        chain.append(rest)
    ends = []
    for at_minus in (True, False):
        signs = [(p[p.degree()] > 0) != (at_minus and p.degree() % 2 == 1) for p in chain if p.degree() >= 0]
        ends.append(sum(x != y for x, y in pairwise(signs)))
    return ends[0] - ends[1] + (chain[0].degree() < 4)


@pytest.mark.parametrize(
    ("coefficients", "number"),
    [([1, 0, -5, 0, 4], 4), ([1, 0, 0, 0, -1], 2), ([1, 0, 0, 0, 1], 0), ([1, -2, 1, 0, 0], 2), ([0, 1, 0, -1, 0], 4)],
)
def test_the_judge(coefficients, number):
    assert sturm([fmpq(c) for c in coefficients]) == number


# ---- none is lost ---------------------------------------------------------------------------------------------------


def random_q(count, seed):
    return np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 3))


def near_singular(arm, count, seed):
    """Configurations whose theta2 differs from a singular one by 1e-1 to 1e-16 rad."""
    rng = np.random.default_rng(seed)
    theta = arm.to_normal(random_q(3 * count, seed + 1))
    a, b, c = np.moveaxis(arm.determinant_terms(theta[:, 2]), -1, 0)
    size = np.hypot(a, b)
    there = np.flatnonzero(np.abs(c) < size)[:count]
    shift = rng.choice([-1.0, 1.0], there.size) * 10.0 ** rng.uniform(-16, -1, there.size)
    theta = theta[there]
    theta[:, 1] = np.arctan2(b, a)[there] + np.arccos(-c[there] / size[there]) + shift
    return arm.from_normal(theta)


def check(arm, points):
    """Every posture reaches its point, is in range and sorted, and there are as many as the judge says."""
    found = postures(arm, points)
    real = np.isfinite(found.q[..., 0])
    assert np.array_equal(real.sum(axis=-1), found.count)
    assert np.all(np.isfinite(found.q) == real[..., None])
    missed = np.sqrt(((reached(arm, found.q) - points[..., None, :]) ** 2).sum(axis=-1))
    assert missed[real].max(initial=0.0) <= 1e-12 * arm.size
    assert np.all((found.q[real] > -np.pi) & (found.q[real] <= np.pi))
    with np.errstate(invalid="ignore"):
        assert not np.any(np.diff(found.q[..., 2], axis=-1) < 0.0)
    number = judged(arm, arm.point_to_normal(points))
    wrong = np.flatnonzero(number != found.count)
    assert wrong.size == 0, (number[wrong][:5], found.count[wrong][:5], points[wrong][:5])
    return found


@pytest.mark.parametrize("name", GENERIC)
def test_none_is_lost(name):
    """84 000 random points for each arm, 10^6 in all."""
    arm = GENERIC[name]
    q = random_q(84_000, 1)
    found = check(arm, reached(arm, q))
    turned = np.abs(np.remainder(found.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=-1)
    assert np.nanmin(turned, axis=-1).max() < 1e-5  # the configuration that a point was made of is among them


@pytest.mark.parametrize("name", GENERIC)
def test_none_is_lost_next_to_singular_curves(name):
    """8 400 points for each arm, 10^5 in all, from 0.1 to 1e-16 rad away."""
    arm = GENERIC[name]
    found = check(arm, reached(arm, near_singular(arm, 8_400, 2)))
    assert found.decided > 1_000  # it is the doubtful ones that are tested


@pytest.mark.parametrize("name", GENERIC)
def test_counts_are_those_of_the_postures(name):
    arm = GENERIC[name]
    rng = np.random.default_rng(4)
    rho, z = rng.uniform(0, arm.size, 4000), rng.uniform(-arm.size, arm.size, 4000)
    expected = judged(arm, np.stack([rho, np.zeros(4000), z], axis=-1))
    assert np.array_equal(number_of_postures(arm, rho, z), expected)
    assert {0, 2} <= set(expected) or name == "axes 2, 3 parallel"


def test_near_a_cusp():
    """Around a target with a triple root the number changes between 2 and 4 and no posture is lost."""
    arm = GENERIC["domain 2"]
    lengths = np.array(arm.orthogonal)
    t = np.roots(evaluator("cusp_polynomial", ORTHOGONAL_3R)(lengths)[::-1])
    t = t[np.abs(t.imag) < 1e-9].real
    elbow = np.stack([(1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)], axis=-1)
    cusp = evaluator("triple_point", ORTHOGONAL_3R)(lengths, elbow)
    place = (cusp[:, :2] / cusp[:, 2:])[cusp[:, 1] > 0]
    rng = np.random.default_rng(5)
    for rho_squared, height in place:
        radius = 10.0 ** rng.uniform(-15, -1, (2000, 1))
        offsets = radius * rng.normal(size=(2000, 2))
        rho, z = np.sqrt(rho_squared) + offsets[:, 0], np.sqrt(height) + offsets[:, 1]
        found = check(arm, np.stack([rho, np.zeros(2000), z], axis=-1))
        assert {2, 4} <= set(found.count)


@pytest.mark.parametrize("scale", [1e-99, 1e-9, 1e9, 1e99])
def test_scale(scale):
    arm, large = GENERIC["domain 2"], orthogonal(*(scale * np.array([1.0, 2.0, 1.5, 1.0])))
    points = reached(arm, random_q(2000, 6))
    small, found = postures(arm, points), postures(large, scale * points)
    assert np.array_equal(small.count, found.count)
    assert np.nanmax(np.abs(small.q - found.q)) < 1e-6  # two that nearly meet are as near as doubles allow
    missed = np.sqrt(((reached(large, found.q) / scale - points[:, None]) ** 2).sum(axis=-1))
    assert np.nanmax(missed) < 1e-12 * arm.size


# ---- special places -------------------------------------------------------------------------------------------------


def test_theta3_at_pi():
    """tan(theta3 / 2) is infinite there; nothing is special about it."""
    for name, arm in GENERIC.items():
        if name == "d3 = d4":  # theta2 is free at pi
            continue
        theta = arm.to_normal(random_q(300, 7))
        theta[:, 2] = np.pi + np.random.default_rng(8).choice([0.0, 1e-16, -1e-12, 1e-8], 300)
        q = arm.from_normal(theta)
        found = check(arm, reached(arm, q))
        if name not in ("r2 = 0", "axes 2, 3 parallel"):  # E is even in theta3: a singular curve at pi
            turned = np.abs(np.remainder(found.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=-1)
            assert np.nanmin(turned, axis=-1).max() < 1e-5


def test_on_the_first_axis():
    """theta1 is free, and said to be: d2 = d3 = 3, d4 = 2, r2 = 0 reaches (0, 0, +-4) with cos theta2 = -3/5."""
    arm = orthogonal(3.0, 3.0, 2.0, 0.0)
    points = np.array([[0.0, 0.0, 4.0], [0.0, 0.0, -4.0], [1e-3, 0.0, 4.0], [0.0, 0.0, 40.0]])
    found = postures(arm, points)
    assert found.count[:2].tolist() == [1, 1] and found.count[3] == 0
    assert found.free.tolist() == [[True, False, False], [True, False, False], [False] * 3, [False] * 3]
    assert np.nanmax(np.abs(reached(arm, found.q) - points[:, None])) < 1e-14


@pytest.mark.parametrize("name", ["d3 = d2", "d3 = d4", "domain 4"])
def test_where_theta2_is_free(name):
    """f1 = 0: the point is on axis 2. It is one posture, with theta2 = 0 standing for all, next to the others."""
    arm = GENERIC[name]
    _, _, _, _, _, d3, d4, _, _ = arm.parameters
    theta3 = np.arccos(-d3 / d4)
    points = reached(arm, arm.from_normal(np.array([[0.4, theta2, theta3] for theta2 in (-2.0, 0.0, 1.0)])))
    assert np.abs(np.diff(points, axis=0)).max() < 1e-14
    found = postures(arm, points)
    assert found.free[:, 1].all() and not found.free[:, 2].any()
    theta = arm.to_normal(found.q)
    here = np.abs(np.abs(theta[..., 2]) - theta3) < 1e-9
    assert np.all(here.sum(axis=-1) >= 1)
    missed = np.sqrt(((reached(arm, found.q) - points[:, None]) ** 2).sum(axis=-1))
    assert np.nanmax(missed) < 1e-12 * arm.size
    others = postures(arm, points + np.array([0.0, 0.0, 1e-3]))
    assert not others.free.any()


def test_on_a_singular_curve():
    """Exactly on it a double root counts once: the stretched arm with r2 = 0 reaches (4.5, 0, 0) in one posture."""
    arm = orthogonal(1.0, 2.0, 1.5, 0.0)
    beyond, within = np.nextafter(4.5, 9), np.nextafter(4.5, 0)
    assert postures(arm, [[4.5, 0.0, 0.0], [beyond, 0.0, 0.0], [within, 0.0, 0.0]]).count.tolist() == [1, 0, 2]
    assert number_of_postures(arm, [4.5, beyond, within], 0.0).tolist() == [1, 0, 2]


# ---- arms that are not generic --------------------------------------------------------------------------------------

SPECIAL = {
    "axes 1, 2 intersect": regional(1.1, 0.4, 0.0, 2.0, 1.5, 0.4, 0.6),
    "axes 1, 2 parallel": regional(0.0, 0.4, 1.0, 2.0, 1.5, 0.4, 0.6),
    "d2 = 0, orthogonal": orthogonal(0.0, 2.0, 1.5, 1.0),
    "puma560": Regional.of(load("puma560"), tip=(0.0203, 0.1, 0.4318)),
}


@pytest.mark.parametrize("name", SPECIAL)
def test_closed_forms(name):
    """Every posture reaches its point; the configuration that made it is among them; there are 2 or 4."""
    arm = SPECIAL[name]
    q = random_q(5000, 9)
    points = reached(arm, q)
    found = postures(arm, points)
    missed = np.sqrt(((reached(arm, found.q) - points[:, None]) ** 2).sum(axis=-1))
    assert np.nanmax(missed) <= 1e-12 * arm.size
    turned = np.abs(np.remainder(found.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=-1)
    assert np.nanmin(turned, axis=-1).max() < 1e-5
    assert set(found.count) <= {2, 4} and not found.free.any()
    assert np.array_equal(np.isfinite(found.q[..., 0]).sum(axis=-1), found.count)
    assert postures(arm, [3.0 * arm.size, 0.0, 0.0]).count == 0


@pytest.mark.parametrize(
    ("name", "generic"),
    [
        ("axes 1, 2 intersect", regional(1.1, 0.4, 1e-6, 2.0, 1.5, 0.4, 0.6)),
        ("axes 1, 2 parallel", regional(1e-6, 0.4, 1.0, 2.0, 1.5, 0.4, 0.6)),
        ("d2 = 0, orthogonal", orthogonal(1e-6, 2.0, 1.5, 1.0)),
    ],
)
def test_closed_forms_lose_none(name, generic):
    """As many postures as the generic arm next to it, certified, except right beside a singular curve."""
    points = reached(SPECIAL[name], random_q(1000, 10))
    expected = judged(generic, generic.point_to_normal(points))
    assert (postures(SPECIAL[name], points).count != expected).sum() <= 5
    assert len(set(expected)) > 1


def test_puma_has_four_postures():
    found = postures(SPECIAL["puma560"], reached(SPECIAL["puma560"], random_q(1000, 11)))
    assert set(found.count) == {4}


@pytest.mark.parametrize(
    ("arm", "why"),
    [
        (regional(1.1, 0.4, 1.0, 0.5, 0.0, 0.4, 0.6), "the point lies on axis 3"),
        (regional(1.1, 0.4, 0.0, 0.5, 0.0, 0.4, 0.6), "the point lies on axis 3"),
        (regional(1.1, 0.0, 1.0, 0.0, 0.5, 0.4, 0.6), "axes 2 and 3 coincide"),
    ],
)
def test_where_theta3_is_free(arm, why):
    """One posture stands for all, at a point that the arm reaches; none at another."""
    assert why in arm.nongeneric
    points = reached(arm, random_q(50, 12))
    found = postures(arm, points)
    assert found.free[:, 2].all() and np.all(found.count >= 1)
    missed = np.sqrt(((reached(arm, found.q) - points[:, None]) ** 2).sum(axis=-1))
    assert np.nanmax(missed) <= 1e-12 * arm.size
    assert postures(arm, points * 1.1 + 0.05).count.max() == 0


def test_arms_without_an_answer():
    with pytest.raises(InputError, match="axes 1 and 2 coincide"):
        postures(regional(0.0, 0.4, 0.0, 2.0, 1.5, 0.4), [1.0, 0.0, 0.0])
    with pytest.raises(InputError, match="three axes are parallel"):
        number_of_postures(regional(0.0, 0.0, 1.0, 2.0, 1.5, 0.4), 1.0, 0.0)


# ---- input ----------------------------------------------------------------------------------------------------------


def test_shapes():
    arm = GENERIC["any twists"]
    points = reached(arm, random_q(6, 13)).reshape(2, 3, 3)
    found = postures(arm, points)
    assert found.q.shape == (2, 3, 4, 3) and found.count.shape == (2, 3) and found.free.shape == (2, 3, 3)
    one = postures(arm, points[1, 2].tolist())
    assert one.q.shape == (4, 3)  # a compiler may contract the lone configuration's operations otherwise
    np.testing.assert_allclose(one.q, found.q[1, 2], rtol=0, atol=2e-15)
    empty = postures(arm, np.empty((0, 5, 3)))
    assert empty.q.shape == (0, 5, 4, 3) and empty.count.shape == (0, 5)
    assert number_of_postures(arm, np.ones((3, 1)), np.zeros(4)).shape == (3, 4)
    assert number_of_postures(arm, np.empty(0), 1.0).shape == (0,)
    single = postures(arm, points.astype(np.float32))
    assert np.array_equal(single.count, postures(arm, points.astype(np.float32).astype(float)).count)
    assert set(found.to_dict()) == {"q", "count", "free", "decided"}


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ([np.nan, 0, 0], r"points\[0\]: nan"),
        ([[0, 0, 0], [0, np.inf, 0]], r"points\[1, 1\]: inf"),
        ([1.0, 2.0], r"shape \(2,\); \(\.\.\., 3\) is accepted"),
        (1.0, r"shape \(\)"),
        (["1", "2", "3"], "points"),
        ([[1, 2, 3], [1, 2]], "ragged"),
        ([1j, 0, 0], "points"),
    ],
)
def test_what_is_refused(points, message):
    with pytest.raises(InputError, match=message):
        postures(GENERIC["domain 2"], points)


def test_what_counts_refuse():
    arm = GENERIC["domain 2"]
    with pytest.raises(InputError, match="rho: nan"):
        number_of_postures(arm, np.nan, 0.0)
    with pytest.raises(InputError, match="do not broadcast"):
        number_of_postures(arm, np.ones(2), np.ones(3))


@pytest.mark.parametrize("far", [1e10, 1e100, 1e308])
def test_far_away(far):
    assert postures(GENERIC["domain 2"], [far, far / 2, -far / 2]).count == 0
    assert number_of_postures(GENERIC["domain 2"], far, 0.0) == 0


@pytest.mark.parametrize("tip", [None, (0.1, 0.2, 0.3)])
def test_normal_form_of_six_joints(tip):
    six = load("puma560")
    if tip is None:
        with pytest.raises(InputError, match="6 joints; name the point of link 3"):
            Regional.of(six)
    else:
        assert Regional.of(six, tip=tip).parameters[6] == pytest.approx(np.hypot(0.1, 0.3), abs=0.5)


def test_what_the_normal_form_refuses():
    for wrong, message in ((planar_3r(1, 2, 3), "planar"), (load("sanchez_8r"), "8 joints")):
        with pytest.raises(InputError, match=message):
            Regional.of(wrong)
    with pytest.raises(InputError, match="three revolute"):
        Regional.of(dh.from_dh([("R", 0, 1, 0, 0), ("P", 0, 1, 0, 0), ("R", 0, 1, 0, 0)]))
    with pytest.raises(InputError, match="tip: an array of shape"):
        Regional.of(load("puma560"), tip=(1.0, 2.0))
