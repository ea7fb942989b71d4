"""Speed ratios: proved for every morphology, then held against paths differentiated without any code of the package."""

from __future__ import annotations

import json
from itertools import product

import mpmath
import numpy as np
import pytest
import reference
import sympy as sp

import chainrule as cr
from chainrule import cli
from chainrule.commands import speed_ratios as _registered  # noqa: F401  the command adds itself
from chainrule.derive import speed_ratio as derived
from chainrule.derive.planar import planar_chain
from chainrule.description import planar_model
from chainrule.plot.speed_ratio import draw_reachable, draw_speed_ratios
from chainrule.report.context import Context
from chainrule.report.parts.speed_ratio import SECTION
from chainrule.speed_ratio import BLOCK, REASONS, STANDSTILL, Status, speed_ratios

MORPHOLOGIES = ["".join(kinds) for kinds in product("RP", repeat=3)]
EXAMPLE_1 = np.radians([-14.0, -10.0, -205.0])


# ---- proofs ----------------------------------------------------------------------------------------------------------
# Every angle is written as the unit complex number E = exp(i angle): sines, cosines and the chain itself become Laurent
# polynomials, and zero has one name only.


def symbolic(kinds):
    """The symbolic chain, what replaces its sines and cosines, and the tip as a complex number."""
    arm = planar_chain(kinds, planar_model(kinds).parameter_names)
    q, parameters = (given.symbols for given in arm.inputs)
    headings = iter(parameters[3:])
    tip, heading, angles = sp.Integer(0), sp.Integer(1), {}
    for joint, kind in enumerate(kinds):
        angle = q[joint] if kind == "R" else next(headings)
        angles[angle] = sp.Symbol(f"E{joint}")
        heading *= angles[angle]
        tip += (parameters[joint] + (q[joint] if kind == "P" else 0)) * heading
    return arm, angles, tip


def laurent(expression, angles):
    """Sines and cosines, and the tangent (tx, ty) = (cos, sin), in terms of the E and of U."""
    u = sp.Symbol("U")
    tx, ty = derived.TANGENT.symbols
    pairs = {tx: (u + 1 / u) / 2, ty: (u - 1 / u) / (2 * sp.I)}
    for angle, e in angles.items():
        pairs[sp.cos(angle)], pairs[sp.sin(angle)] = (e + 1 / e) / 2, (e - 1 / e) / (2 * sp.I)
    return sp.expand(expression.xreplace(pairs))


def along_and_across(z, symbols):
    """Re and Im of z / T, where conjugation inverts the E and U."""
    turned = sp.expand(z / sp.Symbol("U"))
    other = sp.expand(turned.subs({e: 1 / e for e in symbols} | {sp.I: -sp.I}, simultaneous=True))
    return (turned + other) / 2, (turned - other) / (2 * sp.I)


def differentiated(kinds):
    """(r_i . T, T x r_i) and (T x r_ij, r_i . r_j) of the tip, by differentiation of the complex number."""
    arm, angles, tip = symbolic(kinds)
    units = [*angles.values(), sp.Symbol("U")]

    def by(z, joint):
        q = arm.inputs[0].symbols[joint]
        return sp.I * angles[q] * sp.diff(z, angles[q]) if q in angles else sp.diff(z, q)

    first = [along_and_across(by(tip, i), units) for i in range(3)]
    second = {(i, j): along_and_across(by(by(tip, i), j), units)[1] for i in range(3) for j in range(i, 3)}
    return arm, angles, first, second


def outputs(program, **given):
    """A program's outputs with every step put in, but some steps replaced by numbers."""
    values = {}
    for step in program.steps:
        name = step.symbol.name
        values[step.symbol] = sp.Integer(given[name]) if name in given else step.expression.xreplace(values)
    return {o.name: [e.xreplace(values) for e in o.expressions] for o in program.outputs}


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_the_coordination_equations_are_those_of_the_differentiated_tip(kinds):
    arm, angles, first, second = differentiated(kinds)
    for leading in (1, 2, 3):
        found = outputs(derived.terms(arm, leading), usual=1, solvable=1)
        lead = leading - 1
        i, j = (k for k in range(3) if k != lead)
        for value, joint in zip(found["A"], (i, j, lead), strict=True):  # (3): r' x T
            assert sp.expand(laurent(value, angles) + first[joint][1]) == 0
        pairs = ((i, i), (j, j), (i, j), (i, lead), (j, lead), (lead, lead))
        for b0, b1, (k, m) in zip(found["B0"], found["B1"], pairs, strict=True):  # (4): r'' x T + kappa r'.r'
            twice = 1 if k == m else 2
            assert sp.expand(laurent(b0, angles) + twice * second[min(k, m), max(k, m)]) == 0
            dot = first[k][0] * first[m][0] + first[k][1] * first[m][1]
            assert sp.expand(laurent(b1, angles) - twice * dot) == 0


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
@pytest.mark.parametrize("usual", [1, 0])
def test_a_and_b_are_plain_elimination_and_the_paper_s_claim_holds(kinds, usual):
    """For every morphology and leading joint; the products of the tip's derivatives are symbols, so it is exact.

    The dot product of two derivatives is along along' + across across' (proved above, since T is a unit vector).
    """
    arm = planar_chain(kinds, planar_model(kinds).parameter_names)
    kappa = derived.CURVATURE.symbols[0]
    n = sp.Symbol("n")
    for leading in (1, 2, 3):
        program = derived.terms(arm, leading)
        known = {"usual": usual, "solvable": 1}
        values, abstract = {}, {}
        for step in program.steps:  # keep the rows of J and B0 as symbols: they are whatever the arm makes them
            name = step.symbol.name
            if name.removeprefix("along").removeprefix("across").isdigit() or (name[0] == "B" and name.endswith("_0")):
                continue
            values[step.symbol] = sp.Integer(known[name]) if name in known else step.expression.xreplace(values)
        for output in program.outputs:
            abstract[output.name] = [e.xreplace(values) for e in output.expressions]
        line, conic = abstract["A"], abstract["B"]
        tx, ty = derived.TANGENT.symbols
        if usual:
            other = -(line[0] * n + line[2]) / line[1]
            omega = conic[0] * n**2 + conic[1] * other**2 + conic[2] * n * other + conic[3] * n + conic[4] * other
        else:
            other = -(line[1] * n + line[2]) / line[0]
            omega = conic[0] * other**2 + conic[1] * n**2 + conic[2] * n * other + conic[3] * other + conic[4] * n
        omega += conic[5]
        a, b = abstract["a"], abstract["b"]
        printed = sum((a[k] * kappa + b[k]) * n ** (2 - k) for k in range(3))
        assert sp.cancel(sp.together(omega - printed)) == 0
        assert sp.cancel(sp.together(a[1] ** 2 - 4 * a[0] * a[2])) == 0
        delta = (a[1] * kappa + b[1]) ** 2 - 4 * (a[0] * kappa + b[0]) * (a[2] * kappa + b[2])
        assert sp.cancel(sp.together(abstract["discriminant"][0] - delta)) == 0
        assert tx not in omega.free_symbols
        assert ty not in omega.free_symbols


