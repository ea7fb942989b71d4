"""The largest manipulability of an arm with a proof: which arms it can be had for, and what was proved.

H^2 as a sum of waves (:mod:`chainrule.waves`), its largest value by branch and bound
(:mod:`chainrule.branch_and_bound`), all from the generated minors in ball arithmetic (:mod:`chainrule.balls`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.balls import PRECISION, Minors, exact, minors_on_balls, nearest, value_on_balls
from chainrule.branch_and_bound import EQUAL, HALF_TURN, Domain, Hunt, Proof, prove
from chainrule.description import Orthogonal3R, Planar
from chainrule.search import box
from chainrule.waves import Square, Waves, spectra, square, unit_of, waves

Array = NDArray[Any]

#: Work that is done when no budget is given: boxes times waves, and boxes at most.
WORK, MOST_BOXES = 12_000_000, 200_000
#: More slides than this are not tried at all combinations of their ends.
MOST_SLIDES = 6


@dataclass(frozen=True)
class Certificate:
    """What was found and proved.

    Attributes:
        square: H^2 at the first posture, a ball.
        postures: (k, n) where H is largest, all equal to a relative 1e-12.
        bound: a ball that H^2 exceeds nowhere.
        boxes: how many boxes were examined.
        finished: whether the budget sufficed.
        complete: whether ``postures`` are all there are (joints that H does not depend on aside).
        moving: the revolute joints over which the boxes were cut.
        slides: the prismatic joints of which only the ends of the range were tried.
        waves: how many waves H^2 is the sum of (the most, where there are several sums).
        lost: how many of the coordinates turned out not to matter.
    """

    square: Any
    postures: Array
    bound: Any
    boxes: int
    finished: bool
    complete: bool
    moving: tuple[int, ...]
    slides: tuple[int, ...]
    waves: int
    lost: int


@dataclass(frozen=True)
class Unbounded:
    """H grows without end along a prismatic joint without limits.

    Attributes:
        joint: from 0.
    """

    joint: int


def used_joints(minors: Minors, n: int) -> tuple[int, ...]:
    """The joints that the code of the minors reads, seen from a nan that spreads."""
    from flint import arb

    found = []
    for joint in range(n):
        q = exact(np.full((1, n), 0.5))
        q[0, joint] = arb("nan")
        if not all(value.is_finite() for value in minors(q).ravel()):
            found.append(joint)
    return tuple(found)


def certify(
    arm: Arm, task: str, budget: int | None = None, progress: Callable[[str], None] = lambda line: None
) -> Certificate | Unbounded | str:
    """The certificate, or in words why there is none.

    Args:
        arm: the arm.
        task: one of its :attr:`~chainrule.Arm.full_rank_tasks`.
        budget: how many boxes may be examined.
        progress: called with a line now and then.
    """
    from flint import ctx

    with ctx.workprec(PRECISION):
        minors = minors_on_balls(arm, task)
        if minors is None:
            return "H of this many joints comes from a factorisation, not from minors"
        held = arm.limits.position[:, 0] == arm.limits.position[:, 1]  # what cannot move is a number like any other
        used = tuple(j for j in used_joints(minors, arm.n) if not held[j])
        planar = "x_alpha" in arm.tasks
        turning = tuple(j for j in used if arm.kinds[j] == "R")
        slides = tuple(j for j in used if arm.kinds[j] == "P")
        if slides and not planar:
            return "the proof does not cover prismatic joints in space"
        posture = exact(box(arm).mean(axis=1))
        squares = _squares(arm, minors, posture, turning, slides, 1 if planar else 2)
        if isinstance(squares, (str, Unbounded)):
            return squares
        domain = _domain(arm, turning)
        scale = unit_of([part for _, part in squares])
        headings = planar and bool(domain.free.all())
        farthest = float(max(np.abs(domain.lower).max(initial=0.0), np.abs(domain.upper).max(initial=0.0), 4.0))
        places, hunts = [], []
        for start, part in squares:
            sum_of_waves = waves(part, len(turning), scale, farthest, headings)
            place = _Place(start, turning, sum_of_waves.back)
            places.append(place)
            hunts.append(_hunt(minors, place, sum_of_waves, domain))
        wide = max(1, *(hunt.waves.amplitude.size for hunt in hunts))
        allowed = min(MOST_BOXES, max(100, WORK // wide)) if budget is None else budget
        proof = prove(hunts, allowed, progress)
        return _certificate(arm, minors, places, hunts, proof, turning, slides)


@dataclass(frozen=True)
class _Place:
    """A posture of balls whose joints ``turning`` follow the coordinates: x @ back."""

    start: Array
    turning: tuple[int, ...]
    back: Array

    def posture(self, x: Array) -> Array:
        q = self.start.copy()
        if self.turning:
            q[list(self.turning)] = exact(x) @ exact(self.back) if len(x) else exact(np.zeros(len(self.turning)))
        return q


def _squares(
    arm: Arm, minors: Minors, posture: Array, turning: tuple[int, ...], slides: tuple[int, ...], degree: int
) -> list[tuple[Array, Square]] | Unbounded | str:
    """H^2 at every choice of ends for the slides that matter, with the posture that holds the slides there."""
    too_large = f"{len(turning)} joints that turn make too many waves"
    limits = arm.limits.position
    for joint in slides:
        if not np.isfinite(limits[joint]).all():
            matters = _matters(minors, posture, turning, joint, degree)
            if matters is None:
                return too_large
            if matters:
                return Unbounded(joint)
    ends = [j for j in slides if np.isfinite(limits[j]).all()]
    if len(ends) > MOST_SLIDES:
        return f"{len(ends)} prismatic joints have too many combinations of ends"
    found = []
    for choice in product((1, 0), repeat=len(ends)):
        start = posture.copy()
        for joint, side in zip(ends, choice, strict=True):
            start[joint] = exact(limits[joint, side])[()]
        spectrum = spectra(minors, start, turning, degree)
        part = None if spectrum is None else square(spectrum)
        if part is None:
            return too_large
        found.append((start, part))
    return found


def _matters(minors: Minors, posture: Array, turning: Sequence[int], joint: int, degree: int) -> bool | None:
    """Whether some minor changes with a slide: it is affine in it, so then it grows without end."""
    values = []
    for slide in (0.0, 1.0):
        start = posture.copy()
        start[joint] = exact(slide)[()]
        values.append(spectra(minors, start, turning, degree))
    if values[0] is None or values[1] is None:
        return None
    return any(
        not (one[k] - other[k]).real.contains(0) or not (one[k] - other[k]).imag.contains(0)
        for one, other in zip(*values, strict=True)
        for k in one
    )


def _domain(arm: Arm, turning: tuple[int, ...]) -> Domain:
    """The joint limits of the joints that turn; a joint that can make a whole turn is free."""
    limits = arm.limits.position[list(turning)].reshape(-1, 2)
    free = ~(limits[:, 1] - limits[:, 0] < 2 * HALF_TURN)
    return Domain(np.where(free, -HALF_TURN, limits[:, 0]), np.where(free, HALF_TURN, limits[:, 1]), free)


def _hunt(minors: Minors, place: _Place, found: Waves, domain: Domain) -> Hunt:
    size = found.size
    # Coordinates without waves are the last or first headings, or angles: which of the limits belong to the others?
    kept = [int(np.flatnonzero(row == 1)[0]) for row in found.back]
    part = Domain(domain.lower[kept], domain.upper[kept], domain.free[kept])
    assert len(kept) == size
    return Hunt(found, part, lambda x: value_on_balls(minors, place.posture(x)))


def _certificate(
    arm: Arm,
    minors: Minors,
    places: list[_Place],
    hunts: list[Hunt],
    proof: Proof,
    turning: tuple[int, ...],
    slides: tuple[int, ...],
) -> Certificate:
    peaks = [(place, peak) for place, hunt in zip(places, hunts, strict=True) for peak in hunt.peaks]
    postures = [_within(arm, np.array([nearest(value) for value in place.posture(peak.x)])) for place, peak in peaks]
    if any(peak.around is None for _, peak in peaks):  # a ridge, or nearly: one of its postures and the mirror image
        postures = _with_mirror_image(arm, minors, postures)
    postures.sort(key=lambda q: tuple(np.round(q[list((*turning, *slides))], 6)), reverse=True)
    values = [value_on_balls(minors, exact(q)) for q in postures]
    first = max(range(len(values)), key=lambda k: (values[k].mid() >= max(v.mid() for v in values) * (1 - 1e-14), -k))
    order = [first, *(k for k in range(len(postures)) if k != first)]
    bound = max(proof.bound, max(value.upper() for value in values))
    lost = len(turning) - max(hunt.waves.size for hunt in hunts)
    return Certificate(
        values[first],
        np.array([postures[k] for k in order]),
        bound,
        proof.boxes,
        proof.finished,
        proof.complete,
        turning,
        slides,
        max(len(hunt.waves.frequencies) for hunt in hunts),
        lost,
    )


def _with_mirror_image(arm: Arm, minors: Minors, postures: list[Array]) -> list[Array]:
    """The highest of several postures, and the one with all angles reversed where H is the same there."""
    heights = [value_on_balls(minors, exact(q)) for q in postures]
    best = max(range(len(postures)), key=lambda k: heights[k].mid())
    limits = arm.limits.position
    mirrored = np.where([kind == "R" for kind in arm.kinds], -postures[best], postures[best]) + 0.0
    allowed = ((limits[:, 0] <= mirrored) & (mirrored <= limits[:, 1])).all()
    apart = np.abs(mirrored - postures[best]).max() > 1e-6
    if allowed and apart and abs(value_on_balls(minors, exact(mirrored)) / heights[best] - 1) < EQUAL:
        return [postures[best], mirrored]
    return [postures[best]]


def _within(arm: Arm, q: Array) -> Array:
    """Angles as the limits have them: free ones in (-pi, pi], the others shifted by whole turns into their range."""
    limits = arm.limits.position
    turned = q.copy()
    for j, kind in enumerate(arm.kinds):
        if kind != "R":
            continue
        if not np.isfinite(limits[j]).any():
            turned[j] = -np.remainder(math.pi - q[j], 2 * math.pi) + math.pi
        elif not limits[j, 0] <= q[j] <= limits[j, 1]:
            low = limits[j, 0] if math.isfinite(limits[j, 0]) else limits[j, 1] - 2 * math.pi
            turned[j] = np.clip(low + np.remainder(q[j] - low, 2 * math.pi), *limits[j])
    return turned


def crude_bound(arm: Arm, task: str) -> float:
    """A number that H does not exceed, from the lengths of the links alone; infinite with an unlimited slide.

    The determinant of a positive matrix is at most the product of its diagonal blocks' (Fischer), and of each at most
    (trace / size)^size. With m linear rows of trace T, and k angular rows, whose trace is the number R of revolute
    joints, H <= (T / m)^(m / 2) (R / k)^(k / 2). T is the sum of the squared distances of the tip from the joints'
    axes, each at most the sum of the lengths between, and of 1 for every prismatic joint.

    Example:
        >>> from chainrule import planar_3r
        >>> round(crude_bound(planar_3r(1.0, 0.5, 0.25), "position"), 6)
        1.84375
    """
    slides = np.abs(np.where(np.array(list(arm.kinds))[:, None] == "P", arm.limits.position, 0.0)).max(axis=1)
    near, far = _links(arm)
    total = np.float64(0.0)
    turning, linear, angular = arm.kinds.count("R"), *ROWS[("planar" if "x_alpha" in arm.tasks else "spatial", task)]
    with np.errstate(over="ignore"):
        for j, kind in enumerate(arm.kinds):
            distance = near[j] + far[j + 1 :].sum() + slides[j + 1 :].sum()
            total += distance**2 if kind == "R" else 1.0
        found = (total / linear) ** (linear / 2) * (turning / angular if angular else 1.0) ** (angular / 2)
    return float(found) * (1 + 1e-12)


#: Linear and angular rows of the tasks.
ROWS = {
    ("planar", "position"): (2, 0),
    ("planar", "x_alpha"): (1, 1),
    ("planar", "pose"): (2, 1),
    ("spatial", "position"): (3, 0),
    ("spatial", "pose"): (3, 3),
}


def _links(arm: Arm) -> tuple[Array, Array]:
    """How far the next joint's (or the tip's) point is from each joint's axis, and from its point: two (n,)."""
    geometry = arm.description.geometry
    if isinstance(geometry, Planar):
        far = np.abs(geometry.lengths)
        return far, far
    if isinstance(geometry, Orthogonal3R):
        moves = [(geometry.d2, 0.0, geometry.r2), (geometry.d3, 0.0, 0.0), (geometry.d4, 0.0, 0.0)]
        # r2 lies along the second axis: seen from the first it is across.
        moves[0] = (math.hypot(geometry.d2, geometry.r2), 0.0, 0.0)
    else:
        moves = [t.translation for t in (*geometry.placements[1:], geometry.tool)]
    points = np.array(moves)
    return np.hypot(points[:, 0], points[:, 1]), np.linalg.norm(points, axis=1)
