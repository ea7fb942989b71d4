"""What was generated follows its inputs: exactly, atomically, byte for byte."""

from __future__ import annotations

import ast
import contextlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from chainrule.derive import manifest as records
from chainrule.derive import write
from chainrule.derive.manifest import Places

CHECKOUT = Places.checkout(Path(__file__).resolve().parents[1])
#: Few arms, so that all can be regenerated in seconds: a family with a closed form, a square arm, a redundant one.
ARMS = ("planar_3r.toml", "puma560.toml", "panda.toml")
PLANAR = ("kinematics", "position", "x_alpha", "pose", "motion", "speed_ratio")
FOLLOWED = ("continuation_position", "continuation_x_alpha")
MORPHOLOGIES = tuple(f"planar_{a}{b}{c}" for a in "rp" for b in "rp" for c in "rp")  # generated whatever arms there are
UNITS = {
    **dict.fromkeys(MORPHOLOGIES, ("kinematics", "motion", "speed_ratio")),
    "planar_rrr": (*PLANAR, "self_motion", *FOLLOWED),
    "regional_3r": ("cuspidality",),
    "motion": ("rest_to_rest",),
    "puma560": ("kinematics", "position", "pose"),
    "panda": ("kinematics", "position", "pose", "continuation_pose", "redundancy_pose", "dynamics"),
}

RUN = """
import sys
import chainrule
from chainrule.derive.write import main
assert chainrule.__file__.startswith(sys.argv[1]), chainrule.__file__
status = main(sys.argv[2:])
print("loaded:", *sorted({"sympy", "casadi", "jinja2"} & set(sys.modules)), file=sys.stderr)
sys.exit(status)
"""


def command(root: Path, *arguments: str) -> list[str]:
    return [sys.executable, "-S", "-c", RUN, str(root), *arguments]  # -S: no editable install gets in between


def environment(root: Path) -> dict[str, str]:
    packages = [path for path in sys.path if Path(path).name in ("site-packages", "dist-packages")]
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(root / "src"), *packages])}


def run(root: Path, *arguments: str) -> tuple[int, str, str]:
    """``python -m chainrule.derive`` of a copy, in a process of its own: status, output, errors."""
    done = subprocess.run(command(root, *arguments), capture_output=True, text=True, cwd=root, env=environment(root))
    return done.returncode, done.stdout, done.stderr


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> Path:
    """A copy of the checkout with three arms, its ``generated/`` made from nothing by one run."""
    root = tmp_path_factory.mktemp("checkout")
    skip = shutil.ignore_patterns("__pycache__", "*.so", "_kernels", "build")
    for source, target in (
        (CHECKOUT.package, "src/chainrule"),
        (CHECKOUT.derive, "derive"),
        (CHECKOUT.templates, "templates"),
    ):
        shutil.copytree(source, root / target, ignore=skip)
    for name in ("derive", "templates", "generated"):  # installed side by side, as an editable install does
        (root / "src/chainrule" / name).symlink_to(f"../../{name}")
    for path in (root / "src/chainrule/arms").glob("*.toml"):
        if path.name not in ARMS:
            path.unlink()
    (root / "generated").mkdir()
    shutil.copy(CHECKOUT.generated / "__init__.py", root / "generated")
    status, _, errors = run(root)
    assert status == 0, errors
    return root


