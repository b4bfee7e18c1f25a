"""The computer: it sees where the ball is, works out where it will come, and errs like anybody else."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gasbox.rng import Stream, generator
from gasbox.worlds.pong.table import Side, Table

__all__ = ["SKILLS", "Skill", "arrival", "choice"]

_MOST_BOUNCES = 64


@dataclass(frozen=True)
class Skill:
    """How well the computer plays.

    Attributes
    ----------
    pause : from one look at the ball to the next, in flights from one end of the table to the other
    error : standard deviation of where it expects a ball that is near, in half heights of the bat; it errs
        twice as much about one at the other end
    pace : of the greatest speed of a bat
    aim : how far from its middle it likes to hit the ball, in half heights, so that the ball flies off at an angle
    returns : whether it goes to the middle while the ball flies away
    """

    pause: float
    error: float
    pace: float
    aim: float
    returns: bool


SKILLS = {
    "easy": Skill(0.3, 0.9, 0.3, 0.0, False),
    "medium": Skill(0.15, 0.75, 0.42, 0.4, True),
    "hard": Skill(0.03, 0.1, 1.0, 0.35, True),
}


def arrival(
    place: tuple[float, float],
    velocity: tuple[float, float],
    x: float,
    room: tuple[float, float],
    gravity: float = 0.0,
) -> tuple[float, float] | None:
    """When and at what height the ball comes to `x`, if nothing but bottom and top turns it round; None if it does not.

    Parameters
    ----------
    place, velocity : of the ball [length], [length/time]
    room : where its middle can be, upwards [length]
    gravity : upwards [length/time²]
    """
    if velocity[0] == 0.0 or (x - place[0]) / velocity[0] < 0.0:
        return None
    time = (x - place[0]) / velocity[0]
    low, high = room
    if gravity == 0.0:
        height = high - low
        way = (place[1] + velocity[1] * time - low) % (2.0 * height)
        return time, low + (way if way <= height else 2.0 * height - way)
    return time, _tossed(place[1], velocity[1], gravity, low, high, time)


def _tossed(y: float, v: float, g: float, low: float, high: float, time: float) -> float:
    """Height after `time` of what falls, and bounces off bottom and top."""
    for _ in range(_MOST_BOUNCES):
        hit, left = math.inf, time
        for end, sign in ((low, -1.0), (high, 1.0)):
            t = _first(sign * (end - y), sign * v, sign * g)
            if t < hit:
                hit = t
        if hit >= left:
            break
        y, v, time = y + v * hit + 0.5 * g * hit * hit, -(v + g * hit), left - hit
        y = min(max(y, low), high)
    return min(max(y + v * time + 0.5 * g * time * time, low), high)


def _first(away: float, v: float, g: float) -> float:
    """When v t + g t²/2 first reaches `away` >= 0, going that way."""
    square = v * v + 2.0 * g * away
    if square < 0.0:
        return math.inf
    root = math.sqrt(square)
    if v > 0.0:
        return 2.0 * away / (v + root)
    return (root - v) / g if g > 0.0 else math.inf


def choice(
    table: Table,
    side: Side,
    skill: Skill,
    place: tuple[float, float],
    velocity: tuple[float, float],
    gravity: float,
    draw: tuple[int, int],
) -> float | None:
    """Where the bat is to go [length]; None to stay.

    Parameters
    ----------
    draw : seed, and number of the approach: the computer errs once in each, and the less the nearer the ball is
    """
    inwards = 1.0 if side.x < table.center[0] else -1.0
    found = None
    if inwards * velocity[0] < 0.0:
        found = arrival(place, velocity, side.front, (table.bottom, table.top), gravity)
    if found is None:
        return 0.5 * (side.low + side.high) if skill.returns else None
    normal, uniform = _draws(*draw)
    far = min(abs(place[0] - side.front) / table.width, 1.0)
    error = skill.error * normal * (1.0 + far)
    return found[1] + side.half * (error + skill.aim * uniform)


def _draws(seed: int, number: int) -> tuple[float, float]:
    """A Gaussian, and an even number between -1 and 1."""
    source = generator(seed, Stream.PONG, number)
    return float(source.normal()), float(source.uniform(-1.0, 1.0))
