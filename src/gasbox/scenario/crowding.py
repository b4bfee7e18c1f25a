"""Whether walls that move leave room for the discs, and no gaps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.errors import Problem
from gasbox.geometry import Enclosure, Passage, Path, Segment, Wall, side_count
from gasbox.geometry.anchors import anchored, glides
from gasbox.geometry.region import components
from gasbox.geometry.solids import outline, shifted
from gasbox.scenario.parts import Parts
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.shares import shares
from gasbox.scenario.surroundings import surroundings
from gasbox.scenario.tracks import Track, tracks
from gasbox.scenario.wall_rules import named_walls

__all__ = ["crowding_problems", "glide_problems"]

_FULL: Final = 0.9
"""Area fraction beyond which discs that are shut in can hardly move; the densest packing has 0.9069."""
_MOST_TIMES: Final = 400
"""At most so many times are looked at."""
_HALVINGS: Final = 40
_LEVEL: Final = 1e-9
"""A unit vector with a smaller component has none."""


def glide_problems(parts: Parts) -> Iterator[Problem]:
    """Segments that move and whose ends would leave the walls on which they stand."""
    geometry = surroundings(parts)
    if not isinstance(geometry, Enclosure):
        return
    schedule = [entry for entry in parts.schedule if entry is not None]
    moved = {entry.wall for entry in schedule if entry.displacement is not None}
    first = side_count(geometry.container)
    for number, obstacle in enumerate(geometry.obstacles):
        wall = geometry.walls[first + number]
        if not isinstance(obstacle, Segment) or (wall.motion is None and wall.name not in moved):
            continue
        path = f"obstacles[{number}]" + (".motion" if wall.motion is not None else "")
        yield from _in_periods(geometry, number, path)
        for end in (obstacle.start, obstacle.end):
            if not glides(geometry, number, end):
                found = f"the end [{end[0]:g}, {end[1]:g}] on a wall that is not parallel to the motion"
                allowed = "an end keeps clear of walls or glides along a straight one: else it leaks"
                yield Problem(path, found, allowed)


def _in_periods(geometry: Enclosure, number: int, path: str) -> Iterator[Problem]:
    """A segment that moves has no images: it goes all round a period, and never across its edge."""
    normal = np.array(geometry.normal(side_count(geometry.container) + number))
    for axis in np.flatnonzero(geometry.periodic & (np.abs(normal) > _LEVEL)):
        allowed = "a segment moves at right angles to a periodic direction"
        yield Problem(path, f"a motion along {'xy'[axis]}, which is periodic", allowed)
        return
    moving = geometry.with_wall(side_count(geometry.container) + number, motion=Path((0.0,), (0.0,), (0.0,)))
    if geometry.periodic.any() and not all(anchored(moving, number)):
        allowed = "in a periodic container a segment that moves spans the whole period"
        yield Problem(path, "a segment with an end in the gas", allowed)


@dataclass(frozen=True)
class _Course:
    """All that changes with time, as far as it is known beforehand."""

    enclosure: Enclosure
    tracks: list[Track]
    schedule: Sequence[ScheduledChange]

    def at(self, time: float) -> Enclosure:
        """The enclosure at a time, pistons as at the start."""
        enclosure = self.enclosure
        for entry in sorted(self.schedule, key=lambda entry: entry.at):
            if entry.present is not None and entry.wall is not None and entry.at <= time:
                number = enclosure.wall_names.index(entry.wall)
                enclosure = enclosure.with_wall(number, present=entry.present)
        return enclosure.at(np.array([track.displacement(time) for track in self.tracks]))

    def times(self) -> list[float]:
        """When it may be fullest."""
        found = {0.0, *(entry.at for entry in self.schedule if entry.wall is not None)}
        for track in self.tracks:
            found |= {time for time in track.corners() if time > 0.0}
        times = sorted(found)[:_MOST_TIMES]
        speed = max((abs(track.last_speed) for track in self.tracks), default=0.0)
        if speed > 0.0:
            times.append(times[-1] + 2 * max(self.enclosure.width, self.enclosure.height) / speed)
        return times


def crowding_problems(parts: Parts) -> Iterator[Problem]:
    """A motion by which walls meet, a segment leaves the container, or discs that are shut in get no room."""
    geometry = surroundings(parts)
    if not isinstance(geometry, Enclosure):
        # A schedule moves the sides of a plain rectangle, too.
        geometry = Enclosure(geometry, walls=tuple(map(Wall, geometry.wall_names)))
    schedule = [entry for entry in parts.schedule if entry is not None]
    if not geometry.moves and not any(entry.wall for entry in schedule):
        return
    # Whoever passes a membrane is not shut in by it.
    for number, wall in enumerate(geometry.walls):
        if wall.passes is not None:
            geometry = geometry.with_wall(number, passes=Passage())
    course = _Course(geometry, tracks(geometry, schedule), schedule)
    gas = shares(geometry, parts.kinds(), parts.particles)
    before = 0.0
    for time in course.times():
        if _trouble(course, gas, time):
            for _ in range(_HALVINGS):
                middle = (before + time) / 2
                before, time = (before, middle) if _trouble(course, gas, middle) else (middle, time)
            yield Problem(_culprit(course, parts, time), *(_trouble(course, gas, time) or ("", "")))
            return
        before = time


def _culprit(course: _Course, parts: Parts, time: float) -> str:
    """Path of what moves then, if only one thing does."""
    done = [
        (entry.at, number) for number, entry in enumerate(course.schedule) if entry.wall and entry.at <= time
    ]
    if done:
        return f"schedule[{max(done)[1]}]"
    moving = [number for number, track in enumerate(course.tracks) if track.moves]
    return f"{named_walls(parts)[moving[0]][0]}.motion" if len(moving) == 1 else "walls"


def _trouble(course: _Course, gas: NDArray[np.float64], time: float) -> tuple[str, str] | None:
    """What is wrong at a time, and what is allowed; None if nothing is."""
    enclosure = course.at(time)
    inside = outline(enclosure)
    when = f"at time {time:.6g}"
    if inside.is_empty:
        return f"opposite sides that meet {when}", "the container must keep an area: stop the motion before"
    for number, name in _outside(enclosure, inside):
        if course.tracks[number].moves:
            return f"{name} outside the container {when}", "must stay inside it: stop the motion before"
    parts = components(enclosure, 0.0)
    areas = np.array([part.area for part in parts])
    held = gas if len(areas) == gas.size else gas.sum(keepdims=True)
    areas = areas if len(areas) == gas.size else np.array([enclosure.area])
    fraction = float(np.max(held / np.maximum(areas, 1e-300), initial=0.0))
    if fraction > _FULL * (1 + 1e-9):
        found = f"too little room {when}: discs that are shut in fill more than {_FULL:g} of the area"
        return found, f"at most {_FULL:g}; stop the motion before, or use fewer or smaller discs"
    return None


def _outside(enclosure: Enclosure, inside: shapely.Geometry) -> Iterator[tuple[int, str]]:
    """Walls (index, name) of segments that reach beyond the container where it is now."""
    first = side_count(enclosure.container)
    margin = 1e-6 * max(enclosure.width, enclosure.height)
    for number, obstacle in enumerate(enclosure.obstacles):
        if not isinstance(obstacle, Segment):
            continue
        moved = shifted(enclosure, number)
        assert isinstance(moved, Segment)
        if not inside.buffer(margin, join_style="mitre").covers(shapely.LineString([moved.start, moved.end])):
            yield first + number, enclosure.walls[first + number].name
