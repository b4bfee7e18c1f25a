"""Who is near which wall, and where walls are that move.

A wall moves by its displacement along the normal of its elements, as `gasbox.kernels.hall.motion` has it. Its own way
counts like that of a disc when it is asked whether the lists must be made anew.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.forced.tables import Atoms
from gasbox.kernels.hall.motion import displacement, speed
from gasbox.kernels.hall.tables import (
    FACES,
    HIGH,
    KIND,
    LOW,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    RHO,
    RIM,
    SIDE,
    SOFT,
    TX,
    TY,
    WALL,
    Hall,
)

__all__ = ["Walls", "approach", "approach_before", "distance", "note_walls", "seen", "stand", "walls"]


class Walls(NamedTuple):
    """An enclosure, and who is near which of its elements.

    Attributes
    ----------
    hall : its tables
    strength : of walls that push back smoothly [energy]; 0 for walls at which discs turn round
    near : (room, 4) int32, atom, element, and the image of it along x and y
    size : (1,) int64, rows of `near` in use
    cursor : (4,) int64, how many of them have been looked at in this step, and again for those of rigid molecules;
        contacts of the one that is looked at; whether rigid molecules are
    place, rate : (walls,) float64, displacement of each wall at the end of the step [length], and its speed
    earlier : (walls,) float64, displacement at the end of the step before [length]
    listed : (walls,) float64, displacement when `near` was made [length]
    way : (1,) float64, square of the largest way of a wall since then
    force, force_before : (walls, species) float64, of walls that push back smoothly on the discs, along the normal of
        the wall, at the end of the step and before it [mass·length/time²]
    was_x, was_y : (n+,) float64, places of the atoms before the step; (0,) where nobody gets through a wall
    gone : (n,) int64, of each disc in the order of the state, whether it has left in this step
    left : (1,) int64, how many have
    """

    hall: Hall
    strength: float
    near: NDArray[np.int32]
    size: NDArray[np.int64]
    cursor: NDArray[np.int64]
    place: NDArray[np.float64]
    rate: NDArray[np.float64]
    earlier: NDArray[np.float64]
    listed: NDArray[np.float64]
    way: NDArray[np.float64]
    force: NDArray[np.float64]
    force_before: NDArray[np.float64]
    was_x: NDArray[np.float64]
    was_y: NDArray[np.float64]
    gone: NDArray[np.int64]
    left: NDArray[np.int64]


def walls(hall: Hall, strength: float, room: int, atoms: Atoms, count: int) -> Walls:
    """With room for so many discs near walls, of `count` discs in all."""
    through = bool(np.any(hall.rule[:, [OPEN, SOFT]]))
    padded = atoms.x.shape[0] if through else 0
    many = hall.wall.shape[0]
    return Walls(
        hall,
        strength,
        np.zeros((room, 4), np.int32),
        np.zeros(1, np.int64),
        np.zeros(4, np.int64),
        np.zeros(many),
        np.zeros(many),
        np.zeros(many),
        np.zeros(many),
        np.zeros(1),
        np.zeros(hall.passes.shape),
        np.zeros(hall.passes.shape),
        np.zeros(padded),
        np.zeros(padded),
        np.zeros(count if through else 0, np.int64),
        np.zeros(1, np.int64),
    )


@bare_kernel
def stand(walls: Walls, time: float) -> None:
    """Bring walls that move to where they are at `time` [time], which is the end of a step."""
    most = 0.0
    for number in range(walls.place.shape[0]):
        walls.earlier[number] = walls.place[number]
        walls.place[number] = displacement(walls.hall, number, time)
        walls.rate[number] = speed(walls.hall, number, time)
        most = max(most, (walls.place[number] - walls.listed[number]) ** 2)
    walls.way[0] = most


@inlined_kernel
def note_walls(walls: Walls) -> None:
    """Remember where walls are when the lists are made."""
    for number in range(walls.place.shape[0]):
        walls.listed[number] = walls.place[number]


@inlined_kernel
def distance(hall: Hall, e: int, x: float, y: float) -> tuple[float, float, float]:
    """Unit normal from an element to a centre at (x, y) from its place, and distance; infinite beside a side."""
    kind = hall.kind[e, KIND]
    if kind == SIDE:
        foot = x * hall.shape[e, TX] + y * hall.shape[e, TY]
        nx, ny = hall.shape[e, NX], hall.shape[e, NY]
        height = x * nx + y * ny
        face = hall.kind[e, FACES]
        if face < 0 or (face == 0 and height < 0.0):
            nx, ny, height = -nx, -ny, -height
        if not hall.shape[e, LOW] <= foot <= hall.shape[e, HIGH]:
            height = math.inf
        return nx, ny, height
    away = math.sqrt(x * x + y * y)
    if away == 0.0:
        return 1.0, 0.0, hall.shape[e, RHO] if kind == RIM else 0.0
    if kind == RIM:
        return -x / away, -y / away, hall.shape[e, RHO] - away
    return x / away, y / away, away - hall.shape[e, RHO]


@inlined_kernel
def seen(
    walls: Walls, entry: int, place: NDArray[np.float64], x: float, y: float, box: Box
) -> tuple[float, float]:
    """A centre as seen from the element of an entry of the list, with walls displaced by `place` (walls,)."""
    hall, e = walls.hall, walls.near[entry, 1]
    way = place[hall.kind[e, WALL]]
    x = x - hall.shape[e, PX] - walls.near[entry, 2] * box.width - hall.shape[e, NX] * way
    y = y - hall.shape[e, PY] - walls.near[entry, 3] * box.height - hall.shape[e, NY] * way
    return x, y


@inlined_kernel
def approach(walls: Walls, entry: int, atoms: Atoms, box: Box) -> tuple[int, int, float, float, float]:
    """Atom, element, normal and distance of an entry of the list."""
    k, e = walls.near[entry, 0], walls.near[entry, 1]
    x, y = seen(walls, entry, walls.place, atoms.x[k], atoms.y[k], box)
    nx, ny, away = distance(walls.hall, e, x, y)
    return k, e, nx, ny, away


@inlined_kernel
def approach_before(walls: Walls, entry: int, box: Box) -> tuple[float, float, float]:
    """Normal and distance of an entry of the list before the step."""
    k = walls.near[entry, 0]
    x, y = seen(walls, entry, walls.earlier, walls.was_x[k], walls.was_y[k], box)
    return distance(walls.hall, walls.near[entry, 1], x, y)
