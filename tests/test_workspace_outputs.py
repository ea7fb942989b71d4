"""The workspace on the command line, as a figure and in the report."""

import itertools
import json
import math
from xml.etree import ElementTree

import numpy as np
import pytest

import chainrule as cr
import chainrule.commands.workspace
from chainrule.plot import draw_arm
from chainrule.plot.style import svg
from chainrule.plot.workspace import draw_workspace, outline
from chainrule.report.context import Context
from chainrule.report.parts import drawing as drawing_part
from chainrule.report.parts.reach import SECTION
from chainrule.workspaces import findings, orientations_in_words, states_in_words, workspace

LIMITED = """
chainrule = 1
name = "limited_3r"
angles = "deg"
[planar]
kinds = "RRR"
lengths = [1.0, 0.5, 0.25]
[[joints]]
position = [0, 90]
[[joints]]
position = [0, 90]
[[joints]]
position = [0, 0]
"""


@pytest.fixture
def limited():
    return cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(-0.5, 2.0), (-2.0, 2.0), (-2.5, 2.5)])


# ---- command ---------------------------------------------------------------------------------------------------------


def test_command_on_the_papers_arm(call):
    code, out, err = call("workspace", "planar_3r")
    assert (code, err) == (0, "")
    assert "0.25 to 1.75 m from the base" in out
    assert "0.75" in out and "1.25" in out
    code, out, _ = call("workspace", "planar_3r", "--json")
    shown = json.loads(out)
    assert code == 0
    assert shown["primary"] == [[0.25, 1.75]]
    assert shown["secondary"] == [[0.75, 1.25]]
    assert "at" not in shown


def test_command_with_limits_a_point_and_a_figure(call, tmp_path):
    arm = tmp_path / "limited.toml"
    arm.write_text(LIMITED)
    figure = tmp_path / "workspace.svg"
    code, out, err = call("workspace", arm, "--at", "1, 0.75", "--figure", figure, "--json")
    assert (code, err) == (0, "")
    shown = json.loads(out)
    # a 2R arm of 1 and 0.75, elbow between 0 and 90 degrees, base between 0 and 90: l1 l2 pi / 2
    assert shown["area"] == pytest.approx(0.75 * math.pi / 2, abs=1e-14)
    assert shown["primary"] == shown["secondary"] == []
    assert np.allclose(shown["at"]["orientations"], [[math.pi / 2, math.pi / 2]])
    assert ElementTree.parse(figure).getroot().tag.endswith("svg")
    code, out, _ = call("workspace", arm, "--at", "1,0.75", "--figure", figure)
    assert code == 0
    assert "q1 moves, q2 at lower limit" in out
    assert "q3" not in out.split("Boundary")[1]  # its limits are equal: it is no reason for anything
    assert "orientation 90°" in out


def test_command_says_no_and_refuses(call, tmp_path):
    code, out, _ = call("workspace", "planar_3r", "--at", "0,0.1")
    assert code == 1
    assert "not reached" in out
    code, out, err = call("workspace", "planar_3r", "--at", "1e300,1e300")
    assert (code, err) == (1, "")
    code, out, _ = call("workspace", "planar_3r", "--at", "-0.1,0", "--json")
    assert code == 1
    assert json.loads(out)["at"] == {"point": [-0.1, 0.0], "orientations": []}
    for arguments, told in (
        (("panda",), "planar arms only"),
        (("planar_3r", "--at", "1"), "2 are accepted"),
        (("planar_3r", "--at", "1,x"), "not a finite number"),
        (("planar_3r", "--figure", tmp_path / "w.gif"), ".svg, .png or .pdf"),
    ):
        code, out, err = call("workspace", *arguments)
        assert (code, out) == (2, "")
        assert err.count("\n") == 1 and told in err
    assert list(tmp_path.iterdir()) == []


# ---- words -----------------------------------------------------------------------------------------------------------


def test_words():
    found = workspace(cr.planar_3r(1.0, 0.9, 0.5))
    assert findings(found) == [
        "Reached: 0 to 2.4 m from the base,",
        "with every orientation: 0 to 0.4 and 0.6 to 1.4 m",
    ]
    assert orientations_in_words(found, (0.1, 0.0)) == "every orientation"
    assert orientations_in_words(found, (3.0, 0.0)) == "not reached"
    assert orientations_in_words(found, (2.4, 0.0)) == "orientation 0°"
    assert states_in_words(("moves", "fixed", "folded")) == "q1 moves, q3 folded"
    assert states_in_words(("moves", "moves")) == "q1 and q2 move"


# ---- figure ----------------------------------------------------------------------------------------------------------


