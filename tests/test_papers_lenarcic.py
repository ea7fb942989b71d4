"""Lenarcic's paper recomputed: nothing is left unexplained, what is corrected is named, and its figures are drawn."""

import math

import numpy as np
import pytest
from site_pages import paper_page_is_up_to_date

import chainrule as cr
from chainrule.papers import PAPERS, lenarcic, reproduce
from chainrule.plot.self_motion import draw_curves, draw_lengths
from chainrule.self_motions.maps import self_motion_map

D = np.array([0.40, 0.35, 0.25])


@pytest.fixture(scope="module")
def rows():
    return reproduce("lenarcic")


def test_nothing_is_left_unexplained(rows):
    assert "lenarcic" in PAPERS
    assert all(row.good for row in rows)
    assert all(row.how and row.where and row.paper and row.ours for row in rows)
    assert all(row.note for row in rows if row.verdict != "agrees")


def test_what_the_paper_gets_wrong_is_named(rows):
    verdicts = {row.quantity: row.verdict for row in rows}
    assert {name for name, verdict in verdicts.items() if verdict == "misprint"} == {
        "equal links",
        "px = 0",
        "the wrap (13), (14)",
        "curves of a 4R anthropomorphic arm that positions its wrist",
    }
    assert {name for name, verdict in verdicts.items() if verdict == "true under a condition"} == {
        "the two curves in regions A and C",
        "discontinuity of the function s",
        "the error of closure",
        "close to a singularity",
        "the order a < b < c < d",
        "what cannot change sign in region A",
        "what cannot change sign in region C",
        "centre of symmetry",
    }
    assert {name for name, verdict in verdicts.items() if verdict == "not reproducible"} == {
        "a manipulator possessing joint limits",
        "time for a curve with an error below 0.1 %",
    }


def test_every_figure_has_a_row(rows):
    where = " ".join(row.where for row in rows)
    assert all(f"figure {number}" in where for number in (2, 3, 4, 5))


def test_the_values_are_the_papers(rows):
    printed = {row.quantity: row.paper for row in rows if row.where.startswith("section 3.1")}
    assert printed["a = -d1 + d2 + d3"] == "0.2 m"
    assert printed["d = d1 + d2 + d3"] == "1.0 m"
    assert [printed[f"closed curves in region {name}"] for name in "ABCD"] == ["2", "1", "2", "1"]


def curves_by_grid(lengths, r, size=1501):
    """How many curves there are: the pieces of q2, q3 around the torus on which the tip is at distance r.

    Cells of a grid in which |tip| - r changes its sign, joined to their neighbours (also around the torus).
    """
    from scipy.ndimage import label

    q = np.linspace(-np.pi, np.pi, size, endpoint=False) + 1e-3
    q2, q3 = np.meshgrid(q, q, indexing="ij")
    a, b, c = lengths
    above = np.abs(a + b * np.exp(1j * q2) + c * np.exp(1j * (q2 + q3))) > r
    near = [np.roll(above, shift, axes) for shift, axes in ((-1, 0), (-1, 1), ((-1, -1), (0, 1)))]
    crossed = np.any([above != other for other in near], axis=0)
    names, count = label(crossed, np.ones((3, 3)))
    joined = np.arange(count + 1)

    def root(k):
        while joined[k] != k:
            k = joined[k]
        return k

    for first, last in ((names[0], names[-1]), (names[:, 0], names[:, -1])):
        for shift in (-1, 0, 1):
            for i, j in set(zip(first.tolist(), np.roll(last, shift).tolist(), strict=True)):
                if i and j:
                    joined[root(i)] = root(j)
    return len({root(k) for k in range(1, count + 1)})


@pytest.mark.parametrize("r", [0.2, 0.6])
def test_equal_links_have_two_regions_by_counting_on_a_grid(r):
    expected = curves_by_grid([0.3, 0.3, 0.3], r)
    # the quadrilateral 0.3, 0.3, 0.3, r: two curves iff shortest + longest < the other two (Grashof)
    sides = sorted([0.3, 0.3, 0.3, r])
    assert expected == (2 if sides[0] + sides[3] < sides[1] + sides[2] else 1)
    assert self_motion_map([0.3, 0.3, 0.3], [r, 0.0]).number == expected


