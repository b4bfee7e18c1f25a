"""Walls under forces: discs near one are listed with it; then they turn round there, or are pushed back smoothly.

A centre turns round one radius before a wall, at the time within the step at which it comes there. A smooth wall pushes
as the repulsive part of a Lennard-Jones force does, with the potential strength (4 [(2r/d)^12 - (2r/d)^6] + 1) up to
d = 2^(1/6) 2r: r is the radius of the disc, d the distance of its centre from a line one radius behind the wall.

A wall that moves turns them round in its own frame. Those who pass a wall are booked when their centre is through.

All is done by one thread in the order of the atoms, and costs only who is near a wall.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_hall
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.passing import cross, lets_pass
from gasbox.kernels.forced.tables import Atoms
from gasbox.kernels.forced.wall_tables import Walls, approach, approach_before, distance
from gasbox.kernels.hall.motion import push
from gasbox.kernels.hall.rebound import thermal_speeds
from gasbox.kernels.hall.tables import (
    HIGH,
    KIND,
    LOW,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    SIDE,
    SOFT,
    TEMPERATURE,
    TX,
    TY,
    WALL,
    Hall,
)

__all__ = ["list_walls", "push_back", "turn_round"]

_SMOOTH = 2.0 ** (1.0 / 6.0)


@inlined_kernel
def _may_touch(hall: Hall, e: int, x: float, y: float, reach: float) -> bool:
    """Whether a centre may come within reach of an element before the lists are made anew."""
    if hall.kind[e, KIND] == SIDE:
        foot = x * hall.shape[e, TX] + y * hall.shape[e, TY]
        height = abs(x * hall.shape[e, NX] + y * hall.shape[e, NY])
        return height <= reach and hall.shape[e, LOW] - reach <= foot <= hall.shape[e, HIGH] + reach
    _, _, height = distance(hall, e, x, y)
    return height <= reach


@inlined_kernel
def _next(bodies: Bodies | None, number: int) -> int:
    """Which atom comes next: in their order, or in that of the discs of molecules, so that each has them together."""
    if bodies is None:
        return number
    return bodies.where[number]


@bare_kernel
def list_walls(
    walls: Walls, atoms: Atoms, bodies: Bodies | None, gas: Gas, box: Box, n: int, skin: float
) -> bool:
    """List who may touch a wall before the next time; False if there is too little room."""
    hall, count = walls.hall, 0
    across, along = 1 if box.periodic_x else 0, 1 if box.periodic_y else 0
    wide = 2.0 * _SMOOTH - 1.0 if walls.strength > 0.0 else 1.0
    for number in range(n):
        k = _next(bodies, number)
        reach = wide * gas.radius[atoms.row[k]] + skin
        for e in range(hall.kind.shape[0]):
            way = walls.listed[hall.kind[e, WALL]]
            for image_y in range(-along, along + 1):
                for image_x in range(-across, across + 1):
                    x = atoms.x[k] - hall.shape[e, PX] - image_x * box.width - hall.shape[e, NX] * way
                    y = atoms.y[k] - hall.shape[e, PY] - image_y * box.height - hall.shape[e, NY] * way
                    if not _may_touch(hall, e, x, y, reach):
                        continue
                    if count == walls.near.shape[0]:
                        return False
                    walls.near[count, 0], walls.near[count, 1] = k, e
                    walls.near[count, 2], walls.near[count, 3] = image_x, image_y
                    count += 1
    walls.size[0] = count
    return True


@bare_kernel
def turn_round(
    walls: Walls, atoms: Atoms, gas: Gas, box: Box, book: Ledger, time: float, time_step: float
) -> int:
    """Mirror whoever has come nearer to a wall than its radius; a thermal wall gives it a new velocity.

    Twice over, since the second of two walls in a corner may send a disc back through the first.

    Returns
    -------
    0; or 1 if the buffer of contacts is full, and this is to be called again.
    """
    cursor, near = walls.cursor, walls.size[0]
    while cursor[0] < 2 * near:
        if book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]:
            return 1
        _mirror(walls, cursor[0] % near, cursor[0], atoms, gas, box, book, time, time_step)
        cursor[0] += 1
    while cursor[0] < 3 * near and walls.was_x.shape[0] > 0:
        if book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]:
            return 1
        cross(walls, cursor[0] % near, atoms, gas, box, book, time, time_step)
        cursor[0] += 1
    cursor[0] = 0
    return 0


@inlined_kernel
def _mirror(
    walls: Walls,
    entry: int,
    salt: int,
    atoms: Atoms,
    gas: Gas,
    box: Box,
    book: Ledger,
    time: float,
    time_step: float,
) -> None:
    """Turn round the disc of one entry of the list, if it is too near.

    It met the wall a while t before the end of the step. The half kicks before and after the drift know nothing of
    that: with the acceleration a along the normal, place and speed at the end lack a t² and a (2t - time_step). In the
    frame of a wall that moves with u, the speed v is turned round: 2u - v is left, and u times the impulse is the work.

    Who has got into a wall that some pass, and may go no further, is turned round where it was before the step.
    """
    hall, result = walls.hall, walls.hall.result
    k, e, nx, ny, away = approach(walls, entry, atoms, box)
    row, mass, number = atoms.row[k], atoms.mass[k], hall.kind[e, WALL]
    soft, line = hall.rule[number, SOFT] != 0, gas.radius[row]
    if soft:
        was_x, was_y, was_away = approach_before(walls, entry, box)
        line = min(line, was_away)
        if hall.kind[e, KIND] == SIDE and was_x * nx + was_y * ny < 0.0 and max(away, was_away) < math.inf:
            # It has got to the other side in this step.
            nx, ny, away = was_x, was_y, -away
    deep = line - away
    if not deep > 0.0 or hall.rule[number, OPEN]:
        return
    if atoms.rate[k] == 0.0:
        return
    vx, vy = atoms.vx[k], atoms.vy[k]
    vn, vt = vx * nx + vy * ny, vy * nx - vx * ny
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    u, speeding = walls.rate[number] * along, push(hall, number, time) * along
    if soft and (vn >= u or lets_pass(walls, e, gas.species[row], vx, vy)):
        return
    if vn >= u:
        atoms.x[k] += 2.0 * deep * nx
        atoms.y[k] += 2.0 * deep * ny
        return
    after = min(deep / (u - vn), time_step)
    a = (atoms.fx[k] * nx + atoms.fy[k] * ny) / mass
    away, slide, late = u - vn, vt, a * (2.0 * after - time_step)
    u -= speeding * after
    out = u + (u - vn)
    result[4] = result[5] = 0.0
    if hall.wall[number, TEMPERATURE] >= 0.0:
        away, slide = thermal_speeds(hall, number, mass, book.id[row], time, float(salt))
        out, late = u + away, a * (after - 0.5 * time_step)
        result[4] = 0.5 * mass * (away * away + slide * slide - (vn - u) * (vn - u) - vt * vt)
    lift = deep + away * after + (a - speeding) * after * after
    if soft:
        lift = max(lift, deep)
    atoms.x[k] += lift * nx
    atoms.y[k] += lift * ny
    result[2] = mass * (out - vn)
    out += late
    result[3] = u * mass * (out - vn)
    atoms.vx[k], atoms.vy[k] = out * nx - slide * ny, out * ny + slide * nx
    jx, jy = mass * (atoms.vx[k] - vx), mass * (atoms.vy[k] - vy)
    book_hall(book, gas.species[row], row, number, time, jx, jy, result)


@inlined_kernel
def _push_from(
    walls: Walls, entry: int, atoms: Atoms, gas: Gas, box: Box, book: Ledger, time_step: float
) -> None:
    """Add the force of one element on one atom, if it reaches so far."""
    k, e, nx, ny, away = approach(walls, entry, atoms, box)
    row = atoms.row[k]
    r = gas.radius[row]
    behind = away + r
    if behind >= _SMOOTH * 2.0 * r:
        return
    s2 = (2.0 * r / behind) ** 2
    s6 = s2 * s2 * s2
    force = walls.strength * 24.0 * s6 * (2.0 * s6 - 1.0) / behind
    atoms.fx[k] += force * nx
    atoms.fy[k] += force * ny
    atoms.u[k] += walls.strength * (4.0 * s6 * (s6 - 1.0) + 1.0)
    number, hall = walls.hall.kind[e, WALL], walls.hall
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    book.wall_impulse[number, gas.species[row]] += force * time_step
    walls.force[number, gas.species[row]] += force * along


@bare_kernel
def push_back(walls: Walls, atoms: Atoms, gas: Gas, box: Box, book: Ledger, time_step: float) -> None:
    """Add the forces of smooth walls, and their energy; the impulse of a step is booked on the wall.

    Sides without end, those of a rectangle, push each by itself. Of all else only the nearest does: sides that end at a
    corner would let go abruptly there, and the distance from the nearest has no jump.
    """
    hall, size = walls.hall, walls.size[0]
    best, least = -1, math.inf
    _begin_work(walls)
    for entry in range(size):
        k, e = walls.near[entry, 0], walls.near[entry, 1]
        if hall.kind[e, KIND] == SIDE and math.isinf(hall.shape[e, HIGH]):
            _push_from(walls, entry, atoms, gas, box, book, time_step)
        else:
            _, _, _, _, away = approach(walls, entry, atoms, box)
            if away < least:
                best, least = entry, away
        # The entries of one atom follow each other.
        if entry + 1 == size or walls.near[entry + 1, 0] != k:
            if best >= 0:
                _push_from(walls, best, atoms, gas, box, book, time_step)
            best, least = -1, math.inf
    if time_step > 0.0:
        _book_work(walls, book)


@inlined_kernel
def _begin_work(walls: Walls) -> None:
    for number in range(walls.force.shape[0]):
        for species in range(walls.force.shape[1]):
            walls.force_before[number, species] = walls.force[number, species]
            walls.force[number, species] = 0.0


@inlined_kernel
def _book_work(walls: Walls, book: Ledger) -> None:
    """Way times force, the mean of those at both ends of the way."""
    for number in range(walls.force.shape[0]):
        way = walls.place[number] - walls.earlier[number]
        for species in range(walls.force.shape[1]):
            force = 0.5 * (walls.force_before[number, species] + walls.force[number, species])
            book.wall_work[number, species] += force * way
