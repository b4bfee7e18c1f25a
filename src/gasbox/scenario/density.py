"""How densely particles may be placed, and which of them compete for the same room."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
import shapely

from gasbox.errors import Problem
from gasbox.geometry import Enclosure, Geometry, Rectangle, side_count
from gasbox.geometry.solids import blocks as blocks_somebody
from gasbox.geometry.solids import images, outline, shape_of
from gasbox.scenario.kinds import Kind
from gasbox.scenario.particles import Particles

__all__ = ["MIXTURE_LIMIT", "ONE_SIZE_LIMIT", "Crowd", "centre_bounds", "crowds", "density_problems"]

ONE_SIZE_LIMIT: Final = 0.7
"""Greatest area fraction at which discs of one size are placed in a rectangle with nothing in it."""
MIXTURE_LIMIT: Final = 0.5
"""Greatest area fraction at which discs of several sizes, or in any other shape, are placed."""
_ROUNDING: Final = 1e-9

Bounds = tuple[float, float, float, float]
Vector = tuple[float, float]


@dataclass(frozen=True)
class Crowd:
    """Particles that have to share one part of the container.

    Attributes
    ----------
    bounds : left, right, lower and upper end [length] of a rectangle; what of the container lies in it is the part
    area : of the part, without blocks and posts [length²]
    members : indices of the kinds placed wholly inside it
    fraction : area of all particles inside (listed ones, too) over the area of that part
    one_size : whether all particles inside are discs of one radius
    alone : whether no particle from elsewhere can get in the way: no other part overlaps this one
    plain : whether the part is the whole rectangle, with nothing standing in it
    soft : whether forces will push apart what overlaps a little
    """

    bounds: Bounds
    members: tuple[int, ...]
    fraction: float
    one_size: bool
    alone: bool
    area: float
    plain: bool = True
    soft: bool = False

    @property
    def limit(self) -> float:
        """Greatest area fraction at which these are placed."""
        easy = self.soft or (self.one_size and self.alone and self.plain)
        return ONE_SIZE_LIMIT if easy else MIXTURE_LIMIT


def crowds(
    geometry: Geometry, kinds: Sequence[Kind], particles: Particles | None, soft: bool = False
) -> tuple[Crowd, ...]:
    """One crowd for each part of the container that is asked for; if any overlap, the last one is the whole."""
    whole = (0.0, geometry.width, 0.0, geometry.height)
    parts = list(dict.fromkeys(entry.bounds(geometry) for entry in kinds if entry.count))
    overlapping = any(_overlap(one, other) for one, other in itertools.combinations(parts, 2))
    if overlapping:
        parts = [part for part in parts if part != whole] + [whole]
    found = (_crowd(part, not overlapping, geometry, kinds, particles) for part in parts)
    return tuple(replace(crowd, soft=soft) for crowd in found)


def _overlap(one: Bounds, other: Bounds) -> bool:
    return max(one[0], other[0]) < min(one[1], other[1]) and max(one[2], other[2]) < min(one[3], other[3])


def _inside(inner: Bounds, outer: Bounds) -> bool:
    return inner[0] >= outer[0] and inner[1] <= outer[1] and inner[2] >= outer[2] and inner[3] <= outer[3]


def _crowd(
    part: Bounds, alone: bool, geometry: Geometry, kinds: Sequence[Kind], particles: Particles | None
) -> Crowd:
    members = tuple(
        number for number, entry in enumerate(kinds) if entry.count and _inside(entry.bounds(geometry), part)
    )
    held = [(kinds[number], kinds[number].count) for number in members]
    held += _listed(part, kinds, particles)
    area = sum(count * kind.area for kind, count in held)
    room, plain = _room(part, geometry)
    one_size = len({kind.radius for kind, _ in held}) <= 1 and all(len(kind.sites) == 1 for kind, _ in held)
    return Crowd(part, members, area / room if room else math.inf, one_size, alone, room, plain)


def _room(part: Bounds, geometry: Geometry) -> tuple[float, bool]:
    """Area [length²] of what of the container lies in a part, and whether it is all of it."""
    whole = (part[1] - part[0]) * (part[3] - part[2])
    if isinstance(geometry, Rectangle):
        return whole, True
    frame = shapely.box(part[0], part[2], part[1], part[3])
    standing, first = [], side_count(geometry.container)
    for number, obstacle in enumerate(geometry.obstacles):
        if blocks_somebody(geometry.walls[first + number]):
            shape, radius = shape_of(obstacle)
            shape = shape.buffer(radius, quad_segs=64) if radius else shape
            standing += [shapely.transform(shape, lambda at, by=by: at + by) for by in images(geometry)]
    # Where a part goes once round, it has no edge on which an obstacle could stand.
    round_x = geometry.periodic_x and part[1] - part[0] >= geometry.width
    round_y = geometry.periodic_y and part[3] - part[2] >= geometry.height
    core = shapely.box(part[0] - round_x, part[2] - round_y, part[1] + round_x, part[3] + round_y).buffer(
        -_ROUNDING * max(geometry.size)
    )
    plain = isinstance(geometry.container, Rectangle) and not any(
        shape.intersects(core) for shape in standing
    )
    if plain:
        return whole, True
    if part == (0.0, geometry.width, 0.0, geometry.height):
        return geometry.area, False
    inside = outline(geometry).intersection(frame)
    return float(inside.difference(shapely.union_all(standing)).area), False


def centre_bounds(geometry: Geometry, part: Bounds, radius: float) -> tuple[Vector, Vector]:
    """Lower and upper bounds (x, y) [length] of the centres of discs that shall lie wholly in a part.

    Where an edge of the part is that of the container, its walls keep the discs inside, unless they are open.
    """
    low, high = [], []
    for axis, length in enumerate((geometry.width, geometry.height)):
        begin, end = part[2 * axis], part[2 * axis + 1]
        before, after = radius, radius
        if geometry.periodic[axis] and begin == 0.0 and end == length:
            before, after = 0.0, 0.0
        elif isinstance(geometry, Enclosure):
            before = 0.0 if begin == 0.0 and _is_open(geometry, 2 * axis) else radius
            after = 0.0 if end == length and _is_open(geometry, 2 * axis + 1) else radius
        # A disc exactly as wide as its part has one place; rounding may have turned the bounds around.
        low.append(min(begin + before, end - after))
        high.append(end - after)
    return (low[0], low[1]), (high[0], high[1])


def _is_open(geometry: Enclosure, wall: int) -> bool:
    """Whether discs may lie across an edge of the box around a container, because what is there is open."""
    if isinstance(geometry.container, Rectangle):
        return geometry.walls[wall].open
    return any(entry.open for entry in geometry.walls[: side_count(geometry.container)])


def _listed(part: Bounds, kinds: Sequence[Kind], particles: Particles | None) -> list[tuple[Kind, int]]:
    """Kind and number of the listed particles whose centres lie in the part."""
    if particles is None or not particles.count:
        return []
    x, y = particles.position.T
    held = (x >= part[0]) & (x <= part[1]) & (y >= part[2]) & (y <= part[3])
    counts = np.bincount(particles.index[held], minlength=len(particles.names)).tolist()
    known = {kind.name: kind for kind in kinds}
    named = zip(particles.names, counts, strict=True)
    return [(known[name], count) for name, count in named if count and name in known]


def density_problems(
    geometry: Geometry, found: Sequence[Crowd], paths: Sequence[str], discs: str = "discs"
) -> Iterator[Problem]:
    """Parts of the container that are asked to hold too much.

    Parameters
    ----------
    paths : of the kinds
    discs : what to call those that were counted
    """
    whole = (0.0, geometry.width, 0.0, geometry.height)
    for crowd in found:
        if crowd.fraction <= crowd.limit * (1 + _ROUNDING):
            continue
        molecules = any(paths[member].startswith("molecules") for member in crowd.members)
        kind = (
            f"{discs} of one size"
            if crowd.limit == ONE_SIZE_LIMIT
            else discs
            if molecules
            else f"{discs} of several sizes or regions"
        )
        if not crowd.plain:
            kind = f"{discs} beside obstacles or in a shape that is no rectangle"
        kind = discs if crowd.soft else kind
        path = f"{paths[crowd.members[0]]}.count"
        if len(crowd.members) > 1:
            path = "molecules" if molecules else "species"
        where = "" if crowd.bounds == whole else " of the region"
        area = f"an area fraction{where} of {crowd.fraction:.4g}"
        yield Problem(
            path,
            area,
            f"at most {crowd.limit:g} for {kind}; use fewer or smaller {discs.split()[0]} or a larger box",
        )
