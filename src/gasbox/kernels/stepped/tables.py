"""What the stepped kernel keeps beside the particles: grids by size class, slots in the order of cells, and lists.

A particle is filed at the level of its size class, in cells at least as wide as the largest diameter there. Whatever
touches it is filed at its own level or at a coarser one within the 3 x 3 cells around it, or looks it up likewise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.grid import classes
from gasbox.kernels.hall import Hall, with_cells

__all__ = ["PUSHED", "Grid", "Lists", "Room", "Slots", "Walls", "grid", "lists", "room", "walls"]

_SPACING = 0.5
"""Least width of a cell, in mean distances of the discs of its level."""


PUSHED = 2
"""Mark of a disc that came near a wall, if at all, only when it was pushed."""


class Grid(NamedTuple):
    """All levels, finest first; cells of level l are numbered from first[l], row by row.

    Attributes
    ----------
    level : (n,) int32, level of each particle
    columns, rows : (levels,) int64
    first : (levels + 1,) int64
    """

    level: NDArray[np.int32]
    columns: NDArray[np.int64]
    rows: NDArray[np.int64]
    first: NDArray[np.int64]


class Slots(NamedTuple):
    """The particles in the order of their cells.

    Attributes
    ----------
    row : (n,) int32, row of the particle in the state
    x, y : (n,) float64, positions [length]
    vx, vy : (n,) float64, velocities [length/time]
    reach : (n,) float64, radii [length]
    """

    row: NDArray[np.int32]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    vx: NDArray[np.float64]
    vy: NDArray[np.float64]
    reach: NDArray[np.float64]


class Lists(NamedTuple):
    """What the threads (first index) of a team found, each in ascending order of the keys.

    Attributes
    ----------
    key : (threads, capacity) int64, pairs as row of lower id * n + row of higher id, walls as n^2 + 4 * row + wall
    slot : (threads, capacity) int64, slot of the first (or only) disc, and 2^32 times that of the second
    found : (threads,) int64, how many there are; may be more than there was room for
    done : (threads,) int64, how many of these are done
    """

    key: NDArray[np.int64]
    slot: NDArray[np.int64]
    found: NDArray[np.int64]
    done: NDArray[np.int64]


class Walls(NamedTuple):
    """An enclosure, and what is kept beside it. Rows are those of the state.

    Attributes
    ----------
    hall : the enclosure, with lists for the cells of the grid
    start, place : (walls,) float64, displacement of each wall at the begin and at the end of the step [length]
    before : (n, 2) float64, where the way of this step began; unwrapped, so that it leads straight here [length]
    slot : (n,) int32, slot of each particle
    near : (n,) int8, 1 for a particle that may have to do with a wall in this step, 2 if only because it was pushed
    gone : (n,) int8, 1 for a particle that has left the gas
    largest : (levels,) float64, largest radius in each level [length]
    cursor : (4,) int64, how far the walls are in this step: row, part of its visit, the last thing done there; and
        how many discs are gone
    put : (4,) float64, room for what `gasbox.kernels.stepped.ways` finds
    """

    hall: Hall
    start: NDArray[np.float64]
    place: NDArray[np.float64]
    before: NDArray[np.float64]
    slot: NDArray[np.int32]
    near: NDArray[np.int8]
    gone: NDArray[np.int8]
    largest: NDArray[np.float64]
    cursor: NDArray[np.int64]
    put: NDArray[np.float64]


class Room(NamedTuple):
    """Working memory of a team.

    Attributes
    ----------
    progress : (2,) int64, phase of the step, and whether `odd` (1) or `even` (0) is filed last
    even, odd : the particles as filed in every other step
    cell : (n,) int32, new cell of the particle in each slot
    end : (threads, cells + 1) int32, at cell + 1 where the thread files next; in the end the last row holds
        one past the last slot of each cell, and so the first slot of the next
    share : (threads, threads) int64, how many particles each thread (row) files in each thread's cells (column)
    lists : what touches
    """

    progress: NDArray[np.int64]
    even: Slots
    odd: Slots
    cell: NDArray[np.int32]
    end: NDArray[np.int32]
    share: NDArray[np.int64]
    lists: Lists


def grid(radius: NDArray[np.float64], width: float, height: float, ratio: float = 2.0) -> Grid:
    """Grids for discs of these radii (n,) [length] in a box of width x height [length]."""
    level, largest = classes(radius, ratio)
    members = np.bincount(level, minlength=largest.size)
    side = np.maximum(2.0 * largest * (1 + 1e-9), _SPACING * np.sqrt(width * height / np.maximum(members, 1)))
    columns = np.maximum(1, np.floor(width / side)).astype(np.int64)
    rows = np.maximum(1, np.floor(height / side)).astype(np.int64)
    first = np.concatenate([np.zeros(1, np.int64), np.cumsum(columns * rows)]).astype(np.int64)
    return Grid(level, columns, rows, first)


def walls(hall: Hall, grid: Grid, radius: NDArray[np.float64], box: Box, place: NDArray[np.float64]) -> Walls:
    """Walls for discs of these radii (n,) [length] in an enclosure.

    Parameters
    ----------
    box : around it, as the grid divides it
    place : (walls,) float64, displacements now [length]; taken over
    """
    n = radius.size
    largest = np.array(
        [radius[grid.level == level].max(initial=0.0) for level in range(grid.columns.size)], np.float64
    )
    size, periodic = np.array([box.width, box.height]), np.array([box.periodic_x, box.periodic_y])
    return Walls(
        hall=with_cells(hall, size, periodic, grid.columns, grid.rows, grid.first[:-1].copy(), largest),
        start=place.copy(),
        place=place,
        before=np.zeros((n, 2)),
        slot=np.zeros(n, np.int32),
        near=np.zeros(n, np.int8),
        gone=np.zeros(n, np.int8),
        largest=largest,
        cursor=np.zeros(4, np.int64),
        put=np.zeros(4),
    )


def lists(threads: int, capacity: int) -> Lists:
    """Empty lists of `capacity` entries a thread."""
    return Lists(
        np.zeros((threads, capacity), np.int64),
        np.zeros((threads, capacity), np.int64),
        np.zeros(threads, np.int64),
        np.zeros(threads, np.int64),
    )


def room(grid: Grid, gas: Gas, threads: int) -> Room:
    """Memory for the discs of a gas, which are taken over in the order they have there."""
    n = gas.mass.shape[0]
    return Room(
        progress=np.zeros(2, np.int64),
        even=_slots(gas),
        odd=_slots(gas),
        cell=np.zeros(n, np.int32),
        end=np.zeros((threads, int(grid.first[-1]) + 1), np.int32),
        share=np.zeros((threads, threads), np.int64),
        lists=lists(threads, n // (2 * threads) + 64),
    )


def _slots(gas: Gas) -> Slots:
    (x, y), (vx, vy) = gas.position.T.copy(), gas.velocity.T.copy()
    return Slots(np.arange(gas.mass.shape[0], dtype=np.int32), x, y, vx, vy, gas.radius.copy())
