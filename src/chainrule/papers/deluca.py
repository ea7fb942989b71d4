"""A. De Luca, Robotics I, exam of 11 January 2012: the planar 3R arm of exercises 1 and 2 and of the bonus exercise.

The paper's values and formulas are typed here as the paper prints them; ours come from public functions.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from chainrule.arm import Arm, planar_3r
from chainrule.derive import catalogue, planar, rest_to_rest
from chainrule.derive.planar_3r import closed_minors, singular_set
from chainrule.derive.program import closed_form
from chainrule.goals import FastestMove, fastest, postures
from chainrule.loading import load
from chainrule.manipulability import max_manipulability
from chainrule.papers import Row, compared, shown_equal
from chainrule.workspaces import dexterous_rings, ring, workspace

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Expression = Any
EXERCISE, MOTION, BONUS = "exercise 1", "exercise 2", "bonus exercise"


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """Every quantity of the two exercises and the bonus exercise."""
    progress("workspaces")
    found = _workspaces()
    progress("Jacobian, manipulability and singular configurations, by SymPy")
    found += _formulas()
    progress("the fastest motion")
    found += _profile_formulas() + _fastest_motion()
    progress("the largest manipulability")
    return tuple(found + _optimum())


def _workspaces() -> list[Row]:
    arm = load("planar_3r")
    exact = workspace(arm)
    ((inner, outer),) = exact.primary
    rings = list(exact.secondary) or [(float("nan"), float("nan"))]
    how = "workspace(load('planar_3r'))"
    found = [
        compared(EXERCISE, "primary workspace, inner radius r1", "0.25", inner, f"{how}.primary", unit=" m"),
        compared(EXERCISE, "primary workspace, outer radius R1", "1.75", outer, f"{how}.primary", unit=" m"),
        compared(EXERCISE, "secondary workspace, inner radius r2", "0.75", rings[0][0], f"{how}.secondary", unit=" m"),
        compared(EXERCISE, "secondary workspace, outer radius R2", "1.25", rings[0][1], f"{how}.secondary", unit=" m"),
    ]
    found += [
        compared(
            EXERCISE, "auxiliary workspace, inner radius ra", "0.5", ring([1.0, 0.5])[0], "ring([1, 0.5])", unit=" m"
        ),
        compared(
            EXERCISE, "auxiliary workspace, outer radius Ra", "1.5", ring([1.0, 0.5])[1], "ring([1, 0.5])", unit=" m"
        ),
        compared(EXERCISE, "inner hole for equal lengths", "0", ring([1.0, 1.0, 1.0])[0], "ring([1, 1, 1])", unit=" m"),
    ]
    triples = np.random.default_rng(0).uniform(0.0, 2.0, (1000, 3))
    worst = max(abs(ring(triple)[0] - _inner_radius(*triple)) for triple in triples)
    found.append(
        Row(
            EXERCISE,
            "general formula for r1, at 1000 random lengths",
            "max of four terms",
            "the same" if worst < 1e-12 else "not the same",
            worst,
            "agrees" if worst < 1e-12 else "DISAGREES",
            "ring([l1, l2, l3])",
        )
    )
    found.append(_secondary_formula())
    return found


def _inner_radius(l1: float, l2: float, l3: float) -> float:
    """The paper's r1."""
    return max(abs(l1 - l2) - l3, abs(l2 - l3) - l1, abs(l1 - l3) - l2, 0.0)


