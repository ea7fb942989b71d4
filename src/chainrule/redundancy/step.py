"""One step of a redundant arm along a task: a law, made into numbers once, and the generated function it feeds.

    rates = J* (velocity - K error) + (I - J+ J) (sum_k gain_k grad criterion_k + push)

derive/redundancy.py says what each part is and where it comes from.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from chainrule.arm import Arm
from chainrule.errors import InputError, shown
from chainrule.evaluators import Evaluator
from chainrule.inputs import real_array

Array = NDArray[Any]

#: What a gain may be given for. Raising 1/H or H^(-1/2) lowers H: their gains are negative in practice, and so is that
#: of "limits", the mean square of the joints' distances from the middles of their ranges, in half ranges, over 2.
CRITERIA = ("H", "1/H", "H^(-1/2)", "limits")
KINDS = ("none", "constant", "nakamura", "chiaverini")


def _number(value: Any, name: str, least: float = -np.inf) -> float:
    """``value`` as a finite number of at least ``least``."""
    array = real_array(value, name)
    if array.shape or array < least:
        raise InputError(
            f"{name}: {shown(value)}; a number{'' if least == -np.inf else f', {least:g} or more,'} is accepted"
        )
    return float(array)


@dataclass(frozen=True)
class Damping:
    """Damping mu of the task: rates with the least |J rates - v|^2 + mu^2 rates^T W rates.

    Attributes:
        kind: ``"none"``; ``"constant"``: mu = factor; ``"nakamura"``: mu = factor (1 - H / threshold) where H is below
            the threshold; ``"chiaverini"``: mu^2 = factor^2 (1 - (s / threshold)^2) where s, the estimate of the least
            singular value of J, is below it. s is at least the least singular value / sqrt(m) and at most that value,
            which it comes close to where it matters.
        factor: mu, or the largest it becomes.
        threshold: of H or of s, where damping sets in.

    Raises:
        InputError: an unknown kind, a factor below 0, a threshold that is not above 0.

    Example:
        >>> Damping("nakamura", 0.05, 0.01).to_dict()
        {'kind': 'nakamura', 'factor': 0.05, 'threshold': 0.01}
    """

    kind: Literal["none", "constant", "nakamura", "chiaverini"] = "none"
    factor: float = 0.0
    threshold: float = 0.0

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise InputError(f"damping: {shown(self.kind)}; {', '.join(KINDS)} are accepted")
        _number(self.factor, "damping factor", least=0.0)
        if _number(self.threshold, "damping threshold", least=0.0) == 0.0 and self.kind in KINDS[2:]:
            raise InputError(f"damping threshold: {self.threshold}; for {self.kind} a number above 0 is accepted")

    def to_dict(self) -> dict[str, Any]:
        """The damping as plain data."""
        return {"kind": self.kind, "factor": self.factor, "threshold": self.threshold}

    def _entries(self) -> tuple[float, float, float, float, float]:
        """The constant, and for H and s the factor with the inverse of the threshold."""
        off = (0.0, 0.0)
        scaled = (self.factor, 1.0 / self.threshold) if self.kind in KINDS[2:] else off
        return (
            self.factor if self.kind == "constant" else 0.0,
            *(scaled if self.kind == "nakamura" else off),
            *(scaled if self.kind == "chiaverini" else off),
        )


@dataclass(frozen=True)
class Law:
    """How an arm moves: what it does with the joints to spare, how it corrects errors, and how it is damped.

    Attributes:
        gains: for each criterion of :data:`CRITERIA` its gain; a positive one raises the criterion. The thesis of
            Sanchez uses -2 with H^(-1/2).
        feedback: 1/s, of the position error and of the orientation error.
        damping: of the task near singularities.
        weights: (n,) of the joints, W: of all rates that do the task those with the least
            (rates - g)^T W (rates - g), where g is the gradients' sum and the push. A joint of infinite weight stands
            still. None: all alike.

    Raises:
        InputError: an unknown criterion; numbers that are not finite; feedback below 0; weights that are not above 0.

    Example:
        >>> Law({"H^(-1/2)": -2.0}, feedback=(10.0, 10.0)).to_dict()["gains"]
        {'H^(-1/2)': -2.0}
    """

    gains: Mapping[str, float] = field(default_factory=dict)
    feedback: tuple[float, float] = (0.0, 0.0)
    damping: Damping = Damping()
    weights: tuple[float, ...] | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.gains, Mapping) or not set(self.gains) <= set(CRITERIA):
            raise InputError(f"gains: {shown(self.gains)}; a gain for any of {', '.join(CRITERIA)} is accepted")
        gains = {name: _number(gain, f"gain of {name}") for name, gain in self.gains.items()}
        feedback = real_array(self.feedback, "feedback")
        if feedback.shape != (2,) or (feedback < 0).any():
            raise InputError(f"feedback: {shown(self.feedback)}; two numbers, 0 or more, are accepted")
        if not isinstance(self.damping, Damping):
            raise InputError(f"damping: {shown(self.damping)}; a Damping is accepted")
        weights = None
        if self.weights is not None:
            given = real_array(self.weights, "weights", finite=False)
            if given.ndim != 1 or not (given > 0).all():
                raise InputError(f"weights: {shown(self.weights)}; one number above 0 for each joint is accepted")
            weights = tuple(given.tolist())
        object.__setattr__(self, "gains", gains)
        object.__setattr__(self, "feedback", tuple(feedback.tolist()))
        object.__setattr__(self, "weights", weights)

    def to_dict(self) -> dict[str, Any]:
        """The law as plain data; an infinite weight is None."""
        return {
            "gains": dict(self.gains),
            "feedback": list(self.feedback),
            "damping": self.damping.to_dict(),
            "weights": None if self.weights is None else [w if w < np.inf else None for w in self.weights],
        }

    def _settings(self) -> tuple[float, ...]:
        """The entries of the generated functions' input ``settings``, all but dt."""
        return (*self.feedback, *(self.gains.get(name, 0.0) for name in CRITERIA), *self.damping._entries())


