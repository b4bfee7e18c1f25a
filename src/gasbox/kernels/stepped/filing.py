"""Drift, and filing into cells by a counting sort that a team of threads does together."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.grid import cell_of
from gasbox.kernels.stepped.tables import Grid, Room, Slots, Walls
from gasbox.kernels.team import share

__all__ = ["count", "drift", "file", "fly", "number", "show"]


@bare_kernel
def drift(slots: Slots, box: Box, time_step: float, thread: int, threads: int) -> None:
    """Move this thread's share of the particles."""
    begin, end = share(slots.row.shape[0], thread, threads)
    _drift_along(slots.x[begin:end], slots.vx[begin:end], time_step, box.width, box.periodic_x)
    _drift_along(slots.y[begin:end], slots.vy[begin:end], time_step, box.height, box.periodic_y)


@inlined_kernel
def _drift_along(
    place: NDArray[np.float64], speed: NDArray[np.float64], time_step: float, length: float, periodic: bool
) -> None:
    for slot in range(place.shape[0]):
        place[slot] += speed[slot] * time_step
    if periodic:
        for slot in range(place.shape[0]):
            place[slot] -= np.floor(place[slot] / length) * length


@bare_kernel
def fly(slots: Slots, box: Box, walls: Walls, time_step: float, thread: int, threads: int) -> None:
    """Move this thread's share of the particles in an enclosure, on exact parabolas, and note where they came from."""
    begin, end = share(slots.row.shape[0], thread, threads)
    gx, gy = walls.hall.gx, walls.hall.gy
    fall_x, fall_y = 0.5 * gx * time_step * time_step, 0.5 * gy * time_step * time_step
    for slot in range(begin, end):
        row = slots.row[slot]
        if walls.gone[row]:
            continue
        x, y = slots.x[slot], slots.y[slot]
        to_x = x + slots.vx[slot] * time_step + fall_x
        to_y = y + slots.vy[slot] * time_step + fall_y
        if box.periodic_x and not 0.0 <= to_x < box.width:
            shift = np.floor(to_x / box.width) * box.width
            to_x, x = to_x - shift, x - shift
        if box.periodic_y and not 0.0 <= to_y < box.height:
            shift = np.floor(to_y / box.height) * box.height
            to_y, y = to_y - shift, y - shift
        walls.before[row, 0], walls.before[row, 1] = x, y
        slots.x[slot], slots.y[slot] = to_x, to_y
        slots.vx[slot] += gx * time_step
        slots.vy[slot] += gy * time_step


@bare_kernel
def count(slots: Slots, box: Box, grid: Grid, room: Room, thread: int, threads: int) -> None:
    """Find the cells of this thread's share of the particles, and count them by cell."""
    tally, shares, cells = room.end[thread], room.share[thread], grid.first[-1]
    tally[:] = 0
    begin, end = share(slots.row.shape[0], thread, threads)
    if grid.columns.shape[0] == 1:
        columns, rows = grid.columns[0], grid.rows[0]
        across, along = columns / box.width, rows / box.height
        for slot in range(begin, end):
            row, column = cell_of(slots.y[slot], along, rows), cell_of(slots.x[slot], across, columns)
            room.cell[slot] = row * columns + column
    else:
        for slot in range(begin, end):
            level = grid.level[slots.row[slot]]
            columns, rows = grid.columns[level], grid.rows[level]
            row = cell_of(slots.y[slot], rows / box.height, rows)
            column = cell_of(slots.x[slot], columns / box.width, columns)
            room.cell[slot] = grid.first[level] + row * columns + column
    for slot in range(begin, end):
        tally[room.cell[slot] + 1] += 1
    if threads > 1:
        for owner in range(threads):
            first, last = share(cells, owner, threads)
            members = 0
            for slot in range(begin, end):
                members += (room.cell[slot] >= first) & (room.cell[slot] < last)
            shares[owner] = members


@bare_kernel
def number(grid: Grid, room: Room, thread: int, threads: int) -> None:
    """Turn the counts of this thread's share of the cells into first slots, one for each thread."""
    begin, end = share(grid.first[-1], thread, threads)
    tally, slot = room.end, 0
    if threads == 1:
        for cell in range(begin + 1, end + 1):
            members = tally[0, cell]
            tally[0, cell] = slot
            slot += members
        return
    for owner in range(thread):
        for other in range(threads):
            slot += room.share[other, owner]
    for cell in range(begin + 1, end + 1):
        for other in range(threads):
            members = tally[other, cell]
            tally[other, cell] = slot
            slot += members


@bare_kernel
def file(old: Slots, new: Slots, room: Room, thread: int, threads: int) -> None:
    """Put this thread's share of the particles into their new slots."""
    place = room.end[thread]
    begin, end = share(old.row.shape[0], thread, threads)
    for before in range(begin, end):
        cell = room.cell[before]
        slot = place[cell + 1]
        place[cell + 1] = slot + 1
        new.row[slot] = old.row[before]
        new.x[slot] = old.x[before]
        new.y[slot] = old.y[before]
        new.vx[slot] = old.vx[before]
        new.vy[slot] = old.vy[before]
        new.reach[slot] = old.reach[before]


@bare_kernel
def show(slots: Slots, gas: Gas, walls: Walls | None, thread: int, threads: int) -> None:
    """Write this thread's share of the particles into the state; those that have left stay as they were shown last."""
    position, velocity = gas.position, gas.velocity
    begin, end = share(slots.row.shape[0], thread, threads)
    for slot in range(begin, end):
        row = slots.row[slot]
        if walls is not None and walls.gone[row]:
            continue
        position[row, 0] = slots.x[slot]
        position[row, 1] = slots.y[slot]
        velocity[row, 0] = slots.vx[slot]
        velocity[row, 1] = slots.vy[slot]
