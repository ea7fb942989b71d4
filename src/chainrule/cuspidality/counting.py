"""How many postures reach a target, exactly: the number of different real roots of its quartic.

Every real root theta3 gives one theta2 and, off the first axis, one theta1. Where the point lies on the first axis
theta1 is free; where it can lie on the second one theta2 is: both are said. Floats decide almost all targets of a
batch; the rest, next to singular curves, is decided here.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.exact import rational, real_roots, sign
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, exact_function
from chainrule.cuspidality.parameters import exact_parameters, orthogonal_lengths
from chainrule.description import REGIONAL_3R
from chainrule.errors import InputError, shown

Array = NDArray[Any]


@dataclass(frozen=True)
class PostureCount:
    """How many postures reach a target.

    Attributes:
        number: of different theta3; None where every theta3 reaches it.
        multiplicities: of each, by rising tan(theta3 / 2), theta3 = pi last; all 1 off the singular curves.
        free: joints whose angle is arbitrary in some or all of these postures: "theta1", "theta2", "theta3".
    """

    number: int | None
    multiplicities: tuple[int, ...]
    free: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)


def discriminant_signs(e: Any) -> tuple[int, int, int]:
    """Signs of the discriminant of a quartic, lowest power first, and of the two that tell four real roots from none.

    With e[4] not 0 (``chainrule.derive.quartic``): two real roots where the first is negative, four where it is
    positive and the others are negative, none where it is positive otherwise. Where the first is negative the others
    are 0.
    """
    coefficients = np.empty(5, object)
    coefficients[:] = list(e)
    discriminant, below, apart = exact_function("quartic_invariants")(coefficients)[1]
    return (-1, 0, 0) if discriminant < 0 else (sign(discriminant), sign(below), sign(apart))


def count_postures(arm: Any, target: Any) -> PostureCount:
    """The postures of a 3R arm at one target, counted exactly.

    Args:
        arm: what :func:`chainrule.cuspidality.parameters.exact_parameters` takes.
        target: (rho^2, z), or (x, y, z), in the normal form's frame: numbers as :func:`rational` takes them.

    Raises:
        InputError: a target of another length, with an entry that is no number, or with negative rho^2.

    Example:
        >>> count_postures([1, 2, "1.5", 1], ["6.25", 0]).number
        4
    """
    parameters = exact_parameters(arm)
    square, z = exact_target(target)
    lengths = orthogonal_lengths(parameters)
    model, given = (REGIONAL_3R, parameters) if lengths is None else (ORTHOGONAL_3R, lengths)
    values = np.empty(2, object)
    values[:] = square, z
    return _count(parameters, exact_function("quartic", model)(given, values).tolist(), square == 0)


def exact_target(target: Any) -> tuple[Any, Any]:
    """(rho^2, z) as ``fmpq``, of (rho^2, z) or (x, y, z)."""
    entries = list(target)
    if len(entries) == 3:
        x, y, z = (rational(value, name) for value, name in zip(entries, "xyz", strict=True))
        return x * x + y * y, z
    if len(entries) != 2:
        raise InputError(f"target: {shown(target)}; (rho^2, z) or (x, y, z) is accepted")
    square, z = rational(entries[0], "rho^2"), rational(entries[1], "z")
    if square < 0:
        raise InputError(f"rho^2: {square}; a number that is not negative is accepted")
    return square, z


def _simple(e: list[Any]) -> int | None:
    """The number of real roots of a quartic without multiple ones, lowest power first; None where it may have one."""
    if e[4] == 0:
        return None
    discriminant, p, q = discriminant_signs(e)
    if discriminant == 0:
        return None
    return 2 if discriminant < 0 else 4 if p < 0 and q < 0 else 0


def _count(parameters: Array, e: list[Any], on_axis: bool) -> PostureCount:
    from flint import fmpq_poly

    free = ("theta1",) if on_axis else ()
    number = _simple(e)
    if number is not None:
        return PostureCount(number, (1,) * number, free)
    polynomial = fmpq_poly(e)
    if polynomial.degree() < 0:
        return PostureCount(None, (), (*free, "theta3"))
    multiplicities = [root.multiplicity for root in real_roots(polynomial)]
    if polynomial.degree() < 4:
        multiplicities.append(4 - polynomial.degree())
    if _on_second_axis(parameters, polynomial):
        free = (*free, "theta2")
    return PostureCount(len(multiplicities), tuple(multiplicities), free)


def _on_second_axis(parameters: Array, quartic: Any) -> bool:
    """Whether f1 = f2 = 0 at a real root of the quartic.

    They are read off the generated ``image``: z changes by 2 sa2 f1 between theta2 = -90 and 90 deg, by 2 sa2 f2
    between 180 and 0; as polynomials of degree 2 in tan(theta3 / 2) they are known from their values at 0, 1, -1 and
    infinity.
    """
    from flint import fmpq_poly

    common, infinite = quartic, quartic.degree() < 4
    for shoulder in (_pair(0, 1), _pair(1, 0)):
        image = [_heights(parameters, turn * shoulder) for turn in (1, -1)]
        at_zero, at_one, at_minus_one, at_infinity = (first - second for first, second in zip(*image, strict=True))
        common = common.gcd(fmpq_poly([at_zero, at_one - at_minus_one, at_infinity]))
        infinite = infinite and at_infinity == 0
    return infinite or (common.degree() > 0 and bool(real_roots(common)))


def _heights(parameters: Array, shoulder: Array) -> list[Any]:
    """z for theta3 = 0, 90, -90, 180 deg: tan(theta3 / 2) = 0, 1, -1, infinity."""
    from flint import fmpq

    image = exact_function("image")
    elbows = (_pair(1, 0), _pair(0, 1), _pair(0, -1), _pair(-1, 0))
    return [fmpq(image(parameters, shoulder, elbow)[1]) for elbow in elbows]


def _pair(first: int, second: int) -> Array:
    from flint import fmpq

    found = np.empty(2, object)
    found[0], found[1] = fmpq(first), fmpq(second)
    return found


def count_doubtful(arm: Any, targets: Any, numbers: Any, doubtful: Any) -> Array:
    """Counts of a batch, the doubtful ones decided exactly.

    Args:
        arm: what :func:`chainrule.cuspidality.parameters.exact_parameters` takes.
        targets: (..., 2) of rho^2 and z, floats, taken at their binary value.
        numbers: (...) counts that floats gave.
        doubtful: (...) which of them to replace.

    Returns:
        (...) different postures; -1 where every theta3 reaches the target.
    """
    parameters = exact_parameters(arm)
    lengths = orthogonal_lengths(parameters)
    model, given = (REGIONAL_3R, parameters) if lengths is None else (ORTHOGONAL_3R, lengths)
    found: Array = np.array(numbers)
    places = np.nonzero(doubtful)
    chosen = np.asarray(targets)[places]
    if len(chosen):
        exact = np.empty(chosen.shape, object)
        exact[:] = [exact_target(row) for row in chosen.tolist()]
        quartics = exact_function("quartic", model)(given, exact).tolist()
        counts = [_count(parameters, e, square == 0).number for e, square in zip(quartics, exact[:, 0], strict=True)]
        found[places] = [-1 if number is None else number for number in counts]
    return found
