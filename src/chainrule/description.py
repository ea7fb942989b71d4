"""What an arm is: joints, fixed transforms, limits and inertias, as immutable data.

Nothing here computes kinematics. A :class:`Description` is plain numbers (SI units, radians), so it can be
hashed, compared, written to JSON and handed to ``derive`` without anything else of the runtime.

Two geometries exist. :class:`Serial` is any spatial chain: a fixed transform before each joint, then the
joint's motion about (revolute) or along (prismatic) the local z axis, and a tool transform at the end.
:class:`Planar` is a chain in the plane: a revolute joint turns the heading by theta_i and advances l_i along
it, a prismatic joint turns it by the constant heading_i and advances l_i + theta_i.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from numbers import Real
from typing import Literal

from chainrule.errors import DescriptionError, shown

Vector3 = tuple[float, float, float]
Matrix3 = tuple[Vector3, Vector3, Vector3]
JointKind = Literal["R", "P"]

#: Names of arms, joints and links: letters, digits, ``_ - .``, at most 128, starting with a letter, digit or ``_``.
NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.\-]{0,127}")

#: More joints than this are refused: a description is typed by people or exported, not streamed.
MAX_JOINTS = 256

_IDENTITY: Matrix3 = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def check_name(name: str, what: str) -> str:
    """Return ``name`` if it is one we accept, else raise :class:`DescriptionError` naming ``what``."""
    if not isinstance(name, str) or not NAME.fullmatch(name):
        raise DescriptionError(
            f"{what}: the name {shown(name)} is not accepted (1 to 128 letters, digits, '_', '-', '.'; "
            "the first a letter, digit or '_')"
        )
    return name


def check_finite(value: object, what: str) -> float:
    """Return ``value`` as a float if it is a finite real number, else raise :class:`DescriptionError`."""
    if isinstance(value, bool) or not isinstance(value, Real):  # Real: NumPy scalars are welcome, text is not
        raise DescriptionError(f"{what}: {shown(value)} is not a number")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise DescriptionError(f"{what}: {shown(value)} is not finite")
    return number + 0.0  # -0.0 becomes 0.0, so equal descriptions have equal digests


def exact_cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine, with the quarter turns exact: ``exact_cos_sin(math.pi / 2) == (0.0, 1.0)``."""
    quarter = round(angle / (math.pi / 2))
    if angle == quarter * (math.pi / 2) and abs(quarter) <= 64:  # far out every double is "a multiple"
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarter % 4]
    return math.cos(angle), math.sin(angle)


@dataclass(frozen=True, slots=True)
class Transform:
    """A rigid displacement: ``rotation`` (3 x 3, row by row) and ``translation`` (3,) in metres."""

    rotation: Matrix3 = _IDENTITY
    translation: Vector3 = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        # -0.0 becomes 0.0, so equal transforms have equal digests.
        object.__setattr__(self, "rotation", tuple(tuple(x + 0.0 for x in row) for row in self.rotation))
        object.__setattr__(self, "translation", tuple(x + 0.0 for x in self.translation))

    def __matmul__(self, other: Transform) -> Transform:
        """Composition: ``(a @ b)`` applies ``b`` in the frame that ``a`` leads to."""
        a, b = self.rotation, other.rotation
        rotation = tuple(tuple(math.fsum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)) for i in range(3))
        translation = tuple(
            math.fsum([*(a[i][k] * other.translation[k] for k in range(3)), self.translation[i]]) for i in range(3)
        )
        return Transform(rotation, translation)  # type: ignore[arg-type]

    @staticmethod
    def rot_x(angle: float) -> Transform:
        """Rotation about x by ``angle`` rad."""
        c, s = exact_cos_sin(angle)
        return Transform(((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)))

    @staticmethod
    def rot_y(angle: float) -> Transform:
        """Rotation about y by ``angle`` rad."""
        c, s = exact_cos_sin(angle)
        return Transform(((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)))

    @staticmethod
    def rot_z(angle: float) -> Transform:
        """Rotation about z by ``angle`` rad."""
        c, s = exact_cos_sin(angle)
        return Transform(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)))

    @staticmethod
    def shift(x: float, y: float, z: float) -> Transform:
        """Translation by (x, y, z) m."""
        return Transform(_IDENTITY, (float(x), float(y), float(z)))


