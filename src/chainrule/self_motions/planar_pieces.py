"""The pieces of a planar 3R arm's self-motion: whole curves, circles, loops and arcs between singular points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.self_motions import planar_case as deciding
from chainrule.self_motions.planar_case import REGULAR, SINGULAR, UNREACHABLE, Case, evaluator
from chainrule.self_motions.planar_path import Path, by_phi, by_theta, wrapped

Array = NDArray[Any]

TURN = 2.0 * math.pi
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


class Piece:
    """A curve before it is reported: a path, perhaps mirrored, shifted to the target.

    Attributes:
        path: None for an isolated point.
        sign: -1 for the mirror image.
        offset: (3,) added after mirroring.
        angles: (3, 2) least and greatest |angle| of q1 from the target's direction, q2, q3 (x_alpha: q1, q2, heading
            of link 2), where the curve is a whole closed one; else None.
        nested: whether it is one of two curves.
        one_sided: whether one triangle keeps the sign of its area on it, and phi stands for phi + pi as well.
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
        self.nested = self.one_sided = False
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
        return np.asarray(self.sign * TURN * np.rint(raw / TURN))

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
        piece.angles = angles
        piece.nested = piece.one_sided = number == 2
        found.append(piece)
    return tuple(found)


def _circles(case: Case, status: int) -> tuple[str, tuple[Piece, ...]]:
    """A length is 0: what it leaves free turns, the rest is a triangle (two, or one that is flat)."""
    which = zero_length(case)
    velocity = FREE[case.task][which]
    stops = evaluator(f"stops_{case.task}")(np.zeros(3), case.reach, case.lengths)[0]
    joint = int(np.flatnonzero(velocity)[0])
    speed = float(np.linalg.norm(velocity))
    name = "first joint free" if which == 3 else f"link {which + 1} of length 0"
    if which == 3:
        name = "free first joint"
    found = []
    for start in stops[2 * joint : 2 * joint + (1 if status == SINGULAR else 2)]:
        h = float(np.linalg.norm(_minors(case, start)))

        def evaluate(turn: Array, start: Array = start, h: float = h) -> tuple[Array, Array, Array]:
            q = wrapped(start + turn[..., None] * velocity)
            return q, np.full(turn.shape, h), np.full(turn.shape, speed)

        piece = Piece(case, Path(evaluate, 0.0, TURN), start)
        piece.velocity = velocity
        found.append(piece)
    detail = f"{name}, every posture singular" if status == SINGULAR else name
    return detail, tuple(found)


def _minors(case: Case, q: Array) -> Array:
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
    spans = {(True, False): ((0, 2),), (False, True): ((1, 3),), (True, True): ((0, 1), (1, 2))}
    pattern = evaluator(f"gaps_{case.task}")(case.reach, case.sums, case.lengths)[1]
    found = []
    for first, last in spans[top, bottom]:
        evaluate, width = by_phi(case, first), (last - first) * math.pi / 2.0
        near = evaluate(np.array([1e-7, width - 1e-7]))[0]
        ends = _flat(near)
        path = Path(evaluate, 0.0, width, (ends[0], ends[1]))
        for sign in (1.0, -1.0):  # the other triangle's area has the other sign on the mirror image
            piece = _piece(case, path, sign=sign, quarter=first)
            piece.one_sided = bool(pattern[0] == pattern[1])
            found.append(piece)
    if parallel:  # l1 = l2, l3 = r: link 2 folded back on link 1, which turns freely
        velocity, speed = np.array([1.0, 0.0, -1.0]), math.sqrt(2.0)
        for turned in (0.0, math.pi):
            start = np.array([turned, math.pi, -math.pi - turned])

            def evaluate_parallel(turn: Array, start: Array = start) -> tuple[Array, Array, Array]:
                q = start + turn[..., None] * velocity
                h = np.linalg.norm(_minors(case, q), axis=-1)
                return wrapped(q), h, np.full(turn.shape, speed)

            found.append(_piece(case, Path(evaluate_parallel, 0.0, math.pi), velocity=velocity))
    nodes = int(case.zero[1:4].sum() if case.task == "position" else case.zero[[2, 6]].sum())
    return CROSSINGS[nodes], tuple(found)


def _flat(q: Array) -> Array:
    """The flat posture next to q: every angle a multiple of pi."""
    found: Array = math.pi * np.rint(q / math.pi)
    return found


def _piece(
    case: Case, path: Path, sign: float = 1.0, quarter: int | None = None, velocity: Array | None = None
) -> Piece:
    """An arc between singular points, closed where it ends in the posture that it begins in."""
    moved = path.values[-1] - path.values[0]
    closed = bool(np.abs(wrapped(moved)).max() < 1e-6)
    piece = Piece(case, path, path.values[0], sign=sign, closed=closed)
    piece.ends = () if closed else ("singular", "singular")
    piece.quarter, piece.velocity = quarter, velocity
    return piece


def pieces_of(case: Case, status: int, number: int, nothing: int) -> tuple[str, tuple[Piece, ...]]:
    """The curves of a case, as :func:`planar_case.case_of` decided it, and what there is to say of them."""
    if number == 0:
        free = nothing if case.task == "position" else 2
        return ("", ()) if status == UNREACHABLE else (f"surface of dimension {3 if free == 4 else 2}", ())
    if nothing:
        return _circles(case, status)
    return ("", _loops(case, number)) if status == REGULAR else _pieces(case, number)


def zero_length(case: Case) -> int:
    """Which of l1, l2, l3, r (x_alpha: l1, l2) is 0."""
    sizes = [*case.lengths, case.reach[0]] if case.task == "position" else case.lengths[:2]
    return int(np.flatnonzero(np.asarray(sizes) == 0.0)[0])
