"""The self-motion of an arm at a target: every curve, by the best method for the arm."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.errors import InputError, shown
from chainrule.inputs import whole_number
from chainrule.self_motions import components as finding
from chainrule.self_motions.held import Held, checked_targets, held_task, length_scale, target_shape
from chainrule.self_motions.projection import project, start_points
from chainrule.self_motions.result import ENDS, MOST_POINTS, Component, SelfMotion

Array = NDArray[Any]

#: What ``method`` may be, besides None for the best one.
METHODS = ("closed form", "sweep", "continuation", "eigenvector")
#: A curve that ends at a singular configuration after less than this, rad, is none.
NOTHING = 1e-6


def self_motion(
    arm: Arm,
    target: Any,
    task: str | None = None,
    *,
    method: str | None = None,
    limits: bool = False,
    points: int | None = None,
    starts: int = 64,
    seed: int = 0,
    scale: float = 1.0,
    gamma: float = 0.001,
) -> SelfMotion:
    """Every curve of joint space on which an arm with one joint to spare holds a target.

    Planar 3R arms (tasks "position" and "x_alpha") and 7R arms with spherical shoulder and wrist have a closed form; of
    7R arms with one of them, one joint is swept with all postures of the rest: in both cases ``complete`` is "proved",
    if the conditions of the proof hold at this target. Of any other arm the curves through many starts are followed,
    and ``complete`` says how many. Curves are followed without jumping (:mod:`chainrule.self_motions.tracing`).

    Args:
        arm: an arm with one joint more than the task has rows.
        target: planar (2,) x and y in m, (2,) x and alpha, or (3,) x, y and alpha; spatial (3,), or a pose (4, 4). For
            the target of a posture q see ``arm.position(q)`` and ``arm.pose(q)``.
        task: "position", "x_alpha" or "pose"; the arm's default task when absent.
        method: "closed form" or "sweep" (where there is one), "continuation" (many starts), or "eigenvector", the
            algorithm of Lenarcic (2002) as printed, which follows one curve; the best one when absent.
        limits: whether to find what is within the arm's joint limits (:attr:`SelfMotion.feasible`), if it has any.
        points: how many points of each curve to give, evenly spaced; as they were found when absent.
        starts: how many starts the search has.
        seed: of the starts.
        scale: m that count as one radian of a prismatic joint.
        gamma: step of "eigenvector", rad.

    Raises:
        InputError: n - m is not 1; a target, task or method that is not accepted.

    Example:
        >>> import chainrule as cr
        >>> panda = cr.load("panda")
        >>> found = cr.self_motion(panda, panda.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4]), limits=True)
        >>> found.count, found.complete, len(found.arcs)
        (8, 'proved', 4)
        >>> len({round(curve.length, 8) for curve in found.components})  # pairs of equal length
        4
    """
    task = held_task(arm, task)
    aim = _target(arm, task, target)
    if method is not None and method not in METHODS:
        raise InputError(f"method: {shown(method)}; {', '.join(METHODS)} or None are accepted")
    scale, starts = length_scale(scale), whole_number(starts, "starts")
    seed = whole_number(seed, "seed", 0)
    if points is not None:
        points = whole_number(points, "points", 2, MOST_POINTS)
    closed = isinstance(arm.description.geometry, Planar) and arm.kinds == "RRR"
    if closed and method in (None, "closed form"):
        from chainrule.self_motions.planar_3r import planar_self_motion

        return planar_self_motion(arm, aim, task, points=129 if points is None else points, limits=limits)
    if method == "eigenvector":
        found = _eigenvector(Held(arm, task, scale), aim, gamma, starts, seed)
    elif method == "continuation":
        found = finding.searched(Held(arm, task, scale), aim, starts, seed)
    else:
        found = finding.all_components(arm, aim, task, starts=starts, seed=seed, scale=scale)
        if method is not None and found.method != method:
            raise InputError(
                f"{arm.name}: no {method} is known for its task '{task}' at this target; '{found.method}' is"
            )
    return _result(arm, task, aim, found, limits, points)


def _target(arm: Arm, task: str, target: Any) -> Array:
    """One target, checked; of a pose the rotation nearest to the one given."""
    found, shape = checked_targets(arm, task, target), target_shape(arm, task)
    if found.shape != shape:
        raise InputError(f"target has shape {found.shape}; one target ({', '.join(map(str, shape))}) is accepted")
    if shape == (4, 4):
        if np.abs(found[3] - (0.0, 0.0, 0.0, 1.0)).max() > 1e-9:
            raise InputError(f"target: its last row is {found[3].tolist()}; 0, 0, 0, 1 is accepted")
        u, _, v = np.linalg.svd(found[:3, :3])
        found = found.copy()
        found[:3, :3] = u @ v
    return found


def _result(arm: Arm, task: str, target: Array, found: finding.Found, limits: bool, points: int | None) -> SelfMotion:
    """The curves as a result, with what limits leave of them."""
    curves = found.components
    broken = any("singular" in end for curve in curves for end in _reasons(curve))
    status = "singular" if found.detail or broken else "regular" if curves else "unreachable"
    detail = found.detail or ("a curve runs into a singular configuration" if broken else "")
    if broken:  # starts at singular configurations lead nowhere: the pieces between them are what is known
        curves = tuple(curve for curve in curves if curve.closed or curve.length > NOTHING)
        detail += "" if curves else "; every posture found is singular"
    feasible = None
    if limits and np.isfinite(arm.limits.position).any():
        from chainrule.self_motions.limits import feasible as within

        feasible = within(arm, curves, task)
    if points is not None:
        curves = tuple(_spaced(curve, points) for curve in curves)
        feasible = None if feasible is None else tuple(_spaced(curve, points) for curve in feasible)
    return SelfMotion(
        arm=arm.name,
        task=task,
        target=target,
        method=found.method,
        status=status,
        detail=detail,
        components=curves,
        complete=found.complete,
        feasible=feasible,
    )


def _reasons(curve: Component) -> tuple[str, ...]:
    return tuple("singular" for end in curve.ends if end in ("singular", ENDS["singular"]))


def _spaced(curve: Component, points: int) -> Component:
    if len(curve.q) < 2:
        return curve
    return replace(curve, q=curve.at(np.linspace(0.0, 1.0, points)))


def _eigenvector(held: Held, target: Array, gamma: float, starts: int, seed: int) -> finding.Found:
    """One curve by the paper's method, from the first start that reaches the target."""
    from chainrule.self_motions.eigenvector import eigenvector

    q, arrived = project(held.arm, start_points(held.arm, starts, seed), target, held.task, scale=held.scale)
    if not arrived.any():
        return finding.Found((), "eigenvector", f"{starts} starts, none of which reached the target")
    run = eigenvector(held.arm, q[np.argmax(arrived)], held.task, gamma=gamma)
    path = np.asarray(run.q)
    h = held.arm.manipulability(path, task=held.task)
    done = run.status == "closed"
    curve = Component(
        q=path,
        length=run.length,
        closed=done,
        winding=run.winding if done else np.zeros(held.arm.n, int),
        box=np.stack([path.min(axis=0), path.max(axis=0)], axis=1),
        manipulability=(float(h.min()), float(h.max())),
        residual=run.drift,
        closure=run.closure if done else float("nan"),
        ends=() if done else ("start", run.status),
    )
    return finding.Found((curve,), "eigenvector", "1 start, one curve")
