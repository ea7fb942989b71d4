"""The cache of compiled kernels: shared by processes, suspicious of what it finds, and dispensable."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import arms_under_test as under
import numpy as np
import pytest

import chainrule as cr
from chainrule import compile as compiling

pytestmark = pytest.mark.xdist_group("cache")  # the entries made by one test serve the next

ROWS = [("R", 0.0, 0.0, 0.3, 0.0), ("P", 0.5, 0.4, 0.0, 0.2)]
Q = np.array([[0.3, 0.1], [-1.2, 0.4], [2.0, 0.0]])
GROUP = "kinematics"  # a chain of two joints has no other: no task has so few rows


def tiny(name="tiny"):
    return cr.Arm.from_dh(ROWS, name=name)


EXPECTED = np.array([[float(x) for x in list(under.reference.pose(tiny().description, list(q)))[3:12:4]] for q in Q])


def entries(folder: Path) -> list[Path]:
    return sorted(folder.iterdir())


@pytest.fixture(scope="session")
def quick_compiler(tmp_path_factory) -> Path:
    """The compiler without optimisation: what is tested here is not speed."""
    return compiler_script(tmp_path_factory.mktemp("cc"), 'exec cc "$@" -O0')


@pytest.fixture(autouse=True)
def quickly(quick_compiler, monkeypatch):
    monkeypatch.setenv("CC", str(quick_compiler))


@pytest.fixture(scope="session")
def made(tmp_path_factory, quick_compiler) -> Path:
    """A cache with the tiny arm's entry, made once and copied by the tests that spoil it."""
    folder = tmp_path_factory.mktemp("made")
    before = os.environ.get("CHAINRULE_CACHE")
    os.environ["CHAINRULE_CACHE"], os.environ["CC"] = str(folder), str(quick_compiler)
    try:
        assert tiny().evaluator("position").compiled
    finally:
        os.environ["CHAINRULE_CACHE"] = before or ""
        del os.environ["CC"]
    return folder


@pytest.fixture
def filled(made, cache) -> Path:
    """An own copy of that cache; its one entry."""
    shutil.copytree(made, cache)
    (entry,) = entries(cache)
    return entry


def works(compiled=True):
    arm = tiny()
    assert np.abs(arm.position(Q) - EXPECTED).max() < 1e-15
    assert arm.evaluator("position").compiled == compiled


def digests(folder: Path) -> dict[str, str]:
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(folder.iterdir())}


# ---- a good entry ----------------------------------------------------------------------------------------------


def test_entry_is_found_again(filled, monkeypatch):
    """Nothing is derived or compiled for an arm that is in the cache, whatever it is called."""
    monkeypatch.setattr(compiling, "_make", lambda *given: pytest.fail("it was made again"))
    works()
    assert (filled / "entry.json").is_file()


def test_entry_is_private(filled):
    assert filled.stat().st_mode & 0o077 == 0
    assert all(path.stat().st_mode & 0o077 == 0 for path in filled.iterdir())


def test_no_leftovers(filled):
    names = {path.name for path in filled.iterdir()}
    assert {"entry.json", "tiny_kinematics.so", "tiny_kinematics.py", "tiny_kinematics.c", "tiny_kinematics.h"} <= names
    assert not [name for name in names if name.endswith(".o")]
    assert entries(filled.parent) == [filled]


def test_another_geometry_has_an_entry_of_its_own(filled):
    arm = cr.Arm.from_dh([ROWS[0], ("P", 0.5, 0.400000000001, 0.0, 0.2)], name="tiny")
    assert not np.array_equal(arm.position(Q), tiny().position(Q))
    assert len(entries(filled.parent)) == 2


def test_limits_share_an_entry(filled, monkeypatch):
    monkeypatch.setattr(compiling, "_make", lambda *given: pytest.fail("it was made again"))
    tiny().with_limits(velocity=[1.0, 2.0]).position(Q)


# ---- spoiled entries -------------------------------------------------------------------------------------------


def truncate(entry):
    library = entry / "tiny_kinematics.so"
    library.write_bytes(library.read_bytes()[:1000])


def empty(entry):
    (entry / "tiny_kinematics.so").write_bytes(b"")


def edit_code(entry):
    path = entry / "tiny_kinematics.py"
    path.write_text(path.read_text() + "\n")


def record_of(entry):
    return json.loads((entry / "entry.json").read_text())["record"]


def edit_record(entry, signed=True, **changes):
    """Change the record, and (``signed``) the digest that guards it."""
    written = json.loads((entry / "entry.json").read_text())
    written["record"] |= changes
    if signed:
        written["digest"] = hashlib.sha256(json.dumps(written["record"], sort_keys=True).encode()).hexdigest()
    (entry / "entry.json").write_text(json.dumps(written))


def no_json(entry):
    (entry / "entry.json").write_text("{")


def lead_outside(entry):
    """A record that claims a library elsewhere, with its right digest."""
    other = entry.parent / "evil.so"
    shutil.move(entry / "tiny_kinematics.so", other)
    record = record_of(entry)
    files = record["files"] | {"../evil.so": record["files"]["tiny_kinematics.so"]}
    del files["tiny_kinematics.so"]
    edit_record(entry, files=files, library="../evil.so")


