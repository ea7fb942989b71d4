"""Planar chains of revolute (R) and prismatic (P) joints with symbolic lengths and headings.

Joint i is R: the heading turns by theta_i, then the tip advances l_i along it. Joint i is P: the heading turns
by the constant heading_i, then the tip advances l_i + theta_i. Heading angles are never added up: the unit
vector of the heading is turned, so sines and cosines are needed of single inputs only.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.program import Expression, Input, Output, Program, Steps, variables
from chainrule.derive.view import View, identity

Pair = tuple[Expression, Expression]


@dataclass(frozen=True)
class PlanarChain:
    """A planar chain: joint kinds and its inputs ``q`` (n,) and ``lengths`` (n + number of P joints,)."""

    kinds: str
    inputs: tuple[Input, ...]

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.kinds)


def planar_chain(kinds: str, parameter_names: tuple[str, ...]) -> PlanarChain:
    """The symbolic chain; the input ``parameters`` holds the lengths, then the headings of the P joints."""
    symbols = tuple(sp.Symbol(name, real=True) for name in parameter_names)
    return PlanarChain(kinds, (variables("q", len(kinds)), Input("parameters", (len(symbols),), symbols)))


@dataclass(frozen=True)
class Layout:
    """Headings (unit vectors), the points where the joints sit, and the tip."""

    headings: list[Pair]
    points: list[Pair]
    tip: Pair


def layout(steps: Steps, arm: PlanarChain, first: int = 0) -> Layout:
    """Headings and points, seen from the base (``first=0``) or turned back by the first joint's heading."""
    q, parameters = arm.inputs[0].symbols, arm.inputs[1].symbols
    turning = iter(parameters[arm.n :])
    heading: Pair = (sp.Integer(1), sp.Integer(0))
    point: Pair = (sp.Integer(0), sp.Integer(0))
    headings, points = [], []
    for i, kind in enumerate(arm.kinds):
        points.append(point)
        angle, advance = (q[i], parameters[i]) if kind == "R" else (next(turning), parameters[i] + q[i])
        if i >= first:
            c = steps.let(f"c{i + 1}", sp.cos(angle))
            s = steps.let(f"s{i + 1}", sp.sin(angle))
            heading = (
                steps.let(f"hx{i + 1}", heading[0] * c - heading[1] * s),
                steps.let(f"hy{i + 1}", heading[1] * c + heading[0] * s),
            )
        headings.append(heading)
        point = (
            steps.let(f"x{i + 1}", point[0] + advance * heading[0]),
            steps.let(f"y{i + 1}", point[1] + advance * heading[1]),
        )
    return Layout(headings, points, point)


def columns(steps: Steps, arm: PlanarChain, place: Layout) -> list[list[Expression]]:
    """Jacobian columns (x, y, alpha)."""
    result = []
    for i, kind in enumerate(arm.kinds):
        if kind == "P":
            result.append([*place.headings[i], sp.Integer(0)])
        else:
            dx = steps.let(f"rx{i + 1}", place.tip[0] - place.points[i][0])
            dy = steps.let(f"ry{i + 1}", place.tip[1] - place.points[i][1])
            result.append([-dy, dx, sp.Integer(1)])
    return result


ROWS = {"position": (0, 1), "x_alpha": (0, 2), "pose": (0, 1, 2)}


def matrix(steps: Steps, arm: PlanarChain, task: str, first: int = 0) -> list[list[Expression]]:
    """The task Jacobian by rows, in the base frame or (``first=1``) in that of the first heading."""
    found = columns(steps, arm, layout(steps, arm, first))
    return [[column[row] for column in found] for row in ROWS[task]]


def minor_matrix(steps: Steps, arm: PlanarChain, task: str) -> list[list[Expression]]:
    """Rows of a matrix with the minors and row space of the task Jacobian; without q_1 where the task allows."""
    return matrix(steps, arm, task, first=0 if task == "x_alpha" else 1)


def minor_view(steps: Steps, arm: PlanarChain, task: str) -> View:
    """How a velocity of the task becomes the one that :func:`minor_matrix` times the joints' rates is."""
    turn = identity(len(ROWS[task]))
    if task != "x_alpha":
        c, s = layout(steps, arm).headings[0]
        turn[0][:2], turn[1][:2] = [c, s], [-s, c]
    return View(turn, identity(len(turn)))


def place_output(place: Layout, task: str) -> Output:
    """Output ``position`` (2,) or ``pose`` (3, 3)."""
    if task == "position":
        return Output("position", (2,), place.tip)
    (c, s), (x, y) = place.headings[-1], place.tip
    zero, one = sp.Integer(0), sp.Integer(1)
    return Output("pose", (3, 3), (c, -s, x, s, c, y, zero, zero, one))


def placement(arm: PlanarChain, task: str) -> Program:
    """Position or pose of the tip."""
    steps = Steps()
    output = place_output(layout(steps, arm), task)
    return Program(
        output.name, f"{output.name} of the tip, in the base frame", arm.inputs, tuple(steps.steps), (output,)
    )


def jacobian_of(steps: Steps, arm: PlanarChain, place: Layout, task: str) -> Output:
    """Output ``jacobian`` (m, n)."""
    found = columns(steps, arm, place)
    return Output("jacobian", (len(ROWS[task]), arm.n), tuple(column[row] for row in ROWS[task] for column in found))


def jacobian(arm: PlanarChain, task: str) -> Program:
    """The task Jacobian in the base frame."""
    steps = Steps()
    output = jacobian_of(steps, arm, layout(steps, arm), task)
    return Program(
        f"jacobian_{task}", f"Jacobian of the {task} task, in the base frame", arm.inputs, tuple(steps.steps), (output,)
    )


def kinematics(arm: PlanarChain, task: str) -> Program:
    """Position (or pose) and Jacobian together."""
    steps = Steps()
    place = layout(steps, arm)
    outputs = (place_output(place, "position" if task == "position" else "pose"), jacobian_of(steps, arm, place, task))
    return Program(
        f"kinematics_{task}",
        f"{outputs[0].name} and the Jacobian of the {task} task",
        arm.inputs,
        tuple(steps.steps),
        outputs,
    )
