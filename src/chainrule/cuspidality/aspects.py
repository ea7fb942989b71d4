"""Aspects of a 3R arm: the connected components of its joint space without the singularities.

With the terms a, b, c of ``chainrule.derive.regional_3r``, which depend on theta3 alone,
    det J = a cos(theta2) + b sin(theta2) + c,
and theta1 plays no part. So for one theta3 the angles theta2 where det J has the sign s are one arc about
atan2(s b, s a), the whole circle, or none at all:
    they exist exactly where s c + sqrt(a^2 + b^2) > 0.
An arc that depends continuously on theta3 makes one connected band of every interval of such theta3. Hence the aspects
of sign s are the intervals of {s c + sqrt(a^2 + b^2) > 0} on the circle of theta3. Their ends are roots of
a^2 + b^2 - c^2, of degree 8 in tan(theta3 / 2), and a root is an end for the sign s exactly if s c <= 0 there: where c
is not zero, one sign passes. That covers roots where the polynomial only touches zero, and the lines of the orthogonal
arms (theta3 = +-arccos(-d3 / d4), where a = b = c = 0), which are ends for both signs.

The word is that of P. Borrel and A. Liegeois, "A study of multiple manipulator inverse kinematic solutions with
applications to trajectory planning and workspace determination", ICRA 1986. The roots are isolated with a proof and the
signs at them decided for the lengths and twists as given, floats at their binary value: no tolerance is involved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.exact import real_roots, sign_at
from chainrule.cuspidality.normal_form import Regional
from chainrule.errors import InputError, shown

Array = NDArray[Any]
TURN = 2.0 * math.pi
#: |det J| up to this many times |d4| (largest reach)^2 counts as zero: what rounding may make of it.
ROUNDING = 1e-14


@dataclass(frozen=True)
class Aspect:
    """One aspect: an interval of theta3 in which det J can have one sign.

    Attributes:
        label: its place in the list of aspects, from 0; what :func:`aspect_of` answers.
        sign: 1 or -1, the sign of det J.
        theta3: (lower, upper) of the arm's own joint 3 in rad, lower in (-pi, pi], upper at most one turn above it.
        whole: whether theta3 takes every value (the ends of the interval are then no singularities).
    """

    label: int
    sign: int
    theta3: tuple[float, float]
    whole: bool

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"label": self.label, "sign": self.sign, "theta3": list(self.theta3), "whole": self.whole}


def aspects(regional: Regional) -> tuple[Aspect, ...]:
    """All aspects, those of positive det J first, each sign by rising theta3; none where det J vanishes everywhere.

    Joint limits play no part.
    """
    offset = -regional.offsets[2]  # joint 3 is never reversed
    found: list[Aspect] = []
    for sign in (1, -1):
        for lower, upper, whole in sorted(_intervals(regional)[sign]):
            start = math.pi - (math.pi - lower - offset) % TURN
            found.append(Aspect(len(found), sign, (start, start + (upper - lower)), whole))
    return tuple(found)


def aspect_of(regional: Regional, q: Any) -> Array:
    """The aspect of every configuration ``q`` (..., 3): its label, or -1 where it is singular to within rounding."""
    given = configurations(q, "q")
    theta = regional.to_normal(given)
    det = regional.determinant(theta[..., 1], theta[..., 2])
    labels = np.full(det.shape, -1)
    offset = -regional.offsets[2]  # joint 3 is never reversed
    for aspect in aspects(regional):
        lower, upper = (end - offset for end in aspect.theta3)
        inside = np.full(det.shape, True) if aspect.whole else _within(theta[..., 2], lower, upper)
        labels[(np.sign(det) == aspect.sign) & inside] = aspect.label
    labels[(np.abs(det) <= zero(regional)) | ~np.isfinite(given).all(axis=-1)] = -1
    return labels


def configurations(q: Any, name: str) -> Array:
    """``q`` as an array (..., 3); entries that are not finite are let through.

    Raises:
        InputError: not numbers, or another shape.
    """
    try:
        found = np.asarray(q)
    except ValueError:
        found = np.empty(0, object)
    if found.dtype.kind not in "iuf" or found.shape[-1:] != (3,):
        raise InputError(f"{name}: {shown(q)}; joint angles of shape (..., 3) are accepted")
    return found.astype(float)


def same_aspect(regional: Regional, a: Any, b: Any) -> Array:
    """Whether configurations ``a`` and ``b`` (..., 3) can be joined without a singularity; leading axes broadcast."""
    first, second = (aspect_of(regional, configurations(q, name)) for q, name in ((a, "a"), (b, "b")))
    found: Array = (first == second) & (first >= 0)
    return found


def zero(regional: Regional) -> float:
    """What counts as zero for det J, in m^3."""
    return ROUNDING * abs(regional.parameters[6]) * regional.size**2


def _within(theta3: Array, lower: float, upper: float) -> Array:
    """Whether angles lie in the open interval, up to whole turns."""
    above = np.remainder(theta3 - lower, TURN)
    found: Array = (above > 0.0) & (above < upper - lower)
    return found


@lru_cache(maxsize=256)
def _intervals(regional: Regional) -> dict[int, list[tuple[float, float, bool]]]:
    """For each sign the intervals of theta3 (lower, upper, whole) in the normal form."""
    cuts = critical_angles(regional)
    return {sign: components(cuts, sign) for sign in (1, -1)}


@dataclass(frozen=True)
class Critical:
    """Where aspects may end.

    Attributes:
        theta3: (k,) rising in (-pi, pi], where a^2 + b^2 = c^2.
        sign_of_c: (k,) -1, 0 or 1: the sign of c there.
        both: (k,) whether both signs occur just after it (for k = 0: anywhere); else only ``between``.
        between: (k,) the sign of c just after it.
    """

    theta3: tuple[float, ...]
    sign_of_c: tuple[int, ...]
    both: tuple[bool, ...]
    between: tuple[int, ...]


def components(cuts: Critical, sign: int) -> list[tuple[float, float, bool]]:
    """The intervals of one sign: stretches between critical angles, joined over those that are no ends."""
    open_after = [both or between == sign for both, between in zip(cuts.both, cuts.between, strict=True)]
    count = len(cuts.theta3)
    if count == 0:
        return [(-math.pi, math.pi, True)] if open_after[0] else []
    ends = [sign * c <= 0 for c in cuts.sign_of_c]
    starts = [i for i in range(count) if open_after[i] and (ends[i] or not open_after[i - 1])]
    if not starts:
        return [(-math.pi, math.pi, True)] if all(open_after) else []
    found = []
    for i in starts:
        j = i + 1
        while j < i + count and not ends[j % count] and open_after[j % count]:
            j += 1
        lower, upper = cuts.theta3[i], cuts.theta3[j % count]
        found.append((lower, upper + TURN if j >= count else upper, False))
    return found


def critical_angles(regional: Regional) -> Critical:
    """The roots of a^2 + b^2 - c^2 on the circle of theta3, and the signs that decide which aspects end there."""
    from flint import fmpq, fmpq_poly

    polynomial, c = fmpq_poly(list(regional.exact_aspect_polynomial())), _c_polynomial(regional)
    both_vanish = polynomial.is_zero()  # |c| is the amplitude everywhere: c alone decides
    if regional.parameters[6] == 0.0 or (both_vanish and c.is_zero()):
        return Critical((), (), (False,), (0,))
    deciding, degree = (c, 4) if both_vanish else (polynomial, 8)
    roots = real_roots(deciding)
    angles, signs, samples = [2.0 * math.atan(root.value) for root in roots], [sign_at(c, root) for root in roots], []
    for before, after in pairwise(roots):
        samples.append((before.upper + after.lower) / 2)
    beyond = roots[-1].upper + 1 if roots else fmpq(0)
    samples.append(beyond)
    if deciding.degree() < degree:  # theta3 = pi
        leading = c[4]
        angles.append(math.pi)
        signs.append((leading > 0) - (leading < 0))
        if roots:
            samples.append(roots[0].lower - 1)
    values, amounts = [polynomial(t) for t in samples], [c(t) for t in samples]
    return Critical(
        tuple(angles),
        tuple(signs),
        tuple(value > 0 for value in values),
        tuple(int(amount > 0) - int(amount < 0) for amount in amounts),
    )


def _c_polynomial(regional: Regional) -> Any:
    """c (1 + t^2)^2 as a polynomial of degree 4 in t = tan(theta3 / 2), from its values at five points."""
    from flint import fmpq, fmpq_mat, fmpq_poly

    points = [fmpq(k) for k in range(-2, 3)]
    elbows = [[(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)] for t in points]
    terms = regional.exact_determinant_terms(elbows)
    values = [[terms[k][2] * (1 + t * t) ** 2] for k, t in enumerate(points)]
    powers = fmpq_mat(5, 5, [t**n for t in points for n in range(5)])
    solved = powers.solve(fmpq_mat(5, 1, [value for (value,) in values]))
    return fmpq_poly([solved[n, 0] for n in range(5)])
