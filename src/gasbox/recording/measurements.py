"""The numbers that a recording keeps beside the particles, measured at each recorded frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gasbox import observe
from gasbox.geometry import Geometry, Rectangle
from gasbox.scenario import Forced, Scenario
from gasbox.state import Frame, State, Tallies

__all__ = ["Measurements"]


class Measurements:
    """Measures frames one after the other; pressures are those since the frame measured before.

    Parameters
    ----------
    scenario : what is run
    """

    def __init__(self, scenario: Scenario) -> None:
        self._geometry = scenario.geometry()
        self._forced = isinstance(scenario.dynamics, Forced)
        bare = isinstance(self._geometry, Rectangle) and not scenario.schedule
        self._plain = bare and not self._forced
        self._radii = np.array([kind.half_width for kind in scenario.kinds])
        self._before: tuple[float, NDArray[np.float64], Tallies] | None = None

    def of(self, frame: Frame, geometry: Geometry | None = None) -> dict[str, ArrayLike | None]:
        """Name -> number or array; None where there is no value, as for a pressure at the first frame.

        Parameters
        ----------
        geometry : what the gas is in now, where that may have changed
        """
        self._geometry = self._geometry if geometry is None else geometry
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
        if state.sites is not None:
            numbers |= self._temperatures(state)
        if not self._plain:
            here = geometry.at(state.wall_displacement)
            numbers |= {"potential_energy": observe.potential_energy(state, geometry), "area": here.area}
        if self._forced:
            sums = ("thermostat_heat", "heater_heat", "barostat_work")
            numbers |= {"virial": state.virial, **{name: getattr(frame.tallies, name)[0] for name in sums}}
        return {**numbers, **self._pressures(frame)}

    def _temperatures(self, state: State) -> dict[str, ArrayLike | None]:
        """Of the motions of molecules."""
        kinds = range(self._radii.size)
        turning = [observe.rotational_temperature(state, self._geometry, k) for k in kinds]
        vibrating = [observe.vibrational_temperature(state, k) for k in kinds]
        return {
            "temperature_translational": observe.translational_temperature(state, self._geometry),
            "temperature_rotational": observe.rotational_temperature(state, self._geometry),
            "temperature_vibrational": observe.vibrational_temperature(state),
            "species_temperature_rotational": self._by_species(turning),
            "species_temperature_vibrational": self._by_species(vibrating),
        }

    def _by_species(self, values: list[float | None]) -> ArrayLike:
        return np.array([np.nan if value is None else value for value in values])

    def _pressures(self, frame: Frame) -> dict[str, ArrayLike | None]:
        state, before = frame.state, self._before
        self._before = state.time, state.wall_displacement.copy(), frame.tallies.copy()
        walls: NDArray[np.float64] = np.full(len(self._geometry.wall_names), np.nan)
        if before is None:
            each = {} if self._plain else {"wall_pressure": walls}
            return {"pressure": None, "pressure_virial": None, **each}
        change, duration = frame.tallies - before[2], state.time - before[0]
        geometry = observe.between(self._geometry, before[1], state.wall_displacement)
        counts = np.bincount(state.species, minlength=self._radii.size)
        flight = observe.translational_temperature(state, self._geometry)
        if not self._plain:
            walls = observe.wall_pressures(change, geometry, self._radii, duration)
        return {
            "pressure": observe.wall_pressure(change, geometry, self._radii, duration),
            "pressure_virial": observe.virial_pressure(
                change, geometry, self._radii, counts, temperature=flight, duration=duration
            ),
            **({} if self._plain else {"wall_pressure": walls}),
        }
