"""A function of the catalogue as a CasADi function: what CasADi differentiates in its turn, to optimise whole paths."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca

from chainrule.derive.catalogue import Function
from chainrule.derive.lower import casadi_expression, expression_graph
from chainrule.derive.program import Program, needed
from chainrule.errors import GenerationError


def casadi_function(function: Function, outputs: Sequence[str]) -> Any:
    """Some outputs of a function, in the order of their names, over the inputs that these depend on.

    Raises:
        GenerationError: an output that the function does not have, or a gradient, which CasADi takes better itself.
    """
    program = function.program
    known = {output.name: output for output in program.outputs}
    if function.gradient or not set(outputs) <= set(known):
        raise GenerationError(f"{function.name}: {', '.join(outputs)} asked for; it has {', '.join(known)}")
    kept = needed(
        Program(program.name, program.summary, program.inputs, program.steps, tuple(known[name] for name in outputs))
    )
    arrays, values = expression_graph(kept)
    results = [
        ca.cse(ca.vertcat(*(casadi_expression(entry, values) for entry in output.expressions)))
        for output in kept.outputs
    ]
    used = [k for k, array in enumerate(arrays) if ca.depends_on(ca.vertcat(*results), array)]
    names = [kept.inputs[k].name for k in used]
    return ca.Function(function.name, [arrays[k] for k in used], results, names, list(outputs))