def unlisted_library(entry):
    """A library that the record does not vouch for."""
    shutil.copy(entry / "tiny_kinematics.so", entry / "other.so")
    edit_record(entry, library="other.so")


def enlarge(entry):
    """Shapes that the kernels do not have would let them read and write beyond their arrays."""
    functions = record_of(entry)["functions"]
    functions["position"]["outputs"][0][1] = [300]
    edit_record(entry, signed=False, functions=functions)


def unlisted_absolute(entry):
    shutil.move(entry / "tiny_kinematics.so", entry.parent / "evil.so")
    record = record_of(entry)
    edit_record(
        entry,
        files={k: v for k, v in record["files"].items() if not k.endswith(".so")},
        library=str(entry.parent / "evil.so"),
    )


def a_file_instead(entry):
    shutil.rmtree(entry)
    entry.write_text("not a folder")


def a_dangling_link(entry):
    shutil.rmtree(entry)
    entry.symlink_to(entry.parent / "nowhere")


SPOILED = {
    "truncated library": truncate,
    "empty library": empty,
    "edited code": edit_code,
    "no JSON": no_json,
    "record is a list": lambda entry: (entry / "entry.json").write_text("[]"),
    "record without files": lambda entry: edit_record(entry, files=None),
    "other model": lambda entry: edit_record(entry, model="0" * 64),
    "other group": lambda entry: edit_record(entry, group="pose"),
    "library missing": lambda entry: (entry / "tiny_kinematics.so").unlink(),
    "record missing": lambda entry: (entry / "entry.json").unlink(),
    "library elsewhere": lead_outside,
    "unlisted library": unlisted_library,
    "unlisted library elsewhere": unlisted_absolute,
    "functions missing": lambda entry: edit_record(entry, signed=False, functions={}),
    "functions are nonsense": lambda entry: edit_record(entry, signed=False, functions={"position": 3}),
    "larger outputs": enlarge,
    "all may write the record": lambda entry: (entry / "entry.json").chmod(0o666),
    "group may write the folder": lambda entry: entry.chmod(0o770),
    "all may write the library": lambda entry: (entry / "tiny_kinematics.so").chmod(0o666),
    "a file instead": a_file_instead,
    "a dangling link": a_dangling_link,
}


@pytest.mark.parametrize("spoil", SPOILED.values(), ids=SPOILED)
def test_spoiled_entries_are_made_again(filled, spoil):
    """Not used, not fatal: replaced by a good one, and nothing else is left behind."""
    spoil(filled)
    works()
    assert filled.is_dir() and compiling._entry(filled, tiny().description.model, GROUP) is not None
    assert [path for path in entries(filled.parent) if path.name != "evil.so"] == [filled]
    assert not (filled / "other.so").exists()


# ---- several processes -----------------------------------------------------------------------------------------

WORKER = """
import sys
import numpy as np
import chainrule as cr
arm = cr.Arm.from_dh([("R", 0.0, 0.0, 0.3, 0.0), ("P", 0.5, 0.4, 0.0, 0.2)], name="tiny")
sys.stdin.read()
np.save(sys.argv[1], arm.position([[0.3, 0.1], [-1.2, 0.4], [2.0, 0.0]]))
print(arm.evaluator("position").compiled)
"""


def spawn(target: Path, **environment: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-W", "ignore", "-c", WORKER, str(target)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | environment,
    )


@pytest.mark.parametrize("start", ["empty", "spoiled"])
def test_several_processes_at_once(cache, made, tmp_path, start):
    """Processes that find nothing (or a broken entry) at the same moment all succeed, and one entry is left."""
    if start == "spoiled":
        shutil.copytree(made, cache)
        truncate(entries(cache)[0])
    processes = [spawn(tmp_path / f"{k}.npy") for k in range(3)]
    for process in processes:  # all have imported and wait: let them go together
        assert process.stdin is not None
        process.stdin.close()
        process.stdin = None
    for k, process in enumerate(processes):
        said, errors = process.communicate(timeout=300)
        assert process.returncode == 0, errors
        assert said.strip() == "True"
        assert np.array_equal(np.load(tmp_path / f"{k}.npy"), np.load(tmp_path / "0.npy"))
    assert np.abs(np.load(tmp_path / "0.npy") - EXPECTED).max() < 1e-15
    assert len(entries(cache)) == 1
    works()


def test_killed_while_compiling(cache, tmp_path):
    """What a killed process leaves is never taken for an entry."""
    slow = compiler_script(tmp_path, "touch " + str(tmp_path / "started") + "; sleep 60")
    process = spawn(tmp_path / "x.npy", CC=str(slow))
    process.stdin.close()
    process.stdin = None
    try:
        while not (tmp_path / "started").exists():
            assert process.poll() is None
    finally:
        process.kill()
        process.communicate()
    assert entries(cache)
    works()


