"""Look for the earliest meeting of a particle with the discs around it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.event_driven.bodies import meeting
from gasbox.kernels.event_driven.cells import wrapped
from gasbox.kernels.event_driven.crowd import sift
from gasbox.kernels.event_driven.flight import place_at
from gasbox.kernels.event_driven.pairs import apart, may_meet, over_images, precedes, preferred
from gasbox.kernels.event_driven.tables import (
    COLUMN,
    COLUMNS,
    CROWDED,
    FACTOR_X,
    FACTOR_Y,
    FASTEST,
    FIRST,
    IMAGES_X,
    IMAGES_Y,
    LEVEL,
    NEXT,
    RADIUS,
    ROW,
    ROWS,
    T0,
    T_EVENT,
    TESTS,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.grid import span
from gasbox.kernels.hall import Hall
from gasbox.kernels.molecules.spin import Spin

__all__ = ["survey"]


@inlined_kernel
def _look(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    head: NDArray[np.int32],
    counter: NDArray[np.int64],
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    i: int,
    now: float,
    grid: tuple[int, int, int, int, int],
    block: tuple[int, int, int, int],
    best: float,
    who: int,
) -> tuple[float, int]:
    """The earliest meeting of i with the discs in a block of cells, if it precedes (best, who).

    grid : columns, rows, first cell of the level looked at; how many images aside to try in x, y
    block : first and last column, first and last row; may reach beyond the box by one cell where it is periodic
    """
    columns, rows, first, images_x, images_y = grid
    left, right, below, above = block
    own = (flight[i, X], flight[i, Y], flight[i, VX], flight[i, VY], flight[i, T0], flight[i, RADIUS])
    across = 1.0 / box.width if box.periodic_x else 0.0
    along = 1.0 / box.height if box.periodic_y else 0.0
    tests = 0
    for row in range(below, above + 1):
        base = first + wrapped(row, rows) * columns
        for column in range(left, right + 1):
            j = head[base + wrapped(column, columns)]
            while j >= 0:
                after = link[j, NEXT]
                tests += 1
                held = flight[j, T_EVENT]
                if images_x + images_y == 0:
                    dx, dy, dvx, dvy, sigma, start = apart(own, flight, hall, j, now, box, across, along)
                    b = dx * dvx + dy * dvy
                    c = dx * dx + dy * dy - sigma * sigma
                    # Even head-on they could not meet before c/(-2 b): too late?
                    if not may_meet(spin, b, c, start, min(best, held)):
                        j = after
                        continue
                    latest = min(best, held)
                    time = meeting(spin, flight, link, i, j, dx, dy, dvx, dvy, sigma, start, latest)
                elif j == i:
                    time = math.inf
                else:
                    images = (images_x, images_y)
                    time = over_images(own, flight, link, hall, spin, i, j, now, box, across, along, images)
                if (
                    time <= best
                    and time <= held
                    and time < math.inf
                    and preferred(link, time, i, j, best, who)
                    and precedes(flight, link, time, i, j, j)
                ):
                    best, who = time, j
                j = after
    counter[TESTS] += tests
    return best, who


@inlined_kernel
def _finer(x: float, cell: int, side: float, fine: float, length: float, periodic: bool) -> int:
    """Number of the finer cell (of width `fine`) that holds the coordinate, inside a cell of width `side`."""
    within = x - cell * side
    if periodic:
        within -= length * np.rint((within - 0.5 * side) / length)
    parts = int(side / fine + 0.5)
    return cell * parts + min(max(int(within / fine), 0), parts - 1)


@bare_kernel
def _look_around(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    i: int,
    now: float,
    level: int,
    grid: tuple[int, int, int, int, int],
    block: tuple[int, int, int, int],
    best: float,
    who: int,
) -> tuple[float, int]:
    """Look for smaller discs in a block of finer cells, in square rings around i, until none could come in time."""
    flight, link, head, counter = tables.flight, tables.link, tables.head, tables.counter
    left, right, below, above = block
    side_x, side_y = tables.sides[level, 0], tables.sides[level, 1]
    side, radius = min(side_x, side_y), flight[i, RADIUS]
    # The finer cell of the centre, counted from the disc's own cell: rounding at a periodic side does no harm.
    own = link[i, LEVEL]
    x, y = place_at(flight, hall, i, now - flight[i, T0])
    column = _finer(x, link[i, COLUMN], tables.sides[own, 0], side_x, box.width, box.periodic_x)
    row = _finer(y, link[i, ROW], tables.sides[own, 1], side_y, box.height, box.periodic_y)
    speed = tables.number[FASTEST] * 2.0000000001
    if hall is not None:
        # References are from this epoch: nobody has fallen for longer than that.
        speed += 2.0000000001 * now * math.sqrt(hall.gx * hall.gx + hall.gy * hall.gy)
    last = max(right - column, column - left, above - row, row - below)
    ring = max(int(radius / (1.5 * max(side_x, side_y))) - 1, 0)
    while ring <= last:
        # Centres in this ring are at least ring - 1 cells away; no disc of the level is wider than a cell; a margin.
        gap = (ring - 1.501) * side - radius
        if gap > 0.0 and now + gap / speed > best:
            break
        for edge in range(4):
            if edge < 2:
                line = row - ring if edge == 0 else row + ring
                part = (max(column - ring, left), min(column + ring, right), line, line)
                present = below <= line <= above and (ring > 0 or edge == 0)
            else:
                line = column - ring if edge == 2 else column + ring
                part = (line, line, max(row - ring + 1, below), min(row + ring - 1, above))
                present = left <= line <= right and ring > 0
            if present:
                best, who = _look(flight, link, head, counter, box, hall, spin, i, now, grid, part, best, who)
        ring += 1
    return best, who


@inlined_kernel
def _entered(
    step: int, old: int, cell: int, cells: int, periodic: bool, low: int, high: int
) -> tuple[int, int]:
    """Of the offsets low..high those that a crossing by `step` from cell `old` has brought near (all if no step)."""
    if step == 0 or (cells == 1 and periodic):
        return low, high
    if old != cell and (periodic or low <= step <= high):
        return step, step
    return 1, 0


@inlined_kernel
def survey(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    i: int,
    now: float,
    step_x: int,
    step_y: int,
    all_around: bool,
    best: float,
    who: int,
) -> tuple[float, int]:
    """Look through all levels around particle i, or (step not zero) through what a crossing has brought near."""
    flight, link, head, levels, counter = (
        tables.flight,
        tables.link,
        tables.head,
        tables.levels,
        tables.counter,
    )
    own = link[i, LEVEL]
    column, row = link[i, COLUMN], link[i, ROW]
    before_x = wrapped(column - step_x, levels[own, COLUMNS])
    before_y = wrapped(row - step_y, levels[own, ROWS])
    for level in range(levels.shape[0]):
        coarse = max(own, level)
        cx, cy, old_x, old_y = column, row, before_x, before_y
        if level > own:
            fx = levels[level, FACTOR_X] // levels[own, FACTOR_X]
            fy = levels[level, FACTOR_Y] // levels[own, FACTOR_Y]
            cx, cy, old_x, old_y = cx // fx, cy // fy, old_x // fx, old_y // fy
        columns, rows = levels[coarse, COLUMNS], levels[coarse, ROWS]
        left, right = span(cx, columns, box.periodic_x)
        below, above = span(cy, rows, box.periodic_y)
        left, right = _entered(step_x, old_x, cx, columns, box.periodic_x, left, right)
        below, above = _entered(step_y, old_y, cy, rows, box.periodic_y, below, above)
        grid = (
            levels[level, COLUMNS],
            levels[level, ROWS],
            levels[level, FIRST],
            levels[coarse, IMAGES_X],
            levels[coarse, IMAGES_Y],
        )
        if level >= own:
            block = (cx + left, cx + right, cy + below, cy + above)
            if all_around and levels[level, CROWDED] > 0:
                best, who = sift(tables, box, hall, i, now, level, block, best, who)
                continue
            best, who = _look(flight, link, head, counter, box, hall, spin, i, now, grid, block, best, who)
        else:
            fine_x = levels[own, FACTOR_X] // levels[level, FACTOR_X]
            fine_y = levels[own, FACTOR_Y] // levels[level, FACTOR_Y]
            block = (
                (cx + left) * fine_x,
                (cx + right + 1) * fine_x - 1,
                (cy + below) * fine_y,
                (cy + above + 1) * fine_y - 1,
            )
            seen_twice = (box.periodic_x and columns < 3) or (box.periodic_y and rows < 3)
            if step_x != 0 or step_y != 0 or seen_twice:
                best, who = _look(
                    flight, link, head, counter, box, hall, spin, i, now, grid, block, best, who
                )
            else:
                best, who = _look_around(tables, box, hall, spin, i, now, level, grid, block, best, who)
    return best, who
