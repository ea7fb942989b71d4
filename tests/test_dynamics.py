"""Inverse dynamics against Lagrange's equations at 40 digits, energy, statics, closed forms and Pinocchio.

The Lagrangian here knows of an arm only the frames of tests/reference.py, and of each link the sums over its points
r = (x, y, z, 1): with F the frame and P = sum dm r r^T, T = sum tr(F' P F'^T) / 2 and V = -sum g . F P (0, 0, 0, 1)^T.
"""

from __future__ import annotations

from dataclasses import replace

import arms_under_test as under
import mpmath
import numpy as np
import pytest
import reference
from test_peers import pinocchio_of, robot_file

import chainrule as cr
from chainrule.derive import catalogue
from chainrule.derive.program import evaluate
from chainrule.description import Inertia, Planar

DIGITS = 80


def boxes(count, seed):
    """Inertias of boxes of random sizes, turned and placed at random; the last one is a point."""
    rng, found = np.random.default_rng(seed), []
    for _ in range(count - 1):
        sides, mass = rng.uniform(0.05, 0.4, 3), rng.uniform(0.3, 4.0)
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        tensor = turn @ np.diag(mass / 12 * ((sides**2).sum() - sides**2)) @ turn.T
        found.append(Inertia(mass, tuple(rng.uniform(-0.3, 0.3, 3).tolist()), symmetric(tensor)))
    return [*found, Inertia(0.7, (0.1, -0.2, 0.3), ((0.0,) * 3,) * 3)]


def symmetric(tensor):
    return tuple(tuple(row) for row in ((tensor + tensor.T) / 2).tolist())


def dh_arm(kinds, seed):
    rng = np.random.default_rng(seed)
    rows = [(kind, *rng.uniform(-1.5, 1.5, 1), *rng.uniform(-0.4, 0.4, 2), rng.uniform(-3, 3)) for kind in kinds]
    return cr.Arm.from_dh(rows, tool=(0.1, 0.2, 0.3), name=f"dynamics_{kinds.lower()}")


SPATIAL = {
    "RPRP": dh_arm("RPRP", 1).with_inertias(boxes(4, 1)),
    "PRRPR": cr.Arm.from_dh(
        [(kind, turn * np.pi / 2, 0.3, -0.2, 0.0) for kind, turn in zip("PRRPR", (1, -1, 0, 1, 2), strict=True)],
        tool=(0.1, 0.2, 0.3),
        name="dynamics_prrpr",
    ).with_inertias(boxes(5, 2)),
    "orthogonal": cr.orthogonal_3r(1.0, 2.0, 1.5, 0.4).with_inertias(boxes(3, 3)),
    "sanchez_8r": cr.load("sanchez_8r"),
}
PLANAR = {
    "planar RRR": cr.planar_3r(1.0, 0.5, 0.25).with_inertias(boxes(3, 4)),
    "planar RPR": cr.planar("RPR", (0.9, 0.6, 0.4), (0.0, 0.7, 0.0)).with_inertias(boxes(3, 5)),
    "planar PRP": cr.planar("PRP", (0.2, 0.6, 0.0), (0.4, 0.0, 2.0)).with_inertias(boxes(3, 6)),
}
ARMS = SPATIAL | PLANAR
every_arm = pytest.mark.parametrize("name", ARMS)


def motions(name, count, seed=0):
    """q, rates, accelerations (count, n), gravity, wrench, all at random."""
    arm, rng = ARMS[name], np.random.default_rng(seed)
    plane = name in PLANAR
    q = under.random_q(arm, count, seed)
    return (
        q,
        *rng.normal(size=(2, count, arm.n)),
        rng.normal(size=2 + (not plane)) * 9,
        rng.normal(size=3 + 3 * (not plane)),
    )


