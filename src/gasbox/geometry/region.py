"""Areas, lengths and regions of an enclosure."""

from __future__ import annotations

import functools
import math
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import affinity
from shapely.geometry.base import BaseGeometry

from gasbox.geometry.border import border_lengths
from gasbox.geometry.elements import side_count
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Block, Circle, Polygon, Post, Segment
from gasbox.geometry.solids import (
    QUADRANT,
    Surroundings,
    blocked,
    blocks,
    box,
    disc,
    images,
    outline,
    reach,
    shape_of,
    shifted,
    solids,
    within,
)

__all__ = [
    "accessible_area",
    "accessible_length",
    "accessible_size",
    "area",
    "components",
    "holds",
    "room",
    "wall_length",
]

_ROUNDING: Final = 1e-12
"""Of the box: a disc that overlaps a wall by less only touches it."""


def wall_length(enclosure: Surroundings, wall: int) -> float:
    """Length [length] of a wall: of a side or a segment, from end to end; of a block or post, all around."""
    number = wall - side_count(enclosure.container)
    if number >= 0:
        return _around(enclosure.obstacles[number])
    match enclosure.container:
        case Rectangle() as container:
            left, right, bottom, top = box(enclosure, container)
            return top - bottom if wall < 2 else right - left
        case Circle(radius=radius):
            return 2 * math.pi * radius
        case Polygon(vertices=vertices):
            return math.dist(vertices[wall], vertices[(wall + 1) % len(vertices)])


def _around(obstacle: Segment | Block | Post) -> float:
    if isinstance(obstacle, Post):
        return 2 * math.pi * obstacle.radius
    return obstacle.length if isinstance(obstacle, Segment) else float(shape_of(obstacle)[0].length)


@functools.lru_cache(maxsize=1024)
def area(enclosure: Surroundings) -> float:
    """Area [length²] of the container without what blocks and posts cover."""
    whole = outline(enclosure)
    standing = [
        disc(obstacle.center, obstacle.radius) if isinstance(obstacle, Post) else shape_of(obstacle)[0]
        for number, obstacle in enumerate(shifted(enclosure, n) for n in range(len(enclosure.obstacles)))
        if not isinstance(obstacle, Segment)
        and blocks(enclosure.walls[side_count(enclosure.container) + number])
    ]
    standing = [affinity.translate(shape, dx, dy) for dx, dy in images(enclosure) for shape in standing]
    covered = shapely.intersection(shapely.union_all(standing), whole).area if standing else 0.0
    return float(whole.area - covered)


@functools.lru_cache(maxsize=1024)
def room(enclosure: Surroundings, radius: float) -> BaseGeometry:
    """The region that centres of discs of this radius can reach; walls that only some pass count as walls."""
    inside = _eroded(enclosure, radius)
    first = side_count(enclosure.container)
    kept_away = [
        disc((solid.shape.x, solid.shape.y), solid.radius + away)
        if solid.radius
        else solid.shape.buffer(away, quad_segs=QUADRANT)
        for solid in solids(enclosure)
        if solid.wall >= first
        for away in (reach(enclosure.walls[solid.wall], radius),)
    ]
    return shapely.difference(inside, shapely.union_all(kept_away)) if kept_away else inside


def _eroded(enclosure: Surroundings, radius: float) -> BaseGeometry:
    """The inside of the container, all obstacles apart."""
    away = [reach(wall, radius) for wall in enclosure.walls[: side_count(enclosure.container)]]
    match enclosure.container:
        case Rectangle() as container:
            left, right, bottom, top = box(enclosure, container)
            if not container.periodic_x:
                left, right = left + away[0], right - away[1]
            if not container.periodic_y:
                bottom, top = bottom + away[2], top - away[3]
            return (
                shapely.box(left, bottom, right, top) if left < right and bottom < top else shapely.Polygon()
            )
        case Circle(radius=whole) as container:
            return disc(container.center, whole - away[0])
        case Polygon() if not any(away):
            return outline(enclosure)
        case Polygon() if all(away):
            return outline(enclosure).buffer(-radius, quad_segs=QUADRANT)
        case Polygon():
            sides = [solid for solid in solids(enclosure) if solid.wall < len(away) and away[solid.wall]]
            strips = [solid.shape.buffer(radius, quad_segs=QUADRANT) for solid in sides]
            return shapely.difference(outline(enclosure), shapely.union_all(strips))


