"""The fluid of equal hard discs: compressibility Z = P A/(N T) and contact value chi at an area fraction.

The area fraction is eta = n pi sigma²/4, with the density n = N/A and the diameter sigma. The pressure
follows from the contact value of the pair distribution, Z = 1 + 2 eta chi (exact in two dimensions), so
that each equation of state gives both.

Functions take a float or an array and return the same; outside their range they give not-a-number.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

import numpy as np

from gasbox.theory import kolafa_rottner as fit
from gasbox.theory.kolafa_rottner import finite_compressibility
from gasbox.theory.real import Real, pick

__all__ = [
    "EQUATIONS",
    "RANGE",
    "area_fraction",
    "contact_value",
    "finite_compressibility",
    "henderson",
    "ideal",
    "kolafa_rottner",
    "pressure",
    "scaled_particle",
]


def area_fraction(count: float, radius: float, area: float) -> float:
    """Share of the area that discs cover, N pi R²/A."""
    return count * math.pi * radius**2 / area


def ideal(eta: Real) -> Real:
    """Z = 1 of points that do not meet."""
    return 0.0 * eta + 1.0


def scaled_particle(eta: Real) -> Real:
    """Z = 1/(1 - eta)² of scaled-particle theory; 0.5 % low at eta = 0.2, 3 % at 0.6.

    Source: E. Helfand, H. L. Frisch, J. L. Lebowitz, J. Chem. Phys. 34, 1037 (1961), doi:10.1063/1.1731697.
    """
    return _below_one(eta, 0.0 * eta + 1.0)


def henderson(eta: Real) -> Real:
    """Z = (1 + eta²/8)/(1 - eta)²; within 0.03 % up to eta = 0.3, 0.5 % high at 0.5, 1.2 % at 0.6.

    Source: D. Henderson, Mol. Phys. 30, 971 (1975), doi:10.1080/00268977500102511.
    """
    return _below_one(eta, 1.0 + eta * eta / 8.0)


def kolafa_rottner(eta: Real) -> Real:
    """Z by the fit of Kolafa and Rottner, the reference; for eta up to 0.691."""
    return fit.compressibility(eta)


EQUATIONS: Final[dict[str, Callable[[float], float]]] = {
    "ideal": ideal,
    "scaled-particle": scaled_particle,
    "henderson": henderson,
    "kolafa-rottner": kolafa_rottner,
}
"""Compressibility by the name of the equation of state."""

RANGE: Final[dict[str, float]] = {
    "ideal": math.inf,
    "scaled-particle": 1.0,
    "henderson": 1.0,
    "kolafa-rottner": fit.MAXIMUM_AREA_FRACTION,
}
"""Largest area fraction at which each equation gives a number (at 0.700 the fluid begins to freeze)."""


def contact_value(eta: float, equation: str = "kolafa-rottner") -> float:
    """chi = (Z - 1)/(2 eta): how much likelier than by chance two discs touch; 1 in the dilute limit.

    Parameters
    ----------
    eta : area fraction
    equation : a name in `EQUATIONS`
    """
    if eta == 0.0:
        return 0.0 if equation == "ideal" else 1.0
    return (EQUATIONS[equation](eta) - 1.0) / (2.0 * eta)


def pressure(
    count: float, radius: float, area: float, temperature: float, equation: str = "kolafa-rottner"
) -> float:
    """P = Z N T/A [mass/time²] at the nominal area fraction; not a number outside the equation's `RANGE`."""
    return EQUATIONS[equation](area_fraction(count, radius, area)) * count * temperature / area


def _below_one(eta: Real, numerator: Real) -> Real:
    """numerator/(1 - eta)² for 0 <= eta < 1, not a number elsewhere."""
    inside = np.logical_and(np.greater_equal(eta, 0.0), np.less(eta, 1.0))
    space = pick(inside, 1.0 - eta, np.nan)
    result: Real = numerator / space**2
    return result
