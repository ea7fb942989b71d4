"""Task paths from files: a TOML table, or poses in a CSV file.

The TOML schema, one path to a file::

    task_path = 1                      # the version of the schema, required
    kind = "arc"                       # line, arc, circle, ellipse, polyline or spline
    angles = "deg"                     # or "rad"; required where an angle is given
    pace = "arc length"                # what the time counts; or "parameter": the angle of an ellipse, ...

    # points have three coordinates, or two for an arm in the plane
    # line:     start = [x, y, z]   end = [x, y, z]
    # arc:      centre = [x, y, z]  radius = m          may follow: start = angle, end = angle, x = [...], y = [...]
    # circle:   centre = [x, y, z]  radius = m          may follow: start = angle, x = [...], y = [...]
    # ellipse:  centre = [x, y, z]  semi_axes = [a, b]  may follow: start = angle, end = angle, x = [...], y = [...]
    # polyline: points = [[x, y, z], ...]  deviation = m
    # spline:   points = [[x, y, z], ...]               may follow: closed = true

    [time]                             # required: duration alone or speed alone for a constant speed,
    duration = 2.0                     # duration and ramp, or speed and acceleration, from rest to rest
    # speed = m/s   acceleration = m/s^2   ramp = s

    [orientation]                      # that of the start posture when absent; one of
    # quaternion = [w, x, y, z]        # held
    # quaternions = [[w, x, y, z], ...]  # passed at even shares of the way
    # rpy = [roll, pitch, yaw]         # held: fixed axes x, y, z in this order
    # alpha = angle                    # held, in the plane
    # alphas = [angle, ...]            # passed at even shares of the way, in the plane
    # tangent = true                   # x along the path

Lengths are in m, times in s. A key that is not in the schema is refused.

A CSV file has a first row of names: ``x,y,z`` or ``x,y``, then perhaps ``qw,qx,qy,qz`` or ``alpha`` (rad), and perhaps
``t`` (s) before them. Without names three numbers to a row are x,y,z and seven x,y,z,qw,qx,qy,qz.
"""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.description import check_finite
from chainrule.errors import DescriptionError, InputError, shown
from chainrule.readers.files import located, read_limited
from chainrule.readers.paths import cell
from chainrule.readers.toml import known, parsed, radians, required
from chainrule.redundancy.task_path import TaskPath

Array = NDArray[Any]

SCHEMA = 1
MAX_BYTES = 2**22

_KEYS = {
    "line": ("start", "end"),
    "arc": ("centre", "radius", "start", "end", "x", "y"),
    "circle": ("centre", "radius", "start", "x", "y"),
    "ellipse": ("centre", "semi_axes", "start", "end", "x", "y"),
    "polyline": ("points", "deviation"),
    "spline": ("points", "closed"),
}
_TOP = ("task_path", "kind", "angles", "pace", "time", "orientation")
_ORIENTATIONS = ("quaternion", "quaternions", "rpy", "alpha", "alphas", "tangent")
_TIME = ("duration", "speed", "acceleration", "ramp")

#: The rows of names that a CSV file may begin with, ``t`` aside, by the number of names.
_NAMES = (("x", "y"), ("x", "y", "alpha"), ("x", "y", "z"), ("x", "y", "z", "qw", "qx", "qy", "qz"))


def read_task_path(path: str | os.PathLike[str], **options: Any) -> TaskPath:
    """The task path described by a ``.toml`` file, or through the poses of a ``.csv`` file.

    Args:
        path: the file.
        options: time law (``duration=``, ``speed=``, ...) of a CSV file without times; orientation of one without
            orientations, as :class:`TaskPath` takes them. A TOML file says them itself.

    Raises:
        DescriptionError: one line with the file and the key, row or option that is wrong, and what is accepted.
    """
    if not isinstance(path, str | os.PathLike):
        raise DescriptionError(f"a task path is read from a .toml or .csv file, not from {shown(path)}")
    with located(path):
        suffix = os.path.splitext(os.fspath(path))[1].lower()
        if suffix not in (".toml", ".csv"):
            raise DescriptionError(f"a task path is read from a .toml or .csv file, not {shown(suffix)}")
        content = read_limited(path, MAX_BYTES)
        if suffix == ".csv":
            return from_csv(content, **options)
        if options:
            raise DescriptionError(f"option {shown(next(iter(options)))}: a .toml file says it itself")
        return from_toml(content)


