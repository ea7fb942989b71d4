"""Following paths at constant joint rates: what is promised of a stretch, of every method, and of a whole path."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest

import chainrule as cr
from chainrule.cli import run
from chainrule.errors import InputError
from chainrule.following import Followed, follow
from chainrule.following_compared import compare, random_arms, study, study_paths
from chainrule.papers.ambike_following import EXAMPLES, example, rows_following
from chainrule.parametric_paths import Curve, Ellipse, Spline
from chainrule.paths import Circle, Line, Path
from chainrule.stretches import (
    END,
    LIMIT,
    METHODS,
    STUCK,
    TOLERANCE,
    TURNED,
    Arcs,
    Chains,
    choose,
    predicted_travel,
    stand,
    stretch,
)

FREE = np.tile([-np.inf, np.inf], (3, 1))
KINDS = ("RRR", "RRP", "RPR", "PRR", "RPP", "PRP", "PPR", "PPP")
ARM = cr.planar_3r(1.0, 0.8, 0.6)


def tip(kinds: str, parameters: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The tip of planar chains, from the definition: R turns by q, P by its heading; l or l + q onward."""
    heading, place, turning = np.zeros(q.shape[:-1]), np.zeros(q.shape[:-1], complex), 3
    for i, kind in enumerate(kinds):
        if kind == "R":
            heading, advance = heading + q[..., i], parameters[..., i]
        else:
            heading, advance = heading + parameters[..., turning], parameters[..., i] + q[..., i]
            turning += 1
        place = place + advance * np.exp(1j * heading)
    return np.stack([place.real, place.imag], axis=-1)


def off_circle(points: np.ndarray, start: np.ndarray, tangent: np.ndarray, curvature: np.ndarray) -> np.ndarray:
    """Distances of points (k, m, 2) from circles (k,): from the centre, not as the code does it."""
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    centre = start + normal / curvature[:, None]
    return np.abs(np.linalg.norm(points - centre[:, None], axis=2) - 1.0 / np.abs(curvature)[:, None])


