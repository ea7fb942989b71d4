"""Exact numbers for proofs: rational input, the real roots of rational polynomials, and signs at them.

Nothing here has a tolerance. Roots are isolated in balls by FLINT (F. Johansson, "Arb: efficient arbitrary-precision
midpoint-radius interval arithmetic", IEEE Transactions on Computers 66, 2017) and refined by interval Newton steps. A
sign at a root is read off a ball that excludes zero; where none does, a greatest common divisor proves that it is zero.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise
from numbers import Integral
from typing import Any

import numpy as np

from chainrule.balls import nearest
from chainrule.errors import InputError, shown

#: Decimal numbers as text (nothing is evaluated), and the largest exponent of ten that is taken exactly.
_DECIMAL = re.compile(r"[+-]?(?:[0-9]{1,400}\.?[0-9]{0,400}|\.[0-9]{1,400})(?:[eE][+-]?[0-9]{1,3})?")
_MOST_EXPONENT = 400

#: Bits to begin with, and to give up at.
FIRST_BITS, MOST_BITS = 64, 1 << 15


def rational(value: Any, name: str = "value") -> Any:
    """``value`` as an ``fmpq``, exactly; a float at its binary value.

    Raises:
        InputError: no int, Fraction, Decimal, decimal text or float; what is not finite.

    Example:
        >>> rational("1.25"), rational(0.1) == rational("0.1")
        (5/4, False)
    """
    from flint import fmpq, fmpz

    if isinstance(value, (fmpq, fmpz)):
        return fmpq(value)
    if isinstance(value, str) and _DECIMAL.fullmatch(value.strip()):
        value = Decimal(value.strip())
    if isinstance(value, Decimal) and value.is_finite() and abs(value.adjusted()) <= _MOST_EXPONENT:
        value = Fraction(value)
    elif isinstance(value, (float, np.floating)) and np.isfinite(value):
        value = Fraction(float(value))
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (Integral, Fraction)):
        raise InputError(f"{name}: {shown(value)}; an int, Fraction, Decimal, decimal text or finite float is accepted")
    return fmpq(int(value.numerator), int(value.denominator))


def sign(value: Any) -> int:
    """-1, 0 or 1, of an exact number."""
    return int(value > 0) - int(value < 0)


def surd_sign(whole: Any, factor: Any, radicand: Any) -> int:
    """The sign of ``whole + factor sqrt(radicand)`` for rational numbers, radicand not negative, by squaring.

    Example:
        >>> surd_sign(3, -2, 2), surd_sign(2, -1, 4), surd_sign(-3, 2, 3)
        (1, 0, 1)
    """
    first, second = sign(whole), sign(factor) if radicand != 0 else 0
    if first * second >= 0:
        return first or second
    return first * sign(whole * whole - factor * factor * radicand)


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Ball arithmetic with so many bits for a while."""
    from flint import ctx

    before = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = before


def dyadic(ball: Any) -> Any:
    """The number that a ball of radius zero is, as an ``fmpq``."""
    from flint import fmpq

    mantissa, exponent = (int(part) for part in ball.man_exp())
    return fmpq(mantissa * 2**exponent) if exponent >= 0 else fmpq(mantissa, 2**-exponent)


