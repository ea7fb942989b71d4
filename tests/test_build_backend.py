"""The build backend: regenerates what edited sources affect, and asks for the generator only then."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import tarfile
from pathlib import Path
from types import ModuleType

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
HOOKS = ("get_requires_for_build_wheel", "get_requires_for_build_editable", "get_requires_for_build_sdist")

MANIFEST = """
from dataclasses import dataclass

@dataclass(frozen=True)
class Drift:
    path: str
    why: str

def stale(root):
    made = root / "generated" / "arm.c"
    if made.exists() and made.read_text() == (root / "templates" / "arm.c.j2").read_text():
        return []
    return [Drift("generated/arm.c", "templates/arm.c.j2 was edited")]
"""

GENERATOR = """
import multiprocessing
from pathlib import Path
from chainrule.derive.write import write
from chainrule.readers import read

if __name__ == "__main__":
    root = Path(__file__).parents[1]
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        pool.apply(write, (root / "generated" / "arm.c", read(root / "templates" / "arm.c.j2")))
"""


@pytest.fixture
def tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout in small: the real backend and pyproject.toml, one template, and what was generated from it."""
    kept = ("pyproject.toml", "README.md", "LICENSE", "build_backend/chainrule_build.py", "derive/requirements.txt")
    for name, text in {
        **{name: (CHECKOUT / name).read_text(encoding="utf-8") for name in kept},
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.20)\n",
        "src/chainrule/__init__.py": "",
        "derive/__init__.py": "",
        "derive/manifest.py": MANIFEST,
        "derive/__main__.py": GENERATOR,
        "derive/write.py": "def write(path, text):\n    path.write_text(text)\n",
        "src/chainrule/readers.py": "def read(path):\n    return path.read_text()\n",
        "templates/arm.c.j2": "int joints = 3;\n",
        "generated/arm.c": "int joints = 3;\n",
    }.items():
        target = tmp_path / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def backend_of(tree: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("backend_under_test", tree / "build_backend" / "chainrule_build.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def edit_template(tree: Path) -> None:
    (tree / "templates" / "arm.c.j2").write_text("int joints = 7;\n")


def pins(tree: Path) -> list[str]:
    return [line for line in (tree / "derive" / "requirements.txt").read_text().splitlines() if "==" in line]


def in_sdist(tree: Path, name: str) -> str:
    (archive,) = (tree / "out").glob("*.tar.gz")
    with tarfile.open(archive) as tar:
        member = tar.extractfile(f"{archive.name.removesuffix('.tar.gz')}/{name}")
        assert member is not None
        return member.read().decode()


def test_the_generator_is_pinned_exactly() -> None:
    named = {pin.partition("==")[0].strip().lower() for pin in pins(CHECKOUT)}
    assert {"sympy", "casadi", "jinja2"} <= named


@pytest.mark.parametrize("hook", HOOKS)
def test_an_unchanged_tree_asks_for_no_generator(tree: Path, hook: str) -> None:
    asked = getattr(backend_of(tree), hook)()
    assert not set(asked) & set(pins(tree))


@pytest.mark.parametrize("hook", HOOKS)
def test_an_edited_tree_asks_for_the_pinned_generator(tree: Path, hook: str) -> None:
    before = getattr(backend_of(tree), hook)()
    edit_template(tree)
    asked = getattr(backend_of(tree), hook)()
    assert set(asked) - set(before) == set(pins(tree))


def test_an_unchanged_tree_builds_without_running_the_generator(tree: Path) -> None:
    (tree / "derive" / "__main__.py").write_text("raise SystemExit('the generator ran')\n")
    backend_of(tree).build_sdist(str(tree / "out"))
    assert in_sdist(tree, "generated/arm.c") == "int joints = 3;\n"


def test_an_edited_tree_is_regenerated_before_it_is_built(tree: Path, capfd: pytest.CaptureFixture[str]) -> None:
    edit_template(tree)
    backend_of(tree).build_sdist(str(tree / "out"))
    assert in_sdist(tree, "generated/arm.c") == "int joints = 7;\n"
    assert "out of date: generated/arm.c: templates/arm.c.j2 was edited" in capfd.readouterr().out


BROKEN = {"fails": "import a_package_that_is_not_there\n", "writes nothing": ""}


@pytest.mark.parametrize("hook", ["build_wheel", "build_editable", "build_sdist"])
@pytest.mark.parametrize("generator", BROKEN.values(), ids=BROKEN)
def test_a_failing_generator_stops_the_build(tree: Path, hook: str, generator: str) -> None:
    edit_template(tree)
    (tree / "derive" / "__main__.py").write_text(generator)
    with pytest.raises(SystemExit, match=r"derive/requirements\.txt"):
        getattr(backend_of(tree), hook)(str(tree / "out"))
    assert not list(tree.glob("out/*"))


def test_this_checkout_builds_without_the_generator() -> None:
    """Where SymPy, CasADi and Jinja cannot be imported, the hooks of this checkout still answer, and ask for none."""
    code = (
        "import sys; sys.modules.update(dict.fromkeys(('sympy', 'casadi', 'jinja2', 'chainrule')));"
        "sys.path.insert(0, 'build_backend'); import chainrule_build as backend;"
        f"print([backend.{HOOKS[0]}(), backend.{HOOKS[1]}(), backend.{HOOKS[2]}()])"
    )
    result = subprocess.run([sys.executable, "-c", code], cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert not any(pin in result.stdout for pin in pins(CHECKOUT)), result.stdout
