"""Fetch from memory ahead of time what coming events will touch, in a gas that does not fit the caches.

The next event is anywhere in the box, and its neighbours with it. But the calendar knows the events of the buckets to
come, so their rows, the cells around them and the discs in these are asked for some events before they are needed.
Fetching touches nothing, so it changes no bit.
"""

from __future__ import annotations

import numpy as np

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.event_driven.tables import (
    CELL,
    COLUMNS,
    FILED,
    FIRST_ENTRY,
    LEVEL,
    NEXT,
    PARTNER,
    PLACE,
    RING_AT,
    T0,
    T_CROSS,
    T_EVENT,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.processor import fetch

__all__ = ["foresee"]

_APART = 10
"""Buckets between the stages."""


@inlined_kernel
def _fetch_disc(tables: Tables, i: int) -> None:
    fetch(tables.flight, i)
    fetch(tables.link, i)


@inlined_kernel
def _fetch_listed(tables: Tables, cell: int, rank: int) -> None:
    """Ask for the first (`rank` 0) or second disc in a cell."""
    if 0 <= cell < tables.head.shape[0]:
        j = tables.head[cell]
        if rank > 0 and j >= 0:
            j = tables.link[j, NEXT]
        if j >= 0:
            _fetch_disc(tables, j)


@inlined_kernel
def _fetch_entered(tables: Tables, i: int, cell: int, columns: int, rank: int) -> None:
    """Ask for discs in the three cells that disc i will meet when it crosses into the next cell."""
    flight, level = tables.flight, tables.link[i, LEVEL]
    elapsed = flight[i, T_CROSS] - flight[i, T0]
    across = (flight[i, X] + flight[i, VX] * elapsed) / tables.sides[level, 0]
    along = (flight[i, Y] + flight[i, VY] * elapsed) / tables.sides[level, 1]
    if abs(across - np.rint(across)) < abs(along - np.rint(along)):
        middle, step = cell + (2 if flight[i, VX] > 0.0 else -2), columns
    else:
        middle, step = cell + (2 * columns if flight[i, VY] > 0.0 else -2 * columns), 1
    for near in range(-1, 2):
        _fetch_listed(tables, middle + near * step, rank)


@inlined_kernel
def _fetch_around(tables: Tables, cell: int, columns: int, rank: int) -> None:
    """Ask for discs in the 3 x 3 cells around one."""
    for line in range(-1, 2):
        for near in range(-1, 2):
            _fetch_listed(tables, cell + line * columns + near, rank)


@bare_kernel
def foresee(tables: Tables, behind: int) -> None:
    """Ask for what the events some buckets ahead will touch: stage by stage, since each leads to the next.

    Parameters
    ----------
    behind : how many buckets the one to reckon from lies behind the current one
    """
    link, ring, head = tables.link, tables.ring, tables.head
    for stage in range(5):
        place = tables.counter[RING_AT] - behind + _APART * (5 - stage)
        place -= ring.shape[0] if place >= ring.shape[0] else 0
        if stage == 0:
            fetch(ring, place)
            continue
        for entry in range(FIRST_ENTRY, ring[place, FILED]):
            i = ring[place, entry]
            if stage == 1:
                _fetch_disc(tables, i)
                continue
            if link[i, PLACE] != place:
                continue
            cell, columns = link[i, CELL], tables.levels[link[i, LEVEL], COLUMNS]
            crosses = tables.flight[i, T_CROSS] <= tables.flight[i, T_EVENT]
            if stage == 2:
                reach = 2 if crosses else 1
                for line in range(-reach, reach + 1):
                    fetch(head, cell + line * columns)
                if link[i, PARTNER] >= 0 and not crosses:
                    _fetch_disc(tables, link[i, PARTNER])
            elif crosses:
                _fetch_entered(tables, i, cell, columns, stage - 3)
            else:
                _fetch_around(tables, cell, columns, stage - 3)
