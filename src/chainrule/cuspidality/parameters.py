"""The parameters of a 3R arm's normal form as exact numbers, and what is special about them, decided exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.exact import rational, sign
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, Regional, check_lengths
from chainrule.description import REGIONAL_3R
from chainrule.errors import InputError

Array = NDArray[Any]


def exact_parameters(given: Any) -> Array:
    """The parameters of a normal form as an object array (9,) of ``fmpq``.

    Args:
        given: a :class:`Regional` (see its ``rationals``); (d2, d3, d4, r2) of an orthogonal arm; or all of (ca2, sa2,
            ca3, sa3, d2, d3, d4, r2, r3) with ca2^2 + sa2^2 = 1 and ca3^2 + sa3^2 = 1. Entries are what
            :func:`chainrule.cuspidality.exact.rational` takes.

    Raises:
        InputError: another number of entries, an entry that is no such number, twists off the unit circle, or lengths
            that :func:`chainrule.cuspidality.normal_form.check_lengths` refuses.

    Example:
        >>> exact_parameters([1, 2, "1.5", 1])[:7].tolist()
        [0, -1, 0, 1, 1, 2, 3/2]
    """
    if isinstance(given, Regional):
        return given.rationals
    entries = list(given) if isinstance(given, (Sequence, np.ndarray)) and not isinstance(given, (str, bytes)) else []
    if len(entries) == 4:
        names: tuple[str, ...] = ORTHOGONAL_3R.parameter_names
        entries = [0, -1, 0, 1, *(rational(value, name) for value, name in zip(entries, names, strict=True)), 0]
    names = REGIONAL_3R.parameter_names
    if len(entries) != len(names):
        raise InputError(f"a 3R arm: {len(entries)} numbers; (d2, d3, d4, r2) or ({', '.join(names)}) is accepted")
    found = np.empty(9, object)
    found[:] = [rational(value, name) for value, name in zip(entries, names, strict=True)]
    for k, name in ((0, "alpha2"), (2, "alpha3")):
        if found[k] * found[k] + found[k + 1] * found[k + 1] != 1:
            raise InputError(
                f"{name}: cosine {found[k]} and sine {found[k + 1]}; squares that add up to 1 are accepted"
            )
    check_lengths("a 3R arm", [Fraction(int(length.p), int(length.q)) for length in found[4:]])
    return found


def half_tangent(value: Any) -> tuple[Any, Any]:
    """(cos alpha, sin alpha), rational, of the twist with this tan(alpha / 2).

    Example:
        >>> half_tangent("0.5")
        (3/5, 4/5)
    """
    t = rational(value, "tan(alpha / 2)")
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def orthogonal_lengths(parameters: Array) -> Array | None:
    """(d2, d3, d4, r2) where exact parameters are those of the orthogonal family, else None."""
    right = all(parameters[k] == value for k, value in ((0, 0), (1, -1), (2, 0), (3, 1), (8, 0)))
    found: Array = parameters[4:8]
    return found if right else None


def why_nongeneric(parameters: Array) -> tuple[str, ...]:
    """Why the arm is not generic, in the words of :attr:`Regional.nongeneric`: only signs matter there."""
    return Regional(tuple(float(sign(value)) for value in parameters)).nongeneric
