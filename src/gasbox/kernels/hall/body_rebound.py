"""What happens to a molecule at a wall: the impulse at the disc that touches also turns it.

Symbols: n unit normal towards the disc, v velocity of the centre of mass, u speed of the wall along n, m mass.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.random import philox, time_words, uniform
from gasbox.kernels.hall.rebound import rest_speed
from gasbox.kernels.hall.tables import (
    MASS,
    MOTION,
    NX,
    NY,
    PUSH,
    REST,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    TEMPERATURE,
    WALL,
    Hall,
)
from gasbox.kernels.molecules.impulse import yielding
from gasbox.rng import Stream

__all__ = ["rebound_body"]

_STREAM = int(Stream.THERMAL_WALLS)

_Motion = tuple[float, float, float]
"""Velocity of the centre of mass, and angular velocity."""


@bare_kernel
def rebound_body(
    hall: Hall,
    e: int,
    nx: float,
    ny: float,
    motion: _Motion,
    closing: float,
    lever: float,
    mass: float,
    inertia: float,
    r: float,
    label: int,
    time: float,
    epoch: float,
) -> _Motion:
    """New motion of a molecule at element e, and of a piston; `hall.result` as `rebound` leaves it, but for velocities.

    Parameters
    ----------
    nx, ny : unit normal towards the disc that touches
    closing : its speed along n relative to the wall, below 0 [length/time]
    lever : of an impulse along n about the centre of mass [length]
    r : radius of that disc [length]
    label : id of the molecule, for random numbers
    time, epoch : [time], of the meeting, since the start of the epoch, and that start
    """
    number, result = hall.kind[e, WALL], hall.result
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    u = speed(hall, number, time) * along if hall.rule[number, MOTION] != REST else 0.0
    least = rest_speed(hall, number, along, nx, ny, r, time)
    soft = yielding(mass, inertia, lever)
    vx, vy, omega = motion
    result[4] = result[5] = 0.0
    pushed = 0.0
    if hall.wall[number, TEMPERATURE] >= 0.0:
        before = _energy(vx - u * nx, vy - u * ny, omega, mass, inertia)
        vx, vy, omega, closing = _emitted(
            hall, number, nx, ny, lever, mass, inertia, soft, label, time, epoch
        )
        result[4] = _energy(vx, vy, omega, mass, inertia) - before
        vx, vy = vx + u * nx, vy + u * ny
        pushed = mass * ((vx - motion[0]) * nx + (vy - motion[1]) * ny)
        away = max(closing, least)
    else:
        away = max(-closing, least)
        if hall.wall[number, MASS] > 0.0:
            soft += along * along / hall.wall[number, MASS]
    impulse = (away - closing) / soft
    if away > abs(closing):
        result[5] = 0.5 * (away * away - closing * closing) / soft
    vx, vy = vx + impulse / mass * nx, vy + impulse / mass * ny
    if inertia > 0.0:
        omega += impulse * lever / inertia
    result[2] = pushed + impulse
    result[3] = u * result[2]
    if hall.wall[number, MASS] > 0.0:
        _push_piston(hall, number, along, impulse, time)
        # It moves with the mean of its speeds before and after.
        result[3] -= 0.5 * (along * impulse) ** 2 / hall.wall[number, MASS]
    return vx, vy, omega


@inlined_kernel
def _energy(vx: float, vy: float, omega: float, mass: float, inertia: float) -> float:
    return 0.5 * (mass * (vx * vx + vy * vy) + inertia * omega * omega)


@inlined_kernel
def _push_piston(hall: Hall, number: int, along: float, impulse: float, time: float) -> None:
    """Give a free piston the opposite of an impulse, as far as it can move that way."""
    place, rate = displacement(hall, number, time), speed(hall, number, time)
    hall.wall[number, S_TIME], hall.wall[number, S_PLACE] = time, place
    hall.wall[number, S_SPEED] = rate - along * impulse / hall.wall[number, MASS]
    hall.wall[number, S_PUSH] = hall.wall[number, PUSH]


@inlined_kernel
def _normal_pair(first: float, second: float) -> tuple[float, float]:
    """Two normal numbers from two uniform ones."""
    away = math.sqrt(-2.0 * math.log(first))
    return away * math.cos(2.0 * math.pi * second), away * math.sin(2.0 * math.pi * second)


@bare_kernel
def _emitted(
    hall: Hall,
    number: int,
    nx: float,
    ny: float,
    lever: float,
    mass: float,
    inertia: float,
    soft: float,
    label: int,
    time: float,
    epoch: float,
) -> tuple[float, float, float, float]:
    """Velocity, angular velocity and speed of the disc along n with which a molecule leaves a thermal wall.

    Scaled by the roots of mass and inertia, its motion is that of a point in three dimensions, and the wall
    a plane with the normal N = (n/sqrt(m), lever/sqrt(I))/sqrt(soft). The speed along N has the distribution of what
    hits a plane, v exp(-v²/2T); the two others are normal.
    """
    low, high = time_words(time)
    start, more = time_words(epoch)
    tag, key = start ^ more ^ number, hall.seed[0] ^ _STREAM
    words = philox(label, low, high, tag, key, hall.seed[1])
    flux = math.sqrt(-2.0 * math.log(uniform(words[0], words[1])))
    words = philox(label, low, high, tag, key, hall.seed[1] ^ 1)
    along_x, along_y = _normal_pair(uniform(words[0], words[1]), uniform(words[2], words[3]))
    words = philox(label, low, high, tag, key, hall.seed[1] ^ 2)
    turning, _ = _normal_pair(uniform(words[0], words[1]), uniform(words[2], words[3]))
    root_mass, root_inertia = math.sqrt(mass), math.sqrt(inertia)
    share = 1.0 / math.sqrt(soft)
    normal_x, normal_y = nx / root_mass * share, ny / root_mass * share
    normal_turn = lever / root_inertia * share if inertia > 0.0 else 0.0
    scale = math.sqrt(hall.wall[number, TEMPERATURE])
    more_of_it = flux - (along_x * normal_x + along_y * normal_y + turning * normal_turn)
    vx = scale * (along_x + more_of_it * normal_x) / root_mass
    vy = scale * (along_y + more_of_it * normal_y) / root_mass
    omega = scale * (turning + more_of_it * normal_turn) / root_inertia if inertia > 0.0 else 0.0
    return vx, vy, omega, scale * flux * math.sqrt(soft)
