"""From a model to loadable kernels: installed, cached, or derived and compiled now. The one door to ``derive``.

The cache keeps one folder per unit, named by the digest of everything its content depends on. A folder is made under
another name and renamed when whole, so several processes may compile at once; an entry whose contents do not match
its own record, or that somebody else could have written, is not used but made again.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from chainrule.derive import manifest as records
from chainrule.description import Model
from chainrule.errors import GenerationError, shown

Progress = Callable[[str], None]

#: Where compiled kernels of arms that are not embedded are kept (else the platform's cache folder).
CACHE_VARIABLE = "CHAINRULE_CACHE"
#: The C compiler (else ``cc``, ``gcc`` or ``clang``).
COMPILER_VARIABLE = "CC"
#: Best instruction set to use: ``plain``, ``avx2`` or ``avx512`` (else what the processor has).
ISA_VARIABLE = "CHAINRULE_ISA"

#: One derivation at a time in a process: it is Python, and a second one would only delay the first one's compiler.
_DERIVING = threading.Lock()

_ENTRY = 1  # version of the cache entry's layout


class NoCompilerWarning(UserWarning):
    """There is no C compiler: the generated NumPy code is used instead, correct but slower."""


@dataclass(frozen=True)
class Built:
    """Where a unit's code is: its record, the NumPy module, and the shared library if there is one."""

    unit: str
    prefix: str
    functions: dict[str, Any]
    numpy_module: Path
    library: Path | None


def cache_folder() -> Path:
    """Where compiled kernels are kept: ``$CHAINRULE_CACHE``, or ``chainrule`` in the user's cache folder."""
    chosen = os.environ.get(CACHE_VARIABLE)
    if chosen:
        return Path(chosen).expanduser()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")) / "chainrule" / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "chainrule"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "chainrule"


@cache
def instruction_set() -> str:
    """The best instruction set here: ``avx512``, ``avx2`` or ``plain``; ``$CHAINRULE_ISA`` may ask for less.

    Example:
        >>> instruction_set() in ("plain", "avx2", "avx512")
        True
    """
    from chainrule import _gufunc

    order = ("plain", "avx2", "avx512")
    best = str(_gufunc.cpu())
    asked = os.environ.get(ISA_VARIABLE, best)
    if asked not in order:
        raise GenerationError(f"{ISA_VARIABLE}={asked}: plain, avx2 or avx512 is accepted")
    return min(best, asked, key=order.index)


@cache
def _flags() -> dict[str, list[str]]:
    flags: dict[str, list[str]] = json.loads((Path(__file__).parent / "compile_flags.json").read_text("utf-8"))
    return flags


def compiler() -> list[str] | None:
    """The C compiler's command, or None where there is none."""
    chosen = os.environ.get(COMPILER_VARIABLE)
    if chosen:
        words = chosen.split()
        return words if shutil.which(words[0]) else None
    return next(([name] for name in ("cc", "gcc", "clang") if shutil.which(name)), None)


@cache
def _generated() -> tuple[records.Places, dict[str, Any]]:
    places = records.Places.here()
    return places, records.read(places.generated)


def find(model: Model, group: str, progress: Progress = lambda line: None) -> Built:
    """The code of one group of a model: installed, from the cache, or derived and compiled now.

    Raises:
        GenerationError: if the derivation or the compilation fails.
    """
    return _installed(model, group) or _cached(model, group) or _make(model, group, progress)


def _installed(model: Model, group: str) -> Built | None:
    """The embedded arms' code; its library only if it was compiled from exactly this text."""
    places, manifest = _generated()
    unit = manifest["units"].get(f"{model.name}_{group}")
    if unit is None or unit["models"] != [model.digest]:
        return None
    name = f"{model.name}_{group}"
    library = _installed_library(model.name)
    if library is None or _library_digest(library, name) != unit["digest"]:
        return None
    return Built(name, model.name, unit["functions"], places.generated / model.name / f"{name}.py", library)


