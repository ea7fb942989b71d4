"""Task paths: curves, orientations and time laws against differences and closed forms; files; refusals."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import chainrule as cr
from chainrule.errors import DescriptionError, InputError
from chainrule.redundancy.curves import Conic, Interpolated
from chainrule.redundancy.path_files import from_toml
from chainrule.redundancy.time_laws import Constant, Sampled, Trapezoid

RNG = np.random.default_rng(6)
POINTS = RNG.uniform(-1.0, 1.0, (7, 3))
TURNS = Rotation.random(7, random_state=3)
UPRIGHT: dict[str, Any] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 0.0, 1.0)}

SPATIAL: dict[str, cr.TaskPath] = {
    "line": cr.TaskPath.line(POINTS[0], POINTS[1], duration=2.0, orientation=TURNS[0].as_matrix()),
    "arc": cr.TaskPath.arc(POINTS[0], 0.3, end=2.0, **UPRIGHT, duration=2.0, ramp=0.5, orientation="tangent"),
    "circle": cr.TaskPath.circle(POINTS[0], 0.3, **UPRIGHT, speed=0.7, orientation=TURNS[:2].as_matrix()),
    "ellipse": cr.TaskPath.ellipse(POINTS[0], (0.3, 0.1), **UPRIGHT, duration=3.0, orientation="tangent"),
    "ellipse by angle": cr.TaskPath.ellipse(POINTS[0], (0.3, 0.1), duration=3.0, pace="parameter"),
    "polyline": cr.TaskPath.polyline(POINTS, 0.05, duration=3.0, orientation=TURNS),
    "spline": cr.TaskPath.spline(POINTS, closed=True, speed=1.0, acceleration=2.0),
    "poses": cr.TaskPath.poses(POINTS, TURNS, duration=2.0),
    "placed": cr.TaskPath.along(
        cr.Ellipse((0.1, 0.2), (0.3, 0.2)), origin=POINTS[0], duration=2.0, orientation="tangent"
    ),
    "samples": cr.TaskPath.samples(np.linspace(0.0, 3.0, 7) ** 1.1, POINTS, TURNS),
    "sampled law": cr.TaskPath.line(POINTS[0], POINTS[1], law=Sampled([0.0, 0.4, 1.0, 2.0], [0.0, 0.1, 0.5, 1.0])),
}
PLANAR: dict[str, cr.TaskPath] = {
    "line": cr.TaskPath.line((0.1, 0.2), (1.0, -0.3), duration=2.0, orientation=[0.3, 1.0]),
    "ring": cr.TaskPath.ellipse((0.1, 0.2), (0.5, 0.2), duration=2.0, orientation="tangent"),
    "curve": cr.TaskPath.along(cr.Spline(POINTS[:, :2]), duration=2.0, orientation="tangent"),
    "poses": cr.TaskPath.poses(POINTS[:, :2], [0.0, 3.0, -3.0, -2.0, 2.0, 0.0, 1.0], duration=2.0),
}


def inner_times(path: cr.TaskPath) -> Any:
    """Times away from the places where a velocity jumps (they are few, and random times miss them)."""
    return np.sort(np.random.default_rng(1).uniform(0.02, 0.98, 40)) * path.duration


@pytest.mark.parametrize("quarters", [4, 5, 8, 12, -7, 400])
def test_several_turns_may_be_meant(quarters):
    """So many quarter turns, in Python and in a file in degrees; at most a turn for other angles."""
    arc = cr.TaskPath.arc((0.0, 0.0, 0.0), 0.5, start=0.3, end=0.3 + quarters * np.pi / 2.0, speed=0.1)
    assert arc.length == pytest.approx(abs(quarters) * np.pi / 4.0, rel=1e-12)
    text = f"""task_path = 1
