"""Self-motion along a path of targets: how curves change, split, merge, appear and vanish, and which lead to the end.

Between two targets each curve is moved on: points of it are brought to the next target by the shortest correction, and
so are points of the next target's curves back to this one. Where both agree, one to one and every point, the curves are
the same ones, moved. Where they do not, the stretch between the targets is halved until they do, or until it is shorter
than the tolerance: there the curves change. Which curves took part is then seen from where points went.

The rule speaks of where an arm goes that is moved on by the shortest correction. At a singularity of a spherical joint,
two curves meet along a whole arc on which the joint's outer axes, in line, turn against one another: they part again
with the halves of that arc exchanged, which counts as a reconnection although each curve looks as before.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.held import Held, checked_targets, held_task, target_shape
from chainrule.self_motions.identity import Known
from chainrule.self_motions.projection import project
from chainrule.self_motions.result import Component, SelfMotion

Array = NDArray[Any]

#: Points of a curve that are moved on, and the share of them that has to arrive on another curve to count as a tie.
MOVED, TIE = 40, 0.06
#: The share of a curve that has to stay together for it to count as the same curve after touching another.
WHOLE = 0.85
#: A point that has to be moved farther than this, rad, is not counted: it may land anywhere.
NEAR = 1.0
#: Where a midpoint is taken: not the middle itself, so that no exact singular value is met by halving.
MIDDLE = 0.4871


@dataclass(frozen=True)
class Change:
    """Where curves change on the way.

    Attributes:
        at: where: 2.25 is a quarter of the way from target 2 to target 3.
        width: how closely that is known: the curves are unchanged outside ``at`` +- ``width`` / 2; 0 where it is exact.
        kind: "split", "merge", "reconnect" (as many after as before, parts of them exchanged), "appear", "vanish", or
            "touch": as many after as before, and 85 % or more of the points of each stayed together.
        before, after: labels of the curves it takes and those it leaves.
    """

    at: float
    width: float
    kind: str
    before: tuple[int, ...]
    after: tuple[int, ...]

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers."""
        return {
            "at": self.at,
            "width": self.width,
            "kind": self.kind,
            "before": list(self.before),
            "after": list(self.after),
        }


@dataclass(frozen=True)
class SelfMotionAlong:
    """The self-motions along a path.

    Attributes:
        targets: (k, ...) the targets.
        motions: at each target, as :func:`chainrule.self_motion` gives it (in the plane made when looked at).
        labels: at each target, the label of each of its curves, or with ``limits`` of each of its arcs: the same from
            target to target as long as a curve goes on by itself; empty where the target is singular.
        changes: where curves (or arcs) change, in order.
        count: (k,) number of curves, or of arcs.
        length: (k,) length of all of them together, rad.
    """

    targets: Array
    motions: Sequence[SelfMotion]
    labels: tuple[tuple[int, ...], ...]
    changes: tuple[Change, ...]
    count: Array
    length: Array

    @cached_property
    def families(self) -> tuple[int, ...]:
        """Labels of the curves that go on by themselves from the first target to the last."""
        return tuple(label for label in self.labels[0] if label in self.labels[-1])

    @property
    def followable(self) -> bool:
        """Whether the path can be followed on one family to its end."""
        return bool(self.families)

    def reached(self, curve: int) -> tuple[frozenset[int], ...]:
        """For each target, the labels on which a controller may be that starts on a curve of the first target.

        One label as long as the curve goes on by itself; after a split or reconnection several, since it depends on
        where on the curve the arm was; none where its curves have vanished (or the target is singular).

        Args:
            curve: index of the curve at the first target, from 0.
        """
        if curve not in range(len(self.labels[0])):
            raise InputError(f"curve: {shown(curve)}; 0 to {len(self.labels[0]) - 1} is accepted")
        reach, changes, found = {self.labels[0][curve]}, list(self.changes), []
        for k, labels in enumerate(self.labels):
            while changes and changes[0].at <= k:
                change = changes.pop(0)
                if reach & set(change.before):
                    reach = (reach - set(change.before)) | set(change.after)
            found.append(frozenset(reach & set(labels)))
        return tuple(found)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists, without the curves' points."""
        return {
            "targets": self.targets.tolist(),
            "count": self.count.tolist(),
            "lengths": [[curve.length for curve in motion.arcs] for motion in self.motions],
            "labels": [list(labels) for labels in self.labels],
            "complete": [motion.complete for motion in self.motions],
            "changes": [change.to_dict() for change in self.changes],
            "families": list(self.families),
        }


