"""Discs that lie in walls: the worst one, and the way out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Circle, Enclosure, Geometry, Passage, Polygon, Rectangle
from gasbox.geometry.region import room
from gasbox.geometry.solids import box, reach, solids
from gasbox.initial.barriers import barriers, stops_all
from gasbox.kernels.barriers import Barriers, deepest, is_clear

__all__ = ["bounds", "out_of_walls", "worst_at_wall"]

_CLEAR: Final = 1e-5
"""Of a radius: so much farther than touching from a wall is who was put out of it."""


def bounds(
    radius: NDArray[np.float64], geometry: Geometry
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lower and upper bounds (n, 2) [length] of the centres of discs (n,) that lie within the sides of the box."""
    if isinstance(geometry, Rectangle):
        margin = np.where(geometry.periodic, 0.0, radius[:, None])
        return margin, geometry.size - margin
    low, high = np.zeros((radius.size, 2)), np.tile(geometry.size, (radius.size, 1))
    if isinstance(geometry.container, Rectangle):
        ends = box(geometry, geometry.container)
        for wall in range(4):
            if not geometry.periodic[wall // 2]:
                kept = np.zeros_like(radius) if geometry.walls[wall].open else radius
                (high if wall % 2 else low)[:, wall // 2] = ends[wall] + (-kept if wall % 2 else kept)
    return np.minimum(low, high), high


def worst_at_wall(
    position: NDArray[np.float64], radius: NDArray[np.float64], geometry: Geometry, touching: float
) -> tuple[int, int, float] | None:
    """Row, wall and depth [length] of the disc deepest in a wall that nobody passes; None if all are clear.

    Parameters
    ----------
    position : (n, 2) [length]
    radius : (n,) [length]
    touching : depth, as a fraction of the radius, up to which a disc only touches
    """
    found = list(_in_sides(position, radius, geometry, touching))
    if isinstance(geometry, Enclosure):
        found += _in_barriers(geometry.wrap(position), radius, geometry, touching)
    return max(found, key=lambda entry: entry[2], default=None)


def _rounding(geometry: Geometry) -> float:
    """A wall is as far away as the side is long: rounding grows with it [length]."""
    return float((4 if isinstance(geometry, Rectangle) else 16) * np.spacing(geometry.size.max()))


def _in_sides(
    position: NDArray[np.float64], radius: NDArray[np.float64], geometry: Geometry, touching: float
) -> Iterator[tuple[int, int, float]]:
    """The worst one of each side of a rectangle."""
    container = geometry if isinstance(geometry, Rectangle) else geometry.container
    if not isinstance(container, Rectangle):
        return
    ends = (0.0, container.width, 0.0, container.height)
    if isinstance(geometry, Enclosure):
        ends = box(geometry, container)
    for wall, end in enumerate(ends):
        is_open = isinstance(geometry, Enclosure) and geometry.walls[wall].open
        if container.periodic[wall // 2] or is_open:
            continue
        place = position[:, wall // 2]
        depth = (place - end if wall % 2 else end - place) + radius
        depth[depth <= touching * radius + _rounding(geometry)] = -np.inf
        row = int(np.argmax(depth))
        if depth[row] > -np.inf:
            yield row, wall, float(depth[row])


def _in_barriers(
    position: NDArray[np.float64], radius: NDArray[np.float64], geometry: Enclosure, touching: float
) -> Iterator[tuple[int, int, float]]:
    """The worst one whose centre is where it may be, and all whose centres are not."""
    walls = barriers(geometry, float(radius.max()), stops_all)
    row, depth = deepest(walls, position, radius, touching, _rounding(geometry))
    if row >= 0:
        yield int(row), _nearest_wall(geometry, position[row], float(radius[row])), float(depth)
    if isinstance(geometry.container, Polygon) or len(walls.edge):
        lost = np.flatnonzero(~geometry.holds(position, 0.0))
        lines = shapely.linestrings(walls.edge.reshape(-1, 2, 2))
        for number in lost.tolist():
            away = float(shapely.distance(lines, shapely.Point(position[number])).min(initial=0.0))
            if away > _rounding(geometry):
                wall = _nearest_wall(geometry, position[number], 0.0)
                yield number, wall, float(radius[number]) + away


def _nearest_wall(geometry: Enclosure, place: NDArray[np.float64], radius: float) -> int:
    """Which wall is nearest to the surface of a disc at `place` (2,) [length]."""
    point, found = shapely.Point(place), []
    if isinstance(geometry.container, Circle):
        away = geometry.container.radius - float(np.hypot(*(place - geometry.container.center)))
        found.append((away - reach(geometry.walls[0], radius), 0))
    for solid in solids(geometry):
        if stops_all(geometry.walls[solid.wall]):
            shape = solid.shape.boundary if isinstance(solid.shape, shapely.Polygon) else solid.shape
            away = shape.distance(point) - solid.radius
            found.append((away - reach(geometry.walls[solid.wall], radius), solid.wall))
    return min(found)[1]


def out_of_walls(
    position: NDArray[np.float64], radius: NDArray[np.float64], geometry: Enclosure
) -> tuple[Barriers, NDArray[np.float64]]:
    """Barriers, and positions (n, 2) [length] of which those in a wall were moved to the nearest clear place."""
    walls = barriers(geometry, float(radius.max()), stops_all)
    firm = geometry
    for number, wall in enumerate(geometry.walls):
        if not stops_all(wall):
            firm = firm.with_wall(number, passes=Passage())
    clear = position.copy()
    for row in range(len(position)):
        x, y = position[row]
        if is_clear(walls, x, y, radius[row]):
            continue
        free = room(firm, float(radius[row]) * (1 + _CLEAR))
        if not free.is_empty:
            line = shapely.shortest_line(free, shapely.Point(x, y))
            clear[row] = shapely.get_coordinates(line)[0]
    return walls, clear
