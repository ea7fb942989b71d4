"""Where results are written: a file's folder must be there, it is not made."""

from __future__ import annotations

import os
from pathlib import Path

from chainrule.errors import InputError


def output_file(path: Path | None) -> Path | None:
    """The path of a file to write, refused before anything is computed where it cannot be one.

    Raises:
        InputError: the folder does not exist or cannot be written to, or the path is a folder itself.

    Example:
        >>> output_file(Path("nowhere/figure.svg"))
        Traceback (most recent call last):
            ...
        chainrule.errors.InputError: nowhere/figure.svg: there is no folder nowhere
    """
    if path is not None and path.is_dir():
        raise InputError(f"{path} is a folder; a file is accepted")
    if path is not None and not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}")
    if path is not None and not os.access(path.parent, os.W_OK):
        raise InputError(f"{path}: the folder {path.parent} cannot be written to")
    return path


def figure_file(path: Path | None) -> Path | None:
    """The same for a figure, whose suffix says how it is written.

    Raises:
        InputError: a suffix other than .svg, .png or .pdf, too.

    Example:
        >>> figure_file(Path("figure.jpg"))
        Traceback (most recent call last):
            ...
        chainrule.errors.InputError: figure.jpg: a figure is written as .svg, .png or .pdf
    """
    if path is not None and path.suffix.lower() not in (".svg", ".png", ".pdf"):
        raise InputError(f"{path}: a figure is written as .svg, .png or .pdf")
    return output_file(path)
