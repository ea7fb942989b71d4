"""The papers chainrule rests on, recomputed: each quantity a paper prints, beside ours, with the difference explained.

To add a paper: write a module here with a function ``rows(progress)``, perhaps one ``figures()``, and name it in
:data:`PAPERS`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal

from chainrule.errors import InputError, shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Verdict = Literal["agrees", "misprint", "true under a condition", "not reproducible", "DISAGREES"]

#: What each verdict means; only the last is a failure. All but the first have a note that says what is meant.
VERDICTS: dict[Verdict, str] = {
    "agrees": "ours is the same: to the digits the paper prints, or by proof",
    "misprint": "the paper errs; the note gives the corrected form",
    "true under a condition": "right under the condition that the note states, not in general",
    "not reproducible": "the paper leaves out what the note names, so that there is nothing to compare with",
    "DISAGREES": "a difference that nothing explains",
}


@dataclass(frozen=True)
class Row:
    """One quantity.

    Attributes:
        where: where it stands in the paper.
        quantity: what it is.
        paper: the paper's value, as printed.
        ours: our value.
        difference: ours minus the paper's, where both are numbers.
        verdict: one of :data:`VERDICTS`.
        how: the call that gives our value.
        note: what explains a difference.
    """

    where: str
    quantity: str
    paper: str
    ours: str
    difference: float | None
    verdict: Verdict
    how: str
    note: str = ""

    @property
    def good(self) -> bool:
        """Whether nothing is left unexplained."""
        return self.verdict != "DISAGREES"

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "where": self.where,
            "quantity": self.quantity,
            "paper": self.paper,
            "ours": self.ours,
            "difference": self.difference,
            "verdict": self.verdict,
            "how": self.how,
            "note": self.note,
        }


@dataclass(frozen=True)
class Paper:
    """A paper: its key, a short title, how it is cited, what of it is recomputed, and the module that does it."""

    key: str
    title: str
    citation: str
    scope: str
    module: str


#: The papers, by key.
PAPERS: dict[str, Paper] = {
    paper.key: paper
    for paper in (
        Paper(
            "deluca",
            "De Luca 2012",
            "A. De Luca, Robotics I, written exam of 11 January 2012, with solutions",
            "exercises 1 and 2 and the bonus exercise",
            "chainrule.papers.deluca",
        ),
        Paper(
            "ambike",
            "Ambike, Schmiedeler, Stanišić 2010",
            "S. Ambike, J. P. Schmiedeler, M. M. Stanišić, Using Redundancy in Serial Planar Mechanisms to Improve "
            "Output-Space Tracking Accuracy, 2010",
            "equations (3) to (9), both examples, figures 1 and 2, and what the paper claims",
            "chainrule.papers.ambike",
        ),
        Paper(
            "baili",
            "Baili, Wenger, Chablat 2004",
            "M. Baili, P. Wenger, D. Chablat, Kinematic Analysis of a Family of 3R Manipulators, Problems of Mechanics "
            "15(2), 2004",
            "equations (1) to (7), figures 2 to 7, the five domains, and what the paper claims",
            "chainrule.papers.baili",
        ),
        Paper(
            "lenarcic",
            "Lenarčič 2002",
            "J. Lenarčič, Some considerations on the self-motion curves of a planar 3R manipulator, 2002",
            "equations (4) to (21), figures 2 to 5, and what the paper claims",
            "chainrule.papers.lenarcic",
        ),
        Paper(
            "sanchez",
            "Sanchez 2003",
            "E. A. Sanchez, Singularity Avoidance for an Eight Degrees of Freedom Serial Manipulator, thesis, 2003",
            "chapters 2 to 5 as far as page 82, figures 5.1 to 5.32, and what the thesis claims",
            "chainrule.papers.sanchez",
        ),
    )
}


def reproduce(key: str, progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """Recompute a paper's quantities.

    Args:
        key: one of :data:`PAPERS`.
        progress: called with one line for each step.

    Raises:
        InputError: an unknown paper; the message lists the known ones.

    Example:
        >>> reproduce("deluca")[0].verdict
        'agrees'
    """
    if key not in PAPERS:
        raise InputError(f"there is no paper {shown(key)}; {', '.join(PAPERS)} can be reproduced")
    found: tuple[Row, ...] = import_module(PAPERS[key].module).rows(progress)
    return found


def compared(where: str, quantity: str, printed: str, value: float, how: str, note: str = "", unit: str = "") -> Row:
    """A number against the paper's, which it must equal to the last digit printed.

    >>> compared("p. 1", "radius", "0.25", 0.2500000001, "ring([1, 0.5, 0.25])").verdict
    'agrees'
    """
    decimals = len(printed.partition(".")[2])
    difference = value - float(printed)
    verdict: Verdict = "agrees" if abs(difference) <= 0.5 * 10.0**-decimals * (1.0 + 1e-9) else "DISAGREES"
    return Row(where, quantity, f"{printed}{unit}", f"{value:.10g}{unit}", difference, verdict, how, note)


def shown_equal(where: str, quantity: str, printed: str, equal: bool, how: str, note: str = "") -> Row:
    """A formula or set against the paper's, equal or not by proof."""
    return Row(
        where,
        quantity,
        printed,
        "the same, proved" if equal else "not the same",
        None,
        "agrees" if equal else "DISAGREES",
        how,
        note,
    )


def claim(
    where: str, what: str, paper: str, ours: str, true: bool, how: str, note: str = "", verdict: Verdict = "agrees"
) -> Row:
    """A statement of the paper: ``verdict`` where ours bears out what we say of it, else a disagreement.

    >>> claim("p. 1", "the ring", "has a hole", "has a hole", True, "ring([1, 0.5, 0.25])").verdict
    'agrees'
    """
    return Row(where, what, paper, ours, None, verdict if true else "DISAGREES", how, note)


def figures(key: str) -> dict[str, Figure]:
    """The figures of a paper drawn anew, by name.

    Raises:
        InputError: an unknown paper; the message lists the known ones.

    Example:
        >>> list(figures("lenarcic"))
        ['figure-2', 'figure-3', 'figure-4', 'figure-5']
    """
    if key not in PAPERS:
        raise InputError(f"there is no paper {shown(key)}; {', '.join(PAPERS)} can be reproduced")
    module = import_module(PAPERS[key].module)
    return module.figures() if hasattr(module, "figures") else {}
