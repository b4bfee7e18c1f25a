"""Executes what touches, in the prescribed order."""

from __future__ import annotations

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_pair, book_wall
from gasbox.kernels.collision import exchange, nearest
from gasbox.kernels.processor import fetch
from gasbox.kernels.stepped.tables import Lists, Slots

__all__ = ["execute"]


_AHEAD = 8
"""Entries ahead of the one at hand whose memory is asked for: the next pair is anywhere."""


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
def _bounce(slot: int, wall: int, slots: Slots, gas: Gas, time: float, book: Ledger) -> None:
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
def _fetch_discs(slots: Slots, entry: int) -> None:
    """Ask for what the collision in an entry of the lists will touch."""
    for slot in (entry & 0xFFFFFFFF, entry >> 32):
        fetch(slots.x, slot)
        fetch(slots.y, slot)
        fetch(slots.vx, slot)
        fetch(slots.vy, slot)
        fetch(slots.row, slot)


@bare_kernel
def execute(slots: Slots, gas: Gas, box: Box, lists: Lists, book: Ledger, time: float, threads: int) -> bool:
    """Execute the lists of all threads merged, from where they stand; return False if the contacts are full."""
    n = slots.row.shape[0]
    while True:
        best, key = -1, 0
        for thread in range(threads):
            entry = lists.done[thread]
            if entry < lists.found[thread] and (best < 0 or lists.key[thread, entry] < key):
                best, key = thread, int(lists.key[thread, entry])
        if best < 0:
            return True
        if book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]:
            return False
        entry = int(lists.slot[best, lists.done[best]])
        _fetch_discs(slots, int(lists.slot[best, min(lists.done[best] + _AHEAD, lists.slot.shape[1] - 1)]))
        if key < n * n:
            _collide(entry & 0xFFFFFFFF, entry >> 32, slots, gas, box, time, book)
        else:
            _bounce(entry, (key - n * n) & 3, slots, gas, time, book)
        lists.done[best] += 1
