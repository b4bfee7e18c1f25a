"""How fast the particles of a species are, and where their centre of mass lies."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.state import State

__all__ = ["center_of_mass", "mean_speed", "rms_speed", "speeds"]


def speeds(state: State, species: int | None = None) -> NDArray[np.float64]:
    """(n,) float64 [length/time]: speeds of one species, or of all particles."""
    velocity = state.velocity if species is None else state.velocity[state.species == species]
    return np.sqrt(velocity[:, 0] ** 2 + velocity[:, 1] ** 2)


def mean_speed(state: State, species: int | None = None) -> float | None:
    """Mean speed of one species, or of all particles [length/time]; None without particles."""
    values = speeds(state, species)
    return float(np.mean(values)) if values.size else None


def rms_speed(state: State, species: int | None = None) -> float | None:
    """Root of the mean squared speed of one species, or of all [length/time]; None without particles."""
    values = speeds(state, species)
    return math.sqrt(float(np.mean(values**2))) if values.size else None


def center_of_mass(
    state: State, geometry: Geometry, species: int | None = None
) -> NDArray[np.float64] | None:
    """(2,) float64 [length]: centre of mass of one species, or of all particles; None without any.

    Along a periodic direction there is no first and no last place, so the mean is taken on the circle: the
    angle of the mass-weighted sum of exp(2 pi i x/width). Of an evenly spread gas it means little.

    Source: L. Bai and D. Breen, J. Graphics Tools 13, 53 (2008), doi:10.1080/2151237X.2008.10129266.
    """
    mine = slice(None) if species is None else state.species == species
    position, mass = state.position[mine], state.mass[mine]
    if mass.size == 0:
        return None
    center: NDArray[np.float64] = np.sum(mass[:, None] * position, axis=0) / np.sum(mass)
    for axis in np.flatnonzero(geometry.periodic):
        center[axis] = _circular_mean(position[:, axis], mass, float(geometry.size[axis]))
    return center


def _circular_mean(place: NDArray[np.float64], mass: NDArray[np.float64], length: float) -> float:
    angle = 2.0 * math.pi / length * place
    mean = math.atan2(float(np.sum(mass * np.sin(angle))), float(np.sum(mass * np.cos(angle))))
    center = mean / (2.0 * math.pi) * length
    # A tiny negative number plus the length would round to the length itself, which is outside the box.
    return center % length if center % length < length else 0.0
