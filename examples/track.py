"""How do joints to spare keep an arm away from a singularity while its hand follows an arc?"""

import sys

import chainrule as cr
from chainrule.papers.sanchez_paths import STARTS, thesis_arc
from chainrule.plot import draw_runs


def main(figure: str) -> None:
    arm, path, start = cr.load("sanchez_8r"), thesis_arc(), STARTS["A"]
    runs = {
        "pseudoinverse": cr.track(arm, path, start, method="pseudoinverse"),
        "gradient projection": cr.track(arm, path, start, gain=-2.0),
    }
    for name, run in runs.items():
        print(f"{name}: {run.status}, H at least {run.min_manipulability:.2g}, rates up to {run.peak_rate:.2g} rad/s")
    draw_runs(runs).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "track.svg")
