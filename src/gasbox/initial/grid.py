"""Builds the grids in which discs of any sizes find each other."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.kernels.size_grid import SizeGrid

__all__ = ["empty_grid"]

_MOST_CLASSES: Final = 32


def empty_grid(geometry: Geometry, radius: NDArray[np.float64]) -> SizeGrid:
    """Grids without discs, for discs of these radii (n,) [length]."""
    size_class, top, counts = _classes(radius)
    cells = np.array(
        [_cells(geometry, 2 * largest, count) for largest, count in zip(top, counts, strict=True)], np.int64
    ).reshape(-1, 2)
    numbers = cells[:, 0] * cells[:, 1]
    return SizeGrid(
        size=geometry.size,
        periodic=geometry.periodic,
        top=top,
        cells=cells,
        width=geometry.size / cells,
        offset=np.cumsum(numbers) - numbers,
        head=np.full(int(numbers.sum()), -1, np.int32),
        next=np.full(radius.shape[0], -1, np.int32),
        size_class=size_class,
    )


def _classes(
    radius: NDArray[np.float64],
) -> tuple[NDArray[np.int32], NDArray[np.float64], NDArray[np.int64]]:
    """Class of each disc (coarsest first, no empty ones), largest radius and number of discs of each class."""
    if not radius.size:
        return np.zeros(0, np.int32), np.zeros(0), np.zeros(0, np.int64)
    octave = np.minimum(np.floor(np.log2(radius.max() / radius)), _MOST_CLASSES - 1)
    _, size_class, counts = np.unique(octave, return_inverse=True, return_counts=True)
    top = np.zeros(counts.shape[0])
    np.maximum.at(top, size_class, radius)
    return size_class.astype(np.int32), top, counts


def _cells(geometry: Geometry, diameter: float, count: int) -> tuple[int, int]:
    """Number of cells along x and y: at least a diameter wide, and not many more than discs."""
    most = 4 * count + 64
    width = max(diameter, math.sqrt(geometry.width * geometry.height / most))
    columns = max(1, min(most, int(geometry.width / width)))
    rows = max(1, min(most, int(geometry.height / width)))
    return columns, rows