@dataclass(frozen=True, slots=True)
class Inertia:
    """Mass (kg), centre of mass (m) and inertia about the centre (kg m^2), in the link's joint frame.

    That frame moves with the joint, whose axis is its z. A planar arm's lies in the plane instead: x along the heading,
    the origin at the revolute joint, or for a prismatic one theta_i along the heading from where it is mounted, so that
    the next joint is at (l_i, 0); of its inertia only the mass, the centre's x and y and the moment about z count.
    """

    mass: float
    centre: Vector3
    tensor: Matrix3

    def about_origin(self) -> tuple[float, ...]:
        """The ten numbers that dynamics are linear in: m, m c (3), tensor about the frame's origin (6).

        The tensor's entries are xx, xy, xz, yy, yz, zz; I_o = I + m (|c|^2 E - c c^T), the parallel-axis theorem.

        Example:
            >>> Inertia(2.0, (0.5, 0.0, 0.0), ((0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1))).about_origin()
            (2.0, 1.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.6, 0.0, 0.6)
        """
        c, square = self.centre, math.fsum(x * x for x in self.centre)
        turning = (
            self.tensor[i][j] + self.mass * ((square if i == j else 0.0) - c[i] * c[j])
            for i in range(3)
            for j in range(i, 3)
        )
        return (self.mass, *(self.mass * x for x in c), *turning)


@dataclass(frozen=True, slots=True)
class Joint:
    """One joint: its name, kind ('R' revolute, 'P' prismatic) and limits (None where there is none).

    ``position`` is (lower, upper) in rad or m; ``velocity``, ``acceleration`` and ``torque`` are magnitudes
    (rad/s or m/s, rad/s^2 or m/s^2, N m or N).
    """

    name: str
    kind: JointKind
    position: tuple[float, float] | None = None
    velocity: float | None = None
    acceleration: float | None = None
    torque: float | None = None

    @property
    def middle_and_narrowness(self) -> tuple[float, float]:
        """The middle of its range, and 1 / half its width; 0 and 0 without limits that are apart."""
        low, high = self.position or (0.0, 0.0)
        bounded = math.isfinite(low) and math.isfinite(high) and low < high
        return (low / 2 + high / 2, 1 / (high / 2 - low / 2)) if bounded else (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class DHRow:
    """One Denavit-Hartenberg row: kind, alpha (rad), a (m), d (m), theta (rad).

    theta is the offset of a revolute joint, d that of a prismatic one. In the modified (Craig) convention
    alpha and a belong to the link before the joint, in the standard convention to the link after it.
    """

    kind: JointKind
    alpha: float
    a: float
    d: float
    theta: float


@dataclass(frozen=True, slots=True)
class Serial:
    """A spatial chain: ``placements[i]`` leads from joint i-1's moved frame to joint i's, then motion along z."""

    placements: tuple[Transform, ...]
    tool: Transform = Transform()
    table: tuple[DHRow, ...] | None = None  # the rows it was given by, for display only
    convention: Literal["modified", "standard"] | None = None


@dataclass(frozen=True, slots=True)
class Planar:
    """A planar chain: ``lengths`` (m) and ``headings`` (rad; used by prismatic joints, 0 for revolute ones)."""

    lengths: tuple[float, ...]
    headings: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Orthogonal3R:
    """The orthogonal 3R family: alpha_2 = -90 deg, alpha_3 = 90 deg, r_3 = 0; lengths d2, d3, d4, r2 in m."""

    d2: float
    d3: float
    d4: float
    r2: float


Geometry = Serial | Planar | Orthogonal3R


@dataclass(frozen=True, slots=True)
class Description:
    """An arm: its name, joints, geometry, link inertias (one per joint, None where unknown) and source."""

    name: str
    joints: tuple[Joint, ...]
    geometry: Geometry
    inertias: tuple[Inertia | None, ...] = ()
    source: str = ""
    model: Model = field(init=False, compare=False)

    def __post_init__(self) -> None:
        check_name(self.name, "arm")
        n = len(self.joints)
        if not 1 <= n <= MAX_JOINTS:
            raise DescriptionError(f"arm {self.name}: {n} joints; between 1 and {MAX_JOINTS} are accepted")
        seen: set[str] = set()
        for i, joint in enumerate(self.joints, 1):
            _check_joint(joint, f"arm {self.name}, joint {i}")
            if joint.name in seen:
                raise DescriptionError(f"arm {self.name}, joint {i}: the name '{joint.name}' is used twice")
            seen.add(joint.name)
        _check_geometry(self.geometry, self.kinds, f"arm {self.name}")
        if self.inertias and len(self.inertias) != n:
            raise DescriptionError(f"arm {self.name}: {len(self.inertias)} inertias for {n} joints")
        for joint, inertia in zip(self.joints, self.inertias, strict=False):
            if inertia is not None:
                check_inertia(inertia, f"arm {self.name}, joint '{joint.name}'")
        object.__setattr__(self, "model", _model(self))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joints)

    @property
    def kinds(self) -> str:
        """The joints' kinds as one word, such as ``"RRP"``."""
        return "".join(joint.kind for joint in self.joints)


