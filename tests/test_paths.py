"""Paths by arc length: against mpmath, closed forms and brute force; files; refusals."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path as File
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.interpolate import PPoly
from scipy.special import ellipe

from chainrule.errors import DescriptionError, InputError
from chainrule.parametric_paths import Curve, Ellipse, Spline
from chainrule.paths import Arc, Circle, Line, Path, arc_frame, arc_locate, unit
from chainrule.readers.paths import from_csv, from_toml, read_path

POINTS = np.random.default_rng(7).uniform(0.0, 1.0, (9, 2))
SHAPES = {
    "open spline": lambda: Spline(POINTS),
    "closed spline": lambda: Spline(POINTS[:7], closed=True),
    "polynomial": lambda: Spline([(0.0, 0.0), (1.0, 0.3), (2.0, 0.0)]),
    "ellipse": lambda: Ellipse((0.3, -0.2), (0.8, 0.15), rotation=0.7, clockwise=True),
    "circle": lambda: Circle((0.3, -0.2), 0.4, start=2.0),
    "clockwise": lambda: Circle((0.3, -0.2), 0.4, clockwise=True),
    "arc": lambda: Arc((0.1, 0.2), (-3.0, 4.0), -1.7, 2.5),
    "line": lambda: Line((0.1, 0.2), (0.9, -0.6)),
    "wave": lambda: Curve(lambda u: np.stack([u, 0.1 * np.sin(7.0 * u)], axis=-1), 0.0, 1.0),
}


@pytest.fixture(params=sorted(SHAPES))
def path(request: pytest.FixtureRequest) -> Path:
    return SHAPES[request.param]()


def geometry(position: Callable[[Any], tuple[Any, Any]], u: Any) -> tuple[float, float, np.ndarray]:
    """Curvature, dk/ds and tangent at u, from the direction's angle differentiated at 40 digits."""

    def velocity(w: Any) -> tuple[Any, Any]:
        return mpmath.diff(lambda x: position(x)[0], w), mpmath.diff(lambda x: position(x)[1], w)

    def bend(w: Any) -> Any:
        (x1, y1), first = velocity(w), velocity(u)

        # the angle from the direction at u, so that no branch of the arc tangent is near
        def angle(z: Any) -> Any:
            x, y = velocity(z)
            return mpmath.atan2(first[0] * y - first[1] * x, first[0] * x + first[1] * y)

        return mpmath.diff(angle, w) / mpmath.hypot(x1, y1)

    x1, y1 = velocity(u)
    v = mpmath.hypot(x1, y1)
    return float(bend(u)), float(mpmath.diff(bend, u) / v), np.array([float(x1 / v), float(y1 / v)])


def compare(path: Any, position: Callable[[Any], tuple[Any, Any]], places: list[float], accuracy: float) -> None:
    with mpmath.workdps(40):
        for share in places:
            s = share * path.length
            k, rate, tangent = geometry(position, mpmath.mpf(float(path.parameter(np.float64(s)))))
            scale = path.max_curvature
            assert float(path.curvature(s)) == pytest.approx(k, abs=accuracy * scale)
            assert float(path.curvature_rate(s)) == pytest.approx(rate, abs=10.0 * accuracy * scale**2)
            assert path.tangent(s) == pytest.approx(tangent, abs=accuracy)


def test_ellipse_against_mpmath() -> None:
    path = Ellipse((0.3, -0.2), (0.8, 0.25), rotation=0.7, start=0.4, clockwise=True)

    def position(u: Any) -> tuple[Any, Any]:
        x, y = mpmath.mpf(0.8) * mpmath.cos(0.4 - u), mpmath.mpf(0.25) * mpmath.sin(0.4 - u)
        c, s = mpmath.cos(mpmath.mpf(0.7)), mpmath.sin(mpmath.mpf(0.7))
        return mpmath.mpf(0.3) + c * x - s * y, mpmath.mpf(-0.2) + s * x + c * y

    compare(path, position, [0.0, 0.13, 0.5, 0.77], 1e-11)
    assert path.length == pytest.approx(4.0 * 0.8 * ellipe(1.0 - (0.25 / 0.8) ** 2), rel=1e-13)
    assert path.max_curvature == pytest.approx(0.8 / 0.25**2)


