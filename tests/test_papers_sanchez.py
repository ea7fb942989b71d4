"""Sanchez's thesis recomputed: nothing is left unexplained, what is corrected is named, and its figures are drawn."""

import io

import numpy as np
import pytest
from site_pages import paper_page_is_up_to_date

import chainrule as cr
from chainrule.papers import PAPERS, reproduce, sanchez_figures, sanchez_paths, sanchez_runs

NAMES = ("arc", "ellipse", "line")


@pytest.fixture(scope="module")
def rows():
    return reproduce("sanchez")


def test_nothing_is_left_unexplained(rows):
    assert "sanchez" in PAPERS
    assert [row for row in rows if not row.good] == []
    assert all(row.how and row.where and row.paper and row.ours for row in rows)
    assert all(row.note for row in rows if row.verdict != "agrees")


def test_what_the_thesis_gets_wrong_is_named(rows):
    verdicts = {row.quantity: row.verdict for row in rows}
    assert {name for name, verdict in verdicts.items() if verdict == "misprint"} == {
        "size of the Jacobian, and of the Cartesian velocity",
        "v in R(J) at a singularity",
        "bytes of a single and of a double",
        "the pseudoinverse",
        "λ = -1 in (4.10) gives (4.11)",
        "the projection",
        "unit of the positions",
        "py",
        "the ellipse",
    }
    assert verdicts["torques with λ = -4 and -7"] == "not reproducible"
    assert {name for name, verdict in verdicts.items() if verdict == "true under a condition"} == {
        "tau = Jᵀ f",
        "the gradient's part of q'",
        "λ = -.19 on the arc",
        "λ much below -2 at Δt = .0067",
        "largest torque, λ = -.19 against λ = 0",
        "λ = -.61 and -6.1 on the line",
        "λ = 0 from 3000 random starts",
        "λ = -2 from 3000 random starts on the arc",
        "λ = -.19 from 3000 random starts on the arc",
        "λ = -2 from 1000 random starts on the ellipse",
        "λ = -2 from 1000 random starts on the line",
    }


def test_the_page_of_the_site_is_up_to_date(rows):
    rounding = ("λ > 0 at Δt = .002", "random starts on the", "on the line")  # through singularities: chaotic
    assert paper_page_is_up_to_date("sanchez", rows, open_=rounding), "run python docs/pages.py sanchez"


def test_assumed_masses_are_named_beside_every_torque(rows):
    told = [row for row in rows if "torque" in row.quantity or "N m" in row.ours]
    assert len(told) >= 4
    for row in told:
        assert "assumed link masses 3, 2.5, 2, 1.5, 1.2, 1, 0.6, 0.4 kg" in row.note


def test_selected_and_random_starts_are_told_apart(rows):
    texts = [f"{row.quantity} {row.note}" for row in rows if row.where.startswith(("figure 5.9", "figure 5.27"))]
    assert any("searched for" in text for text in texts)
    assert any("random starts" in text for text in texts)


def table_point(name, i, count):
    """Table 5.1, in m, with y = pyo."""
    if name == "line":
        return np.array([-0.5 + i / count, 0.2, -0.5 + i / count])
    centre, radius, turn = {
        "arc": (np.array([0.0, 0.05, -0.25]), 0.25, np.pi),
        "ellipse": (np.array([0.1, 0.6, -0.25]), 0.30, 2.0 * np.pi),
    }[name]
    theta = turn * i / count
    return centre + radius * np.array([np.cos(theta), 0.0, np.sin(theta)])


@pytest.mark.parametrize("name", NAMES)
def test_paths_are_those_of_table_5_1(name):
    path = sanchez_paths.PATHS[name]()
    count = 1000
    found = path.sample(2.0 * np.arange(count + 1) / count, "position").held
    np.testing.assert_allclose(found, [table_point(name, i, count) for i in range(count + 1)], atol=1e-14)
    arm = cr.load("sanchez_8r")
    for start in sanchez_paths.ON[name]:
        np.testing.assert_allclose(arm.position(sanchez_paths.STARTS[start]), table_point(name, 0, 1), atol=1e-10)


