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
from chainrule.plot.maps import draw_map, draw_optima
from chainrule.plot.timing import draw_profiles
from chainrule.plot.workspace import draw_workspace

__all__ = ["draw_arm", "draw_map", "draw_optima", "draw_profiles", "draw_workspace"]
