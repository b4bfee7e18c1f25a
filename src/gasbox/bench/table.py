"""Shows measured rates as one table."""

from __future__ import annotations

from collections.abc import Sequence

from rich.box import SIMPLE
from rich.console import Console
from rich.table import Table

from gasbox.bench.contest import Result
from gasbox.bench.results import Earlier, machine

__all__ = ["print_table"]

_WIDTH = 110


def print_table(
    results: Sequence[Result], earlier: Earlier | None = None, missing: Sequence[str] = ()
) -> None:
    """Million units a second (median and range), ratio to the first program of the task, change since `earlier`.

    Parameters
    ----------
    missing : packages of peers that are not installed, or do not start
    """
    columns = ["gas", "discs", "program", "million/s", "range", "ratio"] + ["moved"] * (earlier is not None)
    table = Table(*columns, box=SIMPLE)
    for column in table.columns:
        column.no_wrap = True
        column.justify = "left" if column.header in ("gas", "program") else "right"
    ordered = sorted(results, key=lambda result: result.task)
    for before, result in zip([None, *ordered], ordered, strict=False):
        if before is not None and (result.task, result.particles) != (before.task, before.particles):
            table.add_section()
        table.add_row(*_cells(result), *([] if earlier is None else [_moved(earlier.moved(result))]))
    # Wide enough that nothing is cut off where the output is no terminal.
    Console(highlight=False, width=max(Console().width, _WIDTH)).print(table)
    print("\n".join(_notes(ordered, earlier, missing)))


def _cells(result: Result) -> list[str]:
    low, high = min(result.rates), max(result.rates)
    return [
        result.task,
        f"{result.particles:,}",
        result.program,
        f"{result.median / 1e6:.3g}",
        f"{low / 1e6:.3g}-{high / 1e6:.3g}",
        f"{result.ratio:.2f}",
    ]


def _moved(share: float | None) -> str:
    return "new" if share is None else f"{100 * share:+.0f} %"


def _notes(results: Sequence[Result], earlier: Earlier | None, missing: Sequence[str]) -> list[str]:
    """What the columns mean, and what is not there."""
    units = dict.fromkeys((result.task.partition(",")[0], result.unit) for result in results)
    counted = "; ".join(f"{task}: {unit}" for task, unit in units)
    rounds, here = max((len(result.rates) for result in results), default=0), machine()
    notes = [
        f"{counted}. Median of {rounds} rounds in turns, {here['processor']}, {here['cores']} cores.",
        "ratio: the time that one unit takes, over that of the first program of the same gas.",
    ]
    if earlier is not None:
        notes.append(f"moved: since {earlier.path}.")
    if missing:
        notes.append(
            f"Left out, for they are not installed or do not start: {', '.join(missing)}. "
            "pip install 'gasbox[bench]'"
        )
    return notes
