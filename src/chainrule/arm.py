"""An arm: a description with its generated functions as methods. The face of chainrule."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.description import Description, Inertia, Orthogonal3R, Planar, with_inertias, with_limits
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluator, Evaluators
from chainrule.readers import dh, families

Array = NDArray[Any]

#: Criteria whose gradients are generated, and the output of the generated function that holds each.
CRITERIA = {"H": 1, "1/H": 2, "H^(-1/2)": 3}


@dataclass(frozen=True)
class Limits:
    """Joint limits as arrays; infinite where there is none.

    Attributes:
        position: (n, 2) lower and upper, rad or m.
        velocity: (n,) rad/s or m/s.
        acceleration: (n,) rad/s^2 or m/s^2.
        torque: (n,) N m or N.
    """

    position: Array
    velocity: Array
    acceleration: Array
    torque: Array


def _likely(name: str, group: str) -> bool:
    """Whether a function of this name is probably in a group: what is looked at first need not be made in vain."""
    if name.startswith(("jacobian_", "kinematics_", "survey_")) or name in ("position", "pose", "postures"):
        return group == "kinematics"
    if name.startswith("step_"):
        return group == f"redundancy_{name.removeprefix('step_')}"
    return name.startswith(group) or name.endswith(group)


_FLOAT = np.dtype(np.float32)  # comparing types is quicker than comparing with a class


def _single(*arrays: Any) -> bool:
    """Whether all of these are arrays of float32."""
    for array in arrays:  # noqa: SIM110  # a generator would take as long as the evaluation
        if getattr(array, "dtype", None) != _FLOAT:
            return False
    return True


def _given(value: Any, default: Array, single: bool) -> Any:
    """An argument or its default; Python's own numbers take the type of the arrays beside them, as NumPy has it."""
    if value is None:
        return default
    if single and isinstance(value, list | tuple) and all(isinstance(entry, int | float) for entry in value):
        return np.asarray(value, _FLOAT)
    return value


