"""Dilute gases with forces: the second virial coefficient of any pair law, in two dimensions.

P/T = n + B_2 n² + ..., with B_2(T) = -pi integral of (exp(-u/T) - 1) r dr.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.theory.pair_laws import PairLaw, cutoff_of, potential

__all__ = ["boyle_temperature", "second_virial", "virial_gas_pressure"]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(40)
_PANELS: Final = 40
_FAR: Final = 4.0
"""Distance in units of sigma from which an infinite range is integrated over 1/r."""


def second_virial(law: PairLaw, temperature: float) -> float:
    """B_2 [length²] of a pair law, by Gauss-Legendre quadrature.

    Parameters
    ----------
    temperature : > 0 [energy]

    Source: D. A. McQuarrie, Statistical Mechanics (1976), chapter 12, in two dimensions.
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


def virial_gas_pressure(law: PairLaw, density: float, temperature: float) -> float:
    """n T (1 + B_2 n) [mass/time²], for a dilute gas of n discs per area [1/length²]."""
    return density * temperature * (1.0 + second_virial(law, temperature) * density)


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


def _panels(low: float, high: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Nodes and weights of equal panels between two places."""
    edges = np.linspace(low, high, _PANELS + 1)
    half = 0.5 * np.diff(edges)
    nodes = (edges[:-1] + half)[:, None] + half[:, None] * _NODES
    return nodes.ravel(), (half[:, None] * _WEIGHTS).ravel()