def moment_matrix(arm):
    """P of every link, in its frame."""
    found = []
    for body in arm.description.inertias:
        centre, tensor = mpmath.matrix(body.centre), mpmath.matrix(body.tensor)
        if isinstance(arm.description.geometry, Planar):  # any two sums of x^2 and y^2 that give the moment about z
            centre, spread = centre[:2], mpmath.eye(2) * tensor[2, 2] / 2
            centre = mpmath.matrix(centre)
        else:
            spread = mpmath.eye(3) * (tensor[0, 0] + tensor[1, 1] + tensor[2, 2]) / 2 - tensor
        size = centre.rows
        whole = mpmath.zeros(size + 1)
        for i in range(size):
            whole[i, size] = whole[size, i] = body.mass * centre[i]
            for j in range(size):
                whole[i, j] = spread[i, j] + body.mass * centre[i] * centre[j]
        whole[size, size] = mpmath.mpf(body.mass)
        found.append(whole)
    return found


def frames(arm, q):
    """The frame that each joint moves. In the plane the reference has the link's end: l_i further along x."""
    found = reference._frames(arm.description, q)
    if not isinstance(arm.description.geometry, Planar):
        return found[:-1]
    return [
        end * mpmath.matrix([[1, 0, -mpmath.mpf(length)], [0, 1, 0], [0, 0, 1]])
        for end, length in zip(found[1:], arm.description.geometry.lengths, strict=True)
    ]


def moved(q, step, direction):
    return [mpmath.mpf(x) + step * mpmath.mpf(d) for x, d in zip(q, direction, strict=True)]


def kinetic(arm, q, rates):
    step = mpmath.mpf(10) ** -30
    total = mpmath.mpf(0)
    ends = (frames(arm, moved(q, s, rates)) for s in (step, -step))
    for ahead, behind, points in zip(*ends, moment_matrix(arm), strict=True):
        rate = (ahead - behind) / (2 * step)
        half = rate * points
        total += mpmath.fsum(half[i, j] * rate[i, j] for i in range(rate.rows) for j in range(rate.cols)) / 2
    return total


def potential(arm, q, gravity):
    total = mpmath.mpf(0)
    for frame, points in zip(frames(arm, q), moment_matrix(arm), strict=True):
        weighted = frame * points[:, frame.cols - 1]
        total -= mpmath.fsum(float(g) * weighted[i] for i, g in enumerate(gravity))
    return total


def lagrange(arm, q, rates, accelerations, gravity, wrench):
    """d/dt dT/dq' - dT/dq + dV/dq + J^T wrench; T is a quadratic form in the rates, so that dT/dq'_i = 2 B(q', e_i)."""
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(10) ** -20
        units = np.eye(arm.n)
        jacobian = reference.jacobian(arm.description, q, DIGITS)

        def momentum(s, unit):
            # along the motion: q + q' s + q'' s^2 / 2 at the time s
            there = moved(moved(q, s, rates), s * s / 2, accelerations)
            going = moved(rates, s, accelerations)
            both, one, other = (kinetic(arm, there, r) for r in (moved(going, 1, unit), going, unit))
            return both - one - other

        torque = []
        for i, unit in enumerate(units):
            change = (momentum(step, unit) - momentum(-step, unit)) / (2 * step)
            ahead, behind = (
                kinetic(arm, there, rates) - potential(arm, there, gravity)
                for there in (moved(q, step, unit), moved(q, -step, unit))
            )
            pushed = mpmath.fsum(jacobian[row, i] * float(w) for row, w in enumerate(wrench))
            torque.append(change - (ahead - behind) / (2 * step) + pushed)
        return torque


def exact_inertias(arm):
    """What the generated functions take of every link, from P, at all digits."""
    found = []
    with mpmath.workdps(DIGITS):
        for points in moment_matrix(arm):
            last = points.rows - 1
            trace = mpmath.fsum(points[i, i] for i in range(last))
            tensor = [(trace if i == j else 0) - points[i, j] for i in range(last) for j in range(i, last)]
            found.append([points[last, last], *points[:last, last], *(tensor if last == 3 else [trace])])
    return found


