"""All self-motion loops of a 7R arm at a pose, with lengths and what joint limits leave, beside ssik's sheets."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

import chainrule as cr
from benchmarks.measure import Disagreement
from benchmarks.planar import Way

#: A posture whose pose has eight loops, and how much slower than ours ssik is meant to be.
POSTURE, RATIO = (0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4), 100.0


def questions(batch: int) -> Iterator[tuple[str, list[Way], str]]:
    """Every question: its heading, the ways of answering it, and a note; one pose each, whatever the batch."""
    for name, prebuilt in (("panda", "franka_panda_ik"), ("iiwa14", "iiwa14_ik")):
        ways, note = loops(name, prebuilt)
        yield f"every self-motion loop of the {name} at a pose, with lengths", ways, note


def loops(name: str, prebuilt: str) -> tuple[list[Way], str]:
    """Ours with joint limits, which is compared, and without; ssik's sheets where that package is installed.

    ssik's sheets are counted and measured, joint limits not considered.
    """
    arm = cr.load(name)
    pose = arm.pose(POSTURE)
    found = cr.self_motion(arm, pose)
    if (found.count, found.complete) != (8, "proved"):
        raise Disagreement(f"chainrule finds {found.count} loops of the {name}, {found.complete}; there are 8")
    ways = [
        Way(
            "chainrule: loops, lengths, boxes, and arcs within limits",
            1,
            lambda: cr.self_motion(arm, pose, limits=True),
        ),
        Way("chainrule, without limits", 1, lambda: cr.self_motion(arm, pose)),
    ]
    try:
        import ssik
    except ImportError:
        return ways, "8 loops, proved. ssik is not installed"
    peer = ssik.Manipulator.from_prebuilt(prebuilt)
    own = np.asarray(peer.fk(np.array(POSTURE)))

    def sheets() -> list[tuple[int, float]]:
        return [(len(sheet), sum(_length(chart) for chart in sheet)) for sheet in peer.self_motion(own).sheets()]

    theirs = sheets()
    ways.append(Way("ssik: sheets with lengths", 1, sheets, None, RATIO))
    total = sum(length for _, length in theirs)
    return (
        ways,
        f"8 loops, proved, {found.length:.4f} rad together; ssik: {len(theirs)} sheets, {total:.4f} rad together",
    )


def _length(chart: Any) -> float:
    return float(chart.length())
