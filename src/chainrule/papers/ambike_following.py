"""S. Ambike, J. P. Schmiedeler and M. M. Stanisic: what the paper claims of following a path, measured.

Its two figures, and its claims over many random arms, postures and paths instead of two.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from chainrule.following_compared import Comparison, Loops, Study, compare, study, study_paths
from chainrule.loading import load
from chainrule.papers import Row
from chainrule.parametric_paths import Ellipse
from chainrule.paths import Circle, Path
from chainrule.stretches import Method

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: The postures (deg) and tangents of the two examples; both turn right, with curvature 1.
EXAMPLES = {
    "figure 1": ((-14.0, -10.0, -205.0), (2.0, 1.0)),
    "figure 2": ((-14.0, -40.0, -205.0), (0.9439, 0.3304)),
}
ERROR = 0.025
#: Random arms, and random arms that follow a whole path.
CASES, LOOPS = 300, 20
_BOTH: tuple[Method, ...] = ("pseudoinverse", "speed_ratio")


def example(figure: str) -> Comparison:
    """Both methods from the posture of a figure until the position error reaches 0.025.

    Example:
        >>> round(float(example("figure 1").of("speed_ratio")), 3)
        1.163
    """
    q, tangent = EXAMPLES[figure]
    return compare(load("ambike_3r"), np.radians(q), tangent, -1.0, ERROR, methods=_BOTH)


def figures() -> dict[str, Figure]:
    """Both figures: the paths and their centres of curvature until the position error reaches 0.025."""
    from chainrule.plot.following import draw_stretches

    arm = load("ambike_3r")
    return {
        figure.replace(" ", "-"): draw_stretches(arm, np.radians(q), tangent, -1.0, example(figure))
        for figure, (q, tangent) in EXAMPLES.items()
    }


def rows_following(progress: Callable[[str], None] = lambda line: None) -> tuple[Row, ...]:
    """The figures and claims about following a path."""
    progress("the stretches of figures 1 and 2")
    found = [_figure(figure) for figure in EXAMPLES]
    progress("stretches of random arms and postures")
    studies = [study(CASES, tolerance, seed=1) for tolerance in (0.025, 0.005, 0.0005)]
    found += [_longer(studies), _nearest(studies[0]), _root(studies[0]), _second_term(studies), _ahead(studies)]
    progress("whole paths")
    return (*found, *(_updates(name, path) for name, path in _PATHS.items()))


_PATHS: dict[str, Path] = {
    "circles of radius 0.3": Circle((0.0, 0.0), 0.3),
    "ellipses, semi-axes 0.5 and 0.2": Ellipse((0.0, 0.0), (0.5, 0.2)),
}


def _figure(figure: str) -> Row:
    found = example(figure)
    plain, ratio = (float(found.of(method)) for method in _BOTH)
    return Row(
        figure,
        "arc length followed until the position error reaches 0.025",
        "longer with the speed ratio",
        f"{ratio:.4g} instead of {plain:.4g}",
        None,
        "agrees" if ratio > plain else "DISAGREES",
        f"ambike_following.example('{figure}')",
    )


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100.0 * share:.3g} %"


def _longer(studies: list[Study]) -> Row:
    facts = [entry.to_dict() for entry in studies]
    worse = ", ".join(_percent(fact["worse"]) for fact in facts)
    medians = ", ".join(f"{fact['median']:.3g}" for fact in facts)
    return Row(
        "section 4, abstract",
        "the speed ratio stays close for a longer portion of the path than the pseudoinverse",
        "in both examples",
        f"{_percent(1.0 - facts[0]['worse'])} of {CASES} random arms",
        None,
        "true under a condition",
        f"following_compared.study({CASES}, 0.025, seed=1)",
        f"it makes the error in s² vanish and leaves that in s³ as it is: less far than the pseudoinverse in {worse} "
        f"of cases where the position error may be 0.025, 0.005, 0.0005; median travel {medians} times its travel",
    )


def _nearest(entry: Study) -> Row:
    facts = entry.to_dict()
    return Row(
        "example 2",
        "where Δ < 0 the nearest curvature gives the most locally accurate path",
        "stated",
        f"median gain {facts['median_not_met']:.4g}",
        None,
        "true under a condition",
        f"following_compared.study({CASES}, 0.025, seed=1)",
        f"right to second order, but the gain over the pseudoinverse is almost nil there (where Δ > 0 its median is "
        f"{facts['median_met']:.3g}), and in {_percent(facts['worse_not_met'])} of cases it is a loss",
    )


def _root(entry: Study) -> Row:
    facts = entry.to_dict()
    return Row(
        "section 3",
        "of the two solutions, the one whose dκ/ds is nearer the desired one goes farther",
        "stated by an example",
        f"in {facts['two_roots'] - facts['better_root_missed']} of {facts['two_roots']} cases",
        None,
        "true under a condition",
        f"following_compared.study({CASES}, 0.025, seed=1)",
        "the sign of the two errors and the terms of higher order decide the rest",
    )


def _second_term(studies: list[Study]) -> Row:
    shares = ", ".join(_percent(entry.to_dict()["winner_predicted"]) for entry in studies)
    return Row(
        "section 5",
        "higher-order path information yields paths that track the desired one more closely",
        "second order, always",
        f"the offset's terms in s² and s³, with their signs, tell which method goes farther in {shares}",
        None,
        "true under a condition",
        f"following_compared.study({CASES}, tolerance, seed=1)",
        "where those two terms say so; for position errors of 0.025, 0.005, 0.0005",
    )


def _ahead(studies: list[Study]) -> Row:
    facts = [entry.to_dict() for entry in studies]
    never = all(fact["look_ahead_worse"] == 0.0 for fact in facts)
    medians = ", ".join(f"{fact['look_ahead_median']:.3g}" for fact in facts)
    return Row(
        "section 5",
        "less feedback is required",
        "with the speed ratio alone",
        f"median travel {medians} times the pseudoinverse's, never less"
        if never
        else "less than the pseudoinverse in some cases",
        None,
        "true under a condition" if never else "DISAGREES",
        f"following_compared.study({CASES}, tolerance, seed=1)",
        "in every case if the candidates of both methods and of the two-term rule are tried; for position errors of "
        "0.025, 0.005, 0.0005",
    )


def _updates(name: str, path: Path) -> Row:
    loops: Loops = study_paths(path, LOOPS, 0.005, methods=_BOTH, seed=1)
    facts = loops.to_dict()["methods"]["speed_ratio"]
    return Row(
        "section 1, abstract",
        f"less feedback is needed: {name}, position error 0.005",
        "stated",
        f"fewer updates in {_percent(facts['fewer'])}, median {facts['median_ratio']:.3g} of the pseudoinverse's",
        None,
        "true under a condition" if facts["more"] else "agrees",
        f"following_compared.study_paths(path, {LOOPS}, 0.005, seed=1)",
        f"more updates in {_percent(facts['more'])} of {LOOPS} random arms" if facts["more"] else "",
    )
