"""What changes in a small gas of fixed energy: exact factors for few degrees of freedom.

With f quadratic degrees of freedom and fixed total energy the velocities are spread evenly over a sphere in
f dimensions; Maxwell's law is the limit of large f. f is 2N between walls, one less for each periodic
direction.
 T = 2K/f always, with K in the frame of the centre of mass where momentum is conserved.

Source: J. R. Ray and H. W. Graben, Phys. Rev. A 44, 6905 (1991), doi:10.1103/PhysRevA.44.6905.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from gasbox.theory.real import Real, pick

__all__ = ["energy_share", "finite_energy_cdf", "finite_energy_pdf", "rate_factor"]

_SERIES_FROM: Final = 200.0
"""Degrees of freedom from which the asymptotic series is exact to the last bit."""


def rate_factor(freedom: float) -> float:
    """Collision rate at fixed energy over Maxwell's at the same T: 1.128 for f = 2, 1 + 1/(4f) for many.

    Gamma(f/2) sqrt(f/2)/Gamma((f+1)/2), from the mean relative speed on the sphere. It holds where momentum
    is conserved too, because the relative velocity of two particles does not see the centre of mass.
    """
    x = 0.5 * freedom
    if freedom >= _SERIES_FROM:
        y = 1.0 / (8.0 * x)
        return 1.0 / (1.0 - y + y**2 / 2.0 + 5.0 * y**3 / 2.0 - 21.0 * y**4 / 8.0)
    return math.sqrt(x) * math.exp(math.lgamma(x) - math.lgamma(x + 0.5))


def energy_share(mass: float, total_mass: float, conserved: int) -> float:
    """Mean kinetic energy of a particle, in the frame of the centre of mass, over T: 1 - (conserved/2) m/M.

    Parameters
    ----------
    mass, total_mass : of the particle and of all [mass]
    conserved : components of the total momentum that are conserved (the number of periodic directions)
    """
    return 1.0 - 0.5 * conserved * mass / total_mass


def finite_energy_cdf(energy: Real, greatest: float, freedom: float) -> Real:
    """Probability that one particle has a kinetic energy below `energy`, at fixed total energy.

    1 - (1 - E/E_max)^(f/2 - 1), for two or no conserved components of momentum.

    Parameters
    ----------
    energy : [energy]
    greatest : E_max, all that one particle can have: the total, or where momentum is conserved the total in
        the frame of the centre of mass times 1 - m/M
    freedom : f of the whole gas, > 2
    """
    rest: Real = 1.0 - np.clip(energy / greatest, 0.0, 1.0)
    below: Real = 1.0 - rest ** (0.5 * freedom - 1.0)
    return below


def finite_energy_pdf(energy: Real, greatest: float, freedom: float) -> Real:
    """Probability density of one particle's kinetic energy at fixed total energy; as `finite_energy_cdf`."""
    share = np.asarray(energy) / greatest
    power = 0.5 * freedom - 1.0
    inside = np.logical_and(np.greater_equal(share, 0.0), np.less(share, 1.0))
    rest = np.where(inside, 1.0 - share, 1.0)
    density: Real = pick(inside, power / greatest * rest ** (power - 1.0), 0.0)
    return density
