"""Energy, momentum and temperature of a gas.

Temperature is T = 2K/f (k_B = 1). Where a momentum is conserved (`gasbox.geometry.conserved`) it carries no heat: the
velocity of the centre of mass along such a direction is subtracted, and one degree of freedom is taken off. So f = 2N
between walls, 2N - 1 in a channel, 2N - 2 in a fully periodic box. Obstacles, rough walls or gravity break the
symmetry; then f = 2N, and all of K counts.

In a bare smooth circle the angular momentum L about the centre is conserved: the velocities are taken in the frame that
turns with L/I, I = sum m r² of the present positions, which leaves K - L²/(2I), and f = 2N - 1. There K is conserved,
but with L the heat is not quite, since I fluctuates; of N discs by one part in N.

A rigid molecule that rotates has one degree of freedom more, and its energy of rotation belongs to K; a flexible one
of k sites has 2k in all (`gasbox.observe.rotation`). L and I hold the spins of molecules too.

Gravity changes none of this: it acts on all discs alike, so velocities at one moment know nothing of it. It adds a
potential energy -m g·x to each disc. Along a periodic direction there is no potential: gravity drives discs round and
round there. Forces between discs add theirs, which the state holds.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.geometry.conserved import conserved_momentum, conserves_rotation
from gasbox.observe.rotation import (
    degrees_of_rotation,
    degrees_of_vibration,
    rotational_energies,
    spins,
    vibrational_energies,
)
from gasbox.state import State

__all__ = [
    "angular_momentum",
    "degrees_of_freedom",
    "enthalpy",
    "internal_energy",
    "kinetic_energy",
    "momentum",
    "potential_energy",
    "rotational_temperature",
    "species_temperature",
    "temperature",
    "thermal_energy",
    "thermal_velocity",
    "translational_temperature",
    "vibrational_temperature",
]


def kinetic_energy(state: State) -> float:
    """Kinetic energy of all particles [energy], as it stands in the box's own frame; also within molecules."""
    return _energy(state.mass, state.velocity) + _inner_energy(state)


def _inner_energy(state: State, rate: float = 0.0) -> float:
    """Kinetic energy of rotation, in a frame that turns at this rate [rad/time], and of vibration [energy]."""
    if state.sites is None:
        return 0.0
    return float(np.sum(rotational_energies(state, rate)) + np.sum(vibrational_energies(state)))


def potential_energy(state: State, geometry: Geometry) -> float:
    """Energy of all particles in gravity, -sum m g·x, and of the forces between them [energy].

    The first is zero at the origin and negative where they fall to, the second zero where all are far apart.
    """
    pull = np.where(geometry.periodic, 0.0, geometry.gravity)
    falling = -float(state.mass @ (state.position @ pull)) if np.any(pull) else 0.0
    return falling + state.potential


def internal_energy(state: State, geometry: Geometry) -> float:
    """Kinetic and potential energy of all particles [energy]."""
    return kinetic_energy(state) + potential_energy(state, geometry)


def enthalpy(state: State, geometry: Geometry, pressure: float) -> float:
    """Internal energy and pressure times area [energy]: at constant pressure it changes by the heat that is added.

    Parameters
    ----------
    geometry : its walls are displaced here
    pressure : from outside, that of the barostat [mass/time²]
    """
    return internal_energy(state, geometry) + pressure * geometry.at(state.wall_displacement).area


def momentum(state: State) -> NDArray[np.float64]:
    """(2,) float64 [mass·length/time]: total momentum."""
    total: NDArray[np.float64] = state.mass @ state.velocity
    return total


def angular_momentum(state: State, center: tuple[float, float] = (0.0, 0.0)) -> float:
    """Sum of m (r x v) + I w about a point [mass·length²/time], counter-clockwise positive."""
    arm, velocity = state.position - center, state.velocity
    around = float(state.mass @ (arm[:, 0] * velocity[:, 1] - arm[:, 1] * velocity[:, 0]))
    if state.sites is None:
        return around
    inertia, turning = spins(state)
    return around + float(inertia @ turning)


def thermal_energy(state: State, geometry: Geometry) -> float:
    """Kinetic energy [energy] without that of the drift, or rotation, that is conserved."""
    flying = _flying_energy(state, geometry)
    if state.sites is None:
        return flying
    return flying + _inner_energy(state, _frame_rate(state, geometry))


def _flying_energy(state: State, geometry: Geometry) -> float:
    """Thermal energy of the motion of the centres alone [energy]."""
    conserved = conserved_momentum(geometry)
    if state.count == 0 or not (np.any(conserved) or conserves_rotation(geometry)):
        return _energy(state.mass, state.velocity)
    whole = state.mass @ state.velocity**2
    drift = np.where(conserved, momentum(state) ** 2 / np.sum(state.mass), 0.0)
    if conserves_rotation(geometry) or np.any(drift > 0.5 * whole):
        # The difference would lose digits.
        return _energy(state.mass, thermal_velocity(state, geometry))
    return 0.5 * float(np.sum(whole - drift))


