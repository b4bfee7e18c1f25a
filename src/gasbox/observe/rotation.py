"""Energies of rotation and vibration of molecules, one by one.

A rigid molecule with angular velocity w has I w²/2 of rotation. The sites of a flexible one are points: of their
kinetic energy in the frame of the centre of mass, J²/(2I) is rotation, with the angular momentum J and the moment of
inertia I of the present places, and the rest is vibration.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.state import State

__all__ = [
    "degrees_of_rotation",
    "degrees_of_vibration",
    "rotational_energies",
    "spins",
    "translational_energies",
    "vibrational_energies",
]


def degrees_of_rotation(state: State) -> NDArray[np.int64]:
    """(n,) int64: 1 of each particle that rotates, 0 of the others."""
    if state.sites is None:
        return np.zeros(state.count, np.int64)
    return (state.inertia > 0.0).astype(np.int64)


def degrees_of_vibration(state: State) -> NDArray[np.int64]:
    """(n,) int64: 2k - 3 of a flexible molecule of k sites, 0 of the others."""
    if state.sites is None:
        return np.zeros(state.count, np.int64)
    return np.where(state.sites.flexible, 2 * np.diff(state.sites.first) - 3, 0)


def spins(state: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Moment of inertia (n,) [mass·length²] and angular velocity (n,) [rad/time] of each particle about its centre."""
    if state.sites is None:
        return np.zeros(state.count), np.zeros(state.count)
    if not state.sites.flexible.any():
        return state.inertia, state.angular_velocity
    inertia, spin, _ = _inside(state)
    flexible = state.sites.flexible
    turning = spin / np.maximum(inertia, 1e-300)
    return np.where(flexible, inertia, state.inertia), np.where(flexible, turning, state.angular_velocity)


def translational_energies(state: State) -> NDArray[np.float64]:
    """(n,) float64 [energy]: kinetic energy of the centre of mass of each particle."""
    energy: NDArray[np.float64] = 0.5 * state.mass * np.sum(state.velocity**2, axis=1)
    return energy


def rotational_energies(state: State, rate: float = 0.0) -> NDArray[np.float64]:
    """(n,) float64 [energy]: energy of rotation of each particle about its centre of mass.

    Parameters
    ----------
    rate : angular velocity of the frame in which it is taken [rad/time]
    """
    inertia, turning = spins(state)
    energy: NDArray[np.float64] = 0.5 * inertia * (turning - rate) ** 2
    return energy


def vibrational_energies(state: State) -> NDArray[np.float64]:
    """(n,) float64 [energy]: kinetic energy of vibration of each particle; 0 of what is rigid."""
    if state.sites is None or not state.sites.flexible.any():
        return np.zeros(state.count)
    inertia, spin, energy = _inside(state)
    rest = energy - spin**2 / (2.0 * np.maximum(inertia, 1e-300))
    return np.where(state.sites.flexible, np.maximum(rest, 0.0), 0.0)


def _inside(state: State) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Of the sites as points, about each centre of mass: moment of inertia, angular momentum, kinetic energy (n,)."""
    sites = state.sites
    assert sites is not None
    owner, begin = sites.owner, sites.first[:-1]

    def mean(values: NDArray[np.float64]) -> NDArray[np.float64]:
        total = np.add.reduceat(sites.mass[:, None] * values, begin)
        return (total / np.add.reduceat(sites.mass, begin)[:, None])[owner]

    arm = sites.position - mean(sites.position)
    velocity = sites.velocity - mean(sites.velocity)
    inertia = np.add.reduceat(sites.mass * np.sum(arm**2, axis=1), begin)
    spin = np.add.reduceat(sites.mass * (arm[:, 0] * velocity[:, 1] - arm[:, 1] * velocity[:, 0]), begin)
    energy = np.add.reduceat(0.5 * sites.mass * np.sum(velocity**2, axis=1), begin)
    return inertia, spin, energy