def test_spline_against_mpmath() -> None:
    path = Spline(np.random.default_rng(3).uniform(0.0, 1.0, (9, 2)))
    spline = path._splines[0]
    pieces = [PPoly.from_spline((spline.t, spline.c[:, axis], spline.k)) for axis in (0, 1)]

    def position(u: Any) -> tuple[Any, Any]:
        k = int(np.searchsorted(pieces[0].x, float(u), side="right")) - 1
        x = u - mpmath.mpf(float(pieces[0].x[k]))
        both = [mpmath.polyval([mpmath.mpf(float(c)) for c in piece.c[:, k]], x) for piece in pieces]
        return both[0], both[1]

    compare(path, position, [0.0137, 0.21, 0.52, 0.83], 1e-9)
    points = path.points
    assert path.nearest(points).distance == pytest.approx(0.0, abs=1e-12)


def test_user_curve_against_mpmath() -> None:
    def r(u: np.ndarray) -> np.ndarray:
        return np.stack([np.exp(0.3 * u) * np.cos(u), np.exp(0.3 * u) * np.sin(u)], axis=-1)

    def position(u: Any) -> tuple[Any, Any]:
        grown = mpmath.exp(mpmath.mpf(0.3) * u)
        return grown * mpmath.cos(u), grown * mpmath.sin(u)

    def derivative(order: int) -> Callable[[np.ndarray], np.ndarray]:
        def found(u: np.ndarray) -> np.ndarray:
            z = (0.3 + 1j) ** order * np.exp((0.3 + 1j) * u)
            return np.stack([z.real, z.imag], axis=-1)

        return found

    exact = Curve(r, 0.0, 4.0, derivatives=[derivative(k) for k in (1, 2, 3)])
    compare(exact, position, [0.1, 0.5, 0.9], 1e-11)
    plain = Curve(r, 0.0, 4.0)
    compare(plain, position, [0.1, 0.5, 0.9], 1e-8)
    spiral = np.hypot(0.3, 1.0) / 0.3 * (np.exp(1.2) - 1.0)  # the length of a logarithmic spiral
    assert exact.length == pytest.approx(spiral, rel=1e-13)
    assert plain.length == pytest.approx(spiral, rel=1e-12)


def test_arc_length_is_arc_length(path: Path) -> None:
    ends = np.sort(np.random.default_rng(1).uniform(0.0, path.length, 2))

    def speed(s: float) -> float:
        step = 1e-6 * path.length
        return float(np.hypot(*(path.point(s + step) - path.point(s - step))) / (2.0 * step))

    assert quad(speed, *ends, epsabs=1e-7)[0] == pytest.approx(ends[1] - ends[0], rel=1e-5)


def test_frame_is_consistent(path: Path) -> None:
    s = np.linspace(0.03, 0.97, 40) * path.length
    step = 1e-5 / max(path.max_curvature, 1.0)
    there, before, after = path.frame(s), path.frame(s - step), path.frame(s + step)
    slope = (after.point - before.point) / (2.0 * step)
    assert slope == pytest.approx(there.tangent, abs=1e-6)
    turn = (after.tangent - before.tangent) / (2.0 * step)
    normal = np.stack([-there.tangent[:, 1], there.tangent[:, 0]], axis=1)
    assert (turn * normal).sum(axis=1) == pytest.approx(there.curvature, abs=1e-4 * max(path.max_curvature, 1.0))
    change = (after.curvature - before.curvature) / (2.0 * step)
    size = max(float(np.abs(there.curvature_rate).max()), 1.0)
    assert change == pytest.approx(there.curvature_rate, abs=2e-3 * size)
    assert np.abs(path.frame(np.linspace(0.0, path.length, 5000)).curvature).max() <= path.max_curvature * (1.0 + 1e-12)


