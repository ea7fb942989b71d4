"""What is computed, by everyone: three functions of two arms."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chainrule as cr

Array = NDArray[Any]
Shape = tuple[int, ...]

#: Peers are compared with ours to this, where H is above CLEAR: det(J J^T) loses digits near a singularity.
TOLERANCE = 1e-10
CLEAR = 0.02


@dataclass(frozen=True)
class Case:
    """One function of one arm.

    Attributes:
        key: a short name.
        title: what is computed, in words.
        arm: the arm.
        function: our generated function.
        outputs: names and shapes of the results that everyone computes; ours may give more after them.
        method: the call a user of ours makes for the same results.
        ratio_to_c: how many times faster than CasADi's compiled C a batch of ours is meant to be.
    """

    key: str
    title: str
    arm: cr.Arm
    function: str
    outputs: tuple[tuple[str, Shape], ...]
    method: Callable[[Array], Any]
    ratio_to_c: float

    @property
    def group(self) -> str:
        """The group of generated code that the function is in."""
        return next(g for g in ("pose", "kinematics") if g == "kinematics" or self.function.startswith("manip"))

    def configurations(self, count: int) -> Array:
        """The same random configurations for everyone, (count, n) in rad."""
        return np.random.default_rng(1).uniform(-3.0, 3.0, (count, self.arm.n))


@dataclass(frozen=True)
class Contender:
    """One way of computing a case.

    Attributes:
        name: who.
        count: configurations in one call of ``batch``.
        batch: evaluates them once; None where it has no batch worth timing.
        results: evaluates them and returns the case's outputs, for comparison.
        single: evaluates the first configuration once; None where that is not a call from Python.
    """

    name: str
    count: int
    batch: Callable[[], object] | None
    results: Callable[[], tuple[Array, ...]]
    single: Callable[[], object] | None = None


class Unavailable(Exception):
    """A peer that is not installed or does not finish; the message is the note under the table."""


def cases() -> tuple[Case, ...]:
    """The cases of the table."""
    planar, panda = cr.load("planar_3r"), cr.load("panda")

    def survey(q: Array) -> tuple[Array, ...]:
        return (*planar.kinematics(q), planar.manipulability(q))

    return (
        Case(
            "planar_3r",
            "planar 3R: position, Jacobian, H",
            planar,
            "survey_position",
            (("position", (2,)), ("jacobian", (2, 3)), ("manipulability", ())),
            survey,
            6.0,
        ),
        Case(
            "panda",
            "Panda: pose, 6 x 7 Jacobian",
            panda,
            "kinematics_pose",
            (("pose", (4, 4)), ("jacobian", (6, 7))),
            panda.kinematics,
            2.0,
        ),
        Case(
            "panda_gradient",
            "Panda: H and its gradient",
            panda,
            "manipulability_gradient_pose",
            (("manipulability", ()), ("gradient", (7,))),
            panda.manipulability_gradient,
            2.0,
        ),
    )


class Memory:
    """One block of memory that everyone writes results to: where pages lie, and how large they are, matters."""

    def __init__(self) -> None:
        self._block: Array = np.zeros(0, np.uint8)

    def rows(self, count: int, shapes: Sequence[Shape], kind: type = np.float64) -> tuple[Array, ...]:
        """An array (count, *shape) for each shape, one after the other, over what was there before."""
        sizes = [count * int(np.prod(shape)) * np.dtype(kind).itemsize for shape in shapes]
        starts = np.cumsum([0, *(-(-size // 64) * 64 for size in sizes)])
        if starts[-1] > self._block.size:
            self._block = np.zeros(int(starts[-1]), np.uint8)
        return tuple(
            self._block[start : start + size].view(kind).reshape(count, *shape)
            for start, size, shape in zip(starts, sizes, shapes, strict=False)
        )

    def blank(self) -> None:
        """Nothing but nan, so that nobody passes with what another left there."""
        self._block.fill(0xFF)


MEMORY = Memory()


def empty_outputs(case: Case, count: int) -> tuple[Array, ...]:
    """Arrays for the case's results, in the shared memory."""
    return MEMORY.rows(count, [shape for _, shape in case.outputs])


def disagreement(case: Case, ours: tuple[Array, ...], theirs: tuple[Array, ...]) -> float:
    """The largest difference over the configurations compared, relative to 1 or the value; inf if any is not finite."""
    count = len(theirs[0])
    clear = np.ones(count, bool)
    for (name, _), values in zip(case.outputs, ours, strict=False):
        if name == "manipulability":
            clear = ~(values[:count] <= CLEAR)
    worst = 0.0
    for mine, other in zip(ours, theirs, strict=False):
        a, b = mine[:count][clear], other[clear]
        worst = max(worst, float(np.max(np.abs(a - b) / np.maximum(1.0, np.abs(a)), initial=0.0)))
        if not (np.isfinite(a).all() and np.isfinite(b).all()):
            return float("inf")
    return worst
