"""What following a path gave, in sentences and tables: the same ones on the terminal, in figures and in the report."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from chainrule.arm import Arm
from chainrule.redundancy.result import Run
from chainrule.tables import Cell, Column, Table, joint_unit, readable

#: What each method is called.
METHODS = {
    "gradient_projection": "gradient projection",
    "priority": "task priority",
    "global": "global optimum",
}


#: Methods whose least H differ by less than this share are as far from singularities as each other.
ALIKE = 1e-3


def method_name(run: Run) -> str:
    """The method, and the gains of its criteria.

    Example:
        >>> import chainrule as cr
        >>> from chainrule.redundancy import words
        >>> words.METHODS["gradient_projection"]
        'gradient projection'
    """
    method, comma, rest = run.method.partition(",")  # "gradient_projection, least time"
    name = METHODS.get(method, method.replace("_", " "))
    gains = {} if run.law is None else {key: gain for key, gain in run.law.gains.items() if gain != 0.0}
    told = " and ".join(f"{readable(float(gain))} on {key}" for key, gain in gains.items())
    if method == "gradient_projection" and not told:
        name = "pseudoinverse"
    elif told:
        name = f"{name}, {told}"
    return name + comma + rest


def setup(run: Run) -> str:
    """How the path was followed: method, gains, feedback, integrator, step."""
    parts = [method_name(run)]
    if run.law is not None and any(run.law.feedback):
        one, two = run.law.feedback
        parts.append(f"feedback {readable(one)}" + ("" if one == two else f" and {readable(two)}") + " 1/s")
    if run.law is not None and run.law.damping.kind != "none":
        parts.append(f"damping: {run.law.damping.kind}")
    return ", ".join(
        [*parts, INTEGRATORS.get(run.integrator, run.integrator), f"step {readable(1000.0 * run.dt, 3)} ms"]
    )


#: What each integrator is called.
INTEGRATORS = {"euler": "Euler", "heun": "Heun", "rk4": "RK4", "dop853": "DOP853", "toppra": "timed by TOPP-RA"}


def rate_unit(arm: Arm, power: str = "s") -> str:
    """The unit of joint rates, or with ``power`` "s²" of accelerations.

    >>> import chainrule as cr
    >>> rate_unit(cr.load("panda")), rate_unit(cr.planar("PRR", [0.2, 0.3, 0.2]), "s²")
    ('rad/s', 'm/s² or rad/s²')
    """
    return " or ".join(f"{joint_unit(kind)}/{power}" for kind in dict.fromkeys(arm.kinds))


def torque_unit(arm: Arm) -> str:
    """The unit of joint torques, of forces where there are slides.

    >>> import chainrule as cr
    >>> torque_unit(cr.load("panda"))
    'N m'
    """
    return " or ".join({"R": "N m", "P": "N"}[kind] for kind in dict.fromkeys(arm.kinds))


def masses(arm: Arm) -> str:
    """The link masses that torques rest on, called assumed where the arm's source says so; empty without masses.

    Example:
        >>> import chainrule as cr
        >>> masses(cr.load("sanchez_8r"))
        'assumed link masses 3, 2.5, 2, 1.5, 1.2, 1, 0.6, 0.4 kg'
    """
    inertias = arm.description.inertias
    if not inertias or None in inertias:
        return ""
    assumed = "assumed link masses" if "assumed" in arm.description.source else "link masses"
    return f"{assumed} {', '.join(readable(float(inertia.mass)) for inertia in inertias if inertia is not None)} kg"


def finding(run: Run) -> str:
    """One run in a sentence: whether the path was followed, how near to a singularity, how fast, how exactly."""
    rates = f"joint rates up to {readable(run.peak_rate, 3)} {rate_unit(run.arm)}"
    if run.status != "complete":
        return f"{run.arm.name} stops at {readable(float(run.t[-1]), 3)} s: {run.reason}"
    nearest = float(run.t[run.manipulability.argmin()])
    left, end = left_at(run), readable(float(run.t[-1]), 4)
    did = f"follows the path in {end} s" if left is None else f"leaves the path at {readable(left, 3)} s of {end} s"
    tip = "tip within" if left is None else "tip off by up to"
    return (
        f"{run.arm.name} {did}: "
        f"H ≥ {readable(run.min_manipulability, 3)} (least at {readable(nearest, 3)} s), {rates}, "
        f"{tip} {readable(rounded(1000.0 * run.worst_position_error, 3))} mm"
    )


def left_at(run: Run) -> float | None:
    """When the tip left the path first, s; None if it never did.

    Example:
        >>> import chainrule as cr
        >>> from chainrule.redundancy.step import Damping
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> outwards = cr.TaskPath.line((1.0, 0.0), (2.0, 0.0), duration=1.0)
        >>> run = cr.track(arm, outwards, [1.0, -1.5, -0.9], damping=Damping("constant", 0.1))
        >>> 0.7 < left_at(run) < 0.8  # it reaches as far as 1.75 m
        True
    """
    return next((event.t for event in run.events if event.kind == "path left"), None)


def comparison_finding(runs: Mapping[str, Run]) -> str:
    """Several runs of one path in a sentence: who stays farthest from singularities, and who needs the lowest rates."""
    done = {name: run for name, run in runs.items() if run.status == "complete" and left_at(run) is None}
    if not done:
        return "No method follows the path to its end"
    if len(done) == 1:
        ((name, run),) = done.items()
        return f"Only {name} follows the path to its end: H ≥ {readable(run.min_manipulability, 3)}"
    least = max(run.min_manipulability for run in done.values())
    clear = [name for name, run in done.items() if run.min_manipulability >= (1.0 - ALIKE) * least]
    slow = min(done, key=lambda name: done[name].peak_rate)
    unit = rate_unit(done[slow].arm)
    rates = [done[slow].peak_rate, max(run.peak_rate for run in done.values())]
    alike = clear[0] if len(clear) == 1 else f"{len(clear)} methods alike"
    return (
        f"Farthest from singularities: {alike} (H ≥ {readable(least, 3)}). "
        f"Lowest rates: {slow} ({readable(rates[0], 3)} {unit}; the highest are {readable(rates[1], 3)})"
    )


def comparison_table(runs: Mapping[str, Run], costs: Sequence[float] = ()) -> Table:
    """One row for each run; with ``costs`` also what a step of it cost, in s."""
    arm = next(iter(runs.values())).arm
    with_torque = any(run.torque is not None for run in runs.values())
    columns = [
        Column("method", "method"),
        Column("status", "status"),
        Column("duration", "time", "s"),
        Column("min_manipulability", "least H"),
        Column("peak_rate", "peak rate", rate_unit(arm)),
        *([Column("peak_torque", "peak torque", torque_unit(arm))] if with_torque else []),
        Column("worst_position_error", "worst error", "mm"),
        Column("final_position_error", "final error", "mm"),
        *([Column("step_cost", "cost of a step", "µs")] if costs else []),
    ]
    rows = []
    for k, (name, run) in enumerate(runs.items()):
        cells: list[Cell] = [name, run.status if left_at(run) is None else "path left", rounded(float(run.t[-1]))]
        cells += [rounded(run.min_manipulability), rounded(run.peak_rate)]
        cells += [None if run.peak_torque is None else rounded(run.peak_torque)] if with_torque else []
        cells += [rounded(1000.0 * run.worst_position_error), rounded(1000.0 * run.final_position_error)]
        rows.append((*cells, *([rounded(1e6 * costs[k], 2)] if costs else [])))
    return Table("", tuple(columns), tuple(rows))


def rounded(value: float, digits: int = 4) -> float:
    """A number to so many significant digits.

    >>> rounded(0.0193864)
    0.01939
    """
    return float(f"{value:.{digits - 1}e}") if math.isfinite(value) else value


def events_table(run: Run, most: int = 12) -> Table:
    """What happened on the way, the first ``most``."""
    columns = (Column("t", "time", "s"), Column("kind", "event"), Column("text", "what"))
    more = f"; {len(run.events) - most} more" if len(run.events) > most else ""
    rows = tuple((rounded(event.t), event.kind, event.text) for event in run.events[:most])
    return Table(f"Events{more}", columns, rows)
