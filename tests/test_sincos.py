"""The vectorised sine and cosine: constants against exact arithmetic, compiled code against mpmath at 40 digits."""

from __future__ import annotations

import ctypes
import os
import platform
import random
import subprocess
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import jinja2
import mpmath
import numpy as np
import pytest

import chainrule.templates
from chainrule.derive import sincos

PRECISIONS: tuple[sincos.Precision, ...] = ("float64", "float32")
TYPES: dict[str, Any] = {"float64": np.float64, "float32": np.float32}
POLYNOMIAL_ULPS = 0.85  # the largest error of the polynomial path, see chainrule_sincos.h
LIBRARY_ULPS = 1.0  # asked of the C library where it takes over

CC = os.environ.get("CC", "cc")
X86 = platform.machine() in ("x86_64", "AMD64")
CPU = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""

# name: flags. "undetected": the compiler fuses although the header believes that there is no FMA.
FLAGS: dict[str, tuple[str, ...]] = {
    "plain": ("-O3",),
    "plain O0": ("-O0",),
    "plain O2 contracted": ("-O2", "-ffp-contract=fast"),
}
if X86 and " avx2" in CPU and " fma" in CPU:
    FLAGS["avx2"] = ("-O3", "-mavx2", "-mfma", "-ffp-contract=off")
    FLAGS["avx2 contracted"] = ("-O3", "-mavx2", "-mfma", "-ffp-contract=fast")
    FLAGS["undetected contracted"] = (
        *("-O3", "-mavx2", "-mfma", "-ffp-contract=fast"),
        *("-U__FMA__", "-U__FP_FAST_FMA", "-U__FP_FAST_FMAF"),
    )
if X86 and " avx512f" in CPU:
    FLAGS["avx512"] = ("-O3", "-mavx512f", "-mfma", "-mprefer-vector-width=512")
PARTS = [(precision, name) for precision in PRECISIONS for name in FLAGS]

# Arithmetic with excess precision, where the compiler offers it.
_PROBE = [CC, "-mfpmath=387", "-x", "c", "-c", "-o", os.devnull, "-"]
X87 = X86 and subprocess.run(_PROBE, input=b"float f(float x) { return x + 1; }", capture_output=True).returncode == 0

SOURCE = """
#include "chainrule_sincos.h"
void tile(const real *x, real *sine, real *cosine, int count);
void single(const real *x, real *sine, real *cosine, int count);
int polynomial(void);
void tile(const real *x, real *sine, real *cosine, int count) { chainrule_sincos(x, sine, cosine, count); }
void single(const real *x, real *sine, real *cosine, int count)
{
    for (int i = 0; i < count; i++) chainrule_sincos1(x[i], &sine[i], &cosine[i]);
}
int polynomial(void) { return !CR_SINCOS_LIBRARY; }
"""


def render(folder: Path) -> None:
    templates = Path(next(iter(chainrule.templates.__path__)))
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    text = environment.get_template("sincos.h.j2").render(sincos=sincos.context())
    (folder / "chainrule_sincos.h").write_text(text)
    (folder / "chainrule_real.h").write_text(environment.get_template("real.h.j2").render())
    (folder / "sincos.c").write_text(SOURCE)


def compile_library(folder: Path, flags: tuple[str, ...], precision: str) -> ctypes.CDLL:
    warnings = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", "-Wsign-conversion")
    real = ("-DCHAINRULE_FLOAT",) if precision == "float32" else ()
    # In two steps: linked with -ffast-math, a library switches the whole process to flushing subnormal numbers to zero.
    for command in (
        [CC, *warnings, *flags, *real, "-fPIC", "-c", "sincos.c", "-o", "sincos.o"],
        [CC, "-shared", "sincos.o", "-o", "sincos.so", "-lm"],
    ):
        subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "sincos.so"))


# Angles with the largest errors in a search of millions (double) and of all of them (float), tail included or left out.
HARD = {
    "float64": (
        *("-0x1.9ec45642eef3p-1", "-0x1.94d0d5c75cff8p-1", "-0x1.c38edabbd394p+2"),
        *("0x1.1f200a2786063p+18", "0x1.517bb65ea65eap+20", "0x1.62f2fbefaddfap+20", "0x1.f35e6f01004f8p+1"),
    ),
    "float32": (
        *("0x1.2e3ca6p+1", "0x1.534432p+4", "0x1.f2a41ap+1", "0x1.2ec144p+1"),
        *("0x1.6c6002p+4", "0x1.93b6fep-1", "0x1.f63214p+1", "0x1.bdd0eap+5"),
    ),
}

Evaluate = Callable[[Any], tuple[Any, Any]]


