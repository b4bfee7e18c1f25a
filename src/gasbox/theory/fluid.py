"""What follows from an equation of state of hard discs: stiffness, free energy, chemical potential.

All from Z(eta) alone. The free energy exceeds the ideal gas's by N T F with F = int_0^eta (Z - 1)/eta d eta;
the chemical potential over T is ln eta + F + Z - 1 and a function of the temperature; and the stiffness
d(P/T)/dn = Z + eta dZ/d eta is the slope of either, eta dmu/d eta = T S and d(eta Z) = eta dmu/T.

Equations of state go by their names in `hard_disc.EQUATIONS`. Functions take a float or an array first and
return the same; outside the range of the equation they give not-a-number.

Source: J.-P. Hansen and I. R. McDonald, Theory of Simple Liquids, 4th ed. (Academic Press, 2013), chs. 2
and 3, doi:10.1016/C2010-0-66723-X; the integrals of each equation are elementary.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Final

import numpy as np

from gasbox.theory import kolafa_rottner
from gasbox.theory.hard_disc import EQUATIONS, RANGE
from gasbox.theory.real import Real, pick
from gasbox.theory.roots import rising_root

__all__ = [
    "CLOSE_PACKED",
    "area_fraction_at",
    "chemical_potential",
    "compressibility",
    "excess_free_energy",
    "greatest_area_fraction",
    "stiffness",
]

CLOSE_PACKED: Final = math.pi / math.sqrt(12.0)
"""Area fraction of equal discs in a triangular lattice, 0.907: no more fit, whatever an equation says."""

_LOWEST: Final = -700.0
"""Chemical potentials over T from here down are taken for empty space: exp(-700) is 1e-304."""


def greatest_area_fraction(equation: str = "kolafa-rottner") -> float:
    """Up to this area fraction an equation is used: the end of its range, or close packing; ideal: inf."""
    return RANGE[equation] if equation == "ideal" else min(RANGE[equation], CLOSE_PACKED)


def compressibility(eta: Real, equation: str = "kolafa-rottner") -> Real:
    """Z = P A/(N T) by the equation of that name."""
    law: Callable[[Any], Any] = EQUATIONS[equation]
    value: Real = law(eta)
    return value


def stiffness(eta: Real, equation: str = "kolafa-rottner") -> Real:
    """S = d(P/T)/dn = Z + eta dZ/d eta: 1 in a dilute gas, large where the fluid is hard to compress."""
    value: Real = compressibility(eta, equation) + _SLOPES[equation](eta)
    return value


def excess_free_energy(eta: Real, equation: str = "kolafa-rottner") -> Real:
    """F = int_0^eta (Z - 1)/eta d eta: free energy per disc over T, less the ideal gas's."""
    value: Real = _valid(eta, equation, _FREE_ENERGIES[equation])
    return value


def chemical_potential(eta: Real, equation: str = "kolafa-rottner") -> Real:
    """ln eta + F + Z - 1: chemical potential over T, but for a function of the temperature; -inf at eta = 0."""
    with np.errstate(divide="ignore"):
        logarithm = np.log(np.maximum(eta, 0.0))
    value: Real = logarithm + excess_free_energy(eta, equation) + compressibility(eta, equation) - 1.0
    return value


def area_fraction_at(potential: Real, equation: str = "kolafa-rottner") -> Real:
    """Area fraction of the fluid with this chemical potential over T: the inverse of `chemical_potential`.

    Not a number above the potential at `greatest_area_fraction`.
    """
    level: Any = np.maximum(potential, _LOWEST)
    if equation == "ideal":
        ideal: Real = pick(np.less_equal(potential, _LOWEST), 0.0, np.exp(level))
        return ideal
    end = greatest_area_fraction(equation)
    top = chemical_potential(end, equation)
    level = np.minimum(level, top)

    def distance(logarithm: Any) -> tuple[Any, Any]:
        eta = np.minimum(np.exp(logarithm), end)
        return chemical_potential(eta, equation) - level, stiffness(eta, equation)

    # What exceeds ln eta lies between 0 and its value at the end of the range.
    bounds = level - (top - math.log(end)), np.minimum(level, math.log(end))
    fraction = pick(np.less_equal(potential, top), np.exp(rising_root(distance, *bounds)), np.nan)
    result: Real = pick(np.less_equal(potential, _LOWEST), 0.0, fraction)
    return result


def _henderson_slope(eta: Any) -> Any:
    """Eta dZ/d eta of Henderson's equation."""
    return eta * (2.0 + 0.25 * eta) / (1.0 - eta) ** 3


def _scaled_particle_slope(eta: Any) -> Any:
    """Eta dZ/d eta of 1/(1 - eta)²."""
    return 2.0 * eta / (1.0 - eta) ** 3


def _henderson_free_energy(eta: Any) -> Any:
    """(Z - 1)/eta is (9/8)/(1 - eta)² + (7/8)/(1 - eta)."""
    return 1.125 * eta / (1.0 - eta) - 0.875 * np.log1p(-eta)


def _scaled_particle_free_energy(eta: Any) -> Any:
    """(Z - 1)/eta is 1/(1 - eta)² + 1/(1 - eta)."""
    return eta / (1.0 - eta) - np.log1p(-eta)


def _zero(eta: Any) -> Any:
    return 0.0 * eta


_SLOPES: Final[dict[str, Callable[[Any], Any]]] = {
    "ideal": _zero,
    "scaled-particle": lambda eta: _valid(eta, "scaled-particle", _scaled_particle_slope),
    "henderson": lambda eta: _valid(eta, "henderson", _henderson_slope),
    "kolafa-rottner": kolafa_rottner.compressibility_slope,
}

_FREE_ENERGIES: Final[dict[str, Callable[[Any], Any]]] = {
    "ideal": _zero,
    "scaled-particle": _scaled_particle_free_energy,
    "henderson": _henderson_free_energy,
    "kolafa-rottner": kolafa_rottner.excess_free_energy,
}


def _valid(eta: Any, equation: str, law: Callable[[Any], Any]) -> Any:
    """`law` where the equation gives a number, not a number elsewhere."""
    inside = np.isfinite(compressibility(eta, equation))
    return pick(inside, law(pick(inside, eta, 0.0)), np.nan)
