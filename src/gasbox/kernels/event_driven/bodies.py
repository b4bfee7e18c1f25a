"""When two rigid molecules in flight meet, and what their collision does.

Their bounding circles say when they are near each other. From there the way is marched: the distance of two discs of
them, d, cannot curve down faster than M = w₁² a₁ + w₂² a₂, with w the angular velocities and a the distances of the
discs from the centres of mass, since these fly straight as seen from each other. So up to the zero of
d + d' t - M t²/2 - sigma nothing can have happened, and near a contact the steps are those of Newton's method.

Symbols: x, y, u relative place and velocity of two discs, dx, dy, dvx, dvy those of the centres of mass, f distance of
two discs less the sum of their radii, n unit normal from the second to the first, k number of a disc.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.flight import meeting_time
from gasbox.kernels.event_driven.tables import LABEL, RADIUS, SPECIES, T0, VX, VY, Tables, X, Y
from gasbox.kernels.hall.roots import safe_step
from gasbox.kernels.molecules.impulse import blow, closing_speed, lever, yielding
from gasbox.kernels.molecules.spin import (
    ANGLE,
    ARM,
    GRAZING,
    INERTIA,
    SITE_ARM,
    SITE_RADIUS,
    SITE_X,
    SITE_Y,
    TURNING,
    Spin,
    is_disc,
)

__all__ = ["CLOSE", "MARCHES", "SLACK", "knock", "meeting"]

MARCHES = 200
"""Most steps of a march. Whoever has not met by then looks again: an event at which nothing happens."""
SLACK = 2.0**-50
"""Of the lengths involved: so near is touching."""
CLOSE = 1e-10
"""Of the reach of two molecules: so near are discs that an event says are touching, by all rounding."""


@inlined_kernel
def meeting(
    spin: Spin | None,
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    i: int,
    j: int,
    dx: float,
    dy: float,
    dvx: float,
    dvy: float,
    sigma: float,
    start: float,
    latest: float,
) -> float:
    """Time at which particles i and j touch while approaching, infinity if never, or not until `latest`.

    Parameters as for `meeting_time`; `sigma` is the sum of the radii of their bounding circles.
    """
    if spin is None:
        return meeting_time(dx, dy, dvx, dvy, sigma, start)
    return _bodies_meet(spin, flight, link, i, j, dx, dy, dvx, dvy, sigma, start, latest)


@bare_kernel
def _bodies_meet(
    spin: Spin,
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    i: int,
    j: int,
    dx: float,
    dy: float,
    dvx: float,
    dvy: float,
    sigma: float,
    start: float,
    latest: float,
) -> float:
    """As `meeting`; after many steps the time up to which they cannot meet."""
    if i == j:
        return math.inf
    if is_disc(spin, link[i, SPECIES]) and is_disc(spin, link[j, SPECIES]):
        return meeting_time(dx, dy, dvx, dvy, sigma, start)
    if link[j, LABEL] < link[i, LABEL]:
        # The same operations whoever asks, so the same bits.
        i, j, dx, dy, dvx, dvy = j, i, -dx, -dy, -dvx, -dvy
    t, end = _circles_overlap(dx, dy, dvx, dvy, sigma)
    if t == math.inf:
        return math.inf
    turn = spin.turn
    begin_i = turn[i, ANGLE] + turn[i, TURNING] * (start - flight[i, T0])
    begin_j = turn[j, ANGLE] + turn[j, TURNING] * (start - flight[j, T0])
    slack = SLACK * (sigma + abs(dx) + abs(dy))
    least = _least(spin, i, j, dvx, dvy)
    for _ in range(MARCHES):
        if start + t > latest:
            return math.inf
        angle_i, angle_j = begin_i + turn[i, TURNING] * t, begin_j + turn[j, TURNING] * t
        x, y = dx + dvx * t, dy + dvy * t
        way = _free_way(
            spin, i, j, link[i, SPECIES], link[j, SPECIES], angle_i, angle_j, x, y, dvx, dvy, slack, least
        )
        if way == 0.0:
            break
        t += way
        if way == math.inf or t > end:
            return math.inf
    return start + t


@inlined_kernel
def _least(spin: Spin, i: int, j: int, dvx: float, dvy: float) -> float:
    """The least speed that counts as an approach."""
    turn = spin.turn
    swing = abs(turn[i, TURNING]) * turn[i, ARM] + abs(turn[j, TURNING]) * turn[j, ARM]
    return GRAZING * (abs(dvx) + abs(dvy) + swing)


@inlined_kernel
def _circles_overlap(dx: float, dy: float, dvx: float, dvy: float, sigma: float) -> tuple[float, float]:
    """From when to when two circles overlap; infinity if never."""
    b = dx * dvx + dy * dvy
    speed2 = dvx * dvx + dvy * dvy
    c = dx * dx + dy * dy - sigma * sigma
    cross = dx * dvy - dy * dvx
    inside = sigma * sigma * speed2 - cross * cross
    begin, end = 0.0, math.inf
    if c > 0.0:
        if b >= 0.0 or inside <= 0.0:
            return math.inf, math.inf
        begin = c / (math.sqrt(inside) - b)
    if speed2 > 0.0:
        end = (math.sqrt(max(inside, 0.0)) - b) / speed2 * (1.0 + 1e-12)
    return begin, end


@bare_kernel
def _free_way(
    spin: Spin,
    i: int,
    j: int,
    a: int,
    b: int,
    angle_i: float,
    angle_j: float,
    dx: float,
    dy: float,
    dvx: float,
    dvy: float,
    slack: float,
    least: float,
) -> float:
    """How long molecules i and j of kinds a and b cannot come to touch; 0 if they touch and approach."""
    site, omega_i, omega_j = spin.site, spin.turn[i, TURNING], spin.turn[j, TURNING]
    cos_i, sin_i = math.cos(angle_i), math.sin(angle_i)
    cos_j, sin_j = math.cos(angle_j), math.sin(angle_j)
    way = math.inf
    for k in range(spin.first[a], spin.first[a + 1]):
        arm_x = cos_i * site[k, SITE_X] - sin_i * site[k, SITE_Y]
        arm_y = sin_i * site[k, SITE_X] + cos_i * site[k, SITE_Y]
        near_x, near_y = dx + arm_x, dy + arm_y
        near_vx, near_vy = dvx - omega_i * arm_y, dvy + omega_i * arm_x
        bend = omega_i * omega_i * site[k, SITE_ARM]
        for other in range(spin.first[b], spin.first[b + 1]):
            arm_x = cos_j * site[other, SITE_X] - sin_j * site[other, SITE_Y]
            arm_y = sin_j * site[other, SITE_X] + cos_j * site[other, SITE_Y]
            x, y = near_x - arm_x, near_y - arm_y
            d = math.sqrt(x * x + y * y)
            f = d - (site[k, SITE_RADIUS] + site[other, SITE_RADIUS])
            slope = (x * (near_vx + omega_j * arm_y) + y * (near_vy - omega_j * arm_x)) / d
            if f <= slack and slope < -least:
                return 0.0
            way = min(way, safe_step(max(f, slack), slope, bend + omega_j * omega_j * site[other, SITE_ARM]))
    return way


@bare_kernel
def _contact(
    spin: Spin,
    i: int,
    j: int,
    a: int,
    b: int,
    dx: float,
    dy: float,
    dvx: float,
    dvy: float,
    close: float,
    least: float,
) -> tuple[float, float, float, float, float]:
    """Of the discs that touch and approach, the two that are deepest in one another; as `_free_way` reckons them.

    Returns
    -------
    f (infinity if there are none), the normal, and the levers of the two molecules.
    """
    site, omega_i, omega_j = spin.site, spin.turn[i, TURNING], spin.turn[j, TURNING]
    cos_i, sin_i = math.cos(spin.turn[i, ANGLE]), math.sin(spin.turn[i, ANGLE])
    cos_j, sin_j = math.cos(spin.turn[j, ANGLE]), math.sin(spin.turn[j, ANGLE])
    best = (math.inf, 0.0, 0.0, 0.0, 0.0)
    for k in range(spin.first[a], spin.first[a + 1]):
        own_x = cos_i * site[k, SITE_X] - sin_i * site[k, SITE_Y]
        own_y = sin_i * site[k, SITE_X] + cos_i * site[k, SITE_Y]
        near_vx, near_vy = dvx - omega_i * own_y, dvy + omega_i * own_x
        for other in range(spin.first[b], spin.first[b + 1]):
            arm_x = cos_j * site[other, SITE_X] - sin_j * site[other, SITE_Y]
            arm_y = sin_j * site[other, SITE_X] + cos_j * site[other, SITE_Y]
            x, y = dx + own_x - arm_x, dy + own_y - arm_y
            d = math.sqrt(x * x + y * y)
            f = d - (site[k, SITE_RADIUS] + site[other, SITE_RADIUS])
            slope = (x * (near_vx + omega_j * arm_y) + y * (near_vy - omega_j * arm_x)) / d
            if f <= close and f < best[0] and slope < -least:
                nx, ny = x / d, y / d
                best = (f, nx, ny, lever(own_x, own_y, nx, ny), lever(arm_x, arm_y, nx, ny))
    return best


@bare_kernel
def knock(tables: Tables, spin: Spin, box: Box, i: int, j: int) -> tuple[float, float, float]:
    """The collision of molecules i and j (label of i below that of j), both at their reference time.

    Returns
    -------
    The impulse given to i, and its product with the vector from the centre of mass of j to that of i; all 0 if no discs
    of theirs touch and approach.
    """
    flight, turn = tables.flight, spin.turn
    a, b = tables.link[i, SPECIES], tables.link[j, SPECIES]
    sigma = flight[i, RADIUS] + flight[j, RADIUS]
    dx, dy = flight[i, X] - flight[j, X], flight[i, Y] - flight[j, Y]
    wide, high = 0, 0
    if box.periodic_x:
        dx -= box.width * np.rint(dx / box.width)
        wide = 1 if 2.0 * sigma >= box.width else 0
    if box.periodic_y:
        dy -= box.height * np.rint(dy / box.height)
        high = 1 if 2.0 * sigma >= box.height else 0
    dvx, dvy = flight[i, VX] - flight[j, VX], flight[i, VY] - flight[j, VY]
    least = _least(spin, i, j, dvx, dvy)
    best, away_x, away_y = (math.inf, 0.0, 0.0, 0.0, 0.0), dx, dy
    for row in range(-high, high + 1):
        for column in range(-wide, wide + 1):
            x, y = dx - column * box.width, dy - row * box.height
            found = _contact(spin, i, j, a, b, x, y, dvx, dvy, CLOSE * sigma, least)
            if found[0] < best[0]:
                best, away_x, away_y = found, x, y
    if best[0] == math.inf:
        return 0.0, 0.0, 0.0
    _, nx, ny, own, arm = best
    mass_i, mass_j = tables.mass[i], tables.mass[j]
    closing = closing_speed(dvx, dvy, nx, ny, turn[i, TURNING], own, turn[j, TURNING], arm)
    impulse = blow(closing, yielding(mass_i, turn[i, INERTIA], own), yielding(mass_j, turn[j, INERTIA], arm))
    jx, jy = impulse * nx, impulse * ny
    _push(tables, spin, i, jx, jy, impulse * own)
    _push(tables, spin, j, -jx, -jy, -impulse * arm)
    return jx, jy, jx * away_x + jy * away_y


@inlined_kernel
def _push(tables: Tables, spin: Spin, i: int, jx: float, jy: float, twist: float) -> None:
    """Change the velocities of molecule i by an impulse and its moment."""
    tables.flight[i, VX] += jx / tables.mass[i]
    tables.flight[i, VY] += jy / tables.mass[i]
    if spin.turn[i, INERTIA] > 0.0:
        spin.turn[i, TURNING] += twist / spin.turn[i, INERTIA]
