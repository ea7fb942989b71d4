"""The benchmarks: everyone computes the same numbers, and the harness runs and reports. No time is judged."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))

from benchmarks import measure, run, table  # noqa: E402
from benchmarks.breakdown import breakdown  # noqa: E402
from benchmarks.cases import MEMORY, Contender, Unavailable, cases  # noqa: E402

NEEDS = {
    "casadi_peer": "casadi",
    "pinocchio_peer": "pinocchio",
    "toolbox_peer": "roboticstoolbox",
    "sympy_peer": "sympy",
}
CASES = {case.key: case for case in cases()}


@pytest.mark.parametrize("key", CASES)
@pytest.mark.parametrize("peer", NEEDS)
def test_a_peer_computes_the_same_numbers(peer: str, key: str) -> None:
    pytest.importorskip(NEEDS[peer])
    case = CASES[key]
    q = case.configurations(40)
    try:
        others = import_module(f"benchmarks.peers.{peer}").contenders(case, q)
    except Unavailable as reason:
        assert (peer, key) == ("sympy_peer", "panda_gradient"), reason
        return
    ours = run.ours.contenders(case, q)
    assert run.compare(case, [*ours, *others]) < 1e-10
    for contender in others:
        for call in (contender.batch, contender.single):
            if call is not None:
                call()


@pytest.mark.parametrize("key", CASES)
def test_our_single_calls_agree_with_our_batch(key: str) -> None:
    case = CASES[key]
    q = case.configurations(5)
    assert run.compare(case, [*run.ours.contenders(case, q), *run.ours.singles(case, q)]) < 1e-14


def test_a_peer_with_other_numbers_is_named() -> None:
    case = CASES["planar_3r"]
    ours = run.ours.contenders(case, case.configurations(8))
    good = tuple(value.copy() for value in ours[0].results())
    moved = tuple(value + 1e-6 for value in good)
    with pytest.raises(run.Disagreement, match=r"a stranger differs by 1\.0e-06"):
        run.compare(case, [ours[0], Contender("a stranger", 8, None, lambda: moved)])
    broken = tuple(np.full_like(value, np.nan) for value in good)
    with pytest.raises(run.Disagreement, match="a stranger"):
        run.compare(case, [ours[0], Contender("a stranger", 8, None, lambda: broken)])
    idle = Contender("an idler", 8, None, lambda: MEMORY.rows(8, [shape for _, shape in case.outputs]))
    with pytest.raises(run.Disagreement, match="an idler"):
        run.compare(case, [ours[0], idle])


def test_a_timing_is_summarised() -> None:
    timing = measure.Timing((3.0, 1.0, 2.0, 5.0, 4.0))
    assert (timing.median, timing.least) == (3.0, 1.0)
    assert timing.times(measure.Timing((1.5, 0.5, 1.0, 2.5, 2.0))) == 2.0
    counts = {"a": 0, "b": 0}

    def count(name: str) -> None:
        counts[name] += 1

    found = measure.in_turn({"a": (lambda: count("a"), 1), "b": (lambda: count("b"), 2)}, 4, 1e3)
    assert {name: len(timing.rounds) for name, timing in found.items()} == {"a": 4, "b": 4}
    assert all(value > 4 for value in counts.values())


def test_the_parts_add_up() -> None:
    case = CASES["planar_3r"]
    found = breakdown(case, case.configurations(256), 3, 1e4)
    assert found.memory + found.sines + found.terms == pytest.approx(found.whole)
    assert found.outputs == 8 * 9


def test_the_harness_runs_and_reports(tmp_path: Path) -> None:
    rows, notes, facts = run.run(run.Effort(batch=300, rounds=2, least_ns=1e4, starts=0, parts=False))
    who = {row.who for row in rows}
    assert {"chainrule", "chainrule, float32", "chainrule, bound"} <= who
    assert all(row.value > 0 for row in rows if not row.who.startswith("of it"))
    assert all((row.reached is None) == (row.goal == "") for row in rows)
    text = table.as_markdown(rows, notes)
    lines = text.splitlines()
    assert len({line.count("|") for line in lines if line.startswith("|")}) == 1
    assert sum(line.startswith("|") for line in lines) == len(rows) + 2
    again = json.loads(json.dumps(table.as_json(rows, notes, facts)))
    assert len(again["rows"]) == len(rows)
    table.show(rows, notes, "title")


def test_help_needs_nothing() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks", "--help"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0
    assert "--markdown" in done.stdout