@cache
def _installed_library(model: str) -> Path | None:
    """The best of the installed libraries of a model that this processor can run."""
    from chainrule import _gufunc

    folder = Path(_gufunc.__file__).parent / "_kernels"
    order = ("plain", "avx2", "avx512")
    candidates = order[: order.index(instruction_set()) + 1][::-1]
    return next((path for isa in candidates if (path := folder / f"{model}.{isa}.so").is_file()), None)


def _library_digest(library: Path, unit: str) -> str | None:
    import ctypes

    try:
        text = (ctypes.c_char * 65).in_dll(ctypes.CDLL(str(library)), f"{unit}_digest")
    except (OSError, ValueError):
        return None
    return bytes(text.value).decode("ascii", "replace")


@cache
def _generator_digest() -> str:
    """Digest of everything that turns a model into code: the cache is keyed by it."""
    places, _ = _generated()
    folders = ((places.derive, "*.py"), (places.templates, "*.j2"))
    files = sorted(path for folder, pattern in folders for path in folder.glob(pattern))
    flags = Path(__file__).parent / "compile_flags.json"
    total = hashlib.sha256(b"".join(records.digest_of(path.read_bytes()).encode() for path in [*files, flags]))
    return total.hexdigest()


def _key(model: Model, group: str) -> str:
    parts = (str(_ENTRY), _generator_digest(), model.digest, model.name, group, instruction_set(), sys.platform)
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:40]


def _cached(model: Model, group: str) -> Built | None:
    folder = cache_folder() / _key(model, group)
    return _entry(folder, model, group) if folder.is_dir() else None


def _entry(folder: Path, model: Model, group: str) -> Built | None:
    """A cache entry, if nobody else could have written it and all of it is as it was made."""
    try:
        entry = folder / "entry.json"
        written = json.loads(entry.read_text("utf-8"))
        record = written["record"]
        if written["digest"] != _digest_of_record(record) or not _ours(folder) or not _ours(entry):
            return None
        if record["model"] != model.digest or record["group"] != group:
            return None
        for name, digest in record["files"].items():
            path = folder / name
            if path.parent != folder or not _ours(path):
                return None
            if hashlib.sha256(path.read_bytes()).hexdigest() != digest:
                return None
        name = f"{model.name}_{group}"
        library = folder / record["library"] if record["library"] else None
        if library is not None and library.name not in record["files"]:
            return None
        if library is None and compiler() is not None:
            return None  # made where there was no compiler: now there is one
        return Built(name, model.name, record["functions"], folder / f"{name}.py", library)
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def _digest_of_record(record: Any) -> str:
    return hashlib.sha256(json.dumps(record, sort_keys=True).encode()).hexdigest()


def _ours(path: Path) -> bool:
    """Whether the file is this user's and nobody else may write it."""
    if os.name != "posix":
        return True
    status = path.stat()
    return status.st_uid == os.getuid() and not status.st_mode & 0o022


def _make(model: Model, group: str, progress: Progress) -> Built:
    """Derive, write and compile a unit into the cache."""
    name = f"{model.name}_{group}"
    with _DERIVING:
        files, functions = _sources(model, group, progress)
    root = cache_folder()
    try:
        root.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(dir=root, prefix=".making-"))
    except OSError as error:
        raise GenerationError(
            f"the cache folder {root} cannot be written ({error.strerror}); set {CACHE_VARIABLE}"
        ) from None
    try:
        work.chmod(0o700)
        for file, text in files.items():
            (work / file).write_text(text, "utf-8", newline="\n")
        progress(f"compiling {name}")
        library = compile_unit(work, name)
        contents = {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in work.iterdir() if p.suffix != ".o"}
        for leftover in work.glob("*.o"):
            leftover.unlink()
        record = {
            "model": model.digest,
            "group": group,
            "files": contents,
            "functions": functions,
            "library": library.name if library else None,
        }
        written = {"record": record, "digest": _digest_of_record(record)}
        (work / "entry.json").write_text(json.dumps(written), "utf-8")
        for path in work.iterdir():
            path.chmod(0o600)
        return _publish(work, root / _key(model, group), model, group)
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _publish(work: Path, final: Path, model: Model, group: str) -> Built:
    """Rename a whole entry to its place; where a good one has appeared meanwhile, that one is used."""
    for _ in range(3):
        try:
            work.rename(final)
        except OSError:
            if (found := _entry(final, model, group)) is not None:
                return found
            # A broken or foreign entry: move it out of the way, whole, and try again.
            aside = Path(tempfile.mkdtemp(dir=final.parent, prefix=".broken-"))
            try:
                final.rename(aside / "entry")
            except FileNotFoundError:
                pass
            except OSError as error:
                raise GenerationError(
                    f"the cache entry {final} is not usable and cannot be replaced ({error.strerror})"
                ) from None
            finally:
                shutil.rmtree(aside, ignore_errors=True)
            continue
        found = _entry(final, model, group)
        if found is not None:
            return found
    raise GenerationError(f"the cache entry {final} cannot be made; set {CACHE_VARIABLE} to a folder of your own")


