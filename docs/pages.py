"""Writes the pages of theory from the derivations and those of the papers from what is recomputed.

``python docs/pages.py`` writes docs/theory/*.md and docs/papers/*.md (two minutes: it recomputes every paper);
``python docs/pages.py theory`` or a paper's key writes those alone. Prose is in templates/pages/, formulas and numbers
come from ``chainrule.derive`` and ``chainrule.papers``. The pages are committed; tests compare them with new ones.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import sympy as sp
from jinja2 import Environment, FileSystemLoader, StrictUndefined

from chainrule.derive import (
    manipulability,
    nodes_3r,
    orthogonal_3r,
    orthogonal_designs,
    planar,
    planar_3r,
    planar_dynamics,
    planar_motion,
    quartic,
    redundancy,
    regional_3r,
    rest_to_rest,
    self_motion_planar_3r,
    speed_ratio,
    speed_ratio_4,
)
from chainrule.derive.chain import jacobian as chain_jacobian
from chainrule.derive.program import Steps

sys.path.insert(0, str(Path(__file__).resolve().parent))
from latex import aligned, block, equations, latex, listing, name, step_lines

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"


def _planar_arm(kinds: str = "RRR") -> planar.PlanarChain:
    return planar.planar_chain(kinds, tuple(f"l{i + 1}" for i in range(len(kinds))))


def kinematics() -> dict[str, str]:
    """Planar arms and arms in space: the steps that are generated."""
    return {
        "planar": listing(planar.kinematics(_planar_arm(), "position")),
        "spatial": listing(chain_jacobian(orthogonal_3r.orthogonal_chain(), "position")),
    }


def largest_minors() -> dict[str, str]:
    """Minors, H and null vector of any 2 x 3 Jacobian, then in closed form for the planar 3R arm."""
    entries = [[sp.Symbol(f"J{row}_{column}") for column in (1, 2, 3)] for row in (1, 2)]
    steps = Steps()
    minors = manipulability.maximal_minors(steps, entries)
    height = manipulability.root_sum_of_squares(steps, minors)
    null = manipulability.null_vector_from_minors(minors)
    arm = _planar_arm()
    closed = planar_3r.closed_minors(arm)
    pairs = ("M12", "M13", "M23")
    singular = planar_3r.singular_set(arm)
    return {
        "general": aligned(
            [
                *((name(step.symbol.name), latex(step.expression)) for step in steps.steps if "_" in step.symbol.name),
                ("H", latex(height.xreplace({s.symbol: s.expression for s in steps.steps if "sum" in s.symbol.name}))),
                *((f"N_{{{j}}}", latex(entry)) for j, entry in enumerate(null, 1)),
            ]
        ),
        "closed": equations(zip(pairs, closed, strict=True)),
        "height": equations([("H^{2}", sum((m**2 for m in closed), sp.Integer(0)))]),
        "singular": block(
            r",\quad ".join(
                "(" + ", ".join(f"{latex(q)} = {latex(value)}" for q, value in found.items()) + ")"
                for found in singular
            )
        ),
        "singular_count": str(len(singular)),
        "submatrices_6_8": str(manipulability.submatrices(6, 8)),
        "null": equations(
            (f"N_{{{j}}}", e) for j, e in enumerate(manipulability.null_vector_from_minors(list(closed)), 1)
        ),
    }


def self_motion() -> dict[str, str]:
    """The planar 3R arm: differences of the roots, and what is generated from them."""
    arm, r = _planar_arm(), self_motion_planar_3r.REACH.symbols[0]
    lengths, sums = arm.inputs[1].symbols, self_motion_planar_3r.SUMS.symbols
    found = {}
    for task, reach in (("position", r), ("x_alpha", sp.Symbol("X", real=True))):
        exact = dict(zip(sums, self_motion_planar_3r.exact_sums(task, lengths, reach), strict=True))
        parts = self_motion_planar_3r.differences(task, lengths, reach, sums)
        found[f"differences_{task}"] = equations(
            (f"{pair[0]} - {pair[1]}", value.xreplace(exact)) for pair, value in parts.items()
        )
    found["gaps"] = listing(self_motion_planar_3r.gaps(arm, "position"))
    return found


def three_joints() -> dict[str, str]:
    """Any 3R arm: the point, the elimination, the determinant, and what decides a quartic."""
    arm = regional_3r.arm()
    f, g = arm.point, arm.slopes
    rho1, rho2 = regional_3r.triple_conditions(arm)
    a, b, c = regional_3r.determinant_parts(arm)
    u, v = regional_3r.mismatch(arm)
    first, second = quartic.invariants()
    below, apart = quartic.shifted()
    return {
        "point": equations([*((f"f{k}", e) for k, e in enumerate(f, 1))]),
        "placed": aligned(step_lines(_placed(arm))),
        "squares": equations([("F3", arm.square), ("F4", arm.height), ("W", arm.width), ("U", u), ("V", v)]),
        "elimination": equations([("E", _in_names(arm))]),
        "slopes": equations([("g3", g[0]), ("g4", g[1]), ("gw", g[2])]),
        "determinant": equations([("a", a), ("b", b), ("c", c)]),
        "cusp": equations([("rho1", rho1), ("rho2", rho2)]),
        "cusp_orthogonal": equations([("0", regional_3r.cusp_condition(orthogonal_3r.normal_form()))]),
        "aspect_orthogonal": equations([("0", regional_3r.aspect_condition(orthogonal_3r.normal_form()))]),
        "invariants": equations([("I", first), ("J", second)]),
        "shifted": equations([(r"8 e_{4}^{2} q", below), (r"64 e_{4}^{4} \left(s - q^{2}/4\right)", apart)]),
        "conic": block(latex(sp.Matrix(nodes_3r.conic(orthogonal_3r.normal_form())))),
    }


def _placed(arm: regional_3r.Arm) -> Sequence[Any]:
    steps = Steps()
    regional_3r.placed(steps, arm)
    return [step for step in steps.steps if not step.symbol.name.startswith("f")]


def _in_names(arm: regional_3r.Arm) -> Any:
    """E with U, V and W by their names."""
    u, v = regional_3r.mismatch(arm)
    named = {u**2: sp.Symbol("U") ** 2, v**2: sp.Symbol("V") ** 2, arm.width: sp.Symbol("W")}
    return regional_3r.elimination(arm).subs(named, simultaneous=True)


def orthogonal() -> dict[str, str]:
    """The orthogonal family: its determinant and the surfaces of its design space."""
    designs = orthogonal_designs
    a, b = designs.squares()
    sides = designs.squared_sides()
    second, third = designs.tangency()
    contacts = {(mean, sense): designs.double_contact(mean, sense) for mean in (1, -1) for sense in (1, -1)}
    rest = {residual for pair in contacts for residual in designs.contact_residuals(*pair)}
    contact = contacts[1, 1]
    false = designs.false_double_root()
    return {
        "determinant": equations([(r"\det \mathbf{J}", orthogonal_3r.determinant())]),
        "squares": equations([("A^{2}", a), ("B^{2}", b), ("P", designs.P), ("N", designs.N)]),
        "printed": equations([("N", designs.printed_numerator())]),
        "c1": equations([("0", sides["C1_whole"] + sides["C1_factor"] * sp.Symbol("A") * sp.Symbol("B"))]),
        "tangency": equations([("0", sp.factor(second)), ("0", sp.factor(third))]),
        "node_surfaces": equations([("0", sides["E"]), ("0", sides["E2"])]),
        "contact": equations(
            [("u_{0}", contact["u0"]), (r"\kappa", contact["kappa"]), ("z^{2}", contact["z_squared"])]
        ),
        "contact_rest": ", ".join(sorted(map(str, rest))),
        "false_root": equations(
            [
                (r"\text{value}", false["value"]),
                (r"\text{slope}", false["slope"]),
                (r"z^{2} d_{2}^{2} \left(d_{3}^{2} + r_{2}^{2}\right)^{2}", sp.factor(false["z_squared"])),
            ]
        ),
    }


def speed_ratios() -> dict[str, str]:
    """A tip's derivatives, the double root of (7), the parabola, and the sextic that is a cubic."""
    arm = _planar_arm()
    plain, derived = speed_ratio.plain_elimination(arm, 1)
    a1, a2, a3 = plain
    rates = speed_ratio.rates(arm)
    wanted = {"p2", "p1", "p0", "gap", "slack"}
    v, along, third, k, rho = sp.symbols("v rt2 rn3 kappa rho")
    links = planar_motion.link_derivatives(3)
    return {
        "links": aligned(
            (rf"\left(a e^{{i\varphi}}\right)^{{({order})}}", _turning(*pair))
            for order, pair in enumerate(links[1:], 1)
        ),
        "quadratic": equations((f"a_{{{k}}}", sp.factor(e)) for k, e in enumerate(derived, 1)),
        "discriminant": str(sp.simplify(a2**2 - 4 * a1 * a3)),
        "same": str(sp.simplify(sp.Matrix(plain) * derived[0] - sp.Matrix(derived) * plain[0]) == sp.zeros(3, 1)),
        "parabola": aligned(step_lines([s for s in rates.steps if s.symbol.name in wanted])),
        "cubic": equations([("0", speed_ratio_4.cubic(v, along, third, k, rho))]),
        "reduction": str(speed_ratio_4.reduction()),
    }


