"""Whether an arm with six revolute joints can change its posture without a singularity: a search for a witness.

An arm is cuspidal if two of its inverse solutions for one pose are joined by a path on which det J is never zero
(P. Wenger 1992, for 6R arms A. J. Elias and J. T. Wen, "Path planning and optimization for cuspidal 6R manipulators",
2025). One such path settles the question. It is looked for among random poses: all inverse solutions, pairs of them
in one component of a roadmap of the nonsingular joint space, the shortest way between them, made short and smooth.

What is found is then proved in ball arithmetic, with the generated functions that users run:
    the sign of det J is constant on every point of the path, not on samples of it;
    next to its end there is exactly one configuration of exactly the pose of its start (Krawczyk's test);
    det J keeps its sign on the way there, too, some 1e-15 rad.

A search that finds nothing proves nothing: the answer is then "no witness in N tries", never "not cuspidal".
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.balls import Minors, minors_on_balls
from chainrule.certificate import used_joints
from chainrule.cuspidality.certified_path import SignProof, bezier, certify_sign, sample
from chainrule.cuspidality.inverse import STARTS, six_joints, size, solutions_from
from chainrule.cuspidality.pose_proof import neighbour
from chainrule.cuspidality.roadmap import MARGIN, JointSpace, Roadmap, roadmap
from chainrule.cuspidality.smooth import lowest, shortened, smoothed
from chainrule.errors import InputError
from chainrule.goals import wrapped
from chainrule.inputs import real_array, whole_number
from chainrule.search import box, turns_freely

Array = NDArray[Any]
TURN = 2.0 * math.pi

#: Poses looked at when no number is given, configurations of the roadmap, and pairs of one pose that are tried.
TRIES, NODES, PAIRS = 200, 8000, 6
#: Control points of the splines tried, the smoothest first.
CONTROL_POINTS = (16, 32, 64)
#: Share of the least |det J| seen by samples that the proved lower bound is to reach.
PROVED = 0.5


@dataclass(frozen=True)
class Witness:
    """What the search for a change of posture without a singularity found.

    Attributes:
        found: whether there is a path. If not, the arm may still be cuspidal.
        tries: how many poses were looked at.
        poses: at how many of them two or more solutions away from singularities had one sign of det J.
        pose: (4, 4) of the tip at both ends; None without a path, like all that follows.
        start: (6,) rad, the first configuration of the path.
        goal: (6,) rad, the last; its angles are those of another inverse solution up to whole turns.
        path: (k, 6) rad, the control points of a B-spline, unwrapped; what :meth:`sample` evaluates.
        degree: of the spline: 3, or 1 for a polyline.
        solutions: (m, 6) rad, all inverse solutions met at this pose, each angle in (-pi, pi].
        certified: whether the proof described above was carried out; true wherever ``found`` is.
        sign: of det J along the path; 0 without one.
        smallest_determinant: a proved lower bound of |det J| along the path, m^3; 0 without one.
        typical_determinant: the median of |det J| over the joint space, to compare it with.
        pieces: into how many pieces the proof cut the path.
        words: the answer in one line.
    """

    found: bool
    tries: int
    poses: int
    pose: Array | None
    start: Array | None
    goal: Array | None
    path: Array | None
    degree: int
    solutions: Array | None
    certified: bool
    sign: int
    smallest_determinant: float
    typical_determinant: float
    pieces: int
    words: str

    def sample(self, s: Any, derivative: int = 0) -> Array:
        """The configurations (..., 6) of the path at ``s`` (...) from 0 to 1, or their derivative by s.

        Raises:
            InputError: there is no path; ``s`` outside 0 to 1; a derivative that is not 0, 1 or 2.
        """
        if self.path is None:
            raise InputError(f"there is no path to sample: {self.words}")
        given = real_array(s, "s")
        if ((given < 0.0) | (given > 1.0)).any():
            raise InputError("s: from 0 to 1 is accepted")
        if derivative not in (0, 1, 2):
            raise InputError(f"derivative: {derivative!r}; 0, 1 or 2 is accepted")
        return sample(self.path, self.degree, given, derivative)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        arrays = {name: getattr(self, name) for name in ("pose", "start", "goal", "path", "solutions")}
        return {
            "found": self.found,
            "tries": self.tries,
            "poses": self.poses,
            **{name: None if array is None else array.tolist() for name, array in arrays.items()},
            "degree": self.degree,
            "certified": self.certified,
            "sign": self.sign,
            "smallest_determinant": self.smallest_determinant,
            "typical_determinant": self.typical_determinant,
            "pieces": self.pieces,
            "words": self.words,
        }


def posture_change_witness(
    arm: Arm,
    *,
    tries: int = TRIES,
    seed: int = 0,
    limits: bool = False,
    starts: int = STARTS,
    progress: Callable[[str], None] = lambda line: None,
) -> Witness:
    """Look for two inverse solutions of one pose that a path without a singularity joins, and prove the path.

    The search ends at the first path that is proved, or after ``tries`` poses, or when it is interrupted (Ctrl-C), with
    what was looked at until then. The same seed gives the same answer.

    Args:
        arm: six revolute joints.
        tries: how many random poses are looked at.
        seed: of the poses, the roadmap and the starts of the inverse solutions.
        limits: keep all of the path inside the arm's position limits; otherwise every joint turns freely.
        starts: how many starts the search for inverse solutions has at each pose.
        progress: called with a line for each step.

    Raises:
        InputError: another kind of arm; numbers that are not whole or too small.

    Example:
        >>> from chainrule import load
        >>> witness = posture_change_witness(load("gofa5"))
        >>> witness.found, witness.certified, witness.path.shape
        (True, True, (16, 6))
        >>> posture_change_witness(load("puma560"), tries=5).words
        'no witness in 5 tries; this does not prove that there is none'
    """
    six_joints(arm)
    whole_number(tries, "tries")
    whole_number(seed, "seed", 0)
    whole_number(starts, "starts")
    minors = minors_on_balls(arm, "pose")
    assert minors is not None  # a 6 x 6 Jacobian has one minor
    done = poses = 0
    space = joint_space(arm, minors, limits)
    if space is None:
        return _nothing(0, 0, 0.0, "det J vanishes at every configuration looked at: the arm has no regular posture")
    try:
        progress(f"a roadmap of {NODES} configurations")
        found = _Search(arm, minors, space, roadmap(space, seed, NODES), limits)
        length, ranges = size(arm), np.stack([space.lower, space.upper], axis=-1)
        for done in range(1, tries + 1):
            rng = np.random.default_rng([seed, done])
            q = rng.uniform(ranges[:, 0], ranges[:, 1])
            target = arm.pose(q)
            solutions = solutions_from(arm, target, rng.uniform(-math.pi, math.pi, (starts, 6)), length)
            regular = solutions[np.abs(space.determinant(solutions)) > MARGIN * space.scale]
            positive = int((space.determinant(regular) > 0.0).sum())
            poses += max(positive, len(regular) - positive) > 1
            progress(f"pose {done} of {tries}: {len(solutions)} inverse solutions")
            for control, degree, proof in found.paths(regular):
                words = (
                    f"cuspidal: two inverse solutions are joined by a proved path without a singularity (try {done})"
                )
                return Witness(
                    True,
                    done,
                    poses,
                    arm.pose(control[0]),
                    control[0],
                    control[-1],
                    control,
                    degree,
                    solutions,
                    True,
                    proof.sign,
                    proof.lower_bound,
                    space.scale,
                    proof.pieces,
                    words,
                )
    except KeyboardInterrupt:
        done = max(done - 1, 0)
        return _nothing(done, poses, space.scale, f"stopped; {_no_witness(done)}")
    return _nothing(done, poses, space.scale, _no_witness(done))


def _no_witness(tries: int) -> str:
    return f"no witness in {tries} {'try' if tries == 1 else 'tries'}; this does not prove that there is none"


def _nothing(tries: int, poses: int, scale: float, words: str) -> Witness:
    return Witness(False, tries, poses, None, None, None, None, 0, None, False, 0, 0.0, scale, 0, words)


def joint_space(arm: Arm, minors: Minors, limits: bool) -> JointSpace | None:
    """Where the joints may be; None where det J is zero to rounding at all of many random configurations."""
    ranges = box(arm) if limits else np.tile([-math.pi, math.pi], (6, 1))
    free = turns_freely(arm) if limits else np.full(6, True)
    used = used_joints(minors, 6)
    q = np.random.default_rng(0).uniform(ranges[:, 0], ranges[:, 1], (4096, 6))
    scale = float(np.median(np.abs(arm.minors(q, task="pose")[..., 0])))
    if not used or scale <= 1e-12 * size(arm) ** 3:
        return None
    return JointSpace(arm, ranges[:, 0], ranges[:, 1], free, used, scale)


@dataclass(frozen=True)
class _Search:
    """From the inverse solutions of a pose to proved paths between them."""

    arm: Arm
    minors: Minors
    space: JointSpace
    roadmap: Roadmap
    limits: bool

    def paths(self, solutions: Array) -> Iterator[tuple[Array, int, SignProof]]:
        """Proved paths between two of the solutions (k, 6): control points, degree and proof; the shortest ways first."""
        postures, which = self._inside(solutions)
        if len(set(which.tolist())) < 2:
            return
        edges, lengths, component = self.roadmap.connect(postures)
        pairs = [
            (i, j)
            for j in range(len(postures))
            for i in range(j)
            if which[i] != which[j] and component[i] == component[j] >= 0
        ]
        ways = self.roadmap.ways(postures, pairs, (edges, lengths))
        for via in sorted(ways, key=lambda way: float(np.linalg.norm(np.diff(way, axis=0), axis=-1).sum()))[:PAIRS]:
            yield from self._proved(via)

    def _inside(self, solutions: Array) -> tuple[Array, Array]:
        """The solutions with the whole turns that the limits allow, and of which solution each is."""
        low, high, free = self.space.lower, self.space.upper, self.space.free
        found, which = [], []
        for k, q in enumerate(solutions):
            choices = []
            for j in range(6):
                first = math.ceil((low[j] - q[j]) / TURN)
                last = math.floor((high[j] - q[j]) / TURN)
                choices.append([q[j]] if free[j] else [q[j] + TURN * turn for turn in range(first, last + 1)])
            for choice in product(*choices):
                found.append(np.clip(choice, low, high) if not free.all() else np.array(choice))
                which.append(k)
        return np.array(found).reshape(-1, 6), np.array(which, int)

    def _proved(self, via: Array) -> Iterator[tuple[Array, int, SignProof]]:
        """At most one proved path along the way via (k, 6)."""
        bounds = np.tile([-np.inf, np.inf], (6, 1))
        if self.limits:
            bounds = np.where(self.space.free[:, None], bounds, np.stack([self.space.lower, self.space.upper], axis=-1))
        short = shortened(self.space, via)
        for control, degree in self._candidates(via, short, bounds):
            proof = prove_path(self.arm, self.minors, control, degree, PROVED * lowest(self.space, control, degree))
            if proof.certified:
                yield control, degree, proof
                return

    def _candidates(self, via: Array, short: Array, bounds: Array) -> Iterator[tuple[Array, int]]:
        """Control points and degrees of what may be proved, the smoothest first."""
        for count in CONTROL_POINTS:
            yield smoothed(self.space, short, bounds, count), 3
        yield short, 1
        yield via, 1


def prove_path(arm: Arm, minors: Minors, control: Array, degree: int, at_least: float = 0.0) -> SignProof:
    """The proof that a B-spline joins two inverse solutions of one pose without a singularity, or one that says no.

    Args:
        arm: six revolute joints.
        minors: its minors on balls, :func:`chainrule.balls.minors_on_balls`.
        control: (k, 6) rad, the spline's control points.
        degree: of the spline.
        at_least: what the lower bound of |det J| is to exceed.
    """
    refused = SignProof(False, 0, 0.0, 0)
    if at_least < 0.0 or np.abs(wrapped(control[-1] - control[0])).max() < 1e-3:  # not another solution
        return refused
    end = neighbour(arm, control[0], control[-1])
    if end is None:
        return refused

    def determinant(q: Array) -> Array:
        found: Array = minors(q)[:, 0]
        return found

    path = certify_sign(determinant, bezier(control, degree), at_least=at_least)
    last = certify_sign(determinant, bezier(np.stack([control[-1], end]), 1))
    if not (path.certified and last.certified and path.sign == last.sign):
        return refused
    return SignProof(True, path.sign, min(path.lower_bound, last.lower_bound), path.pieces + last.pieces)
