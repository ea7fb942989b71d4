"""Questions about 3R arms: postures, how many there are, domains of designs, exact answers; each beside a peer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import cycle
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chainrule as cr
from benchmarks.measure import Disagreement
from benchmarks.planar import Way
from chainrule.cuspidality.classify import classify_orthogonal_3r
from chainrule.cuspidality.cusps import certified_cusps
from chainrule.cuspidality.domains import exact_domain
from chainrule.cuspidality.normal_form import ORTHOGONAL_3R, Regional, evaluator
from chainrule.cuspidality.postures import number_of_postures, postures

Array = NDArray[Any]

#: How many times slower numpy.roots and the discriminant in NumPy are meant to be.
ROOTS, COUNTS = 100.0, 10.0
#: The most that one answer is meant to take: a design in a batch, an exact domain, certified cusps, in ns.
DESIGN, DOMAIN, CUSPS = 100.0, 1e5, 1e6
#: ik-geo's roots are right to some 1e-8, also away from singular curves.
PEERS = 1e-6
LENGTHS = (1.0, 2.0, 1.5, 1.0)


def questions(batch: int) -> Iterator[tuple[str, list[Way], str]]:
    """Every question: its heading, the ways of answering it, and perhaps a note."""
    yield f"postures of an orthogonal 3R arm; batch of {batch:,}", *all_postures(batch)
    yield f"the number of postures; batch of {batch:,}", counts(batch), ""
    yield f"domains of orthogonal 3R designs; batch of {10 * batch:,}", domains(10 * batch), ""
    yield "exact answers about one design", exact(), ""


def regional() -> Regional:
    """The arm of figure 2 (a) of the paper."""
    return Regional.of(cr.load("orthogonal_3r_fig2a"))


def points(arm: Regional, count: int) -> Array:
    """Points that random configurations reach, none near a singular curve: there everyone is to give the same."""
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (3 * count, 3))
    chain = cr.load("orthogonal_3r_fig2a")
    reached = chain.position(q)
    found = postures(arm, reached).q
    real = np.isfinite(found[..., 0])
    dets = np.linalg.det(chain.jacobian(np.where(real[..., None], found, 0.0), task="position"))
    clear = ~((np.abs(dets) < 0.3) & real).any(axis=-1)
    return np.ascontiguousarray(reached[clear][:count])


# ---- postures ----------------------------------------------------------------------------------------------------


def all_postures(count: int) -> tuple[list[Way], str]:
    """All postures at points of one arm."""
    arm = regional()
    at = points(arm, count)
    radii = np.stack([at[:, 0] ** 2 + at[:, 1] ** 2, at[:, 2]], axis=-1)
    quartics = np.ascontiguousarray(arm.quartic(radii)[:, ::-1])
    few = min(count, 2000)
    parameters, generated = arm.values, evaluator("postures")
    out = generated(parameters, at)

    def ours() -> tuple[Array, Array]:
        angles, room, _, _, number, _ = generated(parameters, at, out=out)
        larger = np.repeat(room >= room[:, ::-1], 2, axis=-1)
        valid = (number[:, None] == 4.0) | ((number[:, None] == 2.0) & larger)
        return summed(np.where(valid[..., None], angles, np.nan))

    def roots() -> list[Array]:
        return [np.roots(quartic) for quartic in quartics[:few]]

    companions = np.zeros((min(count, 20000), 4, 4))
    companions[:, 1:, :3] = np.eye(3)
    companions[:, 0] = -quartics[: len(companions), 1:] / quartics[: len(companions), :1]
    ways = [
        Way("chainrule, the generated function", len(at), lambda: generated(parameters, at, out=out), ours),
        Way(
            "chainrule, cuspidality.postures: sorted, doubtful points decided exactly",
            len(at),
            lambda: postures(arm, at),
            lambda: summed(postures(arm, at).q),
        ),
        Way("numpy.roots of the quartic alone, a loop", few, roots, lambda: of_roots(roots()), ROOTS),
        Way(
            "numpy.linalg.eigvals of all companion matrices",
            len(companions),
            lambda: np.linalg.eigvals(companions),
            lambda: of_roots(list(np.linalg.eigvals(companions))),
        ),
    ]
    notes = []
    for peer in (eaik, ik_geo):
        try:
            ways.append(peer(at[: min(count, 1000)]))
        except ImportError as reason:
            notes.append(f"{peer.__name__} is left out: {reason}.")
    return ways, " ".join(notes)


def summed(q: Array) -> tuple[Array, Array]:
    """The number of postures, and the sum of cos(theta3 - 1): the same however they are ordered."""
    return np.isfinite(q[..., 2]).sum(axis=-1).astype(float), np.nansum(np.cos(q[..., 2] - 1.0), axis=-1)


def of_roots(roots: list[Array]) -> tuple[Array, Array]:
    """The same of the real ones among roots tan(theta3 / 2)."""
    found = np.stack(roots)
    real = np.abs(found.imag) <= 1e-8 * (1.0 + np.abs(found))
    return summed(np.where(real, 2.0 * np.arctan(found.real), np.nan)[..., None] * [1.0, 1.0, 1.0])


def with_wrist() -> tuple[Array, Array]:
    """Axes (6, 3) and the steps between them (7, 3) of the arm with a spherical wrist at its point, stretched out."""
    d2, d3, d4, r2 = LENGTHS
    axes = np.array([[0, 0, 1], [0, 1, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [1, 0, 0]], float)
    steps = np.array([[0, 0, 0], [d2, r2, 0], [d3, 0, 0], [d4, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]], float)
    return axes, steps


def of_six(solutions: Any, point: Array) -> Array:
    """theta3 (4,) of the postures of six joints, each of which comes with two of the wrist.

    What does not reach the point is dropped: EAIK also returns pairs of first and second joint angles that belong to
    different postures.
    """
    found = np.asarray([np.asarray(q, float)[:3] for q in solutions]).reshape(-1, 3)
    missed = np.linalg.norm(cr.load("orthogonal_3r_fig2a").position(found) - point, axis=-1)
    kept: list[Array] = []
    for q in found[missed < 1e-6]:
        if not any(np.abs(np.exp(1j * q) - np.exp(1j * other)).max() < 1e-6 for other in kept):
            kept.append(q)
    return np.array([q[2] for q in kept] + [np.nan] * 4)[:4]


def looped(who: str, solve: Callable[[Array], Any], at: Array) -> Way:
    """A peer that takes one pose at a time."""

    def loop() -> list[Any]:
        return [solve(point) for point in at]

    def results() -> tuple[Array, Array]:
        theta3 = np.stack([of_six(solutions, point) for solutions, point in zip(loop(), at, strict=True)])
        return summed(theta3[..., None] * [1.0, 1.0, 1.0])

    return Way(who, len(at), loop, results, tolerance=PEERS)


def eaik(at: Array) -> Way:
    """EAIK: subproblem decomposition in C++."""
    from eaik.IK_HP import HPRobot

    robot = HPRobot(*with_wrist())
    pose = np.eye(4)

    def solve(point: Array) -> Any:
        pose[:3, 3] = point
        return robot.IK(pose).Q

    return looped("EAIK, with a spherical wrist, a loop in Python", solve, at)


def ik_geo(at: Array) -> Way:
    """ik-geo: subproblem decomposition in Rust."""
    from ik_geo import Robot

    axes, steps = with_wrist()
    robot = Robot.spherical(axes.tolist(), steps.tolist())
    turn = np.eye(3).tolist()

    def solve(point: Array) -> Any:
        return [q for q, approximate in robot.get_ik(turn, point.tolist()) if not approximate]

    return looped("ik-geo, with a spherical wrist, a loop in Python", solve, at)


# ---- how many ----------------------------------------------------------------------------------------------------


def counts(count: int) -> list[Way]:
    """How many postures there are at targets (rho, z), inside and outside the workspace."""
    arm = regional()
    rho, z = np.random.default_rng(2).uniform([[0.0], [-4.0]], [[5.0], [4.0]], (2, count))
    targets = np.stack([rho**2, z], axis=-1)
    parameters, generated = np.array(arm.orthogonal), evaluator("number_of_postures", ORTHOGONAL_3R)
    out = generated(parameters, targets)

    def ours() -> tuple[Array, ...]:
        generated(parameters, targets, out=out)
        return (out[0],)

    return [
        Way("chainrule, the generated function", count, lambda: generated(parameters, targets, out=out), ours),
        Way(
            "chainrule, cuspidality.number_of_postures",
            count,
            lambda: number_of_postures(arm, rho, z),
            lambda: (number_of_postures(arm, rho, z).astype(float),),
        ),
        Way(
            "the quartic's discriminant in NumPy",
            count,
            lambda: discriminant_count(rho, z),
            lambda: (discriminant_count(rho, z),),
            COUNTS,
        ),
    ]


def discriminant_count(rho: Array, z: Array) -> Array:
    """The number of real roots by the discriminant and its companions, as one writes it in NumPy."""
    d2, d3, d4, r2 = LENGTHS
    u0 = rho**2 + z**2 - (d2**2 + d3**2 + d4**2 + r2**2)
    k1, k2 = 2 * d3 * d4, 2 * r2 * d4
    low, high, mixed = u0 - k1, u0 + k1, -2 * k2
    near, far = d3 + d4, d3 - d4
    a = high**2 + 4 * d2**2 * (z**2 - far**2)
    b = 2 * high * mixed
    c = mixed**2 + 2 * low * high + 8 * d2**2 * (z**2 - near * far)
    d = 2 * low * mixed
    e = low**2 + 4 * d2**2 * (z**2 - near**2)
    first, second = (
        12 * a * e - 3 * b * d + c**2,
        72 * a * c * e + 9 * b * c * d - 27 * (a * d**2 + e * b**2) - 2 * c**3,
    )
    discriminant = 4 * first**3 - second**2
    p, q = 8 * a * c - 3 * b**2, 64 * a**3 * e - 16 * a**2 * c**2 + 16 * a * b**2 * c - 16 * a**2 * b * d - 3 * b**4
    return np.where(discriminant < 0, 2.0, np.where((p < 0) & (q < 0), 4.0, 0.0))


# ---- domains -----------------------------------------------------------------------------------------------------


def domains(count: int) -> list[Way]:
    """The domains of random designs."""
    d2, d3, d4, r2 = np.exp(np.random.default_rng(3).uniform(-2.0, 1.5, (4, count)))
    return [
        Way(
            "chainrule, cr.classify_orthogonal_3r",
            count,
            lambda: classify_orthogonal_3r(d2, d3, d4, r2),
            lambda: (classify_orthogonal_3r(d2, d3, d4, r2).astype(float),),
            most_ns=DESIGN,
        ),
        Way(
            "the paper's surfaces in NumPy, C1 corrected",
            count,
            lambda: by_surfaces(d2, d3, d4, r2),
            lambda: (by_surfaces(d2, d3, d4, r2),),
        ),
    ]


def by_surfaces(d2: Array, d3: Array, d4: Array, r2: Array) -> Array:
    """The domain from the surfaces as they are printed, for any d2."""
    plus, minus = np.hypot(d3 + d2, r2), np.hypot(d3 - d2, r2)
    square = d3**2 + r2**2
    c1 = np.sqrt((square - (square**2 - (d3**2 - r2**2) * d2**2) / (plus * minus)) / 2)
    c2, c34 = d3 * plus / (d3 + d2), d3 * minus / np.abs(d3 - d2)
    beyond = np.where(d3 > d2, 4.0, 5.0)
    return np.where(d4 < c1, 1.0, np.where(d4 < c2, 2.0, np.where(d4 < c34, 3.0, beyond)))


def exact() -> list[Way]:
    """One design decided exactly, and all its cusps with a proof; another design each time."""
    designs = cycle([(1, 2, f"1.{k:03d}", "0.75") for k in range(100, 1000)])
    if exact_domain(*LENGTHS).number != 2 or certified_cusps(list(LENGTHS)).number != 4:
        raise Disagreement("the exact domain or number of cusps")
    return [
        Way("chainrule, exact_domain", 1, lambda: exact_domain(*next(designs)), most_ns=DOMAIN),
        Way("chainrule, certified_cusps", 1, lambda: certified_cusps(list(next(designs))), most_ns=CUSPS),
    ]
