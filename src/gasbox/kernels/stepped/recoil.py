"""A molecule strikes a wall of an enclosure with one of its sites: the impulse, and its books."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel
from gasbox.kernels.arguments import Gas, Ledger, book_hall
from gasbox.kernels.hall.body_rebound import rebound_body
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.tables import MASS, NX, NY, S_SPEED, WALL
from gasbox.kernels.stepped.bodies import Bodies
from gasbox.kernels.stepped.strike import lever_of, push_body, yielding_of
from gasbox.kernels.stepped.tables import Walls

__all__ = ["bounce_body"]


@bare_kernel
def _pay(
    row: int,
    arm: float,
    nx: float,
    ny: float,
    closing: float,
    lift: float,
    e: int,
    bodies: Bodies,
    walls: Walls,
) -> tuple[float, float, float]:
    """Let a contact pay for what moving its body has cost: the closing speed left, impulse, and what is lacking."""
    hall = walls.hall
    number = hall.kind[e, WALL]
    heavy = hall.wall[number, MASS]
    soft = yielding_of(bodies, row, arm)
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    if heavy > 0.0:
        soft += along * along / heavy
    square = closing * closing + 2.0 * soft * lift
    impulse = (-math.sqrt(max(square, 0.0)) - closing) / soft
    push_body(bodies, row, arm, nx, ny, impulse)
    if heavy > 0.0:
        hall.wall[number, S_SPEED] -= impulse / heavy * along
    return closing + impulse * soft, impulse, max(-0.5 * square / soft, 0.0)


@bare_kernel
def bounce_body(
    e: int,
    nx: float,
    ny: float,
    closing: float,
    lift: float,
    epoch: float,
    site: int,
    row: int,
    gas: Gas,
    bodies: Bodies,
    walls: Walls,
    book: Ledger,
    time: float,
) -> None:
    """A site strikes element e with `closing` speed: its body rebounds, as it does in exact flight.

    lift : energy that moving the body out of the wall has set free (below zero: has cost) [energy]
    epoch : keeps two meetings in one step from drawing the same random numbers
    """
    hall, arm = walls.hall, lever_of(bodies, site, nx, ny)
    result, number, mass, inertia = hall.result, hall.kind[e, WALL], bodies.mass[row], bodies.inertia[row]
    vx, vy, spin = bodies.velocity[row, 0], bodies.velocity[row, 1], bodies.spin[row]
    impulse, lacking = 0.0, 0.0
    if lift != 0.0:
        closing, impulse, lacking = _pay(row, arm, nx, ny, closing, lift, e, bodies, walls)
    motion = bodies.velocity[row, 0], bodies.velocity[row, 1], bodies.spin[row]
    wx, wy, turning = rebound_body(
        hall, e, nx, ny, motion, closing, arm, mass, inertia, gas.radius[site], book.id[site], time, epoch
    )
    bodies.velocity[row, 0], bodies.velocity[row, 1], bodies.spin[row] = wx, wy, turning
    result[2] += impulse
    result[5] += lacking
    if lift != 0.0:
        gained = 0.5 * mass * (wx * wx + wy * wy - vx * vx - vy * vy) - lift
        gained += 0.5 * inertia * (turning * turning - spin * spin)
        moves = speed(hall, number, time) != 0.0 or hall.wall[number, MASS] > 0.0
        result[3] = gained - result[4] - result[5] if moves else 0.0
    book_hall(book, gas.species[site], site, number, time, mass * (wx - vx), mass * (wy - vy), result)
