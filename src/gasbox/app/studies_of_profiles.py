"""Studies along an axis of the box: density, with the barometric curve, and temperature."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from gasbox.app.directions import axis_of
from gasbox.app.sample import Sample
from gasbox.app.study import INK, Axis, Picture, Trace, radii
from gasbox.app.window import Lately
from gasbox.geometry import Enclosure, Rectangle
from gasbox.observe import ProfileAverage, Profiles, temperature
from gasbox.theory import gravity, sediment
from gasbox.units import UNIT

__all__ = ["Density", "Temperature"]

_BINS: Final = 24
_WINDOW: Final = 40
"""Samples over which a profile is averaged at least, twice as many at most."""


class AlongAxis:
    """A profile averaged over the last samples; two averages take turns, so that what is old is forgotten."""

    name = title = ""
    is_light = False

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._averages: list[ProfileAverage] = []
        self._seen = 0
        self._sample: Sample | None = None

    def suits(self, sample: Sample) -> bool:
        """The box keeps its size: a barostat stretches it, and each place with it."""
        return sample.geometry.is_walled or not sample.state.wall_displacement.size

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`. After a change of gravity or of a wall, the average begins anew."""
        key = (sample.version, sample.geometry.gravity, self._walls(sample))
        if key != self._key:
            self._key, self._averages, self._seen = key, [self._fresh(sample)], 0
        elif self._sample is not None and sample.time == self._sample.time:
            return
        if self._seen == _WINDOW:
            self._averages, self._seen = [self._averages[-1], self._fresh(sample)], 0
        self._seen += 1
        self._sample = sample
        for average in self._averages:
            average.changed(sample.state, sample.geometry)
            average.observe(sample.state, sample.tallies)

    @staticmethod
    def _walls(sample: Sample) -> tuple[object, ...]:
        if not isinstance(sample.geometry, Enclosure):
            return ()
        return tuple((wall.present, wall.temperature) for wall in sample.geometry.walls)

    @staticmethod
    def _fresh(sample: Sample) -> ProfileAverage:
        return ProfileAverage(sample.geometry, radii(sample.scenario), axis_of(sample), _BINS)

    def _profiles(self) -> Profiles | None:
        return self._averages[0].profiles() if self._averages else None

    def _place(self, profiles: Profiles) -> Axis:
        low, high = float(profiles.edges[0]), float(profiles.edges[-1])
        return Axis(f"{profiles.axis}  ({UNIT['position']})", low, high)


def _trace(name: str, color: str, profiles: Profiles, mean: object, error: object) -> Trace:
    points = np.column_stack([profiles.middles, np.asarray(mean)])
    known = np.isfinite(points[:, 1])
    return Trace(name, points[known], "points", np.asarray(error)[known], color)


class Density(AlongAxis):
    """Number of discs of each species per area, and where gravity pulls along the axis, what theory expects."""

    name, title = "density", "Density profile"

    def is_wanted(self, sample: Sample) -> bool:
        """There is gravity."""
        return any(sample.geometry.gravity)

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        profiles, sample = self._profiles(), self._sample
        if profiles is None or sample is None or not profiles.frames:
            return None
        traces = [
            _trace(species.name, str(species.color), profiles, one.mean, one.error)
            for species, one in zip(sample.scenario.kinds, profiles.density, strict=True)
        ]
        traces += barometric(sample, profiles)
        return Picture(self._place(profiles), Axis(f"discs per area  (1/{UNIT['area']})", 0.0), traces)


def barometric(sample: Sample, profiles: Profiles) -> list[Trace]:
    """The law of each species, where it holds: straight walls at rest, nothing in the way, gravity along the axis."""
    geometry, warmth = sample.geometry, temperature(sample.state, sample.geometry)
    if not warmth or not _is_open_box(geometry):
        return []
    along = "xy".index(str(profiles.axis))
    pull = geometry.gravity[along]
    if pull == 0.0 or abs(geometry.gravity[1 - along]) > 1e-9 * abs(pull) or geometry.periodic[along]:
        return []
    counts = np.bincount(sample.state.species, minlength=len(sample.scenario.kinds))
    alone = np.count_nonzero(counts) == 1
    traces = []
    for species, one in enumerate(sample.scenario.kinds):
        room = geometry.accessible_size(one.radius)
        height, width = room[along], room[1 - along]
        if not counts[species] or height <= 0.0 or width <= 0.0:
            continue
        scale = gravity.scale_height(one.mass, warmth, abs(pull))
        heights = np.linspace(0.0, height, 81)
        number = float(counts[species])
        if alone:
            density = sediment.hard_disc_density(heights, number, width, one.radius, scale, height)
        else:
            density = gravity.density(heights, number, width, scale, height)
        place = one.radius + heights if pull < 0 else one.radius + height - heights
        points = np.column_stack([place, np.asarray(density)])[:: 1 if pull < 0 else -1]
        if np.all(np.isfinite(points)):
            kind = "hard discs" if alone else "ideal"
            traces.append(
                Trace(f"{one.name}, {kind}", points, "theory", None, INK if alone else str(one.color))
            )
    return traces


def _is_open_box(geometry: object) -> bool:
    """A rectangle at rest with nothing in it that stands in the way, and no walls of another temperature."""
    if not isinstance(geometry, Enclosure) or not isinstance(geometry.container, Rectangle):
        return False
    if any(wall.motion is not None or wall.open or wall.temperature is not None for wall in geometry.walls):
        return False
    return not any(wall.present and wall.passes is None for wall in geometry.walls[4:])


class Temperature(AlongAxis):
    """Mean kinetic energy of the discs at each place."""

    name, title = "temperature", "Temperature profile"

    def is_wanted(self, sample: Sample) -> bool:
        """There is gravity, or walls are warm or cold."""
        geometry = sample.geometry
        return isinstance(geometry, Enclosure) and any(
            wall.temperature is not None for wall in geometry.walls
        )

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        profiles, sample = self._profiles(), self._sample
        if profiles is None or sample is None or not profiles.frames:
            return None
        whole = profiles.whole_temperature
        traces = [_trace("gas", "var(--accent)", profiles, whole.mean, whole.error)]
        low, high = float(profiles.edges[0]), float(profiles.edges[-1])
        warmth = temperature(sample.state, sample.geometry)
        if warmth is not None and math.isfinite(warmth):
            traces.append(Trace("mean", np.array([[low, warmth], [high, warmth]]), "theory", None, INK))
        return Picture(self._place(profiles), Axis(f"temperature  ({UNIT['temperature']})", 0.0), traces)
