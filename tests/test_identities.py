"""What must hold for every arm: checked at 40 digits on random chains, and in doubles on the embedded arms."""

from __future__ import annotations

import math
from functools import lru_cache

import arms_under_test as under
import mpmath
import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st

import chainrule as cr
from chainrule.derive import catalogue
from chainrule.derive.program import evaluate

QUARTERS = [0.0, math.pi / 2, -math.pi / 2, math.pi]
angle = st.one_of(st.sampled_from(QUARTERS), st.floats(-3.0, 3.0).map(lambda x: round(x, 3)))
length = st.one_of(st.just(0.0), st.floats(-1.0, 1.0).map(lambda x: round(x, 3)))
row = st.tuples(st.sampled_from("RRRP"), angle, length, length, angle)
chains = st.builds(
    lambda rows, convention, tool: cr.Arm.from_dh(rows, convention=convention, tool=tool, name="random"),
    st.lists(row, min_size=3, max_size=8),
    st.sampled_from(["modified", "standard"]),
    st.tuples(length, length, length),
)
planar_chains = st.integers(2, 6).flatmap(
    lambda n: st.builds(
        lambda kinds, lengths, turns: cr.planar(
            kinds, lengths, [t if k == "P" else 0.0 for k, t in zip(kinds, turns, strict=True)]
        ),
        st.text("RP", min_size=n, max_size=n),
        st.lists(length, min_size=n, max_size=n),
        st.lists(angle, min_size=n, max_size=n),
    )
)
seeds = st.integers(0, 2**32 - 1)


@lru_cache(maxsize=4)
def _programs(digest, arm):
    return {
        f.name: f.program
        for group in ("kinematics", *arm.full_rank_tasks)
        for f in catalogue.functions(arm.description.model, group)
    }


def value(arm, name, q, digits=40):
    """One derived function at 40 digits, its only output as a flat list."""
    (entries,) = evaluate(_programs(arm.description.model.digest, arm)[name], under.inputs_of(arm, q), digits).values()
    return entries


def matrix(entries, rows):
    columns = len(entries) // rows
    return mpmath.matrix([entries[i * columns : (i + 1) * columns] for i in range(rows)])


def largest(a):
    return max((abs(x) for x in a), default=mpmath.mpf(0))


def configuration(arm, seed):
    return [float(x) for x in under.random_q(arm, 1, seed)[0]]


def rotation_error(pose, size):
    rotation = pose[:size, :size]
    return max(largest(rotation * rotation.T - mpmath.eye(size)), abs(under.determinant(rotation.tolist()) - 1))


def check_kinematics(arm, q):
    """Pose and Jacobian are the reference's; the rotation is one; the Jacobian is the derivative of the pose."""
    size = 3 if "x_alpha" in arm.tasks else 4
    pose, here = matrix(value(arm, "pose", q), size), reference.pose(arm.description, q, 40)
    assert largest(pose - here) < 1e-35
    # Twists that are no quarter turns are rounded to doubles once, in the description.
    assert rotation_error(pose, size - 1) < 1e-15 * arm.n
    assert [pose[i, size - 1] for i in range(size - 1)] == value(arm, "position", q)
    for task, rows in arm.tasks.items():
        found = matrix(value(arm, f"jacobian_{task}", q), rows)
        assert largest(found - under.task_jacobian(arm.description, task, q)) < 1e-35
    step, whole = mpmath.mpf(10) ** -18, matrix(value(arm, "jacobian_pose", q), arm.tasks["pose"])
    for i in range(arm.n):
        ahead, behind = ([*q[:i], q[i] + s, *q[i + 1 :]] for s in (step, -step))
        rate = (matrix(value(arm, "pose", ahead), size) - matrix(value(arm, "pose", behind), size)) / (2 * step)
        spin = rate[: size - 1, : size - 1] * pose[: size - 1, : size - 1].T
        turning = [spin[1, 0]] if size == 3 else [spin[2, 1], spin[0, 2], spin[1, 0]]
        expected = [*(rate[k, size - 1] for k in range(size - 1)), *turning]
        assert max(abs(whole[k, i] - expected[k]) for k in range(len(expected))) < 1e-15 * arm.n


