"""``chainrule track`` and the figures it draws: what it prints and writes, and how it refuses."""

import csv
import io
import json
import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

import chainrule as cr
from chainrule.papers import sanchez_paths as sanchez
from chainrule.plot import redundancy as drawn
from chainrule.plot.style import line_look
from chainrule.redundancy import words
from chainrule.redundancy.samples import circle_through, good_posture, line_from
from chainrule.redundancy.step import Damping

STARTS = ("--start", ",".join(map(repr, sanchez.STARTS["A"])))
ARC = ("sanchez_8r", "--path", "sanchez-arc", "--feedback", "0", "--dt", "0.0067")


@pytest.fixture
def call(call):
    return partial(call, "track")


def arc(t):
    theta = np.pi * np.asarray(t) / 2.0
    return np.stack([0.25 * np.cos(theta), np.full(theta.shape, 0.05), -0.25 + 0.25 * np.sin(theta)], axis=-1)


def height(arm, q):
    jacobian = arm.jacobian(q)
    return np.sqrt(np.linalg.det(jacobian @ np.swapaxes(jacobian, -1, -2)))


def by_numpy(arm, gain, steps):
    """The thesis' run from A: pinv, and the gradient of w^(-1/2) by central differences."""
    q, dt = np.array(sanchez.STARTS["A"]), 2.0 / steps
    found = [q]
    for k in range(steps):
        theta = math.pi * k / steps
        velocity = np.zeros(6)
        velocity[[0, 2]] = 0.125 * math.pi * np.array([-math.sin(theta), math.cos(theta)])
        ends = np.stack([q + 1e-5 * np.eye(8), q - 1e-5 * np.eye(8)])
        gradient = (height(arm, ends[0]) ** -0.5 - height(arm, ends[1]) ** -0.5) / 2e-5
        jacobian = arm.jacobian(q)
        inverse = np.linalg.pinv(jacobian)
        q = q + dt * (inverse @ velocity + gain * (gradient - inverse @ (jacobian @ gradient)))
        found.append(q)
    return np.array(found)


def test_the_thesis_run_is_that_of_plain_numpy(call):
    code, out, err = call(*ARC, "--gain", "-2", *STARTS, "--json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    run = told["run"]
    arm = cr.load("sanchez_8r")
    q = by_numpy(arm, -2.0, 299)
    np.testing.assert_allclose(run["q"], q, atol=1e-7)
    np.testing.assert_allclose(run["t"], np.linspace(0.0, 2.0, 300), atol=1e-14)
    assert run["min_manipulability"] == pytest.approx(height(arm, q).min(), rel=1e-6)
    away = np.linalg.norm(arm.position(q) - arc(run["t"]), axis=1)
    assert run["worst_position_error"] == pytest.approx(away.max(), rel=1e-4)
    assert told["path"]["kind"] == "arc"
    assert run["status"] == "complete"


def test_what_is_printed(call):
    code, out, err = call("sanchez_8r", "--path", "sanchez-arc", "--gain", "-2", "--dt", "0.0067")
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0].startswith("sanchez_8r follows the path in 2 s: H ≥ 0.0194 (least at 0.8")
    assert lines[1].startswith("gradient projection, −2 on H^(-1/2), feedback 74.75 1/s, Euler, step 6.69 ms.")
    assert "cost of a step [µs]" in out
    assert "Torques rest on assumed link masses 3, 2.5, 2, 1.5, 1.2, 1, 0.6, 0.4 kg." in out


def test_events_are_told(call):
    code, out, _ = call(*ARC, "--gain", "0")
    assert code == 0
    assert out.splitlines()[1].startswith("pseudoinverse, Euler")
    assert "singularity near" in out


def test_samples_as_csv_and_a_figure(call, tmp_path):
    table, figure = tmp_path / "a.csv", tmp_path / "a.svg"
    code, out, err = call(*ARC, "--csv", table, "--figure", figure)
    assert (code, err) == (0, "")
    assert out.splitlines()[-2:] == [str(figure), str(table)]
    rows = list(csv.DictReader(io.StringIO(table.read_text("ascii"))))
    assert len(rows) == 300
    arm = cr.load("sanchez_8r")
    values = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    q = np.stack([values[f"q{j}"] for j in range(1, 9)], axis=1)
    np.testing.assert_allclose(
        np.stack([values[f"position_error_{axis}"] for axis in "xyz"], axis=1),
        arm.position(q) - arc(values["t"]),
        atol=1e-13,
    )
    np.testing.assert_allclose(values["determinant"], height(arm, q) ** 2, rtol=1e-8)
    assert "torque8" in values
    text = figure.read_text("utf-8")
    assert "assumed link masses" in text
    assert "det J Jᵀ = H²" in text
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv", "a.svg"]


