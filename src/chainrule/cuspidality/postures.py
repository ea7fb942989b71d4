"""Every posture of a 3R arm that reaches a point, and how many there are.

The generated function ``postures`` answers in floating point, with a margin that tells where rounding might have
changed the number of solutions, and how far from the point each solution is. Where the margin is not clear, a
solution does not close, or two of them are not separate, the quartic is solved exactly: its coefficients at the
binary value of what was given are fractions, the sign of its discriminant says how many roots are real, and where
floating point did not find just as many that close, they are isolated with a proof; theta2 and theta1 then follow in
ball arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.counting import discriminant_signs
from chainrule.cuspidality.exact import real_roots
from chainrule.cuspidality.normal_form import Regional, evaluator, exact_function
from chainrule.errors import InputError
from chainrule.inputs import real_array

Array = NDArray[Any]

#: A posture closes, and a joint is free, where the point is missed or moved by no more than this share of the size.
CLOSED = 2e-13
#: Half the angle up to which two postures in closed form count as one: what rounding makes of a double root.
ALIKE = 3e-8
#: Points evaluated at a time: their results stay in the cache.
BLOCK = 2048
#: Bits of the ball arithmetic.
PRECISION = 192
TURN = 2.0 * math.pi


@dataclass(frozen=True)
class PostureSet:
    """Postures that reach points.

    Attributes:
        q: (..., 4, 3) joint values in (-pi, pi], rad, those of each point by rising third joint; nan where there are
            fewer than four.
        count: (...) how many distinct ones there are; a posture with a free joint counts once.
        free: (..., 3) whether a joint may turn freely in some posture at the point: joint 1 on the first axis, joint 2
            where the point of that posture lies on the second axis, joint 3 where the point is on the third axis or
            every theta3 has a posture. ``q`` then holds one of the values.
        decided: how many points were decided by exact arithmetic.
    """

    q: Array
    count: Array
    free: Array
    decided: int

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "q": self.q.tolist(),
            "count": self.count.tolist(),
            "free": self.free.tolist(),
            "decided": self.decided,
        }


@dataclass(frozen=True)
class Section:
    """The same in angles of the normal form: ``theta`` (..., 4, 3), ``count``, ``free``, ``decided``."""

    theta: Array
    count: Array
    free: Array
    decided: int


def postures(regional: Regional, points: Any) -> PostureSet:
    """Every posture of an arm that reaches each of ``points`` (..., 3), in m in the arm's base frame.

    0, 2 or 4 for a generic arm, and one less for every two that meet, at points on a singular curve. None is lost
    next to one: doubtful points are decided exactly, at the binary value of what was given. Every posture reaches its
    point to 1e-12 of the arm's size; of a pair that nearly meets, theta3 itself may be off by 1e-8 rad. Where axes 1
    and 2 intersect or are parallel the postures are found in closed form, and those that rounding cannot tell apart
    count once.

    Raises:
        InputError: not finite real numbers of shape (..., 3); an arm whose axes 1 and 2 coincide, or whose three axes
            are parallel.

    Example:
        >>> from chainrule import orthogonal_3r
        >>> arm = orthogonal_3r(1.0, 2.0, 1.5, 1.0)
        >>> found = postures(Regional.of(arm), [2.0, 0.25, 0.5])
        >>> int(found.count), arm.position(found.q[0]).round(12)
        (4, array([2.  , 0.25, 0.5 ]))
    """
    given = _points(points)
    found = section(regional, regional.point_to_normal(given))
    if regional.signs == (1, 1, 1) and not any(regional.offsets):
        return PostureSet(found.theta, found.count, found.free, found.decided)
    q = wrapped(regional.from_normal(found.theta))
    return PostureSet(_sorted(q), found.count, found.free, found.decided)


def number_of_postures(regional: Regional, rho: Any, z: Any) -> Array:
    """How many distinct postures reach the points at distance ``rho`` from axis 1 and height ``z``, in m.

    ``rho`` and ``z`` broadcast; z is measured in the normal form's frame (for an orthogonal arm: along axis 1 from the
    common normal with axis 2). As :func:`postures`; -1 where there is a continuum of them with theta3 free.

    Raises:
        InputError: not finite real numbers, or shapes that do not broadcast; an arm as in :func:`postures`.

    Example:
        >>> from chainrule import orthogonal_3r
        >>> number_of_postures(Regional.of(orthogonal_3r(1.0, 2.0, 1.5, 1.0)), [2.0, 2.0, 9.0], [0.5, 1.5, 0.0])
        array([4, 2, 0])
    """
    distances, heights = real_array(rho, "rho"), real_array(z, "z")
    try:
        distances, heights = np.broadcast_arrays(distances, heights)
    except ValueError:
        raise InputError(f"rho and z: the shapes {distances.shape} and {heights.shape} do not broadcast") from None
    _refuse(regional)
    values, factor = _scaled(regional)
    if values[4] == 0.0 or values[1] == 0.0:
        return section(regional, np.stack([distances, np.zeros_like(distances), heights], axis=-1)).count
    with np.errstate(over="ignore"):
        reachable = np.hypot(distances, heights) <= 2.0 * regional.size
    targets = np.stack([distances, heights], axis=-1)[reachable] * factor
    targets[:, 0] **= 2
    number, margin = evaluator("number_of_postures")(values, targets)
    found = number.astype(int)
    doubtful = np.flatnonzero(~(margin > 1.0))
    points = np.stack([distances, np.zeros_like(distances), heights], axis=-1)[reachable][doubtful] * factor
    quartics = _quartics(_exact_values(regional, values), points)
    for k, point, coefficients in zip(doubtful, points, quartics, strict=True):
        known = _number(coefficients)
        if known is None:
            every, loose = _elbows(coefficients, values, point)
            known = -1 if loose else len(every)
        found[k] = known
    whole = np.zeros(distances.shape, int)
    whole[reachable] = found
    return whole


# ---- in the normal form --------------------------------------------------------------------------------------------


def section(regional: Regional, points: Array, *, exactly: bool = True) -> Section:
    """Postures in angles of the normal form at ``points`` (..., 3) of its frame.

    Without ``exactly`` points that floating point does not decide are given none.
    """
    _refuse(regional)
    values, factor = _scaled(regional)
    flat, decided = points.reshape(-1, 3), 0
    theta, free = np.empty((len(flat), 4, 3)), np.empty((len(flat), 3), bool)
    closed_form = values[4] == 0.0 or values[1] == 0.0
    pivots = [] if closed_form else list(_on_second_axis(values))
    exact = _exact_values(regional, values)
    for start in range(0, len(flat), BLOCK):
        with np.errstate(over="ignore"):
            scaled = flat[start : start + BLOCK] * factor
            far = ~((scaled * scaled).sum(axis=-1) <= 16.0)  # the arm's size is less than 2
        scaled[far] = 0.0
        found, loose, doubtful = (
            _in_closed_form(values, scaled) if closed_form else _from_quartic(values, exact, scaled, pivots, exactly)
        )
        found[far], loose[far] = np.nan, False
        theta[start : start + BLOCK], free[start : start + BLOCK, 1:] = found, loose
        free[start : start + BLOCK, 0] = scaled[:, 0] ** 2 + scaled[:, 1] ** 2 <= CLOSED**2
        decided += doubtful
    count = np.isfinite(theta[..., 2]).sum(axis=-1)
    free[count == 0] = False
    lead = points.shape[:-1]
    return Section(theta.reshape(*lead, 4, 3), count.reshape(lead), free.reshape(*lead, 3), decided)


def _refuse(regional: Regional) -> None:
    _, sa2, _, sa3, d2, _, _, _, _ = regional.parameters
    if sa2 == 0.0 and d2 == 0.0:
        raise InputError(f"{regional.name}: axes 1 and 2 coincide; only the sum of their angles matters")
    if sa2 == 0.0 and sa3 == 0.0:
        raise InputError(f"{regional.name}: its three axes are parallel; it moves in one plane (use a planar arm)")


def _points(points: Any) -> Array:
    found = real_array(points, "points")
    if found.ndim < 1 or found.shape[-1] != 3:
        raise InputError(f"points: an array of shape {found.shape}; (..., 3) is accepted")
    return found


def _scaled(regional: Regional) -> tuple[Array, float]:
    """The parameters with lengths times a power of two that brings the arm's size into [1, 2), and that power."""
    factor = 2.0 ** (1 - math.frexp(regional.size)[1]) if regional.size > 0.0 else 1.0
    values = regional.values.copy()
    values[4:] *= factor
    return values, factor