def test_the_proof_can_fail():
    """Without (5) the part of the curvature is no square: two independent forms."""
    a1, a2, c1, c2 = sp.symbols("a1 a2 c1 c2")
    n = sp.Symbol("n")
    square = sp.Poly((a1 * n + a2) ** 2 + (c1 * n + c2) ** 2, n).all_coeffs()
    assert sp.expand(square[1] ** 2 - 4 * square[0] * square[2]) != 0


def test_three_prismatic_joints_make_kappa_times_a_square_with_a_motionless_root():
    arm, angles, first, _ = differentiated("PPP")
    for leading in (1, 2, 3):
        found = outputs(derived.terms(arm, leading), usual=1, solvable=1)
        assert all(e == 0 for e in (*found["b"], *found["B0"], *found["C"], *found["D"]))
        assert any(e != 0 for e in found["a"])  # the paper says that (7) vanishes; only C and D do
    found = outputs(derived.terms(arm, 1), usual=1, solvable=1)
    a, line = ([laurent(e, angles) for e in found[name]] for name in ("a", "A"))
    root = sp.cancel(sp.together(-a[1] / (2 * a[0])))
    other = -(line[0] * root + line[2]) / line[1]
    for row in (0, 1):  # the tip's velocity at the double root
        assert sp.cancel(sp.together(first[1][row] * root + first[2][row] * other + first[0][row])) == 0


# ---- many random arms, against derivatives of a complex number -------------------------------------------------------


def random_arms(kinds, count, seed=0):
    """One arm's lengths and headings, many configurations, tangents and curvatures."""
    random = np.random.default_rng([seed, *map(ord, kinds)])
    sliding = np.array([kind == "P" for kind in kinds])
    arm = cr.planar(kinds, random.uniform(0.2, 1.5, 3), np.where(sliding, random.uniform(-3, 3, 3), 0.0))
    q = np.where(sliding, random.uniform(-0.8, 0.8, (count, 3)), random.uniform(-np.pi, np.pi, (count, 3)))
    angle = random.uniform(-np.pi, np.pi, count)
    return arm, q, np.stack([np.cos(angle), np.sin(angle)], axis=-1), random.normal(0.0, 1.5, count)


def derivatives(arm, q, rates):
    """r', r'', r''' of the tip at constant rates, as complex numbers."""
    geometry, total = arm.description.geometry, [0.0, 0.0, 0.0]
    angle, turning = 0.0, 0.0
    for k, kind in enumerate(arm.kinds):
        angle = angle + (q[..., k] if kind == "R" else geometry.headings[k])
        turning = turning + (rates[..., k] if kind == "R" else 0.0)
        a = geometry.lengths[k] + (q[..., k] if kind == "P" else 0.0)
        da = rates[..., k] if kind == "P" else 0.0
        e = np.exp(1j * angle)
        total[0] = total[0] + (da + 1j * a * turning) * e
        total[1] = total[1] + (2j * da * turning - a * turning**2) * e
        total[2] = total[2] + (-3.0 * da * turning**2 - 1j * a * turning**3) * e
    return total


def path(arm, q, rates):
    """Velocity, curvature and dk/ds of the path."""
    first, second, third = derivatives(arm, q, rates)
    speed = np.abs(first)
    p, dp = (np.conj(first) * second).imag, (np.conj(first) * third).imag
    dv = (np.conj(first) * second).real
    return first, p / speed**3, (dp * speed**2 - 3.0 * p * dv) / speed**6


def well_posed(found):
    """Far enough from singular and from solutions at infinity that doubles say something."""
    size = np.abs(found.rates)
    fine = np.isfinite(size).all(axis=-1) & (size.max(axis=-1) < 1e3)
    return fine & (np.abs(found.pseudoinverse).max(axis=-1) < 1e2)[..., None]


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_the_paths_have_the_tangent_and_the_curvature(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 2000)
    found = speed_ratios(arm, q, tangent, wanted)
    fine = well_posed(found)
    assert fine.sum() > 1000
    velocity, curvature, change = path(arm, q[:, None], found.rates)
    scale = 1.0 + np.abs(found.rates).max(axis=-1) ** 2
    cube = 1.0 + np.abs(found.rates).max(axis=-1) ** 3
    unit = tangent[:, 0] + 1j * tangent[:, 1]
    assert (np.abs(velocity - unit[:, None]) / scale)[fine].max() < 1e-11
    assert (np.abs(curvature - found.curvatures) / scale)[fine].max() < 1e-11
    assert (np.abs(change - found.curvature_rates) / cube**2)[fine].max() < 1e-10
    exact = fine & found.exact[:, None]
    assert (np.abs(curvature - wanted[:, None]) / scale)[exact].max(initial=0.0) < 1e-11
    if kinds != "PPP":
        assert exact.sum() > 100


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_the_curvature_and_its_rate_by_differences_at_fifty_digits(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 12, seed=1)
    for k in range(len(q)):
        found = speed_ratios(arm, q[k], tangent[k], wanted[k])
        for rates, curvature, change in zip(found.rates, found.curvatures, found.curvature_rates, strict=True):
            with mpmath.workdps(50):

                def tip(t, rates=rates, k=k):
                    pose = reference.pose(
                        arm.description,
                        [mpmath.mpf(a) + t * mpmath.mpf(b) for a, b in zip(q[k], rates, strict=True)],
                        50,
                    )
                    return mpmath.mpc(pose[0, 2], pose[1, 2])

                h = mpmath.mpf(10) ** -9
                y = {m: tip(m * h) for m in range(-3, 4)}
                first = (45 * (y[1] - y[-1]) - 9 * (y[2] - y[-2]) + (y[3] - y[-3])) / (60 * h)
                second = (270 * (y[1] + y[-1]) - 27 * (y[2] + y[-2]) + 2 * (y[3] + y[-3]) - 490 * y[0]) / (180 * h**2)
                third = (-13 * (y[1] - y[-1]) + 8 * (y[2] - y[-2]) - (y[3] - y[-3])) / (8 * h**3)
                v = abs(first)
                p = mpmath.im(mpmath.conj(first) * second)
                expected = p / v**3
                slope = (
                    mpmath.im(mpmath.conj(first) * third) * v**2 - 3 * p * mpmath.re(mpmath.conj(first) * second)
                ) / v**6
            size = 1.0 + float(np.abs(rates).max())
            assert abs(complex(first) - complex(*tangent[k])) < 1e-11 * size**2
            assert abs(float(expected) - curvature) < 1e-11 * size**2
            assert abs(float(slope) - change) < 1e-10 * size**4


