"""A gas whose area changes: temperature and pressure along an adiabat, work, and entropy.

Both adiabat and isotherm need the same integral, C = int Z dA/A from the new area to the old: ln(A/A') + F'
- F with the excess free energy F of `fluid`. Slowly and without heat, ln(T'/T) = (2/f) C, and the work done on
the gas is (f/2) N (T' - T), positive in compression; slowly at a kept temperature it is N T C. A free expansion
does none: hard discs keep their temperature, because their energy is all kinetic.

Slowly means walls much slower than the particles, u << sqrt(T/m); the excess work is of order u sqrt(m/T).
Functions take a float or an array first and return the same. f is the number of quadratic degrees of freedom
of one particle (2, with rotation 3). Areas are those by which area fractions are reckoned; where discs are not
small against the box, it is better to use those that centres can reach. Outside the range of the equation
functions give not-a-number.

Source: H. B. Callen, Thermodynamics and an Introduction to Thermostatistics, 2nd ed. (Wiley, 1985), chs. 3 and
4, with P dA in place of P dV.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gasbox.theory.fluid import compressibility, excess_free_energy
from gasbox.theory.real import Real

__all__ = [
    "adiabatic_pressure",
    "adiabatic_temperature",
    "adiabatic_work",
    "expansion_entropy",
    "ideal_temperature",
    "isothermal_work",
    "mixing_entropy",
    "spreading_entropy",
]


def ideal_temperature(new_area: Real, temperature: float, area: float, freedom: float = 2.0) -> Real:
    """T' with T A^(2/f) constant: what points have after a slow change of area without heat [energy]."""
    new: Real = temperature * (area / new_area) ** (2.0 / freedom)
    return new


def adiabatic_temperature(
    new_area: Real,
    temperature: float,
    count: float,
    radius: float,
    area: float,
    equation: str = "kolafa-rottner",
    freedom: float = 2.0,
) -> Real:
    """T' with ln(T'/T) = (2/f) int Z d eta/eta: after a slow change of area without heat [energy].

    Parameters
    ----------
    new_area : A' [length²]
    temperature, area : T and A before [energy], [length²]
    count : number of discs
    radius : of a disc [length]
    equation : a name in `hard_disc.EQUATIONS`
    freedom : f of one disc
    """
    compression = _compression(new_area, count, radius, area, equation)
    new: Real = temperature * np.exp(2.0 / freedom * compression)
    return new


def adiabatic_pressure(
    new_area: Real,
    temperature: float,
    count: float,
    radius: float,
    area: float,
    equation: str = "kolafa-rottner",
    freedom: float = 2.0,
) -> Real:
    """P' = Z' N T'/A' along the adiabat [mass/time²]; as `adiabatic_temperature`."""
    new = adiabatic_temperature(new_area, temperature, count, radius, area, equation, freedom)
    z = compressibility(_area_fraction(new_area, count, radius), equation)
    return z * count * new / new_area


def adiabatic_work(
    new_area: Real,
    temperature: float,
    count: float,
    radius: float,
    area: float,
    equation: str = "kolafa-rottner",
    freedom: float = 2.0,
) -> Real:
    """Work done on the gas along the adiabat, (f/2) N (T' - T) [energy]; as `adiabatic_temperature`."""
    compression = _compression(new_area, count, radius, area, equation)
    work: Real = 0.5 * freedom * count * temperature * np.expm1(2.0 / freedom * compression)
    return work


def isothermal_work(
    new_area: Real,
    temperature: float,
    count: float,
    radius: float,
    area: float,
    equation: str = "kolafa-rottner",
) -> Real:
    """Work done on the gas, and given off as heat, in a slow change of area at constant temperature [energy].

    N T (ln(A/A') + F' - F); of points N T ln(A/A'). Parameters as for `adiabatic_temperature`.
    """
    return count * temperature * _compression(new_area, count, radius, area, equation)


def expansion_entropy(
    new_area: Real, count: float, radius: float, area: float, equation: str = "kolafa-rottner"
) -> Real:
    """Entropy that a free expansion makes, N (ln(A'/A) + F - F'); of points N ln(A'/A).

    Parameters as for `adiabatic_temperature`.
    """
    return -count * _compression(new_area, count, radius, area, equation)


def mixing_entropy(counts: ArrayLike) -> float:
    """Entropy of mixing of species in parts of a box, -sum N_is ln(N_is/N_s), N_s all particles in part s.

    0 where no part holds two species; N ln 2 for two species alike in number, evenly mixed.

    Parameters
    ----------
    counts : (species, parts), particles of each species in each part
    """
    number = np.atleast_2d(np.asarray(counts, dtype=np.float64))
    return -_entropy_sum(number, np.broadcast_to(np.sum(number, axis=0), number.shape))


def spreading_entropy(counts: ArrayLike, areas: ArrayLike) -> float:
    """Entropy of points spread over parts of a box, less that when spread evenly: at most 0.

    -sum N_is ln(N_is A/(N_i A_s)): -N ln 2 if all are in one half. What it gains is what the free expansion
    of `expansion_entropy` makes, for each species by itself.

    Parameters
    ----------
    counts : (species, parts), particles of each species in each part
    areas : (parts,) area of each part [length²], > 0
    """
    number = np.atleast_2d(np.asarray(counts, dtype=np.float64))
    share = np.asarray(areas, dtype=np.float64) / np.sum(areas)
    return -_entropy_sum(number, np.sum(number, axis=1)[:, None] * share)


def _entropy_sum(number: NDArray[np.float64], reference: NDArray[np.float64]) -> float:
    """sum N ln(N/reference), where nothing counts as nothing."""
    held = number > 0.0
    return float(np.sum(number[held] * np.log(number[held] / reference[held])))


def _area_fraction(area: Real, count: float, radius: float) -> Real:
    """N pi R²/A of an area or an array of them."""
    return count * math.pi * radius**2 / area


def _compression(new_area: Real, count: float, radius: float, area: float, equation: str) -> Real:
    """C = int Z dA/A from `new_area` to `area`."""
    old = excess_free_energy(_area_fraction(area, count, radius), equation)
    new = excess_free_energy(_area_fraction(new_area, count, radius), equation)
    value: Real = np.log(area / new_area) + new - old
    return value
