"""The step of a redundant arm along a task: rates that do the task, and motion of the joints to spare.

    rates = J* (v - K e) + (I - J+ J) g,    g = sum_k gain_k grad c_k + push,    q_next = q + dt rates

J+ is the pseudoinverse weighted by the joints: of all rates that do the task it takes those with the least
(rates - g)^T W (rates - g). With mobility_j = W_jj^(-1/2) the rows of J diag(mobility) are factored into R Q by
twice-iterated Gram-Schmidt, Q with orthonormal rows and R lower triangular; then J+ v = diag(mobility) Q^T R^-1 v and
(I - J+ J) g = diag(mobility) (I - Q^T Q) diag(stiffness) g, stiffness_j = 1 / mobility_j. A joint with 0 for both
stands still. A row that vanishes in the factorisation is left out.

J* is J+ or, with damping mu, diag(mobility) Q^T R^T (R R^T + mu^2 I)^-1: least |J rates - v|^2 + mu^2 rates^T W rates.
The null motion is not damped: it leaves the task alone, near singularities too.

    mu^2 = constant^2 + nakamura^2 max(0, 1 - H / H_0)^2 + chiaverini^2 max(0, 1 - (s / s_0)^2)

(Nakamura and Hanafusa 1986; Chiaverini 1997), with s an estimate of the least singular value s_m of J diag(mobility),
m rows: s_m / sqrt(m) <= s <= s_m, and s / s_m -> 1 where s_m becomes small beside the others, since
s = (sum of s_k^-2)^(-1/2) is the inverse of the Frobenius norm of R^-1.

The criteria are H = sqrt(det(J J^T)), 1/H, H^(-1/2) (with gradient 0 where H = 0) and the distance from the joints'
middles, sum of ((q_j - middle_j) narrowness_j)^2 / (2 n) (Liegeois 1977).

e is, row by row: position minus target; for an orientation 2 sin(angle / 2), spatially times the axis, of what turns
the target into the tip. That grows up to half a turn, where it has no axis and is 0.

A secondary task of strict priority, J2 rates = v2 as far as the first task allows: its rows follow in the same
factorisation, so that rates = J1+ v1 + (J2 P1)+ (v2 - J2 rates_1) + P12 g is one forward substitution.
"""

from __future__ import annotations

from types import ModuleType
from typing import Any

import sympy as sp

from chainrule.derive import self_motion
from chainrule.derive.differentiation import gradient
from chainrule.derive.manipulability import Matrix, orthonormal_rows, root_sum_of_squares
from chainrule.derive.program import Expression, GuardedInverse, Input, Output, Program, Steps, Where, variables

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
    matrix = _rows(found.jacobian.expressions, n)
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
    basis, triangle = orthonormal_rows(steps, scaled, passes=2)
    lower = [[steps.let("lower", entry) for entry in row] for row in triangle]
    h, slope = _manipulability(steps, weights, q.symbols)
    first = [row[:m] for row in lower[:m]]
    least = max_zero(steps, "short", 1 - h * given["inverse_threshold_H"])
    nakamura = steps.let("nakamura", given["damping_nakamura"] * least)
    along = _solved(steps, first, wanted, given, nakamura)
    if more:
        rest = [
            steps.let("rest_second", v - _dot(row[:m], along)) for v, row in zip(wanted_second, lower[m:], strict=True)
        ]
        along = along + _solved(steps, [row[m:] for row in lower[m:]], rest, given, sp.Integer(0))

    null = [sp.Integer(0)] * n
    if n > len(basis) or more:
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
        null = _left(steps, basis, stretched)
        null = [steps.let("null", a * entry) for a, entry in zip(mobility, null, strict=True)]
    rates = [
        steps.let("rate", a * sum((y * unit[j] for y, unit in zip(along, basis, strict=True)), sp.Integer(0)) + null[j])
        for j, a in enumerate(mobility)
    ]
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


