"""Executes what touches, in the prescribed order."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_pair, book_wall
from gasbox.kernels.collision import exchange, nearest
from gasbox.kernels.processor import fetch
from gasbox.kernels.stepped.between import divided
from gasbox.kernels.stepped.tables import PUSHED, Grid, Lists, Slots, Walls
from gasbox.kernels.stepped.visit import visit
from gasbox.kernels.stepped.ways import NONE, choices, earliest, elements, way_of

__all__ = ["AHEAD", "bounce_off", "execute", "fetch_discs", "first_of", "is_across", "is_clear"]

AHEAD = 8
"""Entries ahead of the one at hand whose memory is asked for: the next pair is anywhere."""


@inlined_kernel
def _part(a: int, b: int, slots: Slots, gas: Gas, walls: Walls, dx: float, dy: float) -> None:
    """Under gravity: move an overlapping pair apart about its centre of mass, which costs no energy."""
    if walls.hall.gx == 0.0 and walls.hall.gy == 0.0:
        return
    away = math.sqrt(dx * dx + dy * dy)
    depth = slots.reach[a] + slots.reach[b] - away
    if depth <= 0.0 or away == 0.0:
        return
    i, j = slots.row[a], slots.row[b]
    part = depth / away / (gas.mass[i] + gas.mass[j])
    slots.x[a] += part * gas.mass[j] * dx
    slots.y[a] += part * gas.mass[j] * dy
    slots.x[b] -= part * gas.mass[i] * dx
    slots.y[b] -= part * gas.mass[i] * dy
    walls.near[i] = walls.near[i] or PUSHED
    walls.near[j] = walls.near[j] or PUSHED


@inlined_kernel
def is_across(slot: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, time: float) -> bool:
    """Whether a disc has come across a wall that will put it back: where it is now it meets nobody."""
    row = slots.row[slot]
    if walls.near[row] != 1:
        return False
    way = way_of(row, slots, walls)
    where = elements(way, grid.level[row], box, grid, walls)
    found = earliest(way, where, box, walls, gas.species[row], slots.vx[slot], slots.vy[slot], time, True)
    return found[0] != NONE


@inlined_kernel
def _meet(
    a: int, b: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, time: float, book: Ledger
) -> None:
    """As `_collide`, in an enclosure: not through walls, and under gravity nobody sinks into anybody."""
    dx = nearest(slots.x[a] - slots.x[b], box.width, box.periodic_x)
    dy = nearest(slots.y[a] - slots.y[b], box.height, box.periodic_y)
    if (walls.near[slots.row[a]] == 1 or walls.near[slots.row[b]] == 1) and (
        is_across(a, slots, gas, box, grid, walls, time)
        or is_across(b, slots, gas, box, grid, walls, time)
        or divided(a, b, slots, gas, box, grid, walls, dx, dy)
    ):
        return
    _collide(a, b, slots, gas, box, time, book)
    _part(a, b, slots, gas, walls, dx, dy)


@inlined_kernel
def _collide(a: int, b: int, slots: Slots, gas: Gas, box: Box, time: float, book: Ledger) -> None:
    """Execute the collision of the discs in slots `a` (lower id) and `b`, if they approach."""
    dx = nearest(slots.x[a] - slots.x[b], box.width, box.periodic_x)
    dy = nearest(slots.y[a] - slots.y[b], box.height, box.periodic_y)
    dvx = slots.vx[a] - slots.vx[b]
    dvy = slots.vy[a] - slots.vy[b]
    if dvx * dx + dvy * dy >= 0.0:
        return
    i, j = slots.row[a], slots.row[b]
    change_i, change_j, impulse, virial = exchange(dx, dy, dvx, dvy, gas.mass[i], gas.mass[j])
    slots.vx[a] -= change_i * dx
    slots.vy[a] -= change_i * dy
    slots.vx[b] += change_j * dx
    slots.vy[b] += change_j * dy
    book_pair(book, gas.species[i], gas.species[j], i, j, time, -impulse * dx, -impulse * dy, virial)


@inlined_kernel
def bounce_off(slot: int, wall: int, slots: Slots, gas: Gas, time: float, book: Ledger) -> None:
    """Turn a disc at a wall (0 left, 1 right, 2 bottom, 3 top) round, if it moves towards it."""
    speed = slots.vx[slot] if wall < 2 else slots.vy[slot]
    if speed >= 0.0 if wall % 2 == 0 else speed <= 0.0:
        return
    i = slots.row[slot]
    given = -2.0 * gas.mass[i] * speed
    if wall < 2:
        slots.vx[slot] = -speed
        book_wall(book, gas.species[i], i, wall, time, given, 0.0)
    else:
        slots.vy[slot] = -speed
        book_wall(book, gas.species[i], i, wall, time, 0.0, given)


@inlined_kernel
def first_of(lists: Lists, threads: int) -> tuple[int, int]:
    """The thread whose next entry comes first (-1 if there is none), and the key of this entry."""
    best, key = -1, 0
    for thread in range(threads):
        entry = lists.done[thread]
        if entry < lists.found[thread] and (best < 0 or lists.key[thread, entry] < key):
            best, key = thread, int(lists.key[thread, entry])
    return best, key


@inlined_kernel
def fetch_discs(slots: Slots, entry: int) -> None:
    """Ask for what the collision in an entry of the lists will touch."""
    for slot in (entry & 0xFFFFFFFF, entry >> 32):
        fetch(slots.x, slot)
        fetch(slots.y, slot)
        fetch(slots.vx, slot)
        fetch(slots.vy, slot)
        fetch(slots.row, slot)


@inlined_kernel
def is_clear(row: int, slots: Slots, box: Box, grid: Grid, walls: Walls) -> bool:
    """Whether a disc that was only pushed is far from all walls."""
    if walls.near[row] != PUSHED:
        return False
    way = way_of(row, slots, walls)
    if (box.periodic_x and not 0.0 <= way[2] < box.width) or (
        box.periodic_y and not 0.0 <= way[3] < box.height
    ):
        return False
    where = elements(way, grid.level[row], box, grid, walls)
    return where[0] != NONE and choices(where, walls) == 0


@bare_kernel
def _visit_walls(
    slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """All that walls do in this step, disc by disc, from where they stand; False if the contacts are full."""
    cursor = walls.cursor
    n = slots.row.shape[0]
    while cursor[0] < n:
        row = cursor[0]
        if walls.near[row] and not (
            is_clear(row, slots, box, grid, walls) or visit(row, slots, gas, box, grid, walls, book, time)
        ):
            return False
        cursor[0] += 1
    cursor[0] = 0
    return True


@bare_kernel
def execute(
    slots: Slots,
    gas: Gas,
    box: Box,
    grid: Grid,
    lists: Lists,
    walls: Walls | None,
    book: Ledger,
    time: float,
    threads: int,
) -> bool:
    """Execute the lists of all threads merged, from where they stand; return False if the contacts are full."""
    n = slots.row.shape[0]
    while True:
        best, key = first_of(lists, threads)
        if best < 0:
            break
        if book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]:
            return False
        entry = int(lists.slot[best, lists.done[best]])
        fetch_discs(slots, int(lists.slot[best, min(lists.done[best] + AHEAD, lists.slot.shape[1] - 1)]))
        if walls is not None:
            _meet(entry & 0xFFFFFFFF, entry >> 32, slots, gas, box, grid, walls, time, book)
        elif key < n * n:
            _collide(entry & 0xFFFFFFFF, entry >> 32, slots, gas, box, time, book)
        else:
            bounce_off(entry, (key - n * n) & 3, slots, gas, time, book)
        lists.done[best] += 1
    if walls is not None:
        return _visit_walls(slots, gas, box, grid, walls, book, time)
    return True
