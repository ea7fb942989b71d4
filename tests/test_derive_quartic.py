"""Invariants of a quartic, and the signs that count its real roots."""

import numpy as np
import pytest
import sympy as sp
from flint import fmpq, fmpq_poly

from chainrule.cuspidality.normal_form import exact_function
from chainrule.derive.program import closed_form
from chainrule.derive.quartic import COEFFICIENTS, quartic_invariants

T = sp.Symbol("t", real=True)


def test_the_discriminant_is_sympys():
    found = closed_form(quartic_invariants())["discriminating"][0]
    quartic = sum(e * T**k for k, e in enumerate(COEFFICIENTS.symbols))
    assert sp.expand(found - 27 * sp.discriminant(quartic, T)) == 0


def test_invariants_do_not_change_under_moves_of_the_line():
    """I and J of e(t + h) are those of e(t), and those of t^4 e(1 / t) too."""
    e, h = COEFFICIENTS.symbols, sp.Symbol("h")
    found = closed_form(quartic_invariants())["invariants"]
    quartic = sum(c * T**k for k, c in enumerate(e))
    moved = reversed(sp.Poly(sp.expand(quartic.subs(T, T + h)), T).all_coeffs())
    for changed in (list(moved), list(reversed(e))):
        new = [f.subs(dict(zip(e, changed, strict=True)), simultaneous=True) for f in found]
        assert all(sp.expand(a - b) == 0 for a, b in zip(new, found, strict=True))


@pytest.mark.parametrize("multiplicity", [2, 3, 4])
def test_both_vanish_exactly_at_triple_roots(multiplicity):
    """A double root alone leaves I and J apart from 0."""
    e = COEFFICIENTS.symbols
    a, b, c = sp.symbols("a b c")
    rest = {2: (T - b) * (T - c), 3: T - b, 4: sp.Integer(1)}[multiplicity]
    powers = list(reversed(sp.Poly(sp.expand((T - a) ** multiplicity * rest), T).all_coeffs()))
    values = dict(zip(e, powers, strict=True))
    found = [sp.expand(f.subs(values)) for f in closed_form(quartic_invariants())["invariants"]]
    assert [f == 0 for f in found] == [multiplicity > 2] * 2


def test_signs_count_the_real_roots():
    """Against FLINT's isolated roots of 500 quartics with small whole coefficients."""
    rng = np.random.default_rng(4)
    signs = exact_function("quartic_invariants")
    for row in rng.integers(-6, 7, (500, 5)).tolist():
        if row[4] == 0:
            continue
        e = np.array([fmpq(c) for c in row], object)
        discriminant, below, apart = signs(e)[1]
        if discriminant == 0:
            continue
        real = sum(root.imag.contains(0) for root, _ in fmpq_poly(row).complex_roots())
        assert real == (2 if discriminant < 0 else 4 if below < 0 and apart < 0 else 0)
