"""Any arm of three revolute joints that positions a point, in the normal form of ``chainrule.derive.regional_3r``.

Between two joints the fixed transform is Rz(before) Tz(height) Rx(alpha) Tx(d) Rz(after) Tz(r), with the common normal
of the two axes in the middle; what is left of it besides (alpha, d) goes into the joints' offsets and r. Lengths d2,
d3, d4 are never negative. Where alpha2 and alpha3 are right angles and r3 = 0, axes are reversed so that sa2 = -1 and
sa3 = 1: the orthogonal family of Baili, Wenger and Chablat.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from runpy import run_path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule import compile as compiling
from chainrule.arm import Arm
from chainrule.description import REGIONAL_3R, Description, Model, Orthogonal3R, Serial, Transform
from chainrule.errors import InputError
from chainrule.evaluators import Evaluators
from chainrule.inputs import real_array, whole_number

Array = NDArray[Any]

#: A sine of a twist below the first counts as 0 (parallel axes), and a cosine below the second (a right angle).
PARALLEL, CROSSED = 1e-12, 1e-15
#: The shortest and the longest length (m) other than 0, and how many times the shortest the longest may be: det J stays
#: within double precision, and the exact answers take no longer than a second.
SHORTEST, LONGEST, RATIO = 1e-100, 1e100, 1e60

ORTHOGONAL_3R = Model("orthogonal_3r", "orthogonal_3r", "RRR", ("d2", "d3", "d4", "r2"))


@dataclass(frozen=True)
class Regional:
    """An arm of three revolute joints and a point of its last link, in normal form.

    The angles of the normal form are theta = signs * q + offsets; a point p of the arm's base frame is
    rotation^T (p - origin) in the normal form's.

    Attributes:
        parameters: (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3), cosines and sines of the twists, lengths in m.
        signs: (3,) 1 or -1: which axes were reversed.
        offsets: (3,) rad.
        frame: the normal form's base in the arm's.
        name: what the arm is called.
    """

    parameters: tuple[float, ...]
    signs: tuple[int, int, int] = (1, 1, 1)
    offsets: tuple[float, float, float] = (0.0, 0.0, 0.0)
    frame: Transform = field(default_factory=Transform)
    name: str = "arm"

    def __post_init__(self) -> None:
        check_lengths(self.name, self.parameters[4:])

    @classmethod
    def of(cls, arm: Arm | Description, joints: int = 3, tip: Any = None) -> Regional:
        """The normal form of the first three joints of an arm.

        Args:
            arm: an arm, or its description.
            joints: how many joints position the point: 3 is accepted.
            tip: the point (3,) in the frame of the third link, in m; for an arm of three joints its tool when absent.

        Raises:
            InputError: fewer than three joints, prismatic ones among the first three, no tip where one is needed,
                lengths beyond 1e-100 to 1e100 m or more than 1e60 times one another.

        Example:
            >>> from chainrule import orthogonal_3r
            >>> Regional.of(orthogonal_3r(1.0, 2.0, 1.5, 1.0)).orthogonal
            (1.0, 2.0, 1.5, 1.0)
        """
        description = arm.description if isinstance(arm, Arm) else arm
        if whole_number(joints, "joints") != 3:
            raise InputError(f"joints: {joints}; the point must be positioned by 3 joints")
        if description.n < 3 or description.kinds[:3] != "RRR":
            raise InputError(f"{description.name}: joints {description.kinds}; three revolute ones must come first")
        placements, tool = _placements(description)
        if tip is not None:
            point = real_array(tip, "tip")
            if point.shape != (3,):
                raise InputError(f"tip: an array of shape {point.shape}; a point (3,) is accepted")
            at = tuple(float(x) for x in point)
        elif description.n == 3:
            at = tool.translation
        else:
            raise InputError(f"{description.name}: {description.n} joints; name the point of link 3 with tip=(x, y, z)")
        return _normal_form(description.name, placements, at)

    @property
    def orthogonal(self) -> tuple[float, float, float, float] | None:
        """(d2, d3, d4, r2) where the arm is of the orthogonal family, else None."""
        ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3 = self.parameters
        right = (ca2, sa2, ca3, sa3, r3) == (0.0, -1.0, 0.0, 1.0, 0.0)
        return (d2, d3, d4, r2) if right else None

    @property
    def nongeneric(self) -> tuple[str, ...]:
        """Why the arm is not generic, in words; empty where it is."""
        _, sa2, _, sa3, d2, d3, d4, r2, _ = self.parameters
        reasons = []
        for pair, sine, distance in (("1 and 2", sa2, d2), ("2 and 3", sa3, d3)):
            if sine == 0.0:
                reasons.append(f"axes {pair} " + ("coincide" if distance == 0.0 else "are parallel"))
            elif distance == 0.0:
                reasons.append(f"axes {pair} intersect")
        if d4 == 0.0:
            reasons.append("the point lies on axis 3")
        if self.orthogonal is not None and r2 == 0.0:
            reasons.append("r2 = 0: the common normals of an orthogonal arm meet on axis 2")
        return tuple(reasons)

    @property
    def orientation(self) -> int:
        """1, or -1 where an odd number of axes was reversed: det J of the arm over det J of the normal form."""
        return math.prod(self.signs)

    @property
    def size(self) -> float:
        """The sum of all lengths: no point that the arm reaches is farther from the normal form's origin."""
        return math.fsum(abs(length) for length in self.parameters[4:])

    # ---- from the arm and back ---------------------------------------------------------------------------------

    def to_normal(self, q: Any) -> Array:
        """Angles of the normal form of joint values ``q`` (..., 3), rad, not wrapped."""
        found: Array = np.asarray(q) * np.array(self.signs) + np.array(self.offsets)
        return found

    def from_normal(self, theta: Any) -> Array:
        """Joint values of angles ``theta`` (..., 3) of the normal form, rad, not wrapped."""
        found: Array = (np.asarray(theta) - np.array(self.offsets)) * np.array(self.signs)
        return found

    def point_to_normal(self, points: Any) -> Array:
        """Points (..., 3) of the arm's base frame in the normal form's, m."""
        found: Array = (np.asarray(points) - np.array(self.frame.translation)) @ np.array(self.frame.rotation)
        return found

    def point_from_normal(self, points: Any) -> Array:
        """Points (..., 3) of the normal form's base frame in the arm's, m."""
        found: Array = np.asarray(points) @ np.array(self.frame.rotation).T + np.array(self.frame.translation)
        return found

    # ---- generated functions -----------------------------------------------------------------------------------

    @cached_property
    def values(self) -> Array:
        """The parameters as an array (9,)."""
        return np.array(self.parameters)

    def quartic(self, targets: Any) -> Array:
        """Coefficients (..., 5), lowest power of tan(theta3 / 2) first, for targets (rho^2, z) (..., 2)."""
        found: Array = evaluator("quartic")(self.values, targets)
        return found

    def determinant_terms(self, theta3: Any) -> Array:
        """a, b, c (..., 3) of det J = a cos(theta2) + b sin(theta2) + c, of the arm's own det J in m^3."""
        found: Array = self.orientation * evaluator("determinant_terms")(self.values, *_turns(theta3))
        return found

    def determinant(self, theta2: Any, theta3: Any) -> Array:
        """The arm's own det J (...), m^3, at angles of the normal form; both broadcast."""
        found: Array = self.orientation * evaluator("determinant")(self.values, *_turns(theta2, theta3))
        return found

    def image(self, theta2: Any, theta3: Any) -> Array:
        """(rho, z) (..., 2) of angles of the normal form, m."""
        found: Array = evaluator("image")(self.values, *_turns(theta2, theta3))
        found[..., 0] = np.sqrt(found[..., 0])
        return found

    def point(self, theta: Any) -> Array:
        """The point (..., 3) that angles ``theta`` (..., 3) of the normal form reach, in its frame, m."""
        given = np.asarray(theta, float)
        x, y, z = np.moveaxis(evaluator("unturned")(self.values, *_turns(given[..., 1], given[..., 2])), -1, 0)
        c, s = np.cos(given[..., 0]), np.sin(given[..., 0])
        return np.stack([c * x - s * y, s * x + c * y, z], axis=-1)

    def section_postures(self, points: Any, *, exactly: bool = True) -> Array:
        """Postures (..., 4, 3) in angles of the normal form, at ``points`` (..., 3) of its frame.

        Without ``exactly`` points that floating point does not decide have none.
        """
        from chainrule.cuspidality.postures import section

        return section(self, real_array(points, "points"), exactly=exactly).theta

    @cached_property
    def rationals(self) -> Array:
        """The parameters as an object array of ``fmpq``: what is decided exactly is decided for these.

        Lengths at their binary value. A twist that is no multiple of 90 deg has the half tangent that is nearest as a
        double, within 1e-16 of it, so that its cosine and sine are rational and lie on the unit circle.
        """
        ca2, sa2, ca3, sa3, *lengths = self.parameters
        values = [*_rational_turn(ca2, sa2), *_rational_turn(ca3, sa3), *(_fraction(length) for length in lengths)]
        found: Array = np.array(values, object)
        return found

    def exactly(self, name: str, *inputs: Any) -> Array:
        """A generated function of the normal form on ``fmpq`` or ``arb``: nested sequences in, an object array out."""
        found: Array = exact_function(name)(self.rationals, *(_objects(given) for given in inputs))
        return found

    def exact_quartic(self, targets: Any) -> Array:
        """As :meth:`quartic`, exactly."""
        return self.exactly("quartic", targets)

    def exact_aspect_polynomial(self) -> Array:
        """(a^2 + b^2 - c^2) / d4^2 times (1 + t^2)^4, lowest power of t = tan(theta3 / 2) first: (9,) exactly."""
        return self.exactly("aspect_polynomial")

    def exact_determinant_terms(self, elbows: Any) -> Array:
        """As :meth:`determinant_terms`, exactly, from (cos theta3, sin theta3) (..., 2)."""
        found: Array = self.orientation * self.exactly("determinant_terms", elbows)
        return found

    def exact_determinant(self, shoulders: Any, elbows: Any) -> Array:
        """As :meth:`determinant`, exactly, from cosines and sines (..., 2) of theta2 and theta3."""
        found: Array = self.orientation * self.exactly("determinant", shoulders, elbows)
        return found


