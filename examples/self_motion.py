"""In which ways can a Panda move while its hand holds still, and which of them do its joint limits leave?"""

import sys

import chainrule as cr
from chainrule.plot.self_motion import draw_self_motion


def main(figure: str) -> None:
    panda = cr.load("panda")
    pose = panda.pose([0.1, -0.5, 0.3, -2.0, 0.2, 1.6, 0.4])
    found = cr.self_motion(panda, pose, limits=True)
    print(f"{found.count} closed curves (none missing: {found.complete}); within the limits {len(found.arcs)} arcs:")
    for arc in found.arcs:
        print(f"  {arc.length:.3f} rad on curve {arc.of}, from {arc.ends[0]} to {arc.ends[1]}")
    best = cr.best_posture(panda, found, "limits")
    print("farthest from every limit:", best.q.round(3))
    draw_self_motion(panda, found, best.curve).savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "self_motion.svg")
