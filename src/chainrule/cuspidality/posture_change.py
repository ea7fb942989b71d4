"""From one posture to another without a singularity: a smooth joint path with a proof, or why there is none.

A path exists exactly where both postures are in one aspect (:mod:`chainrule.cuspidality.aspects`). It is found along
the aspect's spine: for one theta3 the sign s of det J = a cos(theta2) + b sin(theta2) + c is held best at
theta2 = atan2(s b, s a), where s det J = s c + sqrt(a^2 + b^2). Going to the spine, along it and off it again, s det J
is never less than at the worse of the two postures or in the narrowest place that every path has to pass. That path is
then tightened like an elastic band that the singularities push away, as long as it keeps three quarters of that.

The path is a cubic B-spline, twice continuously differentiable. The sign of det J is proved along all of it in ball
arithmetic: every polynomial piece is cut until the generated det J, run on balls that hold the piece, keeps away from
zero (:mod:`chainrule.cuspidality.certified_path`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.balls import exact
from chainrule.cuspidality.aspects import TURN, Aspect, aspect_of, aspects, zero
from chainrule.cuspidality.certified_path import SignProof, bezier, certify_sign, knots, sample
from chainrule.cuspidality.normal_form import Regional
from chainrule.errors import InputError
from chainrule.inputs import real_array

Array = NDArray[Any]

#: Control points of the first spline tried, and of the last: each has twice as many as the one before.
CONTROL_POINTS, MOST_CONTROL_POINTS = 48, 12288
#: Places on the spine that are looked at, rounds of tightening, and how hard the singularities push.
PLACES, ROUNDS, PUSH = 1024, 80, 0.3
#: The share of the best possible min |det J| that tightening leaves.
KEPT = 0.75
#: Two postures reach one point if they reach it to this share of the arm's size.
SAME = 1e-9
#: Degree of the spline.
DEGREE = 3


@dataclass(frozen=True)
class PostureChange:
    """The answer to: can the arm go from one configuration to the other without meeting a singularity?

    Any two configurations may be asked about: what counts is whether they are in one aspect. It is a change of posture
    where both reach one point (:attr:`same_point`).

    Attributes:
        start: (3,) rad, the posture the path begins at.
        goal: (3,) rad, the posture it ends at, up to whole turns.
        path: (k, 3) rad, the control points of the path's cubic B-spline, unwrapped; None where there is no path.
        reason: why there is no path, in words; empty where there is one.
        sign: of det J along the path; 0 where there is none.
        certified: whether the sign of det J was proved along the whole path.
        smallest_determinant: a lower bound of |det J| along the path, proved if ``certified``, m^3; 0 without a path.
        pieces: into how many pieces the proof cut the path.
    """

    start: Array
    goal: Array
    path: Array | None
    reason: str
    sign: int
    certified: bool
    smallest_determinant: float
    pieces: int
    _regional: Regional = field(repr=False)

    @property
    def knots(self) -> Array | None:
        """The spline's knots in s (k + 4,), from 0 to 1; None where there is no path."""
        return None if self.path is None else knots(len(self.path), DEGREE) / (len(self.path) - DEGREE)

    @property
    def exists(self) -> bool:
        """Whether there is a path."""
        return self.path is not None

    @property
    def same_point(self) -> bool:
        """Whether start and goal reach one point, to 1e-9 of the arm's size: two postures of it."""
        start, goal = self._regional.point(self._regional.to_normal(np.stack([self.start, self.goal])))
        return bool(np.abs(goal - start).max() <= SAME * self._regional.size)

    def sample(self, s: Any, derivative: int = 0) -> Array:
        """The configurations q (..., 3) at ``s`` (...) from 0 to 1, or their derivative by s.

        Raises:
            InputError: there is no path; ``s`` outside 0 to 1; a derivative that is not 0, 1 or 2.
        """
        if self.path is None:
            raise InputError(f"there is no path: {self.reason}")
        given = real_array(s, "s")
        if ((given < 0.0) | (given > 1.0)).any():
            raise InputError("s: from 0 to 1 is accepted")
        if derivative not in (0, 1, 2):
            raise InputError(f"derivative: {derivative!r}; 0, 1 or 2 is accepted")
        return sample(self.path, DEGREE, given, derivative)

    def image(self, count: int = 400) -> Array:
        """The path's (rho, z) in the cross-section of the workspace, (count, 2) in m: it passes round the cusp."""
        theta = self._regional.to_normal(self.sample(np.linspace(0.0, 1.0, count)))
        return self._regional.image(theta[..., 1], theta[..., 2])

    def encircled(self, points: Any) -> Array:
        """How often the path's image runs round each of ``points`` (k, 2) of the cross-section: (k,), left positive.

        Meaningful where both postures reach the same point (:attr:`same_point`), so that the image is closed; the cusp
        it runs round is what makes the change possible.
        """
        around = self.image(2000)[None] - real_array(points, "points").reshape(-1, 1, 2)
        turned = np.unwrap(np.arctan2(around[..., 1], around[..., 0]), axis=-1)
        found: Array = np.rint((turned[:, -1] - turned[:, 0]) / TURN).astype(int)
        return found

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "start": self.start.tolist(),
            "goal": self.goal.tolist(),
            "exists": self.exists,
            "same_point": self.same_point,
            "path": None if self.path is None else self.path.tolist(),
            "knots": None if (found := self.knots) is None else found.tolist(),
            "reason": self.reason,
            "sign": self.sign,
            "certified": self.certified,
            "smallest_determinant": self.smallest_determinant,
            "pieces": self.pieces,
        }