class Arm:
    """An arm and everything generated for it. Make one with :func:`load`, :meth:`from_dh` or a family.

    ``q`` is (..., n) in rad or m; leading axes broadcast; every method takes ``out=``, float64 and float32 (float32 in,
    float32 out), strided and zero-size input. Integers count as float64. A configuration with a nan or infinite entry
    gives nan; the others are not affected. Wrong shapes and complex numbers raise :class:`InputError`.

    ``task`` is ``"position"`` (planar: x, y; spatial: x, y, z), ``"pose"`` (planar: x, y, alpha; spatial: linear and
    angular velocity) or, for planar arms, ``"x_alpha"``. By default ``"position"`` for planar and orthogonal 3R arms,
    ``"pose"`` for the rest.

    Example:
        >>> arm = planar_3r(1.0, 0.5, 0.25)
        >>> arm.position([0.5, 0.5, 0.5]).round(3)
        array([1.165, 1.15 ])
    """

    def __init__(self, description: Description) -> None:
        self._description = description
        self._evaluators = Evaluators(description.model)
        self._parameters = tuple(np.array(p) for p in (description.model.parameters,) if p)
        with np.errstate(over="ignore"):  # lengths beyond float's range are infinite there
            self._single_parameters = tuple(p.astype(np.float32) for p in self._parameters)
        for parameters in self._parameters:
            parameters.flags.writeable = False

    # ---- what it is --------------------------------------------------------------------------------------------

    @property
    def description(self) -> Description:
        """The description this arm was made from."""
        return self._description

    @property
    def name(self) -> str:
        """The arm's name."""
        return self._description.name

    @property
    def n(self) -> int:
        """Number of joints."""
        return self._description.n

    @property
    def kinds(self) -> str:
        """Joint kinds, such as ``"RRR"``."""
        return self._description.kinds

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The joints' names."""
        return tuple(joint.name for joint in self._description.joints)

    @property
    def tasks(self) -> dict[str, int]:
        """The tasks this kind of arm knows, with their number of rows m."""
        if isinstance(self._description.geometry, Planar):
            return {"position": 2, "x_alpha": 2, "pose": 3}
        return {"position": 3, "pose": 6}

    @property
    def default_task(self) -> str:
        """The task used when none is named."""
        return "position" if isinstance(self._description.geometry, Planar | Orthogonal3R) else "pose"

    @cached_property
    def limits(self) -> Limits:
        """Joint limits, infinite where there is none."""
        joints, free = self._description.joints, (-np.inf, np.inf)

        def column(values: Iterable[Any], missing: Any) -> Array:
            array = np.array([missing if value is None else value for value in values], float)
            array.flags.writeable = False
            return array

        return Limits(
            column((j.position for j in joints), free),
            column((j.velocity for j in joints), np.inf),
            column((j.acceleration for j in joints), np.inf),
            column((j.torque for j in joints), np.inf),
        )

    def with_limits(
        self,
        *,
        position: Sequence[Any] | None = None,
        velocity: Sequence[Any] | None = None,
        acceleration: Sequence[Any] | None = None,
        torque: Sequence[Any] | None = None,
    ) -> Arm:
        """A copy with other limits: ``position`` (n, 2), the rest (n,); None or inf means no limit.

        Raises:
            DescriptionError: on a wrong number of entries, or a lower limit above the upper.

        Example:
            >>> planar_3r(1.0, 0.5, 0.25).with_limits(velocity=[1.0, 2.0, None]).limits.velocity
            array([ 1.,  2., inf])
        """
        return Arm(
            with_limits(
                self._description, position=position, velocity=velocity, acceleration=acceleration, torque=torque
            )
        )

    def with_inertias(self, inertias: Sequence[Inertia | None]) -> Arm:
        """A copy with other link inertias, one :class:`chainrule.description.Inertia` (or None) for each joint.

        Raises:
            DescriptionError: on a wrong number of entries, or an inertia that no body has.

        Example:
            >>> rod = Inertia(2.0, (0.5, 0.0, 0.0), ((0.0, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.0, 0.2)))
            >>> float(planar("R", [1.0]).with_inertias([rod]).inverse_dynamics([0.0], [0.0], [0.0])[0])
            9.81
        """
        return Arm(with_inertias(self._description, inertias))

    @classmethod
    def from_dh(cls, rows: Iterable[Sequence[Any]], **options: Any) -> Arm:
        """The arm of a Denavit-Hartenberg table; see :func:`chainrule.readers.dh.from_dh` for the options.

        Args:
            rows: n rows (kind, alpha, a, d, theta), in rad and m.
            options: ``convention`` ("modified" or "standard"), ``tool``, ``name``, limits, ``source``, ...

        Raises:
            DescriptionError: one line naming the row and column.

        Example:
            >>> arm = Arm.from_dh([("R", 0.0, 0.0, 0.3, 0.0), ("P", 0.0, 0.5, 0.0, 0.0)], name="lift")
            >>> arm.position([0.5, 0.1]).round(3)
            array([0.439, 0.24 , 0.4  ])
        """
        return cls(dh.from_dh(rows, **options))

    def __reduce__(self) -> tuple[type[Arm], tuple[Description]]:
        return Arm, (self._description,)  # copies and other processes find the functions anew

    def __repr__(self) -> str:
        return f"<Arm {self.name}: {self.n} joint{'s' * (self.n != 1)} ({self.kinds})>"

    # ---- what is generated for it ------------------------------------------------------------------------------

    def evaluator(self, name: str) -> Evaluator:
        """A generated function by its name, such as ``"kinematics_pose"`` or ``"minors_position"``.

        Its inputs are ``q`` and, for arms of a family, ``parameters`` (:attr:`parameters`).

        Raises:
            InputError: if this arm has no such function.
        """
        rare = [group for group in self.groups_on_first_use if _likely(name, group)]
        for group in sorted((*self.groups, *rare), key=lambda group: not _likely(name, group)):
            found = self._evaluators.get(group, name)
            if found is not None:
                return found
        known = sorted(key for group in self.groups for key in self._evaluators.group(group))
        raise InputError(f"{self.name} has no generated function '{name}'; it has {', '.join(dict.fromkeys(known))}")

    @property
    def groups(self) -> tuple[str, ...]:
        """Groups of generated functions: ``kinematics``, the :attr:`full_rank_tasks`, and more for the families."""
        more: tuple[str, ...] = ()
        if isinstance(self._description.geometry, Planar):
            more = ("motion", "speed_ratio") if self.n in (3, 4) else ("motion",)
            more += ("self_motion",) if self.kinds == "RRR" else ()
        elif isinstance(self._description.geometry, Orthogonal3R):
            more = ("cuspidality",)
        followed = (f"continuation_{task}" for task, rows in self.tasks.items() if self.n - rows == 1)
        return ("kinematics", *self.full_rank_tasks, *more, *followed)

    @property
    def groups_on_first_use(self) -> tuple[str, ...]:
        """Further groups, which :meth:`prepare` leaves to their first use unless they are named.

        For each of the :attr:`full_rank_tasks` ``redundancy_<task>``, the step along it, and where joints are to spare
        ``priority_<task>``, with a secondary task; ``dynamics``.
        """
        spare = (f"priority_{task}" for task in self.full_rank_tasks if self.tasks[task] < self.n)
        return (*(f"redundancy_{task}" for task in self.full_rank_tasks), *spare, "dynamics")

    @property
    def full_rank_tasks(self) -> tuple[str, ...]:
        """The tasks with no more rows than joints: their Jacobians have maximal minors, hence a manipulability."""
        return tuple(task for task, rows in self.tasks.items() if rows <= self.n)

    @property
    def parameters(self) -> Array:
        """The numbers a family's functions take beside ``q`` (empty for other arms)."""
        return self._parameters[0] if self._parameters else np.array([])

    def prepare(self, progress: Callable[[str], None] = lambda line: None, groups: Sequence[str] | None = None) -> None:
        """Derive and compile now what would otherwise be made on first use.

        Args:
            progress: called with one line for each step.
            groups: which groups; all of :attr:`groups` when absent.
        """
        from concurrent.futures import ThreadPoolExecutor

        from chainrule import compile as compiling

        wanted = tuple(self.groups if groups is None else groups)
        with ThreadPoolExecutor(len(wanted)) as pool:
            # The last groups take longest to compile, so they begin.
            list(pool.map(lambda g: compiling.find(self._description.model, g, progress), reversed(wanted)))
        for group in wanted:
            self._evaluators.group(group)

    def _call(self, group: str, name: str, q: Any, out: Any, *more: Any) -> Any:
        evaluator = self._evaluators.get(group, name)
        if evaluator is None:
            raise self._missing(name)
        if self._parameters and _single(q, *more):
            return evaluator(q, *self._single_parameters, *more, out=out)  # float32 in, float32 out
        return evaluator(q, *self._parameters, *more, out=out)

    def _task(self, task: str | None) -> str:
        if task is None:
            return self.default_task
        if task not in self.tasks:
            raise InputError(f"{self.name}: there is no task {task!r}; {', '.join(self.tasks)} are accepted")
        return task

    def task_of_full_rank(self, task: str | None) -> str:
        """The named task, or the default one, if it has no more rows than there are joints.

        Raises:
            InputError: another one.
        """
        task = self._task(task)
        if self.tasks[task] > self.n:
            others = " or ".join(f"'{name}'" for name in self.full_rank_tasks)
            raise InputError(
                f"{self.name}: the task '{task}' has {self.tasks[task]} rows for {self.n} joint{'s' * (self.n != 1)}, "
                f"so its Jacobian has no maximal minors; {others or 'an arm with more joints'} is accepted"
            )
        return task

    def _missing(self, name: str) -> InputError:
        kind, _, task = name.rpartition("_") if not name.endswith("x_alpha") else (name[:-8], "", "x_alpha")
        rows, why = self.tasks.get(task, 0), "it is not generated for this arm"
        if kind == "minors":
            why = f"a {rows} x {self.n} Jacobian has too many minors; manipulability uses a factorisation instead"
        elif kind == "null_vector":
            why = f"it needs one joint more than the task has rows, and this is {self.n} joints for {rows} rows"
        elif kind == "null_projector":
            why = (
                f"{self.n} joints leave no null space to {rows} rows"
                if self.n <= rows
                else "it is generated for arms of up to 16 joints"
            )
        return InputError(f"{self.name}, {kind} of the task '{task}': {why}")

    # ---- kinematics --------------------------------------------------------------------------------------------

    def position(self, q: Any, *, out: Array | None = None) -> Array:
        """Position of the tip, (..., 3) or planar (..., 2), in m, in the base frame."""
        result: Array = self._call("kinematics", "position", q, out)
        return result

    def pose(self, q: Any, *, out: Array | None = None) -> Array:
        """Pose of the tip as a homogeneous matrix, (..., 4, 4) or planar (..., 3, 3), in the base frame."""
        result: Array = self._call("kinematics", "pose", q, out)
        return result

    def jacobian(self, q: Any, *, task: str | None = None, out: Array | None = None) -> Array:
        """Task Jacobian (..., m, n) in the base frame; rows (v; omega) for the spatial pose.

        Example:
            >>> planar_3r(1.0, 0.5, 0.25).jacobian([0.5, 0.5, 0.5]).round(3)
            array([[-1.15 , -0.67 , -0.249],
                   [ 1.165,  0.288,  0.018]])
        """
        result: Array = self._call("kinematics", f"jacobian_{self._task(task)}", q, out)
        return result

    def kinematics(
        self, q: Any, *, task: str | None = None, out: tuple[Array, Array] | None = None
    ) -> tuple[Array, Array]:
        """Position (task "position") or pose (other tasks), and the task Jacobian, in one evaluation."""
        result: tuple[Array, Array] = self._call("kinematics", f"kinematics_{self._task(task)}", q, out)
        return result

    # ---- manipulability ----------------------------------------------------------------------------------------

    def minors(self, q: Any, *, task: str | None = None, out: Array | None = None) -> Array:
        """Maximal minors of the task Jacobian, (..., C(n, m)), columns as in ``itertools.combinations(range(n), m)``.

        They vanish together exactly at the singular configurations. For n = m there is one: the determinant.
        """
        task = self.task_of_full_rank(task)
        result: Array = self._call(task, f"minors_{task}", q, out)
        return result

    def manipulability(self, q: Any, *, task: str | None = None, out: Array | None = None) -> Array:
        """H = sqrt(det(J J^T)), (...,): the root of the sum of the squared maximal minors (Cauchy-Binet).

        Zero exactly where the task Jacobian loses rank. De Luca, equation (1), for the planar 3R arm.

        Example:
            >>> float(planar_3r(1.0, 0.5, 0.25).manipulability([0.3, 0.0, 0.0]))
            0.0
        """
        task = self.task_of_full_rank(task)
        result: Array = self._call(task, f"manipulability_{task}", q, out)
        return result

    def manipulability_gradient(
        self, q: Any, *, task: str | None = None, criterion: str = "H", out: Array | None = None
    ) -> Array:
        """Gradient with respect to q, (..., n), of a criterion: ``"H"``, ``"1/H"`` or ``"H^(-1/2)"``.

        At H = 0 (within the smallest numbers of the type) no gradient exists; the answer there is the zero vector for
        all three: H has a minimum (0 is its smallest subgradient), and 1/H and H^(-1/2) are infinite.

        Raises:
            InputError: an unknown criterion, or a task with more rows than joints.
        """
        task = self.task_of_full_rank(task)
        if criterion not in CRITERIA:
            raise InputError(f"{self.name}: there is no criterion {criterion!r}; {', '.join(CRITERIA)} are accepted")
        place = CRITERIA[criterion]
        outputs = None if out is None else tuple(out if k == place else None for k in range(4))
        result: Array = self._call(task, f"manipulability_gradient_{task}", q, outputs)[place]
        return result

    def null_vector(self, q: Any, *, task: str | None = None, out: Array | None = None) -> Array:
        """N (..., n) with J N = 0 for an arm with one joint to spare: N_j = (-1)^j det(J without column j).

        Smooth in q, of length H: divide by H for the unit vector; it vanishes exactly at singular configurations.

        Raises:
            InputError: if n - m is not 1.
        """
        task = self.task_of_full_rank(task)
        result: Array = self._call(task, f"null_vector_{task}", q, out)
        return result

    def null_projector(self, q: Any, *, task: str | None = None, out: Array | None = None) -> Array:
        """P = I - J^+ J (..., n, n), the orthogonal projector onto the null space of the task Jacobian.

        By orthogonal factorisation, so that P is symmetric and idempotent to rounding also near singularities; at an
        exactly singular configuration rows of J that vanish in the factorisation are left out.
        """
        task = self.task_of_full_rank(task)
        result: Array = self._call(task, f"null_projector_{task}", q, out)
        return result

    # ---- dynamics ----------------------------------------------------------------------------------------------

    def inverse_dynamics(
        self, q: Any, qd: Any, qdd: Any, *, gravity: Any = None, wrench: Any = None, out: Array | None = None
    ) -> Array:
        """Joint torques (N m; prismatic joints: forces, N) of a motion, (..., n), from the description's inertias.

        tau = M(q) qdd + c(q, qd) + g(q) + J(q)^T wrench, by the recursive equations of Newton and Euler (Luh, Walker
        and Paul 1980) in the links' own axes. Rotors and friction are not in it. Every array broadcasts over its
        leading axes; the result is float32 where q, qd and qdd are, and gravity and wrench as far as they are arrays.

        Args:
            q: (..., n) rad or m.
            qd: (..., n) rates, rad/s or m/s.
            qdd: (..., n) accelerations, rad/s^2 or m/s^2.
            gravity: (..., 3) m/s^2 in the base frame; (0, 0, -9.81) when absent. Planar arms: (..., 2), by default
                (0, -9.81), a plane that stands upright; (0, 0) for one that lies flat.
            wrench: (..., 6) the force (N) and moment (N m, about the tip) that the tip exerts on what it touches, in
                the base frame, as the rows of ``jacobian(q, task="pose")``; none when absent. Planar arms: (..., 3),
                force x and y, moment.
            out: where to put the result.

        Raises:
            InputError: joints without an inertia (see :meth:`with_inertias`), wrong shapes.

        Example:
            >>> import chainrule as cr
            >>> q, still = [0.3, 0.2, -0.4, 0.5, 0.6, 0.7, -0.2, 0.1], [0.0] * 8
            >>> cr.load("sanchez_8r").inverse_dynamics(q, still, still)[:4].round(2)
            array([-27.06, -1.96, -6.64, -0.47])
        """
        single = _single(q, qd, qdd)
        inertias, usual, none = self._loads[single]
        gravity, wrench = _given(gravity, usual, single), _given(wrench, none, single)
        result: Array = self._call("dynamics", "inverse_dynamics", q, out, qd, qdd, inertias, gravity, wrench)
        return result

    @cached_property
    def _loads(self) -> tuple[tuple[Array, Array, Array], ...]:
        """What inverse dynamics takes beside a motion, as doubles and as floats: inertias, usual gravity, no wrench."""
        known = self._description.inertias or (None,) * self.n
        missing = [name for name, inertia in zip(self.joint_names, known, strict=True) if inertia is None]
        if missing:
            more = f" and {len(missing) - 5} more" if len(missing) > 5 else ""
            raise InputError(
                f"{self.name}: no inertia is known for {', '.join(missing[:5])}{more}; inverse dynamics needs that of "
                "every joint's link (from the arm's file, or by Arm.with_inertias)"
            )
        planar = isinstance(self._description.geometry, Planar)
        rows = np.array([inertia.about_origin() for inertia in known if inertia is not None])
        flat, spatial = ([0.0, -9.81], np.zeros(3)), ([0.0, 0.0, -9.81], np.zeros(6))
        doubles = [rows[:, [0, 1, 2, 9]] if planar else rows, *(np.array(x) for x in (flat if planar else spatial))]
        found = tuple(tuple(np.ascontiguousarray(x, real) for x in doubles) for real in (np.float64, np.float32))
        for array in (array for arrays in found for array in arrays):
            array.flags.writeable = False
        return found  # type: ignore[return-value]  # three each


