"""From a name or a file to an arm, of the kind that answers most questions."""

from __future__ import annotations

import os

from chainrule import arms as embedded
from chainrule.arm import Arm
from chainrule.description import Description, Orthogonal3R
from chainrule.errors import InputError, shown
from chainrule.readers import read


def load(source: str | os.PathLike[str], *, tip: str | None = None, base: str | None = None) -> Arm:
    """An arm by name or from a file.

    An orthogonal 3R arm is a :class:`chainrule.Orthogonal3R`, as :func:`chainrule.orthogonal_3r` makes it.

    Args:
        source: an embedded arm's name (:func:`chainrule.arms.names`), or the path of a ``.toml`` or ``.urdf`` file.
        tip: for a URDF, the link the chain ends in (needed where the tree has several leaves).
        base: for a URDF, the link the chain begins at (default: the root).

    Raises:
        InputError: an unknown name; the message lists the known ones.
        DescriptionError: a file that is not right, with the place and what would be accepted.

    Example:
        >>> load("panda")
        <Arm panda: 7 joints (RRRRRRR)>
        >>> load("orthogonal_3r_fig2a").cuspidal
        True
    """
    if not isinstance(source, str | os.PathLike):
        raise InputError(f"an arm is loaded by its name or from a .toml or .urdf file, not from {shown(source)}")
    text = os.fspath(source)
    if isinstance(source, str) and text in embedded.names():
        if tip is not None or base is not None:
            raise InputError(f"{text}: tip and base are accepted for a .urdf only; an embedded arm is one chain")
        return _of(read(embedded.path(text)))
    if isinstance(source, str) and not text.lower().endswith((".toml", ".urdf", ".xacro")) and not os.path.exists(text):
        embedded.path(text)  # raises, with the list of names
    return _of(read(source, tip=tip, base=base))


def _of(description: Description) -> Arm:
    """The arm of a description; an orthogonal 3R arm answers for its cusps and postures as well."""
    if isinstance(description.geometry, Orthogonal3R):
        from chainrule.cuspidality.designs import Orthogonal3R as Design  # exact arithmetic, which no other arm needs

        return Design(description)
    return Arm(description)
