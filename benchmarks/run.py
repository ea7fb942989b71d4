"""The run: everyone's numbers compared, then everyone timed, then one table."""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from itertools import chain
from typing import Any

from benchmarks import cuspidality, planar, redundancy, self_motion, self_motion_7r
from benchmarks.breakdown import breakdown
from benchmarks.cases import MEMORY, TOLERANCE, Array, Case, Contender, Unavailable, cases, disagreement
from benchmarks.measure import Disagreement, Timing, in_turn, pin_to_one_core
from benchmarks.peers import ours
from benchmarks.startup import startup
from benchmarks.table import Row

PEERS = ("casadi_peer", "pinocchio_peer", "toolbox_peer", "sympy_peer")
PACKAGES = ("chainrule", "numpy", "casadi", "pin", "roboticstoolbox-python", "ssik", "sympy")

#: Single precision agrees with double to this, relative to 1 or the value, away from singular configurations.
TOLERANCE_FLOAT = 2e-3

COMPILED = "CasADi, compiled C"
PINOCCHIO = "Pinocchio from Python"

RATIO_TO_PINOCCHIO = 20.0
RATIO_OF_FLOAT = 1.6
GENERATED_S, CACHED_S, IMPORT_S = 5.0, 0.05, 0.3

Progress = Callable[[str], None]

#: Questions by topic; the other topics are ``kernels`` and ``start-up``.
QUESTIONS = {
    "planar": planar,
    "cuspidality": cuspidality,
    "self-motion": self_motion,
    "self-motion-7r": self_motion_7r,
    "redundancy": redundancy,
}
TOPICS = ("kernels", *QUESTIONS, "start-up")


@dataclass(frozen=True)
class Effort:
    """How much is measured.

    Attributes:
        batch: configurations in a batch.
        rounds: how often everyone is timed.
        least_ns: about how long one measurement takes at least.
        starts: fresh processes for each start-up time; 0 leaves them out.
        parts: whether to take our kernels apart.
    """

    batch: int = 100_000
    rounds: int = 15
    least_ns: float = 2e7
    starts: int = 9
    parts: bool = True


def contenders(case: Case, q: Array) -> tuple[list[Contender], list[str]]:
    """Everyone who computes the case, ours first, and a note for each who cannot."""
    found, notes = [*ours.contenders(case, q), *ours.singles(case, q)], []
    for name in PEERS:
        try:
            found += import_module(f"benchmarks.peers.{name}").contenders(case, q)
        except Unavailable as reason:
            notes.append(str(reason))
    return found, notes


def compare(case: Case, everyone: list[Contender]) -> float:
    """The largest difference in double; everyone is to give the same numbers before anyone is timed.

    Raises:
        Disagreement: naming who differs and by how much.
    """
    reference = tuple(value.copy() for value in everyone[0].results())
    worst = 0.0
    for contender in everyone:
        single = "float32" in contender.name
        MEMORY.blank()
        difference = disagreement(case, reference, contender.results())
        if not difference <= (TOLERANCE_FLOAT if single else TOLERANCE):
            raise Disagreement(f"{case.title}: {contender.name} differs by {difference:.1e}")
        worst = worst if single else max(worst, difference)
    return worst


def run(
    effort: Effort, progress: Progress = lambda line: None, topics: Collection[str] = TOPICS
) -> tuple[list[Row], list[str], dict[str, Any]]:
    """Measure everything, or some :data:`TOPICS`.

    Returns:
        The rows, the notes under them, and the facts of the machine.
    """
    facts = _facts(effort)
    notes: list[str] = []
    batches: list[Row] = []
    singles: list[Row] = []
    parts: list[Row] = []
    asked: list[Row] = []
    timed = effort.starts and "start-up" in topics
    start = _startup_rows(effort, progress) if timed else []  # before pinning: two types compile side by side
    affinity = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else None
    facts["core"] = pin_to_one_core()
    try:
        for case in cases() if "kernels" in topics else ():
            progress(f"{case.title}: comparing")
            q = case.configurations(effort.batch)
            everyone, missing = contenders(case, q)
            worst = compare(case, everyone)
            notes += [*missing, f"{case.title}: everyone agrees to {worst:.0e}."]
            progress(f"{case.title}: timing batches")
            batches += _batch_rows(case, everyone, effort)
            progress(f"{case.title}: timing single calls")
            singles += _single_rows(case, everyone, effort)
            if effort.parts:
                progress(f"{case.title}: taking ours apart")
                parts += _part_rows(case, q, effort)
        asking = (part.questions(effort.batch) for topic, part in QUESTIONS.items() if topic in topics)
        for section, ways, note in chain.from_iterable(asking):
            progress(f"{section}: comparing and timing")
            worst = planar.agreement(ways)
            notes += [f"{section}: everyone agrees to {worst:.0e}."] if worst else []
            notes += [note] if note else []
            asked += planar.rows(section, ways, effort.rounds, effort.least_ns)
    finally:
        if affinity is not None:
            os.sched_setaffinity(0, affinity)
    return [*batches, *singles, *parts, *asked, *start], list(dict.fromkeys(notes)), facts


