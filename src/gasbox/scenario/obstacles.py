"""What stands in the container: segments, blocks and posts. Each is one wall."""

from __future__ import annotations

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
    """A fixed disc."""

    shape: Literal["disc"] = "disc"
    """Shape of the obstacle."""
    center: Vector
    """[length]."""
    radius: Positive
    """[length]."""

    def geometry(self) -> Post:
        """As engines take it."""
        return Post(self.center, self.radius)


STANDING: Final[dict[str, type[SegmentObstacle] | type[BlockObstacle] | type[PostObstacle]]] = {
    "segment": SegmentObstacle,
    "polygon": BlockObstacle,
    "disc": PostObstacle,
}

Obstacle = Annotated[SegmentObstacle | BlockObstacle | PostObstacle, Field(discriminator="shape")]
