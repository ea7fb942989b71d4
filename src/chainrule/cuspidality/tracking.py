"""Every posture of a path between two events, followed at once: rows of one array, each a continuous joint motion.

Between two events the postures are as many all the way, and no two of them meet, so in the order of theta3 on its
circle they only turn round together. Following them is choosing, from each sample to the next, by how many places they
turn; samples are added where that is not clear or a joint moves far.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
TURN = 2.0 * math.pi

#: A joint moves no further than this from a sample to the next, rad, except where rounds or distances run out.
FARTHEST = 0.25
#: The best turn has to be this many times nearer than the second best.
CLEARER = 4.0
ROUNDS, LEAST_STEP = 40, 1e-13
MOST_SAMPLES = 200_000


@dataclass(frozen=True)
class Tracks:
    """Postures followed between two events.

    Attributes:
        s: (m,) places on the path, rising.
        q: (m, k, 3) the k postures of the normal form; each column is continuous and unwrapped.
        clear: whether all of them could be followed without doubt.
    """

    s: Array
    q: Array
    clear: bool


def follow(
    postures_at: Callable[[Array], Array], intervals: list[tuple[float, float]], numbers: list[int], nodes: Array
) -> list[Tracks]:
    """The tracks in every one of the open ``intervals`` of the path.

    Args:
        postures_at: the postures (m, 4, 3) at places (m,), by rising theta3, nan where there are fewer than four.
        intervals: (lower, upper) between neighbouring events.
        numbers: how many postures there are in each.
        nodes: (j,) places to be among the samples, such as the corners of a polyline.
    """
    s = [_first_places(low, high, nodes) for low, high in intervals]
    rows = [_rows(postures_at(places), number) for places, number in zip(s, numbers, strict=True)]
    keep = [np.isfinite(found).all(axis=(1, 2)) for found in rows]  # rounding may lose one right beside an event
    s, rows = ([part[k] for part, k in zip(parts, keep, strict=True)] for parts in (s, rows))
    for _ in range(ROUNDS):
        steps = [_steps(found) for found in rows]
        bad = [
            ((move > FARTHEST) | (move * CLEARER > second)) & (np.diff(places) > LEAST_STEP)
            for places, (_, move, second) in zip(s, steps, strict=True)
        ]
        if not any(b.any() for b in bad) or sum(p.size for p in s) > MOST_SAMPLES:
            break
        new = [0.5 * (places[:-1][b] + places[1:][b]) for places, b in zip(s, bad, strict=True)]
        found = postures_at(np.concatenate(new))
        parts = np.split(found, np.cumsum([n.size for n in new])[:-1])
        for i, number in enumerate(numbers):
            more = _rows(parts[i], number)
            whole = np.isfinite(more).all(axis=(1, 2))
            places = np.concatenate([s[i], new[i][whole]])
            order = np.argsort(places, kind="stable")
            s[i], rows[i] = places[order], np.concatenate([rows[i], more[whole]])[order]
    return [_joined(places, found) for places, found in zip(s, rows, strict=True)]


def _first_places(low: float, high: float, nodes: Array) -> Array:
    """Evenly spaced, closer and closer to both ends, and the nodes."""
    width = high - low
    near = 0.1 ** np.arange(1.0, 10.0)
    shares = np.concatenate([near, np.linspace(0.0, 1.0, 34)[1:-1], 1.0 - near])
    inner = nodes[(nodes > low) & (nodes < high)]
    places = np.concatenate([low + width * shares, inner])
    return np.unique(places[(places > low) & (places < high)])


def _rows(found: Array, number: int) -> Array:
    """The first ``number`` postures of each sample; nan where a sample does not have exactly that many."""
    wrong = np.isfinite(found[..., 0]).sum(axis=1) != number
    rows: Array = found[:, :number].copy()
    rows[wrong] = np.nan
    return rows


def circular(difference: Array) -> Array:
    """Angles brought into [-pi, pi)."""
    found: Array = np.remainder(difference + math.pi, TURN) - math.pi
    return found


def _steps(rows: Array) -> tuple[Array, Array, Array]:
    """From each sample to the next: by how many places the rows turn, how far a joint moves, and the second best."""
    count = rows.shape[1]
    if count == 0 or len(rows) < 2:
        none = np.zeros(max(len(rows) - 1, 0))
        return none.astype(int), none, none + np.inf
    cost = np.stack(
        [np.abs(circular(np.roll(rows[1:], -k, axis=1) - rows[:-1])).max(axis=(1, 2)) for k in range(count)]
    )
    ordered = np.sort(cost, axis=0)
    return cost.argmin(axis=0), ordered[0], ordered[1] if count > 1 else np.full(len(rows) - 1, np.inf)


def _joined(s: Array, rows: Array) -> Tracks:
    turns, move, second = _steps(rows)
    clear = bool(((move <= 2.0 * FARTHEST) & (2.0 * move < second)).all())
    count = rows.shape[1]
    if count == 0 or s.size == 0:
        return Tracks(s, rows, clear)
    total = np.concatenate([[0], np.cumsum(turns)])
    places = (np.arange(count) + total[:, None]) % count
    q = np.take_along_axis(rows, places[..., None], axis=1)
    return Tracks(s, np.unwrap(q, axis=0), clear)
