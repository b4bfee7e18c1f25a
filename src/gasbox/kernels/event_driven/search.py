"""Find the next event of a particle, and make it mutual.

Each particle holds one next event. A pair is taken only if it precedes the events that both already hold; whoever
loses a partner by that keeps the time, marked STALE, and looks again then (most stale events are overwritten before).

Source: the one-event bookkeeping of B. D. Lubachevsky, J. Comput. Phys. 94, 255 (1991),
doi:10.1016/0021-9991(91)90222-7.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.flight import wall_meeting
from gasbox.kernels.event_driven.look import survey
from gasbox.kernels.event_driven.queue import insert, remove, rise
from gasbox.kernels.event_driven.tables import (
    COLUMN,
    COLUMNS,
    LEVEL,
    NOBODY,
    PARTNER,
    PREDICTIONS,
    ROW,
    ROWS,
    STALE,
    T_EVENT,
    Tables,
)

__all__ = ["predict", "predict_entered", "release"]


@inlined_kernel
def release(tables: Tables, k: int) -> None:
    """Particle k has lost its partner: it keeps the time and will look again then."""
    tables.link[k, PARTNER] = STALE
    rise(tables.flight, tables.link, tables.ring, tables.heap, k)


@inlined_kernel
def _hold(tables: Tables, i: int, time: float, who: int) -> None:
    """Give particle i its next event, and its partner the same; file both."""
    flight, link, ring, heap = tables.flight, tables.link, tables.ring, tables.heap
    counter, number = tables.counter, tables.number
    if who >= 0:
        lost = link[who, PARTNER]
        if lost >= 0:
            release(tables, lost)
        remove(flight, link, ring, heap, counter, who)
        flight[who, T_EVENT] = time
        link[who, PARTNER] = i
        insert(flight, link, ring, heap, counter, number, who)
    flight[i, T_EVENT] = time
    link[i, PARTNER] = who
    insert(flight, link, ring, heap, counter, number, i)


@inlined_kernel
def _at_wall(tables: Tables, box: Box, i: int) -> tuple[float, int]:
    """The next wall that particle i meets, looked for in the outermost cells only."""
    level = tables.link[i, LEVEL]
    columns, rows = tables.levels[level, COLUMNS], tables.levels[level, ROWS]
    column, row = tables.link[i, COLUMN], tables.link[i, ROW]
    at_x = not box.periodic_x and (column == 0 or column == columns - 1)
    at_y = not box.periodic_y and (row == 0 or row == rows - 1)
    if at_x or at_y:
        return wall_meeting(tables.flight, i, box.width, box.height, at_x, at_y)
    return math.inf, NOBODY


@bare_kernel
def predict(tables: Tables, box: Box, i: int, now: float) -> None:
    """Look for the next event of particle i among everything around it.

    Precondition: i is not filed, nobody holds i as a partner; its cell and crossing time are up to date.
    """
    tables.counter[PREDICTIONS] += 1
    time, who = _at_wall(tables, box, i)
    if time == math.inf:
        who = NOBODY
    time, who = survey(tables, box, i, now, 0, 0, True, time, who)
    _hold(tables, i, time, who)


@bare_kernel
def predict_entered(tables: Tables, box: Box, i: int, now: float, step_x: int, step_y: int) -> None:
    """Look for an earlier event of particle i in the cells that a crossing has brought near (no step: all around).

    Precondition: i is not filed; its cell and crossing time are up to date.
    """
    held, partner = tables.flight[i, T_EVENT], tables.link[i, PARTNER]
    time, who = held, partner
    wall_time, wall = _at_wall(tables, box, i)
    if wall_time < time:
        time, who = wall_time, wall
    time, who = survey(tables, box, i, now, step_x, step_y, False, time, who)
    if partner >= 0:
        if who == partner and time == held:
            insert(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, tables.number, i)
            return
        release(tables, partner)
    _hold(tables, i, time, who)
