"""What a description is: immutable numbers with a digest, and the checks that every arm goes through."""

import dataclasses
import math

import pytest

from chainrule.description import (
    Description,
    Inertia,
    Joint,
    Orthogonal3R,
    Planar,
    Serial,
    Transform,
    check_inertia,
    exact_cos_sin,
    identifier,
    with_limits,
)
from chainrule.errors import DescriptionError, shown
from chainrule.readers.dh import from_dh

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def serial(n=2, **options):
    joints = tuple(Joint(f"q{i}", "R") for i in range(n))
    return Description(**{"name": "arm", "joints": joints, "geometry": Serial((Transform(),) * n)} | options)


@pytest.mark.parametrize("quarter", range(-12, 13))
def test_quarter_turns_have_exact_cosines(quarter):
    c, s = exact_cos_sin(quarter * (math.pi / 2))
    assert (c, s) == ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter % 4]


@pytest.mark.parametrize("angle", [0.1, 1.5707963267948968, -3.0, 1e20, 2.0**60 * math.pi])
def test_other_angles_have_the_librarys(angle):
    assert exact_cos_sin(angle) == (math.cos(angle), math.sin(angle))


def test_descriptions_are_immutable_hashable_and_equal_by_value():
    assert serial() == serial() and hash(serial()) == hash(serial())
    with pytest.raises(dataclasses.FrozenInstanceError):
        serial().name = "other"


def test_the_digest_is_of_the_structure_alone():
    plain = serial()
    assert serial(source="elsewhere").model.digest == plain.model.digest
    assert with_limits(plain, velocity=[1, 2]).model.digest == plain.model.digest
    moved = serial(geometry=Serial((Transform(), Transform.shift(0, 0, 1e-9))))
    assert moved.model.digest != plain.model.digest
    negative_zero = serial(geometry=Serial((Transform(), Transform.shift(-0.0, 0, 0))))
    assert negative_zero.model.digest == plain.model.digest


def test_identifiers_are_safe_words():
    for name, word in (("ur5-e.v2", "ur5_e_v2"), ("7axis", "arm_7axis"), ("_", "arm"), ("A--B", "a_b")):
        assert identifier(name) == word
        assert identifier(name).isidentifier()


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"name": ""}, "arm: the name '' is not accepted"),
        ({"name": "a" * 129}, "is not accepted"),
        ({"name": "-a"}, "'-a' is not accepted"),
        ({"name": "a\nb"}, r"'a\nb' is not accepted"),
        ({"name": "arm\u0661"}, "is not accepted"),
        ({"name": 5}, "the name 5 is not accepted"),
        ({"joints": ()}, "0 joints; between 1 and 256"),
        ({"joints": (Joint("a", "R"), Joint("a", "R"))}, "joint 2: the name 'a' is used twice"),
        ({"joints": (Joint("a", "R"), Joint("b", "X"))}, "joint 2 'b': kind 'X'"),
        ({"joints": (Joint("a", "R"),)}, "2 entries in its geometry for 1 joints"),
        ({"geometry": Planar((1.0,), (0.0,))}, "1 entries in its geometry for 2 joints"),
        ({"geometry": Planar((1.0, 1.0), ())}, "0 entries in its geometry for 2 joints"),
        ({"geometry": Orthogonal3R(1, 1, 1, 1)}, "joints RR; the orthogonal 3R arm"),
        ({"joints": (Joint("a", "R", (2.0, 1.0)), Joint("b", "R"))}, "joint 1 'a': position limits [2.0, 1.0]"),
        ({"joints": (Joint("a", "R", torque=-1.0), Joint("b", "R"))}, "joint 1 'a': torque limit -1.0"),
        ({"joints": (Joint("a", "R", velocity=math.nan), Joint("b", "R"))}, "joint 1 'a': velocity limit nan"),
        ({"inertias": (None,)}, "1 inertias for 2 joints"),
        ({"inertias": (None, Inertia(-1.0, (0.0,) * 3, UNIT))}, "joint 'q1': mass -1.0 kg is negative"),
    ],
)
def test_refusals(options, said):
    with pytest.raises(DescriptionError) as caught:
        serial(**options)
    assert said in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("mass", "tensor", "said"),
    [
        (math.nan, UNIT, "must be finite"),
        (1.0, ((1.0, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, 1.0)), "must be finite"),
        (1.0, ((1.0, 0.1, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "not symmetric"),
        (1.0, ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "not that of a body"),
        (1.0, ((1.0, 2.0, 0.0), (2.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "not that of a body"),
        (1.0, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 3.0)), "not that of a body"),
    ],
)
def test_inertias_that_no_body_has(mass, tensor, said):
    with pytest.raises(DescriptionError, match="link 7") as caught:
        check_inertia(Inertia(mass, (0.0, 0.0, 0.0), tensor), "link 7")
    assert said in str(caught.value)


def test_inertias_at_the_edge_are_accepted():
    for diagonal in ((0.0, 0.0, 0.0), (0.0, 1.0, 1.0), (1.0, 1.0, 2.0), (0.0100001, 0.01, 0.02)):
        x, y, z = diagonal
        check_inertia(Inertia(1.0, (0.0,) * 3, ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z))), "link")


def test_with_limits_leaves_the_original_alone():
    arm = from_dh([("R", 0, 0, 0, 0), ("P", 0, 0, 0, 0)])
    limited = with_limits(arm, position=[(-math.inf, math.inf), (0, 1)], torque=[None, math.inf])
    assert arm.joints[1].position is None
    assert [joint.position for joint in limited.joints] == [None, (0.0, 1.0)]
    assert [joint.torque for joint in limited.joints] == [None, None]
    assert with_limits(limited).joints == limited.joints


def test_shown_is_one_short_line_whatever_it_is_given():
    endless: list = []
    endless.append(endless)
    for value in ("a\nb", "x" * 10**7, [[1.0] * 1000] * 100, 10**5000, endless, b"\x00" * 100, object()):
        assert "\n" not in shown(value) and len(shown(value)) <= 64
