"""How do an arm's functions get into another program? As C: written, compiled and called here."""

import ctypes
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import chainrule as cr
from chainrule.plot.workspace import draw_workspace


def main(figure: str) -> None:
    arm = cr.planar("RR", [1.0, 0.6]).with_limits(position=[(-0.5, 2.0), (-2.5, 2.5)])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        cr.generate(arm, folder, targets=["c"])
        command = ["cc", "-std=c99", "-O2", "-shared", "-fPIC", "planar_rr.c", "-lm", "-o", "planar_rr.so"]
        subprocess.run(command, cwd=folder, check=True)
        position = ctypes.CDLL(str(folder / "planar_rr.so")).planar_rr_position
    numbers = ctypes.POINTER(ctypes.c_double)
    position.argtypes, position.restype = [numbers, numbers, numbers], None

    low, high = arm.limits.position.T
    q = np.random.default_rng(0).uniform(low, high, (400, 2))
    tips = np.empty((len(q), 2))
    for row, tip in zip(q, tips, strict=True):  # as a controller would: one configuration, nothing allocated
        position(row.ctypes.data_as(numbers), arm.parameters.ctypes.data_as(numbers), tip.ctypes.data_as(numbers))
    print(f"{len(q)} tips from C; farthest from chainrule's own: {np.abs(tips - arm.position(q)).max():.1e} m")

    drawing = draw_workspace(arm)
    drawing.axes[0].plot(*tips.T, ".", ms=3, color="0.2")
    drawing.savefig(figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "generated_c.svg")
