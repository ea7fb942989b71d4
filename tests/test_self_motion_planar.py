"""Self-motion of planar 3R arms: against counting on a grid, quadrature with 30 digits, and what must not change."""

from __future__ import annotations

import itertools
import math
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from scipy import ndimage

import chainrule as cr
from chainrule.derive import catalogue
from chainrule.derive import self_motion_planar_3r as theory
from chainrule.derive.program import evaluate, needed
from chainrule.description import planar_model
from chainrule.errors import InputError
from chainrule.self_motions.maps import self_motion_map
from chainrule.self_motions.planar_3r import planar_lengths, planar_self_motion, singular_radii, singular_values

PAPER = (0.40, 0.35, 0.25)
TURN = 2.0 * math.pi
TASKS = ("position", "x_alpha")


def arm_of(lengths):
    return cr.planar_3r(*lengths)


def lengths_of(found):
    return [part.length for part in found.components]


# ---- the derivation ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("task", TASKS)
def test_the_closed_form_follows_from_the_arm(task):
    """Every identity it rests on is 0 as a polynomial in the sines and cosines, modulo s^2 + c^2 = 1."""
    arm = catalogue.symbolic(planar_model("RRR"))
    unit = {}
    for joint in arm.inputs[0].symbols:
        s, c = sp.symbols(f"s_{joint} c_{joint}")
        unit[joint] = (s, c)
    for name, identity in theory.identities(arm, task).items():
        if name == "elliptic parameter":
            assert sp.cancel(sp.together(identity)) == 0
            continue
        flat = sp.expand(sp.expand_trig(identity))
        plain = flat.subs({f(j): p for j, pair in unit.items() for f, p in zip((sp.sin, sp.cos), pair, strict=True)})
        rest = sp.expand(plain)
        for s, c in unit.values():
            rest = sp.rem(rest, s**2 + c**2 - 1, s)
        assert sp.expand(rest) == 0, name


def test_sums_stand_for_what_they_are_named_after():
    """The differences of the roots, formed of the sums, are those of the definitions."""
    lengths, r = sp.symbols("l1:4", positive=True), sp.Symbol("r", positive=True)
    l1, l2, l3 = lengths
    roots = {
        "position": ((l1 + l2) ** 2, (l1 - l2) ** 2, (r + l3) ** 2, (r - l3) ** 2),
        "x_alpha": (l1, -l1, r + l2, r - l2),
    }
    for task, values in roots.items():
        named = dict(zip("ABCE", values, strict=True))
        found = theory.differences(task, lengths, r, theory.exact_sums(task, lengths, r))
        for pair, difference in found.items():
            assert sp.expand(named[pair[0]] - named[pair[1]] - difference) == 0


@pytest.mark.parametrize(("complement", "accuracy"), [(0.7, 1e-50), (1e-3, 1e-50), (1e-9, 1e-40), (1e-15, 1e-24)])
def test_landen_transformations_give_jacobis_functions(complement, accuracy):
    """tan phi from the derivation's fixed number of steps, evaluated exactly, against mpmath's elliptic functions."""
    arm = catalogue.symbolic(planar_model("RRR"))
    program = needed(theory.turn(arm, "x_alpha"))
    with mpmath.workdps(90):  # the reference loses twice the digits of the gap
        # x_alpha with l1 = l2 = 1: a - b and c - d are |sums[2]| and |sums[3]|, b - c the smallest of the rest
        gap = mpmath.mpf(complement)
        sums = [2, 2, gap, -gap, 2, 2, 2, 2]
        k2 = 1 - (gap / (gap + 2)) ** 2
        for theta in (0.1, 0.8, 1.5, 1.57, 2.4):
            node = [mpmath.cos(theta), mpmath.sin(theta)]
            given = {"node": node, "reach": [0], "sums": sums, "parameters": [1, 1, 0]}
            c, s = evaluate(program, given, 80)["phi"]
            u = theta * 2 * mpmath.ellipk(k2) / mpmath.pi
            sn, cn = mpmath.ellipfun("sn", u, m=k2), mpmath.ellipfun("cn", u, m=k2)
            tangent = mpmath.sqrt(gap / (gap + 2)) * sn / cn
            assert abs(s / c / tangent - 1) < accuracy


# ---- numbers of curves --------------------------------------------------------------------------------------------


def counted_on_a_grid(lengths, value, task, size=300):
    """Connected components of a level set on the torus of two joints: cells in which the function changes sign."""
    angle = (np.arange(size) + 0.37) * TURN / size
    first, second = np.meshgrid(angle, angle, indexing="ij")
    l1, l2, l3 = lengths
    if task == "position":  # q1 follows from q2 and q3 wherever the target is not the base
        level = np.abs(l1 + np.exp(1j * first) * (l2 + l3 * np.exp(1j * second))) - value
    else:
        level = l1 * np.cos(first) + l2 * np.cos(second) - value
    above = level > 0
    corners = sum(np.roll(above, shift, (0, 1)).astype(int) for shift in itertools.product((0, -1), repeat=2))
    cells, number = ndimage.label((corners > 0) & (corners < 4), np.ones((3, 3)))
    joined = list(range(number + 1))

    def root(k):
        while joined[k] != k:
            k = joined[k]
        return k

    for a, b in ((cells[0], cells[-1]), (cells[:, 0], cells[:, -1])):
        for shift in (-1, 0, 1):
            for i, j in zip(a, np.roll(b, shift), strict=True):
                if i and j:
                    joined[root(i)] = root(j)
    return len({root(k) for k in range(1, number + 1)})


