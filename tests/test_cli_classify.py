"""``chainrule classify``: one design, an arm, a file of designs of any length, exact answers, refusals in one line."""

import csv
import io
import json

import pytest

from chainrule.readers import designs


def test_one_design(call, tmp_path):
    figure, space = tmp_path / "design.svg", tmp_path / "space.png"
    code, out, err = call("classify", "1,2,1.5,1", "--at", "2.5,0.5", "--figure", figure, "--domains", space)
    assert (code, err) == (0, "")
    assert "Cuspidal: 4 cusps and 0 nodes" in out
    assert "domain 2" in out
    assert "proved in ball arithmetic" in out
    assert figure.read_text().startswith("<?xml")
    assert space.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("lengths", "verdict", "way"),
    [
        ("1e-8,1e-7,1,1", "Cuspidal: 2 cusps and 1 node", "no change of posture is shown"),
        ("1,1e6,1.5,1", "Cuspidal: 4 cusps and 0 nodes", "keeps det J from 0 is beyond double precision"),
        ("1e-3,1,1.5,1", "Cuspidal: 4 cusps and 4 nodes", "proved in ball arithmetic"),
    ],
)
def test_lengths_far_apart_keep_their_verdict(call, lengths, verdict, way):
    """Cusps and nodes of the domains 3, 2 and 4, where doubles show no change of posture as well."""
    code, out, err = call("classify", lengths)
    assert (code, err) == (0, "")
    assert verdict in out
    assert way in out
    assert "above 0 m" not in out


def test_json_holds_everything(call):
    code, out, err = call("classify", "1 2 1.5 1", "--at", "2.5,0.5", "--json")
    assert (code, err) == (0, "")
    found = json.loads(out)
    assert (found["design"]["domain"], found["cuspidal"], len(found["cusps"])) == (2, True, 4)
    assert found["posture_change"]["certified"] is True
    assert len(found["at"]["postures"]) == 4


def test_exact_takes_the_lengths_as_written(call):
    code, out, _ = call("classify", "1,3,3.75,3", "--exact")
    assert code == 0
    assert "exactly on C2" in out
    _, out, _ = call("classify", "1,3,3.75000000000000000000000001,3", "--exact", "--json")
    assert json.loads(out)["design"]["domain"] == 3


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("orthogonal_3r_fig2b", "Cuspidal: 2 cusps and 1 node"),
        ("puma560", "Not cuspidal: axes 1 and 2 intersect"),
        ("gofa5", "cuspidal: two inverse solutions"),
    ],
)
def test_arms_by_name(call, name, words):
    code, out, err = call("classify", name)
    assert (code, err) == (0, "")
    assert words in out


def test_a_search_without_a_find_says_so_and_no_more(call):
    code, out, _ = call("classify", "ur5e", "--tries", 2)
    assert code == 1
    assert "no witness in 2 tries" in out
    assert "not cuspidal" not in out.lower().replace("no witness", "")


TABLE = "name,d2,d3,d4,r2\nfish,1,2,1.5,1\ntail,1,3,3.75,3\nother,1,0.5,3,0.5\nflat,1,3,4,0\n"


@pytest.mark.parametrize("exact", [(), ("--exact",)])
def test_a_file_of_designs(call, tmp_path, exact):
    path, answers = tmp_path / "designs.csv", tmp_path / "answers.csv"
    path.write_text(TABLE)
    code, out, err = call("classify", path, *exact)
    assert (code, err) == (0, "")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert [row["name"] for row in rows] == ["fish", "tail", "other", "flat"]
    assert [row["domain"] for row in rows] == ["2", "", "5", ""]
    assert [row["cusps"] for row in rows] == ["4", "2", "0", "0"]
    assert [row["cuspidal"] for row in rows] == ["yes", "yes", "no", "no"]
    assert rows[1]["on"] == "C2"
    assert "r2 = 0" in rows[3]["on"]
    code, said, _ = call("classify", path, *exact, "-o", answers, "--json")
    assert code == 0
    assert answers.read_text() == out
    assert json.loads(said)["designs"] == 4


def test_blocks_make_one_file_with_one_header(call, tmp_path, monkeypatch):
    monkeypatch.setattr(designs, "BLOCK", 3)
    path = tmp_path / "designs.csv"
    path.write_text("d2,d3,d4,r2\n" + "1,2,1.5,1\n" * 10)
    code, out, _ = call("classify", path)
    assert code == 0
    assert out.splitlines() == ["d2,d3,d4,r2,domain,cusps,nodes,cuspidal,on", *["1,2,1.5,1,2,4,0,yes,"] * 10]


def test_a_wrong_row_leaves_no_file(call, tmp_path, monkeypatch):
    monkeypatch.setattr(designs, "BLOCK", 2)
    path, answers = tmp_path / "designs.csv", tmp_path / "answers.csv"
    path.write_text("d2,d3,d4,r2\n" + "1,2,1.5,1\n" * 5 + "1,2,oops,1\n")
    code, _, err = call("classify", path, "-o", answers)
    assert code == 2
    assert "row 7, d4: 'oops'" in err
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("1,2,x",), "DESIGN, entry 3: 'x' is not a finite number"),
        (("1,2,3",), "DESIGN: 3 numbers given; 4 are accepted"),
        (("nobody",), "there is no embedded arm 'nobody'"),
        (("planar_3r",), "planar"),
        (("panda",), "panda"),
        (("1,2,1.5,1", "--at", "-1,0"), "--at: rho = -1"),
        (("1,2,1.5,1", "-o", "x.csv"), "-o is for a .csv file"),
        (("1,2,1.5,1", "--figure", "x.doc"), "a figure is written as"),
        (("puma560", "--domains", "x.svg"), "--domains"),
        (("puma560", "--exact"), "--exact is for lengths"),
        (("gofa5", "--at", "1,0"), "are for 3R arms"),
        (("nothing.csv",), "nothing.csv: cannot be read"),
        (("nothing.csv", "--at", "1,0"), "for one design"),
    ],
)
def test_one_line_for_bad_input(call, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    code, out, err = call("classify", *arguments)
    assert (code, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
