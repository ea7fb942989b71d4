"""The folder that needs nothing else: one unit with every function of an arm, its test programs and its README."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from chainrule.derive import catalogue, emit
from chainrule.derive.catalogue import Function
from chainrule.derive.lower import Kernel
from chainrule.derive.manifest import Places
from chainrule.derive.program import Input
from chainrule.derive.reference import manipulability, reference
from chainrule.derive.write import headers, make_unit
from chainrule.description import Description, identifier

DIGITS = 40
COUNT = 3  # configurations in the test programs
SAMPLED = {"joints": (0.5, 1.5)}  # ranges of the inputs in the test programs; from -1 to 1 else
#: What is a part of another result, and may be 0: errors are relative to the largest entry of either.
PARTS = {"null_motion": "rates"}
#: Counts how many times what rounding can do lies between a verdict and another one: right to 1, however small it is.
MARGIN = "margin"
#: Verdicts that are 0 where rounding in double would decide them; float may decide them there, one way or the other.
VERDICTS = ("domain", "topology")
LIMIT = 512  # times epsilon: the test programs' bound on the error relative to the largest entry


def folder(arm: Description, targets: Sequence[str], task: str, progress: Callable[[str], None]) -> dict[str, str]:
    """Every file of the folder, by name; the step is along the task, if that has no more rows than there are joints."""
    model, unit = arm.model, identifier(arm.name)
    progress(f"deriving {arm.name}")
    stepping = [g for g in (f"redundancy_{task}", f"priority_{task}") if g in catalogue.first_use(model)]
    groups = (*catalogue.groups(model), *stepping, "dynamics")
    made = make_unit(Places.here(), model, groups, name=unit, prefix=unit, shared="")
    progress("computing reference values")
    functions = [f for group in groups for f in catalogue.functions(model, group)]
    context = {
        "unit": unit,
        "digest": made.record["digest"],
        "digits": DIGITS,
        "count": COUNT,
        "limit": LIMIT,
        "step": _step(arm, task, functions, made.kernels) if stepping else None,
        **_reference_values(arm, functions, made.kernels),
    }
    files: dict[str, str] = {}
    if "c" in targets:
        files |= {name: text for name, text in made.files.items() if not name.endswith(".py")} | headers(Places.here())
        files[f"{unit}_float.c"] = emit.render("float.c.j2", context)
        if stepping:
            files |= {f"{unit}_step.{end}": emit.render(f"step.{end}.j2", context | context["step"]) for end in "hc"}
        files[f"test_{unit}.c"] = emit.render("test.c.j2", context)
    if "python" in targets:
        files[f"{unit}.py"] = made.files[f"{unit}.py"]
        files[f"test_{unit}.py"] = emit.render("test.py.j2", context)
    files["README.md"] = emit.render(
        "readme.md.j2",
        {
            **context,
            "arm": arm.name,
            "joints": arm.n,
            "kinds": arm.kinds,
            "source": _one_line(arm.source),
            "targets": targets,
            "parameters": [
                {"name": n, "value": v} for n, v in zip(model.parameter_names, model.parameters, strict=True)
            ],
        },
    )
    return files


def _step(arm: Description, task: str, functions: Sequence[Function], kernels: Sequence[Kernel]) -> dict[str, Any]:
    """What the templates of the steps along the task take besides the unit's name and digest."""
    named = {kernel.name: kernel for kernel in kernels}
    ports = {port.name: port for port in named[f"step_{task}"].inputs}
    variants = []
    for name, function in (("step", f"step_{task}"), ("priority_step", f"priority_{task}")):
        if function in named:
            own = named[function].inputs
            given = next(f.program.inputs for f in functions if f.name == function)
            views = [
                {**emit.port_view(port), "sample": _sample(functions, entry)}
                for port, entry in zip(own, given, strict=True)
            ]
            more = [port.name for port in own if port.name not in ports]
            variants.append({"name": name, "function": function, "ports": views, "more": more})
    limits = [joint.middle_and_narrowness for joint in arm.joints]
    names = arm.model.parameter_names
    rows = [[1.0] * arm.n, [0.0] * arm.n, [middle for middle, _ in limits], [narrow for _, narrow in limits]]
    settings = ports["settings"].labels[:-1]  # all but dt
    return {
        "task": task,
        "joints": arm.n,
        "rows": ports["velocity"].size,
        "held": emit.port_view(ports["held"])["dims"],
        "held_words": " (homogeneous, row by row)" if len(ports["held"].shape) == 2 else "",
        "variants": variants,
        "more": named[f"priority_{task}"].inputs[3].shape[0] if len(variants) > 1 else 0,
        "settings": settings,
        "parameters": names,
        "names": ", ".join(names),
        "start": [repr(0.0)] * len(settings),
        "rows_of_start": [[repr(float(x)) for x in row] for row in [*rows, *([arm.model.parameters] if names else [])]],
    }


def _one_line(text: str) -> str:
    """Free text from a file as one line of Markdown that is only text."""
    words = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return "".join(f"\\{c}" if c in "\\`*_{}[]<>|#!" else c for c in words) or "not given"