def test_methods_are_compared(call, tmp_path):
    chosen = ("sanchez_8r", "--path", "sanchez-arc", "--compare", "pseudoinverse,gradient_projection")
    code, out, err = call(*chosen, "--figure", tmp_path / "a.svg")
    assert (code, err) == (0, "")
    assert out.startswith("Farthest from singularities: gradient projection, −2 on H^(-1/2) (H ≥ 0.0194). ")
    assert "pseudoinverse" in out
    assert "fastest joint [rad/s]" in (tmp_path / "a.svg").read_text("utf-8")
    told = json.loads(call(*chosen, "--json")[1])["runs"]
    assert [run["method"] for run in told] == ["pseudoinverse", "gradient_projection"]
    assert [run["law"]["gains"] for run in told] == [{}, {"H^(-1/2)": -2.0}]
    assert told[0]["q"][0] == told[1]["q"][0]  # one start for all
    assert all(run["step_cost"] > 0.0 for run in told)


def test_damping_weights_and_a_secondary_task(call):
    """The same runs as from Python, and in one table beside what is plain."""
    line, start = ("planar_3r", "--line", "-0.1,0.1", "--start", "0.2,1.2,0.6"), [0.2, 1.2, 0.6]
    arm = cr.load("planar_3r")
    path = line_from(arm, start, [-0.1, 0.1])

    def found(*options):
        code, out, _ = call(*line, *options, "--json")
        assert code == 0
        return json.loads(out)["run"]

    damped = cr.track(arm, path, start, damping=Damping("chiaverini", 0.2, 0.9))
    assert found("--damping", "chiaverini,0.2,0.9")["q"] == damped.q.tolist()
    still = found("--weights", "1,inf,2", "--method", "pseudoinverse")
    assert np.ptp(np.array(still["q"])[:, 1]) == 0.0
    assert still["q"] == cr.track(arm, path, start, method="pseudoinverse", weights=[1.0, np.inf, 2.0]).q.tolist()
    led = found("--method", "priority", "--secondary", "q3=0.9", "--gain", "0")
    q3 = np.array(led["q"])[:, 2]
    np.testing.assert_allclose(q3, 0.9 - 0.3 * (1.0 - 2.0 * 2.0 / 300.0) ** np.arange(301), atol=1e-12)  # Euler
    assert max(np.linalg.norm(led["position_error"], axis=1)) < 1e-3
    turned = ",".join(repr(float(value)) for value in np.degrees(start))
    for turn in ("q3=51.56620156177409", "joint3=51.56620156177409"):
        degrees = found("--method", "priority", "--secondary", turn, "--gain", "0", "--deg", "--start", turned)
        np.testing.assert_allclose(degrees["q"], led["q"], atol=1e-12)
    code, out, _ = call(*line, "--damping", "nakamura,0.1,0.5", "--secondary", "q3=0.9", "--compare", "all")
    assert code == 0
    rows = [text for text in out.splitlines() if "complete" in text]
    for name in ("pseudoinverse ", "pseudoinverse, damped", "task priority", "global optimum"):
        assert sum(text.strip().startswith(name) for text in rows) == 1, name


def test_limits_are_kept_and_the_least_time_is_found(call):
    asked = ("panda", "--circle", "0.1", "--velocity", "0.8", "--acceleration", "4", "--json")
    code, out, err = call(*asked, "--limits")
    assert (code, err) == (0, "")
    run = json.loads(out)["run"]
    rates, q, t = np.array(run["rates"]), np.array(run["q"]), np.array(run["t"])
    assert np.abs(rates).max() <= 0.8 * (1 + 1e-9)
    assert np.abs(np.diff(rates, axis=0)).max() <= 4.0 * run["dt"] * (1 + 1e-6)
    np.testing.assert_allclose(np.diff(q[:-1], axis=0), np.diff(t[:-1])[:, None] * rates[:-2], atol=1e-12)
    low, high = cr.load("panda").limits.position.T
    assert ((low <= q) & (q <= high)).all()
    assert run["worst_position_error"] < 1e-3
    assert t[-1] > 2.0  # slower than asked
    assert "task scaled" in {event["kind"] for event in run["events"]}
    pytest.importorskip("toppra")
    code, out, _ = call("panda", "--circle", "0.1", "--velocity", "2", "--acceleration", "10", "--json", "--fastest")
    assert code == 0
    run = json.loads(out)["run"]
    assert np.abs(run["rates"]).max() <= 2.0 * (1 + 1e-6)
    assert np.abs(run["accelerations"]).max() <= 10.0 * (1 + 1e-3)
    assert run["t"][-1] < 2.0


