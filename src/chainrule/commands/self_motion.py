"""``chainrule self-motion``: every curve of joint space on which an arm with a joint to spare holds a target."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Task,
    Tip,
    angle,
    app,
    configuration,
    load_arm,
    numbers,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)
from chainrule.errors import InputError, shown
from chainrule.outputs import figure_file, output_file

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.self_motions.best import BestPosture
    from chainrule.self_motions.result import SelfMotion
    from chainrule.self_motions.singular import NearestSingular


@app.command()
def self_motion(
    arm: ArmName,
    target: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y[,..]",
            help="What is held: X,Y; X,alpha; X,Y,alpha; X,Y,Z; or the 16 numbers of a pose's matrix, row by row.",
        ),
    ] = None,
    at: Annotated[
        str | None, typer.Option("--at", metavar="Q", help="Instead: a posture; what its tip does is held.")
    ] = None,
    along: Annotated[
        str | None,
        typer.Option("--along", metavar="X0:X1:N", help="N targets with px from X0 to X1, the rest as given (or 0)."),
    ] = None,
    task: Task = None,
    limits: Annotated[
        bool, typer.Option("--limits", help="Also what is within the joint limits: whole curves and arcs.")
    ] = False,
    best: Annotated[
        str | None, typer.Option(help="The best posture by: manipulability, or limits (far from every stop).")
    ] = None,
    singular: Annotated[
        bool, typer.Option("--singular", help="Also a target near by whose self-motion is singular (a local search).")
    ] = False,
    method: Annotated[
        str | None, typer.Option(help="closed form, sweep, continuation or eigenvector; the best one when left out.")
    ] = None,
    points: Annotated[int, typer.Option(help="Points of each curve, in --csv and --json.")] = 91,
    starts: Annotated[int, typer.Option(help="How many starts a search has, where no other method proves all.")] = 64,
    gamma: Annotated[float, typer.Option(help="Step of --method eigenvector, rad.")] = 0.001,
    scale: Annotated[float, typer.Option(help="Metres that count as one radian of a prismatic joint.")] = 1.0,
    figure: Annotated[
        Path | None, typer.Option(metavar="FILE", callback=figure_file, help="Draw it into a .svg, .png or .pdf file.")
    ] = None,
    animation: Annotated[
        Path | None,
        typer.Option(metavar="FILE", callback=output_file, help="The arm moving along a curve, as a .gif file."),
    ] = None,
    csv: Annotated[
        Path | None,
        typer.Option(
            "--csv",
            metavar="FILE",
            callback=output_file,
            help="Points of all curves (with --limits of all arcs): curve, s, joints, H.",
        ),
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Angles given are degrees.")] = False,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Find all self-motions at a target: each curve's length, windings, range of every joint, and manipulability.

    Exits with 1 if the target is out of reach (with --along: one of the targets; with --best: within the limits).

    Example: chainrule self-motion lenarcic_3r --target 0.4,0 --figure self-motion.svg
    """
    from chainrule.self_motions.face import self_motion as find
    from chainrule.self_motions.held import held_task

    loaded = load_arm(arm, tip, base)
    task = held_task(loaded, task)
    _check_files(animation, csv)
    aim = _target(loaded, task, target, at, along, deg)
    if along is not None:
        _refuse_with_along(best, singular, animation, csv, figure, loaded, task)
        options = {"method": method, "limits": limits, "starts": starts, "gamma": gamma, "scale": scale}
        _along(loaded, task, aim, along, figure, as_json, options)
        return
    with progressing() as progress:
        progress("finding the self-motions")
        found = find(
            loaded, aim, task, method=method, limits=limits, points=points, starts=starts, gamma=gamma, scale=scale
        )
        chosen = _best(loaded, found, best, limits)
        near = _near(loaded, found) if singular else None
        files = _draw(loaded, found, figure, animation, csv, points)
    if as_json:
        more = {"singular": near.to_dict() if near else None} if singular else {}
        print_json(found.to_dict() | {"best": chosen.to_dict() if chosen else None, **more, "files": files})
    else:
        _print(loaded, found, chosen, best)
        if near is not None:
            _say_near(loaded, near)
        if limits and found.feasible is None:
            say(f"{loaded.name} has no position limits.")
        for path in files:
            say(path)
    if found.status == "unreachable" or (best is not None and chosen is None):
        raise typer.Exit(1)