@pytest.mark.parametrize("kinds", [kinds for kinds in MORPHOLOGIES if kinds != "PPP"])
def test_no_constant_rates_come_nearer_than_the_nearest(kinds):
    """Also the claim of the paper's section 4 that first-order coordination cannot come closer."""
    arm, q, tangent, wanted = random_arms(kinds, 400, seed=2)
    found = speed_ratios(arm, q, tangent, wanted)
    assert (found.status == Status.NEAREST).sum() > 20
    spread = np.concatenate([-np.logspace(-3, 3, 150), [0.0], np.logspace(-3, 3, 150)])
    for k in np.flatnonzero(found.status == Status.NEAREST):
        jacobian = np.asarray(arm.jacobian(q[k]))
        least, null = np.linalg.pinv(jacobian) @ tangent[k], np.linalg.svd(jacobian)[2][2]
        around = found.rates[k, 0] + spread[:, None] * null
        everywhere = np.concatenate([around, least + spread[:, None] * null])
        _, curvature, _ = path(arm, q[k], everywhere)
        error, best = np.abs(curvature - wanted[k]), abs(found.curvatures[k, 0] - wanted[k])
        size = 1.0 + np.abs(everywhere).max(axis=1) ** 2
        assert (error - best > -1e-10 * size).all()
        low, high = found.reachable[k]
        assert (curvature > low - 1e-10 * size).all()
        assert (curvature < high + 1e-10 * size).all()
        assert not low <= wanted[k] <= high


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
@pytest.mark.parametrize("leading", [1, 2, 3])
def test_the_ratios_solve_the_paper_s_equations(kinds, leading):
    arm, q, tangent, wanted = random_arms(kinds, 500, seed=3)
    found = speed_ratios(arm, q, tangent, wanted, leading=leading)
    n, m = found.ratios[..., 0], found.ratios[..., 1]
    line, conic = found.A[:, None], found.B[:, None]
    fine = well_posed(found) & (np.abs(found.ratios).max(axis=-1) < 1e3) & (found.leading == leading)[:, None]
    size = 1.0 + np.abs(found.ratios).max(axis=-1)
    five = line[..., 0] * n + line[..., 1] * m + line[..., 2]
    assert (np.abs(five) / size)[fine].max() < 1e-10
    wanted_or_tracked = found.curvatures
    conic = found.B0[:, None] + wanted_or_tracked[..., None] * found.B1[:, None]
    six = conic[..., 0] * n**2 + conic[..., 1] * m**2 + conic[..., 2] * n * m + conic[..., 3] * n + conic[..., 4] * m
    assert (np.abs(six + conic[..., 5]) / (size**2 * np.abs(conic).max(axis=-1) + 1e-300))[fine].max() < 1e-9
    steady = fine & (np.abs(found.A[:, 1]) > 1e-3)[:, None]
    seven = found.a[:, None] * wanted_or_tracked[..., None] + found.b[:, None]
    value = seven[..., 0] * n**2 + seven[..., 1] * n + seven[..., 2]
    assert (np.abs(value) / (size**2 * np.abs(seven).max(axis=-1) + 1e-300))[steady].max() < 1e-8
    np.testing.assert_allclose(found.discriminant, wanted * found.C + found.D, rtol=1e-12, atol=1e-12)
    clear = steady.any(axis=1) & (np.abs(found.discriminant) > 1e-6 * (np.abs(wanted * found.C) + np.abs(found.D)))
    if kinds != "PPP":
        assert ((found.discriminant > 0.0) == found.exact)[clear].all()
        bent = clear & ((found.status == Status.EXACT) | (found.status == Status.NEAREST))
        ends = np.where(np.isfinite(found.reachable[:, 0]), found.reachable[:, 0], found.reachable[:, 1])
        np.testing.assert_allclose((-found.D / found.C)[bent], ends[bent], rtol=1e-5, atol=1e-7)
        assert ((found.C > 0.0) == np.isfinite(found.reachable[:, 0]))[bent].all()


# ---- invariance ------------------------------------------------------------------------------------------------------


def sets_of(found):
    """The solutions in an order that does not depend on the metric: by dk/ds."""
    order = np.argsort(np.where(np.isnan(found.curvature_rates), np.inf, found.curvature_rates), axis=-1)
    return np.take_along_axis(found.rates, order[..., None], axis=-2)


def same(found, other, factor=1.0):
    fine = (np.isnan(found.rates) | (np.abs(found.rates) < 50.0)).all(axis=(-1, -2)) & (found.count > 0)
    fine &= (found.count == other.count) & (np.abs(found.pseudoinverse).max(axis=-1) < 50.0)
    gap = np.abs(np.diff(found.curvature_rates, axis=-1))[:, 0]
    spread = np.abs(np.diff(found.rates, axis=-2)).max(axis=(-1, -2))
    fine &= ~((gap < 1e-6) | (spread < 1e-3))  # equal dk/ds: the order says nothing; near a double root
    assert fine.sum() > 100
    assert (found.status[fine] == other.status[fine]).all()
    np.testing.assert_allclose(sets_of(found)[fine] * factor, sets_of(other)[fine], rtol=1e-6, atol=1e-8)


def moved(arm, lengths=None, headings=None):
    geometry = arm.description.geometry
    return cr.planar(
        arm.kinds, geometry.lengths if lengths is None else lengths, geometry.headings if headings is None else headings
    )