def check_manipulability(arm, q, task):
    """Minors, H, null vector and projector of one task, against the reference Jacobian."""
    jacobian, rows = under.task_jacobian(arm.description, task, q), arm.tasks[task]
    scale = mpmath.mpf(1)
    for i in range(rows):
        scale *= mpmath.norm(jacobian[i, :])
    rounded = (scale + 1) * mpmath.mpf(10) ** -14  # where the derivation looks from another link, twists are rounded
    h = value(arm, f"manipulability_{task}", q)[0]
    assert abs(h - under.manipulability(arm.description, task, q, 80)) < rounded
    programs = _programs(arm.description.model.digest, arm)
    if f"minors_{task}" in programs:
        minors = value(arm, f"minors_{task}", q)
        expected = under.minors_of(jacobian)
        assert max(abs(a - b) for a, b in zip(minors, expected, strict=True)) < rounded
        assert abs(mpmath.sqrt(mpmath.fsum(m**2 for m in minors)) - h) < mpmath.mpf(10) ** -38 * (h + 1)  # Cauchy-Binet
    if f"null_vector_{task}" in programs:
        null = mpmath.matrix(value(arm, f"null_vector_{task}", q))
        assert largest(jacobian * null) < rounded * (1 + largest(jacobian))
        assert abs(mpmath.norm(null) - h) < mpmath.mpf(10) ** -38 * (h + 1)
    if f"null_projector_{task}" in programs and h > scale / 1000:
        projector = matrix(value(arm, f"null_projector_{task}", q), arm.n)
        assert largest(projector - projector.T) == 0
        assert largest(projector * projector - projector) < mpmath.mpf(10) ** -30
        assert largest(jacobian * projector) < mpmath.mpf(10) ** -10 * (1 + largest(jacobian))
        trace = mpmath.fsum(projector[i, i] for i in range(arm.n))
        assert abs(trace - (arm.n - rows)) < mpmath.mpf(10) ** -30
        if f"null_vector_{task}" in programs:
            assert largest(projector * null - null) < mpmath.mpf(10) ** -10 * (h + 1)


@settings(max_examples=25)
@given(chains, seeds)
def test_random_spatial_kinematics(arm, seed):
    with mpmath.workdps(50):
        check_kinematics(arm, configuration(arm, seed))


@settings(max_examples=25)
@given(chains, seeds)
def test_random_spatial_manipulability(arm, seed):
    q = configuration(arm, seed)
    with mpmath.workdps(50):
        for task in arm.full_rank_tasks:
            check_manipulability(arm, q, task)


@settings(max_examples=40)
@given(planar_chains, seeds)
def test_random_planar_kinematics(arm, seed):
    with mpmath.workdps(50):
        check_kinematics(arm, configuration(arm, seed))


@settings(max_examples=40)
@given(planar_chains, seeds)
def test_random_planar_manipulability(arm, seed):
    q = configuration(arm, seed)
    with mpmath.workdps(50):
        for task in arm.full_rank_tasks:
            check_manipulability(arm, q, task)


@settings(max_examples=15)
@given(chains, seeds)
def test_manipulability_does_not_depend_on_the_base(arm, seed):
    """Turning the first joint (or shifting it) moves the whole arm; for the pose neither does the last joint matter."""
    q = configuration(arm, seed)
    for task in arm.full_rank_tasks:
        here = value(arm, f"manipulability_{task}", q)[0]
        assert value(arm, f"manipulability_{task}", [q[0] + 1.234, *q[1:]])[0] == here
        if task == "pose":
            assert value(arm, f"manipulability_{task}", [*q[:-1], q[-1] - 0.77])[0] == here
        # The reference does not know that: it agrees to its digits.
        turned = under.manipulability(arm.description, task, [q[0] + 1.234, *q[1:]])
        assert abs(turned - under.manipulability(arm.description, task, q)) < 1e-13


@settings(max_examples=12)
@given(chains, st.floats(-3, 3), st.floats(-1, 1), seeds)
def test_a_moved_base_moves_the_pose_and_nothing_else(arm, turn, shift, seed):
    """The first row's alpha, a, d and theta place the base: poses move rigidly, H stays."""
    rows = [tuple(getattr(r, c) for c in ("kind", "alpha", "a", "d", "theta")) for r in arm.description.geometry.table]
    plain = cr.Arm.from_dh(rows, convention="modified", name="plain")
    kind, alpha, a, d, theta = rows[0]
    moved = cr.Arm.from_dh([(kind, alpha, a + shift, d, theta), *rows[1:]], convention="modified", name="moved")
    q = configuration(arm, seed)
    with mpmath.workdps(50):
        first, second = (matrix(value(x, "pose", q), 4) for x in (plain, moved))
        first[0, 3] += mpmath.mpf(a + shift) - mpmath.mpf(a)
        assert largest(first - second) < 1e-15
    for task in plain.full_rank_tasks:
        h, other = (value(x, f"manipulability_{task}", q)[0] for x in (plain, moved))
        assert abs(h - other) < 1e-14


