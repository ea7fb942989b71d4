"""Reading a small text file whole, with a limit on its size and one clear line for each thing that can go wrong."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager

from chainrule.errors import DescriptionError, shown


def read_limited(path: str | os.PathLike[str], limit: int) -> bytes:
    """The bytes of a regular file of at most ``limit`` bytes.

    Raises:
        DescriptionError: if there is no such file, it is not a regular file, cannot be read, or is larger.
    """
    try:
        with open(path, "rb", opener=_without_waiting) as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise DescriptionError("not a regular file")
            content = file.read(limit + 1)
    except FileNotFoundError:
        raise DescriptionError("there is no such file") from None
    except IsADirectoryError:
        raise DescriptionError("this is a folder, not a file") from None
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise DescriptionError(f"cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if len(content) > limit:
        size = f"{limit // 2**20} MiB" if limit >= 2**20 else f"{limit // 2**10} KiB"
        raise DescriptionError(f"larger than {size}, the most that is accepted")
    return content


@contextmanager
def located(path: str | os.PathLike[str]) -> Iterator[None]:
    """Put the file's name in front of the message of any :class:`DescriptionError` raised inside."""
    try:
        yield
    except DescriptionError as error:
        name = os.fspath(path)
        name = name if isinstance(name, str) and name.isprintable() else shown(name)
        raise DescriptionError(f"{name}: {error}") from None


def _without_waiting(path: str, flags: int) -> int:
    # A pipe without a writer would block for ever when opened; opened this way it is seen and refused.
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))
