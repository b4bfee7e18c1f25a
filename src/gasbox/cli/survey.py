"""What a recording has to tell beside the standard numbers: it is read once, by all observers together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from gasbox import observe
from gasbox.geometry import Enclosure, Geometry, Rectangle, side_count
from gasbox.geometry.conserved import lets_everybody_pass
from gasbox.protocols import Observer
from gasbox.recording import Recording
from gasbox.state import Frame, State

__all__ = ["Survey", "survey"]

_MOST_FRAMES: Final = 1000
"""Of a longer recording every so many frames are read: no picture shows more."""
_BINS: Final = 24


@dataclass(frozen=True)
class Survey:
    """Everything that was observed; None for what this gas does not have.

    Attributes
    ----------
    start, end : geometry at the first and last frame
    last : the last frame
    book : energy and where it came from
    walls : pressure on each wall
    centers : centres of mass; None of one species without gravity
    axis : along which profiles are taken, against gravity
    profiles : density and temperature along it
    sides : those of each divider, by name
    diagram : pressure and area, of the first side that moves
    times : (frames,) float64 [time], of the frames that were read
    passed : (frames, walls, species, 2) int64, as in `Tallies.wall_passed`, since the first frame
    """

    start: Geometry
    end: Geometry
    last: Frame
    book: observe.EnergyBalance
    walls: observe.WallSeries
    centers: observe.CenterSeries | None
    axis: Literal["x", "y"]
    profiles: observe.Profiles | None
    sides: dict[str, observe.SideSeries]
    diagram: observe.IndicatorSeries | None
    times: NDArray[np.float64]
    passed: NDArray[np.int64]


def survey(recording: Recording, first: int) -> Survey:
    """Read a recording; means are over frames from `first` on."""
    start, end = recording.geometry_at(0), recording.geometry_at(-1)
    species = recording.scenario.kinds
    radii, mass = (np.array([getattr(entry, name) for entry in species]) for name in ("half_width", "mass"))
    since = float(recording.times[first])
    pull = start.gravity if any(start.gravity) else end.gravity
    axis: Literal["x", "y"] = "x" if abs(pull[0]) > abs(pull[1]) else "y"
    heavy = any(pull)
    dividers = _dividers(start, len(species))
    book, walls = observe.Balance(start, mass), observe.WallGauge(start, radii, since)
    profile = (
        observe.ProfileAverage(start, radii, axis, _edges(start, recording.read(-1).state, axis), since)
        if heavy
        else None
    )
    centers = observe.Centers(start, len(species)) if heavy or (len(species) > 1 and dividers) else None
    moving = _moving_side(end)
    diagram = observe.Indicator(start, radii, moving) if moving is not None else None
    observers: list[Observer] = [book, walls, *dividers.values()]
    observers += [each for each in (profile, centers, diagram) if each is not None]
    times, passed, last = _read(recording, observers, start)
    return Survey(
        start=start,
        end=end,
        last=last,
        book=book.series(),
        walls=walls.series(),
        centers=None if centers is None else centers.series(),
        axis=axis,
        profiles=None if profile is None else profile.profiles(),
        sides={name: each.series() for name, each in dividers.items()},
        diagram=None if diagram is None else diagram.series(),
        times=times,
        passed=passed - passed[:1],
    )


def _read(
    recording: Recording, observers: list[Observer], geometry: Geometry
) -> tuple[NDArray[np.float64], NDArray[np.int64], Frame]:
    """Show frames to all observers, and tell them when the geometry changes."""
    count = min(recording.frames, _MOST_FRAMES)
    numbers = np.unique(np.linspace(0, recording.frames - 1, count).round().astype(int))
    changing = bool(recording.changes or recording.scenario.schedule)
    passed, frame = [], recording.read(0)
    for observer in observers:
        observer.start(frame.state, frame.tallies)
    for number in numbers:
        frame = recording.read(int(number))
        here = recording.geometry_at(int(number)) if changing else geometry
        if here != geometry:
            geometry = here
            for observer in observers:
                if isinstance(observer, observe.FollowsChanges):
                    observer.changed(frame.state, geometry)
        for observer in observers:
            observer.observe(frame.state, frame.tallies)
        passed.append(frame.tallies.wall_passed)
    return recording.times[numbers], np.array(passed), frame


def _dividers(geometry: Geometry, species: int) -> dict[str, observe.Sides]:
    """A count of sides for each segment in the way, the first few; lines that all pass are for counting alone."""
    found: dict[str, observe.Sides] = {}
    for number, name in enumerate(geometry.wall_names):
        line = observe.Line.of_wall(geometry, name)
        if (
            line is not None
            and isinstance(geometry, Enclosure)
            and not lets_everybody_pass(geometry.walls[number].passes)
        ):
            found[name] = observe.Sides(line, species, number)
    return dict(list(found.items())[:2])


def _edges(start: Geometry, end: State, axis: Literal["x", "y"]) -> NDArray[np.float64]:
    """Strips across the box, and as far beyond as its sides are at the end."""
    low, high = observe.extent(start, axis)
    sides = end.wall_displacement[0 if axis == "x" else 2 :][:2]
    if sides.size and isinstance(start, Enclosure) and isinstance(start.container, Rectangle):
        low, high = min(low, low + float(sides[0])), max(high, high + float(sides[1]))
    return np.linspace(low, high, _BINS + 1)


def _moving_side(geometry: Geometry) -> int | None:
    """The first side of a rectangle that moves."""
    if not isinstance(geometry, Enclosure) or not isinstance(geometry.container, Rectangle):
        return None
    sides = geometry.walls[: side_count(geometry.container)]
    return next((number for number, wall in enumerate(sides) if wall.motion is not None), None)
