"""Speed-ratio control of planar arms with one joint to spare (Ambike, Schmiedeler, Stanisic, equations (3) to (9)).

Joint rates x in constant ratio move the tip along r' = J x with r'' = x . (dJ/dq) . x. Seen in the frame of the desired
unit tangent T, row ``along`` of J gives r'.T and row ``across`` gives T x r'. The path has the tangent T where
    across . x = 0,                                                        (3), (5)
and the signed curvature k (left turns positive) where also
    -T x r''(x) + k (r'.r') = 0.                                           (4), (6)
On the line (5) r' is parallel to T, so r'.r' = (along . x)^2 is the square of ONE linear form. That is why the part of
(7) that multiplies k is a square, with the double root where the tip stands still, and a2^2 - 4 a1 a3 = 0 for every
morphology.

No leading joint is needed to solve them. The joint rates that move the tip at unit speed along T are x = J^+ T + z n,
with n the unit null vector of J, and the curvature T x r''(x) is a parabola in z: k = p2 z^2 + p1 z + p0. Its
discriminant p1^2 - 4 p2 (p0 - kappa) is linear in kappa, as the paper found: C belongs to 4 p2 and D to p1^2 - 4 p2 p0
(up to one square factor). Hence the signs that can occur: C > 0 reaches every curvature from -D/C up, C < 0 every one
from -D/C down, and C = 0 comes with D >= 0 only: a straight line reaches every curvature once (its other solution, in
which the tip stands still, has gone to infinity), and a constant reaches one.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.planar import Layout, PlanarChain, columns, layout
from chainrule.derive.program import CopySign, Expression, Input, Output, Program, Steps

Row = list[Expression]

#: What counts as zero: this many times the size that rounding alone gives a quantity (64 units in the last place).
ROUNDING = sp.Rational(1, 2**46)

#: What is shorter, in metres, has no length to measure by.
TINY = sp.Rational(1, 2**100)

TANGENT = Input("tangent", (2,), (sp.Symbol("tx", real=True), sp.Symbol("ty", real=True)))
#: A joint that makes less than this part of the fastest joint's rate counts as standing still: it cannot lead.
STANDSTILL = sp.Rational(1, 2**40)

CURVATURE = Input("curvature", (2,), (sp.Symbol("kappa", real=True), sp.Symbol("kappa_s", real=True)))
#: Which joint leads: 1 for it, 0 for the others.
LEADING = Input("leading", (3,), tuple(sp.Symbol(f"leads{k}", real=True) for k in (1, 2, 3)))


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


def normalised(steps: Steps) -> tuple[Expression, Expression]:
    """The unit tangent of a tangent of any length; its larger entry first becomes 1, so that no square overflows."""
    tx, ty = TANGENT.symbols
    larger = steps.let("larger", sp.Max(CopySign(tx, sp.Integer(1)), CopySign(ty, sp.Integer(1))))
    x, y = steps.let("scaled_x", tx / larger), steps.let("scaled_y", ty / larger)
    length = steps.let("scaled_length", sp.sqrt(x**2 + y**2))
    return steps.let("unit_x", x / length), steps.let("unit_y", y / length)


def tangent_frame(
    steps: Steps, arm: PlanarChain, tangent: tuple[Expression, Expression] = TANGENT.symbols
) -> TangentFrame:
    """The arm seen from the unit tangent."""
    place: Layout = layout(steps, arm)
    tx, ty = tangent
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
    eliminated, so (7) is a polynomial in the first; where A2 = 0 (5) is no equation for the second, the first is
    eliminated and (7) is a polynomial in the second. Where A1 = A2 = 0 the leading joint cannot move: a, b, C and D are
    then those of (6) without (5) and mean nothing.
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
    # the second ratio is eliminated, or the first where (5) says nothing of the second
    span = steps.let("span", reach(frame))
    bounds = [ROUNDING if frame.kinds[joint] == "P" else ROUNDING * span for joint in (i, j)]
    usual = steps.let("usual", exceeds(line[1], bounds[1]))

    def either(name: str, first: Expression, second: Expression) -> Expression:
        return steps.let(name, usual * first + (1 - usual) * second)

    def ordered(name: str, row: Row) -> Row:
        """A conic with the ratios in the order kept, eliminated."""
        order = (1, 0, 2, 4, 3, 5)
        return [row[k] if k == m else either(f"{name}{k + 1}", row[k], row[m]) for k, m in enumerate(order)]

    # gone = -(slant kept + offset) on the line (5)
    pivot = either("pivot", line[1], line[0])
    bound = either("bound", bounds[1], bounds[0])
    inverse = steps.let("inverse", guarded(steps, pivot, steps.let("solvable", exceeds(pivot, bound))))
    slant = steps.let("slant", either("other", line[0], line[1]) * inverse)
    offset = steps.let("offset", line[2] * inverse)
    b = [steps.let(f"b{k + 1}", e) for k, e in enumerate(eliminated(slant, offset, ordered("kept", constant)))]
    # r'.T on the line: the form whose square multiplies kappa
    kept = either("along_kept", frame.along[i], frame.along[j])
    gone = either("along_gone", frame.along[j], frame.along[i])
    slope, rest = steps.let("u", kept - gone * slant), steps.let("v", frame.along[lead] - gone * offset)
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


def plain_elimination(arm: PlanarChain, leading: int) -> tuple[Row, Row]:
    """The part of (7) that multiplies kappa, twice: (6) with n_j from (5) put in, and a of :func:`terms`.

    The rows of J stay symbols, so that what is found equal is equal for every length, heading, posture and tangent.
    """
    program = terms(arm, leading)
    values: dict[Expression, Expression] = {}
    for step in program.steps:
        name = step.symbol.name
        if name in ("usual", "solvable"):
            values[step.symbol] = sp.Integer(1)
        elif not name.removeprefix("along").removeprefix("across").isdigit():
            values[step.symbol] = step.expression.xreplace(values)
    found = {o.name: [e.xreplace(values) for e in o.expressions] for o in program.outputs}
    line = found["A"]
    return eliminated(line[0] / line[1], line[2] / line[1], found["B1"]), found["a"]


def reach(frame: TangentFrame) -> Expression:
    """The size of the links: the root of the sum of the advances squared."""
    return sp.sqrt(sum((advance**2 for advance in frame.advances), sp.Integer(0)))


def exceeds(value: Expression, bound: Expression) -> Expression:
    """1 where |value| > bound, else 0: a factor, so that what is generated has no branches.

    The bound must not be the constant 0: -|value| is less than 0 even for a zero.
    """
    one = sp.Integer(1)
    return (1 - CopySign(one, bound - CopySign(value, one))) / 2


def guarded(steps: Steps, value: Expression, there: Expression) -> Expression:
    """1 / value where ``there`` is 1, and 0 where it is 0.

    What is added to the divisor has a name: in one sum with the rest, 1 - there would be rounded as if it were near 1.
    """
    absent = steps.let("absent", 1 - there)
    return there / (there * value + absent)


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

    The tangent may have any length but zero. What is not a number in the inputs becomes so in every ``tracked_rate``.

    Outputs: ``rates`` (2, 3), the solution nearer to J^+ T first; ``ratios`` (2, 2), the other two joints' rates
    divided by the leading joint's; ``tracked`` (2,) and ``tracked_rate`` (2,), k and dk/ds of the path that each makes
    at constant rates; ``verdict`` (5,) = status, number of solutions, which of them (0 or 1) has dk/ds nearer to
    kappa_s, whether kappa is met, and in how many of them the leading joint stands still (their ratios are 0);
    ``parabola`` (3,) = (p2, p1, p0) with k = p2 z^2 + p1 z + p0 at the rates least + z null; ``slack`` =
    p1^2 - 4 p2 (p0 - kappa), the discriminant; ``least`` (3,) = J^+ T; ``null`` (3,) = N / |N|. A solution that does
    not exist is zero.

    The status, decided with the bounds of rounding: 0, met (twice, or once where both solutions are one); 1, the
    discriminant is negative: the vertex of the parabola is nearest; 2, p2 = p1 = 0: nothing changes the curvature,
    J^+ T is given; 3, p2 = 0: one solution, the other is at infinity, where only the arm moves; 4, J has not full
    rank: everything is zero.
    """
    steps = Steps()
    frame = tangent_frame(steps, arm, normalised(steps))
    kappa, kappa_s = CURVATURE.symbols
    zero, one = sp.Integer(0), sp.Integer(1)
    normal = [steps.let(f"N{k + 1}", e) for k, e in enumerate(cross(frame.along, frame.across))]
    height = steps.let("H", sp.sqrt(sum((e**2 for e in normal), zero)))
    # Bounds of rounding compare metres with radians, so slides are measured in units of the links' own size (of 1 m
    # where they have none). J is then right to a rounding of size, N to one of size |J|, and n to one of size |J| / H.
    slides = frame.kinds.count("P")
    span = steps.let("span", reach(frame))
    pointlike = steps.let("pointlike", 1 - exceeds(span, TINY)) if slides else zero
    measure = steps.let("measure", span + pointlike) if slides else one
    units = [measure if kind == "P" else one for kind in frame.kinds]
    size = steps.let("size", measure * sp.sqrt(1 + slides)) if slides else span
    turned = [pair for kind, *pair in zip(frame.kinds, frame.along, frame.across, strict=True) if kind == "R"]
    if turned:
        norm = steps.let("norm", sp.sqrt(sum((e**2 for pair in turned for e in pair), slides * measure**2)))
    else:
        norm = steps.let("norm", measure * sp.sqrt(slides))
    scaled = [(e / u) ** 2 for e, u in zip(normal, units, strict=True)]
    spread = steps.let("spread", sp.sqrt(sum(scaled, zero))) if slides else height
    volume = measure**slides
    regular = steps.let("regular", exceeds(spread * volume, ROUNDING * size * norm))
    inverse = steps.let("inverse", guarded(steps, height, regular))
    null = [steps.let(f"null{k + 1}", e * inverse) for k, e in enumerate(normal)]
    least = [steps.let(f"least{k + 1}", e * inverse) for k, e in enumerate(cross(frame.across, null))]
    own, other = (_named(steps, frame.rates(x), label) for x, label in ((null, "n"), (least, "l")))
    p2 = steps.let("p2", frame.second(own, own)[1])
    p1 = steps.let("p1", 2 * frame.second(other, own)[1])
    p0 = steps.let("p0", frame.second(other, other)[1])
    # what rounding may leave of a coefficient that is zero: r'' has the size of the advances times the rates squared
    length = steps.let("length", sp.sqrt(sum(((e / u) ** 2 for e, u in zip(least, units, strict=True)), zero)))
    stretch = steps.let("stretch", spread * inverse) if slides else one  # |n|, as length is |least|
    slope = guarded(steps, spread, regular) / volume if slides else inverse
    tilt = steps.let("tilt", ROUNDING * size * size * norm * slope)
    unit = steps.let("unit", tilt * stretch**2) if slides else tilt
    slip1, slip0 = steps.let("slip1", 2 * tilt * stretch * length), steps.let("slip0", tilt * length**2)
    gap = steps.let("gap", p0 - kappa)
    slack = steps.let("slack", p1**2 - 4 * p2 * gap)
    sizes = [CopySign(e, one) for e in (p1, gap, p2)]
    slip = steps.let("slip", 2 * sizes[0] * slip1 + 4 * sizes[1] * unit + 4 * sizes[2] * slip0)
    bent = steps.let("bent", exceeds(p2, unit))
    sloped = steps.let("sloped", exceeds(p1, slip1))
    twice = steps.let("twice", bent * exceeds(sp.Max(slack, zero), slip))
    short = steps.let("short", bent * exceeds(sp.Max(-slack, zero), slip))
    # the roots half / p2 and gap / half lose nothing to cancellation; one root of a parabola is its vertex
    root = steps.let("root", sp.sqrt(sp.Max(slack, zero)))
    half = steps.let("half", -(p1 + CopySign(root, p1)) / 2)
    steep = steps.let("steep", (1 - bent) * sloped)
    vertex = steps.let("vertex", -p1 * guarded(steps, 2 * p2, bent))
    single = steps.let("single", (1 - twice) * (vertex - gap * guarded(steps, p1, steep)))
    first = steps.let("z1", gap * guarded(steps, half, twice) + single)
    second = steps.let("z2", half * guarded(steps, p2, twice))
    e1, e2, e3 = LEADING.symbols
    leading_unit = e1 * units[0] + e2 * units[1] + e3 * units[2] if slides else one
    found: Row = []
    ratios: Row = []
    curvatures: Row = []
    changes: Row = []
    still: Expression = zero
    for number, (z, exists) in enumerate(((first, regular), (second, steps.let("exists2", regular * twice))), 1):
        x = [steps.let(f"rate{number}_{k + 1}", exists * (least[k] + z * null[k])) for k in range(3)]
        lead = steps.let(f"lead{number}", e1 * x[0] + e2 * x[1] + e3 * x[2])
        most = steps.let(f"most{number}", sp.Max(*(CopySign(e / u, one) for e, u in zip(x, units, strict=True))))
        leads = steps.let(f"leads_{number}", exceeds(lead, STANDSTILL * most * leading_unit))
        still += exists * (1 - leads)
        share = steps.let(f"share{number}", guarded(steps, lead, leads))
        # chosen by factors of 0 and 1, not by differences: a slow joint's rate is not lost beside a fast one's
        ratios += [((1 - e1) * x[0] + e1 * x[1]) * share, ((1 - e3) * x[2] + e3 * x[1]) * share]
        links = _named(steps, frame.rates(x), str(number))
        bend_along, bend = frame.second(links, links)
        curvature = steps.let(f"k{number}", bend)
        found += x
        curvatures.append(curvature)
        changes.append(steps.let(f"dk{number}", frame.third(links)[1] - 3 * curvature * bend_along))
    unlike = [CopySign(change - kappa_s, one) for change in changes]
    status = bent * short + (1 - bent) * (2 + sloped)
    met = bent * (1 - short) + steep + (1 - bent) * (1 - sloped) * (1 - exceeds(gap, slip0))
    verdict = (
        steps.let("status", regular * status + 4 * (1 - regular)),
        steps.let("number", regular * (1 + twice)),
        steps.let("which", regular * twice * (1 - CopySign(one, unlike[1] - unlike[0])) / 2),
        steps.let("met", regular * met),
        steps.let("still", still),
    )
    outputs = (
        Output("rates", (2, 3), tuple(found)),
        Output("ratios", (2, 2), tuple(ratios)),
        Output("tracked", (2,), tuple(curvatures)),
        Output("tracked_rate", (2,), tuple(changes)),
        Output("verdict", (5,), verdict),
        Output("parabola", (3,), (p2, p1, p0)),
        Output("slack", (), (slack,)),
        Output("least", (3,), tuple(least)),
        Output("null", (3,), tuple(null)),
    )
    return Program(
        "speed_ratio_rates",
        "joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates",
        (*arm.inputs, TANGENT, CURVATURE, LEADING),
        tuple(steps.steps),
        outputs,
    )


def _named(steps: Steps, rates: Rates, label: str) -> Rates:
    return Rates([steps.let(f"w{label}_{k + 1}", e) for k, e in enumerate(rates.turning)], rates.sliding)
