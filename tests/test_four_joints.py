"""Four joints: every solution meets its conditions by an independent derivative, and none is missed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import chainrule as cr
from chainrule import four_joints as fj
from chainrule.derive import catalogue, speed_ratio_4
from chainrule.derive.speed_ratio import TANGENT
from chainrule.errors import InputError
from chainrule.four_joints import FourJointRatios, speed_ratios_4, speed_ratios_4_each

KINDS = ("RRRR", "RPRR")
ARMS = {
    kinds: cr.planar(kinds, [1.0, 0.8, 0.6, 0.4], [0.3 * (i + 1) * (k == "P") for i, k in enumerate(kinds)])
    for kinds in (*KINDS, "RPPP", "PPPP")
}


def random_cases(kinds: str, count: int, seed: int) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(seed)
    q = rng.uniform(-np.pi, np.pi, (count, 4)) * [1.0 if kind == "R" else 0.4 for kind in kinds]
    return q, rng.normal(size=(count, 2)), rng.normal(size=count), rng.normal(size=count)


def tip_path(arm: cr.Arm, q: Any, rates: Any, digits: int = 50) -> list[Any]:
    """Velocity, speed, curvature and dk/ds at constant rates: differences of the tip at 50 digits."""
    with mpmath.workdps(digits):
        start, slope = ([mpmath.mpf(float(v)) for v in row] for row in (q, rates))

        shape = arm.description.geometry
        links = list(zip(arm.kinds, shape.lengths, shape.headings, start, slope, strict=True))

        def tip(t: Any) -> Any:
            heading, place = mpmath.mpc(1), mpmath.mpc(0)
            for kind, length, turn, a, b in links:
                move = a + b * t
                heading *= mpmath.expj(move if kind == "R" else turn)
                place += (length if kind == "R" else length + move) * heading
            return place

        h = mpmath.mpf(10) ** -10
        samples = [tip(k * h) for k in range(-3, 4)]
        at = [[z.real for z in samples], [z.imag for z in samples]]
        # central differences of order h^4 and better
        d1 = [(-f[0] + 9 * f[1] - 45 * f[2] + 45 * f[4] - 9 * f[5] + f[6]) / (60 * h) for f in at]
        weights = [mpmath.mpf(w) / 180 for w in (2, -27, 270, -490, 270, -27, 2)]
        d2 = [sum(w * v for w, v in zip(weights, f, strict=True)) / h**2 for f in at]
        d3 = [(f[0] / 8 - f[1] + 13 * f[2] / 8 - 13 * f[4] / 8 + f[5] - f[6] / 8) / h**3 for f in at]

        def cross(a: Any, b: Any) -> Any:
            return a[0] * b[1] - a[1] * b[0]

        speed = mpmath.sqrt(d1[0] ** 2 + d1[1] ** 2)
        turn = cross(d1, d2)
        curvature = turn / speed**3
        rate = (cross(d1, d3) / speed**3 - 3 * turn * (d1[0] * d2[0] + d1[1] * d2[1]) / speed**5) / speed
        return [d1, speed, curvature, rate]


@pytest.mark.parametrize("kinds", KINDS)
def test_solutions_meet_the_conditions(kinds: str) -> None:
    """Tangent, curvature and rate by differences of an independent pose at 50 digits."""
    arm = ARMS[kinds]
    q, tangents, curvatures, rates = random_cases(kinds, 10, 1)
    met = 0
    for k, found in enumerate(speed_ratios_4_each(arm, q, tangents, curvatures, rates)):
        unit = tangents[k] / np.linalg.norm(tangents[k])
        assert found.certified
        for x, path in zip(found.rates, found.path, strict=True):
            # what rounding the rates to doubles does to the path: a wrong direction, times the higher derivatives
            size = float(np.abs(x).max()) + 1.0
            bent, changed = 1e-13 * size**3, 1e-11 * size**4
            velocity, speed, curvature, change = tip_path(arm, q[k], x)
            assert abs(float(velocity[0] * unit[1] - velocity[1] * unit[0])) < 1e-13 * size
            assert abs(float(speed) - 1.0) < 1e-13 * size
            assert abs(float(curvature) - path[1]) < bent
            assert abs(float(change) - path[2]) < changed
            if found.status != "nearest curvature":
                assert abs(float(curvature) - curvatures[k]) < bent
            if found.status == "exact":
                assert abs(float(change) - rates[k]) < changed
                met += 1
    assert met >= 8


def newton(conic: np.ndarray, cubic: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Zeros reached from many starts (s, 2) at once, those that converged."""
    x, y = starts.T
    for _ in range(60):
        with np.errstate(all="ignore"):
            (px, py), values, slopes = ([np.ones_like(v), v, v * v, v * v * v] for v in (x, y)), [], []
            for c in (conic, cubic):
                terms = list(zip(c, fj.CUBIC, strict=False))
                values.append(sum(a * px[i] * py[j] for a, (i, j) in terms))
                slopes.append(
                    (
                        sum(a * i * px[i - 1] * py[j] for a, (i, j) in terms if i),
                        sum(a * j * px[i] * py[j - 1] for a, (i, j) in terms if j),
                    )
                )
            (fx, fy), (gx, gy) = slopes
            det = fx * gy - fy * gx
            dx = (gy * values[0] - fy * values[1]) / det
            dy = (fx * values[1] - gx * values[0]) / det
            x, y = x - dx, y - dy
    with np.errstate(all="ignore"):
        done = np.hypot(dx, dy) < 1e-9 * (1.0 + np.hypot(x, y))
    return np.stack([x, y], axis=1)[done]


