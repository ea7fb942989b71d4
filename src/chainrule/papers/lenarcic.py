"""J. Lenarcic, self-motion curves of a planar 3R arm: the regions, the lengths, the method, and what the paper claims.

The paper's values are typed here as the paper prints them; ours come from public functions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, load, planar_3r
from chainrule.papers import Row, claim, compared
from chainrule.self_motions.eigenvector import eigenvector
from chainrule.self_motions.face import self_motion
from chainrule.self_motions.maps import self_motion_map
from chainrule.self_motions.planar_3r import singular_radii, singular_values
from chainrule.self_motions.result import SelfMotion

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]

BEFORE, METHOD, FIRST, SECOND, OUTLOOK = "section 1", "section 2", "section 3.1", "section 3.2", "section 4"
#: A value of px in each of the regions A to D of section 3.1, m.
INSIDE = {"A": 0.1, "B": 0.25, "C": 0.4, "D": 0.7}


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """Every region, number, length and claim of the paper."""
    arm = load("lenarcic_3r")
    progress("self-motion: the regions of the first example")
    found = [*_borders(arm), *_numbers(arm), *_signs(arm), *_lengths(arm), *_special(arm)]
    progress("self-motion: the second example")
    found += _second(arm)
    progress("self-motion: the paper's method")
    found += _method(arm)
    progress("self-motion: arms in space, limits, slides")
    found += [*_anthropomorphic(), *_outlook(arm)]
    return tuple(found)


def _at(arm: Arm, x: float, task: str = "position", other: float = 0.0) -> SelfMotion:
    return self_motion(arm, [x, other], task=task)


# ---- section 3.1: px and py --------------------------------------------------------------------------------------


def _borders(arm: Arm) -> list[Row]:
    radii = singular_radii(arm.parameters)
    how = "singular_radii([0.40, 0.35, 0.25])"
    names = ("a = -d1 + d2 + d3", "b = d1 - d2 + d3", "c = d1 + d2 - d3", "d = d1 + d2 + d3")
    found = [
        compared(FIRST, name, printed, float(radius), how, unit=" m")
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
            "special case",
        )
    )
    return found


def _numbers(arm: Arm) -> list[Row]:
    found = []
    for region, printed in zip("ABCD", (2, 1, 2, 1), strict=True):
        motion = _at(arm, INSIDE[region])
        how = f"self_motion(load('lenarcic_3r'), [{INSIDE[region]:g}, 0]).count"
        found.append(compared(FIRST, f"closed curves in region {region}", str(printed), float(motion.count), how))
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
            "they are different curves, q and -q about the direction of the target; only their lengths are identical",
            "corrected",
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
                "special case",
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
            FIRST,
            "discontinuity of the function s",
            "at a, b and c",
            f"only of the single curve's: the total changes by {jump:.1g} rad over 2e-9 m",
            jump < 1e-3,
            how,
            "the length of all curves together is continuous",
            "corrected",
        ),
        claim(
            FIRST,
            "shape of the total length beside a, b and c",
            "not stated",
            f"s(a) - s grows with the distance to the power {', '.join(f'{p:.2f}' for p in slopes)}",
            all(0.4 < p < 0.6 for p in slopes),
            how,
            "a cusp like a square root: where two branches meet at an angle, the way round the corner is cut off",
            "refined",
        ),
    ]


def _exponent(arm: Arm, border: float) -> float:
    """The power of the distance from a border with which the total length falls."""
    gaps = np.array([4e-8, 1e-8, 0.0])
    total = self_motion_map(arm, np.stack([border + gaps, np.zeros(3)], axis=-1)).total
    return float(np.log((total[2] - total[0]) / (total[2] - total[1])) / math.log(4.0))


def _special(arm: Arm) -> list[Row]:
    equal = singular_radii([0.3, 0.3, 0.3])  # equal radii once
    collapsed = equal.shape == (2,) and bool(np.abs(equal - (0.3, 0.9)).max() < 1e-15)
    bent = self_motion_map([0.3, 0.3, 0.3], [[0.2, 0.0], [0.6, 0.0]])
    base = self_motion(arm, [0.0, 0.0])
    winding = base.components[0].winding if base.components else np.zeros(3)
    scaled = [_at(a, f * 0.7).length for f, a in ((1.0, arm), (3.0, planar_3r(1.2, 1.05, 0.75)))]
    return [
        claim(
            FIRST,
            "equal links",
            "two pairs of points collapse into two points",
            f"a = b = c = {equal[0]:g} m, d = {equal[-1]:g} m; {bent.number[0]} curves below a, {bent.number[1]} above",
            collapsed and bent.number.tolist() == [2, 1],
            "singular_radii([0.3, 0.3, 0.3])",
            "three radii fall into one; the two regions left are as the paper says",
            "corrected",
        ),
        claim(
            FIRST,
            "px = 0",
            "left out of region A",
            f"{base.status}: {base.count} curves, joint 1 turns {abs(int(winding[0]))} time",
            base.status == "regular" and base.count == 2 and abs(int(winding[0])) == 1,
            "self_motion(load('lenarcic_3r'), [0, 0])",
            "nothing is special there: joint 1 turns freely, the other two keep their angles",
            "refined",
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
        compared(SECOND, name, text, float(value), how, unit=" m")
        for (name, text), value in zip(printed, values, strict=True)
    ]
    for region, x, count in (("A", 0.28, 2), ("B", 0.6, 1)):
        motion = _at(arm, x, "x_alpha")
        call = f"self_motion(load('lenarcic_3r'), [{x:g}, 0], task='x_alpha').count"
        found.append(compared(SECOND, f"closed curves in region {region}", str(count), float(motion.count), call))
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
            "special case",
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
            "special case",
        )
    )
    sums = [c.at(np.linspace(0, 1, 100)).sum(axis=1) for c in _at(arm, 0.6, "x_alpha").components]
    flat = max(float(np.ptp(s)) for s in sums)
    found.append(
        claim(
            SECOND,
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
    run = eigenvector(arm, curve.q[0], gamma=0.001)
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
            "corrected",
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
            "true away from singular targets; stopping within 5γ is also how the method ends, so it can show no more",
            "corrected",
        ),
        claim(
            METHOD,
            "close to a singularity",
            "quite robust",
            f"at px = 0.5001 it {'does not return' if bad.status != 'closed' else 'returns on another branch'}: "
            f"{bad.length:.4g} rad instead of {near.length:.4g}",
            lost,
            "eigenvector(arm, q0) at px = 0.5001",
            "two branches pass each other closer than the drift; continuation with a guard follows the right one",
            "corrected",
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
            "corrected",
        ),
    ]


def _outlook(arm: Arm) -> list[Row]:
    limited = arm.with_limits(position=[(-2.0, 2.0)] * 3)
    motion = self_motion(limited, [INSIDE["C"], 0.0], limits=True)
    arcs = motion.feasible or ()
    slide = self_motion_slide()
    return [
        claim(
            OUTLOOK,
            "joint limits",
            "joints unlimited",
            f"{len(arcs)} feasible arcs of {sum(c.length for c in arcs):.4g} rad in all, with joints within ±2 rad",
            len(arcs) > 0,
            "self_motion(arm.with_limits(...), [0.4, 0], limits=True).feasible",
            "not treated by the paper",
            "refined",
        ),
        claim(
            OUTLOOK,
            "revolute and translational joints together",
            "problematic: the length depends on a scaling factor",
            f"a PRR arm: {slide.count} curve, length {slide.length:.6g} rad at a stated scale of 1 m per rad",
            slide.count > 0,
            "self_motion(planar('PRR', ...), target)",
            "the curve itself does not depend on the factor, which is stated with the length",
            "refined",
        ),
    ]


def self_motion_slide() -> SelfMotion:
    """The self-motion of an arm with a slide, at one target.

    Example:
        >>> self_motion_slide().status
        'regular'
    """
    from chainrule.arm import planar

    return self_motion(planar("PRR", [0.2, 0.35, 0.25]), [0.4, 0.3])


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
