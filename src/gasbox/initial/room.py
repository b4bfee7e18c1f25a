"""The box while it is being filled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.initial.arrangement import Patch
from gasbox.initial.grid import empty_grid
from gasbox.kernels.barriers import Barriers
from gasbox.kernels.overlaps import enter_all
from gasbox.kernels.size_grid import SizeGrid

__all__ = ["Room"]


@dataclass
class Room:
    """Discs that have a place, and discs that need one.

    Attributes
    ----------
    geometry : the container
    radius : (n,) float64 [length]
    low, high : (n, 2) float64 [length], bounds of the centre of each disc
    position : (n, 2) float64 [length]; valid for the discs that are placed
    placed : (n,) bool, which have their place
    grid : the discs that are placed
    reach : (n,) float64 [length], how far from walls the centre of each disc stays
    walls : what stands in the way apart from the bounds; None for nothing
    """

    geometry: Geometry
    radius: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    position: NDArray[np.float64]
    placed: NDArray[np.bool_]
    grid: SizeGrid
    reach: NDArray[np.float64]
    walls: Barriers | None = None

    @classmethod
    def around(
        cls,
        geometry: Geometry,
        listed: NDArray[np.float64],
        radius: NDArray[np.float64],
        low: NDArray[np.float64],
        high: NDArray[np.float64],
        reach: NDArray[np.float64],
        walls: Barriers | None = None,
    ) -> Room:
        """A room in which the first discs have the positions `listed` (m, 2) [length], and the others need one."""
        count = radius.shape[0]
        position = np.zeros((count, 2))
        placed, grid = np.zeros(count, np.bool_), empty_grid(geometry, radius)
        room = cls(geometry, radius, low, high, position, placed, grid, reach, walls)
        room.enter(np.arange(listed.shape[0]), listed)
        return room

    def enter(self, discs: NDArray[np.int64], position: NDArray[np.float64]) -> None:
        """Give `discs` (m,) a place (m, 2) [length]."""
        self.position[discs] = position
        self.placed[discs] = True
        enter_all(self.grid, self.position, discs)

    def enter_anew(self, position: NDArray[np.float64], placed: NDArray[np.bool_]) -> None:
        """Take over positions (n, 2) [length] of all discs that are `placed` (n,)."""
        self.position[:] = position
        self.placed[:] = placed
        self.grid.head.fill(-1)
        enter_all(self.grid, self.position, np.flatnonzero(placed))

    def leave(self, discs: NDArray[np.int64]) -> None:
        """Take `discs` (m,) out again."""
        self.placed[discs] = False
        self.enter_anew(self.position, self.placed)

    def patch(self, disc: int) -> Patch:
        """Where the centre of a disc can be."""
        (left, bottom), (right, top) = self.low[disc], self.high[disc]
        around_x, around_y = self.geometry.periodic & (self.high[disc] - self.low[disc] == self.geometry.size)
        return Patch(
            float(left),
            float(bottom),
            float(right - left),
            float(top - bottom),
            bool(around_x),
            bool(around_y),
        )