def test_a_whole_path_is_optimised(call):
    asked = ("planar_3r", "--circle", "0.2", "--start", "0,1.2,0.4", "--dt", "0.1")
    code, out, err = call(*asked, "--compare", "gradient_projection,global", "--json")
    assert (code, err) == (0, "")
    local, best = json.loads(out)["runs"]
    assert best["method"] == "global"
    assert best["min_manipulability"] > local["min_manipulability"] * (1 - 1e-3)
    assert best["worst_position_error"] < 1e-6
    code, out, _ = call(*asked, "--method", "global")
    assert code == 0
    assert out.splitlines()[1].startswith("global optimum, ")
    assert "no proof that none goes farther" in out
    arm = cr.load("planar_3r")  # at the quarters between the samples
    q = np.array(json.loads(call(*asked, "--method", "global", "--json")[1])["run"]["q"])
    path = circle_through(arm, [0.0, 1.2, 0.4], 0.2)
    shares = np.array([0.25, 0.5, 0.75])[:, None]
    tips = arm.position(q[:-1, None] + shares * np.diff(q, axis=0)[:, None])
    wanted = path.sample((0.1 * (np.arange(20)[:, None] + shares.T)).ravel(), "position").held.reshape(tips.shape)
    worst = 1000.0 * np.linalg.norm(tips - wanted, axis=-1).max()
    assert f"between the samples the tip is up to {worst:.3g} mm off its target" in out


def test_a_circle_and_a_line_from_the_tip(call):
    from_q = ("--start", "0,60,-60", "--deg", "--method", "pseudoinverse", "--json")
    code, out, err = call("planar_3r", "--circle", "0.1", *from_q)
    assert (code, err) == (0, "")
    told = json.loads(out)
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = np.array(told["run"]["q"])
    np.testing.assert_allclose(q[0], np.radians([0.0, 60.0, -60.0]), atol=1e-15)
    tips = arm.position(q)
    centre = tips[0] * (1.0 - 0.1 / np.linalg.norm(tips[0]))
    np.testing.assert_allclose(np.linalg.norm(tips - centre, axis=1), 0.1, atol=1e-3)
    assert np.linalg.norm(tips - tips[0], axis=1).max() == pytest.approx(0.2, abs=1e-3)  # all the way round
    np.testing.assert_allclose(told["run"]["rates"][-1], 0.0, atol=2e-2)  # from rest to rest
    code, out, _ = call("planar_3r", "--line=-0.3,0.1", "--start", "0,1,-1", "--duration", "1", "--json")
    assert code == 0
    run = json.loads(out)["run"]
    way = np.diff(arm.position(np.array(run["q"])[[0, -1]]), axis=0)[0]
    np.testing.assert_allclose(way, [-0.3, 0.1], atol=1e-3)
    assert run["t"][-1] == 1.0


def test_a_start_is_found_where_none_is_given(call):
    code, out, _ = call("planar_3r", "--line=-0.3,0", "--json")
    assert code == 0
    q = json.loads(out)["run"]["q"][0]
    s2, s3 = np.sin(q[1:])
    s23 = np.sin(q[1] + q[2])
    h = math.sqrt((0.5 * s2 + 0.25 * s23) ** 2 + (0.25 * s23 + 0.125 * s3) ** 2 + (0.125 * s3) ** 2)
    assert h > 0.75  # of 0.7955 at most (De Luca)


