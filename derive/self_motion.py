"""What following a self-motion takes, for any arm with one joint more than its task has rows (n - m = 1).

The task is held where e(q) = 0; J is the Jacobian of e there, and N, the null vector of the signed minors, is tangent
to the curve. Along q' = N the null vector changes by (dN/dq) N, from which the curve's curvature and the change of
H = |N| along it follow. That derivative is taken here step by step (forward differentiation of the named steps).

e is, row by row: position minus target (m); for planar orientations the angle from the target's, in (-pi, pi]; for
spatial ones half the skew part of E = R R_target^T as a vector, sin(angle) times the axis of E.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

import sympy as sp

from chainrule.derive import chain, planar
from chainrule.derive.manipulability import maximal_minors, null_vector_from_minors
from chainrule.derive.program import Expression, Input, Output, Program, Steps


def target_input(family: ModuleType, task: str) -> Input:
    """The target: x, y(, z); x, alpha; x, y, alpha; or a homogeneous matrix (4, 4)."""
    if family is planar:
        labels = {"position": ("x", "y"), "x_alpha": ("x", "alpha"), "pose": ("x", "y", "alpha")}[task]
        return Input("held", (len(labels),), tuple(sp.Symbol(f"target_{label}", real=True) for label in labels))
    if task == "position":
        return Input("held", (3,), tuple(sp.Symbol(f"target_{label}", real=True) for label in "xyz"))
    return Input("held", (4, 4), tuple(sp.Symbol(f"target_{i}{j}", real=True) for i in range(4) for j in range(4)))


def _null_vector(steps: Steps, family: ModuleType, arm: Any, task: str) -> list[Expression]:
    minors = maximal_minors(steps, family.minor_matrix(steps, arm, task))
    return [steps.let(f"n{j}", entry) for j, entry in enumerate(null_vector_from_minors(minors), 1)]


@dataclass(frozen=True)
class Apart:
    """How far the tip is from its target.

    Attributes:
        lengths: the errors that are lengths, which come first.
        turn: sin(angle) of a planar orientation, or sin(angle) times the axis of a spatial one; empty without.
        cosine: cos(angle); 1 without an orientation.
        jacobian: the task Jacobian.
    """

    lengths: list[Expression]
    turn: list[Expression]
    cosine: Expression
    jacobian: Output


def apart(steps: Steps, family: ModuleType, arm: Any, task: str, target: Input) -> Apart:
    """The tip and its target (of :func:`target_input`), with the task Jacobian."""
    return (_planar if family is planar else _spatial)(steps, arm, task, target)


def _planar(steps: Steps, arm: planar.PlanarChain, task: str, target: Input) -> Apart:
    place = planar.layout(steps, arm)
    wanted = target.symbols
    rows = dict(zip({"position": "xy", "x_alpha": "xa", "pose": "xya"}[task], wanted, strict=True))
    lengths = [place.tip["xy".index(row)] - rows[row] for row in "xy" if row in rows]
    turn, cosine = [], sp.Integer(1)
    if "a" in rows:
        (c, s), alpha = place.headings[-1], rows["a"]
        c0, s0 = steps.let("cos_target", sp.cos(alpha)), steps.let("sin_target", sp.sin(alpha))
        turn, cosine = [steps.let("sin_apart", s * c0 - c * s0)], steps.let("cos_apart", c * c0 + s * s0)
    return Apart(lengths, turn, cosine, planar.jacobian_of(steps, arm, place, task))


def _spatial(steps: Steps, arm: chain.Chain, task: str, target: Input) -> Apart:
    frames = chain.frames_from_base(steps, arm)
    wanted = target.symbols
    if task == "position":
        lengths, turn, cosine = [a - b for a, b in zip(frames.tip.p, wanted, strict=True)], [], sp.Integer(1)
    else:
        columns = (frames.tip.x, frames.tip.y, frames.tip.z)
        relative = [
            [sum(columns[k][i] * wanted[4 * j + k] for k in range(3)) for j in range(3)]  # R R_target^T
            for i in range(3)
        ]
        lengths = [a - wanted[4 * i + 3] for i, a in enumerate(frames.tip.p)]
        turn = [
            steps.let(f"turn{i + 1}", (relative[k][j] - relative[j][k]) / 2)
            for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        ]
        cosine = (relative[0][0] + relative[1][1] + relative[2][2] - 1) / 2
    return Apart(lengths, turn, cosine, chain.jacobian_output(steps, arm, frames, task))


def held(family: ModuleType, arm: Any, task: str) -> Program:
    """How far the tip is from its target, the task Jacobian and the null vector, in one evaluation."""
    steps, target = Steps(), target_input(family, task)
    found = apart(steps, family, arm, task, target)
    turn = [sp.atan2(found.turn[0], found.cosine)] if family is planar and found.turn else found.turn
    errors = [*found.lengths, *turn]
    null = _null_vector(steps, family, arm, task)
    q, *parameters = arm.inputs
    return Program(
        f"continuation_{task}",
        f"error of the {task}, its Jacobian, and the null vector from its signed minors",
        (q, target, *parameters),
        tuple(steps.steps),
        (
            Output("error", (len(errors),), tuple(errors)),
            found.jacobian,
            Output("null_vector", (len(null),), tuple(null)),
        ),
    )


def bending(family: ModuleType, arm: Any, task: str) -> Program:
    """The null vector N, and its derivative along itself, (dN/dq) N."""
    steps = Steps()
    null = _null_vector(steps, family, arm, task)
    rates: dict[Expression, Expression] = dict(zip(arm.inputs[0].symbols, null, strict=True))
    for step in list(steps.steps):
        moving = sorted((s for s in step.expression.free_symbols if rates.get(s, 0) != 0), key=str)
        change = sum((sp.diff(step.expression, s) * rates[s] for s in moving), sp.Integer(0))
        rates[step.symbol] = steps.let(f"d_{step.symbol}", change)
    changes = [rate_of(entry, rates) for entry in null]
    return Program(
        f"continuation_{task}_bending",
        f"null vector of the {task} Jacobian, and its derivative along itself",
        arm.inputs,
        tuple(steps.steps),
        (Output("null_vector", (len(null),), tuple(null)), Output("bending", (len(null),), tuple(changes))),
    )


def rate_of(entry: Expression, rates: dict[Expression, Expression]) -> Expression:
    """The rate of a number, a symbol or a negated symbol."""
    if entry.is_Number:
        return sp.Integer(0)
    return rates[entry] if entry.is_Symbol else -rates[-entry]
