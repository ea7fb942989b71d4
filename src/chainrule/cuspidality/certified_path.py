"""A proof that a function of the joints keeps its sign along a whole path, in ball arithmetic.

A path is a B-spline with clamped knots one apart: of degree 1 a polyline, of degree 3 a smooth curve. Each of its
polynomial pieces stays in the hull of its Bernstein coefficients, so the function, run on balls that hold the hull, gives
a ball that holds every value along the piece. Pieces whose ball contains zero are halved (de Casteljau) until none is
left, or until there are too many. Nothing is sampled: what is certified holds at every point of the path.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.balls import above, below, exact
from chainrule.errors import InputError

Array = NDArray[Any]
#: A map of balls (k, n) to balls (k,).
OnBalls = Callable[[Array], Array]

#: Bits of a ball's midpoint, how often a piece may be halved, and how many pieces may wait to be decided.
PRECISION, MOST_HALVINGS, MOST_PIECES = 96, 14, 20_000


@dataclass(frozen=True)
class SignProof:
    """What was proved of a function along a path.

    Attributes:
        certified: whether it keeps one sign, without zeros, along the whole path.
        sign: 1 or -1; 0 where nothing was proved.
        lower_bound: of its absolute value along the path, a proved one; 0 where nothing was proved.
        pieces: into how many pieces the proof cut the path.
    """

    certified: bool
    sign: int
    lower_bound: float
    pieces: int


def certify_sign(function: OnBalls, pieces: Array, *, at_least: float = 0.0, precision: int = PRECISION) -> SignProof:
    """Prove that a function keeps one sign along a path.

    A path that crosses a zero is refused, and so is one that comes too near to it for :data:`MOST_HALVINGS`.

    Args:
        function: maps balls (k, n) to balls (k,), such as a generated function run on balls.
        pieces: (k, d + 1, n) the Bernstein coefficients of the path's pieces, numbers or balls; :func:`bezier` has them.
        at_least: go on until the lower bound exceeds this, by default just until the sign is certain.
        precision: bits of a ball's midpoint.

    Example:
        >>> proof = certify_sign(lambda q: q[:, 0] * q[:, 1] + 1, bezier([[-1.0, 0.5], [2.0, 0.5]], 1))
        >>> proof.certified, proof.sign, round(proof.lower_bound, 2)
        (True, 1, 0.5)
        >>> certify_sign(lambda q: q[:, 0], bezier([[-1.0, 0.5], [2.0, 0.5]], 1)).certified
        False
    """
    from flint import ctx

    with ctx.workprec(precision):
        waiting = exact(pieces)
        sign = _sign(function(waiting[:1, 0])[0])
        lowest, used = math.inf, 0
        for _ in range(MOST_HALVINGS + 1):
            if sign == 0 or len(waiting) > MOST_PIECES:
                break
            low = np.array([_least(value, sign) for value in function(hull(waiting))])
            decided = low > at_least
            used += int(decided.sum())
            lowest = min(lowest, float(low[decided].min(initial=math.inf)))
            if decided.all():
                return SignProof(True, sign, lowest, used)
            waiting = waiting[~decided]
            if any(_sign(value) != sign for value in function(waiting[:, 0])):  # a piece begins at a zero or beyond
                break
            waiting = halved(waiting)
    return SignProof(False, 0, 0.0, used)


def _sign(value: Any) -> int:
    """The sign of a ball; 0 where it contains zero, or is no number."""
    return 1 if value > 0 else -1 if value < 0 else 0


def _least(value: Any, sign: int) -> float:
    """The least that ``sign`` times a number of the ball can be, rounded down; -inf where it is no number."""
    if not value.is_finite():
        return -math.inf
    return below(value) if sign > 0 else -above(value)


# ---- splines -------------------------------------------------------------------------------------------------------


def knots(count: int, degree: int) -> Array:
    """The clamped knots (count + degree + 1,), one apart, of a B-spline with ``count`` control points: 0 to count - d.

    Raises:
        InputError: fewer than degree + 1 control points.

    Example:
        >>> knots(5, 3)
        array([0., 0., 0., 0., 1., 2., 2., 2., 2.])
    """
    if count <= degree:
        raise InputError(f"{count} control points; a path of degree {degree} has at least {degree + 1}")
    return np.concatenate([np.zeros(degree), np.arange(count - degree + 1.0), np.full(degree, count - float(degree))])


def sample(control: Array, degree: int, s: Any, derivative: int = 0) -> Array:
    """Points (..., n) of the B-spline with control points (k, n) at ``s`` (...) from 0 to 1, or their derivative by s."""
    from scipy.interpolate import BSpline

    last = len(control) - degree
    spline = BSpline(knots(len(control), degree) / last, np.asarray(control, float), degree)
    found: Array = spline(np.asarray(s, float), nu=derivative)
    return found


def bezier(control: Any, degree: int) -> Array:
    """The Bernstein coefficients (k - d, d + 1, n) of the pieces of a B-spline with control points (k, n), as balls.

    By blossoming: coefficient j of the piece from t to t + 1 is the blossom at d - j times t and j times t + 1. The knots
    are whole numbers, so the weights are exact but for the rounding of thirds, which the balls hold.
    """
    from flint import arb, ctx, fmpq

    with ctx.workprec(PRECISION):
        points = exact(control)
        count = len(points)
        knot = knots(count, degree).astype(int)
        piece = np.arange(count - degree)
        found = np.empty((count - degree, degree + 1, points.shape[1]), object)
        for order in range(degree + 1):
            level = [points[piece + i] for i in range(degree + 1)]
            for r in range(1, degree + 1):
                at = piece + (1 if r <= order else 0)
                for i in range(degree, r - 1, -1):
                    low, high = knot[piece + i], knot[piece + i + degree + 1 - r]
                    weight = np.empty((count - degree, 1), object)
                    weight[:, 0] = [
                        arb(fmpq(int(n), int(d))) for n, d in zip(at - low, np.maximum(high - low, 1), strict=True)
                    ]
                    level[i] = level[i - 1] * (1 - weight) + level[i] * weight
            found[:, order] = level[degree]
        return found


def halved(pieces: Array) -> Array:
    """De Casteljau at the middle: the coefficients (k, d + 1, n) of pieces to those of their halves (2 k, d + 1, n)."""
    from flint import arb

    half, level = arb(0.5), [pieces[:, i] for i in range(pieces.shape[1])]
    left, right = [level[0]], [level[-1]]
    while len(level) > 1:
        level = [(a + b) * half for a, b in zip(level[:-1], level[1:], strict=True)]
        left.append(level[0])
        right.append(level[-1])
    return np.concatenate([np.stack(left, axis=1), np.stack(right[::-1], axis=1)])


def hull(pieces: Array) -> Array:
    """Balls (k, n) that hold the pieces (k, d + 1, n)."""
    found = np.empty((pieces.shape[0], pieces.shape[2]), object)
    for k, m in np.ndindex(found.shape):
        ball = pieces[k, 0, m]
        for i in range(1, pieces.shape[1]):
            ball = ball.union(pieces[k, i, m])
        found[k, m] = ball
    return found