@every_arm
def test_inertia_about_the_origin(name):
    kept = [0, 1, 2, 9] if name in PLANAR else range(10)
    for body, exact in zip(ARMS[name].description.inertias, exact_inertias(ARMS[name]), strict=True):
        found = body.about_origin()
        assert len(found) == 10
        for place, value in zip(kept, exact, strict=True):
            assert abs(found[place] - value) < 4e-16 * (body.mass + 1)


@pytest.mark.parametrize("name", [name for name in ARMS if name != "sanchez_8r"])
def test_lagrange_at_forty_digits(name):
    """The derivation is the Lagrangian's to 30 digits (where no rotation of the description is rounded), and what is
    compiled follows as far as doubles reach."""
    arm = ARMS[name]
    q, rates, accelerations, gravity, wrench = motion = motions(name, 1)
    exact = lagrange(arm, *(part.reshape(-1) for part in motion))
    largest = max(abs(x) for x in exact)
    (function,) = catalogue.functions(arm.description.model, "dynamics")
    parts = {"q": q, "parameters": arm.parameters, "rates": rates, "accelerations": accelerations}
    values = {port: array.ravel().tolist() for port, array in (parts | {"gravity": gravity, "wrench": wrench}).items()}
    values["inertias"] = [entry for row in exact_inertias(arm) for entry in row]
    derived = evaluate(function.program, values, 50)["torque"]
    assert distance(derived, exact) < (1e-15 if name == "RPRP" else 1e-30) * largest
    found = arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench)
    assert found.shape == (1, arm.n)
    assert distance(found[0], exact) < 4e-15 * largest


def distance(found, exact):
    with mpmath.workdps(DIGITS):
        return max(abs(mpmath.mpf(a) - b) for a, b in zip(found, exact, strict=True))


def jacobians(arm, q):
    return np.array([np.array(reference.jacobian(arm.description, row, 25).tolist(), float) for row in q])


# ---- energy and statics ----------------------------------------------------------------------------------------


@every_arm
def test_power_is_the_change_of_energy(name):
    """Along a smooth motion of a second, the work of the joints is T + V at its end less that at its beginning, and
    what the tip's wrench has done to its surroundings."""
    arm = ARMS[name]
    middle, swing, phase, gravity, wrench = motions(name, 1, 7)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    t = np.concatenate(([0.0], (nodes + 1) / 2, [1.0]))[:, None]
    pace = np.arange(1, arm.n + 1) / 2 + 1
    q = middle + swing / 2 * np.sin(pace * t + phase)
    rates, accelerations = (
        swing / 2 * pace**k * f(pace * t + phase) for k, f in ((1, np.cos), (2, lambda x: -np.sin(x)))
    )
    torque = arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench)
    tip = np.einsum("kij,kj->ki", jacobians(arm, q), rates)
    power = (torque * rates).sum(axis=1) - tip @ wrench
    work = weights @ power[1:-1] / 2
    with mpmath.workdps(DIGITS):
        energy = [float(kinetic(arm, q[k], rates[k]) + potential(arm, q[k], gravity)) for k in (0, -1)]
    assert abs(work - (energy[1] - energy[0])) < 1e-12 * np.abs(power).max()
    assert np.ptp(energy) > 0.1  # the comparison is of something


@every_arm
def test_at_rest_it_is_the_slope_of_the_potential(name):
    arm = ARMS[name]
    q, gravity = motions(name, 1, 8)[0][0], motions(name, 1, 8)[3]
    still = np.zeros(arm.n)
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(10) ** -30
        ends = [[potential(arm, moved(q, s, unit), gravity) for s in (step, -step)] for unit in np.eye(arm.n)]
        slope = [(ahead - behind) / (2 * step) for ahead, behind in ends]
    found = arm.inverse_dynamics(q, still, still, gravity=gravity)
    assert distance(found, slope) < 2e-15 * max(abs(x) for x in slope)


