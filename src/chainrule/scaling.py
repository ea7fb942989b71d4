"""How fast a joint path can be run under limits on joint velocities and accelerations.

A path q(s) is given; s(t) is sought with q' s_t and q'' s_t^2 + q' s_tt inside the limits. Two ways:

"stop": a polyline of knots (constant joint rates in each stretch) run exactly, with rest at every knot. Each stretch is
one rest-to-rest move in closed form, all joints in phase, so it is always feasible.

"toppra": without stops, the fastest s(t) on a path whose tangent is continuous, by reachability analysis (Pham and Pham
2018, the package TOPP-RA). A polyline's corners are first rounded by parabolas that stay within a stated deviation.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import GenerationError, InputError, shown
from chainrule.higher_order import MotionRatios
from chainrule.inputs import real_array

Array = NDArray[Any]

#: Grid intervals over a whole path, and the least number in one piece of it.
GRID, LEAST = 400, 8
#: Knots nearer to each other than this share of the allowed deviation are one where corners are rounded.
NEAR = 1e-3
#: Pieces shorter than this share of the path are too short for the grid.
SHORTEST = 1e-9
#: How far before the end of a piece its last grid point lies, relative to its length.
EDGE = 1e-4
#: Points of every grid interval at which the limits are checked at last.
CHECKED = 9


@dataclass(frozen=True)
class JointPath:
    """A joint path q(s) in polynomial pieces.

    Attributes:
        breaks: (k + 1,) rising values of s where the pieces meet.
        pieces: (k, degree + 1, n) coefficients of 1, s, s^2, ... with s counted from the piece's start.
        marks: (m,) values of s at the knots (for a rounded polyline where it is nearest to them).
        corners: whether the tangent jumps where pieces meet.
    """

    breaks: Array
    pieces: Array
    marks: Array
    corners: bool

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.pieces.shape[2])

    def at(self, s: Any, order: int = 0, piece: Any = None) -> Array:
        """q or its derivative of the given order at s (m,): (m, n).

        Args:
            s: (m,) values of s.
            order: 0 for q, 1 for q', ...
            piece: (m,) the piece to use; the one that s is in (the later one at a break) when absent.
        """
        s = np.asarray(s, float)
        last = len(self.pieces) - 1
        index = np.clip(np.searchsorted(self.breaks, s, side="right") - 1, 0, last) if piece is None else piece
        local = (s - self.breaks[index])[..., None]
        total = np.zeros((*s.shape, self.n))
        for power in range(self.pieces.shape[1] - 1, order - 1, -1):
            weight = float(np.prod(np.arange(power - order + 1, power + 1)))
            total = total * local + weight * self.pieces[index, power]
        return total


def polyline(knots: Any, weights: Any = 1.0) -> JointPath:
    """Straight stretches between knots (k + 1, n); s grows in each by the largest move over ``weights`` (n,).

    Knots that repeat their predecessor are passed over.

    Raises:
        InputError: fewer than two knots, or numbers that are not finite.

    Example:
        >>> polyline([[0.0, 0.0], [1.0, 2.0]]).at([1.0])
        array([[0.5, 1. ]])
    """
    points = _knots(knots)
    lengths = np.max(np.abs(np.diff(points, axis=0)) / _positive(weights, "weights", points.shape[1]), axis=1)
    marks = np.concatenate([[0.0], np.cumsum(lengths)])
    lengths = np.diff(marks)  # as the breaks have them: a stretch that rounding of the sum swallows is none
    moving = np.flatnonzero(lengths > 0.0)
    if not len(moving):
        return JointPath(np.zeros(2), np.stack([points[:1], 0.0 * points[:1]], axis=1), marks, False)
    starts = points[moving]
    slopes = (points[moving + 1] - starts) / lengths[moving, None]
    breaks = np.concatenate([[0.0], marks[moving + 1]])
    return JointPath(breaks, np.stack([starts, slopes], axis=1), marks, len(moving) > 1)


def rounded(knots: Any, deviation: Any, weights: Any = 1.0) -> JointPath:
    """The polyline with its corners rounded by parabolas, nowhere further than ``deviation`` from it in any joint.

    With u and v the slopes before and after a corner, the parabola that begins d before it and ends d behind it is off
    by at most d |v - u| / 4, at the corner. A rounding takes at most half of a stretch.

    Args:
        knots: (k + 1, n).
        deviation: positive, one number or (n,), rad or m.
        weights: (n,) as in :func:`polyline`.

    Example:
        >>> path = rounded([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], 0.05)
        >>> path.at(path.marks[1:2]).round(6)     # 0.05 from the corner (1, 0) in either joint
        array([[0.95, 0.05]])
    """
    points = _knots(knots)
    allowed = _positive(deviation, "deviation", points.shape[1])
    kept, stands = _apart(points, NEAR * allowed)
    straight = polyline(points[kept], weights)
    marks = straight.marks[stands]
    if len(kept) < len(points):
        allowed = allowed * (1.0 - NEAR)
    if len(straight.pieces) < 2:
        return JointPath(straight.breaks, straight.pieces, marks, False)
    slopes, lengths = straight.pieces[:, 1], np.diff(straight.breaks)
    jumps = np.abs(np.diff(slopes, axis=0))
    with np.errstate(divide="ignore"):
        reach = np.min(4.0 * allowed / jumps, axis=1)
    reach = np.minimum(reach, 0.5 * np.minimum(lengths[:-1], lengths[1:]))
    breaks, pieces, zero = [0.0], [], np.zeros(straight.n)
    for k, (start, slope) in enumerate(straight.pieces):
        before = reach[k - 1] if k else 0.0
        after = reach[k] if k < len(reach) else 0.0
        if lengths[k] - before - after > 1e-12 * lengths[k]:
            pieces.append([start + before * slope, slope, zero])
            breaks.append(straight.breaks[k + 1] - after)
        if k < len(reach):
            ahead = slopes[k + 1]
            corner = straight.pieces[k + 1, 0]
            pieces.append([corner - after * slope, slope, (ahead - slope) / (4.0 * after)])
            breaks.append(straight.breaks[k + 1] + after)
    return JointPath(np.array(breaks), np.array(pieces), marks, False)


def _apart(points: Array, near: Array) -> tuple[list[int], list[int]]:
    """The knots to keep, with no neighbour nearer than ``near`` in every joint, and which of them stands for each knot.

    Of a cluster the first is kept, and in the last one the last: both ends stay where they are.
    """
    kept, stands = [0], [0]
    for k in range(1, len(points)):
        if (np.abs(points[k] - points[kept[-1]]) > near).any():
            kept.append(k)
        stands.append(len(kept) - 1)
    if len(kept) == 1:
        return [0, len(points) - 1], [*stands[:-1], 1]
    return [*kept[:-1], len(points) - 1], stands


def motion_path(motion: MotionRatios, length: float) -> JointPath:
    """The joint motion of one configuration's speed ratios over an arc length (m): a polynomial of degree 2 or 3.

    Raises:
        InputError: ratios of a batch, or a length that is not positive.
    """
    if not isinstance(motion, MotionRatios):
        raise InputError(f"motion: {shown(motion)}; what motion_ratios gives is accepted")
    if motion.rates.ndim != 1:
        raise InputError(f"a batch {motion.rates.shape[:-1]} of motions; one is accepted")
    end = float(_positive(length, "length", None))
    pieces = np.stack([motion.point.q, motion.rates, motion.second / 2.0, motion.third / 6.0])
    return JointPath(np.array([0.0, end]), pieces[None, : motion.order + 1], np.array([0.0, end]), False)


def _knots(knots: Any) -> Array:
    points = real_array(knots, "knots")
    if points.ndim != 2 or len(points) < 2 or not points.shape[1]:
        raise InputError(f"knots has shape {points.shape}; (k + 1, n) with two knots or more is accepted")
    return points


def _positive(value: Any, name: str, n: int | None, finite: bool = True) -> Array:
    """A positive number, or one for each of n joints."""
    wanted = "a positive number" if n is None else f"a positive number, or one for each of {n} joints,"
    given = real_array(value, name, finite=finite)
    try:
        array = np.broadcast_to(given, () if n is None else (n,))
    except ValueError:
        raise InputError(f"{name}: {shown(value)} does not fit; {wanted} is accepted") from None
    if not (array > 0.0).all():
        raise InputError(f"{name}: {shown(value)} has an entry that is not positive; {wanted} is accepted")
    return array


@dataclass(frozen=True)
class TimeScaling:
    """A path with its timing: phases of constant s_tt.

    Attributes:
        method: "stop" or "toppra".
        path: the path q(s) that is run.
        times: (p + 1,) s, when the phases begin, and the end.
        positions: (p + 1,) s at those times.
        speeds: (p + 1,) s_t at those times.
        accelerations: (p,) s_tt in each phase.
        knot_times: (k + 1,) s, when the knots are passed.
    """

    method: str
    path: JointPath
    times: Array
    positions: Array
    speeds: Array
    accelerations: Array
    knot_times: Array

    @property
    def duration(self) -> float:
        """The whole time, s."""
        return float(self.times[-1])

    @property
    def durations(self) -> Array:
        """(k,) s, the time from knot to knot."""
        found: Array = np.diff(self.knot_times)
        return found

    def sample(self, t: Any) -> tuple[Array, Array, Array]:
        """Joint values, velocities and accelerations at times t (m,) in s, each (m, n); t is clipped to the run.

        Where the acceleration jumps, that of the later phase.
        """
        s, rate, u, k = self._along(t)
        if not len(self.accelerations):
            start = np.broadcast_to(self.path.pieces[0, 0], (*s.shape, self.path.n))
            return start, np.zeros_like(start), np.zeros_like(start)
        rate = rate[..., None]
        middle = (self.positions[k] + self.positions[k + 1]) / 2.0
        piece = np.clip(np.searchsorted(self.path.breaks, middle, side="right") - 1, 0, len(self.path.pieces) - 1)
        q, slope, bend = (self.path.at(s, order, piece) for order in (0, 1, 2))
        return q, slope * rate, bend * rate**2 + slope * u[..., None]

    def along(self, t: Any) -> tuple[Array, Array]:
        """Where on the path the run is at times t (m,) in s, and how fast: s and s_t, each (m,); t is clipped."""
        return self._along(t)[:2]

    def _along(self, t: Any) -> tuple[Array, Array, Array, Array]:
        """Position, speed and acceleration along the path, and the phase, at times t (m,)."""
        t = np.clip(real_array(t, "t"), 0.0, self.duration)
        if not len(self.accelerations):
            still = np.zeros(t.shape)
            return still + self.path.breaks[0], still, still, np.zeros(t.shape, int)
        k = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.accelerations) - 1)
        late, u = t - self.times[k], self.accelerations[k]
        s = self.positions[k] + late * (self.speeds[k] + late * u / 2.0)
        return np.clip(s, self.positions[k], self.positions[k + 1]), self.speeds[k] + late * u, u, k

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and lists."""
        return {"method": self.method, "duration": self.duration, "knot_times": self.knot_times.tolist()}


