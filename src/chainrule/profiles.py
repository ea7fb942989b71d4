"""A motion in one sentence and as a table: the same in the command, the figure and the report."""

from __future__ import annotations

import math

from chainrule.tables import Column, Table, readable
from chainrule.timing import CASES, JointMove


def finding(move: JointMove) -> str:
    """How long a motion takes, which joints need all of that, and whether it is the only one.

    Example:
        >>> from chainrule.timing import min_time
        >>> finding(min_time([0.0, 0.0], [1.0, 2.0], 1.0, 1.0))
        'The motion takes 3 s: joint 2 needs all of it; joint 1 has slack, so other motions are as fast'
    """
    takes = f"The motion takes {readable(float(move.duration), 4)} s"
    if float(move.duration) == 0.0:
        return f"{takes}: no joint has to move"
    tight = [j for j in range(move.n) if move.bottleneck[j]]
    loose = [j for j in range(move.n) if not move.bottleneck[j]]
    if not loose or bool(move.unique):
        whole = "the joint needs" if move.n == 1 else "every joint" + (" that can move" if loose else "") + " needs"
        return f"{takes}, and {whole} all of it: no other motion is as fast"
    if not tight:
        return f"{takes}, longer than any joint needs by itself: the price of moving on a straight line"
    needs, has = ("needs" if len(tight) == 1 else "need"), ("has" if len(loose) == 1 else "have")
    others = _joints(loose) if len(loose) < 4 else "the others"
    return f"{takes}: {_joints(tight)} {needs} all of it; {others} {has} slack, so other motions are as fast"


def _joints(which: list[int]) -> str:
    names = [str(j + 1) for j in which]
    return f"joint {names[0]}" if len(names) == 1 else f"joints {', '.join(names[:-1])} and {names[-1]}"


def table(move: JointMove, kinds: str) -> Table:
    """One row for each joint: way, case, the least time it needs, its slack, and its peak velocity with the limit.

    Degrees for revolute joints, metres for prismatic ones.
    """
    columns = (
        Column("joint", "joint"),
        Column("way", "way", _unit(kinds, "")),
        Column("case", "case"),
        Column("meaning", "by itself it"),
        Column("time", "least time", "s"),
        Column("slack", "slack", "s"),
        Column("peak", "peak velocity", _unit(kinds, "/s")),
        Column("limit", "limit", _unit(kinds, "/s")),
    )
    rows = []
    for j, kind in enumerate(kinds):
        scale = 180.0 / math.pi if kind == "R" else 1.0
        way = (float(move.goal[j]) - float(move.start[j])) * scale
        case = str(move.cases[j])
        slack = 0.0 if move.bottleneck[j] else float(move.slack[j])
        speeds = (float(move.peak[j]) * scale, float(move.v_max[j]) * scale)
        rows.append((j + 1, way, case, CASES[case], float(move.joint_durations[j]), slack, *speeds))
    return Table("Joints", columns, tuple(rows))


def _unit(kinds: str, per: str) -> str:
    used = [unit for kind, unit in (("R", f"deg{per}"), ("P", f"m{per}")) if kind in kinds]
    return " or ".join(used)