def check_lengths(name: str, lengths: Sequence[float | Fraction]) -> None:
    """Refuse lengths (d2, d3, d4, r2, r3) that are too far from one another, or from 1 m, for the answers to be right.

    Raises:
        InputError: names the shortest and the longest.

    Example:
        >>> check_lengths("arm", (1.0, 0.0, 1e-61, 1.0, 0.0))
        Traceback (most recent call last):
        ...
        chainrule.errors.InputError: arm: d4 = 1e-61 m and d2 = 1 m; lengths of 0, or from 1e-100 to 1e100 m and none \
more than 1e60 times another, are accepted
    """
    names = REGIONAL_3R.parameter_names[4:]
    given = {name: max(length, -length) for name, length in zip(names, lengths, strict=True) if length != 0}
    if not given:
        return
    first, last = min(given, key=given.__getitem__), max(given, key=given.__getitem__)
    shortest, longest = given[first], given[last]
    if shortest >= SHORTEST and longest <= LONGEST and longest / shortest <= RATIO:
        return
    said = f"{first} = {_short(shortest)} m" + ("" if first == last else f" and {last} = {_short(longest)} m")
    raise InputError(
        f"{name}: {said}; lengths of 0, or from 1e-100 to 1e100 m and none more than 1e60 times another, are accepted"
    )


