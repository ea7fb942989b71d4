"""The URDF reader: what it refuses, what it lets pass, and that what it reads is the arm in the file."""

import importlib.metadata
import math
from pathlib import Path

import mpmath
import numpy as np
import pytest
from hostile_urdf import BROKEN, GOOD, ODD, chain
from reference import distance, pose, rot_axis, rot_x, rot_y, rot_z, shift

from chainrule.errors import DescriptionError
from chainrule.readers import read
from chainrule.readers.urdf import from_urdf


def saved(folder: Path, content: str | bytes) -> Path:
    file = folder / "arm.urdf"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return file


# --- refusals ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", BROKEN)
def test_broken_files_are_refused_in_one_line(case, tmp_path):
    content, said = BROKEN[case]
    file = saved(tmp_path, content)
    with pytest.raises(DescriptionError) as caught:
        read(file)
    message = str(caught.value)
    assert message.startswith(f"{file}: ") and said in message
    assert "\n" not in message and len(message) < len(str(file)) + 300


def test_there_are_many_of_them():
    assert len(BROKEN) >= 45


def test_a_million_joints(tmp_path):
    with pytest.raises(DescriptionError, match="larger than 8 MiB"):
        read(saved(tmp_path, chain(10**6)))
    with pytest.raises(DescriptionError, match="more than 100000 elements"):
        from_urdf(b'<robot name="r">' + b"<joint/>" * 10**6 + b"</robot>")


def test_more_joints_than_an_arm_has():
    with pytest.raises(DescriptionError, match="257 moving joints between base 'l0' and tip 'l257'; 1 to 256"):
        from_urdf(chain(257).encode())


def test_an_external_entity_is_never_opened(tmp_path):
    secret = tmp_path / "secret"
    secret.write_text("hidden")
    content = f'<!DOCTYPE r [<!ENTITY x SYSTEM "file://{secret}">]><robot name="&x;"/>'
    with pytest.raises(DescriptionError) as caught:
        read(saved(tmp_path, content))
    assert "hidden" not in str(caught.value)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"tip": "hand"}, "tip 'hand' is not a link of the file; it has 'base', 'upper', 'lower', 'tool'"),
        ({"base": "ground"}, "base 'ground' is not a link of the file"),
        ({"tip": "q1"}, "tip 'q1' is not a link"),
        ({"tip": "upper", "base": "lower"}, "tip 'upper' is not below base 'lower'"),
        ({"tip": "base"}, "0 moving joints between base 'base' and tip 'base'"),
        ({"base": "lower"}, "no joint moves anything below base 'lower'"),
        ({"tip": "tool", "base": "lower"}, "0 moving joints"),
    ],
)
def test_tips_and_bases_that_cannot_be(options, said, tmp_path):
    with pytest.raises(DescriptionError) as caught:
        read(saved(tmp_path, GOOD), **options)
    assert said in str(caught.value)


def test_several_tips_are_listed():
    branch = (
        '<link name="f"/><joint name="finger" type="floating"><parent link="lower"/><child link="f"/></joint></robot>'
    )
    content = GOOD.replace("</robot>", branch).encode()
    with pytest.raises(
        DescriptionError, match=r"more than one link can be the tip; give one, for example tip='f', 'tool'$"
    ):
        from_urdf(content)
    assert from_urdf(content, tip="tool").n == 2
    assert from_urdf(content, tip="lower").n == 2
    with pytest.raises(DescriptionError, match="joint 'finger': a floating joint is not accepted"):
        from_urdf(content, tip="f")


# --- oddities ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", ODD)
def test_odd_files_are_read(case, tmp_path):
    arm = read(saved(tmp_path, ODD[case]))
    assert arm.kinds == "RP"
    assert arm.model.name.isidentifier()


def test_a_long_chain():
    arm = from_urdf(chain(256).encode())
    assert arm.n == 256
    fixed = from_urdf((chain(3000, "fixed").replace('"fixed"', '"continuous"', 1)).encode())
    assert fixed.n == 1
    assert fixed.geometry.tool.translation[2] == pytest.approx(0.01 * 2999, rel=1e-12)


# --- what is read --------------------------------------------------------------------------------------------------

