"""Is what was generated right? Measured now, on this machine, against computations that do not share its code.

Every check states what was compared with what, over how many configurations, the worst error met and the bound it
must stay under. Errors are relative to the largest entry of the result (or to the scale named).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.search import samples

Array = NDArray[Any]
Progress = Callable[[str], None]

#: Configurations compared at 40 digits (fewer for long arms), and compared in double precision.
FEW, LONG, MANY = 8, 12, 1000
#: Bound of each relative error: some hundreds of roundings of a double (2.2e-16), of a float (1.2e-7).
DOUBLE, SINGLE = 1e-12, 2e-4


@dataclass(frozen=True)
class Check:
    """One comparison.

    Attributes:
        what: what was compared with what.
        count: number of configurations.
        worst: the largest relative error met.
        bound: what it must not exceed.
    """

    what: str
    count: int
    worst: float
    bound: float

    @property
    def passed(self) -> bool:
        """Whether the worst error is within the bound (not a number never is)."""
        return bool(self.worst <= self.bound)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "what": self.what,
            "configurations": self.count,
            "worst": self.worst,
            "bound": self.bound,
            "passed": self.passed,
        }


def checks(arm: Arm, progress: Progress = lambda line: None) -> tuple[Check, ...]:
    """Every check that applies to the arm.

    Example:
        >>> from chainrule import planar_3r
        >>> all(check.passed for check in checks(planar_3r(1.0, 0.5, 0.25)))
        True
    """
    found = []
    for name, make in (
        ("compiled code against the symbolic programs", _against_symbols),
        ("Jacobian against the pose", _derivative),
        ("gradient against H", _gradient),
        ("rotations", _rotations),
        ("minors", _minors),
        ("manipulability", _singular_values),
        ("null vectors", _null),
        ("single precision", _single),
    ):
        progress(f"checking {name}")
        found += make(arm)
    return tuple(found)


def _few(arm: Arm) -> int:
    return FEW if arm.n <= LONG else 2


def _programs(arm: Arm) -> list[tuple[str, Any]]:
    """The symbolic programs behind the functions of a configuration: (group, program), derivatives left out."""
    from chainrule.derive import catalogue

    model = arm.description.model
    return [
        (group, f.program)
        for group in ("kinematics", *arm.full_rank_tasks)
        for f in catalogue.functions(model, group)
        if not f.gradient and f.program.inputs[0].name == "q"
    ]


def _inputs(arm: Arm, q: Any) -> dict[str, list[Any]]:
    return {"q": list(q), "parameters": list(arm.description.model.parameters)}


def _exact(arm: Arm, program: Any, q: Any) -> dict[str, list[Any]]:
    from chainrule.derive.program import evaluate

    return evaluate(program, _inputs(arm, q))


def _relative(found: Array, expected: Array) -> float:
    """Largest error over configurations (first axis), each relative to its largest entry."""
    k = len(found)
    scale = np.abs(expected).reshape(k, -1).max(axis=1)
    error = np.abs(found - expected).reshape(k, -1).max(axis=1)
    return float(np.max(np.where(scale > 0, error / np.where(scale > 0, scale, 1.0), error)))


def _against_symbols(arm: Arm) -> list[Check]:
    q = samples(arm, _few(arm), seed=11)
    worst, count = 0.0, 0
    for _, program in _programs(arm):
        results = arm.evaluator(program.name)(q, *([arm.parameters] if arm.parameters.size else []))
        results = results if isinstance(results, tuple) else (results,)
        truths = [_exact(arm, program, row) for row in q]
        for output, result in zip(program.outputs, results, strict=True):
            truth = np.array([[float(x) for x in exact[output.name]] for exact in truths])
            worst = max(worst, _relative(np.asarray(result).reshape(len(q), -1), truth))
        count += 1
    return [Check(f"{count} compiled functions against their symbolic programs at 40 digits", len(q), worst, DOUBLE)]


def _derivative(arm: Arm) -> list[Check]:
    """The Jacobian against central differences of the symbolic pose, taken at 50 digits."""
    import mpmath

    program = next(p for _, p in _programs(arm) if p.name == "pose")
    q = samples(arm, _few(arm), seed=12)
    found = np.asarray(arm.jacobian(q, task="pose"))
    expected = np.zeros_like(found)
    side = 3 if found.shape[1] == 3 else 4
    with mpmath.workdps(50):
        step = mpmath.mpf(10) ** -15
        for row, entries in enumerate(q):
            centre = _square(_exact(arm, program, entries)["pose"], side)
            for j in range(arm.n):
                moved = []
                for sign in (1, -1):
                    shifted = [mpmath.mpf(x) for x in entries]
                    shifted[j] += sign * step
                    moved.append(_exact(arm, program, shifted)["pose"])
                rate = _square([(a - b) / (2 * step) for a, b in zip(*moved, strict=True)], side)
                turn = side - 1
                spin = rate[:turn, :turn] * centre[:turn, :turn].T
                angular = [spin[1, 0]] if side == 3 else [spin[2, 1], spin[0, 2], spin[1, 0]]
                expected[row, :, j] = [float(x) for x in [*(rate[k, turn] for k in range(turn)), *angular]]
    return [
        Check(
            "Jacobian against the differentiated pose (differences at 50 digits)",
            len(q),
            _relative(found, expected),
            DOUBLE,
        )
    ]


def _square(entries: list[Any], side: int) -> Any:
    """Entries, row by row, as an mpmath matrix."""
    import mpmath

    return mpmath.matrix([entries[k * side : (k + 1) * side] for k in range(side)])


def _gradient(arm: Arm) -> list[Check]:
    """The gradient of H against central differences of the symbolic H, taken at 50 digits."""
    import mpmath

    found = []
    for group, program in _programs(arm):
        if program.name != f"manipulability_{group}":
            continue
        q = samples(arm, _few(arm), seed=13)
        gradient = np.asarray(arm.manipulability_gradient(q, task=group))
        expected = np.zeros_like(gradient)
        with mpmath.workdps(50):
            step = mpmath.mpf(10) ** -15
            for row, entries in enumerate(q):
                for j in range(arm.n):
                    ends = []
                    for sign in (1, -1):
                        shifted = [mpmath.mpf(x) for x in entries]
                        shifted[j] += sign * step
                        ends.append(_exact(arm, program, shifted)["manipulability"][0])
                    expected[row, j] = float((ends[0] - ends[1]) / (2 * step))
        found.append(
            Check(f"gradient of H against the differentiated H ({group})", len(q), _relative(gradient, expected), 1e-10)
        )
    return found


def _rotations(arm: Arm) -> list[Check]:
    pose = np.asarray(arm.pose(samples(arm, MANY, seed=14)))
    rotation = pose[:, :-1, :-1]
    error = float(np.abs(rotation @ np.swapaxes(rotation, 1, 2) - np.eye(rotation.shape[1])).max())
    error = max(error, float(np.abs(np.linalg.det(rotation) - 1.0).max()))
    return [Check("rotation matrices: R Rᵀ = I and det R = 1", MANY, error, 1e-13)]


def _minors(arm: Arm) -> list[Check]:
    found = []
    names = {program.name for _, program in _programs(arm)}
    q = samples(arm, MANY // 5, seed=15)
    for task in arm.full_rank_tasks:
        if f"minors_{task}" not in names:
            continue
        jacobian = np.asarray(arm.jacobian(q, task=task))
        columns = list(combinations(range(arm.n), jacobian.shape[1]))
        expected = np.stack([np.linalg.det(jacobian[:, :, list(c)]) for c in columns], axis=1)
        scale = np.prod(np.sort(np.linalg.norm(jacobian, axis=1), axis=1)[:, -jacobian.shape[1] :], axis=1)
        error = np.abs(np.asarray(arm.minors(q, task=task)) - expected).max(axis=1) / np.maximum(scale, 1e-300)
        label = "the determinant" if len(columns) == 1 else f"{len(columns)} maximal minors"
        found.append(
            Check(
                f"{label} against NumPy's, of the Jacobian's columns ({task}); relative to their lengths",
                len(q),
                float(error.max()),
                DOUBLE,
            )
        )
    return found


def _singular_values(arm: Arm) -> list[Check]:
    q = samples(arm, MANY, seed=16)
    found = []
    for task in arm.full_rank_tasks:
        values = np.linalg.svd(np.asarray(arm.jacobian(q, task=task)), compute_uv=False)
        expected = values.prod(axis=1)
        scale = values[:, 0] ** values.shape[1]
        error = np.abs(np.asarray(arm.manipulability(q, task=task)) - expected) / np.maximum(scale, 1e-300)
        found.append(
            Check(
                f"H against the product of the Jacobian's singular values ({task}), relative to the largest",
                MANY,
                float(error.max()),
                DOUBLE,
            )
        )
    return found


def _null(arm: Arm) -> list[Check]:
    q = samples(arm, MANY, seed=17)
    found = []
    for task, rows in arm.tasks.items():
        if arm.n != rows + 1:
            continue
        jacobian, null = np.asarray(arm.jacobian(q, task=task)), np.asarray(arm.null_vector(q, task=task))
        length = np.linalg.norm(null, axis=1)
        scale = np.linalg.norm(jacobian, axis=(1, 2)) * np.maximum(length, 1e-300)
        product = np.linalg.norm((jacobian @ null[:, :, None])[:, :, 0], axis=1) / scale
        regular = length > 1e-6 * max(length.max(), 1e-300)  # at a singular configuration the direction itself is lost
        if regular.any():
            worst = float(product[regular].max())
            found.append(Check(f"null vector: J N = 0 ({task})", int(regular.sum()), worst, 1e-9))
    return found


def _single(arm: Arm) -> list[Check]:
    q = samples(arm, MANY, seed=18).astype(np.float32)
    evaluator = arm.evaluator(f"jacobian_{arm.default_task}")
    single, double = ([kind(a) for a in (q, arm.parameters) if a.size] for kind in (np.float32, np.float64))
    result = np.asarray(evaluator(*single))
    error = _relative(result.astype(float), np.asarray(evaluator(*double))) if result.dtype == np.float32 else np.inf
    return [Check("Jacobian in single precision against double", MANY, float(error), SINGLE)]
