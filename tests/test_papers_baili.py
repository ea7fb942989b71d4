"""The reproduction of Baili, Wenger and Chablat: every row good, able to fail, the corrections where they are."""

import numpy as np
import pytest
from site_pages import paper_page_is_up_to_date

from chainrule.cuspidality.classify import classify_orthogonal_3r
from chainrule.papers import VERDICTS, baili


@pytest.fixture(scope="module")
def rows():
    return baili.rows()


def test_nothing_is_left_unexplained(rows):
    assert [row.quantity for row in rows if not row.good] == []
    assert {row.verdict for row in rows} <= set(VERDICTS)
    assert all(row.how and row.where and row.paper and row.ours for row in rows)
    assert all(row.note for row in rows if row.verdict != "agrees")
    assert not any(row.note.endswith(".") for row in rows)


def test_the_corrections_are_where_they_are(rows):
    corrected = {row.where for row in rows if row.verdict == "misprint"}
    places = {"equation (1)", "before equation (6)", "figure 7", "condition (7), first line", "condition (7)"}
    assert corrected == places
    assert {row.where for row in rows if row.ours == "the same, proved"} >= {"equation (2)", "equation (4)"}
    (hypothesis,) = [row for row in rows if row.quantity == "r2 = 0"]
    assert hypothesis.verdict == "true under a condition"


def test_every_figure_has_a_row(rows):
    where = " ".join(row.where for row in rows)
    assert all(f"figure {number}" in where for number in (2, 3, 4, 5, 6, 7))


def test_the_rows_can_fail(monkeypatch):
    monkeypatch.setitem(baili.INSIDE, 2, (1, "0.7", "0.2", "0.3"))  # an arm of domain 1
    assert [row.quantity for row in baili._domains() if not row.good] != []
    assert [row.quantity for row in baili._figures() if not row.good] != []


def test_the_printed_condition_errs_on_one_side_only():
    """Where the two differ the true bound on d4 is lower: by bisection, against the generated classification."""
    rng = np.random.default_rng(3)
    d3, r2 = rng.uniform(0.1, 3.0, (2, 200))
    low, high = np.zeros(200), np.full(200, 3.0)
    for _ in range(60):  # the least d4 that is cuspidal
        middle = (low + high) / 2
        cuspidal = classify_orthogonal_3r(1.0, d3, middle, r2) >= 2
        low, high = np.where(cuspidal, low, middle), np.where(cuspidal, middle, high)
    x, root = d3**2 + r2**2, np.sqrt(((d3 + 1) ** 2 + r2**2) * ((d3 - 1) ** 2 + r2**2))
    true = np.sqrt((x - (x**2 - (d3**2 - r2**2)) / root) / 2)
    np.testing.assert_allclose(high, true, rtol=1e-6, atol=1e-9)
    printed = np.sqrt(np.maximum((x - (x**2 - x) / root) / 2, 0.0))
    assert (printed >= true - 1e-12).all()
    assert (baili.printed_condition(1.0, d3, true + 1e-6, r2, corrected=True) | (d3 < 1.0)).all()
    assert not baili.printed_condition(1.0, d3, true - 1e-6, r2, corrected=True).any()
    assert not baili.printed_condition(1.0, d3, (true + printed) / 2, r2)[printed - true > 1e-3].any()


def test_the_page_of_the_site_is_up_to_date(rows):
    assert paper_page_is_up_to_date("baili", rows), "run python docs/pages.py baili"