ARM = """<robot name="bent">
  <link name="world"/><link name="base"/><link name="a"/><link name="a_cover"/><link name="b"/><link name="c"/>
  <link name="hand"/><link name="finger"/>
  <joint name="mount" type="fixed"><parent link="world"/><child link="base"/>
    <origin xyz="1 2 3" rpy="0.1 -0.2 0.3"/></joint>
  <joint name="one" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0 0.1 0.3" rpy="1 2 3"/>
    <axis xyz="1 -2 3"/><limit lower="-2" upper="1.5" velocity="2" effort="0" acceleration="9"/></joint>
  <joint name="cover" type="fixed"><parent link="a"/><child link="a_cover"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.5 0 1"/></joint>
  <joint name="two" type="prismatic"><parent link="a"/><child link="b"/><origin xyz="0.4 0 0" rpy="0 0.4 0"/>
    <axis xyz="0 3 -4"/><limit upper="0.5" velocity="0" effort="7"/></joint>
  <joint name="three" type="continuous"><parent link="b"/><child link="c"/><origin rpy="0 0 -1.2"/></joint>
  <joint name="flange" type="fixed"><parent link="c"/><child link="hand"/><origin xyz="0 0 0.2" rpy="0 1 0"/></joint>
  <joint name="grip" type="prismatic"><parent link="hand"/><child link="finger"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="0.1" velocity="1" effort="1"/><mimic joint="two"/></joint>
</robot>"""


def urdf_pose(q):
    """The hand in the world, as the URDF specification has it: origin, then motion about or along the axis."""

    def origin(x, y, z, roll, pitch, yaw):
        return shift(x, y, z) * rot_z(mpmath.mpf(yaw)) * rot_y(mpmath.mpf(pitch)) * rot_x(mpmath.mpf(roll))

    one, two, three = q
    slide = [mpmath.mpf(a) * two / 5 for a in (0, 3, -4)]
    return (
        origin(1, 2, 3, 0.1, -0.2, 0.3)
        * origin(0, 0.1, 0.3, 1, 2, 3)
        * rot_axis((1, -2, 3), one)
        * origin(0.4, 0, 0, 0, 0.4, 0)
        * shift(*slide)
        * origin(0, 0, 0, 0, 0, -1.2)
        * rot_axis((1, 0, 0), three)
        * origin(0, 0, 0.2, 0, 1, 0)
    )


@pytest.mark.parametrize("q", [(0, 0, 0), (0.3, -0.2, 1.1), (-2, 0.5, 3)])
def test_pose_is_the_specifications_product(q):
    arm = from_urdf(ARM.encode(), tip="hand")
    with mpmath.workdps(40):
        assert distance(pose(arm, q), urdf_pose([mpmath.mpf(x) for x in q])) < 3e-15


def test_joints_and_limits():
    one, two, three = from_urdf(ARM.encode(), tip="hand").joints
    assert (one.name, one.kind, one.position) == ("one", "R", (-2.0, 1.5))
    assert (one.velocity, one.acceleration, one.torque) == (2.0, 9.0, None)
    assert (two.name, two.kind, two.position, two.velocity, two.torque) == ("two", "P", (0.0, 0.5), None, 7.0)
    assert (three.kind, three.position, three.velocity) == ("R", None, None)


def test_a_base_inside_the_tree():
    whole, part = from_urdf(ARM.encode(), tip="hand"), from_urdf(ARM.encode(), tip="hand", base="a")
    assert part.kinds == "PR"
    assert part.geometry.placements[1] == whole.geometry.placements[2]
    assert "a to hand" in part.source


@pytest.mark.parametrize("axis", ["1 0 0", "-2 0 0", "0 1 0", "0 -1 0", "0 0 5", "0 0 -1"])
def test_axes_along_the_frame_keep_exact_numbers(axis):
    content = GOOD.replace('<axis xyz="0 0 1"/>', f'<axis xyz="{axis}"/>')
    geometry = from_urdf(content.encode()).geometry
    for transform in (*geometry.placements, geometry.tool):
        assert {x for row in transform.rotation for x in row} <= {-1.0, 0.0, 1.0}


@pytest.mark.parametrize("axis", [(1e-8, 0, -1), (0.1, -0.2, -0.97), (1, 1, -1e-17), (-3, 4, 1e-3), (1e200, 1e200, 0)])
def test_any_axis_becomes_the_local_z_axis(axis):
    content = GOOD.replace('xyz="0 0 1"', 'xyz="{} {} {}"'.format(*axis))
    rotation = np.array(from_urdf(content.encode()).geometry.placements[0].rotation)
    assert abs(rotation.T @ rotation - np.eye(3)).max() < 1e-15
    assert np.linalg.det(rotation) == pytest.approx(1, abs=1e-15)
    largest = max(map(abs, axis))
    unit = np.array(axis) / largest / math.hypot(*(a / largest for a in axis))
    assert abs(rotation[:, 2] - unit).max() < 1e-15


