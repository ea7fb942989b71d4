"""Lobatto's quadrature rule on [0, 1], and what else the values at its points say: for ``chainrule_continuation.h``."""

from __future__ import annotations

from typing import Any

import sympy as sp


def context(order: int) -> dict[str, Any]:
    """Literals of the points and of the maps from values there.

    The maps give the integrals up to each point, and the last four Legendre coefficients, of the polynomial through
    the values. The points are -1, 1 and the roots of P', P the Legendre polynomial of degree ``order`` - 1.
    """
    x = sp.Symbol("x")
    inner = sorted(sp.Poly(sp.diff(sp.legendre(order - 1, x), x), x).nroots(n=40))
    points = [sp.Integer(-1), *inner, sp.Integer(1)]
    values = sp.Matrix(order, order, lambda i, k: sp.legendre(k, points[i]))
    coefficients = values.inv()
    integrals = [sp.integrate(sp.legendre(k, x), (x, -1, x)) / 2 for k in range(order)]
    running = sp.Matrix(order, order, lambda i, k: integrals[k].subs(x, points[i])) * coefficients
    return {
        "nodes_text": _literals((point + 1) / 2 for point in points),
        "running_text": [_literals(running.row(i)) for i in range(order)],
        "last_text": [_literals(coefficients.row(k)) for k in range(order - 4, order)],
    }


def _literals(numbers: Any) -> str:
    return ", ".join(repr(float(0 if abs(number) < 1e-30 else number)) for number in numbers)
