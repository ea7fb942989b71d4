"""Methods of following a path compared: on one stretch from the same postures, over random arms, over whole paths."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import planar_model
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluators
from chainrule.following import FINISHED, follow_many
from chainrule.following_inputs import (
    check_against_curvature,
    check_against_rounding,
    check_path,
    checked_chains,
    checked_methods,
    checked_tolerance,
)
from chainrule.inputs import real_array, whole_number
from chainrule.paths import Path, real_number, unit
from chainrule.stretches import ENDS, METHODS, Arcs, Chains, Method, Placed, choose, picked, stand, stretch

Array = NDArray[Any]

# ---- one stretch, method against method ------------------------------------------------------------------------


@dataclass(frozen=True)
class Comparison:
    """One stretch along circular arcs (or lines) from the same postures, by every method.

    Attributes:
        methods: the m methods.
        tolerance: in m.
        rates: (..., m, 3) joint rates per metre of path at the start.
        travel: (..., m) arc length of the desired path when the tolerance is reached, in m; 0 where the arm is
            singular; at most one turn, or four times the arm's size.
        duration: (..., m) how long the joints move: they end at q + rates duration.
        predicted: (..., m) the travel by the two-term offset.
        curvature: (..., m) of the path each makes, at the start, in 1/m.
        curvature_rate: (..., m) its dk/ds, in 1/m^2.
        ended: (..., m) why each ended, numbers in :data:`chainrule.stretches.ENDS`.
        discriminant: (...,) negative where no constant rates have the desired curvature.
        roots: (..., 2) travel by each of the two solutions for the curvature; nan where there is none.
        chosen: (...,) the solution (from 0) that the paper's rule takes.
    """

    methods: tuple[Method, ...]
    tolerance: float
    rates: Array
    travel: Array
    duration: Array
    predicted: Array
    curvature: Array
    curvature_rate: Array
    ended: Array
    discriminant: Array
    roots: Array
    chosen: Array

    def of(self, method: Method) -> Array:
        """The travel (...,) of one method."""
        found: Array = self.travel[..., _place(self.methods, method)]
        return found

    def ratio(self, method: Method, other: Method = "pseudoinverse") -> Array:
        """How many times as far one method travels as another, (...,); nan where the other does not move."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.of(other) > 0.0, self.of(method) / self.of(other), np.nan)

    def to_dict(self) -> dict[str, Any]:
        """Plain values; null where there is no number."""
        names = ("rates", "travel", "duration", "predicted", "curvature", "curvature_rate", "discriminant", "roots")
        lists = {name: _listed(getattr(self, name)) for name in names}
        ended = np.take(np.array(ENDS), self.ended).tolist()
        return {"methods": list(self.methods), "tolerance": self.tolerance, **lists, "ended": ended}


def _place(methods: tuple[Method, ...], method: Any) -> int:
    """Which of the methods of a result this is."""
    if not isinstance(method, str) or method not in methods:
        raise InputError(f"method: {shown(method)}; {', '.join(methods)} were compared")
    return methods.index(method)


def _listed(values: Array) -> Any:
    """Nested lists, with None for what is not finite."""
    objects: Array = values.astype(object)
    objects[~np.isfinite(values)] = None
    return objects.tolist()


