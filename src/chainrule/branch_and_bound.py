r"""The largest value of a sum of waves over a box or torus, with a proof: branch and bound.

The domain is cut into boxes. At the centre c of a box of half-widths r, with g and G the gradient and Hessian there,

    S(c + d) <= S(c) + g.d + d.G d / 2 + sum_k R_k (|k|.r)^3 / 6,       R_k the amplitudes,

by Taylor's theorem, and the quadratic part is bounded along the eigenvectors of G. A box is left out where

- its bound stays below a value that S surely has somewhere;
- a partial derivative keeps its sign over it, and the box does not touch the limit on that side (else only the face
  there stays): no maximum is there;
- it lies in the neighbourhood of a maximum found: one over which the Hessian is proved to be negative definite. There S
  is concave, and no value exceeds S(x*) + |g|^2 / (2 lambda), lambda the least curvature: the rounding of x* costs only
  its square.

A maximum at a limit has a neighbourhood too: the derivative is proved to point outwards all over it, and S to be
concave on the face. What is left is cut in two, along the coordinate that matters most. When nothing is left, the
maximum is global; when also no box was left out for being as high as the maximum within the tolerance, there are no
others.

The waves are evaluated in doubles; the bound on their rounding (:class:`chainrule.waves.Waves`) is added everywhere.
The definiteness of the neighbourhoods' Hessians and the values at the maxima are computed in ball arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.balls import below, exact
from chainrule.waves import Waves

Array = NDArray[Any]

#: A little more than pi: the interval of a free angle covers the whole turn.
HALF_TURN = math.nextafter(math.pi, 4.0)

#: Boxes within this share of the largest value are not cut further, values within EQUAL count as equal.
TOLERANCE, EQUAL = 1e-10, 1e-12

#: Boxes (rad) that may be as high as the maximum are cut down to SMALL, to tell isolated maxima from ridges; none is
#: cut below TINY.
SMALL, TINY = 1e-3, 1e-9

#: Starts of the first search, how many of the best are followed uphill; waves times boxes cut at once; maxima kept.
STARTS, CLIMBS, CHUNK, MOST_MAXIMA = 1024, 12, 131_072, 32


@dataclass(frozen=True)
class Domain:
    """Where to look: lower and upper (a,), and which coordinates are angles that turn freely."""

    lower: Array
    upper: Array
    free: Array

    def wrapped(self, x: Array) -> Array:
        """Free angles in (-pi, pi], the rest inside the limits."""
        turned = -np.remainder(math.pi - x, 2 * math.pi) + math.pi
        inside: Array = np.where(self.free, turned, np.clip(x, self.lower, self.upper))
        return inside

    def apart(self, x: Array, y: Array) -> Array:
        """x - y, free angles the shorter way round."""
        between = x - y
        found: Array = np.where(self.free, between - 2 * math.pi * np.rint(between / (2 * math.pi)), between)
        return found


@dataclass(frozen=True, eq=False)
class Peak:
    """A maximum that was found.

    Attributes:
        x: (a,).
        height: S there, a ball.
        around: (a,) half-widths of its neighbourhood, or None where none could be proved.
        bound: what S does not exceed over the neighbourhood, a ball.
    """

    x: Array
    height: Any
    around: Array | None
    bound: Any


@dataclass
class Hunt:
    """One part of the search: a sum of waves over a domain, and what is known so far.

    Attributes:
        waves: the sum of waves.
        domain: where.
        value: S at x in ball arithmetic.
        peaks: the maxima found.
        boxes: how many boxes were examined.
        retired: the bounds over neighbourhoods of maxima that are no longer listed: boxes were left out for them.
        aside: the largest bound of a box that was as high as the maximum within the tolerance (in units of the scale).
    """

    waves: Waves
    domain: Domain
    value: Callable[[Array], Any]
    peaks: list[Peak] = field(default_factory=list)
    boxes: int = 0
    retired: list[Any] = field(default_factory=list)
    aside: float = -math.inf


@dataclass(frozen=True)
class Proof:
    """What was proved of several hunts together.

    Attributes:
        bound: S exceeds this nowhere, a ball.
        boxes: how many boxes were examined.
        finished: whether nothing was left when the budget allowed no more.
        complete: whether every point where S is largest is among the peaks.
    """

    bound: Any
    boxes: int
    finished: bool
    complete: bool


def prove(hunts: Sequence[Hunt], budget: int, progress: Callable[[str], None] = lambda line: None) -> Proof:
    """Find the largest S of all hunts, and prove that it is.

    Args:
        hunts: all in the same units (``waves.scale``); their ``peaks`` are filled.
        budget: no more boxes than this are examined.
        progress: told how the proof goes on.
    """
    for hunt in hunts:
        _first_peaks(hunt)
    left = -math.inf
    finished = True
    for hunt in hunts:
        remains = _search(hunts, hunt, budget - sum(h.boxes for h in hunts), progress)
        finished = finished and remains == -math.inf
        left = max(left, remains)
    top = _highest(hunts)
    scale = hunts[0].waves.scale
    for hunt in hunts:
        hunt.retired += [peak.bound for peak in hunt.peaks if peak.height < top * (1 - EQUAL)]
        hunt.peaks = [peak for peak in hunt.peaks if not peak.height < top * (1 - EQUAL)]
    bounds = [peak.bound for hunt in hunts for peak in hunt.peaks] + [b for hunt in hunts for b in hunt.retired]
    bounds += [scale * value for value in (left, *(hunt.aside for hunt in hunts)) if value > -math.inf]
    bound = max((b.upper() for b in bounds), default=top.upper())
    complete = finished and all(
        hunt.aside == -math.inf and hunt.waves.whole and all(peak.around is not None for peak in hunt.peaks)
        for hunt in hunts
    )
    return Proof(bound, sum(hunt.boxes for hunt in hunts), finished, complete)


def _highest(hunts: Sequence[Hunt]) -> Any:
    return max((peak.height for hunt in hunts for peak in hunt.peaks), key=lambda ball: ball.mid())


def _first_peaks(hunt: Hunt) -> None:
    lower, upper, a = hunt.domain.lower, hunt.domain.upper, hunt.waves.size
    x = np.random.default_rng(0).uniform(lower, upper, (STARTS if a else 1, a))
    height = hunt.waves.expanded(x)[0]
    for k in np.argsort(-height, kind="stable")[: CLIMBS if a else 1]:
        _add_peak(hunt, climb(hunt.waves, hunt.domain, x[k]))


def _add_peak(hunt: Hunt, x: Array) -> None:
    """Keep a maximum if it is higher than, or as high as and apart from, those known."""
    height = hunt.value(x)
    top = max((peak.height for peak in hunt.peaks), key=lambda ball: ball.mid(), default=height)
    if height < top * (1 - EQUAL):
        return
    if any(_within(hunt.domain, x, peak) and height <= peak.height for peak in hunt.peaks):
        return
    found = Peak(x, height, *neighbourhood(hunt.waves, hunt.domain, x, height))
    # A neighbourhood holds one maximum only, so what else was met in it is the same one, less exact.
    same = [p for p in hunt.peaks if _within(hunt.domain, x, p) or _within(hunt.domain, p.x, found)]
    lower = [p for p in hunt.peaks if p.height < height * (1 - EQUAL)]
    if not same and not lower and len(hunt.peaks) >= MOST_MAXIMA:
        return
    hunt.retired += [p.bound for p in hunt.peaks if p in same or p in lower]
    hunt.peaks = [p for p in hunt.peaks if p not in same and p not in lower] + [found]


def _within(domain: Domain, x: Array, peak: Peak) -> bool:
    around = 1e-6 if peak.around is None else peak.around
    return bool((np.abs(domain.apart(x, peak.x)) <= around).all())


def climb(waves: Waves, domain: Domain, start: Array) -> Array:
    """The local maximum reached from ``start`` (a,) uphill, inside the domain: Newton's method, safeguarded."""
    x = np.clip(start, domain.lower, domain.upper)
    for _ in range(200 if waves.size else 0):
        height, gradient, hessian = (part[0] for part in waves.expanded(x[None, :]))
        held = ~domain.free & (((x >= domain.upper) & (gradient > 0)) | ((x <= domain.lower) & (gradient < 0)))
        moving = np.flatnonzero(~held)
        if moving.size == 0:
            break
        curvature, axes = np.linalg.eigh(hessian[np.ix_(moving, moving)])
        size = np.maximum(np.abs(curvature), 1e-12 * max(np.abs(curvature).max(), 1e-300))
        step = np.zeros(waves.size)
        step[moving] = axes @ np.clip(axes.T @ gradient[moving] / size, -0.5, 0.5)
        share = 1.0
        while share > 1e-6:
            tried = x + share * step
            tried = np.where(domain.free, tried, np.clip(tried, domain.lower, domain.upper))
            if waves.expanded(tried[None, :])[0][0] > height:
                break
            share /= 4
        else:
            break
        x = tried
    return domain.wrapped(_polished(waves, domain, x))


