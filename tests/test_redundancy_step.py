"""The step of a redundant arm along a task, against linear algebra, 50-digit derivatives and its own C code."""

from __future__ import annotations

import ctypes
import subprocess
from functools import cache

import arms_under_test as under
import mpmath
import numpy as np
import pytest
import reference

import chainrule as cr
from chainrule import compile as compiling
from chainrule.derive import catalogue, emit, redundancy
from chainrule.derive.lower import lower
from chainrule.redundancy.step import CRITERIA, Damping, Law, Step, Stepper

pytestmark = pytest.mark.xdist_group("redundancy step")

EPS = np.finfo(float).eps
#: Arms and tasks: two that ship their step, a prismatic joint, families, as many rows as joints.
CASES = [
    ("sanchez_8r", "pose"),
    ("panda", "pose"),
    ("planar_3r", "position"),
    ("planar_3r", "x_alpha"),
    ("planar_3r", "pose"),
    ("orthogonal_3r(1, 2, 1.5, 1)", "position"),
    ("PRRRR", "position"),
]
every_case = pytest.mark.parametrize(("name", "task"), CASES)


@cache
def arm_of(name):
    if name == "PRRRR":
        rows = [("P", 0.0, 0.2, 0.1, 0.0), *(("R", (-1) ** k * np.pi / 2, 0.3, 0.1 * k, 0.2) for k in range(4))]
        return cr.Arm.from_dh(rows, name="railed_5").with_limits(position=[(-1.0, 2.0), *[(-2.5, 1.5)] * 3, None])
    return under.ARMS[name]


def law_of(arm, seed=0, **other):
    """A law that uses everything."""
    rng = np.random.default_rng(seed)
    gains = dict(zip(CRITERIA, rng.uniform(-0.5, 0.5, 4) * [1.0, 0.01, 0.1, 1.0], strict=True))
    return Law(gains, **{"feedback": (3.0, 2.0), "weights": tuple(rng.uniform(0.3, 3.0, arm.n)), **other})


def random_targets(arm, task, q):
    """Targets near the tip's place, as the task takes them."""
    if task == "position":
        return arm.position(q)
    pose = arm.pose(q)
    if pose.shape[-1] == 4:
        return pose
    alpha = np.arctan2(pose[..., 1, 0], pose[..., 0, 0])
    entries = {"x_alpha": [pose[..., 0, 2], alpha], "pose": [pose[..., 0, 2], pose[..., 1, 2], alpha]}[task]
    return np.stack(entries, axis=-1)


def situation(name, task, count, seed=0):
    """Postures, targets, velocities and pushes; H is at least a fifth of its median, so none is nearly singular."""
    arm, rng = arm_of(name), np.random.default_rng(seed)
    q = under.random_q(arm, 4 * count, seed)
    h = arm.manipulability(q, task=task)
    q = q[h > 0.2 * np.median(h)][:count]
    held = random_targets(arm, task, q + rng.normal(0.0, 0.1, q.shape))
    return q, held, rng.normal(size=(len(q), arm.tasks[task])), rng.normal(size=q.shape)


def asked(arm, task, law, step, velocity):
    """The task's velocity with feedback of the reported error."""
    lengths = {"position": 2, "x_alpha": 1, "pose": 2} if arm.pose(np.zeros(arm.n)).shape[-1] == 3 else {}
    first = lengths.get(task, 3)
    gains = np.where(np.arange(arm.tasks[task]) < first, *law.feedback)
    return velocity - gains * step.error


def uphill(arm, task, law, q, push):
    """The gradients' sum and the push, from functions that have tests of their own."""
    total = np.array(push, float)
    for criterion in CRITERIA[:3]:
        total += law.gains.get(criterion, 0.0) * arm.manipulability_gradient(q, task=task, criterion=criterion)
    for j, (low, high) in enumerate(arm.limits.position):
        if np.isfinite(low):
            half = (high - low) / 2
            total[..., j] += law.gains.get("limits", 0.0) * (q[..., j] - (low + high) / 2) / half**2 / arm.n
    return total


def condition(jacobian):
    """Of each matrix, with its rows and columns as they are."""
    values = np.linalg.svd(jacobian, compute_uv=False)
    return values[..., 0] / values[..., -1]


# ---- the task, and what minimises ------------------------------------------------------------------------------


@every_case
def test_the_task_is_done(name, task):
    """J rates is the velocity asked for, to 1e-12 of it or 40 eps cond(J); q_next is where they lead."""
    arm = arm_of(name)
    law = law_of(arm)
    q, held, velocity, push = situation(name, task, 2000)
    step = Stepper(arm, law, task)(q, held, velocity, 0.01, push)
    wanted = asked(arm, task, law, step, velocity)
    jacobian = arm.jacobian(q, task=task)
    missed = np.linalg.norm((jacobian @ step.rates[..., None])[..., 0] - wanted, axis=-1)
    size = np.linalg.norm(wanted, axis=-1) + np.linalg.norm(push, axis=-1)
    assert np.all(missed <= 40 * EPS * condition(jacobian * np.array(law.weights) ** -0.5) * size)
    assert np.median(missed / size) < 1e-14 and np.max(missed / size) < 1e-12
    np.testing.assert_allclose(step.manipulability, arm.manipulability(q, task=task), rtol=1e-13)
    np.testing.assert_allclose(
        step.q_next, q + 0.01 * step.rates, rtol=0, atol=4 * EPS * (1 + np.abs(q).max() + np.abs(step.rates).max())
    )


