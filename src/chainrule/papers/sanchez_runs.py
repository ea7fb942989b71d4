"""Runs of E. A. Sanchez's thesis: what it claims, from the start postures that were found and from random ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.papers import Row, claim
from chainrule.papers.sanchez_paths import ON, PATHS, STARTS, random_starts, the_arm, thesis_arc
from chainrule.redundancy.batch import Batch, track_batch
from chainrule.redundancy.globally import track_globally
from chainrule.redundancy.result import Run
from chainrule.redundancy.track import track
from chainrule.redundancy.words import masses

Array = NDArray[Any]

#: The criterion of equation (4.14) that the thesis' gains are taken to be for, and the other one.
ROOT, INVERSE = "H^(-1/2)", "1/H"
#: Steps in 2 s: the thesis' dt of .0067 s and of .002 s.
COARSE, FINE = 299, 1000
#: Random starts on the arc, and on the other two paths.
MANY, FEWER = 3000, 1000
BEYOND = "beyond the thesis"


@cache
def run_from(start: str, gain: float, steps: int = COARSE, criterion: str = ROOT, feedback: float = 0.0) -> Run:
    """A run of the thesis' law from one of the start postures: Euler, the gain on one of the two criteria."""
    name = next(path for path, starts in ON.items() if start in starts)
    return track(
        the_arm(),
        PATHS[name](),
        STARTS[start],
        gain=gain,
        criterion=criterion,
        integrator="euler",
        dt=2.0 / steps,
        feedback=feedback,
    )


def runs_on(path: str, gain: float, steps: int = COARSE) -> dict[str, Run]:
    """The runs from the start postures on a path, by their names."""
    return {start: run_from(start, gain, steps) for start in ON[path]}


def run_rows(progress: Callable[[str], None] = lambda line: None) -> list[Row]:
    """What the thesis claims of its runs."""
    progress("redundancy: the arc from the start postures")
    found = [*_arc(), *_gains(), *_steps(), *_other_paths()]
    progress("redundancy: whole paths optimised")
    found += _globally()
    progress("redundancy: random starts")
    return found + _random()


# ---- the arc, from the start postures ----------------------------------------------------------------------------


def each(runs: Mapping[str, Run], value: Callable[[Run], float | None], digits: int = 2) -> str:
    """A number of each run, with the run's name: "A 2.7e-06, B 6e-06"."""
    return ", ".join(f"{name} {value(run) or 0.0:.{digits}g}" for name, run in runs.items())


def least(run: Run) -> float:
    """The least det J Jᵀ."""
    return float(run.determinant.min())


def when(run: Run) -> float:
    """When it is least, s."""
    return float(run.t[run.determinant.argmin()])


def torque(run: Run) -> float:
    """The largest torque, N m."""
    return run.peak_torque or 0.0


def millimetres(run: Run) -> float:
    """The worst position error, mm."""
    return 1000.0 * run.worst_position_error


_TRACK = "track(load('sanchez_8r'), papers.sanchez_paths.thesis_arc(), STARTS['A'], gain={gain}, dt=2/{steps})"
_SELECTED = "starts A, B, C were searched for so that this happens"


