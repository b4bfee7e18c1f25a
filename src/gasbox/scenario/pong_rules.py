"""Rules on a game of pong: what it names is there, and is what it must be."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.obstacles import Obstacle, PostObstacle, SegmentObstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.pong import Pong
from gasbox.scenario.problems import near, short

__all__ = ["pong_problems"]


def pong_problems(parts: Parts) -> Iterator[Problem]:
    """All that is wrong with a game; silent about what is not valid by itself."""
    game = parts.world
    if not isinstance(game, Pong):
        return
    if parts.container is not None:
        shape = parts.container.geometry()
        if not isinstance(shape, Rectangle) or shape.periodic_x or shape.periodic_y:
            yield Problem("container", parts.container.shape, "pong needs a rectangle that is not periodic")
    if parts.frame_interval is None:
        yield Problem("frame_interval", "none", "pong needs one: bats are told what to do once in a frame")
    yield from _species(parts, game)
    if None in parts.obstacles:
        return
    for key, name in (("left", game.left), ("right", game.right)):
        if name is not None:
            yield from _bat(f"world.{key}", name, parts)
    bats = 1 if game.right is None else 2
    if len(game.goals) != bats:
        yield Problem("world.goals", f"{len(game.goals)} lines", f"one behind each bat: {bats}")
    for number, name in enumerate(game.goals):
        yield from _goal(f"world.goals[{number}]", name, game.ball, parts)


def _species(parts: Parts, game: Pong) -> Iterator[Problem]:
    names = [entry.name for entry in parts.species if entry is not None]
    if None in parts.species:
        return
    for key, name in (("ball", game.ball), ("bricks", game.bricks)):
        if name is not None and name not in names:
            allowed = f"must be one of {', '.join(map(short, names))}{near(name, names)}"
            yield Problem(f"world.{key}", short(name), allowed)
    if game.ball == game.bricks:
        yield Problem("world.bricks", short(game.ball), "must be another species than the ball")
    if game.ball in names:
        count = _count(parts, game.ball)
        if count != 1:
            yield Problem("world.ball", f"{count} discs of {game.ball}", "there must be exactly one")


def _count(parts: Parts, name: str) -> int:
    """How many discs of a species there are; in a snapshot the particles are all."""
    listed, placed = 0, 0
    if parts.particles is not None and name in parts.particles.names:
        listed = int((parts.particles.index == parts.particles.names.index(name)).sum())
    if parts.snapshot is None:
        placed = sum(entry.count for entry in parts.species if entry is not None and entry.name == name)
    return listed + placed


def _obstacles(parts: Parts) -> dict[str, Obstacle]:
    found = enumerate(parts.obstacles, 1)
    return {one.name or f"obstacle-{number}": one for number, one in found if one is not None}


def _unknown(path: str, name: str, known: dict[str, Obstacle]) -> Problem:
    shown = ", ".join(map(short, known)) or "an obstacle, and there is none"
    return Problem(path, short(name), f"must be one of {shown}{near(name, list(known))}")


def _bat(path: str, name: str, parts: Parts) -> Iterator[Problem]:
    known = _obstacles(parts)
    if name not in known:
        yield _unknown(path, name, known)
        return
    bat = known[name]
    upright = isinstance(bat, PostObstacle) and bat.direction is not None
    if not (upright and isinstance(bat, PostObstacle) and bat.direction and _points_up(bat.direction)):
        yield Problem(path, f"{name}, of shape {bat.shape}", "must be a disc with the direction [0, 1]")
    elif bat.motion is not None or bat.open or bat.passes is not None or bat.temperature is not None:
        allowed = "a bat is a plain wall that only the game moves"
        yield Problem(path, f"{name} with motion, open, passes or temperature", allowed)


def _points_up(direction: tuple[float, float]) -> bool:
    return direction[0] == 0.0 and direction[1] > 0.0


def _goal(path: str, name: str, ball: str, parts: Parts) -> Iterator[Problem]:
    known = _obstacles(parts)
    if name not in known:
        yield _unknown(path, name, known)
        return
    goal = known[name]
    if not isinstance(goal, SegmentObstacle) or goal.start[0] != goal.end[0]:
        yield Problem(path, f"{name}, of shape {goal.shape}", "must be an upright segment")
    elif goal.passes is None or (goal.passes.species is not None and ball not in goal.passes.species):
        yield Problem(path, f"{name}, which {ball} does not pass", f'needs "passes": "all", or ["{ball}"]')
