"""Figures: what they state, that they are made without global state, and that their SVG can stand in a page."""

import re
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

import chainrule as cr
from chainrule.manipulability import manipulability_map
from chainrule.plot import draw_arm, draw_map
from chainrule.plot.maps import finding
from chainrule.plot.style import COLOURS, svg
from chainrule.skeleton import skeleton


@pytest.fixture(scope="module")
def planar():
    return cr.planar_3r(1.0, 0.5, 0.25)


def test_skeleton_of_a_planar_arm_is_plane_trigonometry(planar):
    q = [0.3, -0.7, 1.1]
    bones = skeleton(planar, q)
    headings = np.cumsum(q)
    corners = np.cumsum(
        [[size * np.cos(h), size * np.sin(h)] for size, h in zip((1.0, 0.5, 0.25), headings, strict=True)], axis=0
    )
    np.testing.assert_allclose(bones.points[1:, :2], corners[:2], atol=1e-15)
    np.testing.assert_allclose(bones.tip[:2], corners[2], atol=1e-15)


@pytest.mark.parametrize("name", ["panda", "sanchez_8r", "orthogonal_3r_fig2a"])
def test_skeleton_agrees_with_the_arm(name):
    arm = cr.load(name)
    q = np.linspace(-0.9, 0.8, arm.n)
    bones, pose, jacobian = skeleton(arm, q), arm.pose(q), arm.jacobian(q, task="position")
    np.testing.assert_allclose(bones.tip, pose[:3, 3], atol=1e-14)
    np.testing.assert_allclose(bones.frame, pose[:3, :3], atol=1e-14)
    np.testing.assert_allclose(np.cross(bones.axes, bones.tip - bones.points).T, jacobian, atol=1e-14)


def test_prismatic_joints_are_drawn_where_they_have_moved():
    arm = cr.planar("RP", [0.0, 0.5])
    np.testing.assert_allclose(skeleton(arm, [0.0, 0.25]).points[1], [0.75, 0.0, 0.0], atol=1e-15)
    assert draw_arm(arm, [0.4, 0.2]).axes


def test_the_map_states_what_it_shows(planar):
    found = manipulability_map(planar, size=61)
    assert found.joints == (1, 2)
    title = draw_map(planar, found).axes[0].get_title(loc="left")
    degrees = [
        float(x.replace("−", "-")) for x in re.findall(r"= (−?[\d.]+)°", finding(planar, found).replace("\u00a0", " "))
    ]
    # De Luca: H is the root of the sum of the squares of the three minors.
    s2, s3 = np.sin(np.radians(degrees))
    s23 = np.sin(np.radians(sum(degrees)))
    height = np.sqrt((0.5 * s2 + 0.25 * s23) ** 2 + (0.25 * (s23 + 0.5 * s3)) ** 2 + (0.125 * s3) ** 2)
    assert f"{height:.4f} m²" in title
    assert "zero where both are 0° or 180°" in title


def test_the_map_is_what_the_arm_says(planar):
    found = manipulability_map(planar, size=9)
    q = [0.0, found.first[2], found.second[5]]
    assert found.H[2, 5] == planar.manipulability(q)
    assert found.H.max() <= found.maximum.value


@pytest.mark.parametrize("key", ["a", "b"])
def test_svg_stands_alone_among_others(planar, key):
    text = svg(draw_arm(planar, [0.1, 0.2, 0.3]), key, 'an arm called <"&', "what it looks like")
    root = ElementTree.fromstring(text)
    ids = [e.get("id") for e in root.iter() if e.get("id")]
    assert ids
    assert len(ids) == len(set(ids))
    assert all(i.startswith(f"{key}-") for i in ids)
    referred = re.findall(r'(?:url\(#|href="#)([^)"]+)', text)
    assert set(referred) <= set(ids)
    assert root.find("title").text == 'an arm called <"&'
    assert root.get("aria-labelledby").split() == [f"{key}-title", f"{key}-desc"]
    assert "http" not in text
    assert not any(f": {light}" in text for light in COLOURS.values()), (
        "a colour that does not follow the page's scheme"
    )


def test_figures_leave_pyplot_alone():
    code = """if True:
        import sys, matplotlib, chainrule
        from chainrule.plot import draw_arm
        settings = [key for key in matplotlib.rcParams if key != "backend"]  # reading that one chooses a backend
        before = [matplotlib.rcParams[key] for key in settings]
        draw_arm(chainrule.planar_3r(1, 0.5, 0.25), [0, 1, 2])
        assert "matplotlib.pyplot" not in sys.modules
        assert [matplotlib.rcParams[key] for key in settings] == before
    """
    subprocess.run([sys.executable, "-c", code], check=True)
