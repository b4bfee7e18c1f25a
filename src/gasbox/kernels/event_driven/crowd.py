"""Look for the earliest meeting of a particle in a crowd."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.cells import wrapped
from gasbox.kernels.event_driven.flight import meeting_time
from gasbox.kernels.event_driven.pairs import HEAD_ON, LATEST, TIED, apart, precedes, preferred
from gasbox.kernels.event_driven.tables import (
    COLUMNS,
    FIRST,
    NEXT,
    RADIUS,
    ROWS,
    T0,
    T_EVENT,
    TESTS,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.hall import Hall

__all__ = ["sift"]


@bare_kernel
def sift(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    i: int,
    now: float,
    level: int,
    block: tuple[int, int, int, int],
    best: float,
    who: int,
) -> tuple[float, int]:
    """The earliest meeting of i in a block of cells (first and last column, row), if it precedes (best, who).

    List who is there, keep those who might come in time, then time these.
    Both choices are made without branches: who is there and who comes nearer are toss-ups, and wrong guesses would
    cost the processor more than the arithmetic. Precondition: a level with CROWDED, whose cells are so narrow that
    discs of one size class which do not overlap cannot fill the list.
    """
    flight, link, head, near = tables.flight, tables.link, tables.head, tables.near
    columns, rows, first = (
        tables.levels[level, COLUMNS],
        tables.levels[level, ROWS],
        tables.levels[level, FIRST],
    )
    own = (flight[i, X], flight[i, Y], flight[i, VX], flight[i, VY], flight[i, T0], flight[i, RADIUS])
    across = 1.0 / box.width if box.periodic_x else 0.0
    along = 1.0 / box.height if box.periodic_y else 0.0
    count = 0
    for row in range(block[2], block[3] + 1):
        base = first + wrapped(row, rows) * columns
        for column in range(block[0], block[1] + 1):
            j = head[base + wrapped(column, columns)]
            near[count] = j
            count += j >= 0
            j = link[max(j, 0), NEXT] if j >= 0 else j
            near[count] = j
            count += j >= 0
            while j >= 0:
                j = link[j, NEXT]
                near[count] = j
                count += j >= 0
    tables.counter[TESTS] += count
    kept = 0
    for place in range(count):
        j = near[place]
        dx, dy, dvx, dvy, sigma, start = apart(own, flight, hall, j, now, box, across, along)
        b = dx * dvx + dy * dvy
        c = dx * dx + dy * dy - sigma * sigma
        near[kept] = j
        latest = min(best, flight[j, T_EVENT], LATEST)
        kept += (b < 0.0) & (c <= (TIED * latest - start) * HEAD_ON * b)
    for place in range(kept):
        j = near[place]
        dx, dy, dvx, dvy, sigma, start = apart(own, flight, hall, j, now, box, across, along)
        time = meeting_time(dx, dy, dvx, dvy, sigma, start)
        if (
            time <= best
            and time <= flight[j, T_EVENT]
            and time < math.inf
            and preferred(link, time, i, j, best, who)
            and precedes(flight, link, time, i, j, j)
        ):
            best, who = time, j
    return best, who
