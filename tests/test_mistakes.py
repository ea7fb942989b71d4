"""Mistakes a person makes: each gets one line that helps, or a note beside the answer, and never a traceback."""

import json
import math
import os
import subprocess
import sys
import warnings

import numpy as np
import pytest

import chainrule as cr
from chainrule import outputs
from chainrule.arm import checked_arm
from chainrule.console import angle
from chainrule.errors import InputError
from chainrule.inputs import whole_number
from chainrule.plot import draw_arm
from chainrule.readers.urdf import from_urdf
from chainrule.redundancy.samples import circle_through

LINE = cr.TaskPath.line((0.6, 0.3), (1.2, 0.6), duration=1.0)
FLAT = cr.planar_3r(1.0, 0.5, 0.25)


def process(code, **options):
    """A Python process of its own; the runtime is imported, not installed."""
    return subprocess.run(
        [sys.executable, "-c", code], stderr=subprocess.PIPE, text=True, check=False, timeout=120, **options
    )


def test_an_interrupt_while_modules_are_imported_is_quiet():
    """Ctrl-C when the first large module is looked for; an error there still shows its traceback."""
    code = """
import sys
class Finder:
    def find_spec(self, name, *rest):
        if name == "typer":
            raise {error}
sys.meta_path.insert(0, Finder())
from chainrule.cli import main
main()
"""
    done = process(code.format(error="KeyboardInterrupt"))
    assert (done.returncode, done.stderr) == (130, "")
    done = process(code.format(error="ZeroDivisionError"))
    assert done.returncode == 1
    assert "Traceback" in done.stderr


