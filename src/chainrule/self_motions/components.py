"""All self-motion curves of any arm with one joint more than its task has rows."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.self_motions.continuation import followed
from chainrule.self_motions.held import Held
from chainrule.self_motions.identity import Known
from chainrule.self_motions.projection import project, start_points
from chainrule.self_motions.result import Component
from chainrule.self_motions.spherical import Flip, Structure
from chainrule.self_motions.srs import Swivel
from chainrule.self_motions.sweep import DISTINCT, Sweep
from chainrule.self_motions.tracing import Settings

Array = NDArray[Any]

TURN = 2.0 * math.pi
#: Values of the swept joint, besides the middles between events, at which all postures must lie on the curves found.
CHECKED = 48
#: A sine of a flip's middle joint below this may be 0: such postures belong to both sides.
ON_LINE = 1e-9
#: Starts projected at a time by the search.
BATCH = 64


@dataclass(frozen=True)
class Found:
    """The curves at a target.

    Attributes:
        components: the curves.
        method: "closed form", "sweep" or "continuation".
        complete: "proved", or what was done.
        detail: what is singular, in words.
    """

    components: tuple[Component, ...]
    method: str
    complete: str
    detail: str = ""


def all_components(arm: Arm, target: Array, task: str, *, starts: int = 64, seed: int = 0, scale: float = 1.0) -> Found:
    """All curves at a target: closed form or sweep where the arm's axes allow it, else a search from many starts."""
    held, detail, doubts = Held(arm, task, scale), "", ""
    known = Known(held, target)
    if task == "pose" and arm.kinds == "RRRRRRR":
        swivel = Swivel.of(arm, target)
        if swivel is not None:
            detail = swivel.singular
            if not detail:
                return _swivelled(held, swivel)
        sweep = Sweep.of(held, target)
        if sweep is not None and sweep.special != "unfit":
            doubts, singular = _swept(known, sweep)
            detail = detail or singular
            if not doubts and not detail:
                return Found(tuple(known.components), "sweep", "proved")
            doubts = f"; joint {sweep.swept + 1} was swept before, without a proof: {doubts or detail}"
    found = searched(held, target, starts, seed, known)
    return Found(found.components, "sweep" if doubts else found.method, found.complete + doubts, detail)


def _traced(held: Held, target: Array, starts: Array) -> tuple[Component, ...]:
    return followed(held, starts, target, Settings()) if len(starts) else ()


# ---- S-R-S -------------------------------------------------------------------------------------------------------


def _swivelled(held: Held, swivel: Swivel) -> Found:
    """Eight curves, or none. One is followed; what flips of shoulder, elbow and wrist make of it are others."""
    if not swivel.elbows:
        return Found((), "closed form", "proved")
    starts = held.corrected(swivel.thirds[..., 0, :].reshape(-1, 7), swivel.target)
    structure = swivel.limbs.structure
    curves: list[Component] = []
    ends = [flip for flip in structure.flips if flip.first != 2]  # what the elbow's flip makes is not among the starts
    sides = np.array([flip.side(starts) > 0.0 for flip in ends]).reshape(-1, len(starts))
    for k in np.flatnonzero(sides.all(axis=0)):  # one of each class of curves that the flips make of one another
        [curve] = _traced(held, swivel.target, starts[k : k + 1])
        curves += structure.images(curve, structure.flips)
    closed = all(curve.closed for curve in curves) and len(curves) == 4 * len(swivel.elbows)
    return Found(tuple(curves), "closed form", "proved" if closed else f"{len(curves)} curves, not all of which closed")


# ---- a joint swept -----------------------------------------------------------------------------------------------


