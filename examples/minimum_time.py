"""How fast can a planar arm be at a pose, which of its two postures is sooner there, and which joints have slack?"""

import sys

import numpy as np

import chainrule as cr
from chainrule.plot.timing import draw_profiles


def main(figure: str) -> None:
    arm = cr.load("planar_3r")
    goals = cr.postures(arm, 1.25, 0.5, 0.0)
    limits = arm.limits
    best = cr.fastest([0.0, 0.0, 0.0], goals.q, limits.velocity, limits.acceleration, kinds=arm.kinds)
    print("durations of the postures:", best.durations.round(4), "s; taken:", np.degrees(goals.q[best.index]).round(2))
    print("slack of the joints:", best.move.slack.round(4), "s; the only fastest motion:", bool(best.unique))
    draw_profiles(best.move, arm.kinds).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "minimum_time.svg")
