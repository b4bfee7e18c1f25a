"""Formulas of the two-dimensional gas: what measurements are held against.

`maxwell` (laws of speed and energy), `hard_disc` and `mixture` (pressure, contact values), `kolafa_rottner`
and `virial` (numbers behind them), `fluid` (what follows from them), `kinetic` (collision rates, free paths),
`finite` (few particles), `gravity` and `sediment` (columns of points and of discs), `walls` (hits, thermal
walls, slits), `adiabat` (work and entropy), `piston` (a gas as a spring), `ranges` (axes); of discs with forces
`pair_laws` (energy and force of a pair), `imperfect` (virial coefficients), `lattice` (crystals at T = 0) and
`lennard_jones` (where its phases lie); of molecules `rotors` (laws, heat capacity), `hard_bodies` and `site_gas`
(second virial coefficients).
"""

from gasbox.theory import (
    adiabat,
    finite,
    fluid,
    gravity,
    hard_bodies,
    hard_disc,
    imperfect,
    kinetic,
    kolafa_rottner,
    lattice,
    lennard_jones,
    maxwell,
    mixture,
    pair_laws,
    piston,
    ranges,
    rotors,
    sediment,
    site_gas,
    virial,
    walls,
)
from gasbox.theory.mixture import Mixture

__all__ = [
    "Mixture",
    "adiabat",
    "finite",
    "fluid",
    "gravity",
    "hard_bodies",
    "hard_disc",
    "imperfect",
    "kinetic",
    "kolafa_rottner",
    "lattice",
    "lennard_jones",
    "maxwell",
    "mixture",
    "pair_laws",
    "piston",
    "ranges",
    "rotors",
    "sediment",
    "site_gas",
    "virial",
    "walls",
]
