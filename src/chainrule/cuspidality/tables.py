"""The answers about a 3R arm as sentences and tables of plain values: on the terminal, in JSON and in the report."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from chainrule.tables import Cell, Column, Table, readable

if TYPE_CHECKING:
    from chainrule.cuspidality.designs import Regional3R
    from chainrule.cuspidality.posture_change import PostureChange

#: In place of a change of posture, of an arm that is cuspidal by a hair.
NO_EXAMPLE = (
    "Double precision does not tell two postures in one aspect from singular ones: no change of posture is shown."
)


def verdict(design: Regional3R) -> str:
    """Whether the arm is cuspidal and why, in one or two sentences.

    Example:
        >>> from chainrule import orthogonal_3r
        >>> verdict(orthogonal_3r(1.0, 2.0, 1.5, 1.0)).split(":")[0]
        'Cuspidal'
    """
    cusps, nodes = len(design.cusps()), len(design.nodes())
    counted = f"{count(cusps, 'cusp')} and {count(nodes, 'node')} in the cross-section"
    if design.nongeneric:
        return f"Not cuspidal: {', '.join(design.nongeneric)} ({counted}). Every change of posture meets a singularity."
    if design.cuspidal:
        return f"Cuspidal: {counted}. The arm can change its posture without meeting a singularity."
    return f"Not cuspidal: {counted}. Every change of posture meets a singularity."


def count(number: int, word: str) -> str:
    """A number with its noun.

    >>> count(1, "cusp"), count(2, "cusp")
    ('1 cusp', '2 cusps')
    """
    return f"{number} {word}{'' if number == 1 else 's'}"


def points_table(design: Regional3R) -> Table:
    """The cusps and nodes, by rho and z."""
    columns = (Column("kind", "point"), Column("rho", "ρ", "m"), Column("z", "z", "m"))
    rows = [(kind, float(rho), float(z)) for kind, found in _points(design) for rho, z in found]
    return Table("Cusps and nodes", columns, tuple(rows))


def _points(design: Regional3R) -> list[tuple[str, Any]]:
    return [("cusp", design.cusps()), ("node", design.nodes())]


def aspects_table(design: Regional3R) -> Table:
    """The aspects: the sign of det J and the interval of theta3 of each."""
    rows = tuple(
        (f"A{a.label + 1}", "+" if a.sign > 0 else "−", *((None, None) if a.whole else (_degrees(e) for e in a.theta3)))
        for a in design.aspects()
    )
    columns = (
        Column("aspect", "aspect"),
        Column("sign", "det J"),
        Column("from", "θ3 from", "deg"),
        Column("to", "to", "deg"),
    )
    return Table("Aspects, by θ3", columns, rows)


def postures_table(design: Regional3R, q: Any) -> Table:
    """Postures (k, 3) with the aspect that each is in."""
    labels = np.atleast_1d(design.aspect_of(q)).tolist() if len(q) else []
    rows: tuple[tuple[Cell, ...], ...] = tuple(
        (k, *(_degrees(angle) for angle in angles), "singular" if label < 0 else f"A{label + 1}")
        for k, (angles, label) in enumerate(zip(q, labels, strict=True), 1)
    )
    columns = (
        Column("posture", "posture"),
        *(Column(f"q{j}", f"q{j}", "deg") for j in (1, 2, 3)),
        Column("aspect", "aspect"),
    )
    return Table("Postures", columns, rows)


def _degrees(angle: float) -> float:
    return round(math.degrees(angle), 9) + 0.0


def change_in_words(change: PostureChange) -> str:
    """What came of asking for a change of posture."""
    if not change.exists:
        return f"There is no change of posture without a singularity: {change.reason}."
    if not change.smallest_determinant > 0.0:
        return (
            f"{_angles(change.start)} and {_angles(change.goal)} are in one aspect; that the way found between them "
            "keeps det J from 0 is beyond double precision."
        )
    proof = "proved in ball arithmetic" if change.certified else "sampled, not proved"
    return (
        f"The way from {_angles(change.start)} to {_angles(change.goal)} keeps |det J| above "
        f"{readable(change.smallest_determinant, 3)} m³ ({proof})."
    )


def _angles(q: Any) -> str:
    return "(" + ", ".join(f"{math.degrees(angle):.1f}°" for angle in q) + ")"
