"""One step of a redundant arm along a task, as it is programmed elsewhere; and PlaCo's and Pink's step of the Panda."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import chainrule as cr
from benchmarks.planar import Way
from chainrule.description import Serial, Transform
from chainrule.redundancy.step import Damping, Law, Stepper

Array = NDArray[Any]

#: H^(-1/2) with the gain of the Sanchez thesis, and feedback of both errors.
GAIN, FEEDBACK, DT = -2.0, 10.0, 0.0067
LAW = Law({"H^(-1/2)": GAIN}, feedback=(FEEDBACK, FEEDBACK))
#: How many times slower NumPy with central differences, and with the exact gradient, are meant to be than a batch.
CENTRAL, EXACT = 3000.0, 540.0
#: Central differences of H are right to about this.
DIFFERENCES = 1e-5
#: How many times slower PlaCo is meant to be, a step at a time and beside a batch.
PLACO, PLACO_BATCH = 1.0, 50.0
REST = np.array([0.3, -0.8, 0.1, -2.3, 0.2, 1.6, 0.8])
#: The Panda's step goes to the target at once, as PlaCo's and Pink's do, whose errors are measured otherwise.
AT_ONCE, NEARLY = 1.0 / DT, 1e-3
#: PlaCo needs a regularization: the square of what damps ours in a row of its own.
REGULARIZATION = 1e-6


def questions(batch: int) -> Iterator[tuple[str, list[Way], str]]:
    """Every question: its heading, the ways of answering it, and perhaps a note."""
    given = situation(batch)
    yield f"a step of the 8R arm along its pose; batch of {batch:,}", *batches(*given)
    yield "a step of the 8R arm along its pose; one at a time, from Python", singles(*given), ""
    for heading, least in (("one at a time, from Python", PLACO), (f"batch of {batch:,}", PLACO_BATCH)):
        yield f"a step of the Panda along its pose; {heading}", *of_panda(batch, least)


def situation(count: int) -> tuple[Array, Array, Array]:
    """Postures with H above 0.02, targets near by, velocities."""
    arm, rng = cr.load("sanchez_8r"), np.random.default_rng(1)
    q = rng.uniform(-np.pi, np.pi, (4 * count, arm.n))
    q = np.ascontiguousarray(q[arm.manipulability(q) > 0.02][:count])
    return q, arm.pose(q + rng.normal(0.0, 0.01, q.shape)), rng.normal(0.0, 0.1, (len(q), 6))


# ---- the law, as one writes it -----------------------------------------------------------------------------------


def matrices(arm: cr.Arm) -> tuple[list[Array], Array]:
    """The fixed transforms before each joint, and the tool's."""
    geometry = arm.description.geometry
    assert isinstance(geometry, Serial)

    def whole(transform: Transform) -> Array:
        found = np.eye(4)
        found[:3, :3], found[:3, 3] = transform.rotation, transform.translation
        return found

    return [whole(t) for t in geometry.placements], whole(geometry.tool)


def kinematics(before: list[Array], tool: Array, q: Array) -> tuple[Array, Array]:
    """Pose and Jacobian in NumPy."""
    frame, axes, origins = np.eye(4), [], []
    for placement, angle in zip(before, q, strict=True):
        frame = frame @ placement
        axes.append(frame[:3, 2])
        origins.append(frame[:3, 3])
        c, s = np.cos(angle), np.sin(angle)
        frame = frame @ np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    frame = frame @ tool
    z = np.array(axes)
    return frame, np.concatenate([np.cross(z, frame[:3, 3] - np.array(origins)), z], axis=1).T


def manipulability(jacobian: Array) -> float:
    """sqrt(det(J J^T))."""
    return float(np.sqrt(np.linalg.det(jacobian @ jacobian.T)))


def central(before: list[Array], tool: Array, q: Array, step: float = 1e-6) -> Array:
    """grad H by central differences."""
    found = np.empty(len(q))
    for k in range(len(q)):
        ahead, behind = q.copy(), q.copy()
        ahead[k] += step
        behind[k] -= step
        rise = manipulability(kinematics(before, tool, ahead)[1]) - manipulability(kinematics(before, tool, behind)[1])
        found[k] = rise / (2 * step)
    return found


