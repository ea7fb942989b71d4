"""The self-motion of a planar 3R arm in closed form, for the tasks (x, y) and (x, alpha) (Lenarcic's two examples).

Both tasks reduce to one curve. With the headings a1, a2, a3 of the links and the target at the distance r:

- position: l1 e1 + l2 e2 + l3 e3 = r e closes a quadrilateral. Its diagonal from the base to the last joint,
  V = l1 e1 + l2 e2, has the square x = |V|^2, and y1 = 2 l1 e1 x l2 e2, y2 = 2 V x l3 e3 are four times the areas of
  the two triangles that it makes:  y1^2 = (A - x) (x - B),  y2^2 = (C - x) (x - E)  with
  A, B = (l1 +- l2)^2 and C, E = (r +- l3)^2;
- x_alpha: l1 cos a1 + l2 cos a2 = X, X = x - l3 cos alpha. With x = l1 cos a1, y1 = l1 sin a1, y2 = l2 sin a2 the same
  two equations hold with A, B = +-l1 and C, E = X +- l2.

The joints can be assembled where both radicands are positive: c <= x <= b, for the roots sorted a >= b >= c >= d.
Going round, a triangle that falls flat glues its two branches. With x = c + (b - c) cos^2 phi the four roots

    sqrt(b - x) = sqrt(b - c) sin phi,  sqrt(x - c) = sqrt(b - c) cos phi,  sqrt(a - x) > 0,  sqrt(x - d) > 0

are smooth, and y1 = sqrt(A - x) sqrt(x - B), y2 = sqrt(C - x) sqrt(x - E) take their signs from them: where b and c
belong to the same triangle, the other one never falls flat and keeps its sign (two curves, phi over half a turn);
where they belong to two, both change (one curve, phi over a turn). The null vector N of the minors is dq/dw for
dx/dw = y1 y2 / 2 (position) or y1 y2 (x_alpha), hence dw = (4 or 2) d phi / sqrt((a - x) (x - d)), and the length is
the integral of H = |N| over w.

w is the uniform parameter of the elliptic curve that all this lies on. In theta = pi w / (half its period) nothing is
nearly singular, however close two roots are: tan phi = sqrt((a - b) / (a - c)) tan am, where tan am follows from
tan theta by descending Landen transformations with the arithmetic-geometric mean of sqrt((a - c) (b - d)) and
sqrt((a - b) (c - d)) (R. Bulirsch, Numerische Mathematik 7, 1965). All terms are positive: nothing cancels.

For the quadrilateral these products are P = 16 (area of the cyclic quadrilateral)^2, G = 16 l1 l2 l3 r and P - G:
two curves for P > G, one for G > P > 0, none for P < 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from chainrule.derive.planar import PlanarChain, layout, minor_matrix
from chainrule.derive.program import (
    CopySign,
    Expression,
    GuardedInverse,
    Input,
    Output,
    Program,
    Steps,
    Where,
    closed_form,
)

TASKS = ("position", "x_alpha")

#: Steps of the arithmetic-geometric mean: enough for (a - b) (c - d) down to 1e-32 of (a - c) (b - d).
LANDEN = 9

ZERO, ONE = sp.Integer(0), sp.Integer(1)

#: The point theta on the period, as its cosine and sine; the same for phi.
NODE = Input("node", (2,), tuple(sp.symbols("ct st", real=True)))
TURN = Input("turn", (2,), tuple(sp.symbols("cp sp", real=True)))
#: Distance r of the target from the base; X = x - l3 cos alpha for x_alpha.
REACH = Input("reach", (1,), (sp.Symbol("r", real=True),))
#: The sums +-l1 +-l2 +-l3 +-r whose signs decide everything, each rounded once: with - r where the signs of the lengths
#: are +++, ++-, +-+, -++, then with + r (x_alpha: l3 counts as 0). They follow from the lengths and r, but formed in
#: floating point they would lose the digits that count near a singular value.
SUMS = Input("sums", (8,), tuple(sp.symbols("m0:4 p0:4", real=True)))
#: Halves of two angles, and one bound of each joint.
HALVES = Input("halves", (2,), tuple(sp.symbols("h1 h2", real=True)))
STOPS = Input("stops", (3,), tuple(sp.symbols("v1 v2 v3", real=True)))


@dataclass(frozen=True)
class Roots:
    """Differences of the roots A, B, C, E; those of the sorted a >= b >= c >= d; and which of them b and c are.

    ``upper`` is 1 where b is A (else C), ``lower`` 1 where c is B (else E).
    """

    ab: Expression
    bc: Expression
    cd: Expression
    upper: Expression
    lower: Expression


def exact_sums(task: str, lengths: Sequence[Expression], r: Expression) -> tuple[Expression, ...]:
    """What :data:`SUMS` stand for."""
    l1, l2, l3 = lengths[0], lengths[1], ZERO if task == "x_alpha" else lengths[2]
    flat = (l1 + l2 + l3, l1 + l2 - l3, l1 - l2 + l3, -l1 + l2 + l3)
    return (*(e - r for e in flat), *(e + r for e in flat))


def differences(
    task: str, lengths: Sequence[Expression], r: Expression, sums: Sequence[Expression]
) -> dict[str, Expression]:
    """A - B, A - C, A - E, C - B, C - E and B - E as products: small ones are known to all their digits."""
    l1, l2, l3 = lengths
    m0, m1, m2, m3, p0, p1, p2, p3 = sums
    if task == "x_alpha":
        return {"AB": 2 * l1, "AC": m2, "AE": m0, "CB": p0, "CE": 2 * l2, "BE": m3}
    return {"AB": 4 * l1 * l2, "AC": p0 * m1, "AE": m0 * p1, "CB": p3 * p2, "CE": 4 * l3 * r, "BE": -m3 * m2}


def roots(steps: Steps, task: str, lengths: Sequence[Expression], r: Expression, sums: Sequence[Expression]) -> Roots:
    """The sorted roots' differences; b - c is negative where the target is out of reach."""
    found = {name: steps.let(name, e) for name, e in differences(task, lengths, r, sums).items()}
    ac, be = found["AC"], found["BE"]
    bc = steps.let("bc", sp.Min(sp.Min(found["AB"], found["CE"]), sp.Min(found["AE"], found["CB"])))
    return Roots(
        steps.let("ab", CopySign(ac, ONE)),
        bc,
        steps.let("cd", CopySign(be, ONE)),
        steps.let("upper", Where(steps.let("AC_below", sp.Max(-ac, ZERO)), ONE)),
        steps.let("lower", Where(steps.let("BE_above", sp.Max(be, ZERO)), ONE)),
    )


