"""Three revolute axes that meet in a point: where in a chain, and the two ways in which they take an orientation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.cuspidality.normal_form import evaluator
from chainrule.description import Serial, Transform
from chainrule.self_motions.continuation import Dense, kept_signs
from chainrule.self_motions.result import Component

Array = NDArray[Any]

#: How far axes may pass by a point and still meet in it, relative to the sum of the arm's lengths; the least sine of
#: the angle between two axes.
MEET, PARALLEL = 1e-9, 1e-9
#: How far a flip of the arm's own axes may move the tip, relative to its size: rounding.
EXACT = 1e-14


def turn(angle: Any) -> Array:
    """Rotations (..., 3, 3) about z."""
    c, s = np.cos(angle), np.sin(angle)
    found = np.zeros((*np.shape(angle), 3, 3))
    found[..., 0, 0], found[..., 0, 1] = c, -s
    found[..., 1, 0], found[..., 1, 1] = s, c
    found[..., 2, 2] = 1.0
    return found


@dataclass(frozen=True)
class Chain:
    """A spatial chain of revolute joints as matrices, perhaps seen from its tip.

    Attributes:
        placements: (n, 4, 4) the fixed transform before each joint.
        tool: (4, 4).
        backwards: whether joint 1 of the chain is the arm's last, and joint values are the arm's negated.
    """

    placements: Array
    tool: Array
    backwards: bool = False

    @classmethod
    def of(cls, arm: Arm) -> Chain:
        """The chain of a serial arm."""
        geometry = arm.description.geometry
        assert isinstance(geometry, Serial)
        return cls(np.array([_matrix(each) for each in geometry.placements]), _matrix(geometry.tool))

    def reversed(self) -> Chain:
        """From tip to base: pose and joint values inverted."""
        every = [np.linalg.inv(each) for each in (*self.placements, self.tool)][::-1]
        return Chain(np.array(every[:-1]), every[-1], not self.backwards)

    def pose(self, target: Array) -> Array:
        """A pose of the arm's tip as one of the chain's."""
        return np.asarray(np.linalg.inv(target) if self.backwards else target)

    def joints(self, q: Array) -> Array:
        """Joint values (..., n) of the chain as the arm's."""
        return -q[..., ::-1] if self.backwards else q

    @property
    def size(self) -> float:
        """The sum of all lengths, m."""
        return float(np.linalg.norm(np.concatenate([self.placements, self.tool[np.newaxis]])[:, :3, 3], axis=1).sum())

    def meeting(self, first: int) -> Array | None:
        """Where axes ``first``, + 1 and + 2 (from 0) meet, (3,) in the first one's frame, or None.

        Neighbouring axes keep their place to one another, so what holds at one configuration holds at all.
        """
        frames = [np.eye(4), self.placements[first + 1], self.placements[first + 1] @ self.placements[first + 2]]
        lines = [(frame[:3, 3], frame[:3, 2]) for frame in frames]
        (o1, z1), (o2, z2), (_, z3) = lines
        if min(np.linalg.norm(np.cross(z1, z2)), np.linalg.norm(np.cross(z2, z3))) < PARALLEL:
            return None
        # the point of axis 1 nearest to axis 2
        across = np.cross(z2, np.cross(z1, z2))
        point = o1 + z1 * float((o2 - o1) @ across) / float(z1 @ across)
        apart = max(float(np.linalg.norm(np.cross(point - o, z))) for o, z in lines)
        return point if apart <= MEET * max(self.size, 1e-300) else None

    def right(self, first: int) -> bool:
        """Whether the three axes stand at right angles, each to the next: then they reach every orientation."""
        near = self.placements[first + 1 : first + 3, 2, 2]
        return bool(np.abs(near).max() < PARALLEL)


def _matrix(transform: Transform) -> Array:
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = transform.rotation, transform.translation
    return found


def orientations(second: Array, third: Array, wanted: Array) -> tuple[Array, Array]:
    """Angles (..., 2, 3) with Rz(a) second Rz(b) third Rz(c) = wanted (..., 3, 3), and whether they are real (..., 2).

    The generated form of :mod:`chainrule.derive.spherical_joint`.
    """
    angles, share = evaluator("spherical_orientations")(second, third, wanted)
    return angles, np.broadcast_to(np.abs(share) <= 1.0 + 1e-12, angles.shape[:-1])


