"""A path for the tip: a curve, an orientation along it, and a time law.

A curve (:mod:`.curves`), how the tip is oriented on it (:mod:`.turning`) and when it is where (:mod:`.time_laws`) make
a :class:`TaskPath`. It knows nothing of arms; a posture's own orientation comes in by :meth:`TaskPath.holding`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from chainrule.errors import InputError, shown
from chainrule.inputs import real_array
from chainrule.paths import Path, real_number
from chainrule.readers.parts import FULL_TURN
from chainrule.redundancy import curves
from chainrule.redundancy.curves import SpaceCurve
from chainrule.redundancy.time_laws import TimeLaw, timed
from chainrule.redundancy.turning import Between, Turning, rotations, turning

Array = NDArray[Any]
Pace = Literal["arc length", "parameter"]

#: Times may lie outside the path by this share of its duration, by rounding.
ROUNDING = 1e-9


class Target(NamedTuple):
    """Where the tip is to be at k times, and how fast.

    Attributes:
        held: poses (k, 4, 4), positions (k, 3), or in the plane (k, 2) x, y, (k, 2) x, alpha, or (k, 3) x, y, alpha.
        velocity: (k, m) its rate: linear and angular velocity (v; omega) of a pose.
    """

    held: Array
    velocity: Array


@dataclass(frozen=True)
class TaskPath:
    """A path for the tip, in space or in the plane.

    Made by :meth:`line`, :meth:`arc`, :meth:`circle`, :meth:`ellipse`, :meth:`polyline`, :meth:`spline`,
    :meth:`poses`, :meth:`along` and :meth:`samples`. All take a time law: ``duration`` (s) or ``speed`` (m/s) for a
    constant speed; ``duration`` and ``ramp`` (s), or ``speed`` and ``acceleration`` (m/s^2), from rest to rest; or
    ``law`` (samples have their own). All but poses and samples, which have theirs, take ``orientation``: a rotation
    (3, 3) or quaternion (w, x, y, z) that is held; two or more of them, passed at even values of the curve's parameter
    (slerp between two); "tangent" (x along a path in a plane, z its normal); or None: that of the start posture. In the
    plane an orientation is an angle in rad.

    Attributes:
        curve: where it goes.
        law: when.
        turning: how the tip is oriented; None for the orientation of the start posture.
        pace: what the law counts: "arc length", or the curve's own "parameter" (the same for lines, arcs and circles).
        made_of: plain values it was made from.

    Example:
        >>> path = TaskPath.arc((0.0, 0.05, -0.25), 0.25, end=np.pi, y=(0.0, 0.0, 1.0), duration=2.0)
        >>> held, velocity = path.sample([0.0, 1.0], "position")
        >>> held.round(3)
        array([[ 0.25,  0.05, -0.25],
               [ 0.  ,  0.05,  0.  ]])
        >>> bool(abs(np.linalg.norm(velocity[1]) - 0.25 * np.pi / 2.0) < 1e-15)
        True
    """

    curve: SpaceCurve
    law: TimeLaw
    turning: Turning | None = None
    pace: Pace = "arc length"
    made_of: Mapping[str, Any] = field(default_factory=dict, repr=False)

    # ---- made from geometry --------------------------------------------------------------------------------------

    @classmethod
    def line(cls, start: Any, end: Any, **options: Any) -> TaskPath:
        """The straight line between two points (3,) or (2,), m.

        Raises:
            InputError: one point twice, or options that are not accepted (so all ways to make a path).

        Example:
            >>> TaskPath.line((0.0, 0.0), (0.3, 0.4), speed=0.25).duration
            2.0
        """
        return cls._made(curves.line(start, end), {"kind": "line", "start": start, "end": end}, options)

    @classmethod
    def arc(
        cls,
        centre: Any,
        radius: float,
        *,
        start: float = 0.0,
        end: float = np.pi,
        x: Any = None,
        y: Any = None,
        **options: Any,
    ) -> TaskPath:
        """An arc of a circle: centre + radius (cos(theta) x + sin(theta) y), theta from ``start`` to ``end`` (rad).

        Args:
            centre: (3,) or (2,), m.
            radius: m.
            start: rad.
            end: rad; smaller than ``start`` for the other way round. Up to a full turn from it, or any number of
                quarter turns; other angles were meant in degrees, and are refused.
            x: (3,) direction of theta = 0; the x axis when absent.
            y: (3,) direction of theta = pi / 2, square to ``x``; the y axis when absent.
            options: time law and orientation.

        Example:
            >>> TaskPath.arc((0.5, 0.0, 0.4), 0.1, end=180, duration=1.0)
            Traceback (most recent call last):
            ...
            chainrule.errors.InputError: start and end: 0 to 180 rad are 28.6 turns; rad are accepted, up to a full \
