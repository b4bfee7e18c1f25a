"""Lennard-Jones discs in two dimensions: what truncation leaves out, and where others found their phases.

Reduced units: epsilon = sigma = m = k_B = 1. The points of the literature are for two models that are not the same:
the full law, and the one truncated at 2.5 sigma and shifted. Truncation makes the liquid less stable: its range of
temperature shrinks to some 0.41 to 0.46.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

__all__ = [
    "COEXISTENCE",
    "CRITICAL_POINTS",
    "TRIPLE_POINTS",
    "Coexistence",
    "CriticalPoint",
    "Model",
    "TriplePoint",
    "energy_tail",
    "pressure_tail",
]

Model = Literal["full", "truncated"]
"""The law without end (or with a long cutoff and corrected), or truncated at 2.5 sigma and shifted."""

_SMIT_FRENKEL: Final = "B. Smit and D. Frenkel, J. Chem. Phys. 94, 5663 (1991), doi:10.1063/1.460477"
_BARKER: Final = (
    "J. A. Barker, D. Henderson and F. F. Abraham, Physica A 106, 226 (1981), "
    "doi:10.1016/0378-4371(81)90222-3"
)


@dataclass(frozen=True)
class CriticalPoint:
    """Where liquid and gas become one.

    Attributes
    ----------
    temperature, density : [epsilon], [1/sigma²]
    temperature_error, density_error : standard errors; None where the source gives none
    """

    model: Model
    temperature: float
    density: float
    temperature_error: float | None
    density_error: float | None
    source: str


@dataclass(frozen=True)
class TriplePoint:
    """Where solid, liquid and gas are in equilibrium.

    Attributes
    ----------
    temperature : [epsilon]
    liquid, solid : densities [1/sigma²]; None where the source does not give them
    approximate : whether it is only roughly known
    """

    model: Model
    temperature: float
    liquid: float | None
    solid: float | None
    approximate: bool
    source: str


@dataclass(frozen=True)
class Coexistence:
    """Densities of gas and liquid in equilibrium at one temperature.

    Attributes
    ----------
    temperature : [epsilon]
    gas, liquid : [1/sigma²]
    gas_error, liquid_error : standard errors
    """

    model: Model
    temperature: float
    gas: float
    gas_error: float
    liquid: float
    liquid_error: float
    source: str


CRITICAL_POINTS: Final = (
    CriticalPoint("truncated", 0.459, 0.35, 0.001, 0.01, _SMIT_FRENKEL),
    CriticalPoint("full", 0.515, 0.355, 0.002, 0.003, _SMIT_FRENKEL),
    CriticalPoint("full", 0.533, 0.335, None, None, _BARKER),
)
"""Of the full model the older value is from perturbation theory and small systems, and rather high."""

TRIPLE_POINTS: Final = (
    TriplePoint("truncated", 0.41, 0.73, 0.80, True, "rough, from coexistence in small systems"),
    TriplePoint("full", 0.415, None, None, True, _BARKER),
)

COEXISTENCE: Final = tuple(
    Coexistence("truncated", *row, _SMIT_FRENKEL)
    for row in (
        (0.420, 0.037, 0.005, 0.72, 0.02),
        (0.431, 0.040, 0.002, 0.68, 0.02),
        (0.435, 0.052, 0.006, 0.676, 0.006),
        (0.440, 0.055, 0.007, 0.64, 0.02),
        (0.445, 0.07, 0.01, 0.66, 0.02),
        (0.455, 0.11, 0.01, 0.60, 0.03),
        (0.456, 0.11, 0.02, 0.62, 0.02),
        (0.457, 0.12, 0.03, 0.60, 0.03),
    )
)
"""By Gibbs-ensemble Monte Carlo, in the order of temperature."""


def energy_tail(density: float, cutoff: float) -> float:
    """Energy of each disc [epsilon] from beyond the cutoff [sigma], as if all stood there at random (g = 1)."""
    return math.pi * density * (0.4 * cutoff**-10 - cutoff**-4)


def pressure_tail(density: float, cutoff: float) -> float:
    """Pressure [epsilon/sigma²] from beyond the cutoff [sigma], likewise.

    Source of both: M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), chapter 2, in
    two dimensions.
    """
    return math.pi * density**2 * (2.4 * cutoff**-10 - 3.0 * cutoff**-4)
