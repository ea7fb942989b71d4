"""The arm in a few plain sentences and numbers."""

from __future__ import annotations

import math

import numpy as np

from chainrule.arm import Arm
from chainrule.manipulability import unit
from chainrule.report.content import Facts, Finding, Headlines, Part, Prose
from chainrule.report.context import Context
from chainrule.report.sections import SUMMARY, Section
from chainrule.search import FREE_TRAVEL
from chainrule.tables import readable

_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")


def count_word(number: int) -> str:
    """A small number in words."""
    return _COUNTS[number] if number < len(_COUNTS) else str(number)


def plural(number: int, word: str) -> str:
    """``one joint``, ``two joints``."""
    return f"{count_word(number)} {word}{'' if number == 1 else 's'}"


def _joints(arm: Arm) -> str:
    turning, sliding = arm.kinds.count("R"), arm.kinds.count("P")
    if not sliding:
        return f"{plural(turning, 'revolute joint')}"
    if not turning:
        return f"{plural(sliding, 'prismatic joint')}"
    return f"{plural(turning, 'revolute joint')} and {plural(sliding, 'prismatic joint')} ({arm.kinds})"


def _redundancy(arm: Arm, context: Context) -> str:
    task = context.task
    if task is None:
        return (
            f"With {plural(arm.n, 'joint')} it cannot control any of the tasks fully, so this report leaves out what "
            "needs a task with no more rows than joints."
        )
    rows = arm.tasks[task]
    spare = arm.n - rows
    if task == "pose":
        controlled = "the position and orientation"
    elif task == "x_alpha":
        controlled = "one coordinate and the orientation"
    else:
        controlled = "the position"
    if spare == 0:
        return f"They control {controlled} of the tip ({plural(rows, 'number')}), with no joint to spare."
    return (
        f"They control {controlled} of the tip ({plural(rows, 'number')}), with {plural(spare, 'joint')} to spare: "
        "the arm is redundant, and can move without moving its tip."
    )


def _largest(arm: Arm) -> str:
    """What the largest H is called: without limits on a slide it is one inside the range searched."""
    slides = np.array([kind == "P" for kind in arm.kinds]) & ~np.isfinite(arm.limits.position).all(axis=1)
    return "largest manipulability H" + (f" (slides within ±{FREE_TRAVEL:g} m)" if slides.any() else "")


def _build(arm: Arm, context: Context) -> Part:
    planar = "x_alpha" in arm.tasks
    where = "in a plane" if planar else "in space"
    reach, table = context.reach, context.functions
    operations = sum(row[3] for row in table.rows if isinstance(row[3], int))
    blocks: list[Finding | Facts | Prose | Headlines] = [
        Prose(f"{arm.name} is an arm with {_joints(arm)} that moves {where}. {_redundancy(arm, context)}")
    ]
    pairs = [("joints", f"{arm.n} ({arm.kinds})")]
    if context.task is not None:
        height = float(arm.manipulability(context.maximum.q, task=context.task))
        text = f"{height:.4g}{unit(arm, context.task).suffix}" + (
            ", proved" if context.maximum.proved and math.isfinite(context.maximum.value) else ""
        )
        pairs += [("task", f"{context.task}, {arm.tasks[context.task]} rows"), (_largest(arm), text)]
    pairs.append(
        ("reach from the base", f"{readable(reach.farthest.value, 5)} m" if math.isfinite(reach.bound) else "unlimited")
    )
    pairs.append(("generated functions", f"{len(table.rows)}, {readable(operations)} operations"))
    failed = [check for check in context.checks if not check.passed]
    total = len(context.checks)
    pairs.append(("checks", f"{total - len(failed)} of {total} passed"))
    blocks.append(Facts(tuple(pairs)))
    if context.headlines:
        blocks.append(Headlines(tuple(context.headlines)))
    if failed:
        blocks.append(
            Finding(
                f"{len(failed)} of {total} checks failed: see the last section before using the numbers on this page.",
                tone="bad",
            )
        )
    else:
        worst = max((c for c in context.checks if c.bound <= 1e-9), key=lambda c: c.worst)
        blocks.append(
            Finding(
                f"All {total} checks of the generated code passed; the worst error in double precision is "
                f"{readable(worst.worst, 2)}.",
                tone="good",
            )
        )
    said = [line for *_, line in context.headlines]
    return Part(tuple(blocks), {"name": arm.name, "kinds": arm.kinds, "task": context.task, "findings": said})


SECTION = Section(SUMMARY, "Summary", lambda arm: True, _build)
