"""Where discs stand that start on a triangular lattice."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry, Rectangle
from gasbox.scenario.density import centre_bounds
from gasbox.scenario.kinds import Kind

__all__ = ["Lattice", "lattice_places", "lattices"]

_STRAIN: Final = 1e-3
"""A lattice is stretched or pressed by so much to go once round a periodic box without a seam."""
_ROUNDING: Final = 1e-9
_MOST_MORE: Final = 1_000_000
"""Most places beyond eight for each disc that are looked at."""


@dataclass(frozen=True)
class Lattice:
    """Discs that share one lattice: all species with one spacing and one part of the container.

    Attributes
    ----------
    spacing : distance of nearest neighbours [length]
    bounds : left, right, lower and upper end [length] of the part of the container
    members : indices of the species
    count : number of discs
    radius : of the largest of them [length]
    least : least distance that these discs allow [length]; 0 where they may overlap
    """

    spacing: float
    bounds: tuple[float, float, float, float]
    members: tuple[int, ...]
    count: int
    radius: float
    least: float


def lattices(geometry: Geometry, kinds: Sequence[Kind], soft: bool) -> tuple[Lattice, ...]:
    """All lattices that are asked for; `soft` if discs may overlap."""
    groups: dict[tuple[float, tuple[float, float, float, float]], list[int]] = {}
    for number, entry in enumerate(kinds):
        if entry.lattice is not None and entry.count:
            groups.setdefault((entry.lattice, entry.bounds(geometry)), []).append(number)
    found = []
    for (spacing, bounds), members in groups.items():
        radius = max(kinds[number].radius for number in members)
        count = sum(kinds[number].count for number in members)
        found.append(Lattice(spacing, bounds, tuple(members), count, radius, 0.0 if soft else 2 * radius))
    return tuple(found)


@lru_cache(maxsize=8)
def lattice_places(geometry: Geometry, lattice: Lattice) -> NDArray[np.float64]:
    """Places (m, 2) [length], those nearest to the middle; m is the number of discs, or less if no more fit.

    Neighbours in a row are one spacing apart, rows lie along x, or along y if only so there is room for all. Where the
    part goes once round a periodic box that holds, to 1e-3, a whole number of columns (or pairs of rows), these are
    spread evenly, and the lattice has no seam.
    """
    frames = [frame for turned in (False, True) if (frame := _frame(geometry, lattice, turned)) is not None]
    best, rank = np.zeros((0, 2)), (False, False, 0)
    for frame, phases in ((each, phases) for each in frames for phases in each.phases):
        places = _nearest(geometry, lattice, frame, phases)
        found = (len(places) == lattice.count, frame.fills, len(places))
        if found > rank:
            best, rank = places, found
        if rank[:2] == (True, True):
            break
    best.setflags(write=False)
    return best


@dataclass(frozen=True)
class _Axis:
    """One direction of what centres can reach: from `begin` to `end`, with `number` places if it goes once round."""

    begin: float
    end: float
    step: float
    number: int | None

    @property
    def middle(self) -> float:
        return (self.begin + self.end) / 2

    def places(self, phase: float, within: float) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Numbers and coordinates [length] of the places not farther than `within` from the middle."""
        if self.number is not None:
            center, away = (self.number - 1) / 2 - phase, within / self.step + 1
            first, last = max(0, math.ceil(center - away)), min(self.number - 1, math.floor(center + away))
            numbers = np.arange(first, last + 1, dtype=np.int64)
            return numbers, self.middle + (numbers.astype(np.float64) - center) * self.step
        half = min((self.end - self.begin) / 2, within)
        slack = _ROUNDING * self.step
        first = math.ceil((-half - slack) / self.step - phase)
        last = math.floor((half + slack) / self.step - phase)
        numbers = np.arange(first, last + 1, dtype=np.int64)
        place = self.middle + (numbers.astype(np.float64) + phase) * self.step
        return numbers, np.clip(place, self.begin, self.end)


