"""M. Baili, P. Wenger and D. Chablat: orthogonal 3R arms, their cusps and domains, and the condition to be cuspidal.

The paper's values and formulas are typed here as the paper prints them; ours come from public functions and from
derivations.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from chainrule.cuspidality.classify import classify_orthogonal_3r, topology_orthogonal_3r
from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.designs import orthogonal_3r, regional_3r
from chainrule.cuspidality.domains import exact_domain
from chainrule.derive import orthogonal_designs as derived
from chainrule.derive.orthogonal_3r import determinant, orthogonal_chain
from chainrule.loading import load
from chainrule.papers import Row, claim, compared, shown_equal

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Expression = Any
ARM, CASES, CONDITION = "section I", "section III", "section IV"

#: One design (d2, d3, d4, r2) inside each domain; 2 and 3 are those of figure 2.
INSIDE = {
    1: (1, "0.7", "0.2", "0.3"),
    2: (1, 2, "1.5", 1),
    3: (1, 3, 4, 3),
    4: (1, 2, 6, "0.5"),
    5: (1, "0.5", 3, "0.5"),
}
#: Cusps of the five cases, as the paper has them, and the figures that show them.
PRINTED = {1: "0", 2: "4", 3: "2", 4: "4", 5: "0"}
SHOWN = {1: "figure 3", 2: "figure 4", 3: "figure 2 (b)", 4: "figure 5", 5: "figure 6"}


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """The paper's formulas, figures, domains and claims, and what lies beyond."""
    progress("cuspidal arms: determinant and figures")
    found = [_puma(), *_determinant(), *_figures()]
    progress("cuspidal arms: the separating surfaces, by SymPy")
    found += _surfaces()
    progress("cuspidal arms: domains and cusps, exactly")
    found += _domains()
    progress("cuspidal arms: condition (7)")
    found += _condition()
    progress("cuspidal arms: nodes and topologies")
    return tuple(found + _figure_7() + _topologies())


# ---- section II --------------------------------------------------------------------------------------------------


def _puma() -> Row:
    design = regional_3r(load("puma560"))
    return claim(
        ARM,
        "an arm with a vertical axis and two parallel ones after it, like the Puma",
        "always noncuspidal",
        "not cuspidal: " + ", ".join(design.nongeneric) if not design.cuspidal else "cuspidal",
        design.cuspidal is False,
        "regional_3r(load('puma560')).cuspidal, .nongeneric",
    )


def _determinant() -> list[Row]:
    _, q2, q3 = orthogonal_chain().q
    d2, d3, d4, r2 = orthogonal_chain().inputs[1].symbols
    s3, c3, c2 = sp.sin(q3), sp.cos(q3), sp.cos(q2)
    printed = (d3 + c3 * d4) * (s3 * d2 + c2 * (s3 * d3 - c3 * r2))
    missing = sp.simplify(sp.expand(determinant() - d4 * printed)) == 0
    return [
        claim(
            "equation (1)",
            "det J",
            "(d3 + c3 d4)(s3 d2 + c2 (s3 d3 - c3 r2))",
            "d4 times that" if missing else "something else",
            missing,
            "derive.orthogonal_3r.determinant()",
            "the factor d4 is missing: as printed det J has the unit m² instead of m³; the singularities are the same",
            "misprint",
        )
    ]


def _figures() -> list[Row]:
    found = []
    for figure, lengths, printed in (("figure 2 (a)", INSIDE[2], "4"), ("figure 2 (b)", INSIDE[3], "2")):
        design = orthogonal_3r(*lengths, exact=True)
        call = f"orthogonal_3r({', '.join(map(str, lengths))})"
        found.append(compared(figure, "cusps", printed, float(len(design.cusps())), f"{call}.cusps()"))
        curves = design.singular_curves()
        lines = sum(curve.line for curve in curves)
        text = "two curves" + (" and two lines" if figure.endswith("(b)") else "")
        ours = "two curves" if len(curves) - lines == 2 else f"{len(curves) - lines} curves"
        ours += " and two lines" if lines == 2 else ""
        found.append(
            claim(figure, "singularities in the joint space", text, ours, ours == text, f"{call}.singular_curves()")
        )
    design = orthogonal_3r(*INSIDE[2], exact=True)
    inner, outer = design.number_of_postures([2.4, 4.0], [0.0, 0.0]).tolist()
    found.append(
        claim(
            "figure 2 (a)",
            "postures inside and outside the inner boundary",
            "4 and 2",
            f"{inner} and {outer}",
            (inner, outer) == (4, 2),
            "orthogonal_3r(1, 2, 1.5, 1).number_of_postures(rho, z)",
        )
    )
    points = [curve.image for curve in orthogonal_3r(*INSIDE[3], exact=True).singular_curves() if curve.line]
    spread = max(float(np.ptp(image, axis=0).max()) for image in points)
    found.append(
        claim(
            "figure 2 (b)",
            "image of each line theta3 = +-arccos(-d3/d4)",
            "a point",
            f"a point, to {spread:.1g} m",
            spread < 1e-12,
            "orthogonal_3r(1, 3, 4, 3).singular_curves()[-1].image",
        )
    )
    return found