@dataclass(frozen=True)
class Root:
    """A real root of a rational polynomial.

    Attributes:
        of: a polynomial (``fmpz_poly``) without multiple roots that has it.
        ball: an enclosure (``arb``) with no other root of ``of``; None for the root at infinity.
        multiplicity: how often the polynomial given has it.
    """

    of: Any
    ball: Any
    multiplicity: int

    @property
    def value(self) -> float:
        """The nearest double, or one of the next; infinite for the root at infinity."""
        return float("inf") if self.ball is None else nearest(self.refined(128).ball)

    def __float__(self) -> float:
        return self.value

    @property
    def lower(self) -> Any:
        """A rational number not above the root; different roots of one list have disjoint intervals."""
        return dyadic(self.ball.mid()) - dyadic(self.ball.rad())  # ball.lower() would be rounded to FLINT's precision

    @property
    def upper(self) -> Any:
        """A rational number not below the root."""
        return dyadic(self.ball.mid()) + dyadic(self.ball.rad())

    def refined(self, bits: int) -> Root:
        """The same root in a ball of about so many correct bits; never in a wider one."""
        from flint import arb, arb_poly

        if self.ball is None or self.ball.is_exact() or self.ball.rel_accuracy_bits() >= bits:
            return self
        with precision(bits + 32):
            f, ball = arb_poly(self.of), self.ball
            slope = f.derivative()
            while ball.rel_accuracy_bits() < bits:
                if slope(ball).contains(0):  # too wide for a step
                    low, high = _half(self.of, dyadic(ball.mid()), dyadic(ball.rad()))
                    closer = arb(low).union(arb(high))
                else:
                    middle = ball.mid()
                    closer = ball.intersection(middle - f(middle) / slope(ball))
                if not closer.rad() < ball.rad() * 0.75:
                    break
                ball = closer
        return Root(self.of, ball, self.multiplicity)


def _half(simple: Any, middle: Any, radius: Any) -> tuple[Any, Any]:
    """The half of an interval round ``middle`` that holds its only, simple root; by exact signs."""
    at_middle = sign(simple(middle))
    if at_middle == 0:
        return middle, middle
    return (middle, middle + radius) if at_middle == sign(simple(middle - radius)) else (middle - radius, middle)


def lower(root: Root) -> Any:
    """A rational number not above the root."""
    return root.lower


def upper(root: Root) -> Any:
    """A rational number not below the root."""
    return root.upper


def _isolated(simple: Any) -> list[Any]:
    """Disjoint balls, one for each real root of an ``fmpz_poly`` without multiple roots.

    The quick way takes discs of all roots. A disc that meets the real axis and whose mirror image meets no other disc
    holds a real root: a root that is not real would have its conjugate in another disc. Where that leaves a doubt,
    FLINT's slower isolation of the roots of integer polynomials decides.
    """
    from flint import arb_poly

    with precision(FIRST_BITS):
        try:
            discs = arb_poly(simple).complex_roots()
        except ValueError:  # no convergence
            discs = []
        real = [disc for disc in discs if disc.imag.contains(0)]
        meeting = sum(disc.conjugate().overlaps(other) for disc in real for other in discs)
        balls = [disc.real for disc in real]
        if len(discs) == simple.degree() and meeting == len(real) and not _meet(balls):
            return balls
    bits = FIRST_BITS
    while bits <= MOST_BITS:
        with precision(bits):
            balls = [found.real for found, _ in simple.complex_roots() if found.imag == 0]
            if not _meet(balls):
                return balls
        bits *= 2
    raise ArithmeticError(f"roots were not isolated with {MOST_BITS} bits")


def _meet(balls: list[Any]) -> bool:
    return any(ball.overlaps(other) for k, ball in enumerate(balls) for other in balls[:k])


def real_roots(polynomial: Any, degree: int | None = None) -> list[Root]:
    """The distinct real roots of an ``fmpq_poly``, rising, with their multiplicities.

    ``degree`` is what the degree would be if no leading coefficient vanished: then infinity is the last root.

    Raises:
        ZeroDivisionError: the polynomial is zero: every number is a root.

    Example:
        >>> from flint import fmpq_poly
        >>> [(root.value, root.multiplicity) for root in real_roots(fmpq_poly([0, 0, -1, 1]), 4)]
        [(0.0, 2), (1.0, 1), (inf, 1)]
    """
    if polynomial.degree() < 0:
        raise ZeroDivisionError("the polynomial is zero: every number is a root")
    whole = polynomial.numer()
    simple, parts = whole, [(whole, 1)]
    if whole.degree() > 1 and whole.gcd(whole.derivative()).degree() > 0:
        parts = whole.factor_squarefree()[1]
        simple = parts[0][0]
        for part, _ in parts[1:]:
            simple = simple * part
    balls = _isolated(simple) if simple.degree() > 0 else []
    found = [Root(simple, ball, 1) for ball in sorted(balls, key=lambda ball: dyadic(ball.mid()))]
    if simple is not whole:
        found = [Root(simple, r.ball, next(m for part, m in parts if sign_at(part, r) == 0)) for r in found]
    if degree is not None and polynomial.degree() < degree:
        found.append(Root(simple, None, degree - polynomial.degree()))
    return found


