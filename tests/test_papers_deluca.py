"""The reproduction of De Luca's exercise: every row good, and able to fail."""

import math

import pytest
import sympy as sp
from site_pages import paper_page_is_up_to_date

from chainrule import InputError
from chainrule.papers import PAPERS, VERDICTS, compared, deluca, reproduce, shown_equal
from chainrule.papers.deluca import vanishes


@pytest.fixture(scope="module")
def rows():
    return reproduce("deluca")


def test_nothing_is_left_unexplained(rows):
    assert all(row.good for row in rows)
    assert {row.verdict for row in rows} <= set(VERDICTS)
    assert all(row.how and row.where and row.paper and row.ours for row in rows)
    assert all(row.note for row in rows if row.verdict != "agrees")


def test_the_values_are_the_papers(rows):
    printed = {row.quantity: row.paper for row in rows}
    assert printed["primary workspace, inner radius r1"] == "0.25 m"
    assert printed["secondary workspace, outer radius R2"] == "1.25 m"
    assert sum(row.ours == "the same, proved" for row in rows) >= 7


def test_the_optimum_solves_the_stationarity_equations(rows):
    (row,) = [row for row in rows if row.quantity == "largest H, off the grid"]
    q2, q3 = (float(x) for x in row.ours.split("(")[1].rstrip(")").split(","))
    a, b, c = (
        [
            0.5 * math.sin(q2) + 0.25 * math.sin(q2 + q3),
            0.5 * math.cos(q2) + 0.25 * math.cos(q2 + q3),
            0.25 * math.cos(q2 + q3),
        ],
        [
            0.25 * (math.sin(q2 + q3) + 0.5 * math.sin(q3)),
            0.25 * math.cos(q2 + q3),
            0.25 * (math.cos(q2 + q3) + 0.5 * math.cos(q3)),
        ],
        [0.125 * math.sin(q3), 0.0, 0.125 * math.cos(q3)],
    )
    for k in (1, 2):
        assert abs(a[0] * a[k] + b[0] * b[k] + c[0] * c[k]) < 1e-7
    assert float(row.ours.split()[0]) == pytest.approx(math.sqrt(a[0] ** 2 + b[0] ** 2 + c[0] ** 2), abs=1e-9)


def test_a_wrong_value_is_called_wrong():
    assert compared("", "", "0.25", 0.2551, "").verdict == "DISAGREES"
    assert compared("", "", "0.25", 0.2549, "").verdict == "agrees"
    assert not shown_equal("", "", "", False, "").good


def test_the_proof_tells_zero_from_nearly_zero():
    a, b, length = sp.symbols("a b l")
    assert vanishes(sp.sin(a + b) ** 2 + sp.cos(a + b) ** 2 - 1)
    assert vanishes(length * (sp.sin(a + b) - sp.sin(a) * sp.cos(b) - sp.cos(a) * sp.sin(b)))
    assert not vanishes(sp.sin(a) ** 2 - sp.sin(b) ** 2)
    assert not vanishes(sp.Rational(1, 10**30) * sp.sin(a))
    assert not vanishes(length - 1)


def test_a_changed_formula_is_found_out(monkeypatch):
    monkeypatch.setattr(deluca, "closed_minors", lambda arm: tuple(2 * m for m in original(arm)))
    assert any(row.verdict == "DISAGREES" for row in deluca._formulas())


original = deluca.closed_minors


def test_a_wrong_singular_set_is_found_out(monkeypatch):
    monkeypatch.setattr(deluca, "singular_set", lambda arm: found(arm)[:3])
    assert any(row.verdict == "DISAGREES" for row in deluca._formulas())


found = deluca.singular_set


def test_an_unknown_paper_is_refused():
    with pytest.raises(InputError, match="deluca, ambike, baili, lenarcic, sanchez can be reproduced"):
        reproduce("nobody")
    assert "deluca" in PAPERS


def test_the_page_of_the_site_is_up_to_date(rows):
    assert paper_page_is_up_to_date("deluca", rows), "run python docs/pages.py deluca"
