"""Every generated function of every arm: compiled code against 40 digits, float against double, C against NumPy."""

from __future__ import annotations

import os
import subprocess
import sys
from functools import cache

import arms_under_test as under
import numpy as np
import pytest

import chainrule as cr
from chainrule import compile as compiling

CASES = [
    pytest.param(*case, id="-".join(case), marks=pytest.mark.xdist_group(f"kernels {case[0]}"))
    for case in under.cases()
]
every_function = pytest.mark.parametrize(("arm", "group", "function"), CASES)

COUNT = 6  # configurations at 40 digits for each function


@cache
def exact_values(arm, group, function, seed=1):
    q = under.random_q(under.ARMS[arm], COUNT, seed)
    return q, [under.truth(arm, group, function, row) for row in q]


def compiled(arm, function):
    found = under.ARMS[arm].evaluator(function)
    assert found.compiled
    return found


@every_function
def test_double_against_forty_digits(arm, group, function):
    """Within the rounding of its own operations, entry by entry."""
    q, exact = exact_values(arm, group, function)
    found = under.outputs_of(compiled(arm, function), under.ARMS[arm], q)
    errors, bounds = under.errors_against(found, exact), under.bounds_for(arm, group, function, q)
    for array, error, bound in zip(found, errors, bounds, strict=True):
        assert np.all(np.isfinite(array))
        if function.startswith("postures_"):  # an angle of half a turn has either sign: that of a zero
            error = np.where(error > 6.0, np.abs(error - 2.0 * np.pi) - 1e-15, error)
        assert np.all(error <= bound)
        # The bound says something, unless a length of 0 makes rounding decide whether a solution is at infinity.
        least = 0.4 if group == "speed_ratio" else 0.7  # verdicts on what is exactly zero are left to rounding
        special = "0," in arm or ", 0)" in arm or function.startswith("postures_") or (group, function) == ITERATED
        assert np.isfinite(bound).mean() > least or not array.any() or special


#: Newton steps forget rounding instead of adding it up: what such steps find has no bound, and a test of its own.
ITERATED = ("cuspidality", "postures")


@pytest.mark.parametrize("arm", [arm for arm, group, function in under.cases() if (group, function) == ITERATED])
def test_iterated_roots_against_forty_digits(arm):
    """The pairs of postures that are real, where axes 1 and 2 do not meet: to 1e-9 rad, however they were iterated."""
    q, exact = exact_values(arm, *ITERATED)
    found = under.outputs_of(compiled(arm, ITERATED[1]), under.ARMS[arm], q)
    angles, room = (error.reshape(len(q), 2, -1) for error in under.errors_against(found, exact)[:2])
    real = found[1].reshape(room.shape) > 1e-3
    generic = under.ARMS[arm].parameters[-5 if under.ARMS[arm].parameters.size == 9 else 0] != 0.0
    turned = np.minimum(angles, np.abs(2 * np.pi - angles))
    assert np.all((turned <= 1e-9) | ~real | (not generic))
    assert np.all((room <= 1e-9) | (not generic))


PLAIN = [
    case
    for case in CASES
    if case.values[1] in ("kinematics", "position", "x_alpha", "pose")
    and not any(word in case.values[2] for word in ("gradient", "postures"))
]


@pytest.mark.parametrize(("arm", "group", "function"), PLAIN)
def test_double_in_plain_figures(arm, group, function):
    """To 1e-15 (five units in the last place): kinematics and projectors of their largest entry, minors and H of the
    product of the Jacobian's row lengths, which is what they could reach."""
    q, exact = exact_values(arm, group, function)
    found = under.outputs_of(compiled(arm, function), under.ARMS[arm], q)
    for array, error in zip(found, under.errors_against(found, exact), strict=True):
        scale = np.abs(array).max(axis=1, keepdims=True)
        if function.startswith(("minors", "manipulability", "null_vector")):
            rows = [under.row_lengths(under.ARMS[arm].description, group, row) for row in q]
            scale = np.array(rows).prod(axis=1, keepdims=True)
        assert np.all(error <= 1e-15 * scale)