@pytest.mark.parametrize("task", TASKS)
def test_counts_against_a_grid(task):
    rng = np.random.default_rng(5)
    seen = set()
    for _ in range(45):
        lengths = rng.uniform(0.15, 1.0, 3)
        alpha = rng.uniform(-3, 3)
        reach = rng.uniform(0.0, 1.3) * (lengths.sum() if task == "position" else lengths[:2].sum())
        singular = singular_radii(lengths) if task == "position" else np.abs(singular_values([*lengths[:2], 0.0], 0.0))
        if np.abs(singular - reach).min() < 0.04:  # too near for the grid
            continue
        turn = rng.uniform(-3, 3)
        target = [reach * math.cos(turn), reach * math.sin(turn)]
        if task == "x_alpha":
            target = [reach + lengths[2] * math.cos(alpha), alpha]
        found = planar_self_motion(arm_of(lengths), target, task)
        assert found.count == counted_on_a_grid(lengths, reach, task)
        assert found.status == ("regular" if found.count else "unreachable")
        seen.add(found.count)
    assert seen == {0, 1, 2}


def test_the_papers_regions():
    """Figures 2 and 4: 2, 1, 2, 1 curves cut at 0.2, 0.3, 0.5, 1; for x_alpha four singular values about l3."""
    arm = arm_of(PAPER)
    np.testing.assert_allclose(singular_radii(PAPER), [0.2, 0.3, 0.5, 1.0], rtol=1e-15)
    np.testing.assert_allclose(singular_values(PAPER, 0.0), [-0.5, 0.2, 0.3, 1.0], rtol=1e-15)
    for x, number in ((0.1, 2), (0.25, 1), (0.4, 2), (0.7, 1), (1.1, 0)):
        for target in ([x, 0.0], [-x, 0.0], [0.0, x], [0.6 * x, -0.8 * x]):
            assert planar_self_motion(arm, target).count == number
    for x, number in ((-0.6, 0), (-0.1, 1), (0.25, 2), (0.21, 2), (0.4, 1), (1.1, 0)):
        assert planar_self_motion(arm, [x, 0.0], "x_alpha").count == number
    # the sign of q2 is kept beside that of q3 in A, and that of q1 from the target's direction beside q2's in C
    assert set(planar_self_motion(arm, [0.1, 0.0]).components[0].signs) == {"q2", "q3", "q2+q3"}
    kept = set(planar_self_motion(arm, [0.4, 0.0]).components[0].signs)
    assert kept == {"q2", "q1-direction", "q1+q2-direction"}
    # x_alpha: sin q1 is kept for l1 > l2, sin(q1 + q2) for l1 < l2
    assert set(planar_self_motion(arm, [0.25, 0.0], "x_alpha").components[0].signs) == {"q1"}
    swapped = planar_self_motion(arm_of((0.35, 0.40, 0.25)), [0.25, 0.0], "x_alpha")
    assert set(swapped.components[0].signs) == {"q1+q2"}


# ---- lengths against 30 digits ------------------------------------------------------------------------------------


def quadrature(lengths, value, task):
    """Length of all curves together, at more than 30 digits: the last link's heading (x_alpha: the second's) swept over
    half a turn, two branches of the others, ds from the signed minors; the tanh-sinh rule for the ends' roots.

    A parameter, formulas and arithmetic of its own.
    """
    before, ctx.prec = ctx.prec, 330
    try:
        l1, l2, l3, r = (arb(float(x)) for x in (*lengths, value))
        if task == "position":  # cos(heading) where the first two links reach the last joint
            bounds = [(r * r + l3 * l3 - (l1 + s * l2) ** 2) / (2 * r * l3) for s in (1, -1)]
        else:
            bounds = [(r - l1) / l2, (r + l1) / l2]
        low, high = (b if abs(b) < 1 else arb(1 if b > 0 else -1) for b in bounds)
        if high <= low:
            return None
        first, last = high.acos(), low.acos()  # the heading rises from the first to the last
        middle, half = (first + last) / 2, (last - first) / 2
        step, total = arb(1) / 48, arb(0)
        for k in range(-235, 236):
            t = step * k
            inner = arb.pi() / 2 * t.sinh()
            weight = arb.pi() / 2 * t.cosh() / inner.cosh() ** 2
            heading = middle + half * inner.tanh()
            parts = [pace(l1, l2, l3, r, heading, sign, task) for sign in (1, -1)]
            total += weight * sum(parts)
        return float(2 * half * step * total)
    finally:
        ctx.prec = before