@dataclass(frozen=True, slots=True)
class Model:
    """What generated code depends on: the symbolic structure, without limits, inertias or the family's numbers.

    ``parameters`` are the numbers a family's functions take at run time (empty for a serial chain, whose
    numbers are in its code). ``digest`` identifies the structure; ``name`` is a safe identifier. The family
    ``motion`` is no arm: motion profiles along one axis; ``regional_3r`` is the normal form of any 3R arm.
    """

    family: Literal["serial", "planar", "orthogonal_3r", "regional_3r", "motion"]
    name: str
    kinds: str = ""
    parameter_names: tuple[str, ...] = ()
    parameters: tuple[float, ...] = ()
    placements: tuple[Transform, ...] = ()
    tool: Transform = Transform()

    @property
    def digest(self) -> str:
        """What identifies the structure: everything but the family's numbers."""
        transforms = [[t.rotation, t.translation] for t in (*self.placements, self.tool)]
        content = [self.family, self.kinds, self.parameter_names, transforms]
        return hashlib.sha256(json.dumps(content, separators=(",", ":")).encode()).hexdigest()


#: Motion profiles along one axis, from rest to rest.
REST_TO_REST = Model("motion", "motion")

#: Any arm of three revolute joints that positions a point, in normal form: cosines and sines of its twists, lengths.
REGIONAL_3R = Model("regional_3r", "regional_3r", "RRR", ("ca2", "sa2", "ca3", "sa3", "d2", "d3", "d4", "r2", "r3"))


def planar_model(kinds: str, lengths: Sequence[float] = (), headings: Sequence[float] = ()) -> Model:
    """The model of the planar chains with these joints; the numbers of one of them when given."""
    turning = [i for i, kind in enumerate(kinds) if kind == "P"]
    names = (*(f"l{i + 1}" for i in range(len(kinds))), *(f"heading{i + 1}" for i in turning))
    values = (*lengths, *(headings[i] for i in turning)) if headings else ()
    return Model("planar", f"planar_{kinds.lower()}", kinds, names, tuple(values))


def identifier(name: str) -> str:
    """A C and Python identifier from an accepted name: ``identifier("ur5-e.v2") == "ur5_e_v2"``."""
    word = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")
    return word if word and not word[0].isdigit() else f"arm_{word}".rstrip("_")


def _model(description: Description) -> Model:
    geometry, kinds = description.geometry, description.kinds
    if isinstance(geometry, Planar):
        return planar_model(kinds, geometry.lengths, geometry.headings)
    if isinstance(geometry, Orthogonal3R):
        values = (geometry.d2, geometry.d3, geometry.d4, geometry.r2)
        return Model("orthogonal_3r", "orthogonal_3r", kinds, ("d2", "d3", "d4", "r2"), values)
    name = identifier(description.name)
    return Model("serial", name, kinds, placements=geometry.placements, tool=geometry.tool)


def _check_geometry(geometry: Geometry, kinds: str, where: str) -> None:
    if isinstance(geometry, Orthogonal3R):
        if kinds != "RRR":
            raise DescriptionError(f"{where}: joints {kinds}; the orthogonal 3R arm has three revolute ones")
        return
    parts = (geometry.placements,) if isinstance(geometry, Serial) else (geometry.lengths, geometry.headings)
    for part in parts:
        if len(part) != len(kinds):
            raise DescriptionError(f"{where}: {len(part)} entries in its geometry for {len(kinds)} joints")


