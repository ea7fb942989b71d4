r"""Constants of the vectorised sine and cosine, derived here and rendered into ``chainrule_sincos.h``.

The method is the classical one (Cody and Waite, *Software Manual for the Elementary Functions*, 1980; Muller,
*Elementary Functions*, 3rd ed., chapters 3 and 11):

1. reduction: :math:`n = \mathrm{round}(2x/\pi)`, :math:`r = x - n\pi/2`, with :math:`\pi/2` as a sum of four numbers
   short enough for every product with ``n`` to be exact but the last. An exact product is the same number whether or
   not the compiler fuses it with the sum that follows, so contraction cannot change the reduction;
2. two minimax polynomials in :math:`z = r^2`:
   :math:`\sin r \approx r + r z\,S(z)` and :math:`\cos r \approx 1 - z/2 + z^2\,C(z)`;
3. the quadrant (``n`` modulo 4) swaps the two and sets their signs.

Nothing is pasted: the polynomials come from the Remez exchange algorithm at 80 digits, each coefficient rounded to the
format in turn and the rest fitted again. mpmath computes with integers, so every machine gets the same bits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Literal

from mpmath import MPContext

Precision = Literal["float64", "float32"]

_DIGITS = 80
_GRID = 200  # points of the exchange; the error between two of them differs by far less than the margin below
_CHECK_GRID = 1000
_MARGIN = 1.01


@dataclass(frozen=True)
class _Format:
    """A binary floating-point format and the effort that suits it."""

    bits: int  # of the significand, the hidden one included
    quotient_bits: int  # |n| <= 2**quotient_bits is reduced by the polynomial path
    terms: int  # coefficients of S and of C
    suffix: str  # of a C literal


_FORMATS: dict[Precision, _Format] = {
    "float64": _Format(bits=53, quotient_bits=20, terms=6, suffix=""),
    "float32": _Format(bits=24, quotient_bits=9, terms=3, suffix="f"),
}


@dataclass(frozen=True)
class SincosConstants:
    """Everything the sine and cosine of one floating-point type need, and the bounds that hold for them.

    Attributes:
        precision: ``"float64"`` or ``"float32"``.
        bits: bits of the significand.
        quotient_bits: the polynomial path is taken for ``-2**quotient_bits <= n < 2**quotient_bits``.
        two_over_pi: 2/pi, rounded to the format.
        magic: 1.5 * 2**(bits - 1); adding it rounds to an integer, whose lowest bits are those of the sum.
        half_pi: pi/2 as a sum of four numbers of the format, largest first. ``n * half_pi[i]`` is exact for the first
            three, and ``half_pi[0] + half_pi[1]`` is itself a number of the format (pi/2 truncated), used with FMA.
        limit: ``|x|`` (rad) up to which the polynomial path is taken; the C library serves what is a quadrant beyond.
        half_width: bound of ``|r|`` (rad), a little over pi/4 because 2x/pi is rounded before n is.
        sine: coefficients of S, lowest degree first.
        cosine: coefficients of C, lowest degree first.
        sine_error: bound of ``|r + r z S - sin r| / |sin r|`` for exact arithmetic, ``|r| <= half_width``.
        cosine_error: the same for the cosine.
        closest: lower bound of ``|x - n pi/2|`` (rad) over all numbers ``x`` of the format, pi/4 <= ``|x|`` <= limit.
        reduction_error: bound of the relative error of r, as head and tail together, for ``|x| <= limit``.
    """

    precision: Precision
    bits: int
    quotient_bits: int
    two_over_pi: float
    magic: float
    half_pi: tuple[float, float, float, float]
    limit: float
    half_width: float
    sine: tuple[float, ...]
    cosine: tuple[float, ...]
    sine_error: float
    cosine_error: float
    closest: float
    reduction_error: float


def _context() -> Any:
    """Return a private mpmath context, so that nobody's global precision matters or changes."""
    ctx = MPContext()
    ctx.dps = _DIGITS
    return ctx


def _rounded(ctx: Any, value: Any, bits: int) -> Any:
    """Round to the nearest number with ``bits`` significant bits, ties to even."""
    with ctx.workprec(bits):
        return +value