@every_arm
def test_wrench_of_the_tip(name):
    """J^T (force; moment), as statics has it, on top of the motion's torque."""
    arm = ARMS[name]
    q, rates, accelerations, gravity, _ = motions(name, 20, 9)
    wrench = np.random.default_rng(10).normal(size=(20, 3 if name in PLANAR else 6))
    free, loaded = (arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=w) for w in (None, wrench))
    expected = np.einsum("kij,ki->kj", jacobians(arm, q), wrench)
    assert np.abs(loaded - free - expected).max() < 1e-13 * np.abs(loaded).max()
    still = np.zeros(arm.n)
    held = arm.inverse_dynamics(q, still, still, gravity=0 * gravity, wrench=wrench)
    assert np.abs(held - expected).max() < 1e-14 * np.abs(expected).max()


# ---- structure -------------------------------------------------------------------------------------------------


@every_arm
def test_mass_matrix(name):
    """Columns by unit accelerations: symmetric, positive definite, and half its quadratic form is T."""
    arm = ARMS[name]
    q, rates = motions(name, 200, 11)[:2]
    still = np.zeros(arm.n)
    none = np.zeros(2 if name in PLANAR else 3)
    mass = arm.inverse_dynamics(q[:, None], still, np.eye(arm.n), gravity=none)
    assert mass.shape == (200, arm.n, arm.n)
    assert np.abs(mass - mass.swapaxes(1, 2)).max() < 1e-14 * np.abs(mass).max()
    assert np.linalg.eigvalsh(mass).min() > 0
    with mpmath.workdps(DIGITS):
        energy = float(kinetic(arm, q[0], rates[0]))
    assert abs(rates[0] @ mass[0] @ rates[0] / 2 / energy - 1) < 1e-14


@every_arm
def test_linear_in_inertias_and_accelerations(name):
    arm = ARMS[name]
    q, rates, accelerations, gravity, wrench = motions(name, 100, 12)
    evaluator = arm.evaluator("inverse_dynamics")
    (first, second) = np.random.default_rng(13).normal(size=(2, *dict(evaluator.inputs)["inertias"]))

    def torque(inertias):
        return evaluator(*under.arguments(arm, q), rates, accelerations, inertias, gravity, 0 * wrench)

    mixed = torque(2.0 * first - 0.3 * second)
    assert np.abs(mixed - (2.0 * torque(first) - 0.3 * torque(second))).max() < 1e-13 * np.abs(mixed).max()

    def driven(qdd):
        return arm.inverse_dynamics(q, rates, qdd, gravity=gravity, wrench=wrench)

    more = driven(accelerations + 1.0) - driven(accelerations)
    other = driven(np.ones(arm.n)) - driven(np.zeros(arm.n))
    assert np.abs(more - other).max() < 1e-13 * np.abs(driven(accelerations)).max()


# ---- closed forms of one joint ---------------------------------------------------------------------------------

ROD = Inertia(2.0, (0.5, 0.0, 0.0), ((0.0, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.0, 0.2)))


def test_pendulum():
    """(I + m c^2) q'' + m g c cos q, in the plane and about a level axis in space."""
    q, rate, acceleration = np.random.default_rng(14).normal(size=(3, 50, 1))
    expected = (0.2 + 2.0 * 0.25) * acceleration + 2.0 * 9.81 * 0.5 * np.cos(q)
    spatial = cr.Arm.from_dh([("R", np.pi / 2, 0.0, 0.0, 0.0)], name="dynamics_pendulum", inertias=[ROD])
    for arm in (spatial, cr.planar("R", [1.0]).with_inertias([ROD])):
        np.testing.assert_allclose(arm.inverse_dynamics(q, rate, acceleration), expected, rtol=0, atol=1e-14)


def test_lift():
    """m (q'' + g): the rate and the moments of inertia do not matter."""
    q, rate, acceleration = np.random.default_rng(15).normal(size=(3, 50, 1))
    spatial = cr.Arm.from_dh([("P", 0.0, 0.3, 0.1, 0.4)], name="dynamics_lift", inertias=[ROD])
    for arm in (spatial, cr.planar("P", [1.0], [np.pi / 2]).with_inertias([ROD])):
        found = arm.inverse_dynamics(q, rate, acceleration)
        np.testing.assert_allclose(found, 2.0 * (acceleration + 9.81), rtol=0, atol=2e-14)


