"""A motion measured: what a joint motion along a path did to the tip, the manipulability and the torques."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.redundancy.result import Event, Run, Status
from chainrule.redundancy.step import Law, Step, Stepper
from chainrule.redundancy.words import rounded
from chainrule.tables import joint_unit

Array = NDArray[Any]

#: A manipulability below this share of the largest so far is near a singularity.
NEAR = 0.1
#: A start that misses the first target by more than this, m or rad, is off the path.
OFF = 1e-3
#: A tip farther from its target than this share of the path's extent (or OFF), or turned more (rad), has left the path.
LEFT, TURNED = 0.01, 0.05
#: By how much a joint's limit counts as passed, relative to it.
PASSED = 1e-6
#: How a run ends that does not stop early.
END = "the end of the path was reached"


def measured(
    arm: Arm,
    task: str,
    *,
    method: str,
    law: Law | None,
    integrator: str,
    dt: float,
    t: Array,
    q: Array,
    held: Array,
    velocity: Array,
    rates: Array | None = None,
    accelerations: Array | None = None,
    scale: Array | None = None,
    step: Step | None = None,
    events: Iterable[Event] = (),
    status: Status = "complete",
    reason: str = END,
    near: float = NEAR,
    gravity: Any = None,
    wrench: Any = None,
) -> Run:
    """The run of a joint motion: errors, manipulability, null-space motion, torques, and events of singularity.

    Args:
        arm: the arm.
        task: what is held.
        method: as in :class:`Run`.
        law: likewise; the one of plain feedback and no gains where it is None.
        integrator: likewise.
        dt: s.
        t: (k,) s.
        q: (k, n) rad or m.
        held: (k, ...) targets.
        velocity: (k, m) of the targets.
        rates: (k, n); those of the law when absent.
        accelerations: (k, n); differences of the rates when absent.
        scale: (k,) 1 when absent.
        step: what the law gives at every sample, where it is known already.
        events: found before.
        status: as in :class:`Run`.
        reason: likewise.
        near: share of the largest manipulability so far below which a singularity is near.
        gravity: as in ``Arm.inverse_dynamics``.
        wrench: likewise.
    """
    found = Stepper(arm, law, task)(q, held, velocity, dt) if step is None else step
    null = found.null_motion
    if rates is None:
        rates = found.rates
    else:
        null = null_part(arm, task, law, q, held, rates)
    if accelerations is None:
        accelerations = differences(t, rates)
    torque = None
    if has_inertias(arm):
        torque = arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench)
    away, turned = errors(arm, task, found.error)
    off = share_off(held, away, turned)
    if reason == END and off[-1] > 1.0:
        reason = f"the end of the path's time was reached, the tip {_how_far(away[-1:], turned[-1:])} off its target"
    everything = [
        *beginning(away, turned),
        *events,
        *leaving(t, off, away, turned),
        *passing(arm, t, q, rates),
        *nearing(t, found.manipulability, near),
    ]
    return Run(
        arm=arm,
        task=task,
        method=method,
        law=law,
        integrator=integrator,
        dt=dt,
        t=t,
        q=q,
        rates=rates,
        accelerations=accelerations,
        torque=torque,
        held=held,
        manipulability=found.manipulability,
        determinant=found.manipulability**2,
        position_error=away,
        orientation_error=turned,
        frame_errors=frame_errors(arm, task, q, held, away, turned),
        null_motion=null,
        scale=np.ones(len(t)) if scale is None else scale,
        events=tuple(sorted(everything, key=lambda event: event.t)),
        status=status,
        reason=reason,
    )


def has_inertias(arm: Arm) -> bool:
    """Whether every link has an inertia."""
    known = arm.description.inertias
    return bool(known) and all(inertia is not None for inertia in known)


def null_part(arm: Arm, task: str, law: Law | None, q: Array, held: Array, rates: Array) -> Array:
    """The part of rates (k, n) that does not move the tip: rates - J+ J rates, weighted as the law says."""
    plain = Stepper(arm, Law(weights=None if law is None else law.weights), task)
    moved = (arm.jacobian(q, task=task) @ rates[..., None])[..., 0]
    return np.asarray(rates - plain(q, held, moved, 0.0).rates)


def differences(t: Array, rates: Array) -> Array:
    """Accelerations (k, n): central differences of the rates, one-sided at both ends; 0 for a single sample."""
    if len(t) < 2:
        return np.zeros_like(rates)
    return np.asarray(np.gradient(rates, t, axis=0))


def places(arm: Arm, task: str) -> int:
    """How many rows of a task are lengths; the others are angles."""
    planar = isinstance(arm.description.geometry, Planar)
    return 1 if task == "x_alpha" else 2 if planar else 3


def errors(arm: Arm, task: str, error: Array) -> tuple[Array, Array]:
    """Position errors (..., p) and rotation vectors (..., r) of a step's errors (..., m).

    A step's orientation error is 2 sin(angle / 2) along the axis.
    """
    rows = places(arm, task)
    sines = error[..., rows:]
    size = np.linalg.norm(sines, axis=-1, keepdims=True)
    angle = 2.0 * np.arcsin(np.minimum(size / 2.0, 1.0))
    return error[..., :rows], sines * np.where(size > 0.0, angle / np.where(size > 0.0, size, 1.0), 1.0)


def frame_errors(arm: Arm, task: str, q: Array, held: Array, away: Array, turned: Array) -> Array:
    """|n - n_d|, |o - o_d|, |a - a_d|, |p - p_d| (k, 4); nan for axes that the task leaves free."""
    found = np.full((len(q), 4), np.nan)
    found[:, 3] = np.linalg.norm(away, axis=1)
    if held.shape[1:] == (4, 4):
        pose = arm.pose(q)
        found[:, :3] = np.linalg.norm(pose[:, :3, :3] - held[:, :3, :3], axis=1)
    elif turned.shape[1] == 1:  # in the plane: x and y of the tip turn together, z stays
        found[:, :2], found[:, 2] = 2.0 * np.abs(np.sin(turned / 2.0)), 0.0
    return found


def beginning(away: Array, turned: Array) -> list[Event]:
    """An event if the first sample misses its target by more than :data:`OFF`; errors (k, p) in m and (k, r) in rad."""
    length, angle = (float(np.linalg.norm(part[:1])) for part in (away, turned))
    if not max(length, angle) > OFF:
        return []
    return [Event(0.0, "start off the path", f"the tip begins {_how_far(away[:1], turned[:1])} off the first target")]


def _how_far(away: Array, turned: Array) -> str:
    """The largest of errors (k, p) in m and (k, r) in rad, in words."""
    length, angle = (float(np.linalg.norm(part, axis=1).max(initial=0.0)) for part in (away, turned))
    return f"{rounded(1000.0 * length, 3):g} mm and {round(np.degrees(angle), 6):.3g} degrees"


def share_off(held: Array, away: Array, turned: Array) -> Array:
    """How far the tip is from its target (k,), as a share of what counts as having left the path.

    Args:
        held: (k, ...) targets.
        away: (k, p) m.
        turned: (k, r) rad.
    """
    targets = held[:, :3, 3] if held.ndim == 3 else held[:, : away.shape[1]]
    extent = float(np.linalg.norm(np.ptp(targets, axis=0)))
    distance, angle = (np.linalg.norm(part, axis=1) for part in (away, turned))
    return np.asarray(np.maximum(distance / max(LEFT * extent, OFF), angle / TURNED))


def leaving(t: Array, off: Array, away: Array, turned: Array) -> list[Event]:
    """An event for every stretch in which the tip has left the path, but for one that begins with the run."""
    return [
        Event(
            float(t[first]),
            "path left",
            f"the tip is up to {_how_far(away[first : last + 1], turned[first : last + 1])} off its target until "
            f"{t[last]:.4g} s",
        )
        for first, last in stretches(off > 1.0)
        if first
    ]


def passing(arm: Arm, t: Array, q: Array, rates: Array) -> list[Event]:
    """An event for every joint that is outside its limits of position or velocity, when it is so first."""
    low, high = arm.limits.position.T
    most = arm.limits.velocity
    found = []
    for kind, beyond, size, power in (
        ("position", np.maximum(q - high, low - q), np.maximum(1.0, np.abs(q)), ""),
        ("velocity", np.abs(rates) - most, most, "/s"),
    ):
        with np.errstate(invalid="ignore"):  # no limit
            outside = beyond > PASSED * size
        for j in np.flatnonzero(outside.any(axis=0)):
            text = (
                f"joint '{arm.joint_names[j]}' passes its {kind} limit, by up to {beyond[:, j].max():.3g} "
                f"{joint_unit(arm.kinds[j])}{power}"
            )
            found.append(Event(float(t[int(outside[:, j].argmax())]), "limit passed", text))
    return found


def stretches(mask: Array) -> list[tuple[int, int]]:
    """First and last index of every run of true entries."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [(first, beyond - 1) for first, beyond in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)]


def nearing(t: Array, w: Array, near: float) -> list[Event]:
    """An event for every stretch in which the manipulability is below ``near`` times the largest so far."""
    share = w / np.maximum(np.maximum.accumulate(w), 1e-300)
    found = []
    for first, last in stretches(share < near):
        least = first + int(np.argmin(w[first : last + 1]))
        found.append(
            Event(
                float(t[first]),
                "singularity near",
                f"the manipulability falls to {w[least]:.3g} at {t[least]:.4g} s, {100.0 * share[least]:.2g} % of the "
                "largest before",
            )
        )
    return found
