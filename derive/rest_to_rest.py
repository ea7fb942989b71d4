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
    """Peak, ramp, cruise and duration: peak = min(V, sqrt(d A)), ramp = peak / A, cruise = d / peak - ramp.

    Without displacement everything is 0; a triangle's cruise is 0 up to rounding, which never makes it negative.
    """
    move = _input("move", "distance", "velocity", "acceleration")
    distance, velocity, acceleration = move.symbols
    steps = Steps()
    peak = steps.let("peak", sp.Min(velocity, sp.sqrt(distance) * sp.sqrt(acceleration)))
    ramp = steps.let("ramp", peak / acceleration)
    cruise = steps.let("cruise", sp.Max(distance * GuardedInverse(peak) - ramp, sp.Integer(0)))
    return Program(
        "rest_to_rest",
        "peak speed, ramp, cruise and duration of the fastest move from rest to rest",
        (move,),
        tuple(steps.steps),
        (Output("profile", (4,), (peak, ramp, cruise, 2 * ramp + cruise)),),
    )


def stretched() -> Program:
    """The same move in a longer time T, still with the ramps' acceleration A: the lower root of the area's equation.

    peak (T - peak / A) = d gives peak = 2 d / (T + sqrt(T^2 - 4 d / A)), written so that nothing cancels.
    """
    move = _input("move", "distance", "acceleration", "duration")
    distance, acceleration, duration = move.symbols
    steps = Steps()
    root = steps.let("root", sp.sqrt(sp.Max(duration**2 - 4 * (distance / acceleration), sp.Integer(0))))
    peak = steps.let("peak", 2 * distance * GuardedInverse(duration + root))
    ramp = steps.let("ramp", peak / acceleration)
    cruise = steps.let("cruise", duration - 2 * ramp)
    return Program(
        "rest_to_rest_in",
        "peak speed, ramp and cruise of a move from rest to rest in a given time, with the acceleration given",
        (move,),
        tuple(steps.steps),
        (Output("profile", (4,), (peak, ramp, cruise, duration)),),
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
    distance = steps.let("distance", rate * rising**2 / 2 + peak * steady + (peak - rate * falling / 2) * falling)
    return Program(
        "rest_to_rest_state",
        "distance and speed at a time of a move from rest to rest",
        (given,),
        tuple(steps.steps),
        (Output("state", (2,), (distance, speed)),),
    )