def mask(arm):
    return np.array([kind == "R" for kind in arm.kinds])


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_turning_the_base_changes_nothing(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=4)
    turn = np.array([[np.cos(0.7), -np.sin(0.7)], [np.sin(0.7), np.cos(0.7)]])
    headings = np.array(arm.description.geometry.headings)
    turned_q = q + np.array([0.7 * (kinds[0] == "R"), 0, 0])
    other = moved(arm, headings=headings + np.array([0.7 * (kinds[0] == "P"), 0, 0]))
    same(speed_ratios(arm, q, tangent, wanted), speed_ratios(other, turned_q, tangent @ turn.T, wanted))


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_a_mirrored_arm_mirrors_the_rates(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=5)
    sign = np.where(mask(arm), -1.0, 1.0)
    other = moved(arm, headings=[-h for h in arm.description.geometry.headings])
    found = speed_ratios(arm, q, tangent, wanted)
    mirrored = speed_ratios(other, q * sign, tangent * [1.0, -1.0], -wanted)
    np.testing.assert_allclose(-mirrored.curvature_rates, found.curvature_rates, rtol=1e-5, atol=1e-5)
    np.testing.assert_allclose(mirrored.rates * sign, found.rates, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_the_same_path_run_backwards(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=6)
    found, back = speed_ratios(arm, q, tangent, wanted), speed_ratios(arm, q, -tangent, -wanted)
    np.testing.assert_allclose(-back.rates, found.rates, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(back.curvature_rates, found.curvature_rates, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_a_larger_arm_makes_the_same_motion_larger(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=7)
    scale = np.where(mask(arm), 1.0, 3.0)
    other = moved(arm, lengths=[3.0 * size for size in arm.description.geometry.lengths])
    same(speed_ratios(arm, q, tangent, wanted), speed_ratios(other, q * scale, tangent, wanted / 3.0), scale / 3.0)


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_the_leading_joint_changes_the_ratios_only(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=8)
    by = [speed_ratios(arm, q, tangent, wanted, leading=k) for k in (1, 2, 3)]
    for found in by[1:]:
        np.testing.assert_array_equal(found.rates, by[0].rates)
        np.testing.assert_array_equal(found.chosen, by[0].chosen)
    for k, found in enumerate(by):
        led = (found.leading == k + 1) & (found.count == 2)
        others = [m for m in range(3) if m != k]
        with np.errstate(divide="ignore", invalid="ignore"):
            expected = found.rates[..., others] / found.rates[..., [k]]
        np.testing.assert_allclose(found.ratios[led], expected[led], rtol=1e-9)


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
@pytest.mark.parametrize("scale", [2.0**-27, 2.0**-20, 2.0**-10, 2.0**20])
def test_an_arm_of_any_size_has_the_same_solutions(kinds, scale):
    """From 7 nm to 1000 km. What rounding leaves must not be taken for slides' rates, nor these for what it leaves."""
    arm, q, tangent, wanted = random_arms(kinds, 300, seed=19)
    other = moved(arm, lengths=[scale * size for size in arm.description.geometry.lengths])
    units = np.where(mask(arm), 1.0, scale)  # of q; rates are these for each metre of path, and the path is scaled too
    for leading in (1, 2, 3):
        one = speed_ratios(arm, q, tangent, wanted, leading=leading)
        found = speed_ratios(other, q * units, tangent, wanted / scale, leading=leading)
        np.testing.assert_array_equal(found.status, one.status)
        np.testing.assert_array_equal(found.count, one.count)
        led = found.leading == leading  # PPR goes straight where its last joint stands still
        np.testing.assert_array_equal(led, one.leading == leading)
        assert led.all() or kinds in ("PPR", "PPP")
        # which solution is nearer to J^+ T depends on the units, which two there are does not
        rates, size = found.rates * scale / units, np.nanmax(np.abs(one.rates), axis=(1, 2))
        gaps = [np.abs(rates - one.rates[:, order]).max(axis=(1, 2)) / size**2 for order in ([0, 1], [1, 0])]
        alone = np.abs(rates[:, 0] - one.rates[:, 0]).max(axis=1) / size**2
        clear = (size < 100.0) & (np.abs(np.linalg.svd(arm.jacobian(q))[1]).min(axis=1) > 0.05)
        assert clear.sum() > 150
        both = clear & (one.count == 2)
        apart = np.abs(np.diff(one.rates, axis=1)).max(axis=(1, 2))
        assert (np.minimum(*gaps) * np.minimum(apart, 1.0))[both].max(initial=0.0) < 1e-10
        assert kinds == "PPP" or alone[clear & (found.status == Status.NEAREST)].max() < 1e-10
        others = [k for k in range(3) if k != leading - 1]
        with np.errstate(divide="ignore", invalid="ignore"):
            quotients = found.rates[..., others] / found.rates[..., [leading - 1]]
        np.testing.assert_allclose(found.ratios[led], quotients[led], rtol=1e-14)


def test_every_size_of_threshold_is_one_of_rounding():
    """The first of two solutions far apart is not lost in an arm of a few nanometres, and slides lead it."""
    arm = cr.planar("RRP", [5e-8, 9e-9, 1.4e-8], [0.0, 0.0, -1.1])
    found = speed_ratios(arm, [1.2, 2.0, -8e-9], [-4e-5, 1.5e-3], -2e7, leading=3)
    assert found.status is Status.EXACT
    assert (found.count, found.leading) == (2, 3)
    _, curvature, _ = path(arm, found.q, found.rates)
    np.testing.assert_allclose(curvature, -2e7, rtol=1e-12)


# ---- degenerate cases ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("fold", list(product((0.0, np.pi, -np.pi), repeat=2)))
def test_stretched_and_folded_arms_are_singular_in_every_direction(fold):
    random = np.random.default_rng(3)
    for _ in range(30):
        arm = cr.planar_3r(*random.uniform(0.1, 3.0, 3))
        first, angle = random.uniform(-np.pi, np.pi, 2)
        q = [first, *fold]
        for direction in (angle, first, first + np.pi / 2):
            found = speed_ratios(arm, q, [np.cos(direction), np.sin(direction)], 0.3)
            assert found.status is Status.SINGULAR
            assert not found.exact
            assert (found.count, found.chosen) == (0, -1)
            assert found.rates.shape == (0, 3)
            assert found.ratios.shape == (0, 2)
            assert np.isnan([found.curvature, found.pseudoinverse_curvature]).all()
            assert np.isnan(found.chosen_rates).all()
            assert np.isnan([*found.parabola, *found.pseudoinverse, *found.null]).all()
            assert "rank 1" in found.reason
            assert ("not along the tangent" in found.reason) == (direction != first + np.pi / 2)


def test_parallel_slides_and_a_point_have_no_rank():
    slides = cr.planar("PPP", [0.1, 0.2, 0.3], [0.4, 0.0, 0.0])
    assert speed_ratios(slides, [0.1, 0.2, 0.3], [1.0, 0.0], 1.0).status is Status.SINGULAR
    point = cr.planar_3r(0.0, 0.0, 0.0)
    assert "no joint moves the tip" in speed_ratios(point, [1.0, 2.0, 3.0], [1.0, 0.0], 1.0).reason


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_along_the_acceleration_of_self_motion_one_solution_is_at_infinity(kinds):
    """There p2 is zero, though rounding never makes it so; the far root would be noise."""
    arm, q, _, wanted = random_arms(kinds, 500, seed=9)
    jacobian = np.asarray(arm.jacobian(q))
    null = np.linalg.svd(jacobian)[2][:, 2]
    _, second, _ = derivatives(arm, q, null)
    clear = np.abs(second) > 1e-6
    if kinds == "PPP":
        assert not clear.any()
        return
    if kinds == "PPR":  # every acceleration is along the last link, and so is the tangent: nothing bends
        found = speed_ratios(arm, q, np.stack([second.real, second.imag], axis=-1), wanted)
        assert (found.status[clear] == Status.FIXED).all()
        np.testing.assert_allclose(found.curvature[clear], 0.0, atol=1e-10)
        return
    q, wanted, second = q[clear], wanted[clear], second[clear]
    tangent = np.stack([second.real, second.imag], axis=-1)
    found = speed_ratios(arm, q, tangent, wanted)
    assert (np.isin(found.status, (Status.ONE_AT_INFINITY, Status.FIXED))).all()
    lines = found.status == Status.ONE_AT_INFINITY
    assert lines.mean() > 0.9
    assert (found.count == 1).all()
    assert found.exact[lines].all()
    assert np.isnan(found.rates[:, 1]).all()
    assert (np.abs(found.reachable[lines]) == np.inf).all()
    fine = lines & (np.abs(found.rates[:, 0]).max(axis=-1) < 1e3)
    _, curvature, _ = path(arm, q[fine], found.rates[fine, 0])
    np.testing.assert_allclose(curvature, wanted[fine], rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("kinds", [kinds for kinds in MORPHOLOGIES if kinds != "PPP"])
def test_a_little_beside_it_both_solutions_are_there(kinds):
    arm, q, _, wanted = random_arms(kinds, 300, seed=10)
    _, values, rows = np.linalg.svd(np.asarray(arm.jacobian(q)))
    _, second, _ = derivatives(arm, q, rows[:, 2])
    clear = (np.abs(second) > 1e-3) & (values.prod(axis=1) > 1e-2)
    tilted = second[clear] * np.exp(1e-8j)
    found = speed_ratios(arm, q[clear], np.stack([tilted.real, tilted.imag], axis=-1), wanted[clear])
    assert np.isin(found.status, (Status.EXACT, Status.NEAREST)).all()


def test_an_ordinary_arm_meets_no_threshold():
    for kinds in MORPHOLOGIES[:-1]:
        arm, q, tangent, wanted = random_arms(kinds, 20_000, seed=11)
        found = speed_ratios(arm, q, tangent, wanted)
        assert np.isin(found.status, (Status.EXACT, Status.NEAREST)).all()
        assert (found.count[found.status == Status.EXACT] == 2).all()
        assert (found.leading == 1).all()


def test_where_nothing_changes_the_curvature_it_is_fixed():
    """Two parallel slides after a revolute joint: self-motion turns nothing."""
    arm = cr.planar("RPP", [0.4, 0.3, 0.2], [0.0, 0.8, 0.0])
    found = speed_ratios(arm, [0.3, 0.1, 0.2], [0.6, 0.8], 0.5)
    assert found.status is Status.FIXED
    assert not found.exact
    np.testing.assert_array_equal(found.rates[0], found.pseudoinverse)
    jacobian = np.asarray(arm.jacobian([0.3, 0.1, 0.2]))
    np.testing.assert_allclose(found.rates[0], np.linalg.pinv(jacobian) @ [0.6, 0.8], atol=1e-14)
    for z in (-2.0, 5.0):
        _, curvature, _ = path(arm, found.q, found.rates[0] + z * found.null)
        assert curvature == pytest.approx(found.curvature)
    np.testing.assert_allclose(found.reachable, found.curvature)
    met = speed_ratios(arm, [0.3, 0.1, 0.2], [0.6, 0.8], found.curvature)
    assert met.status is Status.FIXED
    assert met.exact


def test_three_slides_go_straight():
    arm = cr.planar("PPP", [0.3, 0.4, 0.5], [0.1, 1.0, 0.7])
    found = speed_ratios(arm, [0.1, 0.2, 0.3], [1.0, 0.0], [0.0, 1.0])
    assert (found.status == Status.FIXED).all()
    assert found.exact.tolist() == [True, False]
    assert (found.C == 0.0).all()
    assert (found.D == 0.0).all()
    assert (found.curvature == 0.0).all()
    single = speed_ratios(arm, [0.1, 0.2, 0.3], [1.0, 0.0], 1.0)
    assert "double root" in single.reason
    root = -single.a[1] / (2.0 * single.a[0])  # of kappa times a square: the tip stands still
    np.testing.assert_allclose(root, single.null[1] / single.null[0], rtol=1e-12)


@pytest.mark.parametrize("leading", [1, 2, 3])
def test_a_leading_joint_that_stands_still_is_replaced(leading):
    random = np.random.default_rng(12)
    arm, replaced, tried = cr.load("ambike_3r"), 0, 0
    for _ in range(50):
        q, rates = random.uniform(-np.pi, np.pi, 3), random.normal(size=3)
        rates[leading - 1] = 0.0
        velocity, curvature, change = path(arm, q, rates)
        if abs(velocity) < 0.3 or abs(curvature) > 10.0:
            continue
        tangent = [velocity.real, velocity.imag]
        found = speed_ratios(arm, q, tangent, float(curvature), float(change), leading=leading)
        np.testing.assert_allclose(found.chosen_rates * abs(velocity), rates, atol=1e-8)
        share = np.abs(found.rates) / np.abs(found.rates).max(axis=-1, keepdims=True)
        assert (share[:, found.leading - 1] > STANDSTILL).all()
        assert (found.leading != leading) == (share[:, leading - 1] <= STANDSTILL).any()
        assert (f"Joint {leading} stands still" in found.reason) == (found.leading != leading)
        assert np.isfinite(found.ratios).all()
        replaced, tried = replaced + (found.leading != leading), tried + 1
    assert replaced > 0.8 * tried > 20


def test_a_leading_joint_that_cannot_move_along_the_tangent():
    """Links 2 and 3 on one line, the tangent across them: joint 1 must stand still, and A1 = A2 = 0."""
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = [0.0, np.pi / 2, 0.0]
    low, high = speed_ratios(arm, q, [1.0, 0.0], 0.0).reachable
    wanted = low + 1.0 if np.isfinite(low) else high - 1.0
    found = speed_ratios(arm, q, [1.0, 0.0], wanted)
    np.testing.assert_allclose(found.rates[:, 0], 0.0, atol=1e-14)
    assert found.leading != 1
    assert "Joint 1 stands still" in found.reason
    assert found.status is Status.EXACT
    _, curvature, _ = path(arm, np.array(q), found.rates)
    np.testing.assert_allclose(curvature, wanted, atol=1e-12)
    assert np.isfinite(found.ratios).all()
    assert found.discriminant > 0.0
    auto = speed_ratios(arm, q, [1.0, 0.0], wanted, leading="auto")
    assert auto.leading == found.leading
    assert "stands still" not in auto.reason
    many = speed_ratios(arm, [q, EXAMPLE_1.tolist()], [1.0, 0.0], wanted)
    assert many.leading.tolist() == [found.leading, 1]
    other = speed_ratios(arm, EXAMPLE_1, [1.0, 0.0], wanted)
    for name in ("A", "B", "a", "b", "C", "D", "discriminant"):
        np.testing.assert_array_equal(getattr(many, name)[0], getattr(found, name))
        np.testing.assert_array_equal(getattr(many, name)[1], getattr(other, name))


def test_where_a2_vanishes_the_other_ratio_is_the_unknown():
    """The tangent along the last link's own motion: (5) says nothing of n3."""
    arm, q = cr.load("ambike_3r"), np.array([0.3, 1.1, 0.6])
    heading = q.sum() + np.pi / 2
    found = speed_ratios(arm, q, [np.cos(heading), np.sin(heading)], 0.2)
    assert abs(found.A[1]) < 1e-14
    a, b = found.a, found.b
    assert a[1] ** 2 - 4.0 * a[0] * a[2] == pytest.approx(0.0, abs=1e-12 * a[1] ** 2)
    assert found.discriminant == pytest.approx(
        (found.b[1] + 0.2 * a[1]) ** 2 - 4 * (b[0] + 0.2 * a[0]) * (b[2] + 0.2 * a[2])
    )
    assert (found.discriminant > 0.0) == found.exact
    if found.exact:
        roots = np.sort(np.roots(a * 0.2 + b))
        np.testing.assert_allclose(np.sort(found.ratios[:, 1]), roots, rtol=1e-9)
    np.testing.assert_allclose(found.ratios[:, 0], -found.A[2] / found.A[0], rtol=1e-9)


def test_at_the_end_of_what_is_reachable_there_is_one_solution():
    arm, q, tangent, wanted = random_arms("RRR", 200, seed=13)
    found = speed_ratios(arm, q, tangent, wanted)
    near = found.status == Status.NEAREST
    again = speed_ratios(arm, q[near], tangent[near], found.curvature[near])
    assert (again.status == Status.EXACT).all()
    assert (again.count == 1).all()
    np.testing.assert_allclose(again.rates[:, 0], found.rates[near, 0], rtol=1e-6, atol=1e-9)


def test_the_nearest_path_may_bend_to_the_other_side():
    arm, q, tangent, wanted = random_arms("RRR", 2000, seed=14)
    found = speed_ratios(arm, q, tangent, wanted)
    other = np.flatnonzero((found.status == Status.NEAREST) & (found.curvature * wanted < 0.0))
    assert other.size
    k = int(other[0])
    assert "other side" in found.explain(k)
    sign = np.sign(wanted[k])  # the paper counts curvature from the desired side: C and D < 0
    assert sign * found.C[k] < 0.0
    assert found.D[k] < 0.0


def test_the_choice_follows_the_desired_change_of_curvature():
    arm, q, tangent, wanted = random_arms("RRP", 2000, seed=15)
    change = np.random.default_rng(16).normal(0.0, 5.0, 2000)
    found = speed_ratios(arm, q, tangent, wanted, change)
    both = found.count == 2
    error = np.abs(found.curvature_rates - change[:, None])[both]
    assert (error.argmin(axis=1) == found.chosen[both]).all()
    assert {0, 1} == set(found.chosen[both].tolist())


# ---- many at once, and what is given ---------------------------------------------------------------------------------


def test_many_are_as_each_alone():
    arm, q, tangent, wanted = random_arms("RRR", 60, seed=17)
    q[5] = [0.3, 0.0, 0.0]
    found = speed_ratios(
        arm, q.reshape(4, 15, 3), tangent.reshape(4, 15, 2), wanted.reshape(4, 15), 0.1, leading="auto"
    )
    assert found.rates.shape == (4, 15, 2, 3)
    assert found.ratios.shape == (4, 15, 2, 2)
    assert found.status.shape == found.count.shape == found.curvature.shape == (4, 15)
    assert found.status[0, 5] == Status.SINGULAR
    assert found.chosen[0, 5] == -1
    for k in range(60):
        one, i = speed_ratios(arm, q[k], tangent[k], wanted[k], 0.1, leading="auto"), divmod(k, 15)
        assert (one.status, one.count, one.chosen, one.exact) == (
            found.status[i],
            found.count[i],
            found.chosen[i],
            found.exact[i],
        )
        assert one.count == 0 or one.leading == found.leading[i]
        for name in ("rates", "ratios", "curvatures", "curvature_rates"):
            np.testing.assert_array_equal(getattr(one, name), getattr(found, name)[i][: one.count])
            assert np.isnan(getattr(found, name)[i][one.count :]).all()
        for name in ("chosen_rates", "chosen_ratios", "curvature", "reachable", "pseudoinverse_curvature"):
            np.testing.assert_array_equal(getattr(one, name), getattr(found, name)[i])
        assert one.reason == found.explain(*i)
    assert found.reason.startswith("60 configurations: ")


@pytest.mark.parametrize("shape", [(10_000,), (3, 3333), (700, 3, 5), (1, 9000)])
def test_blocks_leave_no_seam(shape):
    """More configurations than are solved at once are as a few at a time, with broadcast arguments too."""
    assert np.prod(shape) > BLOCK
    arm, q, tangent, wanted = random_arms("RRP", int(np.prod(shape)), seed=20)
    q[::7, 1], q[::7, 2] = 0.0, -arm.description.geometry.lengths[2]  # singular if the last slide is along the links
    q, tangent, wanted = q.reshape(*shape, 3), tangent.reshape(*shape, 2), wanted.reshape(shape)
    whole = speed_ratios(arm, q, tangent, wanted, 0.2)
    one_way = speed_ratios(arm, q, tangent.reshape(-1, 2)[0], wanted.flat[0])
    names = ("status", "count", "exact", "leading", "chosen", "rates", "ratios", "curvatures", "curvature_rates")
    flat, step = q.reshape(-1, 3), 1000
    for start in range(0, len(flat), step):
        part = slice(start, start + step)
        few = speed_ratios(arm, flat[part], tangent.reshape(-1, 2)[part], wanted.reshape(-1)[part], 0.2)
        same_way = speed_ratios(arm, flat[part], tangent.reshape(-1, 2)[0], wanted.flat[0])
        for name in (*names, "parabola", "pseudoinverse", "null"):
            for big, small in ((whole, few), (one_way, same_way)):
                got = getattr(big, name)
                np.testing.assert_array_equal(got.reshape(-1, *got.shape[len(shape) :])[part], getattr(small, name))
    assert set(np.unique(whole.count)) >= {1, 2}


def test_arguments_broadcast():
    arm = cr.load("ambike_3r")
    angles = np.linspace(0.0, 6.0, 7)
    tangents = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    found = speed_ratios(arm, EXAMPLE_1, tangents[:, None], [-1.0, 0.0, 2.0])
    assert found.rates.shape == (7, 3, 2, 3)
    assert found.discriminant.shape == (7, 3)
    assert found.reachable.shape == (7, 3, 2)
    np.testing.assert_array_equal(found.rates[3, 1], speed_ratios(arm, EXAMPLE_1, tangents[[3]], 0.0).rates[0])
    assert speed_ratios(arm, np.empty((0, 3)), [1, 0], 0.0).rates.shape == (0, 2, 3)
    for shape in ((0,), (5, 0), (0, 10_000)):
        none = speed_ratios(arm, np.empty((*shape, 3)), [1, 0], 0.0, leading=2)
        assert none.B.shape == (*shape, 6)
        assert none.parabola.shape == (*shape, 3)
        assert json.loads(json.dumps(none.to_dict()))["C"] == none.C.tolist()


def test_the_tangent_s_length_does_not_matter_and_the_inputs_are_not_kept():
    arm, q = cr.load("ambike_3r"), EXAMPLE_1.copy()
    found = speed_ratios(arm, q, [2e-300, 1e-300], -1.0)
    q[:] = 0.0
    other = speed_ratios(arm, EXAMPLE_1, [2e300, 1e300], -1.0)
    np.testing.assert_allclose(found.a, other.a, rtol=1e-12)
    np.testing.assert_allclose(found.rates, other.rates, rtol=1e-12)
    np.testing.assert_allclose(found.tangent, np.array([2.0, 1.0]) / np.sqrt(5.0), rtol=1e-15)
    assert speed_ratios(arm, EXAMPLE_1.astype(np.float32), [2, 1], -1).rates.dtype == np.float64
    assert speed_ratios(arm, [0, 1, 1], [2, 1], 1).exact in (True, False)


def test_the_result_is_plain_values():
    arm = cr.load("ambike_3r")
    for found in (
        speed_ratios(arm, EXAMPLE_1, [2, 1], -1.0),
        speed_ratios(arm, [0.3, 0.0, 0.0], [2, 1], -1.0),
        speed_ratios(arm, [EXAMPLE_1, EXAMPLE_1 * 0.0], [2, 1], -1.0),
    ):
        text = json.loads(json.dumps(found.to_dict(), allow_nan=False))
        assert text["arm"] == "ambike_3r"
        assert "status" in text
        assert "reason" in text
    one = speed_ratios(arm, EXAMPLE_1, [2, 1], -1.0)
    assert one.others == (2, 3)
    assert one.to_dict()["a"] == one.a.tolist()
    assert set(REASONS) == set(Status)
    with pytest.raises(cr.InputError, match="single"):
        speed_ratios(arm, [EXAMPLE_1], [2, 1], -1.0).others  # noqa: B018
    with pytest.raises(cr.InputError, match="indices"):
        one.explain(3)


NAN = float("nan")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("arm", [0.0, 1.0, 2.0], [1, 0], 0.0), "not an arm"),
        ((cr.load("panda"), [0.0] * 7, [1, 0], 0.0), "not planar"),
        ((cr.planar("RR", [1, 1]), [0.0, 1.0], [1, 0], 0.0), "2 joints.*second_order_ratios"),
        ((cr.planar("RRRR", [1, 1, 1, 1]), [0.0] * 4, [1, 0], 0.0), "4 joints.*speed_ratios_4"),
        ((cr.planar("R", [1]), [0.0], [1, 0], 0.0), "1 joint;"),
        ((None, [0.0, 1.0], [1, 0], 0.0), r"q has shape \(2,\)"),
        ((None, [0.0, 1.0, NAN], [1, 0], 0.0), r"q\[2\]: not a finite"),
        ((None, [0.0, 1.0, 1j], [1, 0], 0.0), "q: .*not numbers"),
        ((None, "abc", [1, 0], 0.0), "q: 'abc'"),
        ((None, [[1.0], [1.0, 2.0]], [1, 0], 0.0), "ragged"),
        ((None, [0.0, 1.0, 2.0], [1, 0, 0], 0.0), r"tangent has shape \(3,\)"),
        ((None, [0.0, 1.0, 2.0], [0, 0], 0.0), "length is 0"),
        ((None, [0.0, 1.0, 2.0], [[1, 0], [0, 0]], 0.0), r"tangent\[1\].*length is 0"),
        ((None, [0.0, 1.0, 2.0], [np.inf, 0], 0.0), r"tangent\[0\]: not a finite"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, [0.0, NAN]), r"curvature_rate\[1\]: not a finite"),
        ((None, [[0.0, 1.0, 2.0], [np.inf, 0.0, 0.0]], [1, 0], 0.0), r"q\[1, 0\]: not a finite"),
        ((None, [0.0, 0.0, 0.0], [0, 0], 0.0), "length is 0"),
        ((None, [NAN, 0.0, 0.0], [1, 0], 0.0), "q.0.: not a finite"),
        ((None, [0.0, 1.0, 2.0], [1, 0], NAN), "curvature: not a finite"),
        ((None, [0.0, 1.0, 2.0], [1, 0], [0.0, np.inf]), r"curvature\[1\]: not a finite"),
        ((None, [0.0, 1.0, 2.0], [1, 0], True), "curvature: True"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, "x"), "curvature_rate: 'x'"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, 0.0, 0), "leading: 0"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, 0.0, 4), "leading: 4"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, 0.0, True), "leading: True"),
        ((None, [0.0, 1.0, 2.0], [1, 0], 0.0, 0.0, "one"), "leading: 'one'"),
        ((None, np.zeros((2, 3)), np.ones((3, 2)), 0.0), "do not broadcast"),
        ((None, [0.0, 1.0, 2.0], [1, 0], [1e300, -1e300]), "overflow"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_line(arguments, words):
    arguments = (cr.load("ambike_3r") if arguments[0] is None else arguments[0], *arguments[1:])
    with np.errstate(over="ignore"), pytest.raises(cr.InputError, match=words) as refusal:
        speed_ratios(*arguments)
    assert "\n" not in str(refusal.value)


# ---- the command, the figures, the section of the report -------------------------------------------------------------


@pytest.fixture
def call(capsys):
    def run(*arguments):
        code = cli.run(["speed-ratios", *arguments])
        out, err = capsys.readouterr()
        return code, out, err

    return run


ASKED = ("ambike_3r", "--q=-14,-10,-205", "--deg", "--tangent", "2,1", "--curvature", "-1")


def test_the_command_answers_example_1(call, tmp_path):
    figure = tmp_path / "ratios.svg"
    code, out, err = call(*ASKED, "--json", "--figure", str(figure))
    assert (code, err) == (0, "")
    answer = json.loads(out)
    np.testing.assert_allclose(answer["ratios"], [[-0.0343, 3.0319], [-6.0402, -3.7154]], atol=0.6e-4)
    assert answer["chosen"] == 1
    assert answer["figure"] == str(figure)
    assert "<svg" in figure.read_text("utf-8")
    code, out, err = call(*ASKED, "--leading", "auto")
    assert (code, err) == (0, "")
    assert "The second is chosen" in out
    assert "pseudoinverse" in out


def test_the_command_takes_the_desired_change_and_says_no_at_a_singular_posture(call):
    code, out, _ = call(*ASKED, "--curvature-rate", "0.5", "--json")
    assert (code, json.loads(out)["chosen"]) == (0, 0)
    code, out, err = call("ambike_3r", "--q", "0.3,0,0", "--tangent", "1,0", "--curvature", "1")
    assert (code, err) == (1, "")
    assert "rank 1" in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("panda", "--q", "0,0,0", "--tangent", "1,0", "--curvature", "1"), "not planar"),
        (("ambike_3r", "--q", "0,0", "--tangent", "1,0", "--curvature", "1"), "--q: 2 numbers"),
        (("ambike_3r", "--q", "0,1,2", "--tangent", "1", "--curvature", "1"), "--tangent: 1 number given"),
        (("ambike_3r", "--q", "0,1,2", "--tangent", "0,0", "--curvature", "1"), "length is 0"),
        (("ambike_3r", "--q", "0,1,2", "--tangent", "1,0", "--curvature", "one"), "--curvature, entry 1"),
        (("ambike_3r", "--q", "0,1,2", "--tangent", "1,0", "--curvature", "1", "--leading", "0"), "--leading: '0'"),
        (("ambike_3r", "--q", "0,1,2", "--tangent", "1,0", "--curvature", "1", "--figure", "a.gif"), "a.gif"),
    ],
)
def test_the_command_refuses_in_one_line(call, arguments, words):
    code, out, err = call(*arguments)
    assert (code, out) == (2, "")
    assert words in err
    assert err.count("\n") == 1