def test_without_mass_nothing_is_needed():
    arm = SPATIAL["RPRP"].with_inertias([Inertia(0.0, (0.1, 0.2, 0.3), ((0.0,) * 3,) * 3)] * 4)
    q, rates, accelerations, *_ = motions("RPRP", 9, 16)
    assert np.all(arm.inverse_dynamics(q, rates, accelerations) == 0)


# ---- Pinocchio -------------------------------------------------------------------------------------------------


def recursive(pin, model, q, rates, accelerations, external=None):
    data = model.createData()
    more = [] if external is None else [external]
    return np.array([pin.rnea(model, data, *row, *more) for row in zip(q, rates, accelerations, strict=True)])


@pytest.mark.parametrize("name", [name for name in SPATIAL if name != "orthogonal"])
def test_pinocchio_from_our_description(name):
    pin = pytest.importorskip("pinocchio")
    arm = ARMS[name]
    model, _ = pinocchio_of(pin, arm)
    for k, body in enumerate(arm.description.inertias, 1):
        inertia = pin.Inertia(body.mass, np.array(body.centre), np.array(body.tensor))
        model.appendBodyToJoint(k, inertia, pin.SE3.Identity())
    q, rates, accelerations, gravity, _ = motions(name, 500, 17)
    for field in (None, gravity):
        model.gravity.linear[:] = [0.0, 0.0, -9.81] if field is None else field
        expected = recursive(pin, model, q, rates, accelerations)
        found = arm.inverse_dynamics(q, rates, accelerations, gravity=field)
        assert np.abs(found - expected).max() < 1e-14 * np.abs(expected).max()


def test_pinocchio_reads_the_same_panda():
    """Masses from a file nobody here wrote, through our reader and theirs; fingers are not on the way to the tip."""
    pin = pytest.importorskip("pinocchio")
    path = robot_file("panda_description/urdf/panda.urdf")
    arm, model = cr.load(path, tip="panda_link8"), pin.buildModelFromUrdf(str(path))
    for name in model.names:
        if "finger" in name:
            model.inertias[model.getJointId(name)] = pin.Inertia.Zero()
    assert [model.names[k] for k in range(1, 8)] == list(arm.joint_names)
    q, rates, accelerations = np.random.default_rng(18).normal(size=(3, 500, 7))
    whole = [np.hstack([part, np.zeros((500, model.nv - 7))]) for part in (q, rates, accelerations)]
    expected = recursive(pin, model, *whole)[:, :7]
    assert np.abs(arm.inverse_dynamics(q, rates, accelerations) - expected).max() < 1e-14 * np.abs(expected).max()
    assert np.abs(expected).max() > 20


# ---- arrays, types and refusals --------------------------------------------------------------------------------


@every_arm
def test_types_and_shapes(name):
    arm = ARMS[name]
    q, rates, accelerations, gravity, wrench = motions(name, 70, 19)
    plain = arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench)
    halves = [part.astype(np.float32) for part in (q, rates, accelerations)]
    single = arm.inverse_dynamics(*halves, gravity=gravity.tolist(), wrench=tuple(wrench.tolist()))
    assert single.dtype == np.float32
    assert np.abs(single - plain).max() < 2e-5 * np.abs(plain).max()
    assert arm.inverse_dynamics(*halves).dtype == np.float32
    assert arm.inverse_dynamics(halves[0], rates, accelerations).dtype == np.float64
    assert arm.inverse_dynamics(*halves, wrench=wrench).dtype == np.float64
    many = np.tile(gravity, (3, 1, 1))
    assert np.array_equal(arm.inverse_dynamics(q, rates, accelerations, gravity=many, wrench=wrench)[2], plain)
    out = np.empty((70, arm.n))
    assert arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench, out=out) is out
    assert np.array_equal(out, plain)
    one = arm.inverse_dynamics(q[3].tolist(), rates[3].tolist(), accelerations[3].tolist())
    assert one.shape == (arm.n,)
    for shape in ((0, arm.n), (2, 0, arm.n)):
        assert arm.inverse_dynamics(*np.zeros((3, *shape))).shape == shape
    rates[5] = np.nan
    dirty = arm.inverse_dynamics(q, rates, accelerations, gravity=gravity, wrench=wrench)
    assert np.isnan(dirty[5]).any()
    assert np.array_equal(np.delete(dirty, 5, axis=0), np.delete(plain, 5, axis=0))


