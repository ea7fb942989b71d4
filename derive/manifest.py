"""What was generated from what: digests, drift, and where things are. Standard library only, so it is quick.

``generated/manifest.json`` records for every unit (the files of one group of one model) the digest of its inputs, the
inputs themselves, the digests of its files, and the functions it holds. Inputs are named as in the checkout
(``derive/chain.py``, ``templates/kernel.c.j2``, ``src/chainrule/description.py``) wherever they are installed.
"""

from __future__ import annotations

import ast
import contextlib
import hashlib
import json
import os
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

SCHEMA = 1

#: What every unit depends on besides the modules of its formulas: the pipeline and the templates.
PIPELINE = (
    "chainrule.derive.program",
    "chainrule.derive.catalogue",
    "chainrule.derive.lower",
    "chainrule.derive.listing",
    "chainrule.derive.emit",
    "chainrule.derive.write",
)
UNIT_TEMPLATES = ("templates/kernel.c.j2", "templates/kernel.h.j2", "templates/kernel.inc.j2", "templates/kernel.py.j2")
#: And a unit that follows curves besides: its compiled code is that of the shared header.
CURVE_TEMPLATES = ("derive/lobatto.py", "templates/continuation.h.j2")
SHARED_INPUTS = (
    "derive/lobatto.py",
    "derive/sincos.py",
    "templates/batch.h.j2",
    "templates/continuation.h.j2",
    "templates/real.h.j2",
    "templates/sincos.h.j2",
)
REQUIREMENTS = "derive/requirements.txt"


@dataclass(frozen=True)
class Places:
    """Where the parts are: the runtime package, ``derive``, ``templates`` and ``generated``."""

    package: Path
    derive: Path
    templates: Path
    generated: Path

    @staticmethod
    def checkout(root: Path) -> Places:
        """The places in a checkout."""
        return Places(root / "src" / "chainrule", root / "derive", root / "templates", root / "generated")

    @staticmethod
    def here() -> Places:
        """The places of this installation: a checkout, an editable install or an installed package."""
        derive = Path(__file__).resolve().parent
        checkout = Places.checkout(derive.parent)
        installed = Places(derive.parent, derive, derive.parent / "templates", derive.parent / "generated")
        return checkout if checkout.package.is_dir() else installed

    def locate(self, name: str) -> Path:
        """The file that an input's name stands for."""
        for prefix, folder in (
            ("derive/", self.derive),
            ("templates/", self.templates),
            ("src/chainrule/", self.package),
        ):
            if name.startswith(prefix):
                return folder / name.removeprefix(prefix)
        raise ValueError(f"{name} is not a part of chainrule")


@dataclass(frozen=True)
class Drift:
    """A generated file that does not belong to its inputs, and why."""

    path: str
    why: str

    def __str__(self) -> str:
        return f"{self.path}: {self.why}"


def digest_of(content: bytes) -> str:
    """SHA-256, with line endings made alike."""
    return hashlib.sha256(content.replace(b"\r\n", b"\n")).hexdigest()


def digest_of_inputs(places: Places, names: Iterable[str], *extra: str) -> str:
    """One digest of the named inputs' contents and of further texts (a model's digest)."""
    total = hashlib.sha256()
    for name in sorted(names):
        path = places.locate(name)
        total.update(f"{name} {digest_of(path.read_bytes()) if path.is_file() else 'missing'}\n".encode())
    for text in extra:
        total.update(f"{text}\n".encode())
    return total.hexdigest()


