"""Second- and third-order speed ratios: joint motions whose path has a given tangent, curvature and curvature's rate.

Ambike, Schmiedeler and Stanisic coordinate three joints to the first order and meet the curvature where they can. With
second-order coordination a planar arm meets it at every configuration that is not singular. By arc length s of the
wanted path (unit tangent T, left normal N, signed curvature k)
    r' = T,    r'' = k N,    r''' = k' N - k^2 T,
and each order is linear in the joint derivatives of its own order:
    J q' = T,    J q'' = r'' - r''(q', 0),    J q''' = r''' - r'''(q', q'', 0),
where r''(q', 0) is the tip's second derivative at constant rates, and so on: the generated ``tip_motion``. Arc length
needs no leading joint, so nothing degenerates where some joint stands still.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import unit

Array = NDArray[Any]

#: Singular: the smaller singular value of J is less than this times the larger.
SINGULAR = 1e-10
#: A joint stands still if its rate is less than this times the largest.
STILL = 1e-9
#: Given rates are refused if they leave the tangent by more than this (rad).
ASTRAY = 1e-2

#: Curvatures and their rates are accepted up to this: their powers are summed with numbers of the size of 1.
LARGEST = 1e25


@dataclass(frozen=True)
class PathPoint:
    """Where a path is to be met, and how it runs there. Leading axes are those of the batch.

    Attributes:
        q: (..., n) configuration, rad or m.
        tangent: (..., 2) unit tangent.
        geometry: each (...): the signed curvature k (1/m, left turns positive), dk/ds (1/m^2), ...
    """

    q: Array
    tangent: Array
    geometry: tuple[Array, ...]

    @property
    def normal(self) -> Array:
        """(..., 2): the tangent turned left."""
        return np.stack([-self.tangent[..., 1], self.tangent[..., 0]], axis=-1)


def path_point(arm: Arm, q: Any, tangent: Any, **geometry: Any) -> PathPoint:
    """The checked and broadcast inputs of a question about a planar arm on a path; the tangent is normalised.

    Args:
        arm: a planar arm.
        q: (..., n) configurations.
        tangent: (..., 2) of any length but zero.
        geometry: (...) curvature and its derivatives, by name.

    Raises:
        InputError: another kind of arm, a wrong shape, a number that is not finite, a tangent without direction.

    Example:
        >>> from chainrule import planar_3r
        >>> path_point(planar_3r(1.0, 0.5, 0.25), [0.1, 0.2, 0.3], [3.0, 4.0], curvature=1.0).tangent
        array([0.6, 0.8])
    """
    if not isinstance(arm, Arm):
        raise InputError(f"arm: {shown(arm)}; an arm such as load('planar_3r') is accepted")
    if "x_alpha" not in arm.tasks:
        raise InputError(f"{arm.name}: speed ratios are known for planar arms; {arm.n} joints ({arm.kinds}) in space")
    given = {"q": _real(q, "q", arm.n), "tangent": _real(tangent, "tangent", 2)}
    scalars = {name: real_array(value, name) for name, value in geometry.items()}
    for name, array in scalars.items():
        if np.abs(array).max(initial=0.0) > LARGEST:
            raise InputError(
                f"{name}: {np.abs(array).max():.3g} is too large; magnitudes up to {LARGEST:g} are accepted"
            )
    directions = unit(given["tangent"], "tangent")
    try:
        leading = np.broadcast_shapes(
            *(array.shape[:-1] for array in given.values()), *(array.shape for array in scalars.values())
        )
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in (given | scalars).items())
        raise InputError(f"the leading axes do not broadcast together: {shapes}") from None
    return PathPoint(
        np.broadcast_to(given["q"], (*leading, arm.n)),
        np.broadcast_to(directions, (*leading, 2)),
        tuple(np.broadcast_to(array, leading) for array in scalars.values()),
    )


def _real(value: Any, name: str, entries: int) -> Array:
    """Finite numbers, the last axis of the given length."""
    array = real_array(value, name)
    if array.shape[-1:] != (entries,):
        raise InputError(f"{name} has shape {array.shape}; (..., {entries}) is accepted")
    return array


def leading_joint(value: Any, n: int) -> int:
    """The number of a joint, counted from 1.

    Raises:
        InputError: there is no such joint.

    Example:
        >>> leading_joint(2, 3)
        2
    """
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not 1 <= value <= n:
        raise InputError(f"leading: there is no joint {shown(value)}; 1 to {n} are accepted")
    return int(value)


@dataclass(frozen=True)
class MotionRatios:
    """Derivatives of the joint motion by arc length s of the path; leading axes are those of the batch.

    Attributes:
        point: the configuration and the path wanted there.
        order: 2 or 3: the highest derivative of the joint motion that was used.
        rates: (..., n) dq/ds in rad/m (m/m for prismatic joints).
        second: (..., n) d^2q/ds^2 in rad/m^2 (1/m).
        third: (..., n) d^3q/ds^3 in rad/m^3 (1/m^2); zero where the order is 2.
        path: (..., 4) what the tip does along q(s) at s = 0: speed, signed curvature, dk/ds, d^2k/ds^2.
    """

    point: PathPoint
    order: int
    rates: Array
    second: Array
    third: Array
    path: Array

    def at(self, s: Any) -> Array:
        """The joint values q + q' s + q'' s^2/2 + q''' s^3/6 at arc lengths s (k,): (..., k, n)."""
        s = real_array(s, "s")
        if s.ndim != 1:
            raise InputError(f"s: shape {s.shape}; (k,) is accepted")
        s = s[:, None]
        q, one, two, three = (a[..., None, :] for a in (self.point.q, self.rates, self.second, self.third))
        found: Array = q + s * (one + s * (two / 2.0 + s * three / 6.0))
        return found

    def ratios(self, leading: int = 1) -> tuple[Array, ...]:
        """Ambike's speed ratios n^(1), n^(2) (and n^(3)): derivatives of the joints by a leading joint (from 1).

        With a, b, c the leading joint's q', q'', q''':
            n1 = q'/a,    n2 = (q'' - b n1)/a^2,    n3 = (q''' - 3 a b n2 - c n1)/a^3.

        Raises:
            InputError: there is no such joint, or it stands still somewhere; the fastest one is named.
        """
        leading = leading_joint(leading, self.rates.shape[-1])
        speed = np.abs(self.rates)
        still = speed[..., leading - 1] <= STILL * speed.max(axis=-1)
        if still.any():
            where = tuple(int(k) for k in np.argwhere(still)[0])
            other = int(speed[where].argmax()) + 1
            at = f" at configuration {where if len(where) > 1 else where[0]}" if where else ""
            raise InputError(f"leading: joint {leading} stands still{at}; joint {other} moves")
        a, b, c = (d[..., leading - 1, None] for d in (self.rates, self.second, self.third))
        n1 = self.rates / a
        n2 = (self.second - b * n1) / a**2
        n3 = (self.third - 3.0 * a * b * n2 - c * n1) / a**3
        return (n1, n2, n3)[: self.order]

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        found = {"order": self.order, "q": self.point.q.tolist(), "tangent": self.point.tangent.tolist()}
        found |= {"rates": self.rates.tolist(), "second": self.second.tolist()}
        found |= {"third": self.third.tolist()} if self.order == 3 else {}
        names = ("speed", "curvature", "curvature_rate", "curvature_second")
        return found | {name: self.path[..., k].tolist() for k, name in enumerate(names)}


def motion_ratios(
    arm: Arm,
    q: Any,
    tangent: Any,
    curvature: Any,
    curvature_rate: Any = 0.0,
    *,
    order: int = 3,
    rates: Any = None,
    second: str = "least",
) -> MotionRatios:
    """The joint motion by arc length that leaves q along a path with this tangent, curvature and curvature's rate.

    Two joints leave no choice. With more, q' is J^+ T or as given; q'' and q''' supply what r'' and r''' lack along
    the path by a multiple of q' (which changes the speed, not the ratios) and across it by J^+. So the second-order
    ratios vanish where first-order ones meet the curvature. The tip keeps to the path to the order s^(order + 1)
    wherever J has full rank: also where no constant ratios meet the curvature (Ambike's discriminant is negative).

    Args:
        arm: a planar arm of two joints or more.
        q: (..., n) rad or m.
        tangent: (..., 2) direction of the path.
        curvature: (...) signed curvature k in 1/m; left turns are positive.
        curvature_rate: (...) dk/ds in 1/m^2.
        order: 2 or 3, the highest derivative of the joints that is used.
        rates: (..., n) first-order ratios of the caller's choice, at any scale (brought to unit tip speed, and onto
            the tangent by the least change); J^+ T when absent.
        second: "least"; or "rate" (an arm with a joint to spare): q'' meets dk/ds as well, without q'''. This is one
            linear equation in q'', solved with the least change.

    Raises:
        InputError: a singular configuration (its index is named), rates that lead off the tangent, ``second="rate"``
            where no q'' changes dk/ds, wrong shapes.

    Example:
        Ambike's second example, where no first-order ratios reach the curvature -1:

        >>> import numpy as np
        >>> from chainrule import load
        >>> arm, q = load("ambike_3r"), np.deg2rad([-14.0, -40.0, -205.0])
        >>> motion_ratios(arm, q, [0.9439, 0.3304], -1.0, order=2).path[:2].round(9)
        array([ 1., -1.])
        >>> motion_ratios(arm, q, [0.9439, 0.3304], -1.0, 0.25).path[:3].round(9)
        array([ 1.  , -1.  ,  0.25])
    """
    if not isinstance(order, int | np.integer) or order not in (2, 3):
        raise InputError(f"order: {shown(order)} is not known; 2 and 3 are accepted")
    if not isinstance(second, str) or second not in ("least", "rate"):
        raise InputError(f"second: {shown(second)} is not known; 'least' and 'rate' are accepted")
    point = path_point(arm, q, tangent, curvature=curvature, curvature_rate=curvature_rate)
    k, change = (g[..., None] for g in point.geometry)
    inverse, null = _inverse(arm, point.q)
    least = _times(inverse, point.tangent)
    first = least if rates is None else _along(arm, point, inverse, rates)

    still = np.zeros_like(first)
    bend = k * point.normal
    two = _supply(point, inverse, first, bend - _tip(arm, point.q, first, still, still)[0][..., 2, :])
    if second == "rate":
        two = two + _steer(arm, point, null, first, two)
    three = still
    if order == 3:
        wanted = change * point.normal - k**2 * point.tangent
        three = _supply(point, inverse, first, wanted - _tip(arm, point.q, first, two, still)[0][..., 3, :])
    return MotionRatios(point, order, first, two, three, _tip(arm, point.q, first, two, three)[1])


def _tip(arm: Arm, q: Array, *motion: Array) -> tuple[Array, Array]:
    """The generated tip motion: derivatives (..., 5, 2) and path (..., 4)."""
    found: tuple[Array, Array] = arm.evaluator("tip_motion")(q, arm.parameters, *motion)
    return found


def _times(matrix: Array, vector: Array) -> Array:
    found: Array = np.einsum("...ij,...j->...i", matrix, vector)
    return found


def _supply(point: PathPoint, inverse: Array, first: Array, vector: Array) -> Array:
    """Joint derivatives x with J x = vector: along the path by q' (only the speed changes), across it by J^+."""
    along, across = (np.sum(vector * frame, axis=-1, keepdims=True) for frame in (point.tangent, point.normal))
    found: Array = along * first + across * _times(inverse, point.normal)
    return found