def compare(
    arm: Arm, q: Any, tangent: Any, curvature: Any, tolerance: float, *, methods: Sequence[Method] = METHODS
) -> Comparison:
    """How far each method gets along a circular arc before the tip is ``tolerance`` away from it.

    Args:
        arm: a planar arm with three joints.
        q: (..., 3) postures; leading axes broadcast.
        tangent: (..., 2) directions of the arc at the tip; any length but zero.
        curvature: (...,) of the arc in 1/m, left turns positive; 0 is a straight line.
        tolerance: in m; at most 0.9 of the smallest radius.
        methods: which methods.

    Raises:
        InputError: one line saying what is wrong.

    Example:
        >>> import numpy as np
        >>> from chainrule import load
        >>> arm, q = load("ambike_3r"), np.radians([-14.0, -10.0, -205.0])
        >>> found = compare(arm, q, [2.0, 1.0], -1.0, 0.025)  # example 1 of the paper
        >>> float(found.ratio("speed_ratio").round(2)) > 1.0
        True
    """
    chains = checked_chains(arm)
    margin = checked_tolerance(tolerance)
    methods = checked_methods(methods)
    given, direction, bend = (
        real_array(value, name) for value, name in ((q, "q"), (tangent, "tangent"), (curvature, "curvature"))
    )
    if given.ndim < 1 or given.shape[-1] != 3:
        raise InputError(f"q: shape {given.shape}; (..., 3) is accepted")
    if direction.ndim < 1 or direction.shape[-1] != 2:
        raise InputError(f"tangent: shape {direction.shape}; (..., 2) is accepted")
    try:
        lead = np.broadcast_shapes(given.shape[:-1], direction.shape[:-1], bend.shape)
    except ValueError:
        raise InputError(
            f"q {given.shape}, tangent {direction.shape} and curvature {bend.shape} do not broadcast together"
        ) from None
    direction = unit(direction, "tangent")
    check_against_curvature(margin, float(np.abs(bend).max(initial=0.0)))
    flat = np.broadcast_to(given, (*lead, 3)).reshape(-1, 3)
    headings = np.broadcast_to(direction, (*lead, 2)).reshape(-1, 2)
    check_against_rounding(margin, float(chains.size(flat).max(initial=0.0)))
    found = _compared(
        chains.take(np.zeros(len(flat), dtype=int)),
        flat,
        headings,
        np.broadcast_to(bend, lead).reshape(-1),
        margin,
        methods,
    )
    shaped = {name: a.reshape((*lead, *a.shape[1:])) for name, a in vars(found).items() if isinstance(a, np.ndarray)}
    return Comparison(methods=found.methods, tolerance=margin, **shaped)


def _compared(
    chains: Chains, q: Array, tangent: Array, curvature: Array, tolerance: float, methods: tuple[Method, ...]
) -> Comparison:
    """:func:`compare` for k arms, one each."""
    with np.errstate(divide="ignore"):
        end = np.minimum(2.0 * np.pi / np.abs(curvature), 4.0 * chains.size(q))
    tracks, zero, margin = Arcs(chains.tip(q), tangent, curvature, end), np.zeros(len(q)), np.full(len(q), tolerance)
    case = stand(chains, q, tracks.at(zero), margin)
    rates, travel, duration, predicted, bend, change, ended = [], [], [], [], [], [], []
    for method in methods:
        x, found = choose(case, tracks, zero, method)
        path = chains.motion(q, x)[1]
        still = ~(x != 0.0).any(axis=1)
        rates.append(x)
        travel.append(found.s)
        duration.append(found.t)
        predicted.append(np.where(still, 0.0, case.travel(path[:, 1], path[:, 2])))
        bend.append(path[:, 1])
        change.append(path[:, 2])
        ended.append(found.ended)
    roots = np.full((len(q), 2), np.nan)
    for k in (0, 1):
        own = picked(case.rates.both, np.full(len(q), k))
        there = case.rates.exist[:, k]
        roots[there, k] = stretch(chains, tracks, q, zero, own, margin).s[there]
    return Comparison(
        methods=methods,
        tolerance=tolerance,
        rates=np.stack(rates, axis=1),
        travel=np.stack(travel, axis=1),
        duration=np.stack(duration, axis=1),
        predicted=np.stack(predicted, axis=1),
        curvature=np.stack(bend, axis=1),
        curvature_rate=np.stack(change, axis=1),
        ended=np.stack(ended, axis=1),
        discriminant=case.rates.discriminant,
        roots=roots,
        chosen=case.rates.nearer,
    )