def self_motion_along(
    arm: Arm, targets: Any, task: str | None = None, *, tolerance: float = 1e-6, **options: Any
) -> SelfMotionAlong:
    """How the self-motion changes along a path of targets, joined by straight lines.

    Between targets positions and angles are interpolated linearly, rotations about one axis. For planar 3R arms (task
    "position", without limits) everything is known in closed form: the changes are where the path crosses a singular
    radius, numbers and lengths are those of :func:`chainrule.self_motion_map`. For all others changes are closed in on
    by halving, and two changes between neighbouring targets that undo each other are not seen: give more targets where
    that matters. With ``limits=True`` what is told apart and labelled are the arcs within the arm's joint limits, each
    of which an arm can run along without meeting a stop; an arc changes by splitting, merging, appearing or vanishing.

    Args:
        arm: as for :func:`chainrule.self_motion`.
        targets: (k, ...) two or more targets.
        task: what is held; the arm's default task when absent.
        tolerance: how closely changes are located, as a share of the way from one target to the next.
        options: of :func:`chainrule.self_motion`.

    Raises:
        InputError: fewer than two targets; what :func:`chainrule.self_motion` refuses.

    Example:
        >>> import chainrule as cr
        >>> along = cr.self_motion_along(cr.planar_3r(0.40, 0.35, 0.25), [[0.25, 0.0], [0.4, 0.0], [0.45, 0.0]])
        >>> along.count, along.labels
        (array([1, 2, 2]), ((0,), (1, 2), (1, 2)))
        >>> [(change.kind, round(change.at, 9)) for change in along.changes], along.followable
        ([('split', 0.333333333)], False)
    """
    task = held_task(arm, task)
    path, shape = checked_targets(arm, task, targets), target_shape(arm, task)
    if path.ndim != len(shape) + 1 or len(path) < 2:
        raise InputError(
            f"targets has shape {path.shape}; (k, {', '.join(map(str, shape))}) with k of 2 and more is accepted"
        )
    width = float(real_array(tolerance, "tolerance"))
    if not 0.0 < width < 1.0:
        raise InputError(f"tolerance: {shown(tolerance)}; a share between 0 and 1 is accepted")
    walk = _Walk(arm, task, path, max(width, 1e-12), options)
    return walk.result()


