"""The Maxwell-Boltzmann laws in two dimensions: how speeds and kinetic energies are distributed.

With s² = T/m (k_B = 1) the speed follows Rayleigh's law, (v/s²) exp(-v²/2s²), and the kinetic energy an
exponential one, exp(-E/T)/T, whatever the mass. The first is the second with E = m v²/2, and is written so
here.

Functions take a float or an array for their first argument and return the same; mass and temperature are
floats, mass > 0 and temperature >= 0. At temperature zero everything rests: a step at zero.

Source: S. Chapman and T. G. Cowling, The Mathematical Theory of Non-Uniform Gases, 3rd ed. (Cambridge, 1970),
ch. 4, with two velocity components in place of three.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.theory.real import Real, pick

__all__ = [
    "energy_cdf",
    "energy_pdf",
    "energy_quantile",
    "energy_survival",
    "expected_energy_counts",
    "expected_speed_counts",
    "mean_energy",
    "mean_speed",
    "median_speed",
    "most_probable_speed",
    "rms_speed",
    "speed_cdf",
    "speed_pdf",
    "speed_quantile",
    "speed_survival",
    "speed_variance",
]


def most_probable_speed(mass: float, temperature: float) -> float:
    """Speed at the peak of Rayleigh's law, s = sqrt(T/m) [length/time]."""
    return math.sqrt(temperature / mass)


def median_speed(mass: float, temperature: float) -> float:
    """Speed that half of the particles exceed, s sqrt(2 ln 2) [length/time]."""
    return math.sqrt(2.0 * math.log(2.0)) * most_probable_speed(mass, temperature)


def mean_speed(mass: float, temperature: float) -> float:
    """Mean speed, s sqrt(pi/2) [length/time]."""
    return math.sqrt(0.5 * math.pi) * most_probable_speed(mass, temperature)


def rms_speed(mass: float, temperature: float) -> float:
    """Root of the mean squared speed, s sqrt(2) [length/time]."""
    return math.sqrt(2.0) * most_probable_speed(mass, temperature)


def speed_variance(mass: float, temperature: float) -> float:
    """Variance of the speed, (2 - pi/2) s² [length²/time²]."""
    return (2.0 - 0.5 * math.pi) * temperature / mass


def mean_energy(temperature: float) -> float:
    """Mean kinetic energy of a particle, T [energy]: two components with T/2 each."""
    return temperature


def energy_survival(energy: Real, temperature: float) -> Real:
    """Probability of a kinetic energy of at least `energy`, exp(-E/T); 1 at and below zero."""
    above = np.maximum(energy, 0.0)
    if temperature == 0.0:
        step: Real = pick(above > 0.0, 0.0, 1.0)
        return step
    share: Real = np.exp(-above / temperature)
    return share


def energy_cdf(energy: Real, temperature: float) -> Real:
    """Probability of a kinetic energy below `energy`, 1 - exp(-E/T)."""
    above = np.maximum(energy, 0.0)
    if temperature == 0.0:
        step: Real = pick(above > 0.0, 1.0, 0.0)
        return step
    share: Real = -np.expm1(-above / temperature)
    return share


def energy_pdf(energy: Real, temperature: float) -> Real:
    """Probability density of the kinetic energy, exp(-E/T)/T [1/energy]; needs temperature > 0."""
    density: Real = pick(np.less(energy, 0.0), 0.0, energy_survival(energy, temperature) / temperature)
    return density


def energy_quantile(probability: Real, temperature: float) -> Real:
    """Kinetic energy below which this share of the particles lies, -T ln(1 - p) [energy]; 0 <= p < 1."""
    energy: Real = -temperature * np.log1p(-probability)
    return energy


def speed_survival(speed: Real, mass: float, temperature: float) -> Real:
    """Probability of a speed of at least `speed`, exp(-m v²/2T); 1 at and below zero."""
    above: Real = np.maximum(speed, 0.0)
    return energy_survival(0.5 * mass * above * above, temperature)


def speed_cdf(speed: Real, mass: float, temperature: float) -> Real:
    """Probability of a speed below `speed`, 1 - exp(-m v²/2T)."""
    above: Real = np.maximum(speed, 0.0)
    return energy_cdf(0.5 * mass * above * above, temperature)


def speed_pdf(speed: Real, mass: float, temperature: float) -> Real:
    """Probability density of the speed, (m v/T) exp(-m v²/2T) [time/length]; needs temperature > 0."""
    above: Real = np.maximum(speed, 0.0)
    return mass * above / temperature * speed_survival(above, mass, temperature)


def speed_quantile(probability: Real, mass: float, temperature: float) -> Real:
    """Speed below which this share of the particles lies, s sqrt(-2 ln(1 - p)) [length/time]; 0 <= p < 1."""
    speed: Real = np.sqrt(2.0 / mass * energy_quantile(probability, temperature))
    return speed


def expected_speed_counts(
    edges: NDArray[np.float64], count: float, mass: float, temperature: float
) -> NDArray[np.float64]:
    """How many of `count` particles the law puts into each bin.

    Parameters
    ----------
    edges : (bins+1,) float64 [length/time], ascending
    count : number of particles
    mass, temperature : [mass], [energy]

    Returns
    -------
    (bins,) float64: exact integrals of the law over the bins, not values at their middles.
    """
    return count * -np.diff(speed_survival(edges, mass, temperature)) + 0.0


def expected_energy_counts(
    edges: NDArray[np.float64], count: float, temperature: float
) -> NDArray[np.float64]:
    """How many of `count` particles the law puts into each bin of energy; as `expected_speed_counts`."""
    return count * -np.diff(energy_survival(edges, temperature)) + 0.0
