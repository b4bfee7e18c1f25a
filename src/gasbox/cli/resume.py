"""`gasbox resume`: goes on from where a run was saved."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gasbox.cli import options

__all__ = ["resume"]


def resume(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A snapshot or a recording.")],
    at: Annotated[
        int, typer.Option("--at", metavar="I", help="Of a recording: go on from frame I, -1 for the last.")
    ] = -1,
    until: options.Until = None,
    frames: options.Frames = None,
    frame: options.FrameInterval = None,
    record: options.Record = None,
    record_every: options.Every = None,
    snapshot: options.SnapshotFile = None,
    seed: options.Seed = None,
    settings: options.Settings = None,
    threads: options.Threads = None,
    json: options.Json = False,
) -> None:
    """Go on from a snapshot or a recording, with the same bits as if it had not been stopped."""
    from gasbox.cli.journey import Journey, travel
    from gasbox.cli.source import Changes, from_saved

    start = from_saved(file, at, Changes(settings or [], seed, frame))
    travel(start, Journey(until, frames, record, record_every, snapshot, threads), json)
