"""Following self-motion curves: against the closed form, against integration, and where curves can be mixed up."""

from __future__ import annotations

import dataclasses
import math
import warnings

import numpy as np
import pytest
from arms_under_test import crooked_rrpr
from scipy.integrate import solve_ivp

import chainrule as cr
from chainrule.self_motions import limits, tracing
from chainrule.self_motions.continuation import trace, trace_many, traces
from chainrule.self_motions.eigenvector import eigenvector
from chainrule.self_motions.held import Held, target_of
from chainrule.self_motions.identity import Known
from chainrule.self_motions.kernel import kernel
from chainrule.self_motions.planar_3r import planar_self_motion, singular_radii
from chainrule.self_motions.projection import project, start_points
from chainrule.self_motions.result import Component
from chainrule.self_motions.tracing import Settings

TURN = 2.0 * math.pi
LENARCIC = (0.40, 0.35, 0.25)

#: Arms of every kind with one joint to spare, a task each, and the length scale of prismatic joints. Three of them are
#: compiled on first use.
KINDS: dict[str, tuple[cr.Arm, str, float]] = {
    "RRR": (cr.planar_3r(*LENARCIC), "position", 1.0),
    "RRR x_alpha": (cr.planar_3r(*LENARCIC), "x_alpha", 1.0),
    "RPR": (cr.planar("RPR", [0.4, 0.2, 0.5], [0.0, 0.7, 0.0]), "position", 0.25),
    "RRPR pose": (cr.planar("RRPR", [0.5, 0.45, 0.1, 0.2], [0.0, 0.0, 0.4, 0.0]), "pose", 0.3),
    "RRPR in space": (crooked_rrpr(), "position", 0.4),
    "panda": (cr.load("panda"), "pose", 1.0),
    "iiwa14": (cr.load("iiwa14"), "pose", 1.0),
}
every_kind = pytest.mark.parametrize("kind", KINDS)


def h_of(arm: cr.Arm, task: str, q: np.ndarray) -> np.ndarray:
    """H as the product of the Jacobian's singular values."""
    return np.linalg.svd(arm.jacobian(q, task=task), compute_uv=False).prod(axis=-1)


def starts_of(kind: str, count: int, seed: int) -> np.ndarray:
    arm, task, _ = KINDS[kind]
    widths = np.where([letter == "R" for letter in arm.kinds], 2.5, 0.4)
    q = np.random.default_rng(seed).uniform(-1.0, 1.0, (40 * count, arm.n)) * widths
    h = h_of(arm, task, q)
    return q[h > 0.2 * h.max()][:count]


def unit_of(arm: cr.Arm, scale: float) -> np.ndarray:
    return np.where([letter == "R" for letter in arm.kinds], 1.0, scale)


def integrated(arm: cr.Arm, task: str, scale: float, found: Component, place: float, rtol: float) -> np.ndarray:
    """Where a point goes along the null space of J (by its singular vectors) over the length that was found."""
    unit = unit_of(arm, scale)
    ahead = np.diff(found.at([place, place + 1e-4]), axis=0)[0] / unit

    def rate(_, x):
        j = arm.jacobian(x * unit, task=task) * unit
        null = np.linalg.svd(j)[2][-1]
        return null * np.sign(np.linalg.det(np.vstack([j, null]))) * sense

    sense = 1.0
    sense = math.copysign(1.0, float(rate(0.0, found.at(place) / unit) @ ahead))
    begin = found.at(place) / unit
    run = solve_ivp(rate, (0.0, found.length), begin, method="DOP853", rtol=rtol, atol=0.1 * rtol)
    return run.y[:, -1] * unit


# ---- against the closed form -----------------------------------------------------------------------------------


def agree(closed: Component, followed: Component, length: float = 1e-9, box: float = 1e-9) -> None:
    assert followed.closed and followed.closure < 1e-9
    assert followed.length == pytest.approx(closed.length, rel=length)
    assert followed.residual < 1e-12
    sense = 1 if np.array_equal(followed.winding, closed.winding) else -1
    assert np.array_equal(followed.winding, sense * closed.winding)
    np.testing.assert_allclose(np.diff(followed.box), np.diff(closed.box), rtol=0, atol=box)
    np.testing.assert_allclose(followed.manipulability, closed.manipulability, rtol=0, atol=1e-9)


