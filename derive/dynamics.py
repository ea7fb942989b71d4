"""Inverse dynamics of any serial chain: the recursive equations of Newton and Euler, as named steps.

Link i's frame moves with joint i. Outwards, in each link's own axes: angular velocity w, angular acceleration u and
acceleration a of the frame's origin; with U = [u]x + [w]x [w]x, a point r of the link has the acceleration a + U r.
Gravity is an acceleration -g of the base. Inwards: the force and the moment (about the frame's origin) that joint i
passes on to its link; the joint's torque (or force) is their part about (or along) its axis:

    force_i  = m a + U h + force_i+1,    moment_i = I u + w x I w + h x a + moment_i+1 + r x force_i+1.

A link's inertia is its mass m, first moment h = m c (c its centre) and tensor I about the frame's origin: the torque is
linear in these ten numbers. Source: Luh, Walker and Paul 1980; U and the axes of the links, which save operations, are
those of Khalil and Kleinfinger 1987.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.chain import Chain, Vector, combine, cross, sine_cosine
from chainrule.derive.program import Expression, Input, Output, Program, Steps, variables

#: The ten numbers of a link's inertia, in the order of the input ``inertias``.
ENTRIES = ("m", "hx", "hy", "hz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")


@dataclass(frozen=True)
class Motion:
    """A link's motion in its own axes: w, u, a; and in the same axes the tip's force and moment on what it touches."""

    angular_velocity: Vector
    angular_acceleration: Vector
    acceleration: Vector
    force: Vector
    moment: Vector


def joint_inputs(n: int, entries: tuple[str, ...], axes: str, turns: str) -> tuple[Input, ...]:
    """The inputs beside those of the arm: rates, accelerations, inertias, gravity, and the wrench of the tip."""
    inertias = tuple(sp.Symbol(f"{entry}{i + 1}", real=True) for i in range(n) for entry in entries)
    gravity = tuple(sp.Symbol(f"g{axis}", real=True) for axis in axes)
    wrench = tuple(sp.Symbol(name, real=True) for name in (*(f"f{axis}" for axis in axes), *turns.split()))
    return (
        variables("rates", n, "dq"),
        variables("accelerations", n, "ddq"),
        Input("inertias", (n, len(entries)), inertias),
        Input("gravity", (len(gravity),), gravity),
        Input("wrench", (len(wrench),), wrench),
    )


def plus(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    return [sum(entries, sp.Integer(0)) for entries in zip(*vectors, strict=True)]


def inward(arm: Chain, i: int, vector: Vector) -> Vector:
    """From link i-1's axes to those of the placed frame of joint i."""
    return combine(tuple(vector), tuple(list(row) for row in arm.links[i].rotation))


def outward(arm: Chain, i: int, vector: Vector) -> Vector:
    """From the axes of the placed frame of joint i to link i-1's."""
    return [sum((r * v for r, v in zip(row, vector, strict=True)), sp.Integer(0)) for row in arm.links[i].rotation]


def turned(steps: Steps, arm: Chain, i: int, vector: Vector, sign: int = 1) -> Vector:
    """From the placed to the moved axes of a revolute joint i (back, for sign -1)."""
    s, c = sine_cosine(steps, arm, i)
    s = sign * s
    return [c * vector[0] + s * vector[1], c * vector[1] - s * vector[0], vector[2]]


def rotation_rates(steps: Steps, w: Vector, u: Vector, name: str) -> list[Vector]:
    """The rows of U = [u]x + [w]x [w]x."""
    xx, yy, zz = (steps.let(f"w{axis}{axis}{name}", w[k] ** 2) for k, axis in enumerate("xyz"))
    xy, xz, yz = (steps.let(f"w{p}{q}{name}", w["xyz".index(p)] * w["xyz".index(q)]) for p, q in ("xy", "xz", "yz"))
    entries = ((-yy - zz, xy - u[2], xz + u[1]), (xy + u[2], -xx - zz, yz - u[0]), (xz - u[1], yz + u[0], -xx - yy))
    return [steps.vector(f"U{axis}{name}", row) for axis, row in zip("xyz", entries, strict=True)]


def times(rows: list[Vector], vector: Vector) -> Vector:
    """A matrix times a vector."""
    return [sum((a * b for a, b in zip(row, vector, strict=True)), sp.Integer(0)) for row in rows]


def euler(steps: Steps, inertia: Vector, w: Vector, u: Vector, rates: list[Vector], name: str) -> Vector:
    """I u + w x I w, gathered by the entries of I: 15 products with the entries of U."""
    xx, xy, xz, yy, yz, zz = inertia
    (_, u_xy, u_xz), (u_yx, _, u_yz), (u_zx, u_zy, _) = rates
    wx, wy, wz = w
    squares = [steps.let(f"w{axis}s{name}", value) for axis, value in zip("xyz", (wx**2, wy**2, wz**2), strict=True)]
    product = {p: steps.let(f"w{p}{name}", value) for p, value in (("yz", wy * wz), ("xz", wx * wz), ("xy", wx * wy))}
    return [
        xx * u[0] + (zz - yy) * product["yz"] + xz * u_yx - xy * u_zx + yz * (squares[1] - squares[2]),
        yy * u[1] + (xx - zz) * product["xz"] + xy * u_zy - yz * u_xy + xz * (squares[2] - squares[0]),
        zz * u[2] + (yy - xx) * product["xy"] + yz * u_xz - xz * u_yz + xy * (squares[0] - squares[1]),
    ]


