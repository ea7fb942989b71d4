"""The number of cusps a second time, from the invariants of the quartic: nothing is shared with the cusp polynomial.

The coefficients of a target's quartic are polynomials of R = rho^2 + z^2 and z, and so are its invariants I and J
(``chainrule.derive.quartic``). They vanish together exactly at a root of multiplicity three or four. A resultant
eliminates R. Where what is left, a polynomial in z (in z^2 where alpha2 = +-90 deg), has simple roots only, each real
one belongs to one real R: a cusp, and no root of multiplicity four is among them.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from chainrule.cuspidality.exact import real_roots, sign_at
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, exact_function
from chainrule.cuspidality.parameters import exact_parameters, orthogonal_lengths, why_nongeneric
from chainrule.description import REGIONAL_3R

#: Directions in the plane of R and z that are tried until no two solutions fall together.
_SLANTS = (0, 1, -2, 3)


def cusps_by_invariants(arm: Any) -> int | None:
    """The number of cusps, both signs of z; None where solutions fall together: four equal roots, or cusps that meet.

    Args:
        arm: what :func:`chainrule.cuspidality.parameters.exact_parameters` takes. An arm that is not generic has none.

    Example:
        >>> cusps_by_invariants([1, 2, "1.5", 1])
        4
    """
    from flint import Ordering, fmpq_mpoly_ctx, fmpq_poly

    exact = exact_parameters(arm)
    if why_nongeneric(exact):
        return 0
    lengths = orthogonal_lengths(exact)
    model, given = (REGIONAL_3R, exact) if lengths is None else (ORTHOGONAL_3R, lengths)
    even = exact[0] == 0
    whole, z = fmpq_mpoly_ctx.get(("R", "z"), Ordering.lex).gens()
    for slant in (0,) if even else _SLANTS:
        height = z + slant * whole
        target = np.empty((1, 2), object)  # a leading axis: NumPy takes a lone polynomial for a sequence
        target[0, 0], target[0, 1] = whole - height * height, height
        quartic = exact_function("quartic", model)(given, target)
        first, second = exact_function("quartic_invariants")(quartic)[0][0]
        left = {int(power[1]): value for power, value in first.resultant(second, "R").to_dict().items()}
        step = 2 if even else 1
        eliminant = fmpq_poly([left.get(step * k, 0) for k in range(max(left, default=0) // step + 1)])
        if eliminant.degree() > 0 and eliminant.gcd(eliminant.derivative()).degree() == 0:
            roots = real_roots(eliminant)
            return sum(1 + sign_at(fmpq_poly([0, 1]), root) for root in roots) if even else len(roots)
    return None
