"""Arms with six revolute joints whose last three axes meet in a point: the wrist, and the positioning arm before it.

With such a spherical wrist the first three joints alone place the wrist's centre, and det J is the product of theirs
and of a factor of the wrist. The wrist's two postures for one orientation lie on either side of its factor's zeros. So
the arm can change its posture without a singularity exactly if its regional part can, the 3R arm with the wrist's
centre as tip: everything known of 3R arms applies (D. L. Pieper 1968 for the decomposition).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Description, Planar, Serial, Transform
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array

Array = NDArray[Any]

#: How far axes may pass by a common point and still meet in it, relative to the sum of the arm's lengths; the least
#: sine of the angle between two axes that are not parallel.
MEET, PARALLEL = 1e-9, 1e-9


@dataclass(frozen=True)
class Wrist:
    """What was found about the last three and the first three axes of an arm with six revolute joints.

    Attributes:
        spherical: whether axes 4, 5 and 6 meet in a point, whatever the joints' angles.
        inverse: whether axes 1, 2 and 3 do (an inverse spherical wrist, at the base).
        words: what was found, or why there is no spherical wrist, in one line.
        regional: the 3R arm with the wrist's centre as its tip; None without a spherical wrist.
        in_tip: (3,) m, the wrist's centre in the tip's frame; None without a spherical wrist.
    """

    spherical: bool
    inverse: bool
    words: str
    regional: Description | None
    in_tip: Array | None

    def centre(self, pose: Any) -> Array:
        """The wrist's centre (..., 3) in m where the tip has a pose (..., 4, 4): p + R c.

        Raises:
            InputError: there is no spherical wrist; ``pose`` is not (..., 4, 4).
        """
        given = real_array(pose, "pose")
        if given.shape[-2:] != (4, 4):
            raise InputError(f"pose: shape {given.shape}; (..., 4, 4) is accepted")
        moved: Array = given[..., :3, 3] + given[..., :3, :3] @ self._known()
        return moved

    def pose(self, centre: Any, rotation: Any) -> Array:
        """The tip's pose (..., 4, 4) that has the wrist's centre (..., 3) and the orientation (..., 3, 3).

        Raises:
            InputError: there is no spherical wrist; shapes that do not fit.
        """
        at, turned = real_array(centre, "centre"), real_array(rotation, "rotation")
        if at.shape[-1:] != (3,) or turned.shape[-2:] != (3, 3):
            raise InputError(f"centre {at.shape}, rotation {turned.shape}; (..., 3) and (..., 3, 3) are accepted")
        tip = at - turned @ self._known()
        found = np.zeros((*tip.shape[:-1], 4, 4))
        found[..., :3, :3], found[..., :3, 3], found[..., 3, 3] = turned, tip, 1.0
        return found

    def _known(self) -> Array:
        if self.in_tip is None:
            raise InputError(f"there is no spherical wrist: {self.words}")
        return self.in_tip

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "spherical": self.spherical,
            "inverse": self.inverse,
            "words": self.words,
            "in_tip": None if self.in_tip is None else self.in_tip.tolist(),
        }


def wrist(arm: Arm | Description) -> Wrist:
    """Whether an arm with six revolute joints has a spherical wrist, and the 3R arm that it hangs on.

    Axes 4, 5 and 6 count as meeting in a point if they pass it by no more than :data:`MEET` times the sum of the arm's
    lengths, so that a table in millimetres or with rounded quarter turns is read as it is meant.

    Raises:
        InputError: another kind of arm.

    Example:
        >>> from chainrule import load
        >>> wrist(load("puma560")).words
        'axes 4, 5 and 6 meet in a point'
        >>> wrist(load("ur5e")).words
        'axes 4 and 5 meet, and axes 5 and 6, but 0.0997 m apart on axis 5'
        >>> wrist(load("gofa5")).words
        'axes 5 and 6 pass each other at 0.08 m'
    """
    description = arm.description if isinstance(arm, Arm) else arm
    if not isinstance(description, Description):
        raise InputError(f"arm: {shown(arm)}; an Arm or a Description with six revolute joints is accepted")
    geometry = description.geometry
    if not isinstance(geometry, Serial) or description.kinds != "RRRRRR":
        where = " in a plane" if isinstance(geometry, Planar) else ""
        raise InputError(f"{description.name}: joints {description.kinds}{where}; six revolute joints are accepted")
    near = MEET * sum(float(np.linalg.norm(t.translation)) for t in (*geometry.placements, geometry.tool))
    last = _common_point(geometry.placements[4], geometry.placements[5], near, (4, 5, 6))
    first = _common_point(geometry.placements[1], geometry.placements[2], near, (1, 2, 3))
    inverse = not isinstance(first, str)
    if isinstance(last, str):
        words = last + ("; axes 1, 2 and 3 meet in a point (an inverse spherical wrist)" if inverse else "")
        return Wrist(False, inverse, words, None, None)
    # The centre as a point of axis 4, which joint 4 does not move, and of axis 6.
    on_four = geometry.placements[4] @ Transform.shift(0.0, 0.0, last)
    on_six = _inverse(geometry.placements[5]) @ Transform.shift(0.0, 0.0, last)
    tool = geometry.placements[3] @ Transform.shift(*on_four.translation)
    regional = Description(
        f"{description.name[:100]}-regional",
        description.joints[:3],
        Serial(geometry.placements[:3], Transform.shift(*tool.translation)),
        source=f"the first three joints of {description.name}; the tip is the centre of its wrist",
    )
    in_tip = np.array((_inverse(geometry.tool) @ on_six).translation)
    return Wrist(True, inverse, "axes 4, 5 and 6 meet in a point", regional, in_tip)


def _common_point(before: Transform, after: Transform, near: float, axes: tuple[int, int, int]) -> float | str:
    """Where on the middle of three axes all three meet, its coordinate along it; or in words why they do not.

    ``before`` leads from the first axis' frame to the middle one's, ``after`` from there to the last one's.
    """
    first = _foot(_inverse(before))
    last = _foot(after)
    a, b, c = axes
    for one, two, (height, distance) in ((a, b, first), (b, c, last)):
        if height is None:
            return f"axes {one} and {two} are parallel"
        if distance > near:
            return f"axes {one} and {two} pass each other at {distance:.3g} m"
    assert first[0] is not None and last[0] is not None
    apart = abs(first[0] - last[0])
    if apart > near:
        return f"axes {a} and {b} meet, and axes {b} and {c}, but {apart:.3g} m apart on axis {b}"
    return 0.5 * (first[0] + last[0])


def _foot(other: Transform) -> tuple[float | None, float]:
    """Where on this frame's z axis the z axis of another comes nearest, and at what distance; None if parallel."""
    u = np.array([row[2] for row in other.rotation])
    p = np.array(other.translation)
    across = u[:2] @ u[:2]
    if across <= PARALLEL**2:
        return None, float(np.hypot(p[0], p[1]))
    along = -(u[:2] @ p[:2]) / across
    distance = abs(u[0] * p[1] - u[1] * p[0]) / np.sqrt(across)
    return float(p[2] + along * u[2]), float(distance)


def _inverse(transform: Transform) -> Transform:
    """The displacement back."""
    r = np.array(transform.rotation).T
    back = -r @ np.array(transform.translation)
    return Transform(tuple(tuple(row) for row in r.tolist()), tuple(back.tolist()))  # type: ignore[arg-type]
