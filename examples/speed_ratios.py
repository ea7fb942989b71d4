"""How should a spare joint move along an ellipse, so that the path has to be corrected seldom?"""

import sys

import chainrule as cr
from chainrule.plot.following import draw_following


def main(figure: str) -> None:
    arm, path = cr.planar_3r(1.0, 0.8, 0.6), cr.Ellipse((1.2, 0.3), (0.6, 0.3), rotation=0.4)
    methods = ("pseudoinverse", "speed_ratio", "look_ahead")
    runs = [cr.follow(arm, path, 0.002, method=method) for method in methods]
    for run in runs:
        print(f"{run.method}: {run.updates} updates, {run.status}, never more than {1e3 * run.worst:.3f} mm off")
    draw_following(arm, path, runs).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "speed_ratios.svg")