@pytest.fixture
def copy(made, tmp_path) -> Path:
    """An own copy of it, to edit."""
    return Path(
        shutil.copytree(made, tmp_path / "checkout", symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    )


def contents(root: Path) -> dict[str, tuple[int, bytes]]:
    """Every generated file: when it was written, and its bytes."""
    return {
        path.relative_to(root / "generated").as_posix(): (path.stat().st_mtime_ns, path.read_bytes())
        for path in sorted((root / "generated").rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }


def written(before, after) -> set[str]:
    return {name for name in after if before.get(name) != after[name]} | (before.keys() - after.keys())


def files_of(*units: str) -> set[str]:
    """The files of units such as ``panda_pose``."""
    return {
        f"{next((model for model in UNITS if unit.startswith(f'{model}_')), unit.rpartition('_')[0])}/{unit}{end}"
        for unit in units
        for end in (".c", ".h", ".inc", ".py")
    }


def all_of(*models: str) -> list[str]:
    return [f"{model}_{group}" for model in models for group in UNITS[model]]


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


# ---- what is there ---------------------------------------------------------------------------------------------


def test_made_from_nothing(made):
    headers = {f"chainrule_{name}.h" for name in ("real", "sincos", "batch", "continuation")}
    shared = {*headers, "__init__.py", "manifest.json"}
    assert contents(made).keys() == files_of(*all_of(*UNITS)) | shared


def test_the_same_inputs_give_the_same_bytes(made):
    """A second derivation, elsewhere and by another process, wrote what the checkout holds."""
    for name, (_, content) in contents(made).items():
        if name != "manifest.json":
            assert content == (CHECKOUT.generated / name).read_bytes(), name


def test_generated_belongs_to_its_inputs():
    """The committed files are those of the committed derivations, templates and arms."""
    assert [str(drift) for drift in records.drift(CHECKOUT)] == []


def test_no_date_path_or_version(made):
    for name, (_, content) in contents(made).items():
        text = content.decode()
        assert not re.search(r"\b20\d\d-\d\d-\d\d\b", text), name
        for word in (str(made), str(CHECKOUT.derive.parent), str(Path.home()), sys.version.split()[0]):
            assert word not in text, (name, word)


def test_headers_say_what_they_are(made):
    record = json.loads((made / "generated/manifest.json").read_text())["units"]["panda_pose"]
    for name in files_of("panda_pose"):
        head = (made / "generated" / name).read_text()[:600]
        assert record["digest"] in head
        assert "do not edit" in head.lower()
        assert f"templates/kernel.{name.rsplit('.')[-1]}.j2" in head
    text = (made / "generated/panda/panda_pose.h").read_text()
    assert f"{record['functions']['minors_pose']['operations']} operations" in text


# ---- nothing to do ---------------------------------------------------------------------------------------------


def test_nothing_to_do(copy):
    """Nothing is written, and neither SymPy nor CasADi nor Jinja is loaded to find that out."""
    before = contents(copy)
    for arguments in ((), ("--check",)):
        status, said, errors = run(copy, *arguments)
        assert status == 0 and "matches its inputs" in said
        assert errors.strip() == "loaded:"
    assert written(before, contents(copy)) == set()


def test_line_endings_are_no_change(copy):
    path = copy / "derive/chain.py"
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert run(copy, "--check")[0] == 0


# ---- what an edit affects --------------------------------------------------------------------------------------


def test_editing_one_derivation(copy):
    """The planar closed form: the planar arm's units that use it, and no file of the others."""
    before = contents(copy)
    edit(copy / "derive/planar_3r.py", '"""The planar 3R arm', '"""The planar 3R arm, edited')
    status, said, errors = run(copy, "--check")
    assert status == 1 and "run python -m chainrule.derive" in said
    assert "planar_rrr_position.c: its derivation, template or arm was edited" in errors
    assert "panda" not in errors and "puma560" not in errors
    assert run(copy)[0] == 0
    changed = written(before, contents(copy))
    assert changed - {"manifest.json"} == files_of(*(f"planar_rrr_{group}" for group in PLANAR[:4]))
    assert run(copy, "--check")[0] == 0


def test_editing_the_minors(copy):
    """Every unit that has minors or imports them: the closed forms, and what follows the null vector."""
    before = contents(copy)
    edit(copy / "derive/manipulability.py", "MOST_PROJECTED = 16", "MOST_PROJECTED = 15 + 1")
    assert run(copy)[0] == 0
    changed = written(before, contents(copy)) - {"manifest.json"}
    planar = (f"planar_rrr_{group}" for group in (*PLANAR[:4], *FOLLOWED))
    spatial = ("panda_position", "panda_pose", "puma560_position", "puma560_pose")
    following = ("panda_continuation_pose", "panda_redundancy_pose")
    assert changed == files_of(*planar, *spatial, *following, "regional_3r_cuspidality")


def test_editing_a_geometry(copy):
    before = contents(copy)
    edit(copy / "src/chainrule/arms/puma560.toml", "a = 0.4318", "a = 0.4320")
    _, _, errors = run(copy, "--check")
    assert "src/chainrule/arms/puma560.toml: this arm's geometry was edited" in errors
    assert run(copy)[0] == 0
    assert written(before, contents(copy)) - {"manifest.json"} == files_of(*all_of("puma560"))
    assert run(copy, "--check")[0] == 0


def test_editing_a_limit(copy):
    """Limits and inertias are not in the code: nothing is stale, nothing is written."""
    before = contents(copy)
    edit(copy / "src/chainrule/arms/puma560.toml", "[-160, 160]", "[-150, 150]")
    status, said, _ = run(copy)
    assert status == 0 and "nothing" in said
    assert written(before, contents(copy)) == set()


def test_editing_the_lengths_of_a_family(copy):
    """They are inputs of its functions, not in them."""
    before = contents(copy)
    path = copy / "src/chainrule/arms/planar_3r.toml"
    lengths = next(line for line in path.read_text().splitlines() if line.startswith("lengths"))
    edit(path, lengths, "lengths = [0.75, 0.5, 0.125]")
    assert run(copy, "--check")[0] == 0
    assert written(before, contents(copy)) == set()


def test_editing_a_template(copy):
    """Every unit; the shared headers have templates of their own."""
    before = contents(copy)
    edit(copy / "templates/kernel.h.j2", "SI units and radians", "SI units, radians")
    assert run(copy)[0] == 0
    after = contents(copy)
    assert written(before, after) - {"manifest.json"} == files_of(*all_of(*UNITS))
    assert b"SI units, radians" in after["panda/panda_pose.h"][1]


def test_editing_a_shared_template(copy):
    before = contents(copy)
    edit(copy / "templates/real.h.j2", "no allocation. */", "no allocation, no I/O. */")
    assert run(copy)[0] == 0
    changed = written(before, contents(copy)) - {"manifest.json"}
    assert "chainrule_real.h" in changed and not changed & files_of(*all_of(*UNITS))


def test_a_new_and_a_removed_arm(copy):
    before = contents(copy)
    shutil.copy(CHECKOUT.package / "arms/ur5e.toml", copy / "src/chainrule/arms")
    (copy / "src/chainrule/arms/panda.toml").unlink()
    _, _, errors = run(copy, "--check")
    assert "ur5e.toml: this arm is new" in errors and "panda.toml: this arm was removed" in errors
    assert run(copy)[0] == 0
    changed = written(before, contents(copy)) - {"manifest.json"}
    assert changed == files_of(*all_of("panda"), "ur5e_kinematics", "ur5e_position", "ur5e_pose")
    assert run(copy, "--check")[0] == 0


# ---- drift of the files themselves -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (
            lambda g: edit(g / "panda/panda_pose.inc", "const real t1", "const real  t1"),
            "panda/panda_pose.inc was edited by hand",
        ),
        (lambda g: (g / "puma560/puma560_pose.py").unlink(), "puma560/puma560_pose.py is missing"),
        (lambda g: (g / "chainrule_batch.h").write_text("int x;"), "chainrule_batch.h was edited by hand"),
        (
            lambda g: (g / "panda/notes.txt").write_text("mine"),
            "generated/panda/notes.txt: nothing generates this file",
        ),
        (lambda g: (g / "manifest.json").unlink(), "this arm is new"),
    ],
    ids=["edited", "missing", "shared", "stray", "no manifest"],
)
def test_check_says_which_file_and_why(copy, made, spoil, said):
    """And a run without ``--check`` mends it, to the same bytes."""
    spoil(copy / "generated")
    status, _, errors = run(copy, "--check")
    assert status == 1
    assert said in errors
    assert run(copy)[0] == 0
    assert {name: data for name, (_, data) in contents(copy).items()} == {n: d for n, (_, d) in contents(made).items()}


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "[]",
        "{}",
        '{"schema": 1}',
        '{"schema": 2, "arms": {}, "shared": {}, "units": {}}',
        '{"schema": 1, "arms": [], "shared": {}, "units": {}}',
        "\x00",
    ],
)
def test_a_manifest_that_is_not_ours_counts_as_none(tmp_path, text):
    (tmp_path / "manifest.json").write_text(text)
    assert records.read(tmp_path) == {"schema": 1, "arms": {}, "shared": {}, "units": {}}


