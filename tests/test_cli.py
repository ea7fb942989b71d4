"""The command line: output, JSON, exit codes, one line for bad input, nothing evaluated from text."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

import chainrule as cr
from chainrule import arms as embedded
from chainrule import papers


def refused(result):
    code, out, err = result
    assert code == 2
    assert out == ""
    assert err.startswith("chainrule: ")
    assert err.count("\n") == 1
    assert "Traceback" not in err
    return err


def test_help_is_quick_and_has_an_example_for_every_command(call):
    code, out, _ = call("--help")
    assert code == 0
    for command in ("arms", "show", "eval", "generate", "report", "reproduce", "self-motion", "track"):
        assert command in out
        code, text, _ = call(command, "--help")
        assert code == 0
        assert f"Example: chainrule {command}" in text
        assert "--json" in text


def test_help_loads_nothing_heavy():
    heavy = "{'numpy', 'sympy', 'casadi', 'matplotlib', 'scipy', 'jinja2'}"
    code = f"import sys; from chainrule import cli; cli.run(['--help']); assert not {heavy} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.DEVNULL)


def test_arms(call):
    code, out, err = call("arms", "--json")
    assert (code, err) == (0, "")
    assert [row["name"] for row in json.loads(out)] == list(embedded.names())
    code, out, _ = call("arms")
    assert code == 0
    assert "sanchez_8r" in out


def test_show(call):
    code, out, err = call("show", "panda", "--json")
    assert (code, err) == (0, "")
    shown = json.loads(out)
    assert shown["kinds"] == "RRRRRRR"
    assert shown["geometry"][3]["a"] == 0.0825
    assert shown["tool"][0]["z"] == 0.107
    assert shown["joints"][3]["upper"] == -0.0698
    assert {row["task"]: row["redundancy"] for row in shown["tasks"]} == {"position": 4, "pose": 1}
    assert all(row["operations"] > 0 for row in shown["functions"] if row["function"].startswith("jacobian"))
    code, out, _ = call("show", "panda")
    assert code == 0
    assert "0.0825" in out
    assert "jacobian_pose" in out


def test_eval_is_what_the_arm_says(call):
    q = [0.1, -0.8, 0.0, -2.3, 1e-1, 1.6, 0.8]
    arm = cr.load("panda")
    for name in (
        "position",
        "pose",
        "jacobian",
        "minors",
        "manipulability",
        "manipulability-gradient",
        "null-vector",
        "null-projector",
    ):
        code, out, err = call("eval", "panda", name, "--q", ",".join(map(str, q)), "--json")
        assert (code, err) == (0, "")
        expected = getattr(arm, name.replace("-", "_"))(q)
        assert json.loads(out)["result"] == expected.tolist()


def test_eval_several_configurations_in_degrees(call):
    code, out, _ = call("eval", "planar_3r", "position", "--q", "90 0 0", "--q", "-90,0,0", "--deg", "--json")
    assert code == 0
    np.testing.assert_allclose(json.loads(out)["result"], [[0, 1.75], [0, -1.75]], atol=1e-15)
    code, out, _ = call("eval", "planar_3r", "jacobian", "--task", "pose", "--q", "0 0 0")
    assert code == 0
    assert "1.75" in out


def test_degrees_leave_prismatic_joints_alone(call, tmp_path):
    file = tmp_path / "slide.toml"
    file.write_text(
        'chainrule = 1\nname = "slide"\nsource = "none"\nangles = "rad"\n[planar]\nkinds = "RP"\nlengths = [0.0, 0.5]\n'
    )
    code, out, err = call("eval", file, "position", "--q", "90 0.25", "--deg", "--json")
    assert (code, err) == (0, "")
    np.testing.assert_allclose(json.loads(out)["result"], [0.0, 0.75], atol=1e-15)


@pytest.mark.parametrize(
    "text",
    [
        "1,2",
        "1,2,3,4",
        "",
        "1,,2",
        "a,0,0",
        "nan,0,0",
        "inf,0,0",
        "1e999,0,0",
        "0x10,0,0",
        "1_0,0,0",
        "١,0,0",
        "1+1,0,0",
        "__import__('os').system('true'),0,0",
        "1,2,3;4",
        "9" * 200 + ",0,0",
    ],
)
def test_numbers_are_read_strictly(call, text):
    assert "--q" in refused(call("eval", "planar_3r", "position", "--q", text))


def test_the_wrong_entry_is_named(call):
    assert "entry 2: 'x'" in refused(call("eval", "planar_3r", "position", "--q", "0, x, 0"))


@pytest.mark.parametrize(
    "arguments",
    [
        ("nothing",),
        ("show",),
        ("show", "nobody"),
        ("show", "nowhere.urdf"),
        ("show", "panda", "--colour"),
        ("eval", "panda", "jerk", "--q", "0"),
        ("eval", "panda", "jacobian"),
        ("eval", "planar_3r", "position", "--q", "0 0 0", "--task", "pose"),
        ("eval", "planar_3r", "minors", "--q", "0 0 0", "--task", "dance"),
        ("eval", "ur5e", "null-vector", "--q", "0 0 0 0 0 0"),
        ("generate", "planar_3r", "-o", "x", "--targets", "fortran"),
        ("reproduce", "nobody"),
        ("report", "panda", "-o", "."),
        ("report", "panda", "-o", "missing/panda.html"),
        ("workspace", "planar_3r", "--figure", "missing/figure.svg"),
        ("self-motion", "lenarcic_3r", "--target", "0.4,0", "--csv", "missing/points.csv"),
        ("show", "../../etc/passwd"),
        ("show", "a\x1b[31mb\nc"),
    ],
)
def test_bad_input_is_one_line(call, arguments, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    err = refused(call(*arguments))
    assert "\x1b" not in err
    assert list(tmp_path.iterdir()) == []


def test_broken_files_are_one_line(call, tmp_path):
    file = tmp_path / "arm.toml"
    file.write_text("chainrule = 1\nname = 'q; system(\"x\")'\n[planar]\nkinds='RR'\nlengths=[1,1]\n")
    assert "arm.toml" in refused(call("show", file))


def test_terminal_controls_in_a_file_do_not_reach_the_terminal(call, tmp_path):
    file = tmp_path / "arm.toml"
    file.write_text(
        'chainrule = 1\nname = "arm"\nsource = "[red]x[/red] \\u001b[31m"\nangles = "rad"\n[planar]\nkinds = "RR"\n'
        "lengths = [1.0, 0.5]\n"
    )
    code, out, _ = call("show", file)
    if code == 0:  # else the reader has refused it already
        assert "\x1b" not in out
        assert "[red]x[/red]" in out


def test_generate(call, tmp_path):
    code, out, err = call("generate", "planar_3r", "-o", tmp_path / "code", "--targets", "python", "--json")
    assert (code, err) == (0, "")
    files = json.loads(out)["files"]
    assert files
    assert all((tmp_path / "code") in __import__("pathlib").Path(f).parents for f in files)


def test_report(call, tmp_path):
    page = tmp_path / "arm.html"
    code, out, err = call("report", "planar_3r", "-o", page, "--json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["passed"] is True
    assert told["sections"]["singular"]["proved"] is True
    assert page.read_text("utf-8").startswith("<!doctype html>")
    assert [p.name for p in tmp_path.iterdir()] == ["arm.html"]


def test_report_whose_checks_fail_exits_with_one(call, tmp_path, monkeypatch):
    from chainrule import checks

    monkeypatch.setattr(checks, "DOUBLE", 1e-30)
    code, _, err = call("report", "planar_3r", "-o", tmp_path / "arm.html")
    assert code == 1
    assert "a check failed" in err
    assert (tmp_path / "arm.html").is_file()


def test_reproduce(call, monkeypatch):
    code, out, err = call("reproduce", "deluca", "--json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["agrees"] is True
    assert len(told["papers"]["deluca"]["rows"]) > 15
    assert set(told["papers"]["deluca"]["rows"][0]) >= {
        "where",
        "quantity",
        "paper",
        "ours",
        "difference",
        "verdict",
        "how",
    }


def test_reproduce_all_papers_on_one_page(call, tmp_path, monkeypatch):
    row = papers.Row("here", "<b>a length</b>", "1", "2", 1.0, "misprint", "f(x)", "it is 2")
    asked = []
    monkeypatch.setattr(papers, "reproduce", lambda key, progress: asked.append(key) or (row,))
    monkeypatch.setattr(papers, "figures", lambda key: {})
    file = tmp_path / "papers.html"
    code, out, err = call("reproduce", "all", "--html", file)
    assert (code, err) == (0, "")
    assert asked == list(papers.PAPERS)
    assert "verdict" in out
    assert "here, <b>a length</b>: misprint: it is 2." in out
    page = file.read_text("utf-8")
    assert page.count("&lt;b&gt;a length&lt;/b&gt;") == len(asked)
    assert "<b>" not in page
    assert "It is 2." in page
    assert "f(<wbr>x)" in page
    for option, path, message in (
        ("--html", tmp_path / "x.pdf", "the page is written as .html"),
        ("--html", tmp_path / "no" / "x.html", "there is no folder"),
        ("--figures", file, "is a file; a folder is accepted"),
    ):
        assert message in refused(call("reproduce", "deluca", option, path))
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(("paper", "count"), [("baili", 7), ("lenarcic", 4), ("deluca", 4), ("ambike", 2)])
def test_figures_of_a_paper(call, tmp_path, monkeypatch, paper, count):
    monkeypatch.setattr(papers, "reproduce", lambda key, progress: ())  # the rows have tests of their own
    code, out, err = call("reproduce", paper, "--figures", tmp_path / "figures")
    assert (code, err) == (0, "")
    drawn = sorted((tmp_path / "figures").glob("*.svg"))
    assert len(drawn) == count
    assert all(path.read_text("utf-8").rstrip().endswith("</svg>") and str(path) in out for path in drawn)


def test_reproduce_says_no(call, monkeypatch):
    bad = papers.Row("here", "a length", "1", "2", 1.0, "DISAGREES", "by hand")
    monkeypatch.setattr(papers, "reproduce", lambda key, progress: (bad,))
    code, out, _ = call("reproduce", "deluca", "--json")
    assert code == 1
    assert json.loads(out)["agrees"] is False


def test_an_interrupt_is_one_line(call, monkeypatch):
    from chainrule.commands import arms

    monkeypatch.setattr(arms, "load_arm", lambda *rest: (_ for _ in ()).throw(KeyboardInterrupt))
    code, out, err = call("show", "panda")
    assert (code, out) == (130, "")
    assert err.strip() == "chainrule: interrupted"


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_an_interrupted_report_leaves_no_file(tmp_path):
    code = """if True:
        import os, signal, sys
        from chainrule import cli, report
        signal.signal(signal.SIGINT, signal.default_int_handler)  # it is ignored where tests run in the background
        report._page = lambda *rest: os.kill(os.getpid(), signal.SIGINT)
        sys.exit(cli.run(["report", "planar_3r", "-o", "page.html"]))
    """
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (130, "")
    assert done.stderr == "chainrule: interrupted\n"
    assert list(tmp_path.iterdir()) == []


def test_a_closed_pipe_is_no_error():
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(
        [sys.executable, "-m", "chainrule.cli", "arms"], stdout=write, stderr=subprocess.PIPE, text=True, check=False
    )
    os.close(write)
    assert done.returncode == 0
    assert done.stderr == ""


def test_a_folder_that_cannot_be_written(call, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    refused(call("report", "planar_3r", "-o", blocked / "page.html"))