@every_case
def test_it_solves_the_optimality_conditions(name, task):
    """Least (rates - g)^T W (rates - g) under J rates = v: the solution of [W J^T; J 0], solved by NumPy."""
    arm = arm_of(name)
    law, (q, held, velocity, push) = law_of(arm, 1), situation(name, task, 300, 1)
    step = Stepper(arm, law, task)(q, held, velocity, 0.01, push)
    wanted, g = asked(arm, task, law, step, velocity), uphill(arm, task, law, q, push)
    n, m, jacobian = arm.n, arm.tasks[task], arm.jacobian(q, task=task)
    matrix, right = np.zeros((len(q), n + m, n + m)), np.zeros((len(q), n + m))
    matrix[:, :n, :n] = np.diag(law.weights)
    matrix[:, :n, n:], matrix[:, n:, :n] = jacobian.transpose(0, 2, 1), jacobian
    right[:, :n], right[:, n:] = np.array(law.weights) * g, wanted
    expected = np.linalg.solve(matrix, right[..., None])[:, :n, 0]
    size = np.abs(expected).max(axis=-1, keepdims=True)
    assert np.all(np.abs(step.rates - expected) <= 1e-11 * size)


@every_case
def test_null_motion_leaves_the_task_alone(name, task):
    """J null_motion = 0 to rounding, and rates without it do the task with what is left of W-norm: W-orthogonal."""
    arm = arm_of(name)
    law, (q, held, velocity, push) = law_of(arm, 2), situation(name, task, 500, 2)
    jacobian = arm.jacobian(q, task=task)
    for damping in (Damping(), Damping("constant", 0.1)):  # the null motion is not damped
        damped = Law(law.gains, law.feedback, damping, law.weights)
        step = Stepper(arm, damped, task)(q, held, velocity, 0.01, push)
        moved = np.abs(jacobian @ step.null_motion[..., None]).max(axis=(1, 2))
        size = np.abs(jacobian).max(axis=(1, 2)) * np.linalg.norm(uphill(arm, task, law, q, push), axis=-1)
        assert np.all(moved <= 100 * EPS * size)
        assert (arm.n == arm.tasks[task]) == (not step.null_motion.any())
        across = np.sum((step.rates - step.null_motion) * law.weights * step.null_motion, axis=-1)
        scale = np.linalg.norm(step.rates, axis=-1) * np.linalg.norm(step.null_motion, axis=-1)
        assert np.all(np.abs(across) <= 1e-11 * (scale + 1))


@pytest.mark.parametrize("name", ["sanchez_8r", "panda"])
def test_what_a_law_does_without_changes_nothing(name):
    """Parts of the code are passed over where a whole tile does without them: in any company the same, bit for bit."""
    arm = arm_of(name)
    laws = [
        Law(feedback=(3.0, 2.0)),
        Law({"H^(-1/2)": -2.0}),
        Law({"limits": -0.5}),
        Law(damping=Damping("constant", 0.1)),
        Law({"H": 1.0}, damping=Damping("nakamura", 0.1, 0.05)),
        Law(damping=Damping("chiaverini", 0.1, 0.1)),
    ]
    q, held, velocity, push = (part[:64] for part in situation(name, "pose", 64, 10))
    push[::3] = 0.0
    assert len(q) == 64  # whole tiles: single configurations have code of their own
    order = np.arange(64) % len(laws)
    mixed = Stepper(arm, [laws[k] for k in order])(q, held, velocity, 0.01, push)
    for k, law in enumerate(laws):
        alone = Stepper(arm, law)(q, held, velocity, 0.01, push)
        for part in ("q_next", "rates", "manipulability", "error", "null_motion"):
            mine = order == k
            np.testing.assert_array_equal(getattr(mixed, part)[mine], getattr(alone, part)[mine])
    still = Stepper(arm, laws[0])(q, held, velocity, 0.01)
    assert not still.null_motion.any()
    moved = Stepper(arm, laws[1])(q, held, velocity, 0.01)
    assert np.all(np.abs(moved.null_motion).max(axis=-1) > 0)


def test_arms_of_any_lengths():
    """One function for a family: random lengths, with parameters as an input."""
    rng = np.random.default_rng(3)
    for lengths in rng.uniform(0.2, 1.5, (20, 3)):
        arm = cr.planar_3r(*lengths)
        q = rng.uniform(-2.0, 2.0, (50, 3))
        velocity = rng.normal(size=(50, 2))
        step = Stepper(arm, Law({"H": 1.0}))(q, arm.position(q), velocity, 0.01)
        jacobian = arm.jacobian(q)
        missed = np.abs((jacobian @ step.rates[..., None])[..., 0] - velocity).max(axis=-1)
        assert np.all(missed <= 100 * EPS * condition(jacobian) * (1 + np.abs(step.rates).max(axis=-1)))


# ---- near singularities ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("distance", [1e-2, 1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize(
    ("name", "q"),
    [("sanchez_8r", [0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2]), ("panda", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9])],
)
def test_near_a_singularity(name, q, distance):
    """The task is done to some 40 eps cond(J) of it, and the null motion stays in the null space, however near."""
    arm = arm_of(name)
    q = np.array(q) + distance * np.linspace(-0.9, 1.0, arm.n) ** 2
    jacobian = arm.jacobian(q)
    velocity = jacobian @ np.linspace(1.0, -1.0, arm.n)  # one that can be had
    step = Stepper(arm, Law({"H": 1.0}))(q, arm.pose(q), velocity, 0.01, np.ones(arm.n))
    assert np.linalg.norm(jacobian @ step.rates - velocity) <= 40 * EPS * condition(jacobian) * np.linalg.norm(velocity)
    assert np.linalg.norm(jacobian @ step.null_motion) <= 40 * EPS * np.linalg.norm(jacobian) * 4
    assert np.linalg.norm(step.rates - step.null_motion) <= 2 * np.sqrt(arm.n) * (
        1 + 40 * EPS * condition(jacobian) ** 2
    )


