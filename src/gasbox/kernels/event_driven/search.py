"""Find the next event of a particle, and make it mutual.

Each particle holds one next event. A pair is taken only if it precedes the events that both already hold; whoever
loses a partner by that keeps the time, marked STALE, and looks again then (most stale events are overwritten before).

Source: the one-event bookkeeping of B. D. Lubachevsky, J. Comput. Phys. 94, 255 (1991),
doi:10.1016/0021-9991(91)90222-7.
"""

from __future__ import annotations

import math

import numpy as np

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.flight import place_at, velocity_at, wall_meeting
from gasbox.kernels.event_driven.look import survey
from gasbox.kernels.event_driven.queue import insert, remove, rise
from gasbox.kernels.event_driven.tables import (
    CELL,
    COLUMN,
    COLUMNS,
    HORIZON,
    LEVEL,
    NOBODY,
    PARTNER,
    PREDICTIONS,
    RADIUS,
    ROW,
    ROWS,
    SPECIES,
    STALE,
    T0,
    T_EVENT,
    VX,
    VY,
    WALL,
    Tables,
    X,
    Y,
)
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.approach import touch
from gasbox.kernels.hall.motion import displacement, push, speed
from gasbox.kernels.hall.tables import KIND, NX, NY, PX, PY, SIDE
from gasbox.kernels.hall.tables import WALL as OWNER

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


@inlined_kernel
def _disc(tables: Tables, i: int) -> tuple[float, float, float, float, float, float]:
    flight = tables.flight
    return (flight[i, X], flight[i, Y], flight[i, VX], flight[i, VY], flight[i, T0], flight[i, RADIUS])


@inlined_kernel
def _sooner(time: float, code: int, best: float, who: int) -> bool:
    """Whether a meeting with an element comes before what was found so far: at one time, pairs and lower numbers do."""
    if time != best:
        return time < best
    return who <= WALL and code > who


@bare_kernel
def at_moving_walls(
    tables: Tables, hall: Hall, i: int, wall: int, best: float, who: int
) -> tuple[float, int]:
    """The next meeting of particle i with a wall that moves (number `wall`, or any if below 0), if it precedes."""
    flight = _disc(tables, i)
    species, horizon = tables.link[i, SPECIES], tables.number[HORIZON]
    for e in hall.moving:
        if wall < 0 or hall.kind[e, OWNER] == wall:
            time, what = touch(hall, e, flight, species, 0.0, 0.0, horizon)
            code = WALL - (2 * e + what)
            if time < math.inf and _sooner(time, code, best, who):
                best, who = time, code
    return best, who


@bare_kernel
def _at_elements(
    tables: Tables, box: Box, hall: Hall, i: int, now: float, all_walls: bool
) -> tuple[float, int]:
    """The next element that particle i meets: of those at rest near its cell, and of all that move if `all_walls`."""
    flight, link = tables.flight, tables.link
    best, who = math.inf, NOBODY
    cell, level = link[i, CELL], link[i, LEVEL]
    begin, end = hall.first[cell], hall.first[cell + 1]
    if begin < end:
        around_x, around_y = 0.0, 0.0
        if box.periodic_x or box.periodic_y:
            # By how many lengths of the box is its straight way ahead of the cell that it is filed in?
            x, y = place_at(flight, hall, i, now - flight[i, T0])
            if box.periodic_x:
                middle = (link[i, COLUMN] + 0.5) * tables.sides[level, 0]
                around_x = np.rint((x - middle) / box.width)
            if box.periodic_y:
                middle = (link[i, ROW] + 0.5) * tables.sides[level, 1]
                around_y = np.rint((y - middle) / box.height)
        disc, species = _disc(tables, i), link[i, SPECIES]
        for entry in range(begin, end):
            e = hall.near[entry]
            shift_x = (hall.image[entry, 0] + around_x) * box.width
            shift_y = (hall.image[entry, 1] + around_y) * box.height
            time, what = touch(hall, e, disc, species, shift_x, shift_y, tables.number[HORIZON])
            code = WALL - (2 * e + what)
            if time < math.inf and _sooner(time, code, best, who):
                best, who = time, code
    if all_walls and hall.moving.shape[0] > 0:
        best, who = at_moving_walls(tables, hall, i, -1, best, who)
    return best, who


@inlined_kernel
def _ranks_first(hall: Hall | None, time: float, code: int, best: float, who: int) -> bool:
    """Whether of two elements that are met at one time the first has the lower number."""
    if hall is None:
        return False
    return time < math.inf and _sooner(time, code, best, who)


@inlined_kernel
def _next_wall(
    tables: Tables, box: Box, hall: Hall | None, i: int, now: float, all_walls: bool
) -> tuple[float, int]:
    if hall is None:
        return _at_wall(tables, box, i)
    return _at_elements(tables, box, hall, i, now, all_walls)


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
def meet_moved(tables: Tables, hall: Hall, box: Box, wall: int, but: int, now: float) -> None:
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
        time, who = at_moving_walls(tables, hall, i, wall, flight[i, T_EVENT], NOBODY if held else partner)
        if held and who == NOBODY:
            # Whatever else it may meet comes no sooner than the meeting that falls away.
            release(tables, i)
        elif who != partner or held:
            if partner >= 0:
                release(tables, partner)
            remove(flight, link, tables.ring, tables.heap, tables.counter, i)
            _hold(tables, i, time, who)


@bare_kernel
def predict(tables: Tables, box: Box, hall: Hall | None, i: int, now: float) -> None:
    """Look for the next event of particle i among everything around it.

    Precondition: i is not filed, nobody holds i as a partner; its cell and crossing time are up to date.
    """
    tables.counter[PREDICTIONS] += 1
    time, who = _next_wall(tables, box, hall, i, now, True)
    if time == math.inf:
        who = NOBODY
    time, who = survey(tables, box, hall, i, now, 0, 0, True, time, who)
    _hold(tables, i, time, who)


@bare_kernel
def predict_entered(
    tables: Tables, box: Box, hall: Hall | None, i: int, now: float, step_x: int, step_y: int
) -> None:
    """Look for an earlier event of particle i in the cells that a crossing has brought near (no step: all around).

    Precondition: i is not filed; its cell and crossing time are up to date.
    """
    held, partner = tables.flight[i, T_EVENT], tables.link[i, PARTNER]
    time, who = held, partner
    wall_time, wall = _next_wall(tables, box, hall, i, now, step_x == 0 and step_y == 0)
    if wall_time < time or _ranks_first(hall, wall_time, wall, time, who):
        time, who = wall_time, wall
    time, who = survey(tables, box, hall, i, now, step_x, step_y, False, time, who)
    if partner >= 0:
        if who == partner and time == held:
            insert(tables.flight, tables.link, tables.ring, tables.heap, tables.counter, tables.number, i)
            return
        release(tables, partner)
    _hold(tables, i, time, who)
