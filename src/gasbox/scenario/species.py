"""A kind of particle, and how many of it the gas starts with."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, Strict

from gasbox.geometry import Geometry
from gasbox.scenario.colors import PALETTE
from gasbox.scenario.values import LARGEST_COUNT, WHOLE, Finite, NotNegative, Positive, Section, Vector

__all__ = ["Region", "Species"]


class Region(Section):
    """A part of the container; discs are placed wholly inside it."""

    x: tuple[Finite, Finite] | None = None
    """Left and right end [length]; without it, the whole width."""
    y: tuple[Finite, Finite] | None = None
    """Lower and upper end [length]; without it, the whole height."""


class Species(Section):
    """A kind of particle."""

    name: Annotated[str, Field(min_length=1, max_length=60)]
    """Name, as in charts and tables; each species has its own."""
    mass: Positive = 1.0
    """Mass of one disc [mass]."""
    radius: Positive = 1.0
    """Radius of one disc [length]."""
    epsilon: NotNegative | None = None
    """Strength of the force between two of them; without it, 1 [energy]."""
    sigma: Positive | None = None
    """Range of the force between two of them; without it, the diameter [length]."""
    charge: Finite | None = None
    """Charge of one disc; without it, 0."""
    color: Annotated[str, Field(pattern=r"^#[0-9a-fA-F]{6}$")] = PALETTE[0]
    """Colour as `#rrggbb`; without it, the next one of a palette."""
    count: Annotated[int, Strict(), Field(ge=0, le=LARGEST_COUNT), WHOLE] = 0
    """How many discs are placed at the start, without overlap."""
    temperature: NotNegative | None = None
    """Start with velocities of the Maxwell distribution at this temperature [mass·length²/time², k_B = 1]."""
    speed: NotNegative | None = None
    """Start with this one speed and random directions [length/time]."""
    velocities: tuple[Vector, ...] | None = None
    """Start with these velocities, one `[vx, vy]` for each of `count` [length/time]."""
    region: Region | None = None
    """Where they are placed; without it, in the whole container."""
    lattice: Positive | None = None
    """Place them on a triangular lattice with this distance of neighbours, around the middle of the region or of the
    container; without it, at random [length]."""

    def bounds(self, geometry: Geometry) -> tuple[float, float, float, float]:
        """Left, right, lower and upper end [length] of where the discs are placed."""
        x = self.region.x if self.region else None
        y = self.region.y if self.region else None
        return *(x or (0.0, geometry.width)), *(y or (0.0, geometry.height))
