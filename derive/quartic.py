"""What decides how many real roots a quartic e0 + e1 t + .. + e4 t^4 has, and of which multiplicity.

With b_k = e_k / C(4, k) its invariants are the fourth transvectant of the form with itself and the determinant of its
catalecticant matrix,
    I = 6 sum (-1)^k C(4, k) b_k b_(4-k),   J = 432 det (b_(i+j)),   i, j = 0, 1, 2,
and 4 I^3 - J^2 is 27 times the discriminant (D. Hilbert, "Theory of algebraic invariants"). They vanish together
exactly at a root of multiplicity three or four.

Shifted by e3 / (4 e4) the quartic is e4 (t^4 + q t^2 + r t + s); then for e4 not 0 there are two real roots where the
discriminant is negative, four where it is positive and q < 0 and s < q^2 / 4, none where it is positive otherwise
(E. L. Rees, "Graphical discussion of the roots of a quartic equation", American Mathematical Monthly 29, 1922).
"""

from __future__ import annotations

from math import comb

import sympy as sp

from chainrule.derive.program import Expression, Input, Output, Program, Steps

COEFFICIENTS = Input("coefficients", (5,), tuple(sp.Symbol(f"e{k}", real=True) for k in range(5)))


def invariants() -> tuple[Expression, Expression]:
    """I and J."""
    b = [e / comb(4, k) for k, e in enumerate(COEFFICIENTS.symbols)]
    transvectant = sum(((-1) ** k * comb(4, k) * b[k] * b[4 - k] for k in range(5)), sp.Integer(0))
    catalecticant = sp.Matrix(3, 3, lambda i, j: b[i + j]).det()
    return sp.expand(6 * transvectant), sp.expand(432 * catalecticant)


def shifted() -> tuple[Expression, Expression]:
    """8 e4^2 q and 64 e4^4 (s - q^2 / 4): polynomials, with the signs of q and of s - q^2 / 4."""
    t = sp.Symbol("t")
    e = COEFFICIENTS.symbols
    moved = sum((e[k] / e[4] * (t - e[3] / (4 * e[4])) ** k for k in range(5)), sp.Integer(0))
    s, _, q, _, _ = reversed(sp.Poly(sp.expand(moved), t).all_coeffs())
    return sp.expand(8 * e[4] ** 2 * q), sp.expand(64 * e[4] ** 4 * (s - q**2 / 4))


def quartic_invariants() -> Program:
    """I, J, the discriminant's multiple 4 I^3 - J^2, and what tells four real roots from none."""
    steps = Steps()
    first, second = (steps.let(name, e) for name, e in zip("IJ", invariants(), strict=True))
    below, apart = shifted()
    return Program(
        "quartic_invariants",
        "invariants I, J of a quartic, 27 times its discriminant, and what tells four real roots from none",
        (COEFFICIENTS,),
        tuple(steps.steps),
        (
            Output("invariants", (2,), (first, second)),
            Output("discriminating", (3,), (4 * first**3 - second**2, below, apart)),
        ),
    )