# ---- section III -------------------------------------------------------------------------------------------------


def _surfaces() -> list[Row]:
    d2, d3, d4, r2 = derived.D2, derived.D3, derived.D4, derived.R2
    a_square, b_square = derived.squares()
    contact = derived.double_contact(1, -1)
    one = sp.numer(sp.together(contact["h_kappa"] - contact["kappa"]))
    printed = (d3**2 + r2**2 - ((d3**2 + r2**2) ** 2 - (d3**2 - r2**2) * d2**2) / derived.M) / 2
    fourfold = derived.modulo(sp.numer(sp.together(one.subs(d4, sp.sqrt(printed))))) == 0
    valid = all(residual == 0 for residual in derived.contact_residuals(1, -1))
    second, third = derived.tangency()
    conditions = [d4**2 * (d3 + d2) ** 2 - d3**2 * a_square, d4**2 * (d3 - d2) ** 2 - d3**2 * b_square]
    met = [
        sp.expand(mine + condition) == 0 or sp.expand(mine - condition) == 0
        for mine, condition in zip((second, third), conditions, strict=True)
    ]
    how = "derive.orthogonal_designs.tangency()"
    false = derived.false_double_root()
    never = [sp.simplify(false[name]) == 0 for name in ("value", "slope")]
    return [
        shown_equal(
            "equation (2)",
            "C1, four equal roots",
            "d4² = (d3² + r2² - N/(AB))/2",
            bool(fourfold and valid),
            "derive.orthogonal_designs.double_contact(1, -1)",
            "for d2 = 1 in the paper, with N = (d3² + r2²)² - (d3² - r2²) d2² for any d2",
        ),
        shown_equal("equation (4)", "C2, the singular line tangent to S1", "d4 = d3 A/(1 + d3)", met[0], how),
        shown_equal("equations (5), (6)", "C3 and C4, tangent to S2 and S1", "d4 = d3 B/|d3 - 1|", met[1], how),
        claim(
            CASES,
            "no other surface separates",
            "one or more of five surfaces is not relevant",
            "on d4² = d3² + r2² two roots of the cusp polynomial meet, with z² < 0: no cusp"
            if all(never)
            else "not shown",
            all(never),
            "derive.orthogonal_designs.false_double_root()",
            "",
            "agrees",
        ),
    ]


def _domains() -> list[Row]:
    found = []
    for number, lengths in INSIDE.items():
        design = exact_domain(*lengths)
        cusps = certified_cusps(lengths).number
        row = compared(
            SHOWN[number],
            f"cusps in case {number}",
            PRINTED[number],
            float(cusps),
            f"orthogonal_3r({', '.join(map(str, lengths))}, exact=True).cusps()",
        )
        found.append(
            row
            if design.number == number
            else Row(SHOWN[number], row.quantity, row.paper, "", None, "DISAGREES", row.how)
        )
    counts = {}
    for number, lengths in INSIDE.items():
        arm = orthogonal_3r(*lengths, exact=True)
        rho, z = np.meshgrid(np.linspace(0.01, 10.0, 160), np.linspace(-9.0, 9.0, 161))
        counts[number] = int(arm.number_of_postures(rho, z).max())
    found.append(
        claim(
            CASES,
            "greatest number of postures in the five cases",
            "2, then 4 in the other four",
            ", ".join(str(counts[k]) for k in range(1, 6)),
            [counts[k] for k in range(1, 6)] == [2, 4, 4, 4, 4],
            "orthogonal_3r(...).number_of_postures(rho, z) on a grid",
        )
    )
    half = Fraction(1, 2)
    sides = [exact_domain(1, half, d4, half).number for d4 in (Fraction(7, 10), Fraction(71, 100))]
    found.append(
        claim(
            "before equation (6)",
            "what C4 separates",
            "cases 4 and 5",
            f"domains {sides[0]} and {sides[1]}",
            sides == [3, 5],
            "exact_domain(1, 1/2, d4, 1/2), d4 = 0.70 and 0.71",
            "cases 3 and 5: C4 exists for d3 < d2 only, where domain 4 has no part",
            "misprint",
        )
    )
    return found


