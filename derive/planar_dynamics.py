"""Inverse dynamics of planar chains: the equations of Newton and Euler in the plane, link by link.

Link i's frame lies in the link that joint i moves: x along the heading, the origin at the revolute joint, or for a
prismatic joint theta_i along the heading from where it is mounted; the next joint is at (l_i, 0). Outwards, in each
link's own axes: angular velocity w, angular acceleration u, acceleration a of the origin; a point (x, y) of the link
has the acceleration a + (-w^2 x - u y, u x - w^2 y). See :mod:`chainrule.derive.dynamics`, whose equations these are.
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.dynamics import joint_inputs, program
from chainrule.derive.planar import PlanarChain
from chainrule.derive.program import Expression, Program, Steps

#: The four numbers of a link's inertia in the plane: mass, first moment, moment of inertia about the frame's origin.
ENTRIES = ("m", "hx", "hy", "I")


def inverse_dynamics(arm: PlanarChain) -> Program:
    """Joint torques and forces of a motion: M(q) ddq + the velocity terms + gravity + J^T wrench.

    ``inertias`` (n, 4) hold one row of :data:`ENTRIES` for each link. ``gravity`` (2,) and ``wrench`` (3,), the force
    and moment that the tip exerts on what it touches, about the tip, are in the base frame.
    """
    steps = Steps()
    q, parameters = arm.inputs[0].symbols, arm.inputs[1].symbols
    given = joint_inputs(arm.n, ENTRIES, "xy", "mz")
    rates, accelerations, inertias, gravity, wrench = (port.symbols for port in given)
    turning = iter(parameters[arm.n :])
    w = u = squared = sp.Integer(0)
    a, force = [-g for g in gravity], list(wrench[:2])
    cosines: list[tuple[Expression, Expression]] = []
    own: list[tuple[list[Expression], Expression]] = []  # each link's own share of the force and of the moment
    for i, kind in enumerate(arm.kinds):
        name, angle = str(i + 1), q[i] if kind == "R" else next(turning)
        if i > 0:  # from the origin of link i-1 to its end
            length = parameters[i - 1]
            a = steps.vector(f"ap{name}", [a[0] - squared * length, a[1] + u * length], "xy")
        c, s = steps.let(f"c{name}", sp.cos(angle)), steps.let(f"s{name}", sp.sin(angle))
        cosines.append((c, s))
        a, force = (
            steps.vector(f"{label}t{name}", [c * v[0] + s * v[1], c * v[1] - s * v[0]], "xy")
            for label, v in (("a", a), ("f", force))
        )
        if kind == "R":
            w, u = steps.let(f"w{name}", w + rates[i]), steps.let(f"u{name}", u + accelerations[i])
            squared = steps.let(f"ww{name}", w**2)
        else:
            along = a[0] - squared * q[i] + accelerations[i]
            a = steps.vector(f"a{name}", [along, a[1] + u * q[i] + 2 * w * rates[i]], "xy")
        mass, hx, hy, inertia = inertias[4 * i : 4 * i + 4]
        link_force = [mass * a[0] - squared * hx - u * hy, mass * a[1] + u * hx - squared * hy]
        own.append((link_force, inertia * u + hx * a[1] - hy * a[0]))
    moment = wrench[2]
    torque: list[Expression] = []
    for i in range(arm.n - 1, -1, -1):
        name, (c, s) = str(i + 1), cosines[i]
        moment = steps.let(f"n{name}", own[i][1] + moment + parameters[i] * force[1])
        force = steps.vector(f"f{name}", [own[i][0][0] + force[0], own[i][0][1] + force[1]], "xy")
        torque.insert(0, moment if arm.kinds[i] == "R" else force[0])
        if arm.kinds[i] == "P":
            moment = steps.let(f"np{name}", moment + q[i] * force[1])
        force = steps.vector(f"fo{name}", [c * force[0] - s * force[1], c * force[1] + s * force[0]], "xy")
    return program(arm.inputs, given, steps, torque)
