"""What can be said of a wall, whatever its shape."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from gasbox.geometry import Gate, Passage, Wall
from gasbox.scenario.motions import Motion
from gasbox.scenario.values import NotNegative, Positive, Section

__all__ = ["Passes", "Surface", "WallSettings", "Way"]


class Way(Section):
    """Who passes a wall in one direction."""

    species: tuple[str, ...] | None = None
    """Names of the species that pass; without it, all."""
    least_speed: NotNegative = 0.0
    """Slower discs bounce [length/time]."""
    greatest_speed: Positive | None = None
    """Faster discs bounce [length/time]."""

    def one_way(self, names: Sequence[str]) -> Passage:
        """As engines take it; `names` of all species."""
        members = None if self.species is None else tuple(names.index(name) for name in self.species)
        fastest = math.inf if self.greatest_speed is None else self.greatest_speed
        return Passage(members, "both", self.least_speed, fastest)


class Passes(Way):
    """Who passes a wall: a membrane by species, a gate also by speed and direction, or a rule for each direction."""

    direction: Literal["both", "forward", "backward"] = "both"
    """Along the normal of the wall, against it, or both. That of a segment points to the right of the way from its
    first end to its second."""
    forward: Way | None = None
    """Who passes along the normal, in place of all that stands above; nobody if only `backward` is given."""
    backward: Way | None = None
    """Who passes against the normal; nobody if only `forward` is given."""

    @property
    def each_way(self) -> bool:
        """Whether there is a rule for each direction."""
        return self.forward is not None or self.backward is not None

    def passage(self, names: Sequence[str]) -> Passage | Gate:
        """As engines take it; `names` of all species."""
        if self.each_way:
            ways = (None if way is None else way.one_way(names) for way in (self.forward, self.backward))
            return Gate(*ways)
        return replace(self.one_way(names), direction=self.direction)


def _written_out(value: Any) -> Any:
    """`"all"`, or a list of species, in full."""
    if value == "all":
        return {}
    return {"species": value} if isinstance(value, list | tuple) else value


class Surface(Section):
    """Properties of a wall. Without any it is slippery: a disc that hits it bounces elastically."""

    temperature: NotNegative | None = None
    """Temperature of a thermal wall: discs leave it with the flux distribution of a gas so warm [energy]."""
    open: bool = False
    """Whether discs that reach it leave the gas for good."""
    passes: Annotated[Passes | None, BeforeValidator(_written_out)] = None
    """Who passes: "all" (a line that only counts), a list of names of species (a membrane), or an object (a gate)."""
    motion: Annotated[Motion | None, Field()] = None
    """How it moves; only sides of a rectangle, segments, and discs with a direction can."""

    def wall(self, name: str, names: Sequence[str], present: bool = True) -> Wall:
        """As engines take it; `names` of all species."""
        return Wall(
            name,
            self.temperature,
            self.open,
            None if self.passes is None else self.passes.passage(names),
            None if self.motion is None else self.motion.motion(),
            present,
        )


class WallSettings(Surface):
    """A side of the container."""

    name: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """Another name for it, as in charts and tables."""
