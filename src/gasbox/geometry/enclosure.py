"""A container with everything in it that discs can touch, and the gravity they feel."""

from __future__ import annotations

import functools
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import anchors, region
from gasbox.geometry.elements import Element, container_elements, obstacle_elements, side_count
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Circle, Obstacle, Point, Polygon, Post, Segment
from gasbox.geometry.wall import Wall

__all__ = ["Container", "Enclosure"]

Container = Rectangle | Circle | Polygon


@dataclass(frozen=True)
class Enclosure:
    """Container, obstacles, walls and gravity. Everything is as at the start: walls that move are displaced from here.

    Attributes
    ----------
    container : the outer boundary
    obstacles : what stands in it
    walls : all walls: first those of the container in the order of its sides, then one for each obstacle
    gravity : acceleration of all discs [length/time²]
    displacement : of each wall along its normal, for areas and lengths [length]; empty if none moves
    """

    container: Container
    obstacles: tuple[Obstacle, ...] = ()
    walls: tuple[Wall, ...] = ()
    gravity: Point = (0.0, 0.0)
    displacement: tuple[float, ...] = field(default=())

    # -- size ------------------------------------------------------------------------------------------

    @property
    def width(self) -> float:
        """Of the box [0, width] x [0, height] around it, walls at their start [length]."""
        return self._extent[0]

    @property
    def height(self) -> float:
        """See `width` [length]."""
        return self._extent[1]

    @functools.cached_property
    def _extent(self) -> tuple[float, float]:
        match self.container:
            case Rectangle(width=width, height=height):
                return width, height
            case Circle(radius=radius):
                return 2 * radius, 2 * radius
            case Polygon(vertices=vertices):
                return max(x for x, _ in vertices), max(y for _, y in vertices)

    @property
    def size(self) -> NDArray[np.float64]:
        """(2,) float64 [length]: width, height."""
        return np.array(self._extent)

    @property
    def periodic_x(self) -> bool:
        """Whether a disc that leaves on the right comes back on the left."""
        return isinstance(self.container, Rectangle) and self.container.periodic_x

    @property
    def periodic_y(self) -> bool:
        """Whether a disc that leaves above comes back below."""
        return isinstance(self.container, Rectangle) and self.container.periodic_y

    @property
    def periodic(self) -> NDArray[np.bool_]:
        """(2,) bool: periodic in x, in y."""
        return np.array([self.periodic_x, self.periodic_y])

    # -- walls -----------------------------------------------------------------------------------------

    @property
    def wall_names(self) -> tuple[str, ...]:
        """In the order of the indices."""
        return tuple(wall.name for wall in self.walls)

    @property
    def is_walled(self) -> bool:
        """Whether there is any wall at all."""
        return bool(self.elements)

    @property
    def moves(self) -> bool:
        """Whether any wall moves."""
        return any(wall.motion is not None for wall in self.walls)

    @functools.cached_property
    def elements(self) -> tuple[Element, ...]:
        """What discs can touch, of walls that are present, as at the start."""
        found = list(container_elements(self.container))
        first = side_count(self.container)
        for number, obstacle in enumerate(self.obstacles):
            if self.walls[first + number].present:
                found += obstacle_elements(obstacle, first + number, self._anchored(number))
        return tuple(found)

    def _anchored(self, number: int) -> tuple[bool, bool]:
        """Which ends of a segment stand on the boundary or in another obstacle, so that nothing can touch them."""
        obstacle = self.obstacles[number]
        if not isinstance(obstacle, Segment):
            return (True, True)
        return anchors.anchored(self, number)

    def normal(self, wall: int) -> Point:
        """Direction of the displacements of a wall that can move: a side of a rectangle, a segment, or a post."""
        number = wall - side_count(self.container)
        if number < 0:
            return (1.0, 0.0) if wall < 2 else (0.0, 1.0)
        match self.obstacles[number]:
            case Segment(normal=normal):
                return normal
            case Post(direction=direction):
                return direction
        return (0.0, 0.0)

    def length(self, wall: int) -> float:
        """Length of a wall [length]; of an obstacle, all around."""
        return region.wall_length(self, wall)

    def with_wall(self, wall: int, **changes: object) -> Enclosure:
        """The same with one wall changed."""
        walls = list(self.walls)
        walls[wall] = replace(walls[wall], **changes)  # type: ignore[arg-type]
        return replace(self, walls=tuple(walls))

    def at(self, displacement: NDArray[np.float64]) -> Enclosure:
        """The same with its walls displaced, for areas and lengths. (walls,) [length]; empty for none."""
        if not displacement.size or not np.any(displacement):
            return self if not self.displacement else replace(self, displacement=())
        return replace(self, displacement=tuple(displacement.tolist()))

    # -- regions ---------------------------------------------------------------------------------------

    @property
    def area(self) -> float:
        """Whole area, without that of blocks and posts [length²]."""
        # The way in which a wall moves makes no difference to it, and there is a new one with each change.
        still = tuple(replace(wall, motion=None) for wall in self.walls) if self.moves else self.walls
        return region.area(replace(self, walls=still) if self.moves else self)

    def accessible_area(self, radius: float) -> float:
        """Area [length²] that centres of discs of this radius can reach."""
        return region.accessible_area(self, radius)

    def accessible_size(self, radius: float) -> tuple[float, float]:
        """Width and height [length] of the region that centres can reach; 0 and 0 if they can reach nothing."""
        return region.accessible_size(self, radius)

    def accessible_length(self, wall: int, radius: float) -> float:
        """Length [length] of a wall along which centres of this radius can touch it, both faces of a segment."""
        return region.accessible_length(self, wall, radius)

    def holds(self, position: NDArray[np.float64], radius: NDArray[np.float64] | float) -> NDArray[np.bool_]:
        """(n,) bool: whether each disc lies clear of all walls; pass radius 0 to ask for centres only."""
        return region.holds(self, position, radius)

    def wrap(self, position: NDArray[np.float64]) -> NDArray[np.float64]:
        """Positions (n, 2) [length] moved into the box along its periodic directions."""
        if isinstance(self.container, Rectangle):
            return self.container.wrap(position)
        return position.copy()
