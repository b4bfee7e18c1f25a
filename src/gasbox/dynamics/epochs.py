"""How long an epoch of event-driven dynamics is, and how many events to expect."""

from __future__ import annotations

import math

import numpy as np

from gasbox.geometry import Enclosure, Geometry
from gasbox.state import State

__all__ = ["epoch_length", "expected_rate"]


def epoch_length(state: State, geometry: Geometry) -> float:
    """Length of an epoch [time]: a power of two in which a disc flies some 500 radii, or a few times across the box.

    References move to the next epoch at whole multiples of it, so that late times lose no digits.
    """
    speed = _typical_speed(state, geometry)
    if speed == 0.0:
        return 2.0**20
    way = max(500.0 * float(np.median(state.radius)), geometry.width, geometry.height)
    return 2.0 ** round(math.log2(way / speed))


def _typical_speed(state: State, geometry: Geometry) -> float:
    """Of the discs as they are, and of what gravity and warm walls may make of them [length/time]."""
    if not state.count:
        return 0.0
    square = _mean_square(state)
    if isinstance(geometry, Enclosure):
        square += 0.5 * math.hypot(*geometry.gravity) * float(geometry.size.max())
        warmest = max((wall.temperature or 0.0 for wall in geometry.walls), default=0.0)
        square += warmest / float(state.mass.min())
    return math.sqrt(square)


def _mean_square(state: State) -> float:
    """Of the speed, turning included [length²/time²]."""
    square = float((state.velocity**2).sum(axis=1).mean())
    if state.sites is not None:
        square += float((state.inertia * state.angular_velocity**2 / state.mass).mean())
    return square


def expected_rate(state: State, geometry: Geometry, epoch: float) -> float:
    """Events per time to expect before any were counted; rather too many, since empty buckets cost little."""
    if not state.count:
        return 1.0
    spacing = math.sqrt(geometry.area / state.count)
    return max(8.0 * state.count * math.sqrt(_mean_square(state)) / spacing, 1.0 / epoch)
