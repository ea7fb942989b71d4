"""Source distribution, wheel and editable install: complete, and at work outside the checkout."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import venv
import zipfile
from pathlib import Path
from typing import Any

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("wheel")]

# What installs where: the folder of the checkout, and its place in the wheel.
PACKAGES = {
    "src/chainrule": "chainrule",
    "derive": "chainrule/derive",
    "templates": "chainrule/templates",
    "generated": "chainrule/generated",
}
# Built with what is installed here, so no index is asked; for one instruction set and not optimised, so the compiler
# is soon done.
QUICK = ("-Ccmake.build-type=Debug", "-Ccmake.define.CHAINRULE_ISAS=plain")
BUILD = ("--no-deps", "--no-index", "--no-build-isolation", *QUICK)

ASK = """
import json, sys
import chainrule as cr
arm = cr.load("panda")
jacobian = arm.jacobian([[0.0] * 7] * 3)
heavy = sorted({"casadi", "jinja2", "matplotlib", "scipy", "sympy"} & set(sys.modules))
import chainrule.derive
print(json.dumps({
    "package": cr.__file__,
    "derive": chainrule.derive.__file__,
    "version": cr.__version__,
    "shape": jacobian.shape,
    "column": jacobian[2, :, 0].tolist(),
    "heavy": heavy,
}))
"""


def run(*command: str | Path, cwd: Path) -> str:
    """Run a command that must succeed, whatever the caller's environment says of Python's path or of cached kernels."""
    env = {key: value for key, value in os.environ.items() if not key.startswith(("CHAINRULE_", "PYTHON"))}
    env["CHAINRULE_CACHE"] = str(cwd / "cache")
    done = subprocess.run(
        [str(word) for word in command],
        cwd=cwd,
        env=env,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{done.args}\n{done.stdout}"
    return done.stdout


def copy_of_checkout(target: Path) -> Path:
    """The checkout's own files: no history, no environment, no cache, nothing built."""

    def not_sources(folder: str, names: list[str]) -> list[str]:
        built = {".git", ".hypothesis", "__pycache__", "build", "dist", "node_modules", "site"}
        return [
            name
            for name in names
            if name in built or name.endswith(("_cache", ".so")) or (Path(folder) / name / "pyvenv.cfg").exists()
        ]

    return Path(shutil.copytree(CHECKOUT, target, ignore=not_sources))


def files_below(folder: Path) -> set[str]:
    """The files below a folder, as paths relative to it; what Python compiled along the way is none of them."""
    return {
        path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc"
    }


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return copy_of_checkout(tmp_path_factory.mktemp("copy") / "chainrule")


@pytest.fixture(scope="module")
def sdist(checkout: Path) -> Path:
    run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", checkout.parent, checkout, cwd=checkout)
    (archive,) = checkout.parent.glob("chainrule-*.tar.gz")
    return archive


@pytest.fixture(scope="module")
def wheel(sdist: Path) -> Path:
    out = sdist.parent / "wheel"
    run(sys.executable, "-m", "pip", "wheel", *BUILD, "--wheel-dir", out, sdist, cwd=sdist.parent)
    (archive,) = out.glob("chainrule-*.whl")
    return archive


class Environment:
    """A fresh virtual environment that finds chainrule's dependencies, and nothing else, where the tests found them."""

    def __init__(self, folder: Path) -> None:
        venv.create(folder, symlinks=os.name != "nt", with_pip=False)
        self.folder = folder
        self.python = self.path("scripts") / Path(sys.executable).name
        here = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
        # a .pth file that is reached through another is not read: an editable install of the tests' own stays out
        (self.path("purelib") / "dependencies.pth").write_text("\n".join(sorted(here)) + "\n")

    def path(self, kind: str) -> Path:
        return Path(sysconfig.get_path(kind, "venv", {"base": str(self.folder), "platbase": str(self.folder)}))

    def install(self, *what: str | Path) -> None:
        pip = (sys.executable, "-m", "pip", "--python", self.python, "install", "--ignore-installed")
        run(*pip, *BUILD, *what, cwd=self.folder)

    def ask(self) -> dict[str, Any]:
        answer: dict[str, Any] = json.loads(run(self.python, "-I", "-c", ASK, cwd=self.folder))
        assert not (self.folder / "cache").exists()  # the installed kernels answered: nothing was compiled
        return answer


def check_answers(answer: dict[str, Any]) -> None:
    """What `ASK` must say wherever it runs.

    At q = 0 the Panda's tip lies 0.088 m before the vertical axis of joint 1 (the sum of the a's of its modified DH
    table), so that joint moves it at 0.088 m/rad along y.
    """
    assert answer["shape"] == [3, 6, 7]
    assert answer["column"] == pytest.approx([0, 0.088, 0, 0, 0, 1], abs=1e-12)
    assert answer["version"] == tomllib.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    assert answer["heavy"] == []


def test_sdist_is_complete(checkout: Path, sdist: Path) -> None:
    with tarfile.open(sdist) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    for folder in ("src", "derive", "templates", "generated", "tests", "build_backend"):
        assert {f"{folder}/{name}" for name in files_below(checkout / folder)} <= packed


def test_wheel_holds_the_four_folders_and_the_kernels(checkout: Path, wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        packed = {name for name in archive.namelist() if ".dist-info/" not in name}
    expected = {f"{place}/{name}" for folder, place in PACKAGES.items() for name in files_below(checkout / folder)} - {
        "chainrule/_gufunc.c"
    }
    expected |= {f"chainrule/_kernels/{path.parent.name}.plain.so" for path in (checkout / "generated").glob("*/*.c")}
    expected.add("chainrule/_gufunc" + sysconfig.get_config_var("EXT_SUFFIX"))
    assert packed == expected
    assert {"chainrule/py.typed", "chainrule/arms/panda.toml", "chainrule/generated/manifest.json"} <= packed


def test_wheel_works_outside_the_checkout(wheel: Path, tmp_path: Path) -> None:
    env = Environment(tmp_path / "env")
    env.install(wheel)
    answer = env.ask()
    check_answers(answer)
    assert Path(answer["package"]) == env.path("platlib") / "chainrule" / "__init__.py"
    assert Path(answer["derive"]) == env.path("platlib") / "chainrule" / "derive" / "__init__.py"
    assert "panda" in run(env.path("scripts") / "chainrule", "arms", cwd=tmp_path)


def test_editable_install_works_from_the_checkout(checkout: Path, sdist: Path, tmp_path: Path) -> None:
    env = Environment(tmp_path / "env")
    env.install("--editable", checkout)
    answer = env.ask()
    check_answers(answer)
    assert Path(answer["package"]) == checkout / "src" / "chainrule" / "__init__.py"
    assert Path(answer["derive"]) == checkout / "derive" / "__init__.py"
