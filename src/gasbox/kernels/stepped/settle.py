"""What the walls of an enclosure do to molecules: each site that touches and approaches gives its body an impulse."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.tables import NX, NY, OPEN, WALL
from gasbox.kernels.stepped.bodies import CUT_SHORT, Bodies, is_single
from gasbox.kernels.stepped.execute import is_clear
from gasbox.kernels.stepped.hold import hold_back
from gasbox.kernels.stepped.recoil import bounce_body
from gasbox.kernels.stepped.sides import MOST_BOUNCES
from gasbox.kernels.stepped.strike import closing_at, shift_body, take_over
from gasbox.kernels.stepped.tables import Grid, Slots, Walls
from gasbox.kernels.stepped.visit import (
    COUNT,
    CROSS,
    DONE,
    PART,
    TOUCH,
    code_of,
    count_way,
    is_full,
    overlap,
    visit,
)
from gasbox.kernels.stepped.ways import NONE, choices, choose, earliest, elements, lets_pass

__all__ = ["visit_all"]


@bare_kernel
def _next_touch(
    row: int, slots: Slots, gas: Gas, bodies: Bodies, box: Box, grid: Grid, walls: Walls, time: float
) -> tuple[int, int, float, float, float, float]:
    """First site and element (or NONE) that overlap and approach; depth, normal, and closing speed."""
    hall = walls.hall
    found, best, best_code = 0, NONE, 1 << 60
    best_depth, best_x, best_y, best_closing = 0.0, 0.0, 0.0, 0.0
    for site in range(bodies.first[row], bodies.first[row + 1]):
        if walls.near[site] == 0:
            continue
        slot = walls.slot[site]
        x, y, r = slots.x[slot], slots.y[slot], slots.reach[slot]
        where = elements((x, y, x, y, r), grid.level[site], box, grid, walls)
        for choice in range(choices(where, walls)):
            e, image_x, image_y = choose(choice, where, walls)
            code, number = code_of(e, image_x, image_y), hall.kind[e, WALL]
            if code >= best_code or hall.rule[number, OPEN]:
                continue
            depth, nx, ny = overlap(walls, e, image_x * box.width, image_y * box.height, x, y, r)
            if depth < 0.0:
                continue
            rate = speed(hall, number, time)
            closing = closing_at(
                bodies, row, site, nx, ny, rate * (hall.shape[e, NX] * nx + hall.shape[e, NY] * ny)
            )
            vx, vy = bodies.velocity[row, 0], bodies.velocity[row, 1]
            if closing == 0.0 or lets_pass(walls, e, gas.species[site], vx, vy, rate):
                continue
            found, best, best_code = site, e, code
            best_depth, best_x, best_y, best_closing = depth, nx, ny, closing
        if best != NONE:
            break
    return found, best, best_depth, best_x, best_y, best_closing


@bare_kernel
def _free_part(
    row: int,
    dx: float,
    dy: float,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls,
    time: float,
) -> float:
    """Part of a shift that a body can make without a site of it getting across a wall."""
    free = 1.0
    vx, vy = bodies.velocity[row, 0], bodies.velocity[row, 1]
    for site in range(bodies.first[row], bodies.first[row + 1]):
        slot = walls.slot[site]
        x, y = slots.x[slot], slots.y[slot]
        way = x, y, x + dx, y + dy, slots.reach[slot]
        where = elements(way, grid.level[site], box, grid, walls)
        other, _, _, part = earliest(way, where, box, walls, gas.species[site], vx, vy, time, False)
        if other != NONE:
            free = min(free, 0.5 * part)
    return free


@bare_kernel
def _settle_in(
    row: int,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls,
    book: Ledger,
    time: float,
) -> bool:
    """Let a molecule bounce off the walls until none of its sites approaches; False if the contacts are full."""
    hall, cursor = walls.hall, walls.cursor
    pulls = hall.gx != 0.0 or hall.gy != 0.0
    while True:
        site, e, depth, nx, ny, closing = _next_touch(row, slots, gas, bodies, box, grid, walls, time)
        if e == NONE:
            return True
        if cursor[DONE] >= MOST_BOUNCES:
            bodies.mishaps[CUT_SHORT] += 1
            return True
        if is_full(book):
            return False
        lift = 0.0
        if pulls:
            free = _free_part(row, depth * nx, depth * ny, slots, gas, bodies, box, grid, walls, time)
            dx, dy = free * depth * nx, free * depth * ny
            lift = bodies.mass[row] * (hall.gx * dx + hall.gy * dy)
            shift_body(row, dx, dy, slots, bodies, walls)
        epoch = float(e + hall.kind.shape[0] * cursor[DONE])
        bounce_body(e, nx, ny, closing, lift, epoch, site, row, gas, bodies, walls, book, time)
        cursor[DONE] += 1


@bare_kernel
def _count(
    row: int, gas: Gas, bodies: Bodies, box: Box, grid: Grid, walls: Walls, book: Ledger, time: float
) -> bool:
    """Count a molecule at each line that its centre of mass has crossed; False if the contacts are full."""
    site, vx, vy = bodies.first[row], bodies.velocity[row, 0], bodies.velocity[row, 1]
    way = (
        bodies.before[row, 0],
        bodies.before[row, 1],
        bodies.position[row, 0],
        bodies.position[row, 1],
        gas.radius[site],
    )
    return count_way(way, site, vx, vy, gas, box, grid, walls, book, time)


@bare_kernel
def _visit_body(
    row: int,
    lines: bool,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls,
    book: Ledger,
    time: float,
) -> bool:
    """Do to one molecule what the walls do to it in this step; False if the contacts are full (call again then)."""
    near = False
    for site in range(bodies.first[row], bodies.first[row + 1]):
        near = near or walls.near[site] != 0
    if not near and not lines:
        return True
    cursor = walls.cursor
    if cursor[PART] == CROSS:
        if not hold_back(row, slots, gas, bodies, box, grid, walls, book, time):
            return False
        cursor[PART], cursor[DONE] = TOUCH, 0
    if cursor[PART] == TOUCH:
        if not _settle_in(row, slots, gas, bodies, box, grid, walls, book, time):
            return False
        cursor[PART], cursor[DONE] = COUNT, -1
    if lines and not _count(row, gas, bodies, box, grid, walls, book, time):
        return False
    cursor[PART], cursor[DONE] = CROSS, 0
    for axis in range(2):
        length = box.width if axis == 0 else box.height
        if box.periodic_x if axis == 0 else box.periodic_y:
            bodies.position[row, axis] -= math.floor(bodies.position[row, axis] / length) * length
    return True


@inlined_kernel
def _visit_disc(
    row: int,
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls,
    book: Ledger,
    time: float,
) -> bool:
    """Do to a single disc what the walls do to it, as in a gas of discs."""
    site = bodies.first[row]
    if not walls.near[site]:
        return True
    if not is_clear(site, slots, box, grid, walls) and not visit(
        site, slots, gas, box, grid, walls, book, time
    ):
        return False
    if not walls.gone[site]:
        slot = walls.slot[site]
        bodies.position[row, 0], bodies.position[row, 1] = slots.x[slot], slots.y[slot]
        take_over(slot, slots, bodies)
    return True


@bare_kernel
def visit_all(
    slots: Slots,
    gas: Gas,
    bodies: Bodies,
    box: Box,
    grid: Grid,
    walls: Walls,
    book: Ledger,
    time: float,
) -> bool:
    """All that walls do in this step, body by body, from where they stand; False if the contacts are full."""
    cursor, passes = walls.cursor, walls.hall.passes
    lines = False
    for number in range(passes.shape[0]):
        for kind in range(passes.shape[1]):
            lines = lines or passes[number, kind]
    while cursor[0] < bodies.mass.shape[0]:
        row = cursor[0]
        if is_single(bodies, row):
            done = _visit_disc(row, slots, gas, bodies, box, grid, walls, book, time)
        else:
            done = _visit_body(row, lines, slots, gas, bodies, box, grid, walls, book, time)
        if not done:
            return False
        cursor[0] += 1
    cursor[0] = 0
    return True