def test_the_figure_states_and_explains(limited):
    found = workspace(limited)
    drawing = draw_workspace(limited, found, at=(0.6, 0.7))
    (axes,) = drawing.axes
    title = axes.get_title(loc="left")
    assert f"{found.area:.4g} m²" in title
    assert "at (0.6, 0.7) m: orientation" in title
    explained = [text.get_text() for text in drawing.legends[0].get_texts()]
    kinds = {found.joints(piece) for piece in found.region.pieces}
    assert {text[3:] for text in explained[1:]} == {states_in_words(kind) for kind in kinds}
    assert {text.get_text() for text in axes.texts} == {text[0] for text in explained[1:]}
    (low, high), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    for piece in found.region.pieces:
        z = outline(piece)
        assert (z.real > low).all() and (z.real < high).all() and (z.imag > bottom).all() and (z.imag < top).all()


@pytest.mark.parametrize(
    ("lengths", "limits"),
    [
        ((1.0, 0.8, 0.5, 0.25), [(-1.0, 2.0), (-2.0, 2.0), (-1.7, 2.6), (-2.9, 1.0)]),  # a small hole of four edges
        ((1.0, 0.9, 0.8, 0.7, 0.6, 0.5), [(-0.5, 0.5)] * 6),  # fifteen entries in the legend
    ],
)
def test_nothing_in_a_figure_is_cut_off_or_covered(lengths, limits):
    arm = cr.planar("R" * len(lengths), lengths).with_limits(position=limits)
    drawing = draw_workspace(arm)
    drawing.draw_without_rendering()
    (axes,) = drawing.axes
    page = drawing.bbox
    for box in (axes.get_tightbbox(), drawing.legends[0].get_window_extent()):
        assert box.x0 >= page.x0 - 1 and box.y0 >= page.y0 - 1 and box.x1 <= page.x1 + 1 and box.y1 <= page.y1 + 1
    assert axes.get_tightbbox().y0 >= drawing.legends[0].get_window_extent().y1 - 1
    letters = [text.get_window_extent().get_points().mean(axis=0) for text in axes.texts]
    gaps = [math.dist(a, b) for a, b in itertools.combinations(letters, 2)]
    assert min(gaps) > 8.5 / 72 * drawing.dpi  # their height


@pytest.mark.parametrize(
    ("kinds", "lengths", "limits"),
    [
        ("R", (1.0,), [None]),
        ("RR", (1.0, 1.0), [(0.0, 0.0), (0.0, 1.0)]),
        ("RR", (1.0, 1.0), [(0.0, 0.0), (1.0, 1.0)]),
        ("RRR", (1.0, 0.5, 0.5), [None, None, None]),
        ("PP", (0.0, 0.0), [(0.0, 1.0), (0.0, 2.0)]),
        ("RRRRR", (1.0, 0.8, 0.6, 0.4, 0.2), [(-0.8, 0.8), (-1, 1), (-1, 0.3), (-1, 1), (-1, 1)]),
    ],
)
def test_figures_of_all_kinds_of_workspaces(kinds, lengths, limits):
    arm = cr.planar(kinds, lengths, [0.4 * (kind == "P") for kind in kinds]).with_limits(position=limits)
    text = svg(draw_workspace(arm), "w", "workspace", "its edges")
    assert ElementTree.fromstring(text).find("title").text == "workspace"
    assert draw_arm(arm, np.zeros(arm.n)).axes


def test_an_arm_that_reaches_without_bounds_is_still_drawn():
    assert draw_arm(cr.planar("RP", (0.0, 0.5)), [0.4, 0.2]).axes


# ---- report ----------------------------------------------------------------------------------------------------------


def texts(part):
    return " ".join(getattr(block, "text", "") for block in part.blocks)


def test_report_of_a_limited_planar_arm(limited):
    part = SECTION.build(limited, Context(limited))
    area = workspace(limited).area
    assert f"{area:.4g} m²" in texts(part)
    assert part.data["workspace"]["area"] == area
    kinds = [block.kind for block in part.blocks]
    assert "picture" in kinds and "details" in kinds
    json.dumps(part.data, allow_nan=False)


def test_report_of_other_arms():
    free = cr.planar_3r(1.0, 0.5, 0.25)
    part = SECTION.build(free, Context(free))
    assert "0.25 to 1.75 m" in texts(part) and "0.75 to 1.25 m" in texts(part)
    assert part.data["workspace"]["primary"] == [[0.25, 1.75]]
    unbounded = cr.planar("RP", (0.0, 0.5))
    part = SECTION.build(unbounded, Context(unbounded))
    assert "workspace" not in part.data
    assert "no limits" in texts(part)


def test_the_drawing_says_what_its_shades_mean():
    slide = cr.planar("RP", (0.2, 0.5)).with_limits(position=[(0.0, 1.0), (0.0, 0.4)])
    for arm, explained in ((slide, True), (cr.planar("RP", (0.2, 0.5)), False), (cr.planar_3r(1.0, 0.5, 0.25), True)):
        part = drawing_part.SECTION.build(arm, Context(arm))
        (picture,) = part.blocks
        assert ("every point the tip reaches" in picture.caption) == explained