def exact(jacobian: Array, inverse: Array) -> Array:
    """grad H = H tr(J+ dJ/dq_k), from the columns of J."""
    n = jacobian.shape[1]
    v, z = jacobian[:3].T, jacobian[3:].T
    later = np.arange(n)[:, None] >= np.arange(n)  # joint i moves with joint k
    change = np.zeros((n, n, 6))  # of column i with q_k
    change[..., :3] = np.where(later[..., None], np.cross(z[None], v[:, None]), np.cross(z[:, None], v[None]))
    change[..., 3:] = np.where(later[..., None], np.cross(z[None], z[:, None]), 0.0)
    return manipulability(jacobian) * np.einsum("ir,ikr->k", inverse, change)


def scaled(jacobian: Array, gradient: Array) -> Array:
    """What the law projects, from the gradient of H."""
    factor: float = GAIN * -0.5 * manipulability(jacobian) ** -1.5
    return factor * gradient


def rates(
    jacobian: Array,
    inverse: Array,
    pose: Array,
    held: Array,
    velocity: Array,
    uphill: Array,
    feedback: float = FEEDBACK,
) -> Array:
    """The law, with ``uphill`` to be projected."""
    turn = pose[:3, :3] @ held[:3, :3].T
    half = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    error = np.concatenate([pose[:3, 3] - held[:3, 3], half / np.sqrt(1.0 + np.trace(turn))])
    projected: Array = inverse @ (velocity - feedback * error - jacobian @ uphill) + uphill
    return projected


def by_differences(before: list[Array], tool: Array) -> Callable[[Array, Array, Array], Array]:
    """NumPy's pinv and central differences."""

    def one(q: Array, held: Array, velocity: Array) -> Array:
        pose, jacobian = kinematics(before, tool, q)
        return rates(
            jacobian, np.linalg.pinv(jacobian), pose, held, velocity, scaled(jacobian, central(before, tool, q))
        )

    return one


def by_exact_gradient(before: list[Array], tool: Array) -> Callable[[Array, Array, Array], Array]:
    """NumPy's pinv and the exact gradient."""

    def one(q: Array, held: Array, velocity: Array) -> Array:
        pose, jacobian = kinematics(before, tool, q)
        inverse = np.linalg.pinv(jacobian)
        return rates(jacobian, inverse, pose, held, velocity, scaled(jacobian, exact(jacobian, inverse)))

    return one


def by_pinv(before: list[Array], tool: Array) -> Callable[[Array, Array, Array], Array]:
    """NumPy's pinv alone."""

    def one(q: Array, held: Array, velocity: Array) -> Array:
        pose, jacobian = kinematics(before, tool, q)
        return rates(jacobian, np.linalg.pinv(jacobian), pose, held, velocity, np.zeros(len(q)), AT_ONCE)

    return one


def by_pinocchio(before: list[Array], tool: Array) -> Callable[[Array, Array, Array], Array]:
    """Pinocchio's pose and Jacobian, the rest in NumPy."""
    import pinocchio as pin

    model, joint = pin.Model(), 0
    for k, placement in enumerate(before):
        joint = model.addJoint(joint, pin.JointModelRZ(), pin.SE3(placement), f"joint{k + 1}")
    frame = model.addFrame(pin.Frame("tool", joint, pin.SE3(tool), pin.FrameType.OP_FRAME))
    data, axes = model.createData(), pin.ReferenceFrame.LOCAL_WORLD_ALIGNED

    def one(q: Array, held: Array, velocity: Array) -> Array:
        pin.computeJointJacobians(model, data, q)
        pose = pin.updateFramePlacement(model, data, frame).homogeneous
        jacobian = pin.getFrameJacobian(model, data, frame, axes)
        inverse = np.linalg.pinv(jacobian)
        return rates(jacobian, inverse, pose, held, velocity, scaled(jacobian, exact(jacobian, inverse)))

    return one