def from_toml(content: bytes) -> TaskPath:
    r"""The task path of a TOML file's content; raises as :func:`read_task_path`, without the file's name.

    Example:
        >>> text = b'task_path = 1\nkind = "line"\nstart = [0, 0, 0]\nend = [1, 0, 0]\ntime.duration = 2'
        >>> from_toml(text).sample([1.0]).held
        array([[0.5, 0. , 0. ]])
    """
    table = parsed(content)
    if table.get("task_path") != SCHEMA or isinstance(table["task_path"], bool):
        said = shown(table["task_path"]) if "task_path" in table else "missing"
        raise DescriptionError(f"key 'task_path': {said}; the schema's version is accepted: task_path = {SCHEMA}")
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in _KEYS:
        said = shown(kind) if "kind" in table else "missing"
        raise DescriptionError(f"key 'kind': {said}; {', '.join(_KEYS)} are accepted")
    known(table, (*_TOP, *_KEYS[kind]), f"the {kind}")
    options = _time(table) | _orientation(table)
    if "pace" in table:
        options["pace"] = table["pace"]
    try:
        return _made(kind, table, options)
    except DescriptionError:
        raise
    except InputError as error:
        raise DescriptionError(f"the {kind}: {error}") from None


def _made(kind: str, table: Mapping[str, Any], options: dict[str, Any]) -> TaskPath:
    where = f"the {kind}"

    def point(key: str) -> list[float]:
        return _numbers(required(table, key, where), f"key '{key}'")

    def number(key: str) -> float:
        return check_finite(required(table, key, where), f"key '{key}'")

    for key in ("x", "y"):
        if key in table and key in _KEYS[kind]:
            options[key] = point(key)
    if kind == "line":
        return TaskPath.line(point("start"), point("end"), **options)
    if kind in ("arc", "circle", "ellipse"):
        options |= {key: _angle(table, table[key], key) for key in ("start", "end") if key in table}
        if kind == "ellipse":
            return TaskPath.ellipse(point("centre"), point("semi_axes"), **options)
        make = TaskPath.arc if kind == "arc" else TaskPath.circle
        return make(point("centre"), number("radius"), **options)
    points = _rows(required(table, "points", where), "points")
    if kind == "polyline":
        return TaskPath.polyline(points, number("deviation"), **options)
    closed = table.get("closed", False)
    if not isinstance(closed, bool):
        raise DescriptionError(f"key 'closed': {shown(closed)}; true or false is accepted")
    return TaskPath.spline(points, closed=closed, **options)


def _table(table: Mapping[str, Any], key: str, accepted: tuple[str, ...]) -> Mapping[str, Any]:
    found = table[key]
    if not isinstance(found, dict):
        raise DescriptionError(f"[{key}]: {shown(found)}; a table is accepted")
    known(found, accepted, f"[{key}]")
    return found


def _time(table: Mapping[str, Any]) -> dict[str, Any]:
    if "time" not in table:
        raise DescriptionError("[time] is missing; a duration, or a speed, ... is accepted in it")
    found = _table(table, "time", _TIME)
    return {key: check_finite(value, f"[time] {key}") for key, value in found.items()}


def _orientation(table: Mapping[str, Any]) -> dict[str, Any]:
    if "orientation" not in table:
        return {}
    found = _table(table, "orientation", _ORIENTATIONS)
    if len(found) != 1:
        raise DescriptionError(
            f"[orientation]: {len(found)} keys; exactly one of {', '.join(_ORIENTATIONS)} is accepted"
        )
    ((key, value),) = found.items()
    where = f"[orientation] {key}"
    if key == "tangent":
        if value is not True:
            raise DescriptionError(f"{where}: {shown(value)}; true is accepted")
        return {"orientation": "tangent"}
    if key == "quaternion":
        return {"orientation": _unit(_numbers(value, where, (4,)), where)}
    if key == "quaternions":
        return {"orientation": [_unit(row, where) for row in _rows(value, where, (4,))]}
    if key == "alpha":
        return {"orientation": _angle(table, value, where)}
    if key == "alphas":
        if not isinstance(value, list):
            raise DescriptionError(f"{where}: {shown(value)}; a list of angles is accepted")
        return {"orientation": [_angle(table, entry, f"{where}, entry {i}") for i, entry in enumerate(value, 1)]}
    from scipy.spatial.transform import Rotation

    angles = [_angle(table, entry, where) for entry in _numbers(value, where, (3,))]
    return {"orientation": Rotation.from_euler("xyz", angles).as_matrix()}


def _unit(quaternion: list[float], where: str) -> list[float]:
    """A quaternion of length 1, as near to it as a file with a few digits has it."""
    size = math.hypot(*quaternion)
    if abs(size - 1.0) > 1e-3:
        raise DescriptionError(
            f"{where}: {shown(quaternion)} has length {size:.6g}; a quaternion of length 1 is accepted"
        )
    return [entry / size for entry in quaternion]


def _numbers(value: Any, what: str, counts: tuple[int, ...] = (2, 3)) -> list[float]:
    if not isinstance(value, list) or len(value) not in counts:
        wanted = " or ".join(map(str, counts))
        raise DescriptionError(f"{what}: {shown(value)}; a list of {wanted} numbers is accepted")
    return [check_finite(entry, f"{what}, entry {i}") for i, entry in enumerate(value, 1)]


