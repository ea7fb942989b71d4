"""Every self-motion of a planar 3R arm, in closed form: the number decided exactly, lengths to 1e-10 at any distance
from a singular radius.

Corrects and completes J. Lenarcic, "Some considerations on the self-motion curves of a planar 3R manipulator" (CIT 10,
2002): with the lengths sorted L >= M >= S, the circles |M + S - L|, L - M + S, L + M - S, L + M + S cut the workspace
into regions with 2 (0 if L > M + S), 1, 2, 1 and 0 curves; at the base point the first joint turns freely.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.inputs import whole_number
from chainrule.self_motions import planar_case as deciding
from chainrule.self_motions.planar_case import REGULAR, SINGULAR, STATUS, Case, evaluator
from chainrule.self_motions.planar_path import Path, by_phi, by_theta, wrapped
from chainrule.self_motions.result import Component, SelfMotion

Array = NDArray[Any]

TURN = 2.0 * math.pi
#: Nodes of the trapezoidal rule on the period, doubled until two lengths agree to this.
FIRST, LAST, AGREED = 32, 1 << 16, 1e-10
#: What a zero length leaves free: joint velocities along the circle, for the first, second, third length and r = 0.
FREE = {
    "position": np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "x_alpha": np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0]]),
}
CROSSINGS = {
    1: "figure of eight",
    2: "two closed curves that meet at two points",
    3: "three closed curves, each two of which meet at a point",
}


def singular_radii(lengths: Any) -> Array:
    """The distances from the base at which self-motions of a planar 3R arm (task "position") are singular, rising.

    Args:
        lengths: (3,) m, in any order, not negative.

    Returns:
        |M + S - L|, L - M + S, L + M - S and L + M + S for the lengths L >= M >= S; equal ones once.

    Raises:
        InputError: other than three lengths of 0 and more.

    Example:
        >>> singular_radii([0.40, 0.35, 0.25]).round(12)
        array([0.2, 0.3, 0.5, 1. ])
        >>> singular_radii([1.0, 1.0, 1.0])
        array([1., 3.])
    """
    found = deciding.checked_lengths(lengths)
    if found.shape != (3,):
        raise InputError(f"lengths: shape {found.shape}; (3,) is accepted")
    s, m, l = sorted(float(length) for length in found)  # noqa: E741
    return np.unique([abs(math.fsum([m, s, -l])), math.fsum([l, -m, s]), math.fsum([l, m, -s]), math.fsum([l, m, s])])


def singular_values(lengths: Any, alpha: float) -> Array:
    """The values of x at which self-motions of a planar 3R arm (task "x_alpha") are singular, rising.

    Args:
        lengths: (3,) m, not negative.
        alpha: the direction held, rad.

    Returns:
        l3 cos alpha +- l1 +- l2; equal ones once.

    Raises:
        InputError: other than three lengths of 0 and more, or an alpha that is not finite.

    Example:
        >>> singular_values([0.40, 0.35, 0.25], 0.0).round(12)
        array([-0.5,  0.2,  0.3,  1. ])
    """
    found = deciding.checked_lengths(lengths)
    held = deciding.checked_targets([0.0, alpha])[1]
    if found.shape != (3,):
        raise InputError(f"lengths: shape {found.shape}; (3,) is accepted")
    middle = float(found[2]) * math.cos(held)
    return np.unique([math.fsum([middle, i * found[0], j * found[1]]) for i in (-1, 1) for j in (-1, 1)])


@cache
def nodes(count: int) -> Array:
    """Points (count, 2) of half a turn: cosine and sine of k pi / count."""
    theta = np.arange(count) * (math.pi / count)
    return np.stack([np.cos(theta), np.sin(theta)], axis=-1)


@cache
def _between(count: int) -> Array:
    """The points of ``nodes(2 count)`` that are not in ``nodes(count)``."""
    return np.ascontiguousarray(nodes(2 * count)[1::2])


def half_length(reach: Array, sums: Array, lengths: Array, task: str) -> float:
    """Half the length of a regular self-motion's curves together: one of two, or half of one.

    The trapezoidal rule over the period of an analytic integrand: its error falls geometrically.
    """
    speed = evaluator(f"speed_{task}")
    count = FIRST
    both = speed(nodes(count), reach, sums, lengths)
    even, total = float(both[::2].sum()) * 2.0, float(both.sum())
    while abs(total - even) > AGREED * total and count < LAST:
        more = float(speed(_between(count), reach, sums, lengths).sum())
        even, total, count = 2.0 * total, total + more, 2 * count
    return total * (math.pi / count)


def planar_lengths(arm: Arm, target: Any, task: str = "position") -> tuple[str, tuple[float, ...]]:
    """Status and the length of each self-motion curve of a planar 3R arm, rad, without the curves themselves.

    Raises:
        InputError: as :func:`planar_self_motion`.

    Example:
        >>> from chainrule import planar_3r
        >>> status, lengths = planar_lengths(planar_3r(0.40, 0.35, 0.25), [0.1, 0.0])
        >>> status, len(lengths), round(lengths[0], 9)
        ('regular', 2, 6.752948361)
    """
    task = deciding.checked_task(task)
    case, status, number, nothing = _case(arm, target, task)
    if status != REGULAR:
        found = planar_self_motion(arm, target, task)
        return found.status, tuple(part.length for part in found.components)
    if nothing:
        length = TURN * float(np.linalg.norm(FREE[task][_zero_length(case)]))
        return STATUS[status], (length,) * number
    half = half_length(case.reach, case.sums, case.lengths, task)
    return STATUS[status], (half, half) if number == 2 else (2.0 * half,)


def _case(arm: Arm, target: Any, task: str) -> tuple[Case, int, int, int]:
    lengths = deciding.planar_lengths_of(arm)
    where = deciding.checked_targets(target)
    if where.shape != (2,):
        raise InputError(f"target: shape {where.shape}; (2,) is accepted; for many targets see self_motion_map")
    return deciding.case_of(lengths, where, task)


def _zero_length(case: Case) -> int:
    """Which of l1, l2, l3, r (x_alpha: l1, l2) is 0."""
    sizes = [*case.lengths, case.reach[0]] if case.task == "position" else case.lengths[:2]
    return int(np.flatnonzero(np.asarray(sizes) == 0.0)[0])


def planar_self_motion(
    arm: Arm, target: Any, task: str = "position", *, points: int = 129, limits: bool = True
) -> SelfMotion:
    """Every self-motion curve of a planar 3R arm at a target.

    Args:
        arm: a planar arm with three revolute joints; lengths may be 0 or equal.
        target: (2,) x and y, m; or for the task "x_alpha" x, m, and the last link's direction alpha, rad.
        task: "position" or "x_alpha".
        points: how many points of each curve to give, evenly spaced; any others by ``Component.at``.
        limits: whether to find the parts within the arm's joint limits (:attr:`SelfMotion.feasible`), if it has any.

    Returns:
        Status "regular" with one or two closed curves; "singular" with the pieces between singular points (loops of a
        figure of eight, arcs), an isolated point, or nothing but its name where the set is a surface; "unreachable".
        Joint 1 is unwrapped from the target's direction. Two curves are mirror images, equally long; the signs that
        each keeps are those of sin q2, sin q3, sin(q2 + q3) and of the headings relative to the target's direction
        ("q1-direction", "q1+q2-direction", "q1+q2+q3-direction"), or for x_alpha sin q1 or sin(q1 + q2).

    Raises:
        InputError: another arm, a negative length, a target or task that is not accepted.

    Example:
        >>> from chainrule import planar_3r
        >>> found = planar_self_motion(planar_3r(0.40, 0.35, 0.25), [0.4, 0.0])
        >>> found.count, round(found.components[0].length, 9), dict(found.components[0].signs)
        (2, 8.238309624, {'q2': 1, 'q1-direction': -1, 'q1+q2-direction': 1})
    """
    task, points = deciding.checked_task(task), whole_number(points, "points", 2)
    case, status, number, nothing = _case(arm, target, task)
    where = deciding.checked_targets(target)
    detail, parts = "", ()
    if number and nothing:
        detail, parts = _circles(case, status)
    elif status == REGULAR:
        parts = _loops(case, number)
    elif status == SINGULAR:
        detail, parts = _pieces(case, number)
    finish = partial(_component, arm, where, task, points)
    components = tuple(finish(part) for part in parts)
    feasible = None
    if limits and np.isfinite(arm.limits.position).any():
        from chainrule.self_motions import planar_limits

        feasible = tuple(planar_limits.feasible(case, parts, arm.limits.position, finish))
    return SelfMotion(
        arm=arm.name,
        task=task,
        target=where,
        method="closed form",
        status=STATUS[status],
        components=components,
        complete="proved",
        detail=detail,
        feasible=feasible,
        to_singular=_to_singular(arm, where, task),
    )


def _to_singular(arm: Arm, target: Array, task: str) -> float:
    """Distance of the target to the nearest singular value, m."""
    if task == "x_alpha":
        return float(np.abs(singular_values(arm.parameters, float(target[1])) - target[0]).min())
    return float(np.abs(singular_radii(arm.parameters) - math.hypot(*target)).min())


class Piece:
    """A curve before it is reported: a path, perhaps mirrored, shifted to the target.

    Attributes:
        path: None for an isolated point.
        sign: -1 for the mirror image.
        offset: (3,) added after mirroring.
        angles: (3, 2) least and greatest |angle| of q1 from the target's direction, q2, q3 (x_alpha: q1, q2, heading
            of link 2), where the curve is a whole closed one; else None.
        nested: whether it is one of two curves.
        quarter: where phi is the path's parameter (singular self-motions), how many quarter turns it is counted from.
        velocity: (3,) where the joints move in proportion to the parameter (circles); else None.
        begin, rounds: where it begins on the path and how much of it it runs through, in lengths of the path.
        shift: (3,) whole turns that the joint values are moved by.
        of, span, ends: as of :class:`Component`.
    """

    def __init__(self, case: Case, path: Path | None, start: Array, *, sign: float = 1.0, closed: bool = True) -> None:
        self.case, self.path, self.start, self.sign, self.closed = case, path, start, sign, closed
        self.offset = case.offset
        self.begin, self.rounds = 0.0, 1.0
        self.quarter: int | None = None
        self.velocity: Array | None = None
        self.angles: Array | None = None
        self.nested = False
        self.of: int | None = None
        self.span = (0.0, 1.0)
        self.ends: tuple[str, ...] = ()
        self.shift = np.zeros(3)

    @property
    def length(self) -> float:
        """Length, rad."""
        return 0.0 if self.path is None else self.path.length * self.rounds

    @property
    def advance(self) -> Array:
        """What one round of the whole path adds to the joint values."""
        assert self.path is not None
        raw = self.path.values[-1] - self.path.values[0]
        return self.sign * TURN * np.rint(raw / TURN)

    def joints(self, fractions: Array) -> Array:
        """Joint values (..., 3) at fractions (...,) of the length."""
        if self.path is None:
            return np.broadcast_to(self.sign * self.start + self.offset, (*np.shape(fractions), 3)).copy()
        return self.at_parameter(*self.located(fractions))

    def located(self, fractions: Array) -> tuple[Array, Array]:
        """Whole rounds and the path's parameter at fractions of the length."""
        assert self.path is not None
        along = self.begin + np.asarray(fractions, float) * self.rounds
        whole = np.floor(along)
        whole = np.where((along == whole) & (along == self.begin + self.rounds) & (along > 0.0), whole - 1.0, whole)
        return whole, self.path.parameter_at((along - whole) * self.path.length)

    def at_parameter(self, whole: Array, parameter: Array) -> Array:
        """Joint values at parameters of the path, ``whole`` rounds on."""
        assert self.path is not None
        raw = self.path.joints_at(parameter)
        found: Array = self.sign * raw + self.offset + self.shift
        return found + whole[..., None] * self.advance if np.any(whole) else found


