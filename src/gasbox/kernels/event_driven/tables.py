"""The tables of the event-driven engine, and the names of their columns."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.grid import classes

__all__ = ["Tables", "tables"]

# Columns of `flight`, one row of 64 bytes a particle.
X, Y, VX, VY, T0, RADIUS, T_EVENT, T_CROSS = range(8)
# Columns of `link`, int32: neighbours in the list of the cell, the cell, the level, the partner of the next event,
# neighbours in the bucket, the place in the queue; the row of the state, and the species; column
# and row of the cell in its level.
NEXT, PREV, CELL, LEVEL, PARTNER, Q_NEXT, Q_PREV, PLACE, LABEL, SPECIES, COLUMN, ROW = range(12)
# Values of PARTNER below zero; wall w is WALL - w.
NOBODY, STALE, WALL = -1, -2, -3
# Values of PLACE below zero; entry of row b of the ring is b, in the chain of row b it is b plus the number of rows,
# position p of the heap is p plus twice that number.
NOWHERE, LATER = -1, -2
# Columns of `ring`: one past the last entry, first of the chain of those beyond the row, the first entry.
FILED, CHAIN, FIRST_ENTRY = range(3)
# Columns of `levels`: columns, rows, first cell, images aside of a pair (x, y), finest cells per cell (x, y), whether
# the cells are as narrow as the discs allow, so that many are met and few can come in time.
COLUMNS, ROWS, FIRST, IMAGES_X, IMAGES_Y, FACTOR_X, FACTOR_Y, CROWDED = range(8)
# Entries of `counter`: current bucket, its row in the ring, size of the heap, events, pair tests, predictions,
# crossings, stale events; the number of events at which the rows want sorting; whether to fetch ahead; events since
# time moved on.
CURRENT, RING_AT, HEAP, EVENTS, TESTS, PREDICTIONS, CROSSINGS, STALES, SORT_AT, FETCHES, IDLE = range(11)
# Entries of `number`: buckets per time, end of the epoch, time of the last event, a speed that no disc exceeds.
BUCKETS_PER_TIME, HORIZON, NOW, FASTEST = range(4)


_SPACINGS = 0.7
# Width of a finest cell, in mean distances of its discs; measured: wider cells cost tests, narrower ones crossings.
_SMALL = 20_000
# Discs up to which the caches hold the tables and a longer, wider ring. Measured: 3 to 6 % at 10^3.
_LARGE = 150_000
# Discs beyond which the tables are far larger than the caches: wider rows in the ring, and what coming events will
# touch is fetched ahead. Measured: at 10^5 it costs 10 %, at 10^6 it gives 25 %.


class Tables(NamedTuple):
    """Everything the kernels share. Rows are in an order of their own, in which neighbours are near in memory; the
    column LABEL says which row of the state a particle is. Ties are broken by label, so the order touches no bit.

    Attributes
    ----------
    flight : (n, 8) float64: reference position, velocity and time, radius, times of the next event and cell crossing
    link : (n, 12) int32, see the columns above
    mass : (n,) float64 [mass]
    head : (cells,) int32, first particle of each cell, -1 if empty
    near : (1024,) int32, the discs around one that are looked at
    ring : (buckets, 4 or 8) int32, the calendar: the particles in each bucket, see the columns above
    heap : (n,) int32, the particles whose events lie in the current bucket
    levels : (levels, 8) int64 and sides : (levels, 2) float64 [length], the grids, finest first
    counter : (11,) int64; number : (4,) float64
    """

    flight: NDArray[np.float64]
    link: NDArray[np.int32]
    mass: NDArray[np.float64]
    head: NDArray[np.int32]
    near: NDArray[np.int32]
    ring: NDArray[np.int32]
    heap: NDArray[np.int32]
    levels: NDArray[np.int64]
    sides: NDArray[np.float64]
    counter: NDArray[np.int64]
    number: NDArray[np.float64]


def _grids(
    level: NDArray[np.int32],
    largest: NDArray[np.float64],
    size: tuple[float, float],
    periodic: tuple[bool, bool],
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Nested grids: each cell of a coarser level is divided into whole cells of the next finer one."""
    members = np.maximum(np.bincount(level, minlength=largest.size), 1)
    wanted = 2.0 * largest * (1 + 1e-6)
    spacing = _SPACINGS * np.sqrt(size[0] * size[1] / members)
    crowded = wanted > spacing
    wanted[0] = max(wanted[0], spacing[0])
    count = largest.size
    levels = np.zeros((count, 8), np.int64)
    sides = np.zeros((count, 2))
    for axis in range(2):
        side, cells = size[axis], 1
        for k in range(count - 1, -1, -1):
            parts = max(1, int(side / wanted[k]))
            side, cells = side / parts, cells * parts
            levels[k, COLUMNS + axis] = cells
            sides[k, axis] = size[axis] / cells
            if periodic[axis] and cells <= 4:
                levels[k, IMAGES_X + axis] = 2 if cells == 1 else 1
        levels[:, FACTOR_X + axis] = levels[0, COLUMNS + axis] // levels[:, COLUMNS + axis]
    levels[:, CROWDED] = crowded & (levels[:, IMAGES_X] + levels[:, IMAGES_Y] == 0)
    cells_of = levels[:, COLUMNS] * levels[:, ROWS]
    levels[:, FIRST] = np.concatenate([[0], np.cumsum(cells_of)[:-1]])
    return levels, sides


def _rows(n: int, columns: int, dtype: type[np.float64 | np.int32]) -> NDArray[Any]:
    """Zeros (n, columns), from the start of a cache line."""
    size = n * columns * np.dtype(dtype).itemsize
    room = np.zeros(size + 64, np.uint8)
    begin = -room.ctypes.data % 64
    return room[begin : begin + size].view(dtype).reshape(n, columns)


def tables(
    radius: NDArray[np.float64],
    mass: NDArray[np.float64],
    species: NDArray[np.int32],
    size: tuple[float, float],
    periodic: tuple[bool, bool],
    ratio: float = 2.0,
) -> Tables:
    """Empty tables for discs of these radii, masses and species (n,) in a rectangle of this size [length]."""
    n = radius.shape[0]
    level, largest = classes(radius, ratio)
    levels, sides = _grids(level, largest, size, periodic)
    cells = int((levels[:, COLUMNS] * levels[:, ROWS]).sum())
    flight = _rows(n, 8, np.float64)
    flight[:, RADIUS] = radius
    link = _rows(n, 12, np.int32)
    link[:] = -1
    link[:, LEVEL] = level
    link[:, LABEL] = np.arange(n)
    link[:, SPECIES] = species
    # As many as the cache has room for.
    buckets, entries = (2 * n, 8) if n <= _SMALL else (n, 8 if n > _LARGE else 4)
    counter = np.zeros(11, np.int64)
    counter[FETCHES] = n > _LARGE
    return Tables(
        flight,
        link,
        mass.copy(),
        np.full(cells, -1, np.int32),
        np.zeros(1024, np.int32),
        _rows(buckets + 64, entries, np.int32),
        np.zeros(n, np.int32),
        levels,
        sides,
        counter,
        np.ones(4),
    )