def _batch_rows(case: Case, everyone: list[Contender], effort: Effort) -> list[Row]:
    found = in_turn({c.name: (c.batch, c.count) for c in everyone if c.batch}, effort.rounds, effort.least_ns)
    mine = found["chainrule"]
    rows = []
    for name, timing in found.items():
        row = _row(f"{case.title}; batch of {effort.batch:,}", name, timing, mine)
        if name.startswith(COMPILED):
            row = _at_least(row, timing.times(mine), case.ratio_to_c, "ours")
        elif name == PINOCCHIO:
            row = _at_least(row, timing.times(mine), RATIO_TO_PINOCCHIO, "ours")
        elif name.endswith("float32"):
            row = _at_least(row, mine.times(timing), RATIO_OF_FLOAT, "double")
        rows.append(row)
    return rows


def _single_rows(case: Case, everyone: list[Contender], effort: Effort) -> list[Row]:
    found = in_turn({c.name: (c.single, 1) for c in everyone if c.single}, effort.rounds, effort.least_ns / 4)
    mine = found["chainrule, bound"]
    quickest = min(
        (timing for name, timing in found.items() if "buffered" in name), key=lambda timing: timing.median, default=None
    )
    rows = []
    for name, timing in found.items():
        row = _row(f"{case.title}; single call", name, timing, mine)
        if name.startswith("chainrule") and quickest is not None:
            row = replace(row, goal="below CasADi's quickest buffered call", reached=quickest.times(timing) > 1.0)
        rows.append(row)
    return rows


def _part_rows(case: Case, q: Array, effort: Effort) -> list[Row]:
    found = breakdown(case, q, effort.rounds, effort.least_ns / 2)
    section = f"{case.title}; where our time goes"
    named = (
        ("the kernel, called from C", found.whole),
        ("of it memory: rows in, rows out", found.memory),
        ("of it sines and cosines", found.sines),
        ("of it the other terms", found.terms),
        ("the kernel, batches of 1,000 (in cache)", found.cached),
        (f"NumPy filling the same {found.outputs} bytes", found.fill),
    )
    return [
        Row(section, name, value, "ns", found.spread if k == 0 else None, value / found.whole)
        for k, (name, value) in enumerate(named)
    ]


def _startup_rows(effort: Effort, progress: Progress) -> list[Row]:
    progress("start-up times")
    found, section = startup(effort.starts), "start-up, quickest of some processes, without the interpreter's"

    def below(who: str, seconds: float, goal: float) -> Row:
        unit, scale = ("s", 1.0) if goal >= 1.0 else ("ms", 1e3)
        return Row(section, who, seconds * scale, unit, goal=f"below {goal * scale:g} {unit}", reached=seconds < goal)

    return [
        below("import chainrule", found.bare, IMPORT_S),
        below("import and first use (NumPy loaded)", found.full, IMPORT_S),
        below("a changed Panda: description to loaded kernels", found.generated, GENERATED_S),
        Row(section, "the same, processor time", found.generated_cpu, "s"),
        below("the same from the cache, new process", found.cached, CACHED_S),
        Row(section, "before that: reading the description", found.cached_load * 1e3, "ms"),
    ]


def _row(section: str, name: str, timing: Timing, mine: Timing) -> Row:
    return Row(section, name, timing.median, "ns", timing.spread, timing.times(mine))


def _at_least(row: Row, ratio: float, goal: float, what: str) -> Row:
    """The goal that ours (or float32) is ``goal`` times faster, and whether ``ratio`` reaches it."""
    words = f"ours {goal:g} times faster" if what == "ours" else f"{goal:g} times faster than double"
    return replace(row, goal=words, reached=ratio >= goal)


def _facts(effort: Effort) -> dict[str, Any]:
    from chainrule.compile import compiler, instruction_set

    return {
        "processor": _processor(),
        "instruction set": instruction_set(),
        "python": platform.python_version(),
        "compiler": _compiler_version(compiler()),
        "packages": {name: _version(name) for name in PACKAGES},
        "batch": effort.batch,
        "rounds": effort.rounds,
    }


def _processor() -> str:
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            found = dict(line.split(":", 1) for line in lines if ":" in line)
        values = {key.strip(): value.strip() for key, value in found.items()}
        return f"{values['model name']}, family {values['cpu family']} model {values['model']}"
    except (OSError, KeyError, ValueError):
        return platform.processor() or platform.machine()


def _compiler_version(command: list[str] | None) -> str:
    import subprocess

    if command is None:
        return "none"
    done = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[0] if done.stdout else command[0]


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"
