"""The box as a browser draws it."""

from __future__ import annotations

import io

import numpy as np
from matplotlib.image import imread
from numpy.typing import NDArray
from playwright.sync_api import Page


def pixels(page: Page) -> NDArray[np.float64]:
    """(height, width, 3), 0 to 1."""
    image: NDArray[np.float64] = imread(io.BytesIO(page.locator(".gasbox-lab").screenshot()))
    return image[:, :, :3]


def changed(before: NDArray[np.float64], after: NDArray[np.float64]) -> float:
    """Share of the pixels that differ; a level or two, by which a compositor may round, does not count."""
    return float(np.mean(np.any(np.abs(after - before) > 2.5 / 255, axis=2)))
