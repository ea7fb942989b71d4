"""Robotics Toolbox for Python: its elementary transform sequences, which its C code evaluates."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.cases import Array, Case, Contender, Unavailable, empty_outputs
from chainrule.description import Planar, Serial

MOST = 1000


def contenders(case: Case, q: Array) -> list[Contender]:
    """fkine and jacob0 (manipulability and jacobm for the gradient) in a loop over configurations."""
    try:
        import roboticstoolbox as rtb
        from spatialmath import SE3
    except ImportError as error:
        raise Unavailable(f"Robotics Toolbox cannot be imported: {error}") from None
    chain = _chain(case, rtb, SE3)
    outputs = empty_outputs(case, min(len(q), MOST))
    rows = q[: len(outputs[0])]
    one = {"planar_3r": _survey, "panda": _kinematics, "panda_gradient": _gradient}[case.key](chain)

    def batch() -> None:
        for i, configuration in enumerate(rows):
            one(configuration, i, *outputs)

    def results() -> tuple[Array, ...]:
        batch()
        return outputs

    return [Contender("Robotics Toolbox", len(rows), batch, results, lambda: one(rows[0], 0, *outputs))]


def _chain(case: Case, rtb: Any, se3: Any) -> Any:
    geometry = case.arm.description.geometry
    chain = rtb.ETS()
    if isinstance(geometry, Planar):
        for length in geometry.lengths:
            chain = chain * rtb.ET.Rz() * rtb.ET.tx(length)
        return chain
    if not isinstance(geometry, Serial):
        raise Unavailable(f"Robotics Toolbox: no model for {case.title}")
    for placement in geometry.placements:
        chain = chain * rtb.ET.SE3(se3(_matrix(placement))) * rtb.ET.Rz()
    return chain * rtb.ET.SE3(se3(_matrix(geometry.tool)))


def _matrix(transform: Any) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = transform.rotation, transform.translation
    return matrix


def _survey(chain: Any) -> Callable[..., None]:
    def one(q: Array, i: int, position: Array, jacobian: Array, norm: Array) -> None:
        position[i] = chain.eval(q)[:2, 3]
        j = chain.jacob0(q)[:2]
        jacobian[i] = j
        norm[i] = np.sqrt(np.linalg.det(j @ j.T))

    return one


def _kinematics(chain: Any) -> Callable[..., None]:
    def one(q: Array, i: int, pose: Array, jacobian: Array) -> None:
        pose[i] = chain.eval(q)
        jacobian[i] = chain.jacob0(q)

    return one


def _gradient(chain: Any) -> Callable[..., None]:
    def one(q: Array, i: int, norm: Array, gradient: Array) -> None:
        norm[i] = chain.manipulability(q)
        gradient[i] = chain.jacobm(q).ravel()

    return one
