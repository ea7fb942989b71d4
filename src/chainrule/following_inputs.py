"""What following a path and comparing its methods are given, checked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.errors import InputError, shown
from chainrule.paths import Path, real_number
from chainrule.stretches import METHODS, Chains, Method

#: The tolerance may not exceed this share of the path's smallest radius of curvature.
WIDEST = 0.9
#: Nor may it be below this share of the coordinates: postures are brought back to 1e-14 of them.
FINEST = 1e-11


def checked_chains(arm: Arm) -> Chains:
    """The arm as the one case of many.

    Raises:
        InputError: an arm that is not planar with three joints.
    """
    if not isinstance(arm, Arm):
        raise InputError(f"arm: {shown(arm)}; an arm such as load('planar_3r') is accepted")
    if not isinstance(arm.description.geometry, Planar) or arm.n != 3:
        raise InputError(f"{arm.name}: {arm.n} joints ({arm.kinds}); a planar arm with three joints is accepted")
    return Chains(arm.kinds, arm.evaluator, arm.parameters[None], np.array(arm.limits.position))


def checked_tolerance(value: Any) -> float:
    """A tolerance in m.

    Raises:
        InputError: anything but a positive number.
    """
    number = real_number(value, "tolerance")
    if not number > 0.0:
        raise InputError(f"tolerance: {number}; a positive number of metres is accepted")
    return number


def check_against_rounding(tolerance: float, size: float) -> None:
    """Refuse a tolerance that rounding of coordinates of this size decides."""
    if tolerance < FINEST * size:
        raise InputError(
            f"tolerance: {tolerance:g} m; at least {FINEST * size:.2g} m is accepted here: rounding is finer"
        )


def check_against_curvature(tolerance: float, curvature: float) -> None:
    """Refuse a tolerance within which the nearest point of the path is in doubt."""
    if tolerance * curvature > WIDEST:
        raise InputError(
            f"tolerance: {tolerance:g} m; up to {WIDEST / curvature:.4g} m is accepted, {WIDEST:g} of the smallest "
            "radius of curvature"
        )


def check_method(method: Any) -> None:
    """Refuse what is no method."""
    if not isinstance(method, str) or method not in METHODS:
        raise InputError(f"method: {shown(method)}; {', '.join(METHODS)} are accepted")


def checked_methods(methods: Any) -> tuple[Method, ...]:
    """Several methods, each once."""
    if isinstance(methods, str) or not isinstance(methods, Sequence) or not methods:
        raise InputError(f"methods: {shown(methods)}; a list of {', '.join(METHODS)} is accepted")
    for method in methods:
        check_method(method)
    return tuple(dict.fromkeys(methods))


def check_path(path: Any) -> None:
    """Refuse what is no path in the plane."""
    if not isinstance(path, Path):
        raise InputError(f"path: {shown(path)}; a path such as Circle, Spline or Curve is accepted")
