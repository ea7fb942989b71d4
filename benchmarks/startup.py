"""Times before the first number: importing, description to kernels, kernels from the cache; in fresh processes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from chainrule import arms
from chainrule.compile import CACHE_VARIABLE

#: Pose and Jacobian; minors, H, its gradient (and null vector and projector).
GROUPS = ("kinematics", "pose")

BARE = """
import json, sys, time
sys.modules.pop("chainrule", None)
start = time.perf_counter()
import chainrule
print(json.dumps([time.perf_counter() - start]))
"""

STEPS = """
import json, resource, sys, time
now = time.perf_counter
def cpu():
    return sum(sum(resource.getrusage(who)[:2]) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
marks = [now()]
import chainrule as cr
marks.append(now())
cr.Arm
marks.append(now())
path, groups = sys.argv[1], sys.argv[2].split(",")
if path:
    arm = cr.load(path)
    marks.append(now())
    before = cpu()
    arm.prepare(groups=groups)
    marks.append(now())
    for name in ("kinematics_pose", "minors_pose", "manipulability_pose", "manipulability_gradient_pose"):
        assert arm.evaluator(name).compiled
print(json.dumps([*(b - a for a, b in zip(marks, marks[1:])), cpu() - before if path else 0.0]))
"""


@dataclass(frozen=True)
class Startup:
    """The quickest of some fresh processes, in seconds of the clock; the interpreter's start is in none of them.

    The quickest, because processes and the disk wait for whatever else the machine does.

    Attributes:
        bare: ``import chainrule``.
        full: ``import chainrule`` and its first use, which loads NumPy and the runtime.
        generated: a description unknown until now (the file, read, derived, emitted and compiled for two types) to
            loaded kernels, with an empty cache.
        generated_cpu: processor time of that, all processes together.
        cached: ``prepare`` in a fresh process once the cache has it: checked, loaded, evaluators made.
        cached_load: reading the description before that.
    """

    bare: float
    full: float
    generated: float
    generated_cpu: float
    cached: float
    cached_load: float


def startup(repeats: int) -> Startup:
    """Measure; the arm is the Panda under another name and with another flange, so that nothing installed fits."""
    with tempfile.TemporaryDirectory(prefix="benchmark-startup-") as temporary:
        folder = Path(temporary)
        path = folder / "benchmark_arm.toml"
        path.write_text(_changed(arms.path("panda").read_text("utf-8")), "utf-8")
        groups = ",".join(GROUPS)
        first = [_run(STEPS, folder / f"cache{k}", str(path), groups) for k in range(max(1, repeats // 3))]
        again = [_run(STEPS, folder / "cache0", str(path), groups) for _ in range(repeats)]
        full = [_run(STEPS, folder / "cache0", "", groups) for _ in range(repeats)]
        bare = [_run(BARE, folder / "cache0") for _ in range(repeats)]
    return Startup(
        bare=min(r[0] for r in bare),
        full=min(r[0] + r[1] for r in full),
        generated=min(r[2] + r[3] for r in first),
        generated_cpu=min(r[4] for r in first),
        cached=min(r[3] for r in again),
        cached_load=min(r[2] for r in again),
    )


def _changed(text: str) -> str:
    """The description with another name and another tool."""
    changed = text.replace('name = "panda"', 'name = "benchmark_arm"')
    changed = changed.replace("xyz = [0, 0, 0.107]", "xyz = [0, 0.01, 0.2]")
    if changed.count("benchmark_arm") != 1 or "0.01, 0.2" not in changed:
        raise RuntimeError("the embedded description of the Panda no longer reads as this benchmark expects")
    return changed


def _run(code: str, cache: Path, *arguments: str) -> list[float]:
    environment = {**os.environ, CACHE_VARIABLE: str(cache)}
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise RuntimeError(f"the start-up measurement failed: {done.stderr.strip().splitlines()[-1:]}")
    found: list[float] = json.loads(done.stdout)
    return found