# ---- many arms and paths ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Study:
    """How far each method gets, over many random arms, postures and arcs.

    Attributes:
        kinds: the arms' joints, such as ``RRR``.
        lengths: (k, 3) their link lengths in m.
        curvature: (k,) of the arcs in 1/m.
        comparison: the k stretches.
    """

    kinds: str
    lengths: Array
    curvature: Array
    comparison: Comparison

    def quantiles(self, method: Method, shares: Sequence[float] = (0.05, 0.25, 0.5, 0.75, 0.95)) -> Array:
        """Quantiles of how many times as far a method travels as the pseudoinverse."""
        return np.asarray(np.nanquantile(self.comparison.ratio(method), shares))

    def to_dict(self) -> dict[str, Any]:
        """The distribution in numbers: medians, shares of cases in which a method is worse, predictions."""
        found = self.comparison
        ratio, met = found.ratio("speed_ratio"), found.discriminant >= 0.0
        pair = [found.methods.index("speed_ratio"), found.methods.index("pseudoinverse")]
        gap, guess = (np.diff(a[:, pair], axis=1)[:, 0] for a in (found.travel, found.predicted))
        decided = np.abs(gap) > 1e-9 * found.travel[:, pair].max(axis=1)
        both = np.isfinite(found.roots).all(axis=1) & (np.abs(np.diff(found.roots, axis=1)[:, 0]) > 1e-9)
        missed = found.roots[both].argmax(axis=1) != found.chosen[both]
        return {
            "kinds": self.kinds,
            "cases": len(ratio),
            "tolerance": found.tolerance,
            "met": float(met.mean()),
            "median": _median(ratio),
            "median_met": _median(ratio[met]),
            "median_not_met": _median(ratio[~met]),
            "worse": _share(ratio < 1.0 - 1e-9),
            "worse_met": _share(ratio[met] < 1.0 - 1e-9),
            "worse_not_met": _share(ratio[~met] < 1.0 - 1e-9),
            "two_term_median": _median(found.ratio("two_term")),
            "two_term_worse": _share(found.ratio("two_term") < 1.0 - 1e-9),
            "look_ahead_median": _median(found.ratio("look_ahead")),
            "look_ahead_worse": _share(
                found.of("look_ahead") < (1.0 - 1e-9) * np.maximum(found.of("speed_ratio"), found.of("pseudoinverse"))
            ),
            "winner_predicted": _share((np.sign(gap) == np.sign(guess))[decided]),
            "better_root_missed": int(missed.sum()),
            "two_roots": int(both.sum()),
        }


def _median(values: Array) -> float | None:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else None


def _share(flags: Array) -> float | None:
    return float(flags.mean()) if len(flags) else None


def study(
    count: int = 1000,
    tolerance: float = 0.025,
    *,
    kinds: str = "RRR",
    lengths: Sequence[float] | None = None,
    curvature: float = 1.0,
    seed: int = 0,
) -> Study:
    """Compare the methods over ``count`` random arms, postures, directions and both turns; the same for the same seed.

    Args:
        count: how many cases.
        tolerance: in m.
        kinds: three joints, R or P each.
        lengths: (3,) link lengths in m of every arm; without them each arm has its own, uniform from 0.2 to 1.8.
        curvature: magnitude of the arcs' curvature in 1/m; the turn is drawn.
        seed: of the random numbers.

    Raises:
        InputError: one line saying what is wrong.

    Example:
        >>> study(200, 0.005, seed=1).to_dict()["look_ahead_worse"]
        0.0
    """
    margin = checked_tolerance(tolerance)
    count = whole_number(count, "count")
    bend = real_number(curvature, "curvature")
    check_against_curvature(margin, abs(bend))
    random = np.random.default_rng(whole_number(seed, "seed", 0))
    chains, q = random_arms(random, count, kinds, lengths)
    heading = random.uniform(-np.pi, np.pi, count)
    tangent = np.stack([np.cos(heading), np.sin(heading)], axis=1)
    bends = bend * random.choice([-1.0, 1.0], count)
    found = _compared(chains, q, tangent, bends, margin, METHODS)
    return Study(kinds, chains.parameters[:, :3], bends, found)


def random_arms(
    random: np.random.Generator, count: int, kinds: str, lengths: Sequence[float] | None
) -> tuple[Chains, Array]:
    """Arms of one kind without joint limits, and a posture (count, 3) of each."""
    if not isinstance(kinds, str) or len(kinds) != 3 or set(kinds) - {"R", "P"}:
        raise InputError(f"kinds: {shown(kinds)}; three letters, R or P each, are accepted")
    sliding = np.array([kind == "P" for kind in kinds])
    own = random.uniform(0.2, 1.8, (count, 3))
    if lengths is not None:
        given = real_array(lengths, "lengths")
        if given.shape != (3,) or not (given > 0.0).all():
            raise InputError(f"lengths: {shown(lengths)}; three positive numbers are accepted")
        own = np.broadcast_to(given, (count, 3))
    headings = random.uniform(-np.pi, np.pi, (count, int(sliding.sum())))
    evaluators = Evaluators(planar_model(kinds))
    groups = {"tip_motion": "motion", "speed_ratio_rates": "speed_ratio"}

    def evaluator(name: str) -> Any:
        return evaluators.get(groups.get(name, "kinematics"), name)

    free = np.tile([-np.inf, np.inf], (3, 1))
    q = np.where(sliding, random.uniform(-0.2, 0.8, (count, 3)), random.uniform(-np.pi, np.pi, (count, 3)))
    return Chains(kinds, evaluator, np.concatenate([own, headings], axis=1), free), q


