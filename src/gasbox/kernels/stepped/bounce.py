"""A disc turns round at a wall, or leaves through it; energy, momentum, work and heat are booked."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_crossing, book_hall
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.rebound import rebound
from gasbox.kernels.hall.tables import KIND, MASS, NX, NY, PX, PY, S_SPEED, SIDE, WALL, Hall
from gasbox.kernels.stepped.tables import Slots, Walls

__all__ = ["bounce", "leave", "parked"]

_PARKED = 4.0
"""Boxes between discs that have left, and everybody else."""


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
def bounce(
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
def parked(row: int, box: Box) -> float:
    """Where a disc that has left stands, far from everybody."""
    return -(row + 2) * _PARKED * (box.width + box.height)


@inlined_kernel
def leave(
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
    walls.cursor[3] += 1
    slots.x[slot] = parked(row, box)
    slots.vx[slot] = slots.vy[slot] = 0.0
