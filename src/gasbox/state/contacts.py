"""What a dynamics executed: every collision, as observers read it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

__all__ = ["ContactKind", "Contacts"]


class ContactKind(IntEnum):
    """What met: two particles, or a particle and a wall, or who passed a wall. Numbers are part of the file format."""

    PAIR = 0
    WALL = 1
    CROSSING = 2


@dataclass
class Contacts:
    """A bounded buffer of executed collisions, in the order of execution.

    A dynamics with a capacity of zero writes none. When the buffer is full, `advance` returns early; whoever reads it
    sets `count` to zero (`clear`) and calls `advance` again, which goes on with the same bits.

    Attributes
    ----------
    count : number of valid rows
    kind : (capacity,) uint8, a `ContactKind`
    time : (capacity,) float64 [time]
    first : (capacity,) int64, id of the particle (of a pair: the lower id)
    second : (capacity,) int64, id of the other particle, or index of the wall
    impulse : (capacity, 2) float64 [mass·length/time], given to `first`; of a crossing, the momentum of `first`
    """

    count: int
    kind: NDArray[np.uint8]
    time: NDArray[np.float64]
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    impulse: NDArray[np.float64]

    @classmethod
    def empty(cls, capacity: int) -> Contacts:
        """A buffer with room for `capacity` contacts."""
        return cls(
            0,
            np.zeros(capacity, np.uint8),
            np.zeros(capacity, np.float64),
            np.zeros(capacity, np.int64),
            np.zeros(capacity, np.int64),
            np.zeros((capacity, 2), np.float64),
        )

    @property
    def capacity(self) -> int:
        """Number of rows that fit."""
        return int(self.kind.shape[0])

    def clear(self) -> None:
        """Forget all rows."""
        self.count = 0