def _arc() -> list[Row]:
    plain, weak, strong = (runs_on("arc", gain) for gain in (0.0, -0.19, -2.0))
    gained = {name: least(strong[name]) / least(plain[name]) for name in plain}
    slightly = {name: least(weak[name]) / least(plain[name]) for name in plain}
    note = f"the torques rest on {masses(the_arm())} and gravity along -z, which the thesis does not give"
    less = [name for name in plain if torque(strong[name]) < torque(plain[name])]
    more = [name for name in plain if torque(weak[name]) > torque(plain[name])]
    comparable = {name: strong[name].peak_rate / plain[name].peak_rate for name in plain}
    similar = {name: weak[name].peak_rate / plain[name].peak_rate for name in plain}

    def how(gain: str) -> str:
        return _TRACK.format(gain=gain, steps=COARSE)

    return [
        claim(
            "figure 5.9",
            "λ = 0: when det(J Jᵀ) is least on the arc",
            "about 1.28 s, close to 0",
            f"{each(plain, when, 4)} s; least {each(plain, least)}",
            all(abs(when(run) - 1.28) < 0.015 and least(run) < 5e-5 for run in plain.values()),
            how("0"),
            f"{_SELECTED}: it shows that they exist, not that it had to happen",
        ),
        claim(
            "figure 5.9",
            "λ = 0: instability",
            "none, the end effector follows its entire path",
            f"tip within {each(plain, millimetres)} mm",
            all(run.status == "complete" and millimetres(run) < 3.0 for run in plain.values()),
            how("0"),
        ),
        claim(
            "section 4.1",
            "the pseudoinverse alone",
            "does not avoid singularities",
            f"det(J Jᵀ) falls {', '.join(f'{n} {r.determinant[0] / least(r):.0f}' for n, r in plain.items())}-fold",
            all(run.determinant[0] > 100.0 * least(run) for run in plain.values()),
            how("0"),
        ),
        claim(
            "figure 5.12",
            "λ = -2 on the arc",
            "keeps away from the singularity",
            f"least det(J Jᵀ) {each(strong, least)}, {', '.join(f'{n} {g:.0f}' for n, g in gained.items())} times "
            "that of λ = 0",
            all(least(run) > 3e-4 for run in strong.values()) and min(gained.values()) > 10.0,
            how("-2"),
        ),
        claim(
            "figure 5.13",
            "λ = -.19 on the arc",
            "keeps away from the singularity",
            f"weakly: least det(J Jᵀ) {each(weak, least)}, {', '.join(f'{n} {g:.1f}' for n, g in slightly.items())} "
            "times that of λ = 0",
            all(1.0 < ratio < 0.5 * gained[name] for name, ratio in slightly.items()),
            how("-.19"),
            "from A the least is still 70 times smaller than with λ = -2",
            "true under a condition",
        ),
        claim(
            "figure 5.14",
            "largest torque, λ = -2 against λ = 0",
            "a decrease",
            f"from {each(plain, torque)} to {each(strong, torque)} N m",
            len(less) == 3,
            how("-2"),
            note,
        ),
        claim(
            "figure 5.15",
            "largest joint rate, λ = -2 against λ = 0",
            "comparable",
            f"{each(plain, lambda run: run.peak_rate)} and {each(strong, lambda run: run.peak_rate)} rad/s",
            all(1 / 3 < ratio < 3 for ratio in comparable.values()),
            how("-2"),
        ),
        claim(
            "figure 5.16",
            "largest torque, λ = -.19 against λ = 0",
            "an increase",
            f"from {each(plain, torque)} to {each(weak, torque)} N m",
            more == ["A"],
            how("-.19"),
            "from A only: where the near singularity is only put off the joints hurry past it. " + note,
            "true under a condition",
        ),
        claim(
            "figure 5.17",
            "largest joint rate, λ = -.19 against λ = 0",
            "comparable",
            f"{each(plain, lambda run: run.peak_rate)} and {each(weak, lambda run: run.peak_rate)} rad/s",
            all(1 / 4 < ratio < 4 for ratio in similar.values()),
            how("-.19"),
        ),
        _accelerations(),
    ]


def _accelerations() -> Row:
    found = [runs_on("arc", gain, FINE) for gain in (0.0, -2.0, -0.19)]
    peaks = [each(runs, lambda run: run.peak_acceleration) for runs in found]
    calm = all(found[1][name].peak_acceleration < found[0][name].peak_acceleration for name in "ABC")
    return claim(
        "figures 5.24 to 5.26",
        "joint accelerations with λ = 0, -2, -.19",
        "large rates induce large accelerations",
        f"up to {peaks[0]}; {peaks[1]}; {peaks[2]} rad/s²",
        calm,
        "track(..., dt=0.002).peak_acceleration",
        "λ = -2 has the smallest for all three starts, because it stays away from the singularity",
    )


# ---- gains and steps ---------------------------------------------------------------------------------------------


