"""All self-motion curves of a 7R arm whose first or last three axes meet: one joint swept, all postures of the rest.

Seen from its far end if need be, the last three axes meet in a point that joints 2, 3 and 4 place when joint 1 is held:
a 3R arm with at most four postures (:mod:`chainrule.derive.self_motion_sweep`), and two ways of taking the orientation.

*Events* are the angles of joint 1 at which two postures merge: the real zeros of a trigonometric polynomial, the
discriminant of the quartic (degree 12), or where axes 2 and 3 meet or are parallel the discriminant of a quadratic
(degree 2) and a resultant (degree 8). Between events postures are constant in number and do not merge, so joint 1 has
no extremum on the curves there. A closed curve on which joint 1 does not turn all the way round has a least value of
it, an event, and leaves it into the next interval between events, which it has to cross. So **every curve passes the
middle of an interval**: the curves through all postures there are all the curves. Superfluous events do no harm.
Events are computed in doubles; that none was missed is checked on 48 more sections, and on the extrema of all curves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.cuspidality.normal_form import Regional, evaluator
from chainrule.description import Description, Serial, Transform
from chainrule.self_motions.held import Held
from chainrule.self_motions.spherical import Chain, Structure, orientations, turn

Array = NDArray[Any]

#: Values of the swept joint at which event polynomials are sampled: more than twice any degree.
SAMPLED = 64
#: Zeros this near the unit circle count as real, of event polynomials (too many do no harm) and of postures.
EVENT, REAL = 1e-4, 1e-5
#: At events roots this near count as real, and a posture whose H is below this share of the largest one as singular.
LOOSE, LOST = 1e-4, 1e-4
#: Events nearer to one another than this, rad, leave the count unproved.
DISTINCT = 1e-7
#: A length below this share of the arm's size is none.
NONE = 1e-11


@dataclass(frozen=True)
class Plan:
    """What of a sweep does not depend on the pose.

    Attributes:
        chain: the arm, seen from where the swept joint is first.
        regional: the 3R arm of joints 2, 3 and 4, its tip the point in which axes 5, 6 and 7 meet.
        to_base: (4, 4) from the base frame to the one before joint 1's turn.
        in_tip: (4,) that point in the tip's frame, m, and 1.
        right: whether axes 5, 6 and 7 stand at right angles.
    """

    chain: Chain
    regional: Regional
    to_base: Array
    in_tip: Array
    right: bool

    @classmethod
    def of(cls, arm: Arm) -> Plan | None:
        """The plan of a 7R arm, once for each; None where neither the first nor the last three axes meet."""
        if arm not in _PLANS:
            _PLANS[arm] = cls._made(arm)
        return _PLANS[arm]

    @classmethod
    def _made(cls, arm: Arm) -> Plan | None:
        structure = Structure.of(arm)
        chain, meeting = structure.chain, structure.meeting[4]
        if meeting is None:
            chain = chain.reversed()
            meeting = chain.meeting(4)
        if meeting is None:
            return None
        placements = chain.placements
        tip = placements[4, :3, :3] @ meeting + placements[4, :3, 3]
        last = placements[5] @ placements[6] @ chain.tool  # at q6 = q7 = 0: axes 6 and 7 pass the point anyway
        in_tip = np.linalg.inv(last) @ np.append(meeting, 1.0)
        regional = Regional.of(_three(arm, placements[1:4], tip))
        parameters = [0.0 if abs(x) < NONE * chain.size and k >= 4 else x for k, x in enumerate(regional.parameters)]
        regional = replace(regional, parameters=tuple(parameters))
        return cls(chain, regional, np.linalg.inv(placements[0]), in_tip, chain.right(4))


_PLANS: WeakKeyDictionary[Arm, Plan | None] = WeakKeyDictionary()


@dataclass(frozen=True)
class Sweep:
    """A 7R arm at a pose, its swept joint first and its spherical joint last.

    Attributes:
        held: the arm and its task.
        chain: the arm, seen from where the swept joint is first.
        regional: the 3R arm of joints 2, 3 and 4, its tip the point in which axes 5, 6 and 7 meet.
        target: the pose of the arm's tip.
        point: (3,) that point before joint 1's turn, m.
        right: whether the spherical joint takes every orientation, so that only the 3R arm has events.
    """

    held: Held
    chain: Chain
    regional: Regional
    target: Array
    point: Array
    right: bool

    @classmethod
    def of(cls, held: Held, target: Array) -> Sweep | None:
        """The sweep of an arm at a pose; None where neither the first nor the last three axes meet."""
        if held.arm.kinds != "RRRRRRR" or held.task != "pose":
            return None
        plan = Plan.of(held.arm)
        if plan is None:
            return None
        base = plan.to_base @ plan.chain.pose(target) @ plan.in_tip
        return cls(held, plan.chain, plan.regional, target, base[:3], plan.right)

    @property
    def swept(self) -> int:
        """Index of the swept joint in the arm."""
        return 6 if self.chain.backwards else 0

    @property
    def special(self) -> str:
        """Which of the three cases the 3R arm is: "meeting", "parallel", "general", or "unfit" for this method."""
        _, sa2, _, _, d2, _, d4, _, _ = self.regional.parameters
        if (sa2 == 0.0 and d2 == 0.0) or d4 == 0.0:
            return "unfit"
        return "parallel" if sa2 == 0.0 else "meeting" if d2 == 0.0 else "general"

    # ---- events ------------------------------------------------------------------------------------------------

    def points(self, x: Array) -> tuple[Array, Array]:
        """The point (k, 3) in the 3R arm's normal form at values (k,) of joint 1, and its target (k, 2)."""
        y = self.regional.point_to_normal(np.swapaxes(turn(x), -1, -2) @ self.point)
        return y, np.stack([y[:, 0] ** 2 + y[:, 1] ** 2, y[:, 2]], axis=-1)

    def polynomials(self, x: Array) -> tuple[Array, ...]:
        """Coefficients in tan(theta3/2) at values (k,) of joint 1: of what holds theta3, and of the other condition."""
        values, (_, aim) = self.regional.values, self.points(x)
        if self.special == "general":
            return (self.regional.quartic(aim),)
        u, v, w = evaluator("sweep_conditions")(values, aim)
        sa2, d2 = values[1], values[4]
        if self.special == "meeting":
            return u, sa2**2 * w - _squared(v)
        return v, 4.0 * d2**2 * w - _squared(u)

    def events(self) -> Array:
        """Every value of joint 1 in [0, 2 pi), rising, at which two postures merge; perhaps more."""
        x = np.arange(SAMPLED) * (2.0 * math.pi / SAMPLED)
        first, *other = self.polynomials(x)
        found = [_zeros(_discriminant(first), 2 if other else 12)]
        if other:
            found.append(_zeros(_resultant(first, other[0]), 8))
        return np.sort(np.concatenate(found))

    # ---- postures ----------------------------------------------------------------------------------------------

    def postures(self, x: Array) -> tuple[Array, Array]:
        """All configurations (m, 7) of the arm at values (k,) of the swept joint, and which value each belongs to."""
        q, rows = self.candidates(x)
        exact = self.held.corrected(q, self.target, 2)
        error, _, _ = self.held.evaluate(exact, self.target)
        good = np.abs(error).max(axis=1, initial=0.0) < 1e-11
        good &= np.abs(exact - q).max(axis=1, initial=0.0) < 1e-3
        return exact[good], rows[good]

    def singular(self, events: Array, scale: float) -> Array:
        """(m, 7): postures at events that are singular: H below :data:`LOST` times ``scale``.

        At a regular pose the curves only turn back at events. Where a posture there is singular the set is more than
        the curves: an isolated point, or motions of the other joints alone, which no section shows. A double event,
        which rounding takes apart, is looked at in its middle too.
        """
        close = np.flatnonzero(np.diff(events, append=events[:1] + 2.0 * math.pi) < LOOSE)
        middles = events[close] + 0.5 * np.mod(np.roll(events, -1)[close] - events[close], 2.0 * math.pi)
        q, _ = self.candidates(np.concatenate([events, middles]), LOOSE)
        if not len(q):
            return q
        error = np.abs(self.held.evaluate(q, self.target)[0]).max(axis=1)
        h = self.held.arm.manipulability(q, task=self.held.task)
        return np.asarray(q[(error < 1e-4) & (h < LOST * scale)])

    def candidates(self, x: Array, near: float = REAL) -> tuple[Array, Array]:
        """As :meth:`postures`, uncorrected; roots this ``near`` to being real are taken for real."""
        first, *other = self.polynomials(x)
        rows, theta = real_angles(first, near)
        (y, aim), values = self.points(x), self.regional.values
        sa2, d2 = values[1], values[4]
        elbow = np.stack([np.cos(theta), np.sin(theta)], axis=-1)
        (u, v), (f1, f2) = (np.moveaxis(part, -1, 0) for part in evaluator("sweep_elbow")(values, elbow, aim[rows]))
        if other:
            known = v / sa2 if self.special == "meeting" else u / (2.0 * d2)
            square = f1**2 + f2**2 - known**2
            real = square >= (0.0 if near == REAL else -near * self.chain.size**2)
            square = np.maximum(square, 0.0)
            rows, elbow, theta, known, f1, f2 = (
                np.repeat(p[real], 2, axis=0) for p in (rows, elbow, theta, known, f1, f2)
            )
            free = np.repeat(np.sqrt(square[real]), 2) * np.tile([1.0, -1.0], int(real.sum()))
            a, b = (free, known) if self.special == "meeting" else (known, free)
        else:
            a, b = u / (2.0 * d2), v / sa2
        at = evaluator("sweep_base")(values, elbow, np.stack([a, b], axis=-1))
        angles = np.stack(
            [
                np.arctan2(y[rows, 1], y[rows, 0]) - np.arctan2(at[:, 1], at[:, 0]),
                np.arctan2(b, a) - np.arctan2(f2, f1),
                theta,
            ],
            axis=-1,
        )
        inner = np.concatenate([x[rows, np.newaxis], self.regional.from_normal(angles)], axis=1)
        placed = np.broadcast_to(np.eye(3), (len(inner), 3, 3))
        for i in range(4):
            placed = placed @ self.chain.placements[i, :3, :3] @ turn(inner[:, i])
        rotation = self.chain.pose(self.target)[:3, :3] @ self.chain.tool[:3, :3].T
        wanted = np.swapaxes(placed @ self.chain.placements[4, :3, :3], -1, -2) @ rotation
        outer, real = orientations(self.chain.placements[5, :3, :3], self.chain.placements[6, :3, :3], wanted)
        q = np.concatenate([np.repeat(inner, 2, axis=0), outer.reshape(-1, 3)], axis=1)[real.ravel()]
        rows = np.repeat(rows, 2)[real.ravel()]
        return self.chain.joints(q), rows


