"""The box: a rectangle, a circle, or a polygon."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from pydantic import BeforeValidator, ConfigDict, Field, Strict, field_validator
from pydantic.config import JsonDict

from gasbox.geometry import Circle, Polygon, Rectangle, regular_polygon, signed_area
from gasbox.scenario.values import WHOLE, Finite, Positive, Section, Vector

__all__ = [
    "SHAPES",
    "CircleContainer",
    "Container",
    "PolygonContainer",
    "RectangleContainer",
    "RegularPolygonContainer",
    "Vertices",
]

_SHAPE_REQUIRED: Final[JsonDict] = {"required": ["shape"]}
"""In a file the shape must be said (of a rectangle it may be left out); in Python the class says it."""

Vertices = Annotated[tuple[Vector, ...], Field(min_length=3, max_length=10_000)]


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


class CircleContainer(Section):
    """A circle with its centre at [radius, radius]."""

    model_config = ConfigDict(json_schema_extra=_SHAPE_REQUIRED)

    shape: Literal["circle"] = "circle"
    """Shape of the container."""
    radius: Positive
    """Radius [length]."""

    def geometry(self) -> Circle:
        """The shape that engines and observers work with."""
        return Circle(self.radius)


class PolygonContainer(Section):
    """The inside of a simple polygon, convex or not; its sides are side-1 (from the first vertex), side-2, ..."""

    model_config = ConfigDict(json_schema_extra=_SHAPE_REQUIRED)

    shape: Literal["polygon"] = "polygon"
    """Shape of the container."""
    vertices: Vertices
    """Corners in order, either way round, with no coordinate below 0 [length]."""

    def geometry(self) -> Polygon:
        """The shape that engines and observers work with; vertices counter-clockwise, the first one stays first."""
        if signed_area(self.vertices) >= 0:
            return Polygon(self.vertices)
        return Polygon((self.vertices[0], *self.vertices[:0:-1]))


class RegularPolygonContainer(Section):
    """A regular polygon, moved so that it touches both axes; side-1 leads from its first corner counter-clockwise."""

    model_config = ConfigDict(json_schema_extra=_SHAPE_REQUIRED)

    shape: Literal["regular-polygon"] = "regular-polygon"
    """Shape of the container."""
    sides: Annotated[int, Strict(), Field(ge=3, le=1000), WHOLE]
    """Number of sides."""
    radius: Positive
    """Distance of the corners from the centre [length]."""
    rotation: Finite = 0.0
    """Direction of the first corner as seen from the centre [radian]."""

    def geometry(self) -> Polygon:
        """The shape that engines and observers work with."""
        return Polygon(regular_polygon(self.sides, self.radius, self.rotation))


def _with_shape(value: Any) -> Any:
    """A container that does not say its shape is a rectangle."""
    return {"shape": "rectangle", **value} if isinstance(value, dict) else value


SHAPES: Final[
    dict[
        str,
        type[RectangleContainer]
        | type[CircleContainer]
        | type[PolygonContainer]
        | type[RegularPolygonContainer],
    ]
] = {
    "rectangle": RectangleContainer,
    "circle": CircleContainer,
    "polygon": PolygonContainer,
    "regular-polygon": RegularPolygonContainer,
}

Container = Annotated[
    RectangleContainer | CircleContainer | PolygonContainer | RegularPolygonContainer,
    Field(discriminator="shape"),
    BeforeValidator(_with_shape),
]
