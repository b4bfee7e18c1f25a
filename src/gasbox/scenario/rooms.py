"""Boxes in a rectangle: the rooms of walkers."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario.dynamics import Rooms
from gasbox.scenario.species import Region

__all__ = ["ends_of", "room_boxes"]


def room_boxes(rooms: Rooms, size: tuple[float, float]) -> NDArray[np.float64]:
    """(m, 4) float64 [length]: the rooms in a container of this size [length]."""
    left, lower, right, upper = ends_of(rooms.region or Region(), size)
    width = (right - left - (rooms.columns - 1) * rooms.gap) / rooms.columns
    height = (upper - lower - (rooms.rows - 1) * rooms.gap) / rooms.rows
    row, column = np.divmod(np.arange(rooms.rows * rooms.columns), rooms.columns)
    x, y = left + column * (width + rooms.gap), lower + row * (height + rooms.gap)
    return np.stack([x, y, x + width, y + height], axis=1)


def ends_of(region: Region, size: tuple[float, float]) -> NDArray[np.float64]:
    """(4,) float64 [length]: left, lower, right and upper end of a region of a container of this size [length]."""
    x, y = region.x or (0.0, size[0]), region.y or (0.0, size[1])
    return np.array([x[0], y[0], x[1], y[1]], np.float64)
