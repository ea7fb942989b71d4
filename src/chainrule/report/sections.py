"""The sections of the report, in order.

To add one: write a module in ``parts/`` that has a ``SECTION``, and name it in :data:`ORDER`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from chainrule.arm import Arm
from chainrule.report.content import Part
from chainrule.report.context import Context


@dataclass(frozen=True)
class Section:
    """One section: a key for links, a title, whether it applies to an arm, and how it is built."""

    key: str
    title: str
    applies: Callable[[Arm], bool]
    build: Callable[[Arm, Context], Part]


#: The section that sums the others up: built last, shown first.
SUMMARY = "summary"

#: Modules of ``chainrule.report.parts``, in the order of the page.
ORDER = (
    "summary",
    "drawing",
    "description",
    "jacobian",
    "minors",
    "singular",
    "map",
    "reach",
    "cuspidality",
    "self_motion",
    "redundancy",
    "timing",
    "speed_ratio",
    "following",
    "generated",
    "checked",
)


def sections(arm: Arm) -> list[Section]:
    """The sections that apply to an arm."""
    found = [import_module(f"chainrule.report.parts.{name}").SECTION for name in ORDER]
    return [section for section in found if section.applies(arm)]
