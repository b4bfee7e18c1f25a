"""Containers and obstacles of every shape, as plain data; a rectangle has its own file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Block",
    "Circle",
    "Obstacle",
    "Point",
    "Polygon",
    "Post",
    "Segment",
    "regular_polygon",
    "signed_area",
]

Point = tuple[float, float]


@dataclass(frozen=True)
class Circle:
    """A circular container, with its centre at (radius, radius).

    Attributes
    ----------
    radius : [length]
    """

    radius: float

    @property
    def center(self) -> Point:
        """[length]."""
        return (self.radius, self.radius)


@dataclass(frozen=True)
class Polygon:
    """A container inside a simple polygon, convex or not.

    Attributes
    ----------
    vertices : (n, 2) counter-clockwise [length], no coordinate below 0; side k leads from vertex k to the next
    """

    vertices: tuple[Point, ...]


@dataclass(frozen=True)
class Segment:
    """A wall with two sides. Its normal points to the right of the way from `start` to `end`.

    Attributes
    ----------
    start, end : [length]
    """

    start: Point
    end: Point

    @property
    def normal(self) -> Point:
        """Unit vector; of a divider from bottom to top it points along +x."""
        dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        length = float(np.hypot(dx, dy))
        return (dy / length, -dx / length)

    @property
    def length(self) -> float:
        """[length]."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


@dataclass(frozen=True)
class Block:
    """A filled polygon.

    Attributes
    ----------
    vertices : (n, 2) counter-clockwise [length]
    """

    vertices: tuple[Point, ...]


@dataclass(frozen=True)
class Post:
    """A disc that stands, or moves along one direction.

    Attributes
    ----------
    center : [length]
    radius : [length]
    direction : unit vector along which it can move; (0, 0) if it cannot
    """

    center: Point
    radius: float
    direction: Point = (0.0, 0.0)


Obstacle = Segment | Block | Post


def signed_area(vertices: tuple[Point, ...]) -> float:
    """Area [length²] of a polygon, positive if its vertices run counter-clockwise."""
    corner: NDArray[np.float64] = np.array(vertices, np.float64)
    after = np.roll(corner, -1, axis=0)
    return 0.5 * float(np.sum(corner[:, 0] * after[:, 1] - after[:, 0] * corner[:, 1]))


def regular_polygon(sides: int, radius: float, rotation: float = 0.0) -> tuple[Point, ...]:
    """Corners on a circle of `radius` [length], from angle `rotation` [radian] on, moved to the axes."""
    angle = rotation + 2.0 * np.pi * np.arange(sides) / sides
    corner = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    corner -= corner.min(axis=0)
    return tuple((float(x), float(y)) for x, y in corner)
