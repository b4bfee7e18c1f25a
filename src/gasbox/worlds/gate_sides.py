"""The gas on the two sides of a gate: how many, how warm, in how much room."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure, Geometry, Segment, side_count
from gasbox.geometry.halves import half_areas
from gasbox.state import State
from gasbox.theory.demon import entropy_of_parts

__all__ = ["Census", "GateSides"]


@dataclass(frozen=True)
class Census:
    """Both sides at one moment, the left (or lower) one first.

    Attributes
    ----------
    count : (species, 2) int64
    energy : (2,) float64, kinetic [energy]
    area : (species, 2) float64 [length²], that centres can reach
    """

    count: NDArray[np.int64]
    energy: NDArray[np.float64]
    area: NDArray[np.float64]

    @property
    def total(self) -> NDArray[np.int64]:
        """(2,) int64, discs of all species."""
        return np.asarray(self.count.sum(axis=0), np.int64)

    @property
    def temperature(self) -> NDArray[np.float64]:
        """(2,) float64 [energy]: mean kinetic energy of a disc; 0 where there is none."""
        return self.energy / np.maximum(self.total, 1)

    @property
    def mean_temperature(self) -> float:
        """Of the whole gas, which it has when it is left to itself [energy]."""
        return float(self.energy.sum() / max(int(self.total.sum()), 1))

    @property
    def pressure(self) -> NDArray[np.float64]:
        """(2,) float64 [mass/time²], of an ideal gas."""
        density = self.count / np.where(self.area > 0.0, self.area, np.inf)
        return np.asarray(density.sum(axis=0) * self.temperature, np.float64)

    @property
    def entropy(self) -> float:
        """Of two ideal gases, as `theory.demon.entropy_of_parts` [k_B]."""
        return entropy_of_parts(self.count, self.area, self.temperature)


class GateSides:
    """Parts a gas along the line of a gate.

    Parameters
    ----------
    geometry : with the gate in it, as at the start
    gate : name of its segment
    radii : (species,) float64 [length]

    Attributes
    ----------
    wall : index of the gate
    names : of the sides, as left and right
    normal : unit vector from the first side to the second
    turned : whether the normal of the segment points the other way
    """

    def __init__(self, geometry: Geometry, gate: str, radii: NDArray[np.float64]) -> None:
        assert isinstance(geometry, Enclosure)
        self.wall = geometry.wall_names.index(gate)
        segment = geometry.obstacles[self.wall - side_count(geometry.container)]
        assert isinstance(segment, Segment)
        x, y = segment.normal
        upright = abs(x) >= abs(y)
        self.names = ("left", "right") if upright else ("below", "above")
        self.turned = (x if upright else y) < 0.0
        self.normal = (-x, -y) if self.turned else (x, y)
        self.ends = segment.start, segment.end
        self._radii = radii

    def census(self, state: State, geometry: Geometry) -> Census:
        """Both sides now; a centre on the line counts as right (or above)."""
        assert isinstance(geometry, Enclosure)
        here = geometry.at(state.wall_displacement)
        moved = here.displacement[self.wall] if here.displacement else 0.0
        away = (state.position - self.ends[0]) @ np.array(self.normal)
        ahead = away >= (-moved if self.turned else moved)
        kinds = self._radii.size
        count = np.bincount(2 * state.species + ahead, minlength=2 * kinds).reshape(kinds, 2)
        kinetic = 0.5 * state.mass * np.sum(state.velocity**2, axis=1)
        area = np.array([half_areas(here, self.wall, float(radius)) for radius in self._radii])
        return Census(
            count.astype(np.int64),
            np.asarray(np.bincount(ahead, weights=kinetic, minlength=2), np.float64),
            area[:, ::-1] if self.turned else area,
        )
