"""Parts of a kernel that are passed over where they do not matter: found, ordered, and compiled to the same results."""

from __future__ import annotations

import ctypes
import subprocess

import numpy as np
import pytest

from chainrule.derive import emit, skipping
from chainrule.derive.catalogue import Function
from chainrule.derive.lower import lower
from chainrule.derive.program import Output, Program, Steps, Where, variables


def iterated(steps, start, times):
    """A long polynomial of a value: ``times`` steps of x (1 - x) + start / 8."""
    x = start
    for _ in range(times):
        x = steps.let("x", x * (1 - x) + start / 8)
    return x


def kernel(make, count=3):
    """A kernel of one input ``a`` and one output ``found``."""
    steps, given = Steps(), variables("a", count)
    entries = tuple(make(steps, *given.symbols))
    output = Output("found", (len(entries),), entries)
    return lower(Function("f", Program("f", "a test", (given,), tuple(steps.steps), (output,))))


def guarded(steps, a, b, c):
    """Much of a where b is not 0, and as much always."""
    return [Where(b, iterated(steps, a, 200)) + c, iterated(steps, c, 300)]


def test_a_part_is_what_nothing_else_needs():
    found = kernel(guarded)
    (part,) = skipping.parts(found)
    assert found.values[part.condition].op == "input"
    assert [found.values[index].op for index in part.results] == ["where"]
    assert len(part.values) > 500
    for index, value in enumerate(found.values):
        if index in part.values - set(part.results):
            continue
        arguments = {a for a in value.args if isinstance(a, int)} if value.op != "input" else set()
        if index not in part.values:
            assert not arguments & (part.values - set(part.results))


def test_every_value_is_there_once_and_after_what_it_needs():
    found = kernel(guarded)
    blocks = skipping.blocks(found)
    order = [index for block in blocks for index in block.indices]
    assert sorted(order) == list(range(len(found.values)))
    assert sum(block.part is not None for block in blocks) == 1
    assert blocks[-1].part is None
    place = {index: k for k, index in enumerate(order)}
    for index, value in enumerate(found.values):
        if value.op != "input":
            assert all(place[a] < place[index] for a in value.args if isinstance(a, int))


def test_short_kernels_and_small_parts_are_left_as_they_are():
    """One loop is quicker than a test and a cut; and without a part the order stays."""
    short = kernel(lambda steps, a, b, c: [Where(b, iterated(steps, a, 200)) + c])
    assert short.operations < skipping.LONG
    small = kernel(lambda steps, a, b, c: [Where(b, iterated(steps, a, 20)) + c, iterated(steps, c, 400)])
    assert small.operations > skipping.LONG
    for found in (short, small):
        assert skipping.parts(found) == []
        (block,) = skipping.blocks(found)
        assert block.indices == tuple(range(len(found.values)))


def test_what_others_need_is_not_passed_over():
    """The same polynomial is an output, too."""

    def shared(steps, a, b, c):
        x = iterated(steps, a, 300)
        return [Where(b, x) + c, x]

    assert skipping.parts(kernel(shared)) == []


def test_a_part_that_needs_what_follows_from_it_is_none():
    """where(b, y2) with y2 made of what where(b, y1) led to elsewhere cannot be in one piece with y1."""

    def tangled(steps, a, b, c):
        first = steps.let("first", Where(b, iterated(steps, a, 200)))
        between = steps.let("between", first + c)
        return [steps.let("second", Where(b, iterated(steps, between, 200))), between]

    found = kernel(tangled)
    assert len(skipping.parts(found)) == 1
    (block,) = skipping.blocks(found)
    assert block.part is None
    assert sorted(block.indices) == list(range(len(found.values)))


def test_parts_do_not_overlap():
    """A part within a part belongs to the larger one."""

    def nested(steps, a, b, c):
        inner = steps.let("inner", Where(c, iterated(steps, a, 100)))
        return [Where(b, iterated(steps, inner, 200)) + c, iterated(steps, c, 300)]

    found = skipping.parts(kernel(nested))
    assert len(found) == 1
    assert len(found[0].values) > 800


def steps_in_python(a, b, c):
    """What :func:`guarded` says, in NumPy."""

    def long(start, times):
        x = start
        for _ in range(times):
            x = x * (1 - x) + start / 8
        return x

    with np.errstate(all="ignore"):
        return np.stack([np.where(b != 0, long(a, 200), 0.0) + c, long(c, 300)], axis=-1)


@pytest.fixture(scope="module")
def compiled(tmp_path_factory, c_compiler):
    """The C function for batches, compiled."""
    folder = tmp_path_factory.mktemp("skipping")
    files = {**emit.shared_headers(), **emit.unit("tried", "t", "a test", [kernel(guarded)], "0" * 64, shared="")}
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")
    assert "chainrule_any" in files["tried.inc"]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-fPIC", "-shared", "-ffp-contract=off"]
    subprocess.run([*c_compiler, *flags, "tried.c", "-o", "tried.so", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "tried.so")).t_f_batch


def batch(function, a):
    """Rows of ``a`` through the C function."""
    a, found = np.ascontiguousarray(a), np.full((len(a), 2), np.nan)
    pointers = (ctypes.c_void_p * 2)(a.ctypes.data, found.ctypes.data)
    strides = (ctypes.c_ssize_t * 4)(24, 16, 8, 8)
    function(ctypes.c_ssize_t(len(a)), pointers, strides)
    return found


@pytest.mark.parametrize("condition", ["never", "always", "seldom", "nan"])
@pytest.mark.parametrize("count", [1, 5, 64, 200])
def test_compiled(compiled, condition, count):
    """Whole tiles without the part, with it, and mixed; nan is not 0."""
    a = np.random.default_rng(count).uniform(0.0, 0.9, (count, 3))
    a[:, 1] = {"never": 0.0, "always": 1e-300, "seldom": np.arange(count) % 70 == 3, "nan": np.nan}[condition]
    np.testing.assert_array_equal(batch(compiled, a), steps_in_python(*a.T))


def test_what_is_passed_over_leaves_no_trace(compiled):
    """Infinite where it would not matter; a tile where it does is followed by one where it does not."""
    a = np.full((300, 3), 0.3)
    a[:, 1] = np.arange(300) < 64
    a[64:, 0] = np.inf
    found = batch(compiled, a)
    np.testing.assert_array_equal(found, steps_in_python(*a.T))
    assert np.all(np.isfinite(found[64:]))