def _turning(along: Any, across: Any) -> str:
    """A derivative in the heading's frame."""
    return rf"\left[\,{latex(along)} + i \left({latex(across)}\right)\right] e^{{i\varphi}}"


def minimum_time() -> dict[str, str]:
    """The profiles as they are generated."""
    return {
        "profile": listing(rest_to_rest.profile()),
        "stretched": listing(rest_to_rest.stretched()),
        "state": listing(rest_to_rest.state()),
    }


def joints_to_spare() -> dict[str, str]:
    """The step along the position of the planar 3R arm, and inverse dynamics of two joints, as they are generated."""
    arm = _planar_arm()
    return {
        "step": listing(redundancy.step(planar, arm, "position", planar_3r.minors(arm))),
        "dynamics": listing(planar_dynamics.inverse_dynamics(_planar_arm("RR"))),
    }


#: The pages of theory and where their formulas come from.
THEORY: dict[str, Callable[[], dict[str, str]]] = {
    "kinematics": kinematics,
    "manipulability": largest_minors,
    "self-motion": self_motion,
    "three-joints": three_joints,
    "orthogonal-arms": orthogonal,
    "speed-ratios": speed_ratios,
    "minimum-time": minimum_time,
    "joints-to-spare": joints_to_spare,
}


def _template(key: str) -> Any:
    loader = FileSystemLoader(ROOT / "templates" / "pages")
    environment = Environment(loader=loader, undefined=StrictUndefined, autoescape=False, keep_trailing_newline=True)
    environment.filters["cell"] = cell
    return environment.get_template(key)


