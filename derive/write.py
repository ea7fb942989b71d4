"""Makes the files of a unit (one group of one model) and keeps ``generated/`` in step with its inputs."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from functools import partial
from typing import Any

from chainrule.derive import manifest as records
from chainrule.derive.manifest import Places
from chainrule.description import Description, Model

Progress = Callable[[str], None]


@dataclass(frozen=True)
class Unit:
    """The files of one group (or several) of a model, by name, and the record that describes them."""

    name: str
    files: dict[str, str]
    record: dict[str, Any]
    kernels: tuple[Any, ...] = ()


def inputs_of(places: Places, model: Model, groups: Iterable[str]) -> tuple[str, ...]:
    """Every file of ours that the unit's content depends on."""
    from chainrule.derive import catalogue

    modules = {module.__name__ for group in groups for module in catalogue.sources(model, group)}
    formulas = records.imported(places, modules)
    # The catalogue imports every derivation; only the ones that this unit uses count.
    pipeline = [name for module in records.PIPELINE for name in records.imported_directly(places, module)]
    followed = records.CURVE_TEMPLATES if any(catalogue.curve(model, group) for group in groups) else ()
    return tuple(sorted({*formulas, *pipeline, *records.UNIT_TEMPLATES, *followed}))


def make_unit(
    places: Places,
    model: Model,
    groups: Sequence[str],
    name: str | None = None,
    prefix: str | None = None,
    shared: str = "../",
) -> Unit:
    """Derive, lower and write (as text) the given groups of a model.

    Args:
        places: where the inputs are, for the digest.
        model: the arm's structure.
        groups: which groups of the catalogue.
        name: the unit's name, ``<model>_<group>`` by default.
        prefix: what its C symbols begin with, the model's name by default.
        shared: where the shared headers are, relative to the unit's files.
    """
    from chainrule.derive import catalogue, emit
    from chainrule.derive.lower import lower

    inputs = inputs_of(places, model, groups)
    digest = records.digest_of_inputs(places, inputs, model.digest)
    name = name or f"{model.name}_{groups[0]}"
    kernels = [lower(function) for group in groups for function in catalogue.functions(model, group)]
    tasks = catalogue.FAMILIES[model.family][1]
    words = [f"manipulability ({group})" if group in tasks else group.replace("_", " ") for group in groups]
    title = f"{' and '.join(words)} of {prefix or model.name}"
    curves = [curve for group in groups if (curve := catalogue.curve(model, group)) is not None]
    files = emit.unit(name, prefix or model.name, title, kernels, digest, shared, curves)
    functions = {
        kernel.name: {
            "summary": kernel.summary,
            "operations": kernel.operations,
            "inputs": [[port.name, list(port.shape)] for port in kernel.inputs],
            "outputs": [[port.name, list(port.shape)] for port in kernel.outputs],
        }
        for kernel in kernels
    }
    record: dict[str, Any] = {
        "model": model.name,
        "groups": list(groups),
        "models": [model.digest],
        "inputs": list(inputs),
        "digest": digest,
        "functions": functions,
    }
    return Unit(name, files, record, tuple(kernels))


def embedded(places: Places) -> dict[str, Description]:
    """The embedded arms, by file name."""
    from chainrule.readers import read

    return {path.name: read(path) for path in sorted((places.package / "arms").glob("*.toml"))}


def planned(arms: Iterable[Description]) -> dict[str, tuple[Model, str]]:
    """The units that the given arms need, and the standing ones: model and group by unit name.

    Arms of one family share their units. Groups made on first use are there where :data:`catalogue.SHIPPED` says.
    """
    from chainrule.derive import catalogue

    models: dict[str, Model] = {}
    for arm in arms:
        known = models.setdefault(arm.model.name, arm.model)
        if known.digest != arm.model.digest:
            raise ValueError(f"two embedded arms share the identifier {arm.model.name} but differ in geometry")
    found = {f"{m.name}_{group}": (m, group) for m, groups in catalogue.STANDING.items() for group in groups}
    return found | {f"{m.name}_{group}": (m, group) for m in models.values() for group in catalogue.generated(m)}


def headers(places: Places) -> dict[str, str]:
    """The headers every unit shares: as generated where that is current (deriving the sine takes a second)."""
    shared = records.read(places.generated)["shared"]
    if shared and "shared" not in records.stale_units(places, {"shared": shared, "units": {}}):
        return {name: (places.generated / name).read_text("utf-8") for name in shared["files"]}
    from chainrule.derive import emit

    return emit.shared_headers()


def _made(places: Places, model: Model, group: str) -> Unit:
    return make_unit(places, model, (group,))