def test_a_path_that_leaves_the_reach_exits_with_one(call, tmp_path):
    code, out, err = call("planar_3r", "--line", "1,0", "--start", "0,1,-1", "--figure", tmp_path / "a.svg")
    assert (code, err) == (1, "")
    assert "stops at" in out.splitlines()[0]
    assert (tmp_path / "a.svg").exists()
    code, out, _ = call(
        "planar_3r", "--line", "1,0", "--start", "0,1,-1", "--compare", "pseudoinverse,gradient_projection"
    )
    assert code == 1
    assert out.startswith("No method follows the path to its end.")
    code, out, _ = call("planar_3r", "--line", "1,0", "--start", "0,1,-1", "--damping", "constant,0.1", "--gain", "0")
    assert code == 1
    assert "leaves the path at" in out.splitlines()[0] and "path left" in out
    code, _, err = call(*ARC, "--tolerance", "1e-3")  # 1.4 mm without feedback
    assert code == 1 and "farther than 0.001 m" in err and err.count("\n") == 1
    assert call(*ARC, "--tolerance", "2e-3")[0] == 0


def test_what_is_said_beforehand(call):
    code, out, _ = call("sanchez_8r", "--path", "sanchez-line", "--forecast")
    assert code == 1
    assert out.startswith("sanchez_8r: the local law does not follow this path within rates of 10 and 0.001 m")
    code, out, _ = call("sanchez_8r", "--path", "sanchez-arc", "--forecast", "--json")
    assert code == 0
    assert json.loads(out)["forecast"]["follows"][0] is True


