"""Arms from Denavit-Hartenberg tables: against the conventions' own products of rotations, and every refusal."""

import math

import mpmath
import numpy as np
import pytest
from reference import distance, pose, rot_axis, rot_x, rot_z, shift

from chainrule.description import Inertia, Transform
from chainrule.errors import DescriptionError
from chainrule.readers.dh import from_dh
from chainrule.readers.families import orthogonal_3r, planar, planar_3r
from chainrule.readers.parts import as_transform, rotation_rpy

ROWS = [
    ("R", 0.3, 0.1, 0.2, 0.4),
    ("P", -0.5, 0.2, 0.1, 1.1),
    ("revolute", 1.2, -0.3, 0.4, -0.6),
    ("prismatic", 2.1, 0.05, -0.2, 0.3),
]
Q = [0.7, -0.2, 1.9, 0.33]


def by_definition(rows, q, convention):
    """The product of the four elementary displacements per row, as the convention's definition has them."""
    frame = mpmath.eye(4)
    for (kind, alpha, a, d, theta), value in zip(rows, q, strict=True):
        revolute = kind[0].upper() == "R"
        along = rot_z(mpmath.mpf(theta) + (value if revolute else 0)) * shift(
            0, 0, mpmath.mpf(d) + (0 if revolute else value)
        )
        across = rot_x(mpmath.mpf(alpha)) * shift(a, 0, 0)
        frame = frame * (across * along if convention == "modified" else along * across)
    return frame


@pytest.mark.parametrize("convention", ["modified", "standard"])
def test_pose_is_the_conventions_product(convention):
    arm = from_dh(ROWS, convention=convention)
    assert arm.kinds == "RPRP"
    with mpmath.workdps(40):
        assert distance(pose(arm, Q), by_definition(ROWS, [mpmath.mpf(x) for x in Q], convention)) < 5e-16


def test_tool_comes_after_the_last_link_in_both_conventions():
    for convention in ("modified", "standard"):
        plain, tooled = (
            from_dh(ROWS, convention=convention),
            from_dh(ROWS, convention=convention, tool=(0.1, -0.2, 0.3)),
        )
        assert distance(pose(tooled, Q), pose(plain, Q) * shift(0.1, -0.2, 0.3)) < 5e-16


def test_one_arm_from_both_conventions():
    # A standard table moved by one place is a modified one.
    standard = from_dh([("R", math.pi / 2, 0.1, 0.2, 0), ("R", 0, 0.5, 0, 0)], convention="standard")
    modified = from_dh([("R", 0, 0, 0.2, 0), ("R", math.pi / 2, 0.1, 0, 0)], tool=(0.5, 0, 0))
    assert standard.geometry.placements == modified.geometry.placements
    assert standard.geometry.tool == modified.geometry.tool
    assert standard.model.digest == modified.model.digest


@pytest.mark.parametrize("quarter", range(-6, 7))
def test_quarter_turns_are_exact(quarter):
    arm = from_dh([("R", quarter * math.pi / 2, 0.1, 0.2, quarter * math.pi / 2)])
    entries = {x for row in arm.geometry.placements[0].rotation for x in row}
    assert entries <= {-1.0, 0.0, 1.0}


def test_table_and_convention_are_kept():
    arm = from_dh(ROWS, convention="standard", name="keep-me.1", source="a book")
    assert arm.geometry.convention == "standard"
    assert [(row.kind, row.alpha, row.a, row.d, row.theta) for row in arm.geometry.table] == [
        ("RP"[i % 2], *row[1:]) for i, row in enumerate(ROWS)
    ]
    assert (arm.name, arm.source, arm.joints[3].name) == ("keep-me.1", "a book", "joint4")


