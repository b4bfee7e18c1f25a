"""How much of the gas starts in which part of a container that is divided."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Enclosure
from gasbox.geometry.region import components, room
from gasbox.scenario.particles import Particles
from gasbox.scenario.species import Species

__all__ = ["shares"]


def shares(
    geometry: Enclosure, species: Sequence[Species | None], particles: Particles | None
) -> NDArray[np.float64]:
    """Area of the discs [length²] in each of the parts between which no disc can pass, the leftmost part first.

    Counted discs are spread over what their centres can reach of their region, as they are when they are placed.
    """
    parts = components(geometry, 0.0)
    found = np.zeros(len(parts))
    for entry in species:
        if entry is None:
            continue
        disc = math.pi * entry.radius**2
        if entry.count and len(parts):
            left, right, lower, upper = entry.bounds(geometry)
            reached = room(geometry, entry.radius).intersection(shapely.box(left, lower, right, upper))
            areas = np.array([reached.intersection(part).area for part in parts])
            if areas.sum() > 0.0:
                found += disc * entry.count * areas / areas.sum()
        if particles is not None and entry.name in particles.names:
            places = particles.position[particles.index == particles.names.index(entry.name)]
            found += disc * np.array([shapely.contains_xy(part, *places.T).sum() for part in parts])
    return found
