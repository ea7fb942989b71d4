"""Where our time goes: the same kernel compiled without its memory traffic, and without its sines and cosines.

The generated file is compiled as it is, with the same flags, behind macros that take parts of it away. Parts are
differences of timings, so they add up to the whole; on a processor that overlaps them they are not exact.
"""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from benchmarks.cases import MEMORY, Array, Case
from benchmarks.measure import in_turn
from chainrule import compile as compiling
from chainrule.derive.manifest import Places

#: The shared headers come first; their guards keep the kernel's own include lines from undoing the macros.
WRAPPER = """
#include "chainrule_batch.h"
#include "chainrule_sincos.h"
#ifdef WITHOUT_MEMORY
/* Gather a batch's first tile only, so that the terms see ordinary numbers; scatter nothing, but keep the results. */
int breakdown_fresh;
#define chainrule_gather(tile, ...) \\
    do { if (breakdown_fresh) { chainrule_gather(tile, __VA_ARGS__); breakdown_fresh = 0; } \\
         __asm__ volatile("" : : "r"(tile) : "memory"); } while (0)
#define chainrule_scatter(tile, ...) __asm__ volatile("" : : "r"(tile) : "memory")
#endif
#ifdef WITHOUT_SINES
static inline void breakdown_copy(const real *restrict x, real *restrict s, real *restrict c, int count)
{
    for (int i = 0; i < count; ++i) {
        s[i] = x[i];
        c[i] = x[i] + CR_C(1.0);
    }
}
#define chainrule_sincos breakdown_copy
#endif
"""

VARIANTS = {"whole": (), "no memory": ("-DWITHOUT_MEMORY",), "terms": ("-DWITHOUT_MEMORY", "-DWITHOUT_SINES")}

Kernel = Callable[..., object]


@dataclass(frozen=True)
class Breakdown:
    """Nanoseconds for one configuration, in a large batch.

    Attributes:
        whole: everything.
        memory: rows into the tile and out of it, caches and main memory.
        sines: sines and cosines.
        terms: the rest of the arithmetic.
        cached: the whole again, for a batch that stays in the second-level cache.
        fill: writing the same number of bytes and nothing else, as NumPy's fill does.
        outputs: bytes written for one configuration.
        spread: half of what lies between the quartiles of the whole, over its median.
    """

    whole: float
    memory: float
    sines: float
    terms: float
    cached: float
    fill: float
    outputs: int
    spread: float


def breakdown(case: Case, q: Array, rounds: int, least_ns: float) -> Breakdown:
    """Time the variants of the case's kernel in turn."""
    kernels = _kernels(case)
    evaluator = case.arm.evaluator(case.function)
    inputs = (q, case.arm.parameters)[: len(evaluator.inputs)]
    outputs = MEMORY.rows(len(q), [shape for _, shape in evaluator.outputs])
    few = min(len(q), 1000)
    tasks: dict[str, tuple[Callable[[], object], int]] = {
        name: (_call(kernel, len(q), inputs, outputs), len(q)) for name, kernel in kernels.items()
    }
    tasks["cached"] = (_call(kernels["whole"], few, inputs, outputs), few)

    def fill() -> None:
        for value in outputs:
            value.fill(1.0)

    tasks["fill"] = (fill, len(q))
    found = in_turn(tasks, rounds, least_ns)
    whole, compute, terms = (found[name].median for name in VARIANTS)
    return Breakdown(
        whole,
        whole - compute,
        compute - terms,
        terms,
        found["cached"].median,
        found["fill"].median,
        sum(value[0].nbytes for value in outputs),
        found["whole"].spread,
    )


def _call(kernel: Kernel, count: int, inputs: tuple[Array, ...], outputs: tuple[Array, ...]) -> Callable[[], object]:
    """One batch: addresses and byte strides as the gufunc gives them; constants (a family's parameters) do not step."""
    arrays = (*inputs, *outputs)
    steps = [0 if array.ndim == 1 and k < len(inputs) else array.strides[0] for k, array in enumerate(arrays)]
    for k, array in enumerate(arrays):
        steps += array.strides if array.ndim == 1 and k < len(inputs) else array.strides[1:]
    addresses = (ctypes.c_void_p * len(arrays))(*(array.ctypes.data for array in arrays))
    strides = (ctypes.c_ssize_t * len(steps))(*steps)
    return lambda: kernel(count, addresses, strides)


def _kernels(case: Case) -> dict[str, Kernel]:
    command = compiling.compiler()
    if command is None:
        raise RuntimeError("the breakdown needs a C compiler")
    with tempfile.TemporaryDirectory(prefix="benchmark-", ignore_cleanup_errors=True) as folder:
        return {
            name: _variant(case, command, Path(folder) / name.replace(" ", "_"), defines)
            for name, defines in VARIANTS.items()
        }


def _variant(case: Case, command: list[str], stem: Path, defines: tuple[str, ...]) -> Kernel:
    """The case's kernel with parts taken away, compiled as the package compiles it."""
    model, generated = case.arm.description.model.name, Places.here().generated
    source, library = stem.with_suffix(".c"), stem.with_suffix(".so")
    source.write_text(f'{WRAPPER}#include "{generated / model / f"{model}_{case.group}.c"}"\n', "utf-8")
    flags = [
        *compiling._flags()["common"],
        *compiling._flags()["installed"],
        *compiling._flags()[compiling.instruction_set()],
    ]
    subprocess.run(
        [
            *command,
            "-std=c99",
            *flags,
            *defines,
            f"-I{generated}",
            "-fPIC",
            "-shared",
            str(source),
            "-o",
            str(library),
            "-lm",
        ],
        check=True,
    )
    loaded = ctypes.CDLL(str(library))
    kernel = getattr(loaded, f"{model}_{case.function}_batch")
    kernel.argtypes, kernel.restype = [ctypes.c_ssize_t, ctypes.c_void_p, ctypes.c_void_p], None
    return _fresh(kernel, loaded) if "-DWITHOUT_MEMORY" in defines else kernel


def _fresh(kernel: Kernel, library: ctypes.CDLL) -> Kernel:
    flag = ctypes.c_int.in_dll(library, "breakdown_fresh")

    def call(*arguments: object) -> object:
        flag.value = 1
        return kernel(*arguments)

    return call
