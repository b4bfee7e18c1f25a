"""Where a wall is, and how fast it moves."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.hall.roots import first_fall
from gasbox.kernels.hall.tables import (
    AMPLITUDE,
    LOWER,
    MASS,
    MOTION,
    OMEGA,
    PHASE,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    SMOOTH,
    UNTIL,
    UPPER,
    WAVE,
    Hall,
)

__all__ = ["displacement", "next_turn", "push", "shift_walls", "show_walls", "speed"]


@inlined_kernel
def displacement(hall: Hall, number: int, time: float) -> float:
    """Displacement of a wall along its normal at `time` [length]."""
    motion = hall.rule[number, MOTION]
    if motion == SMOOTH:
        elapsed = time - hall.wall[number, S_TIME]
        return (
            hall.wall[number, S_PLACE]
            + hall.wall[number, S_SPEED] * elapsed
            + 0.5 * hall.wall[number, S_PUSH] * elapsed * elapsed
        )
    if motion == WAVE:
        angle = hall.wall[number, OMEGA] * time + hall.wall[number, PHASE]
        return hall.wall[number, S_PLACE] + hall.wall[number, AMPLITUDE] * math.sin(angle)
    return 0.0


@inlined_kernel
def speed(hall: Hall, number: int, time: float) -> float:
    """Speed of a wall along its normal at `time` [length/time]."""
    motion = hall.rule[number, MOTION]
    if motion == SMOOTH:
        return hall.wall[number, S_SPEED] + hall.wall[number, S_PUSH] * (time - hall.wall[number, S_TIME])
    if motion == WAVE:
        angle = hall.wall[number, OMEGA] * time + hall.wall[number, PHASE]
        return hall.wall[number, AMPLITUDE] * hall.wall[number, OMEGA] * math.cos(angle)
    return 0.0


@inlined_kernel
def push(hall: Hall, number: int, time: float) -> float:
    """Acceleration of a wall along its normal at `time` [length/time²]."""
    motion = hall.rule[number, MOTION]
    if motion == SMOOTH:
        return hall.wall[number, S_PUSH]
    if motion == WAVE:
        omega = hall.wall[number, OMEGA]
        angle = omega * time + hall.wall[number, PHASE]
        return -hall.wall[number, AMPLITUDE] * omega * omega * math.sin(angle)
    return 0.0


@bare_kernel
def next_turn(hall: Hall) -> float:
    """When the first wall comes to the end of a piece of its motion, or a piston to a stop; infinity if never."""
    turn = math.inf
    for number in range(hall.wall.shape[0]):
        if hall.rule[number, MOTION] != SMOOTH:
            continue
        turn = min(turn, hall.wall[number, UNTIL])
        if hall.wall[number, MASS] > 0.0:
            begin, place = hall.wall[number, S_TIME], hall.wall[number, S_PLACE]
            rate, push = hall.wall[number, S_SPEED], hall.wall[number, S_PUSH]
            low, high = hall.wall[number, LOWER], hall.wall[number, UPPER]
            if low > -math.inf:
                turn = min(turn, begin + first_fall(place - low, rate, push, math.inf, 0.0))
            if high < math.inf:
                turn = min(turn, begin + first_fall(high - place, -rate, -push, math.inf, 0.0))
    return turn


@bare_kernel
def show_walls(hall: Hall, time: float, place: NDArray[np.float64], rate: NDArray[np.float64]) -> None:
    """Write displacements and speeds (walls,) of all walls at `time`."""
    for number in range(hall.wall.shape[0]):
        place[number] = displacement(hall, number, time)
        rate[number] = speed(hall, number, time)


@bare_kernel
def shift_walls(hall: Hall, end: float) -> None:
    """Move the references of all walls to the end of the epoch, which is time zero of the next one."""
    for number in range(hall.wall.shape[0]):
        if hall.rule[number, MOTION] == SMOOTH:
            place, rate = displacement(hall, number, end), speed(hall, number, end)
            hall.wall[number, S_TIME], hall.wall[number, S_PLACE] = 0.0, place
            hall.wall[number, S_SPEED] = rate
            hall.wall[number, UNTIL] -= end
