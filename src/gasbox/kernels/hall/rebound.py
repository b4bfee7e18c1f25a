"""What happens to a disc at a wall: elastic, thermal, or moving; with work, heat and the rule for discs at rest.

Symbols: n unit normal towards the disc, v velocity of the disc, u speed of the wall along n, m mass.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.motion import displacement, push, speed
from gasbox.kernels.hall.random import philox, time_words, uniform
from gasbox.kernels.hall.tables import (
    KIND,
    MASS,
    MOTION,
    NX,
    NY,
    PUSH,
    PX,
    PY,
    REST,
    RIM,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    SIDE,
    TEMPERATURE,
    WALL,
    Hall,
)
from gasbox.rng import Stream

__all__ = ["LEAST_HEIGHT", "normal_at", "rebound", "rest_speed", "thermal_speeds"]

LEAST_HEIGHT = 1e-6
"""A disc that is pressed to a wall rebounds at least so high, in radii: the rule for discs at rest."""
_STREAM = int(Stream.THERMAL_WALLS)


@inlined_kernel
def normal_at(
    hall: Hall, e: int, x: float, y: float, shift_x: float, shift_y: float, time: float
) -> tuple[float, float, float]:
    """Unit normal of element e towards a disc centred at (x, y), and the distance of its centre from the element.

    Of a rim the distance counts from its centre, and the normal points there.
    """
    number = hall.kind[e, WALL]
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    place = displacement(hall, number, time)
    x -= hall.shape[e, PX] + shift_x + nx * place
    y -= hall.shape[e, PY] + shift_y + ny * place
    if hall.kind[e, KIND] == SIDE:
        height = x * nx + y * ny
        return (nx, ny, height) if height >= 0.0 else (-nx, -ny, -height)
    away = math.sqrt(x * x + y * y)
    if hall.kind[e, KIND] == RIM:
        return -x / away, -y / away, away
    return x / away, y / away, away


@inlined_kernel
def rest_speed(hall: Hall, number: int, along: float, nx: float, ny: float, r: float, time: float) -> float:
    """Least speed of a rebound along n, of a disc pressed to the wall; `along`: the wall's normal times n."""
    press = -(hall.gx * nx + hall.gy * ny - push(hall, number, time) * along)
    return math.sqrt(2.0 * press * LEAST_HEIGHT * r) if press > 0.0 else 0.0


@bare_kernel
def thermal_speeds(
    hall: Hall, number: int, mass: float, label: int, time: float, epoch: float
) -> tuple[float, float]:
    """Normal and tangential speed of a disc that leaves a thermal wall: v exp(-m v²/2T), and a Gaussian.

    Source: F. Tenenbaum et al., Phys. Rev. A 25, 2778 (1982), doi:10.1103/PhysRevA.25.2778, in two dimensions.
    """
    low, high = time_words(time)
    start, more = time_words(epoch)
    words = philox(label, low, high, start ^ more ^ number, hall.seed[0] ^ _STREAM, hall.seed[1])
    one, two = uniform(words[0], words[1]), uniform(words[2], words[3])
    scale = math.sqrt(hall.wall[number, TEMPERATURE] / mass)
    # The tangential speed is one of two Gaussians from a second pair of numbers.
    words = philox(label, low, high, start ^ more ^ number, hall.seed[0] ^ _STREAM, hall.seed[1] ^ 1)
    radius = math.sqrt(-2.0 * math.log(uniform(words[0], words[1])))
    return scale * math.sqrt(-2.0 * math.log(one)), scale * radius * math.cos(2.0 * math.pi * two)


@bare_kernel
def rebound(
    hall: Hall,
    e: int,
    nx: float,
    ny: float,
    vx: float,
    vy: float,
    mass: float,
    r: float,
    label: int,
    time: float,
    epoch: float,
    result: NDArray[np.float64],
) -> bool:
    """New velocity of a disc at element e, and of a piston; False if they do not approach.

    Parameters
    ----------
    nx, ny : unit normal towards the disc
    label : id of the disc, for random numbers
    time, epoch : [time], of the meeting, since the start of the epoch, and that start
    result : (6,) new velocity (2), normal impulse, work, heat, energy of the resting rule
    """
    number = hall.kind[e, WALL]
    along = hall.shape[e, NX] * nx + hall.shape[e, NY] * ny
    u = speed(hall, number, time) * along if hall.rule[number, MOTION] != REST else 0.0
    vn = vx * nx + vy * ny
    if vn - u > 0.0:
        return False
    least = rest_speed(hall, number, along, nx, ny, r, time)
    if vn - u == 0.0 and least == 0.0:
        return False
    if hall.wall[number, MASS] > 0.0:
        return _push_piston(hall, number, along, nx, ny, vx, vy, u, mass, least, time, result)
    vt = vy * nx - vx * ny
    away, slide = u - vn, vt
    if hall.wall[number, TEMPERATURE] >= 0.0:
        away, slide = thermal_speeds(hall, number, mass, label, time, epoch)
        result[4] = 0.5 * mass * (away * away + slide * slide - (vn - u) ** 2 - vt * vt)
    else:
        result[4] = 0.0
    result[5] = 0.0
    if away < least:
        result[5] = 0.5 * mass * (least * least - away * away)
        away = least
    wn = u + away
    result[0], result[1] = wn * nx - slide * ny, wn * ny + slide * nx
    result[2] = mass * (wn - vn)
    result[3] = u * result[2]
    return True


@inlined_kernel
def _push_piston(
    hall: Hall,
    number: int,
    along: float,
    nx: float,
    ny: float,
    vx: float,
    vy: float,
    u: float,
    mass: float,
    least: float,
    time: float,
    result: NDArray[np.float64],
) -> bool:
    """The elastic collision of a disc and a free piston, along the normal."""
    heavy = hall.wall[number, MASS]
    vn = vx * nx + vy * ny
    away = max(u - vn, least)
    # Relative speed after the meeting is `away`; momentum along n is conserved.
    impulse = mass * heavy / (mass + heavy) * (away - (vn - u))
    wn, wu = vn + impulse / mass, u - impulse / heavy
    result[0], result[1] = vx + (wn - vn) * nx, vy + (wn - vn) * ny
    result[2] = impulse
    gained = 0.5 * mass * heavy / (mass + heavy) * (away * away - (vn - u) ** 2)
    result[5] = gained if away > u - vn else 0.0
    result[3] = 0.5 * mass * (wn * wn - vn * vn) - result[5]
    result[4] = 0.0
    place = displacement(hall, number, time)
    hall.wall[number, S_TIME], hall.wall[number, S_PLACE] = time, place
    hall.wall[number, S_SPEED], hall.wall[number, S_PUSH] = wu * along, hall.wall[number, PUSH]
    return True
