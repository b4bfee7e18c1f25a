"""What stands in the container: segments, blocks and posts. Each is one wall."""

from __future__ import annotations

import math
from typing import Annotated, Final, Literal

from pydantic import ConfigDict, Field
from pydantic.config import JsonDict

from gasbox.geometry import Block, Post, Segment, signed_area
from gasbox.scenario.container import Vertices
from gasbox.scenario.values import Positive, Vector
from gasbox.scenario.walls import Surface

__all__ = ["STANDING", "BlockObstacle", "Obstacle", "PostObstacle", "SegmentObstacle"]

_SHAPE_REQUIRED: Final[JsonDict] = {"required": ["shape"]}


class _Named(Surface):
    model_config = ConfigDict(json_schema_extra=_SHAPE_REQUIRED)

    name: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """Name, as in charts and tables; without it, obstacle-1, obstacle-2, ..."""
    present: bool = True
    """Whether it is there at the start; a schedule or the page can take it away and put it back."""


class SegmentObstacle(_Named):
    """A thin wall with two sides: a divider, with gaps where it ends."""

    shape: Literal["segment"] = "segment"
    """Shape of the obstacle."""
    start: Vector
    """One end [length]."""
    end: Vector
    """The other end [length]."""

    def geometry(self) -> Segment:
        """As engines take it."""
        return Segment(self.start, self.end)


class BlockObstacle(_Named):
    """A filled polygon."""

    shape: Literal["polygon"] = "polygon"
    """Shape of the obstacle."""
    vertices: Vertices
    """Corners in order, either way round [length]."""

    def geometry(self) -> Block:
        """As engines take it."""
        turned = signed_area(self.vertices) < 0
        return Block(self.vertices[::-1] if turned else self.vertices)


class PostObstacle(_Named):
    """A disc that stands, or moves along one direction."""

    shape: Literal["disc"] = "disc"
    """Shape of the obstacle."""
    center: Vector
    """[length]."""
    radius: Positive
    """[length]."""
    direction: Vector | None = None
    """Along which it can move, by its motion, a schedule or a world: displacements count this way. Such a disc may
    reach beyond a rectangle: then it is a cap on its side. Without it, it stands for good."""

    def geometry(self) -> Post:
        """As engines take it."""
        length = math.hypot(*self.direction) if self.direction else 0.0
        if self.direction is None or length == 0.0:
            return Post(self.center, self.radius)
        return Post(self.center, self.radius, (self.direction[0] / length, self.direction[1] / length))


STANDING: Final[dict[str, type[SegmentObstacle] | type[BlockObstacle] | type[PostObstacle]]] = {
    "segment": SegmentObstacle,
    "polygon": BlockObstacle,
    "disc": PostObstacle,
}

Obstacle = Annotated[SegmentObstacle | BlockObstacle | PostObstacle, Field(discriminator="shape")]
