"""The dossier of an arm: one self-contained HTML page, every statement computed when it is written.

Example:
    >>> import chainrule as cr
    >>> from chainrule import report
    >>> page = report.html(cr.planar_3r(1.0, 0.5, 0.25))
    >>> page.startswith("<!doctype html>")
    True
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from chainrule.arm import Arm
from chainrule.checks import Check
from chainrule.derive.manifest import write_whole
from chainrule.outputs import output_file
from chainrule.report.content import Part
from chainrule.report.context import Context
from chainrule.report.page import page
from chainrule.report.sections import SUMMARY, sections

__all__ = ["Report", "build", "html", "write"]

Progress = Callable[[str], None]


@dataclass(frozen=True)
class Report:
    """A finished report: the page, its sections by key, and the checks that failed."""

    html: str
    parts: dict[str, Part]
    failed: tuple[Check, ...]

    @property
    def passed(self) -> bool:
        """Whether every check passed."""
        return not self.failed

    def to_dict(self) -> dict[str, Any]:
        """The numbers of every section."""
        return {
            "passed": self.passed,
            "failed": [check.what for check in self.failed],
            "sections": {key: part.data for key, part in self.parts.items()},
        }


def build(arm: Arm, progress: Progress = lambda line: None) -> Report:
    """Compute every section that applies to the arm, and write the page as text.

    Args:
        arm: the arm; what is not yet generated for it is derived and compiled first.
        progress: called with one line for each step.
    """
    progress("loading the generated functions")
    arm.prepare(progress)
    context = Context(arm, progress)
    chosen = sections(arm)
    built = {}
    for section in sorted(chosen, key=lambda section: section.key == SUMMARY):  # what it sums up comes before it
        built[section.key] = part = section.build(arm, context)
        context.headlines += [(section.key, section.title, line) for line in part.headlines]
    parts = {section.key: built[section.key] for section in chosen}
    titles = {section.key: section.title for section in chosen}
    failed = tuple(check for check in context.checks if not check.passed)
    return Report(_page(arm, parts, titles), parts, failed)


def html(arm: Arm, progress: Progress = lambda line: None) -> str:
    """The report as text: one HTML page that needs nothing beside it."""
    return build(arm, progress).html


def write(arm: Arm, path: str | os.PathLike[str], progress: Progress = lambda line: None) -> Report:
    """Write the report to a file, whole or not at all.

    Raises:
        InputError: if the folder does not exist, or the path is a folder.
        OSError: if the file cannot be written.
    """
    output_file(Path(path))
    report = build(arm, progress)
    write_whole(Path(path), report.html)
    return report


def _page(arm: Arm, parts: dict[str, Part], titles: dict[str, str]) -> str:
    foot = "Every number on this page was computed for this arm when the page was written."
    return page(arm.name, "chainrule report", parts, titles, foot)
