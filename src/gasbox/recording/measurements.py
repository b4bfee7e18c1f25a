"""The numbers that a recording keeps beside the particles, measured at each recorded frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from gasbox import observe
from gasbox.geometry import Rectangle
from gasbox.scenario import Scenario
from gasbox.state import Frame, Tallies

__all__ = ["Measurements"]


class Measurements:
    """Measures frames one after the other; pressures are those since the frame measured before.

    Parameters
    ----------
    scenario : what is run
    """

    def __init__(self, scenario: Scenario) -> None:
        self._geometry: Rectangle = scenario.geometry()
        self._radii = np.array([species.radius for species in scenario.species])
        self._before: tuple[float, Tallies] | None = None

    def of(self, frame: Frame) -> dict[str, ArrayLike | None]:
        """Name -> number or array; None where there is no value, as for a pressure at the first frame."""
        state, geometry = frame.state, self._geometry
        numbers: dict[str, ArrayLike | None] = {
            "energy": observe.kinetic_energy(state),
            "momentum": observe.momentum(state),
            "temperature": observe.temperature(state, geometry),
            "species_temperature": self._by_species(
                [observe.species_temperature(state, geometry, k) for k in range(self._radii.size)]
            ),
            "species_mean_speed": self._by_species(
                [observe.mean_speed(state, k) for k in range(self._radii.size)]
            ),
            "collisions": int(frame.tallies.pair_collisions.sum()),
            "wall_collisions": int(frame.tallies.wall_collisions.sum()),
        }
        return {**numbers, **self._pressures(frame)}

    def _by_species(self, values: list[float | None]) -> ArrayLike:
        return np.array([np.nan if value is None else value for value in values])

    def _pressures(self, frame: Frame) -> dict[str, float | None]:
        before, self._before = self._before, (frame.state.time, frame.tallies.copy())
        if before is None:
            return {"pressure": None, "pressure_virial": None}
        change, duration = frame.tallies - before[1], frame.state.time - before[0]
        counts = np.bincount(frame.state.species, minlength=self._radii.size)
        temperature = observe.temperature(frame.state, self._geometry)
        return {
            "pressure": observe.wall_pressure(change, self._geometry, self._radii, duration),
            "pressure_virial": observe.virial_pressure(
                change, self._geometry, self._radii, counts, temperature=temperature, duration=duration
            ),
        }
