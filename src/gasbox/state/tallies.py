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
    pair_virial : (1,) float64 [energy·time], sum over pair collisions of |impulse| times the distance of the centres;
        under forces the time integral of the sum of force times distance
    pair_collisions : (s, s) int64, [a, b] with a <= b counts the collisions of a pair of species
    wall_impulse : (walls, s) float64 [mass·length/time], sum of the normal impulses on a wall (>= 0)
    wall_collisions : (walls, s) int64
    wall_work : (walls, s) float64 [energy], that a moving wall has given to the gas: velocity of the wall times impulse
    wall_heat : (walls, s) float64 [energy], that a thermal wall has given to the gas, in its own frame
    wall_passed : (walls, s, 2) int64, discs whose centre has passed along the normal of a wall [0], and against it [1];
        of an open wall, those that have left the gas
    wall_carried : (walls, s) float64 [energy], kinetic energy of those that have left
    rest_energy : (1,) float64 [energy], that the rule for discs at rest has given to the gas
    kinetic_time : (1,) float64 [energy·time], time integral of the kinetic energy (forced dynamics alone), without that
        of the whole gas's motion where momentum is conserved
    potential_time : (1,) float64 [energy·time], likewise of the potential energy of all forces between discs
    area_time : (1,) float64 [length²·time], likewise of the area of a box that a barostat changes
    measured_time : (1,) float64 [time], over which these integrals go: whole spans between measurements
    thermostat_heat : (1,) float64 [energy], that a thermostat has given to the gas
    heater_heat : (1,) float64 [energy], that heating at a given power has given to the gas
    barostat_work : (1,) float64 [energy], that a barostat has given to the gas by changing its area
    rotational_time : (1,) float64 [energy·time], time integral of the rotational energy of molecules (forced dynamics
        alone); `kinetic_time` is then that of the centres of mass
    vibrational_time : (1,) float64 [energy·time], likewise of the kinetic energy within flexible molecules
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
    kinetic_time: NDArray[np.float64]
    potential_time: NDArray[np.float64]
    area_time: NDArray[np.float64]
    measured_time: NDArray[np.float64]
    thermostat_heat: NDArray[np.float64]
    heater_heat: NDArray[np.float64]
    barostat_work: NDArray[np.float64]
    rotational_time: NDArray[np.float64]
    vibrational_time: NDArray[np.float64]

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
            kinetic_time=np.zeros(1),
            potential_time=np.zeros(1),
            area_time=np.zeros(1),
            measured_time=np.zeros(1),
            thermostat_heat=np.zeros(1),
            heater_heat=np.zeros(1),
            barostat_work=np.zeros(1),
            rotational_time=np.zeros(1),
            vibrational_time=np.zeros(1),
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
