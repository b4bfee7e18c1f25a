"""What is run at each point of a phase diagram, and where the points are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

__all__ = ["FULL", "QUICK", "Recipe", "grid_points"]


@dataclass(frozen=True)
class Recipe:
    """How each point is run.

    Attributes
    ----------
    particles : discs at each point
    cutoff : of the forces [sigma]; the energy there is taken off
    settle : simulated time before anything is measured [time]; more in a thin gas
    measure : simulated time over which means are taken [time]
    seed : of all points
    """

    particles: int = 500
    cutoff: float = 2.5
    settle: float = 400.0
    measure: float = 100.0
    seed: int = 1


FULL: Final = Recipe()
QUICK: Final = Recipe(particles=200, settle=300.0, measure=100.0)
"""A rough diagram in half a minute."""

_TEMPERATURES: Final = (0.32, 0.60)
_DENSITIES: Final = (0.03, 0.93)
_DIGITS: Final = 5


def grid_points(temperatures: int, densities: int) -> list[tuple[float, float]]:
    """(temperature [energy], density [1/length²]) of so many rows and columns, evenly spread over the interesting part.

    From below the triple point to above the critical one, and from a thin gas to a crystal without holes.
    """
    warm, dense = (
        [round(float(value), _DIGITS) for value in np.linspace(*ends, number)]
        for ends, number in ((_TEMPERATURES, temperatures), (_DENSITIES, densities))
    )
    return [(temperature, density) for temperature in warm for density in dense]
