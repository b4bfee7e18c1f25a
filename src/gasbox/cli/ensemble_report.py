"""What an ensemble came to, for people as a table and for programs as JSON or CSV."""

from __future__ import annotations

import csv
import dataclasses
import json
import math
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from gasbox.cli.ensemble_run import Outcome
from gasbox.cli.outputs import check_place
from gasbox.cli.report import finite, meaning
from gasbox.errors import FileError, UsageError
from gasbox.sweep import Plan, spread
from gasbox.version import __version__

__all__ = ["WORLD", "check_data", "headline", "is_main", "print_ensemble", "report", "write_data"]

WORLD: Final = "world."
"""Before the names of numbers that a world gives."""
_ENDINGS = (".csv", ".json")
_ALIKE = 1e-9
"""A relative spread below it is rounding."""


def check_data(path: Path) -> None:
    """Refuse a file of numbers that could not be written.

    Raises
    ------
    FileError, UsageError
    """
    if path.suffix not in _ENDINGS:
        raise UsageError(f"--data {path}: numbers go to a file that ends in {' or '.join(_ENDINGS)}")
    check_place(path)


def report(plan: Plan, outcome: Outcome) -> dict[str, Any]:
    """What `gasbox ensemble --json` prints."""
    found = outcome.found
    series = {name: _over_time(values) for name, values in found.series.items()}
    return {
        "title": plan.scenario.title,
        "wanted": outcome.wanted,
        "runs": int(found.seeds.size),
        "interrupted": outcome.interrupted,
        "failures": [{"seed": each.seed, "reason": each.reason} for each in outcome.failures],
        "start": float(plan.times[0]),
        "until": float(plan.times[-1]),
        "statistics": {name: dataclasses.asdict(spread(values)) for name, values in found.values.items()},
        "seeds": found.seeds.tolist(),
        "values": {name: values.tolist() for name, values in found.values.items()},
        **({"series": {"time": plan.times.tolist(), **series}} if series else {}),
        "wall_seconds": outcome.wall_seconds,
        "version": __version__,
    }


def _over_time(values: NDArray[np.float64]) -> dict[str, list[float]]:
    each = [spread(column) for column in values.T]
    return {name: [getattr(one, name) for one in each] for name in ("mean", "low", "median", "high")}


def write_data(path: Path, plan: Plan, outcome: Outcome) -> None:
    """Write the numbers of all runs: as rows of a table, or what `report` gives.

    Raises
    ------
    FileError
        The file cannot be written.
    """
    try:
        with path.open("w", encoding="utf-8", newline="") as file:
            if path.suffix == ".json":
                json.dump(finite(report(plan, outcome)), file, allow_nan=False, indent=1, ensure_ascii=False)
                file.write("\n")
                return
            values = outcome.found.values
            writer = csv.writer(file)
            writer.writerow(["seed", *values])
            for row, seed in enumerate(outcome.found.seeds.tolist()):
                writer.writerow([seed, *(_cell(float(column[row])) for column in values.values())])
    except OSError as error:
        raise FileError(f"cannot write {path}: {error.strerror or error}") from None


def headline(plan: Plan, outcome: Outcome) -> str:
    """The title of the scenario, and how many runs there are."""
    count = outcome.found.seeds.size
    runs = f"{count} run{'' if count == 1 else 's'} up to time {plan.times[-1]:g}"
    return f"{plan.scenario.title}\n{runs}" if plan.scenario.title else runs


def _cell(value: float) -> str:
    """In full; empty where there is no value."""
    return f"{value!r}" if math.isfinite(value) else ""


def is_main(name: str) -> bool:
    """Whether a number is one of the whole gas or of its world; the others are for programs."""
    return "." not in name or name.startswith(WORLD)


def print_ensemble(plan: Plan, outcome: Outcome) -> None:
    """Print a table of the main numbers: mean, spread and quantiles, and in a line below those that never differ."""
    found = outcome.found
    table = Table(title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    table.add_column("", overflow="fold", min_width=18)
    for column in ("mean ± its error", "std dev", "5 %", "50 %", "95 %"):
        table.add_column(column, justify="right", no_wrap=True)
    table.title = escape(f"{headline(plan, outcome)}, in {outcome.wall_seconds:.3g} s")
    alike = []
    # First what a world says; beside it, the gas says little.
    for name in sorted(filter(is_main, found.values), key=lambda name: not name.startswith(WORLD)):
        values = found.values[name]
        told = spread(values)
        if not told.runs:
            continue
        words, unit = meaning(name.removeprefix(WORLD))
        if told.greatest - told.least <= _ALIKE * max(abs(told.least), abs(told.greatest)):
            alike.append(f"{words} {told.mean:g}")
            continue
        words += "" if told.runs == found.seeds.size else f" ({told.runs} runs)"
        words += f"\n[{unit}]" if unit else ""
        error = f"{told.mean:.5g} ± {told.standard_error:.2g}"
        quantiles = (f"{value:.4g}" for value in (told.low, told.median, told.high))
        table.add_row(escape(words), error, f"{told.standard_deviation:.3g}", *quantiles)
    console = Console(highlight=False)
    console.print(table if table.row_count else table.title)
    if alike:
        console.print(f"the same in all runs: {escape(', '.join(alike))}", soft_wrap=True)