def _rows(value: Any, what: str, counts: tuple[int, ...] = (2, 3)) -> list[list[float]]:
    what = f"key '{what}'" if what == "points" else what
    if not isinstance(value, list) or not value:
        raise DescriptionError(f"{what}: {shown(value)}; a list of rows is accepted")
    rows = [_numbers(row, f"{what}, row {i}", counts) for i, row in enumerate(value, 1)]
    for i, row in enumerate(rows, 1):
        if len(row) != len(rows[0]):
            raise DescriptionError(f"{what}, row {i}: {len(row)} numbers; {len(rows[0])} as in row 1 are accepted")
    return rows


def _angle(table: Mapping[str, Any], value: Any, key: str) -> float:
    unit = table.get("angles")
    if unit not in ("deg", "rad"):
        said = shown(unit) if "angles" in table else "missing"
        raise DescriptionError(f"key 'angles': {said}; 'deg' or 'rad' is accepted, the unit of '{key}'")
    found = check_finite(value, key if key.startswith("[") else f"key '{key}'")
    return radians(found) if unit == "deg" else found


# ---- poses in CSV ------------------------------------------------------------------------------------------------


def from_csv(content: bytes, **options: Any) -> TaskPath:
    r"""The task path through the poses of a CSV file's content; raises as :func:`read_task_path`.

    Example:
        >>> from_csv(b"t,x,y\n0,0,0\n1,0.5,0.1\n2,1,0\n").duration
        2.0
    """
    names, numbers, rows = _csv(content)
    columns = dict(zip(names, numbers.T, strict=True))
    points = np.stack([columns[name] for name in ("x", "y", "z") if name in columns], axis=1)
    turned: Any = columns.get("alpha")
    if "qw" in columns:
        turned = np.stack([columns[name] for name in ("qw", "qx", "qy", "qz")], axis=1)
        turned = np.array([_unit(row, f"row {i}") for i, row in zip(rows, turned.tolist(), strict=True)])
    if "t" not in columns:
        if not options:
            raise DescriptionError("no times; a column t, or a duration, speed, ... beside the file, is accepted")
        try:
            return TaskPath.poses(points, turned, **options)
        except InputError as error:
            raise DescriptionError(str(error)) from None
    if options:
        raise DescriptionError(f"option {shown(next(iter(options)))}: the file has times of its own")
    falls = np.flatnonzero(np.diff(columns["t"]) <= 0.0)
    if columns["t"][0] != 0.0 or len(falls):
        row = rows[0] if columns["t"][0] != 0.0 else rows[falls[0] + 1]
        raise DescriptionError(f"row {row}, t: times that rise from 0 are accepted")
    return TaskPath.samples(columns["t"], points, turned)


def _csv(content: bytes) -> tuple[tuple[str, ...], Array, list[int]]:
    """Names of the columns, the numbers (k, c), and the row of the file that each is from."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        row = content.count(b"\n", 0, error.start) + 1
        raise DescriptionError(f"row {row}: not UTF-8 text") from None
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    names: tuple[str, ...] = ()
    numbers: list[list[float]] = []
    rows: list[int] = []
    try:
        for cells in reader:
            entries = [entry.strip() for entry in cells]
            if not any(entries):
                continue
            if not names:
                names, titled = _named(entries, reader.line_num)
                if titled:
                    continue
            if len(entries) != len(names):
                raise DescriptionError(
                    f"row {reader.line_num}: {len(entries)} entries; {len(names)} ({','.join(names)}) are accepted"
                )
            numbers.append([cell(e, f"row {reader.line_num}, {n}") for e, n in zip(entries, names, strict=True)])
            rows.append(reader.line_num)
    except csv.Error as error:
        raise DescriptionError(f"row {reader.line_num}: not CSV that is accepted ({error})") from None
    if len(numbers) < 2:
        raise DescriptionError(f"{len(numbers)} poses; at least two rows are accepted")
    return names, np.array(numbers), rows


def _named(entries: list[str], row: int) -> tuple[tuple[str, ...], bool]:
    """The columns' names, and whether the row holds them."""
    names = tuple(entry.lower() for entry in entries)
    if (names[1:] in _NAMES and names[0] == "t") or names in _NAMES:
        return names, True
    if names[0].isalpha():
        accepted = "; ".join(",".join(each) for each in _NAMES)
        raise DescriptionError(f"row {row}: {shown(','.join(entries))}; {accepted} are accepted, with t before or not")
    for each in (_NAMES[2], _NAMES[3], _NAMES[0]):
        if len(each) == len(entries):
            return each, False
    raise DescriptionError(f"row {row}: {len(entries)} entries and no names; x,y,z or x,y,z,qw,qx,qy,qz is accepted")
