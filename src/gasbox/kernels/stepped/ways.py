"""The straight way of a centre in one step, and the elements of an enclosure that it meets.

A way leads from P, where the step began, to Q, where flight and pushes have brought the centre. A wall that moves is at
one displacement at its begin and at another at its end: the way is looked at in the frame of the wall.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.grid import cell_of
from gasbox.kernels.hall.approach import passes
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.tables import (
    CORNER,
    FACES,
    HIGH,
    KIND,
    LOW,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    RHO,
    SIDE,
    TX,
    TY,
    WALL,
)
from gasbox.kernels.stepped.tables import Grid, Slots, Walls

__all__ = [
    "NONE",
    "Way",
    "choices",
    "choose",
    "crossing",
    "earliest",
    "elements",
    "lets_pass",
    "put_back",
    "side_crossing",
    "way_of",
]

NONE = -1
"""No element."""
_SKIN = 1e-9
"""Of its radius: a centre comes no nearer to a line that it may not cross."""
_MARGIN = 1e-9
"""Of the length of a side, by which it reaches beyond its ends for those who would cross it."""
_MOST_IMAGES = 64
"""Of an element in each direction of a periodic box, for discs that fly far in one step."""

Way = tuple[float, float, float, float, float]
"""P, Q and the radius of the disc."""


@inlined_kernel
def way_of(row: int, slots: Slots, walls: Walls) -> Way:
    """The way of a disc in this step, so far."""
    slot = walls.slot[row]
    return walls.before[row, 0], walls.before[row, 1], slots.x[slot], slots.y[slot], slots.reach[slot]


@inlined_kernel
def elements(way: Way, level: int, box: Box, grid: Grid, walls: Walls) -> tuple[int, int, int]:
    """The cell whose list holds all that a way can meet, NONE if it is too long for lists; and images each way."""
    ax, ay, bx, by, _ = way
    dx, dy = bx - ax, by - ay
    near = dx * dx + dy * dy <= walls.largest[level] * walls.largest[level]
    across, along = 0, 0
    if box.periodic_x:
        across = 1 if near else int(min(abs(dx) / box.width + 1.0, _MOST_IMAGES))
    if box.periodic_y:
        along = 1 if near else int(min(abs(dy) / box.height + 1.0, _MOST_IMAGES))
    if not near:
        return NONE, across, along
    columns, rows = grid.columns[level], grid.rows[level]
    column, row = cell_of(bx, columns / box.width, columns), cell_of(by, rows / box.height, rows)
    return grid.first[level] + row * columns + column, across, along


@inlined_kernel
def choices(where: tuple[int, int, int], walls: Walls) -> int:
    """How many elements and images there are to look at."""
    cell, across, along = where
    images = (2 * across + 1) * (2 * along + 1)
    if cell == NONE:
        return walls.hall.kind.shape[0] * images
    return walls.hall.first[cell + 1] - walls.hall.first[cell] + walls.hall.moving.shape[0] * images


@inlined_kernel
def choose(choice: int, where: tuple[int, int, int], walls: Walls) -> tuple[int, int, int]:
    """Element and image of a choice: first the list of the cell, then whatever moves."""
    cell, across, along = where
    hall = walls.hall
    images = (2 * across + 1) * (2 * along + 1)
    if cell == NONE:
        e = choice // images
    else:
        listed = hall.first[cell + 1] - hall.first[cell]
        if choice < listed:
            entry = hall.first[cell] + choice
            return int(hall.near[entry]), int(hall.image[entry, 0]), int(hall.image[entry, 1])
        choice -= listed
        e = int(hall.moving[choice // images])
    rest = choice % images
    return e, rest % (2 * across + 1) - across, rest // (2 * across + 1) - along


@inlined_kernel
def lets_pass(walls: Walls, e: int, species: int, vx: float, vy: float, rate: float) -> bool:
    """Whether a disc with this velocity passes element e, whose wall moves at `rate` along its normal."""
    hall = walls.hall
    number = hall.kind[e, WALL]
    if not hall.passes[number, species]:
        return False
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    ux, uy = vx - rate * nx, vy - rate * ny
    along = ux * nx + uy * ny if hall.kind[e, KIND] == SIDE else 0.0
    return passes(hall, number, species, ux, uy, along)


@inlined_kernel
def _heights(
    walls: Walls, e: int, sx: float, sy: float, way: Way, moving: bool
) -> tuple[float, float, float, float, float, float]:
    """Place of begin and end of a way relative to a side: heights along its normal and feet; and its displacements."""
    hall = walls.hall
    ax, ay, bx, by, _ = way
    number = hall.kind[e, WALL]
    nx, ny, tx, ty = hall.shape[e, NX], hall.shape[e, NY], hall.shape[e, TX], hall.shape[e, TY]
    px, py = hall.shape[e, PX] + sx, hall.shape[e, PY] + sy
    after = walls.place[number]
    before = walls.start[number] if moving else after
    a = (ax - px) * nx + (ay - py) * ny - before
    b = (bx - px) * nx + (by - py) * ny - after
    return a, b, (ax - px) * tx + (ay - py) * ty, (bx - px) * tx + (by - py) * ty, before, after


@inlined_kernel
def side_crossing(
    walls: Walls, e: int, sx: float, sy: float, way: Way, moving: bool, skin: float, margin: float
) -> float:
    """Part of a way at which it crosses a side (infinity if it does not), coming nearer than `skin` [length]."""
    a, b, foot_a, foot_b, _, _ = _heights(walls, e, sx, sy, way, moving)
    faces = walls.hall.kind[e, FACES]
    behind = faces < 0 or (faces == 0 and a < 0.0)
    if behind:
        a, b = -a, -b
    # A centre exactly on the line counts as in front.
    if not (a >= 0.0 and (b < skin or (behind and b == skin)) and b < a):
        return math.inf
    part = min(a / (a - b), 1.0)
    foot = foot_a + part * (foot_b - foot_a)
    low, high = walls.hall.shape[e, LOW], walls.hall.shape[e, HIGH]
    beyond = margin * (high - low)
    return part if low - beyond <= foot <= high + beyond else math.inf


@inlined_kernel
def _entry(dx: float, dy: float, ax: float, ay: float, reach: float) -> float:
    """Part of a way from a by d at which it enters a circle around zero; 0 if it begins there, infinity if never."""
    c = ax * ax + ay * ay - reach * reach
    if c <= 0.0:
        return 0.0
    b = ax * dx + ay * dy
    square = dx * dx + dy * dy
    inside = b * b - square * c
    if b >= 0.0 or inside <= 0.0:
        return math.inf
    part = c / (math.sqrt(inside) - b)
    return part if part <= 1.0 else math.inf


@inlined_kernel
def _exit(dx: float, dy: float, ax: float, ay: float, room: float) -> float:
    """Part of a way from a by d at which it leaves a circle around zero; 0 if it begins outside, going outwards."""
    c = room * room - ax * ax - ay * ay
    b, square = ax * dx + ay * dy, dx * dx + dy * dy
    inside = b * b + square * c
    if room <= 0.0 or square == 0.0 or inside <= 0.0 or (c <= 0.0 and b >= 0.0):
        return 0.0
    root = math.sqrt(inside)
    return min(c / (b + root) if b > 0.0 else (root - b) / square, 1.0)


@inlined_kernel
def _to_post(
    walls: Walls, e: int, sx: float, sy: float, way: Way, moving: bool
) -> tuple[float, float, float, float]:
    """Begin of a way as seen from a corner or post, and how far it leads as seen from there."""
    ax, ay, bx, by, _ = way
    hall = walls.hall
    number = hall.kind[e, WALL]
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    after = walls.place[number]
    before = walls.start[number] if moving else after
    px, py = hall.shape[e, PX] + sx + before * nx, hall.shape[e, PY] + sy + before * ny
    return ax - px, ay - py, bx - ax - (after - before) * nx, by - ay - (after - before) * ny


@inlined_kernel
def crossing(walls: Walls, e: int, sx: float, sy: float, way: Way, moving: bool) -> float:
    """Part of a way at which the centre would get across an element that lets nobody pass; infinity if it does not."""
    ax, ay, bx, by, r = way
    hall = walls.hall
    if hall.kind[e, KIND] == SIDE:
        return side_crossing(walls, e, sx, sy, way, moving, _SKIN * r, _MARGIN)
    rho = hall.shape[e, RHO]
    px, py = hall.shape[e, PX] + sx, hall.shape[e, PY] + sy
    if hall.kind[e, KIND] == CORNER:
        if rho == 0.0:
            return math.inf
        x, y, dx, dy = _to_post(walls, e, sx, sy, way, moving)
        return math.inf if x * x + y * y <= rho * rho else _entry(dx, dy, x, y, rho)
    most = rho - _SKIN * r
    if (bx - px) ** 2 + (by - py) ** 2 < most * most:
        return math.inf
    return _exit(bx - ax, by - ay, ax - px, ay - py, rho)


@bare_kernel
def put_back(walls: Walls, e: int, sx: float, sy: float, way: Way, put: NDArray[np.float64]) -> None:
    """Where on its way a disc first touches an element (its begin, if it does so there), and the normal there.

    put : (>= 4,) place (2) and unit normal towards the disc (2)
    """
    ax, ay, bx, by, r = way
    hall = walls.hall
    if hall.kind[e, KIND] == SIDE:
        a, b, _, _, before, after = _heights(walls, e, sx, sy, way, True)
        faces = hall.kind[e, FACES]
        face = -1.0 if faces < 0 or (faces == 0 and a < 0.0) else 1.0
        a, b = face * a, face * b
        part = max((a - r) / (a - b), 0.0)
        nx, ny = hall.shape[e, NX], hall.shape[e, NY]
        carried = (after - before) * (1.0 - part)
        put[0] = ax + part * (bx - ax) + carried * nx
        put[1] = ay + part * (by - ay) + carried * ny
        put[2], put[3] = face * nx, face * ny
        return
    rho = hall.shape[e, RHO]
    px, py = hall.shape[e, PX] + sx, hall.shape[e, PY] + sy
    if hall.kind[e, KIND] == CORNER:
        x, y, dx, dy = _to_post(walls, e, sx, sy, way, True)
        part, sign = _entry(dx, dy, x, y, rho + r), 1.0
    else:
        part, sign = _exit(bx - ax, by - ay, ax - px, ay - py, rho - r), -1.0
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    number = hall.kind[e, WALL]
    # Like a side, one that moves takes along whom it has met.
    carried = (walls.place[number] - walls.start[number]) * (1.0 - part)
    x, y = ax + part * (bx - ax) + carried * nx, ay + part * (by - ay) + carried * ny
    px, py = px + walls.place[number] * nx, py + walls.place[number] * ny
    away = math.sqrt((x - px) ** 2 + (y - py) ** 2)
    put[0], put[1] = x, y
    put[2], put[3] = sign * (x - px) / away, sign * (y - py) / away


@bare_kernel
def earliest(
    way: Way,
    where: tuple[int, int, int],
    box: Box,
    walls: Walls,
    species: int,
    vx: float,
    vy: float,
    time: float,
    moving: bool,
) -> tuple[int, float, float, float]:
    """The first element that a way would cross and may not: element (or NONE), shift of its image, part of the way.

    moving : whether the way takes as long as the step; otherwise walls are where they are in the end
    """
    hall = walls.hall
    best, best_x, best_y, part = NONE, 0.0, 0.0, math.inf
    for choice in range(choices(where, walls)):
        e, image_x, image_y = choose(choice, where, walls)
        sx, sy = image_x * box.width, image_y * box.height
        t = crossing(walls, e, sx, sy, way, moving)
        if t == math.inf or t > part or (t == part and e >= best):
            continue
        number = hall.kind[e, WALL]
        if not hall.rule[number, OPEN] and lets_pass(walls, e, species, vx, vy, speed(hall, number, time)):
            continue
        best, best_x, best_y, part = e, sx, sy, t
    return best, best_x, best_y, part
