"""The build backend: scikit-build-core's, with generated/ brought up to date first.

A checkout whose derivations, templates or arms were edited asks for the generator's packages (pinned in
derive/requirements.txt) and regenerates before it compiles. An unchanged checkout and a release need none of them:
deciding takes the digests of derive/manifest.py and the standard library. This holds for wheels, editable installs
(PEP 660) and source distributions.
"""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from scikit_build_core import build as _inner
from scikit_build_core.build import prepare_metadata_for_build_editable, prepare_metadata_for_build_wheel

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
    "prepare_metadata_for_build_wheel",
]

_ROOT = Path(__file__).resolve().parents[1]
_Settings = dict[str, Any] | None


def get_requires_for_build_wheel(config_settings: _Settings = None) -> list[str]:
    """What a wheel needs to build; the generator's packages only when generated/ is out of date."""
    return _inner.get_requires_for_build_wheel(config_settings) + _generator_requirements(_ROOT)


def get_requires_for_build_editable(config_settings: _Settings = None) -> list[str]:
    """What an editable install needs to build; the generator's packages only when generated/ is out of date."""
    return _inner.get_requires_for_build_editable(config_settings) + _generator_requirements(_ROOT)


def get_requires_for_build_sdist(config_settings: _Settings = None) -> list[str]:
    """What a source distribution needs to build; the generator's packages only when generated/ is out of date."""
    return _inner.get_requires_for_build_sdist(config_settings) + _generator_requirements(_ROOT)


def build_wheel(wheel_directory: str, config_settings: _Settings = None, metadata_directory: str | None = None) -> str:
    """Build a wheel from an up-to-date generated/."""
    _bring_up_to_date(_ROOT)
    return _inner.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(
    wheel_directory: str, config_settings: _Settings = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel of an editable install from an up-to-date generated/."""
    _bring_up_to_date(_ROOT)
    return _inner.build_editable(wheel_directory, config_settings, metadata_directory)


def build_sdist(sdist_directory: str, config_settings: _Settings = None) -> str:
    """Build a source distribution with an up-to-date generated/."""
    _bring_up_to_date(_ROOT)
    return _inner.build_sdist(sdist_directory, config_settings)


def _generator_requirements(root: Path) -> list[str]:
    """The pinned packages that regenerating needs, or none when there is nothing to regenerate."""
    if not _stale(root):
        return []
    lines = (line.partition("#")[0].strip() for line in (root / "derive/requirements.txt").read_text().splitlines())
    return [line for line in lines if line]


def _bring_up_to_date(root: Path) -> None:
    """Regenerate what edited sources affect, and say what and why."""
    drifts = _stale(root)
    for drift in drifts:
        print(f"chainrule: out of date: {drift.path}: {drift.why}", flush=True)
    if drifts and (not _regenerate(root) or _stale(root)):
        raise SystemExit(
            "chainrule: generated/ is out of date, and regenerating it failed. It needs the packages of "
            "derive/requirements.txt; pip installs them by itself unless build isolation is off."
        )


def _stale(root: Path) -> Sequence[Any]:
    """The generated files that do not match their inputs, each with .path and .why.

    The manifest's module is loaded from its file: chainrule is not installed yet, and its package would load more.
    """
    spec = importlib.util.spec_from_file_location("chainrule_manifest", root / "derive/manifest.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    try:
        spec.loader.exec_module(module)
        stale: Sequence[Any] = module.stale(root)
    finally:
        del sys.modules[spec.name]
    return stale


def _regenerate(root: Path) -> bool:
    """Run the checkout's generator, in a process of its own; whether it succeeded.

    chainrule is not installed yet, so a package made for the moment joins src/chainrule with derive/ under the names
    they install as. It is found by the environment, because the generator's own worker processes must find it too.
    """
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder, "chainrule")
        package.mkdir()
        (package / "__init__.py").write_text(f"__path__ = {[str(root / 'src' / 'chainrule'), str(root)]!r}\n", "utf-8")
        path = os.pathsep.join(filter(None, (folder, os.environ.get("PYTHONPATH"))))
        command = [sys.executable, "-m", "chainrule.derive"]
        return subprocess.run(command, cwd=root, env={**os.environ, "PYTHONPATH": path}, check=False).returncode == 0