def by_casadi(before: list[Array], tool: Array) -> Any:
    """The whole law as one CasADi function of q, held and velocity."""
    import casadi as ca

    q, held, velocity = ca.SX.sym("q", len(before)), ca.SX.sym("held", 4, 4), ca.SX.sym("velocity", 6)
    frame, axes, origins = ca.SX.eye(4), [], []
    for placement, angle in zip(before, ca.vertsplit(q), strict=True):
        frame = frame @ ca.SX(ca.sparsify(ca.DM(placement)))
        axes.append(frame[:3, 2])
        origins.append(frame[:3, 3])
        turn = ca.SX.eye(4)
        turn[0, 0], turn[0, 1], turn[1, 0], turn[1, 1] = ca.cos(angle), -ca.sin(angle), ca.sin(angle), ca.cos(angle)
        frame = frame @ turn
    frame = frame @ ca.SX(ca.sparsify(ca.DM(tool)))
    tip = frame[:3, 3]
    linear = ca.horzcat(*(ca.cross(z, tip - o) for z, o in zip(axes, origins, strict=True)))
    jacobian = ca.vertcat(linear, ca.horzcat(*axes))
    product = jacobian @ jacobian.T
    factors, lower, order = ca.ldl(product)
    h = 1
    for factor in ca.vertsplit(factors):
        h = h * factor
    uphill = GAIN * ca.gradient(ca.sqrt(h) ** -0.5, q)
    apart = frame[:3, :3] @ held[:3, :3].T
    half = ca.vertcat(apart[2, 1] - apart[1, 2], apart[0, 2] - apart[2, 0], apart[1, 0] - apart[0, 1])
    error = ca.vertcat(tip - held[:3, 3], half / ca.sqrt(1 + ca.trace(apart)))
    wanted = velocity - FEEDBACK * error - jacobian @ uphill
    found = jacobian.T @ ca.ldl_solve(wanted, factors, lower, order) + uphill
    return ca.Function("step", [q, held, velocity], ca.cse([ca.densify(found)]))


# ---- the 8R arm --------------------------------------------------------------------------------------------------


def batches(q: Array, held: Array, velocity: Array) -> tuple[list[Way], str]:
    """Many steps: ours at once, NumPy's in a loop, CasADi's mapped."""
    arm = cr.load("sanchez_8r")
    stepper = Stepper(arm, LAW)
    kept = stepper(q, held, velocity, DT)
    ways = [
        Way(
            "chainrule, Stepper",
            len(q),
            lambda: stepper(q, held, velocity, DT, out=kept),
            lambda: (stepper(q, held, velocity, DT).rates,),
        )
    ]
    parts = matrices(arm)
    makers: list[tuple[str, Callable[..., Any], int, float, float]] = [
        ("NumPy, pinv and central differences", by_differences, 50, CENTRAL, DIFFERENCES),
        ("NumPy, pinv and the exact gradient", by_exact_gradient, 200, EXACT, 1e-8),
        ("Pinocchio's Jacobian, the rest in NumPy", by_pinocchio, 200, 0.0, 1e-8),
    ]
    notes = []
    for who, make, most, least, tolerance in makers:
        try:
            ways.append(looped(f"{who}, a loop", make(*parts), q[:most], held, velocity, least, tolerance))
        except ImportError as reason:
            notes.append(f"{who} is left out: {reason}.")
    ways.append(mapped(by_casadi(*parts), q[:20000], held, velocity))
    return ways, " ".join(notes)


def looped(
    who: str,
    one: Callable[[Array, Array, Array], Array],
    q: Array,
    held: Array,
    velocity: Array,
    least: float,
    tolerance: float,
) -> Way:
    """A way that does one step at a time."""

    def loop() -> list[Array]:
        return [one(q[k], held[k], velocity[k]) for k in range(len(q))]

    return Way(who, len(q), loop, lambda: (np.stack(loop()),), least, tolerance=tolerance)


