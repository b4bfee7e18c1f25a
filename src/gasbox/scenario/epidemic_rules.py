"""Rules on an epidemic: which species and which motion it needs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.dynamics import Forced, Walk
from gasbox.scenario.epidemic import ByContact, Duration, Epidemic
from gasbox.scenario.epidemic_settings import (
    OF_CLOSENESS,
    OF_CONTACT,
    OF_EXPOSED,
    OF_VACCINATION,
    OF_WALKERS,
)
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.rooms import ends_of, room_boxes

__all__ = ["STAGES", "epidemic_problems", "lacking", "reason_against"]

STAGES: Final = ("susceptible", "exposed", "infectious", "asymptomatic", "recovered", "dead", "vaccinated")
"""Names of the species that are stages of the disease; their numbers inside."""


def reason_against(name: str, by: str, walks: bool, species: frozenset[str]) -> str | None:
    """Why a setting means nothing in an epidemic that passes on `by` closeness or contact; None if it does."""
    if name in OF_CLOSENESS and by != "closeness":
        return 'needs transmission by "closeness"'
    if name in OF_CONTACT and by != "contact":
        return 'needs transmission by "contact"'
    if name in OF_WALKERS and not walks:
        return 'needs dynamics kind "walk"'
    if name in OF_EXPOSED and "exposed" not in species:
        return 'needs a species "exposed"'
    if name in OF_VACCINATION and "vaccinated" not in species:
        return 'needs a species "vaccinated"'
    return None


def epidemic_problems(parts: Parts) -> Iterator[Problem]:
    """All that is wrong with an epidemic among these people."""
    world = parts.world
    if not isinstance(world, Epidemic):
        return
    if parts.molecules:
        yield Problem("molecules", "molecules in an epidemic", "people are species of single discs")
    if parts.names is not None:
        yield from _species(parts, world)
    if parts.dynamics is None:
        return
    yield from _motion(parts, world)
    yield from _measures(parts, world)
    yield from _schedule(parts, world)
    yield from _boxes(parts, world)
    for name, wall in parts.walls.items():
        if wall is not None and wall.open:
            yield Problem(f"walls.{name}.open", "an open wall", "nobody may leave an epidemic")


def _species(parts: Parts, world: Epidemic) -> Iterator[Problem]:
    names = [entry.name for entry in parts.species if entry is not None]
    known = ", ".join(map(short, STAGES))
    for number, name in enumerate(names):
        if name not in STAGES:
            allowed = f"in an epidemic, must be one of {known}{near(name, STAGES)}"
            yield Problem(f"species[{number}].name", short(name), allowed)
    needed = {"susceptible": "", "infectious": "", "recovered": ""}
    if world.symptomatic < 1:
        needed["asymptomatic"] = f" (world.symptomatic is {world.symptomatic:g})"
    if world.fatality > 0:
        needed["dead"] = f" (world.fatality is {world.fatality:g})"
    if world.vaccination.before > 0 or world.vaccination.per_day > 0:
        needed["vaccinated"] = " (there is vaccination)"
    for name, reason in needed.items():
        if name not in names:
            yield Problem(
                "species", f"no {short(name)}", f"an epidemic needs a species {short(name)}{reason}"
            )
    if "exposed" not in names and world.exposed != Duration():
        yield Problem("world.exposed", "no such species", 'goes with a species "exposed"')


def _motion(parts: Parts, world: Epidemic) -> Iterator[Problem]:
    by_contact = isinstance(world.transmission, ByContact)
    path = "world.transmission.by"
    if by_contact and isinstance(parts.dynamics, Walk | Forced):
        allowed = 'collisions happen under dynamics kind "event-driven" or "stepped" only'
        yield Problem(path, '"contact"', allowed)
    shape = parts.container.geometry() if parts.container is not None else None
    if not by_contact and shape is not None and (not isinstance(shape, Rectangle) or parts.obstacles):
        yield Problem(path, '"closeness"', "needs a rectangle with nothing in it")
    step = getattr(parts.dynamics, "time_step", None)
    if world.interval is not None and step is not None:
        steps = round(world.interval / step)
        if steps < 1 or abs(world.interval - steps * step) > 1e-9 * world.interval:
            allowed = f"must be a whole multiple of dynamics.time_step, {step:g}"
            yield Problem("world.interval", f"{world.interval:g}", allowed)


def _measures(parts: Parts, world: Epidemic) -> Iterator[Problem]:
    if isinstance(parts.dynamics, Walk):
        return
    for key, used in (
        ("distancing", world.distancing.strength),
        ("quarantine", world.quarantine.probability),
        ("travel", world.travel.rate),
        ("central", world.central.visits),
    ):
        if used:
            yield Problem(f"world.{key}", f"{key} of people who fly about", 'needs dynamics kind "walk"')


def _schedule(parts: Parts, world: Epidemic) -> Iterator[Problem]:
    walks, species = isinstance(parts.dynamics, Walk), frozenset(parts.names or ())
    for number, entry in enumerate(parts.schedule):
        if entry is None or entry.setting is None:
            continue
        reason = reason_against(entry.setting, world.transmission.by, walks, species)
        if reason is None and parts.names is not None:
            reason = lacking(entry.setting, entry.value, species)
        if reason is not None:
            yield Problem(f"schedule[{number}].setting", short(entry.setting), reason)


def lacking(name: str, value: object, species: frozenset[str]) -> str | None:
    """What species a setting of this value needs that is not there; None if none."""
    if name == "symptomatic" and value != 1 and "asymptomatic" not in species:
        return 'below 1 it needs a species "asymptomatic"'
    if name == "fatality" and value != 0 and "dead" not in species:
        return 'above 0 it needs a species "dead"'
    return None


def _boxes(parts: Parts, world: Epidemic) -> Iterator[Problem]:
    """A box for quarantine that lies in a room, or outside the container."""
    box = world.quarantine.box
    if box is None or parts.container is None or not isinstance(parts.dynamics, Walk):
        return
    shape = parts.container.geometry()
    if not isinstance(shape, Rectangle):
        return
    size = float(shape.width), float(shape.height)
    ends = ends_of(box, size)
    found = f"[{ends[0]:g}, {ends[2]:g}] x [{ends[1]:g}, {ends[3]:g}]"
    if not (ends[:2] < ends[2:]).all() or (ends < 0).any() or (ends[2:] > size).any():
        yield Problem(
            "world.quarantine.box", found, f"must lie inside the container, {size[0]:g} x {size[1]:g}"
        )
        return
    rooms = room_boxes(parts.dynamics.rooms, size)
    apart = (rooms[:, :2] >= ends[2:]) | (rooms[:, 2:] <= ends[:2])
    if not np.all(apart.any(axis=1)):
        allowed = "must lie beside the rooms: give them less with dynamics.rooms.region"
        yield Problem("world.quarantine.box", found, allowed)
