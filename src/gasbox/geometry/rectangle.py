"""The rectangle [0, width] x [0, height], walled or periodic in x, y or both."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

__all__ = ["Rectangle"]


@dataclass(frozen=True)
class Rectangle:
    """A rectangular box.

    Attributes
    ----------
    width, height : [length]
    periodic_x, periodic_y : whether a disc that leaves on one side comes back on the other
    """

    width: float
    height: float
    periodic_x: bool = False
    periodic_y: bool = False

    WALLS: ClassVar[tuple[str, ...]] = ("left", "right", "bottom", "top")
    """Names of the walls, in the order of their indices. A periodic direction leaves its two walls unused."""

    @property
    def wall_names(self) -> tuple[str, ...]:
        """In the order of the indices."""
        return self.WALLS

    @property
    def gravity(self) -> tuple[float, float]:
        """None: (0, 0)."""
        return (0.0, 0.0)

    @property
    def moves(self) -> bool:
        """Whether any wall moves: none does."""
        return False

    def at(self, displacement: NDArray[np.float64]) -> Rectangle:
        """The rectangle as large as a barostat has made it; its lower left corner stays at the origin.

        Parameters
        ----------
        displacement : (walls,) [length], of each wall since the start, right and up > 0; empty for none
        """
        if not np.any(displacement):
            return self
        left, right, bottom, top = (float(way) for way in displacement[:4])
        return replace(self, width=self.width + right - left, height=self.height + top - bottom)

    @property
    def area(self) -> float:
        """Whole area [length²]."""
        return self.width * self.height

    @property
    def size(self) -> NDArray[np.float64]:
        """(2,) float64 [length]: width, height."""
        return np.array([self.width, self.height])

    @property
    def periodic(self) -> NDArray[np.bool_]:
        """(2,) bool: periodic in x, in y."""
        return np.array([self.periodic_x, self.periodic_y])

    @property
    def is_walled(self) -> bool:
        """Whether there is any wall at all."""
        return not (self.periodic_x and self.periodic_y)

    def accessible_size(self, radius: float) -> tuple[float, float]:
        """Width and height [length] that centres of discs of this radius can reach."""
        return (
            self.width if self.periodic_x else self.width - 2 * radius,
            self.height if self.periodic_y else self.height - 2 * radius,
        )

    def accessible_area(self, radius: float) -> float:
        """Area [length²] that centres of discs of this radius can reach."""
        width, height = self.accessible_size(radius)
        return width * height

    def accessible_length(self, wall: int, radius: float) -> float:
        """Length [length] of a wall along which centres of this radius can touch it; 0 where the side is periodic."""
        width, height = self.accessible_size(radius)
        if wall < 2:
            return 0.0 if self.periodic_x else height
        return 0.0 if self.periodic_y else width

    def holds(self, position: NDArray[np.float64], radius: NDArray[np.float64] | float) -> NDArray[np.bool_]:
        """(n,) bool: whether each disc lies inside all walls; pass radius 0 to ask for centres only."""
        inside = np.ones(position.shape[0], dtype=bool)
        for axis, (length, periodic) in enumerate(zip(self.size, self.periodic, strict=True)):
            if not periodic:
                inside &= (position[:, axis] >= radius) & (position[:, axis] <= length - radius)
        return inside

    def wrap(self, position: NDArray[np.float64]) -> NDArray[np.float64]:
        """Positions (n, 2) [length] moved into the box along its periodic directions."""
        wrapped = position.copy()
        for axis, (length, periodic) in enumerate(zip(self.size, self.periodic, strict=True)):
            if periodic:
                wrapped[:, axis] -= np.floor(wrapped[:, axis] / length) * length
        return wrapped
