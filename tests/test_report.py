"""The report: its structure as a document, what it refuses to trust, and that what it states is true."""

import json
import math
import re
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise

import numpy as np
import pytest

import chainrule as cr
from chainrule import report
from chainrule.manipulability import max_manipulability, min_manipulability, unit
from chainrule.reach import reach, reach_bound
from chainrule.report.content import Part
from chainrule.report.context import Context
from chainrule.report.mathml import inner, joint_numbers, split_name
from chainrule.report.motion import FRAMES, Track, motion
from chainrule.report.page import page
from chainrule.report.sections import ORDER, sections
from chainrule.skeleton import skeleton, skeletons
from chainrule.workspaces import dexterous_rings, ring

pytestmark = pytest.mark.xdist_group("report")  # one worker, so that the reports are made once

VOID = {"meta", "link", "br", "hr", "img", "input", "col", "wbr"}
HOSTILE = '<script>alert("x")</script><img src=http://evil.example/x onerror=y> {{ 7*7 }} \x1b[31m'


class Document(HTMLParser):
    """Elements in order with their attributes; fails on what is not properly nested."""

    def __init__(self, text):
        super().__init__()
        self.found, self.stack, self.text = [], [], []
        self.feed(text)
        self.close()
        assert not self.stack, f"left open: {self.stack}"

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, dict(attrs), tuple(self.stack)))
        if tag not in VOID:
            self.stack.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.found.append((tag, dict(attrs), tuple(self.stack)))

    def handle_endtag(self, tag):
        assert self.stack.pop() == tag, f"</{tag}> closes something else"

    def handle_data(self, data):
        self.text.append(data)

    def all(self, tag):
        return [attributes for name, attributes, _ in self.found if name == tag]


@pytest.fixture(scope="module", params=["panda", "planar_3r", "orthogonal_3r_fig2a"])
def made(request, report_of):
    return report_of(request.param)


def small(**changes):
    """An arm whose report is short."""
    plain = cr.planar("R", [0.7], name="one").description
    return cr.Arm(replace(plain, **changes))


