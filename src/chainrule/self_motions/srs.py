"""All self-motion curves of a 7R arm whose first three axes meet in a point and whose last three do: eight, or four.

Shoulder S and wrist W are held by the pose. Their distance holds the elbow's angle q4, in two ways; what lies between
turns about the line SW (the *swivel*), and shoulder and wrist take the orientations that this asks of them, each in two
ways. The three choices never meet while neither shoulder nor wrist becomes singular on the way: so there are **eight**
closed curves, labelled by the signs of q2, q4 and q6 where neighbouring axes stand at right angles. The other choice of
the shoulder, (q1 + pi, -q2, q3 + pi), or of the wrist is then an isometry of joint space: equal lengths in fours, and
all eight equal where the elbow has no offset, its own choice being a reflection too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.cuspidality.normal_form import evaluator
from chainrule.self_motions.spherical import Chain, Structure, middle_of, orientations, turn

Array = NDArray[Any]

TURN = 2.0 * np.pi

#: A shoulder or wrist whose middle sine falls below this on the circle, or an elbow this near to its end, is singular.
SINGULAR = 1e-7


@dataclass(frozen=True)
class Limbs:
    """What of an S-R-S arm does not depend on the pose.

    Attributes:
        structure: the arm's axes.
        chain: its matrices.
        shoulder: (3,) where axes 1 to 3 meet, in the base frame, m.
        in_three, in_four: (3,) the shoulder in frame 3, the wrist in frame 4, m.
        in_tip: (3,) the wrist in the tip's frame, m.
        before: (3,) the shoulder in the frame that joint 4 turns.
    """

    structure: Structure
    chain: Chain
    shoulder: Array
    in_three: Array
    in_four: Array
    in_tip: Array
    before: Array

    @classmethod
    def of(cls, arm: Arm) -> Limbs | None:
        """The limbs, once for each arm; None where it is no S-R-S arm with shoulder and wrist at right angles."""
        if arm.kinds != "RRRRRRR":
            return None
        if arm not in _LIMBS:
            _LIMBS[arm] = cls._made(Structure.of(arm))
        return _LIMBS[arm]

    @classmethod
    def _made(cls, structure: Structure) -> Limbs | None:
        first, last, chain = structure.meeting[0], structure.meeting[4], structure.chain
        if first is None or last is None or not (structure.right[0] and structure.right[4]):
            return None
        placements = chain.placements
        in_three = _apply(np.linalg.inv(placements[1] @ placements[2]), first)
        return cls(
            structure,
            chain,
            placements[0, :3, :3] @ first + placements[0, :3, 3],
            in_three,
            _apply(placements[4], last),
            _apply(np.linalg.inv(placements[5] @ placements[6] @ chain.tool), last),
            _apply(np.linalg.inv(placements[3]), in_three),
        )


_LIMBS: WeakKeyDictionary[Arm, Limbs | None] = WeakKeyDictionary()


@dataclass(frozen=True)
class Swivel:
    """An S-R-S arm at a pose.

    Attributes:
        limbs: the arm.
        target: the pose.
        wrist: (3,) where axes 5 to 7 meet, in the base frame, m.
        elbows: the values of q4, two or none.
        straight: whether the elbow is stretched or folded.
    """

    limbs: Limbs
    target: Array
    wrist: Array
    elbows: tuple[float, ...]
    straight: bool

    @classmethod
    def of(cls, arm: Arm, target: Array) -> Swivel | None:
        """The arm at a pose; None where it is no S-R-S arm with shoulder and wrist at right angles."""
        limbs = Limbs.of(arm)
        if limbs is None:
            return None
        wrist = _apply(target, limbs.in_tip)
        line = wrist - limbs.shoulder
        angles, share = evaluator("spherical_elbow")(limbs.before, limbs.in_four, np.array([line @ line]))
        beyond = abs(float(share[0])) - 1.0
        elbows = () if beyond > SINGULAR**2 else tuple(angles.tolist())
        return cls(limbs, target, wrist, elbows, abs(beyond) < SINGULAR**2)

    @property
    def chain(self) -> Chain:
        """The arm's matrices."""
        return self.limbs.chain

    def postures(self, swivel: Array, elbows: Sequence[float] | None = None) -> Array:
        """Configurations (elbows, 2, 2, k, 7): each elbow, shoulder and wrist at swivel angles (k,), not unwrapped.

        Args:
            swivel: angles about the line from shoulder to wrist, rad.
            elbows: some of the values of q4; both when absent.
        """
        placements, k = self.chain.placements, len(swivel)
        axis = self.wrist - self.limbs.shoulder
        turned = _about(axis, swivel)
        elbows = self.elbows if elbows is None else elbows
        found = np.empty((len(elbows), 2, 2, k, 7))
        for each, elbow in zip(found, elbows, strict=True):
            inner = placements[3, :3, :3] @ turn(elbow)
            between = inner @ self.limbs.in_four + placements[3, :3, 3] - self.limbs.in_three
            third = turned @ _taking(between, axis)  # the rotation of frame 3
            first, _ = orientations(placements[1, :3, :3], placements[2, :3, :3], placements[0, :3, :3].T @ third)
            fifth = third @ inner @ placements[4, :3, :3]
            rest = np.swapaxes(fifth, -1, -2) @ self.target[:3, :3] @ self.chain.tool[:3, :3].T
            last, _ = orientations(placements[5, :3, :3], placements[6, :3, :3], rest)
            each[..., :3] = np.swapaxes(first, 0, 1)[:, np.newaxis]
            each[..., 3] = elbow
            each[..., 4:] = np.swapaxes(last, 0, 1)
        return found

    @cached_property
    def thirds(self) -> Array:
        """Configurations (elbows, 2, 2, 3, 7) a third of a turn apart; of one elbow where a flip makes the other."""
        flipped = any(flip.first == 2 for flip in self.limbs.structure.flips)
        return self.postures(np.arange(3) * (TURN / 3.0), self.elbows[:1] if flipped else None)

    @property
    def circles(self) -> list[tuple[Array, Array, float]]:
        """For each elbow, the circle that axis 4's origin describes: centre (3,), unit axis (3,), radius, m."""
        limbs = self.limbs
        axis = (self.wrist - limbs.shoulder) / np.linalg.norm(self.wrist - limbs.shoulder)
        found = []
        for elbow in self.elbows:
            placement = self.chain.placements[3]
            between = placement[:3, :3] @ turn(elbow) @ limbs.in_four + placement[:3, 3] - limbs.in_three
            arm = _taking(between, axis) @ (placement[:3, 3] - limbs.in_three)
            along = float(arm @ axis)
            found.append((limbs.shoulder + along * axis, axis, float(np.linalg.norm(arm - along * axis))))
        return found

    @property
    def singular(self) -> str:
        """Why the curves may meet, in words; empty where all are regular."""
        if self.straight:
            return "stretched or folded elbow"
        if np.linalg.norm(self.wrist - self.limbs.shoulder) < 1e-12 * max(self.chain.size, 1e-300):
            return "wrist at the shoulder: it turns freely about it"
        if not self.elbows:
            return ""
        # sin q2 and sin q6 vanish where a cosine, of degree 1 in the swivel, reaches +-1
        q = self.thirds[:, 0, 0]
        for joint, name in ((1, "shoulder"), (5, "wrist")):
            # measured from its middle, the sine and cosine of the joint
            cosine = np.cos(q[..., joint] - middle_of(self.chain.placements[joint : joint + 2]))
            mean = cosine.mean(axis=1)
            swing = np.abs((cosine * np.exp(1j * TURN / 3.0 * np.arange(3))).sum(axis=1)) * 2.0 / 3.0
            if (np.abs(mean) + swing > 1.0 - SINGULAR**2).any():
                return f"the {name} becomes singular on the way"
        return ""


def _apply(transform: Array, point: Array) -> Array:
    return np.asarray(transform[:3, :3] @ point + transform[:3, 3])


def _about(axis: Array, angle: Array) -> Array:
    """Rotations (k, 3, 3) about an axis."""
    x, y, z = unit = axis / np.linalg.norm(axis)
    along, across = np.outer(unit, unit), np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    c, s = np.cos(angle)[:, np.newaxis, np.newaxis], np.sin(angle)[:, np.newaxis, np.newaxis]
    return np.asarray(along + c * (np.eye(3) - along) + s * across)


def _taking(start: Array, end: Array) -> Array:
    """A rotation (3, 3) that takes one direction to another."""
    return np.asarray(_frame(end) @ _frame(start).T)


def _frame(direction: Array) -> Array:
    """A right-handed frame (3, 3), axes in columns, the first one in a direction."""
    first = direction / np.linalg.norm(direction)
    least = np.argmin(np.abs(first))
    second = -first[least] * first
    second[least] += 1.0
    (x, y, z), (u, v, w) = first.tolist(), (second / np.linalg.norm(second)).tolist()
    return np.array([[x, u, y * w - z * v], [y, v, z * u - x * w], [z, w, x * v - y * u]])
