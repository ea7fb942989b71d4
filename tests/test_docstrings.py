"""The examples in docstrings run, and print what they say."""

from __future__ import annotations

import doctest
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]


def modules_with_examples() -> list[str]:
    """The package's modules, under the names they install as, whose text holds an example."""
    found = []
    for folder, place in ((ROOT / "src" / "chainrule", "chainrule"), (ROOT / "derive", "chainrule.derive")):
        for path in sorted(folder.rglob("*.py")):
            if ">>>" in path.read_text("utf-8"):
                parts = path.relative_to(folder).with_suffix("").parts
                found.append(".".join([place, *(part for part in parts if part != "__init__")]))
    return found


@pytest.mark.parametrize("name", modules_with_examples())
def test_examples(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # an example may write a file
    failed, tried = doctest.testmod(import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert tried > 0
    assert failed == 0
