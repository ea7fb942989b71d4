"""In which posture is an arm most dexterous, and how do we know?"""

import sys

import numpy as np

import chainrule as cr
from chainrule.plot.maps import draw_map


def main(figure: str) -> None:
    arm = cr.planar_3r(1.0, 0.5, 0.25)
    best = cr.max_manipulability(arm)
    print(f"H = {best.value:.10f} m² at {np.degrees(best.q).round(2)} degrees, proved: {best.proved}")
    print(best.how)
    draw_map(arm, cr.manipulability_map(arm, size=61)).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "manipulability.svg")
