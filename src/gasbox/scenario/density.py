"""How densely discs may be placed, and which of them compete for the same room."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.particles import Particles
from gasbox.scenario.species import Species

__all__ = ["MIXTURE_LIMIT", "ONE_SIZE_LIMIT", "Crowd", "crowds", "density_problems"]

ONE_SIZE_LIMIT: Final = 0.7
"""Greatest area fraction at which discs of one size are placed."""
MIXTURE_LIMIT: Final = 0.5
"""Greatest area fraction at which discs of several sizes are placed."""
_ROUNDING: Final = 1e-9

Bounds = tuple[float, float, float, float]


@dataclass(frozen=True)
class Crowd:
    """Discs that have to share one part of the container.

    Attributes
    ----------
    bounds : left, right, lower and upper end [length] of that part
    members : indices of the species placed wholly inside it
    fraction : area of all discs inside (listed ones, too) over the area of that part
    one_size : whether all discs inside have one radius
    alone : whether no disc from elsewhere can get in the way: no other part overlaps this one
    """

    bounds: Bounds
    members: tuple[int, ...]
    fraction: float
    one_size: bool
    alone: bool

    @property
    def area(self) -> float:
        """Area [length²] of the part."""
        return (self.bounds[1] - self.bounds[0]) * (self.bounds[3] - self.bounds[2])

    @property
    def limit(self) -> float:
        """Greatest area fraction at which these are placed."""
        return ONE_SIZE_LIMIT if self.one_size and self.alone else MIXTURE_LIMIT


def crowds(geometry: Rectangle, species: Sequence[Species], particles: Particles | None) -> tuple[Crowd, ...]:
    """One crowd for each part of the container that is asked for; if any overlap, the last one is the whole."""
    whole = (0.0, geometry.width, 0.0, geometry.height)
    parts = list(dict.fromkeys(entry.bounds(geometry) for entry in species if entry.count))
    overlapping = any(_overlap(one, other) for one, other in itertools.combinations(parts, 2))
    if overlapping:
        parts = [part for part in parts if part != whole] + [whole]
    return tuple(_crowd(part, not overlapping, geometry, species, particles) for part in parts)


def _overlap(one: Bounds, other: Bounds) -> bool:
    return max(one[0], other[0]) < min(one[1], other[1]) and max(one[2], other[2]) < min(one[3], other[3])


def _inside(inner: Bounds, outer: Bounds) -> bool:
    return inner[0] >= outer[0] and inner[1] <= outer[1] and inner[2] >= outer[2] and inner[3] <= outer[3]


def _crowd(
    part: Bounds, alone: bool, geometry: Rectangle, species: Sequence[Species], particles: Particles | None
) -> Crowd:
    members = tuple(
        number
        for number, entry in enumerate(species)
        if entry.count and _inside(entry.bounds(geometry), part)
    )
    sizes = [(species[number].radius, species[number].count) for number in members]
    sizes += _listed_sizes(part, species, particles)
    area = sum(count * math.pi * radius**2 for radius, count in sizes)
    fraction = area / ((part[1] - part[0]) * (part[3] - part[2]))
    return Crowd(part, members, fraction, len({radius for radius, _ in sizes}) <= 1, alone)


def _listed_sizes(
    part: Bounds, species: Sequence[Species], particles: Particles | None
) -> list[tuple[float, int]]:
    """Radius [length] and number of the listed discs whose centres lie in the part."""
    if particles is None or not particles.count:
        return []
    x, y = particles.position.T
    held = (x >= part[0]) & (x <= part[1]) & (y >= part[2]) & (y <= part[3])
    counts = np.bincount(particles.index[held], minlength=len(particles.names)).tolist()
    radius = {entry.name: entry.radius for entry in species}
    named = zip(particles.names, counts, strict=True)
    return [(radius[name], count) for name, count in named if count and name in radius]


def density_problems(
    geometry: Rectangle, species: Sequence[Species], particles: Particles | None
) -> Iterator[Problem]:
    """Parts of the container that are asked to hold too much."""
    whole = (0.0, geometry.width, 0.0, geometry.height)
    for crowd in crowds(geometry, species, particles):
        if crowd.fraction <= crowd.limit * (1 + _ROUNDING):
            continue
        kind = "discs of one size" if crowd.limit == ONE_SIZE_LIMIT else "discs of several sizes or regions"
        single = len(crowd.members) == 1
        path = f"species[{crowd.members[0]}].count" if single else "species"
        where = "" if crowd.bounds == whole else " of the region"
        found = f"an area fraction{where} of {crowd.fraction:.4g}"
        yield Problem(
            path, found, f"at most {crowd.limit:g} for {kind}; use fewer or smaller discs or a larger box"
        )
