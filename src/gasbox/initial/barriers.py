"""From an enclosure to the barriers that kernels place discs between."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Circle, Enclosure, Polygon, Wall
from gasbox.geometry.solids import Solid, reach, solids
from gasbox.kernels.barriers import Barriers

__all__ = ["barriers", "stops_all"]

_CELLS: Final = 64
"""Along the longer side."""
_SLACK: Final = 1e-14


def stops_all(wall: Wall) -> bool:
    """Whether no disc may overlap a wall: nobody passes it, and it did not come while discs stood in its place."""
    return wall.passes is None and not wall.soft


def barriers(
    enclosure: Enclosure, largest: float, which: Callable[[Wall], bool] = lambda _: True
) -> Barriers:
    """All walls that stand in the way, where they are now, for discs with radii up to `largest` [length].

    which : of the walls, those that count
    """
    found = [solid for solid in solids(enclosure) if which(enclosure.walls[solid.wall])]
    rows = [row for solid in found for row in _rows(solid, reach(enclosure.walls[solid.wall], 1.0))]
    shape = np.array(rows, np.float64).reshape(-1, 6)
    edge, outer = _edges(enclosure, found)
    cells = np.maximum(np.ceil(_CELLS * enclosure.size / enclosure.size.max()), 1).astype(np.int64)
    first, near = _near(shape, enclosure.size, cells, largest)
    rim = np.zeros(4)
    if isinstance(enclosure.container, Circle):
        radius = enclosure.container.radius
        rim[:] = (*enclosure.container.center, radius, reach(enclosure.walls[0], 1.0))
    return Barriers(
        shape,
        rim,
        edge,
        outer,
        enclosure.size,
        cells,
        first,
        near,
        _free(enclosure, found, cells, np.diff(first) > 0),
        enclosure.periodic,
        _SLACK * float(enclosure.size.max()),
    )


def _rows(solid: Solid, kept: float) -> list[tuple[float, ...]]:
    """Rows of `Barriers.shape`."""
    places = shapely.get_coordinates(solid.shape)
    if len(places) == 1:
        return [(*places[0], *places[0], solid.radius, kept)]
    return [(*places[k], *places[k + 1], 0.0, kept) for k in range(len(places) - 1)]


def _edges(enclosure: Enclosure, found: list[Solid]) -> tuple[NDArray[np.float64], int]:
    """Sides (e, 4) [length] of the container, if it is a polygon, and of blocks; and how many are the former."""
    rings = [np.array(enclosure.container.vertices)] if isinstance(enclosure.container, Polygon) else []
    outer = len(rings[0]) if rings else 0
    blocks = [solid.shape for solid in found if isinstance(solid.shape, shapely.Polygon)]
    rings += [shapely.get_coordinates(shape)[:-1] for shape in blocks]
    sides = [np.concatenate([ring, np.roll(ring, -1, axis=0)], axis=1) for ring in rings]
    return np.concatenate([np.zeros((0, 4)), *sides]), outer


def _boxes(size: NDArray[np.float64], cells: NDArray[np.int64]) -> NDArray[np.object_]:
    """All cells as shapes, row by row."""
    row, column = np.divmod(np.arange(cells[0] * cells[1]), cells[0])
    wide, high = size / cells
    return np.asarray(shapely.box(column * wide, row * high, (column + 1) * wide, (row + 1) * high))


def _near(
    shape: NDArray[np.float64], size: NDArray[np.float64], cells: NDArray[np.int64], largest: float
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Which barriers a disc can meet whose centre lies in a cell, or less than a radius beside it."""
    boxes = _boxes(size, cells)
    count = np.zeros(len(boxes) + 1, np.int64)
    if not len(shape):
        return count, np.zeros(0, np.int64)
    lines = shapely.linestrings(shape[:, :4].reshape(-1, 2, 2))
    # A line without length is not searched for as far as the distance says.
    post = (shape[:, :2] == shape[:, 2:4]).all(axis=1)
    lines[post] = shapely.points(shape[post, :2])
    distance = shape[:, 4] + (1 + 1e-9) * 2 * largest
    element, cell = shapely.STRtree(boxes).query(lines, predicate="dwithin", distance=distance)
    order = np.lexsort((element, cell))
    np.add.at(count, cell + 1, 1)
    return np.cumsum(count), element[order].astype(np.int64)


def _free(
    enclosure: Enclosure, found: list[Solid], cells: NDArray[np.int64], touched: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """(cells,) bool: cells without barriers that do not lie outside, or inside a block."""
    row, column = np.divmod(np.arange(cells[0] * cells[1]), cells[0])
    middle = (np.stack([column, row], axis=1) + 0.5) * enclosure.size / cells
    free = ~touched
    if isinstance(enclosure.container, Polygon):
        free &= shapely.contains_xy(shapely.Polygon(enclosure.container.vertices), *middle.T)
    for solid in found:
        if isinstance(solid.shape, shapely.Polygon):
            free &= ~shapely.contains_xy(solid.shape, *middle.T)
        elif solid.radius:
            free &= np.hypot(*(middle - shapely.get_coordinates(solid.shape)[0]).T) > solid.radius
    return free
