"""The tables of an enclosure: what discs can touch, and what each wall does to them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import ElementKind, Enclosure, Path, Piston, Rectangle, Sinusoid
from gasbox.geometry.wall import Motion, Wall
from gasbox.rng import halves

__all__ = ["Hall", "hall", "set_motion"]

# Columns of `shape`: place, tangent, normal, range of the foot, radius.
PX, PY, TX, TY, NX, NY, LOW, HIGH, RHO = range(9)
# Columns of `kind`.
KIND, WALL, FACES = range(3)
SIDE, CORNER, RIM = (int(kind) for kind in (ElementKind.SIDE, ElementKind.CORNER, ElementKind.RIM))
# Columns of `wall`: a motion's reference time, displacement, speed and acceleration; amplitude, frequency, and phase
# at time zero of a sinusoid; end of the present piece; temperature (below zero: none); mass of a piston, its
# acceleration when it is free, its stops; speeds that pass forward, and backward.
S_TIME, S_PLACE, S_SPEED, S_PUSH, AMPLITUDE, OMEGA, PHASE, UNTIL = range(8)
TEMPERATURE, MASS, PUSH, LOWER, UPPER, LEAST, GREATEST, BACK_LEAST, BACK_GREATEST = range(8, 17)
# Columns of `rule`: kind of motion, whether it is open, whether overlaps with it are let be (a wall that some pass, or
# that came while discs stood in its place).
MOTION, OPEN, SOFT = range(3)
REST, SMOOTH, WAVE = range(3)


class Hall(NamedTuple):
    """An enclosure as kernels take it.

    Attributes
    ----------
    gx, gy : gravity [length/time²]
    shape : (elements, 9) float64; kind : (elements, 3) int32; see the columns above
    wall : (walls, 17) float64; rule : (walls, 3) int32
    passes : (walls, species) bool, who passes at all
    ways : (walls, species, 2) bool, who passes along the normal of the wall, and against it
    first, near, image : the elements at rest near each cell, see `gasbox.kernels.hall.near`
    moving : (m,) int32, elements of walls that move
    seed : (2,) int64, halves of the scenario's seed
    result : (6,) float64, room for what `rebound` finds
    """

    gx: float
    gy: float
    shape: NDArray[np.float64]
    kind: NDArray[np.int32]
    wall: NDArray[np.float64]
    rule: NDArray[np.int32]
    passes: NDArray[np.bool_]
    ways: NDArray[np.bool_]
    first: NDArray[np.int32]
    near: NDArray[np.int32]
    image: NDArray[np.int8]
    moving: NDArray[np.int32]
    seed: NDArray[np.int64]
    result: NDArray[np.float64]


def hall(enclosure: Enclosure, species: int, seed: int) -> Hall:
    """The tables of an enclosure, for so many species, with its walls as at time zero and no lists of cells yet."""
    elements = enclosure.elements
    shape = np.zeros((len(elements), 9))
    kind = np.zeros((len(elements), 3), np.int32)
    for row, element in enumerate(elements):
        shape[row] = (
            *element.place,
            *element.tangent,
            *element.normal,
            element.low,
            element.high,
            element.radius,
        )
        kind[row] = int(element.kind), element.wall, element.faces
    walls = enclosure.walls
    wall = np.zeros((len(walls), 17))
    rule = np.zeros((len(walls), 3), np.int32)
    ways = np.zeros((len(walls), species, 2), np.bool_)
    for row, one in enumerate(walls):
        _describe(one, wall[row], rule[row], ways[row])
        rule[row, SOFT] |= one.soft
        if one.motion is not None:
            set_motion(wall[row], rule[row], one.motion, 0.0, 0.0)
            _equip_piston(enclosure, row, wall[row])
    moves = np.array([walls[element.wall].motion is not None for element in elements], np.bool_)
    return Hall(
        float(enclosure.gravity[0]),
        float(enclosure.gravity[1]),
        shape,
        kind,
        wall,
        rule,
        ways[:, :, 0] | ways[:, :, 1],
        ways,
        np.zeros(1, np.int32),
        np.zeros(0, np.int32),
        np.zeros((0, 2), np.int8),
        np.flatnonzero(moves).astype(np.int32),
        halves(seed),
        np.zeros(6),
    )


def _describe(one: Wall, wall: NDArray[np.float64], rule: NDArray[np.int32], ways: NDArray[np.bool_]) -> None:
    wall[UNTIL] = math.inf
    wall[TEMPERATURE] = -1.0 if one.temperature is None else one.temperature
    wall[LOWER], wall[UPPER] = -math.inf, math.inf
    wall[GREATEST] = wall[BACK_GREATEST] = math.inf
    rule[OPEN] = one.open
    if one.passes is not None:
        rule[SOFT] = 1
        for way, passage in enumerate(one.passes.ways):
            if passage is not None:
                ways[:, way] = passage.species is None
                ways[list(passage.species or ()), way] = True
                wall[LEAST + 2 * way], wall[GREATEST + 2 * way] = passage.least_speed, passage.greatest_speed


def _equip_piston(enclosure: Enclosure, number: int, wall: NDArray[np.float64]) -> None:
    """Acceleration of a free piston, by the pressure outside and by gravity, and the stops that the box itself is."""
    motion = enclosure.walls[number].motion
    if not isinstance(motion, Piston):
        return
    nx, ny = enclosure.normal(number)
    is_side = isinstance(enclosure.container, Rectangle) and number < len(Rectangle.WALLS)
    inwards = 1.0 if is_side and number % 2 == 0 else -1.0
    force = inwards * motion.pressure * enclosure.length(number)
    wall[PUSH] = force / motion.mass + enclosure.gravity[0] * nx + enclosure.gravity[1] * ny
    wall[S_PUSH] = wall[PUSH]
    wall[LOWER], wall[UPPER] = motion.lower, motion.upper
    if is_side:
        size = enclosure.width if number < 2 else enclosure.height
        if number % 2 == 0:
            wall[UPPER] = min(wall[UPPER], size)
        else:
            wall[LOWER] = max(wall[LOWER], -size)
    else:
        low, high = _free_way(enclosure, number)
        wall[LOWER], wall[UPPER] = max(wall[LOWER], low), min(wall[UPPER], high)


def _free_way(enclosure: Enclosure, number: int) -> tuple[float, float]:
    """How far a segment can move along its normal within the box around everything."""
    normal = np.array(enclosure.normal(number))
    corners = np.array([[0.0, 0.0], [enclosure.width, 0.0], [0.0, enclosure.height], list(enclosure.size)])
    place = next(element.place for element in enclosure.elements if element.wall == number)
    along = (corners - np.array(place)) @ normal
    return float(along.min()), float(along.max())


def set_motion(
    wall: NDArray[np.float64], rule: NDArray[np.int32], motion: Motion | None, time: float, start: float
) -> None:
    """Set a wall's row to the piece of its motion at `time` [time]; times in the table count from `start` [time].

    A piston keeps its place and speed, which are part of the state; at the very beginning it has its own.
    """
    match motion:
        case None:
            rule[MOTION] = REST
        case Path():
            place, speed, after = motion.piece(time)
            rule[MOTION] = SMOOTH
            wall[S_TIME], wall[S_PLACE], wall[S_SPEED], wall[S_PUSH] = time - start, place, speed, 0.0
            wall[UNTIL] = after - start
        case Sinusoid(amplitude=amplitude, frequency=frequency, phase=phase):
            rule[MOTION] = WAVE
            wall[AMPLITUDE], wall[OMEGA] = amplitude, frequency
            wall[PHASE] = math.remainder(phase + frequency * start, 2.0 * math.pi)
            wall[S_PLACE] = -amplitude * math.sin(phase)
            wall[UNTIL] = math.inf
        case Piston():
            rule[MOTION] = SMOOTH
            wall[MASS] = motion.mass
            wall[UNTIL] = math.inf
            wall[S_TIME], wall[S_PLACE], wall[S_SPEED] = time - start, 0.0, motion.speed
