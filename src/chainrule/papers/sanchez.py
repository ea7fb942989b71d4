"""E. A. Sanchez's thesis: gradient projection on an 8R arm, what it claims, and figures 5.1 to 5.32.

The thesis' values are typed here as it prints them; ours come from public functions. It does not say where its arm
starts, what its links weigh, or how gravity acts. The start postures here were searched for: without a gain they meet a
singularity where the thesis' arm does. They prove that such starts exist, and nothing about others; random starts stand
beside them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, load, planar
from chainrule.papers import Row, Verdict
from chainrule.redundancy.batch import Batch, track_batch
from chainrule.redundancy.globally import track_globally
from chainrule.redundancy.result import Run
from chainrule.redundancy.step import Law, Stepper
from chainrule.redundancy.task_path import TaskPath
from chainrule.redundancy.track import track
from chainrule.redundancy.words import masses

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]

#: The start postures that were found, rad: A, B, C on the arc, E on the "ellipse", L on the line.
STARTS: Mapping[str, tuple[float, ...]] = {
    "A": (
        *(-1.873731004463, -1.816784929574, -2.610767475187, 2.197077859614),
        *(-1.287777812569, 1.434014115789, 1.595985198549, -2.679241147511),
    ),
    "B": (
        *(1.609813802256, -0.232299026129, -2.186365553699, -0.941491016391),
        *(0.461419321006, 0.278709676276, 2.319829892885, -1.050383487685),
    ),
    "C": (
        *(-1.53668959001, -2.920792707402, 3.022548791608, -1.664516093498),
        *(-0.927860291821, -1.06738746154, 0.87794418847, -1.607968946038),
    ),
    "E": (
        *(0.356683909626, -0.678181398008, 2.920983371925, -2.897123090552),
        *(-0.419316528329, -0.004363446089, -0.777582490943, -2.014754810326),
    ),
    "L": (
        *(2.347162607434, 0.690084145544, 0.108517563932, -2.403259386128),
        *(-3.111707060913, 0.311795321069, -0.359757615609, -2.250603423303),
    ),
}
#: The criterion of equation (4.14) that the thesis' gains are taken to be for, and the other one.
ROOT, INVERSE = "H^(-1/2)", "1/H"
#: Steps in 2 s: the thesis' dt of .0067 s and of .002 s.
COARSE, FINE = 299, 1000
#: Random starts on the arc, and on the other two paths.
MANY, FEWER = 3000, 1000


# ---- the thesis' paths -------------------------------------------------------------------------------------------


def thesis_arc() -> TaskPath:
    """The arc of table 5.1: half a circle in the plane y = 0.05 m, in 2 s; the start posture's orientation is held.

    Example:
        >>> thesis_arc().sample([0.0, 1.0, 2.0], "position").held.round(12).tolist()
        [[0.25, 0.05, -0.25], [0.0, 0.05, 0.0], [-0.25, 0.05, -0.25]]
    """
    return TaskPath.arc((0.0, 0.05, -0.25), 0.25, y=(0.0, 0.0, 1.0), duration=2.0)


def thesis_ellipse() -> TaskPath:
    """The ellipse of table 5.1, which is a circle: once round in 2 s.

    Example:
        >>> thesis_ellipse().sample([0.0], "position").held.round(12).tolist()
        [[0.4, 0.6, -0.25]]
    """
    return TaskPath.circle((0.1, 0.6, -0.25), 0.3, y=(0.0, 0.0, 1.0), duration=2.0)


def thesis_line() -> TaskPath:
    """The line of table 5.1, in 2 s.

    Example:
        >>> thesis_line().sample([2.0], "position").held.tolist()
        [[0.5, 0.2, 0.5]]
    """
    return TaskPath.line((-0.5, 0.2, -0.5), (0.5, 0.2, 0.5), duration=2.0)


#: The thesis' paths, and the start postures that were found on each.
PATHS: Mapping[str, Callable[[], TaskPath]] = {"arc": thesis_arc, "ellipse": thesis_ellipse, "line": thesis_line}
ON: Mapping[str, str] = {"arc": "ABC", "ellipse": "E", "line": "L"}


@cache
def _arm() -> Arm:
    return load("sanchez_8r")


@cache
def _run(start: str, gain: float, steps: int = COARSE, criterion: str = ROOT, feedback: float = 0.0) -> Run:
    """A run of the thesis' law from one of the start postures: Euler, the gain on one of the two criteria."""
    name = next(path for path, starts in ON.items() if start in starts)
    return track(
        _arm(),
        PATHS[name](),
        STARTS[start],
        gain=gain,
        criterion=criterion,
        integrator="euler",
        dt=2.0 / steps,
        feedback=feedback,
    )


def _runs(path: str, gain: float, steps: int = COARSE) -> dict[str, Run]:
    return {start: _run(start, gain, steps) for start in ON[path]}


# ---- rows --------------------------------------------------------------------------------------------------------


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """The arm, the theory, the paths, and what the thesis claims of its runs."""
    progress("redundancy: the arm and the theory")
    found = [*_arm_rows(), *_theory(), *_law(), *_paths()]
    progress("redundancy: the arc from the start postures")
    found += [*_arc(), *_gains(), *_steps(), *_other_paths()]
    progress("redundancy: whole paths optimised")
    found += _globally()
    progress("redundancy: random starts")
    return tuple(found + _random())


def _claim(
    where: str, what: str, paper: str, ours: str, true: bool, how: str, note: str = "", verdict: Verdict = "agrees"
) -> Row:
    """A statement of the thesis: ``verdict`` where ours bears out what we say of it, else a disagreement."""
    return Row(where, what, paper, ours, None, verdict if true else "DISAGREES", how, note)