def pace(l1, l2, l3, r, heading, sign, task):
    """ds/d heading."""
    c, s = heading.cos(), heading.sin()
    if task == "x_alpha":  # y of link 1 is +- the root; q1', q2', q3' = l2 s, -l1 s1 - l2 s, l1 s1
        x = r - l2 * c
        radicand = (l1 - x) * (l1 + x)
        if float(radicand) < NEGLIGIBLE:
            return arb(0)
        y = sign * radicand.sqrt()
        n = (l2 * s, -y - l2 * s, y)
        return (sum(e * e for e in n)).sqrt() / abs(n[2])
    wx, wy = r - l3 * c, -l3 * s
    square = wx * wx + wy * wy
    radicand = ((l1 + l2) ** 2 - square) * (square - (l1 - l2) ** 2)
    if float(radicand) < NEGLIGIBLE:
        return arb(0)
    root = radicand.sqrt()
    along, across = (square + l1 * l1 - l2 * l2) / (2 * square), sign * root / (2 * square)
    x1, y1 = along * wx + across * wy, along * wy - across * wx  # l1 e1
    x2, y2 = wx - x1, wy - y1
    x3, y3 = l3 * c, l3 * s
    rates = (x2 * y3 - y2 * x3, x3 * y1 - y3 * x1, x1 * y2 - y1 * x2)  # of the headings
    n = (rates[0], rates[1] - rates[0], rates[2] - rates[1])
    return (sum(e * e for e in n)).sqrt() / abs(rates[2])


#: Radicands so small stand at the ends of the sweep, where the tanh-sinh rule's weights are below 1e-80.
NEGLIGIBLE = 1e-80

NEAR = [side * 10.0**-k for k in (3, 6, 9) for side in (1, -1)]
QUADRATURE = [
    *((PAPER, x, "position") for x in (0.1, 0.25, 0.4, 0.7, 0.999)),
    *((PAPER, edge + gap, "position") for edge in (0.2, 0.3, 0.5) for gap in NEAR[2:]),
    *((PAPER, x, "x_alpha") for x in (0.02, 0.4, -0.7)),
    *((PAPER, 0.05 + gap, "x_alpha") for gap in NEAR),
    *((PAPER, edge, "position") for edge in (0.2, 0.3)),  # as doubles, some 1e-17 from a radius
    *(((4.0, 3.0, 2.0), math.nextafter(edge, side), "position") for edge in (1.0, 3.0, 5.0) for side in (0.0, 9.0)),
    ((4.0, 3.0, 2.0), math.nextafter(9.0, 0.0), "position"),
    ((1.0, 1.0, 1.0), 1.0 + 1e-9, "position"),
    ((1.0, 1.0, 1.0), 1.0 - 1e-9, "position"),
    ((0.4, 0.4, 0.1), 0.1 + 1e-9, "position"),
    ((1.0, 0.1, 1.0), 0.5, "position"),
    ((0.05, 1.0, 0.6), 1.3, "position"),
    ((1.0, 0.9, 1e-3), 1.8996, "position"),
    ((0.2, 0.3, 1.1), 0.9, "position"),
]


@cache
def known_length(lengths, value, task):
    return quadrature(lengths, value, task)


@pytest.mark.parametrize(("lengths", "value", "task"), QUADRATURE)
def test_lengths_against_thirty_digits(lengths, value, task):
    """To 1e-10 relative, also 1e-9 m from a singular radius."""
    expected = known_length(lengths, value, task)
    arm = arm_of((*lengths[:2], 0.0) if task == "x_alpha" else lengths)
    target = [value, math.pi / 2 if task == "x_alpha" else 0.0]
    found = planar_self_motion(arm, target, task)
    assert found.length == pytest.approx(expected, rel=1e-10)
    quick = planar_lengths(arm, target, task)[1]
    assert math.fsum(quick) == pytest.approx(expected, rel=1e-10)
    mapped = self_motion_map(arm, target, task)
    assert float(mapped.total) == pytest.approx(expected, rel=1e-10)


# ---- points, boxes, ranges ----------------------------------------------------------------------------------------

SAMPLES = [
    (PAPER, [0.1, 0.05], "position"),
    (PAPER, [-0.2, 0.15], "position"),
    (PAPER, [0.0, -0.4], "position"),
    (PAPER, [0.7, 0.1], "position"),
    (PAPER, [0.3 + 1e-9, 0.0], "position"),
    ((0.25, 0.4, 0.35), [0.4, 0.0], "position"),
    ((0.35, 0.25, 0.4), [0.4, 0.0], "position"),
    ((1.0, 1.0, 1.0), [0.5, -0.2], "position"),
    (PAPER, [0.25, 0.1], "x_alpha"),
    (PAPER, [-0.1, 2.0], "x_alpha"),
    ((0.35, 0.4, 0.2), [0.2, 0.4], "x_alpha"),
    (PAPER, [0.6, -0.5], "x_alpha"),
]


