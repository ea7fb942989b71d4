"""``chainrule self-motion`` and the figures it draws: what it prints and writes, and how it refuses."""

import csv
import io
import json
import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from PIL import Image

import chainrule as cr
from chainrule.plot.self_motion import animation, draw_self_motion
from chainrule.self_motions import words
from chainrule.self_motions.result import ENDS, limit_reason

D = np.array([0.40, 0.35, 0.25])
POSTURE = "0.1,-0.5,0.3,-2.0,0.2,1.6,0.4"


@pytest.fixture
def call(call):
    return partial(call, "self-motion")


def tip(q):
    """Of the paper's arm, written out."""
    angles = np.cumsum(q, axis=-1)
    return np.stack([(D * np.cos(angles)).sum(axis=-1), (D * np.sin(angles)).sum(axis=-1)], axis=-1)


def test_a_table_of_the_curves(call):
    code, out, err = call("lenarcic_3r", "--target", "0.4,0", "--best", "manipulability")
    assert (code, err) == (0, "")
    assert out.startswith("lenarcic_3r, task position. 2 closed curves of length 8.238 rad each: ")
    assert "These are all curves (closed form, proved)." in out
    assert "The nearest singular target is 0.1 m away." in out  # 0.3 and 0.5
    assert "all round" in out
    assert "q3 −1" in out
    assert "Best posture (largest H): 0.202425" in out


def test_json_is_what_the_library_says(call):
    code, out, err = call("lenarcic_3r", "--target", "0.4,0.1", "--json", "--points", 11)
    assert (code, err) == (0, "")
    told, found = json.loads(out), cr.self_motion(cr.load("lenarcic_3r"), [0.4, 0.1], points=11)
    assert told["count"] == found.count == 2
    assert told["best"] is None
    assert [c["length"] for c in told["components"]] == [c.length for c in found.components]
    points = np.array([c["q"] for c in told["components"]])
    assert points.shape == (2, 11, 3)
    np.testing.assert_allclose(tip(points), np.broadcast_to([0.4, 0.1], (2, 11, 2)), atol=1e-13)


def test_points_of_all_curves_as_csv(call, tmp_path):
    file = tmp_path / "curves.csv"
    code, out, _ = call("lenarcic_3r", "--target", "0.4,0", "--csv", file, "--points", 401)
    assert code == 0
    assert str(file) in out
    rows = list(csv.DictReader(io.StringIO(file.read_text("ascii"))))
    assert list(rows[0]) == ["curve", "s", "q1", "q2", "q3", "H"]
    assert [row["curve"] for row in rows] == ["1"] * 401 + ["2"] * 401
    for k in (1, 2):
        mine = np.array([[float(v) for v in row.values()] for row in rows if row["curve"] == str(k)])
        q, s = mine[:, 2:5], mine[:, 1]
        np.testing.assert_allclose(tip(q), np.broadcast_to([0.4, 0.0], (401, 2)), atol=1e-13)
        chords = np.linalg.norm(np.diff(q, axis=0), axis=1)
        np.testing.assert_allclose(np.diff(s), chords, rtol=1e-3)  # s is the arc length
        assert s[0] == 0.0
        end = (q[-1] - q[0]) / (2 * math.pi)
        np.testing.assert_allclose(end, np.round(end), atol=1e-12)
        j2 = np.stack([-np.sin(np.cumsum(q, axis=1)) * D, np.cos(np.cumsum(q, axis=1)) * D], axis=1)
        jacobian = np.cumsum(j2[:, :, ::-1], axis=2)[:, :, ::-1]
        h = np.sqrt(np.linalg.det(jacobian @ np.swapaxes(jacobian, 1, 2)))
        np.testing.assert_allclose(mine[:, 5], h, rtol=1e-9)


def test_figure_and_animation(call, tmp_path):
    figure, moving = tmp_path / "a.svg", tmp_path / "a.gif"
    code, out, err = call("lenarcic_3r", "--target", "0.7,0", "--figure", figure, "--animation", moving)
    assert (code, err) == (0, "")
    assert "1 closed curve of length" in figure.read_text("utf-8")
    with Image.open(moving) as picture:
        assert picture.format == "GIF"
        assert picture.n_frames > 60
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.gif", "a.svg"]
    assert out.splitlines()[-2:] == [str(figure), str(moving)]