def test_nearest_against_brute_force(path: Path) -> None:
    points = np.random.default_rng(2).uniform(-0.6, 1.4, (120, 2))
    found = path.nearest(points)
    s = np.linspace(0.0, path.length, 4_001)
    brute = np.linalg.norm(points[:, None] - path.point(s), axis=2).min(axis=1)
    spacing = s[1]
    assert np.all(found.distance <= brute + 1e-12)
    assert np.all(found.distance >= brute - spacing)
    assert np.linalg.norm(points - path.point(found.s), axis=1) == pytest.approx(found.distance, abs=1e-12)
    assert np.all((found.s >= 0.0) & (found.s <= path.length))


def test_nearest_of_offset_points_comes_back(path: Path) -> None:
    s = np.linspace(0.02, 0.98, 60) * path.length
    frame = path.frame(s)
    normal = np.stack([-frame.tangent[:, 1], frame.tangent[:, 0]], axis=1)
    size = 0.5 / max(path.max_curvature, 1.0)
    for side in (1.0, -1.0):
        found = path.nearest(frame.point + side * size * normal, near=s)
        assert found.s == pytest.approx(s, abs=1e-9)
        assert found.distance == pytest.approx(size, abs=1e-10)
        assert np.all(found.side == side)


def test_a_crossing_does_not_make_the_nearest_point_jump() -> None:
    eight = Curve(lambda u: np.stack([np.sin(u), np.sin(2.0 * u)], axis=-1), 0.3, 0.3 + 2.0 * np.pi, closed=True)
    s = np.linspace(0.0, eight.length, 250)
    frame = eight.frame(s)
    points = frame.point + 0.03 * np.stack([-frame.tangent[:, 1], frame.tangent[:, 0]], axis=1)
    found = np.empty(len(s))
    near = 0.0
    for k, point in enumerate(points):  # walk along, through the crossing twice
        near = float(eight.nearest(point, near=near).s)
        found[k] = near
    assert found == pytest.approx(s, abs=1e-8)
    far = eight.nearest(points).s  # without a place to look near, the other branch wins somewhere
    assert np.abs(far - s).max() > 0.5


def test_closed_paths_repeat_and_open_ones_go_straight_on(path: Path) -> None:
    ahead = 0.3 * path.length
    if path.closed:
        for a, b in zip(path.frame(ahead), path.frame(ahead + 3.0 * path.length), strict=True):
            assert a == pytest.approx(b, abs=1e-9 * max(path.max_curvature, 1.0) ** 2)
    else:
        end, beyond = path.frame(path.length), path.frame(path.length + ahead)
        assert beyond.point == pytest.approx(end.point + ahead * end.tangent, abs=1e-12)
        assert beyond.curvature == 0.0 == beyond.curvature_rate
        assert float(path.nearest(beyond.point, near=path.length).s) == pytest.approx(path.length)


@given(
    st.floats(-3.0, 3.0) | st.sampled_from([0.0, 1e-12, -1e-9, 1e-7, -1e-4]),
    st.floats(-np.pi, np.pi),
    st.floats(-3.0, 3.0),
    st.floats(-0.3, 0.3),
)
def test_feet_on_arcs(curvature: float, heading: float, s: float, offset: float) -> None:
    start, tangent = np.array([0.4, -1.0]), np.array([np.cos(heading), np.sin(heading)])
    if abs(curvature * s) > 3.0:
        s = 3.0 / curvature
    frame = arc_frame(start, tangent, np.float64(curvature), np.float64(s))
    normal = np.array([-frame.tangent[1], frame.tangent[0]])
    foot = arc_locate(start, tangent, np.float64(curvature), frame.point + offset * normal, np.float64(s))
    assert float(foot.s) == pytest.approx(s, abs=1e-11)
    assert float(foot.offset) == pytest.approx(offset, abs=1e-13)
    assert foot.tangent == pytest.approx(frame.tangent, abs=1e-11)


