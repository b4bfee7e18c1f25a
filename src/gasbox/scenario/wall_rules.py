"""Rules on walls: their names, who passes them, and what cannot go together."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.geometry import Rectangle, side_names
from gasbox.scenario.motions import ConstantMotion, Motion, PathMotion, PistonMotion
from gasbox.scenario.obstacles import PostObstacle, SegmentObstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.walls import Passes, Surface, Way

__all__ = ["named_walls", "wall_problems"]


def wall_problems(parts: Parts) -> list[Problem]:
    """Everything that can be said of walls without knowing where they stand."""
    problems = [*_sides(parts), *_names(parts)]
    for path, surface in _surfaces(parts):
        problems += [*_together(path, surface), *_passes(path, surface.passes, parts.names)]
        problems += _motion(path, surface.motion)
    for side, settings in parts.walls.items():
        if settings is not None and settings.passes is not None:
            allowed = "nobody can pass a side of the container; with open, discs that reach it leave"
            yield_path = f"walls.{short(side, bare=True)}.passes"
            problems.append(Problem(yield_path, "a side of the container", allowed))
    return [*problems, *_movable(parts)]


def named_walls(parts: Parts) -> list[tuple[str, str]]:
    """Path and name of every wall, in their order; walls that are invalid by themselves are left out."""
    if parts.container is None:
        return []
    found = []
    for side in side_names(parts.container.geometry()):
        settings = parts.walls.get(side)
        found.append((f"walls.{side}", settings.name if settings and settings.name else side))
    for number, obstacle in enumerate(parts.obstacles):
        if obstacle is not None:
            found.append((f"obstacles[{number}]", obstacle.name or f"obstacle-{number + 1}"))
    return found


def _surfaces(parts: Parts) -> Iterator[tuple[str, Surface]]:
    for side, settings in parts.walls.items():
        if settings is not None:
            yield f"walls.{short(side, bare=True)}", settings
    for number, obstacle in enumerate(parts.obstacles):
        if obstacle is not None:
            yield f"obstacles[{number}]", obstacle


def _sides(parts: Parts) -> Iterator[Problem]:
    """Keys of `walls` that are no sides."""
    if parts.container is None:
        return
    shape = parts.container.geometry()
    known = side_names(shape)
    for side in parts.walls:
        path = f"walls.{short(side, bare=True)}"
        if side not in known:
            shown = ", ".join(known[:6]) + (f", ..., {known[-1]}" if len(known) > 6 else "")
            yield Problem(path, "an unknown side", f"known: {shown}{near(side, known)}")
        elif isinstance(shape, Rectangle):
            across = known.index(side) < 2
            if shape.periodic_x if across else shape.periodic_y:
                axis = "x" if across else "y"
                yield Problem(path, f"a container that is periodic in {axis}", f"it has no {side} wall")


def _names(parts: Parts) -> Iterator[Problem]:
    first: dict[str, str] = {}
    for path, name in named_walls(parts):
        if name in first:
            allowed = f"each wall needs its own name; {first[name]} has it already"
            yield Problem(f"{path}.name", short(name), allowed)
        first.setdefault(name, path)


def _together(path: str, surface: Surface) -> Iterator[Problem]:
    others = [key for key in ("temperature", "passes", "motion") if getattr(surface, key) is not None]
    if surface.open and others:
        allowed = "discs that reach an open wall leave for good: it can have nothing else"
        yield Problem(path, f"open and {' and '.join(others)}", allowed)


def _passes(path: str, passes: Passes | None, names: tuple[str, ...] | None) -> Iterator[Problem]:
    if passes is None:
        return
    path = f"{path}.passes"
    if passes.each_way:
        plain = type(passes)()
        keys = ("species", "direction", "least_speed", "greatest_speed")
        others = [key for key in keys if getattr(passes, key) != getattr(plain, key)]
        if others:
            allowed = "a rule for each direction stands alone: say it in forward and backward"
            yield Problem(path, f"{' and '.join(others)} beside them", allowed)
        for key, way in (("forward", passes.forward), ("backward", passes.backward)):
            if way is not None:
                yield from _way(f"{path}.{key}", way, names)
        return
    if passes.model_fields_set & {"forward", "backward"}:
        yield Problem(path, "nobody either way", 'a wall that nobody passes has no "passes"')
    yield from _way(path, passes, names)


def _way(path: str, way: Way, names: tuple[str, ...] | None) -> Iterator[Problem]:
    if way.greatest_speed is not None and way.least_speed >= way.greatest_speed:
        allowed = f"must be less than greatest_speed, {way.greatest_speed:g}"
        yield Problem(f"{path}.least_speed", f"{way.least_speed:g}", allowed)
    for name in dict.fromkeys(way.species or ()):
        if names is not None and name not in names:
            allowed = f"must be one of {', '.join(map(short, dict.fromkeys(names)))}{near(name, names)}"
            yield Problem(f"{path}.species", short(name), allowed)


def _motion(path: str, motion: Motion | None) -> Iterator[Problem]:
    """What is wrong with a motion by itself."""
    match motion:
        case ConstantMotion(start=start, stop=stop) if stop is not None and stop <= start:
            yield Problem(f"{path}.motion.stop", f"{stop:g}", f"must be later than start, {start:g}")
        case PathMotion(points=points):
            if points[0][1] != 0.0:
                allowed = "the displacement at its beginning must be 0: the wall starts where it stands"
                yield Problem(f"{path}.motion.points[0]", short(list(points[0])), allowed)
            if points[0][0] < 0.0:
                yield Problem(f"{path}.motion.points[0]", short(list(points[0])), "times start at 0")
            for number, (before, after) in enumerate(itertools.pairwise(points), 1):
                if after[0] <= before[0]:
                    allowed = f"must be later than the point before it, at {before[0]:g}"
                    yield Problem(f"{path}.motion.points[{number}]", short(list(after)), allowed)
                    return
        case PistonMotion(stops=(lower, upper)) if not lower <= 0.0 <= upper or lower == upper:
            allowed = "must be [least, greatest displacement], with the start, 0, between them"
            yield Problem(f"{path}.motion.stops", f"[{lower:g}, {upper:g}]", allowed)


def _movable(parts: Parts) -> Iterator[Problem]:
    """Motions of walls that cannot move."""
    allowed = "only sides of a rectangle, segments, and discs with a direction can move"
    if parts.container is not None and not isinstance(parts.container.geometry(), Rectangle):
        for side, settings in parts.walls.items():
            if settings is not None and settings.motion is not None:
                shape = f"a side of a {parts.container.shape}"
                yield Problem(f"walls.{short(side, bare=True)}.motion", shape, allowed)
    for number, obstacle in enumerate(parts.obstacles):
        path = f"obstacles[{number}]"
        if isinstance(obstacle, PostObstacle) and obstacle.direction is not None:
            yield from _post(path, obstacle, parts)
        elif (
            obstacle is not None and obstacle.motion is not None and not isinstance(obstacle, SegmentObstacle)
        ):
            yield Problem(f"{path}.motion", f"an obstacle of shape {obstacle.shape}", allowed)


def _post(path: str, post: PostObstacle, parts: Parts) -> Iterator[Problem]:
    """What is wrong with a disc that can move."""
    if post.direction == (0.0, 0.0):
        yield Problem(f"{path}.direction", "[0, 0]", "must point somewhere, as [0, 1]")
    if isinstance(post.motion, PistonMotion):
        yield Problem(
            f"{path}.motion", "a disc as a piston", "only sides of a rectangle and segments are free"
        )
    shape = parts.container.geometry() if parts.container is not None else None
    if isinstance(shape, Rectangle) and (shape.periodic_x or shape.periodic_y):
        allowed = "only in a container without periodic directions: a wall that moves has no images"
        yield Problem(f"{path}.direction", "a periodic container", allowed)