def _loops(case: Case, number: int) -> tuple[Piece, ...]:
    """One closed curve, or two that are mirror images."""
    path = Path(by_theta(case), 0.0, math.pi if number == 2 else TURN)
    angles = evaluator(f"extremes_{case.task}")(case.reach, case.sums, case.lengths)
    found = []
    for sign in (1.0, -1.0)[:number]:
        piece = Piece(case, path, path.values[0], sign=sign)
        piece.angles, piece.nested = angles, number == 2
        found.append(piece)
    return tuple(found)


def _circles(case: Case, status: int) -> tuple[str, tuple[Piece, ...]]:
    """A length is 0: what it leaves free turns, the rest is a triangle (two, or one that is flat)."""
    which = _zero_length(case)
    velocity = FREE[case.task][which]
    stops = evaluator(f"stops_{case.task}")(np.zeros(3), case.reach, case.lengths)[0]
    joint = int(np.flatnonzero(velocity)[0])
    speed = float(np.linalg.norm(velocity))
    name = "first joint free" if which == 3 else f"link {which + 1} of length 0"
    if which == 3:
        name = "free first joint"
    found = []
    for start in stops[2 * joint : 2 * joint + (1 if status == SINGULAR else 2)]:
        h = float(np.linalg.norm(evaluators_minors(case, start)))

        def evaluate(turn: Array, start: Array = start, h: float = h) -> tuple[Array, Array, Array]:
            q = wrapped(start + turn[..., None] * velocity)
            return q, np.full(turn.shape, h), np.full(turn.shape, speed)

        piece = Piece(case, Path(evaluate, 0.0, TURN), start)
        piece.velocity = velocity
        found.append(piece)
    detail = f"{name}, every posture singular" if status == SINGULAR else name
    return detail, tuple(found)


