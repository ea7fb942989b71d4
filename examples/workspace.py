"""Where can a planar arm be within its joint limits, and with which orientations?"""

import sys

import numpy as np

import chainrule as cr
from chainrule.plot.workspace import draw_workspace


def main(figure: str) -> None:
    arm = cr.planar_3r(1.0, 0.5, 0.25).with_limits(position=[(-0.5, 2.0), (-2.0, 2.0), (-2.5, 2.5)])
    found = cr.workspace(arm)
    print(f"area {found.area:.6f} m², bounded by {len(found.region.pieces)} pieces")
    at = (0.6, 0.7)
    ranges = [np.degrees(interval).round(1).tolist() for interval in found.orientations(*at)]
    print(f"orientations at {at}, degrees:", ranges)
    draw_workspace(arm, found, at=at).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "workspace.svg")
