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

_BATCH: Final = 1 << 18
_STRIPES: Final = 512
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
    tries = _TRIES_EACH * discs.size + _TRIES_MORE
    for alike in _groups(room, discs):
        done = 0
        while done < alike.size:
            # Never more tries than discs: the last ones must not all come to lie in the first stripes.
            uniform = _striped(random.random((min(_BATCH, alike.size - done), 2)))
            if tries <= 0:
                room.leave(discs)
                return False
            placed = insert(room.grid, room.position, room.radius, alike[done:], room.low, room.high, uniform)
            done, tries = done + placed, tries - uniform.shape[0]
        room.placed[alike] = True
    return True


def _groups(room: Room, discs: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """`discs` in runs of equal radius and bounds."""
    kind = np.column_stack([room.radius[discs], room.low[discs], room.high[discs]])
    starts = 1 + np.flatnonzero((kind[1:] != kind[:-1]).any(axis=1))
    return np.split(discs, starts)


def _striped(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points (n, 2) in [0, 1) in the order of stripes, along x in each: what is tried next lies near in memory."""
    return points[np.argsort(np.floor(points[:, 1] * _STRIPES) + points[:, 0])]


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
