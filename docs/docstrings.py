"""What is read from docstrings for the reference: ``Example:`` is shown as code, names in roles as names."""

from __future__ import annotations

import re
from typing import Any

import griffe


class Docstrings(griffe.Extension):
    """Griffe knows ``Examples:`` as a section of code, but not ``Example:``, and no roles such as ``:func:``."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        """Rename the section, and take off the roles, before the docstring is taken apart."""
        if obj.docstring:
            text = re.sub(r"^Example:$", "Examples:", obj.docstring.value, flags=re.M)
            obj.docstring.value = re.sub(r":(?:attr|class|data|func|meth|mod):`", "`", text)