turn or any number of quarter turns, and degrees in a TOML file that says angles = "deg"
        """
        return cls._ring("arc", centre, (radius, radius), start, end, x, y, options)

    @classmethod
    def circle(
        cls, centre: Any, radius: float, *, start: float = 0.0, x: Any = None, y: Any = None, **options: Any
    ) -> TaskPath:
        """A whole circle, from the angle ``start`` (rad) once round; see :meth:`arc`.

        Example:
            >>> TaskPath.circle((0.5, 0.0, 0.4), 0.1, y=(0.0, 0.0, 1.0), duration=4.0).closed
            True
        """
        return cls._ring("circle", centre, (radius, radius), start, start + 2.0 * np.pi, x, y, options)

    @classmethod
    def ellipse(
        cls,
        centre: Any,
        semi_axes: Any,
        *,
        start: float = 0.0,
        end: float = 2.0 * np.pi,
        x: Any = None,
        y: Any = None,
        **options: Any,
    ) -> TaskPath:
        """centre + a cos(theta) x + b sin(theta) y with ``semi_axes`` (a, b), m; see :meth:`arc`.

        With ``pace="parameter"`` theta grows evenly, else the arc length.
        """
        pair = curves.vector(semi_axes, "semi_axes", 2)
        return cls._ring("ellipse", centre, (float(pair[0]), float(pair[1])), start, end, x, y, options)

    @classmethod
    def _ring(
        cls,
        kind: str,
        centre: Any,
        semi_axes: tuple[float, float],
        start: float,
        end: float,
        x: Any,
        y: Any,
        options: dict[str, Any],
    ) -> TaskPath:
        middle = curves.vector(centre, "centre")
        first, second = curves.axes(x, y, middle.size)
        name = "radius" if kind != "ellipse" else "semi_axes"
        a, b = (real_number(value, name) for value in semi_axes)
        if not min(a, b) > 0.0:
            raise InputError(f"{name}: {min(a, b):g}; a positive length is accepted")
        begin, stop = real_number(start, "start"), real_number(end, "end")
        turns = (stop - begin) / (2.0 * np.pi)
        if abs(stop - begin) > FULL_TURN and abs(4.0 * turns - round(4.0 * turns)) > ROUNDING * abs(turns):
            raise InputError(
                f"start and end: {begin:g} to {stop:g} rad are {turns:.3g} turns; rad are accepted, up to a full turn "
                'or any number of quarter turns, and degrees in a TOML file that says angles = "deg"'
            )
        size = {name: [a, b]} if kind == "ellipse" else {name: a}
        made_of = {"kind": kind, "centre": middle, **size, "start": begin, "end": stop, "x": first, "y": second}
        return cls._made(curves.Conic(middle, a * first, b * second, begin, stop), made_of, options)

    @classmethod
    def polyline(cls, points: Any, deviation: float, **options: Any) -> TaskPath:
        """Straight stretches between points (k, d) with rounded corners.

        Each corner becomes a parabola that leaves the polyline by at most ``deviation`` (m) in any coordinate.

        Example:
            >>> path = TaskPath.polyline([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], 0.05, duration=2.0)
            >>> path.sample([1.0]).held.round(6)
            array([[0.95, 0.05]])
        """
        return cls._made(
            curves.corners(points, deviation), {"kind": "polyline", "points": points, "deviation": deviation}, options
        )

    @classmethod
    def spline(cls, points: Any, *, closed: bool = False, **options: Any) -> TaskPath:
        """The smooth curve through three or more points (k, d), m; closed as well where the last is the first."""
        return cls._made(
            curves.through(points, closed), {"kind": "spline", "points": points, "closed": closed}, options
        )

    @classmethod
    def along(cls, path: Path, *, origin: Any = None, x: Any = None, y: Any = None, **options: Any) -> TaskPath:
        """A path of :mod:`chainrule.paths` by its arc length, in the plane or placed in space.

        Args:
            path: such as :class:`chainrule.Ellipse`, or a user's own :class:`chainrule.Curve`.
            origin: (3,) m, where its origin lies in space.
            x: (3,) where its x axis points.
            y: (3,) where its y axis points. The path stays in the plane where all three are absent.
            options: time law and orientation.
        """
        given = {name: value for name, value in (("origin", origin), ("x", x), ("y", y)) if value is not None}
        if isinstance(path, Path):
            given |= {"kind": "along", "path": path.to_dict()}
        return cls._made(curves.Placed(path, origin, x, y), given, options)

    @classmethod
    def poses(cls, points: Any, orientations: Any = None, **options: Any) -> TaskPath:
        """The smooth path through poses, at a parameter that grows with the way from pose to pose.

        The way is the distance between neighbours over the sum of all and the angle between them over the sum of all,
        as two legs of a right triangle: a pose may differ from its neighbour in either.

        Args:
            points: (k, 3) or (k, 2), m.
            orientations: (k, 3, 3), quaternions (k, 4) with w first, a SciPy ``Rotation``, or angles (k,) in the plane;
                that of the start posture when absent.
            options: time law; by ``pace`` the parameter's.
        """
        given = curves.listed(points, 2)
        turned = _orientations(orientations, given)
        steps = _ways(np.linalg.norm(np.diff(given, axis=0), axis=1)) ** 2
        if turned is not None:
            steps = steps + _ways(_angles(turned)) ** 2
        steps = np.sqrt(steps)
        curves.apart(steps)
        u = np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()
        return cls._passing("poses", given, turned, u, {"pace": "parameter", **options})

    @classmethod
    def samples(cls, t: Any, points: Any, orientations: Any = None) -> TaskPath:
        """A user's own samples: poses as in :meth:`poses`, at times t (k,) rising from 0 (s), and smooth between."""
        times, given = real_array(t, "t"), curves.listed(points, 2)
        if times.shape != given.shape[:1] or times[0] != 0.0 or not (np.diff(times) > 0.0).all():
            raise InputError(f"t: shape {times.shape}; {len(given)} times that rise from 0 are accepted")
        turned = _orientations(orientations, given)
        end = float(times[-1])
        return cls._passing("samples", given, turned, times / end, {"pace": "parameter", "duration": end})

    @classmethod
    def _passing(cls, kind: str, points: Array, turned: Array | None, u: Array, options: dict[str, Any]) -> TaskPath:
        if turned is not None:
            if "orientation" in options:
                raise InputError("orientation: the poses have their own")
            options = {**options, "orientation": Between(u, turned)}
        made_of = {"kind": kind, "points": points, "parameters": u}
        if turned is not None:
            made_of["orientations"] = turned
        return cls._made(curves.Interpolated(points, u), made_of, options)

    @classmethod
    def _made(cls, curve: SpaceCurve, made_of: Mapping[str, Any], options: dict[str, Any]) -> TaskPath:
        known = ("duration", "speed", "acceleration", "ramp", "law")
        unknown = [name for name in options if name not in (*known, "orientation", "pace")]
        if unknown:
            accepted = ", ".join((*known, "orientation", "pace"))
            raise InputError(f"a task path: there is no option {shown(unknown[0])}; {accepted} are accepted")
        pace = options.get("pace", "arc length")
        if pace not in ("arc length", "parameter"):
            raise InputError(f"pace: {shown(pace)}; 'arc length' or 'parameter' is accepted")
        measured = pace == "arc length" or options.keys() & {"speed", "acceleration"}
        law = timed(curve.length if measured else 0.0, **{name: options[name] for name in known if name in options})
        if pace == "arc length" and not curve.length > 0.0:
            raise InputError("pace: the path has no length; 'parameter' is accepted")
        orientation = options.get("orientation")
        found = turning(orientation, curve.dimension)
        if orientation is not None and not isinstance(orientation, Turning):
            made_of = {**made_of, "orientation": orientation}
        return cls(curve, law, found, pace, made_of)

    # ---- changed -------------------------------------------------------------------------------------------------

    def holding(self, orientation: Any) -> TaskPath:
        """A copy with an orientation, as all ways to make a path take it."""
        return replace(self, turning=turning(orientation, self.dimension))

    def timed(self, **options: Any) -> TaskPath:
        """A copy with another time law, as all ways to make a path take it; along the arc length where it has a speed.

        Example:
            >>> TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=2.0).timed(speed=1.0, acceleration=2.0).duration
            1.5
        """
        return replace(self, law=timed(self.curve.length, **options))

    # ---- what it is ----------------------------------------------------------------------------------------------

    @property
    def dimension(self) -> int:
        """3 in space, 2 in the plane."""
        return self.curve.dimension

    @property
    def duration(self) -> float:
        """How long it takes, s."""
        return self.law.duration

    @property
    def length(self) -> float:
        """Arc length, m."""
        return self.curve.length

    @cached_property
    def closed(self) -> bool:
        """Whether it ends where it begins, and in the same orientation."""
        if not self.curve.closed or self.turning is None:
            return self.curve.closed
        ends, _ = self.turning.at(self.curve, np.array([0.0, 1.0]))
        if self.dimension == 2:
            return bool(abs(np.remainder(ends[1] - ends[0] + np.pi, 2.0 * np.pi) - np.pi) < ROUNDING)
        return bool(np.abs(ends[1] - ends[0]).max() < ROUNDING)

    def sample(self, t: Any, task: str | None = None) -> Target:
        """Targets and their velocities at times t (k,) in s, exact but for rounding.

        Args:
            t: from 0 to the duration.
            task: "pose", "position", or in the plane "x_alpha"; "pose" when absent, if the orientation is known.

        Raises:
            InputError: times outside the path; a task without a meaning for it; an orientation that is the start
                posture's, which :meth:`holding` says.
        """
        task = self._task(task)
        times = real_array(t, "t")
        margin = ROUNDING * self.duration
        if times.ndim != 1 or (times.size and (times.min() < -margin or times.max() > self.duration + margin)):
            raise InputError(f"t: times (k,) from 0 to {self.duration:g} s are accepted")
        share, rate = self.law.at(np.clip(times, 0.0, self.duration))
        u, stretch = (share, np.ones_like(share)) if self.pace == "parameter" else self.curve.parameter(share)
        rate = rate * stretch
        point, slope, _ = self.curve.at(u)
        velocity = slope * rate[:, None]
        if task == "position":
            return Target(point, velocity)
        assert self.turning is not None
        turned, spin = self.turning.at(self.curve, u)
        if self.dimension == 2:
            rows = slice(0, 1 if task == "x_alpha" else 2)
            return Target(np.column_stack([point[:, rows], turned]), np.column_stack([velocity[:, rows], spin * rate]))
        held = np.zeros((len(times), 4, 4))
        held[:, :3, :3], held[:, :3, 3], held[:, 3, 3] = turned, point, 1.0
        return Target(held, np.concatenate([velocity, spin * rate[:, None]], axis=1))

    def _task(self, task: str | None) -> str:
        if task is None:
            task = "position" if self.turning is None else "pose"
        accepted = ("position", "pose") if self.dimension == 3 else ("position", "pose", "x_alpha")
        if task not in accepted:
            raise InputError(f"task: {shown(task)}; {', '.join(accepted)} are accepted for this path")
        if task != "position" and self.turning is None:
            raise InputError(f"the path says no orientation, and the task '{task}' holds one; holding(...) says it")
        return task

    def to_dict(self) -> dict[str, Any]:
        """Plain values: what it was made from, its time law and its length."""
        plain = {
            name: value.tolist() if isinstance(value, np.ndarray) else value for name, value in self.made_of.items()
        }
        return {**plain, "length": self.length, "pace": self.pace, "time": self.law.to_dict()}


def _orientations(given: Any, points: Array) -> Array | None:
    """Orientations of poses: (k, 3, 3), or unwrapped angles (k,)."""
    if given is None:
        return None
    found = np.unwrap(real_array(given, "orientations")) if points.shape[1] == 2 else rotations(given)
    wanted = (len(points),) if points.shape[1] == 2 else (len(points), 3, 3)
    if found.shape != wanted:
        raise InputError(
            f"orientations: {found.shape[0] if found.ndim else 1} for {len(points)} points; one each is accepted"
        )
    return found


def _angles(turned: Array) -> Array:
    """The angles (k - 1,) between neighbours."""
    if turned.ndim == 1:
        return np.abs(np.diff(turned))
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_matrix(np.swapaxes(turned[:-1], 1, 2) @ turned[1:]).magnitude())


def _ways(steps: Array) -> Array:
    """Steps over their sum; nothing where they are all nothing."""
    return steps / steps.sum() if steps.sum() > 0.0 else steps
