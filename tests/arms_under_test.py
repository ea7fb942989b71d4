"""What the tests compare with: every generated function, its value at 40 digits, and how far rounding may take it.

Three sources that know nothing of each other: a derivation's own program evaluated with mpmath, tests/reference.py
(kinematics from the definitions), and a running error analysis of the very operations that a kernel does.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from itertools import combinations
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import reference

import chainrule as cr
from chainrule import arms as embedded
from chainrule import compile as compiling
from chainrule.derive import catalogue, emit
from chainrule.derive.lower import Kernel, lower
from chainrule.derive.manifest import Places
from chainrule.derive.program import Program, evaluate
from chainrule.description import REGIONAL_3R, REST_TO_REST, Description, Model
from chainrule.evaluators import Evaluator, Evaluators, load

EPSILON = {np.dtype(np.float64): 2.0**-53, np.dtype(np.float32): 2.0**-24}  # half a unit in the last place of 1

#: Families run one program for all their arms: besides the embedded ones, lengths that make some of its terms vanish.
FAMILY_CASES: dict[str, cr.Arm] = {
    "planar_3r(0, 1, 0.5)": cr.planar_3r(0.0, 1.0, 0.5),
    "planar_3r(1, 0, 0.5)": cr.planar_3r(1.0, 0.0, 0.5),
    "planar_3r(1, 0.5, 0)": cr.planar_3r(1.0, 0.5, 0.0),
    "planar_3r(0, 0, 0)": cr.planar_3r(0.0, 0.0, 0.0),
    "orthogonal_3r(1, 2, 1.5, 1)": cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0),
    "orthogonal_3r(0, 2, 1.5, 0)": cr.orthogonal_3r(0.0, 2.0, 1.5, 0.0),
    "orthogonal_3r(1, 0, 0.3, 0.2)": cr.orthogonal_3r(1.0, 0.0, 0.3, 0.2),
    "orthogonal_3r(1, 2, 0, 1)": cr.orthogonal_3r(1.0, 2.0, 0.0, 1.0),
}
#: The other planar arms of three joints, whose functions are generated although no embedded arm is one.
MORPHOLOGIES: dict[str, cr.Arm] = {
    kinds: cr.planar(
        kinds,
        [0.9, 0.6, 0.35],
        [{"R": 0.0, "P": turn}[kind] for kind, turn in zip(kinds, (0.4, 1.1, -0.8), strict=True)],
    )
    for kinds in ("RRP", "RPR", "PRR", "RPP", "PRP", "PPR", "PPP")
}


class NoArm:
    """What the standing functions that belong to no arm look like to the tests: configurations only make inputs."""

    n, kinds = 3, "RRR"

    def __init__(self, model: Model, group: str, parameters: Sequence[float] = ()) -> None:
        self.description = SimpleNamespace(model=model)
        self.parameters = np.array(parameters)
        self._evaluators, self._group = Evaluators(model), group

    def evaluator(self, name: str) -> Evaluator:
        found = self._evaluators.get(self._group, name)
        assert found is not None
        return found


ARMS: dict[str, Any] = {name: cr.load(name) for name in embedded.names()} | FAMILY_CASES | MORPHOLOGIES
ARMS["rest_to_rest"] = NoArm(REST_TO_REST, "rest_to_rest")
#: Normal forms of 3R arms: cosines and sines of the twists, lengths.
ARMS |= {
    f"regional 3R, {words}": NoArm(REGIONAL_3R, "cuspidality", values)
    for words, values in (
        ("any twists", (0.28, 0.96, -0.6, 0.8, 1.0, 2.0, 1.5, 1.0, 0.5)),
        ("alpha2 right", (0.0, 1.0, 0.28, -0.96, 0.7, 0.9, 0.8, 0.3, -0.2)),
        ("axes 2 and 3 parallel", (0.6, 0.8, 1.0, 0.0, 1.0, 2.0, 1.5, 0.4, 0.0)),
    )
}

MANIFEST: dict[str, Any] = json.loads((Places.here().generated / "manifest.json").read_text("utf-8"))


def cases() -> Iterator[tuple[str, str, str]]:
    """Every generated function of every arm, as the manifest lists them: (arm, group, function)."""
    for name, arm in ARMS.items():
        for unit in MANIFEST["units"].values():
            if unit["model"] == arm.description.model.name:
                for group in unit["groups"]:
                    yield from ((name, group, function) for function in unit["functions"])


@cache
def derived(arm: str, group: str) -> dict[str, catalogue.Function]:
    """The derivations of one group of an arm, by the name of the function."""
    return {function.name: function for function in catalogue.functions(ARMS[arm].description.model, group)}


@cache
def kernel(arm: str, group: str, function: str) -> Kernel:
    """The operations of one generated function."""
    return lower(derived(arm, group)[function])


@cache
def numpy_evaluators(model: str, group: str) -> dict[str, Evaluator]:
    """The evaluators made of the generated NumPy code."""
    unit = f"{model}_{group}"
    path = Places.here().generated / model / f"{unit}.py"
    return load(compiling.Built(unit, model, MANIFEST["units"][unit]["functions"], path, None))


def inputs_of(arm: cr.Arm, q: Sequence[Any]) -> dict[str, Sequence[Any]]:
    """The inputs of an arm's functions of a configuration."""
    return {"q": q, "parameters": [float(p) for p in arm.parameters]}


