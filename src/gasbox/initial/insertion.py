"""Random sequential insertion, and room made for the last ones by pushing."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure
from gasbox.initial.grid import empty_grid
from gasbox.initial.room import Room
from gasbox.initial.sampling import Places, places
from gasbox.kernels.overlaps import SEPARATED, enter_all, push_apart
from gasbox.kernels.placement import insert, insert_between

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
    """`discs` (m,) in runs of equal radius, reach and bounds."""
    kind = np.column_stack([room.radius[discs], room.reach[discs], room.low[discs], room.high[discs]])
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
    between = _between(room, int(discs[0])) if room.walls is not None else None
    if room.walls is not None and between is None:
        return discs
    while done < discs.size and tries > 0:
        # Never more tries than discs: the last ones must not all come to lie in the first stripes.
        batch = min(_BATCH, discs.size - done)
        if between is None:
            uniform = _striped(random.random((batch, 2)))
            done += insert(room.grid, room.position, room.radius, discs[done:], room.low, room.high, uniform)
        else:
            done += _insert_between(room, discs[done:], between.draw(batch, random))
        tries -= batch
    room.placed[discs[:done]] = True
    return discs[done:]


def _between(room: Room, disc: int) -> Places | None:
    """Where the centre of a disc can be between the walls of an enclosure."""
    assert isinstance(room.geometry, Enclosure)
    return places(room.geometry, float(room.reach[disc]), room.low[disc], room.high[disc])


def _insert_between(room: Room, discs: NDArray[np.int64], drawn: NDArray[np.float64]) -> int:
    """Try the places `drawn` (tries, 2) [length]; return how many discs found one."""
    drawn = np.clip(drawn, room.low[discs[0]], room.high[discs[0]])
    assert room.walls is not None
    return insert_between(room.walls, room.grid, room.position, room.radius, discs, room.reach, drawn)


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
            growing.grid,
            growing.position,
            growing.radius,
            share,
            room.low,
            room.high,
            room.reach,
            room.walls,
            _GAP,
            discs,
            budget,
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
