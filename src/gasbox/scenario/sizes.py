"""Whether discs and regions fit into the container at all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import shapely

from gasbox.errors import Problem
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.geometry.region import room
from gasbox.scenario.density import centre_bounds
from gasbox.scenario.species import Species

__all__ = ["region_problems", "size_problems"]

_FINEST: Final = 1e-9
"""Least radius or spacing over the longest side: below it, positions in double precision are too coarse."""
_HALVINGS: Final = 20


def size_problems(geometry: Geometry, species: Sequence[Species | None]) -> Iterator[Problem]:
    """Diameters larger than the box (walled or periodic), discs without room, and what is too small to resolve."""
    longest = max(geometry.width, geometry.height)
    for number, entry in enumerate(species):
        if entry is None:
            continue
        path = f"species[{number}].radius"
        too_wide = list(_too_wide(path, geometry, entry))
        yield from too_wide
        if isinstance(geometry, Enclosure) and not too_wide and room(geometry, entry.radius).is_empty:
            allowed = f"no room: the container holds radii up to about {_largest(geometry, entry.radius):.4g}"
            yield Problem(path, f"{entry.radius:g}", allowed)
        if entry.radius < _FINEST * longest:
            allowed = f"at least {_FINEST * longest:g}, {_FINEST:g} of the container's longest side"
            yield Problem(path, f"{entry.radius:g}", allowed)
        if entry.lattice is not None and entry.lattice < _FINEST * longest:
            allowed = f"at least {_FINEST * longest:g}, {_FINEST:g} of the container's longest side"
            yield Problem(f"species[{number}].lattice", f"{entry.lattice:g}", allowed)


def _too_wide(path: str, geometry: Geometry, entry: Species) -> Iterator[Problem]:
    """Discs wider than a rectangle, whose sides and periods stand still."""
    if isinstance(geometry, Enclosure) and not isinstance(geometry.container, Rectangle):
        return
    for side, length, periodic in (
        ("width", geometry.width, geometry.periodic_x),
        ("height", geometry.height, geometry.periodic_y),
    ):
        if 2 * entry.radius > length:
            why = "a disc would overlap itself" if periodic else "a disc would not fit between the walls"
            allowed = f"at most half the container's {side}, {length / 2:g}; {why}"
            yield Problem(path, f"{entry.radius:g}", allowed)


def _largest(geometry: Enclosure, radius: float) -> float:
    """Largest radius [length] of a disc that has room, when `radius` is too large."""
    low, high = 0.0, radius
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if room(geometry, middle).is_empty else (middle, high)
    return low


def region_problems(geometry: Geometry, species: Sequence[Species | None]) -> Iterator[Problem]:
    """Regions that lie outside the container, are turned around, or are too small for one disc."""
    for number, entry in enumerate(species):
        if entry is None or entry.region is None:
            continue
        bounds = entry.bounds(geometry)
        wrong = False
        for axis, low, high, length in (
            ("x", bounds[0], bounds[1], geometry.width),
            ("y", bounds[2], bounds[3], geometry.height),
        ):
            path, found = f"species[{number}].region.{axis}", f"[{low:g}, {high:g}]"
            problem = None
            if low >= high:
                problem = Problem(path, found, "must be [lower end, upper end], the lower one first")
            elif low < 0 or high > length:
                problem = Problem(path, found, f"must lie inside the container, [0, {length:g}]")
            elif high - low < 2 * entry.radius <= length:
                problem = Problem(path, found, f"must be at least a diameter, {2 * entry.radius:g}, wide")
            if problem is not None:
                wrong = True
                yield problem
        if not wrong and isinstance(geometry, Enclosure) and _has_no_place(geometry, entry, bounds):
            found = f"[{bounds[0]:g}, {bounds[1]:g}] x [{bounds[2]:g}, {bounds[3]:g}]"
            yield Problem(f"species[{number}].region", found, "no disc fits into the container there")


def _has_no_place(geometry: Enclosure, entry: Species, bounds: tuple[float, float, float, float]) -> bool:
    """Whether no disc that has room in the container has its place inside the region."""
    reached = room(geometry, entry.radius)
    (left, lower), (right, upper) = centre_bounds(geometry, bounds, entry.radius)
    inner = shapely.box(left, lower, right, upper)
    return not reached.is_empty and reached.intersection(inner).area == 0.0 and not _is_plain(reached, inner)


def _is_plain(reached: shapely.Geometry, inner: shapely.Geometry) -> bool:
    """Whether a region without area (for a single row of discs) lies in what is reached."""
    return bool(inner.area == 0.0 and reached.buffer(1e-9).covers(inner))
