"""The shapes of an enclosure for shapely: where discs are, and what stands in their way."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, Protocol

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import affinity
from shapely.geometry.base import BaseGeometry

from gasbox.geometry.elements import Element, side_count
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Block, Circle, Obstacle, Point, Polygon, Post, Segment
from gasbox.geometry.wall import Wall, lets_everybody_pass

__all__ = [
    "QUADRANT",
    "Solid",
    "Surroundings",
    "blocked",
    "blocks",
    "box",
    "disc",
    "images",
    "outline",
    "reach",
    "shifted",
    "solids",
    "within",
]

QUADRANT: Final = 256
"""Chords of a quarter circle. The area of an arc with its radius r is so short of 4e-6 r² at most."""
_CHORDS: Final = 4 * QUADRANT
_SWELL: Final = math.sqrt(math.pi / (_CHORDS / 2 * math.sin(2 * math.pi / _CHORDS)))
"""A polygon of so many chords has the area of its disc if its corners lie so much farther out."""


class Surroundings(Protocol):
    """What areas and lengths follow from; `Enclosure` is it."""

    @property
    def container(self) -> Rectangle | Circle | Polygon:
        """The outer boundary."""

    @property
    def obstacles(self) -> tuple[Obstacle, ...]:
        """What stands in it."""

    @property
    def walls(self) -> tuple[Wall, ...]:
        """Sides of the container, then obstacles."""

    @property
    def displacement(self) -> tuple[float, ...]:
        """Of each wall along its normal [length]; empty if none moves."""

    @property
    def width(self) -> float:
        """Of the box around it [length]."""

    @property
    def height(self) -> float:
        """Of the box around it [length]."""

    @property
    def elements(self) -> tuple[Element, ...]:
        """What discs can touch, as at the start."""

    def normal(self, wall: int) -> Point:
        """Direction of displacements."""

    def __hash__(self) -> int:
        """By value: what was worked out is kept for it."""


@dataclass(frozen=True)
class Solid:
    """Something that keeps centres at a distance.

    Attributes
    ----------
    wall : its index
    shape : a line, a polygon, or the centre of a post
    radius : of a post [length]; otherwise 0
    """

    wall: int
    shape: BaseGeometry
    radius: float = 0.0


def blocks(wall: Wall) -> bool:
    """Whether a wall stands in the way of anybody: it is there, and not a line that all pass."""
    return wall.present and not lets_everybody_pass(wall.passes)


def reach(wall: Wall, radius: float) -> float:
    """How near to a wall a disc of this radius can come [length]: the centre itself reaches an open wall."""
    return 0.0 if wall.open else radius


def shift(enclosure: Surroundings, wall: int) -> Point:
    """By how much a wall is displaced [length]."""
    if not enclosure.displacement:
        return (0.0, 0.0)
    way, (nx, ny) = enclosure.displacement[wall], enclosure.normal(wall)
    return (way * nx, way * ny)


def shifted(enclosure: Surroundings, number: int) -> Obstacle:
    """An obstacle where it is now."""
    obstacle = enclosure.obstacles[number]
    dx, dy = shift(enclosure, side_count(enclosure.container) + number)
    if dx == 0.0 and dy == 0.0:
        return obstacle
    match obstacle:
        case Segment(start=(ax, ay), end=(bx, by)):
            return Segment((ax + dx, ay + dy), (bx + dx, by + dy))
        case Post(center=(x, y), radius=radius, direction=direction):
            return Post((x + dx, y + dy), radius, direction)
        case Block():
            return obstacle


def box(enclosure: Surroundings, container: Rectangle) -> tuple[float, float, float, float]:
    """Left, right, lower and upper end [length] of a rectangle whose sides may be displaced."""
    left, right, bottom, top = enclosure.displacement[:4] or (0.0, 0.0, 0.0, 0.0)
    return left, container.width + right, bottom, container.height + top


def disc(center: Point, radius: float) -> BaseGeometry:
    """A disc, as a polygon of the same area."""
    if radius <= 0:
        return shapely.Polygon()
    return shapely.Point(center).buffer(radius * _SWELL, quad_segs=QUADRANT)


def outline(enclosure: Surroundings) -> BaseGeometry:
    """The inside of the container, with displaced sides where they are; empty if they have passed each other."""
    match enclosure.container:
        case Rectangle() as container:
            left, right, bottom, top = box(enclosure, container)
            return (
                shapely.box(left, bottom, right, top) if left < right and bottom < top else shapely.Polygon()
            )
        case Circle(radius=radius) as container:
            return disc(container.center, radius)
        case Polygon(vertices=vertices):
            return shapely.Polygon(vertices)


def images(enclosure: Surroundings) -> Iterator[Point]:
    """Shifts [length] to an obstacle and to its periodic images next to the box; the obstacle itself comes first."""
    container = enclosure.container
    across = container.periodic_x if isinstance(container, Rectangle) else False
    upwards = container.periodic_y if isinstance(container, Rectangle) else False
    turns = itertools.product((0, -1, 1) if across else (0,), (0, -1, 1) if upwards else (0,))
    for column, row in turns:
        yield column * enclosure.width, row * enclosure.height


def shape_of(obstacle: Obstacle) -> tuple[BaseGeometry, float]:
    """A line, a polygon or the centre of a post, and the radius of the post [length]."""
    match obstacle:
        case Segment(start=start, end=end):
            return shapely.LineString([start, end]), 0.0
        case Block(vertices=vertices):
            return shapely.Polygon(vertices), 0.0
        case Post(center=center, radius=radius):
            return shapely.Point(center), radius


def solids(enclosure: Surroundings) -> list[Solid]:
    """All obstacles that block, with their periodic images, and the sides of a polygon."""
    found = []
    first = side_count(enclosure.container)
    for number in range(len(enclosure.obstacles)):
        if not blocks(enclosure.walls[first + number]):
            continue
        shape, radius = shape_of(shifted(enclosure, number))
        found += [
            Solid(first + number, affinity.translate(shape, dx, dy) if dx or dy else shape, radius)
            for dx, dy in images(enclosure)
        ]
    if isinstance(enclosure.container, Polygon):
        corners = enclosure.container.vertices
        ends = (*corners[1:], corners[0])
        found += [
            Solid(wall, shapely.LineString([start, end]))
            for wall, (start, end) in enumerate(zip(corners, ends, strict=True))
        ]
    return found


def within(
    enclosure: Surroundings, position: NDArray[np.float64], radius: NDArray[np.float64], margin: float
) -> NDArray[np.bool_]:
    """(n,) bool: inside the container, and clear of the sides of a rectangle and of a rim, but for `margin` [length].

    Parameters
    ----------
    position : (n, 2) [length]
    radius : (n,) [length]
    """
    x, y = position[:, 0], position[:, 1]
    match enclosure.container:
        case Circle(radius=size) as container:
            away = np.asarray(np.hypot(x - container.center[0], y - container.center[1]))
            return away <= size - (0.0 if enclosure.walls[0].open else radius) + margin
        case Polygon():
            shape = outline(enclosure)
            shapely.prepare(shape)
            inside = np.asarray(shapely.contains_xy(shape, x, y))
            edge = np.flatnonzero(~inside)
            inside[edge] = shapely.dwithin(shape, shapely.points(position[edge]), margin)
            return inside
        case Rectangle() as container:
            inside = np.ones(position.shape[0], np.bool_)
            ends = box(enclosure, container)
            for wall, (way, sign) in enumerate(((x, 1.0), (x, -1.0), (y, 1.0), (y, -1.0))):
                if not (container.periodic_x if wall < 2 else container.periodic_y):
                    near = 0.0 if enclosure.walls[wall].open else radius
                    inside &= sign * (way - ends[wall]) >= near - margin
            return inside


def blocked(
    found: list[Solid], walls: tuple[Wall, ...], position: NDArray[np.float64], radius: float, margin: float
) -> NDArray[np.bool_]:
    """(n,) bool: which discs at these positions (n, 2) [length] overlap any of these by more than `margin` [length]."""
    hit = np.zeros(position.shape[0], np.bool_)
    if not found or not position.shape[0]:
        return hit
    distance = np.array([solid.radius + reach(walls[solid.wall], radius) - margin for solid in found])
    # With no distance to keep, only the inside of a block is out of bounds.
    shapes = [
        solid.shape if way > 0 else solid.shape.buffer(-margin)
        for solid, way in zip(found, distance, strict=True)
    ]
    tree = shapely.STRtree(shapely.points(position))
    _, points = tree.query(np.array(shapes, object), predicate="dwithin", distance=np.maximum(distance, 0.0))
    hit[points] = True
    return hit
