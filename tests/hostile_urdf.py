"""URDF files that must be refused, each with the words its one line must hold, and odd ones that must be read.

Every broken file is a sound one with one thing changed, so that nothing else can be the reason for refusing it.
"""

from __future__ import annotations

GOOD = """<?xml version="1.0"?>
<robot name="two">
  <link name="base"/>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0 0" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/>
    </inertial>
  </link>
  <link name="lower"/>
  <link name="tool"/>
  <joint name="q1" type="revolute">
    <parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.3" rpy="0 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="2" effort="3"/>
  </joint>
  <joint name="q2" type="prismatic">
    <parent link="upper"/><child link="lower"/>
    <origin xyz="0.5 0 0" rpy="0 0 0"/>
    <axis xyz="1 0 0"/>
    <limit lower="0" upper="0.4" velocity="1" effort="5"/>
  </joint>
  <joint name="flange" type="fixed">
    <parent link="lower"/><child link="tool"/>
    <origin xyz="0 0 0.1" rpy="0 0 0"/>
  </joint>
</robot>
"""

LAUGHS = (
    '<!DOCTYPE robot [<!ENTITY a "ha">'
    + "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij", strict=True))
    + "]>"
)
Q1 = '<axis xyz="0 0 1"/>'
LIMIT = '<limit lower="-1" upper="1" velocity="2" effort="3"/>'
INERTIA = '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/>'
SPARE = '<joint name="more" type="fixed"><parent link="{}"/><child link="{}"/></joint></robot>'


def _changed(old: str, new: str, count: int = 1) -> str:
    assert old in GOOD, old
    return GOOD.replace(old, new, count)


