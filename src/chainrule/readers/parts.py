"""What every reader needs: joints by kind and name, rotations from three angles, transforms from whatever was given."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from chainrule.description import Joint, JointKind, Matrix3, Transform, check_finite
from chainrule.errors import DescriptionError, shown

_KINDS: dict[str, JointKind] = {"R": "R", "P": "P", "revolute": "R", "prismatic": "P"}

# A rotation given in numbers may be rounded, but not wrong: a 4 x 4 typed with seven digits passes.
_ORTHONORMAL = 1e-6


#: rad, a little more than 2 pi. A constant angle beyond it, if it is not so many quarter turns, was meant in degrees.
FULL_TURN = 6.3


def constant_angle(value: Any, what: str) -> float:
    """A constant angle of a description, in rad; :class:`DescriptionError` where it is more than a full turn.

    >>> constant_angle(90, "row 2, column 'alpha'")
    Traceback (most recent call last):
        ...
    chainrule.errors.DescriptionError: row 2, column 'alpha': 90 rad is more than a full turn; rad are accepted, and \
degrees in a TOML file that says angles = "deg"
    """
    angle = check_finite(value, what)
    if abs(angle) > FULL_TURN and angle != round(angle / (math.pi / 2)) * (math.pi / 2):
        raise DescriptionError(
            f"{what}: {angle:g} rad is more than a full turn; rad are accepted, and degrees in a TOML file that says "
            'angles = "deg"'
        )
    return angle


def as_transform(value: Any, what: str) -> Transform:
    """A :class:`Transform` from one, a 4 x 4 (rows), a translation (3,) in m, or None for no displacement.

    Raises:
        DescriptionError: if it is none of these, an entry is not finite, the rotation is not orthonormal and
            right-handed to 1e-6 (rounded numbers are made orthonormal), or the last row is not (0, 0, 0, 1).
    """
    if value is None:
        return Transform()
    if isinstance(value, Transform):
        value = [[*row, x] for row, x in zip(value.rotation, value.translation, strict=True)] + [[0, 0, 0, 1]]
    try:
        entries = [list(row) if hasattr(row, "__len__") and not isinstance(row, str) else row for row in value]
    except TypeError:
        entries = []
    if len(entries) == 3 and not any(isinstance(entry, list) for entry in entries):
        x, y, z = (check_finite(entry, f"{what}, entry {i}") for i, entry in enumerate(entries, 1))
        return Transform.shift(x, y, z)
    if len(entries) != 4 or any(not isinstance(row, list) or len(row) != 4 for row in entries):
        raise DescriptionError(f"{what}: {shown(value)}; a 4 x 4 matrix or a translation of 3 numbers is accepted")
    matrix = [
        [check_finite(entry, f"{what}, row {i}, column {j}") for j, entry in enumerate(row, 1)]
        for i, row in enumerate(entries, 1)
    ]
    if matrix[3] != [0.0, 0.0, 0.0, 1.0]:
        raise DescriptionError(f"{what}, row 4: {matrix[3]}; (0, 0, 0, 1) is accepted")
    return Transform(_rotation([row[:3] for row in matrix[:3]], what), (matrix[0][3], matrix[1][3], matrix[2][3]))


def rotation_rpy(roll: float, pitch: float, yaw: float) -> Transform:
    """Rz(yaw) Ry(pitch) Rx(roll), angles in rad about the fixed axes, as URDF has it.

    >>> from math import pi
    >>> rotation_rpy(0, 0, pi / 2).rotation
    ((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    """
    return Transform.rot_z(yaw) @ Transform.rot_y(pitch) @ Transform.rot_x(roll)


def joint_kind(value: Any, what: str) -> JointKind:
    """'R' or 'P' from "R", "P", "revolute" or "prismatic"; :class:`DescriptionError` otherwise."""
    kind = _KINDS.get(value) if isinstance(value, str) else None
    if kind is None:
        raise DescriptionError(f"{what}: {shown(value)}; 'R', 'P', 'revolute' or 'prismatic' is accepted")
    return kind


def named_joints(kinds: Sequence[JointKind], names: Sequence[str] | None) -> tuple[Joint, ...]:
    """Joints without limits; "joint1", "joint2" and so on when ``names`` is None."""
    listed = [f"joint{i}" for i in range(1, len(kinds) + 1)] if names is None else list(names)
    if len(listed) != len(kinds):
        raise DescriptionError(f"joint_names: {len(listed)} names for {len(kinds)} joints")
    return tuple(Joint(name, kind) for name, kind in zip(listed, kinds, strict=True))


def _rotation(given: list[list[float]], what: str) -> Matrix3:
    """The rotation that ``given`` is to rounding: itself when orthonormal to 1e-15, else the nearest one."""
    error = _departure(given)
    (a, b, c), (d, e, f), (g, h, i) = given
    volume = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    if not error <= _ORTHONORMAL or volume < 0.0:
        why = f"columns off by {error:.2g}" if not error <= _ORTHONORMAL else "left-handed"
        raise DescriptionError(f"{what}: its 3 x 3 part is not a rotation ({why}; orthonormal to 1e-6 is accepted)")
    rotation = given
    for _ in range(2):  # Newton's iteration for the polar factor, R (3 I - R^T R) / 2: 1e-6 becomes 1e-12, then 1e-24
        if error > 1e-15:
            gram = [[math.fsum(row[j] * row[k] for row in rotation) for k in range(3)] for j in range(3)]
            step = [[(3.0 * (j == k) - gram[j][k]) / 2.0 for k in range(3)] for j in range(3)]
            rotation = [[math.fsum(row[j] * step[j][k] for j in range(3)) for k in range(3)] for row in rotation]
    return tuple((row[0], row[1], row[2]) for row in rotation)  # type: ignore[return-value]  # three rows


def _departure(rotation: list[list[float]]) -> float:
    """The largest entry of |R^T R - I|."""
    return max(abs(math.fsum(row[j] * row[k] for row in rotation) - (j == k)) for j in range(3) for k in range(j, 3))