@dataclass(frozen=True)
class Curve:
    """A point of the curve: x - B, x - E, C - x, y1, y2 and sqrt((a - x) (x - d))."""

    above_b: Expression
    above_e: Expression
    below_c: Expression
    y1: Expression
    y2: Expression
    flow: Expression


def curve(steps: Steps, found: Roots, cosine: Expression, sine: Expression) -> Curve:
    """The point phi, by its cosine and sine."""
    span = steps.let("span", sp.sqrt(steps.let("width", sp.Max(found.bc, ZERO))))
    b_x, x_c = steps.let("root_bx", span * sine), steps.let("root_xc", span * cosine)
    a_x = steps.let("root_ax", sp.sqrt(steps.let("ax", found.ab + b_x**2)))
    x_d = steps.let("root_xd", sp.sqrt(steps.let("xd", found.cd + x_c**2)))

    def chosen(name: str, flag: Expression, yes: Expression, no: Expression) -> tuple[Expression, Expression]:
        other = steps.let(f"not_{name}", 1 - flag)
        return steps.let(f"{name}1", flag * yes + other * no), steps.let(f"{name}2", flag * no + other * yes)

    up1, up2 = chosen("up", found.upper, b_x, a_x)
    low1, low2 = chosen("low", found.lower, x_c, x_d)
    return Curve(
        steps.let("xB", low1**2),
        steps.let("xE", low2**2),
        steps.let("Cx", up2**2),
        steps.let("y1", up1 * low1),
        steps.let("y2", up2 * low2),
        steps.let("flow", a_x * x_d),
    )


