"""Parts of a kernel that matter only where a condition is not 0: compiled code passes over them elsewhere.

``where(c, y)`` is y, and 0 where c is 0. The values that nothing but the second arguments of a condition's wheres needs
are a part: a tile of configurations whose c are all 0 does without it, and every where is 0. Results do not depend on
what was passed over, so no configuration notices its neighbours.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass

from chainrule.derive.lower import Kernel

#: Operations of a part from which on passing over it is worth the test, and of a kernel that is cut into pieces anyway.
LEAST_OPERATIONS = 80
LONG = 800


@dataclass(frozen=True)
class Part:
    """What is needed only where a value, the condition, is not 0.

    Attributes:
        condition: index of the value.
        values: indices of what is needed there only, and of the results.
        results: indices of the wheres.
    """

    condition: int
    values: frozenset[int]
    results: tuple[int, ...]


@dataclass(frozen=True)
class Block:
    """Values computed one after another, always or (with a part) where the part is needed."""

    indices: tuple[int, ...]
    part: Part | None


def blocks(kernel: Kernel) -> tuple[Block, ...]:
    """A kernel's values in an order in which every part is in one piece; as they are where there is none."""
    found: list[Part] = []
    for part in parts(kernel):
        if not _ordered(kernel, [*found, part])[1]:  # else it needs what follows from its own results
            found.append(part)
    return _ordered(kernel, found)[0]


def parts(kernel: Kernel) -> list[Part]:
    """The parts worth passing over, the largest first; none has a value of another."""
    if kernel.operations < LONG:
        return []
    wheres: dict[int, list[int]] = {}
    users: list[set[int]] = [set() for _ in kernel.values]
    kept = {entry for entries in kernel.results for entry in entries if isinstance(entry, int)}
    for index, value in enumerate(kernel.values):
        if value.op == "input":
            continue
        for operand in value.args:
            if isinstance(operand, int):
                users[operand].add(index)
        if value.op == "where" and isinstance(value.args[0], int):
            wheres.setdefault(value.args[0], []).append(index)
    found = [part for c, results in wheres.items() if (part := _part(kernel, users, kept, c, results))]
    chosen: list[Part] = []
    for part in sorted(found, key=lambda part: (-len(part.values), part.condition)):
        if not any(part.values & other.values for other in chosen):
            chosen.append(part)
    return chosen


def _part(kernel: Kernel, users: list[set[int]], kept: set[int], condition: int, results: list[int]) -> Part | None:
    inside: set[int] = set()
    ends = set(results)
    for index in range(max(results) - 1, -1, -1):
        value = kernel.values[index]
        if value.op in ("input", "sin", "cos") or index == condition or index in kept or not users[index]:
            continue
        if all(user in inside or (user in ends and kernel.values[user].args[0] != index) for user in users[index]):
            inside.add(index)
    if len(inside) < LEAST_OPERATIONS:
        return None
    outward = tuple(index for index in results if index not in inside)
    return Part(condition, frozenset(inside | ends), outward)


def _ordered(kernel: Kernel, found: list[Part]) -> tuple[tuple[Block, ...], set[int]]:
    """Blocks in a topological order that is the values' own where it can be; and the values that no order reaches."""
    part_of = {index: part for part in found for index in part.values}
    first = {part: min(part.values) for part in found}
    waits: dict[int, int] = {}  # of a value or, under its first value, of a part: what it still waits for
    followers: dict[int, list[int]] = {}

    def node(index: int) -> int:
        return first[part_of[index]] if index in part_of else index

    for index, value in enumerate(kernel.values):
        waits.setdefault(node(index), 0)
        needs = {node(a) for a in value.args if isinstance(a, int)} if value.op != "input" else set()
        for need in needs - {node(index)}:
            waits[node(index)] += 1
            followers.setdefault(need, []).append(node(index))
    ready = [index for index, count in waits.items() if count == 0]
    heapq.heapify(ready)
    ordered: list[Block] = []
    plain: list[int] = []
    left = set(range(len(kernel.values)))
    while ready:
        index = heapq.heappop(ready)
        part = part_of.get(index)
        taken = sorted(part.values) if part else [index]
        left -= set(taken)
        if part:
            ordered += [Block(tuple(plain), None)] if plain else []
            ordered.append(Block(tuple(taken), part))
            plain = []
        else:
            plain.append(index)
        for follower in followers.get(index, ()):
            waits[follower] -= 1
            if waits[follower] == 0:
                heapq.heappush(ready, follower)
    return (*ordered, Block(tuple(plain), None)), left
