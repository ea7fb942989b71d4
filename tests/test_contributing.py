"""The worked example of CONTRIBUTING.md, carried out on a copy of the checkout."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]


def code_blocks() -> list[str]:
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    section = text.split("## Adding a derivation")[1].split("\n## ")[0]
    return [textwrap.dedent(block) for block in re.findall(r"^ *```python\n(.*?)^ *```", section, re.S | re.M)]


def test_the_worked_example_adds_a_derivation(tmp_path: Path) -> None:
    function, line, test = code_blocks()
    root = tmp_path / "checkout"
    for part in ("derive", "templates", "src"):
        shutil.copytree(ROOT / part, root / part, ignore=shutil.ignore_patterns("__pycache__", "*.so", "_kernels"))
    for arm in (root / "src/chainrule/arms").glob("*.toml"):
        if arm.stem != "planar_3r":
            arm.unlink()
    (root / "generated").mkdir()
    planar = root / "derive/planar.py"
    planar.write_text(planar.read_text("utf-8") + "\n\n" + function, "utf-8")
    catalogue = root / "derive/catalogue.py"
    before = catalogue.read_text("utf-8")
    after = before.replace(
        "CATALOGUE: tuple[Entry, ...] = (\n", "CATALOGUE: tuple[Entry, ...] = (\n    " + line.strip() + "\n"
    )
    assert after != before
    catalogue.write_text(after, "utf-8")
    # Its own package, made of the copied folders under the names they install as.
    package = tmp_path / "path/chainrule"
    package.mkdir(parents=True)
    paths = [str(root / "src/chainrule"), str(root)]
    (package / "__init__.py").write_text(f"__path__ = {paths!r}\n", "utf-8")
    environment = {"PYTHONPATH": str(package.parent), "PATH": "/usr/bin:/bin"}
    run = [sys.executable, "-m", "chainrule.derive", "--workers", "1"]
    made = subprocess.run(run, env=environment, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    assert "planar_rrr_heading_batch" in (root / "generated/planar_rrr/planar_rrr_kinematics.c").read_text("utf-8")
    # The example's own test, on the generated NumPy code.
    stand_in = f"""
import importlib.util, types
import numpy as np
spec = importlib.util.spec_from_file_location("code", {str(root / "generated/planar_rrr/planar_rrr_kinematics.py")!r})
code = importlib.util.module_from_spec(spec)
spec.loader.exec_module(code)
arm = types.SimpleNamespace(evaluator=lambda name: getattr(code, name), parameters=np.array([1.0, 0.5, 0.25]))
cr = types.SimpleNamespace(load=lambda name: arm)
"""
    script = tmp_path / "example.py"
    script.write_text(stand_in + test + "\n\ntest_heading_is_the_direction_of_the_last_link()\n", "utf-8")
    ran = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr


PAGES = [
    path for path in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))) if ">>>" in path.read_text("utf-8")
]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_the_examples_of_a_page_print_what_they_say(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page is read from top to bottom: a later example knows what an earlier one made."""
    import doctest

    monkeypatch.chdir(tmp_path)  # an example may write files
    known: dict[str, object] = {}
    for number, block in enumerate(re.findall(r"^```python\n(.*?)^```", page.read_text("utf-8"), re.S | re.M)):
        parsed = doctest.DocTestParser().get_doctest(block, known, f"{page.name} block {number}", page.name, 0)
        runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
        runner.run(parsed, clear_globs=False)
        known |= parsed.globs
        assert runner.failures == 0


def test_the_readme_shows_python() -> None:
    assert PAGES[0].name == "README.md"


@pytest.mark.parametrize("name", ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff", "LICENSE"])
def test_the_repository_files_are_there(name: str) -> None:
    assert (ROOT / name).read_text("utf-8").strip()
