"""Shows and keeps measured rates."""

from __future__ import annotations

import datetime
import json
import os
import platform
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path
from typing import Any

from rich.box import SIMPLE
from rich.console import Console
from rich.table import Table

from gasbox.bench.contest import OURS, Result
from gasbox.errors import FileError
from gasbox.version import __version__

__all__ = ["machine", "print_table", "save"]

_WIDTH = 100
_PACKAGES = ("numpy", "numba", "scipy", "pymunk")


def print_table(results: Sequence[Result]) -> None:
    """One table: million units a second (median and range), and how many times faster ours is."""
    table = Table("gas", "particles", "program", "million/s", "range", "ours is", box=SIMPLE)
    for column in table.columns:
        column.no_wrap = True
    for before, result in zip([None, *results], results, strict=False):
        if before is not None and result.task != before.task:
            table.add_section()
        low, high = min(result.rates), max(result.rates)
        table.add_row(
            result.task,
            f"{result.particles:,}",
            result.program,
            f"{result.median / 1e6:.3g}",
            f"{low / 1e6:.2g}-{high / 1e6:.2g}",
            "" if result.program == OURS else f"{result.ratio:.2f} x",
        )
    # Wide enough that nothing is cut off where the output is no terminal.
    Console(highlight=False, width=max(Console().width, _WIDTH)).print(table)
    units = dict.fromkeys((result.task.partition(",")[0], result.unit) for result in results)
    counted = "; ".join(f"{task}: {unit}" for task, unit in units)
    rounds = f"median of {len(results[0].rates)} rounds in turns"
    print(f"{counted}. {rounds}, {machine()['processor']}, {os.cpu_count()} cores.")


def save(results: Sequence[Result], path: Path) -> Path:
    """Write results, machine, versions and date as JSON, into a file or under a name of its own into a folder.

    Raises
    ------
    FileError
        The file cannot be written.
    """
    now = datetime.datetime.now(datetime.UTC)
    target = path / f"{now:%Y-%m-%d-%H%M%S}.json" if path.is_dir() else path
    rows = [{**vars(result), "median": result.median} for result in results]
    kept = {
        "date": now.isoformat(timespec="seconds"),
        "machine": machine(),
        "versions": _versions(),
        "rates": rows,
    }
    try:
        target.write_text(json.dumps(kept, indent=1) + "\n")
    except OSError as error:
        raise FileError(f"cannot write {target}: {error.strerror}") from None
    return target


def machine() -> dict[str, Any]:
    """What the rates depend on."""
    return {"processor": _processor(), "cores": os.cpu_count(), "system": platform.platform()}


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _versions() -> dict[str, str]:
    found = {"gasbox": __version__, "python": platform.python_version()}
    for package in _PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            continue
    return found
