"""Walls and obstacles that stand still while discs are placed or pushed apart.

Symbols: x y centre, r radius, d distance, e barrier, c cell.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel

__all__ = ["Barriers", "deepest", "depth_at", "is_clear", "moved"]

_ROUNDS = 32
"""So often a disc is pushed out of the wall in which it is deepest."""
_OVERSHOOT = 1e-7
"""Of the radius, beyond touching, so that two walls that push a disc to and fro come to an end."""
_MOST_STEPS = 64
_ACROSS = 0.9
"""Of the radius: a step less than that, from a place clear of walls, has not gone through one."""


class Barriers(NamedTuple):
    """What keeps centres away, with its periodic images; sides of a rectangle are bounds of the centres instead.

    Attributes
    ----------
    shape : (k, 6) float64 [length]: both ends of a line (of a post: twice its centre), its radius, and by how many
        radii of a disc centres keep away (1, or 0 for an open wall)
    rim : (4,) float64 [length]: centre and radius of a circle around everything, and as above; radius 0 for none
    edge : (e, 4) float64 [length]: ends of the sides of polygons, all counter-clockwise
    outer : how many of these, the first ones, are of the container
    size : (2,) float64 [length], of the box that the cells divide
    cells : (2,) int64, columns and rows
    first, near : barriers near cell c are near[first[c]:first[c + 1]]
    free : (cells,) bool, whether the whole cell is clear of everything
    periodic : (2,) bool
    slack : overlap [length] that is rounding
    """

    shape: NDArray[np.float64]
    rim: NDArray[np.float64]
    edge: NDArray[np.float64]
    outer: int
    size: NDArray[np.float64]
    cells: NDArray[np.int64]
    first: NDArray[np.int64]
    near: NDArray[np.int64]
    free: NDArray[np.bool_]
    periodic: NDArray[np.bool_]
    slack: float


@kernel
def _cell(walls: Barriers, x: float, y: float) -> int:
    column = min(max(math.floor(x / walls.size[0] * walls.cells[0]), 0), walls.cells[0] - 1)
    row = min(max(math.floor(y / walls.size[1] * walls.cells[1]), 0), walls.cells[1] - 1)
    return int(row * walls.cells[0] + column)


@kernel
def _away(walls: Barriers, e: int, x: float, y: float) -> tuple[float, float, float]:
    """Distance [length] of a point from the line or centre of barrier e, and the unit vector from there to it."""
    ax, ay = walls.shape[e, 0], walls.shape[e, 1]
    tx, ty = walls.shape[e, 2] - ax, walls.shape[e, 3] - ay
    square = tx * tx + ty * ty
    dx, dy = x - ax, y - ay
    if square > 0.0:
        along = min(max((dx * tx + dy * ty) / square, 0.0), 1.0)
        dx, dy = dx - along * tx, dy - along * ty
    d = math.sqrt(dx * dx + dy * dy)
    if d > 0.0:
        return d, dx / d, dy / d
    return 0.0, 1.0, 0.0


@kernel
def depth_at(walls: Barriers, x: float, y: float, r: float) -> tuple[float, float, float]:
    """Depth [length] of a disc in the wall in which it is deepest (0 if it is clear), and which way it gets out."""
    depth, nx, ny = 0.0, 0.0, 0.0
    c = _cell(walls, x, y)
    for number in range(walls.first[c], walls.first[c + 1]):
        e = walls.near[number]
        needed = walls.shape[e, 4] + walls.shape[e, 5] * r
        if needed > 0.0:
            d, ux, uy = _away(walls, e, x, y)
            if needed - d > depth:
                depth, nx, ny = needed - d, ux, uy
    if walls.rim[2] > 0.0:
        dx, dy = x - walls.rim[0], y - walls.rim[1]
        d = math.sqrt(dx * dx + dy * dy)
        out = d - (walls.rim[2] - walls.rim[3] * r)
        if out > depth and d > 0.0:
            depth, nx, ny = out, -dx / d, -dy / d
    return depth, nx, ny


@kernel
def deepest(
    walls: Barriers,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    touching: float,
    rounding: float,
) -> tuple[int, float]:
    """The disc that is deepest in a barrier or beyond the rim.

    Parameters
    ----------
    position : (n, 2) float64 [length]
    radius : (n,) float64 [length]
    touching, rounding : a depth up to `touching` radii and this length more is none

    Returns
    -------
    Its index (-1 if all are clear), and the depth [length].
    """
    first, worst = -1, 0.0
    for i in range(position.shape[0]):
        depth, _, _ = depth_at(walls, position[i, 0], position[i, 1], radius[i])
        if depth > worst and depth > touching * radius[i] + rounding:
            first, worst = i, depth
    return first, worst


@kernel
def _turns(walls: Barriers, x: float, y: float, begin: int, end: int) -> int:
    """How often these edges go around a point."""
    turns = 0
    for e in range(begin, end):
        ax, ay, bx, by = walls.edge[e, 0], walls.edge[e, 1], walls.edge[e, 2], walls.edge[e, 3]
        if (ay <= y) != (by <= y):
            left = (bx - ax) * (y - ay) - (x - ax) * (by - ay)
            if ay <= y and left > 0.0:
                turns += 1
            elif ay > y and left < 0.0:
                turns -= 1
    return turns


@kernel
def is_clear(walls: Barriers, x: float, y: float, r: float) -> bool:
    """Whether a disc of radius `r` at (x, y) lies inside the container and overlaps nothing; touching is clear."""
    c = _cell(walls, x, y)
    if walls.free[c] and walls.rim[2] == 0.0:
        return True
    depth, _, _ = depth_at(walls, x, y, r)
    if depth > walls.slack:
        return False
    if walls.free[c]:
        return True
    edges = walls.edge.shape[0]
    return (walls.outer == 0 or _turns(walls, x, y, 0, walls.outer) > 0) and _turns(
        walls, x, y, walls.outer, edges
    ) == 0


@kernel
def _crosses_open(walls: Barriers, ax: float, ay: float, bx: float, by: float) -> bool:
    """Whether a way of a centre leads across an open wall."""
    c = _cell(walls, bx, by)
    for number in range(walls.first[c], walls.first[c + 1]):
        e = walls.near[number]
        if walls.shape[e, 5] > 0.0:
            continue
        px, py = walls.shape[e, 0], walls.shape[e, 1]
        tx, ty = walls.shape[e, 2] - px, walls.shape[e, 3] - py
        before, after = tx * (ay - py) - ty * (ax - px), tx * (by - py) - ty * (bx - px)
        if before * after > 0.0:
            continue
        one = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
        other = (bx - ax) * (py + ty - ay) - (by - ay) * (px + tx - ax)
        if one * other <= 0.0:
            return True
    return False


@kernel
def _settled(
    walls: Barriers,
    x: float,
    y: float,
    r: float,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> tuple[float, float, bool]:
    """The place clear of all walls to which a disc at (x, y) is pushed, within `low` and `high` (2,) [length].

    Returns
    -------
    The place, and whether it was found.
    """
    for _ in range(_ROUNDS):
        x, y = min(max(x, low[0]), high[0]), min(max(y, low[1]), high[1])
        depth, nx, ny = depth_at(walls, x, y, r)
        if depth <= walls.slack:
            return x, y, True
        x += nx * (depth + _OVERSHOOT * r)
        y += ny * (depth + _OVERSHOOT * r)
    return x, y, False


@kernel
def moved(
    walls: Barriers,
    x: float,
    y: float,
    dx: float,
    dy: float,
    r: float,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> tuple[float, float]:
    """Where a disc of radius `r` at (x, y) comes to lie that is moved by (dx, dy) and slides along walls.

    It goes in steps too short to get through a wall, and stays where the next one finds no place.

    Parameters
    ----------
    low, high : (2,) float64 [length], bounds of the centre; where they are a whole period, it goes round
    """
    way = math.sqrt(dx * dx + dy * dy)
    steps = int(min(2.0 * way / r, 1e6)) + 1
    dx, dy = dx / steps, dy / steps
    around_x = walls.periodic[0] and low[0] == 0.0 and high[0] == walls.size[0]
    around_y = walls.periodic[1] and low[1] == 0.0 and high[1] == walls.size[1]
    for _ in range(min(steps, _MOST_STEPS)):
        turn_x = math.floor((x + dx) / walls.size[0]) * walls.size[0] if around_x else 0.0
        turn_y = math.floor((y + dy) / walls.size[1]) * walls.size[1] if around_y else 0.0
        ax, ay = x - turn_x, y - turn_y
        bx, by, found = _settled(walls, ax + dx, ay + dy, r, low, high)
        if not found or (bx - ax) ** 2 + (by - ay) ** 2 > (_ACROSS * r) ** 2:
            break
        if _crosses_open(walls, ax, ay, bx, by):
            break
        x, y = bx, by
    return x, y
