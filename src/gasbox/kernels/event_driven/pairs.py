"""Two discs in flight: how they stand to each other, and which of two meetings comes first."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.bodies import meeting
from gasbox.kernels.event_driven.queue import pair_before
from gasbox.kernels.event_driven.tables import PARTNER, RADIUS, STALE, T0, T_EVENT, VX, VY, WALL, X, Y
from gasbox.kernels.hall import Hall
from gasbox.kernels.molecules.spin import Spin

__all__ = ["HEAD_ON", "LATEST", "TIED", "apart", "may_meet", "over_images", "precedes", "preferred"]

HEAD_ON = -2.0000000001
"""Discs cannot meet before c/(-2 b), even head-on; with a margin for rounding."""
LATEST = 1e300
"""In place of no time at all, where it is multiplied by what may be zero."""
TIED = 1.0 + 4.0 / 2**53
"""A meeting later than another one by less than this factor may come to the same floating-point time."""


@inlined_kernel
def precedes(
    flight: NDArray[np.float64], link: NDArray[np.int32], time: float, i: int, j: int, k: int
) -> bool:
    """Whether a meeting of i and j at `time` comes before the event that particle k holds."""
    held = flight[k, T_EVENT]
    if time != held:
        return time < held
    partner = link[k, PARTNER]
    if partner >= 0:
        return pair_before(link, i, j, k, partner)
    return partner != STALE


@inlined_kernel
def preferred(link: NDArray[np.int32], time: float, i: int, j: int, best: float, who: int) -> bool:
    """Whether the meeting of i and j comes before what was found for i so far."""
    if time != best:
        return time < best
    if who >= 0:
        return pair_before(link, i, j, i, who)
    return who <= WALL


@inlined_kernel
def _unfolded_in_fall(
    own: tuple[float, float, float, float, float, float],
    flight: NDArray[np.float64],
    hall: Hall,
    j: int,
    start: float,
) -> tuple[float, float, float, float, float, float]:
    """As `_unfolded`, under gravity: both fall, and seen from each other fly straight."""
    x, y, vx, vy, t_i, radius = own
    own_time, other_time = start - t_i, start - flight[j, T0]
    dvx = (vx + hall.gx * own_time) - (flight[j, VX] + hall.gx * other_time)
    dvy = (vy + hall.gy * own_time) - (flight[j, VY] + hall.gy * other_time)
    half, other_half = 0.5 * own_time * own_time, 0.5 * other_time * other_time
    dx = (x + vx * own_time + hall.gx * half) - (
        flight[j, X] + flight[j, VX] * other_time + hall.gx * other_half
    )
    dy = (y + vy * own_time + hall.gy * half) - (
        flight[j, Y] + flight[j, VY] * other_time + hall.gy * other_half
    )
    return dx, dy, dvx, dvy, radius + flight[j, RADIUS], start


@inlined_kernel
def _unfolded(
    own: tuple[float, float, float, float, float, float],
    flight: NDArray[np.float64],
    hall: Hall | None,
    j: int,
) -> tuple[float, float, float, float, float, float]:
    x, y, vx, vy, t_i, radius = own
    t_j = flight[j, T0]
    start = max(t_i, t_j)
    if hall is not None:
        return _unfolded_in_fall(own, flight, hall, j, start)
    dvx, dvy = vx - flight[j, VX], vy - flight[j, VY]
    dx = (x + vx * (start - t_i)) - (flight[j, X] + flight[j, VX] * (start - t_j))
    dy = (y + vy * (start - t_i)) - (flight[j, Y] + flight[j, VY] * (start - t_j))
    return dx, dy, dvx, dvy, radius + flight[j, RADIUS], start


@inlined_kernel
def apart(
    own: tuple[float, float, float, float, float, float],
    flight: NDArray[np.float64],
    hall: Hall | None,
    j: int,
    now: float,
    box: Box,
    across: float,
    along: float,
) -> tuple[float, float, float, float, float, float]:
    """A disc and disc j at their later reference time.

    own : position, velocity, reference time and radius of the disc
    across, along : 1/width and 1/height [1/length], 0 where the box is not periodic

    Returns: difference of the centres (nearest image at `now`), of the velocities, sum of the radii, and this time.
    """
    dx, dy, dvx, dvy, sigma, start = _unfolded(own, flight, hall, j)
    dx -= np.rint((dx + dvx * (now - start)) * across) * box.width
    dy -= np.rint((dy + dvy * (now - start)) * along) * box.height
    return dx, dy, dvx, dvy, sigma, start


@inlined_kernel
def may_meet(spin: Spin | None, b: float, c: float, start: float, latest: float) -> bool:
    """Whether two particles might meet by `latest`: not if even head-on they could not before c/(-2 b).

    Molecules may also do so while their bounding circles overlap.
    """
    if spin is None:
        return not (b >= 0.0 or c > (TIED * latest - start) * HEAD_ON * b)
    return c <= 0.0 or not (b >= 0.0 or c > (TIED * latest - start) * HEAD_ON * b)


@bare_kernel
def over_images(
    own: tuple[float, float, float, float, float, float],
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    hall: Hall | None,
    spin: Spin | None,
    i: int,
    j: int,
    now: float,
    box: Box,
    across: float,
    along: float,
    images: tuple[int, int],
) -> float:
    """Earliest meeting over the images around the nearest one, in a box of few cells; arguments as for `apart`.

    The whole shift to an image is made in one step: made in two it would round by what is the nearest at `now`.
    """
    best = math.inf
    images_x, images_y = images
    dx, dy, dvx, dvy, sigma, start = _unfolded(own, flight, hall, j)
    column = np.rint((dx + dvx * (now - start)) * across)
    row = np.rint((dy + dvy * (now - start)) * along)
    for image_y in range(-images_y, images_y + 1):
        for image_x in range(-images_x, images_x + 1):
            x, y = dx - (column + image_x) * box.width, dy - (row + image_y) * box.height
            best = min(best, meeting(spin, flight, link, i, j, x, y, dvx, dvy, sigma, start, best))
    return best
