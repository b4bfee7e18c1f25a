"""When a disc in flight meets a corner, a post or the rim of a circle. Symbols as in `gasbox.kernels.hall.sides`."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.roots import CLOSE, GRAZING_SPEED, MARCHES, first_fall, safe_step
from gasbox.kernels.hall.tables import AMPLITUDE, MOTION, NX, NY, OMEGA, WALL, WAVE, Hall

__all__ = ["touch_corner", "touch_rim"]


@bare_kernel
def _near_corner(
    hall: Hall,
    e: int,
    x: float,
    y: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    t: float,
    reach: float,
    begin: float,
) -> tuple[float, float]:
    """Distance from a corner less the reach, and its rate, after a time t."""
    number = hall.kind[e, WALL]
    px = x + vx * t + 0.5 * gx * t * t
    py = y + vy * t + 0.5 * gy * t * t
    ux, uy = vx + gx * t, vy + gy * t
    if hall.rule[number, MOTION] == WAVE:
        nx, ny = hall.shape[e, NX], hall.shape[e, NY]
        rate = speed(hall, number, begin)
        swing = displacement(hall, number, begin + t) - displacement(hall, number, begin) - rate * t
        more = speed(hall, number, begin + t) - rate
        px, py, ux, uy = px - nx * swing, py - ny * swing, ux - nx * more, uy - ny * more
    away = math.sqrt(px * px + py * py)
    return away - reach, (px * ux + py * uy) / away


@bare_kernel
def touch_corner(
    hall: Hall,
    e: int,
    x: float,
    y: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    reach: float,
    depth: float,
    begin: float,
    limit: float,
) -> float:
    """Time until the distance from a corner falls to `reach`; exact without acceleration, marched with it."""
    least = GRAZING_SPEED * (abs(vx) + abs(vy))
    number = hall.kind[e, WALL]
    waves = hall.rule[number, MOTION] == WAVE
    if gx == 0.0 and gy == 0.0 and not waves:
        b = x * vx + y * vy
        speed2 = vx * vx + vy * vy
        c = x * x + y * y - reach * reach
        if b >= -least * reach:
            return math.inf
        if c <= 0.0:
            return 0.0 if c >= -2.0 * depth * reach else math.inf
        cross = x * vy - y * vx
        inside = reach * reach * speed2 - cross * cross
        return math.inf if inside <= 1e-24 * speed2 * reach * reach else c / (math.sqrt(inside) - b)
    bound = math.sqrt(gx * gx + gy * gy)
    if waves:
        bound += abs(hall.wall[number, AMPLITUDE]) * hall.wall[number, OMEGA] ** 2
    t = 0.0
    f, slope = _near_corner(hall, e, x, y, vx, vy, gx, gy, 0.0, reach, begin)
    if f < -depth:
        return math.inf
    scale = abs(f) + reach
    for step in range(MARCHES):
        if f <= 0.0 and (slope < -least or (slope <= 0.0 and step > 0)):
            break
        t += safe_step(max(f, 0.0), slope, bound)
        if not t <= limit:
            return math.inf
        f, slope = _near_corner(hall, e, x, y, vx, vy, gx, gy, t, reach, begin)
        if abs(f) <= CLOSE * scale and slope < 0.0:
            for _ in range(3):
                t -= f / slope
                f, slope = _near_corner(hall, e, x, y, vx, vy, gx, gy, t, reach, begin)
            return max(t, 0.0)
    return t


@inlined_kernel
def _within_rim(
    x: float, y: float, vx: float, vy: float, gx: float, gy: float, t: float, room: float
) -> tuple[float, float]:
    """room² less the square of the distance from the centre, and its rate, after a time t."""
    px = x + vx * t + 0.5 * gx * t * t
    py = y + vy * t + 0.5 * gy * t * t
    return room * room - px * px - py * py, -2.0 * (px * (vx + gx * t) + py * (vy + gy * t))


@bare_kernel
def touch_rim(
    x: float, y: float, vx: float, vy: float, gx: float, gy: float, room: float, limit: float
) -> float:
    """Time until the distance from the centre of a circle rises to `room`; marched under gravity."""
    f, slope = _within_rim(x, y, vx, vy, gx, gy, 0.0, room)
    speed2 = vx * vx + vy * vy
    least = 2.0 * room * GRAZING_SPEED * (abs(vx) + abs(vy))
    if gx == 0.0 and gy == 0.0:
        # f + slope t - speed² t²
        return first_fall(f, slope, -2.0 * speed2, math.inf, least)
    strength = math.sqrt(gx * gx + gy * gy)
    # By energy the square of the speed stays below speed² + 4 room strength while the disc is inside.
    bound = 2.0 * (speed2 + 5.0 * room * strength)
    t = 0.0
    for step in range(MARCHES):
        if f <= 0.0 and (slope < -least or (slope <= 0.0 and step > 0)):
            break
        t += safe_step(max(f, 0.0), slope, bound)
        if not t <= limit:
            return math.inf
        f, slope = _within_rim(x, y, vx, vy, gx, gy, t, room)
        if abs(f) <= CLOSE * room * room and slope < 0.0:
            for _ in range(3):
                t -= f / slope
                f, slope = _within_rim(x, y, vx, vy, gx, gy, t, room)
            return max(t, 0.0)
    return t
