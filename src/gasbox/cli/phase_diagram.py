"""`gasbox phase-diagram`: temperature and density swept on all cores."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gasbox.cli import options

if TYPE_CHECKING:
    from gasbox.sweep import Diary, Recipe

__all__ = ["phase_diagram"]

_INTERRUPTED = 130


def phase_diagram(
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE.png", help="Figure to write: .png, .svg or .pdf."),
    ] = None,
    data: Annotated[
        Path,
        typer.Option(
            "--data",
            metavar="FILE.json",
            help="Keeps each point; points that it holds already are not run again.",
        ),
    ] = Path("phase-diagram.json"),
    points: Annotated[
        str | None,
        typer.Option(
            "--points", metavar="ROWSxCOLUMNS", help="Temperatures and densities [15x16; quick: 9x8]."
        ),
    ] = None,
    particles: Annotated[
        int | None,
        typer.Option("--particles", min=20, metavar="N", help="Discs at each point [500; quick: 200]."),
    ] = None,
    cutoff: Annotated[
        float | None,
        typer.Option(
            "--cutoff", min=1.2, max=10.0, metavar="LENGTH", help="Of the forces, in units of sigma [2.5]."
        ),
    ] = None,
    seed: Annotated[int | None, typer.Option("--seed", min=0, metavar="N", help="Of all points [1].")] = None,
    workers: options.Workers = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="A rough one: fewer points, discs and steps.")
    ] = False,
    json: Annotated[bool, typer.Option("--json", help="Print all points as one JSON object.")] = False,
) -> None:
    """Find out what Lennard-Jones discs are at many temperatures and densities, and draw the diagram.

    It can be interrupted and started again: what was found stands in the data file.
    """
    from dataclasses import asdict, replace

    from gasbox.cli.outputs import check_figure
    from gasbox.sweep import FULL, QUICK, Diary, grid_points

    if output is not None:
        check_figure(output)
    usual = QUICK if quick else FULL
    recipe = replace(
        usual,
        particles=usual.particles if particles is None else particles,
        cutoff=usual.cutoff if cutoff is None else cutoff,
        seed=usual.seed if seed is None else seed,
    )
    wanted = grid_points(*_rows_and_columns(points or ("9x8" if quick else "15x16")))
    diary = Diary(data, recipe)
    if diary.missing(wanted):
        _fill(diary, wanted, workers)
    if output is not None:
        _draw(diary, output)
    if json:
        from gasbox.cli.report import print_json

        print_json({"recipe": asdict(recipe), "points": [asdict(one) for one in diary.points]})
        return
    _print(diary, output)


def _rows_and_columns(text: str) -> tuple[int, int]:
    from gasbox.errors import UsageError

    parts = text.lower().split("x")
    if len(parts) != 2 or not all(part.isdecimal() and 2 <= int(part) <= 500 for part in parts):
        raise UsageError(f'--points is "{text}"; it must be rows x columns, as in 15x16, each 2 to 500')
    return int(parts[0]), int(parts[1])


def _fill(diary: Diary, wanted: list[tuple[float, float]], workers: int | None) -> None:
    """Run what is missing; what is done stays, also after Ctrl-C."""
    import sys
    from contextlib import closing

    from gasbox.cli.progress import Progress, compile_first
    from gasbox.dynamics.team import processors
    from gasbox.sweep import measured

    compile_first()
    missing = diary.missing(wanted)
    done = len(wanted) - len(missing)
    try:
        with (
            Progress(0, len(wanted), "point") as progress,
            closing(measured(missing, diary.recipe, workers or processors())) as found,
        ):
            progress.show(done)
            for point in found:
                diary.add(point)
                done += 1
                progress.show(done)
    except KeyboardInterrupt:
        kept = f"{done} of {len(wanted)} points are in {diary.path}; the same command goes on from there."
        print(f"Interrupted: {kept}", file=sys.stderr)
        raise typer.Exit(_INTERRUPTED) from None


def _draw(diary: Diary, output: Path) -> None:
    from gasbox.errors import FileError
    from gasbox.plots import phase_diagram_figure

    found = diary.points
    figure = phase_diagram_figure(
        [one.temperature for one in found],
        [one.density for one in found],
        [one.matter for one in found],
        diary.recipe.cutoff,
        _caption(diary.recipe),
    )
    try:
        figure.savefig(output, dpi=150)
    except OSError as error:
        raise FileError(f"cannot write {output}: {error.strerror or error}") from None


def _caption(recipe: Recipe) -> str:
    return f"{recipe.particles} discs at each point, forces up to {recipe.cutoff:g} sigma, shifted"


def _print(diary: Diary, output: Path | None) -> None:
    from collections import Counter

    from rich.console import Console
    from rich.table import Table

    from gasbox.sweep import MATTERS

    counts = Counter(one.matter for one in diary.points)
    table = Table("what", "points", title=_caption(diary.recipe), title_justify="left")
    for matter in MATTERS:
        if counts[matter]:
            table.add_row(matter, f"{counts[matter]}")
    Console(highlight=False).print(table)
    print(f"points in {diary.path}")
    if output is not None:
        print(f"figure in {output}")