def _gains() -> list[Row]:
    plain = runs_on("arc", 0.0, FINE)
    two, four, seven = (runs_on("arc", gain, FINE) for gain in (-2.0, -4.0, -7.0))
    up = runs_on("arc", 2.0, FINE)
    twenty = runs_on("arc", -20.0)
    other = {start: run_from(start, -20.0, COARSE, INVERSE) for start in "ABC"}
    note = f"the torques rest on {masses(the_arm())}"
    torques = [max(torque(run) for run in runs.values()) for runs in (two, four, seven)]
    return [
        claim(
            "section 5.1.1",
            "λ much below -2 at Δt = .0067",
            "extremely high velocities, the system goes unstable",
            f"λ = -20 follows the arc within {each(twenty, millimetres)} mm, rates up to "
            f"{each(twenty, lambda run: run.peak_rate)} rad/s; with 1/w within {each(other, millimetres)} mm",
            all(millimetres(run) < 20.0 for run in twenty.values()),
            _TRACK.format(gain="-20", steps=COARSE),
            "not with w^(-1/2): the step allows for more than ten times the gain. With 1/w, whose gradient is about "
            "ten times as large, -20 is at the edge",
            "true under a condition",
        ),
        claim(
            "figures 5.18, 5.21",
            "λ = -4 and -7 at Δt = .002",
            "stable",
            f"tip within {each(four, millimetres)} and {each(seven, millimetres)} mm, least det(J Jᵀ) "
            f"{each(four, least)} and {each(seven, least)}",
            all(millimetres(run) < 3.0 for runs in (four, seven) for run in runs.values()),
            _TRACK.format(gain="-4", steps=FINE),
        ),
        claim(
            "figures 5.19, 5.22",
            "torques with λ = -4 and -7",
            "increase dramatically over λ = -.19 and -2",
            f"largest with -2: {each(two, torque)}; -4: {each(four, torque)}; -7: {each(seven, torque)} N m",
            max(torques[1:]) < 3.0 * torques[0],
            _TRACK.format(gain="-7", steps=FINE),
            f"no dramatic rise from any of the three starts; {note}",
            "not reproducible",
        ),
        claim(
            "figures 5.20, 5.23",
            "largest joint rates with λ = -4 and -7",
            "comparable to λ = 0",
            f"{each(plain, lambda run: run.peak_rate)} without; {each(four, lambda run: run.peak_rate)} and "
            f"{each(seven, lambda run: run.peak_rate)} rad/s",
            all(run.peak_rate < 3.0 * plain[name].peak_rate for runs in (four, seven) for name, run in runs.items()),
            _TRACK.format(gain="-7", steps=FINE),
        ),
        claim(
            "section 5.1.1",
            "λ > 0 at Δt = .002",
            "the end effector does not follow its path",
            f"λ = 2 heads for a singularity: least det(J Jᵀ) {each(up, least)}, rates up to "
            f"{each(up, lambda run: run.peak_rate)} rad/s; the tip is off by {each(up, millimetres)} mm, and of 2 s "
            f"{each(up, lambda run: run.t[-1])} s are run",
            all(run.peak_rate > 100.0 and (millimetres(run) > 20.0 or run.status == "stopped") for run in up.values()),
            _TRACK.format(gain="2", steps=FINE),
        ),
    ]


#: Gains and steps of the stability map, from A on the arc.
GAINS = -np.geomspace(0.2, 400.0, 23)
MAP_STEPS = (FINE, 500, COARSE, 200, 100, 50)
#: From this distance on the tip has lost the path, m.
LOST = 0.1


@cache
def gain_map() -> Batch:
    """Runs of the arc from A with many gains and steps."""
    dt = [2.0 / steps for steps in MAP_STEPS]
    return track_batch(the_arm(), thesis_arc(), STARTS["A"], GAINS, dt, criterion=ROOT, feedback=0.0)


def _steps() -> list[Row]:
    found = gain_map()
    lost = found.diverged[0] | ~(found.worst_position_error[0] < LOST)
    last = {
        steps: float(GAINS[int(np.argmax(lost[:, k])) - 1]) for k, steps in enumerate(MAP_STEPS) if lost[:, k].any()
    }
    product = np.array([-gain * 2.0 / steps for steps, gain in last.items()])
    fine = [500, 1000, 2000, 4000]
    halved = track_batch(
        the_arm(), thesis_arc(), STARTS["A"], [0.0, -2.0], [2.0 / n for n in fine], criterion=ROOT, feedback=0.0
    ).final_position_error[0]
    order = np.log2(halved[:, :-1] / halved[:, 1:])[:, -1]
    held = run_from("A", -2.0, feedback=10.0)
    loose = run_from("A", -2.0)
    return [
        claim(
            "section 5.1.1",
            "the larger the gain, the smaller Δt",
            "a stiffer system",
            "from A the path is lost beyond "
            + ", ".join(f"λ = {gain:.3g} at {2000.0 / steps:.3g} ms" for steps, gain in last.items()),
            len(last) >= 3 and float(product.max() / product.min()) < 2.5,
            "track_batch(arm, thesis_arc(), STARTS['A'], gains, dt, feedback=0)",
            f"|λ| Δt stays below {product.min():.2g} to {product.max():.2g} s, as the bound 2 / (Δt ρ) of an explicit "
            "step says",
        ),
        claim(
            "sections 3.4, 5",
            "error of Euler's method",
            "a smaller step makes it as small as desired; O(Δt²) in a step",
            f"order {order[0]:.2f} with λ = 0 and {order[1]:.2f} with λ = -2, at the end of the arc",
            bool(np.abs(order - 1.0).max() < 0.1),
            "track_batch(arm, thesis_arc(), STARTS['A'], [0, -2], dt, feedback=0).final_position_error",
            "O(Δt²) in each step adds up to first order over the path",
        ),
        claim(
            BEYOND,
            "final position error, λ = -2 from A, Δt = .0067",
            "no feedback",
            f"{1000 * loose.final_position_error:.2g} mm without feedback, {1000 * held.final_position_error:.2g} mm "
            "with 10 1/s",
            held.final_position_error < 0.1 * loose.final_position_error,
            "track(..., feedback=10)",
            "the errors of the steps add up unless they are fed back",
            "agrees",
        ),
    ]


