"""What a browser needs to draw the surroundings of the gas: container, walls, obstacles, gravity, as JSON values.

The drawing side is ``frontend/core/outline.js``; what each key means stands in `gasbox.app.protocol`.
"""

from __future__ import annotations

import math
from typing import Any

from gasbox.app.reins import movable
from gasbox.geometry import (
    Block,
    Circle,
    Enclosure,
    Geometry,
    Motion,
    Obstacle,
    Path,
    Piston,
    Polygon,
    Post,
    Rectangle,
    Segment,
    Sinusoid,
    side_count,
)

__all__ = ["outline"]

_PLAIN: dict[str, Any] = {"line": "solid", "temperature": None, "motion": None, "present": True}


def outline(geometry: Geometry, *, handles: bool = True) -> dict[str, Any]:
    """The parts ``container``, ``walls``, ``obstacles`` and ``gravity`` of a table message.

    Parameters
    ----------
    handles : whether walls can be dragged at all
    """
    enclosure = geometry if isinstance(geometry, Enclosure) else None
    return {
        "container": _container(geometry),
        "walls": [{"name": name, **_PLAIN} for name in geometry.wall_names]
        if enclosure is None
        else [_wall(enclosure, number, handles) for number in range(len(enclosure.walls))],
        "obstacles": [] if enclosure is None else _obstacles(enclosure),
        "gravity": list(geometry.gravity),
    }


def _container(geometry: Geometry) -> dict[str, Any]:
    box = {
        "width": geometry.width,
        "height": geometry.height,
        "periodic": [bool(geometry.periodic_x), bool(geometry.periodic_y)],
    }
    match geometry.container if isinstance(geometry, Enclosure) else geometry:
        case Circle(radius=radius):
            return {"shape": "circle", **box, "radius": radius}
        case Polygon(vertices=vertices):
            return {"shape": "polygon", **box, "vertices": [list(vertex) for vertex in vertices]}
        case Rectangle():
            return {"shape": "rectangle", **box}


def _wall(enclosure: Enclosure, number: int, handles: bool) -> dict[str, Any]:
    handles = handles and movable(enclosure, number)
    wall = enclosure.walls[number]
    line = "dashed" if wall.open else "solid" if wall.passes is None else "dotted"
    shown: dict[str, Any] = {
        "name": wall.name,
        "line": line,
        "temperature": wall.temperature,
        "motion": None,
        "present": wall.present,
    }
    if wall.passes is not None and wall.passes.ways.count(None) == 1:
        shown["way"] = "forward" if wall.passes.ways[0] else "backward"
    if _is_moving_post(enclosure, number):
        # The same whether it moves just now or not, so that the table need not be told again and again.
        return {**shown, "motion": "driven", "normal": list(enclosure.normal(number))}
    if wall.motion is not None:
        shown["motion"] = "piston" if isinstance(wall.motion, Piston) else "driven"
        shown["reach"] = list(_reach(wall.motion))
    if handles:
        shown["handle"] = True
    if wall.motion is not None or handles:
        shown["normal"] = list(enclosure.normal(number))
    return shown


def _is_moving_post(enclosure: Enclosure, number: int) -> bool:
    obstacle = number - side_count(enclosure.container)
    return (
        obstacle >= 0
        and isinstance(enclosure.obstacles[obstacle], Post)
        and enclosure.normal(number) != (0.0, 0.0)
    )


def _reach(motion: Motion) -> tuple[float, float]:
    """Least and greatest displacement that can be told beforehand [length]; always with 0 between them."""
    match motion:
        case Sinusoid(amplitude=amplitude, phase=phase):
            middle = -amplitude * math.sin(phase)
            ends = [middle - abs(amplitude), middle + abs(amplitude)]
        case Piston(lower=lower, upper=upper):
            ends = [lower, upper]
        case Path(displacements=displacements):
            ends = list(displacements)
    known = [0.0, *(end for end in ends if math.isfinite(end))]
    return min(known), max(known)


def _obstacles(enclosure: Enclosure) -> list[dict[str, Any]]:
    first = side_count(enclosure.container)
    return [
        {"wall": number, **_obstacle(obstacle)} for number, obstacle in enumerate(enclosure.obstacles, first)
    ]


def _obstacle(obstacle: Obstacle) -> dict[str, Any]:
    match obstacle:
        case Segment(start=start, end=end):
            return {"shape": "segment", "start": list(start), "end": list(end)}
        case Block(vertices=vertices):
            return {"shape": "polygon", "vertices": [list(vertex) for vertex in vertices]}
        case Post(center=center, radius=radius):
            return {"shape": "disc", "center": list(center), "radius": radius}
