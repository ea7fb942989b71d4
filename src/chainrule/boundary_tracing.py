"""The boundary of a set of points of the plane that is given by a test, traced as polygons."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.boundary_pieces import Piece, Segment

Array = NDArray[Any]


def trace(
    inside: Callable[[Array], Array], low: complex, high: complex, steps: int, tolerance: float, straight: float
) -> tuple[tuple[Piece, ...], ...]:
    """Polygons around the points where ``inside`` holds, their corners on its boundary to within ``tolerance``.

    Squares whose corners differ are found on a grid, crossings on their sides by bisection; then sides whose middle is
    off the boundary are bent onto it, up to four times.

    Args:
        inside: for points (k,), whether they belong to the region.
        low: the lower left corner of where to look.
        high: the upper right one.
        steps: squares along the longer side.
        tolerance: of the corners, m.
        straight: how far the middle of a side may be from the boundary, m.
    """
    step = max((high - low).real, (high - low).imag) / steps
    if step <= 0.0:
        return ()
    # off by a share that no drawing has, so that lines of symmetry do not fall on the grid
    nx, ny = (int(extent / step) + 4 for extent in ((high - low).real, (high - low).imag))
    corner = low - step * complex(1.3819, 1.4142)
    grid = corner + step * (np.arange(nx + 1)[:, None] + 1j * np.arange(ny + 1)[None, :])
    value = inside(grid.reshape(-1)).reshape(grid.shape)
    sides: dict[tuple[int, int, int], int] = {}
    ends: list[tuple[complex, complex]] = []  # (inside, outside)
    for direction, (dx, dy) in enumerate(((1, 0), (0, 1))):
        a, b = grid[: nx + 1 - dx, : ny + 1 - dy], grid[dx:, dy:]
        va, vb = value[: nx + 1 - dx, : ny + 1 - dy], value[dx:, dy:]
        for i, j in np.argwhere(va != vb).tolist():
            sides[(direction, i, j)] = len(ends)
            ends.append((a[i, j], b[i, j]) if va[i, j] else (b[i, j], a[i, j]))
    if not ends:
        return ()
    within, outside = np.array(ends).T
    crossing = _bisected(inside, within, outside, tolerance)
    following: dict[int, int] = {}
    cells = {(i - dx, j - dy) for d, i, j in sides for dx, dy in ((0, 0), ((0, 1), (1, 0))[d])}
    for i, j in sorted(cells):
        following.update(_through(value[i : i + 2, j : j + 2], sides, i, j, inside, grid))
    loops = []
    while following:
        at, after = following.popitem()
        polygon = [at]
        while after != polygon[0]:
            polygon.append(after)
            after = following.pop(after)
        loops.append(_bent(inside, crossing[polygon], tolerance, straight))
    pieces = [
        tuple(Segment(complex(a), complex(b)) for a, b in zip(line, np.roll(line, -1), strict=True)) for line in loops
    ]
    return tuple(sorted(pieces, key=lambda loop: -abs(math.fsum(piece.area() for piece in loop))))


def _through(
    value: Array, sides: dict[tuple[int, int, int], int], i: int, j: int, inside: Callable[[Array], Array], grid: Array
) -> dict[int, int]:
    """How the boundary passes a square, with the inside on its left: from which crossing to which."""
    # corners and sides counter-clockwise from the lower left
    corners = [bool(value[0, 0]), bool(value[1, 0]), bool(value[1, 1]), bool(value[0, 1])]
    number = [sides.get(key) for key in ((0, i, j), (1, i + 1, j), (0, i, j + 1), (1, i, j))]
    # going round, the boundary comes in through sides that lead from inside to outside
    entering = [k for k in range(4) if corners[k] and not corners[(k + 1) % 4]]
    leaving = [k for k in range(4) if not corners[k] and corners[(k + 1) % 4]]
    if len(entering) == 2:
        middle = np.array([0.5 * (grid[i, j] + grid[i + 1, j + 1])])
        joined = bool(inside(middle)[0])
        # a joined middle cuts off the outside corners, each between a side and the next
        leaving = [(k + 1) % 4 if joined else (k - 1) % 4 for k in entering]
    found = {}
    for k, m in zip(entering, leaving, strict=True):
        start, end = number[k], number[m]
        assert start is not None and end is not None
        found[start] = end
    return found


def _bisected(inside: Callable[[Array], Array], within: Array, outside: Array, tolerance: float) -> Array:
    """Points (k,) on the boundary between points inside and points outside."""
    within, outside = within.copy(), outside.copy()
    while float(np.abs(within - outside).max(initial=0.0)) > tolerance:
        middle = 0.5 * (within + outside)
        yes = inside(middle)
        within, outside = np.where(yes, middle, within), np.where(yes, outside, middle)
    return within


def _bent(inside: Callable[[Array], Array], line: Array, tolerance: float, straight: float) -> Array:
    """A closed polygon (k,) with more corners where the boundary is further than ``straight`` from its sides."""
    open_ = np.ones(len(line), dtype=bool)
    for _ in range(4):
        sides = np.nonzero(open_)[0]
        start, end = line[sides], np.roll(line, -1)[sides]
        middle, across = 0.5 * (start + end), 0.25j * (end - start)
        a, b = inside(middle + across), inside(middle - across)
        some = (a != b) & (np.abs(across) > straight)
        sides, middle, across, a = sides[some], middle[some], across[some], a[some]
        ends = middle + across, middle - across
        new = _bisected(inside, np.where(a, *ends), np.where(a, *ends[::-1]), tolerance)
        bent = np.abs(new - middle) > straight
        if not bent.any():
            break
        open_[:] = False
        open_[sides[bent]] = True
        line, open_ = np.insert(line, sides[bent] + 1, new[bent]), np.insert(open_, sides[bent] + 1, True)
    return line
