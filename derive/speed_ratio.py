"""Speed-ratio control of planar arms with one joint to spare (Ambike, Schmiedeler, Stanisic, equations (3) to (9)).

Joint rates x in constant ratio move the tip along r' = J x with r'' = x . (dJ/dq) . x. Seen in the frame of the desired
unit tangent T, row ``along`` of J gives r'.T and row ``across`` gives T x r'. The path has the tangent T where
    across . x = 0,                                                        (3), (5)
and the signed curvature k (left turns positive) where also
    -T x r''(x) + k (r'.r') = 0.                                           (4), (6)
On the line (5) r' is parallel to T, so r'.r' = (along . x)^2 is the square of ONE linear form. That is why the part of
(7) that multiplies k is a square, with the double root where the tip stands still, and a2^2 - 4 a1 a3 = 0 for every
morphology.

Nothing here needs a leading joint. The joint rates that move the tip at unit speed along T are x = J^+ T + z n, with n
the unit null vector of J, and the curvature T x r''(x) is a parabola in z: k = p2 z^2 + p1 z + p0. Its discriminant is
linear in kappa, as the paper found, and the solutions in which the tip stands still have gone to infinity.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.planar import Layout, PlanarChain, columns, layout
from chainrule.derive.program import CopySign, Expression, GuardedInverse, Input, Output, Program, Steps, Where

Row = list[Expression]

TANGENT = Input("tangent", (2,), (sp.Symbol("tx", real=True), sp.Symbol("ty", real=True)))
CURVATURE = Input("curvature", (2,), (sp.Symbol("kappa", real=True), sp.Symbol("kappa_s", real=True)))


@dataclass(frozen=True)
class Rates:
    """How fast each link's heading turns and its advance grows, at given joint rates."""

    turning: Row
    sliding: Row


@dataclass(frozen=True)
class TangentFrame:
    """What the tip's path is made of, seen from the tangent: rows of J, and each link's heading and advance."""

    kinds: str
    along: Row
    across: Row
    headings: list[tuple[Expression, Expression]]  # (u.T, T x u)
    advances: Row

    def rates(self, x: Row) -> Rates:
        """What the links do at joint rates x: a heading turns with the sum of the revolute joints' rates before it."""
        turning: Row = []
        total: Expression = sp.Integer(0)
        for kind, rate in zip(self.kinds, x, strict=True):
            total = total + rate if kind == "R" else total
            turning.append(total)
        return Rates(turning, [e if kind == "P" else sp.Integer(0) for kind, e in zip(self.kinds, x, strict=True)])

    def second(self, x: Rates, y: Rates) -> tuple[Expression, Expression]:
        """The symmetric bilinear form of r'': its parts along T and across it."""
        along, across = sp.Integer(0), sp.Integer(0)
        links = zip(x.turning, y.turning, x.sliding, y.sliding, self.advances, self.headings, strict=True)
        for w, v, a, b, advance, (c, s) in links:
            bend, shift = advance * w * v, a * v + b * w
            along += -bend * c - shift * s
            across += -bend * s + shift * c
        return along, across

    def third(self, x: Rates) -> tuple[Expression, Expression]:
        """r''' at constant rates: its parts along T and across it."""
        along, across = sp.Integer(0), sp.Integer(0)
        for w, a, advance, (c, s) in zip(x.turning, x.sliding, self.advances, self.headings, strict=True):
            along += advance * w**3 * s - 3 * a * w**2 * c
            across += -advance * w**3 * c - 3 * a * w**2 * s
        return along, across


def tangent_frame(steps: Steps, arm: PlanarChain) -> TangentFrame:
    """The arm seen from the tangent."""
    place: Layout = layout(steps, arm)
    tx, ty = TANGENT.symbols
    rows = columns(steps, arm, place)
    along = [steps.let(f"along{i + 1}", column[0] * tx + column[1] * ty) for i, column in enumerate(rows)]
    across = [steps.let(f"across{i + 1}", tx * column[1] - ty * column[0]) for i, column in enumerate(rows)]
    headings = [
        (steps.let(f"hc{i + 1}", h[0] * tx + h[1] * ty), steps.let(f"hs{i + 1}", tx * h[1] - ty * h[0]))
        for i, h in enumerate(place.headings)
    ]
    q, lengths = arm.inputs[0].symbols, arm.inputs[1].symbols
    advances = [
        lengths[i] if kind == "R" else steps.let(f"advance{i + 1}", lengths[i] + q[i])
        for i, kind in enumerate(arm.kinds)
    ]
    return TangentFrame(arm.kinds, along, across, headings, advances)