def test_it_is_a_well_formed_page(made):
    arm, result = made
    page = Document(result.html)
    assert result.html.startswith("<!doctype html>")
    assert page.all("html")[0]["lang"] == "en"
    assert len(page.all("h1")) == len(page.all("main")) == len(page.all("nav")) == 1
    ids = [a["id"] for _, a, _ in page.found if "id" in a]
    assert len(ids) == len(set(ids))
    for anchor in page.all("a"):
        assert anchor["href"].startswith("#")
        assert anchor["href"][1:] in ids
    for section in page.all("section"):
        assert section["aria-labelledby"] in ids
    for head in page.all("th"):
        assert head["scope"] in ("col", "row")
    for table in [stack for tag, _, stack in page.found if tag == "table"]:
        assert "div" in table
    assert len(page.all("caption")) == len(page.all("table"))
    for drawing in page.all("svg"):
        assert drawing["role"] == "img"
        assert set(drawing["aria-labelledby"].split()) <= set(ids)
    assert page.all("math")
    assert arm.name in "".join(page.text)
    levels = [int(tag[1]) for tag, _, _ in page.found if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert max(b - a for a, b in pairwise(levels)) <= 1
    (skip,) = [anchor for anchor in page.all("a") if anchor.get("class") == "skip"]
    assert skip == page.all("a")[0]
    assert skip["href"] == "#" + page.all("main")[0]["id"]
    labels = {label["for"] for label in page.all("label")}
    assert {control["id"] for control in page.all("input") + page.all("select")} == labels


def test_it_needs_nothing_from_outside(made):
    _, result = made
    page = Document(result.html)
    assert all("src" not in script for script in page.all("script"))
    for word in ("fetch(", "XMLHttpRequest", "import(", "WebSocket", "eval(", "http:", "https:"):
        assert word not in re.sub(r'xmlns(:\w+)?="[^"]*"', "", result.html)
    for _, attributes, _ in page.found:
        for key in ("src", "href", "data", "poster", "action", "srcset"):
            assert attributes.get(key, "#").startswith(("#", "data:")), attributes
    assert not re.search(r"url\((?!#)", result.html)
    assert "@import" not in result.html


def test_sections_come_in_order_and_all_checks_pass(made):
    arm, result = made
    keys = list(result.parts)
    assert keys == [key for key in ORDER if key in keys]
    some = {  # sections not every arm has
        "planar_3r": {"self_motion", "redundancy", "timing", "speed_ratio", "following"},
        "panda": {"self_motion", "redundancy", "timing"},
        "orthogonal_3r_fig2a": {"cuspidality"},
    }
    assert some.get(arm.name, set()) | {
        "summary",
        "drawing",
        "description",
        "jacobian",
        "minors",
        "singular",
        "map",
        "reach",
        "generated",
        "checked",
    } == set(keys)
    assert result.passed


def test_both_colour_schemes_and_print_are_provided(made):
    _, result = made
    assert "prefers-color-scheme: dark" in result.html
    assert "@media print" in result.html
    used = set(re.findall(r"var\((--fig-[a-z-]+)", result.html))
    assert used
    defined = re.findall(r"(--fig-[a-z-]+):", result.html)
    assert all(defined.count(name) == 2 for name in used), "a figure's colour is missing from a scheme"


def test_text_from_files_is_only_ever_text():
    text = report.html(small(name="hostile", source=HOSTILE))
    page = Document(text)
    assert not page.all("script")
    assert not page.all("img")
    assert "&lt;script&gt;" in text
    assert "{{ 7*7 }}" in text
    assert "\x1b" not in text


def test_a_script_cannot_be_left_from_inside_a_motion():
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    q = np.zeros((FRAMES, 3))
    tracks = [Track("</script><img src=x>", q, np.ones(FRAMES))]
    words = dict.fromkeys(("label", "chart", "symbol", "unit", "title", "caption"), "</script><b>")
    text = page("x", "y", {"one": Part((motion(arm, "k", tracks, **words),))}, {"one": "One"}, "")
    found = Document(text)
    assert not found.all("img")
    assert not found.all("b")
    assert len(found.all("script")) == 2


def test_a_failed_check_is_shown_and_told(monkeypatch):
    from chainrule import checks

    monkeypatch.setattr(checks, "DOUBLE", 1e-30)
    result = report.build(small())
    assert not result.passed
    assert 'class="finding bad"' in result.html
    assert "FAIL" in result.html


def test_writing_is_whole_or_not_at_all(tmp_path, monkeypatch):
    target = tmp_path / "page.html"
    target.write_text("old")
    monkeypatch.setattr(report, "_page", lambda *rest: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        report.write(small(), target)
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_missing_folder_is_named_before_anything_is_computed(tmp_path):
    with pytest.raises(cr.InputError, match=r"there is no folder .*missing"):
        report.write(small(), tmp_path / "missing" / "page.html", lambda line: pytest.fail("it went to work"))
    with pytest.raises(cr.InputError, match="is a folder; a file is accepted"):
        report.write(small(), tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_an_arm_with_too_few_joints_for_any_task_has_a_report():
    result = report.build(small())
    assert "map" not in result.parts
    assert result.passed


def test_an_arm_whose_manipulability_never_changes():
    arm = cr.planar("PPP", [0.1, 0.3, 0.4], [0.0, 0.7, 1.9], name="ppp")
    context = Context(arm)
    parts = {s.key: s.build(arm, context) for s in sections(arm) if s.key in ("map", "singular", "self_motion")}
    # The minors are the sines of the angles between the headings, which add up along the chain.
    expected = math.sqrt(math.sin(0.7) ** 2 + math.sin(2.6) ** 2 + math.sin(1.9) ** 2)
    assert parts["map"].data["maximum"]["H"] == pytest.approx(expected, rel=1e-14)
    assert parts["singular"].data["proved"] is True
    assert parts["singular"].headlines == ("It is never singular.",)
    found = parts["self_motion"].data
    assert [curve["closed"] for curve in found["components"]] == [False]  # the slides go on without end
    assert found["complete"] != "proved"


# ---- what the report states ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(6))
def test_rings_against_brute_force(seed):
    rng = np.random.default_rng(seed)
    lengths = rng.uniform(0.05, 1.0, 3)
    inner_radius, outer_radius = ring(lengths)
    turns = np.linspace(-np.pi, np.pi, 400)
    first, second = ring(lengths[:2])
    for radius in np.linspace(0.0, lengths.sum() * 1.05, 240):
        wrist = np.abs(radius - lengths[2] * np.exp(1j * turns))
        inside = (wrist >= first) & (wrist <= second)
        margin = min(abs(radius - edge) for edge in (inner_radius, outer_radius))
        if margin > 1e-2:
            assert inside.any() == (inner_radius <= radius <= outer_radius)
        edges = [edge for pair in dexterous_rings(lengths) for edge in pair]
        if not edges or min(abs(radius - edge) for edge in edges) > 1e-9:
            expected = any(low <= radius <= high for low, high in dexterous_rings(lengths))
            assert inside.all() == expected or np.abs(np.stack([wrist - first, wrist - second])).min() < 1e-4


@pytest.mark.parametrize("name", ["panda", "ur5e", "jaco2", "sanchez_8r", "orthogonal_3r_fig2b", "lenarcic_3r"])
def test_no_configuration_exceeds_the_bound_of_the_reach(name):
    arm = cr.load(name)
    q = np.random.default_rng(5).uniform(-np.pi, np.pi, (50_000, arm.n))  # limits left aside: the bound needs none
    assert np.linalg.norm(arm.position(q), axis=1).max() <= reach_bound(arm)


def test_bound_with_prismatic_joints():
    rows = [("R", 0.0, 0.0, 0.3, 0.0), ("R", -math.pi / 2, 0.1, 0.0, 0.0), ("P", math.pi / 2, 0.0, 0.2, 0.0)]
    assert math.isinf(reach_bound(cr.Arm.from_dh(rows, name="free")))
    arm = cr.Arm.from_dh(rows, name="rrp", position=[None, None, (-0.1, 0.9)], tool=(0.0, 0.05, 0.1))
    rng = np.random.default_rng(3)
    q = np.column_stack([rng.uniform(-np.pi, np.pi, (20_000, 2)), rng.choice([-0.1, 0.9], 20_000)])
    farthest = np.linalg.norm(arm.position(q), axis=1).max()
    assert farthest <= reach_bound(arm) < 1.2 * farthest
    slide = cr.planar("RP", [0.4, 0.2]).with_limits(position=[None, (-0.5, 0.3)])
    assert reach_bound(slide) == pytest.approx(0.9)
    assert reach(slide).farthest.value == pytest.approx(0.9)


def test_largest_and_smallest_manipulability_are_stationary_or_at_a_limit():
    arm = cr.load("panda")
    best, least = max_manipulability(arm), min_manipulability(arm)
    lower, upper = arm.limits.position.T
    inside = (best.q > lower + 1e-9) & (best.q < upper - 1e-9)
    assert np.abs(arm.manipulability_gradient(best.q)[inside]).max() < 1e-6
    some = arm.manipulability(np.random.default_rng(8).uniform(lower, upper, (20_000, 7)))
    assert some.max() <= best.value
    assert least.value <= some.min()
    assert ((lower <= best.q) & (best.q <= upper)).all()


def test_units_of_manipulability():
    assert unit(cr.planar_3r(1, 1, 1)).text == "m²"
    assert unit(cr.planar_3r(1, 1, 1), "x_alpha").text == "m"
    assert unit(cr.load("panda"), "position").text == "m³"
    assert unit(cr.planar("PPP", [0, 0, 0])).text == "1"
    mixed = unit(cr.planar("RPR", [1, 1, 1]))
    assert mixed.mixed
    assert mixed.text == "m and m²"


def test_units_by_scaling():
    # Lengths in other units multiply H by the scale to the unit's power.
    one, ten = (cr.planar_3r(*(scale * np.array([1.0, 0.5, 0.25]))) for scale in (1.0, 10.0))
    q = [0.1, 1.2, -0.4]
    for task, power in (("position", 2), ("x_alpha", 1), ("pose", 2)):
        assert ten.manipulability(q, task=task) == pytest.approx(10.0**power * one.manipulability(q, task=task))


def test_the_self_motion_is_that_of_the_posture_drawn(made):
    arm, result = made
    if "self_motion" not in result.parts:
        assert all(arm.n - rows != 1 for rows in arm.tasks.values())
        return
    data = result.parts["self_motion"].data
    q = max_manipulability(arm, data["task"]).q
    tip = arm.pose(q) if data["task"] == "pose" else arm.position(q)
    np.testing.assert_allclose(data["target"], tip, atol=1e-12)
    assert data["complete"] == "proved"
    assert data["count"] == len(data["components"]) > 0
    turned = [c for c in data["components"] if _on(c, q)]
    assert turned, "the posture drawn is on none of the curves"
    assert "Self-motion" in result.html


def test_the_path_with_joints_to_spare_is_a_circle_that_gradient_projection_follows_too(made):
    arm, result = made
    if "redundancy" not in result.parts:
        assert all(arm.n <= rows for rows in arm.tasks.values())
        return
    data = result.parts["redundancy"].data
    plain, gained = data["runs"].values()
    assert plain["status"] == gained["status"] == "complete"
    largest = result.parts["map"].data["maximum"]
    assert data["path"]["radius"] == pytest.approx(0.35 * np.linalg.norm(arm.position(largest["q"])))
    for run in (plain, gained):  # H on the way is never above the largest that there is
        assert 0.0 < run["min_manipulability"] <= largest["H"]
        assert run["worst_position_error"] < 0.002 * data["path"]["radius"] * 2 * math.pi
    assert plain["law"]["gains"] == {}
    assert gained["law"]["gains"] == {"H^(-1/2)": -2.0}
    assert "Joints to spare" in result.html


def _on(component, q):
    """Whether a posture is within the box of a curve, up to whole turns."""
    low, high = np.array(component["box"]).T
    shift = np.ceil((low - 1e-9 - q) / (2 * np.pi)) * 2 * np.pi
    return bool((q + shift <= high + 1e-9).all())


def test_the_summary_says_what_the_sections_found(made):
    arm, result = made
    lines = result.parts["summary"].data["findings"]
    said = " ".join(lines)
    assert said.count("self-motion curve") == ("self_motion" in result.parts)
    assert [line for part in result.parts.values() for line in part.headlines] == lines
    expected = {
        "panda": ["four self-motion curves, and cannot pass from one to another", "3 arcs are left"],
        "planar_3r": ["0.25 to 1.75 m", "one self-motion curve", "Avoid postures with all three links in one line"],
        "orthogonal_3r_fig2a": ["This arm is cuspidal", "4 cusps", "Avoid the two curves"],
    }
    for words in expected[arm.name]:
        assert words in said
    assert all(line in result.html.replace("&#39;", "'") for line in lines)


def moving(result):
    """The data of the page's sliders."""
    found = re.findall(r'<script type="application/json">(.*?)</script>', result.html, re.DOTALL)
    return [json.loads(text) for text in found]


def test_the_slider_shows_postures_that_hold_the_tip(made):
    arm, result = made
    if arm.name == "orthogonal_3r_fig2a":
        ((track,),) = moving(result)  # a change of posture: the tip comes back
        tips = [frame.split()[-1] for frame in (track["frames"][0], track["frames"][-1])]
        assert tips[0] == tips[1]
        assert track["frames"][0] != track["frames"][-1]
        return
    (tracks,) = moving(result)
    assert len(tracks) == result.parts["self_motion"].data["count"]
    assert len({frame.split()[-1] for track in tracks for frame in track["frames"]}) == 1
    target = np.array(result.parts["self_motion"].data["target"])
    for track in tracks:
        for text in track["texts"][::9]:
            degrees = re.findall(r"q[1-7] = (−?[0-9.]+)°", text.replace("\u00a0", " "))
            q = np.radians([float(value.replace("−", "-")) for value in degrees])
            tip = arm.pose(q) if target.shape == (4, 4) else arm.position(q)
            np.testing.assert_allclose(tip, target, atol=6e-3)  # a tenth of a degree in each joint
            height = float(re.search(r"H = ([0-9.e-]+)", text.replace("\u00a0", " ")).group(1))
            assert height == pytest.approx(arm.manipulability(q), abs=2e-3)


def test_the_slider_tells_what_is_within_the_joint_limits(report_of):
    _, result = report_of("panda")
    (tracks,) = moving(result)
    data = result.parts["self_motion"].data
    left = [0.0] * len(tracks)
    for part in data["feasible"]:  # found by following the curves to where a limit is met
        left[part["of"]] += part["length"]
    for track, curve, length in zip(tracks, data["components"], left, strict=True):
        share = np.mean([text.endswith("within the joint limits") for text in track["texts"]])
        assert share == pytest.approx(length / curve["length"], abs=4.0 / FRAMES)
        assert (length > 0.0) == track["texts"][track["start"]].endswith("within the joint limits")


@pytest.mark.parametrize("name", ["panda", "planar_3r", "orthogonal_3r_fig2a", "rpr"])
def test_skeletons_of_many_postures(name):
    arm = cr.planar("RPR", [0.5, 0.4, 0.3], [0.0, 0.3, 0.0]) if name == "rpr" else cr.load(name)
    q = np.random.default_rng(4).uniform(-2.0, 2.0, (50, arm.n))
    found = skeletons(arm, q)
    assert found.shape == (50, arm.n + 2, 3)
    np.testing.assert_allclose(found[:, -1, : np.asarray(arm.position(q)).shape[1]], arm.position(q), atol=1e-14)
    one = skeleton(arm, q[7])  # with 20 digits
    np.testing.assert_allclose(found[7], np.vstack([np.zeros(3), one.points, one.tip]), atol=1e-14)
    assert skeletons(arm, np.zeros((0, arm.n))).shape == (0, arm.n + 2, 3)


# ---- formulas ------------------------------------------------------------------------------------------------------


def test_formulas_use_the_fields_shorthand_and_readable_numbers():
    import sympy as sp

    from chainrule.derive.program import exact

    q1, q2, length = sp.symbols("q1 q2 l1", real=True)
    assert "<mi>s</mi><mn>12</mn>" in inner(length * sp.sin(q1 + q2))
    assert "<mi>ℓ</mi><mn>1</mn>" in inner(length)
    assert "<mn>0.0825</mn>" in inner(exact(0.0825) * sp.cos(q1))
    assert "&InvisibleTimes;" not in inner(length * q1)
    assert joint_numbers(q1 - q2) == ""


def test_names_of_steps_stay_distinct():
    names = ["x1x", "x1_x", "p4bx", "p4fx", "m1_2", "m12", "v1y", "hx1", "hy1", "r12z"]
    shown = [split_name(name) for name in names if name != "x1_x"]
    assert len(set(shown)) == len(shown)