def time_scaling(
    path: Any, velocity: Any, acceleration: Any, *, method: str = "stop", deviation: Any = None
) -> TimeScaling:
    """The fastest run of a joint path from rest to rest under joint velocity and acceleration limits.

    Args:
        path: knots (k + 1, n) in rad or m, with constant joint rates between them; or a :class:`JointPath`.
        velocity: one number or (n,), rad/s or m/s; may be infinite.
        acceleration: one number or (n,), rad/s^2 or m/s^2.
        method: "stop" (rest at every knot; exact) or "toppra" (no stops; needs ``pip install chainrule[timing]``).
        deviation: "toppra" with knots: how far a rounded corner may leave the polyline, one number or (n,). If
            stopping at the knots (which leaves it nowhere) is no slower, or the roundings are too small for
            TOPP-RA's grid, the answer is that of "stop", as its ``method`` says.

    Raises:
        InputError: limits that are not positive, a path with bends for "stop" or with corners for "toppra", no
            deviation where one is needed, the package toppra not installed.
        GenerationError: TOPP-RA found no timing (its grid is too coarse for the path).

    Example:
        >>> move = time_scaling([[0.0, 0.0], [1.0, 0.5], [1.0, 1.5]], velocity=1.0, acceleration=2.0)
        >>> move.durations     # a trapezoid of height 1 over each: 1 / 1 + 1 / 2
        array([1.5, 1.5])
        >>> q, qd, qdd = move.sample([0.75, 1.5])
        >>> qd.round(6)
        array([[1. , 0.5],
               [0. , 0. ]])
    """
    if not isinstance(method, str) or method not in ("stop", "toppra"):
        raise InputError(f"method: {shown(method)} is not known; 'stop' and 'toppra' are accepted")
    n = path.n if isinstance(path, JointPath) else _knots(path).shape[1]
    limits = _positive(velocity, "velocity", n, finite=False), _positive(acceleration, "acceleration", n)
    weights = np.where(np.isfinite(limits[0]), limits[0], limits[1])
    if method == "stop":
        if deviation is not None:
            raise InputError("deviation: 'stop' runs the knots exactly and takes none; 'toppra' takes one")
        return _stopping(path if isinstance(path, JointPath) else polyline(path, weights), *limits)
    if not isinstance(path, JointPath):
        if deviation is None:
            raise InputError("deviation: 'toppra' rounds the corners between knots; say how far it may leave them")
        stops = _stopping(polyline(path, weights), *limits)
        smooth = rounded(path, deviation, weights)
        if np.diff(smooth.breaks).min() <= SHORTEST * smooth.breaks[-1]:
            return stops
        try:
            found = _fastest(smooth, *limits)
        except GenerationError:
            return stops
        # roundings so small that the corners are all but stops: the exact profile may beat the grid's
        return found if found.duration < stops.duration else stops
    if path.corners:
        raise InputError("this path has corners, at which 'toppra' would have to stop; 'stop' is accepted")
    return _fastest(path, *limits)


