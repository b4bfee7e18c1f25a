"""The figures of a recording: it is read here, and drawn by `gasbox.plots` from arrays."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gasbox.cli.matter import FIGURES_OF_MATTER, matter_panels
from gasbox.cli.molecules import FIGURES_OF_MOLECULES, molecule_panels
from gasbox.cli.panels import FIGURES, panels_of
from gasbox.cli.survey import Survey, survey
from gasbox.errors import FileError, UsageError
from gasbox.geometry import Rectangle
from gasbox.observe import HistogramAverage, Series, automatic_maximum, bin_edges
from gasbox.plots import (
    HistogramPanel,
    Panel,
    histogram_figure,
    overview_figure,
    panels_figure,
    series_figure,
)
from gasbox.recording import Recording, open_recording
from gasbox.scenario import Forced, Scenario
from gasbox.state import Frame
from gasbox.theory.mixture import Mixture, ideal_pressure, pressure

__all__ = ["draw"]

_DOTS_PER_INCH = 150
_OVERVIEW: Final = ("gas", "profiles", "centers", "transfers", "pv", "walls", "sides", "flow")
"""Order of the further panels of the overview."""
_OF_FORCES: Final = ("phases", "rdf")
"""What the overview of a gas with forces shows beside."""
_OF_MOLECULES: Final = ("modes", "rotation")
"""And that of a gas with molecules."""


def draw(path: Path, output: Path, last: int | None, name: str = "overview") -> None:
    """Draw the recording `path` to the file `output`.

    Parameters
    ----------
    last : frames over which histograms and profiles are averaged; None takes the later half
    name : of the figure: overview, histograms, series, or one of `FIGURES`

    Raises
    ------
    FileError, UsageError
        The recording cannot be read, has nothing to show there, or the figure cannot be written.
    """
    with open_recording(path) as recording:
        recording.read(-1)
        first = recording.frames // 2 if last is None else max(recording.frames - last, 0)
        figure = _figure(recording, first, name)
    try:
        figure.savefig(output, dpi=_DOTS_PER_INCH)
    except OSError as error:
        raise FileError(f"cannot write {output}: {error.strerror or error}") from None


def _figure(recording: Recording, first: int, name: str) -> Figure:
    scenario, numbers = recording.scenario, recording.observables()
    heat = numbers["temperature"][first:]
    temperature = float(np.mean(heat)) if np.all(np.isfinite(heat)) else None
    if name in FIGURES:
        return _panels_figure(recording, first, name, temperature)
    panels = _panels(recording, range(first, recording.frames), temperature) if name != "series" else []
    if name == "histograms":
        return histogram_figure(panels, scenario.histograms.quantity, _title(recording, first))
    series = _series(recording.times, numbers)
    ideal, discs = _theory(recording, temperature)
    if name == "series":
        species = [(entry.name, entry.color) for entry in scenario.kinds]
        return series_figure(series, species, ideal, discs, scenario.title)
    more = _more(survey(recording, first), scenario, temperature) if _is_more_than_a_box(recording) else []
    if isinstance(scenario.dynamics, Forced):
        more += [panel for each in _OF_FORCES for panel in matter_panels(each, recording, first)]
    if scenario.molecules:
        more += [p for each in _OF_MOLECULES for p in molecule_panels(each, recording, first, temperature)]
    quantity = scenario.histograms.quantity
    title = _title(recording, first, "means" if more else "histograms")
    return overview_figure(panels, series, quantity, ideal, discs, title, more)


def _panels_figure(recording: Recording, first: int, name: str, temperature: float | None) -> Figure:
    if name in FIGURES_OF_MATTER:
        panels = matter_panels(name, recording, first)
    elif name in FIGURES_OF_MOLECULES:
        panels = molecule_panels(name, recording, first, temperature)
    else:
        panels = panels_of(name, recording.scenario, survey(recording, first), temperature)
    if not panels:
        raise UsageError(f"{recording.path} has nothing to show in the figure {name!r}: {FIGURES[name]}")
    shown = (
        _title(recording, first, "means")
        if name in ("profiles", "walls", "rdf", "rotation", "orientation")
        else recording.scenario.title
    )
    return panels_figure(panels, shown)


def _more(found: Survey, scenario: Scenario, temperature: float | None) -> list[Panel]:
    return [panel for name in _OVERVIEW for panel in panels_of(name, scenario, found, temperature)]


def _is_more_than_a_box(recording: Recording) -> bool:
    return not all(isinstance(recording.geometry_at(index), Rectangle) for index in (0, -1))


def _title(recording: Recording, first: int, what: str = "histograms") -> str:
    times, count = recording.times, recording.frames - first
    if count == 1:
        shown = f"{what} at time {times[-1]:g}"
    else:
        shown = f"{what}: mean of {count} frames, time {times[first]:g} to {times[-1]:g}"
    shown = shown.replace("means: mean", "mean")
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
        for species, histogram in zip(scenario.kinds, average.histograms(), strict=True)
    ]


def _edges(scenario: Scenario, frame: Frame) -> list[NDArray[np.float64]]:
    """Bins as the scenario says; where it says no end, each species has its own."""
    wanted, geometry = scenario.histograms, scenario.geometry()
    ends = [
        wanted.maximum or automatic_maximum(frame.state, geometry, number, wanted.quantity)
        for number in range(len(scenario.kinds))
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
        numbers.get("potential_energy", np.zeros(0)),
    )


def _theory(recording: Recording, temperature: float | None) -> tuple[float | None, float | None]:
    """Pressure of an ideal gas and of hard discs [mass/time²], where one temperature and area say it.

    Discs with forces are not hard, and molecules no discs: of them no law is drawn but the ideal one, and none where a
    barostat is at work.
    """
    end = recording.read(-1)
    geometry = recording.geometry_at(-1)
    leaves = recording.read(0).state.count != end.state.count
    if temperature is None or any(geometry.gravity) or geometry.moves or leaves:
        return None, None
    kinds = recording.scenario.kinds
    gas = Mixture.of(
        np.bincount(end.state.species, minlength=len(kinds)),
        [species.mass for species in kinds],
        [species.radius for species in kinds],
        geometry.area,
    )
    forced = isinstance(recording.scenario.dynamics, Forced)
    if forced and end.state.wall_displacement.size:
        return None, None
    hard = not forced and not any(kind.inertia for kind in kinds)
    return ideal_pressure(gas, temperature), pressure(gas, temperature) if hard else None
