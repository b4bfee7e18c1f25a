"""The triangular lattice at T = 0: energy and pressure of a crystal, from sums over its neighbours."""

from __future__ import annotations

import functools
import math
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.theory.pair_laws import PairLaw, cutoff_of, potential, virial

__all__ = ["Crystal", "crystal", "lattice_density", "lattice_energy", "lattice_pressure", "lattice_spacing"]

_CELL: Final = math.sqrt(0.75)
"""Area of one disc in a triangular lattice of spacing 1."""
_FAR: Final = 60.0
"""Neighbours up to this many spacings are added one by one where a law has no end."""


class Crystal(NamedTuple):
    """A crystal at T = 0 and pressure 0.

    Attributes
    ----------
    spacing : between nearest neighbours [length]
    density : discs per area [1/length²]
    energy : of each disc [energy]
    """

    spacing: float
    density: float
    energy: float


def lattice_density(spacing: float) -> float:
    """Discs per area [1/length²] of a triangular lattice: 2/(sqrt(3) a²)."""
    return 1.0 / (_CELL * spacing**2)


def lattice_spacing(density: float) -> float:
    """Distance of nearest neighbours [length] of a triangular lattice of this density [1/length²]."""
    return 1.0 / math.sqrt(_CELL * density)


def lattice_energy(law: PairLaw, density: float) -> float:
    """Energy of each disc [energy] of a perfect triangular lattice: half the sum over its neighbours."""
    distance, many = _shells(law, density)
    energy = 0.5 * float(many @ potential(law, distance))
    return energy + _rest(law, density)[0]


def lattice_pressure(law: PairLaw, density: float) -> float:
    """Pressure [mass/time²] of a perfect triangular lattice at T = 0: n/4 times the sum of r F."""
    distance, many = _shells(law, density)
    return 0.25 * density * float(many @ virial(law, distance)) + _rest(law, density)[1]


def crystal(law: PairLaw) -> Crystal:
    """The lattice at rest under no pressure; for laws that attract (lennard-jones, square-well).

    Raises
    ------
    ValueError
        The law does not hold a crystal together.
    """
    low, high = 0.9 * law.sigma, 1.3 * law.sigma
    if (
        lattice_pressure(law, lattice_density(high)) >= 0.0
        or lattice_pressure(law, lattice_density(low)) <= 0.0
    ):
        raise ValueError(f"the pair law {law.law!r} holds no crystal together")
    for _ in range(100):
        middle = 0.5 * (low + high)
        squeezed = lattice_pressure(law, lattice_density(middle)) > 0.0
        low, high = (middle, high) if squeezed else (low, middle)
    density = lattice_density(low)
    return Crystal(low, density, lattice_energy(law, density))


def _shells(law: PairLaw, density: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Distances [length] and numbers of neighbours of one disc, within the cutoff."""
    spacing, cutoff = lattice_spacing(density), cutoff_of(law)
    squares, many = _loeschian(int(math.ceil(min(cutoff / spacing, _FAR)) + 1))
    distance = spacing * np.sqrt(squares)
    near = distance < min(cutoff, _FAR * spacing)
    return distance[near], many[near].astype(np.float64)


@functools.lru_cache(maxsize=8)
def _loeschian(most: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Squares i² + i j + j² of distances in the lattice up to `most`, and how often each occurs."""
    side = np.arange(-2 * most, 2 * most + 1)
    first, second = np.meshgrid(side, side)
    squares = first**2 + first * second + second**2
    found, many = np.unique(squares[(squares > 0) & (squares <= most**2)], return_counts=True)
    return found, many


def _rest(law: PairLaw, density: float) -> tuple[float, float]:
    """Energy and pressure from beyond the neighbours added one by one, as if spread evenly; for Lennard-Jones."""
    if law.law != "lennard-jones" or math.isfinite(cutoff_of(law)):
        return 0.0, 0.0
    far = _FAR * lattice_spacing(density) / law.sigma
    reduced = density * law.sigma**2
    scale = law.epsilon / law.sigma**2
    return (
        law.epsilon * math.pi * reduced * (0.4 * far**-10 - far**-4),
        scale * math.pi * reduced**2 * (2.4 * far**-10 - 3.0 * far**-4),
    )