def both_curves(arm: cr.Arm, task: str, start: np.ndarray, target: np.ndarray) -> tuple[tuple[Component, ...], int]:
    """The curves through a posture and through its mirror image that does the same, and how many they are."""
    mirrored = -start
    if task == "position":  # about the target's direction
        mirrored[0] += 2.0 * math.atan2(target[1], target[0])
    else:  # about the x axis, the last link's heading kept
        mirrored[2] += 2.0 * target[1]
    found = trace_many(arm, [start, mirrored], task, targets=target)
    known = Known(Held(arm, task), target)
    known.add(found[0])
    return found, 1 if known.which(mirrored[np.newaxis])[0] == 0 else 2


def mapped(arms: np.ndarray, targets: np.ndarray, task: str, starts: np.ndarray, length: float, box: float) -> int:
    """Each arm's followed curves against the closed form of all of them; how many targets are regular."""
    known = cr.self_motion_map(arms, targets, task)
    regular = np.flatnonzero(known.words == "regular")
    for k in regular:
        found, number = both_curves(cr.planar_3r(*arms[k]), task, starts[k], targets[k])
        assert number == known.number[k], (arms[k].tolist(), targets[k].tolist())
        for curve in found:
            assert curve.closed and curve.residual < 1e-12 and curve.closure < 1e-8
            assert abs(curve.length - known.length[k]) < length * max(known.length[k], 1e-2)
            np.testing.assert_allclose(np.diff(curve.box)[:, 0], known.span[k], rtol=0, atol=box)
    return len(regular)


@pytest.mark.parametrize(("task", "count"), [("position", 1500), ("x_alpha", 700)])
def test_thousands_of_random_planar_arms_have_the_curves_of_the_closed_form(task: str, count: int) -> None:
    """The same number of curves, lengths to 1e-8, boxes to 1e-9 rad; each arm's target is what a posture does."""
    rng = np.random.default_rng(1)
    arms, starts = rng.uniform(0.1, 1.0, (count, 3)), rng.uniform(-math.pi, math.pi, (count, 3))
    a = np.cumsum(starts, axis=1)
    x, y = (arms * np.cos(a)).sum(axis=1), (arms * np.sin(a)).sum(axis=1)
    targets = np.stack([x, y if task == "position" else a[:, 2]], axis=1)
    assert mapped(arms, targets, task, starts, 1e-8, 1e-9) > 0.99 * count


def test_random_planar_arms_beside_singular_radii_have_the_curves_of_the_closed_form() -> None:
    """Gaps of 1e-9 to 1e-2 m on either side: curves that pass within 3e-5 rad of one another, and tiny ones."""
    rng = np.random.default_rng(2)
    arms, targets, starts = [], [], []
    for _ in range(60):
        lengths = rng.uniform(0.1, 1.0, 3)
        arm, radii = cr.planar_3r(*lengths), singular_radii(lengths)
        for radius in radii[radii > 0.02]:
            target = [radius + rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(-9.0, -2.0), 0.0]
            q, arrived = project(arm, rng.uniform(-3.0, 3.0, (12, 3)), target)
            if arrived.any():
                arms, targets = [*arms, lengths], [*targets, target]
                starts.append(q[np.argmax(arrived)])
    # a rounding of the target moves the curves, the tighter they turn the more, and so do their ranges
    assert mapped(np.array(arms), np.array(targets), "position", np.array(starts), 1e-8, 1e-6) > 100


