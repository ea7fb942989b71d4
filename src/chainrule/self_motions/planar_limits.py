"""What joint limits leave of a planar 3R arm's self-motion: whole loops and arcs, exactly.

A joint of an arm has a real value between its stops, not an angle: a range wider than a turn holds some postures
twice. An arc is a stretch of the curve that the arm can run along with real joint values within all limits, from one
stop to another. A closed curve on which a joint winds cannot be run through for ever once that joint has limits: its
arc may be longer than a round where the range is wider than a turn. Arcs that hold nothing but what another arc of the
same curve holds (the same postures a turn further on) are not listed.

Where a joint is at a stop the rest of the closed chain is a triangle, so that crossings are known in closed form; that
the parts between them are inside or outside is decided at their middles, which settles grazing contacts too: a stop
that is only touched ends nothing, and postures that only touch the allowed range from outside make no arc.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.special import agm, elliprf

from chainrule.errors import InputError
from chainrule.self_motions.planar_case import Case, evaluator
from chainrule.self_motions.planar_path import wrapped
from chainrule.self_motions.planar_pieces import TURN, Piece
from chainrule.self_motions.result import Component, limit_reason

Array = NDArray[np.float64]

#: More combinations of turns within the limits than this are refused.
MOST = 4096


def feasible(
    case: Case, pieces: tuple[Piece, ...], limits: Array, finish: Callable[[Piece], Component]
) -> Iterator[Component]:
    """The parts of all pieces within limits (3, 2), piece by piece."""
    for index, piece in enumerate(pieces):
        for part in _point(piece, limits) if piece.path is None else _arcs(case, piece, limits):
            part.of = index
            yield finish(part)


def _point(piece: Piece, limits: Array) -> Iterator[Piece]:
    """An isolated point, moved by whole turns into the limits where that is possible."""
    q = piece.sign * piece.start + piece.offset
    turns = _turns(q[None], limits)[0]
    if (turns[:, 0] <= turns[:, 1]).all():
        part = copy.copy(piece)
        part.shift = TURN * np.clip(0.0, turns[:, 0], turns[:, 1])
        part.offset = piece.offset + part.shift
        yield part


def _turns(q: Array, limits: Array) -> Array:
    """Least and greatest whole number k (m, 3, 2) with q + 2 pi k within the limits, for q (m, 3)."""
    low, high = np.ceil((limits[:, 0] - q) / TURN), np.floor((limits[:, 1] - q) / TURN)
    return np.stack([low, high], axis=-1)


def crossings(case: Case, piece: Piece, limits: Array) -> Array:
    """Parameters of the path, rising, at which a joint is at one of its stops (modulo whole turns)."""
    path = piece.path
    assert path is not None
    found: list[Array] = []
    for bound in limits.T:
        known = np.isfinite(bound)
        wanted = piece.sign * (np.where(known, bound, 0.0) - piece.offset)
        if piece.velocity is not None:
            moving = known & (piece.velocity != 0.0)
            # the sets of joints that turn in proportion: solved directly
            along = (wanted - path.values[0])[moving] / piece.velocity[moving]
            found.append(np.mod(along, TURN))
            continue
        q, radicands = evaluator(f"stops_{case.task}")(wrapped(wanted), case.reach, case.lengths)
        real = np.repeat(known & (radicands >= 0.0), 2)
        found.append(_parameters(case, piece, q[real]))
    inside = np.concatenate(found)
    return np.unique(inside[(inside > path.start) & (inside < path.end)])


def _parameters(case: Case, piece: Piece, q: Array) -> Array:
    """The parameters of configurations (m, 3) of the functions' own joint values, where they are on this piece."""
    first, second = (q[:, 1], q.sum(axis=1)) if case.task == "position" else (q[:, 0], -q[:, 2])
    gaps, pattern = evaluator(f"gaps_{case.task}")(case.reach, case.sums, case.lengths)
    if piece.one_sided:  # the triangle that never falls flat has the sign of the curve
        outer = second if pattern[0] else first
        q, first, second = (part[np.sin(outer) > 0.0] for part in (q, first, second))
    halves = np.stack([wrapped(first), wrapped(second)], axis=-1) / 2.0
    phase = evaluator(f"phase_{case.task}")(halves, case.reach, case.sums, case.lengths)
    cosine, sine = phase[:, 0], phase[:, 1]
    if piece.quarter is not None:
        period = math.pi if piece.one_sided else TURN
        return np.asarray(np.mod(np.arctan2(sine, cosine) - piece.quarter * math.pi / 2.0, period))
    path = piece.path
    assert path is not None
    return np.mod(theta_of(cosine, sine, gaps), path.end)


def theta_of(cosine: Array, sine: Array, gaps: Array) -> Array:
    """theta from multiples of cos phi and sin phi: an elliptic integral of the first kind in Carlson's form."""
    ab, bc, cd = gaps
    square = (ab / (ab + bc)) * (cd / (bc + cd))  # the complementary modulus, squared
    c, s = math.sqrt(ab) * cosine, math.sqrt(ab + bc) * sine
    size = np.hypot(c, s)
    c, s = c / size, s / size
    integral = s * elliprf(c * c, c * c + square * s * s, 1.0)
    theta = integral * agm(1.0, math.sqrt(square))
    return np.asarray(np.where(c >= 0.0, theta, np.copysign(math.pi, s) - theta))