def _rounded_down(ctx: Any, value: Any, bits: int) -> Any:
    """Truncate a positive number to ``bits`` significant bits."""
    exponent = ctx.frexp(value)[1]
    scale = ctx.ldexp(1, bits - exponent)
    return ctx.floor(value * scale) / scale


def _rounded_up(ctx: Any, value: Any) -> float:
    """Return a double that is not below ``value`` (two bits of slack, for bounds only)."""
    return float(_rounded(ctx, value * (1 + ctx.ldexp(1, -50)), 53))


def _horner(coefficients: Sequence[Any], z: Any) -> Any:
    total = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * z + coefficient
    return total


def _minimax(ctx: Any, points: Sequence[Any], values: Sequence[Any], weights: Sequence[Any], terms: int) -> list[Any]:
    """Return the polynomial with ``terms`` coefficients that minimises max |w (g - p)| over the points.

    The Remez exchange on a finite set: solve for the levelled error on ``terms + 1`` reference points, move the
    reference to the largest error of each sign run, repeat until it stays where it is.
    """
    count = terms + 1
    last = len(points) - 1
    reference = sorted({round(last * (1 - float(ctx.cos(ctx.pi * i / terms))) / 2) for i in range(count)})
    while True:
        matrix = ctx.matrix(count, count)
        right = ctx.matrix(count, 1)
        for row, i in enumerate(reference):
            for power in range(terms):
                matrix[row, power] = points[i] ** power
            matrix[row, terms] = (-1) ** row / weights[i]
            right[row] = values[i]
        solution = ctx.lu_solve(matrix, right)
        coefficients = [solution[i] for i in range(terms)]
        errors = [w * (g - _horner(coefficients, z)) for z, g, w in zip(points, values, weights, strict=True)]
        exchanged = _extrema(errors, count)
        if exchanged == reference:
            return coefficients
        level = max(abs(errors[i]) for i in reference)
        if max(abs(error) for error in errors) <= level * (1 + ctx.mpf(10) ** -20):
            return coefficients
        reference = exchanged


def _extrema(errors: Sequence[Any], count: int) -> list[int]:
    """Return the indices of ``count`` alternating extrema: the largest error of every run of one sign."""
    runs: list[int] = []
    for i, error in enumerate(errors):
        if runs and (errors[runs[-1]] > 0) == (error > 0):
            if abs(error) > abs(errors[runs[-1]]):
                runs[-1] = i
        else:
            runs.append(i)
    while len(runs) > count:  # drop from the ends, so that the signs still alternate
        runs.pop(0 if abs(errors[runs[0]]) < abs(errors[runs[-1]]) else -1)
    return runs


def _coefficients(
    ctx: Any, points: Sequence[Any], values: Sequence[Any], weights: Sequence[Any], form: _Format
) -> tuple[float, ...]:
    """Fit and round: each coefficient is rounded in turn, lowest degree first, and the others fitted again."""
    rounded: list[float] = []
    remaining, weight = list(values), list(weights)
    for terms in range(form.terms, 0, -1):
        first = _rounded(ctx, _minimax(ctx, points, remaining, weight, terms)[0], form.bits)
        rounded.append(float(first))
        remaining = [(value - first) / z for value, z in zip(remaining, points, strict=True)]
        weight = [w * z for w, z in zip(weight, points, strict=True)]
    return tuple(rounded)


def _split_half_pi(ctx: Any, form: _Format) -> tuple[float, float, float, float]:
    """Split pi/2 so that the products of the first three parts with any |n| <= 2**quotient_bits are exact.

    The first two add up to pi/2 truncated to the format, which leaves ``x - n (c0 + c1)`` exact as well: it is a
    multiple of the last bit of either term and below 1. The third is as long as an exact product allows; the fourth
    takes what is left. The first three are positive, which keeps the sign of a negative zero.
    """
    half_pi = ctx.pi / 2
    short = form.bits - form.quotient_bits
    head = _rounded_down(ctx, half_pi, form.bits)
    first = _rounded_down(ctx, head, short)
    third = _rounded(ctx, half_pi - head, short)
    fourth = _rounded(ctx, half_pi - head - third, form.bits)
    return float(first), float(head - first), float(third), float(fourth)


