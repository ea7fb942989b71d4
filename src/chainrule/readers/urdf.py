"""Arms from URDF files: one chain of links, read strictly.

The file's structure is checked as a whole: one root link, every other link the child of exactly one joint, no loop,
names unique and of letters, digits and ``_ - .``, every number that is read a finite decimal. Of that tree the chain
from ``base`` to ``tip`` becomes the arm:

* fixed joints are folded into the transforms before and after the moving joints;
* a joint's axis may point anywhere and have any length but zero: a fixed rotation turns the local z axis to it, so the
  joint's frame is the URDF's link frame times that rotation;
* lower and upper, velocity, acceleration and effort become the limits of position, velocity, acceleration and torque.
  A continuous joint has no position limit. A revolute or prismatic joint on the chain must have a ``<limit>``, as URDF
  requires, with lower or upper (one left out is 0, URDF's default). A velocity or effort of 0 is how many files say
  "unknown"; it is read as no limit;
* a moving link's inertia is its own together with those of all links fixed to it, expressed in the joint's moved
  frame; links without an inertial add nothing, and where none has one the inertia is None.

Joints that branch off the chain (a gripper's fingers) may be of any type URDF has and may mimic others; the links they
move add no mass to the arm, and their inertias are not judged beyond negative numbers. On the chain a mimic, floating
or planar joint is refused. What does not bear on the chain
(visual, collision, gazebo, transmission, ros2_control and other extensions) is skipped. Numbers are kept as the file
has them: an angle of 1.5708 is not taken for a quarter turn, 1.5707963267948966 is one exactly.
"""

from __future__ import annotations

import math
import os
import re
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import PurePath
from typing import Any
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from chainrule.description import (
    MAX_JOINTS,
    Description,
    Inertia,
    Joint,
    JointKind,
    Matrix3,
    Serial,
    Transform,
    Vector3,
    check_inertia,
    check_name,
)
from chainrule.errors import DescriptionError, shown
from chainrule.readers.files import located, read_limited
from chainrule.readers.parts import FULL_TURN, rotation_rpy

#: Larger files are refused (the description of a whole humanoid takes about 1 MiB), and so are files with more
#: elements, or elements nested deeper.
MAX_BYTES = 8 * 2**20
MAX_ELEMENTS = 100_000
MAX_DEPTH = 64

_MOVING: dict[str, JointKind] = {"revolute": "R", "continuous": "R", "prismatic": "P"}
_BOUNDED = ("revolute", "prismatic")
_TYPES = (*_MOVING, "fixed", "floating", "planar")
_IN_JOINT = ("parent", "child", "origin", "axis", "limit", "mimic", "dynamics", "safety_controller", "calibration")
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def read_urdf(path: str | os.PathLike[str], *, tip: str | None = None, base: str | None = None) -> Description:
    """The chain from link ``base`` to link ``tip`` of a URDF file.

    Args:
        path: the file.
        tip: the chain's last link. May be left out where only one leaf of the tree is moved by joints.
        base: the chain's first link; the root link when left out.

    Returns:
        The arm: moving joints in order, their fixed placements, limits (SI units), and link inertias.

    Raises:
        DescriptionError: one line with the file, the joint or link that is wrong, and what would be accepted.
    """
    with located(path):
        return from_urdf(read_limited(path, MAX_BYTES), tip=tip, base=base, file=PurePath(os.fspath(path)).name)


def from_urdf(content: bytes, *, tip: str | None = None, base: str | None = None, file: str = "") -> Description:
    """The chain in a URDF's content; see :func:`read_urdf`.

    Example:
        >>> arm = from_urdf(b'''<robot name="slide"><link name="a"/><link name="b"/>
        ...     <joint name="q" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="0 3 0"/>
        ...     <limit lower="0" upper="0.5" velocity="1" effort="0"/></joint></robot>''')
        >>> arm.kinds, arm.joints[0].position, arm.joints[0].torque
        ('P', (0.0, 0.5), None)
    """
    robot = _parsed(content)
    name = _name(robot, "robot")
    links = _links(robot)
    tree = _Tree(links, _joints(robot, links))
    chain = tree.chain(_known_link(base, links, "base"), _known_link(tip, links, "tip"))
    placements, tool = _folded(chain)
    moving = [joint for joint in chain if joint.kind is not None]
    inertias = tuple(_merged(tree, joint) for joint in moving)
    shown_file = file if file.isprintable() else shown(file)
    return Description(
        name=name,
        joints=tuple(joint.description() for joint in moving),
        geometry=Serial(placements, tool),
        inertias=inertias if any(inertia is not None for inertia in inertias) else (),
        source=f"URDF {shown_file}".rstrip() + f", {chain[0].parent} to {chain[-1].child}",
    )


