"""What is known of an arm as tables of plain values: the same ones on the terminal, in JSON and in the report."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from chainrule.arm import Arm
from chainrule.description import Description, Orthogonal3R, Planar, Serial, Transform

Cell = str | int | float | bool | None


@dataclass(frozen=True)
class Column:
    """A column: its key (for JSON), its title and the unit of its numbers."""

    key: str
    title: str
    unit: str = ""

    @property
    def heading(self) -> str:
        """Title and unit."""
        return f"{self.title} [{self.unit}]" if self.unit else self.title


@dataclass(frozen=True)
class Table:
    """A caption, columns, and rows with one cell for each column; None is an empty cell."""

    caption: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]

    def to_dict(self) -> list[dict[str, Cell]]:
        """One dictionary for each row."""
        return [{c.key: cell for c, cell in zip(self.columns, row, strict=True)} for row in self.rows]

    def numeric(self, column: int) -> bool:
        """Whether a column holds numbers (and perhaps empty cells) only."""
        cells = [row[column] for row in self.rows if row[column] is not None]
        return bool(cells) and all(isinstance(c, int | float) and not isinstance(c, bool) for c in cells)

    def wordy(self, column: int) -> bool:
        """Whether a column holds running text, which may break into lines."""
        return any(isinstance(row[column], str) and len(str(row[column]).split()) > 4 for row in self.rows)


def readable(value: Cell, digits: int = 6) -> str:
    """A cell as text: numbers with up to ``digits`` significant digits, an en dash for nothing.

    >>> readable(0.333), readable(None), readable(2.0), readable(1.5e-16, 2)
    ('0.333', '–', '2', '1.5e-16')
    """
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u202f") if abs(value) >= 10_000 else str(value)
    if isinstance(value, float):
        if math.isinf(value):
            return "∞" if value > 0 else "−∞"
        return f"{value:.{digits}g}".replace("-", "−") if "e" not in f"{value:.{digits}g}" else f"{value:.{digits}g}"
    return value


def printable(text: str, most: int = 400) -> str:
    """Text from a file on one line, without control characters, cut where it is long."""
    clean = "".join(c if c.isprintable() else " " for c in text)
    clean = " ".join(clean.split())
    return clean if len(clean) <= most else clean[: most - 1] + "…"


def capitalised(text: str) -> str:
    """A sentence with a capital letter at its start, unless it starts with a symbol.

    >>> capitalised("for a left turn"), capitalised("d3 is larger")
    ('For a left turn', 'd3 is larger')
    """
    first = text.partition(" ")[0].rstrip(",;:")
    word = (
        first.isalpha() and first.isascii() and (len(first) > 2 or first in ("a", "as", "at", "if", "in", "it", "of"))
    )
    return text[:1].upper() + text[1:] if word else text


def angle_deg(value: float) -> float:
    """Degrees, without the last rounding error of a quarter turn."""
    return float(f"{math.degrees(value):.12g}")


def kind_word(kind: str) -> str:
    """``revolute`` or ``prismatic``."""
    return {"R": "revolute", "P": "prismatic"}[kind]


def joint_unit(kind: str) -> str:
    """``rad`` or ``m``."""
    return {"R": "rad", "P": "m"}[kind]


def in_degrees(value: float, kind: str) -> str:
    """A joint's value as people say it: degrees for a revolute joint, metres for a prismatic one."""
    if kind == "R":
        return f"{readable(round(math.degrees(value), 1) + 0.0)}°"
    return f"{readable(value, 4)} m"


def posture(arm: Arm, q: Any, which: Iterable[int] | None = None) -> str:
    """Joint values in words: ``q1 = 30°, q2 = 0.5 m``, with spaces that do not break within one of them."""
    chosen = range(arm.n) if which is None else which
    return ", ".join(f"q{j + 1} = {in_degrees(float(q[j]), arm.kinds[j])}".replace(" ", "\u00a0") for j in chosen)


