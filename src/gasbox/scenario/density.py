"""How densely discs may be placed, and which of them compete for the same room."""

from __future__ import annotations

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
    """

    bounds: Bounds
    members: tuple[int, ...]
    fraction: float
    one_size: bool

    @property
    def limit(self) -> float:
        """Greatest area fraction at which these are placed."""
        return ONE_SIZE_LIMIT if self.one_size else MIXTURE_LIMIT


def crowds(geometry: Rectangle, species: Sequence[Species], particles: Particles | None) -> tuple[Crowd, ...]:
    """One crowd for each part of the container that is asked for, and one for the whole of several parts."""
    asked = [entry.bounds(geometry) for entry in species if entry.count]
    whole = (0.0, geometry.width, 0.0, geometry.height)
    parts = list(dict.fromkeys(asked))
    if len(parts) > 1 and whole not in parts:
        parts.append(whole)
    return tuple(_crowd(part, geometry, species, particles) for part in parts)


def _crowd(
    part: Bounds, geometry: Rectangle, species: Sequence[Species], particles: Particles | None
) -> Crowd:
    members = tuple(
        number
        for number, entry in enumerate(species)
        if entry.count and _inside(entry.bounds(geometry), part)
    )
    area = sum(species[number].count * math.pi * species[number].radius ** 2 for number in members)
    radii = {species[number].radius for number in members}
    if particles is not None and particles.count:
        x, y = particles.position.T
        held = (x >= part[0]) & (x <= part[1]) & (y >= part[2]) & (y <= part[3])
        counts = np.bincount(particles.index[held], minlength=len(particles.names))
        sizes = {entry.name: entry.radius for entry in species}
        for name, count in zip(particles.names, counts.tolist(), strict=True):
            if count and name in sizes:
                area += count * math.pi * sizes[name] ** 2
                radii.add(sizes[name])
    return Crowd(part, members, area / ((part[1] - part[0]) * (part[3] - part[2])), len(radii) <= 1)


def _inside(inner: Bounds, outer: Bounds) -> bool:
    return inner[0] >= outer[0] and inner[1] <= outer[1] and inner[2] >= outer[2] and inner[3] <= outer[3]


def density_problems(
    geometry: Rectangle, species: Sequence[Species], particles: Particles | None
) -> Iterator[Problem]:
    """Parts of the container that are asked to hold too much."""
    whole = (0.0, geometry.width, 0.0, geometry.height)
    for crowd in crowds(geometry, species, particles):
        if crowd.fraction <= crowd.limit * (1 + _ROUNDING):
            continue
        kind = "discs of one size" if crowd.one_size else "discs of several sizes"
        single = len(crowd.members) == 1
        path = f"species[{crowd.members[0]}].count" if single else "species"
        where = "" if crowd.bounds == whole else " of the region"
        found = f"an area fraction{where} of {crowd.fraction:.4g}"
        yield Problem(
            path, found, f"at most {crowd.limit:g} for {kind}; use fewer or smaller discs or a larger box"
        )