@pytest.mark.parametrize("gap", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("side", [-1, 1])
def test_no_jump_beside_singular_radii(gap, side):
    """On either side of a radius two curves have become one: only the guard keeps the followed one to itself.

    At gap 1e-9 the branches pass within 3e-5 rad, and a rounding of the target changes the gap by 1e-7 of it.
    """
    for lengths in (LENARCIC, (0.3, 0.9, 0.5)):
        arm = cr.planar_3r(*lengths)
        for radius in singular_radii(lengths):
            target = [radius + side * gap, 0.0]
            known = planar_self_motion(arm, target)
            if known.status != "regular":
                continue
            found = trace_many(arm, [each.at(0.2) for each in known.components], targets=target)
            for closed, followed in zip(known.components, found, strict=True):
                # a loop that shrinks to a point with the gap has the gap's relative rounding
                agree(closed, followed, 1e-8 if closed.length > 0.1 else 1e-16 / gap**0.5 * 1e6, 1e-8)


def test_a_figure_of_eight_is_not_crossed():
    """At the radius itself the curve ends at the singular point, from both sides, and says so."""
    arm = cr.planar_3r(*LENARCIC)
    start, arrived = project(arm, np.array([[0.8, -1.2, 2.0]]), [0.5, 0.0])
    assert arrived.all()
    arc = trace(arm, start[0], target=[0.5, 0.0])
    assert not arc.closed and all("manipulability" in end for end in arc.ends)
    assert arc.manipulability[0] < 1e-5 and math.isnan(arc.closure)
    eight = planar_self_motion(arm, [0.5, 0.0])
    assert arc.length == pytest.approx(
        min((c.length for c in eight.components), key=lambda s: abs(s - arc.length)), rel=1e-4
    )


# ---- against integration ---------------------------------------------------------------------------------------


@every_kind
def test_length_is_where_the_integrated_tangent_returns(kind):
    """dx/ds = N / |N| integrated over the length (SciPy's DOP853) comes back to the start, moved by the winding."""
    arm, task, scale = KINDS[kind]
    start = starts_of(kind, 1, 3)[0]
    found = trace(arm, start, task, scale=scale)
    assert found.closed and found.residual < 1e-12
    end = integrated(arm, task, scale, found, 0.0, 1e-9)
    np.testing.assert_allclose(end, start + TURN * found.winding, rtol=0, atol=1e-6)


@every_kind
def test_every_point_is_on_the_curve_and_where_it_says(kind):
    arm, task, scale = KINDS[kind]
    start = starts_of(kind, 1, 4)[0]
    found = trace(arm, start, task, scale=scale)
    unit = unit_of(arm, scale)
    s = np.linspace(0.0, 1.0, 401)
    q = found.at(s)
    held, target = Held(arm, task, scale), target_of(arm, start, task)
    assert np.abs(held.evaluate(q, target)[0]).max() < 1e-12
    steps = np.linalg.norm(np.diff(q / unit, axis=0), axis=1) * 400.0 / found.length
    assert steps.max() < 1.0 + 1e-8 and steps.min() > 0.98  # chords are shorter than arcs
    np.testing.assert_allclose(found.at(1.0), found.at(0.0) + TURN * found.winding, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.at(1.3), found.at(0.3) + TURN * found.winding, rtol=0, atol=1e-12)
    fine = found.at(np.linspace(0.0, 1.0, 20001))
    inside = (fine >= found.box[:, 0] - 1e-12) & (fine <= found.box[:, 1] + 1e-12)
    assert inside.all()
    # and the box is reached: a point beside an extremum is below it by curvature times its distance squared
    reached = np.abs([fine.min(axis=0) - found.box[:, 0], fine.max(axis=0) - found.box[:, 1]]).max()
    assert reached < 1e-4 * max(1.0, found.length)
    h = h_of(arm, task, fine)
    assert found.manipulability[0] <= h.min() + 1e-12 and found.manipulability[1] >= h.max() - 1e-12
    assert h.min() - found.manipulability[0] < 1e-4 and found.manipulability[1] - h.max() < 1e-4


@every_kind
def test_the_start_does_not_matter(kind):
    arm, task, scale = KINDS[kind]
    start = starts_of(kind, 1, 5)[0]
    target = target_of(arm, start, task)
    first = trace(arm, start, task, scale=scale)
    for other in trace_many(arm, first.at([0.11, 0.5, 0.83]), task, targets=target, scale=scale):
        assert other.length == pytest.approx(first.length, rel=1e-9)
        assert np.array_equal(other.winding, first.winding)
        np.testing.assert_allclose(np.diff(other.box), np.diff(first.box), rtol=0, atol=1e-9)


@every_kind
def test_kernel_against_numpy(kind):
    """The compiled loop and the NumPy one take the same steps, to rounding."""
    arm, task, scale = KINDS[kind]
    held, start = Held(arm, task, scale), starts_of(kind, 1, 6)
    target = target_of(arm, start[0], task)
    direction = -1 if kind in ("RRR", "panda") else 1
    [c] = traces(held, start, target, Settings(direction))
    [python] = traces(held, start, target, Settings(direction), compiled=False)
    assert c.reason == python.reason == "closed"
    assert abs(c.steps - python.steps) <= 2
    assert c.s[-1] == pytest.approx(python.s[-1], rel=1e-11)
    np.testing.assert_allclose(c.box, python.box, rtol=0, atol=1e-10)
    np.testing.assert_allclose(c.span, python.span, rtol=0, atol=1e-10)
    assert np.array_equal(c.winding, python.winding)
    assert c.contraction < 0.9 and python.contraction < 0.9
    assert len(c.knots) == len(python.knots)
    np.testing.assert_allclose(c.knots[:, 2], python.knots[:, 2], rtol=0, atol=1e-10)
    # and so do corrections of configurations near the curve
    near = c.q + np.random.default_rng(0).uniform(-1e-4, 1e-4, c.q.shape) * held.unit
    placed, tangents = held.placed(near, target)
    by_numpy = near + held.step(near, target)
    by_numpy += held.step(by_numpy, target)
    np.testing.assert_allclose(placed, by_numpy + held.step(by_numpy, target), rtol=0, atol=1e-11)
    null = held.bend(placed)[0] / held.unit
    np.testing.assert_allclose(tangents, null / np.linalg.norm(null, axis=1, keepdims=True), rtol=0, atol=1e-9)


def test_settings_are_the_same_in_both():
    from chainrule.derive import emit, lobatto

    names = {
        "contraction": tracing.CONTRACTION, "slab": tracing.SLAB, "advance": tracing.ADVANCE, "nodes": tracing.NODES,
        "longest_step": tracing.LONGEST, "step_turn": tracing.TURN, "history": tracing.HISTORY,
        "newton": tracing.NEWTON, "settled": tracing.SETTLED, "left": tracing.LEFT, "powers": tracing.POWERS,
        "parts": tracing.PARTS, "level": tracing.LEVEL, "both": tracing.BOTH,
        "order": tracing.ORDER, "least_turn": tracing.LEAST_TURN, "most_turn": tracing.MOST_TURN,
        "finest": tracing.FINEST, "balls": tracing.BALLS,
    }  # fmt: skip
    assert names == emit.CONTINUATION
    text = lobatto.context(tracing.ORDER)
    np.testing.assert_allclose(np.fromstring(text["nodes_text"], sep=","), tracing.LOBATTO_NODES, rtol=0, atol=1e-15)
    for rows, wanted in ((text["running_text"], tracing.LOBATTO_RUNNING), (text["last_text"], tracing.LOBATTO_LAST)):
        np.testing.assert_allclose([np.fromstring(row, sep=",") for row in rows], wanted, rtol=0, atol=1e-14)


def test_lobatto_is_exact_to_its_degree():
    for degree in range(2 * tracing.ORDER - 2):
        assert tracing.LOBATTO_WEIGHTS @ tracing.LOBATTO_NODES**degree == pytest.approx(1.0 / (degree + 1), abs=1e-15)


# ---- the guard -------------------------------------------------------------------------------------------------


@every_kind
def test_the_bound_of_the_second_derivative_is_one(kind):
    """|D2e(u, u)| by central differences stays below K, at random points of the ball and random directions."""
    arm, task, scale = KINDS[kind]
    held, rng = Held(arm, task, scale), np.random.default_rng(7)
    tightest = 0.0
    for start in starts_of(kind, 8, 8):
        target = target_of(arm, start, task)
        system = held.system(target)
        follower = tracing.Follower(system, Settings())
        x0 = start / held.unit
        _, jacobian, _ = follower.held(x0)
        for radius in (0.02, 0.2):
            bound = tracing.second_derivative(system, x0, jacobian, radius)
            for _ in range(25):
                u, away = rng.normal(size=(2, arm.n))
                u /= np.linalg.norm(u)
                x = x0 + away / np.linalg.norm(away) * radius * rng.uniform() ** (1 / arm.n)
                h = 1e-4
                ahead, here, behind = (follower.held(x + k * h * u)[0] for k in (1, 0, -1))
                size = float(np.linalg.norm(ahead - 2.0 * here + behind)) / h**2
                assert size <= bound + 1e-6
                tightest = max(tightest, size / bound)
    assert tightest > 0.1  # the bound says something


def test_within_the_slab_of_a_ball_there_is_one_arc():
    """Beside a reconnection: no point of the other curve, and none of the own curve elsewhere, is in the slab."""
    arm, target = cr.planar_3r(*LENARCIC), np.array([0.5 - 1e-4, 0.0])
    one, other = planar_self_motion(arm, target).components
    held = Held(arm, "position")
    follower = tracing.Follower(held.system(target), Settings())
    s = np.linspace(0.0, 1.0, 20001)
    mine, theirs = one.at(s), other.at(s)
    least = math.inf
    for place in np.linspace(0.0, 1.0, 80, endpoint=False):
        found = follower.correct(one.at(place))
        assert found is not None
        x, t, bound, jacobian, _ = found
        radius = follower.radius(x, jacobian, bound, 0.5)
        for points, own in ((theirs, False), (mine, True)):
            apart = points - x
            apart = apart - TURN * np.rint(apart / TURN)
            distance, along = np.linalg.norm(apart, axis=1), apart @ t
            inside = (distance <= radius) & (np.abs(along) <= tracing.SLAB * radius)
            if own:  # all of one stretch: places along it rise with the places on the curve
                where = np.sort(along[inside])
                assert np.diff(where).max(initial=0.0) < 2.0 * one.length / 20000
                assert np.abs(np.diff(np.sort((s[inside] - place + 0.5) % 1.0))).max() < 6e-5
            else:
                assert not inside.any()
                least = min(least, distance.min() / radius)
    assert 1.0 < least < 50.0  # the balls come near the other curve, and no nearer


def test_two_balls_meet_on_one_curve_only():
    """Beside a reconnection: arcs said to be one are neighbours on one curve, never on two."""
    arm, target = cr.planar_3r(*LENARCIC), np.array([0.5 - 1e-4, 0.0])
    one, other = planar_self_motion(arm, target).components
    follower = tracing.Follower(Held(arm, "position").system(target), Settings())
    s = np.linspace(0.0, 1.0, 400, endpoint=False)

    def points(curve: Component) -> list[tracing.Point]:
        made = []
        for place in s:
            x, t, bound, jacobian, _ = follower.correct(curve.at(place))
            made.append(tracing.Point(x, t, follower.radius(x, jacobian, bound, 0.5)))
        return made

    mine, theirs = points(one), points(other)
    met = longest = 0
    for k, a in enumerate(mine):
        for points_of, own in ((mine, True), (theirs, False)):
            for j, b in enumerate(points_of):
                turned = b.x + TURN * np.rint((a.x - b.x) / TURN)
                if np.linalg.norm(turned - a.x) > 2.0 * (a.radius + b.radius) or (own and j == k):
                    continue
                there = dataclasses.replace(b, x=turned)
                along = float(a.t @ (turned - a.x))
                joined, _ = (
                    tracing.meet(a, there, along * a.radius / (a.radius + b.radius)) if along > 0 else (False, 0)
                )
                if joined:
                    assert own
                    ahead = (s[j] - s[k]) % 1.0  # the curve runs along its tangents or against them
                    apart = min(ahead, 1.0 - ahead) * one.length
                    assert apart < 2.0 * (a.radius + b.radius)
                    met, longest = met + 1, max(longest, apart / (a.radius + b.radius))
    assert met > 400 and 0.8 < longest < 1.1


def test_without_the_guard_the_same_steps_jump(monkeypatch):
    """Why there is a guard: the same predictor and corrector, not held to the balls, change curves beside a radius."""
    arm, target = cr.planar_3r(*LENARCIC), np.array([0.5 - 1e-9, 0.0])
    held, known = Held(arm, "position"), planar_self_motion(arm, target).components[0]
    start = known.at(0.3)
    [guarded] = traces(held, start[np.newaxis], target, Settings(), compiled=False)
    assert guarded.s[-1] == pytest.approx(known.length, rel=1e-8)
    monkeypatch.setattr(tracing.Follower, "radius", lambda *given: 0.2)
    [loose] = traces(held, start[np.newaxis], target, Settings(steps=2000), compiled=False)
    assert len(set(np.sign(np.sin(guarded.q[:, 1])))) == 1  # what tells the two curves apart
    assert set(np.sign(np.sin(loose.q[:, 1]))) == {-1.0, 1.0}


def beside_singular(seed: int) -> np.ndarray:
    """A Panda posture about 1e-4 from a singular one: Newton's method on H from where H is least on some loop."""
    arm, rng = cr.load("panda"), np.random.default_rng(seed)
    loop = trace(arm, np.array([0.0, -0.6, 0.2, -1.9, 0.3, 1.7, 0.5]) + rng.uniform(-0.5, 0.5, 7), "pose")
    q = loop.at(np.linspace(0.0, 1.0, 2000))
    q = q[int(arm.manipulability(q).argmin())]
    for _ in range(40):
        h, g = float(arm.manipulability(q)), arm.manipulability_gradient(q)
        if h < 1e-12:
            break
        q = q - min(h / float(g @ g), 0.1 / float(np.linalg.norm(g))) * g
    assert h < 1e-12
    return q + rng.normal(size=7) * 1e-4


@pytest.mark.parametrize("seed", [0, 4])
def test_panda_loops_beside_reconnections(seed):
    """Near singular poses the loop closes, its length is where the integrated tangent returns, from any start."""
    arm, near = cr.load("panda"), beside_singular(seed)
    found = trace(arm, near, "pose")
    assert found.closed and found.residual < 1e-12 and found.length < 30.0
    assert found.manipulability[0] < 2e-5 and found.manipulability[1] > 0.03
    for each in trace_many(arm, found.at([0.2, 0.6]), "pose", targets=arm.pose(near)):
        assert each.length == pytest.approx(found.length, rel=1e-8)
    end = integrated(arm, "pose", 1.0, found, 0.5, 1e-11)  # passes the singular posture once
    np.testing.assert_allclose(end, found.at(0.5) + TURN * found.winding, rtol=0, atol=1e-5)


def test_panda_loops_come_in_pairs_from_any_start():
    """All random starts of one pose lie on few loops, and each length comes twice (sin q2 of either sign)."""
    arm = cr.load("panda")
    aim = arm.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4])
    q, arrived = project(arm, start_points(arm, 150, 11), aim)
    assert arrived.mean() > 0.5
    loops = trace_many(arm, q[arrived], "pose", targets=aim)
    lengths = np.array([loop.length for loop in loops])
    signs = np.array([loop.signs["q2"] for loop in loops])
    assert all(loop.closed for loop in loops)
    kinds = np.unique(np.round(lengths, 7))
    assert len(kinds) <= 4
    for kind in kinds:
        assert set(signs[np.abs(lengths - kind) < 1e-6]) == {-1, 1}


