"""Rules on the schedule: each entry changes one thing, and that thing can change so."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.motions import PistonMotion
from gasbox.scenario.obstacles import Obstacle, PostObstacle, SegmentObstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.wall_rules import named_walls
from gasbox.scenario.walls import WallSettings

__all__ = ["schedule_problems"]

_NAMED = ("gravity", "thermostat", "barostat", "heating", "setting", "wall")
_OF_WALLS = ("present", "temperature", "displacement", "free")


def schedule_problems(parts: Parts) -> Iterator[Problem]:
    """Entries that change nothing, two things at once, or what cannot change."""
    for number, entry in enumerate(parts.schedule):
        if entry is not None:
            yield from _entry(f"schedule[{number}]", entry, parts)


def _entry(path: str, entry: ScheduledChange, parts: Parts) -> Iterator[Problem]:
    given = [key for key in _OF_WALLS if getattr(entry, key) is not None]
    named = [key for key in _NAMED if getattr(entry, key) is not None]
    if len(named) != 1:
        found = {0: "nothing that changes", 2: f"both {' and '.join(named)}"}.get(
            len(named), ", ".join(named)
        )
        yield Problem(
            path, found, f"each entry names one of {', '.join(_NAMED)}; of a wall, what becomes of it"
        )
    elif entry.wall is None and given:
        yield Problem(path, f"{named[0]} and {given[0]}", f"{given[0]} needs a wall, in an entry of its own")
    if entry.speed is not None and entry.displacement is None:
        yield Problem(f"{path}.speed", f"{entry.speed:g}", "goes with displacement: the speed of that motion")
    if (entry.setting is None) != (entry.value is None):
        yield Problem(
            path, "setting without value" if entry.setting else "value without setting", "they go together"
        )
    elif entry.setting is not None:
        yield from _setting(path, entry, parts)
    if entry.wall is None:
        return
    if not given and len(named) == 1:
        yield Problem(path, "a wall alone", f"says one of {', '.join(_OF_WALLS)} of it")
    if entry.displacement is not None and len(given) > 1:
        others = " and ".join(key for key in given if key != "displacement")
        yield Problem(path, f"displacement and {others}", "a motion stands in an entry of its own")
    yield from _wall(path, entry, entry.wall, parts)


def _setting(path: str, entry: ScheduledChange, parts: Parts) -> Iterator[Problem]:
    """A setting that the world does not have, or cannot have so."""
    assert entry.setting is not None
    assert entry.value is not None
    if parts.world is None:
        yield Problem(
            f"{path}.setting", short(entry.setting), "this scenario has no world, or its world is not valid"
        )
        return
    known = parts.world.SETTINGS
    if entry.setting not in known:
        allowed = f"must be one of {', '.join(known)}{near(entry.setting, known)}"
        yield Problem(f"{path}.setting", short(entry.setting), allowed)
        return
    try:
        known[entry.setting].check(entry.value)
    except ValueError as error:
        yield Problem(f"{path}.value", short(entry.value), str(error))


def _wall(path: str, entry: ScheduledChange, wall: str, parts: Parts) -> Iterator[Problem]:
    places = {name: place for place, name in named_walls(parts)}
    if parts.container is None or None in parts.obstacles or None in parts.walls.values():
        return
    if wall not in places:
        known = list(places)
        shown = ", ".join(map(short, known[:10])) + (", ..." if len(known) > 10 else "")
        yield Problem(f"{path}.wall", short(wall), f"must be one of {shown}{near(wall, known)}")
        return
    settings = _settings(places[wall], parts)
    is_obstacle = places[wall].startswith("obstacles")
    if entry.present is not None and not is_obstacle:
        allowed = f"only obstacles can be taken away; {wall} is a side of the container"
        yield Problem(f"{path}.present", str(entry.present).lower(), allowed)
    if entry.temperature is not None and settings is not None and settings.open:
        yield Problem(
            f"{path}.temperature", f"{entry.temperature:g}", f"{wall} is open: nobody bounces off it"
        )
    if entry.free is not None and not (settings and isinstance(settings.motion, PistonMotion)):
        yield Problem(f"{path}.free", str(entry.free).lower(), f"{wall} is no piston")
    if entry.displacement is not None and not _can_move(places[wall], settings, parts):
        allowed = (
            f"{wall} cannot move: only sides of a rectangle, segments, and discs with a direction can, "
            "if they are not open"
        )
        yield Problem(f"{path}.displacement", f"{entry.displacement:g}", allowed)


def _settings(place: str, parts: Parts) -> WallSettings | Obstacle | None:
    if place.startswith("walls."):
        return parts.walls.get(place.removeprefix("walls."))
    return parts.obstacles[int(place.removeprefix("obstacles[").removesuffix("]"))]


def _can_move(place: str, settings: WallSettings | Obstacle | None, parts: Parts) -> bool:
    if settings is not None and settings.open:
        return False
    if place.startswith("obstacles"):
        if isinstance(settings, PostObstacle):
            return settings.direction is not None
        return isinstance(settings, SegmentObstacle)
    shape = parts.container.geometry() if parts.container is not None else None
    if not isinstance(shape, Rectangle):
        return False
    across = Rectangle.WALLS.index(place.removeprefix("walls.")) < 2
    return not (shape.periodic_x if across else shape.periodic_y)
