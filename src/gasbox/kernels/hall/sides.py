"""When a disc in flight meets a straight side, bounces from it or passes it.

Symbols: x, y place of the disc relative to the side, v its velocity relative to the wall, g its acceleration relative
to the wall, r radius of the disc, t time.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.roots import CLOSE, GRAZING_SPEED, MARCHES, first_fall, safe_step
from gasbox.kernels.hall.tables import (
    AMPLITUDE,
    BACK_GREATEST,
    BACK_LEAST,
    FACES,
    GREATEST,
    HIGH,
    LEAST,
    LOW,
    MOTION,
    NX,
    NY,
    OMEGA,
    OPEN,
    SOFT,
    TX,
    TY,
    WALL,
    WAVE,
    Hall,
)

__all__ = ["BOUNCE", "PASS", "SOFT_DEPTH", "passes", "touch_side"]

BOUNCE, PASS = 0, 1
"""What happens at a meeting: the disc bounces, or its centre passes and is counted."""
SOFT_DEPTH = 1e-6
"""A disc that overlaps a wall that some may pass by more than this part of its radius is let go on."""
_ON_LINE = 1e-10
"""Of the radius: a centre so near to a line stands on it."""


@inlined_kernel
def passes(hall: Hall, number: int, species: int, vx: float, vy: float, along: float) -> bool:
    """Whether a disc with this velocity, relative to the wall, passes it; `along` its component along the normal.

    One that goes neither along it nor against it passes if it does so either way.
    """
    if not hall.passes[number, species]:
        return False
    speed2 = vx * vx + vy * vy
    if along >= 0.0 and hall.ways[number, species, 0]:
        least, greatest = hall.wall[number, LEAST], hall.wall[number, GREATEST]
        if least * least <= speed2 and speed2 <= greatest * greatest:
            return True
    if along <= 0.0 and hall.ways[number, species, 1]:
        least, greatest = hall.wall[number, BACK_LEAST], hall.wall[number, BACK_GREATEST]
        return least * least <= speed2 and speed2 <= greatest * greatest
    return False


@inlined_kernel
def _foot(
    hall: Hall, e: int, x: float, y: float, vx: float, vy: float, gx: float, gy: float, t: float
) -> bool:
    """Whether the foot of the perpendicular lies on side e after a time t."""
    px = x + vx * t + 0.5 * gx * t * t
    py = y + vy * t + 0.5 * gy * t * t
    foot = px * hall.shape[e, TX] + py * hall.shape[e, TY]
    return hall.shape[e, LOW] <= foot <= hall.shape[e, HIGH]


@bare_kernel
def _wave_fall(
    hall: Hall,
    e: int,
    c: float,
    b: float,
    a: float,
    face: float,
    depth: float,
    least: float,
    begin: float,
    limit: float,
) -> float:
    """As `first_fall` for a wall that swings: c, b of the distance at time `begin`, a without the swing."""
    number = hall.kind[e, WALL]
    omega = hall.wall[number, OMEGA]
    bound = max(-a, 0.0) + abs(hall.wall[number, AMPLITUDE]) * omega * omega
    place = displacement(hall, number, begin)
    rate = speed(hall, number, begin)
    t, f, slope = 0.0, c, b
    rise = max(a, 0.0) + abs(hall.wall[number, AMPLITUDE]) * omega * omega
    for step in range(MARCHES):
        if f < -depth:
            # Beyond the wall: first it must come up on this side.
            t += safe_step(-f, -slope, rise)
            if not t <= limit:
                return math.inf
            f = (
                c
                + b * t
                + 0.5 * a * t * t
                - face * (displacement(hall, number, begin + t) - place - rate * t)
            )
            slope = b + a * t - face * (speed(hall, number, begin + t) - rate)
            continue
        if f <= 0.0 and (slope < -least or (slope <= 0.0 and step > 0)):
            break
        t += safe_step(max(f, 0.0), slope, bound)
        if not t <= limit:
            return math.inf
        f = c + b * t + 0.5 * a * t * t - face * (displacement(hall, number, begin + t) - place - rate * t)
        slope = b + a * t - face * (speed(hall, number, begin + t) - rate)
        if abs(f) <= CLOSE * (abs(c) + abs(b) * t) and slope < 0.0:
            for _ in range(3):
                more = f / slope
                t -= more
                f = (
                    c
                    + b * t
                    + 0.5 * a * t * t
                    - face * (displacement(hall, number, begin + t) - place - rate * t)
                )
                slope = b + a * t - face * (speed(hall, number, begin + t) - rate)
            return max(t, 0.0)
    return t


@inlined_kernel
def _face_fall(
    hall: Hall,
    e: int,
    height: float,
    rate: float,
    curve: float,
    gap: float,
    face: float,
    r: float,
    least: float,
    begin: float,
    limit: float,
) -> float:
    """When the distance from a side, as seen from one of its faces, falls to `gap`."""
    number = hall.kind[e, WALL]
    c, b, a = face * height - gap, face * rate, face * curve
    if gap == 0.0:
        if hall.rule[number, OPEN]:
            depth = math.inf
        elif abs(c) <= _ON_LINE * r:
            # It has just been counted here.
            c, depth = 0.0, -1.0
        else:
            depth = 0.0
    elif hall.rule[number, SOFT]:
        depth = SOFT_DEPTH * r
    else:
        depth = r
    if hall.rule[number, MOTION] == WAVE:
        # The swing is taken out of the curvature: it is known exactly at all times.
        return _wave_fall(hall, e, c, b, a, face, depth, least, begin, limit)
    return first_fall(c, b, a, depth, least)


@bare_kernel
def touch_side(
    hall: Hall,
    e: int,
    x: float,
    y: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    r: float,
    species: int,
    begin: float,
    limit: float,
) -> tuple[float, int]:
    """Earliest meeting with a side; x, y from its displaced start, v relative to it, g relative to a smooth motion."""
    number = hall.kind[e, WALL]
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    height, rate, curve = x * nx + y * ny, vx * nx + vy * ny, gx * nx + gy * ny
    least = GRAZING_SPEED * (abs(vx) + abs(vy))
    best, what = math.inf, BOUNCE
    faces = hall.kind[e, FACES]
    ways = hall.passes[number, species] or hall.rule[number, OPEN] != 0
    for side in range(2):
        face = 1.0 if side == 0 else -1.0
        if faces * face < 0.0:
            continue
        if not hall.rule[number, OPEN]:
            t = _face_fall(hall, e, height, rate, curve, r, face, r, least, begin, limit)
            if t < best and _foot(hall, e, x, y, vx, vy, gx, gy, t):
                ux, uy = vx + gx * t, vy + gy * t
                if not ways or not passes(hall, number, species, ux, uy, ux * nx + uy * ny):
                    best, what = t, BOUNCE
        if ways:
            t = _face_fall(hall, e, height, rate, curve, 0.0, face, r, least, begin, limit)
            if t < best and _foot(hall, e, x, y, vx, vy, gx, gy, t):
                best, what = t, PASS
    return best, what