def _secondary_formula() -> Row:
    """The paper's r2 and R2 are those of l1 > l2 and l3 < l1 - l2: a longer last link adds a disc about the base."""
    lengths = (1.0, 0.9, 0.5)
    printed = (lengths[0] - lengths[1] + lengths[2], lengths[0] + lengths[1] - lengths[2])
    ours = dexterous_rings(lengths)
    text = " and ".join(f"[{low:.4g}, {high:.4g}]" for low, high in ours)
    special = len(ours) == 2 and np.allclose(ours[1], printed)
    return Row(
        EXERCISE,
        "r2 = l1 - l2 + l3, R2 = l1 + l2 - l3, at l = (1, 0.9, 0.5)",
        f"[{printed[0]:.4g}, {printed[1]:.4g}] m",
        f"{text} m",
        None,
        "true under a condition" if special else "DISAGREES",
        "dexterous_rings([1, 0.9, 0.5])",
        "for l1 > l2 and l3 < l1 - l2, as in the paper; where the last link is longer, a disc about the base is added",
    )


def _formulas() -> list[Row]:
    arm = catalogue.symbolic(load("planar_3r").description.model)
    q1, q2, q3 = arm.inputs[0].symbols
    l1, l2, l3 = arm.inputs[1].symbols
    jacobian = sp.Matrix(2, 3, closed_form(planar.jacobian(arm, "position"))["jacobian"])
    s1, s12, s123 = sp.sin(q1), sp.sin(q1 + q2), sp.sin(q1 + q2 + q3)
    c1, c12, c123 = sp.cos(q1), sp.cos(q1 + q2), sp.cos(q1 + q2 + q3)
    printed = sp.Matrix(
        [
            [-(l1 * s1 + l2 * s12 + l3 * s123), -(l2 * s12 + l3 * s123), -l3 * s123],
            [l1 * c1 + l2 * c12 + l3 * c123, l2 * c12 + l3 * c123, l3 * c123],
        ]
    )
    s2, s3, s23 = sp.sin(q2), sp.sin(q3), sp.sin(q2 + q3)
    terms = (l1 * (l2 * s2 + l3 * s23), l3 * (l1 * s23 + l2 * s3), l2 * l3 * s3)
    square, ours = (jacobian * jacobian.T).det(), sum(m**2 for m in closed_minors(arm))
    minors = closed_minors(arm)
    back = {q2: -q2, q3: -q3}
    return [
        shown_equal(
            EXERCISE,
            "Jacobian",
            "2 × 3 matrix",
            all(vanishes(e) for e in jacobian - printed),
            "derive.planar.jacobian(arm, 'position')",
        ),
        shown_equal(
            EXERCISE,
            "H², equation (1)",
            "sum of three squares",
            vanishes(square - sum(t**2 for t in terms)),
            "det(J Jᵀ) of the derived Jacobian",
        ),
        shown_equal(
            EXERCISE,
            "our closed form of H²",
            "equation (1)",
            vanishes(ours - sum(t**2 for t in terms)),
            "derive.planar_3r.closed_minors(arm)",
        ),
        shown_equal(
            EXERCISE,
            "H does not depend on q1",
            "dH/dq1 = 0",
            vanishes(sp.diff(square, q1)),
            "derivative of det(J Jᵀ) by q1",
        ),
        compared(
            "footnote 2", "number of maximal minors", "3", float(len(minors)), "derive.planar_3r.closed_minors(arm)"
        ),
        shown_equal(
            "footnote 2",
            "the three terms are the minors (1,2), (1,3), (2,3)",
            "up to sign",
            all(vanishes(m**2 - t**2) for m, t in zip(minors, terms, strict=True)),
            "derive.planar_3r.closed_minors(arm)",
        ),
        _singular(singular_set(arm), q2, q3),
        shown_equal(
            BONUS,
            "symmetry",
            "H(q2, q3) = H(−q2, −q3)",
            vanishes(ours - ours.subs(back, simultaneous=True)),
            "derive.planar_3r.closed_minors(arm)",
        ),
    ]


