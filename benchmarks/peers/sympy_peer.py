"""SymPy: the symbolic expressions through ``lambdify`` with ``cse=True``, over whole arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.cases import Array, Case, Contender, Unavailable
from chainrule.description import Planar, Serial

MOST = 20_000


def contenders(case: Case, q: Array) -> list[Contender]:
    """NumPy code over a batch and over one configuration, where SymPy gets that far."""
    try:
        import sympy  # noqa: F401
    except ImportError:
        raise Unavailable("SymPy is not installed") from None
    if case.key == "panda_gradient":
        raise Unavailable("SymPy is left out of the gradient: differentiating det(J J^T) does not finish in 240 s.")
    function = _function(case)
    rows = q[:MOST]
    one = q[0].copy()

    def batch() -> tuple[Array, ...]:
        found: tuple[Array, ...] = function(rows)
        return found

    return [Contender("SymPy lambdify", len(rows), batch, batch, lambda: function(one))]


def _function(case: Case) -> Any:
    import sympy as sp

    q = sp.symbols(f"q1:{case.arm.n + 1}", real=True)
    entries = [entry for matrix in _expressions(case, q) for entry in matrix]
    compiled = sp.lambdify([q], entries, "numpy", cse=True)
    sizes = np.cumsum([int(np.prod(shape)) for _, shape in case.outputs])[:-1]

    def evaluate(values: Array) -> tuple[Array, ...]:
        found = np.empty((len(entries), *values.shape[:-1]))
        for k, value in enumerate(compiled(np.moveaxis(values, -1, 0))):
            found[k] = value
        return tuple(
            np.moveaxis(part, 0, -1).reshape((*values.shape[:-1], *shape))
            for part, (_, shape) in zip(np.split(found, sizes), case.outputs, strict=True)
        )

    return evaluate


def _expressions(case: Case, q: tuple[Any, ...]) -> list[Any]:
    import sympy as sp

    geometry = case.arm.description.geometry
    if isinstance(geometry, Planar):
        headings = [sum(q[: i + 1]) for i in range(case.arm.n)]
        position = sp.Matrix(
            [sum(length * f(a) for length, a in zip(geometry.lengths, headings, strict=True)) for f in (sp.cos, sp.sin)]
        )
        jacobian = position.jacobian(q)
        return [position, jacobian, sp.Matrix([sp.sqrt((jacobian * jacobian.T).det())])]
    if not isinstance(geometry, Serial):
        raise Unavailable(f"SymPy: no formulation of {case.title}")
    frame, axes, origins = sp.eye(4), [], []
    for placement, angle in zip(geometry.placements, q, strict=True):
        frame = frame * _matrix(placement)
        axes.append(frame[:3, 2])
        origins.append(frame[:3, 3])
        c, s = sp.cos(angle), sp.sin(angle)
        frame = frame * sp.Matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    frame = frame * _matrix(geometry.tool)
    columns = [z.cross(frame[:3, 3] - origin).col_join(z) for z, origin in zip(axes, origins, strict=True)]
    return [frame, sp.Matrix.hstack(*columns)]


def _matrix(transform: Any) -> Any:
    import sympy as sp

    rows = [[*row, x] for row, x in zip(transform.rotation, transform.translation, strict=True)]
    return sp.Matrix([[int(x) if x == int(x) else x for x in row] for row in [*rows, [0.0, 0.0, 0.0, 1.0]]])