def imported(places: Places, modules: Iterable[str]) -> tuple[str, ...]:
    """The named modules and every chainrule module they import, however indirectly, as names of inputs."""
    found: dict[str, None] = {}
    waiting = list(modules)
    while waiting:
        name = _module_file(places, waiting.pop())
        if name is None or name in found:
            continue
        found[name] = None
        for node in ast.walk(ast.parse(places.locate(name).read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
                waiting += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
            elif isinstance(node, ast.Import):
                waiting += [alias.name for alias in node.names]
    return tuple(sorted(found))


def imported_directly(places: Places, module: str) -> tuple[str, ...]:
    """One module's own file."""
    name = _module_file(places, module)
    return (name,) if name else ()


def _module_file(places: Places, module: str) -> str | None:
    parts = module.split(".")
    if parts[0] != "chainrule" or len(parts) < 2:
        return None
    stem = "/".join(parts if parts[1] != "derive" else parts[1:]).replace("chainrule", "src/chainrule", 1)
    for name in (f"{stem}.py", f"{stem}/__init__.py"):
        if "/" in name and places.locate(name).is_file():
            return name
    return None


def read(generated: Path) -> dict[str, Any]:
    """The manifest, or an empty one where there is none or it is not ours."""
    manifest: Any = {}
    with contextlib.suppress(OSError, ValueError):
        manifest = json.loads((generated / "manifest.json").read_text("utf-8"))
    parts = ("arms", "shared", "units")
    ours = isinstance(manifest, dict) and manifest.get("schema") == SCHEMA
    if not ours or not all(isinstance(manifest.get(part), dict) for part in parts):
        return {"schema": SCHEMA} | {part: {} for part in parts}
    found: dict[str, Any] = manifest
    return found


@contextlib.contextmanager
def whole_file(path: Path) -> Iterator[IO[bytes]]:
    """A stream to write a file through, so that at every moment either the old file or the whole new one is there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def write_whole(path: Path, content: str | bytes) -> None:
    """Write a file so that at every moment either the old one or the new one is there."""
    with whole_file(path) as stream:
        stream.write(content.encode("utf-8") if isinstance(content, str) else content)


def as_text(manifest: Mapping[str, Any]) -> str:
    """A manifest as stable text."""
    return json.dumps(manifest, indent=1, sort_keys=True) + "\n"


def stale_units(places: Places, manifest: Mapping[str, Any]) -> dict[str, str]:
    """Units (and ``shared``) whose recorded inputs or files do not match what is there, with the reason."""
    found = {}
    for name, unit in {"shared": manifest["shared"], **manifest["units"]}.items():
        if not unit:
            found[name] = "it was never generated"
        elif digest_of_inputs(places, unit["inputs"], *unit["models"]) != unit["digest"]:
            found[name] = "its derivation, template or arm was edited after it was generated"
        else:
            for file, digest in unit["files"].items():
                path = places.generated / file
                if not path.is_file():
                    found[name] = f"{file} is missing"
                elif digest_of(path.read_bytes()) != digest:
                    found[name] = f"{file} was edited by hand"
    return found


def stale_arms(places: Places, manifest: Mapping[str, Any]) -> dict[str, str]:
    """Arm files that are new, edited or gone since the last generation, with the reason."""
    recorded = manifest["arms"]
    present = {path.name: digest_of(path.read_bytes()) for path in sorted((places.package / "arms").glob("*.toml"))}
    found = {name: "this arm was removed" for name in recorded if name not in present}
    for name, digest in present.items():
        if name not in recorded:
            found[name] = "this arm is new"
        elif recorded[name]["file"] != digest and _model_digest(places, name) != recorded[name]["model"]:
            found[name] = "this arm's geometry was edited"
    return found


def _model_digest(places: Places, arm: str) -> str | None:
    """The digest of an arm's model; limits and inertias are not part of it. None where it cannot be told."""
    try:
        from chainrule.readers import read as read_arm
    except ImportError:  # a build environment without the package: better to regenerate once too often
        return None
    return read_arm(places.package / "arms" / arm).model.digest


def stray_files(places: Places, manifest: Mapping[str, Any]) -> list[str]:
    """Files in ``generated/`` that nothing generates."""
    known = {"manifest.json", "__init__.py", *manifest["shared"].get("files", {})}
    for unit in manifest["units"].values():
        known |= set(unit["files"])
    return sorted(
        name
        for path in places.generated.rglob("*")
        if path.is_file()
        and "__pycache__" not in path.parts
        and (name := path.relative_to(places.generated).as_posix()) not in known
    )


def stale(root: Path) -> list[Drift]:
    """Everything in a checkout's ``generated/`` that does not match its inputs: what a build must regenerate."""
    return drift(Places.checkout(root))


def drift(places: Places) -> list[Drift]:
    """As :func:`stale`, for any installation."""
    manifest = read(places.generated)
    found = [Drift(f"src/chainrule/arms/{name}", why) for name, why in stale_arms(places, manifest).items()]
    for name, why in stale_units(places, manifest).items():
        files = manifest["units"].get(name, manifest["shared"]).get("files") or {name: ""}
        found += [Drift(f"generated/{file}", why) for file in files]
    return found + [Drift(f"generated/{name}", "nothing generates this file") for name in stray_files(places, manifest)]


def pins(places: Places) -> dict[str, str]:
    """The generator's pinned packages and versions."""
    lines = places.locate(REQUIREMENTS).read_text("utf-8").splitlines()
    pairs = (line.split("==", 1) for line in lines if "==" in line and not line.startswith("#"))
    return {name.strip().lower(): version.strip() for name, version in pairs}