def test_newton_finds_a_known_crossing() -> None:
    """x^2 + y^2 = 2 and x^3 = y cross at (1, 1) and (-1, -1) only."""
    conic, cubic = np.array([-2.0, 0, 0, 1, 0, 1]), np.array([0, 0, -1.0, 0, 0, 0, 1, 0, 0, 0])
    found = newton(conic, cubic, np.random.default_rng(0).normal(size=(50, 2)))
    assert {tuple(p) for p in found.round(9)} == {(1.0, 1.0), (-1.0, -1.0)}


@pytest.mark.parametrize("kinds", KINDS)
def test_no_solution_is_missed(kinds: str) -> None:
    """From 400 starts each, Newton's method finds nothing that elimination has not, in a hundred random cases."""
    rng = np.random.default_rng(7)
    cases = speed_ratios_4_each(ARMS[kinds], *random_cases(kinds, 100, 2))
    counts, reached, listed = [], 0, 0
    for found in cases:
        size = 1.0 + np.abs(found.coordinates).max(initial=1.0)
        starts = rng.normal(size=(400, 2)) * size * 10.0 ** rng.uniform(-1.5, 0.5, (400, 1))
        zeros = newton(found.conic, found.cubic, starts)
        zeros = zeros[np.abs(zeros).max(axis=1) < 0.5 * fj.INFINITE]
        exact = found.coordinates if found.status == "exact" else np.zeros((0, 2))
        for zero in zeros:
            assert len(exact), (found, zero)
            assert np.abs(exact - zero).max(axis=1).min() < 1e-6 * (1.0 + np.abs(zero).max()), (found, zero)
        listed += len(exact)
        reached += sum(bool(len(zeros)) and np.abs(zeros - p).max(axis=1).min() < 1e-6 * size for p in exact)
        counts.append(found.count)
        assert found.count + found.complex_count + found.at_infinity == 6
    assert reached > 0.97 * listed  # so the comparison means something
    assert set(counts) <= {0, 2, 4, 6}
    assert {0, 2, 4} <= set(counts)


def test_count_changes_where_the_separation_vanishes() -> None:
    """Along a line of curvature rates the number of solutions changes by two, and only where two of them meet."""
    arm, q, tangent = ARMS["RRRR"], [0.4, 1.1, -0.6, 0.8], [0.6, 0.8]
    rates = np.linspace(-40.0, 40.0, 81)
    found = speed_ratios_4_each(arm, q, tangent, 0.3, rates)
    counts = [f.count for f in found]
    jumps = [k for k in range(80) if counts[k] != counts[k + 1]]
    assert jumps
    for k in jumps:
        assert abs(counts[k] - counts[k + 1]) == 2
        low, high = rates[k], rates[k + 1]
        for _ in range(44):
            middle = (low + high) / 2.0
            if speed_ratios_4(arm, q, tangent, 0.3, middle).count == counts[k]:
                low = middle
            else:
                high = middle
        assert high - low < 1e-12
        assert speed_ratios_4(arm, q, tangent, 0.3, low).separation < 1e-5