# --- the file as XML ---------------------------------------------------------------------------------------------


class _Limited(TreeBuilder):
    """Builds the tree, and stops at once where there is too much of it."""

    def __init__(self) -> None:
        super().__init__()
        self.elements = 0
        self.depth = 0

    def start(self, tag: Any, attrs: Any, /) -> Any:
        self.elements += 1
        self.depth += 1
        if self.elements > MAX_ELEMENTS:
            raise DescriptionError(f"more than {MAX_ELEMENTS} elements, the most that is accepted")
        if self.depth > MAX_DEPTH:
            raise DescriptionError(f"elements nested more than {MAX_DEPTH} deep, the most that is accepted")
        return super().start(tag, attrs)

    def end(self, tag: Any, /) -> Any:
        self.depth -= 1
        return super().end(tag)


def _parsed(content: bytes) -> Element:
    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import DefusedXMLParser

    parser = DefusedXMLParser(target=_Limited(), forbid_dtd=True, forbid_entities=True, forbid_external=True)
    try:
        parser.feed(content)
        root = parser.close()
    except DescriptionError:
        raise
    except DefusedXmlException:
        raise DescriptionError("has a document type declaration; entities and DTDs are not accepted") from None
    except ParseError as error:
        hint = " (an unprocessed xacro? run xacro on it first)" if b"xacro:" in content else ""
        raise DescriptionError(f"not well-formed XML: {' '.join(str(error).split())}{hint}") from None
    except (ValueError, LookupError):
        raise DescriptionError("its declared encoding cannot be read; UTF-8 is accepted") from None
    return _checked_root(root)


def _checked_root(root: Element) -> Element:
    """The root, with its own namespace (if it has one) taken off every tag, once it is known to be a URDF's."""
    space = root.tag[: root.tag.find("}") + 1]
    for element in root.iter():
        if isinstance(element.tag, str) and "xacro" in element.tag[: element.tag.find("}") + 1]:
            raise DescriptionError(f"an unprocessed xacro (element {shown(_local(element))}); run xacro on it first")
        if space and element.tag.startswith(space):
            element.tag = element.tag[len(space) :]
    if root.tag != "robot":
        raise DescriptionError(f"the root element is {shown(_local(root))}; a URDF's is 'robot'")
    return root


def _local(element: Element) -> str:
    return element.tag.rpartition("}")[2]


# --- links and joints ----------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Joint:
    """A joint of the file: what its elements say, in SI units."""

    name: str
    type: str
    parent: str
    child: str
    origin: Transform
    turn: Transform  # takes the local z axis to the joint's axis
    position: tuple[float, float] | None
    velocity: float | None
    acceleration: float | None
    torque: float | None
    mimics: str | None

    @property
    def kind(self) -> JointKind | None:
        """'R' or 'P'; None for a joint that does not move by one variable."""
        return _MOVING.get(self.type)

    def description(self) -> Joint:
        kind = _MOVING[self.type]
        return Joint(self.name, kind, self.position, self.velocity, self.acceleration, self.torque)


def _links(robot: Element) -> dict[str, Inertia | None]:
    """Each link's inertia in its own frame, by the link's name."""
    links: dict[str, Inertia | None] = {}
    for element in robot.iterfind("link"):
        name = _name(element, "link")
        if name in links:
            raise DescriptionError(f"link '{name}': the name is used twice")
        links[name] = _inertial(element, f"link '{name}'")
    if not links:
        raise DescriptionError("there is no link")
    return links


