"""Arms from TOML files, schema 1.

The whole schema::

    chainrule = 1                      # the version of the schema, required
    name = "my_arm"                    # letters, digits, _ - . ; required
    source = "where the numbers come from"
    angles = "deg"                     # or "rad"; required: the unit of every angle in the file
    limit_angles = "rad"               # the unit of the revolute joints' limits, where it is another one

    # Exactly one geometry: dh, planar or orthogonal_3r.
    [dh]
    convention = "modified"            # or "standard"
    rows = [                           # one per joint; kind "R" or "P"; a and d in m; all five required
        {kind = "R", alpha = 0, a = 0, d = 0.333, theta = 0},
    ]

    [planar]
    kinds = "RPR"
    lengths = [1.0, 0.5, 0.25]         # m
    headings = [0, 30, 0]              # constant turns of the prismatic joints; may be left out when all are 0

    [orthogonal_3r]
    d2 = 1.0                           # m, all four required
    d3 = 2.0
    d4 = 1.5
    r2 = 1.0

    [tool]                             # only with dh; in the last link's frame; either
    xyz = [0, 0, 0.107]                # m, and
    rpy = [0, 0, 0]                    # Rz(yaw) Ry(pitch) Rx(roll); each may be left out; or
    matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.107], [0, 0, 0, 1]]

    [[joints]]                         # none, or one per joint in order; every key may be left out
    name = "shoulder"
    position = [-170, 170]             # lower and upper; inf where one side has no limit
    velocity = 85                      # per s
    acceleration = 300                 # per s^2
    torque = 320                       # N m, or N for a prismatic joint

    [joints.inertia]                   # of the link that the joint moves, in the joint's own moved frame (for planar
                                       # arms see chainrule.description.Inertia)
    mass = 3.0                         # kg
    centre = [0, 0, 0.1]               # m
    ixx = 0.01                         # kg m^2 about the centre; all six required
    ixy = 0
    ixz = 0
    iyy = 0.01
    iyz = 0
    izz = 0.02

A limit that is left out does not exist. The limits of a prismatic joint are in m, m/s, m/s^2. Whole quarter turns in
degrees are exact. A key that is not in the schema is refused, so a misspelt one is never silently ignored.
"""

from __future__ import annotations

import math
import os
import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from chainrule.description import (
    Description,
    Inertia,
    JointKind,
    Matrix3,
    Transform,
    Vector3,
    check_finite,
    with_limits,
)
from chainrule.errors import DescriptionError, shown
from chainrule.readers.dh import COLUMNS, from_dh
from chainrule.readers.families import orthogonal_3r, planar
from chainrule.readers.files import located, read_limited
from chainrule.readers.parts import as_transform, rotation_rpy

SCHEMA = 1

#: Larger files are refused; 256 joints with everything said about them take half of this.
MAX_BYTES = 256 * 2**10

# The time to parse a dotted key grows with the square of its parts. The schema has two at most, and prose has few words
# between dots without a space, so files with more than a few such words are refused before they are parsed.
_BETWEEN_DOTS = re.compile(r"""\.[ \t]*(?:[\w-]+|"(?:[^"\\\n]|\\.)*"|'[^'\n]*')[ \t]*(?=\.)""")
_MOST_BETWEEN_DOTS = 200

_TOP = ("chainrule", "name", "source", "angles", "limit_angles", "dh", "planar", "orthogonal_3r", "tool", "joints")
_LENGTHS = ("d2", "d3", "d4", "r2")
_LIMITS = ("position", "velocity", "acceleration", "torque")
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def read_toml(path: str | os.PathLike[str]) -> Description:
    """The arm described by a TOML file (the schema is this module's docstring).

    Raises:
        DescriptionError: one line with the file and the key, row or joint that is wrong, and what is accepted.
    """
    with located(path):
        return from_toml(read_limited(path, MAX_BYTES))


def from_toml(content: bytes) -> Description:
    r"""The arm described by the content of a TOML file; raises as :func:`read_toml`, without the file's name.

    Example:
        >>> from_toml(b'chainrule = 1\nname = "a"\nangles = "deg"\n[planar]\nkinds = "RR"\nlengths = [1, 2]').kinds
        'RR'
    """
    table = parsed(content)
    if table.get("chainrule") != SCHEMA or isinstance(table["chainrule"], bool):
        said = shown(table["chainrule"]) if "chainrule" in table else "missing"
        raise DescriptionError(f"key 'chainrule': {said}; the schema's version is accepted: chainrule = {SCHEMA}")
    known(table, _TOP, "the file")
    angle = _unit(table, "angles")
    limit_angle = _unit(table, "limit_angles") if "limit_angles" in table else angle
    description = _arm(table, angle)
    joints = _joints(table, description.n)
    if any("inertia" in joint for joint in joints):
        description = replace(description, inertias=tuple(_inertia(joint, i) for i, joint in enumerate(joints, 1)))
    return with_limits(description, **_limits(joints, description.kinds, limit_angle))


