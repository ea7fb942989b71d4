"""How far the tip of any arm gets from its base: a search within the joint limits, and a bound that is certain."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Orthogonal3R, Planar, Transform
from chainrule.search import Found, maximise, samples

Array = NDArray[Any]


@dataclass(frozen=True)
class Reach:
    """How far the tip gets from the origin of the base frame, within the joint limits.

    Attributes:
        farthest: the largest distance met, m, and where.
        nearest: the smallest distance met, m, and where.
        bound: a distance that the tip cannot exceed, m; infinite with an unlimited prismatic joint.
        lowest, highest: the least and greatest height z of the base frame met by the samples, m (y for planar arms).
    """

    farthest: Found
    nearest: Found
    bound: float
    lowest: float
    highest: float

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        return {
            "farthest": {"distance": self.farthest.value, "q": self.farthest.q.tolist()},
            "nearest": {"distance": self.nearest.value, "q": self.nearest.q.tolist()},
            "bound": self.bound if math.isfinite(self.bound) else None,
            "lowest": self.lowest,
            "highest": self.highest,
        }


def reach(arm: Arm) -> Reach:
    """How far and how near the tip gets (a search within the limits), and a bound that it cannot exceed (certain).

    Example:
        >>> from chainrule import load
        >>> r = reach(load("panda"))
        >>> r.nearest.value < r.farthest.value <= r.bound
        True
    """

    def distances(q: Array) -> Array:
        found: Array = np.linalg.norm(arm.position(q), axis=-1)
        return found

    def outward(q: Array) -> tuple[float, Array]:
        p, jacobian = arm.kinematics(q, task="position")
        distance = float(np.linalg.norm(p))
        return distance, (p / distance if distance > 0.0 else p) @ jacobian

    def inward(q: Array) -> tuple[float, Array]:
        p, jacobian = arm.kinematics(q, task="position")
        return -float(p @ p), -2.0 * (p @ jacobian)  # the square is smooth where the distance is zero

    farthest = maximise(arm, distances, outward)
    nearest = maximise(arm, lambda q: -distances(q), inward)
    heights = arm.position(samples(arm))[:, -1]
    return Reach(
        farthest,
        Found(math.sqrt(-nearest.value), nearest.q, nearest.others),
        reach_bound(arm),
        float(heights.min()),
        float(heights.max()),
    )


def reach_bound(arm: Arm) -> float:
    """A distance from the base's origin that the tip cannot exceed, in m, whatever the revolute joints do.

    Choose a point on every joint's axis: its distance to the next one is fixed, so by the triangle inequality their
    sum bounds the reach, for every choice. The points are chosen so that the sum is small (it is convex); a prismatic
    joint counts with the farther end of its range.

    Example:
        >>> from chainrule import planar_3r
        >>> round(reach_bound(planar_3r(1.0, 0.5, 0.25)), 9)
        1.75
    """
    from scipy.optimize import minimize

    links = _links(arm)
    kinds, limits = arm.kinds, arm.limits.position
    sliding = [i for i, kind in enumerate(kinds) if kind == "P"]
    if not np.isfinite(limits[sliding]).all():
        return math.inf

    def total(slides: Array) -> float:
        points = [np.array([0.0, 0.0, slide]) for slide in slides]
        ends = [*points, np.zeros(3)]
        length = float(np.linalg.norm(_seen(links[0], ends[0])))
        for i, kind in enumerate(kinds):
            target = _seen(links[i + 1], ends[i + 1])
            # A prismatic joint's point stays with the link before it: seen from the link after, it moves back by q.
            starts = [points[i]] if kind == "R" else [points[i] - [0.0, 0.0, q] for q in limits[i]]
            length += max(float(np.linalg.norm(target - start)) for start in starts)
        return length

    start = np.zeros(arm.n)
    best = min(total(start), total(minimize(total, start, method="Powell", options={"xtol": 1e-10, "ftol": 1e-14}).x))
    return best * (1.0 + 1e-12)  # the sum's own rounding


def _links(arm: Arm) -> list[tuple[Array, Array]]:
    """Fixed transforms between the joints and to the tip, as rotation and translation; z is each joint's axis."""
    geometry = arm.description.geometry
    if isinstance(geometry, Orthogonal3R):
        placed = [
            Transform(),
            Transform.shift(geometry.d2, 0, 0) @ Transform.rot_x(-math.pi / 2) @ Transform.shift(0, 0, geometry.r2),
            Transform.shift(geometry.d3, 0, 0) @ Transform.rot_x(math.pi / 2),
            Transform.shift(geometry.d4, 0, 0),
        ]
    elif isinstance(geometry, Planar):
        return _planar_links(arm, geometry)
    else:
        placed = [*geometry.placements, geometry.tool]
    return [(np.array(t.rotation), np.array(t.translation)) for t in placed]


def _planar_links(arm: Arm, geometry: Planar) -> list[tuple[Array, Array]]:
    """The same chain with its joints' axes as z: a revolute joint's stands on the plane, a prismatic one's lies in it.

    Bends between the links do not matter for lengths from joint to joint when a revolute joint is between them, and
    a prismatic joint keeps its heading: Ry(90 deg) turns z into the heading, and back after the joint.
    """
    lying = Transform.rot_y(math.pi / 2)
    standing = Transform.rot_y(-math.pi / 2)
    before = Transform()
    placed = []
    for kind, length, heading in zip(arm.kinds, geometry.lengths, geometry.headings, strict=True):
        if kind == "R":
            placed.append(before)
            before = Transform.shift(length, 0, 0)
        else:
            placed.append(before @ Transform.rot_z(heading) @ Transform.shift(length, 0, 0) @ lying)
            before = standing
    placed.append(before)
    return [(np.array(t.rotation), np.array(t.translation)) for t in placed]


def _seen(link: tuple[Array, Array], point: Array) -> Array:
    """A point of the next frame, seen from the frame before."""
    rotation, translation = link
    moved: Array = rotation @ point + translation
    return moved