# ---- ends ------------------------------------------------------------------------------------------------------


def test_a_curve_cut_at_a_length_is_followed_both_ways():
    """It ends 2 rad from its start on either side; its points lie on the closed curve, as far apart as they say."""
    arm, start = cr.planar_3r(*LENARCIC), np.array([0.1, 2.0, 1.0])
    found, whole = trace(arm, start, longest=2.0), trace(arm, start)
    assert not found.closed and len(found.ends) == 2 and all("length" in end for end in found.ends)
    assert 4.0 <= found.length < 5.1 < whole.length
    known = Known(Held(arm, "position"), arm.position(start))
    known.add(whole)
    fine = found.at(np.linspace(0.0, 1.0, 20001))
    assert (known.which(fine[::100]) == 0).all()
    chords = np.linalg.norm(np.diff(fine, axis=0), axis=1)
    assert chords.sum() == pytest.approx(found.length, rel=1e-7)
    before = chords[: int(np.argmin(np.linalg.norm(fine - start, axis=1)))].sum()
    assert 2.0 <= before < 2.6 and 2.0 <= found.length - before < 2.6
    assert found.box[:, 0] == pytest.approx(fine.min(axis=0), abs=1e-7)
    assert found.box[:, 1] == pytest.approx(fine.max(axis=0), abs=1e-7)


