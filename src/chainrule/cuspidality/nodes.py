"""All nodes of a 3R arm with a proof: where the image of its singular curves crosses itself in the half plane (rho, z).

Two double roots of the quartic meet one target exactly if the conic E(cos theta3, sin theta3) touches the unit circle
twice (``chainrule.derive.nodes_3r``): for one of two numbers lambda, M + lambda diag(1, 1, -1) is a line counted twice.
lambda depends on the arm alone and is a root of a quadratic equation; the target follows from one linear and one
quadratic equation. So there are at most four such targets, and all their coordinates are numbers with square roots,
whose signs are decided exactly. The line meets the circle in two real points for a node, in two complex ones for an
isolated point of the discriminant that no singular posture reaches, in one at four equal roots.

Arms whose point can meet axis 2 (ca3 = 0 and r3 = 0, d4 > d3: the orthogonal family is among them) have another kind:
at cos theta3 = -d3 / d4 all theta2 have one image, a node where a singular curve crosses that line of the joint space.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.cusps import elbow_on_balls, float_place, on_balls
from chainrule.cuspidality.exact import precision, real_roots, sign_at
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, Regional, exact_function
from chainrule.cuspidality.parameters import exact_parameters, orthogonal_lengths, why_nongeneric
from chainrule.cuspidality.surds import ball_of, reciprocal, sign_of, square_root
from chainrule.description import REGIONAL_3R

Array = NDArray[Any]

_BITS, _MOST, _AIM = 128, 4096, 1e-14


@dataclass(frozen=True)
class Node:
    """A node, an isolated point, or an event.

    Attributes:
        rho: the distance from the first joint's axis, m.
        z: the height along it, m.
        radius: a proved bound on the error of rho and of z, m.
        kind: "two double roots" or "theta2 free" of a node; "isolated" where the double roots are not real; of an event
            "four equal roots", "two nodes meet" (two double roots at a double solution), or "tangent" (theta2 is free
            and a singular curve touches the line).
    """

    rho: float
    z: float
    radius: float
    kind: str

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)


@dataclass(frozen=True)
class Nodes:
    """All nodes of one arm.

    Attributes:
        nodes: by rising z, then rho; both signs of z.
        isolated: real targets where two complex double roots meet; no posture is there, and no curve.
        events: what makes the design one between two kinds; empty elsewhere.
        nongeneric: why the arm is not generic, in words; such an arm is given no nodes.
    """

    nodes: tuple[Node, ...]
    isolated: tuple[Node, ...]
    events: tuple[Node, ...]
    nongeneric: tuple[str, ...]

    @property
    def number(self) -> int:
        """How many nodes there are."""
        return len(self.nodes)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        parts = {"nodes": self.nodes, "isolated": self.isolated, "events": self.events}
        return {
            **{name: [n.to_dict() for n in part] for name, part in parts.items()},
            "nongeneric": list(self.nongeneric),
        }


def certified_nodes(arm: Any) -> Nodes:
    """All nodes of a 3R arm, counted and enclosed with a proof.

    Args:
        arm: what :func:`chainrule.cuspidality.parameters.exact_parameters` takes; lengths in m.

    Returns:
        In the normal form's frame.

    Example:
        >>> certified_nodes([1, 2, "1.5", 1]).number, certified_nodes([1, 3, 4, 3]).number
        (0, 1)
    """
    parameters = exact_parameters(arm)
    reasons = why_nongeneric(parameters)
    if reasons:
        return Nodes((), (), (), reasons)
    found = sorted((*_contacts(parameters), *_on_second_axis(parameters)), key=lambda node: (node.z, node.rho))
    kinds = {"two double roots": 0, "theta2 free": 0, "isolated": 1}
    parts = [tuple(node for node in found if kinds.get(node.kind, 2) == k) for k in range(3)]
    return Nodes(parts[0], parts[1], parts[2], ())


def nodes(regional: Regional) -> Array:
    """The nodes of an arm: (k, 2) of rho and z in m, by rising z; see :func:`certified_nodes`."""
    return np.array([(node.rho, node.z) for node in certified_nodes(regional).nodes]).reshape(-1, 2)


# ---- two double roots --------------------------------------------------------------------------------------------


@cache
def _conic_terms(orthogonal: bool) -> Any:
    return exact_function("conic_terms", ORTHOGONAL_3R if orthogonal else REGIONAL_3R)


def _contacts(parameters: Array) -> Iterator[Node]:
    """Targets whose conic touches the circle twice, in real or complex points."""
    from flint import fmpq

    lengths = orthogonal_lengths(parameters)
    terms = _conic_terms(lengths is not None)(parameters if lengths is None else lengths)
    # entries 11, 12, 22, 13, 23, 33 by 1, R, z, R^2, z^2
    m11, m12, m22, *_ = conic = [
        [fmpq(int(x)) if isinstance(x, float) else fmpq(x) for x in row] for row in terms.tolist()
    ]
    trace, gap = m11[0] + m22[0], m11[0] - m22[0]
    root = square_root(gap * gap + 4 * m12[0] * m12[0])
    if sign_of(root) == 0:
        return  # the conic is a circle at every target: it never touches the unit circle twice
    for turn in (1, -1):
        contact = turn * root  # the trace of the quadratic part of rank one
        shift = (contact - trace) * fmpq(1, 2)
        yield from _of_one_shift(parameters, conic, contact, shift)


def _of_one_shift(parameters: Array, conic: list[list[Any]], contact: Any, shift: Any) -> Iterator[Node]:
    """The targets of one lambda = ``shift``: rank one needs N_kk N_j3 = N_12 N_k3 and N_kk (M33 - lambda) = N_k3^2."""
    m11, m12, m22, m13, m23, m33 = conic
    own, own_line, other_line = m11[0] + shift, m13, m23
    if sign_of(own) == 0:
        own, own_line, other_line = m22[0] + shift, m23, m13
    linear = [own * b - m12[0] * a for a, b in zip(own_line[:3], other_line[:3], strict=True)]
    for (whole, z), double in _solutions(linear, own, own_line, m33, shift):
        line = own_line[0] + whole * own_line[1] + z * own_line[2]
        real = sign_of(own * contact - line * line)
        kind = ("isolated", "four equal roots", "two double roots")[real + 1]
        if real > 0 and double:
            kind = "two nodes meet"
        square = whole - z * z
        if real < 0 and sign_of(square) < 0:
            continue
        yield _placed(parameters, square, z, kind)


def _solutions(linear: list[Any], own: Any, line: list[Any], m33: list[Any], shift: Any) -> Iterator[tuple[Any, bool]]:
    """(R, z) with linear . (1, R, z) = 0 and own (m33 - shift) = (line . (1, R, z))^2, and whether it is double."""
    constant, by_r, by_z = linear
    if sign_of(by_z) != 0:  # z = base + slope R
        over = reciprocal(by_z)
        start, step = (0 * own, -constant * over), (0 * own + 1, -by_r * over)
    elif sign_of(by_r) != 0:  # R is fixed
        start, step = (-constant * reciprocal(by_r), 0 * own), (0 * own, 0 * own + 1)
    else:
        return
    (r0, z0), (r1, z1) = start, step
    c0, c1 = line[0] + r0 * line[1] + z0 * line[2], r1 * line[1] + z1 * line[2]
    q0 = own * (m33[0] + r0 * m33[1] + z0 * m33[2] + r0 * r0 * m33[3] + z0 * z0 * m33[4] - shift) - c0 * c0
    q1 = own * (r1 * m33[1] + z1 * m33[2] + 2 * (r0 * r1 * m33[3] + z0 * z1 * m33[4])) - 2 * c0 * c1
    q2 = own * (r1 * r1 * m33[3] + z1 * z1 * m33[4]) - c1 * c1
    if sign_of(q2) == 0:
        if sign_of(q1) != 0:
            t = -q0 * reciprocal(q1)
            yield (r0 + t * r1, z0 + t * z1), False
        return
    discriminant = q1 * q1 - 4 * q0 * q2
    state = sign_of(discriminant)
    if state < 0:
        return
    over = reciprocal(2 * q2)
    if state == 0:
        t = -q1 * over
        yield (r0 + t * r1, z0 + t * z1), True
        return
    root = square_root(discriminant)
    for turn in (1, -1):
        t = (turn * root - q1) * over
        yield (t * r1 + r0, t * z1 + z0), False


def _placed(parameters: Array, square: Any, z: Any, kind: str) -> Node:
    """The floats of an exact target."""
    aim = _AIM * _size(parameters)
    bits = _BITS
    while True:
        with precision(bits):
            rho, height, radius = float_place(ball_of(square), ball_of(z))
        if radius <= aim or bits >= _MOST:
            return Node(rho, height, radius, kind)
        bits *= 2


def _size(parameters: Array) -> float:
    return max(abs(int(x.p) / int(x.q)) for x in parameters[4:])


# ---- the point on axis 2 -----------------------------------------------------------------------------------------


def _on_second_axis(parameters: Array) -> Iterator[Node]:
    """Targets of the point on axis 2 that singular curves pass: there (a^2 + b^2 - c^2) / (f1 d4)^2 > 0."""
    from flint import fmpq_poly

    ca3, (d3, d4), r3 = parameters[2], parameters[5:7], parameters[8]
    if ca3 != 0 or r3 != 0 or abs(d4) < abs(d3):
        return
    constant, square = exact_function("second_axis")(parameters)
    f1 = fmpq_poly([constant, 0, square])
    lengths = orthogonal_lengths(parameters)
    if lengths is None:
        reduced = fmpq_poly(list(exact_function("aspect_polynomial")(parameters))) // (f1 * f1)
    else:
        reduced = fmpq_poly(list(exact_function("aspect_polynomial", ORTHOGONAL_3R)(lengths)))
    for root in real_roots(f1, 2):
        crossing = sign_at(reduced, root, 4)
        if crossing < 0 and root.multiplicity == 1:
            continue
        kind = "theta2 free" if crossing > 0 and root.multiplicity == 1 else "tangent"
        with precision(2 * _BITS):
            target = exact_function("image")(
                on_balls(parameters), on_balls((1, 0)), elbow_on_balls(root.refined(_BITS))
            )
            rho, z, radius = float_place(*on_balls(target))
        yield Node(rho, z, radius, kind)