def _left(steps: Steps, basis: Matrix, vector: Vector) -> Vector:
    """(I - Q^T Q) vector."""
    shares = [steps.let("share", _dot(unit, vector)) for unit in basis]
    return [
        steps.let(
            "left", entry - sum((share * unit[j] for share, unit in zip(shares, basis, strict=True)), sp.Integer(0))
        )
        for j, entry in enumerate(vector)
    ]


def _solved(steps: Steps, lower: Matrix, wanted: Vector, given: dict[str, Expression], nakamura: Expression) -> Vector:
    """y with R y = wanted or, where mu is not 0, y = R^T (R R^T + mu^2 I)^-1 wanted, for a lower triangular R."""
    inverses = [steps.let("inverse_pivot", GuardedInverse(row[k])) for k, row in enumerate(lower)]
    plain: Vector = []
    for row, v, inverse in zip(lower, wanted, inverses, strict=True):
        plain.append(steps.let("plain", (v - _dot(row[: len(plain)], plain)) * inverse))
    ratio = steps.let("ratio", _least_singular(steps, lower, inverses) * given["inverse_threshold_s"])
    near = max_zero(steps, "near", 1 - ratio * ratio)
    constant, chiaverini = given["damping_constant"], given["damping_chiaverini"]
    damping = steps.let("damping", constant**2 + nakamura**2 + chiaverini**2 * near)
    damped = _damped(steps, lower, wanted, damping)
    chosen = steps.let("is_damped", Where(damping, sp.Integer(1)))
    other = steps.let("is_plain", 1 - chosen)
    return [
        steps.let("solved", Where(chosen, steps.let("damped", a)) + Where(other, b))
        for a, b in zip(damped, plain, strict=True)
    ]


def _least_singular(steps: Steps, lower: Matrix, inverses: Vector) -> Expression:
    """The estimate s of the least singular value, from the entries of R^-1; no pivot is less than that value."""
    inverse: Matrix = []
    for i, row in enumerate(lower):
        sums = (sum((row[k] * inverse[k][j] for k in range(j, i)), sp.Integer(0)) for j in range(i))
        inverse.append([*(steps.let("entry", -inverses[i] * total) for total in sums), inverses[i]])
    norm = steps.let("norm", root_sum_of_squares(steps, [entry for row in inverse for entry in row]))
    far = steps.let("far", GuardedInverse(norm))
    return steps.let("smallest", sp.Min(*(row[k] for k, row in enumerate(lower)), far))


def _damped(steps: Steps, lower: Matrix, wanted: Vector, damping: Expression) -> Vector:
    """R^T (R R^T + mu^2 I)^-1 wanted, by the factors L D L^T, whose pivots D are at least mu^2.

    Its relative error is some units of rounding times (s_1^2 + mu^2) / (s_m^2 + mu^2), with s_1 and s_m the extreme
    singular values of R.
    """
    m = len(lower)
    factors: Matrix = []  # rows of L
    inverses: Vector = []  # of D
    u: Vector = []
    for i in range(m):
        products: Vector = []  # L_ij D_j
        entries: Vector = []
        for j in range(i):
            square = _dot(lower[i][: j + 1], lower[j][: j + 1])
            products.append(steps.let("product", square - _dot(products, factors[j])))
            entries.append(steps.let("factor_entry", products[j] * inverses[j]))
        whole = steps.let("pivot_damped", _dot(lower[i], lower[i]) - _dot(products, entries) + damping)
        inverses.append(steps.let("inverse_damped", GuardedInverse(steps.let("pivot_kept", sp.Max(whole, damping)))))
        factors.append(entries)
        u.append(steps.let("down", wanted[i] - _dot(entries, u)))
    u = [steps.let("across", a * b) for a, b in zip(u, inverses, strict=True)]
    for i in range(m - 1, -1, -1):
        u[i] = steps.let("up", u[i] - _dot([factors[k][i] for k in range(i + 1, m)], u[i + 1 :]))
    return [_dot([lower[k][i] for k in range(i, m)], u[i:]) for i in range(m)]
