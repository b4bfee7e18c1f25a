"""Gases of molecules that rotate: laws of rotation and of the whole energy, heat capacity, adiabat, free turning.

In equilibrium each quadratic degree of freedom has T/2 on average. A disc has f = 2 of them, a rigid molecule f = 3, a
flexible one of k discs f = 2k of motion. The angular velocity follows the normal law with variance T/I, the energy of
rotation T/2 times chi-square of one degree, the kinetic energy of a whole molecule Gamma's law of shape f/2, and the
speed of its centre of mass Rayleigh's, as that of a disc (`maxwell`).

Functions take a float or an array first and return the same; temperature and inertia > 0.

Source: L. D. Landau and E. M. Lifshitz, Statistical Physics, Part 1, 3rd ed. (1980), sections 29 and 44, in two
dimensions.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gasbox.theory.real import Real, pick

__all__ = [
    "adiabatic_exponent",
    "angular_velocity_cdf",
    "angular_velocity_pdf",
    "body_inertia",
    "disc_inertia",
    "dumbbell_inertia",
    "energy_cdf",
    "energy_pdf",
    "free_turning",
    "heat_capacity",
    "mean_energy",
    "mean_order",
]


def disc_inertia(mass: float, radius: float) -> float:
    """m R²/2 of a uniform disc about its centre [mass·length²]."""
    return 0.5 * mass * radius**2


def dumbbell_inertia(mass: float, radius: float, length: float) -> float:
    """m (R²/2 + l²/4) of two equal uniform discs whose centres are l apart; `mass` of both [mass·length²]."""
    return mass * (0.5 * radius**2 + 0.25 * length**2)


def body_inertia(mass: ArrayLike, radius: ArrayLike, place: ArrayLike) -> float:
    """Sum of m (d² + R²/2) of uniform discs about their common centre of mass [mass·length²].

    Parameters
    ----------
    mass, radius : (k,) [mass], [length]
    place : (k, 2) [length], in any frame
    """
    weight, where = np.asarray(mass, np.float64), np.asarray(place, np.float64)
    arm = where - weight @ where / np.sum(weight)
    return float(weight @ (np.sum(arm**2, axis=1) + 0.5 * np.asarray(radius, np.float64) ** 2))


def mean_energy(temperature: float, freedom: float) -> float:
    """f T/2 [energy], of one molecule."""
    return 0.5 * freedom * temperature


def heat_capacity(freedom: float) -> float:
    """C_V = f/2 of one molecule, with k_B = 1; hard bodies at any density, points with nothing between them."""
    return 0.5 * freedom


def adiabatic_exponent(freedom: float) -> float:
    """(f + 2)/f of a dilute gas: 2 of discs, 5/3 of rigid molecules. P A^gamma and T A^(2/f) are constant."""
    return (freedom + 2.0) / freedom


def angular_velocity_pdf(rate: Real, inertia: float, temperature: float) -> Real:
    """Probability density of the angular velocity: normal with variance T/I [time/rad]."""
    spread = math.sqrt(temperature / inertia)
    density: Real = np.exp(-0.5 * (rate / spread) ** 2) / (math.sqrt(2.0 * math.pi) * spread)
    return density


def angular_velocity_cdf(rate: Real, inertia: float, temperature: float) -> Real:
    """Probability of an angular velocity below `rate`."""
    share: Real = 0.5 * (1.0 + _erf(rate * math.sqrt(0.5 * inertia / temperature)))
    return share


def energy_pdf(energy: Real, temperature: float, freedom: int) -> Real:
    """Probability density of the energy of f degrees of freedom: Gamma's law of shape f/2 [1/energy].

    f = 1 is the energy of rotation, 3 all of a rigid molecule. Zero below zero; at zero it is infinite for f = 1.
    """
    share = np.asarray(energy, np.float64) / temperature
    above = np.where(share > 0.0, share, 1.0)
    log = (0.5 * freedom - 1.0) * np.log(above) - above - math.lgamma(0.5 * freedom)
    at_zero = math.inf if freedom == 1 else float(freedom == 2) / temperature
    density: Real = pick(share > 0.0, np.exp(log) / temperature, np.where(share == 0.0, at_zero, 0.0))
    return density


def energy_cdf(energy: Real, temperature: float, freedom: int) -> Real:
    """Probability that f degrees of freedom have less energy than this; f >= 1, a whole number.

    1 - exp(-E/T) for f = 2 and erf(sqrt(E/T)) for f = 1, and from f to f + 2 as the incomplete Gamma function goes.
    """
    share = np.maximum(np.asarray(energy, np.float64) / temperature, 0.0)
    below = -np.expm1(-share) if freedom % 2 == 0 else np.asarray(_erf(np.sqrt(share)))
    for shape in np.arange(1.0 if freedom % 2 == 0 else 0.5, 0.5 * freedom):
        below = below - share**shape * np.exp(-share) / math.gamma(shape + 1.0)
    shown: Real = pick(True, below, 0.0)
    return shown


def free_turning(time: Real, inertia: float, temperature: float, fold: int = 1) -> Real:
    """Mean cos(m (angle(t) - angle(0))) of molecules that nobody meets: exp(-m² T t²/(2 I)), m = `fold`."""
    mean: Real = np.exp(-0.5 * fold**2 * temperature / inertia * np.square(time))
    return mean


def mean_order(count: float) -> float:
    """Mean nematic order of so many molecules at random, sqrt(pi/(4N)): what chance alone makes of a few.

    The modulus of a mean of N unit vectors, for large N.
    """
    return math.sqrt(0.25 * math.pi / count)


def _erf(value: Real) -> Real:
    """The error function of a float or an array."""
    values = np.asarray(value, np.float64)
    each = np.array([math.erf(one) for one in values.ravel()]).reshape(values.shape)
    shown: Real = pick(True, each, 0.0)
    return shown
