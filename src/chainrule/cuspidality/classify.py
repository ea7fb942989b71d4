"""Domains and topologies of orthogonal 3R arms, for arrays of designs: one generated function, in floating point."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, evaluator
from chainrule.errors import InputError
from chainrule.inputs import real_array

Array = NDArray[Any]

#: Designs evaluated at a time, and lengths beyond which they are made smaller first.
BLOCK, LARGEST = 8192, 1e300


def classify_orthogonal_3r(d2: Any, d3: Any, d4: Any, r2: Any) -> Array:
    """The domain 1 to 5 of orthogonal 3R arms: 0, 4, 2, 4, 0 cusps; arms of the domains 2, 3 and 4 are cuspidal.

    0 where it is not decided: the design is on a separating surface C1 to C4 to within rounding, or a length is 0 (an
    arm of another family, never cuspidal: with r2 = 0 as well). The exact answer is that of ``exact=True`` of
    :func:`chainrule.orthogonal_3r`.

    Args:
        d2: lengths in m, arrays that broadcast. Only their ratios matter, and not their signs: a negative d2, d3 or
            d4 is the positive one with joint angles turned by pi, a negative r2 mirrors the arm.
        d3: as d2.
        d4: as d2.
        r2: as d2.

    Returns:
        int8, of the common shape. C1 to C4 are derived in ``chainrule.derive.orthogonal_designs`` (Baili, Wenger and
        Chablat 2004, equations 2 to 6).

    Raises:
        InputError: not finite real numbers, or shapes that do not broadcast.

    Example:
        >>> classify_orthogonal_3r(1.0, 2.0, [0.1, 1.5, 3.0, 8.0], 1.0)
        array([1, 2, 4, 4], dtype=int8)
    """
    return _classified(d2, d3, d4, r2, 0)


def topology_orthogonal_3r(d2: Any, d3: Any, d4: Any, r2: Any) -> Array:
    """The topology 1 to 9 of the workspace of orthogonal 3R arms: domains cut by the surfaces E1 to E3.

    By rising d4: 1 is domain 1; 2, 3, 4 are domain 2 below E1, up to E2, and above; 5 and 6 domain 3 below and above
    E3; 7 domain 4; 8 and 9 domain 5 below and above E3. Their cusps and nodes are 0/0, 4/2, 4/0, 4/2, 2/1, 2/3, 4/4,
    0/0, 0/2 (``TOPOLOGIES`` of :mod:`chainrule.cuspidality.domains`); nodes with z = 0 count once, pairs +-z twice.

    0 where it is not decided, as in :func:`classify_orthogonal_3r`, also at the surfaces E1 to E3 that cut its domain.

    Args:
        d2: lengths in m, as for :func:`classify_orthogonal_3r`.
        d3: as d2.
        d4: as d2.
        r2: as d2.

    Returns:
        int8, of the common shape.

    Raises:
        InputError: not finite real numbers, or shapes that do not broadcast.

    Example:
        >>> int(topology_orthogonal_3r(1.0, 2.0, 1.5, 1.0))
        3
    """
    return _classified(d2, d3, d4, r2, 1)


def _classified(d2: Any, d3: Any, d4: Any, r2: Any, which: int) -> Array:
    """The generated function's output ``which``, block by block so that each stays in the cache."""
    lengths = [real_array(value, name) for value, name in zip((d2, d3, d4, r2), ("d2", "d3", "d4", "r2"), strict=True)]
    try:
        shape = np.broadcast_shapes(*(length.shape for length in lengths))
    except ValueError:
        shapes = ", ".join(str(length.shape) for length in lengths)
        raise InputError(f"d2, d3, d4, r2: the shapes {shapes} do not broadcast") from None
    flat = [np.broadcast_to(length, shape).reshape(-1) for length in lengths]
    found = np.empty(flat[0].size, np.int8)
    numbers = evaluator("classify", ORTHOGONAL_3R)
    parameters = np.empty((min(BLOCK, found.size), 4))
    for start in range(0, found.size, BLOCK):
        block = parameters[: min(BLOCK, found.size - start)]
        for place, length in enumerate(flat):
            block[:, place] = length[start : start + BLOCK]
        largest = np.abs(block).max()
        if largest > LARGEST:  # the sum of four lengths must not leave the range of doubles
            block *= 2.0**-4
        found[start : start + BLOCK] = numbers(block)[which]
    return found.reshape(shape)