def _inertial(link: Element, where: str) -> Inertia | None:
    inertial = _only(link, "inertial", where)
    if inertial is None:
        return None
    mass = _required(_only(inertial, "mass", where), "mass", where, ("value",))
    inertia = _required(_only(inertial, "inertia", where), "inertia", where, _TENSOR)
    (value,) = _numbers(mass, "value", 1, where)
    xx, xy, xz, yy, yz, zz = (_numbers(inertia, key, 1, where)[0] for key in _TENSOR)
    if value < 0.0 or min(xx, yy, zz) < 0.0:
        what = f"mass {value} kg" if value < 0.0 else f"moment of inertia {min(xx, yy, zz)} kg m^2"
        raise DescriptionError(f"{where}: its {what} is negative")
    tensor: Matrix3 = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    placed = _origin(inertial, where)
    return Inertia(value, placed.translation, _turned(placed.rotation, tensor))


def _joints(robot: Element, links: dict[str, Inertia | None]) -> dict[str, _Joint]:
    joints: dict[str, _Joint] = {}
    for element in robot.iterfind("joint"):
        name = _name(element, "joint")
        where = f"joint '{name}'"
        if name in joints:
            raise DescriptionError(f"{where}: the name is used twice")
        joints[name] = _joint(element, name, where)
        for role, link in (("parent", joints[name].parent), ("child", joints[name].child)):
            if link not in links:
                raise DescriptionError(f"{where}: its {role} link {shown(link)} is not in the file")
    for name, joint in joints.items():
        if joint.mimics is not None and (joint.mimics not in joints or joint.mimics == name):
            raise DescriptionError(f"joint '{name}': it mimics {shown(joint.mimics)}, which is not another joint")
    return joints


def _joint(element: Element, name: str, where: str) -> _Joint:
    for part in element:
        if isinstance(part.tag, str) and "}" not in part.tag and part.tag not in _IN_JOINT:
            raise DescriptionError(f"{where}: unknown element {shown(part.tag)}; accepted are {', '.join(_IN_JOINT)}")
    kind = element.get("type")
    if kind is None or kind not in _TYPES:
        said = "it has no type" if kind is None else f"type {shown(kind)}"
        raise DescriptionError(f"{where}: {said}; accepted are {', '.join(_TYPES)}")
    parent = _required(_only(element, "parent", where), "parent", where, ("link",)).get("link", "")
    child = _required(_only(element, "child", where), "child", where, ("link",)).get("link", "")
    position, velocity, acceleration, torque = _limits(element, kind, where)
    mimic = _only(element, "mimic", where)
    if mimic is not None:
        _required(mimic, "mimic", where, ("joint",))
    return _Joint(
        name,
        kind,
        parent,
        child,
        _origin(element, where),
        _turn(element, where) if kind in _MOVING else Transform(),
        position,
        velocity,
        acceleration,
        torque,
        None if mimic is None else mimic.get("joint"),
    )


def _limits(
    joint: Element, kind: str, where: str
) -> tuple[tuple[float, float] | None, float | None, float | None, float | None]:
    """Position, velocity, acceleration and torque limits; None where there is none."""
    limit = _only(joint, "limit", where)
    if limit is None:
        return None, None, None, None
    _attributes(limit, ("lower", "upper", "velocity", "effort", "acceleration", "deceleration", "jerk"), where)
    given = {key: _numbers(limit, key, 1, where)[0] for key in limit.attrib if "}" not in key}
    position = None
    if kind in _BOUNDED and ("lower" in given or "upper" in given):
        lower, upper = given.get("lower", 0.0), given.get("upper", 0.0)
        if lower > upper:
            raise DescriptionError(f"{where}: limits [{lower}, {upper}]; the lower must not exceed the upper")
        position = (lower, upper)
    for key in ("velocity", "effort", "acceleration"):
        if given.get(key, 0.0) < 0.0:
            raise DescriptionError(f"{where}: {key} limit {given[key]}; it must not be negative")
    return position, given.get("velocity") or None, given.get("acceleration") or None, given.get("effort") or None