#: Inputs that are lengths and times.
POSITIVE = ("move", "instant")


def given(ports: Sequence[tuple[str, Sequence[int]]], arm: Any, q: np.ndarray) -> list[np.ndarray]:
    """Every input of a function for configurations q (k, n), of q's type: what is neither q nor a parameter is made
    of q, so that a configuration always brings the same."""
    found = []
    for name, shape in ports:
        if name == "q":
            found.append(q)
        elif name == "parameters" and len(ports) > 1:
            found.append(arm.parameters.astype(q.dtype))
        else:
            weights = np.random.default_rng(sum(map(ord, name))).uniform(1.0, 3.0, (q.shape[-1], math.prod(shape)))
            with np.errstate(invalid="ignore"):
                values = np.cos((q.astype(float)[..., None] * weights).sum(axis=-2))  # row by row alike, unlike @
            if name == "leading":  # a choice of one joint
                values = np.eye(values.shape[-1])[np.nan_to_num(values).argmax(axis=-1)]
            if name == "parameters":  # nothing else to vary: other arms, what is 0 stays 0
                values = arm.parameters * (1.0 + 0.3 * values)
            if name == "target" and tuple(shape) == (2,):  # rho^2 is not negative
                values = values * [arm.parameters[-5:].max(), 1.0]
                values[..., 0] **= 2
            found.append((np.abs(values) + 0.1 if name in POSITIVE else values).astype(q.dtype))
    return found


def shaped(ports: Sequence[tuple[str, Sequence[int]]], arrays: Sequence[np.ndarray]) -> list[np.ndarray]:
    """The inputs of :func:`given` with the axes that a function takes: matrices are not rows."""
    return [array.reshape(*array.shape[:-1], *shape) for array, (_, shape) in zip(arrays, ports, strict=True)]


def ports_of(program: Program | Kernel) -> list[tuple[str, Sequence[int]]]:
    """Names and shapes of a function's inputs."""
    return [(port.name, port.shape) for port in program.inputs]


def written(arm: cr.Arm, group: str) -> dict[str, Callable[..., Any]]:
    """The functions of one group of any arm: derived now, written as NumPy code, and that code executed."""
    model = arm.description.model
    kernels = [lower(function) for function in catalogue.functions(model, group)]
    unit = f"{model.name}_{group}"
    space: dict[str, Any] = {}
    exec(emit.unit(unit, model.name, unit, kernels, "0" * 64)[f"{unit}.py"], space)
    return {k.name: space[k.name] for k in kernels}


def emitted(arm: cr.Arm, group: str) -> dict[str, Callable[..., Any]]:
    """The functions that :func:`written` makes, of configurations only."""

    def quiet(code: Callable[..., Any]) -> Callable[..., Any]:
        def call(q: Any) -> Any:
            with np.errstate(all="ignore"):
                return code(*arguments(arm, q))

        return call

    return {name: quiet(code) for name, code in written(arm, group).items()}


def arguments(arm: cr.Arm, q: Any) -> list[Any]:
    """What an arm's generated functions take: q and, for families, the parameters."""
    return [q, arm.parameters] if arm.parameters.size else [q]