# ---- on the command line -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("frobnicate",), "chainrule --help"),
        (("eval", "panda"), "chainrule eval --help"),
        (("classify", "-1,2,1.5,1"), "write -- before an argument"),
        (("show", "panda", "--tip", "hand"), "an embedded arm is one chain"),
        (("workspace", "planar_3r", "--figure", "w.bmp"), ".svg, .png or .pdf"),
        (("track", "planar_3r", "--circle", "0.1", "--csv", "missing/t.csv"), "there is no folder missing"),
        (("track", "planar_3r", "--circle", "0.1", "--figure", "missing/t.svg"), "there is no folder missing"),
        (("track", "planar_3r", "--circle", "0.1", "--dt", "1e-9"), "dt: 1e-09 s; from 2e-06 to 2 s are accepted"),
        (("track", "planar_3r", "--circle", "0.1", "--dt", "5"), "dt: 5 s; from 2e-06 to 2 s are accepted"),
        (("track", "planar_3r", "--circle", "0.1", "--start", "bst"), "'bst'; 3 joint values, best or followable"),
        (("track", "planar_3r", "--path", "sanchez-ark"), "sanchez-arc, sanchez-ellipse, sanchez-line"),
        (("track", "free.toml", "--circle", "0.1", "--limits"), "free has no limits to keep"),
        (("track", "free.toml", "--path", "points.csv"), "no times; a column t, or a duration"),
        (("track", "free.toml", "--path", "times.csv", "--duration", "3"), "the file has times of its own"),
        (("self-motion", "planar_3r", "--target", "1,0.5", "--points", "1000000000"), "up to 100000 are accepted"),
        (("track", "free.toml", "--circle", "0.1", "--criterion", "limits"), "free: criterion 'limits': no joint has"),
        (
            ("track", "free.toml", "--circle", "0.1", "--acceleration", "0", "--limits"),
            "limit of joint1, joint2, joint3",
        ),
        (("track", "planar_3r", "--circle", "0.1", "--gain", "inf"), "gain: inf"),
        (
            ("classify", "1e308,1e308,1e308,1e308"),
            "d2 = 1e+308 m; lengths of 0, or from 1e-100 to 1e100 m and none more than",
        ),
        (
            ("classify", "1e-308,1e-300,1,1"),
            "d2 = 1e-308 m and d4 = 1 m; lengths of 0, or from 1e-100 to 1e100 m and none",
        ),
        (
            ("classify", "5e-324,1,1,1e308", "--exact"),
            "d2 = 4.94066e-324 m and r2 = 1e+308 m; lengths of 0, or from 1e-100",
        ),
        (("classify", "1e-320,0,0,0"), "d2 = 9.99989e-321 m; lengths of 0, or from 1e-100 to 1e100 m"),
        (("min-time", "free.toml", "--from", "0,0,0", "--to", "1,1,1", "--velocity", "1,2"), "one, or one for each"),
    ],
)
def test_a_mistake_is_one_line_that_helps(call, arguments, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "free.toml").write_text(
        'chainrule = 1\nname = "free"\nangles = "rad"\n[planar]\nkinds = "RRR"\nlengths = [1, 0.5, 0.25]\n'
    )
    (tmp_path / "points.csv").write_text("x,y\n0.5,0.5\n0.7,0.6\n0.9,0.5\n")
    (tmp_path / "times.csv").write_text("t,x,y\n0,0.5,0.5\n1,0.7,0.6\n2,0.9,0.5\n")
    before = sorted(tmp_path.iterdir())
    code, out, err = call(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("chainrule: ")
    assert err.count("\n") == 1
    assert said in err
    assert sorted(tmp_path.iterdir()) == before


def test_degrees_without_deg_are_wondered_at(call):
    code, out, err = call("eval", "planar_3r", "position", "--q", "0,-45,90", "--json")
    assert code == 0
    assert json.loads(out)["q"] == [0.0, -45.0, 90.0]  # what was asked is answered
    assert err == "chainrule: note: --q: 90 is taken as rad, 14.3 turns; --deg is for degrees\n"
    for arguments in (("--q", "0,-45,90", "--deg"), ("--q", "0,-0.8,12")):
        assert call("eval", "planar_3r", "position", *arguments)[2] == ""
    _, _, err = call("self-motion", "planar_3r", "--target", "1,90", "--task", "x_alpha")
    assert "--target: 90 is taken as rad" in err
    _, _, err = call("min-time", "planar_3r", "--from", "0,0,0", "--pose", "1,0.5,-90")
    assert "--pose: -90 is taken as rad" in err


def test_slides_are_not_wondered_at(capsys):
    assert angle(90.0, True, "--q") == math.pi / 2
    assert angle(12.5, False, "--q") == 12.5
    assert capsys.readouterr().err == ""


def test_a_gain_that_seeks_singularities_is_told(call):
    _, _, err = call("track", "planar_3r", "--circle", "0.1", "--gain", "2")
    assert err == "chainrule: note: --gain 2 raises H^(-1/2), so that singularities are sought\n"
    for gain, criterion in ((-2, "1/H"), (0, "H"), (2, "H")):
        assert call("track", "planar_3r", "--circle", "0.1", "--gain", gain, "--criterion", criterion)[2] == ""


def test_poses_without_times_take_a_duration(call, tmp_path):
    file = tmp_path / "points.csv"
    file.write_text("x,y\n0.5,0.5\n0.7,0.6\n0.9,0.5\n")
    code, out, err = call("track", "planar_3r", "--path", file, "--duration", "3", "--json")
    assert (code, err) == (0, "")
    assert json.loads(out)["run"]["t"][-1] == pytest.approx(3.0)


def test_one_bound_stands_for_all_joints(call):
    arguments = ("min-time", "planar_3r", "--from", "0,0,0", "--to", "1,1,1", "--acceleration", "4", "--json")
    one = call(*arguments, "--velocity", "2")
    each = call(*arguments, "--velocity", "2,2,2")
    assert one == each
    assert one[0] == 0


def test_an_arm_without_limits_is_said_to_have_none(call):
    assert "planar_3r has no position limits." in call("self-motion", "planar_3r", "--target", "1,0.5", "--limits")[1]


# ---- the place it runs in ----------------------------------------------------------------------------------------


@pytest.mark.skipif(os.name != "posix", reason="a closed descriptor is made by the shell")
def test_a_closed_output_is_no_error():
    done = subprocess.run(
        ["sh", "-c", f'"{sys.executable}" -m chainrule.cli arms >&-'], stderr=subprocess.PIPE, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_an_output_without_greek_shows_what_it_can():
    code = "import sys; from chainrule import cli; sys.exit(cli.run(['track', 'planar_3r', '--circle', '0.1']))"
    done = process(code, stdout=subprocess.PIPE, env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stderr) == (0, "")
    assert "H ? 0." in done.stdout


def test_a_package_that_is_missing_is_named():
    code = """if True:
        import sys
        sys.modules["matplotlib"] = None
        from chainrule import cli
        sys.exit(cli.run(["workspace", "planar_3r", "--figure", "w.svg"]))
    """
    done = process(code)
    assert done.returncode == 2
    assert done.stderr.startswith("chainrule: the package matplotlib, which this needs, cannot be imported; installing")
    assert done.stderr.count("\n") == 1


def test_too_much_for_the_memory_is_one_line(call, monkeypatch):
    from chainrule.commands import arms

    monkeypatch.setattr(arms, "load_arm", lambda *rest: (_ for _ in ()).throw(MemoryError))
    assert call("show", "panda") == (2, "", "chainrule: there is not enough memory for so much at once\n")


def test_a_folder_that_may_not_be_written_is_refused_before_the_work(tmp_path, monkeypatch):
    monkeypatch.setattr(outputs.os, "access", lambda path, mode: False)  # as of a read-only folder
    with pytest.raises(InputError, match="cannot be written to"):
        outputs.output_file(tmp_path / "page.html")


# ---- in Python ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: cr.Arm.from_dh([("R", 0, 0, 0, 0), ("R", -90, 0.1, 0, 0)]), "row 2, column 'alpha': -90 rad is more"),
        (lambda: cr.Arm.from_dh([("R", 0, 0, 0, 180)]), "row 1, column 'theta': 180 rad is more"),
        (lambda: cr.planar("RPR", [1, 1, 1], [0, 30, 0]), "headings, joint 2: 30 rad is more"),
        (lambda: cr.load("panda", tip="hand"), "panda: tip and base are accepted for a .urdf only"),
        (lambda: cr.load(None), "not from None"),
        (lambda: cr.load(b"panda"), "not from b'panda'"),
        (lambda: cr.track(FLAT, LINE, dt=3.0), "dt: 3 s; from 1e-06 to 1 s are accepted"),
        (lambda: cr.track_globally(FLAT, LINE, dt=1e-9), "dt: 1e-09 s"),
        (lambda: cr.track_batch(FLAT, LINE, [0.1, 0.2, 0.3], 0.0, [1e-9]), "dt: 1e-09 s"),
        (lambda: cr.self_motion(FLAT, [1.0, 0.5], points=10**9), "up to 100000"),
        (lambda: cr.self_motion("panda", np.eye(4)), "arm: 'panda'"),
        (lambda: cr.track("panda", LINE), "arm: 'panda'"),
        (lambda: cr.track_batch("panda", LINE, [0.0]), "arm: 'panda'"),
        (lambda: cr.track_globally("panda", LINE), "arm: 'panda'"),
        (lambda: cr.forecast("panda", LINE, [0.0]), "arm: 'panda'"),
        (lambda: cr.max_manipulability("panda"), "arm: 'panda'"),
        (lambda: cr.workspace("panda"), "arm: 'panda'"),
        (lambda: cr.generate("panda", "nowhere"), "arm: 'panda'"),
        (lambda: cr.regional_3r("panda"), "arm: 'panda'"),
        (lambda: cr.postures("planar_3r", 1.0, 0.0, 0.0), "arm: 'planar_3r'"),
        (lambda: circle_through("panda", [0.0] * 7, 0.1), "arm: 'panda'"),
        (lambda: draw_arm("panda", [0.0] * 7), "arm: 'panda'"),
        (lambda: draw_arm(FLAT, [0.0] * 2), "q: shape (2,); (3,)"),
        (lambda: cr.track(FLAT, cr.Circle((0.5, 0.5), 0.1)), "a TaskPath is accepted, such as TaskPath.line gives"),
        (lambda: cr.track(FLAT, LINE, push=[0.0, 0.0, 1.0]), "push: [0.0, 0.0, 1.0]; a function of t and q"),
        (lambda: cr.forecast(FLAT, LINE, [0.0] * 3, "large"), "gain: 'large'"),
        (lambda: cr.fastest_run(cr.track(FLAT, LINE), LINE), "planar_3r has no acceleration limit"),
        (lambda: cr.fastest_run("run", LINE), "run: 'run'; a Run is accepted"),
        (lambda: cr.generate(FLAT, None), "directory: None"),
        (lambda: cr.generate(FLAT, "code", targets="rust"), "targets: ['rust']"),
        (lambda: cr.planar("R", [1.0]).manipulability([0.0]), "an arm with more joints is accepted"),
        (lambda: cr.planar("RR", [1.0, 1.0]).minors([0.0, 0.0], task="pose"), "'position' or 'x_alpha' is accepted"),
        (lambda: whole_number(7, "size", 1, 5), "size: 7; up to 5 are accepted"),
    ],
)
def test_a_mistake_is_an_input_error(make, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        make()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_what_is_meant_in_radians_is_taken():
    turns = [0.0, 2.0 * math.pi, -2.0 * math.pi, 3.14159, 6.2832, 7 * (math.pi / 2)]  # rounded, and whole quarters
    for turn in turns:
        arm = cr.Arm.from_dh([("R", turn, 0.3, 0.0, turn)], tool=(0.1, 0.2, 0.0))
        assert arm.n == 1
    assert checked_arm(FLAT) is FLAT


URDF = """<robot name="two"><link name="base"/>{links}
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin rpy="{rpy}"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>{joints}
</robot>"""


def two(rpy="0 0 0", more=0):
    links = "".join(f'<link name="l{k}"/>' for k in range(1, more + 2))
    joints = "".join(
        f'<joint name="f{k}" type="fixed"><parent link="l{k}"/><child link="l{k + 1}"/></joint>'
        for k in range(1, more + 1)
    )
    return URDF.format(links=links, rpy=rpy, joints=joints).encode()


def test_degrees_in_a_urdf_are_wondered_at():
    with pytest.warns(UserWarning, match="rpy 0 90 0 is more than a full turn; a URDF is in rad"):
        from_urdf(two("0 90 0"), tip="l1")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        from_urdf(two("0 1.5707963 6.2832"), tip="l1")


def test_links_that_are_named_alike_are_shown():
    with pytest.raises(InputError, match="tip 'l 9' is not a link of the file; like it are 'l9'"):
        from_urdf(two(more=12), tip="l 9")
    with pytest.raises(InputError, match="it has 'base', 'l1', 'l2', 'l3', 'l4', 'l5' and 8 more"):
        from_urdf(two(more=12), tip="hand")


def test_a_start_off_the_path_is_an_event():
    off = np.array([0.1, 0.2, 0.3])
    run = cr.track(FLAT, LINE, off)
    (event,) = (event for event in run.events if event.kind == "start off the path")
    assert event.t == 0.0
    away = 1000.0 * np.hypot(*(FLAT.position(off) - (0.6, 0.3)))
    assert f"begins {float(f'{away:.2e}'):g} mm" in event.text
    assert not [event for event in cr.track(FLAT, LINE, "best").events if event.kind == "start off the path"]


def test_gains_lead_away_from_singularities_unless_they_are_given():
    start = cr.track(FLAT, LINE, [1.0, -2.0, 1.5]).q[20]  # drawn onto the path, and not where H is largest
    line = cr.TaskPath.line(FLAT.position(start), (1.2, 0.6), duration=1.0)
    plain = cr.track(FLAT, line, start, method="pseudoinverse", dt=0.01)
    for criterion in ("H", "1/H", "H^(-1/2)"):
        run = cr.track(FLAT, line, start, criterion=criterion, dt=0.01)
        assert run.manipulability[-1] > plain.manipulability[-1]
