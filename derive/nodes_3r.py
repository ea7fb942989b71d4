"""Nodes of a 3R arm: where the image of its singular curves crosses itself, because two double roots meet one target.

The elimination E of ``regional_3r`` is a quadratic form in (c3, s3, 1). Two double roots mean that this conic touches
the unit circle c3^2 + s3^2 = 1 twice: then the pencil E + lambda (c3^2 + s3^2 - 1) holds a conic that is a line counted
twice, a form of rank one, and the line meets the circle in the two roots. The target (R, z) stands in E as (R - F3)^2
and (z - F4)^2 with F3, F4 linear in c3, s3: the quadratic part does not depend on it, so that lambda is one of two
numbers, minus an eigenvalue of that part; the condition on the linear part is linear in R and z, the last one
quadratic. There are two such targets for each eigenvalue at most, hence at most four nodes of this kind.

Where an arm has W = (c3 d4 + d3)^2 (the orthogonal ones), the point can meet axis 2, at c3 = -d3 / d4. The targets
(R, z) = (F3, F4) there are nodes as well where singular curves pass through that line of the joint space: theta2 is
free there, so that different crossings have one image.
"""

from __future__ import annotations

from itertools import combinations_with_replacement

import sympy as sp

from chainrule.derive.program import Expression, Output, Program, Steps
from chainrule.derive.regional_3r import TARGET, Arm, C, S, elimination

#: The target as (R, z) = (rho^2 + z^2, z), in which the conic is written.
R = sp.Symbol("R", real=True)
Z = TARGET.symbols[1]

#: Monomials of R and z that the entries have, in the order of the output.
POWERS = ((0, 0), (1, 0), (0, 1), (2, 0), (0, 2))


def conic(where: Arm) -> sp.Matrix:
    """The symmetric matrix M of E / (4 d4^2) = (c3, s3, 1) M (c3, s3, 1)^T, in terms of R and z, for d4 not 0."""
    form = sp.Poly(sp.expand(elimination(where).subs(TARGET.symbols[0], R - Z**2)), C, S)
    exponents = ((1, 0), (0, 1), (0, 0))
    matrix = sp.zeros(3, 3)
    for i, j in combinations_with_replacement(range(3), 2):
        power = tuple(a + b for a, b in zip(exponents[i], exponents[j], strict=True))
        entry = form.coeff_monomial(C ** power[0] * S ** power[1]) / (4 * where.d4**2) / (1 if i == j else 2)
        matrix[i, j] = matrix[j, i] = sp.expand(sp.cancel(entry)) if i < 2 and j < 2 else sp.expand(entry)
    return matrix


def conic_terms(where: Arm) -> Program:
    """The conic times 4 d4^2, which is E, entry by entry as polynomials in R and z.

    Output ``conic`` (6, 5): entries 11, 12, 22, 13, 23, 33; coefficients of 1, R, z, R^2, z^2.
    """
    steps = Steps()
    matrix = conic(where)
    entries: list[Expression] = []
    for i, j in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)):
        terms = sp.Poly(sp.expand(4 * matrix[i, j] * where.d4**2), R, Z)  # whole factors: exact on fractions
        known = {power: factor for power, factor in terms.terms() if factor != 0}
        if not set(known) <= set(POWERS):
            raise ValueError("the conic has a term that was not foreseen")
        entries += [
            steps.let(f"m{i + 1}{j + 1}", sp.factor_terms(sp.expand(known[power]))) if power in known else sp.Integer(0)
            for power in POWERS
        ]
    return Program(
        "conic_terms",
        "the conic E whose double contact with the unit circle is a node, by powers of R and z",
        (where.inputs,),
        tuple(steps.steps),
        (Output("conic", (6, 5), tuple(entries)),),
    )
