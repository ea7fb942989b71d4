"""Higher-order speed ratios: the paths they make, by evaluation at 30 digits, and against exact inverse kinematics."""

from __future__ import annotations

import json
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import chainrule as cr
from chainrule.errors import InputError
from chainrule.higher_order import MotionRatios, motion_ratios, path_point

ARMS = {
    "RR": cr.planar("RR", [1.0, 0.8]),
    "RRR": cr.planar_3r(1.0, 0.8, 0.6),
    "RPR": cr.planar("RPR", [0.5, 0.8, 0.6], [0.0, 0.4, 0.0]),
}


def tip(arm: cr.Arm, q: Any) -> Any:
    """The tip as a complex number, in mpmath's precision: written from the definition of the chains."""
    shape = arm.description.geometry
    heading, place = mpmath.mpc(1), mpmath.mpc(0)
    for kind, length, turn, value in zip(arm.kinds, shape.lengths, shape.headings, q, strict=True):
        heading *= mpmath.expj(value if kind == "R" else turn)
        place += (length if kind == "R" else length + value) * heading
    return place


def wanted(start: Any, tangent: Any, curvature: float, rate: float, s: Any) -> Any:
    """The point of the clothoid of this curvature and rate at arc length s: its definition, integrated."""
    direction = mpmath.mpc(*tangent) / abs(mpmath.mpc(*tangent))
    return start + direction * mpmath.quad(lambda u: mpmath.expj(curvature * u + rate * u * u / 2), [0, s])


def measured_order(arm: cr.Arm, found: MotionRatios, tangent: Any, curvature: float, rate: float, along: bool) -> float:
    """The power of s with which the tip leaves the clothoid (or, not ``along`` it, leaves the curve itself)."""
    with mpmath.workdps(30):
        rows = [[mpmath.mpf(float(v)) for v in row] for row in (found.point.q, found.rates, found.second, found.third)]
        start = tip(arm, rows[0])
        errors = []
        for power in (5, 6):  # q(s) is accurate to 1e-16 s only, so s is not small
            s = mpmath.mpf(2) ** -power
            q = [a + b * s + c * s**2 / 2 + d * s**3 / 6 for a, b, c, d in zip(*rows, strict=True)]
            gap = tip(arm, q) - wanted(start, tangent, curvature, rate, s)
            if not along:
                ahead = mpmath.mpc(*tangent) / abs(mpmath.mpc(*tangent)) * mpmath.expj(curvature * s + rate * s**2 / 2)
                gap = mpmath.im(gap * mpmath.conj(ahead))
            errors.append(abs(gap))
        return float(mpmath.log(errors[0] / errors[1], 2))


def cases(kinds: str, count: int, seed: int) -> list[tuple[Any, ...]]:
    """Configurations away from singular ones, with a tangent, a curvature and its rate."""
    rng, arm, found = np.random.default_rng(seed), ARMS[kinds], []
    while len(found) < count:
        q = rng.uniform(-2.5, 2.5, arm.n) * [1.0 if kind == "R" else 0.3 for kind in kinds]
        if np.linalg.cond(arm.jacobian(q)) < 8.0:
            found.append((q, rng.normal(size=2), *rng.uniform(-1.5, 1.5, 2)))
    return found


@pytest.mark.parametrize("order", [2, 3])
@pytest.mark.parametrize("kinds", list(ARMS))
def test_the_tip_keeps_to_the_path(kinds: str, order: int) -> None:
    """The error falls with s^(order + 1) in the plane."""
    for q, tangent, curvature, rate in cases(kinds, 4, 1):
        found = motion_ratios(ARMS[kinds], q, tangent, curvature, rate, order=order)
        slope = measured_order(ARMS[kinds], found, tangent, curvature, rate, along=True)
        assert slope > order + 0.6, (slope, q)
        np.testing.assert_allclose(found.path[:order], [1.0, curvature, rate][:order], atol=1e-11)


@pytest.mark.parametrize("kinds", ["RRR", "RPR"])
def test_second_order_meets_the_rate_too(kinds: str) -> None:
    """With a joint to spare q'' alone keeps the tip to the curve to s^4, though along it only to s^3."""
    slopes = []
    for q, tangent, curvature, rate in cases(kinds, 6, 2):
        found = motion_ratios(ARMS[kinds], q, tangent, curvature, rate, order=2, second="rate")
        np.testing.assert_allclose(found.path[:3], [1.0, curvature, rate], atol=1e-9)
        assert not found.third.any()
        slopes.append(measured_order(ARMS[kinds], found, tangent, curvature, rate, along=False))
    assert np.median(slopes) > 3.6