def mapped(function: Any, q: Array, held: Array, velocity: Array) -> Way:
    """CasADi's virtual machine over a batch."""
    import casadi as ca

    count = len(q)
    many = function.map(count)
    given = (ca.DM(q.T), ca.DM(held[:count].transpose(1, 0, 2).reshape(4, 4 * count)), ca.DM(velocity[:count].T))
    return Way("CasADi, virtual machine", count, lambda: many(*given), lambda: (np.asarray(many(*given)).T,))


def singles(q: Array, held: Array, velocity: Array) -> list[Way]:
    """One step, called from Python."""
    arm = cr.load("sanchez_8r")
    stepper = Stepper(arm, LAW)
    loop = stepper.bind(DT)
    one = (q[0], held[0], velocity[0])
    loop.q[:], loop.held[:], loop.velocity[:] = one

    def bound() -> tuple[Array, ...]:
        loop()
        return (loop.rates[None].copy(),)

    function = by_casadi(*matrices(arm))
    result = np.zeros(8)
    buffer, call = function.buffer()
    columns = [np.asfortranarray(array) for array in one]
    for k, array in enumerate(columns):
        buffer.set_arg(k, array.T.data if array.ndim > 1 else array.data)
    buffer.set_res(0, result.data)

    def buffered() -> tuple[Array, ...]:
        call()
        return (result[None].copy(),)

    # what is timed is `call` itself; `buffered` keeps the buffer and the arrays alive
    buffered.kept = (buffer, columns)  # type: ignore[attr-defined]
    numpy_one = by_exact_gradient(*matrices(arm))
    return [
        Way("chainrule, Stepper.bind", 1, loop, bound),
        Way("chainrule, Stepper", 1, lambda: stepper(*one, DT), lambda: (stepper(*one, DT).rates[None],)),
        Way("CasADi, virtual machine, buffered", 1, call, buffered),
        Way("NumPy, pinv and the exact gradient", 1, lambda: numpy_one(*one), lambda: (numpy_one(*one)[None],)),
    ]


# ---- the Panda, beside Pink and PlaCo ----------------------------------------------------------------------------


def of_panda(batch: int, least: float) -> tuple[list[Way], str]:
    """The Panda's step to a target; Pink and PlaCo, which solve a quadratic program, where they are installed."""
    arm, many = cr.load("panda"), least == PLACO_BATCH
    held = arm.pose(REST + 0.001)  # near: the errors are lengths and angles here, a screw for Pink
    q = REST + np.random.default_rng(2).uniform(-0.3, 0.3, (batch if many else 1, arm.n))
    q[0] = REST
    ways = []
    damping = Damping("constant", REGULARIZATION**0.5)
    for law, words in ((Law(feedback=(AT_ONCE,) * 2), ""), (Law({}, (AT_ONCE,) * 2, damping), ", damped as PlaCo's")):
        stepper = Stepper(arm, law)
        ways += of_batch(stepper, words, q, held) if many else of_one(stepper, words, held)
    notes = []
    for peer in (placo, pink):
        try:
            ways.append(peer(arm, held, least if peer is placo else 0.0))
        except ImportError as reason:
            notes.append(f"{peer.__name__} is left out: {reason}.")
    one, still = by_pinv(*matrices(arm)), np.zeros(6)
    ways.append(
        Way("NumPy, pinv", 1, lambda: one(REST, held, still), lambda: (one(REST, held, still)[None],), tolerance=1e-8)
    )
    return ways, " ".join(notes)


def of_batch(stepper: Stepper, words: str, q: Array, held: Array) -> list[Way]:
    """Many steps at once, in double and in float32."""
    found = []
    for real, more, tolerance in ((np.float64, "", NEARLY), (np.float32, ", float32", 2e-3)):
        given = (q.astype(real), held.astype(real), None, DT)
        kept = stepper(*given)

        def call(given: Any = given, kept: Any = kept) -> object:
            return stepper(*given, out=kept)

        def results(given: Any = given) -> tuple[Array, ...]:
            return (stepper(*given).rates,)

        found.append(Way(f"chainrule, Stepper{words}{more}", len(q), call, results, tolerance=tolerance))
    return found


