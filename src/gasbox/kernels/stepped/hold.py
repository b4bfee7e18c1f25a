"""No site of a molecule gets across a wall: it goes back to where the step began if the step was too long for it."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_hall
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.tables import CORNER, FACES, KIND, NX, NY, PX, PY, SIDE, WALL
from gasbox.kernels.stepped.bodies import HELD_BACK, Bodies, turn_arms, wrap_site
from gasbox.kernels.stepped.recoil import bounce_body
from gasbox.kernels.stepped.strike import closing_at
from gasbox.kernels.stepped.tables import PUSHED, Grid, Slots, Walls
from gasbox.kernels.stepped.visit import ATTEMPTS, DONE, is_full
from gasbox.kernels.stepped.ways import NONE, earliest, elements, way_of

__all__ = ["hold_back"]


@bare_kernel
def _first_crossing(
    row: int, slots: Slots, gas: Gas, bodies: Bodies, box: Box, grid: Grid, walls: Walls, time: float
) -> tuple[int, int, float, float]:
    """The site that first gets across an element in this step, the element (NONE: no site does), shift of its image."""
    vx, vy = bodies.velocity[row, 0], bodies.velocity[row, 1]
    found, best, best_x, best_y, least = 0, NONE, 0.0, 0.0, math.inf
    for site in range(bodies.first[row], bodies.first[row + 1]):
        way = way_of(site, slots, walls)
        where = elements(way, grid.level[site], box, grid, walls)
        e, sx, sy, part = earliest(way, where, box, walls, gas.species[site], vx, vy, time, True)
        if e != NONE and part < least:
            found, best, best_x, best_y, least = site, e, sx, sy, part
    return found, best, best_x, best_y


@bare_kernel
def _go_back(
    row: int, first: bool, dx: float, dy: float, slots: Slots, bodies: Bodies, box: Box, walls: Walls
) -> float:
    """Put a body to where it was when the step began, and (dx, dy) beside it; the energy that sets free.

    The `first` time it loses the speed that it fell up in this step: what is then set free is what the collisions of
    this step have done.
    """
    hall, mass = walls.hall, bodies.mass[row]
    x, y = bodies.before[row, 0] + dx, bodies.before[row, 1] + dy
    free = mass * (hall.gx * (x - bodies.position[row, 0]) + hall.gy * (y - bodies.position[row, 1]))
    if first:
        vx, vy = bodies.velocity[row, 0], bodies.velocity[row, 1]
        wx, wy = vx - bodies.fallen[0], vy - bodies.fallen[1]
        bodies.velocity[row, 0], bodies.velocity[row, 1] = wx, wy
        free += 0.5 * mass * (vx * vx + vy * vy - wx * wx - wy * wy)
    bodies.position[row, 0], bodies.position[row, 1] = x, y
    bodies.angle[row] = bodies.before[row, 2]
    turn_arms(bodies, row)
    for site in range(bodies.first[row], bodies.first[row + 1]):
        slot = walls.slot[site]
        slots.x[slot], slots.y[slot] = walls.before[site, 0] + dx, walls.before[site, 1] + dy
        wrap_site(site, slot, slots, box, walls)
        walls.near[site] = walls.near[site] or PUSHED
    return free


@inlined_kernel
def _face(walls: Walls, e: int, sx: float, sy: float, site: int, slots: Slots) -> tuple[float, float]:
    """Normal of an element towards a site that has been put back."""
    hall = walls.hall
    slot, place = walls.slot[site], walls.place[hall.kind[e, WALL]]
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    x = slots.x[slot] - hall.shape[e, PX] - sx - place * nx
    y = slots.y[slot] - hall.shape[e, PY] - sy - place * ny
    if hall.kind[e, KIND] == SIDE:
        faces = hall.kind[e, FACES]
        face = -1.0 if faces < 0 or (faces == 0 and x * nx + y * ny < 0.0) else 1.0
        return face * nx, face * ny
    away = math.sqrt(x * x + y * y)
    sign = 1.0 if hall.kind[e, KIND] == CORNER else -1.0
    return (sign * x / away, sign * y / away) if away > 0.0 else (1.0, 0.0)


@bare_kernel
def hold_back(
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
    """No site gets across a wall: a molecule with one that would goes back; False if the contacts are full."""
    hall, cursor = walls.hall, walls.cursor
    while True:
        site, e, sx, sy = _first_crossing(row, slots, gas, bodies, box, grid, walls, time)
        if e == NONE:
            return True
        if is_full(book):
            return False
        bodies.mishaps[HELD_BACK] += 1
        if cursor[DONE] >= ATTEMPTS:
            book.rest_energy[0] -= _go_back(row, False, 0.0, 0.0, slots, bodies, box, walls)
            return True
        # A wall that moves takes along whom it meets.
        number = hall.kind[e, WALL]
        way = walls.place[number] - walls.start[number]
        dx, dy = way * hall.shape[e, NX], way * hall.shape[e, NY]
        if cursor[DONE] > 0:
            dx += bodies.position[row, 0] - bodies.before[row, 0]
            dy += bodies.position[row, 1] - bodies.before[row, 1]
        cursor[DONE] += 1
        lift = _go_back(row, cursor[DONE] == 1, dx, dy, slots, bodies, box, walls)
        nx, ny = _face(walls, e, sx, sy, site, slots)
        u = speed(hall, number, time) * (hall.shape[e, NX] * nx + hall.shape[e, NY] * ny)
        closing = closing_at(bodies, row, site, nx, ny, u)
        if closing < 0.0:
            epoch = -float(1 + e + hall.kind.shape[0] * cursor[DONE])
            bounce_body(e, nx, ny, closing, lift, epoch, site, row, gas, bodies, walls, book, time)
            continue
        book.rest_energy[0] -= lift
        if u == 0.0:
            _turn_about(e, nx, ny, site, row, gas, bodies, walls, book, time)


@inlined_kernel
def _turn_about(
    e: int,
    nx: float,
    ny: float,
    site: int,
    row: int,
    gas: Gas,
    bodies: Bodies,
    walls: Walls,
    book: Ledger,
    time: float,
) -> None:
    """A molecule that came back without approaching takes the way by which it has come, so that it does not hang."""
    jx, jy = (
        -2.0 * bodies.mass[row] * bodies.velocity[row, 0],
        -2.0 * bodies.mass[row] * bodies.velocity[row, 1],
    )
    bodies.velocity[row, 0], bodies.velocity[row, 1] = -bodies.velocity[row, 0], -bodies.velocity[row, 1]
    bodies.spin[row] = -bodies.spin[row]
    result = walls.hall.result
    result[2], result[3], result[4], result[5] = max(jx * nx + jy * ny, 0.0), 0.0, 0.0, 0.0
    book_hall(book, gas.species[site], site, walls.hall.kind[e, WALL], time, jx, jy, result)
