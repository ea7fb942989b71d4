"""S. Ambike, J. P. Schmiedeler and M. M. Stanisic: speed ratios of planar arms with one joint to spare.

The paper's values are typed here as the paper prints them; ours come from public functions. The paper takes the
curvature of both examples as positive, and both turn right: our signed curvature is its negative, and so are a and C.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from chainrule.arm import Arm, planar
from chainrule.derive.planar import planar_chain
from chainrule.derive.speed_ratio import plain_elimination
from chainrule.description import planar_model
from chainrule.loading import load
from chainrule.papers import Row, compared, shown_equal
from chainrule.speed_ratio import SpeedRatios, Status, speed_ratios
from chainrule.tables import functions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FIRST, SECOND, THEORY = "example 1", "example 2", "section 3"
HOW = {
    FIRST: "speed_ratios(load('ambike_3r'), radians([-14, -10, -205]), [2, 1], -1)",
    SECOND: "speed_ratios(load('ambike_3r'), radians([-14, -40, -205]), [1, 0.35], -1)",
}
TO_THE_RIGHT = "with the curvature counted to the right, as the paper does"

#: Rows that other modules add: what is done, the module and its function.
MORE: tuple[tuple[str, str, str], ...] = (
    ("following paths", "chainrule.papers.ambike_following", "rows_following"),
    ("beyond the paper", "chainrule.papers.ambike_beyond", "rows"),
)


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """Every quantity of both examples, the claims of section 3, and what :data:`MORE` adds."""
    progress("speed ratios: the examples")
    found = _first(example(FIRST)) + _second(example(SECOND))
    progress("speed ratios: the claims, by SymPy")
    found += _claims()
    for what, module, function in MORE:
        progress(f"speed ratios: {what}")
        found += getattr(import_module(module), function)(progress)
    return tuple(found)


def figures() -> dict[str, Figure]:
    """Figures 1 and 2."""
    from chainrule.papers import ambike_following

    return ambike_following.figures()


def example(which: str) -> SpeedRatios:
    """Our answer to one of the two examples.

    Example:
        >>> example("example 1").discriminant.round(4)
        np.float64(1.9842)
    """
    pose, tangent = {FIRST: ([-14.0, -10.0, -205.0], [2.0, 1.0]), SECOND: ([-14.0, -40.0, -205.0], [1.0, 0.35])}[which]
    return speed_ratios(load("ambike_3r"), np.radians(pose), tangent, -1.0)


def _first(found: SpeedRatios) -> list[Row]:
    printed = {
        "a": ("-6.4670", "-26.3920", "-26.9267"),
        "b": ("6.7015", "27.8167", "26.9752"),
        "C": "-48.6844",
        "D": "50.6686",
        "delta": "1.9842",
    }
    made = [
        _tangent(FIRST, "[0.8944, 0.4472]", found, "(2, 1)/√5"),
        _misnamed(FIRST, ("0.2345", "1.4247", "0.0485"), found, 1.0),
        *_polynomial(FIRST, printed, found),
    ]
    for number, pair in enumerate((("-0.0343", "3.0319"), ("-6.0402", "-3.7154"))):
        for name, text, value in zip(("n2", "n3"), pair, found.ratios[number], strict=True):
            quantity = f"solution {number + 1}, {name}"
            made.append(compared(FIRST, quantity, text, float(value), f"{HOW[FIRST]}.ratios"))
    made += _changes(found)
    why = found.reason.removesuffix(".")
    made.append(
        shown_answer(FIRST, "the chosen solution", "the second", found.chosen == 1, f"{HOW[FIRST]}.chosen", why)
    )
    made += _pseudoinverse(FIRST, ("2.9052", "6.3343"), found)
    norms = [float(np.linalg.norm(x)) for x in (found.pseudoinverse, found.chosen_rates)]
    made.append(
        Row(
            FIRST,
            "norm of the pseudoinverse's rates, below the chosen ones' at the same tip speed",
            "stated",
            f"{norms[0]:.4f} < {norms[1]:.4f}",
            norms[0] - norms[1],
            "agrees" if norms[0] < norms[1] else "DISAGREES",
            f"{HOW[FIRST]}.pseudoinverse and .chosen_rates",
        )
    )
    return made


def _second(found: SpeedRatios) -> list[Row]:
    printed = {
        "a": ("-19.3305", "-102.2244", "-135.1469"),
        "b": ("3.4823", "28.8917", "49.2146"),
        "C": "-219.0375",
        "D": "149.219",
        "delta": "-69.8184",
    }
    tracked = -found.curvature
    how = f"{HOW[SECOND]}.curvature"
    made = [
        _tangent(
            SECOND, "[0.9439, 0.3304]", found, "(1, 0.35)/√1.1225, which gives every other number to its last digit"
        ),
        _misnamed(SECOND, ("-9.6866", "-40.7486", "-42.8541"), found, tracked),
        *_polynomial(SECOND, printed, found),
        compared(SECOND, "tracked curvature κt = −D/C", "0.6812", tracked, how, TO_THE_RIGHT),
        compared(SECOND, "error |κd − κt|", "0.3188", abs(found.curvature - found.desired), how),
    ]
    for name, text, value in zip(("n2", "n3"), ("-2.1033", "-0.7671"), found.ratios[0], strict=True):
        made.append(compared(SECOND, f"best possible solution, {name}", text, float(value), f"{HOW[SECOND]}.ratios"))
    made += _pseudoinverse(SECOND, ("-0.7398", "-4.3965"), found)
    made.append(_nothing_nearer(found))
    centres = [1.0 / found.desired, 1.0 / found.curvature, 1.0 / found.pseudoinverse_curvature]
    gaps = [abs(centre - centres[0]) for centre in centres[1:]]
    made.append(
        Row(
            SECOND,
            "the solution's centre of curvature is nearer to the desired one than the pseudoinverse's",
            "stated",
            f"{gaps[0]:.4f} against {gaps[1]:.4f}",
            gaps[0] - gaps[1],
            "agrees" if gaps[0] < gaps[1] else "DISAGREES",
            f"{how} and .pseudoinverse_curvature",
        )
    )
    return made


def _tangent(where: str, printed: str, found: SpeedRatios, meant: str) -> Row:
    digits = [float(text) for text in printed.strip("[]").split(", ")]
    same = np.allclose(found.tangent, digits, atol=0.5e-4 * (1.0 + 1e-9))
    return Row(
        where,
        "tangent",
        printed,
        "[" + ", ".join(f"{x:.7f}" for x in found.tangent) + "]",
        float(np.abs(found.tangent - digits).max()),
        "agrees" if same else "DISAGREES",
        f"{HOW[where]}.tangent",
        f"taken as {meant}",
    )


def _misnamed(where: str, printed: Sequence[str], found: SpeedRatios, tracked: float) -> Row:
    """What is printed as A of (5) are the coefficients a kappa + b of (7), at the curvature tracked."""
    seven = found.b - tracked * found.a  # a is that of a left turn
    decimals = [len(text.partition(".")[2]) for text in printed]
    same = all(
        abs(v - float(t)) <= 0.5 * 10.0**-d * (1 + 1e-9) for v, t, d in zip(seven, printed, decimals, strict=True)
    )
    return Row(
        where,
        "A1, A2, A3 of (5)",
        ", ".join(printed),
        ", ".join(f"{value:.4f}" for value in found.A),
        None,
        "misprint" if same else "DISAGREES",
        f"{HOW[where]}.A",
        "what is printed are the coefficients a κ + b of (7): " + ", ".join(f"{value:.4f}" for value in seven),
    )


def _polynomial(where: str, printed: dict[str, Any], found: SpeedRatios) -> list[Row]:
    how = HOW[where]
    made = []
    for k in range(3):
        made.append(compared(where, f"a{k + 1}", printed["a"][k], -float(found.a[k]), f"{how}.a", TO_THE_RIGHT))
    for k in range(3):
        made.append(compared(where, f"b{k + 1}", printed["b"][k], float(found.b[k]), f"{how}.b"))
    return [
        *made,
        compared(where, "C", printed["C"], -float(found.C), f"{how}.C", TO_THE_RIGHT),
        compared(where, "D", printed["D"], float(found.D), f"{how}.D"),
        compared(where, "Δ", printed["delta"], float(found.discriminant), f"{how}.discriminant"),
    ]


def _pseudoinverse(where: str, printed: Sequence[str], found: SpeedRatios) -> list[Row]:
    how = f"{HOW[where]}.pseudoinverse_ratios"
    pairs = zip(("n2", "n3"), printed, found.pseudoinverse_ratios, strict=True)
    return [compared(where, f"pseudoinverse, {name}", text, float(value), how) for name, text, value in pairs]


def wrong_sign(arm: Arm, found: SpeedRatios) -> list[float]:
    """dk/ds of both solutions with the sign of 3 (T x r'') (T.r'') / v^4 changed, as the paper prints them.

    The paper's curvature is positive to the right, and s grows with theta_1: in the first solution against T.
    """
    zero, values = np.zeros(3), []
    for rates in found.rates:
        derivatives, _ = arm.evaluator("tip_motion")(found.q, arm.parameters, rates, zero, zero)
        second, third = derivatives[2], derivatives[3]
        bend = np.array([-found.tangent[1], found.tangent[0]])  # T x r = bend . r; at unit speed v = 1
        change = bend @ third + 3.0 * (bend @ second) * (found.tangent @ second)
        values.append(-float(np.sign(rates[0]) * change))
    return values


def _changes(found: SpeedRatios) -> list[Row]:
    made = []
    flipped = wrong_sign(load("ambike_3r"), found)
    for number, printed in enumerate(("-0.8262", "0.4414")):
        ours = float(found.curvature_rates[number])
        same = abs(flipped[number] - float(printed)) <= 0.5e-4 * (1.0 + 1e-9)
        made.append(
            Row(
                FIRST,
                f"solution {number + 1}, rate of change of curvature",
                printed,
                f"{ours:.4f}",
                ours - float(printed),
                "misprint" if same else "DISAGREES",
                f"{HOW[FIRST]}.curvature_rates",
                "the printed number has the wrong sign of 3 (T × r″)(T·r″)/v⁴ (with it: "
                f"{flipped[number]:.4f}); the choice between the solutions stays",
            )
        )
    return made


def _nothing_nearer(found: SpeedRatios) -> Row:
    """k - k_t is p2 (z - z_t)^2 for every unit-speed motion along T, J^+ T + z n."""
    p2, p1, p0, z = sp.symbols("p2 p1 p0 z")
    square = sp.expand(p2 * z**2 + p1 * z + p0 - (p0 - p1**2 / (4 * p2)) - p2 * (z + p1 / (2 * p2)) ** 2)
    away = np.linspace(-50.0, 50.0, 20_001)
    a, b, c = found.parabola
    tried = float(np.abs(a * away**2 + b * away + c - found.desired).min())
    best = abs(found.curvature - found.desired)
    return shown_equal(
        SECOND,
        "with first-order coordination the centre of curvature cannot be any closer",
        "stated",
        square == 0 and tried >= best * (1.0 - 1e-12),
        f"{HOW[SECOND]}.parabola",
        "all rates that follow T at unit speed are J⁺T + z n, and the curvature less −D/C is p₂ (z − z₀)²",
    )


def _claims() -> list[Row]:
    kinds = ["".join(word) for word in product("RP", repeat=3)]
    return [_square_everywhere(kinds), _linear(), _signs(), _straight(), _exception(), _leading(), _cost()]


def _square_everywhere(kinds: Sequence[str]) -> Row:
    good = True
    for word in kinds:
        chain = planar_chain(word, planar_model(word).parameter_names)
        for leading in (1, 2, 3):
            plain, ours = plain_elimination(chain, leading)
            good &= sp.cancel(sp.together(plain[1] ** 2 - 4 * plain[0] * plain[2])) == 0
            good &= all(sp.cancel(sp.together(p - a)) == 0 for p, a in zip(plain, ours, strict=True))
    return shown_equal(
        THEORY,
        "a2² − 4 a1 a3 = 0 for all eight morphologies, any leading joint, lengths and headings",
        '"by explicit calculation"',
        bool(good),
        "derive.speed_ratio.plain_elimination(arm, leading)",
        "on the line (5) r′ is parallel to T, so κ r′·r′ = κ (r′·T)² is κ times the square of one linear form",
    )


def _linear() -> Row:
    n2, kappa = sp.symbols("n2 kappa")
    u, v, b1, b2, b3 = sp.symbols("u v b1 b2 b3")
    omega = sp.Poly(kappa * (u * n2 + v) ** 2 + b1 * n2**2 + b2 * n2 + b3, n2)
    return shown_equal(
        THEORY,
        "(9): Δ = κ C + D is linear in κ",
        "Δ = κ C + D",
        sp.degree(omega.discriminant(), kappa) == 1,
        "the discriminant of κ (u n₂ + v)² + b₁ n₂² + b₂ n₂ + b₃",
    )


def _signs() -> Row:
    """With C, D < 0 (curvature counted from the desired side) only the other side can be reached."""
    random = np.random.default_rng(0)
    arm, count = load("ambike_3r"), 10_000
    angle = random.uniform(-np.pi, np.pi, count)
    tangent = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    found = speed_ratios(arm, random.uniform(-np.pi, np.pi, (count, 3)), tangent, 1.0)
    positive, negative = (found.C > 0.0) & (found.D > 0.0), (found.C < 0.0) & (found.D < 0.0)
    low, high = found.reachable.T
    good = bool((low[positive] < 0.0).all() and (high[negative] < 0.0).all() and found.exact[positive].all())
    return shown_answer(
        THEORY,
        "C, D > 0: every κ > 0 is matched; C, D < 0: only paths that bend to the other side",
        "stated",
        good and bool(positive.any() and negative.any()),
        "speed_ratios at 10 000 random postures",
        f"{positive.sum()} and {negative.sum()} of 10 000 random postures of the examples' arm",
    )


def _straight() -> Row:
    arm = planar("PPP", [0.3, 0.4, 0.5], [0.1, 1.0, 0.7])
    found = speed_ratios(arm, [0.1, 0.2, 0.3], [1.0, 0.0], 1.0)
    good = bool(found.C == 0.0 and found.D == 0.0 and (found.b == 0.0).all() and (found.a != 0.0).all())
    root = -found.a[1] / (2.0 * found.a[0])
    other = -(found.A[0] * root + found.A[2]) / found.A[1]
    moved = float(np.abs(np.asarray(arm.jacobian(found.q)) @ [1.0, root, other]).max())
    good &= moved < 1e-12
    return Row(
        THEORY,
        "three prismatic joints: C = D = 0 and Ω of (7) vanishes",
        "Ω = 0",
        "Ω = κ (u n₂ + v)², C = D = 0" if good else "not so",
        None,
        "misprint" if good else "DISAGREES",
        "speed_ratios(planar('PPP', ...)).a, .b, .C, .D",
        "C and D vanish, Ω does not: it is κ times a square, whose double root is the motion in which the tip stands "
        "still; so curvature cannot be tracked, as the paper says",
    )


def _exception() -> Row:
    arm = planar("RPP", [0.4, 0.3, 0.2], [0.0, 0.8, 0.0])
    found = speed_ratios(arm, [0.3, 0.1, 0.2], [0.6, 0.8], 1.0)
    fixed = found.status is Status.FIXED and abs(float(found.C)) < 1e-14 and abs(float(found.D)) < 1e-14
    return Row(
        THEORY,
        "three prismatic joints are the exception",
        "the only one named",
        f"also two parallel slides: the curvature is {found.curvature:.4g} at any rates" if fixed else "the only one",
        None,
        "true under a condition" if fixed else "DISAGREES",
        "speed_ratios(planar('RPP', [0.4, 0.3, 0.2], [0, 0.8, 0]), [0.3, 0.1, 0.2], [0.6, 0.8], 1).status",
        "C = D = 0 also where two neighbouring slides are parallel, and for PPR along its link; the curvature is then "
        "one number, not always 0",
    )


def _leading() -> Row:
    """A motion in which joint 1 stands still, and whether it is found with joint 1 leading."""
    arm = load("ambike_3r")
    q, rates = np.radians([-14.0, -10.0, -205.0]), np.array([0.0, 1.0, 0.5])
    tip, turning = np.asarray(arm.jacobian(q)) @ rates, np.cumsum(rates)
    bends = -(np.array(arm.parameters) * turning**2) @ np.exp(1j * np.cumsum(q))
    curvature = float((np.conj(complex(*tip)) * bends).imag) / float(np.hypot(*tip)) ** 3
    found = speed_ratios(arm, q, tip, curvature)
    still = [float(np.abs(r[0]) / np.abs(r).max()) for r in found.rates]
    good = found.count == 2 and min(still) < 1e-9 and found.leading != 1
    return Row(
        "section 2",
        "any joint may lead",
        "without loss of generality θ1",
        f"a solution in which joint 1 stands still is found, joint {found.leading} leads" if good else "not so",
        None,
        "true under a condition" if good else "DISAGREES",
        "speed_ratios(arm, q, J (0, 1, 0.5), curvature).leading",
        "if it moves: where θ1 stands still its ratios are infinite and the solution is lost; ours are found as "
        "J⁺T + z n, whichever joint stands still",
    )


def _cost() -> Row:
    """Operations of the generated functions: the speed ratio's rates, and the pseudoinverse's."""
    table = functions(load("ambike_3r")).to_dict()
    counts = {str(row["function"]): int(row["operations"] or 0) for row in table}
    ratio, plain = counts["speed_ratio_rates"], counts["null_projector_position"]
    return Row(
        "abstract",
        "no additional computational cost",
        "stated",
        f"{ratio} operations for the rates of both methods, {plain} for the pseudoinverse's projector",
        float(ratio - plain),
        "true under a condition" if ratio > plain else "DISAGREES",
        "tables.functions(load('ambike_3r'))",
        "counted for each update more, not less; where fewer updates are needed the whole may still cost less",
    )


def shown_answer(where: str, quantity: str, printed: str, same: bool, how: str, note: str = "") -> Row:
    """A statement against ours, the same or not by computation."""
    return Row(
        where,
        quantity,
        printed,
        "the same" if same else "not the same",
        None,
        "agrees" if same else "DISAGREES",
        how,
        note,
    )
