"""How the tip is oriented along a path, by the path's parameter u from 0 to 1.

In space an orientation is a rotation matrix, and its rate the angular velocity in the base frame per unit of u; in the
plane it is the angle alpha.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import cross
from chainrule.redundancy.curves import SpaceCurve

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

Array = NDArray[Any]

#: A matrix this near to a rotation, and a quaternion this near to unit length, is one.
NEAR = 1e-6


class Turning(ABC):
    """An orientation along a path."""

    @abstractmethod
    def at(self, curve: SpaceCurve, u: Array) -> tuple[Array, Array]:
        """Orientations and their rates by u at u (k,): (k, 3, 3) and (k, 3), in the plane (k,) and (k,)."""


class Held(Turning):
    """One orientation all the way: a rotation (3, 3), or an angle."""

    def __init__(self, orientation: Array) -> None:
        self.orientation = orientation

    def at(self, curve: SpaceCurve, u: Array) -> tuple[Array, Array]:
        """As :meth:`Turning.at`."""
        shape = self.orientation.shape
        rate = np.zeros((len(u), 3) if shape else len(u))
        return np.broadcast_to(self.orientation, (len(u), *shape)).copy(), rate


class Between(Turning):
    """Orientations at given parameters and smoothly between them.

    Two rotations: the shortest way at a constant angular velocity (slerp); more: the cubic rotation spline through
    them, whose angular acceleration is continuous. Angles: one straight stretch, or the cubic spline.

    Args:
        parameters: (k,) rising from 0 to 1.
        orientations: (k, 3, 3), or angles (k,).
    """

    def __init__(self, parameters: Array, orientations: Array) -> None:
        self._angles: Any = None
        self._rotations: Any = None
        if orientations.ndim == 1:
            from scipy.interpolate import make_interp_spline

            self._angles = make_interp_spline(parameters, orientations, k=min(3, len(orientations) - 1))
        else:
            from scipy.spatial.transform import Rotation, RotationSpline

            self._rotations = RotationSpline(parameters, Rotation.from_matrix(orientations))

    def at(self, curve: SpaceCurve, u: Array) -> tuple[Array, Array]:
        """As :meth:`Turning.at`."""
        if self._angles is not None:
            return np.asarray(self._angles(u)), np.asarray(self._angles(u, 1))
        turned: Rotation = self._rotations(u)
        return turned.as_matrix(), turned.apply(self._rotations(u, 1))


class Tangent(Turning):
    """x along the path, z along the normal of its plane; in the plane, alpha is the tangent's angle."""

    def at(self, curve: SpaceCurve, u: Array) -> tuple[Array, Array]:
        """As :meth:`Turning.at`."""
        _, slope, bend = curve.at(u)
        speed = np.linalg.norm(slope, axis=1, keepdims=True)
        if not (speed > 0.0).all():
            raise InputError("orientation: 'tangent' is for a path that keeps moving")
        tangent = slope / speed
        if slope.shape[1] == 2:
            return np.unwrap(np.arctan2(tangent[:, 1], tangent[:, 0])), cross(tangent, bend / speed)
        if curve.normal is None:
            raise InputError("orientation: 'tangent' is for a path in a plane, such as an arc; a rotation is accepted")
        normal = np.broadcast_to(curve.normal, tangent.shape)
        return np.stack([tangent, np.cross(normal, tangent), normal], axis=2), np.cross(tangent, bend / speed)


def turning(given: Any, dimension: int) -> Turning | None:
    """What a caller means by an orientation; None for that of the start posture.

    Args:
        given: None; "tangent"; in space a rotation (3, 3) or unit quaternion (w, x, y, z), or k of them at even
            parameters, or a SciPy ``Rotation``; in the plane an angle in rad, or k of them.
        dimension: 3 or 2.

    Raises:
        InputError: anything else.
    """
    if given is None or isinstance(given, Turning):
        return given
    if isinstance(given, str):
        if given != "tangent":
            raise InputError(f"orientation: {shown(given)}; 'tangent', or orientations, are accepted")
        return Tangent()
    if dimension == 2:
        angles = real_array(given, "orientation")
        if angles.ndim == 0:
            return Held(angles)
        if angles.ndim != 1 or len(angles) < 2:
            raise InputError(f"orientation: shape {angles.shape}; an angle, or two or more, is accepted")
        return Between(np.linspace(0.0, 1.0, len(angles)), angles)
    found = rotations(given)
    if found.ndim == 2:
        return Held(found)
    if len(found) < 2:
        raise InputError("orientation: a list of one; one rotation, or two or more, is accepted")
    return Between(np.linspace(0.0, 1.0, len(found)), found)


def rotations(given: Any) -> Array:
    """Rotation matrices (..., 3, 3) of matrices, unit quaternions (..., 4) with w first, or a SciPy ``Rotation``.

    Raises:
        InputError: what is none of these, or further from a rotation than 1e-6.
    """
    from scipy.spatial.transform import Rotation

    if isinstance(given, Rotation):
        return np.asarray(given.as_matrix())
    array = real_array(given, "orientation")
    if array.shape[-2:] == (3, 3) and array.ndim <= 3:
        u, _, v = np.linalg.svd(array)
        nearest = u @ v
        off = float(np.abs(nearest - array).max(initial=0.0))
        if off > NEAR or (np.linalg.det(nearest) < 0.0).any():
            raise InputError(f"orientation: a matrix is off a rotation by {off:.3g} or mirrors; a rotation is accepted")
        return np.asarray(nearest)
    if array.shape[-1:] == (4,) and array.ndim <= 2:
        size = np.linalg.norm(array, axis=-1)
        if np.abs(size - 1.0).max(initial=0.0) > NEAR:
            raise InputError(f"orientation: {shown(array.tolist())}; quaternions (w, x, y, z) of length 1 are accepted")
        return np.asarray(Rotation.from_quat(np.roll(array, -1, axis=-1)).as_matrix())
    raise InputError(
        f"orientation: shape {array.shape}; a rotation (3, 3), a quaternion (w, x, y, z), or several are accepted"
    )