def _polished(waves: Waves, domain: Domain, x: Array) -> Array:
    """The maximum to the last digits, where heights in doubles no longer tell: Newton's method while steps shrink."""
    last = 1e-2
    for _ in range(20 if waves.size else 0):
        gradient, hessian = (part[0] for part in waves.expanded(x[None, :])[1:])
        moving = np.flatnonzero(domain.free | ((x < domain.upper) & (x > domain.lower)))
        inner = hessian[np.ix_(moving, moving)]
        if moving.size == 0 or np.linalg.eigvalsh(inner)[-1] >= 0.0:
            break
        step = np.linalg.solve(-inner, gradient[moving])
        size = float(np.abs(step).max())
        if not size < last:
            break
        x, last = x.copy(), size / 2
        x[moving] += step
        if not (domain.free | ((x <= domain.upper) & (x >= domain.lower))).all():
            x = np.where(domain.free, x, np.clip(x, domain.lower, domain.upper))
    return x


def neighbourhood(waves: Waves, domain: Domain, x: Array, height: Any) -> tuple[Array | None, Any]:
    """Half-widths (a,) of a box about a maximum over which S is proved not to exceed a bound, and that bound.

    (None, the height) where the maximum is flat, or too near to being so.
    """
    a, k, amplitude = waves.size, np.abs(waves.frequencies), waves.amplitude
    _, gradient, hessian = (part[0] for part in waves.expanded(x[None, :]))
    held = ~domain.free & (((x >= domain.upper) & (gradient > 0)) | ((x <= domain.lower) & (gradient < 0)))
    loose = np.flatnonzero(~held)
    around = np.ones(a)
    for _ in range(24):
        turn = k @ around
        outward = np.abs(gradient) - (amplitude * np.minimum(turn, 2.0)) @ k - _slack(waves, 1)
        if (outward[held] > 0.0).all():
            change = (amplitude * np.minimum(turn, 2.0) * (1 + 1e-9)) @ (k[:, :, None] * k[:, None, :]).reshape(
                len(k), a * a
            )
            change = change.reshape(a, a)[np.ix_(loose, loose)] + _slack(waves, 2)
            excess = _concave(-hessian[np.ix_(loose, loose)], change, np.abs(gradient[loose]) + _slack(waves, 1))
            if excess is not None:
                return around, height + waves.scale * (excess + 2 * waves.folded)
        around = around / 2
    return None, height


