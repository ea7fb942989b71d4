"""All cusps of a 3R arm with a proof: the points of the half plane (rho, z), rho >= 0, that three postures share.

A cusp is a triple root of the quartic. Its theta3 is a real root of the cusp polynomial (degree 12 in tan(theta3 / 2),
or 6 where alpha2 = +-90 deg), and there theta2 must be real: the aspect polynomial must not be negative. The roots are
isolated and the signs decided exactly. :mod:`chainrule.cuspidality.invariants` counts cusps in a way that shares
nothing with this but the quartic.

A root of higher multiplicity is no cusp but an event between two kinds of designs: four equal roots, or two cusps meet.

Sources: M. Baili, P. Wenger, D. Chablat, "Kinematic analysis of a family of 3R manipulators", Problems of Mechanics 15,
2004; J. El Omri, P. Wenger, "How to recognize simply a non-singular posture changing 3-DOF manipulator", ICAR 1995.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.balls import above, nearest
from chainrule.cuspidality.exact import Root, precision, real_roots, sign_at
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, Regional, exact_function
from chainrule.cuspidality.parameters import exact_parameters, orthogonal_lengths, why_nongeneric
from chainrule.description import REGIONAL_3R

Array = NDArray[Any]

#: Bits of the balls that places are computed with: at first, and at most.
_BITS, _MOST = 128, 4096
#: The radius that is aimed at, as a part of the longest length.
_AIM = 1e-14


@dataclass(frozen=True)
class Cusp:
    """One cusp, or what takes its place in a design between two kinds.

    Attributes:
        rho: the distance from the first joint's axis, m.
        z: the height along it, m.
        theta3: the angle of joint 3 of the normal form where the postures meet, rad.
        radius: a proved bound on the error of rho and of z, m.
        event: nothing for a cusp; else "four equal roots", "two cusps meet" or "theta2 free".
    """

    rho: float
    z: float
    theta3: float
    radius: float
    event: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)


@dataclass(frozen=True)
class Cusps:
    """All cusps of one arm.

    Attributes:
        cusps: by rising z, then rho; both signs of z.
        events: triple roots that are no cusps, because the design is between two kinds; empty elsewhere.
        nongeneric: why the arm is not generic, in words; such an arm is given no cusps.
    """

    cusps: tuple[Cusp, ...]
    events: tuple[Cusp, ...]
    nongeneric: tuple[str, ...]

    @property
    def number(self) -> int:
        """How many cusps there are."""
        return len(self.cusps)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "cusps": [cusp.to_dict() for cusp in self.cusps],
            "events": [event.to_dict() for event in self.events],
            "nongeneric": list(self.nongeneric),
        }


@dataclass(frozen=True)
class _Functions:
    """What decides the cusps of one arm."""

    given: Array
    cusp: Any
    degree: int
    aspect: Any
    aspect_degree: int
    triple_point: Any

    @property
    def mirrored(self) -> bool:
        """Whether a root is a pair of targets z, -z."""
        return self.degree == 6


@cache
def _generated(orthogonal: bool, right: bool) -> tuple[Any, int, Any, int, Any]:
    model = ORTHOGONAL_3R if orthogonal else REGIONAL_3R
    suffix = "_right_angle" if right and not orthogonal else ""
    cusp, aspect, place = (
        exact_function(name, model)
        for name in ("cusp_polynomial" + suffix, "aspect_polynomial", "triple_point" + suffix)
    )
    return cusp, 6 if right else 12, aspect, 4 if orthogonal else 8, place


def _functions(parameters: Array) -> _Functions:
    from flint import fmpq_poly

    lengths = orthogonal_lengths(parameters)
    cusp, degree, aspect, aspect_degree, place = _generated(lengths is not None, parameters[0] == 0)
    given = parameters if lengths is None else lengths
    return _Functions(given, fmpq_poly(list(cusp(given))), degree, fmpq_poly(list(aspect(given))), aspect_degree, place)


def certified_cusps(arm: Any) -> Cusps:
    """All cusps of a 3R arm, counted and enclosed with a proof.

    Args:
        arm: what :func:`chainrule.cuspidality.parameters.exact_parameters` takes; lengths in m.

    Returns:
        In the normal form's frame.

    Example:
        >>> found = certified_cusps([1, 2, "1.5", 1])
        >>> found.number, found.events
        (4, ())
    """
    parameters = exact_parameters(arm)
    reasons = why_nongeneric(parameters)
    if reasons:
        return Cusps((), (), reasons)
    functions = _functions(parameters)
    found: list[Cusp] = []
    for root in real_roots(functions.cusp, functions.degree):
        real = sign_at(functions.aspect, root, functions.aspect_degree)
        if real < 0:
            continue
        event = ""
        if real == 0 and _theta2_free(parameters, root):
            event = "theta2 free"
        elif root.multiplicity > 1:
            event = "four equal roots" if _fourfold(parameters, functions, root) else "two cusps meet"
        elif real == 0 and functions.mirrored:
            event = "two cusps meet"
        theta3 = 2.0 * math.atan(root.value)
        places = _places(functions, root, real == 0 and functions.mirrored)
        found += [Cusp(rho, z, theta3, radius, event) for rho, z, radius in places]
    found.sort(key=lambda cusp: (cusp.z, cusp.rho))
    return Cusps(tuple(c for c in found if not c.event), tuple(c for c in found if c.event), ())


def cusps(regional: Regional) -> Array:
    """The cusps of an arm: (k, 2) of rho and z in m, in the normal form's frame, by rising z.

    See :func:`certified_cusps`, which this takes the points from.
    """
    return np.array([(cusp.rho, cusp.z) for cusp in certified_cusps(regional).cusps]).reshape(-1, 2)


# ---- places in balls ---------------------------------------------------------------------------------------------


def elbow_on_balls(root: Root) -> Array:
    """(cos theta3, sin theta3) of a root tan(theta3 / 2) in balls."""
    from flint import arb

    found = np.empty(2, object)
    if root.ball is None:
        found[:] = [arb(-1), arb(0)]
    else:
        below = 1 + root.ball * root.ball
        found[:] = [2 / below - 1, 2 * root.ball / below]
    return found


def on_balls(values: Any) -> Array:
    """Rational numbers or balls, and constants of generated code, as an object array of balls."""
    from flint import arb

    found = np.empty(len(values), object)
    found[:] = [arb(value) for value in values]
    return found


def _target(functions: _Functions, root: Root, on_axis: bool = False) -> tuple[Any, Any]:
    """(rho^2, z) of a triple root in balls, z >= 0 where there are two."""
    first, last, below = functions.triple_point(on_balls(functions.given), elbow_on_balls(root))
    if on_axis:
        return first / below, 0 * below
    return first / below, (last / below).nonnegative_part().sqrt() if functions.mirrored else last / below


def float_place(square: Any, z: Any) -> tuple[float, float, float]:
    """(rho, z, a bound on the error of both) of balls for rho^2 and z."""
    rho = square.nonnegative_part().sqrt()
    middle = (nearest(rho), nearest(z))
    return (*middle, max(above(abs(ball - value)) for ball, value in zip((rho, z), middle, strict=True)))


def _places(functions: _Functions, root: Root, on_axis: bool) -> list[tuple[float, float, float]]:
    """(rho, z) of a triple root with a bound on the error, for both signs of z where there are two."""
    aim = _AIM * max(abs(int(x.p) / int(x.q)) for x in functions.given[-5:])
    bits = _BITS
    while True:
        with precision(bits):
            rho, z, radius = float_place(*_target(functions, root.refined(bits), on_axis))
        if radius <= aim or bits >= _MOST:
            break
        bits *= 2
    return [(rho, z, radius), (rho, -z, radius)] if functions.mirrored and not on_axis else [(rho, z, radius)]


def _theta2_free(parameters: Array, root: Root) -> bool:
    """Whether a = b = 0 at a root of the aspect polynomial: the point is on axis 2. Balls without zero disprove it."""
    terms_of = exact_function("determinant_terms")
    for bits in (_BITS, 8 * _BITS):
        with precision(bits):
            terms = on_balls(terms_of(on_balls(parameters), elbow_on_balls(root.refined(bits))))
            if not all(term.contains(0) for term in terms[:2]):
                return False
    return True


def _fourfold(parameters: Array, functions: _Functions, root: Root) -> bool:
    """Whether the third derivative of the quartic vanishes too, at a multiple root of the cusp polynomial.

    A ball without zero disproves it.
    """
    from flint import arb_poly

    for bits in (_BITS, 8 * _BITS):
        near = root.refined(bits)
        with precision(bits):
            target = on_balls(_target(functions, near))
            quartic = arb_poly(list(on_balls(exact_function("quartic")(on_balls(parameters), target))))
            third = quartic[1] if near.ball is None else quartic.derivative().derivative().derivative()(near.ball)
            if not third.contains(0):
                return False
    return True