@every_function
def test_float_against_double(arm, group, function):
    q = under.random_q(under.ARMS[arm], 200, 2).astype(np.float32)
    evaluator = compiled(arm, function)
    found = under.outputs_of(evaluator, under.ARMS[arm], q)
    inputs = under.shaped(evaluator.inputs, under.given(evaluator.inputs, under.ARMS[arm], q))
    exact = evaluator(*(array.astype(float) for array in inputs))
    exact = exact if isinstance(exact, tuple) else (exact,)
    bounds = under.bounds_for(arm, group, function, q)
    for array, double, bound in zip(found, exact, bounds, strict=True):
        assert array.dtype == np.float32
        with np.errstate(over="ignore", invalid="ignore"):
            difference = np.abs(array - double.reshape(array.shape))
        assert np.all((difference <= bound) | np.isinf(bound))


@every_function
def test_c_against_numpy(arm, group, function):
    q = under.random_q(under.ARMS[arm], 200, 3)
    found = under.outputs_of(compiled(arm, function), under.ARMS[arm], q)
    module = under.numpy_evaluators(under.ARMS[arm].description.model.name, group)[function]
    assert not module.compiled
    # NumPy's own sine and cosine, vectorised, promise 4 units in the last place.
    mine = under.bounds_for(arm, group, function, q)
    theirs = under.bounds_for(arm, group, function, q, sine_ulps=4.0)
    for a, b, ours, other in zip(found, under.outputs_of(module, under.ARMS[arm], q), mine, theirs, strict=True):
        assert a.shape == b.shape
        assert np.all(np.abs(a - b) <= ours + other)


SIZES = (0, 1, 2, 7, 8, 9, 63, 64, 65, 200)


@every_function
def test_place_in_a_batch(arm, group, function):
    """A configuration's result depends neither on its place in a batch nor on the others there.

    Tiles give the same bits everywhere, and so do single configurations, which run through code of their own: there
    the compiler may fuse other products and sums, so that the two agree to rounding.
    """
    evaluator, mine = compiled(arm, function), under.ARMS[arm]
    for real in (np.float64, np.float32):
        q = under.random_q(mine, 64, 4).astype(real)
        whole = under.outputs_of(evaluator, mine, q)
        alone = [under.outputs_of(evaluator, mine, q[k : k + 1]) for k in range(64)]
        single = [np.concatenate([one[place] for one in alone]) for place in range(len(whole))]
        for tiled, lone, bound in zip(whole, single, under.bounds_for(arm, group, function, q), strict=True):
            assert np.all(np.abs(tiled.astype(float) - lone) <= 2 * bound)
        for size in SIZES:
            index = np.arange(size)[::-1] % 64
            for part, tiled, lone in zip(under.outputs_of(evaluator, mine, q[index]), whole, single, strict=True):
                assert part.shape == (size, tiled.shape[1]) and part.dtype == real
                assert np.all(np.all(part == tiled[index], axis=1) | np.all(part == lone[index], axis=1))


@every_function
def test_nan_touches_its_own_configuration_only(arm, group, function):
    evaluator, mine = compiled(arm, function), under.ARMS[arm]
    q = under.random_q(mine, 70, 5)
    clean = under.outputs_of(evaluator, mine, q)
    q[[3, 40, 69], 0], q[[5, 41], -1] = np.nan, np.inf
    touched = np.isin(np.arange(70), [3, 5, 40, 41, 69])
    for dirty, good in zip(under.outputs_of(evaluator, mine, q), clean, strict=True):
        assert np.array_equal(dirty[~touched], good[~touched])


ANOTHER_ISA = """
import sys
import numpy as np
import chainrule as cr
from chainrule.compile import instruction_set
arm = cr.Arm.from_dh([("R", 0.3, 0.1, 0.2, 0.4), ("R", -1.2, 0.5, 0.1, 0.0), ("P", 0.9, 0.2, 0.1, 0.0)], name="isa")
q = np.load(sys.argv[1])
names = ("H", "gradient")
out = dict(zip(names, (arm.manipulability(q, task="position"), arm.manipulability_gradient(q, task="position"))))
out |= {"minors": arm.minors(q, task="position")}
np.savez(sys.argv[2], isa=instruction_set(), **out)
"""


