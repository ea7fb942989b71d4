"""What several sections need, computed once and on first use."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.checks import Check, checks
from chainrule.manipulability import (
    ManipulabilityMap,
    Maximum,
    depends_on,
    manipulability_map,
    max_manipulability,
    min_manipulability,
)
from chainrule.reach import Reach, reach
from chainrule.search import Found, box
from chainrule.tables import Table, functions

Array = NDArray[Any]


class Context:
    """Shared results of one report."""

    def __init__(self, arm: Arm, progress: Callable[[str], None] = lambda line: None) -> None:
        self.arm = arm
        self.progress = progress
        #: What the sections built so far say of themselves for the summary: key, title and sentence.
        self.headlines: list[tuple[str, str, str]] = []

    @cached_property
    def task(self) -> str | None:
        """The task the report speaks of: the arm's own, or the largest with no more rows than joints; None without."""
        known = self.arm.full_rank_tasks
        if not known:
            return None
        return self.arm.default_task if self.arm.default_task in known else known[-1]

    @cached_property
    def maximum(self) -> Maximum:
        """The largest H, with its proof where one can be had."""
        self.progress("searching for the largest manipulability")
        return max_manipulability(
            self.arm, self.task, progress=lambda line: self.progress(f"largest manipulability: {line}")
        )

    @cached_property
    def minimum(self) -> Found:
        """The smallest H met."""
        self.progress("searching for singular configurations")
        return min_manipulability(self.arm, self.task)

    @cached_property
    def depends_on(self) -> tuple[int, ...]:
        """The joints (from 0) that H depends on."""
        return depends_on(self.arm, self.task)

    @cached_property
    def map(self) -> ManipulabilityMap:
        """H over the two joints where it varies most, the others at the posture of the largest H."""
        largest = self.maximum
        self.progress("drawing the manipulability map")
        return manipulability_map(self.arm, self.task, largest=largest)

    @cached_property
    def reach(self) -> Reach:
        """How far the tip gets."""
        self.progress("measuring the reach")
        return reach(self.arm)

    @cached_property
    def functions(self) -> Table:
        """What is generated."""
        return functions(self.arm)

    @cached_property
    def checks(self) -> tuple[Check, ...]:
        """The checks, made now."""
        return checks(self.arm, self.progress)

    @cached_property
    def posture(self) -> Array:
        """The posture the arm is drawn in: that of the largest H, or the middle of the ranges."""
        found: Array = box(self.arm).mean(axis=1) if self.task is None else self.maximum.q
        return found
