"""The classroom rule for equal discs of mass 1 between walls, in plain loops.

Everything is in this one file, so that numba's own file stamp notices every change.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel

__all__ = ["PlainStepped"]


@kernel
def _sort_into_cells(
    position: NDArray[np.float64],
    size: NDArray[np.float64],
    columns: int,
    rows: int,
    start: NDArray[np.int32],
    order: NDArray[np.int32],
    cell: NDArray[np.int32],
) -> None:
    """Counting sort: the discs of cell c are order[start[c]] to order[start[c + 1] - 1]."""
    start[:] = 0
    for i in range(position.shape[0]):
        column = min(max(int(position[i, 0] / size[0] * columns), 0), columns - 1)
        row = min(max(int(position[i, 1] / size[1] * rows), 0), rows - 1)
        cell[i] = row * columns + column
        start[cell[i] + 1] += 1
    for c in range(1, start.shape[0]):
        start[c] += start[c - 1]
    for i in range(position.shape[0] - 1, -1, -1):
        # Filled from behind: each end moves down to the beginning of its cell.
        start[cell[i] + 1] -= 1
        order[start[cell[i] + 1]] = i
    for c in range(start.shape[0] - 1):
        start[c] = start[c + 1]
    start[-1] = position.shape[0]


@kernel
def _touching_pairs(
    position: NDArray[np.float64],
    diameter: float,
    columns: int,
    rows: int,
    start: NDArray[np.int32],
    order: NDArray[np.int32],
    pair: NDArray[np.int64],
) -> int:
    """Write lower * n + higher for each touching pair, in ascending order; return how many there are.

    Precondition: `pair` has room for all of them.
    """
    n, found = position.shape[0], 0
    for row in range(rows):
        for column in range(columns):
            c = row * columns + column
            for slot in range(start[c], start[c + 1]):
                i = order[slot]
                x, y = position[i, 0], position[i, 1]
                # Later discs here, and those of the cells to the right and above: each pair once.
                for up in range(min(2, rows - row)):
                    left = max(column - 1, 0) if up else column
                    right = min(column + 1, columns - 1)
                    begin = start[c + columns + left - column] if up else slot + 1
                    for other in range(begin, start[c + up * columns + right - column + 1]):
                        j = order[other]
                        dx, dy = x - position[j, 0], y - position[j, 1]
                        if dx * dx + dy * dy <= diameter * diameter:
                            pair[found] = min(i, j) * n + max(i, j)
                            found += 1
    pair[:found].sort()
    return found


@kernel
def _collide(position: NDArray[np.float64], velocity: NDArray[np.float64], pair: NDArray[np.int64]) -> int:
    """Let the approaching ones of these pairs collide, one after the other; return how many did."""
    n, collisions = position.shape[0], 0
    for key in pair:
        i, j = key // n, key % n
        dx, dy = position[i, 0] - position[j, 0], position[i, 1] - position[j, 1]
        dvx, dvy = velocity[i, 0] - velocity[j, 0], velocity[i, 1] - velocity[j, 1]
        if dvx * dx + dvy * dy < 0.0:
            along = (dvx * dx + dvy * dy) / (dx * dx + dy * dy)
            velocity[i, 0] -= along * dx
            velocity[i, 1] -= along * dy
            velocity[j, 0] += along * dx
            velocity[j, 1] += along * dy
            collisions += 1
    return collisions


@kernel
def _steps(
    position: NDArray[np.float64],
    velocity: NDArray[np.float64],
    size: NDArray[np.float64],
    radius: float,
    time_step: float,
    columns: int,
    rows: int,
    steps: int,
) -> int:
    """Take whole steps; return the number of collisions."""
    n, collisions = position.shape[0], 0
    start, order = np.zeros(columns * rows + 1, np.int32), np.zeros(n, np.int32)
    # Equal discs that hardly overlap touch six others at most, which makes three pairs a disc.
    cell, pair = np.zeros(n, np.int32), np.zeros(4 * n, np.int64)
    for _ in range(steps):
        for i in range(n):
            position[i, 0] += velocity[i, 0] * time_step
            position[i, 1] += velocity[i, 1] * time_step
        _sort_into_cells(position, size, columns, rows, start, order, cell)
        found = _touching_pairs(position, 2.0 * radius, columns, rows, start, order, pair)
        collisions += _collide(position, velocity, pair[:found])
        for i in range(n):
            for axis in range(2):
                at, speed = position[i, axis], velocity[i, axis]
                if (at <= radius and speed < 0.0) or (at + radius >= size[axis] and speed > 0.0):
                    velocity[i, axis] = -speed
    return collisions


class PlainStepped:
    """Drift, then the collisions of touching, approaching pairs in the order of their ids, then walls.

    Parameters
    ----------
    position : (n, 2) float64 [length], changed in place
    velocity : (n, 2) float64 [length/time], changed in place
    size : (2,) float64, width and height [length]
    radius : [length]
    time_step : [time]
    """

    def __init__(
        self,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        size: NDArray[np.float64],
        radius: float,
        time_step: float,
    ) -> None:
        self.position, self.velocity = position, velocity
        self.collisions = 0
        self._size, self._radius, self._time_step = size, radius, time_step
        # Cells of one diameter, and a hair more: what touches is never two cells away.
        self._columns, self._rows = (max(1, int(length / (2.000001 * radius))) for length in size)

    def step(self, steps: int) -> None:
        """Take whole steps."""
        self.collisions += _steps(
            self.position,
            self.velocity,
            self._size,
            self._radius,
            self._time_step,
            self._columns,
            self._rows,
            steps,
        )