# ---- the other two paths -----------------------------------------------------------------------------------------


def _other_paths() -> list[Row]:
    ellipse = {gain: run_from("E", gain, FINE) for gain in (0.0, -0.3, -0.8)}
    line = {gain: run_from("L", gain, FINE) for gain in (0.0, -0.61, -6.1)}
    rates = [f"{run.peak_rate:.3g}" for run in line.values()]
    searched = "the start was searched for so that this happens"
    return [
        *(
            claim(
                figure,
                f"λ = 0: least det(J Jᵀ) on the {name}",
                "close to 0",
                f"{least(run):.2g} at {when(run):.3g} s, from {run.determinant[0]:.2g}",
                least(run) < 0.02 * run.determinant[0],
                f"track(arm, papers.sanchez_paths.thesis_{name}(), STARTS['{start}'], gain=0, dt=0.002)",
                searched,
            )
            for figure, name, start, run in (
                ("figure 5.27", "ellipse", "E", ellipse[0.0]),
                ("figure 5.28", "line", "L", line[0.0]),
            )
        ),
        claim(
            "section 5.1.1",
            "λ = -.3 and -.8 on the ellipse",
            "similar results",
            f"least det(J Jᵀ) {', '.join(f'{least(run):.2g}' for run in ellipse.values())} with λ = 0, -.3, -.8",
            least(ellipse[0.0]) < least(ellipse[-0.3]) < least(ellipse[-0.8]),
            "track(arm, papers.sanchez_paths.thesis_ellipse(), STARTS['E'], gain=-.8, dt=0.002)",
        ),
        claim(
            "section 5.1.1",
            "λ = -.61 and -6.1 on the line",
            "similar results",
            f"least det(J Jᵀ) {', '.join(f'{least(run):.2g}' for run in line.values())} with λ = 0, -.61, -6.1, and "
            f"rates up to {', '.join(rates)} rad/s",
            least(line[-6.1]) > 3.0 * least(line[0.0]) and line[-6.1].peak_rate > 5.0 * line[0.0].peak_rate,
            "track(arm, papers.sanchez_paths.thesis_line(), STARTS['L'], gain=-6.1, dt=0.002)",
            "the determinant is larger, but the joints would have to run through their turns: a local law fails here. "
            "Which gain the thesis means is not clear: its list of figures has -.61 once and -6.1 elsewhere",
            "true under a condition",
        ),
    ]


# ---- whole paths -------------------------------------------------------------------------------------------------


def _globally() -> list[Row]:
    """Whole paths optimised, beginning with what the local law does."""
    found = {}
    for path, start in (("arc", "A"), ("line", "L")):
        local = track(the_arm(), PATHS[path](), STARTS[start], gain=-2.0, criterion=ROOT, integrator="rk4", dt=0.02)
        found[path] = local, track_globally(the_arm(), PATHS[path](), local.q, dt=0.02, count=0)
    (arc, best), (line, through) = found.values()
    between = through.between
    off = float("inf") if between is None else between.position
    how = "track_globally(arm, thesis_{path}(), track(..., integrator='rk4', dt=0.02).q, dt=0.02, count=0)"
    return [
        claim(
            "section 1.1",
            "a global method against a local one, on the arc from A",
            "better, at a higher cost",
            f"least w {best.value:.3g} and rates up to {best.run.peak_rate:.3g} rad/s; with λ = -2 "
            f"{arc.min_manipulability:.3g} and {arc.peak_rate:.3g} rad/s",
            best.solved and best.value > 1.2 * arc.min_manipulability and best.run.peak_rate < arc.peak_rate,
            how.format(path="arc"),
            "all postures of the path at once (IPOPT): a local optimum, at about a thousand times the cost",
        ),
        claim(
            BEYOND,
            "the line from L, where the local law fails",
            "not treated",
            f"followed with rates up to {through.run.peak_rate:.3g} rad/s, least w {through.value:.2g}; the local law "
            f"with λ = -2: {line.peak_rate:.3g} rad/s, off by up to {millimetres(line):.2g} mm",
            through.solved and through.run.peak_rate < 10.0 < line.peak_rate and off < 2e-3,
            how.format(path="line"),
            f"at the samples the tip is on the line, between them within {1000.0 * off:.2g} mm",
            "agrees",
        ),
    ]


