"""From the sections of a scenario to the geometry that engines and observers work with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gasbox.geometry import Enclosure, Geometry, Rectangle, side_names
from gasbox.scenario.container import Container
from gasbox.scenario.obstacles import Obstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.walls import WallSettings

__all__ = ["geometry_of", "surroundings"]


def geometry_of(
    container: Container,
    walls: Mapping[str, WallSettings],
    obstacles: Sequence[Obstacle],
    gravity: tuple[float, float],
    names: Sequence[str],
) -> Geometry:
    """The plain rectangle if there is nothing else to it, otherwise the whole enclosure; `names` of all species."""
    shape = container.geometry()
    if isinstance(shape, Rectangle) and not walls and not obstacles and gravity == (0.0, 0.0):
        return shape
    found = [
        walls.get(side, WallSettings()).wall(walls[side].name or side if side in walls else side, names)
        for side in side_names(shape)
    ]
    found += [
        obstacle.wall(obstacle.name or f"obstacle-{number}", names, obstacle.present)
        for number, obstacle in enumerate(obstacles, 1)
    ]
    return Enclosure(shape, tuple(obstacle.geometry() for obstacle in obstacles), tuple(found), gravity)


def surroundings(parts: Parts) -> Geometry:
    """The geometry of parts that are all valid."""
    assert parts.container is not None
    walls = {side: settings for side, settings in parts.walls.items() if settings is not None}
    standing = [obstacle for obstacle in parts.obstacles if obstacle is not None]
    return geometry_of(parts.container, walls, standing, parts.gravity or (0.0, 0.0), parts.names or ())