def caller(library: ctypes.CDLL, name: str, precision: str) -> Evaluate:
    """Call ``tile`` or ``single`` of a library on an array."""

    def evaluate(x: Any) -> tuple[Any, Any]:
        x = np.ascontiguousarray(x, dtype=TYPES[precision])
        sine, cosine = np.empty_like(x), np.empty_like(x)
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (x, sine, cosine)]
        getattr(library, name)(*pointers, ctypes.c_int(x.size))
        return sine, cosine

    return evaluate


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, str], ctypes.CDLL]:
    @cache
    def compiled(precision: str, name: str) -> ctypes.CDLL:
        folder = tmp_path_factory.mktemp("sincos")
        render(folder)
        return compile_library(folder, FLAGS[name], precision)

    return compiled


def neighbours(x: Any) -> list[Any]:
    """The number and the two beside it, in its own format."""
    return [np.nextafter(x, -x.dtype.type(np.inf)), x, np.nextafter(x, x.dtype.type(np.inf))]


@cache
def angles(precision: str) -> Any:
    """Angles of the polynomial path: random, near the multiples of pi/4, tiny, and the bound."""
    real, limit = TYPES[precision], sincos.constants(precision).limit
    rng = np.random.default_rng(7)
    chosen: list[Any] = [
        rng.uniform(-np.pi, np.pi, 1500).astype(real),
        rng.uniform(-100, 100, 700).astype(real),
        rng.uniform(-limit, limit, 700).astype(real),
        rng.uniform(0.45, 0.8, 500).astype(real),
        np.array([float.fromhex(text) for text in HARD[precision]], dtype=real),
        (rng.uniform(-1, 1, 300) * 2.0 ** rng.integers(-120, 0, 300)).astype(real),
        np.array([np.finfo(real).tiny, np.finfo(real).smallest_subnormal, -np.finfo(real).tiny / 3], dtype=real),
    ]
    largest = int(limit / (np.pi / 4))
    with mpmath.workdps(60):
        for k in [*range(1, 60), *rng.integers(60, largest, 300).tolist(), largest - 1]:
            multiple = real(float(k * mpmath.pi / 4))
            chosen += [np.array(neighbours(multiple)), -np.array(neighbours(multiple))]
    bound = real(limit)
    chosen.append(np.array([bound, np.nextafter(bound, real(0)), -bound, -np.nextafter(bound, real(0))]))
    return np.concatenate(chosen)


@cache
def far_angles(precision: str) -> Any:
    """Angles that the C library serves, and some where it may be either."""
    real, limit = TYPES[precision], sincos.constants(precision).limit
    huge = [1e5, 1e9, 1e22, float(np.finfo(real).max), 1.5 * limit, 3.0 * limit]
    huge += [1e300, 2.0**1000] if precision == "float64" else [1e30]
    x = np.array(huge, dtype=real)
    just_above = np.array([np.nextafter(real(limit), real(np.inf)), real(limit + 0.4), real(limit + 1.7)])
    return np.concatenate([x, -x, just_above, -just_above])


def reference(x: Any) -> tuple[list[Any], list[Any]]:
    with mpmath.workdps(40):
        exact = [mpmath.mpf(float(v)) for v in x]
        return [mpmath.sin(v) for v in exact], [mpmath.cos(v) for v in exact]


@cache
def reference_near(precision: str) -> tuple[list[Any], list[Any]]:
    return reference(angles(precision))


@cache
def reference_far(precision: str) -> tuple[list[Any], list[Any]]:
    return reference(far_angles(precision))


def worst_ulps(got: Any, exact: list[Any]) -> float:
    """The largest error in units of the last place of the exact value (subnormals have the ulp of the smallest)."""
    info = np.finfo(got.dtype)
    errors = []
    for value, true in zip(got, exact, strict=True):
        assert np.isfinite(value)
        exponent = max(mpmath.frexp(true)[1], info.minexp + 1)
        with mpmath.workdps(60):
            errors.append(float(abs(mpmath.mpf(float(value)) - true) / mpmath.ldexp(1, exponent - info.nmant - 1)))
    return max(errors)


with mpmath.workdps(120):
    HALF_PI = int(mpmath.floor(mpmath.ldexp(mpmath.pi, 299)))  # pi/2 in units of 2**-300

# --- the constants -------------------------------------------------------------------------------------------------


def significant_bits(value: Fraction) -> int:
    """Bits from the first to the last one that is set, of a dyadic number."""
    numerator = abs(value.numerator)
    return numerator.bit_length() - ((numerator & -numerator).bit_length() - 1) if numerator else 0


