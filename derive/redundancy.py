"""The step of a redundant arm along a task: rates that do the task, and motion of the joints to spare.

    rates = J* (v - K e) + (I - J+ J) g,    g = sum_k gain_k grad c_k + push,    q_next = q + dt rates

J+ is the pseudoinverse weighted by the joints: of all rates that do the task it takes those with the least
(rates - g)^T W (rates - g). The rows are taken as an inner link sees them, M = A J, where they have the fewest terms:
A turns them and, for the pose of a spatial arm, takes the velocity of another point, so that J rates = v where
M rates = A v. With mobility_j = W_jj^(-1/2) the rows of M diag(mobility) are factored into L Q by modified
Gram-Schmidt, L lower triangular with ones on its diagonal, Q with rows across one another up to rounding times the
condition of J; D has the squares of their lengths. What is made of Q is as accurate as by reflections (Bjorck and Paige
1992; Bjorck 1994): the shortest x with Q x = z row by row, from the last one, x becoming
x + Q_k (z_k - Q_k x) / D_k, and what is left of u across the rows by u becoming u - Q_k (Q_k u) / D_k through all of
them and back. Then J+ v = diag(mobility) Q^T D^-1 L^-1 A v and (I - J+ J) g =
diag(mobility) (I - Q^T D^-1 Q) diag(stiffness) g, with stiffness_j = 1 / mobility_j. A joint with 0 for both stands
still. A row that vanishes in the factorisation is left out.

J* is J+ or, with damping mu and B = A^-1 L, diag(mobility) Q^T B^T (B D B^T + mu^2 I)^-1: least
|J rates - v|^2 + mu^2 rates^T W rates. The null motion is not damped: it leaves the task alone, near singularities too.

    mu^2 = constant^2 + nakamura^2 max(0, 1 - H / H_0)^2 + chiaverini^2 max(0, 1 - (s / s_0)^2)

(Nakamura and Hanafusa 1986; Chiaverini 1997), with s an estimate of the least singular value s_m of J diag(mobility),
m rows: s_m / sqrt(m) <= s <= s_m, and s / s_m -> 1 where s_m becomes small beside the others, since
s = (sum of s_k^-2)^(-1/2) is the inverse of the Frobenius norm of D^(-1/2) B^-1.

The criteria are H = sqrt(det(J J^T)), 1/H, H^(-1/2) (with gradient 0 where H = 0) and the distance from the joints'
middles, sum of ((q_j - middle_j) narrowness_j)^2 / (2 n) (Liegeois 1977).

e is, row by row: position minus target; for an orientation 2 sin(angle / 2), spatially times the axis, of what turns
the target into the tip. That grows up to half a turn, where it has no axis and is 0.

A secondary task of strict priority, J2 rates = v2 as far as the first task allows: its rows follow in the same
factorisation, so that rates = J1+ v1 + (J2 P1)+ (v2 - J2 rates_1) + P12 g is one forward substitution.

What a law does without (gradients, motion of the joints to spare, damping, s) is written with Where, so that compiled
code passes over it (skipping.py).
"""

from __future__ import annotations

from types import ModuleType
from typing import Any

import sympy as sp

from chainrule.derive import self_motion
from chainrule.derive.differentiation import gradient
from chainrule.derive.manipulability import OrthogonalRows, orthogonal_rows, root_sum_of_squares, sparse_first
from chainrule.derive.program import Expression, GuardedInverse, Input, Matrix, Output, Program, Steps, Where, variables
from chainrule.derive.view import View, identity

Vector = list[Expression]

#: The entries of the input ``settings``; a threshold is given by its inverse, so that 0 switches it off.
SETTINGS = (
    "feedback_position",
    "feedback_orientation",
    "gain_H",
    "gain_inverse_H",
    "gain_inverse_root_H",
    "gain_limits",
    "damping_constant",
    "damping_nakamura",
    "inverse_threshold_H",
    "damping_chiaverini",
    "inverse_threshold_s",
    "dt",
)
#: The rows of the input ``joints``: W^(-1/2), its inverse (or 0 where that is 0), the middle of the range, 1 / half it.
JOINTS = ("mobility", "stiffness", "middle", "narrowness")
#: The most rows of a secondary task.
MOST_SECONDARY = 6


def step(family: ModuleType, arm: Any, task: str, weights: Program) -> Program:
    """One step along the task, with the gradients of the criteria projected into the null space.

    Args:
        family: the arm's module.
        arm: the symbolic arm.
        task: the task.
        weights: the minors of the task Jacobian, or its pivots.
    """
    return _law(family, arm, task, weights, 0)


