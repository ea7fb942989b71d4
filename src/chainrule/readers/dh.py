"""Arms from Denavit-Hartenberg tables, modified (Craig) or standard, in radians and metres."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Literal

from chainrule.description import (
    MAX_JOINTS,
    Description,
    DHRow,
    Inertia,
    Serial,
    Transform,
    check_finite,
    with_limits,
)
from chainrule.errors import DescriptionError, shown
from chainrule.readers.parts import as_transform, constant_angle, joint_kind, named_joints

#: The columns of a row, in order.
COLUMNS = ("kind", "alpha", "a", "d", "theta")

Convention = Literal["modified", "standard"]


def from_dh(
    rows: Iterable[Sequence[Any]],
    *,
    convention: Convention = "modified",
    tool: Any = None,
    name: str = "arm",
    joint_names: Sequence[str] | None = None,
    position: Sequence[Sequence[float] | None] | None = None,
    velocity: Sequence[float | None] | None = None,
    acceleration: Sequence[float | None] | None = None,
    torque: Sequence[float | None] | None = None,
    inertias: Sequence[Inertia | None] | None = None,
    source: str = "",
) -> Description:
    """The arm of a Denavit-Hartenberg table.

    A row is (kind, alpha, a, d, theta): kind "R" or "revolute", "P" or "prismatic"; angles in rad, lengths in m.
    Angles of more than a full turn are refused, because they were meant in degrees.
    With the joint variable q_i added to theta (R) or d (P), link i's frame is placed in link i-1's by

    * modified (Craig): Rx(alpha) Tx(a) Rz(theta) Tz(d), where alpha and a belong to the link before the joint;
    * standard: Rz(theta) Tz(d) Tx(a) Rx(alpha), where they belong to the link after it.

    The standard table becomes fixed placements before each joint, and its last Tx(a) Rx(alpha) a part of the tool,
    so joint i always moves about or along the z axis of its own frame. Quarter turns are exact: an alpha of
    ``math.pi / 2`` has the cosine 0.0.

    Args:
        rows: n rows of five entries, 1 to 256 of them.
        convention: "modified" or "standard".
        tool: the tool in the last link's frame: a 4 x 4, a :class:`Transform`, a translation (3,) in m, or None.
        name: the arm's name (letters, digits, ``_ - .``).
        joint_names: n names; "joint1", "joint2" and so on when absent.
        position: (n, 2) limits (lower, upper) in rad or m; None where there is none. The limits below are (n,).
        velocity: rad/s or m/s.
        acceleration: rad/s^2 or m/s^2.
        torque: N m or N.
        inertias: n link inertias or None each, in the joint's own moved frame (the link frame of the modified table).
        source: where the numbers come from.

    Raises:
        DescriptionError: naming the row (from 1) and column of a wrong entry, or the wrong argument.

    Example:
        >>> from math import pi
        >>> arm = from_dh([("R", 0, 0, 0.3, 0), ("R", -pi / 2, 0, 0, 0), ("P", pi / 2, 0, 0.1, 0)], name="RRP")
        >>> arm.kinds, arm.geometry.placements[1].rotation[1]
        ('RRP', (0.0, 0.0, 1.0))
    """
    if convention not in ("modified", "standard"):
        raise DescriptionError(f"convention {shown(convention)}; 'modified' or 'standard' is accepted")
    table = tuple(_row(row, i) for i, row in enumerate(_listed(rows), 1))
    placements, last = _placements(table, convention)
    description = Description(
        name=name,
        joints=named_joints([row.kind for row in table], joint_names),
        geometry=Serial(placements, last @ as_transform(tool, "tool"), table, convention),
        inertias=() if inertias is None else tuple(inertias),
        source=source,
    )
    return with_limits(description, position=position, velocity=velocity, acceleration=acceleration, torque=torque)


def _listed(rows: Iterable[Sequence[Any]]) -> list[Sequence[Any]]:
    try:
        listed = list(rows)
    except TypeError:
        raise DescriptionError(f"rows: {shown(rows)} is not a sequence of rows {COLUMNS}") from None
    if not 1 <= len(listed) <= MAX_JOINTS:
        raise DescriptionError(f"{len(listed)} rows; between 1 and {MAX_JOINTS} are accepted")
    return listed


def _row(row: Sequence[Any], number: int) -> DHRow:
    if isinstance(row, (str, bytes)) or not hasattr(row, "__len__") or len(row) != len(COLUMNS):
        raise DescriptionError(f"row {number}: {shown(row)}; five entries ({', '.join(COLUMNS)}) are accepted")
    kind, *numbers = row
    alpha, a, d, theta = (
        (constant_angle if column in ("alpha", "theta") else check_finite)(value, f"row {number}, column '{column}'")
        for column, value in zip(COLUMNS[1:], numbers, strict=True)
    )
    return DHRow(joint_kind(kind, f"row {number}, column 'kind'"), alpha, a, d, theta)


def _placements(table: tuple[DHRow, ...], convention: Convention) -> tuple[tuple[Transform, ...], Transform]:
    """The fixed transform before each joint, and what is left after the last one."""
    across = [Transform.rot_x(row.alpha) @ Transform.shift(row.a, 0.0, 0.0) for row in table]
    along = [Transform.rot_z(row.theta) @ Transform.shift(0.0, 0.0, row.d) for row in table]
    before, after = (across, Transform()) if convention == "modified" else ([Transform(), *across[:-1]], across[-1])
    return tuple(x @ z for x, z in zip(before, along, strict=True)), after