@pytest.mark.parametrize("precision", PRECISIONS)
def test_constants_are_numbers_of_the_format(precision: sincos.Precision) -> None:
    c = sincos.constants(precision)
    for value in (c.two_over_pi, c.magic, c.limit, *c.half_pi, *c.sine, *c.cosine):
        assert float(TYPES[precision](value)) == value
    with mpmath.workdps(60):
        assert c.two_over_pi == float(TYPES[precision](float(2 / mpmath.pi)))


@pytest.mark.parametrize("precision", PRECISIONS)
def test_split_of_half_pi_is_exact(precision: sincos.Precision) -> None:
    c = sincos.constants(precision)
    bits = np.finfo(TYPES[precision]).nmant + 1
    parts = [Fraction(part) for part in c.half_pi]
    half_pi = Fraction(HALF_PI, 2**300)
    assert all(part > 0 for part in parts[:3])
    assert parts[0] + parts[1] == Fraction(int(half_pi * 2 ** (bits - 1)), 2 ** (bits - 1))  # pi/2 truncated
    assert abs(half_pi - sum(parts)) <= abs(parts[3]) / 2**bits
    largest = 2**c.quotient_bits
    ends = [*range(1, 65), *range(largest - 64, largest + 1)]
    for n in [*ends, *random.Random(3).sample(range(largest), 200)]:
        for part in parts[:3]:
            assert significant_bits(n * part) <= bits


@pytest.mark.parametrize("precision", PRECISIONS)
def test_polynomials_stay_within_their_stated_error(precision: sincos.Precision) -> None:
    c = sincos.constants(precision)
    worst_sine = worst_cosine = mpmath.mpf(0)
    with mpmath.workdps(50):
        width = mpmath.mpf(c.half_width)
        assert width >= mpmath.pi / 4
        for i in range(1, 3001):
            r = width * i / 3000
            z = r * r
            s = sum((mpmath.mpf(a) * z ** (k + 1) for k, a in enumerate(c.sine)), mpmath.mpf(1)) * r
            k = sum((mpmath.mpf(a) * z ** (k + 2) for k, a in enumerate(c.cosine)), 1 - z / 2)
            worst_sine = max(worst_sine, abs(s / mpmath.sin(r) - 1))
            worst_cosine = max(worst_cosine, abs(k / mpmath.cos(r) - 1))
    bits = np.finfo(TYPES[precision]).nmant + 1
    # Attained (so that the statement says something), never passed, and small beside half an ulp.
    assert 0.95 * c.sine_error < worst_sine <= c.sine_error < 0.1 * 2.0**-bits
    assert 0.95 * c.cosine_error < worst_cosine <= c.cosine_error < 0.1 * 2.0**-bits


@pytest.mark.parametrize("precision", PRECISIONS)
def test_no_number_is_nearer_to_a_multiple_than_stated(precision: sincos.Precision) -> None:
    c = sincos.constants(precision)
    bits = np.finfo(TYPES[precision]).nmant + 1
    largest = int(c.limit / (np.pi / 2))
    some = random.Random(5).sample(range(1, largest + 1), min(largest, 3000))
    nearest = None
    for n in [*range(1, min(largest, 3000)), *some]:
        target = n * HALF_PI
        unit = target.bit_length() - bits  # one ulp of the numbers around the multiple
        rest = target & ((1 << unit) - 1)
        distance = min(rest, (1 << unit) - rest)
        if nearest is None or distance < nearest:
            nearest = distance
    assert nearest is not None
    assert c.closest <= nearest / 2.0**300
    # Head and tail of r together are far better than the format needs, even there.
    assert c.reduction_error < 0.15 * 2.0**-bits


def test_unknown_precision_is_refused() -> None:
    with pytest.raises(ValueError, match=r"float16.*expected 'float64' or 'float32'"):
        sincos.constants("float16")


def test_derivation_is_repeatable_and_leaves_mpmath_alone() -> None:
    before = mpmath.mp.prec
    first = sincos.constants("float32")
    sincos.constants.cache_clear()
    with mpmath.workdps(5):
        assert sincos.constants("float32") == first
    assert mpmath.mp.prec == before


@pytest.mark.parametrize("precision", PRECISIONS)
def test_literals_read_back(precision: sincos.Precision) -> None:
    for value in (*sincos.constants(precision).sine, 1.0, -0.5, 2.0**-60, 6755399441055744.0):
        text = sincos.literal(value, precision)
        assert text.endswith("f") == (precision == "float32")
        assert float.fromhex(text.removesuffix("f") if precision == "float32" else text) == value


# --- the compiled header -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("precision", "name"), PARTS)
def test_polynomial_path_is_within_its_ulps(build: Any, precision: str, name: str) -> None:
    library = build(precision, name)
    assert library.polynomial()
    sine, cosine = caller(library, "tile", precision)(angles(precision))
    true_sine, true_cosine = reference_near(precision)
    assert worst_ulps(sine, true_sine) <= POLYNOMIAL_ULPS
    assert worst_ulps(cosine, true_cosine) <= POLYNOMIAL_ULPS


