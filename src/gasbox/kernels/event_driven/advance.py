"""Execute events in the order of time."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, FULL, NO_PROGRESS, Box, Ledger
from gasbox.kernels.event_driven.ahead import foresee
from gasbox.kernels.event_driven.bounce import meet
from gasbox.kernels.event_driven.cells import cross, leave, schedule_crossing
from gasbox.kernels.event_driven.collide import bounce, collide, refer
from gasbox.kernels.event_driven.flight import note_speed
from gasbox.kernels.event_driven.queue import earliest, remove
from gasbox.kernels.event_driven.search import meet_moved, predict, predict_entered, release
from gasbox.kernels.event_driven.tables import (
    CROSSINGS,
    CURRENT,
    EVENTS,
    FETCHES,
    IDLE,
    LABEL,
    NOBODY,
    NOW,
    PARTNER,
    SORT_AT,
    SPECIES,
    STALE,
    STALES,
    T_CROSS,
    T_EVENT,
    WALL,
    Tables,
)
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.motion import next_turn
from gasbox.kernels.molecules.spin import Spin

__all__ = ["SORT", "TURN", "advance"]

SORT = 11
"""Status: neighbours have drifted apart in memory; sort the rows and rebuild, then call again."""


TURN = 12
"""Status: a wall comes to the end of a piece of its motion, or to a stop; set the next piece and call again."""


@inlined_kernel
def _free(tables: Tables, i: int) -> None:
    """Take particle i out of the queue, without an event."""
    remove(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, i)
    tables.flight[i, T_EVENT] = math.inf
    tables.link[i, PARTNER] = NOBODY


@inlined_kernel
def _pair_event(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    book: Ledger,
    i: int,
    j: int,
    now: float,
    epoch: float,
) -> None:
    _free(tables, i)
    _free(tables, j)
    if tables.link[j, LABEL] < tables.link[i, LABEL]:
        i, j = j, i
    collide(tables, box, hall, spin, book, i, j, now, epoch)
    schedule_crossing(tables.flight, tables.link, tables.levels, tables.sides, box, hall, i, now)
    schedule_crossing(tables.flight, tables.link, tables.levels, tables.sides, box, hall, j, now)
    predict(tables, box, hall, spin, i, now)
    # In a tiny periodic box i may have found another image of j.
    remove(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, j)
    if tables.link[j, PARTNER] >= 0:
        release(tables, tables.link[j, PARTNER])
    predict(tables, box, hall, spin, j, now)


@inlined_kernel
def _hall_event(
    tables: Tables,
    box: Box,
    hall: Hall,
    spin: Spin | None,
    book: Ledger,
    i: int,
    code: int,
    now: float,
    epoch: float,
) -> None:
    _free(tables, i)
    refer(tables, box, hall, spin, i, now)
    flight, link = tables.flight, tables.link
    piston = meet(tables, box, hall, spin, book, i, code, now, epoch)
    if link[i, SPECIES] < 0:
        leave(link, tables.head, i)
        flight[i, T_CROSS] = math.inf
        return
    note_speed(flight, tables.number, i)
    schedule_crossing(flight, link, tables.levels, tables.sides, box, hall, i, now)
    predict(tables, box, hall, spin, i, now)
    if piston >= 0:
        meet_moved(tables, hall, spin, box, piston, i, now)


@inlined_kernel
def _wall_event(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    book: Ledger,
    i: int,
    code: int,
    now: float,
    epoch: float,
) -> None:
    if hall is not None:
        _hall_event(tables, box, hall, spin, book, i, code, now, epoch)
        return
    wall = WALL - code
    _free(tables, i)
    bounce(tables, box, book, i, wall, now, epoch)
    schedule_crossing(tables.flight, tables.link, tables.levels, tables.sides, box, hall, i, now)
    predict(tables, box, hall, spin, i, now)


@inlined_kernel
def _cross_event(tables: Tables, box: Box, hall: Hall | None, spin: Spin | None, i: int, now: float) -> None:
    remove(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, i)
    flight, link, levels, sides = tables.flight, tables.link, tables.levels, tables.sides
    step_x, step_y = cross(flight, link, tables.head, levels, sides, box, hall, i, now)
    schedule_crossing(flight, link, levels, sides, box, hall, i, now)
    predict_entered(tables, box, hall, spin, i, now, step_x, step_y)
    tables.counter[CROSSINGS] += 1


@inlined_kernel
def _next_turn(hall: Hall | None) -> float:
    """When a wall changes its motion of itself."""
    if hall is None:
        return math.inf
    return next_turn(hall)


@bare_kernel
def advance(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    book: Ledger,
    until: float,
    epoch: float,
) -> int:
    """Execute all events up to and including the time `until`.

    Parameters
    ----------
    until : [time], since the start of the epoch, not beyond its end
    epoch : [time], start of the epoch

    Returns
    -------
    DONE, FULL (read the contacts, call again), SORT (sort the rows, rebuild, call again), TURN (a wall changes its
    motion, call again) or NO_PROGRESS (very many events at one moment).
    """
    flight, link, counter = tables.flight, tables.link, tables.counter
    limited = book.kind.shape[0] > 0
    patience = 1000 * (flight.shape[0] + 10)
    # Kept from call to call: otherwise contacts to read and rows to sort would renew the patience for ever.
    idle, latest = counter[IDLE], tables.number[NOW]
    foreseen = counter[CURRENT]
    turn = _next_turn(hall)
    while True:
        last = min(until, turn)
        i = earliest(flight, link, tables.ring, tables.heap, counter, tables.number, last)
        if counter[FETCHES]:
            while foreseen < counter[CURRENT]:
                foreseen += 1
                foresee(tables, counter[CURRENT] - foreseen)
        if i < 0:
            return TURN if turn <= until else DONE
        event, crossing, partner = flight[i, T_EVENT], flight[i, T_CROSS], link[i, PARTNER]
        now = min(event, crossing)
        if now > last:
            return TURN if turn <= until else DONE
        if now > latest:
            latest, idle = now, 0
        else:
            idle += 1
            if idle > patience:
                return NO_PROGRESS
        counter[IDLE] = idle
        if counter[EVENTS] >= counter[SORT_AT]:
            return SORT
        if crossing <= event:
            _cross_event(tables, box, hall, spin, i, now)
        elif partner == STALE:
            counter[STALES] += 1
            _free(tables, i)
            predict(tables, box, hall, spin, i, now)
        elif limited and book.rows[0] >= book.kind.shape[0]:
            return FULL
        elif partner >= 0:
            _pair_event(tables, box, hall, spin, book, i, partner, now, epoch)
        else:
            _wall_event(tables, box, hall, spin, book, i, partner, now, epoch)
            turn = _next_turn(hall)
        counter[EVENTS] += 1
        tables.number[NOW] = now
