"""Drift, and filing into cells by a counting sort that a team of threads does together."""

from __future__ import annotations

import numpy as np

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.grid import cell_of
from gasbox.kernels.stepped.tables import Grid, Room, Slots
from gasbox.kernels.team import share

__all__ = ["drift", "file", "number", "show"]


@inlined_kernel
def _owner(cell: int, cells: int, threads: int) -> int:
    owner = 0
    while cell >= share(cells, owner, threads)[1]:
        owner += 1
    return owner


@bare_kernel
def drift(
    slots: Slots, box: Box, grid: Grid, room: Room, time_step: float, thread: int, threads: int
) -> None:
    """Move this thread's share of the particles, and count them by cell."""
    tally, shares, cells = room.end[thread], room.share[thread], grid.first[-1]
    first_own, last_own = share(cells, thread, threads)
    shares[:] = 0
    tally[:] = 0
    begin, end = share(slots.row.shape[0], thread, threads)
    elsewhere, own, base = 0, 0, 0
    columns, rows = grid.columns[0], grid.rows[0]
    across, along = columns / box.width, rows / box.height
    for slot in range(begin, end):
        x = slots.x[slot] + slots.vx[slot] * time_step
        y = slots.y[slot] + slots.vy[slot] * time_step
        if box.periodic_x:
            x -= np.floor(x / box.width) * box.width
        if box.periodic_y:
            y -= np.floor(y / box.height) * box.height
        slots.x[slot] = x
        slots.y[slot] = y
        if grid.columns.shape[0] > 1 and grid.level[slots.row[slot]] != own:
            own = grid.level[slots.row[slot]]
            columns, rows, base = grid.columns[own], grid.rows[own], grid.first[own]
            across, along = columns / box.width, rows / box.height
        cell = base + cell_of(y, along, rows) * columns + cell_of(x, across, columns)
        room.cell[slot] = cell
        tally[cell + 1] += 1
        if cell < first_own or cell >= last_own:
            shares[_owner(cell, cells, threads)] += 1
            elsewhere += 1
    shares[thread] = end - begin - elsewhere


@bare_kernel
def number(grid: Grid, room: Room, thread: int, threads: int) -> None:
    """Turn the counts of this thread's share of the cells into first slots, one for each thread."""
    begin, end = share(grid.first[-1], thread, threads)
    slot = 0
    for owner in range(thread):
        for other in range(threads):
            slot += room.share[other, owner]
    tally = room.end
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
def show(slots: Slots, gas: Gas, thread: int, threads: int) -> None:
    """Write this thread's share of the particles into the state."""
    position, velocity = gas.position, gas.velocity
    begin, end = share(slots.row.shape[0], thread, threads)
    for slot in range(begin, end):
        row = slots.row[slot]
        position[row, 0] = slots.x[slot]
        position[row, 1] = slots.y[slot]
        velocity[row, 0] = slots.vx[slot]
        velocity[row, 1] = slots.vy[slot]