def _turn(joint: Element, where: str) -> Transform:
    """The rotation that takes z to the joint's axis: the smallest one, exact for axes along x, y and z."""
    axis = _only(joint, "axis", where)
    if axis is None:
        x, y, z = 1.0, 0.0, 0.0  # URDF's default
    else:
        _required(axis, "axis", where, ("xyz",))
        x, y, z = _numbers(axis, "xyz", 3, where)
    largest = max(abs(x), abs(y), abs(z))
    if largest == 0.0:
        raise DescriptionError(f"{where}: its axis is zero; any other direction is accepted")
    x, y, z = x / largest, y / largest, z / largest  # first, so that nothing under- or overflows
    length = math.hypot(x, y, z)
    x, y, z = x / length, y / length, z / length
    if z < 0.0:  # half a turn about x first: then what remains is again at most a quarter turn
        return _smallest_turn(-x, -y, -z) @ Transform.rot_x(math.pi)
    return _smallest_turn(x, y, z)


def _smallest_turn(x: float, y: float, z: float) -> Transform:
    """Rodrigues' rotation by the angle between the z axis and the unit vector (x, y, z), z >= 0, about their normal."""
    k = 1.0 / (1.0 + z)
    return Transform(((1.0 - k * x * x, -k * x * y, x), (-k * x * y, 1.0 - k * y * y, y), (-x, -y, z)))


def _origin(element: Element, where: str) -> Transform:
    origin = _only(element, "origin", where)
    if origin is None:
        return Transform()
    _attributes(origin, ("xyz", "rpy"), where)
    x, y, z = _numbers(origin, "xyz", 3, where) if "xyz" in origin.attrib else (0.0, 0.0, 0.0)
    roll, pitch, yaw = _numbers(origin, "rpy", 3, where) if "rpy" in origin.attrib else (0.0, 0.0, 0.0)
    if max(abs(roll), abs(pitch), abs(yaw)) > FULL_TURN:
        warnings.warn(
            f"{where}: rpy {roll:g} {pitch:g} {yaw:g} is more than a full turn; a URDF is in rad, not in degrees",
            stacklevel=2,
        )
    return Transform.shift(x, y, z) @ rotation_rpy(roll, pitch, yaw)


def _name(element: Element, what: str) -> str:
    name = element.get("name")
    if name is None:
        raise DescriptionError(f"a <{what}> has no name")
    return check_name(name, f"{what}{_xacro_hint(name)}")


def _only(element: Element, tag: str, where: str) -> Element | None:
    found = element.findall(tag)
    if len(found) > 1:
        raise DescriptionError(f"{where}: {len(found)} elements <{tag}>; one is accepted")
    return found[0] if found else None


def _required(element: Element | None, tag: str, where: str, attributes: tuple[str, ...]) -> Element:
    if element is None:
        raise DescriptionError(f"{where}: it has no <{tag}>")
    _attributes(element, attributes if tag != "mimic" else (*attributes, "multiplier", "offset"), where)
    for attribute in attributes:
        if element.get(attribute) is None:
            raise DescriptionError(f"{where}: its <{tag}> has no '{attribute}'")
    return element


def _attributes(element: Element, accepted: tuple[str, ...], where: str) -> None:
    for key in element.attrib:
        if "}" not in key and key not in accepted:
            raise DescriptionError(
                f"{where}: <{element.tag}> has an unknown attribute {shown(key)}; accepted are {', '.join(accepted)}"
            )


def _numbers(element: Element, attribute: str, count: int, where: str) -> tuple[float, ...]:
    text = element.get(attribute, "")
    words = text.split()
    if len(words) != count or not all(_DECIMAL.fullmatch(word) for word in words):
        accepted = "a decimal number is" if count == 1 else f"{count} decimal numbers are"
        raise DescriptionError(
            f"{where}: <{element.tag}> {attribute}={shown(text)}{_xacro_hint(text)}; {accepted} accepted"
        )
    numbers = tuple(float(word) for word in words)
    if not all(math.isfinite(number) for number in numbers):
        raise DescriptionError(f"{where}: <{element.tag}> {attribute}={shown(text)} is not finite")
    return numbers


