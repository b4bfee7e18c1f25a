"""What a game is played on: bats, goal lines, and the room of the ball."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gasbox.geometry import Enclosure, Post, Segment, side_count
from gasbox.scenario import Pong, Scenario

__all__ = ["LEFT", "RIGHT", "SIDES", "Side", "Table", "table_of"]

LEFT, RIGHT = 0, 1
SIDES = ("left", "right")


@dataclass(frozen=True)
class Side:
    """One end of the table.

    Attributes
    ----------
    name : left or right
    bat, wall : name and index of the wall that is the bat
    x, start : middle of the bat, before it was moved [length]
    radius : of the bat [length]
    half : half the height of what is seen of it [length]
    low, high : where its middle can be, upwards [length]
    goal : index of the wall that is the goal line
    line : where that is, across [length]
    front : where the middle of the ball is, across, when it meets the bat in full [length]
    """

    name: str
    bat: str
    wall: int
    x: float
    start: float
    radius: float
    half: float
    low: float
    high: float
    goal: int
    line: float
    front: float


@dataclass(frozen=True)
class Table:
    """All of it.

    Attributes
    ----------
    sides : one or two
    center : where the ball is served [length]
    bottom, top : where the middle of the ball can be, upwards [length]
    width : of the container [length]
    species : of the ball; bricks : of bricks, -1 if there are none
    radius : of the ball [length]
    """

    sides: tuple[Side, ...]
    center: tuple[float, float]
    bottom: float
    top: float
    width: float
    species: int
    bricks: int
    radius: float


def table_of(scenario: Scenario, game: Pong) -> Table:
    """The table of a scenario whose rules are fulfilled."""
    geometry = scenario.geometry()
    assert isinstance(geometry, Enclosure)
    names = [kind.name for kind in scenario.kinds]
    ball = scenario.kinds[names.index(game.ball)]
    bats = [name for name in (game.left, game.right) if name is not None]
    return Table(
        tuple(
            _side(geometry, side, bat, goal, ball.radius)
            for side, (bat, goal) in enumerate(zip(bats, game.goals, strict=True))
        ),
        (0.5 * geometry.width, 0.5 * geometry.height),
        ball.radius,
        geometry.height - ball.radius,
        geometry.width,
        names.index(game.ball),
        -1 if game.bricks is None else names.index(game.bricks),
        ball.radius,
    )


def _side(geometry: Enclosure, side: int, bat: str, goal: str, ball: float) -> Side:
    first, inwards = side_count(geometry.container), 1.0 if side == LEFT else -1.0
    wall, line = geometry.wall_names.index(bat), geometry.wall_names.index(goal)
    post, segment = geometry.obstacles[wall - first], geometry.obstacles[line - first]
    assert isinstance(post, Post)
    assert isinstance(segment, Segment)
    at = segment.start[0]
    behind = inwards * (at - post.center[0])
    # What is seen of a bat whose middle lies behind the line is a cap.
    half = math.sqrt(max(post.radius**2 - behind**2, 0.0)) if behind > 0.0 else post.radius
    low, high = half, geometry.height - half
    if low > high:
        low = high = 0.5 * geometry.height
    front = post.center[0] + inwards * (post.radius + ball)
    return Side(SIDES[side], bat, wall, *post.center, post.radius, half, low, high, line, at, front)