def test_verify_finds_what_digests_cannot(copy):
    """A file and its digest edited together: only deriving it again tells."""
    path = copy / "generated/puma560/puma560_pose.h"
    manifest = copy / "generated/manifest.json"
    old = records.digest_of(path.read_bytes())
    edit(path, "row by row", "column by column")
    edit(manifest, old, records.digest_of(path.read_bytes()))
    assert run(copy, "--check")[0] == 0
    status, _, errors = run(copy, "--verify")
    assert status == 1
    assert "generated/puma560/puma560_pose.h: deriving it again gives other bytes" in errors


# ---- killed ----------------------------------------------------------------------------------------------------


def test_killed_at_any_moment(copy, made):
    """Every file is then the old one or the new one, whole; the next run finishes the work."""
    edit(copy / "templates/kernel.inc.j2", "/* {{ unit }}.inc", "/*  {{ unit }}.inc")
    edit(copy / "templates/kernel.py.j2", "SI units and radians", "SI units, radians")
    new = Path(shutil.copytree(copy, copy.parent / "new", symlinks=True))
    assert run(new)[0] == 0
    old_files, new_files = contents(made), contents(new)
    random_moments, partly = random.Random(1), 0
    for _ in range(6):
        process = subprocess.Popen(
            command(copy),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd=copy,
            env=environment(copy),
            start_new_session=True,
        )
        watch(copy, process, random_moments.randrange(1, 12))
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        found = contents(copy)
        for name, (_, data) in found.items():
            if name == "manifest.json":
                json.loads(data)
            elif not name.rpartition("/")[2].startswith("."):  # a temporary file is nobody's
                assert data in (old_files[name][1], new_files[name][1]), name
                if name.endswith(".py"):
                    ast.parse(data)
        partly += 0 < sum(found[name][1] != data for name, (_, data) in old_files.items()) < len(old_files) - 1
        for name, (_, data) in old_files.items():  # start over, from the old state
            (copy / "generated" / name).write_bytes(data)
    assert partly >= 2  # some were killed in the middle of the work
    assert run(copy)[0] == 0
    assert {n: d for n, (_, d) in contents(copy).items()} == {n: d for n, (_, d) in new_files.items()}


