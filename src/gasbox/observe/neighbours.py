"""Who is near whom: neighbours within a distance, their number, and how well they stand in a hexagon."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.kernels.neighbours import count_neighbours, file_discs, list_neighbours
from gasbox.state import State

__all__ = [
    "Neighbours",
    "bond_order",
    "coordination",
    "hexatic",
    "hexatic_order",
    "neighbours",
    "sum_over",
]

_MARGIN: Final = 1.0 + 1e-9
"""Cells are a little wider than needed, so that rounding at their edges hides nobody."""


class Neighbours(NamedTuple):
    """Neighbours of all discs in one list; those of row i are entries first[i] to first[i + 1].

    Attributes
    ----------
    first : (n+1,) int64
    other : (m,) int64, rows of the neighbours, ascending for each disc
    way : (m, 2) float64 [length], from the disc to its neighbour
    """

    first: NDArray[np.int64]
    other: NDArray[np.int64]
    way: NDArray[np.float64]

    @property
    def counts(self) -> NDArray[np.int64]:
        """(n,) int64: how many neighbours each disc has."""
        return np.diff(self.first)

    @property
    def rows(self) -> NDArray[np.int64]:
        """(m,) int64: whose neighbour each entry is."""
        return np.repeat(np.arange(self.counts.size), self.counts)


def neighbours(state: State, geometry: Geometry, distance: float) -> Neighbours:
    """All pairs of centres at most a distance apart, each from both sides.

    Across periodic edges each image counts by itself; in a box smaller than the distance a disc may so be a neighbour
    several times, and its own. Walls and obstacles hide nobody.

    Parameters
    ----------
    geometry : its walls are displaced here
    distance : > 0 [length]
    """
    here = geometry.at(state.wall_displacement)
    periodic, size = np.asarray(here.periodic), np.array(here.size, np.float64)
    position = here.wrap(state.position)
    if not state.count:
        return Neighbours(np.zeros(1, np.int64), np.zeros(0, np.int64), np.zeros((0, 2)))
    # Where there are walls the discs themselves say how far the box reaches.
    low = np.where(periodic, 0.0, np.min(position, axis=0))
    size = np.where(periodic, size, np.maximum(np.max(position, axis=0) - low, distance))
    position = position - low
    most = 2 * math.isqrt(state.count) + 1
    cells = np.clip(np.floor(size / (distance * _MARGIN)), 1, most).astype(np.int64)
    reach = np.ceil(distance * _MARGIN * cells / size).astype(np.int64)
    box = position, size, periodic, cells, reach, float(distance), *file_discs(position, size, cells)
    first = count_neighbours(*box)
    other, way = np.empty(first[-1], np.int64), np.empty((first[-1], 2))
    list_neighbours(*box, first, other, way)
    return Neighbours(first, other, way)


def coordination(state: State, geometry: Geometry, distance: float = 1.5) -> NDArray[np.int64]:
    """(n,) int64: how many neighbours each disc has within a distance [length]."""
    return neighbours(state, geometry, distance).counts


def hexatic(state: State, geometry: Geometry, distance: float = 1.5) -> NDArray[np.complex128]:
    """(n,) complex: psi_6 of each disc, the mean of exp(6 i theta) over the directions of its neighbours.

    Its modulus is 1 in a perfect triangular lattice; its angle says how the lattice is turned. 0 without neighbours.

    Parameters
    ----------
    distance : within which others are neighbours [length]; best the first minimum of g(r), some 1.5 sigma

    Source: D. R. Nelson and B. I. Halperin, Phys. Rev. B 19, 2457 (1979), doi:10.1103/PhysRevB.19.2457.
    """
    return bond_order(neighbours(state, geometry, distance))


def hexatic_order(state: State, geometry: Geometry, distance: float = 1.5) -> float:
    """Modulus of the mean of psi_6 over all discs: 1 for one crystal, near 0 for a liquid or gas, and for no disc."""
    return float(abs(np.mean(hexatic(state, geometry, distance)))) if state.count else 0.0


def bond_order(found: Neighbours) -> NDArray[np.complex128]:
    """(n,) complex: psi_6 from a list of neighbours."""
    bond = found.way[:, 0] + 1j * found.way[:, 1]
    length = np.abs(bond)
    unit = np.divide(bond, length, out=np.ones_like(bond), where=length > 0.0)
    sums = sum_over(found, unit**6)
    return sums / np.maximum(found.counts, 1)


def sum_over(found: Neighbours, values: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """(n,) complex: sum of the values (m,) over the entries of each disc."""
    real, imaginary = (
        np.bincount(found.rows, part, found.counts.size) for part in (values.real, values.imag)
    )
    return real + 1j * imaginary