def outputs_of(evaluator: Evaluator, arm: cr.Arm, q: Any) -> list[np.ndarray]:
    """Every output of an evaluator at the configurations q (k, n), each as (k, entries)."""
    found = evaluator(*shaped(evaluator.inputs, given(evaluator.inputs, arm, q)))
    found = found if isinstance(found, tuple) else (found,)
    return [
        np.asarray(entry).reshape(len(q), math.prod(shape))
        for entry, (_, shape) in zip(found, evaluator.outputs, strict=True)
    ]


# ---- truth -----------------------------------------------------------------------------------------------------


def truth(arm: str, group: str, function: str, q: Sequence[float]) -> list[list[Any]]:
    """Every output at one configuration at 40 digits: of the program, or for gradients of an independent derivative."""
    found = derived(arm, group)[function]
    if found.gradient:
        return gradients(ARMS[arm].description, group, q)
    ports = ports_of(found.program)
    arrays = given(ports, ARMS[arm], np.asarray(q, float))
    inputs = {name: [float(x) for x in array] for (name, _), array in zip(ports, arrays, strict=True)}
    return list(evaluate(found.program, inputs, 40).values())


ROWS = {
    2: {"position": (0, 1), "x_alpha": (0, 2), "pose": (0, 1, 2)},
    3: {"position": (0, 1, 2), "pose": (0, 1, 2, 3, 4, 5)},
}


def task_jacobian(description: Description, task: str, q: Sequence[Any], digits: int = 40) -> Any:
    """The rows of the reference Jacobian that belong to a task."""
    whole = reference.jacobian(description, q, digits)
    rows = ROWS[2 if whole.rows == 3 else 3][task]
    return mpmath.matrix([[whole[row, i] for i in range(whole.cols)] for row in rows])


def manipulability(description: Description, task: str, q: Sequence[Any], digits: int = 80) -> Any:
    """sqrt(det(J J^T)) of the reference Jacobian: twice the digits, since the product loses half of them."""
    with mpmath.workdps(digits):
        jacobian = task_jacobian(description, task, q, digits)
        return mpmath.sqrt(abs(determinant((jacobian * jacobian.T).tolist())))