@pytest.mark.parametrize(
    ("arm", "task", "q"),
    [
        ("sanchez_8r", "pose", [0.1] + [0.0] * 6 + [0.2]),
        ("panda", "pose", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9]),
        ("planar_3r", "position", [0.7, 0.0, 0.0]),
    ],
)
@pytest.mark.parametrize("real", [np.float64, np.float32])
def test_exactly_singular(arm, task, q, real):
    """H is 0: its gradients count nothing, nothing is nan, and damping bounds the rates by |v| / (2 mu)."""
    mine, q = arm_of(arm), np.array(q, real)
    rng = np.random.default_rng(4)
    gains = {"H": 1.0, "1/H": -1.0, "H^(-1/2)": -1.0}
    held = random_targets(mine, task, q).astype(real)
    for _ in range(10):
        velocity = rng.normal(size=mine.tasks[task]).astype(real)
        loose = Stepper(mine, Law(gains), task)(q, held, velocity, 0.01)
        assert loose.manipulability <= 1e-7 if real is np.float32 else loose.manipulability < 1e-15
        assert np.all(np.isfinite(loose.null_motion))
        for damping in (Damping("constant", 0.1), Damping("nakamura", 0.1, 0.05), Damping("chiaverini", 0.1, 0.05)):
            step = Stepper(mine, Law(damping=damping), task)(q, held, velocity, 0.01)
            assert np.all(np.isfinite(step.rates))
            assert np.linalg.norm(step.rates) <= np.linalg.norm(velocity) / (2 * 0.1) * 1.001


#: Postures at which the gradients are compared with 50 digits: any, and near singular.
POSTURES = [
    ("sanchez_8r", [0.1, 0.4, 0.3, 1.0, -0.7, 0.9, 0.5, 0.3]),
    ("sanchez_8r", [0.1, 0.01, -0.02, 0.01, 0.02, 0.01, -0.01, 0.2]),
    ("panda", [0.3, -0.8, 0.4, -2.3, 0.2, 1.6, 0.8]),
    ("panda", [0.3, -0.8, 0.4, -2.3, 0.2, 1e-4, 0.8]),
    ("panda", [0.3, 1e-6, 0.4, -2.3, 0.2, 1e-6, 0.8]),
]


@pytest.mark.parametrize("criterion", CRITERIA[:3])
@pytest.mark.parametrize(("name", "q"), POSTURES)
def test_gradients_against_fifty_digits(name, q, criterion):
    """The null motion of one criterion is its gradient, projected, both at 50 digits from the definitions."""
    arm = arm_of(name)
    gradient = under.gradients(arm.description, "pose", q)[1 + ("H", "1/H", "H^(-1/2)").index(criterion)]
    with mpmath.workdps(60):
        jacobian = reference.jacobian(arm.description, q, 60)
        g = mpmath.matrix(gradient)
        expected = g - jacobian.T * mpmath.lu_solve(jacobian * jacobian.T, jacobian * g)
    found = Stepper(arm, Law({criterion: 1.0}))(q, arm.pose(q), None, 0.01).null_motion
    size = max(abs(float(x)) for x in gradient)
    worst = max(abs(float(mpmath.mpf(float(a)) - b)) for a, b in zip(found, expected, strict=True))
    assert worst <= 20 * EPS * condition(arm.jacobian(q)) * size


def test_limits_criterion_against_fifty_digits():
    """Mean square distance from the middles in half ranges, over 2; joints without limits count nothing."""
    arm = arm_of("PRRRR")
    q = np.array([1.9, 0.3, -2.0, 1.2, 0.4])
    bounds = [(low, high) for low, high in arm.limits.position]

    def criterion(*values):
        total = mpmath.mpf(0)
        for x, (low, high) in zip(values, bounds, strict=True):
            if np.isfinite(low):
                total += ((2 * x - mpmath.mpf(low) - mpmath.mpf(high)) / (mpmath.mpf(high) - mpmath.mpf(low))) ** 2
        return total / 10

    with mpmath.workdps(50):
        g = mpmath.matrix(
            [mpmath.diff(criterion, tuple(map(mpmath.mpf, q)), tuple(int(i == k) for i in range(5))) for k in range(5)]
        )
        jacobian = reference.jacobian(arm.description, q, 50)[:3, :]
        expected = g - jacobian.T * mpmath.lu_solve(jacobian * jacobian.T, jacobian * g)
    found = Stepper(arm, Law({"limits": 1.0}), "position")(q, arm.position(q), None, 0.01).null_motion
    np.testing.assert_allclose(found, [float(x) for x in expected], rtol=0, atol=1e-14)


# ---- damping, weights ------------------------------------------------------------------------------------------


