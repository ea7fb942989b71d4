"""The examples run, say what is known otherwise, and draw; the lectures' cells run in their order."""

from __future__ import annotations

import json
import runpy
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ROOT / "examples"

#: What each program must say: facts of the papers, and counts that other tests establish.
SAYS = {
    "cuspidality": ["4 cusps, cuspidal: True", "proved True"],  # Baili's figure 2 (a)
    "generated_c": ["400 tips from C"],
    "manipulability": ["H = 0.7955370838", "proved: True"],  # De Luca's 0.79, off his grid
    "track": ["pseudoinverse: complete, H at least 0.0016", "gradient projection: complete, H at least 0.019"],
    "minimum_time": ["[1.75 1.5 ]", "the only fastest motion: False"],  # De Luca's T' and T''
    "self_motion": ["8 closed curves (none missing: proved)"],
    "speed_ratios": ["pseudoinverse: ", "look_ahead: "],
    "workspace": ["7 pieces"],
}


def test_every_example_is_listed() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.py")} == set(SAYS)
    listed = (EXAMPLES / "README.md").read_text("utf-8")
    assert all(f"`{path.name}`" in listed for path in EXAMPLES.iterdir() if path.suffix in (".py", ".ipynb"))


@pytest.mark.parametrize("name", SAYS)
def test_an_example_runs_and_draws(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", [f"{name}.py", "drawn.svg"])
    runpy.run_path(str(EXAMPLES / f"{name}.py"), run_name="__main__")
    said = capsys.readouterr().out
    for words in SAYS[name]:
        assert words in said
    drawn = ElementTree.fromstring((tmp_path / "drawn.svg").read_text("utf-8"))
    assert len(drawn.findall(".//{http://www.w3.org/2000/svg}path")) > 20


def cells(name: str) -> list[dict[str, Any]]:
    """The cells of a notebook, which holds no results."""
    notebook = json.loads((EXAMPLES / f"{name}.ipynb").read_text("utf-8"))
    assert notebook["nbformat"] == 4
    found: list[dict[str, Any]] = notebook["cells"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in found if "outputs" in cell)
    return found


def run_cells(name: str) -> dict[str, Any]:
    """What the names of a notebook stand for after all its cells; the last expression of a cell is shown."""
    import ast

    known: dict[str, Any] = {"__name__": "__main__"}
    for number, cell in enumerate(cells(name)):
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, f"{name} cell {number}", "exec"), known)
        if isinstance(last, ast.Expr):
            shown = eval(compile(ast.Expression(last.value), f"{name} cell {number}", "eval"), known)
            assert shown is None or ElementTree.fromstring(shown._repr_svg_()).tag.endswith("svg")
    return known


def test_the_lecture_on_self_motion() -> None:
    known = run_cells("lecture_self_motion")
    assert known["number"].tolist() == [2, 1, 2, 1]  # Lenarčič's regions A to D
    assert known["radii"].round(9).tolist() == [0.2, 0.3, 0.5, 1.0]
    assert (known["eight"].count, known["eight"].complete) == (8, "proved")


def test_the_lecture_on_cuspidality() -> None:
    known = run_cells("lecture_cuspidality")
    assert known["change"].certified
    assert sorted(known["numbers"].tolist()) == [1, 2, 3, 4, 5]  # the five domains
    assert known["followed"].flips
    assert known["puma"].cuspidal is False