def landen(
    steps: Steps, found: Roots, cosine: Expression, sine: Expression
) -> tuple[Expression, Expression, Expression]:
    """Cosine and sine of phi for a point theta, and the arithmetic-geometric mean."""
    width = steps.let("width", sp.Max(found.bc, ZERO))
    a_c, b_d = steps.let("a_c", found.ab + width), steps.let("b_d", width + found.cd)
    a = [steps.let("mean", sp.sqrt(a_c * b_d))]
    b = [steps.let("gmean", sp.sqrt(found.ab * found.cd))]
    for _ in range(LANDEN):
        a.append(steps.let("mean", (a[-1] + b[-1]) / 2))
        b.append(steps.let("gmean", sp.sqrt(a[-2] * b[-1])))
    square = steps.let("square", sine**2)
    high, low, ratio = steps.let("climb", a[-1] * cosine), cosine, ONE
    for k in reversed(range(LANDEN)):
        product = steps.let("product", low * high)
        high = steps.let("climb", high * ratio)
        ratio = steps.let("ratio", (b[k] * square + product) * GuardedInverse(a[k] * square + product))
        low = steps.let("cotangent", high * GuardedInverse(a[k]))
    c, s = steps.let("cphi", sp.sqrt(a_c) * low), steps.let("sphi", sp.sqrt(found.ab) * sine)
    unit = steps.let("unit", GuardedInverse(steps.let("radius", sp.sqrt(steps.let("size", c**2 + s**2)))))
    return steps.let("cos_phi", c * unit), steps.let("sin_phi", s * unit), a[-1]


@dataclass(frozen=True)
class Place:
    """Products of the vectors of the quadrilateral, divided by nothing small: sines and cosines times two lengths."""

    s12: Expression
    c12: Expression
    s13: Expression
    s23: Expression
    c23: Expression
    s1r: Expression
    c1r: Expression


def place(steps: Steps, at: Curve, lengths: Sequence[Expression], r: Expression) -> Place:
    """Vector and scalar products of l1 e1, l2 e2, l3 e3 and r e, through those with the diagonal V."""
    l1, l2, l3 = lengths
    inverse = steps.let("inverse_x", GuardedInverse(steps.let("x", (l1 - l2) ** 2 + at.above_b)))
    s12, half = steps.let("S12", at.y1 / 2), steps.let("V3", at.y2 / 2)
    v1 = steps.let("v1", at.above_b / 2 + l1 * (l1 - l2))
    v2 = steps.let("v2", at.above_b / 2 + l2 * (l2 - l1))
    v3 = steps.let("v3", l3 * (r - l3) - at.above_e / 2)
    vr = steps.let("vr", at.above_e / 2 + r * (r - l3))
    return Place(
        s12,
        steps.let("C12", at.above_b / 2 - l1 * l2),
        steps.let("S13", (v1 * half + s12 * v3) * inverse),
        steps.let("S23", (v2 * half - s12 * v3) * inverse),
        steps.let("C23", (v2 * v3 + s12 * half) * inverse),
        steps.let("S1r", (v1 * half + s12 * vr) * inverse),
        steps.let("C1r", (v1 * vr - s12 * half) * inverse),
    )


def rates(steps: Steps, task: str, at: Curve, lengths: Sequence[Expression], r: Expression) -> list[Expression]:
    """dq/dw, the null vector from the signed minors, in the sense in which phi grows."""
    if task == "x_alpha":
        return [at.y2, steps.let("turning", -(at.y1 + at.y2)), at.y1]
    there = place(steps, at, lengths, r)
    return [steps.let("rate1", -there.s23), steps.let("V3", at.y2 / 2), steps.let("rate3", -(there.s12 + there.s13))]


def _size(steps: Steps, vector: Sequence[Expression]) -> Expression:
    return steps.let("H", sp.sqrt(steps.let("H_square", sum(e**2 for e in vector))))


def _angle(steps: Steps, y: Expression, x: Expression) -> Expression:
    """atan2, whose zero has no sign: a link that points backwards is at pi, whichever way its sine rounds to 0."""
    return sp.atan2(steps.let("rise", Where(y, y)), x)


def _factor(task: str) -> int:
    """dw = factor d phi / sqrt((a - x) (x - d))."""
    return 4 if task == "position" else 2


