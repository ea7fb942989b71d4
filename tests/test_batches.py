"""How configurations reach a kernel's tile and leave it: any strides, any number, nothing beyond the ends."""

from __future__ import annotations

import ctypes
import subprocess

import numpy as np
import pytest
import sympy as sp

from chainrule.derive import emit
from chainrule.derive.catalogue import Function
from chainrule.derive.lower import lower
from chainrule.derive.program import Input, Output, Program

SHAPES = [(), (1,), (3,), (4,), (5,), (7,), (3, 3), (4, 4), (2, 6)]
COUNTS = [0, 1, 3, 7, 8, 9, 12, 15, 63, 64, 65, 75, 200]


def name_of(shape):
    return "copy_" + "x".join(map(str, shape)) if shape else "copy_one"


def copying(shape):
    """A function whose result is its input."""
    size = int(np.prod(shape, dtype=int))
    symbols = tuple(sp.Symbol(f"a{k}", real=True) for k in range(size))
    given, copied = Input("a", shape, symbols), Output("b", shape, symbols)
    return lower(Function(name_of(shape), Program(name_of(shape), "a copy", (given,), (), (copied,))))


@pytest.fixture(scope="module", params=["quads", "one by one", "float"])
def library(request, tmp_path_factory, c_compiler):
    """The functions compiled, and their type."""
    folder = tmp_path_factory.mktemp("batches")
    kernels = [copying(shape) for shape in SHAPES]
    for name, text in {
        **emit.shared_headers(),
        **emit.unit("copies", "t", "copies", kernels, "0" * 64, shared=""),
    }.items():
        (folder / name).write_text(text, "utf-8")
    more = {"quads": [], "one by one": ["-DCR_HAS_QUADS=0"], "float": ["-DCHAINRULE_FLOAT"]}[request.param]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-fPIC", "-shared", *more]
    subprocess.run([*c_compiler, *flags, "copies.c", "-o", "copies.so", "-lm"], cwd=folder, check=True)
    single = request.param == "float"
    return ctypes.CDLL(str(folder / "copies.so")), "f" if single else "", np.float32 if single else np.float64


def run(library, a, b, shape):
    """``b`` from ``a`` by the C function, with the strides that they have."""
    loaded, suffix, _ = library
    function = loaded[f"t_{name_of(shape)}_batch{suffix}"]
    strides = [a.strides[0], b.strides[0], *a.strides[1:], *b.strides[1:]]
    steps = (ctypes.c_ssize_t * len(strides))(*strides)
    function(ctypes.c_ssize_t(len(a)), (ctypes.c_void_p * 2)(a.ctypes.data, b.ctypes.data), steps)


@pytest.mark.parametrize("shape", SHAPES, ids=name_of)
@pytest.mark.parametrize("count", COUNTS)
def test_rows_in_and_out(library, shape, count):
    """Side by side, spread out, columns first, backwards: the same numbers, and those beside them untouched."""
    real = library[2]
    a = np.random.default_rng(count).normal(size=(count, *shape)).astype(real)
    wide = np.full((count + 2, *(2 * extent + 1 for extent in shape), 2), np.nan, real)
    inner = (slice(1, count + 1), *(slice(1, 2 * extent + 1, 2) for extent in shape), 0)
    spread = wide.copy()
    spread[inner] = a
    fortran = np.asfortranarray(a) if a.size else a
    for given in (a, spread[inner], fortran, np.ascontiguousarray(a[::-1])[::-1]):
        dense = np.full((count + 2, *shape), np.nan, real)
        run(library, given, dense[1:-1], shape)
        np.testing.assert_array_equal(dense[1:-1], a)
        assert np.isnan(dense[[0, -1]]).all()
        found = wide.copy()
        run(library, given, found[inner], shape)
        np.testing.assert_array_equal(found[inner], a)
        found[inner] = np.nan
        assert np.isnan(found).all()


@pytest.mark.parametrize("shape", SHAPES, ids=name_of)
def test_one_row_for_all(library, shape):
    """An input of stride 0."""
    real = library[2]
    a = np.random.default_rng(0).normal(size=shape).astype(real)
    found = np.full((75, *shape), np.nan, real)
    run(library, np.broadcast_to(a, (75, *shape)), found, shape)
    np.testing.assert_array_equal(found, np.broadcast_to(a, (75, *shape)))


@pytest.mark.parametrize("shape", [(), (7,), (4, 4)], ids=name_of)
def test_past_the_caches(library, shape):
    """So many results that they are written past the caches, from an odd address."""
    real = library[2]
    size = max(1, int(np.prod(shape)))
    count = (32 << 20) // (size * np.dtype(real).itemsize) + 37
    a = np.arange(count * size, dtype=real).reshape(count, *shape)
    room = np.full(count * size + 3, -1.0, real)
    found = room[1 : 1 + count * size].reshape(a.shape)
    run(library, a, found, shape)
    assert np.array_equal(found, a)
    assert (room[[0, -2, -1]] == -1.0).all()