def radians(degrees: float) -> float:
    """An angle in rad; whole quarter turns give exactly k * (pi / 2), whose cosine and sine are then exact.

    >>> radians(270) == 3 * (math.pi / 2)
    True
    """
    return (degrees / 90.0) * (math.pi / 2) if degrees % 90.0 == 0.0 else math.radians(degrees)


def parsed(content: bytes) -> dict[str, Any]:
    """The tables of a TOML file."""
    try:
        text = content.decode("utf-8-sig")
        if sum(1 for _ in _BETWEEN_DOTS.finditer(text)) > _MOST_BETWEEN_DOTS:
            raise DescriptionError("not TOML that is accepted: dotted keys nested too deeply")
        return tomllib.loads(text)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise DescriptionError(f"line {line}: not UTF-8 text") from None
    except tomllib.TOMLDecodeError as error:
        raise DescriptionError(f"not TOML: {' '.join(str(error).split())}") from None
    except DescriptionError:
        raise
    except (RecursionError, ValueError) as error:  # ValueError: an integer of thousands of digits
        what = "nested too deeply" if isinstance(error, RecursionError) else "a number too long to read"
        raise DescriptionError(f"not TOML that is accepted: {what}") from None


class _Angle:
    """Converts the file's angles to rad."""

    def __init__(self, degrees: bool) -> None:
        self.degrees = degrees

    def __call__(self, value: Any, what: str) -> float:
        number = check_finite(value, what)
        return radians(number) if self.degrees else number


def _unit(table: Mapping[str, Any], key: str) -> _Angle:
    value = table.get(key)
    if value not in ("deg", "rad"):
        said = f"{shown(value)}; " if key in table else "missing; "
        raise DescriptionError(f"key '{key}': {said}'deg' or 'rad' is accepted")
    return _Angle(value == "deg")


def _arm(table: Mapping[str, Any], angle: _Angle) -> Description:
    given = [key for key in ("dh", "planar", "orthogonal_3r") if key in table]
    if len(given) != 1:
        found = f"both [{given[0]}] and [{given[1]}]" if given else "no geometry"
        raise DescriptionError(f"{found}; exactly one of [dh], [planar] and [orthogonal_3r] is accepted")
    name, source = _text(table, "name"), _text(table, "source", "")
    geometry = _table(table[given[0]], f"[{given[0]}]")
    names = _names(table)
    if given[0] == "dh":
        return _dh(geometry, _tool(table, angle), angle, name, names, source)
    if "tool" in table:
        raise DescriptionError(f"[tool]: accepted with [dh] only; the last length of [{given[0]}] ends at the tip")
    if given[0] == "planar":
        known(geometry, ("kinds", "lengths", "headings"), "[planar]")
        lengths = _list(required(geometry, "lengths", "[planar]"), "[planar] lengths")
        headings = geometry.get("headings")
        if headings is not None:
            listed = enumerate(_list(headings, "[planar] headings"), 1)
            headings = [angle(heading, f"[planar] headings, joint {i}") for i, heading in listed]
        kinds = _text(geometry, "kinds", where="[planar] ")
        return planar(kinds, lengths, headings, name=name, joint_names=names, source=source)
    known(geometry, _LENGTHS, "[orthogonal_3r]")
    d2, d3, d4, r2 = (required(geometry, key, "[orthogonal_3r]") for key in _LENGTHS)
    return orthogonal_3r(d2, d3, d4, r2, name=name, joint_names=names, source=source)


def _dh(
    table: Mapping[str, Any], tool: Transform, angle: _Angle, name: str, names: list[str] | None, source: str
) -> Description:
    known(table, ("convention", "rows"), "[dh]")
    rows = []
    for i, entry in enumerate(_list(required(table, "rows", "[dh]"), "[dh] rows"), 1):
        where = f"[dh] row {i}"
        row = _table(entry, where)
        known(row, COLUMNS, where)
        kind, alpha, a, d, theta = (required(row, column, where) for column in COLUMNS)
        rows.append((kind, angle(alpha, f"{where}, column 'alpha'"), a, d, angle(theta, f"{where}, column 'theta'")))
    convention = required(table, "convention", "[dh]")
    return from_dh(rows, convention=convention, tool=tool, name=name, joint_names=names, source=source)


