"""Three revolute axes that meet in a point: where in a chain, and the two ways in which they take an orientation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Serial, Transform

Array = NDArray[Any]

#: How far axes may pass by a point and still meet in it, relative to the sum of the arm's lengths; the least sine of
#: the angle between two axes.
MEET, PARALLEL = 1e-9, 1e-9


def turn(angle: Any) -> Array:
    """Rotations (..., 3, 3) about z."""
    c, s = np.cos(angle), np.sin(angle)
    o, e = np.zeros_like(c), np.ones_like(c)
    return np.stack([np.stack([c, -s, o], -1), np.stack([s, c, o], -1), np.stack([o, o, e], -1)], -2)


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

    z . wanted z holds b, in two ways; a follows from the images of z, c from the rest (subproblems of B. Paden 1986).
    """
    u, w = second[2], third[:, 2]
    along, cosine, sine = u[2] * w[2], u[0] * w[0] + u[1] * w[1], u[1] * w[0] - u[0] * w[1]
    share = (wanted[..., 2, 2] - along) / np.hypot(cosine, sine)
    half = np.arccos(np.clip(share, -1.0, 1.0))
    b = np.arctan2(sine, cosine) + np.stack([half, -half], axis=-1)
    middle = second @ turn(b) @ third
    column = middle[..., :, 2]
    a = np.arctan2(wanted[..., 1, 2], wanted[..., 0, 2])[..., np.newaxis] - np.arctan2(column[..., 1], column[..., 0])
    # what is left is a turn about z, also where the outer axes are in line and a is any angle
    left = np.swapaxes(turn(a) @ middle, -1, -2) @ wanted[..., np.newaxis, :, :]
    c = np.arctan2(left[..., 1, 0], left[..., 0, 0])
    return np.stack([a, b, c], axis=-1), np.broadcast_to((np.abs(share) <= 1.0 + 1e-12)[..., np.newaxis], b.shape)
