"""The generated functions in ball arithmetic: numbers with a radius, so that the true result is always inside.

The minors' generated NumPy code uses sums, products, sines and cosines only. On arrays of python-flint's ``arb`` the
same text computes with balls (F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval arithmetic",
IEEE Transactions on Computers 66, 2017): what is proved this way holds for the code that users run.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import inf, nextafter
from runpy import run_path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule import compile as compiling
from chainrule.arm import Arm

Array = NDArray[Any]
Minors = Callable[[Array], Array]

#: Bits of a ball's midpoint.
PRECISION = 256


def exact(values: Any) -> Array:
    """Numbers as balls of radius zero, an object array of the same shape.

    Example:
        >>> exact([0.5, 0.25]).sum()
        0.750000000000000
    """
    from flint import arb

    given = np.asarray(values)
    found = np.empty(given.shape, object)
    for place, value in np.ndenumerate(given):
        found[place] = value if isinstance(value, arb) else arb(float(value))
    return found


def minors_on_balls(arm: Arm, task: str) -> Minors | None:
    """The generated function ``minors_<task>`` as a map of balls (k, n) to balls (k, number of minors).

    None where the task is not treated by its minors.
    """
    from flint import arb

    code = run_path(str(compiling.find(arm.description.model, task).numpy_module)).get(f"minors_{task}")
    if code is None:
        return None
    parameters = [exact(arm.parameters)] if arm.parameters.size else []

    def minors(q: Array) -> Array:
        found: Array = code(q, *parameters)
        for place, value in np.ndenumerate(found):
            if not isinstance(value, arb):  # a constant of the code
                found[place] = arb(value)
        return found

    return minors


def value_on_balls(minors: Minors, q: Array) -> Any:
    """H^2 at one configuration (n,) of balls: the sum of the squares of the generated minors (Cauchy-Binet)."""
    from flint import arb

    return sum((minor * minor for minor in minors(q[None, :])[0]), arb(0))  # not **: nan for a ball with zero


def nearest(ball: Any) -> float:
    """The double nearest to the middle of a ball.

    Raises:
        OverflowError: there is none.
    """
    mantissa, exponent = ball.mid().man_exp()
    power = int(exponent)
    if power + int(mantissa).bit_length() < -1100:
        return 0.0
    return float(int(mantissa) * Fraction(2) ** power)


def above(ball: Any) -> float:
    """The smallest double that no number of the ball exceeds, or one of the next.

    Raises:
        OverflowError: there is none.
    """
    from flint import arb

    top = ball.upper()
    found = nearest(top)
    return found if arb(found) >= top else nextafter(found, inf)


def below(ball: Any) -> float:
    """The largest double that every number of the ball reaches, or one of the next.

    Raises:
        OverflowError: there is none.
    """
    return -above(-ball)