@pytest.mark.parametrize(("lengths", "target", "task"), SAMPLES)
def test_points_lie_on_the_curve_evenly(lengths, target, task):
    arm = arm_of(lengths)
    found = planar_self_motion(arm, target, task, points=4001)
    for part in found.components:
        q = part.q
        if task == "position":
            assert np.abs(arm.position(q) - target).max() < 1e-13 * sum(lengths)
        else:
            assert np.abs(arm.position(q)[:, 0] - target[0]).max() < 1e-14
            assert np.abs(np.sin((q.sum(axis=1) - target[1]) / 2.0)).max() < 1e-13
        chords = np.linalg.norm(np.diff(q, axis=0), axis=1)
        assert chords.sum() == pytest.approx(part.length, rel=1e-3 if found.to_singular < 1e-6 else 1e-5)
        assert chords.max() <= part.length / 4000 * (1 + 1e-9)
        np.testing.assert_allclose(q[-1] - q[0], TURN * part.winding, rtol=0, atol=1e-12)
        assert part.residual < 1e-13 and part.closed and part.closure == 0.0
        # H, and its extremes
        h = arm.manipulability(q, task=task)
        low, high = part.manipulability
        assert low <= h.min() * (1 + 1e-9) and h.max() <= high * (1 + 1e-12)
        if found.to_singular > 1e-3:
            assert low == pytest.approx(h.min(), rel=1e-4) and high == pytest.approx(h.max(), rel=1e-5)
        # the box holds the points tightly; a joint that winds spans a turn
        slack = 2e-2 if found.to_singular < 1e-6 else 1e-5
        assert (part.box[:, 0] <= q.min(axis=0) + 1e-12).all() and (q.max(axis=0) <= part.box[:, 1] + 1e-12).all()
        assert np.abs(part.box - np.stack([q.min(axis=0), q.max(axis=0)], axis=-1)).max() < slack
        spans = part.box[:, 1] - part.box[:, 0]
        np.testing.assert_allclose(spans[part.winding != 0], TURN, rtol=1e-14)


def test_the_range_of_h_is_that_of_the_curve_to_ten_digits():
    """Against a dense grid, and a denser one about its extremes."""
    arm = arm_of(PAPER)
    for target in ([0.1, 0.0], [0.25, 0.0], [0.4, 0.0], [0.7, 0.0]):
        part = planar_self_motion(arm, target).components[0]
        h = arm.manipulability(part.at(np.linspace(0.0, 1.0, 6001)[:-1]))
        for found, sign in zip(part.manipulability, (-1.0, 1.0), strict=True):
            near = (int((sign * h).argmax()) + np.linspace(-1.0, 1.0, 1001)) / 6000
            assert found == pytest.approx(sign * (sign * arm.manipulability(part.at(near))).max(), rel=1e-10)


def test_the_shortest_link_turns():
    """Grashof: of four links one can turn round only if it is the shortest; signs between the others are kept."""
    rng = np.random.default_rng(8)
    turning = {0: [1, -1, 0], 1: [0, 1, -1], 2: [0, 0, 1], 3: [1, 0, 0]}
    seen = set()
    for _ in range(60):
        lengths, reach = rng.uniform(0.2, 1.0, 3), rng.uniform(0.1, 2.0)
        found = planar_self_motion(arm_of(lengths), [0.0, reach])
        if found.count == 1:
            assert not found.components[0].winding.any() and not found.components[0].signs
        if found.count == 2:
            shortest = int(np.argmin([*lengths, reach]))
            first, second = found.components
            assert abs(first.winding @ turning[shortest]) == first.winding @ first.winding
            assert (first.winding == -second.winding).all()
            assert len(first.signs) == 3 and second.signs == {name: -sign for name, sign in first.signs.items()}
            for name, sign in first.signs.items():
                q = first.q - [math.pi / 2, 0.0, 0.0]  # the target's direction is pi / 2
                parts = [int(letter) - 1 for letter in name.replace("-direction", "").replace("q", "").split("+")]
                assert (np.sign(np.sin(q[:, parts].sum(axis=1))) == sign).all()
            seen.add(shortest)
    assert seen == {0, 1, 2, 3}


# ---- what must not change -----------------------------------------------------------------------------------------


def random_cases(count, seed):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        lengths = tuple(rng.uniform(0.1, 1.0, 3))
        yield lengths, rng.uniform(-0.6, 0.6, 2) * sum(lengths), rng