@pytest.mark.parametrize("region", "ABCD")
def test_regions_of_the_example_by_counting_on_a_grid(region):
    r = lenarcic.INSIDE[region]
    assert cr.self_motion(cr.planar_3r(*D), [r, 0.0]).count == curves_by_grid(D, r)


def test_the_anthropomorphic_arm_is_one():
    arm = lenarcic.anthropomorphic_4r()
    q = np.array(lenarcic.POSTURES)
    wrist = np.linalg.norm(arm.position(q), axis=1)
    # the distance of the wrist depends on the elbow alone: 0.4 and 0.35 m, and the angle between them
    elbow = np.full((4, 4), 0.3)
    elbow[:, 3] = q[:, 3]
    np.testing.assert_allclose(np.linalg.norm(arm.position(elbow), axis=1), wrist, atol=1e-15)
    np.testing.assert_allclose(wrist**2, 0.4**2 + 0.35**2 - 2 * 0.4 * 0.35 * np.sin(q[:, 3]), atol=1e-15)


def test_a_wrong_count_is_found_out(monkeypatch):
    monkeypatch.setitem(lenarcic.INSIDE, "B", 0.4)
    assert any(row.verdict == "DISAGREES" for row in lenarcic._numbers(cr.planar_3r(*D)))


# ---- figures -------------------------------------------------------------------------------------------------------


def test_lengths_over_px():
    axes = draw_lengths(cr.planar_3r(*D)).axes[0]
    assert axes.get_title(loc="left").startswith("Two curves where px is in region A or C, one in B or D\n")
    borders = sorted(line.get_xdata()[0] for line in axes.lines if len(set(line.get_xdata())) == 1)
    np.testing.assert_allclose(borders, [0.2, 0.3, 0.5, 1.0], atol=1e-15)
    drawn = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert len(drawn) == 8  # for each region all curves together, and one curve
    for whole, one, number in zip(drawn[::2], drawn[1::2], (2, 1, 2, 1), strict=True):
        np.testing.assert_allclose(whole.get_ydata(), number * one.get_ydata(), rtol=1e-14)


def test_lengths_over_px_beside_the_axis():
    axes = draw_lengths(cr.planar_3r(*D), other=0.25).axes[0]
    assert axes.get_title(loc="left").startswith("Two curves where px is in region B, one in A or C\n")
    borders = sorted(line.get_xdata()[0] for line in axes.lines if len(set(line.get_xdata())) == 1)
    np.testing.assert_allclose(borders, np.sqrt(np.array([0.3, 0.5, 1.0]) ** 2 - 0.25**2), atol=1e-15)
    with pytest.raises(cr.InputError, match="py = 1 m: out of reach; less than 1 m is accepted"):
        draw_lengths(cr.planar_3r(*D), other=1.0)


def test_lengths_of_the_second_task():
    axes = draw_lengths(cr.planar_3r(*D), "x_alpha", math.pi / 3).axes[0]
    assert axes.get_title(loc="left").startswith("Two curves where px is in region B, one in A or C\n")
    assert axes.get_xlabel() == "px [m], α = 60°"
    borders = sorted(line.get_xdata()[0] for line in axes.lines if len(set(line.get_xdata())) == 1)
    np.testing.assert_allclose(borders, 0.125 + np.array([-0.75, -0.05, 0.05, 0.75]), atol=1e-15)


def test_curves_in_joint_space():
    drawing = draw_curves(cr.planar_3r(*D), [0.1, 0.25, 0.4, 0.7])
    assert drawing.get_suptitle() == "2 curves at px = 0.1, 0.4 m; 1 curve at px = 0.25, 0.7 m"
    torus, plain, _ = drawing.axes
    assert len(plain.lines) == 6
    for line in torus.lines:
        q2, q3 = np.radians(line.get_xydata().T)
        tip = np.abs(D[0] + D[1] * np.exp(1j * q2) + D[2] * np.exp(1j * (q2 + q3)))
        assert np.abs(tip[:, None] - [0.1, 0.25, 0.4, 0.7]).min(axis=1).max() < 1e-12
        assert np.ptp(np.argmin(np.abs(tip[:, None] - [0.1, 0.25, 0.4, 0.7]), axis=1)) == 0
        assert np.abs(line.get_xydata()).max() <= 180.0


def test_the_page_of_the_site_is_up_to_date(rows):
    assert paper_page_is_up_to_date("lenarcic", rows, open_=("time for a curve",)), "run python docs/pages.py lenarcic"
