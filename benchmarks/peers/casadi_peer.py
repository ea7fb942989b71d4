"""CasADi: its virtual machine, and its generated C compiled by the same compiler, called in a C loop."""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.cases import Array, Case, Contender, Unavailable, empty_outputs
from chainrule.compile import compiler
from chainrule.description import Planar, Serial

FLAGS = ("-O3", "-march=native")

DRIVER = """
/* The C loop over configurations: rows in, rows out, as in a NumPy array. Workspace is given once. */
void drive(long count, const casadi_real *q, {outputs})
{{
    const casadi_real *arg[{sz_arg}];
    casadi_real *res[{sz_res}];
    casadi_int iw[{sz_iw}];
    casadi_real w[{sz_w}];
    for (long i = 0; i < count; ++i) {{
        arg[0] = q + i * {n};
{advance}
        evaluate(arg, res, iw, w, 0);
    }}
}}
"""


def contenders(case: Case, q: Array) -> list[Contender]:
    """The compiled C in a C loop, and the virtual machine's serial map; single calls of both through buffers.

    The gradient also comes in a second formulation, det(J J^T) by an LDL factorisation: four times fewer operations.
    """
    try:
        import casadi  # noqa: F401
    except ImportError:
        raise Unavailable("CasADi is not installed") from None
    natural = _function(case, "det")
    found = [*_compiled(case, natural, q), *_machine(case, natural, q)]
    if case.key == "panda_gradient":
        found += [replace(c, name=f"{c.name}, LDL") for c in _compiled(case, _function(case, "ldl"), q)]
    return found


def _function(case: Case, determinant: str) -> Any:
    """The natural formulation of the case, with common subexpressions shared and rows stored as NumPy stores them."""
    import casadi as ca

    q = ca.SX.sym("q", case.arm.n)
    made = min(
        (_outputs(case, q, by_product, determinant) for by_product in (False, True)),
        key=lambda found: ca.Function("f", [q], found).n_instructions(),
    )
    # CasADi stores columns; a transposed result lies in memory as NumPy's rows do.
    return ca.Function("evaluate", [q], ca.cse([ca.densify(value.T) for value in made]))


def _outputs(case: Case, q: Any, by_product: bool, determinant: str) -> list[Any]:
    """The case's outputs; the Jacobian by products or by differentiation, of which the shorter is taken."""
    import casadi as ca

    geometry = case.arm.description.geometry
    if isinstance(geometry, Planar):
        headings = [sum((q[k] for k in range(1, i + 1)), q[0]) for i in range(case.arm.n)]
        terms = [
            ca.vertcat(length * ca.cos(a), length * ca.sin(a))
            for length, a in zip(geometry.lengths, headings, strict=True)
        ]
        if by_product:  # headings by the addition theorem
            terms = _by_addition(geometry.lengths, q)
        position = sum(terms[1:], terms[0])
        jacobian = ca.jacobian(position, q)
        return [position, jacobian, ca.sqrt(ca.det(jacobian @ jacobian.T))]
    if not isinstance(geometry, Serial):
        raise Unavailable(f"CasADi: no formulation of {case.title}")
    frame, axes, origins = ca.SX.eye(4), [], []
    for placement, angle in zip(geometry.placements, ca.vertsplit(q), strict=True):
        frame = frame @ _matrix(placement)
        axes.append(frame[:3, 2])
        origins.append(frame[:3, 3])
        c, s = ca.cos(angle), ca.sin(angle)
        turn = ca.SX.eye(4)
        turn[0, 0], turn[0, 1], turn[1, 0], turn[1, 1] = c, -s, s, c
        frame = frame @ turn
    frame = frame @ _matrix(geometry.tool)
    tip = frame[:3, 3]
    linear = (
        ca.horzcat(*(ca.cross(z, tip - o) for z, o in zip(axes, origins, strict=True)))
        if by_product
        else ca.jacobian(tip, q)
    )
    jacobian = ca.vertcat(linear, ca.horzcat(*axes))
    if case.key == "panda":
        return [frame, jacobian]
    product = jacobian @ jacobian.T
    norm = ca.sqrt(ca.det(product) if determinant == "det" else _product(ca.ldl(product)[0]))
    return [norm, ca.gradient(norm, q)]


def _product(values: Any) -> Any:
    result = values[0]
    for k in range(1, values.numel()):
        result = result * values[k]
    return result


