"""What the walls do to one disc in one step: put it back, turn it round, let it pass, or let it go."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_crossing
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.tables import (
    CORNER,
    FACES,
    HIGH,
    KIND,
    LOW,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    RHO,
    SIDE,
    TX,
    TY,
    WALL,
)
from gasbox.kernels.stepped.bounce import bounce, leave
from gasbox.kernels.stepped.tables import Grid, Slots, Walls
from gasbox.kernels.stepped.ways import (
    NONE,
    Way,
    choices,
    choose,
    earliest,
    elements,
    lets_pass,
    put_back,
    side_crossing,
    way_of,
)

__all__ = [
    "ATTEMPTS",
    "COUNT",
    "CROSS",
    "DONE",
    "PART",
    "TOUCH",
    "code_of",
    "count_way",
    "is_full",
    "overlap",
    "visit",
]

CROSS, TOUCH, COUNT = 0, 1, 2
"""The parts of a visit."""
ATTEMPTS = 8
"""Times that a disc is put back in a step; one needs more only between walls that crush it."""
PART, DONE = 1, 2
"""Columns of the cursor."""


@inlined_kernel
def is_full(book: Ledger) -> bool:
    """Whether there is no room for another contact."""
    return book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]


@inlined_kernel
def code_of(e: int, image_x: int, image_y: int) -> int:
    """Order of elements and images."""
    return (e * 256 + image_y + 128) * 256 + image_x + 128


@bare_kernel
def _turn_back(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Nobody gets across a wall: whoever would is put to where it first touched; False if the contacts are full."""
    hall, cursor, slot = walls.hall, walls.cursor, walls.slot[row]
    species, level = gas.species[row], grid.level[row]
    while True:
        way = way_of(row, slots, walls)
        where = elements(way, level, box, grid, walls)
        e, sx, sy, _ = earliest(way, where, box, walls, species, slots.vx[slot], slots.vy[slot], time, True)
        if e == NONE:
            return True
        if is_full(book):
            return False
        if cursor[DONE] >= ATTEMPTS:
            lift = hall.gx * (way[0] - way[2]) + hall.gy * (way[1] - way[3])
            book.rest_energy[0] -= gas.mass[row] * lift
            slots.x[slot], slots.y[slot] = way[0], way[1]
            return True
        cursor[DONE] += 1
        if hall.rule[hall.kind[e, WALL], OPEN]:
            leave(e, sx, sy, row, slots, gas, box, walls, book, time)
            return True
        put_back(walls, e, sx, sy, way, walls.put)
        x, y, nx, ny = walls.put[0], walls.put[1], walls.put[2], walls.put[3]
        bounce(e, nx, ny, x, y, row, slots, gas, walls, book, time)


@inlined_kernel
def overlap(
    walls: Walls, e: int, sx: float, sy: float, x: float, y: float, r: float
) -> tuple[float, float, float]:
    """How deep a disc overlaps an element (below 0: not at all), and the normal there towards its centre."""
    hall = walls.hall
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    place = walls.place[hall.kind[e, WALL]]
    x -= hall.shape[e, PX] + sx + place * nx
    y -= hall.shape[e, PY] + sy + place * ny
    if hall.kind[e, KIND] == SIDE:
        height, faces = x * nx + y * ny, hall.kind[e, FACES]
        face = -1.0 if faces < 0 or (faces == 0 and height < 0.0) else 1.0
        low, high = hall.shape[e, LOW], hall.shape[e, HIGH]
        foot = x * hall.shape[e, TX] + y * hall.shape[e, TY]
        # Behind a side of a polygon there may be another part of the container; behind one of a box there is none.
        if not low <= foot <= high or (face * height < 0.0 and high < math.inf):
            return -1.0, 0.0, 0.0
        return r - face * height, face * nx, face * ny
    away = math.sqrt(x * x + y * y)
    if away == 0.0:
        return -1.0, 0.0, 0.0
    if hall.kind[e, KIND] == CORNER:
        return r + hall.shape[e, RHO] - away, x / away, y / away
    return away + r - hall.shape[e, RHO], -x / away, -y / away


@bare_kernel
def _next_touch(
    after: int, row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, time: float
) -> tuple[int, int]:
    """The first element and image beyond `after` that a disc overlaps and approaches: choice, and code."""
    hall, slot, species = walls.hall, walls.slot[row], gas.species[row]
    x, y, r, vx, vy = slots.x[slot], slots.y[slot], slots.reach[slot], slots.vx[slot], slots.vy[slot]
    where = elements((x, y, x, y, r), grid.level[row], box, grid, walls)
    best, best_code = NONE, 1 << 60
    for choice in range(choices(where, walls)):
        e, image_x, image_y = choose(choice, where, walls)
        code = code_of(e, image_x, image_y)
        number = hall.kind[e, WALL]
        if not after < code < best_code or hall.rule[number, OPEN]:
            continue
        depth, nx, ny = overlap(walls, e, image_x * box.width, image_y * box.height, x, y, r)
        if depth < 0.0:
            continue
        rate = speed(hall, number, time)
        u = rate * (hall.shape[e, NX] * nx + hall.shape[e, NY] * ny)
        if vx * nx + vy * ny - u > 0.0 or lets_pass(walls, e, species, vx, vy, rate):
            continue
        best, best_code = choice, code
    return best, best_code