def sign_at(polynomial: Any, root: Root, degree: int | None = None) -> int:
    """The sign of a rational polynomial at a root of another one, decided also where it is zero.

    At infinity it is the sign of the coefficient of ``degree``, an even number.

    Example:
        >>> from flint import fmpq_poly
        >>> root = real_roots(fmpq_poly([-2, 0, 1]))[1]
        >>> sign_at(fmpq_poly([-7, 5]), root), sign_at(fmpq_poly([4, 0, -4, 0, 1]), root)
        (1, 0)
    """
    from flint import arb_poly, fmpq_poly

    polynomial = fmpq_poly(polynomial)
    if root.ball is None:
        return sign(polynomial[polynomial.degree() if degree is None else degree])
    bits, rest = FIRST_BITS, None
    while bits <= MOST_BITS:
        with precision(bits + 32):
            value = arb_poly(polynomial)(root.ball)
            if value > 0 or value < 0:
                return 1 if value > 0 else -1
            if rest is None:
                of = fmpq_poly(root.of)
                rest = of // of.gcd(polynomial)
            if not arb_poly(rest)(root.ball).contains(0):  # the root is one of the common divisor
                return 0
        bits *= 2
        root = root.refined(bits)
    raise ArithmeticError(f"a sign was not decided with {MOST_BITS} bits")


def roots_within(polynomial: Any, low: Any, high: Any) -> list[Root]:
    """The distinct real roots of an ``fmpq_poly`` in the closed interval between two rational numbers, rising.

    Example:
        >>> from flint import fmpq, fmpq_poly
        >>> [root.value for root in roots_within(fmpq_poly([0, -2, 3, -1]), fmpq(0), fmpq(1))]
        [0.0, 1.0]
    """
    from flint import fmpq_poly

    below, above = fmpq_poly([-low, 1]), fmpq_poly([-high, 1])
    return [root for root in real_roots(polynomial) if sign_at(below, root) >= 0 >= sign_at(above, root)]


def number_of_real_roots(coefficients: Sequence[Any]) -> int:
    """The number of distinct real roots, infinity among them, of a polynomial given lowest power first.

    That is the number of distinct angles 2 atan(t). By Sturm's sequence: no root is looked for.

    Raises:
        ZeroDivisionError: the polynomial is zero: every number is a root.

    Example:
        >>> number_of_real_roots([-1, 0, 1, 0, 0])        # t = -1, t = 1, and t = infinity
        3
    """
    from flint import fmpq_poly

    polynomial = fmpq_poly(list(coefficients))
    if polynomial.degree() < 0:
        raise ZeroDivisionError("the polynomial is zero: every number is a root")
    sequence = [polynomial, polynomial.derivative()]
    while sequence[-1].degree() >= 0:
        sequence.append(-(sequence[-2] % sequence[-1]))
    above = [sign(p[p.degree()]) for p in sequence[:-1]]
    below = [s if p.degree() % 2 == 0 else -s for s, p in zip(above, sequence[:-1], strict=True)]
    changes = [sum(a != b for a, b in pairwise(signs)) for signs in (below, above)]
    return changes[0] - changes[1] + int(polynomial.degree() < len(coefficients) - 1)