def cases(kinds: str, count: int, seed: int = 0) -> tuple[Chains, np.ndarray, np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    chains, q = random_arms(random, count, kinds, None)
    angle = random.uniform(-np.pi, np.pi, count)
    curvature = random.choice([-1.0, 1.0], count) * 10.0 ** random.uniform(-0.7, 0.7, count)
    return chains, q, np.stack([np.cos(angle), np.sin(angle)], axis=1), curvature


def tracks(chains: Chains, q: np.ndarray, tangent: np.ndarray, curvature: np.ndarray) -> Arcs:
    return Arcs(chains.tip(q), tangent, curvature, 2.0 * np.pi / np.abs(curvature))


# ---- one stretch -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kinds", KINDS)
@pytest.mark.parametrize("tolerance", [0.05, 0.001])
def test_a_stretch_ends_at_the_tolerance_and_never_passes_it(kinds: str, tolerance: float) -> None:
    chains, q, tangent, curvature = cases(kinds, 50)
    arcs, zero, margin = tracks(chains, q, tangent, curvature), np.zeros(50), np.full(50, tolerance)
    case = stand(chains, q, arcs.at(zero), margin)
    for method in ("pseudoinverse", "speed_ratio", "two_term"):
        rates, found = choose(case, arcs, zero, method)
        moved = found.ended != STUCK
        t = found.t[:, None] * np.linspace(0.0, 1.0, 801)
        points = tip(kinds, chains.parameters[:, None], q[:, None] + rates[:, None] * t[..., None])
        off = off_circle(points, arcs.start, tangent, curvature)
        rounding = 1e-13 * np.maximum(1.0, np.abs(points).max(axis=(1, 2)))
        assert np.all((off <= tolerance * (1.0 + 1e-11) + rounding[:, None])[moved])
        ended = moved & (found.ended == TOLERANCE)
        assert np.all(np.abs(off[ended, -1] - tolerance) <= 1e-11 * tolerance + rounding[ended])
        assert np.all(np.abs(off[moved, -1] - np.abs(found.offset[moved])) <= 2.0 * rounding[moved])
        # where it ended by turning back, the tip has stopped to go along the path
        turned = np.nonzero(found.ended == TURNED)[0]
        for k in turned:
            frame = arcs.take(np.array([k])).at(found.s[[k]])
            first, last = points[k, 1] - points[k, 0], points[k, -1] - points[k, -2]
            assert abs(last @ frame.tangent[0]) < 0.01 * np.linalg.norm(first)
        assert np.all(np.isin(found.ended[moved], [TOLERANCE, TURNED, END]))


def test_the_first_crossing_is_found() -> None:
    """By bisection between dense samples of the distance, for the paper's arm."""
    q, random = np.random.default_rng(3).uniform(-np.pi, np.pi, (40, 3)), np.random.default_rng(4)
    arm = cr.load("ambike_3r")
    angle = random.uniform(-np.pi, np.pi, 40)
    tangent, curvature = np.stack([np.cos(angle), np.sin(angle)], axis=1), random.choice([-1.0, 1.0], 40)
    found = compare(arm, q, tangent, curvature, 0.025)
    lengths = np.broadcast_to(arm.parameters, (40, 3))
    start = tip("RRR", lengths, q)
    for m in range(len(found.methods)):
        rates = found.rates[:, m]

        def distance(t: np.ndarray, rates: np.ndarray = rates) -> np.ndarray:
            points = tip("RRR", lengths[:, None], q[:, None] + rates[:, None] * t[..., None])
            return off_circle(points, start, tangent, curvature)

        t = 1.05 * found.duration[:, m, None] * np.linspace(0.0, 1.0, 4001)
        over = distance(t) >= 0.025
        first = over.argmax(axis=1)
        use = over.any(axis=1) & (found.ended[:, m] == TOLERANCE)
        assert use.sum() > 25
        low, high = (
            np.take_along_axis(t, np.maximum(first - 1, 0)[:, None], 1),
            np.take_along_axis(t, first[:, None], 1),
        )
        for _ in range(60):
            middle = 0.5 * (low + high)
            past = distance(middle) >= 0.025
            low, high = np.where(past, low, middle), np.where(past, middle, high)
        assert found.duration[use, m] == pytest.approx(high[use, 0], rel=1e-9)


def test_joint_limits_end_a_stretch() -> None:
    chains, q, tangent, curvature = cases("RRR", 200, seed=2)
    room = 0.02
    tight = Chains("RRR", chains.evaluator, chains.parameters, np.stack([q[0] - room, q[0] + room], axis=1))
    q = np.broadcast_to(q[0], q.shape)
    arcs, zero = tracks(tight, q, tangent, curvature), np.zeros(200)
    rates, found = choose(stand(tight, q, arcs.at(zero), np.full(200, 0.05)), arcs, zero, "pseudoinverse")
    limited = found.ended == LIMIT
    assert limited.sum() > 20
    ending = q + rates * found.t[:, None]
    assert np.all(np.abs(ending - q[0]) <= room + 1e-12)
    assert np.abs(ending - q[0])[limited].max(axis=1) == pytest.approx(room, rel=1e-9)


def test_no_excursion_is_missed() -> None:
    """With a large self-motion added the tip whirls: loops out of the tolerance and back would be short."""
    chains, q, tangent, curvature = cases("RRR", 120, seed=8)
    arcs, zero, margin = tracks(chains, q, tangent, curvature), np.zeros(120), np.full(120, 0.03)
    least = stand(chains, q, arcs.at(zero), margin).rates.least
    jacobian = chains.evaluator("jacobian_position")(q, chains.parameters)
    null = np.cross(jacobian[:, 0], jacobian[:, 1])
    null *= (np.linalg.norm(least, axis=1) / np.linalg.norm(null, axis=1))[:, None]
    for share in (-30.0, 5.0, 100.0):
        rates = least + share * null
        found = stretch(chains, arcs, q, zero, rates, margin)
        t = found.t[:, None] * np.linspace(0.0, 1.0, 3001)
        points = tip("RRR", chains.parameters[:, None], q[:, None] + rates[:, None] * t[..., None])
        assert off_circle(points, arcs.start, tangent, curvature).max() <= 0.03 * (1.0 + 1e-9)


def test_predicted_travel_against_polynomial_roots() -> None:
    random = np.random.default_rng(0)
    first, second = random.normal(size=400), random.normal(size=400) * 10.0 ** random.uniform(-2, 2, 400)
    tolerance = 10.0 ** random.uniform(-4, -1, 400)
    found = predicted_travel(first, second, tolerance)
    for a, b, e, s in zip(first, second, tolerance, found, strict=True):
        roots = [np.roots([b / 6.0, a / 2.0, 0.0, sign * e]) for sign in (1.0, -1.0)]
        real = [z.real for z in np.concatenate(roots) if abs(z.imag) < 1e-9 * abs(z) and z.real > 0.0]
        assert s == pytest.approx(min(real), rel=1e-6)


def test_predicted_travel_of_a_swing() -> None:
    """With c2 = -(1.5 e c3^2)^(1/3) the swing just touches the tolerance; the end is 1.6777 times its place."""
    tolerance, second = 0.01, 3.0
    touching = -((1.5 * tolerance * second**2) ** (1.0 / 3.0))
    peak = -2.0 * touching / second
    far = float(predicted_travel(0.999 * touching, second, tolerance))
    near = float(predicted_travel(1.001 * touching, second, tolerance))
    end = np.roots([2.0, -3.0, 0.0, -1.0]).real.max() * peak
    assert far == pytest.approx(end, rel=2e-3) and near == pytest.approx(peak, rel=0.05)
    assert float(predicted_travel(0.9 * touching, second, tolerance, swing=0.5)) < far
    straight = float((6.0 * tolerance / second) ** (1.0 / 3.0))
    assert far > 2.0 * straight  # twice as far as with no first term at all
    assert predicted_travel(0.0, 0.0, 0.01) == np.inf


# ---- methods ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kinds", ["RRR", "RPR"])
def test_looking_ahead_is_never_worse(kinds: str) -> None:
    for tolerance in (0.02, 0.001):
        found = study(250, tolerance, kinds=kinds, seed=5).comparison
        for other in ("pseudoinverse", "speed_ratio", "two_term"):
            assert np.all(found.of("look_ahead") >= found.of(other) * (1.0 - 1e-9))


def test_methods_follow_the_tangent_at_unit_speed() -> None:
    found = compare(ARM, [0.3, 0.9, -0.7], [1.0, 2.0], 0.8, 0.003)
    direction = np.array([1.0, 2.0]) / np.sqrt(5.0)
    for rates, curvature in zip(found.rates, found.curvature, strict=True):
        h = 1e-4
        points = tip("RRR", ARM.parameters, np.array([0.3, 0.9, -0.7]) + rates * np.array([[-h], [0.0], [h]]))
        velocity = (points[2] - points[0]) / (2.0 * h)
        bend = (points[2] - 2.0 * points[1] + points[0]) / h**2
        assert velocity == pytest.approx(direction, abs=1e-6)
        assert velocity[0] * bend[1] - velocity[1] * bend[0] == pytest.approx(curvature, abs=1e-5)
    assert np.linalg.norm(found.rates[0]) == pytest.approx(np.linalg.norm(found.rates, axis=1).min())
    if found.discriminant >= 0.0:
        assert found.curvature[1] == pytest.approx(0.8)


def test_the_offset_has_the_predicted_terms() -> None:
    """Halving a small tolerance: travel grows as tolerance^(1/2) with a first term, as tolerance^(1/3) without."""
    q, tangent = np.radians(EXAMPLES["figure 1"][0]), EXAMPLES["figure 1"][1]
    arm = cr.load("ambike_3r")
    small, smaller = (compare(arm, q, tangent, -1.0, e) for e in (8e-9, 1e-9))
    assert small.of("pseudoinverse") / smaller.of("pseudoinverse") == pytest.approx(8.0**0.5, rel=5e-3)
    assert small.of("speed_ratio") / smaller.of("speed_ratio") == pytest.approx(2.0, rel=5e-3)
    for found in (small, smaller):
        assert found.travel[:2] == pytest.approx(found.predicted[:2], rel=5e-3)
        assert found.of("two_term") > 1.3 * found.of("speed_ratio")


@pytest.mark.parametrize("method", METHODS)
def test_mirror_turn_and_scale(method: Any) -> None:
    q, tangent, curvature, e = np.array([0.4, 1.1, -0.8]), np.array([0.6, 0.8]), 0.9, 0.004
    plain = compare(ARM, q, tangent, curvature, e, methods=(method,))
    mirrored = compare(ARM, -q, tangent * [1.0, -1.0], -curvature, e, methods=(method,))
    assert mirrored.travel == pytest.approx(plain.travel, rel=1e-9)
    assert mirrored.rates == pytest.approx(-plain.rates, rel=1e-6)
    c, s = np.cos(0.7), np.sin(0.7)
    turned = compare(ARM, q + np.array([0.7, 0.0, 0.0]), [[c, -s], [s, c]] @ tangent, curvature, e, methods=(method,))
    assert turned.travel == pytest.approx(plain.travel, rel=1e-9)
    bigger = cr.planar_3r(2.0, 1.6, 1.2)
    scaled = compare(bigger, q, tangent, curvature / 2.0, 2.0 * e, methods=(method,))
    assert scaled.travel == pytest.approx(2.0 * plain.travel, rel=1e-9)


def test_backwards_is_the_same_choice() -> None:
    """dk/ds does not change when the tangent turns round, the curvature changes sign: rates change sign."""
    q = [0.4, 1.1, -0.8]
    ahead = compare(ARM, q, [0.6, 0.8], 0.9, 0.004, methods=("pseudoinverse", "speed_ratio"))
    back = compare(ARM, q, [-0.6, -0.8], -0.9, 0.004, methods=("pseudoinverse", "speed_ratio"))
    assert back.rates == pytest.approx(-ahead.rates, abs=1e-9)


def test_comparison_broadcasts() -> None:
    q = np.random.default_rng(0).uniform(-1.0, 1.0, (4, 1, 3))
    found = compare(ARM, q, [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], 0.5, 0.01)
    assert found.travel.shape == (4, 3, 4) and found.rates.shape == (4, 3, 4, 3) and found.roots.shape == (4, 3, 2)
    single = compare(ARM, q[2, 0], [1.0, 1.0], 0.5, 0.01)
    assert single.travel == pytest.approx(found.travel[2, 2], rel=1e-9)
    assert json.loads(json.dumps(single.to_dict()))["methods"] == list(METHODS)
    empty = compare(ARM, np.empty((0, 3)), [1.0, 0.0], 0.5, 0.01)
    assert empty.travel.shape == (0, 4)


def test_singular_postures_do_not_move() -> None:
    found = compare(ARM, [0.3, 0.0, 0.0], [1.0, 0.0], 1.0, 0.01)
    assert np.all(found.travel == 0.0) and np.all(found.predicted == 0.0)
    assert np.all(found.ended == STUCK)


# ---- the paper -------------------------------------------------------------------------------------------------


def test_the_papers_examples() -> None:
    """Figures 1 and 2: the distance of 0.025 is reached later by the speed ratio, by a computation of its own."""
    for figure, (degrees, direction) in EXAMPLES.items():
        found = example(figure)
        q, tangent = np.radians(degrees), np.array(direction) / np.hypot(*direction)
        lengths = np.array([1.15, 1.5, 1.8])
        start = tip("RRR", lengths, q)
        for rates, duration, travel in zip(found.rates, found.duration, found.travel, strict=True):
            points = tip("RRR", lengths, q + rates * duration)
            centre = start + np.array([tangent[1], -tangent[0]])
            ray = points - centre
            assert abs(np.hypot(*ray) - 1.0) == pytest.approx(0.025, rel=1e-9)
            first = start - centre
            turned = -np.arctan2(first[0] * ray[1] - first[1] * ray[0], first @ ray)  # to the right
            assert turned == pytest.approx(travel, rel=1e-9)
        assert found.of("speed_ratio") > found.of("pseudoinverse")


def test_rows_for_reproduce() -> None:
    rows = rows_following()
    assert all(row.good for row in rows)
    assert {row.where for row in rows} >= {"figure 1", "figure 2", "example 2"}


def test_the_claim_over_many_arms() -> None:
    """Bounds well outside the scatter of 500 cases: the shares are those of the mechanism, not of the sample."""
    facts = [study(500, tolerance, lengths=(1.0, 0.5, 0.25), seed=3).to_dict() for tolerance in (0.025, 0.0005)]
    assert 0.10 < facts[0]["worse"] < 0.25 and facts[1]["worse"] < 0.10 < facts[0]["median"]
    assert facts[0]["median"] > 1.1 and facts[1]["median"] > facts[0]["median"]
    for fact in facts:
        assert 1.0 <= fact["median_not_met"] < 1.06 and fact["median_met"] > 1.5
        assert fact["look_ahead_worse"] == 0.0
        assert fact["better_root_missed"] > 0
    assert facts[0]["winner_predicted"] > 0.8 and facts[1]["winner_predicted"] > 0.97


def test_a_study_is_the_same_for_the_same_seed() -> None:
    one, two, other = (study(20, 0.01, seed=seed) for seed in (4, 4, 5))
    assert np.array_equal(one.comparison.travel, two.comparison.travel)
    assert not np.array_equal(one.comparison.travel, other.comparison.travel)
    assert one.quantiles("speed_ratio").shape == (5,)


def test_nothing_to_choose_with_three_prismatic_joints() -> None:
    found = study(100, 0.01, kinds="PPP", seed=1).comparison
    assert found.travel == pytest.approx(np.broadcast_to(found.travel[:, :1], found.travel.shape), rel=1e-9)
    assert found.of("pseudoinverse") == pytest.approx(np.arccos(1.0 / 1.01), rel=1e-6)  # straight off a unit circle


def test_whole_paths_need_fewer_updates() -> None:
    loops = study_paths(Circle((0.0, 0.0), 0.3), 10, 0.004, seed=2)
    assert loops.updates.shape == (10, 4)
    facts = loops.to_dict()["methods"]
    assert facts["look_ahead"]["median_ratio"] < facts["speed_ratio"]["median_ratio"] < 1.0


# ---- whole paths -----------------------------------------------------------------------------------------------

PATHS: dict[str, Callable[[], Path]] = {
    "circle": lambda: Circle((1.2, 0.3), 0.4, clockwise=True),
    "ellipse": lambda: Ellipse((1.2, 0.3), (0.6, 0.3), rotation=0.4),
    "closed spline": lambda: Spline([(1.0, 0.0), (1.4, 0.3), (1.2, 0.8), (0.6, 0.9), (0.4, 0.5)], closed=True),
    "open spline": lambda: Spline([(1.0, 0.0), (1.4, 0.3), (1.2, 0.8), (0.6, 0.9)]),
    "line": lambda: Line((0.5, 0.5), (1.8, 0.2)),
}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", sorted(PATHS))
def test_whole_path(name: str, method: Any) -> None:
    path, tolerance = PATHS[name](), 0.01
    found = follow(ARM, path, tolerance, method=method)
    check(found, path, tolerance)
    assert found.status == "finished" and found.followed == pytest.approx(path.length)
    assert found.ended[-1] == "end of the path"
    assert found.updates == len(found.q) - 1 > 0
    assert json.loads(json.dumps(found.to_dict()))["updates"] == found.updates


def test_a_path_that_crosses_itself() -> None:
    eight = Curve(
        lambda u: np.stack([1.3 + 0.4 * np.sin(u), 0.3 * np.sin(2.0 * u)], axis=-1), 0.2, 0.2 + 2.0 * np.pi, closed=True
    )
    found = follow(ARM, eight, 0.02, method="speed_ratio")
    check(found, eight, 0.02)
    assert found.status == "finished" and found.followed == pytest.approx(eight.length)


def check(found: Followed, path: Path, tolerance: float) -> None:
    """What is promised of every run: on the path after an update, within the tolerance all along, no gap."""
    lengths = np.asarray(ARM.parameters)
    begins = tip("RRR", lengths, found.q)
    assert begins == pytest.approx(path.point(found.s[:-1]), abs=1e-12)
    assert np.all(np.diff(found.s) > 0.0)
    ends = tip("RRR", lengths, found.q_end)
    near = path.nearest(ends, near=found.s[1:])
    inside = near.distance <= tolerance * (1.0 + 1e-9)
    assert np.all(inside)
    for k, why in enumerate(found.ended[:-1]):
        assert why in ("tolerance", "turned back")
        if why == "tolerance":
            assert near.distance[k] == pytest.approx(tolerance, rel=1e-10)
            assert near.side[k] * near.distance[k] == pytest.approx(found.offset[k])
    dense = tip("RRR", lengths, found.postures(60))
    assert path.nearest(dense.reshape(-1, 2)).distance.max() <= tolerance * (1.0 + 1e-9)
    assert found.worst <= tolerance * (1.0 + 1e-9)
    assert found.q_end == pytest.approx(found.q + found.rates * found.travel[:, None])


def test_start_where_the_tip_is() -> None:
    path = PATHS["ellipse"]()
    first = follow(ARM, path, 0.004, method="speed_ratio")
    k = len(first.q) // 2
    again = follow(ARM, path, 0.004, method="speed_ratio", q=first.q[k])
    assert again.s[0] == pytest.approx(first.s[k]) and again.start_moved == pytest.approx(0.0, abs=1e-12)
    shared = len(first.q) - k - 1
    assert again.s[:shared] == pytest.approx(first.s[k : k + shared], abs=1e-6)
    assert again.followed == pytest.approx(path.length)
    near = follow(ARM, path, 0.004, method="speed_ratio", q=first.q[k] + np.array([1e-3, 0.0, 0.0]))
    assert 0.0 < near.start_moved < 0.004
    assert tip("RRR", np.asarray(ARM.parameters), near.q[0]) == pytest.approx(path.point(near.s[0]), abs=1e-12)


def test_a_guess_with_a_start() -> None:
    path = PATHS["circle"]()
    guesses = [[0.2, 1.0, 0.5], [0.2, -1.0, -0.5]]
    found = [follow(ARM, path, 0.01, method="pseudoinverse", q=q, start=0.5) for q in guesses]
    for run_, guess in zip(found, guesses, strict=True):
        assert run_.s[0] == 0.5 and run_.s[-1] == pytest.approx(0.5 + path.length)
        assert run_.q[0, 1] * guess[1] > 0.0
    assert np.abs(found[0].q[0] - found[1].q[0]).max() > 0.5


def test_a_path_out_of_reach() -> None:
    away = follow(ARM, Circle((9.0, 0.0), 0.3), 0.01)
    assert away.status == "unreachable" and len(away.q) == 0 and away.updates == 0 and away.followed == 0.0
    assert "no posture" in away.reason
    leaving = follow(ARM, Line((1.0, 0.2), (4.0, 0.2)), 0.01, method="pseudoinverse")
    edge = np.sqrt(2.4**2 - 0.2**2) - 1.0
    assert leaving.status in ("unreachable", "singular")
    assert 0.97 * edge < leaving.followed < edge + 0.01
    check(leaving, Line((1.0, 0.2), (4.0, 0.2)), 0.01)


def test_a_singular_start() -> None:
    stretched = follow(ARM, Line((2.4, 0.0), (1.0, 0.5)), 0.01, q=[0.0, 0.0, 0.0])
    assert stretched.status == "singular" and len(stretched.q) == 0
    assert "singular" in stretched.reason


def test_joint_limits_stop_a_run() -> None:
    path = PATHS["circle"]()
    free = follow(ARM, path, 0.004, method="speed_ratio")
    turning = int(np.ptp(free.q, axis=0).argmax())
    position = [[-10.0, 10.0]] * 3
    position[turning] = [float(free.q[0, turning]) - 0.1, float(free.q[0, turning]) + 0.1]
    limited = follow(ARM.with_limits(position=position), path, 0.004, method="speed_ratio", q=free.q[0])
    assert limited.status == "joint limit" and limited.ended[-1] == "joint limit"
    assert ARM.joint_names[turning] in limited.reason
    assert np.abs(limited.q_end[-1, turning] - free.q[0, turning]) == pytest.approx(0.1, rel=1e-9)
    assert limited.followed < free.followed


@pytest.mark.parametrize("size", [1e-3, 1e6])
def test_size_does_not_matter(size: float) -> None:
    q = np.array([-0.6, 1.1, 0.8])

    def run_at(size: float) -> Followed:
        arm = cr.planar_3r(size, 0.8 * size, 0.6 * size)
        centre = arm.position(q) - 0.4 * size * np.array([0.8, 0.6])
        return follow(arm, Circle(centre.tolist(), 0.4 * size), 0.01 * size, method="speed_ratio", q=q)

    found, plain = run_at(size), run_at(1.0)
    assert found.status == plain.status == "finished" and found.updates == plain.updates
    assert found.s[:4] == pytest.approx(size * plain.s[:4], rel=1e-6)
    assert found.ended == plain.ended


def test_a_motion_that_follows_exactly() -> None:
    """The first joint alone turns the tip about the base: no update is needed, however small the tolerance."""
    found = follow(ARM, Circle((0.0, 0.0), 1.3), 1e-3, method="speed_ratio")
    assert found.status == "finished" and found.updates == 0 and found.worst < 1e-12
    assert np.abs(found.rates[0]) == pytest.approx([1.0 / 1.3, 0.0, 0.0], abs=1e-9)
    rail = cr.planar("PPP", [0.5, 0.3, 0.4], [0.0, 1.4, -0.3])
    straight = follow(rail, Line((0.0, 0.0), (3.0, 1.0)), 1e-3)
    assert straight.status == "finished" and straight.updates == 0


def test_updates_can_be_limited() -> None:
    found = follow(ARM, PATHS["circle"](), 0.0005, method="pseudoinverse", max_updates=5)
    assert found.status == "too many updates" and found.updates == 5


REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: follow(ARM, PATHS["circle"](), 0.0), "tolerance: 0.0; a positive"),
    (lambda: follow(ARM, PATHS["circle"](), -1.0), "a positive"),
    (lambda: follow(ARM, PATHS["circle"](), np.nan), "tolerance: nan; one finite"),
    (lambda: follow(ARM, PATHS["circle"](), [0.1]), "tolerance: .0.1.; one finite"),  # type: ignore[arg-type]
    (lambda: follow(ARM, PATHS["circle"](), 0.39), "up to 0.36 m"),
    (lambda: follow(ARM, PATHS["circle"](), 1e-300), "tolerance: 1e-300 m; at least"),
    (lambda: follow(ARM, "circle", 0.1), "a path such as"),  # type: ignore[arg-type]
    (lambda: follow(ARM, PATHS["circle"](), 0.01, method="best"), "pseudoinverse, speed_ratio"),  # type: ignore[arg-type]
    (lambda: follow(ARM, PATHS["circle"](), 0.01, q=[0.0, 0.0]), "q: shape"),
    (lambda: follow(ARM, PATHS["circle"](), 0.01, q=[0.0, np.nan, 0.0]), "finite"),
    (lambda: follow(ARM, PATHS["circle"](), 0.01, q=[0.0, 0.0, 0.0]), "from the path, farther than the tolerance"),
    (lambda: follow(ARM, PATHS["circle"](), 0.01, start=-0.1), "start"),
    (lambda: follow(ARM, PATHS["line"](), 0.01, start=9.0), "start"),
    (lambda: follow(ARM, PATHS["line"](), 0.01, start=[0.1, 0.2]), "start: .* one finite"),  # type: ignore[arg-type]
    (lambda: follow(ARM, PATHS["line"](), 0.01, method=np.array(["a", "b"])), "method"),  # type: ignore[arg-type]
    (lambda: follow("planar_3r", PATHS["line"](), 0.01), "arm: 'planar_3r'; an arm"),  # type: ignore[arg-type]
    (lambda: follow(ARM, PATHS["circle"](), 0.01, max_updates=-1), "max_updates"),
    (lambda: follow(cr.planar("RR", [1.0, 0.5]), PATHS["circle"](), 0.01), "a planar arm with three joints"),
    (lambda: follow(cr.load("panda"), PATHS["circle"](), 0.01), "a planar arm with three joints"),
    (
        lambda: follow(ARM.with_limits(position=[[-1, 1]] * 3), PATHS["circle"](), 0.01, q=[2.0, 0.0, 0.0]),
        "outside its limits",
    ),
    (lambda: compare(ARM, [0.0, 1.0], [1.0, 0.0], 1.0, 0.01), "q: shape"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [0.0, 0.0], 1.0, 0.01), "a direction"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0, 0.0], 1.0, 0.01), "tangent: shape"),
    (lambda: compare(ARM, np.zeros((2, 3)), np.ones((3, 2)), 1.0, 0.01), "broadcast"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], np.inf, 0.01), "finite"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], 10.0, 0.1), "up to 0.09 m"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], 1.0, 1e-200), "at least"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], 1.0, 0.01, methods=()), "methods"),
    (lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], 1.0, 0.01, methods="two_term"), "methods"),  # type: ignore[arg-type]
    (
        lambda: compare(ARM, [0.0, 1.0, 1.0], [1.0, 0.0], 1.0, 0.01, methods=["two_term"]).of("look_ahead"),
        "method: 'look_ahead'; two_term were compared",
    ),
    (lambda: study(0), "count"),
    (lambda: study(5, seed=-1), "seed: -1"),
    (lambda: study(5, curvature=[1.0, 2.0]), "curvature: .* one finite"),  # type: ignore[arg-type]
    (lambda: study(5, lengths=[1.0, -1.0, 1.0]), "three positive"),
    (lambda: study_paths("circle", 2), "a path such as"),  # type: ignore[arg-type]
    (lambda: study_paths(PATHS["circle"](), 0), "count: 0"),
    (lambda: study_paths(PATHS["circle"](), 2, max_updates=1.5), "max_updates: 1.5"),  # type: ignore[arg-type]
    (lambda: study_paths(PATHS["circle"](), 2, methods=("best",)), "method: 'best'"),  # type: ignore[arg-type]
    (lambda: study(5, kinds="RRRR"), "three letters"),
    (lambda: study(5, lengths=[1.0, 2.0]), "lengths"),
    (lambda: study_paths(Circle((0.0, 0.0), 50.0), 5), "a smaller path"),
]


