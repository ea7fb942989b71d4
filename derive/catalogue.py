"""The one list of what is generated: :data:`CATALOGUE`.

To add a derivation: write it as a function from the symbolic arm to a :class:`Program`, add one line to the list, and
test it. The modules named in :func:`sources` are where a group's formulas come from; when one of them (or anything it
imports) is edited, that group is generated again, and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import product
from types import ModuleType
from typing import Any

from chainrule.derive import (
    chain,
    dynamics,
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
    regional_postures,
    rest_to_rest,
    self_motion,
    self_motion_planar_3r,
    self_motion_sweep,
    speed_ratio,
    speed_ratio_4,
    spherical_joint,
)
from chainrule.derive.program import Program, Steps, needed
from chainrule.description import REGIONAL_3R, REST_TO_REST, Model, planar_model

#: The module of each family, and its tasks with their number of rows.
FAMILIES: dict[str, tuple[ModuleType, dict[str, int]]] = {
    "serial": (chain, {"position": 3, "pose": 6}),
    "planar": (planar, {"position": 2, "x_alpha": 2, "pose": 3}),
    "orthogonal_3r": (chain, {"position": 3, "pose": 6}),
    "regional_3r": (regional_3r, {}),
    "motion": (rest_to_rest, {}),
}

#: Models, and groups of them, that are generated although no embedded arm needs them: motion profiles, the normal form
#: of any 3R arm, and of the planar arms of three joints what speed ratios and following a path take.
STANDING: dict[Model, tuple[str, ...]] = {
    REST_TO_REST: ("rest_to_rest",),
    REGIONAL_3R: ("cuspidality",),
    **{planar_model("".join(kinds)): ("kinematics", "motion", "speed_ratio") for kinds in product("RP", repeat=3)},
}

#: Groups that are made on first use (:func:`first_use`) but are generated beforehand for these models.
SHIPPED: dict[str, tuple[str, ...]] = dict.fromkeys(("panda", "sanchez_8r"), ("redundancy_pose", "dynamics"))

#: Models with results in closed form: ``minors(arm)`` of the position Jacobian, perhaps ``survey(arm)`` and the like.
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
        self.planar = self.family is planar
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

    def closed_form(self, name: str) -> Program | None:
        """A result that is known in closed form for this model only."""
        found: Program | None = getattr(self.closed, name)(self.arm) if hasattr(self.closed, name) else None
        return found

    @cached_property
    def regional(self) -> regional_3r.Arm:
        """The normal form of a 3R arm."""
        return regional_3r.arm() if self.family is regional_3r else orthogonal_3r.normal_form()

    def right_angle(self, derivation: Callable[[regional_3r.Arm], Program]) -> Program | None:
        """What differs where alpha2 = +-90 deg, for the general 3R arm."""
        return None if self.regional.right_angle else derivation(regional_3r.right_angled(self.regional))

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

    ``group`` is ``"kinematics"`` (once for each model), ``"manipulability"`` (one group for each task with no more
    rows than joints) or the name of a group that only some models have (:func:`extras`); ``derivation`` makes the
    program, or None where a model has no such function; ``each_task`` repeats a line of the kinematics for every task;
    ``gradient`` asks for gradients of the program's norm or product.
    """

    group: str
    derivation: Callable[[Subject], Program | None]
    each_task: bool = False
    gradient: bool = False


def speed_ratio_terms(subject: Subject, leading: int) -> Program | None:
    """Equations (5) to (9) of Ambike for a leading joint (from 1)."""
    return speed_ratio.terms(subject.arm, leading) if subject.arm.n == 3 else None


def postures_in_pairs(subject: Subject, parallel: bool) -> Program | None:
    """What takes the place of the quartic where axes 1 and 2 intersect or are parallel, for the general 3R arm."""
    return None if subject.regional.right_angle else regional_postures.postures_in_pairs(subject.regional, parallel)


def closed_self_motion(subject: Subject, make: Callable[[Any, str], Program], task: str) -> Program | None:
    """A function of the self-motion of the planar 3R arm, known in closed form."""
    return make(subject.arm, task) if subject.model.name == "planar_rrr" else None


def continuation(subject: Subject, make: Callable[[ModuleType, Any, str], Program], task: str) -> Program | None:
    """What following a self-motion takes, for tasks that leave one joint free."""
    model = subject.model
    return make(subject.family, subject.arm, task) if f"continuation_{task}" in continuations(model) else None


@dataclass(frozen=True)
class Curve:
    """A curve on which a task is held, as the template that follows it sees it.

    Attributes:
        task: the task.
        kinds: the joints' kinds.
        parameters: whether the functions take the family's numbers.
        positions: how many of the task's first rows are lengths.
        whole: 1 where these rows are the whole velocity of the tip, else 0.
        spatial: 1 where three rows of a spatial orientation follow, else 0.
    """

    task: str
    kinds: str
    parameters: bool
    positions: int
    whole: int
    spatial: int