def damping_of(damping, h, jacobian):
    """mu^2 by the formulas."""
    if damping.kind == "constant":
        return np.full(len(h), damping.factor**2)
    if damping.kind == "nakamura":
        return damping.factor**2 * np.maximum(0.0, 1.0 - h / damping.threshold) ** 2
    values = np.linalg.svd(jacobian, compute_uv=False)
    estimate = 1.0 / np.sqrt(np.sum(values**-2.0, axis=-1))
    least, rows = values[:, -1], values.shape[-1]
    assert np.all((least / np.sqrt(rows) <= estimate) & (estimate <= least))
    return damping.factor**2 * np.maximum(0.0, 1.0 - (estimate / damping.threshold) ** 2)


@every_case
@pytest.mark.parametrize("kind", ["constant", "nakamura", "chiaverini"])
def test_damping_is_its_formula(name, task, kind):
    """J* = J^T (J J^T + mu^2 I)^-1 of the weighted J, in NumPy; some postures are above the threshold, some below."""
    arm = arm_of(name)
    law = law_of(arm, 5)
    q, held, velocity, _ = situation(name, task, 300, 5)
    h, scale = arm.manipulability(q, task=task), np.array(law.weights) ** -0.5
    weighted = arm.jacobian(q, task=task) * scale
    at = np.median(h) if kind == "nakamura" else np.median(1 / np.linalg.norm(np.linalg.pinv(weighted), axis=(1, 2)))
    damping = Damping(kind, 0.3, float(at))
    step = Stepper(arm, Law({}, law.feedback, damping, law.weights), task)(q, held, velocity, 0.01)
    squares = damping_of(damping, h, weighted)
    assert kind == "constant" or 0.3 < np.mean(squares > 0) < 0.7
    matrix = weighted @ weighted.transpose(0, 2, 1) + squares[:, None, None] * np.eye(arm.tasks[task])
    y = np.linalg.solve(matrix, asked(arm, task, law, step, velocity)[..., None])
    expected = scale * (weighted.transpose(0, 2, 1) @ y)[..., 0]
    assert np.all(np.abs(step.rates - expected) <= 1e-11 * np.abs(expected).max(axis=-1, keepdims=True))


def test_a_joint_of_infinite_weight_stands_still():
    """The others do what they would do without it: the pseudoinverse of J without its column."""
    arm, locked = arm_of("sanchez_8r"), 3
    q, held, velocity, push = situation("sanchez_8r", "pose", 200, 6)
    weights = tuple(np.inf if j == locked else 1.0 for j in range(8))
    step = Stepper(arm, Law(weights=weights))(q, held, velocity, 0.01, push)
    assert not step.rates[:, locked].any() and not step.null_motion[:, locked].any()
    rest = np.delete(arm.jacobian(q), locked, axis=2)
    inverse = np.linalg.pinv(rest)
    g = np.delete(push, locked, axis=1)[..., None]
    expected = inverse @ (velocity[..., None] - rest @ g) + g
    size = condition(rest)[:, None] * np.abs(expected[..., 0]).max(axis=-1, keepdims=True)
    assert np.all(np.abs(np.delete(step.rates, locked, axis=1) - expected[..., 0]) <= 100 * EPS * size)


# ---- feedback --------------------------------------------------------------------------------------------------


def test_orientation_error():
    """2 sin(angle / 2) times the axis, up to half a turn; there it has no axis and is 0."""
    arm, rng = arm_of("sanchez_8r"), np.random.default_rng(7)
    q = under.random_q(arm, 1, 7)[0]
    stepper, pose = Stepper(arm), arm.pose(q)
    for angle in (1e-9, 1e-3, 0.5, 1.5, 3.0, 3.14):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        turn = np.array(reference.rot_axis(axis, angle).tolist(), float)
        held = np.eye(4)
        held[:3, :3] = turn[:3, :3].T @ pose[:3, :3]
        held[:3, 3] = pose[:3, 3] - [0.1, -0.2, 0.3]
        error = stepper(q, held, None, 0.01).error
        np.testing.assert_allclose(error[:3], [0.1, -0.2, 0.3], rtol=0, atol=1e-15)
        tolerance = 4 * EPS / np.cos(angle / 2) ** 2  # of a rotation known to rounding
        np.testing.assert_allclose(error[3:], 2 * np.sin(angle / 2) * axis, rtol=0, atol=tolerance)


def test_planar_orientation_error():
    arm = arm_of("planar_3r")
    for angle in (-3.0, -0.2, 1e-8, 2.5):
        q = np.array([0.3, 0.4, -0.9])
        held = [*arm.position(q), q.sum() - angle]
        error = Stepper(arm, task="pose")(q, held, None, 0.01).error
        tolerance = 4 * EPS / np.cos(angle / 2) ** 2
        np.testing.assert_allclose(error, [0.0, 0.0, 2 * np.sin(angle / 2)], rtol=0, atol=tolerance)


def test_feedback_closes_the_loop():
    """From far off, also in orientation, the error falls at the rate of the feedback to rounding."""
    arm = arm_of("sanchez_8r")
    q = np.array([0.1, 0.4, 0.3, 1.0, -0.7, 0.9, 0.5, 0.3])
    held = arm.pose(q + np.array([0.2, -0.3, 0.2, 0.3, 0.9, -0.3, 0.6, 0.9]))
    stepper = Stepper(arm, Law(feedback=(4.0, 4.0), damping=Damping("chiaverini", 0.05, 0.05)))
    sizes = []
    for _ in range(1200):
        step = stepper(q, held, None, 0.01)
        q = step.q_next
        sizes.append(np.abs(step.error).max())
    assert sizes[0] > 0.5
    assert sizes[-1] < 1e-13


# ---- priority --------------------------------------------------------------------------------------------------