#: what is wrong -> (the file, words of the message)
BROKEN: dict[str, tuple[str | bytes, str]] = {
    # not XML, or not a URDF
    "empty": ("", "not well-formed XML"),
    "text": ("hello", "not well-formed XML"),
    "binary": (bytes(range(256)) * 8, "not well-formed XML"),
    "truncated": (GOOD[: len(GOOD) // 2], "not well-formed XML"),
    "truncated at the end": (GOOD.replace("</robot>", ""), "not well-formed XML: no element found"),
    "two roots": (GOOD + "<robot/>", "not well-formed XML: junk after document element"),
    "unclosed element": (_changed("</joint>", ""), "not well-formed XML: mismatched tag"),
    "attribute twice": (_changed('name="q1"', 'name="q1" name="q3"'), "duplicate attribute"),
    "unquoted attribute": (_changed('name="q1"', "name=q1"), "not well-formed XML"),
    "nul character": (_changed("q1", "q\0"), "not well-formed XML"),
    "not utf-8": (GOOD.encode().replace(b"two", b"tw\xff"), "not well-formed XML"),
    "unknown encoding": ('<?xml version="1.0" encoding="klingon"?>' + GOOD.split("?>", 1)[1], "encoding"),
    "wrong root": (GOOD.replace("robot", "sdf"), "the root element is 'sdf'; a URDF's is 'robot'"),
    "robot without a name": (_changed(' name="two"', ""), "a <robot> has no name"),
    "no links": ('<robot name="r"/>', "there is no link"),
    "one link": ('<robot name="r"><link name="a"/></robot>', "no joint moves anything below base 'a'"),
    # XML as a weapon
    "billion laughs": (LAUGHS + _changed("two", "&j;").split("?>", 1)[1], "document type declaration"),
    "external entity": (
        '<!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + GOOD.replace("two", "&x;").split("?>", 1)[1],
        "document type declaration",
    ),
    "parameter entity": (
        '<!DOCTYPE robot [<!ENTITY % x SYSTEM "http://127.0.0.1/x.dtd"> %x;]>' + GOOD.split("?>", 1)[1],
        "document type declaration",
    ),
    "external dtd": ('<!DOCTYPE robot SYSTEM "robot.dtd">' + GOOD.split("?>", 1)[1], "document type declaration"),
    "undeclared entity": (_changed("two", "&two;"), "not well-formed XML: undefined entity"),
    "nested deep": (_changed("<link", "<a>" * 5000 + "</a>" * 5000 + "<link"), "nested more than 64 deep"),
    "nested deep, never closed": ("<robot>" * 100_000, "nested more than 64 deep"),
    # xacro
    "xacro element": (
        _changed('<robot name="two">', '<robot name="two" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arm/>'),
        "an unprocessed xacro (element 'arm')",
    ),
    "xacro without namespace": (_changed('<link name="base"/>', '<xacro:property name="x" value="1"/>'), "xacro"),
    "xacro expression": (
        _changed("0 0 0.3", "0 0 ${d1}"),
        "joint 'q1': <origin> xyz='0 0 ${d1}' (an unprocessed xacro",
    ),
    "xacro name": (_changed('"q1"', '"${prefix}q1"'), "an unprocessed xacro"),
    # names
    "a joint called as a shell command": (
        _changed('"q1"', "'q; system(\"x\")'"),
        "joint: the name 'q; system(\"x\")' is not",
    ),
    "a joint called as a path": (_changed('"q1"', '"../../x"'), "joint: the name '../../x' is not accepted"),
    "a robot called as a path": (_changed('"two"', '"/etc/passwd"'), "robot: the name '/etc/passwd' is not accepted"),
    "a link called as C": (_changed('"tool"', '"*/int main"', 2), "link: the name '*/int main' is not accepted"),
    "a name of two words": (_changed('"q1"', '"q 1"'), "joint: the name 'q 1' is not accepted"),
    "a name with a newline": (_changed('"q1"', '"q&#10;1"'), "joint: the name 'q\\n1' is not accepted"),
    "a name in other letters": (_changed('"q1"', '"q\u00e9"'), "joint: the name"),
    "an empty name": (_changed('"q1"', '""'), "joint: the name '' is not accepted"),
    "a long name": (_changed('"q1"', f'"{"q" * 129}"'), "is not accepted"),
    "an endless name": (_changed('"q1"', f'"{"q" * 1_000_000}"'), "is not accepted"),
    "no name": (_changed('<joint name="q1"', "<joint"), "a <joint> has no name"),
    "a link without a name": (_changed('<link name="base"/>', '<link name="base"/><link/>'), "a <link> has no name"),
    "two joints of one name": (_changed('"q2"', '"q1"'), "joint 'q1': the name is used twice"),
    "two links of one name": (
        _changed('<link name="tool"/>', '<link name="base"/>'),
        "link 'base': the name is used twice",
    ),
    # the tree
    "a loop": (
        GOOD.replace("</robot>", SPARE.format("tool", "base")),
        "a loop of joints, 'q1', 'q2', 'flange', 'more'; a tree",
    ),
    "a loop beside the tree": (
        GOOD.replace("</robot>", '<link name="x"/><link name="y"/>' + SPARE.format("x", "y").replace("</robot>", ""))
        + SPARE.format("y", "x").replace("more", "back"),
        "a loop of joints, 'more', 'back'; a tree",
    ),
    "a joint to itself": (
        _changed('<parent link="base"/>', '<parent link="upper"/>'),
        "a loop of joints, 'q1'; a tree",
    ),
    "a link with two parents": (
        GOOD.replace("</robot>", SPARE.format("base", "tool")),
        "joint 'more': its child link 'tool' already has a parent, by joint 'flange'",
    ),
    "two trees": (
        _changed('<link name="base"/>', '<link name="base"/><link name="alone"/>'),
        "links 'base', 'alone' have no",
    ),
    "unknown parent": (
        _changed('<parent link="base"/>', '<parent link="basis"/>'),
        "its parent link 'basis' is not in the",
    ),
    "unknown child": (
        _changed('<child link="upper"/>', '<child link="uper"/>'),
        "joint 'q1': its child link 'uper' is not",
    ),
    "no parent": (_changed('<parent link="base"/>', ""), "joint 'q1': it has no <parent>"),
    "no child": (_changed('<child link="upper"/>', ""), "joint 'q1': it has no <child>"),
    "two children": (
        _changed('<child link="upper"/>', '<child link="upper"/><child link="tool"/>'),
        "2 elements <child>",
    ),
    "a parent without a link": (
        _changed('<parent link="base"/>', "<parent/>"),
        "joint 'q1': its <parent> has no 'link'",
    ),
    "only fixed joints": (
        '<robot name="r"><link name="a"/><link name="b"/>' + SPARE.format("a", "b"),
        "no joint moves anything below base 'a'",
    ),
    # joints
    "no type": (_changed(' type="revolute"', ""), "joint 'q1': it has no type; accepted are revolute"),
    "unknown type": (_changed('"revolute"', '"hinge"'), "joint 'q1': type 'hinge'; accepted are revolute"),
    "a floating joint": (_changed('"revolute"', '"floating"'), "joint 'q1': a floating joint is not accepted"),
    "a planar joint": (_changed('"revolute"', '"planar"'), "joint 'q1': a planar joint is not accepted"),
    "a mimic joint": (
        _changed(LIMIT, LIMIT + '<mimic joint="q2"/>'),
        "joint 'q1': it mimics 'q2', which is not accepted",
    ),
    "a mimic of nothing": (_changed(LIMIT, LIMIT + '<mimic joint="q9"/>'), "joint 'q1': it mimics 'q9', which is not"),
    "a mimic of itself": (_changed(LIMIT, LIMIT + '<mimic joint="q1"/>'), "joint 'q1': it mimics 'q1', which is not"),
    "an unknown element": (_changed(Q1, '<axes xyz="0 0 1"/>'), "joint 'q1': unknown element 'axes'; accepted are"),
    "no limit": (_changed(LIMIT, ""), "joint 'q1': a revolute joint needs a <limit> with lower and upper"),
    "no bounds": (_changed(LIMIT, '<limit velocity="2" effort="3"/>'), "joint 'q1': a revolute joint needs a <limit>"),
    "limits upside down": (_changed('lower="-1" upper="1"', 'lower="1" upper="-1"'), "joint 'q1': limits [1.0, -1.0]"),
    "a lower limit above the default upper": (
        _changed('lower="-1" upper="1"', 'lower="1"'),
        "joint 'q1': limits [1.0, 0.0]",
    ),
    "a limit that is not a number": (_changed('upper="1"', 'upper="nan"'), "joint 'q1': <limit> upper='nan'"),
    "an infinite limit": (_changed('upper="1"', 'upper="inf"'), "joint 'q1': <limit> upper='inf'"),
    "a limit out of range": (_changed('upper="1"', 'upper="1e999"'), "joint 'q1': <limit> upper='1e999' is not finite"),
    "a negative velocity": (_changed('velocity="2"', 'velocity="-2"'), "joint 'q1': velocity limit -2.0"),
    "a negative effort": (_changed('effort="3"', 'effort="-3"'), "joint 'q1': effort limit -3.0"),
    "an unknown limit": (_changed('upper="1"', 'uper="1"'), "joint 'q1': <limit> has an unknown attribute 'uper'"),
    "two limits": (_changed(LIMIT, LIMIT * 2), "joint 'q1': 2 elements <limit>"),
    "an axis of zero": (_changed(Q1, '<axis xyz="0 0 0"/>'), "joint 'q1': its axis is zero"),
    "an axis of negative zero": (_changed(Q1, '<axis xyz="0 -0.0 0e5"/>'), "joint 'q1': its axis is zero"),
    "an axis of nan": (_changed(Q1, '<axis xyz="0 0 nan"/>'), "joint 'q1': <axis> xyz='0 0 nan'; 3 decimal numbers"),
    "an infinite axis": (_changed(Q1, '<axis xyz="0 0 1e400"/>'), "joint 'q1': <axis> xyz='0 0 1e400' is not finite"),
    "an axis of two": (_changed(Q1, '<axis xyz="0 1"/>'), "joint 'q1': <axis> xyz='0 1'; 3 decimal numbers"),
    "an axis of four": (_changed(Q1, '<axis xyz="0 0 0 1"/>'), "joint 'q1': <axis> xyz='0 0 0 1'; 3 decimal numbers"),
    "an axis of nothing": (_changed(Q1, "<axis/>"), "joint 'q1': its <axis> has no 'xyz'"),
    "two axes": (_changed(Q1, Q1 * 2), "joint 'q1': 2 elements <axis>"),
    "an origin of nan": (_changed("0 0 0.3", "0 nan 0.3"), "joint 'q1': <origin> xyz='0 nan 0.3'"),
    "an infinite origin": (_changed("0 0 0.3", "0 inf 0.3"), "joint 'q1': <origin> xyz='0 inf 0.3'"),
    "an origin out of range": (_changed("0 0 0.3", "0 0 9e308e"), "joint 'q1': <origin> xyz='0 0 9e308e'"),
    "an origin of two": (_changed("0 0 0.3", "0 0.3"), "joint 'q1': <origin> xyz='0 0.3'; 3 decimal numbers"),
    "an empty origin": (_changed("0 0 0.3", ""), "joint 'q1': <origin> xyz=''; 3 decimal numbers"),
    "commas": (_changed("0 0 0.3", "0,0,0.3"), "joint 'q1': <origin> xyz='0,0,0.3'; 3 decimal numbers"),
    "a decimal comma": (_changed("0 0 0.3", "0 0 0,3"), "joint 'q1': <origin> xyz='0 0 0,3'"),
    "hexadecimal": (_changed("0 0 0.3", "0 0 0x10"), "joint 'q1': <origin> xyz='0 0 0x10'"),
    "underscores": (_changed("0 0 0.3", "0 0 1_0"), "joint 'q1': <origin> xyz='0 0 1_0'"),
    "other digits": (_changed("0 0 0.3", "0 0 \u0663"), "joint 'q1': <origin> xyz="),
    "python": (_changed("0 0 0.3", "0 0 __import__('os').system('x')"), "joint 'q1': <origin> xyz="),
    "angles of nan": (_changed('0.3" rpy="0 0 0', '0.3" rpy="0 0 NaN'), "joint 'q1': <origin> rpy='0 0 NaN'"),
    "a misspelt origin": (_changed('<origin xyz="0 0 0.3"', '<origin xzy="0 0 0.3"'), "unknown attribute 'xzy'"),
    "two origins": (_changed(Q1, '<origin xyz="0 0 0"/>' + Q1), "joint 'q1': 2 elements <origin>"),
    # inertias
    "a negative mass": (_changed('value="2"', 'value="-2"'), "link 'upper': its mass -2.0 kg is negative"),
    "a mass of nan": (_changed('value="2"', 'value="nan"'), "link 'upper': <mass> value='nan'"),
    "no mass": (_changed('<mass value="2"/>', ""), "link 'upper': it has no <mass>"),
    "a mass without a value": (_changed('<mass value="2"/>', "<mass/>"), "link 'upper': its <mass> has no 'value'"),
    "no inertia": (_changed(INERTIA, ""), "link 'upper': it has no <inertia>"),
    "half an inertia": (_changed(' iyz="0" izz="0.2"', ""), "link 'upper': its <inertia> has no 'iyz'"),
    "two inertials": (_changed("</inertial>", "</inertial><inertial/>"), "link 'upper': 2 elements <inertial>"),
    "a negative moment": (_changed('ixx="0.1"', 'ixx="-0.1"'), "link 'upper': its moment of inertia -0.1 kg m^2 is"),
    "an indefinite inertia": (_changed('ixy="0"', 'ixy="5"'), "link 'upper': the inertia tensor is not that of a body"),
    "an inertia of nan": (_changed('ixy="0"', 'ixy="nan"'), "link 'upper': <inertia> ixy='nan'"),
    "a centre of nan": (_changed("0.1 0 0", "nan 0 0"), "link 'upper': <origin> xyz='nan 0 0'"),
    # too much
    "too many elements": (
        _changed('<link name="base"/>', '<link name="base"/>' + "<a/>" * 200_000),
        "more than 100000 elements",
    ),
}


def chain(joints: int, type_: str = "continuous") -> str:
    """A sound URDF of so many joints in a row."""
    links = "".join(f'<link name="l{i}"/>' for i in range(joints + 1))
    rows = "".join(
        f'<joint name="j{i}" type="{type_}"><parent link="l{i}"/><child link="l{i + 1}"/>'
        f'<origin xyz="0 0 0.01"/><axis xyz="0 {i % 2} 1"/></joint>'
        for i in range(joints)
    )
    return f'<robot name="long">{links}{rows}</robot>'


#: what is odd -> the file; each is read as a two-joint arm "RP"
ODD: dict[str, str | bytes] = {
    "plain": GOOD,
    "dashes and dots in names": GOOD.replace("q1", "arm-1.q_1").replace('upper"', 'link-1.a"'),
    "names of digits": GOOD.replace('"q1"', '"1"').replace('"base"', '"0"'),
    "names of C and Python": GOOD.replace('"q1"', '"int"').replace('"q2"', '"lambda"').replace('"two"', '"double"'),
    "joint and link of one name": GOOD.replace('"q1"', '"upper"'),
    "unnormalised axis": _changed(Q1, '<axis xyz="0 0 25"/>'),
    "tiny axis": _changed(Q1, '<axis xyz="0 0 1e-300"/>'),
    "huge axis": _changed(Q1, '<axis xyz="0 0 1e300"/>'),
    "no inertia": _changed(GOOD[GOOD.index("<inertial>") : GOOD.index("</inertial>") + 11], ""),
    "no mass at all": _changed('value="2"', 'value="0"').replace('"0.1"', '"0"').replace('"0.2"', '"0"'),
    "joints before links, in no order": GOOD.replace('<link name="base"/>', "").replace(
        "</robot>", '<link name="base"/></robot>'
    ),
    "comments": _changed("<joint", "<!-- one - - joint --><joint", 3),
    "processing instruction": _changed("<joint", "<?ide fold?><joint"),
    "extensions": _changed(
        "</robot>",
        '<gazebo reference="upper"><selfCollide>true</selfCollide></gazebo><transmission name="t">'
        '<joint name="q1"><hardwareInterface/></joint></transmission><material name="m m/m"/>'
        '<ros2_control name="x y" type="system"><joint name="q 1"><limit lower="no"/></joint></ros2_control></robot>',
    ),
    "visual and collision are not read": _changed(
        '<link name="tool"/>',
        '<link name="tool"><visual><origin xyz="? ?"/><geometry><mesh filename="$(find x)/y"/></geometry></visual>'
        "<collision/><sensor_xyz/></link>",
    ),
    "declared but unused xacro namespace": _changed("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'),
    "default namespace": _changed("<robot", '<robot xmlns="http://example.org/urdf"'),
    "foreign namespace": _changed("<robot", '<robot xmlns:d="http://example.org"').replace(
        "<limit", '<limit d:jerk="no"'
    ),
    "whitespace in numbers": _changed("0 0 0.3", "\n\t 0\n 0   0.3 \t"),
    "scientific numbers": _changed("0 0 0.3", "+0. -0e0 3.0E-1"),
    "windows line ends": GOOD.replace("\n", "\r\n"),
    "byte order mark": b"\xef\xbb\xbf" + GOOD.encode(),
    "utf-16": GOOD.replace('"1.0"', '"1.0" encoding="utf-16"').encode("utf-16"),
    "latin-1": GOOD.replace('"1.0"', '"1.0" encoding="latin-1"')
    .replace("<joint", "<!-- \u00e9 --><joint")
    .encode("latin-1"),
    "no origin": _changed('<origin xyz="0 0 0.3" rpy="0 0 0"/>', ""),
    "origin without angles": _changed('0.3" rpy="0 0 0"', '0.3"'),
    "a fixed joint with a zero axis": _changed("</joint>\n</robot>", '<axis xyz="0 0 0"/></joint></robot>'),
    "dynamics, safety and calibration": _changed(
        LIMIT,
        LIMIT + '<dynamics damping="0.1"/><safety_controller k_velocity="1"/><calibration rising="0"/>',
    ),
    "a gripper beside the chain": _changed(
        "</robot>",
        '<link name="palm"/><link name="left"/><link name="right"/>'
        '<joint name="p" type="fixed"><parent link="base"/><child link="palm"/></joint>'
        '<joint name="f" type="fixed"><parent link="palm"/><child link="left"/></joint>'
        '<joint name="g" type="fixed"><parent link="palm"/><child link="right"/></joint></robot>',
    ),
}