def _by_addition(lengths: tuple[float, ...], q: Any) -> list[Any]:
    import casadi as ca

    c, s, terms = 1.0, 0.0, []
    for k, length in enumerate(lengths):
        ck, sk = ca.cos(q[k]), ca.sin(q[k])
        c, s = c * ck - s * sk, s * ck + c * sk
        terms.append(ca.vertcat(length * c, length * s))
    return terms


def _matrix(transform: Any) -> Any:
    import casadi as ca

    rows = [[*row, x] for row, x in zip(transform.rotation, transform.translation, strict=True)]
    return ca.SX(ca.sparsify(ca.DM([*rows, [0.0, 0.0, 0.0, 1.0]])))


def _compiled(case: Case, function: Any, q: Array) -> list[Contender]:
    import casadi as ca

    command = compiler()
    if command is None:
        raise Unavailable("CasADi's C: no C compiler was found")
    names = [name for name, _ in case.outputs]
    sizes = [int(np.prod(shape)) for _, shape in case.outputs]
    driver = DRIVER.format(
        outputs=", ".join(f"casadi_real *{name}" for name in names),
        n=case.arm.n,
        sz_arg=function.sz_arg() + 1,
        sz_res=function.sz_res() + 1,
        sz_iw=function.sz_iw() + 1,
        sz_w=function.sz_w() + 1,
        advance="\n".join(
            f"        res[{k}] = {name} + i * {size};" for k, (name, size) in enumerate(zip(names, sizes, strict=True))
        ),
    )
    generator = ca.CodeGenerator("evaluate.c", {"with_header": False})
    generator.add(function)
    # What is loaded stays loaded when its file goes.
    with tempfile.TemporaryDirectory(prefix="benchmark-", ignore_cleanup_errors=True) as folder:
        generator.generate(f"{folder}/")
        source, library = Path(folder) / "evaluate.c", Path(folder) / "evaluate.so"
        source.write_text(source.read_text("utf-8") + driver, "utf-8")
        subprocess.run([*command, *FLAGS, "-fPIC", "-shared", str(source), "-o", str(library), "-lm"], check=True)
        drive = ctypes.CDLL(str(library)).drive
        external = ca.external("evaluate", str(library))
    outputs = empty_outputs(case, len(q))
    rows = np.ascontiguousarray(q)
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (rows, *outputs)]  # these keep their arrays alive
    count = ctypes.c_long(len(q))

    def batch() -> object:
        return drive(count, *pointers)

    def results() -> tuple[Array, ...]:
        batch()
        return outputs

    return [
        Contender("CasADi, compiled C", len(q), batch, results),
        _buffered("CasADi, compiled C, buffered", case, external, rows),
    ]


def _machine(case: Case, function: Any, q: Array) -> list[Contender]:
    import casadi as ca

    count = len(q)
    mapped = function.map(count)
    columns = ca.DM(q.T)

    def batch() -> object:
        return mapped(columns)

    def results() -> tuple[Array, ...]:
        found = mapped(columns)
        return tuple(
            _rows(np.asarray(value), count, shape) for value, (_, shape) in zip(found, case.outputs, strict=True)
        )

    one = q[0].copy()

    def call() -> object:
        return function(one)

    def of_call() -> tuple[Array, ...]:
        found = function(one)
        return tuple(_rows(np.asarray(value), 1, shape) for value, (_, shape) in zip(found, case.outputs, strict=True))

    return [
        Contender("CasADi, virtual machine", count, batch, results),
        _buffered("CasADi, virtual machine, buffered", case, function, q),
        Contender("CasADi, f(q)", 1, None, of_call, call),
    ]


def _rows(value: Array, count: int, shape: tuple[int, ...]) -> Array:
    """A mapped result has its configurations side by side, each transposed; (count, *shape) is wanted."""
    return value.reshape(value.shape[0], count, -1).transpose(1, 2, 0).reshape(count, *shape)


def _buffered(name: str, case: Case, function: Any, q: Array) -> Contender:
    one = q[0].copy()
    outputs = tuple(np.zeros(shape) if shape else np.zeros(1) for _, shape in case.outputs)
    buffer, call = function.buffer()
    buffer.set_arg(0, one.data)
    for k, value in enumerate(outputs):
        buffer.set_res(k, value.data)

    def results() -> tuple[Array, ...]:
        call()
        return tuple(value.reshape(1, *shape).copy() for value, (_, shape) in zip(outputs, case.outputs, strict=True))

    # What is timed is `call` itself; `results` keeps the buffer and the arrays alive.
    results.kept = (buffer, one, outputs)  # type: ignore[attr-defined]
    return Contender(name, 1, None, results, call)
