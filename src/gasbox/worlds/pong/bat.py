"""Where a bat is to go, and the change that lets it go there: only one when it is to do something else."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gasbox.state import MoveWall
from gasbox.worlds.pong.table import Side

__all__ = ["Bat"]

_NEAR = 1e-9
"""Of the radius: so near, a bat is where it is to be."""


@dataclass
class Bat:
    """What a bat was told, and what it does.

    Attributes
    ----------
    side : where it is
    target : where its middle is to go, upwards [length]; not a number if nobody said so
    push : 1 up, -1 down, 0 neither; it goes before the target
    aim : where it is on its way to, or stands [length]
    pace : with which speed it set out [length/time]
    """

    side: Side
    target: float = math.nan
    push: int = 0
    aim: float = math.nan
    pace: float = 0.0

    def __post_init__(self) -> None:
        if math.isnan(self.aim):
            self.aim = self.side.start

    def rest(self) -> None:
        """Nobody says where it is to go."""
        self.target, self.push = math.nan, 0

    def order(self, now: float, within: float, fastest: float) -> MoveWall | None:
        """What it is to do from now on, if that is anything else than what it does.

        Parameters
        ----------
        now : where its middle is [length]
        within : time in which it gets to a target that is near, so that it follows a hand evenly [time]
        fastest : its greatest speed [length/time]
        """
        side = self.side
        if self.push:
            goal, speed = side.high if self.push > 0 else side.low, fastest
        elif math.isnan(self.target):
            goal, speed = now, fastest
            if abs(self.aim - now) <= _NEAR * side.radius:
                return None
        else:
            goal = min(max(self.target, side.low), side.high)
            speed = min(abs(goal - now) / within, fastest)
        if goal == self.aim and (self.pace <= fastest or not self.push):
            return None
        if abs(goal - now) <= _NEAR * side.radius and abs(self.aim - now) <= _NEAR * side.radius:
            return None
        self.aim, self.pace = goal, speed
        return MoveWall(side.bat, goal - side.start, max(speed, _NEAR * fastest))
