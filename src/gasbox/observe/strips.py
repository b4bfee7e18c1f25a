"""How much of each strip across a container the centres of discs can reach: what densities are normalised by."""

from __future__ import annotations

import functools
import itertools
import math
from typing import Literal

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from gasbox.geometry import Geometry, Rectangle
from gasbox.geometry.region import room

__all__ = ["Axis", "direction_of", "extent", "strip_areas"]

Axis = Literal["x", "y"] | float
"""Along which a profile is taken: x, y, or an angle from x [radian]."""


def direction_of(axis: Axis) -> tuple[float, float]:
    """Unit vector along an axis."""
    if axis == "x":
        return (1.0, 0.0)
    if axis == "y":
        return (0.0, 1.0)
    return (math.cos(axis), math.sin(axis))


def extent(geometry: Geometry, axis: Axis) -> tuple[float, float]:
    """From where to where the box around a geometry reaches along an axis [length]."""
    x, y = direction_of(axis)
    ends = (0.0, geometry.width * x, geometry.height * y, geometry.width * x + geometry.height * y)
    return min(ends), max(ends)


def strip_areas(
    geometry: Geometry, radius: float, axis: Axis, edges: NDArray[np.float64]
) -> NDArray[np.float64]:
    """(bins,) float64 [length²]: area of each strip across an axis that centres of this radius can reach.

    Parameters
    ----------
    edges : (bins+1,) ascending, places along the axis [length]
    """
    return _areas(geometry, float(radius), axis, tuple(edges.tolist())).copy()


@functools.lru_cache(maxsize=512)
def _areas(geometry: Geometry, radius: float, axis: Axis, edges: tuple[float, ...]) -> NDArray[np.float64]:
    region = _room(geometry, radius)
    shapely.prepare(region)
    x, y = direction_of(axis)
    far = geometry.width + geometry.height
    # A strip between two places along (x, y), far longer than the box is wide.
    strips = [
        shapely.Polygon(
            [
                (along * x - across * y, along * y + across * x)
                for along, across in ((low, -far), (high, -far), (high, far), (low, far))
            ]
        )
        for low, high in itertools.pairwise(edges)
    ]
    return np.asarray(shapely.area(shapely.intersection(np.array(strips, object), region)), np.float64)


def _room(geometry: Geometry, radius: float) -> BaseGeometry:
    if not isinstance(geometry, Rectangle):
        return room(geometry, radius)
    width, height = geometry.accessible_size(radius)
    if width <= 0.0 or height <= 0.0:
        return shapely.Polygon()
    left, bottom = 0.5 * (geometry.width - width), 0.5 * (geometry.height - height)
    return shapely.box(left, bottom, left + width, bottom + height)
