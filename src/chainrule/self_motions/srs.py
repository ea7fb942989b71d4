"""All self-motion curves of a 7R arm whose first three axes meet in a point and whose last three do: eight, or four.

Shoulder S and wrist W are held by the pose. Their distance holds the elbow's angle q4, in two ways; what lies between
turns about the line SW (the *swivel*), and shoulder and wrist take the orientations that this asks of them, each in two
ways. The three choices never meet while neither shoulder nor wrist becomes singular on the way: so there are **eight**
closed curves, labelled by the signs of q2, q4 and q6 where neighbouring axes stand at right angles. The other choice of
the shoulder, (q1 + pi, -q2, q3 + pi), or of the wrist is then an isometry of joint space: equal lengths in fours, and
all eight equal where the elbow has no offset, its own choice being a reflection too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.self_motions.spherical import Chain, orientations, turn

Array = NDArray[Any]

#: A shoulder or wrist whose middle sine falls below this on the circle, or an elbow this near to its end, is singular.
SINGULAR = 1e-7


@dataclass(frozen=True)
class Swivel:
    """An S-R-S arm at a pose.

    Attributes:
        chain: its matrices.
        target: the pose.
        shoulder, wrist: (3,) where the axes meet, in the base frame, m.
        in_three, in_four: (3,) the shoulder in frame 3, the wrist in frame 4, m.
        elbows: the values of q4, two or none.
    """

    chain: Chain
    target: Array
    shoulder: Array
    wrist: Array
    in_three: Array
    in_four: Array
    elbows: tuple[float, ...]
    straight: bool

    @classmethod
    def of(cls, arm: Arm, target: Array) -> Swivel | None:
        """The arm at a pose; None where it is no S-R-S arm with shoulder and wrist at right angles."""
        if arm.kinds != "RRRRRRR":
            return None
        chain = Chain.of(arm)
        first, last = chain.meeting(0), chain.meeting(4)
        if first is None or last is None or not (chain.right(0) and chain.right(4)):
            return None
        placements = chain.placements
        shoulder = placements[0, :3, :3] @ first + placements[0, :3, 3]
        in_three = _apply(np.linalg.inv(placements[1] @ placements[2]), first)
        in_four = _apply(placements[4], last)
        wrist = _apply(target @ np.linalg.inv(placements[5] @ placements[6] @ chain.tool), last)
        s, w = _apply(np.linalg.inv(placements[3]), in_three), in_four
        cosine, sine = float(s[:2] @ w[:2]), float(s[1] * w[0] - s[0] * w[1])
        size = math.hypot(cosine, sine)
        distance = float((wrist - shoulder) @ (wrist - shoulder))
        share = (float(w @ w + s @ s) - 2.0 * float(s[2] * w[2]) - distance) / (2.0 * size) if size else math.inf
        # cos(q4 - middle) = share
        middle, straight = math.atan2(sine, cosine), abs(abs(share) - 1.0) < SINGULAR**2
        half = math.acos(min(max(share, -1.0), 1.0))
        elbows = () if abs(share) > 1.0 + SINGULAR**2 else (middle + half, middle - half)
        return cls(chain, target, shoulder, wrist, in_three, in_four, elbows, straight)

    def postures(self, swivel: Array) -> Array:
        """Configurations (elbows, 2, 2, k, 7): each elbow, shoulder and wrist at swivel angles (k,), not unwrapped."""
        placements = self.chain.placements
        axis = self.wrist - self.shoulder
        turned = _about(axis, swivel)
        found = []
        for elbow in self.elbows:
            inner = placements[3, :3, :3] @ turn(elbow)
            between = inner @ self.in_four + placements[3, :3, 3] - self.in_three
            third = turned @ _taking(between, axis)  # the rotation of frame 3
            first, _ = orientations(placements[1, :3, :3], placements[2, :3, :3], placements[0, :3, :3].T @ third)
            fifth = third @ inner @ placements[4, :3, :3]
            rest = np.swapaxes(fifth, -1, -2) @ self.target[:3, :3] @ self.chain.tool[:3, :3].T
            last, _ = orientations(placements[5, :3, :3], placements[6, :3, :3], rest)
            k = len(swivel)
            pairs = [
                np.concatenate([first[:, i], np.full((k, 1), elbow), last[:, j]], axis=1)
                for i in (0, 1)
                for j in (0, 1)
            ]
            found.append(np.reshape(pairs, (2, 2, k, 7)))
        return np.array(found)

    @property
    def circles(self) -> list[tuple[Array, Array, float]]:
        """For each elbow, the circle that axis 4's origin describes: centre (3,), unit axis (3,), radius, m."""
        axis = (self.wrist - self.shoulder) / np.linalg.norm(self.wrist - self.shoulder)
        found = []
        for elbow in self.elbows:
            placement = self.chain.placements[3]
            between = placement[:3, :3] @ turn(elbow) @ self.in_four + placement[:3, 3] - self.in_three
            arm = _taking(between, axis) @ (placement[:3, 3] - self.in_three)
            along = float(arm @ axis)
            found.append((self.shoulder + along * axis, axis, float(np.linalg.norm(arm - along * axis))))
        return found

    @property
    def singular(self) -> str:
        """Why the curves may meet, in words; empty where all are regular."""
        if self.straight:
            return "stretched or folded elbow"
        if np.linalg.norm(self.wrist - self.shoulder) < 1e-12 * max(self.chain.size, 1e-300):
            return "wrist at the shoulder: it turns freely about it"
        if not self.elbows:
            return ""
        # sin q2 and sin q6 vanish where a cosine, of degree 1 in the swivel, reaches +-1
        q = self.postures(np.arange(3) * (2.0 * math.pi / 3.0))[:, 0, 0]
        for joint, name in ((1, "shoulder"), (5, "wrist")):
            # measured from its middle, the sine and cosine of the joint
            i = 1 if joint == 1 else 5
            cosine = np.cos(q[..., joint] - _middle(self.chain.placements[i : i + 2]))
            mean = cosine.mean(axis=1)
            swing = np.abs((cosine * np.exp(2j * math.pi / 3.0 * np.arange(3))).sum(axis=1)) * 2.0 / 3.0
            if (np.abs(mean) + swing > 1.0 - SINGULAR**2).any():
                return f"the {name} becomes singular on the way"
        return ""


def _middle(placements: Array) -> float:
    """The angle of the middle joint of three at which the outer axes coincide."""
    u, w = placements[0, 2, :3], placements[1, :3, 2]
    return math.atan2(u[1] * w[0] - u[0] * w[1], u[0] * w[0] + u[1] * w[1])


def _apply(transform: Array, point: Array) -> Array:
    return np.asarray(transform[:3, :3] @ point + transform[:3, 3])


def _about(axis: Array, angle: Array) -> Array:
    """Rotations (k, 3, 3) about an axis."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_rotvec(np.outer(angle, axis / np.linalg.norm(axis))).as_matrix())


def _taking(start: Array, end: Array) -> Array:
    """A rotation (3, 3) that takes one direction to another."""
    a, b = start / np.linalg.norm(start), end / np.linalg.norm(end)
    first = np.eye(3) - np.outer(a, a)
    side = first[:, np.argmax(np.linalg.norm(first, axis=0))]
    other = np.eye(3) - np.outer(b, b)
    match = other[:, np.argmax(np.linalg.norm(other, axis=0))]
    u, v = side / np.linalg.norm(side), match / np.linalg.norm(match)
    return np.asarray(np.stack([b, v, np.cross(b, v)], axis=1) @ np.stack([a, u, np.cross(a, u)], axis=1).T)
