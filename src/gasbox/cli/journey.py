"""A run from the command line: the loop with its recording, progress, interruption and summary."""

from __future__ import annotations

import sys
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import typer

from gasbox.cli.outputs import check_outputs
from gasbox.cli.progress import Progress, compile_first
from gasbox.cli.report import print_json, print_summary, warn
from gasbox.cli.source import Source
from gasbox.cli.stopping import Stopping
from gasbox.cli.timetable import recorded_frames
from gasbox.errors import UsageError
from gasbox.recording import Measurements, Recorder
from gasbox.simulation import Simulation, run

__all__ = ["Journey", "travel"]


@dataclass(frozen=True)
class Journey:
    """How far to go, and what to keep on the way.

    Attributes
    ----------
    until : absolute time of the end [time], or None
    frames : number of frames from here, or None
    record : file of the recording, or None
    record_every : time between recorded frames [time]; None records every frame
    snapshot : file for the state at the end, or None
    threads : how many work together; None for as many as are worth it
    """

    until: float | None = None
    frames: int | None = None
    record: Path | None = None
    record_every: float | None = None
    snapshot: Path | None = None
    threads: int | None = None


@dataclass(frozen=True)
class _Arrival:
    """How a run ended: whether it was interrupted, and how many frames were recorded."""

    interrupted: bool
    recorded: int


def travel(source: Source, journey: Journey, as_json: bool) -> None:
    """Run, keep what is asked for, and print the summary; exit with status 130 if it was interrupted.

    Raises
    ------
    GasboxError
        Whatever makes the run impossible; as much as possible is found before it starts.
    """
    if journey.until is None and journey.frames is None:
        raise UsageError("say how far to run: --until TIME or --frames N")
    if journey.record_every is not None and journey.record is None:
        raise UsageError("--record-every needs --record FILE.h5")
    check_outputs(source.path, journey.record, journey.snapshot, source.scenario.snapshot is not None)
    compile_first()
    simulation = Simulation(source.scenario, threads=journey.threads)
    warn(simulation.warnings)
    arrival = _travel(simulation, journey)
    if journey.snapshot is not None:
        simulation.save(journey.snapshot)
    _report(simulation, journey, arrival, as_json)
    if arrival.interrupted:
        raise typer.Exit(130)


def _travel(simulation: Simulation, journey: Journey) -> _Arrival:
    span = (journey.frames or 0) * simulation.frame_interval
    end = simulation.time + span if journey.until is None else journey.until
    frames = run(simulation, until=journey.until, frames=journey.frames)
    moments = recorded_frames(simulation, frames, end, journey.record_every)
    measurements = Measurements(simulation.scenario)
    recorder = None
    with ExitStack() as stack:
        # The first in is the last out: no signal disturbs the closing of the file.
        stopping = stack.enter_context(Stopping())
        if journey.record is not None:
            recorder = stack.enter_context(Recorder(journey.record, simulation.scenario_in_use))
        progress = stack.enter_context(Progress(simulation.time, end))
        for frame in moments:
            if recorder is not None and frame is not None:
                recorder.write(frame, measurements.of(frame, simulation.geometry), simulation.changes)
            progress.show(simulation.time)
            if stopping.wanted:
                return _Arrival(True, recorder.frames if recorder else 0)
    return _Arrival(False, recorder.frames if recorder else 0)


def _report(simulation: Simulation, journey: Journey, arrival: _Arrival, as_json: bool) -> None:
    if arrival.interrupted:
        print(f"Interrupted at time {simulation.time:g}.", file=sys.stderr)
    summary = simulation.summary()
    if as_json:
        kept = {"recording": journey.record, "snapshot": journey.snapshot}
        summary |= {name: None if path is None else str(path) for name, path in kept.items()}
        print_json({**summary, "recorded_frames": arrival.recorded, "interrupted": arrival.interrupted})
        return
    print_summary(summary, simulation.scenario.title)
    if journey.record is not None:
        print(f"{arrival.recorded} frames in {journey.record}")
    if journey.snapshot is not None:
        print(f"the end in {journey.snapshot}")
