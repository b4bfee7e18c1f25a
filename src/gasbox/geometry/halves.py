"""The two sides of a segment: how much room there is on each."""

from __future__ import annotations

import functools

import numpy as np
import shapely

from gasbox.geometry import region
from gasbox.geometry.elements import side_count
from gasbox.geometry.enclosure import Enclosure
from gasbox.geometry.shapes import Segment

__all__ = ["half_areas"]


@functools.lru_cache(maxsize=64)
def half_areas(enclosure: Enclosure, wall: int, radius: float) -> tuple[float, float]:
    """Area [length²] that centres of discs of this radius can reach behind the line of a segment, and ahead of it.

    The line has no ends; behind is where its normal comes from. Nobody passes the segment, whatever its wall says.

    Parameters
    ----------
    enclosure : with its walls where they are, see `Enclosure.at`
    wall : index of the wall of the segment
    """
    segment = enclosure.obstacles[wall - side_count(enclosure.container)]
    assert isinstance(segment, Segment)
    room = region.room(enclosure.with_wall(wall, passes=None), radius)
    normal = np.array(segment.normal)
    moved = enclosure.displacement[wall] if enclosure.displacement else 0.0
    point = np.array(segment.start) + moved * normal
    along = 4.0 * float(enclosure.size.sum()) * np.array([-normal[1], normal[0]])
    ahead = 4.0 * float(enclosure.size.sum()) * normal
    strip = [point - along, point + along, point + along + ahead, point - along + ahead]
    part = float(shapely.intersection(room, shapely.Polygon(strip)).area)
    return float(room.area) - part, part