def joints(arm: Arm) -> Table:
    """The joints with their limits; a column of limits that no joint has is left out."""
    columns = [Column("joint", "joint"), Column("name", "name"), Column("kind", "kind")]
    description = arm.description
    mixed = "P" in arm.kinds
    turning = "rad or m" if mixed else "rad"
    cells: list[list[Cell]] = [[i, j.name, kind_word(j.kind)] for i, j in enumerate(description.joints, 1)]
    limits: list[tuple[Column, list[Cell]]] = [
        (Column("lower", "lower", turning), [_bound(j.position, 0) for j in description.joints]),
        (Column("upper", "upper", turning), [_bound(j.position, 1) for j in description.joints]),
        (
            Column("velocity", "velocity", "rad/s or m/s" if mixed else "rad/s"),
            [j.velocity for j in description.joints],
        ),
        (
            Column("acceleration", "acceleration", "rad/s² or m/s²" if mixed else "rad/s²"),
            [j.acceleration for j in description.joints],
        ),
        (
            Column("torque", "force or torque" if mixed else "torque", "N or N m" if mixed else "N m"),
            [j.torque for j in description.joints],
        ),
    ]
    for column, values in limits:
        if any(value is not None for value in values):
            columns.append(column)
            for row, value in zip(cells, values, strict=True):
                row.append(value)
    return Table("Joints and their limits", tuple(columns), tuple(tuple(row) for row in cells))


def _bound(position: tuple[float, float] | None, side: int) -> Cell:
    value = None if position is None else position[side]
    return None if value is None or math.isinf(value) else value


def geometry(description: Description) -> list[Table]:
    """The numbers of the geometry: a Denavit-Hartenberg table, fixed transforms, or the family's lengths."""
    shape = description.geometry
    if isinstance(shape, Planar):
        motions = {"R": "turns, then advances", "P": "turns by a constant, then advances and slides"}
        columns: tuple[Column, ...] = (
            Column("joint", "joint"),
            Column("motion", "motion"),
            Column("length", "length l", "m"),
        )
        lines = zip(description.kinds, shape.lengths, strict=True)
        rows: tuple[tuple[Cell, ...], ...] = tuple((i, motions[k], length) for i, (k, length) in enumerate(lines, 1))
        if "P" in description.kinds:
            columns += (Column("heading", "heading", "deg"),)
            turns = (angle_deg(h) if k == "P" else None for k, h in zip(description.kinds, shape.headings, strict=True))
            rows = tuple((*row, turn) for row, turn in zip(rows, turns, strict=True))
        return [Table("Planar chain", columns, rows)]
    if isinstance(shape, Orthogonal3R):
        lengths = tuple((name, getattr(shape, name)) for name in ("d2", "d3", "d4", "r2"))
        family = Table(
            "Orthogonal 3R family: lengths", (Column("name", "name"), Column("length", "length", "m")), lengths
        )
        table = Table(
            "Modified Denavit-Hartenberg table (Craig)",
            _DH_COLUMNS,
            (
                (1, "revolute", 0.0, 0.0, 0.0, "q1"),
                (2, "revolute", -90.0, shape.d2, shape.r2, "q2"),
                (3, "revolute", 90.0, shape.d3, 0.0, "q3"),
                ("tool", None, None, shape.d4, None, None),
            ),
        )
        return [family, table]
    return [_dh_table(shape)] if shape.table is not None else _transforms(description, shape)


_DH_COLUMNS = (
    Column("joint", "joint"),
    Column("kind", "kind"),
    Column("alpha", "α", "deg"),
    Column("a", "a", "m"),
    Column("d", "d", "m"),
    Column("theta", "θ", "deg"),
)


def _dh_table(shape: Serial) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for i, row in enumerate(shape.table or (), 1):
        offset = angle_deg(row.theta)
        theta: Cell = offset if row.kind == "P" else _offset(f"q{i}", offset)
        d: Cell = row.d if row.kind == "R" else _offset(f"q{i}", row.d)
        rows.append((i, kind_word(row.kind), angle_deg(row.alpha), row.a, d, theta))
    name = (
        "Modified Denavit-Hartenberg table (Craig)"
        if shape.convention == "modified"
        else ("Standard Denavit-Hartenberg table")
    )
    return Table(name, _DH_COLUMNS, tuple(rows))