@pytest.mark.parametrize(("make", "why"), REFUSED)
def test_refused_in_one_line(make: Callable[[], Any], why: str) -> None:
    with pytest.raises(InputError, match=why) as caught:
        make()
    assert "\n" not in str(caught.value)


# ---- figures and the command -----------------------------------------------------------------------------------


def test_figures_state_their_findings() -> None:
    from chainrule.plot.following import draw_following, draw_stretches, draw_study

    q, tangent = np.radians(EXAMPLES["figure 1"][0]), EXAMPLES["figure 1"][1]
    first = draw_stretches(cr.load("ambike_3r"), q, tangent, -1.0, example("figure 1"))
    assert "1.37 times" in first.axes[0].get_title(loc="left")
    labels = first.axes[0].get_legend_handles_labels()[1]
    assert sum(label.startswith("centre") for label in labels) == 3
    path = PATHS["circle"]()
    runs = [follow(ARM, path, 0.01, method=method) for method in METHODS]
    drawing = draw_following(ARM, path, runs)
    drawing.draw_without_rendering()
    assert all(axes.get_tightbbox().x1 <= drawing.bbox.x1 for axes in drawing.axes)  # no title is cut off
    title = drawing.axes[0].get_title(loc="left")
    assert str(min(r.updates for r in runs)) in title and str(max(r.updates for r in runs)) in title
    drawn = draw_study([study(40, e) for e in (0.025, 0.005)])
    assert len(drawn.axes[0].get_lines()) == 4  # the line at 1, two tolerances, looking ahead
    away = draw_following(ARM, path, [follow(ARM, Circle((9.0, 0.0), 0.3), 0.01)])
    assert away.axes[0].get_title(loc="left").startswith("No method")


