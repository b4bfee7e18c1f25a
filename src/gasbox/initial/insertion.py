"""Random sequential insertion, and for dense mixtures, insertion of shrunken discs that grow and push."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.grid import empty_grid
from gasbox.initial.room import Room
from gasbox.kernels.overlaps import SEPARATED, enter_all, push_apart
from gasbox.kernels.placement import insert

__all__ = ["place_and_push", "place_at_random"]

_BATCH: Final = 1 << 17
_TRIES_EACH: Final = 40
"""So many tries for each disc on average ..."""
_TRIES_MORE: Final = 50_000
"""... and these in addition, for a few discs in a tight corner."""
_STAGES: Final = 4
_LOOKS_EACH: Final = 400
_LOOKS_MORE: Final = 1_000_000
_GAP: Final = 1e-6


def place_at_random(room: Room, discs: NDArray[np.int64], random: np.random.Generator) -> bool:
    """Place `discs` (m,) one by one, the largest first, each at a random free place.

    Returns
    -------
    False if they don't find a place within a bounded number of tries; then none of them is placed.
    """
    order = discs[np.argsort(-room.radius[discs], kind="stable")]
    tries = _TRIES_EACH * order.size + _TRIES_MORE
    done = 0
    while done < order.size and tries > 0:
        uniform = random.random((min(_BATCH, tries), 2))
        placed, used = insert(
            room.grid, room.position, room.radius, order[done:], room.low, room.high, uniform
        )
        done, tries = done + placed, tries - used
    room.placed[order[:done]] = True
    if done < order.size:
        room.leave(discs)
        return False
    return True


def place_and_push(
    room: Room, discs: NDArray[np.int64], shrunken: float, random: np.random.Generator
) -> bool:
    """Place `discs` (m,) with radii times `shrunken` (< 1) at random, then let them grow and push each other apart.

    Returns
    -------
    False if overlaps are left after a bounded amount of work; then none of them is placed.
    """
    growing = _resized(room, discs, shrunken)
    if not place_at_random(growing, discs, random):
        return False
    share = np.zeros(room.radius.shape[0])
    share[discs] = (room.radius[discs].min() / room.radius[discs]) ** 2
    budget = _LOOKS_EACH * discs.size + _LOOKS_MORE
    for factor in np.linspace(shrunken, 1.0, _STAGES + 1)[1:]:
        growing = _resized(growing, discs, float(factor), room.radius)
        status, work = push_apart(
            growing.grid,
            growing.position,
            growing.radius,
            share,
            room.low,
            room.high,
            _GAP,
            np.flatnonzero(growing.placed),
            budget,
        )
        budget -= work
        if status != SEPARATED:
            return False
    room.enter(discs, growing.position[discs])
    return True


def _resized(
    room: Room, discs: NDArray[np.int64], factor: float, full: NDArray[np.float64] | None = None
) -> Room:
    """A copy of the room in which `discs` have `factor` times their `full` radius [length]."""
    radius = (room.radius if full is None else full).copy()
    radius[discs] *= factor
    grid = empty_grid(room.geometry, radius)
    resized = replace(
        room, radius=radius, position=room.position.copy(), placed=room.placed.copy(), grid=grid
    )
    enter_all(grid, resized.position, np.flatnonzero(resized.placed))
    return resized
