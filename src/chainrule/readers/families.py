"""The families whose lengths stay symbols: planar chains of any R and P joints, and the orthogonal 3R arms."""

from __future__ import annotations

from collections.abc import Sequence

from chainrule.description import MAX_JOINTS, Description, Orthogonal3R, Planar, check_finite
from chainrule.errors import DescriptionError, shown
from chainrule.readers.parts import constant_angle, joint_kind, named_joints


def planar(
    kinds: str | Sequence[str],
    lengths: Sequence[float],
    headings: Sequence[float] | None = None,
    *,
    name: str | None = None,
    joint_names: Sequence[str] | None = None,
    source: str = "",
) -> Description:
    """A planar chain of revolute and prismatic joints.

    R turns the heading by theta_i and advances l_i along it, P turns it by heading_i and advances l_i + theta_i.

    Args:
        kinds: one 'R' or 'P' per joint, as a word ("RPR") or a sequence.
        lengths: (n,) l_i in m; any finite numbers.
        headings: (n,) constant turns in rad of the prismatic joints, 0 for the revolute ones; all 0 when absent.
        name: the arm's name; "planar_rpr" for "RPR" when absent.
        joint_names: n names; "joint1" and so on when absent.
        source: where the numbers come from.

    Raises:
        DescriptionError: naming the joint or argument that is wrong.

    Example:
        >>> planar("RPR", [1.0, 0.5, 0.25], [0.0, 0.3, 0.0]).kinds
        'RPR'
    """
    if not 1 <= len(kinds) <= MAX_JOINTS:
        raise DescriptionError(f"kinds: {len(kinds)} joints; between 1 and {MAX_JOINTS} are accepted")
    word = [joint_kind(kind, f"kinds, joint {i}") for i, kind in enumerate(kinds, 1)]
    turns = _numbers(headings, "headings", len(word)) if headings is not None else (0.0,) * len(word)
    for i, (kind, turn) in enumerate(zip(word, turns, strict=True), 1):
        constant_angle(turn, f"headings, joint {i}")
        if kind == "R" and turn != 0.0:
            raise DescriptionError(f"headings, joint {i}: {turn}; a revolute joint takes 0, its angle turns it")
    return Description(
        name=name if name is not None else "planar_" + "".join(word).lower()[:121],
        joints=named_joints(word, joint_names),
        geometry=Planar(_numbers(lengths, "lengths", len(word)), turns),
        source=source,
    )


def planar_3r(l1: float, l2: float, l3: float) -> Description:
    """The planar arm with three revolute joints and link lengths l1, l2, l3 in m.

    Raises:
        DescriptionError: if a length is not a finite number.

    Example:
        >>> planar_3r(1.0, 0.5, 0.25).geometry.lengths
        (1.0, 0.5, 0.25)
    """
    return planar("RRR", (l1, l2, l3), name="planar_3r")


def orthogonal_3r(
    d2: float,
    d3: float,
    d4: float,
    r2: float,
    *,
    name: str = "orthogonal_3r",
    joint_names: Sequence[str] | None = None,
    source: str = "",
) -> Description:
    """The orthogonal 3R arm of lengths d2, d3, d4, r2 in m (alpha_2 = -90 deg, alpha_3 = 90 deg, r_3 = 0).

    Its modified rows (alpha, a, d) are (0, 0, 0), (-90 deg, d2, r2), (90 deg, d3, 0), its tool (d4, 0, 0)
    (Baili, Wenger and Chablat 2004, section II).

    Raises:
        DescriptionError: if a length is not a finite number.

    Example:
        >>> orthogonal_3r(1.0, 2.0, 1.5, 1.0).n
        3
    """
    lengths = _numbers((d2, d3, d4, r2), ("d2", "d3", "d4", "r2"), 4)
    return Description(
        name=name,
        joints=named_joints(("R", "R", "R"), joint_names),
        geometry=Orthogonal3R(*lengths),
        source=source,
    )


def _numbers(values: Sequence[float], what: str | tuple[str, ...], count: int) -> tuple[float, ...]:
    if isinstance(values, str) or not hasattr(values, "__len__") or len(values) != count:
        raise DescriptionError(f"{what}: {shown(values)}; {count} numbers, one per joint, are accepted")
    labels = [f"{what}, joint {i}" for i in range(1, count + 1)] if isinstance(what, str) else what
    return tuple(check_finite(value, label) for value, label in zip(values, labels, strict=True))