def test_arcs_without_cancellation() -> None:
    for curvature in (1e-3, 1e-6, 1e-9, 1e-12):
        with mpmath.workdps(40):
            k, s = mpmath.mpf(curvature), mpmath.mpf(2)
            exact = [float(mpmath.sin(k * s) / k), float((1 - mpmath.cos(k * s)) / k)]
        assert Arc((0.0, 0.0), (1.0, 0.0), curvature, 3.0).point(2.0) == pytest.approx(exact, rel=1e-14)


def test_closed_splines() -> None:
    points = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]
    path = Spline(points, closed=True)
    again = Spline([*points, points[0]])
    assert path.closed and again.closed and path.length == pytest.approx(again.length, rel=1e-14)
    start, end = path.frame(0.0), path.frame(path.length * (1.0 - 1e-13))
    for a, b in zip(start, end, strict=True):
        assert a == pytest.approx(b, abs=1e-8)


REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: Circle((0.0, 0.0), 0.0), "radius: 0; a positive"),
    (lambda: Circle((0.0, np.nan), 1.0), "centre"),
    (lambda: Circle((0.0, 0.0), [1.0]), "radius: .* one finite number"),  # type: ignore[arg-type]
    (lambda: Circle((1e308, 1e308), 1.0), "centre: 1e.308 is too large"),
    (lambda: Line((-1e308, 0.0), (1e308, 0.0)), "start: .* too large"),
    (lambda: Ellipse((0.0, 0.0), (1e-200, 1e-200)), "a positive"),
    (lambda: Circle((0.0,), 1.0), "two numbers"),  # type: ignore[arg-type]
    (lambda: Circle("ab", 1.0), "real numbers"),  # type: ignore[arg-type]
    (lambda: Line((1.0, 1.0), (1.0, 1.0)), "two points"),
    (lambda: Arc((0.0, 0.0), (0.0, 0.0), 1.0, 1.0), "a direction"),
    (lambda: Arc((0.0, 0.0), (1.0, 0.0), np.inf, 1.0), "finite"),
    (lambda: Ellipse((0.0, 0.0), (1.0, 1e-4)), "ratio"),
    (lambda: Ellipse((0.0, 0.0), (1.0, -1.0)), "positive"),
    (lambda: Spline([(0.0, 0.0), (1.0, 1.0)]), "at least 3"),
    (lambda: Spline([(0.0, 0.0), (1.0, 1.0), (1.0, 1.0), (2.0, 0.0)]), "numbers 2 and 3 are one point"),
    (lambda: Spline([(0.0, 0.0), (1.0, 1.0), (0.0, 0.0)]), "3 different points"),
    (lambda: Spline([(0.0, 0.0), (1.0, 1.0), (2.0,)]), "points: a ragged"),
    (lambda: Spline([(0.0, 0.0), (1e300, 1.0), (2e300, 0.0)]), "points: 2e.300 is too large"),
    (lambda: Curve(lambda u: np.stack([u, np.abs(u - 0.3)], axis=-1), 0.0, 1.0), "not smooth enough"),
    (lambda: Curve(lambda u: np.stack([u**2, u**3], axis=-1), -1.0, 1.0), "stands still|not smooth"),
    (lambda: Curve(lambda u: u, 0.0, 1.0), "shape"),
    (lambda: Curve(lambda u: [u, [1.0]], 0.0, 1.0), "returned object"),
    (lambda: Curve("r", 0.0, 1.0), "position: 'r'; a function"),  # type: ignore[arg-type]
    (lambda: Curve(np.sin, 0.0, 1.0, derivatives=(1, 2, 3)), "three functions"),  # type: ignore[arg-type]
    (lambda: Curve(np.sin, 0.0, 1.0, derivatives=1), "three functions"),  # type: ignore[arg-type]
    (lambda: read_path(None), "not from None"),  # type: ignore[arg-type]
    (lambda: Curve(lambda u: np.stack([u, 1.0 / (u - 5.0)], axis=-1) * np.nan, 0.0, 1.0), "not finite at u"),
    (lambda: Curve(lambda u: np.stack([u, u], axis=-1), 1.0, 0.0), "more than start"),
    (lambda: Curve(lambda u: np.stack([u, u**2], axis=-1), 0.0, 1.0, closed=True), "misses the beginning"),
    (lambda: Curve(lambda u: np.stack([u, u], axis=-1), 0.0, 1.0, derivatives=[np.sin]), "three"),
    (
        lambda: Curve(
            lambda u: np.stack([u, u**2], axis=-1),
            0.0,
            1.0,
            derivatives=[lambda u: np.stack([1.0 + 0.0 * u, 3.0 * u], axis=-1)] * 3,
        ),
        "first is not the derivative",
    ),
    (lambda: Circle((0.0, 0.0), 1.0).point(np.nan), "finite"),
    (lambda: Circle((0.0, 0.0), 1.0).nearest([1.0, 2.0, 3.0]), "shape"),
    (lambda: Circle((0.0, 0.0), 1.0).nearest([[1.0, 2.0]], near=[1.0, 2.0, 3.0]), "near"),
]