def test_a_secondary_task():
    """Done where it can be done with the first; where it cannot, as well as possible; the first never notices."""
    arm, rng = arm_of("sanchez_8r"), np.random.default_rng(8)
    law = law_of(arm, 8)
    q, held, velocity, push = situation("sanchez_8r", "pose", 300, 8)
    stepper, jacobian = Stepper(arm, law), arm.jacobian(q)
    scale = np.array(law.weights) ** -0.5
    for rows in (1, 2):
        second, wanted_second = rng.normal(size=(len(q), rows, 8)), rng.normal(size=(len(q), rows))
        step = stepper(q, held, velocity, 0.01, push, secondary=(second, wanted_second))
        wanted = asked(arm, "pose", law, step, velocity)
        both = np.concatenate([jacobian, second], axis=1)
        right = np.concatenate([wanted, wanted_second], axis=1)
        missed = np.linalg.norm((both @ step.rates[..., None])[..., 0] - right, axis=-1)
        size = np.linalg.norm(right, axis=-1) + np.linalg.norm(push, axis=-1)
        assert np.all(missed <= 40 * EPS * condition(both * scale) * size)
        assert np.abs(both @ step.null_motion[..., None]).max() <= 1e-12
        first = np.linalg.norm((jacobian @ step.rates[..., None])[..., 0] - wanted, axis=-1)
        most = np.linalg.norm(step.rates / scale, axis=-1) + size
        assert np.all(first <= 40 * EPS * condition(jacobian * scale) * most)
    # with every joint to spare taken, nothing is left for the gradients
    assert np.abs(step.null_motion).max() <= 1e-11


def test_a_secondary_task_that_contradicts():
    """It asks for other velocities of the tip: damped, it changes nothing."""
    arm = arm_of("sanchez_8r")
    q, held, velocity, _ = situation("sanchez_8r", "pose", 100, 9)
    jacobian = arm.jacobian(q)
    law = Law(damping=Damping("chiaverini", 0.05, 1e-3))
    alone = Stepper(arm, law)(q, held, velocity, 0.01)
    both = Stepper(arm, law)(q, held, velocity, 0.01, secondary=(jacobian[:, :2], velocity[:, :2] + 1.0))
    np.testing.assert_allclose(both.rates, alone.rates, rtol=0, atol=1e-9)


def test_a_secondary_task_of_strict_formula():
    """rates_1 + (J2 P1)+ (v2 - J2 rates_1), in NumPy, with as many rows as joints are to spare."""
    arm, rng = arm_of("planar_3r"), np.random.default_rng(10)
    q, held, velocity, _ = situation("planar_3r", "position", 200, 10)
    second, wanted = rng.normal(size=(len(q), 1, 3)), rng.normal(size=(len(q), 1))
    step = Stepper(arm)(q, held, velocity, 0.01, secondary=(second, wanted))
    inverse = np.linalg.pinv(arm.jacobian(q))
    first = inverse @ velocity[..., None]
    projected = second @ (np.eye(3) - inverse @ arm.jacobian(q))
    expected = (first + np.linalg.pinv(projected) @ (wanted[..., None] - second @ first))[..., 0]
    size = condition(np.concatenate([arm.jacobian(q), second], axis=1))[:, None] * np.abs(expected).max(
        axis=1, keepdims=True
    )
    assert np.all(np.abs(step.rates - expected) <= 100 * EPS * size)


# ---- precision, batches ----------------------------------------------------------------------------------------

LESSER = [
    ("planar_3r", "redundancy_x_alpha", "step_x_alpha"),
    ("planar_3r", "priority_position", "priority_position"),
    ("orthogonal_3r(1, 2, 1.5, 1)", "redundancy_position", "step_position"),
]


@pytest.mark.parametrize(("name", "group", "function"), LESSER)
def test_made_on_first_use_against_forty_digits(name, group, function):
    """As tests/test_kernels.py does it for what is generated beforehand."""
    arm = under.ARMS[name]
    q = under.random_q(arm, 6, 1)
    exact = [under.truth(name, group, function, row) for row in q]
    bounds = under.bounds_for(name, group, function, q)
    for error, bound in zip(
        under.errors_against(under.outputs_of(arm.evaluator(function), arm, q), exact), bounds, strict=True
    ):
        assert np.all(error <= bound) and np.isfinite(bound).mean() > 0.7


def test_long_chain():
    """Ten joints: H and its gradient through the pivots of a factorisation; the NumPy code of the same step."""
    arm = cr.Arm.from_dh([("R", (-1) ** k * np.pi / 2, 0.1 + 0.02 * k, 0.2, 0.0) for k in range(10)], name="snake10")
    (function,) = catalogue.functions(arm.description.model, "redundancy_pose")
    space: dict = {}
    exec(emit.unit("snake", "snake", "snake", [lower(function)], "0" * 64)["snake.py"], space)
    rng = np.random.default_rng(11)
    q, velocity = rng.uniform(-1.0, 1.0, 10), rng.normal(size=6)
    code = under.emitted(arm, "kinematics")
    held, jacobian = code["pose"](q), code["jacobian_pose"](q)
    settings = np.zeros(len(redundancy.SETTINGS))
    settings[redundancy.SETTINGS.index("gain_H")] = 1.0
    joints = np.array([np.ones(10), np.ones(10), np.zeros(10), np.zeros(10)])
    _, rates, h, _, null = space["step_pose"](q, held, velocity, np.zeros(10), joints, settings)
    truth = under.gradients(arm.description, "pose", q)
    gradient = np.array([float(x) for x in truth[1]])
    assert abs(float(h) / float(truth[0][0]) - 1) < 1e-14
    np.testing.assert_allclose(jacobian @ rates, velocity, rtol=0, atol=1e-13)
    np.testing.assert_allclose(null, gradient - np.linalg.pinv(jacobian) @ jacobian @ gradient, rtol=0, atol=1e-13)


