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
from gasbox.kernels.event_driven.flight import place_at, velocity_at
from gasbox.kernels.event_driven.look import survey
from gasbox.kernels.event_driven.queue import insert, remove, rise
from gasbox.kernels.event_driven.tables import (
    NOBODY,
    PARTNER,
    PREDICTIONS,
    RADIUS,
    SPECIES,
    STALE,
    T0,
    T_EVENT,
    WALL,
    Tables,
)
from gasbox.kernels.event_driven.walls import at_moving_walls, next_wall, ranks_first
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.motion import displacement, push, speed
from gasbox.kernels.hall.tables import KIND, NX, NY, PX, PY, SIDE
from gasbox.kernels.hall.tables import WALL as OWNER
from gasbox.kernels.molecules.spin import Spin

__all__ = ["meet_moved", "predict", "predict_entered", "release"]


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
def _line(hall: Hall, wall: int, now: float) -> tuple[float, float, float]:
    """Normal of a wall that moves, and where its line is along it."""
    for e in hall.moving:
        if hall.kind[e, OWNER] == wall and hall.kind[e, KIND] == SIDE:
            nx, ny = hall.shape[e, NX], hall.shape[e, NY]
            at = hall.shape[e, PX] * nx + hall.shape[e, PY] * ny
            return nx, ny, at + displacement(hall, wall, now)
    return 0.0, 0.0, 0.0


@bare_kernel
def meet_moved(
    tables: Tables, hall: Hall, spin: Spin | None, box: Box, wall: int, but: int, now: float
) -> None:
    """A wall has changed its motion: all particles except `but` look for it anew.

    Most need not: those that cannot reach its line before their next event, whatever they do.
    """
    flight, link = tables.flight, tables.link
    nx, ny, line = _line(hall, wall, now)
    rate, pull = speed(hall, wall, now), push(hall, wall, now)
    curve = 0.5 * abs(hall.gx * nx + hall.gy * ny - pull)
    for i in range(flight.shape[0]):
        if i == but or link[i, SPECIES] < 0:
            continue
        partner = link[i, PARTNER]
        held = partner <= WALL and hall.kind[(WALL - partner) // 2, OWNER] == wall
        if flight[i, T_EVENT] < math.inf:
            elapsed, ahead = now - flight[i, T0], flight[i, T_EVENT] - now
            x, y = place_at(flight, hall, i, elapsed)
            vx, vy = velocity_at(flight, hall, i, elapsed)
            way = (abs(vx * nx + vy * ny - rate) + curve * ahead) * ahead
            if abs(x * nx + y * ny - line) - flight[i, RADIUS] > way * 1.000001:
                if held:
                    release(tables, i)
                continue
        time, who = at_moving_walls(
            tables, hall, spin, i, wall, flight[i, T_EVENT], NOBODY if held else partner
        )
        if held and who == NOBODY:
            # Whatever else it may meet comes no sooner than the meeting that falls away.
            release(tables, i)
        elif who != partner or held:
            if partner >= 0:
                release(tables, partner)
            remove(flight, link, tables.ring, tables.heap, tables.counter, i)
            _hold(tables, i, time, who)


@bare_kernel
def predict(tables: Tables, box: Box, hall: Hall | None, spin: Spin | None, i: int, now: float) -> None:
    """Look for the next event of particle i among everything around it.

    Precondition: i is not filed, nobody holds i as a partner; its cell and crossing time are up to date.
    """
    tables.counter[PREDICTIONS] += 1
    time, who = next_wall(tables, box, hall, spin, i, now, True)
    if time == math.inf:
        who = NOBODY
    time, who = survey(tables, box, hall, spin, i, now, 0, 0, True, time, who)
    _hold(tables, i, time, who)


@bare_kernel
def predict_entered(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    i: int,
    now: float,
    step_x: int,
    step_y: int,
) -> None:
    """Look for an earlier event of particle i in the cells that a crossing has brought near (no step: all around).

    Precondition: i is not filed; its cell and crossing time are up to date.
    """
    held, partner = tables.flight[i, T_EVENT], tables.link[i, PARTNER]
    time, who = held, partner
    wall_time, wall = next_wall(tables, box, hall, spin, i, now, step_x == 0 and step_y == 0)
    if wall_time < time or ranks_first(hall, wall_time, wall, time, who):
        time, who = wall_time, wall
    time, who = survey(tables, box, hall, spin, i, now, step_x, step_y, False, time, who)
    if partner >= 0:
        if who == partner and time == held:
            insert(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, tables.number, i)
            return
        release(tables, partner)
    _hold(tables, i, time, who)
