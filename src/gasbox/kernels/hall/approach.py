"""When a disc in flight meets an element of the enclosure: a pure function of its reference and of that of the wall.

Symbols: x, y place of the disc relative to the element, v its velocity relative to the wall, g its acceleration
relative to the wall, r radius of the disc, t time.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.motion import displacement, push, speed
from gasbox.kernels.hall.roots import GRAZING_SPEED, MARCHES, first_fall, safe_step
from gasbox.kernels.hall.tables import (
    AMPLITUDE,
    CORNER,
    DIRECTION,
    FACES,
    GREATEST,
    HIGH,
    KIND,
    LEAST,
    LOW,
    MOTION,
    NX,
    NY,
    OMEGA,
    OPEN,
    PX,
    PY,
    REST,
    RHO,
    S_TIME,
    SIDE,
    SMOOTH,
    SOFT,
    TX,
    TY,
    WALL,
    WAVE,
    Hall,
)

__all__ = ["BOUNCE", "PASS", "passes", "touch"]

BOUNCE, PASS = 0, 1
"""What happens at a meeting: the disc bounces, or its centre passes and is counted."""
_SOFT_DEPTH = 1e-6
"""A disc that overlaps a wall that some may pass by more than this part of its radius is let go on."""
_ON_LINE = 1e-10
"""Of the radius: a centre so near to a line stands on it."""
_CLOSE = 1e-9
"""Of the lengths involved: so near a zero the march goes over to Newton's method, which then doubles the digits."""


@inlined_kernel
def passes(hall: Hall, number: int, species: int, vx: float, vy: float, along: float) -> bool:
    """Whether a disc with this velocity, relative to the wall, passes it; `along` its component along the normal."""
    if not hall.passes[number, species]:
        return False
    direction = hall.rule[number, DIRECTION]
    if direction != 0 and direction * along < 0.0:
        return False
    least, greatest = hall.wall[number, LEAST], hall.wall[number, GREATEST]
    speed2 = vx * vx + vy * vy
    return least * least <= speed2 and speed2 <= greatest * greatest


@inlined_kernel
def _foot(
    hall: Hall, e: int, x: float, y: float, vx: float, vy: float, gx: float, gy: float, t: float
) -> bool:
    """Whether the foot of the perpendicular lies on side e after a time t."""
    px = x + vx * t + 0.5 * gx * t * t
    py = y + vy * t + 0.5 * gy * t * t
    foot = px * hall.shape[e, TX] + py * hall.shape[e, TY]
    return hall.shape[e, LOW] <= foot <= hall.shape[e, HIGH]


@inlined_kernel
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
        if abs(f) <= _CLOSE * (abs(c) + abs(b) * t) and slope < 0.0:
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
        depth = _SOFT_DEPTH * r
    else:
        depth = r
    if hall.rule[number, MOTION] == WAVE:
        # The swing is taken out of the curvature: it is known exactly at all times.
        return _wave_fall(hall, e, c, b, a, face, depth, least, begin, limit)
    return first_fall(c, b, a, depth, least)


@inlined_kernel
def _touch_side(
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


@inlined_kernel
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


@inlined_kernel
def _touch_corner(
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
        if abs(f) <= _CLOSE * scale and slope < 0.0:
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


@inlined_kernel
def _touch_rim(
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
        if abs(f) <= _CLOSE * room * room and slope < 0.0:
            for _ in range(3):
                t -= f / slope
                f, slope = _within_rim(x, y, vx, vy, gx, gy, t, room)
            return max(t, 0.0)
    return t


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
    x, y, vx, vy, begin, r = flight
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
    limit = until - begin
    kind = hall.kind[e, KIND]
    if kind == SIDE:
        t, what = _touch_side(hall, e, x, y, vx, vy, gx, gy, r, species, begin, limit)
        return begin + t, what
    if hall.rule[number, OPEN]:
        return math.inf, BOUNCE
    if hall.passes[number, species] and passes(hall, number, species, vx, vy, 0.0):
        return math.inf, BOUNCE
    if kind == CORNER:
        reach = r + hall.shape[e, RHO]
        depth = _SOFT_DEPTH * r if hall.rule[number, SOFT] else reach
        return begin + _touch_corner(hall, e, x, y, vx, vy, gx, gy, reach, depth, begin, limit), BOUNCE
    return begin + _touch_rim(x, y, vx, vy, gx, gy, hall.shape[e, RHO] - r, limit), BOUNCE