@dataclass(frozen=True)
class _Frame:
    """Columns and rows; `turned` if rows run along y."""

    along: _Axis
    across: _Axis
    fills: bool
    turned: bool

    @property
    def phases(self) -> list[tuple[float, float]]:
        """What may stand in the middle, by shifts in units of the distances of columns and rows."""
        along = (0.0, 0.25, 0.5) if self.along.number is None else (-0.25,)
        return list(itertools.product(along, (0.0, 0.5) if self.across.number is None else (0.0,)))

    def sites(self, phases: tuple[float, float], within: float) -> NDArray[np.float64]:
        """Sites (n, 2) [length] in a square around the middle."""
        rows, heights = self.across.places(phases[1], within)
        found = [np.zeros((0, 2))]
        for parity in (0, 1):
            _, along = self.along.places(phases[0] + parity / 2, within)
            across = heights[rows % 2 == parity]
            found.append(np.stack([np.tile(along, len(across)), np.repeat(across, len(along))], axis=1))
        sites = np.concatenate(found)
        return sites[:, ::-1] if self.turned else sites


def _frame(geometry: Geometry, lattice: Lattice, turned: bool) -> _Frame | None:
    """The columns and rows that have room; None if none have."""
    low, high = centre_bounds(geometry, lattice.bounds, lattice.radius)
    size, spacing = (geometry.width, geometry.height), lattice.spacing
    first, second = (1, 0) if turned else (0, 1)
    round_along, round_across = (
        bool(geometry.periodic[axis]) and high[axis] - low[axis] == size[axis] for axis in (first, second)
    )
    pressed = min(_STRAIN, max(0.0, 1 - lattice.least / spacing)) + 1e-12
    height = spacing * math.sqrt(3) / 2
    along, across = (
        _Axis(low[first], high[first], spacing, None),
        _Axis(low[second], high[second], height, None),
    )
    fills = True
    if round_along:
        columns = int(size[first] / spacing * (1 + pressed))
        seamless = columns > 0 and abs(size[first] / (columns * spacing) - 1) <= _STRAIN
        fills &= seamless
        step = size[first] / columns if seamless else spacing
        along = _Axis(low[first], high[first], step, columns)
    if round_across:
        rows = int(size[second] / height * (1 + pressed))
        if rows % 2 == 1 and size[second] - (rows - 1) * height < spacing * (1 - pressed):
            rows -= 1
        seamless = rows > 0 and rows % 2 == 0 and abs(size[second] / (rows * height) - 1) <= _STRAIN
        fills &= seamless
        across = _Axis(low[second], high[second], size[second] / rows if seamless else height, rows)
    return None if 0 in (along.number, across.number) else _Frame(along, across, fills, turned)


def _nearest(
    geometry: Geometry, lattice: Lattice, frame: _Frame, phases: tuple[float, float]
) -> NDArray[np.float64]:
    """The sites nearest to the middle that discs can reach, as many as there are discs, or all."""
    middle = np.array([frame.along.middle, frame.across.middle])[:: -1 if frame.turned else 1]
    most = 8 * lattice.count + _MOST_MORE
    for within in _windows(lattice, frame):
        sites = frame.sites(phases, within)
        distance = np.round(np.sqrt(np.square(sites - middle).sum(axis=1)) / lattice.spacing, 6)
        sites = geometry.wrap(sites)
        if not isinstance(geometry, Rectangle):
            clear = geometry.holds(sites, lattice.radius * (1 - _ROUNDING))
            sites, distance = sites[clear], distance[clear]
        inside = int((distance * lattice.spacing <= within).sum())
        if inside >= lattice.count or len(sites) > most:
            break
    return sites[np.argsort(distance, kind="stable")[: lattice.count]]


def _windows(lattice: Lattice, frame: _Frame) -> Iterator[float]:
    """Half the widths [length] of squares that are looked at, the last one around everything."""
    whole = max(frame.along.end - frame.along.begin, frame.across.end - frame.across.begin)
    within = lattice.spacing * (2 + 0.6 * math.sqrt(lattice.count))
    while within < whole:
        yield within
        within *= 2
    yield whole + lattice.spacing