def watch(root: Path, process: subprocess.Popen[bytes], count: int) -> None:
    """Return when ``count`` files have been written, or the process has ended."""
    start, changed = contents(root), 0
    while process.poll() is None and changed < count:
        with contextlib.suppress(FileNotFoundError):  # a temporary file may be renamed while it is looked at
            changed = len(written(start, contents(root)))
        time.sleep(0.001)


def test_whole_or_not_at_all(tmp_path):
    """A write that fails leaves the old file and nothing else."""
    path = tmp_path / "file"
    records.write_whole(path, "old")
    with pytest.raises(UnicodeEncodeError):
        records.write_whole(path, "new \ud800")
    assert path.read_text() == "old" and list(tmp_path.iterdir()) == [path]
    records.write_whole(tmp_path / "a/b", b"new")
    assert (tmp_path / "a/b").read_bytes() == b"new"


# ---- the parts -------------------------------------------------------------------------------------------------


def test_imports_are_followed():
    """A unit depends on what its derivation imports, however indirectly, and on nothing else."""
    planar = set(records.imported(CHECKOUT, ["chainrule.derive.planar_3r"]))
    assert {"derive/planar_3r.py", "derive/planar.py", "derive/manipulability.py", "derive/program.py"} <= planar
    assert not {"derive/orthogonal_3r.py", "derive/chain.py", "src/chainrule/arm.py"} & planar


def test_two_arms_of_one_name_are_refused():
    from dataclasses import replace

    import chainrule as cr

    panda = cr.load("panda").description
    other = replace(cr.load("ur5e").description, name="panda")
    with pytest.raises(ValueError, match="share the identifier panda"):
        write.planned([panda, other])


def test_pins_are_those_installed():
    """The committed bytes belong to these versions; with others ``--verify`` says so."""
    assert {"sympy", "casadi", "jinja2"} <= records.pins(CHECKOUT).keys()
    for note in write.version_notes(CHECKOUT):
        assert "other versions may write other bytes" in note