def _tool(table: Mapping[str, Any], angle: _Angle) -> Transform:
    if "tool" not in table:
        return Transform()
    tool = _table(table["tool"], "[tool]")
    if "matrix" in tool:
        if len(tool) > 1:
            raise DescriptionError("[tool]: either matrix or xyz and rpy is accepted, not both")
        matrix = as_transform(_list(tool["matrix"], "[tool] matrix"), "[tool] matrix")
        return matrix
    known(tool, ("xyz", "rpy", "matrix"), "[tool]")
    x, y, z = _vector(tool.get("xyz", (0, 0, 0)), "[tool] xyz")
    roll, pitch, yaw = (angle(value, "[tool] rpy") for value in _vector(tool.get("rpy", (0, 0, 0)), "[tool] rpy"))
    return Transform.shift(x, y, z) @ rotation_rpy(roll, pitch, yaw)


def _names(table: Mapping[str, Any]) -> list[str] | None:
    joints = table.get("joints")
    if not isinstance(joints, list) or not any(isinstance(joint, dict) and "name" in joint for joint in joints):
        return None
    return [
        joint.get("name", f"joint{i}") if isinstance(joint, dict) else f"joint{i}" for i, joint in enumerate(joints, 1)
    ]


def _joints(table: Mapping[str, Any], n: int) -> list[Mapping[str, Any]]:
    """The [[joints]] tables, checked for unknown keys; n empty ones where the file has none."""
    if "joints" not in table:
        return [{}] * n
    joints = [_table(joint, f"joint {i}") for i, joint in enumerate(_list(table["joints"], "[[joints]]"), 1)]
    if len(joints) != n:
        raise DescriptionError(f"[[joints]]: {len(joints)} tables for {n} joints; none, or one per joint, is accepted")
    for i, joint in enumerate(joints, 1):
        known(joint, ("name", *_LIMITS, "inertia"), f"joint {i}")
    return joints


def _limits(joints: list[Mapping[str, Any]], kinds: str, angle: _Angle) -> dict[str, list[Any]]:
    limits: dict[str, list[Any]] = {what: [] for what in _LIMITS}
    for i, (joint, kind) in enumerate(zip(joints, kinds, strict=True), 1):
        for what in _LIMITS:
            value = joint.get(what)
            where = f"joint {i}, {what}"
            if what == "position" and value is not None:
                value = [_position(bound, kind, angle, where) for bound in _list(value, where)]
            elif what in ("velocity", "acceleration") and value is not None and kind == "R":
                value = angle(value, where)
            elif value is not None:
                value = check_finite(value, where)
            limits[what].append(value)
    return limits


def _position(bound: Any, kind: str | JointKind, angle: _Angle, where: str) -> float:
    if isinstance(bound, float) and math.isinf(bound):
        return bound
    return angle(bound, where) if kind == "R" else check_finite(bound, where)


def _inertia(joint: Mapping[str, Any], number: int) -> Inertia | None:
    if "inertia" not in joint:
        return None
    where = f"joint {number}, inertia"
    table = _table(joint["inertia"], where)
    known(table, ("mass", "centre", *_TENSOR), where)
    xx, xy, xz, yy, yz, zz = (check_finite(required(table, key, where), f"{where}, {key}") for key in _TENSOR)
    tensor: Matrix3 = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    mass = check_finite(required(table, "mass", where), f"{where}, mass")
    return Inertia(mass, _vector(required(table, "centre", where), f"{where}, centre"), tensor)


def known(table: Mapping[str, Any], accepted: Iterable[str], where: str) -> None:
    """Refuse keys that are not among the accepted ones."""
    for key in table:
        if key not in accepted:
            raise DescriptionError(f"{where}: unknown key {shown(key)}; accepted are {', '.join(accepted)}")


def required(table: Mapping[str, Any], key: str, where: str) -> Any:
    """The value of a key that must be there."""
    if key not in table:
        raise DescriptionError(f"{where}: the key '{key}' is missing")
    return table[key]


def _table(value: Any, where: str) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise DescriptionError(f"{where}: {shown(value)}; a table is accepted")
    return value


def _list(value: Any, where: str) -> list[Any]:
    if not isinstance(value, list):
        raise DescriptionError(f"{where}: {shown(value)}; a list is accepted")
    return value


def _text(table: Mapping[str, Any], key: str, default: str | None = None, where: str = "") -> str:
    value = table.get(key, default)
    if not isinstance(value, str):
        raise DescriptionError(f"{where}key '{key}': {shown(value) if key in table else 'missing'}; a text is accepted")
    return value


def _vector(value: Any, where: str) -> Vector3:
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise DescriptionError(f"{where}: {shown(value)}; three numbers are accepted")
    x, y, z = (check_finite(entry, f"{where}, entry {i}") for i, entry in enumerate(value, 1))
    return (x, y, z)