def evaluators_minors(case: Case, q: Array) -> Array:
    """The minors of the scaled arm's Jacobian."""
    minors = deciding.evaluators().get(case.task, f"minors_{case.task}")
    assert minors is not None
    lengths = case.lengths if case.task == "position" else np.array([*case.lengths[:2], 0.0])
    found: Array = minors(q, lengths)
    return found


def _pieces(case: Case, number: int) -> tuple[str, tuple[Piece, ...]]:
    """The self-motion at a singular value: an isolated point, or what lies between the flat postures on it."""
    if number == 1:
        point = evaluator(f"point_{case.task}")(np.array([1.0, 0.0]), case.reach, case.sums, case.lengths)[0]
        return "isolated point", (Piece(case, None, _flat(point), closed=False),)
    if case.task == "position":
        top, bottom = bool(case.zero[1]), bool(case.zero[2] or case.zero[3])
        parallel = bool(case.zero[2] and case.zero[3])
    else:
        top, bottom, parallel = bool(case.zero[2]), bool(case.zero[6]), False
    # flat postures at x = b (phi = 0, pi) where a = b, at x = c (phi = pi/2, 3 pi/2) where c = d
    spans = {
        (True, False): ((0, 2), (2, 4)),
        (False, True): ((1, 3), (3, 5)),
        (True, True): ((0, 1), (1, 2), (2, 3), (3, 4)),
    }
    found = []
    for first, last in spans[top, bottom]:
        evaluate, width = by_phi(case, first), (last - first) * math.pi / 2.0
        near = evaluate(np.array([1e-7, width - 1e-7]))[0]
        ends = _flat(near)
        found.append(_piece(case, Path(evaluate, 0.0, width, (ends[0], ends[1])), quarter=first))
    if parallel:  # l1 = l2, l3 = r: link 2 folded back on link 1, which turns freely
        velocity, speed = np.array([1.0, 0.0, -1.0]), math.sqrt(2.0)
        for first in (0.0, math.pi):
            start = np.array([first, math.pi, -math.pi - first])

            def evaluate_parallel(turn: Array, start: Array = start) -> tuple[Array, Array, Array]:
                q = start + turn[..., None] * velocity
                h = np.linalg.norm(evaluators_minors(case, q), axis=-1)
                return wrapped(q), h, np.full(turn.shape, speed)

            found.append(_piece(case, Path(evaluate_parallel, 0.0, math.pi), velocity=velocity))
    nodes = int(case.zero[1:4].sum() if case.task == "position" else case.zero[[2, 6]].sum())
    return CROSSINGS[nodes], tuple(found)


