"""From named steps to one flat straight-line program, through CasADi: translated, differentiated, lowered.

CasADi takes the steps as a scalar expression graph, differentiates them in reverse mode where a gradient is
wanted, and hands back its instruction list; here that list becomes a :class:`Kernel` in which every value has
one definition and equal values have one name.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import casadi as ca

from chainrule.derive.catalogue import Function
from chainrule.derive.program import CopySign, GuardedInverse, Program, Shape, Where
from chainrule.errors import GenerationError

Operand = int | float  # the index of a value, or (as float) a constant


#: Names that the generated code uses itself: no input or output may have them.
RESERVED = frozenset(
    ["args", "cosine", "count", "i", "kept", "np", "real", "sine", "start", "steps", "streaming", "taken"]
)


@dataclass(frozen=True)
class Port:
    """A named array going in or out; ``labels`` name the entries of an input."""

    name: str
    shape: Shape
    labels: tuple[str, ...] = ()

    @property
    def size(self) -> int:
        """Number of entries."""
        size = 1
        for extent in self.shape:
            size *= extent
        return size


@dataclass(frozen=True)
class Value:
    """One instruction: ``op`` applied to earlier values (indices) or constants (floats).

    ``op`` is ``input`` (args: input number, entry), ``sin``, ``cos``, ``sqrt``, ``neg``, ``abs``, ``inv``,
    ``where`` (args x, y: y, but 0 where x is 0), ``add``, ``sub``, ``mul``, ``div``, ``min``, ``max``, ``atan2`` or
    ``copysign``.
    """

    op: str
    args: tuple[Operand, ...]


@dataclass(frozen=True)
class Kernel:
    """A function ready to be written in any language.

    ``results`` gives for each output its entries, as indices of values or constants.
    """

    name: str
    summary: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    values: tuple[Value, ...]
    results: tuple[tuple[Operand, ...], ...]

    @property
    def operations(self) -> int:
        """Arithmetic operations (sines and cosines count one each)."""
        return sum(value.op != "input" for value in self.values)


def lower(function: Function) -> Kernel:
    """Lower one function of the catalogue."""
    inputs, values = expression_graph(function.program)
    outputs = [
        (o.name, o.shape, ca.vertcat(*(casadi_expression(e, values) for e in o.expressions)))
        for o in function.program.outputs
    ]
    summary = function.program.summary
    if function.gradient:
        summary = f"H and the gradients of H, 1/H and H^(-1/2), through the {function.program.summary}"
        outputs = _gradients(inputs[0], *outputs[0])
    names = [i.name for i in function.program.inputs] + [name for name, _, _ in outputs]
    if len(set(names)) < len(names):
        raise GenerationError(f"{function.name}: an input and an output, or two of either, share a name: {names}")
    if taken := RESERVED.intersection(names):
        raise GenerationError(f"{function.name}: the templates need the name {min(taken)!r} for themselves")
    ports = tuple(Port(i.name, i.shape, tuple(str(symbol) for symbol in i.symbols)) for i in function.program.inputs)
    results = [entry for _, _, entry in outputs]
    casadi_function = ca.Function("f", inputs, ca.cse(results))
    numbering = _Numbering()
    entries = _instructions(casadi_function, numbering)
    values_out, results_out = _without_unused(numbering.values, entries)
    return Kernel(function.name, summary, ports, tuple(Port(n, s) for n, s, _ in outputs), values_out, results_out)


def _gradients(q: Any, kind: str, shape: Shape, weights: Any) -> list[tuple[str, Shape, Any]]:
    """H and its gradients by one reverse sweep.

    grad H = sum_k (M_k / H) grad M_k for minors M_k, and sum_k (H / r_k) grad r_k for pivots r_k. Where H = 0 the
    gradient of H is 0 by definition (the smallest subgradient of this non-negative function), and so are those of
    1/H and H^(-1/2), whose values are infinite there.
    """
    if kind == "minors":
        h = ca.sqrt(ca.sumsqr(weights))
        seed = weights / h
    else:
        factors = ca.vertsplit(weights)
        h = factors[0]
        for factor in factors[1:]:
            h = h * factor
        seed = ca.vertcat(*(h / factor for factor in factors))
    gradient = ca.jtimes(weights, q, seed, True)
    inverse = 1 / h
    found = {
        "gradient": gradient,
        "inverse_gradient": -(inverse * inverse) * gradient,
        "inverse_root_gradient": (-0.5 * inverse * ca.sqrt(inverse)) * gradient,
    }
    size = (q.numel(),)
    return [("manipulability", (), h), *((name, size, _where(h, value)) for name, value in found.items())]


def _where(x: Any, y: Any) -> Any:
    """y, but 0 where x is 0."""
    return ca.if_else(x != 0, y, 0)


def expression_graph(program: Program) -> tuple[list[Any], dict[Any, Any]]:
    """CasADi inputs, and the graph of every symbol."""
    values: dict[Any, Any] = {}
    inputs = []
    for given in program.inputs:
        vector = ca.SX.sym(given.name, len(given.symbols))
        inputs.append(vector)
        values.update((symbol, vector[i]) for i, symbol in enumerate(given.symbols))
    for step in program.steps:
        values[step.symbol] = casadi_expression(step.expression, values)
    return inputs, values


def casadi_expression(e: Any, values: dict[Any, Any]) -> Any:
    """One small SymPy expression as a CasADi graph."""
    if e.is_Symbol:
        return values[e]
    if e.is_Rational:
        return ca.SX(float(e))
    if e.is_Add:
        # positive terms first: SymPy's order would begin many sums with a negation
        terms = sorted(e.args, key=lambda term: term.could_extract_minus_sign())
        total = casadi_expression(terms[0], values)
        for term in terms[1:]:
            total = (
                total - casadi_expression(-term, values)
                if term.could_extract_minus_sign()
                else total + casadi_expression(term, values)
            )
        return total
    if e.is_Mul:
        if e.args[0] == -1:
            return -casadi_expression(e * -1, values)
        product = casadi_expression(e.args[0], values)
        for factor in e.args[1:]:
            product = product * casadi_expression(factor, values)
        return product
    if e.is_Pow:
        base, exponent = casadi_expression(e.base, values), e.exp
        if exponent == 2:
            return base * base
        if exponent == 0.5 or (exponent.is_Rational and exponent.q == 2 and exponent.p == 1):
            return ca.sqrt(base)
        if exponent.is_Integer and abs(int(exponent)) <= 8:
            power = base
            for _ in range(abs(int(exponent)) - 1):
                power = power * base
            return power if exponent > 0 else 1 / power
    name = type(e).__name__
    if name in ("sin", "cos"):
        return getattr(ca, name)(casadi_expression(e.args[0], values))
    if name in _PAIRS:
        found = casadi_expression(e.args[0], values)
        for argument in e.args[1:]:
            found = _PAIRS[name](found, casadi_expression(argument, values))
        return found
    if isinstance(e, GuardedInverse):
        # One choice, of 1 or 0: CasADi would carry a choice of 1/x or 0 into every product with it.
        x = casadi_expression(e.args[0], values)
        there = x != 0
        return 1 / (x + (1 - there)) * there
    if isinstance(e, Where):
        return _where(casadi_expression(e.args[0], values), casadi_expression(e.args[1], values))
    raise GenerationError(f"a step may not contain {name}: {e}")


@dataclass
class _Numbering:
    """Values with equal definitions share one index (commutative arguments are ordered)."""

    values: list[Value] = field(default_factory=list)
    known: dict[Any, int] = field(default_factory=dict)

    def add(self, op: str, *args: Operand) -> Operand:
        folded = self._fold(op, args)
        if not isinstance(folded, Value):
            return folded
        key = (folded.op, tuple((type(a), a) for a in folded.args))  # the constant 6.0 is not the value number 6
        if key not in self.known:
            self.known[key] = len(self.values)
            self.values.append(folded)
        return self.known[key]

    def _negated(self, operand: Operand) -> int | None:
        """The index of x where the operand is -x."""
        if isinstance(operand, int) and self.values[operand].op == "neg":
            inner = self.values[operand].args[0]
            return inner if isinstance(inner, int) else None
        return None

    def _fold(self, op: str, args: tuple[Operand, ...]) -> Value | Operand:
        if op in ("add", "sub", "mul", "div") and all(isinstance(a, float) for a in args):
            a, b = (float(x) for x in args)
            if not (op == "div" and b == 0.0):
                return {"add": a + b, "sub": a - b, "mul": a * b, "div": a / b if b else 0.0}[op]
        if op == "neg" and isinstance(args[0], float):
            return -args[0]
        if op == "neg" and (inner := self._negated(args[0])) is not None:
            return inner
        if op == "add":
            if (inner := self._negated(args[1])) is not None:
                return self.add("sub", args[0], inner)
            if (inner := self._negated(args[0])) is not None:
                return self.add("sub", args[1], inner)
        if op == "sub" and (inner := self._negated(args[1])) is not None:
            return self.add("add", args[0], inner)
        if op == "mul":
            signs = [self._negated(a) for a in args]
            if signs[0] is not None and signs[1] is not None:
                return self.add("mul", signs[0], signs[1])
            if args[0] == -1.0 and isinstance(args[0], float):
                return self.add("neg", args[1])
            if args[1] == -1.0 and isinstance(args[1], float):
                return self.add("neg", args[0])
        if op in ("add", "mul", "min", "max"):
            args = tuple(sorted(args, key=lambda a: (isinstance(a, int), a)))
        return Value(op, args)


#: SymPy's functions of two arguments, as CasADi's.
_PAIRS = {"Min": ca.fmin, "Max": ca.fmax, "atan2": ca.atan2, CopySign.__name__: ca.copysign}

_BINARY = {
    ca.OP_ADD: "add",
    ca.OP_SUB: "sub",
    ca.OP_MUL: "mul",
    ca.OP_DIV: "div",
    ca.OP_FMIN: "min",
    ca.OP_FMAX: "max",
    ca.OP_ATAN2: "atan2",
    ca.OP_COPYSIGN: "copysign",
}
_UNARY = {ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_SQRT: "sqrt", ca.OP_NEG: "neg", ca.OP_FABS: "abs", ca.OP_INV: "inv"}


def _instructions(f: Any, numbering: _Numbering) -> list[list[Operand]]:
    """Walk CasADi's instruction list; returns the entries of each output."""
    work: dict[int, Any] = {}
    dense = [f.sparsity_out(i).find() for i in range(f.n_out())]
    outputs: list[list[Operand]] = [[0.0] * f.numel_out(i) for i in range(f.n_out())]

    def operand(place: int) -> Operand:
        """A value; what is true counts 1, what is false 0."""
        found = work[place]
        return _where_nonzero(numbering, found, 1.0) if isinstance(found, tuple) else found

    for k in range(f.n_instructions()):
        op, target, source = f.instruction_id(k), f.instruction_output(k), f.instruction_input(k)
        if op == ca.OP_OUTPUT:
            outputs[target[0]][dense[target[0]][target[1]]] = operand(source[0])
        elif op == ca.OP_INPUT:
            work[target[0]] = numbering.add("input", source[0], source[1])
        elif op == ca.OP_CONST:
            work[target[0]] = float(f.instruction_constant(k))
        elif op == ca.OP_NE:
            work[target[0]] = ("nonzero", operand(source[0]), operand(source[1]))
        elif op == ca.OP_IF_ELSE_ZERO:
            work[target[0]] = _where_nonzero(numbering, work[source[0]], operand(source[1]))
        elif op in _UNARY:
            work[target[0]] = numbering.add(_UNARY[op], operand(source[0]))
        elif op == ca.OP_SQ:
            work[target[0]] = numbering.add("mul", operand(source[0]), operand(source[0]))
        elif op == ca.OP_TWICE:
            work[target[0]] = numbering.add("add", operand(source[0]), operand(source[0]))
        elif op in _BINARY:
            work[target[0]] = numbering.add(_BINARY[op], *(operand(s) for s in source))
        else:
            raise GenerationError(f"CasADi instruction {op} has no counterpart in the generated languages")
    return outputs


