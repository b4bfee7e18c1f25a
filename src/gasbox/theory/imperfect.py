"""Dilute gases with forces: the second and third virial coefficients of any pair law, in two dimensions.

P/T = n + B_2 n² + B_3 n³ + ..., with Mayer's f(r) = exp(-u/T) - 1 and its transform F(k), 2 pi times the integral of
f J_0(k r) r dr: B_2 = -F(0)/2, and B_3 = -1/(6 pi) times the integral of F(k)³ k dk.

Source: D. A. McQuarrie, Statistical Mechanics (1976), chapter 12, in two dimensions.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.theory.pair_laws import PairLaw, cutoff_of, potential

__all__ = ["boyle_temperature", "second_virial", "third_virial", "virial_gas_pressure"]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(40)
_PANELS: Final = 40
_END: Final = 12.0
"""In units of sigma."""
_SHORTEST: Final = 40.0
"""Largest wave number of the transform, in units of 1/sigma."""
_FINE: Final = 0.005
"""Step of a table of the Bessel function."""
_FAR: Final = 4.0
"""Distance in units of sigma from which an infinite range is integrated over 1/r."""


def second_virial(law: PairLaw, temperature: float) -> float:
    """B_2 [length²] of a pair law, by Gauss-Legendre quadrature.

    Parameters
    ----------
    temperature : > 0 [energy]
    """
    cutoff = cutoff_of(law)
    if law.law == "none":
        return 0.0
    end = cutoff if math.isfinite(cutoff) else _FAR * law.sigma
    place, weight = _panels(0.0, end)
    total = float(np.sum(weight * place * _mayer(law, place, temperature)))
    if not math.isfinite(cutoff):
        inverse, weight = _panels(0.0, 1.0 / end)
        total += float(np.sum(weight * _mayer(law, 1.0 / inverse, temperature) / inverse**3))
    return -math.pi * total


def third_virial(law: PairLaw, temperature: float) -> float:
    """B_3 [length⁴] of a pair law, to some 1e-3; laws without an end are cut at 12 sigma for it.

    Parameters
    ----------
    temperature : > 0 [energy]
    """
    if law.law == "none":
        return 0.0
    end = min(cutoff_of(law) / law.sigma, _END)
    place, weight = _panels(0.0, end * law.sigma, math.ceil(2.0 * end))
    mayer = weight * place * _mayer(law, place, temperature)
    wave, wave_weight = _panels(0.0, _SHORTEST / law.sigma, 5 + math.ceil(end))
    transform = 2.0 * math.pi * (_bessel(np.outer(wave, place)) @ mayer)
    return -float(np.sum(wave_weight * wave * transform**3)) / (6.0 * math.pi)


def virial_gas_pressure(law: PairLaw, density: float, temperature: float) -> float:
    """n T (1 + B_2 n + B_3 n²) [mass/time²], for a dilute gas of n discs per area [1/length²]."""
    second, third = second_virial(law, temperature), third_virial(law, temperature)
    return density * temperature * (1.0 + second * density + third * density**2)


def boyle_temperature(law: PairLaw) -> float:
    """Temperature at which B_2 is zero [energy], for a law with epsilon > 0 that attracts."""
    low, high = 0.05 * law.epsilon, 50.0 * law.epsilon
    for _ in range(80):
        middle = math.sqrt(low * high)
        # B_2 rises with the temperature as long as there is attraction to overcome.
        low, high = (middle, high) if second_virial(law, middle) < 0.0 else (low, middle)
    return low


def _mayer(law: PairLaw, distance: NDArray[np.float64], temperature: float) -> NDArray[np.float64]:
    """exp(-u/T) - 1."""
    with np.errstate(over="ignore"):
        energy = potential(law, distance)
    return np.expm1(np.clip(-energy / temperature, -700.0, None))


def _bessel(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """J_0 to some 1e-6, from a fine table of it."""
    table = np.linspace(0.0, float(np.max(places)), int(np.max(places) / _FINE) + 2)
    # The mean of cos(x sin a) over a circle; even steps are exact up to x a little less than their number.
    steps = int(0.25 * table[-1]) + 20
    values = np.zeros(table.size)
    for angle in math.pi * (np.arange(steps) + 0.5) / (2.0 * steps):
        values += np.cos(table * math.sin(angle))
    return np.interp(places, table, values / steps)


def _panels(
    low: float, high: float, panels: int = _PANELS
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Nodes and weights of equal panels between two places."""
    edges = np.linspace(low, high, panels + 1)
    half = 0.5 * np.diff(edges)
    nodes = (edges[:-1] + half)[:, None] + half[:, None] * _NODES
    return nodes.ravel(), (half[:, None] * _WEIGHTS).ravel()
