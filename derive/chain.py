"""Any serial chain: frames, pose, position and geometric Jacobian, as named steps.

Conventions: modified Denavit-Hartenberg frames or fixed transforms before each joint; a revolute joint turns
about its z axis, a prismatic one shifts along it; Jacobian rows are (v; omega) in the base frame.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from chainrule.derive.program import Expression, Input, Matrix, Output, Program, Steps, exact, variables
from chainrule.derive.view import View, identity
from chainrule.description import Transform

Vector = list[Expression]


@dataclass(frozen=True)
class Frame:
    """A frame: the columns x, y, z of its rotation and its origin p, in the frame the derivation starts from."""

    x: Vector
    y: Vector
    z: Vector
    p: Vector


@dataclass(frozen=True)
class Link:
    """A fixed transform with exact entries: ``rotation[i][j]`` and ``translation[i]`` (numbers or symbols)."""

    rotation: tuple[tuple[Expression, ...], ...]
    translation: tuple[Expression, ...]


@dataclass(frozen=True)
class Chain:
    """A symbolic serial chain: joint kinds, the link before each joint, and the tool."""

    kinds: str
    links: tuple[Link, ...]
    tool: Link
    inputs: tuple[Input, ...]

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.kinds)

    @property
    def q(self) -> tuple[Expression, ...]:
        """The joint variables."""
        return self.inputs[0].symbols


def link(transform: Transform) -> Link:
    """The exact value of a description's transform."""
    return Link(
        tuple(tuple(exact(entry) for entry in row) for row in transform.rotation),
        tuple(exact(entry) for entry in transform.translation),
    )


def chain(kinds: str, placements: tuple[Transform, ...], tool: Transform) -> Chain:
    """The symbolic chain of a description's fixed transforms; input ``q`` (n,)."""
    return Chain(kinds, tuple(link(t) for t in placements), link(tool), (variables("q", len(kinds)),))


