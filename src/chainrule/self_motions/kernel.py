"""The compiled functions that follow self-motion curves, and what they are given and return."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from chainrule import compile as compiling
from chainrule.description import Model


class CurveSettings(ctypes.Structure):
    """chainrule_curve_settings."""

    _fields_ = (
        ("longest", ctypes.c_double),
        ("singular", ctypes.c_double),
        ("steps", ctypes.c_ssize_t),
        ("direction", ctypes.c_int),
    )


class CurveInputs(ctypes.Structure):
    """chainrule_curve_inputs."""

    _fields_ = (
        ("starts", ctypes.c_void_p),
        ("targets", ctypes.c_void_p),
        ("target_step", ctypes.c_ssize_t),
        ("parameters", ctypes.c_void_p),
        ("parameter_step", ctypes.c_ssize_t),
        ("units", ctypes.c_void_p),
        ("unit_step", ctypes.c_ssize_t),
        ("links", ctypes.c_void_p),
        ("link_step", ctypes.c_ssize_t),
        ("sizes", ctypes.c_void_p),
        ("size_step", ctypes.c_ssize_t),
    )


class CurveRoom(ctypes.Structure):
    """chainrule_curve_room."""

    _fields_ = (
        ("points", ctypes.c_void_p),
        ("knots", ctypes.c_void_p),
        ("most_points", ctypes.c_ssize_t),
        ("most_knots", ctypes.c_ssize_t),
    )


#: chainrule_curve_result.
CURVE_RESULT = np.dtype(
    {
        "names": [
            *("length", "closure", "contraction", "lowest", "highest"),
            *("points", "knots", "steps", "evaluations", "reason"),
        ],
        "formats": [float] * 5 + [np.intp] * 4 + [np.intc],
    },
    align=True,
)


@dataclass(frozen=True)
class Kernel:
    """The compiled functions of a model's arms: ``follow`` a curve, ``correct`` configurations near it."""

    follow: Any
    correct: Any


@cache
def kernel(model: Model, task: str) -> Kernel | None:
    """The compiled functions of a model's arms, or None where there is no compiler."""
    built = compiling.find(model, f"continuation_{task}")
    if built.library is None:
        return None
    library, name = ctypes.CDLL(str(built.library)), f"{built.prefix}_continuation_{task}"
    follow, correct = library[f"{name}_follow"], library[f"{name}_correct"]
    many, inputs = ctypes.c_ssize_t, ctypes.POINTER(CurveInputs)
    follow.restype, correct.restype = many, None
    follow.argtypes = [
        *(many, inputs, ctypes.POINTER(CurveSettings), ctypes.POINTER(CurveRoom)),
        *[ctypes.c_void_p] * 2,
    ]
    correct.argtypes = [many, inputs, ctypes.c_int, *[ctypes.c_void_p] * 2]
    return Kernel(follow, correct)