def _concave(negated: Array, change: Array, slope: Array) -> float | None:
    """How far a function may rise above a point with slope at most ``slope``.

    Its Hessian is minus ``negated``, give or take ``change``; None where that is not proved to be negative definite.
    """
    if len(negated) == 0:
        return 0.0
    diagonal = np.diag(negated)
    if not (diagonal > 0.0).all():
        return None
    scaling = 1.0 / np.sqrt(diagonal)
    scaled = negated * scaling[:, None] * scaling
    width = float((change * scaling[:, None] * scaling).sum(axis=1).max()) * (1 + 1e-9) + 1e-14 * len(negated)
    least = (float(np.linalg.eigvalsh(scaled)[0]) - width) / 2
    if least <= 0.0 or not positive_definite(scaled - (width + least) * np.eye(len(scaled))):
        return None
    return float(((scaling * slope) ** 2).sum() / (2 * least)) * (1 + 1e-9)


def positive_definite(matrix: Array) -> bool:
    """Whether a symmetric matrix of doubles is proved to be positive definite, by elimination in ball arithmetic."""
    rest = exact(np.tril(matrix) + np.tril(matrix, -1).T)
    for i in range(len(rest)):
        if not rest[i, i] > 0:
            return False
        for j in range(i + 1, len(rest)):
            rest[j, i + 1 :] = rest[j, i + 1 :] - rest[j, i] / rest[i, i] * rest[i, i + 1 :]
    return True


def _slack(waves: Waves, order: int) -> float:
    """Bound on the error of derivatives of that order: every wave of it is multiplied by |k| once more."""
    return waves.error * waves.steepest**order


