"""Pinocchio from Python: a model with the same transforms, and a loop over configurations."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.cases import Array, Case, Contender, Unavailable, empty_outputs
from chainrule.description import Planar, Serial, Transform

#: Configurations in one timed loop; the time of one does not depend on it.
MOST = 4000


def contenders(case: Case, q: Array) -> list[Contender]:
    """One contender: what a Python user writes, for a batch and for one configuration."""
    try:
        import pinocchio as pin
    except ImportError:
        raise Unavailable("Pinocchio (the package pin) is not installed") from None
    model, frame = _model(case, pin)
    data = model.createData()
    outputs = empty_outputs(case, min(len(q), MOST))
    one = {"planar_3r": _survey, "panda": _kinematics, "panda_gradient": _gradient}[case.key](pin, model, data, frame)
    rows = q[: len(outputs[0])]

    def batch() -> None:
        for i, configuration in enumerate(rows):
            one(configuration, i, *outputs)

    def results() -> tuple[Array, ...]:
        batch()
        return outputs

    return [Contender("Pinocchio from Python", len(rows), batch, results, lambda: one(rows[0], 0, *outputs))]


def _model(case: Case, pin: Any) -> tuple[Any, int]:
    geometry = case.arm.description.geometry
    if isinstance(geometry, Planar):
        placements = [Transform(), *(Transform.shift(length, 0.0, 0.0) for length in geometry.lengths)]
        before, tool = placements[:-1], placements[-1]
    elif isinstance(geometry, Serial):
        before, tool = list(geometry.placements), geometry.tool
    else:
        raise Unavailable(f"Pinocchio: no model for {case.title}")

    def placed(transform: Transform) -> Any:
        return pin.SE3(np.array(transform.rotation), np.array(transform.translation))

    model, joint = pin.Model(), 0
    for k, transform in enumerate(before):
        joint = model.addJoint(joint, pin.JointModelRZ(), placed(transform), f"joint{k + 1}")
    frame = model.addFrame(pin.Frame("tool", joint, placed(tool), pin.FrameType.OP_FRAME))
    return model, frame


def _survey(pin: Any, model: Any, data: Any, frame: int) -> Callable[..., None]:
    axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED

    def one(q: Array, i: int, position: Array, jacobian: Array, norm: Array) -> None:
        pin.computeJointJacobians(model, data, q)
        position[i] = pin.updateFramePlacement(model, data, frame).translation[:2]
        j = pin.getFrameJacobian(model, data, frame, axes)[:2]
        jacobian[i] = j
        norm[i] = np.sqrt(np.linalg.det(j @ j.T))

    return one


def _kinematics(pin: Any, model: Any, data: Any, frame: int) -> Callable[..., None]:
    axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED

    def one(q: Array, i: int, pose: Array, jacobian: Array) -> None:
        pin.computeJointJacobians(model, data, q)
        pose[i] = pin.updateFramePlacement(model, data, frame).homogeneous
        jacobian[i] = pin.getFrameJacobian(model, data, frame, axes)

    return one


def _gradient(pin: Any, model: Any, data: Any, frame: int) -> Callable[..., None]:
    """dH/dq_k = H tr((J J^T)^-1 J (dJ/dq_k)^T), with Pinocchio's kinematic Hessian."""
    axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    joint = model.njoints - 1  # H is the same for any point of the last link, as the Jacobians differ by a unit matrix

    def one(q: Array, i: int, norm: Array, gradient: Array) -> None:
        pin.computeJointJacobians(model, data, q)
        pin.computeJointKinematicHessians(model, data)
        j = pin.getJointJacobian(model, data, joint, axes)
        tensor = pin.getJointKinematicHessian(model, data, joint, axes)
        hessian = tensor.ravel().reshape(tensor.shape, order="F")  # it comes stored column by column
        product = j @ j.T
        h = np.sqrt(np.linalg.det(product))
        norm[i] = h
        gradient[i] = h * np.tensordot(np.linalg.solve(product, j), hessian, ([0, 1], [0, 1]))

    return one
