"""Self-motion curves: Lenarcic's algorithm, an integrator that follows the tangent, and what chainrule does."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chainrule as cr
from benchmarks.measure import Disagreement
from benchmarks.planar import Way
from chainrule.self_motions.continuation import trace
from chainrule.self_motions.eigenvector import eigenvector
from chainrule.self_motions.maps import self_motion_map
from chainrule.self_motions.planar_3r import planar_lengths, planar_self_motion

Array = NDArray[Any]

#: The paper's arm, and a target in its region C: two curves of 8.238 rad each.
LENGTHS, TARGET = (0.40, 0.35, 0.25), (0.40, 0.0)
#: The paper's step, rad, and how many steps may bring it back (it asks for at least 5).
GAMMA, RETURN = 0.001, 5
#: How much slower the paper's algorithm and the integrator are meant to be than the closed form.
RATIO_PAPER, RATIO_TANGENT = 3000.0, 30.0
#: And how much slower the paper's algorithm is meant to be than the generated continuation.
RATIO_FOLLOWED = 500.0
#: Targets of a map, and the time it is meant to stay below, s.
MAPPED, MAP_S = 10_000, 1.0


def questions(batch: int) -> Iterator[tuple[str, list[Way], str]]:
    """Every question: its heading, the ways of answering it, and a note."""
    for accuracy in (1e-6, 1e-10):
        ways, note = planar_curve(accuracy)
        yield f"length of a planar 3R's self-motion curve, at {accuracy:.0e}", ways, note
    ways, note = generated_continuation()
    yield "one self-motion curve of a planar 3R followed from a start: length, points, box, range of H", ways, note
    ways, note = followed_loop()
    yield (
        "one self-motion loop of a Panda at a pose, followed from a start: length, points, box, range of H",
        ways,
        note,
    )
    ways, note = planar_map(min(batch, MAPPED))
    yield f"number, lengths and boxes of a planar 3R's self-motions; map of {min(batch, MAPPED):,} targets", ways, note


def planar_curve(accuracy: float) -> tuple[list[Way], str]:
    """One curve of the paper's arm. Beside ours, which gives the number and every length, one curve from one start."""
    arm = cr.planar_3r(*LENGTHS)
    whole = planar_self_motion(arm, TARGET)
    start, length = whole.components[0].q[0], whole.components[0].length

    def ours() -> float:
        return planar_lengths(arm, TARGET, accuracy=accuracy)[1][0]

    errors = [abs(found / length - 1.0) for found in (ours(), followed(start, accuracy), eigenvectors(start))]
    for who, error, allowed in zip(
        ("chainrule", "SciPy's DOP853", "the paper's algorithm"), errors, (accuracy, 10 * accuracy, 5e-3), strict=True
    ):
        if not error <= allowed:
            raise Disagreement(f"{who} is wrong by {error:.1e}")
    ways = [
        Way("chainrule, closed form: number and all lengths", 1, ours),
        Way("SciPy DOP853 along the tangent, one curve", 1, lambda: followed(start, accuracy), None, RATIO_TANGENT),
        Way("the paper's algorithm in NumPy, one curve", 1, lambda: eigenvectors(start), None, RATIO_PAPER),
        Way("chainrule, the curves too: points, boxes, range of H", 1, lambda: planar_self_motion(arm, TARGET)),
    ]
    mine, theirs, paper = errors
    note = (
        f"Self-motion curve at {accuracy:.0e}: ours is right to {max(mine, 1e-16):.0e}, DOP853 to {theirs:.0e}, the "
        f"paper's algorithm (step {GAMMA:g} rad) to {paper:.0e}."
    )
    return ways, note


def generated_continuation() -> tuple[list[Way], str]:
    """The generated kernel, which knows nothing of planar arms, on the same curve."""
    arm = cr.planar_3r(*LENGTHS)
    known = planar_self_motion(arm, TARGET).components[0]
    start = known.q[0]
    error = abs(trace(arm, start).length / known.length - 1.0)
    if not error <= 1e-9:
        raise Disagreement(f"a followed curve is wrong by {error:.1e}")
    ways = [
        Way("chainrule, continuation by the generated kernel", 1, lambda: trace(arm, start)),
        Way("the paper's algorithm in NumPy, length only", 1, lambda: eigenvectors(start), None, RATIO_FOLLOWED),
    ]
    return ways, f"Followed curve: right to {max(error, 1e-16):.0e}; the paper's algorithm steps by {GAMMA:g} rad."


