"""The one list of what is generated: :data:`CATALOGUE`.

To add a derivation: write it as a function from the symbolic arm to a :class:`Program`, add one line to the list, and
test it. The modules named in :func:`sources` are where a group's formulas come from; when one of them (or anything it
imports) is edited, that group is generated again, and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
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


class Subject:
    """What a line of the catalogue may ask for: the symbolic arm, its family's module, and a task."""

    def __init__(self, model: Model, task: str = "") -> None:
        self.model, self.task = model, task
        self.family, self.tasks = FAMILIES[model.family]
        self.closed = CLOSED_FORMS.get(model.name)
        self.arm = symbolic(model)

    @property
    def spare(self) -> int:
        """n - m, the joints that the task leaves free."""
        return len(self.model.kinds) - self.tasks[self.task]

    def matrix(self, steps: Steps) -> Any:
        """Rows with the minors and the row space of the task Jacobian."""
        return self.family.minor_matrix(steps, self.arm, self.task)

    @cached_property
    def weights(self) -> Program:
        """The minors of the task Jacobian (in closed form where one is derived), or its pivots."""
        if self.closed and self.task == "position":
            program: Program = self.closed.minors(self.arm)
            return program
        steps = Steps()
        return manipulability.weights_program(steps, self.arm.inputs, self.matrix(steps), self.task)

    @property
    def has_minors(self) -> bool:
        """Whether the task is treated by its minors."""
        return self.weights.outputs[0].name == "minors"

    def survey(self) -> Program | None:
        """Position, Jacobian and H together, where the closed forms make that cheap."""
        return self.closed.survey(self.arm) if self.closed and hasattr(self.closed, "survey") else None

    def null_vector(self) -> Program | None:
        """The null vector from the signed minors, where one joint is to spare."""
        return manipulability.null_vector(self.weights, self.task) if self.has_minors and self.spare == 1 else None

    def null_projector(self) -> Program | None:
        """The projector, where there is a null space and it is small enough to write out."""
        if not 0 < self.spare <= manipulability.MOST_PROJECTED - self.tasks[self.task]:
            return None
        steps = Steps()
        return manipulability.null_projector(steps, self.arm.inputs, self.matrix(steps), self.task)


@dataclass(frozen=True)
class Entry:
    """One line of the catalogue.

    ``group`` is ``"kinematics"`` (once for each model) or ``"manipulability"`` (one group for each task with no more
    rows than joints); ``derivation`` makes the program, or None where a model has no such function; ``each_task``
    repeats a line of the kinematics for every task; ``gradient`` asks for gradients of the program's norm or product.
    """

    group: str
    derivation: Callable[[Subject], Program | None]
    each_task: bool = False
    gradient: bool = False


CATALOGUE: tuple[Entry, ...] = (
    Entry("kinematics", lambda s: s.family.placement(s.arm, "position")),
    Entry("kinematics", lambda s: s.family.placement(s.arm, "pose")),
    Entry("kinematics", lambda s: s.family.jacobian(s.arm, s.task), each_task=True),
    Entry("kinematics", lambda s: s.family.kinematics(s.arm, s.task), each_task=True),
    Entry("kinematics", lambda s: s.survey()),
    Entry("manipulability", lambda s: manipulability.manipulability(s.weights, s.task)),
    Entry("manipulability", lambda s: s.weights, gradient=True),
    Entry("manipulability", lambda s: s.weights if s.has_minors else None),
    Entry("manipulability", lambda s: s.null_vector()),
    Entry("manipulability", lambda s: s.null_projector()),
)


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
    """The functions of one group of a model, in the order of the catalogue."""
    kind = "kinematics" if group == "kinematics" else "manipulability"
    every = tuple(FAMILIES[model.family][1])
    subjects = {task: Subject(model, task) for task in ("", *every)}
    found = []
    for entry in CATALOGUE:
        if entry.group != kind:
            continue
        for task in every if entry.each_task else ("" if kind == "kinematics" else group,):
            program = entry.derivation(subjects[task])
            if program is not None:
                name = f"manipulability_gradient_{task}" if entry.gradient else program.name
                found.append(Function(name, needed(program), entry.gradient))
    return found