def inertial(mass, centre, rpy, moments):
    keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    entries = " ".join(f'{key}="{value}"' for key, value in zip(keys, moments, strict=True))
    return f'<inertial><origin xyz="{centre}" rpy="{rpy}"/><mass value="{mass}"/><inertia {entries}/></inertial>'


BODIES = {
    "base": inertial(9, "0 0 0", "0 0 0", (1, 0, 0, 1, 0, 1)),
    "a": inertial(2, "0.1 -0.2 0.05", "0.3 0.2 0.1", (0.02, 0.001, 0.002, 0.03, -0.003, 0.04)),
    "a_cover": inertial(0.5, "0.01 0.02 0.03", "0 0 1", (0.001, 0, 0.0001, 0.002, 0, 0.0025)),
    "c": inertial(1, "0 0 0.1", "0 0 0", (0.01, 0, 0, 0.01, 0, 0.002)),
    "hand": inertial(0.7, "0 0.05 0", "0 0 0", (0.001, 0, 0, 0.001, 0, 0.001)),
    "finger": inertial(5, "0 0 0", "0 0 0", (1, 0, 0, 1, 0, 1)),
}


def heavy_arm():
    content = ARM
    for link, body in BODIES.items():
        content = content.replace(f'<link name="{link}"/>', f'<link name="{link}">{body}</link>')
    return content


def test_inertias_are_those_of_rigid_bodies():
    first, second, third = from_urdf(heavy_arm().encode(), tip="hand").inertias
    assert first.mass == 2.5 and third.mass == pytest.approx(1.7)  # with their covers, without the finger and the base
    assert second is None


def test_merged_inertia_is_the_sum_over_points():
    """Two point masses fixed to one link must have the inertia of the pair, in the joint's moved frame."""
    nothing = 'ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"'
    point = '<inertial><origin xyz="{}"/><mass value="{}"/><inertia ' + nothing + "/></inertial>"
    content = ARM.replace('<link name="a"/>', f'<link name="a">{point.format("0.1 0.2 -0.3", 2)}</link>')
    content = content.replace('<link name="a_cover"/>', f'<link name="a_cover">{point.format("0.3 0 0.1", 3)}</link>')
    arm = from_urdf(content.encode(), tip="hand")
    body = arm.inertias[0]
    with mpmath.workdps(30):
        cover = shift(0.1, 0.2, 0.3) * rot_z(mpmath.mpf(1)) * rot_x(mpmath.mpf(0.5))
        first = mpmath.matrix([0.1, 0.2, -0.3, 1])
        second = cover * mpmath.matrix([0.3, 0, 0.1, 1])
        # Invariants of the pair: the total mass, the distance of the centre from the axis, the moments along it.
        axis = np.array([1, -2, 3]) / math.sqrt(14)
        points = [(2.0, np.array([float(x) for x in first[:3]])), (3.0, np.array([float(x) for x in second[:3]]))]
    centre = sum(m * p for m, p in points) / 5
    moment = sum(m * (np.dot(p - centre, p - centre) - np.dot(p - centre, axis) ** 2) for m, p in points)
    assert body.mass == 5.0
    assert body.centre[2] == pytest.approx(centre @ axis, abs=1e-15)
    assert math.hypot(*body.centre) == pytest.approx(np.linalg.norm(centre), abs=1e-15)
    assert body.tensor[2][2] == pytest.approx(moment, abs=1e-15)
    assert sum(body.tensor[i][i] for i in range(3)) == pytest.approx(
        2 * sum(m * np.dot(p - centre, p - centre) for m, p in points), abs=1e-15
    )


# --- against Pinocchio, where it is installed -----------------------------------------------------------------------


