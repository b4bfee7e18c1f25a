"""Along which axis something happens in a gas, so that profiles are taken along it."""

from __future__ import annotations

from typing import Literal

from gasbox.app.sample import Sample
from gasbox.geometry import Enclosure, Rectangle, Segment

__all__ = ["axis_of"]


def axis_of(sample: Sample) -> Literal["x", "y"]:
    """The axis nearest to gravity; else across thermal or moving sides, or dividers; else x."""
    geometry = sample.geometry
    gx, gy = geometry.gravity
    if gx or gy:
        return "x" if abs(gx) > abs(gy) else "y"
    if not isinstance(geometry, Enclosure):
        return "x"
    if isinstance(geometry.container, Rectangle):
        special = [wall.temperature is not None or wall.motion is not None for wall in geometry.walls[:4]]
        if any(special):
            return "x" if any(special[:2]) else "y"
    for obstacle in geometry.obstacles:
        if isinstance(obstacle, Segment):
            return "x" if abs(obstacle.normal[0]) >= abs(obstacle.normal[1]) else "y"
    return "x"
