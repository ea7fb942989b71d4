"""The site: its pages are up to date, its formulas are those that run, nothing public is left out."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from site_pages import script

import chainrule as cr
from chainrule.papers import PAPERS

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))


@pytest.fixture(scope="module")
def site() -> dict[str, ModuleType]:
    """The modules that write the site."""
    return {name: script(name) for name in ("figures", "latex", "pages")}


# ---- what is written anew is what is there -----------------------------------------------------------------------


def test_theory_is_printed_from_the_derivations(site: dict[str, ModuleType]) -> None:
    pages = site["pages"]
    assert {path.stem for path in (DOCS / "theory").glob("*.md")} == set(pages.THEORY)
    for key in pages.THEORY:
        message = f"docs/theory/{key}.md is out of date: run python docs/pages.py theory"
        assert pages.theory_page(key) == (DOCS / "theory" / f"{key}.md").read_text("utf-8"), message


def test_every_paper_has_a_page() -> None:
    """Each is compared with what is recomputed in tests/test_papers_*.py, where that is at hand."""
    assert {path.stem for path in (DOCS / "papers").glob("*.md")} == {*PAPERS, "index"}
    index = (DOCS / "papers" / "index.md").read_text("utf-8")
    for key in PAPERS:
        assert f"({key}.md)" in index
        assert "paper_page_is_up_to_date" in (ROOT / "tests" / f"test_papers_{key}.py").read_text("utf-8")


def test_pages_agree_but_for_rounding(site: dict[str, ModuleType]) -> None:
    same = site["pages"].same_but_for_rounding
    assert same("length 13.195359787 rad, off by 2e-15", "length 13.195359788 rad, off by 0")
    assert not same("length 13.195 rad", "length 13.196 rad")
    assert not same("2 curves", "1 curves")
    assert not same("2 curves", "2 arcs")
    assert not same("off by 1e-6", "off by 0")


# ---- formulas ----------------------------------------------------------------------------------------------------


def read_back(latex: str, known: dict[str, Any]) -> Any:
    """The value of a printed formula: LaTeX turned into Python by rules of this test's own."""
    text = latex.replace(r"\,", "*").replace(r"\left(", "(").replace(r"\right)", ")").replace("^", "**")
    text = re.sub(r"\\ell_\{(\d)\}", r"l\1", text)
    text = re.sub(r"([a-z])_\{(\d+)\}", r"\1\2", text)
    text = text.replace("{", "(").replace("}", ")")
    assert "\\" not in text, text
    return eval(text, {"__builtins__": {}}, known)


def formula(page: str, left: str) -> str:
    """The right side of a formula of a page, on one line; the first one with that left side."""
    text = (DOCS / "theory" / page).read_text("utf-8").replace(" \\\\\n&\\quad", "")
    found = re.search(rf"^{re.escape(left)} &= (.*?)(?: \\\\)?$", text, re.M)
    assert found is not None
    return found.group(1)


def test_printed_minors_are_those_that_run() -> None:
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = np.random.default_rng(0).uniform(-3.0, 3.0, (50, 3))
    known = dict(zip(("l1", "l2", "l3"), arm.parameters, strict=True)) | {
        "s2": np.sin(q[:, 1]),
        "s3": np.sin(q[:, 2]),
        "s23": np.sin(q[:, 1] + q[:, 2]),
    }
    printed = [read_back(formula("manipulability.md", f"M_{{{pair}}}"), known) for pair in ("12", "13", "23")]
    np.testing.assert_allclose(np.stack(printed, axis=-1), arm.minors(q), rtol=0, atol=1e-14)
    height = read_back(formula("manipulability.md", "H^{2}"), known)
    np.testing.assert_allclose(height, np.asarray(arm.manipulability(q)) ** 2, rtol=1e-12, atol=1e-14)