# ---- why at most six ------------------------------------------------------------------------------------------------


def test_the_sextic_is_the_rate_of_the_curvature() -> None:
    """|r'|^6 (rho - dk/ds) of two arbitrary functions, differentiated by SymPy from the definition of the curvature."""
    t, rho = sp.symbols("t rho", real=True)
    x, y = sp.Function("x")(t), sp.Function("y")(t)
    rows = [[sp.diff(f, t, k) for f in (x, y)] for k in (1, 2, 3)]
    speed = sp.sqrt(rows[0][0] ** 2 + rows[0][1] ** 2)
    curvature = (rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]) / speed**3
    rate = sp.diff(curvature, t) / speed
    assert sp.simplify(speed**6 * (rho - rate) - speed_ratio_4.sextic(*rows, rho)) == 0


def test_the_sextic_reduces_to_a_cubic() -> None:
    assert speed_ratio_4.reduction() == 0


def exact_numbers(arm: Any, seed: int) -> dict[Any, Any]:
    """Random rational values of everything; sines and cosines from Pythagorean triples."""
    rng = np.random.default_rng(seed)

    def angle() -> tuple[Any, Any]:
        m, n = (int(v) for v in rng.integers(1, 12, 2))
        square = sp.Integer(m * m + n * n)
        return sp.Integer(m * m - n * n) / square, sp.Integer(2 * m * n) / square

    def ratio() -> Any:
        return sp.Rational(int(rng.integers(-20, 20)) * 2 + 1, 14)

    numbers: dict[Any, Any] = {}
    for symbol in (*arm.inputs[0].symbols, *arm.inputs[1].symbols):
        numbers[sp.cos(symbol)], numbers[sp.sin(symbol)] = angle()
        numbers[symbol] = ratio()
    numbers[TANGENT.symbols[0]], numbers[TANGENT.symbols[1]] = angle()
    return numbers | {speed_ratio_4.KAPPA: ratio(), speed_ratio_4.RHO: ratio()}


@pytest.mark.parametrize("kinds", KINDS)
def test_twelve_intersections_are_six_solutions_and_two_stationary_points_threefold(kinds: str) -> None:
    """The resultants of exact polynomials: degree 12 = 3 x 2 + 6, and equal as products."""
    arm = catalogue.symbolic(ARMS[kinds].description.model)
    for seed in (0, 1):
        system = speed_ratio_4.paper_system(arm, exact_numbers(arm, seed))
        n2, n3 = speed_ratio_4.RATIOS
        assert sp.Poly(system.sextic, n2, n3).total_degree() == 6
        whole, still, six = (
            sp.Poly(sp.resultant(system.conic, p, n3), n2) for p in (system.sextic, system.still, system.cubic)
        )
        assert (whole.degree(), still.degree(), six.degree()) == (12, 2, 6)
        assert whole == still**3 * six


@pytest.mark.parametrize("kinds", ["RRRR", "RPRR"])
def test_the_count_with_a_leading_joint_is_the_same(kinds: str) -> None:
    """The real roots of the resultant in the paper's own unknowns are as many, and n2 = x2 / x1 of ours."""
    symbolic = catalogue.symbolic(ARMS[kinds].description.model)
    for seed in range(4):
        numbers = exact_numbers(symbolic, seed)
        system = speed_ratio_4.paper_system(symbolic, numbers)
        n2, n3 = speed_ratio_4.RATIOS
        six = sp.Poly(sp.resultant(system.conic, system.cubic, n3), n2)
        values = {k: float(v) for k, v in numbers.items()}
        q = [
            np.arctan2(values[sp.sin(s)], values[sp.cos(s)]) if kind == "R" else values[s]
            for s, kind in zip(symbolic.inputs[0].symbols, kinds, strict=True)
        ]
        names = symbolic.inputs[1].symbols
        headings = [0.0] * 4
        for symbol, place in zip(names[4:], (i for i, kind in enumerate(kinds) if kind == "P"), strict=True):
            headings[place] = float(np.arctan2(values[sp.sin(symbol)], values[sp.cos(symbol)]))
        arm = cr.planar(kinds, [values[s] for s in names[:4]], headings)
        tangent = [values[s] for s in TANGENT.symbols]
        found = speed_ratios_4(arm, q, tangent, values[speed_ratio_4.KAPPA], values[speed_ratio_4.RHO])
        assert found.count == six.count_roots()
        if found.count:
            expected = sorted(float(r.evalf(30)) for r in six.real_roots())
            np.testing.assert_allclose(sorted(found.ratios(1)[:, 1]), expected, rtol=1e-7, atol=1e-9)


