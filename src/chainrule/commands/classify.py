"""``chainrule classify``: whether an arm is cuspidal, with its cusps, nodes, aspects and a change of posture."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from chainrule.console import (
    Base,
    Json,
    Tip,
    app,
    load_arm,
    numbers,
    print_json,
    print_table,
    progressing,
    say,
    write_figure,
)
from chainrule.errors import InputError
from chainrule.outputs import figure_file, output_file

if TYPE_CHECKING:
    from chainrule.arm import Arm
    from chainrule.cuspidality.designs import Orthogonal3R, Regional3R
    from chainrule.readers.designs import DesignRows
    from chainrule.tables import Table

_NUMBERS = re.compile(r"[-+.0-9].*[\s,].*")


@app.command()
def classify(
    design: Annotated[
        str,
        typer.Argument(
            metavar="DESIGN",
            help="The lengths d2,d3,d4,r2 of an orthogonal 3R arm in m; a .csv file of many; or an arm as elsewhere.",
        ),
    ],
    exact: Annotated[
        bool, typer.Option("--exact", help="Take the lengths as they are written and decide by exact arithmetic.")
    ] = False,
    at: Annotated[
        str | None,
        typer.Option(metavar="RHO,Z", help="A point of the cross-section, in m: the postures that reach it."),
    ] = None,
    figure: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", callback=figure_file, help="Draw singular curves, cusps and postures (.svg, .png, .pdf)."
        ),
    ] = None,
    domains: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", callback=figure_file, help="Draw the family's design space with the design marked."
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE", callback=output_file, help="For a .csv file: write the answers here."
        ),
    ] = None,
    tries: Annotated[int, typer.Option(help="For six joints without a spherical wrist: poses to try.")] = 40,
    tip: Tip = None,
    base: Base = None,
    as_json: Json = False,
) -> None:
    """Tell whether an arm is cuspidal: whether it can change its posture without meeting a singularity.

    For orthogonal 3R arms the domain (1 to 5) and the topology of the workspace (cusps and nodes) as well. Six joints
    with a spherical wrist are decided by their first three; for other six-joint arms a change of posture is searched.
    A .csv file with columns d2, d3, d4, r2 may have any length; its rows come back with the answers added.

    Exits with 1 if a six-joint arm was searched and nothing was found.

    Example: chainrule classify 1,2,1.5,1 --figure design.svg
    """
    if design.lower().endswith(".csv"):
        if at or figure or domains:
            raise InputError("--at, --figure and --domains are for one design, not for a .csv file")
        _many(Path(design), output, exact, as_json)
        return
    if output is not None:
        raise InputError("-o is for a .csv file of designs; --figure draws one design")
    if _NUMBERS.fullmatch(design) and not Path(design).exists():
        _one(_lengths(design, exact), at, figure, domains, as_json)
        return
    _arm(design, tip, base, exact, at, figure, domains, tries, as_json)


def _lengths(text: str, exact: bool) -> Orthogonal3R:
    """The orthogonal arm of four numbers; with ``exact`` the lengths are the decimal numbers as written."""
    from chainrule.cuspidality.designs import orthogonal_3r

    found = numbers(text, "DESIGN", 4)
    words = re.split(r"\s*,\s*|\s+", text.strip())
    return orthogonal_3r(*(words if exact else found), exact=exact)


def _arm(
    name: str,
    tip: str | None,
    base: str | None,
    exact: bool,
    at: str | None,
    figure: Path | None,
    domains: Path | None,
    tries: int,
    as_json: bool,
) -> None:
    """An arm by name or file: three joints, six with a spherical wrist, or a search."""
    from chainrule.cuspidality.designs import regional_3r
    from chainrule.cuspidality.wrists import wrist

    arm = load_arm(name, tip, base)
    if exact:
        raise InputError("--exact is for lengths as they are written: d2,d3,d4,r2 or a .csv file of them")
    if arm.kinds == "RRRRRR" and not wrist(arm).spherical:
        if at or figure or domains:
            raise InputError(f"{arm.name}: {wrist(arm).words}; --at, --figure and --domains are for 3R arms")
        _search(arm, tries, as_json)
    else:
        _one(regional_3r(arm), at, figure, domains, as_json)


def _one(
    design: Orthogonal3R | Regional3R,
    at: str | None,
    figure: Path | None,
    domains: Path | None,
    as_json: bool,
) -> None:
    """One 3R arm."""
    from chainrule.cuspidality import tables

    lengths = design.regional.orthogonal
    if domains is not None and lengths is None:
        raise InputError("--domains: the design space is that of the orthogonal 3R arms, and this is none of them")
    point = None if at is None else numbers(at, "--at", 2)
    if point is not None and point[0] < 0.0:
        raise InputError(f"--at: rho = {point[0]:g}; a distance from axis 1, 0 or more, is accepted")
    with progressing() as progress:
        progress("looking for cusps and nodes")
        said = tables.verdict(design)
        example = design.example() if design.cuspidal else None
        change = None if example is None else design.posture_change(*example.postures)
        if figure is not None:
            from chainrule.plot.cuspidality import draw_design

            progress("drawing")
            write_figure(draw_design(design, change), figure)
        if domains is not None and lengths is not None:
            from chainrule.plot.design_space import draw_domains

            progress("drawing the design space")
            write_figure(draw_domains(lengths), domains)
    postures = None if point is None else design.postures(point[0], 0.0, point[1])
    if as_json:
        shown = design.to_dict()
        if change is not None:
            shown["posture_change"] = change.to_dict()
        if point is not None and postures is not None:
            shown["at"] = {"point": point, "postures": postures.tolist()}
        print_json(shown)
        return
    say(f"{design.name}. {said}")
    for line in design.words():
        say(line)
    if len(design.cusps()) or len(design.nodes()):
        print_table(tables.points_table(design))
    print_table(tables.aspects_table(design))
    if change is not None:
        say(tables.change_in_words(change))
    elif design.cuspidal:
        say(tables.NO_EXAMPLE)
    if point is not None and postures is not None:
        print_table(tables.postures_table(design, postures))
    for path in (figure, domains):
        if path is not None:
            say(str(path))


def _search(arm: Arm, tries: int, as_json: bool) -> None:
    """Six joints without a spherical wrist."""
    from chainrule.cuspidality.witness import posture_change_witness
    from chainrule.cuspidality.wrists import wrist

    with progressing() as progress:
        found = posture_change_witness(arm, tries=tries, progress=progress)
    if as_json:
        print_json({"name": arm.name, "wrist": wrist(arm).to_dict(), **found.to_dict()})
    else:
        say(f"{arm.name}. {wrist(arm).words}.")
        say(found.words)
    if not found.found:
        raise typer.Exit(1)


# ---- many designs ------------------------------------------------------------------------------------------------


def _many(path: Path, output: Path | None, exact: bool, as_json: bool) -> None:
    """A file of designs: its rows with the answers added, to a file or standard output, block by block."""
    import contextlib

    from chainrule.derive.manifest import whole_file
    from chainrule.readers.designs import read_designs

    if output is not None and output.suffix.lower() != ".csv":
        raise InputError(f"{output}: the designs are written as .csv")
    totals: dict[str, int] = {}
    with progressing() as progress, contextlib.ExitStack() as stack:
        stream = None if output is None else stack.enter_context(whole_file(output))
        done = 0
        for block in read_designs(path):
            rows = _answers(block, exact, totals)
            if done == 0:
                rows.insert(0, [*block.header, *ANSWERS])
            done += len(block.cells)
            if stream is not None:
                stream.write(_csv(rows).encode())
            elif not as_json:
                print(_csv(rows), end="")
            progress(f"{done:,} designs")
    if as_json:
        print_json({"designs": done, "domains": dict(sorted(totals.items())), "output": output and str(output)})
    elif output is not None:
        print_table(_totals(totals))
        say(str(output))


#: The columns added to a file of designs.
ANSWERS = ("domain", "cusps", "nodes", "cuspidal", "on")


def _answers(block: DesignRows, exact: bool, totals: dict[str, int]) -> list[list[str]]:
    """The rows of a block with the answers added; what lies on a surface has no domain, and says on which."""
    found = [_exactly(lengths) for lengths in block.lengths] if exact else _quickly(block)
    for answer in found:
        name = answer[0] or "none"
        totals[name] = totals.get(name, 0) + 1
    return [[*cells, *answer] for cells, answer in zip(block.cells, found, strict=True)]


def _quickly(block: DesignRows) -> list[list[str]]:
    """By the generated function, all rows at once; only the rows that it leaves open are decided exactly."""
    import numpy as np

    from chainrule.cuspidality.classify import classify_orthogonal_3r, topology_orthogonal_3r
    from chainrule.cuspidality.domains import CUSPS, TOPOLOGIES

    lengths = np.array([[float(text) for text in row] for row in block.lengths]).reshape(-1, 4)
    domains, topologies = classify_orthogonal_3r(*lengths.T), topology_orthogonal_3r(*lengths.T)
    known = {
        (number, topology): [str(number), str(CUSPS[number - 1]), str(nodes), "yes" if CUSPS[number - 1] else "no", ""]
        for topology, (_, nodes) in TOPOLOGIES.items()
        for number in range(1, 6)
    }
    pairs = zip(domains.tolist(), topologies.tolist(), block.lengths, strict=True)
    return [known.get((number, topology)) or _exactly(row) for number, topology, row in pairs]


def _exactly(lengths: tuple[str, str, str, str]) -> list[str]:
    """By exact arithmetic, for the lengths as they are written."""
    from chainrule.cuspidality.domains import exact_domain

    found = exact_domain(*lengths)
    cuspidal = {True: "yes", False: "no", None: ""}[found.cuspidal]
    where = found.degenerate or " ".join(found.surfaces)
    numbers = [found.number, found.cusps, found.nodes]
    return [*("" if number is None else str(number) for number in numbers), cuspidal, where]


def _csv(rows: list[list[str]]) -> str:
    import csv
    import io

    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def _totals(totals: dict[str, int]) -> Table:
    from chainrule.tables import Column, Table

    columns = (Column("domain", "domain"), Column("designs", "designs"))
    return Table("Designs in each domain", columns, tuple((name, n) for name, n in sorted(totals.items())))