def cross(a: Vector, b: Vector) -> Vector:
    """a x b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def combine(coefficients: tuple[Expression, ...], vectors: tuple[Vector, ...]) -> Vector:
    """The linear combination of vectors."""
    return [sum((c * v[i] for c, v in zip(coefficients, vectors, strict=True)), sp.Integer(0)) for i in range(3)]


IDENTITY = Frame(
    [sp.Integer(1), sp.Integer(0), sp.Integer(0)],
    [sp.Integer(0), sp.Integer(1), sp.Integer(0)],
    [sp.Integer(0), sp.Integer(0), sp.Integer(1)],
    [sp.Integer(0), sp.Integer(0), sp.Integer(0)],
)


def sine_cosine(steps: Steps, arm: Chain, i: int) -> tuple[Expression, Expression]:
    """Steps sin(q_i) and cos(q_i)."""
    return steps.let(f"s{i + 1}", sp.sin(arm.q[i])), steps.let(f"c{i + 1}", sp.cos(arm.q[i]))


def through(steps: Steps, frame: Frame, link: Link, name: str) -> Frame:
    """The frame after a fixed transform."""
    columns = [tuple(link.rotation[i][j] for i in range(3)) for j in range(3)]
    old = (frame.x, frame.y, frame.z)
    x, y, z = (steps.vector(f"{axis}{name}", combine(c, old)) for axis, c in zip("xyz", columns, strict=True))
    shift = combine(link.translation, old)
    return Frame(x, y, z, steps.vector(f"p{name}", [a + b for a, b in zip(frame.p, shift, strict=True)]))


def moved(steps: Steps, arm: Chain, frame: Frame, i: int, sign: int = 1) -> Frame:
    """The frame after the motion of joint i (before it, for sign -1)."""
    if arm.kinds[i] == "P":
        return Frame(
            frame.x,
            frame.y,
            frame.z,
            steps.vector(f"p{i + 1}_", [p + sign * arm.q[i] * z for p, z in zip(frame.p, frame.z, strict=True)]),
        )
    s, c = sine_cosine(steps, arm, i)
    s = sign * s
    x = steps.vector(f"x{i + 1}_", [c * a + s * b for a, b in zip(frame.x, frame.y, strict=True)])
    y = steps.vector(f"y{i + 1}_", [c * b - s * a for a, b in zip(frame.x, frame.y, strict=True)])
    return Frame(x, y, frame.z, frame.p)


def before(steps: Steps, frame: Frame, link: Link, name: str) -> Frame:
    """The frame before a fixed transform (its inverse applied)."""
    rows = tuple(tuple(link.rotation[j]) for j in range(3))
    old = (frame.x, frame.y, frame.z)
    x, y, z = (steps.vector(f"{axis}{name}", combine(r, old)) for axis, r in zip("xyz", rows, strict=True))
    shift = combine(link.translation, (x, y, z))
    return Frame(x, y, z, steps.vector(f"p{name}", [a - b for a, b in zip(frame.p, shift, strict=True)]))


@dataclass(frozen=True)
class Frames:
    """Joint frames (z is the joint's axis, p a point on it) and the tip, all seen from one frame."""

    joints: list[Frame]
    tip: Frame


def frames_from_base(steps: Steps, arm: Chain) -> Frames:
    """Every joint's frame and the tip, in the base frame."""
    frame, joints = IDENTITY, []
    for i in range(arm.n):
        frame = through(steps, frame, arm.links[i], str(i + 1))
        joints.append(frame)
        frame = moved(steps, arm, frame, i)
    return Frames(joints, through(steps, frame, arm.tool, "e"))


def frames_from_link(steps: Steps, arm: Chain, k: int) -> Frames:
    """Every joint's frame and the tip, in the moved frame of joint k (0-based).

    Seen from inside the arm, the axes of joints 1 .. k+1 do not depend on q_1, and few entries depend on many
    joints; determinants of Jacobian columns are the same in every frame.
    """
    joints: list[Frame | None] = [None] * arm.n
    frame = IDENTITY
    for i in range(k, -1, -1):
        joints[i] = frame  # the axis z and its point are the same before and after the joint's own motion
        if i > 0:
            frame = before(steps, moved(steps, arm, frame, i, sign=-1), arm.links[i], f"{i}b")
    frame = IDENTITY
    for i in range(k + 1, arm.n):
        frame = through(steps, frame, arm.links[i], f"{i + 1}f")
        joints[i] = frame
        frame = moved(steps, arm, frame, i)
    return Frames([f for f in joints if f is not None], through(steps, frame, arm.tool, "ef"))


def linear_columns(steps: Steps, arm: Chain, frames: Frames, name: str = "v") -> list[Vector]:
    """Velocity of the tip's origin for a unit rate of each joint: z_i x (p_e - p_i), or z_i."""
    columns = []
    for i, frame in enumerate(frames.joints):
        if arm.kinds[i] == "P":
            columns.append(frame.z)
            continue
        arm_vector = steps.vector(f"r{i + 1}", [a - b for a, b in zip(frames.tip.p, frame.p, strict=True)])
        columns.append(steps.vector(f"{name}{i + 1}", cross(frame.z, arm_vector)))
    return columns


def angular_columns(arm: Chain, frames: Frames) -> list[Vector]:
    """Angular velocity for a unit rate of each joint: z_i, or zero."""
    return [frame.z if arm.kinds[i] == "R" else [sp.Integer(0)] * 3 for i, frame in enumerate(frames.joints)]


def pose_entries(tip: Frame) -> tuple[Expression, ...]:
    """The 4 x 4 homogeneous matrix, row by row."""
    rows = [[tip.x[i], tip.y[i], tip.z[i], tip.p[i]] for i in range(3)]
    return (*(entry for row in rows for entry in row), *(sp.Integer(i == 3) for i in range(4)))


def by_rows(columns: list[Vector]) -> tuple[Expression, ...]:
    """Entries of a matrix given by columns, row by row."""
    return tuple(column[i] for i in range(len(columns[0])) for column in columns)


def jacobian_output(steps: Steps, arm: Chain, frames: Frames, task: str) -> Output:
    """Output ``jacobian``: (6, n) rows (v; omega) for the pose, (3, n) for the position."""
    rows = by_rows(linear_columns(steps, arm, frames))
    if task == "pose":
        rows += by_rows(angular_columns(arm, frames))
    return Output("jacobian", (len(rows) // arm.n, arm.n), rows)


def place_output(frames: Frames, task: str) -> Output:
    """Output ``pose`` (4, 4) or ``position`` (3,)."""
    return (
        Output("pose", (4, 4), pose_entries(frames.tip))
        if task == "pose"
        else Output("position", (3,), tuple(frames.tip.p))
    )


def placement(arm: Chain, task: str) -> Program:
    """Pose or position of the tip in the base frame."""
    steps = Steps()
    output = place_output(frames_from_base(steps, arm), task)
    return Program(
        output.name, f"{output.name} of the tip, in the base frame", arm.inputs, tuple(steps.steps), (output,)
    )


def jacobian(arm: Chain, task: str) -> Program:
    """The task Jacobian."""
    steps = Steps()
    frames = frames_from_base(steps, arm)
    output = jacobian_output(steps, arm, frames, task)
    return Program(
        f"jacobian_{task}", f"Jacobian of the {task}, in the base frame", arm.inputs, tuple(steps.steps), (output,)
    )


def kinematics(arm: Chain, task: str) -> Program:
    """Pose (or position) and Jacobian together, sharing every step."""
    steps = Steps()
    frames = frames_from_base(steps, arm)
    place = place_output(frames, task)
    output = jacobian_output(steps, arm, frames, task)
    return Program(
        f"kinematics_{task}",
        f"{place.name} and its Jacobian, in the base frame",
        arm.inputs,
        tuple(steps.steps),
        (place, output),
    )


def minor_matrix(steps: Steps, arm: Chain, task: str) -> Matrix:
    """Rows of a matrix with the minors and the row space of the task Jacobian, seen from the best inner link.

    A rotation of the frame, and for the pose a move of its origin, has determinant one. The link is chosen
    that leaves the most zeros; q_1 never appears, and for the pose neither does q_n.
    """
    return _matrix_from(steps, arm, task, _inner_link(arm, task))


def minor_view(steps: Steps, arm: Chain, task: str) -> View:
    """How a velocity of the task becomes the one that :func:`minor_matrix` times the joints' rates is."""
    k = _inner_link(arm, task)
    base = moved(steps, arm, frames_from_base(steps, arm).joints[k], k)
    turn = [list(base.x), list(base.y), list(base.z)]  # R^T: the link's axes, by rows
    none = [sp.Integer(0)] * 3
    if task == "position":
        return View(turn, identity(3))
    a, b, c = frames_from_link(steps, arm, k).tip.p
    zero = sp.Integer(0)
    lever = [[zero, -c, b], [c, zero, -a], [-b, a, zero]]  # tip x: the link's origin moves at v + tip x omega
    move = identity(6)
    for i in range(3):
        move[i][3:] = lever[i]
    return View([row + none for row in turn] + [none + row for row in turn], move)


def _inner_link(arm: Chain, task: str) -> int:
    """The link from which the matrix has the most zeros."""
    candidates = range(arm.n) if arm.n <= 10 else (arm.n // 2,)
    return max(candidates, key=lambda k: (sum(e == 0 for row in _matrix_from(Steps(), arm, task, k) for e in row), -k))


def _matrix_from(steps: Steps, arm: Chain, task: str, k: int) -> Matrix:
    frames = frames_from_link(steps, arm, k)
    if task == "position":
        columns = linear_columns(steps, arm, frames)
    else:
        moments = [
            f.z if kind == "P" else steps.vector(f"v{i}", cross(f.p, f.z))
            for i, (kind, f) in enumerate(zip(arm.kinds, frames.joints, strict=True), 1)
        ]
        columns = [m + a for m, a in zip(moments, angular_columns(arm, frames), strict=True)]
    return [[column[row] for column in columns] for row in range(len(columns[0]))]