def test_printed_determinant_is_that_of_the_jacobian() -> None:
    arm = cr.load("orthogonal_3r_fig2a")
    q = np.random.default_rng(1).uniform(-3.0, 3.0, (50, 3))
    known = dict(zip(("d2", "d3", "d4", "r2"), arm.parameters, strict=True)) | {
        f"{name}{joint}": function(q[:, joint - 1])
        for name, function in (("s", np.sin), ("c", np.cos))
        for joint in (2, 3)
    }
    printed = read_back(formula("orthogonal-arms.md", r"\det \mathbf{J}"), known)
    np.testing.assert_allclose(printed, np.linalg.det(arm.jacobian(q, task="position")), rtol=1e-11, atol=1e-12)


def test_the_name_of_a_symbol(site: dict[str, ModuleType]) -> None:
    import sympy as sp

    from chainrule.derive.program import CopySign, GuardedInverse, Where

    latex = site["latex"].latex
    x, y, q2, q3 = sp.symbols("x y q2 q3", real=True)
    assert latex(sp.sin(q2 + q3) ** 2) == "s_{23}^{2}"
    assert latex(sp.cos(x)) == r"\cos\left(x\right)"
    assert latex(sp.Rational(1, 2)) == r"\frac{1}{2}"
    assert latex(GuardedInverse(x)) == r"\left[\frac{1}{x}\right]"
    assert latex(CopySign(x, sp.Integer(1))) == r"\left|x\right|"
    assert latex(CopySign(x, y)) == r"\left|x\right| \operatorname*{sgn}\left(y\right)"
    assert latex(Where(x, y)) == r"\begin{cases} y & x \neq 0 \\ 0 & x = 0 \end{cases}"


# ---- nothing is missing ------------------------------------------------------------------------------------------


def test_every_public_name_is_in_the_reference() -> None:
    listed = [
        name
        for path in sorted((DOCS / "api").glob("*.md"))
        for name in re.findall(r"^::: chainrule\.(\w+)$", path.read_text("utf-8"), re.M)
    ]
    assert sorted(listed) == sorted(cr.__all__)  # each once


def test_every_page_is_in_the_navigation() -> None:
    listed = re.findall(r"[\w/-]+\.md", (ROOT / "mkdocs.yml").read_text("utf-8").split("\nnav:\n")[1])
    assert sorted(listed) == sorted(str(path.relative_to(DOCS)) for path in PAGES)


def test_figures_are_drawn_by_the_script_and_shown(site: dict[str, ModuleType]) -> None:
    there = {path.stem for path in (DOCS / "images").glob("*.svg")}
    assert there == set(site["figures"].FIGURES)
    assert sorted(path.name for path in (DOCS / "images").glob("*") if path.suffix != ".svg") == ["report.png"]
    text = "\n".join(path.read_text("utf-8") for path in (*PAGES, ROOT / "README.md"))
    shown = set(re.findall(r"images/([\w-]+\.\w+)\)", text))
    assert shown == {f"{name}.svg" for name in there} | {"report.png"}


def test_every_guide_shows_a_figure_and_says_what_it_cannot_do() -> None:
    limits = (DOCS / "limits.md").read_text("utf-8")
    for path in sorted(DOCS.glob("*.md")):
        text = path.read_text("utf-8")
        if "## What it cannot do" in text:
            assert "](images/" in text, path.name
            assert f'--8<-- "docs/{path.name}:limits"' in limits, path.name


def test_a_figure_is_drawn_the_same_again(site: dict[str, ModuleType], tmp_path: Path) -> None:
    from chainrule.console import write_figure

    for name in ("optima", "arm-files"):
        for run in ("first", "second"):
            write_figure(site["figures"].FIGURES[name](), tmp_path / f"{run}.svg")
        assert (tmp_path / "first.svg").read_bytes() == (tmp_path / "second.svg").read_bytes()


def test_the_papers_are_cited_with_the_version() -> None:
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    version = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    assert re.search(r"^version: (.*)$", citation, re.M).group(1) == version  # type: ignore[union-attr]
    authors = ("Lenarčič", "Sanchez", "Ambike", "Baili", "De Luca")
    assert all(citation.count(f'family-names: "{name}"') == 1 for name in authors)
