"""Uniform places in a region of any shape."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Enclosure
from gasbox.geometry.region import room

__all__ = ["Places", "places"]

_CELLS: Final = 64
"""Along the longer side of the box around the region."""


@dataclass(frozen=True)
class Places:
    """Cells that cover what centres can reach.

    Attributes
    ----------
    corner : (k, 2) lower left corner of each cell [length]
    size : (2,) of all cells [length]
    """

    corner: NDArray[np.float64]
    size: NDArray[np.float64]

    def draw(self, count: int, random: np.random.Generator) -> NDArray[np.float64]:
        """Places (count, 2) [length], uniform over the cells, neighbours one after the other."""
        uniform = random.random((count, 2))
        cell, across = np.divmod(uniform[:, 0] * len(self.corner), 1.0)
        cell = np.minimum(cell.astype(np.int64), len(self.corner) - 1)
        drawn = self.corner[cell] + np.stack([across, uniform[:, 1]], axis=1) * self.size
        return drawn[np.argsort(cell, kind="stable")]


def places(
    enclosure: Enclosure, radius: float, low: NDArray[np.float64], high: NDArray[np.float64]
) -> Places | None:
    """Where centres of discs of this radius can be, between `low` and `high` (2,) [length]; None if nowhere."""
    region = room(enclosure, radius).intersection(shapely.box(*low, *high))
    if region.is_empty:
        return None
    left, bottom, right, top = region.bounds
    extent = np.array([right - left, top - bottom])
    cells = np.maximum(np.ceil(_CELLS * extent / max(extent.max(), math.ulp(1.0))), 1).astype(np.int64)
    size = extent / cells
    row, column = np.divmod(np.arange(cells[0] * cells[1]), cells[0])
    corner = np.array([left, bottom]) + np.stack([column, row], axis=1) * size
    shapely.prepare(region)
    met = shapely.intersects(region, shapely.box(*corner.T, *(corner + size).T))
    return Places(corner[met], size)
