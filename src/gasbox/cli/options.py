"""Arguments and options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

import typer

__all__ = [
    "Every",
    "FrameInterval",
    "Frames",
    "Json",
    "Record",
    "ScenarioName",
    "Seed",
    "Settings",
    "SnapshotFile",
    "Threads",
    "Until",
    "Workers",
]

ScenarioName: TypeAlias = Annotated[
    str, typer.Argument(metavar="SCENARIO", help="A file, or the name of a shipped scenario.")
]
Until: TypeAlias = Annotated[
    float | None, typer.Option("--until", metavar="TIME", help="Run up to this time (absolute).")
]
Frames: TypeAlias = Annotated[
    int | None, typer.Option("--frames", metavar="N", help="Run this many frames from here.")
]
FrameInterval: TypeAlias = Annotated[
    float | None, typer.Option("--frame", metavar="DT", help="Simulated time of one frame.")
]
Record: TypeAlias = Annotated[
    Path | None, typer.Option("--record", metavar="FILE.h5", help="Record to this HDF5 file.")
]
Every: TypeAlias = Annotated[
    float | None,
    typer.Option("--record-every", metavar="DT", help="Simulated time between recorded frames."),
]
SnapshotFile: TypeAlias = Annotated[
    Path | None,
    typer.Option("--snapshot", metavar="FILE.json", help="Save the end to this file, to resume from."),
]
Seed: TypeAlias = Annotated[int | None, typer.Option("--seed", help="Another seed.")]
Settings: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help="Change a field: species.0.count=500. Repeatable."),
]
Threads: TypeAlias = Annotated[
    int | None,
    typer.Option("--threads", metavar="N", help="Threads that work together; they change no result."),
]
Workers: TypeAlias = Annotated[
    int | None,
    typer.Option(
        "--workers", min=1, metavar="N", help="Processes [one for each core]; they change no result."
    ),
]
Json: TypeAlias = Annotated[
    bool, typer.Option("--json", help="Print the summary as one JSON object, and nothing else.")
]
