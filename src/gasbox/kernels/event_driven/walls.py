"""Look for the next wall or element that a particle meets."""

from __future__ import annotations

import math

import numpy as np

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.flight import place_at, wall_meeting
from gasbox.kernels.event_driven.tables import (
    CELL,
    COLUMN,
    COLUMNS,
    HORIZON,
    LEVEL,
    NOBODY,
    RADIUS,
    ROW,
    ROWS,
    SPECIES,
    T0,
    VX,
    VY,
    WALL,
    Tables,
    X,
    Y,
)
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.approach import BOUNCE, touch
from gasbox.kernels.hall.bodies import touch_body
from gasbox.kernels.hall.tables import OPEN
from gasbox.kernels.hall.tables import WALL as OWNER
from gasbox.kernels.molecules.spin import ANGLE, ARM, TURNING, Spin, is_disc

__all__ = ["at_moving_walls", "next_wall", "ranks_first"]


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
def _touch(
    tables: Tables,
    hall: Hall,
    spin: Spin | None,
    i: int,
    e: int,
    disc: tuple[float, float, float, float, float, float],
    shift_x: float,
    shift_y: float,
    best: float,
) -> tuple[float, int]:
    """When particle i meets an element, and what happens then; of a molecule only if not after `best`."""
    species, horizon = tables.link[i, SPECIES], tables.number[HORIZON]
    if spin is None:
        return touch(hall, e, disc, species, shift_x, shift_y, horizon)
    return _touch_with(hall, spin, i, e, disc, species, shift_x, shift_y, horizon, best)


@bare_kernel
def _touch_with(
    hall: Hall,
    spin: Spin,
    i: int,
    e: int,
    disc: tuple[float, float, float, float, float, float],
    species: int,
    shift_x: float,
    shift_y: float,
    horizon: float,
    best: float,
) -> tuple[float, int]:
    """As `_touch`. Walls that a molecule passes know its centre of mass alone."""
    number = hall.kind[e, OWNER]
    if is_disc(spin, species) or hall.rule[number, OPEN] or hall.passes[number, species]:
        return touch(hall, e, disc, species, shift_x, shift_y, horizon)
    turn, until = spin.turn, min(horizon, best)
    angle, omega, arm = turn[i, ANGLE], turn[i, TURNING], turn[i, ARM]
    return touch_body(hall, spin, e, disc, species, angle, omega, arm, shift_x, shift_y, until), BOUNCE


@inlined_kernel
def _sooner(time: float, code: int, best: float, who: int) -> bool:
    """Whether a meeting with an element comes before what was found so far: at one time, pairs and lower numbers do."""
    if time != best:
        return time < best
    return who <= WALL and code > who


@bare_kernel
def at_moving_walls(
    tables: Tables, hall: Hall, spin: Spin | None, i: int, wall: int, best: float, who: int
) -> tuple[float, int]:
    """The next meeting of particle i with a wall that moves (number `wall`, or any if below 0), if it precedes."""
    disc = _disc(tables, i)
    for e in hall.moving:
        if wall < 0 or hall.kind[e, OWNER] == wall:
            time, what = _touch(tables, hall, spin, i, e, disc, 0.0, 0.0, best)
            code = WALL - (2 * e + what)
            if time < math.inf and _sooner(time, code, best, who):
                best, who = time, code
    return best, who


@bare_kernel
def _at_elements(
    tables: Tables, box: Box, hall: Hall, spin: Spin | None, i: int, now: float, all_walls: bool
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
        disc = _disc(tables, i)
        for entry in range(begin, end):
            e = hall.near[entry]
            shift_x = (hall.image[entry, 0] + around_x) * box.width
            shift_y = (hall.image[entry, 1] + around_y) * box.height
            time, what = _touch(tables, hall, spin, i, e, disc, shift_x, shift_y, best)
            code = WALL - (2 * e + what)
            if time < math.inf and _sooner(time, code, best, who):
                best, who = time, code
    if all_walls and hall.moving.shape[0] > 0:
        best, who = at_moving_walls(tables, hall, spin, i, -1, best, who)
    return best, who


@inlined_kernel
def ranks_first(hall: Hall | None, time: float, code: int, best: float, who: int) -> bool:
    """Whether of two elements that are met at one time the first has the lower number."""
    if hall is None:
        return False
    return time < math.inf and _sooner(time, code, best, who)


@inlined_kernel
def next_wall(
    tables: Tables, box: Box, hall: Hall | None, spin: Spin | None, i: int, now: float, all_walls: bool
) -> tuple[float, int]:
    """Time and code of the next wall or element that particle i meets; infinity if none."""
    if hall is None:
        return _at_wall(tables, box, i)
    return _at_elements(tables, box, hall, spin, i, now, all_walls)
