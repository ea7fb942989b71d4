"""The types of the public interface, as a user's type checker sees them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]

#: Mistakes that types catch, and the code of mypy's complaint: they would pass if the interface said nothing.
MISTAKES = {
    "arm.jacobian([0.0], task=3)": "arg-type",
    "arm.jacobean([0.0])": "attr-defined",
    "length: str = cr.self_motion(arm, [0.4, 0.0]).length": "assignment",
    'cr.load("panda", tipp="tool")': "call-arg",
    "cr.workspase(arm)": "attr-defined",
    'cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0).posture_change([0.0], [0.0]).certified + "yes"': "operator",
}


def test_a_users_script_is_checked_strictly(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.py"
    wrong.write_text("\n".join(['import chainrule as cr\narm = cr.load("panda")', *MISTAKES, ""]), "utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "--config-file", ROOT / "pyproject.toml"]
    files = [ROOT / "tests" / "user_script.py", wrong]
    done = subprocess.run(
        [*map(str, command), "--cache-dir", str(tmp_path / "cache"), *map(str, files)],
        capture_output=True,
        text=True,
        check=False,
    )
    found = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert not [line for line in found if "wrong.py" not in line], done.stdout + done.stderr
    said = {int(line.split(":")[1]): line.rsplit("[", 1)[1].rstrip("]") for line in found}
    assert said == dict(enumerate(MISTAKES.values(), start=3)), done.stdout
