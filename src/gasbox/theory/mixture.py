"""Mixtures of hard discs: contact values of each pair of species, and the pressure.

The contact values interpolate between point particles and the pure fluid,
chi_ij = 1/(1 - eta) + [chi(eta) - 1/(1 - eta)] z_ij with z_ij = (sigma_i sigma_j/sigma_ij) <sigma>/<sigma²>,
sigma_ij = R_i + R_j, and averages over the particles. From them the pressure follows exactly,
Z = 1 + (pi n/2) sum_ij x_i x_j sigma_ij² chi_ij = (1 - r)/(1 - eta) + r Z(eta), r = <sigma>²/<sigma²>.
Species that are alike give the pure fluid. With Henderson's chi these are the values of Jenkins and Mancini.

Source: A. Santos, S. B. Yuste and M. López de Haro, Mol. Phys. 96, 1 (1999), doi:10.1080/00268979909482932;
J. T. Jenkins and F. Mancini, J. Appl. Mech. 54, 27 (1987).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gasbox.theory.hard_disc import EQUATIONS, contact_value

__all__ = ["Mixture", "compressibility", "contact_values", "ideal_pressure", "pressure"]


@dataclass(frozen=True)
class Mixture:
    """What theory must know of a gas: how many discs of which mass and size in which area.

    Attributes
    ----------
    count : (species,) float64, number of particles
    mass : (species,) float64 [mass]
    radius : (species,) float64 [length]
    area : [length²], the whole area of the box
    """

    count: NDArray[np.float64]
    mass: NDArray[np.float64]
    radius: NDArray[np.float64]
    area: float

    @classmethod
    def of(cls, count: ArrayLike, mass: ArrayLike, radius: ArrayLike, area: float) -> Mixture:
        """A mixture from lists, arrays or single numbers."""
        counts, masses, radii = (np.atleast_1d(np.asarray(column, float)) for column in (count, mass, radius))
        return cls(counts, masses, radii, float(area))

    @property
    def total(self) -> float:
        """Number of all particles."""
        return float(np.sum(self.count))

    @property
    def density(self) -> NDArray[np.float64]:
        """(species,) float64 [1/length²]: number of each species per area."""
        return self.count / self.area

    @property
    def area_fraction(self) -> float:
        """Share of the area that discs cover."""
        return float(np.sum(self.count * math.pi * self.radius**2) / self.area)

    @property
    def contact_distance(self) -> NDArray[np.float64]:
        """(species, species) float64 [length]: distance of the centres at contact, R_i + R_j."""
        return self.radius[:, None] + self.radius[None, :]

    @property
    def reduced_mass(self) -> NDArray[np.float64]:
        """(species, species) float64 [mass]: m_i m_j/(m_i + m_j)."""
        return self.mass[:, None] * self.mass[None, :] / (self.mass[:, None] + self.mass[None, :])


def contact_values(mixture: Mixture, equation: str = "kolafa-rottner") -> NDArray[np.float64]:
    """(species, species) float64: chi_ij of each pair; not a number outside the equation's range."""
    sigma = 2.0 * mixture.radius
    points = 1.0 / (1.0 - mixture.area_fraction)
    second_moment = float(np.sum(mixture.count * sigma**2))
    if second_moment == 0.0:
        return np.full_like(mixture.contact_distance, points)
    size = float(np.sum(mixture.count * sigma)) / second_moment
    weight = sigma[:, None] * sigma[None, :] / mixture.contact_distance * size
    excess = contact_value(mixture.area_fraction, equation) - points
    return points + excess * weight


def compressibility(mixture: Mixture, equation: str = "kolafa-rottner") -> float:
    """Z = P A/(N T) of the mixture; not a number outside the equation's range."""
    if equation == "ideal" or mixture.total == 0.0:
        return 1.0
    eta = mixture.area_fraction
    share = mixture.count / mixture.total
    second_moment = float(np.sum(share * mixture.radius**2))
    r = float(np.sum(share * mixture.radius)) ** 2 / second_moment if second_moment > 0.0 else 0.0
    return (1.0 - r) / (1.0 - eta) + r * float(EQUATIONS[equation](eta))


def ideal_pressure(mixture: Mixture, temperature: float) -> float:
    """P = N T/A [mass/time²] of points that do not meet."""
    return mixture.total * temperature / mixture.area


def pressure(mixture: Mixture, temperature: float, equation: str = "kolafa-rottner") -> float | None:
    """P = Z N T/A [mass/time²] at the nominal area fraction; None outside the equation's range."""
    value = compressibility(mixture, equation) * ideal_pressure(mixture, temperature)
    return value if math.isfinite(value) else None
