"""Formulas as MathML, from SymPy's printer, in the field's shorthand: s2 for sin q2, c12 for cos(q1 + q2).

Numbers of a description are exact rationals of doubles; they are written as the decimals that name the same doubles.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from html import escape
from typing import Any

import sympy as sp
from markupsafe import Markup
from sympy.printing.mathml import MathMLPresentationPrinter

Expression = Any


class _Printer(MathMLPresentationPrinter):  # type: ignore[misc]
    """SymPy's presentation MathML with short names for sines, cosines and the steps' symbols."""

    def _print_Symbol(self, symbol: Expression, style: str = "plain") -> Any:
        number = re.fullmatch(r"[0-9].*", symbol.name)
        if number:
            return self._leaf("mn", symbol.name)
        stem, below = split_name(symbol.name)
        if not below:
            return self._leaf("mi", stem)
        return self._below(stem, below)

    def _print_sin(self, expression: Expression) -> Any:
        return self._turned("s", "sin", expression)

    def _print_cos(self, expression: Expression) -> Any:
        return self._turned("c", "cos", expression)

    def _print_GuardedInverse(self, expression: Expression) -> Any:
        return self._print(sp.Pow(expression.args[0], -1, evaluate=False))

    def _turned(self, short: str, name: str, expression: Expression) -> Any:
        numbers = joint_numbers(expression.args[0])
        if numbers:
            return self._below(short, numbers)
        row = self.dom.createElement("mrow")
        row.appendChild(self._leaf("mi", name))
        row.appendChild(self._leaf("mo", "\u2061"))
        for part in (self._leaf("mo", "("), self._print(expression.args[0]), self._leaf("mo", ")")):
            row.appendChild(part)
        return row

    def _leaf(self, tag: str, text: str) -> Any:
        leaf = self.dom.createElement(tag)
        leaf.appendChild(self.dom.createTextNode(text))
        return leaf

    def _below(self, stem: str, below: str) -> Any:
        pair = self.dom.createElement("msub")
        pair.appendChild(self._leaf("mi", stem))
        pair.appendChild(self._leaf("mn" if below.isdigit() else "mi", below))
        return pair


_GREEK = {"ell": "ℓ"}


def split_name(name: str) -> tuple[str, str]:
    """A symbol's name as letter and subscript: ``m1_2`` is m with 1,2; ``x4_y`` is x with 4,y; ``l1`` is ℓ with 1.

    >>> split_name("m1_2"), split_name("p4bx"), split_name("sum_of_squares")
    (('m', '1,2'), ('p', '4b,x'), ('S', ''))
    """
    if name == "sum_of_squares":
        return "S", ""
    if name.startswith("heading"):
        return "φ", name.removeprefix("heading")
    found = re.fullmatch(r"([A-Za-z])([xyz]?)([0-9].*|e[xyz]?)?", name)
    if found is None:
        head, _, rest = name.partition("_")
        return head, rest.replace("_", ",")
    stem, axis, rest = found.group(1), found.group(2), found.group(3) or ""
    rest = re.sub(r"(?<=[0-9a-z])_?([xyz])$", r",\1", rest).replace("_", ",")
    below = ",".join(part for part in (rest, axis) if part)
    return ("ℓ" if stem == "l" else stem), below


def joint_numbers(angle: Expression) -> str:
    """The subscript of a sum of joint angles: "12" for q1 + q2, "" for anything else."""
    terms = angle.args if angle.is_Add else (angle,)
    names = [term.name if term.is_Symbol else "" for term in terms]
    if not all(re.fullmatch(r"q[0-9]+", name) for name in names):
        return ""
    numbers = sorted(int(name[1:]) for name in names)
    return ("" if max(numbers) < 10 else ",").join(map(str, numbers))


def decimal(number: Expression) -> Expression:
    """The exact rational of a double as the shortest decimal naming that double; integers stay."""
    if number.q == 1:
        return number
    text = repr(abs(float(number)))
    if "e" in text:
        mantissa, exponent = text.split("e")
        text = f"{mantissa}·10^{int(exponent)}"
    symbol = sp.Symbol(text, positive=True)
    return symbol if number > 0 else -symbol


def with_decimals(expression: Expression) -> Expression:
    """The expression with its exact rationals replaced by decimals (exponents are left alone)."""
    if not isinstance(expression, sp.Basic):
        return expression
    if expression.is_Rational:
        return decimal(expression)
    if expression.is_Pow:
        return sp.Pow(with_decimals(expression.base), expression.exp)
    if not expression.args:
        return expression
    return expression.func(*(with_decimals(argument) for argument in expression.args))


def inner(expression: Expression) -> str:
    """An expression as the inside of a ``<math>`` element."""
    printer = _Printer({"mul_symbol": None})
    text = printer._print(with_decimals(sp.S(expression))).toxml()
    for written, meant in (("&InvisibleTimes;", "\u2062"), ("<mo>-</mo>", "<mo>\u2212</mo>")):
        text = str(text).replace(written, meant)
    return str(text)


def math(body: str) -> Markup:
    """A ``<math>`` element around ``body``, which is ours, with the spacing of a displayed formula."""
    return Markup(f'<math displaystyle="true">{body}</math>')


def row(*parts: str) -> str:
    """Parts side by side."""
    return "<mrow>" + "".join(parts) + "</mrow>"


def operator(sign: str) -> str:
    """An operator."""
    return f"<mo>{escape(sign)}</mo>"


def name(text: str) -> str:
    """A symbol by its name, as the steps write it."""
    return inner(sp.Symbol(text))


def bold(letter: str, below: str = "") -> str:
    """A vector or matrix: a bold letter, perhaps with a subscript."""
    code = ord(letter) - ord("A") + 0x1D400 if letter.isupper() else ord(letter) - ord("a") + 0x1D41A
    base = f"<mi>{chr(code)}</mi>"
    return f"<msub>{base}<mi>{escape(below)}</mi></msub>" if below else base


def determinant(body: str) -> str:
    """det body."""
    return row("<mi>det</mi>", '<mspace width="0.17em"></mspace>', body)


def squared(expression: Expression) -> str:
    """An expression in brackets, squared."""
    return f"<msup>{row(operator('('), inner(expression), operator(')'))}<mn>2</mn></msup>"


def matrix(rows: Sequence[Sequence[Expression]]) -> str:
    """A matrix in brackets."""
    cells = "".join("<mtr>" + "".join(f"<mtd>{inner(e)}</mtd>" for e in line) + "</mtr>" for line in rows)
    return row(operator("["), f"<mtable>{cells}</mtable>", operator("]"))


def equation(left: str, *right: str) -> Markup:
    """left = right, as a display."""
    return math(row(left, operator("="), *right))


@cache
def symbol_equation(left: str, right: Expression) -> Markup:
    """A named step: its symbol = its expression (a sine or cosine in full, since its name is the shorthand)."""
    if isinstance(right, sp.sin | sp.cos) and right.args[0].is_Symbol:
        function = "sin" if isinstance(right, sp.sin) else "cos"
        return equation(name(left), f"<mi>{function}</mi>", '<mspace width="0.17em"></mspace>', inner(right.args[0]))
    return equation(name(left), inner(right))


def factors(expression: Expression) -> tuple[Expression, list[Expression]]:
    """The number in front and the factors of a polynomial in sines and cosines, none with a leading minus."""
    front, listed = sp.factor_list(expression)
    found = []
    for factor, power in listed:
        flip = factor.could_extract_minus_sign()
        front *= (-1) ** power if flip else 1
        found += [-factor if flip else factor] * power
    return front, sorted(found, key=lambda f: (f.is_Add, sp.count_ops(f)))
