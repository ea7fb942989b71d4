"""A self-motion in words and tables, for the command line, the report and the titles of figures."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.self_motions.along import SelfMotionAlong
from chainrule.self_motions.result import ENDS, Component, SelfMotion
from chainrule.tables import Cell, Column, Table, readable

Array = NDArray[Any]

#: Lengths that differ by less than this share of themselves are called equal.
EQUAL = 1e-6


def finding(found: SelfMotion) -> str:
    """A self-motion in one line: how many curves, how long, and what that means.

    Example:
        >>> import chainrule as cr
        >>> finding(cr.self_motion(cr.planar_3r(0.40, 0.35, 0.25), [0.4, 0.0]))
        '2 closed curves of length 8.238 rad each: the arm cannot pass from one to the other'
        >>> finding(cr.self_motion(cr.planar_3r(0.40, 0.35, 0.25), [2.0, 0.0]))
        'The target is out of reach: no posture holds it'
    """
    proved = found.complete == "proved"
    if found.status == "unreachable":
        return f"The target is out of reach: no posture {'holds it' if proved else 'that holds it was found'}"
    sizes = _sizes([curve.length for curve in found.components])
    if found.status == "singular":
        whole = f", {readable(found.length, 4)} rad in all" if found.length else ""
        return f"The target is singular: {found.detail}{whole}"
    closed = sum(curve.closed for curve in found.components)
    if found.count == 1:
        if not closed:
            return f"1 curve, followed for {sizes}: it does not close"
        alone = "no other was looked for" if found.method == "eigenvector" else "no other was found"
        rest = "every posture can be reached from every other" if proved else alone
        return f"1 closed curve of length {sizes}: {rest}"
    if closed < found.count:
        return f"{found.count} curves of {sizes}, {closed} of them closed: the arm cannot pass from one to another"
    other = "the other" if found.count == 2 else "another"
    return f"{found.count} closed curves of length {sizes}: the arm cannot pass from one to {other}"


def _sizes(lengths: list[float]) -> str:
    if not lengths:
        return "no length"
    low, high = min(lengths), max(lengths)
    if high - low <= EQUAL * high:
        return f"{readable(low, 4)} rad" + (" each" if len(lengths) > 1 else "")
    return f"{readable(low, 4)} to {readable(high, 4)} rad"


def completeness(found: SelfMotion) -> str:
    """How sure it is that no curve is missing, as a sentence.

    >>> import chainrule as cr
    >>> completeness(cr.self_motion(cr.planar_3r(0.40, 0.35, 0.25), [0.4, 0.0]))
    'These are all curves (closed form, proved).'
    """
    if found.complete == "proved":
        return f"These are all curves ({found.method}, proved)."
    return f"Not proved to be all ({found.method}: {found.complete})."


def limits_finding(found: SelfMotion) -> str:
    """What joint limits leave of the curves, in one line; empty where they were not looked at.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(0.40, 0.35, 0.25).with_limits(position=[(-2.0, 2.0)] * 3)
        >>> limits_finding(cr.self_motion(arm, [0.4, 0.0], limits=True))
        'Within the joint limits 2 arcs are left, of 3.107 rad in all (19 % of the length)'
    """
    if found.feasible is None or not found.count:
        return ""
    if not found.feasible:
        return "Within the joint limits nothing is left: no posture within them holds the target"
    whole = sum(part.closed for part in found.feasible)
    arcs = len(found.feasible) - whole
    parts = [f"{n} {word}{'s' if n > 1 else ''}" for n, word in ((whole, "whole curve"), (arcs, "arc")) if n]
    length = math.fsum(part.length for part in found.feasible)
    share = f" ({100.0 * length / found.length:.0f} % of the length)" if found.length else ""
    verb = "is" if len(found.feasible) == 1 else "are"
    return f"Within the joint limits {' and '.join(parts)} {verb} left, of {readable(length, 4)} rad in all{share}"


# ---- tables ------------------------------------------------------------------------------------------------------


def curves_table(arm: Arm, found: SelfMotion) -> Table:
    """The curves, joints unlimited: length, windings, the range of every joint, and the range of H."""
    rows = tuple((k, *_row(arm, curve, normal=True)) for k, curve in enumerate(found.components, 1))
    lead = (Column("curve", "curve"), Column("length", "length", "rad"), Column("winding", "turns"))
    caption = "The curves, joint limits left aside: the range of every joint, and of the manipulability H"
    return Table(caption, (*lead, *_joint_columns(arm), *_height_columns()), rows)


def arcs_table(arm: Arm, found: SelfMotion) -> Table:
    """What limits leave: each part's curve, length, ends, and the range of every joint (its failure tolerance)."""
    rows = tuple(
        (
            k,
            None if part.of is None else part.of + 1,
            *(cell for i, cell in enumerate(_row(arm, part, normal=False)) if i != 1),
            _ends(part),
        )
        for k, part in enumerate(found.feasible or (), 1)
    )
    lead = (Column("part", "part"), Column("curve", "of curve"), Column("length", "length", "rad"))
    caption = (
        "Within the joint limits: a joint may fail and stay at any value in its range, and the target is still held"
    )
    columns = (*lead, *_joint_columns(arm), *_height_columns(), Column("ends", "ends at"))
    return Table(caption, columns, rows)


def _joint_columns(arm: Arm) -> tuple[Column, ...]:
    return tuple(Column(f"q{j}", f"q{j}", "°" if kind == "R" else "m") for j, kind in enumerate(arm.kinds, 1))