# ---- random starts -----------------------------------------------------------------------------------------------


@cache
def population(path: str, count: int) -> Batch:
    """Runs from random starts on a path, with gains 0, -.19 and -2."""
    return track_batch(
        the_arm(),
        PATHS[path](),
        random_starts(path, count),
        [0.0, -0.19, -2.0],
        2.0 / COARSE,
        criterion=ROOT,
        feedback=0.0,
    )


def _shares(path: str, count: int) -> tuple[Array, Array, Array]:
    """Of gains -.19 and -2 the shares that keep farther away, that need lower rates; of all three, that get lost."""
    found = population(path, count)
    w, peak = found.min_manipulability[..., 0], found.peak_rate[..., 0]
    lost = found.diverged[..., 0] | ~(found.worst_position_error[..., 0] < LOST)
    farther = ((w[:, 1:] > w[:, :1]) & ~lost[:, 1:]).mean(axis=0)
    slower = ((peak[:, 1:] < peak[:, :1]) & ~lost[:, 1:]).mean(axis=0)
    return farther, slower, lost.mean(axis=0)


def _random() -> list[Row]:
    farther, slower, lost = _shares("arc", MANY)
    how = f"track_batch(arm, thesis_arc(), random_starts('arc', {MANY}), [0, -.19, -2], dt=2/{COARSE}, feedback=0)"
    found = population("arc", MANY)
    near = float((found.min_manipulability[:, 0, 0] ** 2 < 5e-5).mean())
    found_rows = [
        claim(
            "figure 5.9",
            f"λ = 0 from {MANY} random starts",
            "close to a singularity",
            f"det(J Jᵀ) falls below 5e-5, as from A, B and C, in {100 * near:.0f} %",
            0.0 < near < 0.5,
            how,
            "starts that nobody selected, each holding its own orientation; most never come so near",
            "true under a condition",
        ),
        claim(
            "figure 5.12",
            f"λ = -2 from {MANY} random starts on the arc",
            "singularity avoidance occurs and is expected",
            f"{100 * farther[1]:.0f} % keep farther away than with λ = 0, {100 * slower[1]:.0f} % need lower rates, "
            f"{100 * lost[2]:.1f} % lose the path",
            0.6 < farther[1] < 0.95 and slower[1] < 0.5,
            how,
            "what the selected starts A, B, C show holds for most starts, not for all: a local law may climb to a "
            "place from which the path leads nearer to a singularity",
            "true under a condition",
        ),
        claim(
            "figure 5.13",
            f"λ = -.19 from {MANY} random starts on the arc",
            "singularity avoidance occurs and is expected",
            f"{100 * farther[0]:.0f} % keep farther away, {100 * slower[0]:.0f} % need lower rates",
            0.6 < farther[0] < 0.95 and slower[0] > slower[1],
            how,
            "less is gained by each than with λ = -2, but the joints move less for it",
            "true under a condition",
        ),
    ]
    for path in ("ellipse", "line"):
        farther, slower, lost = _shares(path, FEWER)
        found_rows.append(
            claim(
                "section 5.1.1",
                f"λ = -2 from {FEWER} random starts on the {path}",
                "similar results",
                f"{100 * farther[1]:.0f} % keep farther away and stay on the path; {100 * lost[0]:.0f} % lose it with "
                f"λ = 0, {100 * lost[2]:.0f} % with λ = -2",
                lost[2] > 0.1,
                f"track_batch(arm, thesis_{path}(), random_starts('{path}', {FEWER}), [0, -2], ...)",
                f"lost: the tip off by {LOST} m or a rate above half a turn in a step. The {path} asks for more than "
                "the arc does",
                "true under a condition",
            )
        )
    return found_rows
