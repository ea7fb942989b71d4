"""Figures 5.1 to 5.32 of E. A. Sanchez's thesis, from the start postures that were found, and three that say more."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure

from chainrule.papers.sanchez_paths import ON, the_arm
from chainrule.papers.sanchez_runs import (
    COARSE,
    FINE,
    GAINS,
    LOST,
    MANY,
    ROOT,
    each,
    gain_map,
    least,
    millimetres,
    population,
    run_from,
    runs_on,
    torque,
    when,
)
from chainrule.plot.redundancy import (
    draw_each_joint,
    draw_frame_errors,
    draw_heights,
    draw_places,
    draw_population,
    draw_stability,
)
from chainrule.redundancy.result import Run
from chainrule.redundancy.stability import decay
from chainrule.redundancy.step import Law, Stepper
from chainrule.redundancy.words import masses

#: Figures 5.9 to 5.32: what is drawn, the path, the gain, the steps.
DRAWN: Mapping[str, tuple[str, str, float, int]] = {
    "5.9": ("determinant", "arc", 0.0, COARSE),
    "5.10": ("torque", "arc", 0.0, COARSE),
    "5.11": ("rates", "arc", 0.0, COARSE),
    "5.12": ("determinant", "arc", -2.0, COARSE),
    "5.13": ("determinant", "arc", -0.19, COARSE),
    "5.14": ("torque", "arc", -2.0, COARSE),
    "5.15": ("rates", "arc", -2.0, COARSE),
    "5.16": ("torque", "arc", -0.19, COARSE),
    "5.17": ("rates", "arc", -0.19, COARSE),
    "5.18": ("determinant", "arc", -4.0, FINE),
    "5.19": ("torque", "arc", -4.0, FINE),
    "5.20": ("rates", "arc", -4.0, FINE),
    "5.21": ("determinant", "arc", -7.0, FINE),
    "5.22": ("torque", "arc", -7.0, FINE),
    "5.23": ("rates", "arc", -7.0, FINE),
    "5.24": ("accelerations", "arc", 0.0, FINE),
    "5.25": ("accelerations", "arc", -2.0, FINE),
    "5.26": ("accelerations", "arc", -0.19, FINE),
    "5.27": ("determinant", "ellipse", 0.0, FINE),
    "5.28": ("determinant", "line", 0.0, FINE),
    "5.29": ("torque", "ellipse", 0.0, FINE),
    "5.30": ("torque", "line", 0.0, FINE),
    "5.31": ("rates", "ellipse", 0.0, FINE),
    "5.32": ("rates", "line", 0.0, FINE),
}
#: Figures 5.1 to 5.8: the path and the share of it that is behind.
PLACES: Mapping[str, tuple[str, float]] = {
    "5.1": ("arc", 0.0),
    "5.2": ("arc", 0.5),
    "5.3": ("arc", 1.0),
    "5.4": ("ellipse", 0.0),
    "5.5": ("ellipse", 0.5),
    "5.6": ("line", 0.0),
    "5.7": ("line", 0.5),
    "5.8": ("line", 1.0),
}
_WHERE = {0.0: "beginning", 0.5: "middle", 1.0: "end"}


def draw(name: str) -> Figure:
    """One of the figures 5.1 to 5.32, by its number.

    Raises:
        KeyError: another number.
    """
    if name in PLACES:
        path, share = PLACES[name]
        runs = runs_on(path, 0.0)
        height = each(runs, lambda run: float(run.determinant[round(share * (len(run.t) - 1))]), 2)
        places = f"Figure {name}: the arm at the {_WHERE[share]} of the {path}, λ = 0, det J Jᵀ = {height}"
        return draw_places(_named(runs), [share], places)
    what, path, gain, steps = DRAWN[name]
    runs = runs_on(path, gain, steps)
    start = f"Figure {name}: the {path} with λ = {_sign(gain)}, step {2000.0 / steps:.3g} ms"
    if what == "determinant":
        close = [start for start, run in runs.items() if least(run) < 1e-4]
        near = f"{', '.join(close) if len(close) < len(runs) else ''} near a singularity".strip()
        near = near if close else "away from singularities"
        return draw_heights(_named(runs), f"{start}, {near}: least det J Jᵀ at {each(runs, when, 3)} s")
    peaks = {
        "rates": ("joint rates", "rad/s", lambda run: run.peak_rate),
        "accelerations": ("joint accelerations", "rad/s²", lambda run: run.peak_acceleration),
        "torque": ("torques", "N m", torque),
    }
    words, unit, peak = peaks[what]
    note = f"{masses(the_arm())}, gravity along −z" if what == "torque" else ""
    return draw_each_joint(_named(runs), what, unit, f"{start}: {words} up to {each(runs, peak, 3)} {unit}", note)


def _sign(gain: float) -> str:
    return f"{gain:g}".replace("-", "−")


def _named(runs: Mapping[str, Run]) -> dict[str, Run]:
    return {f"start {name}": run for name, run in runs.items()}


def draw_errors() -> Figure:
    """Errors of n, o, a and p on the arc from A, B and C, without a gain and with one: without feedback, as there."""
    found = {gain: runs_on("arc", gain) for gain in (0.0, -2.0)}
    named = {f"start {name}, λ = {_sign(gain)}": run for gain, runs in found.items() for name, run in runs.items()}
    worst = ", ".join(f"{each(runs, millimetres)} mm with λ = {_sign(gain)}" for gain, runs in found.items())
    return draw_frame_errors(named, f"Without feedback the errors of the steps add up: the tip is off by up to {worst}")


def draw_starts() -> Figure:
    """Random starts on the arc, with and without gain, and the selected ones among them."""
    found = population("arc", MANY)
    w = found.min_manipulability[..., 0]
    marked = {
        start: (run_from(start, 0.0).min_manipulability, run_from(start, -2.0).min_manipulability)
        for start in ON["arc"]
    }
    share = 100.0 * float((w[:, 2] > w[:, 0]).mean())
    title = f"Of {MANY} random starts on the arc {share:.0f} % keep farther from singularities with λ = −2 than without"
    return draw_population(w[:, 0], w[:, 2], ("λ = 0", "λ = −2"), marked, title)


def draw_gains() -> Figure:
    """Which gains go with which steps on the arc from A, and the bound estimated from a run with a small gain."""
    found = gain_map()
    run = run_from("A", -2.0, FINE)
    fastest = float(np.median(decay(Stepper(the_arm(), Law({ROOT: -1.0})), run.q[::20], run.held[::20])))
    worst = np.where(found.diverged[0], np.nan, found.worst_position_error[0])
    order = np.argsort(found.dt)
    return draw_stability(GAINS, found.dt[order], worst[:, order], lost=LOST, bound=-2.0 / (fastest * found.dt[order]))