def test_a_leading_joint_loses_a_solution_that_the_symmetric_parameter_keeps() -> None:
    """A path made by rates that leave joint 1 still: no ratio to it exists, and the solution is among ours."""
    arm, q = ARMS["RRRR"], np.array([0.3, 0.9, -0.7, 1.2])
    rates = np.array([0.0, 0.7, -0.4, 0.9])
    zero = np.zeros(4)
    derivatives, path = arm.evaluator("tip_motion")(q, arm.parameters, rates, zero, zero)
    tangent = derivatives[1] / np.linalg.norm(derivatives[1])
    found = speed_ratios_4(arm, q, tangent, path[1], path[2], path[3])
    assert found.chosen is not None
    np.testing.assert_allclose(found.rates[found.chosen], rates / path[0], atol=1e-8)
    with pytest.raises(InputError, match="joint 1 stands still in solution"):
        found.ratios(1)
    np.testing.assert_allclose(found.ratios(2)[found.chosen], rates / 0.7, atol=1e-7)


# ---- invariances ----------------------------------------------------------------------------------------------------


@settings(max_examples=40)
@given(
    q=st.lists(st.floats(-3.0, 3.0), min_size=4, max_size=4),
    turn=st.floats(-3.0, 3.0),
    curvature=st.floats(-2.0, 2.0),
    rate=st.floats(-2.0, 2.0),
)
def test_turning_the_whole_arm_changes_nothing(q: list[float], turn: float, curvature: float, rate: float) -> None:
    arm = ARMS["RRRR"]
    if np.linalg.cond(arm.jacobian(q)) > 1e3:
        return
    one = speed_ratios_4(arm, q, [1.0, 0.0], curvature, rate)
    two = speed_ratios_4(arm, [q[0] + turn, *q[1:]], [np.cos(turn), np.sin(turn)], curvature, rate)
    if min(one.separation, two.separation) < 1e-5:
        return
    assert (one.status, one.count) == (two.status, two.count)
    if one.status == "exact":
        size = 1.0 + np.abs(one.rates).max()
        order = [np.lexsort(np.round(f.rates / size, 6).T) for f in (one, two)]
        np.testing.assert_allclose(one.rates[order[0]], two.rates[order[1]], atol=1e-6 * size**2)


def test_mirrored_arm_and_path() -> None:
    """Mirrored joints, tangent and curvature give mirrored rates."""
    arm = ARMS["RRRR"]
    q, tangents, curvatures, rates = random_cases("RRRR", 20, 5)
    for one, two in zip(
        speed_ratios_4_each(arm, q, tangents, curvatures, rates),
        speed_ratios_4_each(arm, -q, tangents * [1.0, -1.0], -curvatures, -rates),
        strict=True,
    ):
        assert one.count == two.count
        if one.status == "exact":
            size = 1.0 + np.abs(one.rates).max()
            for x in one.rates:
                assert np.abs(two.rates + x).max(axis=1).min() < 1e-8 * size**2


def test_walking_backwards() -> None:
    """The opposite tangent: opposite rates, with k and dk/ds as seen from there (-k and the same dk/ds)."""
    arm = ARMS["RPRR"]
    q, tangents, curvatures, rates = random_cases("RPRR", 20, 6)
    forth = speed_ratios_4_each(arm, q, tangents, curvatures, rates)
    back = speed_ratios_4_each(arm, q, -tangents, -curvatures, rates)
    for one, two in zip(forth, back, strict=True):
        assert one.count == two.count
        if one.status == "exact":
            size = 1.0 + np.abs(one.rates).max()
            for x in one.rates:
                assert np.abs(two.rates + x).max(axis=1).min() < 1e-8 * size**2