def theory_page(key: str) -> str:
    """A page of theory."""
    text: str = _template(f"{key}.md.j2").render(THEORY[key]())
    return text


def cell(text: str) -> str:
    """Text for a cell of a Markdown table."""
    return re.sub(r"([|*_\\])", r"\\\1", " ".join(str(text).split())).replace("<", "&lt;")


def paper_page(key: str, rows: Sequence[Any] | None = None) -> str:
    """A paper's page, from what :func:`chainrule.papers.reproduce` gives (recomputed unless given)."""
    from chainrule.papers import PAPERS, VERDICTS, reproduce

    found = reproduce(key) if rows is None else rows
    counts = {verdict: sum(row.verdict == verdict for row in found) for verdict in VERDICTS}
    text: str = _template("paper.md.j2").render(
        key=key, paper=PAPERS[key], rows=found, counts=counts, verdicts=VERDICTS, images=_figures(key)
    )
    return text


def _figures(key: str) -> list[str]:
    return sorted(path.name for path in (DOCS / "images").glob(f"{key}-*.svg"))


_NUMBER = re.compile(r"(?<![\w.])[-+−]?\d+(?:,\d{3})*(?:\.\d+)?(?:e[-+]?\d+)?")


def same_but_for_rounding(first: str, second: str, open_: Sequence[str] = ()) -> bool:
    """Whether two pages agree: the same words, and numbers that differ only in what rounding may change.

    Lines that hold one of the texts in ``open_`` need the same words only: their numbers are times, or of motions that
    rounding decides.
    """
    for text in open_:
        first, second = (
            "\n".join(_NUMBER.sub("#", line) if text in line else line for line in page.splitlines())
            for page in (first, second)
        )
    if _NUMBER.sub("#", first) != _NUMBER.sub("#", second):
        return False
    pairs = zip(_NUMBER.findall(first), _NUMBER.findall(second), strict=True)
    values = [[float(text.replace(",", "").replace("−", "-")) for text in pair] for pair in pairs]
    return all(abs(a - b) <= 1e-5 * max(abs(a), abs(b)) or max(abs(a), abs(b)) < 1e-7 for a, b in values)


def main(wanted: Sequence[str]) -> None:
    """Write the pages asked for, or all."""
    from chainrule.papers import PAPERS

    for key in THEORY if not wanted or "theory" in wanted else ():
        (DOCS / "theory" / f"{key}.md").write_text(theory_page(key), "utf-8")
        print(f"docs/theory/{key}.md", flush=True)
    for key in [key for key in PAPERS if not wanted or key in wanted]:
        (DOCS / "papers" / f"{key}.md").write_text(paper_page(key), "utf-8")
        print(f"docs/papers/{key}.md", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
