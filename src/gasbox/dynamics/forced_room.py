"""Room for the tables of the forced rule: how much seems right, and more when it was not enough."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels import forced
from gasbox.kernels.hall import Hall
from gasbox.state import State

__all__ = ["Tables"]

_FEWEST = 16.0
"""Entries in the list of an atom, at least, that there is room for at first."""
_EXPECTED = 2.0
"""Slots for each disc and image that an even distribution would need, at first."""


class Tables:
    """Atoms of a state, and everything that is made anew as they move.

    Parameters
    ----------
    discs : all discs, each a row
    held : (m,) bool, which of them are parts of rigid bodies
    bodies : the molecules that they make up, if there are any
    size : (2,) float64, width and height of the box [length]
    periodic : (2,) bool
    reach : of the lists, skin included [length]
    threads : how many share the work
    hall, wall_strength : walls, and how they push

    Attributes
    ----------
    crowd, walls : what the kernels take
    """

    def __init__(
        self,
        discs: State,
        held: NDArray[np.bool_],
        bodies: forced.Bodies | None,
        size: tuple[float, float],
        periodic: tuple[bool, bool],
        reach: float,
        threads: int,
        hall: Hall,
        wall_strength: float,
    ) -> None:
        self._count = discs.count
        self._periodic, self._reach, self._threads = periodic, reach, threads
        around = discs.count * (2.0 * reach) ** 2 / (size[0] * size[1])
        self._entries, self._slots = max(_FEWEST, around / 2.0), _EXPECTED
        self._atoms, self._bodies = forced.atoms(discs, held), bodies
        self._has_walls = hall.kind.shape[0] > 0
        self._make(size)
        self.walls = forced.walls(hall, wall_strength, self._near, self._atoms, self._count)

    @property
    def _near(self) -> int:
        """How many discs near walls there is room for."""
        return int(self._slots * (128 + 2 * self._count)) if self._has_walls else 0

    def _make(self, size: tuple[float, float]) -> None:
        thick = forced.thickness(self._count, size[0] * size[1], self._reach)
        strips = forced.strips(size[1], self._reach, thick, self._threads)
        images = 1.0
        if self._periodic[0]:
            images *= 1.0 + 2.0 * self._reach / size[0]
        if self._periodic[1]:
            images *= 1.0 + 2.0 * (self._reach + thick) / size[1]
        most = int(self._slots * self._count * images) + 16 * strips.slot.shape[0] + 64
        slots = forced.slots(most, self._bodies is not None)
        # Each thread fills a part of its own, and stops when all strips around an atom might not fit.
        spare = self._threads * slots.x.shape[0]
        lists = forced.lists(self._count, int(self._entries * (self._count + 64)) + spare)
        room = forced.room(self._count, size, self._threads)
        self.crowd = forced.Crowd(self._atoms, slots, lists, strips, room, self._bodies)

    def grow(self) -> None:
        """Room for twice as much, with the same atoms in the same stage of a step."""
        room = self.crowd.room
        self._slots *= 2.0
        self._entries *= 2.0
        self._make((float(room.size[0]), float(room.size[1])))
        new = self.crowd.room
        new.stage[:], new.before[:], new.sums[:] = room.stage, room.before, room.sums
        self.walls = self.walls._replace(near=np.zeros((self._near, 4), np.int32))

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the box as it is now [length]."""
        width, height = self.crowd.room.size
        return float(width), float(height)

    def stand(self, time: float, listed: NDArray[np.float64] | None = None) -> None:
        """Bring walls that move to where they are at `time` [time].

        listed : (walls,) [length], where they were when discs near them were listed; None if that is now
        """
        forced.stand(self.walls, time)
        self.walls.listed[:] = self.walls.place if listed is None else listed

    def put(self, position: NDArray[np.float64]) -> None:
        """Put all atoms to these places (m, 2), in the order of the discs; the lists stay."""
        rows = self._atoms.row[: self._count]
        self._atoms.x[: self._count], self._atoms.y[: self._count] = position[rows].T

    def put_velocities(self, velocity: NDArray[np.float64]) -> None:
        """Give all atoms these velocities (m, 2), likewise."""
        rows = self._atoms.row[: self._count]
        self._atoms.vx[: self._count], self._atoms.vy[: self._count] = velocity[rows].T

    def by_row(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        """(m, 2) float64: two columns of the atoms in the order of the discs."""
        found = np.zeros((self._count, 2))
        rows = self._atoms.row[: self._count]
        found[rows, 0], found[rows, 1] = x[: self._count], y[: self._count]
        return found