def _where_nonzero(numbering: _Numbering, condition: Any, value: Operand) -> Operand:
    """``x != 0 ? value : 0``: the one conditional that derivations use."""
    if not (isinstance(condition, tuple) and condition[0] == "nonzero" and condition[2] == 0.0):
        raise GenerationError("only 'x != 0' may be a condition in a derivation")
    return numbering.add("where", condition[1], value)


def _without_unused(
    values: list[Value], entries: list[list[Operand]]
) -> tuple[tuple[Value, ...], tuple[tuple[Operand, ...], ...]]:
    """Drop values that no output needs, and renumber the rest."""
    used: set[int] = {e for out in entries for e in out if isinstance(e, int)}
    for index in range(len(values) - 1, -1, -1):
        if index in used and values[index].op != "input":
            used |= {a for a in values[index].args if isinstance(a, int)}
    renumbered: dict[int, int] = {}
    kept: list[Value] = []

    def moved(operand: Operand) -> Operand:
        return renumbered[operand] if isinstance(operand, int) else operand

    for index, value in enumerate(values):
        if index in used:
            renumbered[index] = len(kept)
            kept.append(value if value.op == "input" else Value(value.op, tuple(moved(a) for a in value.args)))
    return tuple(kept), tuple(tuple(moved(e) for e in out) for out in entries)
