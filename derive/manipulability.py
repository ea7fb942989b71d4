"""Maximal minors of a Jacobian, the manipulability H by Cauchy-Binet, the null vector and projector.

H = sqrt(det(J J^T)) = sqrt(sum of the squared maximal minors of J). The minors of an m x n matrix are expanded
row by row over subsets of columns (Laplace), so that they share their sub-minors: the 28 minors of a 6 x 8
need 246 of them. Where those become too many, an orthogonal factorisation takes their place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from chainrule.derive.program import Expression, GuardedInverse, Input, Matrix, Output, Program, Steps

#: Above this many sub-minors H comes from the factorisation (a 6 x 9 has 465, a 6 x 10 has 847).
MOST_SUBMINORS = 500
#: The projector is written out entry by entry up to this many joints.
MOST_PROJECTED = 16


def submatrices(m: int, n: int) -> int:
    """How many sub-minors the expansion of an m x n matrix meets."""
    return sum(math.comb(n, k) for k in range(1, m + 1))


def by_minors(m: int, n: int) -> bool:
    """Whether an m x n Jacobian is treated by its minors (else by factorisation)."""
    return submatrices(m, n) <= MOST_SUBMINORS


def maximal_minors(steps: Steps, matrix: Matrix) -> list[Expression]:
    """All m x m minors, in the order of ``itertools.combinations(range(n), m)``.

    Rows are expanded in the order of their non-zero entries, sparse rows first; the sign of that reordering
    is put back at the end.
    """
    m, n = len(matrix), len(matrix[0])
    order = sparse_first(matrix)
    sign = -1 if sum(a > b for a, b in combinations(order, 2)) % 2 else 1
    known: dict[tuple[int, ...], Expression] = {(): sp.Integer(1)}
    for size in range(1, m + 1):
        row = matrix[order[size - 1]]
        current = {}
        for columns in combinations(range(n), size):
            total = sp.Integer(0)
            for place, column in enumerate(columns):
                if row[column] != 0:
                    cofactor = known[columns[:place] + columns[place + 1 :]]
                    total += (-1) ** (size - 1 + place) * row[column] * cofactor
            current[columns] = steps.let("m" + "_".join(str(c + 1) for c in columns), total)
        known = current
    return [sign * known[columns] for columns in combinations(range(n), m)]


def sparse_first(matrix: Matrix) -> list[int]:
    """The rows in the order of their non-zero entries."""
    return sorted(range(len(matrix)), key=lambda r: (sum(entry != 0 for entry in matrix[r]), r))


def root_sum_of_squares(steps: Steps, entries: list[Expression]) -> Expression:
    """sqrt(sum e^2)."""
    squares = steps.let("sum_of_squares", sum((e**2 for e in entries), sp.Integer(0)))
    return sp.sqrt(squares)


def null_vector_from_minors(minors: list[Expression]) -> list[Expression]:
    """N with J N = 0 for an (n-1) x n matrix: N_j = (-1)^j times the minor without column j; |N| = H."""
    n = len(minors)
    # combinations(range(n), n-1) leaves out column n-1 first and column 0 last
    return [(-1) ** j * minors[n - 1 - j] for j in range(n)]


def orthonormal_rows(steps: Steps, matrix: Matrix, passes: int = 1) -> tuple[Matrix, Matrix]:
    """Gram-Schmidt on the rows: orthonormal rows Q, and the lower triangular R with R Q = matrix.

    The pivots on R's diagonal, whose product is H, are backward stable in the modified process, so one pass is enough
    for H; a second makes the rows orthonormal to rounding ("twice is enough"). A row that vanishes stays zero.
    """
    basis: Matrix = []
    lower: Matrix = []
    for k, row in enumerate(matrix, 1):
        rest, shares = list(row), [sp.Integer(0)] * len(basis)
        for turn in range(passes):
            tag = f"{k}" if turn == 0 else f"{k}again"
            for i, unit in enumerate(basis):
                along = steps.let(f"along{tag}", sum((a * b for a, b in zip(unit, rest, strict=True)), sp.Integer(0)))
                rest = [steps.let(f"rest{tag}", b - along * a) for a, b in zip(unit, rest, strict=True)]
                shares[i] = shares[i] + along
        pivot = steps.let(f"pivot{k}", root_sum_of_squares(steps, rest))
        inverse = steps.let(f"inverse{k}", GuardedInverse(pivot))
        basis.append([steps.let(f"unit{k}", entry * inverse) for entry in rest])
        lower.append([*shares, pivot])
    return basis, lower


@dataclass(frozen=True)
class OrthogonalRows:
    """L Q = matrix, with rows of Q across one another (not of length 1) and L lower triangular, 1 on its diagonal.

    Attributes:
        rows: of Q.
        lower: the entries of L left of the diagonal.
        squares: of the lengths of Q's rows; their roots are the pivots of :func:`orthonormal_rows`.
        inverses: of the squares; 0 for a row that vanishes.
    """

    rows: Matrix
    lower: Matrix
    squares: list[Expression]
    inverses: list[Expression]


def orthogonal_rows(steps: Steps, matrix: Matrix) -> OrthogonalRows:
    """Modified Gram-Schmidt on the rows without square roots."""
    found = OrthogonalRows([], [], [], [])
    for k, row in enumerate(matrix, 1):
        rest, shares = list(row), []
        for other, inverse in zip(found.rows, found.inverses, strict=True):
            along = sum((a * b for a, b in zip(other, rest, strict=True)), sp.Integer(0))
            shares.append(steps.let(f"share{k}", along * inverse))
            rest = [steps.let(f"rest{k}", b - shares[-1] * a) for a, b in zip(other, rest, strict=True)]
        square = steps.let(f"square{k}", sum((entry**2 for entry in rest), sp.Integer(0)))
        found.rows.append(rest)
        found.lower.append(shares)
        found.squares.append(square)
        found.inverses.append(steps.let(f"inverse{k}", GuardedInverse(square)))
    return found


def minors_program(steps: Steps, inputs: tuple[Input, ...], matrix: Matrix, task: str) -> Program:
    """All maximal minors of the task Jacobian."""
    minors = maximal_minors(steps, matrix)
    return Program(
        f"minors_{task}",
        f"maximal minors of the {task} Jacobian, columns in lexicographic order",
        inputs,
        tuple(steps.steps),
        (Output("minors", (len(minors),), tuple(minors)),),
    )


def weights_program(steps: Steps, inputs: tuple[Input, ...], matrix: Matrix, task: str) -> Program:
    """The quantities whose norm (minors) or product (pivots) is H: what the gradient is taken through."""
    if by_minors(len(matrix), len(matrix[0])):
        return minors_program(steps, inputs, matrix, task)
    pivots = [row[-1] for row in orthonormal_rows(steps, matrix)[1]]
    return Program(
        f"pivots_{task}",
        f"pivots of the {task} Jacobian's orthogonal factorisation; H is their product",
        inputs,
        tuple(steps.steps),
        (Output("pivots", (len(pivots),), tuple(pivots)),),
    )


def manipulability(weights: Program, task: str) -> Program:
    """H = sqrt(det(J J^T)) from the minors (their norm) or pivots (their product)."""
    steps, output = Steps(weights.steps), weights.outputs[0]
    if output.name == "minors":
        value = root_sum_of_squares(steps, list(output.expressions))
    else:
        value = sp.prod(output.expressions)
    return Program(
        f"manipulability_{task}",
        f"manipulability H = sqrt(det(J J^T)) of the {task} Jacobian",
        weights.inputs,
        tuple(steps.steps),
        (Output("manipulability", (), (value,)),),
    )


def null_vector(weights: Program, task: str) -> Program:
    """N from the signed minors: J N = 0, |N| = H, and zero exactly at the singular configurations."""
    entries = null_vector_from_minors(list(weights.outputs[0].expressions))
    return Program(
        f"null_vector_{task}",
        f"null vector of the {task} Jacobian from its signed minors, |N| = H",
        weights.inputs,
        weights.steps,
        (Output("null_vector", (len(entries),), tuple(entries)),),
    )


def null_projector(steps: Steps, inputs: tuple[Input, ...], matrix: Matrix, task: str) -> Program:
    """P = I - Q^T Q with orthonormal rows Q spanning those of J: P = I - J^+ J where J has full rank."""
    basis, _ = orthonormal_rows(steps, matrix, passes=2)
    n = len(matrix[0])
    upper = {
        (i, j): steps.let(
            f"P{i + 1}_{j + 1}", sp.Integer(i == j) - sum((unit[i] * unit[j] for unit in basis), sp.Integer(0))
        )
        for i in range(n)
        for j in range(i, n)
    }
    entries = tuple(upper[min(i, j), max(i, j)] for i in range(n) for j in range(n))
    return Program(
        f"null_projector_{task}",
        f"projector I - J^+ J onto the null space of the {task} Jacobian",
        inputs,
        tuple(steps.steps),
        (Output("null_projector", (n, n), entries),),
    )
