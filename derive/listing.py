"""A kernel as readable statements: names, nested expressions, sections; what the templates print.

Values used once are written inside the expression that uses them, up to a few operations. A long listing is cut
into sections, each one loop over the tile; a value needed in a later section is kept in an array whose places are
used again. Sections of a part (skipping.py) run only where it is needed.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from chainrule.derive.lower import Kernel, Operand, Value
from chainrule.derive.skipping import Block, Part
from chainrule.errors import GenerationError

#: Operations in one printed expression.
MOST_NESTED = 6
#: Statements in one section. A longer listing is cut into sections of CUT: compilers' time grows faster than length.
MOST_STATEMENTS = 400
CUT = 100

_PRECEDENCE = {"add": 1, "sub": 1, "mul": 2, "div": 2, "inv": 2, "neg": 2}
_SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


@dataclass(frozen=True)
class Language:
    """How a language writes constants and the functions that are not operators."""

    constant: Callable[[float], str]
    call: dict[str, str]  # sqrt, abs, where (with {0}, {1})


C = Language(
    lambda x: f"CR_C({x!r})",
    {
        "sqrt": "CR_SQRT({0})",
        "abs": "CR_FABS({0})",
        "where": "({0} != CR_C(0.0) ? {1} : CR_C(0.0))",
        "min": "chainrule_min({0}, {1})",
        "max": "chainrule_max({0}, {1})",
        "atan2": "CR_ATAN2({0}, {1})",
        "copysign": "CR_COPYSIGN({0}, {1})",
    },
)
#: Whole numbers are written as such, so that polynomials stay exact on integers and fractions.
NUMPY = Language(
    lambda x: repr(int(x)) if x.is_integer() and 0 < abs(x) < 2**53 else repr(x),
    {
        "sqrt": "np.sqrt({0})",
        "abs": "np.abs({0})",
        "where": "np.where({0} != 0.0, {1}, 0.0)",
        "min": "np.minimum({0}, {1})",
        "max": "np.maximum({0}, {1})",
        "atan2": "np.arctan2({0}, {1})",
        "copysign": "np.copysign({0}, {1})",
    },
)


@dataclass(frozen=True)
class Run:
    """Neighbouring entries of one input whose sines and cosines are computed together."""

    port: str
    entry: int
    angle: int
    count: int


@dataclass(frozen=True)
class Skip:
    """When a part of the sections is passed over, and what that leaves: places are arrays with a row.

    Attributes:
        condition: where the condition is; only where it is 0 throughout is the part passed over.
        zeros: rows of ``kept`` that are 0 then.
    """

    condition: tuple[str, int]
    zeros: tuple[int, ...]


@dataclass(frozen=True)
class Section:
    """One loop: values loaded, terms computed, entries stored; ``skip`` is the same for all sections of a part."""

    loads: tuple[str, ...]
    terms: tuple[str, ...]
    stores: tuple[str, ...]
    skip: Skip | None = None

    def mentions(self, array: str) -> bool:
        """Whether the section reads or writes an array."""
        return any(line.startswith(f"{array}[") for line in self.stores) or any(
            f" {array}[" in line for line in self.loads
        )


@dataclass(frozen=True)
class Statement:
    """A named value: its index, its text and the named values its text reads."""

    index: int
    text: str
    reads: tuple[int, ...]


class Listing:
    """The statements of a kernel in one language, before they are laid out."""

    def __init__(self, kernel: Kernel, language: Language, blocks: Sequence[Block] = ()) -> None:
        """Of all values in their order or, with ``blocks``, in theirs."""
        self.kernel, self.language = kernel, language
        self.blocks = tuple(blocks) or (Block(tuple(range(len(kernel.values))), None),)
        self.angles = _angles(kernel)
        self.names = _leaf_names(kernel, self.angles)
        self._texts: dict[int, tuple[str, int, int, tuple[int, ...]]] = {}
        uses = [0] * len(kernel.values)
        for operand in [a for v in kernel.values if v.op != "input" for a in v.args] + [
            e for out in kernel.results for e in out
        ]:
            if isinstance(operand, int):
                uses[operand] += 1
        # What decides over a part, and what comes out of it, is needed by name.
        named = {i for block in self.blocks if block.part for i in (block.part.condition, *block.part.results)}
        self.statements: list[Statement] = []
        self.ends: list[int] = []  # of each block, among the statements
        for block in self.blocks:
            for index in block.indices:
                if index in self.names:
                    continue
                text, precedence, size, reads = self._expression(kernel.values[index])
                if uses[index] == 1 and size <= MOST_NESTED and index not in named:
                    self._texts[index] = (text, precedence, size, reads)
                else:
                    self.names[index] = f"t{len(self.statements) + 1}"
                    self.statements.append(Statement(index, text, reads))
            self.ends.append(len(self.statements))

    def text(self, operand: Operand) -> str:
        """An entry of the results, as text."""
        return self._operand(operand)[0]

    def reads(self, operand: Operand) -> tuple[int, ...]:
        """The named values that this text reads."""
        return self._operand(operand)[3]

    def _operand(self, operand: Operand) -> tuple[str, int, int, tuple[int, ...]]:
        if isinstance(operand, float):
            return self.language.constant(operand), 4 if operand >= 0 else 3, 0, ()
        if operand in self.names:
            return self.names[operand], 4, 0, (operand,)
        return self._texts[operand]

    def _expression(self, value: Value) -> tuple[str, int, int, tuple[int, ...]]:
        parts = [self._operand(a) for a in value.args]
        size = 1 + sum(part[2] for part in parts)
        reads = tuple(dict.fromkeys(r for part in parts for r in part[3]))
        op, level = value.op, _PRECEDENCE.get(value.op, 4)

        def side(k: int, least: int) -> str:
            return parts[k][0] if parts[k][1] >= least else f"({parts[k][0]})"

        if op in _SIGN:
            # The right side of - and / binds one tighter; so does that of + and *, to keep the order of evaluation.
            return f"{side(0, level)} {_SIGN[op]} {side(1, level + 1)}", level, size, reads
        if op == "neg":
            return f"-{side(0, 3)}", 3, size, reads
        if op == "inv":
            return f"{self.language.constant(1.0)} / {side(0, 3)}", level, size, reads
        return self.language.call[op].format(side(0, 4), parts[-1][0]), 4, size, reads


def _angles(kernel: Kernel) -> dict[tuple[int, int], int]:
    """The angle number of each input entry whose sine or cosine is taken, in the order of the inputs."""
    found = set()
    for value in kernel.values:
        if value.op in ("sin", "cos"):
            source = kernel.values[value.args[0]] if isinstance(value.args[0], int) else None
            if source is None or source.op != "input":
                raise GenerationError(
                    f"{kernel.name}: sine or cosine of something that is not an input entry; "
                    "write it with the addition theorem"
                )
            found.add((int(source.args[0]), int(source.args[1])))
    return {entry: number for number, entry in enumerate(sorted(found))}


def _leaf_names(kernel: Kernel, angles: dict[tuple[int, int], int]) -> dict[int, str]:
    names = {}
    for index, value in enumerate(kernel.values):
        if value.op == "input":
            names[index] = kernel.inputs[int(value.args[0])].labels[int(value.args[1])]
        elif value.op in ("sin", "cos"):
            source = kernel.values[int(value.args[0])]
            port, entry = kernel.inputs[int(source.args[0])], int(source.args[1])
            label = port.labels[entry]
            names[index] = f"{value.op[0]}{entry + 1}" if port.name == "q" else f"{value.op}_{label}"
    return names


def runs(kernel: Kernel, angles: dict[tuple[int, int], int]) -> tuple[Run, ...]:
    """Maximal runs of neighbouring entries among the angles."""
    found: list[Run] = []
    for (port, entry), angle in angles.items():
        last = found[-1] if found else None
        name = kernel.inputs[port].name
        if last and last.port == name and last.entry + last.count == entry:
            found[-1] = Run(name, last.entry, last.angle, last.count + 1)
        else:
            found.append(Run(name, entry, angle, 1))
    return tuple(found)


def leaf_source(kernel: Kernel, angles: dict[tuple[int, int], int], index: int) -> tuple[str, int]:
    """Where a leaf comes from: array (an input's name, ``sine`` or ``cosine``) and row."""
    value = kernel.values[index]
    if value.op == "input":
        return kernel.inputs[int(value.args[0])].name, int(value.args[1])
    source = kernel.values[int(value.args[0])]
    return {"sin": "sine", "cos": "cosine"}[value.op], angles[int(source.args[0]), int(source.args[1])]


@dataclass(frozen=True)
class Layout:
    """A listing cut into sections, with the number of kept values that are alive at once."""

    sections: tuple[Section, ...]
    slots: int


def lay_out(listing: Listing) -> Layout:
    """Cut into sections and give every value that crosses a cut a place in ``kept``."""
    kernel, statements = listing.kernel, listing.statements
    position = {s.index: k for k, s in enumerate(statements)}
    cuts, part_of = _cuts(listing)
    section_of = [number for number, (start, end) in enumerate(cuts) for _ in range(start, end)]

    def stored_in(last: int) -> int:
        """The section that stores what a statement completes: the next one that is never passed over."""
        number = section_of[last] if statements else 0
        return next(k for k in range(number, len(cuts)) if part_of[k] is None)

    entries: list[tuple[int, str, tuple[int, ...]]] = []
    for port, results in zip(kernel.outputs, kernel.results, strict=True):
        for row, operand in enumerate(results):
            reads = listing.reads(operand)
            last = max((position[r] for r in reads if r in position), default=0)
            entries.append((stored_in(last), f"{port.name}[{row} * LANES + i] = {listing.text(operand)}", reads))
    last_use: dict[int, int] = {}
    uses = [(section_of[k], s.reads) for k, s in enumerate(statements)] + [(at, reads) for at, _, reads in entries]
    for number, reads in uses:
        for read in reads:
            if read in position:
                last_use[read] = max(last_use.get(read, 0), number)
    free: list[int] = []
    slots = 0
    slot_of: dict[int, int] = {}
    rows: dict[int, int] = {}  # of every value that was ever kept
    found = []
    for number, (start, end) in enumerate(cuts):
        for read in [r for r, s in slot_of.items() if last_use[r] < number]:
            heapq.heappush(free, slot_of.pop(read))
        mine = statements[start:end]
        stored = [(text, reads) for at, text, reads in entries if at == number]
        own = {s.index for s in mine}
        wanted = dict.fromkeys(r for reads in [*(s.reads for s in mine), *(r for _, r in stored)] for r in reads)
        loads = []
        for read in sorted(wanted):
            if read in own:
                continue
            if read in position:
                loads.append(f"{listing.names[read]} = kept[{slot_of[read]} * LANES + i]")
            else:
                array, row = leaf_source(kernel, listing.angles, read)
                loads.append(f"{listing.names[read]} = {array}[{row} * LANES + i]")
        terms = [f"const real {listing.names[s.index]} = {s.text}" for s in mine]
        keep = []
        for statement in mine:
            if last_use.get(statement.index, number) > number:
                slot = heapq.heappop(free) if free else slots
                slots = max(slots, slot + 1)
                slot_of[statement.index] = rows[statement.index] = slot
                keep.append(f"kept[{slot} * LANES + i] = {listing.names[statement.index]}")
        found.append(Section(tuple(loads), tuple(terms), (*keep, *(text for text, _ in stored))))
    sections = []
    for section, part in zip(found, part_of, strict=True):
        skip = None
        if part is not None:
            c = part.condition
            place = ("kept", rows[c]) if c in position else leaf_source(kernel, listing.angles, c)
            skip = Skip(place, tuple(rows[result] for result in part.results))
        sections.append(replace(section, skip=skip))
    return Layout(tuple(sections), slots)


def _cuts(listing: Listing) -> tuple[list[tuple[int, int]], list[Part | None]]:
    """The sections' first statements and ends, and the part that each belongs to; the last one belongs to none."""
    long = len(listing.statements) > MOST_STATEMENTS or len(listing.blocks) > 1
    cuts: list[tuple[int, int]] = []
    parts: list[Part | None] = []
    start = 0
    for block, end in zip(listing.blocks, listing.ends, strict=True):
        length = end - start
        count = max(1, -(-length // CUT)) if long else 1
        size = max(1, -(-length // count))
        for k in range(count):
            cuts.append((min(start + k * size, end), min(start + (k + 1) * size, end)))
            parts.append(block.part)
        start = end
    return cuts, parts