def curve(model: Model, group: str) -> Curve | None:
    """The curve that the functions of a group ``continuation_<task>`` follow."""
    if group not in continuations(model):
        return None
    task = group.removeprefix("continuation_")
    flat = model.family == "planar"
    positions = {"x_alpha": 1}.get(task, 2) if flat else 3
    spatial = int(not flat and task == "pose")
    return Curve(task, model.kinds, bool(model.parameter_names), positions, int(task != "x_alpha"), spatial)


def redundancy_step(subject: Subject, task: str) -> Program | None:
    """The step along a task."""
    own = Subject(subject.model, task)
    return redundancy.step(own.family, own.arm, task, own.weights)


def priority_step(subject: Subject, task: str) -> Program | None:
    """The step along a task, with a secondary task."""
    own = Subject(subject.model, task)
    return redundancy.priority(own.family, own.arm, task, own.weights, own.spare)


def sweep(subject: Subject, make: Callable[[regional_3r.Arm], Program]) -> Program | None:
    """What sweeping a joint of a redundant arm takes: of the general 3R arm only."""
    return make(subject.regional) if subject.family is regional_3r else None


def spherical(subject: Subject, make: Callable[[], Program]) -> Program | None:
    """What axes that meet in a point take: of no arm, kept with the general 3R arm, whose wrist they are."""
    return make() if subject.family is regional_3r else None


def continuations(model: Model) -> tuple[str, ...]:
    """Groups with what following a self-motion takes: one for each task with one row less than there are joints."""
    tasks = FAMILIES[model.family][1]
    return tuple(f"continuation_{task}" for task, rows in tasks.items() if len(model.kinds) - rows == 1)


