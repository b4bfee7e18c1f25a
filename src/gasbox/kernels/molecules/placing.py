"""Places molecules without overlap: insertion at random places and angles, and shaking in which small ones grow.

Random numbers come in as arrays, so that the same ones give the same bits with and without the JIT. A particle may
stand there smaller than it is, all its lengths by one factor, its scale.

Symbols: i particle, k disc of a particle, x y place.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.barriers import Barriers, is_clear
from gasbox.kernels.size_grid import SizeGrid, overlaps_any, put, take

__all__ = ["Bodies", "enter", "enter_bodies", "insert_bodies", "lay_out", "leave", "shake_bodies"]


class Bodies(NamedTuple):
    """Particles made of discs. Those of particle i are first[i] to first[i + 1].

    Attributes
    ----------
    first : (n + 1,) int64
    place : (m, 2) float64 [length], of each disc seen from the centre of mass, not turned
    full : (m,) float64 [length], radius of each disc; 0 for what only keeps off walls
    reach : (m,) float64 [length], how far from walls its centre stays
    low, high : (m, 2) float64 [length], bounds of its centre; the whole period where it goes round
    position : (n, 2) float64 [length], centres of mass
    angle : (n,) float64 [rad]
    scale : (n,) float64
    disc : (m, 2) float64 [length], where each disc is, inside the box
    radius : (m,) float64 [length], radius of each disc times the scale
    """

    first: NDArray[np.int64]
    place: NDArray[np.float64]
    full: NDArray[np.float64]
    reach: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    position: NDArray[np.float64]
    angle: NDArray[np.float64]
    scale: NDArray[np.float64]
    disc: NDArray[np.float64]
    radius: NDArray[np.float64]


@kernel
def lay_out(bodies: Bodies, grid: SizeGrid, i: int, x: float, y: float, angle: float, scale: float) -> bool:
    """Put the discs of a particle where they would be; False if one is beyond its bounds."""
    cos, sin = scale * math.cos(angle), scale * math.sin(angle)
    inside = True
    for k in range(bodies.first[i], bodies.first[i + 1]):
        along, across = bodies.place[k, 0], bodies.place[k, 1]
        bodies.radius[k] = scale * bodies.full[k]
        for axis in range(2):
            there = x + cos * along - sin * across if axis == 0 else y + sin * along + cos * across
            low, high = bodies.low[k, axis], bodies.high[k, axis]
            # Who reaches the whole of a period goes round it.
            if grid.periodic[axis] and low == 0.0 and high == grid.size[axis]:
                there -= math.floor(there / grid.size[axis]) * grid.size[axis]
            else:
                shrunk = (1.0 - scale) * bodies.reach[k]
                inside &= low - shrunk <= there <= high + shrunk
            bodies.disc[k, axis] = there
    return inside


@kernel
def _is_free(bodies: Bodies, grid: SizeGrid, walls: Barriers | None, i: int, scale: float) -> bool:
    """Whether the discs of a particle that is not in the grid overlap nothing where they are."""
    for k in range(bodies.first[i], bodies.first[i + 1]):
        x, y = bodies.disc[k, 0], bodies.disc[k, 1]
        if walls is not None and not is_clear(walls, x, y, scale * bodies.reach[k]):
            return False
        if bodies.full[k] > 0.0 and overlaps_any(
            grid, bodies.disc, bodies.radius, -1, x, y, bodies.radius[k]
        ):
            return False
    return True


@kernel
def enter(bodies: Bodies, grid: SizeGrid, i: int) -> None:
    """Enter the discs of a particle into the grid."""
    for k in range(bodies.first[i], bodies.first[i + 1]):
        if bodies.full[k] > 0.0:
            put(grid, k, bodies.disc[k, 0], bodies.disc[k, 1])


@kernel
def leave(bodies: Bodies, grid: SizeGrid, i: int) -> None:
    """Take the discs of a particle out of the grid."""
    for k in range(bodies.first[i], bodies.first[i + 1]):
        if bodies.full[k] > 0.0:
            take(grid, k, bodies.disc[k, 0], bodies.disc[k, 1])


@kernel
def enter_bodies(bodies: Bodies, grid: SizeGrid, order: NDArray[np.int64]) -> None:
    """Enter the particles of `order` (m,), which have their places, into the grid, whatever they overlap."""
    for i in order:
        x, y = bodies.position[i, 0], bodies.position[i, 1]
        lay_out(bodies, grid, i, x, y, bodies.angle[i], bodies.scale[i])
        enter(bodies, grid, i)


@kernel
def insert_bodies(
    bodies: Bodies,
    grid: SizeGrid,
    walls: Barriers | None,
    order: NDArray[np.int64],
    scale: float,
    drawn: NDArray[np.float64],
) -> int:
    """Random sequential insertion: each particle of `order` in turn tries places until one is free.

    Parameters
    ----------
    grid : holds the discs of all that are in place already; the new ones are entered
    order : (m,) int64, which particles, in this order
    scale : with which they are inserted
    drawn : (tries, 3) float64: x and y [length], and angle [rad]

    Returns
    -------
    Number of particles placed.
    """
    placed = 0
    for attempt in range(drawn.shape[0]):
        if placed == order.shape[0]:
            break
        i = order[placed]
        x, y, angle = drawn[attempt, 0], drawn[attempt, 1], drawn[attempt, 2]
        if lay_out(bodies, grid, i, x, y, angle, scale) and _is_free(bodies, grid, walls, i, scale):
            bodies.position[i, 0], bodies.position[i, 1] = x, y
            bodies.angle[i], bodies.scale[i] = angle, scale
            enter(bodies, grid, i)
            placed += 1
    return placed


@kernel
def _try(
    bodies: Bodies,
    grid: SizeGrid,
    walls: Barriers | None,
    i: int,
    x: float,
    y: float,
    angle: float,
    scale: float,
) -> bool:
    """Give a particle that is not in the grid another place, angle and scale if that is free."""
    if not (lay_out(bodies, grid, i, x, y, angle, scale) and _is_free(bodies, grid, walls, i, scale)):
        return False
    bodies.position[i, 0], bodies.position[i, 1] = x, y
    bodies.angle[i], bodies.scale[i] = angle, scale
    return True


@kernel
def shake_bodies(
    bodies: Bodies,
    grid: SizeGrid,
    walls: Barriers | None,
    order: NDArray[np.int64],
    step: NDArray[np.float64],
    turn: NDArray[np.float64],
    growth: float,
    uniform: NDArray[np.float64],
) -> tuple[int, int]:
    """One Monte-Carlo sweep: each particle of `order` tries a small move, and to grow if it is too small.

    Parameters
    ----------
    step, turn : (n,) float64, longest move along each axis [length] and largest turn [rad] of each particle
    growth : largest growth of the scale, as a share of it
    uniform : (m, 3) float64 in [0, 1), one row for each particle of `order`

    Returns
    -------
    Number of moves made, and number of particles that are not full-grown.
    """
    moves, small = 0, 0
    for number in range(order.shape[0]):
        i = order[number]
        leave(bodies, grid, i)
        x = bodies.position[i, 0] + step[i] * (2.0 * uniform[number, 0] - 1.0)
        y = bodies.position[i, 1] + step[i] * (2.0 * uniform[number, 1] - 1.0)
        angle = bodies.angle[i] + turn[i] * (2.0 * uniform[number, 2] - 1.0)
        if _try(bodies, grid, walls, i, x, y, angle, bodies.scale[i]):
            moves += 1
        x, y, angle = bodies.position[i, 0], bodies.position[i, 1], bodies.angle[i]
        if bodies.scale[i] < 1.0:
            _try(bodies, grid, walls, i, x, y, angle, min(1.0, bodies.scale[i] * (1.0 + growth)))
            if bodies.scale[i] < 1.0:
                small += 1
        lay_out(bodies, grid, i, x, y, angle, bodies.scale[i])
        enter(bodies, grid, i)
    return moves, small
