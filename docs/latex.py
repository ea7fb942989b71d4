"""Formulas of the derivations as LaTeX, in the field's shorthand: s2 for sin q2, c12 for cos(q1 + q2)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

from sympy.printing.latex import LatexPrinter

from chainrule.derive.program import Program, Step
from chainrule.report.mathml import joint_numbers, split_name

Expression = Any

#: Letters that symbols are named after.
GREEK = ("alpha", "kappa", "phi", "rho", "theta")
#: What the derivations write in words, and what the field writes for it.
STEMS = {
    "acceleration": "A",
    "across": "n",
    "along": "t",
    "distance": "d",
    "duration": "T",
    "hs": r"\sigma",
    "least": "x",
    "null": r"\hat{N}",
    "velocity": "V",
    "wl": r"\lambda",
    "wn": r"\nu",
    "ℓ": r"\ell",
    "φ": r"\varphi",
}
WHOLE = {
    "rho_squared": r"\rho^{2}",
    "gw": "g_{w}",
    "ca2": r"c_{\alpha 2}",
    "sa2": r"s_{\alpha 2}",
    "ca3": r"c_{\alpha 3}",
    "sa3": r"s_{\alpha 3}",
    "rt2": r"\left(\mathbf{T} \cdot \mathbf{r}^{(2)}\right)",
    "rn3": r"\left(\mathbf{T} \times \mathbf{r}^{(3)}\right)",
}
#: A sum is broken into lines of about so many characters of LaTeX.
LINE = 110


class _Printer(LatexPrinter):  # type: ignore[misc]
    """SymPy's LaTeX with short names for sines, cosines and the steps' symbols."""

    def _print_Symbol(self, symbol: Expression, style: str = "plain") -> str:
        return name(symbol.name)

    def _print_sin(self, expression: Expression, exp: str | None = None) -> str:
        return self._turned("s", r"\sin", expression, exp)

    def _print_cos(self, expression: Expression, exp: str | None = None) -> str:
        return self._turned("c", r"\cos", expression, exp)

    def _turned(self, short: str, function: str, expression: Expression, exp: str | None) -> str:
        numbers = joint_numbers(expression.args[0])
        power = f"^{{{exp}}}" if exp else ""
        if numbers:
            return f"{short}_{{{numbers}}}{power}"
        return rf"{function}{power}\left({self._print(expression.args[0])}\right)"

    def _print_GuardedInverse(self, expression: Expression, exp: str | None = None) -> str:
        power = f"^{{{exp}}}" if exp else ""
        return rf"\left[\frac{{1}}{{{self._print(expression.args[0])}}}\right]{power}"

    def _print_Where(self, expression: Expression) -> str:
        test, value = map(self._print, expression.args)
        return rf"\begin{{cases}} {value} & {test} \neq 0 \\ 0 & {test} = 0 \end{{cases}}"

    def _print_CopySign(self, expression: Expression, exp: str | None = None) -> str:
        size, sign = map(self._print, expression.args)
        power = f"^{{{exp}}}" if exp else ""
        if expression.args[1] == 1:
            return rf"\left|{size}\right|{power}"
        return rf"\left|{size}\right| \operatorname*{{sgn}}\left({sign}\right)"


def name(symbol: str) -> str:
    r"""A symbol by its name in the derivation: ``M12`` is M with 12, ``rho_squared`` is rho squared.

    >>> print(name("M12"), name("l1"), name("rho_squared"), name("kappa"), name("across2"))
    M_{12} \ell_{1} \rho^{2} \kappa n_{2}
    """
    if symbol in WHOLE:
        return WHOLE[symbol]
    for letter in GREEK:
        rest = symbol.removeprefix(letter)
        if rest != symbol and not rest[:1].isalpha():
            return _below(rf"\{letter}", rest.strip("_").replace("_", ","))
    words = re.fullmatch(r"([A-Za-z]{2,}?)_?([0-9]*)", symbol)
    if words and (words.group(1) in STEMS or words.group(2)) and not re.fullmatch(r"[a-z][xyz][0-9]*", symbol):
        return _below(STEMS.get(words.group(1), rf"\mathrm{{{words.group(1)}}}"), words.group(2))
    stem, below = split_name(symbol)
    return _below(STEMS.get(stem, stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"), below)


def _below(stem: str, below: str) -> str:
    if not below:
        return stem
    return f"{stem}_{{{below}}}" if not re.search(r"[A-Za-z]{2}", below) else rf"{stem}_{{\mathrm{{{below}}}}}"


def latex(expression: Expression) -> str:
    """An expression, on one line."""
    printed: str = _Printer({"mul_symbol": r" \, "})._print(expression)
    return printed


def block(text: str) -> str:
    """A displayed formula of a page."""
    return f"```math\n{text}\n```"


def aligned(lines: Iterable[tuple[str, str]]) -> str:
    """Left = right, line under line; a long sum goes on in the next line."""
    written = []
    for left, right in lines:
        first, *more = _folded(right)
        written.append(f"{left} &= {first}")
        written += [rf"&\quad {part}" for part in more]
    return block("\\begin{align*}\n" + " \\\\\n".join(written) + "\n\\end{align*}")


def _folded(text: str) -> list[str]:
    """A sum cut before plus and minus signs outside brackets, in pieces of about :data:`LINE` characters."""
    pieces, depth, start = [], 0, 0
    for at, letter in enumerate(text):
        depth += {"{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1}.get(letter, 0)
        if depth == 0 and at - start >= LINE and text[at : at + 3] in (" + ", " - "):
            pieces.append(text[start:at].strip())
            start = at
    return [*pieces, text[start:].strip()]


def equations(pairs: Iterable[tuple[str, Expression]]) -> str:
    """Named expressions, line under line; a name that holds a backslash or a brace is LaTeX already."""
    return aligned((left if re.search(r"[\\{ ]", left) else name(left), latex(right)) for left, right in pairs)


def step_lines(steps: Sequence[Step]) -> list[tuple[str, str]]:
    """Named steps, without those whose name is the shorthand of their value (s2 = sin q2)."""
    pairs = ((name(step.symbol.name), latex(step.expression)) for step in steps)
    return [(left, right) for left, right in pairs if left != right]


def listing(program: Program) -> str:
    """A program as it is generated: its steps, then its outputs."""
    lines = step_lines(program.steps)
    for output in program.outputs:
        entries = [latex(entry) for entry in output.expressions]
        left = r"\ ".join(rf"\mathrm{{{word}}}" for word in output.name.split("_"))
        lines.append((left, entries[0] if output.shape == () else r"\left(" + ",\\; ".join(entries) + r"\right)"))
    return aligned(lines)