def first_order(arm: cr.Arm, q: Any, tangent: Any, curvature: float) -> tuple[np.ndarray, np.ndarray]:
    """The unit-speed rates of constant ratios that meet the curvature, a parabola over the null space: real or not."""
    unit = np.array(tangent) / np.linalg.norm(tangent)
    jacobian, zero = arm.jacobian(q), np.zeros(3)
    least, null = np.linalg.pinv(jacobian) @ unit, np.linalg.svd(jacobian)[2][2]
    z = np.array([-1.0, 0.0, 1.0])
    rates = least + z[:, None] * null
    reached = [arm.evaluator("tip_motion")(q, arm.parameters, row, zero, zero)[1][1] for row in rates]
    roots = np.roots(np.polyfit(z, np.array(reached) - curvature, 2))
    return roots, least + roots.real[:, None] * null


def test_where_first_order_ratios_cannot_reach_the_curvature() -> None:
    """Ambike's second example: the discriminant is negative, and the curvature -1 is met all the same."""
    arm, q, tangent = cr.load("ambike_3r"), np.deg2rad([-14.0, -40.0, -205.0]), [0.9439, 0.3304]
    assert np.iscomplex(first_order(arm, q, tangent, -1.0)[0]).all()
    for order in (2, 3):
        np.testing.assert_allclose(motion_ratios(arm, q, tangent, -1.0, order=order).path[:2], [1.0, -1.0], atol=1e-11)
    np.testing.assert_allclose(motion_ratios(arm, q, tangent, -1.0, 0.3).path[2], 0.3, atol=1e-10)


def test_first_order_solutions_need_no_second_order() -> None:
    """Ambike's example 1: along a speed-ratio solution the curvature is met already, so q'' = 0."""
    arm, q = cr.load("ambike_3r"), np.deg2rad([-14.0, -10.0, -205.0])
    tangent = np.array([2.0, 1.0]) / np.sqrt(5.0)
    roots, both = first_order(arm, q, tangent, -1.0)
    assert np.isreal(roots).all()
    for rates in both:
        # any multiple of the ratios will do, also the paper's own digits
        found = motion_ratios(arm, q, tangent, -1.0, rates=-3.0 * rates / rates[0], order=2)
        np.testing.assert_allclose(found.rates, rates, atol=1e-9)
        # q'' changes the speed alone: the second-order ratios vanish
        np.testing.assert_allclose(found.ratios(1)[1], 0.0, atol=1e-8)
    printed = motion_ratios(arm, q, tangent, -1.0, rates=[1.0, -0.0343, 3.0319], order=2)
    np.testing.assert_allclose(printed.ratios(1)[1], 0.0, atol=0.01)
    np.testing.assert_allclose(printed.path[1], -1.0, atol=1e-11)


def inverse_2r(target: Any, lengths: tuple[float, float]) -> list[Any]:
    """Elbow-down posture of a planar 2R arm, by the cosine rule."""
    a, b = lengths
    x, y = target.real, target.imag
    q2 = mpmath.acos((x * x + y * y - a * a - b * b) / (2 * a * b))
    return [mpmath.atan2(y, x) - mpmath.atan2(b * mpmath.sin(q2), a + b * mpmath.cos(q2)), q2]


def test_two_joints_against_exact_inverse_kinematics() -> None:
    """dq/ds, d^2q/ds^2 and d^3q/ds^3 by differences of the exact postures along the clothoid."""
    arm, q, tangent, curvature, rate = ARMS["RR"], [0.4, 1.1], [0.5, -1.0], 1.2, 0.7
    found = motion_ratios(arm, q, tangent, curvature, rate)
    with mpmath.workdps(40):
        start = tip(arm, [mpmath.mpf(v) for v in q])

        def joint(i: int) -> Any:
            return lambda s: inverse_2r(wanted(start, tangent, curvature, rate, s), (1.0, 0.8))[i]

        h = mpmath.mpf(10) ** -8
        for order, ours in enumerate((found.rates, found.second, found.third), 1):
            exact = [float(mpmath.diff(joint(i), 0, order, h=h)) for i in (0, 1)]
            np.testing.assert_allclose(ours, exact, rtol=1e-7, atol=1e-9)
        # the ratios to the leading joint: the second joint as a function of the first, from the same exact postures
        n1, n2, n3 = found.ratios(leading=1)
        first = [float(mpmath.diff(joint(0), 0, k, h=h)) for k in (1, 2, 3)]
        second = [float(mpmath.diff(joint(1), 0, k, h=h)) for k in (1, 2, 3)]
    np.testing.assert_allclose([n1[0], n2[0], n3[0]], [1.0, 0.0, 0.0], atol=1e-9)
    # theta_2(theta_1(s)) and the chain rule upwards give back the derivatives by s
    a, b, c = first
    np.testing.assert_allclose(
        [n1[1] * a, n2[1] * a**2 + n1[1] * b, n3[1] * a**3 + 3 * n2[1] * a * b + n1[1] * c], second, rtol=1e-6
    )


