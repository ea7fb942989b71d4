"""Numbers with square roots, x + y sqrt(d), exactly: their signs are found by squaring."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chainrule.cuspidality.exact import sign


def sign_of(value: Any) -> int:
    """-1, 0 or 1, of a rational number or a :class:`Surd`."""
    return value.sign() if isinstance(value, Surd) else sign(value)


def ball_of(value: Any) -> Any:
    """A rational number or a :class:`Surd` as a ball in the present precision."""
    from flint import arb

    return value.ball() if isinstance(value, Surd) else arb(value)


@dataclass(frozen=True)
class Surd:
    """x + y sqrt(d), where x, y and d >= 0 are rational, or themselves surds of one smaller field.

    Two surds of one field hold the same object ``d``. sqrt(d) may lie in the smaller field: signs are right even then.

    Example:
        >>> from flint import fmpq
        >>> root = Surd(fmpq(0), fmpq(1), fmpq(2))
        >>> (root * root - 2).sign(), (5 * root - 7).sign()
        (0, 1)
    """

    x: Any
    y: Any
    d: Any

    def _lift(self, other: Any) -> Surd:
        return other if isinstance(other, Surd) and other.d is self.d else Surd(self.x * 0 + other, self.y * 0, self.d)

    def __add__(self, other: Any) -> Surd:
        other = self._lift(other)
        return Surd(self.x + other.x, self.y + other.y, self.d)

    def __neg__(self) -> Surd:
        return Surd(-self.x, -self.y, self.d)

    def __sub__(self, other: Any) -> Surd:
        other = self._lift(other)
        return Surd(self.x - other.x, self.y - other.y, self.d)

    def __rsub__(self, other: Any) -> Surd:
        return self._lift(other) - self

    def __mul__(self, other: Any) -> Surd:
        if isinstance(other, Surd) and other.d is self.d:
            return Surd(self.x * other.x + self.y * other.y * self.d, self.x * other.y + self.y * other.x, self.d)
        return Surd(self.x * other, self.y * other, self.d)

    __radd__, __rmul__ = __add__, __mul__

    def inverse(self) -> Surd:
        """1 / this number, which is not zero."""
        norm = self.x * self.x - self.y * self.y * self.d
        if sign_of(norm) == 0:  # sqrt(d) lies in the smaller field, and x = y sqrt(d): the number is 2 x
            return Surd(reciprocal(2 * self.x), self.y * 0, self.d)
        over = reciprocal(norm)
        return Surd(self.x * over, -self.y * over, self.d)

    def sign(self) -> int:
        """-1, 0 or 1."""
        first, second = sign_of(self.x), sign_of(self.y) * sign_of(self.d)
        if first * second >= 0:
            return first or second
        return first * sign_of(self.x * self.x - self.y * self.y * self.d)

    def ball(self) -> Any:
        """A ball around it in the present precision."""
        return ball_of(self.x) + ball_of(self.y) * ball_of(self.d).nonnegative_part().sqrt()


def reciprocal(value: Any) -> Any:
    """1 / value of a number that is not zero."""
    return value.inverse() if isinstance(value, Surd) else 1 / value


def square_root(d: Any) -> Any:
    """sqrt(d) of a number that is not negative: rational where it is, else a :class:`Surd`.

    Example:
        >>> from flint import fmpq
        >>> square_root(fmpq(9, 4)), square_root(fmpq(2)).sign()
        (3/2, 1)
    """
    from flint import fmpq

    if not isinstance(d, Surd):
        above, below = d.p.isqrt(), d.q.isqrt()
        if above * above == d.p and below * below == d.q:
            return fmpq(above, below)
    return Surd(d * 0, d * 0 + 1, d)
