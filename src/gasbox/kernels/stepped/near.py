"""Walls move on, and the discs that may have to do with a wall in a step are marked, each thread its share."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.hall.motion import displacement
from gasbox.kernels.hall.tables import (
    CORNER,
    FACES,
    HIGH,
    KIND,
    LOW,
    LOWER,
    MASS,
    MOTION,
    NX,
    NY,
    PUSH,
    PX,
    PY,
    REST,
    RHO,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    SIDE,
    TX,
    TY,
    UPPER,
    WALL,
    Hall,
)
from gasbox.kernels.stepped.tables import Grid, Slots, Walls
from gasbox.kernels.stepped.ways import Way, choices, choose
from gasbox.kernels.team import share

__all__ = ["find", "mark", "move_walls"]


@inlined_kernel
def _move_piston(hall: Hall, number: int, time_step: float) -> None:
    """Let a free piston fly one step; at a stop it bounces with the energy that it has there."""
    wall = hall.wall[number]
    push = wall[PUSH]
    wall[S_PLACE] += wall[S_SPEED] * time_step + 0.5 * push * time_step * time_step
    wall[S_SPEED] += push * time_step
    wall[S_PUSH] = push
    low, high = wall[LOWER], wall[UPPER]
    if low <= wall[S_PLACE] <= high:
        return
    stop, inwards = (low, 1.0) if wall[S_PLACE] < low else (high, -1.0)
    square = wall[S_SPEED] * wall[S_SPEED] + 2.0 * push * (stop - wall[S_PLACE])
    wall[S_PLACE], wall[S_SPEED] = stop, inwards * math.sqrt(max(square, 0.0))
    if square <= 0.0:
        wall[S_PUSH] = 0.0


@bare_kernel
def move_walls(walls: Walls, time_step: float, time: float) -> None:
    """Bring all walls to where they are at `time`, the end of the step."""
    hall = walls.hall
    for number in range(hall.wall.shape[0]):
        walls.start[number] = walls.place[number]
        if hall.rule[number, MOTION] == REST:
            continue
        if hall.wall[number, MASS] > 0.0:
            _move_piston(hall, number, time_step)
            hall.wall[number, S_TIME] = time
        walls.place[number] = displacement(hall, number, time)


@inlined_kernel
def _may_meet(walls: Walls, e: int, sx: float, sy: float, way: Way, most: float) -> bool:
    """Whether the end of a way, no longer than `most`, is within reach of an element, or perhaps beyond it."""
    ax, ay, bx, by, r = way
    hall = walls.hall
    number = hall.kind[e, WALL]
    nx, ny = hall.shape[e, NX], hall.shape[e, NY]
    px, py = hall.shape[e, PX] + sx, hall.shape[e, PY] + sy
    after = walls.place[number]
    if hall.kind[e, KIND] == SIDE:
        b = (bx - px) * nx + (by - py) * ny - after
        face = hall.kind[e, FACES]
        if face == 0:
            a = (ax - px) * nx + (ay - py) * ny - walls.start[number]
            face = 1.0 if a >= 0.0 else -1.0
        if face * b > r:
            return False
        foot = (bx - px) * hall.shape[e, TX] + (by - py) * hall.shape[e, TY]
        return hall.shape[e, LOW] - most <= foot <= hall.shape[e, HIGH] + most
    x, y = bx - px - after * nx, by - py - after * ny
    if hall.kind[e, KIND] == CORNER:
        reach = r + hall.shape[e, RHO]
        if hall.shape[e, RHO] > 0.0:
            reach += most + abs(after - walls.start[number])
        return x * x + y * y <= reach * reach
    room = hall.shape[e, RHO] - r
    return x * x + y * y >= room * room


@bare_kernel
def _is_near(way: Way, where: tuple[int, int, int], most: float, box: Box, walls: Walls) -> bool:
    for choice in range(choices(where, walls)):
        e, image_x, image_y = choose(choice, where, walls)
        if _may_meet(walls, e, image_x * box.width, image_y * box.height, way, most):
            return True
    return False


@bare_kernel
def mark(
    slots: Slots, box: Box, grid: Grid, cell: NDArray[np.int32], walls: Walls, thread: int, threads: int
) -> None:
    """Mark this thread's share of the discs: those that may touch or cross a wall.

    cell : (n,) of the disc in each slot
    """
    begin, end = share(slots.row.shape[0], thread, threads)
    first, moves = walls.hall.first, walls.hall.moving.shape[0] > 0
    across, along = 1 if box.periodic_x else 0, 1 if box.periodic_y else 0
    for slot in range(begin, end):
        row = slots.row[slot]
        ax, ay, bx, by = walls.before[row, 0], walls.before[row, 1], slots.x[slot], slots.y[slot]
        most = walls.largest[grid.level[row]]
        if (bx - ax) * (bx - ax) + (by - ay) * (by - ay) > most * most:
            walls.near[row] = 1
        elif moves or first[cell[slot] + 1] > first[cell[slot]]:
            way = ax, ay, bx, by, slots.reach[slot]
            walls.near[row] = 1 if _is_near(way, (cell[slot], across, along), most, box, walls) else 0
        else:
            walls.near[row] = 0
        if walls.gone[row]:
            walls.near[row] = 0


@bare_kernel
def find(slots: Slots, walls: Walls, thread: int, threads: int) -> None:
    """Note where this thread's share of the discs has been filed."""
    begin, end = share(slots.row.shape[0], thread, threads)
    for slot in range(begin, end):
        walls.slot[slots.row[slot]] = slot