class _Walk:
    """The path, the self-motions on it, and the labels so far."""

    def __init__(self, arm: Arm, task: str, path: Array, width: float, options: dict[str, Any]) -> None:
        self.arm, self.task, self.path, self.width, self.options = arm, task, path, width, options
        self.held = Held(arm, task, float(options.get("scale", 1.0)))
        self.limited = bool(options.get("limits")) and bool(np.isfinite(arm.limits.position).any())
        self.changes: list[Change] = []
        self.fresh = 0

    def result(self) -> SelfMotionAlong:
        exact = self.exact()
        if self.closed:
            return self.mapped(exact)
        motions = [self.motion(float(k)) for k in range(len(self.path))]
        labels: list[tuple[int, ...]] = [()] * len(self.path)
        current: list[int] = []
        at, here = -1.0, _Here()
        for t in sorted({*map(float, range(len(self.path))), *self.around(exact)}):
            k = int(t)
            motion = motions[k] if t == k else self.motion(t)
            if motion.status == "singular":
                continue
            known = self.known(t, motion)
            first = at < 0.0
            current = [self.new() for _ in known.curves] if first else self.linked(at, here, t, known, current)
            if t == k:
                labels[k] = tuple(current)
            at, here = t, known
        self.changes = [self.placed(change, exact) for change in self.changes]
        every = [[curve.length for curve in motion.arcs] for motion in motions]
        count, length = np.array([len(each) for each in every]), np.array([math.fsum(each) for each in every])
        return SelfMotionAlong(self.path, tuple(motions), tuple(labels), tuple(self.changes), count, length)

    @cached_property
    def closed(self) -> bool:
        """Whether numbers, lengths and changes are known in closed form."""
        planar = isinstance(self.arm.description.geometry, Planar) and self.arm.kinds == "RRR"
        free = not self.limited and self.options.get("method") in (None, "closed form")
        return planar and self.task == "position" and free and bool((self.arm.parameters > 0.0).all())

    def mapped(self, exact: list[float]) -> SelfMotionAlong:
        """The path of a planar 3R arm. Between singular radii the curves stay as they are, listed in the same order."""
        from chainrule.self_motions.maps import self_motion_map
        from chainrule.self_motions.planar_case import SINGULAR

        places = sorted({*map(float, range(len(self.path))), *self.around(exact)})
        found = self_motion_map(self.arm, np.array([self.target(t) for t in places]))
        labels: list[tuple[int, ...]] = [()] * len(self.path)
        current: list[int] = []
        at, last, ahead = -1.0, -1.0, list(exact)
        for t, number, status in zip(places, found.number.tolist(), found.status.tolist(), strict=True):
            passed = [place for place in ahead if place < t]
            ahead = ahead[len(passed) :]
            last = passed[-1] if passed else last
            if status == SINGULAR:
                continue
            if at < 0.0:
                current = [self.new() for _ in range(number)]
            elif last >= at or number != len(current):
                current = self.crossed(at, t, current, number)
            if t == int(t):
                labels[int(t)] = tuple(current)
            at = t
        whole = np.searchsorted(places, np.arange(len(self.path)))
        length = np.where(found.number > 0, found.total, 0.0)[whole]
        self.changes = [self.placed(change, exact) for change in self.changes]
        motions = _Later(self.arm, self.task, self.path, self.options)
        return SelfMotionAlong(self.path, motions, tuple(labels), tuple(self.changes), found.number[whole], length)

    def crossed(self, t0: float, t1: float, labels: list[int], number: int) -> list[int]:
        """The labels behind a singular radius: one curve more or less, else (radii that coincide) as points move."""
        kinds = {(1, 2): "split", (2, 1): "merge", (0, 1): "appear", (1, 0): "vanish"}
        kind = kinds.get((len(labels), number))
        if kind is None:
            a, b = (self.known(t, self.motion(t)) for t in (t0, t1))
            return self.linked(t0, a, t1, b, labels)
        after = [self.new() for _ in range(number)]
        self.changes.append(Change(0.5 * (t0 + t1), t1 - t0, kind, tuple(labels), tuple(after)))
        return after

    # ---- targets -----------------------------------------------------------------------------------------------

    def target(self, t: float) -> Array:
        """The target at a place of the path."""
        k = min(int(t), len(self.path) - 2)
        u, (a, b) = t - k, self.path[k : k + 2]
        found = np.asarray(a + u * (b - a) if u not in (0.0, 1.0) else (b if u else a))
        if a.shape == (4, 4) and 0.0 < u < 1.0:
            from scipy.spatial.transform import Rotation

            turn = Rotation.from_matrix(b[:3, :3] @ a[:3, :3].T).as_rotvec()
            found[:3, :3] = Rotation.from_rotvec(u * turn).as_matrix() @ a[:3, :3]
        return found

    def motion(self, t: float) -> SelfMotion:
        """The self-motion at a place of the path."""
        return self_motion(self.arm, self.target(t), self.task, **self.options)

    def exact(self) -> list[float]:
        """Where the path crosses a singular radius, for planar 3R arms and task "position"."""
        if not self.closed:
            return []
        from chainrule.self_motions.planar_3r import singular_radii

        found = []
        for k, (a, b) in enumerate(zip(self.path[:-1], self.path[1:], strict=True)):
            d = b - a
            square, cross, along = float(d @ d), float(a[0] * d[1] - a[1] * d[0]), float(a @ d)
            if square == 0.0:
                continue
            for radius in singular_radii(self.arm.parameters):
                inside = radius**2 * square - cross**2
                if inside < 0.0:
                    continue
                for sign in (-1.0, 1.0) if inside > 0.0 else (0.0,):
                    u = (-along + sign * math.sqrt(inside)) / square
                    if 0.0 <= u <= 1.0:
                        found.append(k + u)
        return sorted(set(found))

    def around(self, exact: list[float]) -> list[float]:
        """Places just before and just after the exact ones, so that each has a step of its own."""
        last = float(len(self.path) - 1)
        return [t for place in exact for t in (place - self.width / 2, place + self.width / 2) if 0.0 <= t <= last]

    def placed(self, change: Change, exact: list[float]) -> Change:
        """A change at its exact place, where that is known."""
        near = [place for place in exact if abs(place - change.at) <= self.width]
        return replace(change, at=min(near, key=lambda p: abs(p - change.at)), width=0.0) if near else change

    # ---- curves ------------------------------------------------------------------------------------------------

    def new(self) -> int:
        self.fresh += 1
        return self.fresh - 1

    def known(self, t: float, motion: SelfMotion) -> _Here:
        known = Known(self.held, motion.target)
        curves = motion.arcs if self.limited else motion.components
        for curve in curves:
            known.add(curve)
        return _Here(known, curves)

    def linked(self, t0: float, a: _Here, t1: float, b: _Here, labels: list[int]) -> list[int]:
        """The labels at t1, given those at t0; changes between are recorded."""
        forward, backward = self.moved(a, b), self.moved(b, a)
        if _agree(forward, backward, 1 if self.limited else MOVED):
            return [labels[i] for i in np.argmax(backward, axis=1)] if len(backward) else []
        if t1 - t0 <= self.width:
            return self.changed(t0, t1, forward, backward.T, labels)
        for share in (MIDDLE, 0.5129, 0.4703):
            t = t0 + share * (t1 - t0)
            motion = self.motion(t)
            if motion.status != "singular":
                break
        else:
            return self.changed(t0, t1, forward, backward.T, labels)
        middle = self.known(t, motion)
        return self.linked(t, middle, t1, b, self.linked(t0, a, t, middle, labels))

    def moved(self, a: _Here, b: _Here) -> Array:
        """(curves of a, curves of b): how many points of each arrive on each."""
        counts = np.zeros((len(a.curves), len(b.curves)), int)
        if not counts.size:
            return counts
        places = (np.arange(MOVED) + 0.5) / MOVED
        parts = [curve.at(places) if len(curve.q) > 1 else np.repeat(curve.q[:1], MOVED, axis=0) for curve in a.curves]
        q = np.concatenate(parts)
        found, arrived = project(self.arm, q, b.known.target, self.task, scale=self.held.scale)
        near = np.linalg.norm((found - q) / self.held.unit, axis=1) < NEAR
        on = np.where(arrived & near, b.known.which(found), -1).reshape(len(parts), MOVED)
        for i, row in enumerate(on):
            np.add.at(counts[i], row[row >= 0], 1)
        return counts

    def changed(self, t0: float, t1: float, forward: Array, backward: Array, labels: list[int]) -> list[int]:
        """New labels after a change, group by group of curves that have to do with one another."""
        forward, backward = forward / MOVED, backward / MOVED
        ties = (forward >= TIE) | (backward >= TIE)
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        m, n = ties.shape
        i, j = np.nonzero(ties)
        graph = coo_array((np.ones(len(i)), (i, j + m)), shape=(m + n, m + n))
        _, group = connected_components(graph, directed=False)
        after = [-1] * n
        for each in np.unique(group):
            first, last = np.flatnonzero(group[:m] == each), np.flatnonzero(group[m:] == each)
            if len(first) == 1 and len(last) == 1:
                after[last[0]] = labels[first[0]]
                continue
            kept = _kept(forward[np.ix_(first, last)], backward[np.ix_(first, last)])
            if kept is not None:  # they only touched
                for old_one, new_one in zip(first, last[kept], strict=True):
                    after[new_one] = labels[old_one]
                touching = tuple(labels[k] for k in first)
                self.changes.append(Change(0.5 * (t0 + t1), t1 - t0, "touch", touching, touching))
                continue
            for k in last:
                after[k] = self.new()
            kind = (
                "appear" if not len(first) else "vanish" if not len(last)
                else "split" if len(first) < len(last) else "merge" if len(first) > len(last) else "reconnect"
            )  # fmt: skip
            old, new = tuple(labels[k] for k in first), tuple(after[k] for k in last)
            self.changes.append(Change(0.5 * (t0 + t1), t1 - t0, kind, old, new))
        return after


