"""Random sequential insertion, and room made for the last ones by pushing."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.grid import empty_grid
from gasbox.initial.room import Room
from gasbox.kernels.overlaps import SEPARATED, enter_all, push_apart
from gasbox.kernels.placement import insert

__all__ = ["alike", "insert_at_random", "squeeze_in"]

_BATCH: Final = 1 << 18
_STRIPES: Final = 512
_TRIES_MORE: Final = 2000
"""Tries beyond so many for each disc, for a few discs in a tight corner."""
_STAGES: Final = 4
_LOOKS_EACH: Final = 400
_LOOKS_MORE: Final = 200_000
_GAP: Final = 1e-6


def alike(room: Room, discs: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """`discs` (m,) in runs of equal radius and bounds."""
    kind = np.column_stack([room.radius[discs], room.low[discs], room.high[discs]])
    starts = 1 + np.flatnonzero((kind[1:] != kind[:-1]).any(axis=1))
    return np.split(discs, starts)


def insert_at_random(
    room: Room, discs: NDArray[np.int64], tries_each: int, random: np.random.Generator
) -> NDArray[np.int64]:
    """Place `discs` (m,), which are alike, one after the other, each at a random free place.

    Returns
    -------
    Those that found no place within `tries_each` tries for each disc on average.
    """
    tries = tries_each * discs.size + _TRIES_MORE
    done = 0
    while done < discs.size and tries > 0:
        # Never more tries than discs: the last ones must not all come to lie in the first stripes.
        uniform = _striped(random.random((min(_BATCH, discs.size - done), 2)))
        done += insert(room.grid, room.position, room.radius, discs[done:], room.low, room.high, uniform)
        tries -= uniform.shape[0]
    room.placed[discs[:done]] = True
    return discs[done:]


def _striped(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points (n, 2) in [0, 1) in the order of stripes, along x in each: what is tried next lies near in memory."""
    return points[np.argsort(np.floor(points[:, 1] * _STRIPES) + points[:, 0])]


def squeeze_in(
    room: Room, discs: NDArray[np.int64], factor: float, fixed: int, random: np.random.Generator
) -> bool:
    """Insert `discs` (m,) with `factor` (< 1) times their radii, then let them grow; all give way to each other.

    Parameters
    ----------
    fixed : so many discs, the first ones, never give way

    Returns
    -------
    False if there is no room, or overlaps are left, after a bounded amount of work; then the room is as it was.
    """
    growing = _resized(room, room, discs, factor)
    for group in alike(growing, discs):
        if insert_at_random(growing, group, 100, random).size:
            return False
    share = room.radius.min() / room.radius
    share[:fixed] = 0.0
    budget = _LOOKS_EACH * room.radius.size + _LOOKS_MORE
    for stage in np.linspace(factor, 1.0, _STAGES + 1)[1:]:
        growing = _resized(growing, room, discs, float(stage))
        status, work = push_apart(
            growing.grid, growing.position, growing.radius, share, room.low, room.high, _GAP, discs, budget
        )
        budget -= work
        if status != SEPARATED:
            return False
    room.enter_anew(growing.position, growing.placed)
    return True


def _resized(room: Room, full: Room, discs: NDArray[np.int64], factor: float) -> Room:
    """A copy of `room` in which `discs` (m,) have `factor` times the radius [length] that they have in `full`."""
    radius = full.radius.copy()
    radius[discs] *= factor
    grid = empty_grid(room.geometry, radius)
    enter_all(grid, room.position, np.flatnonzero(room.placed))
    return replace(room, radius=radius, position=room.position.copy(), placed=room.placed.copy(), grid=grid)