def _figure_7() -> list[Row]:
    """The section r2 = 1: its domains, and that each printed curve is the border between two of them."""
    d3, d4 = np.meshgrid(np.linspace(0.01, 4.0, 200), np.linspace(0.01, 4.0, 200))
    met = sorted(set(classify_orthogonal_3r(1.0, d3, d4, 1.0).ravel().tolist()) - {0})
    x = np.linspace(0.05, 3.95, 79)
    a, b = np.hypot(x + 1.0, 1.0), np.hypot(x - 1.0, 1.0)
    with np.errstate(divide="ignore"):
        slanted = x / np.abs(x - 1.0) * b
    square = x**2 + 1.0
    curves = {
        "C1": np.sqrt(0.5 * (square - (square**2 - x**2 + 1.0) / (a * b))),
        "C2": x / (1.0 + x) * a,
        "C3": np.where(x > 1.0, slanted, np.nan),
        "C4": np.where(x < 1.0, slanted, np.nan),
    }
    found = {}
    for name, y in curves.items():
        known = np.isfinite(y)
        sides = [classify_orthogonal_3r(1.0, x[known], y[known] + step, 1.0) for step in (-1e-6, 1e-6)]
        pairs = sorted(set(zip(*(side.tolist() for side in sides), strict=True)))
        found[name] = " and ".join(map(str, pairs[0])) if len(pairs) == 1 else "several"
    expected = {"C1": "1 and 2", "C2": "2 and 3", "C3": "3 and 4", "C4": "3 and 5"}
    return [
        claim(
            "figure 7",
            "domains in the section r2 = 1",
            "1, 2, 3, 4, 5",
            ", ".join(map(str, met)),
            met == [1, 2, 3, 4, 5],
            "classify_orthogonal_3r(1, d3, d4, 1) on a grid",
        ),
        claim(
            "figure 7",
            "what the curves (2), (4), (5), (6) separate there",
            "1 and 2, 2 and 3, 3 and 4, 4 and 5",
            ", ".join(found.values()),
            found == expected,
            "classify_orthogonal_3r(1, d3, d4 +- 1e-6, 1) along each curve",
            "the last is 3 and 5, as the row before equation (6) says",
            "misprint",
        ),
    ]


# ---- section IV --------------------------------------------------------------------------------------------------


def printed_condition(d2: Any, d3: Any, d4: Any, r2: Any, corrected: bool = False) -> Any:
    """Condition (7) as the paper prints it, for arrays of designs; or corrected, with the numerator of (2).

    Example:
        >>> bool(printed_condition(1.0, 2.0, 1.5, 1.0))
        True
    """
    square = d3**2 + r2**2
    root = np.sqrt((d3 + d2) ** 2 + r2**2) * np.sqrt((d3 - d2) ** 2 + r2**2)
    numerator = square**2 - (d3**2 - r2**2 if corrected else square) * d2**2
    first = d4**2 > 0.5 * (square - numerator / root)
    with np.errstate(divide="ignore", invalid="ignore"):
        last = d4 < d3 / (d2 - d3) * np.sqrt((d3 - d2) ** 2 + r2**2)
    return first & ((d3 >= d2) | last)


