"""Where a wall is, and how fast it moves."""

from __future__ import annotations

import math

from gasbox.jit import inlined_kernel
from gasbox.kernels.hall.tables import (
    AMPLITUDE,
    MOTION,
    OMEGA,
    PHASE,
    S_PLACE,
    S_PUSH,
    S_SPEED,
    S_TIME,
    SMOOTH,
    WAVE,
    Hall,
)

__all__ = ["displacement", "push", "speed"]


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
