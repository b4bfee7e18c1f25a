"""Whether particles and regions fit into the container at all."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final

import shapely

from gasbox.errors import Problem
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.geometry.discs import extents, fits_between
from gasbox.geometry.region import room
from gasbox.scenario.density import centre_bounds
from gasbox.scenario.kinds import Kind
from gasbox.scenario.species import Species

__all__ = ["region_problems", "size_problems"]

_FINEST: Final = 1e-9
"""Least radius or spacing over the longest side: below it, positions in double precision are too coarse."""
_HALVINGS: Final = 20


def size_problems(
    geometry: Geometry, kinds: Sequence[Kind], species: Sequence[Species | None]
) -> Iterator[Problem]:
    """Particles wider than the box (walled or periodic) or without room, and what is too small to resolve."""
    finest = _FINEST * max(geometry.width, geometry.height)
    coarse = f"at least {finest:g}, {_FINEST:g} of the container's longest side"
    for kind in kinds:
        path = f"{kind.path}.atoms" if kind.is_molecule else f"{kind.path}.radius"
        too_wide = list(
            _molecule_too_wide(path, geometry, kind) if _turns(kind) else _too_wide(path, geometry, kind)
        )
        yield from too_wide
        largest, least = float(kind.radii.max()), float(kind.radii.min())
        if isinstance(geometry, Enclosure) and not too_wide and room(geometry, largest).is_empty:
            allowed = f"no room: the container holds radii up to about {_largest(geometry, largest):.4g}"
            yield Problem(path, _of_radius(kind, largest), allowed)
        if least < finest:
            yield Problem(path, _of_radius(kind, least), coarse)
    for number, entry in enumerate(species):
        if entry is not None and entry.lattice is not None and entry.lattice < finest:
            yield Problem(f"species[{number}].lattice", f"{entry.lattice:g}", coarse)


def _turns(kind: Kind) -> bool:
    return kind.inertia > 0.0


def _of_radius(kind: Kind, radius: float) -> str:
    return f"an atom of radius {radius:g}" if kind.is_molecule else f"{radius:g}"


def _sides(geometry: Geometry) -> Iterator[tuple[str, float, bool]]:
    """Name and length [length] of the sides of a rectangle, and whether they are periodic; nothing of other shapes."""
    if isinstance(geometry, Enclosure) and not isinstance(geometry.container, Rectangle):
        return
    yield "width", geometry.width, geometry.periodic_x
    yield "height", geometry.height, geometry.periodic_y


def _too_wide(path: str, geometry: Geometry, kind: Kind) -> Iterator[Problem]:
    """Discs wider than a rectangle, whose sides and periods stand still."""
    for side, length, periodic in _sides(geometry):
        if 2 * kind.radius > length:
            why = "a disc would overlap itself" if periodic else "a disc would not fit between the walls"
            allowed = f"at most half the container's {side}, {length / 2:g}; {why}"
            yield Problem(path, _of_radius(kind, kind.radius), allowed)


def _molecule_too_wide(path: str, geometry: Geometry, kind: Kind) -> Iterator[Problem]:
    """Molecules that find no room between walls however they are turned, or could meet another on both its sides."""
    between = []
    for side, length, periodic in _sides(geometry):
        between.append(math.inf if periodic else length)
        if periodic and 4 * kind.radius > length:
            allowed = f"at most a quarter of the container's {side}, {length / 4:g}, where it is periodic; "
            allowed += "else two could meet on both sides at once"
            yield Problem(path, f"atoms that reach {kind.radius:g} from the centre of mass", allowed)
    if between and not fits_between(kind.place, kind.radii, *between):
        allowed = f"must fit between the walls, {geometry.width:g} x {geometry.height:g}, turned as it suits"
        yield Problem(path, _outlines(kind), allowed)


def _outlines(kind: Kind) -> str:
    _, width, height = extents(kind.place, kind.radii).T
    slim = int(width.argmin())
    return f"a molecule {height[slim]:g} long and {width[slim]:g} wide"


def _largest(geometry: Enclosure, radius: float) -> float:
    """Largest radius [length] of a disc that has room, when `radius` is too large."""
    low, high = 0.0, radius
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if room(geometry, middle).is_empty else (middle, high)
    return low


def region_problems(geometry: Geometry, kinds: Sequence[Kind]) -> Iterator[Problem]:
    """Regions that lie outside the container, are turned around, or are too small for one particle."""
    for kind in kinds:
        if kind.region is None:
            continue
        bounds = kind.bounds(geometry)
        wrong = list(_wrong_ends(geometry, kind, bounds))
        yield from wrong
        sides = bounds[1] - bounds[0], bounds[3] - bounds[2]
        found = f"[{bounds[0]:g}, {bounds[1]:g}] x [{bounds[2]:g}, {bounds[3]:g}]"
        if not wrong and _turns(kind) and not _fits_region(geometry, kind, *sides):
            yield Problem(
                f"{kind.path}.region", found, f"no room for {_outlines(kind)}, however it is turned"
            )
        elif not wrong and isinstance(geometry, Enclosure) and _has_no_place(geometry, kind, bounds):
            what = "molecule" if kind.is_molecule else "disc"
            yield Problem(f"{kind.path}.region", found, f"no {what} fits into the container there")


def _wrong_ends(
    geometry: Geometry, kind: Kind, bounds: tuple[float, float, float, float]
) -> Iterator[Problem]:
    for axis, low, high, length in (
        ("x", bounds[0], bounds[1], geometry.width),
        ("y", bounds[2], bounds[3], geometry.height),
    ):
        path, found = f"{kind.path}.region.{axis}", f"[{low:g}, {high:g}]"
        if low >= high:
            yield Problem(path, found, "must be [lower end, upper end], the lower one first")
        elif low < 0 or high > length:
            yield Problem(path, found, f"must lie inside the container, [0, {length:g}]")
        elif not _turns(kind) and high - low < 2 * kind.radius <= length:
            yield Problem(path, found, f"must be at least a diameter, {2 * kind.radius:g}, wide")


def _fits_region(geometry: Geometry, kind: Kind, width: float, height: float) -> bool:
    """Whether a molecule has room; a side that goes once round a period has no ends."""
    width = math.inf if geometry.periodic[0] and width == geometry.width else width
    height = math.inf if geometry.periodic[1] and height == geometry.height else height
    return fits_between(kind.place, kind.radii, width, height)


def _has_no_place(geometry: Enclosure, kind: Kind, bounds: tuple[float, float, float, float]) -> bool:
    """Whether no disc that has room in the container has its place inside the region."""
    radius = float(kind.radii.max())
    reached = room(geometry, radius)
    (left, lower), (right, upper) = centre_bounds(geometry, bounds, radius)
    inner = shapely.box(left, lower, right, upper)
    return not reached.is_empty and reached.intersection(inner).area == 0.0 and not _is_plain(reached, inner)


def _is_plain(reached: shapely.Geometry, inner: shapely.Geometry) -> bool:
    """Whether a region without area (for a single row of discs) lies in what is reached."""
    return bool(inner.area == 0.0 and reached.buffer(1e-9).covers(inner))