def test_single_precision():
    """float32 in, float32 out, within 60 eps cond(J) of the double step."""
    arm = arm_of("sanchez_8r")
    law = Law({"H": 0.3, "limits": -0.2}, feedback=(3.0, 2.0))
    given = [array.astype(np.float32) for array in situation("sanchez_8r", "pose", 500, 12)]
    stepper = Stepper(arm, law)
    q, held, velocity, push = given
    step = stepper(q, held, velocity, 0.01, push)
    double = stepper(*(array.astype(float) for array in (q, held, velocity)), 0.01, push.astype(float))
    assert all(getattr(step, name).dtype == np.float32 for name in step.__dataclass_fields__)
    error = np.abs(step.rates - double.rates).max(axis=-1)
    assert np.all(
        error
        <= 60 * np.finfo(np.float32).eps * condition(arm.jacobian(q.astype(float))) * np.abs(double.rates).max(axis=-1)
    )


def test_batches():
    """None, one or many; broadcast; the same call gives the same bits, another place in a batch the same to rounding.

    (A compiler may contract the operations of the last, incomplete tile otherwise.)
    """
    arm = arm_of("sanchez_8r")
    stepper = Stepper(arm, law_of(arm, 13))
    q, held, velocity, push = situation("sanchez_8r", "pose", 130, 13)
    whole = stepper(q, held, velocity, 0.01, push)
    again = stepper(q[::-1], held[::-1], velocity[::-1], 0.01, push[::-1])
    some = stepper(q[:64], held[:64], velocity[:64], 0.01, push[:64])
    assert under.all_equal(some.rates, whole.rates[:64])
    assert under.all_equal(stepper(q, held, velocity, 0.01, push).rates, whole.rates)
    np.testing.assert_allclose(again.rates[::-1], whole.rates, rtol=0, atol=1e-12)
    alone = stepper(q[5], held[5], velocity[5], 0.01, push[5])
    np.testing.assert_allclose(alone.rates, whole.rates[5], rtol=0, atol=1e-12)
    empty = stepper(np.zeros((0, 8)), np.zeros((0, 4, 4)), np.zeros((0, 6)), 0.01)
    assert empty.rates.shape == (0, 8) and empty.manipulability.shape == (0,)
    grid = stepper(q[:3, None], held[0], velocity[0], [0.01, 0.02])
    assert grid.q_next.shape == (3, 2, 8)
    np.testing.assert_allclose(grid.q_next[:, 1] - q[:3], 2 * (grid.q_next[:, 0] - q[:3]), rtol=0, atol=1e-13)
    kept = stepper(q, held, velocity, 0.01, push, out=again)
    assert kept is again and under.all_equal(again.rates, whole.rates)


@pytest.mark.parametrize("real", [np.float64, np.float32])
def test_bound(real):
    """In place, the same bits as a call; what was written into the arrays is what counts."""
    arm = arm_of("sanchez_8r")
    stepper = Stepper(arm, law_of(arm, 17))
    loop = stepper.bind(0.01, real)
    for q, held, velocity, push in zip(*situation("sanchez_8r", "pose", 5, 17), strict=True):
        given = [a.astype(real) for a in (q, held, velocity, push)]
        loop.q[:], loop.held[:], loop.velocity[:], loop.push[:] = given
        loop()
        expected = stepper(*given[:3], 0.01, given[3])
        for name in expected.__dataclass_fields__:
            assert getattr(loop, name).dtype == real
            assert under.all_equal(getattr(loop, name), getattr(expected, name))


def test_nan_stays_in_its_row():
    arm = arm_of("sanchez_8r")
    stepper = Stepper(arm, law_of(arm, 14))
    q, held, velocity, push = situation("sanchez_8r", "pose", 70, 14)
    clean = stepper(q, held, velocity, 0.01, push)
    q[3, 0], held[10, 1, 2], velocity[20, 4], push[69, 0] = np.nan, np.nan, np.inf, np.nan
    dirty = stepper(q, held, velocity, 0.01, push)
    touched = np.isin(np.arange(70), [3, 10, 20, 69])
    assert np.isnan(dirty.rates[touched]).any(axis=-1).all()
    assert under.all_equal(dirty.rates[~touched], clean.rates[~touched])


def test_many_laws_at_once():
    """A sequence of laws is a leading axis: each row is what its law gives alone."""
    arm = arm_of("sanchez_8r")
    q, held, velocity, push = (a[0] for a in situation("sanchez_8r", "pose", 1, 15))
    laws = [Law({"H": g}, damping=Damping("constant", d)) for g in (0.0, 1.0) for d in (0.0, 0.1)]
    together = Stepper(arm, laws)(q, held, velocity, 0.01, push)
    for row, law in zip(together.rates, laws, strict=True):
        np.testing.assert_allclose(row, Stepper(arm, law)(q, held, velocity, 0.01, push).rates, rtol=0, atol=1e-13)


# ---- what is refused -------------------------------------------------------------------------------------------