@pytest.mark.parametrize(("make", "why"), REFUSED)
def test_refused_in_one_line(make: Callable[[], Any], why: str) -> None:
    with pytest.raises(InputError, match=why) as caught:
        make()
    assert "\n" not in str(caught.value)


# ---- files -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", [1e-30, 1e30])
def test_size_does_not_matter(size: float) -> None:
    """Curvature and its rate of a tiny and of a huge ellipse: powers of the speed must not leave the doubles."""
    one, other = Ellipse((0.0, 0.0), (2.0, 1.0)), Ellipse((0.0, 0.0), (2.0 * size, size))
    s = np.linspace(0.0, one.length, 9)[:-1]
    assert other.curvature(s * size) * size == pytest.approx(one.curvature(s), rel=1e-9)
    assert other.curvature_rate(s * size) * size**2 == pytest.approx(one.curvature_rate(s), rel=1e-9, abs=1e-9)


def test_a_direction_of_any_length() -> None:
    for size in (1e-320, 1e-160, 1e30):
        assert unit(np.array([3.0 * size, 3.0 * size]), "tangent") == pytest.approx([0.5**0.5, 0.5**0.5], rel=1e-15)


def test_every_kind_from_toml(tmp_path: File) -> None:
    cases: list[tuple[str, Path]] = [
        ('kind = "line"\nstart = [0, 0]\nend = [3, 4]', Line((0.0, 0.0), (3.0, 4.0))),
        (
            'kind = "arc"\nstart = [0, 0]\ntangent = [0, 2]\ncurvature = -0.5\nlength = 2',
            Arc((0.0, 0.0), (0.0, 2.0), -0.5, 2.0),
        ),
        (
            'kind = "circle"\nangles = "deg"\ncentre = [1, 2]\nradius = 0.5\nstart = 90\nclockwise = true',
            Circle((1.0, 2.0), 0.5, start=np.pi / 2.0, clockwise=True),
        ),
        (
            'kind = "ellipse"\nangles = "rad"\ncentre = [1, 2]\nsemi_axes = [2, 1]\nrotation = 0.3',
            Ellipse((1.0, 2.0), (2.0, 1.0), rotation=0.3),
        ),
        (
            'kind = "spline"\npoints = [[0, 0], [1, 0.5], [2, 0]]\nclosed = true',
            Spline([(0.0, 0.0), (1.0, 0.5), (2.0, 0.0)], closed=True),
        ),
    ]
    for text, expected in cases:
        file = tmp_path / "path.toml"
        file.write_text(f"path = 1\n{text}\n", "utf-8")
        found = read_path(file)
        assert type(found) is type(expected)
        assert found.to_dict() == expected.to_dict()
        s = np.linspace(0.0, expected.length, 7)
        assert np.array_equal(found.point(s), expected.point(s))