# ---- what is asked -----------------------------------------------------------------------------------------------


def _check_files(animation: Path | None, csv: Path | None) -> None:
    for path, suffix, what in ((animation, ".gif", "an animation"), (csv, ".csv", "a table of points")):
        if path is not None and path.suffix.lower() != suffix:
            raise InputError(f"{path}: {what} is written as {suffix}")


def _target(arm: Arm, task: str, target: str | None, at: str | None, along: str | None, deg: bool) -> Any:
    """The target of the options, as an array."""
    import math

    import numpy as np

    from chainrule.self_motions.held import target_of, target_shape

    shape = target_shape(arm, task)
    if target is not None and at is not None:
        raise InputError("one of --target and --at is accepted, not both")
    if at is not None:
        return target_of(arm, np.array(configuration(at, arm, deg, "--at")), task)
    if target is None:
        if along is None or shape == (4, 4):
            raise InputError("what is held is missing: one of --target and --at gives it")
        return np.zeros(shape)
    found = np.array(numbers(target, "--target", math.prod(shape))).reshape(shape)
    if task == "x_alpha" or (shape == (3,) and task == "pose"):
        found[-1] = angle(float(found[-1]), deg, "--target")
    return found


def _refuse_with_along(
    best: str | None,
    singular: bool,
    animation: Path | None,
    csv: Path | None,
    figure: Path | None,
    arm: Arm,
    task: str,
) -> None:
    for option, given in (("--best", best), ("--singular", singular), ("--animation", animation), ("--csv", csv)):
        if given:
            raise InputError(f"{option} is for one target, not for --along")
    if figure is not None and not (task in ("position", "x_alpha") and "x_alpha" in arm.tasks and arm.kinds == "RRR"):
        raise InputError("--figure with --along is for planar 3R arms, tasks position and x_alpha")


def _range(text: str) -> tuple[float, float, int]:
    """Two ends and a number of values."""
    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(f"--along: {shown(text)}; X0:X1:N is accepted")
    first, last = (numbers(part, "--along", 1)[0] for part in parts[:2])
    if not re.fullmatch(r"[0-9]{1,6}", parts[2].strip()) or int(parts[2]) < 2:
        raise InputError(f"--along: {shown(parts[2])} targets; a whole number of 2 or more is accepted")
    return first, last, int(parts[2])


# ---- one target --------------------------------------------------------------------------------------------------


def _best(arm: Arm, found: SelfMotion, criterion: str | None, limits: bool) -> BestPosture | None:
    from chainrule.self_motions.best import best_posture

    if criterion is None:
        return None
    if criterion not in ("manipulability", "limits"):
        raise InputError(f"--best: {shown(criterion)}; manipulability or limits is accepted")
    return best_posture(arm, found, criterion, limits=limits) if found.arcs else None


def _near(arm: Arm, found: SelfMotion) -> NearestSingular | None:
    from chainrule.self_motions.singular import nearest_singular

    return nearest_singular(arm, found) if found.components else None


def _say_near(arm: Arm, near: NearestSingular) -> None:
    from chainrule.tables import posture

    say(f"The least H at this target is {near.manipulability:.6g}.")
    if near.distance is None or near.q is None:
        say("No singular target was found near by.")
    else:
        say(f"A singular target is {near.distance:.6g} m away (others may be nearer), at {posture(arm, near.q)}")