# ---- where it is -----------------------------------------------------------------------------------------------


def test_place(monkeypatch, tmp_path):
    monkeypatch.setenv("CHAINRULE_CACHE", str(tmp_path / "chosen"))
    assert compiling.cache_folder() == tmp_path / "chosen"
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("CHAINRULE_CACHE", "~/mine")
    assert compiling.cache_folder() == tmp_path / "mine"
    monkeypatch.delenv("CHAINRULE_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    monkeypatch.setattr(sys, "platform", "linux")
    assert compiling.cache_folder() == tmp_path / "xdg" / "chainrule"
    monkeypatch.delenv("XDG_CACHE_HOME")
    assert compiling.cache_folder() == tmp_path / ".cache" / "chainrule"


def test_place_that_is_a_file(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    for place in (tmp_path / "file", tmp_path / "file" / "below", "/dev/null/chainrule"):
        monkeypatch.setenv("CHAINRULE_CACHE", str(place))
        with pytest.raises(cr.GenerationError, match="cannot be written") as caught:
            tiny().position(Q)
        assert "set CHAINRULE_CACHE" in under.one_line(caught.value)


def test_embedded_arms_need_no_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("CHAINRULE_CACHE", str(tmp_path / "cache"))
    cr.load("panda").jacobian(np.zeros(7))
    assert not (tmp_path / "cache").exists()


# ---- compilers -------------------------------------------------------------------------------------------------


def compiler_script(folder: Path, commands: str) -> Path:
    path = folder / "mycc"
    path.write_text(f"#!/bin/sh\n{commands}\n")
    path.chmod(0o755)
    return path


@pytest.mark.parametrize(
    "variables", [{"CC": "no-such-compiler"}, {"CC": "", "PATH": "/nonexistent"}], ids=["CC", "PATH"]
)
def test_no_compiler(cache, monkeypatch, variables):
    """The NumPy code takes its place, with one warning that says what to do; a compiler that comes later is used."""
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    told = "CC is 'no-such-compiler'" if variables["CC"] else "set CC"
    with pytest.warns(cr.NoCompilerWarning, match=re.escape(f"no C compiler was found ({told})")):
        works(compiled=False)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        works(compiled=False)  # from the cache now
    monkeypatch.undo()
    monkeypatch.setenv("CHAINRULE_CACHE", str(cache))
    works(compiled=True)
    assert len(entries(cache)) == 1


def test_no_compiler_is_complete(cache, monkeypatch):
    """Every method answers in NumPy code as it does compiled, out= and float32 included."""
    monkeypatch.setenv("CC", "no-such-compiler")
    arm = cr.planar("RPPR", [1.0, 0.5, 0.25, 0.3], [0.0, 0.4, 0.9, 0.0], name="uncompiled")
    q = under.random_q(arm, 5, 1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cr.NoCompilerWarning)
        for task in arm.tasks:
            for real in (np.float64, np.float32):
                gradient = np.empty((5, 4), real)
                assert arm.manipulability_gradient(q.astype(real), task=task, criterion="1/H", out=gradient) is gradient
                place, jacobian = arm.kinematics(q.astype(real), task=task)
                assert place.dtype == jacobian.dtype == real
            for k in range(5):
                exact = under.gradients(arm.description, task, q[k])
                found = arm.manipulability_gradient(q[k], task=task)
                assert max(abs(a - b) for a, b in zip(found, exact[1], strict=True)) < 1e-13
        assert not arm.evaluator("pose").compiled


def test_compiler_that_fails(cache, tmp_path, monkeypatch):
    script = compiler_script(tmp_path, 'echo "In file included:" >&2; echo "tiny.c:1: error: bad day" >&2; exit 1')
    monkeypatch.setenv("CC", str(script))
    with pytest.raises(cr.GenerationError, match="error: bad day") as caught:
        tiny().position(Q)
    assert "mycc" in under.one_line(caught.value)
    assert entries(cache) == []
    monkeypatch.undo()
    monkeypatch.setenv("CHAINRULE_CACHE", str(cache))
    works()


def test_compiler_with_arguments(cache, tmp_path, monkeypatch):
    log = tmp_path / "log"
    script = compiler_script(tmp_path, f'echo "$@" >> {log}; exec cc "$@"')
    monkeypatch.setenv("CC", f"{script} -DMINE=1")
    works()
    lines = log.read_text().splitlines()
    assert len(lines) == 3 and all("-DMINE=1" in line for line in lines)
    assert "-std=c99" in lines[0]


def test_compilers_are_told_no_names_from_files(cache, tmp_path, monkeypatch):
    """File and symbol names come from a safe identifier, whatever the arm is called."""
    log = tmp_path / "log"
    monkeypatch.setenv("CC", str(compiler_script(tmp_path, f'echo "$@" >> {log}; exec cc "$@"')))
    cr.Arm.from_dh(ROWS, name="0.Odd--name_.V2").position(Q)
    assert "Odd" not in log.read_text()
    assert re.search(r"/arm_0_odd_name_v2_kinematics\.c", log.read_text())
