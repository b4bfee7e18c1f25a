"""The standard figures of a recording: it is read here, and drawn by `gasbox.plots` from arrays."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import FileError
from gasbox.observe import HistogramAverage, Series, automatic_maximum, bin_edges
from gasbox.plots import HistogramPanel, overview_figure
from gasbox.recording import Recording, open_recording
from gasbox.scenario import Scenario
from gasbox.state import Frame
from gasbox.theory.mixture import Mixture, ideal_pressure, pressure

__all__ = ["draw"]

_DOTS_PER_INCH = 150


def draw(path: Path, output: Path, last: int | None) -> None:
    """Draw the recording `path` to the file `output`.

    Parameters
    ----------
    last : frames over which histograms are averaged; None takes the later half

    Raises
    ------
    FileError
        The recording cannot be read, or the figure not be written.
    """
    with open_recording(path) as recording:
        end = recording.read(-1)
        first = recording.frames // 2 if last is None else max(recording.frames - last, 0)
        numbers = recording.observables()
        heat = float(np.mean(numbers["temperature"][first:]))
        temperature = None if np.isnan(heat) else heat
        ideal, discs = _theory(recording.scenario, end, temperature)
        figure = overview_figure(
            _panels(recording, range(first, recording.frames), temperature),
            _series(recording.times, numbers),
            recording.scenario.histograms.quantity,
            ideal,
            discs,
            _title(recording, first),
        )
    try:
        figure.savefig(output, dpi=_DOTS_PER_INCH)
    except OSError as error:
        raise FileError(f"cannot write {output}: {error.strerror or error}") from None


def _title(recording: Recording, first: int) -> str:
    times, count = recording.times, recording.frames - first
    if count == 1:
        shown = f"histograms at time {times[-1]:g}"
    else:
        shown = f"histograms: mean of {count} frames, time {times[first]:g} to {times[-1]:g}"
    title = recording.scenario.title
    return f"{title}\n{shown}" if title else shown


def _panels(recording: Recording, frames: range, temperature: float | None) -> list[HistogramPanel]:
    scenario = recording.scenario
    edges = _edges(scenario, recording.read(frames[0]))
    average = HistogramAverage(edges, scenario.histograms.quantity)
    for number in frames:
        frame = recording.read(number)
        average.observe(frame.state, frame.tallies)
    return [
        HistogramPanel(species.name, species.color, histogram, species.mass, temperature)
        for species, histogram in zip(scenario.species, average.histograms(), strict=True)
    ]


def _edges(scenario: Scenario, frame: Frame) -> list[NDArray[np.float64]]:
    """Bins as the scenario says; where it says no end, each species has its own."""
    wanted, geometry = scenario.histograms, scenario.geometry()
    ends = [
        wanted.maximum or automatic_maximum(frame.state, geometry, number, wanted.quantity)
        for number in range(len(scenario.species))
    ]
    return [bin_edges(wanted.bins, wanted.minimum, max(end, wanted.minimum * 2)) for end in ends]


def _series(times: NDArray[np.float64], numbers: dict[str, NDArray[np.float64]]) -> Series:
    return Series(
        times,
        numbers["energy"],
        numbers["temperature"],
        numbers["species_temperature"],
        numbers["pressure"],
        numbers["pressure_virial"],
    )


def _theory(scenario: Scenario, frame: Frame, temperature: float | None) -> tuple[float | None, float | None]:
    """Pressure of an ideal gas and of hard discs [mass/time²]."""
    if temperature is None:
        return None, None
    kinds = scenario.species
    gas = Mixture.of(
        np.bincount(frame.state.species, minlength=len(kinds)),
        [species.mass for species in kinds],
        [species.radius for species in kinds],
        scenario.geometry().area,
    )
    return ideal_pressure(gas, temperature), pressure(gas, temperature)
