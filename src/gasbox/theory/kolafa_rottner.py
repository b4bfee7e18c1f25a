"""The most exact equation of state of the hard-disc fluid, a fit to very long simulations.

Z is a polynomial in x = eta/(1 - eta), so that eta d/d eta is x (1 + x) d/dx, and slopes stay polynomials.

Source: J. Kolafa and M. Rottner, Mol. Phys. 104, 3435 (2006), doi:10.1080/00268970600967963, the fit to
data up to the density n sigma² = 0.88.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.polynomial import Polynomial

from gasbox.theory.real import Real, pick

__all__ = [
    "MAXIMUM_AREA_FRACTION",
    "compressibility",
    "compressibility_slope",
    "excess_free_energy",
    "finite_compressibility",
]

MAXIMUM_AREA_FRACTION: Final = 0.88 * math.pi / 4.0
"""Up to this area fraction (0.691) the fit stands on data; the fluid itself ends at about 0.700."""

_END: Final = MAXIMUM_AREA_FRACTION
_COEFFICIENTS: Final[dict[int, float]] = {
    0: 1.0,
    1: 2.0,
    2: 1.12801775,
    3: 0.00181895291,
    4: -0.0526134737,
    5: 0.0504951668,
    6: -0.0325433846,
    7: 0.0133946531,
    8: 0.00174265604,
    9: -0.00944632202,
    10: 0.00851111768,
    11: -0.0035963525,
    12: 0.000577345106,
    19: -1.06399127e-7,
}
_SERIES: Final = Polynomial([_COEFFICIENTS.get(power, 0.0) for power in range(20)])
_LOGARITHMIC: Final = Polynomial([0.0, 1.0, 1.0])
"""x (1 + x): what turns d/dx into eta d/d eta."""
_SLOPE: Final = _LOGARITHMIC * _SERIES.deriv()
_STIFFNESS: Final = _SERIES + _SLOPE
"""d(P/T)/dn = Z + eta dZ/d eta, the inverse of the structure factor at zero wave number."""
_STIFFNESS_SLOPE: Final = _LOGARITHMIC * _STIFFNESS.deriv()
_QUOTIENT, _REST = divmod(Polynomial(_SERIES.coef[1:]), Polynomial([1.0, 1.0]))
"""(Z - 1)/x over 1 + x: a polynomial, and a number over 1 + x."""
_INTEGRAL: Final = _QUOTIENT.integ()


def compressibility(area_fraction: Real) -> Real:
    """Z = P A/(N T) of the bulk fluid; not a number outside 0 <= eta <= MAXIMUM_AREA_FRACTION.

    Good to about 1e-5 below eta = 0.6 and to 1e-4 up to the end of its range.
    """
    return _valid(area_fraction, _SERIES(_argument(area_fraction)))


def compressibility_slope(area_fraction: Real) -> Real:
    """The derivative eta dZ/d eta of the bulk fluid."""
    return _valid(area_fraction, _SLOPE(_argument(area_fraction)))


def excess_free_energy(area_fraction: Real) -> Real:
    """int_0^eta (Z - 1)/eta d eta: free energy per disc of the bulk fluid over T, less the ideal gas's."""
    x = _argument(area_fraction)
    value: Real = _INTEGRAL(x) + float(_REST.coef[0]) * np.log1p(x)
    return _valid(area_fraction, value)


def finite_compressibility(area_fraction: Real, count: int) -> Real:
    """Z of `count` discs in a periodic box, to first order in 1/count.

    The canonical free energy differs from the bulk's by (T/2) ln(2 pi N S), S = 1/(Z + eta Z'), whose area
    derivative gives Z_N = Z - (1/2N) d ln(Z + eta Z')/d ln eta. In a dilute gas Z_N - 1 = (1 - 1/N)(Z - 1).

    Source: J. L. Lebowitz and J. K. Percus, Phys. Rev. 124, 1673 (1961), doi:10.1103/PhysRev.124.1673.
    """
    x = _argument(area_fraction)
    return _valid(area_fraction, _SERIES(x) - _STIFFNESS_SLOPE(x) / _STIFFNESS(x) / (2.0 * count))


def _argument(area_fraction: Real) -> Real:
    """x = eta/(1 - eta), with everything outside the range moved to its nearer end."""
    inside: Real = np.clip(area_fraction, 0.0, _END)
    return inside / (1.0 - inside)


def _valid(area_fraction: Real, value: Real) -> Real:
    """`value` where the fit holds, not a number elsewhere."""
    inside = np.logical_and(np.greater_equal(area_fraction, 0.0), np.less_equal(area_fraction, _END))
    result: Real = pick(inside, value, np.nan)
    return result
