"""An observer that keeps energy, temperature and pressure over time."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.energy import (
    kinetic_energy,
    potential_energy,
    species_temperature,
    temperature,
    translational_temperature,
)
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
    potential_energy : (frames,) float64 [energy], in gravity and of forces; empty if nobody asked for it
    """

    time: NDArray[np.float64]
    energy: NDArray[np.float64]
    temperature: NDArray[np.float64]
    species_temperature: NDArray[np.float64]
    wall_pressure: NDArray[np.float64]
    virial_pressure: NDArray[np.float64]
    potential_energy: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))


class TimeSeries:
    """Keeps energy, temperature and the tallies of each frame; pressures follow over any window of frames.

    Parameters
    ----------
    geometry : what the gas is in
    radii : (species,) float64 [length]
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, radii: NDArray[np.float64]) -> None:
        self._geometry = geometry
        self._radii = np.asarray(radii, dtype=np.float64)
        self._rows: list[tuple[float, ...]] = []
        self._species_rows: list[list[float]] = []
        self._tallies: list[Tallies] = []
        self._counts: list[NDArray[np.int64]] = []
        self._places: list[tuple[Geometry, NDArray[np.float64]]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything and keep the first row."""
        self._rows, self._species_rows, self._tallies = [], [], []
        self._counts, self._places = [], []
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed: the tallies say it all."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Keep a row, unless this moment was seen already."""
        if self._rows and state.time <= self._rows[-1][0]:
            return
        whole = _number(temperature(state, self._geometry))
        potential = potential_energy(state, self._geometry)
        flight = _number(translational_temperature(state, self._geometry))
        self._rows.append((state.time, kinetic_energy(state), whole, potential, flight))
        self._species_rows.append(
            [_number(species_temperature(state, self._geometry, s)) for s in range(self._radii.size)]
        )
        self._tallies.append(tallies.copy())
        self._counts.append(np.bincount(state.species, minlength=self._radii.size))
        self._places.append((self._geometry, state.wall_displacement.copy()))

    def series(self, window: int = 1) -> Series:
        """Everything so far; pressures are measured over the `window` frames before (fewer at first)."""
        time, energy, heat, potential, _ = np.array(self._rows, dtype=np.float64).reshape(-1, 5).T
        pressures = [self._pressures(i, max(i - window, 0)) for i in range(time.size)]
        wall, virial = np.array(pressures, dtype=np.float64).reshape(-1, 2).T
        by_species = np.array(self._species_rows, dtype=np.float64).reshape(-1, self._radii.size)
        return Series(time, energy, heat, by_species, wall, virial, potential)

    def _pressures(self, later: int, earlier: int) -> tuple[float, float]:
        change = self._tallies[later] - self._tallies[earlier]
        duration = self._rows[later][0] - self._rows[earlier][0]
        flight = self._rows[later][4]
        heat = None if np.isnan(flight) else flight
        geometry = self._mean_place(later, earlier)
        wall = wall_pressure(change, geometry, self._radii, duration)
        virial = virial_pressure(
            change, geometry, self._radii, self._counts[later], temperature=heat, duration=duration
        )
        return _number(wall), _number(virial)

    def _mean_place(self, later: int, earlier: int) -> Geometry:
        """The geometry with its walls where they were on average, as frames tell it."""
        geometry, last = self._places[later]
        places = [place for _, place in self._places[earlier : later + 1] if place.shape == last.shape]
        # Ends count half: between frames walls count as moving evenly.
        middles = [0.5 * (one + other) for one, other in itertools.pairwise(places)]
        return geometry.at(np.mean(middles, axis=0) if middles else last)


def _number(value: float | None) -> float:
    return np.nan if value is None else value
