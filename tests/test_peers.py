"""Other people's robotics libraries, built from the same description or the same file, give the same kinematics."""

from __future__ import annotations

from importlib import metadata
from pathlib import Path

import arms_under_test as under
import numpy as np
import pytest

import chainrule as cr

COUNT = 1000


def largest(a, b):
    return np.abs(np.asarray(a) - np.asarray(b)).max()


# ---- Pinocchio -------------------------------------------------------------------------------------------------


def pinocchio_results(pin, model, frame, q):
    """Tip poses (k, 4, 4) and Jacobians (k, 6, n) of the frame, axes of the world, at the frame's origin."""
    data = model.createData()
    poses, jacobians = [], []
    for row in q:
        pin.computeJointJacobians(model, data, row)
        pin.updateFramePlacements(model, data)
        poses.append(data.oMf[frame].homogeneous.copy())
        jacobians.append(pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED).copy())
    return np.array(poses), np.array(jacobians)


def pinocchio_of(pin, arm):
    """A model built joint by joint from our description's fixed transforms."""
    model, joint = pin.Model(), 0
    geometry = arm.description.geometry
    for k, (kind, placement) in enumerate(zip(arm.kinds, geometry.placements, strict=True)):
        motion = pin.JointModelRZ() if kind == "R" else pin.JointModelPZ()
        place = pin.SE3(np.array(placement.rotation), np.array(placement.translation))
        joint = model.addJoint(joint, motion, place, f"joint{k}")
    tool = pin.SE3(np.array(geometry.tool.rotation), np.array(geometry.tool.translation))
    return model, model.addFrame(pin.Frame("tip", joint, 0, tool, pin.FrameType.OP_FRAME))


def compare(arm, poses, jacobians, q):
    reach = np.abs(poses[:, :3, 3]).max()
    assert largest(arm.pose(q), poses) < 1e-12
    assert largest(arm.position(q), poses[:, :3, 3]) < 1e-12
    assert largest(arm.jacobian(q, task="pose"), jacobians) < 1e-12
    assert largest(arm.jacobian(q, task="position"), jacobians[:, :3]) < 1e-12
    assert reach > 0.1  # the comparison is of something
    gram = np.linalg.det(jacobians @ jacobians.swapaxes(1, 2))
    assert largest(arm.manipulability(q) ** 2, gram) < 1e-12


MIXED = cr.Arm.from_dh(
    [
        ("R", 0.3, 0.1, 0.2, 0.4),
        ("P", -0.5, 0.2, 0.1, 1.1),
        ("R", 1.2, -0.3, 0.4, -0.6),
        ("R", -1.5, 0.2, 0.0, 0.0),
        ("P", 0.8, 0.0, 0.3, 0.2),
        ("R", 0.4, 0.1, 0.1, 2.0),
    ],
    tool=(0.1, 0.2, 0.3),
    name="mixed6",
)
SERIAL = [name for name in under.ARMS if under.ARMS[name].description.model.family == "serial"]


@pytest.mark.parametrize("name", [*SERIAL, "mixed6"])
def test_pinocchio_from_our_description(name):
    pin = pytest.importorskip("pinocchio")
    arm = MIXED if name == "mixed6" else under.ARMS[name]
    q = under.random_q(arm, COUNT, 1)
    compare(arm, *pinocchio_results(pin, *pinocchio_of(pin, arm), q), q)


def robot_file(name):
    """A URDF of the example-robot-data package, wherever its wheel puts it."""
    try:
        files = metadata.files("example-robot-data") or []
    except metadata.PackageNotFoundError:
        pytest.skip("example-robot-data is not installed")
    return next(Path(str(file.locate())) for file in files if file.as_posix().endswith(f"robots/{name}"))


