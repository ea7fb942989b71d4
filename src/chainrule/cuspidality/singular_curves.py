"""The singular curves of a 3R arm: det J = 0 in the joint space (theta2, theta3), and their images (rho, z).

det J = a cos(theta2) + b sin(theta2) + c vanishes at
    theta2 = atan2(b, a) +- arccos(-c / sqrt(a^2 + b^2)),
real where a^2 + b^2 >= c^2. At the ends of such an interval of theta3 both branches meet, so that together they are
one closed curve. Where a, b and c vanish together, theta2 is arbitrary: a singular line of the joint space (for the
orthogonal arms theta3 = +-arccos(-d3 / d4), whose image is a single point each); the branches pass through it.

Source: M. Baili, P. Wenger, D. Chablat, "Kinematic analysis of a family of 3R manipulators", Problems of Mechanics 15
(2004), section II, for the orthogonal arms.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.aspects import TURN, Critical, critical_angles
from chainrule.cuspidality.normal_form import Regional
from chainrule.inputs import whole_number

Array = NDArray[Any]

#: theta2 moves no further than this from a sample to the next, rad, unless so many halvings do not suffice.
STEEP, REFINEMENTS = 0.06, 16


@dataclass(frozen=True)
class SingularCurve:
    """One closed curve det J = 0.

    Attributes:
        line: whether it is a line: theta3 constant, theta2 arbitrary.
        joint: (k, 2) theta2 and theta3 of the arm's own joints, rad, unwrapped; the last row is the first again, up to
            whole turns.
        image: (k, 2) rho and z in m, in the cross-section through the first joint's axis.
        turns: (2,) how often theta2 and theta3 go round.
    """

    line: bool
    joint: Array
    image: Array
    turns: tuple[int, int]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "line": self.line,
            "joint": self.joint.tolist(),
            "image": self.image.tolist(),
            "turns": list(self.turns),
        }


def singular_curves(regional: Regional, points: int = 400) -> tuple[SingularCurve, ...]:
    """All singular curves, lines last; empty where det J vanishes everywhere or nowhere.

    Args:
        regional: the arm.
        points: on each branch between two places where branches meet.

    Raises:
        InputError: ``points`` is not a whole number of at least 8.
    """
    points = whole_number(points, "points", 8)
    critical = critical_angles(regional)
    lines = [angle for angle, c in zip(critical.theta3, critical.sign_of_c, strict=True) if c == 0]
    found = [_made(regional, False, theta) for theta in _curves(regional, critical, points)]
    theta2 = np.linspace(-math.pi, math.pi, points)
    for angle in lines:
        found.append(_made(regional, True, np.stack([theta2, np.full(points, angle)], axis=-1)))
    return tuple(found)


def _made(regional: Regional, line: bool, theta: Array) -> SingularCurve:
    joint = regional.from_normal(np.insert(theta, 0, 0.0, axis=1))[:, 1:]
    turns = np.rint((joint[-1] - joint[0]) / TURN).astype(int)
    image = regional.image(theta[:, 0], theta[:, 1])
    return SingularCurve(line, joint, image, (int(turns[0]), int(turns[1])))


def _curves(regional: Regional, critical: Critical, points: int) -> list[Array]:
    """Closed curves (k, 2) of the normal form."""
    count = len(critical.theta3)
    ends = [i for i in range(count) if critical.sign_of_c[i] != 0]
    if not ends:
        if not (critical.both[0] if count == 0 else any(critical.both)):
            return []
        theta3 = _refined(regional, critical, np.linspace(-math.pi, math.pi, 2 * points) + 1e-3)  # off the lines
        return _all_round(regional, critical, theta3)
    found = []
    for k, i in enumerate(ends):
        if not critical.both[i]:
            continue
        lower, upper = critical.theta3[i], critical.theta3[ends[(k + 1) % len(ends)]]
        if upper <= lower:
            upper += TURN
        share = 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, points))
        theta3 = _refined(regional, critical, lower + (upper - lower) * share)
        middle, width = _arcs(regional, critical, theta3)
        for end in (0, -1):  # where the branches meet
            width[end] = 0.0 if width[end] < 0.5 * math.pi else math.pi
        there, back = np.stack([middle + width, theta3], -1), np.stack([middle - width, theta3], -1)[::-1]
        back[:, 0] += there[-1, 0] - back[0, 0]
        found.append(np.concatenate([there, back[1:]]))
    return found


def _refined(regional: Regional, critical: Critical, theta3: Array) -> Array:
    """More samples where a branch is steep."""
    for _ in range(REFINEMENTS):
        middle, width = _arcs(regional, critical, theta3)
        steep = np.flatnonzero(np.abs(np.diff(middle)) + np.abs(np.diff(width)) > STEEP)
        if not steep.size:
            break
        theta3 = np.sort(np.concatenate([theta3, 0.5 * (theta3[steep] + theta3[steep + 1])]))
    return theta3


def _all_round(regional: Regional, critical: Critical, theta3: Array) -> list[Array]:
    """The two branches where there are both for every theta3, joined if one goes on as the other."""
    middle, width = _arcs(regional, critical, theta3)
    above, below = (np.stack([middle + sign * width, theta3], axis=-1) for sign in (1.0, -1.0))
    gap = [abs(math.remainder(branch[-1, 0] - above[0, 0], TURN)) for branch in (above, below)]
    if gap[0] <= gap[1]:
        return [above, below]
    below = below + np.array([above[-1, 0] - below[0, 0], TURN])
    return [np.concatenate([above, below[1:]])]


def _arcs(regional: Regional, critical: Critical, theta3: Array) -> tuple[Array, Array]:
    """Middle (unwrapped) and half width of the arc between both branches, continued through singular lines."""
    terms = regional.determinant_terms(theta3)
    for line, c in zip(critical.theta3, critical.sign_of_c, strict=True):
        if c == 0:
            for turn in (-TURN, 0.0, TURN):
                place = int(np.searchsorted(theta3, line + turn))
                if 0 < place < theta3.size and terms[place - 1] @ terms[place] < 0.0:
                    terms[place:] *= -1.0
    a, b, c = np.moveaxis(terms, -1, 0)
    size = np.hypot(a, b)
    cosine = np.divide(-c, size, out=np.zeros_like(c), where=size > 0.0)
    return np.unwrap(np.arctan2(b, a)), np.arccos(np.clip(cosine, -1.0, 1.0))
