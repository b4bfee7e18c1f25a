"""Rules between fields. Each tries what is valid by itself and is silent about the rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from gasbox.errors import Problem
from gasbox.scenario.container import Container, RectangleContainer
from gasbox.scenario.density import density_problems
from gasbox.scenario.dynamics import EventDriven, Stepped
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.particles import Particles
from gasbox.scenario.problems import near, short
from gasbox.scenario.remembered import snapshot_problems
from gasbox.scenario.sizes import region_problems, size_problems
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Species
from gasbox.scenario.values import LARGEST_COUNT

__all__ = ["Parts", "broken_rules"]

_SHOWN: Final = 10
"""Of each kind of wrong row, so many are named."""
_SOURCES: Final = ("temperature", "speed", "velocities")


@dataclass(frozen=True)
class Parts:
    """The parts of a scenario, None where a part is invalid by itself."""

    container: Container | None
    species: tuple[Species | None, ...]
    particles: Particles | None
    dynamics: Stepped | EventDriven | None
    frame_interval: float | None
    histograms: Histograms | None
    snapshot: Snapshot | None


def broken_rules(parts: Parts) -> list[Problem]:
    """All problems between fields."""
    rules = (_names, _velocities, _total, _listed_names, _frames, _axis, _snapshot)
    problems = [problem for rule in rules for problem in rule(parts)]
    if not isinstance(parts.container, RectangleContainer):
        return problems
    geometry = parts.container.geometry()
    room = [*size_problems(geometry, parts.species), *region_problems(geometry, parts.species)]
    problems += [*room, *_listed_positions(parts)]
    if not room and parts.snapshot is None and all(parts.species):
        valid = tuple(entry for entry in parts.species if entry is not None)
        problems += density_problems(geometry, valid, parts.particles)
    return problems


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
        elif not given and species.count > 0:
            allowed = f"{species.count} discs need velocities: give one of {', '.join(_SOURCES)}"
            yield Problem(f"species[{number}]", "none of them", allowed)
        if species.velocities is not None and len(species.velocities) != species.count:
            allowed = f"must be as many as count, {species.count}"
            yield Problem(f"species[{number}].velocities", f"{len(species.velocities)} velocities", allowed)


def _total(parts: Parts) -> Iterator[Problem]:
    total = sum(species.count for species in parts.species if species is not None)
    total += parts.particles.count if parts.particles else 0
    if total > LARGEST_COUNT:
        yield Problem("species", f"{total} particles in all", f"at most {LARGEST_COUNT} particles")


def _listed_names(parts: Parts) -> Iterator[Problem]:
    if parts.particles is None or not all(parts.species):
        return
    known = [species.name for species in parts.species if species is not None]
    uses = Counter(parts.particles.index.tolist())
    for number, name in enumerate(parts.particles.names):
        if name not in known:
            row = int((parts.particles.index == number).argmax())
            times = f" ({uses[number]} times)" if uses[number] > 1 else ""
            allowed = f"must be one of {', '.join(map(short, dict.fromkeys(known)))}{near(name, known)}"
            yield Problem(parts.particles.path(row, "species"), short(name) + times, allowed)


def _listed_positions(parts: Parts) -> Iterator[Problem]:
    # What the stepped rule has moved beyond a wall may stand in a snapshot.
    if parts.particles is None or parts.snapshot is not None:
        return
    if not isinstance(parts.container, RectangleContainer):
        return
    width, height = parts.container.width, parts.container.height
    x, y = parts.particles.position.T
    outside = ((x < 0) | (x > width) | (y < 0) | (y > height)).nonzero()[0]
    for row in outside[:_SHOWN]:
        allowed = f"the centre must lie inside the container [0, {width:g}] x [0, {height:g}]"
        found = short(parts.particles.position[row].tolist())
        yield Problem(parts.particles.path(int(row), "position"), found, allowed)
    if len(outside) > _SHOWN:
        yield Problem("particles", f"{len(outside)} centres outside the container", "none may lie outside")


def _frames(parts: Parts) -> Iterator[Problem]:
    if not isinstance(parts.dynamics, Stepped) or parts.frame_interval is None:
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
    if parts.snapshot is not None:
        walls = _wall_count(parts)
        if walls is not None:
            yield from snapshot_problems(parts.snapshot, parts.particles, len(parts.species), walls)