def potential_and_kinetic(arm, q, qd):
    """Potential energy in gravity 9.81 along -z and kinetic energy, from this description alone."""
    frame, spin, speed = np.eye(4), np.zeros(3), np.zeros(3)
    potential = kinetic = 0.0
    for placement, joint, inertia, x, rate in zip(
        arm.geometry.placements, arm.joints, arm.inertias, q, qd, strict=True
    ):
        origin = frame[:3, 3]
        fixed = np.eye(4)
        fixed[:3, :3], fixed[:3, 3] = placement.rotation, placement.translation
        frame = frame @ fixed
        move = np.eye(4)
        if joint.kind == "R":
            move[:2, :2] = [[math.cos(x), -math.sin(x)], [math.sin(x), math.cos(x)]]
        else:
            move[2, 3] = x
        axis, frame = frame[:3, 2], frame @ move
        speed = speed + np.cross(spin, frame[:3, 3] - origin) + (axis * rate if joint.kind == "P" else 0)
        spin = spin + (axis * rate if joint.kind == "R" else 0)
        if inertia is None:
            continue
        arm_to_centre = frame[:3, :3] @ inertia.centre
        velocity = speed + np.cross(spin, arm_to_centre)
        tensor = frame[:3, :3] @ np.array(inertia.tensor) @ frame[:3, :3].T
        potential += inertia.mass * 9.81 * (frame[:3, 3] + arm_to_centre)[2]
        kinetic += inertia.mass * velocity @ velocity / 2 + spin @ tensor @ spin / 2
    return potential, kinetic


def test_energies_against_pinocchio(tmp_path):
    """Mass, centre and inertia are in the right frame exactly when the energies of every motion agree."""
    pin = pytest.importorskip("pinocchio")
    content = (
        heavy_arm()
        .replace(BODIES["finger"], "")
        .replace(BODIES["base"], "")
        .replace('type="continuous"', 'type="revolute"')
    )
    content = content.replace(
        '<origin rpy="0 0 -1.2"/>', '<origin rpy="0 0 -1.2"/><limit lower="-4" upper="4" velocity="1" effort="1"/>'
    )
    file = saved(tmp_path, content)
    arm = read(file, tip="hand")
    peer = pin.buildModelFromUrdf(str(file))
    data = peer.createData()
    rng = np.random.default_rng(7)
    order = [peer.joints[peer.getJointId(joint.name)].idx_q for joint in arm.joints]
    for _ in range(20):
        q, qd = rng.uniform(-2, 2, (2, 3))
        full, rate = pin.neutral(peer), np.zeros(peer.nv)
        full[order], rate[order] = q, qd
        potential, kinetic = potential_and_kinetic(arm, q, qd)
        assert kinetic == pytest.approx(pin.computeKineticEnergy(peer, data, full, rate), rel=1e-12)
        zero = (
            pin.computePotentialEnergy(peer, data, pin.neutral(peer)) - potential_and_kinetic(arm, np.zeros(3), qd)[0]
        )
        assert potential + zero == pytest.approx(pin.computePotentialEnergy(peer, data, full), abs=1e-12)


def robots() -> Path:
    """The folder of the URDF files that the package example-robot-data brings."""
    try:
        package = importlib.metadata.distribution("example-robot-data")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("example-robot-data is not installed")
    return Path(str(package.locate_file("cmeel.prefix/share/example-robot-data/robots")))


@pytest.mark.parametrize(
    ("folder", "file", "tip"),
    [
        ("panda_description/urdf", "panda.urdf", "panda_hand_tcp"),
        ("ur_description/urdf", "ur5_robot.urdf", "tool0"),
        ("xarm_description/urdf", "xarm7.urdf", None),
        ("talos_data/robots", "talos_left_arm.urdf", "gripper_left_base_link"),
        ("tiago_description/robots", "tiago_no_hand.urdf", "wrist_ft_tool_link"),
    ],
)
def test_files_that_nobody_here_wrote(folder, file, tip):
    pin = pytest.importorskip("pinocchio")
    path = robots() / folder / file
    arm = read(path, tip=tip)
    tip = tip or arm.source.rpartition(" to ")[2]
    peer = pin.buildModelFromUrdf(str(path))
    state = peer.createData()
    rng = np.random.default_rng(11)
    for q in rng.uniform(-2, 2, (10, arm.n)):
        full = pin.neutral(peer)
        for joint, x in zip(arm.joints, q, strict=True):
            at = peer.joints[peer.getJointId(joint.name)]
            full[at.idx_q : at.idx_q + at.nq] = (x,) if at.nq == 1 else (math.cos(x), math.sin(x))
        pin.framesForwardKinematics(peer, state, full)
        expected = state.oMf[peer.getFrameId(tip)].homogeneous
        found = pose(arm, q, 20)
        assert max(abs(found[i, j] - expected[i, j]) for i in range(4) for j in range(4)) < 1e-13
