"""What discs can touch: straight sides, corners and posts, and the rim of a circle.

A disc of radius R touches a side when its centre is R from the line and the foot of the perpendicular lies on the side;
a corner when its centre is R away. Together they bound exactly the region that centres can reach.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Block, Circle, Obstacle, Point, Polygon, Post, Segment

__all__ = ["Element", "ElementKind", "container_elements", "obstacle_elements", "side_count", "side_names"]

_MARGIN = 1e-9
"""Of the length of a side, beyond an end at which no corner is needed."""


class ElementKind(IntEnum):
    """How a disc meets an element."""

    SIDE = 0
    CORNER = 1
    RIM = 2


@dataclass(frozen=True)
class Element:
    """One thing that a disc can touch.

    Attributes
    ----------
    kind : side, corner (or post), or rim of a circle seen from inside
    wall : index of the wall that it belongs to
    place : start of a side, centre of a corner or rim [length]
    tangent, normal : unit vectors of a side; the normal is that along which displacements of the wall count, also of
        corners and posts
    low, high : where the foot of a perpendicular may lie on a side, from its start [length]
    radius : of a post or rim [length]; 0 for a corner
    faces : +1 if only its front (where the normal points) can be touched, -1 if only its back, 0 for both
    """

    kind: ElementKind
    wall: int
    place: Point
    tangent: Point = (0.0, 0.0)
    normal: Point = (0.0, 0.0)
    low: float = 0.0
    high: float = 0.0
    radius: float = 0.0
    faces: int = 0


def side_names(container: Rectangle | Circle | Polygon) -> tuple[str, ...]:
    """Names of the walls of a container, in the order of their indices."""
    match container:
        case Rectangle():
            return Rectangle.WALLS
        case Circle():
            return ("rim",)
        case Polygon(vertices=vertices):
            return tuple(f"side-{number + 1}" for number in range(len(vertices)))


def side_count(container: Rectangle | Circle | Polygon) -> int:
    """How many walls a container has."""
    return len(side_names(container))


def container_elements(container: Rectangle | Circle | Polygon) -> Iterator[Element]:
    """All elements of a container; its walls are numbered from 0."""
    match container:
        case Rectangle():
            yield from _box(container)
        case Circle(radius=radius):
            yield Element(ElementKind.RIM, 0, container.center, radius=radius, faces=1)
        case Polygon(vertices=vertices):
            yield from _ring(vertices, range(len(vertices)), inside=True)


def obstacle_elements(obstacle: Obstacle, wall: int, anchored: tuple[bool, bool]) -> Iterator[Element]:
    """All elements of an obstacle with this index of wall; `anchored`: which ends of a segment need no corner."""
    match obstacle:
        case Post(center=center, radius=radius, direction=direction):
            yield Element(ElementKind.CORNER, wall, center, normal=direction, radius=radius)
        case Block(vertices=vertices):
            yield from _ring(vertices, [wall] * len(vertices), inside=False)
        case Segment(start=start, end=end):
            margin = _MARGIN * obstacle.length
            low = -margin if anchored[0] else 0.0
            high = obstacle.length + (margin if anchored[1] else 0.0)
            normal = obstacle.normal
            tangent = (-normal[1], normal[0])
            yield Element(ElementKind.SIDE, wall, start, tangent, normal, low, high)
            for corner, held in zip((start, end), anchored, strict=True):
                if not held:
                    # The normal tells along which way the corner moves with its wall.
                    yield Element(ElementKind.CORNER, wall, corner, normal=normal)


def _box(box: Rectangle) -> Iterator[Element]:
    """The sides of a rectangle have no ends: where they meet, no centre can come."""
    sides: list[tuple[Point, Point, int]] = []
    if not box.periodic_x:
        sides += [((0.0, 0.0), (1.0, 0.0), 0), ((box.width, 0.0), (1.0, 0.0), 1)]
    if not box.periodic_y:
        sides += [((0.0, 0.0), (0.0, 1.0), 2), ((0.0, box.height), (0.0, 1.0), 3)]
    for place, normal, wall in sides:
        tangent = (-normal[1], normal[0])
        faces = 1 if wall % 2 == 0 else -1
        yield Element(ElementKind.SIDE, wall, place, tangent, normal, -math.inf, math.inf, faces=faces)


def _ring(vertices: tuple[Point, ...], walls: range | list[int], inside: bool) -> Iterator[Element]:
    """Sides and corners of a polygon that runs counter-clockwise, touched from inside or from outside."""
    corner = np.array(vertices, np.float64)
    along = np.roll(corner, -1, axis=0) - corner
    length = np.hypot(along[:, 0], along[:, 1])
    tangent = along / length[:, None]
    before = np.roll(tangent, 1, axis=0)
    turn = before[:, 0] * tangent[:, 1] - before[:, 1] * tangent[:, 0]
    # A corner can be touched if it sticks out towards the discs, or is flat (its sides may differ).
    touched = turn < 1e-12 if inside else turn > -1e-12
    for k, wall in enumerate(walls):
        after = (k + 1) % len(vertices)
        tx, ty = (float(part) for part in tangent[k])
        normal = (-ty, tx) if inside else (ty, -tx)
        margin = _MARGIN * float(length[k])
        low = 0.0 if touched[k] else -margin
        high = float(length[k]) + (0.0 if touched[after] else margin)
        place = (float(corner[k, 0]), float(corner[k, 1]))
        yield Element(ElementKind.SIDE, wall, place, (tx, ty), normal, low, high, faces=1)
        if touched[k]:
            yield Element(ElementKind.CORNER, wall, place)
