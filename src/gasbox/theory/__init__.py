"""Formulas of the two-dimensional gas: what measurements are held against.

`maxwell` (laws of speed and energy), `hard_disc` and `mixture` (pressure, contact values), `kolafa_rottner`
and `virial` (numbers behind them), `kinetic` (collision rates, free paths), `finite` (few particles),
`ranges` (axes).
"""

from gasbox.theory import finite, hard_disc, kinetic, kolafa_rottner, maxwell, mixture, ranges, virial
from gasbox.theory.mixture import Mixture

__all__ = [
    "Mixture",
    "finite",
    "hard_disc",
    "kinetic",
    "kolafa_rottner",
    "maxwell",
    "mixture",
    "ranges",
    "virial",
]
