"""Kernels into files, through the templates: C99 (header, terms, entries) and NumPy.

Everything a template prints is computed here; the same inputs give the same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from functools import cache
from itertools import groupby
from pathlib import Path
from typing import Any

import jinja2

from chainrule.derive import lobatto, sincos
from chainrule.derive.catalogue import Curve
from chainrule.derive.listing import NUMPY, C, Listing, lay_out, leaf_source, runs
from chainrule.derive.lower import Kernel, Port
from chainrule.derive.skipping import blocks

TEMPLATES = Path(__file__).resolve().parent.parent / "templates"

#: A tile's arrays should stay in the first-level cache: 64 configurations did best, fewer where a kernel is large.
TILES = (64, 32, 16, 8)
CACHE_BYTES = 40 * 1024

#: Headers every kernel includes, and the template each is made from.
SHARED = {
    "chainrule_real.h": "real.h.j2",
    "chainrule_sincos.h": "sincos.h.j2",
    "chainrule_batch.h": "batch.h.j2",
    "chainrule_continuation.h": "continuation.h.j2",
}

#: Settings of chainrule_continuation.h; chainrule/self_motions/tracing.py has the same ones.
CONTINUATION = {
    "contraction": 0.9,
    "slab": 0.89,
    "advance": 0.85,
    "both": 0.82,
    "longest_step": 0.5,
    "step_turn": 0.5,
    "nodes": 48,
    "history": 4,
    "newton": 12,
    "settled": 1e-9,
    "left": 1e-16,
    "powers": 3,
    "parts": 8,
    "level": 1e-12,
    "order": 7,
    "least_turn": 0.02,
    "most_turn": 0.7,
    "finest": 1e-11,
    "balls": 5,
}


@cache
def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )


def render(template: str, context: Mapping[str, Any]) -> str:
    """A template filled in."""
    return _environment().get_template(template).render(**context)


def shared_headers() -> dict[str, str]:
    """The headers that do not depend on the arm."""
    contexts: dict[str, Callable[[], dict[str, Any]]] = {
        "chainrule_sincos.h": lambda: {"sincos": sincos.context()},
        "chainrule_continuation.h": lambda: {**CONTINUATION, **lobatto.context(int(CONTINUATION["order"]))},
    }
    return {name: render(template, contexts[name]() if name in contexts else {}) for name, template in SHARED.items()}


def unit(
    name: str,
    prefix: str,
    title: str,
    kernels: Sequence[Kernel],
    digest: str,
    shared: str = "../",
    curves: Sequence[Curve] = (),
) -> dict[str, str]:
    """The files of one unit, by name: header, C, its included terms, NumPy.

    Args:
        name: file stem, such as ``panda_kinematics``.
        prefix: what C symbols begin with, such as ``panda``.
        title: what the unit is, in words.
        kernels: its functions.
        digest: digest of everything the unit depends on.
        shared: where the shared headers are, relative to the unit.
        curves: the curves that its code can follow.
    """
    views = [_c_view(prefix, kernel) for kernel in kernels]
    width = max(v["rows"] for v in views)
    tile = next((t for t in TILES if width * t * 8 <= CACHE_BYTES), TILES[-1])
    common = {
        "unit": name,
        "title": title,
        "digest": digest,
        "operations": sum(kernel.operations for kernel in kernels),
        "tile": tile,
        "shared": shared,
        "guard": f"CHAINRULE_{name.upper()}_H",
        "curves": [{"symbol": f"{prefix}_continuation_{c.task}", "joints": len(c.kinds), **asdict(c)} for c in curves],
    }
    files = {
        f"{name}.{suffix}": render(f"kernel.{suffix}.j2", {"functions": views, **common})
        for suffix in ("h", "c", "inc")
    }
    numpy_views = [_numpy_view(kernel) for kernel in kernels]
    files[f"{name}.py"] = render("kernel.py.j2", {"functions": numpy_views, **common})
    return files


def port_view(port: Port) -> dict[str, Any]:
    """An array as the templates see it."""
    return {
        "name": port.name,
        "size": port.size,
        "shape": port.shape,
        "dims": "".join(f"[{extent}]" for extent in port.shape) or " (one number)",
        "labels": "" if port.name == "q" else ", ".join(port.labels),
    }


def _accesses(ports: Sequence[Port], first_place: int, first_step: int) -> list[dict[str, Any]]:
    """How the batch entry reaches each argument: its place, and "rows, columns, row stride, column stride"."""
    found, step = [], first_step
    for place, port in enumerate(ports, first_place):
        axes = len(port.shape)
        rows = port.shape[0] if axes == 2 else 1
        columns = port.shape[-1] if axes else 1
        column_step = f"steps[{step + axes - 1}]" if axes else "(ptrdiff_t)sizeof(real)"
        row_step = f"steps[{step}]" if axes == 2 else f"{columns} * {column_step}"
        found.append({"name": port.name, "place": place, "access": f"{rows}, {columns}, {row_step}, {column_step}"})
        step += axes
    return found


def _c_view(prefix: str, kernel: Kernel) -> dict[str, Any]:
    listing = Listing(kernel, C, blocks(kernel))
    layout = lay_out(listing)
    ports = kernel.inputs + kernel.outputs
    used = {run.port for run in runs(kernel, listing.angles)} | {
        leaf_source(kernel, listing.angles, index)[0] for index, v in enumerate(kernel.values) if v.op == "input"
    }
    count = len(kernel.inputs)
    work = [*(["sine", "cosine"] if listing.angles else []), *(["kept"] if layout.slots else [])]
    arrays = [
        *(("const ", p.name) for p in kernel.inputs),
        *(("const " if n != "kept" else "", n) for n in work),
        *(("", p.name) for p in kernel.outputs),
    ]
    accesses = _accesses(ports, 0, len(ports))
    return {
        "symbol": f"{prefix}_{kernel.name}",
        "summary": kernel.summary,
        "operations": kernel.operations,
        "inputs": [{**port_view(p), **a} for p, a in zip(kernel.inputs, accesses[:count], strict=True)],
        "outputs": [{**port_view(p), **a} for p, a in zip(kernel.outputs, accesses[count:], strict=True)],
        "arguments": ", ".join(port.name for port in ports),
        "unused": [port.name for port in kernel.inputs if port.name not in used],
        "angles": len(listing.angles),
        "runs": runs(kernel, listing.angles),
        "slots": layout.slots,
        "section_parameters": ", ".join(f"{const}real *restrict {name}" for const, name in arrays),
        "section_arguments": ", ".join(name for _, name in arrays),
        "sections": [
            {
                "loads": s.loads,
                "terms": s.terms,
                "stores": s.stores,
                "unused": [name for _, name in arrays if not s.mentions(name)],
            }
            for s in layout.sections
        ],
        "stretches": [
            {"skip": skip, "numbers": [number for number, _ in group]}
            for skip, group in groupby(enumerate(layout.sections, 1), key=lambda pair: pair[1].skip)
        ],
        "rows": sum(p.size for p in ports) + 2 * len(listing.angles) + layout.slots,
    }


def _numpy_view(kernel: Kernel) -> dict[str, Any]:
    listing = Listing(kernel, NUMPY)
    loads = []
    for index, value in enumerate(kernel.values):
        if value.op == "input":
            loads.append(f"{listing.names[index]} = {kernel.inputs[int(value.args[0])].name}[..., {value.args[1]}]")
        elif value.op in ("sin", "cos"):
            loads.append(f"{listing.names[index]} = np.{value.op}({listing.names[int(value.args[0])]})")
    stores = [
        f"{port.name}[..., {row}] = {listing.text(operand)}"
        for port, results in zip(kernel.outputs, kernel.results, strict=True)
        for row, operand in enumerate(results)
    ]
    return {
        "name": kernel.name,
        "summary": kernel.summary,
        "operations": kernel.operations,
        "inputs": [port_view(p) for p in kernel.inputs],
        "outputs": [port_view(p) for p in kernel.outputs],
        "loads": loads,
        "terms": [f"{listing.names[s.index]} = {s.text}" for s in listing.statements],
        "stores": stores,
    }
