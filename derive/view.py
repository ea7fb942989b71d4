"""The rows of a task Jacobian as an inner link sees them: from another place, with fewer terms."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.program import Matrix


@dataclass(frozen=True)
class View:
    """What leads from the task Jacobian J to a matrix ``move turn J`` with the same minors, row space and fewer terms.

    Attributes:
        turn: (m, m) orthogonal: the directions that the rows are seen along.
        move: (m, m) of determinant 1, I + N with N N = 0: the point whose velocity is seen.
    """

    turn: Matrix
    move: Matrix


def identity(m: int) -> Matrix:
    """I."""
    return [[sp.Integer(i == j) for j in range(m)] for i in range(m)]
