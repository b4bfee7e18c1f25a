"""How much of the gas starts in which part of a container that is divided."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Enclosure
from gasbox.geometry.region import components, room
from gasbox.scenario.kinds import Kind
from gasbox.scenario.particles import Particles

__all__ = ["shares"]


def shares(geometry: Enclosure, kinds: Sequence[Kind], particles: Particles | None) -> NDArray[np.float64]:
    """Area of the particles [length²] in each of the parts between which no disc can pass, the leftmost part first.

    Counted ones are spread over what their centres can reach of their region, as they are when they are placed.
    """
    parts = components(geometry, 0.0)
    found = np.zeros(len(parts))
    for entry in kinds:
        if entry.count and len(parts):
            left, right, lower, upper = entry.bounds(geometry)
            reached = room(geometry, float(entry.radii.min())).intersection(
                shapely.box(left, lower, right, upper)
            )
            areas = np.array([reached.intersection(part).area for part in parts])
            if areas.sum() > 0.0:
                found += entry.area * entry.count * areas / areas.sum()
        if particles is not None and entry.name in particles.names:
            places = particles.position[particles.index == particles.names.index(entry.name)]
            found += entry.area * np.array([shapely.contains_xy(part, *places.T).sum() for part in parts])
    return found
