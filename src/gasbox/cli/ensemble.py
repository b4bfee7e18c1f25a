"""`gasbox ensemble`: one scenario with many seeds on all cores."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gasbox.cli import options

if TYPE_CHECKING:
    from gasbox.cli.ensemble_run import Outcome
    from gasbox.sweep import Plan

__all__ = ["ensemble"]

_INTERRUPTED = 130


def ensemble(
    scenario: options.ScenarioName,
    seeds: Annotated[int, typer.Option("--seeds", min=1, metavar="N", help="How many runs.")] = 100,
    first_seed: Annotated[
        int,
        typer.Option("--first-seed", min=0, metavar="N", help="Seed of the first run; the others follow."),
    ] = 1,
    until: options.Until = None,
    frames: options.Frames = None,
    settings: options.Settings = None,
    workers: options.Workers = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE.png", help="Figure to write: .png, .svg or .pdf."),
    ] = None,
    data: Annotated[
        Path | None,
        typer.Option(
            "--data", metavar="FILE", help="Write the numbers of each run: .csv (one row each) or .json."
        ),
    ] = None,
    json: options.Json = False,
) -> None:
    """Run a scenario with many seeds on all cores, and tell how its numbers are spread."""
    from gasbox.cli.ensemble_report import check_data, print_ensemble, report, write_data
    from gasbox.cli.ensemble_run import prepare, travel_all
    from gasbox.cli.outputs import check_figure
    from gasbox.cli.report import print_json

    if output is not None:
        check_figure(output)
    if data is not None:
        check_data(data)
    plan = prepare(scenario, settings or [], seeds, first_seed, until, frames)
    outcome = travel_all(plan, range(first_seed, first_seed + seeds), workers)
    if outcome.found.seeds.size:
        if data is not None:
            write_data(data, plan, outcome)
        if output is not None:
            _draw(output, plan, outcome)
        if json:
            print_json(report(plan, outcome))
        else:
            print_ensemble(plan, outcome)
            for what, path in (("figure", output), ("numbers", data)):
                if path is not None:
                    print(f"{what} in {path}")
    if outcome.interrupted:
        raise typer.Exit(_INTERRUPTED)
    if outcome.failures:
        raise typer.Exit(1)


def _draw(output: Path, plan: Plan, outcome: Outcome) -> None:
    from gasbox.cli.ensemble_figure import figure_of
    from gasbox.errors import FileError

    try:
        figure_of(plan, outcome).savefig(output, dpi=150)
    except OSError as error:
        raise FileError(f"cannot write {output}: {error.strerror or error}") from None
