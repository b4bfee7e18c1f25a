"""Snapshots: the scenario's own format, with the whole gas in `particles` and what else is needed to go on."""

from __future__ import annotations

import dataclasses
import gzip
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gasbox.errors import FileError
from gasbox.scenario import Particles, Scenario, ScheduledChange, Snapshot
from gasbox.state import Change, Frame
from gasbox.version import __version__

__all__ = ["snapshot", "write"]


def snapshot(scenario: Scenario, frame: Frame, changes: Sequence[tuple[float, Change]] = ()) -> Scenario:
    """The scenario as it stands at `frame`, after these changes; running it goes on with the same bits."""
    names = np.array([kind.name for kind in scenario.kinds], dtype=object)
    state = frame.state
    particles = Particles.of(
        names[state.species].tolist(),
        state.position,
        state.velocity,
        angle=None if state.sites is None else state.angle,
        angular_velocity=None if state.sites is None else state.angular_velocity,
    )
    ids = frame.state.id
    section = Snapshot(
        version=__version__,
        time=frame.state.time,
        memory=frame.memory,
        tallies={name: value.tolist() for name, value in dataclasses.asdict(frame.tallies).items()},
        ids=None if np.array_equal(ids, np.arange(ids.size)) else tuple(ids.tolist()),
        changes=tuple(ScheduledChange.of(time, change) for time, change in changes),
    )
    return scenario.model_copy(update={"particles": particles, "snapshot": section})


def write(scenario: Scenario, path: Path) -> None:
    """Write a scenario or snapshot; compressed if the name ends in .gz. The old file stays until the new is whole."""
    text = scenario.to_json().encode()
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(gzip.compress(text, 6) if path.suffix == ".gz" else text)
        part.replace(path)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from None
