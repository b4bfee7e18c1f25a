"""Finds a place without overlap for every disc that a scenario counts."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Enclosure
from gasbox.initial.arrangement import most_places
from gasbox.initial.barriers import barriers
from gasbox.initial.insertion import alike, insert_at_random, squeeze_in
from gasbox.initial.lattice import place_on_lattice
from gasbox.initial.room import Room
from gasbox.rng import Stream, generator
from gasbox.scenario import MIXTURE_LIMIT, Crowd, Forced, Placement, Scenario, centre_bounds

__all__ = ["place", "sizes_tried"]

_DILUTE: Final = 0.35
"""Up to this area fraction discs of one size are inserted at random; above, they start from a lattice."""
_TRIES_EACH: Final = (25, 3, 0)
"""Tries of random insertion for each disc, in one attempt after the other; the rest is squeezed in."""
_FACTORS: Final = (0.7, 0.5, 0.3)
"""Factors of the radii with which discs are squeezed in, in one attempt after the other."""

_CLOSER: Final = (1.0, 0.8, 0.6)
"""Factors of the radii of discs that forces will push apart, in one attempt after the other."""


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
    soft = isinstance(scenario.dynamics, Forced)
    placement = Placement(
        scenario.geometry(), scenario.kinds, scenario.site_kinds, scenario.particles, soft, scenario.seed
    )
    placed, free = np.empty((species.shape[0], 2)), np.ones(species.shape[0], np.bool_)
    for number, places in placement.on_lattices().items():
        members = species == number
        placed[members] = places
        listed = np.concatenate([listed, places])
        listed_species = np.concatenate([listed_species, species[members]])
        free[members] = False
    rest = np.flatnonzero(free)
    placed[rest] = _place_at_random(scenario, placement, listed, listed_species, species[rest])
    return placed


def _place_at_random(
    scenario: Scenario,
    placement: Placement,
    listed: NDArray[np.float64],
    listed_species: NDArray[np.int32],
    species: NDArray[np.int32],
) -> NDArray[np.float64]:
    """Positions of discs that stand nowhere yet; arguments as those of `place`."""
    geometry, found = placement.geometry, placement.crowds()
    reach = np.array([entry.radius for entry in scenario.kinds])
    bounds = np.array([entry.bounds(geometry) for entry in scenario.kinds])
    low, high = _centre_bounds(scenario)
    random = generator(scenario.seed, Stream.POSITIONS)
    radii = np.array([kind.radius for kind in placement.sized()])
    turn = _turns(radii[species], reach[species], bounds[species], random)
    every = np.concatenate([listed_species, species[turn]])
    walls = None
    if isinstance(geometry, Enclosure) and not all(crowd.plain for crowd in found):
        walls = barriers(geometry, float(reach.max()))
    refusal: Problem | None = None
    for factor in sizes_tried(found):
        radius = factor * radii[every]
        room = Room.around(geometry, listed, radius, low[every], high[every], reach[every], walls)
        refusal = _fill_all(room, found, species[turn], listed.shape[0], random)
        if refusal is None:
            placed = np.empty((species.shape[0], 2))
            placed[turn] = room.position[listed.shape[0] :]
            return placed
    assert refusal is not None
    raise ScenarioError([refusal])


def sizes_tried(found: tuple[Crowd, ...]) -> tuple[float, ...]:
    """Factors of the radii, in one attempt after the other: where forces act, discs may start a little too close."""
    if not any(crowd.soft for crowd in found):
        return (1.0,)
    easy = all(crowd.plain and crowd.alone and crowd.one_size for crowd in found)
    densest = max((crowd.fraction for crowd in found), default=0.0)
    first = 1.0 if easy else min(1.0, math.sqrt(MIXTURE_LIMIT / max(densest, MIXTURE_LIMIT)))
    return tuple(first * factor for factor in _CLOSER)


def _fill_all(
    room: Room, found: tuple[Crowd, ...], species: NDArray[np.int32], count: int, random: np.random.Generator
) -> Problem | None:
    """Place all discs behind the first `count`, of `species` (n,); returns what is wrong if that fails."""
    for crowd in _islands(found):
        discs = count + np.flatnonzero(np.isin(species, crowd.members))
        if not _place_crowd(_as_seen_by(crowd, room), crowd, discs, count, random):
            return _refusal(room, crowd, discs)
    return None


def _turns(
    radius: NDArray[np.float64],
    reach: NDArray[np.float64],
    bounds: NDArray[np.float64],
    random: np.random.Generator,
) -> NDArray[np.intp]:
    """In which order discs (n,) get their places: the largest first, those that are alike shuffled.

    Neighbours in this order become neighbours in the box, which is quick; ids say nothing about places.
    """
    return np.lexsort((random.random(radius.shape[0]), -reach, *bounds.T, -radius))


def _centre_bounds(scenario: Scenario) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lower and upper bounds (species, 2) [length] of the centres."""
    geometry = scenario.geometry()
    found = [centre_bounds(geometry, entry.bounds(geometry), entry.radius) for entry in scenario.kinds]
    low, high = np.array(found).transpose(1, 0, 2)
    return low.copy(), high.copy()


def _as_seen_by(crowd: Crowd, room: Room) -> Room:
    """The same room; where nothing stands in the part of a crowd, without walls."""
    return replace(room, walls=None) if crowd.plain else room


def _islands(found: tuple[Crowd, ...]) -> tuple[Crowd, ...]:
    """The crowds that are placed one after the other; if any two overlap, all are placed together."""
    return found if all(crowd.alone for crowd in found) else found[-1:]


def _place_crowd(
    room: Room, crowd: Crowd, discs: NDArray[np.int64], fixed: int, random: np.random.Generator
) -> bool:
    one_size = crowd.plain and crowd.alone and np.unique(room.radius[discs]).size == 1
    if one_size and crowd.fraction > _DILUTE and place_on_lattice(room, discs, random):
        return True
    for tries_each in _TRIES_EACH:
        if all(_fill(room, group, tries_each, fixed, random) for group in alike(room, discs)):
            return True
        room.leave(discs)
    return one_size and place_on_lattice(room, discs, random)


def _fill(
    room: Room, discs: NDArray[np.int64], tries_each: int, fixed: int, random: np.random.Generator
) -> bool:
    """Place `discs` (m,), which are alike: most at random, the rest squeezed in."""
    rest = insert_at_random(room, discs, tries_each, random) if tries_each else discs
    return not rest.size or any(squeeze_in(room, rest, factor, fixed, random) for factor in _FACTORS)


def _refusal(room: Room, crowd: Crowd, discs: NDArray[np.int64]) -> Problem:
    """Says what was asked for, and what would fit."""
    path = f"species[{crowd.members[0]}].count" if len(crowd.members) == 1 else "species"
    found = f"{discs.size} discs at an area fraction of {crowd.fraction:.4g}"
    allowed = f"no places were found for them, although the limit is {crowd.limit:g}"
    radius = room.radius[discs]
    if crowd.plain and crowd.alone and np.unique(radius).size == 1:
        most = most_places(room.patch(int(discs[0])), 2 * float(radius[0]))
        fraction = most * math.pi * float(radius[0]) ** 2 / crowd.area
        allowed += f"; rows and columns hold at most {most} in a box of this shape, an area fraction of {fraction:.4g}"
    return Problem(path, found, allowed + "; use fewer or smaller discs or a larger box")