def gaps(arm: PlanarChain, task: str) -> Program:
    """a - b, b - c, c - d, and which roots b and c are."""
    steps = Steps()
    found = roots(steps, task, arm.inputs[1].symbols, REACH.symbols[0], SUMS.symbols)
    return Program(
        f"self_motion_gaps_{task}",
        "differences a - b, b - c, c - d of the sorted roots, and whether b is A and c is B",
        (REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (Output("gaps", (3,), (found.ab, found.bc, found.cd)), Output("pattern", (2,), (found.upper, found.lower))),
    )


def speed(arm: PlanarChain, task: str) -> Program:
    """ds/d theta: the length of all curves together is twice its integral over half a turn of theta."""
    steps, lengths, r = Steps(), arm.inputs[1].symbols, REACH.symbols[0]
    found = roots(steps, task, lengths, r, SUMS.symbols)
    cosine, sine, mean = landen(steps, found, *NODE.symbols)
    moving = rates(steps, task, curve(steps, found, cosine, sine), lengths, r)
    per_turn = steps.let("per_turn", _factor(task) * GuardedInverse(mean))
    pace = steps.let("pace", _size(steps, moving) * per_turn)
    return Program(
        f"self_motion_speed_{task}",
        "ds/d theta of the self-motion, theta uniform in the elliptic parameter",
        (NODE, REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (Output("speed", (), (pace,)),),
    )


def turn(arm: PlanarChain, task: str) -> Program:
    """phi at a point theta."""
    steps = Steps()
    found = roots(steps, task, arm.inputs[1].symbols, REACH.symbols[0], SUMS.symbols)
    cosine, sine, _ = landen(steps, found, *NODE.symbols)
    return Program(
        f"self_motion_turn_{task}",
        "cosine and sine of phi at a point theta of the elliptic parameter",
        (NODE, REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (Output("phi", (2,), (cosine, sine)),),
    )


def point(arm: PlanarChain, task: str) -> Program:
    """The joint values at phi: q1 from the direction of the target, or (x_alpha) q3 less alpha; dq/dw; H; ds/d phi."""
    steps, lengths, r = Steps(), arm.inputs[1].symbols, REACH.symbols[0]
    at = curve(steps, roots(steps, task, lengths, r, SUMS.symbols), *TURN.symbols)
    moving = rates(steps, task, at, lengths, r)
    if task == "x_alpha":
        c1, c2 = steps.let("l1_cos", at.above_b - lengths[0]), steps.let("l2_cos", at.below_c - lengths[1])
        cross, dot = steps.let("cross", c1 * at.y2 - at.y1 * c2), steps.let("dot", c1 * c2 + at.y1 * at.y2)
        q = (_angle(steps, at.y1, c1), _angle(steps, cross, dot), -_angle(steps, at.y2, c2))
    else:
        there = place(steps, at, lengths, r)
        q = (
            -_angle(steps, there.s1r, there.c1r),
            _angle(steps, there.s12, there.c12),
            _angle(steps, there.s23, there.c23),
        )
    h = _size(steps, moving)
    return Program(
        f"self_motion_point_{task}",
        "joint values, their rates dq/dw, H and ds/d phi at a point phi of the self-motion",
        (TURN, REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (
            Output("q", (3,), q),
            Output("rates", (3,), tuple(moving)),
            Output("manipulability", (), (h,)),
            Output("speed", (), (_factor(task) * h * GuardedInverse(at.flow),)),
        ),
    )


def phase(arm: PlanarChain, task: str) -> Program:
    """sqrt(b - x) and sqrt(x - c) with the signs that phi gives them, from half the angles of the two triangles.

    ``halves`` are q2 / 2 and half the angle from the target's direction to the last link (position), or a1 / 2 and
    a2 / 2 (x_alpha), in (-pi / 2, pi / 2]: A - x = s sin^2 h1, x - B = s cos^2 h1, C - x = t cos^2 h2 and
    x - E = t sin^2 h2 with s = A - B and t = C - E.
    """
    steps, lengths, r = Steps(), arm.inputs[1].symbols, REACH.symbols[0]
    found = roots(steps, task, lengths, r, SUMS.symbols)
    first, second = HALVES.symbols
    wide = differences(task, lengths, r, SUMS.symbols)
    s, t = (steps.let(name, sp.sqrt(sp.Max(wide[pair], ZERO))) for name, pair in (("root_s", "AB"), ("root_t", "CE")))
    up1, low1 = steps.let("up1", s * sp.sin(first)), steps.let("low1", s * sp.cos(first))
    up2, low2 = steps.let("up2", t * sp.cos(second)), steps.let("low2", t * sp.sin(second))
    # the root whose partner is a - x or x - d, taken as positive, carries the sign of its triangle
    signed_up2 = steps.let("signed_up2", found.lower * CopySign(up2, low2) + (1 - found.lower) * up2)
    signed_low1 = steps.let("signed_low1", found.upper * low1 + (1 - found.upper) * CopySign(low1, up1))
    sine = steps.let("sine_part", found.upper * up1 + (1 - found.upper) * signed_up2)
    cosine = steps.let("cosine_part", found.lower * signed_low1 + (1 - found.lower) * low2)
    return Program(
        f"self_motion_phase_{task}",
        "sqrt(x - c) and sqrt(b - x), with the signs of cos phi and sin phi, of a configuration",
        (HALVES, REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (Output("phase", (2,), (cosine, sine)),),
    )


def _tangents(steps: Steps, found: Roots, first: bool) -> list[Expression]:
    """Half the angle of a triangle at x = b and x = c: tan^2 = (A - x) / (x - B), or (x - E) / (C - x)."""
    width = steps.let("width", sp.Max(found.bc, ZERO))
    upper, lower = (found.upper, found.lower) if first else (1 - found.upper, 1 - found.lower)
    over = [steps.let("over_b", (1 - upper) * found.ab), steps.let("over_c", (1 - upper) * found.ab + width)]
    under = [steps.let("under_b", width + (1 - lower) * found.cd), steps.let("under_c", (1 - lower) * found.cd)]
    angles = []
    for high, low in zip(over, under, strict=True):
        pair = (sp.sqrt(high), sp.sqrt(low)) if first else (sp.sqrt(low), sp.sqrt(high))
        angles.append(steps.let("extreme", 2 * sp.atan2(*pair)))
    return angles if first else angles[::-1]


def extremes(arm: PlanarChain, task: str) -> Program:
    """Least and greatest |angle| that each joint takes: where dq_j/dw = 0, the rest of the chain falls flat.

    The angles are q1 from the target's direction, q2, q3 (position), or a1 = q1, q2, a2 = alpha - q3 (x_alpha).
    """
    steps, (l1, l2, l3), r = Steps(), arm.inputs[1].symbols, REACH.symbols[0]
    found = roots(steps, task, (l1, l2, l3), r, SUMS.symbols)
    if task == "x_alpha":
        inner = steps.let("inner", sp.Max(-SUMS.symbols[2] * SUMS.symbols[6], ZERO))
        outer = steps.let("outer", sp.Max(SUMS.symbols[0] * SUMS.symbols[4], ZERO))
        bent = steps.let("bent", 2 * sp.atan2(sp.sqrt(outer), sp.sqrt(inner)))
        entries = [*_tangents(steps, found, True), ZERO, bent, *_tangents(steps, found, False)]
    else:
        m0, m1, m2, m3, p0, p1, p2, p3 = SUMS.symbols
        other = roots(steps, task, (l2, l3, l1), r, (m0, m3, m1, m2, p0, p3, p1, p2))
        entries = [*_tangents(steps, other, False), *_tangents(steps, found, True), *_tangents(steps, other, True)]
    return Program(
        f"self_motion_extremes_{task}",
        "least and greatest absolute angle of each joint along the self-motion",
        (REACH, SUMS, arm.inputs[1]),
        tuple(steps.steps),
        (Output("extremes", (3, 2), tuple(entries)),),
    )


def _two_links(
    steps: Steps, square: Expression, other: Expression, r2: Expression
) -> tuple[Expression, list[tuple[Expression, Expression]]]:
    """A 2R arm with links sqrt(square) and sqrt(other) that reaches sqrt(r2): radicand, and (bend, lag) of both.

    2 p q sin = +-sqrt(4 p^2 q^2 - C^2), C = r^2 - p^2 - q^2; the first link lags atan2(S, 2 p^2 + C) behind.
    """
    c = steps.let("C", r2 - square - other)
    radicand = steps.let("radicand", 4 * square * other - c**2)
    root = steps.let("S", sp.sqrt(sp.Max(radicand, ZERO)))
    bend, lag = steps.let("bend", sp.atan2(root, c)), steps.let("lag", sp.atan2(root, 2 * square + c))
    return radicand, [(bend, lag), (-bend, -lag)]


def stops(arm: PlanarChain, task: str) -> Program:
    """The configurations (two for each joint) in which a joint has a given value, and the radicands of their roots.

    Joint values as in :func:`point`: q1 from the target's direction, or q3 less alpha.
    """
    steps, (l1, l2, l3), r = Steps(), arm.inputs[1].symbols, REACH.symbols[0]
    cos = [steps.let(f"cv{k + 1}", sp.cos(v)) for k, v in enumerate(STOPS.symbols)]
    sin = [steps.let(f"sv{k + 1}", sp.sin(v)) for k, v in enumerate(STOPS.symbols)]
    v1, v2, v3 = STOPS.symbols
    found: list[list[Expression]] = []
    radicands = []
    if task == "x_alpha":
        for known, length, given in ((l1 * cos[0], l2, 0), (l2 * cos[2], l1, 2)):  # one heading is known
            c = steps.let("c", r - known)
            radicands.append(steps.let("radicand", (length - c) * (length + c)))
            root = steps.let("S", sp.sqrt(sp.Max(radicands[-1], ZERO)))
            angle = steps.let("angle", sp.atan2(root, c))
            for sign in (1, -1):
                found.append(
                    [v1, sign * angle - v1, -sign * angle] if given == 0 else [sign * angle, -v3 - sign * angle, v3]
                )
        # l1 e1 + l2 e2 turned as one: its size p and lead beyond a1
        px, py = steps.let("px", l1 + l2 * cos[1]), steps.let("py", l2 * sin[1])
        radicand = steps.let("radicand", px**2 + py**2 - r**2)
        root = steps.let("S", sp.sqrt(sp.Max(radicand, ZERO)))
        lead, angle = steps.let("lead", _angle(steps, py, px)), steps.let("angle", sp.atan2(root, r))
        bent = [[sign * angle - lead, v2, -(sign * angle - lead + v2)] for sign in (1, -1)]
        found, radicands = [*found[:2], *bent, *found[2:]], [radicands[0], radicand, radicands[1]]
    else:
        r2 = steps.let("r2", r**2)
        ux, uy = steps.let("ux", r - l1 * cos[0]), steps.let("uy", -l1 * sin[0])
        radicand, pairs = _two_links(steps, l2**2, l3**2, steps.let("u2", ux**2 + uy**2))
        towards = steps.let("towards", _angle(steps, uy, ux))
        found += [[v1, towards - lag - v1, bend] for bend, lag in pairs]
        radicands.append(radicand)
        px, py = steps.let("px", l1 + l2 * cos[1]), steps.let("py", l2 * sin[1])
        radicand, pairs = _two_links(steps, steps.let("p2", px**2 + py**2), l3**2, r2)
        lead = steps.let("lead", _angle(steps, py, px))
        found += [[-lag - lead, v2, lead + bend - v2] for bend, lag in pairs]
        radicands.append(radicand)
        wx, wy = steps.let("wx", l2 + l3 * cos[2]), steps.let("wy", l3 * sin[2])
        radicand, pairs = _two_links(steps, l1**2, steps.let("w2", wx**2 + wy**2), r2)
        lead = steps.let("lead", _angle(steps, wy, wx))
        found += [[-lag, bend - lead, v3] for bend, lag in pairs]
        radicands.append(radicand)
    return Program(
        f"self_motion_stops_{task}",
        "both configurations in which each joint has a given value, and the radicands, negative where there are none",
        (STOPS, REACH, arm.inputs[1]),
        tuple(steps.steps),
        (
            Output("q", (6, 3), tuple(e for row in found for e in row)),
            Output("radicands", (3,), tuple(radicands)),
        ),
    )


def identities(arm: PlanarChain, task: str) -> dict[str, Expression]:
    """What the closed form rests on, each as an expression that is 0: from the arm's own position and minors."""
    q, (l1, l2, l3) = arm.inputs[0].symbols, arm.inputs[1].symbols
    steps = Steps()
    where = layout(steps, arm)
    rows = minor_matrix(steps, arm, task)
    entries = (*where.points[1], *where.points[2], *where.tip, *rows[0], *rows[1])
    output = Output("all", (len(entries),), entries)
    values = closed_form(Program("", "", arm.inputs, tuple(steps.steps), (output,)))["all"]
    elbow, wrist, tip = (sp.Matrix(values[k : k + 2]) for k in (0, 2, 4))
    n = sp.Matrix(values[6:9]).cross(sp.Matrix(values[9:12]))  # the null vector: signed minors
    links = [elbow, wrist - elbow, tip - wrist]

    def cross(u: Expression, v: Expression) -> Expression:
        return u[0] * v[1] - u[1] * v[0]

    def along(e: Expression) -> Expression:
        return sum(sp.diff(e, joint) * rate for joint, rate in zip(q, n, strict=True))

    a, b, c, d, u = sp.symbols("a b c d u", positive=True)  # the sorted roots; u = tan am
    t = sp.sqrt((a - b) / (a - c)) * u
    x_of = c + (b - c) / (1 + t**2)
    flow = (sp.diff(t, u) * (1 + u**2) / (1 + t**2)) ** 2 * ((a - c) * (b - d) - (b - c) * (a - d) * u**2 / (1 + u**2))
    found = {"elliptic parameter": flow - (a - x_of) * (x_of - d)}
    if task == "x_alpha":
        x, held = elbow[0], wrist[0]
        y1, y2 = elbow[1], links[1][1]
        return found | {
            "first triangle": y1**2 - (l1 - x) * (x + l1),
            "second triangle": y2**2 - (held + l2 - x) * (x - held + l2),
            "first rate": n[0] + y2,
            "second rate": n[1] - y1 - y2,
            "third rate": n[2] + y1,
            "flow": along(x) - y1 * y2,
        }
    x, r2 = wrist.dot(wrist), tip.dot(tip)
    y1, y2 = 2 * cross(links[0], links[1]), 2 * cross(wrist, links[2])
    v1, v2, v3, vr = (wrist.dot(vector) for vector in (links[0], links[1], links[2], tip))
    r = sp.Symbol("r", positive=True)
    p = [e for e in exact_sums(task, (l1, l2, l3), r)]
    return found | {
        "first triangle": y1**2 - ((l1 + l2) ** 2 - x) * (x - (l1 - l2) ** 2),
        "second triangle": y2**2 - (4 * r2 * l3**2 - (x - r2 - l3**2) ** 2),
        "first rate": n[0] - cross(links[1], links[2]),
        "second rate": n[1] + y2 / 2,
        "third rate": n[2] - cross(links[0], links[2]) - y1 / 2,
        "flow": along(x) - y1 * y2 / 2,
        "V.1": 2 * v1 - (x + l1**2 - l2**2),
        "V.2": 2 * v2 - (x + l2**2 - l1**2),
        "V.3": 2 * v3 - (r2 - l3**2 - x),
        "V.r": 2 * vr - (r2 - l3**2 + x),
        "1x3": x * cross(links[0], links[2]) - (v1 * y2 / 2 + y1 / 2 * v3),
        "2x3": x * cross(links[1], links[2]) - (v2 * y2 / 2 - y1 / 2 * v3),
        "2.3": x * links[1].dot(links[2]) - (v2 * v3 + y1 * y2 / 4),
        "1xr": x * cross(links[0], tip) - (v1 * y2 / 2 + y1 / 2 * vr),
        "1.r": x * links[0].dot(tip) - (v1 * vr - y1 * y2 / 4),
        "P - G": p[0] * p[5] * p[6] * p[7] - 16 * l1 * l2 * l3 * r - p[4] * p[1] * p[2] * p[3],
    }


#: Everything that is generated: the task, and the derivation that makes the program.
EVERY = tuple((task, make) for task in TASKS for make in (gaps, speed, turn, point, phase, extremes, stops))