def posture_change(regional: Regional, a: Any, b: Any) -> PostureChange:
    """A smooth path from configuration ``a`` to ``b`` (3,) that meets no singularity, or why there is none.

    They need not reach one point: any two configurations of one aspect can be joined.

    Joint limits play no part; joint 1, which has no part in det J, goes the shorter way.

    Raises:
        InputError: ``a`` or ``b`` is not three finite numbers.
    """
    start, goal = (_configuration(q, name) for q, name in ((a, "a"), (b, "b")))
    labels = aspect_of(regional, np.stack([start, goal]))
    every = aspects(regional)
    if (labels < 0).any() or labels[0] != labels[1]:
        reason = _why_not(regional, start, goal, labels, every)
        return PostureChange(start, goal, None, reason, 0, False, 0.0, 0, regional)
    aspect = every[labels[0]]
    theta = regional.to_normal(np.stack([start, goal]))
    line = _way(regional, aspect, theta)
    best = _least(regional, aspect.sign, line)
    count = CONTROL_POINTS
    while True:
        points = _evenly(line, count)
        for candidate in (_tightened(regional, aspect.sign, points, KEPT * best), points):
            control = _in_joints(start, goal, (candidate - theta[0, 1:]) * regional.signs[1:])
            proof = certified(regional, control)
            if proof.certified:
                break
        if proof.certified or count >= MOST_CONTROL_POINTS:
            break
        count *= 2
    return PostureChange(
        start, goal, control, "", aspect.sign, proof.certified, proof.lower_bound, proof.pieces, regional
    )


def _configuration(q: Any, name: str) -> Array:
    found = real_array(q, name)
    if found.shape != (3,):
        raise InputError(f"{name}: an array of shape {found.shape}; the three joint angles (3,) are accepted")
    return found


# ---- why there is none ---------------------------------------------------------------------------------------------