def _height_columns() -> tuple[Column, ...]:
    return (Column("lowest_H", "least H"), Column("highest_H", "largest H"))


def _row(arm: Arm, curve: Component, normal: bool) -> tuple[Cell, ...]:
    """Length, winding, the range of every joint, least and largest H."""
    turns = ", ".join(f"q{j} {int(w):+d}".replace("-", "−") for j, w in enumerate(curve.winding, 1) if w)
    ranges = (joint_range(curve, j, kind, normal) for j, kind in enumerate(arm.kinds, 1))
    low, high = curve.manipulability
    return (float(curve.length), turns or "none", *ranges, float(f"{low:.4g}"), float(f"{high:.4g}"))


def joint_range(curve: Component, joint: int, kind: str, normal: bool = True) -> str:
    """The range of a joint (from 1) on a curve: degrees, or m for a slide.

    Args:
        curve: the curve.
        joint: the joint.
        kind: "R" or "P".
        normal: whether whole turns may be left out (a curve without limits is the same in every turn).

    >>> import chainrule as cr
    >>> curve = cr.self_motion(cr.planar_3r(0.40, 0.35, 0.25), [0.4, 0.0]).components[0]
    >>> [joint_range(curve, joint, "R") for joint in (1, 2, 3)]
    ['−97.2 … −14.4', '60 … 158.2', 'all round']
    """
    low, high = (float(value) for value in curve.box[joint - 1])
    if kind == "R":
        if curve.turns_freely(joint):
            return "all round"
        low, high = math.degrees(low), math.degrees(high)
        if normal:
            shift = 360.0 * math.floor(((low + high) / 2.0 + 180.0) / 360.0)
            low, high = low - shift, high - shift
        digits = 1
    else:
        digits = 4
    first, last = (f"{round(value, digits) + 0.0:g}".replace("-", "−") for value in (low, high))
    return first if first == last else f"{first} … {last}"


def _ends(part: Component) -> str:
    """Where an arc ends, in words."""
    if part.closed:
        return "whole"
    short = {sentence: word for word, sentence in ENDS.items()}
    words = [short.get(end, end).replace("limit of joint ", "q") for end in part.ends]
    return ", ".join(dict.fromkeys(words))


# ---- along a path ------------------------------------------------------------------------------------------------


def along_finding(found: SelfMotionAlong) -> str:
    """Whether a path can be followed on one family of curves, in one line.

    Example:
        >>> import chainrule as cr
        >>> arm = cr.planar_3r(0.40, 0.35, 0.25)
        >>> along_finding(cr.self_motion_along(arm, [[0.32, 0.0], [0.4, 0.0], [0.48, 0.0]]))
        'The path can be followed on each of 2 curves, from its first target to its last'
    """
    if not found.count.all():
        missed = int((found.count == 0).sum())
        return f"The path cannot be followed: {missed} of its {len(found.count)} targets out of reach"
    n = len(found.families)
    if n:
        which = "one curve, which goes on" if n == 1 else f"each of {n} curves,"
        return f"The path can be followed on {which} from its first target to its last"
    return "No curve goes on from the first target to the last: every one splits, merges or vanishes on the way"


def intervals_table(found: SelfMotionAlong, x: Array, heading: str = "px", unit: str = "m") -> Table:
    """Runs of targets with the same curves: from where to where, their number, and the range of their lengths.

    Args:
        found: the self-motions along a path.
        x: (k,) what is told of each target.
        heading: its name.
        unit: its unit.
    """
    rows: list[tuple[Cell, ...]] = []
    start = 0
    for k in range(1, len(x) + 1):
        if k < len(x) and _same(found, start, k):
            continue
        motions = found.motions[start:k]
        lengths = [curve.length for motion in motions for curve in motion.arcs]
        rows.append(
            (
                float(x[start]),
                float(x[k - 1]),
                k - start,
                motions[0].detail or motions[0].status,
                len(motions[0].arcs),
                min(lengths, default=None),
                max(lengths, default=None),
                ", ".join(str(label + 1) for label in found.labels[start]) or None,
            )
        )
        start = k
    columns = (
        Column("from", f"{heading} from", unit),
        Column("to", "to", unit),
        Column("targets", "targets"),
        Column("status", "status"),
        Column("number", "curves"),
        Column("shortest", "lengths from", "rad"),
        Column("longest", "to", "rad"),
        Column("labels", "labels"),
    )
    return Table(
        "Targets with the same curves; a curve keeps its label as long as it goes on by itself", columns, tuple(rows)
    )


def _same(found: SelfMotionAlong, i: int, k: int) -> bool:
    a, b = found.motions[i], found.motions[k]
    return (a.status, a.detail, found.labels[i]) == (b.status, b.detail, found.labels[k]) and len(a.arcs) == len(b.arcs)


def changes_table(found: SelfMotionAlong, x: Array, heading: str = "px", unit: str = "m") -> Table:
    """Where curves split, merge, appear or vanish."""
    at = np.interp([change.at for change in found.changes], np.arange(len(x)), x)
    rows = tuple(
        (
            float(place),
            change.kind,
            ", ".join(str(label + 1) for label in change.before) or None,
            ", ".join(str(label + 1) for label in change.after) or None,
        )
        for place, change in zip(at, found.changes, strict=True)
    )
    columns = (
        Column("at", heading, unit),
        Column("kind", "change"),
        Column("before", "before"),
        Column("after", "after"),
    )
    return Table("Where curves change", columns, rows)
