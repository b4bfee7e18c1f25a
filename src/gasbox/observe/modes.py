"""The energy of each degree of freedom: of flight along x and y, of rotation and of vibration.

In equilibrium each has T/2 on average (equipartition); how far they are apart tells how far a gas is from it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.energy import rotational_temperature, thermal_velocity, vibrational_temperature
from gasbox.state import Contacts, State, Tallies

__all__ = ["ModeEnergies", "ModeSeries", "Modes", "mode_energies"]


@dataclass(frozen=True)
class ModeEnergies:
    """Mean kinetic energies [energy], for each degree of freedom.

    Attributes
    ----------
    x, y : of flight along either direction, per particle
    rotation : per particle that rotates; None where nothing does
    vibration : per degree of freedom of vibration; None where nothing vibrates
    """

    x: float
    y: float
    rotation: float | None
    vibration: float | None


def mode_energies(state: State, geometry: Geometry, species: int | None = None) -> ModeEnergies | None:
    """Energies of the whole gas, or of one kind, in the same frame as `temperature`; None without particles.

    Where momentum is conserved those of flight are a little less than T/2: `gasbox.theory.finite.energy_share`.
    """
    mine = np.ones(state.count, np.bool_) if species is None else state.species == species
    count = int(np.count_nonzero(mine))
    if count == 0:
        return None
    x, y = 0.5 * (state.mass[mine] @ thermal_velocity(state, geometry)[mine] ** 2) / count
    turning = rotational_temperature(state, geometry, species)
    vibrating = vibrational_temperature(state, species)
    return ModeEnergies(float(x), float(y), _half(turning), _half(vibrating))


def _half(value: float | None) -> float | None:
    return None if value is None else 0.5 * value


@dataclass(frozen=True)
class ModeSeries:
    """Energies of each degree of freedom over time, one row for each frame; not-a-number where there is none.

    Attributes
    ----------
    time : (frames,) float64 [time]
    x, y, rotation, vibration : (frames,) float64 [energy], as `ModeEnergies` has them
    """

    time: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    rotation: NDArray[np.float64]
    vibration: NDArray[np.float64]


class Modes:
    """Keeps the energy of each degree of freedom, frame by frame.

    Parameters
    ----------
    geometry : what the gas is in
    species : of which kind; None for the whole gas
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, species: int | None = None) -> None:
        self._geometry = geometry
        self._species = species
        self._rows: list[tuple[float, ...]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything and keep the first row."""
        self._rows = []
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Keep a row, unless this moment was seen already."""
        if self._rows and state.time <= self._rows[-1][0]:
            return
        found = mode_energies(state, self._geometry, self._species)
        values = (None,) * 4 if found is None else (found.x, found.y, found.rotation, found.vibration)
        self._rows.append((state.time, *(np.nan if value is None else value for value in values)))

    def series(self) -> ModeSeries:
        """Everything so far."""
        return ModeSeries(*np.array(self._rows, np.float64).reshape(-1, 5).T)