def inverse_dynamics(arm: Chain) -> Program:
    """Joint torques and forces of a motion: M(q) ddq + the velocity terms + gravity + J^T wrench.

    ``inertias`` (n, 10) hold one row of :data:`ENTRIES` for each link, in its joint's moved frame. ``gravity`` (3,) and
    ``wrench`` (6,), the force and moment that the tip exerts on what it touches, about the tip, are in the base frame.
    """
    steps, zero = Steps(), [sp.Integer(0)] * 3
    given = joint_inputs(arm.n, ENTRIES, "xyz", "mx my mz")
    rates, accelerations, inertias, gravity, wrench = (port.symbols for port in given)
    motion = Motion(zero, zero, [-g for g in gravity], list(wrench[:3]), list(wrench[3:]))
    matrix: list[Vector] = [zero, zero, zero]
    own: list[tuple[Vector, Vector]] = []  # each link's own share of the force and of the moment
    for i in range(arm.n):
        motion, matrix = _outwards(steps, arm, i, motion, matrix, rates[i], accelerations[i])
        mass, *rest = inertias[10 * i : 10 * i + 10]
        first, tensor, a = rest[:3], rest[3:], motion.acceleration
        force = plus([mass * entry for entry in a], times(matrix, first))
        spin = euler(steps, tensor, motion.angular_velocity, motion.angular_acceleration, matrix, str(i + 1))
        own.append((force, plus(spin, cross(first, a))))
    force, moment = motion.force, plus(motion.moment, cross(list(arm.tool.translation), motion.force))
    torque: list[Expression] = []
    for i in range(arm.n - 1, -1, -1):
        kind, name = arm.kinds[i], str(i + 1)
        force = steps.vector(f"f{name}", plus(own[i][0], force))
        moment = steps.vector(f"n{name}", plus(own[i][1], moment))
        torque.insert(0, (moment if kind == "R" else force)[2])
        if kind == "P":  # about the origin of the placed frame, which the joint has left by q along z
            moment = plus(moment, cross([*zero[:2], arm.q[i]], force))
        else:
            force = steps.vector(f"ft{name}", turned(steps, arm, i, force, -1))
            moment = turned(steps, arm, i, moment, -1)
        force, moment = outward(arm, i, force), outward(arm, i, steps.vector(f"nt{name}", moment))
        force = steps.vector(f"fo{name}", force)
        moment = plus(moment, cross(list(arm.links[i].translation), force))
    return program(arm.inputs, given, steps, torque)


def program(arm: tuple[Input, ...], given: tuple[Input, ...], steps: Steps, torque: list[Expression]) -> Program:
    """The program of inverse dynamics, from its last quantities."""
    return Program(
        "inverse_dynamics",
        "torques and forces of the joints for a motion, under gravity and a wrench of the tip",
        (*arm, *given),
        tuple(steps.steps),
        (Output("torque", (len(torque),), tuple(torque)),),
    )


def _outwards(
    steps: Steps, arm: Chain, i: int, motion: Motion, matrix: list[Vector], rate: Expression, acceleration: Expression
) -> tuple[Motion, list[Vector]]:
    """Link i's motion and matrix U, from those of link i-1."""
    name, revolute = str(i + 1), arm.kinds[i] == "R"
    origin = steps.vector(f"ap{name}", plus(motion.acceleration, times(matrix, list(arm.links[i].translation))))
    turning = (motion.angular_velocity, motion.angular_acceleration)
    found = []
    for label, vector in zip("wuafm", (*turning, origin, motion.force, motion.moment), strict=True):
        vector = steps.vector(f"{label}o{name}", inward(arm, i, vector))
        found.append(steps.vector(f"{label}t{name}", turned(steps, arm, i, vector)) if revolute else vector)
    w, u, a, force, moment = found
    across = [w[1] * rate, -w[0] * rate, sp.Integer(0)]  # w x (the joint's own velocity along z)
    if revolute:
        u = steps.vector(f"u{name}", plus(u, across, [sp.Integer(0), sp.Integer(0), acceleration]))
        w = [*w[:2], steps.let(f"wz{name}", w[2] + rate)]
    matrix = rotation_rates(steps, w, u, name)
    if not revolute:
        shift = [arm.q[i] * row[2] for row in matrix]
        a = steps.vector(f"a{name}", plus(a, shift, [2 * x for x in across], [sp.Integer(0)] * 2 + [acceleration]))
    return Motion(w, u, a, force, moment), matrix