def test_scale_mirror_rotation_and_order():
    for lengths, target, rng in random_cases(25, 3):
        found = planar_lengths(arm_of(lengths), target)
        size = 10.0 ** rng.uniform(-40, 40)
        scaled = planar_lengths(arm_of([size * length for length in lengths]), size * target)
        assert scaled[0] == found[0] and scaled[1] == pytest.approx(found[1], rel=1e-11)
        assert planar_lengths(arm_of(lengths), target * [1, -1])[1] == pytest.approx(found[1], rel=1e-12)
        turn = rng.uniform(-3, 3)
        turned = target @ [[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]
        assert planar_lengths(arm_of(lengths), turned)[1] == pytest.approx(found[1], rel=1e-9)
        # the chain run from its tip: (q3, q2, q1) mirrored, the sum of all angles in place of the target's direction
        for order in itertools.permutations(lengths):
            status, parts = planar_lengths(arm_of(order), target)
            assert (status, len(parts)) == (found[0], len(found[1]))
    for task in TASKS:
        # links 1 and 2 exchanged are the same parallelogram for x_alpha in (a1, a2), with q1 and q3 exchanged
        one = planar_lengths(arm_of((0.5, 0.3, 0.2)), [0.2 if task == "x_alpha" else 0.3, 0.0], task)[1]
        other = planar_lengths(
            arm_of((0.3, 0.5, 0.2) if task == "x_alpha" else (0.5, 0.3, 0.2)),
            [0.2 if task == "x_alpha" else 0.3, 0.0],
            task,
        )[1]
        assert one == pytest.approx(other, rel=1e-12)


def test_equal_links_may_change_places():
    """Arms whose second and third (or first and second) lengths are equal, nearly equal, or exchanged by rounding."""
    for lengths in ((0.5, 0.3, 0.3), (0.3, 0.3, 0.5), (1.0, 1.0, 1.0)):
        for reach in (0.21, 0.4, 0.62):
            exact = planar_lengths(arm_of(lengths), [reach, 0.0])
            for k in range(3):
                moved = list(lengths)
                moved[k] = math.nextafter(moved[k], 2.0)
                near = planar_lengths(arm_of(moved), [reach, 0.0])
                assert near[0] == exact[0] and near[1] == pytest.approx(exact[1], rel=1e-9)


# ---- singular and degenerate --------------------------------------------------------------------------------------


def test_figures_of_eight():
    """At each inner radius, decided exactly for doubles; total length against quadrature and against both sides."""
    arm = arm_of((4.0, 3.0, 2.0))
    np.testing.assert_array_equal(singular_radii([2.0, 4.0, 3.0]), [1.0, 3.0, 5.0, 9.0])
    for target in ([1.0, 0.0], [3.0, 0.0], [0.0, 5.0], [-3.0, 4.0]):
        found = planar_self_motion(arm, target)
        assert (found.status, found.detail, found.count) == ("singular", "figure of eight", 2)
        assert found.to_singular == 0.0
        radius = math.hypot(*target)
        first, second = lengths_of(found)
        assert first == pytest.approx(second, rel=1e-12)
        assert found.length == pytest.approx(quadrature((4.0, 3.0, 2.0), radius, "position"), rel=1e-10)
        for part in found.components:
            assert part.closed and part.residual < 1e-14 * 9.0 and part.manipulability[0] < 1e-12
            assert arm.manipulability(part.q[0]) < 1e-12
        for beside in (1 - 1e-9, 1 + 1e-9):
            near = planar_self_motion(arm, np.multiply(target, beside))
            assert near.status == "regular"
            assert near.length == pytest.approx(found.length, rel=1e-4)  # a cusp like a square root
    for target, x in (([1.0, math.pi / 2], 1.0), ([-1.0, math.pi / 2], -1.0)):
        found = planar_self_motion(arm_of((4.0, 3.0, 0.0)), target, "x_alpha")
        assert (found.status, found.detail, found.count) == ("singular", "figure of eight", 2)
        assert found.length == pytest.approx(quadrature((4.0, 3.0, 0.0), x, "x_alpha"), rel=1e-10)


def test_a_radius_is_exact_in_the_doubles():
    """0.4, 0.35, 0.25 as doubles have no radius that is the double 0.3; the last place of the target decides."""
    assert planar_self_motion(arm_of(PAPER), [0.3, 0.0]).status == "regular"
    arm = arm_of((4.0, 3.0, 2.0))
    for beside, number in ((math.nextafter(3.0, 0.0), 1), (math.nextafter(3.0, 4.0), 2)):
        found = planar_self_motion(arm, [beside, 0.0])
        assert (found.status, found.count) == ("regular", number)
        assert found.length == pytest.approx(planar_self_motion(arm, [3.0, 0.0]).length, rel=1e-6)
    assert planar_self_motion(arm, [math.nextafter(9.0, 10.0), 0.0]).status == "unreachable"
    inside = planar_self_motion(arm, [math.nextafter(9.0, 0.0), 0.0])
    assert inside.status == "regular" and inside.count == 1 and 0.0 < inside.length < 1e-6


def test_isolated_points():
    for lengths, target in (
        ((4.0, 3.0, 2.0), [9.0, 0.0]),
        ((9.0, 3.0, 2.0), [0.0, 4.0]),
        ((2.0, 9.0, 3.0), [-4.0, 0.0]),
    ):
        arm = arm_of(lengths)
        found = planar_self_motion(arm, target)
        assert (found.status, found.detail, found.count, found.length) == ("singular", "isolated point", 1, 0.0)
        (part,) = found.components
        assert part.q.shape == (1, 3) and not part.closed
        np.testing.assert_allclose(arm.position(part.q[0]), target, atol=1e-14)
        assert arm.manipulability(part.q[0]) < 1e-13
        assert planar_self_motion(arm, np.multiply(target, 0.5)).count == (0 if max(lengths) == 9.0 else 2)


def test_equal_links():
    """Radii collapse; singular sets with two and three crossings, cut into arcs there."""
    np.testing.assert_array_equal(singular_radii([1.0, 1.0, 1.0]), [1.0, 3.0])
    np.testing.assert_array_equal(singular_radii([2.0, 1.0, 2.0]), [1.0, 3.0, 5.0])
    whole = {}
    for lengths in ((1.0, 1.0, 1.0), (2.0, 2.0, 1.0), (2.0, 1.0, 2.0), (1.0, 2.0, 2.0)):
        arm = arm_of(lengths)
        found = planar_self_motion(arm, [0.0, 1.0])
        three = lengths[0] == lengths[1] == lengths[2]
        assert found.status == "singular" and ("three" if three else "two") in found.detail
        assert found.count == (6 if three else 4)
        for part in found.components:
            assert part.residual < 1e-13
            ends = np.abs(np.sin(part.q[[0, -1]] - [math.pi / 2, 0.0, 0.0])).max()
            assert ends < 1e-12  # from one flat posture to another
            assert part.ends == ("singular", "singular")
            assert part.closed or np.abs(np.sin((part.q[-1] - part.q[0]) / 2.0)).max() > 0.5
            chords = np.linalg.norm(np.diff(part.at(np.linspace(0, 1, 2001)), axis=0), axis=1)
            assert chords.sum() == pytest.approx(part.length, rel=1e-5)
        whole[lengths] = found.length
        for beside in (1 - 1e-10, 1 + 1e-10):
            assert planar_self_motion(arm, [0.0, beside]).length == pytest.approx(found.length, rel=1e-4)
    for lengths, length in whole.items():
        # the sweep of the last link misses the curve on which it stands still, e1 = -e2
        still = TURN * math.sqrt(2.0) if lengths[0] == lengths[1] else 0.0
        assert length == pytest.approx(quadrature(lengths, 1.0, "position") + still, rel=1e-10)


def test_the_first_joint_is_free_at_the_base_point():
    arm = arm_of(PAPER)
    found = planar_self_motion(arm, [0.0, 0.0])
    assert (found.status, found.detail, found.count) == ("regular", "free first joint", 2)
    for part in found.components:
        assert part.length == pytest.approx(TURN, rel=1e-14)
        assert part.winding.tolist() == [1, 0, 0] and np.ptp(part.q[:, 1:], axis=0).max() < 1e-14
        assert part.residual < 1e-15
    near = planar_self_motion(arm, [1e-9, 0.0])
    np.testing.assert_allclose(lengths_of(near), lengths_of(found), rtol=1e-8)
    assert planar_self_motion(arm_of((1.0, 0.3, 0.2)), [0.0, 0.0]).status == "unreachable"
    flat = planar_self_motion(arm_of((3.0, 2.0, 1.0)), [0.0, 0.0])
    assert flat.status == "singular" and flat.count == 1 and "every posture singular" in flat.detail
    assert flat.length == pytest.approx(TURN)


def test_links_of_length_zero():
    free = {0: math.sqrt(2.0), 1: math.sqrt(2.0), 2: 1.0}
    for k, speed in free.items():
        lengths = [0.7, 0.5, 0.4]
        lengths[k] = 0.0
        arm = arm_of(lengths)
        others = sorted(length for length in lengths if length)
        found = planar_self_motion(arm, [0.0, 0.6])
        assert (found.status, found.count) == ("regular", 2)
        assert found.detail == f"link {k + 1} of length 0"
        for part in found.components:
            assert part.length == pytest.approx(TURN * speed, rel=1e-14) and part.residual < 1e-14
        tiny = [length or 1e-9 for length in lengths]
        near = planar_self_motion(arm_of(tiny), [0.0, 0.6])
        np.testing.assert_allclose(lengths_of(near), lengths_of(found), rtol=1e-7)
        assert planar_self_motion(arm, [others[0] + others[1] + 1e-9, 0.0]).status == "unreachable"
    line = planar_self_motion(arm_of((2.0, 0.0, 1.0)), [3.0, 0.0])
    assert line.status == "singular" and line.length == pytest.approx(TURN * math.sqrt(2.0))
    surface = planar_self_motion(arm_of((1.0, 0.0, 0.0)), [0.0, 1.0])
    assert (surface.status, surface.count) == ("singular", 0) and "surface" in surface.detail
    assert planar_self_motion(arm_of((1.0, 0.0, 0.0)), [0.0, 1.1]).status == "unreachable"
    assert "dimension 3" in planar_self_motion(arm_of((0.0, 0.0, 0.0)), [0.0, 0.0]).detail
    assert planar_self_motion(arm_of((0.0, 0.0, 0.0)), [0.0, 1.0]).status == "unreachable"
    for lengths, speed in (((0.0, 1.0, 0.3), math.sqrt(2.0)), ((1.0, 0.0, 0.3), math.sqrt(2.0))):
        found = planar_self_motion(arm_of(lengths), [0.5, 1.0], "x_alpha")
        assert found.count == 2 and found.length == pytest.approx(2 * TURN * speed)
        assert max(part.residual for part in found.components) < 1e-14


# ---- joint limits -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("lengths", "target", "task"), SAMPLES)
def test_arcs_and_what_is_excluded_make_the_whole(lengths, target, task):
    """Limits on one joint and the complementary ones: the arcs together are the whole curve, for every curve."""
    rng = np.random.default_rng(11)
    for joint in range(3):
        for _ in range(2):
            low = rng.uniform(-3.0, 3.0)
            high = low + rng.uniform(0.5, 5.5)
            parts = []
            for bounds in ((low, high), (high, low + TURN)):
                limits = [None, None, None]
                limits[joint] = bounds
                parts.append(planar_self_motion(arm_of(lengths).with_limits(position=limits), target, task))
            for k, whole in enumerate(parts[0].components):
                arcs = [arc for found in parts for arc in found.feasible if arc.of == k]
                assert math.fsum(arc.length for arc in arcs) == pytest.approx(whole.length, rel=2e-9)


@pytest.mark.parametrize(("lengths", "target", "task"), SAMPLES)
def test_feasible_arcs_against_samples(lengths, target, task):
    rng = np.random.default_rng(12)
    limited = arcs = 0
    curve = planar_self_motion(arm_of(lengths), target, task).components[0]
    for _ in range(2):
        centre, half = curve.at(rng.uniform()) + rng.uniform(-0.4, 0.4, 3), rng.uniform(0.6, 2.8, 3)
        limits = np.stack([centre - half, centre + half], axis=-1)
        arm = arm_of(lengths).with_limits(position=limits)
        found = planar_self_motion(arm, target, task)
        for k, whole in enumerate(found.components):
            q = whole.at((np.arange(4000) + 0.5) / 4000)
            turned = q - TURN * np.floor((q - limits[:, 0]) / TURN)  # narrower than a turn: at most one value fits
            share = (turned <= limits[:, 1]).all(axis=1)
            mine = [arc for arc in found.feasible if arc.of == k]
            assert math.fsum(arc.length for arc in mine) / whole.length == pytest.approx(share.mean(), abs=2e-3)
            limited += not share.all()
            for arc in mine:
                arcs += 1
                assert (arc.q >= limits[:, 0] - 1e-8).all() and (arc.q <= limits[:, 1] + 1e-8).all()
                assert arc.residual < 1e-12
                dense = arc.at(np.linspace(0.0, 1.0, 1001))
                seen = np.stack([dense.min(axis=0), dense.max(axis=0)], axis=-1)
                assert (arc.box[:, 0] <= seen[:, 0] + 1e-9).all() and (seen[:, 1] <= arc.box[:, 1] + 1e-9).all()
                assert np.abs(arc.box - seen).max() < (2e-2 if found.to_singular < 1e-6 else 1e-4)
                steps = np.linalg.norm(np.diff(arc.q, axis=0), axis=1)
                assert steps.sum() == pytest.approx(arc.length, rel=2e-2)
                if arc.closed:
                    assert k in found.surviving and arc.length == pytest.approx(whole.length, rel=1e-12)
                    continue
                assert arc.span[1] - arc.span[0] == pytest.approx(arc.length / whole.length, rel=1e-9)
                for reason, place in zip(arc.ends, (arc.q[0], arc.q[-1]), strict=True):
                    joint, side = int(reason.split()[3]) - 1, 1 if "upper" in reason else 0
                    assert place[joint] == pytest.approx(limits[joint, side], abs=1e-7)
    assert limited and arcs


def test_a_whole_loop_survives_wide_limits_unless_a_joint_winds():
    arm = arm_of(PAPER)
    whole = planar_self_motion(arm, [0.7, 0.0]).components[0]
    inside = planar_self_motion(arm.with_limits(position=[*(whole.box + np.array([-1e-9, 1e-9]))]), [0.7, 0.0])
    assert inside.surviving == (0,) and inside.feasible[0].closed
    # a stop exactly at an extreme of a joint is only touched
    touched = planar_self_motion(arm.with_limits(position=[None, tuple(whole.box[1]), None]), [0.7, 0.0])
    assert math.fsum(part.length for part in touched.feasible) == pytest.approx(whole.length, rel=1e-6)
    short = planar_self_motion(arm.with_limits(position=[None, (whole.box[1, 0] + 1e-3, 3.0), None]), [0.7, 0.0])
    assert not short.surviving and len(short.feasible) == 1
    # whole turns away is inside too
    moved = planar_self_motion(arm.with_limits(position=[*(whole.box + TURN)]), [0.7, 0.0])
    assert math.fsum(part.length for part in moved.feasible) == pytest.approx(whole.length, rel=1e-6)
    # a joint that winds meets its stops, at most after more than a round
    for width, rounds in ((TURN - 0.5, None), (2.5 * TURN, 2.5)):
        found = planar_self_motion(arm.with_limits(position=[(-1.0, -1.0 + width), None, None]), [0.1, 0.0])
        assert not found.surviving and len(found.feasible) == 2
        for arc in found.feasible:
            assert arc.q[:, 0].min() == pytest.approx(-1.0) and arc.q[:, 0].max() == pytest.approx(-1.0 + width)
            assert set(arc.ends) == {"limit of joint 1 (lower)", "limit of joint 1 (upper)"}
            if rounds:
                whole_loop = found.components[arc.of].length
                assert 2.0 * whole_loop < arc.length < 3.0 * whole_loop
    assert planar_self_motion(arm.with_limits(position=[(0.1, 0.1), None, None]), [0.1, 0.0]).feasible == ()


def test_limits_of_singular_self_motions():
    """Arcs of a figure of eight, circles, and an isolated point."""
    limits = [(-1.5, 1.4), (-2.2, 2.4), (-2.0, 2.6)]
    arm = arm_of((4.0, 3.0, 2.0)).with_limits(position=limits)
    bounds = np.array(limits)
    for target in ([3.0, 0.0], [5.0, 0.0], [9.0, 0.0]):
        found = planar_self_motion(arm, target)
        assert found.feasible
        for arc in found.feasible:
            assert (arc.q >= bounds[:, 0] - 1e-8).all() and (arc.q <= bounds[:, 1] + 1e-8).all()
        for k, whole in enumerate(found.components):
            if whole.length:
                q = whole.at((np.arange(4000) + 0.5) / 4000)
                turned = q - TURN * np.floor((q - bounds[:, 0]) / TURN)
                share = (turned <= bounds[:, 1]).all(axis=1).mean()
                mine = math.fsum(arc.length for arc in found.feasible if arc.of == k)
                assert mine / whole.length == pytest.approx(share, abs=2e-3)
    free = arm_of(PAPER).with_limits(position=[(-1.0, 2.0), (-3.0, 3.0), (-3.0, 3.0)])
    for arc in planar_self_motion(free, [0.0, 0.0]).feasible:
        assert arc.length == pytest.approx(3.0) and arc.box[0].tolist() == pytest.approx([-1.0, 2.0])
    away = arm_of((4.0, 3.0, 2.0)).with_limits(position=[(0.1, 1.0), None, None])
    assert planar_self_motion(away, [9.0, 0.0]).feasible == ()


# ---- maps ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("task", TASKS)
def test_maps_agree_with_single_targets(task):
    rng = np.random.default_rng(21)
    lengths = np.round(rng.uniform(0.0, 1.0, (6, 1, 3)), 1)
    targets = np.concatenate([rng.uniform(-1.5, 1.5, (20, 2)), [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0]]])
    found = self_motion_map(lengths, targets, task)
    assert found.number.shape == (6, 23) and found.box.shape == (6, 23, 3, 2)
    for i, j in np.ndindex(6, 23):
        single = planar_self_motion(arm_of(lengths[i, 0]), targets[j], task)
        assert found.words[i, j] == single.status and found.number[i, j] == single.count
        if single.count:
            assert found.total[i, j] == pytest.approx(single.length, rel=1e-10)
        else:
            assert np.isnan(found.length[i, j])
        if single.status == "regular":
            apart = found.box[i, j] - single.components[0].box
            np.testing.assert_allclose(apart, TURN * np.rint(apart / TURN), rtol=0, atol=1e-9)
    assert self_motion_map(arm_of(PAPER), np.empty((0, 2)), task).number.shape == (0,)
    row = found.to_dict()
    assert row["number"][0][0] == int(found.number[0, 0])