def gradients(
    description: Description, task: str, q: Sequence[float], digits: int = 100, only: Sequence[int] | None = None
) -> list[list[Any]]:
    """H and the gradients of H, 1/H and H^(-1/2), by central differences of the reference's manipulability.

    At 100 digits and a step of 1e-30 the truncation is below 1e-50 of the third derivative, and the rounding of H far
    below that. Where H is zero the gradients are zero by definition. With ``only``, entries of other joints are nan.
    """
    with mpmath.workdps(digits):
        q = [mpmath.mpf(float(x)) for x in q]
        step = mpmath.mpf(10) ** -30
        here = manipulability(description, task, q, digits)
        if here < mpmath.mpf(10) ** (-digits // 3):
            return [[mpmath.mpf(0)]] + [[mpmath.mpf(0)] * len(q)] * 3
        gradient = []
        for i in range(len(q)):
            if only is not None and i not in only:
                gradient.append(mpmath.nan)
                continue
            ahead, behind = ([*q[:i], q[i] + s, *q[i + 1 :]] for s in (step, -step))
            rise = manipulability(description, task, ahead, digits) - manipulability(description, task, behind, digits)
            gradient.append(mpmath.chop(rise / (2 * step), mpmath.mpf(10) ** -40))
        inverse, root = -1 / here**2, -1 / (2 * here * mpmath.sqrt(here))
        return [[here], gradient, [inverse * g for g in gradient], [root * g for g in gradient]]


def minors_of(matrix: Any) -> list[Any]:
    """The determinants of the maximal square submatrices of an mpmath matrix, columns in lexicographic order."""
    m, n = matrix.rows, matrix.cols
    return [determinant([[matrix[i, j] for j in columns] for i in range(m)]) for columns in combinations(range(n), m)]


def determinant(rows: Sequence[Sequence[Any]]) -> Any:
    """By elimination with row exchanges, in the current precision; mpmath's own fails where a whole column is zero."""
    left, value = [list(row) for row in rows], mpmath.mpf(1)
    while left:
        pivot = max(left, key=lambda row: abs(row[0]))
        if pivot[0] == 0:
            return mpmath.mpf(0)
        value *= pivot[0] * (-1) ** left.index(pivot)
        left.remove(pivot)
        left = [[b - row[0] / pivot[0] * a for a, b in zip(pivot[1:], row[1:], strict=True)] for row in left]
    return value


def row_lengths(description: Description, task: str, q: Sequence[float]) -> list[float]:
    """The lengths of the rows of the task Jacobian; their product bounds its minors (Hadamard)."""
    matrix = task_jacobian(description, task, [float(x) for x in q])
    return [float(mpmath.norm(matrix[row, :])) for row in range(matrix.rows)]


# ---- how far rounding may take a result ------------------------------------------------------------------------


def rounding_bounds(
    program: Kernel, inputs: Mapping[str, np.ndarray], epsilon: float = 2.0**-53, sine_ulps: float = 0.85
) -> list[np.ndarray]:
    """For each output (k, entries) a bound on |computed - exact|, by running error analysis.

    Every operation adds half a unit in the last place of its result to what its arguments carry; sine and cosine add
    ``sine_ulps`` units. The bound knows the cancellations that happened, so it is as small near a singularity as the
    operations allow, and nothing in it is fitted to what the code does.
    """
    count = len(max(inputs.values(), key=np.ndim))  # parameters may be the same for all
    values: list[np.ndarray] = []
    errors: list[np.ndarray] = []  # in units of epsilon

    def operand(a: int | float) -> tuple[np.ndarray, np.ndarray]:
        if isinstance(a, float):
            inexact = epsilon > 2.0**-53 and float(np.float32(a)) != a
            return np.full(count, a), np.full(count, abs(a) if inexact else 0.0)
        return values[a], errors[a]

    with np.errstate(all="ignore"):
        for value in program.values:
            if value.op == "input":
                port = program.inputs[int(value.args[0])].name
                given = inputs[port][..., int(value.args[1])]
                values.append(np.broadcast_to(given, count).astype(float))
                errors.append(np.zeros(count))
                continue
            v, e = _step(value.op, [operand(a) for a in value.args], epsilon, sine_ulps)
            values.append(v)
            errors.append(e)
        results = []
        for entries in program.results:
            bounds = []
            for entry in entries:
                bounds.append(np.nan_to_num(operand(entry)[1] * epsilon, nan=np.inf, posinf=np.inf))
            results.append(np.stack(bounds, axis=-1) if bounds else np.zeros((count, 0)))
    return results


def _step(op: str, arguments: list[Any], epsilon: float, sine_ulps: float) -> tuple[np.ndarray, np.ndarray]:
    """The value of one operation, and its error in units of epsilon."""
    (a, ea), (b, eb) = arguments[0], arguments[-1]
    if op in ("sin", "cos"):
        value = np.sin(a) if op == "sin" else np.cos(a)
        return value, 2 * sine_ulps * np.abs(value)
    if op == "neg":
        return -a, ea
    if op == "abs":
        return np.abs(a), ea
    if op == "where":
        undecided = (np.abs(a) <= ea * epsilon) & (ea > 0)
        return np.where(a != 0, b, 0), np.where(undecided, np.inf, np.where(a != 0, eb, 0))
    if op == "sqrt":
        a = np.maximum(a, 0)
        value, error = np.sqrt(a), ea / (np.sqrt(a + ea * epsilon) + np.sqrt(np.maximum(a - ea * epsilon, 0)))
        exact = (a == 0) & (ea == 0)
        return value, np.where(exact, 0, np.where(ea == 0, 0, error) + _rounded(value, error, epsilon))
    if op in ("add", "sub"):
        value, error = (a + b if op == "add" else a - b), ea + eb
        exact = ((a == 0) & (ea == 0)) | ((b == 0) & (eb == 0))
        exact |= (ea == 0) & (eb == 0) & (a == np.rint(a)) & (b == np.rint(b)) & (np.abs(value) < 2.0**20)
        return value, error + np.where(exact, 0, _rounded(value, error, epsilon))
    if op == "mul":
        value = a * b
        error = np.abs(a) * eb + np.abs(b) * ea + ea * eb * epsilon
        exact = np.isin(np.abs(a), (0.0, 1.0, 2.0, 0.5)) & (ea == 0) | np.isin(np.abs(b), (0.0, 1.0, 2.0, 0.5)) & (
            eb == 0
        )
        return value, error + np.where(exact, 0, _rounded(value, error, epsilon))
    if op in ("min", "max"):
        clear = np.abs(a - b) > (ea + eb) * epsilon  # which one it is, rounding cannot change
        first = a < b if op == "min" else a > b
        return np.where(first, a, b), np.where(clear, np.where(first, ea, eb), np.maximum(ea, eb))
    if op == "copysign":
        return np.copysign(a, b), np.where((np.abs(b) <= eb * epsilon) & (eb > 0), np.inf, ea)
    if op == "atan2":
        size = np.maximum(a * a + b * b, 1e-300)
        value, error = np.arctan2(a, b), (np.abs(b) * ea + np.abs(a) * eb) / size
        torn = (np.abs(a) <= ea * epsilon) & (ea > 0) & (b - eb * epsilon <= 0)  # the angle jumps by a turn there
        return value, np.where(torn, np.inf, error) + 2 * sine_ulps * np.abs(value)
    if op == "inv":
        a, ea, b, eb = np.ones_like(a), np.zeros_like(a), a, ea
    elif op != "div":
        raise ValueError(op)
    value, least = a / b, np.abs(b) - eb * epsilon
    error = np.where(least > 0, (ea + np.abs(value) * eb) / np.where(least > 0, least, 1), np.inf)
    return value, error + _rounded(value, error, epsilon)


def _rounded(value: np.ndarray, error: np.ndarray, epsilon: float) -> np.ndarray:
    """Half a unit in the last place of a result that is itself wrong by some units, and what underflow may lose."""
    tiny = 2.0**-1074 if epsilon == 2.0**-53 else 2.0**-149
    return np.abs(value) + np.where(np.isfinite(error), error * epsilon, 0) + tiny / epsilon


def bounds_for(arm: str, group: str, function: str, q: np.ndarray, sine_ulps: float = 0.85) -> list[np.ndarray]:
    """The rounding bounds of one generated function at the configurations q (k, n), in the precision of q."""
    operations = kernel(arm, group, function)
    ports = ports_of(operations)
    arrays = given(ports, ARMS[arm], q)
    inputs = {name: array.astype(float) for (name, _), array in zip(ports, arrays, strict=True)}
    return rounding_bounds(operations, inputs, EPSILON[q.dtype], sine_ulps)


def errors_against(found: Sequence[np.ndarray], exact: Sequence[Sequence[Sequence[Any]]]) -> list[np.ndarray]:
    """|computed - exact| of every entry: ``found`` per output (k, entries), ``exact`` per configuration and output."""
    result = []
    for place, array in enumerate(found):
        rows = [
            [abs(float(mpmath.mpf(float(x)) - y)) for x, y in zip(row, values[place], strict=True)]
            for row, values in zip(array, exact, strict=True)
        ]
        result.append(np.array(rows).reshape(array.shape))
    return result


# ---- configurations --------------------------------------------------------------------------------------------


def random_q(arm: cr.Arm, count: int, seed: int, reach: float = math.pi) -> np.ndarray:
    """Configurations (count, n): angles within +-reach, shifts within +-1 m."""
    rng = np.random.default_rng(seed)
    widths = np.array([reach if kind == "R" else 1.0 for kind in arm.kinds])
    return rng.uniform(-1.0, 1.0, (count, arm.n)) * widths


def all_equal(a: Any, b: Any) -> bool:
    """Bitwise the same numbers, nan counting as equal to nan."""
    return bool(np.array_equal(a, b, equal_nan=True))


def one_line(error: BaseException) -> str:
    """The message of an exception, after checking that it is one line of reasonable length."""
    text = str(error)
    assert text and "\n" not in text and len(text) < 400, text
    return text


def crooked_rrpr() -> cr.Arm:
    """A spatial arm with four joints, one of them a slide: one to spare for holding a position."""
    rows = [("R", 0.0, 0.0, 0.3, 0.0), ("R", -1.3, 0.1, 0.0, 0.2), ("P", 0.9, 0.2, 0.3, 0.0), ("R", 1.2, 0.1, 0.0, 0.0)]
    return cr.Arm.from_dh(rows, tool=cr.description.Transform.shift(0.3, 0.1, 0.0), name="crooked_rrpr")