def _still(method: str, path: JointPath) -> TimeScaling:
    """No time at all for a path that goes nowhere."""
    zero = np.zeros(1)
    return TimeScaling(method, path, zero, zero, zero, np.zeros(0), np.zeros_like(path.marks))


def _stopping(path: JointPath, velocity: Array, acceleration: Array) -> TimeScaling:
    """Rest to rest in every stretch: s_t <= min V / |q'| and s_tt <= min A / |q'|."""
    from chainrule.description import REST_TO_REST
    from chainrule.evaluators import Evaluators

    if path.pieces.shape[1] > 2 and np.any(path.pieces[:, 2:]):
        raise InputError("'stop' is for straight stretches between knots; 'toppra' is accepted for this path")
    if path.breaks[-1] == path.breaks[0]:
        return _still("stop", path)
    lengths = np.diff(path.breaks)
    slopes = np.abs(path.pieces[:, 1])
    with np.errstate(divide="ignore"):
        bounds = [np.min(limit / slopes, axis=1) for limit in (velocity, acceleration)]
    rest_to_rest = Evaluators(REST_TO_REST).get("rest_to_rest", "rest_to_rest")
    assert rest_to_rest is not None
    peak, ramp, cruise, _ = rest_to_rest(np.stack([lengths, *bounds], axis=-1)).T
    zero = np.zeros_like(peak)
    steps = np.stack([ramp, cruise, ramp], axis=1).ravel()
    times = np.concatenate([[0.0], np.cumsum(steps)])
    rise = peak * ramp / 2.0
    starts = path.breaks[:-1]
    inner = np.stack([starts, starts + rise, starts + lengths - rise], axis=1).ravel()
    with np.errstate(invalid="ignore"):
        rate = peak / ramp
    return TimeScaling(
        "stop",
        path,
        times,
        np.append(inner, path.breaks[-1]),
        np.append(np.stack([zero, peak, peak], axis=1).ravel(), 0.0),
        np.stack([rate, zero, -rate], axis=1).ravel(),
        np.interp(path.marks, path.breaks, times[::3]),
    )


