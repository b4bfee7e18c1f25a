"""Executes what touches where there are molecules: sites strike each other until none approaches, then walls."""

from __future__ import annotations

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger
from gasbox.kernels.collision import nearest
from gasbox.kernels.stepped.between import divided
from gasbox.kernels.stepped.bodies import BOUNCES, CHANGED, CUT_SHORT, SWEEP, Bodies, is_single
from gasbox.kernels.stepped.execute import AHEAD, bounce_off, fetch_discs, first_of, is_across
from gasbox.kernels.stepped.settle import visit_all
from gasbox.kernels.stepped.sides import settle
from gasbox.kernels.stepped.strike import move_apart, strike, take_over
from gasbox.kernels.stepped.tables import Grid, Lists, Slots, Walls
from gasbox.kernels.stepped.visit import is_full

__all__ = ["execute_bodies"]

_SWEEPS = 8
"""Times that the touching pairs of a step are gone through; more are wanted only in a jam."""


@inlined_kernel
def _are_apart(
    a: int, b: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, time: float
) -> bool:
    """Whether a wall keeps two sites from each other."""
    if walls.near[slots.row[a]] != 1 and walls.near[slots.row[b]] != 1:
        return False
    dx = nearest(slots.x[a] - slots.x[b], box.width, box.periodic_x)
    dy = nearest(slots.y[a] - slots.y[b], box.height, box.periodic_y)
    return (
        is_across(a, slots, gas, box, grid, walls, time)
        or is_across(b, slots, gas, box, grid, walls, time)
        or divided(a, b, slots, gas, box, grid, walls, dx, dy)
    )


@inlined_kernel
def _meet(
    entry: int,
    first: bool,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls | None,
    book: Ledger,
    time: float,
) -> None:
    """Two sites meet, in the `first` sweep or a later one; single discs meet each other once."""
    a, b = entry & 0xFFFFFFFF, entry >> 32
    i, j = bodies.owner[slots.row[a]], bodies.owner[slots.row[b]]
    if not first and is_single(bodies, i) and is_single(bodies, j):
        return
    if walls is not None and _are_apart(a, b, slots, gas, box, grid, walls, time):
        return
    if strike(a, b, slots, gas, bodies, box, time, book):
        bodies.cursor[CHANGED] = 1
    if walls is not None and first:
        move_apart(a, b, slots, bodies, box, walls)


@bare_kernel
def _sweep(
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    lists: Lists,
    walls: Walls | None,
    book: Ledger,
    time: float,
    threads: int,
) -> bool:
    """Go through all pairs once, from where the lists stand; False if the contacts are full."""
    n = slots.row.shape[0]
    while True:
        best, key = first_of(lists, threads)
        if best < 0 or key >= n * n:
            return True
        if is_full(book):
            return False
        entry = int(lists.slot[best, lists.done[best]])
        fetch_discs(slots, int(lists.slot[best, min(lists.done[best] + AHEAD, lists.slot.shape[1] - 1)]))
        _meet(entry, bodies.cursor[SWEEP] == 0, slots, gas, bodies, box, grid, walls, book, time)
        lists.done[best] += 1


@bare_kernel
def _sides(
    slots: Slots, gas: Gas, bodies: Bodies, box: Box, lists: Lists, book: Ledger, time: float, threads: int
) -> bool:
    """What the sides of a plain rectangle do, from where the lists stand; False if the contacts are full."""
    n = slots.row.shape[0]
    while True:
        best, key = first_of(lists, threads)
        if best < 0:
            return True
        slot = int(lists.slot[best, lists.done[best]])
        row = bodies.owner[slots.row[slot]]
        if is_single(bodies, row):
            if is_full(book):
                return False
            bounce_off(slot, (key - n * n) & 3, slots, gas, time, book)
            take_over(slot, slots, bodies)
        elif not settle(row, gas, bodies, box, book, time):
            return False
        bodies.cursor[BOUNCES] = 0
        lists.done[best] += 1


@bare_kernel
def execute_bodies(
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    lists: Lists,
    walls: Walls | None,
    book: Ledger,
    time: float,
    threads: int,
) -> bool:
    """Execute the lists of all threads merged, from where they stand; return False if the contacts are full."""
    cursor = bodies.cursor
    while cursor[SWEEP] < _SWEEPS:
        if not _sweep(slots, gas, bodies, box, grid, lists, walls, book, time, threads):
            return False
        if cursor[CHANGED] == 0:
            cursor[SWEEP] = _SWEEPS
            break
        cursor[CHANGED] = 0
        cursor[SWEEP] += 1
        if cursor[SWEEP] == _SWEEPS:
            bodies.mishaps[CUT_SHORT] += 1
            break
        for thread in range(threads):
            lists.done[thread] = 0
    if walls is not None:
        return visit_all(slots, gas, bodies, box, grid, walls, book, time)
    return _sides(slots, gas, bodies, box, lists, book, time, threads)