def _swept(known: Known, sweep: Sweep) -> tuple[str, str]:
    """The curves through all postures at the middles between events.

    Where flips (:class:`Flip`) leave the swept joint alone, curves come in classes of images of one another: then only
    postures on one side of each flip are looked at, as long as no curve changes sides.

    Returns:
        why that is no proof, or nothing if it is one; and what is singular, or nothing.
    """
    events = sweep.events()
    gaps = np.diff(events, append=events[:1] + TURN)
    middles = events + 0.5 * gaps if len(events) else np.array([0.5])
    middles = middles[gaps >= DISTINCT] if len(events) else middles
    grid = (np.arange(CHECKED) + 0.37) * (TURN / CHECKED)
    q, rows = sweep.postures(np.concatenate([middles, grid]))
    structure = Structure.of(known.held.arm)
    flips = [each for each in structure.flips if not each.first <= sweep.swept <= each.first + 2]
    one_side = np.ones(len(q), bool)
    for flip in flips:
        one_side &= flip.side(q) > -ON_LINE
    half = Known(known.held, known.target)
    _followed(half, q[one_side & (rows < len(middles))])
    if flips and all(_keeps_side(curve, flip) for curve in half.components for flip in flips):
        q, rows = q[one_side], rows[one_side]
    elif flips:
        flips, half = [], Known(known.held, known.target)
        _followed(half, q[rows < len(middles)])
    needed = rows < len(middles)
    doubts = [] if sweep.right else ["the spherical joint's axes are not at right angles: it has events of its own"]
    if len(events) and gaps.min() < DISTINCT:
        doubts.append(f"two events are {gaps.min():.1g} rad apart")
    if not all(curve.closed for curve in half.components):
        doubts.append("not every curve closed")
    apart = np.abs(np.mod(grid[:, np.newaxis] - events + math.pi, TURN) - math.pi).min(axis=1, initial=9.0)
    clear = np.concatenate([np.ones(len(middles), bool), apart > 1e-6])[rows] & ~needed
    astray = q[clear][half.which(q[clear]) < 0]
    if len(astray):  # an event was missed: follow what was found, and say so
        before = len(half.components)
        _followed(half, astray)
        if len(half.components) > before:
            doubts.append("a posture between events lay on no curve")
    if _folds(half, sweep, events) > 0:
        doubts.append("a curve turns back where there is no event")
    for curve in half.components:
        for image in structure.images(curve, flips):
            known.add(image)
    scale = max((curve.manipulability[1] for curve in known.components), default=0.0)
    if not scale:
        random = start_points(known.held.arm, 64)
        scale = float(known.held.arm.manipulability(random, task=known.held.task).max())
    lost = sweep.singular(events, scale)
    return "; ".join(doubts), "" if not len(lost) else f"singular postures where joint {sweep.swept + 1} turns back"


def _keeps_side(curve: Component, flip: Flip) -> bool:
    """Whether the middle joint of a flip stays between two values at which the outer axes are in line."""
    low, high = (curve.box[flip.first + 1] - flip.middle) / math.pi
    return bool(math.floor(low) == math.floor(high) and low > math.floor(low))


def _followed(known: Known, q: Array) -> None:
    """Follow the curves through configurations that are on none yet."""
    open_ = q
    while len(open_):
        open_ = open_[known.which(open_) < 0]
        if not len(open_):
            break
        [curve] = _traced(known.held, known.target, open_[:1])
        known.add(curve)
        open_ = open_[1:]


def _folds(known: Known, sweep: Sweep, events: Array) -> int:
    """How many extrema of the swept joint on the curves found are at no event."""
    missing = 0
    for curve in known.components:
        low, high = curve.box[sweep.swept]
        if not curve.closed or curve.winding[sweep.swept]:
            continue
        for value in (low, high):
            x = -value if sweep.chain.backwards else value
            apart = np.abs(np.mod(events - x + math.pi, TURN) - math.pi).min(initial=math.inf)
            missing += bool(apart > 1e-5)
    return missing


# ---- many starts -------------------------------------------------------------------------------------------------


def searched(held: Held, target: Array, starts: int, seed: int = 0, known: Known | None = None) -> Found:
    """The curves on which starts lie that were moved to the target, besides those already known.

    ``starts`` random configurations go to the nearest posture, and for each joint ``starts`` / n others (rounded up) to
    a posture in which that joint is extremal on its curve. The former meet a curve about as often as it is long; the
    latter lead to short ones too, since every closed curve has two extremal points of each joint that does not wind.
    """
    known = Known(held, target) if known is None else known
    n, last = held.arm.n, ""
    each = -(-starts // n)
    every = start_points(held.arm, starts + n * each, seed)
    joints = np.repeat(np.arange(n) + 1, each)
    batches = [(begin, min(begin + BATCH, starts), None) for begin in range(0, starts, BATCH)]
    for begin, end, extremal in [*batches, (starts, len(every), joints)]:
        q, arrived = project(held.arm, every[begin:end], target, held.task, scale=held.scale, extremal=extremal)
        places = np.flatnonzero(arrived)
        places = places[known.which(q[places]) < 0]
        while len(places):
            [curve] = _traced(held, target, q[places[:1]])
            known.add(curve)
            number = int(places[0]) + 1
            last = f"start {begin + number}" if extremal is None else f"extremal point {number}"
            places = places[1:]
            places = places[known.which(q[places]) < 0]
    words = f"{starts} starts and {n * each} extremal points of joints"
    if not known.components:
        return Found((), "continuation", f"{words}, none of which reached the target")
    return Found(tuple(known.components), "continuation", f"{words}, last new component at {last or 'none of them'}")
