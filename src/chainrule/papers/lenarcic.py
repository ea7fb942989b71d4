"""J. Lenarcic, self-motion curves of a planar 3R arm: the regions, the lengths, the method, and what the paper claims.

The paper's values are typed here as the paper prints them; ours come from public functions.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from chainrule.arm import Arm, planar_3r
from chainrule.derive import catalogue, planar
from chainrule.derive.program import closed_form
from chainrule.loading import load
from chainrule.papers import Row, claim, compared, shown_equal
from chainrule.self_motions.eigenvector import eigenvector
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.maps import self_motion_map
from chainrule.self_motions.planar_3r import singular_radii, singular_values
from chainrule.self_motions.result import SelfMotion

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]

BEFORE, METHOD, FIRST, SECOND, OUTLOOK = "section 1", "section 2", "section 3.1", "section 3.2", "section 4"
LENGTHS, CURVES = "section 3.1, figure 2", "section 3.1, figure 3"
BORDERS, PLANE = "section 3.2, figure 4", "section 3.2, figure 5"
#: A value of px in each of the regions A to D of section 3.1, m.
INSIDE = {"A": 0.1, "B": 0.25, "C": 0.4, "D": 0.7}


#: Directions of a target, as complex numbers.
TURNS = tuple(np.exp(1j * np.array([0.0, 0.4, 2.0, 3.9])))


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """Every region, number, length and claim of the paper."""
    arm = load("lenarcic_3r")
    progress("self-motion: the kinematics")
    found = [*_kinematics(arm), _one_or_two()]
    progress("self-motion: the regions of the first example")
    found += [*_borders(arm), *_numbers(arm), *_signs(arm), *_lengths(arm), *_special(arm)]
    progress("self-motion: the second example")
    found += _second(arm)
    progress("self-motion: the paper's method")
    found += _method(arm)
    progress("self-motion: arms in space, limits, slides")
    found += [*_anthropomorphic(), *_outlook(arm)]
    return tuple(found)


def _at(arm: Arm, x: float, task: str = "position", other: float = 0.0) -> SelfMotion:
    return self_motion(arm, [x, other], task=task)


# ---- sections 2 and 3: the arm -----------------------------------------------------------------------------------


def _kinematics(arm: Arm) -> list[Row]:
    symbolic = catalogue.symbolic(arm.description.model)
    q1, q2, q3 = symbolic.inputs[0].symbols
    d1, d2, d3 = symbolic.inputs[1].symbols
    tip = closed_form(planar.placement(symbolic, "position"))["position"]
    printed = [d1 * turn(q1) + d2 * turn(q1 + q2) + d3 * turn(q1 + q2 + q3) for turn in (sp.cos, sp.sin)]
    same = all(sp.expand(sp.expand_trig(mine - theirs)) == 0 for mine, theirs in zip(tip, printed, strict=True))
    q = np.random.default_rng(0).uniform(-math.pi, math.pi, (1000, 3))
    jacobian = np.asarray(arm.jacobian(q))
    null = np.asarray(arm.null_vector(q))
    projector = np.eye(3) - np.linalg.pinv(jacobian) @ jacobian
    moved = float(np.abs(jacobian @ projector).max())
    values, vectors = np.linalg.eigh(jacobian.mT @ jacobian)
    unit = null / np.linalg.norm(null, axis=-1, keepdims=True)
    turned = float(np.abs(np.abs((vectors[..., 0] * unit).sum(axis=-1)) - 1.0).max())
    rank = np.linalg.matrix_rank(projector, tol=1e-6)
    straight = np.asarray(arm.jacobian([0.3, 0.0, 0.0]))
    spare = arm.n - int(np.linalg.matrix_rank(straight))
    how = "load('lenarcic_3r').jacobian(q), .null_vector(q)"
    return [
        shown_equal(
            "equations (19), (20)", "px and py", "sums of d cos and d sin", same, "derive.planar.placement(arm)"
        ),
        claim(
            "equations (4) to (6)",
            "J N = 0 with N = I - J⁺J",
            "stated",
            f"to {moved:.0g} at 1000 random postures",
            moved < 1e-12,
            how,
        ),
        claim(
            "equation (7)",
            "D = rank(N) = n - rank(J)",
            "1, more at a singularity",
            f"{', '.join(map(str, sorted(set(rank.tolist()))))}; {spare} where the links are in line",
            bool((rank == 1).all()) and spare == 2,
            how,
        ),
        claim(
            "equation (10)",
            "e is the eigenvector of JᵀJ of the eigenvalue zero",
            "stated",
            f"the null vector, to {turned:.0g}; eigenvalue below {values[..., 0].max():.0g} m²",
            turned < 1e-9 and float(values[..., 0].max()) < 1e-14,
            how,
        ),
    ]


def _one_or_two() -> Row:
    rng = np.random.default_rng(0)
    most = 0
    for lengths in rng.uniform(0.1, 1.0, (200, 3)):
        targets = rng.uniform(-1.0, 1.0, (200, 2)) * lengths.sum()
        most = max(most, int(self_motion_map(lengths, targets).number.max()))
    return claim(
        "abstract",
        "curves for a target within reach",
        "one or two",
        f"at most {most}, for 200 targets of each of 200 random arms",
        most == 2,
        "self_motion_map(lengths, targets).number",
    )


# ---- section 3.1: px and py --------------------------------------------------------------------------------------


def _borders(arm: Arm) -> list[Row]:
    radii = singular_radii(arm.parameters)
    how = "singular_radii([0.40, 0.35, 0.25])"
    names = ("a = -d1 + d2 + d3", "b = d1 - d2 + d3", "c = d1 + d2 - d3", "d = d1 + d2 + d3")
    found = [
        compared(LENGTHS, name, printed, float(radius), how, unit=" m")
        for name, printed, radius in zip(names, ("0.2", "0.3", "0.5", "1.0"), radii, strict=True)
    ]
    reordered = np.array([singular_radii(row) for row in ([0.25, 0.4, 0.35], [0.35, 0.25, 0.4])])
    same = bool(np.abs(reordered - radii).max() < 1e-15)
    found.append(
        claim(
            FIRST,
            "the order a < b < c < d",
            "of the formulas as printed",
            "the same four radii in every order of the links" if same else "other radii",
            same,
            how,
            "as printed the order holds for d1 > d2 > d3 only; with the links sorted L >= M >= S the radii are "
            "|M + S - L|, L - M + S, L + M - S and L + M + S",
            "true under a condition",
        )
    )
    return found


def _numbers(arm: Arm) -> list[Row]:
    found = []
    for region, printed in zip("ABCD", (2, 1, 2, 1), strict=True):
        motion = _at(arm, INSIDE[region])
        how = f"self_motion(load('lenarcic_3r'), [{INSIDE[region]:g}, 0]).count"
        found.append(compared(CURVES, f"closed curves in region {region}", str(printed), float(motion.count), how))
    a, c = (_at(arm, INSIDE[region]).components for region in "AC")
    gaps = [abs(pair[0].length - pair[1].length) for pair in (a, c)]
    mirrored = max(_mirror_error(pair) for pair in (a, c))
    found.append(
        claim(
            FIRST,
            "the two curves in regions A and C",
            "identical",
            f"mirror images: lengths differ by {max(gaps):.1g} rad, points by {mirrored:.1g} rad",
            max(gaps) < 1e-10 and mirrored < 1e-9,
            "self_motion(...).components",
            "they are different curves, q and -q about the direction of the target; their lengths are identical",
            "true under a condition",
        )
    )
    return found


def _mirror_error(pair: Sequence[Any]) -> float:
    """How far the points of one curve, mirrored, are from the other curve, modulo whole turns."""
    mirrored = -pair[0].at(np.linspace(0.0, 1.0, 16, endpoint=False))
    dense = pair[1].at(np.linspace(0.0, 1.0, 4001))
    gap = np.abs(np.remainder(mirrored[:, None] - dense[None] + math.pi, 2 * math.pi) - math.pi).max(axis=-1)
    best = gap.argmin(axis=1) / 4000.0
    step = 1.0 / 4000.0
    for _ in range(12):  # closer and closer around the nearest point
        s = best[:, None] + np.linspace(-step, step, 41)
        gap = np.abs(np.remainder(mirrored[:, None] - pair[1].at(s) + math.pi, 2 * math.pi) - math.pi).max(axis=-1)
        best, step = s[np.arange(len(s)), gap.argmin(axis=1)], step / 10.0
    return float(gap.min(axis=1).max())


def _signs(arm: Arm) -> list[Row]:
    found = []
    for region, printed, both in (("A", "q3", ("q2", "q3")), ("C", "q2", ("q1-direction", "q2"))):
        kept = [dict(component.signs) for component in _at(arm, INSIDE[region]).components]
        opposite = all(kept[0].get(name, 0) * kept[1].get(name, 0) == -1 for name in both)
        words = "q2 and q3" if region == "A" else "q2 and of q1 relative to the target's direction"
        found.append(
            claim(
                FIRST,
                f"what cannot change sign in region {region}",
                printed,
                words if opposite else str(kept),
                opposite,
                f"self_motion(load('lenarcic_3r'), [{INSIDE[region]:g}, 0]).components[0].signs",
                "the paper names one of the two",
                "true under a condition",
            )
        )
    free = [dict(_at(arm, INSIDE[region]).components[0].signs) for region in "BD"]
    both_ways = all("q2" not in kept and "q3" not in kept for kept in free)
    found.append(
        claim(
            FIRST,
            "regions B and D",
            "free to pass from one group to another",
            "no joint keeps its sign" if both_ways else str(free),
            both_ways,
            "self_motion(...).components[0].signs",
        )
    )
    return found


def _lengths(arm: Arm) -> list[Row]:
    borders = singular_radii(arm.parameters)[:3]
    beside = np.stack([borders - 1e-9, borders + 1e-9], axis=-1)
    targets = np.stack([beside, np.zeros_like(beside)], axis=-1)
    found = self_motion_map(arm, targets)
    single, total = found.length, found.total
    ratio = np.maximum(single[:, 0], single[:, 1]) / np.minimum(single[:, 0], single[:, 1])
    jump = float(np.abs(total[:, 0] - total[:, 1]).max())
    halves = bool(np.all(np.abs(ratio - 2.0) < 1e-3))
    slopes = [_exponent(arm, float(border)) for border in borders]
    how = "self_motion_map(arm, targets).length and .total"
    return [
        claim(
            FIRST,
            "one curve of length s splits into two",
            "of lengths s/2",
            f"in the limit: ratios {', '.join(f'{r:.4f}' for r in ratio)} at 1e-9 m from a, b, c",
            halves,
            how,
        ),
        claim(
            LENGTHS,
            "discontinuity of the function s",
            "at a, b and c",
            f"only of the single curve's: the total changes by {jump:.1g} rad over 2e-9 m",
            jump < 1e-3,
            how,
            "for the curve that the arm is on; the length of all curves together is continuous",
            "true under a condition",
        ),
        claim(
            LENGTHS,
            "s is steep beside a, b and c",
            "drawn",
            f"s(a) - s grows with the distance to the power {', '.join(f'{p:.2f}' for p in slopes)}",
            all(0.4 < p < 0.6 for p in slopes),
            how,
            "a cusp like a square root: where two branches meet at an angle, the way round the corner is cut off",
        ),
    ]


def _exponent(arm: Arm, border: float) -> float:
    """The power of the distance from a border with which the total length falls."""
    gaps = np.array([4e-8, 1e-8, 0.0])
    total = self_motion_map(arm, np.stack([border + gaps, np.zeros(3)], axis=-1)).total
    return float(np.log((total[2] - total[0]) / (total[2] - total[1])) / math.log(4.0))


def _special(arm: Arm) -> list[Row]:
    crossing = self_motion(arm, [float(singular_radii(arm.parameters)[1]), 0.0])
    ways = sorted(_at(arm, 0.7 * turn.real, other=0.7 * turn.imag).length for turn in TURNS)
    equal = singular_radii([0.3, 0.3, 0.3])  # equal radii once
    collapsed = equal.shape == (2,) and bool(np.abs(equal - (0.3, 0.9)).max() < 1e-15)
    bent = self_motion_map([0.3, 0.3, 0.3], [[0.2, 0.0], [0.6, 0.0]])
    base = self_motion(arm, [0.0, 0.0])
    winding = base.components[0].winding if base.components else np.zeros(3)
    scaled = [_at(a, f * 0.7).length for f, a in ((1.0, arm), (3.0, planar_3r(1.2, 1.05, 0.75)))]
    return [
        claim(
            "section 2, end",
            "a singular configuration is a cross of self-motion curves",
            "stated",
            f"at b: {crossing.detail}",
            crossing.status == "singular" and crossing.detail == "figure of eight",
            "self_motion(arm, [singular_radii(arm.parameters)[1], 0]).detail",
        ),
        claim(
            "section 3",
            "s depends on the distance of the target alone",
            "stated",
            f"s = {ways[0]:.12g} rad at 0.7 m in {len(ways)} directions, to {ways[-1] - ways[0]:.0g}",
            ways[-1] - ways[0] < 1e-9,
            "self_motion(load('lenarcic_3r'), [x, y]).length",
        ),
        claim(
            FIRST,
            "equal links",
            "two pairs of points collapse into two points",
            f"a = b = c = {equal[0]:g} m, d = {equal[-1]:g} m; {bent.number[0]} curves below a, {bent.number[1]} above",
            collapsed and bent.number.tolist() == [2, 1],
            "singular_radii([0.3, 0.3, 0.3])",
            "three of the four radii fall into one, the fourth stays; the two regions left are as the paper says",
            "misprint",
        ),
        claim(
            FIRST,
            "px = 0",
            "left out: region A is (0, a) and (-a, 0)",
            f"{base.status}: {base.count} curves, joint 1 turns {abs(int(winding[0]))} time",
            base.status == "regular" and base.count == 2 and abs(int(winding[0])) == 1,
            "self_motion(load('lenarcic_3r'), [0, 0])",
            "region A is (-a, a): at 0 joint 1 turns freely, the other two keep their angles, and nothing is singular",
            "misprint",
        ),
        claim(
            SECOND,
            "a change of the arm's size",
            "does not change the curves and s",
            f"s = {scaled[0]:.12g} and {scaled[1]:.12g} rad at three times the size",
            abs(scaled[0] - scaled[1]) < 1e-9,
            "self_motion(planar_3r(1.2, 1.05, 0.75), [2.1, 0]).length",
        ),
    ]


# ---- section 3.2: px and the orientation -------------------------------------------------------------------------


def _second(arm: Arm) -> list[Row]:
    values = singular_values(arm.parameters, 0.0)
    how = "singular_values([0.40, 0.35, 0.25], 0)"
    printed = (("b' = -d1 - d2 + d3", "-0.5"), ("a' = -d1 + d2 + d3", "0.2"), ("a = d1 - d2 + d3", "0.3"), ("b", "1.0"))
    found = [
        compared(BORDERS, name, text, float(value), how, unit=" m")
        for (name, text), value in zip(printed, values, strict=True)
    ]
    for region, x, count in (("A", 0.28, 2), ("B", 0.6, 1)):
        motion = _at(arm, x, "x_alpha")
        call = f"self_motion(load('lenarcic_3r'), [{x:g}, 0], task='x_alpha').count"
        found.append(compared(PLANE, f"closed curves in region {region}", str(count), float(motion.count), call))
    turned = 0.7
    shifted = singular_values(arm.parameters, turned)
    middle = float(shifted.mean())
    right = abs(middle - 0.25 * math.cos(turned)) < 1e-15
    found.append(
        claim(
            SECOND,
            "centre of symmetry",
            "px = d3",
            f"px = d3 cos(pα): {middle:.6f} m at pα = {turned} rad",
            right,
            "singular_values([0.40, 0.35, 0.25], 0.7).mean()",
            "d3 for pα = 0 only",
            "true under a condition",
        )
    )
    kept = [dict(c.signs) for c in _at(arm, 0.28, "x_alpha").components]
    other = [dict(c.signs) for c in self_motion(planar_3r(0.35, 0.40, 0.25), [0.28, 0.0], task="x_alpha").components]
    swapped = "q1" in kept[0] and "q1" not in other[0] and len(other[0]) > 0
    found.append(
        claim(
            SECOND,
            "what cannot change sign in region A",
            "q1",
            f"q1 for d1 > d2; {' and '.join(other[0])} for d1 < d2",
            swapped,
            "self_motion(planar_3r(0.35, 0.40, 0.25), [0.28, 0], task='x_alpha').components[0].signs",
            "the longer of the first two links keeps to one side",
            "true under a condition",
        )
    )
    sums = [c.at(np.linspace(0, 1, 100)).sum(axis=1) for c in _at(arm, 0.6, "x_alpha").components]
    flat = max(float(np.ptp(s)) for s in sums)
    found.append(
        claim(
            PLANE,
            "all curves lie in one plane",
            "yes",
            f"q1 + q2 + q3 varies by {flat:.1g} rad",
            flat < 1e-12,
            "self_motion(...).components[0].at(s).sum(axis=1)",
        )
    )
    return found


# ---- section 2: the method ---------------------------------------------------------------------------------------


def _method(arm: Arm) -> list[Row]:
    motion = _at(arm, INSIDE["D"])
    (curve,) = motion.components
    began = time.perf_counter()
    run = eigenvector(arm, curve.q[0], gamma=0.001)
    taken = 1000.0 * (time.perf_counter() - began)
    error = abs(run.length - curve.length) / curve.length
    found = [
        claim(
            METHOD,
            "the wrap (13), (14)",
            "q > 2π: -2π, q < 2π: +2π",
            "q > π: -2π, q < -π: +2π",
            run.status == "closed" and abs(float(np.abs(run.q[-1]).max())) < 20.0,
            "eigenvector(arm, q0)",
            "as printed every angle below 2π would gain a turn at every step; the interval meant is (-π, π]",
            "misprint",
        ),
        claim(
            METHOD,
            "error of the length, γ = 0.001",
            "smaller than 0.1 %",
            f"{100 * error:.3f} % at px = 0.7, tip off by up to {1000 * run.drift:.2g} mm",
            error < 1e-3,
            "eigenvector(arm, q0, gamma=0.001)",
            "the closed form gives the length to 1e-10",
        ),
    ]
    found.append(
        claim(
            "section 2, section 4",
            "time for a curve with an error below 0.1 %",
            "a few tens of a millisecond",
            f"{taken:.0f} ms here with the method, in Python",
            run.status == "closed",
            "eigenvector(arm, q0, gamma=0.001)",
            "neither the computer, nor the program, nor the curve is named",
            "not reproducible",
        )
    )
    start = _at(arm, INSIDE["B"]).components[0].q[0]
    coarse = eigenvector(arm, start, gamma=0.02, k0=5)
    fine = eigenvector(arm, start, gamma=0.001, k0=5)
    growth = coarse.drift / fine.drift
    found.append(
        claim(
            METHOD,
            "the error depends linearly on γ and the length",
            "in the first approximation",
            f"the tip's error grows {growth:.0f}-fold from γ = 0.001 to 0.02",
            10.0 < growth < 40.0,
            "eigenvector(arm, q0, gamma=...).drift",
        )
    )
    near = _at(arm, 0.5001).components[0]
    bad = eigenvector(arm, near.q[0], gamma=0.001, steps=3 * int(near.length / 0.001))
    far = abs(bad.length - near.length) / near.length
    lost = bad.status != "closed" or far > 0.01
    found += [
        claim(
            METHOD,
            "the error of closure",
            "never exceeded 5γ",
            f"{bad.status}, {bad.closure / 0.001:.0f}γ after {bad.length / near.length:.2f} times the curve's length",
            lost,
            "eigenvector(arm, q0) at px = 0.5001",
            "away from singular targets; stopping within 5γ is also how the method ends, so that it can show no more",
            "true under a condition",
        ),
        claim(
            METHOD,
            "close to a singularity",
            "quite robust",
            f"at px = 0.5001 it {'does not return' if bad.status != 'closed' else 'returns on another branch'}: "
            f"{bad.length:.4g} rad instead of {near.length:.4g}",
            lost,
            "eigenvector(arm, q0) at px = 0.5001",
            "where branches are farther apart than the drift; continuation with a guard follows the right one",
            "true under a condition",
        ),
    ]
    return found


# ---- sections 1 and 4 --------------------------------------------------------------------------------------------


def anthropomorphic_4r() -> Arm:
    """A shoulder of three axes through one point, and an elbow: four joints that position the wrist.

    Example:
        >>> anthropomorphic_4r().kinds
        'RRRR'
    """
    quarter = math.pi / 2
    rows = [("R", 0.0, 0.0, 0.0, 0.0), ("R", -quarter, 0.0, 0.0, 0.0), ("R", quarter, 0.0, 0.4, 0.0)]
    return Arm.from_dh([*rows, ("R", -quarter, 0.0, 0.0, 0.0)], name="anthropomorphic_4r", tool=(0.35, 0.0, 0.0))


#: Postures whose wrist is the target, and for arms with seven joints those of the other three.
POSTURES = ((0.3, 0.8, 0.4, 1.2), (-1.0, 0.6, 2.0, 2.1), (2.0, -1.1, -0.7, 0.5), (0.9, 1.4, -2.2, -1.6))
WRIST = (0.4, 0.9, -0.6)


def _anthropomorphic() -> list[Row]:
    arm, long = anthropomorphic_4r(), load("iiwa14")
    four = [self_motion(arm, arm.position(q), task="position") for q in POSTURES]
    eight = [self_motion(long, long.pose([*q, *WRIST])) for q in POSTURES]
    numbers = sorted({motion.count for motion in four})
    many = sorted({motion.count for motion in eight})
    whole = all(motion.complete == "proved" for motion in eight)
    return [
        claim(
            BEFORE,
            "curves of a 4R anthropomorphic arm that positions its wrist",
            "eight",
            f"{' or '.join(map(str, numbers))} at {len(four)} targets; {' or '.join(map(str, many))} for the pose of "
            "a 7R arm (iiwa14)",
            numbers == [4] and many == [8] and whole,
            "self_motion(anthropomorphic_4r(), target, task='position').count",
            "the elbow bends to either side, and so does the shoulder's middle joint: four curves, each once round the "
            "line from shoulder to wrist. Eight is the number of the pose task, where the wrist's middle joint adds "
            "its two sides (found from 64 starts for 4R, proved for 7R)",
            "misprint",
        ),
    ]


def _outlook(arm: Arm) -> list[Row]:
    limited = arm.with_limits(position=[(-2.0, 2.0)] * 3)
    motion = self_motion(limited, [INSIDE["C"], 0.0], limits=True)
    arcs = motion.feasible or ()
    slide, scaled = self_motion_slide(), self_motion_slide(0.5)
    ratio = scaled.length / slide.length
    return [
        claim(
            "abstract",
            "a manipulator possessing joint limits",
            "the joint angles are unlimited (section 3)",
            f"{len(arcs)} feasible arcs of {sum(c.length for c in arcs):.4g} rad in all, with joints within ±2 rad",
            len(arcs) > 0,
            "self_motion(arm.with_limits(...), [0.4, 0], limits=True).feasible",
            "the paper gives no limits and treats none",
            "not reproducible",
        ),
        claim(
            OUTLOOK,
            "revolute and translational joints together",
            "problematic: the length depends on a scaling factor",
            f"a PRR arm: {slide.length:.6g} rad at 1 m per rad, {scaled.length:.6g} rad at 0.5 m per rad",
            slide.count == scaled.count > 0 and ratio > 1.01,
            "self_motion(planar('PRR', ...), target, scale=0.5)",
            "the curve itself does not depend on the factor, which is stated with the length",
        ),
    ]


def self_motion_slide(scale: float = 1.0) -> SelfMotion:
    """The self-motion of an arm with a slide, at one target; ``scale`` m count as one radian.

    Example:
        >>> self_motion_slide().status
        'regular'
    """
    from chainrule.arm import planar

    return self_motion(planar("PRR", [0.2, 0.35, 0.25]), [0.4, 0.3], scale=scale)


def figures() -> dict[str, Figure]:
    """Figures 2 to 5: lengths over px, and curves in joint space, for both tasks."""
    from chainrule.plot.self_motion import draw_curves, draw_lengths

    arm = load("lenarcic_3r")
    return {
        "figure-2": draw_lengths(arm, "position"),
        "figure-3": draw_curves(arm, list(INSIDE.values()), "position"),
        "figure-4": draw_lengths(arm, "x_alpha"),
        "figure-5": draw_curves(arm, [0.28, 0.45, 0.6, 0.8], "x_alpha"),
    }