#: Table 2.1: twist before the joint (deg), a (cm) and d (cm) of each row; the last is the tool's.
_TABLE = ((-90, 0, 0), (-90, 0, 0), (90, 25, 20), (90, 0, 0), (-90, 0, 0), (-90, 20, 0), (0, 20, 0), (-90, 0, 0))
_TOOL_CM = 12.5


def _printed_pose(q: Array) -> Array:
    """Equations (2.3) and (2.4), as printed, with table 2.1."""
    pose = np.eye(4)
    for (alpha, a, d), angle in zip((*_TABLE, (0, 0, _TOOL_CM)), (*q, 0.0), strict=True):
        ca, sa = math.cos(math.radians(alpha)), math.sin(math.radians(alpha))
        c, s = math.cos(angle), math.sin(angle)
        pose = pose @ [
            [c, -s, 0.0, a / 100.0],
            [s * ca, c * ca, -sa, -sa * d / 100.0],
            [s * sa, c * sa, ca, ca * d / 100.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    return pose


def _random_postures(count: int) -> Array:
    return np.random.default_rng(0).uniform(-math.pi, math.pi, (count, _arm().n))


def _arm_rows() -> list[Row]:
    arm, q = _arm(), _random_postures(50)
    off = max(float(np.abs(arm.pose(each) - _printed_pose(each)).max()) for each in q)
    shape = arm.jacobian(q[0]).shape
    return [
        _claim(
            "table 2.1, (2.3)",
            "the tool's frame",
            "the product of the rows' transformations",
            f"the same, to {off:.1g} m",
            off < 1e-14,
            "load('sanchez_8r').pose(q)",
            "where the scan has 'nil' for the twists it is pi/2; lengths in cm here",
        ),
        _claim(
            "(2.5), (2.10)",
            "size of the Jacobian, and of the Cartesian velocity",
            "m x m, and 8 x 1",
            f"m x n: {shape[0]} x {shape[1]}, and {shape[0]} x 1",
            shape == (6, 8),
            "load('sanchez_8r').jacobian(q).shape",
            "elsewhere the thesis has 6 x 8 too",
            "corrected",
        ),
    ]


# ---- theory ------------------------------------------------------------------------------------------------------


def _theory() -> list[Row]:
    arm, q = _arm(), _random_postures(200)
    jacobian = arm.jacobian(q)
    v = np.random.default_rng(1).normal(size=(200, 6))
    still = Stepper(arm, Law())
    rates = still(q, arm.pose(q), v, 0.0).rates
    least = np.einsum("bij,bj->bi", np.linalg.pinv(jacobian), v)
    off = float((np.abs(rates - least).max(axis=1) / np.abs(least).max(axis=1)).max())
    at_zero = arm.jacobian(np.zeros(8))
    u, s, _ = np.linalg.svd(at_zero)
    rank = int((s > 1e-12).sum())
    inside, outside = at_zero @ np.ones(8), u[:, -1]
    missed = [float(np.linalg.norm(at_zero @ np.linalg.lstsq(at_zero, w)[0] - w)) for w in (inside, outside)]
    return [
        _claim(
            "(2.20)",
            "Jᵀ (J Jᵀ)⁻¹ v",
            "the smallest rates with J q' = v",
            f"the same rates as ours, to {off:.1g} of them, in 200 postures",
            off < 1e-10,
            "Stepper(arm, Law())(q, arm.pose(q), v, dt).rates",
            "ours come from a factorisation of the rows of J instead, which keeps twice the digits near a singularity",
        ),
        _claim(
            "(3.3)",
            "dim R(J) + dim N(J)",
            "n, also where J loses rank",
            f"{rank} + {8 - rank} = 8 at q = 0, which is singular",
            rank == 5,
            "arm.jacobian(np.zeros(8))",
        ),
        _claim(
            "section 3.2.1",
            "v in R(J) at a singularity",
            "no solution, and two lines below: solutions",
            f"a solution for v in R(J) (misses by {missed[0]:.1g}), none for another v (by {missed[1]:.2g})",
            missed[0] < 1e-12 and missed[1] > 0.99,
            "numpy.linalg.lstsq(arm.jacobian(np.zeros(8)), v)",
            "the first of the two sentences means v NOT in R(J)",
            "corrected",
        ),
        _bytes(),
        _slides(),
        _statics(),
    ]


def _bytes() -> Row:
    sizes = [np.dtype(kind).itemsize for kind in (np.float32, np.float64)]
    return _claim(
        "section 3.4",
        "bytes of a single and of a double",
        "8 and 16",
        f"{sizes[0]} and {sizes[1]}",
        sizes == [4, 8],
        "numpy.dtype('float32').itemsize",
        "16 is about the number of digits of a double",
        "corrected",
    )


def _slides() -> Row:
    jacobian = planar("PRR", [0.2, 0.35, 0.25]).jacobian([0.1, 0.7, -0.9], task="position")
    v = np.array([0.3, -0.2])
    off = float(np.abs(jacobian @ (jacobian.T @ np.linalg.solve(jacobian @ jacobian.T, v)) - v).max())
    return _claim(
        "section 4.1",
        "the pseudoinverse",
        "only for arms whose joints are all of one type",
        f"J q' = v to {off:.1g} for a slide and two revolute joints",
        off < 1e-14,
        "planar('PRR', [0.2, 0.35, 0.25]).jacobian(q, task='position')",
        "it solves J q' = v for any joints; what depends on the choice of units is which solution counts as smallest",
        "corrected",
    )


def _statics() -> Row:
    arm, q, still = _arm(), np.array(STARTS["A"]), np.zeros(8)
    force = np.array([3.0, -2.0, 5.0, 0.4, 0.1, -0.3])
    held = arm.inverse_dynamics(q, still, still, gravity=(0.0, 0.0, 0.0), wrench=force)
    off = float(np.abs(held - arm.jacobian(q).T @ force).max())
    moving = _run("A", 0.0).peak_torque or 0.0
    return _claim(
        "(2.23)",
        "tau = Jᵀ f",
        "the joint torques, in section 5 the Newton-Euler algorithm",
        f"at rest and without weight Newton-Euler gives Jᵀ f, to {off:.1g} N m; on the arc, with f = 0, "
        f"{moving:.3g} N m",
        off < 1e-13 and moving > 1.0,
        "arm.inverse_dynamics(q, 0, 0, gravity=(0, 0, 0), wrench=f)",
        f"it is statics: motion and weight need inertia. Ours rests on {masses(arm)}",
        "special case",
    )


# ---- the law -----------------------------------------------------------------------------------------------------


def _law() -> list[Row]:
    arm, q = _arm(), _random_postures(500)
    jacobian, height = arm.jacobian(q), arm.manipulability(q)
    up = arm.manipulability_gradient(q)  # of w
    gradient = -0.5 * height[:, None] ** -1.5 * up  # of w^(-1/2)
    inverse = np.linalg.pinv(jacobian)
    projected = gradient - np.einsum("bij,bj->bi", inverse, np.einsum("bij,bj->bi", jacobian, gradient))
    descent = -np.einsum("bi,bi->b", gradient, projected)  # H' along (4.9), v = 0
    moved = {gain: Stepper(arm, Law({ROOT: gain}))(q, arm.pose(q), None, 0.0).rates for gain in (-1.0, 1.0)}  # (4.11)
    change = {gain: np.einsum("bi,bi->b", gradient, rates) for gain, rates in moved.items()}
    same = float((np.abs(moved[-1.0] + projected).max(axis=1) / np.abs(projected).max(axis=1)).max())
    task = np.einsum("bij,bj->bi", jacobian, moved[-1.0])
    rest = float((np.abs(task).max(axis=1) / np.abs(moved[-1.0]).max(axis=1)).max())
    shapes = inverse[0].shape, jacobian[0].T.shape
    other = -(height[:, None] ** -2) * up  # of 1/w
    scaled = 2.0 * height[:, None] ** -0.5 * gradient
    ratio = float((np.abs(other - scaled).max(axis=1) / np.abs(other).max(axis=1)).max())
    along = _run("A", -2.0).manipulability ** -0.5 * 2.0
    return [
        _claim(
            "(4.9)",
            "q' = J* v + (J* J - I) ∇H",
            "improves H where it is to be small",
            f"H falls in {int((descent <= 0.0).sum())} of 500 postures",
            bool((descent <= 0.0).all()),
            "arm.manipulability_gradient(q)",
        ),
        _claim(
            "(4.10), (4.11)",
            "λ = -1 in (4.10) gives (4.11)",
            "q' = J* v + λ (I - J* J) ∇H",
            f"the same motion has λ = 1 in (4.10) and λ = -1 in (4.11), to {same:.1g}",
            same < 1e-9,
            "Stepper(arm, Law({'H^(-1/2)': -1}))",
            "the step from one to the other flips the sign of λ; with (4.11), which the thesis uses, negative gains "
            "lower H",
            "corrected",
        ),
        _claim(
            "after (4.11)",
            "the projection",
            "(I - J* Jᵀ)",
            f"I - J* J; J* is {shapes[0][0]} x {shapes[0][1]} and Jᵀ {shapes[1][0]} x {shapes[1][1]}: no product",
            shapes[0][1] != shapes[1][0],
            "numpy.linalg.pinv(arm.jacobian(q)).shape",
            "",
            "corrected",
        ),
        _claim(
            "section 4.2.1",
            "sign of λ",
            "negative: H is minimised; positive: maximised",
            f"H falls in {int((change[-1.0] <= 0).sum())} and grows in {int((change[1.0] >= 0).sum())} of 500 postures",
            bool((change[-1.0] <= 0.0).all() and (change[1.0] >= 0.0).all()),
            "Stepper(arm, Law({'H^(-1/2)': -1}))",
            "H is the criterion of (4.14) here, which is large near singularities: negative gains keep away from them",
        ),
        _claim(
            "section 4.2",
            "the gradient's part of q'",
            "does not influence the end effector",
            f"J q' = 0 to {rest:.1g} of q'; a step of Euler moves the tip with the square of dt: {_drift():.2f}-fold "
            "where dt is halved",
            rest < 1e-9 and abs(_drift() - 0.25) < 0.01,
            "Stepper(arm, Law({'H^(-1/2)': -2}))(q, arm.pose(q), None, dt).q_next",
            "true of the rates; after a step of finite length the tip is off, which feedback takes back",
            "special case",
        ),
        _claim(
            "(4.14)",
            "the criterion",
            "1/w, or w^(-1/2); both are called H1",
            f"∇(1/w) = 2 w^(-1/2) ∇(w^(-1/2)) to {ratio:.1g}; on the arc from A the factor is {along.min():.3g} to "
            f"{along.max():.3g}",
            ratio < 1e-12,
            "arm.manipulability_gradient(q)",
            "they need different gains. What follows is for w^(-1/2), which section 5 names, unless it says otherwise",
            "refined",
        ),
    ]


def _drift() -> float:
    """How much less the tip has moved where a step along the null space is half as long."""
    arm, q = _arm(), np.array(STARTS["A"])
    stepper = Stepper(arm, Law({ROOT: -2.0}))
    far = [
        float(np.linalg.norm(arm.position(stepper(q, arm.pose(q), None, dt).q_next) - arm.position(q)))
        for dt in (1e-3, 5e-4)
    ]
    return far[1] / far[0]


# ---- the paths ---------------------------------------------------------------------------------------------------


def _paths() -> list[Row]:
    arm = _arm()
    first = {name: PATHS[name]().sample([0.0], "position").held[0] for name in PATHS}
    off = max(
        float(np.abs(arm.position(STARTS[start]) - first[name]).max())
        for name, starts in ON.items()
        for start in starts
    )
    theta = np.linspace(0.0, math.pi, 50)
    t = np.linspace(0.0, 2.0, 50)
    tables = {
        "arc": 0.5 * math.pi * 0.25 * np.stack([-np.sin(theta), 0.0 * theta, np.cos(theta)], axis=1),
        "ellipse": 0.5 * 2.0 * math.pi * 0.3 * np.stack([-np.sin(2 * theta), 0.0 * theta, np.cos(2 * theta)], axis=1),
        "line": np.tile([0.5, 0.0, 0.5], (50, 1)),
    }
    velocity = max(
        float(np.abs(PATHS[name]().sample(t, "position").velocity - printed).max()) for name, printed in tables.items()
    )
    round_ = PATHS["ellipse"]().sample(t, "position").held - (0.1, 0.6, -0.25)
    spread = float(np.ptp(np.linalg.norm(round_, axis=1)))
    across = max(float(np.ptp(PATHS[name]().sample(t, "position").held[:, 1])) for name in PATHS)
    return [
        _claim(
            "table 5.1",
            "unit of the positions",
            "cm",
            f"m: the arm reaches the three first points, in postures A to L to {off:.1g} m",
            off < 1e-10,
            "load('sanchez_8r').position(q)",
            "in cm the paths would lie within 1 cm of the base; the links of table 2.1 are in cm indeed",
            "corrected",
        ),
        _claim(
            "table 5.1",
            "py",
            "0, with pyo = .05, .6, .2 above",
            f"y = pyo all along; it changes by {across:.1g}",
            across < 1e-15,
            "papers.sanchez.thesis_arc().sample(t)",
            "taken so because pyo would have no use otherwise and vy is 0",
            "corrected",
        ),
        _claim(
            "table 5.1",
            "the ellipse",
            "an ellipse",
            f"a circle: its radius varies by {spread:.1g} m",
            spread < 1e-14,
            "papers.sanchez.thesis_ellipse().sample(t)",
            "both semi-axes are rad = 0.3",
            "corrected",
        ),
        _claim(
            "table 5.1",
            "velocity of the tip",
            "vt = [vx, vy, vz] / 2",
            f"the same, to {velocity:.1g} m/s",
            velocity < 1e-14,
            "papers.sanchez.PATHS[name]().sample(t).velocity",
            "the table repeats vx, vy, xz; vz is meant",
        ),
        _claim(
            "section 5.1.1",
            "Δt",
            "0.0067 s, with angles of π/1000 in table 5.1",
            f"{COARSE} steps of {2.0 / COARSE:.6f} s; π/1000 belongs to Δt = {2.0 / FINE:g} s",
            round(2.0 / COARSE, 4) == 0.0067 and 2.0 / FINE == 0.002,
            "track(arm, path, q, dt=2 / 299)",
            "2 s are not a whole number of steps of 0.0067 s",
            "refined",
        ),
    ]


# ---- the arc, from the start postures ----------------------------------------------------------------------------


def _each(runs: Mapping[str, Run], value: Callable[[Run], float | None], digits: int = 2) -> str:
    """A number of each run, with the run's name: "A 2.7e-06, B 6e-06"."""
    return ", ".join(f"{name} {value(run) or 0.0:.{digits}g}" for name, run in runs.items())


def _least(run: Run) -> float:
    return float(run.determinant.min())


def _when(run: Run) -> float:
    return float(run.t[run.determinant.argmin()])


def _torque(run: Run) -> float:
    return run.peak_torque or 0.0


def _millimetres(run: Run) -> float:
    return 1000.0 * run.worst_position_error


_TRACK = "track(load('sanchez_8r'), papers.sanchez.thesis_arc(), STARTS['A'], gain={gain}, dt=2/{steps})"
_SELECTED = "starts A, B, C were searched for so that this happens"


def _arc() -> list[Row]:
    plain, weak, strong = (_runs("arc", gain) for gain in (0.0, -0.19, -2.0))
    gained = {name: _least(strong[name]) / _least(plain[name]) for name in plain}
    slightly = {name: _least(weak[name]) / _least(plain[name]) for name in plain}
    note = f"the torques rest on {masses(_arm())} and gravity along -z, which the thesis does not give"
    less = [name for name in plain if _torque(strong[name]) < _torque(plain[name])]
    more = [name for name in plain if _torque(weak[name]) > _torque(plain[name])]
    comparable = {name: strong[name].peak_rate / plain[name].peak_rate for name in plain}
    similar = {name: weak[name].peak_rate / plain[name].peak_rate for name in plain}

    def how(gain: str) -> str:
        return _TRACK.format(gain=gain, steps=COARSE)

    return [
        _claim(
            "figure 5.9",
            "λ = 0: when det(J Jᵀ) is least on the arc",
            "about 1.28 s, close to 0",
            f"{_each(plain, _when, 4)} s; least {_each(plain, _least)}",
            all(abs(_when(run) - 1.28) < 0.015 and _least(run) < 5e-5 for run in plain.values()),
            how("0"),
            f"{_SELECTED}: it shows that they exist, not that it had to happen",
        ),
        _claim(
            "figure 5.9",
            "λ = 0: instability",
            "none, the end effector follows its entire path",
            f"tip within {_each(plain, _millimetres)} mm",
            all(run.status == "complete" and _millimetres(run) < 3.0 for run in plain.values()),
            how("0"),
        ),
        _claim(
            "section 4.1",
            "the pseudoinverse alone",
            "does not avoid singularities",
            f"det(J Jᵀ) falls {', '.join(f'{n} {r.determinant[0] / _least(r):.0f}' for n, r in plain.items())}-fold",
            all(run.determinant[0] > 100.0 * _least(run) for run in plain.values()),
            how("0"),
        ),
        _claim(
            "figure 5.12",
            "λ = -2 on the arc",
            "keeps away from the singularity",
            f"least det(J Jᵀ) {_each(strong, _least)}, {', '.join(f'{n} {g:.0f}' for n, g in gained.items())} times "
            "that of λ = 0",
            all(_least(run) > 3e-4 for run in strong.values()) and min(gained.values()) > 10.0,
            how("-2"),
        ),
        _claim(
            "figure 5.13",
            "λ = -.19 on the arc",
            "keeps away from the singularity",
            f"weakly: least det(J Jᵀ) {_each(weak, _least)}, {', '.join(f'{n} {g:.1f}' for n, g in slightly.items())} "
            "times that of λ = 0",
            all(1.0 < ratio < 0.5 * gained[name] for name, ratio in slightly.items()),
            how("-.19"),
            "from A the least is still 70 times smaller than with λ = -2",
            "special case",
        ),
        _claim(
            "figure 5.14",
            "largest torque, λ = -2 against λ = 0",
            "a decrease",
            f"from {_each(plain, _torque)} to {_each(strong, _torque)} N m",
            len(less) == 3,
            how("-2"),
            note,
        ),
        _claim(
            "figure 5.15",
            "largest joint rate, λ = -2 against λ = 0",
            "comparable",
            f"{_each(plain, lambda run: run.peak_rate)} and {_each(strong, lambda run: run.peak_rate)} rad/s",
            all(1 / 3 < ratio < 3 for ratio in comparable.values()),
            how("-2"),
        ),
        _claim(
            "figure 5.16",
            "largest torque, λ = -.19 against λ = 0",
            "an increase",
            f"from {_each(plain, _torque)} to {_each(weak, _torque)} N m",
            more == ["A"],
            how("-.19"),
            "from A only: where the near singularity is only put off the joints hurry past it. " + note,
            "special case",
        ),
        _claim(
            "figure 5.17",
            "largest joint rate, λ = -.19 against λ = 0",
            "comparable",
            f"{_each(plain, lambda run: run.peak_rate)} and {_each(weak, lambda run: run.peak_rate)} rad/s",
            all(1 / 4 < ratio < 4 for ratio in similar.values()),
            how("-.19"),
        ),
        _accelerations(),
    ]


def _accelerations() -> Row:
    found = [_runs("arc", gain, FINE) for gain in (0.0, -2.0, -0.19)]
    peaks = [_each(runs, lambda run: run.peak_acceleration) for runs in found]
    calm = all(found[1][name].peak_acceleration < found[0][name].peak_acceleration for name in "ABC")
    return _claim(
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
    plain = _runs("arc", 0.0, FINE)
    two, four, seven = (_runs("arc", gain, FINE) for gain in (-2.0, -4.0, -7.0))
    up = _runs("arc", 2.0, FINE)
    twenty = _runs("arc", -20.0)
    other = {start: _run(start, -20.0, COARSE, INVERSE) for start in "ABC"}
    note = f"the torques rest on {masses(_arm())}"
    torques = [max(_torque(run) for run in runs.values()) for runs in (two, four, seven)]
    return [
        _claim(
            "section 5.1.1",
            "λ much below -2 at Δt = .0067",
            "extremely high velocities, the system goes unstable",
            f"λ = -20 follows the arc within {_each(twenty, _millimetres)} mm, rates up to "
            f"{_each(twenty, lambda run: run.peak_rate)} rad/s; with 1/w within {_each(other, _millimetres)} mm",
            all(_millimetres(run) < 20.0 for run in twenty.values()),
            _TRACK.format(gain="-20", steps=COARSE),
            "not with w^(-1/2): the step allows for more than ten times the gain. With 1/w, whose gradient is about "
            "ten times as large, -20 is at the edge",
            "corrected",
        ),
        _claim(
            "figures 5.18, 5.21",
            "λ = -4 and -7 at Δt = .002",
            "stable",
            f"tip within {_each(four, _millimetres)} and {_each(seven, _millimetres)} mm, least det(J Jᵀ) "
            f"{_each(four, _least)} and {_each(seven, _least)}",
            all(_millimetres(run) < 3.0 for runs in (four, seven) for run in runs.values()),
            _TRACK.format(gain="-4", steps=FINE),
        ),
        _claim(
            "figures 5.19, 5.22",
            "torques with λ = -4 and -7",
            "increase dramatically over λ = -.19 and -2",
            f"largest with -2: {_each(two, _torque)}; -4: {_each(four, _torque)}; -7: {_each(seven, _torque)} N m",
            max(torques[1:]) < 3.0 * torques[0],
            _TRACK.format(gain="-7", steps=FINE),
            f"no dramatic rise from any of the three starts; {note}",
            "corrected",
        ),
        _claim(
            "figures 5.20, 5.23",
            "largest joint rates with λ = -4 and -7",
            "comparable to λ = 0",
            f"{_each(plain, lambda run: run.peak_rate)} without; {_each(four, lambda run: run.peak_rate)} and "
            f"{_each(seven, lambda run: run.peak_rate)} rad/s",
            all(run.peak_rate < 3.0 * plain[name].peak_rate for runs in (four, seven) for name, run in runs.items()),
            _TRACK.format(gain="-7", steps=FINE),
        ),
        _claim(
            "section 5.1.1",
            "λ > 0 at Δt = .002",
            "the end effector does not follow its path",
            f"λ = 2 heads for a singularity: least det(J Jᵀ) {_each(up, _least)}, rates up to "
            f"{_each(up, lambda run: run.peak_rate)} rad/s; the tip is off by {_each(up, _millimetres)} mm"
            + "".join(
                f", {name} breaks off at {run.t[-1]:.2f} s" for name, run in up.items() if run.status == "stopped"
            ),
            all(run.peak_rate > 100.0 and (_millimetres(run) > 20.0 or run.status == "stopped") for run in up.values()),
            _TRACK.format(gain="2", steps=FINE),
        ),
    ]


#: Gains and steps of the stability map, from A on the arc.
GAINS = -np.geomspace(0.2, 400.0, 23)
MAP_STEPS = (FINE, 500, COARSE, 200, 100, 50)
#: From this distance on the tip has lost the path, m.
LOST = 0.1


@cache
def _map() -> Batch:
    dt = [2.0 / steps for steps in MAP_STEPS]
    return track_batch(_arm(), thesis_arc(), STARTS["A"], GAINS, dt, criterion=ROOT, feedback=0.0)


def _steps() -> list[Row]:
    found = _map()
    lost = found.diverged[0] | ~(found.worst_position_error[0] < LOST)
    last = {
        steps: float(GAINS[int(np.argmax(lost[:, k])) - 1]) for k, steps in enumerate(MAP_STEPS) if lost[:, k].any()
    }
    product = np.array([-gain * 2.0 / steps for steps, gain in last.items()])
    fine = [500, 1000, 2000, 4000]
    halved = track_batch(
        _arm(), thesis_arc(), STARTS["A"], [0.0, -2.0], [2.0 / n for n in fine], criterion=ROOT, feedback=0.0
    ).final_position_error[0]
    order = np.log2(halved[:, :-1] / halved[:, 1:])[:, -1]
    held = _run("A", -2.0, feedback=10.0)
    loose = _run("A", -2.0)
    return [
        _claim(
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
        _claim(
            "sections 3.4, 5",
            "error of Euler's method",
            "a smaller step makes it as small as desired; O(Δt²) in a step",
            f"order {order[0]:.2f} with λ = 0 and {order[1]:.2f} with λ = -2, at the end of the arc",
            bool(np.abs(order - 1.0).max() < 0.1),
            "track_batch(arm, thesis_arc(), STARTS['A'], [0, -2], dt, feedback=0).final_position_error",
            "O(Δt²) in each step adds up to first order over the path",
        ),
        _claim(
            BEYOND,
            "final position error, λ = -2 from A, Δt = .0067",
            "no feedback",
            f"{1000 * loose.final_position_error:.2g} mm without feedback, {1000 * held.final_position_error:.2g} mm "
            "with 10 1/s",
            held.final_position_error < 0.1 * loose.final_position_error,
            "track(..., feedback=10)",
            "the errors of the steps add up unless they are fed back",
            "refined",
        ),
    ]


BEYOND = "beyond the thesis"


# ---- the other two paths -----------------------------------------------------------------------------------------


def _other_paths() -> list[Row]:
    ellipse = {gain: _run("E", gain, FINE) for gain in (0.0, -0.3, -0.8)}
    line = {gain: _run("L", gain, FINE) for gain in (0.0, -0.61, -6.1)}
    rates = [f"{run.peak_rate:.3g}" for run in line.values()]
    searched = "the start was searched for so that this happens"
    return [
        *(
            _claim(
                figure,
                f"λ = 0: least det(J Jᵀ) on the {name}",
                "close to 0",
                f"{_least(run):.2g} at {_when(run):.3g} s, from {run.determinant[0]:.2g}",
                _least(run) < 0.02 * run.determinant[0],
                f"track(arm, papers.sanchez.thesis_{name}(), STARTS['{start}'], gain=0, dt=0.002)",
                searched,
            )
            for figure, name, start, run in (
                ("figure 5.27", "ellipse", "E", ellipse[0.0]),
                ("figure 5.28", "line", "L", line[0.0]),
            )
        ),
        _claim(
            "section 5.1.1",
            "λ = -.3 and -.8 on the ellipse",
            "similar results",
            f"least det(J Jᵀ) {', '.join(f'{_least(run):.2g}' for run in ellipse.values())} with λ = 0, -.3, -.8",
            _least(ellipse[0.0]) < _least(ellipse[-0.3]) < _least(ellipse[-0.8]),
            "track(arm, papers.sanchez.thesis_ellipse(), STARTS['E'], gain=-.8, dt=0.002)",
        ),
        _claim(
            "section 5.1.1",
            "λ = -.61 and -6.1 on the line",
            "similar results",
            f"least det(J Jᵀ) {', '.join(f'{_least(run):.2g}' for run in line.values())} with λ = 0, -.61, -6.1, and "
            f"rates up to {', '.join(rates)} rad/s",
            _least(line[-6.1]) > 3.0 * _least(line[0.0]) and line[-6.1].peak_rate > 5.0 * line[0.0].peak_rate,
            "track(arm, papers.sanchez.thesis_line(), STARTS['L'], gain=-6.1, dt=0.002)",
            "the determinant is larger, but the joints would have to run through their turns: a local law fails here. "
            "Which gain the thesis means is not clear: its list of figures has -.61 once and -6.1 elsewhere",
            "special case",
        ),
    ]


# ---- whole paths -------------------------------------------------------------------------------------------------


def _globally() -> list[Row]:
    """Whole paths optimised, beginning with what the local law does."""
    found = {}
    for path, start in (("arc", "A"), ("line", "L")):
        local = track(_arm(), PATHS[path](), STARTS[start], gain=-2.0, criterion=ROOT, integrator="rk4", dt=0.02)
        found[path] = local, track_globally(_arm(), PATHS[path](), local.q, dt=0.02, count=0)
    (arc, best), (line, through) = found.values()
    between = through.between
    off = float("inf") if between is None else between.position
    how = (
        "track_globally(arm, papers.sanchez.thesis_{path}(), track(..., integrator='rk4', dt=0.02).q, dt=0.02, count=0)"
    )
    return [
        _claim(
            "section 1.1",
            "a global method against a local one, on the arc from A",
            "better, at a higher cost",
            f"least w {best.value:.3g} and rates up to {best.run.peak_rate:.3g} rad/s; with λ = -2 "
            f"{arc.min_manipulability:.3g} and {arc.peak_rate:.3g} rad/s",
            best.solved and best.value > 1.2 * arc.min_manipulability and best.run.peak_rate < arc.peak_rate,
            how.format(path="arc"),
            "all postures of the path at once (IPOPT): a local optimum, at about a thousand times the cost",
        ),
        _claim(
            BEYOND,
            "the line from L, where the local law fails",
            "not treated",
            f"followed with rates up to {through.run.peak_rate:.3g} rad/s, least w {through.value:.2g}; the local law "
            f"with λ = -2: {line.peak_rate:.3g} rad/s, off by up to {_millimetres(line):.2g} mm",
            through.solved and through.run.peak_rate < 10.0 < line.peak_rate and off < 2e-3,
            how.format(path="line"),
            f"at the samples the tip is on the line, between them within {1000.0 * off:.2g} mm",
            "refined",
        ),
    ]


# ---- random starts -----------------------------------------------------------------------------------------------


def random_starts(path: str, count: int, seed: int = 0) -> Array:
    """Random postures (count, 8) of the thesis' arm whose tips are at the start of one of its paths.

    Joints are drawn evenly from all angles and brought to the point by Newton's method; the orientation is what comes
    of it.

    Example:
        >>> import chainrule as cr
        >>> q = random_starts("arc", 5)
        >>> cr.load("sanchez_8r").position(q).round(9)[:2].tolist()
        [[0.25, 0.05, -0.25], [0.25, 0.05, -0.25]]
    """
    arm = _arm()
    point = PATHS[path]().sample([0.0], "position").held[0]
    q = np.random.default_rng(seed).uniform(-math.pi, math.pi, (2 * count, arm.n))
    for _ in range(60):
        away = point - arm.position(q)
        jacobian = arm.jacobian(q, task="position")
        turned = np.swapaxes(jacobian, 1, 2)
        change = (turned @ np.linalg.solve(jacobian @ turned + 1e-12 * np.eye(3), away[..., None]))[..., 0]
        q = q + change * np.minimum(1.0, 0.5 / np.maximum(np.abs(change).max(axis=1, keepdims=True), 1e-300))
    near = np.linalg.norm(arm.position(q) - point, axis=1) < 1e-10
    wrapped: Array = np.remainder(q[near] + math.pi, 2.0 * math.pi) - math.pi
    return wrapped[:count]


@cache
def _population(path: str, count: int) -> Batch:
    return track_batch(
        _arm(),
        PATHS[path](),
        random_starts(path, count),
        [0.0, -0.19, -2.0],
        2.0 / COARSE,
        criterion=ROOT,
        feedback=0.0,
    )


def _shares(path: str, count: int) -> tuple[Array, Array, Array]:
    """Of gains -.19 and -2 the shares that keep farther away, that need lower rates; of all three, that get lost."""
    found = _population(path, count)
    w, peak = found.min_manipulability[..., 0], found.peak_rate[..., 0]
    lost = found.diverged[..., 0] | ~(found.worst_position_error[..., 0] < LOST)
    farther = ((w[:, 1:] > w[:, :1]) & ~lost[:, 1:]).mean(axis=0)
    slower = ((peak[:, 1:] < peak[:, :1]) & ~lost[:, 1:]).mean(axis=0)
    return farther, slower, lost.mean(axis=0)


def _random() -> list[Row]:
    farther, slower, lost = _shares("arc", MANY)
    how = f"track_batch(arm, thesis_arc(), random_starts('arc', {MANY}), [0, -.19, -2], dt=2/{COARSE}, feedback=0)"
    found = _population("arc", MANY)
    near = float((found.min_manipulability[:, 0, 0] ** 2 < 5e-5).mean())
    found_rows = [
        _claim(
            "figure 5.9",
            f"λ = 0 from {MANY} random starts",
            "close to a singularity",
            f"det(J Jᵀ) falls below 5e-5, as from A, B and C, in {100 * near:.0f} %",
            0.0 < near < 0.5,
            how,
            "starts that nobody selected, each holding its own orientation; most never come so near",
            "special case",
        ),
        _claim(
            "figure 5.12",
            f"λ = -2 from {MANY} random starts on the arc",
            "singularity avoidance occurs and is expected",
            f"{100 * farther[1]:.0f} % keep farther away than with λ = 0, {100 * slower[1]:.0f} % need lower rates, "
            f"{100 * lost[2]:.1f} % lose the path",
            0.6 < farther[1] < 0.95 and slower[1] < 0.5,
            how,
            "what the selected starts A, B, C show holds for most starts, not for all: a local law may climb to a "
            "place from which the path leads nearer to a singularity",
            "special case",
        ),
        _claim(
            "figure 5.13",
            f"λ = -.19 from {MANY} random starts on the arc",
            "singularity avoidance occurs and is expected",
            f"{100 * farther[0]:.0f} % keep farther away, {100 * slower[0]:.0f} % need lower rates",
            0.6 < farther[0] < 0.95 and slower[0] > slower[1],
            how,
            "less is gained by each than with λ = -2, but the joints move less for it",
            "special case",
        ),
    ]
    for path in ("ellipse", "line"):
        farther, slower, lost = _shares(path, FEWER)
        found_rows.append(
            _claim(
                "section 5.1.1",
                f"λ = -2 from {FEWER} random starts on the {path}",
                "similar results",
                f"{100 * farther[1]:.0f} % keep farther away and stay on the path; {100 * lost[0]:.0f} % lose it with "
                f"λ = 0, {100 * lost[2]:.0f} % with λ = -2",
                lost[2] > 0.1,
                f"track_batch(arm, thesis_{path}(), random_starts('{path}', {FEWER}), [0, -2], ...)",
                f"lost: the tip off by {LOST} m or a rate above half a turn in a step. The {path} asks for more than "
                "the arc does",
                "special case",
            )
        )
    return found_rows


# ---- figures -----------------------------------------------------------------------------------------------------

#: Figures 5.9 to 5.32: what is drawn, the path, the gain, the steps.
_DRAWN: Mapping[str, tuple[str, str, float, int]] = {
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
_PLACES: Mapping[str, tuple[str, float]] = {
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


def figures() -> dict[str, Figure]:
    """Figures 5.1 to 5.32, from the start postures A, B, C (arc), E (ellipse) and L (line), and two that say more.

    ``figure-starts`` has random starts beside the selected ones, ``figure-gains`` what gains and steps go together.
    """
    return {f"figure-{name}": draw(name) for name in (*_PLACES, *_DRAWN)} | {
        "figure-starts": draw_starts(),
        "figure-gains": draw_gains(),
    }


def draw(name: str) -> Figure:
    """One of the figures 5.1 to 5.32, by its number.

    Raises:
        KeyError: another number.
    """
    from chainrule.plot.redundancy import draw_each_joint, draw_heights, draw_places

    if name in _PLACES:
        path, share = _PLACES[name]
        runs = _runs(path, 0.0)
        places = f"Figure {name}: the arm at the {_WHERE[share]} of the {path}, λ = 0"
        return draw_places(_named(runs), [share], places)
    what, path, gain, steps = _DRAWN[name]
    runs = _runs(path, gain, steps)
    start = f"Figure {name}: the {path} with λ = {_sign(gain)}, step {2000.0 / steps:.3g} ms"
    if what == "determinant":
        close = [start for start, run in runs.items() if _least(run) < 1e-4]
        near = f"{', '.join(close) if len(close) < len(runs) else ''} near a singularity".strip()
        near = near if close else "away from singularities"
        return draw_heights(_named(runs), f"{start}, {near}: least det J Jᵀ at {_each(runs, _when, 3)} s")
    peaks = {
        "rates": ("joint rates", "rad/s", lambda run: run.peak_rate),
        "accelerations": ("joint accelerations", "rad/s²", lambda run: run.peak_acceleration),
        "torque": ("torques", "N m", _torque),
    }
    words, unit, peak = peaks[what]
    note = f"{masses(_arm())}, gravity along −z" if what == "torque" else ""
    return draw_each_joint(_named(runs), what, unit, f"{start}: {words} up to {_each(runs, peak, 3)} {unit}", note)


def _sign(gain: float) -> str:
    return f"{gain:g}".replace("-", "−")


def _named(runs: Mapping[str, Run]) -> dict[str, Run]:
    return {f"start {name}": run for name, run in runs.items()}


def draw_starts() -> Figure:
    """Random starts on the arc, with and without gain, and the selected ones among them."""
    from chainrule.plot.redundancy import draw_population

    found = _population("arc", MANY)
    w = found.min_manipulability[..., 0]
    marked = {start: (_run(start, 0.0).min_manipulability, _run(start, -2.0).min_manipulability) for start in ON["arc"]}
    share = 100.0 * float((w[:, 2] > w[:, 0]).mean())
    title = f"Of {MANY} random starts on the arc {share:.0f} % keep farther from singularities with λ = −2 than without"
    return draw_population(w[:, 0], w[:, 2], ("λ = 0", "λ = −2"), marked, title)


def draw_gains() -> Figure:
    """Which gains go with which steps on the arc from A, and the bound estimated from a run with a small gain."""
    from chainrule.plot.redundancy import draw_stability
    from chainrule.redundancy.stability import decay

    found = _map()
    run = _run("A", -2.0, FINE)
    fastest = float(np.median(decay(Stepper(_arm(), Law({ROOT: -1.0})), run.q[::20], run.held[::20])))
    worst = np.where(found.diverged[0], np.nan, found.worst_position_error[0])
    order = np.argsort(found.dt)
    return draw_stability(GAINS, found.dt[order], worst[:, order], lost=LOST, bound=-2.0 / (fastest * found.dt[order]))