def lowest(name, start, gain, steps):
    """The least det J J^T of the thesis' law in plain NumPy, the gradient by central differences."""
    arm, q = cr.load("sanchez_8r"), np.array(sanchez_paths.STARTS[start])
    least = np.inf
    for k in range(steps + 1):
        jacobian = arm.jacobian(q)
        least = min(least, float(np.linalg.det(jacobian @ jacobian.T)))
        velocity = np.zeros(6)
        velocity[:3] = (table_point(name, k + 1e-3, steps) - table_point(name, k - 1e-3, steps)) / (2e-3 * 2.0 / steps)
        near = arm.jacobian(q + np.concatenate([1e-5 * np.eye(8), -1e-5 * np.eye(8)]))
        w = np.linalg.det(near @ np.swapaxes(near, 1, 2)) ** 0.5
        gradient = (w[:8] ** -0.5 - w[8:] ** -0.5) / 2e-5
        inverse = np.linalg.pinv(jacobian)
        q = q + 2.0 / steps * (inverse @ velocity + gain * (gradient - inverse @ (jacobian @ gradient)))
    return least


@pytest.mark.parametrize(("name", "start", "gain", "steps"), [("arc", "B", -2.0, 299), ("ellipse", "E", -0.8, 1000)])
def test_runs_are_those_of_plain_numpy(name, start, gain, steps):
    ours = float(sanchez_runs.run_from(start, gain, steps).determinant.min())
    assert ours == pytest.approx(lowest(name, start, gain, steps), rel=1e-3)


def test_random_starts_are_at_the_start_and_spread():
    q = sanchez_paths.random_starts("ellipse", 200, seed=3)
    assert q.shape == (200, 8)
    np.testing.assert_allclose(cr.load("sanchez_8r").position(q), np.tile([0.4, 0.6, -0.25], (200, 1)), atol=1e-9)
    assert (np.ptp(q, axis=0) > 2.0).all()  # radians
    assert not np.array_equal(q, sanchez_paths.random_starts("ellipse", 200, seed=4))
    assert np.array_equal(q[:50], sanchez_paths.random_starts("ellipse", 200, seed=3)[:50])


def test_every_figure_is_known_and_each_kind_is_drawn():
    known = {*sanchez_figures.PLACES, *sanchez_figures.DRAWN}
    assert known == {f"5.{k}" for k in range(1, 33)}
    for name in ("5.5", "5.12", "5.30"):
        figure = sanchez_figures.draw(name)
        assert figure.get_suptitle().startswith(f"Figure {name}: ")
        figure.savefig(io.BytesIO(), format="svg")
    assert "assumed link masses" in sanchez_figures.draw("5.10").get_suptitle()
    start = cr.load("sanchez_8r").jacobian(sanchez_paths.STARTS["E"])
    assert f"det J Jᵀ = E {np.linalg.det(start @ start.T):.2g}" in sanchez_figures.draw("5.4").get_suptitle().replace(
        "\n", " "
    )
    beside = [text for axes in sanchez_figures.draw("5.11").axes for text in axes.texts]
    assert [text.get_text() for text in beside] == [f"q{j}" for j in range(1, 9)]
    assert all(text.xy[0] >= 1.0 for text in beside)  # no curve runs behind them
    lines = sanchez_figures.draw("5.9").axes[0].lines
    assert len(lines) == 3  # A, B, C
    for line in lines:
        t, height = line.get_xydata().T
        assert t[height.argmin()] == pytest.approx(1.28, abs=0.015)


def test_errors_of_the_tip_are_drawn_for_every_start():
    figure = sanchez_figures.draw_errors()
    assert [axes.get_title(loc="left") for axes in figure.axes] == ["n (x axis)", "o (y axis)", "a (z axis)", "p [m]"]
    assert all(len(axes.lines) == 6 for axes in figure.axes)
    run = sanchez_runs.run_from("B", -2.0)
    away = np.linalg.norm(run.arm.position(run.q) - sanchez_paths.thesis_arc().sample(run.t, "position").held, axis=1)
    np.testing.assert_allclose(figure.axes[3].lines[4].get_ydata(), away, atol=1e-15)
    assert f"B {1000.0 * away.max():.2g}" in figure.get_suptitle().replace("\n", " ")


def test_the_map_of_gains_shows_the_bound():
    figure = sanchez_figures.draw_gains()
    axes = figure.axes[0]
    crosses = next(line for line in axes.lines if line.get_marker() == "x").get_xydata()
    assert len(crosses) > 5
    assert (crosses.prod(axis=1) > 1000.0).all()  # the path is lost only where |gain| step is above 1 s
    assert sanchez_figures.draw_starts().axes[0].get_title(loc="left").startswith("Of 3000 random starts")
