"""Forward kinematics and Jacobians in plain mpmath, written from the definitions and from nothing of chainrule.

It reads a description's numbers and works at any number of digits, so it can stand as the reference for whatever the
package computes. Spatial arms give 4 x 4 poses and 6 x n Jacobians with rows (v; omega) in the base frame; planar arms
give 3 x 3 poses and 3 x n Jacobians with rows (x, y, alpha).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath

from chainrule.description import Description, Orthogonal3R, Planar, Serial


def pose(description: Description, q: Sequence[Any], digits: int = 40) -> mpmath.matrix:
    """The tool's pose in the base frame: 4 x 4, or 3 x 3 for a planar arm."""
    with mpmath.workdps(digits):
        return _frames(description, q)[-1]


def jacobian(description: Description, q: Sequence[Any], digits: int = 40) -> mpmath.matrix:
    """The geometric Jacobian: column i is (z x (p - p_i); z) for R and (z; 0) for P, z the axis of joint i."""
    with mpmath.workdps(digits):
        frames = _frames(description, q)
        planar = isinstance(description.geometry, Planar)
        rows = 3 if planar else 6
        result = mpmath.zeros(rows, description.n)
        tip = _origin(frames[-1])
        for i, joint in enumerate(description.joints):
            if planar:
                column = _planar_column(joint.kind, frames[i], frames[i + 1], tip)
            else:
                column = _spatial_column(joint.kind, frames[i], tip)
            for row in range(rows):
                result[row, i] = column[row]
        return result


def _frames(description: Description, q: Sequence[Any]) -> list[mpmath.matrix]:
    """One frame for each joint, moved by it, and the tool's last.

    For a planar arm the frame of joint i is instead where its link begins, and the next one where it ends.
    """
    geometry = description.geometry
    values = [mpmath.mpf(value) for value in q]
    if isinstance(geometry, Planar):
        return _planar_frames(geometry, description.kinds, values)
    if isinstance(geometry, Orthogonal3R):
        before, tool = _orthogonal(geometry)
    else:
        before, tool = _serial(geometry)
    frames, frame = [], mpmath.eye(4)
    for placement, joint, value in zip(before, description.joints, values, strict=True):
        motion = rot_z(value) if joint.kind == "R" else shift(0, 0, value)
        frame = frame * placement * motion
        frames.append(frame)
    return [*frames, frame * tool]


def _serial(geometry: Serial) -> tuple[list[mpmath.matrix], mpmath.matrix]:
    placed = [
        mpmath.matrix([[*row, x] for row, x in zip(t.rotation, t.translation, strict=True)] + [[0, 0, 0, 1]])
        for t in (*geometry.placements, geometry.tool)
    ]
    return placed[:-1], placed[-1]


def _orthogonal(geometry: Orthogonal3R) -> tuple[list[mpmath.matrix], mpmath.matrix]:
    """Modified rows (alpha, a, d): (0, 0, 0), (-90, d2, r2), (90, d3, 0); tool d4 along x."""
    down = mpmath.matrix([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])  # Rx(-90 deg)
    second = down * shift(geometry.d2, 0, geometry.r2)
    return [mpmath.eye(4), second, down.T * shift(geometry.d3, 0, 0)], shift(geometry.d4, 0, 0)


def _planar_frames(geometry: Planar, kinds: str, q: list[Any]) -> list[mpmath.matrix]:
    frames = [mpmath.eye(3)]
    for kind, length, heading, value in zip(kinds, geometry.lengths, geometry.headings, q, strict=True):
        turn = value if kind == "R" else mpmath.mpf(heading)
        advance = mpmath.mpf(length) + (0 if kind == "R" else value)
        c, s = mpmath.cos(turn), mpmath.sin(turn)
        frames.append(frames[-1] * mpmath.matrix([[c, -s, advance * c], [s, c, advance * s], [0, 0, 1]]))
    return frames


def _planar_column(kind: str, start: mpmath.matrix, end: mpmath.matrix, tip: list[Any]) -> list[Any]:
    if kind == "P":  # along the heading in which the link ends
        return [end[0, 0], end[1, 0], mpmath.mpf(0)]
    x, y = _origin(start)
    return [-(tip[1] - y), tip[0] - x, mpmath.mpf(1)]


def _spatial_column(kind: str, frame: mpmath.matrix, tip: list[Any]) -> list[Any]:
    z = [frame[i, 2] for i in range(3)]
    if kind == "P":
        return [*z, 0, 0, 0]
    r = [a - b for a, b in zip(tip, _origin(frame), strict=True)]
    return [z[1] * r[2] - z[2] * r[1], z[2] * r[0] - z[0] * r[2], z[0] * r[1] - z[1] * r[0], *z]


def _origin(frame: mpmath.matrix) -> list[Any]:
    last = frame.cols - 1
    return [frame[i, last] for i in range(last)]


def rot_x(angle: Any) -> mpmath.matrix:
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    return mpmath.matrix([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def rot_y(angle: Any) -> mpmath.matrix:
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    return mpmath.matrix([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]])


def rot_z(angle: Any) -> mpmath.matrix:
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    return mpmath.matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def shift(x: Any, y: Any, z: Any) -> mpmath.matrix:
    return mpmath.matrix([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])


def rot_axis(axis: Sequence[Any], angle: Any) -> mpmath.matrix:
    """Rodrigues' rotation by ``angle`` about ``axis`` of any length."""
    length = mpmath.sqrt(sum(mpmath.mpf(a) ** 2 for a in axis))
    x, y, z = (mpmath.mpf(a) / length for a in axis)
    cross = mpmath.matrix([[0, -z, y, 0], [z, 0, -x, 0], [-y, x, 0, 0], [0, 0, 0, 0]])
    return mpmath.eye(4) + mpmath.sin(angle) * cross + (1 - mpmath.cos(angle)) * cross * cross


def distance(a: mpmath.matrix, b: mpmath.matrix) -> float:
    """The largest difference between two matrices' entries."""
    return float(max(abs(x) for x in a - b))
