"""Where the arm is singular: derived where it can be, else what is certain and what a search found."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import sympy as sp

from chainrule.arm import Arm
from chainrule.derive import catalogue, orthogonal_3r, planar_3r
from chainrule.report import mathml
from chainrule.report.content import Block, Finding, Formulas, Grid, Part, Points, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import Column, Table, posture, readable


def _planar_3r(arm: Arm) -> tuple[list[Block], dict[str, object], str]:
    symbolic = catalogue.symbolic(arm.description.model)
    found = planar_3r.singular_set(symbolic)
    q2, q3 = symbolic.inputs[0].symbols[1:]
    rows = tuple(
        (f"{math.degrees(float(pair[q2])):g}", f"{math.degrees(float(pair[q3])):g}", _stretched(pair, q2, q3))
        for pair in found
    )
    table = Table(
        "Singular configurations, at any q₁",
        (Column("q2", "q2", "deg"), Column("q3", "q3", "deg"), Column("links", "the links")),
        rows,
    )
    return (
        [
            Finding(
                f"The arm is singular in exactly {len(found)} pairs (q₂, q₃): where all three links lie on one line."
            ),
            Prose(
                "Derived by solving the vanishing of all three minors over (−π, π]: M₂₃ gives q₃, then M₁₃ gives "
                "q₂, and M₁₂ vanishes there too. It holds for all positive link lengths."
            ),
            Grid(table),
        ],
        {"singular": [[float(pair[q2]), float(pair[q3])] for pair in found], "proved": True},
        (
            "Avoid postures with all three links in one line (q2 and q3 each 0° or 180°): there, and nowhere else, it "
            "is singular."
        ),
    )


def _stretched(pair: dict[Any, Any], q2: Any, q3: Any) -> str:
    words = {True: "on", False: "back"}
    return f"second link {words[pair[q2] == 0]}, third link {words[pair[q3] == 0]} along the one before"


def _orthogonal(arm: Arm) -> tuple[list[Block], dict[str, object], str]:
    factors = [f for f in mathml.factors(orthogonal_3r.determinant())[1] if f.has(sp.sin, sp.cos)]
    lines = tuple(mathml.math(mathml.row(mathml.inner(f), mathml.operator("="), "<mn>0</mn>")) for f in factors)
    geometry = arm.description.geometry
    d3, d4 = (getattr(geometry, name) for name in ("d3", "d4"))
    blocks: list[Block] = [
        Finding(f"The arm is singular exactly where one of {len(factors)} factors of the determinant vanishes."),
        Formulas(lines, "Factors"),
    ]
    if abs(d3) <= abs(d4) and d4 != 0:
        angle = math.degrees(math.acos(-d3 / d4))
        blocks.append(
            Prose(
                f"The factor without q₂ vanishes at q₃ = ±{angle:.4g}°, because |d₃| does not exceed |d₄|: there the "
                "tip lies on the axis of joint 2."
            )
        )
    else:
        blocks.append(
            Prose(
                "The factor without q₂ never vanishes here, because |d₃| exceeds |d₄|: the tip cannot reach the axis "
                "of joint 2."
            )
        )
    avoid = "Avoid the two curves over q2 and q3 that are dashed in its map: there, and nowhere else, it is singular."
    return blocks, {"factors": [str(f) for f in factors], "proved": True}, avoid


def _general(arm: Arm, context: Context) -> tuple[list[Block], dict[str, object], str]:
    task = context.task
    assert task is not None
    if not context.depends_on and context.maximum.value > 0.0:
        return (
            [
                Finding(
                    "The arm is never singular: "
                    f"H is the same, {readable(context.maximum.value)}, in every configuration."
                )
            ],
            {"smallest_H": context.maximum.value, "proved": True},
            "It is never singular.",
        )
    certain = _certain(arm, context, task)
    found = context.minimum
    scale = float(arm.manipulability(context.maximum.q, task=task))
    jacobian = np.asarray(arm.jacobian(found.q, task=task))
    values = np.linalg.svd(jacobian, compute_uv=False)
    rank = int((values > 1e-6 * values[0]).sum())
    blocks: list[Block] = [
        Prose("No closed form of the singular set is derived for this arm. This is certain:"),
        Points(certain),
    ]
    at = posture(arm, found.q)
    if found.value < 1e-6 * scale:
        blocks.append(
            Finding(
                f"A search inside the joint limits meets singular configurations: H falls to "
                f"{readable(found.value, 2)}, where the Jacobian's rank is {rank} of {arm.tasks[task]}."
            )
        )
        blocks.append(
            Prose(
                f"For example at {at}. The search (20 000 random configurations, the lowest twelve refined by "
                "descent on H²) shows that singular configurations exist; it does not list them all."
            )
        )
    else:
        blocks.append(
            Finding(
                f"A search inside the joint limits found no singular configuration: the smallest H it met is "
                f"{readable(found.value, 3)}."
            )
        )
        blocks.append(
            Prose(
                f"It is met at {at}. The search (20 000 random configurations, the lowest twelve refined by descent "
                "on H²) is no proof that there is none."
            )
        )
    return (
        blocks,
        {
            "smallest_H": found.value,
            "q": found.q.tolist(),
            "rank": rank,
            "certain": list(certain),
            "proved": False,
        },
        _avoid(arm, at, found.value < 1e-6 * scale),
    )


def _avoid(arm: Arm, at: str, met: bool) -> str:
    """What to keep away from, as far as the search tells."""
    if met:
        return f"Avoid its singular configurations, which exist within its ranges: one is at {at}."
    return "No singular configuration was found within its ranges, which proves nothing."


def _certain(arm: Arm, context: Context, task: str) -> tuple[str, ...]:
    """What follows from the structure of the derived program alone."""
    programs = {f.name: f.program for f in catalogue.functions(arm.description.model, task)}
    program = programs[f"manipulability_{task}"]
    symbols = program.inputs[0].symbols
    used = {s for step in program.steps for s in step.expression.free_symbols}
    used |= {s for output in program.outputs for e in output.expressions for s in e.free_symbols}
    absent = [i for i, symbol in enumerate(symbols, 1) if symbol not in used]
    statements = []
    if absent:
        names = " and ".join(f"q{i}" for i in absent) if len(absent) < 3 else ", ".join(f"q{i}" for i in absent)
        statements.append(
            f"H does not depend on {names}: {'it does' if len(absent) == 1 else 'they do'} not appear in the "
            "derived formula, so singular configurations come in whole families."
        )
    rows = arm.tasks[task]
    if arm.n > rows:
        statements.append(
            f"The arm is singular only where all {math.comb(arm.n, rows)} maximal minors vanish together."
        )
    else:
        statements.append("The arm is singular exactly where the determinant of its Jacobian vanishes.")
    if f"minors_{task}" in programs:
        zero = sum(e == 0 for e in programs[f"minors_{task}"].outputs[0].expressions)
        if zero:
            statements.append(
                f"{zero} of the minors are zero in every configuration, so {math.comb(arm.n, rows) - zero} decide."
            )
    return tuple(statements)


def _build(arm: Arm, context: Context) -> Part:
    model = arm.description.model
    if model.name == "planar_rrr" and context.task == "position" and min(model.parameters) > 0.0:
        blocks, data, headline = _planar_3r(arm)
    elif model.family == "orthogonal_3r" and context.task == "position":
        blocks, data, headline = _orthogonal(arm)
    else:
        blocks, data, headline = _general(arm, context)
    return Part(tuple(blocks), data, headlines=(headline,))


SECTION = Section("singular", "Singular configurations", lambda arm: bool(arm.full_rank_tasks), _build)