@dataclass(frozen=True)
class Run:
    """A stretch of the path's line: ``round`` and segment of both ends, and the turns of each joint."""

    first: tuple[int, int]
    last: tuple[int, int]
    turns: tuple[int, ...]
    whole: bool = False


def _arcs(case: Case, piece: Piece, limits: Array) -> list[Piece]:
    path = piece.path
    assert path is not None
    cuts = np.concatenate([[path.start], crossings(case, piece, limits), [path.end]])
    middles = (cuts[:-1] + cuts[1:]) / 2.0
    allowed = _turns(piece.at_parameter(np.zeros(len(middles)), middles), limits)
    winding = np.rint(piece.advance / TURN).astype(int) if piece.closed else np.zeros(3, int)
    runs = _runs(allowed, winding, np.asarray(np.isfinite(limits).any(axis=1)), piece.closed)
    lengths = path.length_to(cuts[:-1])
    marks = np.append(lengths, path.length) / path.length
    found = []
    for run in runs:
        part = copy.copy(piece)
        part.shift = TURN * np.array(run.turns, float)
        if not run.whole:
            begin, end = run.first[0] + marks[run.first[1]], run.last[0] + marks[run.last[1] + 1]
            back = math.floor(begin)
            part.begin, part.rounds = begin - back, end - begin
            part.shift = part.shift + back * (piece.advance if piece.closed else 0.0)
            part.span = (part.begin, part.begin + part.rounds)
            part.closed = False
            part.ends = (_reason(piece, run, allowed, winding, False), _reason(piece, run, allowed, winding, True))
        found.append(part)
    return _distinct(found)


def _runs(allowed: Array, winding: Array, limited: NDArray[np.bool_], closed: bool) -> list[Run]:
    """Maximal stretches of segments in which every joint, moved by its turns, is allowed."""
    segments = len(allowed)
    leading = next((j for j in range(3) if limited[j] and winding[j]), None)
    rounds = range(1)
    if leading is not None:
        usable = allowed[allowed[:, leading, 0] <= allowed[:, leading, 1], leading]
        if not len(usable):
            return []
        ends = sorted((usable.min() * winding[leading], usable.max() * winding[leading]))
        rounds = range(int(ends[0]), int(ends[1]) + 1)
    choices = []
    for joint in range(3):
        if not limited[joint] or joint == leading:
            choices.append([0])
            continue
        low, high = allowed[:, joint, 0], allowed[:, joint, 1]
        good = low <= high
        if not good.any():
            return []
        if not winding[joint] and low.max() <= high.min():
            choices.append([int(np.clip(0, low.max(), high.min()))])
            continue
        spread = sorted((rounds[0] * int(winding[joint]), rounds[-1] * int(winding[joint])))
        choices.append(list(range(int(low[good].min()) - spread[1], int(high[good].max()) - spread[0] + 1)))
    if math.prod(map(len, choices)) * len(rounds) > MOST:
        raise InputError(
            f"limits: they hold more than {MOST} combinations of turns; limits of some turns, or none, are accepted"
        )
    found = []
    for turns in product(*choices):
        inside = np.array(
            [[_inside(allowed[i], turns, n, winding, limited) for i in range(segments)] for n in rounds]
        ).ravel()
        places = [(n, i) for n in rounds for i in range(segments)]
        if closed and leading is None:
            if inside.all():
                found.append(Run((0, 0), (0, segments - 1), turns, True))
                continue
            gap = int(np.flatnonzero(~inside)[0])  # begin behind a gap, so that no stretch is cut at the path's start
            places = [(n + (k >= segments), i) for k in range(gap, gap + segments) for n, i in [places[k % segments]]]
            inside = np.roll(inside, -gap)
        edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
        for first, last in zip(edges[::2], edges[1::2], strict=True):
            found.append(Run(places[first], places[last - 1], turns))
    return found


def _inside(allowed: Array, turns: tuple[int, ...], n: int, winding: Array, limited: NDArray[np.bool_]) -> bool:
    return all(not limited[j] or allowed[j, 0] <= turns[j] + n * winding[j] <= allowed[j, 1] for j in range(len(turns)))


def _reason(piece: Piece, run: Run, allowed: Array, winding: Array, end: bool) -> str:
    """Why a stretch ends: the joint that the next segment does not allow."""
    n, i = run.last if end else run.first
    i += 1 if end else -1
    if not 0 <= i < len(allowed):
        if not piece.closed:
            return piece.ends[1 if end else 0] if piece.ends else "singular"
        n, i = n + (1 if end else -1), i % len(allowed)
    for j in range(3):
        turns = run.turns[j] + n * winding[j]
        if turns > allowed[i, j, 1]:
            return limit_reason(j + 1, True)
        if turns < allowed[i, j, 0]:
            return limit_reason(j + 1, False)
    return "singular"  # a figure of eight's loop: the singular point is where it begins


def _distinct(parts: list[Piece]) -> list[Piece]:
    """Without the parts that lie in another one, whole turns apart."""
    kept: list[Piece] = []
    for part in sorted(parts, key=lambda part: (-part.rounds, part.begin, float(np.abs(part.shift).sum()))):
        inside = any(
            other.closed
            or other.rounds >= 1.0
            or math.fmod(part.begin - other.begin + 1.0, 1.0) + part.rounds <= other.rounds + 1e-12
            for other in kept
        )
        if not inside:
            kept.append(part)
    return sorted(kept, key=lambda part: part.begin)