def test_points_from_csv(tmp_path: File) -> None:
    rows = [(0.0, 0.0), (1.0, 0.5), (2.0, -0.25), (3.0, 0.0)]
    body = "".join(f"{x},{y}\n" for x, y in rows)
    for text in (body, "x,y\n" + body, "\ufeffX, Y\r\n" + body.replace("\n", "\r\n") + "\r\n"):
        file = tmp_path / "points.csv"
        file.write_text(text, "utf-8", newline="")
        assert np.array_equal(read_path(file).to_dict()["points"], rows)
    closed = from_csv((body + "0,0\n").encode())
    assert closed.closed and len(closed.points) == 4


BAD_TOML = [
    ("", "key 'path': missing"),
    ("path = 2", "path = 1"),
    ("path = true", "path = 1"),
    ("path = 1", "key 'kind': missing"),
    ('path = 1\nkind = "helix"', "line, arc, circle"),
    ('path = 1\nkind = "circle"\ncentre = [0, 0]', "'radius' is missing"),
    ('path = 1\nkind = "circle"\ncentre = [0, 0]\nradius = 1\ncolour = 3', "unknown key 'colour'"),
    ('path = 1\nkind = "circle"\ncentre = [0, 0]\nradius = -1', "the circle: radius: -1; a positive"),
    ('path = 1\nkind = "circle"\ncentre = [0, "1"]\nradius = 1', "key 'centre', entry 2"),
    ('path = 1\nkind = "circle"\ncentre = [0, nan]\nradius = 1', "not finite"),
    ('path = 1\nkind = "circle"\ncentre = 0\nradius = 1', "a list of 2 numbers"),
    ('path = 1\nkind = "circle"\ncentre = [0, 0]\nradius = 1\nstart = 90', "key 'angles': missing"),
    ('path = 1\nkind = "circle"\ncentre = [0, 0]\nradius = 1\nclockwise = 1', "true or false"),
    ('path = 1\nkind = "spline"\npoints = [[0, 0], [1]]', "point 2"),
    ('path = 1\nkind = "spline"\npoints = 3', "a list of points"),
    ("path = ", "not TOML"),
    ("a" + ".a" * 3000 + " = 1", "nested too deeply"),
]


@pytest.mark.parametrize(("text", "why"), BAD_TOML)
def test_bad_toml(text: str, why: str) -> None:
    with pytest.raises(DescriptionError, match=why) as caught:
        from_toml(text.encode())
    assert "\n" not in str(caught.value)


BAD_CSV = [
    (b"", "0 points"),
    (b"x,y\n0,0\n1,1\n", "2 points"),
    (b"0,0\n1,1\n1,1\n2,0\n", "row 3: the same point"),
    (b"0,0\n1,a\n2,0\n", "row 2, y: 'a'"),
    (b"0,0\n1,nan\n2,0\n", "row 2, y"),
    (b"0,0\n1,1e999\n2,0\n", "row 2, y"),
    (b"0,0\n1_0,1\n2,0\n", "row 2, x"),
    (b"0,0\n1,2,3\n2,0\n", "row 2: 3 entries"),
    (b"y,x\n0,0\n1,2\n2,0\n", "row 1"),
    (b"0,0\n1,\xff\n2,0\n", "row 2: not UTF-8"),
    (b'0,0\n"1,2\n2,0\n', "row"),
]


@pytest.mark.parametrize(("content", "why"), BAD_CSV)
def test_bad_csv(content: bytes, why: str) -> None:
    with pytest.raises(DescriptionError, match=why) as caught:
        from_csv(content)
    assert "\n" not in str(caught.value)


def test_bad_files(tmp_path: File) -> None:
    for name, why in (("none.toml", "no such file"), ("path.json", "'.json'"), ("folder.csv", "folder")):
        if "folder" in name:
            (tmp_path / name).mkdir()
        with pytest.raises(DescriptionError, match=why) as caught:
            read_path(tmp_path / name)
        assert str(caught.value).startswith(str(tmp_path / name))
    (tmp_path / "long.csv").write_bytes(b"0,0\n" * 2**19)
    with pytest.raises(DescriptionError, match="larger than"):
        read_path(tmp_path / "long.csv")