def test_the_figure_states_the_finding():
    arm = cr.load("ambike_3r")
    met = draw_speed_ratios(speed_ratios(arm, EXAMPLE_1, [2, 1], -1.0))
    assert met.get_suptitle() == "The curvature −1 is met by two motions"
    far = draw_speed_ratios(speed_ratios(arm, np.radians([-14.0, -40.0, -205.0]), [1, 0.35], -1.0))
    assert far.get_suptitle() == "The curvature −1 is out of reach; −0.6812 is nearest"
    assert met.axes[0].get_xlim()[0] < -0.02  # the base is not cut in half
    drawn = [line for line in met.axes[0].lines if line.get_label() == "chosen"]
    x, y = drawn[0].get_data()
    bend = np.linalg.norm(
        np.stack([x, y], axis=1) - (arm.position(EXAMPLE_1) + np.array([1.0, -2.0]) / np.sqrt(5)), axis=1
    )
    assert abs(bend[len(bend) // 2 + 5] - 1.0) < 1e-3  # beside the tip, on the circle of radius 1


@pytest.mark.parametrize("kinds", MORPHOLOGIES)
def test_every_morphology_can_be_drawn(kinds):
    arm, q, tangent, wanted = random_arms(kinds, 1, seed=18)
    assert len(draw_speed_ratios(speed_ratios(arm, q[0], tangent[0], wanted[0])).axes) == 2
    assert "straight line" in draw_reachable(arm, q[0]).get_suptitle()


def test_what_is_singular_has_no_disc_but_a_figure():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    with pytest.raises(cr.InputError, match="singular"):
        draw_reachable(arm, [0.3, 0.0, 0.0])
    assert "singular" in draw_speed_ratios(speed_ratios(arm, [0.3, 0.0, 0.0], [1, 0], 0.0)).get_suptitle()


def test_the_report_s_share_is_counted_right():
    """By the parabola's own range, found with no code of the package."""
    arm = cr.load("ambike_3r")
    part = SECTION.build(arm, Context(arm))
    q = np.array(part.data["q"])
    jacobian = np.asarray(arm.jacobian(q))
    null, inverse = np.linalg.svd(jacobian)[2][2], np.linalg.pinv(jacobian)
    count = 0
    angles = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)
    for angle in angles:
        least = inverse @ [np.cos(angle), np.sin(angle)]
        k = [path(arm, q, least + z * null)[1] for z in (-1.0, 0.0, 1.0)]
        p2, p1, p0 = (k[0] + k[2]) / 2.0 - k[1], (k[2] - k[0]) / 2.0, k[1]
        count += p1**2 - 4.0 * p2 * p0 >= 0.0
    assert f"in {100.0 * count / 720:.0f} % of the directions" in part.data["finding"]
    assert json.dumps(part.data)
    assert SECTION.applies(arm)
    assert not SECTION.applies(cr.load("panda"))
    assert not SECTION.applies(cr.planar("RR", [1.0, 1.0]))