def priority(family: ModuleType, arm: Any, task: str, weights: Program, spare: int) -> Program | None:
    """The same with a secondary task of strict priority, whose Jacobian and velocity are inputs."""
    return _law(family, arm, task, weights, min(spare, MOST_SECONDARY)) if spare > 0 else None


def _law(family: ModuleType, arm: Any, task: str, weights: Program, more: int) -> Program:
    steps, q, n = Steps(), arm.inputs[0], arm.n
    target = self_motion.target_input(family, task)
    found = self_motion.apart(steps, family, arm, task, target)
    m = found.jacobian.shape[0]
    velocity, push = variables("velocity", m), variables("push", n)
    joints = Input(
        "joints", (len(JOINTS), n), tuple(sp.Symbol(f"{row}{j + 1}", real=True) for row in JOINTS for j in range(n))
    )
    mobility, stiffness, middle, narrowness = _rows(joints.symbols, n)
    settings = Input("settings", (len(SETTINGS),), tuple(sp.Symbol(name, real=True) for name in SETTINGS))
    given = dict(zip(SETTINGS, settings.symbols, strict=True))
    rows = family.minor_matrix(steps, arm, task)
    view = family.minor_view(steps, arm, task)
    order = sparse_first(rows)
    matrix = [rows[r] for r in order]
    secondary: tuple[Input, ...] = ()
    wanted_second: Vector = []
    if more:
        entries = tuple(sp.Symbol(f"secondary{i + 1}_{j + 1}", real=True) for i in range(more) for j in range(n))
        secondary = (Input("secondary", (more, n), entries), variables("secondary_velocity", more))
        matrix += _rows(entries, n)
        wanted_second = list(secondary[1].symbols)

    error = _error(steps, found)
    gains = [given["feedback_position"]] * len(found.lengths) + [given["feedback_orientation"]] * len(found.turn)
    wanted = [
        steps.let(f"wanted{i}", v - k * e)
        for i, (v, k, e) in enumerate(zip(velocity.symbols, gains, error, strict=True))
    ]
    scaled = [[steps.let("scaled", e * a) for e, a in zip(row, mobility, strict=True)] for row in matrix]
    rows_found = orthogonal_rows(steps, scaled)
    h, slope = _manipulability(steps, weights, q.symbols)
    least = max_zero(steps, "short", 1 - h * given["inverse_threshold_H"])
    nakamura = steps.let("nakamura", given["damping_nakamura"] * least)
    shares = _solved(steps, _part(rows_found, 0, m), order, view, wanted, given, nakamura)
    if more:
        rest = [
            steps.let("rest_second", v - _dot(row[:m], shares))
            for v, row in zip(wanted_second, rows_found.lower[m:], strict=True)
        ]
        unmoved = View(identity(more), identity(more))
        second = _part(rows_found, m, m + more)
        shares = shares + _solved(steps, second, list(range(more)), unmoved, rest, given, sp.Integer(0))

    null = [sp.Integer(0)] * n
    if n > m:
        to_raise = [given[name] for name in ("gain_H", "gain_inverse_H", "gain_inverse_root_H")]
        raised = _number_of_others_than_zero(steps, "raised", to_raise)
        slope = [steps.let("slope", Where(raised, d)) for d in slope]
        inverse = steps.let("inverse_h", GuardedInverse(h))
        steep = steps.let("steep_inverse", given["gain_inverse_H"] * inverse)
        steeper = steps.let("steep_root", given["gain_inverse_root_H"] * inverse)
        factor = steps.let("factor", given["gain_H"] - steep * inverse - steeper * sp.sqrt(inverse) / 2)
        to_limits = steps.let("gain_each", given["gain_limits"] / n)
        moved = [
            factor * d + to_limits * (q_j - centre) * narrow * narrow + own
            for d, q_j, centre, narrow, own in zip(slope, q.symbols, middle, narrowness, push.symbols, strict=True)
        ]
        stretched = [steps.let("uphill", g * stiff) for g, stiff in zip(moved, stiffness, strict=True)]
        uphill = _number_of_others_than_zero(steps, "pushed", stretched)
        null = [steps.let("left", Where(uphill, entry)) for entry in _projected(steps, rows_found, stretched)]
        null = [steps.let("null", a * entry) for a, entry in zip(mobility, null, strict=True)]
    done = _least_norm(steps, rows_found, shares)
    rates = [steps.let("rate", a * x + y) for a, x, y in zip(mobility, done, null, strict=True)]
    ahead = [q_j + given["dt"] * rate for q_j, rate in zip(q.symbols, rates, strict=True)]
    kind = "step" if not more else "priority"
    what = f"step along the {task}" if not more else f"step along the {task}, with a secondary task of strict priority"
    return Program(
        f"{kind}_{task}",
        what,
        (q, target, velocity, *secondary, push, joints, settings, *arm.inputs[1:]),
        tuple(steps.steps),
        (
            Output("q_next", (n,), tuple(ahead)),
            Output("rates", (n,), tuple(rates)),
            Output("manipulability", (), (h,)),
            Output("error", (m,), tuple(error)),
            Output("null_motion", (n,), tuple(null)),
        ),
    )


