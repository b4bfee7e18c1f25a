"""What the walls do to one disc in one step: put it back, turn it round, let it pass, or let it go."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_crossing, book_hall
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.rebound import rebound
from gasbox.kernels.hall.tables import (
    CORNER,
    FACES,
    HIGH,
    KIND,
    LOW,
    MASS,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    RHO,
    S_SPEED,
    SIDE,
    TX,
    TY,
    WALL,
    Hall,
)
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
)

__all__ = ["PARKED", "divided", "visit"]

_CROSS, _TOUCH, _COUNT = 0, 1, 2
"""The parts of a visit."""
_ATTEMPTS = 8
"""Times that a disc is put back in a step; one needs more only between walls that crush it."""
PARKED = 4.0
"""Boxes between discs that have left, and everybody else."""
_ROW, _PART, _DONE, _LEFT = range(4)


@inlined_kernel
def _is_full(book: Ledger) -> bool:
    return book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]


@inlined_kernel
def _code(e: int, image_x: int, image_y: int) -> int:
    """Order of elements and images."""
    return (e * 256 + image_y + 128) * 256 + image_x + 128


@inlined_kernel
def _lift(
    hall: Hall,
    number: int,
    along: float,
    nx: float,
    ny: float,
    slot: int,
    slots: Slots,
    mass: float,
    u: float,
    lift: float,
) -> tuple[float, float]:
    """Take what a disc was lifted by (per mass, < 0) from its speed towards a wall; impulse, and what was lacking."""
    heavy = hall.wall[number, MASS]
    share = (mass + heavy) / heavy if heavy > 0.0 else 1.0
    toward = slots.vx[slot] * nx + slots.vy[slot] * ny - u
    square = toward * toward + 2.0 * share * lift
    lacking = max(-0.5 * mass / share * square, 0.0)
    impulse = mass / share * (-math.sqrt(max(square, 0.0)) - toward)
    slots.vx[slot] += impulse / mass * nx
    slots.vy[slot] += impulse / mass * ny
    if heavy > 0.0:
        hall.wall[number, S_SPEED] -= impulse / heavy * along
    return impulse, lacking


@bare_kernel
def _bounce(
    e: int,
    nx: float,
    ny: float,
    to_x: float,
    to_y: float,
    row: int,
    slots: Slots,
    gas: Gas,
    walls: Walls,
    book: Ledger,
    time: float,
) -> None:
    """Put a disc to (to_x, to_y) and turn it round if it approaches; its energy stays, or is booked."""
    hall = walls.hall
    result = hall.result
    slot, mass, number = walls.slot[row], gas.mass[row], hall.kind[e, WALL]
    lift = hall.gx * (to_x - slots.x[slot]) + hall.gy * (to_y - slots.y[slot])
    slots.x[slot], slots.y[slot] = to_x, to_y
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    u = speed(hall, number, time) * along
    vx, vy = slots.vx[slot], slots.vy[slot]
    if vx * nx + vy * ny - u > 0.0:
        book.rest_energy[0] -= mass * lift
        return
    impulse, lacking = 0.0, 0.0
    if lift != 0.0:
        impulse, lacking = _lift(hall, number, along, nx, ny, slot, slots, mass, u, lift)
    label, r = book.id[row], gas.radius[row]
    result[0], result[1] = slots.vx[slot], slots.vy[slot]
    result[2] = result[3] = result[4] = result[5] = 0.0
    # The number of the element keeps two meetings in one step from drawing the same random numbers.
    turned = rebound(hall, e, nx, ny, slots.vx[slot], slots.vy[slot], mass, r, label, time, float(e), result)
    if not turned and impulse == 0.0:
        return
    slots.vx[slot], slots.vy[slot] = result[0], result[1]
    result[2] += impulse
    result[5] += lacking
    if lift != 0.0:
        gained = 0.5 * mass * (result[0] ** 2 + result[1] ** 2 - vx * vx - vy * vy) - mass * lift
        moves = u != 0.0 or hall.wall[number, MASS] > 0.0
        result[3] = gained - result[4] - result[5] if moves else 0.0
    book_hall(
        book, gas.species[row], row, number, time, mass * (result[0] - vx), mass * (result[1] - vy), result
    )


@inlined_kernel
def _leave(
    e: int,
    sx: float,
    sy: float,
    row: int,
    slots: Slots,
    gas: Gas,
    box: Box,
    walls: Walls,
    book: Ledger,
    time: float,
) -> None:
    """A disc leaves the gas through an open wall."""
    hall = walls.hall
    slot, mass, number = walls.slot[row], gas.mass[row], hall.kind[e, WALL]
    vx, vy = slots.vx[slot], slots.vy[slot]
    along = False
    if hall.kind[e, KIND] == SIDE:
        x, y = walls.before[row, 0] - hall.shape[e, PX] - sx, walls.before[row, 1] - hall.shape[e, PY] - sy
        along = x * hall.shape[e, NX] + y * hall.shape[e, NY] - walls.start[number] < 0.0
    energy = 0.5 * mass * (vx * vx + vy * vy)
    book_crossing(book, gas.species[row], row, number, time, mass * vx, mass * vy, along, energy)
    walls.gone[row] = 1
    walls.cursor[_LEFT] += 1
    slots.x[slot] = -(row + 2) * PARKED * (box.width + box.height)
    slots.vx[slot] = slots.vy[slot] = 0.0


@inlined_kernel
def _way(row: int, slots: Slots, walls: Walls) -> Way:
    slot = walls.slot[row]
    return walls.before[row, 0], walls.before[row, 1], slots.x[slot], slots.y[slot], slots.reach[slot]


@bare_kernel
def _turn_back(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Nobody gets across a wall: whoever would is put to where it first touched; False if the contacts are full."""
    hall, cursor, slot = walls.hall, walls.cursor, walls.slot[row]
    species, level = gas.species[row], grid.level[row]
    while True:
        way = _way(row, slots, walls)
        where = elements(way, level, box, grid, walls)
        e, sx, sy, _ = earliest(way, where, box, walls, species, slots.vx[slot], slots.vy[slot], time, True)
        if e == NONE:
            return True
        if _is_full(book):
            return False
        if cursor[_DONE] >= _ATTEMPTS:
            lift = hall.gx * (way[0] - way[2]) + hall.gy * (way[1] - way[3])
            book.rest_energy[0] -= gas.mass[row] * lift
            slots.x[slot], slots.y[slot] = way[0], way[1]
            return True
        cursor[_DONE] += 1
        if hall.rule[hall.kind[e, WALL], OPEN]:
            _leave(e, sx, sy, row, slots, gas, box, walls, book, time)
            return True
        put_back(walls, e, sx, sy, way, walls.put)
        x, y, nx, ny = walls.put[0], walls.put[1], walls.put[2], walls.put[3]
        _bounce(e, nx, ny, x, y, row, slots, gas, walls, book, time)


