"""Figures: each function draws a result with matplotlib and returns a ``Figure``; none touches global state.

Example:
    >>> import chainrule as cr
    >>> from chainrule.plot import draw_arm
    >>> figure = draw_arm(cr.planar_3r(1.0, 0.5, 0.25), [0.3, 0.8, 0.5])
    >>> len(figure.axes)
    1
"""

from __future__ import annotations

from chainrule.plot.arm import draw_arm
from chainrule.plot.higher_order import draw_four_joints, draw_orders, draw_timings
from chainrule.plot.maps import draw_map, draw_optima
from chainrule.plot.redundancy import draw_population, draw_run, draw_runs, draw_stability
from chainrule.plot.self_motion import draw_curves, draw_lengths, draw_self_motion
from chainrule.plot.speed_ratio import draw_reachable, draw_speed_ratios
from chainrule.plot.timing import draw_profiles
from chainrule.plot.workspace import draw_workspace

__all__ = [
    "draw_arm",
    "draw_curves",
    "draw_four_joints",
    "draw_lengths",
    "draw_map",
    "draw_optima",
    "draw_orders",
    "draw_population",
    "draw_profiles",
    "draw_reachable",
    "draw_run",
    "draw_runs",
    "draw_self_motion",
    "draw_speed_ratios",
    "draw_stability",
    "draw_timings",
    "draw_workspace",
]