def _rows(entries: tuple[Expression, ...], n: int) -> Matrix:
    return [list(entries[k : k + n]) for k in range(0, len(entries), n)]


def _dot(a: Vector, b: Vector) -> Expression:
    return sum((x * y for x, y in zip(a, b, strict=True)), sp.Integer(0))


def max_zero(steps: Steps, name: str, expression: Expression) -> Expression:
    """max(expression, 0)."""
    return steps.let(name, sp.Max(steps.let(f"signed_{name}", expression), 0))


def _error(steps: Steps, found: self_motion.Apart) -> Vector:
    """The error of the task: lengths, then 2 sin(angle / 2) along the axis, sin(angle) divided by cos(angle / 2)."""
    if not found.turn:
        return found.lengths
    half = max_zero(steps, "half_turn", (1 + found.cosine) / 2)
    inverse = steps.let("inverse_half", GuardedInverse(steps.let("cosine_half", sp.sqrt(half))))
    return found.lengths + [steps.let("turned", s * inverse) for s in found.turn]


def _manipulability(steps: Steps, weights: Program, q: tuple[Expression, ...]) -> tuple[Expression, Vector]:
    """H and its gradient, through the minors or pivots; 0 where H is 0."""
    known: dict[Expression, Expression] = {}
    for one in weights.steps:
        known[one.symbol] = steps.let(str(one.symbol), one.expression.xreplace(known))
    (output,) = weights.outputs
    parts = [steps.let("weight", entry.xreplace(known)) for entry in output.expressions]
    if output.name == "minors":
        h = steps.let("h", root_sum_of_squares(steps, parts))
        inverse = steps.let("inverse_h", GuardedInverse(h))
        seeds = [steps.let("seed", part * inverse) for part in parts]
    else:  # H is the product of the pivots: each seed is the product of the others
        before, after = [sp.Integer(1)], [sp.Integer(1)]
        for part, other in zip(parts, reversed(parts), strict=True):
            before.append(steps.let("before", before[-1] * part))
            after.append(steps.let("after", after[-1] * other))
        h = before[-1]
        seeds = [steps.let("seed", a * b) for a, b in zip(before, reversed(after[:-1]), strict=False)]
    return h, gradient(steps, parts, seeds, q)


def _number_of_others_than_zero(steps: Steps, name: str, entries: Vector) -> Expression:
    """How many entries are not 0 (nan is not 0)."""
    return steps.let(name, sum((Where(entry, sp.Integer(1)) for entry in entries), sp.Integer(0)))


def _part(found: OrthogonalRows, start: int, end: int) -> OrthogonalRows:
    """Some of the rows, with what they share among themselves."""
    lower = [row[start:] for row in found.lower[start:end]]
    return OrthogonalRows(found.rows[start:end], lower, found.squares[start:end], found.inverses[start:end])


def _projected(steps: Steps, across: OrthogonalRows, vector: Vector) -> Vector:
    """What is left of the vector across the rows: by all of them and back."""
    left = list(vector)
    pairs = list(zip(across.rows, across.inverses, strict=True))
    for row, inverse in [*pairs, *reversed(pairs[:-1])]:
        share = steps.let("along", _dot(row, left) * inverse)
        left = [steps.let("left_over", entry - share * u) for entry, u in zip(left, row, strict=True)]
    return left


def _least_norm(steps: Steps, across: OrthogonalRows, wanted: Vector) -> Vector:
    """The shortest vector x with Q x = wanted, from the last row to the first."""
    found: Vector = [sp.Integer(0)] * len(across.rows[0])
    for row, inverse, value in reversed(list(zip(across.rows, across.inverses, wanted, strict=True))):
        missing = steps.let("missing", (value - _dot(row, found)) * inverse)
        found = [steps.let("found", entry + missing * u) for entry, u in zip(found, row, strict=True)]
    return found


def _times(steps: Steps, name: str, matrix: Matrix, vector: Vector) -> Vector:
    return [steps.let(name, _dot(row, vector)) for row in matrix]