@dataclass
class _Here:
    """The curves at a place of the path."""

    known: Any = None
    curves: tuple[Component, ...] = ()


def _kept(forward: Array, backward: Array) -> Array | None:
    """For as many curves before as after, which one each became, if nearly all of it did; else None."""
    if forward.shape[0] != forward.shape[1]:
        return None
    there = forward.argmax(axis=1)
    n = np.arange(len(there))
    whole = (forward[n, there] >= WHOLE) & (backward[n, there] >= WHOLE)
    return there if whole.all() and len(set(there.tolist())) == len(there) else None


class _Later(Sequence[SelfMotion]):
    """Self-motions at the targets of a path, each made when it is first looked at."""

    def __init__(self, arm: Arm, task: str, targets: Array, options: dict[str, Any]) -> None:
        self._make: Callable[[int], SelfMotion] = lambda k: self_motion(arm, targets[k], task, **options)
        self._made: list[SelfMotion | None] = [None] * len(targets)

    def __len__(self) -> int:
        return len(self._made)

    @overload
    def __getitem__(self, k: int) -> SelfMotion: ...
    @overload
    def __getitem__(self, k: slice) -> tuple[SelfMotion, ...]: ...
    def __getitem__(self, k: int | slice) -> SelfMotion | tuple[SelfMotion, ...]:
        if isinstance(k, slice):
            return tuple(self[i] for i in range(*k.indices(len(self))))
        found = self._made[k]
        if found is None:
            found = self._made[k] = self._make(k)
        return found


def _agree(forward: Array, backward: Array, enough: int) -> bool:
    """Whether the points of each curve went to one curve, one to one, both ways, and enough of them to any.

    Of arcs within limits some points may leave the limits.
    """
    m, n = forward.shape
    if m != n:
        return False
    if m == 0:
        return True
    for counts in (forward, backward):
        if ((counts > 0).sum(axis=1) != 1).any() or (counts.sum(axis=1) < enough).any():
            return False
    there, back = forward.argmax(axis=1), backward.argmax(axis=1)
    return bool((back[there] == np.arange(m)).all())