def _inverse(arm: Arm, q: Array) -> tuple[Array, Array]:
    """J^+ (..., n, 2) and an orthonormal basis (..., n - 2, n) of the null space; refuses singular configurations."""
    if arm.n < 2:
        raise InputError(f"{arm.name}: one joint moves the tip along one curve only; two joints or more are accepted")
    u, s, vt = np.linalg.svd(arm.jacobian(q, task="position"))
    singular = s[..., 1] <= SINGULAR * s[..., 0]
    if singular.any():
        where = tuple(int(k) for k in np.argwhere(singular)[0])
        at = f", configuration {where if len(where) > 1 else where[0]}" if where else ""
        raise InputError(
            f"{arm.name}{at}: singular, the tip can move along one line only; a configuration whose "
            "Jacobian has rank 2 is accepted"
        )
    inverse = np.einsum("...ki,...k,...jk->...ij", vt[..., :2, :], 1.0 / s, u)
    return inverse, vt[..., 2:, :]


def _along(arm: Arm, point: PathPoint, inverse: Array, rates: Any) -> Array:
    """The caller's rates at unit tip speed along the tangent."""
    given = _real(rates, "rates", arm.n)
    try:
        given = np.broadcast_to(given, point.q.shape)
    except ValueError:
        raise InputError(f"rates has shape {given.shape}; {point.q.shape} is accepted") from None
    tip = _times(arm.jacobian(point.q, task="position"), given)
    along, across = (np.sum(tip * frame, axis=-1, keepdims=True) for frame in (point.tangent, point.normal))
    if not (np.abs(across) < ASTRAY * np.abs(along)).all():
        raise InputError("rates: they do not move the tip along the tangent; x with J x parallel to it is accepted")
    scaled = given / along
    found: Array = scaled + _times(inverse, point.tangent - tip / along)
    return found


def _steer(arm: Arm, point: PathPoint, null: Array, first: Array, second: Array) -> Array:
    """The least null-space change of q'' that makes dk/ds right without q'''.

    On r' = T, r'' = k N: dk/ds = T x r''', and r''' is affine in q''.
    """
    if arm.n < 3:
        raise InputError(f"{arm.name}: second='rate' needs a joint to spare, and this arm has two; 'least' is accepted")
    still = np.zeros_like(first)

    def third(two: Array) -> Array:
        found: Array = np.sum(_tip(arm, point.q, first, two, still)[0][..., 3, :] * point.normal, axis=-1)
        return found

    here = third(second)
    slope = np.stack([third(second + null[..., k, :]) - here for k in range(arm.n - 2)], axis=-1)
    square = np.sum(slope**2, axis=-1)
    size = np.abs(here) + np.sum(first**2, axis=-1) ** 1.5 + 1.0
    if not (square > (1e-12 * size) ** 2).all():
        raise InputError(f"{arm.name}: no q'' changes dk/ds here; order=3 with second='least' is accepted")
    short = (point.geometry[1] - here) / square
    found: Array = np.sum((short[..., None] * slope)[..., None] * null, axis=-2)
    return found
