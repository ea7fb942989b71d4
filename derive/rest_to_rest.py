"""Fastest motion from rest to rest along one axis, under bounds on velocity and acceleration (De Luca, exercise 2).

The speed rises at the rate A to a peak, stays, and falls at the rate A: a trapezoid of area d. It has its largest
allowed peak V if d >= V^2 / A; else there is no time to reach it, and the triangle of area d has the peak sqrt(d A).
"""

from __future__ import annotations

import sympy as sp

from chainrule.derive.program import Expression, GuardedInverse, Input, Output, Program, Steps


def _input(name: str, *labels: str) -> Input:
    return Input(name, (len(labels),), tuple(sp.Symbol(label, real=True) for label in labels))


def travelled(peak: Expression, acceleration: Expression, duration: Expression) -> Expression:
    """The trapezoid's area: peak (duration - peak / acceleration)."""
    return peak * (duration - peak / acceleration)


def profile() -> Program:
    """Peak, ramp, cruise and duration: peak = min(V, sqrt(d A)), ramp = peak / A, cruise = max(0, d / V - V / A).

    V and A are positive, and one of them may be infinite where d is not 0. Without displacement everything is 0; a
    triangle's cruise is exactly 0, since d / V < V / A.
    """
    move = _input("move", "distance", "velocity", "acceleration")
    distance, velocity, acceleration = move.symbols
    steps = Steps()
    peak = steps.let("peak", sp.Min(velocity, sp.sqrt(distance) * sp.sqrt(acceleration)))
    ramp = steps.let("ramp", peak / acceleration)
    cruise = steps.let("cruise", sp.Max(distance / velocity - velocity / acceleration, sp.Integer(0)))
    return Program(
        "rest_to_rest",
        "peak speed, ramp, cruise and duration of the fastest move from rest to rest",
        (move,),
        tuple(steps.steps),
        (Output("profile", (4,), (peak, ramp, cruise, 2 * ramp + cruise)),),
    )


def stretched() -> Program:
    """The same move in a longer time T, still with the ramps' acceleration A: the lower root of the area's equation.

    peak (T - peak / A) = d gives peak = 2 d / (T + sqrt(T^2 - 4 d / A)), written so that nothing cancels. Under the
    root stands (T - s) (T + s), s = 2 sqrt(d / A) the least time without a bound on velocity, so that no square
    overflows. The root is also the time between the ramps, T - 2 peak / A.
    """
    move = _input("move", "distance", "acceleration", "duration")
    distance, acceleration, duration = move.symbols
    steps = Steps()
    least = steps.let("least", 2 * sp.sqrt(distance) / steps.let("root_a", sp.sqrt(acceleration)))
    spare = steps.let("spare", sp.Max(duration - least, sp.Integer(0)))
    root = steps.let("root", sp.sqrt(spare) * sp.sqrt(duration + least))
    peak = steps.let("peak", distance * GuardedInverse((duration + root) / 2))
    ramp = steps.let("ramp", peak / acceleration)
    return Program(
        "rest_to_rest_in",
        "peak speed, ramp and cruise of a move from rest to rest in a given time, with the acceleration given",
        (move,),
        tuple(steps.steps),
        (Output("profile", (4,), (peak, ramp, root, duration)),),
    )


def state() -> Program:
    """Distance and speed at a time: the time spent in each phase is the time clipped to it."""
    given = _input("instant", "peak", "ramp", "cruise", "time")
    peak, ramp, cruise, time = given.symbols
    steps, zero = Steps(), sp.Integer(0)
    rising = steps.let("rising", sp.Max(sp.Min(time, ramp), zero))
    steady = steps.let("steady", sp.Max(sp.Min(time - ramp, cruise), zero))
    falling = steps.let("falling", sp.Max(sp.Min(time - ramp - cruise, ramp), zero))
    rate = steps.let("rate", peak * GuardedInverse(ramp))
    speed = steps.let("speed", rate * (rising - falling))
    reached = steps.let("reached", rate * rising)
    distance = steps.let("distance", reached * rising / 2 + peak * steady + (peak - rate * falling / 2) * falling)
    return Program(
        "rest_to_rest_state",
        "distance and speed at a time of a move from rest to rest",
        (given,),
        tuple(steps.steps),
        (Output("state", (2,), (distance, speed)),),
    )
