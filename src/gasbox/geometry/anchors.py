"""Which ends of a segment stand on something, so that no disc can touch them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from shapely import affinity

from gasbox.geometry.elements import side_count
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Circle, Point, Polygon, Segment
from gasbox.geometry.solids import Surroundings, images, shape_of

__all__ = ["anchored", "stands_on_side"]

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
    return bool(stands_on_side(enclosure, end)) or any(_stands_on(enclosure, number, end, other))


def stands_on_side(enclosure: Surroundings, end: Point) -> list[int]:
    """Walls of the container that nobody passes and that are at rest, on which this end stands."""
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    x, y = end
    match enclosure.container:
        case Rectangle(width=width, height=height, periodic_x=periodic_x, periodic_y=periodic_y):
            away = {0: abs(x), 1: abs(x - width)} if not periodic_x else {}
            away |= {2: abs(y), 3: abs(y - height)} if not periodic_y else {}
        case Circle(radius=radius) as container:
            away = {0: abs(float(np.hypot(x - container.center[0], y - container.center[1])) - radius)}
        case Polygon(vertices=vertices):
            sides = [
                shapely.LineString([vertices[k], vertices[(k + 1) % len(vertices)]])
                for k in range(len(vertices))
            ]
            distance = shapely.distance(sides, shapely.Point(end))
            away = {int(k): float(distance[k]) for k in np.flatnonzero(distance <= margin)}
    return [wall for wall, distance in away.items() if distance <= margin and _firm(enclosure, wall)]


def _stands_on(enclosure: Surroundings, number: int, end: Point, other: Point) -> Iterator[bool]:
    """For each obstacle and image near this end, whether it holds it."""
    first = side_count(enclosure.container)
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    along = np.subtract(end, other) / np.hypot(*np.subtract(end, other))
    point = shapely.Point(end)
    for index, obstacle in enumerate(enclosure.obstacles):
        if not _firm(enclosure, first + index):
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
