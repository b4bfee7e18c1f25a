"""Rigid molecules turn round at walls, at the time within the step at which one of their discs gets there.

With n the normal at the disc that touches, d its arm and g = d x n, an elastic wall gives the impulse
j = -2 (V·n + w g)/(1/M + g²/I) along n: the speed at the contact is turned round, the energy stays. A thermal wall
gives the centre of the disc that touches a new velocity, from the flux of the Maxwell distribution that molecules of
its temperature T have there: with the covariance T K along n and the tangent t, K_ab = a·b/M + (d x a)(d x b)/I.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_hall
from gasbox.kernels.forced.bodies import RIGID, Bodies
from gasbox.kernels.forced.molecules import arm, place
from gasbox.kernels.forced.tables import Atoms
from gasbox.kernels.forced.wall_tables import Walls, approach
from gasbox.kernels.forced.walls import turn_round
from gasbox.kernels.hall.rebound import thermal_speeds
from gasbox.kernels.hall.tables import TEMPERATURE, WALL

__all__ = ["turn_all_round"]

_ROUNDS = 20
"""Contacts of one molecule in a step, at most; what is left then is left to the next step."""


@bare_kernel
def turn_all_round(
    bodies: Bodies | None,
    walls: Walls,
    atoms: Atoms,
    gas: Gas,
    box: Box,
    book: Ledger,
    time: float,
    time_step: float,
) -> int:
    """Turn round all that have come too near to a wall: first discs by themselves, then rigid molecules.

    Returns
    -------
    0; or 1 if the buffer of contacts is full, and this is to be called again.
    """
    cursor = walls.cursor
    if cursor[3] == 0:
        if turn_round(walls, atoms, gas, box, book, time, time_step):
            return 1
        cursor[3] = 1
    if _turn_bodies_round(bodies, walls, atoms, gas, box, book, time, time_step):
        return 1
    cursor[3] = 0
    return 0


@bare_kernel
def _turn_bodies_round(
    bodies: Bodies | None,
    walls: Walls,
    atoms: Atoms,
    gas: Gas,
    box: Box,
    book: Ledger,
    time: float,
    time_step: float,
) -> int:
    """Turn round whoever has a disc nearer to a wall than its radius, the earliest contact first; 1 if it must stop."""
    if bodies is None:
        return 0
    cursor, near = walls.cursor, walls.size[0]
    while cursor[1] < near:
        entry = cursor[1]
        row = bodies.owner[atoms.row[walls.near[entry, 0]]]
        # The entries of one molecule follow each other.
        last = entry + 1
        while last < near and bodies.owner[atoms.row[walls.near[last, 0]]] == row:
            last += 1
        while bodies.style[row] == RIGID and cursor[2] < _ROUNDS:
            first, after = _earliest(bodies, walls, entry, last, row, atoms, gas, box, time_step)
            if first < 0:
                break
            if book.kind.shape[0] > 0 and book.rows[0] >= book.kind.shape[0]:
                return 1
            _collide(bodies, walls, first, row, atoms, gas, box, book, time, after, time_step)
            cursor[2] += 1
        cursor[1], cursor[2] = last, 0
    cursor[1] = 0
    return 0


@inlined_kernel
def _lever(
    bodies: Bodies, walls: Walls, entry: int, row: int, atoms: Atoms, box: Box
) -> tuple[float, float, float, float, float, float]:
    """Normal, distance, speed along the normal, and the moments of normal and tangent, of one entry of the list."""
    k, _, nx, ny, away = approach(walls, entry, atoms, box)
    ax, ay = arm(bodies, row, atoms.row[k])
    across, along = ax * ny - ay * nx, ax * nx + ay * ny
    speed = bodies.vx[row] * nx + bodies.vy[row] * ny + bodies.turning[row] * across
    return nx, ny, away, speed, across, along


@bare_kernel
def _earliest(
    bodies: Bodies,
    walls: Walls,
    begin: int,
    end: int,
    row: int,
    atoms: Atoms,
    gas: Gas,
    box: Box,
    time_step: float,
) -> tuple[int, float]:
    """The entry whose disc met its wall first, and how long before the end of the step; -1 if none did."""
    best, most = -1, 0.0
    for entry in range(begin, end):
        _, _, away, speed, _, _ = _lever(bodies, walls, entry, row, atoms, box)
        deep = gas.radius[atoms.row[walls.near[entry, 0]]] - away
        if deep > 0.0 and speed < 0.0:
            after = min(deep / -speed, time_step)
            if after > most:
                best, most = entry, after
    return best, most


@inlined_kernel
def _move(bodies: Bodies, atoms: Atoms, box: Box, row: int, time: float) -> None:
    bodies.x[row] += bodies.vx[row] * time
    bodies.y[row] += bodies.vy[row] * time
    bodies.angle[row] += bodies.turning[row] * time
    place(bodies, atoms, box, row, row + 1)


@bare_kernel
def _collide(
    bodies: Bodies,
    walls: Walls,
    entry: int,
    row: int,
    atoms: Atoms,
    gas: Gas,
    box: Box,
    book: Ledger,
    time: float,
    after: float,
    time_step: float,
) -> None:
    """Go back to the contact, turn round, and go on from there.

    As of discs, the half kicks before and after the drift know nothing of that: with the acceleration a along the
    normal, place and speed there lack a t² and a (2t - time_step) at the end.
    """
    hall, result = walls.hall, walls.hall.result
    k, e = walls.near[entry, 0], walls.near[entry, 1]
    site, number = atoms.row[k], hall.kind[e, WALL]
    rate, ease = bodies.rate[row], bodies.ease[row]
    _move(bodies, atoms, box, row, -after)
    nx, ny, _, speed, across, along = _lever(bodies, walls, entry, row, atoms, box)
    if speed >= 0.0:
        # It has turned so far that it does not approach there: let it meet the wall at the end of the step.
        _move(bodies, atoms, box, row, after)
        after = 0.0
        nx, ny, _, speed, across, along = _lever(bodies, walls, entry, row, atoms, box)
    normal = rate + across * across * ease
    push = (bodies.fx[row] * nx + bodies.fy[row] * ny) * rate + bodies.torque[row] * across * ease
    jn, jt = -2.0 * speed / normal, 0.0
    late = push * (2.0 * after - time_step)
    if hall.wall[number, TEMPERATURE] >= 0.0:
        cross, tangent = across * along * ease, rate + along * along * ease
        slide = bodies.vy[row] * nx - bodies.vx[row] * ny + bodies.turning[row] * along
        out, noise = thermal_speeds(
            hall, number, 1.0, book.id[site], time, float(entry * _ROUNDS + walls.cursor[2])
        )
        out *= math.sqrt(normal)
        gain = out - speed
        skid = cross / normal * out + math.sqrt(tangent - cross * cross / normal) * noise - slide
        whole = normal * tangent - cross * cross
        jn, jt = (tangent * gain - cross * skid) / whole, (normal * skid - cross * gain) / whole
        late = push * (after - 0.5 * time_step)
    before = _energy(bodies, row)
    vx, vy = bodies.vx[row], bodies.vy[row]
    bodies.vx[row] += (jn * nx - jt * ny) * rate
    bodies.vy[row] += (jn * ny + jt * nx) * rate
    bodies.turning[row] += (jn * across + jt * along) * ease
    result[2], result[3], result[4], result[5] = jn, 0.0, 0.0, 0.0
    if hall.wall[number, TEMPERATURE] >= 0.0:
        result[4] = _energy(bodies, row) - before
    _move(bodies, atoms, box, row, after)
    _nudge(bodies, row, nx, ny, across, push * after * after / normal, late / normal)
    place(bodies, atoms, box, row, row + 1)
    jx, jy = bodies.mass[row] * (bodies.vx[row] - vx), bodies.mass[row] * (bodies.vy[row] - vy)
    book_hall(book, gas.species[site], site, number, time, jx, jy, result)


@inlined_kernel
def _nudge(bodies: Bodies, row: int, nx: float, ny: float, across: float, way: float, impulse: float) -> None:
    """Add to place and velocity as an impulse along the normal would."""
    rate, turn = bodies.rate[row], across * bodies.ease[row]
    bodies.x[row] += way * nx * rate
    bodies.y[row] += way * ny * rate
    bodies.angle[row] += way * turn
    bodies.vx[row] += impulse * nx * rate
    bodies.vy[row] += impulse * ny * rate
    bodies.turning[row] += impulse * turn


@inlined_kernel
def _energy(bodies: Bodies, row: int) -> float:
    flight = bodies.mass[row] * (bodies.vx[row] ** 2 + bodies.vy[row] ** 2)
    return 0.5 * (flight + bodies.inertia[row] * bodies.turning[row] ** 2)
