"""What a wall of an enclosure gives to a molecule that strikes it with one of its sites: impulse, work and heat."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Gas, Ledger, book_hall
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.rebound import thermal_speeds
from gasbox.kernels.hall.tables import MASS, NX, NY, PUSH, S_PUSH, S_SPEED, TEMPERATURE, WALL, Hall
from gasbox.kernels.stepped.bodies import Bodies
from gasbox.kernels.stepped.strike import lever_of, push_body, yielding_of
from gasbox.kernels.stepped.tables import Walls

__all__ = ["bounce_body"]


@bare_kernel
def _recoil(
    hall: Hall,
    e: int,
    nx: float,
    ny: float,
    closing: float,
    yielding: float,
    lift: float,
    label: int,
    time: float,
    epoch: float,
) -> float:
    """Impulse along n that the wall of element e gives; work, heat and rest are left in `hall.result`.

    The contact is a mass 1/yielding on a line: this is what an impulse along n meets. A thermal wall draws its speed
    anew, as that of a disc of this mass; the rest of the motion of a smooth body knows nothing of the wall.

    Parameters
    ----------
    nx, ny : unit normal towards the body
    closing : speed along n of the contact relative to the wall, below zero [length/time]
    yielding : change of the normal speed of the contact for each unit of impulse [1/mass]
    lift : energy that moving the body out of the wall has set free (below zero: has cost) [energy]
    label, time, epoch : as for `gasbox.kernels.hall.rebound.rebound`
    """
    number = hall.kind[e, WALL]
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    u = speed(hall, number, time) * along
    heavy = hall.wall[number, MASS]
    both = yielding + 1.0 / heavy if heavy > 0.0 else yielding
    square = closing * closing + 2.0 * both * lift
    rest = max(-0.5 * square / both, 0.0)
    square = max(square, 0.0)
    away, heat = math.sqrt(square), 0.0
    if hall.wall[number, TEMPERATURE] >= 0.0 and heavy == 0.0:
        away = thermal_speeds(hall, number, 1.0 / both, label, time, epoch)[0]
        heat = 0.5 * (away * away - square) / both
    impulse = (away - closing) / both
    gained = impulse * (closing + u) + 0.5 * impulse * impulse * yielding - lift
    moves = u != 0.0 or heavy > 0.0
    if heavy > 0.0:
        hall.wall[number, S_SPEED] -= impulse / heavy * along
        hall.wall[number, S_PUSH] = hall.wall[number, PUSH]
    hall.result[2], hall.result[3] = impulse, gained - heat - rest if moves else 0.0
    hall.result[4], hall.result[5] = heat, rest
    return impulse


@inlined_kernel
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
    """A site strikes element e: its body recoils."""
    hall, arm = walls.hall, lever_of(bodies, site, nx, ny)
    yielding = yielding_of(bodies, row, arm)
    impulse = _recoil(hall, e, nx, ny, closing, yielding, lift, book.id[site], time, epoch)
    push_body(bodies, row, arm, nx, ny, impulse)
    number = hall.kind[e, WALL]
    book_hall(book, gas.species[site], site, number, time, impulse * nx, impulse * ny, hall.result)