def _closest_approaches(ctx: Any, form: _Format, limit: Any) -> list[tuple[int, Any]]:
    """Return, for every binade up to the limit, its largest n and a lower bound of the distance to a multiple of pi/2.

    In a binade the numbers are integers m < 2**bits times an ulp u, and ``|m u - n pi/2| = pi/2 |m a - n|`` with
    ``a = 2 u / pi``. The best approximations of ``a`` are the convergents of its continued fraction, so ``|m a - n|``
    is at least that of the last convergent whose denominator is below 2**bits.
    """
    approaches = []
    exponent = 0  # |x| >= pi/4 lies in the binade [0.5, 1) or above; 2**exponent is the binade's end
    while ctx.ldexp(1, exponent - 1) <= limit:
        alpha = ctx.ldexp(2, exponent - form.bits) / ctx.pi
        numerators, denominators = (1, 0), (0, 1)  # the last two convergents, newest first
        distance, rest = alpha, alpha
        while True:
            whole = int(ctx.floor(rest))
            numerators = (whole * numerators[0] + numerators[1], numerators[0])
            denominators = (whole * denominators[0] + denominators[1], denominators[0])
            if denominators[0] >= 2**form.bits:
                break
            distance = abs(denominators[0] * alpha - numerators[0])
            rest = 1 / (rest - whole)
        largest = int(ctx.floor(ctx.ldexp(2, exponent) / ctx.pi)) + 1
        approaches.append((largest, distance * ctx.pi / 2))
        exponent += 1
    return approaches


@cache
def constants(precision: Precision) -> SincosConstants:
    """Derive the constants of one type.

    Example:
        >>> c = constants("float64")
        >>> c.quotient_bits, c.magic == 1.5 * 2.0**52
        (20, True)
        >>> round(c.limit), c.sine_error < 2.0**-57, c.cosine_error < 2.0**-60
        (1647098, True, True)

    Raises:
        ValueError: ``precision`` is neither ``"float64"`` nor ``"float32"``.
    """
    if precision not in _FORMATS:
        raise ValueError(f"precision is {precision!r}: expected 'float64' or 'float32'")
    form = _FORMATS[precision]
    ctx = _context()
    half_pi = _split_half_pi(ctx, form)
    largest = 2**form.quotient_bits
    limit = _rounded_down(ctx, (largest - 1) * ctx.pi / 2, form.bits)
    # 2x/pi before its rounding to n carries the errors of the constant and, without FMA, of the product.
    half_width = ctx.pi / 2 * (ctx.mpf(1) / 2 + largest * ctx.ldexp(1, 1 - form.bits))

    points = _grid(ctx, half_width, _GRID)
    angles = [ctx.sqrt(z) for z in points]
    sines = [ctx.sin(r) / r for r in angles]
    cosines = [ctx.cos(r) for r in angles]
    sine = _coefficients(
        ctx,
        points,
        [(s - 1) / z for s, z in zip(sines, points, strict=True)],
        [z / s for s, z in zip(sines, points, strict=True)],
        form,
    )
    cosine = _coefficients(
        ctx,
        points,
        [(c - 1 + z / 2) / z**2 for c, z in zip(cosines, points, strict=True)],
        [z**2 / c for c, z in zip(cosines, points, strict=True)],
        form,
    )
    approaches = _closest_approaches(ctx, form, limit)
    # The tail, half an ulp of r at most, lacks n times what the split leaves out; its last product and sum are rounded.
    missing = abs(ctx.pi / 2 - sum(ctx.mpf(part) for part in half_pi))
    per_quadrant = missing + 2 * abs(ctx.mpf(half_pi[3])) * ctx.ldexp(1, -form.bits)
    sine_error, cosine_error = _polynomial_errors(ctx, half_width, sine, cosine)
    return SincosConstants(
        precision=precision,
        bits=form.bits,
        quotient_bits=form.quotient_bits,
        two_over_pi=float(_rounded(ctx, 2 / ctx.pi, form.bits)),
        magic=1.5 * 2.0 ** (form.bits - 1),
        half_pi=half_pi,
        limit=float(limit),
        half_width=_rounded_up(ctx, half_width),
        sine=sine,
        cosine=cosine,
        sine_error=sine_error,
        cosine_error=cosine_error,
        closest=float(_rounded_down(ctx, min(distance for _, distance in approaches), 53)),
        reduction_error=_rounded_up(
            ctx, max(n * per_quadrant / distance for n, distance in approaches) + ctx.ldexp(1, -2 * form.bits)
        ),
    )