def checked_arm(value: Any) -> Arm:
    """``value``, if it is an arm.

    Raises:
        InputError: anything else, such as the name of an arm.

    Example:
        >>> checked_arm("panda")
        Traceback (most recent call last):
            ...
        chainrule.errors.InputError: arm: 'panda'; an Arm is accepted, such as chainrule.load('panda') gives
    """
    if not isinstance(value, Arm):
        raise InputError(f"arm: {shown(value)}; an Arm is accepted, such as chainrule.load('panda') gives")
    return value


def planar_3r(l1: float, l2: float, l3: float) -> Arm:
    """The planar arm with three revolute joints and link lengths l1, l2, l3 (m).

    Example:
        >>> planar_3r(1.0, 0.5, 0.25).n
        3
    """
    return Arm(families.planar_3r(l1, l2, l3))


def planar(
    kinds: str | Sequence[str], lengths: Sequence[float], headings: Sequence[float] | None = None, **options: Any
) -> Arm:
    """A planar chain of revolute ("R") and prismatic ("P") joints.

    R turns the heading by theta_i, then advances l_i; P turns it by heading_i, then advances l_i + theta_i.

    Args:
        kinds: one letter for each joint, such as "RPR".
        lengths: (n,) in m.
        headings: (n,) in rad, 0 for revolute joints; all 0 when absent.
        options: ``name``, ``joint_names``, ``source``.

    Example:
        >>> planar("RP", [0.0, 0.5]).position([0.5, 0.25]).round(3)
        array([0.658, 0.36 ])
    """
    return Arm(families.planar(kinds, lengths, headings, **options))