def test_instruction_sets_agree(tmp_path, common_cache):
    """A process restricted to a lesser instruction set: the same results to a few units in the last place."""
    np.save(tmp_path / "q.npy", np.random.default_rng(6).uniform(-3, 3, (100, 3)))
    found = {}
    for isa in ("plain", "avx2", "avx512"):
        target = tmp_path / f"{isa}.npz"
        subprocess.run(
            [sys.executable, "-c", ANOTHER_ISA, str(tmp_path / "q.npy"), str(target)],
            check=True,
            env=os.environ | {"CHAINRULE_ISA": isa},
        )
        found[isa] = dict(np.load(target))
    assert str(found["plain"].pop("isa")) == "plain"
    for isa in ("avx2", "avx512"):
        assert str(found[isa].pop("isa")) in ("plain", "avx2", isa)
        for name, expected in found["plain"].items():
            assert np.abs(found[isa][name] - expected).max() <= 4e-15 * np.abs(expected).max()


def test_unknown_instruction_set_is_refused(monkeypatch):
    compiling.instruction_set.cache_clear()
    monkeypatch.setenv("CHAINRULE_ISA", "mmx")
    with pytest.raises(cr.GenerationError, match="plain, avx2 or avx512 is accepted") as caught:
        compiling.instruction_set()
    under.one_line(caught.value)
    compiling.instruction_set.cache_clear()


# ---- at and near singular configurations -----------------------------------------------------------------------

#: Configurations where H is exactly zero, also in doubles: every product that should vanish has a factor that is 0.
SINGULAR = [
    ("planar_3r", "position", [0.7, 0.0, 0.0]),
    ("planar_3r(0, 0, 0)", "position", [0.3, -1.2, 2.0]),
    ("planar_3r(0, 0, 0)", "pose", [0.3, -1.2, 2.0]),
    ("orthogonal_3r(1, 2, 0, 1)", "position", [0.3, -1.2, 2.0]),
    ("panda", "pose", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9]),
    ("iiwa14", "pose", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9]),
    ("iiwa14", "position", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9]),
    ("puma560", "pose", [0.4, 0.3, 0.8, 0.2, 0.0, 0.9]),
    ("ur5e", "pose", [0.4, 0.3, 0.8, 0.2, 0.0, 0.9]),
]


@pytest.mark.parametrize("real", [np.float64, np.float32])
@pytest.mark.parametrize(("arm", "task", "q"), SINGULAR)
def test_exactly_singular(arm, task, q, real):
    """H is 0, every gradient is zero, nothing is nan or infinite, and nobody is warned: in tiles and alone."""
    mine = under.ARMS[arm]
    assert under.manipulability(mine.description, task, q, 80) < 1e-30
    for count in (1, 70):
        batch = np.tile(np.array(q, real), (count, 1))
        batch[1::2] += real(0.1)  # regular neighbours in the same tile
        rows = slice(None, None, 2)
        assert np.all(mine.manipulability(batch, task=task)[rows] == 0)
        for criterion in ("H", "1/H", "H^(-1/2)"):
            gradient = mine.manipulability_gradient(batch, task=task, criterion=criterion)
            assert np.all(np.isfinite(gradient))
            assert np.all(gradient[rows] == 0)
        for function in (mine.null_projector, mine.null_vector, mine.minors):
            try:
                assert np.all(np.isfinite(function(batch, task=task)))
            except cr.InputError as error:  # square Jacobians have no null space
                assert "null" in under.one_line(error) or "joint" in under.one_line(error)


NEAR = [
    ("planar_3r", "position", [0.7, 0.0, 0.0]),
    ("panda", "pose", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9]),
    ("iiwa14", "pose", [0.4, 0.3, 0.0, 0.0, 0.2, 0.0, 0.9]),
    ("puma560", "pose", [0.4, 0.3, 0.8, 0.2, 0.0, 0.9]),
    ("ur5e", "pose", [0.4, 0.3, 0.0, 0.2, 0.7, 0.9]),
    ("sanchez_8r", "pose", [0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2]),
    ("orthogonal_3r(1, 2, 1.5, 1)", "position", [0.1, 0.4, float(np.arccos(-2 / 1.5 + 0.6))]),
]


