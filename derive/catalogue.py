"""The one list of what is generated: for each family of arms its functions, in groups that are compiled together.

To add a derivation: write it as a function from the symbolic arm to a :class:`Program`, and name it here. The
modules named in :func:`sources` are where a group's formulas come from; when one of them (or anything it imports)
is edited, that group is generated again, and nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from chainrule.derive import chain, manipulability, orthogonal_3r, planar, planar_3r
from chainrule.derive.program import Program, Steps, needed
from chainrule.description import Model

#: The module of each family, and its tasks with their number of rows.
FAMILIES: dict[str, tuple[ModuleType, dict[str, int]]] = {
    "serial": (chain, {"position": 3, "pose": 6}),
    "planar": (planar, {"position": 2, "x_alpha": 2, "pose": 3}),
    "orthogonal_3r": (chain, {"position": 3, "pose": 6}),
}

#: Models with results in closed form: ``minors(arm)`` of the position Jacobian and perhaps ``survey(arm)``.
CLOSED_FORMS: dict[str, ModuleType] = {"planar_rrr": planar_3r, "orthogonal_3r": orthogonal_3r}


@dataclass(frozen=True)
class Function:
    """One generated function: its program or, with ``gradient``, the gradients of that program's norm or product."""

    name: str
    program: Program
    gradient: bool = False


def groups(model: Model) -> tuple[str, ...]:
    """The groups of a model: ``kinematics``, then one for each task with no more rows than joints."""
    tasks = FAMILIES[model.family][1]
    return ("kinematics", *(task for task, rows in tasks.items() if rows <= len(model.kinds)))


def sources(model: Model, group: str) -> tuple[ModuleType, ...]:
    """The modules that a group's formulas are written in."""
    closed = [CLOSED_FORMS[model.name]] if model.name in CLOSED_FORMS else []
    general = [] if group == "kinematics" else [manipulability]
    return (FAMILIES[model.family][0], *closed, *general)


def symbolic(model: Model) -> Any:
    """The symbolic arm of a model: what derivations take."""
    if model.family == "planar":
        return planar.planar_chain(model.kinds, model.parameter_names)
    if model.family == "orthogonal_3r":
        return orthogonal_3r.orthogonal_chain()
    return chain.chain(model.kinds, model.placements, model.tool)


def functions(model: Model, group: str) -> list[Function]:
    """The functions of one group of a model."""
    made = _kinematics(model) if group == "kinematics" else _manipulability(model, group)
    return [Function(f.name, needed(f.program), f.gradient) for f in made]


def _kinematics(model: Model) -> list[Function]:
    (family, tasks), closed, arm = FAMILIES[model.family], CLOSED_FORMS.get(model.name), symbolic(model)
    programs = [
        family.placement(arm, "position"),
        family.placement(arm, "pose"),
        *(family.jacobian(arm, task) for task in tasks),
        *(family.kinematics(arm, task) for task in tasks),
        *([closed.survey(arm)] if hasattr(closed, "survey") else []),  # type: ignore[union-attr]
    ]
    return [Function(program.name, program) for program in programs]


def _manipulability(model: Model, task: str) -> list[Function]:
    (family, tasks), closed, arm = FAMILIES[model.family], CLOSED_FORMS.get(model.name), symbolic(model)
    steps = Steps()
    matrix = family.minor_matrix(steps, arm, task)
    if closed and task == "position":
        weights = closed.minors(arm)
    else:
        weights = manipulability.weights_program(steps, arm.inputs, matrix, task)
    found = [
        Function(f"manipulability_{task}", manipulability.manipulability(weights, task)),
        Function(f"manipulability_gradient_{task}", weights, gradient=True),
    ]
    if weights.outputs[0].name == "minors":
        found.append(Function(weights.name, weights))
        if arm.n == tasks[task] + 1:
            found.append(Function(f"null_vector_{task}", manipulability.null_vector(weights, task)))
    if tasks[task] < arm.n <= manipulability.MOST_PROJECTED:
        steps = Steps()
        matrix = family.minor_matrix(steps, arm, task)
        projector = manipulability.null_projector(steps, arm.inputs, matrix, task)
        found.append(Function(projector.name, projector))
    return found