kind = "arc"
angles = "deg"
centre = [0, 0, 0]
radius = 0.5
end = {90 * quarters}
time.speed = 0.1
"""
    assert from_toml(text.encode()).length == pytest.approx(arc.length, rel=1e-12)
    assert cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, start=5.0, end=11.2, speed=0.1).length == pytest.approx(6.2)


@pytest.mark.parametrize("name", SPATIAL)
def test_velocities_are_the_derivatives_of_poses(name: str) -> None:
    path = SPATIAL[name]
    t, h = inner_times(path), 1e-6 * path.duration
    task = "position" if path.turning is None else "pose"
    before, after = (path.sample(t + sign * h, task).held for sign in (-1.0, 1.0))
    velocity = path.sample(t, task).velocity
    if task == "position":
        np.testing.assert_allclose((after - before) / (2.0 * h), velocity, atol=2e-6 * np.abs(velocity).max())
        return
    moved = (after[:, :3, 3] - before[:, :3, 3]) / (2.0 * h)
    turned = Rotation.from_matrix(after[:, :3, :3] @ np.swapaxes(before[:, :3, :3], 1, 2)).as_rotvec() / (2.0 * h)
    scale = np.abs(velocity).max()
    np.testing.assert_allclose(np.concatenate([moved, turned], axis=1), velocity, atol=3e-6 * scale)


@pytest.mark.parametrize("name", PLANAR)
@pytest.mark.parametrize("task", ["pose", "x_alpha", "position"])
def test_planar_velocities_are_the_derivatives_of_targets(name: str, task: str) -> None:
    path = PLANAR[name]
    t, h = inner_times(path), 1e-6 * path.duration
    difference = path.sample(t + h, task).held - path.sample(t - h, task).held
    if task != "position":
        difference[:, -1] = np.remainder(difference[:, -1] + np.pi, 2.0 * np.pi) - np.pi
    velocity = path.sample(t, task).velocity
    np.testing.assert_allclose(difference / (2.0 * h), velocity, atol=3e-6 * np.abs(velocity).max())


@pytest.mark.parametrize("name", [name for name in SPATIAL if name not in ("ellipse by angle", "poses", "samples")])
def test_the_arc_length_grows_as_the_time_law_says(name: str) -> None:
    path = SPATIAL[name]
    t = inner_times(path)
    speed = np.linalg.norm(path.sample(t, "position").velocity, axis=1)
    np.testing.assert_allclose(speed, path.length * path.law.at(t)[1], rtol=1e-9)


def test_rotations_are_rotations() -> None:
    for path in SPATIAL.values():
        if path.turning is not None:
            turned = path.sample(inner_times(path)).held[:, :3, :3]
            np.testing.assert_allclose(
                turned @ np.swapaxes(turned, 1, 2), np.broadcast_to(np.eye(3), turned.shape), atol=1e-14
            )
            np.testing.assert_allclose(np.linalg.det(turned), 1.0, atol=1e-14)


def test_the_thesis_paths_in_closed_form() -> None:
    i = np.arange(300)
    theta = np.pi * i / 299
    path = cr.TaskPath.arc((0.0, 0.05, -0.25), 0.25, end=np.pi, y=(0.0, 0.0, 1.0), duration=2.0)
    found = path.sample(2.0 * i / 299, "position")
    expected = np.stack([0.25 * np.cos(theta), np.full(300, 0.05), -0.25 + 0.25 * np.sin(theta)], axis=1)
    np.testing.assert_allclose(found.held, expected, rtol=0, atol=1e-15)
    slope = np.pi / 2.0 * 0.25 * np.stack([-np.sin(theta), np.zeros(300), np.cos(theta)], axis=1)
    np.testing.assert_allclose(found.velocity, slope, rtol=0, atol=1e-15)


def test_the_length_of_an_ellipse_is_the_elliptic_integral() -> None:
    path = cr.TaskPath.ellipse((0.0, 0.0, 0.0), (2.0, 0.7), duration=1.0)
    with mpmath.workdps(40):
        expected = float(4 * 2 * mpmath.ellipe(1 - mpmath.mpf("0.7") ** 2 / 4))
    assert abs(path.length - expected) < 1e-12 * expected
    by_angle = cr.TaskPath.ellipse((0.0, 0.0, 0.0), (2.0, 0.7), duration=1.0, pace="parameter")
    assert not np.allclose(by_angle.sample([0.05]).held, path.sample([0.05]).held, atol=1e-3)
    np.testing.assert_allclose(by_angle.sample([0.125]).held, [[np.sqrt(2.0), 0.7 / np.sqrt(2.0), 0.0]], atol=1e-15)


def test_slerp_turns_at_a_constant_rate_by_the_shortest_way() -> None:
    first, second = TURNS[0], TURNS[1]
    path = cr.TaskPath.line(
        POINTS[0], POINTS[1], duration=2.0, orientation=np.stack([first.as_matrix(), second.as_matrix()])
    )
    held, velocity = path.sample(np.linspace(0.0, 2.0, 9))
    turn = (second * first.inv()).as_rotvec()
    np.testing.assert_allclose(velocity[:, 3:], np.broadcast_to(turn / 2.0, (9, 3)), atol=1e-14)
    expected = Rotation.from_rotvec(turn * 0.25) * first
    np.testing.assert_allclose(held[2, :3, :3], expected.as_matrix(), atol=1e-14)


def test_splines_and_poses_pass_through_what_was_given() -> None:
    path = SPATIAL["samples"]
    held = path.sample(np.linspace(0.0, 3.0, 7) ** 1.1).held
    np.testing.assert_allclose(held[:, :3, 3], POINTS, atol=1e-13)
    np.testing.assert_allclose(held[:, :3, :3], TURNS.as_matrix(), atol=1e-13)
    curve = SPATIAL["poses"].curve
    assert isinstance(curve, Interpolated)
    u = np.concatenate([[0.0], np.cumsum(_ways(POINTS, TURNS))])
    np.testing.assert_allclose(curve.at(u)[0], POINTS, atol=1e-12)


def _ways(points: Any, turns: Rotation) -> Any:
    """What the docstring of ``poses`` says of the parameter."""
    moves = np.linalg.norm(np.diff(points, axis=0), axis=1)
    angles = (turns[:-1].inv() * turns[1:]).magnitude()
    way = np.hypot(moves / moves.sum(), angles / angles.sum())
    return way / way.sum()


def test_a_polyline_keeps_its_distance_from_the_corners() -> None:
    path = cr.TaskPath.polyline(POINTS, 0.05, duration=1.0)
    held = path.sample(np.linspace(0.0, 1.0, 4001), "position").held
    gap = np.full(len(held), np.inf)
    for a, b in pairwise(POINTS):
        share = np.clip((held - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        gap = np.minimum(gap, np.linalg.norm(held - a - share[:, None] * (b - a), axis=1))
    assert 0.01 < gap.max() <= 0.05 * np.sqrt(3.0)
    assert gap.min() < 1e-15


def test_poses_that_only_turn_have_a_path_too() -> None:
    path = cr.TaskPath.poses(np.zeros((3, 3)), TURNS[:3], duration=1.0)
    held, velocity = path.sample([0.0, 0.5, 1.0])
    assert np.abs(velocity[:, :3]).max() == 0.0
    np.testing.assert_allclose(held[[0, 2], :3, :3], TURNS[[0, 2]].as_matrix(), atol=1e-14)


def test_trapezoid_in_closed_form() -> None:
    law = Trapezoid.lasting(2.0, 0.5)  # peak 1 / 1.5, ramps of 0.5
    share, rate = law.at(np.array([0.0, 0.25, 0.5, 1.0, 1.75, 2.0]))
    np.testing.assert_allclose(rate, np.array([0.0, 1 / 3, 2 / 3, 2 / 3, 1 / 3, 0.0]), atol=1e-15)
    np.testing.assert_allclose(share, [0.0, 1 / 24, 1 / 6, 0.5, 23 / 24, 1.0], atol=1e-15)
    path = cr.TaskPath.line((0.0, 0.0), (2.0, 0.0), speed=1.0, acceleration=2.0)
    assert path.duration == pytest.approx(2.5, abs=1e-15)


def test_closed_paths_say_so() -> None:
    assert cr.TaskPath.circle((0.0, 0.0, 0.0), 1.0, duration=1.0).closed
    assert not cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, duration=1.0).closed
    assert cr.TaskPath.spline(POINTS, closed=True, duration=1.0).closed
    turned = cr.TaskPath.circle((0.0, 0.0, 0.0), 1.0, duration=1.0, orientation=TURNS[:2].as_matrix())
    assert not turned.closed  # it ends in another orientation
    around = cr.TaskPath.circle((0.0, 0.0), 1.0, duration=1.0, orientation="tangent")
    assert around.closed  # alpha has grown by a turn


def test_holding_brings_the_orientation_of_a_posture() -> None:
    path = cr.TaskPath.line(POINTS[0], POINTS[1], duration=1.0)
    with pytest.raises(InputError, match="the path says no orientation"):
        path.sample([0.0], "pose")
    held = path.holding(TURNS[0].as_matrix()).sample([0.0, 1.0]).held
    np.testing.assert_allclose(held[1, :3, :3], TURNS[0].as_matrix(), atol=1e-15)
    assert path.to_dict()["time"] == {"law": "constant", "duration": 1.0}


def test_no_times_no_targets() -> None:
    found = SPATIAL["arc"].sample([])
    assert found.held.shape == (0, 4, 4) and found.velocity.shape == (0, 6)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: cr.TaskPath.line((0.0, 0.0), (0.0, 0.0), duration=1.0), "two points are accepted"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (0.0, 0.0, 1.0), duration=1.0), "2 numbers are accepted"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0)), "nothing given; duration, or speed"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=1.0, speed=1.0), "duration, speed given"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=-1.0), "a positive number is accepted"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=1.0, ramp=0.6), "up to half of the duration"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=1.0, colour=1), "no option 'colour'"),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), duration=1.0, pace="fast"), "'arc length' or 'parameter'"),
        (
            lambda: cr.TaskPath.line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), duration=1.0, orientation="tangent").sample(
                [0.0]
            ),
            "in a plane",
        ),
        (lambda: cr.TaskPath.arc((0.0, 0.0, 0.0), 0.0, duration=1.0), "a positive length"),
        (lambda: cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, end=0.0, duration=1.0), "two angles are accepted"),
        (lambda: cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, end=180, duration=1.0), "28.6 turns; rad are accepted"),
        (lambda: cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, start=90, end=-90.0, duration=1.0), "-28.6 turns; rad are"),
        (lambda: cr.TaskPath.ellipse((0.0, 0.0, 0.0), (2, 1), end=360, duration=1.0), "57.3 turns; rad are accepted"),
        (lambda: cr.TaskPath.arc((0.0, 0.0, 0.0), 1.0, x=(1.0, 1.0, 0.0), duration=1.0), "not square"),
        (lambda: cr.TaskPath.spline([[0.0, 0.0, 0.0]], duration=1.0), "k from 3"),
        (lambda: cr.TaskPath.spline([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]], duration=1.0), "numbers 1 and 2 are one"),
        (
            lambda: cr.TaskPath.polyline([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], 0.0, duration=1.0),
            "^deviation: 0; a positive number is accepted$",
        ),
        (lambda: cr.TaskPath.line((0.0, 0.0), (1.0, 0.0), law=[0.0, 1.0]), r"^law: \[0.0, 1.0\]; a TimeLaw"),
        (lambda: cr.TaskPath.poses(np.zeros((3, 3)), duration=1.0), "numbers 1 and 2 are one"),
        (lambda: cr.TaskPath.poses(POINTS, TURNS[:3], duration=1.0), "one each is accepted"),
        (lambda: cr.TaskPath.samples([0.0, 1.0, 1.0], POINTS[:3]), "times that rise from 0"),
        (
            lambda: cr.TaskPath.line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), duration=1.0, orientation=np.eye(3) * 2),
            "rotation",
        ),
        (
            lambda: cr.TaskPath.line(
                (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), duration=1.0, orientation=np.diag([1.0, 1.0, -1.0])
            ),
            "mirrors",
        ),
        (
            lambda: cr.TaskPath.line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), duration=1.0, orientation=[1.0, 1.0, 0.0, 0.0]),
            "length 1",
        ),
        (lambda: SPATIAL["line"].sample([2.5]), "from 0 to 2 s"),
        (lambda: SPATIAL["line"].sample([0.0], "x_alpha"), "task"),
        (lambda: Sampled([0.0, 1.0], [0.0, 0.9]), "share"),
        (lambda: Conic([0.0, 0.0], [1.0, 0.0], [1.0, 0.0], 0.0, 1.0), "not parallel"),
        (lambda: Constant(float("nan")), "duration"),
        (lambda: cr.TaskPath.along("circle", duration=1.0), "a path such as"),  # type: ignore[arg-type]
    ],
)
def test_what_is_no_path_is_refused(make: Any, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)


# ---- files -------------------------------------------------------------------------------------------------------

ARC = """
task_path = 1
kind = "arc"
angles = "deg"
centre = [0.0, 0.05, -0.25]
radius = 0.25
end = 180
y = [0, 0, 1]
[time]
duration = 2.0
[orientation]
rpy = [0, 90, 0]
"""


def written(folder: Path, name: str, text: str) -> Path:
    (folder / name).write_text(text, "utf-8")
    return folder / name


def test_a_path_from_toml_is_the_path_from_python(tmp_path: Path) -> None:
    found = cr.read_task_path(written(tmp_path, "arc.toml", ARC))
    turned = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])  # a quarter turn about y
    same = cr.TaskPath.arc((0.0, 0.05, -0.25), 0.25, end=np.pi, y=(0.0, 0.0, 1.0), duration=2.0, orientation=turned)
    t = np.linspace(0.0, 2.0, 7)
    for one, other in zip(found.sample(t), same.sample(t), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-15)


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        ("line", "start = [0, 0]\nend = [1, 0]\norientation.alpha = 30"),
        ("circle", "centre = [0, 0, 1]\nradius = 1\nstart = 90\norientation.tangent = true"),
        ("ellipse", 'pace = "parameter"\ncentre = [0, 0]\nsemi_axes = [2, 1]\norientation.alphas = [0, 360]'),
        ("polyline", "points = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\ndeviation = 0.1"),
        ("spline", "points = [[0, 0], [1, 0], [1, 1]]\nclosed = true"),
        (
            "line",
            "start = [0, 0, 0]\nend = [1, 0, 0]\norientation.quaternions = [[1, 0, 0, 0], [0.7071, 0.7071, 0, 0]]",
        ),
    ],
)
def test_every_kind_is_read(tmp_path: Path, kind: str, text: str) -> None:
    head = f'task_path = 1\nkind = "{kind}"\nangles = "deg"\n'
    path = cr.read_task_path(written(tmp_path, "p.toml", head + text + "\n[time]\nspeed = 0.5\nacceleration = 1.0\n"))
    assert path.made_of["kind"] == kind and np.isfinite(path.sample([0.0, path.duration]).held).all()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("task_path = 1", "", "key 'task_path': missing"),
        ("task_path = 1", "task_path = 2", "task_path = 1"),
        ('kind = "arc"', 'kind = "helix"', "key 'kind': 'helix'; line, arc"),
        ("radius = 0.25", "", "the key 'radius' is missing"),
        ("radius = 0.25", 'radius = "__import__(1)"', "key 'radius'"),
        ("radius = 0.25", "radius = -1", "a positive length"),
        ("radius = 0.25", "radius = 0.25\nlength = 2", "unknown key 'length'"),
        ("centre = [0.0, 0.05, -0.25]", "centre = [0.0]", "key 'centre'"),
        ("centre = [0.0, 0.05, -0.25]", "centre = [0.0, nan, 0]", "not finite"),
        ('angles = "deg"', "", "key 'angles': missing"),
        ("duration = 2.0", "", "nothing given"),
        ("duration = 2.0", "length = 2.0", r"\[time\]: unknown key"),
        ("[time]\nduration = 2.0", "", r"\[time\] is missing"),
        ("rpy = [0, 90, 0]", "", r"\[orientation\]: 0 keys"),
        ("rpy = [0, 90, 0]", "quaternion = [1, 1, 0, 0]", "length 1.41421"),
        ("rpy = [0, 90, 0]", "tangent = false", "true is accepted"),
    ],
)
def test_a_wrong_file_is_one_line_with_its_name(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in ARC
    file = written(tmp_path, "arc.toml", ARC.replace(old, new))
    with pytest.raises(DescriptionError, match=words) as caught:
        cr.read_task_path(file)
    assert "arc.toml" in str(caught.value) and "\n" not in str(caught.value)


def test_poses_from_csv(tmp_path: Path) -> None:
    quaternions = np.roll(TURNS.as_quat(), 1, axis=1)
    rows = [",".join(f"{x:.17g}" for x in row) for row in np.concatenate([POINTS, quaternions], axis=1)]
    path = cr.read_task_path(written(tmp_path, "poses.csv", "\n".join(rows)), duration=2.0)
    t = np.linspace(0.0, 2.0, 7)
    np.testing.assert_allclose(path.sample(t).held, SPATIAL["poses"].sample(t).held, atol=1e-12)
    named = "x,y,z\n" + "\n".join(",".join(map(repr, row)) for row in POINTS.tolist())
    only = cr.read_task_path(written(tmp_path, "points.csv", named), speed=0.5)
    assert only.turning is None and only.dimension == 3
    flat = cr.read_task_path(written(tmp_path, "flat.csv", "t, x, y, alpha\n0, 0, 0, 0\n1, 1, 0, 0.5\n3, 2, 1, 1"))
    assert flat.duration == 3.0
    np.testing.assert_allclose(flat.sample([1.0]).held, [[1.0, 0.0, 0.5]], atol=1e-14)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "0 poses"),
        ("x,y,z\n0,0,0", "1 poses"),
        ("x,y,w\n0,0,0\n1,1,1", "row 1: 'x,y,w'"),
        ("0,0,0\n1,1", "row 2: 2 entries"),
        ("0,0,0\n1,one,1", "row 2, y: 'one' is not a finite number"),
        ("0,0,0\n1,inf,1", "row 2, y: 'inf'"),
        ("t,x,y,z\n0,0,0,0\n0,1,1,1", "row 3, t: times that rise"),
        ("0,0,0,1,1,0,0\n1,1,1,1,0,0,0", "row 1: .* length 1.41421"),
        ("1,2,3,4,5\n1,2,3,4,5", "row 1: 5 entries and no names"),
        ("0,0,0\n0,0,0\n1,1,1", "numbers 1 and 2 are one"),
        ('"0,0,0', "not CSV that is accepted"),
    ],
)
def test_a_wrong_csv_is_one_line_with_its_row(tmp_path: Path, text: str, words: str) -> None:
    options = {} if text.startswith("t") else {"duration": 1.0}
    with pytest.raises(InputError, match=words) as caught:
        cr.read_task_path(written(tmp_path, "p.csv", text), **options)
    assert "p.csv" in str(caught.value) and "\n" not in str(caught.value)


def test_files_of_other_kinds_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match=r"\.toml or \.csv"):
        cr.read_task_path(tmp_path / "path.yaml")
    with pytest.raises(DescriptionError, match="says it itself"):
        cr.read_task_path(written(tmp_path, "arc.toml", ARC), duration=1.0)
    (tmp_path / "bad.csv").write_bytes(b"x,y\n\xff\xfe,0\n")
    with pytest.raises(DescriptionError, match="row 2: not UTF-8"):
        cr.read_task_path(tmp_path / "bad.csv", duration=1.0)