@pytest.mark.parametrize(("precision", "name"), PARTS)
def test_large_angles(build: Any, precision: str, name: str) -> None:
    """Far angles are right, and leave the others of their tile as they were."""
    evaluate = caller(build(precision, name), "tile", precision)
    far, near = far_angles(precision), angles(precision)[: far_angles(precision).size]
    alone = evaluate(near)
    mixed = np.stack([near, far], axis=1).ravel()
    for got, exact, undisturbed in zip(evaluate(mixed), reference_far(precision), alone, strict=True):
        assert worst_ulps(got[1::2], exact) <= LIBRARY_ULPS
        assert got[::2].tobytes() == undisturbed.tobytes()


@pytest.mark.parametrize(("precision", "name"), PARTS)
def test_special_values(build: Any, precision: str, name: str) -> None:
    for function in ("tile", "single"):
        evaluate = caller(build(precision, name), function, precision)
        sine, cosine = evaluate([0.0, -0.0, 1.0, np.nan, np.inf, -np.inf, -np.nan, 2.0])
        assert sine[:2].tolist() == [0.0, 0.0]
        assert np.signbit(sine[:2]).tolist() == [False, True]
        assert cosine[:2].tolist() == [1.0, 1.0]
        assert np.isnan(sine[3:7]).all()
        assert np.isnan(cosine[3:7]).all()
        assert np.isfinite(sine[[2, 7]]).all()
        assert np.isfinite(cosine[[2, 7]]).all()


@pytest.mark.parametrize(("precision", "name"), PARTS)
def test_symmetry_is_exact(build: Any, precision: str, name: str) -> None:
    evaluate = caller(build(precision, name), "tile", precision)
    x = angles(precision)
    (sine, cosine), (mirrored_sine, mirrored_cosine) = evaluate(x), evaluate(-x)
    assert (-sine).tobytes() == mirrored_sine.tobytes()
    assert cosine.tobytes() == mirrored_cosine.tobytes()


@pytest.mark.parametrize(("precision", "name"), PARTS)
def test_an_element_does_not_depend_on_its_place(build: Any, precision: str, name: str) -> None:
    """Every count from 0 on, vector body or remainder, and one at a time: the same bits; nothing written beyond."""
    library = build(precision, name)
    x = angles(precision)[:80]
    whole = caller(library, "tile", precision)(x)
    for got, expected in zip(caller(library, "single", precision)(x), whole, strict=True):
        assert got.tobytes() == expected.tobytes()
    for count in range(67):
        outputs = [np.full(80, 7, dtype=x.dtype) for _ in range(2)]
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (x, *outputs)]
        library.tile(*pointers, ctypes.c_int(count))
        for got, expected in zip(outputs, whole, strict=True):
            assert got[:count].tobytes() == expected[:count].tobytes()
            assert (got[count:] == 7).all()


@pytest.mark.parametrize("precision", PRECISIONS)
def test_contraction_does_not_change_a_bit(build: Any, precision: str) -> None:
    """Builds that know of the same FMA agree bit for bit, however they contract and however wide their vectors are."""
    fused = [name for name in FLAGS if name.startswith("avx")]
    for names in (["plain", "plain O0"], fused):
        results = [caller(build(precision, name), "tile", precision)(angles(precision)) for name in names]
        for sine, cosine in results:
            assert sine.tobytes() == results[0][0].tobytes()
            assert cosine.tobytes() == results[0][1].tobytes()


@pytest.mark.parametrize("precision", PRECISIONS)
@pytest.mark.parametrize("flag", ["-ffast-math", *(["-mfpmath=387"] if X87 else [])])
def test_arithmetic_that_breaks_the_method_takes_the_library(tmp_path: Path, flag: str, precision: str) -> None:
    """Reordered sums and excess precision defeat the rounding trick: no polynomial there, and still right.

    Vector functions that a fast-math compiler may choose are allowed four ulp.
    """
    render(tmp_path)
    library = compile_library(tmp_path, ("-O2", flag), precision)
    assert not library.polynomial()
    sine, cosine = caller(library, "tile", precision)(angles(precision))
    true_sine, true_cosine = reference_near(precision)
    regular = np.abs(angles(precision)) >= np.finfo(TYPES[precision]).tiny  # fast-math may flush the others to zero
    for got, exact in ((sine, true_sine), (cosine, true_cosine)):
        assert worst_ulps(got[regular], [v for v, keep in zip(exact, regular, strict=True) if keep]) <= 4


def test_no_library_of_these_tests_changes_the_processors_state() -> None:
    assert 2.0**-1022 / float("2") > 0.0