def _flat(q: Array) -> Array:
    """The flat posture next to q: every angle a multiple of pi."""
    found: Array = math.pi * np.rint(q / math.pi)
    return found


def _piece(case: Case, path: Path, quarter: int | None = None, velocity: Array | None = None) -> Piece:
    """An arc between singular points, closed where it ends in the posture that it begins in."""
    moved = path.values[-1] - path.values[0]
    closed = bool(np.abs(wrapped(moved)).max() < 1e-6)
    piece = Piece(case, path, path.values[0], closed=closed)
    piece.ends = () if closed else ("singular", "singular")
    piece.quarter, piece.velocity = quarter, velocity
    return piece


def _component(arm: Arm, target: Array, task: str, points: int, piece: Piece) -> Component:
    """What is reported of a curve or an arc."""
    if piece.path is None or piece.length == 0.0:
        q = piece.joints(np.zeros(1))
        box, h = np.stack([q[0], q[0]], axis=-1), (float(arm.manipulability(q, task=task)[0]),) * 2
        closed, winding, closure = False, np.zeros(3, int), math.nan
    else:
        q = piece.joints(np.linspace(0.0, 1.0, points))
        h = _range_of_h(piece)
        box = _box(piece, q)
        closed = piece.closed
        winding = np.rint((q[-1] - q[0]) / TURN).astype(int) if closed else np.zeros(3, int)
        closure = 0.0 if closed else math.nan
    return Component(
        q=q,
        length=piece.length,
        closed=closed,
        winding=winding,
        box=box,
        manipulability=h,
        residual=_residual(arm, q, target, task),
        closure=closure,
        ends=piece.ends,
        signs=_signs(piece),
        of=piece.of,
        span=piece.span,
        points=piece.joints,
    )


def _residual(arm: Arm, q: Array, target: Array, task: str) -> float:
    place = arm.position(q)
    if task == "position":
        return float(np.linalg.norm(place - target, axis=-1).max())
    return float(max(np.abs(place[..., 0] - target[0]).max(), np.abs(wrapped(q.sum(axis=-1) - target[1])).max()))


