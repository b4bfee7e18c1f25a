"""Energy, momentum and temperature of a gas.

Temperature is T = 2K/f (k_B = 1). Along a periodic direction the total momentum is conserved and carries no
heat: the velocity of the centre of mass along it is subtracted, and one degree of freedom is taken off. So f
= 2N between walls, 2N - 1 in a channel, 2N - 2 in a fully periodic box.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Rectangle
from gasbox.state import State

__all__ = [
    "degrees_of_freedom",
    "kinetic_energy",
    "momentum",
    "species_temperature",
    "temperature",
    "thermal_energy",
]


def kinetic_energy(state: State) -> float:
    """Kinetic energy of all particles [energy], as it stands in the box's own frame."""
    return _energy(state.mass, state.velocity)


def momentum(state: State) -> NDArray[np.float64]:
    """(2,) float64 [mass·length/time]: total momentum."""
    total: NDArray[np.float64] = state.mass @ state.velocity
    return total


def thermal_energy(state: State, geometry: Rectangle) -> float:
    """Kinetic energy [energy] without that of the drift along periodic directions."""
    if state.count == 0 or not np.any(geometry.periodic):
        return kinetic_energy(state)
    whole = state.mass @ state.velocity**2
    drift = np.where(geometry.periodic, momentum(state) ** 2 / np.sum(state.mass), 0.0)
    if np.any(drift > 0.5 * whole):
        # The difference would lose digits.
        return _energy(state.mass, _thermal_velocity(state, geometry))
    return 0.5 * float(np.sum(whole - drift))


def degrees_of_freedom(count: int, geometry: Rectangle) -> int:
    """Velocity components that share the energy: 2 a particle, less one for each periodic direction."""
    return max(2 * count - int(geometry.periodic_x) - int(geometry.periodic_y), 0)


def temperature(state: State, geometry: Rectangle) -> float | None:
    """T = 2K/f [energy]; None without degrees of freedom (no particle, or a single one in a periodic box)."""
    freedom = degrees_of_freedom(state.count, geometry)
    if freedom == 0:
        return None
    return 2.0 * thermal_energy(state, geometry) / freedom


def species_temperature(state: State, geometry: Rectangle, species: int) -> float | None:
    """Mean kinetic energy per particle of one species [energy], in the same frame as `temperature`.

    Where momentum is conserved its long-time mean is T (1 - (conserved/2) m/M), with the mass m of the
    particle and M of all: `gasbox.theory.finite.energy_share`. None without particles of this species or
    degrees of freedom.
    """
    mine = state.species == species
    count = int(np.count_nonzero(mine))
    if count == 0 or degrees_of_freedom(state.count, geometry) == 0:
        return None
    return _energy(state.mass[mine], _thermal_velocity(state, geometry)[mine]) / count


def _energy(mass: NDArray[np.float64], velocity: NDArray[np.float64]) -> float:
    return 0.5 * float(np.sum(mass @ velocity**2))


def _thermal_velocity(state: State, geometry: Rectangle) -> NDArray[np.float64]:
    """(n, 2) float64 [length/time]: velocities less that of the centre of mass along periodic directions."""
    if state.count == 0 or not np.any(geometry.periodic):
        return state.velocity
    drift = momentum(state) / np.sum(state.mass)
    return state.velocity - np.where(geometry.periodic, drift, 0.0)
