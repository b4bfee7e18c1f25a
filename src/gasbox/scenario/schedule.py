"""What changes at a given time: gravity, or a wall."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from gasbox.scenario.values import Finite, NotNegative, Positive, Section, Vector
from gasbox.state import Change, MoveWall, SetGravity, SetWall

__all__ = ["ScheduledChange"]


class ScheduledChange(Section):
    """One change. It names either `gravity`, or a `wall` and what becomes of it."""

    at: NotNegative
    """When [time]."""
    gravity: Vector | None = None
    """New acceleration of all discs [length/time²]."""
    wall: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """Name of a wall."""
    present: bool | None = None
    """Take the wall (an obstacle) away, or put it back."""
    temperature: NotNegative | None = None
    """New temperature of the wall [energy]."""
    displacement: Finite | None = None
    """Move the wall there, along its normal from its place at the start [length]."""
    speed: Positive | None = None
    """Speed of that motion; without it, 1 [length/time]."""
    origin: Finite | None = None
    """Where the wall was when it set out [length]: stands in snapshots and recordings."""
    free: bool | None = None
    """Let a piston that was moved go free again."""

    def change(self) -> Change:
        """The value that the simulation applies."""
        if self.gravity is not None:
            return SetGravity(self.gravity)
        wall = self.wall or ""
        if self.displacement is not None:
            return MoveWall(wall, self.displacement, self.speed or 1.0, self.origin)
        return SetWall(wall, self.present, self.temperature, self.free)

    @classmethod
    def of(cls, time: float, change: Change) -> ScheduledChange:
        """The entry that makes this change at this time."""
        match change:
            case SetGravity(gravity=gravity):
                return cls(at=time, gravity=gravity)
            case MoveWall(wall=wall, displacement=displacement, speed=speed, origin=origin):
                return cls(at=time, wall=wall, displacement=displacement, speed=speed, origin=origin)
            case SetWall(wall=wall, present=present, temperature=temperature, free=free):
                return cls(at=time, wall=wall, present=present, temperature=temperature, free=free)
