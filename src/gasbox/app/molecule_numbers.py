"""The energies of one particle: of its flight, its rotation, and of what moves within it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gasbox.state import State

__all__ = ["Energies", "energies_of"]


@dataclass(frozen=True)
class Energies:
    """Kinetic energies of one particle.

    Attributes
    ----------
    translational : of its centre of mass [energy]
    rotational : about it [energy]; None for what does not turn
    vibrational : of the rest [energy]; None for what is rigid
    angular_velocity : [rad/time], counter-clockwise; 0 for what does not turn
    """

    translational: float
    rotational: float | None = None
    vibrational: float | None = None
    angular_velocity: float = 0.0


def energies_of(state: State, row: int) -> Energies:
    """Of the particle in this row."""
    velocity = state.velocity[row]
    flight = 0.5 * float(state.mass[row]) * float(velocity @ velocity)
    if state.sites is None or state.inertia[row] == 0.0:
        return Energies(flight)
    if not state.sites.flexible[row]:
        turning = float(state.angular_velocity[row])
        return Energies(flight, 0.5 * float(state.inertia[row]) * turning**2, None, turning)
    own = slice(int(state.sites.first[row]), int(state.sites.first[row + 1]))
    mass = state.sites.mass[own]
    arm = state.sites.position[own] - state.position[row]
    motion = state.sites.velocity[own] - velocity
    spin = float(mass @ (arm[:, 0] * motion[:, 1] - arm[:, 1] * motion[:, 0]))
    inertia = float(mass @ np.einsum("ij,ij->i", arm, arm))
    rotation = 0.5 * spin**2 / inertia
    inner = 0.5 * float(mass @ np.einsum("ij,ij->i", motion, motion))
    return Energies(flight, rotation, max(inner - rotation, 0.0), spin / inertia)
