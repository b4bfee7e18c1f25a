"""Whether container and obstacles are shapes that fit into each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from gasbox.errors import Problem
from gasbox.geometry import Block, Circle, Polygon, Post, Rectangle, Segment
from gasbox.scenario.container import Container, PolygonContainer
from gasbox.scenario.obstacles import BlockObstacle, Obstacle, PostObstacle, SegmentObstacle
from gasbox.scenario.outlines import outline_problems
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import short

__all__ = ["container_problems", "obstacle_problems", "sticks_out"]

_MARGIN: Final = 1e-9
"""Of the container: what sticks out by less only touches."""


def container_problems(container: Container | None) -> list[Problem]:
    """A polygon that crosses itself, or lies beyond the axes."""
    if not isinstance(container, PolygonContainer):
        return []
    problems = outline_problems("container.vertices", container.vertices)
    least = np.array(container.vertices).min(axis=0)
    if (least < 0).any():
        dx, dy = np.maximum(-least, 0.0)
        found = f"coordinates down to [{least[0]:g}, {least[1]:g}]"
        problems.append(
            Problem("container.vertices", found, f"none may be below 0: shift all by [{dx:g}, {dy:g}]")
        )
    return problems


def obstacle_problems(parts: Parts) -> Iterator[Problem]:
    """Obstacles without extent, that cross themselves, or stick out of the container."""
    shape = None
    if parts.container is not None and not container_problems(parts.container):
        shape = parts.container.geometry()
    for number, obstacle in enumerate(parts.obstacles):
        if obstacle is None:
            continue
        wrong = list(_by_itself(f"obstacles[{number}]", obstacle))
        yield from wrong
        if shape is not None and not wrong and sticks_out(shape, obstacle.geometry()):
            yield Problem(
                _place(f"obstacles[{number}]", obstacle),
                _where(obstacle),
                f"must lie inside the container{_extent(shape)}; touching its walls is fine",
            )


def sticks_out(container: Rectangle | Circle | Polygon, obstacle: Segment | Block | Post) -> bool:
    """Whether an obstacle reaches beyond the container. A post may stand across a periodic edge.

    One that can move only has to reach into a rectangle.
    """
    corners, radius = _corners(obstacle)
    match container:
        case Circle(radius=whole) as circle:
            away = np.hypot(*(corners - circle.center).T).max() + radius
            return bool(away > whole * (1 + 2 * _MARGIN))
        case Rectangle() as box if isinstance(obstacle, Post) and obstacle.direction != (0.0, 0.0):
            # It may be a cap on a side, moving along it.
            nearest = np.clip(corners, 0.0, box.size)
            return bool(np.hypot(*(nearest - corners).T).max() >= radius)
        case Rectangle() as box:
            margin = _MARGIN * max(box.width, box.height)
            beyond = np.where(box.periodic, 0.0, radius)
            out = (corners < beyond - margin) | (corners > box.size - beyond + margin)
            around = box.periodic & (2 * radius > box.size)
            return bool(out.any() or around.any())
        case Polygon(vertices=vertices):
            outline = shapely.Polygon(vertices)
            margin = _MARGIN * float(np.max(vertices))
            shape = _shape(obstacle, corners)
            if not outline.buffer(margin, join_style="mitre").covers(shape):
                return True
            return bool(radius and outline.boundary.distance(shape) < radius - margin)


def _corners(obstacle: Segment | Block | Post) -> tuple[NDArray[np.float64], float]:
    """Corners (n, 2) [length], and the radius [length] of a post."""
    match obstacle:
        case Segment(start=start, end=end):
            return np.array([start, end]), 0.0
        case Block(vertices=vertices):
            return np.array(vertices), 0.0
        case Post(center=center, radius=radius):
            return np.array([center]), radius


def _shape(obstacle: Segment | Block | Post, corners: NDArray[np.float64]) -> BaseGeometry:
    if isinstance(obstacle, Block):
        return shapely.Polygon(corners)
    return shapely.LineString(corners) if isinstance(obstacle, Segment) else shapely.Point(corners[0])


def _by_itself(path: str, obstacle: Obstacle) -> Iterator[Problem]:
    if isinstance(obstacle, SegmentObstacle) and obstacle.start == obstacle.end:
        yield Problem(f"{path}.end", short(list(obstacle.end)), "must differ from start")
    if isinstance(obstacle, BlockObstacle):
        yield from outline_problems(f"{path}.vertices", obstacle.vertices)


def _place(path: str, obstacle: Obstacle) -> str:
    return f"{path}.vertices" if isinstance(obstacle, BlockObstacle) else path


def _where(obstacle: Obstacle) -> str:
    match obstacle:
        case SegmentObstacle(start=start, end=end):
            return f"a segment from [{start[0]:g}, {start[1]:g}] to [{end[0]:g}, {end[1]:g}]"
        case PostObstacle(center=center, radius=radius):
            return f"a disc of radius {radius:g} at [{center[0]:g}, {center[1]:g}]"
        case BlockObstacle(vertices=vertices):
            left, bottom = np.min(vertices, axis=0)
            right, top = np.max(vertices, axis=0)
            return f"a polygon over [{left:g}, {right:g}] x [{bottom:g}, {top:g}]"


def _extent(container: Rectangle | Circle | Polygon) -> str:
    match container:
        case Rectangle(width=width, height=height):
            return f", [0, {width:g}] x [0, {height:g}]"
        case Circle(radius=radius):
            return f", a circle of radius {radius:g} around [{radius:g}, {radius:g}]"
        case Polygon():
            return ""
