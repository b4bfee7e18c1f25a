"""When a molecule in flight meets an element of the enclosure, and with which of its discs.

The distance of a disc from a side or a corner is that of a point from a convex set, so it curves down no faster than
the point is accelerated: by gravity, by the motion of the wall, and by w² a as the molecule turns, with w its angular
velocity and a the distance of the disc from its centre of mass. Within a rim the square of the distance serves. From
such a bound a march finds the first contact and misses none, see `gasbox.kernels.hall.roots`.

Symbols: x, y, u place and velocity of a disc relative to the element, v and g velocity and acceleration of the centre
of mass, r a radius, f distance of a rim from the wall, n unit normal towards the disc, t time, k number of a disc.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.approach import seen_from
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.roots import safe_step
from gasbox.kernels.hall.sides import SOFT_DEPTH
from gasbox.kernels.hall.tables import (
    AMPLITUDE,
    HIGH,
    KIND,
    LOW,
    MOTION,
    NX,
    NY,
    OMEGA,
    RHO,
    RIM,
    SIDE,
    SOFT,
    TX,
    TY,
    WALL,
    WAVE,
    Hall,
)
from gasbox.kernels.molecules.spin import GRAZING, SITE_ARM, SITE_RADIUS, SITE_X, SITE_Y, Spin

__all__ = ["site_at", "touch_body"]

_MARCHES = 200
"""Most steps of a march. Whoever has met nothing by then looks again: an event at which nothing happens."""
_SLACK = 2.0**-50
"""Of the lengths involved: so near is touching."""
_CLOSE = 1e-10
"""Of the reach of a molecule: so near is a disc that an event says is touching, by all rounding."""
_NEAR = 0.01
"""Of the reach: within so much of the wall the bounding circle gives way to the discs in it."""

_Flight = tuple[float, float, float, float, float, float]


@inlined_kernel
def _gap(hall: Hall, e: int, x: float, y: float, r: float) -> tuple[float, float, float]:
    """Distance of the rim of a disc from element e, and the unit normal towards its centre."""
    if hall.kind[e, KIND] == SIDE:
        nx, ny = hall.shape[e, NX], hall.shape[e, NY]
        height, foot = x * nx + y * ny, x * hall.shape[e, TX] + y * hall.shape[e, TY]
        beyond = foot - min(max(foot, hall.shape[e, LOW]), hall.shape[e, HIGH])
        if beyond == 0.0:
            return (height - r, nx, ny) if height >= 0.0 else (-height - r, -nx, -ny)
        x, y = height * nx + beyond * hall.shape[e, TX], height * ny + beyond * hall.shape[e, TY]
    d = max(math.sqrt(x * x + y * y), 1e-300)
    if hall.kind[e, KIND] == RIM:
        return hall.shape[e, RHO] - d - r, -x / d, -y / d
    return d - hall.shape[e, RHO] - r, x / d, y / d


@inlined_kernel
def _way(
    hall: Hall,
    e: int,
    x: float,
    y: float,
    ux: float,
    uy: float,
    r: float,
    bound: float,
    fastest: float,
    slack: float,
    least: float,
) -> float:
    """How long a disc cannot come to touch element e; 0 if it touches and approaches.

    bound : on its acceleration [length/time²]
    fastest : a speed that it does not exceed, for rims only [length/time]
    """
    f, nx, ny = _gap(hall, e, x, y, r)
    slope = ux * nx + uy * ny
    if hall.rule[hall.kind[e, WALL], SOFT] and f < -SOFT_DEPTH * r:
        # It is let go on until it has come out.
        return -0.5 * f / max(math.sqrt(ux * ux + uy * uy - 2.0 * bound * f), 1e-300)
    if f <= slack and slope < -least:
        return 0.0
    if hall.kind[e, KIND] == RIM:
        room = hall.shape[e, RHO] - r
        square = max(room * room - x * x - y * y, 2.0 * room * slack)
        curve = 2.0 * (fastest * fastest + hall.shape[e, RHO] * bound)
        return safe_step(square, -2.0 * (x * ux + y * uy), curve)
    return safe_step(max(f, slack), slope, bound)


@inlined_kernel
def _swing(hall: Hall, e: int, begin: float, t: float) -> tuple[float, float]:
    """How far a wall that swings has moved along its normal since `begin` beyond its first speed, and how fast."""
    number = hall.kind[e, WALL]
    if hall.rule[number, MOTION] != WAVE:
        return 0.0, 0.0
    rate = speed(hall, number, begin)
    way = displacement(hall, number, begin + t) - displacement(hall, number, begin) - rate * t
    return way, speed(hall, number, begin + t) - rate


@inlined_kernel
def _pull(hall: Hall, e: int, gx: float, gy: float) -> float:
    """A bound on the acceleration of a centre of mass as the wall sees it."""
    number = hall.kind[e, WALL]
    bound = math.sqrt(gx * gx + gy * gy)
    if hall.rule[number, MOTION] == WAVE:
        bound += abs(hall.wall[number, AMPLITUDE]) * hall.wall[number, OMEGA] ** 2
    return bound


@bare_kernel
def _free_way(
    hall: Hall,
    spin: Spin,
    e: int,
    species: int,
    x: float,
    y: float,
    ux: float,
    uy: float,
    angle: float,
    omega: float,
    pull: float,
    fastest: float,
    slack: float,
    least: float,
) -> float:
    """As `_way`, for all discs of a molecule."""
    cos, sin, way = math.cos(angle), math.sin(angle), math.inf
    for k in range(spin.first[species], spin.first[species + 1]):
        arm_x = cos * spin.site[k, SITE_X] - sin * spin.site[k, SITE_Y]
        arm_y = sin * spin.site[k, SITE_X] + cos * spin.site[k, SITE_Y]
        bound = pull + omega * omega * spin.site[k, SITE_ARM]
        vx, vy = ux - omega * arm_y, uy + omega * arm_x
        r = spin.site[k, SITE_RADIUS]
        way = min(way, _way(hall, e, x + arm_x, y + arm_y, vx, vy, r, bound, fastest, slack, least))
        if way == 0.0:
            return 0.0
    return way


@bare_kernel
def touch_body(
    hall: Hall,
    spin: Spin,
    e: int,
    flight: _Flight,
    species: int,
    angle: float,
    omega: float,
    arm: float,
    shift_x: float,
    shift_y: float,
    until: float,
) -> float:
    """When a molecule meets element e; infinity if not until `until`; after many steps, until when it cannot.

    Parameters as for `gasbox.kernels.hall.approach.touch`; angle and angular velocity are those at its reference time,
    `arm` is the distance of its farthest disc from the centre of mass, the radius reaches to the farthest rim.
    """
    x, y, vx, vy, gx, gy, begin = seen_from(hall, e, flight, shift_x, shift_y)
    angle += omega * (begin - flight[4])
    r, limit, pull = flight[5], until - begin, _pull(hall, e, gx, gy)
    slack = _SLACK * (r + abs(x) + abs(y))
    least = GRAZING * (abs(vx) + abs(vy) + abs(omega) * arm)
    # By energy the square of a speed grows by no more than this while the molecule is inside a rim.
    drift = math.sqrt(vx * vx + vy * vy + 4.0 * hall.shape[e, RHO] * pull)
    t = 0.0
    for _ in range(_MARCHES):
        px, py = x + vx * t + 0.5 * gx * t * t, y + vy * t + 0.5 * gy * t * t
        way, rate = _swing(hall, e, begin, t)
        px, py = px - hall.shape[e, NX] * way, py - hall.shape[e, NY] * way
        ux, uy = vx + gx * t - hall.shape[e, NX] * rate, vy + gy * t - hall.shape[e, NY] * rate
        if _gap(hall, e, px, py, r)[0] > _NEAR * r:
            way = _way(hall, e, px, py, ux, uy, r, pull, drift, slack, least)
        else:
            fastest = drift + abs(omega) * arm
            way = _free_way(
                hall, spin, e, species, px, py, ux, uy, angle + omega * t, omega, pull, fastest, slack, least
            )
        if way == 0.0:
            break
        t += way
        if way == math.inf or t > limit:
            return math.inf
    return begin + t


@bare_kernel
def site_at(
    hall: Hall,
    spin: Spin,
    e: int,
    flight: _Flight,
    species: int,
    angle: float,
    omega: float,
    arm: float,
    shift_x: float,
    shift_y: float,
) -> tuple[float, float, float, float, int]:
    """Of the discs that touch element e and approach, the one that is deepest in it; parameters as for `touch_body`.

    Returns
    -------
    Distance of its rim (infinity if there is none), the normal, its approaching speed along it, and its number.
    """
    x, y, vx, vy, _, _, _ = seen_from(hall, e, flight, shift_x, shift_y)
    least = GRAZING * (abs(vx) + abs(vy) + abs(omega) * arm)
    soft = hall.rule[hall.kind[e, WALL], SOFT]
    cos, sin = math.cos(angle), math.sin(angle)
    best = (math.inf, 0.0, 0.0, 0.0, 0)
    for k in range(spin.first[species], spin.first[species + 1]):
        arm_x = cos * spin.site[k, SITE_X] - sin * spin.site[k, SITE_Y]
        arm_y = sin * spin.site[k, SITE_X] + cos * spin.site[k, SITE_Y]
        r = spin.site[k, SITE_RADIUS]
        f, nx, ny = _gap(hall, e, x + arm_x, y + arm_y, r)
        slope = (vx - omega * arm_y) * nx + (vy + omega * arm_x) * ny
        sunk = soft and f < -SOFT_DEPTH * r
        if f <= _CLOSE * flight[5] and f < best[0] and slope < -least and not sunk:
            best = (f, nx, ny, slope, k)
    return best