def test_command(capsys: pytest.CaptureFixture[str], tmp_path: File) -> None:
    drawing = tmp_path / "follow.svg"
    arguments = ["follow", "planar_3r", "--circle", "1,0.2,0.2", "--tolerance", "0.01", "--figure", str(drawing)]
    assert run(arguments) == 0
    out = capsys.readouterr().out
    assert all(method in out for method in METHODS) and "finished" in out
    assert drawing.read_text("utf-8").startswith("<?xml")
    file = tmp_path / "path.toml"
    file.write_text('path = 1\nkind = "circle"\ncentre = [1, 0.2]\nradius = 0.2\n', "utf-8")
    assert run(["follow", "planar_3r", "--path", str(file), "--tolerance", "0.01", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    expected = follow(cr.load("planar_3r"), Circle((1.0, 0.2), 0.2), 0.01, method="speed_ratio")
    (same,) = [entry for entry in data["runs"] if entry["method"] == "speed_ratio"]
    assert same["updates"] == expected.updates


@pytest.mark.parametrize(
    ("arguments", "code", "why"),
    [
        (["--circle", "9,0,0.2", "--tolerance", "0.01", "--method", "two_term"], 1, "no posture"),
        (["--circle", "1,0.2,0.2", "--tolerance", "0"], 2, "a positive"),
        (["--circle", "1,0.2", "--tolerance", "0.01"], 2, "3 are accepted"),
        (["--tolerance", "0.01"], 2, "one of --path"),
        (["--circle", "1,0,1", "--line", "1,0,1,1", "--tolerance", "0.01"], 2, "only one"),
        (["--ellipse", "1,0,1", "--tolerance", "0.01"], 2, "4 or 5"),
        (["--path", "none.toml", "--tolerance", "0.01"], 2, "no such file"),
        (["--circle", "1,0.2,0.2", "--tolerance", "0.01", "--method", "x"], 2, "look_ahead"),
        (["--circle", "1,0.2,0.2", "--tolerance", "0.01", "--q", "0,0"], 2, "has 3 joints"),
        (["--line", "1,0.2,1.2,0.2", "--tolerance", "0.01", "--q", "90,0,0", "--deg"], 2, "farther than"),
    ],
)
def test_command_answers_no_or_refuses(
    arguments: list[str], code: int, why: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["follow", "planar_3r", *arguments]) == code
    captured = capsys.readouterr()
    text = captured.err if code == 2 else captured.out
    assert why in text
    if code == 2:
        assert text.count("\n") == 1


def test_report_section() -> None:
    from chainrule.report.content import Grid, Picture
    from chainrule.report.context import Context
    from chainrule.report.parts.following import SECTION

    arm = cr.load("lenarcic_3r")
    assert SECTION.applies(arm) and not SECTION.applies(cr.load("panda"))
    assert not SECTION.applies(cr.planar("RR", [1.0, 0.5]))
    part = SECTION.build(arm, Context(arm))
    (table,) = [block.table for block in part.blocks if isinstance(block, Grid)]
    (picture,) = [block for block in part.blocks if isinstance(block, Picture)]
    assert "<svg" in str(picture.svg)
    runs: Any = part.data["runs"]
    assert [row[1] for row in table.rows] == [entry["updates"] for entry in runs]
    assert min(entry["updates"] for entry in runs) < runs[0]["updates"]