def test_limits_names_and_inertias():
    body = Inertia(1.0, (0.0, 0.0, 0.1), ((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.01)))
    arm = from_dh(
        ROWS[:2],
        joint_names=["a", "b"],
        position=[(-1, 1), None],
        velocity=[2, math.inf],
        acceleration=np.array([3.0, 4.0]),
        torque=[None, 5],
        inertias=[None, body],
    )
    first, second = arm.joints
    assert (first.name, first.position, first.velocity, first.acceleration, first.torque) == (
        "a",
        (-1.0, 1.0),
        2.0,
        3.0,
        None,
    )
    assert (second.name, second.position, second.velocity, second.acceleration, second.torque) == (
        "b",
        None,
        None,
        4.0,
        5.0,
    )
    assert arm.inertias == (None, body)


def test_numpy_rows_and_scalars():
    numbers = np.array([[0.3, 0.1, 0.2, 0.4], [0.0, 0.5, 0.0, 0.0]], dtype=np.float32)
    arm = from_dh([("R", *row) for row in numbers])
    assert arm.geometry.table[0].a == float(np.float32(0.1))


def test_tools_of_every_form():
    given = np.eye(4)
    given[:3, 3] = (1, 2, 3)
    for tool in (given, given.tolist(), (1, 2, 3), np.array([1, 2, 3]), Transform.shift(1, 2, 3)):
        assert as_transform(tool, "tool") == Transform.shift(1, 2, 3)
    assert as_transform(None, "tool") == Transform()


def test_rounded_tool_is_made_orthonormal():
    with mpmath.workdps(30):
        exact = rot_axis((1, 2, 3), 0.7)
    rounded = [[round(float(exact[i, j]), 7) for j in range(4)] for i in range(4)]
    rotation = np.array(as_transform(rounded, "tool").rotation)
    assert abs(rotation.T @ rotation - np.eye(3)).max() < 5e-16
    assert abs(rotation - np.array(rounded)[:3, :3]).max() < 1e-7


def test_rpy_is_about_fixed_axes():
    with mpmath.workdps(30):
        expected = rot_axis((0, 0, 1), 0.3) * rot_axis((0, 1, 0), 0.2) * rot_axis((1, 0, 0), 0.1)
    found = rotation_rpy(0.1, 0.2, 0.3).rotation
    assert max(abs(found[i][j] - expected[i, j]) for i in range(3) for j in range(3)) < 3e-16


left_handed = np.diag([1.0, 1.0, -1.0, 1.0])
scaled = np.diag([2.0, 2.0, 2.0, 1.0])
projective = np.eye(4)
projective[3, 0] = 0.5
with_nan = np.eye(4)
with_nan[1, 2] = np.nan