def _xacro_hint(text: str) -> str:
    return " (an unprocessed xacro; run xacro on it first)" if "${" in text or "$(" in text else ""


# --- the tree ------------------------------------------------------------------------------------------------------


class _Tree:
    """The links as a tree: which joint leads to a link, and which joints leave it."""

    def __init__(self, links: dict[str, Inertia | None], joints: dict[str, _Joint]) -> None:
        self.links = links
        self.above: dict[str, _Joint] = {}
        self.below: dict[str, list[_Joint]] = {link: [] for link in links}
        for joint in joints.values():
            if joint.child in self.above:
                raise DescriptionError(
                    f"joint '{joint.name}': its child link '{joint.child}' already has a parent, by joint "
                    f"'{self.above[joint.child].name}'; a link has one parent"
                )
            self.above[joint.child] = joint
            self.below[joint.parent].append(joint)
        roots = [link for link in links if link not in self.above]
        if len(roots) > 1:
            raise DescriptionError(f"links {_listed(roots)} have no parent joint; exactly one root link is accepted")
        reached = sum(1 for _ in self._walk(roots[0])) if roots else 0
        if reached < len(links):
            self._refuse_loop(roots)
        self.root = roots[0]

    def chain(self, base: str | None, tip: str | None) -> list[_Joint]:
        """The joints from ``base`` to ``tip`` in order; at least one of them moves and none is refused."""
        base = self.root if base is None else base
        tip = self._only_tip(base) if tip is None else tip
        chain: list[_Joint] = []
        link = tip
        while link != base:
            if link not in self.above:
                raise DescriptionError(f"tip '{tip}' is not below base '{base}'; a link below it is accepted")
            chain.append(self.above[link])
            link = self.above[link].parent
        chain.reverse()
        for joint in chain:
            if joint.mimics is not None:
                raise DescriptionError(
                    f"joint '{joint.name}': it mimics '{joint.mimics}', which is not accepted between base and tip"
                )
            if joint.kind is None and joint.type != "fixed":
                raise DescriptionError(
                    f"joint '{joint.name}': a {joint.type} joint is not accepted between base and tip; "
                    "revolute, continuous, prismatic and fixed are"
                )
            if joint.type in _BOUNDED and joint.position is None:
                raise DescriptionError(
                    f"joint '{joint.name}': a {joint.type} joint needs a <limit> with lower and upper"
                    + " (or make it continuous)" * (joint.kind == "R")
                )
        moving = sum(joint.kind is not None for joint in chain)
        if not 1 <= moving <= MAX_JOINTS:
            raise DescriptionError(
                f"{moving} moving joints between base '{base}' and tip '{tip}'; 1 to {MAX_JOINTS} are accepted"
            )
        return chain

    def fixed_to(self, link: str) -> Iterator[tuple[str, Transform]]:
        """``link`` and every link fixed to it, each with its frame's placement in that of ``link``."""
        waiting = [(link, Transform())]
        while waiting:
            name, placed = waiting.pop()
            yield name, placed
            waiting += [(j.child, placed @ j.origin) for j in self.below[name] if j.type == "fixed"]

    def _walk(self, link: str) -> Iterator[tuple[str, int]]:
        """The links at and below ``link``, each with the number of joints that move it, as seen from ``link``."""
        waiting = [(link, 0)]
        while waiting:
            name, moving = waiting.pop()
            yield name, moving
            waiting += [(joint.child, moving + (joint.type != "fixed")) for joint in self.below[name]]

    def _only_tip(self, base: str) -> str:
        leaves = [(moving, link) for link, moving in self._walk(base) if moving and not self.below[link]]
        if not leaves:
            raise DescriptionError(f"no joint moves anything below base '{base}'")
        if len(leaves) > 1:
            leaves.sort(key=lambda leaf: -leaf[0])  # those moved by most joints first
            raise DescriptionError(
                f"more than one link can be the tip; give one, for example tip={_listed([link for _, link in leaves])}"
            )
        return leaves[0][1]

    def _refuse_loop(self, roots: list[str]) -> None:
        reached = {link for link, _ in self._walk(roots[0])} if roots else set()
        link = next(link for link in self.links if link not in reached)
        seen: list[str] = []
        while link not in seen:  # every link outside the tree has a parent outside it, so this ends in the loop
            seen.append(link)
            link = self.above[link].parent
        loop = seen[seen.index(link) :]  # from each link to its parent, so the joints are met backwards
        names = [self.above[name].name for name in reversed(loop)]
        raise DescriptionError(f"a loop of joints, {_listed(names)}; a tree is accepted")


