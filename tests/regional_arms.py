"""3R arms for the tests of cuspidality: random and degenerate ones, and their kinematics from the definitions alone."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import chainrule as cr
from chainrule.description import Orthogonal3R, Serial

TURN = 2.0 * math.pi


def orthogonal(rng: np.random.Generator) -> Any:
    """A random orthogonal arm, lengths of either sign."""
    d2, d3, d4, r2 = rng.uniform(0.3, 2.0, 4) * rng.choice([1.0, 1.0, -1.0], 4)
    return cr.orthogonal_3r(d2, d3, d4, r2)


def general(rng: np.random.Generator) -> Any:
    """A random 3R arm: any twists and offsets, angles counted from anywhere, a tip off the last joint's x axis."""
    (a2, a3), (o1, o2, o3) = rng.uniform(-math.pi, math.pi, 2), rng.uniform(-2.0, 2.0, 3)
    d2, d3, r1, r2, r3 = rng.uniform(0.3, 2.0, 5) * rng.choice([1.0, -1.0], 5)
    rows = [("R", 0.0, 0.0, r1, o1), ("R", a2, d2, r2, o2), ("R", a3, d3, r3, o3)]
    return cr.regional_3r(cr.Arm.from_dh(rows, tool=tuple(rng.uniform(0.3, 1.5, 3)), name="random_3r"))


def tip_and_determinant(design: Any, q: Any) -> tuple[np.ndarray, np.ndarray]:
    """The tip (..., 3) and det J (...) of the position at q (..., 3), from transforms and z x (p - p_i)."""
    geometry = design.description.geometry if hasattr(design, "description") else design.arm.description.geometry
    placements, tool = _placements(geometry)
    q = np.asarray(q, float)
    frame = np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))
    axes, points = [], []
    for i, placement in enumerate(placements):
        turn = np.zeros((*q.shape[:-1], 4, 4))
        c, s = np.cos(q[..., i]), np.sin(q[..., i])
        turn[..., 0, 0], turn[..., 0, 1], turn[..., 1, 0], turn[..., 1, 1] = c, -s, s, c
        turn[..., 2, 2] = turn[..., 3, 3] = 1.0
        frame = frame @ placement @ turn
        axes.append(frame[..., :3, 2])
        points.append(frame[..., :3, 3])
    tip = (frame @ tool)[..., :3, 3]
    a, b, c = (np.cross(axis, tip - point) for axis, point in zip(axes, points, strict=True))
    return tip, (np.cross(a, b) * c).sum(axis=-1)


def _placements(geometry: Any) -> tuple[list[np.ndarray], np.ndarray]:
    if isinstance(geometry, Orthogonal3R):
        second, third = np.eye(4), np.eye(4)
        second[:3, :3], second[:3, 3] = [[1, 0, 0], [0, 0, 1], [0, -1, 0]], [geometry.d2, geometry.r2, 0.0]
        third[:3, :3], third[:3, 3] = [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [geometry.d3, 0.0, 0.0]
        tool = np.eye(4)
        tool[0, 3] = geometry.d4
        return [np.eye(4), second, third], tool
    assert isinstance(geometry, Serial)
    every = []
    for transform in (*geometry.placements[:3], geometry.tool):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = transform.rotation, transform.translation
        every.append(matrix)
    return every[:3], every[3]


def same_angles(a: Any, b: Any, within: float = 1e-9) -> bool:
    """Whether angles agree up to whole turns."""
    return bool((np.abs(np.remainder(np.asarray(a) - b + math.pi, TURN) - math.pi) <= within).all())