def _exact_values(regional: Regional, values: Array) -> Array:
    """The same in fractions."""
    return np.concatenate([regional.rationals[:4], _fractions(values[4:])])


def wrapped(angles: Array) -> Array:
    """Angles in (-pi, pi]."""
    found = angles - TURN * np.ceil((angles - math.pi) / TURN)
    return np.where(found <= -math.pi, math.pi, np.minimum(found, math.pi))  # rounding may lead just out of it


def _sorted(angles: Array) -> Array:
    """Postures (..., k, 3) by rising last angle, nan last."""
    order = np.argsort(angles[..., 2], axis=-1)
    found: Array = np.take_along_axis(angles, order[..., None], axis=-2)
    return found


# ---- generic arms: the quartic -------------------------------------------------------------------------------------


def _from_quartic(
    values: Array, exact: Array, points: Array, pivots: list[tuple[float, Array]], exactly: bool
) -> tuple[Array, Array, int]:
    """Postures (k, 4, 3) by rising theta3, whether theta2 and theta3 are free (k, 2), how many were decided exactly."""
    angles, room, closure, slope, number, margin = evaluator("postures")(values, points)
    clear = margin > 1.0
    touching = np.zeros(len(points), bool)
    for _, target in pivots:
        touching |= np.hypot(np.hypot(points[:, 0], points[:, 1]) - target[0], points[:, 2] - target[1]) <= CLOSED
    doubtful, rest = np.flatnonzero(~clear & exactly), touching | (~clear & (not exactly))
    for k, coefficients in zip(doubtful, _quartics(exact, points[doubtful]), strict=True):
        known = _number(coefficients)
        rest[k] |= known is None
        number[k] = -1.0 if known is None else known
    valid = _valid(number, room)
    angles = np.where(valid[..., None], wrapped(angles), np.nan)
    order = np.argsort(angles[..., 2], axis=-1)  # nan last
    angles, slope, closed = (
        part[np.arange(len(points))[:, None], order] for part in (angles, slope, closure <= CLOSED)
    )
    known = np.arange(4) < number[:, None]
    rest |= ~((closed | ~known).all(axis=-1) & _separate(angles[..., 2], slope, known, clear))
    free = np.zeros((len(points), 2), bool)
    if not exactly:
        angles[rest] = np.nan
        return angles, free, 0
    for k in np.flatnonzero(rest):
        found, free[k, 1] = _exactly(values, exact, points[k])
        if touching[k]:
            found, free[k, 0] = _with_pivots(values, points[k], found, pivots), True
        angles[k] = np.nan
        angles[k, : len(found)] = _sorted(wrapped(np.reshape(found, (-1, 3))))
    return angles, free, int((rest | ~clear).sum())


