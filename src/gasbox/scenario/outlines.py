"""Whether the corners of a polygon go once around an area."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.errors import Problem
from gasbox.scenario.problems import short

__all__ = ["outline_problems"]

_FINEST: Final = 1e-9
"""Of the extent of a polygon: what is shorter has no length."""
_SHOWN: Final = 5
"""So many wrong places are named."""


def outline_problems(path: str, vertices: tuple[tuple[float, float], ...]) -> list[Problem]:
    """Corners that coincide, sides that cross, and an area that vanishes; `path` leads to the vertices."""
    corner = np.array(vertices, np.float64)
    extent = float(np.ptp(corner, axis=0).max())
    double = list(_coinciding(path, corner, _FINEST * extent))
    if double:
        return double
    crossing = list(_crossing(path, corner))
    if crossing:
        return crossing
    if not shapely.Polygon(corner).area > _FINEST * extent**2:
        return [Problem(path, "corners on one line", "must enclose an area")]
    return []


def _coinciding(path: str, corner: NDArray[np.float64], margin: float) -> Iterator[Problem]:
    before = np.roll(corner, 1, axis=0)
    for number in np.flatnonzero(np.hypot(*(corner - before).T) <= margin)[:_SHOWN]:
        # Of the first and the last one, the last is too many.
        place, other = (number, number - 1) if number else (len(corner) - 1, 0)
        allowed = f"must differ from its neighbour, vertex {other}: every side needs a length"
        if not number:
            allowed = "must differ from the first one, to which it is joined anyway"
        yield Problem(f"{path}[{place}]", short(corner[place].tolist()), allowed)


def _crossing(path: str, corner: NDArray[np.float64]) -> Iterator[Problem]:
    """Sides that meet anywhere but at the corner that they share."""
    count = len(corner)
    after = np.roll(corner, -1, axis=0)
    sides = shapely.linestrings(np.stack([corner, after], axis=1))
    first, second = shapely.STRtree(sides).query(sides, predicate="intersects")
    shown = 0
    for one, other in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        if other <= one:
            continue
        meeting = shapely.intersection(sides[one], sides[other])
        if (other - one) in (1, count - 1) and meeting.length == 0.0:
            continue
        place = shapely.get_coordinates(meeting)[0].tolist()
        found = f"sides {one + 1} and {other + 1} meet at [{place[0]:g}, {place[1]:g}]"
        yield Problem(path, found, "sides may meet at the corner that they share, nowhere else")
        shown += 1
        if shown == _SHOWN:
            return
