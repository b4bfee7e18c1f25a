"""What a gas is in after changes from outside."""

from __future__ import annotations

import dataclasses

from gasbox.geometry import Enclosure, Geometry, Path, Rectangle, Wall
from gasbox.state import Change, MoveWall, SetGravity, SetWall

__all__ = ["geometry_after"]


def geometry_after(geometry: Geometry, time: float, change: Change) -> Geometry:
    """The geometry after one change, for measuring: a wall that is moved counts as one that moves, on any path."""
    enclosure = (
        Enclosure(geometry, walls=tuple(Wall(name) for name in geometry.wall_names))
        if isinstance(geometry, Rectangle)
        else geometry
    )
    if isinstance(change, SetGravity):
        return dataclasses.replace(enclosure, gravity=change.gravity)
    if change.wall not in enclosure.wall_names:
        return geometry
    number = enclosure.wall_names.index(change.wall)
    if isinstance(change, MoveWall):
        still = enclosure.walls[number].motion is None
        path = Path((time,), (0.0,), (change.speed,))
        return enclosure.with_wall(number, motion=path) if still else enclosure
    assert isinstance(change, SetWall)
    new = {"present": change.present, "temperature": change.temperature}
    return enclosure.with_wall(number, **{key: value for key, value in new.items() if value is not None})
