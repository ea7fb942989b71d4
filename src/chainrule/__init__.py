"""chainrule: what is known about a robot arm, as code that can be trusted.

>>> import chainrule as cr
>>> arm = cr.load("panda")
>>> arm.jacobian([0.0, -0.8, 0.0, -2.3, 0.0, 1.6, 0.8]).shape
(6, 7)

Names load what they need on first use, so that importing the package is quick.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from chainrule.arm import Arm, Limits, planar, planar_3r
    from chainrule.compile import NoCompilerWarning
    from chainrule.cuspidality.classify import classify_orthogonal_3r
    from chainrule.cuspidality.designs import FreeJointWarning, Orthogonal3R, Regional3R, orthogonal_3r, regional_3r
    from chainrule.cuspidality.feasible import FeasiblePostures
    from chainrule.cuspidality.posture_change import PostureChange
    from chainrule.cuspidality.witness import Witness, posture_change_witness
    from chainrule.errors import DescriptionError, GenerationError, InputError
    from chainrule.export import generate
    from chainrule.following import follow
    from chainrule.four_joints import speed_ratios_4, speed_ratios_4_each
    from chainrule.goals import FastestMove, Postures, fastest, postures
    from chainrule.higher_order import motion_ratios
    from chainrule.loading import load
    from chainrule.manipulability import ManipulabilityMap, Maximum, manipulability_map, max_manipulability
    from chainrule.parametric_paths import Curve, Ellipse, Spline
    from chainrule.paths import Arc, Circle, Line
    from chainrule.readers.paths import read_path
    from chainrule.redundancy.batch import Batch, Forecast, forecast, track_batch
    from chainrule.redundancy.fastest import fastest_run
    from chainrule.redundancy.globally import GlobalRun, track_globally
    from chainrule.redundancy.path_files import read_task_path
    from chainrule.redundancy.result import Event, Run
    from chainrule.redundancy.task_path import TaskPath
    from chainrule.redundancy.track import track
    from chainrule.scaling import time_scaling
    from chainrule.self_motions.along import SelfMotionAlong, self_motion_along
    from chainrule.self_motions.best import BestPosture, best_posture
    from chainrule.self_motions.face import self_motion
    from chainrule.self_motions.maps import SelfMotionMap, self_motion_map
    from chainrule.self_motions.result import Component, SelfMotion
    from chainrule.self_motions.singular import NearestSingular, nearest_singular
    from chainrule.speed_ratio import SpeedRatios, speed_ratios
    from chainrule.timing import JointMove, min_time
    from chainrule.workspaces import Workspace, workspace

    __version__: str

__all__ = [
    "Arc",
    "Arm",
    "Batch",
    "BestPosture",
    "Circle",
    "Component",
    "Curve",
    "DescriptionError",
    "Ellipse",
    "Event",
    "FastestMove",
    "FeasiblePostures",
    "Forecast",
    "FreeJointWarning",
    "GenerationError",
    "GlobalRun",
    "InputError",
    "JointMove",
    "Limits",
    "Line",
    "ManipulabilityMap",
    "Maximum",
    "NearestSingular",
    "NoCompilerWarning",
    "Orthogonal3R",
    "PostureChange",
    "Postures",
    "Regional3R",
    "Run",
    "SelfMotion",
    "SelfMotionAlong",
    "SelfMotionMap",
    "SpeedRatios",
    "Spline",
    "TaskPath",
    "Witness",
    "Workspace",
    "best_posture",
    "classify_orthogonal_3r",
    "fastest",
    "fastest_run",
    "follow",
    "forecast",
    "generate",
    "load",
    "manipulability_map",
    "max_manipulability",
    "min_time",
    "motion_ratios",
    "nearest_singular",
    "orthogonal_3r",
    "planar",
    "planar_3r",
    "posture_change_witness",
    "postures",
    "read_path",
    "read_task_path",
    "regional_3r",
    "self_motion",
    "self_motion_along",
    "self_motion_map",
    "speed_ratios",
    "speed_ratios_4",
    "speed_ratios_4_each",
    "time_scaling",
    "track",
    "track_batch",
    "track_globally",
    "workspace",
]

_HOMES = {
    **dict.fromkeys(("Arm", "Limits", "planar", "planar_3r"), "chainrule.arm"),
    "load": "chainrule.loading",
    "classify_orthogonal_3r": "chainrule.cuspidality.classify",
    **dict.fromkeys(
        ("FreeJointWarning", "Orthogonal3R", "Regional3R", "orthogonal_3r", "regional_3r"),
        "chainrule.cuspidality.designs",
    ),
    "FeasiblePostures": "chainrule.cuspidality.feasible",
    "PostureChange": "chainrule.cuspidality.posture_change",
    **dict.fromkeys(("Witness", "posture_change_witness"), "chainrule.cuspidality.witness"),
    **dict.fromkeys(("DescriptionError", "GenerationError", "InputError"), "chainrule.errors"),
    "NoCompilerWarning": "chainrule.compile",
    "generate": "chainrule.export",
    **dict.fromkeys(("FastestMove", "Postures", "fastest", "postures"), "chainrule.goals"),
    **dict.fromkeys(
        ("ManipulabilityMap", "Maximum", "manipulability_map", "max_manipulability"), "chainrule.manipulability"
    ),
    **dict.fromkeys(("Curve", "Ellipse", "Spline"), "chainrule.parametric_paths"),
    **dict.fromkeys(("Arc", "Circle", "Line"), "chainrule.paths"),
    **dict.fromkeys(("JointMove", "min_time"), "chainrule.timing"),
    **dict.fromkeys(("speed_ratios_4", "speed_ratios_4_each"), "chainrule.four_joints"),
    "follow": "chainrule.following",
    "motion_ratios": "chainrule.higher_order",
    **dict.fromkeys(("SpeedRatios", "speed_ratios"), "chainrule.speed_ratio"),
    "time_scaling": "chainrule.scaling",
    **dict.fromkeys(("Component", "SelfMotion"), "chainrule.self_motions.result"),
    **dict.fromkeys(("SelfMotionAlong", "self_motion_along"), "chainrule.self_motions.along"),
    **dict.fromkeys(("SelfMotionMap", "self_motion_map"), "chainrule.self_motions.maps"),
    **dict.fromkeys(("BestPosture", "best_posture"), "chainrule.self_motions.best"),
    **dict.fromkeys(("NearestSingular", "nearest_singular"), "chainrule.self_motions.singular"),
    "self_motion": "chainrule.self_motions.face",
    "read_path": "chainrule.readers.paths",
    **dict.fromkeys(("GlobalRun", "track_globally"), "chainrule.redundancy.globally"),
    "read_task_path": "chainrule.redundancy.path_files",
    **dict.fromkeys(("Event", "Run"), "chainrule.redundancy.result"),
    "TaskPath": "chainrule.redundancy.task_path",
    "fastest_run": "chainrule.redundancy.fastest",
    "track": "chainrule.redundancy.track",
    **dict.fromkeys(("Batch", "Forecast", "forecast", "track_batch"), "chainrule.redundancy.batch"),
    **dict.fromkeys(("Workspace", "workspace"), "chainrule.workspaces"),
}


if not TYPE_CHECKING:  # to a type checker it would mean that every name exists

    def __getattr__(name: str) -> Any:
        from importlib import import_module

        if name in _HOMES:
            return getattr(import_module(_HOMES[name]), name)
        if name == "__version__":
            from importlib.metadata import version

            return version("chainrule")
        raise AttributeError(f"module 'chainrule' has no attribute {name!r}")


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