def _known_link(name: str | None, links: dict[str, Inertia | None], what: str) -> str | None:
    if name is not None and name not in links:
        near = get_close_matches(str(name), links, n=6) if len(links) > 6 else []
        has = f"like it are {_listed(near)}" if near else f"it has {_listed(list(links))}"
        raise DescriptionError(f"{what} {shown(name)} is not a link of the file; {has}")
    return name


def _listed(names: list[str], most: int = 6) -> str:
    return ", ".join(f"'{name}'" for name in names[:most]) + (f" and {len(names) - most} more" * (len(names) > most))


def _folded(chain: list[_Joint]) -> tuple[tuple[Transform, ...], Transform]:
    """The placement before each moving joint, and the tool.

    Motion about or along an axis a = R z is R (motion about or along z) R^T: R joins the transform before the joint,
    R^T the one after it.
    """
    placements = []
    fixed = Transform()
    for joint in chain:
        fixed = fixed @ joint.origin
        if joint.kind is not None:
            placements.append(fixed @ joint.turn)
            fixed = Transform(_transposed(joint.turn.rotation))
    return tuple(placements), fixed


# --- inertias ------------------------------------------------------------------------------------------------------


def _merged(tree: _Tree, joint: _Joint) -> Inertia | None:
    """The inertia of the body that ``joint`` moves, in the joint's moved frame.

    With m = sum m_k and c = sum m_k c_k / m, the parallel-axis theorem gives
    I = sum (I_k + m_k (|r_k|^2 E - r_k r_k^T)), r_k = c_k - c.
    """
    to_joint = Transform(_transposed(joint.turn.rotation))
    parts = []
    for link, placed in tree.fixed_to(joint.child):
        inertia = tree.links[link]
        if inertia is not None:
            check_inertia(inertia, f"link '{link}'")
            in_joint = to_joint @ placed
            centre = (in_joint @ Transform.shift(*inertia.centre)).translation
            parts.append(Inertia(inertia.mass, centre, _turned(in_joint.rotation, inertia.tensor)))
    if len(parts) <= 1:
        return parts[0] if parts else None
    mass = math.fsum(part.mass for part in parts)
    weights = [part.mass / mass if mass > 0.0 else 0.0 for part in parts]
    x, y, z = (math.fsum(w * part.centre[i] for w, part in zip(weights, parts, strict=True)) for i in range(3))
    tensors = [_shifted(part, (x, y, z)) for part in parts]
    return Inertia(mass, (x, y, z), _matrix(lambda i, j: math.fsum(tensor[i][j] for tensor in tensors)))


def _shifted(part: Inertia, centre: Vector3) -> Matrix3:
    """The tensor of ``part`` about ``centre``."""
    r = [a - b for a, b in zip(part.centre, centre, strict=True)]
    square = math.fsum(x * x for x in r)
    return _matrix(lambda i, j: part.tensor[i][j] + part.mass * ((square if i == j else 0.0) - r[i] * r[j]))


def _turned(rotation: Matrix3, tensor: Matrix3) -> Matrix3:
    """R I R^T, kept symmetric."""
    half = [[math.fsum(row[k] * tensor[k][j] for k in range(3)) for j in range(3)] for row in rotation]
    full = [[math.fsum(half[i][k] * rotation[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    return _matrix(lambda i, j: (full[i][j] + full[j][i]) / 2.0 + 0.0)


def _transposed(rotation: Matrix3) -> Matrix3:
    return _matrix(lambda i, j: rotation[j][i])


def _matrix(entry: Callable[[int, int], float]) -> Matrix3:
    return tuple((entry(i, 0), entry(i, 1), entry(i, 2)) for i in range(3))  # type: ignore[return-value]  # three rows