def _frame_rate(state: State, geometry: Geometry) -> float:
    """Angular velocity of the frame in which heat is measured [rad/time]."""
    return _rotation_rate(state, geometry) if state.count and conserves_rotation(geometry) else 0.0


def degrees_of_freedom(particles: State | int, geometry: Geometry) -> int:
    """Velocities that share the energy: 2 a particle, 1 more if it rotates, less one for each conserved momentum.

    A flexible molecule of k sites has 2k.

    Parameters
    ----------
    particles : the gas; or their number, for the motion of their centres alone
    """
    moving = 2 * (particles.count if isinstance(particles, State) else particles)
    if isinstance(particles, State):
        moving += int(np.sum(degrees_of_rotation(particles)) + np.sum(degrees_of_vibration(particles)))
    conserved = int(np.count_nonzero(conserved_momentum(geometry))) + int(conserves_rotation(geometry))
    return max(moving - conserved, 0)


def temperature(state: State, geometry: Geometry) -> float | None:
    """T = 2K/f [energy]; None without degrees of freedom (no particle, or a single disc in a periodic box).

    Of molecules those of rotation and vibration count as well.
    """
    freedom = degrees_of_freedom(state, geometry)
    if freedom == 0:
        return None
    return 2.0 * thermal_energy(state, geometry) / freedom


def translational_temperature(state: State, geometry: Geometry) -> float | None:
    """2K/f of the motion of the centres of mass alone [energy]; None without degrees of freedom."""
    freedom = degrees_of_freedom(state.count, geometry)
    if freedom == 0:
        return None
    return 2.0 * _flying_energy(state, geometry) / freedom


def rotational_temperature(state: State, geometry: Geometry, species: int | None = None) -> float | None:
    """2K/f of the rotation of molecules [energy], of all or of one kind; None where nothing rotates."""
    mine = np.ones(state.count, np.bool_) if species is None else state.species == species
    freedom = int(np.sum(degrees_of_rotation(state)[mine]))
    if freedom == 0:
        return None
    rate = _frame_rate(state, geometry)
    return 2.0 * float(np.sum(rotational_energies(state, rate)[mine])) / freedom


def vibrational_temperature(state: State, species: int | None = None) -> float | None:
    """2K/f of the vibration of flexible molecules [energy], of all or of one kind; None where nothing vibrates."""
    mine = np.ones(state.count, np.bool_) if species is None else state.species == species
    freedom = int(np.sum(degrees_of_vibration(state)[mine]))
    if freedom == 0:
        return None
    return 2.0 * float(np.sum(vibrational_energies(state)[mine])) / freedom


def species_temperature(state: State, geometry: Geometry, species: int) -> float | None:
    """Mean kinetic energy per particle of one species [energy], in the same frame as `temperature`.

    Where momentum is conserved its long-time mean is T (1 - (conserved/2) m/M), with the mass m of the
    particle and M of all: `gasbox.theory.finite.energy_share`. None without particles of this species or
    degrees of freedom.
    """
    mine = state.species == species
    count = int(np.count_nonzero(mine))
    if count == 0 or degrees_of_freedom(state.count, geometry) == 0:
        return None
    return _energy(state.mass[mine], thermal_velocity(state, geometry)[mine]) / count


def thermal_velocity(state: State, geometry: Geometry) -> NDArray[np.float64]:
    """(n, 2) float64 [length/time]: velocities less the drift, or rotation, that is conserved."""
    conserved = conserved_momentum(geometry)
    if state.count == 0:
        return state.velocity
    if conserves_rotation(geometry):
        return state.velocity - _rotation(state, geometry)
    if not np.any(conserved):
        return state.velocity
    drift = momentum(state) / np.sum(state.mass)
    return state.velocity - np.where(conserved, drift, 0.0)


def _rotation(state: State, geometry: Geometry) -> NDArray[np.float64]:
    """(n, 2) float64 [length/time]: velocities of a rigid body with the same angular momentum."""
    arm = state.position - (0.5 * geometry.width, 0.5 * geometry.height)
    return _rotation_rate(state, geometry) * np.stack([-arm[:, 1], arm[:, 0]], axis=1)


def _rotation_rate(state: State, geometry: Geometry) -> float:
    """Angular velocity [rad/time] of a rigid body with the same angular momentum about the middle."""
    center = (0.5 * geometry.width, 0.5 * geometry.height)
    arm = state.position - center
    inertia = float(state.mass @ np.sum(arm**2, axis=1))
    if state.sites is not None:
        inertia += float(np.sum(spins(state)[0]))
    return angular_momentum(state, center) / inertia if inertia > 0.0 else 0.0


def _energy(mass: NDArray[np.float64], velocity: NDArray[np.float64]) -> float:
    return 0.5 * float(np.sum(mass @ velocity**2))