def _fastest(path: JointPath, velocity: Array, acceleration: Array) -> TimeScaling:
    """TOPP-RA's s_t^2 on a grid, and the time stretched until the limits hold between its points too."""
    try:
        import toppra  # type: ignore[import-untyped,unused-ignore]
    except ImportError:
        raise InputError("method 'toppra' needs the package toppra: pip install 'chainrule[timing]'") from None
    if path.breaks[-1] == path.breaks[0]:
        return _still("toppra", path)
    total = path.breaks[-1] - path.breaks[0]
    grid = np.concatenate([*(_grid(a, b, total) for a, b in pairwise(path.breaks)), path.breaks[-1:]])
    # in units in which the path is 1 long, its largest slope is 1 and so is the least acceleration limit:
    # TOPP-RA's tolerances are absolute numbers
    slopes = np.abs(path.at(grid, 1)).max(axis=0)
    least = float(acceleration.min())
    size = total * float(slopes.max())
    beat = np.sqrt(size / least)  # the unit of time
    pushes = acceleration / least
    # it takes finite velocity limits only: no joint needs one that it cannot reach on this path
    beyond = 10.0 * (np.sqrt(pushes * slopes / slopes.max()) + slopes / slopes.max())
    bound = np.minimum(velocity * beat / size, np.maximum(beyond, 1e-6))
    constraints = [
        toppra.constraint.JointVelocityConstraint(np.stack([-bound, bound], axis=1)),
        toppra.constraint.JointAccelerationConstraint(np.stack([-pushes, pushes], axis=1)),
    ]
    _, speeds, *_ = toppra.algorithm.TOPPRA(
        constraints,
        _adapter(path, total, size),
        gridpoints=(grid - path.breaks[0]) / total,
        parametrizer="ParametrizeConstAccel",
    ).compute_parameterization(0.0, 0.0)
    if speeds is None or not np.isfinite(speeds).all():
        raise GenerationError("TOPP-RA found no timing for this path: its grid is too coarse for it")
    speeds = speeds * total / beat
    steps = 2.0 * np.diff(grid) / (speeds[:-1] + speeds[1:])
    rates = np.diff(speeds**2) / (2.0 * np.diff(grid))
    found = TimeScaling(
        "toppra", path, np.concatenate([[0.0], np.cumsum(steps)]), grid, speeds, rates, np.zeros_like(path.marks)
    )
    slower = _excess(found, velocity, acceleration)
    times, speeds = found.times * slower, speeds / slower
    passed = _passing(grid, speeds, times, path.marks)
    return TimeScaling("toppra", path, times, grid, speeds, rates / slower**2, passed)