@dataclass(frozen=True)
class Step:
    """What a step gave, over the leading axes of what went in.

    Attributes:
        q_next: (..., n) q + dt rates.
        rates: (..., n) rad/s, m/s.
        manipulability: (...,) H before the step.
        error: (..., m) of the task before the step, in the order of its rows: position minus target (m), and for an
            orientation 2 sin(angle / 2), times the axis in space, of what turns the target into the tip.
        null_motion: (..., n) the part of the rates that leaves the task alone.
    """

    q_next: Array
    rates: Array
    manipulability: Array
    error: Array
    null_motion: Array

    def to_dict(self) -> dict[str, Any]:
        """The step as plain data."""
        return {name: np.asarray(getattr(self, name)).tolist() for name in self.__dataclass_fields__}


@dataclass(frozen=True)
class Bound:
    """One configuration's step in place, made by :meth:`Stepper.bind`: write the inputs, call, read the outputs.

    Attributes:
        q, held, velocity, push: what goes in.
        q_next, rates, manipulability, error, null_motion: what comes out, as in :class:`Step`.
    """

    q: Array
    held: Array
    velocity: Array
    push: Array
    q_next: Array
    rates: Array
    manipulability: Array
    error: Array
    null_motion: Array
    _run: Callable[[], None] = field(repr=False)

    def __call__(self) -> None:
        """Evaluate the step."""
        self._run()


