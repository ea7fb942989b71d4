"""Settings shared by the tests: repeatable random examples, and a cache of their own."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

settings.register_profile(
    "chainrule",
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
settings.load_profile("chainrule")


@pytest.fixture(scope="session", autouse=True)
def common_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One cache of compiled kernels for the whole run, never the user's own."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "kernels"
    folder.mkdir(exist_ok=True)
    os.environ["CHAINRULE_CACHE"] = str(folder)
    return folder


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache of one test's own."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("CHAINRULE_CACHE", str(folder))
    return folder


@pytest.fixture(scope="session")
def c_compiler() -> list[str]:
    """The C compiler's command; without one the test is left out."""
    from chainrule import compile as compiling

    found = compiling.compiler()
    if found is None:
        pytest.skip("no C compiler")
    return found


@pytest.fixture
def call(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """The command line with these arguments: its exit code, what it wrote, what it complained of."""
    from chainrule import cli

    def run(*arguments: Any) -> tuple[int, str, str]:
        code = cli.run([str(a) for a in arguments])
        return (code, *capsys.readouterr())

    return run


@pytest.fixture(scope="session")
def report_of() -> Callable[[str], Any]:
    """An embedded arm and its report, by the arm's name; made once."""
    import chainrule as cr
    from chainrule import report

    made: dict[str, Any] = {}

    def build(name: str) -> Any:
        if name not in made:
            arm = cr.load(name)
            made[name] = arm, report.build(arm)
        return made[name]

    return build