# ---- hostile input ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("target", "words"),
    [
        ([math.nan, 0.0], "target"),
        ([math.inf, 0.0], "target"),
        ([1.0], "target"),
        ([1.0, 2.0, 3.0], "target"),
        ("here", "target"),
        ([[0.1, 0.0]], "self_motion_map"),
        ([1.0 + 2.0j, 0.0], "target"),
        (None, "target"),
        ([[1.0], [2.0, 3.0]], "target"),
        ([1.7e308, 1.7e308], "target"),
    ],
)
def test_targets_that_are_refused(target, words):
    for call in (planar_self_motion, planar_lengths):
        with pytest.raises(InputError, match=words) as refusal:
            call(arm_of(PAPER), target)
        assert "\n" not in str(refusal.value)


def test_arms_and_tasks_that_are_refused():
    with pytest.raises(InputError, match="negative"):
        planar_self_motion(arm_of((0.4, -0.3, 0.2)), [0.1, 0.0])
    with pytest.raises(InputError, match="three revolute"):
        planar_self_motion(cr.planar("RPR", [0.4, 0.3, 0.2], [0.0, 0.5, 0.0]), [0.1, 0.0])
    with pytest.raises(InputError, match="not a planar arm"):
        planar_self_motion("planar_3r", [0.1, 0.0])
    with pytest.raises(InputError, match="task"):
        planar_self_motion(arm_of(PAPER), [0.1, 0.0], "pose")
    with pytest.raises(InputError, match="points"):
        planar_self_motion(arm_of(PAPER), [0.1, 0.0], points=1)
    for accuracy in (0.0, math.nan, 1, "high"):
        with pytest.raises(InputError, match="accuracy"):
            planar_lengths(arm_of(PAPER), [0.1, 0.0], accuracy=accuracy)
    with pytest.raises(InputError, match="lengths"):
        self_motion_map([0.1, 0.2], [0.1, 0.0])
    with pytest.raises(InputError, match="broadcast"):
        self_motion_map(np.ones((3, 3)), np.ones((2, 2)))
    with pytest.raises(InputError, match="negative"):
        self_motion_map([0.1, -0.2, 0.3], [0.1, 0.0])
    with pytest.raises(InputError, match="lengths"):
        singular_radii([0.1, math.nan, 0.2])
    with pytest.raises(InputError, match="turns"):
        wide = [(-1e5, 1e5)] * 3
        planar_self_motion(arm_of((0.25, 0.4, 0.35)).with_limits(position=wide), [0.4, 0.0])