def test_ratios_are_the_series_of_one_joint_in_another() -> None:
    """Ambike's (1): theta_i = n_i t + n_i^(2) t^2/2 + n_i^(3) t^3/6 with t the leading joint's move, to t^4."""
    q, tangent, curvature, rate = cases("RRR", 1, 3)[0]
    found = motion_ratios(ARMS["RRR"], q, tangent, curvature, rate)
    for leading in (1, 2, 3):
        n1, n2, n3 = found.ratios(leading)
        errors = []
        for s in (0.02, 0.01):
            move = found.at([s])[0] - q
            t = move[leading - 1]
            errors.append(np.abs(n1 * t + n2 * t**2 / 2 + n3 * t**3 / 6 - move).max())
        assert errors[1] < errors[0] / 12.0 or errors[0] < 1e-13


@given(turn=st.floats(-3.0, 3.0), size=st.floats(0.2, 5.0), curvature=st.floats(-2.0, 2.0), rate=st.floats(-2.0, 2.0))
def test_invariances(turn: float, size: float, curvature: float, rate: float) -> None:
    """Turning the base changes nothing; an arm ``size`` times as large moves with each derivative scaled by it."""
    q, tangent = np.array([0.3, 0.9, -1.3]), np.array([0.6, 0.8])
    one = motion_ratios(ARMS["RRR"], q, tangent, curvature, rate)
    c, s = np.cos(turn), np.sin(turn)
    turned = motion_ratios(
        ARMS["RRR"], q + np.array([turn, 0.0, 0.0]), [c * 0.6 - s * 0.8, s * 0.6 + c * 0.8], curvature, rate
    )
    large = motion_ratios(cr.planar_3r(size, 0.8 * size, 0.6 * size), q, tangent, curvature / size, rate / size**2)
    mirrored = motion_ratios(ARMS["RRR"], -q, tangent * [1, -1], -curvature, -rate)
    for power, name in ((1, "rates"), (2, "second"), (3, "third")):
        value = getattr(one, name)
        scale = 1e-9 * (1.0 + np.abs(value).max())
        np.testing.assert_allclose(getattr(turned, name), value, atol=scale)
        np.testing.assert_allclose(getattr(large, name) * size**power, value, atol=scale)
        np.testing.assert_allclose(getattr(mirrored, name), -value, atol=scale)


def test_batches() -> None:
    """Leading axes broadcast, and a batch is its members."""
    rows = cases("RRR", 6, 4)
    q = np.array([row[0] for row in rows]).reshape(2, 3, 3)
    tangent = np.array([1.0, 0.5])
    many = motion_ratios(ARMS["RRR"], q, tangent, [0.1, 0.2, 0.3], 0.4, second="rate")
    assert many.third.shape == (2, 3, 3)
    assert many.path.shape == (2, 3, 4)
    assert many.at([0.0, 0.1]).shape == (2, 3, 2, 3)
    for i in range(2):
        for j in range(3):
            one = motion_ratios(ARMS["RRR"], q[i, j], tangent, [0.1, 0.2, 0.3][j], 0.4, second="rate")
            np.testing.assert_allclose(many.third[i, j], one.third, atol=1e-9 * (1 + np.abs(one.third).max()))
            np.testing.assert_allclose(many.ratios(2)[1][i, j], one.ratios(2)[1], rtol=1e-8, atol=1e-9)
    empty = motion_ratios(ARMS["RRR"], np.zeros((0, 3)), tangent, 0.0)
    assert empty.rates.shape == (0, 3)
    assert len(empty.ratios(1)) == 3
    assert json.loads(json.dumps(many.to_dict()))["order"] == 3