@bare_kernel
def _touch(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Turn a disc round at each element that it overlaps and approaches; False if the contacts are full."""
    hall, cursor, slot = walls.hall, walls.cursor, walls.slot[row]
    level = grid.level[row]
    pulls = hall.gx != 0.0 or hall.gy != 0.0
    while True:
        choice, code = _next_touch(cursor[DONE], row, slots, gas, box, grid, walls, time)
        if choice == NONE:
            return True
        if is_full(book):
            return False
        cursor[DONE] = code
        x, y, r = slots.x[slot], slots.y[slot], slots.reach[slot]
        where = elements((x, y, x, y, r), level, box, grid, walls)
        e, image_x, image_y = choose(choice, where, walls)
        depth, nx, ny = overlap(walls, e, image_x * box.width, image_y * box.height, x, y, r)
        to_x, to_y = x, y
        if pulls:
            way = x, y, x + depth * nx, y + depth * ny, r
            where = elements(way, level, box, grid, walls)
            other, _, _, part = earliest(
                way, where, box, walls, gas.species[row], slots.vx[slot], slots.vy[slot], time, False
            )
            free = 1.0 if other == NONE else 0.5 * part
            to_x, to_y = x + free * depth * nx, y + free * depth * ny
        bounce(e, nx, ny, to_x, to_y, row, slots, gas, walls, book, time)


@bare_kernel
def _count(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Count a disc at each line that it has crossed and may cross, in their order; False if the contacts are full."""
    slot = walls.slot[row]
    way = way_of(row, slots, walls)
    return count_way(way, row, slots.vx[slot], slots.vy[slot], gas, box, grid, walls, book, time)


@inlined_kernel
def count_way(
    way: Way,
    row: int,
    vx: float,
    vy: float,
    gas: Gas,
    box: Box,
    grid: Grid,
    walls: Walls,
    book: Ledger,
    time: float,
) -> bool:
    """Count the crossings of lines on the way of a centre, that of the disc in `row` or of what it belongs to."""
    hall, cursor = walls.hall, walls.cursor
    species, mass = gas.species[row], gas.mass[row]
    where = elements(way, grid.level[row], box, grid, walls)
    while True:
        best, best_e, along = 1 << 60, NONE, False
        for choice in range(choices(where, walls)):
            e, image_x, image_y = choose(choice, where, walls)
            code = code_of(e, image_x, image_y)
            if not cursor[DONE] < code < best or hall.kind[e, KIND] != SIDE:
                continue
            if not hall.passes[hall.kind[e, WALL], species]:
                continue
            sx, sy = image_x * box.width, image_y * box.height
            if side_crossing(walls, e, sx, sy, way, True, 0.0, 0.0) < math.inf:
                best, best_e = code, e
                along = _begins_behind(walls, e, sx, sy, way)
        if best_e == NONE:
            return True
        if is_full(book):
            return False
        cursor[DONE] = best
        number = hall.kind[best_e, WALL]
        book_crossing(book, species, row, number, time, mass * vx, mass * vy, along, 0.0)


@inlined_kernel
def _begins_behind(walls: Walls, e: int, sx: float, sy: float, way: Way) -> bool:
    """Whether a way begins behind a side, as its normal sees it."""
    shape = walls.hall.shape
    height = (way[0] - shape[e, PX] - sx) * shape[e, NX] + (way[1] - shape[e, PY] - sy) * shape[e, NY]
    return height < walls.start[walls.hall.kind[e, WALL]]


@inlined_kernel
def _wrap(row: int, slots: Slots, box: Box, walls: Walls) -> None:
    """Bring a disc that was pushed over a periodic edge back into the box."""
    slot = walls.slot[row]
    if box.periodic_x and not 0.0 <= slots.x[slot] < box.width:
        slots.x[slot] -= math.floor(slots.x[slot] / box.width) * box.width
    if box.periodic_y and not 0.0 <= slots.y[slot] < box.height:
        slots.y[slot] -= math.floor(slots.y[slot] / box.height) * box.height


@bare_kernel
def visit(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Do to one disc what the walls do to it in this step; False if the contacts are full (call again then)."""
    cursor = walls.cursor
    if cursor[PART] == CROSS:
        if not _turn_back(row, slots, gas, box, grid, walls, book, time):
            return False
        cursor[PART], cursor[DONE] = TOUCH, -1
    if cursor[PART] == TOUCH and not walls.gone[row]:
        if not _touch(row, slots, gas, box, grid, walls, book, time):
            return False
        cursor[PART], cursor[DONE] = COUNT, -1
    if not walls.gone[row]:
        if not _count(row, slots, gas, box, grid, walls, book, time):
            return False
        _wrap(row, slots, box, walls)
    cursor[PART], cursor[DONE] = CROSS, 0
    return True