def _short(length: float | Fraction) -> str:
    """Six digits, also of a fraction that no double is near."""
    if isinstance(length, Fraction):
        return f"{Decimal(f'{Decimal(length.numerator) / Decimal(length.denominator):.6g}').normalize():g}"
    return f"{length:g}"


# ---- generated functions -----------------------------------------------------------------------------------------


@cache
def _evaluators(model: Model) -> Evaluators:
    return Evaluators(model)


def evaluator(name: str, model: Model = REGIONAL_3R) -> Callable[..., Any]:
    """A generated function of the normal form, or of the orthogonal family."""
    found = _evaluators(model).get("cuspidality", name)
    if found is None:
        raise InputError(f"there is no generated function '{name}' of {model.name}")
    return found


@cache
def exact_function(name: str, model: Model = REGIONAL_3R) -> Callable[..., Any]:
    """The generated NumPy code of a function whose operations are exact on fractions and sound on balls."""
    code: Callable[..., Any] = run_path(str(compiling.find(model, "cuspidality").numpy_module))[name]
    return code


def _turns(*angles: Any) -> list[Array]:
    """(cos, sin) (..., 2) of each angle; all broadcast."""
    every = np.broadcast_arrays(*(np.asarray(angle, float) for angle in angles))
    return [np.stack([np.cos(angle), np.sin(angle)], axis=-1) for angle in every]


def _objects(values: Any) -> Array:
    """Nested sequences of numbers as an object array; NumPy is not asked what kind of numbers they are."""
    if isinstance(values, np.ndarray):
        return values.astype(object)
    rows = list(values)
    if rows and isinstance(rows[0], (list, tuple, np.ndarray)):
        return np.stack([_objects(row) for row in rows])
    found = np.empty(len(rows), object)
    found[:] = rows
    return found