def test_refusals() -> None:
    arm, q = ARMS["RRR"], [0.3, 0.9, -1.3]
    still = np.array([0.0, 0.7, -0.4])  # joint 1 stands still
    tangent = arm.jacobian(q) @ still
    motion = motion_ratios(arm, q, tangent, 0.0, rates=still)
    for call, words in (
        (lambda: motion_ratios(cr.load("panda"), np.zeros(7), [1, 0], 0.0), "known for planar arms"),
        (lambda: motion_ratios(arm, q[:2], [1, 0], 0.0), r"q has shape \(2,\)"),
        (lambda: motion_ratios(arm, q, [1, 0, 0], 0.0), r"tangent has shape \(3,\)"),
        (lambda: motion_ratios(arm, q, [0, 0], 0.0), r"tangent: \(0, 0\)"),
        (lambda: motion_ratios(arm, q, [1, 0], np.inf), "curvature: inf; finite"),
        (lambda: motion_ratios(arm, q, [1, 0], "tight"), "curvature: 'tight'; an array"),
        (lambda: motion_ratios(arm, q, [1, 0], 1e200), "curvature: 1e.200 is too large"),
        (lambda: motion_ratios("planar_3r", q, [1, 0], 0.0), "arm: 'planar_3r'; an arm"),  # type: ignore[arg-type]
        (lambda: motion_ratios(arm, q, [1, 0], 0.0, order=3.0), "order: 3.0"),  # type: ignore[arg-type]
        (lambda: motion_ratios(arm, q, [1, 0], 0.0, order=np.array([2, 3])), "order"),  # type: ignore[arg-type]
        (lambda: motion.at([np.nan]), r"s\[0\]: nan"),
        (lambda: motion.at(0.1), "s: shape"),
        (lambda: motion.ratios(1.5), "no joint 1.5"),  # type: ignore[arg-type]
        (lambda: motion.ratios(True), "no joint True"),
        (lambda: motion_ratios(arm, [q, q], np.ones((3, 2)), 0.0), "do not broadcast"),
        (lambda: motion_ratios(arm, q, [1, 0], 0.0, order=4), "order: 4 is not known"),
        (lambda: motion_ratios(arm, q, [1, 0], 0.0, second="most"), "'least' and 'rate' are accepted"),
        (lambda: motion_ratios(arm, [0.3, 0.0, 0.0], [1, 0], 0.0), "singular"),
        (lambda: motion_ratios(arm, [q, [0.3, 0.0, 0.0]], [1, 0], 0.0), "configuration 1: singular"),
        (lambda: motion_ratios(arm, q, tangent[::-1], 0.0, rates=still), "off the tangent|along the tangent"),
        (lambda: motion_ratios(arm, q, [1, 0], 0.0, rates=[1, 2]), r"rates has shape \(2,\)"),
        (lambda: motion_ratios(ARMS["RR"], [0.1, 1.0], [1, 0], 0.0, second="rate"), "needs a joint to spare"),
        (lambda: motion_ratios(cr.planar("PPP", [1, 1, 1], [0, 1, 1]), q, [1, 0], 0.0, second="rate"), "no q''"),
        (lambda: motion_ratios(cr.planar("R", [1.0]), [0.1], [1, 0], 0.0), "two joints or more"),
        (lambda: motion.ratios(0), "no joint 0"),
        (lambda: motion.ratios(1), "joint 1 stands still; joint 2 moves"),
    ):
        with pytest.raises(InputError, match=words) as caught:
            call()
        assert "\n" not in str(caught.value)
    assert motion.ratios(2)[0][0] == pytest.approx(0.0, abs=1e-12)


def test_path_point_is_left_handed_nowhere() -> None:
    """The normal is the tangent turned left."""
    point = path_point(ARMS["RR"], [0.1, 0.2], [3.0, 4.0], curvature=0.0)
    np.testing.assert_allclose(point.normal, [-0.8, 0.6])


def test_orders_are_drawn() -> None:
    """The title states the measured powers: 2, 3 and 4 for the first, second and third order."""
    from dataclasses import replace

    from chainrule.plot.higher_order import draw_orders

    arm, q, tangent = cr.load("ambike_3r"), np.deg2rad([-14.0, -40.0, -205.0]), [0.9439, 0.3304]
    third = motion_ratios(arm, q, tangent, -1.0, 0.2)
    second = motion_ratios(arm, q, tangent, -1.0, 0.2, order=2)
    first = replace(second, second=np.zeros(3))
    figure = draw_orders(arm, {"first order": first, "second": second, "third": third})
    assert "s², s³, s⁴" in figure.axes[0].get_title(loc="left")
