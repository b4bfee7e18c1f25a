"""Finds a place without overlap for every disc that a scenario counts."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Rectangle
from gasbox.initial.arrangement import most_places
from gasbox.initial.insertion import place_and_push, place_at_random
from gasbox.initial.lattice import place_on_lattice
from gasbox.initial.room import Room
from gasbox.rng import Stream, generator
from gasbox.scenario import Crowd, Scenario, crowds

__all__ = ["place"]

_DILUTE: Final = 0.35
"""Up to this area fraction discs are inserted at random, which is quick there and free of any lattice."""
_SHRUNKEN: Final = (0.25, 0.15, 0.08)
"""Area fractions at which shrunken discs are inserted, before they grow and push."""
_PUSHED_AGAIN: Final = 4


def place(
    scenario: Scenario,
    listed: NDArray[np.float64],
    listed_species: NDArray[np.int32],
    species: NDArray[np.int32],
) -> NDArray[np.float64]:
    """Positions (n, 2) [length] of the discs of `species` (n,), beside those that are `listed` (m, 2) [length].

    Raises
    ------
    ScenarioError
        No places were found within a bounded amount of work.
    """
    geometry = scenario.container.geometry()
    radii = np.array([entry.radius for entry in scenario.species])
    bounds = np.array([entry.bounds(geometry) for entry in scenario.species])
    low, high = _centre_bounds(geometry, bounds, radii)
    random = generator(scenario.seed, Stream.POSITIONS)
    turn = _turns(radii[species], bounds[species], random)
    every = np.concatenate([listed_species, species[turn]])
    room = Room.around(geometry, listed, radii[every], low[every], high[every])
    count = listed.shape[0]
    for crowd in _islands(crowds(geometry, scenario.species, scenario.particles)):
        discs = count + np.flatnonzero(np.isin(species[turn], crowd.members))
        if not _place_crowd(room, crowd, discs, random):
            raise ScenarioError([_refusal(room, crowd, discs)])
    placed = np.empty((species.shape[0], 2))
    placed[turn] = room.position[count:]
    return placed


def _turns(
    radius: NDArray[np.float64], bounds: NDArray[np.float64], random: np.random.Generator
) -> NDArray[np.intp]:
    """In which order discs (n,) get their places: the largest first, those with equal radius and part shuffled.

    Neighbours in this order become neighbours in the box, which is quick; ids say nothing about places.
    """
    return np.lexsort((random.random(radius.shape[0]), *bounds.T, -radius))


def _centre_bounds(
    geometry: Rectangle, bounds: NDArray[np.float64], radii: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lower and upper bounds (species, 2) [length] of the centres, for parts given as left, right, lower, upper end."""
    low, high = bounds[:, [0, 2]].copy(), bounds[:, [1, 3]].copy()
    around = geometry.periodic & (low == 0) & (high == geometry.size)
    low += np.where(around, 0.0, radii[:, None])
    high -= np.where(around, 0.0, radii[:, None])
    # A disc exactly as wide as its part has one place; rounding may have turned the bounds around.
    return np.minimum(low, high), high


def _islands(found: tuple[Crowd, ...]) -> tuple[Crowd, ...]:
    """The crowds that are placed one after the other; if any two overlap, all are placed together."""
    return found if all(crowd.alone for crowd in found) else found[-1:]


def _place_crowd(room: Room, crowd: Crowd, discs: NDArray[np.int64], random: np.random.Generator) -> bool:
    on_lattice = crowd.alone and np.unique(room.radius[discs]).size == 1
    if on_lattice and crowd.fraction > _DILUTE:
        return place_on_lattice(room, discs, random) or _push(room, crowd, discs, random)
    if crowd.fraction <= _DILUTE and place_at_random(room, discs, random):
        return True
    return _push(room, crowd, discs, random) or (on_lattice and place_on_lattice(room, discs, random))


def _push(room: Room, crowd: Crowd, discs: NDArray[np.int64], random: np.random.Generator) -> bool:
    for _ in range(_PUSHED_AGAIN):
        for fraction in _SHRUNKEN:
            shrunken = min(0.95, math.sqrt(fraction / crowd.fraction))
            if place_and_push(room, discs, shrunken, random):
                return True
    return False


def _refusal(room: Room, crowd: Crowd, discs: NDArray[np.int64]) -> Problem:
    """Says what was asked for, and what would fit."""
    path = f"species[{crowd.members[0]}].count" if len(crowd.members) == 1 else "species"
    found = f"{discs.size} discs at an area fraction of {crowd.fraction:.4g}"
    allowed = f"no places were found for them, although the limit is {crowd.limit:g}"
    radius = room.radius[discs]
    if crowd.alone and np.unique(radius).size == 1:
        most = most_places(room.patch(int(discs[0])), 2 * float(radius[0]))
        fraction = most * math.pi * float(radius[0]) ** 2 / crowd.area
        allowed += f"; rows and columns hold at most {most} in a box of this shape, an area fraction of {fraction:.4g}"
    return Problem(path, found, allowed + "; use fewer or smaller discs or a larger box")
