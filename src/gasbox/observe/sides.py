"""Who is on which side of a line, how well two sides are mixed, and where centres of mass are, over time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure, Geometry, Point, Segment, side_count
from gasbox.observe.motion import center_of_mass
from gasbox.state import Contacts, State, Tallies

__all__ = [
    "CenterSeries",
    "Centers",
    "Line",
    "SideSeries",
    "Sides",
    "greatest_mixing_entropy",
    "mixing",
    "mixing_entropy",
    "side_counts",
]


@dataclass(frozen=True)
class Line:
    """A line without ends that cuts the plane in two.

    Attributes
    ----------
    point : on the line [length]
    normal : unit vector; what lies along it is ahead, what lies against it behind
    """

    point: Point
    normal: Point

    @classmethod
    def of_segment(cls, start: Point, end: Point, displacement: float = 0.0) -> Line:
        """The line of a divider; its normal points to the right of the way from `start` to `end`."""
        normal = Segment(start, end).normal
        return cls((start[0] + displacement * normal[0], start[1] + displacement * normal[1]), normal)

    @classmethod
    def of_wall(cls, geometry: Geometry, name: str) -> Line | None:
        """The line of the segment of this name, where it stands at the start; None if there is none."""
        if not isinstance(geometry, Enclosure) or name not in geometry.wall_names:
            return None
        number = geometry.wall_names.index(name) - side_count(geometry.container)
        obstacle = geometry.obstacles[number] if number >= 0 else None
        return cls.of_segment(obstacle.start, obstacle.end) if isinstance(obstacle, Segment) else None

    @property
    def sides(self) -> tuple[str, str]:
        """Names of the side behind and the side ahead."""
        x, y = self.normal
        names = ("left", "right") if abs(x) >= abs(y) else ("below", "above")
        return names if (x if abs(x) >= abs(y) else y) > 0 else names[::-1]


def side_counts(state: State, line: Line, species: int) -> NDArray[np.int64]:
    """(species, 2) int64: how many centres of each species lie behind the line, and on it or ahead of it."""
    ahead = (state.position - line.point) @ np.array(line.normal) >= 0.0
    counts = np.bincount(2 * state.species + ahead, minlength=2 * species)
    return counts.reshape(-1, 2).astype(np.int64)


def mixing_entropy(counts: NDArray[np.int64]) -> float:
    """Entropy of mixing on two sides, -sum N_is ln(N_is/N_s) [k_B]: 0 if no side holds two species.

    Parameters
    ----------
    counts : (species, sides) numbers N_is; N_s is the number of all on a side
    """
    whole = np.broadcast_to(np.sum(counts, axis=0), counts.shape)
    there = counts > 0
    return -float(np.sum(counts[there] * np.log(counts[there] / whole[there]))) + 0.0


def greatest_mixing_entropy(counts: NDArray[np.int64]) -> float:
    """`mixing_entropy` of the same discs if each side were a fair sample of all [k_B]."""
    return mixing_entropy(np.sum(counts, axis=1, keepdims=True))


def mixing(counts: NDArray[np.int64]) -> float | None:
    """`mixing_entropy` as a share of its greatest value, 0 to 1; None for fewer than two species."""
    greatest = greatest_mixing_entropy(counts)
    return mixing_entropy(counts) / greatest if greatest > 0.0 else None


@dataclass(frozen=True)
class SideSeries:
    """Who was on which side, one row for each frame.

    Attributes
    ----------
    line : that parts the sides, as at the start
    time : (frames,) float64 [time]
    counts : (frames, species, 2) int64, behind and ahead
    entropy : (frames,) float64 [k_B], of mixing
    mixing : (frames,) float64, 0 to 1; not-a-number for fewer than two species
    """

    line: Line
    time: NDArray[np.float64]
    counts: NDArray[np.int64]
    entropy: NDArray[np.float64]
    mixing: NDArray[np.float64]


class Sides:
    """Counts each species on both sides of a line, frame by frame.

    Parameters
    ----------
    line : as at the start
    species : how many there are
    wall : index of the wall with which the line moves; None for a line at rest
    """

    reads_contacts = False

    def __init__(self, line: Line, species: int, wall: int | None = None) -> None:
        self._line, self._species, self._wall = line, species, wall
        self._times: list[float] = []
        self._counts: list[NDArray[np.int64]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything and count for the first time."""
        self._times, self._counts = [], []
        self.observe(state, tallies)

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Count, unless this moment was seen already."""
        if self._times and state.time <= self._times[-1]:
            return
        self._times.append(state.time)
        self._counts.append(side_counts(state, self._moved(state), self._species))

    def series(self) -> SideSeries:
        """Everything so far."""
        counts = np.array(self._counts, np.int64).reshape(-1, self._species, 2)
        shares = [mixing(row) for row in counts]
        return SideSeries(
            self._line,
            np.array(self._times, np.float64),
            counts,
            np.array([mixing_entropy(row) for row in counts], np.float64),
            np.array([math.nan if share is None else share for share in shares], np.float64),
        )

    def _moved(self, state: State) -> Line:
        if self._wall is None or not state.wall_displacement.size:
            return self._line
        way, (x, y), normal = float(state.wall_displacement[self._wall]), self._line.point, self._line.normal
        return Line((x + way * normal[0], y + way * normal[1]), normal)


@dataclass(frozen=True)
class CenterSeries:
    """Centres of mass over time.

    Attributes
    ----------
    time : (frames,) float64 [time]
    whole : (frames, 2) float64 [length], of all discs
    species : (frames, species, 2) float64 [length]; not-a-number where there is none
    """

    time: NDArray[np.float64]
    whole: NDArray[np.float64]
    species: NDArray[np.float64]


class Centers:
    """Keeps the centre of mass of the gas and of each species, frame by frame.

    Parameters
    ----------
    geometry : what the gas is in
    species : how many there are
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, species: int) -> None:
        self._geometry, self._species = geometry, species
        self._times: list[float] = []
        self._rows: list[list[NDArray[np.float64]]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything and keep the first row."""
        self._times, self._rows = [], []
        self.observe(state, tallies)

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Keep a row, unless this moment was seen already."""
        if self._times and state.time <= self._times[-1]:
            return
        found = [center_of_mass(state, self._geometry, k) for k in (None, *range(self._species))]
        self._times.append(state.time)
        self._rows.append([np.full(2, np.nan) if center is None else center for center in found])

    def series(self) -> CenterSeries:
        """Everything so far."""
        rows = np.array(self._rows, np.float64).reshape(-1, self._species + 1, 2)
        return CenterSeries(np.array(self._times, np.float64), rows[:, 0], rows[:, 1:])