@pytest.mark.parametrize(
    ("rows", "options", "said"),
    [
        ([], {}, "0 rows"),
        ([("R", 0, 0, 0, 0)] * 257, {}, "257 rows; between 1 and 256"),
        (5, {}, "rows: 5 is not a sequence"),
        ([("R", 0, 0, 0)], {}, "row 1: ('R', 0, 0, 0); five entries"),
        ([("R", 0, 0, 0, 0), "RRRRR"], {}, "row 2: 'RRRRR'; five entries"),
        ([("R", 0, 0, 0, 0), 7], {}, "row 2: 7; five entries"),
        ([("S", 0, 0, 0, 0)], {}, "row 1, column 'kind': 'S'"),
        ([(0, 0, 0, 0, 0)], {}, "row 1, column 'kind': 0"),
        ([("R", 0, "x", 0, 0)], {}, "row 1, column 'a': 'x' is not a number"),
        ([("R", 0, "1", 0, 0)], {}, "row 1, column 'a': '1' is not a number"),
        ([("R", None, 0, 0, 0)], {}, "row 1, column 'alpha': None is not a number"),
        ([("R", 0, 0, True, 0)], {}, "row 1, column 'd': True is not a number"),
        ([("R", 0, 0, 0, 1j)], {}, "row 1, column 'theta': 1j is not a number"),
        ([("R", 0, 0, 0, 0), ("R", 0, 0, math.nan, 0)], {}, "row 2, column 'd': nan is not finite"),
        ([("R", 0, math.inf, 0, 0)], {}, "row 1, column 'a': inf is not finite"),
        ([("R", 0, 10**400, 0, 0)], {}, "row 1, column 'a'"),
        (ROWS, {"convention": "craig"}, "convention 'craig'; 'modified' or 'standard'"),
        (ROWS, {"name": "two words"}, "'two words' is not accepted"),
        (ROWS, {"name": "../../x"}, "'../../x' is not accepted"),
        (ROWS, {"joint_names": ["a"]}, "1 names for 4 joints"),
        (ROWS, {"joint_names": ["a", "b", "a", "c"]}, "joint 3: the name 'a' is used twice"),
        (ROWS, {"joint_names": ["a", 'q; system("x")', "c", "d"]}, "joint 2: the name 'q; system"),
        (ROWS, {"tool": [1, 2]}, "tool: [1, 2]; a 4 x 4 matrix or a translation of 3 numbers"),
        (ROWS, {"tool": "xyz"}, "tool"),
        (ROWS, {"tool": 3.0}, "tool: 3.0; a 4 x 4 matrix"),
        (ROWS, {"tool": np.eye(3)}, "tool"),
        (ROWS, {"tool": left_handed}, "not a rotation (left-handed"),
        (ROWS, {"tool": scaled}, "not a rotation (columns off by 3"),
        (ROWS, {"tool": projective}, "tool, row 4"),
        (ROWS, {"tool": with_nan}, "tool, row 2, column 3: "),
        (ROWS, {"position": [(1, -1), None, None, None]}, "position limits [1.0, -1.0]; the lower must not exceed"),
        (ROWS, {"position": [(1, 2, 3), None, None, None]}, "position limit of joint 1: (1, 2, 3) is not a pair"),
        (ROWS, {"position": [(math.nan, 2), None, None, None]}, "position limit of joint 1: nan is not finite"),
        (ROWS, {"velocity": [1, 2]}, "velocity limits: 2 entries for 4 joints"),
        (ROWS, {"velocity": 3}, "velocity limits: 3; one entry per joint"),
        (ROWS, {"velocity": ["fast", 1, 1, 1]}, "velocity limit of joint 1: 'fast' is not a number"),
        (ROWS, {"acceleration": [-1, 1, 1, 1]}, "acceleration limit -1.0; it must not be negative"),
        (ROWS, {"inertias": [None]}, "1 inertias for 4 joints"),
    ],
)
def test_refusals_say_what_and_where_in_one_line(rows, options, said):
    with pytest.raises(DescriptionError) as caught:
        from_dh(rows, **options)
    message = str(caught.value)
    assert said in message
    assert "\n" not in message and len(message) < 300


def test_families():
    assert planar_3r(1, 0.5, 0.25).model.digest == planar("RRR", [3, 2, 1]).model.digest
    assert planar("RPR", [1, 2, 3], [0, 0.5, 0]).model.parameters == (1.0, 2.0, 3.0, 0.5)
    assert planar(["revolute", "P"], [1, 2]).kinds == "RP"
    assert orthogonal_3r(1, 2, 3, 4).model.parameters == (1.0, 2.0, 3.0, 4.0)
    assert planar("RP" * 100, [1.0] * 200).n == 200


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: planar("RXR", [1, 1, 1]), "kinds, joint 2: 'X'"),
        (lambda: planar("", []), "kinds: 0 joints"),
        (lambda: planar("RRR", [1, 1]), "lengths: [1, 1]; 3 numbers"),
        (lambda: planar("RRR", [1, math.nan, 1]), "lengths, joint 2: nan is not finite"),
        (lambda: planar("RP", [1, 1], [0.5, 0]), "headings, joint 1: 0.5; a revolute joint takes 0"),
        (lambda: planar_3r(1, "2", 3), "lengths, joint 2: '2' is not a number"),
        (lambda: orthogonal_3r(1, math.inf, 1, 1), "d3: inf is not finite"),
        (lambda: planar("RR", [1, 1], joint_names=["a"]), "joint_names: 1 names for 2 joints"),
    ],
)
def test_family_refusals(make, said):
    with pytest.raises(DescriptionError, match=r"^(?!.*\n)") as caught:
        make()
    assert said in str(caught.value)
