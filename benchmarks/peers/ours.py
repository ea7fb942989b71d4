"""chainrule: float64 and float32, in batches and one at a time."""

from __future__ import annotations

import numpy as np

from benchmarks.cases import MEMORY, Array, Case, Contender


def contenders(case: Case, q: Array) -> list[Contender]:
    """The evaluator with ``out=`` for double and float; ``bind`` and the arm's method for single calls."""
    evaluator = case.arm.evaluator(case.function)
    found = []
    for kind, name in ((np.float64, "chainrule"), (np.float32, "chainrule, float32")):
        values = q.astype(kind)
        inputs = (values, case.arm.parameters.astype(kind))[: len(evaluator.inputs)]
        outputs = MEMORY.rows(len(q), [shape for _, shape in evaluator.outputs], kind)

        def batch(inputs: tuple[Array, ...] = inputs, outputs: tuple[Array, ...] = outputs) -> object:
            return evaluator(*inputs, out=outputs if len(outputs) > 1 else outputs[0])

        def results(batch: object = batch, outputs: tuple[Array, ...] = outputs) -> tuple[Array, ...]:
            batch()  # type: ignore[operator]
            return outputs

        found.append(Contender(name, len(q), batch, results))
    return found


def singles(case: Case, q: Array) -> list[Contender]:
    """Three ways to evaluate one configuration from Python, the quickest first."""
    evaluator = case.arm.evaluator(case.function)
    one = q[0].copy()
    inputs = (one, case.arm.parameters)[: len(evaluator.inputs)]
    outputs = tuple(np.zeros(shape) for _, shape in evaluator.outputs)
    bound = evaluator.bind(*inputs, *outputs)

    def of_bound() -> tuple[Array, ...]:
        bound()
        return tuple(value[None].copy() for value in outputs)

    def by_out() -> object:
        return evaluator(*inputs, out=outputs)

    def of_out() -> tuple[Array, ...]:
        by_out()
        return tuple(value[None].copy() for value in outputs)

    def of_method() -> tuple[Array, ...]:
        found = case.method(one)
        if case.key == "panda_gradient":
            return np.asarray(case.arm.manipulability(one))[None], found[None]
        return tuple(np.asarray(value)[None] for value in found)

    return [
        Contender("chainrule, bound", 1, None, of_bound, bound),
        Contender("chainrule, evaluator(q, out=)", 1, None, of_out, by_out),
        Contender("chainrule, arm.method(q)", 1, None, of_method, lambda: case.method(one)),
    ]
