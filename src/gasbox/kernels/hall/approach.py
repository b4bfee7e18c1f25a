"""When a disc in flight meets an element of the enclosure: a pure function of its reference and of that of the wall.

Symbols as in `gasbox.kernels.hall.sides`.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.curves import touch_corner, touch_rim
from gasbox.kernels.hall.motion import displacement, push, speed
from gasbox.kernels.hall.sides import BOUNCE, PASS, SOFT_DEPTH, passes, touch_side
from gasbox.kernels.hall.tables import (
    CORNER,
    KIND,
    MOTION,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    REST,
    RHO,
    S_TIME,
    SIDE,
    SMOOTH,
    SOFT,
    WALL,
    Hall,
)

__all__ = ["BOUNCE", "PASS", "passes", "seen_from", "touch"]


@inlined_kernel
def seen_from(
    hall: Hall,
    e: int,
    flight: tuple[float, float, float, float, float, float],
    shift_x: float,
    shift_y: float,
) -> tuple[float, float, float, float, float, float, float]:
    """Place, velocity and acceleration of a disc relative to element e, and the time when it is there.

    Parameters as for `touch`. Of a wall that swings, the swing from then on is left out.
    """
    x, y, vx, vy, begin, _ = flight
    number = hall.kind[e, WALL]
    gx, gy = hall.gx, hall.gy
    px, py = hall.shape[e, PX], hall.shape[e, PY]
    motion = hall.rule[number, MOTION]
    if motion != REST:
        start = max(begin, hall.wall[number, S_TIME]) if motion == SMOOTH else begin
        elapsed = start - begin
        x += vx * elapsed + 0.5 * gx * elapsed * elapsed
        y += vy * elapsed + 0.5 * gy * elapsed * elapsed
        vx += gx * elapsed
        vy += gy * elapsed
        begin = start
        nx, ny = hall.shape[e, NX], hall.shape[e, NY]
        place, rate = displacement(hall, number, begin), speed(hall, number, begin)
        px += nx * place
        py += ny * place
        vx -= nx * rate
        vy -= ny * rate
        if motion == SMOOTH:
            away = push(hall, number, begin)
            gx -= nx * away
            gy -= ny * away
    x -= px + shift_x
    y -= py + shift_y
    return x, y, vx, vy, gx, gy, begin


@bare_kernel
def touch(
    hall: Hall,
    e: int,
    flight: tuple[float, float, float, float, float, float],
    species: int,
    shift_x: float,
    shift_y: float,
    until: float,
) -> tuple[float, int]:
    """When a disc meets element e, and what happens then (BOUNCE or PASS); infinity if not until `until`.

    Parameters
    ----------
    flight : reference position, velocity and time, and radius of the disc
    shift_x, shift_y : added to the place of the element, to reach its image in a periodic box [length]
    until : [time], where a search may end
    """
    x, y, vx, vy, gx, gy, begin = seen_from(hall, e, flight, shift_x, shift_y)
    r, number = flight[5], hall.kind[e, WALL]
    limit = until - begin
    kind = hall.kind[e, KIND]
    if kind == SIDE:
        t, what = touch_side(hall, e, x, y, vx, vy, gx, gy, r, species, begin, limit)
        return begin + t, what
    if hall.rule[number, OPEN]:
        return math.inf, BOUNCE
    if hall.passes[number, species] and passes(hall, number, species, vx, vy, 0.0):
        return math.inf, BOUNCE
    if kind == CORNER:
        reach = r + hall.shape[e, RHO]
        depth = SOFT_DEPTH * r if hall.rule[number, SOFT] else reach
        return begin + touch_corner(hall, e, x, y, vx, vy, gx, gy, reach, depth, begin, limit), BOUNCE
    return begin + touch_rim(x, y, vx, vy, gx, gy, hall.shape[e, RHO] - r, limit), BOUNCE
