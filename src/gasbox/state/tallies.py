"""Sums that every dynamics keeps anyway, from the start of the scenario on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Tallies"]


@dataclass
class Tallies:
    """Cumulative sums over all executed collisions, indexed by species and wall.

    Attributes
    ----------
    pair_virial : (1,) float64 [energy], sum over pair collisions of |impulse| times the distance of the centres
    pair_collisions : (s, s) int64, [a, b] with a <= b counts the collisions of a pair of species
    wall_impulse : (walls, s) float64 [mass·length/time], sum of the normal impulses on a wall (>= 0)
    wall_collisions : (walls, s) int64
    """

    pair_virial: NDArray[np.float64]
    pair_collisions: NDArray[np.int64]
    wall_impulse: NDArray[np.float64]
    wall_collisions: NDArray[np.int64]

    @classmethod
    def zero(cls, species: int, walls: int) -> Tallies:
        """All sums at zero, for a number of species and of walls."""
        return cls(
            np.zeros(1),
            np.zeros((species, species), np.int64),
            np.zeros((walls, species)),
            np.zeros((walls, species), np.int64),
        )

    def copy(self) -> Tallies:
        """An independent copy."""
        return Tallies(
            self.pair_virial.copy(),
            self.pair_collisions.copy(),
            self.wall_impulse.copy(),
            self.wall_collisions.copy(),
        )

    def __sub__(self, earlier: Tallies) -> Tallies:
        """What was added since `earlier`."""
        return Tallies(
            self.pair_virial - earlier.pair_virial,
            self.pair_collisions - earlier.pair_collisions,
            self.wall_impulse - earlier.wall_impulse,
            self.wall_collisions - earlier.wall_collisions,
        )
