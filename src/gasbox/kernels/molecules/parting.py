"""Pushes overlapping molecules apart, each as a rigid body.

Symbols: i particle, k j discs of particles, x y place, r radius, n number of pushes.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.barriers import Barriers, depth_at
from gasbox.kernels.molecules.placing import Bodies, enter, lay_out, leave
from gasbox.kernels.size_grid import SizeGrid, around, first_cell, last_cell, nearest

__all__ = ["push_bodies_apart"]

_NEIGHBOURS = 128
_MOST = 0.5
"""Of its radius: a disc is pushed no farther at once."""


@kernel
def _overlapping(
    grid: SizeGrid,
    disc: NDArray[np.float64],
    radius: NDArray[np.float64],
    owner: NDArray[np.int64],
    k: int,
    found: NDArray[np.int64],
) -> int:
    """Write the discs of other particles that disc `k` overlaps to `found`, as many as fit; return their number."""
    x, y, r = disc[k, 0], disc[k, 1], radius[k]
    count = 0
    for size in range(grid.top.shape[0]):
        reach = r + grid.top[size]
        columns, rows = grid.cells[size, 0], grid.cells[size, 1]
        left = first_cell(x - reach, x + reach, grid.width[size, 0], columns, grid.periodic[0])
        right = last_cell(x - reach, x + reach, grid.width[size, 0], columns, grid.periodic[0])
        bottom = first_cell(y - reach, y + reach, grid.width[size, 1], rows, grid.periodic[1])
        top = last_cell(y - reach, y + reach, grid.width[size, 1], rows, grid.periodic[1])
        for row in range(bottom, top + 1):
            start = grid.offset[size] + around(row, rows) * columns
            for column in range(left, right + 1):
                j = grid.head[start + around(column, columns)]
                while j >= 0:
                    dx = nearest(x - disc[j, 0], grid.size[0], grid.periodic[0])
                    dy = nearest(y - disc[j, 1], grid.size[1], grid.periodic[1])
                    other = owner[j] != owner[k] and count < found.shape[0]
                    if other and dx * dx + dy * dy < (r + radius[j]) ** 2:
                        found[count] = j
                        count += 1
                    j = grid.next[j]
    return count


@kernel
def _lever(bodies: Bodies, i: int, k: int, nx: float, ny: float) -> float:
    """Lever arm [length] of a push along (nx, ny) through the centre of disc `k`, about the centre of mass."""
    cos, sin = math.cos(bodies.angle[i]), math.sin(bodies.angle[i])
    x = cos * bodies.place[k, 0] - sin * bodies.place[k, 1]
    y = sin * bodies.place[k, 0] + cos * bodies.place[k, 1]
    return x * ny - y * nx


@kernel
def _shift(
    bodies: Bodies,
    grid: SizeGrid,
    share: NDArray[np.float64],
    i: int,
    nx: float,
    ny: float,
    push: float,
    lever: float,
) -> None:
    """Move a particle by an impulse of displacement `push` along (nx, ny)."""
    leave(bodies, grid, i)
    bodies.position[i, 0] += push * share[i, 0] * nx
    bodies.position[i, 1] += push * share[i, 0] * ny
    bodies.angle[i] += push * share[i, 1] * lever
    lay_out(bodies, grid, i, bodies.position[i, 0], bodies.position[i, 1], bodies.angle[i], 1.0)
    enter(bodies, grid, i)


@kernel
def _push_from_wall(
    bodies: Bodies,
    grid: SizeGrid,
    share: NDArray[np.float64],
    i: int,
    k: int,
    depth: float,
    nx: float,
    ny: float,
) -> None:
    lever = _lever(bodies, i, k, nx, ny)
    give = share[i, 0] + share[i, 1] * lever * lever
    _shift(bodies, grid, share, i, nx, ny, min(depth, _MOST * bodies.radius[k]) / give, lever)


@kernel
def _out_of_walls(
    bodies: Bodies, grid: SizeGrid, walls: Barriers | None, share: NDArray[np.float64], gap: float, i: int
) -> int:
    """Push a particle out of all walls, one disc after the other; return the number of pushes."""
    n = 0
    for k in range(bodies.first[i], bodies.first[i + 1]):
        more = gap * bodies.radius[k]
        for axis in range(2):
            low, high = bodies.low[k, axis], bodies.high[k, axis]
            if grid.periodic[axis] and low == 0.0 and high == grid.size[axis]:
                continue
            for side in range(2):
                depth = low - bodies.disc[k, axis] if side == 0 else bodies.disc[k, axis] - high
                if depth > 0.0:
                    sign = 1.0 if side == 0 else -1.0
                    nx, ny = (sign, 0.0) if axis == 0 else (0.0, sign)
                    _push_from_wall(bodies, grid, share, i, k, depth + more, nx, ny)
                    n += 1
        if walls is not None:
            depth, nx, ny = depth_at(walls, bodies.disc[k, 0], bodies.disc[k, 1], bodies.reach[k])
            if depth > walls.slack:
                _push_from_wall(bodies, grid, share, i, k, depth + more, nx, ny)
                n += 1
    return n


@kernel
def _push(
    bodies: Bodies,
    grid: SizeGrid,
    owner: NDArray[np.int64],
    share: NDArray[np.float64],
    gap: float,
    k: int,
    j: int,
) -> bool:
    """Push the particles of two discs apart along the line of their centres; False if these are apart already."""
    nx = nearest(bodies.disc[k, 0] - bodies.disc[j, 0], grid.size[0], grid.periodic[0])
    ny = nearest(bodies.disc[k, 1] - bodies.disc[j, 1], grid.size[1], grid.periodic[1])
    distance, touch = math.sqrt(nx * nx + ny * ny), bodies.radius[k] + bodies.radius[j]
    if distance >= touch:
        return False
    if distance < 1e-12 * touch:
        # One place for two: part them in a direction that depends on who they are.
        angle = 2.399963229728653 * (k + j)
        nx, ny, distance = math.cos(angle), math.sin(angle), 0.0
    else:
        nx, ny = nx / distance, ny / distance
    one, other = owner[k], owner[j]
    near, far = _lever(bodies, one, k, nx, ny), _lever(bodies, other, j, nx, ny)
    give = share[one, 0] + share[one, 1] * near * near + share[other, 0] + share[other, 1] * far * far
    way = min(touch * (1.0 + gap) - distance, _MOST * min(bodies.radius[k], bodies.radius[j]))
    _shift(bodies, grid, share, one, nx, ny, way / give, near)
    _shift(bodies, grid, share, other, nx, ny, -way / give, far)
    return True


@kernel
def push_bodies_apart(
    bodies: Bodies,
    grid: SizeGrid,
    walls: Barriers | None,
    owner: NDArray[np.int64],
    share: NDArray[np.float64],
    gap: float,
    sweeps: int,
) -> bool:
    """Push overlapping particles apart and out of walls, in sweeps, until nothing overlaps.

    Each push is an impulse through the centres of two discs, so that it moves and turns both particles as a contact
    would: the centre of mass of a pair stays where it is. The order is that of the rows.

    Parameters
    ----------
    bodies : changed in place; `low` and `high` are the sides of the box
    grid : holds all discs
    walls : what else stands in the way; None for nothing
    owner : (m,) int64, the particle that each disc belongs to
    share : (n, 2) float64, one over the mass and one over the moment of inertia (0 for what does not rotate)
    gap : how far beyond touching they are pushed, as a fraction of the sum of the radii
    sweeps : at most so many

    Returns
    -------
    Whether nothing overlaps.
    """
    found = np.empty(_NEIGHBOURS, np.int64)
    for _ in range(sweeps):
        n = 0
        for i in range(bodies.position.shape[0]):
            n += _out_of_walls(bodies, grid, walls, share, gap, i)
            for k in range(bodies.first[i], bodies.first[i + 1]):
                for number in range(_overlapping(grid, bodies.disc, bodies.radius, owner, k, found)):
                    if _push(bodies, grid, owner, share, gap, k, found[number]):
                        n += 1
        if n == 0:
            return True
    return False
