"""Whether discs and regions fit into the container at all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.species import Species

__all__ = ["region_problems", "size_problems"]

_FINEST: Final = 1e-9
"""Least radius over the longest side: below it, positions in double precision are too coarse."""


def size_problems(geometry: Rectangle, species: Sequence[Species | None]) -> Iterator[Problem]:
    """Diameters larger than the box (walled or periodic), and radii too small to resolve."""
    longest = max(geometry.width, geometry.height)
    for number, entry in enumerate(species):
        if entry is None:
            continue
        path = f"species[{number}].radius"
        for side, length, periodic in (
            ("width", geometry.width, geometry.periodic_x),
            ("height", geometry.height, geometry.periodic_y),
        ):
            if 2 * entry.radius > length:
                why = "a disc would overlap itself" if periodic else "a disc would not fit between the walls"
                allowed = f"at most half the container's {side}, {length / 2:g}; {why}"
                yield Problem(path, f"{entry.radius:g}", allowed)
        if entry.radius < _FINEST * longest:
            allowed = f"at least {_FINEST * longest:g}, {_FINEST:g} of the container's longest side"
            yield Problem(path, f"{entry.radius:g}", allowed)


def region_problems(geometry: Rectangle, species: Sequence[Species | None]) -> Iterator[Problem]:
    """Regions that lie outside the container, are turned around, or are too small for one disc."""
    for number, entry in enumerate(species):
        if entry is None or entry.region is None:
            continue
        bounds = entry.bounds(geometry)
        for axis, low, high, length in (
            ("x", bounds[0], bounds[1], geometry.width),
            ("y", bounds[2], bounds[3], geometry.height),
        ):
            path, found = f"species[{number}].region.{axis}", f"[{low:g}, {high:g}]"
            if low >= high:
                yield Problem(path, found, "must be [lower end, upper end], the lower one first")
            elif low < 0 or high > length:
                yield Problem(path, found, f"must lie inside the container, [0, {length:g}]")
            elif high - low < 2 * entry.radius <= length:
                yield Problem(path, found, f"must be at least a diameter, {2 * entry.radius:g}, wide")
