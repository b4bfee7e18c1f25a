"""Sums that every dynamics keeps anyway, from the start of the scenario on."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
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
    wall_work : (walls, s) float64 [energy], that a moving wall has given to the gas: velocity of the wall times impulse
    wall_heat : (walls, s) float64 [energy], that a thermal wall has given to the gas, in its own frame
    wall_passed : (walls, s, 2) int64, discs whose centre has passed along the normal of a wall [0], and against it [1];
        of an open wall, those that have left the gas
    wall_carried : (walls, s) float64 [energy], kinetic energy of those that have left
    rest_energy : (1,) float64 [energy], that the rule for discs at rest has given to the gas
    """

    pair_virial: NDArray[np.float64]
    pair_collisions: NDArray[np.int64]
    wall_impulse: NDArray[np.float64]
    wall_collisions: NDArray[np.int64]
    wall_work: NDArray[np.float64]
    wall_heat: NDArray[np.float64]
    wall_passed: NDArray[np.int64]
    wall_carried: NDArray[np.float64]
    rest_energy: NDArray[np.float64]

    @classmethod
    def zero(cls, species: int, walls: int) -> Tallies:
        """All sums at zero, for a number of species and of walls."""
        at_walls = (walls, species)
        return cls(
            pair_virial=np.zeros(1),
            pair_collisions=np.zeros((species, species), np.int64),
            wall_impulse=np.zeros(at_walls),
            wall_collisions=np.zeros(at_walls, np.int64),
            wall_work=np.zeros(at_walls),
            wall_heat=np.zeros(at_walls),
            wall_passed=np.zeros((*at_walls, 2), np.int64),
            wall_carried=np.zeros(at_walls),
            rest_energy=np.zeros(1),
        )

    def copy(self) -> Tallies:
        """An independent copy."""
        return self._each(lambda name: getattr(self, name).copy())

    def __sub__(self, earlier: Tallies) -> Tallies:
        """What was added since `earlier`."""
        return self._each(lambda name: getattr(self, name) - getattr(earlier, name))

    @staticmethod
    def _each(make: Callable[[str], NDArray[np.generic]]) -> Tallies:
        return Tallies(**{entry.name: make(entry.name) for entry in dataclasses.fields(Tallies)})  # type: ignore[arg-type]
