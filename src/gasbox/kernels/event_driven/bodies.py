"""When two rigid molecules in flight meet.

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
from gasbox.kernels.event_driven.flight import meeting_time
from gasbox.kernels.event_driven.tables import LABEL, RADIUS, SPECIES, T0
from gasbox.kernels.hall.roots import safe_step
from gasbox.kernels.molecules.spin import (
    ANGLE,
    ARM,
    GRAZING,
    SITE_ARM,
    SITE_RADIUS,
    SITE_X,
    SITE_Y,
    TURNING,
    Spin,
    is_disc,
)

__all__ = ["fastest", "meeting"]

_MARCHES = 200
"""Most steps of a march. Whoever has not met by then looks again: an event at which nothing happens."""
_SLACK = 2.0**-50
"""Of the lengths involved: so near is touching."""


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
    slack = _SLACK * (sigma + abs(dx) + abs(dy))
    limit = fastest(spin, i, j, dvx, dvy)
    for _ in range(_MARCHES):
        if start + t > latest:
            return math.inf
        angle_i, angle_j = begin_i + turn[i, TURNING] * t, begin_j + turn[j, TURNING] * t
        x, y = dx + dvx * t, dy + dvy * t
        way = _free_way(
            spin,
            i,
            j,
            link[i, SPECIES],
            link[j, SPECIES],
            flight[j, RADIUS],
            angle_i,
            angle_j,
            x,
            y,
            dvx,
            dvy,
            slack,
            limit,
        )
        if way == 0.0:
            break
        t += way
        if way == math.inf or t > end:
            return math.inf
    return start + t


@inlined_kernel
def fastest(spin: Spin, i: int, j: int, dvx: float, dvy: float) -> float:
    """A speed that no two discs of molecules i and j exceed relative to each other."""
    turn = spin.turn
    swing = abs(turn[i, TURNING]) * turn[i, ARM] + abs(turn[j, TURNING]) * turn[j, ARM]
    return abs(dvx) + abs(dvy) + swing


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
    radius: float,
    angle_i: float,
    angle_j: float,
    dx: float,
    dy: float,
    dvx: float,
    dvy: float,
    slack: float,
    limit: float,
) -> float:
    """How long molecules i and j of kinds a and b cannot come to touch; 0 if they touch and approach.

    radius : of the bounding circle of j
    limit : a speed that no two discs exceed relative to each other

    Discs so far away that even at that speed they could not meet in the time found so far are passed over.
    """
    site, omega_i, omega_j = spin.site, spin.turn[i, TURNING], spin.turn[j, TURNING]
    cos_i, sin_i = math.cos(angle_i), math.sin(angle_i)
    cos_j, sin_j = math.cos(angle_j), math.sin(angle_j)
    least, way = GRAZING * limit, math.inf
    for k in range(spin.first[a], spin.first[a + 1]):
        arm_x = cos_i * site[k, SITE_X] - sin_i * site[k, SITE_Y]
        arm_y = sin_i * site[k, SITE_X] + cos_i * site[k, SITE_Y]
        near_x, near_y = dx + arm_x, dy + arm_y
        far = site[k, SITE_RADIUS] + radius + limit * way
        if near_x * near_x + near_y * near_y > far * far:
            continue
        near_vx, near_vy = dvx - omega_i * arm_y, dvy + omega_i * arm_x
        bend = omega_i * omega_i * site[k, SITE_ARM]
        for other in range(spin.first[b], spin.first[b + 1]):
            arm_x = cos_j * site[other, SITE_X] - sin_j * site[other, SITE_Y]
            arm_y = sin_j * site[other, SITE_X] + cos_j * site[other, SITE_Y]
            x, y = near_x - arm_x, near_y - arm_y
            reach = site[k, SITE_RADIUS] + site[other, SITE_RADIUS]
            far = reach + limit * way
            if x * x + y * y > far * far:
                continue
            d = math.sqrt(x * x + y * y)
            f = d - reach
            slope = (x * (near_vx + omega_j * arm_y) + y * (near_vy - omega_j * arm_x)) / d
            if f <= slack and slope < -least:
                return 0.0
            bound = bend + omega_j * omega_j * site[other, SITE_ARM]
            way = min(way, safe_step(max(f, slack), slope, bound))
    return way