def test_steps_run_out():
    found = trace(cr.planar_3r(*LENARCIC), [0.5, 1.0, 1.0], steps=10)
    assert not found.closed and all("steps" in end for end in found.ends) and 0.0 < found.length < 8.0


def test_a_singular_start_is_one_point():
    arm = cr.planar_3r(*LENARCIC)
    found = trace(arm, [0.3, 0.0, 0.0])
    assert len(found.q) == 1 and found.length == 0.0 and not found.closed and found.manipulability == (0.0, 0.0)
    assert np.array_equal(found.at([0.0, 0.5]), [found.q[0]] * 2)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: trace(cr.load("ur5e"), np.zeros(6)), "no curve"),
        (lambda: trace(cr.planar_3r(1, 1, 1), np.zeros(3), "pose"), "position, x_alpha is accepted"),
        (lambda: trace(cr.planar_3r(1, 1, 1), np.zeros(4)), "q0 has shape"),
        (lambda: trace(cr.planar_3r(1, 1, 1), [0.1, math.nan, 0.0]), "nan"),
        (lambda: trace(cr.planar_3r(1, 1, 1), [0.1, 1.0, 0.5], target=[4.0, 0.0]), "does not lead"),
        (lambda: trace(cr.planar_3r(1, 1, 1), [0.1, 1.0, 0.5], target=[1.0, 0.0, 2.0]), "target has shape"),
        (lambda: trace(cr.planar_3r(1, 1, 1), [0.1, 1.0, 0.5], "spin"), "there is no task"),
        (lambda: trace(cr.planar_3r(1, 1, 1), [0.1, 1.0, 0.5], scale=0.0), "scale"),
        (lambda: trace(cr.load("panda"), np.ones(7), target=np.ones((4, 4))), "rotation"),
        (lambda: eigenvector(cr.planar_3r(1, 1, 1), [0.1, 1.0, 0.5], gamma=-1.0), "gamma"),
    ],
)
def test_refusals(call, said):
    with pytest.raises(cr.InputError, match=said) as caught:
        call()
    assert "\n" not in str(caught.value)