def _check_joint(joint: Joint, where: str) -> None:
    check_name(joint.name, where)
    if joint.kind not in ("R", "P"):
        raise DescriptionError(f"{where} '{joint.name}': kind {joint.kind!r}; 'R' or 'P' is accepted")
    if joint.position is not None:
        lower, upper = joint.position
        if math.isnan(lower) or math.isnan(upper) or lower > upper:
            raise DescriptionError(
                f"{where} '{joint.name}': position limits [{lower}, {upper}]; the lower must not exceed the upper"
            )
    for what in ("velocity", "acceleration", "torque"):
        value = getattr(joint, what)
        if value is not None and not value >= 0.0:
            raise DescriptionError(f"{where} '{joint.name}': {what} limit {value}; it must not be negative")


def check_inertia(inertia: Inertia, where: str) -> None:
    """Raise :class:`DescriptionError` unless the mass is not negative and the tensor is that of a real body.

    A tensor is accepted when it is symmetric, positive semidefinite, and its principal moments satisfy the
    triangle inequality, each to a relative 1e-6 (files carry rounded numbers).
    """
    numbers = [inertia.mass, *inertia.centre, *(entry for row in inertia.tensor for entry in row)]
    if not all(math.isfinite(number) for number in numbers):
        raise DescriptionError(f"{where}: mass, centre and inertia must be finite numbers")
    if inertia.mass < 0.0:
        raise DescriptionError(f"{where}: mass {inertia.mass} kg is negative")
    tensor = inertia.tensor
    scale = max((abs(entry) for row in tensor for entry in row), default=0.0)
    if any(abs(tensor[i][j] - tensor[j][i]) > 1e-6 * scale for i in range(3) for j in range(i)):
        raise DescriptionError(f"{where}: the inertia tensor is not symmetric")
    import numpy as np  # only arms with inertias need it here

    moments = np.linalg.eigvalsh(np.array(tensor))
    if moments[0] < -1e-6 * scale or moments[2] > moments[0] + moments[1] + 1e-6 * scale:
        raise DescriptionError(
            f"{where}: the inertia tensor is not that of a body (principal moments "
            f"{', '.join(f'{m:.6g}' for m in moments)}; none may be negative or exceed the sum of the others)"
        )


def with_limits(
    description: Description,
    *,
    position: Sequence[Sequence[float] | None] | None = None,
    velocity: Sequence[float | None] | None = None,
    acceleration: Sequence[float | None] | None = None,
    torque: Sequence[float | None] | None = None,
) -> Description:
    """A copy with the given limits: ``position`` (n, 2), the rest (n,); None or inf means no limit.

    Raises:
        DescriptionError: on a wrong number of entries, nan, or a lower limit above the upper.
    """
    joints = list(description.joints)
    for what, values in (
        ("position", position),
        ("velocity", velocity),
        ("acceleration", acceleration),
        ("torque", torque),
    ):
        if values is None:
            continue
        try:
            entries = list(values)
        except TypeError:
            raise DescriptionError(f"{what} limits: {shown(values)}; one entry per joint is accepted") from None
        if len(entries) != len(joints):
            raise DescriptionError(f"{what} limits: {len(entries)} entries for {len(joints)} joints")
        for i, entry in enumerate(entries):
            limit = {what: _limit(what, entry, f"{what} limit of joint {i + 1}")}
            joints[i] = replace(joints[i], **limit)  # type: ignore[arg-type]  # one limit by its field's name
    return replace(description, joints=tuple(joints))


def with_inertias(description: Description, inertias: Sequence[Inertia | None]) -> Description:
    """A copy with the given link inertias, one for each joint, None where unknown.

    Raises:
        DescriptionError: on a wrong number of entries, or an inertia that no body has.
    """
    if not isinstance(inertias, Sequence) or not all(isinstance(body, Inertia | None) for body in inertias):
        raise DescriptionError(f"inertias: {shown(inertias)}; one Inertia, or None, per joint is accepted")
    return replace(description, inertias=tuple(inertias))


def _limit(what: str, entry: object, where: str) -> object:
    if entry is None:
        return None
    if what == "position":
        try:
            lower, upper = (_bound(bound, where) for bound in entry)  # type: ignore[attr-defined]
        except DescriptionError:
            raise
        except (TypeError, ValueError):
            raise DescriptionError(f"{where}: {shown(entry)} is not a pair (lower, upper)") from None
        return None if (lower, upper) == (-math.inf, math.inf) else (lower, upper)
    value = _bound(entry, where)
    return None if value == math.inf else value


def _bound(value: object, where: str) -> float:
    """A limit as a float: any real number or an infinity."""
    if isinstance(value, (float, Real)) and math.isinf(value):
        return float(value)
    return check_finite(value, where)
