"""The checks, made while the report was written."""

from __future__ import annotations

from chainrule.arm import Arm
from chainrule.report.content import Finding, Grid, Part, Prose
from chainrule.report.context import Context
from chainrule.report.sections import Section
from chainrule.tables import Column, Table, readable


def _build(arm: Arm, context: Context) -> Part:
    found = context.checks
    failed = [check for check in found if not check.passed]
    rows = tuple(
        (c.what, c.count, readable(c.worst, 2), readable(c.bound, 2), "pass" if c.passed else "FAIL") for c in found
    )
    table = Table(
        "Checks",
        (
            Column("what", "what was compared"),
            Column("count", "configurations"),
            Column("worst", "worst relative error"),
            Column("bound", "allowed"),
            Column("result", "result"),
        ),
        rows,
    )
    verdict = (
        Finding(f"All {len(found)} checks passed.", tone="good")
        if not failed
        else Finding(f"{len(failed)} of {len(found)} checks failed.", tone="bad")
    )
    return Part(
        (
            verdict,
            Prose(
                "Measured on this machine while the report was written, on random configurations inside the "
                "joint limits. The comparisons use arithmetic with 40 and 50 digits (mpmath) and NumPy's linear "
                "algebra, neither of which the generated code shares."
            ),
            Grid(table),
        ),
        {"checks": [check.to_dict() for check in found]},
    )


SECTION = Section("checked", "Checks", lambda arm: True, _build)
