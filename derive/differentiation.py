"""Reverse differentiation of named steps: a gradient as further named steps, with every value shared.

CasADi differentiates a whole function (derive/lower.py); here the gradient stays among the steps, so that one program
can use both a quantity and its gradient.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import sympy as sp

from chainrule.derive.program import Expression, GuardedInverse, Steps


def gradient(
    steps: Steps, entries: Sequence[Expression], seeds: Sequence[Expression], variables: Sequence[Expression]
) -> list[Expression]:
    """sum_k seed_k (d entry_k / d variable), one entry for each variable.

    Args:
        steps: the steps so far; those of the gradient are added.
        entries: expressions in the steps so far.
        seeds: their weights, taken as constant.
        variables: the input symbols to differentiate by.
    """
    reached = set(variables)
    for step in steps.steps:
        if step.expression.free_symbols & reached:
            reached.add(step.symbol)
    shares: dict[Expression, list[Expression]] = defaultdict(list)

    def pass_on(seed: Expression, expression: Expression, value: Expression | None) -> None:
        for symbol in sorted(expression.free_symbols & reached, key=str):
            shares[symbol].append(seed * _derivative(expression, symbol, value))

    steps_before = list(steps.steps)
    for entry, seed in zip(entries, seeds, strict=True):
        pass_on(seed, entry, None)
    for step in reversed(steps_before):
        if step.symbol in shares:
            total = steps.let(f"slope_{step.symbol}", sum(shares.pop(step.symbol), sp.Integer(0)))
            pass_on(total, step.expression, step.symbol)
    return [sum(shares[variable], sp.Integer(0)) for variable in variables]


def _derivative(expression: Expression, symbol: Expression, value: Expression | None) -> Expression:
    """d expression / d symbol; that of a root from its value, and 0 where it is 0."""
    if expression.is_Pow and expression.exp == sp.Rational(1, 2):
        root = expression if value is None else value
        return sp.diff(expression.base, symbol) * GuardedInverse(root) / 2
    return sp.diff(expression, symbol)