def test_a_posture_whose_pose_is_held_within_limits(call):
    code, out, err = call("panda", "--at", POSTURE, "--limits", "--best", "limits", "--json", "--points", 5)
    assert (code, err) == (0, "")
    told = json.loads(out)
    arm = cr.load("panda")
    assert (told["count"], told["complete"]) == (8, "proved")
    pose = arm.pose([float(v) for v in POSTURE.split(",")])
    for part in told["feasible"]:
        np.testing.assert_allclose(arm.pose(part["q"]), np.broadcast_to(pose, (5, 4, 4)), atol=1e-9)
        low, high = arm.limits.position.T
        assert (np.array(part["q"]) >= low - 1e-9).all()
        assert (np.array(part["q"]) <= high + 1e-9).all()
    best = told["best"]["maxima"][0]
    low, high = arm.limits.position.T
    q = np.array(best["q"])
    assert best["value"] == pytest.approx((np.minimum(q - low, high - q) / ((high - low) / 2)).min(), rel=1e-9)
    assert best["value"] >= (np.minimum(-low, high) / ((high - low) / 2)).min()


def test_arcs_in_csv_name_their_curve(call, tmp_path):
    file = tmp_path / "arcs.csv"
    code, _, err = call("panda", "--at", POSTURE, "--limits", "--csv", file, "--points", 3)
    assert (code, err) == (0, "")
    rows = list(csv.DictReader(io.StringIO(file.read_text("ascii"))))
    assert list(rows[0])[:3] == ["curve", "arc", "s"]
    arm = cr.load("panda")
    found = cr.self_motion(arm, arm.pose([float(v) for v in POSTURE.split(",")]), limits=True)
    assert [(row["curve"], row["arc"]) for row in rows[::3]] == [
        (str(part.of + 1), str(k + 1)) for k, part in enumerate(found.feasible)
    ]
    assert len({row["curve"] for row in rows}) < len({row["arc"] for row in rows})


def test_starts_scale_and_gamma_are_passed_on(call):
    told = json.loads(call("lenarcic_3r", "--target", "0.4,0", "--method", "continuation", "--starts", 9, "--json")[1])
    assert told["complete"].startswith("9 starts and 9 extremal points")
    told = json.loads(call("lenarcic_3r", "--target", "0.4,0", "--method", "eigenvector", "--gamma", 0.01, "--json")[1])
    assert told["components"][0]["length"] == pytest.approx(8.238, abs=0.06)
    assert told["components"][0]["closure"] > 1e-3
    code, _, err = call("lenarcic_3r", "--target", "0.4,0", "--method", "continuation", "--scale", 0)
    assert code == 2 and "scale" in err and "\n" not in err.strip()


def test_a_singular_target_near_by(call):
    code, out, err = call("lenarcic_3r", "--target", "0.38,0", "--singular")
    assert (code, err) == (0, "")
    assert "A singular target is 0.08 m away (others may be nearer), at " in out  # 0.3
    told = json.loads(call("lenarcic_3r", "--target", "0.38,0", "--singular", "--json")[1])
    assert told["singular"]["target"] == pytest.approx([0.3, 0.0], abs=1e-9)
    assert call("lenarcic_3r", "--along", "0.1:0.5:3", "--singular")[0] == 2


def test_degrees_turn_angles_only(call):
    one = call("lenarcic_3r", "--target", "0.28,60", "--task", "x_alpha", "--deg", "--json")[1]
    two = call("lenarcic_3r", "--target", f"0.28,{math.radians(60)!r}", "--task", "x_alpha", "--json")[1]
    assert json.loads(one)["target"] == json.loads(two)["target"]
    three = call("lenarcic_3r", "--at=10,20,30", "--deg", "--json")[1]
    np.testing.assert_allclose(json.loads(three)["target"], tip(np.radians([10.0, 20.0, 30.0])), atol=1e-15)