def _why_not(regional: Regional, start: Array, goal: Array, labels: Array, every: tuple[Aspect, ...]) -> str:
    """In words."""
    theta = regional.to_normal(np.stack([start, goal]))
    dets = regional.determinant(theta[:, 1], theta[:, 2])
    singular = [name for name, label in zip(("start", "goal"), labels, strict=True) if label < 0]
    if singular:
        which = " and ".join(f"the {name}" for name in singular)
        return f"{which} is itself singular: det J = 0 to within rounding"
    if dets[0] * dets[1] < 0.0:
        words = ["positive" if det > 0.0 else "negative" for det in dets]
        return f"det J is {words[0]} at the start and {words[1]} at the goal, so that every path passes det J = 0"
    first, second = (every[label] for label in labels)
    walls = _walls(regional, first, second)
    return (
        f"the postures are in different aspects: wherever det J is {'positive' if first.sign > 0 else 'negative'}, "
        f"theta3 stays between {_degrees(first.theta3)} in one and {_degrees(second.theta3)} in the other; {walls}"
    )


def _degrees(interval: tuple[float, float]) -> str:
    return f"{math.degrees(interval[0]):.2f} and {math.degrees(interval[1]):.2f} deg"


def _walls(regional: Regional, first: Aspect, second: Aspect) -> str:
    """What separates two aspects of one sign: singular lines of the joint space, or the singular curve."""
    offset = -regional.offsets[2]
    lines = []
    for end in {*first.theta3, *second.theta3}:
        a, b, c = regional.determinant_terms(np.array(end - offset))
        if max(abs(a), abs(b), abs(c)) <= 1e6 * zero(regional):
            lines.append(end)
    if not lines:
        return "the singular curve det J = 0 lies between them"
    angles = " and ".join(f"{math.degrees(math.remainder(line, TURN)):.2f} deg" for line in sorted(lines))
    return f"between them are the singular lines theta3 = {angles}, where the tip is on the axis of joint 2"


# ---- the way along the spine ---------------------------------------------------------------------------------------


def _way(regional: Regional, aspect: Aspect, theta: Array) -> Array:
    """The better of the ways from one posture to the other in (theta2, theta3): (k, 2), unwrapped."""
    begin, end = theta[0, 2], theta[1, 2]
    if aspect.whole:
        turn = math.remainder(end - begin, TURN)
        ways = [turn, turn - math.copysign(TURN, turn)]
    else:
        offset = -regional.offsets[2]
        lower = aspect.theta3[0] - offset
        ways = [float(np.remainder(end - lower, TURN) - np.remainder(begin - lower, TURN))]
    lines = [_along_spine(regional, aspect.sign, theta, turn) for turn in ways]
    least = [_least(regional, aspect.sign, line) for line in lines]
    return lines[1] if len(lines) > 1 and least[1] > 2.0 * least[0] else lines[0]


def _along_spine(regional: Regional, sign: int, theta: Array, turn: float) -> Array:
    """To the spine, along it while theta3 advances by ``turn``, and off it."""
    share = np.linspace(0.0, 1.0, PLACES)
    for _ in range(12):  # more places where the spine is steep
        theta3 = theta[0, 2] + turn * share
        theta2 = _spine(regional, sign, theta3, theta[0, 1], theta[1, 1])
        steep = np.flatnonzero(np.abs(np.diff(theta2)) > 0.05)
        if not steep.size or share.size > 64 * PLACES:
            break
        share = np.sort(np.concatenate([share, 0.5 * (share[steep] + share[steep + 1])]))
    on = theta2[0] - math.remainder(theta2[0] - theta[0, 1], TURN)  # the start's theta2, next to the spine
    off = theta2[-1] - math.remainder(theta2[-1] - theta[1, 1], TURN)
    to, back = np.linspace(0.0, 1.0, 64, endpoint=False), np.linspace(1.0, 0.0, 65)[1:]
    line = np.concatenate(
        [
            np.stack([on + (theta2[0] - on) * to, np.full(64, theta3[0])], axis=-1),
            np.stack([theta2, theta3], axis=-1),
            np.stack([off + (theta2[-1] - off) * back, np.full(64, theta3[-1])], axis=-1),
        ]
    )
    line[:, 0] += theta[0, 1] - on
    return line


