"""What a change from outside makes of the geometry."""

from __future__ import annotations

import dataclasses

from gasbox.errors import UsageError
from gasbox.geometry import Enclosure, Gate, Geometry, Motion, Passage, Path, Piston, Rectangle, Wall
from gasbox.state import MoveWall, SetGate, SetGravity, SetWall, Surrounding, Way

__all__ = ["altered", "as_enclosure"]


def as_enclosure(geometry: Geometry) -> Enclosure:
    """The same; a plain rectangle as an enclosure."""
    if isinstance(geometry, Rectangle):
        return Enclosure(geometry, walls=tuple(Wall(name) for name in geometry.wall_names))
    return geometry


def altered(geometry: Geometry, time: float, change: Surrounding, start: Geometry) -> Geometry:
    """The geometry after a change.

    Parameters
    ----------
    time : when [time]
    change : a `MoveWall` must say from where (`origin`)
    start : the geometry of the scenario, whose pistons can go free again

    Raises
    ------
    UsageError
        There is no such wall, or it cannot do that.
    """
    enclosure = as_enclosure(geometry)
    match change:
        case SetGravity(gravity=gravity):
            if (gravity[0] and enclosure.periodic_x) or (gravity[1] and enclosure.periodic_y):
                raise UsageError("gravity along a periodic direction: discs would fall for ever")
            return dataclasses.replace(enclosure, gravity=gravity)
        case MoveWall(displacement=target, speed=speed, origin=origin):
            number = _movable(enclosure, change.wall)
            return enclosure.with_wall(number, motion=_way(time, origin or 0.0, target, speed))
        case SetWall(present=present, temperature=temperature, free=free):
            number = _number(enclosure, change.wall)
            changes: dict[str, object] = {}
            if present is not None:
                if number < len(enclosure.walls) - len(enclosure.obstacles):
                    raise UsageError(f"{change.wall} is a side of the container: it cannot be taken away")
                # Who stands in the place of a wall that comes is let go on.
                changes |= {"present": present, "soft": present or enclosure.walls[number].soft}
            if temperature is not None:
                changes["temperature"] = temperature
            if free:
                changes["motion"] = _free(as_enclosure(start).walls[number].motion, change.wall)
            return enclosure.with_wall(number, **changes)
        case SetGate(wall=wall, forward=forward, backward=backward):
            number = _number(enclosure, wall)
            if number < len(enclosure.walls) - len(enclosure.obstacles):
                raise UsageError(f"{wall} is a side of the container: nobody can pass it")
            return enclosure.with_wall(number, passes=Gate(_passage(forward), _passage(backward)))


def _passage(way: Way | None) -> Passage | None:
    if way is None:
        return None
    return Passage(way.species, least_speed=way.least_speed, greatest_speed=way.greatest_speed)


def _way(time: float, origin: float, target: float, speed: float) -> Path:
    """From one displacement to another at constant speed, and then at rest."""
    if target == origin:
        return Path((time,), (origin,), (0.0,))
    duration = abs(target - origin) / speed
    return Path((time, time + duration), (origin, target), ((target - origin) / duration, 0.0))


def _free(motion: Motion | None, name: str) -> Piston:
    if not isinstance(motion, Piston):
        raise UsageError(f"{name} is no piston: it cannot go free")
    return dataclasses.replace(motion, speed=0.0)


def _number(enclosure: Enclosure, name: str) -> int:
    if name not in enclosure.wall_names:
        raise UsageError(f"there is no wall {name!r}; there are {', '.join(enclosure.wall_names)}")
    return enclosure.wall_names.index(name)


def _movable(enclosure: Enclosure, name: str) -> int:
    number = _number(enclosure, name)
    if enclosure.normal(number) == (0.0, 0.0) or not (
        isinstance(enclosure.container, Rectangle)
        or number >= len(enclosure.walls) - len(enclosure.obstacles)
    ):
        raise UsageError(
            f"{name} cannot move: only sides of a rectangle, segments, and discs with a direction can"
        )
    return number
