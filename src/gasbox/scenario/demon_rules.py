"""Rules on a demon: its gate, the gas that it sorts, and what its settings may be."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.scenario.demon import Demon
from gasbox.scenario.dynamics import Forced, Stepped, Walk
from gasbox.scenario.obstacles import SegmentObstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.wall_rules import named_walls

__all__ = ["demon_problems"]


def demon_problems(parts: Parts) -> Iterator[Problem]:
    """A gate that is none, a gas that a demon cannot sort, and species that do not exist."""
    demon = parts.world
    if not isinstance(demon, Demon):
        return
    if parts.container is not None and None not in parts.obstacles and None not in parts.walls.values():
        yield from _gate(demon, parts)
    if any(parts.molecules):
        yield Problem("molecules", "molecules", "a demon sorts discs: its books are those of a gas of discs")
    if isinstance(parts.dynamics, Forced | Walk):
        allowed = 'a demon needs dynamics kind "event-driven" or "stepped": its books are those of hard discs'
        yield Problem("dynamics.kind", short(parts.dynamics.kind), allowed)
    if isinstance(parts.dynamics, Stepped):
        step = parts.dynamics.time_step
        steps = round(demon.interval / step)
        if steps < 1 or abs(demon.interval - steps * step) > 1e-9 * demon.interval:
            allowed = f"must be a whole multiple of dynamics.time_step, {step:g}"
            yield Problem("world.interval", f"{demon.interval:g}", allowed)
    yield from _species(demon, parts)


def _gate(demon: Demon, parts: Parts) -> Iterator[Problem]:
    segments = {
        name: obstacle
        for path, name in named_walls(parts)
        if path.startswith("obstacles")
        and isinstance(
            obstacle := parts.obstacles[int(path.removeprefix("obstacles[").removesuffix("]"))],
            SegmentObstacle,
        )
    }
    if demon.gate not in segments:
        known = ", ".join(map(short, list(segments)[:10])) or "there is none yet"
        allowed = f"must be the name of a segment: {known}{near(demon.gate, segments)}"
        yield Problem("world.gate", short(demon.gate), allowed)
        return
    gate = segments[demon.gate]
    for key, has in (("open", gate.open), ("motion", gate.motion is not None), ("present", not gate.present)):
        if has:
            found = (
                f"a gate with {key} {str(getattr(gate, key)).lower()}"
                if key != "motion"
                else "a gate that moves"
            )
            yield Problem("world.gate", found, "a demon needs a gate that is there, and does nothing else")


def _species(demon: Demon, parts: Parts) -> Iterator[Problem]:
    if parts.names is None:
        return
    said = [("world.species", demon.species)]
    said += [
        (f"schedule[{number}].value", str(entry.value))
        for number, entry in enumerate(parts.schedule)
        if entry is not None and entry.setting == "species" and isinstance(entry.value, str)
    ]
    for path, name in said:
        if name is not None and name not in parts.names:
            known = ", ".join(map(short, dict.fromkeys(parts.names)))
            yield Problem(path, short(name), f"must be one of {known}{near(name, parts.names)}")