def _valid(number: Array, room: Array) -> Array:
    """Which of the two pairs (k, 4) are postures: both of four, of two the pair with more room."""
    first = room[:, 0] >= room[:, 1]
    pair = np.stack([first, first, ~first, ~first], axis=-1)
    found: Array = (number == 4.0)[:, None] | (number == 2.0)[:, None] & pair
    return found


def _separate(theta3: Array, slope: Array, valid: Array, clear: Array) -> Array:
    """Whether postures are different roots: the slope changes its sign from each to the next.

    Two that rounding cannot tell apart, where the number of roots was doubtful and is now known, are a pair that nearly
    meets on a singular curve: either is as near to a root as doubles allow.
    """
    alternating = slope[:, 1:] * slope[:, :-1] < 0.0
    alike = (theta3[:, 1:] - theta3[:, :-1] <= 4.0 * ALIKE) & ~clear[:, None]
    found: Array = np.all(alternating | alike | ~valid[:, 1:], axis=-1)
    return found


def _quartics(exact: Array, points: Array) -> Array:
    """The exact coefficients (k, 5) of the quartics at points (k, 3)."""
    numbers = _fractions(points)
    targets = np.stack([numbers[:, 0] ** 2 + numbers[:, 1] ** 2, numbers[:, 2]], axis=-1)
    found: Array = exact_function("quartic")(exact, targets)
    return found


def _number(coefficients: Array) -> int | None:
    """The number of real roots, or None where some are equal or tan(theta3 / 2) is infinite at one."""
    from flint import fmpq_poly

    whole = fmpq_poly(list(coefficients)).numer()
    if whole.degree() < 4:
        return None
    discriminant, p, q = discriminant_signs(list(whole))
    if discriminant == 0:
        return None
    return 2 if discriminant < 0 else 4 if p < 0 and q < 0 else 0


def _exactly(values: Array, exact: Array, point: Array) -> tuple[list[Array], bool]:
    """All postures at one point from the exact quartic, and whether theta3 is free."""
    from flint import arb, ctx

    before, ctx.prec = ctx.prec, PRECISION
    try:
        x, y, z = (arb(number) for number in _fractions(point))
        target = _object([x * x + y * y, z])
        every, loose = _elbows(_quartics(exact, point[None])[0], values, point)
        found = []
        parameters = _object([arb(number) for number in exact])
        for c3, s3 in every:
            elbow = _object([c3, s3])
            ratio = exact_function("shoulder")(parameters, target, elbow)
            c2, s2 = _direction(ratio[0], ratio[1])
            at = exact_function("unturned")(parameters, _object([c2, s2]), elbow)
            turn = _angle(x * at[0] + y * at[1], y * at[0] - x * at[1])
            found.append(np.array([turn, _angle(c2, s2), _angle(c3, s3)]))
        return found, loose
    finally:
        ctx.prec = before