def _fraction(value: float) -> Any:
    from flint import fmpq

    return fmpq(*value.as_integer_ratio())


def _rational_turn(cosine: float, sine: float) -> tuple[Any, Any]:
    """Cosine and sine on the unit circle in fractions, from doubles that are on it to rounding."""
    if 0.0 in (cosine, sine):
        return _fraction(cosine), _fraction(sine)
    half = _fraction(sine / (1.0 + cosine) if cosine > 0.0 else (1.0 - cosine) / sine)
    square = half * half
    return (1 - square) / (1 + square), 2 * half / (1 + square)


# ---- the reduction -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Between:
    """Rz(before) Tz(height) Rx(alpha) Tx(distance) Rz(after) Tz(along), alpha by its cosine and sine."""

    before: float
    height: float
    cosine: float
    sine: float
    distance: float
    after: float
    along: float


def _placements(description: Description) -> tuple[tuple[Transform, ...], Transform]:
    """The fixed transforms before the joints, and the tool."""
    geometry = description.geometry
    if isinstance(geometry, Serial):
        return geometry.placements, geometry.tool
    if isinstance(geometry, Orthogonal3R):
        quarter = math.pi / 2
        second = Transform.rot_x(-quarter) @ Transform.shift(geometry.d2, 0.0, geometry.r2)
        third = Transform.rot_x(quarter) @ Transform.shift(geometry.d3, 0.0, 0.0)
        return (Transform(), second, third), Transform.shift(geometry.d4, 0.0, 0.0)
    raise InputError(f"{description.name}: a planar arm; a spatial arm of three revolute joints is accepted")


def _between(transform: Transform) -> _Between:
    """A fixed transform by the common normal of the axis before it and the one after it."""
    rotation, (x, y, z) = np.array(transform.rotation), transform.translation
    across = math.hypot(rotation[0, 2], rotation[1, 2])
    if across < PARALLEL:
        distance, cosine, sine = math.hypot(x, y), math.copysign(1.0, rotation[2, 2]), 0.0
        normal = (x / distance, y / distance) if distance else (1.0, 0.0)
        along, height = 0.0, z
    else:
        normal = (-rotation[1, 2] / across, rotation[0, 2] / across)
        distance, sine, cosine = x * normal[0] + y * normal[1], across, float(rotation[2, 2])
        if distance < 0.0 or (distance == 0.0 and normal[0] < 0.0):
            normal, distance, sine = (-normal[0], -normal[1]), -distance, -across
        if abs(cosine) < CROSSED:
            cosine, sine = 0.0, math.copysign(1.0, sine)
        along = (x * normal[1] - y * normal[0]) / sine
        height = z - cosine * along
    first = rotation[0] * normal[0] + rotation[1] * normal[1]  # Rz(after)'s first row
    return _Between(
        math.atan2(normal[1], normal[0]),
        height,
        cosine,
        sine,
        distance + 0.0,
        math.atan2(-first[1], first[0]),
        along + 0.0,
    )


def _normal_form(name: str, placements: tuple[Transform, ...], tip: tuple[float, ...]) -> Regional:
    second, third = _between(placements[1]), _between(placements[2])
    d4, tip_angle = math.hypot(tip[0], tip[1]), math.atan2(tip[1], tip[0])
    offsets = [second.before, second.after + third.before, third.after + tip_angle]
    twists = [second.cosine, second.sine, third.cosine, third.sine]
    r2, r3 = second.along + third.height, third.along + tip[2]
    frame = placements[0] @ Transform.shift(0.0, 0.0, second.height)
    signs = [1, 1, 1]
    if twists[0] == 0.0 and twists[2] == 0.0 and r3 == 0.0:
        if twists[3] < 0.0:  # axis 2 the other way round
            twists[1], twists[3], r2 = -twists[1], 1.0, -r2
            signs[1], offsets[1] = -1, -offsets[1]
        if twists[1] > 0.0:  # axis 1 the other way round
            twists[1] = -1.0
            signs[0], offsets[0] = -1, -offsets[0]
            frame = frame @ Transform.rot_x(math.pi)
    parameters = (*twists, second.distance, third.distance, d4, r2, r3)
    return Regional(
        tuple(float(x) + 0.0 for x in parameters),
        (signs[0], signs[1], signs[2]),
        (offsets[0], offsets[1], offsets[2]),
        frame,
        name,
    )