# ---- symmetries --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Flip:
    """The other posture of three axes that meet at right angles: (a + pi, 2 m - b, c + pi) does what (a, b, c) does.

    It moves nothing else, at any target, and as a map of joint space it is an isometry: it takes self-motion curves to
    self-motion curves of the same length.

    Attributes:
        first: index of the first of the three joints.
        middle: m, the value of the middle joint at which the outer axes are in line.
    """

    first: int
    middle: float

    def side(self, q: Array) -> Array:
        """(...): the sine of the middle joint, which changes its sign."""
        return np.asarray(np.sin(q[..., self.first + 1] - self.middle))


@dataclass(frozen=True)
class Structure:
    """What of a 7R arm does not depend on the target.

    Attributes:
        chain: the arm.
        meeting: for each three axes in a row, (3,) where they meet in the first one's frame, or None.
        right: for each three, whether they stand at right angles.
        flips: of those that do both.
    """

    chain: Chain
    meeting: tuple[Array | None, ...]
    right: tuple[bool, ...]
    flips: tuple[Flip, ...]

    @classmethod
    def of(cls, arm: Arm) -> Structure:
        """The structure of a serial arm of revolute joints, once for each arm."""
        found = _STRUCTURES.get(arm)
        if found is None:
            chain = Chain.of(arm)
            firsts = range(arm.n - 2)
            meeting = tuple(chain.meeting(i) for i in firsts)
            right = tuple(chain.right(i) for i in firsts)
            flips = (
                Flip(i, middle_of(chain.placements[i + 1 : i + 3]))
                for i in firsts
                if meeting[i] is not None and right[i]
            )
            found = cls(chain, meeting, right, tuple(flip for flip in flips if _holds(arm, flip)))
            _STRUCTURES[arm] = found
        return found

    def images(self, curve: Component, flips: Sequence[Flip]) -> list[Component]:
        """The curves that all combinations of flips make of one, itself first."""
        found = [curve]
        for flip in flips:
            found += [_flipped(each, flip) for each in found]
        return found


_STRUCTURES: WeakKeyDictionary[Arm, Structure] = WeakKeyDictionary()


def middle_of(placements: Array) -> float:
    """The angle of the middle joint of three at which the outer axes are in line."""
    u, w = placements[0, 2, :3], placements[1, :3, 2]
    return math.atan2(u[1] * w[0] - u[0] * w[1], u[0] * w[0] + u[1] * w[1])


def _affine(flip: Flip, q: Array) -> tuple[Array, Array]:
    """Signs (n,) and shift (n,) of a flip that takes a configuration q (n,) to angles within half a turn of 0."""
    sign, shift = np.ones(len(q)), np.zeros(len(q))
    three = slice(flip.first, flip.first + 3)
    sign[flip.first + 1] = -1.0
    shift[three] = math.pi, 2.0 * flip.middle, math.pi
    there = sign * q + shift
    shift[three] -= 2.0 * math.pi * np.ceil((there[three] - math.pi) / (2.0 * math.pi))
    return sign, shift


def _holds(arm: Arm, flip: Flip) -> bool:
    """Whether a flip leaves the tip where it is, to rounding: axes may meet nearly."""
    q = np.random.default_rng(0).uniform(-math.pi, math.pi, (4, arm.n))
    there = q.copy()
    for row in there:
        sign, shift = _affine(flip, row)
        row[:] = sign * row + shift
    size = max(float(np.abs(arm.position(q)).max()), 1.0)
    return bool(np.abs(arm.pose(there) - arm.pose(q)).max() <= EXACT * size)


def _flipped(curve: Component, flip: Flip) -> Component:
    sign, shift = _affine(flip, curve.q[0])
    box = curve.box * sign[:, np.newaxis] + shift[:, np.newaxis]
    box[flip.first + 1] = box[flip.first + 1, ::-1]
    points = curve.points
    assert isinstance(points, Dense)  # curves that were followed
    moved = Dense(
        *(points.held, points.target, points.x * sign + shift, points.t * sign, points.k * sign, points.s, points.h),
        source=(points, sign, shift),
    )
    return Component(
        q=curve.q * sign + shift,
        length=curve.length,
        closed=curve.closed,
        winding=(curve.winding * sign).astype(int),
        box=box,
        manipulability=curve.manipulability,
        residual=curve.residual,
        closure=curve.closure,
        ends=curve.ends,
        signs=kept_signs(box, points.held.revolute),
        scale=curve.scale,
        points=moved,
    )