@settings(max_examples=10)
@given(st.lists(row, min_size=3, max_size=5), seeds)
def test_gradient_of_random_chains(rows, seed):
    """The generated NumPy gradient against differences of the reference's H; the base joint's entry is exactly 0."""
    arm = cr.Arm.from_dh(rows, name="random")
    q = configuration(arm, seed)
    exact = under.gradients(arm.description, "position", q)
    h, *gradients = under.emitted(arm, "position")["manipulability_gradient_position"](np.array(q))
    assert gradients[0][0] == 0 and gradients[1][0] == 0 and gradients[2][0] == 0
    if exact[0][0] > 1e-3:
        assert abs(h - exact[0][0]) < 1e-14
        for gradient, truth in zip(gradients, exact[1:], strict=True):
            assert max(abs(a - b) for a, b in zip(gradient, truth, strict=True)) < 1e-10 * (1 + float(largest(truth)))


# ---- the embedded arms, in doubles -----------------------------------------------------------------------------

EMBEDDED = pytest.mark.parametrize(
    "name", [name for name, arm in under.ARMS.items() if "(0, 0, 0)" not in name and isinstance(arm, cr.Arm)]
)


@EMBEDDED
def test_compiled_identities(name):
    """Thousands of configurations at once: J N = 0, |N| = H, P a projector onto the null space, rotations rotations."""
    arm = under.ARMS[name]
    q = under.random_q(arm, 2000, 8)
    pose = arm.pose(q)
    size = pose.shape[-1] - 1
    rotation = pose[:, :size, :size]
    assert np.abs(rotation @ rotation.swapaxes(1, 2) - np.eye(size)).max() < 4e-15
    assert np.abs(np.linalg.det(rotation) - 1).max() < 4e-15
    assert np.array_equal(pose[:, -1], np.broadcast_to(np.eye(size + 1)[-1], (2000, size + 1)))
    for task in arm.full_rank_tasks:
        jacobian, h, minors = (f(q, task=task) for f in (arm.jacobian, arm.manipulability, arm.minors))
        reach = np.linalg.norm(jacobian, axis=2).prod(axis=1)
        assert np.all(np.abs(np.linalg.norm(minors, axis=-1) - h) <= 1e-15 * reach)
        values = np.linalg.svd(jacobian, compute_uv=False)
        assert np.all(np.abs(values.prod(axis=1) - h) <= 4e-15 * values[:, 0] ** arm.tasks[task])
        assert np.all(arm.manipulability_gradient(q, task=task)[:, 0] == 0) or task == "x_alpha"
        if arm.n == arm.tasks[task] + 1:
            null = arm.null_vector(q, task=task)
            product = np.linalg.norm(np.einsum("kij,kj->ki", jacobian, null), axis=1)
            assert np.all(product <= 1e-14 * reach * np.linalg.norm(jacobian, axis=(1, 2)))
            assert np.all(np.abs(np.linalg.norm(null, axis=1) - h) <= 1e-15 * reach)
        if arm.n > arm.tasks[task]:
            projector, regular = arm.null_projector(q, task=task), h > 1e-3 * reach
            assert np.array_equal(projector, projector.swapaxes(1, 2))
            assert np.abs(projector @ projector - projector).max() < 1e-14
            assert np.abs((jacobian @ projector)[regular]).max(initial=0) < 1e-14


@EMBEDDED
def test_together_is_what_it_is_apart(name):
    """Pose (or position) and Jacobian in one evaluation are those of the two functions."""
    arm = under.ARMS[name]
    q = under.random_q(arm, 100, 9)
    for task in arm.tasks:
        place, jacobian = arm.kinematics(q, task=task)
        apart = arm.position(q) if task == "position" else arm.pose(q)
        assert np.abs(place - apart).max() < 1e-14
        assert np.abs(jacobian - arm.jacobian(q, task=task)).max() < 1e-14


@pytest.mark.parametrize("kinds", ["RPR", "PRP", "PPR", "RRP"])
def test_planar_chains_with_shifts(kinds):
    """Generated code of position, pose and every task's Jacobian against the reference; one of them compiled."""
    arm = cr.planar(kinds, [1.0, 0.5, 0.25], [0.4 if kind == "P" else 0.0 for kind in kinds])
    q = under.random_q(arm, 9, 10)
    code = under.emitted(arm, "kinematics")
    check_planar(arm, q, code["pose"](q), {task: code[f"jacobian_{task}"](q) for task in arm.tasks})
    if kinds == "RPR":
        assert arm.evaluator("pose").compiled
        check_planar(arm, q, arm.pose(q), {task: arm.jacobian(q, task=task) for task in arm.tasks})


def check_planar(arm, q, pose, jacobians):
    for k in (0, 8):
        exact = reference.pose(arm.description, list(q[k]))
        assert reference.distance(mpmath.matrix(pose[k].tolist()), exact) < 1e-15
        for task, found in jacobians.items():
            truth = under.task_jacobian(arm.description, task, list(q[k]))
            assert reference.distance(mpmath.matrix(found[k].tolist()), truth) < 2e-15
