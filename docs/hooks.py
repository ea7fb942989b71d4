"""What MkDocs does to a page here: blocks of ``math`` become MathML, which browsers show without a script."""

from __future__ import annotations

import re
from typing import Any

from latex2mathml.converter import convert


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Every ``math`` block of a page as a ``<math>`` element, readable without a network."""

    def shown(found: re.Match[str]) -> str:
        # latex2mathml leaves a name in words without spaces around it, and empty elements that are drawn as boxes
        element = convert(found.group(1), display="block").replace("<mi />", "").replace("<mo />", "")
        return f'<div class="formula" tabindex="0">{element}</div>'

    return re.sub(r"^```math\n(.*?)\n```$", shown, markdown, flags=re.M | re.S)
