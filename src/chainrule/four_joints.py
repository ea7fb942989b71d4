"""First-order speed ratios of planar arms with four joints: all real solutions, by elimination.

Ambike, Schmiedeler and Stanisic count a linear, a quadratic and a sextic equation and leave them to a search. At unit
tip speed along the tangent, joint rates are x = J^+ T + x1 n1 + x2 n2 (n1, n2 a basis of the null space), and tangent,
curvature k and its rate rho are met where a conic and a cubic of the plane (x1, x2) meet:
    T x r'' = k,        T x r''' - 3 k (T.r'') = rho.
So there are at most six solutions. One coordinate is eliminated exactly (the resultant of degree six, over the
rationals), its roots are isolated with a proof (FLINT's ball arithmetic), and every root gives one solution.

The count is proved for the arm, not for rounded coefficients: each of the solutions, complex ones included, is shown to
be alone in a box of its own for all coefficients within a margin (Krawczyk's test). Where that fails, the coefficients
are computed again at 120 digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError
from chainrule.higher_order import SINGULAR, STILL, leading_joint, path_point

if TYPE_CHECKING:
    from flint import acb, arb, fmpq, fmpq_poly

Array = NDArray[Any]

#: Exponents of (x1, x2) in the order of the generated coefficients.
QUADRATIC = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
CUBIC = (*QUADRATIC, (3, 0), (2, 1), (1, 2), (0, 3))

#: Margin of the generated coefficients, relative to the largest, at a well-conditioned configuration.
MARGIN = 1e-12
#: Digits of the coefficients where that margin does not decide, their margin, and what counts as zero among them.
DIGITS, FINE_MARGIN, ZERO = 120, 1e-90, 1e-60
#: Solutions nearer to each other than this (relative to 1 + |x|) are one of a higher multiplicity.
SAME = 1e-20
#: Coordinates above this, relative to 1 + |J^+ T|, count as at infinity: rounding the joint values to doubles makes
#: such solutions out of infinite ones, and rounding the rates alone changes dk/ds by about 1e-16 of their fourth power.
INFINITE = 1e4
#: Bits of the isolated roots.
BITS = 600

#: What each status means.
STATUSES = {
    "exact": "every solution that meets tangent, curvature and curvature rate",
    "nearest rate": "no real solution: tangent and curvature are met, the curvature's rate as nearly as possible",
    "nearest curvature": "no constant rates meet the curvature: it is met as nearly as possible",
    "infinitely many": "the conic and the cubic share a curve: one rate can be chosen freely; none is listed",
    "unbounded": "the curvature is met, and its rate comes nearest only with unbounded joint rates; none is listed",
}


@dataclass(frozen=True)
class FourJointRatios:
    """All first-order solutions at one configuration; k of them, the chosen one among them.

    Attributes:
        status: a key of :data:`STATUSES`.
        count: number of different real solutions of the three conditions: 0 to 6; -1 where they are infinitely many.
        complex_count: number of those that are not real.
        at_infinity: how many of the six have gone to infinity (:data:`INFINITE`).
        multiplicity: (k,) 1, or more where solutions coincide to 20 digits.
        certified: whether the count is proved (see the module); not where solutions coincide.
        separation: distance of the two nearest of the six solutions, relative to 1 + |x|: small where a slightly
            different path or posture may have two solutions more or fewer.
        rates: (k, 4) joint rates at unit tip speed, rad/m (m/m for prismatic joints).
        coordinates: (k, 2) the same as (x1, x2): rates = least + coordinates @ basis.
        path: (k, 4) what the tip does at these constant rates: speed, signed curvature, dk/ds, d^2k/ds^2.
        desired: (3,) the curvature wanted, and its first two derivatives.
        chosen: which one's path stays nearest: the least error of the first derivative of the curvature that is not
            met; None where there is none.
        least: (4,) J^+ T.
        basis: (2, 4) orthonormal basis of the null space.
        conic: (6,) coefficients of T x r'' - k over 1, x1, x2, x1^2, x1 x2, x2^2.
        cubic: (10,) those of T x r''' - 3 k (T.r'') - rho, with x1^3, x1^2 x2, x1 x2^2, x2^3 besides.
    """

    status: str
    count: int
    complex_count: int
    at_infinity: int
    multiplicity: Array
    certified: bool
    separation: float
    rates: Array
    coordinates: Array
    path: Array
    desired: Array
    chosen: int | None
    least: Array
    basis: Array
    conic: Array
    cubic: Array

    def ratios(self, leading: int = 1) -> Array:
        """(k, 4): the rates over those of a leading joint (from 1).

        Raises:
            InputError: there is no such joint, or it stands still in one of the solutions (which has no ratios to it).
        """
        leading = leading_joint(leading, 4)
        lead = self.rates[:, leading - 1 : leading]
        still = np.abs(lead[:, 0]) <= STILL * np.abs(self.rates).max(axis=1)
        if still.any():
            which = int(still.argmax())
            other = int(np.abs(self.rates[which]).argmax()) + 1
            raise InputError(f"leading: joint {leading} stands still in solution {which + 1}; joint {other} moves")
        found: Array = self.rates / lead
        return found

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        names = ("speed", "curvature", "curvature_rate", "curvature_second")
        return {
            "status": self.status,
            "count": self.count,
            "complex_count": self.complex_count,
            "at_infinity": self.at_infinity,
            "certified": self.certified,
            "separation": self.separation if np.isfinite(self.separation) else None,
            "chosen": self.chosen,
            "solutions": [
                {"rates": rates.tolist(), "multiplicity": int(m)} | dict(zip(names, path.tolist(), strict=True))
                for rates, m, path in zip(self.rates, self.multiplicity, self.path, strict=True)
            ],
        }


def speed_ratios_4(
    arm: Arm,
    q: Any,
    tangent: Any,
    curvature: float,
    curvature_rate: float = 0.0,
    curvature_second: float = 0.0,
) -> FourJointRatios:
    """All joint rates of a planar arm with four joints that meet tangent, curvature and curvature's rate.

    Where there is none, those that come nearest (see :data:`STATUSES`).

    Args:
        arm: a planar arm with four joints.
        q: (4,) rad or m.
        tangent: (2,) direction of the path.
        curvature: signed curvature k in 1/m; left turns are positive.
        curvature_rate: dk/ds in 1/m^2.
        curvature_second: d^2k/ds^2 in 1/m^3, by which one of several solutions is chosen.

    Raises:
        InputError: another kind of arm, a singular configuration, wrong shapes.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar("RRRR", [1.0, 0.8, 0.6, 0.4])
        >>> found = cr.speed_ratios_4(arm, [0.2, 0.8, 0.9, -1.2], [0.6, 0.8], 0.3)
        >>> found.status, found.count, found.certified
        ('exact', 4, True)
        >>> found.path[found.chosen][:3].round(9) + 0.0   # speed, curvature, dk/ds
        array([1. , 0.3, 0. ])
    """
    found = speed_ratios_4_each(arm, q, tangent, curvature, curvature_rate, curvature_second)
    if len(found) != 1 or np.ndim(q) != 1:
        raise InputError("speed_ratios_4 takes one configuration (4,); speed_ratios_4_each takes many")
    return found[0]


def speed_ratios_4_each(
    arm: Arm, q: Any, tangent: Any, curvature: Any, curvature_rate: Any = 0.0, curvature_second: Any = 0.0
) -> tuple[FourJointRatios, ...]:
    """:func:`speed_ratios_4` at many configurations (..., 4), one after the other; leading axes broadcast.

    The coefficients and the paths are generated functions over the whole batch; the elimination is a loop in Python.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar("RRRR", [1.0, 0.8, 0.6, 0.4])
        >>> [f.count for f in cr.speed_ratios_4_each(arm, [0.2, 0.8, 0.9, -1.2], [0.6, 0.8], [0.0, 0.3, 2.0])]
        [6, 4, 2]
    """
    if isinstance(arm, Arm) and arm.n != 4:
        raise InputError(f"{arm.name}: {arm.n} joints; planar arms with four joints are accepted")
    point = path_point(
        arm, q, tangent, curvature=curvature, curvature_rate=curvature_rate, curvature_second=curvature_second
    )
    values = np.linalg.svd(arm.jacobian(point.q, task="position"), compute_uv=False)
    singular = values[..., 1] <= SINGULAR * values[..., 0]
    if singular.any():
        where = tuple(int(k) for k in np.argwhere(singular)[0])
        at = f", configuration {where if len(where) > 1 else where[0]}" if where else ""
        raise InputError(f"{arm.name}{at}: singular, the tip can move along one line only; a regular one is accepted")
    coefficients = arm.evaluator("speed_ratio_conditions")(point.q, arm.parameters, point.tangent)
    flat = [np.reshape(c, (-1, *c.shape[point.q.ndim - 1 :])) for c in coefficients]
    wanted = np.stack([np.ravel(g) for g in point.geometry], axis=1)
    condition = np.ravel(values[..., 0] / values[..., 1])
    q_rows, t_rows = point.q.reshape(-1, 4), point.tangent.reshape(-1, 2)
    return tuple(
        _solve_one(_Place(arm, q_rows[k], t_rows[k], wanted[k], float(condition[k]), *(c[k] for c in flat)))
        for k in range(len(wanted))
    )


@dataclass(frozen=True)
class _Place:
    """One configuration: what is wanted there, and the generated coefficients."""

    arm: Arm
    q: Array
    tangent: Array
    wanted: Array
    condition: float
    least: Array
    basis: Array
    along: Array
    across: Array
    third: Array

    def rough(self) -> _System:
        """Conic and cubic as generated, in double precision."""
        across, third, along = ([_exact(c) for c in row] for row in (self.across, self.third, self.along))
        return _system(across, third, along, self.wanted, MARGIN * self.condition**2)

    def fine(self) -> _System:
        """The same from the derivation itself, at :data:`DIGITS` digits."""
        import mpmath

        from chainrule.derive import catalogue
        from chainrule.derive.program import evaluate

        model = self.arm.description.model
        program = next(
            f.program for f in catalogue.functions(model, "speed_ratio") if f.name == "speed_ratio_conditions"
        )
        with mpmath.workdps(DIGITS):
            unit = [mpmath.mpf(float(t)) for t in self.tangent]
            length = mpmath.sqrt(unit[0] ** 2 + unit[1] ** 2)
            given: dict[str, Any] = {
                "q": self.q,
                "parameters": self.arm.parameters,
                "tangent": [t / length for t in unit],
            }
            found = evaluate(program, given, DIGITS)
            across, third, along = ([_exact(c) for c in found[name]] for name in ("across", "third", "along"))
            return _system(across, third, along, self.wanted, FINE_MARGIN)


@dataclass(frozen=True)
class _System:
    """A conic (6,) and a cubic (10,) with rational coefficients.

    Each coefficient is known to the margin, relative to the size of the numbers it was made of.
    """

    conic: list[fmpq]
    cubic: list[fmpq]
    sizes: tuple[fmpq, fmpq]
    margin: float


def _largest(*rows: Sequence[fmpq]) -> fmpq:
    return max((abs(c) for row in rows for c in row), default=_exact(0.0))


def _system(across: list[fmpq], third: list[fmpq], along: list[fmpq], wanted: Array, margin: float) -> _System:
    """T x r'' - k and T x r''' - 3 k (T.r'') - rho."""
    k, rate = _exact(wanted[0]), _exact(wanted[1])
    bent = [3 * k * c for c in along]
    cubic = [c - (bent[i] if i < len(bent) else 0) for i, c in enumerate(third)]
    sizes = _largest(across, [k]), _largest(third, bent, [rate])
    return _System([across[0] - k, *across[1:]], [cubic[0] - rate, *cubic[1:]], sizes, margin)


def _extrema(system: _System) -> _System:
    """The conic, and the cubic det(grad conic, grad cubic): on the conic its zeros are the extrema of the given one."""
    return _turned(system, system.cubic, system.sizes[1])


def _feet(system: _System) -> _System:
    """The conic, and what vanishes at its points nearest to (or furthest from) the origin, where |rates| is extreme."""
    square = [_exact(0.5 if power in ((2, 0), (0, 2)) else 0.0) for power in CUBIC]
    return _turned(system, square, _exact(1.0))


def _turned(system: _System, cubic: list[fmpq], size: fmpq) -> _System:
    """The conic, and the determinant of its gradient and that of the given cubic."""
    total = dict.fromkeys(CUBIC, _exact(0.0))
    for (i, j), a in zip(CUBIC, system.conic, strict=False):
        for (k, m), b in zip(CUBIC, cubic, strict=True):
            weight = i * m - j * k  # of x^(i + k - 1) y^(j + m - 1)
            if weight:
                total[i + k - 1, j + m - 1] += weight * a * b
    sizes = system.sizes[0], 36 * system.sizes[0] * size
    return _System(system.conic, [total[power] for power in CUBIC], sizes, system.margin)


def _exact(number: Any) -> fmpq:
    """A double's or mpmath number's exact value."""
    from flint import fmpq

    if hasattr(number, "man_exp"):
        mantissa, exponent = number.man_exp
        sign = -1 if number < 0 and mantissa > 0 else 1
        return fmpq(sign * int(mantissa)) * fmpq(2) ** int(exponent)
    return fmpq(*float(number).as_integer_ratio())


@dataclass(frozen=True)
class _Roots:
    """The finite common points of a conic and a cubic: all of them, multiple ones once, or none if they share a curve.

    ``points`` holds ((x1, x2), multiplicity); x1 and x2 are complex balls, with the imaginary part 0 where real.
    """

    points: list[tuple[tuple[acb, acb], int]]
    infinite: int
    shared: bool
    certified: bool
    separation: float

    @property
    def real(self) -> list[tuple[tuple[arb, arb], int]]:
        """The real ones."""
        return [((x.real, y.real), m) for (x, y), m in self.points if x.imag == 0 and y.imag == 0]


def _intersect(place: _Place, rough: _System, change: Callable[[_System], _System] = lambda system: system) -> _Roots:
    """The common points by the generated coefficients; where their margin does not decide, by those at 120 digits."""
    size = 1.0 + float(np.abs(place.least).max())
    found = _common(change(rough), size, zero=None)
    return found if found.certified else _common(change(place.fine()), size, zero=_exact(ZERO))


def _common(system: _System, size: float, zero: fmpq | None) -> _Roots:
    """The common points. With ``zero``, coefficients below it (relative) are zero, as at 120 digits.

    In the direction x = x1 + c x2 no two of them may lie above each other. At most 15 directions join two of the six
    and at most 2 have no constant leading coefficient in x2, so among 20 integers c there is one.
    """
    from flint import ctx

    before = ctx.prec
    try:
        ctx.prec = BITS
        for c in (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8, -8, 9, -9, 10):
            found = _sheared(system, c, size, zero)
            if found is not None:
                return found
        return _Roots([], 0, True, False, 0.0)
    finally:
        ctx.prec = before


def _columns(coefficients: Sequence[fmpq], c: int) -> list[fmpq_poly]:
    """A polynomial in (x1, x2) = (x - c y, y) by powers of y: each coefficient a polynomial in x."""
    from math import comb

    from flint import fmpq_poly

    degree = 2 if len(coefficients) == len(QUADRATIC) else 3
    columns = [[_exact(0.0)] * (degree + 1) for _ in range(degree + 1)]
    for (i, j), value in zip(CUBIC, coefficients, strict=False):
        for k in range(i + 1):
            columns[j + k][i - k] += value * comb(i, k) * (-c) ** k
    return [fmpq_poly(column) for column in columns]


def _norm(polynomial: fmpq_poly) -> fmpq:
    return sum((abs(c) for c in polynomial.coeffs()), _exact(0.0))


def _tidy(polynomial: fmpq_poly, scale: fmpq, zero: fmpq | None) -> fmpq_poly:
    from flint import fmpq_poly

    if zero is None:
        return polynomial
    return fmpq_poly([c if abs(c) > zero * scale else 0 for c in polynomial.coeffs()])


def _sheared(system: _System, c: int, size: float, zero: fmpq | None) -> _Roots | None:
    """The common points seen along one direction, or None if it is not a good one.

    With the conic y^2 + f1 y + f0 the cubic leaves the remainder A y + B, and their resultant is B^2 - f1 A B + f0 A^2.
    """
    conic, cubic = (
        [v if zero is None or abs(v) > zero * size_of else _exact(0.0) for v in row]
        for row, size_of in zip((system.conic, system.cubic), system.sizes, strict=True)
    )
    f, g = _columns(conic, c), _columns(cubic, c)
    if not any(v != 0 for v in conic[1:]):
        # no curve: nothing, or the whole plane, of which the cubic takes a curve if it is one
        shared = conic[0] == 0 and (cubic[0] == 0 or any(v != 0 for v in cubic[1:]))
        return _Roots([], 6, shared, not shared, float("inf"))
    quadratic = any(v != 0 for v in conic[3:])
    if quadratic:
        if not f[2]:
            return None
        lead = f[2][0]
        f0, f1 = f[0] / lead, f[1] / lead
        # y^2 = -f1 y - f0, so y^3 = (f1^2 - f0) y + f0 f1
        a = g[1] - g[2] * f1 + g[3] * (f1 * f1 - f0)
        b = g[0] - g[2] * f0 + g[3] * f0 * f1
        scale = 30 * system.sizes[1] * (1 + _norm(f0) + _norm(f1)) ** 2
        a, b = _tidy(a, scale, zero), _tidy(b, scale, zero)
        resultant = b * b - f1 * a * b + f0 * a * a
        scale = scale**2 * (1 + _norm(f0) + _norm(f1))
    else:
        if not f[1]:
            return None
        f0, f1 = f[0] / f[1][0], None
        a, b = _one(), f0
        resultant = g[0] - f0 * (g[1] - f0 * (g[2] - f0 * g[3]))
        scale = 30 * system.sizes[1] * (1 + _norm(f0)) ** 3
    resultant = _tidy(resultant, scale, zero)
    if not resultant:
        return _Roots([], 0, True, False, 0.0)
    points = _above(resultant, a, b, f0, f1, c)
    if points is None:
        return None
    near = [p for p in points if max(abs(complex(v)) for v in p[0]) <= INFINITE * size]
    merged = _merged(near)
    separation = _separation([p for p, _ in merged]) if len(merged) == len(near) else 0.0
    six = 6 if quadratic else 3
    finite = sum(m for _, m in merged)
    whole = finite == six or zero is not None
    certified = whole and all(m == 1 for _, m in merged) and _alone(system, [p for p, _ in merged])
    return _Roots(merged, 6 - finite, False, certified, separation)


def _one() -> fmpq_poly:
    from flint import fmpq_poly

    return fmpq_poly([1])


def _above(
    resultant: fmpq_poly, a: fmpq_poly, b: fmpq_poly, f0: fmpq_poly, f1: fmpq_poly | None, c: int
) -> list[tuple[tuple[acb, acb], int]] | None:
    """The points above the roots of the resultant; None if two points may be above one of them.

    A y + B = 0 gives y. Where A and B vanish both, the two points of the conic above the root are on the cubic; they
    are one point if the conic's discriminant vanishes there too (the crossing of two lines).
    """
    found = []
    roots: Any = resultant.numer().complex_roots()  # pairs (root, multiplicity)
    for x, multiplicity in roots:
        slope = _horner(a, x)
        if not slope.contains(0):
            y = -_horner(b, x) / slope
        elif f1 is not None and (_horner(f1, x) ** 2 - 4 * _horner(f0, x)).contains(0):
            y = -_horner(f1, x) / 2
        else:
            return None
        found.append((_point(x, y, c), multiplicity))
    return found


def _horner(polynomial: fmpq_poly, x: acb) -> acb:
    from flint import acb

    value = acb(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * x + coefficient
    return value


def _point(x: acb, y: acb, c: int) -> tuple[acb, acb]:
    """(x1, x2) = (x - c y, y); real where x is."""
    from flint import acb

    if x.imag == 0:  # flint isolates the real roots with an imaginary part that is exactly zero
        x, y = acb(x.real), acb(y.real)
    return x - c * y, y


def _merged(points: Sequence[tuple[tuple[acb, acb], int]]) -> list[tuple[tuple[acb, acb], int]]:
    """Points nearer than :data:`SAME` as one; a pair of conjugates that near is a real point."""
    from flint import acb

    left, found = list(points), []
    while left:
        (here, count), *left = left
        group = [p for p in left if _distance(here, p[0]) < SAME]
        left = [p for p in left if _distance(here, p[0]) >= SAME]
        if group:
            real = any(p[0].imag == 0 and p[1].imag == 0 for p, _ in [(here, count), *group]) or all(
                abs(float(v.imag)) < SAME * (1.0 + abs(complex(v))) for v in here
            )
            here = (acb(here[0].real), acb(here[1].real)) if real else here
        found.append((here, count + sum(m for _, m in group)))
    return found


def _distance(p: tuple[acb, acb], q: tuple[acb, acb]) -> float:
    """The distance of two points, relative to 1 + |p|."""
    gap = max(abs(complex(a - b)) for a, b in zip(p, q, strict=True))
    return gap / (1.0 + max(abs(complex(a)) for a in p))


def _separation(points: Sequence[tuple[acb, acb]]) -> float:
    pairs = ((p, q) for i, p in enumerate(points) for q in points[:i])
    return min((_distance(p, q) for p, q in pairs), default=float("inf"))


# ---- the proof that every point is alone in a box ---------------------------------------------------------------


def _alone(system: _System, points: Sequence[tuple[acb, acb]]) -> bool:
    """Whether each point has a box of its own with exactly one common point, for all coefficients within the margin.

    Krawczyk: with Y near the inverse derivative at the centre p, the system F has exactly one zero in the box p + R if
    |Y F(p)| + |1 - Y F'(p + R)| R < R. A real box that holds one point of a real system holds a real one.
    """
    from flint import arb

    boxes = []
    conic, cubic = (
        _balls(row, system.margin * float(arb(size)))
        for row, size in zip((system.conic, system.cubic), system.sizes, strict=True)
    )
    for x, y in points:
        box = _box(conic, cubic, x.mid(), y.mid())
        if box is None:
            return False
        real = x.imag == 0 and y.imag == 0
        if not real and not any(abs(complex(v.mid()).imag) > box for v in (x, y)):
            return False
        boxes.append(((complex(x.mid()), complex(y.mid())), box))
    return all(
        max(abs(a - b) for a, b in zip(p, q, strict=True)) > 1.01 * (r + s) + 1e-300
        for k, (p, r) in enumerate(boxes)
        for q, s in boxes[:k]
    )


def _balls(coefficients: Sequence[fmpq], radius: float) -> list[arb]:
    from flint import arb

    return [arb(arb(c).mid(), radius) for c in coefficients]


def _box(conic: Sequence[arb], cubic: Sequence[arb], x: acb, y: acb) -> float | None:
    """The half-width of a box about (x, y) in which there is exactly one common point, or None."""
    from flint import acb, arb

    fx, fy, gx, gy = _slopes(conic, cubic, x, y)
    determinant = (fx * gy - fy * gx).mid()
    if determinant == 0:
        return None
    inverse = [[v.mid() / determinant for v in row] for row in ((gy, -fy), (-gx, fx))]
    values = [_value(c, x, y) for c in (conic, cubic)]
    step = [float((row[0] * values[0] + row[1] * values[1]).abs_upper()) for row in inverse]
    width = 2.5 * max(step) + 1e-100
    if not np.isfinite(width):
        return None
    ball = acb(arb(0, width), arb(0, width))
    fx, fy, gx, gy = _slopes(conic, cubic, x + ball, y + ball)
    for row, moved, unit in zip(inverse, step, ((1, 0), (0, 1)), strict=True):
        left = unit[0] - (row[0] * fx + row[1] * gx), unit[1] - (row[0] * fy + row[1] * gy)
        # a box of half-width w in real and imaginary parts: |w + i w| = 1.5 w at most
        if not moved + 1.5 * width * sum(float(v.abs_upper()) for v in left) < width:
            return None
    return width


def _powers(x: acb, y: acb) -> Iterator[acb]:
    from flint import acb

    ups = [[acb(1), v, v * v, v * v * v] for v in (x, y)]
    return (ups[0][i] * ups[1][j] for i, j in CUBIC)


def _value(coefficients: Sequence[arb], x: acb, y: acb) -> acb:
    from flint import acb

    return sum((c * p for c, p in zip(coefficients, _powers(x, y), strict=False)), acb(0))


def _slopes(conic: Sequence[arb], cubic: Sequence[arb], x: acb, y: acb) -> tuple[acb, acb, acb, acb]:
    found = []
    for coefficients in (conic, cubic):
        known = dict(zip(CUBIC, coefficients, strict=False))
        by_x: list[Any] = [known.get((i + 1, j), 0) * (i + 1) for i, j in QUADRATIC]
        by_y: list[Any] = [known.get((i, j + 1), 0) * (j + 1) for i, j in QUADRATIC]
        found += [_value(by_x, x, y), _value(by_y, x, y)]
    fx, fy, gx, gy = found
    return fx, fy, gx, gy


# ---- one configuration -------------------------------------------------------------------------------------------


def _solve_one(place: _Place) -> FourJointRatios:
    """The solutions, or what comes nearest."""
    rough = place.rough()
    roots = _intersect(place, rough)
    if not roots.shared and roots.real:
        return _result(place, rough, "exact", roots, roots.real)
    cubic = _doubles(rough.cubic)

    def miss(point: tuple[tuple[Any, Any], int]) -> float:
        """By how much dk/ds is missed on the conic."""
        (x, y), _ = point
        return abs(_at(cubic, float(x), float(y)))

    if roots.shared:
        # of the shared curve the points with the least rates; elsewhere on the conic the cubic does not vanish
        feet = _intersect(place, rough, _feet).real
        met = [(p, 1) for p, _ in feet if miss((p, 1)) <= 1e-8 * float(np.abs(cubic).max())]
        return _result(place, rough, "infinitely many", roots, met, count=-1)
    extremum = _extremum(place)
    if extremum is not None:
        point, met_too = extremum
        return _result(place, rough, "nearest rate" if met_too else "nearest curvature", roots, [(point, 1)], count=0)
    extrema = _intersect(place, rough, _extrema)
    # where dk/ds is constant along a line of the conic, every point of it is an extremum: the one with the least rates
    candidates = extrema.real + (_intersect(place, rough, _feet).real if extrema.shared else [])
    if not candidates:
        return _result(place, rough, "unbounded", roots, [], count=0)
    nearest, _ = min(candidates, key=miss)
    return _result(place, rough, "nearest rate", roots, [(nearest, 1)], count=0)


def _doubles(coefficients: Sequence[fmpq]) -> Array:
    from flint import arb

    return np.array([float(arb(c)) for c in coefficients])


def _at(coefficients: Array, x: float, y: float) -> float:
    return float(sum(c * x**i * y**j for c, (i, j) in zip(coefficients, CUBIC, strict=False)))


def _extremum(place: _Place) -> tuple[tuple[float, float], bool] | None:
    """Where T x r'' is nearest to the curvature wanted, if no curve meets it; and whether this point does."""
    c = place.across
    size = max(float(np.abs(c).max()), abs(float(place.wanted[0])))
    slack = MARGIN * place.condition**2 * size  # what is zero in exact arithmetic, rounding leaves below this
    values, vectors = np.linalg.eigh(np.array([[c[3], c[4] / 2.0], [c[4] / 2.0, c[5]]]))
    linear = vectors.T @ c[1:3]
    flat = np.abs(values) <= slack
    if (flat & (np.abs(linear) > slack)).any() or ((values > slack).any() and (values < -slack).any()):
        return None  # it takes every value
    at = vectors @ np.where(flat, 0.0, -linear / (2.0 * np.where(flat, 1.0, values)))
    gap = float(place.wanted[0]) - _at(c, float(at[0]), float(at[1]))
    met = abs(gap) <= slack
    if not met and not flat.all() and gap * float(values[~flat].sum()) > 0.0:
        return None  # beyond the extremum there is an ellipse, or two lines
    return None if met and flat.any() and not flat.all() else ((float(at[0]), float(at[1])), met)


def _result(
    place: _Place,
    system: _System,
    status: str,
    roots: _Roots,
    listed: Sequence[tuple[tuple[Any, Any], int]],
    count: int | None = None,
) -> FourJointRatios:
    """The listed points as rates, with the paths they make and the choice among them."""
    at = np.array([[float(v) for v in point] for point, _ in listed]).reshape(-1, 2)
    at = at[np.lexsort(at.T[::-1])]
    order = {tuple(float(v) for v in point): m for point, m in listed}
    rates = place.least + at @ place.basis
    still = np.zeros_like(rates)
    path = place.arm.evaluator("tip_motion")(place.q, place.arm.parameters, rates, still, still)[1]
    first_missed = {"nearest curvature": 0, "nearest rate": 1}.get(status, 2)
    error = np.abs(path[:, 1 + first_missed] - place.wanted[first_missed])
    return FourJointRatios(
        status,
        len(listed) if count is None else count,
        sum(m for _, m in roots.points) - sum(m for _, m in roots.real),
        roots.infinite,
        np.array([order[tuple(row)] for row in at.tolist()], dtype=int),
        roots.certified,
        roots.separation,
        rates,
        at,
        path,
        place.wanted,
        int(error.argmin()) if len(error) else None,
        place.least,
        place.basis,
        _doubles(system.conic),
        _doubles(system.cubic),
    )