def _condition() -> list[Row]:
    rng = np.random.default_rng(0)
    lengths = rng.uniform(0.0, 3.0, (200_000, 3))
    d3, d4, r2 = lengths.T
    domains = classify_orthogonal_3r(1.0, d3, d4, r2)
    true = np.isin(domains, (2, 3, 4))
    printed = printed_condition(1.0, d3, d4, r2)
    missed, wrong = int((true & ~printed).sum()), int((printed & ~true).sum())
    left = int((true != printed_condition(1.0, d3, d4, r2, corrected=True)).sum())
    example = lengths[np.flatnonzero(true & ~printed)[0]].round(2).tolist()
    cusps = certified_cusps((1, *(str(x) for x in example))).number
    judged = bool(printed_condition(1.0, *example))
    larger = sp.expand(derived.printed_numerator() - derived.N)
    never_larger = sp.simplify(larger + 2 * derived.R2**2 * derived.D2**2) == 0
    flat = orthogonal_3r(1, 2, "1.5", 0, exact=True)
    return [
        claim(
            "condition (7), first line",
            "numerator",
            "(d3² + r2²)² - (d3² + r2²) d2²",
            "(d3² + r2²)² - (d3² - r2²) d2², as in (2)",
            bool(never_larger),
            "derive.orthogonal_designs.printed_numerator()",
            "the printed one is smaller by 2 r2² d2², so that its bound on d4 is higher",
            "misprint",
        ),
        claim(
            "condition (7)",
            "a necessary and sufficient condition",
            "yes",
            f"sufficient only: {missed / int(true.sum()):.3f} of the cuspidal arms missed, {wrong} others called so",
            missed > 0 and wrong == 0 and left == 0,
            "printed_condition(...) against classify_orthogonal_3r(...), 200000 designs up to 3 d2",
            f"with the numerator of (2) it is both: {left} of the designs are judged wrongly; how many the printed one "
            "misses depends on where one looks, with r2 near 0 none",
            "misprint",
        ),
        claim(
            "condition (7)",
            f"d3, d4, r2 = {', '.join(f'{x:g}' for x in example)} (d2 = 1)",
            "noncuspidal" if not judged else "cuspidal",
            f"cuspidal: {cusps} cusps, counted exactly",
            cusps > 0 and not judged,
            "orthogonal_3r(..., exact=True).cusps()",
            "an arm that the printed condition misses, and the corrected one does not",
            "misprint",
        ),
        claim(
            "condition (7)",
            "r2 = 0",
            "not excluded: " + ("cuspidal" if printed_condition(1.0, 2.0, 1.5, 0.0) else "noncuspidal"),
            "never cuspidal" if not flat.cuspidal else "cuspidal",
            not flat.cuspidal and len(flat.cusps()) == 0,
            "orthogonal_3r(1, 2, 1.5, 0, exact=True).cuspidal",
            "for r2 other than 0, a hypothesis of the theorem",
            "true under a condition",
        ),
        _posture_changes(),
    ]


def _posture_changes() -> Row:
    changed = {}
    for number, lengths in INSIDE.items():
        arm = orthogonal_3r(*lengths, exact=True)
        example = arm.example()
        changed[number] = example is not None and arm.posture_change(*example.postures).certified
    with_path = [number for number, done in changed.items() if done]
    return claim(
        CONDITION,
        "cuspidal arms change posture without a singularity",
        "domains 2, 3, 4",
        "a proved path in domains " + ", ".join(map(str, with_path)),
        with_path == [2, 3, 4],
        "orthogonal_3r(...).posture_change()",
    )


# ---- topologies ------------------------------------------------------------------------------------------------------


def _topologies() -> list[Row]:
    rng = np.random.default_rng(1)
    lengths = rng.uniform(0.0, 3.0, (200_000, 3))
    topologies = topology_orthogonal_3r(1.0, *lengths.T)
    second = set(topologies[classify_orthogonal_3r(1.0, *lengths.T) == 2].tolist()) - {0}
    met = sorted(set(topologies.tolist()) - {0})
    seen = {}
    for topology in met:
        first = [Fraction(x).limit_denominator(1000) for x in lengths[np.flatnonzero(topologies == topology)[0]]]
        design = orthogonal_3r(1, *first, exact=True)
        seen[topology] = (len(design.cusps()), len(design.nodes()))
    text = " ".join(f"{cusps}/{nodes}" for cusps, nodes in seen.values())
    expected = [(0, 0), (4, 2), (4, 0), (4, 2), (2, 1), (2, 3), (4, 4), (0, 0), (0, 2)]
    return [
        claim(
            CASES,
            "topologies of the workspace",
            "five cases",
            f"nine, by cusps/nodes: {text}",
            list(seen.values()) == expected,
            "topology_orthogonal_3r(...), and orthogonal_3r(..., exact=True).cusps(), .nodes() of one arm of each",
            "if cusps alone are counted; the surfaces (A - B)/2, d3 and (A + B)/2 of the nodes cut the domains further",
            "true under a condition",
        ),
        claim(
            "after equation (3)",
            "instances of case 2",
            "figure 4 and two others",
            f"{len(second)}",
            len(second) == 3,
            "topology_orthogonal_3r(...) of the designs in domain 2",
        ),
    ]


def figures() -> dict[str, Figure]:
    """Figures 2 to 7; figures 3 to 6 print no numbers, so that designs of the same cases stand for them."""
    from chainrule.plot.cuspidality import draw_design
    from chainrule.plot.design_space import draw_domains

    hole = (1, "0.5", "0.45", "0.5")  # domain 2 with a hole, as in figure 4
    drawn = {"2a": INSIDE[2], "2b": INSIDE[3], "3": INSIDE[1], "4": hole, "5": INSIDE[4], "6": INSIDE[5]}
    found = {f"figure-{name}": draw_design(orthogonal_3r(*lengths, exact=True)) for name, lengths in drawn.items()}
    return found | {"figure-7": draw_domains()}