@pytest.mark.parametrize(
    ("file", "tip"),
    [
        ("panda_description/urdf/panda.urdf", "panda_link8"),
        ("ur_description/urdf/ur5_robot.urdf", "tool0"),
        ("kinova_description/robots/kinova.urdf", "j2s6s200_end_effector"),
    ],
    ids=["panda", "ur5", "kinova"],
)
def test_pinocchio_reads_the_same_file(file, tip):
    """The whole way from a file nobody here wrote: our reader and kernels against theirs."""
    pin = pytest.importorskip("pinocchio")
    path = robot_file(file)
    arm = cr.load(path, tip=tip)
    model = pin.buildModelFromUrdf(str(path))
    ours = [model.joints[model.getJointId(name)] for name in arm.joint_names]
    configurations, columns = (np.array([getattr(joint, index) for joint in ours]) for index in ("idx_q", "idx_v"))
    q = under.random_q(arm, COUNT, 2)
    whole = np.tile(pin.neutral(model), (COUNT, 1))
    for k, joint in enumerate(ours):
        if joint.nq == 2:  # continuous joints are kept as cosine and sine
            whole[:, joint.idx_q], whole[:, joint.idx_q + 1] = np.cos(q[:, k]), np.sin(q[:, k])
        else:
            whole[:, configurations[k]] = q[:, k]
    poses, jacobians = pinocchio_results(pin, model, model.getFrameId(tip), whole)
    compare(arm, poses, jacobians[:, :, columns], q)


def test_embedded_panda_is_the_published_file():
    """The table of the data sheet and the URDF of another package describe one arm, limits of position included."""
    ours, theirs = cr.load("panda"), cr.load(robot_file("panda_description/urdf/panda.urdf"), tip="panda_link8")
    q = under.random_q(ours, COUNT, 3)
    assert largest(ours.pose(q), theirs.pose(q)) < 1e-11  # the file rounds pi/2 to twelve digits
    assert largest(ours.jacobian(q), theirs.jacobian(q)) < 1e-11


# ---- Robotics Toolbox ------------------------------------------------------------------------------------------


def test_puma_of_the_robotics_toolbox():
    """Corke's own model of the arm whose table he published."""
    toolbox = pytest.importorskip("roboticstoolbox")
    theirs, ours = toolbox.models.DH.Puma560(), cr.load("puma560")
    # Theirs stands on a pedestal and has the rounded offsets of the toolbox's file: compare the same numbers.
    table = ours.description.geometry.table
    links = [toolbox.RevoluteDH(a=row.a, alpha=row.alpha, d=row.d, offset=row.theta) for row in table]
    same = toolbox.DHRobot(links, name="puma")
    assert [link.alpha for link in theirs.links] == pytest.approx([row.alpha for row in table])
    assert [link.a for link in theirs.links] == pytest.approx([row.a for row in table], abs=1e-3)
    q = under.random_q(ours, COUNT, 4)
    poses = np.array([same.fkine(row).A for row in q])
    assert largest(ours.pose(q), poses) < 1e-12
    assert largest(ours.jacobian(q), np.array([same.jacob0(row) for row in q])) < 1e-12
    measure = np.array([same.manipulability(row, method="yoshikawa", axes="all") for row in q])
    assert largest(ours.manipulability(q), measure) < 1e-7  # theirs is the root of det(J J^T): half the digits


@pytest.mark.parametrize("convention", ["modified", "standard"])
def test_toolbox_tables(convention):
    """Random tables of both conventions, revolute and prismatic."""
    toolbox = pytest.importorskip("roboticstoolbox")
    rng = np.random.default_rng(5)
    rows = [(kind, *rng.uniform(-1, 1, 4)) for kind in "RRPRPR"]
    make = {
        ("R", "modified"): toolbox.RevoluteMDH,
        ("P", "modified"): toolbox.PrismaticMDH,
        ("R", "standard"): toolbox.RevoluteDH,
        ("P", "standard"): toolbox.PrismaticDH,
    }
    links = [
        make[kind, convention](
            a=a, alpha=alpha, **({"d": d, "offset": theta} if kind == "R" else {"theta": theta, "offset": d})
        )
        for kind, alpha, a, d, theta in rows
    ]
    theirs = toolbox.DHRobot(links, name="random")
    arm = cr.Arm.from_dh(rows, convention=convention, name="random6")
    code = under.emitted(arm, "kinematics")
    q = under.random_q(arm, 100, 6)
    assert largest(code["pose"](q), np.array([theirs.fkine(row).A for row in q])) < 1e-12
    assert largest(code["jacobian_pose"](q), np.array([theirs.jacob0(row) for row in q])) < 1e-12