@inlined_kernel
def _overlap(
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
        code = _code(e, image_x, image_y)
        number = hall.kind[e, WALL]
        if not after < code < best_code or hall.rule[number, OPEN]:
            continue
        depth, nx, ny = _overlap(walls, e, image_x * box.width, image_y * box.height, x, y, r)
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
        choice, code = _next_touch(cursor[_DONE], row, slots, gas, box, grid, walls, time)
        if choice == NONE:
            return True
        if _is_full(book):
            return False
        cursor[_DONE] = code
        x, y, r = slots.x[slot], slots.y[slot], slots.reach[slot]
        where = elements((x, y, x, y, r), level, box, grid, walls)
        e, image_x, image_y = choose(choice, where, walls)
        depth, nx, ny = _overlap(walls, e, image_x * box.width, image_y * box.height, x, y, r)
        to_x, to_y = x, y
        if pulls:
            way = x, y, x + depth * nx, y + depth * ny, r
            where = elements(way, level, box, grid, walls)
            other, _, _, part = earliest(
                way, where, box, walls, gas.species[row], slots.vx[slot], slots.vy[slot], time, False
            )
            free = 1.0 if other == NONE else 0.5 * part
            to_x, to_y = x + free * depth * nx, y + free * depth * ny
        _bounce(e, nx, ny, to_x, to_y, row, slots, gas, walls, book, time)


@bare_kernel
def _count(
    row: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Count a disc at each line that it has crossed and may cross, in their order; False if the contacts are full."""
    hall, cursor, slot = walls.hall, walls.cursor, walls.slot[row]
    species, mass = gas.species[row], gas.mass[row]
    way = _way(row, slots, walls)
    where = elements(way, grid.level[row], box, grid, walls)
    while True:
        best, best_e = 1 << 60, NONE
        for choice in range(choices(where, walls)):
            e, image_x, image_y = choose(choice, where, walls)
            code = _code(e, image_x, image_y)
            if not cursor[_DONE] < code < best or hall.kind[e, KIND] != SIDE:
                continue
            if not hall.passes[hall.kind[e, WALL], species]:
                continue
            sx, sy = image_x * box.width, image_y * box.height
            if side_crossing(walls, e, sx, sy, way, True, 0.0, 0.0) < math.inf:
                best, best_e = code, e
                along = _begins_behind(walls, e, sx, sy, way)
        if best_e == NONE:
            return True
        if _is_full(book):
            return False
        cursor[_DONE] = best
        vx, vy = slots.vx[slot], slots.vy[slot]
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
    if cursor[_PART] == _CROSS:
        if not _turn_back(row, slots, gas, box, grid, walls, book, time):
            return False
        cursor[_PART], cursor[_DONE] = _TOUCH, -1
    if cursor[_PART] == _TOUCH and not walls.gone[row]:
        if not _touch(row, slots, gas, box, grid, walls, book, time):
            return False
        cursor[_PART], cursor[_DONE] = _COUNT, -1
    if not walls.gone[row]:
        if not _count(row, slots, gas, box, grid, walls, book, time):
            return False
        _wrap(row, slots, box, walls)
    cursor[_PART], cursor[_DONE] = _CROSS, 0
    return True


@bare_kernel
def divided(
    first: int, second: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, dx: float, dy: float
) -> bool:
    """Whether a wall that neither passes lies between the centres of two discs; (dx, dy) leads from second to first."""
    for turn in range(2):
        a = first if turn == 0 else second
        row, other = slots.row[a], slots.row[second if turn == 0 else first]
        x, y = slots.x[a], slots.y[a]
        sign = -1.0 if turn == 0 else 1.0
        way = x, y, x + sign * dx, y + sign * dy, slots.reach[a]
        where = elements((x, y, x, y, slots.reach[a]), grid.level[row], box, grid, walls)
        for choice in range(choices(where, walls)):
            e, image_x, image_y = choose(choice, where, walls)
            number = walls.hall.kind[e, WALL]
            if walls.hall.kind[e, KIND] != SIDE or walls.hall.rule[number, OPEN]:
                continue
            if walls.hall.passes[number, gas.species[row]] or walls.hall.passes[number, gas.species[other]]:
                continue
            sx, sy = image_x * box.width, image_y * box.height
            if side_crossing(walls, e, sx, sy, way, False, 0.0, 0.0) < math.inf:
                return True
    return False
