"""When two discs in free flight meet, and when a disc meets a wall: pure functions of their references."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import inlined_kernel
from gasbox.kernels.event_driven.tables import FASTEST, RADIUS, T0, VX, VY, WALL, X, Y
from gasbox.kernels.hall import Hall

__all__ = ["GRAZING", "meeting_time", "note_speed", "place_at", "velocity_at", "wall_meeting"]

GRAZING = 1e-24
"""A pair whose approach along the line of centres, at contact, is below 1e-12 of its relative speed passes: it would
overlap by less than 1e-24 of a diameter, and rounding could not tell on which side."""


@inlined_kernel
def place_at(flight: NDArray[np.float64], hall: Hall | None, i: int, elapsed: float) -> tuple[float, float]:
    """Where disc `i` is, a time after its reference: on a straight line, or on a parabola under gravity."""
    x = flight[i, X] + flight[i, VX] * elapsed
    y = flight[i, Y] + flight[i, VY] * elapsed
    if hall is None:
        return x, y
    half = 0.5 * elapsed * elapsed
    return x + hall.gx * half, y + hall.gy * half


@inlined_kernel
def velocity_at(
    flight: NDArray[np.float64], hall: Hall | None, i: int, elapsed: float
) -> tuple[float, float]:
    """Velocity of disc `i`, a time after its reference."""
    if hall is None:
        return flight[i, VX], flight[i, VY]
    return flight[i, VX] + hall.gx * elapsed, flight[i, VY] + hall.gy * elapsed


@inlined_kernel
def meeting_time(dx: float, dy: float, dvx: float, dvy: float, sigma: float, start: float) -> float:
    """Time at which two discs touch while approaching, infinity if never.

    Parameters
    ----------
    dx, dy : difference of the centres at time `start` [length]
    dvx, dvy : difference of the velocities [length/time]
    sigma : sum of the radii [length]
    start : the later of the two reference times [time]

    The discriminant is taken from the cross product, whose rounding error grows with the distance only linearly.
    Discs that touch (or overlap by rounding) and approach meet at `start`.

    Source: D. C. Rapaport, The Art of Molecular Dynamics Simulation (2004), section 14.2, doi:10.1017/CBO9780511816581.
    """
    b = dx * dvx + dy * dvy
    if b >= 0.0:
        return math.inf
    speed2 = dvx * dvx + dvy * dvy
    sigma2 = sigma * sigma
    c = dx * dx + dy * dy - sigma2
    if c <= 0.0:
        return math.inf if b * b <= GRAZING * speed2 * sigma2 else start
    cross = dx * dvy - dy * dvx
    discriminant = sigma2 * speed2 - cross * cross
    if discriminant <= GRAZING * speed2 * sigma2:
        return math.inf
    return start + c / (math.sqrt(discriminant) - b)


@inlined_kernel
def wall_meeting(
    flight: NDArray[np.float64], i: int, width: float, height: float, walled_x: bool, walled_y: bool
) -> tuple[float, int]:
    """Time and code (WALL - wall) of the next wall that disc `i` meets in free flight, infinity if none.

    walled_x, walled_y : whether to look at the walls left and right, below and above
    """
    time, code = math.inf, WALL
    r = flight[i, RADIUS]
    if walled_x:
        v = flight[i, VX]
        if v < 0.0:
            time = flight[i, T0] + (r - flight[i, X]) / v
        elif v > 0.0:
            time, code = flight[i, T0] + (width - r - flight[i, X]) / v, WALL - 1
    if walled_y:
        v = flight[i, VY]
        if v < 0.0:
            t = flight[i, T0] + (r - flight[i, Y]) / v
            if t < time:
                time, code = t, WALL - 2
        elif v > 0.0:
            t = flight[i, T0] + (height - r - flight[i, Y]) / v
            if t < time:
                time, code = t, WALL - 3
    return time, code


@inlined_kernel
def note_speed(flight: NDArray[np.float64], number: NDArray[np.float64], i: int) -> None:
    """Keep the speed that no disc exceeds up to date with disc `i`."""
    speed = math.sqrt(flight[i, VX] * flight[i, VX] + flight[i, VY] * flight[i, VY])
    number[FASTEST] = max(number[FASTEST], speed)
