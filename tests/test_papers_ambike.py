"""The reproduction of Ambike, Schmiedeler and Stanisic: every row good, able to fail, the misprints where they are."""

import numpy as np
import pytest
from site_pages import paper_page_is_up_to_date

import chainrule as cr
from chainrule.papers import VERDICTS, ambike


@pytest.fixture(scope="module")
def rows():
    more, ambike.MORE = ambike.MORE, ()  # what other modules add has tests of its own
    try:
        return ambike.rows()
    finally:
        ambike.MORE = more


def test_nothing_is_left_unexplained(rows):
    assert [row.quantity for row in rows if not row.good] == []
    assert {row.verdict for row in rows} <= set(VERDICTS)
    assert all(row.how and row.where and row.paper and row.ours for row in rows)
    assert all(row.note for row in rows if row.verdict != "agrees")
    assert not any(row.note.endswith(".") for row in rows)  # the full stop is added where notes are printed


def test_every_number_of_the_examples_is_there(rows):
    printed = {text for row in rows for text in row.paper.split(", ")}
    numbers = """-6.4670 -26.3920 -26.9267 6.7015 27.8167 26.9752 -48.6844 50.6686 1.9842 -0.0343 3.0319 -6.0402 -3.7154
        -0.8262 0.4414 2.9052 6.3343 0.2345 1.4247 0.0485 -9.6866 -40.7486 -42.8541 -19.3305 -102.2244 -135.1469 3.4823
        28.8917 49.2146 -219.0375 149.219 -69.8184 0.6812 0.3188 -2.1033 -0.7671 -0.7398 -4.3965"""
    assert set(numbers.split()) <= printed
    assert sum(row.ours == "the same, proved" for row in rows) >= 3


def polynomials(q, tangent):
    """A of (5), and a, b of (7), from nothing but the chain: derivatives of a complex number, n3 put into (6)."""
    lengths, angles = (1.15, 1.5, 1.8), np.cumsum(np.radians(q))
    t = complex(*tangent) / abs(complex(*tangent))
    links = [size * np.exp(1j * angle) / t for size, angle in zip(lengths, angles, strict=True)]
    first = [1j * sum(links[k:]) for k in range(3)]
    second = [[-sum(links[max(i, k) :]) for k in range(3)] for i in range(3)]
    slant, offset = first[1].imag / first[2].imag, first[0].imag / first[2].imag  # n3 = -(slant n2 + offset)
    rates = np.array([[0.0, 1.0], [1.0, 0.0], [-slant, -offset]])  # of the three joints, by powers (1, 0) of n2
    bend = sum(np.convolve(rates[i], rates[k]) * second[i][k].imag for i in range(3) for k in range(3))
    speed = sum(rates[i] * first[i].real for i in range(3))
    return -np.array([first[1].imag, first[2].imag, first[0].imag]), np.convolve(speed, speed), -bend


@pytest.mark.parametrize(
    ("pose", "tangent", "tracked", "printed"),
    [
        ([-14, -10, -205], (2, 1), 1.0, (0.2345, 1.4247, 0.0485)),
        ([-14, -40, -205], (1, 0.35), 0.68124901, (-9.6866, -40.7486, -42.8541)),
    ],
)
def test_the_printed_a_are_the_coefficients_of_seven(pose, tangent, tracked, printed):
    line, a, b = polynomials(pose, tangent)
    np.testing.assert_allclose(b - tracked * a, printed, atol=0.6e-4)
    assert np.abs(line - printed).min() > 0.1  # and not those of (5), nor a multiple of them
    assert np.linalg.matrix_rank(np.array([line, printed]), tol=1e-2) == 2
    found = ambike.example("example 1" if pose[1] == -10 else "example 2")
    np.testing.assert_allclose(found.A, line, rtol=1e-12)
    np.testing.assert_allclose(found.a, a, rtol=1e-11)
    np.testing.assert_allclose(found.b, b, rtol=1e-10)


def test_the_printed_curvature_rates_have_a_sign_changed():
    """From the curvature of the path itself, by differences: 0.4205 and 0.0991, in absolute value."""
    found, arm = ambike.example("example 1"), cr.load("ambike_3r")
    lengths = np.array([1.15, 1.5, 1.8])

    def curvature(rates, s):
        angles, turning = np.cumsum(found.q + rates * s), np.cumsum(rates)
        velocity = (1j * lengths * turning * np.exp(1j * angles)).sum()
        acceleration = (-lengths * turning**2 * np.exp(1j * angles)).sum()
        return (np.conj(velocity) * acceleration).imag / abs(velocity) ** 3

    h = 1e-5  # the speed is 1 at s = 0, so time is arc length to first order
    differences = [(curvature(x, h) - curvature(x, -h)) / (2 * h) for x in found.rates]
    np.testing.assert_allclose(differences, [0.4205, 0.0991], atol=0.6e-4)
    np.testing.assert_allclose(found.curvature_rates, differences, atol=1e-8)
    np.testing.assert_allclose(ambike.wrong_sign(arm, found), [-0.8262, 0.4414], atol=0.6e-4)
    assert np.argmin(np.abs(differences)) == np.argmin(np.abs([-0.8262, 0.4414])) == found.chosen


def test_a_changed_polynomial_is_found_out(monkeypatch):
    monkeypatch.setattr(ambike, "plain_elimination", lambda arm, leading: ([1, 3, 1], [1, 2, 1]))
    assert any(row.verdict == "DISAGREES" for row in ambike._claims())


def test_a_changed_answer_is_found_out(monkeypatch):
    original = ambike.speed_ratios
    monkeypatch.setattr(ambike, "speed_ratios", lambda arm, q, t, k: original(arm, np.asarray(q) + 1e-3, t, k))
    bad = [row.quantity for row in ambike._first(ambike.example("example 1")) if not row.good]
    assert {"a1", "b3", "C", "D", "Δ", "solution 1, n2", "A1, A2, A3 of (5)"} <= set(bad)
    assert "solution 1, rate of change of curvature" in bad


def test_what_other_modules_add_comes_last(monkeypatch):
    monkeypatch.setattr(ambike, "_claims", list)  # proved above
    monkeypatch.setattr(ambike, "MORE", (("more", "chainrule.papers.ambike", "shown_more"),))
    monkeypatch.setattr(
        ambike, "shown_more", lambda progress: (ambike.shown_answer("", "", "", True, ""),), raising=False
    )
    said = []
    found = ambike.rows(said.append)
    assert found[-1] == ambike.shown_answer("", "", "", True, "")
    assert said[-1] == "speed ratios: more"


def test_the_page_of_the_site_is_up_to_date(rows):
    assert paper_page_is_up_to_date("ambike", rows, whole=False), "run python docs/pages.py ambike"
