"""The lists of particles in each cell, and when a particle crosses into the next cell.

Crossings only decide which pairs are looked at; they never touch a reference, so they may be rounded at will.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.flight import place_at, velocity_at
from gasbox.kernels.event_driven.tables import (
    CELL,
    COLUMN,
    COLUMNS,
    FIRST,
    LEVEL,
    NEXT,
    PREV,
    ROW,
    ROWS,
    T0,
    T_CROSS,
)
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.roots import first_fall

__all__ = ["cross", "enter", "leave", "schedule_crossing", "wrapped"]


@inlined_kernel
def wrapped(cell: int, cells: int) -> int:
    """Column or row of a cell at most one box beyond the first or last."""
    return cell + cells if cell < 0 else cell - cells if cell >= cells else cell


@inlined_kernel
def enter(
    link: NDArray[np.int32], head: NDArray[np.int32], levels: NDArray[np.int64], i: int, column: int, row: int
) -> None:
    """Put particle `i` into the list of a cell of its level."""
    level = link[i, LEVEL]
    cell = levels[level, FIRST] + row * levels[level, COLUMNS] + column
    link[i, COLUMN] = column
    link[i, ROW] = row
    after = head[cell]
    link[i, CELL] = cell
    link[i, PREV] = -1
    link[i, NEXT] = after
    if after >= 0:
        link[after, PREV] = i
    head[cell] = i


@inlined_kernel
def leave(link: NDArray[np.int32], head: NDArray[np.int32], i: int) -> None:
    """Take particle `i` out of the list of its cell."""
    before, after = link[i, PREV], link[i, NEXT]
    if before >= 0:
        link[before, NEXT] = after
    else:
        head[link[i, CELL]] = after
    if after >= 0:
        link[after, PREV] = before


@inlined_kernel
def _time_to_cross(
    x: float, v: float, cell: int, cells: int, side: float, length: float, periodic: bool
) -> float:
    """Time from now until the coordinate `x` leaves its cell, infinity if it stays or ends at a wall.

    A cell as long as a periodic box has no edge; other images come near, and are looked for after each length flown.
    """
    if v == 0.0 or (not periodic and cell == (cells - 1 if v > 0.0 else 0)):
        return math.inf
    if cells == 1:
        return length / abs(v)
    within = x - cell * side
    if periodic:
        within -= length * np.rint((within - 0.5 * side) / length)
    distance = max(side - within, 0.0) if v > 0.0 else max(within, 0.0)
    return distance / abs(v)


@inlined_kernel
def _to_edges(
    x: float, cell: int, cells: int, side: float, length: float, periodic: bool
) -> tuple[float, float]:
    """Distance of the coordinate `x` from the lower and the upper edge of its cell, infinity where there is none."""
    if cells == 1:
        return (length, length) if periodic else (math.inf, math.inf)
    within = x - cell * side
    if periodic:
        within -= length * np.rint((within - 0.5 * side) / length)
    down, up = max(within, 0.0), max(side - within, 0.0)
    if not periodic:
        down = math.inf if cell == 0 else down
        up = math.inf if cell == cells - 1 else up
    return down, up


@inlined_kernel
def _time_to_fall_out(
    x: float, v: float, g: float, cell: int, cells: int, side: float, length: float, periodic: bool
) -> float:
    """As `_time_to_cross`, with an acceleration."""
    down, up = _to_edges(x, cell, cells, side, length, periodic)
    time = math.inf
    if down < math.inf:
        time = first_fall(down, v, g, 0.0, 0.0)
    if up < math.inf:
        time = min(time, first_fall(up, -v, -g, 0.0, 0.0))
    return time


@inlined_kernel
def _times_to_cross(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    levels: NDArray[np.int64],
    sides: NDArray[np.float64],
    box: Box,
    hall: Hall | None,
    i: int,
    now: float,
) -> tuple[float, float]:
    """Time from `now` until particle `i` leaves its cell sideways, and up or down."""
    level = link[i, LEVEL]
    columns, rows = levels[level, COLUMNS], levels[level, ROWS]
    elapsed = now - flight[i, T0]
    x, y = place_at(flight, hall, i, elapsed)
    vx, vy = velocity_at(flight, hall, i, elapsed)
    if hall is not None:
        column, row = link[i, COLUMN], link[i, ROW]
        return (
            _time_to_fall_out(x, vx, hall.gx, column, columns, sides[level, 0], box.width, box.periodic_x),
            _time_to_fall_out(y, vy, hall.gy, row, rows, sides[level, 1], box.height, box.periodic_y),
        )
    return (
        _time_to_cross(x, vx, link[i, COLUMN], columns, sides[level, 0], box.width, box.periodic_x),
        _time_to_cross(y, vy, link[i, ROW], rows, sides[level, 1], box.height, box.periodic_y),
    )


@inlined_kernel
def schedule_crossing(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    levels: NDArray[np.int64],
    sides: NDArray[np.float64],
    box: Box,
    hall: Hall | None,
    i: int,
    now: float,
) -> None:
    """Set the time at which particle `i` leaves its cell."""
    along_x, along_y = _times_to_cross(flight, link, levels, sides, box, hall, i, now)
    flight[i, T_CROSS] = now + min(along_x, along_y)


@inlined_kernel
def _falls(hall: Hall | None) -> bool:
    """Whether there is gravity."""
    if hall is None:
        return False
    return hall.gx != 0.0 or hall.gy != 0.0


@inlined_kernel
def _nearest_edge(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    levels: NDArray[np.int64],
    sides: NDArray[np.float64],
    box: Box,
    hall: Hall | None,
    i: int,
    now: float,
    all_around: bool,
) -> tuple[int, int]:
    """Direction of the edge that particle i stands on: where it turns round, its velocity could not tell.

    all_around : whether it may stand on none, having flown once round the box
    """
    level = link[i, LEVEL]
    x, y = place_at(flight, hall, i, now - flight[i, T0])
    left, right = _to_edges(
        x, link[i, COLUMN], levels[level, COLUMNS], sides[level, 0], box.width, box.periodic_x
    )
    below, above = _to_edges(
        y, link[i, ROW], levels[level, ROWS], sides[level, 1], box.height, box.periodic_y
    )
    nearest = min(left, right, below, above)
    if all_around and nearest > 1e-7 * min(sides[level, 0], sides[level, 1]):
        return 0, 0
    if min(left, right) == nearest:
        return (-1 if left < right else 1), 0
    return 0, (-1 if below < above else 1)


@inlined_kernel
def cross(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    head: NDArray[np.int32],
    levels: NDArray[np.int64],
    sides: NDArray[np.float64],
    box: Box,
    hall: Hall | None,
    i: int,
    now: float,
) -> tuple[int, int]:
    """Move particle `i` into the cell that it enters at time `now`, and return where to look for what has come near.

    Returns
    -------
    The direction (-1, 0 or 1 in x and y); 0 and 0, all around, where a cell is as long as a periodic box.
    """
    along_x, along_y = _times_to_cross(flight, link, levels, sides, box, hall, i, now)
    level = link[i, LEVEL]
    columns, rows = levels[level, COLUMNS], levels[level, ROWS]
    vx, vy = velocity_at(flight, hall, i, now - flight[i, T0])
    all_around = (box.periodic_x and columns == 1) or (box.periodic_y and rows == 1)
    step_x, step_y = 0, 0
    if _falls(hall):
        step_x, step_y = _nearest_edge(flight, link, levels, sides, box, hall, i, now, all_around)
    elif all_around:
        # Has it reached an edge, or flown once round the box?
        if columns > 1 and along_x * abs(vx) < 1e-7 * sides[level, 0]:
            step_x = 1 if vx > 0.0 else -1
        elif rows > 1 and along_y * abs(vy) < 1e-7 * sides[level, 1]:
            step_y = 1 if vy > 0.0 else -1
    elif along_x <= along_y:
        step_x = 1 if vx > 0.0 else -1
    else:
        step_y = 1 if vy > 0.0 else -1
    leave(link, head, i)
    column, row = wrapped(link[i, COLUMN] + step_x, columns), wrapped(link[i, ROW] + step_y, rows)
    enter(link, head, levels, i, column, row)
    return (0, 0) if all_around else (step_x, step_y)
