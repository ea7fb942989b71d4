"""The embedded arms: one TOML file each, beside this module; each names its source."""

from __future__ import annotations

from pathlib import Path

from chainrule.errors import InputError, shown

_FOLDER = Path(__file__).parent


def names() -> tuple[str, ...]:
    """The names of the embedded arms, sorted.

    >>> "panda" in names()
    True
    """
    return tuple(sorted(file.stem for file in _FOLDER.glob("*.toml")))


def path(name: str) -> Path:
    """The TOML file of the embedded arm ``name``.

    Raises:
        InputError: if there is no such arm; the message lists those there are.

    >>> path("panda").name
    'panda.toml'
    """
    if name not in names():  # compared with what exists, so no name can lead out of the folder
        raise InputError(f"there is no embedded arm {shown(name)}; there are {', '.join(names())}")
    return _FOLDER / f"{name}.toml"