FLAT, TWO = ([0.0] * 3, [0.0] * 3, None, 0.01), (np.ones((2, 3)), [1.0, 1.0])


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Law({"w": 1.0}), "any of H, 1/H"),
        (lambda: Law({"H": np.nan}), "gain of H"),
        (lambda: Law(feedback=(1.0, -1.0)), "two numbers, 0 or more"),
        (lambda: Law(feedback=1.0), "two numbers, 0 or more"),
        (lambda: Law(weights=(1.0, 0.0)), "above 0"),
        (lambda: Law(damping="constant"), "a Damping is accepted"),
        (lambda: Damping("tikhonov"), "none, constant, nakamura, chiaverini"),
        (lambda: Damping("constant", -1.0), "0 or more"),
        (lambda: Damping("nakamura", 0.1), "above 0"),
        (lambda: Stepper(arm_of("panda"), Law(weights=(1.0,) * 6)), "7, one for each joint of panda"),
        (lambda: Stepper(arm_of("panda"), "H"), "a Law"),
        (lambda: Stepper(arm_of("planar_3r"), task="speed"), "there is no task"),
        (lambda: Stepper(cr.planar("RR", [1.0, 1.0]), task="pose"), "3 rows for 2 joints"),
        (lambda: Stepper(arm_of("panda")).bind("fast"), "dt"),
        (lambda: Stepper(arm_of("panda")).bind(0.01, int), "float64 or float32"),
        (lambda: Stepper(arm_of("panda"), [Law()]).bind(0.01), "one law"),
        (lambda: Stepper(arm_of("panda"))([0.0] * 6, np.eye(4), None, 0.01), r"q has shape \(6,\)"),
        (lambda: Stepper(arm_of("panda"))([0.0] * 7, np.eye(3), None, 0.01), "held has shape"),
        (lambda: Stepper(arm_of("panda"))([0.0] * 7, np.eye(4), None, "fast"), "dt"),
        (lambda: Stepper(arm_of("planar_3r"))(*FLAT[:1], [0.0, 0.0], *FLAT[2:], secondary=TWO), "k from 1 to 1"),
        (lambda: Stepper(arm_of("planar_3r"), task="pose")(*FLAT, secondary=TWO), "no joint to spare"),
        (lambda: Stepper(arm_of("panda"))([0.0] * 7, np.eye(4), None, 0.01, secondary=3), "secondary: 3; a Jacobian"),
        (lambda: Stepper(arm_of("panda"))([0.0] * 7, np.eye(4), None, 0.01, secondary=("a", 0)), "real numbers"),
    ],
)  # fmt: skip
def test_refusals(make, said):
    with pytest.raises(cr.InputError, match=said) as caught:
        make()
    under.one_line(caught.value)


def test_plain_data():
    step = Step(np.zeros(2), np.ones(2), np.float64(0.5), np.zeros(2), np.zeros(2))
    assert step.to_dict() == {
        "q_next": [0, 0],
        "rates": [1, 1],
        "manipulability": 0.5,
        "error": [0, 0],
        "null_motion": [0, 0],
    }
    law = Law({"H": 1}, weights=[1, 2])
    assert Law(**{**law.to_dict(), "damping": Damping(**law.to_dict()["damping"])}) == law
    assert Law(weights=[1, np.inf]).to_dict()["weights"] == [1.0, None]  # JSON has no infinity


def test_groups_are_those_of_the_catalogue():
    for name in ("panda", "planar_3r", "ur5e", "orthogonal_3r(1, 2, 1.5, 1)"):
        arm = under.ARMS[name]
        assert arm.groups_on_first_use == catalogue.first_use(arm.description.model)
        assert not set(arm.groups_on_first_use) & set(arm.groups)
    for model, groups in catalogue.SHIPPED.items():
        assert set(groups) <= set(under.ARMS[model].groups_on_first_use)
        assert all(f"{model}_{group}" in under.MANIFEST["units"] for group in groups)


# ---- C for a microcontroller -----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def folder(tmp_path_factory, c_compiler):
    """The C folder of an arm with few functions and three joints to spare."""
    arm = cr.planar("RRPRR", [0.5, 0.4, 0.3, 0.3, 0.2], [0.0, 0.0, 0.3, 0.0, 0.0], name="reacher")
    arm = arm.with_limits(position=[(-2.0, 1.0), None, (0.0, 0.5), None, (-1.0, 1.0)])
    place = tmp_path_factory.mktemp("reacher")
    cr.generate(arm, place, targets=["c"])
    return arm, place


def built(place, target, *words):
    subprocess.run([*compiling.compiler(), "-std=c99", *words, "-o", target, "-lm"], check=True, cwd=place)
    return place / target