def _three(arm: Arm, placements: Array, tip: Array) -> Description:
    """The 3R arm of three joints."""
    fixed = tuple(
        Transform(tuple(map(tuple, p[:3, :3].tolist())), tuple(p[:3, 3].tolist()))  # type: ignore[arg-type]
        for p in placements
    )
    tool = Transform.shift(*(float(t) for t in tip))
    return Description(f"{arm.name[:100]}-swept", arm.description.joints[:3], Serial(fixed, tool))


# ---- polynomials -------------------------------------------------------------------------------------------------


def _squared(p: Array) -> Array:
    """The squares (k, 5) of quadratics (k, 3)."""
    a, b, c = p.T
    return np.stack([a * a, 2 * a * b, b * b + 2 * a * c, 2 * b * c, c * c], axis=-1)


def _discriminant(p: Array) -> Array:
    """(k,): of quadratics (k, 3) or quartics (k, 5), up to a constant factor; 4 I^3 - J^2 for the latter."""
    if p.shape[1] == 3:
        return np.asarray(p[:, 1] ** 2 - 4.0 * p[:, 0] * p[:, 2])
    p = p / np.abs(p).max()
    e, d, c, b, a = p.T
    i = 12 * a * e - 3 * b * d + c**2
    j = 72 * a * c * e + 9 * b * c * d - 27 * a * d**2 - 27 * e * b**2 - 2 * c**3
    return np.asarray(4.0 * i**3 - j**2)