def _spine(regional: Regional, sign: int, theta3: Array, first: float, last: float) -> Array:
    """theta2 on the spine, unwrapped; where every theta2 has the sign, evenly from one arc to the next."""
    a, b, c = np.moveaxis(regional.determinant_terms(theta3), -1, 0)
    arc = np.hypot(a, b) > sign * c
    if not arc.any():
        return first + math.remainder(last - first, TURN) * np.linspace(0.0, 1.0, theta3.size)
    middle = np.unwrap(np.arctan2(sign * b[arc], sign * a[arc]))
    places = np.arange(theta3.size, dtype=float) if theta3[0] == theta3[-1] else np.abs(theta3 - theta3[0])
    found: Array = np.interp(places, places[arc], middle)
    return found


def _least(regional: Regional, sign: int, line: Array) -> float:
    """The least s det J at points (k, 2) of (theta2, theta3)."""
    return float((sign * regional.determinant(line[:, 0], line[:, 1])).min())


# ---- the spline ----------------------------------------------------------------------------------------------------


def _evenly(line: Array, count: int) -> Array:
    """``count`` points of a polyline (k, 2), evenly spaced along it, its ends kept."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], count)
    points = np.stack([np.interp(at, lengths, coordinate) for coordinate in line.T], axis=-1)
    points[0], points[-1] = line[0], line[-1]
    return points


def _tightened(regional: Regional, sign: int, points: Array, floor: float) -> Array:
    """The control points pulled straight and pushed away from det J = 0; the last state that keeps above ``floor``."""
    from scipy.linalg import solve_banded

    count, step, h = len(points), 0.02, 1e-5
    inner = count - 2
    stiffness = step * (count - 1) ** 2 / math.pi**2  # the slowest wave of the band decays by 1 / (1 + step)
    bands = np.stack([np.full(inner, -stiffness), np.full(inner, 1.0 + 2.0 * stiffness), np.full(inner, -stiffness)])
    at = np.linspace(0.0, 1.0, 6 * count)
    best, now = points, points.copy()
    for _ in range(ROUNDS):
        x, y = now[1:-1, 0], now[1:-1, 1]
        middle = sign * regional.determinant(x, y)
        slope = np.stack(
            [
                sign * (regional.determinant(x + h, y) - regional.determinant(x - h, y)),
                sign * (regional.determinant(x, y + h) - regional.determinant(x, y - h)),
            ],
            axis=-1,
        ) / (2.0 * h)
        push = PUSH * slope / np.maximum(middle, floor)[:, None]
        push /= np.maximum(1.0, np.hypot(*push.T) / 5.0)[:, None]
        right = now[1:-1] + step * push
        right[0] += stiffness * now[0]
        right[-1] += stiffness * now[-1]
        now = np.concatenate([now[:1], solve_banded((1, 1), bands, right), now[-1:]])
        if _least(regional, sign, sample(now, DEGREE, at)) < floor:
            break
        best = now
    return best


def _in_joints(start: Array, goal: Array, moved: Array) -> Array:
    """Control points (k, 3) in the arm's joints: joints 2 and 3 are ``moved`` (k, 2) from the start.

    Exactly ``start`` is first, exactly ``goal`` last up to whole turns; joint 1 goes evenly the shorter way.
    """
    share = np.linspace(0.0, 1.0, len(moved))
    control: Array = start + np.column_stack([share * math.remainder(goal[0] - start[0], TURN), moved])
    control[0] = start
    control[-1] = goal + TURN * np.rint((control[-1] - goal) / TURN)
    return control


# ---- the proof -----------------------------------------------------------------------------------------------------


def certified(regional: Regional, control: Array) -> SignProof:
    """The proof that det J keeps its sign along the spline with control points (k, 3) in the arm's joints."""

    def on_balls(q: Array) -> Array:
        theta = q * np.array(regional.signs[1:], object) + exact(regional.offsets[1:])
        turns = np.empty((len(q), 2, 2), object)
        for place, angle in np.ndenumerate(theta):
            turns[place] = angle.cos(), angle.sin()
        return regional.exact_determinant(turns[:, 0], turns[:, 1])

    return certify_sign(on_balls, bezier(control[:, 1:], DEGREE))
