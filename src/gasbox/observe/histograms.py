"""Histograms of speeds, energies and angular velocities, and where their axes end when nobody says."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.energy import species_temperature, temperature
from gasbox.observe.motion import speeds
from gasbox.observe.rotation import rotational_energies, spins, vibrational_energies
from gasbox.state import State
from gasbox.theory.ranges import Measure, Quantity, histogram_maximum, rounded_up

__all__ = [
    "Histogram",
    "automatic_maximum",
    "bin_edges",
    "energies",
    "energy_histogram",
    "histogram",
    "speed_histogram",
    "values",
]


@dataclass(frozen=True)
class Histogram:
    """Numbers of particles in half-open bins, edges[i] <= value < edges[i+1].

    Attributes
    ----------
    edges : (bins+1,) float64, ascending
    counts : (bins,) float64, number of particles (a mean over frames need not be whole)
    underflow, overflow : how many lie below the first edge, and at or above the last
    """

    edges: NDArray[np.float64]
    counts: NDArray[np.float64]
    underflow: float
    overflow: float

    @property
    def total(self) -> float:
        """Number of particles, those outside the axis included."""
        return float(np.sum(self.counts)) + self.underflow + self.overflow

    @classmethod
    def of(cls, values: NDArray[np.float64], edges: NDArray[np.float64]) -> Histogram:
        """The histogram of some values."""
        place = np.bincount(np.searchsorted(edges, values, side="right"), minlength=edges.size + 1)
        return cls(edges, place[1:-1].astype(np.float64), float(place[0]), float(place[-1]))


def bin_edges(bins: int, minimum: float, maximum: float) -> NDArray[np.float64]:
    """(bins+1,) float64: edges of equally wide bins."""
    return np.linspace(minimum, maximum, bins + 1)


def energies(state: State, species: int | None = None) -> NDArray[np.float64]:
    """(n,) float64 [energy]: kinetic energies of one species, or of all particles."""
    mass = state.mass if species is None else state.mass[state.species == species]
    return 0.5 * mass * speeds(state, species) ** 2


def speed_histogram(state: State, species: int | None, edges: NDArray[np.float64]) -> Histogram:
    """Histogram of the speeds of one species, or of all particles for None; edges [length/time]."""
    return Histogram.of(speeds(state, species), edges)


def energy_histogram(state: State, species: int | None, edges: NDArray[np.float64]) -> Histogram:
    """Histogram of the kinetic energies of one species, or of all particles for None; edges [energy]."""
    return Histogram.of(energies(state, species), edges)


def histogram(
    state: State, species: int | None, edges: NDArray[np.float64], quantity: Measure = "speed"
) -> Histogram:
    """Histogram of any quantity."""
    return Histogram.of(values(state, species, quantity), edges)


def values(state: State, species: int | None, quantity: Measure) -> NDArray[np.float64]:
    """(k,) float64: a quantity of all particles of one kind, or of the whole gas.

    Speeds [length/time] and energies [energy] are those of the centres of mass, but for the energy of rotation and the
    whole kinetic energy, which a molecule has in all its degrees of freedom; angular velocities are in [rad/time]. What
    does not rotate has neither an angular velocity nor an energy of rotation.
    """
    mine = np.ones(state.count, np.bool_) if species is None else state.species == species
    if quantity == "speed":
        return speeds(state, species)
    if quantity == "energy":
        return energies(state, species)
    if quantity == "whole-energy":
        within = rotational_energies(state) + vibrational_energies(state)
        whole: NDArray[np.float64] = energies(state, species) + within[mine]
        return whole
    inertia, turning = spins(state)
    mine &= inertia > 0.0
    found = turning if quantity == "angular-velocity" else 0.5 * inertia * turning**2
    chosen: NDArray[np.float64] = found[mine]
    return chosen


def automatic_maximum(state: State, geometry: Geometry, species: int, quantity: Quantity = "speed") -> float:
    """A round end for the axis of one species, from theory; ask once, at the start, and keep it.

    It holds 99.9 % of Maxwell's law at the temperature of the gas, to which the species will come, or at its
    own, if it starts hotter. For one axis for all species take the largest. A gas at rest gets its fastest
    value, or 1.
    """
    hottest = max(temperature(state, geometry) or 0.0, species_temperature(state, geometry, species) or 0.0)
    mine = state.mass[state.species == species]
    end = histogram_maximum(float(mine[0]), hottest, quantity) if mine.size else None
    if end is not None:
        return end
    fastest = float(np.max(values(state, species, quantity), initial=0.0))
    return rounded_up(fastest) if fastest > 0.0 else 1.0