# ---- what comes nearest ---------------------------------------------------------------------------------------------


def conic_points(found: FourJointRatios) -> np.ndarray:
    """Many points of the conic: its crossings with lines through many points of the plane, all directions."""
    rng = np.random.default_rng(3)
    origin = rng.normal(size=(40000, 2)) * 10.0 ** rng.uniform(-2.0, 2.0, (40000, 1))
    angle = rng.uniform(0.0, np.pi, 40000)
    d = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    c, (x, y), (u, v) = found.conic, origin.T, d.T
    a = c[3] * u * u + c[4] * u * v + c[5] * v * v
    b = c[1] * u + c[2] * v + 2 * c[3] * x * u + c[4] * (x * v + y * u) + 2 * c[5] * y * v
    e = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y
    with np.errstate(all="ignore"):
        root = np.sqrt(b * b - 4 * a * e)
        points = np.concatenate([origin + ((-b + s * root) / (2 * a))[:, None] * d for s in (1, -1)])
    return points[np.isfinite(points).all(axis=1)]


def value(coefficients: np.ndarray, points: np.ndarray) -> np.ndarray:
    return sum(c * points[:, 0] ** i * points[:, 1] ** j for c, (i, j) in zip(coefficients, fj.CUBIC, strict=False))


@pytest.mark.parametrize("kinds", KINDS)
def test_nothing_comes_nearer(kinds: str) -> None:
    """Where no real solution exists, no point of the conic has a better dk/ds, no rates a better curvature."""
    cases = speed_ratios_4_each(ARMS[kinds], *random_cases(kinds, 60, 8))
    seen = set()
    for found in cases:
        seen.add(found.status)
        if found.status == "nearest rate":
            miss = abs(found.path[0, 2] - found.desired[1])
            points = conic_points(found)
            points = points[np.abs(points).max(axis=1) < 1e3]
            assert np.abs(value(found.cubic, points)).min() > miss * (1.0 - 1e-6)
            assert found.path[0, 1] == pytest.approx(found.desired[0], abs=1e-8 * (1 + np.abs(found.rates).max() ** 2))
        elif found.status == "nearest curvature":
            miss = abs(found.path[0, 1] - found.desired[0])
            plane = np.random.default_rng(4).normal(size=(20000, 2)) * 10.0 ** np.linspace(-2, 2, 20000)[:, None]
            assert np.abs(value(found.conic, plane + found.coordinates[0])).min() > miss * (1.0 - 1e-9)
            assert not len(conic_points(found))
    assert seen >= {"exact", "nearest rate", "nearest curvature"}


def test_prismatic_joints_only_go_straight() -> None:
    arm = ARMS["PPPP"]
    bent = speed_ratios_4(arm, [0.1, 0.2, 0.3, 0.4], [1.0, 0.2], 0.5)
    assert (bent.status, bent.count) == ("nearest curvature", 0)
    assert bent.path[0, 1] == 0.0
    straight = speed_ratios_4(arm, [0.1, 0.2, 0.3, 0.4], [1.0, 0.2], 0.0)
    assert (straight.status, straight.count) == ("infinitely many", -1)
    clothoid = speed_ratios_4(arm, [0.1, 0.2, 0.3, 0.4], [1.0, 0.2], 0.0, 1.0)
    assert clothoid.status == "nearest rate"
    assert clothoid.path[0, 2] == 0.0


def test_three_prismatic_joints_leave_no_choice_of_the_rate() -> None:
    """One null vector moves nothing at all, so the conic is two lines, and dk/ds is one number on each of them."""
    arm, q, tangent, curvature = ARMS["RPPP"], [0.4, 0.3, 0.5, 0.2], [0.3, 1.0], -0.8
    found = speed_ratios_4(arm, q, tangent, curvature)
    assert (found.status, found.count, found.at_infinity) == ("nearest rate", 0, 6)
    assert found.path[0, 1] == pytest.approx(curvature)
    # that very rate asked for: met along the whole line, of which the point with the least rates is listed
    again = speed_ratios_4(arm, q, tangent, curvature, found.path[0, 2])
    assert again.status in ("infinitely many", "nearest rate")
    assert again.path[0, 2] == pytest.approx(found.path[0, 2])
    np.testing.assert_allclose(again.rates[0], found.rates[0], atol=1e-6)


