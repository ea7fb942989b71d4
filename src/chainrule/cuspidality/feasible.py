"""Which postures can follow a path in the workspace to its end without a jump, and where and why the others stop.

A posture can be followed until it meets another one in a singularity: there the path leads out of the region where
both exist. On straight segments the places where that may happen are the real roots of a polynomial, isolated with a
proof (:mod:`chainrule.cuspidality.events`). For a path given as a function nothing of the kind is known: it is sampled,
and two events closer together than the samples may be missed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.aspects import zero
from chainrule.cuspidality.events import segment_events
from chainrule.cuspidality.normal_form import Regional
from chainrule.cuspidality.tracking import Tracks, circular, follow
from chainrule.errors import InputError
from chainrule.inputs import real_array

Array = NDArray[Any]

#: Samples of a path given as a function, at first.
SAMPLES = 1024
#: Two postures this near each other beside an event, and this much nearer than elsewhere, meet there; rad.
MEETING, NEARER = 3e-3, 0.05


@dataclass(frozen=True)
class FollowedPosture:
    """What becomes of one start posture.

    Attributes:
        start: (3,) rad, the posture at the path's begin, each angle in (-pi, pi].
        s: (k,) rising places on the path, from 0 to 1 or to where the posture stops.
        q: (k, 3) rad, the joint path at ``s``, unwrapped.
        stops_at: the place s where it stops; None where it reaches the end.
        reason: why it stops there, in words; empty where it reaches the end.
        merges_with: which start posture it merges with where it stops; None where there is none, or it is one that
            appeared on the way.
        end: which of the end postures it becomes; None where it stops.
    """

    start: Array
    s: Array
    q: Array
    stops_at: float | None
    reason: str
    merges_with: int | None
    end: int | None

    @property
    def reaches_end(self) -> bool:
        """Whether it can follow the whole path."""
        return self.end is not None

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "start": self.start.tolist(),
            "s": self.s.tolist(),
            "q": self.q.tolist(),
            "stops_at": self.stops_at,
            "reason": self.reason,
            "merges_with": self.merges_with,
            "end": self.end,
        }


@dataclass(frozen=True)
class FeasiblePostures:
    """What becomes of every posture at the begin of a path.

    Attributes:
        postures: one for each start posture, by rising theta3.
        ends: (m, 3) rad, the postures at the path's end, by rising theta3.
        events: (k,) places s where postures may merge or appear.
        closed: whether the path ends where it begins.
        certified: whether ``events`` are proved to be all, and every posture was followed without doubt from one to the
            next; never for functions. Two events nearer than doubles can tell apart count as one, without proof.
        guarantee: what is guaranteed, in words.
    """

    postures: tuple[FollowedPosture, ...]
    ends: Array
    events: Array
    closed: bool
    certified: bool
    guarantee: str
    _start: Array = field(repr=False)

    @property
    def starts(self) -> Array:
        """(n, 3) rad, the start postures."""
        return self._start

    @property
    def feasible(self) -> tuple[int, ...]:
        """Which start postures reach the end."""
        return tuple(i for i, posture in enumerate(self.postures) if posture.reaches_end)

    @property
    def permutation(self) -> tuple[int | None, ...] | None:
        """For a closed path: the start posture that each one has become after one round (None: it stops on the way).

        Entries that differ from their place are the arm "flipping": it comes back in another posture, without a
        singularity and without a jump. Only cuspidal arms do. None for a path that is not closed, or where begin and
        end are singular and cannot be told apart.
        """
        alike = self.closed and len(self.ends) == len(self.starts)
        return tuple(posture.end for posture in self.postures) if alike else None

    @property
    def flips(self) -> bool:
        """Whether the path is closed and some posture comes back as another one."""
        return any(end is not None and end != i for i, end in enumerate(self.permutation or ()))

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "postures": [posture.to_dict() for posture in self.postures],
            "ends": self.ends.tolist(),
            "events": self.events.tolist(),
            "closed": self.closed,
            "permutation": None if self.permutation is None else list(self.permutation),
            "certified": self.certified,
            "guarantee": self.guarantee,
        }


def feasible_postures(regional: Regional, path: Any) -> FeasiblePostures:
    """Which postures at the begin of ``path`` can follow it to its end, and what stops the others.

    Args:
        regional: the arm.
        path: corners (k, 3) of a polyline in m, s growing with its length; or a function of s in [0, 1] that maps
            arrays (...,) to points (..., 3) in m.

    Raises:
        InputError: fewer than two different corners; numbers that are not finite; a function whose answer has another
            shape.
    """
    plan = _of_function(regional, path) if callable(path) else _of_polyline(regional, path)
    tracks = follow(plan.postures_at, plan.intervals, plan.numbers, plan.nodes)
    return _Assembly(plan, tracks).answer()


# ---- where the events are ------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Plan:
    """A path with its events.

    Attributes:
        regional: the arm.
        at: points (m, 3) of the normal form at places (m,).
        intervals: (lower, upper) between neighbouring events; the path's ends bound the first and last.
        numbers: how many postures there are in each.
        events: (k,) places.
        nodes: (j,) places of corners.
        guarantee: in words; ``certified`` whether it is a proof.
    """

    regional: Regional
    at: Callable[[Array], Array]
    intervals: list[tuple[float, float]]
    numbers: list[int]
    events: list[float]
    nodes: Array
    certified: bool
    guarantee: str

    def postures_at(self, s: Array) -> Array:
        """(m, 4, 3) postures of the normal form by rising theta3, nan where there are fewer."""
        return self.regional.section_postures(self.at(np.asarray(s, float)))


def _of_polyline(regional: Regional, path: Any) -> _Plan:
    """Events of every segment, by one polynomial each."""
    corners = real_array(path, "path")
    if corners.ndim != 2 or corners.shape[1] != 3 or len(corners) < 2:
        raise InputError(
            f"path: an array of shape {corners.shape}; two or more points (k, 3), or a function, are accepted"
        )
    points = regional.point_to_normal(corners)
    lengths = np.sqrt((np.diff(points, axis=0) ** 2).sum(axis=1))
    moving = lengths > 0.0
    if not moving.any():
        raise InputError("path: all its points are the same; two different ones are needed")
    points = np.concatenate([points[:-1][moving], points[-1:]])
    s = np.concatenate([[0.0], np.cumsum(lengths[moving])])
    s /= s[-1]

    def at(places: Array) -> Array:
        return np.stack([np.interp(places, s, coordinate) for coordinate in points.T], axis=-1)

    segments = [segment_events(regional, a, b) for a, b in pairwise(points)]
    if any(segment.everywhere for segment in segments):
        why = "somewhere two postures coincide all along a segment, so that no polynomial tells the events"
        return _sampled(regional, at, s, why)
    events, intervals, numbers, open_event = list[float](), list[tuple[float, float]](), list[int](), False
    for i, segment in enumerate(segments):
        bounds = [s[i], *(s[i] + u * (s[i + 1] - s[i]) for u in segment.at), s[i + 1]]
        for j, number in enumerate(segment.numbers):
            low, high = float(bounds[j]), float(bounds[j + 1])
            if j > 0:
                open_event = True
                events.append(low)
            if high <= low:  # an event exactly at a corner, or two that one number stands for
                continue
            if intervals and not open_event:
                intervals[-1] = (intervals[-1][0], high)
            else:
                intervals.append((low, high))
                numbers.append(number)
            open_event = False
    guarantee = "the events are all there are, for the path's corners as given (real roots isolated with a proof)"
    return _Plan(regional, at, intervals, numbers, sorted(set(events)), s, True, guarantee)


def _of_function(regional: Regional, path: Callable[[Array], Any]) -> _Plan:
    def at(places: Array) -> Array:
        points = real_array(path(places), "path(s)")
        if points.shape != (*places.shape, 3):
            raise InputError(
                f"path: for s of shape {places.shape} it gave {points.shape}; {(*places.shape, 3)} is accepted"
            )
        return regional.point_to_normal(points)

    return _sampled(regional, at, np.array([0.0, 1.0]), "the path is a function, known at samples only")


def _sampled(regional: Regional, at: Callable[[Array], Array], nodes: Array, why: str) -> _Plan:
    """Events where the number of postures changes from one sample to the next, narrowed down by halving."""

    def numbers_at(places: Array) -> Array:
        found: Array = np.isfinite(regional.section_postures(at(places))[..., 0]).sum(axis=-1)
        return found

    s = np.unique(np.concatenate([np.linspace(0.0, 1.0, SAMPLES + 1), nodes]))
    count = numbers_at(s)
    change = np.flatnonzero(np.diff(count))
    low, high, before = s[change], s[change + 1], count[change]
    for _ in range(60 if change.size else 0):
        middle = 0.5 * (low + high)
        same = numbers_at(middle) == before
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    edges = [0.0, *high.tolist(), 1.0]
    numbers = [*count[change].tolist(), int(count[-1])]
    guarantee = f"none: {why}; two events closer together than {1.0 / SAMPLES:.1g} of the path may be missed"
    return _Plan(regional, at, list(pairwise(edges)), numbers, edges[1:-1], nodes, False, guarantee)


# ---- putting the tracks together -----------------------------------------------------------------------------------


class _Assembly:
    """The tracks between events, joined over them."""

    def __init__(self, plan: _Plan, tracks: list[Tracks]) -> None:
        self.plan, self.regional = plan, plan.regional
        kept = [i for i, track in enumerate(tracks) if track.s.size]  # some are too narrow for a sample
        self.tracks, self.intervals = [tracks[i] for i in kept], [plan.intervals[i] for i in kept]
        self.whole = len(kept) == len(tracks)
        self.begins_at_event = not kept or kept[0] > 0 or 0.0 in plan.events
        self.ends_at_event = not kept or kept[-1] < len(tracks) - 1 or 1.0 in plan.events

    def answer(self) -> FeasiblePostures:
        """The result."""
        begin, end = (self._at_end(s) for s in (0.0, 1.0))
        first = self.tracks[0]
        columns: list[int | None]
        singular_begin = self.begins_at_event
        if first.q.shape[1] == 0 or first.s.size == 0:
            starts, columns = begin, [None] * len(begin)
        elif singular_begin or len(begin) != first.q.shape[1]:
            starts, columns = first.q[0], list(range(first.q.shape[1]))
        else:
            order = _matched(begin, first.q[0])
            starts, columns = begin, [order[i] for i in range(len(begin))]
        last = self.tracks[-1]
        if self.ends_at_event or len(end) != last.q.shape[1]:
            end = last.q[-1] if last.q.size else np.empty((0, 3))
        final = {column: i for i, column in _matched(end, last.q[-1]).items()} if len(end) else {}
        points = self.plan.at(np.array([0.0, 1.0]))
        closed = bool(np.abs(points[1] - points[0]).max() <= 1e-12 * np.abs(points).max())
        if closed and len(end) == len(starts):
            place = _matched(end, starts)
            end = end[[{v: k for k, v in place.items()}[i] for i in range(len(end))]]
            final = {column: place[i] for column, i in final.items()}
        stopped = self._stops_at_begin(singular_begin, columns)
        found = self._through(starts, columns, stopped, final)
        return FeasiblePostures(
            tuple(found),
            _wrapped(self.regional.from_normal(end)),
            np.array(self.plan.events),
            closed,
            self.plan.certified and self.whole and all(tracks.clear for tracks in self.tracks),
            self.plan.guarantee,
            _wrapped(self.regional.from_normal(starts)),
        )

    def _at_end(self, s: float) -> Array:
        rows = self.plan.postures_at(np.array([s]))[0]
        found: Array = rows[np.isfinite(rows[:, 0])]
        return found

    def _stops_at_begin(self, singular: bool, columns: list[int | None]) -> set[int]:
        """Start postures that are singular themselves."""
        if not singular or self.tracks[0].s.size == 0:
            return set()
        meeting = _meeting(self.tracks[0], 0)
        return {i for i, column in enumerate(columns) if column is not None and column in meeting}

    def _through(
        self, starts: Array, columns: list[int | None], stopped: set[int], final: dict[int, int]
    ) -> list[FollowedPosture]:
        """Every start posture from interval to interval."""
        parts: list[list[tuple[Array, Array]]] = [[(np.array([0.0]), start[None])] for start in starts]
        stops: list[tuple[float, str, int | None] | None] = [None] * len(starts)
        alive = {i: column for i, column in enumerate(columns) if column is not None and i not in stopped}
        for i, column in enumerate(columns):
            if i in stopped:
                stops[i] = (0.0, f"it is singular at the begin: {self._what(0, i, None)}", None)
            elif column is None:
                stops[i] = (0.0, "the path leaves the workspace at its begin", None)
        for number, tracks in enumerate(self.tracks):
            for i, column in alive.items():
                parts[i].append((tracks.s, tracks.q[:, column]))
            if number + 1 == len(self.tracks):
                break
            after, event = self.tracks[number + 1], self.intervals[number][1]
            onward, meeting = _over_event(tracks, after)
            owner = {column: i for i, column in alive.items()}
            for i, column in list(alive.items()):
                if column in onward and column not in meeting:
                    alive[i] = onward[column]
                    continue
                del alive[i]
                partner = owner.get(meeting[column]) if column in meeting else None
                stops[i] = (event, self._reason(number, column, meeting, partner), partner)
        found = []
        for i, start in enumerate(starts):
            s = np.concatenate([part for part, _ in parts[i]])
            q = np.unwrap(np.concatenate([rows for _, rows in parts[i]]), axis=0)
            if i in alive:
                exact = self._at_end(1.0)
                if len(exact) and not self.ends_at_event:
                    gap = circular(exact - q[-1])
                    nearest = int(np.abs(gap).max(axis=1).argmin())
                    s, q = np.append(s, 1.0), np.concatenate([q, (q[-1] + gap[nearest])[None]])
            joints = self.regional.from_normal(q)
            begin = _wrapped(self.regional.from_normal(start))
            joints += begin - joints[0]
            at, reason, partner = stops[i] or (None, "", None)
            end = final.get(alive[i]) if i in alive else None
            found.append(FollowedPosture(begin, s, joints, at, reason, partner, end))
        return found

    def _reason(self, number: int, column: int, meeting: dict[int, int], partner: int | None) -> str:
        """Why a posture stops at the upper end of an interval."""
        return self._what(number, column, partner, upper=True, beyond=self.tracks[number + 1].q.shape[1])

    def _what(self, number: int, column: int, partner: int | None, *, upper: bool = False, beyond: int = 1) -> str:
        tracks, event = self.tracks[number], self.intervals[number][1 if upper else 0]
        point = self.plan.at(np.array([event]))[0]
        theta = tracks.q[-1 if upper else 0, column]
        reach = self.regional.size
        if np.hypot(point[0], point[1]) <= 1e-9 * reach:
            return "the tip is on the axis of joint 1, which is free there"
        terms = self.regional.determinant_terms(theta[2])
        if np.abs(terms).max() <= 1e8 * zero(self.regional):
            return "the tip is on the axis of joint 2, which is free there"
        if beyond == 0:
            return "the path leaves the workspace there: beyond it there is no posture at all"
        other = f"start posture {partner}" if partner is not None else "a posture that is not among the start postures"
        return f"it meets a singularity (det J = 0), where it merges with {other}"


def _wrapped(q: Array) -> Array:
    """Angles in (-pi, pi]."""
    return -circular(-q)


def _distance(a: Array, b: Array) -> Array:
    """How far rows a (m, 3) are from rows b (n, 3) in theta2 and theta3: (m, n); theta1 may be free."""
    found: Array = np.abs(circular(a[:, None, 1:] - b[None, :, 1:])).max(axis=-1)
    return found


def _matched(a: Array, b: Array) -> dict[int, int]:
    """Which row of b belongs to each row of a, nearest first; as many pairs as the shorter has rows."""
    from scipy.optimize import linear_sum_assignment

    if not len(a) or not len(b):
        return {}
    rows, columns = linear_sum_assignment(_distance(a, b))
    return dict(zip(rows.tolist(), columns.tolist(), strict=True))


def _meeting(tracks: Tracks, end: int) -> dict[int, int]:
    """Columns that meet another one at an end of the interval (0 or -1), and the one they meet."""
    count = tracks.q.shape[1]
    if count < 2 or tracks.s.size == 0:
        return {}

    def gaps(row: Array) -> Array:
        apart = np.abs(circular(row[:, None, 2] - row[None, :, 2]))
        np.fill_diagonal(apart, np.inf)
        return apart

    at_end, inside = gaps(tracks.q[end]), gaps(tracks.q[len(tracks.q) // 2])
    near = (at_end < MEETING) & (at_end < NEARER * inside)
    return {i: int(at_end[i].argmin()) for i in range(count) if near[i].any()}


def _over_event(before: Tracks, after: Tracks) -> tuple[dict[int, int], dict[int, int]]:
    """Over an event: which column each one becomes, and which ones meet which other one there."""
    meeting = _meeting(before, -1)
    if before.s.size == 0 or after.s.size == 0:
        return {}, meeting
    onward = _matched(before.q[-1], after.q[0])
    return onward, meeting