def test_c_folder_under_the_sanitizers(folder):
    """Warnings are errors; every function against 40 digits, and the step with a law against the function behind it."""
    _, place = folder
    strict = ("-Wall", "-Wextra", "-Werror", "-pedantic", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    sources = ("reacher.c", "reacher_step.c", "reacher_float.c", "test_reacher.c")
    program = built(place, "checked", "-O0", *strict, *sources)
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines()
    assert said[-1] == "pass"
    names = ("step_position", "priority_position", "step", "stepf", "priority_step", "priority_stepf")
    for word in (f"reacher_{name} " for name in names):
        assert any(line.startswith(word) and line.endswith("pass") for line in said)


def test_c_step_is_the_step_in_python(folder):
    """Compiled alike, bit for bit; the law that C starts from is the arm's own."""
    arm, place = folder
    flags = compiling._flags()
    alike = [*flags["common"], *flags["first_use"], *flags[compiling.instruction_set()]]
    library = ctypes.CDLL(str(built(place, "alike.so", "-shared", "-fPIC", *alike, "reacher.c", "reacher_step.c")))
    names = [*redundancy.SETTINGS[:-1], *("mobility", "push", "middle", "narrowness"), "parameters"]
    sizes = [1] * (len(redundancy.SETTINGS) - 1) + [arm.n] * 4 + [arm.parameters.size]

    class CLaw(ctypes.Structure):
        _fields_ = [(name, ctypes.c_double * size) for name, size in zip(names, sizes, strict=True)]

    law = CLaw()
    library.reacher_law_init(ctypes.byref(law))
    assert list(law.parameters) == list(arm.parameters) and list(law.mobility) == [1.0] * arm.n
    law.gain_H[0], law.gain_limits[0], law.feedback_position[0] = 0.3, -0.5, 4.0
    law.damping_nakamura[0], law.inverse_threshold_H[0] = 0.1, 2.0
    step = library.reacher_step
    step.restype, numbers = ctypes.c_double, ctypes.POINTER(ctypes.c_double)
    step.argtypes = [ctypes.c_void_p, numbers, numbers, numbers, ctypes.c_double, numbers, numbers]
    stepper = Stepper(arm, Law({"H": 0.3, "limits": -0.5}, (4.0, 0.0), Damping("nakamura", 0.1, 0.5)))
    rng = np.random.default_rng(16)
    for _ in range(50):
        q, held, velocity = rng.uniform(-1.0, 1.0, 5), rng.uniform(-1.0, 1.0, 2), rng.normal(size=2)
        expected = stepper(q, held, velocity, 0.01)
        inout, rates = q.copy(), np.empty(5)
        pointers = [a.ctypes.data_as(numbers) for a in (inout, held, velocity, inout, rates)]
        h = step(ctypes.byref(law), *pointers[:3], 0.01, *pointers[3:])
        assert under.all_equal(inout, expected.q_next) and under.all_equal(rates, expected.rates)
        assert h == expected.manipulability
        step(ctypes.byref(law), q.ctypes.data_as(numbers), *pointers[1:3], 0.01, pointers[3], None)
        assert under.all_equal(inout, expected.q_next)
    both = library.reacher_priority_step
    both.restype, both.argtypes = ctypes.c_double, [*step.argtypes[:4], numbers, numbers, *step.argtypes[4:]]
    for _ in range(50):
        q, held, velocity = rng.uniform(-1.0, 1.0, 5), rng.uniform(-1.0, 1.0, 2), rng.normal(size=2)
        second, wanted = np.zeros((3, 5)), np.zeros(3)
        second[0], wanted[0] = rng.normal(size=5), 0.7
        expected = stepper(q, held, velocity, 0.01, secondary=(second[:1], wanted[:1]))
        inout, rates = q.copy(), np.empty(5)
        pointers = [a.ctypes.data_as(numbers) for a in (inout, held, velocity, second, wanted, inout, rates)]
        h = both(ctypes.byref(law), *pointers[:5], 0.01, *pointers[5:])
        assert under.all_equal(inout, expected.q_next) and under.all_equal(rates, expected.rates)
        assert h == expected.manipulability


def test_c_along_another_task(tmp_path):
    """The task is chosen; with as many rows as joints there is no secondary one; more rows are refused."""
    arm = cr.planar("RRR", [0.5, 0.4, 0.3], name="three")
    cr.generate(arm, tmp_path / "pose", targets=["c"], task="pose")
    header = (tmp_path / "pose/three_step.h").read_text()
    assert "one step of three along its pose" in header.replace("\n * ", " ") and "velocity[3]" in header
    assert "priority" not in header
    cr.generate(arm, tmp_path / "position", targets=["c"])
    assert "secondary[1][3]" in (tmp_path / "position/three_step.h").read_text()
    with pytest.raises(cr.InputError, match="'pose' has 3 rows for 2 joints"):
        cr.generate(cr.planar("RR", [0.5, 0.4]), tmp_path / "none", task="pose")
    if compiling.compiler() is not None:
        names = ("three.c", "three_step.c", "three_float.c", "test_three.c")
        said = subprocess.run([built(tmp_path / "pose", "checked", "-O0", *names)], capture_output=True, text=True)
        assert said.stdout.splitlines()[-1] == "pass"


def test_every_arm_with_a_step_has_one_in_c(tmp_path):
    """Eight joints: the header says what goes in; an arm of fewer joints than its task has rows gets none."""
    cr.generate(under.ARMS["sanchez_8r"], tmp_path / "eight", targets=["c"])
    header = (tmp_path / "eight/sanchez_8r_step.h").read_text()
    assert "in   q[8], held[4][4] (homogeneous, row by row), velocity[6]" in header
    few = cr.Arm.from_dh([("R", (-1) ** k * 1.2, 0.3, 0.1, 0.0) for k in range(4)], name="few")
    cr.generate(few, tmp_path / "few", targets=["c"])
    assert not list((tmp_path / "few").glob("*_step.*"))


def test_c_of_an_arm_that_is_always_singular(tmp_path, c_compiler):
    """Two prismatic joints never turn the tip: H of that task is 0, its gradients too; the folder passes its test."""
    cr.generate(cr.planar("PP", [0.5, 0.4], [0.0, 0.4], name="table"), tmp_path, targets=["c"])
    program = built(tmp_path, "checked", "-O0", "table.c", "table_step.c", "table_float.c", "test_table.c")
    assert subprocess.run([program], capture_output=True, text=True).stdout.splitlines()[-1] == "pass"