def _range_of_h(piece: Piece) -> tuple[float, float]:
    """Least and greatest H: its local extremes, closed in on."""
    low, high = _over(piece, lambda parameter, path: path.evaluate(parameter)[1])
    return low * piece.case.scale_of_h, high * piece.case.scale_of_h


def _over(piece: Piece, function: Callable[[Array, Path], Array]) -> tuple[float, float]:
    """Extremes of a function of the parameter over the piece, end points included."""
    path = piece.path
    assert path is not None
    if piece.rounds >= 1.0:
        return path.extremes(partial(function, path=path))
    whole, ends = piece.located(np.array([0.0, 1.0]))
    if whole[0] == whole[1]:
        return between(path, ends[0], ends[1], function)
    low1, high1 = between(path, ends[0], path.end, function)
    low2, high2 = between(path, path.start, ends[1], function)
    return min(low1, low2), max(high1, high2)


def between(path: Path, first: float, last: float, function: Callable[[Array, Path], Array]) -> tuple[float, float]:
    """Extremes between two parameters of a path."""
    part = object.__new__(Path)
    part.start, part.end, part.edges = float(first), float(last), path.edges
    return part.extremes(partial(function, path=path))


def _box(piece: Piece, q: Array) -> Array:
    """Range of each unwrapped joint: in closed form on whole curves, else from its extremes along the piece."""
    low, high = q.min(axis=0), q.max(axis=0)
    if piece.angles is None or piece.rounds != 1.0 or not piece.closed:
        if piece.rounds > 1.0 or piece.path is None:
            return np.stack([low, high], axis=-1)
        found = []
        for joint in range(3):
            if piece.closed and abs(piece.advance[joint]) > 1.0:
                found.append(sorted((q[0, joint], q[0, joint] + piece.advance[joint])))
                continue
            ends = piece.joints(np.array([0.0, 1.0]))[:, joint]
            middle = (low[joint] + high[joint]) / 2.0
            values = _over(piece, lambda p, path, j=joint: piece.sign * path.joints_at(p)[..., j])  # type: ignore[misc]
            moved = piece.offset[joint] + piece.shift[joint]
            pair = np.sort(np.array(values)) + moved
            pair += TURN * np.rint((middle - pair.mean()) / TURN)
            found.append([min(pair[0], ends.min()), max(pair[1], ends.max())])
        return np.array(found)
    found = []
    for joint in range(3):
        least, most = piece.angles[joint]
        if abs(piece.advance[joint]) > 1.0:
            found.append(sorted((q[0, joint], q[0, joint] + piece.advance[joint])))
            continue
        heading = piece.case.task == "x_alpha" and joint == 2  # q3 = alpha - heading
        if least == 0.0:
            pair = np.array([-most, most])
        elif most == math.pi:
            pair = np.array([least, TURN - least])
        else:
            side = math.sin(float(q[0, joint] - piece.offset[joint])) * (-1.0 if heading else 1.0)
            pair = np.array([least, most]) if side > 0.0 else np.array([-most, -least])
        pair = np.sort(-pair if heading else pair) + piece.offset[joint]
        pair += TURN * np.rint(((low[joint] + high[joint]) / 2.0 - pair.mean()) / TURN)
        found.append(list(pair))
    return np.array(found)


def _signs(piece: Piece) -> dict[str, int]:
    """The sines that keep their sign on one of two curves: of angles between links none of which is the shortest."""
    if not piece.nested or piece.path is None:
        return {}
    q1, q2, q3 = piece.sign * piece.path.values[0]
    if piece.case.task == "x_alpha":
        headings = {"q1": q1, "q1+q2": q1 + q2}
        rolls = piece.path.values[-1] - piece.path.values[0]
        return {
            name: int(math.copysign(1.0, math.sin(angle)))
            for name, angle in headings.items()
            if abs(rolls[0] if name == "q1" else rolls[0] + rolls[1]) < 1.0
        }
    links = [*piece.case.lengths, piece.case.reach[0]]
    shortest = int(np.argmin(links))
    angles = {
        "q2": (0, 1, q2),
        "q3": (1, 2, q3),
        "q2+q3": (0, 2, q2 + q3),
        "q1-direction": (0, 3, q1),
        "q1+q2-direction": (1, 3, q1 + q2),
        "q1+q2+q3-direction": (2, 3, q1 + q2 + q3),
    }
    return {
        name: int(math.copysign(1.0, math.sin(angle)))
        for name, (i, j, angle) in angles.items()
        if shortest not in (i, j)
    }