def test_along_a_line_of_targets(call):
    code, out, err = call("lenarcic_3r", "--along", "0.22:0.92:15", "--target", "0,0.1", "--json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    x = np.linspace(0.22, 0.92, 15)
    np.testing.assert_allclose(told["targets"], np.stack([x, np.full(15, 0.1)], axis=1), atol=1e-15)
    r = np.hypot(x, 0.1)
    assert told["count"] == [2 if 0.3 < each < 0.5 else 1 for each in r]
    assert [change["kind"] for change in told["changes"]] == ["split", "merge"]
    places = np.interp([change["at"] for change in told["changes"]], np.arange(15), x)
    np.testing.assert_allclose(places, np.sqrt(np.array([0.3, 0.5]) ** 2 - 0.01), atol=1e-12)
    code, out, err = call("lenarcic_3r", "--along", "0.22:0.92:15", "--target", "0,0.1")
    assert code == 0
    assert "every one splits, merges or vanishes" in out
    assert "Where curves change" in out


def test_along_draws_the_lengths(call, tmp_path):
    code, out, _ = call("lenarcic_3r", "--along", "0.32:0.48:3", "--figure", tmp_path / "s.svg")
    assert code == 0
    assert "can be followed on each of 2 curves" in out
    assert "one in B or D" in (tmp_path / "s.svg").read_text("utf-8")


def test_what_is_out_of_reach_exits_with_one(call, tmp_path):
    code, out, err = call("lenarcic_3r", "--target", "2,0", "--figure", tmp_path / "a.png")
    assert (code, err) == (1, "")
    assert out.startswith("lenarcic_3r, task position. The target is out of reach: no posture holds it.\n")
    code, out, _ = call("lenarcic_3r", "--target", "2,0", "--json")
    assert code == 1
    assert json.loads(out)["status"] == "unreachable"
    code, out, _ = call("lenarcic_3r", "--along", "0.8:1.1:4")
    assert code == 1
    assert "1 of its 4 targets out of reach" in out
    assert "unreachable" in out


def test_a_singular_pose_is_not_out_of_reach(call):
    code, out, err = call("iiwa14", "--at", "0,0,0,0,0,0,0")
    assert (code, err) == (0, "")
    assert "The target is singular" in out


def test_no_best_posture_within_the_limits_exits_with_one(call, tmp_path):
    file = tmp_path / "stiff.toml"
    file.write_text(
        'chainrule = 1\nname = "stiff"\nsource = "none"\nangles = "rad"\n[planar]\nkinds = "RRR"\n'
        "lengths = [0.4, 0.35, 0.25]\n"
        + "".join(f"[[joints]]\nposition = [{a}, {b}]\n" for a, b in ((-3.0, 3.0), (-0.1, 0.1), (-0.1, 0.1)))
    )
    code, out, err = call(file, "--target", "0.1,0", "--limits", "--best", "manipulability")
    assert (code, err) == (1, "")
    assert "no posture within them holds the target" in out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("lenarcic_3r",), "one of --target and --at gives it"),
        (("lenarcic_3r", "--target", "0.4"), "--target: 1 number given; 2 are accepted"),
        (("lenarcic_3r", "--target", "0.4,x"), "--target, entry 2"),
        (("lenarcic_3r", "--target", "nan,0"), "--target, entry 1"),
        (("lenarcic_3r", "--target", "0.4,0", "--at", "0,0,0"), "not both"),
        (("lenarcic_3r", "--at", "0,0"), "--at: 2 numbers given"),
        (("lenarcic_3r", "--target", "0.4,0", "--task", "pose"), "position, x_alpha is accepted"),
        (("lenarcic_3r", "--target", "0.4,0", "--task", "dance"), "there is no task"),
        (("lenarcic_3r", "--target", "0.4,0", "--method", "luck"), "method"),
        (("lenarcic_3r", "--target", "0.4,0", "--best", "luck"), "--best"),
        (("lenarcic_3r", "--target", "0.4,0", "--best", "limits"), "no joint has two limits"),
        (("lenarcic_3r", "--target", "0.4,0", "--points", "1"), "points"),
        (("lenarcic_3r", "--target", "0.4,0", "--figure", "a.bmp"), ".svg, .png or .pdf"),
        (("lenarcic_3r", "--target", "0.4,0", "--animation", "a.mp4"), ".gif"),
        (("lenarcic_3r", "--target", "0.4,0", "--csv", "a.txt"), ".csv"),
        (("lenarcic_3r", "--target", "2,0", "--animation", "a.gif"), "there is no curve to show at this target"),
        (("lenarcic_3r", "--along", "0:1"), "X0:X1:N is accepted"),
        (("lenarcic_3r", "--along", "0:1:1"), "a whole number of 2 or more"),
        (("lenarcic_3r", "--along", "0:1:1e9"), "a whole number of 2 or more"),
        (("lenarcic_3r", "--along", "0:inf:3"), "not a finite number"),
        (("lenarcic_3r", "--along", "0:1:3", "--csv", "a.csv"), "--csv is for one target"),
        (("lenarcic_3r", "--along", "0:1:3", "--best", "limits"), "--best is for one target"),
        (("panda", "--along", "0:1:3"), "one of --target and --at gives it"),
        (("panda", "--along", "0:1:3", "--at", POSTURE, "--figure", "a.svg"), "for planar 3R arms"),
        (("panda", "--target", "0.3,0.2,0.5"), "3 numbers given; 16 are accepted"),
        (("ur5e", "--at", "0,0,0,0,0,0"), "one joint more"),
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