def _sources(model: Model, group: str, progress: Progress) -> tuple[dict[str, str], dict[str, Any]]:
    """The files of a unit, derived now, all for one folder; and the record of its functions."""
    places, _ = _generated()
    progress(f"deriving {model.name}_{group}")
    from chainrule.derive import write

    unit = write.make_unit(places, model, (group,), shared="")
    return {**unit.files, **write.headers(places)}, unit.record["functions"]


@cache
def casadi_function(model: Model, group: str, name: str, outputs: tuple[str, ...]) -> Any:
    """Some outputs of a generated function as a ``casadi.Function``, which CasADi can differentiate again.

    Its inputs are those of the generated function that these outputs depend on, under the same names.

    Raises:
        GenerationError: there is no such function or output.
    """
    with _DERIVING:
        from chainrule.derive import catalogue, graph

        for function in catalogue.functions(model, group):
            if function.name == name:
                return graph.casadi_function(function, outputs)
    raise GenerationError(f"{model.name}: there is no function '{name}' in the group '{group}'")


def compile_unit(folder: Path, name: str) -> Path | None:
    """Compile ``<name>.c`` for double and float, at the same time, and link one library; None without a compiler.

    Raises:
        GenerationError: if the compiler refuses the code, with its first line.
    """
    command = compiler()
    if command is None:
        chosen = os.environ.get(COMPILER_VARIABLE)
        told = f"{COMPILER_VARIABLE} is {shown(chosen)}" if chosen else f"set {COMPILER_VARIABLE}"
        warnings.warn(
            f"no C compiler was found ({told}): using the generated NumPy code, which is slower",
            NoCompilerWarning,
            stacklevel=2,
        )
        return None
    flags = ["-std=c99", "-fPIC", *_flags()["common"], *_flags()["first_use"], *_flags()[instruction_set()]]
    library = folder / f"{name}.so"
    jobs = []
    for kind, define in (("double", []), ("float", ["-DCHAINRULE_FLOAT"])):
        target = folder / f"{name}.{kind}.o"
        jobs.append(
            (
                target,
                subprocess.Popen(
                    [*command, *flags, *define, "-c", str(folder / f"{name}.c"), "-o", str(target)],
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    text=True,
                ),
            )
        )
    errors = [process.communicate()[1] for _, process in jobs]
    for (_, process), error in zip(jobs, errors, strict=True):
        if process.returncode != 0:
            raise GenerationError(_compiler_said(command, error))
    link = subprocess.run(
        [*command, "-shared", *(str(target) for target, _ in jobs), "-o", str(library), "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    if link.returncode != 0:
        raise GenerationError(_compiler_said(command, link.stderr))
    return library


def _compiler_said(command: list[str], errors: str) -> str:
    first = next(
        (line for line in errors.splitlines() if "error" in line),
        errors.strip().splitlines()[0] if errors.strip() else "no message",
    )
    return f"the C compiler '{command[0]}' failed: {first.strip()}"
