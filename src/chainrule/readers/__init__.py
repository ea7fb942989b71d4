"""Readers: how an arm comes in, from a Denavit-Hartenberg table, a TOML file or a URDF."""

from __future__ import annotations

import os
from pathlib import PurePath

from chainrule.description import Description
from chainrule.errors import DescriptionError, shown
from chainrule.readers.files import located


def read(path: str | os.PathLike[str], *, tip: str | None = None, base: str | None = None) -> Description:
    """The arm in a file, by its suffix: ``.toml`` (:mod:`chainrule.readers.toml`) or ``.urdf``.

    Args:
        path: the file.
        tip: the link at the end of the chain, for a URDF; may be left out where only one link can be meant.
        base: the link at the start of the chain, for a URDF; the root link when left out.

    Raises:
        DescriptionError: one line with the file, what is wrong in it, and what would be accepted.
    """
    suffix = PurePath(os.fspath(path)).suffix.lower()
    if suffix == ".urdf":
        from chainrule.readers.urdf import read_urdf

        return read_urdf(path, tip=tip, base=base)
    with located(path):
        if suffix != ".toml":
            hint = "; a xacro must be expanded to a .urdf first" if suffix == ".xacro" else ""
            raise DescriptionError(f"the suffix {shown(suffix)} is not known; .toml and .urdf are accepted{hint}")
        if tip is not None or base is not None:
            raise DescriptionError("tip and base are accepted for a .urdf only; a TOML file describes one chain")
    from chainrule.readers.toml import read_toml

    return read_toml(path)