@pytest.mark.parametrize("distance", [1e-3, 1e-6, 1e-9, 1e-12, 0.0])
@pytest.mark.parametrize(("arm", "task", "q"), NEAR)
def test_near_a_singularity(arm, task, q, distance):
    """H keeps an error of 1e-15 of what the rows could reach however small it gets, and its gradient one to match."""
    mine = under.ARMS[arm]
    direction = np.array([0.0, 1.0, -0.7, 0.6, 0.9, -0.8, 0.3, 0.5])[: mine.n]
    q = np.array(q) + distance * direction
    exact = under.gradients(mine.description, task, q)
    found = [entry[None] for entry in mine.evaluator(f"manipulability_gradient_{task}")(*under.arguments(mine, q))]
    found = [entry.reshape(1, -1) for entry in found]
    bounds = under.bounds_for(arm, task, f"manipulability_gradient_{task}", q[None])
    errors = under.errors_against(found, [exact])
    assert errors[0][0, 0] <= 1e-15 * np.prod(under.row_lengths(mine.description, task, q))
    for array, error, bound in zip(found, errors, bounds, strict=True):
        assert np.all(np.isfinite(array))
        assert np.all(error <= bound)


# ---- long chains: the orthogonal factorisation -----------------------------------------------------------------


@cache
def long_chain(n):
    """A chain of n joints, every fourth prismatic, as the two evaluators of its manipulability, in NumPy code."""
    rng = np.random.default_rng(n)
    rows = [
        ("P" if k % 4 == 3 else "R", rng.choice([-np.pi / 2, np.pi / 2, 0.3]), *rng.uniform(-0.3, 0.3, 2), 0.2)
        for k in range(n)
    ]
    arm = cr.Arm.from_dh(rows, name=f"chain{n}")
    return arm, under.emitted(arm, "pose")


def condition(description, q):
    """The largest over the smallest singular value of the pose Jacobian."""
    values = np.linalg.svd(
        np.array(under.task_jacobian(description, "pose", list(q)).tolist(), float), compute_uv=False
    )
    return values[0] / values[-1]


@pytest.mark.parametrize("n", [10, 12, 24, 60])
def test_long_chain(n):
    """H from pivots within a few units in the last place; the gradient as far as the condition of J lets it."""
    arm, code = long_chain(n)
    q = under.random_q(arm, 2 if n <= 12 else 1, n)
    for row in q:
        exact = under.manipulability(arm.description, "pose", row)
        assert abs(float(code["manipulability_pose"](row) / exact - 1)) < 1e-14
        steps = range(n) if n <= 12 else range(0, n, 7)
        h, *gradients = code["manipulability_gradient_pose"](row)
        truths = under.gradients(arm.description, "pose", row, only=steps)
        assert abs(float(h / exact - 1)) < 1e-14
        for gradient, truth in zip(gradients, truths[1:], strict=True):
            difference = [abs(float(gradient[i] - truth[i])) for i in steps]
            assert max(difference) < 1e-15 * n * condition(arm.description, row) * np.abs(gradient).max()


def test_long_chain_singular():
    """All axes parallel: no rotation about x or y can be reached. H and its gradients are zero, without nan."""
    arm = cr.Arm.from_dh([("R", 0.0, 0.3, 0.1, 0.0)] * 12, name="parallel12")
    code = under.emitted(arm, "pose")
    for q in (np.zeros(12), under.random_q(arm, 1, 1)[0]):
        for entry in code["manipulability_gradient_pose"](q):
            assert np.all(entry == 0)
        assert code["manipulability_pose"](q) == 0
        assert np.all(np.isfinite(code["null_projector_pose"](q)))


def test_long_chain_compiled():
    """A chain that needs the factorisation, end to end: derived, compiled, and right."""
    arm = cr.Arm.from_dh([("R", (-1) ** k * np.pi / 2, 0.1, 0.2, 0.0) for k in range(10)], name="snake10")
    q = under.random_q(arm, 70, 7)
    found = arm.manipulability(q, task="pose")
    assert arm.evaluator("manipulability_pose").compiled
    for k in (0, 63, 69):
        assert abs(float(found[k] / under.manipulability(arm.description, "pose", q[k]) - 1)) < 1e-14
    with pytest.raises(cr.InputError, match="too many minors"):
        arm.minors(q, task="pose")
