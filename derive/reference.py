"""Reference values: what a function of the catalogue must return, at many digits and without the generated code.

A program is evaluated with mpmath. A gradient is the central difference of H at twice the digits, so it shares
nothing with the reverse sweep that the generated code comes from.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath

from chainrule.derive.catalogue import Function
from chainrule.derive.program import Program, evaluate


def reference(function: Function, inputs: Mapping[str, Sequence[Any]], digits: int = 40) -> dict[str, list[Any]]:
    """The outputs of a function, entry by entry.

    Args:
        function: one entry of the catalogue.
        inputs: for each input its entries, row by row.
        digits: significant digits of the result.
    """
    if not function.gradient:
        return evaluate(function.program, inputs, digits)
    name = function.program.inputs[0].name
    q = [mpmath.mpf(entry) for entry in inputs[name]]
    with mpmath.workdps(3 * digits):
        h = mpmath.mpf(10) ** -digits
        value = manipulability(function.program, inputs, 3 * digits)
        if value < h:  # 0 but for rounding, where the gradients are 0 by definition
            nothing = [mpmath.mpf(0)] * len(q)
            names = ("gradient", "inverse_gradient", "inverse_root_gradient")
            return {"manipulability": [mpmath.mpf(0)], **dict.fromkeys(names, nothing)}
        gradient = []
        for i in range(len(q)):
            ahead, behind = ([entry + sign * h * (k == i) for k, entry in enumerate(q)] for sign in (1, -1))
            rise = manipulability(function.program, {**inputs, name: ahead}, 3 * digits) - manipulability(
                function.program, {**inputs, name: behind}, 3 * digits
            )
            gradient.append(rise / (2 * h))
        return {
            "manipulability": [value],
            "gradient": gradient,
            "inverse_gradient": [-g / value**2 for g in gradient],
            "inverse_root_gradient": [-g / (2 * value ** mpmath.mpf("1.5")) for g in gradient],
        }


def manipulability(program: Program, inputs: Mapping[str, Sequence[Any]], digits: int) -> Any:
    """H from the minors (their norm) or the pivots (their product)."""
    ((name, entries),) = evaluate(program, inputs, digits).items()
    with mpmath.workdps(digits + 10):
        return mpmath.sqrt(mpmath.fsum(e**2 for e in entries)) if name == "minors" else mpmath.fprod(entries)