# ---- joint limits ----------------------------------------------------------------------------------------------


def test_arcs_and_their_complement_make_the_loop():
    """What joint 3 may do and what it may not sum to the whole curve; every end lies on its stop."""
    rng = np.random.default_rng(12)
    for _ in range(12):
        arm = cr.planar_3r(*rng.uniform(0.2, 1.0, 3))
        loop = trace(arm, rng.uniform(-2.5, 2.5, 3))
        low, high = np.sort(rng.uniform(-3.0, 3.0, 2))
        for joint in range(3):
            sides = []
            for a, b in ((low, high), (high, low + TURN)):
                bounds = np.full((3, 2), [-math.inf, math.inf])
                bounds[joint] = a, b
                parts = limits.feasible(arm, [loop], limits=bounds)
                sides.append(sum(part.length for part in parts))
                for part in parts:
                    assert part.box[joint, 0] > a - 1e-11 and part.box[joint, 1] < b + 1e-11
                    for point, end in zip(part.at([0.0, 1.0]), part.ends, strict=False):
                        assert end.startswith(f"limit of joint {joint + 1}")
                        assert abs(point[joint] - (b if "upper" in end else a)) < 1e-11
            assert sum(sides) == pytest.approx(loop.length, rel=1e-10)


@pytest.mark.parametrize("kind", ["RRR", "RPR", "RRPR in space", "panda"])
def test_a_stop_that_is_grazed_is_met(kind):
    """An upper stop 1e-9 below the greatest value of a joint cuts a small piece out; one 1e-9 above cuts nothing."""
    arm, task, scale = KINDS[kind]
    loop = trace(arm, starts_of(kind, 1, 13)[0], task, scale=scale)
    for joint in range(arm.n):
        if loop.winding[joint] or np.diff(loop.box[joint]) > TURN - 0.1 or np.diff(loop.box[joint]) < 1e-3:
            continue
        free = np.full((arm.n, 2), [-math.inf, math.inf])
        free[joint] = loop.box[joint, 0] - 0.05, loop.box[joint, 1] + 1e-9
        [whole] = limits.feasible(arm, [loop], task, free)
        assert whole.closed and whole.of == 0
        free[joint, 1] = loop.box[joint, 1] - 1e-9
        parts = limits.feasible(arm, [loop], task, free)
        assert all(not part.closed and part.ends[1].endswith("(upper)") for part in parts)
        lost = loop.length - sum(part.length for part in parts)
        assert 0.0 < lost < 0.05  # of the order of the root of 1e-9
        kinds = {c.kind for c in limits.crossings(arm, loop, task, free)}
        assert {"leaves", "enters"} <= kinds


