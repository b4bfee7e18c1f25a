"""Set up cells and events from the references; move the references to the next epoch; show where all discs are."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.event_driven.cells import enter, schedule_crossing
from gasbox.kernels.event_driven.flight import note_speed
from gasbox.kernels.event_driven.queue import empty, remove
from gasbox.kernels.event_driven.search import predict_entered
from gasbox.kernels.event_driven.tables import (
    BUCKETS_PER_TIME,
    COLUMNS,
    FASTEST,
    HORIZON,
    LABEL,
    LEVEL,
    NOBODY,
    NOW,
    NOWHERE,
    PARTNER,
    PLACE,
    ROWS,
    T0,
    T_EVENT,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.grid import cell_of

__all__ = ["project", "rebuild", "shift"]


@inlined_kernel
def _fold(coordinate: float, length: float, periodic: bool) -> float:
    """The coordinate inside the box, if periodic."""
    if periodic:
        coordinate -= math.floor(coordinate / length) * length
    return coordinate


@bare_kernel
def project(flight: NDArray[np.float64], link: NDArray[np.int32], box: Box, now: float, gas: Gas) -> None:
    """Write positions and velocities at time `now` (since the start of the epoch) into the public arrays."""
    position, velocity = gas.position, gas.velocity
    for i in range(flight.shape[0]):
        elapsed = now - flight[i, T0]
        row = link[i, LABEL]
        position[row, 0] = _fold(flight[i, X] + flight[i, VX] * elapsed, box.width, box.periodic_x)
        position[row, 1] = _fold(flight[i, Y] + flight[i, VY] * elapsed, box.height, box.periodic_y)
        velocity[row, 0] = flight[i, VX]
        velocity[row, 1] = flight[i, VY]


@bare_kernel
def shift(flight: NDArray[np.float64], box: Box, end: float) -> None:
    """Move all references to the end of the epoch, which is time zero of the next one."""
    for i in range(flight.shape[0]):
        elapsed = end - flight[i, T0]
        flight[i, X] = _fold(flight[i, X] + flight[i, VX] * elapsed, box.width, box.periodic_x)
        flight[i, Y] = _fold(flight[i, Y] + flight[i, VY] * elapsed, box.height, box.periodic_y)
        flight[i, T0] = 0.0


@bare_kernel
def rebuild(tables: Tables, box: Box, now: float, horizon: float, rate: float) -> None:
    """File all particles and find all events anew, from the references alone.

    Parameters
    ----------
    now : [time], since the start of the epoch
    horizon : [time], end of the epoch
    rate : [1/time], expected events per time, for the width of the calendar's buckets
    """
    flight, link, head, levels = tables.flight, tables.link, tables.head, tables.levels
    head[:] = -1
    tables.number[HORIZON] = horizon
    tables.number[NOW] = now
    tables.number[FASTEST] = 0.0
    for i in range(flight.shape[0]):
        note_speed(flight, tables.number, i)
    tables.number[BUCKETS_PER_TIME] = rate
    empty(tables.ring, tables.counter, int(now * rate))
    for i in range(flight.shape[0]):
        elapsed = now - flight[i, T0]
        x = _fold(flight[i, X] + flight[i, VX] * elapsed, box.width, box.periodic_x)
        y = _fold(flight[i, Y] + flight[i, VY] * elapsed, box.height, box.periodic_y)
        level = link[i, LEVEL]
        column = cell_of(x, levels[level, COLUMNS] / box.width, levels[level, COLUMNS])
        row = cell_of(y, levels[level, ROWS] / box.height, levels[level, ROWS])
        enter(link, head, levels, i, column, row)
        link[i, PARTNER] = NOBODY
        link[i, PLACE] = NOWHERE
        flight[i, T_EVENT] = math.inf
        schedule_crossing(flight, link, levels, tables.sides, box, i, now)
    for i in range(flight.shape[0]):
        remove(flight, link, tables.ring, tables.heap, tables.counter, i)
        predict_entered(tables, box, i, now, 0, 0)