CATALOGUE: tuple[Entry, ...] = (
    Entry("kinematics", lambda s: s.family.placement(s.arm, "position")),
    Entry("kinematics", lambda s: s.family.placement(s.arm, "pose")),
    Entry("kinematics", lambda s: s.family.jacobian(s.arm, s.task), each_task=True),
    Entry("kinematics", lambda s: s.family.kinematics(s.arm, s.task), each_task=True),
    Entry("kinematics", lambda s: s.closed_form("survey")),
    Entry("kinematics", lambda s: s.closed_form("postures")),
    Entry("manipulability", lambda s: manipulability.manipulability(s.weights, s.task)),
    Entry("manipulability", lambda s: s.weights, gradient=True),
    Entry("manipulability", lambda s: s.weights if s.has_minors else None),
    Entry("manipulability", lambda s: s.null_vector()),
    Entry("manipulability", lambda s: s.null_projector()),
    Entry("motion", lambda s: planar_motion.tip_motion(s.arm)),
    *(Entry("speed_ratio", partial(speed_ratio_terms, leading=k)) for k in (1, 2, 3)),
    Entry("speed_ratio", lambda s: speed_ratio.rates(s.arm) if s.arm.n == 3 else None),
    Entry("speed_ratio", lambda s: speed_ratio_4.conditions(s.arm) if s.arm.n == 4 else None),
    *(Entry("self_motion", partial(closed_self_motion, make=make, task=t)) for t, make in self_motion_planar_3r.EVERY),
    *(
        Entry(f"continuation_{task}", partial(continuation, make=make, task=task))
        for task in ("position", "x_alpha", "pose")
        for make in (self_motion.held, self_motion.bending)
    ),
    Entry("cuspidality", lambda s: regional_3r.quartic(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.cusp_polynomial(s.regional)),
    Entry("cuspidality", lambda s: s.right_angle(regional_3r.cusp_polynomial)),
    Entry("cuspidality", lambda s: regional_3r.aspect_polynomial(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.determinant_terms(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.determinant(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.second_axis(s.regional)),
    Entry("cuspidality", lambda s: quartic.quartic_invariants() if s.family is regional_3r else None),
    Entry("cuspidality", lambda s: regional_3r.triple_point(s.regional)),
    Entry("cuspidality", lambda s: s.right_angle(regional_3r.triple_point)),
    Entry("cuspidality", lambda s: regional_3r.image(s.regional)),
    Entry("cuspidality", lambda s: nodes_3r.conic_terms(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.shoulder(s.regional)),
    Entry("cuspidality", lambda s: regional_3r.unturned(s.regional)),
    Entry("cuspidality", lambda s: regional_postures.number_of_postures(s.regional)),
    Entry("cuspidality", lambda s: regional_postures.postures(s.regional) if s.family is regional_3r else None),
    *(Entry("cuspidality", partial(postures_in_pairs, parallel=parallel)) for parallel in (False, True)),
    Entry("cuspidality", lambda s: orthogonal_designs.classify() if s.closed is orthogonal_3r else None),
    Entry("cuspidality", lambda s: orthogonal_designs.sides_of_surfaces() if s.closed is orthogonal_3r else None),
    Entry("cuspidality", lambda s: orthogonal_designs.exact_sides() if s.closed is orthogonal_3r else None),
    *(Entry("cuspidality", partial(sweep, make=make)) for make in self_motion_sweep.EVERY),
    Entry("dynamics", lambda s: (planar_dynamics if s.planar else dynamics).inverse_dynamics(s.arm)),
    *(
        Entry(f"{kind}_{task}", partial(make, task=task))
        for kind, make in (("redundancy", redundancy_step), ("priority", priority_step))
        for task in ("position", "x_alpha", "pose")
    ),
    *(Entry("cuspidality", partial(spherical, make=make)) for make in spherical_joint.EVERY),
    Entry("rest_to_rest", lambda s: rest_to_rest.profile()),
    Entry("rest_to_rest", lambda s: rest_to_rest.stretched()),
    Entry("rest_to_rest", lambda s: rest_to_rest.state()),
)


def groups(model: Model) -> tuple[str, ...]:
    """The groups of a model: ``kinematics``, one for each task with no more rows than joints, then the extras."""
    tasks = FAMILIES[model.family][1]
    if not tasks:
        return extras(model)
    return ("kinematics", *(task for task, rows in tasks.items() if rows <= len(model.kinds)), *extras(model))


def first_use(model: Model) -> tuple[str, ...]:
    """The groups of a model that are made on first use: for the :data:`SHIPPED` ones that has been done.

    For each task with no more rows than joints ``redundancy_<task>`` (the step along it), where joints are to spare
    ``priority_<task>`` (with a secondary task), and ``dynamics``.
    """
    n, tasks = len(model.kinds), FAMILIES[model.family][1]
    steps = (f"redundancy_{task}" for task, rows in tasks.items() if rows <= n)
    more = (f"priority_{task}" for task, rows in tasks.items() if rows < n)
    return (*steps, *more, *(("dynamics",) if tasks else ()))


def generated(model: Model) -> tuple[str, ...]:
    """The groups of an embedded arm's model in ``generated/``."""
    return (*groups(model), *SHIPPED.get(model.name, ()))


def extras(model: Model) -> tuple[str, ...]:
    """Groups that only some models have.

    Planar arms have ``motion`` (the tip's path along a joint motion), with 3 or 4 joints ``speed_ratio``, and the RRR
    arms ``self_motion`` (in closed form); arms with one joint more than a task has rows have ``continuation_<task>``;
    what belongs to no arm is the profile of a motion, ``rest_to_rest``. The normal form of 3R arms, and the orthogonal
    ones, have ``cuspidality``: postures, cusps and aspects.
    """
    if model.family == "planar":
        closed = ("self_motion",) if model.name == "planar_rrr" else ()
        more = ("motion", "speed_ratio", *closed) if len(model.kinds) in (3, 4) else ("motion",)
        return (*more, *continuations(model))
    others = {"motion": "rest_to_rest", "orthogonal_3r": "cuspidality", "regional_3r": "cuspidality"}
    return (others[model.family],) if model.family in others else continuations(model)


def sources(model: Model, group: str) -> tuple[ModuleType, ...]:
    """The modules that a group's formulas are written in."""
    family, tasks = FAMILIES[model.family]
    closed = [CLOSED_FORMS[model.name]] if model.name in CLOSED_FORMS else []
    if group in continuations(model):
        return (family, self_motion)
    if group in first_use(model):
        moving = planar_dynamics if family is planar else dynamics
        return (family, *closed, moving if group == "dynamics" else redundancy)
    if group in extras(model):
        ratios = speed_ratio if len(model.kinds) == 3 else speed_ratio_4
        known: dict[str, tuple[ModuleType, ...]] = {
            "motion": (planar_motion,),
            "speed_ratio": (ratios,),
            "self_motion": (self_motion_planar_3r,),
            "cuspidality": (
                nodes_3r,
                orthogonal_designs,
                quartic,
                regional_postures,
                self_motion_sweep,
                spherical_joint,
            ),
        }
        return known.get(group, (family,))
    general = [manipulability] if group in tasks else []
    return (family, *closed, *general)


def symbolic(model: Model) -> Any:
    """The symbolic arm of a model: what derivations take."""
    if model.family == "planar":
        return planar.planar_chain(model.kinds, model.parameter_names)
    if model.family == "orthogonal_3r":
        return orthogonal_3r.orthogonal_chain()
    if model.family in ("motion", "regional_3r"):
        return None
    return chain.chain(model.kinds, model.placements, model.tool)


def functions(model: Model, group: str) -> list[Function]:
    """The functions of one group of a model, in the order of the catalogue."""
    every = tuple(FAMILIES[model.family][1])
    kind = "manipulability" if group in every else group
    subjects = {task: Subject(model, task) for task in ("", *every)}
    found = []
    for entry in CATALOGUE:
        if entry.group != kind:
            continue
        for task in every if entry.each_task else (group if kind == "manipulability" else "",):
            program = entry.derivation(subjects[task])
            if program is not None:
                name = f"manipulability_gradient_{task}" if entry.gradient else program.name
                found.append(Function(name, needed(program), entry.gradient))
    return found
