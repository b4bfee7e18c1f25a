"""Finds a place and an angle without overlap for every particle of a gas with molecules."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Enclosure
from gasbox.initial.barriers import barriers
from gasbox.initial.bodies import Draw, Filling, filling
from gasbox.initial.placing import sizes_tried
from gasbox.initial.rows import most_in_rows, place_in_rows
from gasbox.kernels.molecules.placing import enter_bodies, insert_bodies, shake_bodies
from gasbox.scenario import Crowd, Forced, Placement, Scenario

__all__ = ["place_turned"]

_BATCH: Final = 1 << 16
_TRIES_EACH: Final = 100
"""Tries of random insertion for each particle, on average."""
_TRIES_MORE: Final = 20_000
_SCALES: Final = (0.6, 0.4, 0.25)
"""Of those that found no place; they are inserted so much smaller, and grow while all are shaken."""
_GROWTH: Final = 0.1
_LOOKS: Final = 10_000_000
"""Most discs that are moved in shaking, in all, but each at least and at most so often."""
_SWEEPS: Final = (300, 3000)
_STEPS: Final = (0.02, 1.0)
"""Least and greatest move, as a share of the radius of the largest disc."""


def place_turned(
    scenario: Scenario,
    listed: NDArray[np.float64],
    listed_species: NDArray[np.int32],
    listed_angle: NDArray[np.float64],
    species: NDArray[np.int32],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 2) [length] and angles (n,) [rad] of the particles of kinds `species` (n,).

    They stand beside those that are `listed` (m, 2) [length], turned by `listed_angle` (m,) [rad].

    Raises
    ------
    ScenarioError
        No places were found within a bounded amount of work.
    """
    soft = isinstance(scenario.dynamics, Forced)
    placement = Placement(
        scenario.geometry(), scenario.kinds, scenario.site_kinds, scenario.particles, soft, scenario.seed
    )
    position = np.zeros((species.shape[0], 2))
    free = np.ones(species.shape[0], np.bool_)
    for number, places in placement.on_lattices().items():
        position[species == number] = places
        free[species == number] = False
    kind = np.concatenate([listed_species, species])
    count = listed.shape[0]
    standing = np.concatenate([np.arange(count), count + np.flatnonzero(~free)])
    found = placement.crowds()
    refusal: Problem | None = None
    for factor in sizes_tried(found):
        room = _room(placement, found, kind, factor)
        room.bodies.position[:] = np.concatenate([listed, position])
        room.bodies.angle[:count] = listed_angle
        enter_bodies(room.bodies, room.grid, standing)
        refusal = _fill(room, found, standing, Draw(scenario.seed))
        if refusal is None:
            inside = placement.geometry.wrap(room.bodies.position[count:])
            return inside, room.bodies.angle[count:] % (2.0 * math.pi)
    assert refusal is not None
    raise ScenarioError([refusal])


def _room(placement: Placement, found: tuple[Crowd, ...], kind: NDArray[np.int32], factor: float) -> Filling:
    geometry, walls = placement.geometry, None
    if isinstance(geometry, Enclosure) and not all(crowd.plain for crowd in found):
        walls = barriers(geometry, max(float(each.radii.max()) for each in placement.kinds))
    radii = [factor * each.radii for each in placement.sized()]
    return filling(geometry, placement.kinds, radii, kind, walls)


def _fill(room: Filling, found: tuple[Crowd, ...], standing: NDArray[np.int64], draw: Draw) -> Problem | None:
    """Place all who do not stand yet, the largest kinds first; says what is wrong if that fails."""
    rest = np.setdiff1d(np.arange(room.kind.size), standing)
    kinds = sorted(np.unique(room.kind[rest]).tolist(), key=lambda k: -room.kinds[k].radius)
    groups = [rest[room.kind[rest] == k] for k in kinds]
    if all(not _insert(room, group, 1.0, draw).size for group in groups):
        return None
    for scale in _SCALES:
        if _grow(room.emptied(standing), groups, scale, draw):
            return None
    if len(groups) == 1 and place_in_rows(room.emptied(standing), groups[0], draw):
        return None
    return _refusal(room, found, groups)


def _insert(room: Filling, rows: NDArray[np.int64], scale: float, draw: Draw) -> NDArray[np.int64]:
    """Place particles `rows` (m,) of one kind at random, one after the other; returns those left over."""
    box, tries = room.box(int(room.kind[rows[0]])), _TRIES_EACH * rows.size + _TRIES_MORE
    while rows.size and tries > 0:
        drawn = draw.within(box, min(_BATCH, 4 * rows.size + 100))
        rows = rows[insert_bodies(room.bodies, room.grid, room.walls, rows, scale, drawn) :]
        tries -= len(drawn)
    return rows


def _grow(room: Filling, groups: list[NDArray[np.int64]], scale: float, draw: Draw) -> bool:
    """Insert all so much smaller, and let them grow while they are shaken; False if some are left small."""
    if any(_insert(room, group, scale, draw).size for group in groups):
        return False
    rows = np.concatenate(groups)
    kind = room.kind[rows]
    discs = sum(len(room.kinds[k].sites) for k in kind.tolist())
    largest = np.array([float(each.radii.max()) for each in room.kinds])[room.kind]
    reach = np.array([each.radius for each in room.kinds])[room.kind]
    share = 0.3
    for _ in range(min(max(_SWEEPS[0], _LOOKS // discs), _SWEEPS[1])):
        moves, small = shake_bodies(
            room.bodies,
            room.grid,
            room.walls,
            rows,
            share * largest,
            share * largest / reach,
            _GROWTH,
            draw.uniform(rows.size),
        )
        if not small:
            return True
        share = min(max(share * (1.1 if moves > 0.4 * rows.size else 0.9), _STEPS[0]), _STEPS[1])
    return False


def _refusal(room: Filling, found: tuple[Crowd, ...], groups: list[NDArray[np.int64]]) -> Problem:
    """Says what was asked for, and what would fit."""
    kinds = [int(room.kind[group[0]]) for group in groups]
    path = f"{room.kinds[kinds[0]].path}.count" if len(kinds) == 1 else "molecules"
    densest = max(found, key=lambda crowd: crowd.fraction)
    count = sum(group.size for group in groups)
    allowed = "no places were found for them"
    if densest.fraction <= densest.limit:
        allowed += f", although the limit is {densest.limit:g}"
    if len(kinds) == 1 and room.walls is None:
        most = most_in_rows(room, kinds[0])
        allowed += f"; rows of them, all turned one way, hold at most {most}"
    return Problem(
        path,
        f"{count} particles at an area fraction of {densest.fraction:.4g}",
        f"{allowed}; use fewer or smaller molecules or a larger box",
    )