def _resultant(p: Array, g: Array) -> Array:
    """(k,): of quadratics (k, 3) and quartics (k, 5), by Sylvester's matrix."""
    p, g = p / max(np.abs(p).max(), 1e-300), g / max(np.abs(g).max(), 1e-300)
    matrix = np.zeros((len(p), 6, 6))
    for i in range(4):
        matrix[:, i, i : i + 3] = p
    for i in range(2):
        matrix[:, 4 + i, i : i + 5] = g
    return np.asarray(np.linalg.det(matrix))


def _zeros(samples: Array, degree: int) -> Array:
    """Angles in [0, 2 pi) of a trigonometric polynomial's zeros near the unit circle, from equally spaced samples."""
    spectrum = np.fft.fft(samples) / len(samples)
    coefficients = np.concatenate([spectrum[-degree:], spectrum[: degree + 1]])[::-1]  # highest power of exp(i x) first
    size = np.abs(coefficients).max()
    if size == 0.0:
        return np.zeros(0)
    kept = np.flatnonzero(np.abs(coefficients) > 1e-15 * size)
    roots = np.roots(coefficients[kept[0] : kept[-1] + 1])
    near = np.abs(np.abs(roots) - 1.0) < EVENT
    return np.asarray(np.mod(np.angle(roots[near]), 2.0 * math.pi))


def real_angles(p: Array, near: float = REAL) -> tuple[Array, Array]:
    """Rows (m,) and theta (m,) with p(tan(theta/2)) = 0, half a turn included, of polynomials (k, 3) or (k, 5).

    The polynomial in the half tangent is one in exp(i theta) without any value at infinity.
    """
    degree = p.shape[1] - 1
    half = np.arange(degree + 2) * (math.pi / (degree + 2))
    powers = np.stack([np.sin(half) ** k * np.cos(half) ** (degree - k) for k in range(degree + 1)])
    spectrum = np.fft.fft(p @ powers, axis=1) / (degree + 2)
    reach = degree // 2
    c = np.concatenate([spectrum[:, -reach:], spectrum[:, : reach + 1]], axis=1)  # exp(-i reach theta) first
    size = np.abs(c).max(axis=1, initial=0.0)
    lead = np.where(np.abs(c[:, -1]) > 1e-13 * size, c[:, -1], 1e-13 * size + 1e-300)
    companion = np.zeros((len(p), degree, degree), complex)
    companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1.0
    companion[:, :, -1] = -c[:, :-1] / lead[:, np.newaxis]
    roots = np.linalg.eigvals(companion)
    rows, which = np.nonzero(np.abs(np.abs(roots) - 1.0) < near)
    return rows, np.angle(roots[rows, which])
