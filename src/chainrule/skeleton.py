"""The arm as points and lines in one posture: where its joints are, their axes, and the tip's frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar

Array = NDArray[Any]


@dataclass(frozen=True)
class Skeleton:
    """Points and axes in the base frame; in the plane, z is 0 and a revolute joint's axis is z.

    Attributes:
        points: (n, 3) a point on every joint's axis, m (after the joint's own motion, for a prismatic one).
        axes: (n, 3) unit vectors along the joints' axes.
        tip: (3,) m.
        frame: (3, 3) the tip's axes x, y, z as columns.
        planar: whether the arm moves in a plane.
    """

    points: Array
    axes: Array
    tip: Array
    frame: Array
    planar: bool


def skeleton(arm: Arm, q: Any) -> Skeleton:
    """The skeleton at ``q`` (n,), from the same named steps that the arm's functions are generated from."""
    from chainrule.derive.program import evaluate

    given = {"q": [float(x) for x in q], "parameters": list(arm.description.model.parameters)}
    found = evaluate(_program(arm), given, digits=20)
    arrays = {name: np.array([float(x) for x in entries]).reshape(-1, 3) for name, entries in found.items()}
    flat = isinstance(arm.description.geometry, Planar)
    return Skeleton(arrays["points"], arrays["axes"], arrays["tip"][0], arrays["frame"].T, flat)


def skeletons(arm: Arm, q: Any) -> Array:
    """Base, joints and tip (k, n + 2, 3), m, at many configurations (k, n), from the same steps.

    Example:
        >>> from chainrule import planar_3r
        >>> skeletons(planar_3r(1.0, 0.5, 0.25), [[0.0, 0.0, 0.0]])[0, :, 0]
        array([0.  , 0.  , 1.  , 1.5 , 1.75])
    """
    import sympy as sp

    program, q = _program(arm), np.asarray(q, float)
    entries = [e for output in program.outputs if output.name in ("points", "tip") for e in output.expressions]
    steps = [(step.symbol, step.expression) for step in program.steps]
    symbols = [symbol for port in program.inputs for symbol in port.symbols]
    compute = sp.lambdify(symbols, entries, modules="numpy", cse=lambda expressions: (steps, expressions))
    found = compute(*q.T, *arm.description.model.parameters)
    points = np.stack([np.broadcast_to(value, len(q)) for value in found], axis=-1).reshape(len(q), arm.n + 1, 3)
    return np.concatenate([np.zeros((len(q), 1, 3)), points], axis=1)


def _program(arm: Arm) -> Any:
    """The derivation of the skeleton."""
    from chainrule.derive import catalogue, chain, planar
    from chainrule.derive.program import Expression, Output, Program, Steps, needed

    symbolic, steps = catalogue.symbolic(arm.description.model), Steps()
    flat = isinstance(arm.description.geometry, Planar)
    vectors: dict[str, list[list[Expression]]]
    if flat:
        place = planar.layout(steps, symbolic)
        starts = [[*p, 0] for p in place.points]
        ends = [*starts[1:], [*place.tip, 0]]
        heads = [[*h, 0] for h in place.headings]
        (c, s), turning = place.headings[-1], [kind == "R" for kind in arm.kinds]
        vectors = {
            "points": [a if r else b for a, b, r in zip(starts, ends, turning, strict=True)],
            "axes": [[0, 0, 1] if r else h for h, r in zip(heads, turning, strict=True)],
            "tip": [[*place.tip, 0]],
            "frame": [[c, s, 0], [-s, c, 0], [0, 0, 1]],
        }
    else:
        frames = chain.frames_from_base(steps, symbolic)
        moved = [
            [p + symbolic.q[i] * z for p, z in zip(f.p, f.z, strict=True)] if arm.kinds[i] == "P" else f.p
            for i, f in enumerate(frames.joints)
        ]
        vectors = {
            "points": moved,
            "axes": [f.z for f in frames.joints],
            "tip": [frames.tip.p],
            "frame": [frames.tip.x, frames.tip.y, frames.tip.z],
        }
    import sympy as sp

    outputs = tuple(
        Output(name, (len(rows), 3), tuple(sp.S(e) for row in rows for e in row)) for name, rows in vectors.items()
    )
    return needed(Program("skeleton", "", symbolic.inputs, tuple(steps.steps), outputs))
