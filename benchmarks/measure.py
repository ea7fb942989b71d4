"""Timing on a shared machine: one core, processor time, everyone in turn, medians of rounds."""

from __future__ import annotations

import os
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass


class Disagreement(Exception):
    """Two ways of computing the same thing differ: nothing is timed then."""


@dataclass(frozen=True)
class Timing:
    """Nanoseconds of one evaluation over the rounds.

    Attributes:
        rounds: one number for each round.
    """

    rounds: tuple[float, ...]

    @property
    def median(self) -> float:
        """The middle round."""
        return statistics.median(self.rounds)

    @property
    def least(self) -> float:
        """The best round."""
        return min(self.rounds)

    @property
    def spread(self) -> float:
        """Half of what lies between the quartiles, over the median."""
        if len(self.rounds) < 4:
            return (max(self.rounds) - min(self.rounds)) / 2 / self.median
        low, _, high = statistics.quantiles(self.rounds, n=4)
        return (high - low) / 2 / self.median

    def times(self, other: Timing) -> float:
        """How many times longer this takes than ``other``: the median of the rounds' ratios."""
        return statistics.median(a / b for a, b in zip(self.rounds, other.rounds, strict=True))


def pin_to_one_core() -> int | None:
    """Keep this process on one core (the last it may use); None where the system has no such call."""
    if not hasattr(os, "sched_setaffinity"):
        return None
    core = max(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {core})
    return core


def once(task: Callable[[], object], repeats: int) -> float:
    """Processor time of this thread for ``repeats`` calls, in ns: what other processes take does not count."""
    start = time.thread_time_ns()
    for _ in range(repeats):
        task()
    return float(time.thread_time_ns() - start)


def in_turn(tasks: Mapping[str, tuple[Callable[[], object], int]], rounds: int, least_ns: float) -> dict[str, Timing]:
    """Time every task in every round, one after the other, starting with another one each time.

    Args:
        tasks: by name, the call and how many evaluations it makes.
        rounds: how often everyone is timed.
        least_ns: a measurement repeats its call until it takes at least about this long.
    """
    repeats = {}
    for name, (task, _) in tasks.items():
        task()
        number = 1
        while (spent := once(task, number)) < least_ns / 8:
            number *= 4
        repeats[name] = max(1, round(number * least_ns / max(spent, 1.0)))
    found: dict[str, list[float]] = {name: [] for name in tasks}
    names = list(tasks)
    for k in range(rounds):
        for name in names[k % len(names) :] + names[: k % len(names)]:
            task, count = tasks[name]
            found[name].append(once(task, repeats[name]) / (repeats[name] * count))
    return {name: Timing(tuple(values)) for name, values in found.items()}
