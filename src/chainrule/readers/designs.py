r"""Designs of orthogonal 3R arms from a CSV file, read in blocks so that a file may have any length.

The first row names the columns: ``d2``, ``d3``, ``d4`` and ``r2`` (in m) in any order and among any others, which are
kept. Every further row holds one design; the lengths are decimal numbers, and are handed on as they are written, so
that exact arithmetic can take them exactly.
"""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass

from chainrule.errors import DescriptionError, shown
from chainrule.readers.files import located

LENGTHS = ("d2", "d3", "d4", "r2")
DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?")

#: Rows in a block, columns in a file, and characters in a cell: a cell is a number or a name.
BLOCK, MOST_COLUMNS, MOST_CHARACTERS = 20_000, 256, 200


@dataclass(frozen=True)
class DesignRows:
    """A block of rows.

    Attributes:
        header: the columns' names as the file has them.
        cells: the rows as text, one entry for each column.
        lengths: of each row the four lengths as text, in the order d2, d3, d4, r2.
    """

    header: tuple[str, ...]
    cells: tuple[tuple[str, ...], ...]
    lengths: tuple[tuple[str, str, str, str], ...]


def read_designs(path: str | os.PathLike[str]) -> Iterator[DesignRows]:
    """The designs of a CSV file, block by block; at least one block, which is empty where there are no designs.

    Raises:
        DescriptionError: one line with the file, the row and the column that is wrong, and what is accepted; raised
            when the block with the row is asked for.
    """
    with located(path):
        try:
            with open(path, encoding="utf-8-sig", newline="") as file:
                yield from _blocks(csv.reader(file, strict=True))
        except UnicodeDecodeError:
            raise DescriptionError("not UTF-8 text") from None
        except (OSError, ValueError) as error:
            if isinstance(error, DescriptionError):
                raise
            raise DescriptionError(f"cannot be read ({getattr(error, 'strerror', None) or error})") from None


def _blocks(reader: Iterator[list[str]]) -> Iterator[DesignRows]:
    header: tuple[str, ...] = ()
    places: list[int] = []
    cells: list[tuple[str, ...]] = []
    lengths: list[tuple[str, str, str, str]] = []
    begun = False
    while True:
        line = getattr(reader, "line_num", 0) + 1
        try:
            row = next(reader, None)
        except csv.Error as error:
            raise DescriptionError(f"row {line}: not CSV that is accepted ({error})") from None
        if row is None:
            break
        entries = tuple(cell.strip() for cell in row)
        if not any(entries):
            continue
        if not header:
            header, places = entries, _places(entries, line)
            continue
        if len(entries) != len(header):
            raise DescriptionError(f"row {line}: {len(entries)} entries; {len(header)} are accepted, one to a column")
        d2, d3, d4, r2 = (_length(entries[k], f"row {line}, {name}") for k, name in zip(places, LENGTHS, strict=True))
        cells.append(entries)
        lengths.append((d2, d3, d4, r2))
        if len(cells) == BLOCK:
            yield DesignRows(header, tuple(cells), tuple(lengths))
            cells, lengths, begun = [], [], True
    if not header:
        raise DescriptionError(f"no rows; a first row that names the columns {', '.join(LENGTHS)} is needed")
    if cells or not begun:
        yield DesignRows(header, tuple(cells), tuple(lengths))


def _places(header: tuple[str, ...], line: int) -> list[int]:
    """Where the four lengths are."""
    if len(header) > MOST_COLUMNS:
        raise DescriptionError(f"row {line}: {len(header)} columns; up to {MOST_COLUMNS} are accepted")
    words = [word.lower() for word in header]
    for name in LENGTHS:
        if words.count(name) != 1:
            said = "none" if name not in words else "more than one"
            raise DescriptionError(
                f"row {line}: {said} of the columns is named {name}; the first row names {', '.join(LENGTHS)} once each"
            )
    return [words.index(name) for name in LENGTHS]


def _length(text: str, where: str) -> str:
    if len(text) > MOST_CHARACTERS or not DECIMAL.fullmatch(text):
        raise DescriptionError(f"{where}: {shown(text)} is not a decimal number")
    return text
