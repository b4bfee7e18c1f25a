"""What the collision of two rigid molecules does.

Symbols: x, y, u relative place and velocity of two discs, dx, dy, dvx, dvy those of the centres of mass, f distance of
two discs less the sum of their radii, n unit normal from the second to the first, k number of a disc.
"""

from __future__ import annotations

import math

import numpy as np

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.bodies import fastest
from gasbox.kernels.event_driven.tables import RADIUS, SPECIES, VX, VY, Tables, X, Y
from gasbox.kernels.molecules.impulse import blow, closing_speed, lever, yielding
from gasbox.kernels.molecules.spin import (
    ANGLE,
    GRAZING,
    INERTIA,
    SITE_RADIUS,
    SITE_X,
    SITE_Y,
    TURNING,
    Spin,
)

__all__ = ["knock"]

_CLOSE = 1e-10
"""Of the reach of two molecules: so near are discs that an event says are touching, by all rounding."""


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
    least = GRAZING * fastest(spin, i, j, dvx, dvy)
    best, away_x, away_y = (math.inf, 0.0, 0.0, 0.0, 0.0), dx, dy
    for row in range(-high, high + 1):
        for column in range(-wide, wide + 1):
            x, y = dx - column * box.width, dy - row * box.height
            found = _contact(spin, i, j, a, b, x, y, dvx, dvy, _CLOSE * sigma, least)
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