def followed_loop() -> tuple[list[Way], str]:
    """A Panda's loop; the paper's algorithm takes J from our generated code and the eigenvector from NumPy."""
    panda, posture = cr.load("panda"), np.array([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4])
    error = abs(eigenvector(panda, posture).length / trace(panda, posture).length - 1.0)
    if not error <= 5e-3:
        raise Disagreement(f"the two lengths of a Panda's loop differ by {error:.1e}")
    ways = [
        Way("chainrule, continuation by the generated kernel", 1, lambda: trace(panda, posture)),
        Way("the paper's algorithm, the Panda's J", 1, lambda: eigenvector(panda, posture), None, RATIO_FOLLOWED),
    ]
    return ways, f"Panda's loop: the paper's algorithm differs by {error:.0e}."


def planar_map(count: int) -> tuple[list[Way], str]:
    """A map over the workspace: all at once, and target by target."""
    arm = cr.planar_3r(*LENGTHS)
    targets = np.random.default_rng(6).uniform(-1.0, 1.0, (count, 2))
    few = min(count, 200)

    def whole() -> tuple[Array, ...]:
        return (np.nan_to_num(self_motion_map(arm, targets).total),)

    def singly() -> tuple[Array, ...]:
        return (np.array([sum(planar_lengths(arm, target)[1]) for target in targets[:few]]),)

    whole()
    begun = time.process_time()
    whole()
    spent = time.process_time() - begun
    ways = [
        Way("chainrule, cr.self_motion_map", count, whole, whole),
        Way("chainrule, closed form, a loop in Python (no boxes)", few, singly, singly),
    ]
    verdict = "reached" if spent < MAP_S * count / MAPPED else "missed"
    goal = f"goal: below {MAP_S:g} s for {MAPPED:,}, {verdict}"
    return ways, f"Map of {count:,} targets: {spent:.2f} s of one core ({goal})."


# ---- one curve from one start, as one would write it ---------------------------------------------------------------


def eigenvectors(start: Array, gamma: float = GAMMA) -> float:
    """Lenarcic, equations (8) to (18): q += gamma e with e the null eigenvector of J^T J, wrapped as must be meant."""
    l1, l2, l3 = LENGTHS
    q, before, steps = start.copy(), None, 0
    jacobian = np.empty((2, 3))
    while True:
        a1, a2, a3 = np.cumsum(q)
        jacobian[0] = -l1 * math.sin(a1), -l2 * math.sin(a2), -l3 * math.sin(a3)
        jacobian[1] = l1 * math.cos(a1), l2 * math.cos(a2), l3 * math.cos(a3)
        jacobian[:, 1] += jacobian[:, 2]
        jacobian[:, 0] += jacobian[:, 1]
        e = np.linalg.eigh(jacobian.T @ jacobian)[1][:, 0]
        if before is not None and e @ before < 0.0:
            e = -e
        before = e
        q += gamma * e
        q[q > math.pi] -= 2.0 * math.pi
        q[q < -math.pi] += 2.0 * math.pi
        steps += 1
        if steps > RETURN and np.linalg.norm(wrapped(q - start)) < gamma * RETURN:
            return steps * gamma
        if steps > 100 / gamma:
            raise Disagreement("the paper's algorithm did not return")


def wrapped(angle: Array) -> Array:
    """Angles in [-pi, pi]."""
    found: Array = angle - 2.0 * math.pi * np.rint(angle / (2.0 * math.pi))
    return found


def tangent(_: float, q: Array) -> list[float]:
    """The unit null vector, written out in plain floats: quicker than NumPy for three numbers."""
    l1, l2, l3 = LENGTHS
    q2, q3 = float(q[1]), float(q[2])
    s12, s23, s13 = l1 * l2 * math.sin(q2), l2 * l3 * math.sin(q3), l1 * l3 * math.sin(q2 + q3)
    n1, n2, n3 = s23, -(s13 + s23), s12 + s13
    size = math.sqrt(n1 * n1 + n2 * n2 + n3 * n3)
    return [n1 / size, n2 / size, n3 / size]


def followed(start: Array, accuracy: float) -> float:
    """The length at which SciPy's DOP853 along the tangent comes back through the plane across the curve's start."""
    from scipy.integrate import solve_ivp

    first = np.array(tangent(0.0, start))

    def home(run: float, q: Array) -> float:
        if run == 0.0:
            return 1.0
        away = q - start
        near = float(np.sum(1.0 - np.cos(away))) < 0.1  # the start, perhaps some turns on
        return float(first @ np.sin(away)) if near else -1.0

    home.terminal, home.direction = True, 1.0  # type: ignore[attr-defined]
    found = solve_ivp(tangent, (0.0, 100.0), start, "DOP853", events=home, rtol=accuracy, atol=accuracy)
    if not found.t_events[0].size:
        raise Disagreement("DOP853 did not come back")
    return float(found.t_events[0][0])