def test_double_conic_is_not_called_a_solution_or_two() -> None:
    """At the extremum of the curvature the conic is one point: no solution there, nor just beside it."""
    arm, q, tangent = ARMS["RRRR"], [0.3, 0.5, -0.7, 0.9], [0.6, 0.8]
    beyond = next(
        f for f in speed_ratios_4_each(arm, q, tangent, np.linspace(-50, 50, 21)) if f.status == "nearest curvature"
    )
    extreme = beyond.path[0, 1]
    for curvature in (extreme, extreme + 1e-6, extreme - 1e-6):
        found = speed_ratios_4(arm, q, tangent, curvature, 1e3)
        assert found.count == 0
        assert found.path[0, 1] == pytest.approx(extreme, abs=1e-5)


# ---- the certificate ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kinds", KINDS)
def test_generated_coefficients_are_within_their_margin(kinds: str) -> None:
    """Against the derivation at 120 digits: the margin that the proof in double precision relies on."""
    arm = ARMS[kinds]
    q, tangents, curvatures, rates = random_cases(kinds, 12, 9)
    point = tangents / np.linalg.norm(tangents, axis=1, keepdims=True)
    rows = arm.evaluator("speed_ratio_conditions")(q, arm.parameters, point)
    values = np.linalg.svd(arm.jacobian(q), compute_uv=False)
    for k in range(len(q)):
        wanted = np.array([curvatures[k], rates[k], 0.0])
        condition = float(values[k, 0] / values[k, 1])
        place = fj._Place(arm, q[k], point[k], wanted, condition, *(row[k] for row in rows))
        rough, fine = place.rough(), place.fine()
        for a, b, size in zip((rough.conic, rough.cubic), (fine.conic, fine.cubic), rough.sizes, strict=True):
            worst = max(abs(float((x - y).p) / float((x - y).q)) if x != y else 0.0 for x, y in zip(a, b, strict=True))
            assert worst < 0.1 * rough.margin * float(size.p) / float(size.q)


def system(conic: list[float], cubic: list[float]) -> fj._System:
    rows = [[fj._exact(float(c)) for c in row] for row in (conic, cubic)]
    return fj._System(rows[0], rows[1], (fj._largest(rows[0]), fj._largest(rows[1])), fj.FINE_MARGIN)


def common(conic: list[float], cubic: list[float]) -> fj._Roots:
    return fj._common(system(conic, cubic), 1.0, fj._exact(fj.ZERO))


def test_crossings_known_by_hand() -> None:
    # circle x^2 + y^2 = 1 and the lines x (x - 1/2) (x + 1/2) = 0: six points
    six = common([-1, 0, 0, 1, 0, 1], [0, -0.25, 0, 0, 0, 0, 1, 0, 0, 0])
    assert (len(six.real), six.infinite, six.certified) == (6, 0, True)
    assert sorted(round(float(x), 9) for (x, _), _ in six.real) == [-0.5, -0.5, 0.0, 0.0, 0.5, 0.5]
    # ... and y = 2 three times: none real
    none = common([-1, 0, 0, 1, 0, 1], [-8, 0, 1, 0, 0, 0, 0, 0, 0, 0])
    assert (len(none.real), none.infinite) == (0, 4)
    # parabola y = x^2 and y = x^3: (0, 0) twice and (1, 1); three at infinity
    parabola = common([0, 0, -1, 1, 0, 0], [0, 0, -1, 0, 0, 0, 1, 0, 0, 0])
    assert sorted((round(float(x), 9), m) for (x, _), m in parabola.real) == [(0.0, 2), (1.0, 1)]
    assert (parabola.infinite, parabola.certified) == (3, False)


