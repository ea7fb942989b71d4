"""Paths from files: a TOML table or points in a CSV file.

The TOML schema, one path to a file::

    path = 1                           # the version of the schema, required
    kind = "ellipse"                   # line, arc, circle, ellipse or spline
    angles = "deg"                     # or "rad"; required where the path has an angle

    # line:    start = [x, y]   end = [x, y]
    # arc:     start = [x, y]   tangent = [x, y]   curvature = 1/m, left positive   length = m
    # circle:  centre = [x, y]  radius = m             may follow: start = angle, clockwise = true
    # ellipse: centre = [x, y]  semi_axes = [a, b]     may follow: rotation = angle, start = angle, clockwise = true
    # spline:  points = [[x, y], ...]                  may follow: closed = true

Lengths are in m. A key that is not in the schema is refused.

A CSV file holds the points of a spline, two numbers x,y in m to a row, after a first row ``x,y`` or without one. The
spline is closed where the last point is the first.
"""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Mapping
from typing import Any

from chainrule.description import check_finite
from chainrule.errors import DescriptionError, InputError, shown
from chainrule.parametric_paths import Ellipse, Spline
from chainrule.paths import Arc, Circle, Line, Path
from chainrule.readers.files import located, read_limited
from chainrule.readers.toml import known, parsed, radians, required

SCHEMA = 1
MAX_BYTES = 2**20

_KEYS = {
    "line": ("start", "end"),
    "arc": ("start", "tangent", "curvature", "length"),
    "circle": ("centre", "radius", "start", "clockwise"),
    "ellipse": ("centre", "semi_axes", "rotation", "start", "clockwise"),
    "spline": ("points", "closed"),
}
_ANGLES = ("rotation", "start")


def read_path(path: str | os.PathLike[str]) -> Path:
    """The path described by a ``.toml`` file, or through the points of a ``.csv`` file.

    Raises:
        DescriptionError: one line with the file and the key or row that is wrong, and what is accepted.
    """
    if not isinstance(path, str | os.PathLike):
        raise DescriptionError(f"a path is read from a .toml or .csv file, not from {shown(path)}")
    with located(path):
        suffix = os.path.splitext(os.fspath(path))[1].lower()
        if suffix not in (".toml", ".csv"):
            raise DescriptionError(f"a path is read from a .toml or .csv file, not {shown(suffix)}")
        content = read_limited(path, MAX_BYTES)
        return from_toml(content) if suffix == ".toml" else from_csv(content)


def from_toml(content: bytes) -> Path:
    r"""The path described by the content of a TOML file; raises as :func:`read_path`, without the file's name.

    Example:
        >>> from_toml(b'path = 1\nkind = "circle"\ncentre = [1, 0]\nradius = 0.5').closed
        True
    """
    table = parsed(content)
    if table.get("path") != SCHEMA or isinstance(table["path"], bool):
        said = shown(table["path"]) if "path" in table else "missing"
        raise DescriptionError(f"key 'path': {said}; the schema's version is accepted: path = {SCHEMA}")
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in _KEYS:
        said = shown(kind) if "kind" in table else "missing"
        raise DescriptionError(f"key 'kind': {said}; {', '.join(_KEYS)} are accepted")
    known(table, ("path", "kind", "angles", *_KEYS[kind]), f"the {kind}")
    try:
        return _made(kind, table)
    except DescriptionError:
        raise
    except InputError as error:
        raise DescriptionError(f"the {kind}: {error}") from None


def _made(kind: str, table: Mapping[str, Any]) -> Path:
    def pair(key: str) -> list[float]:
        return _numbers(required(table, key, f"the {kind}"), f"key '{key}'", 2)

    def number(key: str) -> float:
        return check_finite(required(table, key, f"the {kind}"), f"key '{key}'")

    if kind == "line":
        return Line(pair("start"), pair("end"))
    if kind == "arc":
        return Arc(pair("start"), pair("tangent"), number("curvature"), number("length"))
    if kind == "circle":
        return Circle(
            pair("centre"), number("radius"), start=_angle(table, "start"), clockwise=_flag(table, "clockwise")
        )
    if kind == "ellipse":
        return Ellipse(
            pair("centre"),
            pair("semi_axes"),
            rotation=_angle(table, "rotation"),
            start=_angle(table, "start"),
            clockwise=_flag(table, "clockwise"),
        )
    rows = required(table, "points", "the spline")
    if not isinstance(rows, list):
        raise DescriptionError(f"key 'points': {shown(rows)}; a list of points [x, y] is accepted")
    points = [_numbers(row, f"key 'points', point {i}", 2) for i, row in enumerate(rows, 1)]
    return Spline(points, closed=_flag(table, "closed"))


def _numbers(value: Any, what: str, count: int) -> list[float]:
    if not isinstance(value, list) or len(value) != count:
        raise DescriptionError(f"{what}: {shown(value)}; a list of {count} numbers is accepted")
    return [check_finite(entry, f"{what}, entry {i}") for i, entry in enumerate(value, 1)]


def _angle(table: Mapping[str, Any], key: str) -> float:
    if key not in table:
        return 0.0
    unit = table.get("angles")
    if unit not in ("deg", "rad"):
        said = shown(unit) if "angles" in table else "missing"
        raise DescriptionError(f"key 'angles': {said}; 'deg' or 'rad' is accepted, the unit of '{key}'")
    value = check_finite(table[key], f"key '{key}'")
    return radians(value) if unit == "deg" else value


def _flag(table: Mapping[str, Any], key: str) -> bool:
    value = table.get(key, False)
    if not isinstance(value, bool):
        raise DescriptionError(f"key '{key}': {shown(value)}; true or false is accepted")
    return value


def from_csv(content: bytes) -> Spline:
    r"""The spline through the points of a CSV file's content; raises as :func:`read_path`, without the file's name.

    Example:
        >>> from_csv(b"x,y\n0,0\n1,0.5\n2,0\n").points.shape
        (3, 2)
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        row = content.count(b"\n", 0, error.start) + 1
        raise DescriptionError(f"row {row}: not UTF-8 text") from None
    points: list[list[float]] = []
    rows: list[int] = []
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        for cells in reader:
            entries = [entry.strip() for entry in cells]
            number = reader.line_num
            if not any(entries) or (not points and not rows and [e.lower() for e in entries] == ["x", "y"]):
                continue
            if len(entries) != 2:
                raise DescriptionError(f"row {number}: {len(entries)} entries; two numbers x,y are accepted")
            point = [cell(entry, f"row {number}, {axis}") for entry, axis in zip(entries, "xy", strict=True)]
            if points and point == points[-1]:
                raise DescriptionError(f"row {number}: the same point as the row before it")
            points.append(point)
            rows.append(number)
    except csv.Error as error:
        raise DescriptionError(f"row {reader.line_num}: not CSV that is accepted ({error})") from None
    if len(points) < 3:
        raise DescriptionError(f"{len(points)} points; at least three rows x,y are accepted")
    try:
        return Spline(points)
    except InputError as error:
        raise DescriptionError(str(error)) from None


def cell(text: str, what: str) -> float:
    """The finite number in a cell of a CSV file; ``what`` is what a message calls it."""
    try:
        number = float(text) if len(text) <= 100 and "_" not in text else math.nan
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise DescriptionError(f"{what}: {shown(text)} is not a finite number")
    return number
