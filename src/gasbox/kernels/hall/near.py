"""Which elements at rest a disc can touch from each cell: lists made once, so that a wall costs only who is near it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.hall.tables import (
    HIGH,
    KIND,
    LOW,
    MOTION,
    PX,
    PY,
    REST,
    RHO,
    RIM,
    SIDE,
    TX,
    TY,
    WALL,
    Hall,
)

__all__ = ["with_cells"]

_FAR = 1e300


@kernel
def _span(low: float, high: float, side: float, cells: int) -> tuple[int, int]:
    """First and last cell of a direction that meet [low, high]; what lies outside is in the outermost."""
    first = 0 if low <= 0.0 else min(int(low / side), cells - 1)
    last = cells - 1 if high >= side * cells else max(int(max(high, 0.0) / side), 0)
    return first, min(last, cells - 1)


@kernel
def _near_side(hall: Hall, e: int, x: float, y: float, reach: float) -> bool:
    """Whether a point is within reach of a side."""
    tx, ty = hall.shape[e, TX], hall.shape[e, TY]
    along = x * tx + y * ty
    along = min(max(along, hall.shape[e, LOW]), hall.shape[e, HIGH])
    dx, dy = x - along * tx, y - along * ty
    return dx * dx + dy * dy <= reach * reach


@kernel
def _is_near(hall: Hall, e: int, x: float, y: float, reach: float) -> bool:
    """Whether a point (x, y), relative to the place of element e, is within reach of it."""
    kind = hall.kind[e, KIND]
    if kind == SIDE:
        return _near_side(hall, e, x, y, reach)
    if kind == RIM:
        return math.sqrt(x * x + y * y) + reach >= hall.shape[e, RHO]
    return x * x + y * y <= (reach + hall.shape[e, RHO]) ** 2


@kernel
def _bounds(hall: Hall, e: int, reach: float) -> tuple[float, float, float, float]:
    """Left, right, lower and upper bound of what is within reach of element e, relative to its place."""
    if hall.kind[e, KIND] != SIDE:
        wide = reach + hall.shape[e, RHO]
        return -wide, wide, -wide, wide
    tx, ty = hall.shape[e, TX], hall.shape[e, TY]
    low, high = max(hall.shape[e, LOW], -_FAR), min(hall.shape[e, HIGH], _FAR)
    ax, bx, ay, by = low * tx, high * tx, low * ty, high * ty
    return min(ax, bx) - reach, max(ax, bx) + reach, min(ay, by) - reach, max(ay, by) + reach


@kernel
def _list(
    hall: Hall,
    size: NDArray[np.float64],
    periodic: NDArray[np.bool_],
    columns: NDArray[np.int64],
    rows: NDArray[np.int64],
    offset: NDArray[np.int64],
    largest: NDArray[np.float64],
    count: NDArray[np.int32],
    near: NDArray[np.int32],
    image: NDArray[np.int8],
    filling: bool,
) -> None:
    """Count (at cell + 1) or list the elements of each cell; `count` is then where the cell's next entry goes."""
    for level in range(columns.shape[0]):
        wide, high = size[0] / columns[level], size[1] / rows[level]
        reach = largest[level] * (1.0 + 1e-6) + 0.5 * math.sqrt(wide * wide + high * high) * (1.0 + 1e-6)
        for e in range(hall.kind.shape[0]):
            number = hall.kind[e, WALL]
            if hall.rule[number, MOTION] != REST:
                continue
            left, right, below, above = _bounds(hall, e, reach)
            for image_y in range(-1 if periodic[1] else 0, 2 if periodic[1] else 1):
                for image_x in range(-1 if periodic[0] else 0, 2 if periodic[0] else 1):
                    px = hall.shape[e, PX] + image_x * size[0]
                    py = hall.shape[e, PY] + image_y * size[1]
                    if px + right < 0.0 or px + left > size[0] or py + above < 0.0 or py + below > size[1]:
                        continue
                    first, last = _span(px + left, px + right, wide, columns[level])
                    bottom, top = _span(py + below, py + above, high, rows[level])
                    for row in range(bottom, top + 1):
                        for column in range(first, last + 1):
                            x, y = (column + 0.5) * wide - px, (row + 0.5) * high - py
                            if not _is_near(hall, e, x, y, reach):
                                continue
                            cell = offset[level] + row * columns[level] + column
                            if filling:
                                near[count[cell]] = e
                                image[count[cell], 0], image[count[cell], 1] = image_x, image_y
                                count[cell] += 1
                            else:
                                count[cell + 1] += 1


def with_cells(
    hall: Hall,
    size: NDArray[np.float64],
    periodic: NDArray[np.bool_],
    columns: NDArray[np.int64],
    rows: NDArray[np.int64],
    offset: NDArray[np.int64],
    largest: NDArray[np.float64],
) -> Hall:
    """The hall with lists for grids over a box of this size.

    Parameters
    ----------
    size : (2,) [length]; periodic : (2,)
    columns, rows, offset : (levels,) of each grid, and the number of its first cell; cells go row by row
    largest : (levels,) [length], largest radius of a disc of that level

    Returns
    -------
    A hall in which the elements at rest near cell c are near[first[c]:first[c + 1]], each at its place plus
    image * size. Discs beyond the box count to the outermost cells.
    """
    cells = int(offset[-1] + columns[-1] * rows[-1])
    count = np.zeros(cells + 1, np.int32)
    arguments = (hall, size, periodic, columns, rows, offset, largest)
    nothing = (np.zeros(0, np.int32), np.zeros((0, 2), np.int8))
    _list(*arguments, count, *nothing, False)
    first = np.cumsum(count, dtype=np.int32)
    near, image = np.zeros(int(first[-1]), np.int32), np.zeros((int(first[-1]), 2), np.int8)
    _list(*arguments, first[:-1].copy(), near, image, True)
    return hall._replace(first=first, near=near, image=image)
