"""The exceptions chainrule raises. Each message is one line: what was wrong, where, what is accepted."""

from __future__ import annotations


class InputError(ValueError):
    """What the caller gave cannot be used; the message says what would be."""


class DescriptionError(InputError):
    """A description of an arm is wrong; the message names the file, and the row, joint or key."""


class GenerationError(RuntimeError):
    """Code could not be derived, written or compiled; the message names the step."""


def shown(value: object) -> str:
    """``value`` as it may stand in a message: quoted, on one line, at most 60 characters of it.

    >>> shown("q1")
    "'q1'"
    """
    if isinstance(value, (str, bytes)):
        value = value[:61]
    try:
        text = " ".join(repr(value).split())
    except (ValueError, RecursionError):  # an int of thousands of digits, a list that holds itself
        return f"a {type(value).__name__} too long to show"
    return text if len(text) <= 62 else text[:59] + "..."
