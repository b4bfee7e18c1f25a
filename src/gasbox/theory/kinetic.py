"""How often discs meet and how far they fly, by Enskog's theory.

A disc of species i meets discs of species j at the rate omega_ij = 2 n_j sigma_ij chi_ij sqrt(pi T/(2
mu_ij)): density of partners, width of the swept strip, enhancement at contact, mean relative speed. In
equilibrium this is exact but for the contact value. Collision rates count pair collisions only; walls stand
apart.

Source: S. Chapman and T. G. Cowling, The Mathematical Theory of Non-Uniform Gases, 3rd ed. (Cambridge, 1970),
chs. 5 and 16, in two dimensions; D. M. Gass, J. Chem. Phys. 54, 1898 (1971), doi:10.1063/1.1675116.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.theory.maxwell import mean_speed
from gasbox.theory.mixture import Mixture, contact_values

__all__ = [
    "collision_rates",
    "equalisation_rate",
    "mean_free_path",
    "mean_free_paths",
    "pair_rates",
    "relative_speed",
    "wall_flux",
]


def relative_speed(
    mass: float, other_mass: float, temperature: float, other_temperature: float | None = None
) -> float:
    """Mean relative speed of two particles, sqrt(pi/2 (T/m + T'/m')) [length/time]; alike: sqrt(pi T/m)."""
    other = temperature if other_temperature is None else other_temperature
    return math.sqrt(0.5 * math.pi * (temperature / mass + other / other_mass))


def collision_rates(
    mixture: Mixture, temperature: float, equation: str = "kolafa-rottner"
) -> NDArray[np.float64]:
    """(species, species) float64 [1/time]: omega_ij, how often one disc of i meets any of j, in a large gas.

    Not a number where `equation` does not hold; with the ideal one nothing ever meets.
    """
    return mixture.count[None, :] * _rate_per_partner(mixture, temperature, equation)


def pair_rates(mixture: Mixture, temperature: float, equation: str = "kolafa-rottner") -> NDArray[np.float64]:
    """(species, species) float64 [1/time]: collisions per pair of species in the whole gas, for i <= j.

    A disc does not meet itself: N discs make N (N - 1)/2 like pairs, the whole 1/N correction of a dilute
    gas.
    """
    like = np.diag(0.5 * mixture.count * np.maximum(mixture.count - 1.0, 0.0))
    pairs = np.triu(np.outer(mixture.count, mixture.count), 1) + like
    return pairs * _rate_per_partner(mixture, temperature, equation)


def mean_free_paths(
    mixture: Mixture, temperature: float, equation: str = "kolafa-rottner"
) -> NDArray[np.float64]:
    """(species,) float64 [length]: mean speed over rate of pair collisions; infinite without any."""
    rates = np.sum(collision_rates(mixture, temperature, equation), axis=1)
    speeds = np.array([mean_speed(mass, temperature) for mass in mixture.mass])
    with np.errstate(divide="ignore"):
        paths: NDArray[np.float64] = speeds / rates
    return paths


def mean_free_path(mixture: Mixture, temperature: float, equation: str = "kolafa-rottner") -> float:
    """Mean path between pair collisions over all particles [length]: all paths over all their ends.

    Of one species it is 1/(2 sqrt(2) n sigma chi), whatever the temperature. Infinite if nothing meets.
    """
    rates = np.sum(collision_rates(mixture, temperature, equation), axis=1)
    speeds = np.array([mean_speed(mass, temperature) for mass in mixture.mass])
    ends = float(np.sum(mixture.count * rates))
    return float(np.sum(mixture.count * speeds)) / ends if ends != 0.0 else math.inf


def wall_flux(count: float, mass: float, accessible_area: float, temperature: float) -> float:
    """Hits on a wall per length and time of a dilute gas, n sqrt(T/(2 pi m)) [1/(length·time)].

    In a dense gas the density at the wall is P/T instead of n.
    """
    return count / accessible_area * math.sqrt(temperature / (2.0 * math.pi * mass))


def equalisation_rate(mixture: Mixture, temperature: float, equation: str = "kolafa-rottner") -> float:
    """Rate at which the temperature difference of two species dies away, near equilibrium [1/time].

    4 m_1 m_2/(m_1 + m_2)² (omega_12 + omega_21), each species taken as Maxwellian at its own temperature.
    """
    omega = collision_rates(mixture, temperature, equation)
    exchange = 4.0 * mixture.reduced_mass[0, 1] / float(np.sum(mixture.mass[:2]))
    return float(exchange * (omega[0, 1] + omega[1, 0]))


def _rate_per_partner(mixture: Mixture, temperature: float, equation: str) -> NDArray[np.float64]:
    """(species, species) float64 [1/time]: how often one disc of i meets one particular disc of j."""
    if equation == "ideal":
        return np.zeros_like(mixture.reduced_mass)
    speed = np.sqrt(0.5 * math.pi * temperature / mixture.reduced_mass)
    chi = contact_values(mixture, equation)
    return 2.0 * mixture.contact_distance * chi * speed / mixture.area