def terms(arm: PlanarChain, leading: int) -> Program:
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of (5) to (9) for a leading joint (from 1).

    The ratios are those of the other joints, in their order: n_i = theta_i' / theta_leading'. The second of them is
    eliminated, so a, b, C and D mean nothing where A2 = 0 (they are then those of n_j = 0).
    """
    steps = Steps()
    frame = tangent_frame(steps, arm)
    kappa = CURVATURE.symbols[0]
    lead = leading - 1
    i, j = (k for k in range(3) if k != lead)
    unit = [frame.rates([sp.Integer(k == joint) for k in range(3)]) for joint in range(3)]

    def form(joint: int, other: int) -> tuple[Expression, Expression]:
        """The coefficients of x_joint x_other in -T x r'' and in r'.r'."""
        twice = 1 if joint == other else 2
        square = frame.along[joint] * frame.along[other] + frame.across[joint] * frame.across[other]
        return -twice * frame.second(unit[joint], unit[other])[1], twice * square

    # in the order of (6): n_i^2, n_j^2, n_i n_j, n_i, n_j, 1
    pairs = ((i, i), (j, j), (i, j), (lead, i), (lead, j), (lead, lead))
    line = [steps.let(f"A{k + 1}", -frame.across[joint]) for k, joint in enumerate((i, j, lead))]
    constant = [steps.let(f"B{k + 1}_0", form(*pair)[0]) for k, pair in enumerate(pairs)]
    bent = [steps.let(f"B{k + 1}_1", form(*pair)[1]) for k, pair in enumerate(pairs)]
    conic = [steps.let(f"B{k + 1}", c + kappa * b) for k, (c, b) in enumerate(zip(constant, bent, strict=True))]
    # n_j = -(slant n_i + offset) on the line (5)
    inverse = steps.let("inverse", GuardedInverse(line[1]))
    slant, offset = steps.let("slant", line[0] * inverse), steps.let("offset", line[2] * inverse)
    b = [steps.let(f"b{k + 1}", e) for k, e in enumerate(eliminated(slant, offset, constant))]
    # r'.T on the line: the form whose square multiplies kappa
    slope = steps.let("u", frame.along[i] - frame.along[j] * slant)
    rest = steps.let("v", frame.along[lead] - frame.along[j] * offset)
    a = [steps.let("a1", slope**2), steps.let("a2", 2 * slope * rest), steps.let("a3", rest**2)]
    c = steps.let("C", 2 * a[1] * b[1] - 4 * a[0] * b[2] - 4 * b[0] * a[2])
    d = steps.let("D", b[1] ** 2 - 4 * b[0] * b[2])
    outputs = (
        Output("A", (3,), tuple(line)),
        Output("B", (6,), tuple(conic)),
        Output("B0", (6,), tuple(constant)),
        Output("B1", (6,), tuple(bent)),
        Output("a", (3,), tuple(a)),
        Output("b", (3,), tuple(b)),
        Output("C", (), (c,)),
        Output("D", (), (d,)),
        Output("discriminant", (), (c * kappa + d,)),
    )
    return Program(
        f"speed_ratio_terms_{leading}",
        f"A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint {leading} leading",
        (*arm.inputs, TANGENT, CURVATURE),
        tuple(steps.steps),
        outputs,
    )


def eliminated(slant: Expression, offset: Expression, conic: Row) -> Row:
    """A conic on the line n_j = -(slant n_i + offset): coefficients of n_i^2, n_i and 1."""
    b1, b2, b3, b4, b5, b6 = conic
    return [
        b1 + b2 * slant**2 - b3 * slant,
        2 * b2 * slant * offset - b3 * offset + b4 - b5 * slant,
        b2 * offset**2 - b5 * offset + b6,
    ]


def cross(a: Row, b: Row) -> Row:
    """The vector product of two rows of three."""
    return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]


def rates(arm: PlanarChain) -> Program:
    """Both joint rates that move the tip at unit speed along T with the curvature kappa, or come nearest to it.

    Outputs: ``rates`` (2, 3); ``tracked`` (2,) and ``tracked_rate`` (2,), k and dk/ds of the path each makes at
    constant rates; ``parabola`` (3,) = (p2, p1, p0) with k = p2 z^2 + p1 z + p0 at the rates least + z null;
    ``discriminant`` = p1^2 - 4 p2 (p0 - kappa), negative where the curvature cannot be met: both solutions are then the
    vertex of the parabola; ``least`` (3,) = J^+ T; ``null`` (3,) = N / |N|. Where p2 = 0 the first solution is at infinity (only the
    arm moves) and its rates are zero; where p1 = 0 too, nothing changes the curvature and both are J^+ T. Everything is
    zero at a singular configuration.
    """
    steps = Steps()
    frame = tangent_frame(steps, arm)
    kappa = CURVATURE.symbols[0]
    zero, one = sp.Integer(0), sp.Integer(1)
    normal = [steps.let(f"N{k + 1}", e) for k, e in enumerate(cross(frame.along, frame.across))]
    size = steps.let("H", sp.sqrt(sum((e**2 for e in normal), zero)))
    inverse = steps.let("inverse", GuardedInverse(size))
    null = [steps.let(f"null{k + 1}", e * inverse) for k, e in enumerate(normal)]
    least = [steps.let(f"least{k + 1}", e * inverse) for k, e in enumerate(cross(frame.across, null))]
    own, other = (_named(steps, frame.rates(x), label) for x, label in ((null, "n"), (least, "l")))
    p2 = steps.let("p2", frame.second(own, own)[1])
    p1 = steps.let("p1", 2 * frame.second(other, own)[1])
    p0 = steps.let("p0", frame.second(other, other)[1])
    gap = steps.let("gap", p0 - kappa)
    discriminant = steps.let("discriminant", p1**2 - 4 * p2 * gap)
    root = steps.let("root", sp.sqrt(sp.Max(discriminant, zero)))
    half = steps.let("half", -(p1 + CopySign(root, p1)) / 2)
    # z1 = half / p2 and z2 = gap / half, without cancellation; where there is no root, both are the vertex
    two = steps.let("two", Where(root, one))
    bent = steps.let("bent", Where(p2, one))
    first = steps.let("z1", half * GuardedInverse(p2))
    second = steps.let("z2", Where(two, gap * GuardedInverse(half)) + Where(1 - two, first))
    flat = steps.let("flat", Where(1 - bent, 1 - Where(p1, one)))  # nothing changes the curvature
    exists = steps.let("exists1", bent + flat)
    found: Row = []
    curvatures: Row = []
    changes: Row = []
    for number, (z, there) in enumerate(((first, exists), (second, two + Where(1 - two, exists))), 1):
        flag = steps.let(f"exists{number}", there)
        x = [steps.let(f"rate{number}_{k + 1}", Where(flag, least[k] + z * null[k])) for k in range(3)]
        links = _named(steps, frame.rates(x), str(number))
        bend_along, bend = frame.second(links, links)
        curvature = steps.let(f"k{number}", bend)
        found += x
        curvatures.append(curvature)
        changes.append(steps.let(f"dk{number}", frame.third(links)[1] - 3 * curvature * bend_along))
    outputs = (
        Output("rates", (2, 3), tuple(found)),
        Output("tracked", (2,), tuple(curvatures)),
        Output("tracked_rate", (2,), tuple(changes)),
        Output("parabola", (3,), (p2, p1, p0)),
        Output("discriminant", (), (discriminant,)),
        Output("least", (3,), tuple(least)),
        Output("null", (3,), tuple(null)),
    )
    return Program(
        "speed_ratio_rates",
        "joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates",
        (*arm.inputs, TANGENT, CURVATURE),
        tuple(steps.steps),
        outputs,
    )


def _named(steps: Steps, rates: Rates, label: str) -> Rates:
    return Rates([steps.let(f"w{label}_{k + 1}", e) for k, e in enumerate(rates.turning)], rates.sliding)
