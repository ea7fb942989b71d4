"""Where postures merge or appear along a straight path: the real roots of one polynomial, isolated with a proof.

Along a straight line p(u) = p0 + u (p1 - p0), rho^2 and z are polynomials of u, and so are the five coefficients of the
quartic in tan(theta3 / 2), each of degree 4. Its discriminant, of degree 24 at most, vanishes exactly where two of its
roots are equal. Between two neighbouring real roots of the discriminant the number of postures is constant, all of them
are regular, and none can turn into another.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from numpy.typing import NDArray

from chainrule.cuspidality.exact import Root, number_of_real_roots, roots_within
from chainrule.cuspidality.normal_form import Regional

Array = NDArray[Any]


@dataclass(frozen=True)
class Segment:
    """The events on one straight segment.

    Attributes:
        at: (k,) their places u in [0, 1], rising.
        numbers: (k + 1,) how many postures there are before, between and after them.
        everywhere: whether all of the segment is singular (``at`` and ``numbers`` then say nothing).
    """

    at: tuple[float, ...]
    numbers: tuple[int, ...]
    everywhere: bool = False


def segment_events(regional: Regional, start: Array, goal: Array) -> Segment:
    """The events between two points (3,) of the normal form, which are taken at their binary value."""
    from flint import fmpq

    coefficients = quartic_along(regional, start, goal)
    discriminant = evaluate_discriminant(coefficients)
    if discriminant.is_zero():
        return Segment((), (), True)
    roots = [] if _of_one_sign(discriminant) else roots_within(discriminant, fmpq(0), fmpq(1))
    edges = [fmpq(0), *(edge for root in roots for edge in (root.lower, root.upper)), fmpq(1)]
    numbers = [
        number_of_real_roots([c((low + high) / 2) for c in coefficients])
        for low, high in zip(edges[::2], edges[1::2], strict=True)
    ]
    at = tuple(_within_unit(root, discriminant) for root in roots)
    return Segment(at, tuple(numbers))


def quartic_along(regional: Regional, start: Array, goal: Array) -> list[Any]:
    """The coefficients of the quartic, lowest power first, as polynomials of u."""
    from flint import fmpq, fmpq_mat, fmpq_poly

    places = [fmpq(k, 4) for k in range(5)]
    first, last = ([fmpq(*float(x).as_integer_ratio()) for x in point] for point in (start, goal))
    targets = []
    for u in places:
        x, y, z = (p + u * (q - p) for p, q in zip(first, last, strict=True))
        targets.append([x * x + y * y, z])
    values = regional.exact_quartic(targets)
    powers = fmpq_mat(5, 5, [u**n for u in places for n in range(5)])
    solved = powers.solve(fmpq_mat(5, 5, [value for row in values for value in row]))
    return [fmpq_poly([solved[n, k] for n in range(5)]) for k in range(5)]


def _within_unit(root: Root, polynomial: Any) -> float:
    """A root's double in [0, 1]; exactly 0 or 1 where that is the root."""
    for end in (0, 1):
        if root.lower <= end <= root.upper and polynomial(end) == 0:
            return float(end)
    return min(max(root.value, 0.0), 1.0)


@cache
def _discriminant_terms() -> tuple[tuple[int, tuple[int, ...]], ...]:
    """The discriminant of a general quartic: (factor, exponents of its five coefficients), computed by FLINT."""
    from flint import Ordering, fmpz_mpoly_ctx

    ring = fmpz_mpoly_ctx.get(["t", *(f"e{k}" for k in range(5))], Ordering.lex)
    t, *e = ring.gens()
    general = sum((e[k] * t**k for k in range(5)), 0 * t)
    found = general.discriminant("t")
    return tuple((int(found[m]), tuple(int(x) for x in m[1:])) for m in found.monoms())


def evaluate_discriminant(coefficients: list[Any]) -> Any:
    """The discriminant of a quartic with these five coefficients, of any kind that can be added and multiplied."""
    powers = [[None, c, c * c, c * c * c, c * c * c * c] for c in coefficients]
    total: Any = 0
    for factor, exponents in _discriminant_terms():
        term: Any = factor
        for k, exponent in enumerate(exponents):
            if exponent:
                term = term * powers[k][exponent]
        total = total + term
    return total


def _of_one_sign(polynomial: Any) -> bool:
    """Whether the Bernstein coefficients on [0, 1] prove that a polynomial has no root there."""
    n = polynomial.degree()
    if n < 1:
        return True
    c = polynomial.coeffs()
    # b_k = sum_i C(k, i) / C(n, i) c_i, by repeated sums
    scaled = [value / _binomial(n, i) for i, value in enumerate(c)]
    positive = negative = False
    for k in range(n + 1):
        b = sum((_binomial(k, i) * scaled[i] for i in range(k + 1)), 0 * scaled[0])
        positive, negative = positive or b > 0, negative or b < 0
        if b == 0 or (positive and negative):
            return False
    return True


@cache
def _binomial(n: int, k: int) -> int:
    from math import comb

    return comb(n, k)