# ---- figures -------------------------------------------------------------------------------------------------------


def test_a_figure_of_every_kind_of_self_motion():
    arm = cr.planar_3r(*D)
    for target, title in (
        ([0.5, 0.0], "The target is singular: figure of eight"),
        ([1.0, 0.0], "The target is singular: isolated point"),
        ([0.0, 0.0], "2 closed curves"),
        ([3.0, 0.0], "The target is out of reach"),
    ):
        found = cr.self_motion(arm, target)
        drawing = draw_self_motion(arm, found)
        assert drawing.get_suptitle().startswith(title)
        drawing.savefig(io.BytesIO(), format="svg")


def test_the_fan_rests_at_the_target_and_limits_fade():
    arm = cr.planar_3r(*D).with_limits(position=[(-2.0, 2.0)] * 3)
    found = cr.self_motion(arm, [0.4, 0.0], limits=True)
    fan = draw_self_motion(arm, found).axes[0]
    lines = [line for line in fan.lines if len(line.get_xdata()) == 5]  # base, three joints, tip
    assert len(lines) == 14
    clear = 0
    for line in lines:
        xy = line.get_xydata()
        np.testing.assert_allclose(xy[-1], [0.4, 0.0], atol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(np.diff(xy[1:], axis=0), axis=1), D, atol=1e-12)
        turns = np.diff(np.unwrap(np.arctan2(*np.diff(xy[1:], axis=0).T[::-1])), prepend=0.0)
        inside = (np.abs((turns + np.pi) % (2 * np.pi) - np.pi) <= 2.0).all()
        assert line.get_alpha() == (1.0 if inside else 0.25)
        clear += inside
    assert 0 < clear < 14


def test_the_animation_moves_the_arm_and_not_the_tip():
    arm = cr.planar_3r(*D)
    with Image.open(io.BytesIO(animation(arm, cr.self_motion(arm, [0.4, 0.0]), frames=6))) as picture:
        frames = []
        for k in range(picture.n_frames):
            picture.seek(k)
            frames.append(np.asarray(picture.convert("RGB")).astype(int))
    assert len(frames) == 6
    red = [(f[..., 0] > 150) & (f[..., 1] < 70) & (f[..., 2] < 70) for f in frames]
    assert red[0].sum() > 20
    for before, after, r in zip(frames[:-1], frames[1:], red[1:], strict=True):
        assert np.abs(before - after).max() > 100
        assert (r == red[0]).mean() > 0.999


def test_ends_of_arcs_are_short():
    arm = cr.planar_3r(*D).with_limits(position=[(-2.0, 2.0)] * 3)
    found = cr.self_motion(arm, [0.4, 0.0], limits=True)
    part = replace(found.feasible[0], ends=(limit_reason(3, True), ENDS["singular"]))
    table = words.arcs_table(arm, replace(found, feasible=(part,)))
    assert table.rows[0][-1] == "q3 (upper), singular"
    assert words.arcs_table(arm, found).rows[0][:2] == (1, 1)


# ---- words ---------------------------------------------------------------------------------------------------------


def test_words_do_not_claim_what_is_not_known():
    arm = cr.planar("PPP", [0.1, 0.3, 0.4], [0.0, 0.7, 1.9])
    found = cr.self_motion(arm, [0.4, 0.3])
    assert words.finding(found).endswith("it does not close")
    assert words.completeness(found).startswith("Not proved to be all (continuation: ")
    slide = cr.planar("PRR", [0.2, 0.35, 0.25])
    assert words.finding(cr.self_motion(slide, [0.4, 0.3])).endswith("no other was found")
    nothing = cr.self_motion(slide, [0.4, 3.0])
    assert words.finding(nothing) == "The target is out of reach: no posture that holds it was found"
    paper = cr.self_motion(cr.load("lenarcic_3r"), [0.4, 0.0], method="eigenvector")
    assert words.finding(paper).endswith("no other was looked for")
    assert words.completeness(paper).startswith("Not proved to be all (eigenvector: ")


def test_ranges_of_slides_are_in_metres():
    arm = cr.planar("RPR", [0.2, 0.35, 0.25])
    found = cr.self_motion(arm, [0.4, 0.3])
    table = words.curves_table(arm, found)
    assert [column.heading for column in table.columns][3:6] == ["q1 [°]", "q2 [m]", "q3 [°]"]
    for row, curve in zip(table.rows, found.components, strict=True):
        low, high = (float(text.replace("−", "-")) for text in str(row[4]).split(" … "))
        np.testing.assert_allclose([low, high], curve.box[1], atol=5.001e-5)
        assert row[5] == "all round"