def test_touching_crossing_lines_and_shared_curves() -> None:
    # the circle and the line y = 1 with x^2 + 1: they touch at (0, 1)
    touch = common([-1, 0, 0, 1, 0, 1], [-1, 0, 1, -1, 0, 0, 0, 1, 0, 0])
    assert [m for (x, y), m in touch.real if abs(float(y) - 1) < 1e-9 and abs(float(x)) < 1e-9] == [2]
    # the lines x y = 0 and y = x^3 - x: (0, 0) where they cross, (1, 0), (-1, 0), and two points at infinity
    lines = common([0, 0, 0, 0, 1, 0], [0, -1, -1, 0, 0, 0, 1, 0, 0, 0])
    assert sorted((round(float(x), 9), round(float(y), 9), m) for (x, y), m in lines.real) == [
        (-1.0, 0.0, 1),
        (0.0, 0.0, 2),
        (1.0, 0.0, 1),
    ]
    # x y = 0 and x (x^2 + y + 1) = 0 share the line x = 0
    assert common([0, 0, 0, 0, 1, 0], [0, 1, 0, 0, 1, 0, 1, 0, 0, 0]).shared
    # parallel lines x = 1, x = -1, and x^3 = 8: nothing in common
    assert common([-1, 0, 0, 1, 0, 0], [-8, 0, 0, 0, 0, 0, 1, 0, 0, 0]).points == []
    # a straight line for a conic: y = x and the cubic y = x^3
    straight = common([0, 1, -1, 0, 0, 0], [0, 0, -1, 0, 0, 0, 1, 0, 0, 0])
    assert sorted(round(float(x), 9) for (x, _), _ in straight.real) == [-1.0, 0.0, 1.0]


def test_nearly_touching_curves_are_told_apart() -> None:
    """y = 1 + e against the unit circle: two, a double, or no real points for e = -1e-18, 0, 1e-18 (rationals)."""
    for e, count in ((-1, 2), (1, 0)):
        rows = system([-1, 0, 0, 1, 0, 1], [-1, 0, 1, 0, 0, 0, 0, 0, 0, 1e-30])
        rows.cubic[0] -= fj._exact(e) / 10**18
        near = fj._common(rows, 1.0, fj._exact(fj.ZERO))
        close = [p for p, _ in near.real if abs(float(p[1]) - 1.0) < 1e-3]
        assert len(close) == count
        assert near.certified
        assert near.separation < 1e-8


def test_a_margin_too_wide_is_not_certified() -> None:
    """Two crossings 2e-3 apart are told apart for a margin of 1e-12, not for one of 1e-2."""
    conic, cubic = [-1, 0, 0, 1, 0, 1], [-0.9999995, 0, 1, 0, 0, 0, 0, 0, 0.3, 0.2]
    tight = system(conic, cubic)
    points = [p for p, _ in fj._common(tight, 1.0, fj._exact(fj.ZERO)).points]
    assert fj._alone(tight, points)
    assert not fj._alone(fj._System(tight.conic, tight.cubic, tight.sizes, 1e-2), points)


# ---- input ----------------------------------------------------------------------------------------------------------


def test_refusals() -> None:
    arm, q = ARMS["RRRR"], [0.3, 0.5, -0.7, 0.9]
    for call, words in (
        (lambda: speed_ratios_4(cr.planar_3r(1, 1, 1), q, [1, 0], 0.0), "four joints are accepted"),
        (lambda: speed_ratios_4(cr.load("panda"), q, [1, 0], 0.0), "four joints are accepted"),
        (lambda: speed_ratios_4(arm, q[:3], [1, 0], 0.0), r"q has shape \(3,\)"),
        (lambda: speed_ratios_4(arm, q, [0, 0], 0.0), r"tangent: \(0, 0\)"),
        (lambda: speed_ratios_4(arm, q, [1, 0], np.nan), "curvature: nan; finite"),
        (lambda: speed_ratios_4(arm, [q, q], [1, 0], 0.0), "speed_ratios_4_each takes many"),
        (lambda: speed_ratios_4(arm, [0.1, 0, 0, 0], [1, 0], 0.0), "singular"),
        (lambda: speed_ratios_4_each(arm, [q, [0.1, 0, 0, 0]], [1, 0], 0.0), "configuration 1: singular"),
        (lambda: speed_ratios_4(arm, q, [1, 0], 0.0).ratios(5), "no joint 5"),
        (lambda: speed_ratios_4(arm, q, [1, 0], 0.0).ratios("x"), "no joint 'x'"),  # type: ignore[arg-type]
        (lambda: speed_ratios_4("RRRR", q, [1, 0], 0.0), "arm: 'RRRR'; an arm"),  # type: ignore[arg-type]
        (lambda: speed_ratios_4(arm, q, [1, 0], 1e20, 1e60), "curvature_rate: 1e.60 is too large"),
    ):
        with pytest.raises(InputError, match=words) as caught:
            call()
        assert "\n" not in str(caught.value)