def of_one(stepper: Stepper, words: str, held: Array) -> list[Way]:
    """One step, called from Python."""
    loop = stepper.bind(DT)
    loop.q[:], loop.held[:] = REST, held

    def bound() -> tuple[Array, ...]:
        loop()
        return (loop.rates[None].copy(),)

    def called() -> tuple[Array, ...]:
        return (stepper(REST, held, None, DT).rates[None],)

    return [
        Way(f"chainrule, Stepper.bind{words}", 1, loop, bound, tolerance=NEARLY),
        Way(f"chainrule, Stepper{words}", 1, lambda: stepper(REST, held, None, DT), called, tolerance=NEARLY),
    ]


def urdf(arm: cr.Arm) -> str:
    """The arm as a URDF without masses, for peers that read nothing else."""
    before, tool = matrices(arm)

    def joint(name: str, kind: str, parent: str, child: str, at: Array) -> str:
        r = at[:3, :3]
        rpy = (np.arctan2(r[2, 1], r[2, 2]), np.arcsin(-np.clip(r[2, 0], -1.0, 1.0)), np.arctan2(r[1, 0], r[0, 0]))
        numbers = [" ".join(repr(float(x)) for x in triple) for triple in (at[:3, 3], rpy)]
        return (
            f'<link name="{child}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" '
            f'iyz="0"/></inertial></link><joint name="{name}" type="{kind}"><parent link="{parent}"/>'
            f'<child link="{child}"/><origin xyz="{numbers[0]}" rpy="{numbers[1]}"/><axis xyz="0 0 1"/>'
            '<limit lower="-6" upper="6" velocity="100" effort="100"/></joint>'
        )

    parts = [joint(f"joint{k + 1}", "revolute", f"link{k}", f"link{k + 1}", at) for k, at in enumerate(before)]
    parts.append(joint("held", "fixed", f"link{arm.n}", "tool", tool))
    return f'<robot name="{arm.name}"><link name="link0"/>{"".join(parts)}</robot>'


def placo(arm: cr.Arm, held: Array, least: float) -> Way:
    """PlaCo's kinematics solver: one soft frame task, no limits."""
    import placo as library

    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "robot.urdf").write_text(urdf(arm), "utf-8")
        robot = library.RobotWrapper(folder, library.Flags.ignore_collisions)
    solver = library.KinematicsSolver(robot)
    solver.mask_fbase(True)
    solver.enable_joint_limits(False)
    solver.enable_velocity_limits(False)
    solver.add_frame_task("tool", held).configure("tool", "soft", 1.0, 1.0)
    solver.add_regularization_task(REGULARIZATION)
    for k, angle in enumerate(REST):
        robot.set_joint(f"joint{k + 1}", angle)
    robot.update_kinematics()

    def step() -> None:
        solver.solve(True)
        robot.update_kinematics()

    rates = solver.solve(False)[-len(REST) :][None] / DT  # before the robot moves
    step.kept = robot  # type: ignore[attr-defined]
    return Way("PlaCo, KinematicsSolver", 1, step, lambda: (rates,), least, tolerance=NEARLY)


def pink(arm: cr.Arm, held: Array, least: float) -> Way:
    """Pink's solve_ik: one frame task, the first solver that is installed."""
    import pink as library
    import pinocchio as pin
    import qpsolvers

    model = pin.buildModelFromXML(urdf(arm))
    task = library.tasks.FrameTask("tool", position_cost=1.0, orientation_cost=1.0)
    task.set_target(pin.SE3(held))
    if not qpsolvers.available_solvers:
        raise ImportError("qpsolvers has no solver")
    solver, data = qpsolvers.available_solvers[0], model.createData()

    def step() -> Array:
        configuration = library.Configuration(model, data, REST)
        rates: Array = library.solve_ik(configuration, [task], DT, solver=solver, safety_break=False)
        return rates

    return Way(f"Pink, solve_ik with {solver}", 1, step, lambda: (step()[None],), least, tolerance=NEARLY)