def _offset(symbol: str, offset: float) -> str:
    if offset == 0.0:
        return symbol
    return f"{symbol} {'+' if offset > 0 else '−'} {readable(abs(offset))}"


_TRANSFORM_COLUMNS = (
    Column("before", "before"),
    Column("x", "x", "m"),
    Column("y", "y", "m"),
    Column("z", "z", "m"),
    Column("roll", "roll", "deg"),
    Column("pitch", "pitch", "deg"),
    Column("yaw", "yaw", "deg"),
)


def _transforms(description: Description, shape: Serial) -> list[Table]:
    named = [*((j.name, t) for j, t in zip(description.joints, shape.placements, strict=True)), ("tool", shape.tool)]
    return [
        Table(
            "Fixed transform before each joint (roll, pitch, yaw about the fixed x, y, z)",
            _TRANSFORM_COLUMNS,
            tuple(transform_row(name, t) for name, t in named),
        )
    ]


def transform_row(name: str, transform: Transform) -> tuple[Cell, ...]:
    """A fixed transform as translation and roll, pitch, yaw (fixed axes) in degrees."""
    r = transform.rotation
    pitch = math.atan2(-r[2][0], math.hypot(r[0][0], r[1][0]))
    if math.hypot(r[0][0], r[1][0]) > 1e-12:
        roll, yaw = math.atan2(r[2][1], r[2][2]), math.atan2(r[1][0], r[0][0])
    else:  # pitch of a quarter turn: roll and yaw turn about one line, and yaw takes it all
        roll, yaw = 0.0, math.atan2(-r[0][1], r[1][1])
    angles = tuple(angle_deg(a) + 0.0 if abs(a) > 1e-13 else 0.0 for a in (roll, pitch, yaw))
    return (name, *transform.translation, *angles)


def tool(description: Description) -> Table | None:
    """The tool's fixed transform after the last joint, for an arm given by a Denavit-Hartenberg table."""
    shape = description.geometry
    if not isinstance(shape, Serial) or shape.table is None or shape.tool == Transform():
        return None
    return Table("Tool, in the last link's frame", _TRANSFORM_COLUMNS[1:], (transform_row("", shape.tool)[1:],))


def tasks(arm: Arm) -> Table:
    """The tasks: what is controlled, rows m, redundancy n - m, number of maximal minors."""
    planar = "x_alpha" in arm.tasks
    what = {
        "position": "x, y" if planar else "x, y, z",
        "x_alpha": "x and heading α",
        "pose": "x, y and heading α" if planar else "linear and angular velocity",
    }
    rows = tuple(
        (
            task,
            what[task],
            m,
            arm.n - m if arm.n >= m else None,
            math.comb(arm.n, m) if arm.n >= m else None,
            task == arm.default_task,
        )
        for task, m in arm.tasks.items()
    )
    return Table(
        "Tasks",
        (
            Column("task", "task"),
            Column("controls", "controls"),
            Column("rows", "rows m"),
            Column("redundancy", "redundancy n − m"),
            Column("minors", "maximal minors"),
            Column("default", "default"),
        ),
        rows,
    )


def functions(arm: Arm) -> Table:
    """Every generated function: what it computes, its outputs, operations, and whether it is compiled.

    Makes the functions if nothing has been generated for this arm yet.
    """
    from chainrule import compile as compiling

    rows: list[tuple[Cell, ...]] = []
    for group in arm.groups:
        built = compiling.find(arm.description.model, group)
        for name, spec in built.functions.items():
            outputs = ", ".join(_shape(port) for port in spec["outputs"])
            rows.append(
                (
                    name,
                    spec["summary"],
                    outputs,
                    int(spec["operations"]),
                    "compiled C" if built.library is not None else "NumPy",
                )
            )
    return Table(
        "Generated functions",
        (
            Column("function", "function"),
            Column("summary", "what it computes"),
            Column("outputs", "outputs"),
            Column("operations", "operations"),
            Column("code", "code"),
        ),
        tuple(rows),
    )


def _shape(port: Any) -> str:
    name, extents = port
    return f"{name} ({' × '.join(map(str, extents))})" if extents else str(name)
