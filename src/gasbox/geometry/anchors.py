"""Which ends of a segment stand on something, so that no disc can touch them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import affinity
from shapely.geometry.base import BaseGeometry

from gasbox.geometry.elements import side_count
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Circle, Point, Polygon, Segment
from gasbox.geometry.solids import Surroundings, blocks, images, shape_of

__all__ = ["anchored", "glides"]

_MARGIN: Final = 1e-9
"""Of the box: so near, an end stands on a wall."""


def anchored(enclosure: Surroundings, number: int) -> tuple[bool, bool]:
    """For both ends of a segment, whether it stands on a wall that is there, nobody passes and does not move.

    Where two segments meet end to end, discs can touch the end unless one goes straight on in the other. An end on a
    periodic edge goes on in whatever is on the other side.
    """
    segment = enclosure.obstacles[number]
    assert isinstance(segment, Segment)
    first, second = segment.start, segment.end
    return _held(enclosure, number, first, second), _held(enclosure, number, second, first)


def _held(enclosure: Surroundings, number: int, end: Point, other: Point) -> bool:
    moves = enclosure.walls[side_count(enclosure.container) + number].motion is not None
    if moves and not isinstance(enclosure.container, Rectangle):
        # It may glide beyond the end of the side on which it stands.
        return False
    on_sides = any(_firm(enclosure, wall) for wall in _sides_at(enclosure, end))
    # What moves goes on in nothing but itself, across a periodic edge.
    return on_sides or any(_stands_on(enclosure, number, end, other, only_itself=moves))


def glides(enclosure: Surroundings, number: int, end: Point) -> bool:
    """Whether an end of a segment that moves stands nowhere, or on something straight along its normal."""
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    first = side_count(enclosure.container)
    point = shapely.Point(end)
    touched = [_side_line(enclosure, wall) for wall in _sides_at(enclosure, end)]
    for index, obstacle in enumerate(enclosure.obstacles):
        if index == number or not blocks(enclosure.walls[first + index]):
            continue
        shape, radius = shape_of(obstacle)
        if shape.distance(point) <= radius + margin:
            touched += [None] if radius else _lines(shape)
    along = np.array(enclosure.normal(first + number))
    near = [line for line in touched if line is None or shapely.LineString(line).distance(point) <= margin]
    return not touched or any(line is not None and _parallel(line, along) for line in near)


def _lines(shape: BaseGeometry) -> list[NDArray[np.float64] | None]:
    """Straight pieces, (2, 2) [length] each, of a line or of the border of a polygon."""
    places = shapely.get_coordinates(shape)
    return [places[k : k + 2] for k in range(len(places) - 1)]


def _side_line(enclosure: Surroundings, wall: int) -> NDArray[np.float64] | None:
    match enclosure.container:
        case Rectangle(width=width, height=height):
            ends = ((0.0, 0.0), (0.0, height)), ((width, 0.0), (width, height))
            return np.array((*ends, ((0.0, 0.0), (width, 0.0)), ((0.0, height), (width, height)))[wall])
        case Polygon(vertices=vertices):
            return np.array([vertices[wall], vertices[(wall + 1) % len(vertices)]])
        case Circle():
            return None


def _parallel(line: NDArray[np.float64], along: NDArray[np.float64]) -> bool:
    way = line[1] - line[0]
    return bool(abs(way[0] * along[1] - way[1] * along[0]) <= _MARGIN * np.hypot(*way))


def _sides_at(enclosure: Surroundings, end: Point) -> list[int]:
    """Walls of the container on which this end stands."""
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    x, y = end
    match enclosure.container:
        case Rectangle(width=width, height=height, periodic_x=periodic_x, periodic_y=periodic_y):
            away = {0: abs(x), 1: abs(x - width)} if not periodic_x else {}
            away |= {2: abs(y), 3: abs(y - height)} if not periodic_y else {}
        case Circle(radius=radius) as container:
            away = {0: abs(float(np.hypot(x - container.center[0], y - container.center[1])) - radius)}
        case Polygon(vertices=vertices):
            corners = np.array(vertices)
            sides = shapely.linestrings(np.stack([corners, np.roll(corners, -1, axis=0)], axis=1))
            away = dict(enumerate(shapely.distance(sides, shapely.Point(end)).tolist()))
    return [wall for wall, distance in away.items() if distance <= margin]


def _stands_on(
    enclosure: Surroundings, number: int, end: Point, other: Point, only_itself: bool
) -> Iterator[bool]:
    """For each obstacle and image near this end, whether it holds it."""
    first = side_count(enclosure.container)
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    along = np.subtract(end, other) / np.hypot(*np.subtract(end, other))
    point = shapely.Point(end)
    for index, obstacle in enumerate(enclosure.obstacles):
        if (index != number) if only_itself else not _firm(enclosure, first + index):
            continue
        whole, radius = shape_of(obstacle)
        for dx, dy in images(enclosure):
            if index == number and dx == dy == 0.0:
                continue
            shape = affinity.translate(whole, dx, dy)
            if shape.distance(point) > radius + margin:
                continue
            if not isinstance(obstacle, Segment):
                yield True
                continue
            ends = np.array(shape.coords)
            away = np.hypot(*(ends - end).T)
            if away.min() > margin:
                yield True
            else:
                onward = ends[int(away.argmax())] - end
                yield bool(np.hypot(*(onward / np.hypot(*onward) - along)) < _MARGIN)


def _firm(enclosure: Surroundings, wall: int) -> bool:
    """Whether a wall is there, stops everybody, and stays where it is."""
    entry = enclosure.walls[wall]
    return entry.present and not entry.open and entry.passes is None and entry.motion is None