def _reference_values(arm: Description, functions: list[Function], kernels: Sequence[Kernel]) -> dict[str, Any]:
    """Inputs, and for each function its ports with their reference values as literals of C and Python."""
    ports: dict[str, Input] = {}
    for function in functions:
        for port in function.program.inputs:
            ports.setdefault(_sample(functions, port), port)
    generator = random.Random(arm.model.digest)
    samples = []
    doubtful = [f for f in functions if any(output.name == MARGIN for output in f.program.outputs)]

    def one(fixed: Mapping[str, list[float]]) -> dict[str, list[float]]:
        others = {
            n: [round(generator.uniform(*SAMPLED.get(n, (-1.0, 1.0))), 6) for _ in p.symbols] for n, p in ports.items()
        }
        return {name: fixed.get(name, others[name]) for name in ports}

    def margin(sample: Mapping[str, list[float]]) -> Any:
        return min(reference(f, _inputs(functions, f, sample), 15)[MARGIN][0] for f in doubtful)

    for q in _configurations(arm, functions):
        fixed = {"q": q, "parameters": list(arm.model.parameters)}
        # Of some inputs those whose verdicts are clearest: next to a change of verdict a margin is rounding alone.
        samples.append(max((one(fixed) for _ in range(8)), key=margin) if doubtful else one(fixed))
    inputs = [
        {"name": name, "size": len(samples[0][name]), "shape": port.shape, "rows": [_row(s[name]) for s in samples]}
        for name, port in ports.items()
    ]
    views = [
        _function(
            f,
            k,
            identifier(arm.name),
            [_sample(functions, port) for port in f.program.inputs],
            [_inputs(functions, f, sample) for sample in samples],
        )
        for f, k in zip(functions, kernels, strict=True)
    ]
    return {"inputs": inputs, "functions": views}


def _sample(functions: Sequence[Function], port: Input) -> str:
    """What an input's values are called in the test programs: inputs of one name may have several shapes."""
    shapes = list(dict.fromkeys(p.shape for f in functions for p in f.program.inputs if p.name == port.name))
    return port.name if port.shape == shapes[0] else f"{port.name}_{'x'.join(map(str, port.shape))}"


def _inputs(
    functions: Sequence[Function], function: Function, sample: Mapping[str, list[float]]
) -> dict[str, list[float]]:
    """A function's own inputs from a sample of them all."""
    return {port.name: sample[_sample(functions, port)] for port in function.program.inputs}


def _configurations(arm: Description, functions: list[Function]) -> list[list[float]]:
    """Configurations within the limits; of random ones those with the largest H, where errors are only rounding's."""
    generator = random.Random(arm.model.digest)

    def one() -> list[float]:
        found = []
        for joint in arm.joints:
            lower, upper = joint.position or (-3.0, 3.0)
            lower, upper = max(lower, -3.0), min(upper, 3.0)
            found.append(round(generator.uniform(lower, upper) if lower < upper else lower, 6))
        return found

    candidates = [one() for _ in range(8 * COUNT)]
    weights = [f.program for f in functions if f.gradient]
    if not weights:
        return candidates[:COUNT]

    def least(q: list[float]) -> Any:
        values = {"q": q, "parameters": list(arm.model.parameters)}
        return min(manipulability(program, values, 15) for program in weights)

    return sorted(candidates, key=least, reverse=True)[:COUNT]


def _row(entries: Sequence[Any]) -> str:
    return ", ".join(repr(float(entry)) for entry in entries)


def _function(
    function: Function,
    kernel: Kernel,
    unit: str,
    names: Sequence[str],
    samples: Sequence[Mapping[str, Sequence[float]]],
) -> dict[str, Any]:
    """A function as the test programs see it; ``names`` are those of its inputs' values."""
    values = [reference(function, sample, DIGITS) for sample in samples]
    inputs = [{**emit.port_view(port), "sample": name} for port, name in zip(kernel.inputs, names, strict=True)]
    outputs = [
        {
            **emit.port_view(port),
            "rows": [_row(v[port.name]) for v in values],
            "part_of": PARTS.get(port.name, port.name),
            "is_margin": port.name == MARGIN,
            "is_verdict": port.name in VERDICTS,
        }
        for port in kernel.outputs
    ]
    symbol = f"{unit}_{function.name}"
    arguments = [f"(char *){n}" for n in names] + [f"(char *){p['name']}_all" for p in outputs]
    ports = inputs + outputs
    steps = [f"sizeof(double) * {p['size']}" for p in ports]
    for port in ports:
        strides, width = [], 1
        for extent in reversed(port["shape"]):
            strides.append(f"sizeof(double) * {width}")
            width *= extent
        steps += reversed(strides)
    return {
        "name": function.name,
        "symbol": symbol,
        "summary": kernel.summary,
        "operations": kernel.operations,
        "inputs": inputs,
        "outputs": outputs,
        "batch_args": ", ".join(arguments),
        "batch_steps": ", ".join(steps),
        "call": ", ".join([f"{n}[i]" for n in names] + [f"{p['name']}_got" for p in outputs]),
        "callf": ", ".join([f"{p['name']}_f" for p in inputs] + [f"{p['name']}_gotf" for p in outputs]),
    }
