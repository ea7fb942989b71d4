"""Figures about 3R arms: what they state is what the design is, and what they shade is what the counts are."""

import re

import numpy as np
import pytest

import chainrule as cr
from chainrule.plot.cuspidality import draw_design
from chainrule.plot.design_space import draw_domains
from chainrule.plot.style import COLOURS, svg

DESIGNS = {
    (1.0, 2.0, 1.5, 1.0): ("Cuspidal: 4 cusps", 2),
    (1.0, 3.0, 4.0, 3.0): ("Cuspidal: 2 cusps", 3),
    (1.0, 0.5, 3.0, 0.5): ("Not cuspidal: 0 cusps", 5),
    (1.0, 0.7, 0.2, 0.3): ("Not cuspidal: 0 cusps", 1),
}


@pytest.mark.parametrize(("lengths", "said"), DESIGNS.items())
def test_a_design_states_its_finding(lengths, said):
    design = cr.orthogonal_3r(*lengths)
    drawing = draw_design(design)
    title = drawing.get_suptitle()
    assert title.startswith(said[0])
    assert f"up to {4 if said[1] > 1 else 2} postures" in title
    joint, section = drawing.axes
    assert "[deg]" in joint.get_xlabel()
    assert "[m]" in section.get_xlabel()
    names = {text.get_text() for text in joint.texts}
    assert names == {f"A{a.label + 1} {'+' if a.sign > 0 else '−'}" for a in design.aspects()}
    for text, aspect in zip(joint.texts, design.aspects(), strict=True):  # each name stands in its aspect
        q = [0.0, *np.radians(text.get_position())]
        assert int(design.aspect_of(q)) == aspect.label
    cusps = next(line for line in section.lines if line.get_markerfacecolor() == COLOURS["accent"])
    np.testing.assert_array_equal(np.stack(cusps.get_data(), axis=-1), design.cusps().reshape(-1, 2))


def test_a_change_of_posture_is_drawn_from_start_to_goal():
    design = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    change = design.posture_change()
    joint, section = draw_design(design, change).axes
    red = [line for line in section.lines if line.get_color() == COLOURS["accent"] and len(line.get_xdata()) > 100]
    np.testing.assert_allclose(np.stack(red[0].get_data(), axis=-1), change.image(801))
    assert any(line.get_color() == COLOURS["accent"] for line in joint.lines)


def test_any_3r_arm_is_drawn():
    arm = cr.Arm.from_dh(
        [("R", 0, 0, 0, 0), ("R", 1.2, 1.0, 0.3, 0), ("R", -0.9, 1.5, 0.2, 0)], tool=(1.2, 0, 0), name="twisted"
    )
    assert draw_design(cr.regional_3r(arm)).get_suptitle().startswith("Cuspidal")
    assert draw_design(cr.regional_3r(cr.load("puma560"))).get_suptitle().startswith("Not cuspidal")


@pytest.mark.parametrize(("lengths", "said"), DESIGNS.items())
def test_the_design_space_marks_the_design(lengths, said):
    drawing = draw_domains([3.0 * length for length in lengths])
    assert f"domain {said[1]}" in drawing.get_suptitle()
    main = next(axes for axes in drawing.axes if axes.get_xlabel())
    (mark,) = (line for line in main.lines if line.get_markerfacecolor() == COLOURS["accent"])
    np.testing.assert_allclose(np.ravel(mark.get_data()), lengths[1:3], rtol=1e-12)
    for text in main.texts:  # every number stands in its domain
        d3, d4 = text.get_position()
        assert int(cr.classify_orthogonal_3r(1.0, d3, d4, lengths[3])) == int(text.get_text())


def test_as_svg_in_a_page():
    text = svg(draw_domains(), "space", "title", "description")
    assert "<image" not in text  # outlines, so that the page's colours apply
    assert not re.search(r"(?:https?:)?//(?!www\.w3\.org)", text.replace("http://www.w3.org", ""))
    for name in ("fill", "fill-deep", "ink"):
        assert f"var(--fig-{name}" in text
