"""Which arms of a family are cuspidal, and how does one of them change its posture without a singularity?"""

import sys

import numpy as np

import chainrule as cr
from chainrule.plot.cuspidality import draw_design


def main(figure: str) -> None:
    d4 = np.linspace(0.2, 4.0, 20)
    domains = cr.classify_orthogonal_3r(1.0, 2.0, d4, 1.0)
    print("domain of d2 = 1, d3 = 2, r2 = 1 over d4:", *np.unique(domains).tolist())
    arm = cr.orthogonal_3r(1.0, 2.0, 1.5, 1.0)
    print(f"d4 = 1.5: domain {arm.domain}, {len(arm.cusps())} cusps, cuspidal: {arm.cuspidal}")
    postures = arm.postures(2.5, 0.0, 0.5)
    change = arm.posture_change(postures[0], postures[2])
    least = f"{change.smallest_determinant:.3f}"
    print(f"between two of {len(postures)} postures, proved {change.certified}: |det J| > {least}")
    draw_design(arm, change).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "cuspidality.svg")
