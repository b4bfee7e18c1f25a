"""Finds the worst overlap of discs, and pushes overlapping discs apart."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.barriers import Barriers, moved
from gasbox.kernels.size_grid import SizeGrid, around, first_cell, last_cell, nearest, put, take

__all__ = ["CROWDED", "SEPARATED", "enter_all", "push_apart", "worst_pair"]

SEPARATED = 0
"""No disc of the queue overlaps another one."""
CROWDED = 1
"""The budget is used up, and there are overlaps left."""

_NEIGHBOURS = 128


@kernel
def enter_all(grid: SizeGrid, position: NDArray[np.float64], order: NDArray[np.int64]) -> None:
    """Enter the discs of `order` (m,) into the grid."""
    for i in order:
        put(grid, i, position[i, 0], position[i, 1])


@kernel
def worst_pair(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    owner: NDArray[np.int64],
    touching: float,
) -> tuple[int, int, float]:
    """The pair that overlaps most.

    Parameters
    ----------
    position : (n, 2) float64 [length]
    radius : (n,) float64 [length]
    owner : (n,) int64, the particle that each disc belongs to; those of one particle may overlap
    touching : depth, as a fraction of the smaller radius, up to which two discs only touch

    Returns
    -------
    The lower index, the higher index, and the depth [length]; (-1, -1, 0) if nothing overlaps.
    """
    first, second, worst = -1, -1, 0.0
    for i in range(position.shape[0]):
        x, y, r = position[i, 0], position[i, 1], radius[i]
        # Coarser classes come first: a pair of two classes is met from its smaller disc.
        for k in range(grid.size_class[i] + 1):
            reach = r + grid.top[k]
            columns, rows = grid.cells[k, 0], grid.cells[k, 1]
            left = first_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
            right = last_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
            for row in range(
                first_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1]),
                last_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1]) + 1,
            ):
                start = grid.offset[k] + around(row, rows) * columns
                for column in range(left, right + 1):
                    j = grid.head[start + around(column, columns)]
                    while j >= 0:
                        if (j < i or (j > i and k < grid.size_class[i])) and owner[i] != owner[j]:
                            dx = nearest(x - position[j, 0], grid.size[0], grid.periodic[0])
                            dy = nearest(y - position[j, 1], grid.size[1], grid.periodic[1])
                            depth = r + radius[j] - math.sqrt(dx * dx + dy * dy)
                            if depth > worst and depth > touching * min(r, radius[j]):
                                first, second, worst = min(i, j), max(i, j), depth
                        j = grid.next[j]
    return first, second, worst


@kernel
def _overlapping(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    i: int,
    found: NDArray[np.int64],
) -> tuple[int, int]:
    """Write the discs that overlap `i` to `found`, as many as fit; return their number and that of discs looked at."""
    x, y, r = position[i, 0], position[i, 1], radius[i]
    count, looked = 0, 0
    for k in range(grid.top.shape[0]):
        reach = r + grid.top[k]
        columns, rows = grid.cells[k, 0], grid.cells[k, 1]
        left = first_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
        right = last_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
        for row in range(
            first_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1]),
            last_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1]) + 1,
        ):
            start = grid.offset[k] + around(row, rows) * columns
            for column in range(left, right + 1):
                looked += 1
                j = grid.head[start + around(column, columns)]
                while j >= 0:
                    looked += 1
                    dx = nearest(x - position[j, 0], grid.size[0], grid.periodic[0])
                    dy = nearest(y - position[j, 1], grid.size[1], grid.periodic[1])
                    if j != i and count < found.shape[0] and dx * dx + dy * dy < (r + radius[j]) ** 2:
                        found[count] = j
                        count += 1
                    j = grid.next[j]
    return count, looked


@kernel
def _move(
    grid: SizeGrid,
    position: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    reach: NDArray[np.float64],
    walls: Barriers | None,
    i: int,
    dx: float,
    dy: float,
) -> None:
    """Move disc `i` by (dx, dy), as far as its bounds allow, and round where its bounds are the whole period."""
    take(grid, i, position[i, 0], position[i, 1])
    if walls is not None:
        x, y = moved(walls, position[i, 0], position[i, 1], dx, dy, reach[i], low[i], high[i])
        position[i, 0], position[i, 1] = x, y
        put(grid, i, x, y)
        return
    for axis in range(2):
        place = position[i, axis] + (dx if axis == 0 else dy)
        length = grid.size[axis]
        if grid.periodic[axis] and low[i, axis] == 0.0 and high[i, axis] == length:
            place -= math.floor(place / length) * length
        position[i, axis] = min(max(place, low[i, axis]), high[i, axis])
    put(grid, i, position[i, 0], position[i, 1])


@kernel
def _push(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    share: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    reach: NDArray[np.float64],
    walls: Barriers | None,
    gap: float,
    i: int,
    j: int,
) -> bool:
    """Push `i` and `j` apart along the line of centres, the one with the greater share farther; False if apart."""
    dx = nearest(position[i, 0] - position[j, 0], grid.size[0], grid.periodic[0])
    dy = nearest(position[i, 1] - position[j, 1], grid.size[1], grid.periodic[1])
    distance = math.sqrt(dx * dx + dy * dy)
    touch = radius[i] + radius[j]
    total = share[i] + share[j]
    if distance >= touch or total == 0.0:
        return False
    if distance < 1e-12 * touch:
        # One place for two: part them in a direction that depends on who they are.
        angle = 2.399963229728653 * (i + j)
        dx, dy, distance = math.cos(angle), math.sin(angle), 0.0
    else:
        dx, dy = dx / distance, dy / distance
    way = touch * (1.0 + gap) - distance
    near, far = way * share[i] / total, way * share[j] / total
    _move(grid, position, low, high, reach, walls, i, dx * near, dy * near)
    _move(grid, position, low, high, reach, walls, j, -dx * far, -dy * far)
    return True


@kernel
def push_apart(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    share: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    reach: NDArray[np.float64],
    walls: Barriers | None,
    gap: float,
    queue: NDArray[np.int64],
    budget: int,
) -> tuple[int, int]:
    """Push overlapping discs apart, pair by pair, until nothing of the queue overlaps or the budget is used up.

    A disc that was moved goes back to the end of the queue. Every pair pushes at most one way, so the work is in
    proportion to the overlaps, and the order is that of the queue: the same discs give the same bits.

    Parameters
    ----------
    grid : holds all discs
    position : (n, 2) float64 [length], changed in place
    radius : (n,) float64 [length]
    share : (n,) float64, how readily a disc gives way; 0 for one that stays
    low, high : (n, 2) float64 [length], bounds of the centres
    reach : (n,) float64 [length], how far from walls the centre of each disc stays
    walls : what else stands in the way, of which all discs are clear; None for nothing
    gap : how far beyond touching they are pushed, as a fraction of the sum of the radii
    queue : (m,) int64, which discs to look at first, each once
    budget : most cells and discs that are looked at

    Returns
    -------
    Status (`SEPARATED`, `CROWDED`), and what was looked at.
    """
    count = position.shape[0]
    ring = np.empty(count + 1, np.int64)
    waiting = np.zeros(count, np.bool_)
    found = np.empty(_NEIGHBOURS, np.int64)
    begin, end, work = 0, 0, 0
    for i in queue:
        ring[end] = i
        waiting[i] = True
        end += 1
    while begin != end:
        if work > budget:
            return CROWDED, work
        i = ring[begin]
        begin = (begin + 1) % (count + 1)
        waiting[i] = False
        near, looked = _overlapping(grid, position, radius, i, found)
        work += looked
        for number in range(near):
            j = found[number]
            if _push(grid, position, radius, share, low, high, reach, walls, gap, i, j):
                for moved in (i, j):
                    if not waiting[moved] and share[moved] > 0.0:
                        ring[end] = moved
                        waiting[moved] = True
                        end = (end + 1) % (count + 1)
    return SEPARATED, work
