"""An observer that keeps energy, temperature and pressure over time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Rectangle
from gasbox.observe.energy import kinetic_energy, species_temperature, temperature
from gasbox.observe.pressure import virial_pressure, wall_pressure
from gasbox.state import Contacts, State, Tallies

__all__ = ["Series", "TimeSeries"]


@dataclass(frozen=True)
class Series:
    """Quantities over time, one row for each frame; not-a-number where there is none.

    Attributes
    ----------
    time : (frames,) float64 [time]
    energy, temperature : (frames,) float64 [energy]
    species_temperature : (frames, species) float64 [energy]
    wall_pressure, virial_pressure : (frames,) float64 [mass/time²], over the window of frames before each
    """

    time: NDArray[np.float64]
    energy: NDArray[np.float64]
    temperature: NDArray[np.float64]
    species_temperature: NDArray[np.float64]
    wall_pressure: NDArray[np.float64]
    virial_pressure: NDArray[np.float64]


class TimeSeries:
    """Keeps energy, temperature and the tallies of each frame; pressures follow over any window of frames.

    Parameters
    ----------
    geometry : the box
    radii : (species,) float64 [length]
    """

    reads_contacts = False

    def __init__(self, geometry: Rectangle, radii: NDArray[np.float64]) -> None:
        self._geometry = geometry
        self._radii = np.asarray(radii, dtype=np.float64)
        self._rows: list[tuple[float, ...]] = []
        self._species_rows: list[list[float]] = []
        self._tallies: list[Tallies] = []
        self._counts = np.zeros(self._radii.size, np.int64)

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything and keep the first row."""
        self._rows, self._species_rows, self._tallies = [], [], []
        self._counts = np.bincount(state.species, minlength=self._radii.size)
        self.observe(state, tallies)

    def read(self, contacts: Contacts) -> None:
        """Not needed: the tallies say it all."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Keep a row, unless this moment was seen already."""
        if self._rows and state.time <= self._rows[-1][0]:
            return
        whole = _number(temperature(state, self._geometry))
        self._rows.append((state.time, kinetic_energy(state), whole))
        self._species_rows.append(
            [_number(species_temperature(state, self._geometry, s)) for s in range(self._radii.size)]
        )
        self._tallies.append(tallies.copy())

    def series(self, window: int = 1) -> Series:
        """Everything so far; pressures are measured over the `window` frames before (fewer at first)."""
        columns = np.array(self._rows, dtype=np.float64).reshape(-1, 3)
        pressures = np.array([self._pressures(i, max(i - window, 0)) for i in range(len(columns))]).reshape(
            -1, 2
        )
        by_species = np.array(self._species_rows, dtype=np.float64).reshape(-1, self._radii.size)
        return Series(
            columns[:, 0], columns[:, 1], columns[:, 2], by_species, pressures[:, 0], pressures[:, 1]
        )

    def _pressures(self, later: int, earlier: int) -> tuple[float, float]:
        change = self._tallies[later] - self._tallies[earlier]
        duration = self._rows[later][0] - self._rows[earlier][0]
        whole = self._rows[later][2]
        heat = None if np.isnan(whole) else whole
        wall = wall_pressure(change, self._geometry, self._radii, duration)
        virial = virial_pressure(
            change, self._geometry, self._radii, self._counts, temperature=heat, duration=duration
        )
        return _number(wall), _number(virial)


def _number(value: float | None) -> float:
    return np.nan if value is None else value