def accessible_area(enclosure: Surroundings, radius: float) -> float:
    """Area [length²] that centres of discs of this radius can reach."""
    return float(room(enclosure, radius).area)


def accessible_size(enclosure: Surroundings, radius: float) -> tuple[float, float]:
    """Width and height [length] of the box around what centres can reach; 0 and 0 if they can reach nothing."""
    region = room(enclosure, radius)
    if region.is_empty:
        return 0.0, 0.0
    left, bottom, right, top = region.bounds
    most = math.inf
    if isinstance(enclosure.container, Circle):
        most = 2 * (enclosure.container.radius - reach(enclosure.walls[0], radius))
    return min(float(right - left), most), min(float(top - bottom), most)


def accessible_length(enclosure: Surroundings, wall: int, radius: float) -> float:
    """Length [length] of the border of the region that centres can reach, as far as it belongs to this wall."""
    return border_lengths(enclosure, radius)[wall]


@functools.lru_cache(maxsize=256)
def components(enclosure: Surroundings, radius: float) -> tuple[BaseGeometry, ...]:
    """The parts of the region that centres can reach between which they cannot pass, the leftmost first.

    Each is a polygon, or several ones that join up across a periodic edge.
    """
    parts = list(shapely.get_parts(_cut(enclosure, radius)))
    parts.sort(key=lambda part: part.bounds)
    return tuple(_joined(enclosure, parts))


def _cut(enclosure: Surroundings, radius: float) -> BaseGeometry:
    """The region, cut along lines up to which the centres themselves can come."""
    region = room(enclosure, radius)
    lines = [
        solid.shape
        for solid in solids(enclosure)
        if solid.wall >= side_count(enclosure.container)
        and solid.shape.geom_type == "LineString"
        and reach(enclosure.walls[solid.wall], radius) == 0.0
    ]
    if not lines or region.is_empty:
        return region
    net = shapely.union_all([region.boundary, *(line.intersection(region) for line in lines)])
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(net)))
    return (
        shapely.union_all([])
        if not len(faces)
        else shapely.multipolygons([face for face in faces if region.covers(face.representative_point())])
    )


def _joined(enclosure: Surroundings, parts: list[BaseGeometry]) -> list[BaseGeometry]:
    """Parts that meet across a periodic edge, as one."""
    container = enclosure.container
    if not isinstance(container, Rectangle) or not (container.periodic_x or container.periodic_y):
        return parts
    number = list(range(len(parts)))
    shifts = [(enclosure.width, 0.0)] * container.periodic_x + [
        (0.0, enclosure.height)
    ] * container.periodic_y
    for one, part in enumerate(parts):
        for dx, dy in shifts:
            image = shapely.transform(part, lambda places, way=(dx, dy): places + way)
            for other, neighbour in enumerate(parts):
                if image.intersection(neighbour).length > 0:
                    number = [number[one] if n == number[other] else n for n in number]
    groups = [
        [part for part, n in zip(parts, number, strict=True) if n == group] for group in dict.fromkeys(number)
    ]
    return [group[0] if len(group) == 1 else shapely.multipolygons(group) for group in groups]


def holds(
    enclosure: Surroundings, position: NDArray[np.float64], radius: NDArray[np.float64] | float
) -> NDArray[np.bool_]:
    """(n,) bool: whether each disc lies inside, clear of all walls that nobody passes; touching is clear.

    Parameters
    ----------
    position : (n, 2) [length]
    radius : (n,) or one for all [length]; 0 asks for centres only
    """
    margin = _ROUNDING * max(enclosure.width, enclosure.height)
    radii = np.broadcast_to(np.asarray(radius, np.float64), position.shape[:1])
    clear = within(enclosure, position, radii, margin)
    barriers = [solid for solid in solids(enclosure) if enclosure.walls[solid.wall].passes is None]
    for size in np.unique(radii) if barriers else ():
        alike = np.flatnonzero(radii == size)
        clear[alike] &= ~blocked(barriers, enclosure.walls, position[alike], float(size), margin)
    return clear