def _draw(
    arm: Arm, found: SelfMotion, figure: Path | None, animation: Path | None, csv: Path | None, points: int
) -> list[str]:
    """The files asked for; their names."""
    from chainrule.derive.manifest import write_whole

    if figure is not None:
        from chainrule.plot.self_motion import draw_self_motion

        write_figure(draw_self_motion(arm, found), figure)
    if animation is not None:
        from chainrule.plot.self_motion import animation as moving

        if not found.components:
            raise InputError(f"{animation}: there is no curve to show at this target")
        write_whole(animation, moving(arm, found))
    if csv is not None:
        write_whole(csv, _points(arm, found, points).encode("ascii"))
    return [str(path) for path in (figure, animation, csv) if path is not None]


def _points(arm: Arm, found: SelfMotion, points: int) -> str:
    """Points of all curves, or of what limits leave of them (arcs, numbered too), as comma-separated values."""
    import numpy as np

    limited = found.feasible is not None
    lines = [",".join(["curve", *(["arc"] if limited else []), "s", *(f"q{j}" for j in range(1, arm.n + 1)), "H"])]
    for k, curve in enumerate(found.arcs):
        number = k if curve.of is None else curve.of
        label = [str(number + 1), str(k + 1)] if limited else [str(number + 1)]
        s = np.linspace(0.0, 1.0, points) if len(curve.q) > 1 else np.zeros(1)
        q = curve.at(s)
        h = arm.manipulability(q, task=found.task)
        for row in np.column_stack([s * curve.length, q, h]):
            lines.append(",".join([*label, *(repr(float(value)) for value in row)]))
    return "\n".join(lines) + "\n"


def _print(arm: Arm, found: SelfMotion, chosen: BestPosture | None, criterion: str | None) -> None:
    from chainrule.self_motions import words
    from chainrule.tables import posture

    say(f"{arm.name}, task {found.task}. {words.finding(found)}.")
    if found.count or found.complete != "proved":
        say(words.completeness(found))
    if found.to_singular is not None and found.status == "regular":
        say(f"The nearest singular target is {found.to_singular:.6g} m away.")
    if found.count:
        print_table(words.curves_table(arm, found))
    if found.feasible is not None and found.count:
        say(f"{words.limits_finding(found)}.")
        if found.feasible:
            print_table(words.arcs_table(arm, found))
    if chosen is not None:
        part = found.arcs[chosen.curve]
        curve = chosen.curve if part.of is None else part.of
        what = "largest H" if criterion == "manipulability" else "farthest from the limits"
        say(f"Best posture ({what}): {chosen.value:.9g} on curve {curve + 1}, {posture(arm, chosen.q)}")


# ---- along a line of targets -------------------------------------------------------------------------------------


def _along(
    arm: Arm, task: str, target: Any, text: str, figure: Path | None, as_json: bool, options: dict[str, Any]
) -> None:
    import numpy as np

    from chainrule.self_motions import words
    from chainrule.self_motions.along import self_motion_along

    first, last, count = _range(text)
    x = np.linspace(first, last, count)
    targets = np.repeat(target[np.newaxis], count, axis=0)
    targets[(slice(None), 0, 3) if target.shape == (4, 4) else (slice(None), 0)] = x
    with progressing() as progress:
        progress(f"finding the self-motions at {count} targets")
        found = self_motion_along(arm, targets, task, **options)
        if figure is not None:
            from chainrule.plot.self_motion import draw_lengths

            write_figure(draw_lengths(arm, task, float(target[1])), figure)
    if as_json:
        print_json({"arm": arm.name, "task": task, **found.to_dict()})
    else:
        say(f"{arm.name}, task {task}. {words.along_finding(found)}.")
        print_table(words.intervals_table(found, x))
        if found.changes:
            print_table(words.changes_table(found, x))
        if figure is not None:
            say(str(figure))
    if not found.count.all():
        raise typer.Exit(1)
