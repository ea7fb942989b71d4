"""Where results are written: a file's folder must be there, it is not made."""

from __future__ import annotations

from pathlib import Path

from chainrule.errors import InputError


def output_file(path: Path | None) -> Path | None:
    """The path of a file to write, refused before anything is computed where it cannot be one.

    Raises:
        InputError: the folder does not exist, or the path is a folder itself.

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
    return path
