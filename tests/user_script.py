"""A user's script under ``mypy --strict``: what the public interface says of its types."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import chainrule as cr


def dexterity(arm: cr.Arm, q: NDArray[np.float64]) -> float:
    """The least manipulability over a batch."""
    return float(np.min(arm.manipulability(q)))


def main() -> None:
    panda: cr.Arm = cr.load("panda")
    q = np.zeros((10, panda.n))
    pose: NDArray[np.float64] = panda.pose(q[0])
    print(dexterity(panda, q), panda.jacobian(q, task="position").shape)

    motion: cr.SelfMotion = cr.self_motion(panda, pose, limits=True)
    for curve in motion.components:
        length: float = curve.length
        print(length, curve.winding.tolist(), curve.closed)
    best: cr.BestPosture = cr.best_posture(panda, motion, "limits")
    print(best.value, best.q)

    design: cr.Orthogonal3R = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    cuspidal: bool | None = design.cuspidal
    postures = design.postures(2.5, 0.0, 0.5)
    change: cr.PostureChange = design.posture_change(postures[0], postures[2])
    print(cuspidal, change.certified, change.reason)

    flat = cr.planar_3r(1.0, 0.5, 0.25)
    found: cr.Workspace = cr.workspace(flat)
    area: float = found.area
    value, at = cr.max_manipulability(flat)
    print(area, value, at)
    move: cr.JointMove = cr.min_time([0.0, 0.0], [1.0, 0.5], 1.0, 2.0)
    print(float(move.duration), move.to_dict())
    try:
        cr.generate(flat, "folder", targets=["c"])
    except cr.InputError as error:
        print(error)


if __name__ == "__main__":
    main()
