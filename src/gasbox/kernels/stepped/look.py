"""Finds the pairs that touch and the discs at a wall."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.collision import nearest
from gasbox.kernels.grid import cell_of, span
from gasbox.kernels.sorting import sort
from gasbox.kernels.stepped.bodies import Bodies
from gasbox.kernels.stepped.tables import Grid, Lists, Room, Slots, Walls
from gasbox.kernels.team import share

__all__ = ["look"]


@inlined_kernel
def _note(key: int, slots: int, lists: Lists, thread: int, found: int) -> int:
    if found < lists.key.shape[1]:
        lists.key[thread, found] = key
        lists.slot[thread, found] = slots
    return found + 1


@inlined_kernel
def _note_pair(
    first: int, second: int, slots: Slots, bodies: Bodies | None, lists: Lists, thread: int, found: int
) -> int:
    n = slots.row.shape[0]
    if bodies is not None and bodies.owner[slots.row[first]] == bodies.owner[slots.row[second]]:
        return found
    if slots.row[first] > slots.row[second]:
        first, second = second, first
    return _note(
        int(slots.row[first]) * n + int(slots.row[second]), first | second << 32, lists, thread, found
    )


@inlined_kernel
def _near(
    slot: int,
    begin: int,
    end: int,
    slots: Slots,
    bodies: Bodies | None,
    lists: Lists,
    thread: int,
    found: int,
) -> int:
    """Note the discs in slots [begin, end) that touch the disc in `slot`, where none is seen across the border."""
    x, y, reach = slots.x[slot], slots.y[slot], slots.reach[slot]
    for other in range(begin, end):
        dx = x - slots.x[other]
        dy = y - slots.y[other]
        sigma = reach + slots.reach[other]
        if dx * dx + dy * dy <= sigma * sigma:
            found = _note_pair(slot, other, slots, bodies, lists, thread, found)
    return found


@bare_kernel
def _around(
    slot: int,
    after: int,
    column: int,
    row: int,
    level: int,
    grid: Grid,
    box: Box,
    slots: Slots,
    bodies: Bodies | None,
    start: NDArray[np.int32],
    lists: Lists,
    thread: int,
    found: int,
) -> int:
    """Note whom the disc in `slot` touches from slot `after` on, in the 3 x 3 cells around one, across borders."""
    columns, rows, target = grid.columns[level], grid.rows[level], grid.first[level]
    left, right = span(column, columns, box.periodic_x)
    below, above = span(row, rows, box.periodic_y)
    x, y, reach = slots.x[slot], slots.y[slot], slots.reach[slot]
    for up in range(below, above + 1):
        base = target + (row + up + rows) % rows * columns
        for beside in range(left, right + 1):
            cell = base + (column + beside + columns) % columns
            for other in range(max(start[cell], after), start[cell + 1]):
                dx = nearest(x - slots.x[other], box.width, box.periodic_x)
                dy = nearest(y - slots.y[other], box.height, box.periodic_y)
                sigma = reach + slots.reach[other]
                if dx * dx + dy * dy <= sigma * sigma:
                    found = _note_pair(slot, other, slots, bodies, lists, thread, found)
    return found


@bare_kernel
def _level(
    level: int,
    begin: int,
    end: int,
    own: bool,
    grid: Grid,
    box: Box,
    slots: Slots,
    bodies: Bodies | None,
    start: NDArray[np.int32],
    lists: Lists,
    thread: int,
    found: int,
) -> int:
    """Note whom the discs in slots [begin, end) touch on one level: their `own`, later slots only, or a coarser one."""
    columns, rows, target = grid.columns[level], grid.rows[level], grid.first[level]
    across, along = columns / box.width, rows / box.height
    for slot in range(begin, end):
        column = cell_of(slots.x[slot], across, columns)
        row = cell_of(slots.y[slot], along, rows)
        if not (0 < column < columns - 1 and 0 < row < rows - 1):
            after = slot + 1 if own else 0
            found = _around(
                slot, after, column, row, level, grid, box, slots, bodies, start, lists, thread, found
            )
            continue
        cell = target + row * columns + column
        if own:
            # The rest of the own row to the right; the row below holds earlier slots only.
            found = _near(slot, slot + 1, start[cell + 2], slots, bodies, lists, thread, found)
        else:
            found = _near(slot, start[cell - 1], start[cell + 2], slots, bodies, lists, thread, found)
            cell -= columns
            found = _near(slot, start[cell - 1], start[cell + 2], slots, bodies, lists, thread, found)
            cell += columns
        cell += columns
        found = _near(slot, start[cell - 1], start[cell + 2], slots, bodies, lists, thread, found)
    return found


@bare_kernel
def _walls(begin: int, end: int, box: Box, slots: Slots, lists: Lists, thread: int, found: int) -> int:
    """Note the walls that the discs in slots [begin, end) are at or beyond."""
    n = slots.row.shape[0]
    for slot in range(begin, end):
        x, y, reach = slots.x[slot], slots.y[slot], slots.reach[slot]
        clear_x = box.periodic_x or (x > reach and x + reach < box.width)
        clear_y = box.periodic_y or (y > reach and y + reach < box.height)
        if clear_x and clear_y:
            continue
        key = n * n + 4 * int(slots.row[slot])
        if not box.periodic_x and x <= reach:
            found = _note(key, slot, lists, thread, found)
        if not box.periodic_x and x + reach >= box.width:
            found = _note(key + 1, slot, lists, thread, found)
        if not box.periodic_y and y <= reach:
            found = _note(key + 2, slot, lists, thread, found)
        if not box.periodic_y and y + reach >= box.height:
            found = _note(key + 3, slot, lists, thread, found)
    return found


@bare_kernel
def look(
    slots: Slots,
    box: Box,
    grid: Grid,
    room: Room,
    walls: Walls | None,
    bodies: Bodies | None,
    thread: int,
    threads: int,
) -> None:
    """List, in this thread's share of the slots, what touches; in ascending order if there is room for all.

    Walls of a plain rectangle are listed as well; those of an enclosure are not.
    """
    start, lists = room.end[threads - 1], room.lists
    first_slot, last_slot = share(slots.row.shape[0], thread, threads)
    found = 0
    levels = grid.columns.shape[0]
    for own in range(levels):
        begin, end = max(first_slot, start[grid.first[own]]), min(last_slot, start[grid.first[own + 1]])
        for level in range(own, levels):
            found = _level(
                level, begin, end, level == own, grid, box, slots, bodies, start, lists, thread, found
            )
    if walls is None:
        found = _walls(first_slot, last_slot, box, slots, lists, thread, found)
    lists.found[thread] = found
    if found <= lists.key.shape[1]:
        sort(lists.key[thread], lists.slot[thread], found)