def test_the_numpy_code_agrees():
    """What is used where there is no compiler."""
    for name in ("RPRP", "planar RPR"):
        arm = ARMS[name]
        q, rates, accelerations, gravity, wrench = motions(name, 40, 20)
        evaluator = arm.evaluator("inverse_dynamics")
        assert evaluator.compiled
        inertias = np.random.default_rng(21).normal(size=dict(evaluator.inputs)["inertias"])
        arrays = [*under.arguments(arm, q), rates, accelerations, inertias, gravity, wrench]
        compiled = evaluator(*arrays)
        assert (
            np.abs(under.written(arm, "dynamics")["inverse_dynamics"](*arrays) - compiled).max()
            < 1e-13 * np.abs(compiled).max()
        )


def test_usual_gravity():
    for name, down in (("RPRP", [0.0, 0.0, -9.81]), ("planar RRR", [0.0, -9.81])):
        q, rates, accelerations, *_ = motions(name, 5, 22)
        usual, given = (ARMS[name].inverse_dynamics(q, rates, accelerations, gravity=g) for g in (None, down))
        assert np.array_equal(usual, given)


def test_joints_without_inertia_are_named():
    still = np.zeros(7)
    with pytest.raises(
        cr.InputError, match=r"panda: no inertia is known for joint1, .*joint5 and 2 more; .*Arm.with_inertias"
    ) as caught:
        cr.load("panda").inverse_dynamics(still, still, still)
    under.one_line(caught.value)
    arm = SPATIAL["RPRP"].with_inertias([ROD, None, ROD, None])
    with pytest.raises(cr.InputError, match="no inertia is known for joint2, joint4; ") as caught:
        arm.inverse_dynamics(still[:4], still[:4], still[:4])
    under.one_line(caught.value)


@pytest.mark.parametrize(
    ("inertias", "said"),
    [
        ([ROD], "1 inertias for 4 joints"),
        ([ROD, 1.0, ROD, ROD], "one Inertia, or None, per joint is accepted"),
        (ROD, "one Inertia, or None, per joint is accepted"),
        ([replace(ROD, mass=-1.0)] * 4, "joint 'joint1': mass -1.0 kg is negative"),
    ],
)
def test_wrong_inertias_are_refused(inertias, said):
    with pytest.raises(cr.DescriptionError, match=said) as caught:
        SPATIAL["RPRP"].with_inertias(inertias)
    under.one_line(caught.value)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"qd": np.zeros(3)}, r"rates has shape \(3,\); \(\.\.\., 4\) is accepted"),
        ({"qdd": np.zeros(4) * 1j}, "accelerations has type complex128"),
        ({"gravity": -9.81}, r"gravity has shape \(\)"),
        ({"gravity": [0.0, -9.81]}, r"gravity has shape \(2,\); \(\.\.\., 3\) is accepted"),
        ({"wrench": [[1.0], [2.0, 3.0]]}, "ragged"),
        ({"wrench": np.zeros(3)}, r"wrench has shape \(3,\)"),
    ],
)
@pytest.mark.parametrize("real", [np.float64, np.float32])
def test_wrong_arrays_are_refused(changed, said, real):
    given = {name: np.zeros(4, real) for name in ("q", "qd", "qdd")} | changed
    with pytest.raises(cr.InputError, match=said) as caught:
        SPATIAL["RPRP"].inverse_dynamics(**given)
    under.one_line(caught.value)
