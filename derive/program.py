"""A derivation as named straight-line steps: what SymPy hands to CasADi, and what every test compares with.

A nested expression of a seven-joint arm cannot be simplified or differentiated in reasonable time; the same
formula as a list of small named steps can, and can be read. A :class:`Program` has inputs, steps (each one
SymPy expression over inputs and earlier steps) and outputs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

Expression = Any  # SymPy ships no types: an sp.Expr
Matrix = list[list[Expression]]  # rows
Shape = tuple[int, ...]


@dataclass(frozen=True)
class Input:
    """An input array: its name, shape and one symbol per entry (row by row)."""

    name: str
    shape: Shape
    symbols: tuple[Expression, ...]


@dataclass(frozen=True)
class Step:
    """One named intermediate quantity."""

    symbol: Expression
    expression: Expression


@dataclass(frozen=True)
class Output:
    """An output array: its name, shape and one expression per entry (row by row)."""

    name: str
    shape: Shape
    expressions: tuple[Expression, ...]


@dataclass(frozen=True)
class Program:
    """Inputs, steps in order, outputs; ``summary`` is one line saying what it computes."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    steps: tuple[Step, ...]
    outputs: tuple[Output, ...]


class Steps:
    """Collects named steps; an expression that is a number, a symbol or a negated symbol needs no name."""

    def __init__(self, steps: Iterable[Step] = ()) -> None:
        self.steps = list(steps)
        self._names: dict[str, int] = {}
        self._taken = {step.symbol.name for step in self.steps}
        self._known: dict[Expression, Expression] = {}

    def let(self, name: str, expression: Expression) -> Expression:
        """Name ``expression`` (made unique by a suffix if needed) and return its symbol."""
        if isinstance(expression, int):
            return sp.Integer(expression)
        if expression.is_Atom or (
            expression.is_Mul and len(expression.args) == 2 and expression.args[0] == -1 and expression.args[1].is_Atom
        ):
            return expression
        if expression in self._known:
            return self._known[expression]
        count = self._names.get(name, 0)
        symbol = sp.Symbol(name if count == 0 else f"{name}_{count}", real=True)
        while symbol.name in self._taken:
            count += 1
            symbol = sp.Symbol(f"{name}_{count}", real=True)
        self._names[name] = count + 1
        self._taken.add(symbol.name)
        self.steps.append(Step(symbol, expression))
        self._known[expression] = symbol
        return symbol

    def vector(self, name: str, expressions: Iterable[Expression], labels: str = "xyz") -> list[Expression]:
        """Name the entries of a vector ``name_x, name_y, ...``."""
        return [self.let(f"{name}{label}", entry) for label, entry in zip(labels, expressions, strict=True)]


def variables(name: str, count: int, label: str | None = None) -> Input:
    """An input vector with symbols ``name1 .. name<count>``."""
    stem = name if label is None else label
    return Input(name, (count,), tuple(sp.Symbol(f"{stem}{i + 1}", real=True) for i in range(count)))


def exact(number: float) -> Expression:
    """The exact rational value of a double: what the description says is what is derived from."""
    numerator, denominator = number.as_integer_ratio()
    return sp.Rational(numerator, denominator)


def needed(program: Program) -> Program:
    """The same program without the steps that no output needs."""
    wanted = {symbol for output in program.outputs for e in output.expressions for symbol in e.free_symbols}
    kept: list[Step] = []
    for step in reversed(program.steps):
        if step.symbol in wanted:
            kept.append(step)
            wanted |= step.expression.free_symbols
    return Program(program.name, program.summary, program.inputs, tuple(reversed(kept)), program.outputs)


def closed_form(program: Program) -> dict[str, list[Expression]]:
    """Outputs with every step substituted back: one expression per entry, for proofs on small arms."""
    values: dict[Expression, Expression] = {}
    for step in program.steps:
        values[step.symbol] = step.expression.xreplace(values)
    return {o.name: [e.xreplace(values) for e in o.expressions] for o in program.outputs}


def evaluate(program: Program, inputs: Mapping[str, Sequence[Any]], digits: int = 40) -> dict[str, list[Any]]:
    """Evaluate at ``digits`` significant digits with mpmath: the truth that compiled code is compared with.

    Args:
        program: what to evaluate.
        inputs: for each input its entries, row by row (floats are taken at their exact binary value).
        digits: working precision, in decimal digits.

    Returns:
        For each output its entries, row by row, as mpmath numbers.
    """
    with mpmath.workdps(digits + 10):
        values: dict[Expression, Any] = {}
        for given in program.inputs:
            for symbol, value in zip(given.symbols, inputs[given.name], strict=True):
                values[symbol] = mpmath.mpf(value)
        for step in program.steps:
            values[step.symbol] = number(step.expression, values)
        return {o.name: [number(e, values) for e in o.expressions] for o in program.outputs}


def number(expression: Expression, values: Mapping[Expression, Any]) -> Any:
    """The value of one small expression in mpmath's current precision."""
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Rational:
        return mpmath.mpf(int(expression.p)) / int(expression.q)
    if expression.is_NumberSymbol:
        return mpmath.mpf(expression.evalf(mpmath.mp.dps + 5))
    args = [number(argument, values) for argument in expression.args] if not expression.is_Piecewise else []
    if expression.is_Add:
        return mpmath.fsum(args)
    if expression.is_Mul:
        return mpmath.fprod(args)
    if expression.is_Pow:
        base, exponent = args
        if exponent == 0.5:
            return mpmath.sqrt(base)
        if exponent == int(exponent):
            return mpmath.inf if base == 0 and exponent < 0 else base ** int(exponent)
        return mpmath.inf if base == 0 and exponent < 0 else base**exponent
    if isinstance(expression, sp.sin):
        return mpmath.sin(args[0])
    if isinstance(expression, sp.cos):
        return mpmath.cos(args[0])
    if isinstance(expression, sp.Min | sp.Max):
        return (min if isinstance(expression, sp.Min) else max)(args)
    if isinstance(expression, sp.atan2):
        return mpmath.atan2(*args)
    if isinstance(expression, GuardedInverse):
        return mpmath.mpf(0) if args[0] == 0 else 1 / args[0]
    if isinstance(expression, Where):
        return mpmath.mpf(0) if args[0] == 0 else args[1]
    if isinstance(expression, CopySign):
        return -abs(args[0]) if args[1] < 0 else abs(args[0])
    raise TypeError(f"a step may not contain {type(expression).__name__}: {expression}")


class GuardedInverse(sp.Function):  # type: ignore[misc]
    """1/x, and 0 where x is 0: the step that keeps a normalisation defined at a singularity."""

    nargs = 1

    def fdiff(self, argindex: int = 1) -> Expression:
        """Derivative -1/x^2, and 0 where x is 0."""
        return -(GuardedInverse(self.args[0]) ** 2)


class Where(sp.Function):  # type: ignore[misc]
    """Where(x, y) is y, and 0 where x is 0; Where(x, 1) says whether x is not 0."""

    nargs = 2


class CopySign(sp.Function):  # type: ignore[misc]
    """|x| with the sign of y: what keeps the roots of a quadratic free of cancellation."""

    nargs = 2
