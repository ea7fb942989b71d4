"""Ambike, Schmiedeler and Stanisic, beyond the examples: four joints, and second-order coordination."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp

from chainrule.arm import planar
from chainrule.derive import speed_ratio_4
from chainrule.derive.planar import planar_chain
from chainrule.derive.speed_ratio import TANGENT
from chainrule.description import planar_model
from chainrule.four_joints import FourJointRatios, speed_ratios_4_each
from chainrule.higher_order import motion_ratios
from chainrule.loading import load
from chainrule.papers import Row, Verdict

WHERE = "section 3"
ARMS = 200


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """What the paper says of four joints and of second-order coordination, and what can be had."""
    progress("four joints: the sextic, by SymPy")
    found = [_sextic(), _twelve()]
    progress(f"four joints: all solutions of {ARMS} random arms")
    found += _all_solutions()
    progress("second-order coordination")
    return (*found, _two_joints(), _second_example())


def _sextic() -> Row:
    reduces = speed_ratio_4.reduction() == 0
    return Row(
        WHERE,
        "the third-order equation of four joints",
        "sextic",
        "v³ times a cubic on (5) and (6)" if reduces else "not reducible",
        None,
        "agrees" if reduces else "DISAGREES",
        "derive.speed_ratio_4.reduction()",
        "with v = r′·T it is ρv³ − T×r‴ + 3κv(T·r″) = 0; at unit tip speed v is 1",
    )


def _twelve() -> Row:
    """An exact 4R arm: sines and cosines from Pythagorean triples."""
    model = planar_model("RRRR")
    arm = planar_chain(model.kinds, model.parameter_names)
    triples = ((3, 4, 5), (12, -5, 13), (8, 15, 17), (20, 21, 29))
    numbers: dict[Any, Any] = {}
    for angle, (c, s, r) in zip(arm.inputs[0].symbols, triples, strict=True):
        numbers |= {sp.cos(angle): sp.Rational(c, r), sp.sin(angle): sp.Rational(s, r)}
    numbers |= dict(zip(arm.inputs[1].symbols, map(sp.Integer, (1, 2, 3, 1)), strict=True))
    numbers |= dict(zip(TANGENT.symbols, (sp.Rational(9, 41), sp.Rational(40, 41)), strict=True))
    numbers |= {speed_ratio_4.KAPPA: sp.Rational(1, 3), speed_ratio_4.RHO: sp.Rational(-2, 7)}
    system = speed_ratio_4.paper_system(arm, numbers)
    n2, n3 = speed_ratio_4.RATIOS
    whole, still, cubic = (
        sp.Poly(sp.resultant(system.conic, p, n3), n2) for p in (system.sextic, system.still, system.cubic)
    )
    degrees = whole.degree(), still.degree(), cubic.degree()
    good = degrees == (12, 2, 6) and whole == still**3 * cubic
    return Row(
        WHERE,
        "common points of the quadratic and the sextic equation",
        "2 × 6",
        f"{degrees[0]} = 3 × {degrees[1]} + {degrees[2]}" if good else f"{degrees}",
        None,
        "agrees" if good else "DISAGREES",
        "resultants of derive.speed_ratio_4.paper_system(arm, numbers), an exact 4R arm",
        "two stationary points (v = 0) count threefold and move nothing; six solutions are left",
    )


def _all_solutions() -> list[Row]:
    rng = np.random.default_rng(0)
    found: list[FourJointRatios] = []
    for lengths in rng.uniform(0.2, 1.5, (ARMS, 4)):
        q, tangent, (curvature, rate) = rng.uniform(-np.pi, np.pi, 4), rng.normal(size=2), rng.normal(size=2)
        found += speed_ratios_4_each(planar("RRRR", lengths), q, tangent, curvature, rate)
    counts = Counter(result.count for result in found)
    proved = sum(result.certified for result in found)
    text = ", ".join(f"{count} in {counts[count]}" for count in sorted(counts))
    verdict: Verdict = "true under a condition" if proved == ARMS and set(counts) <= {0, 2, 4, 6} else "DISAGREES"
    met = sum(counts[count] for count in counts if count > 0)
    return [
        Row(
            WHERE,
            f"real solutions for four joints, {ARMS} random arms and paths",
            "a search algorithm must be employed",
            f"all of them, proved: {text}",
            None,
            verdict,
            "speed_ratios_4(arm, q, tangent, curvature, curvature_rate)",
            "if the three equations are solved as they stand; elimination leaves one polynomial of degree six, whose "
            "real roots are isolated",
        ),
        Row(
            WHERE,
            "four joints use second- and third-order path properties",
            "stated in general",
            f"in {met} of {ARMS} cases",
            None,
            "true under a condition" if 0 < met < ARMS else "DISAGREES",
            "speed_ratios_4(...).count",
            "where a real solution exists; elsewhere the nearest is given",
        ),
    ]


def _two_joints() -> Row:
    """Second-order coordination of two joints at random configurations.

    Example:
        >>> _two_joints().verdict
        'agrees'
    """
    rng = np.random.default_rng(1)
    q = rng.uniform([-3.0, 0.3], [3.0, 2.8], (1000, 2))
    curvature = rng.normal(size=1000)
    reached = motion_ratios(planar("RR", [1.0, 0.8]), q, rng.normal(size=(1000, 2)), curvature, order=2).path[:, 1]
    worst = float(np.abs(reached - curvature).max())
    return Row(
        WHERE,
        "two joints, second-order coordination: curvature error, 1000 regular configurations",
        "accurate curvature tracking is ensured",
        f"{worst:.1g} 1/m at most",
        worst,
        "agrees" if worst < 1e-9 else "DISAGREES",
        "motion_ratios(arm, q, tangent, curvature, order=2)",
    )


def _second_example() -> Row:
    """Where first-order ratios stop at 0.6812, second-order ones reach the curvature, and third-order ones its rate."""
    q, tangent = np.deg2rad([-14.0, -40.0, -205.0]), [0.9439, 0.3304]
    path = motion_ratios(load("ambike_3r"), q, tangent, -1.0, 0.0).path
    error = float(np.abs(path[:3] - [1.0, -1.0, 0.0]).max())
    return Row(
        "example 2",
        "tracked curvature",
        "0.6812, the best possible",
        f"{-path[1]:.10g} with second-order ratios",
        None,
        "true under a condition" if error < 1e-9 else "DISAGREES",
        "motion_ratios(load('ambike_3r'), radians([-14, -40, -205]), [0.9439, 0.3304], -1)",
        "0.6812 is the best of first-order coordination; one linear equation in q″ gives the curvature itself",
    )
