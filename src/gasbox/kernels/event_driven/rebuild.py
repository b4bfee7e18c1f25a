"""Set up cells and events from the references; move the references to the next epoch; show where all discs are."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.event_driven.cells import enter, schedule_crossing
from gasbox.kernels.event_driven.flight import note_speed, place_at, velocity_at
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
    SPECIES,
    T0,
    T_CROSS,
    T_EVENT,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.grid import cell_of
from gasbox.kernels.hall import Hall
from gasbox.kernels.molecules.spin import Spin, turn_to

__all__ = ["project", "rebuild", "shift"]


@inlined_kernel
def _fold(coordinate: float, length: float, periodic: bool) -> float:
    """The coordinate inside the box, if periodic."""
    if periodic:
        coordinate -= math.floor(coordinate / length) * length
    return coordinate


@inlined_kernel
def _has_left(hall: Hall | None, species: int) -> bool:
    """Whether a particle has left the gas: its species is then turned into a negative number."""
    if hall is None:
        return False
    return species < 0


@bare_kernel
def project(
    flight: NDArray[np.float64],
    link: NDArray[np.int32],
    box: Box,
    hall: Hall | None,
    now: float,
    gas: Gas,
) -> None:
    """Write positions and velocities at time `now` (since the start of the epoch) into the public arrays."""
    position, velocity = gas.position, gas.velocity
    for i in range(flight.shape[0]):
        elapsed = now - flight[i, T0]
        row = link[i, LABEL]
        x, y = place_at(flight, hall, i, elapsed)
        position[row, 0] = _fold(x, box.width, box.periodic_x)
        position[row, 1] = _fold(y, box.height, box.periodic_y)
        velocity[row, 0], velocity[row, 1] = velocity_at(flight, hall, i, elapsed)


@bare_kernel
def shift(flight: NDArray[np.float64], box: Box, hall: Hall | None, spin: Spin | None, end: float) -> None:
    """Move all references to the end of the epoch, which is time zero of the next one."""
    for i in range(flight.shape[0]):
        elapsed = end - flight[i, T0]
        turn_to(spin, i, elapsed)
        x, y = place_at(flight, hall, i, elapsed)
        flight[i, VX], flight[i, VY] = velocity_at(flight, hall, i, elapsed)
        flight[i, X] = _fold(x, box.width, box.periodic_x)
        flight[i, Y] = _fold(y, box.height, box.periodic_y)
        flight[i, T0] = 0.0


@bare_kernel
def rebuild(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    now: float,
    horizon: float,
    rate: float,
) -> None:
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
        x, y = place_at(flight, hall, i, elapsed)
        x, y = _fold(x, box.width, box.periodic_x), _fold(y, box.height, box.periodic_y)
        level = link[i, LEVEL]
        column = cell_of(x, levels[level, COLUMNS] / box.width, levels[level, COLUMNS])
        row = cell_of(y, levels[level, ROWS] / box.height, levels[level, ROWS])
        link[i, PARTNER] = NOBODY
        link[i, PLACE] = NOWHERE
        flight[i, T_EVENT] = math.inf
        if _has_left(hall, link[i, SPECIES]):
            flight[i, T_CROSS] = math.inf
            continue
        enter(link, head, levels, i, column, row)
        schedule_crossing(flight, link, levels, tables.sides, box, hall, i, now)
    for i in range(flight.shape[0]):
        if _has_left(hall, link[i, SPECIES]):
            continue
        remove(flight, link, tables.ring, tables.heap, tables.counter, i)
        predict_entered(tables, box, hall, spin, i, now, 0, 0)