class Stepper:
    """The step of an arm under a law. Arrays broadcast over leading axes: thousands of arms in one call.

    Args:
        arm: the arm.
        law: the law; or a sequence of them, which is then the last of the leading axes of every call.
        task: the task, the arm's default one when absent; one with no more rows than joints.

    Raises:
        InputError: a task of more rows than joints; weights that are not one for each joint.

    Example:
        >>> import chainrule as cr
        >>> arm, q = cr.load("sanchez_8r"), [0.1, 0.4, 0.3, 1.0, -0.7, 0.9, 0.5, 0.3]
        >>> stepper = Stepper(arm, Law({"H^(-1/2)": -2.0}, feedback=(10.0, 10.0)))
        >>> velocity = [0.1, 0.0, 0.0, 0.0, 0.0, 0.0]
        >>> step = stepper(q, arm.pose(q), velocity, 0.001)
        >>> bool(np.allclose(arm.jacobian(q) @ step.rates, velocity))
        True
    """

    def __init__(self, arm: Arm, law: Law | Sequence[Law] | None = None, task: str | None = None) -> None:
        self.arm, self.task = arm, arm.task_of_full_rank(task)
        self.law = Law() if law is None else law if isinstance(law, Law) else tuple(law)
        laws = (self.law,) if isinstance(self.law, Law) else self.law
        if not laws:
            raise InputError("law: none in the sequence; a Law, or a sequence of them, is accepted")
        for one in laws:
            if not isinstance(one, Law):
                raise InputError(f"law: {shown(one)}; a Law, or a sequence of them, is accepted")
            if one.weights is not None and len(one.weights) != arm.n:
                raise InputError(
                    f"weights: {len(one.weights)} given; {arm.n}, one for each joint of {arm.name}, are accepted"
                )
        n, m = arm.n, arm.tasks[self.task]
        settings = np.array([(*one._settings(), 0.0) for one in laws])
        joints = np.zeros((len(laws), 4, n))
        joints[:, 1] = [np.sqrt(one.weights or (1.0,) * n) for one in laws]
        joints[:, 0] = 1.0 / joints[:, 1]
        joints[:, 1][joints[:, 0] == 0.0] = 0.0  # of infinite weight
        joints[:, 2:] = np.array([joint.middle_and_narrowness for joint in arm.description.joints]).T
        if isinstance(self.law, Law):
            settings, joints = settings[0], joints[0]
        fixed = (np.zeros(m), np.zeros(n), joints, settings, *((arm.parameters,) if arm.parameters.size else ()))
        self._double, self._single = (tuple(a.astype(kind) for a in fixed) for kind in (np.float64, np.float32))
        self._last = (np.nan, self._double[3])
        self._spare = n - m
        self._step = arm.evaluator(f"step_{self.task}")

    def __call__(
        self,
        q: ArrayLike,
        held: ArrayLike,
        velocity: ArrayLike | None,
        dt: ArrayLike,
        push: ArrayLike | None = None,
        *,
        secondary: tuple[ArrayLike, ArrayLike] | None = None,
        out: Step | None = None,
    ) -> Step:
        """One step.

        Args:
            q: (..., n) rad or m; float32 here makes float32 of what the stepper itself brings.
            held: where the tip should be: a homogeneous matrix (..., 4, 4); (..., 3) for the position; for planar tasks
                (..., 2) or (..., 3), in the order of the task's rows.
            velocity: (..., m) of the target, m/s and rad/s; None where it stands still.
            dt: (...,) s.
            push: (..., n) what is added to the gradients, projected like them.
            secondary: Jacobian (..., k, n) and velocity (..., k) of a task of lower priority, done as far as this
                task allows; at most n - m rows, and at most 6.
            out: the step of a batch of the same leading axes, to overwrite.

        Raises:
            InputError: wrong shapes, or numbers that are not real.
        """
        q = np.asarray(q)
        still, unpushed, joints, settings, *parameters = self._single if q.dtype.char == "f" else self._double
        velocity = still if velocity is None else velocity
        push = unpushed if push is None else push
        settings = self._at(settings, dt)
        into = None if out is None else (out.q_next, out.rates, out.manipulability, out.error, out.null_motion)
        if secondary is None:
            found = self._step(q, held, velocity, push, joints, settings, *parameters, out=into)
        else:
            priority = self._priority()
            most = priority.inputs[3][1][0]  # rows of the input ``secondary``
            second = self._padded(secondary, most, still.dtype)
            found = priority(q, held, velocity, *second, push, joints, settings, *parameters, out=into)
        return Step(*found) if out is None else out

    def bind(self, dt: float, dtype: DTypeLike = np.float64) -> Bound:
        """The step of one configuration from fixed arrays into fixed arrays: no checks, no allocation.

        Args:
            dt: s, of every step.
            dtype: float64 or float32.

        Raises:
            InputError: a sequence of laws, or another type.

        Example:
            >>> import chainrule as cr
            >>> arm = cr.load("panda")
            >>> loop = Stepper(arm, Law(feedback=(10.0, 10.0))).bind(0.01)
            >>> loop.q[:] = [0.3, -0.8, 0.0, -2.3, 0.0, 1.6, 0.8]
            >>> loop.held[:] = arm.pose([0.3, -0.7, 0.1, -2.2, 0.0, 1.6, 0.8])
            >>> for _ in range(300):
            ...     loop()
            ...     loop.q[:] = loop.q_next
            >>> bool(np.abs(loop.error).max() < 1e-12)
            True
        """
        kind = np.dtype(dtype)
        if kind.char not in "df" or not isinstance(self.law, Law):
            raise InputError(f"bind: {kind} and {shown(self.law)}; float64 or float32 and one law are accepted")
        velocity, push, joints, settings, *parameters = (
            a.copy() for a in (self._double if kind.char == "d" else self._single)
        )
        settings[-1] = _number(dt, "dt")
        evaluator = self._step
        q, held = (np.zeros(shape, kind) for _, shape in evaluator.inputs[:2])
        q_next, rates, manipulability, error, null_motion = (np.zeros(shape, kind) for _, shape in evaluator.outputs)
        outputs = (q_next, rates, manipulability, error, null_motion)
        run = evaluator.bind(q, held, velocity, push, joints, settings, *parameters, *outputs)
        return Bound(q, held, velocity, push, q_next, rates, manipulability, error, null_motion, run)

    def _at(self, settings: Array, dt: ArrayLike) -> Array:
        """The settings with dt in them; a control loop asks for the same ones again and again."""
        if isinstance(dt, float):
            last = self._last
            if last[0] == dt and last[1].itemsize == settings.itemsize:
                return last[1]
            filled = settings.copy()
            filled[..., -1] = dt
            self._last = (dt, filled)
            return filled
        dt = real_array(dt, "dt", finite=False)
        lead = np.broadcast_shapes(settings.shape[:-1], dt.shape)
        filled = np.broadcast_to(settings, (*lead, settings.shape[-1])).copy()
        filled[..., -1] = dt
        return filled

    def _priority(self) -> Evaluator:
        if self._spare == 0:
            raise InputError(
                f"{self.arm.name}: the task '{self.task}' leaves no joint to spare, so no secondary task is accepted"
            )
        return self.arm.evaluator(f"priority_{self.task}")

    def _padded(self, secondary: tuple[ArrayLike, ArrayLike], most: int, kind: Any) -> tuple[Array, Array]:
        """The secondary task with rows of zeros, which do nothing, up to what the generated function takes."""
        pair = [np.asarray(part) for part in secondary] if isinstance(secondary, tuple | list) else []
        if len(pair) != 2 or not all(part.dtype.kind in "iuf" for part in pair):
            raise InputError(f"secondary: {shown(secondary)}; a Jacobian and a velocity, real numbers, are accepted")
        matrix, velocity = pair
        rows = matrix.shape[-2] if matrix.ndim > 1 else 0
        if not 0 < rows <= most or matrix.shape[-1] != self.arm.n or velocity.shape[-1:] != (rows,):
            raise InputError(
                f"secondary: shapes {matrix.shape} and {velocity.shape}; a Jacobian (..., k, {self.arm.n}) and a "
                f"velocity (..., k) with k from 1 to {most} are accepted"
            )
        wide = np.zeros((*matrix.shape[:-2], most, self.arm.n), kind)
        long = np.zeros((*velocity.shape[:-1], most), kind)
        wide[..., :rows, :], long[..., :rows] = matrix, velocity
        return wide, long