def test_a_range_of_more_than_a_turn_holds_more_than_a_round():
    """Joint 3 winds: with +-7 rad it may turn 14 rad, 2.23 rounds, in one arc."""
    arm = cr.planar_3r(*LENARCIC)
    loop = trace(arm, [0.1, 2.0, 1.0])
    assert abs(loop.winding[2]) == 1
    [arc] = limits.feasible(arm, [loop], limits=[(-math.pi, math.pi), (-math.pi, math.pi), (-7.0, 7.0)])
    assert arc.length > 2.0 * loop.length and arc.box[2].tolist() == pytest.approx([-7.0, 7.0], abs=1e-11)
    error = arm.position(arc.at(np.linspace(0.0, 1.0, 50))) - arm.position(loop.q[0])
    assert np.abs(error).max() < 1e-12


def test_limits_agree_with_the_closed_form():
    rng = np.random.default_rng(14)
    met = 0
    for _ in range(10):
        arm = cr.planar_3r(*rng.uniform(0.2, 1.0, 3))
        bounds = np.sort(rng.uniform(-3.1, 3.1, (3, 2)), axis=1)
        limited = arm.with_limits(position=bounds)
        known = planar_self_motion(limited, arm.position(rng.uniform(-2.0, 2.0, 3)), limits=True)
        if known.status != "regular" or known.feasible is None:
            continue
        loops = trace_many(arm, [each.at(0.1) for each in known.components], targets=known.target)
        parts = limits.feasible(arm, loops, limits=bounds)
        assert len(parts) == len(known.feasible)
        np.testing.assert_allclose(
            sorted(p.length for p in parts), sorted(p.length for p in known.feasible), rtol=0, atol=1e-8
        )
        if parts:
            np.testing.assert_allclose(limits.ranges(parts), limits.ranges(known.feasible), rtol=0, atol=1e-8)
        met += 1
    assert met >= 6