@dataclass(frozen=True)
class Loops:
    """Whole paths followed by many arms, each with every method from the same posture.

    Attributes:
        methods: the m methods.
        tolerance: in m.
        updates: (k, m) feedback updates.
        finished: (k, m) which reached the end.
    """

    methods: tuple[Method, ...]
    tolerance: float
    updates: Array
    finished: Array

    def ratio(self, method: Method, other: Method = "pseudoinverse") -> Array:
        """Updates of one method divided by another's, where both reached the end and the other needed any."""
        i, j = (_place(self.methods, name) for name in (method, other))
        use = self.finished[:, i] & self.finished[:, j] & (self.updates[:, j] > 0)
        found: Array = self.updates[use, i] / self.updates[use, j]
        return found

    def to_dict(self) -> dict[str, Any]:
        """For each method: the share that reached the end, median updates, and ratios to the pseudoinverse."""
        rows = {}
        for k, method in enumerate(self.methods):
            ratio = self.ratio(method)
            rows[method] = {
                "finished": float(self.finished[:, k].mean()),
                "median_updates": _median(self.updates[self.finished.all(axis=1), k].astype(float)),
                "median_ratio": _median(ratio),
                "more": _share(ratio > 1.0),
                "fewer": _share(ratio < 1.0),
            }
        return {"cases": len(self.updates), "tolerance": self.tolerance, "methods": rows}


def study_paths(
    path: Path,
    count: int = 200,
    tolerance: float = 0.005,
    *,
    lengths: Sequence[float] | None = None,
    methods: Sequence[Method] = METHODS,
    seed: int = 0,
    max_updates: int = 2000,
) -> Loops:
    """Follow one path with ``count`` random 3R arms, the path placed at the tip in a random direction.

    Postures are drawn until the path fits into the arm's workspace with a twentieth of its reach to spare.

    Raises:
        InputError: one line saying what is wrong; a path that no random arm can hold.

    Example:
        >>> from chainrule import Circle
        >>> study_paths(Circle((0.0, 0.0), 0.3), 20).to_dict()["cases"]
        20
    """
    margin, methods = checked_tolerance(tolerance), checked_methods(methods)
    check_path(path)
    check_against_curvature(margin, path.max_curvature)
    count, most = whole_number(count, "count"), whole_number(max_updates, "max_updates", 0)
    random = np.random.default_rng(whole_number(seed, "seed", 0))
    grid = path.point(np.linspace(0.0, path.length, 200))
    heading = path.tangent(0.0)
    stores: tuple[list[Array], ...] = ([], [], [], [])
    kept = 0
    for _ in range(100):
        chains, q = random_arms(random, 4 * count, "RRR", lengths)
        angle = random.uniform(-np.pi, np.pi, len(q))
        c, s = np.cos(angle), np.sin(angle)
        turn = np.stack([c * heading[0] + s * heading[1], s * heading[0] - c * heading[1]], axis=1)
        spun = np.stack(
            [
                turn[:, :1] * grid[:, 0] - turn[:, 1:] * grid[:, 1],
                turn[:, 1:] * grid[:, 0] + turn[:, :1] * grid[:, 1],
            ],
            axis=2,
        )
        shift = chains.tip(q) - spun[:, 0]
        radius = np.linalg.norm(spun + shift[:, None], axis=2)
        links = chains.parameters
        reach = links.sum(axis=1)
        hole = np.maximum(0.0, 2.0 * links.max(axis=1) - reach)
        fits = (radius.max(axis=1) < 0.95 * reach) & (radius.min(axis=1) > hole + 0.05 * reach)
        for store, values in zip(stores, (links, q, turn, shift), strict=True):
            store.append(values[fits])
        kept += int(fits.sum())
        if kept >= count:
            break
    else:
        raise InputError(f"path: no {count} random arms were found that reach all of it; a smaller path is accepted")
    arms, q, turn, shift = (np.concatenate(store)[:count] for store in stores)
    all_chains = Chains("RRR", chains.evaluator, arms, chains.limits)
    end = np.full(count, path.length)
    tracks = Placed(path, turn, shift, end)
    zero, tolerances = np.zeros(count), np.full(count, margin)
    logs = [follow_many(all_chains, tracks, q, zero, tolerances, method, most) for method in methods]
    return Loops(
        methods,
        margin,
        np.stack([log.updates for log in logs], axis=1),
        np.stack([log.status == FINISHED for log in logs], axis=1),
    )
