"""E. A. Sanchez's thesis: gradient projection on an 8R arm; its arm, its theory, its paths, and its claims.

The thesis' values are typed here as it prints them; ours come from public functions. It does not say where its arm
starts, what its links weigh, or how gravity acts: see :mod:`.sanchez_paths`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import planar
from chainrule.papers import Row, claim
from chainrule.papers.sanchez_paths import ON, PATHS, STARTS, the_arm
from chainrule.papers.sanchez_runs import COARSE, FINE, ROOT, run_from, run_rows
from chainrule.redundancy.step import Law, Stepper
from chainrule.redundancy.words import masses

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]


def rows(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """The arm, the theory, the paths, and what the thesis claims of its runs."""
    progress("redundancy: the arm and the theory")
    return (*_arm_rows(), *_theory(), *_law(), *_paths(), *run_rows(progress))


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
    return np.random.default_rng(0).uniform(-math.pi, math.pi, (count, the_arm().n))


def _arm_rows() -> list[Row]:
    arm, q = the_arm(), _random_postures(50)
    off = max(float(np.abs(arm.pose(each) - _printed_pose(each)).max()) for each in q)
    shape = arm.jacobian(q[0]).shape
    return [
        claim(
            "table 2.1, (2.3)",
            "the tool's frame",
            "the product of the rows' transformations",
            f"the same, to {off:.1g} m",
            off < 1e-14,
            "load('sanchez_8r').pose(q)",
            "where the scan has 'nil' for the twists it is pi/2; lengths in cm here",
        ),
        claim(
            "(2.5), (2.10)",
            "size of the Jacobian, and of the Cartesian velocity",
            "m x m, and 8 x 1",
            f"m x n: {shape[0]} x {shape[1]}, and {shape[0]} x 1",
            shape == (6, 8),
            "load('sanchez_8r').jacobian(q).shape",
            "elsewhere the thesis has 6 x 8 too",
            "misprint",
        ),
    ]


# ---- theory ------------------------------------------------------------------------------------------------------


def _theory() -> list[Row]:
    arm, q = the_arm(), _random_postures(200)
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
        claim(
            "(2.20)",
            "Jᵀ (J Jᵀ)⁻¹ v",
            "the smallest rates with J q' = v",
            f"the same rates as ours, to {off:.1g} of them, in 200 postures",
            off < 1e-10,
            "Stepper(arm, Law())(q, arm.pose(q), v, dt).rates",
            "ours come from a factorisation of the rows of J instead, which keeps twice the digits near a singularity",
        ),
        claim(
            "(3.3)",
            "dim R(J) + dim N(J)",
            "n, also where J loses rank",
            f"{rank} + {8 - rank} = 8 at q = 0, which is singular",
            rank == 5,
            "arm.jacobian(np.zeros(8))",
        ),
        claim(
            "section 3.2.1",
            "v in R(J) at a singularity",
            "no solution, and two lines below: solutions",
            f"a solution for v in R(J) (misses by {missed[0]:.1g}), none for another v (by {missed[1]:.2g})",
            missed[0] < 1e-12 and missed[1] > 0.99,
            "numpy.linalg.lstsq(arm.jacobian(np.zeros(8)), v)",
            "the first of the two sentences means v NOT in R(J)",
            "misprint",
        ),
        _bytes(),
        _slides(),
        _statics(),
    ]


def _bytes() -> Row:
    sizes = [np.dtype(kind).itemsize for kind in (np.float32, np.float64)]
    return claim(
        "section 3.4",
        "bytes of a single and of a double",
        "8 and 16",
        f"{sizes[0]} and {sizes[1]}",
        sizes == [4, 8],
        "numpy.dtype('float32').itemsize",
        "16 is about the number of digits of a double",
        "misprint",
    )


def _slides() -> Row:
    jacobian = planar("PRR", [0.2, 0.35, 0.25]).jacobian([0.1, 0.7, -0.9], task="position")
    v = np.array([0.3, -0.2])
    off = float(np.abs(jacobian @ (jacobian.T @ np.linalg.solve(jacobian @ jacobian.T, v)) - v).max())
    return claim(
        "section 4.1",
        "the pseudoinverse",
        "only for arms whose joints are all of one type",
        f"J q' = v to {off:.1g} for a slide and two revolute joints",
        off < 1e-14,
        "planar('PRR', [0.2, 0.35, 0.25]).jacobian(q, task='position')",
        "it solves J q' = v for any joints; what depends on the choice of units is which solution counts as smallest",
        "misprint",
    )


def _statics() -> Row:
    arm, q, still = the_arm(), np.array(STARTS["A"]), np.zeros(8)
    force = np.array([3.0, -2.0, 5.0, 0.4, 0.1, -0.3])
    held = arm.inverse_dynamics(q, still, still, gravity=(0.0, 0.0, 0.0), wrench=force)
    off = float(np.abs(held - arm.jacobian(q).T @ force).max())
    moving = run_from("A", 0.0).peak_torque or 0.0
    return claim(
        "(2.23)",
        "tau = Jᵀ f",
        "the joint torques, in section 5 the Newton-Euler algorithm",
        f"at rest and without weight Newton-Euler gives Jᵀ f, to {off:.1g} N m; on the arc, with f = 0, "
        f"{moving:.3g} N m",
        off < 1e-13 and moving > 1.0,
        "arm.inverse_dynamics(q, 0, 0, gravity=(0, 0, 0), wrench=f)",
        f"it is statics: motion and weight need inertia. Ours rests on {masses(arm)}",
        "true under a condition",
    )


# ---- the law -----------------------------------------------------------------------------------------------------


def _law() -> list[Row]:
    arm, q = the_arm(), _random_postures(500)
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
    along = run_from("A", -2.0).manipulability ** -0.5 * 2.0
    return [
        claim(
            "(4.9)",
            "q' = J* v + (J* J - I) ∇H",
            "improves H where it is to be small",
            f"H falls in {int((descent <= 0.0).sum())} of 500 postures",
            bool((descent <= 0.0).all()),
            "arm.manipulability_gradient(q)",
        ),
        claim(
            "(4.10), (4.11)",
            "λ = -1 in (4.10) gives (4.11)",
            "q' = J* v + λ (I - J* J) ∇H",
            f"the same motion has λ = 1 in (4.10) and λ = -1 in (4.11), to {same:.1g}",
            same < 1e-9,
            "Stepper(arm, Law({'H^(-1/2)': -1}))",
            "the step from one to the other flips the sign of λ; with (4.11), which the thesis uses, negative gains "
            "lower H",
            "misprint",
        ),
        claim(
            "after (4.11)",
            "the projection",
            "(I - J* Jᵀ)",
            f"I - J* J; J* is {shapes[0][0]} x {shapes[0][1]} and Jᵀ {shapes[1][0]} x {shapes[1][1]}: no product",
            shapes[0][1] != shapes[1][0],
            "numpy.linalg.pinv(arm.jacobian(q)).shape",
            "the projection onto the null space is I - J* J",
            "misprint",
        ),
        claim(
            "section 4.2.1",
            "sign of λ",
            "negative: H is minimised; positive: maximised",
            f"H falls in {int((change[-1.0] <= 0).sum())} and grows in {int((change[1.0] >= 0).sum())} of 500 postures",
            bool((change[-1.0] <= 0.0).all() and (change[1.0] >= 0.0).all()),
            "Stepper(arm, Law({'H^(-1/2)': -1}))",
            "H is the criterion of (4.14) here, which is large near singularities: negative gains keep away from them",
        ),
        claim(
            "section 4.2",
            "the gradient's part of q'",
            "does not influence the end effector",
            f"J q' = 0 to {rest:.1g} of q'; a step of Euler moves the tip with the square of dt: {_drift():.2f}-fold "
            "where dt is halved",
            rest < 1e-9 and abs(_drift() - 0.25) < 0.01,
            "Stepper(arm, Law({'H^(-1/2)': -2}))(q, arm.pose(q), None, dt).q_next",
            "true of the rates; after a step of finite length the tip is off, which feedback takes back",
            "true under a condition",
        ),
        claim(
            "(4.14)",
            "the criterion",
            "1/w, or w^(-1/2); both are called H1",
            f"∇(1/w) = 2 w^(-1/2) ∇(w^(-1/2)) to {ratio:.1g}; on the arc from A the factor is {along.min():.3g} to "
            f"{along.max():.3g}",
            ratio < 1e-12,
            "arm.manipulability_gradient(q)",
            "they need different gains. What follows is for w^(-1/2), which section 5 names, unless it says otherwise",
            "agrees",
        ),
    ]


def _drift() -> float:
    """How much less the tip has moved where a step along the null space is half as long."""
    arm, q = the_arm(), np.array(STARTS["A"])
    stepper = Stepper(arm, Law({ROOT: -2.0}))
    far = [
        float(np.linalg.norm(arm.position(stepper(q, arm.pose(q), None, dt).q_next) - arm.position(q)))
        for dt in (1e-3, 5e-4)
    ]
    return far[1] / far[0]


# ---- the paths ---------------------------------------------------------------------------------------------------


def _paths() -> list[Row]:
    arm = the_arm()
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
        claim(
            "table 5.1",
            "unit of the positions",
            "cm",
            f"m: the arm reaches the three first points, in postures A to L to {off:.1g} m",
            off < 1e-10,
            "load('sanchez_8r').position(q)",
            "in cm the paths would lie within 1 cm of the base; the links of table 2.1 are in cm indeed",
            "misprint",
        ),
        claim(
            "table 5.1",
            "py",
            "0, with pyo = .05, .6, .2 above",
            f"y = pyo all along; it changes by {across:.1g}",
            across < 1e-15,
            "papers.sanchez_paths.thesis_arc().sample(t)",
            "taken so because pyo would have no use otherwise and vy is 0",
            "misprint",
        ),
        claim(
            "table 5.1",
            "the ellipse",
            "an ellipse",
            f"a circle: its radius varies by {spread:.1g} m",
            spread < 1e-14,
            "papers.sanchez_paths.thesis_ellipse().sample(t)",
            "both semi-axes are rad = 0.3",
            "misprint",
        ),
        claim(
            "table 5.1",
            "velocity of the tip",
            "vt = [vx, vy, vz] / 2",
            f"the same, to {velocity:.1g} m/s",
            velocity < 1e-14,
            "papers.sanchez_paths.PATHS[name]().sample(t).velocity",
            "the table repeats vx, vy, xz; vz is meant",
        ),
        claim(
            "section 5.1.1",
            "Δt",
            "0.0067 s, with angles of π/1000 in table 5.1",
            f"{COARSE} steps of {2.0 / COARSE:.6f} s; π/1000 belongs to Δt = {2.0 / FINE:g} s",
            round(2.0 / COARSE, 4) == 0.0067 and 2.0 / FINE == 0.002,
            "track(arm, path, q, dt=2 / 299)",
            "2 s are not a whole number of steps of 0.0067 s",
            "agrees",
        ),
    ]


# ---- figures -----------------------------------------------------------------------------------------------------


def figures() -> dict[str, Figure]:
    """Figures 5.1 to 5.32, from the start postures A, B, C (arc), E (ellipse) and L (line), and three that say more.

    ``figure-errors`` has the errors of n, o, a and p (the thesis' are among the figures after its last page here),
    ``figure-starts`` has random starts beside the selected ones, ``figure-gains`` what gains and steps go together.
    """
    from chainrule.papers import sanchez_figures as drawn

    return {f"figure-{name}": drawn.draw(name) for name in (*drawn.PLACES, *drawn.DRAWN)} | {
        "figure-errors": drawn.draw_errors(),
        "figure-starts": drawn.draw_starts(),
        "figure-gains": drawn.draw_gains(),
    }
