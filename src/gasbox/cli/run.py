"""`gasbox run`: a scenario without a page."""

from __future__ import annotations

from gasbox.cli import options

__all__ = ["run"]


def run(
    scenario: options.ScenarioName,
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
    """Run a scenario without a page, and print what it came to."""
    from gasbox.cli.journey import Journey, travel
    from gasbox.cli.source import Changes, from_scenario

    start = from_scenario(scenario, Changes(settings or [], seed, frame))
    travel(start, Journey(until, frames, record, record_every, snapshot, threads), json)