def test_panda_within_its_limits():
    """Every point of every arc is within the limits, and a point of a loop that is in no arc is not."""
    arm = cr.load("panda")
    bounds = arm.limits.position
    loops = trace_many(arm, starts_of("panda", 4, 15), "pose")
    parts = limits.feasible(arm, loops, "pose")
    for part in parts:
        q = part.at(np.linspace(0.0, 1.0, 300))
        assert (q >= bounds[:, 0] - 1e-10).all() and (q <= bounds[:, 1] + 1e-10).all()
    for index, loop in enumerate(loops):
        s = np.linspace(0.0, 1.0, 2000, endpoint=False)
        q = loop.at(s)
        fits = np.all(np.floor((bounds[:, 1] - q) / TURN) >= np.ceil((bounds[:, 0] - q) / TURN), axis=1)
        share = sum(part.length for part in parts if part.of == index) / loop.length
        assert share == pytest.approx(fits.mean(), abs=0.01)


# ---- the paper's method ----------------------------------------------------------------------------------------


def test_the_paper_s_method_closes_with_an_error_that_grows_with_its_step():
    arm = cr.planar_3r(*LENARCIC)
    start = np.array([0.5, 1.0, 1.0])
    exact = trace(arm, start).length
    runs = [eigenvector(arm, start, gamma=gamma) for gamma in (0.02, 0.01, 0.005)]
    for run in runs:
        assert run.status == "closed" and run.length == pytest.approx(exact, abs=10.0 * run.gamma)
        assert np.all(np.linalg.norm(np.diff(run.q, axis=0), axis=1) == pytest.approx(run.gamma))
    drifts = [run.drift for run in runs]
    assert drifts[0] / drifts[1] == pytest.approx(2.0, rel=0.1) and drifts[1] / drifts[2] == pytest.approx(2.0, rel=0.1)


def test_the_paper_s_method_fails_beside_a_singular_radius():
    """At px = 0.5001 ("quite robust ... very close to a singularity") it has the wrong length, where ours is right."""
    arm = cr.planar_3r(*LENARCIC)
    [known] = planar_self_motion(arm, [0.5001, 0.0]).components
    start = known.at(0.3)
    run = eigenvector(arm, start, gamma=0.001, steps=40_000)
    assert run.status == "never returned" or abs(run.length - known.length) > 1.0 or run.closure > 5.0 * run.gamma
    assert trace(arm, start, target=[0.5001, 0.0]).length == pytest.approx(known.length, rel=1e-9)


# ---- results ---------------------------------------------------------------------------------------------------


def test_without_a_compiler_the_curves_are_the_same(monkeypatch):
    """No library in the cache entry: the NumPy code follows, by the same steps."""
    from chainrule import compile as compiling

    arm = cr.planar_3r(*LENARCIC)
    wanted = trace(arm, [0.5, 1.0, 1.0])
    found = compiling.find(arm.description.model, "continuation_position")
    kernel.cache_clear()
    with monkeypatch.context() as patch, warnings.catch_warnings():
        patch.setattr(compiling, "find", lambda *given: dataclasses.replace(found, library=None))
        again = trace(arm, [0.5, 1.0, 1.0])
    kernel.cache_clear()
    assert again.length == pytest.approx(wanted.length, rel=1e-12)
    np.testing.assert_allclose(again.box, wanted.box, rtol=0, atol=1e-12)


def test_results_as_plain_numbers():
    import json

    found = trace(cr.planar_3r(*LENARCIC), [0.5, 1.0, 1.0], steps=10)
    plain = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert plain["closure"] is None and plain["ends"] and len(plain["box"]) == 3