def _elbows(coefficients: Array, values: Array, point: Array) -> tuple[list[tuple[Any, Any]], bool]:
    """Cosine and sine of every distinct real root of the quartic, as balls; every theta3 is one where it vanishes."""
    from flint import arb

    doubt = 2.0**-44 * (1.0 + float(np.abs(point).max())) ** 4
    constant = values[6] == 0.0 or values[3] == 0.0 == values[5]  # theta3 moves nothing in the cross-section
    if all(c == 0 for c in coefficients) or (constant and max(abs(float(c)) for c in coefficients) < doubt):
        return [(arb(1), arb(0))], True
    found = [((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)) for t in _balls(list(coefficients))]
    if coefficients[4] == 0:
        found.append((arb(-1), arb(0)))
    return found, False


def _balls(coefficients: list[Any]) -> list[Any]:
    """The distinct real roots of a polynomial with ``fmpq`` coefficients, lowest power first, as disjoint balls."""
    from flint import fmpq_poly

    polynomial = fmpq_poly(coefficients)
    return [root.refined(PRECISION).ball for root in real_roots(polynomial)] if polynomial.degree() > 0 else []


def _fractions(numbers: Array) -> Array:
    """Doubles at their binary value, an object array of the same shape."""
    from flint import fmpq

    found = _object([fmpq(*x.as_integer_ratio()) for x in numbers.ravel().tolist()])
    return found.reshape(numbers.shape)


def _object(numbers: list[Any]) -> Array:
    found = np.empty(len(numbers), object)
    found[:] = numbers
    return found


def _direction(c: Any, s: Any) -> tuple[Any, Any]:
    """Cosine and sine of the direction (c, s); of the direction 0 where it is not known."""
    from flint import arb

    length = (c * c + s * s).sqrt()
    return (c / length, s / length) if length > 0 else (arb(1), arb(0))


def _angle(c: Any, s: Any) -> float:
    """The angle of the direction (c, s), in double precision."""
    return math.atan2(float(s.mid()), float(c.mid()))


# ---- where the point lies on the second axis -----------------------------------------------------------------------


def _on_second_axis(values: Array) -> Iterator[tuple[float, Array]]:
    """Every theta3 that puts the point on axis 2 (W = 0), with the target (rho, z) reached there for every theta2."""
    d3, d4 = values[5], values[6]
    if d4 == 0.0 or d3 > d4:
        return
    elbow = math.acos(-d3 / d4)
    for theta3 in sorted({elbow, -elbow}):
        turn = np.array([math.cos(theta3), math.sin(theta3)])
        if evaluator("shoulder")(values, np.zeros(2), turn)[2] <= CLOSED**2:
            x, y, z = evaluator("unturned")(values, np.array([1.0, 0.0]), turn)
            yield theta3, np.array([math.hypot(x, y), z])


def _with_pivots(values: Array, point: Array, found: list[Array], pivots: list[tuple[float, Array]]) -> list[Array]:
    """The postures at a point that is reached with theta2 free: that one with theta2 = 0, and the others."""
    rho = math.hypot(point[0], point[1])
    for theta3, target in pivots:
        if math.hypot(rho - target[0], point[2] - target[1]) <= CLOSED:
            turn = np.array([math.cos(theta3), math.sin(theta3)])
            x, y, _ = evaluator("unturned")(values, np.array([1.0, 0.0]), turn)
            theta1 = math.atan2(point[1], point[0]) - math.atan2(y, x)
            found = [q for q in found if abs(math.remainder(q[2] - theta3, TURN)) > 1e-5]
            found.append(np.array([theta1, 0.0, theta3]))
    return found


# ---- axes 1 and 2 intersect or are parallel -------------------------------------------------------------------------


def _in_closed_form(values: Array, points: Array) -> tuple[Array, Array, int]:
    """As :func:`_from_quartic`, for d2 = 0 or sa2 = 0; solutions that rounding cannot tell apart are given once."""
    name = "postures_parallel" if values[1] == 0.0 else "postures_intersecting"
    angles, closure, width = evaluator(name)(values, points)
    valid = closure <= CLOSED
    for later in range(1, 4):
        for earlier in range(later):
            apart = np.abs(np.sin((angles[:, later, 1:] - angles[:, earlier, 1:]) / 2.0)).max(axis=-1)
            valid[:, later] &= ~((apart <= ALIKE) & valid[:, earlier])
    angles[~valid] = np.nan
    free = np.stack([(valid & (width <= CLOSED**2)).any(axis=-1), np.zeros(len(points), bool)], axis=-1)
    _, sa2, _, sa3, _, d3, d4, r2, _ = values
    still = d4 == 0.0 or (sa2 == 0.0 and sa3 == 0.0) or (sa2 != 0.0 and d3 == 0.0 and sa3 * r2 == 0.0)
    free[:, 1] = still & valid.any(axis=-1)
    return _sorted(wrapped(angles)), free, 0