def _grid(start: float, end: float, total: float) -> Array:
    """Grid points of a piece of the path, without its end.

    At a break q'' jumps, and TOPP-RA sees only the value behind it; a point just before makes it see both.
    """
    count = max(LEAST, int(np.ceil(GRID * (end - start) / total)))
    share = np.append(np.arange(count) / count, 1.0 - EDGE)
    found: Array = start + (end - start) * share
    return found


def _excess(found: TimeScaling, velocity: Array, acceleration: Array) -> float:
    """The factor (1 or more) by which the time must be stretched for the limits to hold."""
    share = np.linspace(0.0, 1.0, CHECKED)
    inside = found.positions[:-1, None] + share * np.diff(found.positions)[:, None]
    square = found.speeds[:-1, None] ** 2 + share * np.diff(found.speeds**2)[:, None]
    middle = inside[:, CHECKED // 2]
    piece = np.clip(np.searchsorted(found.path.breaks, middle, side="right") - 1, 0, len(found.path.pieces) - 1)
    slope, bend = (found.path.at(inside, order, piece[:, None]) for order in (1, 2))
    rate = np.abs(slope) * np.sqrt(square)[..., None] / velocity
    push = np.abs(bend * square[..., None] + slope * found.accelerations[:, None, None]) / acceleration
    fastest = max(float(rate.max()), _peak(found, inside, rate.argmax(axis=1), piece, velocity))
    return max(1.0, fastest, float(np.sqrt(push.max()))) * (1.0 + 1e-12)


def _peak(found: TimeScaling, inside: Array, where: Array, piece: Array, velocity: Array) -> float:
    """The largest share of the velocity limits near the largest samples ``where`` (p, n), between them.

    q'^2 s_t^2 has its maximum where 2 q'' s_t^2 + q' 2 s_tt = 0; with q'' and s_tt constant (parabolas) that is linear
    in s, and one step gets there. For higher degrees two steps come near.
    """
    n, first, last = found.path.n, found.positions[:-1, None], found.positions[1:, None]
    joints, u = np.arange(n), 2.0 * found.accelerations[:, None]
    s = np.take_along_axis(inside, where, axis=1)
    for _ in range(2):
        slope, bend = (found.path.at(s, order, piece[:, None])[:, joints, joints] for order in (1, 2))
        square = found.speeds[:-1, None] ** 2 + u * (s - first)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = -(2.0 * bend * square + slope * u) / (3.0 * bend * u)
        s = np.clip(s + np.where(np.isfinite(step), step, 0.0), first, last)
    square = np.maximum(found.speeds[:-1, None] ** 2 + u * (s - first), 0.0)
    slope = found.path.at(s, 1, piece[:, None])[:, joints, joints]
    return float((np.abs(slope) * np.sqrt(square) / velocity).max())


def _passing(grid: Array, speeds: Array, times: Array, marks: Array) -> Array:
    """When the marks are passed: within a grid interval s_t^2 is linear in s."""
    k = np.clip(np.searchsorted(grid, marks, side="right") - 1, 0, len(grid) - 2)
    gone = marks - grid[k]
    square = speeds[k] ** 2 + gone * np.diff(speeds**2)[k] / np.diff(grid)[k]
    both = speeds[k] + np.sqrt(np.maximum(square, 0.0))
    found: Array = times[k] + np.where(both > 0.0, 2.0 * gone / np.where(both > 0.0, both, 1.0), 0.0)
    return found


def _adapter(path: JointPath, total: float, size: float) -> Any:
    """The path as TOPP-RA wants it, over s / total from 0 to 1 and with joint values in units of ``size``."""
    from toppra.interpolator import AbstractGeometricPath  # type: ignore[import-untyped,unused-ignore]

    class Adapter(AbstractGeometricPath):  # type: ignore[misc]
        """Values and derivatives of a joint path."""

        dof = path.n
        path_interval = np.array([0.0, 1.0])

        def __call__(self, path_positions: Any, order: int = 0) -> Array:
            """Q or its derivative."""
            s = path.breaks[0] + total * np.asarray(path_positions, float)
            return path.at(s, order) * (total**order / size)

    return Adapter()