def test_shapes_and_plain_values() -> None:
    arm, q = ARMS["RRRR"], np.array([[0.3, 0.5, -0.7, 0.9], [0.1, 1.0, 0.4, -0.3]])
    many = speed_ratios_4_each(arm, q[:, None], [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], 0.2, 0.1)
    assert len(many) == 6
    one = speed_ratios_4(arm, q[1], [5.0, 5.0], 0.2, 0.1)
    np.testing.assert_allclose(many[5].rates, one.rates)
    assert speed_ratios_4_each(arm, np.zeros((0, 4)), [1.0, 0.0], 0.0) == ()
    for found in many:
        text = json.dumps(found.to_dict(), allow_nan=False)
        assert json.loads(text)["count"] == found.count
        if found.chosen is not None and found.status == "exact":
            errors = np.abs(found.path[:, 3] - found.desired[2])
            assert errors[found.chosen] == errors.min()


# ---- reproduced, drawn, and on the command line ----------------------------------------------------------------


def test_what_the_paper_says_of_four_joints() -> None:
    from chainrule.papers.ambike_beyond import rows

    found = rows()
    assert len(found) >= 6
    assert all(row.good for row in found), [row.quantity for row in found if not row.good]


def test_every_status_is_drawn() -> None:
    from chainrule.plot.higher_order import draw_four_joints

    arm, straight = ARMS["RRRR"], ARMS["PPPP"]
    cases = speed_ratios_4_each(arm, [0.3, 0.9, 0.7, 0.5], [0.6, 0.8], [-1.0, 0.0, 1.0])
    six = speed_ratios_4(arm, [0.2, 0.8, 0.9, -1.2], [0.6, 0.8], 0.0)
    line = speed_ratios_4(straight, [0.1, 0.2, 0.3, 0.4], [1.0, 0.2], 0.0)
    assert {f.status for f in (*cases, line)} == {"nearest rate", "exact", "nearest curvature", "infinitely many"}
    for found in (*cases, six, line):
        title = draw_four_joints(found).axes[0].get_title(loc="left")
        assert (f"{found.count} joint motions meet" in title) == (found.status == "exact")
        assert found.status == "exact" or found.status in title


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    import chainrule.commands.four_joints
    from chainrule.cli import run

    assert chainrule.commands.four_joints.four_joints.__name__ == "four_joints"
    file = tmp_path / "four.toml"
    file.write_text(
        'chainrule = 1\nname = "four"\nsource = "a test"\nangles = "rad"\n'
        '[planar]\nkinds = "RRRR"\nlengths = [1.0, 0.8, 0.6, 0.4]\n'
    )
    given = ["four-joints", str(file), "--q=0.2 0.8 0.9 -1.2", "--tangent=3,4"]
    assert run([*given, "--curvature=0", "--json", f"--figure={tmp_path / 'six.svg'}"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert (answer["count"], answer["certified"], len(answer["solutions"])) == (6, True, 6)
    assert (tmp_path / "six.svg").read_text().lstrip().startswith("<?xml")
    assert run([*given, "--curvature=0"]) == 0
    assert "6 real, 0 complex" in capsys.readouterr().out
    degrees = [
        "four-joints",
        str(file),
        "--deg",
        "--q=17.188733853924695 51.56620156177409 40.10704565915762 28.64788975654116",
    ]
    assert run([*degrees, "--tangent=3,4", "--curvature=1"]) == 1
    assert "nearest curvature" in capsys.readouterr().out
    assert run([*given, "--curvature=tight"]) == 2
    assert "--curvature" in capsys.readouterr().err
