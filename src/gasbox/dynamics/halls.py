"""Walls that move, between the geometry and the kernels: where they begin, and how they go on."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure, Geometry, Path, Piston, Sinusoid
from gasbox.kernels.hall import Hall, hall, set_motion
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.tables import (
    LOWER,
    MASS,
    MOTION,
    PUSH,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    SMOOTH,
    UNTIL,
    UPPER,
)
from gasbox.state import State

__all__ = ["make_hall", "set_waves", "start_walls", "turn_paths", "turn_walls", "wall_rows"]

_HELD = 1e-9
"""A piston that meets its stop so slowly that it would not rise by this part of the box again is held there."""


def make_hall(geometry: Geometry, species: int, seed: int) -> Hall | None:
    """The tables of an enclosure; None for a plain rectangle."""
    return hall(geometry, species, seed) if isinstance(geometry, Enclosure) else None


def start_walls(
    hall: Hall, geometry: Geometry, state: State, start: float, rows: NDArray[np.float64] | None
) -> None:
    """Set all walls in motion at the time of the state, with times in the table counted from `start` [time].

    rows : as `wall_rows` gave them, to go on with the same bits
    """
    if rows is not None:
        hall.wall[:, : UNTIL + 1] = np.asarray(rows, np.float64).reshape(-1, UNTIL + 1)
        never = hall.wall[:, UNTIL] < 0.0
        hall.wall[never, UNTIL] = math.inf
        return
    assert isinstance(geometry, Enclosure)
    for number, wall in enumerate(geometry.walls):
        if wall.motion is None:
            continue
        push = hall.wall[number, S_PUSH]
        set_motion(hall.wall[number], hall.rule[number], wall.motion, state.time, start)
        if isinstance(wall.motion, Piston):
            hall.wall[number, S_PUSH] = push
            if state.wall_displacement.size and state.time > 0.0:
                hall.wall[number, S_PLACE] = state.wall_displacement[number]
                hall.wall[number, S_SPEED] = state.wall_velocity[number]


def set_waves(hall: Hall, geometry: Geometry, start: float) -> None:
    """A new epoch has begun: the phases of swinging walls count from its start [time]."""
    assert isinstance(geometry, Enclosure)
    for number, wall in enumerate(geometry.walls):
        if isinstance(wall.motion, Sinusoid):
            set_motion(hall.wall[number], hall.rule[number], wall.motion, start, start)


def turn_walls(hall: Hall, geometry: Geometry, now: float, start: float) -> list[int]:
    """Let walls that have come to the end of a piece or to a stop at `now` go on; return which have changed."""
    assert isinstance(geometry, Enclosure)
    turned = []
    for number, wall in enumerate(geometry.walls):
        row = hall.wall[number]
        if hall.rule[number, MOTION] != SMOOTH:
            continue
        if isinstance(wall.motion, Path) and row[UNTIL] <= now:
            corner = next(time for time in wall.motion.times if time - start >= row[UNTIL])
            set_motion(row, hall.rule[number], wall.motion, corner, start)
            turned.append(number)
        elif row[MASS] > 0.0 and _at_stop(hall, number, now, float(geometry.size.max())):
            turned.append(number)
    return turned


def turn_paths(hall: Hall, geometry: Enclosure, step: int, time_step: float) -> int:
    """Let walls on a path set out on the piece of the step after `step`; return the last step before a piece ends."""
    last = int(np.iinfo(np.int64).max)
    time = (step + 1) * time_step
    for number, wall in enumerate(geometry.walls):
        if not isinstance(wall.motion, Path):
            continue
        row = hall.wall[number]
        if row[UNTIL] <= time:
            set_motion(row, hall.rule[number], wall.motion, time, 0.0)
        if row[UNTIL] < math.inf:
            last = min(last, max(step + 1, _last_before(float(row[UNTIL]), time_step)))
    return last


def _last_before(time: float, time_step: float) -> int:
    """The last step before `time` [time]."""
    step = math.floor(time / time_step) + 1
    while step * time_step >= time:
        step -= 1
    return step


def _at_stop(hall: Hall, number: int, now: float, size: float) -> bool:
    """Whether a piston meets one of its stops; it then bounces, or is held there."""
    row = hall.wall[number]
    place, rate = displacement(hall, number, now), speed(hall, number, now)
    for stop, inwards in ((row[LOWER], 1.0), (row[UPPER], -1.0)):
        if math.isinf(stop) or inwards * (place - stop) > 1e-9 * size or inwards * rate > 0.0:
            continue
        row[S_TIME], row[S_PLACE] = now, stop
        row[S_SPEED], row[S_PUSH] = -rate, row[PUSH]
        if rate * rate < 2.0 * _HELD * size * max(-inwards * row[PUSH], 0.0):
            row[S_SPEED] = row[S_PUSH] = 0.0
        return True
    return False


def wall_rows(hall: Hall) -> NDArray[np.float64]:
    """(walls, 8) float64: what must be remembered of the motion of all walls; a piece without an end ends at -1."""
    rows = hall.wall[:, : UNTIL + 1].copy()
    rows[np.isinf(rows[:, UNTIL]), UNTIL] = -1.0
    return rows
