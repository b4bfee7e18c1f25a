"""The radial distribution function g(r): how much more often than by chance two discs are a distance apart.

By chance means independently of each other, each anywhere where its centre can go. In a periodic box that is the usual
n 2 pi r dr; between walls pairs far apart are rarer, because one of the two would be outside, and g is normalised by
the share of pairs of points in the same region that are r apart. It so tends to 1 at large r in an even gas of any box;
in a gas with a surface (a drop, a sediment) it does not, and tells of the drop's size as well.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.affinity import translate

from gasbox.geometry import Geometry, Rectangle
from gasbox.geometry.region import room
from gasbox.observe.neighbours import neighbours
from gasbox.state import Contacts, State, Tallies

__all__ = ["PairDistribution", "RadialDistribution", "shell_shares"]

_DIRECTIONS: Final = 360
"""Directions over which the overlap of a shifted rectangle is averaged."""
_FEW_DIRECTIONS: Final = 24
_FEW_DISTANCES: Final = 25
"""For other shapes, between which it is interpolated."""


@dataclass(frozen=True)
class PairDistribution:
    """g(r) of all pairs of species; not-a-number where there is no pair, or before the first frame.

    Attributes
    ----------
    r : (bins,) float64 [length], middles of the bins
    g : (species, species, bins) float64, the same for [a, b] and [b, a]
    whole : (bins,) float64, of all discs whatever their species
    frames : over how many it was averaged
    """

    r: NDArray[np.float64]
    g: NDArray[np.float64]
    whole: NDArray[np.float64]
    frames: int


class RadialDistribution:
    """Averages g(r) over the frames of a run.

    Parameters
    ----------
    geometry : what the gas is in
    species : how many there are
    bins : how many between 0 and `maximum`
    maximum : greatest distance [length]
    since : frames before this time are left out, so that a transient can pass [time]
    """

    reads_contacts = False

    def __init__(
        self, geometry: Geometry, species: int, bins: int, maximum: float, since: float = -np.inf
    ) -> None:
        self._geometry = geometry
        self._edges = np.linspace(0.0, maximum, bins + 1)
        self._species = species
        self._since = since
        self._last, self._frames = -np.inf, 0
        self._counts = np.zeros((species, species, bins))
        self._expected = np.zeros((species, species, bins))

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all frames and count the first."""
        self._forget()
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Count the pairs of a frame, unless it is too early or was seen already."""
        if state.time < self._since or state.time <= self._last:
            return
        self._last = state.time
        self._frames += 1
        self._counts += self._count(state)
        self._expected += self._expect(state)

    def value(self) -> PairDistribution:
        """The mean so far."""
        middles = 0.5 * (self._edges[1:] + self._edges[:-1])
        whole = _over(np.sum(self._counts, axis=(0, 1)), np.sum(self._expected, axis=(0, 1)))
        return PairDistribution(middles, _over(self._counts, self._expected), whole, self._frames)

    def _forget(self) -> None:
        self._last, self._frames = -np.inf, 0
        self._counts, self._expected = np.zeros_like(self._counts), np.zeros_like(self._expected)

    def _count(self, state: State) -> NDArray[np.float64]:
        """Ordered pairs in each bin."""
        bins = self._edges.size - 1
        found = neighbours(state, self._geometry, float(self._edges[-1]))
        place = (np.hypot(found.way[:, 0], found.way[:, 1]) * (bins / self._edges[-1])).astype(np.int64)
        kinds = state.species[found.rows].astype(np.int64) * self._species + state.species[found.other]
        # What lies on the last edge belongs to the last bin.
        row = kinds * bins + np.minimum(place, bins - 1)
        return np.bincount(row, minlength=self._counts.size).reshape(self._counts.shape).astype(np.float64)

    def _expect(self, state: State) -> NDArray[np.float64]:
        """As many ordered pairs as there would be by chance."""
        here = self._geometry.at(state.wall_displacement)
        numbers = np.bincount(state.species, minlength=self._species)
        radii = [float(np.max(state.radius[state.species == k], initial=0.0)) for k in range(self._species)]
        expected = np.zeros(self._counts.shape)
        for a in range(self._species):
            for b in range(a, self._species):
                pairs = numbers[a] * (numbers[b] - (a == b))
                if pairs > 0:
                    expected[a, b] = expected[b, a] = pairs * shell_shares(
                        here, radii[a], radii[b], self._edges
                    )
        return expected


def shell_shares(
    geometry: Geometry, first: float, second: float, edges: NDArray[np.float64]
) -> NDArray[np.float64]:
    """(bins,) float64: share of pairs of points, each anywhere where a centre can be, that are so far apart.

    Images across periodic edges count too, so that far shells have shares beyond 1.

    Parameters
    ----------
    first, second : radii of the two discs [length]
    edges : (bins+1,) of the shells [length]
    """
    middles, shells = 0.5 * (edges[1:] + edges[:-1]), math.pi * np.diff(edges**2)
    if isinstance(geometry, Rectangle):
        overlap = _rectangle_overlap(geometry, first, second, middles)
    else:
        far = float(edges[-1])
        places = np.linspace(0.0, far, _FEW_DISTANCES)
        overlap = np.interp(middles, places, _room_overlap(geometry, first, second, far))
    areas = geometry.accessible_area(first) * geometry.accessible_area(second)
    return shells * overlap / areas if areas > 0.0 else np.zeros(middles.size)


def _rectangle_overlap(
    box: Rectangle, first: float, second: float, distance: NDArray[np.float64]
) -> NDArray[np.float64]:
    """(m,) float64 [length²]: overlap of where both can be, one shifted by a distance, over all directions."""
    angle = 2.0 * math.pi * (np.arange(_DIRECTIONS) + 0.5) / _DIRECTIONS
    overlap = np.ones((distance.size, _DIRECTIONS))
    shifts = distance[:, None] * np.cos(angle), distance[:, None] * np.sin(angle)
    for shift, length, periodic in zip(shifts, box.size, box.periodic, strict=True):
        low = np.maximum(first, second + shift)
        high = np.minimum(length - first, length - second + shift)
        overlap *= length if periodic else np.maximum(high - low, 0.0)
    mean: NDArray[np.float64] = np.mean(overlap, axis=1)
    return mean


@functools.lru_cache(maxsize=64)
def _room_overlap(geometry: Geometry, first: float, second: float, far: float) -> NDArray[np.float64]:
    """As `_rectangle_overlap`, for any shape, at evenly spaced distances from 0 to `far`."""
    assert not isinstance(geometry, Rectangle)
    here, other = room(geometry, first), room(geometry, second)
    sides = zip(geometry.size, geometry.periodic, strict=True)
    turns = [math.ceil(far / length) if wraps else 0 for length, wraps in sides]
    images = [
        translate(other, i * geometry.width, j * geometry.height)
        for i in range(-turns[0], turns[0] + 1)
        for j in range(-turns[1], turns[1] + 1)
    ]
    around = shapely.unary_union(images) if len(images) > 1 else other
    angle = 2.0 * math.pi * (np.arange(_FEW_DIRECTIONS) + 0.5) / _FEW_DIRECTIONS
    areas = [
        [here.intersection(translate(around, r * math.cos(t), r * math.sin(t))).area for t in angle]
        for r in np.linspace(0.0, far, _FEW_DISTANCES)
    ]
    mean: NDArray[np.float64] = np.mean(areas, axis=1)
    return mean


def _over(counts: NDArray[np.float64], expected: NDArray[np.float64]) -> NDArray[np.float64]:
    quotient: NDArray[np.float64] = np.full(counts.shape, np.nan)
    np.divide(counts, expected, out=quotient, where=expected > 0.0)
    return quotient