def vanishes(expression: Expression) -> bool:
    """Whether a polynomial in sines and cosines of sums of symbols is zero, decided exactly.

    Sums of angles are expanded, and s^2 + c^2 = 1 then leaves at most the first power of every sine: a form in which
    zero has no other name.
    """
    flat = sp.expand(sp.expand_trig(expression))
    names = {}
    for angle in sorted({f.args[0] for f in flat.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.Dummy(f"s_{angle}"), sp.Dummy(f"c_{angle}")
        names[angle] = (s, c)
        flat = flat.xreplace({sp.sin(angle): s, sp.cos(angle): c})
    for s, c in names.values():
        flat = sp.rem(sp.expand(flat), s**2 + c**2 - 1, s) if flat.has(s) else flat
    return bool(sp.expand(flat) == 0)


def _singular(found: tuple[dict[Expression, Expression], ...], q2: Expression, q3: Expression) -> Row:
    printed = {(0, 0), (0, sp.pi), (sp.pi, 0), (sp.pi, sp.pi)}  # the paper's ±π is one angle
    ours = {(sp.Mod(pair[q2], 2 * sp.pi), sp.Mod(pair[q3], 2 * sp.pi)) for pair in found}
    text = ", ".join(f"{{{a}, {b}}}" for a, b in sorted(ours, key=lambda pair: (float(pair[0]), float(pair[1]))))
    return Row(
        EXERCISE,
        "singular pairs {q2, q3}, for all positive lengths",
        "{0, 0}, {0, ±π}, {±π, 0}, {±π, ±π}",
        text.replace("pi", "π"),
        None,
        "agrees" if ours == printed else "DISAGREES",
        "derive.planar_3r.singular_set(arm)",
    )


def _profile_formulas() -> list[Row]:
    """Equations (2) to (4): the durations follow from the area under the velocity."""
    d, v, a, time = sp.symbols("d V A T", positive=True)
    (trapezoid,) = sp.solve(sp.Eq(rest_to_rest.travelled(v, a, time), d), time)
    peak = sp.sqrt(d * a)
    (triangle,) = sp.solve(sp.Eq(rest_to_rest.travelled(peak, a, time), d), time)
    how = "derive.rest_to_rest.travelled: the area under the velocity, solved for the duration"
    return [
        shown_equal(
            MOTION, "T, equation (2)", "(Δ A + V²) / (A V)", sp.simplify(trapezoid - (d * a + v**2) / (a * v)) == 0, how
        ),
        shown_equal(
            MOTION,
            "equation (3)",
            "Δ ≥ V²/A exactly if T ≥ 2 Ts",
            sp.simplify((trapezoid - 2 * v / a) * v - (d - v**2 / a)) == 0,
            how,
        ),
        shown_equal(MOTION, "T, equation (4)", "2 √(Δ/A)", sp.simplify(triangle - 2 * sp.sqrt(d / a)) == 0, how),
    ]


def _fastest(arm: Arm) -> FastestMove:
    """The motion of exercise 2."""
    start, goals = postures(arm, 1.75, 0.0, 0.0), postures(arm, 1.25, 0.5, 0.0)
    return fastest(start.q[0], goals.q, arm.limits.velocity, arm.limits.acceleration, kinds=arm.kinds)


def _fastest_motion() -> list[Row]:
    arm = load("planar_3r")
    start, goals = postures(arm, 1.75, 0.0, 0.0), postures(arm, 1.25, 0.5, 0.0)
    how = "postures(load('planar_3r'), 1.25, 0.5, 0)"
    found = [
        _all_of(
            "q_A, the only posture there",
            ["0", "0", "0"],
            np.degrees(start.q),
            "postures(load('planar_3r'), 1.75, 0, 0)",
            "°",
        ),
        _all_of("q'_B", ["0", "90", "-90"], np.degrees(goals.q[:1]), how, "°"),
        _all_of("q''_B", ["53.13", "-90", "36.87"], np.degrees(goals.q[1:]), how, "°"),
    ]
    best = _fastest(arm)
    how = "fastest(q_A, q_B, V, A, kinds='RRR')"
    for k, (name, times, whole, cases) in enumerate(
        (("T'", ["0", "1.5", "1.75"], "1.75", "d, b, a"), ("T''", ["1.1903", "1.5", "0.8645"], "1.5", "c, b, a"))
    ):
        ours = best.moves.joint_durations[k : k + 1]
        letters = ", ".join(best.moves.cases[k])
        found += [
            _all_of(f"joint times of {name}", times, ours, f"{how}.moves.joint_durations[{k}]", " s"),
            _same(f"cases of {name}", cases, letters, f"{how}.moves.cases[{k}]"),
            compared(MOTION, name, whole, float(best.durations[k]), f"{how}.durations[{k}]", unit=" s"),
        ]
    together = fastest(
        start.q[0], goals.q, arm.limits.velocity, arm.limits.acceleration, kinds=arm.kinds, synchronise="time"
    )
    return [*found, *_statements(best, together, how)]


def _statements(best: FastestMove, together: FastestMove, how: str) -> list[Row]:
    chosen = {0: "q'_B", 1: "q''_B"}[best.index]
    spare = [j + 1 for j in range(3) if not best.move.bottleneck[j]]
    another = together.move.duration == best.move.duration and together.move.peak[0] < best.move.peak[0]
    ours = f"no: extra motion of joints {' and '.join(map(str, spare))}" if another and not best.unique else "yes"
    turning = best.move.sample(np.linspace(0.0, float(best.move.duration), 151)).velocity.sum(axis=-1)
    changes = "not constant" if np.abs(turning).max() > 1e-9 else "constant"
    return [
        compared(MOTION, "minimum motion time T", "1.5", float(best.move.duration), f"{how}.move.duration", unit=" s"),
        _same("the goal it goes to", "q''_B", chosen, f"{how}.index"),
        _same("is the motion unique", "no: extra motion of joints 1 and 3", ours, f"{how}.unique, .move.bottleneck"),
        _same("orientation during the motion", "not constant", changes, f"{how}.move.sample(t).velocity"),
    ]


def _same(quantity: str, printed: str, ours: str, how: str) -> Row:
    """A statement against the paper's."""
    return Row(MOTION, quantity, printed, ours, None, "agrees" if ours == printed else "DISAGREES", how)


def _all_of(quantity: str, printed: list[str], values: Any, how: str, unit: str) -> Row:
    """The numbers in the only row of ``values``, each against the paper's."""
    if np.shape(values) != (1, len(printed)):
        return Row(MOTION, quantity, ", ".join(printed), f"{len(values)} found", None, "DISAGREES", how)
    each = [compared("", "", p, float(x) + 0.0, "") for p, x in zip(printed, values[0], strict=True)]
    return Row(
        MOTION,
        quantity,
        f"({', '.join(printed)}){unit}",
        f"({', '.join(row.ours for row in each)}){unit}",
        max((row.difference or 0.0 for row in each), key=abs),
        "agrees" if all(row.good for row in each) else "DISAGREES",
        how,
    )


def _optimum() -> list[Row]:
    arm = load("planar_3r")
    step = 0.02
    angles = np.arange(-np.pi, np.pi, step)  # the paper's -pi:delta:pi
    grid = np.zeros((len(angles), len(angles), 3))
    grid[..., 1], grid[..., 2] = angles[:, None], angles[None, :]
    height = arm.manipulability(grid)
    i, j = np.unravel_index(int(height.argmax()), height.shape)
    at = (float(angles[i]), float(angles[j]))
    how = "load('planar_3r').manipulability on the grid −π:0.02:π"
    best = max_manipulability(arm)
    found = [
        _truncated("largest H on the paper's grid", "0.79", float(height[i, j]), how),
        compared(BONUS, "q2 there", "1.48", at[0], how, unit=" rad"),
        compared(BONUS, "q3 there", "0.24", at[1], how, unit=" rad"),
    ]
    straight = arm.manipulability([[0.0, a, b] for a in (0.0, np.pi) for b in (0.0, np.pi)])
    found.append(
        Row(
            BONUS,
            "H at the singular configurations",
            "0, seen in figures 4 and 5",
            f"{straight.max():.1g} m² at most",
            float(straight.max()),
            "agrees" if straight.max() < 1e-15 else "DISAGREES",
            "load('planar_3r').manipulability(q)",
        )
    )
    near = all(abs(best.q[k + 1] - at[k]) <= step for k in (0, 1)) and 0.0 <= best.value - height[i, j] < 1e-3
    found.append(
        Row(
            BONUS,
            "largest H, off the grid",
            "0.79 m² at (1.48, 0.24)",
            f"{best.value:.10f} m² at ({best.q[1]:.7f}, {best.q[2]:.7f})",
            best.value - float(height[i, j]),
            "agrees" if near else "DISAGREES",
            "max_manipulability(load('planar_3r'))",
            "the difference is to the grid's largest value",
        )
    )
    both = best.proved and best.complete and len(best.others) == 1 and np.allclose(best.others[0], -best.q, atol=1e-7)
    found.append(
        Row(
            BONUS,
            "two symmetric configurations provide the maximum, and no other",
            "seen in figures 4 and 5",
            f"global to {max(best.bound / best.value - 1.0, 1e-15):.0e}" if both else "not proved",
            None,
            "agrees" if both else "DISAGREES",
            "max_manipulability(load('planar_3r'))",
            best.how,
        )
    )
    one, two = (max_manipulability(planar_3r(*[size] * 3)) for size in (1.0, 2.0))
    twice = max_manipulability(planar_3r(2.0, 1.0, 0.5))
    same = bool(np.allclose(one.q, two.q, atol=1e-6)) and abs(two.value / one.value - 4.0) < 1e-9
    scaled = (
        bool(np.allclose(np.abs(twice.q), np.abs(best.q), atol=1e-6)) and abs(twice.value / best.value - 4.0) < 1e-9
    )
    found += [
        Row(
            BONUS,
            "equal lengths l: optimal posture independent of l, H* grows with l²",
            "stated",
            f"l = 1 and 2: ratio {two.value / one.value:.9g}, same posture" if same else "not so",
            two.value / one.value - 4.0,
            "agrees" if same else "DISAGREES",
            "max_manipulability(planar_3r(l, l, l))",
        ),
        Row(
            BONUS,
            "only with equal lengths does the optimal posture not depend on the size",
            "stated",
            f"l and 2 l: ratio {twice.value / best.value:.9g}, same posture" if scaled else "not so",
            twice.value / best.value - 4.0,
            "true under a condition" if scaled else "DISAGREES",
            "max_manipulability(planar_3r(2, 1, 0.5))",
            "if the lengths change by different factors; in proportion any arm keeps its posture, and H* grows with l²",
        ),
    ]
    return found


def figures() -> dict[str, Figure]:
    """Figures 1 to 6: the workspaces, the fastest motion, H and its maximum."""
    from chainrule.manipulability import manipulability_map
    from chainrule.plot.maps import draw_map, draw_optima
    from chainrule.plot.timing import draw_profiles
    from chainrule.plot.workspace import draw_workspace

    arm = load("planar_3r")
    best = max_manipulability(arm)
    return {
        "figures-1-2": draw_workspace(arm),
        "figure-3": draw_profiles(_fastest(arm).move, arm.kinds),
        "figures-4-5": draw_map(arm, manipulability_map(arm, largest=best)),
        "figure-6": draw_optima(arm, best),
    }


def _truncated(quantity: str, printed: str, value: float, how: str) -> Row:
    """A value that the paper cuts off after its last digit instead of rounding it."""
    difference = value - float(printed)
    agrees = 0.0 <= difference < 0.01
    return Row(
        BONUS,
        quantity,
        f"{printed} m²",
        f"{value:.10g} m²",
        difference,
        "agrees" if agrees else "DISAGREES",
        how,
        "the paper cuts off after two decimals; rounded it is 0.80" if f"{value:.2f}" != printed else "",
    )