def _solved(
    steps: Steps,
    across: OrthogonalRows,
    order: list[int],
    view: View,
    wanted: Vector,
    given: dict[str, Expression],
    nakamura: Expression,
) -> Vector:
    """z with L z = A wanted or, where mu is not 0, z = D B^T (B D B^T + mu^2 I)^-1 wanted: what Q x is to be.

    Row i of L belongs to row order[i] of A.
    """
    turned = _times(steps, "turned", view.turn, wanted)
    seen = _times(steps, "seen", view.move, turned)
    plain: Vector = []
    for row, place in zip(across.lower, order, strict=True):
        plain.append(steps.let("plain", seen[place] - _dot(row, plain)))
    constant, chiaverini = given["damping_constant"], given["damping_chiaverini"]
    least = steps.let("least", Where(chiaverini, _least_singular(steps, across, order, view)))
    ratio = steps.let("ratio", least * given["inverse_threshold_s"])
    near = max_zero(steps, "near", 1 - ratio * ratio)
    damping = steps.let("damping", constant**2 + nakamura**2 + chiaverini**2 * near)
    damped = _damped(steps, across, order, view, turned, damping)
    chosen = steps.let("is_damped", Where(damping, sp.Integer(1)))
    other = steps.let("is_plain", 1 - chosen)
    return [
        steps.let("solved", Where(damping, steps.let("damped", a)) + Where(other, b))
        for a, b in zip(damped, plain, strict=True)
    ]


def _least_singular(steps: Steps, across: OrthogonalRows, order: list[int], view: View) -> Expression:
    """The estimate s of the least singular value, from the entries of D^(-1/2) L^-1 move; 0 where a row vanishes."""
    m = len(order)
    inverse: Matrix = []  # L^-1
    for i, row in enumerate(across.lower):
        sums = (sum((row[k] * inverse[k][j] for k in range(j, i)), sp.Integer(0)) for j in range(i))
        inverse.append([*(steps.let("entry", -total) for total in sums), sp.Integer(1)])
    squares = []
    for row, weight in zip(inverse, across.inverses, strict=True):
        moved = [
            steps.let("entry_moved", sum((a * view.move[order[j]][c] for j, a in enumerate(row)), sp.Integer(0)))
            for c in range(m)
        ]
        squares.append(steps.let("square_of_row", _dot(moved, moved)) * weight)
    norm = steps.let("norm", sp.sqrt(steps.let("sum_of_rows", sum(squares, sp.Integer(0)))))
    far = steps.let("far", GuardedInverse(norm))
    shortest = steps.let("shortest", sp.Min(*across.squares))
    return steps.let("smallest", Where(shortest, far))


def _damped(
    steps: Steps, across: OrthogonalRows, order: list[int], view: View, turned: Vector, damping: Expression
) -> Vector:
    """D B^T (B D B^T + mu^2 I)^-1 turned, by factors triangular, diagonal, triangular; the pivots are at least mu^2.

    Its relative error is some units of rounding times (s_1^2 + mu^2) / (s_m^2 + mu^2), with s_1 and s_m the extreme
    singular values of J diag(mobility).
    """
    m = len(order)
    whole = [[*row, sp.Integer(1)] for row in across.lower]  # L
    weighted = [  # L D
        [steps.let("weighted", entry * square) for entry, square in zip(row, across.squares, strict=False)]
        for row in whole
    ]
    back = [[2 * sp.Integer(r == s) - view.move[r][s] for s in order] for r in order]  # move^-1
    gram = [[sp.Integer(0)] * m for _ in range(m)]
    for i in range(m):
        for j in range(i + 1):
            gram[i][j] = gram[j][i] = steps.let("gram", _dot(weighted[i][: j + 1], whole[j]))
    half = [[steps.let("half", _dot(row, list(column))) for column in zip(*gram, strict=True)] for row in back]
    factors: Matrix = []  # rows of the triangular one
    inverses: Vector = []  # of the diagonal one
    u: Vector = []
    for i in range(m):
        products: Vector = []  # entries of a row times the pivots
        entries: Vector = []
        for j in range(i):
            square = _dot(half[i], back[j])
            products.append(steps.let("product", square - _dot(products, factors[j])))
            entries.append(steps.let("factor_entry", products[j] * inverses[j]))
        pivot = steps.let("pivot_damped", _dot(half[i], back[i]) - _dot(products, entries) + damping)
        inverses.append(steps.let("inverse_damped", GuardedInverse(steps.let("pivot_kept", sp.Max(pivot, damping)))))
        factors.append(entries)
        u.append(steps.let("down", turned[order[i]] - _dot(entries, u)))
    u = [steps.let("across", a * b) for a, b in zip(u, inverses, strict=True)]
    for i in range(m - 1, -1, -1):
        u[i] = steps.let("up", u[i] - _dot([factors[k][i] for k in range(i + 1, m)], u[i + 1 :]))
    u = [steps.let("unmoved", _dot(list(column), u)) for column in zip(*back, strict=True)]
    return [_dot([row[i] for row in weighted[i:]], u[i:]) for i in range(m)]
