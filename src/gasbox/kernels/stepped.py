"""The classroom rule: drift, then the collisions of touching, approaching pairs, then the walls."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, FULL, Box, Gas, Ledger, book_pair, book_wall
from gasbox.kernels.collision import exchange, nearest
from gasbox.kernels.grid import Grid, cell_of, file, span
from gasbox.kernels.sorting import sort

__all__ = ["GROW", "Workspace", "advance", "workspace"]

GROW = 10
"""Status: the list of touching pairs is too short; give a longer one and call again."""

_DRIFT, _FIND, _PAIRS, _WALLS = 0, 1, 2, 3


class Workspace(NamedTuple):
    """What the kernel needs beside the particles.

    Attributes
    ----------
    progress : (3,) int64, phase of the step, place in it, number of touching pairs
    key : (capacity,) int64, touching pairs as row of lower id * n + row of higher id
    x, y, reach : (n,) float64, positions and radii in the order of the cells
    """

    progress: NDArray[np.int64]
    key: NDArray[np.int64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    reach: NDArray[np.float64]


def workspace(n: int, capacity: int, progress: NDArray[np.int64] | None = None) -> Workspace:
    """Room for `n` particles and `capacity` touching pairs."""
    progress = np.zeros(3, np.int64) if progress is None else progress
    return Workspace(progress, np.zeros(capacity, np.int64), np.zeros(n), np.zeros(n), np.zeros(n))


@bare_kernel
def _drift(position: NDArray[np.float64], velocity: NDArray[np.float64], box: Box, time_step: float) -> None:
    for i in range(position.shape[0]):
        x = position[i, 0] + velocity[i, 0] * time_step
        y = position[i, 1] + velocity[i, 1] * time_step
        if box.periodic_x:
            x -= np.floor(x / box.width) * box.width
        if box.periodic_y:
            y -= np.floor(y / box.height) * box.height
        position[i, 0] = x
        position[i, 1] = y


@inlined_kernel
def _scan(
    s: int,
    begin: int,
    end: int,
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    reach: NDArray[np.float64],
    order: NDArray[np.int64],
    key: NDArray[np.int64],
    box: Box,
    found: int,
) -> int:
    """Note the discs in slots [begin, end) that touch the disc in slot `s`."""
    x_s, y_s, reach_s = x[s], y[s], reach[s]
    for other in range(begin, end):
        dx = nearest(x_s - x[other], box.width, box.periodic_x)
        dy = nearest(y_s - y[other], box.height, box.periodic_y)
        sigma = reach_s + reach[other]
        if dx * dx + dy * dy <= sigma * sigma:
            if found < key.shape[0]:
                i, j = order[s], order[other]
                key[found] = min(i, j) * order.shape[0] + max(i, j)
            found += 1
    return found


@bare_kernel
def _scan_level(
    target: int,
    own: int,
    box: Box,
    columns: int,
    rows: int,
    begin_slot: int,
    end_slot: int,
    start: NDArray[np.int64],
    order: NDArray[np.int64],
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    reach: NDArray[np.float64],
    key: NDArray[np.int64],
    found: int,
) -> int:
    """Note the touching pairs of slots [begin_slot, end_slot) with the discs of one level.

    `target` is the number of the level's first cell; if `own`, the slots are of this level and look
    at later slots only.
    """
    across, along = columns / box.width, rows / box.height
    for s in range(begin_slot, end_slot):
        column = cell_of(x[s], across, columns)
        row = cell_of(y[s], along, rows)
        left, right = span(column, columns, box.periodic_x)
        below, above = span(row, rows, box.periodic_y)
        inside = column + left >= 0 and column + right < columns
        after = s + 1 if own else 0
        for up in range(below, above + 1):
            line = row + up
            line = line + rows if line < 0 else line - rows if line >= rows else line
            base = target + line * columns
            if inside:
                begin, end = start[base + column + left], start[base + column + right + 1]
                found = _scan(s, max(begin, after), end, x, y, reach, order, key, box, found)
            else:
                for beside in range(left, right + 1):
                    cell = base + (column + beside + columns) % columns
                    begin, end = start[cell], start[cell + 1]
                    found = _scan(s, max(begin, after), end, x, y, reach, order, key, box, found)
    return found


@bare_kernel
def _find(gas: Gas, box: Box, grid: Grid, room: Workspace) -> int:
    """List all touching pairs in ascending order of (lower id, higher id); return how many there are."""
    position, radius = gas.position, gas.radius
    order, start, key = grid.order, grid.start, room.key
    x, y, reach = room.x, room.y, room.reach
    file(position, box, grid.level, grid.columns, grid.rows, grid.first, start, order, grid.cell)
    for s in range(order.shape[0]):
        i = order[s]
        x[s] = position[i, 0]
        y[s] = position[i, 1]
        reach[s] = radius[i]
    found = 0
    levels = grid.columns.shape[0]
    for own in range(levels):
        begin_slot, end_slot = start[grid.first[own]], start[grid.first[own + 1]]
        for level in range(own, levels):
            columns, rows, target = grid.columns[level], grid.rows[level], grid.first[level]
            found = _scan_level(
                target,
                level == own,
                box,
                columns,
                rows,
                begin_slot,
                end_slot,
                start,
                order,
                x,
                y,
                reach,
                key,
                found,
            )
    if found <= key.shape[0]:
        sort(key, found)
    return found


@inlined_kernel
def _full(book: Ledger) -> bool:
    return book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]


@inlined_kernel
def _collide(i: int, j: int, gas: Gas, box: Box, time: float, book: Ledger) -> None:
    dx = nearest(gas.position[i, 0] - gas.position[j, 0], box.width, box.periodic_x)
    dy = nearest(gas.position[i, 1] - gas.position[j, 1], box.height, box.periodic_y)
    dvx = gas.velocity[i, 0] - gas.velocity[j, 0]
    dvy = gas.velocity[i, 1] - gas.velocity[j, 1]
    if dvx * dx + dvy * dy >= 0.0:
        return
    change_i, change_j, impulse, virial = exchange(dx, dy, dvx, dvy, gas.mass[i], gas.mass[j])
    gas.velocity[i, 0] -= change_i * dx
    gas.velocity[i, 1] -= change_i * dy
    gas.velocity[j, 0] += change_j * dx
    gas.velocity[j, 1] += change_j * dy
    book_pair(book, gas.species[i], gas.species[j], i, j, time, -impulse * dx, -impulse * dy, virial)


@inlined_kernel
def _hits(
    i: int,
    wall: int,
    position: NDArray[np.float64],
    velocity: NDArray[np.float64],
    radius: NDArray[np.float64],
    box: Box,
) -> bool:
    """Whether a disc is at or beyond a wall and moves towards it."""
    if wall == 0:
        return not box.periodic_x and position[i, 0] <= radius[i] and velocity[i, 0] < 0.0
    if wall == 1:
        return not box.periodic_x and position[i, 0] + radius[i] >= box.width and velocity[i, 0] > 0.0
    if wall == 2:
        return not box.periodic_y and position[i, 1] <= radius[i] and velocity[i, 1] < 0.0
    return not box.periodic_y and position[i, 1] + radius[i] >= box.height and velocity[i, 1] > 0.0


@inlined_kernel
def _bounce(i: int, wall: int, gas: Gas, time: float, book: Ledger) -> None:
    axis = wall // 2
    given = -2.0 * gas.mass[i] * gas.velocity[i, axis]
    gas.velocity[i, axis] = -gas.velocity[i, axis]
    book_wall(book, gas.species[i], i, wall, time, given if axis == 0 else 0.0, given if axis == 1 else 0.0)


@bare_kernel
def _walls(gas: Gas, box: Box, room: Workspace, book: Ledger, time: float) -> bool:
    """Turn round all discs at a wall, from place `progress[1]` on; return whether the end was reached."""
    position, velocity, radius = gas.position, gas.velocity, gas.radius
    for i in range(room.progress[1] // 4, radius.shape[0]):
        x, y, r = position[i, 0], position[i, 1], radius[i]
        clear_x = box.periodic_x or (x > r and x + r < box.width)
        clear_y = box.periodic_y or (y > r and y + r < box.height)
        if clear_x and clear_y:
            continue
        for wall in range(room.progress[1] % 4 if room.progress[1] > 4 * i else 0, 4):
            if _hits(i, wall, position, velocity, radius, box):
                if _full(book):
                    room.progress[1] = 4 * i + wall
                    return False
                _bounce(i, wall, gas, time, book)
    return True


@bare_kernel
def advance(
    gas: Gas,
    box: Box,
    grid: Grid,
    room: Workspace,
    book: Ledger,
    clock: NDArray[np.int64],
    target: int,
    time_step: float,
) -> int:
    """Take whole steps until step number `target`.

    Parameters
    ----------
    clock : (1,) int64, steps done; counted on here
    target : step to stop at
    time_step : [time]

    Returns
    -------
    DONE, FULL (read the contacts, call again) or GROW (give a longer `room.key`, same progress, call again).
    """
    progress = room.progress
    while clock[0] < target:
        time = (clock[0] + 1) * time_step
        if progress[0] == _DRIFT:
            _drift(gas.position, gas.velocity, box, time_step)
            progress[0] = _FIND
        if progress[0] == _FIND:
            progress[2] = _find(gas, box, grid, room)
            if progress[2] > room.key.shape[0]:
                return GROW
            progress[0], progress[1] = _PAIRS, 0
        if progress[0] == _PAIRS:
            while progress[1] < progress[2]:
                if _full(book):
                    return FULL
                key = room.key[progress[1]]
                n = gas.position.shape[0]
                _collide(key // n, key % n, gas, box, time, book)
                progress[1] += 1
            progress[0], progress[1] = _WALLS, 0
        if not _walls(gas, box, room, book, time):
            return FULL
        progress[0], progress[1] = _DRIFT, 0
        clock[0] += 1
    return DONE