def _grid(ctx: Any, half_width: Any, count: int) -> list[Any]:
    """Return ``count`` values of z = r**2 in (0, half_width**2], dense near the ends as Chebyshev points are."""
    return [half_width**2 * (1 - ctx.cos(ctx.pi * i / count)) / 2 for i in range(1, count + 1)]


def _polynomial_errors(
    ctx: Any, half_width: Any, sine: Sequence[float], cosine: Sequence[float]
) -> tuple[float, float]:
    """Return the largest relative errors on a dense grid, with a margin of one per cent for what lies between."""
    worst_sine = worst_cosine = ctx.mpf(0)
    sine_terms, cosine_terms = [ctx.mpf(c) for c in sine], [ctx.mpf(c) for c in cosine]
    for z in _grid(ctx, half_width, _CHECK_GRID):
        r = ctx.sqrt(z)
        true_sine, true_cosine = ctx.sin(r), ctx.cos(r)
        worst_sine = max(worst_sine, abs((r + r * z * _horner(sine_terms, z)) / true_sine - 1))
        worst_cosine = max(worst_cosine, abs((1 - z / 2 + z**2 * _horner(cosine_terms, z)) / true_cosine - 1))
    return _rounded_up(ctx, worst_sine * _MARGIN), _rounded_up(ctx, worst_cosine * _MARGIN)


def literal(value: float, precision: Precision) -> str:
    """Write a number as a C99 hexadecimal literal, which every compiler reads to the same bits.

    Example:
        >>> literal(-0.5, "float64"), literal(1.5, "float32")
        ('-0x1p-1', '0x1.8p+0f')
    """
    mantissa, exponent = value.hex().split("p")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return f"{mantissa}p{exponent}{_FORMATS[precision].suffix}"


def _pairwise(names: Sequence[str]) -> str:
    """Write a polynomial in z as Horner's scheme in ``z2`` over pairs: as many operations, half the latency."""
    pairs = [f"CR_MULADD(z, {odd}, {even})" for even, odd in zip(names[::2], names[1::2], strict=False)]
    if len(names) % 2:
        pairs.append(names[-1])
    text = pairs[-1]
    for pair in reversed(pairs[:-1]):
        text = f"CR_MULADD(z2, {text}, {pair})"
    return text


def _variables(precision: Precision) -> dict[str, Any]:
    c = constants(precision)
    head = Fraction(c.half_pi[0]) + Fraction(c.half_pi[1])
    sine = [(f"CR_SINE_{i}", literal(value, precision)) for i, value in enumerate(c.sine)]
    cosine = [(f"CR_COSINE_{i}", literal(value, precision)) for i, value in enumerate(c.cosine)]
    return {
        "bits": c.bits,
        "word": 64 if precision == "float64" else 32,
        "quotient_bits": c.quotient_bits,
        "two_over_pi": literal(c.two_over_pi, precision),
        "magic": literal(c.magic, precision),
        "magic_lowest": literal(c.magic - 2.0**c.quotient_bits, precision),
        "half_pi_truncated": literal(float(head), precision),
        "half_pi": [literal(part, precision) for part in c.half_pi],
        "limit": literal(c.limit, precision),
        "limit_decimal": f"{c.limit:.6g}",
        "sine": sine,
        "cosine": cosine,
        "sine_polynomial": _pairwise([name for name, _ in sine]),
        "cosine_polynomial": _pairwise([name for name, _ in cosine]),
        "sine_error": f"{c.sine_error:.2g}",
        "cosine_error": f"{c.cosine_error:.2g}",
    }


def context() -> dict[str, Any]:
    """Return the variables of ``templates/sincos.h.j2``: ``{"double": {...}, "float": {...}}``, literals as text.

    Example:
        >>> context()["double"]["magic"], context()["float"]["magic"]
        ('0x1.8p+52', '0x1.8p+23f')
    """
    return {"double": _variables("float64"), "float": _variables("float32")}
