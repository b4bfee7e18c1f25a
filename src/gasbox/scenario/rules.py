"""Rules between fields. Each tries what is valid by itself and is silent about the rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Final

import numpy as np

from gasbox.errors import Problem
from gasbox.geometry import Enclosure, Geometry, Rectangle, side_count
from gasbox.scenario.crowding import crowding_problems, glide_problems
from gasbox.scenario.demon_rules import demon_problems
from gasbox.scenario.dynamics import Forced, Stepped, Walk
from gasbox.scenario.epidemic_rules import epidemic_problems
from gasbox.scenario.falling import falling_problems
from gasbox.scenario.forced_rules import forced_problems
from gasbox.scenario.kinds import site_kinds_of
from gasbox.scenario.molecule_rules import molecule_problems
from gasbox.scenario.molecule_walls import molecule_wall_problems
from gasbox.scenario.parts import Parts
from gasbox.scenario.placement import Placement, placement_problems
from gasbox.scenario.pong_rules import pong_problems
from gasbox.scenario.problems import near, short
from gasbox.scenario.remembered import snapshot_problems
from gasbox.scenario.schedule_rules import schedule_problems
from gasbox.scenario.sizes import region_problems, size_problems
from gasbox.scenario.standing import container_problems, obstacle_problems
from gasbox.scenario.surroundings import geometry_of, surroundings
from gasbox.scenario.values import LARGEST_COUNT
from gasbox.scenario.walk_rules import walk_problems
from gasbox.scenario.wall_rules import wall_problems

__all__ = ["broken_rules"]

_SHOWN: Final = 10
"""Of each kind of wrong row, so many are named."""
_SOURCES: Final = ("temperature", "speed", "velocities")


def broken_rules(parts: Parts) -> list[Problem]:
    """All problems between fields."""
    rules = (
        _names,
        _velocities,
        _total,
        _listed_names,
        _frames,
        _axis,
        _snapshot,
        falling_problems,
        forced_problems,
        molecule_problems,
        molecule_wall_problems,
        walk_problems,
        epidemic_problems,
        pong_problems,
        demon_problems,
    )
    problems = [problem for rule in rules for problem in rule(parts)]
    shapes = [*container_problems(parts.container), *obstacle_problems(parts)]
    walls = [*wall_problems(parts), *schedule_problems(parts)]
    problems += [*shapes, *walls]
    if parts.container is None or container_problems(parts.container):
        return problems
    if parts.are_valid and not shapes and not walls:
        problems += glide_problems(parts)
    geometry = _surroundings(parts, with_all=not shapes and not walls)
    kinds = parts.kinds()
    room = [*size_problems(geometry, kinds, parts.species), *region_problems(geometry, kinds)]
    problems += [*room, *_listed_positions(parts, geometry)]
    if not room and parts.snapshot is None and len(kinds) == len(parts.species) + len(parts.molecules):
        discs = site_kinds_of(
            [entry for entry in parts.species if entry], [entry for entry in parts.molecules if entry]
        )
        soft = isinstance(parts.dynamics, Forced)
        problems += placement_problems(Placement(geometry, tuple(kinds), discs, parts.particles, soft))
        if parts.are_valid and not problems:
            problems += crowding_problems(parts)
    return problems


def _surroundings(parts: Parts, with_all: bool) -> Geometry:
    """The geometry as far as it is valid: what is not yet, takes no room."""
    assert parts.container is not None
    if with_all and parts.are_valid:
        return surroundings(parts)
    standing = [entry for entry in parts.obstacles if entry is not None] if with_all else []
    plain = [entry.model_copy(update={"passes": None, "motion": None}) for entry in standing]
    return geometry_of(parts.container, {}, plain, parts.gravity or (0.0, 0.0), ())


def _names(parts: Parts) -> Iterator[Problem]:
    first: dict[str, int] = {}
    for number, species in enumerate(parts.species):
        if species is None:
            continue
        if species.name in first:
            allowed = f"each species needs its own name; species[{first[species.name]}] has it already"
            yield Problem(f"species[{number}].name", short(species.name), allowed)
        first.setdefault(species.name, number)


def _velocities(parts: Parts) -> Iterator[Problem]:
    for number, species in enumerate(parts.species):
        if species is None:
            continue
        given = [source for source in _SOURCES if getattr(species, source) is not None]
        if len(given) > 1:
            yield Problem(f"species[{number}]", " and ".join(given), f"only one of {', '.join(_SOURCES)}")
        elif not given and species.count > 0 and not isinstance(parts.dynamics, Walk):
            allowed = f"{species.count} discs need velocities: give one of {', '.join(_SOURCES)}"
            yield Problem(f"species[{number}]", "none of them", allowed)
        if species.velocities is not None and len(species.velocities) != species.count:
            allowed = f"must be as many as count, {species.count}"
            yield Problem(f"species[{number}].velocities", f"{len(species.velocities)} velocities", allowed)


def _total(parts: Parts) -> Iterator[Problem]:
    total = sum(entry.count for entry in (*parts.species, *parts.molecules) if entry is not None)
    total += parts.particles.count if parts.particles else 0
    if total > LARGEST_COUNT:
        yield Problem("species", f"{total} particles in all", f"at most {LARGEST_COUNT} particles")


def _listed_names(parts: Parts) -> Iterator[Problem]:
    known = parts.names
    if parts.particles is None or known is None:
        return
    uses = Counter(parts.particles.index.tolist())
    for number, name in enumerate(parts.particles.names):
        if name not in known:
            row = int((parts.particles.index == number).argmax())
            times = f" ({uses[number]} times)" if uses[number] > 1 else ""
            allowed = f"must be one of {', '.join(map(short, dict.fromkeys(known)))}{near(name, known)}"
            yield Problem(parts.particles.path(row, "species"), short(name) + times, allowed)


def _listed_positions(parts: Parts, geometry: Geometry) -> Iterator[Problem]:
    # What the stepped rule has moved beyond a wall may stand in a snapshot.
    if parts.particles is None or parts.snapshot is not None:
        return
    shape = geometry.container if isinstance(geometry, Enclosure) else geometry
    where = "inside the container"
    if isinstance(shape, Rectangle):
        where += f" [0, {shape.width:g}] x [0, {shape.height:g}]"
        x, y = parts.particles.position.T
        outside = (x < 0) | (x > shape.width) | (y < 0) | (y > shape.height)
    else:
        outside = np.zeros(parts.particles.count, np.bool_)
    if isinstance(geometry, Enclosure):
        outside |= ~geometry.holds(parts.particles.position, 0.0)
        where += ", in no block or post" if geometry.obstacles else ""
    rows = outside.nonzero()[0]
    for row in rows[:_SHOWN]:
        found = short(parts.particles.position[row].tolist())
        yield Problem(parts.particles.path(int(row), "position"), found, f"the centre must lie {where}")
    if len(rows) > _SHOWN:
        yield Problem("particles", f"{len(rows)} centres outside the container", "none may lie outside")


def _frames(parts: Parts) -> Iterator[Problem]:
    if not isinstance(parts.dynamics, Stepped | Forced | Walk) or parts.frame_interval is None:
        return
    step, interval = parts.dynamics.time_step, parts.frame_interval
    steps = round(interval / step)
    if steps < 1 or abs(interval - steps * step) > 1e-9 * interval:
        allowed = f"must be a whole multiple of dynamics.time_step, {step:g}"
        yield Problem("frame_interval", f"{interval:g}", allowed)


def _axis(parts: Parts) -> Iterator[Problem]:
    axis = parts.histograms
    if axis is not None and axis.maximum is not None and axis.maximum <= axis.minimum:
        allowed = f"must be greater than histograms.minimum, {axis.minimum:g}"
        yield Problem("histograms.maximum", f"{axis.maximum:g}", allowed)


def _snapshot(parts: Parts) -> Iterator[Problem]:
    if parts.snapshot is not None and parts.container is not None:
        walls = side_count(parts.container.geometry()) + len(parts.obstacles)
        yield from snapshot_problems(parts.snapshot, parts.particles, parts.discs(), walls)