def test_paths_from_files(call, tmp_path):
    file = tmp_path / "arc.toml"
    file.write_text(
        'task_path = 1\nkind = "arc"\nangles = "deg"\ncentre = [0, 0.05, -0.25]\nradius = 0.25\nend = 180\n'
        "y = [0, 0, 1]\n[time]\nduration = 2\n"
    )
    one = json.loads(call("sanchez_8r", "--path", file, "--start", "A", "--json")[1])["run"]
    two = json.loads(call("sanchez_8r", "--path", "sanchez-arc", "--start", "A", "--json")[1])["run"]
    np.testing.assert_allclose(one["q"], two["q"], atol=1e-9)
    assert call("sanchez_8r", "--path", tmp_path / "none.toml")[0] == 2


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("sanchez_8r",), "one of --path, --circle and --line is needed"),
        (("sanchez_8r", "--path", "sanchez-arc", "--circle", "0.1"), "one of --path, --circle and --line is needed"),
        (("sanchez_8r", "--path", "sanchez-spiral"), ".toml or .csv"),
        (("sanchez_8r", "--path", "sanchez-arc", "--start", "1,2,3"), "--start: 3 numbers given"),
        (("sanchez_8r", "--path", "sanchez-arc", "--start", "E", "--feedback", "0"), "misses the start of the path"),
        (("panda", "--path", "sanchez-arc", "--start", "A"), "is a posture of sanchez_8r"),
        (("sanchez_8r", "--path", "sanchez-arc", "--start", "best"), "'best' needs a path that says the orientation"),
        (("planar_3r", "--path", "sanchez-arc"), "coordinates"),
        (("planar_3r", "--circle", "-0.1"), "radius"),
        (("planar_3r", "--circle", "nan"), "radius"),
        (("planar_3r", "--line", "0.1,0.2,0.3"), "displacement: 3 numbers"),
        (("planar_3r", "--line", "0.1,x"), "--line, entry 2"),
        (("planar_3r", "--circle", "0.1", "--start", "best"), "needs a --path"),
        (("planar_3r", "--circle", "0.1", "--duration", "0"), "duration"),
        (("sanchez_8r", "--path", "sanchez-arc", "--duration", "3"), "has its own time"),
        (("planar_3r", "--circle", "0.1", "--method", "luck"), "--method: 'luck'"),
        (
            ("planar_3r", "--circle", "0.1", "--method", "pseudoinverse", "--gain", "1"),
            "--gain: 'pseudoinverse' has none",
        ),
        (("planar_3r", "--circle", "0.1", "--method", "pseudoinverse", "--limits"), "limited and global do"),
        (("planar_3r", "--circle", "0.1", "--method", "damped"), "--damping is needed"),
        (("planar_3r", "--circle", "0.1", "--damping", "magic,1"), "--damping: 'magic'; constant, nakamura"),
        (("planar_3r", "--circle", "0.1", "--damping", "nakamura,1"), "--damping: 1 number given; 2 are accepted"),
        (("planar_3r", "--circle", "0.1", "--damping", "constant,-1"), "damping factor: -1"),
        (
            ("planar_3r", "--circle", "0.1", "--damping", "constant,1", "--compare", "pseudoinverse,global"),
            "which is not among the methods",
        ),
        (("planar_3r", "--circle", "0.1", "--damping", "constant,1", "--method", "global"), "are for local laws"),
        (("planar_3r", "--circle", "0.1", "--weights", "1,2"), "weights: 2 given; 3"),
        (("planar_3r", "--circle", "0.1", "--weights", "1,2,x"), "--weights, entry 1: 'x'"),
        (("planar_3r", "--circle", "0.1", "--method", "priority"), "--secondary and the method 'priority'"),
        (("planar_3r", "--circle", "0.1", "--secondary", "q1=0"), "--secondary and the method 'priority'"),
        (("planar_3r", "--circle", "0.1", "--method", "priority", "--secondary", "q9=0"), "joint 'q9': planar_3r has"),
        (("planar_3r", "--circle", "0.1", "--method", "priority", "--secondary", "q1"), "--secondary: 'q1'"),
        (("planar_3r", "--circle", "0.1", "--method", "priority", "--secondary", "q1=a"), "--secondary, q1, entry 1"),
        (("planar_3r", "--circle", "0.1", "--method", "priority", "--secondary", "q1=0,q2=0"), "k from 1 to 1"),
        (("planar_3r", "--circle", "0.1", "--limits", "--integrator", "rk4"), "with limits 'euler' is accepted"),
        (("planar_3r", "--circle", "0.1", "--compare", "luck"), "--compare: 'luck'"),
        (("planar_3r", "--circle", "0.1", "--compare", "all", "--csv", "a.csv"), "not for --compare"),
        (("planar_3r", "--circle", "0.1", "--compare", "all", "--forecast"), "not for --compare"),
        (("planar_3r", "--circle", "0.1", "--compare", "all", "--limits"), "'limited'"),
        (("planar_3r", "--circle", "0.1", "--criterion", "beauty"), "criterion"),
        (("planar_3r", "--circle", "0.1", "--integrator", "midpoint"), "integrator"),
        (("planar_3r", "--circle", "0.1", "--integrator", "dop853", "--forecast"), "has no forecast"),
        (("planar_3r", "--circle", "0.1", "--dt", "0"), "dt"),
        (("planar_3r", "--circle", "0.1", "--feedback", "-1"), "feedback"),
        (("planar_3r", "--circle", "0.1", "--velocity", "1,2"), "--velocity: 2 numbers given"),
        (("planar_3r", "--circle", "0.1", "--velocity", "-1"), "velocity"),
        (("lenarcic_3r", "--circle", "0.1", "--fastest"), "acceleration"),
        (("planar_3r", "--circle", "0.1", "--tolerance", "0"), "--tolerance"),
        (("planar_3r", "--circle", "0.1", "--task", "dance"), "there is no task"),
        (("planar_3r", "--circle", "0.1", "--figure", "a.bmp"), ".svg, .png or .pdf"),
        (("planar_3r", "--circle", "0.1", "--csv", "a.txt"), ".csv"),
    ],
)
def test_bad_input_is_one_line(call, arguments, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, out, err = call(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("chainrule: ")
    assert err.count("\n") == 1
    assert said in err
    assert list(tmp_path.iterdir()) == []


# ---- figures and words -------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def planar_run():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = [0.0, 1.2, 0.4]
    return cr.track(arm, circle_through(arm, q, 0.15), q, dt=0.02)


def test_the_arm_is_drawn_with_its_links(planar_run):
    sheet = drawn.draw_run(planar_run)
    picture = sheet.axes[0]
    lines = [line.get_xydata() for line in picture.lines if len(line.get_xdata()) == 5]
    assert len(lines) >= 4
    for line in lines:
        np.testing.assert_allclose(np.linalg.norm(np.diff(line[1:], axis=0), axis=1), [1.0, 0.5, 0.25], atol=1e-12)
    assert "rates that leave the tip at rest [rad/s]" in [axes.get_title(loc="left") for axes in sheet.axes]
    sheet.savefig(io.BytesIO(), format="svg")


def test_a_run_that_stopped_and_one_sample_are_drawn(planar_run):
    k = 40
    cut = {
        name: getattr(planar_run, name)[:k]
        for name in planar_run.__dataclass_fields__
        if isinstance(getattr(planar_run, name), np.ndarray)
    }
    stopped = replace(planar_run, **cut, status="stopped", reason="a test ended it")
    assert words.finding(stopped) == "planar_3r stops at 0.78 s: a test ended it"
    sheet = drawn.draw_runs({"one": planar_run, "two": stopped})
    assert [text.get_text() for text in sheet.legends[0].get_texts()] == ["one", "two (×: stopped)"]
    single = replace(stopped, **{name: values[:1] for name, values in cut.items()})
    drawn.draw_run(single).savefig(io.BytesIO(), format="svg")
    table = words.comparison_table({"one": planar_run, "two": stopped})
    assert [row[1:3] for row in table.rows] == [("complete", 2.0), ("stopped", 0.78)]
    assert "µs" not in str(table)
    assert words.comparison_finding({"one": planar_run, "two": stopped}).startswith("Only one follows the path")
    assert words.comparison_finding({"two": stopped}) == "No method follows the path to its end"


def test_gains_and_steps_that_lose_the_path_are_crossed_out():
    worst = [[0.001, 0.002, 0.01], [0.001, 0.02, 0.3], [0.01, 0.5, math.nan]]
    figure = drawn.draw_stability([-1.0, -10.0, -100.0], [0.001, 0.01, 0.1], worst, bound=[-50.0, -5.0, -0.5])
    axes = figure.axes[0]
    assert axes.get_title(loc="left").replace("\n", " ") == (
        "The path is followed with gains down to −100 at a step of 1 ms, −1 at 100 ms"
    )
    crosses = next(line for line in axes.lines if line.get_marker() == "x").get_xydata()
    assert sorted(map(tuple, np.round(crosses, 9).tolist())) == [(10.0, 100.0), (100.0, 10.0), (100.0, 100.0)]
    np.testing.assert_allclose(axes.lines[-1].get_xydata(), [[1.0, 50.0], [10.0, 5.0], [100.0, 0.5]])


def test_starts_that_gain_are_counted():
    figure = drawn.draw_population([0.01, 0.02, 0.03], [0.02, 0.01, 0.04], ("a", "b"), {"A": (0.01, 0.02)}, "title")
    labels = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert labels == ["gain: 2 starts", "lose: 1"]


def test_a_determinant_below_the_scale_is_marked_at_its_edge():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = [0.0, 1.0, -1.0]
    outwards = line_from(arm, q, [1.0, 0.0])
    run = cr.track(arm, outwards, q, gain=0.0, damping=Damping("constant", 0.1))
    assert run.determinant.min() < 1e-7 * run.determinant.max()
    axes = drawn.draw_run(run).axes[1]
    dot = next(line for line in axes.lines if line.get_marker() == "o")
    assert dot.get_ydata()[0] == axes.get_ylim()[0] > run.determinant.min()
    assert "tip off by up to 1970 mm" in words.finding(replace(run, position_error=0.0 * run.position_error + 1.39))


def test_eight_lines_differ_in_grey():
    looks = [line_look(k) for k in range(8)]
    assert len({str(look["ls"]) for look in looks}) == 8 and len({look["color"] for look in looks}) == 7


def test_units_of_slides_and_masses():
    arm = cr.planar("PRR", [0.2, 0.35, 0.25])
    assert words.rate_unit(arm) == "m/s or rad/s"
    assert words.torque_unit(arm) == "N or N m"
    assert words.masses(arm) == ""


def test_a_circle_above_the_base_goes_along_x():
    arm = cr.load("panda")
    straight = np.zeros(7)  # the tip is beside the base's axis, 0.088 m along x
    path = circle_through(arm, straight, 0.05)
    np.testing.assert_allclose(path.sample([0.0], "position").held[0], arm.position(straight), atol=1e-14)
    np.testing.assert_allclose(path.sample([0.0, 1.0], "pose").held[1][:3, :3], arm.pose(straight)[:3, :3], atol=1e-14)
    up = cr.planar_3r(1.0, 0.5, 0.5)
    folded = [0.3, math.pi, 0.0]  # the tip is on the base
    path = circle_through(up, folded, 0.05)
    np.testing.assert_allclose(path.sample([0.0, 1.0], "position").held, [[0.0, 0.0], [-0.1, 0.0]], atol=1e-12)


def test_samples_refuse_what_does_not_fit():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    for call in (
        lambda: circle_through(arm, [0.0, 1.0], 0.1),
        lambda: circle_through(arm, [0.0, 1.0, 0.0], 0.0),
        lambda: line_from(arm, [0.0, 1.0, 0.0], [0.1, 0.0, 0.0]),
        lambda: line_from(arm, [0.0, 1.0, math.nan], [0.1, 0.0]),
        lambda: good_posture(arm, "dance"),
    ):
        with pytest.raises(cr.InputError):
            call()
