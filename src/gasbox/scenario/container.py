"""The box."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, field_validator

from gasbox.geometry import Rectangle
from gasbox.scenario.values import Positive, Section

__all__ = ["RectangleContainer"]


class RectangleContainer(Section):
    """A rectangle [0, width] x [0, height], with walls or periodic."""

    shape: Literal["rectangle"] = "rectangle"
    """Shape of the container."""
    width: Positive
    """Width [length]."""
    height: Positive
    """Height [length]."""
    periodic: Annotated[tuple[Literal["x", "y"], ...], Field(max_length=2)] = ()
    """Directions without walls: a disc that leaves on one side comes back on the other."""

    @field_validator("periodic")
    @classmethod
    def _in_order(cls, value: tuple[Literal["x", "y"], ...]) -> tuple[Literal["x", "y"], ...]:
        return tuple(sorted(set(value)))

    def geometry(self) -> Rectangle:
        """The shape that engines and observers work with."""
        return Rectangle(self.width, self.height, "x" in self.periodic, "y" in self.periodic)