def regenerate(places: Places, progress: Progress = lambda line: None, workers: int | None = None) -> list[str]:
    """Bring ``generated/`` up to date; returns the names of the units that were written.

    Files are written whole, the manifest last: whenever this is interrupted, the next run sees what is missing.
    """
    manifest = records.read(places.generated)
    arms = stale = None
    if not records.drift(places):
        return []
    arms = embedded(places)
    units = planned(arms.values())
    stale = records.stale_units(places, manifest)
    wanted = [
        name
        for name, (model, _) in units.items()
        if name in stale or name not in manifest["units"] or manifest["units"][name]["models"] != [model.digest]
    ]
    written = []
    if "shared" in stale:
        _write_shared(places, manifest)
        written.append("shared")
    with ProcessPoolExecutor(workers) as pool:
        waiting = {pool.submit(partial(_made, places, *units[name])): name for name in wanted}
        for done in as_completed(waiting):
            unit = done.result()
            _write_unit(places, manifest, unit)
            written.append(unit.name)
            progress(f"{unit.name}: {sum(f['operations'] for f in unit.record['functions'].values())} operations")
    for name in [name for name in manifest["units"] if name not in units]:
        del manifest["units"][name]
    manifest["arms"] = {
        name: {
            "file": records.digest_of((places.package / "arms" / name).read_bytes()),
            "model": arm.model.digest,
            "name": arm.model.name,
        }
        for name, arm in arms.items()
    }
    records.write_whole(places.generated / "manifest.json", records.as_text(manifest))
    for name in records.stray_files(places, manifest):
        (places.generated / name).unlink()
    return sorted(written)


def _write_unit(places: Places, manifest: dict[str, Any], unit: Unit) -> None:
    folder = unit.record["model"]
    for name, text in unit.files.items():
        records.write_whole(places.generated / folder / name, text)
    digests = {f"{folder}/{name}": records.digest_of(text.encode()) for name, text in unit.files.items()}
    manifest["units"][unit.name] = {**unit.record, "files": digests}


def _write_shared(places: Places, manifest: dict[str, Any]) -> None:
    from chainrule.derive import emit

    headers = emit.shared_headers()
    for name, text in headers.items():
        records.write_whole(places.generated / name, text)
    inputs = [*records.SHARED_INPUTS, "derive/emit.py"]
    manifest["shared"] = {
        "inputs": inputs,
        "models": [],
        "digest": records.digest_of_inputs(places, inputs),
        "files": {name: records.digest_of(text.encode()) for name, text in headers.items()},
    }


def differences(
    places: Places, progress: Progress = lambda line: None, workers: int | None = None
) -> list[records.Drift]:
    """Derive everything again, in memory, and compare byte by byte with what is there: the thorough check."""
    from chainrule.derive import emit

    found = []
    expected: dict[str, str] = dict(emit.shared_headers())
    with ProcessPoolExecutor(workers) as pool:
        units = planned(embedded(places).values())
        waiting = {pool.submit(partial(_made, places, *spec)): name for name, spec in units.items()}
        for done in as_completed(waiting):
            unit = done.result()
            expected |= {f"{unit.record['model']}/{name}": text for name, text in unit.files.items()}
            progress(unit.name)
    for name, text in sorted(expected.items()):
        path = places.generated / name
        if not path.is_file():
            found.append(records.Drift(f"generated/{name}", "it is missing"))
        elif path.read_bytes().replace(b"\r\n", b"\n") != text.encode():
            found.append(records.Drift(f"generated/{name}", "deriving it again gives other bytes"))
    return found


def version_notes(places: Places) -> list[str]:
    """One line for each generator package whose installed version is not the pinned one."""
    from importlib.metadata import PackageNotFoundError, version

    notes = []
    for name, pinned in records.pins(places).items():
        try:
            installed = version(name)
        except PackageNotFoundError:
            installed = "none"
        if installed != pinned:
            notes.append(
                f"{name} {installed} is installed; generated/ is written with {name} {pinned}, "
                "and other versions may write other bytes"
            )
    return notes


def main(arguments: Sequence[str] | None = None) -> int:
    """``python -m chainrule.derive``: rebuild what is stale; ``--check`` only says; ``--verify`` derives all again."""
    import argparse

    parser = argparse.ArgumentParser(prog="python -m chainrule.derive", description=main.__doc__)
    parser.add_argument("--check", action="store_true", help="fail if generated/ does not match its inputs' digests")
    parser.add_argument("--verify", action="store_true", help="derive everything again and compare byte by byte")
    parser.add_argument("--workers", type=int, default=None, help="parallel processes (default: one per core)")
    options = parser.parse_args(arguments)
    places = Places.here()
    say = partial(print, flush=True)
    if options.check or options.verify:
        found = records.drift(places)
        if options.verify:
            for note in version_notes(places):
                say(f"note: {note}")
            found += differences(places, say, options.workers)
        for drift in found:
            print(drift, file=sys.stderr)
        say("generated/ matches its inputs" if not found else "generated/ has drifted: run python -m chainrule.derive")
        return 1 if found else 0
    for name in regenerate(places, say, options.workers) or ["nothing: generated/ matches its inputs"]:
        say(f"wrote {name}" if "nothing" not in name else name)
    return 0