@dataclass(frozen=True)
class _Boxes:
    lower: Array
    upper: Array
    bound: Array

    def __len__(self) -> int:
        return len(self.bound)

    def chosen(self, which: Array) -> _Boxes:
        return _Boxes(self.lower[which], self.upper[which], self.bound[which])

    def joined(self, other: _Boxes) -> _Boxes:
        return _Boxes(
            np.concatenate([self.lower, other.lower]),
            np.concatenate([self.upper, other.upper]),
            np.concatenate([self.bound, other.bound]),
        )


def _search(hunts: Sequence[Hunt], hunt: Hunt, budget: int, progress: Callable[[str], None]) -> float:
    """Work through the boxes of a hunt; the largest bound of what is left, minus infinity where nothing is."""
    waves, domain = hunt.waves, hunt.domain
    most = waves.constant + float(waves.amplitude.sum()) + waves.error
    queue = _Boxes(domain.lower[None, :], domain.upper[None, :], np.array([most]))
    new, queue = queue, queue.chosen(np.array([], int))
    chunk = max(16, CHUNK // max(1, waves.amplitude.size))
    weight = np.sqrt((waves.amplitude[:, None] * waves.frequencies**2).sum(axis=0))
    climbs = 0
    while True:
        if len(new) > budget:
            queue = queue.joined(new)
            break
        budget -= len(new)
        hunt.boxes += len(new)
        new, heights = _examined(hunt, new, below(_highest(hunts) / waves.scale))
        if len(new) and climbs < 64:
            best = int(heights.argmax())
            inside = _inside_any(hunt, new.chosen(np.array([best])))[0]
            if not inside and heights[best] > below(_highest(hunts) / waves.scale) * (1 - 1e-3):
                climbs += 1
                centre = (new.lower[best] + new.upper[best]) / 2
                _add_peak(hunt, climb(waves, domain, centre))
        low = below(_highest(hunts) / waves.scale)
        queue = queue.joined(new)
        queue = queue.chosen((queue.bound >= low) & ~_inside_any(hunt, queue))
        width = (queue.upper - queue.lower).max(axis=1, initial=0.0)
        isolated = all(peak.around is not None for h in hunts for peak in h.peaks)
        settled = (queue.bound <= low * (1 + TOLERANCE)) & (width < (SMALL if isolated else math.inf)) | (width < TINY)
        hunt.aside = max(hunt.aside, float(queue.bound[settled].max(initial=-math.inf)))
        queue = queue.chosen(~settled)
        if not len(queue):
            return -math.inf
        progress(f"{hunt.boxes:,} boxes examined, {len(queue):,} left".replace(",", "\u202f"))
        order = np.argsort(-queue.bound, kind="stable")
        widest = ((queue.upper - queue.lower) * weight).argmax(axis=1)
        taken = order[: min(chunk, max(1, budget // 2))]
        if budget < 2:
            break
        new = _halved(queue.chosen(taken), widest[taken])
        queue = queue.chosen(order[len(taken) :])
    return float(queue.bound.max())


def _halved(boxes: _Boxes, along: Array) -> _Boxes:
    rows = np.arange(len(boxes))
    middle = (boxes.lower[rows, along] + boxes.upper[rows, along]) / 2
    left, right = boxes.upper.copy(), boxes.lower.copy()
    left[rows, along] = middle
    right[rows, along] = middle
    whole = boxes.lower[rows, along] < boxes.upper[rows, along]  # a point has no second half
    return _Boxes(boxes.lower, left, boxes.bound).joined(_Boxes(right, boxes.upper, boxes.bound).chosen(whole))


def _inside_any(hunt: Hunt, boxes: _Boxes) -> Array:
    """Which boxes lie in a neighbourhood of a known maximum (its bound stands for theirs)."""
    inside = np.zeros(len(boxes), bool)
    if not len(boxes):
        return inside
    centre, half = (boxes.lower + boxes.upper) / 2, (boxes.upper - boxes.lower) / 2
    for peak in hunt.peaks:
        if peak.around is not None:
            away = np.abs(hunt.domain.apart(centre, peak.x)) + half
            rounding = 2.0**-48 * (np.abs(boxes.lower) + np.abs(boxes.upper) + np.abs(peak.x) + 4.0)
            inside |= (away + rounding <= peak.around).all(axis=1)
    return inside


def _examined(hunt: Hunt, boxes: _Boxes, low: float) -> tuple[_Boxes, Array]:
    """The boxes that may hold a maximum of ``low`` or more, with better bounds, and the heights of their centres.

    Where only the face of a box stays, the face is examined in its place.
    """
    waves, domain = hunt.waves, hunt.domain
    if waves.size == 0:
        top = np.full(len(boxes), waves.constant + waves.error)
        return _Boxes(boxes.lower, boxes.upper, np.minimum(boxes.bound, top)), top
    centre = (boxes.lower + boxes.upper) / 2
    half = np.nextafter(np.maximum(boxes.upper - centre, centre - boxes.lower), math.inf)
    height, gradient, hessian = waves.expanded(centre)
    k, amplitude = np.abs(waves.frequencies), waves.amplitude
    turn = half @ k.T * (1 + 1e-12)
    slack = waves.error * (1 + (1 + waves.steepest * half.max(axis=1)) ** 2)

    change = np.einsum("mij,mj->mi", np.abs(hessian), half) + 0.5 * (turn * turn * amplitude) @ k
    change = change * (1 + 1e-12) + waves.steepest * slack[:, None]
    rising, falling = gradient > change, gradient < -change
    at_upper = ~domain.free & (boxes.upper >= domain.upper)
    at_lower = ~domain.free & (boxes.lower <= domain.lower)
    out = ((rising & ~at_upper) | (falling & ~at_lower)).any(axis=1)
    lower = np.where(rising & at_upper, boxes.upper, boxes.lower)
    upper = np.where(falling & at_lower, boxes.lower, boxes.upper)

    bound = _by_taylor(height, gradient, hessian, half, turn, amplitude)
    open_still = np.flatnonzero(~out & (bound + slack >= low))
    bound[open_still] = np.minimum(bound[open_still], _by_phase(waves, centre[open_still], turn[open_still]))
    bound = np.minimum(boxes.bound, bound + slack)
    onto_face = ~out & ((lower > boxes.lower) | (upper < boxes.upper)).any(axis=1)
    stays = ~out & ~onto_face
    found = _Boxes(lower[stays], upper[stays], bound[stays]), height[stays]
    if not onto_face.any():
        return found
    faces, heights = _examined(hunt, _Boxes(lower[onto_face], upper[onto_face], bound[onto_face]), low)
    return found[0].joined(faces), np.concatenate([found[1], heights])


def _by_taylor(height: Array, gradient: Array, hessian: Array, half: Array, turn: Array, amplitude: Array) -> Array:
    """The bound by Taylor's theorem; the quadratic part along eigenvectors V of the Hessian, e = V^T d.

    g.d + d.G d / 2 = (V^T g).e + sum_i lambda_i e_i^2 / 2 + (g - V V^T g).d + d.(G - V Lambda V^T) d / 2; the last two
    are what rounding left of nought, and V need not be orthogonal.
    """
    curvature, axes = np.linalg.eigh(hessian)
    slope = np.einsum("mji,mj->mi", axes, gradient)
    extent = np.einsum("mji,mj->mi", np.abs(axes), half)
    steep = np.abs(slope)
    ends = steep * extent + 0.5 * curvature * extent**2
    with np.errstate(divide="ignore", invalid="ignore"):
        top = -0.5 * steep**2 / curvature
        best = np.where((curvature < 0.0) & (steep < -curvature * extent), top, ends)
    odd = np.abs(gradient - np.einsum("mij,mj->mi", axes, slope))
    rest = np.abs(hessian - np.einsum("mij,mj,mkj->mik", axes, curvature, axes))
    corrections = (odd * half).sum(axis=1) + 0.5 * np.einsum("mij,mi,mj->m", rest, half, half)
    found: Array = height + best.sum(axis=1) + corrections + (turn * turn * turn @ amplitude) / 6 * (1 + 1e-12)
    return found


def _by_phase(waves: Waves, centre: Array, turn: Array) -> Array:
    """The bound by the range of every wave for itself: better for large boxes."""
    phase = centre @ waves.frequencies.T - np.arctan2(waves.sine, waves.cosine)
    away = np.abs(phase - 2 * math.pi * np.rint(phase / (2 * math.pi)))
    found: Array = np.cos(np.maximum(away - turn, 0.0)) @ waves.amplitude + waves.constant
    return found
