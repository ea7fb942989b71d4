"""A proof that an exact configuration of the same pose lies next to one that floats found.

Krawczyk's test (R. Krawczyk 1969; A. Neumaier, Interval Methods for Systems of Equations, 1990) on the six equations
    p(q) = p,   A - A^T = 0 with A = R(q) R^T,
in ball arithmetic on the generated pose and Jacobian. A rotation with A = A^T is the identity or a half turn; a positive
trace, shown too, leaves the identity. The fixed rotations of an arm given by doubles are orthogonal to rounding only
(a 60 degree twist has no exact cosine and sine); so much, 1e-16, the equation "the same orientation" means.
"""

from __future__ import annotations

from collections.abc import Callable
from runpy import run_path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule import compile as compiling
from chainrule.arm import Arm
from chainrule.balls import exact
from chainrule.cuspidality.inverse import skew_part

Array = NDArray[Any]

#: Bits of a ball's midpoint, and the radii of the box tried, rad.
PRECISION, RADII = 128, tuple(10.0**k for k in range(-14, -6))


def neighbour(arm: Arm, start: Array, goal: Array) -> Array | None:
    """A box (6,) of balls round ``goal`` with exactly one configuration of the pose that ``start`` has; None: no proof.

    ``start`` (6,) is taken exactly as it is.

    Example:
        >>> from chainrule import load
        >>> puma, q = load("puma560"), np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
        >>> flipped = q + [0.0, 0.0, 0.0, np.pi, -1.0, -np.pi]
        >>> neighbour(puma, q, flipped) is None, neighbour(puma, q, flipped + 1e-4) is None
        (False, True)
    """
    from flint import arb, ctx

    code = run_path(str(compiling.find(arm.description.model, "kinematics").numpy_module))
    parameters = [exact(arm.parameters)] if arm.parameters.size else []

    def on_balls(name: str) -> Callable[[Array], Array]:
        return lambda q: exact(code[name](q, *parameters))

    pose, jacobian = on_balls("pose"), on_balls("jacobian_pose")
    with ctx.workprec(PRECISION):
        target, middle = pose(exact(start)), exact(goal)
        back = exact(_slopes(target, pose(middle), jacobian(middle), np.eye(6), invert=True))
        correction = back @ _residual(target, pose(middle))
        for radius in RADII:
            box = np.array([value + arb(0, radius) for value in middle], object)
            there = pose(box)
            slopes = _slopes(target, there, jacobian(box), np.eye(6), invert=False)
            spread = exact(np.eye(6)) - back @ slopes
            moved = -correction + spread @ (box - middle)
            inside = all(bool(abs(value) < arb(radius)) for value in moved)
            if inside and np.trace(there[:3, :3] @ target[:3, :3].T) > 0:
                return np.array([value + shift for value, shift in zip(middle, moved, strict=True)], object)
    return None


def _residual(target: Array, pose: Array) -> Array:
    """The six equations' left sides."""
    found: Array = np.concatenate([pose[:3, 3] - target[:3, 3], skew_part(pose[:3, :3] @ target[:3, :3].T)])
    return found


def _slopes(target: Array, pose: Array, jacobian: Array, identity: Array, *, invert: bool) -> Array:
    """The six equations' derivatives (6, 6) by the joints; with ``invert`` the inverse, in floats, of their middles.

    The angular column w of a joint means dR = w x R.
    """
    turned = pose[:3, :3] @ target[:3, :3].T
    columns = []
    for v, w in zip(jacobian[:3].T, jacobian[3:].T, strict=True):
        change = np.stack([np.array(_cross(w, column), object) for column in turned.T], axis=-1)
        columns.append(np.concatenate([v, skew_part(change)]))
    slopes = np.stack(columns, axis=-1)
    if not invert:
        return slopes
    middles = np.array([[float(value.mid()) for value in row] for row in slopes])
    try:
        return np.linalg.inv(middles)
    except np.linalg.LinAlgError:
        return identity


def _cross(a: Array, b: Array) -> tuple[Any, Any, Any]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
