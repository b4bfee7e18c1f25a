"""Snapshots: the scenario's own format, with the whole gas in `particles` and what else is needed to go on."""

from __future__ import annotations

import dataclasses
import gzip
from pathlib import Path

import numpy as np

from gasbox.errors import FileError
from gasbox.scenario import Particles, Scenario, Snapshot
from gasbox.state import Frame
from gasbox.version import __version__

__all__ = ["snapshot", "write"]


def snapshot(scenario: Scenario, frame: Frame) -> Scenario:
    """The scenario as it stands at `frame`; running it goes on with the same bits."""
    names = np.array([species.name for species in scenario.species], dtype=object)
    particles = Particles.of(names[frame.state.species].tolist(), frame.state.position, frame.state.velocity)
    section = Snapshot(
        version=__version__,
        time=frame.state.time,
        memory=frame.memory,
        tallies={name: value.tolist() for name, value in dataclasses.asdict(frame.tallies).items()},
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
