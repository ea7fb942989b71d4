"""``chainrule track``: a path followed by an arm with joints to spare, by one method or by several compared."""

from __future__ import annotations

import math
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer

from chainrule.console import (
    ArmName,
    Base,
    Json,
    Task,
    Tip,
    angle,
    app,
    bounds,
    complain,
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
    from collections.abc import Callable

    from chainrule.arm import Arm
    from chainrule.redundancy.asked import Secondary
    from chainrule.redundancy.globally import Between
    from chainrule.redundancy.result import Run
    from chainrule.redundancy.step import Damping
    from chainrule.redundancy.task_path import TaskPath

#: Paths known by name, of Sanchez's thesis, and a start posture for the thesis' arm on each.
NAMED = {"sanchez-arc": ("arc", "A"), "sanchez-ellipse": ("ellipse", "E"), "sanchez-line": ("line", "L")}
#: What can be asked for by --method and --compare.
METHODS = ("pseudoinverse", "damped", "gradient_projection", "priority", "limited", "global")
#: Those that know no gain.
GAINLESS = ("pseudoinverse", "damped")


@app.command()
def track(
    arm: ArmName,
    path: Annotated[
        str | None,
        typer.Option(
            metavar="FILE|NAME",
            help="A .toml file (kind = line, arc, circle, ...), poses in a .csv file, or sanchez-arc, sanchez-ellipse, "
            "sanchez-line.",
        ),
    ] = None,
    circle: Annotated[
        float | None,
        typer.Option(metavar="RADIUS", help="Instead: a level circle through the tip of the start posture, m."),
    ] = None,
    line: Annotated[
        str | None,
        typer.Option(metavar="DX,DY[,DZ]", help="Instead: a line from the tip of the start posture, m."),
    ] = None,
    duration: Annotated[
        float | None,
        typer.Option(
            help="With --circle and --line: s from rest to rest, 2 when left out. With poses without times: s in all."
        ),
    ] = None,
    start: Annotated[
        str | None,
        typer.Option(
            metavar="Q|NAME",
            help="The start posture: joint values, best, followable, or A, B, C, E, L of Sanchez's arm.",
        ),
    ] = None,
    task: Task = None,
    method: Annotated[
        str, typer.Option(help=f"How the joints to spare are used: {', '.join(METHODS)}.")
    ] = "gradient_projection",
    gain: Annotated[
        float | None,
        typer.Option(help="Gain of the criterion: -2, or 2 for H, when left out. Negative gains lower it."),
    ] = None,
    criterion: Annotated[str, typer.Option(help="H, 1/H, H^(-1/2) or limits.")] = "H^(-1/2)",
    damping: Annotated[
        str | None,
        typer.Option(
            metavar="KIND,MU[,AT]",
            help="Damping near singularities: constant,MU; nakamura,MU,H or chiaverini,MU,S where H, or the least "
            "singular value, falls below it. With --compare that of 'damped'.",
        ),
    ] = None,
    weights: Annotated[
        str | None,
        typer.Option(metavar="W,W,..", help="What each joint's motion costs; inf for one that stands still."),
    ] = None,
    secondary: Annotated[
        str | None,
        typer.Option(
            metavar="Q=V[,Q=V..]",
            help="For --method priority: joints led to values as far as the path allows, such as q3=0.5.",
        ),
    ] = None,
    feedback: Annotated[
        float | None, typer.Option(help="Feedback of the tip's error, 1/s; half of it in a step when left out.")
    ] = None,
    integrator: Annotated[str, typer.Option(help="euler, heun, rk4 or dop853.")] = "euler",
    dt: Annotated[float | None, typer.Option(help="Step, s; a 300th of the path's time when left out.")] = None,
    limits: Annotated[
        bool,
        typer.Option(
            "--limits", help="Within the arm's limits: --method limited, which slows down if need be, or global."
        ),
    ] = False,
    velocity: Annotated[
        str | None, typer.Option(metavar="V[,V..]", help="Velocity limits, one number or one for each joint.")
    ] = None,
    acceleration: Annotated[
        str | None, typer.Option(metavar="A[,A..]", help="Acceleration limits, one number or one for each joint.")
    ] = None,
    fastest: Annotated[
        bool, typer.Option("--fastest", help="Then pass the same postures in the least time, within both limits.")
    ] = False,
    compare: Annotated[
        str | None, typer.Option(metavar="all|M,M,..", help="Several methods in one table and one figure.")
    ] = None,
    forecast: Annotated[
        bool, typer.Option("--forecast", help="Only say beforehand whether the local law will follow the path.")
    ] = False,
    tolerance: Annotated[
        float | None,
        typer.Option(
            help="Exit with 1 if the tip is farther than this from the path, m; a 100th of its extent if left out."
        ),
    ] = None,
    figure: Annotated[
        Path | None, typer.Option(metavar="FILE", callback=figure_file, help="Draw it into a .svg, .png or .pdf file.")
    ] = None,
    csv: Annotated[
        Path | None,
        typer.Option(
            "--csv",
            metavar="FILE",
            callback=output_file,
            help="Every sample: time, joints, rates, torques, errors.",
        ),
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Angles given are degrees.")] = False,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Follow a path with an arm that has joints to spare: how near to singularities, how fast, how exactly.

    Exits with 1 if the end of the path is not reached, or the path is left (with --compare: by all methods; with
    --forecast: probably).

    Example: chainrule track sanchez_8r --path sanchez-arc --gain -2 --figure track.svg
    """
    loaded = _limited(load_arm(arm, tip, base), velocity, acceleration, deg)
    _check(csv, compare, forecast, duration, path, tolerance)
    second = None if secondary is None else _secondary(loaded, secondary, deg)
    if (limits or method == "limited") and not _any_limits(loaded):
        raise InputError(f"{loaded.name} has no limits to keep; --velocity and --acceleration give some")
    if limits and method == "gradient_projection":
        method = "limited"
    chosen = _methods(loaded, compare, method, limits, damping is not None, second is not None)
    task = loaded.task_of_full_rank(task)
    desired, posture = _path(loaded, task, path, circle, line, duration, start, deg)
    if desired.turning is None and task != "position" and isinstance(posture, str) and posture == "best":
        raise InputError(
            f"--start: 'best' needs a path that says the orientation, which the task '{task}' holds; joint values or "
            "followable are accepted"
        )
    options: dict[str, Any] = {
        "task": task,
        "criterion": criterion,
        "feedback": feedback,
        "dt": dt,
        "integrator": integrator,
        "damping": None if damping is None else _damping(damping),
        "weights": None if weights is None else _weights(weights),
    }
    if limits and method not in ("limited", "global"):
        raise InputError(f"--limits: '{method}' does not keep them; limited and global do")
    if chosen[0] in GAINLESS and len(chosen) == 1 and gain is not None:
        raise InputError(f"--gain: '{method}' has none; gradient_projection and limited take one")
    if chosen == ("global",) and (damping is not None or weights is not None):
        raise InputError("--damping and --weights are for local laws, not for global")
    _wonder(gain, criterion)
    if forecast:
        _forecast(loaded, desired, posture, gain, options, as_json)
        return
    with progressing() as progress:
        posture = _settled(loaded, desired, posture, gain, options, chosen)
        found = {}
        for name in chosen:
            own = options | ({"integrator": "euler"} if name == "limited" and compare is not None else {})
            if compare is not None and name != "damped":
                own["damping"] = None
            if name == "priority":
                own["secondary"] = second
            found[name] = _followed(loaded, desired, posture, name, gain, own, limits, progress)
        if fastest:
            progress("finding the least time")
            from chainrule.redundancy.fastest import fastest_run

            found = {name: (fastest_run(run, desired), cost, note) for name, (run, cost, note) in found.items()}
    runs = {_name(name, run): run for name, (run, _, _) in found.items()}
    costs = [cost for _, cost, _ in found.values()]
    files = _files(runs, compare is not None, figure, csv)
    if as_json:
        _print_json(loaded, desired, runs, costs, compare is not None, files)
    else:
        _print(runs, costs, [note for _, _, note in found.values()], compare is not None)
        for written in files:
            say(written)
    if not any(_good(run, tolerance) for run in runs.values()):
        if tolerance is not None and any(run.status == "complete" for run in runs.values()):
            complain(f"the tip is farther than {tolerance:g} m from its target, which --tolerance allows")
        raise typer.Exit(1)


# ---- what is asked -----------------------------------------------------------------------------------------------


def _check(
    csv: Path | None,
    compare: str | None,
    forecast: bool,
    duration: float | None,
    path: str | None,
    tolerance: float | None,
) -> None:
    if csv is not None and csv.suffix.lower() != ".csv":
        raise InputError(f"{csv}: a table of samples is written as .csv")
    if compare is not None and (csv is not None or forecast):
        raise InputError(f"{'--csv' if csv is not None else '--forecast'} is for one method, not for --compare")
    if duration is not None and path in NAMED:
        raise InputError(f"--duration: the path '{path}' has its own time")
    if tolerance is not None and not tolerance > 0.0:
        raise InputError(f"--tolerance: {tolerance:g} m; a positive length is accepted")


def _limited(arm: Arm, velocity: str | None, acceleration: str | None, deg: bool) -> Arm:
    """The arm with the limits that were given."""
    given: dict[str, Any] = {}
    for name, text in (("velocity", velocity), ("acceleration", acceleration)):
        if text is not None:
            given[name] = bounds(text, arm, deg, f"--{name}")
    return arm.with_limits(**given) if given else arm


def _damping(text: str) -> Damping:
    """KIND,MU or KIND,MU,THRESHOLD."""
    from chainrule.redundancy.step import KINDS, Damping

    kind, _, rest = text.partition(",")
    if kind not in KINDS[1:]:
        raise InputError(f"--damping: {shown(kind)}; {', '.join(KINDS[1:])} are accepted")
    return Damping(cast("Any", kind), *numbers(rest, "--damping", 1 if kind == "constant" else 2))


def _weights(text: str) -> list[float]:
    """Numbers, or inf."""
    parts = [part.strip() for part in text.split(",")]
    return [math.inf if part == "inf" else numbers(part, "--weights", 1)[0] for part in parts]


def _secondary(arm: Arm, text: str, deg: bool) -> Secondary:
    """Joints and their values."""
    from chainrule.redundancy.secondary import joints_towards

    values: dict[str, float] = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals or name in values:
            raise InputError(f"--secondary: {shown(part)}; joints and their values are accepted, such as q3=0.5,q5=0")
        found = numbers(value, f"--secondary, {name}", 1)[0]
        slides = any(kind == "P" for j, kind in enumerate(arm.kinds) if name in (arm.joint_names[j], f"q{j + 1}"))
        values[name] = found if slides else angle(found, deg, f"--secondary, {name}")
    return joints_towards(arm, values)


def _methods(arm: Arm, compare: str | None, method: str, limits: bool, damped: bool, second: bool) -> tuple[str, ...]:
    """The methods to run, by name."""
    names: tuple[str, ...]
    if compare is None:
        names = (method,)
    elif limits:
        raise InputError("--limits is for one method; --compare takes 'limited' among its methods")
    else:
        possible = {"limited": _any_limits(arm), "damped": damped, "priority": second}
        every = tuple(name for name in METHODS if possible.get(name, True))
        names = every if compare == "all" else tuple(dict.fromkeys(part.strip() for part in compare.split(",")))
    for name in names:
        if name not in METHODS:
            what = "--method" if compare is None else "--compare"
            raise InputError(f"{what}: {shown(name)}; {', '.join(METHODS)} are accepted")
    if "damped" in names and not damped:
        raise InputError("--damping is needed for 'damped', such as nakamura,0.05,0.01")
    if ("priority" in names) != second:
        raise InputError("--secondary and the method 'priority' come together, such as --secondary q3=0.5")
    if damped and compare is not None and "damped" not in names:
        raise InputError("--damping: with --compare it is that of 'damped', which is not among the methods")
    return names


def _wonder(gain: float | None, criterion: str) -> None:
    """Tell of a gain that leads to what its criterion is to keep the arm away from."""
    from chainrule.redundancy.asked import default_gain

    if gain is not None and -math.inf < gain * default_gain(criterion) < 0.0:
        towards = "the middles of the joints' ranges are left" if criterion == "limits" else "singularities are sought"
        complain(f"note: --gain {gain:g} {'raises' if gain > 0.0 else 'lowers'} {criterion}, so that {towards}")


def _any_limits(arm: Arm) -> bool:
    limits = arm.limits
    return any(bool(abs(each).min() < float("inf")) for each in (limits.position, limits.velocity, limits.acceleration))


def _path(
    arm: Arm,
    task: str,
    path: str | None,
    circle: float | None,
    line: str | None,
    duration: float | None,
    start: str | None,
    deg: bool,
) -> tuple[TaskPath, Any]:
    """The one path that was given, and the start posture or how it is found."""
    from chainrule.papers import sanchez_paths as sanchez
    from chainrule.redundancy.path_files import read_task_path
    from chainrule.redundancy.samples import circle_through, good_posture, line_from

    if (path is not None) + (circle is not None) + (line is not None) != 1:
        raise InputError("one of --path, --circle and --line is needed, and only one")
    if start is not None and start in sanchez.STARTS:
        if arm.name != "sanchez_8r":
            raise InputError(f"--start: {shown(start)} is a posture of sanchez_8r; {arm.n} joint values are accepted")
        posture: Any = sanchez.STARTS[start]
    elif start in ("best", "followable"):
        posture = start
    elif start is not None and start.isalpha():
        named = f", or {', '.join(sanchez.STARTS)}" if arm.name == "sanchez_8r" else ""
        raise InputError(f"--start: {shown(start)}; {arm.n} joint values, best or followable{named} are accepted")
    else:
        posture = None if start is None else configuration(start, arm, deg, "--start")
    if path is not None:
        if path not in NAMED:
            if not path.lower().endswith((".toml", ".csv")):
                raise InputError(f"--path: {shown(path)}; a .toml or .csv file, or {', '.join(NAMED)} is accepted")
            return read_task_path(path, **({} if duration is None else {"duration": duration})), posture
        kind, own = NAMED[path]
        if posture is None and arm.name == "sanchez_8r":
            posture = sanchez.STARTS[own]
        return sanchez.PATHS[kind](), posture
    if isinstance(posture, str):
        raise InputError(
            f"--start: '{posture}' needs a --path; {arm.n} joint values are accepted for --circle and --line"
        )
    posture = good_posture(arm, task) if posture is None else posture
    duration = 2.0 if duration is None else duration
    if circle is not None:
        return circle_through(arm, posture, circle, duration), posture
    assert line is not None
    return line_from(arm, posture, numbers(line, "--line"), duration), posture


def _settled(
    arm: Arm, path: TaskPath, posture: Any, gain: float | None, options: dict[str, Any], chosen: tuple[str, ...]
) -> Any:
    """One start posture for all methods, found once where it is not given."""
    from chainrule.redundancy.track import track as follow

    if len(chosen) == 1 and chosen != ("global",) and (posture is None or isinstance(posture, str)):
        return posture
    if posture is None or isinstance(posture, str):
        return follow(arm, path, posture, gain=gain, **options).q[0]
    return posture


# ---- runs --------------------------------------------------------------------------------------------------------


def _followed(
    arm: Arm,
    path: TaskPath,
    posture: Any,
    name: str,
    gain: float | None,
    options: dict[str, Any],
    limits: bool,
    progress: Callable[[str], None],
) -> tuple[Run, float, str]:
    """A run by one method, what a step of it cost (s), and what else is to be said of it."""
    from chainrule.redundancy.track import track as follow

    progress(f"following the path: {name.replace('_', ' ')}")
    if name == "global":
        from chainrule.redundancy.globally import track_globally

        own = {key: options[key] for key in ("task", "dt")}
        begun = perf_counter()
        found = track_globally(arm, path, posture, limits=limits, progress=progress, **own)
        cost = (perf_counter() - begun) / max(len(found.run.t) - 1, 1)
        off = "" if found.between is None else _between(found.between)
        return found.run, cost, found.text + off
    kind = "pseudoinverse" if name in GAINLESS else "priority" if name == "priority" else "gradient_projection"
    more = {**options, "method": kind}
    if name not in GAINLESS:
        more["gain"] = gain
    if name == "limited":
        more["limits"] = True
    run, cost = None, float("inf")
    for _ in range(2):  # the first call may have to load what it needs
        begun = perf_counter()
        run = follow(arm, path, posture, **more)
        cost = min(cost, (perf_counter() - begun) / max(len(run.t) - 1, 1))
    assert run is not None
    return run, cost, ""


def _between(between: Between) -> str:
    from chainrule.redundancy.words import rounded

    return f"; between the samples the tip is up to {rounded(1000.0 * between.position, 3):g} mm off its target"


def _name(method: str, run: Run) -> str:
    from chainrule.redundancy.words import method_name

    more = {"limited": ", within the limits", "damped": ", damped"}
    return method_name(run) + more.get(method, "")


def _good(run: Run, tolerance: float | None) -> bool:
    from chainrule.redundancy.words import left_at

    if run.status != "complete":
        return False
    return left_at(run) is None if tolerance is None else run.worst_position_error <= tolerance


def _forecast(
    arm: Arm, path: TaskPath, posture: Any, gain: float | None, options: dict[str, Any], as_json: bool
) -> None:
    from chainrule.redundancy.asked import default_gain
    from chainrule.redundancy.batch import forecast
    from chainrule.redundancy.track import track as follow

    if options["integrator"] == "dop853":
        raise InputError("--integrator: 'dop853' has no forecast; euler, heun or rk4 is accepted")
    with progressing() as progress:
        progress("following the path with several gains")
        if posture is None or isinstance(posture, str):
            posture = follow(arm, path, posture, gain=gain, **options).q[0]
        told = forecast(arm, path, posture, default_gain(options["criterion"]) if gain is None else gain, **options)
    if as_json:
        print_json({"arm": arm.name, "path": path.to_dict(), "forecast": told.to_dict()})
    else:
        say(f"{arm.name}: {told.text}.")
    if not told.good:
        raise typer.Exit(1)


# ---- what comes out ----------------------------------------------------------------------------------------------


def _files(runs: dict[str, Run], several: bool, figure: Path | None, csv: Path | None) -> list[str]:
    """The files asked for; their names."""
    from chainrule.derive.manifest import write_whole

    first = next(iter(runs.values()))
    if figure is not None:
        from chainrule.plot.redundancy import draw_run, draw_runs

        write_figure(draw_runs(runs) if several else draw_run(first), figure)
    if csv is not None:
        headings, rows = first.rows()
        lines = [",".join(headings), *(",".join(repr(float(value)) for value in row) for row in rows)]
        write_whole(csv, ("\n".join(lines) + "\n").encode("ascii"))
    return [str(path) for path in (figure, csv) if path is not None]


def _print_json(
    arm: Arm, path: TaskPath, runs: dict[str, Run], costs: list[float], several: bool, files: list[str]
) -> None:
    told = [{"step_cost": cost, **run.to_dict()} for run, cost in zip(runs.values(), costs, strict=True)]
    content = {"runs": told} if several else {"run": told[0]}
    print_json({"arm": arm.name, "path": path.to_dict(), **content, "files": files})


def _print(runs: dict[str, Run], costs: list[float], notes: list[str], several: bool) -> None:
    from chainrule.redundancy import words

    if several:
        say(f"{words.comparison_finding(runs)}.")
    else:
        (run,) = runs.values()
        say(f"{words.finding(run)}.")
        say(f"{words.setup(run)}.")
    print_table(words.comparison_table(runs, costs))
    first = next(iter(runs.values()))
    if first.torque is not None:
        say(f"Torques rest on {words.masses(first.arm)}.")
    for name, run in runs.items():
        if run.events and not several:
            print_table(words.events_table(run))
        elif run.status != "complete":
            say(f"{name}: {run.reason}.")
    for note in filter(None, notes):
        say(note)
