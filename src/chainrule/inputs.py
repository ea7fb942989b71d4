"""What callers give, as arrays and numbers of the right kind, or one clear line."""

from __future__ import annotations

from operator import index
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown


def real_array(value: Any, name: str, *, finite: bool = True) -> NDArray[Any]:
    """``value`` as an array of doubles, of any shape; ``name`` is what a message calls it.

    Raises:
        InputError: ragged or not real; nan, or (where ``finite``) infinite entries, with the place of the first.

    Example:
        >>> real_array([[1, 2]], "q")
        array([[1., 2.]])
    """
    try:
        array = np.asarray(value)
    except ValueError:
        raise InputError(f"{name}: a ragged nested sequence was given; an array of real numbers is accepted") from None
    if array.dtype.kind not in "iuf":
        raise InputError(f"{name}: {shown(value)}; an array of real numbers is accepted")
    array = array.astype(float)
    wrong = ~np.isfinite(array) if finite else np.isnan(array)
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        accepted = "finite numbers are accepted" if finite else "numbers are accepted, infinite ones too"
        raise InputError(f"{name}{list(at) if at else ''}: {array[at]}; {accepted}")
    return array


def whole_number(value: Any, name: str, least: int = 1, most: int | None = None) -> int:
    """``value`` as an int of at least ``least``, and at most ``most``.

    Raises:
        InputError: anything else: a fraction, nan, text, a truth value, a smaller or larger number.

    Example:
        >>> whole_number(3, "size")
        3
    """
    try:
        found = index(value)
    except TypeError:
        found = least - 1
    if isinstance(value, (bool, np.bool_)) or found < least:
        raise InputError(f"{name}: {shown(value)}; a whole number, {least} or more, is accepted")
    if most is not None and found > most:
        raise InputError(f"{name}: {shown(value)}; up to {most} are accepted")
    return found
