"""Areas, lengths and regions of an enclosure."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from gasbox.geometry.enclosure import Enclosure


def anchored(enclosure: Enclosure, number: int) -> tuple[bool, bool]:
    raise NotImplementedError


def wall_length(enclosure: Enclosure, wall: int) -> float:
    raise NotImplementedError


def area(enclosure: Enclosure) -> float:
    raise NotImplementedError


def accessible_area(enclosure: Enclosure, radius: float) -> float:
    raise NotImplementedError


def accessible_size(enclosure: Enclosure, radius: float) -> tuple[float, float]:
    raise NotImplementedError


def accessible_length(enclosure: Enclosure, wall: int, radius: float) -> float:
    raise NotImplementedError


def holds(enclosure: Enclosure, position: NDArray[np.float64], radius: NDArray[np.float64] | float) -> NDArray[np.bool_]:
    raise NotImplementedError
